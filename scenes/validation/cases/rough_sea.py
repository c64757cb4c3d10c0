"""V10: emissivity of a wind-roughened sea, from Cox and Munk's slopes."""
import math

from bench import Result
from closed_forms import fresnel_reflectance, nodes, steps

TITLE = "Wind-roughened sea"
METHOD = ("brdftab -cox-munk, column of the model's direct emission, against a quadrature over the slopes of "
          "the facets that are seen. Bar in emissivity.")

BAR = 5e-4
INDEX = 1.218 + 0.0508j      # 10 µm
DEGREES = (0, 60, 80)
FIGURES = {5: ("0.9898", "0.9566", "0.7664"), 15: ("0.9897", "0.9511", "0.8301")}    # by wind, m/s
PRINTED = 1e-6               # brdftab's report has six decimals


def emissivity(wind, angle):
    """Mean over the facets of slope (p, q) of a Gaussian of total variance .003 + .00512 wind: those that face the
    viewer, weighted by the area that they show, (cos - p sin)/cos, of which the mean is normalised."""
    deviation = math.sqrt(.003 + 5.12e-3 * wind)
    reach = 6 * deviation
    sine, cosine = math.sin(angle), math.cos(angle)
    highest = min(reach, cosine / sine) if sine > 0 else reach
    emitted, seen = [], []
    # facets seen edge-on: p = highest - s², for a smooth integrand there
    for s, weight_s in nodes(steps(0, math.sqrt(highest + reach), 24)):
        p = highest - s * s
        for q, weight_q in nodes(steps(0, reach, 12)):
            facing = (cosine - p * sine) / math.sqrt(1 + p * p + q * q)
            if facing <= 0:
                continue
            share = weight_s * 2 * s * weight_q * math.exp(-(p * p + q * q) / deviation ** 2) * (cosine - p * sine)
            seen.append(share)
            emitted.append(share * (1 - fresnel_reflectance(facing, INDEX)))
    return math.fsum(emitted) / math.fsum(seen)


def reported(text):
    """Emissivity of direct emission by degrees, from brdftab's report."""
    table = {}
    for line in text.splitlines():
        words = line.split()
        if len(words) == 5 and words[0].replace(".", "").isdigit():
            table[float(words[0])] = float(words[4])
    return table


def results(bench):
    rows = []
    for wind, figures in FIGURES.items():
        report = bench.run("brdftab", "-cox-munk", wind, INDEX.real, INDEX.imag, "-n", 19, 36, 19)
        table = reported(report.decode())
        for degrees, figure in zip(DEGREES, figures):
            rows.append(Result(f"{wind} m/s, {degrees}°", "", emissivity(wind, math.radians(degrees)),
                               table[degrees], 0, BAR, figure, absolute=True, rounding=PRINTED))
    return rows
