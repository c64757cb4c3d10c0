"""V15: a closed diffuse room with a lamp in its middle; the mean of the indirect irradiance of its walls."""
import math

from bench import Result, mean_of_groups

TITLE = "Closed diffuse room"
METHOD = ("rtrace -I at points of the walls of a cube, on a lattice, with and without interreflection; 64 lattices, each "
          "shifted at random, give the standard error. What is reflected n times has passed through all walls n times: "
          "their mean is (flux/area) r/(1-r). source: CIE 171 (2006), 5.8.")

BAR = 5e-3
UNIT = "W/m²"
SIDE, FLUX = 4.0, 1e4                   # m; of the lamp
LAMP = 0.01                             # radius, m: it takes a hundred-thousandth of what is reflected
GROUPS, POINTS = 64, 24                 # lattices, points of each
CASES = ((.3, "44.643"), (.7, "243.056"), (.9, "937.5"))
OPTIONS = ("-I+", "-ad", 64, "-dj", 0, "-ds", 0, "-dt", 0)

SCENE = """# V15. A cube of 4 m whose walls reflect {r:g}, lit by a small lamp in its middle.

void plastic wall
0
0
5 {r:g} {r:g} {r:g} 0 0

void light lum
0
0
3 {lum!r} {lum!r} {lum!r}

lum sphere lamp
0
0
4 0 0 0 {lamp:g}

{walls}"""


def walls():
    """Six polygons that face inwards."""
    half = SIDE / 2
    text = []
    for axis in range(3):
        for side in (-1, 1):
            corners = []
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))[::-side]:
                point = [0.0] * 3
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side * half, u * half, v * half
                corners.append(" ".join(f"{x:g}" for x in point))
            text.append(f"wall polygon wall_{axis}_{'+' if side > 0 else '-'}\n0\n0\n12 " + "  ".join(corners) + "\n")
    return "\n".join(text)


def points_on_walls(bench):
    """Position and normal, as rtrace -I takes them: four points of a lattice on each wall."""
    half = SIDE / 2
    for _ in range(GROUPS):
        for i, (u, v) in enumerate(bench.lattice(POINTS)):
            axis, side = i % 3, 1 if i % 6 < 3 else -1
            point, normal = [0.0] * 3, [0.0] * 3
            point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side * half, SIDE * (u - .5), SIDE * (v - .5)
            normal[axis] = -side
            point[axis] += 1e-6 * normal[axis]
            yield *point, *normal


def results(bench):
    lum = FLUX / (4 * math.pi ** 2 * LAMP ** 2)
    area = 6 * SIDE ** 2
    rows = []
    for reflectance, figure in CASES:
        octree = bench.octree(f"room_{reflectance:g}",
                              SCENE.format(r=reflectance, lum=lum, lamp=LAMP, walls=walls()))
        points = list(points_on_walls(bench))
        bounces = math.ceil(math.log(1e-4) / math.log(reflectance))
        path = (*OPTIONS, "-aa", 0, "-as", 0, "-lr", 0, "-lw", 1e-3)
        total = bench.trace(octree, points, *path, "-ab", bounces, interpolation=("-ab", bounces, "-lw", 0))
        direct = bench.trace(octree, points, *path, "-ab", 0, cached=False)
        indirect = mean_of_groups([t - d for t, d in zip(total, direct)], POINTS)
        closed = FLUX / area * reflectance / (1 - reflectance)
        rows.append(Result(f"mean indirect irradiance, reflectance {reflectance:g}", UNIT, closed, indirect.mean,
                           indirect.error, BAR, figure))
    return rows
