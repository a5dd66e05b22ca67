//! Input of the model that codes one coordinate of a new vertex.

use super::bumps::{Bumps, Width};
use super::local::LocalRing;

/// Number of size classes.
pub(super) const SIZES: usize = 64;
/// Number of context classes.
pub(super) const CONTEXTS: usize = 16;
/// Number of distance classes.
pub(super) const DISTANCES: usize = 32;
/// Number of spread classes.
pub(super) const SPREADS: usize = 32;

/// Everything that a coordinate's model may use.
pub(super) struct AxisInput<'a> {
    /// The surroundings of the vertex.
    pub local: &'a LocalRing,
    /// Index of the axis.
    pub axis: usize,
    /// Density of each kind of guess.
    pub bumps: &'a [Bumps],
    /// Width of the bumps.
    pub width: Width,
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
