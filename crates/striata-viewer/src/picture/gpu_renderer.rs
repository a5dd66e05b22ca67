//! Draws shots with a GPU.

use std::borrow::Cow;
use std::ops::Range;
use std::time::Instant;

use striata::mesh::IndexedMesh;
use striata_gpu::wgpu::RenderPass;
use striata_gpu::{
    Canvas as GpuCanvas, Drawing, Gpu, GpuError, GpuIndices, GpuOptions, GpuVertices, Inspection, Look,
    Painter, RejectedAdapter, Scene, Shading, Viewpoint, choose_adapter,
};

use super::gpu_look::{LookPainter, SeenLook, UploadedLook};
use super::rendered_picture::Drawn;
use super::shot::{LineTriangles, Paint, STONE, Shot};
use super::{Camera, Canvas};
use striata_command::driver_messages::without_driver_messages;
use striata_command::failure::catch_panic;
use striata_command::output::Output;

/// A GPU with everything that is shared by all shots.
#[derive(Debug)]
pub struct GpuRenderer {
    gpu: Gpu,
    painter: Painter,
    /// Created when a shot with materials is drawn for the first time.
    look_painter: Option<LookPainter>,
    canvas: Option<([u32; 2], GpuCanvas)>,
}

/// Samples per pixel.
const SAMPLES: u32 = 4;
/// Downsampling factor: each final pixel is the mean of a square of this many pixels per side.
const DOWNSAMPLING: usize = 2;
/// Maximum number of pixels of a picture that is downsampled: each takes 64 bytes, and larger pictures
/// look fine with samples alone.
const MAX_DOWNSAMPLED_PIXELS: usize = 48 << 20;

/// A shot on the GPU.
enum Uploaded {
    Plain(UploadedShot),
    WithLook(UploadedLook),
}

/// GPU resources of one shot without materials.
struct UploadedShot {
    vertices: GpuVertices,
    surface: Surface,
    lines: Option<(Scene, Inspection)>,
    scene: Scene,
}

/// How the surface of a shot is drawn.
enum Surface {
    List(GpuIndices, Range<u32>),
    Strips(GpuIndices, Vec<Range<u32>>),
    Triangles(Inspection),
}

impl GpuRenderer {
    /// Opens the best adapter that can draw, and returns the better ones that were rejected.
    ///
    /// # Errors
    /// If no adapter can draw.
    pub fn open(options: &GpuOptions, output: &Output) -> Result<(Self, Vec<RejectedAdapter>), GpuError> {
        let chosen = without_driver_messages(output, || attempt(|| choose_adapter(options, Gpu::probe)))?;
        if output.is_verbose() {
            let info = chosen.gpu.info();
            output.say(&format!(
                "drawing on {}, driver {} {}",
                chosen.gpu.name(),
                info.driver,
                info.driver_info
            ));
        }
        let painter = Painter::new(&chosen.gpu, SAMPLES);
        Ok((Self { gpu: chosen.gpu, painter, look_painter: None, canvas: None }, chosen.rejected))
    }

    /// Name of the adapter.
    pub fn name(&self) -> String {
        self.gpu.name()
    }

    /// Destroys the device, to simulate losing it.
    #[cfg(test)]
    pub(super) fn destroy(&self) {
        self.gpu.device().destroy();
    }

    /// Draws a shot, at a higher resolution if possible, and downsamples it.
    ///
    /// # Errors
    /// If the GPU runs out of memory, is lost, or its driver panics.
    pub(super) fn draw(
        &mut self,
        shot: &Shot<'_>,
        camera: &Camera,
        size: [usize; 2],
    ) -> Result<Drawn, GpuError> {
        attempt(|| self.try_to_draw(shot, camera, size))
    }

    fn try_to_draw(
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
        let uploaded = match shot.visible_look() {
            Some(scene_look) => {
                let painter = self.look_painter.get_or_insert_with(|| LookPainter::new(&self.gpu, SAMPLES));
                Uploaded::WithLook(painter.upload(
                    &self.gpu,
                    shot,
                    SeenLook { look: scene_look, camera, size },
                )?)
            }
            None => {
                let look = look(shot, shot.edge_opacity(camera, height), factor as f32);
                Uploaded::Plain(self.upload(shot, camera, size, &look)?)
            }
        };
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
        {
            let mut pass = canvas.begin(&mut encoder, [0.0; 4]);
            match uploaded {
                Uploaded::Plain(uploaded) => self.paint(&mut pass, uploaded),
                Uploaded::WithLook(uploaded) => uploaded.frame.draw(&mut pass),
            }
        }
        self.gpu.queue().submit([encoder.finish()]);
        self.gpu.wait()
    }

