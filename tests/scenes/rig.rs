//! Scenes in a few words: solids, a collider, a tuning; run as they are, mirrored and shifted.

use edgewalker::geom::{Collider, Point};
use edgewalker::motion::{
    Body, Control, EventKind, Mode, Mover, Path, Region, Size, Terrain, Trace, Traits,
    check::{check, steady},
};
use edgewalker::tune::Motion;
use glam::DVec2;

/// Half the width of B, and its height.
pub const HALF: f64 = 13.0 / 32.0;
pub const TALL: f64 = 29.0 / 16.0;

/// What is done to a scene before it is run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Variant {
    Plain,
    Mirrored,
    Shifted,
}

impl Variant {
    pub fn there(self, p: DVec2) -> DVec2 {
        match self {
            Variant::Plain => p,
            Variant::Mirrored => DVec2::new(-p.x, p.y),
            Variant::Shifted => p + DVec2::new(1000.5, -2000.25),
        }
    }

    fn back(self, p: DVec2) -> DVec2 {
        match self {
            Variant::Plain => p,
            Variant::Mirrored => DVec2::new(-p.x, p.y),
            Variant::Shifted => p - DVec2::new(1000.5, -2000.25),
        }
    }

    /// A height.
    pub fn back_y(self, y: f64) -> f64 {
        self.back(v(0.0, y)).y
    }

    pub fn velocity(self, v: DVec2) -> DVec2 {
        if self == Variant::Mirrored {
            DVec2::new(-v.x, v.y)
        } else {
            v
        }
    }
}

/// A scene.
#[derive(Clone)]
pub struct Scene {
    pub solids: Vec<Vec<DVec2>>,
    /// Edges without an inside, for the point alone: they cut free space and stop nobody.
    pub wires: Vec<(DVec2, DVec2)>,
    /// Polylines; walked from left to right their front is up.
    pub one_ways: Vec<Vec<DVec2>>,
    /// Regions by the reference point.
    pub regions: Vec<(Region, Vec<DVec2>)>,
    /// How far above the ends of the ladders among them they are drawn.
    pub drawn: [f64; 2],
    /// Edges without an inside, for the point alone: they stop who comes from either side.
    pub lines: Vec<(DVec2, DVec2)>,
    /// Moving solids, each a scene of its own, and where it goes from time 0 on.
    pub movers: Vec<(Scene, Path)>,
    /// When they begin to go, if somebody starts them: [`Run::start`].
    pub starts: Option<f64>,
    pub stand: Collider,
    pub crouch: Collider,
    pub tuning: Motion,
    /// By solid; those beyond the end have none.
    pub traits: Vec<Traits>,
}

/// Gravity 30 and nothing else: no control, no limits.
pub fn plain() -> Motion {
    Motion {
        gravity: 30.0,
        run_speed: 5.0,
        run_accel: 0.0,
        run_brake: 0.0,
        over_speed_decay: 0.0,
        air_accel: 0.0,
        air_brake: 0.0,
        jump_speed: 12.0,
        jump_cut_speed: 1e9,
        apex_gravity: 1.0,
        fall_speed: 1e12,
        fast_fall_speed: 1e12,
        fast_fall_gravity: 1.0,
        joint_stick: 0.0,
        floor_snap: 0.0,
        step_up: 0.0,
        corner_correction: 0.0,
        ledge_correction: 0.0,
        wall_slide_speed: 0.0,
        wall_jump_out: 0.0,
        wall_jump_up: 0.0,
        ledge_hang: 0.0,
        ledge_magnet: 0.0,
        ..Motion::default()
    }
}

pub fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// A box collider about the middle of its foot.
pub fn box_collider(half: f64, tall: f64) -> Collider {
    let corners = [v(-half, 0.0), v(half, 0.0), v(half, tall), v(-half, tall)];
    Collider::new(corners.map(|p| Point::snap(p).unwrap()).to_vec()).unwrap()
}

impl Scene {
    /// The point P.
    pub fn point() -> Scene {
        Scene {
            solids: Vec::new(),
            wires: Vec::new(),
            one_ways: Vec::new(),
            regions: Vec::new(),
            drawn: [0.0; 2],
            lines: Vec::new(),
            movers: Vec::new(),
            starts: None,
            stand: Collider::point(),
            crouch: Collider::point(),
            tuning: plain(),
            traits: Vec::new(),
        }
    }

    /// The box B.
    pub fn boxed() -> Scene {
        let b = box_collider(HALF, TALL);
        Scene {
            stand: b.clone(),
            crouch: b,
            ..Scene::point()
        }
    }

    pub fn tune(mut self, change: impl Fn(&mut Motion)) -> Scene {
        change(&mut self.tuning);
        self
    }

