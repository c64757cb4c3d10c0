"""Plane facets, and the few solids a ship is put together from. Metres, z up; corners run counterclockwise seen from
outside. A facet is a polygon or a cone of a scene file together with what heat.py needs to know of it."""
import math


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


class Facet:
    """shape: "polygon" or "cone"; numbers: its real arguments; points: corners, whose hull casts its shadow; normal:
    outward, None for a cone."""

    def __init__(self, shape, numbers, points, normal):
        self.shape, self.numbers, self.points, self.normal = shape, numbers, points, normal
        self.centre = tuple(sum(x) / len(points) for x in zip(*points))


def polygon(points):
    """A facet, or none where the corners have run together."""
    corners = [p for i, p in enumerate(points) if math.dist(p, points[i - 1]) > 1e-6]
    if len(corners) < 3:
        return []
    normal = (0.0, 0.0, 0.0)
    for i in range(1, len(corners) - 1):
        turn = cross(minus(corners[i], corners[0]), minus(corners[i + 1], corners[0]))
        normal = tuple(x + y for x, y in zip(normal, turn))
    return [Facet("polygon", [x for p in corners for x in p], corners, unit(normal))] if any(normal) else []


def between(p, q, t):
    return tuple(a + t * (b - a) for a, b in zip(p, q))


def panels(a, b, c, d, size):
    """The plane quadrilateral abcd in plates of about `size`."""
    columns = max(1, round(max(math.dist(a, b), math.dist(d, c)) / size))
    rows = max(1, round(max(math.dist(a, d), math.dist(b, c)) / size))

    def node(i, j):
        return between(between(a, b, i / columns), between(d, c, i / columns), j / rows)

    return [facet for i in range(columns) for j in range(rows)
            for facet in polygon([node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)])]


def skin(node, columns, rows):
    """Two triangles a cell of the curved surface node(u, v), u and v in 0..1, the outside along du x dv. Both have the
    cell's normal and middle, so that they are equally warm."""
    facets = []
    for i in range(columns):
        for j in range(rows):
            a, b = node(i / columns, j / rows), node((i + 1) / columns, j / rows)
            c, d = node((i + 1) / columns, (j + 1) / rows), node(i / columns, (j + 1) / rows)
            cell = polygon([a, b, c]) + polygon([a, c, d])
            turn = cross(minus(c, a), minus(d, b))
            for facet in cell:
                facet.normal, facet.centre = unit(turn), between(between(a, c, 0.5), between(b, d, 0.5), 0.5)
            facets += cell
    return facets


def inset(plan, depth):
    """The convex plan (x, y, counterclockwise) with each edge moved inwards by its own depth."""
    def edge(i):
        (x0, y0), (x1, y1) = plan[i], plan[(i + 1) % len(plan)]
        length = math.hypot(x1 - x0, y1 - y0)
        return (x0 - depth[i] * (y1 - y0) / length, y0 + depth[i] * (x1 - x0) / length), (x1 - x0, y1 - y0)

    corners = []
    for i in range(len(plan)):
        (p, r), (q, s) = edge(i - 1), edge(i)
        t = ((q[0] - p[0]) * s[1] - (q[1] - p[1]) * s[0]) / (r[0] * s[1] - r[1] * s[0])
        corners.append((p[0] + t * r[0], p[1] + t * r[1]))
    return corners


def walls(plan, z0, z1, lean, size):
    """The walls over a plan from z0 to z1, leaning inwards by `lean` degrees, one angle or one for each edge; and the
    plan of the roof. Parallel edges keep every wall plane."""
    leans = [lean] * len(plan) if isinstance(lean, (int, float)) else lean
    top = inset(plan, [(z1 - z0) * math.tan(math.radians(angle)) for angle in leans])
    facets = []
    for i in range(len(plan)):
        j = (i + 1) % len(plan)
        facets += panels((*plan[i], z0), (*plan[j], z0), (*top[j], z1), (*top[i], z1), size)
    return facets, top


def roof(plan, z, size):
    """A flat roof in strips along x, cut where an edge has a corner so that each strip is a trapezoid."""
    xs = sorted({round(x, 6) for x, _ in plan})

    def ends(x):
        ys = []
        for i, (x0, y0) in enumerate(plan):
            x1, y1 = plan[(i + 1) % len(plan)]
            if min(x0, x1) - 1e-6 <= x <= max(x0, x1) + 1e-6:
                ys += [y0, y1] if abs(x1 - x0) < 1e-6 else [y0 + (y1 - y0) * (x - x0) / (x1 - x0)]
        return min(ys), max(ys)

    facets = []
    for left, right in zip(xs, xs[1:]):
        (a, d), (b, c) = ends(left), ends(right)
        facets += panels((left, a, z), (right, b, z), (right, c, z), (left, d, z), size)
    return facets


def block(plan, z0, z1, lean, size):
    """Walls and roof."""
    facets, top = walls(plan, z0, z1, lean, size)
    return facets, roof(top, z1, size)


def rectangle(x0, x1, y, chamfer=0.0):
    """x0..x1 by -y..y, the forward corners cut by `chamfer`."""
    if not chamfer:
        return [(x0, -y), (x1, -y), (x1, y), (x0, y)]
    return [(x0, -y), (x1 - chamfer, -y), (x1, chamfer - y), (x1, y - chamfer), (x1 - chamfer, y), (x0, y)]


def octagon(x, y, length, width):
    """Centred at x, y, its corners cut by three tenths of the lesser side."""
    a, b, cut = length / 2, width / 2, 0.3 * min(length, width)
    corners = [(a - cut, -b), (a, cut - b), (a, b - cut), (a - cut, b),
               (cut - a, b), (-a, b - cut), (-a, cut - b), (cut - a, -b)]
    return [(x + p, y + q) for p, q in corners]


def tube(p, q, r0, r1):
    """A cone or cylinder from p to q; its shadow is that of a square prism."""
    axis = unit(minus(q, p))
    side = unit(cross(axis, (1, 0, 0) if abs(axis[0]) < 0.9 else (0, 1, 0)))
    other = cross(axis, side)
    points = [tuple(c + r * (s * a + t * b) for c, a, b in zip(centre, side, other))
              for centre, r in ((p, r0), (q, r1)) for s, t in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    return [Facet("cone", [*p, *q, r0, r1], points, None)]


def drum(x, y, z0, z1, r0, r1, size):
    """The wall of a cone around a vertical axis, in plates."""
    count = max(8, round(2 * math.pi * max(r0, r1) / size))

    def node(u, v):
        angle, r = 2 * math.pi * u, r0 + (r1 - r0) * v
        return x + r * math.cos(angle), y + r * math.sin(angle), z0 + (z1 - z0) * v

    return skin(node, count, max(1, round((z1 - z0) / size)))


def dome(x, y, z, radius, size, lowest=-60):
    """A ball in plates from the latitude `lowest` degrees upwards."""
    def node(u, v):
        angle, latitude = 2 * math.pi * u, math.radians(lowest + (90 - lowest) * v)
        r = radius * math.cos(latitude) if v < 1 else 0.0
        return x + r * math.cos(angle), y + r * math.sin(angle), z + radius * math.sin(latitude)

    count = max(8, round(2 * math.pi * radius / size))
    return skin(node, count, max(3, count // 3))
