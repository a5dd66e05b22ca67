//! Draws surfaces with materials on a GPU.

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};
use striata_scene::drawn::{AlphaMode, Material};

use crate::camera::{Camera, to_f64};
use crate::environment::Environment;
use crate::gpu::{
    Gpu, GpuError, GpuIndices, LitFrame, LitMaterials, LitObject, LitPainter, LitPart, LitScene, LitVertices,
};
use crate::scene_look::SceneLook;
use crate::shot::{LineTriangles, Shot};

/// Painter of pictures with materials: the shader, and the materials of the last look.
#[derive(Debug)]
pub(crate) struct LookPainter {
    painter: LitPainter,
    /// Materials with the number of their look; the last one is for lines.
    materials: Option<(u64, LitMaterials)>,
}

/// The materials of a picture, and where they are seen from.
pub(crate) struct SeenLook<'a> {
    /// Materials and lights.
    pub look: &'a SceneLook,
    /// The camera.
    pub camera: &'a Camera,
    /// Width and height, pixels.
    pub size: [u32; 2],
}

impl LookPainter {
    pub(crate) fn new(gpu: &Gpu, samples: u32) -> Self {
        Self { painter: LitPainter::new(gpu, samples), materials: None }
    }

    /// Uploads a shot, whose materials stay for the next one with the same look.
    ///
    /// # Errors
    /// If the GPU runs out of memory.
    pub(crate) fn upload(
        &mut self,
        gpu: &Gpu,
        shot: &Shot<'_>,
        SeenLook { look, camera, size }: SeenLook<'_>,
    ) -> Result<LitFrame, GpuError> {
        if self.materials.as_ref().is_none_or(|(id, _)| *id != look.id()) {
            self.materials = Some((look.id(), upload_materials(gpu, &self.painter, look)?));
        }
        let Some((_, materials)) = &self.materials else {
            return Err(GpuError::Failed("no materials were uploaded".to_owned()));
        };
        let painter = &self.painter;
        let surface = surface_of(shot);
        let vertices = LitVertices::upload(gpu, &surface)?;
        let (triangles, parts) = parts_of(shot, look, camera);
        let indices = GpuIndices::upload(gpu, triangles.as_flattened())?;
        let mut objects = vec![LitObject { vertices: &vertices, indices: &indices, parts: &parts }];
        let lines = LineTriangles::new(&shot.lines, camera, 0);
        let line_mesh = line_mesh(&lines);
        let line_vertices = LitVertices::upload(gpu, &line_mesh)?;
        let line_indices = GpuIndices::upload(gpu, line_mesh.triangles.as_flattened())?;
        let range = 0..3 * line_mesh.triangles.len() as u32;
        let line_parts = [LitPart { range, material: Some(look.materials.len()) }];
        if !line_mesh.triangles.is_empty() {
            objects.push(LitObject { vertices: &line_vertices, indices: &line_indices, parts: &line_parts });
        }
        // Lights beyond the limit are left out.
        let lights = &look.lights[..look.lights.len().min(LitFrame::MAX_LIGHT_COUNT)];
        let scene = LitScene { camera, size, lights, materials, objects: &objects };
        LitFrame::new(gpu, painter, &Environment::studio(), &scene)
    }
}

fn upload_materials(gpu: &Gpu, painter: &LitPainter, look: &SceneLook) -> Result<LitMaterials, GpuError> {
    let lines = Material { is_unlit: true, is_double_sided: true, ..Material::default() };
    let materials: Vec<Material> = look.materials.iter().cloned().chain([lines]).collect();
    LitMaterials::upload(gpu, painter, &materials, &look.images)
}

/// Returns the vertices of a shot with the attributes that its style needs.
fn surface_of<'a>(shot: &Shot<'a>) -> std::borrow::Cow<'a, IndexedMesh> {
    let mesh = shot.vertices;
    if !shot.is_flat || mesh.layer(&Semantic::Normal).is_none() {
        return std::borrow::Cow::Borrowed(mesh);
    }
    let layers = mesh.layers.iter().filter(|layer| layer.semantic != Semantic::Normal);
    std::borrow::Cow::Owned(IndexedMesh {
        layers: layers.cloned().collect(),
        ..IndexedMesh::new(mesh.positions.clone(), Vec::new())
    })
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
    let distance = |&(_, triangle): &(Option<u32>, [u32; 3])| {
        let depth = |v: u32| -(to_f64(shot.vertices.positions[v as usize]) - camera.eye_64()).dot(back);
        // Like the rasterizer, which adds inverse depths.
        triangle.map(|v| 1.0 / depth(v).max(1e-30)).iter().sum::<f64>()
    };
    blended.sort_by_cached_key(|entry| ordered(distance(entry)));
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

/// A positive number as an integer in the same order.
fn ordered(number: f64) -> u64 {
    number.max(0.0).to_bits()
}

/// Returns lines as a mesh with a color for each vertex.
fn line_mesh(lines: &LineTriangles) -> IndexedMesh {
    let mut mesh = IndexedMesh::new(lines.positions.clone(), lines.triangles.clone());
    let mut colors = vec![[1.0; 4]; lines.positions.len()];
    for (triangle, color) in lines.triangles.iter().zip(&lines.colors) {
        triangle.iter().for_each(|&v| colors[v as usize] = color.map(|byte| f32::from(byte) / 255.0));
    }
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 4, colors.into_flattened()));
    mesh
}
