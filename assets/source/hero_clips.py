"""The hero's clips."""

from math import cos, pi, sin

from hero_export import KEYS_A_SECOND
from hero_pose import Solver, curve


class Clip:
    """Channels over time in keys; a loop's last key equals its first."""

    def __init__(self, name, length, channels, loop=False):
        self.name, self.length, self.channels, self.loop = name, length, channels, loop

    def channels_at(self, key):
        period = self.length if self.loop else None
        return {name: curve(keys, key % self.length if self.loop else key, period) for name, keys in self.channels.items()}

    def poses(self):
        return [Solver(self.channels_at(key)) for key in range(self.length + 1)]

    def seconds(self):
        return self.length / KEYS_A_SECOND


STAND = {
    "foot.l.x": -0.08, "foot.l.z": -0.125, "foot.r.x": 0.09, "foot.r.z": 0.125, "foot.l.yaw": 18, "foot.r.yaw": -8,
    "hips.y": -0.02, "spine.pitch": 2,
    "arm.l.swing": 28, "elbow.l": 75, "arm.l.out": 12, "arm.r.swing": -8, "elbow.r": 22, "arm.r.out": 16,
}


def posed(**changes):
    return {**STAND, **{name.replace("__", "."): value for name, value in changes.items()}}


def steps(length, stance, reach, lift, width):
    """Both feet of a cycle: back at constant speed on the ground for a share of it, then forward in an arc."""
    def place(lead):
        def x(key):
            phase = (key / length + lead) % 1.0
            if phase < stance:
                return reach * (0.5 - phase / stance)
            s = (phase - stance) / (1.0 - stance)
            return reach * (-0.5 + s * s * (3 - 2 * s))
        def y(key):
            phase = (key / length + lead) % 1.0
            s = (phase - stance) / (1.0 - stance)
            return lift * sin(pi * s) if s > 0 else 0.0
        return x, y
    (rx, ry), (lx, ly) = place(0.0), place(0.5)
    return {"foot.r.x": rx, "foot.r.y": ry, "foot.l.x": lx, "foot.l.y": ly, "foot.r.z": width, "foot.l.z": -width, "foot.l.yaw": 0, "foot.r.yaw": 0}


def cycle(length, mean, swing, lead=0.0):
    return lambda key: mean + swing * cos(2 * pi * (key / length + lead))


def rough():
    def walk(name, length, stance, reach, lift, **more):
        return Clip(name, length, {**posed(**more), **steps(length, stance, reach, lift, 0.09)}, loop=True)
    still = posed
    shot = lambda name, length, keys: Clip(name, length, {**STAND, **keys})
    low = dict(hips__y=-0.3, hips__pitch=35, spine__pitch=20, head__pitch=5)
    return [
        Clip("idle", 60, {**STAND, "hips.y": cycle(60, -0.02, 0.006), "chest.pitch": cycle(60, 0, 1.5)}, loop=True),
        walk("walk", 30, 0.6, 0.72, 0.08, arm__r__swing=cycle(30, -5, 20, 0.5)),
        walk("run", 24, 0.22, 0.75, 0.25, hips__y=cycle(12, -0.05, 0.03, 0.3), hips__pitch=14, spine__pitch=8, elbow__r=90, arm__r__swing=cycle(24, -10, 50, 0.5), arm__l__swing=cycle(24, 30, 15)),
        shot("turn", 8, {"hips.yaw": [(0, 0), (4, 35), (8, 0)]}),
        shot("jump", 6, {"hips.y": [(0, -0.2), (3, 0.0), (6, 0.05)], "foot.r.y": [(0, 0), (6, 0.3)]}),
        Clip("rise", 20, still(foot__r__y=0.35, foot__r__x=0.2, foot__l__x=-0.15, foot__l__pitch=50), loop=True),
        Clip("fall", 20, still(foot__r__y=0.15, foot__r__x=0.2, foot__l__x=-0.25, foot__l__y=0.2, arm__r__out=70, arm__l__out=60), loop=True),
        shot("land_soft", 8, {"hips.y": [(0, -0.05), (2, -0.16), (8, -0.02)]}),
        shot("land_hard", 18, {"hips.y": [(0, -0.05), (3, -0.34), (8, -0.3), (18, -0.02)], "hips.pitch": [(0, 5), (3, 40), (18, 0)]}),
        Clip("crouch", 60, still(**low), loop=True),
        walk("crawl", 24, 0.6, 0.6, 0.08, **low),
        Clip("wall_slide", 30, still(foot__r__x=0.3, foot__r__y=0.35, arm__r__swing=120), loop=True),
        Clip("ledge_hang", 60, still(arm__l__swing=165, arm__r__swing=165, elbow__l=10, elbow__r=10, foot__l__y=0.2, foot__r__y=0.3), loop=True),
        shot("ledge_climb", 15, {"arm.r.swing": [(0, 165), (10, 0)], "arm.l.swing": [(0, 165), (10, 10)]}),
        Clip("ladder", 24, still(arm__l__swing=cycle(24, 130, 30), arm__r__swing=cycle(24, 130, -30), foot__l__y=cycle(24, 0.2, 0.2), foot__r__y=cycle(24, 0.2, -0.2)), loop=True),
        Clip("climb_wall", 24, still(arm__l__swing=cycle(24, 130, 30), arm__r__swing=cycle(24, 130, -30), foot__l__y=cycle(24, 0.2, 0.2), foot__r__y=cycle(24, 0.2, -0.2)), loop=True),
        shot("roll", 15, {"hips.pitch": [(0, 0), (15, 360)], "head.pitch": [(0, 0), (15, 360)], "hips.y": [(0, -0.1), (4, -0.4), (10, -0.4), (15, -0.1)]}),
        shot("death", 36, {"hips.pitch": [(0, 0), (20, 80), (36, 85)], "hips.y": [(0, 0), (20, -0.55), (36, -0.6)]}),
    ]


EXTRAS = {"stride_walk": 1.2, "stride_run": 0.75 / 0.22, "stride_crawl": 1.0, "rise_ladder": 1.36, "rise_climb_wall": 1.2}
CLIPS = rough
