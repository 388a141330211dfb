"""The hero's skeleton: where each joint is, which joint carries it, and its armature in Blender.

Figure axes, here and in the .glb: x forward, y up, z to the figure's right; metres, the ground under the figure at the
origin. In the rest pose every bone has exactly these axes: a local rotation of a joint is a rotation about the figure's
own x, y and z, whatever way the limb points. Blender's axes are x forward, y left, z up; only `to_blender` knows them.
"""

import bpy
from mathutils import Matrix, Vector

# Joint: (the joint that carries it, its place in the rest pose). The arms of the rest pose hang a little outwards.
_MIDDLE = {
    "root": (None, (0.0, 0.0, 0.0)),
    "hips": ("root", (0.0, 0.74, 0.0)),
    "spine": ("hips", (0.0, 0.83, 0.0)),
    "chest": ("spine", (0.0, 0.97, 0.0)),
    "neck": ("chest", (-0.01, 1.21, 0.0)),
    "head": ("neck", (0.0, 1.27, 0.0)),
    "crest": ("head", (-0.06, 1.60, 0.0)),
    "cape.1": ("chest", (-0.155, 1.19, 0.0)),
    "cape.2": ("cape.1", (-0.205, 1.01, 0.0)),
    "cape.3": ("cape.2", (-0.234, 0.82, 0.0)),
    "cape.4": ("cape.3", (-0.250, 0.63, 0.0)),
    "cape.5": ("cape.4", (-0.260, 0.44, 0.0)),
    "sword": ("hips", (0.10, 0.80, -0.215)),
}

# Joints that come in pairs, as of the right side; the left side is their mirror image.
_PAIRED = {
    "upper_arm": ("chest", (-0.01, 1.145, 0.215)),
    "forearm": ("upper_arm", (-0.02, 0.925, 0.305)),
    "hand": ("forearm", (0.03, 0.715, 0.355)),
    "thigh": ("hips", (0.0, 0.705, 0.095)),
    "shin": ("thigh", (0.012, 0.395, 0.108)),
    "foot": ("shin", (-0.012, 0.095, 0.115)),
}

# How far a bone is drawn in Blender; nothing depends on it.
_BONE_LENGTH = 0.08


def _joints():
    """All joints, carriers first: name -> (carrier, place)."""
    joints = dict(_MIDDLE)
    for name, (carrier, (x, y, z)) in _PAIRED.items():
        for side, sign in (("l", -1.0), ("r", 1.0)):
            by = carrier if carrier in _MIDDLE else f"{carrier}.{side}"
            joints[f"{name}.{side}"] = (by, (x, y, sign * z))
    x, y, z = joints["hand.l"][1]
    joints["lantern"] = ("hand.l", (x + 0.02, y - 0.075, z - 0.01))
    return joints


JOINTS = _joints()
CARRIER = {name: carrier for name, (carrier, _) in JOINTS.items()}
PLACE = {name: Vector(place) for name, (_, place) in JOINTS.items()}


def to_blender(point):
    """A point or direction of the figure in Blender's axes."""
    return Vector((point[0], -point[2], point[1]))


def build_armature():
    """The armature object, with all joints as bones that point up."""
    data = bpy.data.armatures.new("hero_rig")
    rig = bpy.data.objects.new("hero_rig", data)
    bpy.context.scene.collection.objects.link(rig)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    for name, (carrier, place) in JOINTS.items():
        bone = data.edit_bones.new(name)
        head = to_blender(place)
        axes = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))  # the figure's axes as columns
        bone.head, bone.tail = head, head + Vector((0, 0, _BONE_LENGTH))
        bone.matrix = Matrix.Translation(head) @ axes.to_4x4()
        bone.length = _BONE_LENGTH
        if carrier:
            bone.parent = data.edit_bones[carrier]
    bpy.ops.object.mode_set(mode="OBJECT")
    data.display_type = "STICK"
    for bone in rig.pose.bones:
        bone.rotation_mode = "QUATERNION"
    return rig
