//! The rasterizer, for machines without a GPU.
//!
//! A band of the picture is drawn in three passes. First, opaque triangles leave their depth and their
//! number at each sample, with [`DOWNSAMPLING`] by [`DOWNSAMPLING`] samples per pixel. Then, each triangle is
//! shaded once for all of its samples in a pixel, at their mean position: textures are filtered for pixels,
//! so more would not be visible. Edges are drawn at every sample. Last, transparent triangles are
//! blended over the samples from back to front. Bands are drawn in parallel. Colors, lights and edges match
//! those of `gpu`. Time O(samples covered + bands triangles).

use std::ops::Range;

use striata_scene::drawn::AlphaMode;

use super::finish::{Finish, light_of};
use super::surface::Surface;
use super::view::{DOWNSAMPLING, ScreenPoint, View};
use crate::canvas::over;
use crate::scene_look::in_parallel;
use crate::shot::{LineTriangles, Shot};
use crate::{Camera, Canvas, Rgba};

/// No triangle at a sample.
const NONE: u32 = u32::MAX;

/// Number of bands that a picture is divided into at least, so that threads share the work evenly.
const LEAST_BANDS: usize = 16;

/// Draws a shot, at most some rows at a time; uncovered pixels are transparent.
pub(crate) fn draw(
    shot: &Shot<'_>,
    camera: &Camera,
    [width, height]: [usize; 2],
    max_band_rows: usize,
) -> Canvas {
    let view = View::new(shot, camera, [DOWNSAMPLING * width, DOWNSAMPLING * height]);
    let surface = Surface::new(shot, &view);
    let finish = Finish::new(shot, shot.edge_opacity(camera, height));
    let lines = LineTriangles::new(&shot.lines, camera, 0);
    let line = |(corners, color): (&[u32; 3], _)| {
        let corners = corners.map(|v| view.to_camera_space(lines.positions[v as usize]));
        (corners.map(|corner| view.project(corner)), light_of(color).extend(1.0).to_array())
    };
    let lines = lines.triangles.iter().zip(lines.colors.iter().copied()).map(line).collect();
    let triangles = ScreenTriangles::new(&surface, &finish, &view);
    let picture = Picture { triangles, lines, surface, finish, view };
    let band_rows = max_band_rows.min(height.div_ceil(LEAST_BANDS)).max(1);
    let starts: Vec<usize> = (0..height).step_by(band_rows).collect();
    let bands = in_parallel(starts.len(), &|band| {
        let rows = starts[band]..(starts[band] + band_rows).min(height);
        picture.draw_rows(width, rows)
    });
    let mut canvas = Canvas::filled(width, height, [0.0; 4]);
    for (first, band) in starts.into_iter().zip(bands) {
        canvas.blend(&band, 0, first);
    }
    canvas
}

/// Everything that bands share.
struct Picture<'a> {
    surface: Surface<'a>,
    finish: Finish<'a>,
    triangles: ScreenTriangles,
    lines: Vec<(Corners, Rgba)>,
    view: View,
}

/// Corners of a triangle on the screen.
type Corners = [ScreenPoint; 3];

/// Triangles in front of the eye, on the screen.
struct ScreenTriangles {
    /// The vertices.
    points: Vec<ScreenPoint>,
    /// Opaque triangles between vertices, by number.
    whole: Vec<u32>,
    /// Parts of opaque triangles that the near plane cuts, each with its number.
    cut: Vec<(u32, Corners)>,
    /// Transparent triangles, from back to front.
    blended: Vec<(u32, Corners)>,
}

