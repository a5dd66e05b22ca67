//! The GPU's side of the picture: vertices and indices uploaded as they change, drawn into a texture that the window shows.

use std::ops::Range;

use striata::model::FanInstance;
use striata_gpu::{
    Canvas, Drawing, FanExtractor, Gpu, GpuError, GpuFanInstance, GpuFans, GpuIndices, GpuMorph, GpuVertices,
    Inspection, Look, Painter, Scene, ScreenCopy, Viewpoint, palette_color, wgpu,
};

use super::shown::{Changes, Shown};
use super::state::Colors;
use super::subject::Subject;

/// Samples a pixel.
const SAMPLES: u32 = 4;

/// What the triangles of an inspection are told apart by, and whether there is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Inspected {
    /// The surface is drawn by its indices.
    No,
    /// Single triangles, in these colors.
    By(Colors),
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
    /// Fans that are extracted on the GPU, and whether they have to be.
    fans: Option<ExtractedFans>,
    /// Where vertices are that move.
    morph: Option<GpuMorph>,
    scene: Scene,
}

/// An instance of fans whose triangles the GPU makes.
#[derive(Debug)]
struct ExtractedFans {
    instance: GpuFanInstance,
    /// The triangles are not those of the instance yet.
    is_stale: bool,
    /// Whether they are what is drawn.
    is_drawn: bool,
}

/// The picture, and the copy of it that the window shows.
#[derive(Debug)]
struct Framed {
    canvas: Canvas,
    copy: ScreenCopy,
    size: [u32; 2],
}

/// Where the model is drawn.
#[derive(Debug)]
pub(super) struct Stage {
    gpu: Gpu,
    painter: Painter,
    extractor: Option<FanExtractor>,
    canvas: Option<Framed>,
    props: Option<Props>,
    uploaded_bytes: u64,
}

impl Stage {
    /// A stage without a model.
    pub(super) fn new(gpu: Gpu) -> Self {
        let painter = Painter::new(&gpu, Canvas::FORMAT, SAMPLES);
        Self { gpu, painter, extractor: None, canvas: None, props: None, uploaded_bytes: 0 }
    }

    /// Bytes uploaded so far of indices, colors and moved vertices.
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
            fans: None,
            morph: None,
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
        let uploaded_before = props.uploaded_bytes();
        if let Inspected::By(colors) = inspected {
            if is_new || props.inspected != inspected || props.inspection.is_none() {
                let (triangles, numbers) = match colors {
                    Colors::Pieces => shown.pieces(subject),
                    _ => shown.grouped(subject),
                };
                let colors = triangle_colors(colors, &numbers);
                let vertices = &props.vertices;
                let inspection = Inspection::new(&self.gpu, &self.painter, vertices, (&triangles, &colors))?;
                props.inspection = Some(inspection);
                self.uploaded_bytes += 16 * triangles.len() as u64;
            }
            // Single triangles stand where they belong; what moves is followed anew afterwards.
            (props.inspected, props.morph) = (inspected, None);
            props.fans.iter_mut().for_each(|fans| fans.is_drawn = false);
            return Ok(());
        }
        (props.inspected, props.inspection) = (inspected, None);
        if is_new || props.morph.is_none() {
            props.follow_morphs(&self.gpu, &self.painter, (subject, shown))?;
        }
        let fans_were_drawn = props.fans.as_mut().is_some_and(|fans| std::mem::take(&mut fans.is_drawn));
        match shown.instance_for_gpu() {
            Some(_) if fans_were_drawn && !is_new => props.draws_fans(),
            Some(instance) => {
                let extractor = self.extractor.get_or_insert_with(|| FanExtractor::new(&self.gpu));
                props.write_fans(&self.gpu, extractor, (subject, instance))?;
            }
            None => props.write_indices(&self.gpu, shown)?,
        }
        // A morph that is over takes its count with it.
        self.uploaded_bytes += props.uploaded_bytes().saturating_sub(uploaded_before);
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
        let is_resized = self.canvas.as_ref().is_none_or(|framed| framed.size != size);
        if is_resized {
            let canvas = Canvas::new(&self.gpu, size, SAMPLES)?;
            let copy = ScreenCopy::new(&self.gpu, &canvas);
            self.canvas = Some(Framed { canvas, copy, size });
        }
        let Some(Framed { canvas, copy, .. }) = &self.canvas else { return Ok(false) };
        let mut encoder = self.gpu.device().create_command_encoder(&Default::default());
        if let (Some(fans), Some(extractor)) =
            (self.props.as_mut().and_then(|props| props.fans.as_mut()), &self.extractor)
            && fans.is_drawn
            && fans.is_stale
        {
            extractor.extract(&mut encoder, &fans.instance);
            fans.is_stale = false;
        }
        let mut pass = canvas.begin(&mut encoder, look.background);
        if let Some(props) = &mut self.props {
            props.scene.update(&self.gpu, &props.vertices, (viewpoint, size), look);
            if let Some(inspection) = &props.inspection {
                self.painter.inspect(&mut pass, &props.scene, inspection);
            } else {
                let drawing = props.drawing();
                match &props.morph {
                    Some(morph) => self.painter.draw_morphing(&mut pass, &props.scene, morph, drawing),
                    None => self.painter.draw(&mut pass, &props.scene, &props.vertices, drawing),
                }
            }
        }
        drop(pass);
        copy.update(&mut encoder);
        self.gpu.queue().submit([encoder.finish()]);
        Ok(is_resized)
    }

    /// The picture as its bytes stand, for a window that mixes colors as the screen encodes them.
    pub(super) fn picture(&self) -> Option<&wgpu::TextureView> {
        self.canvas.as_ref().map(|framed| framed.copy.view())
    }
}

