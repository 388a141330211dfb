//! The shell: window, picture, overlay.
