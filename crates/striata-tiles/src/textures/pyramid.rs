//! Reduced copies of an image on disk, each half as large as the one before.
//!
//! ```text
//!  level 0  |. a a b b .|     texels that no triangle reaches (.) have no part in averages, and take the color
//!  level 1  |  a   b   |     of the next copy that has one: holes close without a search for neighbors
//! ```
//!
//! Cost: while a pyramid is built, memory holds its image and a third more. Afterward, rows are read as they are needed.

use std::collections::VecDeque;
use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::Path;
use std::sync::Mutex;

use rayon::prelude::*;
use striata_scene::drawn::Wrap;
use striata_scene::textures::{RgbaImage, TextureRole};

use super::coverage::Coverage;

/// A file without a name.
pub(crate) struct Scratch {
    file: Mutex<File>,
    end: u64,
}

impl Scratch {
    pub(crate) fn new(folder: &Path) -> io::Result<Self> {
        Ok(Self { file: Mutex::new(tempfile::tempfile_in(folder)?), end: 0 })
    }

    /// Appends bytes, and returns their place.
    pub(crate) fn push(&mut self, bytes: &[u8]) -> io::Result<u64> {
        let file = self.file.get_mut().unwrap_or_else(std::sync::PoisonError::into_inner);
        file.write_all(bytes)?;
        self.end += bytes.len() as u64;
        Ok(self.end - bytes.len() as u64)
    }

    pub(crate) fn read(&self, place: u64, count: usize) -> io::Result<Vec<u8>> {
        let mut bytes = vec![0; count];
        let mut file = self.file.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        file.seek(SeekFrom::Start(place))?;
        file.read_exact(&mut bytes)?;
        Ok(bytes)
    }
}

/// An image and its reduced copies in a scratch file.
#[derive(Debug)]
pub(crate) struct Pyramid {
    pub role: TextureRole,
    /// Size and place of each copy.
    copies: Vec<([u32; 2], u64)>,
}

/// A reduced copy with the weight of each texel.
struct ReducedCopy {
    size: [u32; 2],
    pixels: Vec<[u8; 4]>,
    weights: Vec<u8>,
}

impl Pyramid {
    pub(crate) fn new(
        image: &mut RgbaImage,
        role: TextureRole,
        coverage: &Coverage,
        scratch: &mut Scratch,
    ) -> io::Result<Self> {
        let full = [image.width, image.height];
        let mut copies: Vec<ReducedCopy> = Vec::new();
        let mut size = full;
        while size != [1, 1] {
            let copy = match copies.last() {
                None => {
                    let pixels = image.rgba.as_chunks::<4>().0;
                    halved(size, role, |x, y| {
                        let weight = if coverage.has(x, y) { 255 } else { 0 };
                        (pixels[y as usize * full[0] as usize + x as usize], weight)
                    })
                }
                Some(ReducedCopy { size: [width, _], pixels, weights }) => halved(size, role, |x, y| {
                    let at = y as usize * *width as usize + x as usize;
                    (pixels[at], weights[at])
                }),
            };
            size = copy.size;
            copies.push(copy);
        }
        for index in (1..copies.len()).rev() {
            let (finer, coarser) = copies.split_at_mut(index);
            let Some((ReducedCopy { size, pixels, weights }, coarser)) =
                finer.last_mut().zip(coarser.first())
            else {
                continue;
            };
            fill(pixels, size[0], coarser, |at, _, _| weights[at] == 0);
        }
        if let (Some(first), Some(rgba)) = (copies.first(), std::sync::Arc::get_mut(&mut image.rgba))
            && !coverage.is_whole
        {
            fill(rgba.as_chunks_mut::<4>().0, full[0], first, |_, x, y| !coverage.is_near(x, y));
        }
        let mut places = vec![(full, scratch.push(&image.rgba)?)];
        for copy in copies {
            places.push((copy.size, scratch.push(copy.pixels.as_flattened())?));
        }
        Ok(Self { role, copies: places })
    }

