"""What the hero does to the ground and to walls: steps, landings, slides, climbing.

A step is two blows, the heel's and a little later the ball's: each strikes the modes of what is under it, moves its grit,
and thumps. Armour and leather move along, quietly.
"""

import numpy as np

from synth import RATE, band, db, decay, fade, finish, grains, high, level, low, modes, moving_band, noise, pulse, put
from synth import respond, rng, room, in_room, seconds, silence, struck, swell, transform, wander

STEPS = 6
FEW = 4


def thump(f, time, r, length=0.3):
    """The ground gives way: a low tone that falls a little."""
    t = seconds(length)
    phase = np.cumsum(f * (1 + 0.6 * decay(t, 0.05))) / RATE
    return np.sin(2 * np.pi * phase + r.uniform(0, 0.4)) * swell(t, 0.004, time)


def puff(length, f, q, r, attack=0.004):
    """Dust and air under a sole."""
    t = seconds(length)
    return band(noise(length, r), f, q)[: len(t)] * swell(t, attack, length * 0.8)


def mail(length, r, amount=1.0):
    """Rings of mail and a buckle that shift."""
    t = seconds(length)
    density = 260 * swell(t, length * 0.25, length * 0.8)
    rings = grains(length, density, (0.008, 0.03), (3800, 9500), r)
    return amount * high(rings, 3000)[: len(t)]


def rock_body(r, hard):
    base = r.uniform(0.9, 1.12)
    partials = [(210 * base, 0.8, 0.05), (480 * base, 0.6, 0.03), (1130 * base, 0.5, 0.018), (2350 * base, 0.35, 0.012)]
    return struck(partials, 0.0009 / hard, 0.12, r, 0.07)


def masonry_body(r, hard):
    base = r.uniform(0.92, 1.1)
    partials = [(170 * base, 0.35, 0.06), (620 * base, 0.8, 0.05), (1280 * base, 0.9, 0.04), (1990 * base, 0.7, 0.03)]
    partials += [(3150 * base, 0.4, 0.02), (4700 * base, 0.2, 0.012)]
    return struck(partials, 0.0005 / hard, 0.16, r, 0.06)


def timber_body(r, hard):
    base = r.uniform(0.88, 1.14)
    partials = [(118 * base, 0.25, 0.10), (183 * base, 0.5, 0.11), (271 * base, 0.8, 0.11), (408 * base, 0.9, 0.09)]
    partials += [(596 * base, 0.9, 0.075), (870 * base, 0.9, 0.06), (1370 * base, 0.7, 0.04), (2160 * base, 0.5, 0.025)]
    return struck(partials, 0.0008 / hard, 0.35, r, 0.05)


def iron_body(r, hard):
    base = r.uniform(0.94, 1.07)
    ratios = [1, 1.31, 1.72, 2.09, 2.61, 2.92, 3.6, 4.22, 4.95, 5.97, 7.1, 8.3, 9.7, 11.3, 13.4, 16.2]
    partials = [(197 * base * k, 0.3 + 0.2 * np.sin(np.pi * i / 12), 0.3 / (1 + 0.13 * i)) for i, k in enumerate(ratios)]
    return struck(partials, 0.0003 / hard, 0.6, r, 0.04)


BODIES = {"rock": rock_body, "masonry": masonry_body, "timber": timber_body, "iron": iron_body}


def blow(material, r, hard):
    """One contact with a material."""
    out = silence(0.6)
    body = BODIES[material](r, hard)
    body /= np.max(np.abs(body)) + 1e-9
    weight = {"rock": (0.5, 0.2, 112), "masonry": (0.75, 0.13, 104), "timber": (0.8, 0.07, 96), "iron": (0.7, 0.08, 100)}[material]
    put(out, body, 0.0, weight[0])
    put(out, thump(weight[2] * r.uniform(0.9, 1.1), 0.055, r), 0.0, weight[1])
    grit = {"rock": (2600, 1.0), "masonry": (700, 0.45), "timber": (260, 0.3), "iron": (300, 0.3)}[material]
    t = seconds(0.2)
    sound = grains(0.2, grit[0] * swell(t, 0.012, 0.13), (0.002, 0.011), (1300, 6800), r)
    sound += 0.16 * puff(0.2, r.uniform(1700, 2600), 0.6, r)
    put(out, sound, 0.002, grit[1])
    return out


