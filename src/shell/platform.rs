//! The window, its OpenGL context and SDL's subsystems; the only place that opens them.

use super::ShellError;
use super::{render, xlib};
use glow::HasContext;
use sdl2::event::EventSender;
use sdl2::video::{FullscreenType, GLContext, GLProfile, SwapInterval, Window};
use sdl2::{
    AudioSubsystem, EventPump, EventSubsystem, GameControllerSubsystem, Sdl, VideoSubsystem,
};
use std::rc::Rc;
use std::time::Duration;

/// Size in points unless asked otherwise.
const SIZE: (u32, u32) = (1280, 720);
/// Drivers without a picture, which SDL may fall back to; only who names them wants them.
const INVISIBLE: &[&str] = &["offscreen", "dummy", "evdev"];
const DRIVER_VARIABLE: &str = "SDL_VIDEODRIVER";
/// What helps where OpenGL is too old or does not work.
const SOFTWARE: &str = "A newer driver of the graphics card may have it. With Mesa LIBGL_ALWAYS_SOFTWARE=1 draws without the \
                        card, slowly";
/// Displays that do not tell their rate are taken for common ones.
const COMMON_RATE: i32 = 60;

/// What a window may be asked for.
#[derive(Clone, Debug, Default)]
pub struct WindowOptions {
    /// Size in points.
    pub size: Option<(u32, u32)>,
    /// Start in fullscreen.
    pub fullscreen: bool,
    /// Wait for the display.
    pub vsync: bool,
}

/// An open window with everything SDL has to give.
pub struct Platform {
    /// The window.
    pub window: Window,
    /// OpenGL, 3.3 core or newer, current on this thread.
    pub gl: Rc<glow::Context>,
    /// Events as they come.
    pub events: EventPump,
    /// Where controllers are opened.
    pub controllers: GameControllerSubsystem,
    /// Whether swapping buffers waits for the display.
    pub vsync: bool,
    event_system: EventSubsystem,
    video: VideoSubsystem,
    sdl: Sdl,
    _context: GLContext, // current as long as it lives
}

impl Platform {
    /// Opens the window.
    ///
    /// # Errors
    /// There is no display, or none with OpenGL 3.3.
    pub fn open(options: &WindowOptions) -> Result<Platform, ShellError> {
        let failed = |what: &str, e: String| ShellError::Platform(format!("{what}: {e}"));
        let sdl = sdl2::init().map_err(|e| failed("cannot start SDL", e))?;
        let video = sdl.video().map_err(|e| no_display(&e))?;
        refuse_invisible(video.current_video_driver())?;
        if video.current_video_driver() == xlib::DRIVER {
            xlib::listen();
        }
        let (window, context) = open_window(&video, options)?;
        let gl = Rc::new(render::load(|name| video.gl_get_proc_address(name).cast()));
        check_version(&gl)?;
        Ok(Platform {
            vsync: set_vsync(&video, options.vsync),
            events: sdl.event_pump().map_err(|e| failed("no events", e))?,
            controllers: sdl
                .game_controller()
                .map_err(|e| failed("no game controllers", e))?,
            event_system: sdl.event().map_err(|e| failed("no events", e))?,
            window,
            gl,
            video,
            sdl,
            _context: context,
        })
    }

    /// Size of the picture in pixels, never 0.
    pub fn pixels(&self) -> (u32, u32) {
        let (width, height) = self.window.drawable_size();
        (width.max(1), height.max(1))
    }

    /// Time per frame of the display that the window is on.
    pub fn frame_time(&self) -> Duration {
        let mode = self
            .window
            .display_index()
            .and_then(|index| self.video.current_display_mode(index));
        let rate = mode
            .map(|mode| mode.refresh_rate)
            .ok()
            .filter(|rate| *rate > 0);
        Duration::from_secs(1) / rate.unwrap_or(COMMON_RATE).unsigned_abs()
    }

    /// Into fullscreen or out of it; on failure nothing changes.
    pub fn set_fullscreen(&mut self, fullscreen: bool) -> Result<(), String> {
        let wanted = match fullscreen {
            true => FullscreenType::Desktop,
            false => FullscreenType::Off,
        };
        self.window.set_fullscreen(wanted)
    }

    /// Makes the window so many points large.
    pub fn resize(&mut self, width: u32, height: u32) -> Result<(), String> {
        self.window
            .set_size(width, height)
            .map_err(|e| e.to_string())
    }

    /// Waits for the display from now on, or no longer.
    pub fn set_vsync(&mut self, wanted: bool) {
        self.vsync = set_vsync(&self.video, wanted);
    }

    /// Where the mouse is, in pixels of the picture.
    pub fn mouse(&self) -> [f32; 2] {
        let mouse = self.events.mouse_state();
        let ((width, height), (across, down)) = (self.pixels(), self.window.size());
        [
            mouse.x() as f32 * width as f32 / across.max(1) as f32,
            mouse.y() as f32 * height as f32 / down.max(1) as f32,
        ]
    }

