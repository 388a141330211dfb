"""Contact sheets of hero.glb, to look at what was made.

    python hero_preview.py turn OUT.png              the figure from eight sides
    python hero_preview.py run OUT.png               the run cycle in twelve frames
    python hero_preview.py CLIP OUT.png [PIXELS]     any clip in twelve frames, seen as in the game; PIXELS a metre
    python hero_preview.py poses OUT.png CLIP:KEY..  chosen keys of clips
    python hero_preview.py small OUT.png CLIP:KEY..  the same, 60 pixels high

With --insides first, facets seen from behind, which the game leaves out, are shown in loud pink.
"""

import sys
from math import radians
from pathlib import Path

sys.dont_write_bytecode = True

import bpy  # noqa: E402
from mathutils import Euler, Matrix, Quaternion, Vector  # noqa: E402

MODEL = Path(__file__).resolve().parent.parent / "models" / "hero.glb"
INSIDES = "--insides" in sys.argv
SAMPLES = 8
# Metres of a sheet's cell, and its pixels.
CELL = Vector((1.9, 2.15))
PIXELS_A_METRE = 150
# The game shows the figure turned a little towards the viewer.
THREE_QUARTERS = 25
# How far the wind of the motion lifts each bone of the cape, in degrees: the game's springs do it, this only hints at it.
WIND = {"run": 13, "walk": 5, "rise": -2, "fall": 24, "jump": 0, "roll": 12, "crawl": 8, "wall_slide": 14}


def load():
    """The scene with the model, a sun, a cool sky; the armature."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps = 30
    bpy.ops.import_scene.gltf(filepath=str(MODEL), bone_heuristic="TEMPERANCE")
    rig = next(o for o in bpy.data.objects if o.type == "ARMATURE")
    for material in bpy.data.materials:
        surface = material.node_tree.nodes["Principled BSDF"]
        colour = material.node_tree.nodes.new("ShaderNodeVertexColor")
        material.node_tree.links.new(colour.outputs["Color"], surface.inputs["Base Color"])
        if material.name == "glow":
            material.node_tree.links.new(colour.outputs["Color"], surface.inputs["Emission Color"])
            surface.inputs["Emission Strength"].default_value = 2.0
        if INSIDES:
            show_insides(material)
    light = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    light.data.energy, light.data.angle, light.data.color = 4.2, 0.05, (1.0, 0.86, 0.68)
    light.rotation_euler = Euler((radians(48), radians(8), radians(52)))
    scene.collection.objects.link(light)
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.30, 0.36, 0.52, 1)
    world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.9
    scene.world = world
    return rig


def show_insides(material):
    """Facets seen from behind in loud pink."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
    mix, pink, side = (nodes.new(f"ShaderNode{kind}") for kind in ("MixShader", "Emission", "NewGeometry"))
    pink.inputs["Color"].default_value = (1, 0, 1, 1)
    links.new(side.outputs["Backfacing"], mix.inputs[0])
    links.new(nodes["Principled BSDF"].outputs[0], mix.inputs[1])
    links.new(pink.outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], output.inputs["Surface"])


def posed(rig, clip, key):
    """A copy of the body in a pose."""
    action = bpy.data.actions[clip]
    rig.animation_data_create()
    for track in rig.animation_data.nla_tracks:
        track.mute = True
    rig.animation_data.action = action
    rig.animation_data.action_slot = action.slots[0]
    bpy.context.scene.frame_set(int(key), subframe=key - int(key))
    body = next(o for o in bpy.data.objects if o.type == "MESH" and o.name == "hero")
    for i in range(1, 6):
        bone = rig.pose.bones[f"cape.{i}"]
        # About the figure's own axis to the side, whatever axes the importer gave the bone.
        aside = bone.bone.matrix_local.to_3x3().inverted() @ Vector((0, 1, 0))
        bone.rotation_mode = "QUATERNION"
        bone.rotation_quaternion = Quaternion(aside, radians(WIND.get(clip, 0)))
    bpy.context.view_layer.update()
    seen = body.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return bpy.data.meshes.new_from_object(seen)


