#!/usr/bin/env python3
"""Writes a ship of about 200 000 triangles as .rad text to standard output: bench scene, the same on every run.

    make_hull.py [--detail 1] [--infrared | --obj]

A hull of 120 m with dented plating, a deck, a superstructure of plated blocks, two funnels and a mast. x points to the
bow, z up, the waterline is z = 0. Materials are plastic, metal and, for the funnels, glow; with --infrared they are
`emissive` instead. With --obj the same triangles come as OBJ, their vertices shared. --detail scales the number of
triangles along each edge.
"""
import argparse
import math
import os
import random
import sys

LENGTH, BEAM, DEPTH = 120.0, 14.0, 8.0

PLAIN = """\
void plastic paint  0 0 5 .45 .47 .5 .04 .1
void plastic deck_paint  0 0 5 .3 .3 .28 0 0
void metal steel  0 0 5 .6 .6 .6 .8 .05
void glow hot  0 0 4 60 60 60 0
"""
INFRARED = """\
void plastic paint_0  0 0 5 .15 .15 .15 .04 .1
void plastic deck_0  0 0 5 .08 .08 .08 0 0
void metal steel_0  0 0 5 .6 .6 .6 .8 .05
void emissive paint 1 paint_0 0 3 31 31 31
void emissive deck_paint 1 deck_0 0 3 36 36 36
void emissive steel 1 steel_0 0 3 13 13 13
void emissive hot 1 paint_0 0 3 90 90 90
"""


class Writer:
    """Triangles with coordinates in millimetres, as short as text allows; to `obj`, if given, as OBJ too."""

    def __init__(self, out, obj=None):
        self.out, self.obj = out, obj
        self.count = 0
        self.material = None
        self.vertices = {}

    def triangle(self, material, *corners):
        a, b, c = ([round(x, 3) for x in corner] for corner in corners)
        if a == b or b == c or c == a:      # the hull closes to a line at the stem
            return
        places = [" ".join(f"{x:g}" for x in corner) for corner in (a, b, c)]
        self.out.write(f"{material} polygon t{self.count} 0 0 9 {' '.join(places)}\n")
        self.count += 1
        if self.obj:
            self.face(material, places)

    def face(self, material, places):
        numbers = []
        for place in places:
            if place not in self.vertices:
                self.vertices[place] = len(self.vertices) + 1
                self.obj.write(f"v {place}\n")
            numbers.append(self.vertices[place])
        if material != self.material:
            self.material = material
            self.obj.write(f"usemtl {material}\n")
        self.obj.write("f {} {} {}\n".format(*numbers))

    def grid(self, material, surface, columns, rows):
        """Two triangles a cell of surface(u, v), u and v in 0..1, the normal along du x dv."""
        points = [[surface(i / columns, j / rows) for j in range(rows + 1)] for i in range(columns + 1)]
        for i in range(columns):
            for j in range(rows):
                a, b, c, d = points[i][j], points[i + 1][j], points[i + 1][j + 1], points[i][j + 1]
                self.triangle(material, a, b, c)
                self.triangle(material, a, c, d)


def half_breadth(u, v):
    """Half the beam at u (0 stern .. 1 bow) and v (0 waterline .. 1 deck): fuller at the deck, flared at the bow."""
    fullness = min(1.0, 2.2 * (1 - u) ** 0.75) * (0.82 + 0.18 * min(1.0, 3 * u))
    flare = 0.78 + 0.22 * v ** (0.6 + 1.4 * u)
    return BEAM / 2 * fullness * flare


def deck_height(u):
    return DEPTH + 2.5 * max(0.0, u - 0.55) ** 2 * 4


def plating(u, v):
    """Dents of up to 15 mm between frames 0.75 m apart and stringers: what makes each plate's glint its own."""
    frames = math.sin(math.pi * u * LENGTH / 0.75) ** 2
    return 0.015 * frames * math.sin(math.pi * 6 * v) ** 2