impl Props {
    /// Bytes uploaded so far, but for inspections.
    fn uploaded_bytes(&self) -> u64 {
        let fans = self.fans.as_ref().map_or(0, |fans| fans.instance.uploaded_bytes());
        self.indices.uploaded_bytes() + fans + self.morph.as_ref().map_or(0, GpuMorph::uploaded_bytes)
    }

    /// Uploads what has changed of the indices.
    fn write_indices(&mut self, gpu: &Gpu, shown: &mut Shown) -> Result<(), GpuError> {
        let changes = shown.take_changes();
        let form = shown.form();
        match changes {
            Changes::None => {}
            Changes::Ranges(ranges) if form.indices.len() <= self.indices.capacity() => {
                self.indices.write_ranges(gpu, form.indices, &ranges);
            }
            Changes::Ranges(_) | Changes::All => self.indices.write(gpu, form.indices)?,
        }
        self.groups.clear();
        self.groups.extend_from_slice(form.groups);
        self.is_strips = form.is_strips;
        Ok(())
    }

    /// Uploads which steps are taken; the table comes before, once.
    fn write_fans(
        &mut self,
        gpu: &Gpu,
        extractor: &FanExtractor,
        (subject, instance): (&Subject, &FanInstance),
    ) -> Result<(), GpuError> {
        if self.fans.is_none() {
            let Some((scene, _)) = subject.fan_scene() else { return Ok(()) };
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

    /// Uploads where vertices are that move; where nothing ever does, nothing is kept.
    fn follow_morphs(
        &mut self,
        gpu: &Gpu,
        painter: &Painter,
        (subject, shown): (&Subject, &Shown),
    ) -> Result<(), GpuError> {
        let (Some(morphs), Some(refinable)) = (shown.morphs(), subject.refinable()) else {
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

    /// Goes on drawing what was extracted before.
    fn draws_fans(&mut self) {
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

/// A color for each triangle.
fn triangle_colors(colors: Colors, numbers: &[u32]) -> Vec<[u8; 4]> {
    match colors {
        Colors::Surface => vec![[255, 255, 255, 0]; numbers.len()],
        Colors::Triangles => (0..numbers.len() as u32).map(palette_color).collect(),
        Colors::Pieces | Colors::Groups => numbers.iter().map(|&number| palette_color(number)).collect(),
    }
}
