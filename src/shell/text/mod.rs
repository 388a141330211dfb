//! Text of menus and of the heads-up display: sharp at any size, kerned, drawn with one call a page.
//!
//! A page is filled from the back to the front with rectangles, drawings and lines of text, all of them in pixels from the top
//! left corner. Letters are rasterised at exactly the size that is asked for and kept in one picture ([`atlas`]). What no font
//! has is shown as a box. Nothing here needs OpenGL but [`Pass`], which shows a page.

mod atlas;
mod fonts;
mod page;
mod pass;
mod symbols;

pub use fonts::{Face, Fonts};
pub use page::{Colour, Rect, Style, Text};
pub use pass::Pass;
pub use symbols::Symbol;
