//! Level files: what is refused, in which words, and that nothing in a file can make the game panic.

mod kinds;
mod stretches;

use edgewalker::game::Stage;
use edgewalker::level::{self, Level};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use std::fs;
use std::path::{Path, PathBuf};

/// A small level whose comments and strings do their best to look like values.
const SMALL: &str = r#"// features: [ (id: "not this one
(
    version: 1,
    name: "A (small] level",
    start: (0.0, 0.5),
    goal: (min: (8, 0), max: (9, 2)),
    bottom: -10.0,
    features: [
        /* (id: "nor", outline: [( */
        (
            id: "floor, [(\"quoted\")]",
            material: Rock,
            outline: [
                (-5, -1),
                (10, -1), // (10, 0)
                (10, 0),
                (-5, 0),
            ],
        ),
        (
            id: "ledge",
            material: Masonry,
            outline: [(3, 1), (5, 1), (4, 2)],
        ),
    ],
    scenery: [
        (kind: Lantern, at: (1, 0)),
        (kind: Crane, at: (2, 0), depth: -8, scale: 1.5, turn: Some(30), flip: true),
    ],
)
"#;

/// What is said about the small level after one change to its text.
fn complaint(from: &str, to: &str) -> String {
    assert_eq!(
        SMALL.matches(from).count(),
        1,
        "the change must hit one place: {from}"
    );
    let text = SMALL.replacen(from, to, 1);
    level::parse(&text, Path::new("small.ron"))
        .expect_err(to)
        .to_string()
}

fn scratch(name: &str) -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&dir);
    fs::create_dir_all(&dir).unwrap();
    dir
}

#[test]
fn the_small_level_is_read() {
    let level = level::parse(SMALL, Path::new("small.ron")).unwrap();
    assert_eq!((level.features.len(), level.scenery.len()), (2, 2));
    assert_eq!(level.features[0].id, "floor, [(\"quoted\")]");
    assert_eq!((level.scenery[0].depth, level.scenery[0].scale), (0.0, 1.0));
    assert_eq!(
        (level.scenery[0].turn, level.scenery[0].flip),
        (None, false)
    );
    assert_eq!(
        (level.scenery[1].turn, level.scenery[1].flip),
        (Some(30.0), true)
    );
}

#[test]
fn numbers_that_are_none_or_too_large_are_refused() {
    let cases = [
        (
            "(5, 1)",
            "(5, NaN)",
            "small.ron:23: feature \"ledge\", outline[1].y: NaN is not a finite number",
        ),
        (
            "(10, 0),\n",
            "(-inf, 0),\n",
            "small.ron:16: feature \"floor, [(\\\"quoted\\\")]\", outline[2].x: -inf is not a finite number",
        ),
        (
            "(-5, -1)",
            "(-4000, -1)",
            "small.ron:14: feature \"floor, [(\\\"quoted\\\")]\", outline[0].x: -4000 is out of bounds: coordinates are between -4000 and 4000 m",
        ),
        (
            "(0.0, 0.5)",
            "(0.0, NaN)",
            "small.ron:5: level, start.y: NaN is not a finite number",
        ),
        (
            "(8, 0)",
            "(8, inf)",
            "small.ron:6: level, goal.min.y: inf is not a finite number",
        ),
        (
            "-10.0",
            "5e3",
            "small.ron:7: level, bottom: 5000 is out of bounds: coordinates are between -4000 and 4000 m",
        ),
        (
            "(1, 0)",
            "(1, NaN)",
            "small.ron:27: scenery[0], at.y: NaN is not a finite number",
        ),
        (
            "-8",
            "-1001",
            "small.ron:28: scenery[1], depth: -1001 is outside -1000..=1000 m",
        ),
        (
            "1.5",
            "NaN",
            "small.ron:28: scenery[1], scale: NaN is not above 0 and at most 100",
        ),
        (
            "1.5",
            "0",
            "small.ron:28: scenery[1], scale: 0 is not above 0 and at most 100",
        ),
        (
            "30",
            "-361",
            "small.ron:28: scenery[1], turn: -361 is outside -360..=360 degrees",
        ),
        (
            "30",
            "NaN",
            "small.ron:28: scenery[1], turn: NaN is outside -360..=360 degrees",
        ),
    ];
    for (from, to, expected) in cases {
        assert_eq!(complaint(from, to), expected);
    }
    assert_eq!(
        complaint("(4, 2)", "(4, 1e300)"),
        "small.ron:23: feature \"ledge\", outline[2].y: 1e300 is out of bounds: coordinates are between -4000 and 4000 m"
    );
}

