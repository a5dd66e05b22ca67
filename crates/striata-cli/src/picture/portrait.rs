//! Small pictures of whole meshes: a camera that stands so that all of the mesh just fits, and one for none.

use striata::mesh::IndexedMesh;

use super::{Camera, Canvas, Paint, Rgb, Surface, draw, vertex_normals};

const BACKGROUND: Rgb = [0.012, 0.013, 0.017];
const STONE: Rgb = [0.72, 0.58, 0.44];
const FAINT: Rgb = [0.05, 0.052, 0.06];
/// Each pixel is the mean of so many squared.
const SAMPLES: usize = 3;
/// Share of the picture that the mesh may fill.
const FILLED: f32 = 0.88;
/// Height of the view, radians.
const FOV: f32 = 0.45;
/// An axis along which a mesh is flatter than this is up: it is a terrain.
const FLAT: f32 = 0.3;

/// A mesh from in front, a little from the left and above.
pub(crate) fn portrait(mesh: &IndexedMesh, width: usize, height: usize) -> Canvas {
    let normals = vertex_normals(mesh);
    let aspect = width as f32 / height as f32;
    painted(mesh, Paint::Smooth(STONE, &normals), aspect, [width, height])
}

/// A picture for what cannot be drawn: a faint shape that is nobody's.
pub(crate) fn nobody(width: usize, height: usize) -> Canvas {
    let positions = [
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    let triangles = (0..8).map(|side: u32| {
        let corner = |axis: u32| 2 * axis + (side >> axis & 1);
        [corner(0), corner(1), corner(2)]
    });
    let mesh = IndexedMesh::new(positions.to_vec(), triangles.collect());
    // Twice the width asked for leaves room around the shape.
    painted(&mesh, Paint::Flat(&[FAINT; 8]), width as f32 / height as f32 / 2.0, [width, height])
}

fn painted(mesh: &IndexedMesh, paint: Paint<'_>, aspect: f32, [width, height]: [usize; 2]) -> Canvas {
    let mut large = Canvas::filled(width * SAMPLES, height * SAMPLES, BACKGROUND);
    if let Some(camera) = camera(mesh, aspect) {
        let surface = Surface { positions: &mesh.positions, triangles: &mesh.triangles, paint };
        draw(&mut large, &camera, &surface);
    }
    large.shrunk(SAMPLES)
}

/// A camera that sees all of the mesh and little else; none where there is nothing to see.
fn camera(mesh: &IndexedMesh, aspect: f32) -> Option<Camera> {
    let bounds = mesh.bounds()?;
    let centre: [f32; 3] = std::array::from_fn(|axis| bounds.min[axis] / 2.0 + bounds.max[axis] / 2.0);
    let size: [f32; 3] = std::array::from_fn(|axis| bounds.max[axis] - bounds.min[axis]);
    let longest = size.into_iter().fold(0.0f32, f32::max);
    if !longest.is_finite() || longest <= 0.0 {
        return None;
    }
    let lies_flat = size[2] < FLAT * size[0].min(size[1]);
    let (turn, rise) = if lies_flat { (-0.5f32, 0.75f32) } else { (-0.5, 0.22) };
    // Unit vectors: towards the eye, to the right, up in the picture.
    let across = [turn.sin() * rise.cos(), rise.sin(), turn.cos() * rise.cos()];
    let right = [turn.cos(), 0.0, -turn.sin()];
    let above = [-turn.sin() * rise.sin(), rise.cos(), -turn.cos() * rise.sin()];
    // What lies flat has z up: y goes to the back.
    let placed = |v: [f32; 3]| if lies_flat { [v[0], -v[2], v[1]] } else { v };
    let [across, right, above] = [across, right, above].map(placed);
    let tan_y = (FOV / 2.0).tan() * FILLED;
    let tan_x = tan_y * aspect;
    let distance = mesh.positions.iter().fold(0.0f32, |distance, p| {
        let p: [f32; 3] = std::array::from_fn(|axis| p[axis] - centre[axis]);
        let near = dot(p, across);
        // Comparisons with NaN are false: such a vertex asks for nothing.
        distance.max(dot(p, right).abs() / tan_x + near).max(dot(p, above).abs() / tan_y + near)
    });
    let eye = std::array::from_fn(|axis| centre[axis] + distance * across[axis]);
    Some(Camera { eye, look_at: centre, up: above, fov: FOV })
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;

    /// First and last column and row that are not background.
    fn extent(mut canvas: Canvas) -> [[usize; 2]; 2] {
        let mut extent = [[usize::MAX, 0]; 2];
        for y in 0..canvas.height {
            let row = canvas.row_mut(y).to_vec();
            for (x, pixel) in row.iter().enumerate() {
                if pixel.iter().zip(BACKGROUND).any(|(a, b)| (a - b).abs() > 1e-3) {
                    for (place, [first, last]) in [x, y].into_iter().zip(&mut extent) {
                        (*first, *last) = ((*first).min(place), (*last).max(place));
                    }
                }
            }
        }
        extent
    }

    #[test]
    fn a_mesh_fills_its_picture_and_stays_inside_at_any_scale() {
        for scale in [1e-12f32, 1.0, 1e12] {
            let mut mesh = shapes::icosphere(3, 1.0);
            for p in &mut mesh.positions {
                *p = p.map(|x| x * scale);
            }
            let [[left, right], [top, bottom]] = extent(portrait(&mesh, 160, 120));
            assert!(top >= 4 && bottom < 116 && bottom - top > 90, "rows {top} to {bottom} at {scale}");
            assert!(left >= 20 && right < 140, "columns {left} to {right} at {scale}");
        }
    }

    #[test]
    fn nothing_and_a_single_point_are_drawn_as_nothing() {
        for mesh in [IndexedMesh::default(), IndexedMesh::new(vec![[1.0; 3]; 3], vec![[0, 1, 2]])] {
            assert_eq!(extent(portrait(&mesh, 32, 24)), [[usize::MAX, 0]; 2]);
        }
    }

    #[test]
    fn a_terrain_is_seen_from_above() {
        let grid = shapes::grid(9, 9);
        let size = grid.bounds().expect("vertices");
        assert!(size.max[2] - size.min[2] < 0.1);
        let camera = camera(&grid, 1.0).expect("a camera");
        assert!(camera.eye[2] > 0.5 && camera.up[2] > 0.5, "{camera:?}");
    }

    #[test]
    fn what_cannot_be_drawn_gets_a_faint_shape() {
        let [[left, right], [top, bottom]] = extent(nobody(160, 120));
        assert!(left > 30 && right < 130 && top > 20 && bottom < 100 && right - left > 30);
    }
}
