"""V4: exchange between diffuse grey surfaces. Concentric spheres and infinite parallel plates, by radiosity."""
from bench import SPLIT_PATHS, Result, along, grey_wall, lambertian, looking_at, mean_of_groups, on_sphere, turned
from closed_forms import LONG_WAVE, band_radiance

TITLE = "Concentric spheres, parallel plates"
METHOD = ("Rays towards points of each surface from directions of a lattice; 64 lattices, each shifted at "
          "random, give the standard error. Walls are thermal around diffuse plastic.")

BAR = 1e-3
UNIT = "W/(m²sr)"
GROUPS, RAYS = 64, 500                   # lattices, rays of each
HOT, COLD = 300.0, 280.0                 # K
HOT_EMISSIVITY, COLD_EMISSIVITY = 0.8, 0.5
PLATE = 1e6                              # radius of the plates 1 m apart: what escapes between them is below 1e-12

SPHERES = """# V4. A grey sphere of 1 m (emissivity .8, 300 K) within one of 2 m (.5, 280 K). What leaves the outer one
# meets the inner with probability (1/2)^2, and itself else.

{inner}{outer}inner sphere ball
0
0
4 0 0 0 1

outer bubble shell
0
0
4 0 0 0 2
"""

PLATES = """# V4. Two plates 1 m apart, emissivity .8 at 300 K below and .5 at 280 K above, of a radius at which
# no ray finds the rim.

{low}{high}low ring floor
0
0
8 0 0 0  0 0 1  0 {radius}

high ring ceiling
0
0
8 0 0 1  0 0 -1  0 {radius}
"""


def sphere_radiosities():
    """Leaving radiances of the inner and the outer sphere. Inner sees outer only; outer sees inner by 1/4."""
    e1, e2 = HOT_EMISSIVITY, COLD_EMISSIVITY
    b1, b2 = (band_radiance(temperature, *LONG_WAVE) for temperature in (HOT, COLD))
    # L1 = e1 B1 + (1-e1) L2;  L2 = e2 B2 + (1-e2) (L1/4 + 3 L2/4)
    outer = (e2 * b2 + (1 - e2) * e1 * b1 / 4) / (1 - (1 - e2) * (3 / 4 + (1 - e1) / 4))
    return e1 * b1 + (1 - e1) * outer, outer


def plate_radiosities():
    e1, e2 = HOT_EMISSIVITY, COLD_EMISSIVITY
    b1, b2 = (band_radiance(temperature, *LONG_WAVE) for temperature in (HOT, COLD))
    between = 1 - (1 - e1) * (1 - e2)
    return (e1 * b1 + (1 - e1) * e2 * b2) / between, (e2 * b2 + (1 - e2) * e1 * b1) / between


def rays_at_sphere(bench, radius, side):
    """Towards a sphere from outside (side 1) or inside (-1), begun 0.1 m before it or, for a flat ray within it, at the
    middle of its chord."""
    for _ in range(GROUPS):
        for place_u, place_v, u, v in bench.lattice(RAYS, 4):
            normal = on_sphere(place_u, place_v)
            local = lambertian(u, v)
            outward = turned(local, tuple(side * x for x in normal))
            yield looking_at(along((0, 0, 0), normal, radius), outward, min(0.1, radius * local[2]))


def rays_at_plate(bench, height, side):
    for _ in range(GROUPS):
        for u, v in bench.lattice(RAYS):
            yield looking_at((0, 0, height), turned(lambertian(u, v), (0, 0, side)), 0.1)


def results(bench):
    spheres = bench.octree("spheres", SPHERES.format(inner=grey_wall("inner", HOT_EMISSIVITY, HOT),
                                                     outer=grey_wall("outer", COLD_EMISSIVITY, COLD)))
    plates = bench.octree("plates", PLATES.format(low=grey_wall("low", HOT_EMISSIVITY, HOT),
                                                  high=grey_wall("high", COLD_EMISSIVITY, COLD), radius=PLATE))
    inner, outer = sphere_radiosities()
    low, high = plate_radiosities()
    cases = [("inner sphere", spheres, rays_at_sphere(bench, 1, 1), inner, "36.608773"),
             ("outer sphere", spheres, rays_at_sphere(bench, 2, -1), outer, "29.042168"),
             ("lower plate", plates, rays_at_plate(bench, 0, 1), low, ""),
             ("upper plate", plates, rays_at_plate(bench, 1, -1), high, "")]
    rows = []
    for what, octree, rays, closed, figure in cases:
        seen = mean_of_groups(bench.trace(octree, list(rays), *SPLIT_PATHS), RAYS)
        rows.append(Result(what, UNIT, closed, seen.mean, seen.error, BAR, figure))
    return rows
