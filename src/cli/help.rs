//! What `--help` prints.

/// The text of `--help`.
pub const HELP: &str = "\
Edgewalker: a side-scroller whose movement runs, exactly, on a mesh.

Usage: edgewalker [options]

What to play
  --level FILE        Level to play (default: levels/quarry.ron)
  --tuning FILE       Tuning to play with (default: tuning.local.ron, if there is one)
  --tick-rate N       Ticks per second, 10 to 2000 (default: 120)
  --seed N            Seed of the game's random numbers (default: 0)

Runs as values
  --record FILE       Write the inputs of this run to FILE as they come
  --replay FILE       Play a recorded run; it brings its level, tuning, tick rate and seed
  --headless          With --replay: no window, print the final state's hash and a summary
  --screenshot FILE   Write one picture as PNG and leave; needs --at
  --at TICK           The tick of the picture, or before the film: of the replay, or of a run without input
  --soundtrack FILE   With --replay: no window, write what is heard of the run as WAV
  --sound FILE        With --soundtrack, in place of --replay: one file of sound or music as the game decodes it
  --film FILE         Write 60 pictures a second into FILE, as PPM one after the other, and leave; needs --seconds. FILE may
                      be a pipe (scripts/video)
  --seconds N         How long the film is
  --bench-frames N    Draw N frames (of a replay: spread over it), say how long they took, and leave; of all presets,
                      or of the one that --preset names

For level makers
  --check LEVEL       Check all meshes of a level and walk about in it at random, no window; --seed, --tuning and
                      --tick-rate hold, and --record names the replay of a fault (default: check.replay.ron)
  --ticks N           How long to walk (default: 100000)

Window
  --size WxH          Size in points (default: 1280x720)
  --fullscreen        Start in fullscreen
  --no-vsync          Do not wait for the display
  --preset NAME       How much the picture may cost: low, medium or high (default: medium)
  --config-dir DIR    Where settings and progress are kept (default: the user's folder for that)
  --screen NAME       Start with a menu open: title, pause, settings, video, audio, controls, accessibility, credits...
  --device NAME       Prompts as for keys, or for a pad with letters, shapes or signs, until a device is used
  --overlay           Start with the overlay open
  --mesh              Start with the motion mesh drawn
  --mute              No sound

  --help, --version

Without --level, --replay, --record or --screenshot the game starts at its title. What is said here for the window holds
for this run and is not saved.

Keys, which the settings can change
  Left/Right, A/D     Run                      F1         Overlay: tunables, drawings, graphs
  Space, Z            Jump                     P  .       Stop time, single step
  Down, S             Crouch, fast fall        [  ]       Slower, faster
  Up, W               Climb, look up           F11, Alt+Enter  Fullscreen
  C, Ctrl             Crouch                   R          Back to the last checkpoint
  Esc                 Pause; menus: arrows, Enter, Esc, or the mouse
Game controllers: stick or D-pad, A jump, B crouch, Back to the last checkpoint, Start pause, right stick looks.

Exit status: 0 left by the player or nothing wrong, 1 something failed or is wrong, 2 the options make no sense.
";
