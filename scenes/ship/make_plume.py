#!/usr/bin/env python3
"""Writes the exhaust plumes for one band as .rad text to standard output: shells of hot gas around an axis that the
wind and the ship's way bend aft. Each shell emits what it absorbs and lets the rest through unbent.

    make_plume.py [--band 3 5] [--absorption 0.03]

--absorption is that of one shell at the funnel, in the band; two walls of each are seen.
"""
import argparse
import math

from frigate import STACKS
from weather import AFTERNOON

EXIT = 19.35                            # z of their rims
EXIT_KELVIN = 540.0
EXIT_RADIUS = 0.9
LENGTH = 26.0                           # metres of drift after which nothing is left to see
SHELLS, STEPS = 6, 24

GAS = """\
void trans gas.{step}  0  0  7 {through:.6f} {through:.6f} {through:.6f} 0 0 1 1
void thermal plume.{step}  1 gas.{step}  0  3 {kelvin:.1f} {low:g} {high:g}
"""


def radius(s):
    """After s metres of drift."""
    return EXIT_RADIUS + 0.17 * s


def axis(x, s):
    """Aft with the wind, up with the jet."""
    return x - 0.25 * s - 0.65 * s * s / (s + 3), 0.0, EXIT + 4.2 * (1 - math.exp(-s / 4)) + 0.06 * s


def kelvin(s):
    """Cooled by the air that has come in."""
    return AFTERNOON.air + (EXIT_KELVIN - AFTERNOON.air) * (EXIT_RADIUS / radius(s)) ** 1.2


def absorbed(s, absorption):
    """By one shell: the gas is thinned as its cross-section grows while the path gets longer; it fades at the end."""
    return absorption * EXIT_RADIUS / radius(s) * (1 - (s / LENGTH) ** 2)


def plume(low, high, absorption):
    text = ""
    for step in range(STEPS):
        start, end = LENGTH * (step / STEPS) ** 1.5, LENGTH * ((step + 1) / STEPS) ** 1.5
        middle = (start + end) / 2
        through = 1 - absorbed(middle, absorption)
        text += GAS.format(step=step, through=through, kelvin=kelvin(middle), low=low, high=high)
        for number, x in enumerate(STACKS):
            for shell in range(SHELLS):
                part = math.sqrt((shell + 1) / SHELLS)
                numbers = (*axis(x, start), *axis(x, end), radius(start) * part, radius(end) * part)
                text += (f"plume.{step} cone plume.{step}.{number}.{shell}  0  0  8 "
                         + " ".join(f"{value:.5g}" for value in numbers) + "\n")
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--band", type=float, nargs=2, default=(3, 5), metavar="UM")
    parser.add_argument("--absorption", type=float, default=0.03)
    options = parser.parse_args()
    print(plume(*options.band, options.absorption), end="")


if __name__ == "__main__":
    main()
