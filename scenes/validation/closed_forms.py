"""What the closed forms of several cases need: quadrature, Planck's law and Fresnel's equations, by Python's own
means and with nothing of the renderer's."""
import cmath
import functools
import math

PLANCK = 6.62607015e-34      # J·s
LIGHT_SPEED = 299792458.0    # m/s
BOLTZMANN = 1.380649e-23     # J/K
STEFAN_BOLTZMANN = 2 * math.pi ** 5 * BOLTZMANN ** 4 / (15 * PLANCK ** 3 * LIGHT_SPEED ** 2)    # W·m⁻²·K⁻⁴

LONG_WAVE = (8.0, 12.0)      # µm


@functools.lru_cache(maxsize=None)
def gauss_legendre(count):
    """Nodes and weights on -1..1, the nodes by Newton's method on the Legendre polynomial."""
    rule = []
    for i in range(count):
        x = math.cos(math.pi * (i + 0.75) / (count + 0.5))
        for _ in range(100):
            before, value = 1.0, x
            for k in range(2, count + 1):
                before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
            slope = count * (x * value - before) / (x * x - 1)
            step = value / slope
            x -= step
            if abs(step) < 1e-15:
                break
        rule.append((x, 2 / ((1 - x * x) * slope * slope)))
    return rule


def nodes(edges, count=8):
    """Points and weights of Gauss-Legendre quadrature in each interval between neighbouring `edges`."""
    return [(low + (high - low) * (1 + x) / 2, (high - low) * weight / 2)
            for low, high in zip(edges, edges[1:]) for x, weight in gauss_legendre(count)]


def steps(low, high, count):
    return [low + (high - low) * i / count for i in range(count + 1)]


def integral(function, low, high, pieces=64):
    return math.fsum(function(x) * weight for x, weight in nodes(steps(low, high, pieces)))


def planck_um(wavelength_um, temperature):
    """Radiance of a black body at one wavelength, W·m⁻²·sr⁻¹·µm⁻¹."""
    wavelength = wavelength_um * 1e-6
    return 1e-6 * 2 * PLANCK * LIGHT_SPEED ** 2 / wavelength ** 5 / math.expm1(
        PLANCK * LIGHT_SPEED / (wavelength * BOLTZMANN * temperature))


@functools.lru_cache(maxsize=None)
def band_radiance(temperature, low_um, high_um):
    """Radiance of a black body in a band, W·m⁻²·sr⁻¹: over the logarithm of the wavelength, where Planck's law is
    smooth in any band."""
    return integral(lambda t: planck_um(math.exp(t), temperature) * math.exp(t), math.log(low_um), math.log(high_um))


def fresnel_reflectance(cosine, index):
    """Unpolarised reflectance of a flat surface with the complex refractive index `index`."""
    inside = cmath.sqrt(index * index - (1 - cosine * cosine))
    senkrecht = (cosine - inside) / (cosine + inside)
    parallel = (index * index * cosine - inside) / (index * index * cosine + inside)
    return (abs(senkrecht) ** 2 + abs(parallel) ** 2) / 2
