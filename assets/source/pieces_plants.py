"""What grows and lives in the quarry."""

import math

from pieces_kit import Paint, Piece, boulder, turned, unit, vec

BLADE = Paint(0x75925A, 0.16)
DRY = Paint(0xB5A866, 0.14)
FROND = Paint(0x55804F, 0.15)
LEAF = Paint(0x668552, 0.18, 0x94A565, 0.6)
DEEP_LEAF = Paint(0x4B6A4C, 0.16, 0x748C5A, 0.5)
BARK = Paint(0x5E4E48, 0.13)
DEAD_BARK = Paint(0x85796F, 0.13)
STEM = Paint(0x5F7448, 0.12)
BROWN = Paint(0x6B4630, 0.10)
CAP = Paint(0x7E5F4C, 0.10)
GILLS = Paint(0x57463E, 0.08)
STALK = Paint(0x9A8C78, 0.08)
FEATHER = Paint(0x1D1F26, 0.10)


def blade(p, root, tip, width, low, high, bend=0.12):
    """A blade of grass: two facets seen from both sides, dark below."""
    root, tip = vec(*root), vec(*tip)
    middle = root + (tip - root) * 0.5 + vec(0, bend, 0)
    side = unit(vec(-(tip - root)[2], 0, (tip - root)[0])) * width / 2
    if abs(side).max() < 1e-6 or abs(side[0]) < abs(side[2]) * 0.6:
        side = vec(width / 2, 0, 0.1 * width)
    p.poly([root, middle + side, middle - side], low, both=True)
    p.poly([middle - side, middle + side, tip], high, both=True)


def grass():
    p = Piece("grass", sway=0.8, dirt=0.45)
    for i in range(9):
        a = 2.39996 * i
        out = vec(math.cos(a), 0, math.sin(a))
        lean, height = p.rng.uniform(0.10, 0.56), p.rng.uniform(0.4, 0.86)
        root = out * 0.14 * p.rng.random() - vec(0, 0.05, 0)
        low = BLADE.shifted(p.rng.uniform(0.75, 0.95))
        high = DRY if p.rng.random() < 0.3 else BLADE.shifted(1.12)
        blade(p, root, out * lean + vec(0, height, 0), 0.15, low, high)
    return p


def fern():
    p = Piece("fern", sway=0.6, dirt=0.4)
    for i in range(7):
        a = 2.39996 * i + 0.4
        out = vec(math.cos(a), 0, 0.8 * math.sin(a))
        across = vec(-out[2], 0, out[0])
        reach, rise = p.rng.uniform(0.55, 0.78), p.rng.uniform(0.55, 0.82)
        tone = FROND.shifted(p.rng.uniform(0.85, 1.15))

        def spine(t):
            return out * reach * t + vec(0, rise * math.sin(t * 2.3), 0)

        for k in range(1, 6):
            t = k / 6
            size = 0.26 * (1 - 0.75 * t)
            for side in (-1, 1):
                root, tip = spine(t - 0.07), spine(t + 0.10) + across * side * size - vec(0, 0.05, 0)
                p.poly([root, spine(t + 0.06), tip][::side], tone, both=True)
        p.poly([spine(0.8), spine(1.06), spine(0.86) + across * 0.05], tone.shifted(1.2), both=True)
        p.poly([vec(0, -0.04, 0) + across * 0.02, vec(0, -0.04, 0) - across * 0.02, spine(0.45)], STEM, both=True)
    return p


def bush():
    p = Piece("bush", sway=0.3, dirt=0.4)
    clumps = ((-0.42, 0.36, 0.05, 0.46), (0.40, 0.34, 0.0, 0.44), (0.0, 0.58, -0.12, 0.52), (0.08, 0.26, 0.34, 0.36), (-0.14, 0.84, 0.0, 0.3))
    for x, y, z, size in clumps:
        solid = boulder(p.rng, (size, size * 0.8, size * 0.9), 14)
        p.solid(solid, DEEP_LEAF if y < 0.4 else LEAF, (x, y, z), turned(y=p.rng.uniform(0, 90)))
        for _ in range(9):
            d = unit(vec(p.rng.uniform(-1, 1), p.rng.uniform(-0.1, 1), p.rng.uniform(-0.5, 1)))
            root = vec(x, y, z) + d * size * 0.72
            p.leaf(root, root + d * 0.17 + vec(0, 0.06, 0), 0.13, LEAF.shifted(p.rng.uniform(0.9, 1.3)))
    return p


