//! The developers' overlay, through ImGui.
//!
//! It reads the game ([`Info`]) and answers with values ([`Edit`]); it never reaches into the world.

pub mod panel;
pub mod scene;
pub mod stats;
pub mod style;
pub mod tunables;

use super::ShellError;
use super::edits::Edit;
use super::notices::Notices;
use super::platform::Platform;
use super::play::Play;
use crate::cli::files::{self, FileError};
use crate::game::View;
use crate::tune::Tuning;
use imgui::{
    ClipboardBackend, ConfigFlags, Context, FontConfig, FontGlyphRanges, FontSource, Key,
    MouseButton, Textures,
};
use imgui_glow_renderer::Renderer;
use imgui_sdl2_support::SdlPlatform;
use sdl2::clipboard::ClipboardUtil;
use sdl2::event::Event;
use std::path::{Path, PathBuf};
use std::rc::Rc;

const FONT_FILE: &str = "assets/fonts/DejaVuSans.ttf";
/// Characters that are drawn: Latin, and some punctuation.
const GLYPHS: &[u32] = &[0x20, 0xff, 0x2013, 0x2026, 0];
/// Text lines that the picture's height holds, and the limits of the text's height in pixels.
const LINES: f32 = 48.0;
const TEXT: (f32, f32) = (13.0, 48.0);
/// Text height at which sizes are as the style names them.
const STYLE_TEXT: f32 = 15.0;

/// What the panels show of one frame.
pub struct Info<'a> {
    /// The world and its run.
    pub play: &'a Play,
    /// The moment that is drawn.
    pub view: &'a View,
    /// Tunables, and their file.
    pub tuning: &'a Tuning,
    /// The file.
    pub tuning_path: &'a Path,
    /// The level that is played.
    pub level_path: &'a Path,
    /// Levels to choose from.
    pub levels: &'a [PathBuf],
    /// Size of the mesh that the hero moves in.
    pub mesh_size: MeshSize,
    /// Times and counts.
    pub stats: &'a stats::Stats,
    /// Problems and notices.
    pub notices: &'a Notices,
    /// Where input comes from and goes to, in words.
    pub source: &'a str,
    /// Time stands still.
    pub paused: bool,
    /// Speed of time.
    pub scale: f64,
}

/// How much there is of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MeshSize {
    /// Vertices.
    pub vertices: usize,
    /// Edges, each counted once.
    pub edges: usize,
    /// Faces.
    pub faces: usize,
    /// Faces that are solid.
    pub solid: usize,
    /// Features of the level.
    pub features: usize,
}

/// ImGui, and what is shown.
pub struct Overlay {
    /// The panel is open.
    pub open: bool,
    /// What is drawn over the scene while it is open.
    pub show: scene::Show,
    panel: panel::Panel,
    base_style: imgui::Style,
    context: Context,
    platform: SdlPlatform,
    renderer: Renderer,
    textures: Textures<glow::Texture>,
    font_file: Vec<u8>,
    text_pixels: f32,
    gl: Rc<glow::Context>,
}

impl Overlay {
    /// Makes ImGui ready for a window; there can be one at a time in a process.
    ///
    /// # Errors
    /// The font is missing, or OpenGL fails.
    pub fn new(window: &Platform) -> Result<Overlay, ShellError> {
        let font_file = read_font(&files::find(Path::new(FONT_FILE)))?;
        let mut context = Context::create();
        context.set_ini_filename(None);
        context.set_clipboard_backend(Clipboard(window.video().clipboard()));
        context.io_mut().config_flags |= ConfigFlags::NO_MOUSE_CURSOR_CHANGE;
        let platform = SdlPlatform::new(&mut context);
        let text_pixels = text_pixels(window);
        load_font(&mut context, &font_file, text_pixels);
        let mut textures = Textures::new();
        let renderer = make_renderer(&window.gl, &mut context, &mut textures)?;
        Ok(Overlay {
            open: false,
            show: scene::Show {
                place: true,
                contact: true,
                velocity: true,
                path: true,
                ..scene::Show::default()
            },
            panel: panel::Panel::default(),
            base_style: *context.style(),
            context,
            platform,
            renderer,
            textures,
            font_file,
            text_pixels,
            gl: window.gl.clone(),
        })
    }

    /// Takes note of an event.
    pub fn handle(&mut self, event: &Event) {
        self.platform.handle_event(&mut self.context, event);
    }

