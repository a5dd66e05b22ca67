//! Uploads changed vertices and indices to the GPU and draws them into a texture that the window shows.

use std::ops::Range;

use striata::model::FanInstance;
use striata_gpu::{
    Canvas, Drawing, FanExtractor, Gpu, GpuError, GpuFanInstance, GpuFans, GpuIndices, GpuMorph, GpuVertices,
    Inspection, LitPainter, Look, Painter, Scene, ScreenCopy, Viewpoint, palette_color, wgpu,
};

use super::instance::{Changes, ModelInstance};
use super::mesh_subject::MeshSubject;
use super::scene::{SceneResources, SceneSubject, ShownScene};
use super::state::Colors;
use super::subject::Subject;

/// Samples per pixel.
const SAMPLES: u32 = 4;

/// Whether individual triangles are drawn, and how they are colored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum InspectionMode {
    /// The surface is drawn from its index buffer.
    Off,
    /// Individual triangles are drawn in these colors.
    By(Colors),
}

/// GPU resources of the subject.
#[derive(Debug)]
enum Resources {
    Mesh(Box<MeshResources>),
    Scene(Box<SceneResources>),
}

/// GPU resources of one mesh.
#[derive(Debug)]
struct MeshResources {
    vertices: GpuVertices,
    indices: GpuIndices,
    groups: Vec<Range<u32>>,
    is_strips: bool,
    inspection: Option<Inspection>,
    inspection_mode: InspectionMode,
    /// Fans that are extracted on the GPU.
    fans: Option<ExtractedFans>,
    /// Positions of moving vertices.
    morph: Option<GpuMorph>,
    scene: Scene,
}

/// A fan instance whose triangles the GPU extracts.
#[derive(Debug)]
struct ExtractedFans {
    instance: GpuFanInstance,
    /// Whether the triangles have to be extracted again.
    is_stale: bool,
    /// Whether these triangles are being drawn.
    is_drawn: bool,
}

/// Render target and the copy of it that the window shows.
#[derive(Debug)]
struct RenderTarget {
    canvas: Canvas,
    copy: ScreenCopy,
    size: [u32; 2],
}

/// Renders the shown level into a texture.
#[derive(Debug)]
pub(super) struct SceneRenderer {
    gpu: Gpu,
    painter: Painter,
    extractor: Option<FanExtractor>,
    target: Option<RenderTarget>,
    /// Painter of scenes, made when the first one is loaded.
    lit_painter: Option<LitPainter>,
    resources: Option<Resources>,
    uploaded_bytes: u64,
}

impl SceneRenderer {
    /// Creates a renderer without a model.
    pub(super) fn new(gpu: Gpu) -> Self {
        let painter = Painter::new(&gpu, Canvas::FORMAT, SAMPLES);
        Self {
            gpu,
            painter,
            extractor: None,
            target: None,
            lit_painter: None,
            resources: None,
            uploaded_bytes: 0,
        }
    }

