//! Levels of a `.striata` file, from any of its models.

use super::{FoundLevel, Levels, LevelsFacts, PatternLevels, fan_level};
use crate::file::{DecodeError, SectionKind, StriataFile};
use crate::mesh::{Bounds, IndexedMesh, LevelTable, RefinableMesh, replay};
use crate::model::{
    Fans, FansLevel, LodModel, LodStrips, LodStripsState, ModelKind, Mts, MtsState, Patterns, PatternsState,
    StoredModel, StripModel,
};
use crate::simplify::Target;
use crate::strip::StripSet;
use crate::view::{DetailBox, ScreenError};

/// Levels of a `.striata` file.
///
/// Uniform levels come from the collapses in the file, or from one of its models if that is named, if there are no
/// collapses, or if strips are asked for. Views come from fans or patterns, and boxes from patterns; these are built
/// from the steps if the file lacks them.
#[derive(Debug)]
pub struct FileLevels<'a> {
    file: StriataFile<'a>,
    named: Option<ModelKind>,
    table: LevelTable,
    facts: LevelsFacts,
    model: Option<MovingModel<'a>>,
    keeps_strips: bool,
    strips: Option<StripSet>,
}

/// A model and one instance of it.
#[derive(Debug)]
struct Moving<M, S> {
    model: M,
    state: S,
}

/// The source of uniform levels.
#[derive(Debug)]
enum MovingModel<'a> {
    /// The collapses. Reading them takes a fraction of the time that it takes to check the records of a model.
    Collapses(Box<RefinableMesh>),
    LodStrips(Box<Moving<LodStrips<'a>, LodStripsState>>),
    Mts(Box<Moving<Mts<'a>, MtsState>>),
    Fans(Box<Moving<Fans, FansLevel>>),
    Patterns(Box<Moving<Patterns, PatternsState>>),
    /// A file that has nothing but a stream.
    Stream,
}

impl<'a> FileLevels<'a> {
    /// Uses the named model; else the collapses of the file or the first model that it has, and for views fans or
    /// patterns.
    ///
    /// # Errors
    /// [`DecodeError`] if the table of levels is damaged.
    pub fn new(file: StriataFile<'a>, named: Option<ModelKind>) -> Result<Self, DecodeError> {
        let table = file.levels()?;
        let summary = file.summary();
        let facts = LevelsFacts {
            vertex_count: summary.vertex_count,
            triangle_count: summary.triangle_count,
            step_count: table.step_count(),
            has_guaranteed_errors: file.has_guaranteed_errors()?,
            origin: file.origin()?,
        };
        Ok(Self { file, named, table, facts, model: None, keeps_strips: false, strips: None })
    }

    /// Keeps the strips of each uniform level, for [`strips`](Self::strips).
    #[must_use]
    pub fn keeping_strips(self) -> Self {
        Self { keeps_strips: true, ..self }
    }

    /// The file.
    pub fn file(&self) -> &StriataFile<'a> {
        &self.file
    }

    /// The kind of the model that uniform levels come from; [`None`] if the file does not have it.
    pub fn kind(&self) -> Option<ModelKind> {
        let is_wanted = |kind| self.named.is_none_or(|named| named == kind);
        ModelKind::ALL.into_iter().find(|&kind| is_wanted(kind) && self.file.has_model(kind))
    }

    /// The kind of the model that views come from: the named one, or patterns if the file has them but no fans.
    pub fn kind_of_views(&self) -> ModelKind {
        let has_patterns_only =
            self.file.has_model(ModelKind::Patterns) && !self.file.has_model(ModelKind::Fans);
        match self.named {
            Some(kind) => kind,
            None if has_patterns_only => ModelKind::Patterns,
            None => ModelKind::Fans,
        }
    }

    /// The strips of the last uniform level, if they were to be kept and its model has strips.
    pub fn strips(&self) -> Option<&StripSet> {
        self.strips.as_ref()
    }

    fn patterns(&self) -> Result<PatternLevels, DecodeError> {
        if let Some(stored) = self.file.patterns() {
            return Ok(PatternLevels::new(stored?, self.file.mesh()?));
        }
        let fragmented = self.file.fragmented_mesh()?;
        let built = Patterns::build(&fragmented);
        let built = built.map_err(|reason| DecodeError::Model { model: ModelKind::Patterns, reason });
        Ok(PatternLevels::new(built?, fragmented.mesh))
    }

    /// Reads the model of uniform levels.
    fn read_model(&self) -> Result<MovingModel<'a>, DecodeError> {
        let file = &self.file;
        if self.named.is_none() && !self.keeps_strips && !file.is_stream_only() && file.has_collapses() {
            return Ok(MovingModel::Collapses(Box::new(file.refinable_mesh()?)));
        }
        Ok(match self.kind() {
            Some(ModelKind::LodStrips) => started(file.lod_strips(), MovingModel::LodStrips)?,
            Some(ModelKind::Mts) => started(file.mts(), MovingModel::Mts)?,
            Some(ModelKind::Fans) => started(file.fans(), MovingModel::Fans)?,
            Some(ModelKind::Patterns) => started(file.patterns(), MovingModel::Patterns)?,
            _ if file.is_stream_only() => MovingModel::Stream,
            _ => return Err(missing()),
        })
    }

    /// Moves a model and returns its level, with its strips if they are kept.
    fn moved<M: StoredModel>(
        &self,
        Moving { model, state }: &mut Moving<M, M::State>,
        split_count: usize,
        strips: impl Fn(&M, &M::State) -> Option<StripSet>,
    ) -> Result<(IndexedMesh, Option<StripSet>), DecodeError> {
        if split_count > model.split_count(state) {
            // The order of the triangles would depend on the level before.
            *state = model.new_state();
        }
        model.move_to(state, split_count);
        let mesh = self.file.level_of(&*model, state)?;
        let strips = strips(&*model, state).filter(|_| self.keeps_strips);
        Ok((mesh.without_unused_vertices(), strips.and_then(|strips| strips.on_used_vertices(&mesh))))
    }
}