impl ScreenTriangles {
    fn new(surface: &Surface<'_>, finish: &Finish<'_>, view: &View) -> Self {
        let points = surface.positions.iter().map(|&position| view.project(position)).collect();
        let (mut whole, mut cut, mut blended) = (Vec::new(), Vec::new(), Vec::new());
        for (index, triangle) in (0..).zip(surface.triangles) {
            let Some(alpha_mode) = finish.alpha_mode(surface, index as usize) else { continue };
            let corners = triangle.map(|v| surface.positions[v as usize]);
            let is_blended = alpha_mode == AlphaMode::Blend;
            if !is_blended && corners.iter().all(|&corner| view.is_inside(corner)) {
                whole.push(index);
                continue;
            }
            let parts = view.clip(corners).map(|corners| (index, corners.map(|corner| view.project(corner))));
            if is_blended { blended.extend(parts) } else { cut.extend(parts) }
        }
        let nearness = |corners: &Corners| corners.iter().map(|corner| corner.inverse_depth).sum::<f32>();
        blended.sort_by(|(_, a), (_, b)| nearness(a).total_cmp(&nearness(b)));
        Self { points, whole, cut, blended }
    }
}

/// A band of samples.
struct Band {
    canvas: Canvas,
    /// Inverse depths.
    nearest: Vec<f32>,
    rows: Range<usize>,
}

impl Picture<'_> {
    /// Draws some rows of pixels.
    fn draw_rows(&self, width: usize, rows: Range<usize>) -> Canvas {
        let (width, rows) = (DOWNSAMPLING * width, DOWNSAMPLING * rows.start..DOWNSAMPLING * rows.end);
        let canvas = Canvas::filled(width, rows.len(), [0.0; 4]);
        let mut band = Band { canvas, nearest: vec![0.0; width * rows.len()], rows };
        self.draw_opaque(&mut band);
        for (index, corners) in &self.triangles.blended {
            self.blend(*index as usize, corners, &mut band);
        }
        for (corners, color) in &self.lines {
            let Band { canvas, nearest, rows } = &mut band;
            visit_samples(corners, rows, width, |x, y, depth| {
                let nearest = &mut nearest[(y - rows.start) * width + x];
                if depth > *nearest {
                    *nearest = depth;
                    canvas.row_mut(y - rows.start)[x] = *color;
                }
            });
        }
        band.canvas.downsampled(DOWNSAMPLING)
    }

    fn draw_opaque(&self, band: &mut Band) {
        let width = band.canvas.width;
        let mut numbers = vec![NONE; width * band.rows.len()];
        let Band { nearest, rows, .. } = &mut *band;
        let mut draw = |index: u32, corners: &Corners| {
            let cutoff = self.finish.cutoff(index as usize);
            let is_visible = |x: usize, y: usize, cutoff: f32| {
                let sample = [x as f64 + 0.5, y as f64 + 0.5];
                self.finish.alpha(&self.surface, &self.view, index as usize, sample) >= cutoff
            };
            visit_samples(corners, rows, width, |x, y, depth| {
                let at = (y - rows.start) * width + x;
                if depth > nearest[at] && cutoff.is_none_or(|cutoff| is_visible(x, y, cutoff)) {
                    (nearest[at], numbers[at]) = (depth, index);
                }
            });
        };
        let ScreenTriangles { points, whole, cut, .. } = &self.triangles;
        for &index in whole {
            draw(index, &self.surface.triangles[index as usize].map(|v| points[v as usize]));
        }
        cut.iter().for_each(|(index, corners)| draw(*index, corners));
        for row in 0..band.rows.len() / DOWNSAMPLING {
            for column in 0..width / DOWNSAMPLING {
                self.shade_pixel(band, &numbers, [column, row]);
            }
        }
    }

    /// Shades each triangle that is visible in a pixel of the picture.
    fn shade_pixel(&self, band: &mut Band, numbers: &[u32], [column, row]: [usize; 2]) {
        let width = band.canvas.width;
        let samples: [[usize; 2]; DOWNSAMPLING * DOWNSAMPLING] = std::array::from_fn(|i| {
            [DOWNSAMPLING * column + i % DOWNSAMPLING, DOWNSAMPLING * row + i / DOWNSAMPLING]
        });
        let number = samples.map(|[x, y]| numbers[y * width + x]);
        for first in 0..number.len() {
            if number[first] == NONE || number[..first].contains(&number[first]) {
                continue;
            }
            let (triangle, start) = (number[first] as usize, band.rows.start);
            let same = || (first..number.len()).filter(|&i| number[i] == number[first]);
            let middle = mean(same().map(|i| samples[i]), start);
            let [r, g, b, a] = self.finish.shade(&self.surface, &self.view, triangle, middle);
            for [x, y] in same().map(|i| samples[i]) {
                let sample = [x as f64 + 0.5, (y + start) as f64 + 0.5];
                let light = 1.0 - self.finish.line(&self.surface, &self.view, triangle, sample);
                band.canvas.row_mut(y)[x] = [light * r, light * g, light * b, a];
            }
        }
    }

    /// Blends a transparent triangle over what has been drawn.
    fn blend(&self, index: usize, corners: &Corners, band: &mut Band) {
        let (width, start) = (band.canvas.width, band.rows.start);
        let mut visible: Vec<[usize; 2]> = Vec::new();
        visit_samples(corners, &band.rows, width, |x, y, depth| {
            if depth > band.nearest[(y - start) * width + x] {
                visible.push([x, y - start]);
            }
        });
        let pixel = |[x, y]: &[usize; 2]| [y / DOWNSAMPLING, x / DOWNSAMPLING];
        visible.sort_unstable_by_key(pixel);
        for samples in visible.chunk_by(|a, b| pixel(a) == pixel(b)) {
            let middle = mean(samples.iter().copied(), start);
            let color = self.finish.shade(&self.surface, &self.view, index, middle);
            for &[x, y] in samples {
                let below = &mut band.canvas.row_mut(y)[x];
                *below = over(color, *below);
            }
        }
    }
}

