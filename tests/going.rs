//! What moves and what makes it: regions on movers, movers that begin when they are ridden or called, and that come back. All of it
//! at exact times, the same at every tick rate.

#[path = "common/hall.rs"]
mod hall;
#[path = "common/worlds.rs"]
mod worlds;

use edgewalker::game::{Input, Shape, Stage, World};
use edgewalker::level::{self, By, Call, End, Feature, Kind, Mover, Repeat, Starts, Stop};
use edgewalker::motion::{Event, EventKind};
use edgewalker::tune::Tuning;
use glam::DVec2;
use hall::{block, region, world};
use std::path::Path;
use std::sync::Arc;
use worlds::Dice;

const RATES: [u32; 5] = [30, 60, 120, 240, 1000];

/// Gravity 30 and no other law of the fall.
fn tuning() -> Tuning {
    let mut tuning = Tuning::default();
    let t = &mut tuning.motion;
    (t.gravity, t.apex_gravity, t.fall_speed) = (30.0, 1.0, 1e3);
    tuning
}

/// A game, and what has happened to the hero in it.
struct Game {
    world: World,
    events: Vec<Event>,
}

impl Game {
    fn new(features: &[Feature], movers: &[Mover], rate: u32) -> Game {
        let world = world(features, movers, rate);
        let events = Vec::new();
        Game { world, events }
    }

    fn step(&mut self, input: Input) {
        self.world.step(input, &tuning());
        self.world.check().unwrap();
        self.events.extend(&self.world.trace().events);
    }

    /// Plays until a time that all rates share, to the right (1), to the left (-1) or at rest (0).
    fn play(&mut self, until: f64, run: i8) {
        let input = Input {
            run: 127 * run,
            ..Input::default()
        };
        while self.world.time() < until {
            self.step(input);
        }
    }

    /// The times of all events of a kind.
    fn times(&self, wanted: impl Fn(EventKind) -> bool) -> Vec<f64> {
        let events = self.events.iter().filter(|event| wanted(event.kind));
        events.map(|event| event.time).collect()
    }

    /// How far the first mover is from where it was drawn.
    fn offset(&self) -> DVec2 {
        let offset = self.world.offsets_at(self.world.time()).next();
        offset.expect("a mover")
    }
}

/// The same story at every rate: what a test tells must be equal.
fn at_every_rate<T: PartialEq + std::fmt::Debug>(tell: impl Fn(u32) -> T) -> T {
    let first = tell(RATES[0]);
    for rate in &RATES[1..] {
        assert_eq!(tell(*rate), first, "{rate} Hz");
    }
    first
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-11, "{a} is {:e} from {b}", (a - b).abs());
}

fn stop(x: f64, y: f64, seconds: f64) -> Stop {
    Stop {
        at: DVec2::new(x, y),
        seconds,
        ..Stop::default()
    }
}

/// Features that go a way once, at an even speed.
fn going(features: Vec<Feature>, way: (f64, f64), seconds: f64) -> Mover {
    Mover {
        id: "mover".into(),
        features,
        path: vec![stop(0.0, 0.0, seconds), stop(way.0, way.1, 0.0)],
        repeat: Repeat::Once,
        ..Mover::default()
    }
}

/// A deck from 2 to 5 m, its top 1 m up, that rises 4 m in 2 s when it is ridden, and comes back 1 s after that.
fn lift() -> Mover {
    Mover {
        starts: Starts::Ridden,
        back: Some(1.0),
        ..going(
            vec![block("deck", Kind::Solid, (2.0, 0.5), (5.0, 1.0))],
            (0.0, 4.0),
            2.0,
        )
    }
}