def step(material, n):
    r = rng(11, list(BODIES).index(material), n)
    out = silence(0.75)
    gap = r.uniform(0.04, 0.075)
    put(out, blow(material, r, r.uniform(0.8, 1.2)), 0.001, 1.0)
    put(out, blow(material, r, r.uniform(0.45, 0.8)), 0.001 + gap, r.uniform(0.3, 0.6))
    put(out, mail(0.14, r), 0.0, 0.05)
    if material == "timber" and n % 3 == 2:
        put(out, creak(0.25, r), 0.06, 0.10)
    if material == "iron":
        rattle = grains(0.3, 90 * swell(seconds(0.3), 0.02, 0.25), (0.02, 0.06), (1100, 3600), r)
        put(out, rattle, 0.02, 0.25)
    length = {"rock": 0.32, "masonry": 0.32, "timber": 0.42, "iron": 0.6}[material]
    return level(finish(out[: int(length * RATE)], end=0.08), -20)


def creak(length, r):
    """A beam under load: sticks and slips faster and slower."""
    t = seconds(length)
    rate = wander(length, 6, r, 35, 95)[: len(t)]
    phase = np.cumsum(rate) / RATE
    slips = np.diff(np.floor(phase), prepend=0) * r.uniform(0.5, 1.0, len(t))
    body = modes(0.06, [(410, 1, 0.05), (730, 0.8, 0.04), (1240, 0.6, 0.03), (2100, 0.3, 0.02)], r, 0.05)
    sound = respond(slips, lambda w: np.fft.rfft(body, 2 * (len(w) - 1)))
    return sound * swell(t, length * 0.3, length * 0.9)


def land_soft(n):
    r = rng(12, n)
    out = silence(0.5)
    other = r.uniform(0.012, 0.035)
    put(out, thump(88 * r.uniform(0.9, 1.15), 0.1, r), 0.001, 0.38)
    put(out, thump(148 * r.uniform(0.9, 1.15), 0.06, r), other, 0.3)
    for at, gain in [(0.001, 1.0), (other, r.uniform(0.5, 0.9))]:
        put(out, rock_body(r, r.uniform(0.35, 0.6)), at, 0.22 * gain)
        put(out, puff(0.22, r.uniform(650, 1100), 0.5, r, 0.002), at, 0.5 * gain)
    put(out, grains(0.2, 900 * swell(seconds(0.2), 0.01, 0.15), (0.002, 0.01), (1300, 5600), r), 0.004, 0.5)
    put(out, mail(0.2, r), 0.008, 0.14)
    put(out, cloth_body(0.3, r, 700), 0.02, 0.25)
    return level(finish(out, end=0.1), -20)


def land_hard(n):
    r = rng(13, n)
    out = silence(1.1)
    put(out, thump(62 * r.uniform(0.95, 1.06), 0.22, r, 0.5), 0.001, 0.6)
    put(out, thump(118, 0.12, r, 0.4), 0.005, 0.65)
    put(out, rock_body(r, 0.7), 0.001, 1.2)
    t = seconds(0.9)
    rubble = 2100 * swell(t, 0.015, 0.30) + 120 * swell(t, 0.1, 0.9)
    put(out, low(grains(0.9, rubble, (0.002, 0.016), (700, 5600), r), 6500), 0.006, 1.3)
    put(out, mail(0.35, r), 0.02, 0.16)
    clank = struck([(880, 0.6, 0.2), (1410, 0.8, 0.16), (2290, 0.6, 0.12), (3470, 0.5, 0.09)], 0.0003, 0.3, r, 0.05)
    put(out, clank, r.uniform(0.03, 0.06), 0.04)
    put(out, puff(0.6, 420, 0.5, r, 0.02), 0.01, 0.3)
    return level(finish(out, end=0.25), -16)