#[test]
fn outlines_that_are_not_simple_are_refused() {
    let ledge = "[(3, 1), (5, 1), (4, 2)]";
    let cases = [
        ("[]", "an outline needs 3 corners and this one has 0"),
        (
            "[(3, 1), (5, 1)]",
            "an outline needs 3 corners and this one has 2",
        ),
        (
            "[(3, 1), (5, 1), (5, 1.000001), (4, 2)]",
            "edge 1 has no length (on the grid): (5, 1) to (5, 1.000001)",
        ),
        (
            "[(3, 1), (5, 1), (4, 2), (3, 1)]",
            "edge 3 has no length (on the grid): (3, 1) to (3, 1)",
        ),
        (
            "[(3, 1), (5, 2), (5, 1), (3, 2)]",
            "edges 0 and 2 cross or touch: (3, 1) to (5, 2) and (5, 1) to (3, 2)",
        ),
        (
            "[(3, 1), (5, 1), (4, 1), (4, 2)]",
            "the outline turns back on itself at corner 1: (5, 1)",
        ),
        (
            "[(3, 1), (5, 1), (5, 2), (4, 1), (3, 2)]",
            "edges 0 and 3 cross or touch: (3, 1) to (5, 1) and (4, 1) to (3, 2)",
        ),
    ];
    for (outline, message) in cases {
        let expected = format!("small.ron:23: feature \"ledge\", outline: {message}");
        assert_eq!(complaint(ledge, outline), expected);
    }
    let close: Vec<String> = (0..5000)
        .map(|i| format!("({}, {})", f64::from(i) * 0.5, i % 2))
        .collect();
    let close = complaint(ledge, &format!("[{}]", close.join(",")));
    assert!(
        close.ends_with("outline: has 5000 corners; at most 4096 are allowed"),
        "{close}"
    );
    let spread = complaint(ledge, "[\n(3, 2),\n(3, 1),\n(5, 2),\n(5, 1)]");
    assert!(
        spread.starts_with("small.ron:25: feature \"ledge\", outline: edges 1 and 3 cross"),
        "{spread}"
    );
}

#[test]
fn names_and_places_that_make_no_sense_are_refused() {
    let cases = [
        (
            "id: \"ledge\"",
            "id: \"floor, [(\\\"quoted\\\")]\"",
            "21: feature \"floor, [(\\\"quoted\\\")]\", id: is the id of features[0] as well",
        ),
        (
            "id: \"ledge\"",
            "id: \"\"",
            "21: feature \"\", id: must have 1 to 64 characters, none of them a control character",
        ),
        (
            "\"A (small] level\"",
            "\"a\\tb\"",
            "4: level, name: must have 1 to 64 characters, none of them a control character",
        ),
        (
            "(8, 0)",
            "(8, 2)",
            "6: level, goal: min is not below and left of max",
        ),
        (
            "-10.0",
            "3",
            "6: level, goal: lies below the bottom, where the hero falls out of the level",
        ),
        (
            "-10.0",
            "1",
            "5: level, start: lies below the bottom, where the hero falls out of the level",
        ),
        (
            "(0.0, 0.5)",
            "(8.5, 1)",
            "5: level, start: lies in the goal: the level would end before it begins",
        ),
        (
            "(0.0, 0.5)",
            "(0.0, -0.5)",
            "5: level, start: the hero would stand inside feature \"floor, [(\\\"quoted\\\")]\"",
        ),
        (
            "(0.0, 0.5)",
            "(4.0, 0.0)",
            "5: level, start: the hero would stand inside feature \"ledge\"",
        ),
        (
            "version: 1",
            "version: 2",
            "3: level, version: 2 is not supported; this build reads version 1",
        ),
    ];
    for (from, to, expected) in cases {
        assert_eq!(complaint(from, to), format!("small.ron:{expected}"));
    }
}

