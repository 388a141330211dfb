"""The instruments from which all sounds and all music of Edgewalker are made: numpy and nothing else.

A signal is an array of float64, one row of samples at RATE, or two rows (left, right). Filters and resonators are
applied exactly, as frequency responses of their recursions, to signals with room for what rings on. What shall loop
is made on a circle: its spectrum is drawn, or its notes and their reverberation wrap around the end.
"""

import subprocess
from pathlib import Path

import numpy as np

RATE = 48000
TAU = 2 * np.pi


def rng(*seed):
    """Random numbers that are the same on every run."""
    return np.random.Generator(np.random.PCG64([int(s) for s in seed]))


def seconds(length):
    """The times of the samples of so many seconds."""
    return np.arange(int(round(length * RATE))) / RATE


def silence(length):
    return np.zeros(int(round(length * RATE)))


def db(value):
    return 10 ** (value / 20)


def put(target, signal, at, gain=1.0):
    """Adds a signal to another at a time in seconds; what is past the end is cut off."""
    start = int(round(at * RATE))
    end = min(start + signal.shape[-1], target.shape[-1])
    if end > start >= 0:
        target[..., start:end] += gain * signal[..., : end - start]
    return target


def put_around(target, signal, at, gain=1.0):
    """The same on a circle: what is past the end goes on at the beginning."""
    length = target.shape[-1]
    where = (int(round(at * RATE)) + np.arange(signal.shape[-1])) % length
    for first in range(0, signal.shape[-1], length):
        part = slice(first, first + length)
        target[..., where[part]] += gain * signal[..., part]
    return target


# ---- Envelopes ---------------------------------------------------------------------------------------------------------


def decay(t, time):
    """Falls to a thousandth (60 dB) in a time."""
    return np.exp(-6.9 * t / time)


def swell(t, attack, release):
    """Rises smoothly in a time, then falls by 60 dB in another."""
    up = 0.5 - 0.5 * np.cos(np.pi * np.clip(t / attack, 0, 1))
    return up * np.where(t < attack, 1.0, decay(t - attack, release))


