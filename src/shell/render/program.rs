//! Shaders from files: includes, and errors that name the file and the line.
//!
//! The files have no `#version` line; every one is compiled as GLSL 3.30 core. `#include "name"` takes in another file of
//! the same directory. `#line` directives number the files, so that the driver's messages can be traced back.

use super::RenderError;
use super::gl::{Gl, Program};
use super::state::Stage;
use std::path::{Path, PathBuf};

/// Uniform blocks by name, in the order of their binding points.
pub const BLOCKS: [&str; 2] = ["FrameBlock", "HeroBlock"];

/// Samplers by name, in the order of the texture units that they read.
pub const SAMPLERS: [&str; 5] = [
    "shadow_map",
    "light_map",
    "bloom_map",
    "screen_map",
    "piece_light",
];

/// Where shaders come from: their directory, and the lines that are put before each.
pub struct Library<'a> {
    /// The directory.
    pub dir: &'a Path,
    /// Lines with `#define`.
    pub defines: &'a str,
}

/// Reads, compiles and links `<vertex>.vert` with `<fragment>.frag`.
pub fn load(
    gl: &Gl,
    library: &Library,
    vertex: &str,
    fragment: &str,
) -> Result<Program, RenderError> {
    let vertex = Source::read(library, &format!("{vertex}.vert"))?;
    let fragment = Source::read(library, &format!("{fragment}.frag"))?;
    gl.program(&vertex.text, &fragment.text, (&BLOCKS, &SAMPLERS))
        .map_err(|error| match error.stage {
            Some(Stage::Vertex) => vertex.locate(&error.log),
            Some(Stage::Fragment) => fragment.locate(&error.log),
            None => RenderError::Link {
                vertex: vertex.files[0].clone(),
                fragment: fragment.files[0].clone(),
                log: error.log,
            },
        })
}

/// The text of one shader with everything it includes.
struct Source {
    text: String,
    /// The files it was put together from; their index is their number in `#line`.
    files: Vec<PathBuf>,
}

impl Source {
    fn read(library: &Library, name: &str) -> Result<Source, RenderError> {
        let mut source = Source {
            text: format!("#version 330 core\n{}", library.defines),
            files: Vec::new(),
        };
        source.add(library.dir, name)?;
        Ok(source)
    }

    /// Appends a file; one that is there already is left out, which also ends circles.
    fn add(&mut self, dir: &Path, name: &str) -> Result<(), RenderError> {
        let path = dir.join(name);
        if self.files.contains(&path) {
            return Ok(());
        }
        let text = std::fs::read_to_string(&path).map_err(|error| RenderError::Read {
            path: path.clone(),
            error,
        })?;
        let number = self.files.len();
        self.files.push(path);
        self.text += &format!("#line 1 {number}\n");
        for (index, line) in text.lines().enumerate() {
            if let Some(included) = line.trim().strip_prefix("#include") {
                self.add(dir, included.trim().trim_matches('"'))?;
                self.text += &format!("#line {} {number}\n", index + 2);
            } else {
                self.text += line;
                self.text.push('\n');
            }
        }
        Ok(())
    }

    /// Turns the driver's message into an error with file and line.
    fn locate(&self, log: &str) -> RenderError {
        let (file, line) = position(log).unwrap_or((0, 0));
        let path = self.files.get(file).unwrap_or(&self.files[0]).clone();
        RenderError::Compile {
            path,
            line,
            log: log.trim().to_string(),
        }
    }
}

/// File number and line of the first message: `0:12(5): error` (Mesa), `0(12) : error` (NVIDIA), `ERROR: 0:12:` (others).
fn position(log: &str) -> Option<(usize, usize)> {
    log.lines().find_map(|line| {
        let start = line.find(|c: char| c.is_ascii_digit())?;
        let mut numbers = line[start..].split(|c: char| !c.is_ascii_digit());
        Some((numbers.next()?.parse().ok()?, numbers.next()?.parse().ok()?))
    })
}

#[cfg(test)]
mod tests {
    use super::position;

    #[test]
    fn messages_of_three_drivers_are_understood() {
        assert_eq!(position("2:12(5): error: `x' undeclared"), Some((2, 12)));
        assert_eq!(
            position("2(12) : error C1008: undefined variable \"x\""),
            Some((2, 12))
        );
        assert_eq!(
            position("ERROR: 2:12: 'x' : undeclared identifier"),
            Some((2, 12))
        );
        assert_eq!(position("no numbers at all"), None);
    }
}
