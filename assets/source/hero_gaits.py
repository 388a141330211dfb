"""Clips on the ground: standing, walking, running, turning, crouching and crawling."""

from hero_clip import STAND, Clip, Gait, wave

WALK = Gait(
    30, 0.60, 0.30, -0.34, 0.088,
    lift=[(0, 0), (0.35, 0.085), (0.7, 0.06), (1, 0)],
    pitch=[(0, -16), (0.10, 0), (0.36, 0), (0.60, 44), (0.70, 52), (0.86, 2), (0.95, -16)])

RUN = Gait(
    24, 0.25, 0.34, -0.44, 0.062,
    lift=[(0, 0), (0.25, 0.25), (0.45, 0.33), (0.72, 0.22), (1, 0)],
    pitch=[(0, -4), (0.05, 0), (0.12, 4), (0.25, 52), (0.36, 88), (0.52, 74), (0.72, 14), (0.88, -12), (0.96, -9)], eager=0.5)

CRAWL = Gait(
    24, 13 / 24, 0.16, -0.42, 0.15,
    lift=[(0, 0), (0.3, 0.035), (0.75, 0.05), (1, 0)],
    pitch=[(0, -6), (0.08, 0), (0.30, 8), (0.54, 42), (0.66, 40), (0.86, 4), (0.96, -6)], toes=10)


def idle():
    """Two slow breaths with the weight on the right leg; the lantern sways after them."""
    n = 90
    return Clip(
        "idle", n, STAND,
        {
            "hips.y": wave(n / 2, -0.027, 0.005, 18), "hips.z": wave(n, 0.014, 0.006, 20), "hips.roll": wave(n, 2, 0.8, 22),
            "chest.pitch": wave(n / 2, -2, 1.8, 0), "chest.yaw": wave(n, 3, 2.0, 60), "spine.pitch": wave(n / 2, 1, 0.8, 4),
            "arm.l.swing": wave(n / 2, 25, 2.0, 6), "elbow.l": wave(n / 2, 77, 2.5, 10), "arm.l.out": wave(n / 2, 16, 1.5, 24),
            "arm.r.out": wave(n / 2, 15, 2.0, 22), "arm.r.swing": wave(n / 2, -10, 2.0, 4), "elbow.r": wave(n / 2, 26, 3, 8),
            "head.pitch": wave(n / 2, 3, 1.3, 8), "head.yaw": [(0, -4), (20, -4), (32, 9), (58, 9), (70, -4)],
            "lantern.swing": wave(n / 2, 0, 3.5, 14),
        },
        loop=True)


def walk():
    """A soldier's walk: heel first, rolling over the ball, shoulders against hips, the lantern carried steady."""
    n = WALK.length
    return Clip(
        "walk", n, WALK.channels(),
        {
            "hips.y": wave(n / 2, -0.045, 0.017, 8.5), "hips.x": 0.01, "hips.z": wave(n, 0, 0.016, 8),
            "hips.yaw": wave(n, 0, 9, 0), "hips.roll": wave(n, 0, -3, 5), "hips.pitch": wave(n / 2, 5, 1.2, 2),
            "spine.pitch": 3, "spine.yaw": wave(n, 0, -6, 1), "chest.yaw": wave(n, 0, -10, 1.5), "chest.roll": wave(n, 0, 2, 6),
            "chest.pitch": wave(n / 2, 0, 1.5, 4),
            "head.pitch": wave(n / 2, 4, 1.5, 5), "head.yaw": wave(n, 0, 2, 4),
            "arm.r.swing": wave(n, -4, -27, 1), "elbow.r": wave(n, 32, -14, 3), "arm.r.out": 13, "arm.r.twist": 8,
            "arm.l.swing": wave(n, 30, 8, 1.5), "elbow.l": wave(n, 70, 5, 4), "arm.l.out": 14,
            "lantern.swing": wave(n / 2, 0, 6, 6), "knee.r.out": 6, "knee.l.out": 6,
        },
        loop=True)


def run():
    """Full speed, bent low into it: contact, down, off the toes, flight; elbows pump, the lantern arm holds its line."""
    n = RUN.length
    half = n / 2
    return Clip(
        "run", n, RUN.channels(),
        {
            "hips.y": [(0, -0.098), (2.6, -0.135), (6, -0.085), (9, -0.040), (12, -0.098), (14.6, -0.135), (18, -0.085), (21, -0.040)],
            "hips.x": wave(half, 0.015, 0.012, 7), "hips.z": wave(n, 0, 0.012, 3),
            "hips.yaw": wave(n, 0, 13, 23.5), "hips.roll": wave(n, 0, -5, 3), "hips.pitch": wave(half, 15, 2.5, 5),
            "spine.pitch": wave(half, 10, 2.0, 3), "spine.yaw": wave(n, 0, -11, 0), "spine.roll": wave(n, 0, 2, 3),
            "chest.pitch": wave(half, 6, 2.0, 4), "chest.yaw": wave(n, 0, -17, 0.5), "chest.roll": wave(n, 0, 3, 4),
            "head.pitch": wave(half, 9, 2.5, 4), "head.yaw": wave(n, 0, 3, 1), "head.roll": wave(n, 0, 2, 5),
            "arm.r.swing": [(0.5, -74), (4, -52), (8, 10), (12.5, 48), (16, 34), (20, -34)],
            "elbow.r": [(0, 88), (5, 66), (9, 84), (13, 112), (18, 80)],
            "arm.r.out": wave(n, 17, 7, 1), "arm.r.across": wave(n, 8, -10, 1), "arm.r.twist": wave(n, 5, 10, 1),
            "arm.l.swing": wave(n, 46, 15, 0.5), "elbow.l": wave(half, 62, 6, 4), "arm.l.out": wave(n, 20, 4, 8), "arm.l.across": -4,
            "hand.l.pitch": wave(half, 0, 8, 4),
            "lantern.swing": wave(half, -22, 9, 6), "knee.r.out": 3, "knee.l.out": 3,
        },
        loop=True)


