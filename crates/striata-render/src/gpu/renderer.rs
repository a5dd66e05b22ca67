//! Draws shots with a GPU.

use std::ops::Range;
use std::time::Instant;

use striata_scene::drawn::AlphaMode;
use wgpu::RenderPass;

use crate::camera::{Camera, to_f64};
use crate::environment::Environment;
use crate::gpu::{
    Canvas as GpuCanvas, Drawing, Gpu, GpuError, GpuIndices, GpuOptions, GpuVertices, Inspection, LitFrame,
    LitMaterials, LitObject, LitPart, LitScene, Look, Painter, RejectedAdapter, Scene, choose_adapter,
};
use crate::scene_look::SceneLook;
use crate::shot::{LineTriangles, Paint, Shot};
use crate::{Canvas, Drawn};

/// A GPU with everything that is shared by all shots.
#[derive(Debug)]
pub struct GpuRenderer {
    gpu: Gpu,
    painter: Painter,
    /// Materials of the last look, with its number.
    materials: Option<(u64, LitMaterials)>,
    canvas: Option<([u32; 2], GpuCanvas)>,
}

/// Samples per pixel.
const SAMPLES: u32 = 4;
/// Downsampling factor: each final pixel is the mean of a square of this many pixels per side.
const DOWNSAMPLING: usize = 2;
/// Maximum number of pixels of a picture that is downsampled: each takes 64 bytes, and larger pictures
/// look fine with samples alone.
const MAX_DOWNSAMPLED_PIXELS: usize = 48 << 20;

/// GPU resources of one shot.
struct Uploaded {
    vertices: GpuVertices,
    surface: Surface,
    lines: Option<(Scene, Inspection)>,
}

/// How the surface of a shot is drawn.
enum Surface {
    List(Scene, GpuIndices, Range<u32>),
    Strips(Scene, GpuIndices, Vec<Range<u32>>),
    Triangles(Scene, Inspection),
    Materials(LitFrame),
}

impl GpuRenderer {
    /// Opens the best adapter that can draw, and returns the better ones that were rejected.
    ///
    /// # Errors
    /// If no adapter can draw.
    pub fn open(options: &GpuOptions) -> Result<(Self, Vec<RejectedAdapter>), GpuError> {
        let chosen = choose_adapter(options, Gpu::probe)?;
        let painter = Painter::new(&chosen.gpu, SAMPLES);
        Ok((Self { gpu: chosen.gpu, painter, materials: None, canvas: None }, chosen.rejected))
    }

    /// The GPU that draws.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Draws a shot, at a higher resolution if possible, and downsamples it.
    ///
    /// # Errors
    /// If the GPU runs out of memory or is lost.
    pub fn draw(
        &mut self,
        shot: &Shot<'_>,
        camera: &Camera,
        [width, height]: [usize; 2],
    ) -> Result<Drawn, GpuError> {
        let limit = self.gpu.device().limits().max_texture_dimension_2d as usize;
        let is_small = DOWNSAMPLING * width.max(height) <= limit
            && DOWNSAMPLING * DOWNSAMPLING * width * height <= MAX_DOWNSAMPLED_PIXELS;
        let factor = if is_small { DOWNSAMPLING } else { 1 };
        let size = [width * factor, height * factor].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
        let canvas = match self.canvas.take() {
            Some((of_size, canvas)) if of_size == size => canvas,
            _ => GpuCanvas::new(&self.gpu, size, SAMPLES)?,
        };
        let look = Look {
            background: [0.0; 4],
            edges: [0.0, 0.0, 0.0, shot.edge_opacity(camera, height)],
            edge_width_px: factor as f32,
            light: shot.light(),
            ..Look::default()
        };
        let uploaded = self.upload(shot, camera, size, &look)?;
        // The first frame pays for shader compilation and first use of memory.
        self.frame(&canvas, &uploaded)?;
        let started = Instant::now();
        self.frame(&canvas, &uploaded)?;
        let secs = started.elapsed().as_secs_f64();
        let picture = canvas.read(&self.gpu)?;
        self.canvas = Some((size, canvas));
        let large = Canvas::from_srgb(picture.width as usize, picture.height as usize, &picture.rgba);
        Ok(Drawn { canvas: if factor > 1 { large.downsampled(factor) } else { large }, secs })
    }