def reed():
    p = Piece("reed", sway=0.7, dirt=0.4)
    for i in range(8):
        a = 2.39996 * i
        out = vec(math.cos(a), 0, math.sin(a))
        root = out * 0.22 * p.rng.random() - vec(0, 0.1, 0)
        tip = out * p.rng.uniform(0.12, 0.5) + vec(0, p.rng.uniform(0.9, 1.65), 0)
        blade(p, root, tip, 0.13, BLADE.shifted(0.72), BLADE.shifted(p.rng.uniform(0.95, 1.2)), 0.10)
    for x, z, height in ((0.06, 0.05, 1.82), (-0.16, 0.02, 1.55), (0.2, -0.08, 1.38), (-0.02, 0.14, 1.22)):
        top = (x * 1.7, height, z)
        p.tube([(x, -0.1, z), top], 0.035, 3, STEM, caps=False)
        p.lathe([(-0.34, 0.03), (-0.28, 0.085), (-0.06, 0.08), (0.0, 0.03), (0.12, 0.0)], 5, BROWN, top)
    return p


def limb(p, path, radii, sides=5, paint=BARK):
    p.tube(path, radii, sides, paint, caps=False, spin=p.rng.random())


def tree():
    """A small tree that the wind has bent to the right."""
    p = Piece("tree", sway=0.18, dirt=0.3)
    limb(p, [(-0.12, -0.3, 0), (0.0, 0.35, 0), (-0.22, 1.05, 0.05), (0.10, 1.75, 0.0), (0.62, 2.30, -0.05), (1.15, 2.62, 0)], [0.34, 0.23, 0.19, 0.16, 0.11, 0.05], 7)
    limb(p, [(-0.20, 1.10, 0.05), (-0.62, 1.62, 0.12), (-0.72, 2.25, 0.1), (-0.45, 2.72, 0.05)], [0.13, 0.10, 0.075, 0.03])
    limb(p, [(0.10, 1.72, 0), (0.05, 2.35, -0.2), (0.3, 2.95, -0.2)], [0.11, 0.075, 0.03])
    limb(p, [(0.60, 2.28, -0.05), (1.05, 2.22, 0.25), (1.5, 2.36, 0.3)], [0.08, 0.05, 0.02], 4)
    for a in (0.4, 2.4, 4.4):  # roots
        limb(p, [(0.0, 0.22, 0), (0.36 * math.cos(a), 0.05, 0.36 * math.sin(a)), (0.62 * math.cos(a), -0.12, 0.62 * math.sin(a))], [0.13, 0.09, 0.03], 4)
    clumps = ((1.25, 2.95, 0.0, 0.78), (0.42, 3.25, -0.2, 0.82), (-0.48, 3.02, 0.05, 0.68), (1.85, 2.55, 0.25, 0.50), (1.0, 3.55, -0.1, 0.5), (-0.95, 2.55, 0.15, 0.4))
    for x, y, z, size in clumps:
        solid = boulder(p.rng, (size, size * 0.52, size * 0.8), 15)
        p.solid(solid, LEAF if y > 2.9 else DEEP_LEAF, (x, y, z), turned(y=p.rng.uniform(0, 90), z=-9))
    return p


def dead_tree():
    p = Piece("dead_tree", sway=0.06, dirt=0.2)

    def grow(start, direction, length, r, depth):
        steps, path, radii = 3, [start], [r]
        for i in range(steps):
            direction = unit(direction + vec(p.rng.uniform(-0.35, 0.35), p.rng.uniform(-0.05, 0.25), p.rng.uniform(-0.2, 0.2)))
            path.append(path[-1] + direction * length / steps)
            radii.append(r * (1 - 0.22 * (i + 1)))
        if depth == 0:
            radii[-1] = 0.0
        limb(p, path, radii, 6 if depth > 1 else 4 if depth else 3, DEAD_BARK)
        if depth:
            for side in (-1, 1):
                turn = vec(side * p.rng.uniform(0.6, 1.0), p.rng.uniform(0.35, 0.8), p.rng.uniform(-0.4, 0.4))
                at = path[-1] if side > 0 else path[-2]
                grow(at, unit(direction * 0.6 + turn), length * p.rng.uniform(0.62, 0.8), radii[-1 if side > 0 else -2] * 0.82, depth - 1)

    grow(vec(0, -0.25, 0), vec(0.12, 1, 0), 1.9, 0.26, 3)
    for a in (0.2, 2.2, 3.6):
        limb(p, [(0.0, 0.2, 0), (0.34 * math.cos(a), 0.03, 0.34 * math.sin(a)), (0.6 * math.cos(a), -0.14, 0.6 * math.sin(a))], [0.14, 0.09, 0.03], 4, DEAD_BARK)
    return p


