"""From figure, rig and clips to one .glb."""

import bpy
from mathutils import Vector

from hero_clip import KEYS_A_SECOND
from hero_rig import JOINTS


def clear():
    """An empty scene."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = KEYS_A_SECOND


def key_clip(rig, clip):
    """Makes an action of a clip: a rotation of every joint at every key, and the hips' shift."""
    poses = clip.poses()
    action = bpy.data.actions.new(clip.name)
    action.use_fake_user = True
    rig.animation_data_create()
    rig.animation_data.action = action
    slot = action.slots[0] if action.slots else action.slots.new("OBJECT", rig.name)
    rig.animation_data.action_slot = slot
    # Since Blender 5 the curves of an action are only to be had through its layers.
    bag = action.layers.new("keys").strips.new(type="KEYFRAME").channelbag(slot, ensure=True)
    for joint in JOINTS:
        path = f'pose.bones["{joint}"].'
        turns = [pose.local(joint) for pose in poses]
        for before, after in zip(turns, turns[1:]):
            if before.dot(after) < 0.0:
                after.negate()
        _channel(bag, path + "rotation_quaternion", turns)
    _channel(bag, 'pose.bones["hips"].location', [pose.shift() for pose in poses])
    return action


def _channel(bag, path, values):
    for index in range(len(values[0])):
        line = bag.fcurves.new(path, index=index)
        line.keyframe_points.add(len(values))
        flat = [number for key, value in enumerate(values) for number in (key, value[index])]
        line.keyframe_points.foreach_set("co", flat)
        for key in line.keyframe_points:
            key.interpolation = "LINEAR"
        line.update()


def write(rig, path):
    """Writes everything in the scene."""
    rig.animation_data.action = None
    for bone in rig.pose.bones:
        bone.rotation_quaternion, bone.location = (1, 0, 0, 0), Vector((0, 0, 0))
    bpy.ops.export_scene.gltf(
        filepath=str(path),
        export_format="GLB",
        export_yup=True,
        export_extras=True,
        export_normals=True,
        export_tangents=False,
        export_texcoords=False,
        export_materials="EXPORT",
        export_vertex_color="ACTIVE",
        export_skins=True,
        export_influence_nb=4,
        export_all_influences=False,
        export_animations=True,
        export_animation_mode="ACTIONS",
        export_force_sampling=True,
        export_frame_range=False,
        export_optimize_animation_size=True,
        export_optimize_animation_keep_anim_armature=True,
        export_def_bones=False,
        export_rest_position_armature=True,
        export_morph=False,
        export_cameras=False,
        export_lights=False,
    )
