//! The section on the hard cases.

use crate::hard::{self, Case};
use crate::movers;
use crate::page::{Page, metres};
use crate::run;

/// How many cases each mover holds, ours first, and how many there are.
pub struct Held {
    pub names: Vec<&'static str>,
    pub exact: Vec<usize>,
    pub centimetre: Vec<usize>,
    pub cases: usize,
}

/// Good enough for a game that does not look closely, m.
const CENTIMETRE: f64 = 0.01;

pub fn write(page: &mut Page) -> Held {
    page.heading(2, "3. Hard cases");
    page.say(
        "Those of the project's 71 numbered hard cases that any mover can be asked (still geometry, lifts, walking, falling, \
         sliding; `tests/scenes` has all of them for Edgewalker), at 60 Hz. A cell is the largest error in metres of the whole run. \
         **Bold**: exact to 1e-9 m, or to the grid's two steps where a case is finer than the grid. `lost` or \
         many metres: fell through, got stuck, or slid away. The peers fall by semi-implicit Euler, which alone is off by some \
         centimetres at 60 Hz; the columns `mean velocity` show them without that error.",
    );
    let makers = movers::all();
    let names: Vec<&'static str> = makers.iter().map(|maker| maker.name).collect();
    let cases = hard::all();
    let mut held = Held {
        exact: vec![0; names.len()],
        centimetre: vec![0; names.len()],
        cases: cases.len(),
        names,
    };
    let mut rows = Vec::new();
    for case in &cases {
        let mut row = vec![format!("{}: {}", case.number, case.scene.what)];
        for (i, maker) in makers.iter().enumerate() {
            row.push(match (maker.make)(&case.scene) {
                Ok(mut mover) => cell(
                    case,
                    run::error(&mut *mover, &case.scene, hard::RATE),
                    i,
                    &mut held,
                ),
                Err(why) => format!("cannot: {why}"),
            });
        }
        rows.push(row);
    }
    for (name, counts) in [("exact", &held.exact), ("within 1 cm", &held.centimetre)] {
        let cells = counts
            .iter()
            .map(|count| format!("{count} of {}", held.cases));
        rows.push(std::iter::once(name.to_string()).chain(cells).collect());
    }
    let head: Vec<&str> = std::iter::once("case")
        .chain(held.names.iter().copied())
        .collect();
    page.table(&head, &rows);
    held
}

fn cell(case: &Case, error: f64, mover: usize, held: &mut Held) -> String {
    held.centimetre[mover] += usize::from(error <= CENTIMETRE);
    match error <= case.tolerance {
        true => {
            held.exact[mover] += 1;
            format!("**{}**", metres(error))
        }
        false => metres(error),
    }
}
