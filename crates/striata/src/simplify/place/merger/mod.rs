//! The loop: collapses the cheapest edge and updates the costs around it.

mod edge_evaluation;

use glam::DVec3;

use crate::mesh::{AttributeLayer, Welded};
use crate::simplify::collapse::collapse_choice::CollapseKind;
use crate::simplify::collapse::cost_evaluator::CostEvaluator;
use crate::simplify::collapse::costs::CostFunction;
use crate::simplify::collapse::heap::IndexedHeap;
use crate::simplify::collapse::relaxation_schedule::RelaxationSchedule;
use crate::simplify::options::{SeamRule, SequenceOptions, SimplifyError, StopReason};
use crate::simplify::scaled_space::ScaledSpace;
use crate::{Progress, ProgressFn};

use super::blend::Blender;
use super::neighborhood::PositionStar;
use super::quadratic_form::StarForm;

use super::seams::merge_wedges;

/// A third vertex follows a collapsed edge if that costs at most this many times as much as the next
/// collapse in the queue, or as the edge.
const THIRD_VERTEX_FACTOR: f32 = 8.0;

/// An edge collapse whose cost has been evaluated in full.
#[derive(Clone, Copy, Debug)]
struct EdgeChoice {
    other: u32,
    other_version: u32,
    /// Whether the other end is removed and this one kept.
    is_kept: bool,
    position: DVec3,
    kind: CollapseKind,
    /// Squared distance that a relaxed collapse leaves.
    distance_squared: f32,
}

/// Data about a position and its star.
#[derive(Clone, Copy, Debug, Default)]
struct StarData {
    form: StarForm,
    /// Incremented whenever the star changes.
    version: u32,
    border_count: u32,
}

/// Complete state of one simplification.
pub(super) struct Merger<'a> {
    welded: &'a Welded,
    pub space: ScaledSpace,
    positions: Vec<DVec3>,
    evaluator: CostEvaluator<'a>,
    seams: SeamRule,
    schedule: RelaxationSchedule<'a>,
    stars: Vec<StarData>,
    /// The choice of each position; `None` if its key is a lower bound.
    choices: Vec<Option<EdgeChoice>>,
    heap: IndexedHeap,
    neighborhood: PositionStar,
    other_neighborhood: PositionStar,
    costs: Vec<f32>,
    ring: Vec<u32>,
    /// Neighbors of the position removed last, each once.
    removed_ring: Vec<u32>,
    /// The removed position, the kept one and all that lost their last triangle with the last collapse.
    gone: Vec<u32>,
    pairs: Vec<(u32, u32)>,
    /// The vertex that each vertex was merged into, or itself.
    targets: Vec<u32>,
    layers: Vec<AttributeLayer>,
    blender: Blender,
    triangle_count: usize,
    removed: Vec<u32>,
    /// Number of positions removed so far.
    removed_count: usize,
    /// All merges, if a sequence will be built from them.
    log: Option<MergeLog>,
    /// Whether the third vertex of a triangle follows a collapsed edge.
    has_triangle_collapses: bool,
    thirds: Vec<u32>,
}

impl<'a> Merger<'a> {
    pub(super) fn new(welded: &'a Welded, options: &SequenceOptions) -> Self {
        let mesh = &welded.mesh;
        let space = ScaledSpace::of(mesh);
        let position_count = welded.positions.position_count();
        let position = |p| space.scaled(mesh.positions[welded.positions.first_vertex(p) as usize]);
        let positions: Vec<DVec3> = (0..position_count as u32).map(position).collect();
        let options =
            SequenceOptions { cost: CostFunction::Memoryless, pair_distance: None, ..options.clone() };
        let mut evaluator = CostEvaluator::new(welded, &options);
        evaluator.lock_boundary();
        Self {
            welded,
            space,
            evaluator,
            seams: options.seams,
            schedule: RelaxationSchedule::new(welded, options.topology),
            stars: vec![StarData::default(); position_count],
            choices: vec![None; position_count],
            heap: IndexedHeap::new(&[]),
            positions,
            neighborhood: PositionStar::default(),
            other_neighborhood: PositionStar::default(),
            costs: Vec::new(),
            ring: Vec::new(),
            removed_ring: Vec::new(),
            gone: Vec::new(),
            pairs: Vec::new(),
            targets: (0..mesh.vertex_count() as u32).collect(),
            layers: mesh.layers.clone(),
            blender: Blender::new(&mesh.layers),
            triangle_count: mesh.triangle_count(),
            removed: Vec::new(),
            removed_count: 0,
            log: None,
            has_triangle_collapses: false,
            thirds: Vec::new(),
        }
    }

