"""What is seen far away: towers, an aqueduct, stacks of rock, a windmill, a crane. Few facets, strong outlines."""

import math

from pieces_kit import DARK, IRON, OLD_WOOD, PALE, ROPE, STONE, WARM_WINDOW, WOOD, Paint, Piece, boulder, drum, hull, prism, turned, vec
from pieces_cloth import BONE

TILES = Paint(0x5E4A55, 0.12)
VOID = Paint(0x23242C, 0.05)
CLIFF = Paint(0x77737F, 0.10, 0x7F8A66, 0.8)
UNDER = 10.0  # how far distant things go down below their foot


def window(p, x, y, z, lit, width=0.34, height=0.70):
    """A narrow window in a wall that faces the camera."""
    outline = [(-width / 2, 0), (width / 2, 0), (width / 2, height * 0.7), (0, height), (-width / 2, height * 0.7)]
    paint = WARM_WINDOW if lit else VOID
    p.poly([(x + u, y + v, z + 0.03) for u, v in outline], paint)
    p.block((x, y - 0.16, z + 0.02), (width * 1.7, 0.16, 0.22), PALE, bevel=0, drop=(0, 0, -1))


def tower():
    p = Piece("tower", ground=False, dirt=0.25)
    p.block((0, -UNDER, 0), (6.0, UNDER + 1.6, 6.0), DARK, bevel=0.25, taper=0.86)
    p.block((0, 1.5, 0), (4.7, 3.6, 4.7), STONE, bevel=0.15, taper=0.96)
    p.block((0, 5.0, 0), (4.8, 0.34, 4.8), PALE, bevel=0.06)
    p.block((0, 5.3, 0), (4.35, 4.6, 4.35), STONE, bevel=0.15, taper=0.93)
    p.block((0, 9.8, 0), (4.9, 0.5, 4.9), PALE, bevel=0.1)
    p.block((0, 10.2, 0), (4.5, 0.35, 4.5), STONE, bevel=0)
    for x in (-1.8, -0.6, 0.6, 1.8):
        for z in (-2.0, 2.0):
            if (x, z) != (0.6, 2.0):
                p.block((x, 10.5, z), (0.66, 0.75, 0.5), STONE, bevel=0)
    for z in (-0.7, 0.7):
        for x in (-2.0, 2.0):
            p.block((x, 10.5, z), (0.5, 0.75, 0.66), STONE, bevel=0)
    p.block((0.2, 10.5, -0.2), (2.7, 1.5, 2.7), STONE, bevel=0.08)
    roof = hull([(x, 12.0, z) for x in (-1.6, 2.0) for z in (-2.0, 1.6)] + [(0.2, 14.6, -0.2)])
    p.solid(roof, TILES)
    for x, y, z, lit in ((-0.9, 2.6, 2.31, False), (0.9, 3.3, 2.30, False), (0.2, 6.4, 2.14, True), (-1.1, 8.0, 2.08, False), (1.1, 8.1, 2.08, False), (0.2, 10.8, 1.16, False)):
        window(p, x, y, z, lit)
    for x in (-2.1, 2.1):
        p.block((x, 1.2, 2.2), (0.7, 3.2, 0.7), DARK, bevel=0, taper=0.7)
    return p


def tower_ruin():
    p = Piece("tower_ruin", ground=False, dirt=0.25)
    p.block((0, -UNDER, 0), (6.0, UNDER + 1.6, 6.0), DARK, bevel=0.25, taper=0.86)
    p.block((0, 1.5, 0), (4.7, 3.6, 4.7), STONE, bevel=0.15, taper=0.96)
    p.block((0, 5.0, 0), (4.8, 0.34, 4.8), PALE, bevel=0.06, chips=3)
    heights = ((-1.95, 5.2), (-1.1, 3.9), (-0.3, 2.1), (0.5, 1.5), (1.25, 0.9), (1.95, 0.6))
    for x, height in heights:
        p.block((x, 5.3, 1.85), (0.84, height, 0.5), STONE.shifted(p.rng.uniform(0.9, 1.08)), bevel=0, chips=2)
        if x < 0.8:
            p.block((x, 5.3, -1.85), (0.84, height * p.rng.uniform(0.9, 1.25), 0.5), DARK, bevel=0.0, chips=1)
    for z, height in ((-1.1, 5.6), (-0.3, 6.6), (0.5, 6.0), (1.2, 5.6)):
        p.block((-1.95, 5.3, z), (0.5, height, 0.84), STONE, bevel=0, chips=1)
    for x, y, z, lit in ((-0.9, 2.4, 2.31, False), (1.0, 3.0, 2.30, False), (-1.1, 6.6, 2.10, False)):
        window(p, x, y, z, lit)
    for x, y, z, s in ((2.6, 1.4, 2.0, 0.6), (1.9, 1.5, 2.6, 0.4), (3.1, 0.9, 1.4, 0.4)):
        p.solid(boulder(p.rng, (s, s * 0.7, s), 10), STONE, (x, y, z))
    return p


