//! Simplifies a large mesh in memory in cells, many at a time, into one sequence.
//!
//! Each level divides what is left into cells of about [`CELL_TRIANGLES`] triangles and simplifies each cell to half of
//! them; the next level has other cells of the same size. Cells stop before the topology changes, and the last level,
//! one part, does the rest with all rules. Steps are merged by the keys of
//! [`PartOrder`](crate::simplify::collapse::part_order::PartOrder), and errors by their order. Cells do not depend on
//! the number of threads, so the sequence does not either.
//!
//! In contrast to [`build_in_cells`](super::build_in_cells), which suits meshes of any size, nothing is welded or copied
//! twice, and the removed vertices that measure errors go from level to level: errors are as good as those of one queue.

mod part;
mod routed;
mod surface;

use self::part::{PartResult, simplify_part, simplify_rest};
use self::routed::RoutedLevel;
use self::surface::{DividedSurface, NONE};
use crate::mesh::Welded;
use crate::parallel::map;
use crate::simplify::collapse::cost_evaluator::has_large_parts;
use crate::simplify::collapse::refinement_order::CollapseRecord;
use crate::simplify::{BoundaryRule, SequenceOptions, SimplifyError, StopReason};
use crate::{Progress, ProgressFn};

/// Largest number of triangles of a cell. Smaller cells are quicker, but worse by up to 1.7 % in RMS.
pub(in crate::simplify) const CELL_TRIANGLES: usize = 1 << 15;
/// Meshes with fewer triangles are simplified as a whole: the last level would be too large a share.
const MIN_TRIANGLES: usize = 250_000;
/// Connected parts must have this many triangles on average, because cells let no part vanish.
const MIN_PART_TRIANGLES: usize = 1000;
/// Number of cells between two progress reports.
const CELLS_PER_REPORT: usize = 64;
/// A level must remove this share of the triangles; if it does not, the next one is the last.
const MIN_REMOVED_SHARE: f64 = 0.1;

/// Whether a mesh is simplified in cells.
pub(in crate::simplify) fn is_worth_dividing(welded: &Welded, options: &SequenceOptions) -> bool {
    let mesh = &welded.mesh;
    mesh.triangle_count() >= MIN_TRIANGLES
        && options.base_triangle_count < mesh.triangle_count()
        && welded.positions.is_identity()
        && options.cost.create().rules().is_local
        && options.pair_distance.is_none_or(|distance| distance <= 0.0)
        && options.group_borders != BoundaryRule::Locked
        && has_large_parts(welded, MIN_PART_TRIANGLES)
}

/// Steps of all parts, in the order of levels and parts.
#[derive(Default)]
struct MergedSteps {
    record: CollapseRecord,
    keys: Vec<f32>,
    triangle_count: usize,
}

