"""Lanterns: on a post, on a bracket at the wall, on a chain; lit or dead."""

import math

from pieces_kit import DARK, FLAME, GLASS, IRON, OLD_WOOD, RUST, Piece, times, turned, vec

COLOUR = (3.4, 1.75, 0.60)  # linear light of a flame
REACH = 9.0


def lamp(p, top, lit, size=1.0, tilt=0.0):
    """A six-sided lamp that hangs from `top`: ring, roof, panes between bars, foot. 0.62 m tall at size 1."""
    top = vec(*top)
    lean = turned(z=tilt)
    metal = IRON if lit else RUST.shifted(0.75)

    def place(y):
        return top + times(lean, vec(0, y * size, 0))

    p.lathe([(-0.10, 0.025), (0.0, 0.025)], 5, metal, place(0), lean)
    roof = [(h * size, r * size) for h, r in ((-0.30, 0.20), (-0.25, 0.21), (-0.16, 0.09), (-0.09, 0.06))]
    p.lathe(roof, 6, metal, top, lean)
    panes = [(h * size, r * size) for h, r in ((-0.56, 0.105), (-0.30, 0.155))]
    if lit:
        p.lathe(panes, 6, FLAME, top, lean)
    else:  # two panes are left
        for side in (1, 4):
            a, b = (2 * math.pi * (side + k + 0.5) / 6 for k in (0, 1))
            ring = [(r * math.cos(t), y, -r * math.sin(t)) for (y, r), t in ((panes[0], a), (panes[0], b), (panes[1], b))]
            p.poly([top + times(lean, vec(*q)) for q in ring], GLASS, both=True)
    for i in range(6):
        t = 2 * math.pi * (i + 0.5) / 6
        low = top + times(lean, vec(0.125 * size * math.cos(t), -0.57 * size, -0.125 * size * math.sin(t)))
        high = top + times(lean, vec(0.175 * size * math.cos(t), -0.29 * size, -0.175 * size * math.sin(t)))
        p.tube([low, high], 0.026 * size, 3, metal, caps=False)
    p.lathe([(-0.62 * size, 0.09 * size), (-0.56 * size, 0.15 * size), (-0.54 * size, 0.14 * size)], 6, metal, top, lean)
    if lit:
        p.light(place(-0.42), REACH * size, COLOUR)


def post(lit):
    p = Piece("lantern" if lit else "lantern_dead", dirt=0.35)
    p.block((0, -0.15, 0), (0.52, 0.30, 0.50), DARK, bevel=0.05, chips=2, taper=0.85)
    p.block((0, 0.13, 0), (0.36, 0.20, 0.36), DARK.shifted(1.15), bevel=0.04, taper=0.75)
    p.beam((0.0, 0.2, 0), (-0.05, 1.35, 0), 0.075, OLD_WOOD, 0.018, end=0.85)
    p.beam((-0.05, 1.30, 0), (0.03, 2.62, 0), 0.064, OLD_WOOD, 0.016, end=0.8)
    p.beam((-0.22, 2.36, 0), (0.56, 2.44, 0), 0.06, OLD_WOOD, 0.012)
    p.beam((0.0, 1.98, 0), (0.33, 2.39, 0), 0.05, OLD_WOOD)
    for y in (0.42, 1.32, 2.40):
        p.lathe([(y - 0.04, 0.105), (y + 0.04, 0.105)], 6, IRON, (-0.02, 0, 0))
    p.tube([(0.45, 2.45, 0), (0.45, 2.20, 0)], 0.04, 3, IRON, caps=False)
    lamp(p, (0.45, 2.22, 0), lit, 1.15, 0.0 if lit else 9.0)
    return p


def wall(lit):
    p = Piece("lantern_wall" if lit else "lantern_wall_dead", ground=False, wall=True, dirt=0.2)
    p.block((0, -0.30, 0.04), (0.20, 0.62, 0.07), IRON, bevel=0.02)
    p.beam((0, 0.20, 0.05), (0, 0.26, 0.62), 0.05, IRON)
    p.tube([(0, -0.20, 0.06), (0, -0.02, 0.22), (0, 0.08, 0.42), (0, 0.22, 0.50)], 0.04, 4, IRON)
    p.tube([(0, 0.26, 0.60), (0, 0.34, 0.66), (0, 0.30, 0.72)], 0.04, 4, IRON)
    p.tube([(0, 0.24, 0.56), (0, 0.08, 0.56)], 0.04, 3, IRON, caps=False)
    lamp(p, (0, 0.10, 0.56), lit, 1.1, 0.0 if lit else -8.0)
    return p


def hanging(lit):
    p = Piece("lantern_hanging" if lit else "lantern_hanging_dead", sway=0.35, ground=False, dirt=0.0)
    for i in range(4):
        link(p, (0, -0.02 - 0.29 * i, 0), 0.18, 0.085, i % 2, IRON, 0.04)
    lamp(p, (0, -1.18, 0), lit, 1.25, 0.0 if lit else 11.0)
    return p


def link(p, top, half_length, half_width, across, paint, thick=0.02, sides=3):
    """A link of a chain that hangs from `top`: six straight pieces; every other link is seen edge-on, as one bar."""
    if across:
        p.tube([vec(*top), vec(*top) - vec(0, 2 * half_length, 0)], thick * 1.15, 4, paint)
        return
    loop = [(0, 0), (0.8, -0.35), (0.8, -1.65), (0, -2), (-0.8, -1.65), (-0.8, -0.35), (0, 0)]
    path = []
    for u, v in loop:
        x, y = u * half_width, v * half_length
        path.append(vec(*top) + vec(x, y, 0))
    for a, b in zip(path, path[1:]):
        p.tube([a, b], thick, sides, paint, caps=False)


def lantern():
    return post(True)


def lantern_dead():
    return post(False)


def lantern_wall():
    return wall(True)


def lantern_wall_dead():
    return wall(False)


def lantern_hanging():
    return hanging(True)


def lantern_hanging_dead():
    return hanging(False)


PIECES = [lantern, lantern_dead, lantern_wall, lantern_wall_dead, lantern_hanging, lantern_hanging_dead]
