//! A z-buffer for triangles, for machines without anything else to draw with.
//!
//! Triangles are set up in pixels, walked over their bounding rectangle and kept where nearest. Colours, lights and edges are
//! those of `striata-gpu`. What does not lie wholly before the eye is left out. Time O(pixels covered), memory O(pixels).

use std::ops::Range;

use striata::mesh::{IndexedMesh, Semantic};

use super::camera::{Camera, cross, dot, minus, unit, wide};
use super::paint::Colour;
use super::shot::{LineTriangles, Paint, STONE, Shot};
use super::{Canvas, Rgba};

type Vec3 = [f32; 3];

/// Each pixel of a picture is the mean of so many squared.
const SHRINK: usize = 3;

/// Draws a shot; where there is nothing one can see through it.
pub(super) fn draw(shot: &Shot<'_>, camera: &Camera, [width, height]: [usize; 2]) -> Canvas {
    let edges = shot.edge_opacity(camera, height);
    draw_large(shot, camera, edges, [SHRINK * width, SHRINK * height]).shrunk(SHRINK)
}

fn draw_large(shot: &Shot<'_>, camera: &Camera, edges: f32, [width, height]: [usize; 2]) -> Canvas {
    let view = View::new(camera, width, height);
    let mut target =
        Target { canvas: Canvas::filled(width, height, [0.0; 4]), nearest: vec![0.0; width * height] };
    let places: Vec<Place> = shot.vertices.positions.iter().map(|&p| view.place(p)).collect();
    let normals = normals_of(shot.vertices);
    let of_triangles = shot.colours_of_triangles();
    let of_vertices = match &shot.paint {
        Paint::Vertices(colours) => Some(colours.clone()),
        Paint::Surface => colours_of(shot.vertices),
        Paint::Triangles(_) => None,
    };
    for (index, corners) in shot.triangles.iter().enumerate() {
        let colours = match (&of_triangles, &of_vertices) {
            (Some(colours), _) => [colour(colours[index]); 3],
            (None, Some(colours)) => corners.map(|v| colour(colours[v as usize])),
            (None, None) => [STONE; 3],
        };
        let normals = if shot.is_flat { None } else { normals.as_ref() };
        let normals = normals.map(|normals| corners.map(|v| view.turned(normals[v as usize])));
        let face = Face { colours, normals, light: shot.light(), edges };
        target.fill(&corners.map(|v| places[v as usize]), &face);
    }
    let lines = LineTriangles::new(&shot.lines, camera, 0);
    for (corners, &paint) in lines.triangles.iter().zip(&lines.colours) {
        let face = Face { colours: [colour(paint); 3], normals: None, light: 0.0, edges: 0.0 };
        target.fill(&corners.map(|v| view.place(lines.positions[v as usize])), &face);
    }
    target.canvas
}

fn colour([r, g, b, _]: Colour) -> Vec3 {
    [r, g, b].map(|byte| f32::from(byte) / 255.0)
}

fn normals_of(mesh: &IndexedMesh) -> Option<Vec<Vec3>> {
    let layer = mesh.layer(&Semantic::Normal).filter(|layer| layer.component_count >= 3)?;
    Some((0..mesh.vertex_count()).map(|v| [0, 1, 2].map(|k| layer.get(v, k))).collect())
}

fn colours_of(mesh: &IndexedMesh) -> Option<Vec<Colour>> {
    let layer = mesh.layers.iter().find(|layer| matches!(layer.semantic, Semantic::Color(_)))?;
    let channels = if layer.component_count < 3 { [0, 0, 0] } else { [0, 1, 2] };
    let byte = |v, k| (255.0 * layer.get(v, k).clamp(0.0, 1.0) + 0.5) as u8;
    let colour = |v| channels.map(|k| byte(v, k));
    Some((0..mesh.vertex_count()).map(colour).map(|[r, g, b]| [r, g, b, 255]).collect())
}

/// A vertex on the screen: pixels, one over the distance, and where it is as the camera sees it.
#[derive(Clone, Copy, Debug)]
struct Place {
    x: f32,
    y: f32,
    inverse_depth: f32,
    in_view: Vec3,
}