    /// Lets go of every key and button: whoever takes the focus away keeps their release to himself.
    pub fn release_all(&mut self) {
        let io = self.context.io_mut();
        // From the mouse on, keys are aliases of other inputs, and ImGui takes no events for those.
        let keys = Key::VARIANTS
            .into_iter()
            .take_while(|key| *key != Key::MouseLeft);
        for key in keys.chain([Key::ModCtrl, Key::ModShift, Key::ModAlt, Key::ModSuper]) {
            io.add_key_event(key, false);
        }
        for button in MouseButton::VARIANTS {
            io.add_mouse_button_event(button, false);
        }
    }

    /// Whether the keyboard belongs to a field of the panel.
    pub fn typing(&self) -> bool {
        let io = self.context.io();
        self.open && (io.want_capture_keyboard || io.want_text_input)
    }

    /// Whether the mouse belongs to the panel.
    pub fn takes_mouse(&self) -> bool {
        self.open && self.context.io().want_capture_mouse
    }

    /// Share of the picture's width that the panel covers.
    pub fn covered(&self, window: &Platform) -> f64 {
        let width = window.pixels().0 as f32;
        let share = if self.open {
            panel::width(self.text_pixels, width) / width
        } else {
            0.0
        };
        f64::from(share)
    }

    /// Draws over the picture; returns what was asked for.
    ///
    /// # Errors
    /// OpenGL fails.
    pub fn draw(&mut self, window: &Platform, info: &Info) -> Result<Vec<Edit>, ShellError> {
        self.fit_text(window)?;
        self.platform
            .prepare_frame(&mut self.context, &window.window, &window.events);
        let mut edits = Vec::new();
        let ui = self.context.new_frame();
        if self.open {
            panel::draw(ui, &mut self.panel, info, &mut self.show, &mut edits);
        }
        let data = self.context.render();
        if data.total_vtx_count > 0 {
            self.renderer
                .render(&self.gl, &self.textures, data)
                .map_err(picture_failed)?;
        }
        Ok(edits)
    }

    /// Makes the text anew when the size of the picture asks for another one.
    fn fit_text(&mut self, window: &Platform) -> Result<(), ShellError> {
        let wanted = text_pixels(window);
        if wanted != self.text_pixels {
            self.text_pixels = wanted;
            self.renderer.destroy(&self.gl);
            self.textures = Textures::new();
            load_font(&mut self.context, &self.font_file, wanted);
            self.renderer = make_renderer(&self.gl, &mut self.context, &mut self.textures)?;
        }
        let density = window.pixels().1 as f32 / window.window.size().1.max(1) as f32;
        self.context.io_mut().font_global_scale = 1.0 / density;
        *self.context.style_mut() = style::make(&self.base_style, wanted / density / STYLE_TEXT);
        Ok(())
    }
}

impl Drop for Overlay {
    fn drop(&mut self) {
        self.renderer.destroy(&self.gl);
    }
}

/// Height of the text in pixels: a share of the picture's, within reason.
fn text_pixels(window: &Platform) -> f32 {
    (window.pixels().1 as f32 / LINES)
        .clamp(TEXT.0, TEXT.1)
        .round()
}

/// The font's bytes; ImGui would end the process if they were no font.
fn read_font(path: &Path) -> Result<Vec<u8>, FileError> {
    let bytes = files::read(path)?;
    if !bytes.starts_with(&[0, 1, 0, 0]) {
        return Err(FileError::new(path, "is not a TrueType font"));
    }
    Ok(bytes)
}

fn load_font(context: &mut Context, file: &[u8], size_pixels: f32) {
    let atlas = context.fonts();
    atlas.clear();
    let config = FontConfig {
        glyph_ranges: FontGlyphRanges::from_slice(GLYPHS),
        ..FontConfig::default()
    };
    atlas.add_font(&[FontSource::TtfData {
        data: file,
        size_pixels,
        config: Some(config),
    }]);
}

fn make_renderer(
    gl: &glow::Context,
    context: &mut Context,
    textures: &mut Textures<glow::Texture>,
) -> Result<Renderer, ShellError> {
    let to_srgb = true; // the framebuffer is not an sRGB one
    Renderer::new(gl, context, textures, to_srgb).map_err(picture_failed)
}

fn picture_failed(error: impl std::fmt::Display) -> ShellError {
    ShellError::Platform(format!("overlay: {error}"))
}

/// The system's clipboard.
struct Clipboard(ClipboardUtil);

impl ClipboardBackend for Clipboard {
    fn get(&mut self) -> Option<String> {
        self.0.clipboard_text().ok()
    }

    fn set(&mut self, value: &str) {
        let _ = self.0.set_clipboard_text(value); // there may be no clipboard
    }
}
