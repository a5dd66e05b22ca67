//! Builds the table in one pass over all triangles of all levels.

mod from_collapses;
mod from_fragments;
mod history;
mod tree;

use self::history::{FanHistory, PERMANENT};
use self::tree::Tree;
use super::crowns::{RingArc, crowns};
use super::table::{Creator, Fan, TableWriter};
use super::{Fans, MAX_ARCS};
use crate::mesh::{FragmentedMesh, IndexedMesh, LevelTable, RefinableMesh, Steps};
use crate::model::step_bounds::StepBounds;
use crate::model::step_vertices::StepVertices;
use crate::{Cancelled, Progress, ProgressFn, ignore_progress};

/// Number of steps or vertices between two calls of the progress callback.
const STEPS_PER_REPORT: usize = 1 << 12;

/// Source of a table of fans: a mesh in refinement order and the steps that simplify it.
#[derive(Clone, Copy, Debug)]
pub enum FanSource<'m> {
    /// Steps that are collapses.
    Collapses(&'m RefinableMesh),
    /// Removals of any kind, whose holes may be filled freely.
    Fragments(&'m FragmentedMesh),
}

impl<'m> From<&'m RefinableMesh> for FanSource<'m> {
    fn from(refinable: &'m RefinableMesh) -> Self {
        Self::Collapses(refinable)
    }
}

impl<'m> From<&'m FragmentedMesh> for FanSource<'m> {
    fn from(fragmented: &'m FragmentedMesh) -> Self {
        Self::Fragments(fragmented)
    }
}

impl<'m> From<&'m Steps> for FanSource<'m> {
    fn from(steps: &'m Steps) -> Self {
        match steps {
            Steps::Collapses(refinable) => Self::Collapses(refinable),
            Steps::Fragments(fragmented) => Self::Fragments(fragmented),
        }
    }
}

impl<'m> FanSource<'m> {
    /// The full mesh.
    pub fn mesh(self) -> &'m IndexedMesh {
        match self {
            Self::Collapses(refinable) => &refinable.mesh,
            Self::Fragments(fragmented) => &fragmented.mesh,
        }
    }

    /// Sizes and errors of the levels.
    pub fn levels(self) -> &'m LevelTable {
        match self {
            Self::Collapses(refinable) => refinable.sequence.levels(),
            Self::Fragments(fragmented) => fragmented.fragments.levels(),
        }
    }

    /// Returns the error of the surface while a step is not refined, in mesh units: that of the level for a
    /// collapse, that of the floor for a removal.
    ///
    /// # Panics
    /// If the step does not exist.
    pub fn step_error(self, step: usize) -> f32 {
        match self {
            Self::Collapses(refinable) => refinable.sequence.error_at(step),
            Self::Fragments(fragmented) => fragmented.fragments.floor_error(step as u32),
        }
    }
}

/// The steps that the bounds of a step enclose besides the step itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoundScope {
    /// Its descendants in a tree in which each step has one parent among the steps that it needs.
    #[default]
    Tree,
    /// All steps that depend on it, directly or not. The steps that a criterion wants are then a valid set by
    /// themselves, so each step can be evaluated alone, in any order. But bounds are wider: a view of the
    /// bunny has a third more triangles.
    Dependents,
}

/// Options for building [`Fans`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct FanOptions {
    /// The bounds of the steps, or `None` for a table that supports uniform levels and instances that are moved
    /// step by step, but no view criteria and no files. Default: [`BoundScope::Tree`].
    pub bounds: Option<BoundScope>,
}

impl Default for FanOptions {
    fn default() -> Self {
        Self { bounds: Some(BoundScope::Tree) }
    }
}

impl FanOptions {
    /// Sets [`FanOptions::bounds`].
    #[must_use]
    pub fn with_bounds(self, bounds: Option<BoundScope>) -> Self {
        Self { bounds, ..self }
    }
}

