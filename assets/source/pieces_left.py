"""What people have left behind: crates, barrels, a cart, a ladder, a scaffold."""

import math

from pieces_kit import IRON, OLD_WOOD, ROPE, STONE, WOOD, Paint, Piece, boulder, times, turned, vec

SACK = Paint(0x9C8763, 0.10)
INSIDE = Paint(0x4A372B, 0.08)


def crate_at(p, at, size, turn, wood=WOOD):
    """Boards between stouter edges, a brace across the front."""
    half, bar = size / 2, size * 0.07

    def block(centre, extent, paint, spin=None, bevel=0.0):
        from pieces_kit import box

        solid = box(extent).moved(offset=(0, -extent[1] / 2, 0)).moved(spin, (0, 0, 0)).moved(offset=centre)
        p.solid(solid.bevel(bevel, p.rng) if bevel else solid, paint, at, turn)

    inner = size - 2.2 * bar
    for k in range(3):
        y = size * (0.2 + 0.3 * k)
        block((0, y, 0), (inner + 0.02 * (k % 2), size * 0.285, inner), wood.shifted(0.82 + 0.09 * (k % 2)))
    for x in (-1, 1):
        for z in (-1, 1):
            block((x * (half - bar), half, z * (half - bar)), (2 * bar, size, 2 * bar), wood, bevel=0.012)
    for y in (bar, size - bar):
        for z in (-1, 1):
            block((0, y, z * (half - bar)), (size * 0.8, 2 * bar, 1.9 * bar), wood.shifted(1.05))
        for x in (-1, 1):
            block((x * (half - bar), y, 0), (1.9 * bar, 2 * bar, size * 0.8), wood.shifted(1.05))
    block((0, half, half - bar * 0.9), (size * 1.04, 1.6 * bar, bar), wood.shifted(1.1), turned(z=38))


def crate():
    p = Piece("crate", dirt=0.3)
    crate_at(p, (0, 0, 0), 0.92, turned(y=7))
    return p


def crates():
    p = Piece("crates", dirt=0.3)

    def plain(at, size, degrees, wood):
        turn = turned(y=degrees)
        p.block(at, (size, size, size), wood.shifted(0.85), bevel=0.02, turn=turn)
        band = size * 1.06
        for y in (0.0, 0.88):
            p.block(vec(*at) + vec(0, y * size, 0), (band, size * 0.14, band), wood.shifted(1.1), bevel=0.012, turn=turn)
        p.block(vec(*at) + times(turn, vec(0, 0.12 * size, size * 0.5)), (size * 0.16, size * 0.76, 0.05), wood.shifted(1.1), turn=turn)

    plain((-0.50, 0, 0), 0.92, 6, WOOD)
    plain((0.48, 0, -0.08), 0.78, -11, OLD_WOOD)
    plain((-0.22, 0.92, -0.02), 0.66, 24, WOOD.shifted(0.9))
    p.lathe([(0.0, 0.24), (0.16, 0.31), (0.40, 0.24), (0.50, 0.07), (0.60, 0.12)], 7, SACK, (0.34, 0, 0.52), turned(z=-6))
    p.lathe([(0.0, 0.20), (0.14, 0.25), (0.30, 0.18), (0.37, 0.05), (0.44, 0.09)], 7, SACK.shifted(0.9), (0.80, 0, 0.50), turned(z=8))
    return p


def barrel():
    p = Piece("barrel", dirt=0.3)
    profile = [(0.0, 0.29), (0.12, 0.335), (0.22, 0.36), (0.50, 0.40), (0.78, 0.36), (0.88, 0.335), (1.0, 0.29)]
    sides = 11
    for (y0, r0), (y1, r1) in zip(profile, profile[1:]):
        for k in range(sides):
            a, b = (2 * math.pi * (k + d) / sides for d in (0, 1))
            tone = WOOD.shifted(0.86 + 0.28 * ((k * 7919) % 5) / 5)
            p.poly([(r0 * math.cos(a), y0, -r0 * math.sin(a)), (r0 * math.cos(b), y0, -r0 * math.sin(b)), (r1 * math.cos(b), y1, -r1 * math.sin(b)), (r1 * math.cos(a), y1, -r1 * math.sin(a))], tone)
    for y, r in ((0.17, 0.365), (0.80, 0.375)):
        p.lathe([(y - 0.045, r - 0.012), (y + 0.045, r + 0.004)], sides, IRON, spin=0.0)
    p.lathe([(0.94, 0.30), (0.95, 0.0)], sides, INSIDE)
    p.lathe([(1.0, 0.29), (1.0, 0.25), (0.94, 0.24)], sides, WOOD.shifted(1.1), spin=0.0)
    return p


