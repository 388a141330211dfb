"""Clips off the ground: jump, rise, fall, both landings, roll, death."""

from math import cos, radians, sin

from hero_clip import STAND, Clip, wave
from hero_pose import curve

# Going up: the right knee leads, the left leg trails, the lantern is thrown high.
RISE = {
    "hips.pitch": 10, "spine.pitch": 4, "chest.pitch": 2, "hips.yaw": 8, "chest.yaw": -14, "head.pitch": -8, "hips.y": 0.02,
    "foot.r.x": 0.22, "foot.r.y": 0.42, "foot.r.z": 0.085, "foot.r.pitch": 24, "foot.l.x": -0.30, "foot.l.y": 0.02, "foot.l.z": -0.085, "foot.l.pitch": 68,
    "arm.l.swing": 112, "arm.l.out": 24, "elbow.l": 38, "arm.r.swing": -58, "arm.r.out": 34, "elbow.r": 58,
    "lantern.swing": -10, "knee.r.out": 6, "knee.l.out": 4,
}

# Coming down: arms up and wide, the legs reach for the ground one before the other.
FALL = {
    "hips.pitch": -4, "spine.pitch": 4, "chest.pitch": 8, "hips.yaw": -4, "chest.yaw": 8, "head.pitch": 20, "hips.y": 0.02,
    "foot.r.x": 0.19, "foot.r.y": 0.20, "foot.r.z": 0.10, "foot.r.pitch": 14, "foot.l.x": -0.20, "foot.l.y": 0.13, "foot.l.z": -0.10, "foot.l.pitch": 48,
    "arm.l.swing": 72, "arm.l.out": 62, "elbow.l": 44, "arm.r.swing": -20, "arm.r.out": 96, "elbow.r": 46,
    "lantern.swing": 6, "knee.r.out": 8, "knee.l.out": 8,
}


def jump():
    """Off the ground at once: one key pressed low, then everything stretches, the arms lead, and the knee comes up."""
    keys = {
        "hips.y": [(0, -0.18), (2, 0.035), (4, 0.05), (7, RISE["hips.y"])], "hips.x": [(0, -0.03), (2, 0.03), (7, 0)],
        "hips.pitch": [(0, 28), (2, 12), (7, RISE["hips.pitch"])], "spine.pitch": [(0, 16), (2, -4), (7, RISE["spine.pitch"])],
        "chest.pitch": [(0, 10), (2, -8), (7, RISE["chest.pitch"])], "head.pitch": [(0, 6), (3, -14), (7, RISE["head.pitch"])],
        "hips.yaw": [(0, 0), (7, RISE["hips.yaw"])], "chest.yaw": [(0, 6), (7, RISE["chest.yaw"])],
        "foot.r.x": [(0, 0.08), (2, 0.02), (7, RISE["foot.r.x"])], "foot.r.y": [(0, 0), (2, 0.02), (7, RISE["foot.r.y"])],
        "foot.r.pitch": [(0, 10), (2, 62), (7, RISE["foot.r.pitch"])],
        "foot.l.x": [(0, -0.10), (2, -0.16), (7, RISE["foot.l.x"])], "foot.l.y": [(0, 0), (2, 0.0), (7, RISE["foot.l.y"])],
        "foot.l.pitch": [(0, 24), (2, 70), (7, RISE["foot.l.pitch"])],
        "arm.l.swing": [(0, 10), (3, 128), (7, RISE["arm.l.swing"])], "elbow.l": [(0, 50), (3, 22), (7, RISE["elbow.l"])],
        "arm.l.out": [(0, 20), (3, 18), (7, RISE["arm.l.out"])],
        "arm.r.swing": [(0, -62), (3, 30), (7, RISE["arm.r.swing"])], "elbow.r": [(0, 40), (3, 70), (7, RISE["elbow.r"])],
        "arm.r.out": [(0, 24), (7, RISE["arm.r.out"])], "lantern.swing": [(0, 20), (3, -26), (7, RISE["lantern.swing"])],
    }
    return Clip("jump", 7, RISE, keys, missed=0.05)


def rise():
    """Held by its own speed; only cloth and arms stir."""
    n = 24
    return Clip(
        "rise", n, RISE,
        {
            "arm.l.swing": wave(n, 112, 4, 4), "arm.r.swing": wave(n, -58, 5, 8), "foot.l.x": wave(n, -0.30, 0.02, 6),
            "foot.r.y": wave(n, 0.42, 0.015, 2), "chest.yaw": wave(n, -14, 3, 0), "lantern.swing": wave(n, -10, 6, 10),
        },
        loop=True)


