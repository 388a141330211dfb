"""What tells the player something: checkpoint, secret, death, return, goal, menus. Bells, struck stone and strings in
the mode of the music (D dorian), so that they belong to it."""

import numpy as np

from synth import RATE, TAU, band, decay, fade, finish, grains, high, in_room, level, low, modes, noise, put, rng, room
from synth import seconds, silence, string, struck, swell, wander
from steps import cloth_body, mail, puff, thump

# Semitones from D4.
D4 = 293.66


def note(steps):
    return D4 * 2 ** (steps / 12)


def bell(f, time, r, length=None, soft=0.0004):
    """A small bronze bell: hum, prime, tierce, quint, nominal and what is above."""
    ratios = [(0.5, 0.5, 1.0), (1, 0.8, 0.8), (1.19, 0.45, 0.6), (1.5, 0.3, 0.5), (2, 0.9, 0.55), (2.67, 0.3, 0.3)]
    ratios += [(3.01, 0.35, 0.26), (4.1, 0.25, 0.18), (5.4, 0.16, 0.12), (6.8, 0.1, 0.08)]
    out = struck([(f * k, g, time * d) for k, g, d in ratios], soft, length or time * 1.05, r, 0.0015)
    return out / np.max(np.abs(out))


def stone_chime(f, time, r):
    """A hanging stone that is struck: a bar's modes, quickly gone but for the lowest."""
    out = struck([(f, 1, time), (f * 2.756, 0.4, time * 0.3), (f * 5.404, 0.2, time * 0.12)], 0.0005, time * 1.1, r, 0.002)
    return out / np.max(np.abs(out))


def pluck(f, time, r, length, bright=0.6):
    n = int(RATE / f)
    burst = low(noise(0.03, r), 2600)[: n + 200] * np.hanning(n + 200)
    out = string(burst, f, time, bright, length)
    return out / np.max(np.abs(out))


def stereo(signal, answer, wet, length, end, loud):
    return level(finish(in_room(signal, answer, wet)[:, : int(length * RATE)], 0.002, end), loud, window=0.4)


def checkpoint():
    """The lodestone wakes: a stone is struck, its iron sings, a fifth opens above."""
    r = rng(51)
    out = silence(3.4)
    put(out, thump(62, 0.3, r, 0.5), 0.0, 0.5)
    put(out, stone_chime(note(-12), 1.6, r), 0.0, 0.7)
    for at, steps, gain in [(0.05, 0, 0.5), (0.17, 7, 0.5), (0.31, 14, 0.45)]:
        put(out, bell(note(steps), 2.6, r), at, gain)
    t = seconds(3.0)
    hum = sum(np.sin(TAU * note(s) * k * t + r.uniform(0, TAU)) / k for s in (-12, -5, 2) for k in (1, 2.003))
    put(out, hum * swell(t, 0.6, 2.4), 0.1, 0.10)
    return stereo(out, room(2.2, 0.7, r), 0.35, 4.2, 1.0, -20)


def secret():
    """A hidden place: a figure on a glassy string that climbs and stays open."""
    r = rng(52)
    out = silence(3.4)
    for k, steps in enumerate([2, 5, 9, 7, 12, 16]):
        put(out, pluck(note(steps), 1.8, r, 2.0, 0.85), 0.115 * k, 0.4 + 0.05 * k)
        put(out, bell(note(steps + 12), 1.0, r), 0.115 * k, 0.08 + 0.02 * k)
    return stereo(out, room(2.4, 0.8, r), 0.45, 4.0, 1.0, -21)


