"""Set pieces of stone: columns, arches, statues, a tomb, rubble, stalactites."""

import math

from pieces_kit import DARK, MOSS, PALE, STONE, Paint, Piece, boulder, box, drum, hull, prism, times, turned, vec

MOULDING = PALE.shifted(1.08)
HOLLOW = Paint(0x34353F, 0.05)
FOUNDATION = 3.0  # how far the piers of columns and arches go down, so that they may stand behind a ledge


def pier(p, width, depth, paint=DARK):
    """What carries a column where the ground lies deeper."""
    p.block((0, -FOUNDATION, 0), (width, FOUNDATION + 0.02, depth), paint, bevel=0.06, taper=0.94)


def base(p):
    pier(p, 1.5, 1.5)
    p.block((0, 0, 0), (1.42, 0.30, 1.42), STONE, bevel=0.05, chips=3)
    p.solid(drum(0.62, 0.52, 0.20, 10).bevel(0.04, p.rng, 0.3, 55), MOULDING, (0, 0.28, 0), drop=(0, -1, 0))


def shaft(p, drums, first=0.46, height=1.0, chips=2):
    """Drums on each other, never quite in line; returns the height and the place of the top."""
    y, shift = base_height(), vec(0, 0, 0)
    for i in range(drums):
        low, high = first - 0.018 * i, first - 0.018 * (i + 1)
        solid = drum(low, high, height, 9, p.rng.random()).bevel(0.035, p.rng, 0.6, 55).chip(p.rng, chips, 0.14)
        shift = shift + vec(p.rng.uniform(-0.04, 0.04), 0, p.rng.uniform(-0.04, 0.04))
        p.solid(solid, PALE, (shift[0], y, shift[2]))
        y += height
    return y, shift


def base_height():
    return 0.47


def pillar():
    p = Piece("pillar")
    base(p)
    top, at = shaft(p, 4, height=0.95, chips=1)
    p.solid(drum(0.40, 0.62, 0.30, 9).chip(p.rng, 1, 0.12), MOULDING, (at[0], top, at[2]))
    p.block((at[0], top + 0.29, at[2]), (1.36, 0.26, 1.36), STONE, bevel=0.05, chips=3)
    return p


def pillar_fluted():
    p = Piece("pillar_fluted")
    base(p)
    flutes = 10

    def ring(y, r, share):
        points = []
        for i in range(2 * flutes):
            a = math.pi * i / flutes
            radius = r * (1 if i % 2 == 0 else 1 - 0.17 * share)
            points.append(vec(radius * math.cos(a), y, -radius * math.sin(a)))
        return points

    rings = [ring(0.47, 0.48, 0.2), ring(0.70, 0.47, 1), ring(2.6, 0.45, 1), ring(4.25, 0.41, 1), ring(4.45, 0.41, 0.2)]
    for low, high in zip(rings, rings[1:]):
        for i in range(2 * flutes):
            j = (i + 1) % (2 * flutes)
            if p.rng.random() > 0.04:
                p.poly([low[i], low[j], high[j], high[i]], PALE.shifted(1.0 if i % 2 else 1.06))
            else:  # a broken rib
                p.poly([low[i], low[j], high[j], high[i]], HOLLOW.shifted(2.2))
    p.solid(drum(0.45, 0.66, 0.28, 10), MOULDING, (0, 4.43, 0))
    p.block((0, 4.70, 0), (1.42, 0.28, 1.42), STONE, bevel=0.05, chips=4)
    return p


def pillar_square():
    p = Piece("pillar_square")
    pier(p, 1.35, 1.35)
    p.block((0, 0, 0), (1.34, 0.42, 1.34), STONE, bevel=0.06, chips=3)
    y = 0.42
    for i in range(5):
        height, width = p.rng.uniform(0.66, 0.80), 0.98 + p.rng.uniform(-0.04, 0.04)
        turn = turned(y=p.rng.uniform(-3, 3))
        paint = STONE if i % 2 else PALE.shifted(0.93)
        p.block((p.rng.uniform(-0.03, 0.03), y, 0), (width, height, width), paint, bevel=0.045, chips=2, turn=turn)
        y += height
    p.block((0, y, 0), (1.26, 0.24, 1.26), MOULDING, bevel=0.05, chips=2)
    p.block((0, y + 0.24, 0), (1.5, 0.22, 1.5), STONE, bevel=0.05, chips=3)
    return p


