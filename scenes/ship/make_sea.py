#!/usr/bin/env python3
"""Writes the sea for one band as .rad text to standard output: water of the sea's temperature that follows the
curvature of the Earth to its horizon, in gusts between two winds.

    make_sea.py [--band 8 12]

Reads sea_calm.brdf, sea_gust.brdf (brdftab) and sea.cal at rendering.
"""
import argparse

from weather import AFTERNOON

EARTH_RADIUS = 6.371e6                  # metres
RINGS = (0, 500, 1000, 2000, 4000, 6000, 8000, 10000, 13000, 16000, 20000, 25000, 30000, 40000)

SURFACE = """\
void nrlbrdf water_{name}  1 sea_{name}.brdf  0  5 1 1 1 32 .2
void thermal sea_{name}  1 water_{name}  0  3 {kelvin:g} {low:g} {high:g}
"""


def depth(radius):
    """How far the sea lies below the plane z = 0 at that distance."""
    return radius * radius / (2 * EARTH_RADIUS)


def sea(low, high):
    """Frusta around the ship, their outside up."""
    text = "".join(SURFACE.format(name=name, kelvin=AFTERNOON.sea, low=low, high=high) for name in ("calm", "gust"))
    text += "void mixfunc sea  4 sea_gust sea_calm gust sea.cal  0  0\n"
    for inner, outer in zip(RINGS, RINGS[1:]):
        text += f"sea cone sea.{inner}  0  0  8 0 0 {-depth(inner):.6f} 0 0 {-depth(outer):.6f} {inner} {outer}\n"
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--band", type=float, nargs=2, default=(8, 12), metavar="UM")
    print(sea(*parser.parse_args().band), end="")


if __name__ == "__main__":
    main()
