"""What the place does: wind, water, machines, lamps; and the loops that follow the hero. Loops are made on a circle."""

import numpy as np

from synth import RATE, TAU, around_line, around_noise, around_room, band, db, decay, fade, finish, grains, high, level, low
from synth import modes, noise, put, put_around, respond, rng, room, in_room, seconds, silence, string, struck, swell, wander
from steps import creak, puff, thump

FEW = 3
LOOP = -26  # loudness of loops, LUFS over a second


def steady(signal):
    """Brings a loop to its loudness, without what is too low to hear."""
    return level(circle(signal, lambda f: 1 / (1 + (35 / f) ** 4)), LOOP, window=1.0)


def bump_at(f, middle, width):
    """A hill over the logarithm of frequency."""
    return np.exp(-0.5 * (np.log2(f / middle) / width) ** 2)


def circle(signal, response):
    """Filters a loop: its spectrum times a response, a function of frequency."""
    n = signal.shape[-1]
    f = np.maximum(np.fft.rfftfreq(n, 1 / RATE), 1.0)
    return np.fft.irfft(np.fft.rfft(signal) * response(f), n)


def wind():
    """Gusts over stone: bands of noise, the higher the gustier, and a far whistle; 24 s."""
    length, r = 24.0, rng(31)
    gust = around_line(length, 9, r)
    out = np.zeros((2, int(length * RATE)))
    for middle, width, bend, share in [(130, 0.9, 0.5, 1.0), (330, 0.7, 1.0, 0.9), (760, 0.55, 1.9, 0.6), (1900, 0.6, 3.0, 0.22)]:
        for side in range(2):
            own = around_line(length, 14, r, 0.7, 1.0)
            out[side] += share * around_noise(length, lambda f: bump_at(f, middle, width), r) * (0.12 + gust**bend) * own
    for middle, side in [(612, 0.35), (918, 0.7), (1240, 0.55)]:
        tone = around_noise(length, lambda f: bump_at(f, middle, 0.02), r) * gust**4 * around_line(length, 20, r) ** 2
        out += np.array([[1 - side], [side]]) * 0.16 * tone
    return steady(out)


def fall():
    """Air that rushes past who falls or runs; 6 s."""
    length, r = 6.0, rng(32)
    out = np.zeros((2, int(length * RATE)))
    for side in range(2):
        flutter = around_line(length, 90, r, 0.45, 1.0)
        out[side] = around_noise(length, lambda f: bump_at(f, 520, 1.2), r) * flutter
        out[side] += 0.3 * around_noise(length, lambda f: bump_at(f, 2400, 0.8), r) * flutter**2
    return steady(out)


def cape():
    """Heavy cloth that flaps in a stream of air, about eight times a second; 5 s."""
    length, r = 5.0, rng(33)
    out = np.zeros(int(length * RATE))
    at = 0.0
    while at < length:
        t = seconds(0.22)
        flap = band(noise(0.22, r), r.uniform(480, 800), 0.6)[: len(t)] + 0.5 * band(noise(0.22, r), r.uniform(1500, 2600), 0.6)[: len(t)]
        put_around(out, fade(flap * swell(t, 0.018, 0.16), 0.002, 0.02), at, r.uniform(0.3, 1.0))
        at += r.uniform(0.07, 0.17)
    return steady(out + 0.05 * around_noise(length, lambda f: bump_at(f, 900, 1.0), r))


def slide():
    """Boots and a glove along a wall of stone: grit and a dull roar; 3 s."""
    length, r = 3.0, rng(34)
    rough = around_line(length, 150, r, 0.25, 1.0)
    out = around_noise(length, lambda f: bump_at(f, 1500, 0.9) + 0.5 * bump_at(f, 260, 0.6), r) * rough
    grit = np.zeros(len(out))
    put_around(grit, grains(length + 0.05, 900, (0.002, 0.01), (1400, 6500), r), 0.0)
    return steady(out + 0.9 * grit / np.sqrt(np.mean(grit**2)) * 0.5)


