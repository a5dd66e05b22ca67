//! The interface between models and refinement criteria: which parts of a surface should be refined?
//!
//! A model describes its surface as parts: a step together with all steps that depend on it, given by a
//! bounding sphere, a cone of normals and an error. A criterion knows the view. It assigns each part a
//! weight, and parts with a weight above 1 are refined. Parts are nested, and a part must weigh at least as
//! much as the parts inside it; otherwise, models would have to look below every part that they leave coarse.

use super::{NormalCone, Sphere};

/// A part of a surface that a model can leave coarse or refine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Contains everything that changes when the part is refined.
    pub sphere: Sphere,
    /// Contains the normals of all triangles that refining the part adds or removes.
    pub cone: NormalCone,
    /// Maximum distance to the original surface while the part is not refined, in mesh units.
    pub error: f32,
}

/// A criterion's decision about a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// Ratio of the part's error to the error allowed; the part is refined above 1. It is 0 if the part is
    /// invisible.
    pub weight: f32,
    /// Safety margin: the decision stays the same until the view has moved by more than this, as measured
    /// by [`Criterion::motion_since`]. Never negative.
    pub motion_margin: f32,
}

impl Verdict {
    /// A decision that has to be evaluated again whenever anything moves.
    pub fn now(weight: f32) -> Self {
        Self { weight, motion_margin: 0.0 }
    }

    /// Returns the decision to refine a part if this decision or another one is to refine it.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        let motion_margin = match (self.should_refine(), other.should_refine()) {
            (true, true) => self.motion_margin.max(other.motion_margin),
            (true, false) => self.motion_margin,
            (false, true) => other.motion_margin,
            (false, false) => self.motion_margin.min(other.motion_margin),
        };
        Self { weight: self.weight.max(other.weight), motion_margin }
    }

    /// Whether the part should be refined.
    pub fn should_refine(&self) -> bool {
        self.weight > 1.0
    }
}

/// Decides which parts of a surface are refined. Any function from a part to its weight is a criterion.
///
/// A part must weigh at least as much as every part inside it, that is, one whose sphere and cone are
/// contained in its own and whose error is not larger. Models assume that a part that is not refined
/// contains no part to refine, and do not evaluate those. If a criterion violates this, the surface still
/// has no cracks, but parts inside a coarse part may not be refined, or may stay refined until their last
/// decision expires.
pub trait Criterion {
    /// Evaluates a part.
    fn weigh(&self, part: &Part) -> Verdict;

    /// Evaluates several parts and appends a verdict for each, equal to the one that [`weigh`](Self::weigh)
    /// returns.
    fn weigh_all(&self, parts: &[Part], verdicts: &mut Vec<Verdict>) {
        verdicts.extend(parts.iter().map(|part| self.weigh(part)));
    }

    /// How far the view has moved since an earlier one, in the unit of [`Verdict::motion_margin`]; infinite
    /// if verdicts of the earlier view say nothing about this one.
    ///
    /// Motions add up: a verdict is valid as long as their sum does not exceed its margin.
    fn motion_since(&self, _earlier: &Self) -> f32
    where
        Self: Sized,
    {
        f32::INFINITY
    }
}

impl<F: Fn(&Part) -> f32> Criterion for F {
    fn weigh(&self, part: &Part) -> Verdict {
        Verdict::now(self(part))
    }
}
