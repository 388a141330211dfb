//! What is left of games that are stopped in the middle: by signals, by a fault of their own, by the display that goes away.
//!
//! Each game is a process of its own, this program again. It tells every frame what it has come to, so that what is found
//! afterwards can be held against it.

#[allow(dead_code)] // shared with tests that do more by hand
mod hands;

use edgewalker::cli::{Options, Source, load};
use edgewalker::game::{Replay, Run};
use edgewalker::shell::app::App;
use edgewalker::shell::guard;
use edgewalker::shell::settings::{Progress, Store};
use hands::{FLAT, key, open, options};
use sdl2::keyboard::Scancode;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

const TICK_RATE: u64 = 120;
/// How long a game is played before it is stopped.
const PLAYED: Duration = Duration::from_millis(2500);
/// How long anything is waited for.
const PATIENCE: Duration = Duration::from_secs(120);

type Test = (&'static str, fn(&Path));

const TESTS: &[Test] = &[
    ("a recording survives every signal", signals),
    ("a recording survives its display", lost_display),
    ("what a display refuses is told in our words", refused),
    ("a fault leaves the inputs that led to it", fault),
    ("progress survives a kill", progress),
    ("several games keep all that they reach", several_games),
];

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    if let [role, folder, rest @ ..] = args.as_slice()
        && let Some(role) = role.strip_prefix("as-")
    {
        act(role, Path::new(folder), rest);
        return ExitCode::SUCCESS;
    }
    let wanted = args.iter().find(|arg| !arg.starts_with('-'));
    let is_wanted = |name: &str| wanted.is_none_or(|wanted| name.contains(wanted.as_str()));
    for (name, test) in TESTS.iter().filter(|(name, _)| is_wanted(name)) {
        let folder = std::env::temp_dir().join(format!("edgewalker-end-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        print!("test {name} ... ");
        test(&folder);
        println!("ok");
        fs::remove_dir_all(&folder).unwrap();
    }
    ExitCode::SUCCESS
}

// The games.

fn act(role: &str, folder: &Path, rest: &[String]) {
    let config = Some(folder.join("config"));
    let recorded = Options {
        config_dir: config.clone(),
        source: Source::Live {
            level: Some(FLAT.into()),
            tuning: None,
            tick_rate: TICK_RATE as u32,
            seed: 0,
            record: (role == "recorded").then(|| folder.join("run.replay")),
        },
        ..options(FLAT)
    };
    match role {
        "recorded" => play(&mut open(&recorded), None),
        "fault" => guard::keep(|| play(&mut open(&recorded), Some(500))),
        "kept" => {
            let mut from_title = recorded;
            if let Source::Live { level, .. } = &mut from_title.source {
                *level = None;
            }
            let mut app = open(&from_title);
            hands::frames(&mut app, 2);
            hands::tap(&mut app, Scancode::Return); // a new game
            play(&mut app, None);
        }
        "finishing" => finish_often(folder, &rest[0]),
        _ => panic!("{role}?"),
    }
}

/// Plays with changing keys in real time until the game is left; tells every frame what it has come to.
fn play(app: &mut App, faulty_at: Option<u64>) {
    let mut out = std::io::stdout().lock();
    let mut last = Instant::now();
    let mut held = Scancode::D;
    for frame in 0.. {
        if frame % 5 == 0 {
            key(app, held, false);
            held = [Scancode::D, Scancode::Space, Scancode::A, Scancode::S][frame / 5 % 4];
            key(app, held, true);
        }
        if frame == 12 {
            hands::tap(app, Scancode::R); // a death
        }
        std::thread::sleep(Duration::from_millis(8));
        let now = Instant::now();
        app.frame(now - last).unwrap();
        last = now;
        let (world, view) = (&app.play.world, app.play.world.view());
        let (tick, hash, deaths) = (world.tick(), world.hash(), view.deaths);
        // Who reads may have gone; the game goes on.
        let _ = writeln!(out, "{tick} {hash} {deaths} {}", view.run_time());
        let _ = out.flush();
        assert!(faulty_at.is_none_or(|at| tick < at), "planted");
        if app.has_quit() {
            break;
        }
    }
    app.finish().unwrap();
}

/// Finishes runs, each saved at once; and finds a secret of its own each time.
fn finish_often(folder: &Path, name: &str) {
    let (mut store, _) = Store::open(Some(folder));
    for round in 0..ROUNDS {
        let run = Run {
            seconds: f64::from(1000 - round),
            secrets: vec![format!("{name}-{round}")],
            ..Run::default()
        };
        store.progress.finish("all", &run, 9);
        store.progress.finish(name, &run, 9);
        store.save_progress();
        store.settle().unwrap().unwrap();
        println!("{round} 0 0 0");
    }
}

const ROUNDS: u32 = 25;

// Those who watch.

/// A game that runs, and what it has told so far.
struct Game {
    child: Child,
    out: BufReader<ChildStdout>,
    told: Vec<(u64, u64, u32, f64)>,
}

impl Game {
    fn start(role: &str, folder: &Path, more: &[&str], display: Option<&str>) -> Game {
        let mut command = Command::new(std::env::current_exe().unwrap());
        command.arg(format!("as-{role}")).arg(folder).args(more);
        match display {
            Some(display) => command
                .env("SDL_VIDEODRIVER", "x11")
                .env("DISPLAY", display),
            None => command.env("SDL_VIDEODRIVER", "offscreen"),
        };
        let piped = command
            .env("SDL_AUDIODRIVER", "dummy")
            .stdout(Stdio::piped());
        let mut child = piped.stderr(Stdio::piped()).spawn().unwrap();
        let out = BufReader::new(child.stdout.take().unwrap());
        let told = Vec::new();
        Game { child, out, told }
    }

    /// Reads a line; whether there was one.
    fn listen(&mut self) -> bool {
        let mut line = String::new();
        if self.out.read_line(&mut line).unwrap() == 0 {
            return false;
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        let [tick, hash, deaths, seconds] = words[..] else {
            return true; // the summary at the end
        };
        if let (Ok(tick), Ok(hash), Ok(deaths), Ok(seconds)) =
            (tick.parse(), hash.parse(), deaths.parse(), seconds.parse())
        {
            self.told.push((tick, hash, deaths, seconds));
        }
        true
    }

    /// Lets it play for a while, from its first frame on.
    fn watch(&mut self) {
        assert!(self.listen(), "{}", self.complaint());
        let begin = Instant::now();
        while begin.elapsed() < PLAYED {
            assert!(self.listen(), "{}", self.complaint());
        }
    }

    fn complaint(&mut self) -> String {
        let mut said = String::new();
        let stderr = self.child.stderr.as_mut().unwrap();
        std::io::Read::read_to_string(stderr, &mut said).unwrap();
        said
    }

    fn signal(&self, name: &str) {
        let id = self.child.id().to_string();
        let sent = Command::new("kill").args(["-s", name, &id]).status();
        assert!(sent.unwrap().success(), "kill -s {name}");
    }

    /// Waits for its end, by itself; its status and what it has complained of.
    fn end(&mut self) -> (Option<i32>, String) {
        while self.listen() {}
        let begin = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return (status.code(), self.complaint());
            }
            assert!(begin.elapsed() < PATIENCE, "it does not end");
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}

impl Drop for Game {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// What is in the file is what was played, tick by tick, and at most so many of the last ticks are missing.
fn expect_prefix(file: &Path, game: &Game, missing: u64) {
    let replay: Replay = load::replay(file).unwrap_or_else(|e| panic!("{e}"));
    let last = game.told.last().unwrap().0;
    assert!(last > TICK_RATE, "too little was played: {last} ticks");
    let ticks = replay.ticks();
    assert!(ticks + missing >= last, "{ticks} of {last} ticks");
    let mut world = load::replay_world(file, &replay).unwrap_or_else(|e| panic!("{e}"));
    let mut told = game.told.iter().filter(|told| told.0 > 0).peekable();
    let mut compared = 0;
    for input in replay.iter() {
        world.step(input, &replay.tuning);
        while told.peek().is_some_and(|told| told.0 < world.tick()) {
            told.next();
        }
        if let Some(&&(tick, hash, ..)) = told.peek()
            && tick == world.tick()
        {
            assert_eq!(world.hash(), hash, "tick {tick}");
            compared += 1;
        }
    }
    assert!(compared > 9 && replay.inputs.len() > 4, "{compared}");
}

fn signals(folder: &Path) {
    let file = folder.join("run.replay");
    for signal in ["INT", "TERM", "HUP", "KILL"] {
        let mut game = Game::start("recorded", folder, &[], None);
        game.watch();
        game.signal(signal);
        let (status, said) = game.end();
        let is_left = ["INT", "TERM"].contains(&signal);
        assert_eq!(status, is_left.then_some(0), "{signal}: {said}");
        expect_prefix(&file, &game, if is_left { 0 } else { TICK_RATE });
        fs::remove_file(&file).unwrap();
    }
}

/// An X server of its own, gone with the test. Only Linux has its windows by X: nowhere else is there one to be taken away.
struct Server {
    child: Child,
    display: String,
}

impl Server {
    fn start() -> Server {
        let xvfb = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "640x480x24"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut child = xvfb.expect("Xvfb is needed for this test: scripts/test installs it");
        let mut number = String::new();
        let mut out = BufReader::new(child.stdout.take().unwrap());
        out.read_line(&mut number).unwrap();
        let display = format!(":{}", number.trim());
        Server { child, display }
    }

    fn stop(&mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn lost_display(folder: &Path) {
    if !cfg!(target_os = "linux") {
        return;
    }
    let mut server = Server::start();
    let mut game = Game::start("recorded", folder, &[], Some(&server.display));
    game.watch();
    server.stop();
    let (status, said) = game.end();
    assert_eq!(status, Some(1), "{said}");
    assert!(
        said.contains("edgewalker: the display has gone away"),
        "{said}"
    );
    assert!(!said.contains("panicked"), "{said}");
    expect_prefix(&folder.join("run.replay"), &game, TICK_RATE);
}

/// By itself Xlib would print codes and end the program.
fn refused(_: &Path) {
    if !cfg!(target_os = "linux") {
        return;
    }
    let server = Server::start();
    for (name, value) in [
        ("LIBGL_ALWAYS_INDIRECT", "1"),
        ("GALLIUM_DRIVER", "none-such"),
    ] {
        let found = Command::new(env!("CARGO_BIN_EXE_edgewalker"))
            .args(["--level", FLAT, "--size", "320x200"])
            .env("SDL_VIDEODRIVER", "x11")
            .env("DISPLAY", &server.display)
            .env(name, value)
            .output()
            .unwrap();
        let said = String::from_utf8(found.stderr).unwrap();
        assert_eq!(found.status.code(), Some(1), "{said}");
        for words in [
            "OpenGL 3.3, which the game needs",
            "LIBGL_ALWAYS_SOFTWARE=1",
        ] {
            assert!(said.contains(words), "{name}: {said}");
        }
        for word in ["X Error", "opcode", "panicked"] {
            assert!(!said.contains(word), "{name}: {said}");
        }
    }
}

fn fault(folder: &Path) {
    for number in 1..=2 {
        let mut game = Game::start("fault", folder, &[], None);
        let (status, said) = game.end();
        assert_eq!(status, Some(101), "{said}");
        let file = folder.join(format!("config/fault-{number}.replay"));
        for words in [
            "planted",
            "a fault of the game",
            "--replay",
            file.to_str().unwrap(),
        ] {
            assert!(said.contains(words), "{words}: {said}");
        }
        expect_prefix(&file, &game, 0);
    }
}

fn read_progress(folder: &Path) -> Progress {
    let text = fs::read_to_string(folder.join("progress.ron")).unwrap();
    ron::from_str(&text).unwrap_or_else(|e| panic!("{e}: {text}"))
}

fn progress(folder: &Path) {
    let mut game = Game::start("kept", folder, &[], None);
    game.watch();
    game.watch();
    game.signal("KILL");
    game.end();
    let &(_, _, deaths, seconds) = game.told.last().unwrap();
    let progress = read_progress(&folder.join("config"));
    let (_, run) = progress.unfinished().expect("a run was begun");
    assert!(deaths > 0 && run.deaths == deaths, "{run:?} {deaths}");
    assert!(run.seconds + 1.0 >= seconds, "{run:?} {seconds}");
}

fn several_games(folder: &Path) {
    // What a game leaves that is killed while it writes.
    let half = folder.join(".progress.ron.1.tmp");
    fs::write(&half, "half").unwrap();
    let names: Vec<String> = (0..4).map(|number| format!("game-{number}")).collect();
    let mut games: Vec<Game> = names
        .iter()
        .map(|name| Game::start("finishing", folder, &[name], None))
        .collect();
    // The last of them is killed in its turn, or between two.
    let mut killed = games.pop().unwrap();
    while killed.told.len() < 5 {
        assert!(killed.listen(), "{}", killed.complaint());
    }
    killed.signal("KILL");
    killed.end();
    for game in &mut games {
        let (status, said) = game.end();
        assert_eq!(status, Some(0), "{said}");
    }
    let progress = read_progress(folder);
    let done = |level: &str| progress.levels[level].finished;
    let of_killed = done(&names[3]);
    assert!((5..=ROUNDS).contains(&of_killed), "{of_killed}");
    for name in &names[..3] {
        assert_eq!(done(name), ROUNDS);
    }
    assert_eq!(done("all"), 3 * ROUNDS + of_killed);
    let found = &progress.levels["all"].found;
    assert_eq!(found.len() as u32, 3 * ROUNDS + of_killed);
    assert_eq!(
        progress.levels["all"].best_seconds,
        Some(f64::from(1001 - ROUNDS))
    );
    drop(Store::open(Some(folder)));
    assert!(!half.exists(), "what was half written is gone");
    let names = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name());
    let left: Vec<PathBuf> = names.map(PathBuf::from).collect();
    assert_eq!(left.len(), 2, "the progress and the lock: {left:?}");
}
