//! Rasterizer of surfaces with materials.
//!
//! A band of the picture is drawn in three passes. First, opaque triangles leave their depth and their
//! number at each sample, with [`DOWNSAMPLING`] by [`DOWNSAMPLING`] samples per pixel. Then, each triangle is
//! shaded once for all of its samples in a pixel, at their mean position: textures are filtered for pixels,
//! so more would not be visible. Last, transparent triangles are blended over the samples from back to
//! front. Bands are drawn in parallel.

use std::ops::Range;

use glam::Vec3;
use striata_scene::drawn::AlphaMode;

use super::clip::{Corner, clip};
use super::lit_surface::{LitSurface, PixelGrid};
use super::raster::{Band, DOWNSAMPLING, ScreenPoint, View, covered};
use crate::scene_look::{SceneLook, in_parallel};
use crate::shot::{LineTriangles, Shot};
use crate::{Camera, Canvas};

/// No triangle at a sample.
const NONE: u32 = u32::MAX;

/// Number of bands that a picture is divided into at least, so that threads share the work evenly.
const LEAST_BANDS: usize = 16;

/// Draws a shot with the materials of a look; uncovered pixels are transparent.
pub(crate) fn draw(
    shot: &Shot<'_>,
    look: &SceneLook,
    camera: &Camera,
    [width, height]: [usize; 2],
    max_band_rows: usize,
) -> Canvas {
    let view = View::new(shot, camera, [DOWNSAMPLING * width, DOWNSAMPLING * height]);
    let positions: Vec<[f32; 3]> = shot.vertices.positions.iter().map(|&p| view.to_camera_space(p)).collect();
    let surface = LitSurface::new(shot, look, &positions);
    let picture = Picture {
        triangles: ScreenTriangles::new(shot, &surface, &positions, &view),
        lines: LineTriangles::new(&shot.lines, camera, 0),
        grid: PixelGrid {
            axes: view.axes.map(|axis| axis.as_vec3()),
            center: view.center,
            scale: view.scale,
            step: DOWNSAMPLING as f64,
        },
        surface,
        eye: camera.eye.into(),
        view,
    };
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
    surface: LitSurface<'a>,
    triangles: ScreenTriangles,
    lines: LineTriangles,
    grid: PixelGrid,
    view: View,
    eye: Vec3,
}

/// Triangles in front of the eye, on the screen.
struct ScreenTriangles {
    opaque: Vec<ScreenTriangle>,
    /// From back to front.
    blended: Vec<ScreenTriangle>,
}

/// A triangle, or a part of one that was cut by the near plane.
struct ScreenTriangle {
    /// Number in the shot.
    index: u32,
    /// Whether alpha decides what is visible.
    has_mask: bool,
    corners: [ScreenPoint; 3],
}

impl ScreenTriangles {
    fn new(shot: &Shot<'_>, surface: &LitSurface<'_>, positions: &[[f32; 3]], view: &View) -> Self {
        let (mut opaque, mut blended) = (Vec::new(), Vec::new());
        for (index, triangle) in shot.triangles.iter().enumerate() {
            let material = surface.material(index);
            if !material.is_double_sided && !surface.is_front(index) {
                continue;
            }
            let corners = triangle.map(|v| Corner {
                position: positions[v as usize],
                color: [0.0; 3],
                normal: [0.0; 3],
            });
            for part in clip(corners, view.near) {
                let corners = part.corners.map(|corner| view.project(corner.position));
                if corners.iter().any(|p| p.inverse_depth <= 0.0 || !p.inverse_depth.is_finite()) {
                    continue;
                }
                let has_mask = matches!(material.alpha_mode, AlphaMode::Mask(_));
                let triangle = ScreenTriangle { index: index as u32, has_mask, corners };
                match material.alpha_mode {
                    AlphaMode::Blend => blended.push(triangle),
                    _ => opaque.push(triangle),
                }
            }
        }
        blended.sort_by(|a, b| a.nearness().total_cmp(&b.nearness()));
        Self { opaque, blended }
    }
}

impl ScreenTriangle {
    fn nearness(&self) -> f32 {
        self.corners.iter().map(|corner| corner.inverse_depth).sum()
    }

    /// Calls `visit` with each sample inside, as column and row, and its inverse depth.
    fn samples(&self, rows: &Range<usize>, width: usize, mut visit: impl FnMut(usize, usize, f32)) {
        let [a, b, c] = self.corners;
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if area == 0.0 || !area.is_finite() {
            return;
        }
        let sides = [(b, c), (c, a), (a, b)];
        // Of two triangles that share a side, exactly one owns the samples on it: else, transparent ones would
        // cover them twice.
        let owns = sides.map(|(p, q)| {
            let (dx, dy) = ((q.x - p.x) * area.signum(), (q.y - p.y) * area.signum());
            dy > 0.0 || (dy == 0.0 && dx > 0.0)
        });
        let rows = covered([a.y, b.y, c.y], rows);
        let columns = covered([a.x, b.x, c.x], &(0..width));
        for y in rows {
            let py = y as f32 + 0.5;
            for x in columns.clone() {
                let px = x as f32 + 0.5;
                // Both triangles of a side compute the same number up to its sign.
                let weights =
                    sides.map(|(p, q)| ((p.x - px) * (q.y - py) - (p.y - py) * (q.x - px)) * area.signum());
                let is_inside = (0..3).all(|k| weights[k] > 0.0 || (weights[k] == 0.0 && owns[k]));
                if is_inside {
                    let [wa, wb, wc] = weights.map(|weight| weight / area.abs());
                    visit(x, y, wa * a.inverse_depth + wb * b.inverse_depth + wc * c.inverse_depth);
                }
            }
        }
    }
}

