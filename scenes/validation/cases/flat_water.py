"""V9: emissivity of flat water by Fresnel's equations: a thermal surface around water that is written in the scene
language, against complex arithmetic."""
import math

from bench import Result
from closed_forms import fresnel_reflectance

TITLE = "Flat water"
METHOD = ("thermal around a mixture of mirror and black by Fresnel's equations (water.cal); radiance in the "
          "cold over that of a black body. Bar in emissivity.")

BAR = 1e-5
# µm, n, k of water (Hale and Querry, Applied Optics 12 (1973) 555), emissivity at 0, 60 and 80°
WATER = ((4.0, 1.351, 0.0046, ("0.97771", "0.93694", "0.64633")),
         (10.0, 1.218, 0.0508, ("0.98982", "0.96124", "0.69723")),
         (12.0, 1.111, 0.199, ("0.98845", "0.94888", "0.64311")))
DEGREES = (0, 60, 80)

FUNCTIONS = """{ Unpolarised Fresnel reflectance of water with the complex refractive index A1 + i A2 (Born and Wolf,
  14.2): a + i b is the root of index^2 - sin^2, from the modulus and the real part of that. }
cosine = abs(Rdot);
sine2 = 1 - cosine*cosine;
difference = A1*A1 - A2*A2 - sine2;
modulus = sqrt(difference*difference + 4*A1*A1*A2*A2);
a = sqrt((modulus + difference)/2);
senkrecht = (modulus - 2*a*cosine + cosine*cosine)/(modulus + 2*a*cosine + cosine*cosine);
tangent = sine2/cosine;
parallel_share = (modulus - 2*a*tangent + tangent*tangent)/(modulus + 2*a*tangent + tangent*tangent);
water = senkrecht*(1 + parallel_share)/2;
"""

TEMPERATURE = 300.0          # K
BAND = 0.1                   # µm, width around the wavelength

SCENE = """# V9. Flat water of 300 K and index {n} + {k} i around {um} µm, with nothing to reflect.

void metal mirror_1
0
0
5 1 1 1 1 0

void plastic black
0
0
5 0 0 0 0 0

void mixfunc water
4 mirror_1 black water water.cal
0
2 {n} {k}

void thermal sea
1 water
0
3 {temperature} {low!r} {high!r}

sea ring surface
0
0
8 0 0 0  0 0 1  0 10
"""


def results(bench):
    bench.write("water.cal", FUNCTIONS)
    rows = []
    for um, n, k, figures in WATER:
        low, high = um - BAND / 2, um + BAND / 2
        octree = bench.octree(f"water_{um:g}", SCENE.format(um=um, n=n, k=k, temperature=TEMPERATURE, low=low,
                                                              high=high))
        [black_body] = bench.planck("-b", low, high, TEMPERATURE)
        angles = [math.radians(degrees) for degrees in DEGREES]
        rays = [(-math.sin(angle), 0, math.cos(angle), math.sin(angle), 0, -math.cos(angle)) for angle in angles]
        for degrees, angle, radiance, figure in zip(DEGREES, angles, bench.trace(octree, rays), figures):
            rows.append(Result(f"{um:g} µm, {degrees}°", "", 1 - fresnel_reflectance(math.cos(angle), n + 1j * k),
                               radiance / black_body, 0, BAR, figure, absolute=True))
    return rows
