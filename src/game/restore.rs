//! Snapshots, taken and taken up again: whatever a text says is checked before a world trusts it.

use super::going::Going;
use super::meshes::Shape;
use super::replay::FASTEST;
use super::snapshot::{Snapshot, State};
use super::stage::{EditError, Stage};
use super::world::{HERO, World};
use crate::level::Kind;
use crate::mesh::{FeatureId, MeshError};
use crate::motion::{Trace, vet};
use crate::tune::Tuning;
use std::sync::Arc;
use xxhash_rust::xxh3::xxh3_64;

/// The latest time that a world may have come to, s: in three years at rest a tenth of a microsecond is still told.
const LATEST: f64 = 1e8;

/// Most shapes and most bodies of a snapshot.
const MOST: usize = 4096;

/// Why a snapshot cannot be taken up.
#[derive(Clone, Debug, PartialEq)]
pub enum RestoreError {
    /// It is of another level.
    OtherLevel,
    /// The stage has edits that the snapshot does not begin with.
    OtherEdits,
    /// One of its edits is refused.
    Edit(EditError),
    /// The level has no meshes for one of its shapes.
    Mesh(MeshError),
    /// Something in it cannot be true: what, in words.
    Broken(String),
}

impl std::fmt::Display for RestoreError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            RestoreError::OtherLevel => f.write_str("the snapshot is of another level"),
            RestoreError::OtherEdits => {
                f.write_str("the level was edited in another way than in the snapshot")
            }
            RestoreError::Edit(error) => write!(f, "an edit of the snapshot: {error}"),
            RestoreError::Mesh(error) => write!(f, "a shape of the snapshot: {error}"),
            RestoreError::Broken(what) => write!(f, "the snapshot is broken: {what}"),
        }
    }
}

impl std::error::Error for RestoreError {}

impl World {
    /// The whole state, at this moment between two ticks.
    pub fn snapshot(&self) -> Snapshot {
        let mut snapshot = Snapshot {
            fingerprint: self.stage.fingerprint(),
            edits: self.stage.edits().to_vec(),
            sum: 0,
            state: self.state.clone(),
        };
        snapshot.sum = snapshot.hash();
        snapshot
    }

    /// The world of a snapshot, in the stage that it was taken in, or in the same before some of its edits.
    ///
    /// # Errors
    /// If the stage is another one, or the snapshot says what cannot be true.
    pub fn restore(mut stage: Arc<Stage>, snapshot: Snapshot) -> Result<World, RestoreError> {
        let is_whole = snapshot.sum == snapshot.hash();
        let Snapshot {
            fingerprint,
            edits,
            state,
            ..
        } = snapshot;
        if stage.fingerprint() != fingerprint {
            return Err(RestoreError::OtherLevel);
        }
        state.vet_counts().map_err(RestoreError::Broken)?;
        if !is_whole {
            return Err(RestoreError::Broken("it was changed".into()));
        }
        let missing = edits.strip_prefix(stage.edits());
        for edit in missing.ok_or(RestoreError::OtherEdits)?.to_vec() {
            let stage = Arc::make_mut(&mut stage);
            stage.edit(edit).map_err(RestoreError::Edit)?;
        }
        for shape in &state.shapes {
            stage.land(shape).map_err(RestoreError::Mesh)?;
        }
        let bodies = state.actors.len();
        let world = World {
            lands: Arc::new(state.lands(&stage)),
            traces: vec![Trace::default(); bodies],
            done: vec![0; bodies],
            told: vec![0; bodies],
            stage,
            state,
        };
        world.vet().map_err(RestoreError::Broken)?;
        Ok(world)
    }

