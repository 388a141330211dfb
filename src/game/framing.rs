//! What a level says about its pictures: the rooms that they stay in, and set pieces that are framed. Values, made once per level.
//!
//! Every frame and every area is a *shot*: a way to move the aim of a following camera. A camera blends the shots of a level,
//! and as each of them is smooth in the aim, so is the blend. Absent: time, and the hero.

use crate::level::{Kind, Level, Rect, Scenery};
use crate::tune::Camera;
use glam::DVec2;
use std::collections::BTreeMap;

/// Width over height of the picture that rooms are cut to; a wider window sees more.
pub const ASPECT: f64 = 16.0 / 9.0;

/// Share of the aim's own motion that is left where a set piece is framed, so that the picture lives.
const SHARE: f64 = 0.3;

/// The aim slows down over this much before it stops at the wall of a room, m.
const KNEE: f64 = 2.0;

/// The camera stays this far before the foremost thing of a level, m.
const CLEARANCE: f64 = 3.0;

/// How far the front of the terrain and half a thing of usual size reach towards the camera, m.
const FRONT: f64 = 1.0;

/// How a hero falls, as a picture foresees it: m/s^2, m/s.
pub(super) const GRAVITY: f64 = 45.0;
pub(super) const FALL_SPEED: f64 = 24.0;

/// How far a fall is foreseen, in s, and in what steps.
const AHEAD: u32 = 24;
const MOMENT: f64 = 0.06;

/// Width of the strips by which ground is found, in m.
const STRIP: f64 = 4.0;

/// One way to show the level.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shot {
    /// It is wanted while the hero's foot is in here.
    room: Rect,
    /// What it looks at, if it does not just follow.
    at: Option<DVec2>,
    /// How many times larger than usual things are seen.
    zoom: f64,
    /// The picture stays inside; without bounds at open sides.
    walls: Rect,
}

/// All shots of a level: its frames, then its areas, then one that follows freely.
#[derive(Clone, Debug, PartialEq)]
pub struct Framing {
    shots: Vec<Shot>,
    /// The nearest that the camera may come to the plane of play, m.
    nearest: f64,
    /// Edges that one can land on, from left to right each, by the strips that they reach into.
    ground: BTreeMap<i32, Vec<(DVec2, DVec2)>>,
}

/// Where a shot looks, and from how far away, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    /// What is in the middle of the picture.
    pub target: DVec2,
    /// How far away the camera is.
    pub distance: f64,
}

/// A room without walls.
const OPEN: Rect = Rect {
    min: DVec2::NEG_INFINITY,
    max: DVec2::INFINITY,
};

/// Follows wherever it goes.
const FREE: Shot = Shot {
    room: OPEN,
    at: None,
    zoom: 1.0,
    walls: OPEN,
};

impl Framing {
    /// Of a level that asks for nothing.
    pub fn free() -> Framing {
        Framing {
            shots: vec![FREE],
            nearest: FRONT + CLEARANCE,
            ground: BTreeMap::new(),
        }
    }

    /// The shots of a level.
    pub fn new(level: &Level) -> Framing {
        let rooms: Vec<Rect> = level.areas.iter().map(|area| area.room).collect();
        let walls: Vec<Rect> = rooms.iter().map(|room| outer_walls(room, &rooms)).collect();
        let walls_at = |p: DVec2| {
            let index = rooms.iter().position(|room| room.contains(p));
            index.map_or(OPEN, |index| walls[index])
        };
        let frames = level.frames.iter().map(|frame| Shot {
            room: frame.room,
            at: frame.at,
            zoom: frame.zoom,
            walls: walls_at((frame.room.min + frame.room.max) / 2.0),
        });
        let follow = |(&room, &walls)| Shot {
            room,
            walls,
            ..FREE
        };
        let areas = rooms.iter().zip(&walls).map(follow);
        let shots = frames.chain(areas).chain([FREE]).collect();
        let reach = |thing: &Scenery| thing.depth + FRONT * thing.scale;
        let foremost = level.scenery.iter().filter(|thing| thing.depth > 0.0);
        Framing {
            shots,
            nearest: foremost.map(reach).fold(FRONT, f64::max) + CLEARANCE,
            ground: ground(level),
        }
    }