def wheel(p, at, r, turn, broken=False):
    n = 8

    def place(k, radius, z):
        a = 2 * math.pi * k / n
        return vec(*at) + times(turn, vec(radius * math.cos(a), radius * math.sin(a), z))

    for k in range(n):
        if broken and k in (1, 2):
            continue
        p.beam(place(k, r * 0.94, 0), place(k + 1, r * 0.94, 0), 0.05, OLD_WOOD, depth=0.05)
    for k in range(0, n, 2 if broken else 4):
        end = 0.55 if broken and k == 2 else 0.92
        p.beam(place(k, 0.08, 0), place(k, r * end, 0), 0.028, OLD_WOOD)
    p.lathe([(-0.09, 0.10), (0.09, 0.10)], 6, IRON, at, times(turn, turned(x=90)))


def cart():
    p = Piece("cart", dirt=0.3)
    tilt = turned(z=-7)

    def at(x, y, z):
        return times(tilt, vec(x, y, z)) + vec(0, 0.62, 0)

    for k in range(4):
        z = -0.42 + 0.28 * k
        p.beam(at(-1.0, 0, z), at(1.0, 0, z), 0.03, WOOD.shifted(0.9 + 0.08 * (k % 2)), depth=0.13)
    for z in (-0.58, 0.58):
        p.beam(at(-1.0, 0.16, z), at(1.02, 0.16, z), 0.12, WOOD, depth=0.035)
        p.beam(at(-1.0, 0.40, z), at(0.5, 0.40, z), 0.09, WOOD.shifted(0.9), depth=0.035)
        for x in (-0.85, 0.5):
            p.beam(at(x, -0.06, z * 1.07), at(x, 0.52, z * 1.07), 0.04, OLD_WOOD)
        p.beam(at(-1.0, 0.02, z * 0.6), at(-1.95, 0.16, z * 0.5), 0.04, OLD_WOOD)
    p.beam(at(-0.96, 0.25, -0.55), at(-0.96, 0.25, 0.55), 0.035, WOOD, depth=0.2)
    p.beam(at(0.3, -0.12, -0.72), at(0.3, -0.12, 0.72), 0.05, IRON)
    wheel(p, (0.32, 0.50, 0.72), 0.50, turned(), broken=True)
    wheel(p, (0.32, 0.50, -0.72), 0.50, turned())
    for x, y, z, size in ((0.25, 0.22, 0.1, 0.34), (-0.4, 0.20, -0.12, 0.30), (0.68, 0.18, -0.1, 0.27)):
        p.solid(boulder(p.rng, (size, size * 0.75, size), 9), STONE, at(x, y, z), turned(y=p.rng.uniform(0, 90)))
    return p


def ladder():
    p = Piece("ladder", dirt=0.2)
    lean = 0.32

    def at(x, y):
        return (x, y, lean * (0.5 - y / 3.0) * 2)

    for x in (-0.26, 0.26):
        p.beam(at(x, -0.05), at(x * 0.9, 3.05), 0.055, OLD_WOOD, 0.01)
    for k in range(8):
        if k == 5:  # broken rung
            p.beam(at(-0.28, 2.08), at(-0.02, 1.98), 0.026, WOOD)
            continue
        y = 0.28 + 0.36 * k
        p.beam(at(-0.30, y), at(0.30, y + 0.02 * (k % 3 - 1)), 0.028, WOOD)
    return p


def scaffold():
    p = Piece("scaffold", dirt=0.2)
    for z in (-0.55, 0.55):
        for x in (-2.0, 0.05, 2.05):
            top = 4.5 + 0.25 * ((x + z) % 1)
            p.beam((x, -0.3, z), (x + 0.06, top, z), 0.06, OLD_WOOD, 0.012)
        for y in (1.9, 3.7):
            p.beam((-2.3, y, z * 1.08), (2.35, y + 0.05, z * 1.08), 0.05, OLD_WOOD)
    p.beam((-2.0, 0.1, 0.64), (0.05, 3.7, 0.64), 0.055, OLD_WOOD)
    p.beam((2.05, 2.0, 0.64), (0.05, 3.9, 0.64), 0.055, OLD_WOOD)
    for y, ends in ((1.98, (-2.25, 2.2)), (3.78, (-2.2, 1.1))):
        for k, z in enumerate((-0.45, -0.15, 0.15, 0.45)):
            a, b = ends[0] + 0.1 * p.rng.uniform(-1, 1), ends[1] + 0.15 * p.rng.uniform(-1, 1)
            p.beam((a, y, z), (b, y + 0.03, z), 0.03, WOOD.shifted(0.85 + 0.1 * (k % 2)), depth=0.14)
    for x in (-2.0, 0.05, 2.05):
        for y in (1.9, 3.7):
            p.block((x + 0.03, y - 0.08, 0.58), (0.2, 0.18, 0.2), ROPE, bevel=0)
    return p


PIECES = [crate, crates, barrel, cart, ladder, scaffold]