def turn():
    """About face: the feet brake, the head is round first, the shoulders and the lantern come after, and settle."""
    return Clip(
        "turn", 9, STAND,
        {
            "foot.r.x": [(0, 0.20), (4, 0.17), (9, 0.09)], "foot.r.yaw": [(0, -34), (5, -6), (9, -10)], "foot.r.pitch": [(0, -14), (2, 0)],
            "foot.l.x": [(0, -0.20), (4, -0.16), (9, -0.10)], "foot.l.yaw": [(0, -16), (6, 20), (9, 24)], "foot.l.pitch": [(0, 30), (3, 12), (6, 0)],
            "hips.y": [(0, -0.10), (2, -0.13), (6, -0.03), (9, -0.026)], "hips.x": [(0, -0.07), (3, -0.05), (7, 0.012), (9, 0)],
            "hips.yaw": [(0, -34), (3, -16), (6, 10), (9, 7)], "hips.pitch": [(0, -12), (3, -8), (6, 5), (9, 2)],
            "chest.yaw": [(0, -30), (3, -20), (6, 8), (9, 3)], "spine.yaw": [(0, -14), (3, -9), (6, 3), (9, 0)],
            "spine.roll": [(0, 6), (4, 3), (9, 0)], "head.yaw": [(0, -34), (2, -4), (5, 3), (9, -4)], "head.pitch": [(0, 10), (4, 6), (9, 3)],
            "arm.r.swing": [(0, 30), (3, 24), (6, -24), (9, -10)], "arm.r.out": [(0, 42), (4, 34), (9, 15)], "elbow.r": [(0, 60), (5, 46), (9, 26)],
            "arm.l.swing": [(0, 4), (3, 20), (6, 42), (9, 25)], "arm.l.out": [(0, 52), (4, 30), (9, 16)], "elbow.l": [(0, 40), (5, 60), (9, 77)],
            "lantern.swing": [(0, 20), (4, 4), (7, -14), (9, -4)], "lantern.yaw": [(0, -60), (5, 0), (9, 0)],
        })


LOW = {
    "hips.y": -0.385, "hips.x": -0.22, "hips.pitch": 52, "spine.pitch": 20, "chest.pitch": 14, "head.pitch": 14,
        "foot.l.x": -0.34, "foot.r.x": -0.06, "foot.l.z": -0.15, "foot.r.z": 0.14, "foot.l.pitch": 34, "foot.l.yaw": 14, "foot.r.yaw": -10,
    "knee.r.out": 30, "knee.l.out": 26,
    "arm.r.ik": 1, "reach.r.x": 0.24, "reach.r.y": 0.17, "reach.r.z": 0.24, "arm.r.pole": 40,
    "arm.l.ik": 1, "reach.l.x": 0.47, "reach.l.y": 0.45, "reach.l.z": -0.20, "arm.l.pole": 50,
}


def crouch():
    """Low and ready, the lantern before him, the right hand's knuckles near the ground."""
    n = 60
    return Clip(
        "crouch", n, LOW,
        {
            "hips.y": wave(n, -0.387, 0.005, 20), "chest.pitch": wave(n, 14, 1.6, 4), "head.pitch": wave(n, 14, 1.2, 10),
            "head.yaw": [(0, 0), (14, 0), (22, -10), (38, -10), (48, 0)], "reach.l.y": wave(n, 0.45, 0.008, 8), "reach.l.x": wave(n, 0.47, 0.006, 14), "lantern.swing": wave(n, 0, 3, 12),
        },
        loop=True)


def crawl():
    """Creeping under things: long low steps, the shoulders roll, the free hand feels ahead."""
    n = CRAWL.length
    half = n / 2
    return Clip(
        "crawl", n, LOW, CRAWL.channels(),
        {
            "hips.y": wave(half, -0.368, 0.012, 8), "hips.z": wave(n, 0, 0.02, 6), "hips.yaw": wave(n, 0, 10, 0), "hips.roll": wave(n, 0, -4, 5),
            "spine.yaw": wave(n, 0, -8, 1), "chest.yaw": wave(n, 0, -9, 2), "chest.roll": wave(n, 0, 5, 4), "chest.pitch": wave(half, 15, 2, 4),
            "head.pitch": wave(half, 13, 2.5, 6), "head.yaw": wave(n, 0, 3, 4),
            "reach.r.x": wave(n, 0.22, -0.15, 1), "reach.r.y": wave(n, 0.21, 0.05, 19), "reach.r.z": wave(n, 0.23, 0.02, 6),
            "reach.l.x": wave(n, 0.46, 0.03, 1), "reach.l.y": wave(half, 0.45, 0.012, 6), "lantern.swing": wave(half, -5, 8, 6),
        },
        loop=True)


def clips():
    """All of them."""
    return [idle(), walk(), run(), turn(), crouch(), crawl()]
