//! Codes positions with a mixture of guesses.
//!
//! The two most tangential axes are coded first. After each, the guesses that were near gain weight for the
//! next one. Before the last axis, all guesses are moved along the surface to the two known coordinates.

use super::blend::Blend;
use super::cells::CellModel;
use super::guesses::KINDS;
use super::position_density::{FEATURES, PositionDensity, normal_order};
use crate::entropy::Coder;
use crate::topology::neighborhood::Neighborhood;

/// Logarithm of half the width of the bumps, along the surface and across it, in local units.
const WIDTHS: [u32; 2] = [5, 4];

/// Error classes of a vertex whose errors are not known.
const UNKNOWN_ERRORS: [u8; 2] = [7; 2];

/// A position model that uses the guesses as a density.
#[derive(Clone, Debug)]
pub(super) struct MixedModel {
    density: PositionDensity,
    axes: [CellModel; 3],
    /// By direction (along or across the surface) and valence.
    blends: [[Blend<FEATURES>; 4]; 2],
    /// Error class of each vertex, along the surface and across it.
    pub errors: Vec<[u8; 2]>,
}

impl MixedModel {
    /// Creates an untrained model.
    pub(super) fn new() -> Self {
        Self {
            density: PositionDensity::new(),
            axes: std::array::from_fn(|_| CellModel::new()),
            blends: [[Blend::new(std::array::from_fn(|k| if k < KINDS { 10_000 } else { 0 })); 4]; 2],
            errors: Vec::new(),
        }
    }

    /// Codes the grid coordinates of a new vertex.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        neighborhood: &Neighborhood<'_>,
        actual: [i32; 3],
    ) -> [i32; 3] {
        self.density.gather(neighborhood);
        let (normal, axes) = normal_order(&self.density.local);
        let ring_errors = self.ring_errors();
        let valence = self.density.local.count.clamp(4, 7) - 4;
        let mut coords = [0; 3];
        let mut errors = [0u32; 2];
        for (slot, &a) in axes.iter().enumerate() {
            let across = slot / 2;
            self.density.move_bumps(slot, normal, axes, coords);
            let (base, features) = self.density.features(a);
            let blend = &mut self.blends[across][valence];
            let expected = base + blend.predict(&features);
            let axis = self.density.axis(
                a,
                WIDTHS[across],
                (expected, ring_errors[across] * 4 + valence),
                &features,
            );
            coords[a] = self.axes[slot].code(coder, &axis, actual[a]);
            let found = self.density.local.to_local_axis(coords[a], a);
            let error = (found - expected).clamp(-self.density.local.radius, self.density.local.radius);
            blend.learn(&features, error);
            errors[across] = errors[across].max(error.unsigned_abs());
            if slot < 2 {
                self.density.reweight(slot, found);
            }
        }
        self.note(neighborhood.vertex, errors);
        coords
    }

    /// Classifies how well the ring vertices could be predicted, along the surface and across it: 0 to 3.
    fn ring_errors(&self) -> [usize; 2] {
        let (mut sums, mut count) = ([0; 2], 0);
        for &id in &self.density.local.ids[..self.density.local.count] {
            if let Some(errors) = self.errors.get(id as usize) {
                sums[0] += usize::from(errors[0]);
                sums[1] += usize::from(errors[1]);
                count += 1;
            }
        }
        let class = |sum: usize, first: usize| (sum / count.max(1)).saturating_sub(first).min(3);
        [class(sums[0], 5), class(sums[1], 4)]
    }

    /// Reserves memory for a total number of vertices.
    pub(super) fn reserve(&mut self, vertex_count: usize) {
        self.errors.reserve_exact(vertex_count);
    }

    /// Adapts to a rebuilt surface. `old_of_new` contains the old index of each vertex, or
    /// [`NONE`](crate::topology::surface::NONE).
    pub(super) fn renumber(&mut self, old_of_new: &[u32]) {
        let errors = |&old: &u32| self.errors.get(old as usize).copied().unwrap_or(UNKNOWN_ERRORS);
        self.errors = old_of_new.iter().map(errors).collect();
    }

    /// Records the error classes of a vertex.
    fn note(&mut self, vertex: u32, errors: [u32; 2]) {
        self.errors.resize(vertex as usize, UNKNOWN_ERRORS);
        self.errors
            .push(errors.map(|error| (error * 1024 / self.density.local.radius as u32 + 1).ilog2() as u8));
    }
}
