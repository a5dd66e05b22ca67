//! Textures of the scene, painted from formulas: bands of ornaments on clay, their relief and gloss, and wood.

use std::f32::consts::TAU;
use std::io::Cursor;

use image::{Rgb, RgbImage};

/// Width and height of the textures of the vase.
const SIDE: u32 = 512;

/// Clay and glaze, sRGB.
const CLAY: [f32; 3] = [190.0, 102.0, 58.0];
const GLAZE: [f32; 3] = [26.0, 22.0, 22.0];

/// Encodes a texture as a JPEG file.
pub(crate) fn jpeg(image: &RgbImage) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut bytes, 82);
    image.write_with_encoder(encoder).expect("a small image can be encoded");
    bytes.into_inner()
}

pub(crate) fn vase_color() -> RgbImage {
    picture(SIDE, |u, v| {
        let glaze = glaze_at(u, v);
        let speckle =
            1.0 + 0.1 * (noise(u * 96.0, v * 96.0, 96) - 0.5) + 0.16 * (noise(u * 12.0, v * 40.0, 12) - 0.5);
        [0, 1, 2].map(|k| (CLAY[k] * speckle + glaze * (GLAZE[k] - CLAY[k] * speckle)).clamp(0.0, 255.0))
    })
}

/// Normals of a relief: glaze lies on the clay, and clay has fine rings from turning.
pub(crate) fn vase_relief() -> RgbImage {
    let height = |u: f32, v: f32| {
        let clay = 0.0012 * (v * TAU * 110.0).sin() + 0.002 * noise(u * 64.0, v * 64.0, 64);
        let glaze = glaze_at(u, v);
        0.006 * glaze + (1.0 - glaze) * clay
    };
    picture(SIDE, |u, v| {
        let step = 1.0 / SIDE as f32;
        let slope = [
            (height(u + step, v) - height(u - step, v)) / (2.0 * step),
            (height(u, v + step) - height(u, v - step)) / (2.0 * step),
        ];
        // Green points up, where v falls.
        let normal = [-slope[0], slope[1], 1.0];
        let length = normal.iter().map(|x| x * x).sum::<f32>().sqrt();
        normal.map(|x| 127.5 + 127.5 * x / length)
    })
}

/// Roughness in green and metalness in blue: glaze is smoother than clay.
pub(crate) fn vase_gloss() -> RgbImage {
    picture(SIDE / 2, |u, v| {
        let rough = 0.82 - 0.52 * glaze_at(u, v);
        [255.0, 255.0 * rough, 0.0]
    })
}

/// Rings of a board.
pub(crate) fn wood() -> RgbImage {
    picture(SIDE / 2, |u, v| {
        let warp = 0.5 * noise(u * 8.0, v * 2.0, 8) + 0.2 * noise(u * 32.0, v * 6.0, 32);
        let ring = 0.5 + 0.5 * ((v * 26.0 + 2.5 * warp) * TAU).sin();
        let fiber = noise(u * 16.0, v * 200.0, 16);
        let light = 0.62 + 0.25 * ring + 0.13 * fiber;
        [168.0 * light, 116.0 * light, 72.0 * light]
    })
}

fn picture(side: u32, color: impl Fn(f32, f32) -> [f32; 3]) -> RgbImage {
    RgbImage::from_fn(side, side, |x, y| {
        let at = |pixel: u32| (pixel as f32 + 0.5) / side as f32;
        Rgb(color(at(x), at(y)).map(|channel| channel.round().clamp(0.0, 255.0) as u8))
    })
}

/// How much glaze covers a place, 0 to 1. The wall goes from the inside (v = 0) over the lip to the foot.
fn glaze_at(u: f32, v: f32) -> f32 {
    let inside_and_neck = soft(0.36 - v, 0.002);
    let foot = soft(v - 0.783, 0.002);
    let bands = [0.395, 0.475, 0.49, 0.6, 0.615, 0.675, 0.69]
        .iter()
        .map(|line| soft(0.003 - (v - line).abs(), 0.001))
        .fold(0.0, f32::max);
    let ornaments = [
        tongues(u, band(v, 0.36, 0.395)),
        palmettes(u, band(v, 0.395, 0.475)),
        meander(u, band(v, 0.49, 0.6)),
        waves(u, band(v, 0.615, 0.675)),
        rays(u, band(v, 0.7, 0.783)),
    ];
    ornaments.into_iter().flatten().fold(inside_and_neck.max(foot).max(bands), f32::max)
}