#[test]
fn a_hazard_that_moves_kills_a_hero_at_rest_at_its_own_time() {
    // Its front is at -11 + 4 t, and stops at -3: it comes to him, who stands at -5, at 1.5 s.
    let saw = || {
        going(
            vec![region("saw", Kind::Hazard, -12.0, -11.0)],
            (8.0, 0.0),
            2.0,
        )
    };
    let times = at_every_rate(|rate| {
        let mut game = Game::new(&[], &[saw()], rate);
        game.world.put(DVec2::new(-5.0, 0.0)).unwrap();
        game.play(3.0, 0);
        let id = game.world.stage().features().find(|f| f.1.id == "saw");
        let id = id.unwrap().0;
        assert_eq!(game.world.view().deaths, 1, "{rate} Hz");
        assert_eq!(game.world.view().position, DVec2::ZERO);
        game.times(|kind| kind == EventKind::Entered(id))
    });
    near(times[0], 1.5);
    assert_eq!(times.len(), 1);
}

#[test]
fn a_goal_a_secret_and_a_trigger_that_move_come_to_the_hero() {
    // All go by at 4 m/s, 2 m behind each other; the trigger opens a door.
    let parts = vec![
        region("treasure", Kind::Secret, -9.0, -8.0),
        region("plate", Kind::Trigger, -11.0, -10.0),
        region("end", Kind::Goal, -13.0, -12.0),
    ];
    let door = Mover {
        id: "door".into(),
        starts: Starts::On("plate".into()),
        ..going(
            vec![block("leaf", Kind::Solid, (10.0, 0.0), (11.0, 4.0))],
            (0.0, 4.0),
            1.0,
        )
    };
    let (secret, won, height) = at_every_rate(|rate| {
        let cart = going(parts.clone(), (16.0, 0.0), 4.0);
        let mut game = Game::new(&[], &[door.clone(), cart], rate);
        game.play(2.8, 0);
        let height = game.offset().y;
        game.play(3.3, 0);
        let view = game.world.view();
        (view.secret_at.unwrap(), view.won_at.unwrap(), height)
    });
    near(secret, 2.0);
    near(won, 3.0);
    near(height, 4.0 * 0.3);
}

#[test]
fn the_place_of_return_of_a_checkpoint_that_moves_rides_along() {
    // A deck goes at 2 m/s; he dies at 1 s and at 3.5 s, and is set on it where it is then, as fast as it is.
    let rest = Feature {
        respawn: Some(DVec2::new(4.5, 1.5)),
        ..block("rest", Kind::Checkpoint, (3.5, 1.25), (4.5, 4.0))
    };
    let cart = going(
        vec![block("deck", Kind::Solid, (2.0, 1.0), (6.0, 1.5)), rest],
        (20.0, 0.0),
        10.0,
    );
    at_every_rate(|rate| {
        let mut game = Game::new(&[], std::slice::from_ref(&cart), rate);
        game.world.put(DVec2::new(3.0, 1.5)).unwrap();
        game.play(0.3, 1);
        for died in [1.0, 3.5] {
            game.play(died, 0);
            game.step(Input {
                respawn: true,
                ..Input::default()
            });
            for later in [0.5, 1.5] {
                game.play(died + later, 0);
                let place = DVec2::new(4.5 + 2.0 * (died + later), 1.5);
                let off = game.world.view().position - place;
                assert!(off.length() < 1e-12, "{rate} Hz: {off}");
                assert_eq!(game.world.hero().carrier(), Some(0));
            }
        }
        assert_eq!(game.world.view().deaths, 2);
        game.world.hero().hash()
    });
}

