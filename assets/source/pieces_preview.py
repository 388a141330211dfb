"""Pictures of the set pieces, to judge them by: a sheet for each family, or one of the pieces that are named.

    python assets/source/pieces_preview.py FOLDER [--family stone] [PIECE ...] [--samples 16] [--width 1200]
"""

import argparse
import math
import pathlib
import sys

import bpy
from mathutils import Vector

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import pieces  # noqa: E402

GAP = 0.5  # between pieces, in metres
SHARE = 1.9  # width of a sheet by its height
HERO = (0.5, 1.7)  # width and height of the grey stand-in for the hero, at the left of each sheet


def extent(thing):
    corners = [Vector(c) for c in thing.bound_box]
    return [min(c[i] for c in corners) for i in range(3)], [max(c[i] for c in corners) for i in range(3)]


def stand_in():
    """As tall as the hero, to see sizes by."""
    bpy.ops.mesh.primitive_cube_add(size=1)
    cube = bpy.context.object
    cube.scale = (HERO[0], 0.3, HERO[1])
    cube.location = (0, 0, HERO[1] / 2)
    bpy.ops.object.transform_apply(location=True, scale=True)
    return cube


def lay_out(things):
    """In rows, from left to right, as large as they get; returns the width of all and their height."""
    sizes = [extent(thing) for thing in things]
    widths = [high[0] - low[0] + GAP for low, high in sizes]
    heights = [high[2] - low[2] + GAP for low, high in sizes]

    def rows(limit):
        x = y = row = widest = 0.0
        places = []
        for w, h in zip(widths, heights):
            if x + w > limit + 1e-6:
                x, y, row = 0.0, y - row, 0.0
            places.append((x, y))
            x, row, widest = x + w, max(row, h), max(widest, x + w)
        return places, widest, row - y

    limits = [max(widths) * 1.1**i for i in range(30)]
    places, wide, tall = min((rows(limit) for limit in limits), key=lambda r: max(r[1], r[2] * SHARE))
    for thing, (low, high), (x, y) in zip(things, sizes, places):
        thing.location = (x - low[0] + GAP / 2, 0, y - high[2] - GAP / 2)
    return wide, tall


def light_up():
    scene = bpy.context.scene
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.color, sun.data.angle = 3.2, (1, 0.78, 0.56), 0.03
    sun.rotation_euler = (math.radians(48), math.radians(-34), 0)
    scene.collection.objects.link(sun)
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.16, 0.22, 0.33, 1)
    world.node_tree.nodes["Background"].inputs[1].default_value = 1.1
    scene.world = world


def shoot(path, things, width, samples, turn):
    scene = bpy.context.scene
    wide, tall = lay_out(things)
    for thing in things:
        thing.rotation_euler = (0, 0, math.radians(turn))
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", max(wide, tall * SHARE)
    camera.location, camera.rotation_euler = (wide / 2, -80, -tall / 2 + 14), (math.radians(80), 0, 0)
    camera.data.clip_end = 300
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", samples, False
    scene.cycles.max_bounces = 2
    scene.render.threads_mode, scene.render.threads = "FIXED", 1
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y = width, int(width / SHARE)
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--family", action="append", default=[])
    parser.add_argument("--samples", type=int, default=12)
    parser.add_argument("--width", type=int, default=1200)
    parser.add_argument("--turn", type=float, default=0)
    arguments = parser.parse_args()
    families = {f.__name__.removeprefix("pieces_"): [m.__name__ for m in f.PIECES] for f in pieces.FAMILIES}
    sheets = {name: families[name] for name in (arguments.family or ([] if arguments.names else families))}
    if arguments.names:
        sheets["some"] = arguments.names
    for sheet, names in sheets.items():
        built = pieces.build(names)
        for name, (_, triangles) in built.items():
            print(f"{name:24}{triangles:5}")
        light_up()
        shoot(arguments.folder / f"{sheet}.png", [stand_in(), *(thing for thing, _ in built.values())], arguments.width, arguments.samples, arguments.turn)


if __name__ == "__main__":
    main()
