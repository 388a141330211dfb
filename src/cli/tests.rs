//! What the command line understands and refuses.

use super::*;

fn parse_text(text: &str) -> Result<Command, String> {
    parse(text.split_whitespace().map(OsString::from)).map_err(|e| e.to_string())
}

fn options(text: &str) -> Options {
    match parse_text(text) {
        Ok(Command::Window(options)) => options,
        other => panic!("{text}: {other:?}"),
    }
}

#[test]
fn nothing_asked_is_the_default_game() {
    let Options {
        source,
        size,
        vsync,
        screenshot,
        ..
    } = options("");
    assert!(vsync && size.is_none() && screenshot.is_none());
    assert!(!options("").is_direct());
    let live = Source::Live {
        level: None,
        tuning: None,
        tick_rate: 120,
        seed: 0,
        record: None,
    };
    assert_eq!(source, live);
}

#[test]
fn every_option_arrives() {
    let all = options(
        "--level a --tuning=b --tick-rate 60 --seed 7 --record r --size 800x600 --no-vsync --mesh",
    );
    let live = Source::Live {
        level: Some("a".into()),
        tuning: Some("b".into()),
        tick_rate: 60,
        seed: 7,
        record: Some("r".into()),
    };
    assert_eq!(all.source, live);
    assert!(
        all.size == Some((800, 600)) && !all.vsync && all.mesh && !all.overlay && !all.fullscreen
    );
    assert!(all.is_direct() && options("--record r").is_direct());
    let kept = options("--config-dir c --screen video");
    assert!(!kept.is_direct());
    assert_eq!(
        (kept.config_dir, kept.screen),
        (Some("c".into()), Some("video"))
    );
    let film = options("--film f --seconds 20 --at 7 --preset low");
    let file = "f".into();
    assert_eq!(
        (film.film, film.preset),
        (
            Some(Film {
                file,
                at: 7,
                seconds: 20
            }),
            Some(Preset::Low)
        )
    );
    assert_eq!(options("--bench-frames 9").bench_frames, Some(9));
    let shot = options("--replay r --screenshot s.png --at 12 --overlay");
    assert_eq!(shot.source, Source::Replay("r".into()));
    assert_eq!(
        shot.screenshot,
        Some(Screenshot {
            file: "s.png".into(),
            at: 12
        })
    );
    assert_eq!(
        parse_text("--headless --replay r"),
        Ok(Command::Headless { replay: "r".into() })
    );
    let plan = check::Plan {
        level: "l".into(),
        tuning: None,
        ticks: 12,
        tick_rate: 60,
        seed: 9,
        record: Some("r".into()),
    };
    assert_eq!(
        parse_text("--check l --ticks 12 --tick-rate 60 --seed 9 --record r"),
        Ok(Command::Check(plan))
    );
    assert_eq!(parse_text("--version"), Ok(Command::Version));
    assert_eq!(parse_text("--headless --help"), Ok(Command::Help));
}

#[test]
fn help_names_every_option() {
    for name in FLAGS.iter().chain(VALUED) {
        assert!(HELP.contains(&format!("--{name}")), "{name}");
    }
}

#[test]
fn nonsense_is_refused_with_the_reason() {
    for (text, message) in [
        (
            "--screen shop",
            "--screen: `shop` is none of title, levels, pause, results, settings, video, audio, controls, accessibility, credits, confirm",
        ),
        ("--speed 3", "unknown option --speed"),
        ("-x", "unknown option -x"),
        ("level.ron", "unexpected argument `level.ron`"),
        ("--seed 1 --seed 2", "--seed is given twice"),
        ("--mesh --mesh", "--mesh is given twice"),
        ("--level", "missing argument for option '--level'"),
        ("--mesh=1", "unexpected argument for option '--mesh': \"1\""),
        (
            "--tick-rate 0",
            "--tick-rate: `0` is not a whole number from 10 to 2000",
        ),
        (
            "--tick-rate NaN",
            "--tick-rate: `NaN` is not a whole number from 10 to 2000",
        ),
        (
            "--seed -1",
            "--seed: `-1` is not a whole number from 0 to 18446744073709551615",
        ),
        (
            "--screenshot a.png --at 86400001",
            "--at: `86400001` is not a whole number from 0 to 86400000",
        ),
        (
            "--size 800",
            "--size: `800` is not WIDTHxHEIGHT with sides from 64 to 16384",
        ),
        (
            "--size 0x600",
            "--size: `0x600` is not WIDTHxHEIGHT with sides from 64 to 16384",
        ),
        ("--headless", "--headless needs --replay"),
        ("--ticks 4", "--ticks needs --check"),
        (
            "--check a --mesh",
            "--check and --mesh contradict each other: without a window there is nothing to show",
        ),
        (
            "--check a --level b",
            "--check and --level contradict each other: it names the level, and plays it without a window",
        ),
        ("--screenshot a.png", "--screenshot needs --at"),
        ("--film a", "--film needs --seconds"),
        ("--soundtrack a", "--soundtrack needs --replay or --sound"),
        ("--sound a.ogg", "--sound needs --soundtrack"),
        (
            "--preset ultra",
            "--preset: `ultra` is not low, medium or high",
        ),
        (
            "--bench-frames 0",
            "--bench-frames: `0` is not a whole number from 1 to 100000",
        ),
        ("--at 3", "--at needs --screenshot or --film"),
        (
            "--replay r --level l",
            "--replay and --level contradict each other: a replay brings its own",
        ),
        (
            "--replay r --record r",
            "--replay and --record contradict each other: a replay is recorded already",
        ),
    ] {
        assert_eq!(parse_text(text), Err(message.to_string()), "{text}");
    }
}

#[test]
fn a_soundtrack_is_of_a_replay_or_of_a_sound() {
    let file = || "out.wav".into();
    let of = Heard::Replay("a.ron".into());
    let expected = Command::Soundtrack { of, file: file() };
    assert_eq!(
        parse_text("--soundtrack out.wav --replay a.ron"),
        Ok(expected)
    );
    let of = Heard::Sound("a.ogg".into());
    let expected = Command::Soundtrack { of, file: file() };
    assert_eq!(
        parse_text("--soundtrack out.wav --sound a.ogg"),
        Ok(expected)
    );
    let both = parse_text("--soundtrack out.wav --sound a.ogg --replay a.ron");
    assert!(both.is_err_and(|e| e.contains("one thing at a time")));
}