#[test]
fn a_lift_begins_when_somebody_lands_on_it_and_comes_back_when_nobody_is_on_it() {
    let fall = f64::sqrt(4.0 / 30.0);
    let (begun, left) = at_every_rate(|rate| {
        let mut game = Game::new(&[], &[lift()], rate);
        game.play(0.5, 0);
        assert_eq!(game.offset(), DVec2::ZERO, "nobody rides it");
        game.world.put(DVec2::new(3.5, 3.0)).unwrap();
        game.play(1.5, 0);
        let begun = game.times(|kind| kind == EventKind::Mounted(0))[0];
        near(game.offset().y, 2.0 * (1.5 - begun));
        assert_eq!(game.world.view().position.y, 1.0 + game.offset().y);
        // Up there it stays as long as he stands on it, and a second longer.
        game.play(5.0, 0);
        assert_eq!(game.offset().y, 4.0);
        game.play(6.0, 1);
        // Where it has stopped dead he has been tossed up, and has come down again.
        let left = game.times(|kind| kind == EventKind::Dismounted(0));
        let left = *left.last().unwrap();
        game.play(7.0, 0);
        near(game.offset().y, 4.0 - 2.0 * (7.0 - left - 1.0));
        game.play(10.0, 0);
        assert_eq!(game.offset(), DVec2::ZERO);
        // It waits again.
        game.world.put(DVec2::new(3.5, 1.0)).unwrap();
        game.play(10.5, 0);
        near(game.offset().y, 1.0);
        (begun, left)
    });
    near(begun, 0.5 + fall);
    assert!(left > 5.0 && left < 6.0, "{left}");
}

#[test]
fn a_hop_on_a_lift_puts_off_its_way_back_by_its_whole_wait() {
    at_every_rate(|rate| {
        let mut game = Game::new(&[], &[lift()], rate);
        game.world.put(DVec2::new(3.5, 1.0)).unwrap();
        game.play(3.0, 0);
        // A hop of about 0.8 s, which is less than a second: it is still there for him.
        let jump = Input {
            jump: true,
            ..Input::default()
        };
        while game.world.time() < 3.1 {
            game.step(jump);
        }
        game.play(6.0, 0);
        assert_eq!(game.offset().y, 4.0);
        let mounted = game.times(|kind| kind == EventKind::Mounted(0));
        assert_eq!(game.world.hero().rides(), Some(0));
        mounted.last().copied()
    });
}

#[test]
fn who_boards_a_lift_on_its_way_home_is_taken_out_again() {
    at_every_rate(|rate| {
        let mut game = Game::new(&[], &[lift()], rate);
        game.world.put(DVec2::new(3.5, 1.0)).unwrap();
        game.play(2.5, 0);
        game.world.put(DVec2::new(-9.0, 0.0)).unwrap();
        // Up at 2 s; alone since 2.5 s, it goes home at 3.5 s and is there at 5.5 s.
        game.play(4.5, 0);
        near(game.offset().y, 2.0);
        game.world.put(DVec2::new(3.5, 1.0 + 2.0)).unwrap();
        game.play(5.5, 0);
        assert_eq!(game.offset().y, 0.0, "first it comes home");
        game.play(6.5, 0);
        near(game.offset().y, 2.0);
        game.world.hero().hash()
    });
}

#[test]
fn another_body_rides_as_well_as_the_hero() {
    at_every_rate(|rate| {
        let mut game = Game::new(&[], &[lift()], rate);
        let twin = game.world.add_body(&Shape::hero(), DVec2::new(3.5, 1.0));
        let twin = twin.unwrap();
        game.play(1.0, 0);
        near(game.offset().y, 2.0);
        assert_eq!(game.world.bodies().nth(twin).unwrap().rides(), Some(0));
        game.world.hero().hash()
    });
}

#[test]
fn who_touches_the_side_of_a_lift_or_passes_under_it_does_not_ride_it() {
    let mut game = Game::new(&[], &[lift()], 120);
    game.play(3.0, 1);
    assert_eq!(game.offset(), DVec2::ZERO);
    assert!(game.world.view().position.x < 2.0, "stopped by its side");
}

/// A lift that only triggers move, from 0 to 4 m in 2 s.
fn elevator() -> Mover {
    let call = |by: &str, to| Call { by: by.into(), to };
    Mover {
        starts: Starts::On("go".into()),
        calls: vec![call("up", End::Last), call("down", End::First)],
        ..going(
            vec![block("deck", Kind::Solid, (20.0, 0.5), (23.0, 1.0))],
            (0.0, 4.0),
            2.0,
        )
    }
}