/// Place within a band: 0 at its top and 1 at its bottom; none outside.
fn band(v: f32, top: f32, bottom: f32) -> Option<f32> {
    (top..bottom).contains(&v).then(|| (v - top) / (bottom - top))
}

fn tongues(u: f32, at: Option<f32>) -> Option<f32> {
    let width = (u * 22.0).fract() - 0.5;
    at.map(|y| soft(0.36 * (1.0 - y * y) - width.abs(), 0.05))
}

/// Fans of leaves, which alternate with dots.
fn palmettes(u: f32, at: Option<f32>) -> Option<f32> {
    at.map(|y| {
        let [x, up] = [2.0 * (u * 7.0).fract() - 1.0, 1.0 - y];
        let (radius, angle) = (x.hypot(up - 0.12), x.atan2(up - 0.12));
        let leaf = 0.78 * (0.35 + 0.65 * (angle * 4.5).cos().abs()) * (1.0 - 0.25 * angle.abs());
        let leaves = soft(leaf - radius, 0.06);
        let dot = soft(0.14 - (x.abs() - 1.0).hypot(up - 0.75), 0.05);
        leaves.max(dot)
    })
}

/// The Greek key, drawn on a grid of seven by seven cells.
fn meander(u: f32, at: Option<f32>) -> Option<f32> {
    const KEY: [&[u8; 8]; 7] =
        [b"########", b"#......#", b"#.####.#", b"#.#..#.#", b"#.##.#.#", b"#....#.#", b"######.#"];
    at.map(|y| {
        let y = (y * 8.0 - 0.5).clamp(0.0, 6.999);
        let cell = KEY[y as usize][((u * 10.0).fract() * 8.0) as usize % 8];
        f32::from(u8::from(cell == b'#'))
    })
}

/// Running waves.
fn waves(u: f32, at: Option<f32>) -> Option<f32> {
    at.map(|y| {
        let x = (u * 16.0).fract();
        let crest = 0.5 + 0.34 * ((x - 0.1 * (1.0 - y)) * TAU).sin();
        let eye = soft((x - 0.32).hypot(0.7 * (y - 0.36)) - 0.12, 0.04);
        (soft(y - crest, 0.06) * eye).max(soft(0.07 - (x - 0.32).hypot(0.7 * (y - 0.36)), 0.03))
    })
}

/// Rays that rise from the foot.
fn rays(u: f32, at: Option<f32>) -> Option<f32> {
    let width = ((u * 24.0).fract() - 0.5).abs();
    at.map(|y| soft(0.42 * y - width, 0.03))
}

/// A step from 0 to 1 at x = 0, softened so that the texture has no jagged edges.
fn soft(x: f32, width: f32) -> f32 {
    let t = (0.5 + 0.5 * x / width).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Smooth noise of 0 to 1 that repeats after `period` cells along x.
fn noise(x: f32, y: f32, period: i32) -> f32 {
    let (column, row) = (x.floor(), y.floor());
    let (s, t) = (x - column, y - row);
    let smooth = |t: f32| t * t * (3.0 - 2.0 * t);
    let corner = |dx: i32, dy: i32| hashed((column as i32 + dx).rem_euclid(period), row as i32 + dy);
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * smooth(t);
    mix(mix(corner(0, 0), corner(1, 0), s), mix(corner(0, 1), corner(1, 1), s), t)
}

fn hashed(x: i32, y: i32) -> f32 {
    let mut bits = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca6b);
    bits = (bits ^ bits >> 15).wrapping_mul(0x2c1b_3c6d);
    bits = (bits ^ bits >> 12).wrapping_mul(0x297a_2d39);
    (bits ^ bits >> 15) as f32 / u32::MAX as f32
}