    /// Bytes uploaded so far for indices, colors and moving vertices.
    pub(super) fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }

    /// Uploads the vertices of another subject; if that fails, the old one stays.
    ///
    /// # Errors
    /// If they do not fit into GPU memory.
    pub(super) fn load(&mut self, subject: &Subject) -> Result<(), GpuError> {
        self.resources = Some(match subject {
            Subject::Mesh(mesh) => {
                Resources::Mesh(Box::new(MeshResources::load(&self.gpu, &self.painter, mesh)?))
            }
            Subject::Scene(scene) => {
                let painter = self
                    .lit_painter
                    .get_or_insert_with(|| LitPainter::new(&self.gpu, Canvas::FORMAT, SAMPLES));
                Resources::Scene(Box::new(SceneResources::load(&self.gpu, painter, scene)?))
            }
        });
        Ok(())
    }

    /// Uploads the indices of a scene that have changed, and its pose.
    ///
    /// # Errors
    /// If a buffer exceeds the device's limit.
    pub(super) fn update_scene(
        &mut self,
        subject: &SceneSubject,
        shown: &ShownScene,
        inspection_mode: InspectionMode,
    ) -> Result<(), GpuError> {
        if let Some(Resources::Scene(resources)) = &mut self.resources {
            let device = (&self.gpu, &self.painter);
            self.uploaded_bytes += resources.update(device, (subject, shown), inspection_mode)?;
        }
        Ok(())
    }

    /// Uploads what has changed of one mesh. `is_new` is true if the triangles differ from those of the last call.
    ///
    /// # Errors
    /// If a buffer exceeds the device's limit.
    pub(super) fn update(
        &mut self,
        subject: &MeshSubject,
        instance: &mut ModelInstance,
        inspection_mode: InspectionMode,
        is_new: bool,
    ) -> Result<(), GpuError> {
        let Some(Resources::Mesh(resources)) = &mut self.resources else { return Ok(()) };
        let uploaded_before = resources.uploaded_bytes();
        if let InspectionMode::By(colors) = inspection_mode {
            if is_new || resources.inspection_mode != inspection_mode || resources.inspection.is_none() {
                let (triangles, numbers) = match colors {
                    Colors::StripsOrFans => instance.by_primitive(subject),
                    _ => instance.by_group(subject),
                };
                let colors = triangle_colors(colors, &numbers);
                let vertices = &resources.vertices;
                let inspection = Inspection::new(&self.gpu, &self.painter, vertices, &triangles, &colors)?;
                resources.inspection = Some(inspection);
                self.uploaded_bytes += 16 * triangles.len() as u64;
            }
            // Individual triangles are drawn at rest; motions are uploaded again afterward.
            (resources.inspection_mode, resources.morph) = (inspection_mode, None);
            resources.fans.iter_mut().for_each(|fans| fans.is_drawn = false);
            return Ok(());
        }
        (resources.inspection_mode, resources.inspection) = (inspection_mode, None);
        if is_new || resources.morph.is_none() {
            resources.follow_morphs(&self.gpu, &self.painter, subject, instance)?;
        }
        let fans_were_drawn = resources.fans.as_mut().is_some_and(|fans| std::mem::take(&mut fans.is_drawn));
        match instance.instance_for_gpu() {
            Some(_) if fans_were_drawn && !is_new => resources.keep_drawing_fans(),
            Some(instance) => {
                let extractor = self.extractor.get_or_insert_with(|| FanExtractor::new(&self.gpu));
                resources.write_fans(&self.gpu, extractor, subject, instance)?;
            }
            None => resources.write_indices(&self.gpu, instance)?,
        }
        // A finished morph is dropped with its byte count, hence the saturating subtraction.
        self.uploaded_bytes += resources.uploaded_bytes().saturating_sub(uploaded_before);
        Ok(())
    }

    /// Draws the picture with `size` pixels; returns whether the texture was replaced.
    ///
    /// # Errors
    /// If the size exceeds the device's limit.
    pub(super) fn draw(
        &mut self,
        viewpoint: &Viewpoint,
        size: [u32; 2],
        look: &Look,
    ) -> Result<bool, GpuError> {
        let is_resized = self.target.as_ref().is_none_or(|target| target.size != size);
        if is_resized {
            let canvas = Canvas::new(&self.gpu, size, SAMPLES)?;
            let copy = ScreenCopy::new(&self.gpu, &canvas);
            self.target = Some(RenderTarget { canvas, copy, size });
        }
        let Some(RenderTarget { canvas, copy, .. }) = &self.target else { return Ok(false) };
        let mut encoder = self.gpu.device().create_command_encoder(&Default::default());
        match (&mut self.resources, &self.lit_painter) {
            (Some(Resources::Mesh(resources)), _) => {
                resources.extract_fans(&mut encoder, self.extractor.as_ref());
                resources.scene.update(&self.gpu, &resources.vertices, (viewpoint, size), look);
            }
            (Some(Resources::Scene(resources)), Some(painter)) => {
                resources.aim(&self.gpu, painter, ((viewpoint, size), look))?;
            }
            _ => {}
        }
        let mut pass = canvas.begin(&mut encoder, look.background);
        match &self.resources {
            Some(Resources::Mesh(resources)) => resources.draw(&self.painter, &mut pass),
            Some(Resources::Scene(resources)) => resources.draw(&self.painter, &mut pass),
            None => {}
        }
        drop(pass);
        copy.update(&mut encoder);
        self.gpu.queue().submit([encoder.finish()]);
        Ok(is_resized)
    }

    /// Reads back what was drawn last.
    #[cfg(test)]
    pub(super) fn read(&self, gpu: &Gpu) -> Result<striata_gpu::Picture, GpuError> {
        self.target.as_ref().expect("something was drawn").canvas.read(gpu)
    }

    /// The encoded picture, for a user interface that blends encoded colors.
    pub(super) fn picture(&self) -> Option<&wgpu::TextureView> {
        self.target.as_ref().map(|target| target.copy.view())
    }
}

