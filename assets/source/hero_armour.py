"""Helm, trunk, shoulders, arms and legs. What comes in pairs is made on the right and mirrored."""

from math import cos, radians, sin

from mathutils import Matrix, Vector

from hero_paints import *  # noqa: F403
from hero_rig import PLACE
from hero_shapes import Shape, axes_along, block, chain, limb, loft, oval, plate, rotation, stops

# The head is a little larger than life, so that it reads from afar.
HEAD_SIZE, HEAD_FOOT = 1.05, 1.235


def wrap(profile, start, end, origin=(0, 0, 0), axes=None, keel=0.0, hem=None):
    """A surface for `plate`, bent about an axis: from start to end in degrees (0 forward, 90 right, 180 back), down a profile
    of (height, half length forward, half length aside, shift forward); `keel` sharpens the front, `hem(u)` lowers the end."""
    x, y, z = axes or (Vector((1, 0, 0)), Vector((0, 1, 0)), Vector((0, 0, 1)))

    def surface(u, v):
        place = v * (len(profile) - 1)
        low = max(0, min(int(place), len(profile) - 2))
        share = place - low
        height, fore, aside, shift = (a + (b - a) * share for a, b in zip(profile[low], profile[low + 1]))
        angle = radians(start + (end - start) * u)
        c, s = cos(angle), sin(angle)
        fore *= 1.0 + keel * max(0.0, c) ** 4
        if hem:
            height -= hem(u) * v**3
        return Vector(origin) + y * height + x * (shift + fore * c) + z * aside * s

    return surface


def upwards(start, end):
    """Axes whose y runs up a limb, from its end to its start."""
    return axes_along(end, start)


def helm(shape):
    """A great helm: a face with a keel and breath holes, a dark slit with glowing eyes under a heavy brow, a brass cross."""
    def ring(height, fore, back, aside, shift=0.008):
        return oval((shift, height, 0), (fore, back), aside, 10)
    face = [ring(1.225, .138, .118, .118), ring(1.235, .160, .138, .134), ring(1.266, .162, .139, .135),
            ring(1.335, .180, .148, .146), ring(1.405, .190, .150, .151)]
    loft(shape, face, [BRASS_DARK, BRASS, STEEL, STEEL], "head")
    slit = [ring(1.400, .168, .137, .132), ring(1.460, .168, .137, .132)]
    loft(shape, slit, BLACK, "head", (False, False))
    bowl = [ring(1.450, .172, .14, .136), ring(1.446, .203, .158, .160), ring(1.475, .205, .160, .162),
            ring(1.535, .178, .150, .144), ring(1.578, .122, .112, .100), ring(1.600, .05, .05, .04)]
    loft(shape, bowl, [SHADE, BRIGHT, STEEL, STEEL, STEEL], "head")
    temples = [(1.468, .163, .160, 0), (1.398, .163, .155, 0)]
    plate(shape, wrap(temples, 62, 298, (0.008, 0, 0)), 1, 4, "head", SHADE, STEEL, .016, .01)
    brow = [(1.488, .203, .160, 0), (1.452, .214, .168, 0)]
    plate(shape, wrap(brow, -80, 80, (0.008, 0, 0)), 1, 4, "head", BRASS, BRASS_DARK, .012, .007)
    ridge(shape)
    core = [(1.446, .171, .135, 0), (1.414, .171, .135, 0)]
    for side in (1, -1):
        at = wrap(core, side * 12, side * 34, (0.008, 0, 0))
        decal(shape, at, [(0, 0), (1, .1), (1, .9), (0, 1)], "head", EYES, side)
        cheek = wrap([(1.405, .196, .156, 0), (1.268, .165, .139, 0)], side * 22, side * 60, (0.008, 0, 0))
        for low, row in ((.2, 0), (.43, 1), (.66, 2)):
            width = .55 - .12 * row
            decal(shape, cheek, [(.1, low), (.1 + width, low + .03), (.1 + width, low + .12), (.1, low + .10)], "head", BLACK, side)


def decal(shape, surface, corners, bind, paint, side):
    """A thin marking on a surface; on the left the surface runs the other way."""
    points = [shape.corner(surface(u, v), bind) for u, v in corners]
    shape.facet(points if side > 0 else points[::-1], paint)


