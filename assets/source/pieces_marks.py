"""What belongs to a rule of the game: dangers, what is climbed, the lodestone of a checkpoint, the gate at the goal.

Dangers and what is climbed are one metre long, so that the game can set them side by side along an outline.
What can be climbed, and nothing else, bears gold: blossoms on vines, cloth around rungs.
"""

import math

from pieces_kit import DARK, HOT, IRON, MAGIC, OLD_WOOD, PALE, RUST, STONE, WOOD, Paint, Piece, drum, hull, prism, turned, vec
from pieces_lamps import link
from pieces_plants import LEAF, STEM

BLACK = Paint(0x26252D, 0.10)
EMBER = Paint(0xC2331A, 0.10, glow=True)
GOLD = Paint(0xFFC02E, 0.10)


def spike(p, x, z, height, r, lean):
    """Four-edged: black iron, glowing towards the point."""
    foot, tip = vec(x, -0.06, z), vec(x + lean * height, height, z)
    shares = (0.0, 0.5, 0.68, 1.0)
    places = [foot + (tip - foot) * share for share in shares]
    radii = [r * (1 - share) for share in shares]
    for i, paint in enumerate((BLACK, EMBER, HOT)):
        p.tube(places[i : i + 2], radii[i : i + 2], 4, paint, caps=False, spin=0.5)


def spikes():
    """A metre of spikes, as tall as a metre; the game scales them to the height of the danger."""
    p = Piece("spikes", dirt=0.0)
    rows = (
        ((-0.27, 1.0, -0.05), (0.24, 0.92, 0.05)),
        ((0.0, 0.84, 0.03), (0.48, 0.88, 0.0)),
        ((-0.24, 0.90, 0.04), (0.26, 0.98, -0.05)),
    )
    for z, row in zip((0.26, -0.16, -0.56), rows):
        for x, height, lean in row:
            spike(p, x, z, height, 0.20, lean)
    for x in (-0.25, 0.25):
        p.block((x, -0.05, -0.14), (0.50, 0.12, 1.05), BLACK, bevel=0.02, chips=1)
    return p


def teeth():
    """A metre of a machine's jaw: its plate lies at the foot, its teeth point up. Half a metre tall."""
    p = Piece("teeth", ground=False, dirt=0.0)
    p.block((0, -0.10, -0.12), (1.0, 0.16, 1.10), BLACK.shifted(1.3), bevel=0.02)
    for k in range(3):  # saw teeth, all one way
        x = -0.333 + 0.333 * k
        low = [(x - 0.165, 0.05), (x + 0.165, 0.05), (x + 0.15, 0.24), (x - 0.03, 0.24)]
        high = [(x - 0.03, 0.24), (x + 0.15, 0.24), (x + 0.13, 0.50), (x + 0.11, 0.50)]
        p.solid(prism(low, -0.6, 0.36), IRON, drop=(0, 1, 0))
        p.solid(prism(high, -0.6, 0.36), HOT, drop=(0, -1, 0))
    return p


def wrap(p, x, y, z):
    """Cloth around the end of a rung, its end hanging down."""
    p.block((x, y - 0.085, z), (0.18, 0.17, 0.15), GOLD, bevel=0)
    low = vec(x + 0.03, y - 0.36, z + 0.09)
    p.poly([vec(x - 0.08, y - 0.05, z + 0.08), low, vec(x + 0.09, y - 0.05, z + 0.08)], GOLD.shifted(0.85), both=True)


def ladder_metre():
    """A metre of a wooden ladder, as wide as a metre, about its middle; it goes up from its foot."""
    p = Piece("ladder_metre", ground=False, dirt=0.0)
    for x in (-0.42, 0.42):
        p.beam((x, 0, 0), (x, 1.0, 0), 0.06, OLD_WOOD, 0.012)
    for k, tilt in enumerate((0.01, -0.012, 0.006)):
        y = 0.17 + 0.333 * k
        p.beam((-0.5, y - tilt, 0.06), (0.5, y + tilt, 0.06), 0.052, WOOD, 0.008)
    wrap(p, 0.42 * (-1), 0.17 + 0.333, 0.05)
    wrap(p, 0.42, 0.17 + 0.333, 0.05)
    return p


def chain_metre():
    """A metre of a heavy chain to climb, with a rung through every other link; it goes up from its foot."""
    p = Piece("chain_metre", ground=False, dirt=0.0)
    for k in range(2):
        link(p, (0, 1.06 - 0.5 * k, 0), 0.29, 0.15, k % 2, IRON.shifted(1.15), 0.056, 4)
    for y in (0.27, 0.77):
        p.beam((-0.32, y, 0), (0.32, y + 0.01, 0), 0.052, RUST, 0.01)
        for x in (-0.27, 0.27):
            wrap(p, x, y, 0)
    return p