impl MeshResources {
    fn load(gpu: &Gpu, painter: &Painter, subject: &MeshSubject) -> Result<Self, GpuError> {
        let vertices = GpuVertices::upload(gpu, subject.steps.mesh())?;
        let indices = GpuIndices::new(gpu, 0)?;
        let placeholder =
            Viewpoint { eye: [0.0, 0.0, 1.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 1.0 };
        let scene = painter.scene(gpu, &vertices, (&placeholder, [1, 1]), &Look::default())?;
        Ok(Self {
            vertices,
            indices,
            groups: Vec::new(),
            is_strips: false,
            inspection: None,
            inspection_mode: InspectionMode::Off,
            fans: None,
            morph: None,
            scene,
        })
    }

    /// Extracts the triangles of fans if they have changed.
    fn extract_fans(&mut self, encoder: &mut wgpu::CommandEncoder, extractor: Option<&FanExtractor>) {
        if let (Some(fans), Some(extractor)) = (&mut self.fans, extractor)
            && fans.is_drawn
            && fans.is_stale
        {
            extractor.extract(encoder, &fans.instance);
            fans.is_stale = false;
        }
    }

    fn draw(&self, painter: &Painter, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(inspection) = &self.inspection {
            painter.inspect(pass, &self.scene, inspection);
            return;
        }
        match &self.morph {
            Some(morph) => painter.draw_morphing(pass, &self.scene, morph, self.drawing()),
            None => painter.draw(pass, &self.scene, &self.vertices, self.drawing()),
        }
    }

    /// Bytes uploaded so far, except for inspections.
    fn uploaded_bytes(&self) -> u64 {
        let fans = self.fans.as_ref().map_or(0, |fans| fans.instance.uploaded_bytes());
        self.indices.uploaded_bytes() + fans + self.morph.as_ref().map_or(0, GpuMorph::uploaded_bytes)
    }

    /// Uploads the changed indices.
    fn write_indices(&mut self, gpu: &Gpu, instance: &mut ModelInstance) -> Result<(), GpuError> {
        let changes = instance.take_changes();
        let draw_indices = instance.draw_indices();
        match changes {
            Changes::None => {}
            Changes::Ranges(ranges) if draw_indices.indices.len() <= self.indices.capacity() => {
                self.indices.write_changed(gpu, draw_indices.indices, ranges);
            }
            Changes::Ranges(_) | Changes::All => self.indices.write(gpu, draw_indices.indices)?,
        }
        self.groups.clear();
        self.groups.extend_from_slice(draw_indices.groups);
        self.is_strips = draw_indices.is_strips;
        Ok(())
    }

    /// Uploads which steps are collapsed, preceded once by the table of fans.
    fn write_fans(
        &mut self,
        gpu: &Gpu,
        extractor: &FanExtractor,
        subject: &MeshSubject,
        instance: &FanInstance,
    ) -> Result<(), GpuError> {
        if self.fans.is_none() {
            let Some(scene) = subject.fan_scene() else { return Ok(()) };
            let table = GpuFans::upload(gpu, scene.fans())?;
            let instance = GpuFanInstance::new(gpu, extractor, &table)?;
            self.fans = Some(ExtractedFans { instance, is_stale: true, is_drawn: true });
        }
        if let Some(fans) = &mut self.fans {
            fans.instance.write(gpu, instance);
            (fans.is_stale, fans.is_drawn) = (true, true);
        }
        Ok(())
    }

    /// Uploads the positions of moving vertices; drops the buffers if geomorphs are off.
    fn follow_morphs(
        &mut self,
        gpu: &Gpu,
        painter: &Painter,
        subject: &MeshSubject,
        instance: &ModelInstance,
    ) -> Result<(), GpuError> {
        let (Some(morphs), Some(refinable)) = (instance.morphs(), subject.refinable()) else {
            self.morph = None;
            return Ok(());
        };
        let mut morph = match self.morph.take() {
            Some(morph) => morph,
            None => GpuMorph::new(gpu, painter, &self.vertices)?,
        };
        morph.follow(gpu, morphs, &refinable.sequence)?;
        self.morph = Some(morph);
        Ok(())
    }

    /// Continues drawing the triangles extracted before.
    fn keep_drawing_fans(&mut self) {
        if let Some(fans) = &mut self.fans {
            fans.is_drawn = true;
        }
    }

    fn drawing(&self) -> Drawing<'_> {
        let (indices, groups) = (&self.indices, &self.groups[..]);
        match &self.fans {
            Some(fans) if fans.is_drawn => fans.instance.drawing(),
            _ if self.is_strips => Drawing::Strips { indices, groups },
            _ => Drawing::List { indices, groups },
        }
    }
}

/// Returns a color for each triangle.
fn triangle_colors(colors: Colors, numbers: &[u32]) -> Vec<[u8; 4]> {
    match colors {
        Colors::Surface => vec![[255, 255, 255, 0]; numbers.len()],
        Colors::Triangles => (0..numbers.len() as u32).map(palette_color).collect(),
        Colors::StripsOrFans | Colors::Groups => {
            numbers.iter().map(|&number| palette_color(number)).collect()
        }
    }
}
