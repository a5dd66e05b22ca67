//! Thumbnails of whole meshes, and a placeholder for files that cannot be drawn.

use striata::mesh::IndexedMesh;

use super::{Camera, Canvas, Paint, Rgba, SceneLook, Shot, Style, ViewAngles, rasterize, with_all_normals};

const BACKGROUND: Rgba = [0.012, 0.013, 0.017, 1.0];
const FAINT: [u8; 4] = [13, 13, 15, 255];
/// Vertical field of view, radians.
const FOV: f32 = 0.45;

/// Draws a mesh from the front, slightly from the left and above, with its materials if it has some.
pub fn portrait(mesh: IndexedMesh, look: Option<&SceneLook>, size: [usize; 2]) -> Canvas {
    // Materials show vertices without normals flat, as glTF prescribes.
    let mesh = if look.is_some() { mesh } else { with_all_normals(&mesh).into_owned() };
    draw(&mesh, Paint::Surface, look, size)
}

/// Draws a placeholder for models that cannot be drawn: a faint octahedron.
pub fn placeholder(size: [usize; 2]) -> Canvas {
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
    let room = size.map(|side| side / 2);
    let mut canvas = Canvas::filled(size[0], size[1], BACKGROUND);
    canvas.blend(&draw(&mesh, Paint::Triangles(vec![FAINT; 8]), None, room), room[0] / 2, room[1] / 2);
    canvas
}

/// Draws without a GPU, since a server draws in the background on any machine.
fn draw(mesh: &IndexedMesh, paint: Paint, look: Option<&SceneLook>, [width, height]: [usize; 2]) -> Canvas {
    let mut canvas = Canvas::filled(width, height, BACKGROUND);
    if let Some(camera) = camera(mesh, look.is_none(), width as f32 / height as f32) {
        let is_flat = matches!(paint, Paint::Triangles(_));
        let shot = Shot { look, ..Shot::of(mesh, paint, Style { has_edges: false, is_flat }) };
        canvas.blend(&rasterize(&shot, &camera, [width, height]), 0, 0);
    }
    canvas
}

/// Camera that fits the mesh; none if there is nothing to see.
///
/// Only a mesh that `may_lie` is taken for a terrain if it is flat along z; in scenes, y is up.
fn camera(mesh: &IndexedMesh, may_lie: bool, aspect: f32) -> Option<Camera> {
    let bounds = mesh.bounds()?;
    let size: [f32; 3] = std::array::from_fn(|axis| bounds.max[axis] - bounds.min[axis]);
    let longest = size.into_iter().fold(0.0f32, f32::max);
    if !longest.is_finite() || longest <= 0.0 {
        return None;
    }
    let lies_flat = may_lie && bounds.lies_flat();
    let is_terrain = !mesh.appearance.georeference.is_empty();
    let (rise, up) = if lies_flat || is_terrain { (0.75, [0.0, 0.0, 1.0]) } else { (0.22, [0.0, 1.0, 0.0]) };
    Some(Camera::around(&mesh.positions, &ViewAngles { turn: -0.5, rise, up, fov: FOV }, aspect))
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
                    for (index, [first, last]) in [x, y].into_iter().zip(&mut extent) {
                        (*first, *last) = ((*first).min(index), (*last).max(index));
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
            let [[left, right], [top, bottom]] = extent(portrait(mesh, None, [160, 120]));
            assert!(top >= 2 && bottom < 118 && bottom - top > 90, "rows {top} to {bottom} at {scale}");
            assert!(left >= 20 && right < 140, "columns {left} to {right} at {scale}");
        }
    }

    #[test]
    fn empty_and_degenerate_meshes_give_empty_pictures() {
        for mesh in [IndexedMesh::default(), IndexedMesh::new(vec![[1.0; 3]; 3], vec![[0, 1, 2]])] {
            assert_eq!(extent(portrait(mesh, None, [32, 24])), [[usize::MAX, 0]; 2]);
        }
    }

    #[test]
    fn a_terrain_is_seen_from_above() {
        let grid = shapes::grid(9, 9);
        let size = grid.bounds().expect("vertices");
        assert!(size.max[2] - size.min[2] < 0.1);
        let camera = camera(&grid, true, 1.0).expect("a camera");
        assert!(camera.eye[2] > 0.5 && camera.up[2] > 0.5, "{camera:?}");
    }

    #[test]
    fn the_placeholder_is_a_faint_shape() {
        let [[left, right], [top, bottom]] = extent(placeholder([160, 120]));
        assert!(left > 30 && right < 130 && top > 20 && bottom < 100 && right - left > 30);
    }
}
