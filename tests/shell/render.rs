//! The picture, drawn for real into an offscreen window: it is there, it shows what it should, and bad shaders do no harm.
//!
//! SDL allows one context per process, so these tests share one and run one after another.

mod pictures;

use edgewalker::anim::{Figure, Ground, Rig};
use edgewalker::game::{Stage, View};

use edgewalker::level;
use edgewalker::shell::puppet;
use edgewalker::shell::render::{CameraPose, Frame, Line, RenderError, Renderer, Tri, load};
use glam::{DVec2, Vec3};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::rc::Rc;
use std::sync::Arc;

const DRIVER: (&str, &str) = ("SDL_VIDEODRIVER", "offscreen");
const SIZE: (u32, u32) = (640, 360);

/// What all tests draw with.
struct Studio {
    gl: Rc<glow::Context>,
    folder: PathBuf,
}

type Test = (&'static str, fn(&Studio));

const TESTS: &[Test] = &[
    ("a picture has many colours", a_picture_has_many_colours),
    ("the same moment gives the same picture", the_same_moment),
    ("the hero is seen", the_hero_is_seen),
    ("the hero moves his limbs", the_hero_moves_his_limbs),
    ("the quarry is drawn from start to goal", the_quarry),
    ("debug drawings lie over the scene", debug_drawings),
    ("any size", any_size),
    ("golden pictures", pictures::golden_pictures),
    (
        "every pass is seen in golden pictures",
        pictures::every_pass_is_seen,
    ),
    ("a broken shader names file and line", a_broken_shader),
    ("a missing shader is named", a_missing_shader),
    ("a missing or broken model is named", a_broken_model),
];

/// The driver is chosen by the environment of a fresh process; in there the tests run in order.
fn main() -> ExitCode {
    if std::env::var(DRIVER.0).as_deref() != Ok(DRIVER.1) {
        let program = std::env::current_exe().unwrap();
        let arguments = std::env::args_os().skip(1);
        let again = Command::new(program)
            .args(arguments)
            .envs([DRIVER])
            .status();
        return ExitCode::from(u8::from(!again.unwrap().success()));
    }
    let wanted = std::env::args()
        .skip(1)
        .find(|arg| !arg.starts_with('-'))
        .unwrap_or_default();
    let sdl = sdl2::init().unwrap();
    let video = sdl.video().unwrap();
    let attributes = video.gl_attr();
    attributes.set_context_profile(sdl2::video::GLProfile::Core);
    attributes.set_context_version(3, 3);
    attributes.set_depth_size(24);
    let window = video
        .window("picture", SIZE.0, SIZE.1)
        .opengl()
        .build()
        .unwrap();
    let _current = window.gl_create_context().unwrap();
    let gl = Rc::new(load(|name| video.gl_get_proc_address(name).cast()));
    let folder = std::env::temp_dir().join(format!("edgewalker-picture-{}", std::process::id()));
    let studio = Studio { gl, folder };
    for (name, test) in TESTS.iter().filter(|(name, _)| name.contains(&wanted)) {
        fs::create_dir_all(&studio.folder).unwrap();
        print!("test {name} ... ");
        test(&studio);
        println!("ok");
        fs::remove_dir_all(&studio.folder).unwrap();
    }
    ExitCode::SUCCESS
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn models() -> PathBuf {
    root().join("assets/models")
}

fn stage(name: &str) -> Stage {
    Stage::build(level::load(&root().join("levels").join(name)).unwrap()).unwrap()
}

impl Studio {
    fn renderer(&self) -> Renderer {
        Renderer::new(self.gl.clone(), &root().join("shaders"), &models()).unwrap()
    }

    /// A copy of the shaders that a test may spoil.
    fn own_shaders(&self) -> PathBuf {
        for entry in fs::read_dir(root().join("shaders")).unwrap() {
            let from = entry.unwrap().path();
            fs::copy(&from, self.folder.join(from.file_name().unwrap())).unwrap();
        }
        self.folder.clone()
    }
}

/// A camera at the game's usual distance.
fn camera(at: DVec2) -> CameraPose {
    let target = at.as_vec2().extend(0.0) + Vec3::Y * 1.6;
    CameraPose {
        eye: target + Vec3::new(0.0, 1.4, 17.0),
        target,
        fov_degrees: 42.0,
    }
}

/// The shipped model.
fn hero() -> Arc<Rig> {
    puppet::load(&root().join(puppet::MODEL)).unwrap()
}

/// No ground but the plane that the view tells of.
struct Level;

impl Ground for Level {
    fn under(&self, _: f64, _: f64, _: f64) -> Option<(f64, f32)> {
        None
    }
}

/// Draws a view and gives its pixels; OpenGL must have nothing to complain about.
fn shoot(renderer: &mut Renderer, view: &View, camera: CameraPose) -> Vec<u8> {
    let rig = hero();
    renderer.set_hero(&rig);
    let figure = Figure::new(&view.moves(0.0, None), &rig, &Level);
    let frame = Frame {
        offsets: &[],
        view,
        hero: Some(figure.shown()),
        camera,
        time: view.time,
        lines: &[],
        tris: &[],
        show_world: true,
    };
    renderer.draw(&frame, SIZE);
    assert_eq!(renderer.take_error(), None);
    renderer.read_pixels(SIZE)
}

/// How many pixels differ clearly between two pictures, and the box around them: left, top, right, bottom.
fn difference(a: &[u8], b: &[u8]) -> (usize, [usize; 4]) {
    let width = SIZE.0 as usize;
    let mut found = (0, [usize::MAX, usize::MAX, 0, 0]);
    for (i, (p, q)) in a.chunks_exact(3).zip(b.chunks_exact(3)).enumerate() {
        if p.iter().zip(q).any(|(a, b)| a.abs_diff(*b) > 24) {
            let (x, y) = (i % width, i / width);
            let [left, top, right, bottom] = found.1;
            found = (
                found.0 + 1,
                [left.min(x), top.min(y), right.max(x), bottom.max(y)],
            );
        }
    }
    found
}

fn a_picture_has_many_colours(studio: &Studio) {
    let mut renderer = studio.renderer();
    let stage = stage("quarry.ron");
    renderer.set_stage(&stage);
    let picture = shoot(
        &mut renderer,
        &View::at(stage.level.start),
        camera(stage.level.start),
    );
    let colours: BTreeSet<[u8; 3]> = picture
        .chunks_exact(3)
        .map(|p| [p[0] >> 3, p[1] >> 3, p[2] >> 3])
        .collect();
    assert!(colours.len() > 200, "{} colours", colours.len());
    let luminance = |p: &[u8]| u32::from(p[0]) + u32::from(p[1]) + u32::from(p[2]);
    let share = |test: &dyn Fn(u32) -> bool| {
        picture
            .chunks_exact(3)
            .filter(|p| test(luminance(p)))
            .count()
            * 100
            / (picture.len() / 3)
    };
    assert!(
        share(&|l| l < 15) < 3,
        "too much black: {} %",
        share(&|l| l < 15)
    );
    assert!(
        share(&|l| l > 750) < 3,
        "too much white: {} %",
        share(&|l| l > 750)
    );
}

fn the_same_moment(studio: &Studio) {
    let stage = stage("quarry.ron");
    let view = View {
        time: 12.5,
        ..View::at(stage.level.start)
    };
    let shot = || {
        let mut renderer = studio.renderer();
        renderer.set_stage(&stage);
        shoot(&mut renderer, &view, camera(view.position))
    };
    assert!(shot() == shot());
}

fn the_hero_is_seen(studio: &Studio) {
    let mut renderer = studio.renderer();
    let stage = stage("quarry.ron");
    renderer.set_stage(&stage);
    let here = camera(stage.level.start);
    let with = shoot(&mut renderer, &View::at(stage.level.start), here);
    let without = shoot(
        &mut renderer,
        &View::at(stage.level.start + DVec2::X * 500.0),
        here,
    );
    let (count, [left, top, right, bottom]) = difference(&with, &without);
    // 1.7 m are 47 pixels here; his light and his shadow reach further.
    assert!(count > 500, "{count} pixels");
    assert!(
        right - left > 20 && bottom - top > 40,
        "{left} {top} {right} {bottom}"
    );
    let middle = (SIZE.0 / 2) as usize;
    assert!(left < middle && middle < right && bottom > (SIZE.1 / 2) as usize);
}

fn the_hero_moves_his_limbs(studio: &Studio) {
    let mut renderer = studio.renderer();
    let stage = stage("dev/flat.ron");
    renderer.set_stage(&stage);
    let at = stage.level.start;
    let shot = |renderer: &mut Renderer, view: View| {
        shoot(
            renderer,
            &View {
                time: 100.0,
                ..view
            },
            camera(at),
        )
    };
    let standing = View {
        stance: edgewalker::game::Stance::Ground,
        normal: DVec2::Y,
        ..View::at(at)
    };
    let base = shot(&mut renderer, standing);
    let poses = [
        (
            "running",
            View {
                velocity: DVec2::X * 8.0,
                ..standing
            },
        ),
        (
            "facing left",
            View {
                facing: -1.0,
                ..standing
            },
        ),
        (
            "crouched",
            View {
                crouched: true,
                ..standing
            },
        ),
        (
            "falling",
            View {
                velocity: DVec2::Y * -12.0,
                ..View::at(at)
            },
        ),
    ];
    for (name, view) in poses {
        let mut renderer = studio.renderer();
        renderer.set_stage(&stage);
        let (count, _) = difference(&base, &shot(&mut renderer, view));
        assert!(count > 80, "{name}: {count} pixels");
    }
}

fn the_quarry(studio: &Studio) {
    let mut renderer = studio.renderer();
    let stage = stage("quarry.ron");
    renderer.set_stage(&stage);
    let (from, to) = (stage.level.start, stage.level.goal.min);
    for step in 0..=10 {
        let at = from.lerp(to, f64::from(step) / 10.0);
        let picture = shoot(
            &mut renderer,
            &View {
                time: f64::from(step),
                ..View::at(at)
            },
            camera(at),
        );
        let colours: BTreeSet<&[u8]> = picture.chunks_exact(3).collect();
        assert!(
            colours.len() > 1000,
            "step {step}: {} colours",
            colours.len()
        );
    }
    let below = DVec2::new(from.x, stage.level.bottom - 30.0);
    shoot(&mut renderer, &View::at(below), camera(below));
}

fn debug_drawings(studio: &Studio) {
    let mut renderer = studio.renderer();
    let view = View::at(DVec2::ZERO);
    let pose = CameraPose {
        eye: Vec3::Z * 10.0,
        target: Vec3::ZERO,
        fov_degrees: 60.0,
    };
    let lines = [Line {
        a: Vec3::X * -50.0,
        b: Vec3::X * 50.0,
        colour: [1.0, 0.0, 0.0, 1.0],
        width: 5.0,
    }];
    let corners = [
        Vec3::new(-1.0, 1.0, 0.0),
        Vec3::new(1.0, 1.0, 0.0),
        Vec3::new(0.0, 3.0, 0.0),
    ];
    let tris = [Tri {
        corners,
        colour: [0.0, 1.0, 0.0, 1.0],
    }];
    let frame = Frame {
        offsets: &[],
        view: &view,
        hero: None,
        camera: pose,
        time: 0.0,
        lines: &lines,
        tris: &tris,
        show_world: false,
    };
    renderer.draw(&frame, SIZE);
    assert_eq!(renderer.take_error(), None);
    let picture = renderer.read_pixels(SIZE);
    let count = |colour: [u8; 3]| picture.chunks_exact(3).filter(|p| *p == colour).count();
    // The line crosses the whole picture, five pixels high; the triangle has 2 square metres.
    let red = count([255, 0, 0]);
    assert!(
        (5 * 640 - 700..=5 * 640 + 700).contains(&red),
        "{red} red pixels"
    );
    let metre = f64::from(SIZE.1) / (2.0 * 10.0 * (30f64).to_radians().tan());
    let (green, expected) = (count([0, 255, 0]) as f64, 2.0 * metre * metre);
    assert!(
        (green / expected - 1.0).abs() < 0.05,
        "{green} green pixels, expected {expected}"
    );
}

fn any_size(studio: &Studio) {
    let mut renderer = studio.renderer();
    renderer.set_stage(&stage("dev/flat.ron"));
    let view = View::at(DVec2::ZERO);
    for size in [
        (0, 0),
        (0, 100),
        (100, 0),
        (1, 1),
        (3, 2),
        (50, 4000),
        (16_000, 9_000),
        (u32::MAX, 1),
    ] {
        let frame = Frame {
            offsets: &[],
            view: &view,
            hero: None,
            camera: camera(DVec2::ZERO),
            time: 0.0,
            lines: &[],
            tris: &[],
            show_world: true,
        };
        renderer.draw(&frame, size);
        assert_eq!(renderer.take_error(), None, "{size:?}");
    }
    assert!(renderer.read_pixels((0, 10)).is_empty());
    assert_eq!(renderer.read_pixels((1, 1)).len(), 3);
}

fn a_broken_shader(studio: &Studio) {
    let folder = studio.own_shaders();
    let mut renderer = Renderer::new(studio.gl.clone(), &folder, &models()).unwrap();
    let stage = stage("dev/flat.ron");
    renderer.set_stage(&stage);
    let view = View::at(stage.level.start);
    let good = shoot(&mut renderer, &view, camera(view.position));
    for (file, line) in [("sky.frag", 3), ("tone.glsl", 2), ("world.vert", 9)] {
        let path = folder.join(file);
        let text = fs::read_to_string(&path).unwrap();
        let mut lines: Vec<&str> = text.lines().collect();
        lines.insert(line - 1, "this is no GLSL;");
        fs::write(&path, lines.join("\n")).unwrap();
        let error = renderer.reload_shaders().unwrap_err();
        let found = matches!(&error, RenderError::Compile { path: named, line: at, .. } if *named == path && *at == line);
        assert!(found, "{file}:{line}: {error}");
        assert!(
            error.to_string().contains(&format!("{file}:{line}")),
            "{error}"
        );
        assert!(
            shoot(&mut renderer, &view, camera(view.position)) == good,
            "after an error in {file}"
        );
        fs::write(&path, text).unwrap();
        renderer.reload_shaders().unwrap();
    }
    let sky = folder.join("sky.frag");
    let red = fs::read_to_string(&sky)
        .unwrap()
        .replace("shown(light)", "shown(vec3(1.0, 0.0, 0.0) + 0.0 * light)");
    fs::write(&sky, red).unwrap();
    renderer.reload_shaders().unwrap();
    let (changed, _) = difference(&good, &shoot(&mut renderer, &view, camera(view.position)));
    assert!(changed > 1000, "a good change shows: {changed} pixels");
}

fn a_missing_shader(studio: &Studio) {
    let nowhere = studio.folder.join("nowhere");
    let error = Renderer::new(studio.gl.clone(), &nowhere, &models())
        .err()
        .expect("there are no shaders");
    assert!(
        matches!(error, RenderError::Read { .. }) && error.to_string().contains("nowhere"),
        "{error}"
    );
    let folder = studio.own_shaders();
    fs::remove_file(folder.join("tone.glsl")).unwrap();
    let error = Renderer::new(studio.gl.clone(), &folder, &models())
        .err()
        .expect("a file is missing");
    assert!(error.to_string().contains("tone.glsl"), "{error}");
}

fn a_broken_model(studio: &Studio) {
    let complaint = |models: &Path| {
        let made = Renderer::new(studio.gl.clone(), &root().join("shaders"), models);
        made.err().expect("there are no models").to_string()
    };
    let file = studio.folder.join("pieces.glb");
    let missing = complaint(&studio.folder);
    assert!(
        missing.starts_with(&format!("{}: ", file.display())),
        "{missing}"
    );
    let whole = fs::read(models().join("pieces.glb")).unwrap();
    fs::write(&file, &whole[..whole.len() / 2]).unwrap();
    let cut = complaint(&studio.folder);
    assert!(cut.starts_with(&format!("{}: ", file.display())), "{cut}");
}
