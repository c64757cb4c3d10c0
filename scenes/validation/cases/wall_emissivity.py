"""Closed forms of the emissivity of walls by the cosine of the angle: what they neither reflect nor transmit."""
import math

from closed_forms import nodes, steps


def fresnel_approximation(cosine):
    """RADIANCE's stand-in for Fresnel's equations at smooth plastic and metal."""
    return math.exp(-5.85 * cosine) - 0.00287989916


def plastic_emissivity(color, specularity, cosine):
    return (1 - color) * (1 - specularity) * (1 - fresnel_approximation(cosine))


def metal_emissivity(color, cosine):
    """The diffuse part and the mirror of a metal are of one colour but for Fresnel's share, which is white."""
    return (1 - color) * (1 - fresnel_approximation(cosine))


def glass_emissivity(transmissivity, cosine, index=1.52):
    """A pane absorbs (1-r)(1-t)/(1-rt) of either polarisation: r at a face, t in one passage."""
    inside = math.sqrt(1 - (1 - cosine * cosine) / index ** 2)
    passage = transmissivity ** (1 / inside)
    faces = (((cosine - index * inside) / (cosine + index * inside)) ** 2,
             ((index * cosine - inside) / (index * cosine + inside)) ** 2)
    return sum((1 - r) * (1 - passage) / (1 - r * passage) for r in faces) / 2


def table_emissivity(table, cosine):
    """1 less the integral over all incident directions, exact for the table's linear interpolation in azimuth."""
    count = 2 * (table.np - 1) if table.half else table.np
    azimuths = [2 * math.pi * k / count for k in range(count)]
    total = 0.0
    for theta, weight in nodes(steps(0, math.pi / 2, table.ni - 1), 4):
        ring = sum(table.eval(theta, phi, math.acos(cosine)) for phi in azimuths) * 2 * math.pi / count
        total += weight * ring * math.cos(theta) * math.sin(theta)
    return 1 - total
