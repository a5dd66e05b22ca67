//! The refinement loop of writer and reader: select the vertices that split, split them, and code the new
//! vertices.
//!
//! Both sides run the same generic code over a [`Coder`]. The writer passes a [`StreamSide`] that knows the
//! splits to come; the reader's source knows nothing. As long as models only use data that has already
//! been coded, the two sides cannot disagree.

use super::growth::GrowingMesh;
use super::models::PartModels;
use super::parameters::StreamParameters;
use super::parts::{Batch, RefinedLevel, StreamLimits, Stretch};
use super::source::StreamSide;
use super::walk::BatchWalk;
use crate::base::coder::code_base;
use crate::base::mesh::Base;
use crate::base::neighborhoods::BaseNeighborhoods;
use crate::connectivity::ConnectivityModel;
use crate::entropy::{Coder, Part};
use crate::format::error::StreamDefect;
use crate::format::grid::CorrectionModel;
use crate::general::GeneralBatches;
use crate::layers::attributes::{Attributes, BasePlace, WedgeOfVertex, actual_layers};
use crate::positions::PositionModel;
use crate::topology::surface::NONE;
use crate::wedges::model::WedgeModel;

/// Maximum number of splits whose connectivity is coded before their values; a reader outputs new vertices
/// only after a whole run.
const STRETCH: usize = 1024;

/// How a stretch of the stream ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CodingResult {
    /// Everything was coded.
    Complete,
    /// The data ended early. All vertices that are complete remain valid.
    OutOfData,
}

/// A surface under refinement, with all models.
#[derive(Clone, Debug)]
pub(crate) struct MeshRefiner {
    /// The mesh and surface refined so far.
    pub level: RefinedLevel,
    /// The adaptive models.
    pub models: PartModels,
    /// Progress within the current batch.
    pub batch: Batch,
    /// Limits that the stream must respect.
    pub limits: StreamLimits,
    /// The splits that are currently being coded.
    pub stretch: Stretch,
}

impl MeshRefiner {
    /// Codes the base mesh, including its counts, and starts the refinement from it.
    ///
    /// # Errors
    /// If the decoded data is not a valid base mesh.
    pub(crate) fn begin<C: Coder>(
        coder: &mut C,
        known: &Base,
        parameters: &StreamParameters,
        source: &mut impl StreamSide,
    ) -> Result<Self, StreamDefect> {
        let (mut base, order) = code_base(coder, known, parameters.base)?;
        if let Some(observer) = source.observer() {
            observer.order_base(&base, &order);
        }
        if coder.overran() {
            return Err(StreamDefect::NoBase);
        }
        if let Some(position) =
            base.grid_points.iter().position(|&grid_point| !parameters.grid.contains(grid_point))
        {
            return Err(StreamDefect::OffGrid { position });
        }
        let vertex_of_position = base.vertex_of_position()?;
        let mut surface = base.surface()?;
        let mut wedges = parameters.has_wedges().then(|| WedgeModel::new(parameters.vertex_count));
        match &mut wedges {
            Some(model) => {
                if let Some(observer) = source.observer() {
                    vertex_of_position.iter().for_each(|&vertex| observer.name_base(vertex));
                }
                let most = parameters.base.position_count.saturating_add(parameters.base.extra_wedges);
                let counts = (parameters.vertex_count.min(most), parameters.group_count);
                coder.part(Part::Wedges);
                base.code_wedges(coder, model, source.input(), (counts, &vertex_of_position));
            }
            None => base.use_one_vertex_per_position(),
        }
        let mut models = PartModels {
            connectivity: ConnectivityModel::new(&surface, parameters.effort),
            positions: PositionModel::new(parameters.effort),
            corrections: parameters.is_exact.then(CorrectionModel::new),
            wedges,
            attributes: Attributes::new(&parameters.layers, parameters.effort),
            general: parameters.has_general.then(|| GeneralBatches::new(base.grid_points.clone())),
        };
        let growth = GrowingMesh::of_base(&base, &mut surface, parameters.group_count);
        let mut level =
            RefinedLevel { surface, grid_points: base.surface_grid_points(), grid: parameters.grid, growth };
        base_values(coder, source, (&base, &vertex_of_position), (&mut level, &mut models));
        let limits = StreamLimits {
            max_patch: parameters.max_patch,
            visits_left: parameters.most_visits(),
            most_wedges: parameters.base.extra_wedges.into(),
        };
        let batch = Batch { walk: BatchWalk::default(), is_under_way: false, split_count: 0 };
        Ok(Self { level, models, batch, limits, stretch: Stretch::default() })
    }