    /// Records all merges; with `has_triangle_collapses`, triangles are collapsed instead of edges where
    /// that is possible.
    pub(super) fn with_log(self, has_triangle_collapses: bool) -> Self {
        let log = Some(MergeLog::new(&self.layers, self.welded.mesh.vertex_count()));
        Self { log, has_triangle_collapses, ..self }
    }

    /// Returns the recorded merges, and the wedge that each removed wedge was merged into.
    pub(super) fn into_log(self) -> (Option<MergeLog>, Vec<u32>) {
        (self.log, self.targets)
    }

    /// Collapses the cheapest edge until no more than `base_triangle_count` triangles are left, or no collapse is.
    pub(super) fn run(
        &mut self,
        base_triangle_count: usize,
        progress: &mut ProgressFn<'_>,
    ) -> Result<StopReason, SimplifyError> {
        if self.schedule.is_possible() && self.evaluator.wedges.is_some() {
            self.schedule.begin(&mut self.evaluator, (&self.removed, &self.targets));
        }
        let position_count = self.positions.len() as u32;
        (0..position_count).for_each(|v| self.update_star(v));
        let keys: Vec<f32> = (0..position_count).map(|v| self.provisional_cost(v)).collect();
        self.heap = IndexedHeap::new(&keys);
        drop(keys);
        let total = self.positions.len() as u64;
        while self.triangle_count > base_triangle_count
            && let Some((key, v)) = self.next()
        {
            let Some(choice) = self.choices[v as usize].filter(|choice| self.is_still_valid(v, choice))
            else {
                self.choices[v as usize] = None;
                self.decide(v, key);
                continue;
            };
            self.find_thirds(v, choice.other);
            self.collapse(v, choice);
            self.collapse_third(key);
            let done = self.removed_count as u64;
            if done.is_multiple_of(4096) {
                Progress { phase: "simplify", done, total }.report(progress)?;
            }
        }
        Ok(StopReason::BaseReached)
    }

    /// Returns the position with the smallest key, and that key; begins relaxed collapses if they had
    /// to wait for the last strict one.
    fn next(&mut self) -> Option<(f32, u32)> {
        if self.heap.first().is_none() && self.schedule.is_postponed() {
            self.schedule.begin(&mut self.evaluator, (&self.removed, &self.targets));
            for v in 0..self.positions.len() as u32 {
                self.choices[v as usize] = None;
                let bound = self.provisional_cost(v);
                self.heap.set(v, bound);
            }
        }
        self.heap.first()
    }

    fn is_still_valid(&mut self, v: u32, choice: &EdgeChoice) -> bool {
        let is_fresh = self.stars[choice.other as usize].version == choice.other_version;
        let (removed, kept) = if choice.is_kept { (choice.other, v) } else { (v, choice.other) };
        // Changes in links outside the two stars may have changed what is allowed.
        let CostEvaluator { legality, links, .. } = &mut self.evaluator;
        is_fresh
            && match choice.kind {
                CollapseKind::Strict => legality.allows(links, removed, kept),
                kind => self.evaluator.is_relaxed_choice_valid(removed, kept, kind, choice.distance_squared),
            }
    }

