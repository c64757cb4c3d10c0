#!/usr/bin/env python3
"""Radiance that a vertical panel with a .brdf table reflects from a constant sky and a constant sea.

    quadrature.py panel.brdf [--sky 31.48] [--sea 34.34] [--elevation 30] [--scale 1]

Reads the table by itself and integrates f L cos(theta) over the hemisphere by midpoints, doubling the polar ones
until the result settles: nothing here is shared with the ray tracer or with make_brdf.py. The viewer stands in the
vertical plane through the panel's normal, `elevation` degrees above the horizon, and below it: both are printed.
"""
import argparse
import math

SETTLED = 1e-6      # relative change at which doubling stops


class Table:
    """f [1/sr] at angles in radians, linear between the nodes of a .brdf file."""

    def __init__(self, path):
        self.half, mirror_zero, words = False, False, []
        with open(path, encoding="ascii") as lines:
            for line in lines:
                text, _, comment = line.partition("#")
                words += text.split()
                directive = comment[1:].split() if comment.startswith("%") else []
                self.half = self.half or directive == ["phi", "180"]
                mirror_zero = mirror_zero or directive == ["mirror", "0"]
        self.ni, self.np, self.nt = (int(word) for word in words[:3])
        numbers = [float(word) for word in words[3:]]
        block = self.np * self.nt
        if len(numbers) == self.ni * block + 1:
            self.f = numbers[1:]
        elif len(numbers) == self.ni * (block + 1):
            self.f = [v for i in range(self.ni) for v in numbers[i * (block + 1) + 1:(i + 1) * (block + 1)]]
        else:
            raise SystemExit(f"{path}: {len(numbers)} values do not fit the counts {words[:3]}")
        self.turn = math.pi if mirror_zero else 0.0

    @staticmethod
    def place(x, last):
        cell = min(int(x), last - 1)
        return cell, x - cell

    def eval(self, theta_i, phi, theta_r):
        """The eight corners, by nested linear steps."""
        i, a = self.place(theta_i / (math.pi / 2) * (self.ni - 1), self.ni - 1)
        j, c = self.place(theta_r / (math.pi / 2) * (self.nt - 1), self.nt - 1)
        phi = (phi + self.turn) % (2 * math.pi)
        if self.half:
            k, b = self.place(min(phi, 2 * math.pi - phi) / math.pi * (self.np - 1), self.np - 1)
            rows = (k, k + 1)
        else:
            k, b = self.place(phi / (2 * math.pi) * self.np, self.np)
            rows = (k, (k + 1) % self.np)
        total = 0.0
        for i_node, i_weight in ((i, 1 - a), (i + 1, a)):
            for k_node, k_weight in zip(rows, (1 - b, b)):
                start = (i_node * self.np + k_node) * self.nt + j
                total += i_weight * k_weight * ((1 - c) * self.f[start] + c * self.f[start + 1])
        return total


def midpoints(table, elevation, sky, sea, thetas, azimuths):
    """Local frame: z the normal, x up. Azimuths in a multiple of 4 keep the horizon between the midpoints."""
    theta_r = abs(elevation)
    viewer_azimuth = 0.0 if elevation >= 0 else math.pi
    step, turn = math.pi / 2 / thetas, 2 * math.pi / azimuths
    total = 0.0
    for a in range(thetas):
        theta = (a + 0.5) * step
        ring = 0.0
        for b in range(azimuths):
            azimuth = (b + 0.5) * turn
            ring += table.eval(theta, viewer_azimuth - azimuth, theta_r) * (sky if math.cos(azimuth) > 0 else sea)
        total += ring * math.cos(theta) * math.sin(theta)
    return total * step * turn


def reflected(table, elevation_deg, sky, sea):
    """Reflected radiance in the unit of sky and sea, and the last relative change on doubling the polar midpoints.

    f is linear in azimuth between rows, so midpoints between them are exact when the horizon lies on a row."""
    azimuths = 4 * (2 * (table.np - 1) if table.half else table.np)
    thetas, before = 2 * (table.ni - 1), 0.0
    while True:
        now = midpoints(table, math.radians(elevation_deg), sky, sea, thetas, azimuths)
        change = abs(now - before) / now
        if change < SETTLED:
            return now, change
        thetas, before = 2 * thetas, now


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("table")
    parser.add_argument("--sky", type=float, default=31.48)
    parser.add_argument("--sea", type=float, default=34.34)
    parser.add_argument("--elevation", type=float, default=30.0, help="degrees above the horizon")
    parser.add_argument("--scale", type=float, default=1.0, help="factor on the table")
    options = parser.parse_args()
    table = Table(options.table)
    for name, elevation in (("above", options.elevation), ("below", -options.elevation)):
        radiance, change = reflected(table, elevation, options.sky, options.sea)
        print(f"{name} {options.scale * radiance:.6f} settled {change:.1e}")


if __name__ == "__main__":
    main()
