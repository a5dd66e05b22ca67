//! What a small picture shows: all of a mesh and little else, or a shape that is nobody's.

use striata::mesh::IndexedMesh;

use crate::failure::Failure;
use crate::picture::{Angles, Artist, Camera, Canvas, Paint, Rgba, Shot, with_normals};

const BACKGROUND: Rgba = [0.012, 0.013, 0.017, 1.0];
const FAINT: [u8; 4] = [13, 13, 15, 255];
/// Height of the view, radians.
const FOV: f32 = 0.45;
/// What is flatter than this along its third axis is a terrain, and seen from above.
const FLAT: f32 = 0.3;

/// A mesh from in front, a little from the left and above.
///
/// # Errors
/// Where it cannot be drawn.
pub(super) fn portrait(mesh: IndexedMesh, size: [usize; 2]) -> Result<Canvas, Failure> {
    let mesh = with_normals(mesh);
    let camera = Camera::around(&mesh.positions, &angles(&mesh), size[0] as f32 / size[1] as f32);
    painted(&Shot::of(&mesh, Paint::Surface, (false, false)), &camera, size)
}

/// A picture for what cannot be drawn.
///
/// # Errors
/// As [`portrait`].
pub(super) fn nobody(size: [usize; 2]) -> Result<Canvas, Failure> {
    let corner = |axis: usize, sign: f32| std::array::from_fn(|k| if k == axis { sign } else { 0.0 });
    let positions: Vec<[f32; 3]> = (0..3).flat_map(|axis| [corner(axis, 1.0), corner(axis, -1.0)]).collect();
    let triangles = (0..8).map(|side: u32| [0, 1, 2].map(|axis| 2 * axis + (side >> axis & 1)));
    let mesh = IndexedMesh::new(positions, triangles.collect());
    let camera = Camera::around(&mesh.positions, &angles(&mesh), size[0] as f32 / size[1] as f32);
    painted(&Shot::of(&mesh, Paint::Triangles(vec![FAINT; 8]), (false, true)), &camera.zoomed(0.5), size)
}

/// A GPU would take longer to be found than all the rest does.
fn painted(shot: &Shot<'_>, camera: &Camera, size: [usize; 2]) -> Result<Canvas, Failure> {
    let drawn = Artist::Software.draw(shot, camera, size)?;
    let mut picture = Canvas::filled(size[0], size[1], BACKGROUND);
    picture.lay(&drawn.canvas, 0, 0);
    Ok(picture)
}

fn angles(mesh: &IndexedMesh) -> Angles {
    let size = mesh.bounds().map_or([0.0; 3], |b| [0, 1, 2].map(|axis| b.max[axis] - b.min[axis]));
    if size[2] < FLAT * size[0].min(size[1]) {
        return Angles { turn: -0.5, rise: 0.75, up: [0.0, 0.0, 1.0], fov: FOV };
    }
    Angles { turn: -0.5, rise: 0.22, up: [0.0, 1.0, 0.0], fov: FOV }
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;

    const SIZE: [usize; 2] = [160, 120];

    /// First and last column and row that are not background.
    fn extent(canvas: Result<Canvas, Failure>) -> [[usize; 2]; 2] {
        let mut canvas = canvas.expect("it can be drawn");
        let mut extent = [[usize::MAX, 0]; 2];
        for y in 0..canvas.height {
            for (x, pixel) in canvas.row_mut(y).iter().enumerate() {
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
            let [[left, right], [top, bottom]] = extent(portrait(mesh, SIZE));
            assert!(top >= 1 && bottom < 119 && bottom - top > 90, "rows {top} to {bottom} at {scale}");
            assert!(left >= 10 && right < 150, "columns {left} to {right} at {scale}");
        }
    }

    #[test]
    fn nothing_and_a_single_point_are_drawn_as_nothing() {
        for mesh in [IndexedMesh::default(), IndexedMesh::new(vec![[1.0; 3]; 3], vec![[0, 1, 2]])] {
            assert_eq!(extent(portrait(mesh, SIZE)), [[usize::MAX, 0]; 2]);
        }
    }

    #[test]
    fn a_terrain_is_seen_from_above() {
        assert_eq!(angles(&shapes::grid(9, 9)).up, [0.0, 0.0, 1.0]);
        assert_eq!(angles(&shapes::icosphere(1, 1.0)).up, [0.0, 1.0, 0.0]);
    }

    #[test]
    fn what_cannot_be_drawn_gets_a_faint_shape() {
        let [[left, right], [top, bottom]] = extent(nobody(SIZE));
        assert!(
            left > 30 && right < 130 && top > 20 && bottom < 100 && right - left > 20,
            "{left} {right} {top} {bottom}"
        );
    }
}