def fall():
    """Arms row for balance, legs pedal a little, the eyes are on the ground."""
    n = 24
    return Clip(
        "fall", n, FALL,
        {
            "arm.r.out": wave(n, 98, 12, 2), "arm.r.swing": wave(n, -16, 14, 8), "elbow.r": wave(n, 46, 10, 10),
            "arm.l.out": wave(n, 62, 9, 14), "arm.l.swing": wave(n, 72, 8, 20), "foot.r.x": wave(n, 0.19, 0.05, 4),
            "foot.l.x": wave(n, -0.20, 0.05, 18), "foot.r.y": wave(n, 0.20, 0.035, 10), "foot.l.y": wave(n, 0.14, 0.035, 0),
            "chest.roll": wave(n, 0, 3, 4), "chest.yaw": wave(n, 8, 4, 10), "lantern.swing": wave(n, 6, 10, 2),
        },
        loop=True)


def land_soft():
    """Feet wide, one dip in the knees, arms come down after the body, a small rise past standing."""
    return Clip(
        "land_soft", 9, STAND,
        {
            "foot.r.x": [(0, 0.14), (9, 0.09)], "foot.l.x": [(0, -0.14), (9, -0.10)], "foot.l.pitch": [(0, 24), (1.5, 6), (4, 0)], "foot.r.pitch": [(0, 8), (1, 0)],
            "hips.y": [(0, -0.06), (2, -0.19), (3, -0.185), (7, -0.016), (9, -0.026)], "hips.x": [(0, 0.0), (3, -0.035), (9, 0)],
            "hips.pitch": [(0, 4), (3, 24), (7, 0), (9, 2)], "spine.pitch": [(0, 2), (3, 14), (7, -2), (9, 0)],
            "chest.pitch": [(0, 2), (4, 10), (8, -4), (9, -2)], "head.pitch": [(0, 14), (3, 20), (7, 2), (9, 3)],
            "arm.r.out": [(0, 84), (3, 44), (6, 10), (9, 15)], "arm.r.swing": [(0, -16), (4, 8), (9, -10)], "elbow.r": [(0, 46), (4, 48), (9, 26)],
            "arm.l.out": [(0, 54), (3, 34), (9, 16)], "arm.l.swing": [(0, 72), (4, 12), (9, 25)], "elbow.l": [(0, 44), (4, 66), (9, 77)],
            "lantern.swing": [(0, 4), (3, 14), (6, -10), (9, 0)], "knee.r.out": [(0, 6), (3, 18), (9, 0)], "knee.l.out": [(0, 6), (3, 18), (9, 0)],
        })


def land_hard():
    """To one knee and one fist, the lantern flung up behind; held a moment, then up by the back."""
    n = 22
    return Clip(
        "land_hard", n, STAND,
        {
            "foot.r.x": [(0, 0.20), (2, 0.23), (13, 0.22), (18, 0.09), (n, 0.09)], "foot.r.y": [(13, 0), (15.5, 0.04), (18, 0)], "foot.r.z": [(0, 0.15), (13, 0.15), (18, 0.125)],
            "foot.l.x": [(0, -0.26), (2, -0.36), (12, -0.35), (17, -0.10), (n, -0.10)], "foot.l.y": [(12, 0), (14.5, 0.05), (17, 0)],
            "foot.l.pitch": [(0, 30), (2, 66), (11, 64), (16, 6), (18, 0)],
            "hips.y": [(0, -0.09), (2, -0.395), (3.5, -0.378), (5, -0.386), (9, -0.372), (16, -0.10), (20, -0.012), (n, -0.026)],
            "hips.x": [(0, 0), (3, -0.06), (10, -0.05), (n, 0)], "hips.pitch": [(0, 6), (2.5, 34), (10, 31), (17, 12), (n, 2)],
            "spine.pitch": [(0, 4), (3, 20), (10, 17), (18, 2), (n, 0)], "chest.pitch": [(0, 4), (3.5, 12), (10, 9), (18, -4), (n, -2)],
            "chest.yaw": [(0, 6), (3, 26), (10, 24), (18, 0), (n, 3)], "hips.yaw": [(0, 0), (3, 8), (11, 8), (n, 7)],
            "head.pitch": [(0, 16), (3, 30), (6, 24), (10, 4), (n, 3)], "head.yaw": [(0, 0), (6, 8), (n, -4)],
            "arm.r.ik": [(0, 0), (1, 0.4), (2.2, 1), (9, 1), (16, 0)], "reach.r.x": 0.27, "reach.r.y": [(0, 0.5), (2.2, 0.105), (10, 0.115), (13, 0.5)], "reach.r.z": 0.20,
            "arm.r.swing": [(0, -10), (3, 60), (11, 60), (17, -16), (n, -10)], "arm.r.out": [(0, 70), (3, 26), (17, 20), (n, 15)], "elbow.r": [(0, 40), (14, 40), (n, 26)],
            "hand.r.pitch": [(0, 0), (2.5, -20), (10, -20), (14, 0)],
            "arm.l.swing": [(0, 60), (3, -66), (5, -84), (10, -76), (16, 44), (n, 25)], "arm.l.out": [(0, 56), (3, 40), (10, 36), (16, 16), (n, 16)],
            "elbow.l": [(0, 44), (4, 14), (10, 20), (16, 78), (n, 77)], "lantern.swing": [(0, 0), (3, 34), (6, -18), (9, 8), (16, -14), (20, 5), (n, 0)],
            "knee.r.out": [(0, 8), (2.5, 26), (10, 24), (18, 0)], "knee.l.out": [(0, 8), (2.5, 12), (10, 12), (18, 0)],
        }, missed=0.08)


