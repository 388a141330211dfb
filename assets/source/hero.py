"""Makes assets/models/hero.glb: python hero.py, with Blender as a Python module (see README.md here)."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from hero_clips import CLIPS, EXTRAS  # noqa: E402
from hero_export import clear, key_clip, write  # noqa: E402
from hero_mesh import build_mesh  # noqa: E402
from hero_rig import build_armature  # noqa: E402

TARGET = HERE.parent / "models" / "hero.glb"


def main():
    clear()
    rig = build_armature()
    _, shape = build_mesh(rig)
    for name, value in EXTRAS.items():
        rig[name] = value
    clips = CLIPS()
    for clip in clips:
        key_clip(rig, clip)
    TARGET.parent.mkdir(exist_ok=True)
    write(rig, TARGET)
    print(f"{TARGET.name}: {shape.triangles()} triangles, {len(clips)} clips, {TARGET.stat().st_size} bytes")


if __name__ == "__main__":
    main()
