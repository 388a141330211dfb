//! What can go wrong with the picture, in words for the player's screen and the developer's terminal.

use crate::pieces::PiecesError;
use std::path::PathBuf;

/// Why there is no picture, or no new one.
#[derive(Debug)]
pub enum RenderError {
    /// A shader or a model cannot be read.
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// A shader does not compile.
    Compile {
        /// The file.
        path: PathBuf,
        /// The line of the first error, from 1; 0 if the driver names none.
        line: usize,
        /// The driver's messages.
        log: String,
    },
    /// Two shaders do not fit together.
    Link {
        /// The vertex shader's file.
        vertex: PathBuf,
        /// The fragment shader's file.
        fragment: PathBuf,
        /// The driver's messages.
        log: String,
    },
    /// OpenGL is too old.
    Version {
        /// What there is: major and minor version.
        found: (u32, u32),
    },
    /// The set pieces cannot be used.
    Pieces(PiecesError),
    /// OpenGL refused to make a buffer or a texture.
    Resource(String),
}

impl From<String> for RenderError {
    fn from(what: String) -> Self {
        RenderError::Resource(what)
    }
}

impl From<PiecesError> for RenderError {
    fn from(error: PiecesError) -> Self {
        RenderError::Pieces(error)
    }
}

impl std::fmt::Display for RenderError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            RenderError::Read { path, error } => write!(f, "{}: {error}", path.display()),
            RenderError::Compile { path, line, log } => {
                write!(f, "{}:{line}: {log}", path.display())
            }
            RenderError::Link {
                vertex,
                fragment,
                log,
            } => write!(f, "{} with {}: {log}", vertex.display(), fragment.display()),
            RenderError::Version {
                found: (major, minor),
            } => write!(f, "OpenGL 3.3 is needed, this is OpenGL {major}.{minor}"),
            RenderError::Pieces(error) => write!(f, "{error}"),
            RenderError::Resource(what) => write!(f, "OpenGL: {what}"),
        }
    }
}

impl std::error::Error for RenderError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            RenderError::Read { error, .. } => Some(error),
            _ => None,
        }
    }
}