    fn frame(&self, canvas: &GpuCanvas, uploaded: &Uploaded) -> Result<(), GpuError> {
        let mut encoder = self.gpu.device().create_command_encoder(&Default::default());
        self.paint(&mut canvas.begin(&mut encoder, [0.0; 4]), uploaded);
        self.gpu.queue().submit([encoder.finish()]);
        self.gpu.wait()
    }

    fn paint(&self, pass: &mut RenderPass<'_>, Uploaded { vertices, surface, lines }: &Uploaded) {
        match surface {
            Surface::List(scene, indices, whole) => {
                let drawing = Drawing::List { indices, groups: std::slice::from_ref(whole) };
                self.painter.draw(pass, scene, vertices, drawing);
            }
            Surface::Strips(scene, indices, groups) => {
                self.painter.draw(pass, scene, vertices, Drawing::Strips { indices, groups });
            }
            Surface::Triangles(scene, inspection) => self.painter.inspect(pass, scene, inspection),
            Surface::Materials(frame) => frame.draw(pass),
        }
        if let Some((scene, inspection)) = lines {
            self.painter.inspect(pass, scene, inspection);
        }
    }

    fn upload(
        &mut self,
        shot: &Shot<'_>,
        camera: &Camera,
        size: [u32; 2],
        look: &Look,
    ) -> Result<Uploaded, GpuError> {
        let view = (camera, size);
        let lines = LineTriangles::new(&shot.lines, camera, shot.vertices.vertex_count());
        let mut vertices = GpuVertices::with_more(&self.gpu, shot.vertices, &lines.positions, shot.is_flat)?;
        if let Paint::Vertices(colors) = &shot.paint {
            vertices.set_colors(&self.gpu, colors);
        }
        let surface = match self.lit_frame(shot, &vertices, camera, size)? {
            Some(frame) => Surface::Materials(frame),
            None => self.surface(shot, &vertices, self.painter.scene(&self.gpu, &vertices, view, look)?)?,
        };
        let (gpu, painter) = (&self.gpu, &self.painter);
        let lines = if lines.triangles.is_empty() {
            None
        } else {
            let scene = painter.scene(gpu, &vertices, view, &Look { light: 0.0, ..Look::default() })?;
            Some((scene, Inspection::new(gpu, painter, &vertices, &lines.triangles, &lines.colors)?))
        };
        Ok(Uploaded { vertices, surface, lines })
    }

    /// Uploads a surface without materials.
    fn surface(&self, shot: &Shot<'_>, vertices: &GpuVertices, scene: Scene) -> Result<Surface, GpuError> {
        let gpu = &self.gpu;
        Ok(match (shot.colors_of_triangles(), shot.strips) {
            (Some(colors), _) => {
                let inspection = Inspection::new(gpu, &self.painter, vertices, &shot.triangles, &colors)?;
                Surface::Triangles(scene, inspection)
            }
            (None, Some(strips)) => {
                let indices = GpuIndices::upload(gpu, &strips.indices)?;
                Surface::Strips(scene, indices, strips.group_ranges.clone())
            }
            (None, None) => {
                let whole = 0..3 * shot.triangles.len() as u32;
                Surface::List(scene, GpuIndices::upload(gpu, shot.triangles.as_flattened())?, whole)
            }
        })
    }

