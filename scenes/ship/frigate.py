"""The shape of the ship: a frigate of our own invention, 120 m long, bow along x, waterline at z = 0, in metres.

frigate(size) gives (part, facets) pairs; make_frigate.py says what each part is made of and how warm it is inside.
"""
import math

from solids import between, block, dome, drum, inset, octagon, panels, polygon, rectangle, roof, skin, tube, walls

STERN, BEAM = -60.0, 7.3                # x of the transom, half the beam
MAIN_DECK = 6.0                         # z amidships
FIRST, SECOND, BRIDGE = 9.0, 12.0, 15.2     # z of the roofs above it
KNUCKLE = 0.62                          # of the height of the hull's side
STACKS = (-10.6, -7.6)                  # x of the uptakes in the funnel


def deck_height(u):
    """Upper edge of the hull at u (0 stern .. 1 bow): level to amidships, then the sheer."""
    return MAIN_DECK + 3.4 * max(0.0, (u - 0.55) / 0.45) ** 2


def deck_breadth(u):
    return BEAM * (1 - 0.12 * max(0.0, 1 - u / 0.2) ** 2) * (1 - max(0.0, (u - 0.60) / 0.40) ** 2.3)


def water_breadth(u):
    return 6.7 * (1 - 0.22 * max(0.0, 1 - u / 0.3) ** 2) * (1 - max(0.0, (u - 0.42) / 0.58) ** 1.65)


def hull_point(u, v):
    """Starboard skin: v from -0.15 under water over 0 at the waterline to 1 at the deck. The stem is raked; the flare
    grows towards the bow, up to the knuckle above which the side stands straighter."""
    w = max(0.0, v)
    stem, transom = 50.0 + 10.0 * w ** 0.9, STERN + 0.8 * (1 - w)
    x = transom + u * (stem - transom)
    bend = 0.86 * (w / KNUCKLE) ** (1 + 0.8 * u) if w < KNUCKLE else 0.86 + 0.14 * (w - KNUCKLE) / (1 - KNUCKLE)
    return x, -(water_breadth(u) + (deck_breadth(u) - water_breadth(u)) * bend), v * deck_height(u)


def mirrored(point):
    return point[0], -point[1], point[2]


def strake(low, high, columns, rows):
    """Both sides between two heights v."""
    def starboard(a, b):
        return hull_point(a, low + (high - low) * b)

    return skin(starboard, columns, rows) + skin(lambda a, b: mirrored(starboard(1 - a, b)), columns, rows)


def hull(size):
    """The skin, cut at the boot topping and at the knuckle, the transom and the deck."""
    columns = round(120 / size)
    yield "waterline", strake(-0.15, 0.0, columns, 1)
    yield "waterline", strake(0.0, 0.12, columns, 1)
    yield "hull", strake(0.12, KNUCKLE, columns, max(1, round(5.4 / size)))
    yield "hull", strake(KNUCKLE, 1.0, columns, max(1, round(4.0 / size)))
    yield "hull", skin(stern_point, 6, 4)
    yield "deck", deck(columns)


def stern_point(a, b):
    """The transom, from port (a = 0) to starboard."""
    x, y, z = hull_point(0.0, -0.15 + 1.15 * b)
    return x, -y * (1 - 2 * a), z


def deck(columns):
    """Weather deck from side to side, sunk below the bulwark towards the bow."""
    def edge(i):
        u = min(i / columns, 0.99)
        x, y, z = hull_point(u, 1 - bulwark(u) / deck_height(u))
        return x, y + 0.02, z

    facets = []
    for i in range(columns):
        (x0, y0, z0), (x1, y1, z1) = edge(i), edge(i + 1)
        for s, t in ((1, 0.5), (0.5, 0), (0, -0.5), (-0.5, -1)):    # y0 and y1 are negative
            facets += polygon([(x0, y0 * s, z0), (x1, y1 * s, z1), (x1, y1 * t, z1), (x0, y0 * t, z0)])
    return facets


def bulwark(u):
    return 1.0 * min(1.0, max(0.0, (u - 0.80) / 0.08))


SIDE = deck_breadth(0.4)
# Plans of the houses and how far each of their walls leans inwards, degrees, against radar
HOUSE = rectangle(-32, 24, SIDE - 0.02, 4.5), [8, 14, 20, 14, 8, 0]
FORE_HOUSE = rectangle(0, 22.6, SIDE - 0.45, 4.2), [8, 14, 20, 14, 8, 12]
BRIDGE_HOUSE = rectangle(5.5, 20.6, SIDE - 1.1, 3.6), [8, 14, 18, 14, 8, 10]
HANGAR = rectangle(-32, -14, SIDE - 0.45), [8, 6, 8, 0]


