//! One instance of a model, which moves from level to level.

use std::collections::BTreeSet;

use striata::mesh::Steps;
use striata::model::{
    CriterionCondition, DrawCounts, FanForm, FanFront, FanIndices, FanInstance, FanScene, Fans, LodModel,
    LodStripsState, ModelKind, MtsState, Overlap, PatternInstance, PatternScene, StripBuffer, StripModel,
    fan_triangles_into,
};
use striata::strip::{RESTART, restart_triangles_into};
use striata::view::ScreenError;
use striata_strip::{LiveStripBuffer, LiveStrips};

use super::models::{InspectedModels, Kind, size};
use super::surface::{InspectedLevel, NumberedTriangles};
use crate::Failure;

/// The level or view that an instance is to show.
#[derive(Clone, Debug)]
pub(super) enum InspectedTarget {
    /// A uniform level.
    Splits(usize),
    /// A view, within a number of triangles.
    View(ScreenError, usize),
}

/// The state of one model.
#[derive(Debug)]
pub(super) enum ModelInstance {
    List(Option<usize>),
    LodStrips(LodStripsState, StripBuffer),
    LiveStrips(Box<(LiveStrips<'static>, LiveStripBuffer)>),
    Mts(MtsState),
    Fans(Box<(FanFront<ScreenError>, FanInstance)>),
    Patterns(Box<PatternInstance>),
}

impl ModelInstance {
    /// Makes an instance, and its model if it is missing.
    pub(super) fn new(kind: Kind, models: &InspectedModels, steps: &Steps) -> Result<Self, Failure> {
        Ok(match kind {
            Kind::List => Self::List(None),
            Kind::LiveStrips => {
                let mut live = models.live_strips(steps)?;
                let buffer = LiveStripBuffer::new(&mut live);
                Self::LiveStrips(Box::new((live, buffer)))
            }
            Kind::Model(ModelKind::LodStrips) => {
                let model = models.lod_strips(steps)?;
                let mut state = model.new_state();
                let buffer = StripBuffer::new(model, &mut state);
                Self::LodStrips(state, buffer)
            }
            Kind::Model(ModelKind::Mts) => Self::Mts(models.mts(steps)?.new_state()),
            Kind::Model(ModelKind::Fans) => {
                let front = FanFront::new(&FanScene::new(models.fans(steps), &steps.mesh().positions));
                let shown = front.instance().clone();
                Self::Fans(Box::new((front, shown)))
            }
            Kind::Model(ModelKind::Patterns) => {
                Self::Patterns(Box::new(PatternInstance::base(models.patterns(steps)?)))
            }
            Kind::Model(kind) => return Err(Failure::unsupported(format!("{} is not drawn", kind.as_str()))),
        })
    }

    /// The fans that are shown, if these are fans.
    pub(super) fn fans(&self) -> Option<&FanInstance> {
        match self {
            Self::Fans(fans) => Some(&fans.1),
            _ => None,
        }
    }

    /// Moves to a level and draws it. InspectedModels without views show the finest uniform level within the triangles of a
    /// view, and that for its error otherwise.
    pub(super) fn show(
        &mut self,
        models: &InspectedModels,
        steps: &Steps,
        request: InspectedTarget,
    ) -> Result<InspectedLevel, Failure> {
        let uniform = |request| match request {
            InspectedTarget::Splits(splits) => splits,
            InspectedTarget::View(_, limit) => steps.levels().split_count_for_triangles(limit),
        };
        Ok(match self {
            Self::List(before) => {
                let splits = uniform(request);
                let surface = NumberedTriangles::of_list(steps.level(splits).triangles);
                let indices = 3 * surface.triangles.len();
                let changed = if before.replace(splits) == Some(splits) { 0 } else { indices };
                InspectedLevel {
                    index_count: indices,
                    changed_count: changed,
                    instance_bytes: 4 * indices,
                    ..of(steps, splits, surface)
                }
            }
            Self::LodStrips(state, buffer) => {
                let model = models.lod_strips(steps)?;
                let splits = uniform(request);
                model.move_to(state, splits);
                let changed_count = buffer.sync(model, state);
                let level = strips_of(model, state, of(steps, splits, NumberedTriangles::default()));
                InspectedLevel { changed_count, ..level }
            }
            Self::Mts(state) => {
                let model = models.mts(steps)?;
                let splits = uniform(request);
                let is_changed = model.split_count(state) != splits;
                model.move_to(state, splits);
                let level = strips_of(model, state, of(steps, splits, NumberedTriangles::default()));
                InspectedLevel { changed_count: if is_changed { level.index_count } else { 0 }, ..level }
            }
            Self::LiveStrips(live) => {
                let (live, buffer) = &mut **live;
                let splits = uniform(request);
                live.move_to(splits);
                buffer.sync(live);
                let changed = buffer.take_changed_ranges();
                let mut surface = NumberedTriangles::default();
                for range in buffer.strip_ranges() {
                    let strip = &buffer.indices()[range.start as usize..range.end as usize];
                    restart_triangles_into(strip, &mut surface.triangles);
                    // Strips have no numbers; the first vertex stays while the beginning does.
                    surface.number(strip.first().copied().unwrap_or(0));
                }
                InspectedLevel {
                    primitive_count: live.strip_count(),
                    index_count: buffer.live_index_count(),
                    changed_count: changed.iter().map(ExactSizeIterator::len).sum(),
                    instance_bytes: live.bytes(),
                    ..of(steps, splits, surface)
                }
            }
            Self::Fans(fans) => {
                let model = models.fans(steps);
                let (front, shown) = &mut **fans;
                let is_changed = match request {
                    InspectedTarget::Splits(splits) => replace(shown, FanInstance::uniform(model, splits)),
                    InspectedTarget::View(criterion, limit) => {
                        let scene = FanScene::new(model, &steps.mesh().positions);
                        let criterion = criterion.with_model_bounds(scene.sphere());
                        match limit {
                            usize::MAX => front.update(&scene, &criterion, usize::MAX),
                            _ => front.update_to_budget(&scene, &criterion, limit),
                        };
                        replace(shown, front.instance().clone())
                    }
                };
                let (surface, counts) = fans_of(model, shown);
                let splits = shown.split_count();
                InspectedLevel {
                    primitive_count: counts.strip_count,
                    index_count: counts.index_count,
                    changed_count: if is_changed { counts.index_count } else { 0 },
                    error: error_of(steps, |step| shown.is_refined(step)),
                    model_bytes: size(model),
                    instance_bytes: shown.bytes(),
                    ..of(steps, splits, surface)
                }
            }
            Self::Patterns(instance) => patterns_of(instance, models, steps, request)?,
        })
    }
}

/// A level with what all models have.
fn of(steps: &Steps, split_count: usize, surface: NumberedTriangles) -> InspectedLevel {
    let error = steps.levels().error_at(split_count);
    InspectedLevel { surface, split_count, error, ..InspectedLevel::default() }
}

/// Returns whether a value has changed.
fn replace<T: PartialEq>(before: &mut T, value: T) -> bool {
    let is_changed = *before != value;
    *before = value;
    is_changed
}

/// Error of the coarsest step that is not refined.
fn error_of(steps: &Steps, is_refined: impl Fn(u32) -> bool) -> f32 {
    let levels = steps.levels();
    let coarsest = (0..levels.step_count()).find(|&step| !is_refined(step as u32));
    coarsest.map_or(0.0, |step| levels.error_at(step))
}

fn strips_of<M: StripModel>(model: &M, state: &M::State, level: InspectedLevel) -> InspectedLevel {
    let mut surface = NumberedTriangles::default();
    for strip in 0..model.strip_count() {
        restart_triangles_into(model.strip(state, strip), &mut surface.triangles);
        surface.number(strip as u32);
    }
    let DrawCounts { strip_count, index_count } = model.draw_counts(state);
    InspectedLevel {
        surface,
        primitive_count: strip_count,
        index_count,
        model_bytes: size(model),
        instance_bytes: model.state_bytes(state),
        ..level
    }
}

/// Draws fans.
pub(super) fn fans_of(model: &Fans, instance: &FanInstance) -> (NumberedTriangles, DrawCounts) {
    let (mut surface, mut indices) = (NumberedTriangles::default(), FanIndices::default());
    instance.emit_into(model, FanForm::Fans, &mut indices);
    let fans = indices.indices.split(|&index| index == RESTART).filter(|fan| !fan.is_empty());
    for (number, fan) in (0..).zip(fans) {
        fan_triangles_into(fan, &mut surface.triangles);
        surface.number(number);
    }
    (surface, instance.draw_counts(model, FanForm::Fans))
}

fn patterns_of(
    instance: &mut PatternInstance,
    models: &InspectedModels,
    steps: &Steps,
    request: InspectedTarget,
) -> Result<InspectedLevel, Failure> {
    let patterns = models.patterns(steps)?;
    let change = match request {
        InspectedTarget::Splits(splits) => {
            instance.adapt(patterns, &|overlap: Overlap| (overlap.upper as usize) < splits)
        }
        InspectedTarget::View(criterion, usize::MAX) => {
            let scene = PatternScene::new(patterns, &steps.mesh().positions);
            instance.adapt(patterns, &CriterionCondition::new(scene, &criterion))
        }
        InspectedTarget::View(_, limit) => {
            let splits = steps.levels().split_count_for_triangles(limit);
            instance.adapt(patterns, &|overlap: Overlap| (overlap.upper as usize) < splits)
        }
    };
    let mut triangles = Vec::with_capacity(instance.triangle_count());
    instance.triangles_into(&mut triangles);
    let levels = steps.levels();
    // The base mesh is no fragment.
    let fragment_of = |&[a, b, c]: &[u32; 3]| levels.step_of(a.max(b).max(c)).map_or(0, |step| step + 1);
    let numbers: Vec<u32> = triangles.iter().map(fragment_of).collect();
    let fragments: BTreeSet<u32> = numbers.iter().copied().filter(|&number| number > 0).collect();
    let index_count = 3 * triangles.len();
    Ok(InspectedLevel {
        primitive_count: fragments.len(),
        index_count,
        changed_count: if change.inserted + change.removed > 0 { index_count } else { 0 },
        error: error_of(steps, |step| instance.is_refined(step)),
        model_bytes: size(patterns),
        instance_bytes: instance.bytes(),
        ..of(steps, instance.split_count(), NumberedTriangles { triangles, numbers })
    })
}