    /// Uploads a surface with materials, if the shot has some; they stay for the next shot with the same look.
    fn lit_frame(
        &mut self,
        shot: &Shot<'_>,
        vertices: &GpuVertices,
        camera: &Camera,
        size: [u32; 2],
    ) -> Result<Option<LitFrame>, GpuError> {
        let Some(look) = shot.visible_look() else { return Ok(None) };
        let (gpu, painter) = (&self.gpu, &self.painter);
        let materials = match self.materials.take() {
            Some((id, materials)) if id == look.id() => materials,
            _ => LitMaterials::upload(gpu, painter, &look.materials, &look.images)?,
        };
        let (_, materials) = self.materials.insert((look.id(), materials));
        let (triangles, parts) = parts_of(shot, look, camera);
        let indices = GpuIndices::upload(gpu, triangles.as_flattened())?;
        let objects = [LitObject { vertices, indices: &indices, parts: &parts }];
        // Lights beyond the limit are left out.
        let lights = &look.lights[..look.lights.len().min(LitFrame::MAX_LIGHT_COUNT)];
        let scene = LitScene { camera, size, lights, materials, objects: &objects };
        LitFrame::new(gpu, painter, &Environment::studio(), &scene).map(Some)
    }
}

/// Returns the triangles with a part for each run of one material; transparent ones come last, from back to
/// front.
fn parts_of(shot: &Shot<'_>, look: &SceneLook, camera: &Camera) -> (Vec<[u32; 3]>, Vec<LitPart>) {
    let is_blended = |material: Option<u32>| {
        let material = material.and_then(|material| look.materials.get(material as usize));
        material.is_some_and(|material| material.alpha_mode == AlphaMode::Blend)
    };
    let (mut opaque, mut blended) = (Vec::new(), Vec::new());
    for group in shot.vertices.groups_or_whole() {
        let list = if is_blended(group.material) { &mut blended } else { &mut opaque };
        let triangles = shot.triangles.get(group.range()).unwrap_or_default();
        list.extend(triangles.iter().map(|&triangle| (group.material, triangle)));
    }
    let [_, _, back] = camera.axes();
    let nearness = |&(_, triangle): &(Option<u32>, [u32; 3])| {
        let depth = |v: u32| -(to_f64(shot.vertices.positions[v as usize]) - camera.eye_64()).dot(back);
        // Like the rasterizer, which adds inverse depths.
        triangle.map(|v| 1.0 / depth(v).max(1e-30)).iter().sum::<f64>()
    };
    // The bits of positive numbers are in the same order.
    blended.sort_by_cached_key(|entry| nearness(entry).to_bits());
    let mut triangles = Vec::with_capacity(opaque.len() + blended.len());
    let mut parts = Vec::new();
    for run in opaque.chunk_by(|a, b| a.0 == b.0).chain(blended.chunk_by(|a, b| a.0 == b.0)) {
        let start = 3 * triangles.len() as u32;
        triangles.extend(run.iter().map(|(_, triangle)| *triangle));
        let material = run[0].0.map(|material| material as usize).filter(|&m| m < look.materials.len());
        parts.push(LitPart { range: start..3 * triangles.len() as u32, material });
    }
    (triangles, parts)
}