def vine_metre():
    """A metre of thick vines to climb, as wide as a metre; it goes up from its foot."""
    p = Piece("vine_metre", sway=0.05, ground=False, dirt=0.0)
    for x, z, phase in ((-0.26, 0.0, 0.0), (0.04, 0.05, 2.0), (0.28, -0.02, 4.2)):
        path = [(x + 0.06 * math.sin(phase + k * math.pi / 2), k / 4, z) for k in range(5)]
        p.tube(path, 0.06, 4, STEM, caps=False)
        for k in range(3):
            y = (k + 0.5 + 0.3 * (phase > 3)) / 3
            side = 1 if (k + (phase > 1)) % 2 else -1
            at = vec(x, y, z + 0.05)
            tip = at + vec(0.34 * side * p.rng.uniform(0.85, 1.15), -0.16, p.rng.uniform(0.02, 0.14))
            tone = LEAF.shifted(p.rng.uniform(0.85, 1.3))
            p.poly([at, (at + tip) / 2 + vec(0, -0.14, 0.03), tip, (at + tip) / 2 + vec(0, 0.13, 0.03)][::side], tone, both=True)
    for x, y in ((-0.28, 0.16), (0.20, 0.48), (-0.22, 0.80)):
        blossom(p, vec(x, y, 0.21), 0.16 * p.rng.uniform(0.9, 1.1))
    return p


def blossom(p, at, size):
    """Four petals about a point that sticks out of the leaves."""
    rim = [at + vec(size * x, size * y, 0) for x, y in ((1, 0.2), (-0.2, 1), (-1, -0.2), (0.2, -1))]
    heart = at + vec(0, 0, size * 0.6)
    for k in range(4):
        p.poly([heart, rim[k], rim[(k + 1) % 4]], GOLD.shifted(0.9 + 0.1 * (k % 2)))


def lodestone():
    """A standing stone, split above: between its horns hangs the shard. 2.6 m tall."""
    p = Piece("lodestone", dirt=0.3)
    for r, y, height in ((0.86, 0.0, 0.14), (0.64, 0.13, 0.14)):
        p.solid(drum(r, r * 0.94, height, 7, 0.2).bevel(0.03, p.rng), DARK, (0, y, 0))
    body = hull([(x, 0.2, z) for x in (-0.40, 0.40) for z in (-0.26, 0.26)] + [(x, 1.25, z) for x in (-0.34, 0.34) for z in (-0.20, 0.20)])
    p.solid(body.bevel(0.05, p.rng).chip(p.rng, 2, 0.09), STONE)
    for side in (-1, 1):  # two halves of a ring that does not close
        places = [(0.20, 1.12), (0.50, 1.48), (0.62, 1.92), (0.48, 2.32 + 0.06 * side), (0.16, 2.58 - 0.10 * side)]
        widths = [0.19, 0.17, 0.14, 0.10, 0.02]
        for (low, wide), (high, narrow) in zip(zip(places, widths), list(zip(places, widths))[1:]):
            p.beam((side * low[0], low[1], 0), (side * high[0], high[1], 0), wide, PALE, 0.02 if wide > 0.12 else 0.0, end=narrow / wide)
    for y, width in ((0.46, 0.20), (0.72, 0.26), (0.98, 0.16)):  # cut runes
        z = 0.268 - 0.057 * (y - 0.2)
        p.block((0, y, z), (width, 0.055, 0.02), MAGIC.shifted(0.55), bevel=0)
    p.block((0, 0.46, 0.252), (0.05, 0.56, 0.02), MAGIC.shifted(0.55), bevel=0)
    p.light((0, 1.86, 0.35), 7.0, (0.22, 1.5, 1.3))
    return p


def lodestone_shard():
    """The shard alone, about its middle."""
    p = Piece("lodestone_shard", ground=False, dirt=0.0)
    p.lathe([(-0.36, 0.0), (-0.06, 0.135), (0.10, 0.125), (0.40, 0.0)], 5, [MAGIC.shifted(0.75), MAGIC.shifted(1.1), MAGIC])
    for a, y, size in ((0.6, -0.12, 0.07), (2.8, 0.10, 0.055), (4.6, 0.0, 0.05)):
        at = (0.24 * math.cos(a), y, 0.24 * math.sin(a))
        p.lathe([(-size * 1.5, 0.0), (0.0, size * 0.55), (size * 1.7, 0.0)], 4, MAGIC, at)
    return p


