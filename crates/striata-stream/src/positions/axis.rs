//! Input of the models that code one coordinate of a new vertex.

use super::bumps::{Bumps, Width, below};
use super::local::LocalRing;
use crate::entropy::Coder;

/// Number of size classes.
pub(super) const SIZES: usize = 64;
/// Number of context classes.
pub(super) const CONTEXTS: usize = 16;
/// Number of distance classes.
pub(super) const DISTANCES: usize = 32;
/// Number of spread classes.
pub(super) const SPREADS: usize = 32;

/// Everything that a coordinate's model may use.
pub(super) struct AxisInput<'a, const KINDS: usize, const WIDTHS: usize> {
    /// The surroundings of the vertex.
    pub local: &'a LocalRing,
    /// Index of the axis.
    pub axis: usize,
    /// Density of each kind of guess.
    pub bumps: &'a [Bumps],
    /// Widths of the bumps.
    pub widths: [Width; WIDTHS],
    /// The expected grid coordinate.
    pub center: i32,
    /// Whether adaptive counters use this axis in reverse. The axis is reversed if needed so that for the
    /// counters the vertex that split (on the last axis: the outside) always lies in the positive direction.
    pub is_mirrored: bool,
    /// Whether this is the axis along the normal, on which little uncertainty remains.
    pub is_last: bool,
    /// Size class of the surroundings, below [`SIZES`].
    pub size: usize,
    /// Class of valence and recent errors, below [`CONTEXTS`].
    pub context: usize,
    /// Class of the distance between the vertex that split and the expected position, below [`DISTANCES`].
    pub distance: usize,
    /// Class of how much the guesses disagree, below [`SPREADS`].
    pub spread: usize,
}

/// Mass of each density, by kind of guess and width.
pub(super) type Masses<const KINDS: usize, const WIDTHS: usize> = [[i32; WIDTHS]; KINDS];

impl<const KINDS: usize, const WIDTHS: usize> AxisInput<'_, KINDS, WIDTHS> {
    /// Returns the total mass of each density.
    #[inline]
    pub(super) fn all(&self) -> Masses<KINDS, WIDTHS> {
        let weigh =
            |bumps: &[Bumps]| bumps.iter().flat_map(|bumps| bumps.weight).map(|w| i32::from(w) << 13).sum();
        if KINDS == 1 {
            [[weigh(self.bumps); WIDTHS]; KINDS]
        } else {
            std::array::from_fn(|kind| [weigh(&self.bumps[kind..=kind]); WIDTHS])
        }
    }

    /// Returns the mass of each density below a coordinate, given relative to the center.
    #[inline]
    pub(super) fn below(&self, off: i32) -> Masses<KINDS, WIDTHS> {
        let x = self.local.border(self.center.wrapping_add(off), self.axis);
        let mut masses = [[0; WIDTHS]; KINDS];
        if KINDS == 1 {
            masses[0] = below(self.bumps, x, &self.widths);
        } else {
            for (masses, bumps) in masses.iter_mut().zip(self.bumps) {
                *masses = below(std::slice::from_ref(bumps), x, &self.widths);
            }
        }
        masses
    }
}

/// A model that codes one coordinate.
pub(super) trait AxisCoder<const DENSITIES: usize, const WIDTHS: usize> {
    /// Creates an untrained model.
    fn new() -> Self;

    /// Codes a grid coordinate.
    fn code<C: Coder>(&mut self, coder: &mut C, axis: &AxisInput<'_, DENSITIES, WIDTHS>, actual: i32) -> i32;
}
