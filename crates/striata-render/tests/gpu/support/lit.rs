//! Shared by the tests of lit surfaces: a device for all of them, and meshes.

use std::sync::{Arc, LazyLock};

use bytemuck::cast_slice;
use glam::{Mat4, Vec3};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, shapes};
use striata_render::gpu::{
    Canvas, Gpu, GpuError, GpuIndices, GpuVertices, LitFrame, LitMaterials, LitObject, LitPart, LitScene,
    Painter, Picture,
};
use striata_render::{
    Camera, Environment, Light, LightKind, Material, RgbaImage, Sampler, TextureUse, UvTransform, to_srgb,
};

use crate::support::gpu;

pub(crate) const SIDE: u32 = 64;

/// A camera that sees the square from -1 to 1 exactly, from 10 units away.
pub(crate) fn camera() -> Camera {
    let fov = 2.0 * 0.1f32.atan();
    Camera { eye: [0.0, 0.0, 10.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov }
}

/// A device and a painter for all tests: opening and compiling takes longer than drawing.
static SHARED: LazyLock<(Gpu, Arc<Painter>)> = LazyLock::new(|| {
    let gpu = gpu();
    let painter = Painter::new(&gpu, 1);
    (gpu, Arc::new(painter))
});

pub(crate) struct LitTest {
    pub gpu: Gpu,
    pub painter: Arc<Painter>,
    pub canvas: Canvas,
    pub environment: Environment,
    pub lights: Vec<Light>,
    pub materials: Vec<Material>,
    pub images: Vec<RgbaImage>,
    pub camera: Camera,
}

/// A mesh as a test wants it drawn.
pub(crate) struct Shown {
    pub mesh: IndexedMesh,
    pub material: Option<usize>,
}

impl Shown {
    pub(crate) fn new(mesh: &IndexedMesh) -> Self {
        Self { mesh: mesh.clone(), material: Some(0) }
    }

    /// Moves or turns the mesh.
    pub(crate) fn at(mesh: &IndexedMesh, matrix: Mat4) -> Self {
        let mut mesh = mesh.clone();
        for position in &mut mesh.positions {
            *position = matrix.transform_point3(Vec3::from(*position)).into();
        }
        for layer in mesh.layers.iter_mut().filter(|layer| layer.semantic == Semantic::Normal) {
            let LayerData::F32(normals) = &mut layer.data else { unreachable!("tests have floats") };
            for normal in normals.as_chunks_mut::<3>().0 {
                *normal = matrix.transform_vector3(Vec3::from(*normal)).into();
            }
        }
        Self { mesh, material: Some(0) }
    }
}

impl LitTest {
    pub(crate) fn new(material: Material) -> Self {
        let (gpu, painter) = SHARED.clone();
        Self {
            painter,
            canvas: Canvas::new(&gpu, [SIDE; 2], 1).unwrap(),
            gpu,
            environment: Environment::uniform([1.0; 3]),
            lights: Vec::new(),
            materials: vec![material],
            images: Vec::new(),
            camera: camera(),
        }
    }

    pub(crate) fn draw(&self, shown: &[Shown]) -> Picture {
        self.try_draw(shown).unwrap()
    }

    pub(crate) fn try_draw(&self, shown: &[Shown]) -> Result<Picture, GpuError> {
        let images: Vec<_> = self.images.iter().cloned().map(Some).collect();
        let materials = LitMaterials::upload(&self.gpu, &self.painter, &self.materials, &images)?;
        let mut uploaded = Vec::new();
        for shown in shown {
            let vertices = GpuVertices::upload(&self.gpu, &shown.mesh)?;
            let indices = GpuIndices::upload(&self.gpu, cast_slice(&shown.mesh.triangles))?;
            let range = 0..3 * shown.mesh.triangle_count() as u32;
            uploaded.push((vertices, indices, [LitPart { range, material: shown.material }]));
        }
        let objects: Vec<LitObject<'_>> = uploaded
            .iter()
            .map(|(vertices, indices, parts)| LitObject { vertices, indices, parts })
            .collect();
        let scene = LitScene {
            camera: &self.camera,
            size: [SIDE; 2],
            lights: &self.lights,
            materials: &materials,
            objects: &objects,
        };
        let frame = LitFrame::new(&self.gpu, &self.painter, &self.environment, &scene)?;
        self.canvas.paint(&self.gpu, [0.0; 4], |pass| frame.draw(pass))
    }
}

/// The square from -1 to 1, facing the camera, with texture coordinates from the upper left as in glTF.
pub(crate) fn quad() -> IndexedMesh {
    let positions = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    let mut mesh = IndexedMesh::new(positions, vec![[0, 1, 2], [0, 2, 3]]);
    let normals = [[0.0, 0.0, 1.0]; 4].concat();
    let uv = vec![0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uv));
    mesh
}

/// Uses an image with the default sampling, the first texture coordinates, and no transform.
pub(crate) fn used(image: usize) -> TextureUse {
    TextureUse { image, sampler: Sampler::default(), uv_set: 0, transform: UvTransform::default() }
}

pub(crate) fn unlit(base_color: [f32; 4]) -> Material {
    Material { base_color, is_unlit: true, ..Material::default() }
}

pub(crate) fn image(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [u8; 4]) -> RgbaImage {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    RgbaImage { width, height, rgba: places.flat_map(|(x, y)| pixel(x, y)).collect() }
}

pub(crate) fn pixel(picture: &Picture, x: u32, y: u32) -> [u8; 4] {
    let start = 4 * (y * picture.width + x) as usize;
    std::array::from_fn(|k| picture.rgba[start + k])
}

pub(crate) fn srgb(light: f32) -> u8 {
    to_srgb(light)
}

#[track_caller]
pub(crate) fn assert_near(found: [u8; 4], expected: [u8; 4], tolerance: u8) {
    let is_near = found.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= tolerance);
    assert!(is_near, "{found:?}, not {expected:?}");
}

pub(crate) fn sphere() -> IndexedMesh {
    let mut mesh = shapes::icosphere(4, 1.0);
    mesh.layers.retain(|layer| layer.semantic != Semantic::Normal);
    let normals = mesh.positions.iter().copied().flatten().collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    mesh
}

pub(crate) fn sunlight(direction: [f32; 3]) -> Light {
    let kind = LightKind::Directional;
    Light { kind, color: [2.0; 3], range: None, position: [0.0; 3], direction }
}

pub(crate) fn lit_by(material: Material, light: Light) -> LitTest {
    let mut test = LitTest::new(material);
    test.environment = Environment::uniform([0.0; 3]);
    test.lights = vec![light];
    test
}

pub(crate) fn chalk() -> Material {
    Material { metallic: 0.0, roughness: 1.0, base_color: [0.8, 0.8, 0.8, 1.0], ..Default::default() }
}