    /// The height at which a fall from a place ends that begins with a velocity, if it ends soon.
    pub(super) fn end_of_fall(&self, from: DVec2, velocity: DVec2) -> Option<f64> {
        let (mut a, mut speed) = (from + DVec2::new(0.0, MOMENT), velocity);
        for _ in 0..AHEAD {
            speed.y = (speed.y - GRAVITY * MOMENT).max(-FALL_SPEED);
            let b = a + speed * MOMENT;
            let strips = strip(a.x.min(b.x))..=strip(a.x.max(b.x));
            let edges = strips.filter_map(|strip| self.ground.get(&strip)).flatten();
            let met = edges.filter_map(|&(c, d)| meeting(a, b, c, d));
            if let Some(height) = met.reduce(f64::max) {
                return Some(height);
            }
            a = b;
        }
        None
    }

    /// How many shots there are: at least one.
    pub fn count(&self) -> usize {
        self.shots.len()
    }

    /// The shot that is wanted with the hero's foot at a place: the first whose room holds it.
    pub fn shot_at(&self, foot: DVec2) -> usize {
        let found = self.shots.iter().position(|shot| shot.room.contains(foot));
        found.unwrap_or(self.shots.len() - 1)
    }

    /// Where a shot looks while a camera without a level would look at `target`.
    pub fn aim(&self, shot: usize, target: DVec2, tuning: &Camera) -> Aim {
        let Shot {
            at, zoom, walls, ..
        } = self.shots[shot];
        let distance = (tuning.distance / zoom).max(self.nearest);
        let wished = at.map_or(target, |at| at + (target - at) * SHARE);
        let half = half_picture(distance, tuning);
        let side = |x: f64, half: f64, min: f64, max: f64| between(x, min + half, max - half, KNEE);
        let x = side(wished.x, half.x, walls.min.x, walls.max.x);
        let y = side(wished.y, half.y, walls.min.y, walls.max.y);
        Aim {
            target: DVec2::new(x, y),
            distance,
        }
    }
}

/// The number of the strip that a place is in.
fn strip(x: f64) -> i32 {
    (x / STRIP).floor() as i32
}