/// The camera as three axes and a scale.
struct View {
    axes: [[f64; 3]; 3],
    eye: [f64; 3],
    scale: f64,
    centre: [f64; 2],
}

impl View {
    fn new(camera: &Camera, width: usize, height: usize) -> Self {
        let scale = height as f64 / 2.0 / (f64::from(camera.fov) / 2.0).tan();
        let centre = [width as f64 / 2.0, height as f64 / 2.0];
        Self { axes: camera.axes(), eye: wide(camera.eye), scale, centre }
    }

    fn place(&self, point: Vec3) -> Place {
        let p = minus(wide(point), self.eye);
        let [x, y, z] = self.axes.map(|axis| dot(axis, p));
        Place {
            x: (self.centre[0] - self.scale * x / z) as f32,
            y: (self.centre[1] + self.scale * y / z) as f32,
            inverse_depth: (-1.0 / z) as f32,
            in_view: [x, y, z].map(|x| x as f32),
        }
    }

    /// A direction as the camera sees it: right, up, towards the eye.
    fn turned(&self, n: Vec3) -> Vec3 {
        self.axes.map(|axis| dot(axis, wide(n)) as f32)
    }
}

/// What one triangle looks like.
struct Face {
    colours: [Vec3; 3],
    /// As the camera sees them; none where the triangle is flat.
    normals: Option<[Vec3; 3]>,
    light: f32,
    /// How much its edges cover.
    edges: f32,
}

/// Pixels, and one over the distance of what is on them.
struct Target {
    canvas: Canvas,
    nearest: Vec<f32>,
}

impl Target {
    /// Colours the pixels whose centres lie in the triangle and that nothing nearer covers.
    fn fill(&mut self, screen: &[Place; 3], face: &Face) {
        let [a, b, c] = *screen;
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        let is_behind = screen.iter().any(|p| p.inverse_depth <= 0.0 || !p.inverse_depth.is_finite());
        if is_behind || area == 0.0 || !area.is_finite() {
            return;
        }
        let normal = facing(screen);
        // Pixels across the triangle from each side, as a GPU tells them: by rows and columns.
        let heights =
            [(b, c), (c, a), (a, b)].map(|(p, q)| area.abs() / ((p.x - q.x).abs() + (p.y - q.y).abs()));
        let width = self.canvas.width;
        let columns = covered(a.x, b.x, c.x, width);
        for y in covered(a.y, b.y, c.y, self.canvas.height) {
            let py = y as f32 + 0.5;
            for x in columns.clone() {
                let px = x as f32 + 0.5;
                let wa = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) / area;
                let wb = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) / area;
                let on_screen = [wa, wb, 1.0 - wa - wb];
                if on_screen.iter().any(|&w| w < 0.0) {
                    continue;
                }
                let parts: Vec3 = std::array::from_fn(|k| on_screen[k] * screen[k].inverse_depth);
                let depth = parts[0] + parts[1] + parts[2];
                let kept = &mut self.nearest[y * width + x];
                if depth > *kept {
                    *kept = depth;
                    let weights = parts.map(|part| part / depth);
                    let away = (0..3).map(|k| on_screen[k] * heights[k]).fold(f32::INFINITY, f32::min);
                    self.canvas.row_mut(y)[x] = face.at((screen, weights), normal, away);
                }
            }
        }
    }
}

impl Face {
    /// The colour of a place, which is so many pixels away from the nearest edge.
    fn at(&self, (screen, weights): (&[Place; 3], Vec3), facing: Vec3, away: f32) -> Rgba {
        let mixed = |of: &[Vec3; 3]| -> Vec3 {
            std::array::from_fn(|axis| (0..3).map(|corner| weights[corner] * of[corner][axis]).sum())
        };
        let colour = mixed(&self.colours);
        let normal = self.normals.as_ref().map_or(facing, |normals| unit32(mixed(normals)));
        // Both sides of a surface are lit: what looks away is turned around.
        let normal = if dot32(normal, facing) < 0.0 { normal.map(|x| -x) } else { normal };
        let to_eye = unit32(mixed(&screen.map(|place| place.in_view)).map(|x| -x));
        let lit = lit(colour, normal, to_eye);
        // As wide as on a GPU, whose pictures are twice as large.
        let line = self.edges * (1.0 - smooth_step(2.0 / SHRINK as f32 * away - 0.5));
        let [r, g, b] = std::array::from_fn(|k| {
            let seen = colour[k] + self.light * (lit[k] - colour[k]);
            seen * (1.0 - line)
        });
        [r, g, b, 1.0]
    }
}

