"""Banners: cloth of facets with a device, folded and torn by the wind."""

import math

from pieces_kit import BRASS, IRON, OLD_WOOD, ROPE, Paint, Piece

PLUM = Paint(0x73566E, 0.10)
INDIGO = Paint(0x46528A, 0.10)
TEAL = Paint(0x3F7672, 0.10)
BONE = Paint(0xCDBE9C, 0.08)


def cloth(p, left, right, top, lengths, rows, device, wave=0.10, phase=0.0):
    """A cloth from a bar: `lengths` are those of its threads from left to right, `device` paints a cell (column, row)."""
    columns = len(lengths) - 1

    def at(column, row):
        u, v = column / columns, row / rows
        y = -lengths[column] * v
        depth = wave * (0.25 + 0.75 * v) * math.sin(phase + u * 7.0 + v * 3.1) + 0.03 * math.sin(v * 9 + phase)
        return (left + (right - left) * (u + 0.02 * v * math.sin(v * 4 + phase)), top + y, depth + 0.02)

    for row in range(rows):
        for column in range(columns):
            paint = device(column, row)
            if paint is None:
                continue
            a, b = at(column, row), at(column + 1, row)
            c, d = at(column + 1, row + 1), at(column, row + 1)
            if (column + row) % 2:
                halves = ([a, d, c], [a, c, b])
            else:
                halves = ([a, d, b], [b, d, c])
            for half in halves:
                p.poly(half, paint, both=True)


def pattern(rows, key):
    """A device drawn with letters, one for each cell; a blank is a hole."""
    return lambda column, row: key.get(rows[row][column])


def banner():
    p = Piece("banner", sway=0.5, dirt=0.1)
    p.beam((0, -0.4, 0), (0.0, 3.55, 0), 0.065, OLD_WOOD, 0.014)
    p.beam((-0.16, 3.22, 0), (1.28, 3.30, 0), 0.055, OLD_WOOD, 0.01)
    p.beam((0.02, 2.86, 0), (0.36, 3.22, 0), 0.045, OLD_WOOD)
    p.lathe([(3.50, 0.03), (3.58, 0.075), (3.64, 0.06), (3.82, 0.0)], 6, BRASS)
    device = pattern(
        ["AAAAAA", "BBBBBB", "BBAABB", "BAAAAB", "BAAAAB", "BBAABB", "BBBBBB", "BBBBBB"],
        {"A": BONE, "B": INDIGO},
    )
    cloth(p, 0.12, 1.22, 3.22, [2.15, 1.95, 2.2, 1.75, 2.1, 1.85, 2.25], 8, device, 0.13)
    return p


def banner_torn():
    p = Piece("banner_torn", sway=0.55, ground=False, dirt=-0.1)
    p.beam((-0.85, -0.04, 0), (0.85, 0.0, 0), 0.055, OLD_WOOD, 0.01)
    for x in (-0.7, 0.7):
        p.tube([(x, 0.28, -0.02), (x, -0.02, 0.0)], 0.045, 3, ROPE, caps=False)
    device = pattern(
        ["AAAAAAA", "BBBBBBB", "BBBABBB", "BBAAABB", "BAA AAB", "BB AAB ", "B   BB ", "B    B "],
        {"A": BONE.shifted(0.85), "B": PLUM},
    )
    cloth(p, -0.72, 0.72, -0.06, [2.7, 2.2, 2.35, 2.0, 2.5, 2.95, 2.55, 1.8], 8, device, 0.16, 1.3)
    return p


def banner_long():
    p = Piece("banner_long", sway=0.6, ground=False, dirt=-0.1)
    p.beam((-0.42, 0, 0), (0.42, 0, 0), 0.055, IRON, 0.01)
    p.tube([(-0.36, 0.0, 0), (0, 0.34, 0), (0.36, 0.0, 0)], 0.045, 3, ROPE, caps=False)
    rows = ["BB", "AA", "BB", "BB", "AB", "BA", "AB", "BA", "BB", "BB", "AA", "BB"]
    device = pattern([r[0] + r + r[1] for r in rows], {"A": BONE, "B": TEAL})
    cloth(p, -0.34, 0.34, -0.04, [4.1, 4.35, 3.7, 4.35, 4.05], 12, device, 0.15, 0.4)
    return p


PIECES = [banner, banner_torn, banner_long]