    /// Codes the rest of the current batch or a part of it, at most `most` splits.
    pub(crate) fn stretch<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &mut impl StreamSide,
        most: usize,
    ) -> Result<CodingResult, StreamDefect> {
        if !self.batch.is_under_way {
            self.spend_visits(self.level.surface.vertex_count() as u64)?;
            if let Some(observer) = source.observer() {
                observer.begin_batch();
            }
            self.batch.is_under_way = true;
            if self.begin_general(coder, source)? {
                return self.continue_general(coder, source, most);
            }
            self.batch.walk.begin(&self.level.surface);
            self.models.connectivity.begin_batch(&self.level.surface);
            self.batch.split_count = 0;
        } else if self.models.general.as_ref().is_some_and(GeneralBatches::is_active) {
            return self.continue_general(coder, source, most);
        }
        coder.part(Part::Connectivity);
        self.code_splits(coder, source, most.min(STRETCH));
        if coder.overran() {
            return Ok(CodingResult::OutOfData);
        }
        self.batch.split_count += self.stretch.split_count();
        if !self.batch.is_under_way && self.batch.split_count == 0 {
            return Err(StreamDefect::EmptyBatch { batch: self.batch.walk.batch() });
        }
        let (first, mut start) = (self.level.surface.vertex_count() as u32, 0);
        let is_predicted = self.predict_ahead(first);
        self.split_all(source);
        if !is_predicted {
            self.prefetch(first);
        }
        for split in 0..self.stretch.split_count() {
            let vertex = first + split as u32;
            let Stretch { patches, ends, corners, .. } = &mut self.stretch;
            let end = ends[split] as usize;
            // The ring of the new vertex: A, its patch, B.
            let a = self.level.surface.corner_of(vertex);
            corners.clear();
            corners.push(a);
            corners.extend_from_slice(&patches[start..end]);
            corners.push(a + 4);
            start = end;
            if self.code_vertex(coder, source, vertex)? == CodingResult::OutOfData {
                return Ok(CodingResult::OutOfData);
            }
        }
        Ok(CodingResult::Complete)
    }

    /// Counts visits to vertices or triangles against the stream's limit.
    ///
    /// # Errors
    /// If the stream visits too many vertices for its number of splits.
    pub(crate) fn spend_visits(&mut self, visits: u64) -> Result<(), StreamDefect> {
        let batch_count = self.batch.walk.batch();
        let left = self.limits.visits_left.checked_sub(visits);
        self.limits.visits_left = left.ok_or(StreamDefect::TooManyBatches { batch_count })?;
        Ok(())
    }

    /// Applies the splits of the stretch to the surface.
    fn split_all(&mut self, source: &mut impl StreamSide) {
        let Self { level: RefinedLevel { surface, .. }, models, batch, stretch, .. } = self;
        for patch in stretch.patches() {
            let kept = surface.vertex(patch[0]);
            let vertex = surface.split(patch);
            let made = surface.triangle_count() as u32;
            for triangle in [made - 2, made - 1] {
                surface.set_mark(triangle, batch.walk.batch());
                // Not part of the mesh until the vertex's values are known.
                surface.set_label(triangle, NONE);
            }
            models.connectivity.split(surface, patch.len(), kept);
            batch.walk.record_split(kept);
            if let Some(observer) = source.observer() {
                observer.split_applied(vertex, kept);
            }
        }
    }

    /// Returns the attribute layers, if there are any.
    pub(crate) fn attributes(&self) -> Option<&Attributes> {
        self.models.attributes.as_ref()
    }

    /// Sets how many vertices in excess of one per position are allowed.
    pub(crate) fn limit_wedges(&mut self, most: u64) {
        self.limits.most_wedges = most;
    }

    /// Reserves memory for a number of further steps.
    pub(crate) fn reserve(&mut self, steps: usize) {
        self.level.reserve(steps);
        self.batch.walk.reserve(self.level.surface.vertex_count() + steps);
        self.models.reserve(&self.level.surface, steps);
    }

    /// Brings the list of triangles up to date.
    pub(crate) fn catch_up(&mut self) {
        self.level.growth.catch_up(&mut self.level.surface);
    }

    /// Number of splits that have been coded completely.
    pub(crate) fn split_count(&self) -> usize {
        self.level.growth.added.len()
    }

    /// Number of batches begun so far.
    pub(crate) fn batch(&self) -> u32 {
        self.batch.walk.batch()
    }

    /// Whether the current batch has vertices that have not been visited.
    pub(crate) fn is_in_batch(&self) -> bool {
        self.batch.is_under_way
    }
}

/// Codes the positions and attributes of the base mesh's vertices.
fn base_values<C: Coder>(
    coder: &mut C,
    source: &impl StreamSide,
    (base, vertex_of_position): (&Base, &[u32]),
    (level, models): (&mut RefinedLevel, &mut PartModels),
) {
    let neighborhoods = BaseNeighborhoods::new(base);
    for (position, &vertex) in vertex_of_position.iter().enumerate() {
        let grid_point = base.grid_points[position];
        coder.part(Part::Base);
        let exact = match &mut models.corrections {
            Some(model) => {
                let exact = source.input().map_or([0.0; 3], |input| input.exact(vertex));
                model.code(coder, &level.grid, grid_point, exact)
            }
            None => level.grid.position(grid_point),
        };
        let wedges = base.first_vertex[position]..base.first_vertex[position + 1];
        level.growth.positions.extend(wedges.clone().map(|_| exact));
        if let Some(attributes) = &mut models.attributes {
            for (wedge, new) in (0..).zip(wedges) {
                let actual = actual_layers(source.input(), |input| input.wedges(vertex).start + wedge);
                attributes.base_vertex(
                    coder,
                    BasePlace { neighborhoods: &neighborhoods, grid_point },
                    WedgeOfVertex { vertex: new, wedge },
                    actual,
                );
            }
        }
    }
}
