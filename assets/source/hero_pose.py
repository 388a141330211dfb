"""Poses from few numbers: curves over time, the trunk's bends, limbs placed by angles or by where hand and foot go.

A pose is a dict of channels (name -> number); what is not named is 0. Angles are degrees, lengths metres, all in figure
axes (hero_rig). Positive is: pitch forward and down, yaw to the figure's left, roll to its right.

    hips.x .y .z            the hips' shift from rest            hips|spine|chest.pitch .yaw .roll
    head.pitch .yaw .roll   where the head looks, in the figure's axes, however the trunk bends
    foot.S.x .y .z          the middle of the flat sole on the ground; S is l or r
    foot.S.pitch .yaw       heel up (about the ball) or toes up (about the heel); toes to the left
    knee.S.out              the knee's turn outwards
    arm.S.swing .out .across .twist, elbow.S, hand.S.pitch .yaw .roll
    arm.S.ik, reach.S.x .y .z, arm.S.pole   share of the hand's place that is given, that place, the elbow's turn outwards
"""

from math import acos, atan2, cos, degrees, radians, sin

import bpy  # noqa: F401  (first: mathutils comes with it)
from mathutils import Matrix, Quaternion, Vector

from hero_rig import CARRIER, JOINTS, PLACE

X, Y, Z = Vector((1, 0, 0)), Vector((0, 1, 0)), Vector((0, 0, 1))
DOWN = -Y
SIDES = {"l": -1.0, "r": 1.0}
# The sole: ankle above it, heel behind and ball before the ankle.
ANKLE = PLACE["foot.r"].y
HEEL, BALL = Vector((-0.075, -ANKLE, 0.0)), Vector((0.115, -ANKLE, 0.0))
# The toe's tip, and how far the boot rolls over its ball until the tip is down.
TIP = Vector((0.198, 0.030 - ANKLE, 0.0))
ROLL = degrees(atan2(TIP.y - BALL.y, TIP.x - BALL.x))
# A limb is never stretched quite straight: the joint would jump.
STRAIGHT = 0.998


def turn(axis, angle):
    """A rotation about an axis by degrees."""
    return Quaternion(axis, radians(angle))


def bend(pitch=0.0, yaw=0.0, roll=0.0):
    """A rotation of trunk or head."""
    return turn(Y, yaw) @ turn(X, roll) @ turn(Z, -pitch)


def curve(keys, time, period=None):
    """The value at a time of a smooth curve through (time, value) keys; flat at its extremes, so it never overshoots."""
    if not isinstance(keys, (list, tuple)):
        return keys(time) if callable(keys) else keys
    keys = sorted(keys)
    if period is not None:
        time %= period
        first, last = keys[0], keys[-1]
        before = [(t - period, v) for t, v in keys if t - period < first[0]]
        after = [(t + period, v) for t, v in keys if t + period > last[0]]
        keys = before[-3:] + keys + after[:3]
    if time <= keys[0][0]:
        return keys[0][1]
    for i in range(len(keys) - 1):
        (t0, a), (t1, b) = keys[i], keys[i + 1]
        if time <= t1:
            span = t1 - t0
            s = (time - t0) / span
            m0, m1 = _slope(keys, i) * span, _slope(keys, i + 1) * span
            return (
                a * (2 * s**3 - 3 * s**2 + 1) + m0 * (s**3 - 2 * s**2 + s)
                + b * (3 * s**2 - 2 * s**3) + m1 * (s**3 - s**2)
            )
    return keys[-1][1]


def _slope(keys, i):
    """The tangent at a key: none at an end or an extreme, else the mean of both sides, limited to stay monotone."""
    if i == 0 or i == len(keys) - 1:
        return 0.0
    (t0, a), (t1, b), (t2, c) = keys[i - 1], keys[i], keys[i + 1]
    left, right = (b - a) / (t1 - t0), (c - b) / (t2 - t1)
    if left * right <= 0.0:
        return 0.0
    mean = (left * (t2 - t1) + right * (t1 - t0)) / (t2 - t0)
    limit = 3.0 * min(abs(left), abs(right))
    return max(-limit, min(limit, mean))