def death():
    """Breath is knocked out, mail falls, a low string goes slack."""
    r = rng(53)
    out = silence(2.2)
    put(out, thump(66, 0.25, r, 0.8), 0.0, 0.25)
    put(out, thump(132, 0.12, r, 0.5), 0.0, 0.25)
    put(out, puff(0.15, 800, 0.6, r, 0.002), 0.0, 1.0)
    mail_falls = struck([(690, 0.6, 0.25), (1130, 0.8, 0.2), (1870, 0.7, 0.15), (2950, 0.5, 0.1)], 0.0003, 0.4, r, 0.04)
    for at, gain in [(0.004, 0.16), (0.13, 0.1), (0.21, 0.06)]:
        put(out, mail_falls, at, gain)
    put(out, mail(0.5, r), 0.01, 0.5)
    put(out, cloth_body(0.5, r, 600), 0.02, 0.6)
    t = seconds(1.8)
    slack = 1 - 0.16 * np.clip(t / 1.4, 0, 1) ** 0.7
    for s, g in [(-24, 0.4), (-12, 0.45), (-11, 0.3), (-5, 0.3)]:
        phase = np.cumsum(note(s) * slack) / RATE
        out[: len(t)] += g * 0.35 * sum(np.sin(TAU * k * phase + k) / k**1.4 for k in range(1, 9)) * swell(t, 0.02, 1.5)
    return stereo(low(out, 3800), room(1.8, 0.4, r), 0.35, 2.8, 0.8, -18)


def respawn():
    """A stone answers, air is drawn in, and stands still with a soft fifth."""
    r = rng(54)
    out = silence(1.8)
    t = seconds(0.7)
    breath = sum(g * band(noise(0.7, r), f, 1.2)[: len(t)] for f, g in [(700, 1.0), (1500, 0.6), (3200, 0.3)])
    put(out, breath * np.sin(np.pi * t / 0.7) ** 2 * (0.3 + t / 0.7), 0.0, 0.5)
    put(out, stone_chime(note(-12), 0.9, r), 0.0, 0.3)
    for at, steps, gain in [(0.30, 0, 0.35), (0.36, 7, 0.3)]:
        put(out, stone_chime(note(steps), 1.0, r), at, gain)
        put(out, bell(note(steps + 12), 1.0, r), at, 0.08)
    return stereo(out, room(1.6, 0.7, r), 0.35, 2.4, 0.8, -23)


def goal():
    """The gate opens: bells over a chord that rises out of the ground and turns to major."""
    r = rng(55)
    out = silence(6.5)
    put(out, thump(49, 0.6, r, 0.9), 0.0, 0.7)
    t = seconds(6.0)
    for s, g in [(-24, 0.5), (-12, 0.5), (-5, 0.4), (-1 + 0, 0.0), (4, 0.3), (7, 0.25), (11, 0.15)]:
        voice = sum(np.sin(TAU * note(s) * k * (t + 0.0004 * np.sin(TAU * 4.6 * t + s)) + r.uniform(0, TAU)) / k**1.5 for k in range(1, 7))
        put(out, voice * swell(t, 1.3, 5.0), 0.1, g * 0.3)
    for k, steps in enumerate([0, 7, 12, 16, 19, 24, 23, 19]):
        put(out, bell(note(steps), 3.2, r), 0.02 + 0.36 * k, 0.42 - 0.02 * k)
        put(out, pluck(note(steps - 12), 2.5, r, 2.6, 0.7), 0.02 + 0.36 * k, 0.3)
    return stereo(out, room(3.0, 0.7, r), 0.4, 8.0, 2.2, -19)


def menu_move():
    """A pebble on slate."""
    r = rng(56)
    out = silence(0.25)
    put(out, stone_chime(note(19), 0.09, r), 0.0, 0.6)
    put(out, grains(0.05, 500, (0.002, 0.006), (2500, 6500), r), 0.0, 0.12)
    return level(finish(out, end=0.1), -27)


def menu_choose():
    """Two stones and a string."""
    r = rng(57)
    out = silence(0.9)
    put(out, stone_chime(note(12), 0.25, r), 0.0, 0.6)
    put(out, stone_chime(note(19), 0.35, r), 0.075, 0.5)
    put(out, pluck(note(0), 0.9, r, 0.8, 0.6), 0.0, 0.35)
    return level(finish(out, end=0.3), -24)


def menu_back():
    r = rng(58)
    out = silence(0.7)
    put(out, stone_chime(note(12), 0.2, r), 0.0, 0.5)
    put(out, stone_chime(note(5), 0.35, r), 0.075, 0.55)
    return level(finish(out, end=0.25), -25)


def sounds():
    """All of them: (name, signal)."""
    for make in [checkpoint, secret, death, respawn, goal, menu_move, menu_choose, menu_back]:
        yield make.__name__, make()
