//! Where the hero has been within a tick: in closed form, so that nothing depends on when somebody looks.

use super::world::{HERO, World};
use crate::geom::STEP;
use crate::level::Rect;
use crate::motion::roots::zeros;
use crate::motion::{Piece, Way};
use glam::DVec2;

/// How far from a room's rim a place is still on it, m: rooms are on the grid, and a place may be drawn half a step beside it.
const ROUNDING: f64 = 0.5 * STEP + 1e-9;

impl World {
    /// The hero's motions in the last tick, the latest first: each with its span of time, s.
    fn ways(&self) -> impl Iterator<Item = (f64, Way)> + '_ {
        let rate = f64::from(self.state.rate);
        let begin = self.state.tick.saturating_sub(1) as f64 / rate;
        let past = &self.traces[HERO].ways;
        let last = Way {
            piece: self.hero().motion(),
            until: self.time(),
        };
        let all = past.iter().copied().chain([last]);
        let from = [begin].into_iter().chain(past.iter().map(|way| way.until));
        // A motion that began within the tick, or after it, has no time before.
        let span = |(from, way): (f64, Way)| (from.max(way.piece.t0), way);
        let all: Vec<(f64, Way)> = from.zip(all).map(span).collect();
        all.into_iter().rev()
    }

    /// Where the hero's foot was at a time of the last tick.
    pub(super) fn hero_at(&self, time: f64) -> DVec2 {
        let mut past = self.traces[HERO].ways.iter();
        let piece = past.find(|way| time <= way.until).map(|way| way.piece);
        piece.unwrap_or_else(|| self.hero().motion()).offset(time)
    }

    /// The greatest height of the hero's foot in the last tick, m: that of a jump is its apex, wherever ticks end.
    pub fn highest(&self) -> f64 {
        let tops = self
            .ways()
            .map(|(from, way)| top(&way.piece, from, way.until));
        tops.fold(f64::NEG_INFINITY, f64::max)
    }

    /// In which area the hero's foot is; between areas, the one where it was last.
    pub(super) fn note_area(&mut self) {
        let rooms = self.stage.rooms();
        let foot = self.hero().position();
        if let Some(area) = rooms.iter().position(|room| is_in(room, foot)) {
            self.state.area = area;
        } else if let Some(area) = self.left_area(rooms) {
            self.state.area = area;
        }
    }

    /// The area that the hero has left within the last tick, if he has.
    fn left_area(&self, rooms: &[Rect]) -> Option<usize> {
        if rooms.is_empty() {
            return None;
        }
        self.ways().find_map(|(from, way)| {
            let left = |room: &Rect| last_inside(&way.piece, (from, way.until), room);
            let mut found: Option<(f64, usize)> = None;
            for (area, room) in rooms.iter().enumerate() {
                if let Some(at) = left(room)
                    && found.is_none_or(|(latest, _)| at > latest)
                {
                    found = Some((at, area));
                }
            }
            found.map(|(_, area)| area)
        })
    }
}

/// Whether a place is in a room or on its rim.
fn is_in(room: &Rect, p: DVec2) -> bool {
    p.cmpge(room.min - ROUNDING).all() && p.cmple(room.max + ROUNDING).all()
}

/// The last time in a span at which a motion is in a room.
fn last_inside(piece: &Piece, (from, until): (f64, f64), room: &Rect) -> Option<f64> {
    let sides = [room.min, room.max];
    let roots = sides.iter().flat_map(|side| {
        let c = piece.p0 - *side;
        let (v, e) = (piece.v0, piece.accel * 0.5);
        [zeros(c.x, v.x, e.x), zeros(c.y, v.y, e.y)]
    });
    let times = roots.flatten().flatten().map(|dt| piece.t0 + dt);
    let between = times.filter(|&t| from <= t && t <= until);
    let inside = between
        .chain([from, until])
        .filter(|&t| is_in(room, piece.offset(t)));
    inside.max_by(f64::total_cmp)
}

/// The greatest height of a motion in a span.
fn top(piece: &Piece, from: f64, until: f64) -> f64 {
    let ends = piece.offset(from).y.max(piece.offset(until).y);
    let apex = piece.t0 - piece.v0.y / piece.accel.y;
    match piece.accel.y < 0.0 && from < apex && apex < until {
        true => ends.max(piece.offset(apex).y),
        false => ends,
    }
}