fn smooth_step(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// The normal of a triangle, turned to the eye.
fn facing(screen: &[Place; 3]) -> Vec3 {
    let [a, b, c] = screen.map(|place| wide(place.in_view));
    let normal = unit(cross(minus(b, a), minus(c, a)));
    let side = if dot(normal, a) > 0.0 { -1.0 } else { 1.0 };
    normal.map(|x| (side * x) as f32)
}

/// Light on a surface, as `light.wgsl` has it; the camera carries the lights.
fn lit(colour: Vec3, normal: Vec3, to_eye: Vec3) -> Vec3 {
    let towards_key = unit32([-0.55, 0.65, 0.75]);
    let key = 0.78 * dot32(normal, towards_key).max(0.0);
    let fill = 0.16 * dot32(normal, unit32([0.9, 0.1, 0.35])).max(0.0);
    let sky = 0.5 + 0.5 * normal[1];
    let half_way = unit32(std::array::from_fn(|k| to_eye[k] + towards_key[k]));
    let gloss = 0.06 * dot32(normal, half_way).max(0.0).powi(40);
    let light = 0.05 + 0.13 * sky + key + fill;
    colour.map(|channel| channel * light + gloss)
}

/// The pixels of a row or column whose centres may lie between three coordinates.
fn covered(a: f32, b: f32, c: f32, size: usize) -> Range<usize> {
    let min = a.min(b).min(c).floor().clamp(0.0, size as f32);
    let max = a.max(b).max(c).ceil().clamp(0.0, size as f32);
    min as usize..max as usize
}

fn dot32(a: Vec3, b: Vec3) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit32(v: Vec3) -> Vec3 {
    let length = dot32(v, v).sqrt();
    if length > 0.0 { v.map(|x| x / length) } else { v }
}

#[cfg(test)]
mod tests {
    use std::borrow::Cow;

    use super::*;

    const CAMERA: Camera = Camera { eye: [0.0, 0.0, 5.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.8 };

    fn drawn(positions: &[Vec3], triangles: &[[u32; 3]], colours: &[Colour]) -> Canvas {
        let mesh = IndexedMesh::new(positions.to_vec(), triangles.to_vec());
        let shot = Shot {
            vertices: &mesh,
            triangles: Cow::Borrowed(triangles),
            strips: None,
            paint: Paint::Triangles(colours.to_vec()),
            has_edges: false,
            is_flat: true,
            lines: Vec::new(),
        };
        draw(&shot, &CAMERA, [21, 21])
    }

    #[test]
    fn the_nearer_triangle_hides_the_other_in_any_order() {
        let corners = |z: f32| [[-1.0, -1.0, z], [1.0, -1.0, z], [0.0, 1.0, z]];
        let positions = [corners(0.0), corners(1.0)].concat();
        let (far, near) = ([0, 1, 2], [3, 4, 5]);
        let (red, blue) = ([255, 0, 0, 255], [0, 0, 255, 255]);
        let one = drawn(&positions, &[far, near], &[red, blue]);
        assert_eq!(one, drawn(&positions, &[near, far], &[blue, red]));
        let middle = one.pixels()[10 * 21 + 10];
        assert!(middle[2] > 2.0 * middle[0], "blue is in front: {middle:?}");
        assert_eq!(one.pixels()[0], [0.0; 4], "the corner is empty");
    }

    #[test]
    fn what_lies_behind_the_eye_is_not_drawn() {
        let positions = [[-1.0, -1.0, 9.0], [1.0, -1.0, 9.0], [0.0, 1.0, 9.0]];
        let canvas = drawn(&positions, &[[0, 1, 2]], &[[255; 4]]);
        assert!(canvas.pixels().iter().all(|&pixel| pixel == [0.0; 4]));
    }
}
