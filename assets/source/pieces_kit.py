"""What the set pieces are built with: convex solids cut by planes, sheets, tubes, and a bake of colours and occlusion.

Coordinates are the game's: x to the right, y up, z towards the camera, in metres. Colours are written as they appear on
the screen (sRGB) and baked into linear light, with the share of the sky that each corner sees beside them.
"""

import math
import random
import zlib
from dataclasses import dataclass, replace

import numpy as np

EPSILON = 1e-5  # points closer than this are one, in metres
RAYS = 56  # for the occlusion of one corner
SHORT = 5.0  # edges shorter than this many widths of their bevel stay sharp
APART = 0.0015  # between the two sides of a sheet, in metres
HIDDEN = 0.12  # facets with less of the sky at all corners are never seen


def vec(*xyz):
    return np.array(xyz, dtype=float)


def dot(a, b):
    """The scalar product, added up in a fixed order: NumPy's own takes a kernel that fits the processor, and the last digit with it."""
    return float(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


def times(a, b):
    """A matrix of three columns times a vector or a matrix, for the same reason."""
    return np.multiply.outer(a[:, 0], b[0]) + np.multiply.outer(a[:, 1], b[1]) + np.multiply.outer(a[:, 2], b[2])


def norm(v):
    return math.sqrt(dot(v, v))


def unit(v):
    length = norm(v)
    return v / length if length > 1e-12 else v * 0.0


# ---- Paint ------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Paint:
    """What a surface looks like."""

    colour: int  # 0xRRGGBB
    variety: float = 0.07  # how much facets differ from each other in brightness and hue
    top: int = -1  # the colour of what looks up, if another
    moss: float = 0.75  # how much of it
    worn: float = 0.16  # how much lighter bevels and chips are
    glow: bool = False  # shines by itself

    def shifted(self, factor):
        """The same, lighter or darker."""
        channels = [min(255, int(((self.colour >> s) & 255) * factor)) for s in (16, 8, 0)]
        return replace(self, colour=channels[0] << 16 | channels[1] << 8 | channels[2])


MOSS, DUST = 0x7A8A5E, 0xB9AE98
STONE = Paint(0x8A8790, 0.085, MOSS)
PALE = Paint(0xB3A898, 0.075, 0x9A9C76, 0.6)
DARK = Paint(0x5F6170, 0.09, MOSS, 0.6)
WOOD = Paint(0x745840, 0.13, 0x947656, 0.5, 0.22)
OLD_WOOD = Paint(0x6E5D50, 0.12, 0x8C7C68, 0.5, 0.2)
IRON = Paint(0x474A54, 0.09, 0x6A6A70, 0.4, 0.30)
RUST = Paint(0x6C5048, 0.15, 0x846A5A, 0.4, 0.25)
BRASS = Paint(0xB08A4A, 0.10, 0xCFAE6A, 0.4, 0.25)
ROPE = Paint(0xA58A5E, 0.12)
FLAME = Paint(0xFFCB68, 0.05, glow=True)
GLASS = Paint(0x3E4A50, 0.10)
MAGIC = Paint(0x6FEBDC, 0.08, glow=True)
HOT = Paint(0xFF4E1E, 0.10, glow=True)
WARM_WINDOW = Paint(0x8F6032, 0.10, glow=True)


def linear(colour):
    channels = [(colour >> s & 255) / 255 for s in (16, 8, 0)]
    return vec(*(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels))


# ---- Placing ----------------------------------------------------------------------------------------------------------


def turned(x=0.0, y=0.0, z=0.0):
    """The rotation by these degrees about x, then y, then z."""
    a, b, c = (math.radians(d) for d in (x, y, z))
    rx = np.array([[1, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]])
    ry = np.array([[math.cos(b), 0, math.sin(b)], [0, 1, 0], [-math.sin(b), 0, math.cos(b)]])
    rz = np.array([[math.cos(c), -math.sin(c), 0], [math.sin(c), math.cos(c), 0], [0, 0, 1]])
    return times(times(rz, ry), rx)


def frame_along(direction):
    """Two unit vectors across a direction."""
    d = unit(direction)
    side = unit(np.cross(vec(0, 0, 1) if abs(d[2]) < 0.8 else vec(1, 0, 0), d))
    return side, np.cross(d, side)


# ---- Convex solids ----------------------------------------------------------------------------------------------------


class Solid:
    """A convex solid: polygons counter-clockwise seen from outside, each with a tag: "face" or "worn" (a bevel, a chip)."""

    def __init__(self, faces):
        self.faces = faces

    def centre(self):
        return np.mean([p for face, _ in self.faces for p in face], axis=0)

    def cut(self, normal, distance, tag="worn"):
        """Without what lies beyond the plane normal . p = distance."""
        normal, kept, rim = unit(normal), [], []
        for face, mark in self.faces:
            heights = [dot(normal, p) - distance for p in face]
            if all(h <= EPSILON for h in heights):
                kept.append((face, mark))
                continue
            points = []
            for i, p in enumerate(face):
                q, hp, hq = face[(i + 1) % len(face)], heights[i], heights[(i + 1) % len(face)]
                if hp <= EPSILON:
                    points.append(p)
                if (hp < -EPSILON and hq > EPSILON) or (hp > EPSILON and hq < -EPSILON):
                    points.append(p + (q - p) * (hp / (hp - hq)))
            points = distinct(points)
            if len(points) >= 3:
                kept.append((points, mark))
            rim += [p for p in points if abs(dot(normal, p) - distance) < 10 * EPSILON]
        rim = distinct(rim)
        if len(rim) >= 3 and len(kept) < len(self.faces) + 1:
            kept.append((around(rim, normal), tag))
        return Solid(kept if len(kept) >= 4 else self.faces)

    def edges(self):
        """Each edge once: its ends, and the normals beside it."""
        found = {}
        for face, _ in self.faces:
            n = polygon_normal(face)
            for i, p in enumerate(face):
                q = face[(i + 1) % len(face)]
                key = tuple(sorted((tuple(np.round(p, 4)), tuple(np.round(q, 4)))))
                found.setdefault(key, []).append((p, q, n))
        return [(a[0], a[1], a[2], b[2]) for a, b in (v for v in found.values() if len(v) == 2)]

    def bevel(self, width, rng=None, uneven=0.5, sharp=40.0):
        """With its sharp edges cut off, more or less wide; those behind and below, which are hardly seen, stay sharp."""
        result = self
        for p, q, m, n in self.edges():
            if norm(q - p) < SHORT * width:
                continue
            seen = max(m[2], n[2], 0.8 * m[1], 0.8 * n[1])
            if dot(m, n) > math.cos(math.radians(sharp)) or seen < 0.35:
                continue
            amount = width * (1 + uneven * (rng.random() * 2 - 1) if rng else 1)
            normal = unit(m + n)
            result = result.cut(normal, dot(normal, p) - amount * math.sqrt(0.5))
        return result

    def chip(self, rng, count, depth):
        """With pieces broken off at some corners."""
        result = self
        for _ in range(count):
            centre = result.centre()
            corners = [p for face, _ in result.faces for p in face]
            corner = corners[rng.randrange(len(corners))]
            direction = unit(unit(corner - centre) + vec(*(rng.uniform(-0.5, 0.5) for _ in range(3))))
            reach = max(dot(direction, p) for p in corners)
            result = result.cut(direction, reach - depth * rng.uniform(0.4, 1.0))
        return result

    def moved(self, rotation=None, offset=(0, 0, 0)):
        rotation = np.eye(3) if rotation is None else rotation
        offset = vec(*offset)
        return Solid([([times(rotation, p) + offset for p in face], tag) for face, tag in self.faces])


def distinct(points):
    kept = []
    for p in points:
        if all(norm(p - q) > EPSILON * 5 for q in kept):
            kept.append(p)
    return kept


def around(points, normal):
    """Points of a convex polygon, counter-clockwise about its normal."""
    side, up = frame_along(normal)
    middle = np.mean(points, axis=0)
    return sorted(points, key=lambda p: math.atan2(dot((p - middle), up), dot((p - middle), side)))


def polygon_normal(face):
    total = np.zeros(3)
    for i, p in enumerate(face):
        total += np.cross(p, face[(i + 1) % len(face)])
    return unit(total)


def hull(points):
    """The convex hull of a few points."""
    points = [np.array(p, dtype=float) for p in points]
    planes = []
    for i in range(len(points)):
        for j in range(i + 1, len(points)):
            for k in range(j + 1, len(points)):
                n = unit(np.cross(points[j] - points[i], points[k] - points[i]))
                if not n.any():
                    continue
                heights = [dot(n, (p - points[i])) for p in points]
                if max(heights) > 1e-6 and min(heights) < -1e-6:
                    continue
                n = n if max(heights) <= 1e-6 else -n
                d = dot(n, points[i])
                if all(dot(n, m) < 0.99999 or abs(d - e) > 1e-5 for m, e in planes):
                    planes.append((n, d))
    faces = []
    for n, d in planes:
        on = distinct([p for p in points if abs(dot(n, p) - d) < 1e-5])
        faces.append((around(on, n), "face"))
    return Solid(faces)


def prism(outline, back, front):
    """A convex polygon of x and y between two depths."""
    return hull([(x, y, z) for x, y in outline for z in (back, front)])


def box(size, taper=1.0, lean=(0, 0)):
    """A box that stands on the origin; its top is smaller or larger, and may be moved aside in x and z."""
    w, h, d = size[0] / 2, size[1], size[2] / 2
    low = [(x * w, 0, z * d) for x in (-1, 1) for z in (-1, 1)]
    high = [(x * w * taper + lean[0], h, z * d * taper + lean[1]) for x in (-1, 1) for z in (-1, 1)]
    return hull(low + high)


def drum(low, high, height, sides, spin=0.0):
    """A cone frustum of flat sides that stands on the origin."""
    faces, rings = [], []
    for r, y in ((low, 0.0), (high, height)):
        angles = [2 * math.pi * (i + spin) / sides for i in range(sides)]
        rings.append([vec(r * math.cos(a), y, -r * math.sin(a)) for a in angles])
    for i in range(sides):
        j = (i + 1) % sides
        faces.append(([rings[0][i], rings[0][j], rings[1][j], rings[1][i]], "face"))
    faces.append((rings[1], "face"))
    faces.append((rings[0][::-1], "face"))
    return Solid(faces)


def boulder(rng, size, planes=16):
    """A rough stone about the origin: a box cut by planes from all around."""
    w, h, d = size
    solid = hull([(x * w, y * h, z * d) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    for i in range(planes):
        y = 1 - 2 * (i + 0.5) / planes
        a = i * 2.39996 + rng.uniform(-0.3, 0.3)
        r = math.sqrt(1 - y * y)
        n = vec(r * math.cos(a), y, r * math.sin(a))
        reach = math.sqrt((n[0] * w) ** 2 + (n[1] * h) ** 2 + (n[2] * d) ** 2)
        solid = solid.cut(n, reach * rng.uniform(0.82, 1.0), "face")
    return solid


# ---- Pieces -----------------------------------------------------------------------------------------------------------


class Piece:
    """A set piece under construction."""

    def __init__(self, name, sway=0.0, ground=True, wall=False, dirt=0.25):
        self.name, self.sway, self.ground, self.wall, self.dirt = name, sway, ground, wall, dirt
        self.rng = random.Random(zlib.crc32(name.encode()))
        self.faces = []  # corners, paint, tag
        self.lights = []  # place, reach, colour

    def poly(self, points, paint, tag="face", both=False):
        points = [np.array(p, dtype=float) for p in points]
        if not both:
            self.faces.append((points, paint, tag))
            return
        lift = polygon_normal(points) * APART
        self.faces.append(([p + lift for p in points], paint, tag))
        self.faces.append(([p - lift for p in points[::-1]], paint, tag))

    def solid(self, solid, paint, at=(0, 0, 0), turn=None, drop=None):
        """Adds a solid; `drop` is a direction whose faces nobody sees."""
        for face, tag in solid.moved(turn, at).faces:
            if drop is not None and dot(polygon_normal(face), vec(*drop)) > 0.98:
                continue
            self.poly(face, paint, tag)

    def block(self, at, size, paint, bevel=0.03, chips=0, turn=None, taper=1.0, lean=(0, 0), drop=None):
        """A box on its foot, worn and chipped."""
        solid = box(size, taper, lean)
        if bevel:
            solid = solid.bevel(bevel, self.rng)
        if chips:
            solid = solid.chip(self.rng, chips, min(size) * 0.35)
        self.solid(solid, paint, at, turn, drop)

    def beam(self, a, b, half, paint, bevel=0.0, depth=None, end=None):
        """A squared beam from one point to another; `depth` is its other half width, `end` the scale of its far end."""
        a, b = vec(*a), vec(*b)
        side, up = frame_along(b - a)
        depth, end = depth or half, end or 1.0
        ring = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        near = [a + side * half * x + up * depth * y for x, y in ring]
        far = [b + (side * half * x + up * depth * y) * end for x, y in ring]
        solid = hull(near + far)
        self.solid(solid.bevel(bevel, self.rng) if bevel else solid, paint)

    def tube(self, path, radii, sides, paint, caps=True, spin=0.0):
        """A round thing along a path."""
        path = [vec(*p) for p in path]
        radii = radii if isinstance(radii, (list, tuple)) else [radii] * len(path)
        rings, side = [], None
        for i, p in enumerate(path):
            along = unit(path[min(i + 1, len(path) - 1)] - path[max(i - 1, 0)])
            if side is None:
                side, _ = frame_along(along)
            side = unit(side - along * dot(side, along))
            up = np.cross(along, side)
            angles = [2 * math.pi * (k + spin) / sides for k in range(sides)]
            rings.append([p + (side * math.cos(t) + up * math.sin(t)) * radii[i] for t in angles])
        for low, high, r in zip(rings, rings[1:], zip(radii, radii[1:])):
            for k in range(sides):
                j = (k + 1) % sides
                corners = [low[k], low[j], high[j], high[k]]
                self.poly(distinct(corners) if min(r) < 1e-4 else corners, paint)
        if caps:
            if radii[0] > 1e-4:
                self.poly(rings[0][::-1], paint)
            if radii[-1] > 1e-4:
                self.poly(rings[-1], paint)

    def lathe(self, profile, sides, paint, at=(0, 0, 0), turn=None, spin=0.5):
        """Pairs of height and radius about the y axis, from below; a paint, or one for each band."""
        turn = np.eye(3) if turn is None else turn
        at = vec(*at)

        def ring(height, radius):
            angles = [2 * math.pi * (i + spin) / sides for i in range(sides)]
            return [times(turn, vec(radius * math.cos(t), height, -radius * math.sin(t))) + at for t in angles]

        rings = [ring(h, r) for h, r in profile]
        paints = paint if isinstance(paint, list) else [paint] * (len(profile) - 1)
        for low, high, colour in zip(rings, rings[1:], paints):
            for i in range(sides):
                j = (i + 1) % sides
                corners = distinct([low[i], low[j], high[j], high[i]])
                if len(corners) >= 3:
                    self.poly(corners, colour)
        if profile[0][1] > 1e-4:
            self.poly(rings[0][::-1], paints[0])
        if profile[-1][1] > 1e-4:
            self.poly(rings[-1], paints[-1])

    def leaf(self, root, tip, width, paint, bend=0.0, tone=None):
        """A pointed leaf of two facets on each side, folded along its middle."""
        root, tip = vec(*root), vec(*tip)
        middle = (root + tip) / 2 + vec(0, bend, 0)
        side = unit(np.cross(tip - root, vec(0.2, 0.9, 0.4))) * width / 2
        fold = unit(np.cross(side, tip - root)) * width * 0.15
        a, b = middle + side + fold, middle - side + fold
        self.poly([root, a, tip], tone or paint, both=True)
        self.poly([root, tip, b], paint, both=True)

    def light(self, at, reach, colour):
        self.lights.append((at, reach, colour))

    def triangles(self):
        """All triangles with their paint and a number of the polygon that they are of."""
        found = []
        for number, (points, paint, tag) in enumerate(self.faces):
            for i in range(2, len(points)):
                corners = [points[0], points[i - 1], points[i]]
                if norm(np.cross(corners[1] - corners[0], corners[2] - corners[0])) > 1e-8:
                    found.append((corners, paint, tag, number))
        return found


# ---- Colours and occlusion --------------------------------------------------------------------------------------------


def hemisphere():
    """Directions about +z, as many as a matt surface would send."""
    found = []
    for i in range(RAYS):
        r, a = math.sqrt((i + 0.5) / RAYS), i * 2.39996
        found.append((r * math.cos(a), r * math.sin(a), math.sqrt(max(0.0, 1 - r * r))))
    return np.array(found)


def bake(piece):
    """The triangles of a piece: corners, and for each of them linear red, green, blue and openness; and whether it glows."""
    from mathutils import Vector
    from mathutils.bvhtree import BVHTree

    triangles = piece.triangles()
    points = np.array([t[0] for t in triangles])
    low, high = points.min(axis=(0, 1)), points.max(axis=(0, 1))
    size = norm(high - low)
    reach = min(max(0.30 * size, 0.35), 3.5)
    soup = [tuple(p) for t in points for p in t]
    indices = [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(triangles))]
    if piece.ground or piece.wall:
        w = size * 2
        floor = [(-w, 0, -w), (-w, 0, w), (w, 0, w), (w, 0, -w)]
        back = [(-w, -w, 0), (w, -w, 0), (w, w, 0), (-w, w, 0)]
        soup += floor if piece.ground else back
        indices.append(tuple(range(len(soup) - 4, len(soup))))
    tree = BVHTree.FromPolygons(soup, indices)
    directions, cache, baked = hemisphere(), {}, []
    for (corners, paint, tag, number), place in zip(triangles, points):
        normal = unit(np.cross(place[1] - place[0], place[2] - place[0]))
        rays, middle = times(directions, np.array([*frame_along(normal), normal])), place.mean(axis=0)

        def sky(point, lift):
            return openness(tree, Vector, point + normal * lift, rays, reach)

        shades = []
        for corner in place:
            key = (tuple(np.round(corner, 3)), tuple(np.round(normal, 1)))
            if key not in cache:
                cache[key] = sky(corner + (middle - corner) * 0.12, 0.004 * max(size, 1.0))
            shades.append(cache[key])
        on_ground = piece.ground and normal[1] < -0.9 and place[:, 1].max() < 0.03
        if on_ground or (max(shades) < HIDDEN and sky(middle, 0.004) < HIDDEN):
            continue
        shades = [1.0] * 3 if paint.glow else shades
        colour = facet_colour(piece, paint, tag, number, normal, place, (low, high))
        baked.append((place, [(*(colour * (0.62 + 0.38 * s)), s) for s in shades], paint.glow))
    return baked


def openness(tree, Vector, origin, directions, reach):
    covered = 0.0
    start = Vector(origin)
    for d in directions:
        distance = tree.ray_cast(start, Vector(d), reach)[3]
        if distance is not None:
            covered += (1 - distance / reach) ** 0.6
    return 1 - 0.92 * covered / len(directions)


def facet_colour(piece, paint, tag, number, normal, place, extent):
    """The paint, shifted for the facet, worn at edges, overgrown above, dirty at the foot."""
    rng = random.Random(f"{piece.name} {number}")
    own = random.Random(f"{piece.name} {np.round(place.mean(axis=0), 2).tolist()}")
    colour = linear(paint.colour)
    if paint.top >= 0:
        up = min(max((normal[1] - 0.45) / 0.35, 0.0), 1.0)
        colour = colour + (linear(paint.top) - colour) * up * paint.moss
    brighter = 1 + 2 * paint.variety * (rng.uniform(-1, 1) + 0.4 * own.uniform(-1, 1))
    warmer = paint.variety * rng.uniform(-0.8, 0.8)
    colour = colour * brighter * np.array([1 + warmer, 1.0, 1 - warmer])
    if tag == "worn":
        colour = colour * (1 + 2 * paint.worn)
    if not paint.glow and piece.dirt:
        height = (place.mean(axis=0)[1] - extent[0][1]) / max(extent[1][1] - extent[0][1], 1e-6)
        colour = colour * (1 - piece.dirt * (1 - min(height * 1.6, 1.0)))
    return np.clip(colour, 0, 1)