#[test]
fn the_hero_fits_where_he_touches() {
    // On the floor exactly, and beside the ledge with 13/32 m to his side; one grid step further he does not fit.
    for (start, fits) in [
        ("(4, 2)", true),
        ("(0, 0)", true),
        ("(5.40625, 0)", true),
        ("(5.40623, 0)", false),
    ] {
        let text = SMALL.replacen("(0.0, 0.5)", start, 1);
        assert_eq!(
            level::parse(&text, Path::new("small.ron")).is_ok(),
            fits,
            "{start}"
        );
    }
}

#[test]
fn text_that_is_no_level_is_refused_with_its_line() {
    let cases = [
        (
            "material: Masonry",
            "colour: Masonry",
            "22: feature \"ledge\": Unexpected field named `colour` in `Feature`, expected one of `id`, `material`, `kind`, `outline`, `climbable`, `conveyor`, `friction`, `concave`, `by`, or `respawn` instead",
        ),
        (
            "id: \"ledge\",",
            "",
            "24: feature \"#1\": Unexpected missing field named `id` in `Feature`",
        ),
        (
            "Masonry",
            "Marble",
            "22: feature \"ledge\": Unexpected variant named `Marble` in enum `Material`, expected one of `Rock`, `Masonry`, `Timber`, or `Iron` instead",
        ),
        (
            "(4, 2)",
            "(4, 2, 0)",
            "23: feature \"ledge\": Expected closing `)`",
        ),
        (
            "(4, 2)",
            "4",
            "23: feature \"ledge\": Expected opening `(` for struct `DVec2`",
        ),
        (
            "kind: Crane",
            "kind: \"Crane\"",
            "28: scenery[1]: Expected identifier",
        ),
        (
            "name: ",
            "title: ",
            "4: Unexpected field named `title` in `Level`, expected one of `version`, `name`, `start`, `goal`, `bottom`, `areas`, `frames`, `prompts`, `features`, `movers`, or `scenery` instead",
        ),
        (
            "bottom: -10.0,",
            "",
            "30: Unexpected missing field named `bottom` in `Level`",
        ),
        ("version: 1", "version: one", "3: Expected integer"),
        (
            "version: 1,",
            "",
            "30: Unexpected missing field named `version` in `Level`",
        ),
    ];
    for (from, to, expected) in cases {
        assert_eq!(complaint(from, to), format!("small.ron:{expected}"));
    }
}

#[test]
fn files_that_cannot_be_read_are_refused() {
    let dir = scratch("unreadable");
    let error = |name: &str, bytes: Option<&[u8]>| {
        let path = dir.join(name);
        bytes.inspect(|bytes| fs::write(&path, bytes).unwrap());
        let error = level::load(&path).unwrap_err().to_string();
        error
            .strip_prefix(&format!("{}: ", dir.join(name).display()))
            .unwrap()
            .to_string()
    };
    assert_eq!(error("empty.ron", Some(b"")), "is empty");
    assert_eq!(error("blank.ron", Some(b" \n\n")), "is empty");
    assert_eq!(
        error("latin1.ron", Some(b"(name: \"Br\xfccke\")")),
        "is not UTF-8 text (byte 10 of the file)"
    );
    assert!(error("missing.ron", None).starts_with("cannot be read: No such file"));
    assert_eq!(
        error("", None),
        "cannot be read: is a directory, not a file"
    );
}

#[test]
fn a_byte_order_mark_and_foreign_line_ends_are_no_matter() {
    let plain = level::parse(SMALL, Path::new("small.ron")).unwrap();
    let windows = format!("\u{feff}{}", SMALL.replace('\n', "\r\n"));
    assert_eq!(
        level::parse(&windows, Path::new("small.ron")).unwrap(),
        plain
    );
    let broken = windows.replace("(4, 2)", "(4, NaN)");
    let error = level::parse(&broken, Path::new("small.ron")).unwrap_err();
    assert_eq!(error.line, Some(23));
}

