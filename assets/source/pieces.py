"""Builds assets/models/pieces.glb, the set pieces of the game.

    python assets/source/pieces.py            with Blender as a Python module (see README.md here)
    python assets/source/pieces.py --check    only tells whether the file is what these scripts make

Each piece is a function in a file of its family (pieces_stone.py and so on); what they have in common is in pieces_kit.py.
`pieces_preview.py` makes pictures of them.
"""

import pathlib
import sys

import bpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import glb  # noqa: E402
import pieces_cloth  # noqa: E402
import pieces_distance  # noqa: E402
import pieces_lamps  # noqa: E402
import pieces_left  # noqa: E402
import pieces_machines  # noqa: E402
import pieces_marks  # noqa: E402
import pieces_plants  # noqa: E402
import pieces_stone  # noqa: E402
from pieces_kit import bake  # noqa: E402

FAMILIES = [
    pieces_stone, pieces_lamps, pieces_cloth, pieces_machines, pieces_plants, pieces_left, pieces_distance, pieces_marks,
]  # fmt: skip
TARGET = HERE.parent / "models" / "pieces.glb"
FEWEST, MOST = 20, 600  # triangles of a piece


def materials():
    """What shines by itself, and what does not; both take their colour from the corners."""
    made = {}
    for name in ("matte", "glow"):
        material = bpy.data.materials.new(name)
        material.use_nodes = True
        nodes, links = material.node_tree.nodes, material.node_tree.links
        shader = nodes["Principled BSDF"]
        shader.inputs["Roughness"].default_value = 1.0
        shader.inputs["Specular IOR Level"].default_value = 0.0
        colour = nodes.new("ShaderNodeVertexColor")
        colour.layer_name = "colour"
        links.new(colour.outputs["Color"], shader.inputs["Base Color"])
        if name == "glow":
            links.new(colour.outputs["Color"], shader.inputs["Emission Color"])
            shader.inputs["Emission Strength"].default_value = 1.5
        material.use_backface_culling = True
        made[name] = material
    return made


def to_blender(p):
    """The game's y is up; Blender's z is."""
    return (p[0], -p[2], p[1])


def add(piece, made):
    """The piece as an object, with its lamps as children."""
    facets = bake(piece)
    mesh = bpy.data.meshes.new(piece.name)
    corners = [to_blender(p) for place, _, _ in facets for p in place]
    mesh.from_pydata(corners, [], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(facets))])
    mesh.materials.append(made["matte"])
    if any(glows for _, _, glows in facets):
        mesh.materials.append(made["glow"])
    mesh.color_attributes.new("colour", "FLOAT_COLOR", "POINT")
    mesh.attributes.new("_openness", "FLOAT", "POINT")
    # Only now: to add an attribute moves those that were there before.
    colours, openness = mesh.color_attributes["colour"].data, mesh.attributes["_openness"].data
    for i, (_, shades, glows) in enumerate(facets):
        mesh.polygons[i].material_index = int(glows)
        for k in range(3):
            colours[3 * i + k].color = [*(float(c) for c in shades[k][:3]), 1.0]
            openness[3 * i + k].value = float(shades[k][3])
    thing = bpy.data.objects.new(piece.name, mesh)
    thing["sway"] = float(piece.sway)
    bpy.context.collection.objects.link(thing)
    for at, reach, colour in piece.lights:
        lamp = bpy.data.objects.new("light", None)
        lamp.parent, lamp.location = thing, to_blender(at)
        lamp["reach"], lamp["colour"] = float(reach), [float(c) for c in colour]
        bpy.context.collection.objects.link(lamp)
    return thing, len(facets)


def build(wanted=None):
    """All pieces in an empty scene; `wanted` leaves out others. Returns them by name with their triangles."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    made, built = materials(), {}
    for family in FAMILIES:
        for make in family.PIECES:
            if wanted and make.__name__ not in wanted:
                continue
            piece = make()
            built[piece.name] = add(piece, made)
    return built


def export(path):
    bpy.ops.export_scene.gltf(
        filepath=str(path),
        export_format="GLB",
        export_yup=True,
        export_extras=True,
        export_normals=False,
        export_texcoords=False,
        export_animations=False,
        export_skins=False,
        export_vertex_color="ACTIVE",
        export_attributes=True,
    )


def make(target):
    """Writes all pieces, and tells how many triangles each has."""
    built = build()
    for name, (_, triangles) in built.items():
        note = "" if FEWEST <= triangles <= MOST else "  <-- not within bounds"
        print(f"{name:24}{triangles:5}{note}")
    print(f"{len(built)} pieces, {sum(triangles for _, triangles in built.values())} triangles")
    target.parent.mkdir(exist_ok=True)
    export(target)
    print(f"{target.name}: {target.stat().st_size} bytes")


def main():
    if sys.argv[1:] == ["--check"]:
        sys.exit(glb.check(make, TARGET))
    make(TARGET)


if __name__ == "__main__":
    main()