    fn paint(&self, pass: &mut RenderPass<'_>, uploaded: &UploadedShot) {
        let UploadedShot { vertices, surface, lines, scene } = uploaded;
        match surface {
            Surface::List(indices, whole) => {
                let drawing = Drawing::List { indices, groups: std::slice::from_ref(whole) };
                self.painter.draw(pass, scene, vertices, drawing);
            }
            Surface::Strips(indices, groups) => {
                self.painter.draw(pass, scene, vertices, Drawing::Strips { indices, groups });
            }
            Surface::Triangles(inspection) => self.painter.inspect(pass, scene, inspection),
        }
        if let Some((scene, inspection)) = lines {
            self.painter.inspect(pass, scene, inspection);
        }
    }

    fn upload(
        &self,
        shot: &Shot<'_>,
        camera: &Camera,
        size: [u32; 2],
        look: &Look,
    ) -> Result<UploadedShot, GpuError> {
        let (gpu, painter) = (&self.gpu, &self.painter);
        let lines = LineTriangles::new(&shot.lines, camera, shot.vertices.vertex_count());
        let mesh = with_more_vertices(shot.vertices, &lines.positions);
        let mut vertices = GpuVertices::upload(gpu, &mesh)?;
        if let Paint::Vertices(colors) = &shot.paint {
            let mut colors = colors.clone();
            colors.resize(mesh.vertex_count(), [0; 4]);
            vertices.set_colors(gpu, &colors);
        }
        let surface = match (shot.colors_of_triangles(), shot.strips) {
            (Some(colors), _) => {
                Surface::Triangles(Inspection::new(gpu, painter, &vertices, &shot.triangles, &colors)?)
            }
            (None, Some(strips)) => {
                let indices = GpuIndices::upload(gpu, &strips.indices)?;
                Surface::Strips(indices, strips.group_ranges.clone())
            }
            (None, None) => {
                let whole = 0..3 * shot.triangles.len() as u32;
                Surface::List(GpuIndices::upload(gpu, shot.triangles.as_flattened())?, whole)
            }
        };
        let viewpoint = viewpoint(camera);
        let view = (&viewpoint, size);
        let scene = painter.scene(gpu, &vertices, view, look)?;
        let lines = if lines.triangles.is_empty() {
            None
        } else {
            let scene = painter.scene(gpu, &vertices, view, &Look::default().with_light(0.0))?;
            Some((scene, Inspection::new(gpu, painter, &vertices, &lines.triangles, &lines.colors)?))
        };
        Ok(UploadedShot { vertices, surface, lines, scene })
    }
}

/// Runs work on the GPU and turns panics into errors, so that the rasterizer can draw the picture instead.
fn attempt<T>(work: impl FnOnce() -> Result<T, GpuError>) -> Result<T, GpuError> {
    catch_panic(work).unwrap_or_else(|panic| Err(GpuError::Failed(panic)))
}

fn look(shot: &Shot<'_>, edge_opacity: f32, factor: f32) -> Look {
    Look::default()
        .with_base(STONE)
        .with_background([0.0; 4])
        .with_shading(if shot.is_flat { Shading::Flat } else { Shading::Smooth })
        .with_edges([0.0, 0.0, 0.0, edge_opacity])
        .with_edge_width_px(factor)
        .with_light(shot.light())
}

fn viewpoint(camera: &Camera) -> Viewpoint {
    Viewpoint { eye: camera.eye, look_at: camera.look_at, up: camera.up, fov: camera.fov }
}

/// Appends vertices for lines; their attributes are copied from the first vertex and not used.
fn with_more_vertices<'a>(mesh: &'a IndexedMesh, positions: &[[f32; 3]]) -> Cow<'a, IndexedMesh> {
    if positions.is_empty() {
        return Cow::Borrowed(mesh);
    }
    let mut order: Vec<u32> = (0..mesh.vertex_count() as u32).collect();
    order.resize(order.len() + positions.len(), 0);
    Cow::Owned(IndexedMesh {
        positions: [&mesh.positions[..], positions].concat(),
        layers: mesh.layers.iter().map(|layer| layer.gather(&order)).collect(),
        ..IndexedMesh::default()
    })
}
