//! Edgewalker side by side with other movers and meshes: speed against error, as a report.
//!
//! `peers [--quick] FOLDER` measures everything and writes the report and its plots into the folder.
//!
//! In reading order: [`scene`] and [`scenes`] (what is to be done), [`movers`] (who does it), [`level`] (the recorded run),
//! [`meshes`] (who holds the geometry), [`flat`] and [`swept`] (our own core with pieces swapped), [`reference`] (the slow
//! reference of the tests); then the sections of the report, each a file; [`page`] (text, tables, plots), [`clock`], [`memory`].

mod cases;
mod clock;
mod exactness;
mod flat;
mod floors;
mod hard;
mod level;
mod machine;
mod memory;
mod meshes;
mod movers;
mod page;
mod precision;
mod published;
mod recorded;
mod reference;
mod run;
mod scaling;
mod scene;
mod scenes;
mod stability;
mod summary;
mod swept;

use page::Page;
use std::path::PathBuf;
use std::time::Instant;

fn main() {
    let (flags, folders): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|a| a.starts_with("--"));
    let quick = flags.iter().any(|flag| flag == "--quick");
    let folder = folders
        .first()
        .map_or_else(|| PathBuf::from("report"), PathBuf::from);
    let start = Instant::now();
    let done = |section: &str| eprintln!("{:6.1} s: {section}", start.elapsed().as_secs_f64());
    let mut page = Page::new(&folder);
    summary::begin(&mut page);
    let precision = precision::write(&mut page, quick);
    done("work against precision");
    let recorded = recorded::write(&mut page, quick);
    done("the recorded run");
    exactness::write(&mut page, quick);
    done("exactness");
    let held = cases::write(&mut page);
    floors::write(&mut page);
    done("hard cases and floors");
    let scaling = scaling::write(&mut page, quick);
    done("scaling");
    stability::write(&mut page, quick);
    done("stability");
    published::write(&mut page, quick);
    done("published figures");
    summary::settings(&mut page);
    summary::fill(&mut page, &precision, &recorded, &held, &scaling);
    page.write();
    done("written");
}
