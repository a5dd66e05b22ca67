//! The contents of one panel: triangles, their paint, and lines.

use std::borrow::Cow;

use glam::DVec3;
use striata::mesh::IndexedMesh;
use striata::strip::StripIndices;

use super::camera::{Camera, to_f64};
use super::paint::Color;
use super::scene_look::SceneLook;

/// The contents of one panel.
#[derive(Clone, Debug)]
pub struct Shot<'a> {
    /// Mesh whose vertices, normals and colors are used.
    pub vertices: &'a IndexedMesh,
    /// Triangles over these vertices.
    pub triangles: Cow<'a, [[u32; 3]]>,
    /// The triangles as strips, for a GPU to draw if triangles need no colors or edges.
    pub strips: Option<&'a StripIndices>,
    /// Colors of the triangles.
    pub paint: Paint,
    /// Whether edges are drawn.
    pub has_edges: bool,
    /// Whether shading is flat.
    pub is_flat: bool,
    /// Materials that [`Paint::Surface`] shows, unless edges are drawn; without them, the surface has the
    /// colors of its vertices or is stone. The triangles must be those of `vertices`, whose groups name the
    /// materials.
    pub look: Option<&'a SceneLook>,
    /// Additional lines.
    pub lines: Vec<Line>,
}

/// Coloring of triangles, linear light as bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Paint {
    /// Materials, or vertex colors of the mesh, or stone if it has neither.
    Surface,
    /// One color per triangle.
    Triangles(Vec<Color>),
    /// One color per vertex, interpolated. Since the colors carry information, lighting is weaker.
    Vertices(Vec<Color>),
}

/// A line segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// End points, mesh units.
    pub ends: [[f32; 3]; 2],
    /// Linear light as bytes.
    pub color: Color,
    /// Width in pixels of a picture with 1000 rows.
    pub width: f32,
}

/// Drawing style of triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// Whether edges are drawn.
    pub has_edges: bool,
    /// Whether shading is flat.
    pub is_flat: bool,
}

impl Style {
    /// Smooth, without edges.
    pub const SMOOTH: Self = Self { has_edges: false, is_flat: false };

    /// Flat, without edges.
    pub const FLAT: Self = Self { has_edges: false, is_flat: true };

    /// Flat, with edges.
    pub const FACETED: Self = Self { has_edges: true, is_flat: true };
}

/// Color of a mesh without colors, linear light.
pub(crate) const STONE: [f32; 3] = [0.72, 0.58, 0.44];

impl<'a> Shot<'a> {
    /// Creates a shot of a mesh with a paint and a style.
    pub fn of(mesh: &'a IndexedMesh, paint: Paint, Style { has_edges, is_flat }: Style) -> Self {
        let triangles = Cow::Borrowed(&mesh.triangles[..]);
        let (strips, look, lines) = (None, None, Vec::new());
        Self { vertices: mesh, triangles, strips, paint, has_edges, is_flat, look, lines }
    }

    /// Returns the materials if the shot shows them.
    pub(crate) fn visible_look(&self) -> Option<&'a SceneLook> {
        self.look.filter(|_| self.paint == Paint::Surface && !self.has_edges)
    }

    /// Strength of the lighting.
    pub(crate) fn light(&self) -> f32 {
        if matches!(self.paint, Paint::Vertices(_)) { 0.62 } else { 1.0 }
    }

    /// A color for each triangle, if triangles have to be drawn individually.
    pub(crate) fn colors_of_triangles(&self) -> Option<Cow<'_, [Color]>> {
        match &self.paint {
            Paint::Triangles(colors) => Some(Cow::Borrowed(colors)),
            Paint::Surface if !self.has_edges => None,
            Paint::Surface => {
                let stone = STONE.map(|x| (255.0 * x + 0.5) as u8);
                let stone = [stone[0], stone[1], stone[2], 255];
                Some(Cow::Owned(vec![stone; self.triangles.len()]))
            }
            Paint::Vertices(_) if !self.has_edges => None,
            Paint::Vertices(colors) => {
                let mean = |triangle: &[u32; 3]| {
                    let corners = triangle.map(|v| colors[v as usize]);
                    std::array::from_fn(|k| (corners.iter().map(|c| u32::from(c[k])).sum::<u32>() / 3) as u8)
                };
                Some(self.triangles.iter().map(mean).collect())
            }
        }
    }

    /// Opacity of edges: lower if they are so dense that they would hide the surface.
    pub(crate) fn edge_opacity(&self, camera: &Camera, height: usize) -> f32 {
        if !self.has_edges || self.triangles.is_empty() {
            return 0.0;
        }
        let [right, up, back] = camera.axes();
        let scale = height as f64 / 2.0 / (f64::from(camera.fov) / 2.0).tan();
        let on_screen = |v: u32| {
            let p = to_f64(self.vertices.positions[v as usize]) - camera.eye_64();
            let depth = -p.dot(back);
            (depth > 0.0).then(|| [scale * p.dot(right) / depth, scale * p.dot(up) / depth])
        };
        // A few thousand triangles are a sufficient sample.
        let step = self.triangles.len() / 4000 + 1;
        let (mut length, mut count) = (0.0, 0);
        for &[a, b, _] in self.triangles.iter().step_by(step) {
            if let (Some(a), Some(b)) = (on_screen(a), on_screen(b)) {
                length += (a[0] - b[0]).hypot(a[1] - b[1]);
                count += 1;
            }
        }
        ((length / f64::from(count.max(1)) / 7.0) as f32).clamp(0.22, 0.9)
    }
}