def roll():
    """Dives over the shoulder, tucks, once round, and comes up running."""
    n = 16
    spin = [(0, 34), (3, 100), (7.5, 240), (11, 340), (13.5, 370), (n, 376)]
    tuck = [(0, 0.2), (4, 1), (10.5, 1), (13.5, 0.45), (n, 0.12)]

    # The middle of the ball: high while the long helm is under it, and again for the sheath.
    height = [(0, 0.44), (2, 0.60), (3, 0.655), (4, 0.645), (6, 0.53), (8, 0.45), (9, 0.50), (10, 0.575), (11, 0.525), (12, 0.45), (n, 0.415)]

    def ball(key):
        """How far the figure is a ball, and the middle of that ball: trunk and limbs go round it."""
        return curve(tuck, key), curve(height, key)

    def turned(key, fore, up):
        """A place in the body's axes about the ball's middle, as (along, height)."""
        angle = radians(curve(spin, key))
        return fore * cos(angle) + up * sin(angle), -fore * sin(angle) + up * cos(angle)

    def hips(key, axis):
        share, middle = ball(key)
        x, y = turned(key, -0.12, -0.14)
        free = (-0.03, 0.56)
        return (x if axis == "x" else middle + y - 0.74) * share + (free[0] if axis == "x" else free[1] - 0.74) * (1 - share)

    def foot(fore, ground):
        """A foot tucked under the thighs, or on the ground before or behind."""
        def place(key, axis):
            share, middle = ball(key)
            x, y = turned(key, fore, -0.27)
            y = max(middle + y, 0.06) - 0.06
            return (x if axis == "x" else y) * share + (ground if axis == "x" else 0.0) * (1 - share)
        return place

    right, left = foot(0.12, 0.16), foot(0.06, -0.16)
    on = lambda place, axis: (lambda key: place(key, axis))  # noqa: E731
    tilt = lambda more: (lambda key: (curve(spin, key) + more) * curve(tuck, key) + 360 * (1 - curve(tuck, key)) * (key > n / 2))  # noqa: E731
    return Clip(
        "roll", n,
        {
            "hips.x": on(hips, "x"), "hips.y": on(hips, "y"), "hips.pitch": spin,
            "foot.r.x": on(right, "x"), "foot.r.y": on(right, "y"), "foot.r.z": 0.10, "foot.r.pitch": tilt(0),
            "foot.l.x": on(left, "x"), "foot.l.y": on(left, "y"), "foot.l.z": -0.10, "foot.l.pitch": tilt(14),
            "spine.pitch": [(0, 16), (3, 44), (10, 44), (n, 12)], "chest.pitch": [(0, 10), (3, 34), (10, 32), (n, 8)],
            "head.pitch": [(0, 56), (3, 205), (7.5, 345), (11, 425), (13.5, 396), (n, 372)],
            "chest.yaw": [(0, -8), (5, 12), (10, 8), (n, -8)], "hips.roll": [(0, 0), (5, 8), (10, 5), (n, 0)],
            "arm.r.swing": [(0, 76), (4, 66), (10, 70), (n, -20)], "elbow.r": [(0, 44), (4, 100), (10, 104), (n, 77)], "arm.r.out": [(0, 16), (5, 14), (n, 18)],
            "arm.l.swing": [(0, 84), (4, 60), (10, 64), (n, 46)], "elbow.l": [(0, 40), (4, 98), (10, 96), (n, 64)], "arm.l.out": [(0, 20), (5, 18), (n, 20)],
            "lantern.swing": [(0, 0), (2, -84), (4, -136), (7.5, -240), (11, -340), (13, -366), (n, -360)],
            "knee.r.out": [(0, 8), (5, 16), (n, 6)], "knee.l.out": [(0, 8), (5, 16), (n, 6)],
        }, missed=0.3)


