//! Runs as players know them: begun, left, gone on with, finished; and what is kept of them.

use super::app::App;
use super::front::Front;
use super::levels::Choice;
use super::loading::Then;
use super::menu::{Command, Screen};
use super::notices::Topic;
use super::play::Play;
use super::reload::Watch;
use super::runs::Feed;
use super::settings::progress::{Results, clock};
use crate::game::{Back, Input, Run, Stage, View, World};
use crate::level::Skill;
use std::sync::Arc;
use std::time::Duration;

/// Where the hero has come back between two moments of a run, if he has.
fn way_back(before: &View, now: &View) -> Option<&'static str> {
    let last = now.returned.filter(|_| now.returned != before.returned)?;
    if now.began_at != before.began_at {
        return None;
    }
    Some(match (last.back, now.checkpoint) {
        (Back::Last, Some(_)) => "Back at the checkpoint",
        (Back::Last, None) => "Back at the start",
        (Back::Earlier, _) => "The checkpoint is closed: back at an earlier one",
        (Back::Start, _) => "The checkpoint is closed: back at the start",
        (Back::Anew, _) => "The way back was closed: all that moves begins anew",
    })
}

/// Seconds from the goal to what the run came to.
const SAVOUR: f64 = 1.6;

/// Time after which a run is kept again though nothing has happened but that time has passed: what a kill loses at most,
/// beside the time of a save.
const KEEP: Duration = Duration::from_millis(500);

/// What a run had come to when it was last looked at.
#[derive(Default)]
pub struct Seen {
    pub(super) checkpoint: Option<String>,
    began_at: f64,
    counts: (u32, u32),
    has_won: bool,
    /// When it was begun or came to its checkpoint.
    reached: u64,
    /// What it came to at the goal.
    results: Option<Results>,
}

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

    /// What the run came to; what is kept was saved when it came to the goal.
    pub(super) fn results(&mut self, view: &View) -> Results {
        if let Some(results) = self.front.seen.results {
            return results;
        }
        Results {
            seconds: view.run_time(),
            deaths: view.deaths,
            secrets: (view.secrets, self.play.world.stage().secret_count() as u32),
            best_before: None,
            marked: view.marked,
        }
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

    /// Sees whether the player has done something for the first time, holding this: he is not told of it any more.
    pub(super) fn note_lesson(&mut self, input: Input) {
        let (view, look) = (self.play.world.view(), self.controls.look());
        let done = self.lessons.watch(&view, input, look);
        let is_played = matches!(self.feed, Feed::Player);
        if let Some(skill) = done.filter(|_| is_played)
            && self.front.store.progress.learnt.insert(skill)
        {
            self.save_progress();
        }
    }

    /// What the player is to be told where the hero is.
    pub(super) fn lesson(&self) -> Option<Skill> {
        let at = self.play.world.view().position;
        let learnt = &self.front.store.progress.learnt;
        let mut prompts = self.play.world.stage().level.prompts.iter();
        let prompt = prompts.find(|p| p.room.contains(at) && !learnt.contains(&p.skill));
        prompt.map(|prompt| prompt.skill)
    }

    /// Sees what a tick has brought: a checkpoint and a way back are told; checkpoints, deaths, secrets and the goal are kept at once.
    pub(super) fn note_tick(&mut self) {
        let (before, now) = self.play.moments();
        if let Some(words) = way_back(before, now) {
            self.notices.say(words);
        }
        let world = &self.play.world;
        let view = world.view();
        let checkpoint = world.checkpoint().map(|feature| feature.id.as_str());
        let seen = &self.front.seen;
        let is_new = checkpoint != seen.checkpoint.as_deref();
        let begins = view.began_at.to_bits() != seen.began_at.to_bits();
        let has_won = view.won_at.is_some();
        let counts = (view.deaths, view.secrets);
        if !is_new && !begins && counts == seen.counts && has_won == seen.has_won {
            return;
        }
        let checkpoint = checkpoint.map(str::to_owned);
        if is_new && checkpoint.is_some() {
            self.hud.checkpoint();
        }
        let arrives = has_won && !self.front.seen.has_won;
        self.see_run();
        if is_new || begins {
            self.stamp_run();
        }
        match arrives {
            true => self.finish_run(),
            false => self.keep_run(),
        }
    }

    /// What the run has come to counts as seen.
    fn see_run(&mut self) {
        let (world, view) = (&self.play.world, self.play.world.view());
        let seen = &mut self.front.seen;
        seen.checkpoint = world.checkpoint().map(|feature| feature.id.clone());
        (seen.began_at, seen.counts) = (view.began_at, (view.deaths, view.secrets));
        seen.has_won = view.won_at.is_some();
        seen.results = seen.results.filter(|_| seen.has_won);
    }

    /// The run has begun, or come to a checkpoint: just now.
    fn stamp_run(&mut self) {
        let Front {
            kept, store, seen, ..
        } = &mut self.front;
        seen.reached = kept.as_ref().map_or(0, |level| store.progress.stamp(level));
    }

    /// The run has come to the goal: that is kept, if runs are.
    fn finish_run(&mut self) {
        let Front {
            kept, store, seen, ..
        } = &mut self.front;
        let Some(level) = kept else {
            return;
        };
        let world = &self.play.world;
        let of = world.stage().secret_count() as u32;
        seen.results = Some(store.progress.finish(level, &world.so_far(), of));
        self.save_progress();
    }

    /// Keeps the run as it is now, if runs are kept and it is not over.
    pub(super) fn keep_run(&mut self) {
        let Front {
            kept, store, seen, ..
        } = &mut self.front;
        if let Some(level) = kept
            && self.play.world.view().won_at.is_none()
        {
            store
                .progress
                .note(level, self.play.world.so_far(), seen.reached);
            self.front.since_kept = Duration::ZERO;
            self.save_progress();
        }
    }

    /// Keeps the run's time as it goes on.
    pub(super) fn keep_run_at_times(&mut self, elapsed: Duration) {
        self.front.since_kept += elapsed;
        if self.front.since_kept >= KEEP && !self.paused {
            self.keep_run();
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
        self.load_level(&path, Then::Begin(key, run.cloned()));
    }

    /// A run in a level that is there.
    pub(super) fn begin_in(
        &mut self,
        stage: Arc<Stage>,
        key: String,
        run: Option<&Run>,
        level_file: Watch,
    ) {
        let mut world = World::new(stage, self.play.world.tick_rate(), self.seed);
        if run.is_some_and(|run| !world.resume(run)) {
            self.notices
                .say("The checkpoint is gone: the level begins anew");
        }
        self.tune_for(level_file.path());
        self.enter(world);
        self.level_file = level_file;
        self.log_anew(run);
        self.front.kept = Some(key);
        self.front.seen = Seen::default();
        self.see_run();
        self.stamp_run();
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
        self.log_anew(None);
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
