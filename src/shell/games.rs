//! Runs as players know them: begun, left, gone on with, finished; and what is kept of them.

use super::app::App;
use super::levels::Choice;
use super::menu::{Command, Screen};
use super::notices::Topic;
use super::play::Play;
use super::reload::Watch;
use super::runs::Feed;
use super::settings::progress::{Results, clock};
use crate::cli::load;
use crate::game::{Run, View, World};

/// Seconds from the goal to what the run came to.
const SAVOUR: f64 = 1.6;

impl App {
    /// A moment after the goal, what the run came to.
    pub(super) fn look_for_goal(&mut self) {
        let view = self.play.world.view();
        let goes_on = !self.paused && !self.controls.wants_retry();
        let is_played = matches!(self.feed, Feed::Player) && goes_on;
        let is_over = view.won_at.is_some_and(|won| view.time - won >= SAVOUR);
        if is_played && is_over {
            self.front.facts.results = Some(self.results(&view));
            self.open_menu(Screen::Results);
        }
    }

    /// What the run came to; what is kept is saved.
    pub(super) fn results(&mut self, view: &View) -> Results {
        let of = self.play.world.stage().secret_count() as u32;
        let secrets = (view.secrets, of);
        let Some(level) = self.front.kept.clone() else {
            let (seconds, deaths) = (view.run_time(), view.deaths);
            return Results {
                seconds,
                deaths,
                secrets,
                best_before: None,
            };
        };
        let progress = &mut self.front.store.progress;
        let results = progress.finish(&level, view.run_time(), view.deaths, secrets);
        self.save_progress();
        results
    }

    /// The run as it is now, in a line.
    pub(super) fn paused_run(&self) -> String {
        let view = self.play.world.view();
        let level = &self.play.world.stage().level;
        let area = level.areas.get(view.area);
        let place = area.map_or(&level.name, |area| &area.name);
        let deaths = match view.deaths {
            1 => "1 death".into(),
            deaths => format!("{deaths} deaths"),
        };
        format!("{place}   ·   {}   ·   {deaths}", clock(view.run_time()))
    }

    /// Sees what a tick has brought: a checkpoint is told and kept.
    pub(super) fn note_tick(&mut self) {
        let now = self
            .play
            .world
            .checkpoint()
            .map(|feature| feature.id.as_str());
        if now == self.front.checkpoint.as_deref() {
            return;
        }
        self.front.checkpoint = now.map(str::to_owned);
        if self.front.checkpoint.is_some() {
            self.hud.checkpoint();
            self.keep_run();
        }
    }

    /// Keeps the run as it is now, if runs are kept and it is not over.
    pub(super) fn keep_run(&mut self) {
        if let Some(level) = &self.front.kept
            && self.play.world.view().won_at.is_none()
        {
            self.front
                .store
                .progress
                .note(level, self.play.world.so_far());
            self.save_progress();
        }
    }

    /// Does what was chosen.
    pub(super) fn command(&mut self, command: Command) {
        match command {
            Command::Continue => self.go_on(),
            Command::Begin(level) => self.begin(level, None),
            Command::Resume => {
                self.close_menu();
                self.pause(false);
            }
            Command::Retry => {
                self.close_menu();
                self.pause(false);
                self.controls.ask_respawn();
            }
            Command::Restart => {
                self.close_menu();
                self.pause(false);
                self.controls.ask_retry();
            }
            Command::ToTitle => self.leave_for_title(),
            Command::Quit => self.quit = true,
        }
    }

    /// The run that was left.
    fn go_on(&mut self) {
        let unfinished = self.front.store.progress.unfinished();
        let Some((name, run)) = unfinished.map(|(name, run)| (name.to_owned(), run.clone())) else {
            return;
        };
        match self.front.levels.iter().position(|level| level.key == name) {
            Some(level) => self.begin(level, Some(&run)),
            None => self
                .notices
                .fail(Topic::Level, format!("{name} is not there any more")),
        }
    }

    /// A run in a level, from its start or from where it was left. A level that is broken is not entered.
    fn begin(&mut self, level: usize, run: Option<&Run>) {
        let Some(choice) = self.front.levels.get(level) else {
            return;
        };
        let Choice { path, key, .. } = choice.clone();
        let level_file = Watch::new(&path);
        let stage = match load::stage(&path) {
            Ok(stage) => stage,
            Err(error) => return self.notices.fail(Topic::Level, error),
        };
        self.notices.solve(Topic::Level);
        let mut world = World::new(stage, self.play.world.tick_rate(), self.seed);
        if run.is_some_and(|run| !world.resume(run)) {
            self.notices
                .say("The checkpoint is gone: the level begins anew");
        }
        self.front.checkpoint = world.checkpoint().map(|feature| feature.id.clone());
        self.enter(world);
        self.level_file = level_file;
        self.front.kept = Some(key);
        self.keep_run();
        self.close_menu();
        self.pause(false);
    }

    /// Back to the title, over the level as it begins. The run is kept.
    fn leave_for_title(&mut self) {
        self.keep_run();
        self.front.leave_run();
        let stage = self.play.world.stage().clone();
        self.enter(World::new(stage, self.play.world.tick_rate(), self.seed));
        self.pause(false);
        self.open_menu(Screen::Title);
    }

    /// Plays a world from now on.
    fn enter(&mut self, world: World) {
        self.play = Play::new(world, &self.tuning);
        self.feed = Feed::Player;
        self.hud.begin();
        self.hud.draw_curtain();
        self.enter_stage();
    }
}
