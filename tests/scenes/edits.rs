//! Edits of the level under a body: scenes 61 to 63, and what belongs to them.

use super::rig::*;
use crate::worlds::{Dice, star};
use edgewalker::geom::{Collider, Point, STEP, expand};
use edgewalker::mesh::{FeatureId, Mesh};
use edgewalker::motion::{Body, Control, EventKind, Mode, Terrain, Trace, check::check};
use edgewalker::tune::Motion;
use glam::DVec2;

/// A level that changes under a body.
struct Site {
    mesh: Mesh,
    collider: Collider,
    tuning: Motion,
    body: Option<Body>,
    trace: Trace,
    sign: f64,
}

impl Site {
    /// The site as it is, and its mirror image.
    fn both(collider: Collider, test: impl Fn(&mut Site)) {
        for sign in [1.0, -1.0] {
            test(&mut Site {
                mesh: Mesh::build(&[]).unwrap(),
                collider: collider.clone(),
                tuning: plain(),
                body: None,
                trace: Trace::default(),
                sign,
            });
        }
    }

    fn edit(&mut self, change: impl Fn(&mut Mesh)) {
        let before = Terrain::new(&self.mesh, &self.mesh, &self.tuning);
        let anchor = self.body.as_ref().map(|body| body.anchor(&before));
        change(&mut self.mesh);
        let after = Terrain::new(&self.mesh, &self.mesh, &self.tuning);
        if let (Some(body), Some(anchor)) = (&mut self.body, &anchor) {
            body.rehome(anchor, &after, &mut self.trace);
            check(body, &after, &Trace::default()).unwrap();
        }
    }

    fn insert(&mut self, id: FeatureId, outline: &[(f64, f64)]) -> &mut Site {
        let place = |&(x, y): &(f64, f64)| Point::snap(v(self.sign * x, y)).unwrap();
        let mut outline: Vec<_> = outline.iter().map(place).collect();
        if self.sign < 0.0 {
            outline.reverse();
        }
        let edges = expand(&outline, &self.collider);
        self.edit(|mesh| mesh.insert(id, &edges).unwrap());
        self
    }

    fn rect(&mut self, id: FeatureId, x: (f64, f64), y: (f64, f64)) -> &mut Site {
        self.insert(id, &[(x.0, y.0), (x.1, y.0), (x.1, y.1), (x.0, y.1)])
    }

    fn remove(&mut self, id: FeatureId) -> &mut Site {
        self.edit(|mesh| mesh.remove(id).unwrap());
        self
    }

    fn spawn(&mut self, x: f64, y: f64) -> &mut Site {
        let terrain = Terrain::new(&self.mesh, &self.mesh, &self.tuning);
        self.body = Some(Body::spawn(v(self.sign * x, y), 0.0, &terrain).unwrap());
        self.advance(0.0)
    }

    fn moves(&mut self, x: f64, y: f64) -> &mut Site {
        let terrain = Terrain::new(&self.mesh, &self.mesh, &self.tuning);
        let velocity = v(self.sign * x, y);
        let body = self.body.as_mut().unwrap();
        body.set_velocity(velocity, &terrain, &mut self.trace);
        self
    }

    fn hold(&mut self, run: f64) -> &mut Site {
        let terrain = Terrain::new(&self.mesh, &self.mesh, &self.tuning);
        let run = run * self.sign;
        let control = Control {
            run,
            ..Control::default()
        };
        let body = self.body.as_mut().unwrap();
        body.apply(control, &terrain, &mut self.trace);
        self
    }

    fn advance(&mut self, to: f64) -> &mut Site {
        let terrain = Terrain::new(&self.mesh, &self.mesh, &self.tuning);
        let mut trace = Trace::default();
        let body = self.body.as_mut().unwrap();
        body.advance(to, &terrain, &mut trace);
        check(body, &terrain, &trace).unwrap();
        self.trace.events.extend(trace.events);
        self
    }

    fn body(&self) -> &Body {
        self.body.as_ref().unwrap()
    }

    fn at(&self) -> DVec2 {
        let p = self.body().position();
        v(self.sign * p.x, p.y)
    }

    fn speed(&self) -> DVec2 {
        let w = self.body().velocity();
        v(self.sign * w.x, w.y)
    }

