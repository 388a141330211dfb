"""What a .glb says, so that two can be compared where they are not the same bytes: each version of Blender writes its own name into
the file, and some write colours as floats and others as integers."""

import json
import struct
from pathlib import Path

import numpy as np

KINDS = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
NEAR = 2e-5  # a colour of 16 bits is off by 7.7e-6, a float by less


class Glb:
    """A file as nodes, meshes and clips by name, with numbers as floats."""

    def __init__(self, path):
        data = Path(path).read_bytes()
        size = struct.unpack("<I", data[12:16])[0]
        self.json, self.bytes = json.loads(data[20 : 20 + size]), data[28 + size :]

    def accessor(self, index):
        """A table of numbers; one without a view holds zeros."""
        what = self.json["accessors"][index]
        kind, width = np.dtype(KINDS[what["componentType"]]), WIDTHS[what["type"]]
        if "bufferView" not in what:
            return np.zeros((what["count"], width))
        view = self.json["bufferViews"][what["bufferView"]]
        start = view.get("byteOffset", 0) + what.get("byteOffset", 0)
        stride = view.get("byteStride", kind.itemsize * width)
        rows = [np.frombuffer(self.bytes, kind, width, start + i * stride) for i in range(what["count"])]
        table = np.array(rows, dtype=float).reshape(what["count"], width)
        return table / np.iinfo(kind).max if what.get("normalized") else table

    def tables(self):
        """Every table by what it is of: a primitive's attribute, its corners, a clip's times and values, the rest pose of a skin."""
        found = {}
        for mesh in self.json["meshes"]:
            for i, part in enumerate(mesh["primitives"]):
                place = f"mesh {mesh['name']}, part {i}"
                for name, index in part["attributes"].items():
                    table = self.accessor(index)
                    if name == "COLOR_0":
                        table = table[:, :3]  # its opacity means nothing here
                    elif name == "JOINTS_0":
                        table = self.ranks()[table.astype(int)]  # a skin may list its joints in any order
                    found[f"{place}, {name}"] = table
                found[f"{place}, corners"] = self.accessor(part["indices"])
        for clip in self.json.get("animations", []):
            for channel in clip["channels"]:
                sampler = clip["samplers"][channel["sampler"]]
                node = self.json["nodes"][channel["target"]["node"]]["name"]
                place = f"clip {clip['name']}, {node}, {channel['target']['path']}"
                found[f"{place}, times"] = self.accessor(sampler["input"])
                found[f"{place}, values"] = self.accessor(sampler["output"])
        for skin in self.json.get("skins", []):
            for joint, matrix in zip(skin["joints"], self.accessor(skin["inverseBindMatrices"])):
                found[f"joint {self.json['nodes'][joint]['name']} at rest"] = matrix
        return found

    def ranks(self):
        """Of each joint of the skin, its place in the order of their names."""
        names = [self.json["nodes"][joint]["name"] for joint in self.json["skins"][0]["joints"]]
        return np.array([sorted(names).index(name) for name in names])

    def nodes(self):
        """Where each node is and what is said of it; lamps have one name in Blender, and numbers behind it here."""
        nodes = self.json["nodes"]
        names = {child: node["name"] for node in nodes for child in node.get("children", [])}
        numbers = ("translation", "rotation", "scale", "extras")
        return {
            (names.get(i, ""), node["name"]): flat([node.get(key) for key in numbers]) for i, node in enumerate(nodes)
        }


def flat(value):
    """Numbers and words of nested lists and tables, in order."""
    if isinstance(value, dict):
        return [word for key in sorted(value) for word in [key, *flat(value[key])]]
    if isinstance(value, list):
        return [word for part in value for word in flat(part)]
    return [value]


def alike(a, b):
    """Whether two lists of numbers and words say the same."""
    def one(x, y):
        numbers = isinstance(x, (int, float)) and isinstance(y, (int, float))
        return abs(x - y) <= NEAR if numbers else x == y

    return len(a) == len(b) and all(one(x, y) for x, y in zip(a, b))


def differences(path, other):
    """In what two files differ, as lines of text; none if they say the same."""
    a, b = Glb(path), Glb(other)
    found = []
    for kind in ("nodes", "tables"):
        here, there = getattr(a, kind)(), getattr(b, kind)()
        found += [f"{name}: in one only" for name in sorted(here.keys() ^ there.keys(), key=str)]
        for name in here.keys() & there.keys():
            if kind == "nodes":
                same = alike(here[name], there[name])
            else:
                x, y = here[name], there[name]
                same = x.shape == y.shape and bool(np.all(np.abs(x - y) <= NEAR))
            if not same:
                found.append(f"{name}: differs")
    return sorted(found)


def check(build, target):
    """Builds a file anew beside the one that is kept and tells whether they are the same; the exit status."""
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / target.name
        build(made)
        if made.read_bytes() == target.read_bytes():
            print("the same bytes")
            return 0
        found = differences(made, target)
    for line in found[:20]:
        print(line)
    print(f"{target} is NOT what these scripts make: {len(found)} differences" if found else "the same content")
    return 1 if found else 0
