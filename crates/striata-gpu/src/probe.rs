//! The trial of a device: a small triangle, drawn in each way that pictures are drawn and read back.

use bytemuck::cast_slice;
use striata::mesh::IndexedMesh;
use wgpu::RenderPass;

use crate::canvas::{Canvas, Picture};
use crate::drawing::Drawing;
use crate::gpu::{Gpu, GpuError};
use crate::indices::GpuIndices;
use crate::inspection::Inspection;
use crate::look::Look;
use crate::painter::Painter;
use crate::vertices::GpuVertices;
use crate::viewpoint::Viewpoint;

/// Pixels of a side of the trial's picture.
const SIDE: u32 = 16;

/// Samples per pixel, as pictures use.
const SAMPLES: u32 = 4;

/// The triangle covers the middle of the picture and no corner of it.
const TRIANGLE: [[f32; 3]; 3] = [[-0.5, -0.4, 0.0], [0.5, -0.4, 0.0], [0.0, 0.6, 0.0]];

impl Gpu {
    /// Draws a small triangle as a list, as a strip and with edges, and checks the pixels that come back.
    ///
    /// # Errors
    /// What the device lacks or does wrong.
    pub fn probe(&self) -> Result<(), GpuError> {
        let canvas = Canvas::new(self, [SIDE, SIDE], SAMPLES)?;
        let painter = Painter::new(self, Canvas::FORMAT, SAMPLES);
        self.wait()?;
        self.probe_with(&canvas, &painter)
    }

    fn probe_with(&self, canvas: &Canvas, painter: &Painter) -> Result<(), GpuError> {
        let mesh = IndexedMesh::new(TRIANGLE.to_vec(), vec![[0, 1, 2]]);
        let vertices = GpuVertices::upload(self, &mesh)?;
        let view = Viewpoint { eye: [0.0, 0.0, 3.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.6 };
        let look = Look::default().with_background([0.0; 4]);
        let scene = painter.scene(self, &vertices, (&view, [SIDE, SIDE]), &look)?;
        let indices = GpuIndices::upload(self, cast_slice(&mesh.triangles))?;
        let groups = [0..3];
        let list = Drawing::List { indices: &indices, groups: &groups };
        let strips = Drawing::Strips { indices: &indices, groups: &groups };
        let inspection = Inspection::new(self, painter, &vertices, (&mesh.triangles, &[[255; 4]]))?;
        let draws: [(&str, &dyn Fn(&mut RenderPass<'_>)); 3] = [
            ("a triangle list", &|pass| painter.draw(pass, &scene, &vertices, list)),
            ("a triangle strip", &|pass| painter.draw(pass, &scene, &vertices, strips)),
            ("a triangle with edges", &|pass| painter.inspect(pass, &scene, &inspection)),
        ];
        for (what, draw) in draws {
            let picture = canvas.paint(self, look.background, draw)?;
            self.wait()?;
            if !shows_the_triangle(&picture) {
                return Err(GpuError::Failed(format!("it draws {what} wrongly")));
            }
        }
        Ok(())
    }
}

/// Whether the middle is covered and lit, and the corners are empty.
fn shows_the_triangle(picture: &Picture) -> bool {
    let at = |x: u32, y: u32| {
        let start = 4 * (y * picture.width + x) as usize;
        &picture.rgba[start..start + 4]
    };
    let (last, middle) = (SIDE - 1, at(SIDE / 2, SIDE / 2));
    let corners = [at(0, 0), at(last, 0), at(0, last), at(last, last)];
    middle[3] == 255 && middle[0] > 40 && corners.iter().all(|corner| corner[3] == 0)
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
    fn only_a_lit_triangle_on_nothing_passes() {
        assert!(shows_the_triangle(&picture([180, 160, 140, 255], [0; 4])));
        assert!(!shows_the_triangle(&picture([0; 4], [0; 4])), "nothing was drawn");
        assert!(!shows_the_triangle(&picture([0, 0, 0, 255], [0; 4])), "it is black");
        assert!(!shows_the_triangle(&picture([180, 160, 140, 255], [9, 9, 9, 255])), "it covers all");
    }
}
