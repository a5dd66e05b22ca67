//! Renders a mesh from twelve directions with the software rasterizer, to compare levels with it.
//!
//! The directions are the corners of an icosahedron, so they are spread evenly. Plain pictures show shading
//! by normals only: no textures or colors, and both sides of each triangle are lit. If the mesh has
//! materials, a second series shows them.

use striata::mesh::{IndexedMesh, Semantic};

use striata_command::output::Output;
use striata_render::{Camera, Canvas, Paint, SceneLook, Shot, Style, ViewAngles};
use striata_viewer::PictureRenderer;

/// Width and height of a picture in pixels.
const SIDE: usize = 256;

/// Elevation of the five corners of an icosahedron next to a pole, in radians.
const RISE: f32 = 0.463_647_6;

/// Vertical field of view in radians.
const FOV: f32 = 0.45;

/// Gray level and coverage of a pixel.
#[derive(Clone, Copy)]
struct Pixel {
    /// Gray level, 0 to 255, over black.
    gray: f32,
    /// Share of the pixel that the mesh covers.
    cover: f32,
}

/// A pixel of a picture with materials: color, 0 to 255 over black, and coverage.
type ColorPixel = ([f32; 3], f32);

/// Pictures of the original, and their cameras.
pub(super) struct Gallery {
    cameras: Vec<Camera>,
    pictures: Vec<Vec<Pixel>>,
    /// The materials, and pictures with them.
    lit: Option<(SceneLook, Vec<Vec<ColorPixel>>)>,
}

/// Differences between the pictures of a level and those of the original.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PictureDifference {
    /// RMS difference of gray levels (0 to 255) over the pixels that either mesh covers.
    pub gray_rms: f64,
    /// Covered area relative to the original's, over all pictures.
    pub silhouette: f64,
    /// Mean difference of colors (0 to 255) over the pixels that either mesh covers, with materials.
    pub color_mean: Option<f64>,
    /// Peak signal-to-noise ratio over the pixels that either mesh covers, dB: of colors with materials, else of gray
    /// levels; [`None`] if the pictures are equal.
    pub decibels: Option<f64>,
}

impl Gallery {
    /// Renders the pictures of a mesh that has normals; also with materials, if there are any.
    pub(super) fn of(original: &IndexedMesh, look: Option<SceneLook>) -> Self {
        let camera = |(turn, rise)| {
            let angles = ViewAngles { turn, rise, up: [0.0, 1.0, 0.0], fov: FOV };
            Camera::around(&original.positions, &angles, 1.0)
        };
        let cameras: Vec<Camera> = directions().into_iter().map(camera).collect();
        let pictures = take_pictures(original, &cameras);
        let lit = look.map(|look| {
            let pictures = take_lit_pictures(original, &look, &cameras);
            (look, pictures)
        });
        Self { cameras, pictures, lit }
    }

    /// Compares a level that has normals with the original.
    pub(super) fn compare(&self, level: &IndexedMesh) -> PictureDifference {
        let (mut squares, mut seen) = (0.0, 0.0);
        let (mut area, mut original_area) = (0.0, 0.0);
        for (theirs, ours) in take_pictures(level, &self.cameras).iter().zip(&self.pictures) {
            for (a, b) in theirs.iter().zip(ours) {
                let weight = f64::from(a.cover.max(b.cover));
                squares += f64::from(a.gray - b.gray).powi(2);
                seen += weight;
                area += f64::from(a.cover);
                original_area += f64::from(b.cover);
            }
        }
        let gray_rms = (squares / f64::max(seen, 1.0)).sqrt();
        let color = self.color_difference(level);
        let rms = color.map_or(gray_rms, |(_, rms)| rms);
        PictureDifference {
            gray_rms,
            silhouette: if original_area > 0.0 { area / original_area } else { 1.0 },
            color_mean: color.map(|(mean, _)| mean),
            decibels: (rms > 0.0).then(|| 20.0 * (255.0 / rms).log10()),
        }
    }

    /// Mean and RMS difference of the pictures with materials.
    fn color_difference(&self, level: &IndexedMesh) -> Option<(f64, f64)> {
        let (look, pictures) = self.lit.as_ref()?;
        let (mut sum, mut squares, mut seen) = (0.0, 0.0, 0.0);
        for (theirs, ours) in take_lit_pictures(level, look, &self.cameras).iter().zip(pictures) {
            for ((a, a_cover), (b, b_cover)) in theirs.iter().zip(ours) {
                let differences = [0, 1, 2].map(|k| f64::from((a[k] - b[k]).abs()));
                sum += differences.iter().sum::<f64>() / 3.0;
                squares += differences.iter().map(|difference| difference * difference).sum::<f64>() / 3.0;
                seen += f64::from(a_cover.max(*b_cover));
            }
        }
        let seen = f64::max(seen, 1.0);
        Some((sum / seen, (squares / seen).sqrt()))
    }
}

/// The corners of an icosahedron as azimuths and elevations in radians.
fn directions() -> Vec<(f32, f32)> {
    let quarter = std::f32::consts::FRAC_PI_2;
    let fifth = |k: usize| k as f32 * std::f32::consts::TAU / 5.0;
    let upper = (0..5).map(|k| (fifth(k), RISE));
    let lower = (0..5).map(|k| (fifth(k) + fifth(1) / 2.0, -RISE));
    upper.chain(lower).chain([(0.0, quarter), (0.0, -quarter)]).collect()
}

