//! Stop condition of the loop: the caller's target, in terms of the counts that the loop keeps.

use crate::simplify::options::{SimplifyOptions, StopReason, Target};

/// Size of the mesh before simplification.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counts {
    pub(super) triangles: usize,
    pub(super) vertices: usize,
    /// Number of positions that are not locked.
    pub(super) removable: usize,
}

/// The target in terms of counts and an error limit.
#[derive(Clone, Copy, Debug)]
pub(super) struct StopCriteria {
    triangles: usize,
    vertices: usize,
    /// Number of positions to remove.
    pub(super) removals: usize,
    base_triangles: usize,
    /// Largest error allowed, mesh units.
    pub(super) limit: f64,
    /// Reason to report if the error limit stops the loop.
    pub(super) at_limit: StopReason,
    /// Reason to report if no collapse is left.
    pub(super) at_base: StopReason,
    is_above_full: bool,
}

impl StopCriteria {
    pub(super) fn new(options: &SimplifyOptions, counts: Counts) -> Self {
        let limits = [options.tolerance, options.sequence.max_error];
        let mut criteria = Self {
            triangles: 0,
            vertices: 0,
            removals: usize::MAX,
            base_triangles: options.sequence.base_triangle_count,
            limit: limits.into_iter().flatten().fold(f64::INFINITY, f64::min),
            at_limit: StopReason::ErrorLimit,
            at_base: StopReason::BaseReached,
            is_above_full: false,
        };
        match options.target {
            Target::Triangles(n) => {
                criteria.triangles = n;
                criteria.is_above_full = n > counts.triangles;
            }
            Target::Vertices(n) => {
                criteria.vertices = n;
                criteria.is_above_full = n > counts.vertices;
            }
            Target::Detail(detail) => {
                let kept = (detail * counts.removable as f64).round() as usize;
                criteria.keep_splits(kept, counts);
            }
            Target::SplitCount(n) => {
                criteria.is_above_full = n > counts.removable;
                criteria.keep_splits(n, counts);
            }
            Target::Error(error) => {
                if error <= criteria.limit {
                    (criteria.limit, criteria.at_limit) = (error, StopReason::TargetReached);
                }
            }
        }
        criteria
    }

    fn keep_splits(&mut self, kept: usize, counts: Counts) {
        self.removals = counts.removable.saturating_sub(kept);
        if kept == 0 {
            // The number of removable positions is known only once none is left; the caller asked for
            // exactly that base mesh.
            (self.removals, self.at_base) = (usize::MAX, StopReason::TargetReached);
        }
    }

    /// Returns the reason to stop now, if there is one.
    pub(super) fn stop_reason(
        &self,
        triangles: usize,
        vertices: usize,
        removals: usize,
    ) -> Option<StopReason> {
        if self.is_above_full {
            return Some(StopReason::FullMesh);
        }
        if triangles <= self.triangles || vertices <= self.vertices || removals >= self.removals {
            return Some(StopReason::TargetReached);
        }
        (triangles <= self.base_triangles).then_some(self.at_base)
    }
}
