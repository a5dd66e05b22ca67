//! Chooses what draws pictures: a GPU that has passed a test, or the software rasterizer.
//!
//! Drawing never fails because of a GPU. If no adapter passes its trial, or one fails later, the rasterizer
//! draws instead, and one line on stderr gives the reason.

use std::time::Instant;

#[cfg(feature = "gpu")]
use striata_gpu::{GpuError, GpuOptions, RejectedAdapter};

use super::{Camera, Drawn, Shot, raster};
#[cfg(feature = "gpu")]
use striata_command::failure::Failure;
use striata_command::output::Output;

#[cfg(feature = "gpu")]
use super::GpuRenderer;

/// Name of the rasterizer in messages.
const RASTERIZER: &str = "the software rasterizer";

/// Draws shots with a GPU or the rasterizer.
#[derive(Debug)]
pub struct PictureRenderer {
    /// The GPU, until it fails.
    #[cfg(feature = "gpu")]
    gpu: Option<Box<GpuRenderer>>,
    #[cfg_attr(not(feature = "gpu"), expect(dead_code, reason = "only a GPU that fails is reported"))]
    output: Output,
}

impl PictureRenderer {
    /// Uses the best working adapter, or else the rasterizer; the reason is reported to `output`.
    #[cfg(feature = "gpu")]
    pub fn best(output: &Output) -> Self {
        match GpuRenderer::open(&GpuOptions::default(), output) {
            Ok((renderer, rejected)) => {
                note_rejected(&rejected, &renderer.name(), output);
                Self { gpu: Some(Box::new(renderer)), output: *output }
            }
            Err(error) => {
                output.say(&format!("note: {error}; using {RASTERIZER} instead"));
                Self::software(output)
            }
        }
    }

    /// Uses the rasterizer, since this build has no GPU support.
    #[cfg(not(feature = "gpu"))]
    pub fn best(output: &Output) -> Self {
        Self::software(output)
    }

    /// Uses the adapter whose name contains `name`, or the rasterizer if that adapter cannot draw.
    ///
    /// # Errors
    /// If no adapter has this name.
    #[cfg(feature = "gpu")]
    pub fn named(name: &str, output: &Output) -> Result<Self, Failure> {
        let options = GpuOptions::default().with_adapter_name(Some(name.to_owned()));
        match GpuRenderer::open(&options, output) {
            Ok((renderer, _)) => Ok(Self { gpu: Some(Box::new(renderer)), output: *output }),
            Err(error @ GpuError::NoSuchAdapter { .. }) => Err(error.into()),
            Err(error) => {
                output.say(&format!("note: {error}; using {RASTERIZER} instead"));
                Ok(Self::software(output))
            }
        }
    }

    /// Uses the rasterizer.
    pub fn software(output: &Output) -> Self {
        Self {
            #[cfg(feature = "gpu")]
            gpu: None,
            output: *output,
        }
    }

    /// Name of the adapter, or of the rasterizer.
    pub fn name(&self) -> String {
        #[cfg(feature = "gpu")]
        if let Some(renderer) = &self.gpu {
            return renderer.name();
        }
        RASTERIZER.to_owned()
    }

    /// Draws a shot with `[width, height]` pixels. If the GPU fails, the rasterizer draws this shot and
    /// all later ones.
    pub fn draw(&mut self, shot: &Shot<'_>, camera: &Camera, size: [usize; 2]) -> Drawn {
        #[cfg(feature = "gpu")]
        if let Some(renderer) = &mut self.gpu {
            match renderer.draw(shot, camera, size) {
                Ok(drawn) => return drawn,
                Err(error) => {
                    let name = renderer.name();
                    self.output.say(&format!("note: {name}: {error}; using {RASTERIZER} instead"));
                    self.gpu = None;
                }
            }
        }
        let started = Instant::now();
        let canvas = raster::draw(shot, camera, size);
        Drawn { canvas, secs: started.elapsed().as_secs_f64() }
    }
}

