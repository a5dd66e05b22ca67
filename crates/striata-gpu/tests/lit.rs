//! Lit surfaces: textures, blending, light, and poses give the pictures that formulas predict.

mod support;

use std::f32::consts::PI;

use bytemuck::cast_slice;
use glam::{DMat4, DVec3};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, shapes};
use striata_gpu::{
    AlphaMode, Canvas, Environment, Gpu, GpuError, GpuIndices, LitCamera, LitFrame, LitImage, LitLight,
    LitLightKind, LitMaterial, LitMaterials, LitObject, LitPainter, LitPart, LitScene, LitVertices, Picture,
    TextureFilter, TextureSampler, TextureUse, linear_to_srgb,
};
use support::{differing_pixels, gpu};

const SIDE: u32 = 64;

/// A camera that sees the square from -1 to 1 exactly, from 10 units away.
fn camera() -> LitCamera {
    let fov = 2.0 * (0.1f64).atan();
    LitCamera { eye: [0.0, 0.0, 10.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov }
}

struct LitTest {
    gpu: Gpu,
    painter: LitPainter,
    canvas: Canvas,
    environment: Environment,
    lights: Vec<LitLight>,
    materials: Vec<LitMaterial>,
    images: Vec<LitImage>,
    camera: LitCamera,
}

/// A mesh in a pose, as a test wants it drawn.
struct Shown<'a> {
    mesh: &'a IndexedMesh,
    material: Option<usize>,
    world_from_mesh: DMat4,
    joints: &'a [DMat4],
    morph_weights: &'a [f32],
}

impl<'a> Shown<'a> {
    fn new(mesh: &'a IndexedMesh) -> Self {
        let world_from_mesh = DMat4::IDENTITY;
        Self { mesh, material: Some(0), world_from_mesh, joints: &[], morph_weights: &[] }
    }

    fn at(mesh: &'a IndexedMesh, world_from_mesh: DMat4) -> Self {
        Self { world_from_mesh, ..Self::new(mesh) }
    }
}

impl LitTest {
    fn new(material: LitMaterial) -> Self {
        let gpu = gpu();
        Self {
            painter: LitPainter::new(&gpu, Canvas::FORMAT, 1),
            canvas: Canvas::new(&gpu, [SIDE; 2], 1).unwrap(),
            gpu,
            environment: Environment::uniform([1.0; 3]),
            lights: Vec::new(),
            materials: vec![material],
            images: Vec::new(),
            camera: camera(),
        }
    }

    fn draw(&self, shown: &[Shown<'_>]) -> Picture {
        self.try_draw(shown).unwrap()
    }

    fn try_draw(&self, shown: &[Shown<'_>]) -> Result<Picture, GpuError> {
        let materials = LitMaterials::upload(&self.gpu, &self.painter, &self.materials, &self.images)?;
        let mut uploaded = Vec::new();
        for shown in shown {
            let vertices = LitVertices::upload(&self.gpu, &self.painter, shown.mesh)?;
            let indices = GpuIndices::upload(&self.gpu, cast_slice(&shown.mesh.triangles))?;
            let range = 0..3 * shown.mesh.triangle_count() as u32;
            uploaded.push((vertices, indices, [LitPart { range, material: shown.material }]));
        }
        let objects: Vec<LitObject<'_>> = uploaded
            .iter()
            .zip(shown)
            .map(|((vertices, indices, parts), shown)| LitObject {
                vertices,
                indices,
                parts,
                world_from_mesh: shown.world_from_mesh,
                joints: shown.joints,
                morph_weights: shown.morph_weights,
            })
            .collect();
        let mut frame = LitFrame::new(&self.gpu, &self.painter, &self.environment)?;
        let scene = LitScene {
            camera: self.camera,
            size: [SIDE; 2],
            lights: &self.lights,
            materials: &materials,
            objects: &objects,
        };
        frame.update(&self.gpu, &self.painter, &scene)?;
        self.canvas.paint(&self.gpu, [0.0; 4], |pass| frame.draw(pass))
    }
}

/// The square from -1 to 1, facing the camera, with texture coordinates from the upper left as in glTF.
fn quad() -> IndexedMesh {
    let positions = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    let mut mesh = IndexedMesh::new(positions, vec![[0, 1, 2], [0, 2, 3]]);
    let normals = [[0.0, 0.0, 1.0]; 4].concat();
    let uv = vec![0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uv));
    mesh
}

fn unlit(base_color: [f32; 4]) -> LitMaterial {
    LitMaterial { base_color, is_unlit: true, ..LitMaterial::default() }
}

fn image(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [u8; 4]) -> LitImage {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    LitImage { width, height, rgba: places.flat_map(|(x, y)| pixel(x, y)).collect() }
}

fn pixel(picture: &Picture, x: u32, y: u32) -> [u8; 4] {
    let start = 4 * (y * picture.width + x) as usize;
    std::array::from_fn(|k| picture.rgba[start + k])
}

fn srgb(light: f32) -> u8 {
    (255.0 * linear_to_srgb(light) + 0.5) as u8
}

#[track_caller]
fn assert_near(found: [u8; 4], expected: [u8; 4], tolerance: u8) {
    let is_near = found.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= tolerance);
    assert!(is_near, "{found:?}, not {expected:?}");
}

#[test]
fn an_unlit_textured_quad_shows_its_pixels() {
    let mut test = LitTest::new(LitMaterial {
        base_color_texture: Some(TextureUse {
            sampler: TextureSampler { mag_filter: TextureFilter::Nearest, ..Default::default() },
            ..TextureUse::of(0)
        }),
        ..unlit([1.0; 4])
    });
    let colors = |x: u32, y: u32| [(x * 60) as u8, (y * 60) as u8, 200 - (x * y) as u8, 255];
    test.images = vec![image(4, 4, colors)];
    let picture = test.draw(&[Shown::new(&quad())]);
    for y in 0..4 {
        for x in 0..4 {
            assert_near(pixel(&picture, 16 * x + 8, 16 * y + 8), colors(x, y), 1);
        }
    }
}

#[test]
fn a_white_furnace_returns_the_light_that_arrives() {
    let sphere = sphere();
    for metallic in [0.0, 1.0] {
        for roughness in [0.0, 0.2, 0.5, 0.8, 1.0] {
            let test = LitTest::new(LitMaterial { metallic, roughness, ..Default::default() });
            let picture = test.draw(&[Shown::new(&sphere)]);
            // Middle, halfway and near the edge.
            for x in [32, 46, 58] {
                let found = pixel(&picture, x, 32);
                let name = format!("metallic {metallic}, roughness {roughness}, at {x}: {found:?}");
                assert!(found[..3].iter().all(|&byte| byte >= 248), "{name}");
            }
        }
    }
}

/// A sphere of radius 1 with normals.
fn sphere() -> IndexedMesh {
    let mut mesh = shapes::icosphere(4, 1.0);
    mesh.layers.retain(|layer| layer.semantic != Semantic::Normal);
    let normals = mesh.positions.iter().copied().flatten().collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    mesh
}
