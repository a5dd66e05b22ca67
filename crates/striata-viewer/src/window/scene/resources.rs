//! A scene on the GPU: vertices and materials are uploaded once, indices when they change, poses in each
//! frame.

use striata_gpu::glam::DMat4;
use striata_gpu::{
    Environment, Gpu, GpuError, GpuIndices, LitCamera, LitFrame, LitLight, LitMaterials, LitObject,
    LitPainter, LitPart, LitScene, LitVertices, Look, Painter, Viewpoint, wgpu,
};

use super::inspection::SceneInspection;
use super::shown::ShownScene;
use super::subject::SceneSubject;
use crate::lit::lit_lights;
use crate::window::scene_renderer::InspectionMode;

/// GPU resources of a scene.
#[derive(Debug)]
pub(in crate::window) struct SceneResources {
    vertices: Vec<Option<LitVertices>>,
    materials: LitMaterials,
    lists: Vec<Option<IndexList>>,
    objects: Vec<PosedObject>,
    lights: Vec<LitLight>,
    frame: LitFrame,
    /// Individual triangles, if these are drawn instead.
    inspection: Option<SceneInspection>,
}

/// Indices that one or more instances show.
#[derive(Debug)]
struct IndexList {
    indices: GpuIndices,
    revision: u64,
    parts: Vec<LitPart>,
}

/// An instance of the current frame.
#[derive(Debug)]
struct PosedObject {
    mesh: usize,
    list: usize,
    world: DMat4,
    joints: Vec<DMat4>,
    morph_weights: Vec<f32>,
}

impl SceneResources {
    /// Uploads the vertices and materials of a scene.
    ///
    /// # Errors
    /// If they do not fit into GPU memory.
    pub(in crate::window) fn load(
        gpu: &Gpu,
        painter: &LitPainter,
        subject: &SceneSubject,
    ) -> Result<Self, GpuError> {
        let meshes = subject.lods.lods().iter();
        let upload = |lod: &Option<striata::Lod>| {
            lod.as_ref().map(|lod| LitVertices::upload(gpu, painter, lod.mesh())).transpose()
        };
        let list_count = subject.lods.lods().len() + subject.lods.scene().instances().len();
        Ok(Self {
            vertices: meshes.map(upload).collect::<Result<_, _>>()?,
            materials: LitMaterials::upload(gpu, painter, &subject.materials, &subject.images)?,
            lists: std::iter::repeat_with(|| None).take(list_count).collect(),
            objects: Vec::new(),
            lights: Vec::new(),
            frame: LitFrame::new(gpu, painter, &Environment::studio())?,
            inspection: None,
        })
    }

    /// Uploads the indices that have changed, and remembers places and lights; or uploads individual
    /// triangles. Returns the uploaded bytes.
    ///
    /// # Errors
    /// If a buffer exceeds the device's limit.
    pub(in crate::window) fn update(
        &mut self,
        (gpu, painter): (&Gpu, &Painter),
        (subject, shown): (&SceneSubject, &ShownScene),
        inspection_mode: InspectionMode,
    ) -> Result<u64, GpuError> {
        self.inspection = None;
        if let InspectionMode::By(colors) = inspection_mode {
            let (inspection, bytes) = SceneInspection::new(gpu, painter, subject, shown, colors)?;
            self.inspection = Some(inspection);
            return Ok(bytes);
        }
        let mut uploaded_bytes = 0;
        self.objects.clear();
        for index in 0..shown.instance_count() {
            let Some((drawn, triangles)) = shown.instance(index) else { continue };
            let slot = &mut self.lists[triangles.list];
            if slot.as_ref().is_none_or(|list| list.revision != triangles.revision) {
                let mut indices = match slot.take() {
                    Some(list) => list.indices,
                    None => GpuIndices::new(gpu, triangles.indices.len())?,
                };
                indices.write(gpu, triangles.indices)?;
                uploaded_bytes += 4 * triangles.indices.len() as u64;
                let materials = &subject.primitive_materials[drawn.mesh];
                let parts = triangles.groups.iter().enumerate().map(|(primitive, range)| LitPart {
                    range: range.clone(),
                    material: materials.get(primitive).copied().flatten(),
                });
                let parts = parts.collect();
                *slot = Some(IndexList { indices, revision: triangles.revision, parts });
            }
            self.objects.push(PosedObject {
                mesh: drawn.mesh,
                list: triangles.list,
                world: DMat4::from_cols_array(&drawn.world),
                joints: drawn.joints.iter().map(DMat4::from_cols_array).collect(),
                morph_weights: drawn.morph_weights.clone(),
            });
        }
        self.lights = lit_lights(shown.lights());
        Ok(uploaded_bytes)
    }

    /// Prepares the frame for a camera and a picture of `size` pixels.
    ///
    /// # Errors
    /// If all joints together exceed the device's limit.
    pub(in crate::window) fn aim(
        &mut self,
        gpu: &Gpu,
        painter: &LitPainter,
        ((viewpoint, size), look): ((&Viewpoint, [u32; 2]), &Look),
    ) -> Result<(), GpuError> {
        if let Some(inspection) = &mut self.inspection {
            inspection.aim(gpu, (viewpoint, size), look);
            return Ok(());
        }
        let objects: Vec<LitObject<'_>> =
            self.objects.iter().filter_map(|object| object.lit(&self.vertices, &self.lists)).collect();
        let scene = LitScene {
            camera: LitCamera::from(viewpoint),
            size,
            lights: &self.lights,
            materials: &self.materials,
            objects: &objects,
        };
        self.frame.update(gpu, painter, &scene)
    }

    /// Draws the frame.
    pub(in crate::window) fn draw(&self, painter: &Painter, pass: &mut wgpu::RenderPass<'_>) {
        match &self.inspection {
            Some(inspection) => inspection.draw(painter, pass),
            None => self.frame.draw(pass),
        }
    }
}

impl PosedObject {
    fn lit<'a>(
        &'a self,
        vertices: &'a [Option<LitVertices>],
        lists: &'a [Option<IndexList>],
    ) -> Option<LitObject<'a>> {
        let vertices = vertices.get(self.mesh)?.as_ref()?;
        let list = lists.get(self.list)?.as_ref()?;
        Some(LitObject {
            world_from_mesh: self.world,
            joints: &self.joints,
            morph_weights: &self.morph_weights,
            ..LitObject::new(vertices, &list.indices, &list.parts)
        })
    }
}
