//! Which movement follows which event, when it begins, and that no change of it is a jump.

use super::{RIG, Slope, running};
use edgewalker::anim::{Act, Bone, Figure, Kind, Leap, Moves, Shown, Support, angle_between};
use glam::{DVec2, Vec2};

const TICK: f64 = 1.0 / 120.0;
/// The most that a bone may turn in a tick, in radians: a thigh is that fast in a run of 8 m/s.
const LARGEST_TURN: f32 = 0.49;

fn falling(time: f64) -> Moves {
    Moves {
        time,
        velocity: DVec2::new(0.0, -5.0),
        support: Support::Air,
        normal: Vec2::ZERO,
        left: (0.0, Leap::Walked),
        ..Moves::standing(DVec2::ZERO)
    }
}

/// The largest turn of a bone from one moment to the next, and whose.
fn largest_turn(a: &Shown, b: &Shown) -> (f32, usize) {
    let bones = RIG.model.skeleton.joints.len();
    let turn = |i: usize| angle_between(a.pose.bones[i].turn, b.pose.bones[i].turn);
    // What hangs swings freely.
    let hangs = |i: &usize| {
        let name = &RIG.model.skeleton.joints[*i].name;
        ["cape", "lantern", "crest"]
            .iter()
            .any(|tail| name.starts_with(tail))
    };
    let turns = (0..bones).filter(|i| !hangs(i)).map(|i| (turn(i), i));
    turns.fold(
        (0.0, 0),
        |best, next| if next.0 > best.0 { next } else { best },
    )
}

/// One moment of each kind of movement.
fn moments() -> Vec<(&'static str, Moves)> {
    let still = Moves::standing(DVec2::ZERO);
    let wall = Moves {
        normal: Vec2::NEG_X,
        ..still
    };
    let holding = |support| Moves { support, ..wall };
    vec![
        ("idle", still),
        ("walk", running(1.5, 0.0, 0.0)),
        ("run", running(8.0, 0.0, 0.0)),
        (
            "turn",
            Moves {
                facing: -1.0,
                ..running(8.0, 0.0, 0.0)
            },
        ),
        (
            "crouch",
            Moves {
                crouched: true,
                ..still
            },
        ),
        (
            "crawl",
            Moves {
                crouched: true,
                ..running(3.0, 0.0, 0.0)
            },
        ),
        (
            "rise",
            Moves {
                velocity: DVec2::new(3.0, 14.0),
                ..falling(0.0)
            },
        ),
        ("fall", falling(0.0)),
        ("wall slide", holding(Support::Slide)),
        (
            "hang",
            Moves {
                ledge: 1.3,
                ..holding(Support::Ledge)
            },
        ),
        (
            "over",
            Moves {
                ledge: 0.6,
                ..holding(Support::Over)
            },
        ),
        ("climb", holding(Support::Wall)),
        ("ladder", holding(Support::Ladder)),
        (
            "skid",
            Moves {
                normal: Vec2::new(-0.8, 0.6),
                ..holding(Support::Slide)
            },
        ),
    ]
}

#[test]
fn a_movement_begins_at_the_time_of_its_event() {
    let mut figure = Figure::new(&falling(0.0), &RIG, &Slope(0.0));
    assert_eq!(figure.state().kind, Kind::Air);
    let landed = Moves {
        time: 0.01,
        landed: (0.004, 12.0),
        ..Moves::standing(DVec2::ZERO)
    };
    figure.advance(&landed, &RIG, &Slope(0.0));
    assert_eq!(
        (figure.state().kind, figure.state().since),
        (Kind::LandSoft, 0.004)
    );
    // In the same tick or split at the event: the same pose.
    let later = Moves {
        time: 0.1,
        ..landed
    };
    figure.advance(&later, &RIG, &Slope(0.0));
    let seconds = RIG.clip(Act::LandSoft).seconds;
    let end = Moves {
        time: 0.02 + f64::from(seconds),
        ..landed
    };
    figure.advance(&end, &RIG, &Slope(0.0));
    assert_eq!(figure.state().kind, Kind::Idle);
}

#[test]
fn the_speed_of_a_landing_and_of_the_run_choose_what_follows() {
    let cases = [
        (2.0, 0.0, Kind::Idle),
        (12.0, 0.0, Kind::LandSoft),
        (23.0, 0.0, Kind::LandHard),
        (12.0, 8.0, Kind::Go),
        (24.0, 8.0, Kind::Roll),
        (12.0, -8.0, Kind::Turn),
    ];
    for (down, forward, expected) in cases {
        let mut figure = Figure::new(&falling(0.0), &RIG, &Slope(0.0));
        let landed = Moves {
            time: TICK,
            landed: (TICK, down),
            velocity: DVec2::X * forward,
            ..Moves::standing(DVec2::ZERO)
        };
        figure.advance(&landed, &RIG, &Slope(0.0));
        assert_eq!(
            figure.state().kind,
            expected,
            "{down} m/s down, {forward} forward"
        );
    }
}