    fn kinds(&mut self) -> Vec<EventKind> {
        self.trace.events.drain(..).map(|e| e.kind).collect()
    }

    fn airborne(&self) -> bool {
        matches!(self.body().mode(), Mode::Air(_))
    }
}

fn b() -> Collider {
    box_collider(HALF, TALL)
}

#[test]
fn scene_61_ground_removed_is_flight_with_the_same_velocity() {
    Site::both(b(), |site| {
        site.rect(0, (-5.0, 5.0), (-1.0, 0.0))
            .spawn(-3.0, 0.0)
            .moves(4.0, 0.0);
        site.advance(0.5).kinds();
        site.remove(0);
        assert!(site.airborne());
        assert_eq!((site.at(), site.speed()), (v(-1.0, 0.0), v(4.0, 0.0)));
        assert_eq!(site.kinds(), [EventKind::Left]);
        site.advance(1.5);
        assert_eq!(site.at(), v(3.0, -15.0));
    });
}

#[test]
fn scene_61_a_solid_put_over_a_body_moves_it_out_the_nearest_way() {
    for (x, y, exit) in [
        // A floor that rises by a quarter: upwards.
        ((-4.0, 4.0), (-1.0, 0.25), v(0.0, 0.25)),
        // A wall that reaches just over the middle of the body: back to its left side.
        ((0.125, 4.0), (-1.0, 8.0), v(0.125 - HALF, 0.0)),
    ] {
        Site::both(b(), |site| {
            site.rect(0, (-5.0, 5.0), (-1.0, 0.0)).spawn(0.0, 0.0);
            site.kinds();
            site.rect(1, x, y);
            assert_eq!(site.at(), exit);
            let depth = exit.length();
            assert_eq!(site.kinds()[0], EventKind::Embedded(depth));
            site.advance(1.0);
            assert_eq!(site.at(), exit);
            assert!(site.body().supported());
        });
    }
}

#[test]
fn scene_61_the_same_edit_ends_in_the_same_place_every_time() {
    let run = |detour: bool| {
        let out = std::cell::Cell::new(0);
        Site::both(b(), |site| {
            site.rect(0, (-5.0, 5.0), (-1.0, 0.0))
                .spawn(0.0, 2.0)
                .moves(1.0, 0.0);
            if detour {
                // Other ids in the mesh, the same set of features.
                site.rect(7, (-0.5, 0.3), (-3.0, -1.5))
                    .rect(8, (1.0, 2.0), (-0.5, 0.0));
                site.remove(7).remove(8);
            }
            site.advance(0.1)
                .insert(1, &[(-2.0, 1.0), (2.0, 1.0), (2.0, 6.0), (-2.0, 6.0)]);
            site.advance(2.0);
            out.set(site.body().hash());
        });
        out.get()
    };
    assert_eq!(run(false), run(true));
}

#[test]
fn a_ledge_that_goes_lets_go_who_hangs_from_it() {
    Site::both(b(), |site| {
        (site.tuning.ledge_hang, site.tuning.air_accel) = (1.25, 16.0);
        site.rect(0, (0.0, 5.0), (-9.0, -1.0))
            .rect(1, (0.0, 5.0), (-1.0, 0.0))
            .spawn(-HALF, -0.5)
            .hold(1.0)
            .advance(1.0);
        assert_eq!((site.at(), site.speed()), (v(-HALF, -1.25), v(0.0, 0.0)));
        // A metre lower there is another one.
        site.remove(1).advance(2.0);
        assert!(site.kinds().contains(&EventKind::LetGo));
        assert_eq!((site.at(), site.speed()), (v(-HALF, -2.25), v(0.0, 0.0)));
    });
}

