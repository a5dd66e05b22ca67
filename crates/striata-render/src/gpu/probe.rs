//! Tests a device by drawing a small triangle in every way that pictures are drawn, and checking the pixels.

use striata::mesh::IndexedMesh;
use wgpu::RenderPass;

use crate::camera::Camera;
use crate::gpu::canvas::{Canvas, Picture};
use crate::gpu::device::Gpu;
use crate::gpu::drawing::Drawing;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::indices::GpuIndices;
use crate::gpu::inspection::Inspection;
use crate::gpu::look::Look;
use crate::gpu::painter::Painter;
use crate::gpu::vertices::GpuVertices;

/// Side of the test picture, pixels.
const SIDE: u32 = 16;

/// Samples per pixel, the same as for real pictures.
const SAMPLES: u32 = 4;

/// A triangle that covers the middle of the picture but no corner of it, and two that leave the middle free.
const CORNERS: [[f32; 3]; 9] = [
    [-0.5, -0.4, 0.0],
    [0.5, -0.4, 0.0],
    [0.0, 0.6, 0.0],
    [-0.7, -0.7, 0.0],
    [-0.3, -0.7, 0.0],
    [-0.5, -0.3, 0.0],
    [0.5, 0.3, 0.0],
    [0.7, 0.7, 0.0],
    [0.3, 0.7, 0.0],
];

/// Indices of the first triangle, and of the other two as strips that the device must keep separate.
const TRIANGLE: [u32; 3] = [0, 1, 2];
const TWO_STRIPS: [u32; 7] = [3, 4, 5, u32::MAX, 6, 7, 8];

impl Gpu {
    /// Draws a small triangle as a list, as a strip and with edges, and checks the pixels that come back.
    ///
    /// # Errors
    /// [`GpuError::Failed`] says what the device lacks or draws incorrectly.
    pub fn probe(&self) -> Result<(), GpuError> {
        let canvas = Canvas::new(self, [SIDE, SIDE], SAMPLES)?;
        let painter = Painter::new(self, SAMPLES);
        self.wait()?;
        self.probe_with(&canvas, &painter)
    }

    fn probe_with(&self, canvas: &Canvas, painter: &Painter) -> Result<(), GpuError> {
        let mesh = IndexedMesh::new(CORNERS.to_vec(), vec![TRIANGLE, [3, 4, 5], [6, 7, 8]]);
        let vertices = GpuVertices::upload(self, &mesh)?;
        let view = Camera { eye: [0.0, 0.0, 3.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.6 };
        let look = Look { background: [0.0; 4], ..Look::default() };
        let scene = painter.scene(self, &vertices, (&view, [SIDE, SIDE]), &look)?;
        let [triangle, strips] =
            [&TRIANGLE[..], &TWO_STRIPS].map(|indices| GpuIndices::upload(self, indices));
        let (triangle, strips) = (triangle?, strips?);
        let (whole, both) = (0..3, 0..7);
        let list = Drawing::List { indices: &triangle, groups: std::slice::from_ref(&whole) };
        let strips = Drawing::Strips { indices: &strips, groups: std::slice::from_ref(&both) };
        let inspection = Inspection::new(self, painter, &vertices, &[TRIANGLE], &[[255; 4]])?;
        let draws: [ProbeCase<'_>; 3] = [
            ProbeCase {
                what: "a triangle list",
                is_expected: shows_the_triangle,
                draw: &|pass| painter.draw(pass, &scene, &vertices, list),
            },
            ProbeCase {
                what: "triangle strips",
                is_expected: shows_the_strips,
                draw: &|pass| painter.draw(pass, &scene, &vertices, strips),
            },
            ProbeCase {
                what: "a triangle with edges",
                is_expected: shows_the_triangle,
                draw: &|pass| painter.inspect(pass, &scene, &inspection),
            },
        ];
        for ProbeCase { what, is_expected, draw } in draws {
            let picture = canvas.paint(self, look.background, draw)?;
            self.wait()?;
            if !is_expected(&picture) {
                return Err(GpuError::Failed(format!("it draws {what} incorrectly")));
            }
        }
        Ok(())
    }
}

/// One way to draw that a device has to support.
struct ProbeCase<'a> {
    /// Description of what is drawn.
    what: &'static str,
    /// Whether the resulting picture is correct.
    is_expected: fn(&Picture) -> bool,
    draw: &'a dyn Fn(&mut RenderPass<'_>),
}

/// Whether the middle is covered and lit, and the corners are empty.
fn shows_the_triangle(picture: &Picture) -> bool {
    let last = SIDE - 1;
    let corners = [[0, 0], [last, 0], [0, last], [last, last]];
    is_lit(picture, [SIDE / 2, SIDE / 2]) && corners.iter().all(|&corner| is_empty(picture, corner))
}

/// Whether the lower left and upper right triangles are lit and the space between them is empty.
fn shows_the_strips(picture: &Picture) -> bool {
    let between =
        (SIDE / 2 - 2..SIDE / 2 + 2).flat_map(|y| (SIDE / 2 - 2..SIDE / 2 + 2).map(move |x| [x, y]));
    is_lit(picture, [3, 13])
        && is_lit(picture, [12, 2])
        && between.into_iter().all(|at| is_empty(picture, at))
}

fn is_lit(picture: &Picture, at: [u32; 2]) -> bool {
    let [red, _, _, opacity] = pixel(picture, at);
    opacity == 255 && red > 40
}

fn is_empty(picture: &Picture, at: [u32; 2]) -> bool {
    pixel(picture, at)[3] == 0
}

fn pixel(picture: &Picture, [x, y]: [u32; 2]) -> [u8; 4] {
    let start = 4 * (y * picture.width + x) as usize;
    std::array::from_fn(|k| picture.rgba[start + k])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(middle: [u8; 4], rest: [u8; 4]) -> Picture {
        let mut rgba = rest.repeat((SIDE * SIDE) as usize);
        let start = 4 * (SIDE / 2 * SIDE + SIDE / 2) as usize;
        rgba[start..start + 4].copy_from_slice(&middle);
        Picture { width: SIDE, height: SIDE, rgba }
    }

    #[test]
    fn connected_strips_fail_the_probe() {
        let mut apart = picture([0; 4], [0; 4]);
        for [x, y] in [[3, 13], [12, 2]] {
            let start = 4 * (y * SIDE + x) as usize;
            apart.rgba[start..start + 4].copy_from_slice(&[180, 160, 140, 255]);
        }
        assert!(shows_the_strips(&apart));
        let start = 4 * (SIDE / 2 * SIDE + SIDE / 2) as usize;
        apart.rgba[start + 3] = 255;
        assert!(!shows_the_strips(&apart), "there is something between the strips");
        assert!(!shows_the_strips(&picture([0; 4], [0; 4])), "nothing was drawn");
    }

    #[test]
    fn only_a_lit_triangle_on_an_empty_background_passes() {
        assert!(shows_the_triangle(&picture([180, 160, 140, 255], [0; 4])));
        assert!(!shows_the_triangle(&picture([0; 4], [0; 4])), "nothing was drawn");
        assert!(!shows_the_triangle(&picture([0, 0, 0, 255], [0; 4])), "the triangle is black");
        assert!(
            !shows_the_triangle(&picture([180, 160, 140, 255], [9, 9, 9, 255])),
            "the background is covered"
        );
    }
}
