"""Makes assets/sounds and assets/music anew, from anywhere: python3 assets/source/sound/build.py [sounds] [music]"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import music
import places
import signs
import steps
from synth import with_margins, write

ASSETS = Path(__file__).resolve().parents[2]


def main():
    wanted = sys.argv[1:] or ["sounds", "music"]
    if "sounds" in wanted:
        for module in (steps, places, signs):
            for name, signal in module.sounds():
                is_loop = name in [make.__name__ for make in places.LOOPS]
                write(ASSETS / "sounds" / f"{name}.ogg", with_margins(signal) if is_loop else signal)
    if "music" in wanted:
        for name, signal in music.pieces():
            write(ASSETS / "music" / f"{name}.ogg", with_margins(signal), quality=1)


if __name__ == "__main__":
    main()
