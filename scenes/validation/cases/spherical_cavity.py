"""V6: a spherical cavity with diffuse walls and a round opening looks blacker than its wall, by the same everywhere."""
import math

from bench import SPLIT_PATHS, Result, grey_wall, lambertian, mean_of
from closed_forms import LONG_WAVE, band_radiance

TITLE = "Spherical cavity"
METHOD = ("Rays through random points of the opening, from random directions. The opening is a mixture of wall "
          "and void above a height of a whole sphere: no facets.")

BAR = 1e-3
TEMPERATURE = 300.0          # K
RAYS = 25_000
CASES = ((0.5, 0.5, "0.666667"), (0.5, 0.1, "0.909091"), (0.7, 0.25, "0.903226"))    # emissivity, open share, figure

SCENE = """# V6. A cavity in the unit sphere of which the part above z = {rim!r} is open, {share:g} of the whole. A
# cavity's wall is seen from every point of it alike, so that its radiosity is one number.

{wall}void mixfunc open_above
4 wall void if({rim!r}-Pz,1,0) .
0
0

open_above bubble cavity
0
0
4 0 0 0 1
"""


def apparent_emissivity(emissivity, share):
    """Of what the wall receives, 1 - share comes from the wall: L = e + (1-e)(1-share) L."""
    return emissivity / (1 - (1 - emissivity) * (1 - share))


def rays_into(bench, rim):
    """Through the plane of the opening, just below it."""
    radius = math.sqrt(1 - rim * rim)
    for _ in range(RAYS):
        r, phi = radius * math.sqrt(bench.random.random()), 2 * math.pi * bench.random.random()
        x, y, z = lambertian(bench.random.random(), bench.random.random())
        yield r * math.cos(phi), r * math.sin(phi), rim - 1e-4, x, y, -z


def results(bench):
    black_body = band_radiance(TEMPERATURE, *LONG_WAVE)
    rows = []
    for emissivity, share, figure in CASES:
        rim = 1 - 2 * share
        octree = bench.octree(f"cavity_{emissivity:g}_{share:g}", SCENE.format(
            rim=rim, share=share, wall=grey_wall("wall", emissivity, TEMPERATURE)))
        seen = mean_of(bench.trace(octree, list(rays_into(bench, rim)), *SPLIT_PATHS)) * (1 / black_body)
        rows.append(Result(f"apparent emissivity, wall {emissivity:g}, open {share:g}", "",
                           apparent_emissivity(emissivity, share), seen.mean, seen.error, BAR, figure))
    return rows