#[cfg(feature = "gpu")]
fn note_rejected(rejected: &[RejectedAdapter], chosen: &str, output: &Output) {
    for adapter in rejected {
        output.say(&format!("note: {adapter}; using {chosen} instead"));
    }
}

#[cfg(all(test, feature = "gpu"))]
mod tests {
    use std::borrow::Cow;

    use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, TriangleGroup, shapes};
    use striata_scene::Poser;
    use striata_scene::drawn::{
        AlphaMode, ImageLimits, Light, LightKind, Material, Sampler, TextureUse, UvTransform, posed_mesh,
    };
    use striata_scene::textures::RgbaImage;

    use super::*;
    use crate::picture::{Line, Paint, SceneLook, Style, ViewAngles, triangle_colors, with_normals};

    fn on_gpu() -> PictureRenderer {
        let output = Output::quiet();
        let (renderer, _) = GpuRenderer::open(&GpuOptions::default(), &output)
            .expect("an adapter; apt-get install mesa-vulkan-drivers");
        PictureRenderer { gpu: Some(Box::new(renderer)), output }
    }

    fn torus() -> (IndexedMesh, Camera) {
        let mesh = with_normals(shapes::torus(48, 24, 1.0, 0.4));
        let angles = ViewAngles { turn: 0.5, rise: 0.7, up: [0.0, 1.0, 0.0], fov: 0.5 };
        let camera = Camera::around(&mesh.positions, &angles, 1.5);
        (mesh, camera)
    }

    /// Panics if the GPU's picture differs from the rasterizer's by more than rounding and sampling explain.
    fn both_draw_the_same(shot: &Shot<'_>, camera: &Camera, least_drawn: usize) {
        both_draw_the_same_at([150, 100], shot, camera, least_drawn);
    }

    fn both_draw_the_same_at(size: [usize; 2], shot: &Shot<'_>, camera: &Camera, least_drawn: usize) {
        let pictures = [on_gpu(), PictureRenderer::software(&Output::quiet())]
            .map(|mut renderer| renderer.draw(shot, camera, size).canvas);
        let pairs = pictures[0].pixels().iter().zip(pictures[1].pixels());
        let distances: Vec<f32> =
            pairs.map(|(a, b)| a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f32::max)).collect();
        let drawn = pictures[1].pixels().iter().filter(|pixel| pixel[3] > 0.5).count();
        let far = distances.iter().filter(|&&d| d > 0.08).count();
        let mean = distances.iter().sum::<f32>() / drawn as f32;
        assert!(drawn > least_drawn, "{drawn} pixels were drawn");
        assert!(far < drawn / 12 && mean < 0.03, "{:?}: {far} of {drawn} pixels, mean {mean}", shot.paint);
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
            both_draw_the_same(&shot, &camera, 4000);
        }
    }

    #[test]
    fn both_clip_triangles_behind_the_eye() {
        let (mesh, _) = torus();
        // Inside the tube, along the ring: triangles all around, many of them crossing the plane of the eye.
        let camera =
            Camera { eye: [1.0, 0.0, 0.05], look_at: [0.8, 0.05, 0.6], up: [0.0, 1.0, 0.0], fov: 1.2 };
        for style in [Style::SMOOTH, Style::FACETED] {
            both_draw_the_same(&Shot::of(&mesh, Paint::Surface, style), &camera, 14_000);
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
            both_draw_the_same(&shot, &camera, 3000);
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
        // Thin parts with fine stripes need more pixels than silhouettes have.
        both_draw_the_same_at([450, 300], &shot, &camera, 5000);
    }

    #[test]
    fn a_picture_is_drawn_again_if_the_device_is_lost() {
        let (mesh, camera) = torus();
        let shot = Shot::of(&mesh, Paint::Surface, Style::SMOOTH);
        let mut renderer = on_gpu();
        let expected = PictureRenderer::software(&Output::quiet()).draw(&shot, &camera, [60, 40]).canvas;
        renderer.gpu.as_ref().expect("a GPU").destroy();
        assert_eq!(renderer.draw(&shot, &camera, [60, 40]).canvas, expected);
        assert_eq!(renderer.name(), RASTERIZER);
    }
}