/// Returns a model with an instance at full detail.
fn started<'a, M: LodModel>(
    model: Option<Result<M, DecodeError>>,
    wrap: impl Fn(Box<Moving<M, M::State>>) -> MovingModel<'a>,
) -> Result<MovingModel<'a>, DecodeError> {
    let model = model.ok_or_else(missing)??;
    let state = model.new_state();
    Ok(wrap(Box::new(Moving { model, state })))
}

fn missing() -> DecodeError {
    DecodeError::SectionCount { kind: SectionKind::STRIP_INDICES, found: 0 }
}

impl Levels for FileLevels<'_> {
    type Shape = IndexedMesh;
    type Error = DecodeError;

    fn facts(&self) -> LevelsFacts {
        self.facts
    }

    fn bounds(&mut self) -> Result<Option<Bounds>, DecodeError> {
        match self.file.summary().bounds {
            Some(bounds) => Ok(Some(bounds)),
            None => Ok(self.file.mesh()?.bounds()),
        }
    }

    fn find(&mut self, target: Target) -> Result<FoundLevel<IndexedMesh>, DecodeError> {
        let (split_count, stop_reason) = target.resolve_in(&self.table);
        let mut model = match self.model.take() {
            Some(model) => model,
            None => self.read_model()?,
        };
        let (mesh, strips) = match &mut model {
            MovingModel::Collapses(refinable) => {
                Ok((replay(refinable, split_count).without_unused_vertices(), None))
            }
            MovingModel::LodStrips(moving) => {
                self.moved(moving, split_count, |model, state| Some(model.strips_at(state)))
            }
            MovingModel::Mts(moving) => {
                self.moved(moving, split_count, |model, state| Some(model.strips_at(state)))
            }
            MovingModel::Fans(moving) => self.moved(moving, split_count, |_, _| None),
            MovingModel::Patterns(moving) => self.moved(moving, split_count, |_, _| None),
            MovingModel::Stream => {
                self.file.level(split_count).map(|level| (level.without_unused_vertices(), None))
            }
        }?;
        (self.model, self.strips) = (Some(model), strips);
        Ok(FoundLevel::of_mesh(mesh, split_count, self.table.error_at(split_count), stop_reason))
    }

    fn find_for_view(
        &mut self,
        criterion: &ScreenError,
        triangle_limit: Option<usize>,
    ) -> Result<FoundLevel<IndexedMesh>, DecodeError> {
        if self.kind_of_views() == ModelKind::Patterns {
            return Ok(self.patterns()?.view(criterion, triangle_limit));
        }
        let steps = self.file.steps()?;
        let fans = self.file.fans().unwrap_or_else(|| Ok(Fans::build(&steps)))?;
        Ok(fan_level(&fans, &steps, criterion, triangle_limit))
    }

    fn find_for_box(
        &mut self,
        detail_box: &DetailBox,
        triangle_limit: Option<usize>,
    ) -> Result<Option<FoundLevel<IndexedMesh>>, DecodeError> {
        Ok(Some(self.patterns()?.detail_box(detail_box, triangle_limit)))
    }
}
