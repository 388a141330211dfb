//! A game controller without a device, through the one part of SDL that the `sdl2` crate does not wrap.

/// A controller that exists in SDL only.
pub struct VirtualPad(i32);

impl VirtualPad {
    /// Plugs it in; SDL must be running.
    pub fn plug_in() -> VirtualPad {
        let kind = sdl2::sys::SDL_JoystickType::SDL_JOYSTICK_TYPE_GAMECONTROLLER;
        // SAFETY: plain numbers in, a device index out; SDL is initialised by the open app.
        let index = unsafe { sdl2::sys::SDL_JoystickAttachVirtual(kind, 6, 15, 0) };
        assert!(index >= 0, "{}", sdl2::get_error());
        VirtualPad(index)
    }

    /// Moves an axis, and presses or releases a button.
    pub fn set(&self, axis: i32, value: i16, button: i32, pressed: bool) {
        // SAFETY: the index is that of a device; SDL refuses axes and buttons that it does not have.
        let done = unsafe {
            let device = sdl2::sys::SDL_JoystickOpen(self.0);
            assert!(!device.is_null());
            let moved = sdl2::sys::SDL_JoystickSetVirtualAxis(device, axis, value);
            let pressed =
                sdl2::sys::SDL_JoystickSetVirtualButton(device, button, u8::from(pressed));
            sdl2::sys::SDL_JoystickClose(device);
            moved + pressed
        };
        assert_eq!(done, 0, "{}", sdl2::get_error());
    }

    /// Pulls it out.
    pub fn pull_out(self) {
        // SAFETY: the index is that of a device that is attached.
        assert_eq!(unsafe { sdl2::sys::SDL_JoystickDetachVirtual(self.0) }, 0);
    }
}