    pub fn solid(mut self, outline: &[(f64, f64)]) -> Scene {
        self.solids
            .push(outline.iter().map(|&(x, y)| v(x, y)).collect());
        self
    }

    /// Gives traits to the last solid.
    pub fn traits(mut self, change: impl Fn(&mut Traits)) -> Scene {
        self.traits.resize(self.solids.len(), Traits::default());
        change(self.traits.last_mut().expect("a solid"));
        self
    }

    pub fn wire(mut self, a: (f64, f64), b: (f64, f64)) -> Scene {
        self.wires.push((v(a.0, a.1), v(b.0, b.1)));
        self
    }

    pub fn one_way(mut self, line: &[(f64, f64)]) -> Scene {
        self.one_ways
            .push(line.iter().map(|&(x, y)| v(x, y)).collect());
        self
    }

    /// A box that is a region. Its id as a feature follows those of all solids, wires and one-ways.
    pub fn region(mut self, kind: Region, x: (f64, f64), y: (f64, f64)) -> Scene {
        let corners = [(x.0, y.0), (x.1, y.0), (x.1, y.1), (x.0, y.1)];
        self.regions
            .push((kind, corners.map(|(x, y)| v(x, y)).to_vec()));
        self
    }

    /// A line without area that stops from both sides, for the point alone.
    pub fn line(mut self, a: (f64, f64), b: (f64, f64)) -> Scene {
        self.lines.push((v(a.0, a.1), v(b.0, b.1)));
        self
    }

    pub fn rect(self, x: (f64, f64), y: (f64, f64)) -> Scene {
        self.solid(&[(x.0, y.0), (x.1, y.0), (x.1, y.1), (x.0, y.1)])
    }

    /// Under a polyline from left to right, down to a depth.
    pub fn under(self, top: &[(f64, f64)], bottom: f64) -> Scene {
        let (first, last) = (top[0], top[top.len() - 1]);
        let mut outline = vec![(first.0, bottom), (last.0, bottom)];
        outline.extend(top.iter().rev());
        self.solid(&outline)
    }

    /// Runs a test on the scene in all variants.
    pub fn each(&self, test: impl Fn(&mut Run)) {
        for variant in [Variant::Plain, Variant::Mirrored, Variant::Shifted] {
            self.with(variant, &test);
        }
    }

    /// Runs a test on the scene in one variant.
    pub fn with(&self, variant: Variant, test: &impl Fn(&mut Run)) {
        let (stand, crouch) = (
            self.mesh(variant, &self.stand),
            self.mesh(variant, &self.crouch),
        );
        let traits = self.all_traits(variant);
        let movers = self.build_movers(variant, self.starts.map_or(Some(0.0), |_| None));
        let going = self.build_movers(variant, self.starts);
        let terrain = Terrain {
            traits: &traits,
            movers: &movers,
            ..Terrain::new(&stand, &crouch, &self.tuning)
        };
        test(&mut Run {
            variant,
            terrain,
            going: &going,
            body: None,
            trace: Trace::default(),
            control: Control::default(),
        });
    }
}

/// A body in a scene; coordinates in and out are those of the plain variant.
pub struct Run<'a> {
    pub variant: Variant,
    pub terrain: Terrain<'a>,
    /// The moving solids after the scene's start of them.
    pub going: &'a [Mover],
    pub(super) body: Option<Body>,
    pub trace: Trace,
    control: Control,
}