impl Fans {
    /// Builds the table of a mesh with collapses or with removals of any kind, including the bounds of its
    /// steps.
    ///
    /// # Panics
    /// If the mesh uses vertices that the steps do not have.
    pub fn build<'m>(source: impl Into<FanSource<'m>>) -> Self {
        Self::build_with(source, &FanOptions::default(), &mut ignore_progress)
            .expect("the default callback never cancels")
    }

    /// Builds the table without bounds, which takes less time; see [`FanOptions::bounds`].
    ///
    /// # Panics
    /// If the mesh uses vertices that the steps do not have.
    pub fn build_without_bounds<'m>(source: impl Into<FanSource<'m>>) -> Self {
        Self::build_with(source, &FanOptions::default().with_bounds(None), &mut ignore_progress)
            .expect("the default callback never cancels")
    }

    /// Builds the table and reports progress in steps; the callback can cancel.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels.
    ///
    /// # Panics
    /// If the mesh uses vertices that the steps do not have.
    pub fn build_with<'m>(
        source: impl Into<FanSource<'m>>,
        options: &FanOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Cancelled> {
        let source = source.into();
        let history = match source {
            FanSource::Collapses(refinable) => from_collapses::history(refinable, progress)?,
            FanSource::Fragments(fragmented) => from_fragments::history(fragmented),
        };
        let fans = Self::of_history(source, &history, progress)?;
        let Some(scope) = options.bounds else { return Ok(fans) };
        let bounds = StepBounds::of_fans(&fans, source, scope, progress)?;
        Ok(Self { bounds: Some(bounds), ..fans })
    }

    /// Builds the table without bounds.
    fn of_history(
        source: FanSource<'_>,
        history: &FanHistory,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Cancelled> {
        let (mesh, levels) = (source.mesh(), source.levels());
        let group_count = mesh.groups.len().max(1);
        let mut table = TableWriter::new(group_count > 1);
        let mut tree = Tree::of_history(history, levels);
        let (mut arcs, mut fans) = (Vec::new(), Vec::new());
        let vertex_count = history.vertex_count();
        for vertex in 0..vertex_count as u32 {
            if (vertex as usize).is_multiple_of(STEPS_PER_REPORT) {
                let (done, total) = ((vertex_count + vertex as usize) as u64, 2 * vertex_count as u64);
                Progress { phase: "fans", done, total }.report(progress)?;
            }
            fans.clear();
            let mut entry = history.entry(vertex).to_vec();
            entry.sort_by_key(|&triangle| history.group(triangle));
            for of_group in entry.chunk_by(|&a, &b| history.group(a) == history.group(b)) {
                arcs.clear();
                arcs.extend(of_group.iter().map(|&triangle| history.arc(vertex, triangle)));
                push_crowns(&crowns(&mut arcs), history.group(of_group[0]), &mut fans);
            }
            let own_step = levels.step_of(vertex).map_or(0, |step| step + 1);
            tree.mark_children(own_step, &mut fans);
            table.push(own_step, &fans);
        }
        Ok(Self {
            vertices: StepVertices::of_levels(levels),
            step_count: levels.step_count(),
            group_count,
            table: table.finish(),
            waits: history.waits.clone(),
            far: history.far.clone(),
            orphans: tree.orphans(),
            added: history.added_counts(levels),
            bounds: None,
            quick: Default::default(),
        })
    }
}

/// Appends the fans of crowns, cutting those with more than [`MAX_ARCS`] arcs.
fn push_crowns(crowns: &[Vec<RingArc>], group: u32, fans: &mut Vec<Fan>) {
    for crown in crowns {
        let pieces = crown.chunks(MAX_ARCS);
        fans.extend(pieces.map(|piece| fan_of(piece, crown.len() == piece.len(), group)));
    }
}

/// Makes a fan of consecutive arcs; `is_whole` is set if they are an entire crown, which may then be closed.
fn fan_of(arcs: &[RingArc], is_whole: bool, group: u32) -> Fan {
    let mut fan = Fan { group, arc_count: arcs.len(), ..Fan::default() };
    fan.nodes.extend(arcs.iter().map(|arc| arc.from));
    let (first, last) = (arcs[0], arcs[arcs.len() - 1]);
    if !(is_whole && last.to == first.from) {
        fan.nodes.push(last.to);
    }
    for (at, arc) in arcs.iter().enumerate() {
        let bit = 1 << at;
        if arc.creator == PERMANENT {
            fan.permanent |= bit;
        } else if let Some(creator) = fan.creators.iter_mut().find(|c| c.step == arc.creator) {
            creator.mask |= bit;
        } else {
            fan.creators.push(Creator { step: arc.creator, mask: bit, is_child: false });
        }
    }
    fan
}
