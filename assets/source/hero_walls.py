"""Clips at walls: sliding, hanging from a ledge and climbing onto it, ladders and climbable walls.

The wall is at WALL before the foot. Hands that hold, hold still against the wall while the body moves.
"""

from hero_clip import STAND, Clip, hermite, wave
from hero_pose import curve

WALL = 0.406
# The ledge's corner while he hangs.
CORNER = (0.4, 1.6)
# Keys of the climb onto it, and the share of them after which he is up.
LEDGE_CLIMB, LEDGE_RISE = 17, 0.7


def wall_slide():
    """Right hand and boot scrape down the wall, the body leans out, the lantern lights the way below."""
    n = 24
    return Clip(
        "wall_slide", n,
        {
            "hips.x": -0.03, "hips.y": wave(6, -0.08, 0.004, 1), "hips.pitch": -10, "hips.yaw": 6, "spine.pitch": 6, "chest.pitch": wave(8, 8, 0.8, 0), "chest.yaw": 10, "chest.roll": wave(n, -9, 1.2, 3),
            "head.pitch": 22, "head.yaw": -14,
            "foot.r.x": 0.235, "foot.r.y": wave(6, 0.37, 0.006, 2), "foot.r.z": 0.12, "foot.r.pitch": -52,
            "foot.l.x": 0.175, "foot.l.y": wave(6, 0.10, 0.006, 4), "foot.l.z": -0.11, "foot.l.pitch": -34, "knee.r.out": 22, "knee.l.out": 14,
            "arm.r.ik": 1, "reach.r.x": WALL - 0.055, "reach.r.y": wave(6, 1.30, 0.005, 3), "reach.r.z": 0.22, "hand.r.pitch": 10, "arm.r.pole": 30,
            "arm.l.swing": wave(n, -82, 5, 4), "arm.l.out": wave(n, 34, 4, 10), "elbow.l": 16, "lantern.swing": wave(n, 8, 9, 8),
        },
        loop=True)


HANG = {
    "hips.x": 0.07, "hips.y": 0.06, "hips.pitch": -6, "hips.yaw": 10, "hips.roll": -4, "spine.pitch": -2, "spine.roll": -6, "chest.pitch": -2, "chest.yaw": 14, "chest.roll": -14,
    "head.pitch": -16, "head.yaw": 4,
    "arm.r.ik": 1, "reach.r.x": CORNER[0] - 0.045, "reach.r.y": CORNER[1] - 0.015, "reach.r.z": 0.17, "arm.r.pole": 50, "hand.r.pitch": 62,
    "arm.l.swing": -66, "arm.l.out": 38, "elbow.l": 20,
    "foot.r.x": 0.17, "foot.r.y": 0.36, "foot.r.z": 0.10, "foot.r.pitch": -24, "foot.l.x": 0.02, "foot.l.y": 0.10, "foot.l.z": -0.10, "foot.l.pitch": 40,
    "knee.r.out": 20, "knee.l.out": 6,
}


def ledge_hang():
    """By the right hand alone, a boot against the wall, the lantern held clear; the body swings under the grip."""
    n = 60
    return Clip(
        "ledge_hang", n, HANG,
        {
            "hips.x": wave(n, 0.07, 0.012, 10), "hips.y": wave(n / 2, 0.06, 0.005, 6), "hips.pitch": wave(n, -6, 1.5, 10), "hips.yaw": wave(n, 10, 3, 20),
            "foot.l.x": wave(n, 0.02, 0.045, 16), "foot.l.y": wave(n, 0.10, 0.02, 24), "chest.yaw": wave(n, 14, 3, 14), "head.pitch": wave(n, -16, 2, 20),
            "arm.l.swing": wave(n, -66, 6, 18), "arm.l.out": wave(n, 38, 4, 26), "lantern.swing": wave(n, 0, 8, 26),
        },
        loop=True)