def aqueduct():
    """Three bays, the last one broken off."""
    p = Piece("aqueduct", ground=False, dirt=0.2)
    bay, top, thick = 8.0, 14.2, 1.5
    for i, x in enumerate((-12.0, -4.0, 4.0, 12.0)):
        high = 10.4 if i < 3 else 6.2
        p.block((x, -UNDER, 0), (2.7, UNDER + 0.8, 2.9), DARK, bevel=0, taper=0.9)
        p.block((x, 0.7, 0), (2.0, high - 0.7, 2.1), STONE, bevel=0.1 if i < 3 else 0, taper=0.92, chips=0 if i < 3 else 4)
        if i < 3:
            p.block((x, 9.7, 0), (2.5, 0.42, 2.5), PALE, bevel=0)
    inner = bay / 2 - 0.95
    for i, x in enumerate((-8.0, 0.0, 8.0)):
        count = 6
        for k in range(count):
            if i == 2 and k < 4:
                continue
            a, b = (math.pi * (k + d) / count for d in (0, 1))
            ring = [(x + r * math.cos(t), 10.1 + r * 0.9 * math.sin(t)) for r, t in ((inner, a), (inner, b), (inner + 0.95, b), (inner + 0.95, a))]
            p.solid(prism(ring, -0.95, 0.95 + 0.1 * (k % 2)), PALE if k % 2 else STONE)
        if i < 2:  # the wall between arch and channel
            for side in (-1, 1):
                corner = [(x + side * 4.0, 10.2), (x + side * 4.0, top), (x + side * 0.4, top), (x + side * 2.2, 13.1), (x + side * 3.4, 11.6)]
                for z, order in ((0.8, side), (-0.8, -side)):
                    p.poly([(u, v, z) for u, v in corner][::-order], STONE)
    p.block((-4.2, top - 0.1, 0), (16.6, 0.5, 2.4), PALE, bevel=0.08)
    for z in (-0.95, 0.95):
        for x, length in ((-8.6, 7.8), (-0.4, 7.6))[: 2 if z > 0 else 1]:
            p.block((x, top + 0.35, z), (length, 0.95, 0.42), STONE, bevel=0, chips=1)
    p.block((4.9, top - 1.3, 0), (1.5, 1.4, 1.6), STONE, bevel=0, chips=4)
    for x, y, s in ((9.6, -0.4, 1.1),):
        p.solid(boulder(p.rng, (s, s * 0.8, s), 10), STONE, (x, y, 0.9))
    return p


def cliff_stack():
    p = Piece("cliff_stack", ground=False, dirt=0.25)
    levels = ((-UNDER, 6.6, 13.0, 0, 0), (2.4, 5.2, 7.0, 0.5, -0.2), (8.6, 4.2, 6.4, -0.5, 0.1), (14.2, 2.7, 5.0, 0.6, -0.3), (18.4, 1.5, 2.2, 1.1, -0.2))
    for y, r, height, x, z in levels:
        solid = drum(r, r * 0.80, height, 8, p.rng.random())
        for _ in range(6):
            a = p.rng.uniform(0, 2 * math.pi)
            solid = solid.cut(vec(math.cos(a), p.rng.uniform(0.15, 0.7), math.sin(a)), r * p.rng.uniform(0.84, 1.02) + 0.35 * height, "face")
        p.solid(solid, CLIFF.shifted(p.rng.uniform(0.92, 1.05)), (x, y, z), turned(z=p.rng.uniform(-3, 3)))
    for x, y, z, s in ((4.6, 1.6, 2.6, 1.6), (-4.6, 1.4, 2.2, 1.9), (3.9, 8.2, 1.6, 1.1), (-3.4, 14.0, 1.2, 1.0)):
        p.solid(boulder(p.rng, (s, s, s), 12), CLIFF, (x, y, z))
    return p


