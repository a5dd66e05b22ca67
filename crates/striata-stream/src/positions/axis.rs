//! What an axis of a new vertex is coded with.

use super::bumps::{Bumps, Width, below};
use super::local::Local;
use crate::entropy::Coder;

/// Kinds of sizes.
pub(super) const SIZES: usize = 64;
/// Kinds of circumstances.
pub(super) const PLACES: usize = 16;
/// Kinds of distances.
pub(super) const DISTANCES: usize = 32;
/// Kinds of disagreement.
pub(super) const SPREADS: usize = 32;

/// What an axis is coded with.
pub(super) struct Axis<'a, const KINDS: usize, const WIDTHS: usize> {
    /// The surroundings.
    pub(super) local: &'a Local,
    /// Which axis.
    pub(super) axis: usize,
    /// The density of each kind of guess.
    pub(super) bumps: &'a [Bumps],
    /// How far bumps reach.
    pub(super) widths: [Width; WIDTHS],
    /// The grid coordinate that is expected.
    pub(super) center: i32,
    /// True where counters see the axis from its other end: the vertex that split, or the outside, is upwards for them.
    pub(super) is_mirrored: bool,
    /// True for the axis along the normal, where little is left open.
    pub(super) is_last: bool,
    /// Which size the surroundings have, below [`SIZES`].
    pub(super) size: usize,
    /// What they are like, below [`PLACES`].
    pub(super) place: usize,
    /// How far the vertex that split is from what is expected, below [`DISTANCES`].
    pub(super) distance: usize,
    /// How much the guesses disagree, below [`SPREADS`].
    pub(super) spread: usize,
}

/// How much each density comes to, by kind and width.
pub(super) type Masses<const KINDS: usize, const WIDTHS: usize> = [[i32; WIDTHS]; KINDS];

impl<const KINDS: usize, const WIDTHS: usize> Axis<'_, KINDS, WIDTHS> {
    /// How much each density comes to.
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

    /// How much of each density lies below a coordinate `off` from the center.
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

/// What codes a coordinate from what is known of it.
pub(super) trait AxisCoder<const DENSITIES: usize, const WIDTHS: usize> {
    /// Nothing learned.
    fn new(is_thorough: bool) -> Self;

    /// Codes a grid coordinate.
    fn code<C: Coder>(&mut self, coder: &mut C, axis: &Axis<'_, DENSITIES, WIDTHS>, actual: i32) -> i32;
}
