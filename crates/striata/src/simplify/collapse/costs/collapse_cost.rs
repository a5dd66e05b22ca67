//! The trait of all costs, and the memoryless cost, which consists of its defaults.

use std::fmt::Debug;

use crate::simplify::collapse::fan::point;
use crate::simplify::collapse::links::Links;
use crate::simplify::collapse::star::Star;

/// How the evaluator treats a cost.
#[derive(Clone, Copy, Debug)]
pub(in crate::simplify) struct CostRules {
    /// Share of distances from the current surface in the cost.
    pub surface_share: f32,
    /// Whether the distances of the new fan from the current surface count, in addition to the quadratic form.
    pub counts_fan: bool,
    /// Factor by which the full cost nearly always exceeds its quadratic part, at least. Scaling the bounds
    /// by 2 saves over a quarter of the time on the bunny, since fewer positions reach the top only to go
    /// back. A rare position whose full cost is less is collapsed late, by at most this factor in cost. Over
    /// five meshes, this raises the RMS error by 0.3 % down to 10 % of the triangles, and by 1.3 % at 2 %.
    pub bound_factor: f32,
    /// Whether nothing but the current surface counts, so that parts of a mesh can be simplified separately.
    pub is_local: bool,
    /// Whether a collapse also changes the costs of collapsing other positions to its target.
    pub target_grows: bool,
    /// Whether the star must have the indices of its triangles.
    pub follows_triangles: bool,
}

/// The rules of a cost that knows the current surface only.
pub(super) const LOCAL: CostRules = CostRules {
    surface_share: 1.0,
    counts_fan: true,
    bound_factor: 2.0,
    is_local: true,
    target_grows: false,
    follows_triangles: false,
};

/// A cost of half-edge collapses. The methods are called with a gathered star; the defaults are those of the
/// memoryless cost.
pub(in crate::simplify) trait CollapseCost: Debug + Send + Sync {
    /// How the evaluator treats this cost; never changes.
    fn rules(&self) -> CostRules {
        LOCAL
    }

    /// Prepares for a mesh on which nothing has been collapsed yet.
    fn begin(&mut self, _star: &mut Star, _links: &Links, _positions: &[[f32; 4]], _triangle_count: usize) {}

    /// Changes the costs in the star of `v`, which are those of its quadratic form: the lower bounds by which
    /// targets are tried.
    fn fill(&self, _star: &mut Star, _positions: &[[f32; 4]], _v: u32) {}

    /// Prepares for calls of [`Self::increase`] with the star of `v`.
    fn load(&mut self, _star: &Star, _positions: &[[f32; 4]], _v: u32) {}

    /// Added cost of collapsing `v` to neighbor `k` of its star; `own` is the squared distance of `v` from the
    /// fan.
    fn increase(&self, _star: &mut Star, _k: usize, _v: u32, _own: f32) -> f32 {
        0.0
    }

    /// Cost of contracting `v` with `u`, which is no neighbor, without that of the distance between them. The
    /// star of `v` moves away by a squared distance.
    fn contraction(&self, star: &Star, positions: &[[f32; 4]], [v, u]: [u32; 2], squared: f32) -> f32 {
        star.cost_at(point(positions, u) - point(positions, v)) + star.distance_cost(squared)
    }

    /// Merges `v` into `u`, whether or not they are neighbors.
    fn merge(&mut self, _v: u32, _u: u32) {}

    /// Collapses `v` to neighbor `k` of its star, which still shows the mesh before; returns the largest squared
    /// distance of a removed vertex if the cost knows it.
    fn collapse(&mut self, _star: &mut Star, _positions: &[[f32; 4]], _v: u32, _k: usize) -> Option<f32> {
        None
    }
}

/// Quadrics of the current mesh [LT98], [Hop99]: those of the star, without any history.
#[derive(Debug, Default)]
pub(super) struct Memoryless;

impl CollapseCost for Memoryless {}