    /// Checks what its state says about its level, and each of its bodies.
    fn vet(&self) -> Result<(), String> {
        let (state, stage) = (&self.state, &self.stage);
        let movers = stage.level.movers.len();
        let is_all = |going: &[Going]| going.len() == movers;
        require(is_all(&state.going), "it knows of other movers")?;
        let is = |id: FeatureId, kind: Kind| stage.feature(id).is_some_and(|f| f.kind == kind);
        let known = |id: FeatureId| (id as usize) < stage.traits().len();
        let visits = || state.visited.iter();
        require(
            visits().all(|visit| known(visit.checkpoint) && is_all(&visit.going)),
            "it knows checkpoints that are not there",
        )?;
        require(
            state
                .secrets
                .iter()
                .all(|&id| known(id) && stage.feature(id).is_none_or(|_| is(id, Kind::Secret))),
            "it knows secrets that are not there",
        )?;
        let last = stage.level.areas.len().max(1);
        require(state.area < last, "its area is not there")?;
        let now = self.time();
        let goings = visits().flat_map(|visit| &visit.going).chain(&state.going);
        let starts = goings.filter_map(|going| going.start);
        let times = state.times().into_iter().chain(starts);
        let bad = times.into_iter().find(|t| !(-LATEST..=LATEST).contains(t));
        require(bad.is_none(), "one of its times is none")?;
        let until = state.away.map(|away| (away.until.unwrap_or(now), away.at));
        require(
            until.is_none_or(|(t, at)| t >= now && t.is_finite() && at.is_finite()),
            "the hero comes back in the past",
        )?;
        for (number, actor) in state.actors.iter().enumerate() {
            let terrain = self.lands[actor.shape].terrain(stage, &state.tuning);
            vet(&actor.body, now, &terrain).map_err(|what| format!("body {number}: {what}"))?;
            let run = actor.control.run;
            require(run.is_finite(), "a body wants what is no number")?;
        }
        Ok(())
    }
}

impl Snapshot {
    /// Hash of all but itself. Whoever changes a snapshot by hand must say so here; even then nothing in it is trusted.
    fn hash(&self) -> u64 {
        let text = ron::to_string(&(&self.edits, &self.state));
        xxh3_64(text.expect("a state is plain data").as_bytes())
    }
}

impl State {
    /// Counts and rates, before anything is made of them.
    fn vet_counts(&self) -> Result<(), String> {
        require((1..=FASTEST).contains(&self.rate), "its tick rate is none")?;
        let time = self.tick as f64 / f64::from(self.rate);
        require(time <= LATEST, "its time is too far off")?;
        let shapes = self.shapes.len();
        require(
            (1..=MOST).contains(&shapes),
            "it has no shapes, or too many",
        )?;
        let hero = self.shapes[HERO] == Shape::hero();
        let bodies = (1..=MOST).contains(&self.actors.len());
        let first = bodies && self.actors[HERO].shape == HERO;
        require(hero && first, "its first body is not the hero")?;
        require(
            self.actors.iter().all(|actor| actor.shape < shapes),
            "a body has a shape that is not there",
        )?;
        let tuning = Tuning {
            motion: self.tuning.clone(),
            ..Tuning::default()
        };
        tuning.check().map_err(|error| error.to_string())
    }

    /// Every number in it that is a time or lasts like one.
    fn times(&self) -> Vec<f64> {
        let some = [
            self.won_at,
            self.secret_at,
            self.away.map(|a| a.since),
            self.returned.map(|r| r.at),
        ];
        let always = [
            self.facing,
            self.left_at,
            self.held_at,
            self.ledge_at,
            self.landed_at,
            self.landed_speed,
            self.began_at,
        ];
        some.into_iter().flatten().chain(always).collect()
    }
}

