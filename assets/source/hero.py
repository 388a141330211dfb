"""Makes assets/models/hero.glb: python hero.py, with Blender as a Python module (see README.md here). With --check it only tells
whether the file is what these scripts make, byte for byte or at least number for number."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

import glb  # noqa: E402
import hero_air  # noqa: E402
import hero_gaits  # noqa: E402
import hero_walls  # noqa: E402
from hero_clip import KEYS_A_SECOND  # noqa: E402
from hero_export import clear, key_clip, write  # noqa: E402
from hero_mesh import build_mesh  # noqa: E402
from hero_rig import build_armature  # noqa: E402

# Metres that a cycle of a loop covers; where the ledge is that he hangs from, and when he is up on it (seconds).
EXTRAS = {
    "stride_walk": hero_gaits.WALK.stride,
    "stride_run": hero_gaits.RUN.stride,
    "stride_crawl": hero_gaits.CRAWL.stride,
    "rise_ladder": hero_walls.LADDER.rise,
    "rise_climb_wall": hero_walls.WALL_CLIMB.rise,
    "ledge_corner": list(hero_walls.CORNER),
    "ledge_climb_risen": hero_walls.LEDGE_CLIMB * hero_walls.LEDGE_RISE / KEYS_A_SECOND,
}
TARGET = HERE.parent / "models" / "hero.glb"


def build(target):
    """Writes the model."""
    clear()
    rig = build_armature()
    _, shape = build_mesh(rig)
    for name, value in EXTRAS.items():
        rig[name] = value
    clips = hero_gaits.clips() + hero_air.clips() + hero_walls.clips()
    for clip in clips:
        missed, key = clip.worst_miss()
        if missed > clip.missed:
            print(f"{clip.name}: at key {key} a hand or foot stays {missed:.3f} m from its goal")
        key_clip(rig, clip)
    target.parent.mkdir(exist_ok=True)
    write(rig, target)
    print(f"{target.name}: {shape.triangles()} triangles, {len(clips)} clips, {target.stat().st_size} bytes")


def main():
    if sys.argv[1:] == ["--check"]:
        sys.exit(glb.check(build, TARGET))
    build(TARGET)


if __name__ == "__main__":
    main()
