#!/usr/bin/env python3
"""Writes the frigate for one band as .rad text to standard output: plane facets and a few cones, each with the
temperature that the weather and what is behind it give it (heat.py), in steps of STEP kelvin.

    make_frigate.py [--band 8 12] [--panel 1.5]

Surfaces are `thermal` on the materials paint, deck_paint, steel and glass that another file must define before.
--panel is the size of the plates in metres.
"""
import argparse
import math
import sys

from frigate import frigate
from heat import Skin, temperatures
from weather import AFTERNOON

STEP = 0.25                             # kelvin

# What a part is made of: the material, and what decides its temperature. A large transfer stands for hot gas or warm
# machinery behind bare plate, a small one for insulation.
PARTS = {
    "waterline": ("paint", Skin(.70, .92, 286.5, 60)),
    "hull": ("paint", Skin(.70, .92, 293, 4)),
    "deck": ("deck_paint", Skin(.85, .94, 294, 3)),
    "house": ("paint", Skin(.70, .92, 295, 4)),
    "roof": ("deck_paint", Skin(.80, .94, 295, 3)),
    "door": ("paint", Skin(.70, .92, 289, 9)),
    "louvre": ("deck_paint", Skin(.70, .92, 306, 30)),
    "hot_louvre": ("deck_paint", Skin(.70, .92, 330, 40)),
    "window": ("glass", Skin(.30, .35, 296, 8)),
    "mast": ("paint", Skin(.70, .92, 291, 2)),
    "radar": ("paint", Skin(.45, .90, 301, 4)),
    "pole": ("paint", Skin(.70, .92, 288, 0)),
    "gun": ("paint", Skin(.70, .92, 290, 1)),
    "canister": ("paint", Skin(.70, .92, 289, 1)),
    "boat": ("paint", Skin(.80, .92, 288, 0)),
    "casing": ("paint", Skin(.70, .92, 312, 9)),
    "funnel": ("paint", Skin(.75, .92, 330, 14)),
    "rim": ("steel", Skin(.60, .45, 450, 60)),
    "soot": ("deck_paint", Skin(.95, .95, 440, 40)),
    "uptake": ("steel", Skin(.60, .55, 560, 90)),
    "exhaust": ("deck_paint", Skin(.95, .95, 560, 400)),
}
ENGINE_ROOM = Skin(.70, .92, 312, 9)    # the hull's side where the engines are
ENGINE_ROOM_MIDDLE = (-5.0, 2.0)        # x and z
ENGINE_ROOM_REACH = (17.0, 2.2)         # half of its length and height
FUNNEL_TOP = Skin(.75, .92, 420, 32)    # what "funnel" becomes towards z = 17.2, from z = 12
COMPARTMENT = (7.0, 3.0, 7.3)           # metres, of rooms that are heated more or less
COMPARTMENT_KELVIN = 5.0


def blend(a, b, share):
    return Skin(*(x + share * (y - x) for x, y in zip(a, b)))


def room(centre):
    """-1..1 from the number of the compartment behind a plate: how warm it is kept."""
    number = [math.floor(x / length) for x, length in zip(centre, COMPARTMENT)]
    return math.sin(12.9 * number[0] + 78.2 * number[1] + 37.7 * number[2]) * 43758.5 % 2 - 1


def skin_of(part, facet):
    skin = PARTS[part][1]
    x, y, z = facet.centre
    if part in ("hull", "house", "roof", "deck"):
        skin = skin._replace(inside=skin.inside + COMPARTMENT_KELVIN * room((x, z, y)))
    if part == "hull":
        away = math.hypot(*((a - b) / c for a, b, c in zip((x, z), ENGINE_ROOM_MIDDLE, ENGINE_ROOM_REACH)))
        skin = blend(skin, ENGINE_ROOM, 1 / (1 + away ** 4))
    if part == "funnel":
        skin = blend(skin, FUNNEL_TOP, (z - 12) / 5.2)
    return skin


def write_ship(out, band, panel):
    """The number of facets and of different temperatures."""
    parts = list(frigate(panel))
    kelvin = iter(temperatures(parts, skin_of, AFTERNOON))
    out.write(f"# A frigate in {band[0]:g}-{band[1]:g} um, written by make_frigate.py. Metres, z up, bow along x.\n")
    known, count = set(), 0
    for part, facets in parts:
        material = PARTS[part][0]
        for facet in facets:
            t = STEP * round(next(kelvin) / STEP)
            name = f"{material}_{t:g}"
            if name not in known:
                known.add(name)
                out.write(f"void thermal {name}  1 {material}  0  3 {t:g} {band[0]:g} {band[1]:g}\n")
            numbers = " ".join(f"{x:.7g}" for x in facet.numbers)
            out.write(f"{name} {facet.shape} {part}.{count}  0  0  {len(facet.numbers)} {numbers}\n")
            count += 1
    return count, len(known)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--band", type=float, nargs=2, default=(8, 12), metavar="UM")
    parser.add_argument("--panel", type=float, default=1.5)
    options = parser.parse_args()
    facets, materials = write_ship(sys.stdout, options.band, options.panel)
    print(f"make_frigate: {facets} facets, {materials} temperatures", file=sys.stderr)


if __name__ == "__main__":
    main()