def hull_side(side):
    def surface(u, v):
        y = half_breadth(u, v)
        return u * LENGTH, side * max(0.0, y - (plating(u, v) if 0 < v < 1 and y > 0.1 else 0.0)), v * deck_height(u)
    return surface if side < 0 else lambda u, v: surface(1 - u, v)


def deck(u, v):
    return u * LENGTH, (2 * v - 1) * half_breadth(u, 1), deck_height(u)


def block_walls(writer, dent, x0, x1, y0, y1, z0, z1, cells):
    """Four walls and a roof; the walls lean in by 7 degrees and are dented by `dent`, a random number each node."""
    lean = (z1 - z0) * math.tan(math.radians(7))

    def wall(p, q, outward):
        along = [b - a for a, b in zip(p, q)]

        def surface(u, v):
            depth = lean * v + (dent() if 0 < u < 1 and 0 < v < 1 else 0.0)
            edge = lean * v * (1 - 2 * u) / math.hypot(*along)
            x = p[0] + along[0] * (u + edge) - outward[0] * depth
            y = p[1] + along[1] * (u + edge) - outward[1] * depth
            return x, y, z0 + v * (z1 - z0)
        return surface

    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    for k, outward in enumerate([(0, -1), (1, 0), (0, 1), (-1, 0)]):
        writer.grid("paint", wall(corners[k], corners[(k + 1) % 4], outward), cells, max(cells // 2, 1))
    roof = lambda u, v: (x0 + lean + u * (x1 - x0 - 2 * lean), y0 + lean + v * (y1 - y0 - 2 * lean), z1)
    writer.grid("deck_paint", roof, cells, cells)


def tube(x, y, r0, r1, z0, z1):
    def surface(u, v):
        r, angle = r0 + (r1 - r0) * v, 2 * math.pi * u
        return x + r * math.cos(angle), y + r * math.sin(angle), z0 + v * (z1 - z0)
    return surface


def write_ship(out, detail, infrared, obj=None):
    """Returns the number of triangles; without area there is none."""
    cells = lambda count: max(1, round(count * detail))
    out.write("# A ship for the bench, written by make_hull.py. Metres, z up, bow along x.\n")
    out.write(INFRARED if infrared else PLAIN)
    writer = Writer(out, obj)
    generator = random.Random(20)
    dent = lambda: generator.uniform(-0.01, 0.01)
    for side in (-1, 1):
        writer.grid("paint", hull_side(side), cells(562), cells(50))
    writer.grid("deck_paint", deck, cells(300), cells(24))
    blocks = [(28, 78, -5, 5, 8, 12), (46, 74, -4.2, 4.2, 12, 15.5), (58, 72, -3.2, 3.2, 15.5, 19), (30, 42, -3.5, 3.5, 12, 15),
              (90, 97, -2.2, 2.2, 8.6, 11)]
    for block in blocks:
        block_walls(writer, dent, *block, cells(44))
    for x in (50.0, 36.0):
        writer.grid("paint", tube(x, 0, 1.9, 1.5, 15, 20.5), cells(64), cells(32))
        writer.grid("hot", tube(x, 0, 1.2, 1.2, 20.2, 20.9), cells(64), cells(4))
    writer.grid("steel", tube(64, 0, 0.5, 0.15, 19, 31), cells(48), cells(60))
    return writer.count


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--detail", type=float, default=1.0)
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument("--infrared", action="store_true")
    kind.add_argument("--obj", action="store_true")
    options = parser.parse_args()
    if options.obj:
        with open(os.devnull, "w", encoding="ascii") as nothing:
            count = write_ship(nothing, options.detail, False, sys.stdout)
    else:
        count = write_ship(sys.stdout, options.detail, options.infrared)
    print(f"make_hull: {count} triangles", file=sys.stderr)


if __name__ == "__main__":
    main()
