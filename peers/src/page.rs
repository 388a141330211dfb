//! The report as it grows: text, tables, plots beside it.

pub use plotters::prelude::SeriesLabelPosition;
use plotters::prelude::*;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// A page of Markdown in a folder, with its pictures.
pub struct Page {
    folder: PathBuf,
    text: String,
}

/// One line of a plot.
pub struct Line {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

/// What a plot's axes say, and where they begin upwards: what is below that, is drawn there.
pub struct Axes {
    pub title: &'static str,
    pub x: &'static str,
    pub y: &'static str,
    pub floor: f64,
    /// Where there is room for the names of the lines.
    pub legend: SeriesLabelPosition,
}

/// The colours of the lines, in order: told apart by who sees few colours, too.
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 0, 0),
    RGBColor(213, 94, 0),
    RGBColor(0, 114, 178),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(150, 150, 150),
];

impl Page {
    pub fn new(folder: &Path) -> Page {
        std::fs::create_dir_all(folder).expect("a folder for the report");
        Page {
            folder: folder.to_path_buf(),
            text: String::new(),
        }
    }

    /// A heading with a number of hashes before it.
    pub fn heading(&mut self, level: usize, text: &str) {
        let _ = writeln!(self.text, "{} {text}\n", "#".repeat(level));
    }

    /// A paragraph.
    pub fn say(&mut self, text: &str) {
        let words: Vec<&str> = text.split_whitespace().collect();
        let _ = writeln!(self.text, "{}\n", words.join(" "));
    }

    /// A list.
    pub fn list(&mut self, items: &[String]) {
        items.iter().for_each(|item| {
            let _ = writeln!(self.text, "- {item}");
        });
        self.text.push('\n');
    }

    /// A table; all columns but the first are right-aligned.
    pub fn table(&mut self, head: &[&str], rows: &[Vec<String>]) {
        let _ = writeln!(self.text, "| {} |", head.join(" | "));
        let _ = writeln!(self.text, "|---|{}", "---:|".repeat(head.len() - 1));
        for row in rows {
            let _ = writeln!(self.text, "| {} |", row.join(" | "));
        }
        self.text.push('\n');
    }

    /// A plot with logarithmic axes, as a file beside the page.
    pub fn plot(&mut self, file: &str, axes: &Axes, lines: &[Line]) {
        draw(&self.folder.join(file), axes, lines).expect("a plot in the report's folder");
        let _ = writeln!(self.text, "![{}]({file})\n", axes.title);
    }

    /// Puts a text in the place of a mark.
    pub fn fill(&mut self, mark: &str, text: &str) {
        self.text = self.text.replace(mark, text);
    }

    pub fn write(&self) {
        std::fs::write(self.folder.join("README.md"), &self.text)
            .expect("the report can be written");
    }
}

/// The powers of ten around some numbers.
fn decades(numbers: impl Iterator<Item = f64> + Clone) -> std::ops::Range<f64> {
    let low = numbers
        .clone()
        .fold(f64::INFINITY, f64::min)
        .log10()
        .floor();
    let high = numbers.fold(0.0, f64::max).log10().ceil().max(low + 1.0);
    10f64.powf(low)..10f64.powf(high)
}

fn draw(path: &Path, axes: &Axes, lines: &[Line]) -> Result<(), Box<dyn std::error::Error>> {
    let area = SVGBackend::new(path, (760, 420)).into_drawing_area();
    area.fill(&WHITE)?;
    let shown = |y: f64| y.max(axes.floor).min(1e4);
    let all = lines.iter().flat_map(|line| &line.points);
    let (xs, ys) = (
        decades(all.clone().map(|p| p.0)),
        decades(all.map(|p| shown(p.1)).chain(std::iter::once(axes.floor))),
    );
    let mut chart = ChartBuilder::on(&area)
        .caption(axes.title, ("sans-serif", 19))
        .margin(8)
        .margin_right(16)
        .x_label_area_size(38)
        .y_label_area_size(62)
        .build_cartesian_2d(xs.log_scale(), ys.log_scale())?;
    let power = |value: &f64| format!("1e{:.0}", value.log10());
    chart
        .configure_mesh()
        .x_desc(axes.x)
        .y_desc(axes.y)
        .light_line_style(TRANSPARENT)
        .label_style(("sans-serif", 15))
        .axis_desc_style(("sans-serif", 16))
        .x_label_formatter(&power)
        .y_label_formatter(&power)
        .draw()?;
    for (line, colour) in lines.iter().zip(COLOURS.iter().cycle()) {
        let points = || line.points.iter().map(|&(x, y)| (x, shown(y)));
        let width = if *colour == BLACK { 3 } else { 2 };
        chart
            .draw_series(LineSeries::new(points(), colour.stroke_width(width)))?
            .label(&line.name)
            .legend(move |(x, y)| {
                PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(width))
            });
        chart.draw_series(points().map(|p| Circle::new(p, 3, colour.filled())))?;
    }
    chart
        .configure_series_labels()
        .position(axes.legend.clone())
        .background_style(WHITE.mix(0.8))
        .border_style(RGBColor(200, 200, 200))
        .label_font(("sans-serif", 15))
        .draw()?;
    area.present()?;
    Ok(())
}

/// An error in words of the tables: m.
pub fn metres(error: f64) -> String {
    match error {
        e if !e.is_finite() => "lost".to_string(),
        0.0 => "0".to_string(),
        e if e < 0.001 => format!("{e:.0e}"),
        e if e < 1.0 => format!("{e:.3}"),
        e if e < 100.0 => format!("{e:.1}"),
        e => format!("{e:.0e}"),
    }
}

/// A time, from ns.
pub fn time(ns: f64) -> String {
    match ns {
        ns if ns < 100.0 => format!("{ns:.1} ns"),
        ns if ns < 1e4 => format!("{ns:.0} ns"),
        ns if ns < 1e6 => format!("{:.1} µs", ns / 1e3),
        ns if ns < 1e7 => format!("{:.2} ms", ns / 1e6),
        ns if ns < 1e9 => format!("{:.0} ms", ns / 1e6),
        ns => format!("{:.2} s", ns / 1e9),
    }
}
