//! Cuts a failing run down: as long as it fails in the same way, everything that can be left out is, and numbers become round.

use super::case::{Case, Edit};
use super::run::{Failure, live};
use super::tally::Tally;
use super::worlds::sound;
use edgewalker::geom::Point;
use edgewalker::level::Feature;
use edgewalker::motion::Control;
use edgewalker::tune::Motion;
use std::time::{Duration, Instant};

/// How long cutting down may take.
const PATIENCE: Duration = Duration::from_secs(40);

struct Shrinker {
    case: Case,
    failure: Failure,
    until: Instant,
}

/// The smallest case found that fails like this one, and how it fails.
pub fn shrink(case: &Case, failure: &Failure) -> (Case, Failure) {
    let mut s = Shrinker {
        case: case.clone(),
        failure: failure.clone(),
        until: Instant::now() + PATIENCE,
    };
    loop {
        let before = s.case.clone();
        s.cut_time();
        s.cut_list(|c| &mut c.world.features);
        s.cut_list(|c| &mut c.world.movers);
        s.cut_list(|c| &mut c.life.edits);
        s.cut_list(|c| &mut c.life.inputs);
        s.calm_tuning();
        s.calm_inputs();
        s.calm_features();
        if s.case == before || Instant::now() > s.until {
            return (s.case, s.failure);
        }
    }
}

impl Shrinker {
    /// Takes a changed case if it fails in the same way.
    fn take(&mut self, change: impl FnOnce(&mut Case)) -> bool {
        let mut case = self.case.clone();
        change(&mut case);
        if case == self.case || Instant::now() > self.until {
            return false;
        }
        match live(&case, &mut case.world.ready(), &mut Tally::default()) {
            Err(failure) if failure.class() == self.failure.class() => {
                (self.case, self.failure) = (case, failure);
                true
            }
            _ => false,
        }
    }

    /// Ends at the failure, starts at time 0 and at a usual rate.
    fn cut_time(&mut self) {
        let last = self.failure.tick;
        self.take(|c| c.life.ticks = last);
        self.take(|c| c.life.since = 0);
        self.take(|c| c.world.rate = 60.0);
    }

    /// Leaves out as many items of a list as possible, in chunks that are halved (Zeller's delta debugging).
    fn cut_list<T>(&mut self, list: impl Fn(&mut Case) -> &mut Vec<T>) {
        let mut chunk = list(&mut self.case).len();
        while chunk > 0 {
            let mut from = 0;
            while from < list(&mut self.case).len() {
                let cut = |c: &mut Case| {
                    let items = list(c);
                    items.drain(from..(from + chunk).min(items.len()));
                };
                if !self.take(cut) {
                    from += chunk;
                }
            }
            chunk /= 2;
        }
    }

    /// As many tunables as possible at their defaults, or 0.
    fn calm_tuning(&mut self) {
        for (i, meta) in Motion::META.iter().enumerate() {
            for calm in [0.0_f64.max(meta.min), meta.default] {
                self.take(|c| *c.world.tuning.values_mut()[i] = calm);
            }
        }
    }

    fn calm_inputs(&mut self) {
        for i in 0..self.case.life.inputs.len() {
            let calm: [fn(&mut Control); 4] = [
                |c| c.run = 0.0,
                |c| c.jump = false,
                |c| c.down = false,
                |c| c.up = false,
            ];
            for change in calm {
                self.take(|c| change(&mut c.life.inputs[i].1));
            }
        }
    }

    fn calm_features(&mut self) {
        for i in 0..self.case.world.features.len() {
            self.calm_feature(|c| &mut c.world.features[i]);
        }
        for i in 0..self.case.world.movers.len() {
            for j in 0..self.case.world.movers[i].features.len() {
                self.calm_feature(|c| &mut c.world.movers[i].features[j]);
            }
        }
        for i in 0..self.case.life.edits.len() {
            if let Edit::Insert(_) | Edit::InsertHere(_) = self.case.life.edits[i].1 {
                self.calm_feature(|c| match &mut c.life.edits[i].1 {
                    Edit::Insert(f) | Edit::InsertHere(f) => f,
                    _ => unreachable!("the kind of an edit stays"),
                });
            }
        }
    }

    /// Fewer traits, fewer corners, rounder numbers.
    fn calm_feature(&mut self, feature: impl Fn(&mut Case) -> &mut Feature) {
        self.take(|c| feature(c).conveyor = 0.0);
        self.take(|c| feature(c).friction = None);
        self.take(|c| feature(c).concave = None);
        self.take(|c| feature(c).climbable = false);
        let mut corner = 0;
        while corner < feature(&mut self.case).outline.len() {
            let cut = self.take_sound(&feature, |f| _ = f.outline.remove(corner));
            corner += usize::from(!cut);
        }
        for corner in 0..feature(&mut self.case).outline.len() {
            for places in [1.0, 4.0, 64.0, 1024.0] {
                let round = |f: &mut Feature| {
                    f.outline[corner] = (f.outline[corner] * places).round() / places;
                };
                if self.take_sound(&feature, round) {
                    break;
                }
            }
        }
    }

    fn take_sound(
        &mut self,
        feature: &impl Fn(&mut Case) -> &mut Feature,
        change: impl FnOnce(&mut Feature),
    ) -> bool {
        let mut changed = feature(&mut self.case).clone();
        change(&mut changed);
        let on_grid = |p: &glam::DVec2| Point::snap(*p).is_some();
        changed.outline.iter().all(on_grid)
            && sound(&changed)
            && self.take(|c| *feature(c) = changed)
    }
}
