"""V1: Planck's law in bands. The program `planck` against Gauss-Legendre quadrature of the law."""
import math

from bench import TEXT_ROUNDING, Result
from closed_forms import STEFAN_BOLTZMANN, band_radiance

TITLE = "Planck's law in bands"
METHOD = ("planck -b for radiances, planck -i for the way back; the fraction below a wavelength is the radiance "
          "from 0.2 µm at 1000 K over σT⁴/π.")

BAR = 1e-6                   # relative
INVERSE_BAR = 1e-4           # K
UNIT = "W/(m²sr)"
FIGURES = {                  # kelvin: in 3-5, 8-12 and 8-14 µm, and σT⁴/π
    250: ("0.21703", "14.55930", "22.29229", "70.5053"),
    300: ("1.86596", "38.50042", "54.93346", "146.1998"),
    350: ("8.97435", "78.03554", "106.44447", "270.8532"),
}
BANDS = ((3, 5), (8, 12), (8, 14))
CELSIUS = {15: "31.4780", 20: "34.3344", 25: "37.3463"}
FRACTIONS = {2898: "0.250106", 4107: "0.499956", 10000: "0.914157"}      # by µm·K


def total(temperature):
    return STEFAN_BOLTZMANN * temperature ** 4 / math.pi


def radiance(bench, temperature, low, high, figure):
    return Result(f"{temperature:g} K, {low}–{high} µm", UNIT, band_radiance(temperature, low, high),
                  bench.planck("-b", low, high, temperature)[0], 0, BAR, figure, rounding=TEXT_ROUNDING)


def results(bench):
    rows = [radiance(bench, temperature, *band, figure) for temperature, figures in FIGURES.items()
            for band, figure in zip(BANDS, figures)]
    for temperature, figures in FIGURES.items():       # all wavelengths: what 0.2–1000 µm leaves out is below 2e-5
        closed = total(temperature)
        rows.append(Result(f"{temperature} K, 0.2–1000 µm and beyond", UNIT, closed,
                           bench.planck("-b", 0.2, 1000, temperature)[0] + beyond(1000, temperature), 0, BAR,
                           figures[3], rounding=TEXT_ROUNDING))
    rows += [radiance(bench, celsius + 273.15, 8, 12, figure) for celsius, figure in CELSIUS.items()]
    for product, figure in FRACTIONS.items():
        closed = band_radiance(1000.0, 0.2, product / 1000) / total(1000)
        value = bench.planck("-b", 0.2, product / 1000, 1000)[0] / total(1000)
        rows.append(Result(f"fraction below λT = {product} µm·K", "", closed, value, 0, BAR, figure,
                           rounding=TEXT_ROUNDING))
    rows += [round_trip(bench, *band) for band in BANDS]
    return rows


def beyond(wavelength_um, temperature):
    """Radiance at longer wavelengths, by the quadrature of the closed forms."""
    return band_radiance(temperature, wavelength_um, 1e7)


def round_trip(bench, low, high):
    """The temperature that planck finds for the quadrature's radiance, where it is worst."""
    temperatures = [150, 200, 250, 300, 500, 1000, 2000, 3000]
    radiances = [repr(band_radiance(float(temperature), low, high)) for temperature in temperatures]
    found = bench.planck("-b", low, high, "-i", *radiances)
    worst = max(range(len(found)), key=lambda i: abs(found[i] - temperatures[i]))
    return Result(f"T from radiance, {low}–{high} µm, 150–3000 K, worst", "K", temperatures[worst], found[worst], 0,
                  INVERSE_BAR, absolute=True, rounding=TEXT_ROUNDING)
