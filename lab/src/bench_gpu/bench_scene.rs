//! The scene that is drawn in every way: the mesh with its steps and strips, its vertices on the GPU, and
//! the canvas.

use striata::mesh::{IndexedMesh, RefinableMesh, weld};
use striata::model::{LodStrips, StageOptions};
use striata::simplify::{SequenceOptions, build_welded_sequence_with_progress};
use striata::strip::StripSet;
use striata_render::Camera;
use striata_render::gpu::{Canvas, Gpu, GpuVertices, Look, Painter, Scene};
use striata_strip::{StripOptions, stripify};

use striata_command::failure::Failure;
use striata_command::output::Bar;
use striata_command::strip_chain::StripPlan;

/// A mesh on the GPU with everything needed to draw it.
pub(super) struct BenchScene<'a> {
    pub gpu: &'a Gpu,
    pub refinable: RefinableMesh,
    pub strips: StripSet,
    /// Strip options for levels that get their own strips.
    pub level_strips: StripOptions,
    pub vertices: GpuVertices,
    pub painter: Painter,
    pub canvas: Canvas,
    pub scene: Scene,
    pub look: Look,
}

impl<'a> BenchScene<'a> {
    /// Builds steps and strips, and uploads the vertices.
    ///
    /// # Errors
    /// If the mesh is inconsistent or does not fit onto the GPU.
    pub(super) fn new(
        gpu: &'a Gpu,
        (name, mesh): (&str, &IndexedMesh),
        (size, plan): ([u32; 2], &StripPlan),
        bar: &mut Bar,
    ) -> Result<Self, Failure> {
        let options = SequenceOptions::default();
        let built =
            build_welded_sequence_with_progress(weld(mesh)?, &options, &mut |progress| bar.show(progress))?;
        let refinable = built.refinable;
        let strips = plan.run(&refinable.mesh, &mut |share| bar.share("strip", share))?.strips;
        let Some(bounds) = refinable.mesh.bounds().filter(|_| refinable.mesh.triangle_count() > 0) else {
            return Err(Failure::user(format!(
                "{name}: there is nothing to draw: the mesh has no triangles"
            )));
        };
        let canvas = Canvas::new(gpu, size, 1)?;
        let painter = Painter::new(gpu, canvas.samples());
        let vertices = GpuVertices::upload(gpu, &refinable.mesh)?;
        let view = Camera::portrait(&bounds, -0.6, 0.15, 0.6);
        let look = Look::default();
        let scene = painter.scene(gpu, &vertices, (&view, size), &look)?;
        let level_strips = plan.search.options(plan.chain.last());
        Ok(Self { gpu, refinable, strips, level_strips, vertices, painter, canvas, scene, look })
    }

    /// LodStrips in a single stage.
    ///
    /// # Errors
    /// If the strips do not belong to the mesh, which would be a bug.
    pub(super) fn lod_strips(&self) -> Result<LodStrips<'static>, Failure> {
        Ok(LodStrips::build(&self.refinable, &self.strips)?)
    }

    /// LodStrips in stages.
    ///
    /// # Errors
    /// If the strips do not belong to the mesh, which would be a bug.
    pub(super) fn staged_lod_strips(&self) -> Result<LodStrips<'static>, Failure> {
        let strips = |level: &_| stripify(level, &self.level_strips).map_err(Failure::from);
        LodStrips::build_staged(&self.refinable, &self.strips, &StageOptions::default(), strips)
    }

    /// Number of steps from the base mesh to the full mesh.
    pub(super) fn step_count(&self) -> usize {
        self.refinable.sequence.step_count()
    }
}