def pillar_broken():
    p = Piece("pillar_broken")
    base(p)
    top, at = shaft(p, 1, height=1.0)
    stump = drum(0.44, 0.43, 1.15, 9, 0.3)
    for direction, reach in ((vec(0.75, 0.8, 0.2), 0.74), (vec(-0.5, 0.85, -0.5), 0.92), (vec(-0.3, 0.6, 0.9), 0.83)):
        stump = stump.cut(direction, reach)
    p.solid(stump.bevel(0.03, p.rng, 0.6, 65), PALE, (at[0], top, at[2]))
    for x, z, size in ((0.95, 0.35, 0.22), (-0.85, 0.45, 0.16), (0.7, -0.6, 0.18)):
        p.solid(boulder(p.rng, (size, size * 0.7, size * 0.8), 10), PALE, (x, size * 0.5, z))
    return p


def pillar_fallen():
    p = Piece("pillar_fallen")
    x = -2.35
    for i, (length, gap, tilt) in enumerate(((1.75, 0.10, 3), (1.35, 0.28, -5), (0.95, 0.0, 9))):
        r = 0.47 - 0.02 * i
        solid = drum(r, r - 0.02, length, 9, p.rng.random()).bevel(0.035, p.rng, 0.6, 55).chip(p.rng, 3, 0.2)
        turn = times(turned(y=tilt), turned(z=-90 + tilt * 0.4))
        p.solid(solid, PALE, (x, r * 0.86, 0.06 * tilt * 0.3), turn)
        x += length + gap
    capital = drum(0.42, 0.62, 0.30, 9).chip(p.rng, 2, 0.15)
    p.solid(capital, MOULDING, (2.15, 0.40, 0.15), times(turned(y=24), turned(z=-104)))
    p.block((2.72, 0.16, 0.22), (0.24, 1.15, 1.15), STONE, bevel=0.05, chips=3, turn=times(turned(y=24), turned(z=-20)))
    for x, z, size in ((-0.4, 0.62, 0.15), (1.2, 0.66, 0.20), (-2.5, 0.55, 0.13)):
        p.solid(boulder(p.rng, (size, size * 0.7, size), 9), STONE, (x, size * 0.45, z))
    return p


INNER, OUTER, SPRING, HALF = 2.05, 2.95, 2.6, 0.45  # of arches: radii, height of the springers, half the depth
COUNT = 7  # voussoirs


def wedge(p, index, count, paint, at=(0, 0, 0), turn=None, extra=0.0):
    """A voussoir: one of so many stones of a half circle."""
    a, b = (math.pi * (k / count) for k in (index, index + 1))
    inner = [(INNER * math.cos(t), INNER * math.sin(t)) for t in (a, b)]
    outer = [((OUTER + extra) * math.cos(t), (OUTER + extra) * math.sin(t)) for t in (b, a)]
    depth = HALF + extra * 0.4 + p.rng.uniform(-0.03, 0.03)
    solid = prism(inner + outer, -depth, depth)
    solid = solid.moved(offset=-solid.centre()) if turn is not None else solid
    p.solid(solid.bevel(0.035, p.rng), paint, at, turn)


def arch_piers(p, heights):
    for side, height in zip((-1, 1), heights):
        x = side * (INNER + OUTER) / 2
        p.block((x, -FOUNDATION, 0), (1.15, FOUNDATION, 1.1), DARK, bevel=0)
        p.block((x, 0, 0), (1.16, 0.36, 1.16), STONE, bevel=0.05)
        y = 0.36
        while y < height - 0.1:
            rise = min(1.12, height - y)
            turn = turned(y=p.rng.uniform(-2, 2))
            p.block((x, y, 0), (0.90, rise, 0.90), PALE.shifted(p.rng.uniform(0.88, 1.0)), bevel=0.04, chips=int(y < 1), turn=turn)
            y += rise
        if height >= SPRING:
            p.block((x, SPRING - 0.24, 0), (1.10, 0.24, 1.06), MOULDING, bevel=0)