def superstructure(size):
    """Deckhouse flush with the hull's side, bridge, hangar."""
    for (plan, leans), low, high in ((HOUSE, MAIN_DECK, FIRST), (FORE_HOUSE, FIRST, SECOND),
                                     (BRIDGE_HOUSE, SECOND, BRIDGE), (HANGAR, FIRST, SECOND + 0.4)):
        sides, top = walls(plan, low, high, leans, size)
        yield "house", sides
        yield "roof", roof(top, high, size)
    x, y, top = -32.06, 2.9, 11.2
    yield "door", panels((x, y, MAIN_DECK), (x, -y, MAIN_DECK), (x, -y, top), (x, y, top), size)
    yield from openings()


def plates(plan, leans, z, edge, low, high, spans):
    """Plates 3 cm before one wall over `plan`, whose foot is at z: from `low` to `high` above it, over each span of the
    wall's length (shares, from its first corner)."""
    def wall(height):
        ring = inset(plan, [height * math.tan(math.radians(lean)) - 0.03 for lean in leans])
        return (*ring[edge], z + height), (*ring[(edge + 1) % len(ring)], z + height)

    (a, b), (d, c) = wall(low), wall(high)
    return [facet for s, t in spans
            for facet in polygon([between(a, b, s), between(a, b, t), between(d, c, t), between(d, c, s)])]


def row(count, start=0.0, end=1.0, gap=0.24):
    """Spans of equal panes with gaps between."""
    step = (end - start) / count
    return [(start + (k + gap / 2) * step, start + (k + 1 - gap / 2) * step) for k in range(count)]


def reverse(spans):
    """For the other side of the ship, whose walls run the other way."""
    return [(1 - t, 1 - s) for s, t in spans]


def openings():
    """Panes of the bridge, and doors and louvres in the sides of the houses."""
    plan, leans = BRIDGE_HOUSE
    for edge, spans in ((0, row(4, 0.55)), (1, row(4)), (2, row(6)), (3, row(4)), (4, row(4, 0.0, 0.45))):
        yield "window", plates(plan, leans, SECOND, edge, 1.35, 2.45, spans)
    for (plan, leans), z, edges, doors, louvres in (
            (HOUSE, MAIN_DECK, (0, 4), [(.30, .318), (.62, .638)], [(.40, .44), (.47, .51), (.755, .785)]),
            (FORE_HOUSE, FIRST, (0, 4), [(.16, .20)], [(.55, .62)]),
            (HANGAR, FIRST, (0, 2), [(.12, .165)], [(.72, .80), (.84, .92)])):
        for edge in edges:
            yield "door", plates(plan, leans, z, edge, 0.35, 2.35, doors if edge == 0 else reverse(doors))
            yield "louvre", plates(plan, leans, z, edge, 0.9, 2.1, louvres if edge == 0 else reverse(louvres))


def funnel(size):
    """A raked casing on its own deckhouse, a hot rim, and two uptakes that stand out of it."""
    base = rectangle(-13.8, -2.5, 4.6)
    sides, top = walls(base, FIRST, SECOND, [6, 6, 6, 8], size)
    yield "casing", sides
    yield "roof", roof(top, SECOND, size)
    for edge in (0, 2):
        yield "hot_louvre", plates(base, [6, 6, 6, 8], FIRST, edge, 0.9, 2.3, [(.12, .26), (.32, .46), (.76, .90)])
    plan = [(-12.6, -2.1), (-11.6, -2.9), (-5.8, -2.9), (-4.0, -1.5),
            (-4.0, 1.5), (-5.8, 2.9), (-11.6, 2.9), (-12.6, 2.1)]
    leans = [4, 7, 12, 16, 12, 7, 4, 2]
    sides, top = walls(plan, SECOND, 17.2, leans, size / 2)
    yield "funnel", sides
    sides, rim = walls(top, 17.2, 18.3, leans, size / 2)
    yield "rim", sides
    yield "soot", roof(rim, 18.3, size)
    for x in STACKS:
        yield "uptake", drum(x, 0, 18.2, 19.4, 1.05, 0.95, 0.5)
        yield "exhaust", polygon([(x + math.cos(k * math.pi / 8), math.sin(k * math.pi / 8), 18.9) for k in range(16)])