#[test]
fn scene_62_ten_thousand_edits_a_kilometre_away_change_no_bit() {
    Site::both(b(), |site| {
        site.rect(0, (-5.0, 5.0), (-1.0, 0.0))
            .insert(1, &[(2.0, -1.0), (5.0, -1.0), (5.0, 2.0)]);
        site.spawn(-3.0, 3.0).hold(1.0);
        let mut twin = Site {
            mesh: site.mesh.clone(),
            collider: site.collider.clone(),
            tuning: site.tuning.clone(),
            body: site.body.clone(),
            trace: Trace::default(),
            sign: site.sign,
        };
        site.kinds();
        for i in 0..5_000u32 {
            let x = 1000.0 + f64::from(i % 70) * 3.0;
            site.rect(10, (x, x + 2.5), (-1.0, f64::from(i % 11) - 5.5));
            site.remove(10);
            let t = f64::from(i + 1) / 1000.0;
            site.advance(t);
            twin.advance(t);
            if i % 50 == 0 {
                let run = f64::from(i / 50 % 3) - 1.0;
                site.hold(run);
                twin.hold(run);
            }
            assert_eq!(site.body().hash(), twin.body().hash());
        }
        assert_eq!(site.trace.events, twin.trace.events);
        assert!(!site.trace.events.is_empty());
    });
}

#[test]
fn scene_63_a_seam_under_the_foot_loses_one_side() {
    Site::both(b(), |site| {
        // One floor of two pieces and a third one laid over the seam.
        site.rect(0, (-5.0, 0.0), (-1.0, 0.0))
            .rect(1, (0.0, 5.0), (-1.0, 0.0));
        site.rect(2, (-1.0, 1.0), (-0.5, 0.0)).spawn(0.0, 0.0);
        site.kinds();
        for id in [2, 0] {
            site.remove(id);
            assert!(site.body().supported(), "{id}");
            assert_eq!(site.at(), v(0.0, 0.0));
        }
        site.advance(1.0);
        assert_eq!((site.at(), site.kinds()), (v(0.0, 0.0), vec![]));
        site.remove(1);
        assert!(site.airborne());
    });
}

#[test]
fn scene_63_the_tip_that_holds_a_body_goes() {
    Site::both(Collider::point(), |site| {
        // At rest at the foot of a V; without its right side the body slides on down the left one.
        site.insert(0, &[(-4.0, 4.0), (-4.0, -2.0), (0.0, 0.0)]);
        site.insert(1, &[(4.0, 4.0), (0.0, 0.0), (4.0, -2.0)]);
        site.tuning.max_slope = 0.5;
        site.spawn(0.0, 3.0).advance(2.0);
        assert_eq!((site.at(), site.speed()), (v(0.0, 0.0), DVec2::ZERO));
        site.kinds();
        site.remove(1);
        assert_eq!(site.at(), v(0.0, 0.0), "no pop");
        site.advance(2.5);
        assert!(site.at().y < -1.0, "{}", site.at());
    });
}

#[test]
fn a_wall_that_goes_lets_go_on_who_pushes_against_it() {
    Site::both(b(), |site| {
        site.rect(0, (-5.0, 20.0), (-1.0, 0.0))
            .rect(1, (2.0, 3.0), (-0.5, 4.0))
            .spawn(0.0, 0.0);
        site.tuning.run_accel = 50.0;
        site.hold(1.0).advance(2.0);
        assert_eq!((site.at(), site.speed()), (v(2.0 - HALF, 0.0), DVec2::ZERO));
        site.remove(1).advance(3.0);
        assert!(
            (site.at().x - (2.0 - HALF) - 0.25 - 4.5).abs() < 1e-9,
            "{}",
            site.at()
        );
    });
}

#[test]
fn ground_that_is_cut_elsewhere_under_a_walker_changes_no_bit() {
    Site::both(b(), |site| {
        site.insert(0, &[(-9.0, -3.0), (9.0, -3.0), (9.0, 2.5), (-9.0, -1.5)])
            .spawn(-5.0, 2.0);
        site.hold(1.0).moves(5.0, 0.0);
        site.advance(0.4);
        let mut twin = site.body.clone().unwrap();
        // A pillar that cuts the slope ahead, within the same feature edge, and goes again.
        site.rect(1, (3.3, 3.4), (-2.0, 0.9)).remove(1);
        let terrain = Terrain::new(&site.mesh, &site.mesh, &site.tuning);
        twin.advance(0.5, &terrain, &mut Trace::default());
        site.advance(0.5);
        assert_eq!(site.body().hash(), twin.hash());
    });
}

