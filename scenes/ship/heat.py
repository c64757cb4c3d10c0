"""How warm each facet is: a steady balance of sun, sky, sea, wind and what is behind the plate.

    a (E n.s + E_sky F) + e s (F Tsky^4 + (1 - F) Tsea^4) + h (Tair - T) + U (Tinside - T) = e s T^4

with a the solar absorptance, e the emissivity, s Stefan and Boltzmann's constant, F = (1 + nz)/2 the share of sky that
the facet sees (the rest is sea), h the wind's heat transfer and U that of insulation and inside air. n.s is the cosine
of the sun's incidence, nothing where the ship shades itself.
"""
import math
from collections import namedtuple

from solids import cross, dot, minus, unit
from weather import direction

STEFAN_BOLTZMANN = 5.670374419e-8       # W·m⁻²·K⁻⁴

# absorptance of sunlight; emissivity, all thermal wavelengths; inside K; transfer W·m⁻²·K⁻¹ from inside
Skin = namedtuple("Skin", "absorptance emissivity inside transfer")


def equilibrium(skin, weather, facing_sky, sun_cosine):
    """Temperature at which the balance holds, by Newton's method; the loss rises and bends upwards with T."""
    gain = (skin.absorptance * (weather.direct * sun_cosine + weather.diffuse * facing_sky)
            + skin.emissivity * STEFAN_BOLTZMANN * (facing_sky * weather.sky ** 4 + (1 - facing_sky) * weather.sea ** 4)
            + weather.wind_transfer * weather.air + skin.transfer * skin.inside)
    t = 300.0
    for _ in range(20):
        radiated = skin.emissivity * STEFAN_BOLTZMANN * t ** 4
        loss = radiated + (weather.wind_transfer + skin.transfer) * t
        t -= (loss - gain) / (4 * radiated / t + weather.wind_transfer + skin.transfer)
    return t


class Shadows:
    """Which points of the ship the sun reaches: every facet's outline, projected along the sun's rays, is kept in the
    cells of a square grid that it may cover."""

    CELL = 1.5                          # metres
    LIFT = 0.05                         # metres off a facet where its shadow is looked for: before its own plates
    CLEARANCE = 0.10                    # metres towards the sun in which nothing casts a shadow

    def __init__(self, facets, sun):
        self.sun = sun
        self.across = unit(cross(sun, (0, 0, 1)))
        self.up = cross(self.across, sun)
        self.cells = {}
        for facet in facets:
            outline = convex_hull([self.flat(p) for p in facet.points])
            if len(outline) < 3:
                continue
            plane = (facet.normal, facet.centre)
            (x0, y0), (x1, y1) = self.cell(*map(min, zip(*outline))), self.cell(*map(max, zip(*outline)))
            for i in range(x0, x1 + 1):
                for j in range(y0, y1 + 1):
                    self.cells.setdefault((i, j), []).append((outline, plane))

    def flat(self, point):
        return dot(point, self.across), dot(point, self.up)

    def cell(self, x, y):
        return math.floor(x / self.CELL), math.floor(y / self.CELL)

    def distance(self, plane, point):
        """Along the sun's ray from the point to the plane; a round shape counts as its middle."""
        normal, through = plane
        if normal is None:
            return dot(minus(through, point), self.sun)
        slope = dot(normal, self.sun)
        return dot(normal, minus(through, point)) / slope if abs(slope) > 1e-6 else 0.0

    def shaded(self, point):
        flat = self.flat(point)
        return any(inside(outline, flat) and self.distance(plane, point) > self.CLEARANCE
                   for outline, plane in self.cells.get(self.cell(*flat), ()))


def inside(outline, p):
    return all((b[0] - a[0]) * (p[1] - a[1]) >= (b[1] - a[1]) * (p[0] - a[0])
               for a, b in zip(outline, outline[1:] + outline[:1]))


def convex_hull(points):
    """Counterclockwise, by Andrew's monotone chain."""
    def chain(ordered):
        kept = []
        for p in ordered:
            while len(kept) > 1 and ((kept[-1][0] - kept[-2][0]) * (p[1] - kept[-2][1])
                                     <= (kept[-1][1] - kept[-2][1]) * (p[0] - kept[-2][0])):
                kept.pop()
            kept.append(p)
        return kept[:-1]

    ordered = sorted(set(points))
    return chain(ordered) + chain(ordered[::-1])


def sun_cosine(facet, shadows):
    """Mean over a facet of the cosine of incidence where the sun reaches it, asked near its corners. A pole is warm all
    around: 1/pi of what falls on it broadside."""
    if facet.normal is None:
        axis = unit(minus(facet.numbers[3:6], facet.numbers[0:3]))
        return 0.0 if shadows.shaded(facet.centre) else math.sqrt(1 - dot(axis, shadows.sun) ** 2) / math.pi
    cosine = dot(facet.normal, shadows.sun)
    if cosine <= 0:
        return 0.0
    lift = [shadows.LIFT * x for x in facet.normal]
    probes = [tuple(0.3 * c + 0.7 * x + h for c, x, h in zip(facet.centre, p, lift)) for p in facet.points]
    return cosine * sum(not shadows.shaded(p) for p in probes) / len(probes)


def temperatures(parts, skin_of, weather):
    """The temperature of each facet of [(part, facets)], in order; skin_of(part, facet) says what it is made of."""
    shadows = Shadows([facet for _, facets in parts for facet in facets],
                      direction(weather.sun_elevation, weather.sun_bearing))
    result = []
    for part, facets in parts:
        for facet in facets:
            facing_sky = 0.5 if facet.normal is None else (1 + facet.normal[2]) / 2
            result.append(equilibrium(skin_of(part, facet), weather, facing_sky, sun_cosine(facet, shadows)))
    return result
