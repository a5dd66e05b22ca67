//! Primitive restart on OpenGL, which wgpu leaves off there, so that strips would run into each other.

/// Enables primitive restart for everything the device draws, if it is an OpenGL device.
#[cfg(not(any(target_vendor = "apple", target_arch = "wasm32")))]
#[allow(unsafe_code, reason = "wgpu hands out its OpenGL context only to unsafe code")]
pub(crate) fn enable(device: &wgpu::Device) {
    use glow::HasContext;
    // SAFETY: the device is alive, its context is locked and current while it is used, and wgpu never
    // sets or reads this switch, so none of the state that wgpu tracks becomes wrong.
    unsafe {
        if let Some(device) = device.as_hal::<wgpu::hal::api::Gles>() {
            device.context().lock().enable(glow::PRIMITIVE_RESTART_FIXED_INDEX);
        }
    }
}

/// Does nothing: Metal and WebGL always restart strips.
#[cfg(any(target_vendor = "apple", target_arch = "wasm32"))]
pub(crate) fn enable(_: &wgpu::Device) {}
