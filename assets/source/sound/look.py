"""Draws sounds as pictures, to judge them by eye: python3 look.py OUT.png FILE.ogg ...

One tile each: the spectrogram (40 Hz to 16 kHz, a decade per third of the height; black to white: 80 dB), below it the
wave. Prints for each: seconds, loudness of the loudest 0.4 s (LUFS), peak (dB), mean.

The game itself decodes them, so that what is judged is what is heard: loops without their margins, and every sound to its end
(ffmpeg leaves out the last 128 samples of an Ogg Vorbis file, 2.7 ms, and a loop then seems to click). It needs the game to be
built: `cargo build --release`.
"""

import struct
import subprocess
import sys
import tempfile
import wave
import zlib
from pathlib import Path

import numpy as np

from synth import RATE, loudness

GAME = Path(__file__).resolve().parents[3] / "target/release/edgewalker"
WIDE, TALL, WAVE, COLUMNS = 300, 170, 50, 6


def read(path):
    """The two channels of a file as the game plays it."""
    with tempfile.TemporaryDirectory() as folder:
        plain = Path(folder) / "sound.wav"
        subprocess.run([GAME, "--soundtrack", plain, "--sound", Path(path).resolve()], check=True)
        with wave.open(str(plain)) as file:
            raw = file.readframes(file.getnframes())
    return np.frombuffer(raw, "<i2").reshape(-1, 2).T / 32767


def tile(signal, span):
    mono = signal.mean(axis=0)
    size = 2048 if span < 3 else 8192
    edges = 40 * (16000 / 40) ** (np.arange(TALL + 1) / TALL)
    f = np.fft.rfftfreq(size, 1 / RATE)
    picture = np.zeros((TALL + WAVE, WIDE))
    padded = np.pad(mono, (size // 2, size + int(span * RATE)))
    window = np.hanning(size)
    low = np.searchsorted(f, edges[:-1])
    high = np.maximum(np.searchsorted(f, edges[1:]), low + 1)
    for x in range(WIDE):
        start = int(x / WIDE * span * RATE)
        block = padded[start : start + size]
        power = np.abs(np.fft.rfft(block * window)) ** 2 / (window.sum() / 2) ** 2
        total = np.concatenate([[0], np.cumsum(power)])
        rows = 10 * np.log10((total[np.minimum(high, len(f))] - total[low]) + 1e-12)
        picture[:TALL, x] = np.clip((rows[::-1] + 95) / 80, 0, 1)
        wave = padded[size // 2 + start : size // 2 + int((x + 1) / WIDE * span * RATE)]
        top, bottom = wave.max(initial=0), wave.min(initial=0)
        a, b = (int(TALL + WAVE / 2 - v * (WAVE / 2 - 1)) for v in (top, bottom))
        picture[a : b + 1, x] = 1.0
    picture[:, -1] = 0.4
    picture[-1, :] = 0.4
    return picture


def png(path, grey):
    r = np.clip(grey * 2.2, 0, 1)
    g = np.clip(grey * 2.2 - 0.8, 0, 1)
    b = np.clip(np.where(grey < 0.35, grey * 1.4, 0.49 - (grey - 0.35) + np.clip(grey * 3 - 2, 0, 1)), 0, 1)
    rows = (np.stack([r, g, b], axis=-1) * 255).astype(np.uint8)
    raw = b"".join(b"\0" + row.tobytes() for row in rows)
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", grey.shape[1], grey.shape[0], 8, 2, 0, 0, 0)
    Path(path).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


def main():
    out, files = sys.argv[1], sys.argv[2:]
    tiles = []
    for path in files:
        signal = read(path)
        span = signal.shape[1] / RATE
        peak = 20 * np.log10(np.max(np.abs(signal)) + 1e-9)
        loud = loudness(signal, 0.4)
        print(f"{Path(path).stem:18} {span:6.2f} s {loud:6.1f} LUFS  peak {peak:5.1f} dB  mean {signal.mean():+.5f}")
        tiles.append(tile(signal, span))
    tiles += [np.zeros_like(tiles[0])] * (-len(tiles) % COLUMNS)
    rows = [np.hstack(tiles[k : k + COLUMNS]) for k in range(0, len(tiles), COLUMNS)]
    png(out, np.vstack(rows))


if __name__ == "__main__":
    main()