def hum():
    """A lamp that burns: a flame's flutter and the faintest tone of its glass; 6 s."""
    length, r = 6.0, rng(35)
    t = seconds(length)
    flame = around_noise(length, lambda f: bump_at(f, 170, 1.0), r) * around_line(length, 70, r, 0.3, 1.0)
    tone = np.zeros(len(t))
    for f, gain in [(220, 0.5), (440.5, 0.3), (661, 0.22), (1104, 0.06)]:
        f = round(f * length) / length
        tone += gain * np.sin(TAU * f * t) * around_line(length, 8, r, 0.5, 1.0)
    crackle = np.zeros(len(t))
    put_around(crackle, grains(length, 7, (0.002, 0.006), (1800, 5200), r), 0.0)
    return steady(0.8 * flame + 0.5 * tone + 0.25 * crackle)


def water():
    """Water that laps at stone: slow swells, and bubbles that ring as they close; 18 s."""
    length, r = 18.0, rng(36)
    n = int(length * RATE)
    out = np.zeros((2, n))
    for side in range(2):
        swells = 0.2 + around_line(length, 12, r) ** 2
        out[side] += 0.7 * around_noise(length, lambda f: bump_at(f, 420, 0.9) + 0.25 * bump_at(f, 1600, 0.7), r) * swells
    at = 0.0
    while at < length:
        f, time = 10 ** r.uniform(np.log10(330), np.log10(1500)), r.uniform(0.02, 0.07)
        t = seconds(time * 2.2)
        chirp = np.sin(TAU * np.cumsum(f * (1 + 0.35 * t / time)) / RATE) * swell(t, 0.004, time * 1.8)
        side = r.uniform(0.1, 0.9)
        gain = r.uniform(0.2, 1.0) ** 2 * 0.8
        put_around(out, np.array([[1 - side], [side]]) * fade(chirp, 0.001, 0.004), at, gain)
        at += r.exponential(0.055)
    return steady(around_room(out, room(1.1, 0.6, r), 0.25))


def motor():
    """A lift's winch: a shaft, teeth that mesh, a load that sways; 4 s."""
    length, r = 4.0, rng(37)
    t = seconds(length)
    turn = 6.0  # turns a second, a whole number in the loop
    out = np.zeros(len(t))
    for k, gain in [(8, 1.0), (16, 0.7), (24, 0.35), (40, 0.22), (64, 0.12)]:
        wobble = 0.25 * np.sin(TAU * turn / 2 * t + k)
        out += gain * np.sin(TAU * turn * k * t + wobble) * around_line(length, 30, r, 0.6, 1.0)
    teeth = np.zeros(len(t))
    ring = struck([(540, 1, 0.05), (1260, 0.8, 0.04), (2330, 0.5, 0.03), (3900, 0.25, 0.02)], 0.0015, 0.1, r)
    count = int(length * turn * 3)
    for k in range(count):
        put_around(teeth, ring, k * length / count, r.uniform(0.4, 1.0))
    rumble = around_noise(length, lambda f: bump_at(f, 95, 0.8), r)
    whirr = around_noise(length, lambda f: bump_at(f, 1150, 0.5), r) * (0.5 + 0.5 * np.sin(TAU * turn * t)) ** 2
    return steady(0.5 * out + 0.22 * rumble + 1.6 * teeth / np.max(np.abs(teeth)) + 0.12 * whirr)


def chain():
    """Links that run over a wheel; 3 s."""
    length, r = 3.0, rng(38)
    out = np.zeros(int(length * RATE))
    count = 36
    for k in range(count):
        base = r.uniform(0.85, 1.2)
        link = struck([(1310 * base, 1, 0.09), (2480 * base, 0.8, 0.07), (3720 * base, 0.6, 0.06), (5630 * base, 0.4, 0.04)], 0.0008, 0.14, r, 0.02)
        put_around(out, link, (k + r.uniform(-0.25, 0.25)) * length / count % length, r.uniform(0.25, 1.0))
        put_around(out, thump(190 * base, 0.03, r, 0.06), k * length / count, 0.8)
    return steady(out)


