"""What a clip is, and helpers for those who key them."""

from math import cos, pi

from hero_pose import Solver, curve

KEYS_A_SECOND = 30


class Clip:
    """Channels (hero_pose) over time in keys; a loop's last key equals its first. `missed` is by how many metres a hand or
    foot may stay from where it is asked to be; `clock` from the key that is played to the key that is drawn."""

    def __init__(self, name, length, *channels, loop=False, missed=0.012, clock=None):
        self.name, self.length, self.loop, self.missed, self.clock = name, length, loop, missed, clock
        self.channels = {}
        for some in channels:
            self.channels.update(some)

    def channels_at(self, key):
        """All channels at a key."""
        period = self.length if self.loop else None
        if self.loop:
            key %= self.length
        if self.clock:
            key = self.clock(key)
        return {name: curve(keys, key, period) for name, keys in self.channels.items()}

    def poses(self):
        """The pose at every key."""
        return [Solver(self.channels_at(key)) for key in range(self.length + 1)]

    def worst_miss(self):
        """(metres, key) where a hand or foot is farthest from its goal."""
        return max((pose.missed, key) for key, pose in enumerate(self.poses()))


def wave(length, mean, swing, peak=0.0):
    """A swing about a mean, highest at the key `peak`."""
    return lambda key: mean + swing * cos(2 * pi * (key - peak) / length)


def hermite(a, b, slope_a, slope_b, s):
    """From a to b with given slopes at both ends, s in 0..1."""
    return (
        a * (2 * s**3 - 3 * s**2 + 1) + slope_a * (s**3 - 2 * s**2 + s)
        + b * (3 * s**2 - 2 * s**3) + slope_b * (s**3 - s**2)
    )


class Gait:
    """Steps of a cycle: each foot goes back at exactly constant speed while it is down, then forward in an arc.

    A phase of 0 is where the right foot comes down; the left is half a cycle later. `down` is the share of the cycle that a foot
    is down, `front` and `back` where it comes down and leaves. `lift` and `pitch` are curves of the swing (0..1) and of the
    whole cycle (0..1)."""

    def __init__(self, length, down, front, back, width, lift, pitch, toes=4.0, eager=1.0):
        self.length, self.down, self.front, self.back = length, down, front, back
        self.width, self.lift, self.pitch, self.toes, self.eager = width, lift, pitch, toes, eager
        self.stride = (front - back) / down

    def sole(self, phase):
        """Place along the way and height of the sole."""
        phase %= 1.0
        if phase <= self.down:
            return self.front - self.stride * phase, 0.0
        s = (phase - self.down) / (1 - self.down)
        slope = -self.stride * (1 - self.down)
        return hermite(self.back, self.front, slope, slope * self.eager, s), curve(self.lift, s)

    def channels(self):
        """Both feet."""
        made = {}
        for side, lead, sign in (("r", 0.0, 1), ("l", 0.5, -1)):
            made[f"foot.{side}.x"] = lambda key, lead=lead: self.sole(key / self.length + lead)[0]
            made[f"foot.{side}.y"] = lambda key, lead=lead: self.sole(key / self.length + lead)[1]
            made[f"foot.{side}.pitch"] = lambda key, lead=lead: curve(self.pitch, (key / self.length + lead) % 1.0, 1.0)
            made[f"foot.{side}.z"] = sign * self.width
            made[f"foot.{side}.yaw"] = -sign * self.toes
        return made


# Standing at ease: the left foot behind, the lantern held before him, the right hand free.
STAND = {
    "foot.l.x": -0.10, "foot.l.z": -0.135, "foot.l.yaw": 24, "foot.r.x": 0.09, "foot.r.z": 0.125, "foot.r.yaw": -10,
    "hips.y": -0.026, "hips.z": 0.012, "hips.yaw": 7, "hips.roll": 2, "hips.pitch": 2, "chest.yaw": 3, "chest.pitch": -2, "chest.roll": -2,
    "head.pitch": 3, "head.yaw": -4,
    "arm.l.swing": 25, "arm.l.out": 16, "elbow.l": 77, "arm.r.swing": -10, "arm.r.out": 15, "elbow.r": 26,
    "hand.r.roll": 0,
}