def ridge(shape):
    """The brass ridge down the face and over the crown."""
    path = [(.183, 1.27), (.205, 1.395), (.222, 1.45), (.222, 1.48), (.194, 1.538), (.138, 1.583), (.05, 1.612), (-.06, 1.606)]
    rings = []
    for x, y in path:
        out = Vector((x - 0.0, (y - 1.42) * (1.2 if y > 1.5 else 0.2), 0)).normalized() * 0.016
        width = .016 if 1.3 < y < 1.6 else .011
        middle = Vector((x, y, 0))
        rings.append([middle - out, middle + Vector((0, 0, width)), middle + out, middle - Vector((0, 0, width))])
    loft(shape, rings, BRASS, "head")


def crest(shape):
    """A red brush that stands on the crown and streams back, in uneven tufts."""
    path = [  # x, foot, top, half width
        (.105, 1.592, 1.628, .010), (.055, 1.600, 1.668, .026), (.005, 1.604, 1.678, .034), (-.045, 1.602, 1.700, .040),
        (-.10, 1.585, 1.684, .042), (-.155, 1.545, 1.676, .040), (-.205, 1.495, 1.630, .036), (-.26, 1.445, 1.605, .030),
        (-.30, 1.40, 1.535, .022), (-.345, 1.385, 1.475, .014), (-.375, 1.355, 1.375, .003)]
    bind = stops((-.30, "crest"), (-.02, "crest"), (.06, "head"))
    rings = []
    for x, foot, top, half in path:
        waist = foot + (top - foot) * .55
        rings.append([shape.corner((x, y, z), bind(x)) for y, z in ((foot, 0), (waist, half), (top, 0), (waist, -half))])
    for a, b in zip(rings, rings[1:]):
        for i in range(4):
            j = (i + 1) % 4
            shape.quad(a[i], a[j], b[j], b[i], LINING if i in (0, 3) else RED)
    shape.cap(rings[0][::-1], RED)
    shape.cap(rings[-1], RED)


def trunk(shape):
    """Padding, breastplate and back, a lame below them, the surcoat's panel with its badge, the gorget."""
    def ring(height, fore, back, aside, count=8):
        return oval((0, height, 0), (fore, back), aside, count, 0.5)
    by_height = stops((.80, "hips"), (.88, "spine"), (.97, "chest"))
    bound = lambda p: by_height(p.y)  # noqa: E731
    padding = [ring(.655, .06, .06, .09), ring(.70, .115, .115, .155), ring(.79, .128, .125, .165), ring(.89, .122, .11, .145),
               ring(1.05, .15, .12, .165), ring(1.17, .12, .11, .15)]
    loft(shape, padding, DARK, bound)
    breast = [(1.205, .095, .150, .0), (1.15, .165, .194, .0), (1.07, .188, .205, .0), (.975, .158, .172, .0), (.925, .168, .182, .0)]
    plate(shape, wrap(breast, -106, 106, keel=.10), 4, 6, bound, STEEL, BRIGHT, .02, .012)
    back = [(1.20, .10, .15, .0), (1.10, .152, .20, .0), (.98, .135, .175, .0), (.93, .15, .18, .0)]
    plate(shape, wrap(back, 112, 248), 1, 3, bound, SHADE, STEEL, .02, .012)
    lame = [(.945, .138, .158, .0), (.90, .152, .172, .0), (.868, .168, .188, .0)]
    plate(shape, wrap(lame, -172, 172, keel=.05), 1, 8, bound, SHADE, STEEL, .02, .009)
    panel = [(1.192, .125, .17, .006), (1.15, .176, .203, .008), (1.07, .200, .214, .010), (.975, .172, .184, .010), (.925, .182, .194, .012), (.85, .182, .19, .010)]
    plate(shape, wrap(panel, -40, 40, keel=.10), 5, 2, bound, CLOTH, CLOTH_EDGE, .014, .012)
    badge = [(.222, 1.135, 0), (.225, 1.085, .034), (.222, 1.02, 0), (.225, 1.085, -.034)]
    made = [shape.corner(p, "chest") for p in badge]
    shape.cap(made, BRASS, (.242, 1.085, 0), "chest")
    gorget = [oval((0, 1.19, 0), .12, .135, 8), oval((.0, 1.28, 0), .075, .075, 8)]
    to_neck = stops((1.19, "chest"), (1.27, "neck"))
    loft(shape, gorget, DARK, lambda p: to_neck(p.y))


