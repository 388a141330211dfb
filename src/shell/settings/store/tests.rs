//! Files that are good, missing, broken, too new, half wrong, or not to be written.

use super::super::bindings::Deed;
use super::*;
use crate::cli::Preset;
use crate::game::Run;
use sdl2::keyboard::Scancode;
use std::fs;

/// A folder of its own for each test, gone with it.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let name = format!("edgewalker-store-{name}-{}", std::process::id());
        let folder = Folder(std::env::temp_dir().join(name));
        fs::create_dir_all(&folder.0).unwrap();
        folder
    }

    fn open(&self) -> (Store, Vec<String>) {
        Store::open(Some(&self.0))
    }

    fn write(&self, file: &str, text: &str) {
        fs::write(self.0.join(file), text).unwrap();
    }

    fn read(&self, file: &str) -> String {
        fs::read_to_string(self.0.join(file)).unwrap()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn what_is_saved_is_there_again() {
    let folder = Folder::new("again");
    let (mut store, said) = folder.open();
    assert!(said.is_empty() && store.settings == Settings::default());
    store.settings.video.preset = Some(Preset::High);
    store.settings.video.size = values::Size {
        width: 1920,
        height: 1080,
    };
    store.settings.audio.music = 35;
    store.settings.accessibility.crouch = values::Hold::Toggle;
    let bindings = &mut store.settings.controls.bindings;
    assert!(bindings.set_key(Deed::Jump, 1, Some(Scancode::Comma)));
    assert!(bindings.set_key(Deed::Left, 1, None));
    assert!(bindings.set_button(Deed::Crouch, None));
    let run = Run {
        checkpoint: Some("gate".into()),
        seconds: 12.5,
        deaths: 2,
        ..Run::default()
    };
    store.progress.note("levels/quarry.ron", run, 7);
    store.save_settings().unwrap();
    store.save_progress();
    store.settle().unwrap().unwrap();
    let (again, said) = folder.open();
    assert_eq!(said, [""; 0]);
    assert_eq!(again.settings, store.settings);
    assert_eq!(again.progress.levels, store.progress.levels);
}

#[test]
fn without_a_folder_nothing_is_kept_and_a_missing_one_is_made() {
    let (mut store, said) = Store::open(None);
    assert!(said.is_empty() && store.save_settings().is_ok());
    let folder = Folder::new("missing");
    let deep = folder.0.join("a/b");
    let (mut store, said) = Store::open(Some(&deep));
    assert!(said.is_empty());
    store.save_settings().unwrap();
    assert!(deep.join(SETTINGS_FILE).exists());
}

#[test]
fn a_broken_file_is_set_aside_and_told_of() {
    let folder = Folder::new("broken");
    for (number, text) in [(1, "(version: 1, video: (size"), (2, "nonsense"), (3, "")] {
        folder.write(SETTINGS_FILE, text);
        let (mut store, said) = folder.open();
        assert_eq!(store.settings, Settings::default());
        let aside = format!("{SETTINGS_FILE}.broken-{number}");
        assert!(said.len() == 1 && said[0].contains(&aside), "{said:?}");
        assert_eq!(folder.read(&aside), text);
        store.save_settings().unwrap();
        assert!(folder.open().1.is_empty());
    }
    folder.write(PROGRESS_FILE, "(version: 1, levels: 3)");
    let (_, said) = folder.open();
    assert!(said[0].contains("progress.ron.broken-1"), "{said:?}");
}

#[test]
fn a_newer_file_is_left_alone() {
    let folder = Folder::new("newer");
    let text = "(version: 2, moods: [Bright])";
    for file in [SETTINGS_FILE, PROGRESS_FILE] {
        folder.write(file, text);
    }
    let (mut store, said) = folder.open();
    assert!(
        said.len() == 2 && said.iter().all(|s| s.contains("version 2")),
        "{said:?}"
    );
    store.save_settings().unwrap();
    store.save_progress();
    assert!(store.settle().is_none(), "nothing was to be written");
    assert_eq!(
        [folder.read(SETTINGS_FILE), folder.read(PROGRESS_FILE)],
        [text, text]
    );
}

#[test]
fn one_bad_value_spoils_no_other() {
    let folder = Folder::new("values");
    folder.write(
        SETTINGS_FILE,
        "(version: 1, video: (size: (3, 5), preset: Some(Ultra), vsync: false, frame_cap: 1), \
         audio: (master: 300, music: -4, effects: 7, bass: 1), sky: 3, \
         accessibility: (speed: 10, contrast: true), controls: (bindings: (keys: {\"jump\": [\"Spce\"]}, buttons: {})))",
    );
    let (store, said) = folder.open();
    let Settings {
        video,
        audio,
        controls,
        accessibility,
    } = &store.settings;
    assert_eq!(
        (video.size, video.preset, video.vsync),
        (values::Video::default().size, None, false)
    );
    assert_eq!((audio.master, audio.music, audio.effects), (100, 80, 7));
    assert_eq!((accessibility.speed, accessibility.contrast), (50, true));
    assert_eq!(*controls, values::Hands::default());
    for name in [
        "video.size",
        "video.preset",
        "1 frames a second are no limit: that is 0 for none, or 20 to 1000; the default is used",
        "video.frame_cap: ",
        "audio.master: 300",
        "audio.music",
        "audio.bass",
        "sky",
        "accessibility.speed: 10",
        "`Spce` is no key",
    ] {
        assert!(said.iter().any(|s| s.contains(name)), "{name}: {said:?}");
    }
    assert_eq!(video.frame_cap, values::FrameCap::NONE);
    assert_eq!(said.len(), 9, "{said:?}");
}

#[test]
fn times_that_are_none_are_left_out() {
    let folder = Folder::new("times");
    folder.write(
        PROGRESS_FILE,
        "(version: 1, levels: {\"a\": (best_seconds: Some(-3)), \"b\": (run: Some((seconds: inf)), finished: 2)})",
    );
    let (store, said) = folder.open();
    assert_eq!(said.len(), 2, "{said:?}");
    assert_eq!(store.progress.levels["a"].best_seconds, None);
    assert_eq!(
        (
            &store.progress.levels["b"].run,
            store.progress.levels["b"].finished
        ),
        (&None, 2)
    );
}

/// What cannot be written says so: here because a file stands where the folder should be.
#[test]
fn what_cannot_be_written_says_so() {
    let folder = Folder::new("blocked");
    folder.write("file", "");
    let (mut store, said) = Store::open(Some(&folder.0.join("file")));
    assert!(said.is_empty());
    let error = store.save_settings().unwrap_err().to_string();
    assert!(
        error.contains(SETTINGS_FILE) && error.contains("cannot be saved"),
        "{error}"
    );
}

/// Each game keeps what it has changed itself; what it has not, as the other one left it.
#[test]
fn two_games_keep_what_each_has_changed() {
    let folder = Folder::new("both");
    let (mut one, mut two) = (folder.open().0, folder.open().0);
    one.settings.audio.music = 10;
    one.settings.video.vsync = false;
    one.save_settings().unwrap();
    two.settings.audio.effects = 20;
    two.settings.video.vsync = true; // as it was
    two.save_settings().unwrap();
    let (both, _) = folder.open();
    let audio = &both.settings.audio;
    assert_eq!(
        (audio.music, audio.effects, both.settings.video.vsync),
        (10, 20, false)
    );
    one.settings.audio.effects = 30;
    one.save_settings().unwrap();
    two.settings.audio.music = 40;
    two.save_settings().unwrap();
    let audio = folder.open().0.settings.audio;
    assert_eq!(
        (audio.music, audio.effects),
        (40, 30),
        "the last writer of each"
    );
}

/// What was reached while a save was under way, and what other games have reached, is counted once.
#[test]
fn what_two_games_reach_is_counted_once() {
    let folder = Folder::new("counted");
    let (mut one, mut two) = (folder.open().0, folder.open().0);
    let run = |seconds: f64| Run {
        seconds,
        ..Run::default()
    };
    for round in 0..10 {
        for game in [&mut one, &mut two] {
            game.progress.finish("a", &run(50.0 - f64::from(round)), 0);
            game.save_progress();
            game.progress.finish("a", &run(90.0), 0); // while the last is being written, or was just
            game.save_progress();
        }
        let _ = (one.saved(), two.saved());
    }
    for game in [&mut one, &mut two] {
        game.settle().map(Result::unwrap);
        game.save_progress();
        game.settle().unwrap().unwrap();
    }
    let record = &folder.open().0.progress.levels["a"];
    assert_eq!((record.finished, record.best_seconds), (40, Some(41.0)));
    assert_eq!(
        &two.progress.levels["a"], record,
        "who saved last knows all"
    );
}

/// A file that went bad or newer while the game was running.
#[test]
fn what_has_become_of_a_file_meanwhile_is_looked_at() {
    let folder = Folder::new("meanwhile");
    let mut store = folder.open().0;
    store.progress.finish("a", &Run::default(), 0);
    folder.write(PROGRESS_FILE, "half of a fi");
    store.save_progress();
    store.settle().unwrap().unwrap();
    assert_eq!(folder.read("progress.ron.broken-1"), "half of a fi");
    assert!(folder.read(PROGRESS_FILE).contains("finished: 1"));
    folder.write(PROGRESS_FILE, "(version: 9, new: true)");
    store.save_progress();
    let why = store.settle().unwrap().unwrap_err().to_string();
    assert!(why.contains("newer game"), "{why}");
    assert_eq!(folder.read(PROGRESS_FILE), "(version: 9, new: true)");
    fs::remove_file(folder.0.join(PROGRESS_FILE)).unwrap();
    store.save_progress();
    store.settle().unwrap().unwrap();
    assert!(folder.read(PROGRESS_FILE).contains("finished: 1"));
}

/// Progress that older games have written is still read.
#[test]
fn what_older_games_have_written_is_read() {
    let folder = Folder::new("older");
    folder.write(
        PROGRESS_FILE,
        "(version: 1, last: Some(\"a\"), levels: {\"a\": (run: Some((checkpoint: Some(\"gate\"), seconds: 4.5, \
         deaths: 2, secrets: [\"cave\"])), best_seconds: Some(9.5), fewest_deaths: Some(1), most_secrets: 3, finished: 2)})",
    );
    let (mut store, said) = folder.open();
    assert_eq!(said, [""; 0]);
    assert_eq!(store.progress.unfinished().unwrap().1.deaths, 2);
    store.progress.finish("a", &Run::default(), 0);
    store.save_progress();
    store.settle().unwrap().unwrap();
    let record = &folder.open().0.progress.levels["a"];
    assert_eq!(
        (record.finished, record.most_secrets, &record.run),
        (3, 3, &None)
    );
}
