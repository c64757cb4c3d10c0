#!/usr/bin/env python3
"""Writes the BRDF table of panels 6 and 7: .86 Lambertian + .14 directional lobe.

    make_brdf.py panel.brdf

The lobe lies around the mirror direction, wholly within 90 deg of azimuth of it. For a vertical panel
seen in the vertical plane through its normal that is the half below the horizon when the viewer is
above it, and the half above when the viewer is below.

The table as interpolated (trilinear) reflects exactly 1 towards every viewing angle, and is
reciprocal: lobe values are s(theta_i) s(theta_r) g(theta_i, theta_r) p(phi), with g and p given below and
s found by Sinkhorn's iteration so that the hemispherical integral is .14 at every node. Under a sky and a
sea of constant radiance the answer is then .86 (sky + sea)/2 + .14 sea (or sky, from below).
"""
import math
import sys

LAMBERTIAN = 0.86
LOBE = 0.14
POLAR_NODES = 19    # 5 deg apart, for theta_i and theta_r, so that 30 deg is a node
HALF_ROWS = 19      # phi 0..180 deg, 10 deg apart, so that the horizon, 90 deg, is a node
WIDTH_DEG = 8.0     # of the Gaussian in theta_i - theta_r


def polar_weights(count):
    """Integral of each node's hat function times cos(theta) sin(theta), over 0..90 deg.

    sin(2 theta)/2 integrates to -cos(2 theta)/4 and that to -sin(2 theta)/8, so a hat's integral is
    a second difference of the latter; the ends add the boundary term 1/4.
    """
    step = math.pi / 2 / (count - 1)
    twice = [-math.sin(2 * step * i) / 8 for i in range(count)]
    inner = [(twice[i - 1] - 2 * twice[i] + twice[i + 1]) / step for i in range(1, count - 1)]
    end = 0.25 + (twice[1] - twice[0]) / step
    return [end] + inner + [end]


def azimuth_profile(row):
    """p(phi) at a row of 0..180 deg: 1 at the mirror direction, 0 from 90 deg of it on."""
    return max(0.0, -math.cos(math.pi * row / (HALF_ROWS - 1))) ** 2 if row > (HALF_ROWS - 1) // 2 else 0.0


def shape(i, j):
    """g: Gaussian in the difference of the polar angles. At the normal azimuth has no meaning, so node 0
    sees itself alone and all round; its neighbours would otherwise see beyond the horizon."""
    if i == 0 or j == 0:
        return 1.0 if i == j else 0.0
    return math.exp(-0.5 * ((i - j) * 90 / (POLAR_NODES - 1) / WIDTH_DEG) ** 2)


def balanced_lobe():
    """Values of s(i) s(j) g(i, j) with reflectance LOBE at every node."""
    weights = polar_weights(POLAR_NODES)
    row_step = math.pi / (HALF_ROWS - 1)
    profile = [azimuth_profile(k) for k in range(HALF_ROWS)]
    around = row_step * (profile[0] + profile[-1] + 2 * sum(profile[1:-1]))   # the integral of p over 360 deg
    nodes = range(POLAR_NODES)

    def reflectances(scale):
        return [scale[j] * sum(scale[i] * shape(i, j) * weights[i] for i in nodes) * (around if j else 2 * math.pi)
                for j in nodes]

    scale = [1.0] * POLAR_NODES
    for _ in range(10000):
        found = reflectances(scale)
        if max(abs(r - LOBE) for r in found) < 1e-14:
            break
        scale = [s * math.sqrt(LOBE / r) for s, r in zip(scale, found)]
    else:
        raise SystemExit("make_brdf: the lobe did not converge")
    return [[scale[i] * scale[j] * shape(i, j) for j in nodes] for i in nodes], profile


def main():
    if len(sys.argv) != 2:
        raise SystemExit("usage: make_brdf.py panel.brdf")
    lobe, profile = balanced_lobe()
    with open(sys.argv[1], "w", encoding="ascii") as out:
        out.write("# .86 Lambertian + .14 directional lobe within 90 deg of azimuth of the mirror direction,\n"
                  "# written by make_brdf.py; reciprocal, reflectance 1 at every angle\n"
                  "#% phi 180\n"
                  f"{POLAR_NODES} {HALF_ROWS} {POLAR_NODES}\n{LAMBERTIAN}\n")
        for i in range(POLAR_NODES):
            out.write(f"# theta_i = {i * 90 / (POLAR_NODES - 1):g} deg\n")
            for k in range(HALF_ROWS):
                values = (LAMBERTIAN / math.pi + lobe[i][j] * (profile[k] if i and j else 1.0)
                          for j in range(POLAR_NODES))
                out.write(" ".join(f"{f:.9g}" for f in values) + "\n")


if __name__ == "__main__":
    main()