def ivy():
    p = Piece("ivy", sway=0.08, ground=False, wall=True, dirt=-0.1)
    stems = []
    for x, lean in ((-0.5, 0.15), (0.1, -0.12), (0.55, 0.1)):
        path = [(x + lean * math.sin(k * 1.3), -1.05 + 0.36 * k, 0.03) for k in range(6)]
        p.tube(path, [0.055, 0.05, 0.05, 0.045, 0.04, 0.03], 3, BROWN, caps=False)
        stems += path
    for i in range(38):
        x, y, z = stems[p.rng.randrange(len(stems))]
        a, far = p.rng.uniform(0, 2 * math.pi), p.rng.uniform(0.03, 0.30)
        at = vec(x + far * math.cos(a), y + far * math.sin(a) * 0.9, 0.05 + 0.06 * p.rng.random())
        size = p.rng.uniform(0.30, 0.46)
        tip = at + vec(size * p.rng.uniform(-0.5, 0.5), -size, 0.07)
        wide, tone = vec(size * 0.55, -0.02, 0), LEAF.shifted(p.rng.uniform(0.65, 1.25))
        p.poly([at, at - wide - vec(0, 0.35 * size, 0.0), tip], tone)
        p.poly([at, tip, at + wide - vec(0, 0.35 * size, 0.0)], tone.shifted(1.15))
    return p


def vine():
    p = Piece("vine", sway=0.4, ground=False, dirt=-0.15)
    for x, z, length in ((0.0, 0.05, 3.0), (-0.34, -0.04, 2.0), (0.32, 0.0, 2.4)):
        steps = 5
        path = [(x + 0.05 * math.sin(k * 1.7 + x * 9), 0.1 - (length + 0.1) * k / steps, z) for k in range(steps + 1)]
        p.tube(path, [0.055 - 0.004 * k for k in range(steps + 1)], 3, STEM, caps=False)
        for k in range(int(length / 0.42)):
            t = (k + 0.6) * 0.42 / length
            i = min(int(t * steps), steps - 1)
            at = vec(*path[i]) + (vec(*path[i + 1]) - vec(*path[i])) * (t * steps - i)
            side = 1 if k % 2 else -1
            tip = at + vec(0.31 * side * p.rng.uniform(0.85, 1.2), -0.24, p.rng.uniform(-0.02, 0.13))
            middle = (at + tip) / 2 + vec(0, 0.11, 0.02)
            lower = (at + tip) / 2 + vec(0, -0.11, 0.02)
            tone = LEAF.shifted(p.rng.uniform(0.75, 1.2))
            p.poly([at, lower, tip, middle][::side], tone, both=True)
    return p


def mushrooms():
    p = Piece("mushrooms", dirt=0.3)
    for x, z, height, size, lean in ((0.0, 0.0, 0.44, 0.26, 5), (0.36, 0.08, 0.24, 0.17, -9), (-0.32, 0.06, 0.30, 0.18, 10)):
        turn = turned(z=lean)
        p.lathe([(-0.04, size * 0.34), (height * 0.8, size * 0.22)], 5, STALK, (x, 0, z), turn)
        top = [(height * 0.74, size * 0.2), (height * 0.70, size), (height * 0.86, size * 0.86), (height * 1.08, size * 0.3), (height * 1.1, 0.0)]
        p.lathe(top, 7, [GILLS, CAP, CAP.shifted(1.05), CAP.shifted(1.1)], (x, 0, z), turn)
    return p


def bird():
    """It sits and looks to the right: all dark, so that nobody takes it for a thing to pick up."""
    p = Piece("bird", dirt=0.0)
    p.tube([(-0.20, 0.13, 0), (-0.13, 0.15, 0), (-0.02, 0.17, 0), (0.07, 0.20, 0), (0.12, 0.25, 0)], [0.03, 0.085, 0.11, 0.085, 0.04], 6, FEATHER, spin=0.5)
    p.solid(boulder(p.rng, (0.075, 0.066, 0.066), 12), FEATHER.shifted(1.2), (0.125, 0.275, 0))
    p.tube([(0.175, 0.275, 0), (0.28, 0.262, 0)], [0.03, 0.0], 4, FEATHER.shifted(1.5))
    for side in (-1, 1):
        wing = [(0.04, 0.215, 0.05 * side), (-0.05, 0.15, 0.088 * side), (-0.27, 0.12, 0.03 * side), (-0.08, 0.225, 0.055 * side)]
        p.poly(wing[::side], FEATHER.shifted(0.8), both=True)
        p.tube([(0.0, 0.11, 0.025 * side), (0.01, 0.0, 0.025 * side)], 0.022, 3, FEATHER)
    p.poly([(-0.16, 0.15, 0.03), (-0.42, 0.10, 0.07), (-0.42, 0.10, -0.07), (-0.16, 0.15, -0.03)], FEATHER, both=True)
    return p


PIECES = [grass, fern, bush, reed, tree, dead_tree, ivy, vine, mushrooms, bird]
