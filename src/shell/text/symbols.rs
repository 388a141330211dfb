//! Small drawings that stand among letters: ornaments, and the shapes on the buttons of controllers. Each is the distance to
//! its outline, so that it is sharp at every size.

use glam::Vec2;

/// A drawing in a square.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Symbol {
    /// A square on its corner.
    Lozenge,
    /// Its outline.
    LozengeRing,
    /// A filled circle.
    Disc,
    /// A circle.
    Ring,
    /// A filled square with round corners.
    Round,
    /// Its outline.
    RoundRing,
    /// Two crossed strokes.
    Cross,
    /// A square's outline.
    Square,
    /// A triangle's outline.
    Triangle,
    /// An arrow head to the left.
    Left,
    /// An arrow head to the right.
    Right,
    /// An arrow head upwards.
    Up,
    /// An arrow head downwards.
    Down,
    /// An arrow to the left.
    ToLeft,
    /// An arrow to the right.
    ToRight,
    /// An arrow upwards.
    ToTop,
    /// An arrow downwards.
    ToBottom,
    /// A light that fades towards its rim.
    Glow,
    /// What stands for a character that no font has.
    Missing,
}

/// Thickness of strokes, as a share of half the side.
const STROKE: f32 = 0.16;
/// Radius of round corners.
const CORNER: f32 = 0.42;

impl Symbol {
    /// Coverage of a picture of `side` by `side` pixels, rows from the top down.
    pub fn rasterise(self, side: usize) -> Vec<u8> {
        let half = side as f32 / 2.0;
        let mut pixels = Vec::with_capacity(side * side);
        for row in 0..side {
            for column in 0..side {
                let at = Vec2::new(column as f32 + 0.5 - half, row as f32 + 0.5 - half) / half;
                let cover = match self {
                    Symbol::Glow => (1.0 - at.length()).max(0.0).powi(2),
                    _ => (0.5 - self.distance(at) * half).clamp(0.0, 1.0),
                };
                pixels.push((cover * 255.0).round() as u8);
            }
        }
        pixels
    }

    /// Distance to the outline, inside negative; the square reaches from -1 to 1, downwards positive.
    fn distance(self, p: Vec2) -> f32 {
        let ring = |d: f32| d.abs() - STROKE / 2.0;
        match self {
            Symbol::Lozenge => lozenge(p, 0.9),
            Symbol::LozengeRing => ring(lozenge(p, 0.8)),
            Symbol::Disc => p.length() - 0.98,
            Symbol::Ring => ring(p.length() - 0.9),
            Symbol::Round => rounded(p, 0.98),
            Symbol::RoundRing => ring(rounded(p, 0.9)),
            Symbol::Cross => stroke(p.abs(), Vec2::ZERO, Vec2::splat(0.55)),
            Symbol::Square => ring(boxed(p, Vec2::splat(0.52))),
            Symbol::Triangle => triangle(p),
            Symbol::Left => chevron(p),
            Symbol::Right => chevron(Vec2::new(-p.x, p.y)),
            Symbol::Up => chevron(Vec2::new(p.y, p.x)),
            Symbol::Down => chevron(Vec2::new(-p.y, p.x)),
            Symbol::ToLeft => arrow(p),
            Symbol::ToRight => arrow(Vec2::new(-p.x, p.y)),
            Symbol::ToTop => arrow(Vec2::new(p.y, p.x)),
            Symbol::ToBottom => arrow(Vec2::new(-p.y, p.x)),
            Symbol::Missing => ring(boxed(p, Vec2::new(0.5, 0.75))),
            Symbol::Glow => p.length() - 1.0,
        }
    }
}

fn lozenge(p: Vec2, reach: f32) -> f32 {
    (p.abs().element_sum() - reach) * std::f32::consts::FRAC_1_SQRT_2
}

fn boxed(p: Vec2, half: Vec2) -> f32 {
    let q = p.abs() - half;
    q.max(Vec2::ZERO).length() + q.max_element().min(0.0)
}

fn rounded(p: Vec2, half: f32) -> f32 {
    boxed(p, Vec2::splat(half - CORNER)) - CORNER
}

/// A line with round ends.
fn stroke(p: Vec2, a: Vec2, b: Vec2) -> f32 {
    let (along, from) = (b - a, p - a);
    let share = (from.dot(along) / along.length_squared()).clamp(0.0, 1.0);
    (from - along * share).length() - STROKE / 2.0
}

fn triangle(p: Vec2) -> f32 {
    let [top, right, left] = [(0.0, -0.68), (0.62, 0.42), (-0.62, 0.42)].map(Vec2::from);
    stroke(p, top, right)
        .min(stroke(p, right, left))
        .min(stroke(p, left, top))
}

fn chevron(p: Vec2) -> f32 {
    let tip = Vec2::new(-0.3, 0.0);
    stroke(p, tip, Vec2::new(0.3, -0.6)).min(stroke(p, tip, Vec2::new(0.3, 0.6)))
}

/// A head with a shaft, to the left.
fn arrow(p: Vec2) -> f32 {
    let tip = Vec2::new(-0.7, 0.0);
    stroke(p, tip, Vec2::new(0.7, 0.0))
        .min(stroke(p, tip, Vec2::new(-0.15, -0.5)))
        .min(stroke(p, tip, Vec2::new(-0.15, 0.5)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The share of the square that a symbol covers is the same at every size, but for its rim.
    #[test]
    fn symbols_look_the_same_at_every_size() {
        let cover = |symbol: Symbol, side: usize| {
            let sum: f32 = symbol.rasterise(side).iter().map(|&p| f32::from(p)).sum();
            sum / 255.0 / (side * side) as f32
        };
        for symbol in [Symbol::Disc, Symbol::Lozenge, Symbol::Cross, Symbol::Left] {
            let [small, large] = [16, 96].map(|side| cover(symbol, side));
            assert!((small - large).abs() < 0.02, "{symbol:?} {small} {large}");
        }
        assert!((cover(Symbol::Disc, 96) - 0.754).abs() < 0.01);
    }
}