def belt():
    """Slats over rollers; 4 s."""
    length, r = 4.0, rng(39)
    out = 0.8 * around_noise(length, lambda f: bump_at(f, 210, 0.8), r) * around_line(length, 40, r, 0.6, 1.0)
    knock = struck([(280, 1, 0.05), (510, 0.7, 0.04), (890, 0.4, 0.03)], 0.003, 0.1, r)
    for k in range(40):
        put_around(out, knock / np.max(np.abs(knock)), (k + r.uniform(-0.1, 0.1)) * length / 40 % length, r.uniform(0.8, 1.7))
    return steady(out)


# ---- Single sounds ------------------------------------------------------------------------------------------------------


def slam(n):
    """Tons of iron and stone come down."""
    r = rng(41, n)
    out = silence(1.6)
    put(out, thump(48 * r.uniform(0.95, 1.05), 0.45, r, 0.9), 0.004, 1.0)
    put(out, thump(96, 0.2, r, 0.5), 0.004, 0.9)
    put(out, puff(0.25, 1400, 0.4, r, 0.002), 0.003, 1.2)
    plate = [(131 * k, 0.8 / (1 + 0.2 * i), 1.1 / (1 + 0.35 * i)) for i, k in enumerate([1, 1.52, 2.3, 2.77, 3.9, 5.1, 6.8, 9.0, 12.1])]
    put(out, struck(plate, 0.0012, 1.3, r, 0.02), 0.003, 0.5)
    rubble = grains(1.0, 1500 * swell(seconds(1.0), 0.02, 0.5), (0.003, 0.02), (600, 4800), r)
    put(out, rubble, 0.01, 0.5)
    put(out, puff(0.8, 300, 0.5, r, 0.02), 0.01, 0.4)
    wet = in_room(out, room(1.4, 0.5, r), 0.3).mean(axis=0)
    return level(finish(wet[: int(2.0 * RATE)], end=0.4), -15)


def clunk(n):
    """A machine starts or stops: a pawl falls in."""
    r = rng(42, n)
    out = silence(0.8)
    iron = [(236, 1, 0.2), (418, 0.8, 0.18), (777, 0.7, 0.14), (1290, 0.5, 0.1), (2210, 0.4, 0.08)]
    put(out, struck(iron, 0.0014, 0.4, r, 0.04), 0.004, 0.6)
    put(out, struck(iron, 0.0014, 0.4, r, 0.06), r.uniform(0.07, 0.11), 0.35)
    put(out, thump(92, 0.09, r), 0.004, 0.4)
    put(out, creak(0.4, r), 0.12, 0.05)
    return level(finish(out, end=0.2), -20)


def door(n):
    """Stone grinds over stone, then sets."""
    r = rng(43, n)
    length = 1.3
    t = seconds(length)
    grind = band(noise(length, r), 240, 0.6)[: len(t)] * wander(length, 40, r, 0.3, 1.0)[: len(t)]
    grind += 0.35 * grains(length, 900, (0.002, 0.014), (700, 3800), r)
    out = silence(1.9)
    put(out, fade(grind, 0.15, 0.2), 0.0, 1.0)
    put(out, thump(74, 0.2, r, 0.5), 1.22, 0.8)
    put(out, struck([(180, 1, 0.12), (420, 0.8, 0.08), (960, 0.5, 0.05)], 0.002, 0.3, r, 0.03), 1.22, 0.6)
    put(out, grains(0.5, 600 * swell(seconds(0.5), 0.01, 0.3), (0.002, 0.012), (900, 4500), r), 1.22, 0.5)
    return level(finish(out, end=0.3), -19)


