//! The last thing that everything passes: what would be too loud is bent back, so that nothing ever clips.

use kira::Frame;
use kira::effect::{Effect, EffectBuilder};
use kira::info::Info;

/// Up to here nothing is changed.
const KNEE: f32 = 0.7;
/// What is never passed, a little below full.
const MOST: f32 = 0.97;

/// Bends amplitudes.
pub struct Ceiling;

/// Unchanged up to the knee, then ever flatter, with no bend at the knee itself.
fn bend(sample: f32) -> f32 {
    let over = sample.abs() - KNEE;
    if over <= 0.0 {
        return sample;
    }
    let room = MOST - KNEE;
    (KNEE + room * (over / room).tanh()).copysign(sample)
}

impl Effect for Ceiling {
    fn process(&mut self, input: &mut [Frame], _: f64, _: &Info) {
        for frame in input {
            *frame = Frame::new(bend(frame.left), bend(frame.right));
        }
    }
}

impl EffectBuilder for Ceiling {
    type Handle = ();

    fn build(self) -> (Box<dyn Effect>, ()) {
        (Box::new(self), ())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_too_loud_and_what_is_soft_stays() {
        assert_eq!([0.0, 0.5, -0.7].map(bend), [0.0, 0.5, -0.7]);
        let mut last = 0.0;
        for step in 1..=400 {
            let bent = bend(step as f32 * 0.01);
            assert!(bent >= last && bent <= MOST && bent - last <= 0.01001);
            assert_eq!(bend(-step as f32 * 0.01), -bent);
            last = bent;
        }
    }
}
