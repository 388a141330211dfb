"""Shapes that the hero is made of: facets with a colour, each corner bound to one to three bones.

Everything is in figure axes (hero_rig). A `Shape` only collects; `hero_mesh` says what is built from it.
"""

from math import cos, pi, sin

from mathutils import Matrix, Vector

# How much lighter or darker a facet is than its paint at most.
VARIETY = 0.07
# A corner follows at most so many bones.
MOST_BONES = 3


def linear(hex_colour):
    """Linear red, green, blue of a colour as in a style sheet."""
    shares = [(hex_colour >> shift & 255) / 255 for shift in (16, 8, 0)]
    return tuple(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in shares)


class Paint:
    """A colour; `glow` for what shines by itself."""

    def __init__(self, hex_colour, glow=False, variety=VARIETY):
        self.colour, self.glow, self.variety = linear(hex_colour), glow, variety

    def on(self, number):
        """The colour of the facet with a number: a little lighter or darker."""
        noise = (number * 0.61803398875) % 1.0 * 2.0 - 1.0
        return tuple(min(1.0, c * (1.0 + self.variety * noise)) for c in self.colour)


class Shape:
    """Corners with weights, and facets between them."""

    def __init__(self):
        self.corners, self.weights, self.facets = [], [], []

    def corner(self, point, weights):
        """Adds a corner; weights are a bone's name or {bone: share}."""
        if isinstance(weights, str):
            weights = {weights: 1.0}
        strongest = sorted(weights.items(), key=lambda item: (-item[1], item[0]))[:MOST_BONES]
        strongest = [(bone, share) for bone, share in strongest if share > 0.01]
        total = sum(share for _, share in strongest)
        self.corners.append(Vector(point))
        self.weights.append({bone: share / total for bone, share in strongest})
        return len(self.corners) - 1

    def facet(self, corners, paint):
        """Adds a facet, its corners anticlockwise as seen from outside; repeated corners are dropped."""
        kept = [c for i, c in enumerate(corners) if c not in corners[:i]]
        if len(kept) >= 3:
            self.facets.append((tuple(kept), paint.on(len(self.facets)), paint.glow))

    def triangles(self):
        """How many triangles the facets make."""
        return sum(len(corners) - 2 for corners, _, _ in self.facets)

    def ring(self, points, weights):
        """A ring of corners."""
        return [self.corner(point, weights) for point in points]

    def skin(self, rings, paint, closed=True):
        """Quads between rings of equal length; `paint` may be a list with one paint for each band."""
        for band, (low, high) in enumerate(zip(rings, rings[1:])):
            count = len(low)
            for i in range(count if closed else count - 1):
                j = (i + 1) % count
                self.quad(low[i], low[j], high[j], high[i], paint[band] if isinstance(paint, list) else paint)

    def quad(self, a, b, c, d, paint):
        """A quad, cut along its shorter diagonal where it is not flat."""
        points = [self.corners[i] for i in (a, b, c, d)]
        normal = (points[1] - points[0]).cross(points[2] - points[0])
        if len({a, b, c, d}) < 4 or abs(normal.dot(points[3] - points[0])) <= 1e-4 * normal.length:
            self.facet((a, b, c, d), paint)
        elif (points[0] - points[2]).length <= (points[1] - points[3]).length:
            self.facet((a, b, c), paint)
            self.facet((a, c, d), paint)
        else:
            self.facet((a, b, d), paint)
            self.facet((b, c, d), paint)

    def cap(self, ring, paint, point=None, weights=None):
        """Closes a ring that runs anticlockwise as seen from outside: flat, or as a fan to a point."""
        if point is None:
            self.facet(ring, paint)
            return
        tip = self.corner(point, weights if weights else self.weights[ring[0]])
        for i, corner in enumerate(ring):
            self.facet((corner, ring[(i + 1) % len(ring)], tip), paint)

    def add(self, other, mirrored=False):
        """Adds another shape; mirrored: on the other side of the figure, its bones exchanged too."""
        base = len(self.corners)
        for point, weights in zip(other.corners, other.weights):
            if mirrored:
                point = Vector((point.x, point.y, -point.z))
                weights = {other_side(bone): share for bone, share in weights.items()}
            self.corners.append(point)
            self.weights.append(weights)
        for corners, colour, glow in other.facets:
            corners = tuple(base + c for c in (reversed(corners) if mirrored else corners))
            self.facets.append((corners, colour, glow))

    def moved(self, matrix):
        """Moves all corners."""
        self.corners = [matrix @ point for point in self.corners]
        return self