def masts(size):
    """The enclosed main mast with its radar, yards and poles, and the after mast."""
    sides, top = walls(octagon(10.5, 0, 6.4, 5.2), BRIDGE, 22.5, 8, size)
    yield "mast", sides
    yield "mast", roof(top, 22.5, size)
    sides, top = walls(octagon(10.5, 0, 3.6, 3.6), 22.5, 24.2, -8, size)
    yield "radar", sides
    sides, top = walls(top, 24.2, 25.6, 20, size)
    yield "radar", sides + roof(top, 25.6, size)
    yield "pole", tube((10.5, 0, 25.6), (10.5, 0, 31.0), 0.22, 0.10)
    yield "pole", tube((10.5, -1.5, 28.0), (10.5, 1.5, 28.0), 0.10, 0.10)
    for z, reach in ((19.5, 5.2), (21.8, 4.2)):
        yield "pole", tube((9.6, -reach, z + 0.4), (9.6, reach, z + 0.4), 0.16, 0.16)
        for y in (-reach, reach):
            yield "pole", tube((9.6, y, z - 0.3), (9.6, y, z + 1.6), 0.14, 0.08)
    sides, top = walls(octagon(-16.6, 0, 3.6, 3.4), SECOND + 0.4, 18.6, 6, size)
    yield "mast", sides
    yield "mast", roof(top, 18.6, size)
    yield "radar", dome(-16.6, 0, 19.6, 1.25, 0.5)
    yield "pole", tube((-16.6, 0, 20.6), (-16.6, 0, 24.5), 0.12, 0.06)
    for x, y in ((-24, 4.6), (-24, -4.6), (2.2, 4.8), (2.2, -4.8)):
        yield "pole", tube((x, y, SECOND), (x - 0.6, y * 1.08, SECOND + 8.5), 0.07, 0.03)


def fittings(size):
    """Gun, vertical launchers, directors, domes, canisters, boats, staffs."""
    level = deck_height(0.86) - bulwark(0.86) - 0.15
    turret = [(37.2, -1.5), (40.6, -1.5), (42.4, -0.55), (42.4, 0.55), (40.6, 1.5), (37.2, 1.5)]
    yield "gun", drum(39.6, 0, level - 0.4, level + 0.5, 1.9, 1.8, 0.7)
    sides, top = walls(turret, level + 0.45, level + 2.7, [12, 22, 30, 22, 12, 14], 1.0)
    yield "gun", sides + roof(top, level + 2.7, 1.0)
    yield "gun", tube((41.2, 0, level + 1.5), (46.8, 0, level + 2.3), 0.17, 0.13)
    cells = rectangle(27.2, 33.6, 2.9)
    sides, top = block(cells, MAIN_DECK - 0.3, MAIN_DECK + 1.55, 4, size)
    yield "house", sides
    yield "roof", top
    sides, top = block([(34.6, -3.8), (35.1, -3.8), (36.4, 0), (35.1, 3.8), (34.6, 3.8)], 6.2, 8.3, 3, size)
    yield "house", sides + top

    yield "mast", drum(17.2, 0, BRIDGE, BRIDGE + 1.3, 0.8, 0.7, 0.5)
    yield "radar", dome(17.2, 0, BRIDGE + 2.2, 1.15, 0.45)
    for y in (-4.3, 4.3):
        yield "mast", drum(2.6, y, SECOND, SECOND + 1.0, 0.6, 0.5, 0.5)
        yield "radar", dome(2.6, y, SECOND + 1.95, 1.2, 0.45)
    yield "mast", drum(-27.0, 0, SECOND + 0.4, SECOND + 1.8, 1.1, 0.9, 0.5)
    yield "gun", drum(-27.0, 0, SECOND + 1.8, SECOND + 3.6, 0.75, 0.75, 0.5)
    yield "radar", dome(-27.0, 0, SECOND + 3.6, 0.75, 0.4, 0)
    yield "gun", tube((-27.5, 0, SECOND + 2.3), (-29.6, 0, SECOND + 2.6), 0.16, 0.12)

    for k, x in enumerate((-1.9, -1.0)):
        for y in (-0.5, 0.5):
            side = 1 if k else -1
            yield "canister", tube((x, y - 2.2 * side, FIRST + 0.8), (x, y + 2.2 * side, FIRST + 2.6), 0.38, 0.38)
    for y in (-1, 1):
        yield "boat", boat(-0.2, y * 6.25)
    yield "pole", tube((-59.0, 0, MAIN_DECK - 0.1), (-59.6, 0, MAIN_DECK + 4.0), 0.07, 0.04)
    yield "pole", tube((59.0, 0, 8.2), (59.6, 0, 11.6), 0.07, 0.04)


def boat(x, y):
    """A boat in its cradle: the ship's own lines at a sixteenth, decked over."""
    def node(a, b):
        px, py, pz = hull_point(a if b <= 0.5 else 1 - a, -0.15 + 1.15 * min(2 * b, 2 - 2 * b))
        return x + px / 16, y + (py if b <= 0.5 else -py) / 7.5, FIRST + 0.9 + pz / 4.5
    return skin(node, 14, 8)


def frigate(size):
    """All parts, in plates of about `size` metres."""
    for group in (hull, superstructure, funnel, masts, fittings):
        yield from group(size)