def gate():
    """The end of the way: two pylons, a broken ring between their heads, steps before an open door. 10 m tall."""
    p = Piece("gate", dirt=0.2)
    p.block((0, -FOOT, -0.6), (7.6, FOOT, 2.6), DARK, bevel=0.12)
    p.block((0, -0.02, -0.7), (6.9, 0.20, 2.6), STONE, bevel=0.05)
    for side in (-1, 1):
        outline = [(1.45, 0.0), (3.35, 0.0), (2.95, 6.2), (1.75, 6.2)]
        pylon = prism([(side * x, y) for x, y in outline], -1.9, 0.0).bevel(0.16, p.rng)
        p.solid(pylon, PALE, (0, 0.16, 0))
        p.block((side * 2.4, 0.16, -0.92), (2.3, 0.7, 2.3), STONE, bevel=0.1, chips=1)
        p.block((side * 2.35, 6.30, -0.95), (1.6, 0.42, 2.2), PALE.shifted(1.08), bevel=0.08)
        horn = hull([(side * x, y, z) for x, y, z in ((1.75, 6.7, -1.7), (1.75, 6.7, -0.2), (2.9, 6.7, -1.7), (2.9, 6.7, -0.2), (1.5, 8.9, -1.2), (1.5, 8.9, -0.6), (1.9, 8.8, -1.2), (1.9, 8.8, -0.6))])
        p.solid(horn.bevel(0.08, p.rng), PALE)
        tip = hull([(side * x, y, z) for x, y, z in ((1.48, 8.75, -1.18), (1.48, 8.75, -0.62), (1.92, 8.7, -1.18), (1.92, 8.7, -0.62), (0.75, 9.9, -0.95), (0.75, 9.9, -0.85))])
        p.solid(tip, STONE)
        p.block((side * 1.30, 0.16, -1.0), (0.42, 4.5, 1.4), DARK.shifted(1.1), bevel=0.05)
    p.block((0, 4.64, -1.0), (3.3, 0.75, 1.5), STONE, bevel=0.08, chips=2)
    crest = hull([(-1.2, 5.38, -1.4), (1.2, 5.38, -1.4), (-1.2, 5.38, -0.5), (1.2, 5.38, -0.5), (0, 6.05, -1.0), (0, 6.05, -0.9)])
    p.solid(crest.bevel(0.05, p.rng), PALE)
    p.light((0, 7.6, 0.5), 16.0, (0.35, 2.1, 1.85))
    p.light((0, 2.2, 0.9), 9.0, (0.22, 1.4, 1.25))
    return p


def gate_light():
    """What of the gate lights up: the shard between the horns, the runes, the door."""
    p = Piece("gate_light", ground=False, dirt=0.0)
    p.lathe([(6.55, 0.0), (7.35, 0.46), (7.75, 0.42), (9.0, 0.0)], 6, [MAGIC.shifted(0.75), MAGIC.shifted(1.1), MAGIC], (0, 0, -0.92))
    for a, y, size in ((0.4, 7.1, 0.20), (2.6, 7.9, 0.16), (4.2, 7.4, 0.14), (5.4, 8.3, 0.12)):
        p.lathe([(-size * 1.5, 0.0), (0.0, size * 0.55), (size * 1.7, 0.0)], 4, MAGIC, (0.85 * math.cos(a), y, -0.92 + 0.4 * math.sin(a)))
    for side in (-1, 1):
        for k in range(5):
            y, wide = 1.3 + 0.95 * k, (0.5, 0.3, 0.42, 0.26, 0.36)[k]
            x = side * (2.40 - 0.02 * y)
            p.block((x, y, 0.01), (0.07, 0.58, 0.04), MAGIC, bevel=0)
            p.block((x + side * 0.08 * (k % 3 - 1), y + 0.22 + 0.1 * (k % 2), 0.01), (wide, 0.07, 0.04), MAGIC, bevel=0)
    for k, (x, y) in enumerate(((-1.09, 0.2), (-0.55, 0.2), (0.0, 0.2), (0.55, 0.2))):  # the door: a curtain of light
        tone = MAGIC.shifted(0.34 + 0.10 * (k in (1, 2)))
        p.poly([(x, y, -1.45), (x + 0.55, y, -1.45), (x + 0.55, 4.64, -1.45), (x, 4.64, -1.45)], tone)
    return p


FOOT = 2.0  # how far the gate's foundation goes down


def pedestal():
    """What a trigger is seen as: a plate before a stone that bears an eye."""
    p = Piece("pedestal", dirt=0.2)
    p.solid(drum(0.46, 0.42, 0.12, 7, 0.2).bevel(0.02, p.rng), DARK)
    p.block((0, 0.1, 0), (0.44, 0.84, 0.40), STONE, bevel=0.05, chips=2, taper=0.78)
    p.block((0, 0.92, 0), (0.46, 0.14, 0.42), PALE, bevel=0.03)
    p.lathe([(1.08, 0.0), (1.22, 0.14), (1.28, 0.13), (1.46, 0.0)], 6, MAGIC)
    p.light((0, 1.3, 0.4), 5.0, (0.2, 1.1, 1.0))
    return p


PIECES = [
    spikes, teeth, ladder_metre, chain_metre, vine_metre, lodestone, lodestone_shard, gate, gate_light, pedestal,
]  # fmt: skip
