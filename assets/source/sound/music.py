"""Two pieces of music, each in four layers of equal length that may sound in any mixture: pad, pulse, melody, tension.

Everything wraps around: notes and their reverberation go on at the beginning, so that a piece can be repeated for ever.
Notes are MIDI numbers (62 is D4), times are beats.
"""

import numpy as np

from synth import RATE, TAU, around_line, around_noise, around_room, band, db, decay, fade, grains, high, low, loudness, modes
from synth import noise, put_around, respond, rng, room, seconds, string, struck, swell, wander

TABLE = 2048
OO, AH, MM = [(330, 1.0, 70), (820, 0.3, 110), (2500, 0.05, 200)], [(640, 1.0, 110), (1080, 0.6, 120), (2600, 0.12, 220)], [(240, 1.0, 60), (1000, 0.08, 150), (2200, 0.02, 250)]


def hertz(note):
    return 440 * 2 ** ((note - 69) / 12)


class Song:
    """A circle of so many beats."""

    def __init__(self, tempo, beats, seed):
        self.beat = 60 / tempo
        self.length = beats * self.beat
        self.seed = seed
        self.beats = beats

    def layer(self):
        return np.zeros((2, int(round(self.length * RATE))))

    def put(self, layer, signal, beat, gain=1.0, pan=0.0):
        """A signal of one row, from a side; of two rows, as it is."""
        if signal.ndim == 1:
            angle = (pan + 1) * np.pi / 4
            signal = np.sqrt(2) * np.stack([np.cos(angle) * signal, np.sin(angle) * signal])
        put_around(layer, signal, beat * self.beat % self.length, gain)


# ---- Instruments ---------------------------------------------------------------------------------------------------------