fn take_pictures(mesh: &IndexedMesh, cameras: &[Camera]) -> Vec<Vec<Pixel>> {
    let plain = IndexedMesh {
        positions: mesh.positions.clone(),
        triangles: mesh.triangles.clone(),
        layers: mesh.layers.iter().filter(|layer| layer.semantic == Semantic::Normal).cloned().collect(),
        ..IndexedMesh::default()
    };
    let shot = Shot::of(&plain, Paint::Surface, Style::SMOOTH);
    let canvases = draw(&shot, cameras);
    canvases.iter().map(|canvas| canvas.pixels().iter().map(pixel).collect()).collect()
}

fn take_lit_pictures(mesh: &IndexedMesh, look: &SceneLook, cameras: &[Camera]) -> Vec<Vec<ColorPixel>> {
    let shot = Shot { look: Some(look), ..Shot::of(mesh, Paint::Surface, Style::SMOOTH) };
    let canvases = draw(&shot, cameras);
    let pixel = |&[r, g, b, cover]: &[f32; 4]| ([r, g, b].map(encoded), cover);
    canvases.iter().map(|canvas| canvas.pixels().iter().map(pixel).collect()).collect()
}

fn draw(shot: &Shot<'_>, cameras: &[Camera]) -> Vec<Canvas> {
    let mut artist = PictureRenderer::software(&Output::quiet());
    cameras.iter().map(|camera| artist.draw(shot, camera, [SIDE; 2]).canvas).collect()
}

fn pixel(&[r, g, b, cover]: &[f32; 4]) -> Pixel {
    Pixel { gray: encoded(0.2126 * r + 0.7152 * g + 0.0722 * b), cover }
}

/// Converts linear light to sRGB, 0 to 255.
fn encoded(light: f32) -> f32 {
    let light = light.clamp(0.0, 1.0);
    255.0 * if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use striata::mesh::{Material, TriangleGroup, shapes};
    use striata_scene::drawn::ImageLimits;

    use super::*;
    use striata_render::with_normals;

    #[test]
    fn mesh_does_not_differ_from_itself() {
        let ball = with_normals(shapes::icosphere(2, 1.0));
        let same = Gallery::of(&ball, None).compare(&ball);
        assert_eq!(
            same,
            PictureDifference { gray_rms: 0.0, silhouette: 1.0, color_mean: None, decibels: None }
        );
    }

    #[test]
    fn silhouette_area_shrinks_with_the_square_of_the_size() {
        let ball = with_normals(shapes::icosphere(4, 1.0));
        let mut small = ball.clone();
        small.positions.iter_mut().for_each(|p| *p = p.map(|x| 0.8 * x));
        let found = Gallery::of(&ball, None).compare(&small);
        // Slightly less than 0.64, because the outline of a smaller ball is farther from a near camera.
        assert!((found.silhouette - 0.63).abs() < 0.01, "{found:?}");
        assert!(found.gray_rms > 20.0, "{found:?}");
    }

    #[test]
    fn both_sides_of_triangles_are_drawn() {
        let sheet = with_normals(shapes::grid(9, 9));
        let mut turned = sheet.clone();
        turned.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        let found = Gallery::of(&sheet, None).compare(&turned);
        assert!((found.silhouette - 1.0).abs() < 1e-6 && found.gray_rms < 1.0, "{found:?}");
    }

    #[test]
    fn materials_count_in_pictures_with_colors_only() {
        let material = |json: &str| Material { gltf_json: json.to_owned(), ..Material::default() };
        let mut ball = with_normals(shapes::icosphere(3, 1.0));
        ball.appearance.materials = vec![
            material(r#"{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}"#),
            material(r#"{"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 1, 1]}}"#),
        ];
        let count = ball.triangles.len() as u32;
        ball.groups = vec![TriangleGroup { material: Some(0), count, ..TriangleGroup::default() }];
        let look = SceneLook::of_mesh(&ball, &ImageLimits::default());
        let gallery = Gallery::of(&ball, look);
        assert_eq!(gallery.compare(&ball).color_mean, Some(0.0));
        ball.groups[0].material = Some(1);
        let found = gallery.compare(&ball);
        assert_eq!((found.gray_rms, found.silhouette), (0.0, 1.0));
        assert!(found.color_mean.unwrap() > 30.0, "{found:?}");
        // The RMS is at least the mean.
        let at_most = 20.0 * (255.0 / found.color_mean.unwrap()).log10();
        assert!(found.decibels.is_some_and(|decibels| decibels > 0.0 && decibels <= at_most), "{found:?}");
    }

    #[test]
    fn directions_are_spread_evenly() {
        let points: Vec<[f32; 3]> = directions()
            .into_iter()
            .map(|(turn, rise)| [rise.cos() * turn.cos(), rise.sin(), rise.cos() * turn.sin()])
            .collect();
        for (i, a) in points.iter().enumerate() {
            let dots = points.iter().enumerate().filter(|&(j, _)| j != i);
            let nearest = dots.map(|(_, b)| (0..3).map(|k| a[k] * b[k]).sum::<f32>()).fold(-1.0, f32::max);
            assert!((nearest - 0.2f32.sqrt()).abs() < 1e-5, "corner {i}: {nearest}");
        }
    }
}