#[cfg(test)]
mod tests {
    use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, TriangleGroup, shapes};
    use striata_scene::Poser;
    use striata_scene::drawn::{
        AlphaMode, ImageLimits, Light, LightKind, Material, Sampler, TextureUse, UvTransform, posed_mesh,
    };
    use striata_scene::textures::RgbaImage;

    use std::borrow::Cow;

    use super::*;
    use crate::{Line, SceneLook, Style, ViewAngles, rasterize, to_srgb, triangle_colors, with_normals};

    fn torus() -> (IndexedMesh, Camera) {
        let mesh = with_normals(shapes::torus(48, 24, 1.0, 0.4));
        let angles = ViewAngles { turn: 0.5, rise: 0.7, up: [0.0, 1.0, 0.0], fov: 0.5 };
        let camera = Camera::around(&mesh.positions, &angles, 1.5);
        (mesh, camera)
    }

    /// Panics if the GPU's picture differs from the rasterizer's by more than rounding and sampling explain.
    fn both_draw_the_same(shot: &Shot<'_>, camera: &Camera, least_drawn: usize) {
        let size = [450, 300];
        let (mut renderer, _) = GpuRenderer::open(&GpuOptions::default())
            .expect("an adapter; apt-get install mesa-vulkan-drivers");
        let by_gpu = renderer.draw(shot, camera, size).expect("a working device").canvas;
        let pictures = [by_gpu, rasterize(shot, camera, size)];
        let pairs = pictures[0].pixels().iter().zip(pictures[1].pixels());
        let drawn: Vec<_> = pairs.filter(|(a, b)| a[3].max(b[3]) > 0.5).collect();
        let difference =
            |a: &[f32; 4], b: &[f32; 4]| [0, 1, 2].map(|k| to_srgb(a[k]).abs_diff(to_srgb(b[k])));
        let differences: Vec<[u8; 3]> = drawn.iter().map(|(a, b)| difference(a, b)).collect();
        let far = differences.iter().filter(|bytes| bytes.iter().any(|&byte| byte > 32)).count();
        let sum: u32 = differences.as_flattened().iter().map(|&byte| u32::from(byte)).sum();
        let mean = f64::from(sum) / 3.0 / drawn.len() as f64;
        // The darkness of a line narrower than a pixel depends on the places of the samples.
        let limit = if shot.has_edges { 1.25 } else { 1.0 };
        assert!(drawn.len() > least_drawn, "{} pixels were drawn", drawn.len());
        assert!(
            far < drawn.len() / 40 && mean <= limit,
            "{:?}: {far} of {} pixels, mean {mean}",
            shot.paint,
            drawn.len()
        );
    }

    #[test]
    fn a_gpu_and_the_rasterizer_draw_the_same() {
        let (mesh, camera) = torus();
        let (_, colors) = triangle_colors(&mesh.triangles);
        let by_height = |p: &[f32; 3]| [(127.0 * (1.0 + p[1])) as u8, 40, 200, 255];
        let heights = Paint::Vertices(mesh.positions.iter().map(by_height).collect());
        let line = Line { ends: [[-2.0, 0.1, -1.0], [2.0, 0.3, 1.0]], color: [255, 80, 0, 255], width: 12.0 };
        for (paint, has_edges, is_flat) in [
            (Paint::Surface, false, false),
            (Paint::Triangles(colors), false, true),
            (heights, false, false),
            (Paint::Surface, true, true),
        ] {
            let (triangles, lines) = (Cow::Borrowed(&mesh.triangles[..]), vec![line]);
            let shot = Shot {
                vertices: &mesh,
                triangles,
                strips: None,
                paint,
                has_edges,
                is_flat,
                look: None,
                lines,
            };
            both_draw_the_same(&shot, &camera, 36_000);
        }
    }

    #[test]
    fn both_clip_triangles_behind_the_eye() {
        let (mesh, _) = torus();
        // Inside the tube, along the ring: triangles all around, many of them crossing the plane of the eye.
        let camera =
            Camera { eye: [1.0, 0.0, 0.05], look_at: [0.8, 0.05, 0.6], up: [0.0, 1.0, 0.0], fov: 1.2 };
        for style in [Style::SMOOTH, Style::FACETED] {
            both_draw_the_same(&Shot::of(&mesh, Paint::Surface, style), &camera, 126_000);
        }
    }

    /// A board of two colors with soft squares, so that both filter it alike.
    fn board(colors: [[u8; 4]; 2]) -> RgbaImage {
        let cell = |i: usize| colors[(i % 64 / 16 + i / 64 / 16) % 2];
        RgbaImage { width: 64, height: 64, rgba: (0..64 * 64).flat_map(cell).collect() }
    }

    /// A sphere with a texture on each half, in front of a masked and behind a transparent square.
    fn textured_scene() -> (IndexedMesh, SceneLook) {
        let mut mesh = with_normals(shapes::two_material_sphere(24, 36));
        let sphere = mesh.vertex_count() as u32;
        let square = |z: f32| [[-1.3, -1.3, z], [0.4, -1.3, z], [0.4, 0.4, z], [-1.3, 0.4, z]];
        mesh.positions.extend(square(-1.4).into_iter().chain(square(1.4)));
        let first = mesh.triangles.len() as u32;
        let corners = |start: u32| [[0, 1, 2], [0, 2, 3]].map(|triangle| triangle.map(|v: u32| v + start));
        mesh.triangles.extend(corners(sphere).into_iter().chain(corners(sphere + 4)));
        let group = |first, material| TriangleGroup { first, count: 2, material, ..TriangleGroup::default() };
        mesh.groups.extend([group(first, Some(2)), group(first + 2, Some(3))]);
        let normals = mesh.layer(&Semantic::Normal).map(|layer| layer.data.clone());
        let Some(LayerData::F32(mut normals)) = normals else { panic!("a layer of normals") };
        normals.extend([0.0, 0.0, 1.0].repeat(8));
        let uv = |p: &[f32; 3]| [0.5 + 0.4 * p[0], 0.5 - 0.4 * p[1]];
        let uvs = mesh.positions.iter().flat_map(uv).collect();
        mesh.layers = vec![
            AttributeLayer::from_f32(Semantic::Normal, 3, normals),
            AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs),
        ];
        mesh.appearance.materials = vec![Default::default(); 4];
        let texture = |image| {
            let (sampler, transform) = (Sampler::default(), UvTransform::default());
            Some(TextureUse { image, sampler, uv_set: 0, transform })
        };
        let materials = vec![
            Material {
                base_color_texture: texture(0),
                metallic: 0.0,
                roughness: 0.4,
                emissive: [0.1, 0.0, 0.05],
                ..Material::default()
            },
            Material {
                base_color: [1.0, 0.8, 0.4, 1.0],
                metallic_roughness_texture: texture(1),
                normal_texture: texture(2),
                ..Material::default()
            },
            Material {
                base_color_texture: texture(3),
                alpha_mode: AlphaMode::Mask(0.5),
                is_unlit: true,
                ..Material::default()
            },
            Material {
                base_color: [0.2, 0.4, 1.0, 0.4],
                alpha_mode: AlphaMode::Blend,
                roughness: 0.6,
                ..Material::default()
            },
        ];
        let images = [
            board([[200, 40, 30, 255], [230, 220, 200, 255]]),
            board([[0, 60, 255, 255], [0, 200, 100, 255]]),
            board([[150, 128, 250, 255], [110, 140, 250, 255]]),
            board([[30, 180, 60, 255], [30, 180, 60, 0]]),
        ];
        let light = Light {
            kind: LightKind::Point,
            color: [2.0, 1.5, 1.0],
            range: Some(9.0),
            position: [1.5, 1.0, 2.5],
            direction: [0.0, 0.0, -1.0],
        };
        let look = SceneLook::new(materials, images.into_iter().map(Some).collect()).with_lights(vec![light]);
        (mesh, look)
    }

    #[test]
    fn both_draw_the_same_materials() {
        let (mesh, look) = textured_scene();
        let angles = ViewAngles { turn: -0.3, rise: 0.25, up: [0.0, 1.0, 0.0], fov: 0.5 };
        let camera = Camera::around(&mesh.positions, &angles, 1.5);
        let line = Line { ends: [[-2.0, 0.1, -1.0], [2.0, 0.3, 1.0]], color: [255, 80, 0, 255], width: 12.0 };
        for style in [Style::SMOOTH, Style::FLAT] {
            let shot = Shot::of(&mesh, Paint::Surface, style);
            let shot = Shot { look: Some(&look), lines: vec![line], ..shot };
            both_draw_the_same(&shot, &camera, 27_000);
        }
    }

    #[test]
    fn both_draw_the_same_animated_scene() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/arm.glb");
        let scene = striata_io::read_scene(path).expect("an asset of the repository");
        let poser = Poser::new(&scene).expect("a sound scene");
        let pose = poser.pose(0, 0.6);
        let mesh = posed_mesh(&scene, &poser, &pose).expect("a small scene");
        let look = SceneLook::of(&scene, &ImageLimits::default());
        assert!(look.warnings().is_empty() && look.images.iter().any(Option::is_some));
        let angles = ViewAngles { turn: 0.4, rise: 0.3, up: [0.0, 1.0, 0.0], fov: 0.5 };
        let camera = Camera::around(&mesh.positions, &angles, 1.5);
        let shot = Shot { look: Some(&look), ..Shot::of(&mesh, Paint::Surface, Style::SMOOTH) };
        both_draw_the_same(&shot, &camera, 5000);
    }
}
