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
        flap = band(noise(0.22, r), r.uniform(360, 650), 0.6)[: len(t)] + 0.3 * band(noise(0.22, r), r.uniform(1300, 2200), 0.6)[: len(t)]
        flap = low(flap, 3200)[: len(t)]
        put_around(out, fade(flap * swell(t, 0.018, 0.16), 0.002, 0.02), at, r.uniform(0.3, 1.0))
        at += r.uniform(0.07, 0.17)
    return steady(out + 0.05 * around_noise(length, lambda f: bump_at(f, 700, 1.0), r))


def slide():
    """Boots and a glove along a wall of stone: grit and a dull roar; 3 s."""
    length, r = 3.0, rng(34)
    rough = around_line(length, 150, r, 0.25, 1.0)
    out = around_noise(length, lambda f: bump_at(f, 1000, 0.9) + 0.6 * bump_at(f, 260, 0.6), r) * rough
    grit = np.zeros(len(out))
    put_around(grit, grains(length + 0.05, 900, (0.002, 0.01), (900, 4800), r), 0.0)
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
    for k, gain in [(8, 0.35), (16, 0.5), (24, 0.4), (40, 0.3), (64, 0.2)]:
        wobble = 0.25 * np.sin(TAU * turn / 2 * t + k)
        out += gain * np.sin(TAU * turn * k * t + wobble) * around_line(length, 30, r, 0.6, 1.0)
    teeth = np.zeros(len(t))
    count = int(length * turn * 3)
    for k in range(count):
        tooth = [(540, 1, 0.06), (870, 0.7, 0.05), (1260, 0.8, 0.045), (2330, 0.5, 0.035), (3900, 0.25, 0.02)]
        ring = struck(tooth, 0.0005, 0.1, r, 0.03)
        put_around(teeth, ring, (k + r.uniform(-0.06, 0.06)) % count * length / count, r.uniform(0.4, 1.0))
    rumble = around_noise(length, lambda f: bump_at(f, 95, 0.8), r)
    whirr = around_noise(length, lambda f: bump_at(f, 1150, 0.5), r) * (0.5 + 0.5 * np.sin(TAU * turn * t)) ** 2
    return steady(0.4 * out + 0.2 * rumble + 1.7 * teeth / np.max(np.abs(teeth)) + 0.2 * whirr)


def chain():
    """Links that run over a wheel; 3 s."""
    length, r = 3.0, rng(38)
    out = np.zeros(int(length * RATE))
    count = 36
    for k in range(count):
        base = r.uniform(0.85, 1.2)
        link = struck([(1310 * base, 1, 0.09), (2480 * base, 0.8, 0.07), (3720 * base, 0.6, 0.06), (5630 * base, 0.4, 0.04)], 0.0003, 0.14, r, 0.03)
        put_around(out, link, (k + r.uniform(-0.25, 0.25)) * length / count % length, r.uniform(0.25, 1.0))
        put_around(out, thump(190 * base, 0.03, r, 0.06), k * length / count, 0.25)
    return steady(out)


def belt():
    """Slats over rollers; 4 s."""
    length, r = 4.0, rng(39)
    out = 0.45 * around_noise(length, lambda f: bump_at(f, 260, 0.9), r) * around_line(length, 40, r, 0.6, 1.0)
    for k in range(40):
        base = r.uniform(0.85, 1.2)
        slat = [(280 * base, 0.7, 0.06), (510 * base, 0.9, 0.05), (890 * base, 0.8, 0.04), (1640 * base, 0.5, 0.025), (2700 * base, 0.25, 0.015)]
        knock = struck(slat, 0.0007, 0.12, r, 0.04)
        at = (k + r.uniform(-0.12, 0.12)) % 40 * length / 40
        put_around(out, knock / np.max(np.abs(knock)), at, r.uniform(0.8, 2.2))
        put_around(out, puff(0.06, r.uniform(900, 1500), 0.7, r), at, 0.5)
    return steady(out)


# ---- Single sounds ------------------------------------------------------------------------------------------------------


