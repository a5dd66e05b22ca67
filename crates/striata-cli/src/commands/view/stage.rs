//! The GPU's side of the picture: vertices and indices uploaded as they change, drawn into a texture that the window shows.

use std::ops::Range;

use striata_gpu::{
    Canvas, Drawing, Gpu, GpuError, GpuIndices, GpuVertices, Inspection, Look, Painter, Scene, Viewpoint,
    palette_colour, wgpu,
};

use super::shown::{Changes, Shown};
use super::state::Colours;
use super::subject::Subject;

/// Samples a pixel.
const SAMPLES: u32 = 4;

/// What the triangles of an inspection are told apart by, and whether there is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Inspected {
    /// The surface is drawn by its indices.
    No,
    /// Single triangles, in these colours.
    By(Colours),
}

/// Everything on the GPU that belongs to one subject.
#[derive(Debug)]
struct Props {
    vertices: GpuVertices,
    indices: GpuIndices,
    groups: Vec<Range<u32>>,
    is_strips: bool,
    inspection: Option<Inspection>,
    inspected: Inspected,
    scene: Scene,
}

/// Where the model is drawn.
#[derive(Debug)]
pub(super) struct Stage {
    gpu: Gpu,
    painter: Painter,
    canvas: Option<(Canvas, [u32; 2])>,
    props: Option<Props>,
    uploaded_bytes: u64,
}

impl Stage {
    /// A stage without a model.
    pub(super) fn new(gpu: Gpu) -> Self {
        let painter = Painter::new(&gpu, Canvas::FORMAT, SAMPLES);
        Self { gpu, painter, canvas: None, props: None, uploaded_bytes: 0 }
    }

    /// Bytes uploaded so far of indices, colours and moved vertices.
    pub(super) fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }

    /// Brings another subject's vertices to the GPU; the old one's stay where that fails.
    ///
    /// # Errors
    /// Where they do not fit.
    pub(super) fn enter(&mut self, subject: &Subject) -> Result<(), GpuError> {
        let vertices = GpuVertices::upload(&self.gpu, subject.steps.mesh())?;
        let indices = GpuIndices::new(&self.gpu, 0)?;
        let nowhere = Viewpoint { eye: [0.0, 0.0, 1.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 1.0 };
        let scene = self.painter.scene(&self.gpu, &vertices, (&nowhere, [1, 1]), &Look::default())?;
        self.props = Some(Props {
            vertices,
            indices,
            groups: Vec::new(),
            is_strips: false,
            inspection: None,
            inspected: Inspected::No,
            scene,
        });
        Ok(())
    }

    /// Uploads what has changed of a level. `is_new` says that the triangles are others than at the last time.
    ///
    /// # Errors
    /// Where it does not fit.
    pub(super) fn update(
        &mut self,
        subject: &Subject,
        shown: &mut Shown,
        (inspected, is_new): (Inspected, bool),
    ) -> Result<(), GpuError> {
        let Some(props) = &mut self.props else { return Ok(()) };
        if let Inspected::By(colours) = inspected {
            if is_new || props.inspected != inspected || props.inspection.is_none() {
                let (triangles, numbers) = match colours {
                    Colours::Pieces => shown.pieces(subject),
                    _ => shown.grouped(),
                };
                let colours = triangle_colours(colours, &numbers);
                let vertices = &props.vertices;
                let inspection = Inspection::new(&self.gpu, &self.painter, vertices, (&triangles, &colours))?;
                props.inspection = Some(inspection);
                self.uploaded_bytes += 16 * triangles.len() as u64;
            }
            props.inspected = inspected;
            return Ok(());
        }
        (props.inspected, props.inspection) = (inspected, None);
        let before = props.indices.uploaded_bytes();
        let changes = shown.take_changes();
        let form = shown.form();
        match changes {
            Changes::None => {}
            Changes::Ranges(ranges) if form.indices.len() <= props.indices.capacity() => {
                props.indices.write_ranges(&self.gpu, form.indices, &ranges);
            }
            Changes::Ranges(_) | Changes::All => props.indices.write(&self.gpu, form.indices)?,
        }
        self.uploaded_bytes += props.indices.uploaded_bytes() - before;
        props.groups.clear();
        props.groups.extend_from_slice(form.groups);
        props.is_strips = form.is_strips;
        Ok(())
    }

    /// Draws the picture, of so many pixels; whether it has become another texture.
    ///
    /// # Errors
    /// Where so many pixels cannot be drawn.
    pub(super) fn draw(
        &mut self,
        viewpoint: &Viewpoint,
        size: [u32; 2],
        look: &Look,
    ) -> Result<bool, GpuError> {
        let is_resized = self.canvas.as_ref().is_none_or(|(_, old)| *old != size);
        if is_resized {
            self.canvas = Some((Canvas::new(&self.gpu, size, SAMPLES)?, size));
        }
        let Some((canvas, _)) = &self.canvas else { return Ok(false) };
        let mut encoder = self.gpu.device().create_command_encoder(&Default::default());
        let mut pass = canvas.begin(&mut encoder, look.background);
        if let Some(props) = &mut self.props {
            props.scene.update(&self.gpu, &props.vertices, (viewpoint, size), look);
            if let Some(inspection) = &props.inspection {
                self.painter.inspect(&mut pass, &props.scene, inspection);
            } else {
                let (indices, groups) = (&props.indices, &props.groups[..]);
                let drawing = match props.is_strips {
                    true => Drawing::Strips { indices, groups },
                    false => Drawing::List { indices, groups },
                };
                self.painter.draw(&mut pass, &props.scene, &props.vertices, drawing);
            }
        }
        drop(pass);
        self.gpu.queue().submit([encoder.finish()]);
        Ok(is_resized)
    }

    /// The picture as its bytes stand, for a window that mixes colours as the screen encodes them.
    pub(super) fn picture(&self) -> Option<wgpu::TextureView> {
        self.canvas.as_ref().map(|(canvas, _)| canvas.encoded_view())
    }
}

/// A colour for each triangle.
fn triangle_colours(colours: Colours, numbers: &[u32]) -> Vec<[u8; 4]> {
    match colours {
        Colours::Surface => vec![[255, 255, 255, 0]; numbers.len()],
        Colours::Triangles => (0..numbers.len() as u32).map(palette_colour).collect(),
        Colours::Pieces | Colours::Groups => numbers.iter().map(|&number| palette_colour(number)).collect(),
    }
}