    /// Recomputes the star of `v` after a change. That of a hub, which no edge may be collapsed to, waits.
    fn update_star(&mut self, v: u32) {
        if self.evaluator.is_hub(v) {
            self.stars[v as usize].version += 1;
            self.choices[v as usize] = None;
            return;
        }
        self.gather(v);
        let star = &mut self.stars[v as usize];
        star.form = self.neighborhood.form();
        star.border_count = self.neighborhood.borders.len() as u32;
        star.version += 1;
        self.choices[v as usize] = None;
    }

    /// Applies a choice of `v` and updates the positions around it.
    fn collapse(&mut self, v: u32, choice: EdgeChoice) {
        let EdgeChoice { other, is_kept, position, kind, .. } = choice;
        let (removed, kept) = if is_kept { (other, v) } else { (v, other) };
        self.removed_ring.clear();
        self.removed_ring.extend_from_slice(self.evaluator.links.entries(removed));
        self.ring.clear();
        for p in [removed, kept] {
            self.ring.extend(self.evaluator.links.entries(p).iter().filter(|&&w| w != removed && w != kept));
        }
        for ring in [&mut self.ring, &mut self.removed_ring] {
            ring.sort_unstable();
            ring.dedup();
        }
        self.ring.push(kept);
        let share = self.edge_share(removed, kept, position);
        let old_position = self.positions[kept as usize];
        merge_wedges(&mut self.evaluator, removed, kept, &mut self.targets, &mut self.pairs);
        let count = |evaluator: &CostEvaluator<'_>, p| evaluator.links.triangle_count(p);
        let before = count(&self.evaluator, removed) + count(&self.evaluator, kept);
        self.evaluator.links.collapse(removed, kept);
        self.move_to(kept, position);
        // Each removed triangle was in both links.
        let removed_triangles = (before - count(&self.evaluator, kept)) / 2;
        self.note_changes(removed, kept, kind, removed_triangles);
        self.triangle_count -= removed_triangles;
        for &p in self.gone.iter().filter(|&&p| p != kept || self.evaluator.links.triangle_count(kept) == 0) {
            self.removed_count += 1;
            self.heap.remove(p);
        }
        self.removed.push(removed);
        self.pairs.iter().for_each(|&(from, to)| self.blender.blend(&mut self.layers, from, to, share));
        self.log_merge(removed, kept, position != old_position);
        self.update_ring();
    }

    fn log_merge(&mut self, removed: u32, kept: u32, is_moved: bool) {
        let Some(log) = &mut self.log else { return };
        let is_lost = self.evaluator.links.triangle_count(kept) == 0;
        let moved = is_moved.then(|| {
            let first_row = log.add_rows(&self.layers, self.welded.positions.wedges(kept));
            (self.space.unscaled(self.positions[kept as usize]), first_row)
        });
        let others = self.gone.iter().copied().filter(|&p| p != removed && (p != kept || is_lost));
        let lost = others.collect();
        log.merges.push(LoggedMerge { removed, kept, moved, lost, continues: false });
    }

    /// Finds the vertices that form a triangle with the edge from `v` to `other`, which is about to collapse.
    fn find_thirds(&mut self, v: u32, other: u32) {
        self.thirds.clear();
        if !self.has_triangle_collapses {
            return;
        }
        self.gather(v);
        let ring = &self.neighborhood.ring;
        for t in 0..ring.triangle_count() {
            let [a, b] = ring.triangle(t).map(|i| ring.ids[i]);
            self.thirds.extend((a == other).then_some(b).or((b == other).then_some(a)));
        }
    }