/// Lines converted to triangles that face the camera.
#[derive(Clone, Debug, Default)]
pub(crate) struct LineTriangles {
    pub positions: Vec<[f32; 3]>,
    pub triangles: Vec<[u32; 3]>,
    pub colors: Vec<Color>,
}

impl LineTriangles {
    pub(crate) fn new(lines: &[Line], camera: &Camera, first_vertex: usize) -> Self {
        let mut out = Self::default();
        let [_, _, back] = camera.axes();
        let eye = camera.eye_64();
        // Size of a pixel at distance 1, in a picture of 1000 rows.
        let pixel = 2.0 * (f64::from(camera.fov) / 2.0).tan() / 1000.0;
        for line in lines {
            let Some([from, to]) = clip_in_front(line.ends.map(|end| to_f64(end) - eye), back) else {
                continue;
            };
            let across = from.cross(to).normalize_or_zero();
            let first = (first_vertex + out.positions.len()) as u32;
            for (end, side) in [(from, -1.0), (from, 1.0), (to, 1.0), (to, -1.0)] {
                let half = side * 0.5 * f64::from(line.width) * pixel * -end.dot(back);
                out.positions.push((eye + end + half * across).as_vec3().into());
            }
            out.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
            out.colors.extend([line.color; 2]);
        }
        out
    }
}

/// Clips a line, relative to the eye, to the part in front of the eye.
fn clip_in_front(ends: [DVec3; 2], back: DVec3) -> Option<[DVec3; 2]> {
    let depths = ends.map(|end| -end.dot(back));
    let nearest = 1e-3 * depths[0].abs().max(depths[1].abs());
    if depths[0].max(depths[1]) <= nearest {
        return None;
    }
    let [a, b] = ends;
    let at = |share: f64| a + share * (b - a);
    let cut = (nearest - depths[0]) / (depths[1] - depths[0]);
    Some([if depths[0] < nearest { at(cut) } else { a }, if depths[1] < nearest { at(cut) } else { b }])
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: Camera = Camera { eye: [0.0, 0.0, 4.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 1.0 };

    #[test]
    fn a_line_has_the_requested_width_at_both_ends() {
        let line = Line { ends: [[0.0, -1.0, 0.0], [0.0, 1.0, 2.0]], color: [255; 4], width: 10.0 };
        let quad = LineTriangles::new(&[line], &CAMERA, 7);
        assert_eq!((quad.triangles[0], quad.positions.len()), ([7, 8, 9], 4));
        for (a, b, depth) in [(0, 1, 4.0f32), (2, 3, 2.0)] {
            let (a, b): ([f32; 3], [f32; 3]) = (quad.positions[a], quad.positions[b]);
            let pixels = (a[0] - b[0]).abs() * 1000.0 / (2.0 * depth * 0.5f32.tan());
            assert!((pixels - 10.0).abs() < 1e-3, "{pixels}");
        }
    }

    #[test]
    fn lines_are_clipped_behind_the_eye() {
        let line = |a: f32, b: f32| Line { ends: [[1.0, 0.0, a], [1.0, 0.0, b]], color: [0; 4], width: 1.0 };
        assert!(LineTriangles::new(&[line(5.0, 9.0)], &CAMERA, 0).triangles.is_empty());
        let cut = LineTriangles::new(&[line(0.0, 9.0)], &CAMERA, 0);
        assert_eq!(cut.triangles.len(), 2);
        assert!(cut.positions.iter().all(|p| p[2] < 4.0));
    }

    #[test]
    fn dense_edges_are_faint() {
        let mesh = striata::mesh::shapes::icosphere(4, 1.0);
        let shot = Shot {
            vertices: &mesh,
            triangles: Cow::Borrowed(&mesh.triangles),
            strips: None,
            paint: Paint::Surface,
            has_edges: true,
            is_flat: false,
            look: None,
            lines: Vec::new(),
        };
        let opacities = [40, 400, 4000].map(|height| shot.edge_opacity(&CAMERA, height));
        assert!(opacities[0] < opacities[1] && opacities[1] < opacities[2], "{opacities:?}");
        assert_eq!(shot.colors_of_triangles().map(|c| c.len()), Some(mesh.triangle_count()));
    }
}