/// Mean position of samples of a band that starts at this row.
fn mean(samples: impl Iterator<Item = [usize; 2]>, start: usize) -> [f64; 2] {
    let (mut sum, mut count) = ([0.0; 2], 0.0);
    for [x, y] in samples {
        sum = [sum[0] + x as f64 + 0.5, sum[1] + (y + start) as f64 + 0.5];
        count += 1.0;
    }
    sum.map(|x| x / count)
}

/// Calls `visit` with each sample of some rows inside a triangle, as column and row, and its inverse depth.
fn visit_samples(
    corners: &Corners,
    rows: &Range<usize>,
    width: usize,
    mut visit: impl FnMut(usize, usize, f32),
) {
    let [a, b, c] = *corners;
    let rows = covered([a.y, b.y, c.y], rows);
    let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    let is_behind = corners.iter().any(|p| p.inverse_depth <= 0.0 || !p.inverse_depth.is_finite());
    if rows.is_empty() || is_behind || area == 0.0 || !area.is_finite() {
        return;
    }
    let sides = [(b, c), (c, a), (a, b)];
    // Of two triangles that share a side, exactly one owns the samples on it: else, transparent ones would
    // cover them twice.
    let owns = sides.map(|(p, q)| {
        let (dx, dy) = ((q.x - p.x) * area.signum(), (q.y - p.y) * area.signum());
        dy > 0.0 || (dy == 0.0 && dx > 0.0)
    });
    let columns = covered([a.x, b.x, c.x], &(0..width));
    for y in rows {
        let py = y as f32 + 0.5;
        for x in columns.clone() {
            let px = x as f32 + 0.5;
            // Both triangles of a side compute the same number up to its sign.
            let weights =
                sides.map(|(p, q)| ((p.x - px) * (q.y - py) - (p.y - py) * (q.x - px)) * area.signum());
            if (0..3).all(|k| weights[k] > 0.0 || (weights[k] == 0.0 && owns[k])) {
                let [wa, wb, wc] = weights.map(|weight| weight / area.abs());
                visit(x, y, wa * a.inverse_depth + wb * b.inverse_depth + wc * c.inverse_depth);
            }
        }
    }
}

/// Range of rows or columns whose sample centers may lie between three coordinates.
fn covered(corners: [f32; 3], samples: &Range<usize>) -> Range<usize> {
    let [first, end] = [samples.start, samples.end].map(|sample| sample as f32);
    let min = corners.into_iter().fold(f32::INFINITY, f32::min).floor().clamp(first, end);
    let max = corners.into_iter().fold(f32::NEG_INFINITY, f32::max).ceil().clamp(first, end);
    min as usize..max as usize
}

