"""V13: contrast intensity of black bodies before a uniform background: radiance contrast times projected area."""
import math

from bench import Result, along, mean_of_groups
from closed_forms import LONG_WAVE, band_radiance

TITLE = "Contrast intensity"
METHOD = ("Parallel rays on an even lattice over a window around the target: mean of the radiance less the "
          "background's, times the window's area; 64 lattices, each shifted at random, give the standard error.")

BAR = 1e-3
UNIT = "W/sr"
TARGET, BACKGROUND = 303.15, 293.15      # K
GROUPS, RAYS = 64, 4000                 # lattices, rays of each
MARGIN = 1.02                            # of the window around the target, linear

SCENE = """# V13. {what}, black at 30 degrees Celsius, before a background of 20 degrees Celsius.

void glow background_glow
0
0
4 {background!r} {background!r} {background!r} 0

background_glow source background
0
0
4 0 0 1 360

void thermal target
0
0
3 {target} 8 12

{shape}"""
PLATE = """target polygon plate
0
0
12 0 -{h!r} -{h!r}  0 {h!r} -{h!r}  0 {h!r} {h!r}  0 -{h!r} {h!r}
"""
SPHERE = """target sphere ball
0
0
4 0 0 0 1
"""
BOX = (100.0, 20.0, 15.0)                # m, along x, y and z


def box(lengths):
    """Six rectangles around the origin."""
    text = ""
    for axis in range(3):
        for side in (-1, 1):
            corners = []
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = [0.0, 0.0, 0.0]
                corner[axis] = side * lengths[axis] / 2
                corner[(axis + 1) % 3] = a * lengths[(axis + 1) % 3] / 2
                corner[(axis + 2) % 3] = b * lengths[(axis + 2) % 3] / 2
                corners.append(" ".join(map(repr, corner)))
            text += f"target polygon face_{axis}_{'low' if side < 0 else 'high'}\n0\n0\n12 {'  '.join(corners)}\n\n"
    return text


def parallel_rays(bench, degrees, width, height, distance=200.0):
    """Horizontal rays from an azimuth, 0 is +x, through lattices in a window around the origin."""
    angle = math.radians(degrees)
    towards = (math.cos(angle), math.sin(angle), 0)
    right = (-towards[1], towards[0], 0)
    for _ in range(GROUPS):
        for u, v in bench.lattice(RAYS):
            origin = along(along(along((0, 0, 0), towards, distance), right, (u - .5) * width), (0, 0, 1),
                           (v - .5) * height)
            yield *origin, *(-x for x in towards)


def results(bench):
    background = band_radiance(BACKGROUND, *LONG_WAVE)
    contrast = band_radiance(TARGET, *LONG_WAVE) - background
    [sky] = bench.planck("-b", *LONG_WAVE, BACKGROUND)
    side = math.sqrt(10)
    length, beam, height = BOX
    shapes = {"plate": ("A plate of 10 m²", PLATE.format(h=side / 2)),
              "sphere": ("A sphere of radius 1 m", SPHERE), "box": ("A box of 100 x 20 x 15 m", box(BOX))}
    cases = [("plate", degrees, 10 * math.cos(math.radians(degrees)), side, side, figure)
             for degrees, figure in ((0, "61.8100"), (60, ""))]
    cases += [("sphere", degrees, math.pi, 2, 2, "19.41818") for degrees in (0, 73)]
    for degrees, figure in ((0, "1854.3"), (45, "7867.1"), (90, "9271.5")):
        width = beam * math.cos(math.radians(degrees)) + length * math.sin(math.radians(degrees))
        cases.append(("box", degrees, width * height, width, height, figure))

    octrees = {name: bench.octree(name, SCENE.format(what=what, shape=shape, background=sky, target=TARGET))
               for name, (what, shape) in shapes.items()}
    rows = []
    for name, degrees, area, width, height, figure in cases:
        width, height = MARGIN * width, MARGIN * height
        radiances = bench.trace(octrees[name], list(parallel_rays(bench, degrees, width, height)))
        seen = mean_of_groups([radiance - sky for radiance in radiances], RAYS) * (width * height)
        rows.append(Result(f"{name} at {degrees}°", UNIT, contrast * area, seen.mean, seen.error, BAR, figure))
    return rows