/// Regions that come to the hero one after the other, at 4 m/s, the first one after a second.
fn calls(ids: &[(&str, f64)]) -> Mover {
    let part = |&(id, at): &(&str, f64)| Feature {
        by: Some(By::Foot),
        ..block(
            id,
            Kind::Trigger,
            (-4.0 * at - 0.25, -0.5),
            (-4.0 * at, 3.0),
        )
    };
    Mover {
        id: "calls".into(),
        ..going(ids.iter().map(part).collect(), (80.0, 0.0), 20.0)
    }
}

#[test]
fn a_lift_comes_where_it_is_called_after_it_has_come_to_the_end_of_its_way() {
    // Called up at 1 s, and down at 1.5 s: up at 3 s, down at 5 s. Then nothing calls it.
    at_every_rate(|rate| {
        let movers = [
            elevator(),
            calls(&[("up", 1.0), ("down", 1.5), ("go", 9.0)]),
        ];
        let mut game = Game::new(&[], &movers, rate);
        let mut heights = Vec::new();
        for tick in 1..=16 {
            game.play(f64::from(tick) * 0.5, 0);
            heights.push(game.offset().y);
        }
        let t = |n: usize| (n + 1) as f64 * 0.5;
        for (n, height) in heights.iter().enumerate() {
            let up = (2.0 * (t(n) - 1.0)).clamp(0.0, 4.0);
            let down = (2.0 * (t(n) - 3.0)).clamp(0.0, 4.0);
            near(*height, up - down);
        }
        game.world.hero().hash()
    });
}

#[test]
fn a_call_to_where_a_mover_is_changes_nothing() {
    at_every_rate(|rate| {
        // Down while it is there; up, and up again; down from the top, at once.
        let at = [("down", 1.0), ("go", 2.0)];
        let movers = [elevator(), calls(&at)];
        let mut game = Game::new(&[], &movers, rate);
        game.play(1.7, 0);
        assert_eq!(game.offset(), DVec2::ZERO);
        game.play(3.0, 0);
        near(game.offset().y, 2.0);
        game.play(9.0, 0);
        near(game.offset().y, 4.0);
        game.world.hero().hash()
    });
    at_every_rate(|rate| {
        let movers = [elevator(), calls(&[("go", 1.0), ("down", 5.0)])];
        let mut game = Game::new(&[], &movers, rate);
        game.play(6.0, 0);
        near(game.offset().y, 2.0);
        game.play(8.0, 0);
        assert_eq!(game.offset().y, 0.0);
        game.world.hero().hash()
    });
}

#[test]
fn what_is_known_of_a_way_is_in_snapshots_and_a_restart_forgets_it() {
    for until in [1.0, 2.25, 3.5, 5.0] {
        let movers = [lift(), calls(&[("up", 1.0)])];
        let mut game = Game::new(&[], &movers, 120);
        game.world.put(DVec2::new(3.5, 1.0)).unwrap();
        game.play(2.25_f64.min(until), 0);
        if until > 2.25 {
            game.world.put(DVec2::new(-9.0, 0.0)).unwrap();
        }
        game.play(until, 0);
        let snapshot = game.world.snapshot();
        let stage = game.world.stage().clone();
        let mut other = World::restore(stage, snapshot).unwrap();
        assert_eq!(other.hash(), game.world.hash());
        for _ in 0..600 {
            game.step(Input::default());
            other.step(Input::default(), &tuning());
            assert_eq!(other.hash(), game.world.hash(), "from {until} s on");
        }
    }
    let mut game = Game::new(&[], &[lift()], 120);
    game.world.put(DVec2::new(3.5, 1.0)).unwrap();
    game.play(1.0, 0);
    game.step(Input {
        retry: true,
        ..Input::default()
    });
    game.play(3.0, 0);
    assert_eq!(game.offset(), DVec2::ZERO);
}