def cloth_body(length, r, f=1100):
    """Heavy cloth that moves: noise that comes and goes like a fold."""
    t = seconds(length)
    flaps = wander(length, 22, r, 0.15, 1.0)[: len(t)] ** 2
    sound = low(band(noise(length, r), f, 0.5)[: len(t)], 3 * f) + 0.22 * band(noise(length, r), f * 3.1, 0.7)[: len(t)]
    return sound * flaps * swell(t, min(0.02, length * 0.1), length * 0.95)


def jump(n):
    """The sole pushes off, breath goes, cloth is pulled up."""
    r = rng(14, n)
    out = silence(0.55)
    scuff = grains(0.12, 1300 * swell(seconds(0.12), 0.004, 0.1), (0.002, 0.008), (1300, 5200), r)
    put(out, scuff, 0.0, 0.4)
    put(out, puff(0.08, r.uniform(600, 900), 0.6, r, 0.002), 0.0, 0.6)
    put(out, thump(105 * r.uniform(0.92, 1.1), 0.07, r), 0.0, 0.34)
    length = r.uniform(0.16, 0.2)
    t = seconds(length)
    breath = noise(length, r) * swell(t, 0.022, length)
    voice = sum(g * band(breath, f * r.uniform(0.95, 1.05), q)[: len(t)] for f, q, g in [(620, 5, 1.0), (1180, 6, 0.8), (2650, 7, 0.4)])
    put(out, voice, 0.004, 1.1)
    put(out, cloth_body(0.4, r, r.uniform(650, 900)), 0.02, 0.4)
    put(out, mail(0.2, r), 0.03, 0.10)
    return level(finish(out, end=0.12), -21)


def cloth(n):
    r = rng(15, n)
    out = silence(0.45)
    put(out, puff(0.06, r.uniform(500, 800), 0.6, r, 0.002), 0.0, 0.9)
    put(out, cloth_body(0.42, r, r.uniform(600, 850)), 0.0)
    put(out, mail(0.25, r), 0.03, 0.08)
    return level(finish(out, end=0.1), -22)


def bump(n):
    """A shoulder meets stone."""
    r = rng(16, n)
    out = silence(0.45)
    put(out, thump(112 * r.uniform(0.85, 1.2), 0.08, r), 0.001, 0.3)
    put(out, masonry_body(r, r.uniform(0.4, 0.7)), 0.001, 0.9)
    put(out, puff(0.1, r.uniform(700, 1100), 0.6, r, 0.002), 0.001, 0.7)
    put(out, mail(0.2, r), 0.002, 0.3)
    put(out, grains(0.4, 260 * swell(seconds(0.4), 0.05, 0.3), (0.002, 0.008), (1500, 6000), r), 0.03, 0.3)
    return level(finish(out, end=0.1), -20)


def wall_jump(n):
    r = rng(17, n)
    out = silence(0.6)
    put(out, blow("rock", r, 0.9), 0.001, 0.9)
    put(out, blow("rock", r, 0.7), 0.05, 0.45)
    put(out, jump(20 + n), 0.03, 0.8)
    crumbs = grains(0.45, 300 * swell(seconds(0.45), 0.1, 0.35), (0.002, 0.009), (1400, 5200), r)
    put(out, crumbs, 0.08, 0.45)
    return level(finish(out, end=0.12), -19)


