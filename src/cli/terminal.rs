//! What is said in the terminal beside the window.

use std::io::Write;

/// One message, with the program's name before it. Where even that cannot be written, nobody is there to read it.
pub fn say(message: impl std::fmt::Display) {
    let _ = writeln!(std::io::stderr(), "edgewalker: {message}");
}
