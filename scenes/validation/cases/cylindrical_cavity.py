"""V7: an isothermal cylindrical cavity with diffuse walls and a flat bottom, by its two integral equations."""
import math

from bench import SPLIT_PATHS, Result, grey_wall, lambertian, mean_of_groups
from closed_forms import LONG_WAVE, band_radiance, nodes, steps

TITLE = "Cylindrical cavity"
METHOD = ("Rays through points of the opening from directions of a lattice for the hemispherical value, along "
          "the axis for the normal one, to the centre of the bottom for the last; 64 lattices, each shifted at "
          "random, give the standard error.")

BAR = 1e-3
TEMPERATURE = 300.0          # K
DEPTH = 4.0                  # radius 1
GROUPS, RAYS = 64, 340       # lattices, rays of each
FIGURES = {0.7: ("0.91412", "0.97793", "0.97639"), 0.5: ("0.83295", "0.94961", "0.94603")}    # by emissivity

SCENE = """# V7. A cylinder of radius 1 and depth 4 with a flat bottom, open above.

{wall}wall tube side
0
0
7 0 0 0  0 0 {depth}  1

wall ring bottom
0
0
8 0 0 0  0 0 1  0 1
"""


def wall_to_end(z):
    """View factor from a wall element to the disk that ends the cylinder at distance z."""
    x = z / 2
    return (x * x + 0.5) / math.sqrt(x * x + 1) - x


def wall_to_wall(z):
    """From a wall element to a ring of the wall of unit width at distance z."""
    x = abs(z) / 2
    return (1 - x * (2 * x * x + 3) / (2 * (x * x + 1) ** 1.5)) / 2


def bottom_to_wall(r, z):
    """From an element of the bottom at radius r to a ring of the wall of unit width at height z: the slope of the view
    factor to the disk at that height, as in bottom_to_opening."""
    s = r * r + z * z
    root = math.sqrt((s + 1) ** 2 - 4 * r * r)
    return z * (1 / root - (s - 1) * (s + 1) / root ** 3)


def bottom_to_opening(r):
    """From an element of the bottom at radius r to the disk of the opening."""
    s = r * r + DEPTH * DEPTH
    return (1 - (s - 1) / math.sqrt((s + 1) ** 2 - 4 * r * r)) / 2


def apparent_emissivities(emissivity):
    """Hemispherical, normal, and of the centre of the bottom. Radiosities w of the wall and b of the bottom, relative
    to a black body's, by iteration on intervals that halve towards the corner, where the kernels peak; the kink of the
    wall's own is taken out by subtracting w(z)."""
    halving = [2.0 ** -k for k in range(1, 13)]
    walls = nodes([0.0, *reversed(halving), *steps(1, DEPTH, 6)], 4)
    disk = nodes([0.0, *(1 - x for x in halving), 1.0], 4)
    reflectance = 1 - emissivity
    side = [[weight * wall_to_wall(z - other) for other, weight in walls] for z, _ in walls]
    down = [scaled([weight * r * bottom_to_wall(r, z) for r, weight in disk], wall_to_end(z)) for z, _ in walls]
    up = [scaled([weight * bottom_to_wall(r, z) for z, weight in walls], 1 - bottom_to_opening(r)) for r, _ in disk]
    kept = [1 - wall_to_end(z) - wall_to_end(DEPTH - z) - sum(row) for (z, _), row in zip(walls, side)]
    w, b, change = [1.0] * len(walls), [1.0] * len(disk), 1.0
    while change > 1e-12:
        new_w = [emissivity + reflectance * (dot(side_row, w) + kept_share * w[i] + dot(down_row, b))
                 for i, (side_row, down_row, kept_share) in enumerate(zip(side, down, kept))]
        new_b = [emissivity + reflectance * dot(row, w) for row in up]
        change = max(abs(x - y) for x, y in zip(w + b, new_w + new_b))
        w, b = new_w, new_b
    centre = emissivity + reflectance * sum(weight * bottom_to_wall(0, z) * x for (z, weight), x in zip(walls, w))
    lost = emissivity / reflectance * (sum(weight * 2 * (1 - x) for (_, weight), x in zip(walls, w))
                                       + sum(weight * 2 * r * (1 - x) for (r, weight), x in zip(disk, b)))
    return lost, sum(weight * 2 * r * x for (r, weight), x in zip(disk, b)), centre


def scaled(row, total):
    """Factors whose sum is known, as that of view factors is: what quadrature misses of a peak is made good."""
    return [x * total / sum(row) for x in row]


def dot(row, values):
    return sum(x * y for x, y in zip(row, values))


def on_opening(u, v):
    r, phi = math.sqrt(u), 2 * math.pi * v
    return r * math.cos(phi), r * math.sin(phi), DEPTH


def from_all_sides(place_u, place_v, u, v):
    x, y, z = lambertian(u, v)
    return *on_opening(place_u, place_v), x, y, -z


def along_axis(place_u, place_v):
    return *on_opening(place_u, place_v), 0, 0, -1


def to_centre(_u, _v):
    return 0, 0, DEPTH, 0, 0, -1


def results(bench):
    black_body = band_radiance(TEMPERATURE, *LONG_WAVE)
    views = (("hemispherical", from_all_sides, 4), ("normal", along_axis, 2), ("centre of the bottom", to_centre, 2))
    rows = []
    for emissivity, figures in FIGURES.items():
        octree = bench.octree(f"cylinder_{emissivity:g}", SCENE.format(
            depth=DEPTH, wall=grey_wall("wall", emissivity, TEMPERATURE)))
        for (what, ray, dimensions), closed, figure in zip(views, apparent_emissivities(emissivity), figures):
            rays = [ray(*point) for _ in range(GROUPS) for point in bench.lattice(RAYS, dimensions)]
            seen = mean_of_groups(bench.trace(octree, rays, *SPLIT_PATHS), RAYS) * (1 / black_body)
            rows.append(Result(f"{what}, walls {emissivity:g}", "", closed, seen.mean, seen.error, BAR, figure))
    return rows
