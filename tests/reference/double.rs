//! Numbers of about 106 bits: the unevaluated sum of two f64, the second at most half a last place of the first.
//!
//! Why not a crate: the reference needs + - * / sqrt and comparisons, at some thousand operations per event and tick of
//! ten thousand runs, in a debug build. Thirty-two digits leave sixteen below those of the motion under test; rational
//! numbers have no square root and grow with every event, and arbitrary precision is ten times slower. The algorithms are
//! those of Dekker (1971) and Knuth (TAOCP 2, 4.2.2); the error of one operation is below 2^-102 of its result.

use glam::DVec2;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number: high and low part. Ordered as a number, because the high part decides first.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Double(f64, f64);

/// The exact sum of two f64.
fn two_sum(a: f64, b: f64) -> Double {
    let sum = a + b;
    let from_b = sum - a;
    Double(sum, (a - (sum - from_b)) + (b - from_b))
}

/// The exact sum where the first is known to be larger in magnitude.
fn quick_sum(a: f64, b: f64) -> Double {
    let sum = a + b;
    Double(sum, b - (sum - a))
}

/// Upper and lower half of the bits.
fn split(a: f64) -> (f64, f64) {
    let shifted = a * 134_217_729.0; // 2^27 + 1
    let high = shifted - (shifted - a);
    (high, a - high)
}

/// The exact product of two f64.
fn two_product(a: f64, b: f64) -> Double {
    let product = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    Double(product, ((ah * bh - product) + ah * bl + al * bh) + al * bl)
}

impl Double {
    pub const ZERO: Double = Double(0.0, 0.0);
    pub const ONE: Double = Double(1.0, 0.0);

    pub fn to_f64(self) -> f64 {
        self.0
    }

    pub fn abs(self) -> Double {
        if self.0 < 0.0 { -self } else { self }
    }

    /// 1, -1 or 0.
    pub fn sign(self) -> f64 {
        if self.0 == 0.0 { 0.0 } else { self.0.signum() }
    }

    pub fn min(self, other: Double) -> Double {
        if other < self { other } else { self }
    }

    pub fn max(self, other: Double) -> Double {
        if other > self { other } else { self }
    }

    /// One step of Newton's method from the root of the high part; 0 for what is not positive.
    pub fn sqrt(self) -> Double {
        if self.0 <= 0.0 {
            return Double::ZERO;
        }
        let root = self.0.sqrt();
        let rest = self - two_product(root, root);
        quick_sum(root, rest.0 / (2.0 * root))
    }

    /// Whether this is zero but for the rounding of numbers of the size of metres and seconds.
    pub fn is_tiny(self) -> bool {
        self.0.abs() < 1e-20
    }
}

impl From<f64> for Double {
    fn from(a: f64) -> Double {
        Double(a, 0.0)
    }
}

impl From<i64> for Double {
    fn from(a: i64) -> Double {
        let low = a & 0xffff_ffff;
        two_sum((a - low) as f64, low as f64)
    }
}

impl Neg for Double {
    type Output = Double;
    fn neg(self) -> Double {
        Double(-self.0, -self.1)
    }
}

impl Add for Double {
    type Output = Double;
    fn add(self, other: Double) -> Double {
        let (high, low) = (two_sum(self.0, other.0), two_sum(self.1, other.1));
        let sum = quick_sum(high.0, high.1 + low.0);
        quick_sum(sum.0, sum.1 + low.1)
    }
}

impl Sub for Double {
    type Output = Double;
    fn sub(self, other: Double) -> Double {
        self + -other
    }
}

impl Mul for Double {
    type Output = Double;
    fn mul(self, other: Double) -> Double {
        let product = two_product(self.0, other.0);
        quick_sum(product.0, product.1 + (self.0 * other.1 + self.1 * other.0))
    }
}

impl Div for Double {
    type Output = Double;
    fn div(self, other: Double) -> Double {
        let first = self.0 / other.0;
        let rest = self - other * first.into();
        let second = rest.0 / other.0;
        let rest = rest - other * second.into();
        quick_sum(first, second) + (rest.0 / other.0).into()
    }
}

/// A position, direction, velocity or acceleration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vector {
    pub x: Double,
    pub y: Double,
}

impl Vector {
    pub fn new(x: impl Into<Double>, y: impl Into<Double>) -> Vector {
        Vector {
            x: x.into(),
            y: y.into(),
        }
    }

    pub fn dot(self, other: Vector) -> Double {
        self.x * other.x + self.y * other.y
    }

    /// Positive if the other is counter-clockwise of this one.
    pub fn cross(self, other: Vector) -> Double {
        self.x * other.y - self.y * other.x
    }

    pub fn length(self) -> Double {
        self.dot(self).sqrt()
    }

    /// Turned left by a right angle.
    pub fn left(self) -> Vector {
        Vector::new(-self.y, self.x)
    }

    pub fn to_f64(self) -> DVec2 {
        DVec2::new(self.x.to_f64(), self.y.to_f64())
    }
}

impl Add for Vector {
    type Output = Vector;
    fn add(self, other: Vector) -> Vector {
        Vector::new(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Vector {
    type Output = Vector;
    fn sub(self, other: Vector) -> Vector {
        Vector::new(self.x - other.x, self.y - other.y)
    }
}

impl Mul<Double> for Vector {
    type Output = Vector;
    fn mul(self, factor: Double) -> Vector {
        Vector::new(self.x * factor, self.y * factor)
    }
}

#[test]
fn thirty_digits_hold() {
    let near = |a: Double, b: Double| (a - b).to_f64().abs();
    let third = Double::ONE / 3.0.into();
    assert!(near(third * 3.0.into(), Double::ONE) < 1e-31);
    assert!(near(third, (1.0 / 3.0).into()) > 1e-18, "more than an f64");
    let root = Double::from(2.0).sqrt();
    assert!(near(root * root, 2.0.into()) < 1e-31);
    // (1 + 2^-60)^2 - 1 - 2^-59 = 2^-120: what is lost is below the last place of 1.
    let small = Double::from(2f64.powi(-60));
    let one = Double::ONE + small;
    assert!(near(one * one - Double::ONE, small + small) < 1e-31);
    let large = i64::MAX - 5;
    let back = Double::from(large) - Double::from(large - 7);
    assert_eq!(back.to_f64(), 7.0, "integers are exact");
    assert!(Double::ONE < one && -one < -Double::ONE);
}