#[test]
fn the_order_of_movers_in_the_file_changes_nothing() {
    let saw = Mover {
        id: "saw".into(),
        ..going(
            vec![region("teeth", Kind::Hazard, 4.0, 5.0)],
            (-40.0, 0.0),
            20.0,
        )
    };
    let movers = [
        lift(),
        calls(&[("go", 1.0), ("up", 2.0)]),
        saw,
        Mover {
            id: "other".into(),
            ..elevator()
        },
    ];
    let story = |order: [usize; 4]| {
        let mut movers = order.map(|i| movers[i].clone());
        let [deck, other] = ["mover", "other"].map(|id| movers.iter().position(|m| m.id == id));
        movers[other.unwrap()].features[0].id = "other deck".into();
        let mut game = Game::new(&[], &movers, 120);
        game.world.put(DVec2::new(3.5, 2.0)).unwrap();
        let mut seen = Vec::new();
        for tick in 0..800 {
            let run = [0, 0, -1, 0, 1][tick / 160];
            game.play((tick + 1) as f64 / 120.0, run);
            let offsets: Vec<_> = game.world.offsets_at(game.world.time()).collect();
            let view = game.world.view();
            let at = [deck, other].map(|i| offsets[i.unwrap()]);
            seen.push((view.position, view.velocity, view.deaths, at));
        }
        seen
    };
    let first = story([0, 1, 2, 3]);
    for order in [[3, 2, 1, 0], [1, 3, 0, 2]] {
        assert_eq!(story(order), first, "{order:?}");
    }
}

/// Places of the level of rides: the floor, the lift, the ferry, the chain, the last lift.
const PLACES: [(f64, f64); 5] = [
    (-6.0, 0.0),
    (22.0, 0.5),
    (36.0, 6.25),
    (53.5, 8.0),
    (71.0, 6.5),
];

/// Half a minute of wishes from there, each for a fifth of a second or more, and all that comes of it.
fn minute(stage: &Arc<Stage>, place: usize, rate: u32) -> (Vec<Event>, Vec<u64>, u32) {
    let mut dice = Dice::new(place as u64);
    let mut world = World::new(Arc::clone(stage), rate, 0);
    world.put(PLACES[place].into()).unwrap();
    let (mut events, mut hashes, mut input) = (Vec::new(), Vec::new(), Input::default());
    for stretch in 1..=150 {
        if dice.below(3) > 0 {
            input = Input {
                run: [127, 127, 0, 64, -127, 0][dice.below(6) as usize],
                jump: dice.below(4) == 0,
                down: dice.below(8) == 0,
                up: dice.below(3) == 0,
                ..Input::default()
            };
        }
        while world.time() < f64::from(stretch) / 5.0 {
            world.step(input, &Tuning::default());
            world.check().unwrap();
            events.extend(&world.trace().events);
        }
        hashes.push(world.hero().hash());
    }
    (events, hashes, world.view().deaths)
}

#[test]
fn the_rides_have_the_same_bits_at_every_rate() {
    let level = level::load(Path::new("levels/dev/rides.ron")).unwrap();
    let stage = Arc::new(Stage::build(level).unwrap());
    let mut all = Vec::new();
    for place in 0..PLACES.len() {
        let (events, ..) = at_every_rate(|rate| minute(&stage, place, rate));
        all.extend(events.iter().map(|event| event.kind));
    }
    let has = |wanted: fn(&EventKind) -> bool| all.iter().filter(|kind| wanted(kind)).count();
    assert!(has(|k| matches!(k, EventKind::Mounted(_))) > 2);
    assert!(has(|k| *k == EventKind::Climbed) > 0);
    assert!(has(|k| matches!(k, EventKind::Entered(_))) > 5);
}
