//! Reduction of images by a triangle filter, one row at a time.
//!
//! Each output pixel averages the input under a triangle twice as wide as the output pixel, which neither
//! rings nor aliases visibly. Only a few rows of floats are kept, so the memory is that of the two images.

use std::collections::VecDeque;

use super::role::TextureRole;

/// An image of 8-bit RGBA pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Pixels {
    pub width: u32,
    pub height: u32,
    /// Four bytes per pixel, row by row.
    pub rgba: Vec<u8>,
}

/// Returns the size of an image of which no side is longer than `max_side`, with the same aspect.
pub(super) fn reduced_size(width: u32, height: u32, max_side: u32) -> [u32; 2] {
    let longest = width.max(height);
    if longest <= max_side {
        return [width, height];
    }
    let scaled = |side: u32| {
        let side = u64::from(side) * u64::from(max_side);
        ((side + u64::from(longest) / 2) / u64::from(longest)).max(1) as u32
    };
    [scaled(width), scaled(height)]
}

/// Reduces an image; no side of the result may be longer than before.
pub(super) fn reduce(image: &Pixels, [width, height]: [u32; 2], role: TextureRole) -> Pixels {
    let columns = filter(image.width, width);
    let rows = filter(image.height, height);
    let mut out = Pixels { width, height, rgba: Vec::with_capacity(width as usize * height as usize * 4) };
    let mut kept: VecDeque<Vec<[f32; 4]>> = VecDeque::new();
    let (mut first_kept, mut next_row) = (0, 0);
    let mut line = vec![[0.0f32; 4]; width as usize];
    for taps in &rows {
        while first_kept < taps.first {
            kept.pop_front();
            first_kept += 1;
        }
        while next_row < taps.first + taps.weights.len() {
            kept.push_back(reduced_row(image, next_row, &columns, role));
            next_row += 1;
        }
        line.fill([0.0; 4]);
        for (row, &weight) in kept.iter().zip(&taps.weights) {
            for (sum, pixel) in line.iter_mut().zip(row) {
                (0..4).for_each(|channel| sum[channel] += weight * pixel[channel]);
            }
        }
        out.rgba.extend(line.iter().flat_map(|&pixel| role.pixel(pixel)));
    }
    out
}

/// The input that an output row or column is made from.
struct ResampleTaps {
    first: usize,
    /// Weights of consecutive inputs; they add up to 1.
    weights: Vec<f32>,
}

/// Returns the taps of each output along one axis.
fn filter(from: u32, to: u32) -> Vec<ResampleTaps> {
    let scale = f64::from(from) / f64::from(to);
    if from == to {
        return (0..from as usize).map(|first| ResampleTaps { first, weights: vec![1.0] }).collect();
    }
    let of_output = |index: u32| {
        let center = (f64::from(index) + 0.5) * scale;
        let first = (center - scale).floor().max(0.0) as usize;
        let end = ((center + scale).ceil() as usize).min(from as usize).max(first + 1);
        let weight = |at: usize| (1.0 - ((at as f64 + 0.5 - center) / scale).abs()).max(0.0);
        let sum: f64 = (first..end).map(weight).sum();
        ResampleTaps { first, weights: (first..end).map(|at| (weight(at) / sum) as f32).collect() }
    };
    (0..to).map(of_output).collect()
}

/// Converts a row to linear numbers and filters it along the row.
fn reduced_row(image: &Pixels, row: usize, columns: &[ResampleTaps], role: TextureRole) -> Vec<[f32; 4]> {
    let width = image.width as usize;
    let (bytes, _) = image.rgba[row * width * 4..(row + 1) * width * 4].as_chunks::<4>();
    let linear: Vec<[f32; 4]> = bytes.iter().map(|&pixel| role.numbers(pixel)).collect();
    let reduced = columns.iter().map(|taps| {
        let mut sum = [0.0f32; 4];
        for (pixel, &weight) in linear[taps.first..].iter().zip(&taps.weights) {
            (0..4).for_each(|channel| sum[channel] += weight * pixel[channel]);
        }
        sum
    });
    reduced.collect()
}

#[cfg(test)]
mod tests {
    use super::super::role::{AlphaUse, TextureTransfer};
    use super::*;

    fn role(transfer: TextureTransfer, alpha: AlphaUse) -> TextureRole {
        TextureRole { transfer, alpha }
    }

    /// A board of single pixels in two colors.
    fn board(side: u32, colors: [[u8; 4]; 2]) -> Pixels {
        let cells = (0..side).flat_map(|y| (0..side).map(move |x| (x + y) % 2));
        let rgba = cells.flat_map(|cell| colors[cell as usize]).collect();
        Pixels { width: side, height: side, rgba }
    }

    #[test]
    fn colors_are_averaged_in_linear_light_and_numbers_are_not() {
        let image = board(64, [[0, 0, 0, 255], [255, 255, 255, 255]]);
        let center = |role| {
            let small = reduce(&image, [8, 8], role);
            small.rgba[(4 * 8 + 4) * 4..][..4].to_vec()
        };
        assert_eq!(center(role(TextureTransfer::Srgb, AlphaUse::Unused)), [188, 188, 188, 255]);
        assert_eq!(center(role(TextureTransfer::Linear, AlphaUse::Unused)), [128, 128, 128, 255]);
    }

    #[test]
    fn invisible_pixels_do_not_color_their_neighbors() {
        let image = board(64, [[200, 10, 10, 255], [0, 255, 0, 0]]);
        let small = reduce(&image, [8, 8], role(TextureTransfer::Srgb, AlphaUse::Coverage));
        let pixel = &small.rgba[(3 * 8 + 3) * 4..][..4];
        assert!(pixel[0] >= 199 && pixel[1] <= 20 && pixel[3] == 128, "{pixel:?}");
        let clear = board(8, [[9, 90, 200, 0], [9, 90, 200, 0]]);
        let small = reduce(&clear, [2, 2], role(TextureTransfer::Srgb, AlphaUse::Coverage));
        assert_eq!(small.rgba[..4], [9, 90, 200, 0]);
    }

    #[test]
    fn normals_have_unit_length_after_averaging() {
        let image = board(64, [[217, 128, 217, 255], [38, 128, 217, 255]]);
        let small = reduce(&image, [4, 4], role(TextureTransfer::Normal, AlphaUse::Unused));
        let pixel = &small.rgba[(4 + 1) * 4..][..3];
        assert!(pixel[0].abs_diff(128) <= 1 && pixel[2] == 255, "{pixel:?}");
    }

    #[test]
    fn constant_images_stay_constant_at_any_size() {
        for (width, height, to) in [(7, 5, [3, 2]), (100, 1, [9, 1]), (16, 16, [16, 3]), (5, 5, [5, 5])] {
            let image = Pixels { width, height, rgba: [30, 60, 90, 120].repeat((width * height) as usize) };
            let small = reduce(&image, to, role(TextureTransfer::Srgb, AlphaUse::Data));
            assert_eq!(small.rgba, [30, 60, 90, 120].repeat((to[0] * to[1]) as usize));
        }
    }

    #[test]
    fn sizes_keep_the_aspect() {
        assert_eq!(reduced_size(4096, 2048, 128), [128, 64]);
        assert_eq!(reduced_size(100, 3, 10), [10, 1]);
        assert_eq!(reduced_size(10_000, 1, 128), [128, 1]);
        assert_eq!(reduced_size(64, 32, 128), [64, 32]);
    }
}