    /// Merges the cheaper of the found vertices with the one that the last collapse has kept, if it is not too
    /// expensive.
    fn collapse_third(&mut self, key: f32) {
        let Some(kept) = self.log.as_ref().and_then(|log| log.merges.last()).map(|merge| merge.kept) else {
            return;
        };
        if self.thirds.is_empty() || self.evaluator.links.triangle_count(kept) == 0 {
            return;
        }
        let limit = THIRD_VERTEX_FACTOR * self.heap.first().map_or(key, |(next, _)| next.max(key));
        self.gather(kept);
        self.fill_costs(kept);
        let mut best: Option<(f32, EdgeChoice)> = None;
        for i in 0..self.neighborhood.ring.ids.len() {
            if self.thirds.contains(&self.neighborhood.ring.ids[i]) && self.costs[i] < f32::INFINITY {
                let least = best.map_or(limit, |(cost, _)| cost);
                best = self.evaluate_edge(kept, i, least).filter(|found| found.0 < least).or(best);
            }
        }
        if let Some((_, choice)) = best {
            self.collapse(kept, choice);
            if let Some(merge) = self.log.as_mut().and_then(|log| log.merges.last_mut()) {
                merge.continues = true;
            }
        }
    }

    fn move_to(&mut self, p: u32, position: DVec3) {
        let place = self.plan_of(position);
        if position != self.positions[p as usize]
            && let Some(field) = &mut self.evaluator.height_field
        {
            field.move_to(p, place);
        }
        self.positions[p as usize] = position;
        let [x, y, z] = position.as_vec3().to_array();
        self.evaluator.positions[p as usize] = [x, y, z, 0.0];
    }

    /// Tells the evaluator about a collapse, and leaves the positions that are gone in `gone`.
    fn note_changes(&mut self, removed: u32, kept: u32, kind: CollapseKind, removed_triangles: usize) {
        let lost_positions =
            self.evaluator.note_collapse(removed, kept, removed_triangles, &self.removed_ring);
        self.gone.clear();
        self.gone.extend([removed, kept]);
        let mut is_plain = kind == CollapseKind::Strict;
        if let Some(lost_positions) = lost_positions {
            self.gone.extend(lost_positions.positions.iter().filter(|&&p| p != kept));
            is_plain &= lost_positions.positions.is_empty();
            self.evaluator.recycle(lost_positions);
        }
        if !is_plain {
            self.evaluator.mark_relaxed();
        }
    }

    fn update_ring(&mut self) {
        let ring = std::mem::take(&mut self.ring);
        ring.iter().for_each(|&w| self.update_star(w));
        for &w in &ring {
            let bound = self.provisional_cost(w);
            self.heap.set(w, bound);
        }
        self.ring = ring;
    }
}

/// One merge, in the numbering of the welded mesh.
#[derive(Clone, Debug)]
pub(super) struct LoggedMerge {
    /// Position that is removed, and the one that it is merged with.
    pub removed: u32,
    pub kept: u32,
    /// New place of the kept position, mesh units, and the first row with the attributes of its wedges;
    /// `None` if it stays.
    pub moved: Option<([f32; 3], u32)>,
    /// Other positions that lose their last triangle.
    pub lost: Vec<u32>,
    /// Whether the merge belongs to the same step as the one before it.
    pub continues: bool,
}

/// All merges, and the attributes of moved vertices.
#[derive(Clone, Debug)]
pub(super) struct MergeLog {
    pub merges: Vec<LoggedMerge>,
    /// Attributes: a row for each vertex of the welded mesh, then one for each wedge that moved, in order.
    pub rows: Vec<AttributeLayer>,
    pub row_count: u32,
}

impl MergeLog {
    fn new(layers: &[AttributeLayer], vertex_count: usize) -> Self {
        Self { merges: Vec::new(), rows: layers.to_vec(), row_count: vertex_count as u32 }
    }

    /// Adds the current attributes of some wedges as rows; returns the index of the first.
    fn add_rows(&mut self, layers: &[AttributeLayer], wedges: std::ops::Range<u32>) -> u32 {
        let first = self.row_count;
        self.row_count += wedges.len() as u32;
        for (rows, layer) in self.rows.iter_mut().zip(layers) {
            let n = layer.component_count as usize;
            let values = wedges.start as usize * n..wedges.end as usize * n;
            let is_one_type = rows.data.extend_from_range(&layer.data, values);
            debug_assert!(is_one_type, "rows were copied from the layers");
        }
        first
    }
}