impl Picture<'_> {
    /// Draws some rows of pixels.
    fn draw_rows(&self, width: usize, rows: Range<usize>) -> Canvas {
        let sample_rows = DOWNSAMPLING * rows.start..DOWNSAMPLING * rows.end;
        let mut band = Band::new(DOWNSAMPLING * width, sample_rows);
        self.draw_opaque(&mut band);
        for triangle in &self.triangles.blended {
            self.blend(triangle, &mut band);
        }
        self.lines.triangles.iter().zip(&self.lines.colors).for_each(|(corners, &paint)| {
            let corners = corners.map(|v| self.view.to_camera_space(self.lines.positions[v as usize]));
            band.fill_line(&self.view, corners, paint);
        });
        band.canvas.downsampled(DOWNSAMPLING)
    }

    fn draw_opaque(&self, band: &mut Band) {
        let width = band.canvas.width;
        let mut numbers = vec![NONE; width * band.rows.len()];
        for triangle in &self.triangles.opaque {
            let Band { rows, nearest, .. } = &mut *band;
            triangle.samples(rows, width, |x, y, depth| {
                let at = (y - rows.start) * width + x;
                if depth > nearest[at] && (!triangle.has_mask || self.is_visible(triangle, x, y)) {
                    nearest[at] = depth;
                    numbers[at] = triangle.index;
                }
            });
        }
        for row in 0..band.rows.len() / DOWNSAMPLING {
            for column in 0..width / DOWNSAMPLING {
                self.shade_pixel(band, &numbers, [column, row]);
            }
        }
    }

    /// Whether the mask of a triangle leaves a sample visible.
    fn is_visible(&self, triangle: &ScreenTriangle, x: usize, y: usize) -> bool {
        let index = triangle.index as usize;
        let AlphaMode::Mask(cutoff) = self.surface.material(index).alpha_mode else { return true };
        self.surface.alpha(index, &self.grid, [x as f64 + 0.5, y as f64 + 0.5]) >= cutoff
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
            let same = || (first..number.len()).filter(|&i| number[i] == number[first]);
            let middle = mean(same().map(|i| samples[i]), band.rows.start);
            let color = self.surface.shade(number[first] as usize, &self.grid, self.eye, middle);
            same().for_each(|i| band.canvas.row_mut(samples[i][1])[samples[i][0]] = color);
        }
    }

    /// Blends a transparent triangle over what has been drawn.
    fn blend(&self, triangle: &ScreenTriangle, band: &mut Band) {
        let (width, start) = (band.canvas.width, band.rows.start);
        let mut visible: Vec<[usize; 2]> = Vec::new();
        let Band { rows, nearest, .. } = &*band;
        triangle.samples(rows, width, |x, y, depth| {
            if depth > nearest[(y - start) * width + x] {
                visible.push([x, y - start]);
            }
        });
        let pixel = |[x, y]: &[usize; 2]| [y / DOWNSAMPLING, x / DOWNSAMPLING];
        visible.sort_unstable_by_key(pixel);
        for samples in visible.chunk_by(|a, b| pixel(a) == pixel(b)) {
            let middle = mean(samples.iter().copied(), start);
            let [r, g, b, a] = self.surface.shade(triangle.index as usize, &self.grid, self.eye, middle);
            for &[x, y] in samples {
                let below = &mut band.canvas.row_mut(y)[x];
                let [r0, g0, b0, a0] = *below;
                *below = [r + (1.0 - a) * r0, g + (1.0 - a) * g0, b + (1.0 - a) * b0, a + (1.0 - a) * a0];
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

#[cfg(test)]
mod tests {
    use striata::mesh::{
        AttributeLayer, ColorSpace, IndexedMesh, Material as MeshMaterial, Semantic, TriangleGroup,
    };
    use striata_scene::drawn::{Material, Sampler, TextureUse, UvTransform};
    use striata_scene::textures::RgbaImage;

    use super::*;
    use crate::{Paint, Style};

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
        draw(&shot, look, camera, [SIZE, SIZE], 1000)
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
        let whole = draw(&shot, &look, &CAMERA, [40, 30], 30);
        for rows in [1, 7] {
            assert_eq!(draw(&shot, &look, &CAMERA, [40, 30], rows), whole, "{rows} rows");
        }
    }
}