#[cfg(test)]
mod tests {
    use striata::mesh::{
        AttributeLayer, ColorSpace, IndexedMesh, Material as MeshMaterial, Semantic, TriangleGroup, shapes,
    };
    use striata_scene::drawn::{Material, Sampler, TextureUse, UvTransform};
    use striata_scene::textures::RgbaImage;

    use super::*;
    use crate::{Paint, SceneLook, Style};

    const CAMERA: Camera = Camera { eye: [0.0, 0.0, 4.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.8 };
    const SIZE: usize = 60;

    const fn texture(image: usize) -> TextureUse {
        let sampler = Sampler {
            wrap: [striata_scene::drawn::Wrap::ClampToEdge; 2],
            is_smooth: false,
            has_mip_maps: false,
        };
        let transform = UvTransform([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        TextureUse { image, sampler, uv_set: 0, transform }
    }

    /// A material that shows its color as it is.
    fn plain(base_color: [f32; 4]) -> Material {
        Material { base_color, is_unlit: true, ..Material::default() }
    }

    /// Squares that face the eye at these depths, one for each material, with texture coordinates that begin
    /// at the top left.
    fn squares(depths: &[f32]) -> IndexedMesh {
        let corners = |z: f32| [[-1.0, 1.0, z], [-1.0, -1.0, z], [1.0, -1.0, z], [1.0, 1.0, z]];
        let positions = depths.iter().flat_map(|&z| corners(z)).collect();
        let triangles =
            (0..depths.len() as u32).flat_map(|i| [[0, 1, 2], [0, 2, 3]].map(|t| t.map(|v| v + 4 * i)));
        let mut mesh = IndexedMesh::new(positions, triangles.collect());
        let uvs = depths.iter().flat_map(|_| [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0]).collect();
        mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs));
        mesh.appearance.materials = vec![MeshMaterial::default(); depths.len()];
        let group =
            |i: u32| TriangleGroup { first: 2 * i, count: 2, material: Some(i), ..TriangleGroup::default() };
        mesh.groups = (0..depths.len() as u32).map(group).collect();
        mesh
    }

    fn look(materials: Vec<Material>, images: Vec<RgbaImage>) -> SceneLook {
        SceneLook::new(materials, images.into_iter().map(Some).collect())
    }

    fn drawn(mesh: &IndexedMesh, look: &SceneLook, camera: &Camera) -> Canvas {
        let shot = Shot { look: Some(look), ..Shot::of(mesh, Paint::Surface, Style::SMOOTH) };
        draw(&shot, camera, [SIZE, SIZE], 1000)
    }

    fn at(canvas: &Canvas, x: usize, y: usize) -> [f32; 4] {
        canvas.pixels()[y * SIZE + x]
    }

    fn middle(canvas: &Canvas) -> [f32; 4] {
        at(canvas, SIZE / 2, SIZE / 2)
    }

    fn assert_near(found: [f32; 4], expected: [f32; 4]) {
        let distance = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(distance < 0.01, "{found:?} instead of {expected:?}");
    }

    /// Red and green above, blue and white below; the right half is half transparent.
    fn four_colors() -> RgbaImage {
        let rgba = vec![255, 0, 0, 255, 0, 255, 0, 100, 0, 0, 255, 255, 255, 255, 255, 100];
        RgbaImage { width: 2, height: 2, rgba: rgba.into() }
    }

    #[test]
    fn images_are_upright_and_masks_cut_them() {
        let mut material = plain([1.0; 4]);
        material.base_color_texture = Some(texture(0));
        let (a, b) = (SIZE / 3, SIZE - SIZE / 3);
        let opaque = drawn(&squares(&[0.0]), &look(vec![material.clone()], vec![four_colors()]), &CAMERA);
        assert_near(at(&opaque, a, a), [1.0, 0.0, 0.0, 1.0]);
        assert_near(at(&opaque, b, a), [0.0, 1.0, 0.0, 1.0]);
        assert_near(at(&opaque, a, b), [0.0, 0.0, 1.0, 1.0]);
        assert_near(at(&opaque, b, b), [1.0; 4]);
        material.alpha_mode = AlphaMode::Mask(0.5);
        let masked = drawn(&squares(&[0.0]), &look(vec![material.clone()], vec![four_colors()]), &CAMERA);
        assert_near(at(&masked, a, b), [0.0, 0.0, 1.0, 1.0]);
        assert_near(at(&masked, b, a), [0.0; 4]);
        material.alpha_mode = AlphaMode::Blend;
        material.base_color[3] = 0.5;
        let blended = drawn(&squares(&[0.0]), &look(vec![material], vec![four_colors()]), &CAMERA);
        assert_near(at(&blended, a, a), [0.5, 0.0, 0.0, 0.5]);
    }

    #[test]
    fn texture_coordinates_are_correct_in_perspective() {
        // A floor that runs from below the eye into the distance, with a gradient along it.
        let mut mesh = squares(&[0.0]);
        mesh.positions = vec![[-1.0, -1.0, -20.0], [-1.0, -1.0, 5.0], [1.0, -1.0, 5.0], [1.0, -1.0, -20.0]];
        let gradient = (0..=255u8).flat_map(|y| [y, y, y, 255]).collect::<Vec<u8>>();
        let gradient = RgbaImage { width: 1, height: 256, rgba: gradient.into() };
        let mut material = plain([1.0; 4]);
        // As numbers rather than colors, through the image of occlusion, would need light: compare in sRGB.
        material.base_color_texture = Some(texture(0));
        let canvas = drawn(&mesh, &look(vec![material], vec![gradient]), &CAMERA);
        let slope = (0.4f32).tan();
        for y in SIZE * 2 / 3..SIZE {
            let down = slope * (2.0 * (y as f32 + 0.5) / SIZE as f32 - 1.0);
            let z = 4.0 - 1.0 / down;
            let byte = (256.0 * (z + 20.0) / 25.0).floor();
            let expected = crate::srgb::from_srgb(byte as u8);
            let found = at(&canvas, SIZE / 2, y)[0];
            assert!((found - expected).abs() < 0.03, "row {y}: {found} instead of {expected}");
        }
    }

    #[test]
    fn transparent_surfaces_are_sorted_and_hidden_by_opaque_ones() {
        let glass = |color: [f32; 3]| Material {
            alpha_mode: AlphaMode::Blend,
            ..plain([color[0], color[1], color[2], 0.5])
        };
        let materials = vec![glass([1.0, 0.0, 0.0]), plain([0.0, 0.0, 1.0, 1.0]), glass([0.0, 1.0, 0.0])];
        let canvas = drawn(&squares(&[0.6, 0.0, -1.0]), &look(materials.clone(), Vec::new()), &CAMERA);
        assert_near(middle(&canvas), [0.5, 0.0, 0.5, 1.0]);
        // Red is in front of green, although it comes first.
        let canvas = drawn(&squares(&[0.6, -1.0, 0.3]), &look(materials, Vec::new()), &CAMERA);
        assert_near(middle(&canvas), [0.5, 0.25, 0.25, 1.0]);
    }

    #[test]
    fn backs_are_visible_only_if_the_material_has_two_sides() {
        let behind = Camera { eye: [0.0, 0.0, -4.0], ..CAMERA };
        let mut material = plain([1.0, 0.5, 0.0, 1.0]);
        let of = |material: &Material| {
            middle(&drawn(&squares(&[0.0]), &look(vec![material.clone()], Vec::new()), &behind))
        };
        assert_near(of(&material), [0.0; 4]);
        material.is_double_sided = true;
        assert_near(of(&material), [1.0, 0.5, 0.0, 1.0]);
        material.is_unlit = false;
        assert!(of(&material)[0] > 0.02, "the back is lit");
    }

    #[test]
    fn vertex_colors_emission_and_normal_maps_have_an_effect() {
        let mut mesh = squares(&[0.0]);
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, [0.5, 1.0, 0.0].repeat(4)));
        mesh.appearance.color_space = ColorSpace::Linear;
        let canvas = drawn(&mesh, &look(vec![plain([1.0; 4])], Vec::new()), &CAMERA);
        assert_near(middle(&canvas), [0.5, 1.0, 0.0, 1.0]);
        let rough = Material { metallic: 0.0, base_color: [0.2, 0.2, 0.2, 1.0], ..Material::default() };
        let of = |material: &Material, images: Vec<RgbaImage>| {
            middle(&drawn(&squares(&[0.0]), &look(vec![material.clone()], images), &CAMERA))
        };
        let usual = of(&rough, Vec::new());
        let glowing = of(&Material { emissive: [0.0, 0.3, 0.0], ..rough.clone() }, Vec::new());
        assert_near(glowing, [usual[0], usual[1] + 0.3, usual[2], 1.0]);
        // A map that turns the surface to the left and up, toward the strongest lamp, or away from it.
        let map = |x: u8, y: u8| RgbaImage { width: 1, height: 1, rgba: vec![x, y, 200, 255].into() };
        let bent = Material { normal_texture: Some(texture(0)), ..rough };
        let [toward, away] = [map(60, 195), map(195, 60)].map(|map| of(&bent, vec![map])[1]);
        assert!(toward > 1.2 * away, "{toward} and {away}, {} without", usual[1]);
        assert!(toward > usual[1], "{toward}, {} without", usual[1]);
    }

    #[test]
    fn bands_leave_no_seams() {
        let mut mesh = squares(&[0.6, 0.0]);
        mesh.groups[0].material = Some(1);
        let glass = Material {
            alpha_mode: AlphaMode::Blend,
            base_color: [0.1, 0.2, 0.3, 0.4],
            ..Material::default()
        };
        let look = look(vec![glass, Material::default()], Vec::new());
        let shot = Shot { look: Some(&look), ..Shot::of(&mesh, Paint::Surface, Style::SMOOTH) };
        let torus = shapes::torus(24, 12, 1.0, 0.4);
        for shot in [shot, Shot::of(&torus, Paint::Surface, Style::FACETED)] {
            let whole = draw(&shot, &CAMERA, [40, 30], 30);
            for rows in [1, 7, 29] {
                assert_eq!(draw(&shot, &CAMERA, [40, 30], rows), whole, "{rows} rows");
            }
        }
    }

    /// Draws triangles with a color each.
    fn drawn_plain(positions: &[[f32; 3]], triangles: &[[u32; 3]], colors: &[[u8; 4]]) -> Canvas {
        let mesh = IndexedMesh::new(positions.to_vec(), triangles.to_vec());
        draw(&Shot::of(&mesh, Paint::Triangles(colors.to_vec()), Style::FLAT), &CAMERA, [21, 21], 10)
    }

    #[test]
    fn the_nearer_triangle_hides_the_other_in_any_order() {
        let corners = |z: f32| [[-1.0, -1.0, z], [1.0, -1.0, z], [0.0, 1.0, z]];
        let positions = [corners(0.0), corners(1.0)].concat();
        let (far, near) = ([0, 1, 2], [3, 4, 5]);
        let (red, blue) = ([255, 0, 0, 255], [0, 0, 255, 255]);
        let one = drawn_plain(&positions, &[far, near], &[red, blue]);
        assert_eq!(one, drawn_plain(&positions, &[near, far], &[blue, red]));
        let middle = one.pixels()[10 * 21 + 10];
        assert!(middle[2] > 2.0 * middle[0], "blue is in front: {middle:?}");
        assert_eq!(one.pixels()[0], [0.0; 4], "the corner is empty");
    }

    #[test]
    fn triangles_behind_the_eye_are_not_drawn_plain() {
        let positions = [[-1.0, -1.0, 9.0], [1.0, -1.0, 9.0], [0.0, 1.0, 9.0]];
        let canvas = drawn_plain(&positions, &[[0, 1, 2]], &[[255; 4]]);
        assert!(canvas.pixels().iter().all(|&pixel| pixel == [0.0; 4]));
    }
}
