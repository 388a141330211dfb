"""Broken machinery of the quarry: gears, press, winch, pipe, boiler, treadwheel, pulley; chain and rope."""

import math

from pieces_kit import BRASS, DARK, IRON, OLD_WOOD, ROPE, RUST, WOOD, Paint, Piece, drum, turned, vec
from pieces_lamps import link

DEEP = Paint(0x1E1C22, 0.04)
STEEL = Paint(0x5A5C66, 0.10, 0x7C7A7A, 0.4, 0.3)


def wheel(p, centre, outer, inner, teeth, half, paint, missing=(), spokes=5, hub=0.16, sector=None, tooth=0.14):
    """A toothed wheel that faces the camera; teeth in `missing` are broken off, `sector` (of 0..1) is left of the rim."""
    centre = vec(*centre)
    first, last = sector or (0.0, 1.0)
    steps = 4 * teeth
    flanks = (0.0, 0.16, 0.52, 0.68)  # where root, rise, head and fall of a tooth begin

    def radius(step):
        index, part = divmod(step, 4)
        broken = index % teeth in missing
        return outer - tooth * outer * (1.0 if part in (0, 3) else (0.65 if broken else 0.0))

    def at(r, step, z):
        a = 2 * math.pi * (step // 4 + flanks[step % 4]) / teeth
        return centre + vec(r * math.cos(a), r * math.sin(a), z)

    low, high = int(first * steps), int(last * steps)
    for step in range(low, high):
        ra, rb = radius(step), radius(step + 1)
        front = [at(inner, step, half), at(ra, step, half), at(rb, step + 1, half), at(inner, step + 1, half)]
        p.poly(front, paint)
        p.poly([q - vec(0, 0, 2 * half) for q in front[::-1]], paint)
        p.poly([at(ra, step, half), at(ra, step, -half), at(rb, step + 1, -half), at(rb, step + 1, half)], paint, "worn")
        if step % 2 == 0:
            stop = min(step + 2, high)
            p.poly([at(inner, stop, half), at(inner, stop, -half), at(inner, step, -half), at(inner, step, half)], paint)
    if sector:
        for step, way in ((low, 1), (high, -1)):
            r = radius(step)
            end = [at(inner, step, half), at(inner, step, -half), at(r, step, -half), at(r, step, half)]
            p.poly(end[::way], paint, "worn")
    for k in range(spokes):
        a = 2 * math.pi * (k + 0.3) / spokes
        direction = vec(math.cos(a), math.sin(a), 0)
        whole = sector is None or first <= (k + 0.3) / spokes <= last
        end = centre + direction * (inner + 0.04 if whole else inner * 0.55)
        p.beam(centre + direction * hub * 0.6, end, half * 0.75, paint, end=0.7)
    turn = turned(x=90)
    p.lathe([(-half * 1.5, hub), (half * 1.5, hub), (half * 1.8, hub * 0.7)], 8, paint, centre, turn)
    p.lathe([(half * 1.75, hub * 0.45), (half * 2.6, hub * 0.4)], 6, BRASS.shifted(0.8), centre, turn)


def gear():
    """Half sunk in the ground, a quarter of its rim broken out."""
    p = Piece("gear", dirt=0.35)
    wheel(p, (0, 1.02, 0), 1.55, 1.12, 12, 0.16, RUST, missing=(3,), sector=(0.18, 0.99), hub=0.24)
    return p


def gear_small():
    """On its shaft, in a worn bearing."""
    p = Piece("gear_small", dirt=0.3)
    wheel(p, (0, 0.86, 0.10), 0.70, 0.46, 9, 0.09, STEEL, missing=(2,), spokes=4, hub=0.13)
    p.beam((0, 0.86, -0.5), (0, 0.86, 0.12), 0.06, IRON)
    p.block((0, 0.0, -0.28), (0.62, 0.14, 0.5), DARK, bevel=0.03)
    p.block((0, 0.13, -0.28), (0.40, 0.82, 0.26), OLD_WOOD, bevel=0.03, taper=0.75)
    p.block((0, 0.90, -0.28), (0.36, 0.12, 0.30), IRON, bevel=0.02)
    return p


def press():
    p = Piece("press", dirt=0.3)
    p.block((0, 0, 0), (2.3, 0.34, 1.2), DARK, bevel=0.05, chips=2)
    for x in (-0.86, 0.86):
        p.block((x, 0.32, 0), (0.30, 2.44, 0.36), WOOD, bevel=0.035)
        for y in (0.62, 2.2):
            p.block((x, y, 0), (0.36, 0.10, 0.42), IRON, bevel=0.0)
    p.block((0, 2.62, 0), (2.36, 0.42, 0.50), WOOD, bevel=0.05, chips=1)
    thread = [(1.25 + 0.17 * i, 0.13 if i % 2 else 0.085) for i in range(11)]
    p.lathe(thread, 7, STEEL)
    p.lathe([(3.0, 0.20), (3.16, 0.20), (3.24, 0.12)], 7, IRON)
    p.beam((-0.72, 3.10, 0.0), (0.72, 3.16, 0.0), 0.045, OLD_WOOD)
    p.block((0, 1.06, 0), (1.30, 0.24, 0.86), IRON, bevel=0.04)
    p.block((0, 0.96, 0), (1.16, 0.12, 0.74), RUST, bevel=0.02)
    p.block((0.05, 0.33, 0), (1.0, 0.20, 0.7), STEEL, bevel=0.03, turn=turned(y=4))
    p.block((0.1, 0.52, 0.02), (0.66, 0.24, 0.46), DARK.shifted(1.3), bevel=0.03, chips=3, turn=turned(y=-12))
    return p


def winch():
    p = Piece("winch", dirt=0.3)
    for x in (-0.72, 0.72):
        p.beam((x, 0, 0.50), (x, 1.18, 0.02), 0.075, WOOD, 0.015)
        p.beam((x, 0, -0.50), (x, 1.18, -0.02), 0.075, WOOD, 0.015)
        p.beam((x, 0.32, 0.40), (x, 0.32, -0.40), 0.05, WOOD)
        p.block((x, 1.06, 0), (0.20, 0.22, 0.24), IRON, bevel=0.02)
    for z in (0.46, -0.46):
        p.beam((-0.9, 0.06, z), (0.9, 0.06, z), 0.07, WOOD, 0.015)
    side = turned(z=90)
    p.lathe([(-0.64, 0.20), (0.64, 0.20)], 9, OLD_WOOD, (0, 1.10, 0), side)
    coil = [(-0.46, 0.22)] + [(-0.43 + 0.1 * i, 0.31 if i % 2 else 0.255) for i in range(9)] + [(0.40, 0.22)]
    p.lathe(coil, 8, OLD_WOOD.shifted(0.8), (0.03, 1.10, 0), side)
    p.beam((-1.02, 1.10, 0), (1.02, 1.10, 0), 0.05, IRON)
    p.beam((1.0, 1.10, 0), (1.0, 0.62, 0.16), 0.05, IRON)
    p.beam((0.98, 0.62, 0.16), (1.28, 0.62, 0.16), 0.05, WOOD)
    p.beam((-1.0, 1.10, 0), (-1.0, 1.56, -0.16), 0.05, IRON)
    p.beam((-0.98, 1.56, -0.16), (-1.28, 1.56, -0.16), 0.05, WOOD)
    p.tube([(0.2, 0.82, 0.20), (0.24, 0.3, 0.42), (0.5, 0.05, 0.62), (0.95, 0.03, 0.72)], 0.05, 4, OLD_WOOD.shifted(0.8))
    return p


def pipe():
    """An elbow comes out of the ground, runs to the right and ends in a torn mouth."""
    p = Piece("pipe", dirt=0.3)
    r = 0.30
    path = [(-1.2, -0.2, 0), (-1.2, 0.62, 0), (-1.10, 0.92, 0), (-0.86, 1.10, 0), (-0.55, 1.14, 0), (1.35, 1.14, 0)]
    p.tube(path, r, 9, RUST, caps=False)
    side = turned(z=90)
    for x in (-0.45, 0.52):
        p.lathe([(-0.06, r + 0.10), (0.06, r + 0.10)], 9, IRON, (x, 1.14, 0), side)
    p.lathe([(0.50, r + 0.10), (0.62, r + 0.10)], 9, IRON, (-1.2, 0, 0))
    for k in range(7):  # torn metal around the mouth
        a, b = (2 * math.pi * (k + d) / 7 for d in (0, 0.8))
        low = [vec(1.33, 1.14 + r * math.cos(t), r * math.sin(t)) for t in (a, b)]
        tip = vec(1.33 + p.rng.uniform(0.14, 0.42), 1.14 + r * 1.5 * math.cos(a + 0.2), r * 1.5 * math.sin(a + 0.2))
        p.poly([low[0], low[1], tip], RUST, "worn", both=True)
    p.lathe([(0.0, r * 0.96), (0.02, 0.0)], 9, DEEP, (1.30, 1.14, 0), turned(z=-90))
    p.block((0.55, 0, 0), (0.50, 0.84, 0.42), DARK, bevel=0.04, chips=2, taper=0.8)
    p.beam((0.2, 0.80, 0), (0.9, 0.80, 0), 0.05, IRON)
    wheel(p, (-0.45, 1.14, 0.55), 0.26, 0.20, 6, 0.025, STEEL, spokes=3, hub=0.06, tooth=0.05)
    p.beam((-0.45, 1.14, 0.3), (-0.45, 1.14, 0.55), 0.03, IRON)
    return p


def boiler():
    """A lying boiler, burst open in its flank."""
    p = Piece("boiler", dirt=0.35)
    r, y, sides = 1.0, 1.32, 14
    shell = RUST.shifted(0.88)
    xs = [-1.55, -0.95, -0.3, 0.35, 0.95, 1.55]

    def at(x, k, radius):
        a = 2 * math.pi * (k + 0.5) / sides
        return vec(x, y + radius * math.sin(a), radius * math.cos(a))

    hole = {(2, 0), (2, 1), (2, 2), (1, 1), (3, 1)}  # bands and staves that are gone
    for i in range(5):
        for k in range(sides):
            if (i, k) in hole:
                continue
            p.poly([at(xs[i], k, r), at(xs[i], k + 1, r), at(xs[i + 1], k + 1, r), at(xs[i + 1], k, r)][::-1], shell)
            if k < 5:
                p.poly([at(xs[i], k, r * 0.97), at(xs[i], k + 1, r * 0.97), at(xs[i + 1], k + 1, r * 0.97), at(xs[i + 1], k, r * 0.97)], DEEP)
    for i, k, dx in ((2, 0, 0.5), (2, 2, 0.5), (1, 1, 0.9), (3, 1, 0.1)):  # metal bent outwards
        a, b = at(xs[i], k, r), at(xs[i + 1], k + 1, r)
        tip = at(xs[i] + 0.6 * dx, k + (1.6 if k == 2 else -0.4 if k == 0 else 0.5), r * 1.35)
        p.poly([a, b, tip], RUST, "worn", both=True)
    for side in (-1, 1):
        ends = [at(1.55 * side, k, r) for k in range(sides)]
        dome = [at(1.86 * side, k, r * 0.55) for k in range(sides)]
        for k in range(sides):
            j = (k + 1) % sides
            quad = [ends[k], ends[j], dome[j], dome[k]]
            p.poly(quad[::-1] if side > 0 else quad, shell)
        p.poly(dome[::-1] if side > 0 else dome, shell)
        p.lathe([(-0.05, r + 0.07), (0.05, r + 0.07)], sides, IRON, (1.2 * side, y, 0), turned(z=90))
    for x in (-1.0, 1.0):
        p.block((x, 0, 0), (0.5, 0.62, 1.5), DARK, bevel=0.05, chips=1, taper=0.9)
    p.lathe([(2.2, 0.30), (2.5, 0.28), (2.62, 0.18)], 8, shell, (-0.75, 0, 0))
    p.lathe([(2.2, 0.17), (3.0, 0.15)], 7, IRON, (0.95, 0, 0), turned(z=-4))
    p.lathe([(2.98, 0.22), (3.08, 0.22)], 7, IRON, (0.95, 0, 0), turned(z=-4))
    return p


def treadwheel():
    p = Piece("treadwheel", dirt=0.25)
    centre, r, n = (0, 2.25, 0), 2.0, 12

    def at(k, radius, z):
        a = 2 * math.pi * k / n
        return (radius * math.cos(a), centre[1] + radius * math.sin(a), z)

    for z in (-0.55, 0.55):
        for k in range(n):
            if z > 0 and k in (1, 2):  # broken out
                continue
            p.beam(at(k, r, z), at(k + 1, r, z), 0.075, WOOD, depth=0.06)
        for k in (0, 2, 4, 6, 8, 10):
            end = 0.5 if z > 0 and k == 2 else 1.0
            p.beam(centre[:2] + (z,), at(k, r * end, z), 0.05, WOOD)
    for k in range(n):
        if k in (2, 3, 7, 10):
            continue
        a, b = at(k + 0.12, r * 0.97, -0.62), at(k + 0.12, r * 0.97, 0.62)
        p.beam(a, b, 0.13, OLD_WOOD, depth=0.03)
    p.lathe([(-0.9, 0.14), (0.9, 0.14)], 7, OLD_WOOD, centre, turned(x=90))
    for z in (-0.86, 0.86):
        for x in (-1.15, 1.15):
            p.beam((x, 0, z), (0.1 * x, 2.36, z), 0.10, WOOD)
        p.block((0, 2.16, z), (0.36, 0.24, 0.18), IRON, bevel=0.02)
    return p


def pulley():
    p = Piece("pulley", sway=0.25, ground=False, dirt=0.0)
    p.tube([(0, 0.05, 0), (0.0, -0.9, 0)], 0.055, 4, ROPE, caps=False)
    for z in (-0.11, 0.11):
        p.block((0, -1.42, z), (0.30, 0.60, 0.05), WOOD, bevel=0.03)
    p.lathe([(-0.07, 0.19), (-0.02, 0.14), (0.02, 0.14), (0.07, 0.19)], 8, BRASS.shifted(0.8), (0, -1.12, 0), turned(x=90))
    p.beam((0, -1.12, -0.18), (0, -1.12, 0.18), 0.035, IRON)
    p.tube([(0.17, -1.1, 0), (0.18, 0.05, 0)], 0.05, 4, ROPE, caps=False)
    p.tube([(0, -1.40, 0), (0, -1.56, 0), (0.10, -1.68, 0), (0.13, -1.82, 0), (0.03, -1.95, 0), (-0.11, -1.90, 0), (-0.15, -1.78, 0)],
           [0.055, 0.06, 0.07, 0.075, 0.07, 0.06, 0.0], 5, IRON)  # fmt: skip
    return p


def chain():
    p = Piece("chain", sway=0.12, ground=False, dirt=0.0)
    for i in range(7):
        link(p, (0, 0.05 - 0.565 * i, 0), 0.32, 0.15, i % 2, RUST.shifted(0.8) if i % 3 else IRON, 0.058, 4)
    return p


def rope():
    p = Piece("rope", sway=0.3, ground=False, dirt=0.0)
    path = [(0.04 * math.sin(i * 1.9), 0.05 - 0.63 * i, 0.02 * math.cos(i)) for i in range(7)]
    p.tube(path, 0.055, 5, ROPE)
    x, y, z = path[-1]
    p.lathe([(-0.20, 0.06), (-0.14, 0.13), (-0.04, 0.14), (0.04, 0.07)], 6, ROPE.shifted(0.9), (x, y, z))
    for k in range(5):
        a = k * 1.26
        p.poly([(x + 0.02, y - 0.14, z), (x - 0.02, y - 0.14, z), (x + 0.09 * math.cos(a), y - 0.42 + 0.05 * (k % 3), z + 0.09 * math.sin(a))], ROPE, both=True)
    return p


PIECES = [gear, gear_small, press, winch, pipe, boiler, treadwheel, pulley, chain, rope]
