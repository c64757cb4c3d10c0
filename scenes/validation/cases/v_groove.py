"""V8: a long V-groove with diffuse walls; its apparent emissivity by the integral equation of its radiosity."""
import math
import operator

from bench import HUGE, SPLIT_PATHS, Result, grey_wall, lambertian, mean_of_groups
from closed_forms import LONG_WAVE, band_radiance, nodes

TITLE = "Diffuse V-groove"
METHOD = ("Rays through points of the opening from directions of a lattice, so that their mean is the "
          "hemispherical value; 64 lattices, each shifted at random, give the standard error. The walls are 1 m "
          "wide and 2000 km long: what the ends let out is below 1e-11.")

BAR = 1e-3
TEMPERATURE = 300.0          # K
GROUPS, RAYS = 64, 500     # lattices, rays of each
CASES = ((60, 0.5, "0.65410"), (60, 0.7, "0.81299"), (90, 0.7, "0.76457"))    # full angle, emissivity, figure
HALF_LENGTH = 1e6            # m

SCENE = """# V8. Two plates of width 1 that meet along the y axis at {angle} degrees and open upwards.

{wall}wall polygon left
0
0
12 0 {near!r} 0  0 {far!r} 0  {minus_x!r} {far!r} {z!r}  {minus_x!r} {near!r} {z!r}

wall polygon right
0
0
12 0 {near!r} 0  0 {far!r} 0  {x!r} {far!r} {z!r}  {x!r} {near!r} {z!r}
"""


def apparent_emissivity(angle, emissivity):
    """B(x) = e + (1-e) ∫ K(x,y) B(y) dy over the distance y of the other wall's points from the vertex, with the
    kernel K = sin²a x y / (2 r³), r² = x² + y² - 2 x y cos a, of strips of infinite length; by Neumann's series on
    intervals that halve towards the vertex. The heat that leaves both walls is that which leaves the opening."""
    sine, cosine = math.sin(angle), math.cos(angle)
    points = nodes([0.0] + [2.0 ** -k for k in range(24, -1, -1)], 5)
    kernel = [[weight * sine * sine * x * y / (2 * (x * x + y * y - 2 * x * y * cosine) ** 1.5)
               for y, weight in points] for x, _ in points]
    radiosity = [1.0] * len(points)
    change = 1.0
    while change > 1e-12:
        following = [emissivity + (1 - emissivity) * sum(map(operator.mul, row, radiosity)) for row in kernel]
        change = max(abs(a - b) for a, b in zip(radiosity, following))
        radiosity = following
    lost = emissivity / (1 - emissivity) * sum(weight * (1 - b) for (_, weight), b in zip(points, radiosity))
    return 2 * lost / (2 * math.sin(angle / 2))


def rays_into(bench, half_width, height):
    for _ in range(GROUPS):
        for place, u, v in bench.lattice(RAYS, 3):
            x, y, z = lambertian(u, v)
            yield half_width * (2 * place - 1), 0, height, x, y, -z


def results(bench):
    black_body = band_radiance(TEMPERATURE, *LONG_WAVE)
    rows = []
    for degrees, emissivity, figure in CASES:
        angle = math.radians(degrees)
        x, z = math.sin(angle / 2), math.cos(angle / 2)
        octree = bench.octree(f"groove_{degrees}_{emissivity:g}", SCENE.format(
            angle=degrees, near=-HALF_LENGTH, far=HALF_LENGTH, x=x, minus_x=-x, z=z,
            wall=grey_wall("wall", emissivity, TEMPERATURE)))
        seen = mean_of_groups(bench.trace(octree, list(rays_into(bench, x, z)), *SPLIT_PATHS, interpolation=HUGE), RAYS) * (1 / black_body)
        rows.append(Result(f"apparent emissivity, {degrees}°, walls {emissivity:g}", "",
                           apparent_emissivity(angle, emissivity), seen.mean, seen.error, BAR, figure))
    return rows
