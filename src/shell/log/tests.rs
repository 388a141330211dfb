//! Files that follow a run: whole at any time, and never behind by more than a beat.

use super::*;
use crate::game::Stage;
use std::fs;
use std::time::Instant;

/// The quickest level, and a folder that goes with the test.
fn log(name: &str) -> (PathBuf, Arc<Log>) {
    let folder = std::env::temp_dir().join(format!("edgewalker-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = files::find(Path::new("levels/dev/flat.ron"));
    let stage = Stage::build(crate::level::load(&path).unwrap()).unwrap();
    let replay = Replay::new("levels/dev/flat.ron", &stage, 120, 3, &Tuning::default());
    (folder, Log::of(replay))
}

fn input(tick: u32) -> Input {
    Input {
        run: (tick / 3 % 200) as i8,
        jump: tick.is_multiple_of(7),
        ..Input::default()
    }
}

fn read(path: &Path) -> Replay {
    Replay::parse(&fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
fn the_file_is_whole_after_every_write() {
    let (folder, log) = log("page");
    let path = folder.join("run.replay");
    fs::write(&path, "what was there").unwrap();
    let mut page = Page {
        path: path.clone(),
        file: None,
        ticks: 0,
        open: (0, 0),
        failed: None,
    };
    page.flush(&log);
    let kept = fs::read_to_string(&path).unwrap();
    assert_eq!(kept, "what was there", "nothing is played yet");
    let mut tick = 0;
    for beat in 0..60 {
        for _ in 0..beat % 17 {
            log.push(input(tick));
            tick += 1;
        }
        page.flush(&log);
        assert!(page.failed.is_none());
        if tick > 0 {
            let text = fs::read_to_string(&path).unwrap();
            assert_eq!(text, locked(&log.0).replay.to_text(), "beat {beat}");
        }
    }
    assert_eq!(read(&path).ticks(), u64::from(tick));
    fs::remove_dir_all(folder).unwrap();
}

/// Nobody writes the file here but the recorder's own thread.
#[test]
fn a_recorder_writes_by_itself() {
    let (folder, log) = log("beats");
    let path = folder.join("run.replay");
    let recorder = Recorder::new(&path, log.clone()).unwrap();
    for wanted in [1, 50, 51] {
        while log.ticks() < wanted {
            log.push(input(log.ticks() as u32));
        }
        let pushed = Instant::now();
        while !path.exists() || read(&path).ticks() < wanted {
            assert!(pushed.elapsed() < Duration::from_secs(20), "{wanted} ticks");
            thread::sleep(Duration::from_millis(5));
        }
    }
    log.push(input(51));
    drop(recorder); // as when the game fails
    assert_eq!(read(&path).ticks(), 52);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn what_cannot_be_written_is_told_and_tried_again() {
    let (folder, log) = log("told");
    let path = folder.join("made/run.replay");
    assert!(Recorder::new(&path, log.clone()).is_err());
    fs::create_dir_all(folder.join("made")).unwrap();
    let recorder = Recorder::new(&path, log.clone()).unwrap();
    assert!(recorder.problem().is_none());
    fs::remove_dir_all(folder.join("made")).unwrap();
    log.push(input(0));
    locked(&recorder.page).flush(&log);
    let why = recorder.problem().unwrap().to_string();
    assert!(why.contains("run.replay"), "{why}");
    fs::create_dir_all(folder.join("made")).unwrap();
    locked(&recorder.page).flush(&log);
    assert!(recorder.problem().is_none());
    assert_eq!(read(&path).ticks(), 1);
    assert!(recorder.write().unwrap().contains("recorded  1 ticks to"));
    fs::remove_dir_all(folder).unwrap();
}

/// No file is longer than what can be read again.
#[test]
fn a_log_ends_where_no_replay_could_be_longer() {
    let (folder, log) = log("long");
    {
        let mut inputs = locked(&log.0);
        inputs.replay.inputs = vec![(LONGEST as u32 - 1, input(1))];
        inputs.ticks = LONGEST - 1;
    }
    assert!(!log.push(input(2)) && log.goes_on());
    assert!(log.push(input(2)), "it ends here");
    assert!(!log.push(input(2)) && !log.goes_on());
    let path = folder.join("day.replay");
    let said = log.write(&path).unwrap();
    assert!(said.contains("ended when"), "{said}");
    assert_eq!(read(&path).ticks(), LONGEST);
    fs::remove_dir_all(folder).unwrap();
}