def shoulder(size=1.0, rims=BRIGHT):
    """Three lames over the right shoulder, each over the next."""
    shape = Shape()
    x, y, z = PLACE["upper_arm.r"]
    lean = rotation((1, 0, 0), 24).to_3x3()
    axes = [lean @ Vector(axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    origin = (x + .002, y - .005, z + .012)
    lames = [
        ([(-.045, .118, .112, 0), (-.115, .128, .120, 0)], 1, SHADE, STEEL, {"chest": .35, "upper_arm.r": .65}),
        ([(.02, .120, .112, 0), (-.035, .136, .128, 0), (-.060, .145, .137, 0)], 2, STEEL, rims, {"chest": .5, "upper_arm.r": .5}),
        ([(.112, .045, .04, 0), (.074, .112, .102, 0), (.002, .146, .138, 0)], 2, STEEL, rims,
         {"chest": .7, "upper_arm.r": .3})]
    for profile, rows, paint, rim, bind in lames:
        scaled = [(h * size, a * size, b * size, s) for h, a, b, s in profile]
        plate(shape, wrap(scaled, -28, 208, origin, axes), rows, 4, bind, paint, rim, .016, .011, SHADE)
    return shape


def arm():
    """The right arm: a padded sleeve, plates on its outside, a cop on the elbow, a flared cuff, a fist in leather."""
    shape = Shape()
    top, elbow, wrist = (PLACE[f"{joint}.r"] for joint in ("upper_arm", "forearm", "hand"))
    sleeve = [(.0, .062, .060, 0), (.45, .066, .06, 0), (.82, .054, .051, 0), (1.0, .051, .05, 0),
              (1.3, .054, .05, 0)]
    rings = chain(shape, (top, elbow, wrist), sleeve, 6, DARK, ("upper_arm.r", "forearm.r"))
    shape.cap(rings[0][::-1], DARK)
    upper = upwards(top, elbow)
    guard = [(.115, .074, .072, 0), (.036, .076, .074, 0)]
    plate(shape, wrap(guard, -35, 215, elbow, upper), 1, 4, "upper_arm.r", SHADE, PLATE, .014, .008)
    between = axes_along(wrist, top)
    cop = [(.056, .056, .054, -.004), (.0, .084, .080, -.012), (-.054, .056, .054, -.004)]
    plate(shape, wrap(cop, 40, 235, elbow, between), 2, 3, {"upper_arm.r": .5, "forearm.r": .5}, PLATE, STEEL, .014, .009)
    lower = upwards(elbow, wrist)
    cuff = [(.20, .058, .054, 0), (.46, .074, .067, 0), (.82, .056, .053, 0), (.86, .063, .060, 0), (1.04, .082, .076, 0), (1.0, .045, .042, 0)]
    limb(shape, elbow, wrist, cuff, 7, [PLATE, PLATE, BRASS_DARK, LEATHER, LEATHER_DARK], "forearm.r", caps=(False, True))
    fist(shape, wrist, lower)
    return shape


def fist(shape, wrist, axes):
    """A gauntlet closed to a fist, the fingers curled inwards, a plate over the knuckles."""
    x, y, z = axes
    palm = [(0, .032, .028, 0), (.05, .052, .040, .002), (.09, .050, .036, .004), (.108, .034, .022, .004)]
    ways = [(h / .108, a, b, s) for h, a, b, s in palm]
    limb(shape, wrist, wrist - y * .108, ways, 6, LEATHER, "hand.r", power=2.6)
    block(shape, wrist - y * .078 - z * .036 + x * .004, (.044, .022, .028), LEATHER_DARK, "hand.r", .9, (x, -z, y))
    thumb = [(0, .020, .020, 0), (1, .015, .014, 0)]
    limb(shape, wrist - y * .03 + x * .038 - z * .01, wrist - y * .088 + x * .047 - z * .036, thumb, 4, LEATHER, "hand.r")
    knuckles = [(-.008, .044, .044, 0), (-.092, .060, .050, .004)]
    plate(shape, wrap(knuckles, 25, 155, wrist, axes), 1, 3, "hand.r", PLATE, STEEL, .010, .007)


def leg():
    """The right leg: padding that bends softly, cuisse, knee cop with a wing, greave, boot."""
    shape = Shape()
    hip, knee, ankle = (PLACE[f"{joint}.r"] for joint in ("thigh", "shin", "foot"))
    padding = [(-.12, .075, .07, 0), (.05, .096, .088, 0), (.4, .094, .084, 0), (.8, .075, .068, 0), (1.0, .069, .064, 0),
               (1.25, .067, .060, -.004)]
    rings = chain(shape, (hip, knee, ankle), padding, 6, DARK, ("thigh.r", "shin.r"))
    shape.cap(rings[0][::-1], DARK)
    thigh = upwards(hip, knee)
    cuisse = [(.215, .106, .100, 0), (.12, .100, .092, 0), (.046, .086, .082, 0)]
    plate(shape, wrap(cuisse, -62, 112, knee, thigh, keel=.06), 2, 4, "thigh.r", PLATE, STEEL, .014, .009)
    both = {"thigh.r": .5, "shin.r": .5}
    cop = [(.064, .074, .072, .004), (.0, .096, .086, .012), (-.060, .070, .070, .004)]
    plate(shape, wrap(cop, -78, 86, knee, thigh, keel=.14), 2, 4, both, PLATE, BRASS, .014, .010)
    wing = [(.042, .07, .092, -.004), (-.036, .066, .092, -.004)]
    plate(shape, wrap(wing, 62, 138, knee, thigh), 1, 2, both, BRASS, BRASS_DARK, .012, .008)
    greave = [(.17, .066, .064, 0), (.40, .079, .072, -.008), (.70, .062, .058, -.002), (.86, .070, .067, .0)]
    limb(shape, knee, ankle, greave, 8, [PLATE, PLATE, STEEL], "shin.r", start_angle=0.0, caps=(False, True))
    strap = [(.46, .081, .074, -.007), (.56, .076, .069, -.005)]
    limb(shape, knee, ankle, strap, 8, LEATHER, "shin.r", start_angle=0.0, caps=(False, False))
    boot(shape, ankle)
    return shape


def boot(shape, ankle):
    """A heavy boot: heel, instep, a broad toe with a steel cap, a dark sole."""
    shaft = [oval((ankle.x + .008, y, ankle.z), (a, a * 1.05), b, 6, 0.5) for y, a, b in
             ((.075, .062, .052), (.175, .055, .048))]
    around = stops((.085, "foot.r"), (.135, "shin.r"))
    loft(shape, shaft, LEATHER, lambda p: around(p.y))
    path = [  # x from the ankle, sole, top, half width
        (-.080, .006, .085, .036), (-.04, .0, .125, .050), (.02, .0, .128, .054), (.065, .0, .105, .058),
        (.115, .0, .085, .066), (.160, .017, .070, .060), (.198, .030, .052, .036)]
    rings = []
    for x, sole, top, half in path:
        edge = sole + (top - sole) * .26
        outline = [(sole, half * .92), (edge, half), (top, half * .5)]
        outline += [(y, -z) for y, z in reversed(outline)]
        # The inner side is straighter than the outer.
        rings.append([shape.corner((ankle.x + x, y, ankle.z + z * (1.0 if z > 0 else .86)), "foot.r") for y, z in outline])
    for a, b in zip(rings, rings[1:]):
        for i in range(6):
            j = (i + 1) % 6
            shape.quad(b[i], b[j], a[j], a[i], LEATHER_DARK if i in (0, 4, 5) else LEATHER)
    shape.cap(rings[0], LEATHER_DARK)
    shape.cap(rings[-1][::-1], LEATHER_DARK)
    cap = [(.072, .067, .062), (.118, .095, .072), (.170, .073, .066), (.203, .045, .040)]
    bands = [[shape.corner((ankle.x + x, y, ankle.z + z * share), "foot.r") for y, share in
              ((max(top * .38, (x - .115) * .42), 1.03), (top * 1.04, .52), (top * 1.04, -.48), (max(top * .38, (x - .115) * .42), -.90))] for x, top, z in cap]
    shape.skin(bands[::-1], PLATE, closed=False)
    shape.facet(bands[-1][::-1], SHADE)


def armour(shape):
    """All of it."""
    head = Shape()
    helm(head)
    crest(head)
    shape.add(head.moved(Matrix.Translation((0, HEAD_FOOT, 0)) @ Matrix.Scale(HEAD_SIZE, 4) @ Matrix.Translation((0, -HEAD_FOOT, 0))))
    trunk(shape)
    for part in (arm(), leg()):
        shape.add(part)
        shape.add(part, mirrored=True)
    # The right shoulder carries the heavier plate.
    shape.add(shoulder(1.08, BRASS))
    shape.add(shoulder(0.96, BRIGHT), mirrored=True)
