//! Shared by the picture tests: a device, and comparisons of pictures.

pub(crate) mod lit;

use striata_render::gpu::{AdapterKind, Gpu, GpuOptions, Picture};

/// Opens a CPU adapter, which draws the same everywhere. Fails if no adapter is available, so that tests
/// never pass untested.
pub(crate) fn gpu() -> Gpu {
    let fallback = Gpu::new(&GpuOptions { kind: AdapterKind::Cpu, ..GpuOptions::default() });
    fallback
        .or_else(|_| Gpu::new(&GpuOptions::default()))
        .expect("these tests need a graphics adapter; install mesa-vulkan-drivers for a CPU one")
}

/// Counts the pixels of two equally large pictures that differ in a channel by more than `tolerance` of 255.
pub(crate) fn differing_pixels(a: &Picture, b: &Picture, tolerance: u8) -> usize {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let differ = |(p, q): (&[u8], &[u8])| p.iter().zip(q).any(|(&x, &y)| x.abs_diff(y) > tolerance);
    a.rgba.chunks(4).zip(b.rgba.chunks(4)).filter(|&pair| differ(pair)).count()
}

/// Counts the pixels that differ from the background, taken from the first corner.
pub(crate) fn drawn_pixels(picture: &Picture) -> usize {
    let background = &picture.rgba[..4];
    picture.rgba.chunks(4).filter(|&pixel| pixel != background).count()
}
