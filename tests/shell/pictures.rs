//! Golden pictures: a few small scenes, compared with recorded ones, so that a broken pass is noticed.
//!
//! `GOLDEN=record cargo test --test shell_render golden` records them anew; say in the commit why. What differs is saved
//! beside the other files of the build, as it is and as the difference.

use super::{Studio, camera, root};
use edgewalker::game::{Stage, Stance, View};
use edgewalker::level;
use edgewalker::shell::capture::write_png;
use edgewalker::shell::render::{CameraPose, Frame, Pass, Preset, Renderer};
use glam::DVec2;
use std::path::{Path, PathBuf};

const SIZE: (u32, u32) = (480, 270);
/// Rounding of different processors: so much in a channel does not count, nor do so many of a thousand pixels.
const CHANNEL: u8 = 3;
const PER_MILLE: usize = 5;
/// When the hero has landed, in seconds.
const LANDED: f64 = 20.0;
/// How much nearer than usual the camera is to the hero.
const NEAR: f32 = 0.35;

/// A picture: its name, its preset, where its middle is, and whether it is taken from near, with the hero in it.
struct Shot {
    name: &'static str,
    preset: Preset,
    at: (f64, f64),
    with_hero: bool,
}

const SHOTS: &[Shot] = &[
    shot("slope", Preset::Medium, (-1.0, 0.0)),
    shot("slope-low", Preset::Low, (-1.0, 0.0)),
    shot("masonry", Preset::Medium, (18.0, 1.0)),
    shot("iron", Preset::Medium, (31.0, 1.0)),
    shot("water", Preset::Medium, (10.0, -4.0)),
    shot("sky", Preset::Medium, (-24.0, 9.0)),
    Shot {
        name: "hero",
        preset: Preset::Medium,
        at: (1.0, -0.2),
        with_hero: true,
    },
];

const fn shot(name: &'static str, preset: Preset, at: (f64, f64)) -> Shot {
    Shot {
        name,
        preset,
        at,
        with_hero: false,
    }
}

fn folder() -> PathBuf {
    root().join("tests/golden/pictures")
}

/// Draws a shot, perhaps without one of the passes.
fn draw(renderer: &mut Renderer, shot: &Shot, left_out: Option<Pass>) -> Vec<u8> {
    let at = DVec2::from(shot.at);
    let pose = camera(at);
    renderer.set_preset(shot.preset).unwrap();
    renderer.leave_out(left_out);
    // Who is there has just landed, and what that stirs up has had time to rise.
    for time in [LANDED, LANDED + 0.2] {
        let there = View {
            time,
            stance: Stance::Ground,
            normal: DVec2::Y,
            landed_at: LANDED,
            landed_speed: 16.0,
            ..View::at(at)
        };
        let far_away = View {
            time,
            ..View::at(DVec2::new(-500.0, 0.0))
        };
        let frame = Frame {
            view: if shot.with_hero { &there } else { &far_away },
            offsets: &[],
            hero: None,
            camera: CameraPose {
                eye: pose.target
                    + (pose.eye - pose.target) * if shot.with_hero { NEAR } else { 1.0 },
                ..pose
            },
            time,
            lines: &[],
            tris: &[],
            show_world: true,
        };
        renderer.draw(&frame, SIZE);
    }
    assert_eq!(renderer.take_error(), None);
    renderer.read_pixels(SIZE)
}

/// A renderer that has the scenes.
fn renderer(studio: &Studio) -> Renderer {
    let mut renderer = studio.renderer();
    let level = level::load(&folder().join("scenes.ron")).unwrap();
    renderer.set_stage(&Stage::build(level).unwrap());
    renderer
}

/// How many pixels differ more than rounding does.
fn differing(a: &[u8], b: &[u8]) -> usize {
    let pixels = a.chunks_exact(3).zip(b.chunks_exact(3));
    let differs = |(p, q): &(&[u8], &[u8])| p.iter().zip(*q).any(|(a, b)| a.abs_diff(*b) > CHANNEL);
    pixels.filter(differs).count()
}

fn is_like(golden: &[u8], actual: &[u8]) -> bool {
    golden.len() == actual.len() && differing(golden, actual) * 1000 <= actual.len() / 3 * PER_MILLE
}

/// Reads a golden picture: RGB bytes.
fn golden(shot: &Shot) -> Vec<u8> {
    let path = folder().join(shot.name).with_extension("png");
    let bytes = std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), SIZE, "{}", path.display());
    pixels
}

/// Saves a picture that is not as it was, and where.
fn save_failure(shot: &Shot, golden: &[u8], actual: &[u8]) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let save = |what: &str, pixels: &[u8]| {
        let path = folder.join(format!("{}-{what}.png", shot.name));
        write_png(&path, SIZE, pixels).unwrap();
        path
    };
    let difference: Vec<u8> = golden
        .iter()
        .zip(actual)
        .map(|(a, b)| a.abs_diff(*b).saturating_mul(8))
        .collect();
    save("difference", &difference);
    save("actual", actual).display().to_string()
}

/// The scenes look as recorded.
pub fn golden_pictures(studio: &Studio) {
    let mut renderer = renderer(studio);
    let mut failures = Vec::new();
    for shot in SHOTS {
        let actual = draw(&mut renderer, shot, None);
        if std::env::var("GOLDEN").as_deref() == Ok("record") {
            let path = folder().join(shot.name).with_extension("png");
            write_png(&path, SIZE, &actual).unwrap();
            continue;
        }
        let golden = golden(shot);
        if !is_like(&golden, &actual) {
            let count = differing(&golden, &actual);
            let saved = save_failure(shot, &golden, &actual);
            failures.push(format!("{}: {count} pixels differ, see {saved}", shot.name));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Without any one of the passes, some scene does not.
pub fn every_pass_is_seen(studio: &Studio) {
    let mut renderer = renderer(studio);
    for pass in Pass::ALL {
        let mut is_noticed = |shot: &Shot| {
            let golden = golden(shot);
            let [with, without] = [None, Some(pass)].map(|pass| draw(&mut renderer, shot, pass));
            is_like(&golden, &with) && !is_like(&golden, &without)
        };
        assert!(SHOTS.iter().any(&mut is_noticed), "nobody misses {pass:?}");
    }
}