fn require(ok: bool, what: &str) -> Result<(), String> {
    if ok { Ok(()) } else { Err(what.to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::Input;
    use crate::level;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    /// A hall with everything that a state can name: a belt, stairs, a ladder, a lift, a pusher, a door with its button, a camp.
    const HALL: &str = r#"(version: 1, name: "hall", start: (0, 0), goal: (min: (90, 0), max: (91, 1)), bottom: -9,
        areas: [(name: "a", room: (min: (-9, -9), max: (9, 9)), mood: Dusk)],
        features: [
            (id: "floor", outline: [(-20,-2),(20,-2),(20,0),(-20,0)]),
            (id: "ramp", outline: [(3,-1),(9,-1),(9,1.5)]),
            (id: "rungs", kind: Ladder, outline: [(-6,0),(-5,0),(-5,5),(-6,5)]),
            (id: "camp", kind: Checkpoint, respawn: Some((0,0)), outline: [(-1,0),(1,0),(1,2),(-1,2)]),
            (id: "cave", kind: Secret, outline: [(-1,0),(1,0),(1,2),(-1,2)]),
            (id: "button", kind: Trigger, outline: [(-3,0),(-2,0),(-2,2),(-3,2)])],
        movers: [
            (id: "lift", features: [(id: "deck", outline: [(-2,-0.5),(2,-0.5),(2,0.25),(-2,0.25)])],
                path: [(at: (0,-1), wait: 0.2, seconds: 1, easing: Eased),(at: (0,2), seconds: 1)]),
            (id: "door", features: [(id: "leaf", outline: [(10,0),(11,0),(11,4),(10,4)])],
                path: [(at: (0,0), seconds: 1),(at: (0,3))], repeat: Once, starts: On("button"))])"#;

    fn stage() -> Arc<Stage> {
        let level = level::parse(HALL, "hall.ron".as_ref());
        let level = level.unwrap_or_else(|error| panic!("{error}"));
        Arc::new(Stage::build(level).unwrap_or_else(|error| panic!("{error}")))
    }

    /// A run that walks, jumps, climbs, rides and is pressed, and a second body.
    fn input(tick: u64) -> Input {
        Input {
            run: [127, -127, -127, 60, 0][(tick / 17 % 5) as usize],
            jump: tick % 50 < 20,
            down: tick % 90 > 75,
            up: tick % 40 > 25,
            respawn: tick % 333 == 100,
            ..Input::default()
        }
    }

    /// So many events in a hundred ticks are more than any honest world has.
    const MUCH: u64 = 100_000;

    /// Plays some ticks; how many events that were.
    fn steps(world: &mut World, ticks: u64) -> u64 {
        let mut work = 0;
        for _ in 0..ticks {
            let input = input(world.tick());
            world.step(input, &Tuning::default());
            let traces = world.traces.iter();
            work += traces
                .map(|t| t.crossed + t.passed + t.touched + t.events.len() as u64)
                .sum::<u64>();
        }
        work
    }

    /// Where the numbers of a text are.
    fn numbers(text: &str) -> Vec<(usize, usize)> {
        let bytes = text.as_bytes();
        let is_word = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'.' | b'-' | b'+');
        let mut found = Vec::new();
        let mut i = 0;
        while i < bytes.len() {
            let end = (i..bytes.len())
                .find(|&j| !is_word(bytes[j]))
                .unwrap_or(bytes.len());
            if end > i && (bytes[i].is_ascii_digit() || bytes[i] == b'-') {
                found.push((i, end));
            }
            i = end.max(i + 1);
        }
        found
    }

    /// What becomes of a snapshot with a number changed: refused, or a world that goes on; `whole` says that it was made by hand
    /// and is meant so.
    fn tried(stage: &Arc<Stage>, text: &str, whole: bool) -> Result<bool, String> {
        let Ok(mut snapshot) = ron::from_str::<Snapshot>(text) else {
            return Ok(false);
        };
        if whole {
            snapshot.sum = snapshot.hash();
        }
        let ran = catch_unwind(AssertUnwindSafe(|| {
            let mut world = World::restore(Arc::clone(stage), snapshot).ok()?;
            Some(steps(&mut world, 100))
        }));
        match ran {
            Err(_) => Err("panics".into()),
            Ok(Some(work)) if work > MUCH => Err(format!("{work} events")),
            Ok(went_on) => Ok(went_on.is_some()),
        }
    }

    #[test]
    fn a_snapshot_with_any_number_changed_is_refused_or_goes_on() {
        let stage = stage();
        let mut world = World::new(Arc::clone(&stage), 120, 0);
        world
            .add_body(&Shape::hero(), glam::DVec2::new(-5.5, 0.5))
            .unwrap();
        let values = [
            "0",
            "-1",
            "1",
            "7",
            "4000000000",
            "1e300",
            "NaN",
            "inf",
            "-1e-3",
            "0.5",
        ];
        let (mut tries, mut went_on, mut faults) = (0, 0, Vec::new());
        for round in 0..8 {
            steps(&mut world, 61 + 7 * round);
            let text = ron::to_string(&world.snapshot()).unwrap();
            assert_eq!(tried(&stage, &text, false), Ok(true));
            for (from, to) in numbers(&text) {
                for value in values {
                    let changed = format!("{}{value}{}", &text[..from], &text[to..]);
                    if changed == text {
                        continue;
                    }
                    let seal = tried(&stage, &changed, false);
                    let same =
                        ron::from_str::<Snapshot>(&changed).is_ok_and(|s| s == world.snapshot());
                    assert!(same || seal == Ok(false), "{value} at {from}: {seal:?}");
                    tries += 1;
                    match tried(&stage, &changed, true) {
                        Ok(goes_on) => went_on += u32::from(goes_on),
                        Err(fault) => faults.push(format!(
                            "{} -> {value}: {fault}",
                            &text[from.saturating_sub(40)..to]
                        )),
                    }
                }
            }
        }
        println!("{tries} changes, {went_on} worlds that went on");
        assert!(tries > 10_000, "{tries}");
        assert!(
            faults.is_empty(),
            "{} faults: {:#?}",
            faults.len(),
            &faults[..faults.len().min(40)]
        );
    }
}
