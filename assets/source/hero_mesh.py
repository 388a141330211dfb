"""The hero's body as one skinned mesh in Blender, its facets shaded by what is near them."""

from math import cos, pi, sin, sqrt

import bpy
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from hero_armour import armour
from hero_gear import gear
from hero_rig import JOINTS, to_blender
from hero_shapes import Shape

# Facets that others stand close to are darker: looked at along so many rays, so far, at most so much.
SHADE_RAYS, SHADE_REACH, SHADE_MOST = 48, 0.22, 0.50


def figure():
    """The whole body, in figure axes."""
    shape = Shape()
    armour(shape)
    gear(shape)
    return shape


def shades(shape):
    """For each facet how much of its paint is left by the shade of what is near."""
    tree = BVHTree.FromPolygons(shape.corners, [corners for corners, _, _ in shape.facets])
    kept = []
    for corners, _, glow in shape.facets:
        points = [shape.corners[c] for c in corners]
        normal = (points[1] - points[0]).cross(points[2] - points[0]).normalized()
        middle = sum(points, Vector()) / len(points) + normal * 0.002
        met = 0.0
        for x, y, z in _HEMISPHERE:
            aside = normal.orthogonal().normalized()
            ray = aside * x + normal.cross(aside) * y + normal * z
            hit = tree.ray_cast(middle, ray, SHADE_REACH)
            if hit[0]:
                met += 1.0 - hit[3] / SHADE_REACH
        kept.append(1.0 if glow else 1.0 - SHADE_MOST * min(1.0, 1.4 * met / SHADE_RAYS))
    return kept


def _hemisphere():
    """Directions about +z, more of them near it."""
    rays = []
    for i in range(SHADE_RAYS):
        radius, angle = sqrt((i + 0.5) / SHADE_RAYS), 2 * pi * i * 0.61803398875
        rays.append((radius * cos(angle), radius * sin(angle), sqrt(1 - radius * radius)))
    return rays


_HEMISPHERE = _hemisphere()


def build_mesh(rig):
    """The mesh object "hero", skinned to the armature."""
    shape = figure()
    mesh = bpy.data.meshes.new("hero")
    mesh.from_pydata([to_blender(p) for p in shape.corners], [], [corners for corners, _, _ in shape.facets])
    colours = mesh.color_attributes.new("Color", "FLOAT_COLOR", "CORNER")
    for polygon, (_, colour, glow), kept in zip(mesh.polygons, shape.facets, shades(shape)):
        polygon.material_index = int(glow)
        for loop in polygon.loop_indices:
            colours.data[loop].color = (*(c * kept for c in colour), 1.0)
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
