//! What X servers complain of, in our words. By itself the library that talks to them prints codes, and ends the program.
#![allow(unsafe_code)]

use crate::cli::terminal;
use std::ffi::{CStr, c_char, c_int, c_uchar, c_ulong, c_void};
use std::sync::atomic::{AtomicBool, Ordering};

/// The library, as SDL has loaded it.
const LIBRARY: &CStr = c"libX11.so.6";
/// The driver of SDL's that uses it.
pub const DRIVER: &str = "x11";

/// What was refused: the library's `XErrorEvent`.
#[repr(C)]
struct Refusal {
    kind: c_int,
    display: *mut c_void,
    resource: c_ulong,
    serial: c_ulong,
    error: c_uchar,
    request: c_uchar,
    part: c_uchar,
}

type OnRefusal = extern "C" fn(*mut c_void, *const Refusal) -> c_int;
type OnLoss = extern "C" fn(*mut c_void) -> c_int;

/// Whether a refusal was told: many tend to follow.
static IS_TOLD: AtomicBool = AtomicBool::new(false);

/// What was asked for does not happen, and who asked finds out or can do without.
extern "C" fn refused(_: *mut c_void, refusal: *const Refusal) -> c_int {
    // SAFETY: the library gives an event of its own that lives as long as this call.
    let (error, request, part) = unsafe { ((*refusal).error, (*refusal).request, (*refusal).part) };
    if !IS_TOLD.swap(true, Ordering::Relaxed) {
        terminal::say(format!(
            "the display refuses something (error {error} of request {request}.{part}), which may be of no account"
        ));
    }
    0
}

/// There is nothing to go on with; the library ends the program if this does not.
extern "C" fn lost(_: *mut c_void) -> c_int {
    terminal::say(
        "the display has gone away: what is recorded and reached is in its files, but for the last half second",
    );
    std::process::exit(1)
}

/// Listens to what servers complain of. SDL must be running, on [`DRIVER`].
pub fn listen() {
    // SAFETY: the names are those of functions that take one function each and give the one before. SDL keeps the library
    // loaded as long as it runs; it is loaded once more here and never let go, so that both functions stay.
    unsafe {
        let library = sdl2::sys::SDL_LoadObject(LIBRARY.as_ptr());
        let find =
            |name: &CStr| sdl2::sys::SDL_LoadFunction(library, name.as_ptr().cast::<c_char>());
        if library.is_null() {
            return;
        }
        let (refusals, losses) = (find(c"XSetErrorHandler"), find(c"XSetIOErrorHandler"));
        if refusals.is_null() || losses.is_null() {
            return;
        }
        let on_refusal: extern "C" fn(OnRefusal) -> *mut c_void = std::mem::transmute(refusals);
        let on_loss: extern "C" fn(OnLoss) -> *mut c_void = std::mem::transmute(losses);
        on_refusal(refused);
        on_loss(lost);
    }
}
