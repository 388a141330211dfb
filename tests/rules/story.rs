//! A run as a story that does not depend on the tick rate: what happened, and when.

use edgewalker::game::{Input, Stage, View, World};
use edgewalker::level;
use edgewalker::motion::EventKind;
use edgewalker::tune::Tuning;
use glam::DVec2;
use std::sync::Arc;

/// The rates at which every story is the same.
pub const RATES: [u32; 6] = [10, 30, 60, 120, 240, 1000];

/// What is told of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Story {
    /// Deaths, and all comings into regions, with their times.
    pub events: Vec<(f64, EventKind)>,
    /// When he came back.
    pub returns: Vec<f64>,
    /// At the end of each stretch of input: where he is, and hash of his body.
    pub ends: Vec<(DVec2, u64)>,
    /// At the end.
    pub last: View,
    /// When each mover had started.
    pub offsets: Vec<DVec2>,
}

/// A level out of its text.
pub fn stage(text: &str) -> Arc<Stage> {
    let level = level::parse(text, "test.ron".as_ref()).unwrap_or_else(|error| panic!("{error}"));
    Arc::new(Stage::build(level).unwrap_or_else(|error| panic!("{error}")))
}

/// A floor from -20 to 20 at height 0, and more; the goal is far away.
pub fn hall(features: &str, movers: &str) -> String {
    format!(
        "(version: 1, name: \"hall\", start: (0, 0), goal: (min: (900, 0), max: (901, 1)), bottom: -20, \
         features: [(id: \"floor\", outline: [(-20,-2),(20,-2),(20,0),(-20,0)]), {features}], movers: [{movers}])"
    )
}

/// To the right (1), to the left (-1) or at rest (0).
pub fn run(run: i8) -> Input {
    Input {
        run: 127 * run,
        ..Input::default()
    }
}

/// Nothing but to go back to the last checkpoint.
pub fn back() -> Input {
    Input {
        respawn: true,
        ..Input::default()
    }
}

/// Nothing but a new run.
pub fn anew() -> Input {
    Input {
        retry: true,
        ..Input::default()
    }
}

/// Plays tenths of seconds of inputs in a world, and watches every invariant.
pub fn play(world: &mut World, script: &[(u32, Input)]) -> Story {
    let rate = world.tick_rate();
    let mut story = Story {
        events: Vec::new(),
        returns: Vec::new(),
        ends: Vec::new(),
        last: world.view(),
        offsets: Vec::new(),
    };
    for &(tenths, input) in script {
        for _ in 0..tenths * rate / 10 {
            world.step(input, &Tuning::default());
            world
                .check()
                .unwrap_or_else(|error| panic!("{rate} Hz, {} s: {error}", world.time()));
            let events = world.trace().events.iter();
            let told = events.map(|event| (event.time, event.kind));
            let counts = |kind: &EventKind| {
                matches!(
                    kind,
                    EventKind::Entered(_) | EventKind::Crushed | EventKind::Landed(_)
                )
            };
            story.events.extend(told.filter(|(_, kind)| counts(kind)));
            if let Some(last) = world.view().returned
                && story.returns.last() != Some(&last.at)
            {
                story.returns.push(last.at);
            }
        }
        story
            .ends
            .push((world.view().position, world.hero().hash()));
    }
    story.last = world.view();
    story.offsets = world.offsets_at(world.time()).collect();
    story
}

/// The story of a script at every rate; it is the same.
pub fn told(text: &str, script: &[(u32, Input)]) -> Story {
    let stage = stage(text);
    let mut stories = RATES.iter().map(|&rate| {
        let mut world = World::new(Arc::clone(&stage), rate, 0);
        (rate, play(&mut world, script))
    });
    let (_, first) = stories.next().unwrap();
    for (rate, story) in stories {
        assert_eq!(story, first, "{rate} Hz");
    }
    first
}
