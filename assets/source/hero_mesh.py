"""The hero's body."""

import bpy

from hero_rig import JOINTS, PLACE, to_blender
from hero_shapes import Paint, Shape, limb

STEEL, DARK, CLOTH, LEATHER = Paint(0xC9D2DA), Paint(0x39424F), Paint(0x2C5F73), Paint(0x6B4630)
RED, BRASS, FLAME = Paint(0xD83A2B), Paint(0xD6A04E), Paint(0xFFD27A, glow=True)


def figure():
    shape = Shape()
    at = PLACE
    limb(shape, (0, 0.62, 0), (0, 0.86, 0), [(0, .16, .2, 0), (1, .13, .16, 0)], 8, CLOTH, "hips")
    limb(shape, (0, 0.86, 0), (0, 1.0, 0), [(0, .13, .16, 0), (1, .15, .18, 0)], 8, CLOTH, "spine")
    limb(shape, (0, 1.0, 0), (0, 1.25, 0), [(0, .15, .18, 0), (.5, .18, .22, 0), (1, .1, .12, 0)], 8, STEEL, "chest")
    limb(shape, (0, 1.25, 0), (0, 1.64, 0), [(0, .15, .14, 0), (.7, .18, .17, 0), (1, .08, .08, 0)], 8, STEEL, "head")
    limb(shape, (.1, 1.62, 0), (-.25, 1.62, 0), [(0, .02, .02, 0), (.5, .06, .03, 0), (1, .02, .02, 0)], 6, RED, "crest", (0, 1, 0))
    for s in "lr":
        for a, b, r, paint in (("upper_arm", "forearm", .06, DARK), ("forearm", "hand", .06, STEEL), ("thigh", "shin", .085, DARK), ("shin", "foot", .075, STEEL)):
            limb(shape, at[f"{a}.{s}"], at[f"{b}.{s}"], [(0, r * 1.1, r * 1.1, 0), (1, r * .8, r * .8, 0)], 6, paint, f"{a}.{s}")
        h = at[f"hand.{s}"]
        limb(shape, h, (h.x + .02, h.y - .1, h.z), [(0, .04, .035, 0), (1, .045, .04, 0)], 6, LEATHER, f"hand.{s}")
        f = at[f"foot.{s}"]
        limb(shape, (f.x - .06, .05, f.z), (f.x + .17, .04, f.z), [(0, .05, .05, 0), (1, .03, .05, 0)], 6, LEATHER, f"foot.{s}", (0, 1, 0))
    for i in range(1, 6):
        a = at[f"cape.{i}"]
        b = at[f"cape.{i + 1}"] if i < 5 else a + (a - at["cape.4"])
        limb(shape, a, b, [(0, .015, .16 + .02 * i, 0), (1, .015, .18 + .02 * i, 0)], 4, RED, f"cape.{i}")
    p = at["lantern"]
    limb(shape, p, (p.x, p.y - .25, p.z), [(0, .02, .02, 0), (.3, .06, .06, 0), (1, .05, .05, 0)], 6, FLAME, "lantern")
    p = at["sword"]
    limb(shape, (p.x + .12, p.y + .06, p.z), (p.x - .4, p.y - .25, p.z), [(0, .02, .02, 0), (1, .03, .02, 0)], 4, BRASS, "sword", (0, 1, 0))
    return shape


def build_mesh(rig):
    """The mesh object "hero", skinned to the armature."""
    shape = figure()
    mesh = bpy.data.meshes.new("hero")
    mesh.from_pydata([to_blender(p) for p in shape.corners], [], [corners for corners, _, _ in shape.facets])
    colours = mesh.color_attributes.new("Color", "FLOAT_COLOR", "CORNER")
    for polygon, (_, colour, glow) in zip(mesh.polygons, shape.facets):
        polygon.material_index = int(glow)
        for loop in polygon.loop_indices:
            colours.data[loop].color = (*colour, 1.0)
    for name in ("matte", "glow"):
        mesh.materials.append(material(name))
    hero = bpy.data.objects.new("hero", mesh)
    bpy.context.scene.collection.objects.link(hero)
    for joint in JOINTS:
        group = hero.vertex_groups.new(name=joint)
        for index, weights in enumerate(shape.weights):
            if joint in weights:
                group.add([index], weights[joint], "REPLACE")
    hero.parent = rig
    hero.modifiers.new("rig", "ARMATURE").object = rig
    return hero, shape


def material(name):
    """A material that shows the vertex colours; "glow" shines with them."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.use_backface_culling = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    surface = nodes["Principled BSDF"]
    surface.inputs["Roughness"].default_value = 0.9
    surface.inputs["Metallic"].default_value = 0.0
    colour = nodes.new("ShaderNodeVertexColor")
    colour.layer_name = "Color"
    links.new(colour.outputs["Color"], surface.inputs["Base Color"])
    if name == "glow":
        links.new(colour.outputs["Color"], surface.inputs["Emission Color"])
        surface.inputs["Emission Strength"].default_value = 1.0
    return made
