//! What developers see drawn over the scene: the motion mesh, the hero's place in it, contact, velocity, path.

use super::MeshSize;
use crate::game::camera::Pose;
use crate::game::{Meshes, Stance, View, World};
use crate::mesh::{self, EdgeId, Mesh};
use crate::shell::play::Play;
use crate::shell::render::{Line, Tri};
use glam::{DVec2, Vec3};

const FREE_EDGE: [f32; 4] = [0.75, 0.85, 1.0, 0.3];
const WALL_EDGE: [f32; 4] = [1.0, 0.78, 0.35, 0.95];
const INNER_EDGE: [f32; 4] = [0.62, 0.55, 0.85, 0.55];
const FRONT_EDGE: [f32; 4] = [0.55, 0.95, 0.55, 0.95];
const REGION: [f32; 4] = [0.35, 0.65, 1.0, 0.16];
const SOLID: [f32; 4] = [0.95, 0.40, 0.20, 0.20];
const FACE: [f32; 4] = [0.35, 0.95, 0.65, 0.22];
const PLACE: [f32; 4] = [0.35, 1.0, 0.65, 1.0];
const NORMAL: [f32; 4] = [0.35, 0.85, 1.0, 1.0];
const VELOCITY: [f32; 4] = [1.0, 0.45, 0.75, 1.0];
const PATH: [f32; 4] = [1.0, 1.0, 1.0, 0.75];

/// Metres of arrow per m/s, and of the normal.
const VELOCITY_SCALE: f64 = 0.15;
const NORMAL_LENGTH: f64 = 1.0;
/// Height of a picture, in pixels, in which lines have the widths that are written here.
const USUAL_HEIGHT: f32 = 720.0;
/// Metres around what the camera sees in which edges are drawn as well.
const MARGIN: f64 = 2.0;
/// Widest picture that is provided for, as width over height.
const ASPECT: f64 = 2.4;

/// What is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Show {
    /// The motion mesh: edges, and a tint on solid faces.
    pub mesh: bool,
    /// The face that the hero is in, or the edge or vertex he is on.
    pub place: bool,
    /// The normal of the ground or wall in contact.
    pub contact: bool,
    /// The velocity.
    pub velocity: bool,
    /// The path of the last second.
    pub path: bool,
    /// Not the world: the drawings alone.
    pub hide_world: bool,
}

/// The meshes for one collider put ready for drawing, made once.
#[derive(Default)]
pub struct MeshPicture {
    level: Sheet,
    movers: Vec<Sheet>,
    size: MeshSize,
}

/// One mesh as lines and triangles.
#[derive(Default)]
struct Sheet {
    edges: Vec<(DVec2, DVec2, Kind)>,
    tints: Vec<([DVec2; 3], [f32; 4])>,
    solid: usize,
}

/// What an edge is to a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Free,
    Inner,
    Front,
    Blocking,
}

impl Sheet {
    /// All of a mesh; edges in the order in which they are drawn, the blocking ones last and so on top.
    fn new(mesh: &Mesh) -> Sheet {
        let mut sheet = Sheet::default();
        for face in mesh.faces() {
            let mut covers = mesh.cover(face).iter();
            let is_region = covers.any(|&id| mesh.kind_of(id) == Some(mesh::Kind::Region));
            let corners = || mesh.corners(face).map(|p| p.metres());
            if mesh.is_solid(face) {
                sheet.tints.push((corners(), SOLID));
                sheet.solid += 1;
            } else if is_region {
                sheet.tints.push((corners(), REGION));
            }
            let sides = mesh.sides(face).into_iter();
            let drawn = sides.filter(|e| is_first(mesh, *e));
            sheet.edges.extend(drawn.map(|e| describe(mesh, e)));
        }
        sheet.edges.sort_by_key(|(_, _, kind)| *kind);
        sheet
    }

