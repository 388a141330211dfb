//! The program from outside: exit status and message for everything that can be wrong with what it is given.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

const PROGRAM: &str = env!("CARGO_BIN_EXE_edgewalker");

/// A folder of its own for one test, gone at its end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let path =
            std::env::temp_dir().join(format!("edgewalker-cli-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    fn write(&self, name: &str, text: &str) -> String {
        let path = self.0.join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn program(args: &[&str]) -> Command {
    let mut command = Command::new(PROGRAM);
    command.args(args).current_dir(env!("CARGO_MANIFEST_DIR"));
    command
        .env("SDL_VIDEODRIVER", "offscreen")
        .env("SDL_AUDIODRIVER", "dummy");
    command
}

/// Runs it and expects this exit status, and all these words in the message; no panic, whatever happens.
fn expect(mut command: Command, status: i32, words: &[&str]) -> String {
    let Output {
        status: found,
        stdout,
        stderr,
    } = command.output().unwrap();
    let message = String::from_utf8_lossy(&stderr).into_owned();
    assert_eq!(found.code(), Some(status), "{command:?}: {message}");
    assert!(!message.contains("panicked"), "{command:?}: {message}");
    for word in words {
        assert!(
            message.contains(word),
            "{command:?}: no `{word}` in: {message}"
        );
    }
    String::from_utf8_lossy(&stdout).into_owned()
}

/// A level file, with its features put in.
fn level(features: &str) -> String {
    format!(
        "Level(\n  version: 1,\n  name: \"Broken\",\n  start: (0.0, 0.0),\n  \
         goal: (min: (5.0, 0.0), max: (6.0, 2.0)),\n  bottom: -10.0,\n  features: [\n{features}\n  ],\n)\n"
    )
}

fn block(corners: &str) -> String {
    level(&format!(
        "    (id: \"block\", material: Rock, outline: [{corners}]),"
    ))
}

/// What can be wrong with a level, and what the message must name.
fn broken_levels() -> Vec<(&'static str, String, Vec<&'static str>)> {
    let square = "(-9.0, -1.0), (9.0, -1.0), (9.0, 0.0), (-9.0, 0.0)";
    let good = block(square);
    vec![
        ("empty", String::new(), vec!["empty.ron"]),
        (
            "truncated",
            good[..good.len() / 2].to_owned(),
            vec!["truncated.ron"],
        ),
        (
            "nan",
            block(&square.replace("9.0, 0.0", "9.0, NaN")),
            vec!["nan.ron", ":8", "block", "outline"],
        ),
        (
            "huge",
            block(&square.replace("(9.0, 0.0)", "(1e300, 0.0)")),
            vec!["huge.ron", ":8", "block", "outline"],
        ),
        (
            "crossing",
            block("(-9.0, -1.0), (9.0, 0.0), (9.0, -1.0), (-9.0, 0.0)"),
            vec!["crossing.ron", ":8", "block", "outline"],
        ),
        (
            "unknown",
            good.replace("bottom:", "bottum:"),
            vec!["unknown.ron", ":6", "bottum"],
        ),
        (
            "twice",
            level(&format!("    (id: \"a\", material: Rock, outline: [{square}]),\n").repeat(2)),
            vec!["twice.ron", ":9", "a"],
        ),
    ]
}

#[test]
fn broken_levels_are_refused_by_file_line_and_field() {
    let folder = Folder::new("levels");
    for (name, text, words) in broken_levels() {
        let path = folder.write(&format!("{name}.ron"), &text);
        let replay = format!(
            "(version: 1, level: \"{path}\", fingerprint: \"0\", tick_rate: 120, seed: 0, tuning: (), inputs: [])"
        );
        let replay = folder.write(&format!("{name}.replay"), &replay);
        expect(program(&["--headless", "--replay", &replay]), 1, &words);
        if cfg!(feature = "shell") {
            expect(program(&["--level", &path]), 1, &words);
        }
    }
}

#[test]
fn nonsense_on_the_command_line_is_refused_with_status_2() {
    for (args, word) in [
        (&["--no-such-option"][..], "unknown option --no-such-option"),
        (&["--seed", "1", "--seed", "1"], "--seed is given twice"),
        (&["--headless"], "--headless needs --replay"),
        (
            &["--headless", "--replay", "x", "--size", "640x480"],
            "contradict",
        ),
        (&["--replay", "x", "--record", "y"], "contradict"),
        (
            &["--tick-rate", "1e300"],
            "--tick-rate: `1e300` is not a whole number",
        ),
        (&["--size", "axb"], "--size: `axb` is not WIDTHxHEIGHT"),
        (&["quarry.ron"], "unexpected argument `quarry.ron`"),
    ] {
        expect(program(args), 2, &[word, "--help"]);
    }
}

/// Where even the message cannot be written, the status says what happened.
#[cfg(target_os = "linux")]
#[test]
fn a_full_terminal_is_no_panic() {
    for (args, status) in [
        (&["--nonsense"][..], 2),
        (&["--headless", "--replay", "none"], 1),
        (&["--version"], 1),
    ] {
        let full = || fs::File::options().write(true).open("/dev/full").unwrap();
        let found = program(args).stdout(full()).stderr(full()).status();
        assert_eq!(found.unwrap().code(), Some(status), "{args:?}");
    }
}

#[test]
fn help_and_version_go_to_the_output() {
    assert!(expect(program(&["--help"]), 0, &[]).contains("--tick-rate N"));
    let version = expect(program(&["--version"]), 0, &[]);
    assert_eq!(
        version.trim(),
        concat!("edgewalker ", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn broken_replays_are_refused() {
    let folder = Folder::new("replays");
    let replay = |version: u32, rate: &str, tuning: &str| {
        format!(
            "(version: {version}, level: \"levels/dev/flat.ron\", fingerprint: \"0\", tick_rate: {rate}, seed: 0, \
             tuning: ({tuning}), inputs: [])"
        )
    };
    for (name, text, word) in [
        ("empty", String::new(), "empty.replay"),
        ("newer", replay(99, "120", ""), "`version`: 99"),
        (
            "line",
            replay(1, "120", "\nmotion: (apex_gravity: 0.5,\ngravity: -1.0)"),
            "line 3: tuning, field `gravity`",
        ),
        (
            "lasts",
            replay(1, "120", "").replace("inputs: []", "\ninputs: [(0, (run: 0))]"),
            "line 2: field `inputs`",
        ),
        ("rate", replay(1, "0", ""), "tick_rate"),
        ("nan", replay(1, "120", "motion: (gravity: NaN)"), "gravity"),
        (
            "unknown",
            replay(1, "120", "motion: (levity: 1.0)"),
            "levity",
        ),
        ("other", replay(1, "120", ""), "fingerprint"),
    ] {
        let path = folder.write(&format!("{name}.replay"), &text);
        expect(
            program(&["--headless", "--replay", &path]),
            1,
            &[word, &format!("{name}.replay")],
        );
    }
    expect(
        program(&["--headless", "--replay", "no/such/file"]),
        1,
        &["no/such/file: not found"],
    );
    let directory = folder.0.to_str().unwrap();
    expect(
        program(&["--headless", "--replay", directory]),
        1,
        &["is a directory, not a file"],
    );
}

#[cfg(not(feature = "shell"))]
#[test]
fn a_build_without_a_window_says_so() {
    expect(
        program(&[]),
        1,
        &["this build has no window", "--headless --replay"],
    );
}

#[cfg(feature = "shell")]
mod window {
    use super::*;

    const FLAT: &[&str] = &["--level", "levels/dev/flat.ron"];

    #[test]
    fn a_file_that_is_missing_or_a_directory_is_named() {
        let folder = Folder::new("missing");
        let directory = folder.0.to_str().unwrap();
        expect(program(&["--level", "no/such.ron"]), 1, &["no/such.ron"]);
        expect(
            program(&["--level", directory]),
            1,
            &[directory, "directory"],
        );
        expect(
            program(&["--tuning", "no/such.ron"]),
            1,
            &["no/such.ron: not found"],
        );
        expect(
            program(&["--tuning", directory]),
            1,
            &["is a directory, not a file"],
        );
        expect(
            program(&["--record", "no/such/folder/run"]),
            1,
            &["no/such/folder/run: cannot be written"],
        );
        expect(
            program(&["--screenshot", directory, "--at", "0"]),
            1,
            &["is a directory, not a file"],
        );
    }

    #[test]
    fn a_broken_tuning_file_is_refused_by_line_and_field() {
        let folder = Folder::new("tuning");
        for (name, text, words) in [
            ("empty.ron", "", ["line 1", "empty"]),
            (
                "huge.ron",
                "(\n motion: (\n  gravity: 1e300,\n ),\n)",
                ["line 3", "gravity"],
            ),
            (
                "nan.ron",
                "(\n motion: (\n  gravity: NaN,\n ),\n)",
                ["line 3", "gravity"],
            ),
            (
                "unknown.ron",
                "(\n motion: (\n  levity: 1.0,\n ),\n)",
                ["line 3", "levity"],
            ),
            ("cut.ron", "(\n motion: (\n  grav", ["line 3", "cut.ron"]),
        ] {
            let path = folder.write(name, text);
            let mut words = words.to_vec();
            words.push(name);
            expect(program(&["--tuning", &path]), 1, &words);
        }
    }

    /// The first place where assets are looked for is the current directory.
    #[test]
    fn a_missing_or_broken_asset_is_named() {
        let folder = Folder::new("assets");
        let run_there = || {
            let mut command = program(FLAT);
            command
                .args(["--screenshot", "a.png", "--at", "0"])
                .current_dir(&folder.0);
            command
        };
        fs::create_dir_all(folder.0.join("shaders")).unwrap();
        expect(run_there(), 1, &["shaders"]);
        fs::remove_dir(folder.0.join("shaders")).unwrap();
        fs::create_dir_all(folder.0.join("assets/fonts")).unwrap();
        folder.write("assets/fonts/DejaVuSans.ttf", "no font");
        expect(
            run_there(),
            1,
            &["assets/fonts/DejaVuSans.ttf: is not a TrueType font"],
        );
        assert!(!folder.0.join("a.png").exists());
    }

    #[test]
    fn without_a_display_there_is_a_message_and_no_game() {
        for driver in [Some("x11"), Some("no-such-driver"), None] {
            let mut command = program(FLAT);
            command
                .env_remove("DISPLAY")
                .env_remove("WAYLAND_DISPLAY")
                .env_remove("SDL_VIDEODRIVER");
            if let Some(driver) = driver {
                command.env("SDL_VIDEODRIVER", driver);
            }
            expect(command, 1, &["display", "DISPLAY is not set", OFFSCREEN]);
        }
        let mut command = program(FLAT);
        command
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("SDL_VIDEODRIVER")
            .env("DISPLAY", ":7777");
        expect(command, 1, &["display", "DISPLAY is `:7777`", OFFSCREEN]);
    }

    const OFFSCREEN: &str = "SDL_VIDEODRIVER=offscreen plays unseen";

    #[test]
    fn without_opengl_3_3_there_is_a_message_and_no_game() {
        let mut command = program(FLAT);
        command.env("MESA_GL_VERSION_OVERRIDE", "2.1");
        expect(command, 1, &["OpenGL 3.3", "LIBGL_ALWAYS_SOFTWARE=1"]);
    }

    /// Without sound the game goes on, and says so where it was started.
    #[test]
    fn without_sound_there_is_a_message_and_a_game() {
        let measured = ["--bench-frames", "2", "--size", "64x64", "--preset", "low"];
        let run = |driver: &str| {
            let mut command = program(FLAT);
            command.args(measured).env("SDL_AUDIODRIVER", driver);
            command.output().unwrap()
        };
        let said = |driver: &str| {
            let Output { status, stderr, .. } = run(driver);
            let text = String::from_utf8(stderr).unwrap();
            assert!(status.success(), "{text}");
            text
        };
        assert_eq!(said("dummy"), "");
        let deaf = said("no-such-driver");
        assert!(
            deaf.starts_with("edgewalker: No sound: ") && deaf.lines().count() == 1,
            "{deaf}"
        );
        assert!(deaf.ends_with("the game goes on without it\n"), "{deaf}");
    }

    #[test]
    fn a_screenshot_has_the_size_that_was_asked_for() {
        let folder = Folder::new("shot");
        let path = folder.0.join("shot.png");
        let mut command = program(FLAT);
        command
            .args(["--size", "320x200", "--at", "30", "--screenshot"])
            .arg(&path);
        expect(command, 0, &[]);
        let mut reader = png::Decoder::new(std::io::BufReader::new(fs::File::open(&path).unwrap()))
            .read_info()
            .unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(reader.info().size(), (320, 200));
        assert!(
            pixels.chunks(3).any(|pixel| pixel != &pixels[..3]),
            "one colour"
        );
    }
}

#[test]
fn a_good_level_passes_the_check() {
    let mut command = program(&[
        "--check",
        "levels/dev/crossing.ron",
        "--ticks",
        "3000",
        "--seed",
        "3",
    ]);
    let out = String::from_utf8(command.output().unwrap().stdout).unwrap();
    for words in [
        "level     levels/dev/crossing.ron: The Crossing",
        "meshes    3 built and checked",
        "walks     1, together 3000 ticks at 120 Hz, seed 3",
        "found     nothing wrong",
    ] {
        assert!(out.contains(words), "{out}");
    }
    expect(command, 0, &[]);
}

#[test]
fn a_bad_level_fails_the_check_and_the_place_is_named() {
    let folder = Folder::new("check");
    let floor = "(id: \"floor\", outline: [(-9, -1), (9, -1), (9, 0), (-9, 0)]),";
    let inside = folder.write(
        "inside.ron",
        &level(&floor.replace("(9, 0), (-9, 0)", "(9, 1), (-9, 1)")),
    );
    let words = ["inside.ron:4", "start", "stand inside feature \"floor\""];
    expect(program(&["--check", &inside]), 1, &words);
    let far = "(id: \"far\", kind: Hazard, outline: [(20, 0), (4001, 0), (4001, 1)]),";
    let far = folder.write("far.ron", &level(&format!("{floor}\n{far}")));
    let words = [
        "far.ron:9",
        "feature \"far\"",
        "outline[1].x: 4001 is out of bounds",
    ];
    expect(program(&["--check", &far]), 1, &words);
    let idle = "(id: \"idle\", kind: Trigger, outline: [(2, 0), (3, 0), (3, 1)]),
                (id: \"buried\", kind: Checkpoint, respawn: Some((3, 0)), by: Some(Foot),
                 outline: [(-3, -0.9), (-1, -0.9), (-1, -0.5)]),";
    let idle = folder.write("idle.ron", &level(&format!("{floor}\n{idle}")));
    let mut command = program(&["--check", &idle, "--ticks", "500"]);
    let out = String::from_utf8(command.output().unwrap().stdout).unwrap();
    assert!(
        out.contains("wrong     feature \"idle\": nothing waits for this trigger"),
        "{out}"
    );
    assert!(
        out.contains("wrong     feature \"buried\": the standing hero can never be in it"),
        "{out}"
    );
    assert!(
        out.contains("walks     2, ") && out.ends_with("found     2 wrong\n"),
        "{out}"
    );
    expect(command, 1, &["idle.ron: not as it should be"]);
}

#[test]
fn what_moves_over_a_place_of_return_is_told_by_the_check() {
    let folder = Folder::new("sweeps");
    let press = "(version: 1, name: \"press\", start: (-6, 0), goal: (min: (900, 0), max: (901, 1)), bottom: -40,
        features: [(id: \"floor\", outline: [(-20,-2),(20,-2),(20,0),(-20,0)]),
            (id: \"camp\", kind: Checkpoint, respawn: Some((0,0)), outline: [(-1,0),(1,0),(1,2),(-1,2)])],
        movers: [(id: \"press\", features: [(id: \"head\", outline: [(-1,4),(1,4),(1,7),(-1,7)])],
            path: [(at: (0,0), wait: 1.5, seconds: 1),(at: (0,-3), wait: 0.5, seconds: 1)]),
            (id: \"cart\", features: [(id: \"box\", outline: [(4,0.01),(5,0.01),(5,1),(4,1)])],
            path: [(at: (0,0), seconds: 1),(at: (-2,0), seconds: 1)])])";
    let press = folder.write("press.ron", press);
    let mut command = program(&["--check", &press, "--ticks", "100"]);
    let out = String::from_utf8(command.output().unwrap().stdout).unwrap();
    // Its head is 109/64 m high.
    assert!(
        out.contains(
            "wrong     mover \"press\": 2.266 s after it sets out it comes over where checkpoint \"camp\" puts the hero"
        ),
        "{out}"
    );
    assert!(!out.contains("cart") && !out.contains("the start"), "{out}");
}

#[test]
fn what_does_not_mean_what_it_seems_to_is_told_by_the_check() {
    let folder = Folder::new("seems");
    // Two slopes of nearly 45 degrees, one of exactly that, a curve of short pieces, and a one-way in the rock.
    let features = "(id: \"floor\", outline: [(-9, -1), (20, -1), (20, 0), (-9, 0)]),
                    (id: \"steep\", outline: [(2, 0), (4.1, 0), (4.1, 2.101)]),
                    (id: \"flat\", outline: [(9, 0), (7, 1.999), (7, 0)]),
                    (id: \"exact\", outline: [(10.1, 0), (12.4, 0), (12.4, 2.3)]),
                    (id: \"curve\", outline: [(15, 0), (15.04, 0.0401), (15.04, 0)]),
                    (id: \"buried\", kind: OneWay, outline: [(-3, -0.6), (-1, -0.6)]),
                    (id: \"shelf\", kind: OneWay, outline: [(-3, 2), (-1, 2)]),";
    let file = folder.write("seems.ron", &level(features));
    let mut command = program(&["--check", &file, "--ticks", "500"]);
    let out = String::from_utf8(command.output().unwrap().stdout).unwrap();
    for words in [
        "wrong     feature \"steep\", outline[2] to outline[0]: rises 1.000476 on 1, just over the limit of 1",
        "wrong     feature \"flat\", outline[0] to outline[1]: rises 0.999500 on 1, just under the limit of 1",
        "wrong     feature \"buried\", from outline[0] on: this one-way holds nobody",
    ] {
        assert!(out.contains(words), "{out}");
    }
    assert!(out.ends_with("found     3 wrong\n"), "{out}");
}
