"""V14: a sun of 5772 K on a diffuse plate that faces it."""
import math

from bench import Result
from closed_forms import band_radiance

TITLE = "Sun on a diffuse plate"
METHOD = ("A light source of half-angle 0.2666°: irradiance by rtrace -I, radiance of a plate of reflectance "
          ".5, and the disk as it is seen. Direct light has no noise; it comes from the disk's centre with all "
          "its solid angle, which is 5e-6 too much for a plate that faces it.")

BAR = 1e-3
TEMPERATURE = 5772.0         # K
HALF_ANGLE = 0.2666          # degrees
REFLECTANCE = 0.5
CASES = (((3, 5), "21.842", "3.4762"), ((8, 12), "1.2995", "0.20682"))    # µm, W/m², W/(m²sr)

SCENE = """# V14. A sun of 5772 K in the zenith, as large as it looks from the earth, and a plate that faces it.
# Its radiance is that of a black body in {low}-{high} µm; nothing is lost on the way.

void light sun_light
0
0
3 {radiance!r} {radiance!r} {radiance!r}

sun_light source sun
0
0
4 0 0 1 {angle!r}

void plastic diffuse
0
0
5 {reflectance} {reflectance} {reflectance} 0 0

diffuse ring plate
0
0
8 0 0 0  0 0 1  0 1
"""


def results(bench):
    half = math.radians(HALF_ANGLE)
    tilt = math.radians(60)
    rows = []
    for band, irradiance_figure, radiance_figure in CASES:
        [radiance] = bench.planck("-b", *band, TEMPERATURE)
        octree = bench.octree(f"sun_{band[0]}_{band[1]}", SCENE.format(
            low=band[0], high=band[1], radiance=radiance, angle=2 * HALF_ANGLE, reflectance=REFLECTANCE))
        sun = band_radiance(TEMPERATURE, *band)
        irradiance = sun * 2 * math.pi * (1 - math.cos(half))
        [seen] = bench.trace(octree, [(0, 0, 2, 0, 0, 1)])
        facing, tilted = bench.trace(octree, [(0, 0, 2, 0, 0, 1), (0, 0, 2, math.sin(tilt), 0, math.cos(tilt))], "-I")
        [plate] = bench.trace(octree, [(0.5, 0, 0.5, -math.sqrt(.5), 0, -math.sqrt(.5))])
        name = f"{band[0]}–{band[1]} µm"
        rows += [
            Result(f"{name}, disk seen", "W/(m²sr)", sun, seen, 0, BAR),
            Result(f"{name}, irradiance facing", "W/m²", irradiance, facing, 0, BAR, irradiance_figure),
            Result(f"{name}, irradiance at 60°", "W/m²", irradiance * math.cos(tilt), tilted, 0, BAR),
            Result(f"{name}, plate of reflectance .5", "W/(m²sr)", irradiance * REFLECTANCE / math.pi, plate, 0, BAR,
                   radiance_figure),
        ]
    return rows
