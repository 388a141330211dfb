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

/// The middle one of some numbers.
pub fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// Times several things in turn, over and over, so that whatever else the machine does meets them all alike: the median
/// of each, ns.
pub fn interleaved(rounds: usize, work: &mut [&mut dyn FnMut()]) -> Vec<f64> {
    let mut times = vec![Vec::with_capacity(rounds); work.len()];
    for _ in 0..rounds {
        for (times, work) in times.iter_mut().zip(work.iter_mut()) {
            times.push(time(work));
        }
    }
    times.into_iter().map(median).collect()
}