/// The height at which who goes down from `a` to `b` meets the edge from `c` to `d`.
fn meeting(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> Option<f64> {
    let over = |p: DVec2| (d - c).perp_dot(p - c);
    let (before, after) = (over(a), over(b));
    if before < 0.0 || after > 0.0 || before == after {
        return None;
    }
    let at = a + (b - a) * (before / (before - after));
    (c.x..=d.x).contains(&at.x).then_some(at.y)
}

/// The edges of a level that one can land on, from left to right each.
fn ground(level: &Level) -> BTreeMap<i32, Vec<(DVec2, DVec2)>> {
    let mut ground: BTreeMap<i32, Vec<_>> = BTreeMap::new();
    for feature in &level.features {
        let corners = &feature.outline;
        let mut edges: Vec<(DVec2, DVec2)> = corners.windows(2).map(|c| (c[0], c[1])).collect();
        if let (Kind::Solid, Some(first), Some(last)) =
            (feature.kind, corners.first(), corners.last())
        {
            edges.push((*last, *first));
            let area: f64 = edges.iter().map(|(a, b)| a.perp_dot(*b)).sum();
            if area > 0.0 {
                edges.iter_mut().for_each(|(a, b)| std::mem::swap(a, b));
            }
        }
        let lands = feature.kind == Kind::Solid || feature.kind == Kind::OneWay;
        for (a, b) in edges.into_iter().filter(|(a, b)| lands && a.x < b.x) {
            for strip in strip(a.x)..=strip(b.x) {
                ground.entry(strip).or_default().push((a, b));
            }
        }
    }
    ground
}

/// Half the size of what is seen of the plane of play from a distance, m.
pub fn half_picture(distance: f64, tuning: &Camera) -> DVec2 {
    let half = (tuning.field_of_view / 2.0).to_radians();
    let height = distance * tangent(half);
    DVec2::new(height * ASPECT, height)
}

/// The tangent as glam computes it, equal on every machine.
fn tangent(angle: f64) -> f64 {
    let half = DVec2::from_angle(angle);
    half.y / half.x
}

/// The sides of a room at which no other one goes on.
fn outer_walls(room: &Rect, rooms: &[Rect]) -> Rect {
    let mut walls = *room;
    for other in rooms {
        let reaches = other.min.cmple(room.max).all() && room.min.cmple(other.max).all();
        // How much the two have in common, side by side and one above the other.
        let common = other.max.min(room.max) - other.min.max(room.min);
        if reaches && common.y > 0.0 {
            open(
                &mut walls.min.x,
                other.min.x < room.min.x,
                f64::NEG_INFINITY,
            );
            open(&mut walls.max.x, other.max.x > room.max.x, f64::INFINITY);
        }
        if reaches && common.x > 0.0 {
            open(
                &mut walls.min.y,
                other.min.y < room.min.y,
                f64::NEG_INFINITY,
            );
            open(&mut walls.max.y, other.max.y > room.max.y, f64::INFINITY);
        }
    }
    walls
}

fn open(wall: &mut f64, goes_on: bool, end: f64) {
    if goes_on {
        *wall = end;
    }
}

/// A number kept between two bounds, or half way between bounds that leave no room. Over a knee it slows down before it stops.
pub(super) fn between(x: f64, min: f64, max: f64, knee: f64) -> f64 {
    if min >= max {
        return (min + max) / 2.0;
    }
    let knee = knee.min((max - min) / 2.0);
    let above = match min.is_finite() {
        true => min + eased(x - min, knee),
        false => x,
    };
    match max.is_finite() {
        true => max - eased(max - above, knee),
        false => above,
    }
}

/// Nothing below `-knee`, the identity above `knee`, a parabola between: smooth, and never negative.
fn eased(x: f64, knee: f64) -> f64 {
    match x {
        _ if x <= -knee => 0.0,
        _ if x >= knee => x,
        _ => (x + knee) * (x + knee) / (4.0 * knee),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_kept_between_its_bounds_smoothly() {
        let steps = (-4000..4000).map(|i| f64::from(i) * 0.01);
        let values: Vec<f64> = steps.clone().map(|x| between(x, -7.0, 9.0, KNEE)).collect();
        assert!(values.iter().all(|y| (-7.0..=9.0).contains(y)));
        let slopes: Vec<f64> = values.windows(2).map(|y| (y[1] - y[0]) / 0.01).collect();
        assert!(slopes.iter().all(|s| (-1e-9..=1.0 + 1e-9).contains(s)));
        let bends = slopes.windows(2).map(|s| (s[1] - s[0]).abs());
        assert!(bends.fold(0.0, f64::max) < 0.01, "no corner");
        assert_eq!(
            (between(1.0, -7.0, 9.0, KNEE), between(5.0, 3.0, 2.0, KNEE)),
            (1.0, 2.5)
        );
        assert_eq!(between(3.5, f64::NEG_INFINITY, f64::INFINITY, KNEE), 3.5);
    }

    #[test]
    fn a_room_is_open_where_another_goes_on() {
        let rect = |x0: f64, y0: f64, x1: f64, y1: f64| Rect {
            min: DVec2::new(x0, y0),
            max: DVec2::new(x1, y1),
        };
        let rooms = [
            rect(0.0, 0.0, 9.0, 9.0),
            rect(9.0, -5.0, 20.0, 9.0),
            rect(30.0, 0.0, 40.0, 50.0),
        ];
        let walls = outer_walls(&rooms[0], &rooms);
        assert_eq!(
            walls.min,
            DVec2::ZERO,
            "the other one goes on below, but beside it"
        );
        assert_eq!(walls.max, DVec2::new(f64::INFINITY, 9.0));
        assert_eq!(outer_walls(&rooms[2], &rooms), rooms[2]);
    }
}