def windmill():
    p = Piece("windmill", ground=False, dirt=0.2)
    p.block((0, -UNDER, 0), (5.4, UNDER + 0.4, 5.4), DARK, bevel=0.2, taper=0.9)
    p.solid(drum(2.2, 1.45, 7.6, 8, 0.5).bevel(0.1, p.rng), PALE.shifted(0.92), (0, 0.3, 0))
    p.solid(drum(2.45, 2.3, 0.5, 8, 0.5), STONE, (0, 0.2, 0))
    p.solid(drum(1.66, 1.66, 0.34, 8, 0.5), WOOD, (0, 7.8, 0))
    p.solid(hull([(1.55 * math.cos(a), 8.1, 1.55 * math.sin(a)) for a in (k * math.pi / 4 + 0.39 for k in range(8))] + [(-0.3, 9.8, -0.2), (0.3, 9.8, 0.2)]), TILES)
    hub = vec(0, 8.3, 2.0)
    p.beam((0, 8.3, 0.8), tuple(hub), 0.16, WOOD)
    p.lathe([(-0.2, 0.30), (0.25, 0.22)], 6, IRON, tuple(hub), turned(x=90))
    for k in range(4):
        a = math.radians(24 + 90 * k)
        d, s = vec(math.cos(a), math.sin(a), 0), vec(-math.sin(a), math.cos(a), 0)
        length = 5.4 if k != 2 else 3.2
        p.beam(tuple(hub), tuple(hub + d * length), 0.09, WOOD)
        if k == 2:
            continue
        for i in range(1, 7, 1 + (k == 3)):
            at = hub + d * (0.9 + 0.72 * i)
            p.beam(tuple(at), tuple(at + s * 1.15), 0.035, OLD_WOOD)
        p.beam(tuple(hub + d * 1.5 + s * 1.15), tuple(hub + d * 5.3 + s * 1.15), 0.035, OLD_WOOD)
        for i, keep in enumerate(((1, 1, 0, 1, 1), (1, 0, 1, 1, 0), (), (0, 1, 1, 0, 1))[k]):
            if keep:
                u, v = 1.62 + 0.72 * i, 2.34 + 0.72 * i
                sail = [hub + d * u + s * 0.1, hub + d * v + s * 0.1, hub + d * v + s * 1.1, hub + d * u + s * 1.1]
                p.poly([q + vec(0, 0, 0.05) for q in sail], BONE.shifted(0.85), both=True)
    for x, y, z, lit in ((0.1, 2.6, 2.02, False), (-0.1, 5.2, 1.76, False)):
        window(p, x, y, z, lit, 0.38, 0.74)
    door = [(-0.5, 0.7), (0.5, 0.7), (0.5, 2.0), (0, 2.4), (-0.5, 2.0)]
    p.poly([(1.15 + u * 0.7, v - 0.2, 2.06 - 0.35 * (u + 0.5)) for u, v in door], VOID)
    return p


def crane():
    """Two trestles, the jib to the right, ropes, a counterweight, a block of stone that was never set down."""
    p = Piece("crane", sway=0.04, dirt=0.2)
    for z in (-0.9, 0.9):
        apex = (0, 5.3, z * 0.25)
        p.beam((-1.45, -0.6, z), apex, 0.17, WOOD, 0.04)
        p.beam((1.45, -0.6, z), apex, 0.17, WOOD, 0.04)
        p.beam((-1.05, 1.3, z * 0.82), (1.05, 1.3, z * 0.82), 0.11, OLD_WOOD)
        p.beam((-0.6, 3.2, z * 0.5), (0.6, 3.2, z * 0.5), 0.10, OLD_WOOD)
    p.beam((0.95, 1.5, -0.75), (0.95, 1.5, 0.75), 0.09, OLD_WOOD)
    p.beam((-2.9, 4.0, 0), (4.9, 7.5, 0), 0.18, WOOD, 0.04, end=0.7)
    p.beam((0, 4.9, 0), (0.1, 7.3, 0), 0.14, WOOD, 0.03)
    for end in ((4.7, 7.42, 0), (-2.6, 4.2, 0), (2.3, 6.38, 0)):
        p.tube([(0.1, 7.2, 0), end], 0.055, 3, ROPE, caps=False)
    for x in (1.1, 3.4):
        p.block((x, 5.55 + 0.45 * x - 0.05, 0), (0.16, 0.42, 0.46), IRON, turn=turned(z=24))
    p.block((-2.75, 2.65, 0), (1.35, 1.15, 1.15), STONE, bevel=0.06, chips=2)
    for z in (-0.4, 0.4):
        p.tube([(-2.7, 4.15, 0), (-2.75, 3.75, z)], 0.055, 3, ROPE, caps=False)
    p.tube([(4.75, 7.35, 0), (4.75, 3.6, 0)], 0.055, 3, ROPE, caps=False)
    p.block((4.75, 3.32, 0), (0.28, 0.36, 0.22), IRON, bevel=0.03)
    for x in (-0.55, 0.55):
        p.tube([(4.75, 3.34, 0), (4.75 + x, 2.75, 0)], 0.05, 3, ROPE, caps=False)
    p.block((4.75, 1.9, 0), (1.35, 0.88, 1.0), PALE, bevel=0.06, chips=2, turn=turned(y=14))
    p.lathe([(-0.5, 0.32), (0.5, 0.32)], 8, ROPE, (0.0, 2.05, 0), turned(x=90))
    p.lathe([(-0.62, 0.12), (0.62, 0.12)], 6, OLD_WOOD, (0.0, 2.05, 0), turned(x=90))
    p.tube([(0.2, 2.3, 0), (0.12, 7.25, 0)], 0.05, 3, ROPE, caps=False)
    return p


PIECES = [tower, tower_ruin, aqueduct, cliff_stack, windmill, crane]