    /// Size of the image, texels.
    pub(crate) fn size(&self) -> [u32; 2] {
        self.copies[0].0
    }

    /// Reads a rectangle of `size` pixels, each of `step` texels, whose first corner is at `start`. Calls `take` with
    /// each row.
    pub(crate) fn read(
        &self,
        scratch: &Scratch,
        sampled: &SampledRect,
        mut take: impl FnMut(u32, &[[u8; 4]]),
    ) -> io::Result<()> {
        let SampledRect { start, step, size, wrap } = *sampled;
        let level = self.level(sampled);
        let scale = f64::from(1u32 << level);
        let taps = |a: usize| -> Vec<PixelTaps> {
            (0..size[a]).map(|i| taps((start[a] + f64::from(i) * step[a]) / scale, step[a] / scale)).collect()
        };
        let ([width, height], place) = self.copies[level];
        let (columns, rows) = (taps(0), taps(1));
        let Some((first, last)) = columns.first().zip(columns.last()) else { return Ok(()) };
        let base = first.first;
        let count = (last.first - base) as usize + last.count;
        let mapped: Vec<u32> = (0..count as i64).map(|i| wrapped(base + i, width, wrap[0])).collect();
        let left = mapped.iter().copied().min().unwrap_or(0);
        let row_bytes = (mapped.iter().copied().max().unwrap_or(0) - left + 1) as usize * 4;
        let read_row = |y: i64| -> io::Result<Vec<[u8; 4]>> {
            let y = wrapped(y, height, wrap[1]);
            let at = place + (u64::from(y) * u64::from(width) + u64::from(left)) * 4;
            let bytes = scratch.read(at, row_bytes)?;
            let pixels = bytes.as_chunks::<4>().0;
            Ok(mapped.iter().map(|&x| pixels[(x - left) as usize]).collect())
        };
        let is_exact = columns.iter().chain(&rows).all(|taps| taps.count == 1);
        let mut kept: VecDeque<(i64, Vec<[f32; 4]>)> = VecDeque::new();
        let mut line = vec![[0u8; 4]; size[0] as usize];
        for (index, row) in (0..).zip(&rows) {
            if is_exact {
                take(index, &read_row(row.first)?);
                continue;
            }
            while kept.front().is_some_and(|&(y, _)| y < row.first) {
                kept.pop_front();
            }
            for y in row.first..row.first + row.count as i64 {
                if kept.back().is_none_or(|&(last, _)| last < y) {
                    let numbers: Vec<[f32; 4]> =
                        read_row(y)?.into_iter().map(|pixel| self.role.numbers(pixel)).collect();
                    let mixed = |taps: &PixelTaps| mixed(taps, |i| numbers[(taps.first - base) as usize + i]);
                    kept.push_back((y, columns.iter().map(mixed).collect()));
                }
            }
            for (x, pixel) in line.iter_mut().enumerate() {
                *pixel = self.role.pixel(mixed(row, |i| kept[i].1[x]));
            }
            take(index, &line);
        }
        Ok(())
    }

    /// The coarsest copy with texels no larger than the pixels. It repeats where the image does.
    fn level(&self, sampled: &SampledRect) -> usize {
        let SampledRect { start, step, size, .. } = *sampled;
        let full = self.size();
        let is_inside =
            (0..2).all(|a| start[a] >= 0.0 && start[a] + step[a] * f64::from(size[a]) <= f64::from(full[a]));
        let most =
            if is_inside { 31 } else { full[0].trailing_zeros().min(full[1].trailing_zeros()) as usize };
        let mut level = 0;
        while level < most.min(self.copies.len() - 1)
            && f64::from(2u32 << level) <= step[0].min(step[1]) * (1.0 + 1e-9)
        {
            level += 1;
        }
        level
    }
}