def other_side(bone):
    """The bone of the other side."""
    ends = {".l": ".r", ".r": ".l"}
    return bone[:-2] + ends[bone[-2:]] if bone[-2:] in ends else bone


def oval(centre, forward, aside, count, start=0.0, power=2.0, axes=None):
    """A ring about the vertical, anticlockwise seen from above: half lengths forward and aside (one number, or front and
    back, right and left), rounder or squarer by the power (2 is an ellipse)."""
    fore, back = forward if isinstance(forward, tuple) else (forward, forward)
    right, left = aside if isinstance(aside, tuple) else (aside, aside)
    x, y, z = axes if axes else (Vector((1, 0, 0)), Vector((0, 1, 0)), Vector((0, 0, 1)))
    points = []
    for i in range(count):
        angle = 2.0 * pi * (i + start) / count
        c, s = cos(angle), -sin(angle)
        c, s = (abs(v) ** (2.0 / power) * (1 if v >= 0 else -1) for v in (c, s))
        points.append(Vector(centre) + x * c * (fore if c > 0 else back) + z * s * (right if s > 0 else left))
    return points


def axes_along(start, end, forward=(1, 0, 0)):
    """Axes whose y runs from start to end and whose x is as far forward as it can be."""
    y = (Vector(end) - Vector(start)).normalized()
    x = Vector(forward)
    x = (x - y * x.dot(y)).normalized()
    return x, y, x.cross(y)


def limb(shape, start, end, profile, count, paint, weights, forward=(1, 0, 0), start_angle=0.5, power=2.0, caps=(True, True)):
    """A tube from start to end. Profile: (share of the way, half length forward, half length aside, shift forward).
    `weights` is one binding, or a function of the share of the way."""
    axes = axes_along(start, end, forward)
    rings = []
    for share, fore, aside, shift in profile:
        centre = Vector(start).lerp(Vector(end), share) + axes[0] * shift
        bound = weights(share) if callable(weights) else weights
        rings.append(shape.ring(oval(centre, fore, aside, count, start_angle, power, axes), bound))
    shape.skin(rings, paint)
    first, last = (paint[0], paint[-1]) if isinstance(paint, list) else (paint, paint)
    if caps[0]:
        shape.cap(rings[0][::-1], first)
    if caps[1]:
        shape.cap(rings[-1], last)
    return rings


def stops(*pairs):
    """Weights that change along a number: (value, bone) pairs; between two the shares go over from one to the other."""
    def bound(value):
        if value <= pairs[0][0]:
            return {pairs[0][1]: 1.0}
        for (low, a), (high, b) in zip(pairs, pairs[1:]):
            if value <= high:
                share = (value - low) / (high - low)
                return {a: 1.0} if a == b else {a: 1.0 - share, b: share}
        return {pairs[-1][1]: 1.0}
    return bound


def chain(shape, joints, profile, count, paint, bones, softness=0.22, forward=(1, 0, 0), power=2.0, start_angle=0.5):
    """A tube along two bones, its skin bending softly where they meet. Profile as for `limb`, the way from 0 to 2."""
    first, middle, last = (Vector(j) for j in joints)
    bound = stops((1.0 - softness, bones[0]), (1.0 + softness, bones[1]))
    rings = []
    for way, fore, aside, shift in profile:
        upper, lower = axes_along(first, middle, forward), axes_along(middle, last, forward)
        turned = max(0.0, min(1.0, (way - 1.0 + softness) / (2 * softness)))
        axes = axes_along(first, first + upper[1].lerp(lower[1], turned), forward)
        at = first.lerp(middle, way) if way <= 1.0 else middle.lerp(last, way - 1.0)
        points = oval(at + axes[0] * shift, fore, aside, count, start_angle, power, axes)
        rings.append(shape.ring(points, bound(way)))
    shape.skin(rings, paint)
    return rings