def lever(n):
    """A plate gives way under a foot, something in the wall answers."""
    r = rng(44, n)
    out = silence(0.9)
    put(out, struck([(340, 1, 0.06), (910, 0.8, 0.05), (1730, 0.6, 0.04)], 0.0015, 0.15, r, 0.03), 0.004, 0.35)
    put(out, thump(92, 0.1, r), 0.004, 0.7)
    for k in range(5):
        put(out, struck([(1180, 1, 0.04), (2660, 0.7, 0.03)], 0.0008, 0.08, r, 0.05), 0.16 + 0.055 * k, 0.16 * (1 - 0.12 * k))
    put(out, thump(98, 0.12, r), 0.46, 0.4)
    put(out, struck([(240, 1, 0.1), (530, 0.7, 0.07), (1270, 0.4, 0.04)], 0.002, 0.2, r, 0.03), 0.46, 0.4)
    return level(finish(out, end=0.2), -21)


def swing(n):
    """The lantern's handle in its eye."""
    r = rng(45, n)
    length = 0.5
    t = seconds(length)
    f = 1350 * r.uniform(0.9, 1.12)
    squeak = np.sin(TAU * np.cumsum(f * (1 + 0.05 * np.sin(TAU * 5 * t))) / RATE) * wander(length, 40, r)[: len(t)] ** 2 * swell(t, 0.07, 0.3)
    squeak += 0.4 * np.sin(TAU * np.cumsum(2.02 * f * (1 + 0.05 * np.sin(TAU * 5 * t))) / RATE) * swell(t, 0.09, 0.2)
    out = silence(0.6)
    put(out, squeak, 0.0, 0.3)
    put(out, struck([(2870, 1, 0.12), (4630, 0.7, 0.1), (6420, 0.5, 0.07)], 0.0006, 0.2, r, 0.03), 0.02, 0.1)
    return level(finish(out, end=0.12), -26)


def splash(n):
    """A body falls into deep water."""
    r = rng(46, n)
    length = 2.0
    t = seconds(length)
    out = silence(length)
    burst = noise(length, r)
    for f, q, g, attack, time in [(260, 0.6, 1.2, 0.01, 0.5), (900, 0.6, 0.9, 0.03, 0.7), (2800, 0.6, 0.5, 0.06, 1.0), (6000, 0.7, 0.2, 0.08, 0.9)]:
        out += g * band(burst, f, q)[: len(t)] * swell(t, attack, time) * wander(length, 30, r, 0.5, 1.0)[: len(t)]
    put(out, thump(78, 0.22, r, 0.6), 0.004, 0.7)
    for _ in range(70):
        f, time, at = 10 ** r.uniform(2.4, 3.3), r.uniform(0.02, 0.08), 0.08 + r.gamma(2.0, 0.28)
        s = seconds(time * 2)
        chirp = np.sin(TAU * np.cumsum(f * (1 + 0.5 * s / time)) / RATE) * swell(s, 0.004, time * 1.6)
        put(out, fade(chirp, 0.001, 0.004), at, r.uniform(0.05, 0.35))
    return level(finish(out, end=0.5), -17)


def drip(n):
    """A drop in a cave."""
    r = rng(47, n)
    f = 900 * r.uniform(0.8, 1.5)
    t = seconds(0.12)
    drop = np.sin(TAU * np.cumsum(f * (1 + 1.4 * np.clip(t / 0.05, 0, 1))) / RATE) * swell(t, 0.003, 0.07)
    out = silence(0.3)
    put(out, fade(drop, 0.001, 0.01), 0.004)
    put(out, fade(drop, 0.001, 0.01), 0.07, 0.25)
    wet = in_room(out, room(1.6, 0.7, r), 0.25).mean(axis=0)
    return level(finish(wet[: int(1.5 * RATE)], end=0.5), -27)


LOOPS = [wind, fall, cape, slide, hum, water, motor, chain, belt]


def sounds():
    """All of them: (name, signal)."""
    for make in LOOPS:
        yield make.__name__, make()
    for make in [slam, clunk, door, lever, swing, splash, drip]:
        for n in range(FEW):
            yield f"{make.__name__}_{n + 1}", make(n)
