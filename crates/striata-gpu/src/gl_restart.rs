//! Strips on OpenGL: wgpu leaves primitive restart off there, and strips would run into each other.

/// Turns primitive restart on for all that the device will draw, if it is an OpenGL device.
#[cfg(not(any(target_vendor = "apple", target_arch = "wasm32")))]
#[allow(unsafe_code, reason = "wgpu hands out its OpenGL context only to unsafe code")]
pub(crate) fn enable(device: &wgpu::Device) {
    use glow::HasContext;
    // SAFETY: the device is not destroyed, its context is locked and current while it is used, and wgpu never sets or reads this
    // switch, so nothing that it believes of the context becomes wrong.
    unsafe {
        if let Some(device) = device.as_hal::<wgpu::hal::api::Gles>() {
            device.context().lock().enable(glow::PRIMITIVE_RESTART_FIXED_INDEX);
        }
    }
}

/// Metal always restarts strips, and so does WebGL.
#[cfg(any(target_vendor = "apple", target_arch = "wasm32"))]
pub(crate) fn enable(_: &wgpu::Device) {}
