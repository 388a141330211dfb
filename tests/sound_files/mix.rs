//! The recorded run through the quarry as it is heard, measured: how loud, how high its peaks, whether it clicks or falls
//! silent, and whether steps are heard over the music. What was measured lies in `target/tmp/mix-*.wav` afterwards.

use super::heard::each_moment;
use super::measure::{Loudness, band, click, true_peak};
use edgewalker::cli::load;
use edgewalker::game::Replay;
use edgewalker::shell::audio::Volumes;
use edgewalker::shell::audio::decode::RATE;
use edgewalker::shell::audio::soundtrack::{render, wav};
use edgewalker::sound::{Cue, Sound};
use std::path::Path;
use std::sync::LazyLock;

const RUN: &str = "tests/golden/quarry.replay.ron";
/// What the whole shall come to and how far it may be off, LUFS; and what the curve between its samples may reach, dB.
const WHOLE: (f32, f32) = (-18.0, 1.0);
const PEAK: f32 = -1.0;
/// What is softer for a second is silence, LUFS.
const SILENCE: f32 = -42.0;
/// The band in which steps are told from one another on any loudspeaker, Hz; and how long one is looked at, s.
const STEP_BAND: (f32, f32) = (400.0, 6000.0);
const STEP_TIME: f64 = 0.06;
/// By how much the median step is above the music in that band, and nine of ten are, dB.
const STEP_OVER: (f32, f32) = (6.0, -4.5);

/// The three renderings: the whole, without music, and music alone.
struct Mix {
    whole: Vec<f32>,
    effects: Vec<f32>,
    music: Vec<f32>,
    cues: Vec<Cue>,
}

static MIX: LazyLock<Mix> = LazyLock::new(|| {
    let path = Path::new(RUN);
    let replay = load::replay(path).unwrap_or_else(|e| panic!("{e}"));
    let all = Volumes::default();
    let play = |name: &str, volumes: Volumes| {
        let heard = render(path, &replay, volumes).unwrap_or_else(|e| panic!("{e}"));
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("mix-{name}.wav"));
        std::fs::write(file, wav(&heard)).unwrap();
        heard
    };
    let (music, effects) = (0.0, 0.0);
    Mix {
        whole: play("whole", all),
        effects: play("effects", Volumes { music, ..all }),
        music: play("music", Volumes { effects, ..all }),
        cues: cues(path, &replay),
    }
});

/// What begins in the run, and when.
fn cues(path: &Path, replay: &Replay) -> Vec<Cue> {
    let mut cues = Vec::new();
    each_moment(path, replay, |_, scape, moment| {
        cues.extend(&scape.tick(moment).cues);
    });
    cues
}

#[test]
fn the_run_is_as_loud_as_it_shall_be_and_never_too_loud() {
    let loudness = Loudness::of(&MIX.whole);
    let (integrated, peak) = (loudness.integrated(), true_peak(&MIX.whole));
    println!("{integrated} LUFS, true peak {peak} dB");
    assert!((integrated - WHOLE.0).abs() < WHOLE.1, "{integrated} LUFS");
    assert!(peak < PEAK, "true peak {peak} dB");
    let seconds = loudness.seconds();
    for (second, loudness) in seconds.iter().enumerate().skip(2) {
        assert!(
            *loudness > SILENCE || second + 3 > seconds.len(),
            "second {second}: {loudness} LUFS"
        );
    }
}

#[test]
fn nothing_clicks_in_the_run() {
    for (name, heard) in [("the whole", &MIX.whole), ("music", &MIX.music)] {
        for side in 0..2 {
            let samples: Vec<f32> = heard.iter().skip(side).step_by(2).copied().collect();
            let clicks = click(&samples);
            assert!(clicks.is_none(), "{name}: a click at {clicks:?}");
        }
    }
}

#[test]
fn steps_are_heard_over_the_music() {
    let is_step = |cue: &&Cue| {
        use Sound::{StepIron, StepMasonry, StepRock, StepTimber};
        matches!(cue.sound, StepIron | StepMasonry | StepRock | StepTimber)
    };
    let count = (STEP_TIME * f64::from(RATE)) as usize;
    let mut over: Vec<f32> = Vec::new();
    for cue in MIX.cues.iter().filter(is_step) {
        let start = (cue.at * f64::from(RATE)) as usize;
        let part = |heard: &[f32]| band(&heard[2 * start..2 * (start + count)], STEP_BAND);
        over.push(part(&MIX.effects) - part(&MIX.music));
    }
    over.sort_by(f32::total_cmp);
    let (median, tenth) = (over[over.len() / 2], over[over.len() / 10]);
    println!(
        "{} steps: {median} dB over the music, nine of ten {tenth} dB",
        over.len()
    );
    assert!(over.len() > 300, "{}", over.len());
    assert!(
        median > STEP_OVER.0 && tenth > STEP_OVER.1,
        "{median} dB, {tenth} dB"
    );
}