/// Simplifies a mesh in cells of at most `cell_triangles`. Each of its positions must have one vertex.
pub(in crate::simplify) fn simplify_in_cells(
    welded: &Welded,
    options: &SequenceOptions,
    cell_triangles: usize,
    progress: &mut ProgressFn<'_>,
) -> Result<(CollapseRecord, StopReason), SimplifyError> {
    let mut surface = DividedSurface::new(welded, options);
    let mut steps = MergedSteps { triangle_count: welded.mesh.triangle_count(), ..MergedSteps::default() };
    steps.record.targets = vec![0; welded.mesh.vertex_count()];
    let total = welded.positions.position_count() as u64;
    // At the end of a level, other cells may still have steps with smaller keys.
    let wanted = options.base_triangle_count / 2;
    let mut stop_reason = StopReason::TargetReached;
    for number in 0.. {
        let before = surface.triangles.len();
        if before <= wanted {
            break;
        }
        let routed = RoutedLevel::new(&surface, number, cell_triangles);
        let mut rest = routed.onward(&surface);
        let mut outside = Vec::new();
        for first in (0..routed.cell_count()).step_by(CELLS_PER_REPORT) {
            let cells = first..routed.cell_count().min(first + CELLS_PER_REPORT);
            let results = map(cells, |cell| simplify_part(&surface, options, (&routed, cell)));
            for result in results {
                let mut result = result?;
                outside.append(&mut result.witnesses_outside);
                surface.apply(result, &mut steps, &mut rest);
            }
            Progress { phase: "simplify", done: steps.keys.len() as u64, total }.report(progress)?;
        }
        surface.triangles = rest;
        surface.add_witnesses(outside, &steps.record.targets);
        let removed = before - surface.triangles.len();
        let is_stuck = (removed as f64) < MIN_REMOVED_SHARE * before as f64;
        if is_stuck || surface.triangles.len() <= 2 * cell_triangles {
            break;
        }
    }
    if surface.triangles.len() > wanted {
        let done = steps.keys.len() as u64;
        let mut after = |p: Progress| progress(Progress { done: done + p.done, total, ..p });
        let worst = steps.record.errors.iter().copied().fold(0.0, f32::max);
        let last = simplify_rest(&surface, options, (wanted, worst), &mut after)?;
        stop_reason = last.stop_reason;
        surface.apply(last, &mut steps, &mut Vec::new());
    }
    Ok(steps.merge(options, stop_reason))
}

impl DividedSurface<'_> {
    /// Takes over the result of a part; its triangles are appended to `rest`.
    fn apply(&mut self, part: PartResult, steps: &mut MergedSteps, rest: &mut Vec<[u32; 3]>) {
        for (&v, target) in part.removed.iter().zip(part.targets) {
            self.is_removed[v as usize] = true;
            self.witnesses[v as usize] = (NONE, 0.0);
            steps.record.targets[v as usize] = target;
        }
        for (p, latest, witness) in part.states {
            self.latest[p as usize] = latest;
            self.witnesses[p as usize] = witness;
        }
        rest.extend(part.triangles);
        steps.record.removed.extend(part.removed);
        steps.record.errors.extend(part.errors);
        steps.record.removed_triangle_counts.extend(part.removed_triangle_counts);
        steps.keys.extend(part.keys);
    }
}

impl MergedSteps {
    /// Sorts the steps by key, and drops those after the limits of the options.
    fn merge(self, options: &SequenceOptions, last: StopReason) -> (CollapseRecord, StopReason) {
        let Self { record, keys, mut triangle_count } = self;
        // Keys are never negative, so their bits have the same order.
        let mut order: Vec<u64> =
            (0..).zip(&keys).map(|(i, key)| u64::from(key.to_bits()) << 32 | i).collect();
        sort(&mut order);
        let mut merged = CollapseRecord { targets: record.targets, ..CollapseRecord::default() };
        merged.removed.reserve(order.len());
        let limit = options.max_error.unwrap_or(f64::INFINITY);
        let mut error = 0.0f32;
        let mut stop_reason = None;
        for i in order.into_iter().map(|item| item as u32 as usize) {
            let count = record.removed_triangle_counts[i];
            if triangle_count <= options.base_triangle_count && count > 0 {
                break;
            }
            error = error.max(record.errors[i]);
            if f64::from(error) > limit {
                stop_reason = Some(StopReason::ErrorLimit);
                break;
            }
            triangle_count -= usize::from(count);
            merged.removed.push(record.removed[i]);
            merged.errors.push(error);
            merged.removed_triangle_counts.push(count);
        }
        let is_met = triangle_count <= options.base_triangle_count;
        let ended = if is_met { StopReason::TargetReached } else { last };
        (merged, stop_reason.unwrap_or(ended))
    }
}

/// Sorts different numbers, on several threads if enabled.
fn sort(numbers: &mut [u64]) {
    #[cfg(feature = "parallel")]
    rayon::slice::ParallelSliceMut::par_sort_unstable(numbers);
    #[cfg(not(feature = "parallel"))]
    numbers.sort_unstable();
}

#[cfg(test)]
mod tests;