    /// What meets the window, moved; of a mover, only what is its own.
    fn draw(&self, window: (DVec2, DVec2), offset: DVec2, is_mover: bool, out: &mut Drawing) {
        let window = (window.0 - offset, window.1 - offset);
        let at = |p: DVec2| at(p + offset);
        let tints = self.tints.iter();
        for (corners, colour) in tints.filter(|(corners, _)| meets(window, corners)) {
            out.tris.push(Tri {
                corners: corners.map(at),
                colour: *colour,
            });
        }
        let edges = self.edges.iter();
        for (a, b, kind) in edges.filter(|(a, b, _)| meets(window, &[*a, *b])) {
            let (colour, width) = match kind {
                Kind::Free if is_mover => continue,
                Kind::Free => (FREE_EDGE, 1.0),
                Kind::Inner => (INNER_EDGE, 1.5),
                Kind::Front => (FRONT_EDGE, 2.5),
                Kind::Blocking => (WALL_EDGE, 3.0),
            };
            out.lines.push(Line {
                a: at(*a),
                b: at(*b),
                colour,
                width,
            });
        }
    }
}

impl MeshPicture {
    /// All meshes for a collider.
    pub fn new(meshes: &Meshes) -> MeshPicture {
        let (mesh, level) = (&meshes.level, Sheet::new(&meshes.level));
        let (faces, edges) = (mesh.faces().count(), level.edges.len());
        let size = MeshSize {
            // Euler: a triangulated disc has one vertex more than it has edges beyond its faces.
            vertices: (edges + 1).saturating_sub(faces),
            edges,
            faces,
            solid: level.solid,
            features: mesh.features().count(),
        };
        MeshPicture {
            level,
            movers: meshes.movers.iter().map(|mesh| Sheet::new(mesh)).collect(),
            size,
        }
    }

    /// How much there is of the level's mesh.
    pub fn size(&self) -> MeshSize {
        self.size
    }

    /// What meets the window; in a large level that is little of the mesh.
    fn draw(&self, window: (DVec2, DVec2), offsets: &[DVec2], out: &mut Drawing) {
        self.level.draw(window, DVec2::ZERO, false, out);
        for (sheet, offset) in self.movers.iter().zip(offsets) {
            sheet.draw(window, *offset, true, out);
        }
    }
}

/// Of the two directions of an edge, the one that is drawn.
fn is_first(mesh: &Mesh, edge: EdgeId) -> bool {
    let other = mesh.sym(edge);
    edge < other || mesh.left(other).is_none()
}

/// Ends and kind of an edge.
fn describe(mesh: &Mesh, edge: EdgeId) -> (DVec2, DVec2, Kind) {
    let end = |v| mesh.point(v).metres();
    let kind = if mesh.blocks(edge) || mesh.blocks(mesh.sym(edge)) {
        Kind::Blocking
    } else if mesh.has_front(edge) || mesh.has_front(mesh.sym(edge)) {
        Kind::Front
    } else if mesh.uses(edge).next().is_some() {
        Kind::Inner
    } else {
        Kind::Free
    };
    (end(mesh.origin(edge)), end(mesh.dest(edge)), kind)
}

/// Lines and triangles for the renderer.
#[derive(Default)]
pub struct Drawing {
    /// Lines, drawn in their order.
    pub lines: Vec<Line>,
    /// Triangles, drawn below the lines.
    pub tris: Vec<Tri>,
}

impl Drawing {
    /// Nothing, with the room that it had.
    pub fn clear(&mut self) {
        self.lines.clear();
        self.tris.clear();
    }

    /// Adds everything that shall be shown of this moment.
    pub fn add(
        &mut self,
        show: Show,
        play: &Play,
        picture: &MeshPicture,
        offsets: &[DVec2],
        view: &View,
        pose: &Pose,
    ) {
        if show.mesh {
            picture.draw(window(pose), offsets, self);
        }
        if show.place {
            self.place(&play.world, offsets);
        }
        if show.path {
            self.path(play, view);
        }
        if show.velocity {
            self.arrow(view.position, view.velocity * VELOCITY_SCALE, VELOCITY);
        }
        if show.contact && view.stance != Stance::Air {
            self.arrow(view.position, view.normal * NORMAL_LENGTH, NORMAL);
        }
    }