def slam(n):
    """Tons of iron and stone come down."""
    r = rng(41, n)
    out = silence(1.6)
    put(out, thump(48 * r.uniform(0.95, 1.05), 0.45, r, 0.9), 0.001, 0.6)
    put(out, thump(96 * r.uniform(0.95, 1.05), 0.2, r, 0.5), 0.001, 0.75)
    put(out, puff(0.25, r.uniform(1000, 1500), 0.4, r, 0.002), 0.0, 1.2)
    plate = [(131 * k, 0.8 / (1 + 0.2 * i), 1.1 / (1 + 0.35 * i)) for i, k in enumerate([1, 1.52, 2.3, 2.77, 3.9, 5.1, 6.8, 9.0, 12.1])]
    put(out, struck(plate, 0.0005, 1.3, r, 0.04), 0.0, 0.8)
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
    put(out, struck(iron, 0.0005, 0.4, r, 0.05), 0.001, 0.6)
    put(out, struck(iron, 0.0005, 0.4, r, 0.06), r.uniform(0.06, 0.12), r.uniform(0.25, 0.45))
    put(out, thump(92 * r.uniform(0.9, 1.1), 0.09, r), 0.001, 0.28)
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
    put(out, struck([(210, 1, 0.1), (560, 0.9, 0.07), (1240, 0.7, 0.05), (2300, 0.4, 0.03)], 0.0005, 0.2, r, 0.05), 0.0, 0.5)
    put(out, thump(90, 0.12, r), 0.0, 0.4)
    put(out, fade(grind, 0.03, 0.2), 0.0, 1.0)
    put(out, thump(74, 0.2, r, 0.5), 1.22, 0.8)
    put(out, struck([(180, 1, 0.12), (420, 0.8, 0.08), (960, 0.5, 0.05)], 0.0008, 0.3, r, 0.03), 1.22, 0.6)
    put(out, grains(0.5, 600 * swell(seconds(0.5), 0.01, 0.3), (0.002, 0.012), (900, 4500), r), 1.22, 0.5)
    return level(finish(out, end=0.3), -19)


def lever(n):
    """A plate gives way under a foot, something in the wall answers."""
    r = rng(44, n)
    out = silence(0.9)
    base = r.uniform(0.88, 1.14)
    put(out, struck([(340 * base, 1, 0.06), (910 * base, 0.8, 0.05), (1730 * base, 0.6, 0.04)], 0.0006, 0.15, r, 0.04), 0.0, 0.4)
    put(out, thump(92 * base, 0.1, r), 0.0, 0.3)
    put(out, grains(0.2, 500 * swell(seconds(0.2), 0.01, 0.15), (0.002, 0.01), (1200, 4800), r), 0.0, 0.3)
    at, pace = r.uniform(0.13, 0.17), r.uniform(0.04, 0.06)
    for k in range(int(r.integers(4, 7))):
        pawl = struck([(1180 * base, 1, 0.05), (1830 * base, 0.6, 0.04), (2660 * base, 0.7, 0.03)], 0.0003, 0.08, r, 0.06)
        put(out, pawl, at, 0.2 * r.uniform(0.6, 1.0))
        at += pace * r.uniform(0.85, 1.2)
    put(out, thump(98 * base, 0.12, r), at + 0.03, 0.2)
    put(out, struck([(240 * base, 1, 0.12), (530 * base, 0.8, 0.09), (1270 * base, 0.6, 0.06)], 0.0006, 0.25, r, 0.04), at + 0.03, 0.45)
    return level(finish(out, end=0.2), -21)


def swing(n):
    """The lantern's handle in its eye."""
    r = rng(45, n)
    length = 0.5
    t = seconds(length)
    f = 780 * r.uniform(0.85, 1.2)
    slips = np.cumsum(wander(length, 30, r, 0.9, 1.1)[: len(t)] * f * (1 + 0.06 * np.sin(TAU * r.uniform(3, 6) * t))) / RATE
    squeak = sum(np.sin(TAU * k * slips + k) / k for k in (1, 2, 3, 5)) * wander(length, 40, r)[: len(t)] ** 2 * swell(t, 0.05, 0.25)
    out = silence(0.6)
    put(out, squeak, 0.02, 0.07)
    eye = [(930, 0.7, 0.14), (1720, 1, 0.12), (2870, 0.8, 0.1), (4630, 0.4, 0.07)]
    for at, gain in [(0.0, 1.0), (r.uniform(0.05, 0.12), 0.5), (r.uniform(0.16, 0.26), 0.3)]:
        put(out, struck(eye, 0.0003, 0.2, r, 0.05), at, 0.15 * gain)
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
    put(out, thump(78, 0.22, r, 0.6), 0.001, 0.6)
    put(out, puff(0.2, r.uniform(700, 1000), 0.5, r, 0.002), 0.0, 2.2)
    for _ in range(70):
        f, time, at = 10 ** r.uniform(2.4, 3.3), r.uniform(0.02, 0.08), 0.08 + r.gamma(2.0, 0.28)
        s = seconds(time * 2)
        chirp = np.sin(TAU * np.cumsum(f * (1 + 0.5 * s / time)) / RATE) * swell(s, 0.004, time * 1.6)
        put(out, fade(chirp, 0.001, 0.004), at, r.uniform(0.05, 0.35))
    return level(finish(out, end=0.5), -17)


def drip(n):
    """A drop in a cave."""
    r = rng(47, n)
    f = [760, 1020, 1390][n] * r.uniform(0.95, 1.05)
    t = seconds(0.12)
    drop = np.sin(TAU * np.cumsum(f * (1 + 1.4 * np.clip(t / 0.05, 0, 1))) / RATE) * swell(t, 0.003, 0.07)
    out = silence(0.3)
    put(out, fade(drop, 0.001, 0.01), 0.0)
    put(out, fade(drop, 0.001, 0.01), r.uniform(0.05, 0.14), 0.3)
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