    /// Shows or hides the mouse.
    pub fn show_mouse(&self, show: bool) {
        let mouse = self.sdl.mouse();
        if mouse.is_cursor_showing() != show {
            mouse.show_cursor(show);
        }
    }

    /// Puts the mouse at a point of the window.
    pub fn move_mouse(&self, x: i32, y: i32) {
        self.sdl.mouse().warp_mouse_in_window(&self.window, x, y);
    }

    /// Lets the system compose text from keys, or stops that.
    pub fn take_text(&self, take: bool) {
        let text = self.video.text_input();
        match (take, text.is_active()) {
            (true, false) => text.start(),
            (false, true) => text.stop(),
            _ => {}
        }
    }

    /// The clipboard's owner.
    pub fn video(&self) -> &VideoSubsystem {
        &self.video
    }

    /// Whether the picture goes nowhere, by wish.
    pub fn is_invisible(&self) -> bool {
        INVISIBLE.contains(&self.video.current_video_driver())
    }

    /// SDL's sound.
    ///
    /// # Errors
    /// There is no device that could play.
    pub fn audio(&self) -> Result<AudioSubsystem, String> {
        self.sdl.audio()
    }

    /// A way to send events to the window as if from outside.
    pub fn event_sender(&self) -> EventSender {
        self.event_system.event_sender()
    }
}

/// What to do without a display.
fn no_display(reason: &str) -> ShellError {
    let named = |name: &str| match std::env::var(name) {
        Ok(value) => format!("{name} is `{value}`"),
        Err(_) => format!("{name} is not set"),
    };
    ShellError::Platform(format!(
        "no display to open a window on: {reason}. {}, {}. Start it from a desktop; without one, \
         {DRIVER_VARIABLE}=offscreen plays unseen, and --headless --replay FILE plays a recorded run",
        named("DISPLAY"),
        named("WAYLAND_DISPLAY"),
    ))
}

/// SDL falls back to drivers without a picture silently; a player would see nothing at all.
fn refuse_invisible(driver: &str) -> Result<(), ShellError> {
    let asked = std::env::var(DRIVER_VARIABLE).unwrap_or_default();
    if INVISIBLE.contains(&driver) && !asked.split(',').any(|name| name == driver) {
        return Err(no_display("none was found"));
    }
    Ok(())
}

/// A window that the scene is brought to when it is done: it needs no depth and no samples of its own.
fn open_window(
    video: &VideoSubsystem,
    options: &WindowOptions,
) -> Result<(Window, GLContext), ShellError> {
    let attributes = video.gl_attr();
    attributes.set_context_profile(GLProfile::Core);
    attributes.set_context_version(3, 3);
    attributes.set_context_flags().forward_compatible().set();
    attributes.set_double_buffer(true);
    attributes.set_depth_size(0);
    try_window(video, options).map_err(|error| {
        ShellError::Platform(format!(
            "no window with OpenGL 3.3, which the game needs ({error}). {SOFTWARE}"
        ))
    })
}

/// A window and a context that fit the attributes set before.
fn try_window(
    video: &VideoSubsystem,
    options: &WindowOptions,
) -> Result<(Window, GLContext), String> {
    let (width, height) = options.size.unwrap_or(SIZE);
    let mut builder = video.window("Edgewalker", width, height);
    builder
        .opengl()
        .position_centered()
        .resizable()
        .allow_highdpi();
    if options.fullscreen {
        builder.fullscreen_desktop();
    }
    let window = builder.build().map_err(|e| e.to_string())?;
    let context = window.gl_create_context()?;
    window.gl_make_current(&context)?;
    Ok((window, context))
}

/// A driver may give less than was asked for.
fn check_version(gl: &glow::Context) -> Result<(), ShellError> {
    let version = gl.version();
    if (version.major, version.minor) < (3, 3) || version.is_embedded {
        return Err(ShellError::Platform(format!(
            "the game needs OpenGL 3.3, the driver offers {}.{} {}. {SOFTWARE}",
            version.major, version.minor, version.vendor_info
        )));
    }
    Ok(())
}

/// Adaptive vsync (late frames are shown at once), else the plain one, else none. Returns whether there is one.
fn set_vsync(video: &VideoSubsystem, wanted: bool) -> bool {
    let try_set = |interval: SwapInterval| video.gl_set_swap_interval(interval).is_ok();
    let has_vsync =
        wanted && (try_set(SwapInterval::LateSwapTearing) || try_set(SwapInterval::VSync));
    if !has_vsync {
        try_set(SwapInterval::Immediate); // if even that is refused, frames are limited by other means
    }
    has_vsync
}