def ledge_climb():
    """Pulls up, swings the other arm and a knee over, presses the hands down to the hips, stands."""
    n, up = 18, 9
    # How high the ledge is, seen from the rising foot; the game lifts him at constant speed.
    ledge = lambda key: CORNER[1] * max(0.0, 1.0 - key / up)  # noqa: E731
    along = [(0, 0.4), (7, 0.38), (up, 0.34), (13, 0.28), (n, 0.28)]

    def clock(key):
        """Drawn as nine keys up and nine to stand; played with the rise as LEDGE_RISE of the whole."""
        risen = LEDGE_CLIMB * LEDGE_RISE
        return key * up / risen if key < risen else up + (key - risen) * (n - up) / (LEDGE_CLIMB - risen)
    grip = lambda side: (lambda key: ledge(key) + (0.36 if side else -0.015) + 0.07 * min(1.0, key / 4))  # noqa: E731
    return Clip(
        "ledge_climb", LEDGE_CLIMB, STAND,
        {
            "hips.x": [(0, 0.07), (4, 0.06), (9, -0.07), (12, -0.03), (n, 0)], "hips.y": [(0, 0.06), (2, 0.0), (5, 0.04), (9, -0.22), (11, -0.24), (15, -0.05), (n, -0.026)],
            "hips.pitch": [(0, -6), (3, 4), (6, 34), (9, 50), (12, 34), (16, 6), (n, 2)], "spine.pitch": [(0, -2), (3, 6), (8, 20), (12, 14), (n, 0)],
            "chest.pitch": [(0, -2), (4, 8), (9, 12), (14, 2), (n, -2)], "spine.roll": [(0, -6), (4, 0), (n, 0)], "chest.roll": [(0, -10), (4, 4), (9, 0), (n, -2)],
            "chest.yaw": [(0, 12), (4, -8), (9, -4), (n, 3)], "hips.roll": [(0, -4), (5, 3), (n, 2)], "hips.yaw": [(0, 10), (6, -8), (10, 0), (n, 7)],
            "head.pitch": [(0, -16), (3, -24), (7, -4), (11, 14), (n, 3)], "head.yaw": [(0, 4), (n, -4)],
            "arm.r.ik": [(0, 1), (7.5, 1), (14, 0)], "reach.r.x": lambda key: curve(along, key) - 0.045, "reach.r.y": grip(0), "reach.r.z": 0.19,
            "hand.r.pitch": [(0, 62), (4, 30), (8, -40), (12, 0)], "arm.r.pole": [(0, 50), (5, 70), (9, 40)],
            "arm.r.swing": [(0, 120), (9, -10), (13, -24), (n, -10)], "arm.r.out": [(0, 15), (9, 30), (n, 15)], "elbow.r": [(0, 60), (9, 50), (13, 44), (n, 26)],
            "arm.l.ik": [(0, 0), (3, 0), (6.5, 1), (7.5, 1), (12, 0)], "reach.l.x": lambda key: curve(along, key) + 0.06, "reach.l.y": grip(1), "reach.l.z": -0.19,
            "arm.l.swing": [(0, -66), (2.5, 10), (5.5, 96), (9, 50), (12, 24), (n, 25)], "arm.l.out": [(0, 38), (3, 52), (9, 26), (n, 16)], "elbow.l": [(0, 20), (5, 84), (10, 66), (n, 77)],
            "arm.l.pole": [(0, 60), (8, 50)],
            "foot.r.x": [(0, 0.17), (4, 0.10), (7, 0.0), (9, -0.08), (13, 0.10), (n, 0.09)], "foot.r.y": [(0, 0.36), (4, 0.20), (7, 0.05), (9.5, 0.07), (13, 0.0)],
            "foot.r.pitch": [(0, -24), (4, 36), (8, 70), (11, 30), (13, 0)],
            "foot.l.x": [(0, 0.02), (4, 0.06), (7, 0.10), (9, 0.02), (12, -0.08), (n, -0.10)], "foot.l.y": [(0, 0.10), (4, 0.36), (6.5, 0.34), (9, 0.02), (10, 0)],
            "foot.l.pitch": [(0, 40), (4, 50), (7, 10), (9, 0)], "foot.l.z": [(0, -0.10), (5, -0.19), (n, -0.135)], "foot.r.z": 0.12,
            "knee.l.out": [(0, 6), (5, 60), (9, 30), (14, 0)], "knee.r.out": [(0, 20), (8, 16), (14, 0)],
            "lantern.swing": [(0, 0), (4, 18), (8, -20), (12, 14), (n, 0)],
        }, missed=0.3, clock=clock)