#[test]
fn no_change_of_movement_is_a_jump() {
    let all = moments();
    for (from, first) in &all {
        for (to, second) in &all {
            let mut figure = Figure::new(first, &RIG, &Slope(0.0));
            let mut time = 0.0;
            let mut foot = DVec2::ZERO;
            let mut before = *figure.shown();
            for tick in 0..150 {
                let now = if tick < 50 { first } else { second };
                time += TICK;
                // He moves as fast as he says, but neither into the ground nor through a wall.
                foot += DVec2::new(now.velocity.x, 0.0) * TICK;
                let moves = Moves {
                    time,
                    foot,
                    held_at: time.min(0.42),
                    ..*now
                };
                figure.advance(&moves, &RIG, &Slope(0.0));
                let (turn, bone) = largest_turn(&before, figure.shown());
                let name = &RIG.model.skeleton.joints[bone].name;
                assert!(
                    turn < LARGEST_TURN || tick < 2,
                    "{from} to {to}, tick {tick}: {name} turns by {turn}"
                );
                assert!(
                    (figure.shown().yaw - before.yaw).abs() < LARGEST_TURN,
                    "{from} to {to}: turns about"
                );
                assert!(figure.is_finite());
                before = *figure.shown();
            }
        }
    }
}

#[test]
fn a_run_to_the_left_is_the_mirror_image_of_one_to_the_right() {
    let play = |sign: f64| {
        let moves = |t: f64| running(sign * 8.0, sign * 0.3, t);
        let mut figure = Figure::new(&moves(0.0), &RIG, &Slope(sign * 0.3));
        (1..=100)
            .for_each(|i| figure.advance(&moves(f64::from(i) * TICK), &RIG, &Slope(sign * 0.3)));
        *figure.shown()
    };
    let (right, left) = (play(1.0), play(-1.0));
    assert!(
        (right.yaw + left.yaw + std::f32::consts::PI).abs() < 1e-3,
        "{} {}",
        right.yaw,
        left.yaw
    );
    let (a, b) = (right.bones(&RIG), left.bones(&RIG));
    for (i, joint) in RIG.model.skeleton.joints.iter().enumerate() {
        // The wind does not come from both sides.
        if !["cape", "lantern", "crest"]
            .iter()
            .any(|tail| joint.name.starts_with(tail))
        {
            let (p, q) = (a[i].w_axis, b[i].w_axis);
            assert!((p.y - q.y).abs() < 0.03, "{}: {p} {q}", joint.name);
        }
    }
}

#[test]
fn a_death_begins_anew_and_gets_up() {
    let mut figure = Figure::new(&falling(0.0), &RIG, &Slope(0.0));
    let back = Moves {
        time: TICK,
        deaths: 1,
        ..Moves::standing(DVec2::X * -50.0)
    };
    figure.advance(&back, &RIG, &Slope(0.0));
    assert_eq!(figure.state().kind, Kind::GetUp);
    figure.advance(
        &Moves {
            time: 2.0 * TICK,
            velocity: DVec2::X * 4.0,
            ..back
        },
        &RIG,
        &Slope(0.0),
    );
    assert_eq!(figure.state().kind, Kind::Go, "the player need not wait");
    figure.advance(
        &Moves {
            time: 1.0 + TICK,
            ..back
        },
        &RIG,
        &Slope(0.0),
    );
    assert_eq!(figure.state().kind, Kind::Idle);
}

#[test]
fn squash_and_stretch_are_subtle() {
    let mut figure = Figure::new(&falling(0.0), &RIG, &Slope(0.0));
    for tick in 1..200 {
        let time = f64::from(tick) * TICK;
        let moves = match tick {
            0..100 => Moves {
                velocity: DVec2::new(0.0, -30.0),
                ..falling(time)
            },
            _ => Moves {
                time,
                landed: (100.0 * TICK, 30.0),
                ..Moves::standing(DVec2::ZERO)
            },
        };
        figure.advance(&moves, &RIG, &Slope(0.0));
        let squash = figure.shown().squash;
        assert!((squash - 1.0).abs() <= 0.0801, "tick {tick}: {squash}");
        let volume = figure.shown().stand().determinant();
        assert!((volume - 1.0).abs() < 1e-4, "tick {tick}: {volume}");
    }
}

#[test]
fn who_is_struck_goes_down_where_he_is() {
    let mut figure = Figure::new(&running(8.0, 0.0, 0.0), &RIG, &Slope(0.0));
    for tick in 1..60 {
        figure.advance(
            &running(8.0, 0.0, f64::from(tick) * TICK),
            &RIG,
            &Slope(0.0),
        );
    }
    let place = figure.shown().foot;
    let height = |figure: &Figure| super::at(figure.shown(), Bone::Head).y - place.y;
    let before = height(&figure);
    figure.strike(&RIG);
    let mut was = *figure.shown();
    for _ in 0..48 {
        figure.fall(TICK, &RIG, &Slope(0.0));
        let now = *figure.shown();
        let hips = RIG.bone(Bone::Hips);
        let turn = angle_between(was.pose.bones[hips].turn, now.pose.bones[hips].turn);
        assert!(
            turn < LARGEST_TURN && now.foot == place,
            "{turn}, {}",
            now.foot
        );
        was = now;
    }
    assert_eq!(figure.state().kind, Kind::Die);
    assert!(
        height(&figure) < 0.75 * before,
        "{before} to {}",
        height(&figure)
    );
}
