#!/usr/bin/env bash
# Guess: Blender's glTF exporter lists the joints of a skin in the order of the armature's bones, in every version.
# Seen (bpy 4.5.15, bpy 5.3.0): 4.5.15 does. 5.3.0 lists the children of a bone by name, so the same scene gives another
# order of `skins[0].joints`, and with it other numbers in JOINTS_0 and in the inverse bind matrices.
# It matters to who compares two exports number by number, or refers to joints by index: names are what stays.
# Needs python3.11 and python3.13: Blender as a module is built for one Python each.
set -euo pipefail

folder="$(mktemp -d)"
trap 'rm -r "$folder"' EXIT

cat >"$folder/scene.py" <<'PY'
import json
import struct
import sys

import bpy

bpy.ops.wm.read_factory_settings(use_empty=True)
data = bpy.data.armatures.new("rig")
rig = bpy.data.objects.new("rig", data)
bpy.context.scene.collection.objects.link(rig)
bpy.context.view_layer.objects.active = rig
bpy.ops.object.mode_set(mode="EDIT")
base = data.edit_bones.new("base")
base.head, base.tail = (0, 0, 0), (0, 0, 1)
for i, name in enumerate(("neck", "tail", "arm")):
    bone = data.edit_bones.new(name)
    bone.head, bone.tail, bone.parent = (i, 0, 1), (i, 0, 2), base
bpy.ops.object.mode_set(mode="OBJECT")
mesh = bpy.data.meshes.new("skin")
mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
skin = bpy.data.objects.new("skin", mesh)
bpy.context.scene.collection.objects.link(skin)
for name in ("base", "neck", "tail", "arm"):
    skin.vertex_groups.new(name=name).add([0, 1, 2], 0.25, "REPLACE")
skin.parent = rig
skin.modifiers.new("rig", "ARMATURE").object = rig
bpy.ops.export_scene.gltf(filepath=sys.argv[1], export_format="GLB")
raw = open(sys.argv[1], "rb").read()
document = json.loads(raw[20 : 20 + struct.unpack("<I", raw[12:16])[0]])
print("joints:", *(document["nodes"][i]["name"] for i in document["skins"][0]["joints"]))
PY

# joints PYTHON VERSION: what that version of Blender lists.
joints() {
    "$1" -m venv "$folder/$2"
    "$folder/$2/bin/pip" install --quiet "bpy==$2"
    "$folder/$2/bin/python" "$folder/scene.py" "$folder/$2.glb" 2>/dev/null | sed -n 's/^joints: //p'
}

old="$(joints python3.11 4.5.15)"
new="$(joints python3.13 5.3.0)"
printf 'bpy 4.5.15: %s\nbpy 5.3.0:  %s\n' "$old" "$new"
[[ "$old" == "base neck tail arm" && "$new" == "base arm neck tail" ]]