class Climb:
    """Hands and feet of a climb: each holds still against the wall for a share of the cycle, then reaches up in an arc away
    from it. Right hand and left foot go together."""

    def __init__(self, length, rise, down, hands, feet, out):
        self.length, self.rise, self.down, self.hands, self.feet, self.out = length, rise, down, hands, feet, out

    def limb(self, top, lead, key):
        """Height, and how far from the wall."""
        phase = (key / self.length + lead) % 1.0
        if phase <= self.down:
            return top - self.rise * phase, 0.0
        s = (phase - self.down) / (1 - self.down)
        slope = -self.rise * (1 - self.down)
        return hermite(top - self.rise * self.down, top, slope * 0.6, slope * 0.6, s), self.out * 16 * (s * (1 - s)) ** 2

    def channels(self, reach, tread):
        """`reach` and `tread` are how far before the foot hands and soles are when they hold."""
        made = {}
        for part, lead in (("reach.r", 0.0), ("foot.l", 0.06), ("reach.l", 0.5), ("foot.r", 0.56)):
            top, before = (self.hands, reach) if part[0] == "r" else (self.feet, tread)
            made[f"{part}.y"] = lambda key, top=top, lead=lead: self.limb(top, lead, key)[0]
            made[f"{part}.x"] = lambda key, top=top, lead=lead, before=before: before - self.limb(top, lead, key)[1]
        return made


LADDER = Climb(24, 1.02, 0.54, 1.48, 0.50, 0.09)
WALL_CLIMB = Climb(24, 0.96, 0.56, 1.47, 0.43, 0.11)


def ladder():
    """Hand over hand, close to the rungs, the hips sway to the foot that stands."""
    n, half = LADDER.length, LADDER.length / 2
    return Clip(
        "ladder", n, LADDER.channels(0.27, 0.16),
        {
            "hips.x": -0.03, "hips.y": wave(half, -0.05, 0.014, 4), "hips.z": wave(n, 0, 0.025, 18), "hips.roll": wave(n, 0, 6, 0), "hips.yaw": wave(n, 0, 7, 2),
            "hips.pitch": 4, "spine.pitch": 2, "chest.roll": wave(n, 0, -11, 0), "spine.roll": wave(n, 0, -5, 0), "chest.yaw": wave(n, 0, 7, 0), "head.pitch": -14, "head.roll": wave(n, 0, -3, 2),
            "arm.r.ik": 1, "arm.l.ik": 1, "reach.r.z": 0.15, "reach.l.z": -0.15, "arm.r.pole": 60, "arm.l.pole": 60,
            "hand.r.pitch": wave(n, 50, 25, 0), "hand.l.pitch": wave(n, 50, -25, 0),
            "foot.r.z": 0.10, "foot.l.z": -0.10, "foot.r.pitch": -8, "foot.l.pitch": -8, "foot.r.yaw": -8, "foot.l.yaw": 8, "knee.r.out": 34, "knee.l.out": 34,
            "lantern.swing": wave(half, 0, 8, 4),
        },
        loop=True, missed=0.05)


def climb_wall():
    """Wide holds, the body swings from side to side under the reaching arm, toes dig in."""
    n, half = WALL_CLIMB.length, WALL_CLIMB.length / 2
    return Clip(
        "climb_wall", n, WALL_CLIMB.channels(WALL - 0.06, 0.19),
        {
            "hips.x": 0.0, "hips.y": wave(half, -0.06, 0.018, 5), "hips.z": wave(n, 0, 0.05, 17), "hips.roll": wave(n, 0, 10, 0), "hips.yaw": wave(n, 0, 12, 2),
            "hips.pitch": 0, "spine.pitch": -2, "chest.roll": wave(n, 0, -18, 0), "spine.roll": wave(n, 0, -7, 0), "chest.yaw": wave(n, 0, 14, 0), "chest.pitch": -2, "head.pitch": -20, "head.yaw": wave(n, 0, -10, 0),
            "arm.r.ik": 1, "arm.l.ik": 1, "reach.r.z": wave(n, 0.24, -0.05, 0), "reach.l.z": wave(n, -0.24, -0.05, 0), "arm.r.pole": 75, "arm.l.pole": 75,
            "hand.r.pitch": wave(n, 44, 25, 0), "hand.l.pitch": wave(n, 44, -25, 0),
            "foot.r.z": 0.17, "foot.l.z": -0.17, "foot.r.pitch": -36, "foot.l.pitch": -36, "foot.r.yaw": -16, "foot.l.yaw": 16, "knee.r.out": 62, "knee.l.out": 62,
            "lantern.swing": wave(half, 4, 10, 4),
        },
        loop=True, missed=0.06)


def clips():
    """All of them."""
    return [wall_slide(), ledge_hang(), ledge_climb(), ladder(), climb_wall()]