def death():
    """Struck: the chest caves and the head goes back; the knees give, a last sway, and he falls on his face and lies still."""
    n = 36
    return Clip(
        "death", n, STAND,
        {
            "hips.y": [(0, -0.026), (2, 0.0), (5, -0.06), (11, -0.385), (12.5, -0.37), (17, -0.37), (20, -0.38), (24, -0.455), (26, -0.435), (28, -0.448), (n, -0.450)],
            "hips.x": [(0, 0), (3, -0.07), (11, -0.03), (17, 0.0), (24, 0.02)],
            "hips.pitch": [(0, 2), (3, -14), (7, -8), (11, 8), (14, 2), (17, 8), (24, 82), (26, 79), (28, 82)],
            "spine.pitch": [(0, 0), (2.5, -16), (6, 4), (12, 16), (17, 14), (24, 4), (n, 4)], "chest.pitch": [(0, -2), (2, -22), (6, 8), (12, 18), (17, 12), (24, 2), (n, 2)],
            "head.pitch": [(0, 3), (1.5, 12), (4, -36), (9, 14), (13, 34), (17, 26), (21, 62), (24, 86), (26, 78), (28, 84)], "head.yaw": [(0, -4), (16, 6), (24, 22), (n, 24)],
            "hips.yaw": [(0, 7), (11, 0), (n, 6)], "chest.yaw": [(0, 3), (3, 16), (12, -8), (24, 8), (n, 8)], "chest.roll": [(0, -2), (12, 6), (17, -6), (24, 4), (n, 4)],
            "foot.r.x": [(0, 0.09), (3, 0.09), (11, -0.34), (17, -0.36), (24, -0.68), (n, -0.69)], "foot.r.pitch": [(0, 0), (5, 20), (11, 76), (17, 80), (24, 88), (n, 88)],
            "foot.l.x": [(0, -0.10), (3, -0.12), (11, -0.42), (17, -0.42), (24, -0.71), (n, -0.72)], "foot.l.pitch": [(0, 0), (5, 26), (11, 80), (17, 82), (24, 88), (n, 88)],
            "foot.l.yaw": [(0, 24), (11, 6), (n, 10)], "foot.r.yaw": [(0, -10), (11, -4), (n, -14)], "foot.r.z": [(0, 0.125), (n, 0.17)],
            "arm.r.swing": [(0, -10), (3, 34), (7, -6), (12, -22), (17, -4), (22, 110), (24.5, 138), (n, 140)], "arm.r.out": [(0, 15), (3, 64), (8, 34), (13, 16), (20, 50), (25, 36), (n, 36)],
            "elbow.r": [(0, 26), (3, 60), (9, 22), (14, 18), (21, 60), (25, 44), (n, 44)],
            "arm.l.swing": [(0, 30), (3, 62), (8, 22), (13, 6), (18, 26), (23, 112), (25, 126), (n, 126)], "arm.l.out": [(0, 14), (3, 50), (9, 26), (18, 30), (25, 22), (n, 22)],
            "elbow.l": [(0, 72), (3, 50), (9, 40), (14, 30), (24, 18), (n, 18)],
            "arm.l.ik": [(0, 0), (13, 0), (20, 1)], "reach.l.x": [(13, 0.3), (19, 0.45), (24, 0.80)], "reach.l.y": [(13, 0.5), (19, 0.46), (22, 0.42), (25, 0.22), (27, 0.155), (29, 0.15)], "reach.l.z": -0.30, "arm.l.pole": 80,
            "hand.l.pitch": [(0, 0), (20, 0), (25, -20)],
            "lantern.swing": [(0, 0), (4, 26), (8, -20), (12, 14), (18, -6), (22, -10), (24, 44), (26.5, 80), (28.5, 74), (30, 82), (n, 82)],
            "knee.r.out": [(0, 0), (11, 14), (17, 24), (21, 62), (n, 66)], "knee.l.out": [(0, 0), (11, 14), (17, 24), (21, 54), (n, 56)],
        }, missed=0.2)


def clips():
    """All of them."""
    return [jump(), rise(), fall(), land_soft(), land_hard(), roll(), death()]