def grab(n):
    """Two gloves slap onto an edge, the body swings against the wall."""
    r = rng(18, n)
    out = silence(0.6)
    for at, gain in [(0.0, 0.9), (r.uniform(0.03, 0.065), 0.65)]:
        slap = band(noise(0.09, r), 1300, 0.6)[: int(0.09 * RATE)] * decay(seconds(0.09), 0.06)
        put(out, slap, at, gain * 0.9)
        put(out, thump(150, 0.05, r), at, gain * 0.35)
        put(out, masonry_body(r, r.uniform(0.3, 0.6)), at, gain * 0.35)
    put(out, grains(0.25, 700 * swell(seconds(0.25), 0.02, 0.2), (0.002, 0.008), (1500, 6000), r), 0.01, 0.45)
    put(out, thump(104, 0.08, r), r.uniform(0.11, 0.15), 0.22)
    put(out, mail(0.3, r), 0.1, 0.25)
    put(out, cloth_body(0.3, r, 800), 0.08, 0.35)
    return level(finish(out, end=0.12), -20)


def scrape(n):
    """A boot and a glove find the next hold."""
    r = rng(19, n)
    length = r.uniform(0.26, 0.34)
    t = seconds(length)
    rough = wander(length, 60, r, 0.1, 1.0)[: len(t)]
    sound = band(noise(length, r), r.uniform(900, 1600), 0.7)[: len(t)] * rough * swell(t, 0.03, length)
    out = silence(0.5)
    put(out, sound, 0.0, 0.9)
    put(out, grains(0.35, 600 * swell(seconds(0.35), 0.08, 0.25), (0.002, 0.01), (1200, 5500), r), 0.0, 0.8)
    put(out, thump(120, 0.06, r), 0.0, 0.12)
    put(out, rock_body(r, r.uniform(0.5, 0.9)), 0.0, 0.35)
    return level(finish(out, end=0.1), -22)


def rung(n):
    """Glove and boot on a wooden rung in iron clamps."""
    r = rng(20, n)
    out = silence(0.4)
    base = r.uniform(0.92, 1.1)
    wood = [(310 * base, 1.0, 0.09), (655 * base, 0.7, 0.06), (1120 * base, 0.4, 0.04), (1830 * base, 0.2, 0.025)]
    put(out, struck(wood, 0.0008, 0.2, r, 0.05), 0.001, 0.6)
    put(out, struck(wood, 0.0011, 0.2, r, 0.05), r.uniform(0.05, 0.09), r.uniform(0.2, 0.4))
    put(out, thump(110, 0.05, r), 0.001, 0.08)
    put(out, band(noise(0.06, r), 1600, 0.7)[: int(0.06 * RATE)] * decay(seconds(0.06), 0.04), 0.0, 0.2)
    if n % 2:
        put(out, creak(0.2, r), 0.08, 0.04)
    put(out, mail(0.15, r), 0.02, 0.06)
    return level(finish(out, end=0.1), -22)


def rope(n):
    """A hand closes on a vine or a rope, which stretches; leaves brush."""
    r = rng(21, n)
    length = 0.42
    t = seconds(length)
    fibres = grains(length, 500 * swell(t, 0.07, 0.3), (0.003, 0.012), (500, 2400), r)
    leaves = low(high(band(noise(length, r), 3400, 0.5)[: len(t)] * wander(length, 30, r)[: len(t)] ** 3 * swell(t, 0.09, 0.36), 1400), 5200)
    out = silence(0.45)
    put(out, fibres, 0.0, 0.8)
    put(out, leaves, 0.02, 0.35)
    put(out, creak(0.2, r), 0.05, 0.05)
    put(out, puff(0.07, r.uniform(500, 800), 0.7, r, 0.002), 0.0, 1.6)
    put(out, thump(140, 0.05, r), 0.0, 0.12)
    return level(finish(out, end=0.1), -23)


def sounds():
    """All of them: (name, signal)."""
    for material in BODIES:
        for n in range(STEPS):
            yield f"step_{material}_{n + 1}", step(material, n)
    for make in [land_soft, land_hard, jump, cloth, bump, wall_jump, grab, scrape, rung, rope]:
        for n in range(FEW):
            yield f"{make.__name__}_{n + 1}", make(n)
