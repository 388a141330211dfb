"""What he wears over the armour and carries: surcoat, belts, pouches, cape, lantern, sword."""

from math import cos, sin

from mathutils import Vector

from hero_armour import wrap
from hero_paints import *  # noqa: F403
from hero_rig import PLACE
from hero_shapes import Shape, block, limb, loft, oval, plate, rotation, stops


def along_thigh(side, most):
    """Cloth and plates below the belt follow the thigh, the lower the more."""
    def bind(point):
        share = max(0.0, min(1.0, (.83 - point.y) / .24)) * most
        return {"hips": 1.0 - share, f"thigh.{side}": share}
    return bind


def surcoat(shape):
    """Four tails, split before, behind and at the sides, each over its thigh, with uneven hems."""
    front = [(.862, .165, .178, 0), (.76, .178, .195, 0), (.64, .192, .212, 0), (.53, .205, .225, .004)]
    rear = [(.862, .148, .178, 0), (.74, .172, .2, 0), (.60, .195, .22, 0), (.47, .215, .235, 0)]
    hems = {"r": (lambda u: .045 * (1 - u) - .02 * sin(9 * u), lambda u: .05 * sin(7 * u)),
            "l": (lambda u: .06 * u * (1 - u) * 2 - .01, lambda u: .06 * (1 - u) + .02 * sin(11 * u))}
    for side in "rl":
        half = Shape()
        before, behind = hems[side]
        bind = along_thigh("r", .82)
        plate(half, wrap(front, 2, 60, hem=before), 3, 2, bind, CLOTH, CLOTH_EDGE, .014, .012, CLOTH_INSIDE)
        plate(half, wrap(rear, 122, 178, hem=behind), 3, 2, bind, CLOTH, CLOTH_EDGE, .014, .012, CLOTH_INSIDE)
        shape.add(half, mirrored=side == "l")


def tassets():
    """Two plates over the right thigh."""
    shape = Shape()
    low = [(.735, .165, .212, 0), (.66, .175, .226, 0), (.60, .165, .224, 0)]
    high = [(.845, .158, .195, 0), (.77, .178, .222, 0), (.705, .188, .236, 0)]
    plate(shape, wrap(low, 56, 118), 2, 2, along_thigh("r", .75), SHADE, STEEL, .014, .010)
    plate(shape, wrap(high, 50, 124), 2, 2, along_thigh("r", .55), STEEL, BRIGHT, .014, .010)
    return shape