#[test]
fn an_endless_id_is_not_repeated_in_the_message() {
    let message = complaint("\"ledge\"", &format!("\"{}\"", "x".repeat(100_000)));
    assert!(
        message.contains("features[1], id: must have 1 to 64 characters"),
        "{} characters",
        message.len()
    );
}

#[test]
fn a_saved_level_comes_back_equal_and_a_refused_one_leaves_the_file_alone() {
    let path = scratch("saved").join("level.ron");
    let mut level = level::parse(SMALL, Path::new("small.ron")).unwrap();
    level.features[1].outline[2].y = 2.0 + f64::EPSILON * 3.0;
    level::save(&level, &path).unwrap();
    assert_eq!(level::load(&path).unwrap(), level);
    let before = fs::read(&path).unwrap();
    level.features[1].outline[2].y = f64::NAN;
    let error = level::save(&level, &path).unwrap_err().to_string();
    assert!(
        error.ends_with("level.ron: feature \"ledge\", outline[2].y: NaN is not a finite number"),
        "{error}"
    );
    assert_eq!(fs::read(&path).unwrap(), before);
    assert_eq!(
        fs::read_dir(path.parent().unwrap()).unwrap().count(),
        1,
        "no temporary file stays behind"
    );
}

#[test]
fn saving_to_a_place_that_cannot_hold_a_file_is_an_error() {
    let dir = scratch("unwritable");
    let level = level::parse(SMALL, Path::new("small.ron")).unwrap();
    for path in [dir.clone(), dir.join("no/such/dir.ron"), dir.join("..")] {
        assert!(
            level::save(&level, &path)
                .unwrap_err()
                .to_string()
                .contains("cannot be written: ")
        );
    }
}

/// Reads what must not panic; a level that is accepted must survive being written and read again, and being built.
fn survive(text: &str) {
    if let Ok(level) = level::parse(text, Path::new("mutant.ron")) {
        let again = ron::to_string(&level).unwrap();
        let read: Level = level::parse(&again, Path::new("again.ron")).unwrap();
        assert_eq!(read, level);
        if let Err(error) = Stage::build(level) {
            panic!("accepted, but cannot be played: {error}\n{text}");
        }
    }
}

#[test]
fn every_truncation_is_refused_in_words() {
    for end in 0..SMALL.trim_end().len() {
        let error =
            level::parse(&SMALL[..end], Path::new("small.ron")).expect_err("a truncated level");
        assert!(error.to_string().starts_with("small.ron:"), "{error}");
    }
}

/// Copies of a text with a few random bytes changed, put in, taken out or doubled.
fn mutants(text: &'static str, seed: u64, count: u32) -> impl Iterator<Item = String> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let spare = b"()[]{},:\"\\/*#'-+.0123456789eENaninfr_ \n\xc3\xa4\xff";
    (0..count).map(move |_| {
        let mut bytes = text.as_bytes().to_vec();
        for _ in 0..1 + random.next_u32() % 4 {
            let at = random.next_u32() as usize % bytes.len();
            let byte = spare[random.next_u32() as usize % spare.len()];
            let to = (at + random.next_u32() as usize % 40).min(bytes.len());
            match random.next_u32() % 4 {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                2 => drop(bytes.drain(at..to)),
                _ => bytes.splice(at..at, bytes[at..to].to_vec()).for_each(drop),
            }
        }
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

#[test]
fn random_damage_never_panics() {
    mutants(SMALL, 0x1e7e1, 6000).for_each(|text| survive(&text));
}

#[test]
fn every_shipped_level_loads() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("levels");
    let mut count = 0;
    for dir in [root.clone(), root.join("dev")] {
        for entry in fs::read_dir(dir).unwrap() {
            let path = entry.unwrap().path();
            let name = path.to_string_lossy();
            if name.ends_with(".ron") && !name.ends_with(".tuning.ron") {
                level::load(&path).unwrap_or_else(|error| panic!("{error}"));
                count += 1;
            }
        }
    }
    assert!(count >= 6, "only {count} levels");
}
