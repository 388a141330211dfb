//! How far places within the solids of a picture lie from the open: a grid of distances, so that what depends on them does
//! not show the triangles.

use super::facets::Facets;
use glam::Vec2;

/// Metres from one point of the grid to the next, and most points; larger for levels that would need more of them.
const CELL: f32 = 0.5;
const MOST: f32 = 4e5;
/// Grid points around a border that are measured by themselves; the others have their distance from them.
const NEAR: f32 = 2.0;

/// The distances.
#[derive(Default)]
pub struct Inward {
    min: Vec2,
    cell: f32,
    width: usize,
    far: Vec<f32>,
}

impl Inward {
    /// Measures facets.
    pub fn of(facets: &Facets) -> Inward {
        let points = || facets.points.iter().map(|p| p.as_vec2());
        let min = points().fold(Vec2::INFINITY, Vec2::min);
        let max = points().fold(Vec2::NEG_INFINITY, Vec2::max);
        if points().next().is_none() {
            return Inward::default();
        }
        let extent = max - min;
        let cell = CELL.max((extent.x * extent.y / MOST).sqrt());
        let [width, height] = [extent.x, extent.y].map(|side| (side / cell) as usize + 2);
        let mut inward = Inward {
            min,
            cell,
            width,
            far: vec![f32::INFINITY; width * height],
        };
        for e in (0..facets.origin.len()).filter(|&e| facets.is_border(e)) {
            let (a, b) = facets.ends(e);
            inward.measure(a.as_vec2(), b.as_vec2());
        }
        inward.spread();
        inward
    }

    /// Lowers the distances around a piece of border.
    fn measure(&mut self, a: Vec2, b: Vec2) {
        let height = self.far.len() / self.width;
        let around = Vec2::splat(NEAR * self.cell);
        let low = ((a.min(b) - around - self.min) / self.cell).max(Vec2::ZERO);
        let high = (a.max(b) + around - self.min) / self.cell;
        for y in low.y as usize..=(high.y as usize).min(height - 1) {
            for x in low.x as usize..=(high.x as usize).min(self.width - 1) {
                let p = self.min + Vec2::new(x as f32, y as f32) * self.cell;
                let place = &mut self.far[y * self.width + x];
                *place = place.min(distance(p, a, b));
            }
        }
    }

    /// Hands the distances on, forwards and then backwards, from each point to those after it.
    fn spread(&mut self) {
        let width = self.width as isize;
        let height = self.far.len() as isize / width;
        let steps = [(1, 0), (0, 1), (1, 1), (-1, 1)];
        for way in [1, -1] {
            let rows = (0..height).map(|y| if way > 0 { y } else { height - 1 - y });
            for y in rows {
                for x in (0..width).map(|x| if way > 0 { x } else { width - 1 - x }) {
                    let far = self.far[(y * width + x) as usize];
                    for (dx, dy) in steps {
                        let (u, v) = (x + dx * way, y + dy * way);
                        if (0..width).contains(&u) && (0..height).contains(&v) {
                            let step = Vec2::new(dx as f32, dy as f32).length() * self.cell;
                            let place = &mut self.far[(v * width + u) as usize];
                            *place = place.min(far + step);
                        }
                    }
                }
            }
        }
    }

    /// How far a place lies from the open, in metres; 0 if there is no solid at all.
    pub fn at(&self, p: Vec2) -> f32 {
        if self.far.is_empty() {
            return 0.0;
        }
        let height = self.far.len() / self.width;
        let most = Vec2::new((self.width - 2) as f32, (height - 2) as f32);
        let place = ((p - self.min) / self.cell).clamp(Vec2::ZERO, most + 0.999);
        let (x, y) = (place.x as usize, place.y as usize);
        let row = |y: usize| {
            let (left, right) = (
                self.far[y * self.width + x],
                self.far[y * self.width + x + 1],
            );
            left + (right - left) * place.x.fract()
        };
        row(y) + (row(y + 1) - row(y)) * place.y.fract()
    }
}

/// How far a place is from the line between two others.
pub fn distance(p: Vec2, a: Vec2, b: Vec2) -> f32 {
    let share = (p - a).dot(b - a) / (b - a).length_squared();
    p.distance(a.lerp(b, share.clamp(0.0, 1.0)))
}

#[cfg(test)]
mod tests {
    use super::super::facets::Look;
    use super::*;
    use crate::geom::Point;

    #[test]
    fn distances_are_those_from_the_nearest_side() {
        let p = |x: i32, y: i32| Point::new(x << 16, y << 16);
        let [a, b, c, d] = [p(0, 0), p(30, 0), p(30, 12), p(0, 12)];
        let look = Look::default();
        let inward = Inward::of(&Facets::new(&[([a, b, c], look), ([a, c, d], look)]));
        for (x, y, far) in [
            (15.0, 1.0, 1.0),
            (15.0, 6.0, 6.0),
            (2.3, 6.0, 2.3),
            (28.0, 9.5, 2.0),
        ] {
            let found = inward.at(Vec2::new(x, y));
            assert!((found - far).abs() < 0.05, "{x} {y}: {found}");
        }
        assert_eq!(Inward::default().at(Vec2::ONE), 0.0);
    }
}