/// Pixels that are read from an image.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SampledRect {
    /// First corner, texels.
    pub start: [f64; 2],
    /// Texels of a pixel.
    pub step: [f64; 2],
    /// Number of pixels.
    pub size: [u32; 2],
    pub wrap: [Wrap; 2],
}

/// Texels of which a pixel is the average.
#[derive(Debug)]
struct PixelTaps {
    first: i64,
    count: usize,
    start: f64,
    end: f64,
}

/// Texels below an interval, or the two around its middle if it is shorter than a texel.
fn taps(start: f64, length: f64) -> PixelTaps {
    let (start, end) = match length < 1.0 - 1e-9 {
        true => (start + 0.5 * length - 0.5, start + 0.5 * length + 0.5),
        false => (start, start + length),
    };
    // Rounding does not add texels.
    let first = (start + 1e-6).floor();
    let last = (end - 1e-6).ceil().max(first + 1.0);
    PixelTaps { first: first as i64, count: (last - first) as usize, start, end }
}

fn mixed(taps: &PixelTaps, number: impl Fn(usize) -> [f32; 4]) -> [f32; 4] {
    let (mut sum, mut total) = ([0.0; 4], 0.0);
    for i in 0..taps.count {
        let at = (taps.first + i as i64) as f64;
        let weight = ((at + 1.0).min(taps.end) - at.max(taps.start)) as f32;
        let pixel = number(i);
        (0..4).for_each(|channel| sum[channel] += weight * pixel[channel]);
        total += weight;
    }
    sum.map(|x| x / total)
}

/// The texel that is shown at a coordinate.
fn wrapped(at: i64, side: u32, wrap: Wrap) -> u32 {
    let length = i64::from(side);
    let at = match wrap {
        Wrap::ClampToEdge => at.clamp(0, length - 1),
        Wrap::Repeat => at.rem_euclid(length),
        Wrap::MirroredRepeat => {
            let at = at.rem_euclid(2 * length);
            at.min(2 * length - 1 - at)
        }
    };
    at as u32
}

/// A copy of half the size, of which each texel is the weighted average of four.
fn halved(
    [width, height]: [u32; 2],
    role: TextureRole,
    texel: impl Fn(u32, u32) -> ([u8; 4], u8) + Sync,
) -> ReducedCopy {
    let size = [width.div_ceil(2), height.div_ceil(2)];
    let of_pixel = |at: u32| {
        let (x, y) = (at % size[0] * 2, at / size[0] * 2);
        let (mut sum, mut total, mut count) = ([0.0f32; 4], 0u32, 0u32);
        for (x, y) in [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)] {
            if x >= width || y >= height {
                continue;
            }
            count += 1;
            let (pixel, weight) = texel(x, y);
            if weight > 0 {
                let numbers = role.numbers(pixel);
                (0..4).for_each(|channel| sum[channel] += f32::from(weight) * numbers[channel]);
                total += u32::from(weight);
            }
        }
        if total == 0 {
            return ([0; 4], 0);
        }
        (role.pixel(sum.map(|x| x / total as f32)), total.div_ceil(count) as u8)
    };
    let (pixels, weights) = (0..size[0] * size[1]).into_par_iter().map(of_pixel).unzip();
    ReducedCopy { size, pixels, weights }
}

/// Fills holes with the texels of the next copy.
fn fill(
    pixels: &mut [[u8; 4]],
    width: u32,
    coarser: &ReducedCopy,
    is_hole: impl Fn(usize, u32, u32) -> bool + Sync,
) {
    let rows = pixels.par_chunks_mut(width as usize).enumerate();
    rows.for_each(|(y, row)| {
        for (x, pixel) in row.iter_mut().enumerate() {
            if is_hole(y * width as usize + x, x as u32, y as u32) {
                *pixel = coarser.pixels[y / 2 * coarser.size[0] as usize + x / 2];
            }
        }
    });
}
