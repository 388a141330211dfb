//! Times and counts of the last frames, and their graphs.

use super::style::{FAINT, size};
use imgui::Ui;

/// Frames that a graph shows.
const FRAMES: usize = 240;

/// The last values of one quantity, the oldest first.
#[derive(Debug, Default)]
pub struct Series(Vec<f32>);

impl Series {
    /// Adds a value; the oldest goes.
    pub fn push(&mut self, value: f32) {
        if self.0.len() == FRAMES {
            self.0.remove(0);
        }
        self.0.push(value);
    }

    /// The mean, and the largest.
    pub fn summary(&self) -> (f32, f32) {
        let count = self.0.len().max(1) as f32;
        (
            self.0.iter().sum::<f32>() / count,
            self.0.iter().copied().fold(0.0, f32::max),
        )
    }
}

/// What is measured of every frame.
#[derive(Debug, Default)]
pub struct Stats {
    /// Milliseconds from one frame to the next.
    pub frame: Series,
    /// Microseconds spent on each tick, in frames with ticks.
    pub tick: Series,
    /// Motion events per tick, in frames with ticks.
    pub events: Series,
}

/// The section with the graphs.
pub fn section(ui: &Ui, stats: &Stats) {
    graph(ui, "Frame", "ms", &stats.frame, 1);
    graph(ui, "Tick", "µs", &stats.tick, 1);
    graph(ui, "Events per tick", "", &stats.events, 2);
}

/// A line over the last frames, from 0 to a little above the largest value, with the figures beside its name.
fn graph(ui: &Ui, name: &str, unit: &str, series: &Series, digits: usize) {
    let (mean, top) = series.summary();
    ui.text(name);
    ui.same_line();
    ui.text_colored(
        FAINT,
        format!("mean {mean:.digits$}  max {top:.digits$} {unit}"),
    );
    ui.plot_lines(format!("##{name}"), &series.0)
        .scale_min(0.0)
        .scale_max((top * 1.1).max(1e-3))
        .graph_size([ui.content_region_avail()[0], size(ui, 2.6)])
        .build();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_series_keeps_the_last_values() {
        let mut series = Series::default();
        (0..1000).for_each(|n| series.push(n as f32));
        assert_eq!(series.0.len(), FRAMES);
        assert_eq!(series.summary(), (879.5, 999.0));
    }
}
