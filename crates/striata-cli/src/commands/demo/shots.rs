//! The demo's picture: levels side by side, shaded above, their strips in colours below.

use striata::mesh::IndexedMesh;

use crate::picture::{Camera, Canvas, Paint, Rgb, Surface, draw, vertex_normals};

/// One level as the picture needs it.
pub(super) struct Shot {
    /// What is written above it.
    pub(super) title: String,
    /// What is written below it.
    pub(super) caption: String,
    /// Its triangles.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The strip that each triangle belongs to.
    pub(super) strip_of: Vec<u32>,
}

const PANEL_WIDTH: usize = 200;
const PANEL_HEIGHT: usize = 266;
const HEAD_HEIGHT: usize = 44;
const FOOT_HEIGHT: usize = 34;
/// Each pixel is the mean of so many squared.
const SAMPLES: usize = 3;

const BACKGROUND: Rgb = [0.012, 0.013, 0.017];
const STONE: Rgb = [0.72, 0.58, 0.44];
const INK: Rgb = [0.85, 0.83, 0.80];
const SOFT_INK: Rgb = [0.42, 0.41, 0.39];

/// The picture of all shots of one mesh.
pub(super) fn contact_sheet(mesh: &IndexedMesh, shots: &[Shot]) -> Canvas {
    let normals = vertex_normals(mesh);
    let width = PANEL_WIDTH * shots.len();
    let height = HEAD_HEIGHT + 2 * PANEL_HEIGHT + FOOT_HEIGHT;
    let mut sheet = Canvas::filled(width, height, BACKGROUND);
    for (column, shot) in shots.iter().enumerate() {
        let colours: Vec<Rgb> = shot.strip_of.iter().map(|&strip| strip_colour(strip)).collect();
        let left = column * PANEL_WIDTH;
        for (row, paint) in [Paint::Smooth(STONE, &normals), Paint::Flat(&colours)].into_iter().enumerate() {
            let surface = Surface { positions: &mesh.positions, triangles: &shot.triangles, paint };
            sheet.paste(&panel(mesh, &surface), left, HEAD_HEIGHT + row * PANEL_HEIGHT);
        }
        let middle = left + PANEL_WIDTH / 2;
        sheet.text_centred(&shot.title, [middle, 16], 2, INK);
        sheet.text_centred(&shot.caption, [middle, height - FOOT_HEIGHT + 6], 2, SOFT_INK);
    }
    sheet
}

fn panel(mesh: &IndexedMesh, surface: &Surface<'_>) -> Canvas {
    let mut large = Canvas::filled(PANEL_WIDTH * SAMPLES, PANEL_HEIGHT * SAMPLES, BACKGROUND);
    draw(&mut large, &portrait(mesh), surface);
    large.shrunk(SAMPLES)
}

/// A camera in front of the mesh, a little to its left, that sees all of it.
fn portrait(mesh: &IndexedMesh) -> Camera {
    let Some(bounds) = mesh.bounds() else {
        return Camera { eye: [0.0, 0.0, 1.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.5 };
    };
    let look_at: [f32; 3] = std::array::from_fn(|axis| (bounds.min[axis] + bounds.max[axis]) / 2.0);
    let distance = 1.72 * bounds.diagonal() as f32;
    let (turn, rise) = (-0.62f32, 0.04);
    let eye = [
        look_at[0] + distance * turn.sin(),
        look_at[1] + distance * rise,
        look_at[2] + distance * turn.cos(),
    ];
    Camera { eye, look_at, up: [0.0, 1.0, 0.0], fov: 0.47 }
}

/// Colours that differ much from strip to strip: hues by the golden ratio, two shades of each.
fn strip_colour(strip: u32) -> Rgb {
    let hue = (strip as f32 * 0.618_034).fract() * 6.0;
    let shade = if strip.is_multiple_of(2) { 0.85 } else { 0.60 };
    // Each channel rises and falls along the circle of hues.
    let channel = |shift: f32| {
        let place = (hue + shift) % 6.0;
        let amount = (2.0 - (place - 3.0).abs()).clamp(0.0, 1.0);
        shade * (0.24 + 0.60 * amount)
    };
    [channel(3.0), channel(1.0), channel(5.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_shows_every_shot() {
        let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.1]];
        let triangles = vec![[0, 1, 2], [1, 3, 2]];
        let mesh = IndexedMesh::new(positions, triangles.clone());
        let shot = |triangles: &[[u32; 3]]| Shot {
            title: "100 %".to_owned(),
            caption: "2 triangles".to_owned(),
            triangles: triangles.to_vec(),
            strip_of: (0..triangles.len() as u32).collect(),
        };
        let mut sheet = contact_sheet(&mesh, &[shot(&triangles), shot(&triangles[..1])]);
        assert_eq!(sheet.width, 2 * PANEL_WIDTH);
        let middle = HEAD_HEIGHT + PANEL_HEIGHT / 2;
        for column in 0..2 {
            let left = column * PANEL_WIDTH;
            let panel = &sheet.row_mut(middle)[left..left + PANEL_WIDTH];
            assert!(panel.iter().any(|&pixel| pixel != BACKGROUND), "panel {column} is empty");
            let corner = sheet.row_mut(HEAD_HEIGHT)[left];
            assert!((corner[0] - BACKGROUND[0]).abs() < 1e-4, "a corner is drawn over: {corner:?}");
        }
    }

    #[test]
    fn neighbouring_strips_differ_in_colour() {
        for strip in 0..50 {
            let (a, b) = (strip_colour(strip), strip_colour(strip + 1));
            let difference: f32 = a.iter().zip(b).map(|(x, y)| (x - y).abs()).sum();
            assert!(difference > 0.2, "strips {strip} and the next: {a:?} {b:?}");
        }
    }
}
