//! What the tests of pictures share: a device, and how far two pictures are apart.

use striata_gpu::{Gpu, GpuOptions, Picture};

/// A device that draws on the processor: the same everywhere. Tests must not pass for want of one.
pub(crate) fn gpu() -> Gpu {
    let fallback = Gpu::new(&GpuOptions::default().with_fallback(true));
    fallback
        .or_else(|_| Gpu::new(&GpuOptions::default()))
        .expect("pictures are tested on an adapter that draws on the processor: install mesa-vulkan-drivers")
}

/// Pixels of two pictures of one size that differ in a channel by more than `tolerance` of 255.
#[allow(dead_code, reason = "not every test compares pictures")]
pub(crate) fn differing_pixels(a: &Picture, b: &Picture, tolerance: u8) -> usize {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let differ = |(p, q): (&[u8], &[u8])| p.iter().zip(q).any(|(&x, &y)| x.abs_diff(y) > tolerance);
    a.rgba.chunks(4).zip(b.rgba.chunks(4)).filter(|&pair| differ(pair)).count()
}

/// Pixels that show something else than the background in the first corner.
#[allow(dead_code, reason = "not every test counts pixels")]
pub(crate) fn drawn_pixels(picture: &Picture) -> usize {
    let background = &picture.rgba[..4];
    picture.rgba.chunks(4).filter(|&pixel| pixel != background).count()
}