def sheet(rig, cells, columns, path, pixels=PIXELS_A_METRE):
    """Renders cells of (clip, key, turn about the vertical in degrees) in rows."""
    scene = bpy.context.scene
    meshes = [(posed(rig, clip, key), angle) for clip, key, angle in cells]
    rows = -(-len(cells) // columns)
    for old in [o for o in bpy.data.objects if o.type in {"MESH", "ARMATURE"}]:
        old.hide_render = True
    ground = bpy.data.materials.new("ground")
    ground.use_nodes = True
    ground.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.20, 0.18, 0.19, 1)
    for index, (mesh, angle) in enumerate(meshes):
        column, row = index % columns, index // columns
        place = Matrix.Translation((column * CELL.x, 0, -row * CELL.y))
        copy = bpy.data.objects.new("copy", mesh)
        copy.matrix_world = place @ Matrix.Rotation(radians(-angle), 4, "Z")
        scene.collection.objects.link(copy)
        bpy.ops.mesh.primitive_cube_add(size=1)
        slab = bpy.context.object
        slab.matrix_world = place @ Matrix.Translation((0, 0, -0.02)) @ Matrix.Diagonal((CELL.x * 0.94, 0.9, 0.04, 1))
        slab.data.materials.append(ground)
        clip, key, _ = cells[index]
        if clip in WALLED:
            low, high = (-0.05, 1.95) if clip not in LEDGE else (-0.05, LEDGE[clip](key))
            bpy.ops.mesh.primitive_cube_add(size=1)
            wall = bpy.context.object
            turned = place @ Matrix.Rotation(radians(-angle), 4, "Z")
            wall.matrix_world = turned @ Matrix.Translation((WALL + 0.1, 0.35, (low + high) / 2)) @ Matrix.Diagonal((0.2, 0.8, max(high - low, 0.01), 1))
            wall.data.materials.append(ground)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type = "ORTHO"
    width, height = columns * CELL.x, rows * CELL.y
    camera.data.ortho_scale = max(width, height)
    middle = Vector(((columns - 1) * CELL.x / 2, 0, CELL.y / 2 - 0.2 - (rows - 1) * CELL.y / 2))
    tilt = radians(4)
    camera.matrix_world = (
        Matrix.Translation(middle) @ Matrix.Rotation(radians(90) - tilt, 4, "X") @ Matrix.Translation((0, 0, 20))
    )
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = SAMPLES, True
    scene.cycles.max_bounces, scene.cycles.seed = 2, 1
    scene.view_settings.view_transform = "Standard"
    scene.render.threads_mode, scene.render.threads = "FIXED", 2
    scene.render.resolution_x, scene.render.resolution_y = int(width * pixels), int(height * pixels)
    scene.render.image_settings.file_format, scene.render.image_settings.compression = "PNG", 100
    scene.render.dither_intensity = 0.0
    scene.render.image_settings.color_mode = "RGB"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


def length(clip):
    """Keys of a clip."""
    return bpy.data.actions[clip].frame_range[1]


def main():
    what, path, *keys = [word for word in sys.argv[1:] if word != "--insides"]
    rig = load()
    if what == "turn":
        sheet(rig, [("idle", 0, angle) for angle in range(0, 360, 45)], 4, path, 220)
    elif what in ("poses", "small"):
        pairs = [key.split(":") for key in keys]
        pixels = PIXELS_A_METRE if what == "poses" else 60 / 1.7
        sheet(rig, [(clip, float(key), THREE_QUARTERS) for clip, key in pairs], min(6, len(pairs)), path, pixels)
    else:
        shown = 12 if length(what) >= 11 else int(length(what)) + 1
        last = length(what) * (1 - 1 / shown) if what in LOOPS else length(what)
        step = last / (shown - 1)
        pixels = int(keys[0]) if keys else PIXELS_A_METRE
        sheet(rig, [(what, i * step, THREE_QUARTERS) for i in range(shown)], 6, path, pixels)


# What he holds on to is shown: the wall before him; a ledge comes down as he climbs.
WALL = 0.406
WALLED = {"wall_slide", "ledge_hang", "ledge_climb", "climb_wall"}
LEDGE = {"ledge_hang": lambda key: 1.6, "ledge_climb": lambda key: max(0.0, 1.6 * (1 - key / (17 * 0.7)))}
LOOPS = "idle walk run rise fall crouch crawl wall_slide ledge_hang ladder climb_wall".split()

if __name__ == "__main__":
    main()