def fade(signal, begin=0.002, end=0.01):
    """Starts and ends at nothing, smoothly."""
    out = np.array(signal, dtype=float)
    n = out.shape[-1]
    a, b = min(n // 2, int(begin * RATE)), min(n // 2, int(end * RATE))
    if a:
        out[..., :a] *= 0.5 - 0.5 * np.cos(np.pi * np.arange(a) / a)
    if b:
        out[..., n - b :] *= 0.5 + 0.5 * np.cos(np.pi * (np.arange(b) + 1) / b)
    return out


def wander(length, speed, r, low=0.0, high=1.0):
    """A smooth random line between two values that bends so many times a second."""
    n = int(round(length * RATE))
    points = max(4, int(length * speed) + 4)
    return np.interp(np.linspace(0, points - 3, n), np.arange(points), smooth(r.uniform(low, high, points)))


def smooth(values):
    return np.convolve(np.pad(values, 1, mode="edge"), [0.25, 0.5, 0.25], mode="valid")


# ---- Filters: exact responses of recursions ------------------------------------------------------------------------


def respond(signal, response, ring=0.0):
    """Sends a signal through a linear filter given as a function of angular frequency per sample; keeps what rings on
    for so many seconds."""
    n = signal.shape[-1] + int(ring * RATE)
    size = 1 << int(np.ceil(np.log2(n + RATE // 2)))
    w = np.linspace(0, np.pi, size // 2 + 1)
    return np.fft.irfft(np.fft.rfft(signal, size) * response(w), size)[..., :n]


def two_poles(w, f, q, kind):
    """The response of a second-order section: "low", "high" or "band" (unit gain at its peak)."""
    w0 = TAU * min(f, RATE * 0.45) / RATE
    alpha, c = np.sin(w0) / (2 * q), np.cos(w0)
    z = np.exp(-1j * w)
    b = {"low": ((1 - c) / 2, 1 - c, (1 - c) / 2), "high": ((1 + c) / 2, -1 - c, (1 + c) / 2), "band": (alpha, 0, -alpha)}[kind]
    return (b[0] + b[1] * z + b[2] * z * z) / (1 + alpha - 2 * c * z + (1 - alpha) * z * z)


def low(signal, f, q=0.707):
    return respond(signal, lambda w: two_poles(w, f, q, "low"))


def high(signal, f, q=0.707):
    return respond(signal, lambda w: two_poles(w, f, q, "high"))


def band(signal, f, q=1.0):
    return respond(signal, lambda w: two_poles(w, f, q, "band"))


def moving_band(signal, f, q, hop=512):
    """A band-pass whose middle follows a line: blocks of it overlap."""
    out, window = np.zeros(len(signal)), np.hanning(2 * hop + 1)[:-1]
    padded = np.concatenate([np.zeros(hop), signal, np.zeros(3 * hop)])
    total = np.zeros(len(padded))
    for start in range(0, len(signal) + hop, hop):
        block = padded[start : start + 2 * hop] * window
        middle = f[min(start, len(f) - 1)]
        total[start : start + 2 * hop] += respond(block, lambda w: two_poles(w, middle, q, "band"))[: 2 * hop]
    out[:] = total[hop : hop + len(signal)]
    return out


# ---- Sources ------------------------------------------------------------------------------------------------------------


def noise(length, r):
    return r.standard_normal(int(round(length * RATE)))


def around_noise(length, spectrum, r):
    """Noise that loops: a spectrum (a function of frequency) with random phases, unit power."""
    n = int(round(length * RATE))
    f = np.fft.rfftfreq(n, 1 / RATE)
    lines = spectrum(np.maximum(f, 1.0)) * np.exp(1j * r.uniform(0, TAU, len(f)))
    lines[0] = 0
    out = np.fft.irfft(lines, n)
    return out / np.sqrt(np.mean(out**2))


def around_line(length, cycles, r, low=0.0, high=1.0):
    """A smooth random line that loops, made of its first so many harmonics."""
    t = np.arange(int(round(length * RATE))) / (length * RATE)
    out = sum(r.standard_normal() / k**0.5 * np.cos(TAU * (k * t + r.uniform())) for k in range(1, cycles + 1))
    out = (out - out.min()) / (out.max() - out.min())
    return low + (high - low) * out


def modes(length, partials, r=None, spread=0.0):
    """A struck body: partials (frequency, amplitude, 60 dB decay time), each a little off by chance."""
    t = seconds(length)
    out = np.zeros(len(t))
    for f, amplitude, time in partials:
        if r is not None:
            f, amplitude = f * (1 + spread * r.standard_normal()), amplitude * r.uniform(0.6, 1.2)
        if f < RATE * 0.45:
            out += amplitude * np.sin(TAU * f * t) * decay(t, time)
    return out


def pulse(width):
    """The force of a blow that lasts a time."""
    t = seconds(width)
    return np.sin(np.pi * t / width) ** 2


def struck(partials, width, length, r=None, spread=0.0):
    """A body struck by something so hard that they touch for a time: the longer, the duller. Nothing is left of what swings
    twice in that time, so it is some 0.2 ms for iron on iron, 0.4 ms for stone, 0.8 ms for wood."""
    force = pulse(width)
    return respond(modes(length, partials, r, spread), lambda w: transform(force, w))


def transform(force, w):
    """The spectrum of a short signal, of unit sum."""
    size = 2 * (len(w) - 1)
    return np.fft.rfft(force / force.sum(), size)


def grains(length, density, size, pitch, r):
    """Gravel: grit that rings for a moment, more often where the density (grains a second, a line) is high."""
    n = int(round(length * RATE))
    out = np.zeros(n)
    line = np.broadcast_to(np.asarray(density, dtype=float), (n,))
    for start in np.flatnonzero(r.uniform(size=n) < line / RATE):
        ring = 10 ** r.uniform(np.log10(size[0]), np.log10(size[1]))
        f = 10 ** r.uniform(np.log10(pitch[0]), np.log10(pitch[1]))
        t = seconds(min(ring * 2, 0.08))
        grain = np.sin(TAU * f * t + r.uniform(0, TAU)) * decay(t, ring) * min(r.pareto(2.5), 2.5)
        put(out, fade(grain, 0.0003, 0.001), start / RATE, 0.4)
    return out


def string(excitation, f, time, bright, length, stiff=0.0):
    """A plucked string as a loop with delay: `time` is its decay, `bright` (0 to 1) how much of the overtones stays."""
    period = RATE / f
    gain = 10 ** (-3 * period / (time * RATE))

    def response(w):
        damp = (1 + bright) / 2 + (1 - bright) / 2 * np.cos(w)
        bend = stiff * w * w * period
        return 1 / (1 - gain * damp * np.exp(-1j * (w * period + bend)))

    n = int(length * RATE)
    size = 1 << int(np.ceil(np.log2(max(n, time * RATE * 1.2) + RATE)))
    w = np.linspace(0, np.pi, size // 2 + 1)
    out = np.fft.irfft(np.fft.rfft(excitation, size) * response(w), size)[:n]
    return out - np.mean(out)


# ---- Rooms --------------------------------------------------------------------------------------------------------------


def room(size, bright, r, early=8):
    """The answer of a room to a clap, left and right: `size` is its 60 dB decay in seconds, high sounds die sooner."""
    t = seconds(size * 1.1)
    tail = np.zeros((2, len(t)))
    bands = [(150, 1.0), (400, 1.0), (1000, 0.9), (2500, 0.65 * bright + 0.1), (6000, 0.4 * bright + 0.05)]
    for f, share in bands:
        for side in range(2):
            tail[side] += band(noise(size * 1.1, r), f, 0.7)[: len(t)] * decay(t, size * share) * np.clip(t / 0.03, 0, 1)
    for _ in range(early):
        at, gain = r.uniform(0.008, 0.06), r.uniform(0.2, 0.6)
        tail[r.integers(2), int(at * RATE)] += gain * 6
    return tail / np.sqrt(np.sum(tail**2) / 2)


def in_room(signal, answer, wet):
    """A signal (one row or two) as it sounds in a room."""
    dry = np.broadcast_to(signal, (2, signal.shape[-1]))
    n = dry.shape[-1] + answer.shape[-1]
    size = 1 << int(np.ceil(np.log2(n)))
    echo = np.fft.irfft(np.fft.rfft(dry, size) * np.fft.rfft(answer, size), size)[:, :n]
    out = wet * echo
    out[:, : dry.shape[-1]] += dry
    return out


def around_room(signal, answer, wet):
    """The same for what loops."""
    dry = np.broadcast_to(signal, (2, signal.shape[-1]))
    n = dry.shape[-1]
    folded = np.zeros((2, n))
    for first in range(0, answer.shape[-1], n):
        part = answer[:, first : first + n]
        folded[:, : part.shape[-1]] += part
    return dry + wet * np.fft.irfft(np.fft.rfft(dry) * np.fft.rfft(folded), n)


# ---- How loud, and files ----------------------------------------------------------------------------------------------


def loudness(signal, window=0.1):
    """The loudest so many seconds, weighted as ears do, in LUFS."""
    weighted = high(signal, 60, 0.5)
    weighted = weighted + 0.58 * high(weighted, 1700, 0.7)
    power = np.atleast_2d(weighted) ** 2
    n = max(1, min(int(window * RATE), power.shape[-1]))
    total = np.concatenate([np.zeros((len(power), 1)), np.cumsum(power, axis=-1)], axis=-1)
    mean = (total[:, n:] - total[:, :-n]) / n
    return -0.691 + 10 * np.log10(np.max(np.sum(mean, axis=0)) * (2 if len(power) == 1 else 1) + 1e-12)


def level(signal, target, peak=-2.0, window=0.1):
    """Brings a signal to a loudness (LUFS), its peak below a limit (dB)."""
    signal = signal * db(target - loudness(signal, window))
    return signal * min(1.0, db(peak) / np.max(np.abs(signal)))


def finish(signal, begin=0.0015, end=0.03):
    """Takes out what is too low to hear, and lets a sound begin and end at nothing."""
    return fade(high(signal, 25, 0.6), begin, end)


MARGIN = 4096


def with_margins(loop):
    """A loop with some of its end before it and some of its beginning after it: what the codec makes worse at the ends of a
    file is there, and is cut off by the game."""
    return np.concatenate([loop[..., -MARGIN:], loop, loop[..., :MARGIN]], axis=-1)


def write(path, signal, quality=5):
    """Writes Ogg Vorbis, the same bytes every time."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    rows = np.atleast_2d(signal)
    raw = rows.T.astype("<f4").tobytes()
    command = ["ffmpeg", "-v", "error", "-y", "-f", "f32le", "-ar", str(RATE), "-ac", str(len(rows)), "-i", "-"]
    command += ["-map_metadata", "-1", "-fflags", "+bitexact", "-flags:a", "+bitexact"]
    command += ["-c:a", "libvorbis", "-q:a", str(quality), str(path)]
    subprocess.run(command, input=raw, check=True)
