//! Time.

use std::time::Instant;

/// Takes a result, so that the compiler must compute it.
pub fn keep<T>(result: T) {
    drop(std::hint::black_box(result));
}

/// How long something takes, ns.
pub fn time(mut work: impl FnMut()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e9
}

/// How long making something takes, ns; giving it back is not counted.
pub fn making<T>(make: impl FnOnce() -> T) -> f64 {
    let start = Instant::now();
    let made = std::hint::black_box(make());
    let ns = start.elapsed().as_secs_f64() * 1e9;
    drop(made);
    ns
}

/// The middle one of some numbers.
pub fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// Times several things in turn, over and over, so that whatever else the machine does meets them all alike: the median
/// of each, ns.
pub fn interleaved(rounds: usize, work: &mut [&mut dyn FnMut()]) -> Vec<f64> {
    let mut timed: Vec<_> = work
        .iter_mut()
        .map(|work| move || time(&mut **work))
        .collect();
    let mut timed: Vec<_> = timed
        .iter_mut()
        .map(|t| t as &mut dyn FnMut() -> f64)
        .collect();
    in_turn(rounds, &mut timed)
}

/// The same for things that time themselves.
pub fn in_turn(rounds: usize, work: &mut [&mut dyn FnMut() -> f64]) -> Vec<f64> {
    let mut times = vec![Vec::with_capacity(rounds); work.len()];
    for _ in 0..rounds {
        for (times, work) in times.iter_mut().zip(work.iter_mut()) {
            times.push(work());
        }
    }
    times.into_iter().map(median).collect()
}