impl Run<'_> {
    /// Puts the reference point of a new body somewhere, at time 0.
    pub fn spawn(&mut self, x: f64, y: f64) -> &mut Self {
        self.body = Some(Body::spawn(self.variant.there(v(x, y)), 0.0, &self.terrain).unwrap());
        self.control = Control::default();
        self.trace.clear();
        self.advance(0.0)
    }

    pub fn body(&self) -> &Body {
        self.body.as_ref().unwrap()
    }

    pub fn velocity(&mut self, x: f64, y: f64) -> &mut Self {
        let velocity = self.variant.velocity(v(x, y));
        self.body
            .as_mut()
            .unwrap()
            .set_velocity(velocity, &self.terrain, &mut self.trace);
        self
    }

    /// Walks: the tangential speed and the wish for it.
    pub fn walk(&mut self, speed: f64) -> &mut Self {
        self.advance(self.time());
        assert!(self.supported(), "must stand to walk");
        let normal = self.body().normal();
        let tangent = v(normal.y, -normal.x)
            * if self.variant == Variant::Mirrored {
                -1.0
            } else {
                1.0
            };
        let velocity = tangent * speed;
        self.body
            .as_mut()
            .unwrap()
            .set_velocity(velocity, &self.terrain, &mut self.trace);
        self.hold(speed.signum())
    }

    pub fn control(&mut self, control: Control) -> &mut Self {
        self.control = control;
        let run = if self.variant == Variant::Mirrored {
            -control.run
        } else {
            control.run
        };
        self.body.as_mut().unwrap().apply(
            Control { run, ..control },
            &self.terrain,
            &mut self.trace,
        );
        self
    }

    pub fn hold(&mut self, run: f64) -> &mut Self {
        self.control(Control {
            run,
            ..self.control
        })
    }

    pub fn jump(&mut self, jump: bool) -> &mut Self {
        self.control(Control {
            jump,
            ..self.control
        })
    }

    pub fn down(&mut self, down: bool) -> &mut Self {
        self.control(Control {
            down,
            ..self.control
        })
    }

    pub fn up(&mut self, up: bool) -> &mut Self {
        self.control(Control { up, ..self.control })
    }

    /// Moves up to a time and checks the invariants there.
    pub fn advance(&mut self, to: f64) -> &mut Self {
        let body = self.body.as_mut().unwrap();
        let mut step = Trace::default();
        body.advance(to, &self.terrain, &mut step);
        check(body, &self.terrain, &step).unwrap();
        let end = body.next_at().unwrap_or(f64::INFINITY).min(to + 1.0);
        if end - to > 1e-9 && !step.events.is_empty() {
            for part in [0.03, 0.21, 0.37, 0.5, 0.68, 0.83, 0.97] {
                steady(body, to + part * (end - to), &self.terrain).unwrap();
            }
        }
        self.trace.events.extend(step.events);
        self.trace.crossed += step.crossed;
        self.trace.passed += step.passed;
        self.trace.touched += step.touched;
        self
    }

    /// Moves on by a time.
    pub fn wait(&mut self, span: f64) -> &mut Self {
        self.advance(self.time() + span)
    }

    /// Moves on by a number of ticks.
    pub fn ticks(&mut self, ticks: u32, rate: f64) -> &mut Self {
        let start = (self.time() * rate).round();
        for tick in 1..=ticks {
            self.advance((start + f64::from(tick)) / rate);
        }
        self
    }

    pub fn time(&self) -> f64 {
        self.body().time()
    }

    pub fn at(&self) -> DVec2 {
        self.variant.back(self.body().position())
    }

    pub fn speed(&self) -> DVec2 {
        self.variant.velocity(self.body().velocity())
    }

    pub fn supported(&self) -> bool {
        self.body().supported()
    }

    pub fn crouched(&self) -> bool {
        self.body().size() == Size::Crouch
    }

    pub fn airborne(&self) -> bool {
        matches!(self.body().mode(), Mode::Air(_))
    }

    pub fn kinds(&self) -> Vec<EventKind> {
        self.trace.events.iter().map(|e| e.kind).collect()
    }

    /// The time of the first event of a kind.
    pub fn when(&self, kind: impl Fn(EventKind) -> bool) -> f64 {
        self.trace
            .events
            .iter()
            .find(|e| kind(e.kind))
            .unwrap_or_else(|| panic!("no such event in {:?}", self.trace.events))
            .time
    }

    /// The time of the last event of a kind.
    pub fn last(&self, kind: impl Fn(EventKind) -> bool) -> f64 {
        let found = self.trace.events.iter().rfind(|e| kind(e.kind));
        found.expect("such an event").time
    }

    /// Position to a tolerance; in the shifted variant no closer than the coordinates allow.
    #[track_caller]
    pub fn near(&mut self, x: f64, y: f64, tolerance: f64) -> &mut Self {
        let tolerance = if self.variant == Variant::Shifted {
            tolerance.max(1e-11)
        } else {
            tolerance
        };
        let off = (self.at() - v(x, y)).abs();
        assert!(
            off.max_element() <= tolerance,
            "{:?}: {} is {off} from ({x}, {y})",
            self.variant,
            self.at()
        );
        self
    }

    /// Not one bit changes, position and velocity, over ticks at 60 Hz.
    #[track_caller]
    pub fn frozen(&mut self, ticks: u32) -> &mut Self {
        let before = (
            self.body().position().to_array().map(f64::to_bits),
            self.body().velocity(),
        );
        self.ticks(ticks, 60.0);
        assert_eq!(
            (
                self.body().position().to_array().map(f64::to_bits),
                self.body().velocity()
            ),
            before
        );
        self
    }
}

/// A number to a tolerance.
pub fn close(a: f64, b: f64, tolerance: f64) {
    assert!(
        (a - b).abs() <= tolerance,
        "{a} is {:e} from {b}",
        (a - b).abs()
    );
}