class Solver:
    """Turns channels into local rotations of the joints and the hips' shift."""

    def __init__(self, channels):
        self.channels = channels
        self.world = {}
        self.at = {}
        self.missed = 0.0  # the farthest that a foot or hand stays from its goal
        self._solve()

    def get(self, name, default=0.0):
        return self.channels.get(name, default)

    def _bend(self, name):
        return bend(*(self.get(f"{name}.{part}") for part in ("pitch", "yaw", "roll")))

    def _place(self, joint, world):
        """Sets a joint's rotation in figure axes; its place follows from its carrier."""
        carrier = CARRIER[joint]
        self.world[joint] = world
        if carrier:
            self.at[joint] = self.at[carrier] + self.world[carrier] @ (PLACE[joint] - PLACE[carrier])

    def _solve(self):
        self.world["root"], self.at["root"] = Quaternion(), Vector((0, 0, 0))
        self._place("hips", self._bend("hips"))
        self.at["hips"] += Vector([self.get(f"hips.{axis}") for axis in "xyz"])
        for joint in ("spine", "chest"):
            self._place(joint, self.world[CARRIER[joint]] @ self._bend(joint))
        look = self._bend("head")
        self._place("neck", self.world["chest"].slerp(look, 0.4))
        self._place("head", look)
        for side, sign in SIDES.items():
            self._leg(side, sign)
            self._arm(side, sign)
        # What hangs, hangs; the game's springs take over from there.
        self._place("lantern", turn(Y, self.get("lantern.yaw")) @ turn(Z, self.get("lantern.swing")))
        for joint in JOINTS:
            if joint not in self.world:
                self._place(joint, self.world[CARRIER[joint]].copy())

    def _leg(self, side, sign):
        names = thigh, shin, foot = [f"{joint}.{side}" for joint in ("thigh", "shin", "foot")]
        pitch, yaw = self.get(f"{foot}.pitch"), self.get(f"{foot}.yaw")
        sole = Vector([self.get(f"{foot}.{axis}") for axis in "xyz"])
        flat, tilted = turn(Y, yaw), turn(Y, yaw) @ turn(Z, -pitch)
        # A boot rolls over its ball, then stands on its tip; toes up it stands on its heel.
        pivot = BALL if pitch > 0.0 else HEEL
        rolled = turn(Y, yaw) @ turn(Z, -min(pitch, ROLL))
        ankle = sole + Y * ANKLE + flat @ pivot - rolled @ pivot
        if pitch > ROLL:
            ankle += rolled @ TIP - tilted @ TIP
        self._place(thigh, Quaternion())
        hinge = self.world["hips"] @ Z
        self._note(self._two_bones(names, ankle, hinge, -1.0, sign * self.get(f"knee.{side}.out")))
        self._place(foot, tilted)

    def _arm(self, side, sign):
        names = upper, fore, hand = [f"{joint}.{side}" for joint in ("upper_arm", "forearm", "hand")]
        chest = self.world["chest"]
        angle = {part: self.get(f"arm.{side}.{part}") for part in ("swing", "out", "across", "twist")}
        straight = (
            chest @ turn(Y, sign * angle["across"]) @ turn(X, -sign * angle["out"])
            @ turn(Z, angle["swing"]) @ turn(Y, sign * angle["twist"])
        )
        self._place(upper, straight @ _straightened(upper, fore))
        self._place(fore, straight @ turn(Z, self.get(f"elbow.{side}")) @ _straightened(fore, hand))
        share = self.get(f"arm.{side}.ik")
        if share > 0.0:
            free = self.world[upper].copy(), self.world[fore].copy()
            goal = Vector([self.get(f"reach.{side}.{axis}") for axis in "xyz"])
            missed = self._two_bones(names, goal, chest @ Z, 1.0, -sign * self.get(f"arm.{side}.pole"))
            if share == 1.0:
                self._note(missed)
            self._place(upper, free[0].slerp(self.world[upper], share))
            self._place(fore, free[1].slerp(self.world[fore], share))
        wrist = bend(self.get(f"{hand}.pitch"), self.get(f"{hand}.yaw"), self.get(f"{hand}.roll"))
        straighten = _straightened(fore, hand)
        self._place(hand, self.world[fore] @ straighten.inverted() @ wrist @ straighten)

    def _two_bones(self, names, goal, hinge, flexes, out):
        """Upper and lower bone so that the end is at the goal; by how much it is not. The joint between them flexes about the
        hinge, that is turned out about the way to the goal."""
        first, second, end = names
        a = (PLACE[second] - PLACE[first]).length
        b = (PLACE[end] - PLACE[second]).length
        way = goal - self.at[first]
        reach = max(abs(a - b) * 1.05, min(way.length, (a + b) * STRAIGHT))
        along = way.normalized()
        aside = turn(along, out) @ (along.cross(hinge) * flexes).normalized()
        alpha = acos(max(-1.0, min(1.0, (a * a + reach * reach - b * b) / (2 * a * reach))))
        upper = along * cos(alpha) + aside * sin(alpha)
        lower = (along * reach - upper * a).normalized()
        hinge = aside.cross(along).normalized() * flexes
        self._place(first, _frame(upper, hinge) @ _straightened(first, second))
        self._place(second, _frame(lower, hinge) @ _straightened(second, end))
        return abs(way.length - reach)

    def _note(self, missed):
        self.missed = max(self.missed, missed)

    def local(self, joint):
        """A joint's rotation against its carrier."""
        carrier = CARRIER[joint]
        return self.world[carrier].inverted() @ self.world[joint] if carrier else self.world[joint].copy()

    def shift(self):
        """The hips' place against rest, in the axes of the root."""
        return self.at["hips"] - PLACE["hips"]


def _straightened(joint, end):
    """From a limb that hangs straight down to the limb's rest direction, undone: applied before the limb's turns."""
    return (PLACE[end] - PLACE[joint]).normalized().rotation_difference(DOWN)


def _frame(along, hinge):
    """The rotation that takes down to `along` and z to `hinge`."""
    up = -along
    return Matrix((up.cross(hinge), up, hinge)).transposed().to_quaternion()
