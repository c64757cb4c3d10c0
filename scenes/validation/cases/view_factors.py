"""V5: view factors of Howell's catalogue, as the irradiance from a surface of radiance 1, over pi (rtrace -I)."""
import math

from bench import Result, mean_of_groups

TITLE = "View factors"
METHOD = ("rtrace -I on an even lattice over the receiving surface; 64 lattices, each shifted at random, give "
          "the standard error.")

BAR = 1e-3
GROUPS = 64
PLACES, DIVISIONS = 2000, 256         # of a lattice, and rays from each

SCENE = """# V5. A surface of radiance 1 as seen from the other: the irradiance is pi times the view factor.

void emissive unit
0
0
3 1 1 1

unit {shape}
"""
CUBE_TOP = "polygon top\n0\n0\n12 0 0 1  0 1 1  1 1 1  1 0 1"
CUBE_SIDE = "polygon side\n0\n0\n12 0 0 0  0 1 0  0 1 1  0 0 1"
DISK = "ring disk\n0\n0\n8 0 0 {height}  0 0 -1  0 {radius}"


def opposite_squares(x=1.0, y=1.0):
    """Identical parallel rectangles x by y, at distance 1."""
    a, b = math.sqrt(1 + x * x), math.sqrt(1 + y * y)
    return 2 / (math.pi * x * y) * (
        math.log(a * b / math.sqrt(1 + x * x + y * y)) + x * b * math.atan(x / b) + y * a * math.atan(y / a)
        - x * math.atan(x) - y * math.atan(y))


def adjacent_squares(h=1.0, w=1.0):
    """Rectangles of a common edge 1 at a right angle, w wide and h high."""
    r = math.hypot(h, w)
    total = 1 + h * h + w * w
    logarithm = (math.log((1 + w * w) * (1 + h * h) / total)
                 + w * w * math.log(w * w * total / ((1 + w * w) * r * r))
                 + h * h * math.log(h * h * total / ((1 + h * h) * r * r)))
    return (w * math.atan(1 / w) + h * math.atan(1 / h) - r * math.atan(1 / r) + logarithm / 4) / (math.pi * w)


def coaxial_disks(r1, r2, height):
    """From the first to the second."""
    x = 1 + (height ** 2 + r2 ** 2) / r1 ** 2
    return (x - math.sqrt(x * x - 4 * (r2 / r1) ** 2)) / 2


def element_to_disk(radius, height):
    """To a disk from a parallel element on the axis."""
    return 1 / (1 + (height / radius) ** 2)


def element_to_corner(a, b, height):
    """A parallel element below a corner of a rectangle a by b."""
    x, y = a / height, b / height
    p, q = math.sqrt(1 + x * x), math.sqrt(1 + y * y)
    return (x / p * math.atan(y / p) + y / q * math.atan(x / q)) / (2 * math.pi)


def on_square(u, v):
    return u, v, 0, 0, 0, 1


def on_unit_disk(u, v):
    r, phi = math.sqrt(u), 2 * math.pi * v
    return r * math.cos(phi), r * math.sin(phi), 0, 0, 0, 1


def at_origin(_u, _v):
    return 0, 0, 0, 0, 0, 1


def results(bench):
    disk = DISK.format
    cases = [       # name, what it is, source, places of the receiver, how many and rays from each, closed form, figure
        ("opposite", "opposite faces of a cube", CUBE_TOP, on_square, PLACES, DIVISIONS,
         opposite_squares(), "0.199825"),
        ("adjacent", "adjacent faces of a cube", CUBE_SIDE, on_square, PLACES, DIVISIONS,
         adjacent_squares(), "0.200044"),
        ("disks", "disks, r 1 and 1, 1 apart", disk(height=1, radius=1), on_unit_disk, PLACES, DIVISIONS,
         coaxial_disks(1, 1, 1), "0.381966"),
        ("wide_disks", "disks, r 1 and 2, 1 apart", disk(height=1, radius=2), on_unit_disk, PLACES, DIVISIONS,
         coaxial_disks(1, 2, 1), "0.763932"),
        ("element_disk", "element to a disk, r/h .5", disk(height=2, radius=1), at_origin, 4, 16384,
         element_to_disk(1, 2), "0.2"),
        ("element_corner", "element below a square's corner", CUBE_TOP, at_origin, 4, 16384,
         element_to_corner(1, 1, 1), "0.138532"),
    ]
    rows = []
    for name, what, shape, place, places, divisions, closed, figure in cases:
        octree = bench.octree(name, SCENE.format(shape=shape))
        rays = [place(*point) for _ in range(GROUPS) for point in bench.lattice(places)]
        # Few values are computed where they are interpolated; those at the origin are one and the same.
        every = ("-ad", 2 ** 20 if place is at_origin else 2 ** 16)
        irradiances = bench.trace(octree, rays, "-I", "-ab", 1, "-aa", 0, "-ad", divisions, "-as", 0, "-lw", 1e-12,
                                  interpolation=("-ab", 1, "-lw", 0, *every))
        factor = mean_of_groups(irradiances, places) * (1 / math.pi)
        rows.append(Result(what, "", closed, factor.mean, factor.error, BAR, figure))
    return rows