    /// Makes it one for a picture so many pixels high: what is bold stays bold on a fine display.
    pub fn scale_to(&mut self, height: u32) {
        let scale = (height as f32 / USUAL_HEIGHT).max(1.0);
        self.lines.iter_mut().for_each(|line| line.width *= scale);
    }

    /// The discrete place, which is the truth about where the hero is: his face, and the edge or vertex he is on, in the
    /// mesh of what carries him.
    fn place(&mut self, world: &World, offsets: &[DVec2]) {
        let (mesh, hero) = (world.mesh_under(), world.hero());
        let carrier = hero.carrier().and_then(|i| offsets.get(i as usize));
        let offset = carrier.copied().unwrap_or_default();
        let corners = mesh.corners(hero.face(mesh));
        self.tris.push(Tri {
            corners: corners.map(|p| at(p.metres() + offset)),
            colour: FACE,
        });
        match hero.edge() {
            Some(edge) => {
                let (a, b, _) = describe(mesh, edge);
                self.line(a + offset, b + offset, PLACE, 5.0);
            }
            None if world.view().stance == Stance::Wedge => self.cross(hero.position()),
            None => {}
        }
    }

    fn cross(&mut self, p: DVec2) {
        for d in [DVec2::new(0.2, 0.2), DVec2::new(0.2, -0.2)] {
            self.line(p - d, p + d, PLACE, 5.0);
        }
    }

    /// The path of the last second up to the moment that is drawn, fading towards its beginning.
    fn path(&mut self, play: &Play, view: &View) {
        let points: Vec<DVec2> = play
            .trail()
            .iter()
            .copied()
            .chain([view.position])
            .collect();
        for (index, pair) in points.windows(2).enumerate() {
            let age = index as f32 / points.len() as f32;
            let [r, g, b, a] = PATH;
            self.line(pair[0], pair[1], [r, g, b, a * age], 2.0);
        }
    }

    /// An arrow with a head of fixed size; one without length has none.
    fn arrow(&mut self, from: DVec2, along: DVec2, colour: [f32; 4]) {
        let to = from + along;
        self.line(from, to, colour, 3.0);
        let Some(direction) = along.try_normalize() else {
            return;
        };
        for side in [direction.perp(), -direction.perp()] {
            self.line(to, to + (side - direction * 1.6) * 0.12, colour, 3.0);
        }
    }

    fn line(&mut self, a: DVec2, b: DVec2, colour: [f32; 4], width: f32) {
        self.lines.push(Line {
            a: at(a),
            b: at(b),
            colour,
            width,
        });
    }
}

/// The part of the plane of play that a camera may see, with a margin: lower left, upper right.
fn window(pose: &Pose) -> (DVec2, DVec2) {
    let half = DVec2::from_angle((pose.fov_degrees / 2.0).to_radians());
    let height = pose.eye.distance(pose.target) * half.y / half.x;
    let reach = DVec2::new(height * ASPECT, height) + MARGIN;
    let middle = pose.target.truncate();
    (middle - reach, middle + reach)
}

/// Whether the box around some points meets the window.
fn meets((low, high): (DVec2, DVec2), points: &[DVec2]) -> bool {
    let (min, max) = points
        .iter()
        .fold((points[0], points[0]), |(a, b), p| (a.min(*p), b.max(*p)));
    min.cmple(high).all() && max.cmpge(low).all()
}

/// A point of the plane of play in space.
fn at(p: DVec2) -> Vec3 {
    p.as_vec2().extend(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_near_the_camera_is_drawn_even_if_its_corners_are_far() {
        let near = (DVec2::ZERO, DVec2::ONE);
        assert!(meets(
            near,
            &[DVec2::new(-100.0, 0.5), DVec2::new(100.0, 0.5)]
        ));
        assert!(!meets(
            near,
            &[DVec2::new(2.0, 0.5), DVec2::new(100.0, 0.5)]
        ));
    }
}