def belts(shape):
    """A belt with a buckle, a second that hangs to the sword, two pouches on the right."""
    rings = [oval((0, y, 0), (a, a - .012), b, 10, .5) for y, a, b in
             ((.832, .184, .199), (.872, .182, .197), (.876, .160, .175))]
    loft(shape, rings, [LEATHER, LEATHER_EDGE], "hips", (False, False))
    block(shape, (.192, .853, .0), (.013, .030, .034), BRASS, "hips", .95)
    block(shape, (.203, .853, .0), (.006, .015, .018), LEATHER_DARK, "hips", .95)
    tilt = rotation((1, 0, 0), -11, (0, .80, 0))
    hanging = [[tilt @ p for p in oval((0, y, 0), (a, a - .006), b, 10, .5)] for y, a, b in
               ((.792, .188, .216), (.816, .188, .214), (.820, .170, .198))]
    loft(shape, hanging, [LEATHER_DARK, LEATHER], "hips", (False, False))
    for centre, half, angle in (((.135, .785, .172), (.034, .048, .050), -42), ((-.075, .79, .222), (.026, .040, .044), -100)):
        turn = rotation((0, 1, 0), angle).to_3x3()
        axes = [turn @ Vector(axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
        block(shape, centre, half, LEATHER, "hips", .85, axes)
        flap = Vector(centre) + axes[1] * half[1] * .62 + axes[0] * .004
        block(shape, flap, (half[0] * 1.1, half[1] * .45, half[2] * 1.08), LEATHER_EDGE, "hips", .8, axes)
        block(shape, flap + axes[0] * half[0] * 1.08 - axes[1] * .012, (.007, .010, .010), BRASS, "hips", .9, axes)


def mantle(shape):
    """The cape's collar: a roll of cloth about the neck that falls over the shoulders, closed by a brass clasp."""
    folds = 12
    def ring(height, fore, back, aside, ripple, phase):
        points = oval((-.012, height, 0), (fore, back), aside, folds, 0.5)
        return [Vector((p.x, p.y + ripple * cos(i * 2.4 + phase) - .03 * max(0, p.x), p.z)) for i, p in enumerate(points)]
    rings = [ring(1.222, .118, .12, .122, 0, 0), ring(1.262, .136, .142, .142, .005, 0), ring(1.248, .165, .172, .175, .007, 1),
             ring(1.212, .178, .190, .205, .007, 2), ring(1.172, .188, .207, .228, .014, 3)]
    rings.append(ring(1.160, .12, .13, .15, .006, 3))
    loft(shape, rings[::-1], [LINING, RED_EDGE, RED, RED, RED_EDGE], "chest", (False, False))
    clasp = [(0, .026, .026, 0), (.6, .030, .030, 0), (1, .016, .016, 0)]
    limb(shape, (.142, 1.205, .085), (.192, 1.218, .108), clasp, 6, BRASS, "chest", forward=(0, 1, 0))


CAPE_TOP, CAPE_COLUMNS, CAPE_ROWS = 1.215, 11, 7
# How much each column of the hem is longer or shorter: torn, never alike.
HEM = [-.06, .05, -.03, .07, -.10, .02, .085, -.05, .06, -.12, .05, -.02]
# Where its columns lie, from left to right, and how far each fold stands out.
COLUMNS = [-1, -.86, -.66, -.46, -.32, -.12, .08, .22, .42, .62, .82, 1]
FOLDS = [.2, -.6, .9, -.5, .7, -.9, .4, -.8, 1.0, -.4, .6, -.2]


def cape(shape):
    """A sheet with folds that grow towards a torn hem; its inside is darker."""
    spine = [(1.225, -.135), *((PLACE[f"cape.{i}"].y, PLACE[f"cape.{i}"].x) for i in range(1, 6)), (.25, -.266), (.0, -.27)]
    def back(height):
        for (high, a), (low, b) in zip(spine, spine[1:]):
            if height >= low:
                return a + (b - a) * (high - height) / (high - low)
        return spine[-1][1]
    centres = [(1.20, "chest")] + [((PLACE[f"cape.{i}"].y + (PLACE[f"cape.{i + 1}"].y if i < 5 else .25)) / 2, f"cape.{i}") for i in range(1, 6)]
    by_depth = stops(*[(-height, bone) for height, bone in centres])
    def point(row, column, inside):
        v, u = row / CAPE_ROWS, COLUMNS[column]
        height = CAPE_TOP - v * (CAPE_TOP - .27)
        if row == CAPE_ROWS:
            height -= HEM[column]
        half = .185 + .145 * v**.8
        fold = (.008 + .042 * v) * FOLDS[column]
        x = back(height) + (.11 - .07 * v) * u * u + fold + (.018 if inside else 0)
        return Vector((x, height - .03 * u * u * (1 - v), half * u + .012 * sin(3 * v + u)))
    sheets = []
    for inside in (False, True):
        sheets.append([[shape.corner(p := point(r, c, inside), by_depth(-p.y)) for c in range(CAPE_COLUMNS + 1)] for r in range(CAPE_ROWS + 1)])
    outer, inner = sheets
    for r in range(CAPE_ROWS):
        for c in range(CAPE_COLUMNS):
            a, b = outer[r], outer[r + 1]
            shape.quad(b[c], b[c + 1], a[c + 1], a[c], RED)
            a, b = inner[r], inner[r + 1]
            shape.quad(a[c], a[c + 1], b[c + 1], b[c], LINING)
        shape.quad(outer[r][0], inner[r][0], inner[r + 1][0], outer[r + 1][0], RED_EDGE)
        shape.quad(inner[r][-1], outer[r][-1], outer[r + 1][-1], inner[r + 1][-1], RED_EDGE)
    for c in range(CAPE_COLUMNS):
        shape.quad(outer[-1][c + 1], outer[-1][c], inner[-1][c], inner[-1][c + 1], RED_EDGE)
        shape.quad(outer[0][c], outer[0][c + 1], inner[0][c + 1], inner[0][c], RED)


def lantern(shape):
    """A ring in the fist, a hood with a chimney, glowing glass behind six bars, a foot."""
    x, y, z = PLACE["lantern"]
    def ring(down, radius, count=6, start=.5):
        return oval((x, y - down, z), radius, radius, count, start)
    corners = [(0, .012), (.030, .028), (.026, .066), (-.026, .066), (-.030, .028), (0, .012)]
    for (a, down_a), (b, down_b) in zip(corners, corners[1:]):
        limb(shape, (x + a, y - down_a + .03, z), (x + b, y - down_b + .03, z), [(0, .007, .007, 0), (1, .007, .007, 0)], 4, BRASS_DARK, "lantern", forward=(0, .2, 1), caps=(False, False))
    hood = [ring(.118, .062), ring(.122, .092), ring(.108, .090), ring(.068, .036), ring(.042, .028), ring(.030, .034)]
    loft(shape, hood, [BRASS_DARK, BRASS_DARK, BRASS, BRASS_DARK, BRASS], "lantern")
    glass = [ring(.228, .052), ring(.200, .066), ring(.150, .066), ring(.118, .054)]
    loft(shape, glass, [FLAME, FLAME_HEART, FLAME], "lantern", (False, False))
    foot = [ring(.262, .066), ring(.256, .084), ring(.240, .084), ring(.226, .060)]
    loft(shape, foot, [BRASS_DARK, BRASS, BRASS], "lantern")
    for low, high in zip(ring(.232, .072), ring(.116, .074)):
        limb(shape, low, high, [(0, .010, .010, 0), (1, .010, .010, 0)], 3, BRASS_DARK, "lantern", caps=(False, False))


def sword(shape):
    """A short broad sword in its sheath at the left hip, the hilt forward."""
    x, y, z = PLACE["sword"]
    mouth = Vector((x, y, z))
    along = Vector((-.73, -.65, -.10)).normalized()
    side = Vector((0, 0, 1))
    def flat(profile, paint, bone, caps=(True, True), count=6):
        start, end = mouth + along * profile[0][0], mouth + along * profile[-1][0]
        whole = profile[-1][0] - profile[0][0]
        limb(shape, start, end, [((d - profile[0][0]) / whole, a, b, 0) for d, a, b in profile], count, paint, bone, forward=(.58, -.8, 0), start_angle=0.0, caps=caps)
    flat([(.0, .046, .028), (.035, .044, .026)], BRASS, "hips")
    flat([(.03, .038, .021), (.45, .030, .015)], LEATHER_DARK, "hips", (False, False))
    flat([(.20, .039, .022), (.225, .039, .022)], BRASS_DARK, "hips", (False, False))
    flat([(.44, .034, .019), (.535, .010, .007)], BRASS, "hips")
    flat([(-.01, .030, .010), (.36, .028, .008), (.45, .004, .004)], STEEL, "sword", (False, False), 4)
    block(shape, mouth - along * .022, (.085, .013, .017), BRASS, "sword", 1.0, _hilt_axes(along, side))
    flat([(-.03, .018, .015), (-.09, .021, .018), (-.15, .016, .014)], LEATHER, "sword", (False, False))
    flat([(-.145, .016, .016), (-.162, .030, .027), (-.185, .030, .027), (-.200, .014, .014)], BRASS, "sword")


def _hilt_axes(along, side):
    """The guard's long side lies across the blade."""
    across = side.cross(along).normalized()
    return across, -along, across.cross(-along)


def gear(shape):
    """All of it."""
    surcoat(shape)
    part = tassets()
    shape.add(part)
    shape.add(part, mirrored=True)
    belts(shape)
    mantle(shape)
    cape(shape)
    lantern(shape)
    sword(shape)