/// A random polygon near the middle of the world.
fn litter(dice: &mut Dice) -> Vec<Point> {
    let at = v(dice.between(-8.0, 8.0), dice.between(-6.0, 6.0));
    let n = 3 + dice.below(4) as usize;
    let (near, far) = (dice.between(0.3, 1.0), dice.between(1.0, 3.0));
    let outline = star(dice, at, n, near, far);
    outline.iter().map(|&p| Point::snap(p).unwrap()).collect()
}

/// Solids come and go all over a level in which a hero runs about: every invariant holds after every edit, and only who is
/// inside a new solid is moved, by as much as the event says.
fn soak(seed: u64, edits: u32) -> [u32; 2] {
    let mut dice = Dice::new(seed);
    let colliders = [Collider::hero(), Collider::hero_crouched()];
    let floor =
        [(-12, -9), (12, -9), (12, -7), (-12, -7)].map(|(x, y)| Point::new(x << 16, y << 16));
    let mut meshes = colliders
        .each_ref()
        .map(|c| Mesh::build(&[expand(&floor, c)]).unwrap());
    let mut present: Vec<FeatureId> = Vec::new();
    let tuning = Motion::default();
    let mut body: Option<Body> = None;
    let mut counts = [0, 0];
    let mut time = 0.0;
    for edit in 1..=edits {
        let anchor = body
            .as_ref()
            .map(|b| b.anchor(&Terrain::new(&meshes[0], &meshes[1], &tuning)));
        if present.len() > 12 || !present.is_empty() && dice.below(2) == 0 {
            let id = present.swap_remove(dice.below(present.len() as u32) as usize);
            meshes.iter_mut().for_each(|mesh| mesh.remove(id).unwrap());
        } else {
            let outline = litter(&mut dice);
            for (mesh, collider) in meshes.iter_mut().zip(&colliders) {
                mesh.insert(edit, &expand(&outline, collider)).unwrap();
            }
            present.push(edit);
        }
        let terrain = Terrain::new(&meshes[0], &meshes[1], &tuning);
        let mut trace = Trace::default();
        if let (Some(body), Some(anchor)) = (&mut body, &anchor) {
            let before = body.position();
            body.rehome(anchor, &terrain, &mut trace);
            let moved = (body.position() - before).length();
            let told = trace.events.iter().find_map(|e| match e.kind {
                EventKind::Embedded(depth) => Some(depth),
                _ => None,
            });
            counts[0] += u32::from(told.is_some());
            counts[1] += u32::from(!trace.events.is_empty());
            let allowed = told.unwrap_or(2.0 * STEP) + 1e-12;
            assert!(
                moved <= allowed,
                "seed {seed}, edit {edit}: moved by {moved}, told {told:?}"
            );
            check(body, &terrain, &trace)
                .unwrap_or_else(|e| panic!("seed {seed}, edit {edit}: {e}"));
        }
        if body.as_ref().is_none_or(|b| b.position().y < -50.0) {
            let at = v(dice.between(-8.0, 8.0), dice.between(-6.0, 8.0));
            body = Body::spawn(at, time, &terrain).ok();
        }
        let Some(body) = &mut body else { continue };
        for _ in 0..dice.below(20) {
            trace.clear();
            let control = Control {
                run: f64::from(dice.below(3) - 1),
                jump: dice.below(2) == 0,
                down: dice.below(4) == 0,
                ..Control::default()
            };
            if dice.below(5) == 0 {
                body.apply(control, &terrain, &mut trace);
            }
            time += 1.0 / 64.0;
            body.advance(time, &terrain, &mut trace);
            check(body, &terrain, &trace)
                .unwrap_or_else(|e| panic!("seed {seed}, after edit {edit}: {e}"));
        }
    }
    counts
}

#[test]
fn solids_that_come_and_go_leave_every_body_in_a_valid_place() {
    let worlds = std::env::var("EDIT_WORLDS").map_or(60, |n| n.parse().expect("a number"));
    let counts = (0..worlds).map(|seed| soak(seed, 200));
    let [embedded, told] = counts.fold([0, 0], |[a, b], [c, d]| [a + c, b + d]);
    println!("{embedded} times embedded, {told} edits told");
    assert!(embedded > 100 && told > embedded, "{embedded}, {told}");
}