def vowel_table(f, formants):
    """One period of a voice: harmonics, as loud as the mouth lets them."""
    k = np.arange(1, max(2, int(7000 / f)))
    mouth = sum(g * np.exp(-0.5 * ((k * f - middle) / width) ** 2) for middle, g, width in formants)
    lines = np.zeros(TABLE // 2 + 1, dtype=complex)
    count = min(len(k), TABLE // 2)
    lines[1 : count + 1] = ((0.04 + mouth) / k**0.9)[:count] * np.exp(1j * np.arange(count) * 2.4)
    table = np.fft.irfft(lines, TABLE)
    return table / np.sqrt(np.mean(table**2))


def choir(note, length, r, first=OO, second=AH, voices=3, attack=2.4, release=3.2):
    """Some voices on one note, which open and close their mouths and never sing quite the same; left and right."""
    t = seconds(length)
    out = np.zeros((2, len(t)))
    f = hertz(note)
    tables = [vowel_table(f, vowel) for vowel in (first, second)]
    opened = 0.5 - 0.5 * np.cos(TAU * np.clip(t / length, 0, 1))
    for voice in range(voices):
        drift = 2 ** (wander(length, 0.9, r, -7, 7)[: len(t)] / 1200)
        depth = 2 ** (9 / 1200) - 1
        vibrato = 1 + depth * np.sin(TAU * r.uniform(4.3, 5.3) * t + r.uniform(0, TAU)) * np.clip(t / 2.5, 0, 1)
        phase = (np.cumsum(f * drift * vibrato) / RATE + r.uniform()) % 1 * TABLE
        index = phase.astype(int)
        share = phase - index
        sung = 0
        for table, weight in zip(tables, (1 - 0.7 * opened, 0.7 * opened)):
            ring = np.append(table, table[0])
            sung = sung + weight * (ring[index] * (1 - share) + ring[index + 1] * share)
        sung = sung * wander(length, 1.3, r, 0.6, 1.0)[: len(t)]
        side = 0.5 + 0.4 * (voice / max(1, voices - 1) * 2 - 1) * r.uniform(0.7, 1.0)
        out += np.array([[np.sqrt(1 - side)], [np.sqrt(side)]]) * sung
    shape = np.minimum(1, 0.5 - 0.5 * np.cos(np.pi * np.clip(t / attack, 0, 1)))
    shape = shape * (0.5 - 0.5 * np.cos(np.pi * np.clip((length - t) / release, 0, 1)))
    return out * shape / voices


def bowed(f, length, r, bright=0.5):
    """A sheet of metal or a cymbal's rim under a bow: its modes, each swelling by itself, rough at their edges."""
    t = seconds(length)
    out = np.zeros((2, len(t)))
    for k, gain in [(1, 1.0), (2.32, 0.45), (2.76, 0.6 * bright), (4.25, 0.35 * bright), (5.4, 0.25 * bright), (8.9, 0.1 * bright)]:
        rough = np.cumsum(noise(length, r))[: len(t)]
        rough = 0.12 * high(low(rough, 30), 2) / 40
        tone = np.sin(TAU * f * k * t * (1 + 0.0005 * r.standard_normal()) + rough + r.uniform(0, TAU))
        side = r.uniform(0.15, 0.85)
        out += gain * np.array([[np.sqrt(1 - side)], [np.sqrt(side)]]) * tone * wander(length, 1.6, r, 0.1, 1.0)[: len(t)] ** 1.5
    shape = np.sin(np.pi * np.clip(t / length, 0, 1)) ** 1.4
    return out * shape


def harp(note, r, velocity=1.0, length=4.0):
    """A plucked string of gut on a small body."""
    f = hertz(note)
    n = int(RATE / f)
    burst = low(noise(0.04, r), 900 + 2600 * velocity)[: n + 300] * np.hanning(n + 300)
    # Plucked at a fifth of its length: every fifth overtone is weak.
    burst = respond(burst, lambda w: 1 - 0.85 * np.exp(-1j * w * n / 5))
    tone = string(burst, f, 4.8 * (220 / f) ** 0.35, 0.45 + 0.3 * velocity, length, 0.0)
    tone = tone / np.max(np.abs(tone))
    body = band(tone, 190, 1.2) * 0.5 + band(tone, 430, 1.5) * 0.35
    return fade(tone + body, 0.001, 1.0) * velocity


def bell(note, r, velocity=1.0, length=7.0):
    """A bronze bell, struck with wood."""
    f = hertz(note)
    ratios = [(0.5, 0.45, 1.0), (1, 0.8, 0.75), (1.19, 0.4, 0.6), (1.5, 0.25, 0.5), (2, 0.8, 0.5), (2.67, 0.25, 0.3)]
    ratios += [(3.01, 0.3, 0.24), (4.1, 0.2, 0.16), (5.43, 0.12, 0.1)]
    long = length * (520 / f) ** 0.3
    out = struck([(f * k, g, long * d) for k, g, d in ratios], 0.0007, length, r, 0.001)
    return fade(out / np.max(np.abs(out)), 0.001, 1.5) * velocity


def drum(f, r, velocity=1.0, skin=0.5):
    """A large frame drum, struck softly near its middle."""
    t = seconds(1.6)
    out = 0
    for k, g, time in [(1, 1.0, 1.0), (1.59, 0.4 * skin, 0.5), (2.14, 0.25 * skin, 0.35), (2.3, 0.2 * skin, 0.3), (2.92, 0.12 * skin, 0.2)]:
        phase = np.cumsum(f * k * (1 + 0.18 * decay(t, 0.12))) / RATE
        out = out + g * np.sin(TAU * phase) * swell(t, 0.005, time)
    slap = band(noise(1.6, r), 900, 0.6)[: len(t)] * swell(t, 0.002, 0.06) * 0.16 * skin
    return fade((out + slap) * velocity, 0.001, 0.2)


def shaker(r, velocity=1.0):
    t = seconds(0.14)
    return fade(high(noise(0.14, r), 4200)[: len(t)] * swell(t, 0.03, 0.09) * 0.2 * velocity, 0.002, 0.02)


# ---- Dusk: D dorian, slow, open ----------------------------------------------------------------------------------------


def dusk():
    song = Song(60, 112, 71)
    chords = [
        (38, [45, 53, 57, 64]), (38, [45, 53, 60, 64]), (41, [48, 53, 57, 64]), (40, [48, 52, 55, 62]),
        (43, [50, 55, 59, 62]), (45, [48, 52, 55, 64]), (38, [45, 50, 57, 65]), (38, [45, 52, 57, 65]),
        (41, [48, 57, 60, 64]), (36, [48, 55, 62, 64]), (40, [47, 52, 55, 62]), (43, [50, 55, 59, 64]),
        (45, [52, 57, 62, 64]), (45, [52, 57, 60, 64]),
    ]
    span = 8

    pad = song.layer()
    r = rng(song.seed, 1)
    for index, (bass, notes) in enumerate(chords):
        start, length = index * span, span * song.beat + 3.2
        song.put(pad, choir(bass, length, r, MM, OO, 2), start, 0.5)
        for place, note in enumerate(notes):
            vowels = (OO, AH) if place > 1 else (MM, OO)
            song.put(pad, choir(note, length, r, *vowels, 3), start + 0.15 * place, [0.42, 0.36, 0.30, 0.2][place])
        song.put(pad, bowed(hertz(notes[-1] + 12), length, r, 0.4), start + 1, 0.030)
    pad = around_room(pad, room(4.0, 0.5, r), 0.55)

    pulse = song.layer()
    r = rng(song.seed, 2)
    # How much goes on under each chord: it grows towards the theme's summits and lies down between them.
    busy = [0.5, 0.7, 0.85, 1.0, 0.9, 0.65, 0.4, 0.7, 0.85, 1.0, 0.95, 0.8, 0.55, 0.35]
    for bar in range(28):
        bass, force = chords[bar // 2][0], busy[bar // 2]
        beat = bar * 4
        song.put(pulse, drum(76, r, 0.9 * force), beat, 0.55)
        if force > 0.5:
            song.put(pulse, drum(114, r, 0.4 * force), beat + 2.5, 0.35, 0.2)
        if bar % 4 == 3:
            song.put(pulse, drum(114, r, 0.3), beat + 3.5, 0.3, -0.25)
        for place, (at, step, velocity) in enumerate([(0, 0, 0.8), (1, 7, 0.45), (1.5, 12, 0.5), (2.5, 7, 0.45), (3, 0, 0.35), (3.5, 12, 0.4)]):
            if r.uniform() < 0.3 + 0.7 * force or place == 0:
                note = bass + 12 + step
                song.put(pulse, low(harp(note, r, velocity * r.uniform(0.8, 1.1), 2.5), 1800), beat + at + r.normal(0, 0.008), 0.26 * (0.5 + 0.5 * force), 0.25 * (-1) ** place)
        for at in np.arange(0.5, 4, 1):
            if force > 0.6:
                song.put(pulse, shaker(r, force * r.uniform(0.5, 1.0)), beat + at + r.normal(0, 0.01), 0.22, 0.45)
    pulse = around_room(pulse, room(1.8, 0.5, r), 0.22)

    melody = song.layer()
    r = rng(song.seed, 3)
    # A theme of four phrases, each over a chord: a turn upwards that is answered, climbs, and comes down. It is told twice, the
    # second time higher and to its end; between and after is room. (beat, note, velocity)
    phrases = [
        (8, [(0, 69, 0.75), (1.5, 72, 0.55), (2, 74, 0.8), (3, 72, 0.55), (4, 69, 0.65)]),
        (16, [(0, 69, 0.75), (1.5, 72, 0.55), (2, 76, 0.8), (3, 74, 0.55), (4, 72, 0.65)]),
        (24, [(0, 67, 0.7), (1.5, 72, 0.6), (2, 74, 0.7), (3, 76, 0.75), (4, 79, 0.9)]),
        (32, [(0, 76, 0.75), (1, 74, 0.6), (2, 71, 0.7), (3, 69, 0.55), (4, 67, 0.6), (8, 69, 0.65)]),
        (56, [(0, 69, 0.7), (1.5, 72, 0.55), (2, 74, 0.75), (3, 72, 0.55), (4, 69, 0.6), (7, 69, 0.5)]),
        (64, [(0, 72, 0.75), (1.5, 74, 0.6), (2, 77, 0.9), (3, 76, 0.6), (4, 72, 0.65)]),
        (72, [(0, 67, 0.7), (1.5, 72, 0.6), (2, 74, 0.7), (3, 76, 0.75), (4, 79, 0.9), (6, 76, 0.55)]),
        (80, [(0, 79, 0.85), (1, 76, 0.65), (2, 74, 0.7), (3, 71, 0.6), (4, 76, 0.75)]),
        (88, [(0, 74, 0.7), (1.5, 71, 0.55), (2, 69, 0.65), (3, 67, 0.55), (4, 64, 0.6), (8, 69, 0.6), (10, 62, 0.65)]),
    ]
    for start, notes in phrases:
        for at, note, velocity in notes:
            song.put(melody, harp(note, r, velocity), start + at + r.normal(0, 0.015), 0.34, -0.15)
            if velocity > 0.7:
                song.put(melody, harp(note - 12, r, velocity * 0.6), start + at + 0.04, 0.2, 0.1)
    for beat, note, velocity in [(14, 81, 0.3), (30, 84, 0.25), (44, 76, 0.45), (45.5, 72, 0.4), (47, 69, 0.45), (51, 77, 0.3), (52.5, 74, 0.4),
                                 (70, 84, 0.25), (86, 83, 0.3), (100, 76, 0.4), (101.5, 81, 0.3), (106, 72, 0.4), (108, 69, 0.45), (110, 64, 0.4)]:
        song.put(melody, bell(note, r, velocity), beat, 0.30, 0.35)
    melody = around_room(melody, room(3.4, 0.7, r), 0.5)

    tension = strain(song, 38, rng(song.seed, 4), 4)
    return {"pad": (pad, -27), "pulse": (pulse, -28), "melody": (melody, -26), "tension": (tension, -29)}


# ---- Deep: E phrygian over machines and water ---------------------------------------------------------------------------


def deep():
    song = Song(72, 120, 72)
    chords = [
        (40, [47, 52, 55, 59]), (40, [47, 52, 57, 59]), (41, [48, 53, 57, 60]), (40, [47, 52, 55, 62]),
        (45, [48, 52, 57, 60]), (43, [50, 55, 59, 62]), (41, [48, 52, 57, 60]), (40, [47, 52, 53, 59]),
        (38, [45, 50, 53, 57]), (41, [48, 53, 55, 60]), (36, [48, 52, 55, 59]), (38, [45, 50, 57, 60]),
        (40, [47, 52, 57, 59]), (40, [47, 52, 55, 59]), (41, [48, 53, 57, 64]),
    ]
    span = 8

    pad = song.layer()
    r = rng(song.seed, 1)
    for index, (bass, notes) in enumerate(chords):
        start, length = index * span, span * song.beat + 3.0
        song.put(pad, choir(bass - 12, length, r, MM, MM, 2), start, 0.4)
        song.put(pad, choir(bass, length, r, MM, OO, 3), start, 0.5)
        for place, note in enumerate(notes):
            song.put(pad, choir(note, length, r, MM, OO, 3), start + 0.2 * place, [0.38, 0.3, 0.24, 0.16][place])
        song.put(pad, bowed(hertz(bass + 24), length, r, 0.8), start + 2, 0.045)
    pad = around_room(pad, room(5.0, 0.35, r), 0.6)

    pulse = song.layer()
    r = rng(song.seed, 2)
    busy = [0.5, 0.65, 0.85, 1.0, 0.7, 0.5, 0.8, 0.9, 1.0, 0.85, 0.45, 0.4, 0.75, 0.9, 0.6]
    for bar in range(30):
        bass = chords[bar // 2][0]
        beat = bar * 4
        force = busy[bar // 2]
        for at, f, velocity in [(0, 68, 1.0), (1.5, 102, 0.35), (2.75, 68, 0.5), (3.5, 102, 0.3)]:
            if at == 0 or force > 0.5:
                song.put(pulse, drum(f, r, force * velocity * r.uniform(0.85, 1.1)), beat + at, 0.5, 0.2 * np.sign(f - 80))
        for at, gain in [(1, 0.5), (3, 0.7)]:
            if force > 0.6:
                anvil = struck([(512, 1, 0.3), (1187, 0.7, 0.22), (1930, 0.5, 0.16), (2970, 0.4, 0.1)], 0.0007, 0.5, r, 0.01)
                song.put(pulse, fade(anvil / np.max(np.abs(anvil)), 0.001, 0.1), beat + at, 0.07 * gain * force, 0.4)
        # The second above the bass is a half tone over E alone; elsewhere it would leave the mode.
        turn = 13 if bar % 4 == 3 and bass == 40 else 7
        for place, (at, step) in enumerate([(0, 0), (0.5, 12), (1, 7), (2, 0), (2.5, 12), (3, turn)]):
            if r.uniform() < 0.35 + 0.65 * force or place == 0:
                song.put(pulse, low(harp(bass + 12 + step, r, r.uniform(0.5, 0.8), 2.0), 1500), beat + at + r.normal(0, 0.006), 0.24 * (0.5 + 0.5 * force), 0.2 * (-1) ** place)
    pulse = around_room(pulse, room(2.4, 0.4, r), 0.3)

    melody = song.layer()
    r = rng(song.seed, 3)
    # A lament: a half tone up and back, then a fall; told three times, each time from elsewhere, with room between.
    phrases = [
        (0, [(0, 71, 0.65), (2, 72, 0.55), (3, 71, 0.55), (4, 67, 0.65)]),
        (8, [(0, 69, 0.6), (2, 71, 0.55), (3, 69, 0.55), (4, 64, 0.65)]),
        (16, [(0, 69, 0.6), (1, 72, 0.55), (2, 77, 0.75), (4, 76, 0.65), (6, 72, 0.5)]),
        (24, [(0, 74, 0.6), (1, 72, 0.5), (2, 71, 0.6), (4, 64, 0.65)]),
        (48, [(0, 72, 0.65), (2, 74, 0.55), (3, 72, 0.55), (4, 69, 0.65)]),
        (56, [(0, 71, 0.6), (2, 72, 0.55), (3, 71, 0.55), (4, 65, 0.6), (6, 64, 0.6)]),
        (64, [(0, 69, 0.6), (1, 72, 0.55), (2, 77, 0.75), (4, 74, 0.65), (6, 69, 0.5)]),
        (72, [(0, 69, 0.55), (1, 67, 0.5), (2, 65, 0.6), (4, 60, 0.6)]),
        (96, [(0, 71, 0.6), (2, 72, 0.5), (3, 71, 0.5), (4, 69, 0.6)]),
        (104, [(0, 67, 0.6), (2, 65, 0.5), (3, 64, 0.5), (4, 59, 0.65)]),
    ]
    for start, notes in phrases:
        for at, note, velocity in notes:
            song.put(melody, bell(note, r, velocity, 6.0), start + at, 0.26, -0.2)
            song.put(melody, harp(note - 12, r, velocity * 0.8), start + at + r.normal(0, 0.012), 0.26, 0.15)
    for beat, note in [(33, 76), (41, 74), (60, 71), (81, 76), (89, 74), (113, 72)]:
        song.put(melody, bowed(hertz(note), 5.0, r, 0.6), beat, 0.09)
    melody = around_room(melody, room(4.4, 0.6, r), 0.6)

    tension = strain(song, 40, rng(song.seed, 4), 3)
    return {"pad": (pad, -27), "pulse": (pulse, -28), "melody": (melody, -26), "tension": (tension, -29)}


def strain(song, root, r, group):
    """What danger adds to any harmony: a fifth that beats, bowed iron a semitone apart, a heart that hurries. Nothing of it is
    so low that small loudspeakers would lose it."""
    out = song.layer()
    bars = song.beats // 4
    for bar in range(0, bars, 4):
        length = 16 * song.beat + 2.5
        t = seconds(length)
        shape = np.sin(np.pi * np.clip(t / length, 0, 1)) ** 0.7
        drone = np.zeros((2, len(t)))
        for note, gain in [(root, 0.6), (root + 7, 0.55), (root + 12, 0.4), (root + 19, 0.2)]:
            for side, off in enumerate((-0.35, 0.35)):
                f = hertz(note) + off
                for k in range(1, 12):
                    # Each overtone breathes by itself, as under an uneven bow.
                    breath = wander(length, 1.1, r, 0.15, 1.0)[: len(t)]
                    drone[side] += gain * breath * np.sin(TAU * f * k * t + k * note + 0.6 * side) / k**1.1
        song.put(out, low(drone * shape, 1600), bar * 4, 0.10)
    for bar in range(1, bars, 3):
        high_note = root + 36 + r.choice([0, 1, 7, 8])
        song.put(out, bowed(hertz(high_note), 6.0, r, 1.0), bar * 4 + 1, 0.10)
        song.put(out, bowed(hertz(high_note + 1), 5.0, r, 0.8), bar * 4 + 2, 0.07)
    for beat in np.arange(0, song.beats, 1.0):
        for at, velocity in [(0, 0.8), (0.28, 0.45)]:
            song.put(out, drum(72, r, velocity * r.uniform(0.9, 1.05), 0.45), beat + at, 0.32)
        if int(beat) % group == group - 1:
            song.put(out, drum(130, r, 0.35, 0.9), beat + 0.75, 0.26, 0.3)
    return around_room(out, room(3.0, 0.4, r), 0.4)


def settle(layer, target):
    """Takes out what is too low to hear, on the circle, and brings the whole to a loudness; the peak stays below -3 dB."""
    n = layer.shape[-1]
    f = np.maximum(np.fft.rfftfreq(n, 1 / RATE), 1e-3)
    layer = np.fft.irfft(np.fft.rfft(layer) / (1 + (28 / f) ** 4), n)
    layer = layer * db(target - loudness(layer, layer.shape[-1] / RATE * 0.98))
    return layer * min(1.0, db(-3) / np.max(np.abs(layer)))


def pieces():
    """All layers: (name, signal)."""
    for make in (dusk, deep):
        for name, (layer, target) in make().items():
            yield f"{make.__name__}_{name}", settle(layer, target)