def arch():
    p = Piece("arch")
    arch_piers(p, (SPRING, SPRING))
    for i in range(COUNT):
        wedge(p, i, COUNT, (STONE if i % 2 else PALE), (0, SPRING, 0), extra=0.16 if i == COUNT // 2 else 0.0)
    return p


def arch_broken():
    p = Piece("arch_broken")
    arch_piers(p, (SPRING, SPRING))
    for i in (0, 1, COUNT - 1):
        wedge(p, i, COUNT, (STONE if i % 2 else PALE), (0, SPRING, 0))
    for at, tilt in (((0.75, 0.36, 0.25), 62), ((-0.65, 0.34, -0.1), 17), ((-1.25, 0.40, 0.45), 130)):
        wedge(p, 3, COUNT, PALE, at, times(turned(x=p.rng.uniform(-15, 15), y=p.rng.uniform(-30, 30)), turned(z=tilt)))
    return p


def statue_head():
    """A fallen colossus, sunk to the jaw, looking past us."""
    p = Piece("statue_head")
    lean = times(turned(y=-38), turned(x=-12, z=14))
    at = (0.1, 1.15, 0)

    def add(solid, paint, place, turn=None):
        p.solid(solid.moved(turn, place), paint, at, lean)

    skull = boulder(p.rng, (1.15, 1.45, 1.25), 22)
    skull = skull.cut(vec(0.02, 0.05, 1), 1.02, "face").cut(vec(-0.7, 0.8, -0.35), 1.22).cut(vec(-0.9, 0.15, -0.3), 0.98)
    add(skull, STONE, (0, 0.2, 0))
    add(box((2.02, 0.34, 0.5), 0.92).bevel(0.08, p.rng), PALE, (0, 0.72, 0.86))  # the band on the brow
    add(box((1.74, 0.22, 0.36), 0.9).bevel(0.05, p.rng), STONE, (0, 0.42, 1.0))  # brows
    nose = hull([(-0.13, 0.5, 1.1), (0.13, 0.5, 1.1), (-0.27, -0.34, 1.02), (0.27, -0.34, 1.02), (0.0, -0.26, 1.56), (0, 0.42, 1.26)])
    add(nose.cut(vec(0.5, -0.5, 0.7), 1.16), PALE, (0, 0, 0))
    for side in (-1, 1):
        add(box((0.48, 0.26, 0.2)), HOLLOW, (0.44 * side, 0.12, 0.93))
        lid = hull([(x * side, y, z) for x, y, z in ((0.2, 0.2, 1.1), (0.74, 0.2, 0.98), (0.2, 0.06, 1.06), (0.74, 0.04, 0.94), (0.46, 0.12, 1.16))])
        add(lid, STONE, (0, 0.06, 0))
        cheek = hull([(x * side, y, z) for x, y, z in ((0.3, 0.02, 0.9), (0.95, 0.1, 0.7), (0.34, -0.62, 0.95), (0.86, -0.6, 0.5), (0.5, -0.1, 1.2))])
        add(cheek, STONE, (0, 0, 0))
        add(box((0.2, 0.62, 0.42)), PALE, (1.13 * side, -0.1, 0.05))
    add(box((0.72, 0.13, 0.2), 0.85).bevel(0.03, p.rng), PALE, (0, -0.62, 1.02))
    add(box((0.60, 0.15, 0.2), 1.1).bevel(0.03, p.rng), PALE, (0, -0.80, 0.99))
    add(box((0.85, 0.40, 0.5), 1.15).bevel(0.08, p.rng), STONE, (0, -1.22, 0.75))
    for i, x in enumerate((-0.7, -0.25, 0.25, 0.7)):  # the crown, two points of it broken
        height = (0.30, 0.78, 0.85, 0.24)[i]
        add(box((0.34, height, 0.26), 0.35 if height > 0.5 else 0.9).chip(p.rng, 1, 0.1), PALE, (x, 1.02, 0.80 - 0.25 * abs(x)))
    for x, z, size in ((1.5, 0.6, 0.34), (-1.35, 0.8, 0.26), (1.1, 1.1, 0.18)):
        p.solid(boulder(p.rng, (size, size * 0.75, size), 10), STONE, (x, size * 0.4, z))
    return p


def statue_kneeling():
    """A knight on one knee before the sword that he has set down, looking to the right."""
    p = Piece("statue_kneeling")
    p.block((0, 0, 0), (2.1, 0.34, 1.3), DARK, bevel=0.05, chips=3)
    p.block((0, 0.33, 0), (1.8, 0.22, 1.05), STONE, bevel=0.04)
    y = 0.55
    cape = hull([(-0.95, y, -0.42), (-0.95, y, 0.42), (-0.1, y, -0.5), (-0.1, y, 0.5), (-0.36, y + 1.45, -0.32), (-0.36, y + 1.45, 0.32), (0.1, y + 1.4, -0.2), (0.1, y + 1.4, 0.2)])
    p.solid(cape.bevel(0.06, p.rng), STONE)
    chest = hull([(-0.25, y + 0.7, -0.3), (-0.25, y + 0.7, 0.3), (0.25, y + 0.7, -0.27), (0.25, y + 0.7, 0.27), (-0.2, y + 1.42, -0.44), (-0.2, y + 1.42, 0.44), (0.28, y + 1.35, -0.4), (0.28, y + 1.35, 0.4)])
    p.solid(chest.bevel(0.05, p.rng), PALE)
    for side in (-1, 1):
        z = 0.46 * side
        p.solid(boulder(p.rng, (0.24, 0.22, 0.2), 7), PALE, (0.05, y + 1.36, z))
        p.beam((0.08, y + 1.3, z), (0.42, y + 0.98, z * 0.8), 0.11, PALE)
        p.beam((0.40, y + 1.0, z * 0.8), (0.78, y + 1.16, 0.07 * side), 0.10, PALE)
    p.beam((-0.05, y + 0.62, 0.28), (0.56, y + 0.66, 0.28), 0.17, PALE)  # the raised knee
    p.beam((0.5, y + 0.72, 0.28), (0.46, y, 0.28), 0.14, PALE)
    p.block((0.53, y, 0.28), (0.44, 0.14, 0.24), PALE, bevel=0)
    p.beam((-0.05, y + 0.6, -0.26), (0.22, y + 0.14, -0.26), 0.17, PALE)
    p.beam((0.22, y + 0.13, -0.26), (-0.55, y + 0.10, -0.26), 0.13, PALE)
    head = boulder(p.rng, (0.24, 0.28, 0.23), 10).cut(vec(1, -0.35, 0), 0.19, "face")
    p.solid(head, PALE, (0.24, y + 1.64, 0), turned(z=-24))
    hood = hull([(-0.3, y + 1.38, -0.26), (-0.3, y + 1.38, 0.26), (0.12, y + 1.42, -0.27), (0.12, y + 1.42, 0.27), (-0.12, y + 2.02, -0.12), (-0.12, y + 2.02, 0.12), (0.34, y + 1.94, -0.13), (0.34, y + 1.94, 0.13)])
    p.solid(hood, STONE)
    p.beam((0.84, y + 0.02, 0), (0.84, y + 1.2, 0), 0.035, DARK, depth=0.09)
    p.beam((0.84, y + 1.2, 0), (0.84, y + 1.55, 0), 0.05, DARK)
    p.beam((0.84, y + 1.2, -0.32), (0.84, y + 1.2, 0.32), 0.05, DARK)
    p.solid(drum(0.09, 0.05, 0.12, 5), PALE, (0.84, y + 1.6, 0))
    return p


def tomb():
    p = Piece("tomb")
    p.block((0, 0, 0), (2.5, 0.20, 1.25), DARK, bevel=0.04, chips=3)
    p.block((0, 0.19, 0), (2.02, 0.62, 0.82), STONE, bevel=0.02)
    for x in (-1.02, -0.34, 0.34, 1.02):
        for z in (-0.42, 0.42):
            p.block((x, 0.19, z), (0.17, 0.62, 0.15), PALE, bevel=0)
    p.block((0, 0.79, 0), (2.28, 0.13, 1.06), MOULDING, bevel=0.035, chips=2)
    lid = hull([(x, 0.0, z) for x in (-1.14, 1.14) for z in (-0.5, 0.5)] + [(x, 0.3, z) for x in (-0.98, 0.98) for z in (-0.14, 0.14)])
    left = lid.cut(vec(1, 0.25, 0.2), 0.16).bevel(0.03, p.rng, 0.5, 50)
    right = lid.cut(vec(-1, -0.25, -0.2), -0.22).bevel(0.03, p.rng, 0.5, 50)
    p.solid(left, PALE, (0, 0.93, 0))
    p.solid(right, PALE, (0.13, 0.86, 0.16), turned(x=9, y=-10, z=-9))
    p.beam((-0.95, 1.235, 0), (0.02, 1.235, 0), 0.03, STONE, depth=0.05)
    p.beam((-0.62, 1.24, -0.17), (-0.62, 1.24, 0.17), 0.03, STONE, depth=0.05)
    for x, z, size in ((1.45, 0.35, 0.17), (1.3, -0.3, 0.22), (-1.4, 0.5, 0.13)):
        p.solid(boulder(p.rng, (size, size * 0.7, size), 9), STONE, (x, size * 0.4, z))
    return p


def heap(name, paint, stones):
    p = Piece(name)
    for x, y, z, size, flat in stones:
        solid = boulder(p.rng, (size, size * flat, size * p.rng.uniform(0.75, 1.0)), 12)
        turn = turned(p.rng.uniform(-25, 25), p.rng.uniform(0, 360), p.rng.uniform(-25, 25))
        p.solid(solid, paint if p.rng.random() < 0.7 else paint.shifted(0.86), (x, y, z), turn)
    return p


LOOSE = Paint(0x6C6F80, 0.09, MOSS, 0.5)  # what has broken off the rock, and has its colour


def rubble():
    return heap("rubble", LOOSE, [
        (-0.35, 0.26, -0.1, 0.52, 0.72), (0.42, 0.22, 0.0, 0.44, 0.7), (0.05, 0.62, -0.12, 0.36, 0.75),
        (-0.85, 0.12, 0.2, 0.26, 0.7), (0.1, 0.13, 0.42, 0.26, 0.7), (0.92, 0.10, 0.18, 0.22, 0.7),
        (-0.42, 0.08, 0.52, 0.20, 0.7),
    ])  # fmt: skip


def rubble_small():
    return heap("rubble_small", LOOSE, [
        (0.0, 0.12, 0.0, 0.27, 0.7), (0.40, 0.08, 0.08, 0.19, 0.7), (-0.36, 0.07, 0.10, 0.17, 0.75),
    ])  # fmt: skip


def rubble_blocks():
    p = Piece("rubble_blocks")
    for at, size, turn, paint in (
        ((-0.62, -0.04, 0), (0.95, 0.55, 0.7), (0, 14, 5), PALE),
        ((0.45, -0.03, -0.1), (0.8, 0.62, 0.7), (4, -22, -7), STONE),
        ((-0.08, 0.50, -0.05), (0.9, 0.48, 0.62), (-6, 30, 17), PALE),
        ((1.05, 0.12, 0.22), (0.62, 0.42, 0.5), (12, 40, -34), PALE),
        ((-0.2, -0.02, 0.62), (0.46, 0.30, 0.36), (3, 25, 8), STONE),
        ((-1.25, 0.06, 0.25), (0.36, 0.30, 0.3), (10, -30, 28), STONE),
    ):
        p.block(at, size, paint, bevel=0.045, chips=2, turn=turned(*turn))
    for x, z, size in ((0.62, 0.6, 0.13), (-0.75, 0.65, 0.10), (1.35, 0.5, 0.09)):
        p.solid(boulder(p.rng, (size, size * 0.7, size), 9), STONE, (x, size * 0.4, z))
    return p


def stalactite():
    p = Piece("stalactite", ground=False, dirt=-0.15)
    wet = Paint(0x73727F, 0.09)
    for x, z, length, r in ((0, 0, 1.85, 0.30), (0.42, -0.1, 1.15, 0.22), (-0.40, 0.06, 1.35, 0.21), (0.2, 0.26, 0.8, 0.16), (-0.72, -0.12, 0.7, 0.17), (-0.16, -0.3, 0.95, 0.18), (0.78, 0.08, 0.55, 0.15)):
        bend, turn = p.rng.uniform(-0.05, 0.05), p.rng.random()
        path = [(x, 0.16, z), (x, -0.22 * length, z), (x + bend, -0.6 * length, z), (x + bend * 1.4, -length, z)]
        p.tube(path, [r * 1.35, r * 0.8, r * 0.42, 0.0], 6, wet, spin=turn)
    return p


PIECES = [
    pillar, pillar_fluted, pillar_square, pillar_broken, pillar_fallen, arch, arch_broken, statue_head, statue_kneeling, tomb,
    rubble, rubble_small, rubble_blocks, stalactite,
]  # fmt: skip