def plate(shape, surface, rows, columns, bind, paint, rim=None, thickness=0.014, inset=0.008, back=None):
    """A bent plate with bevelled edges. `surface(u, v)` is a point for u, v in 0..1, its outside where u x v points;
    `bind` the bone or bones, or a function of the point; `rim` the paint of the edge, `back` that of the inside if it shows."""
    rim = rim or paint
    tiny = 1e-3

    def normal(u, v):
        u, v = min(max(u, tiny), 1 - tiny), min(max(v, tiny), 1 - tiny)
        across = surface(u + tiny, v) - surface(u - tiny, v)
        down = surface(u, v + tiny) - surface(u, v - tiny)
        return across.cross(down).normalized()

    width = max((surface(1, 0.5) - surface(0.5, 0.5)).length + (surface(0.5, 0.5) - surface(0, 0.5)).length, 1e-4)
    height = max((surface(0.5, 1) - surface(0.5, 0.5)).length + (surface(0.5, 0.5) - surface(0.5, 0)).length, 1e-4)
    du, dv = min(0.3, inset / width), min(0.3, inset / height)

    def corner(u, v, depth, pull):
        u, v = du * pull + u * (1 - 2 * du * pull), dv * pull + v * (1 - 2 * dv * pull)
        point = surface(u, v) - normal(u, v) * depth
        return shape.corner(point, bind(point) if callable(bind) else bind)

    def grid(depth, pull):
        return [[corner(c / columns, r / rows, depth, pull) for c in range(columns + 1)] for r in range(rows + 1)]

    def border(cells):
        top, bottom = cells[0], cells[-1][::-1]
        right, left = [row[-1] for row in cells[1:-1]], [row[0] for row in cells[1:-1]][::-1]
        return top + right + bottom + left

    def edge(depth, pull):
        ways = border([[(c / columns, r / rows) for c in range(columns + 1)] for r in range(rows + 1)])
        return [corner(u, v, depth, pull) for u, v in ways]

    face = grid(0.0, 1.0)
    for upper, lower in zip(face, face[1:]):
        for c in range(columns):
            shape.quad(upper[c], upper[c + 1], lower[c + 1], lower[c], paint)
    outer, brim = border(face), edge(thickness, 0.0)
    shape.skin([brim, outer], rim)
    if back:
        inside = grid(thickness * 1.2, 0.5)
        shape.skin([border(inside), brim], back)
        for upper, lower in zip(inside, inside[1:]):
            for c in range(columns):
                shape.quad(upper[c + 1], upper[c], lower[c], lower[c + 1], back)


def block(shape, centre, half, paint, bind, top=0.8, axes=None, base=1.0):
    """A box with a bevelled top, narrower there; its foot is hidden."""
    x, y, z = axes if axes else (Vector((1, 0, 0)), Vector((0, 1, 0)), Vector((0, 0, 1)))
    rings = []
    for level, size in ((-1.0, base), (0.45, (1 + top) / 2), (1.0, top * 0.78)):
        outline = [(half[0], -half[2]), (-half[0], -half[2]), (-half[0], half[2]), (half[0], half[2])]
        points = [Vector(centre) + x * a * size + y * (level * half[1]) + z * b * size for a, b in outline]
        rings.append(shape.ring(points, bind))
    shape.skin(rings, paint)
    shape.cap(rings[0][::-1], paint)
    shape.cap(rings[-1], paint)


def loft(shape, rings, paint, bind, caps=(True, True)):
    """Skin over rings of points (anticlockwise as seen from the last); `bind` as for `plate`."""
    made = [[shape.corner(p, bind(p) if callable(bind) else bind) for p in ring] for ring in rings]
    shape.skin(made, paint)
    first, last = (paint[0], paint[-1]) if isinstance(paint, list) else (paint, paint)
    if caps[0]:
        shape.cap(made[0][::-1], first)
    if caps[1]:
        shape.cap(made[-1], last)
    return made


def rotation(axis, degrees, about=(0, 0, 0)):
    """A rotation about a point."""
    centre = Vector(about)
    return Matrix.Translation(centre) @ Matrix.Rotation(degrees * pi / 180, 4, Vector(axis)) @ Matrix.Translation(-centre)
