//! Texts of runs: the longest, those that are written bit by bit, and those that break off.

use super::*;

/// A run of some entries, without a level that it could be played in.
fn run(entries: u32) -> Replay {
    let mut replay = Replay {
        version: VERSION,
        level: "levels/none.ron".into(),
        fingerprint: "0".into(),
        tick_rate: 120,
        seed: 7,
        start: None,
        run: None,
        tuning: Tuning::default(),
        inputs: Vec::new(),
    };
    for entry in 0..entries {
        for _ in 0..1 + entry * entry % 23 {
            replay.push(input(entry));
        }
    }
    replay
}

fn input(entry: u32) -> Input {
    Input {
        run: (entry * 37 % 255) as i8,
        jump: entry.is_multiple_of(2),
        respawn: entry.is_multiple_of(5),
        ..Input::default()
    }
}

#[test]
fn a_day_at_1000_hz_is_the_longest_run() {
    assert_eq!(LONGEST, 24 * 60 * 60 * 1000);
    let mut replay = run(0);
    replay.inputs = vec![(LONGEST as u32 - 1, input(1)), (1, input(2))];
    assert_eq!(Replay::parse(&replay.to_text()).as_ref(), Ok(&replay));
    replay.inputs[1].0 = 2;
    let refused = Replay::parse(&replay.to_text()).unwrap_err().to_string();
    assert_eq!(
        refused,
        "field `inputs`: 86400001 ticks are more than 86400000"
    );
}

/// Whoever puts each new end in the place of the old one has the whole text at any time.
#[test]
fn a_text_grows_by_its_end() {
    let mut replay = run(1);
    let mut written = replay.to_text();
    for tick in 0..400_u32 {
        let open = replay.inputs.len() - 1;
        let at = written.len() - replay.tail(open).len();
        for _ in 0..tick % 4 {
            replay.push(input(tick / 9));
        }
        let tail = replay.tail(open);
        assert!(at + tail.len() >= written.len(), "it never shrinks");
        written.truncate(at);
        written += &tail;
        assert_eq!(written, replay.to_text());
    }
    assert!(replay.inputs.len() > 30);
}

/// Broken off anywhere among its inputs, a text gives what was whole; before them, nothing.
#[test]
fn a_text_that_breaks_off_gives_what_is_whole() {
    let replay = run(9);
    let text = replay.to_text();
    let list = text.find(LIST).unwrap() + LIST.len();
    for cut in (0..text.len() - 2).step_by(1) {
        let cut_off = &text[..cut];
        let Some(found) = Replay::parse_cut(cut_off) else {
            assert!(cut < list, "at {cut}");
            continue;
        };
        assert!(cut >= list, "at {cut}");
        let whole = cut_off[list..].matches("))").count();
        assert_eq!(found.inputs, replay.inputs[..whole], "at {cut}");
        let header = Replay {
            inputs: Vec::new(),
            ..found
        };
        assert_eq!(header, run(0));
    }
}

#[test]
fn what_is_wrong_does_not_break_off() {
    let text = run(9).to_text();
    for (from, to) in [
        ("seed: 7", "seed: x"),
        ("inputs: [", "inputs: ["),
        ("run: 37", "run: 370"),
        ("    ],\n)\n", "    ],\n)\n)"),
        ("    ],\n)\n", "    garbage"),
        ("    ],\n)\n", "    (5, (run: 1)]"),
    ] {
        let wrong = text.replacen(from, to, 1);
        let is_right = wrong == text;
        assert_eq!(Replay::parse(&wrong).is_ok(), is_right, "{to}");
        assert!(Replay::parse_cut(&wrong).is_none(), "{to}");
    }
}
