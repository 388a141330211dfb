//! Areas: what is between two ticks counts too.

use super::story::{RATES, run, stage};
use edgewalker::game::World;
use edgewalker::tune::Tuning;
use std::sync::Arc;

/// A floor at a height of a tenth, an area that begins there, and one that he passes in three hundredths of a second.
fn level(height: f64) -> String {
    let start = height + 0.25;
    format!(
        "(version: 1, name: \"areas\", start: (0, {start}), goal: (min: (900, 0), max: (901, 1)), bottom: -20, \
         areas: [(name: \"here\", room: (min: (-3, {height}), max: (1, 9)), mood: Dusk), \
         (name: \"gate\", room: (min: (4.1, {height}), max: (4.35, 9)), mood: Works), \
         (name: \"far\", room: (min: (12, {height}), max: (20, 9)), mood: Depths)], \
         features: [(id: \"floor\", outline: [(-20,-2),(20,-2),(20,{height}),(-20,{height})])])"
    )
}

#[test]
fn who_passes_an_area_between_two_ticks_was_in_it() {
    for height in [0.0, 0.1, 0.3, 0.7, 1.1] {
        let stage = stage(&level(height));
        for rate in RATES.iter().chain(&[1, 7]) {
            let mut world = World::new(Arc::clone(&stage), *rate, 0);
            assert_eq!(world.view().area, 0);
            let until = |world: &mut World, time: f64| {
                while world.time() < time {
                    world.step(run(1), &Tuning::default());
                }
                world.view()
            };
            let view = until(&mut world, 1.0);
            assert!(view.position.x > 5.0 && view.position.x < 12.0);
            assert_eq!(view.area, 1, "{rate} Hz at {height}");
            assert_eq!(until(&mut world, 2.0).area, 2);
        }
    }
}
