//! What decides where a mesh is refined: a question that is asked of parts of its surface.
//!
//! Models know parts: a step and all that cannot be there without it, as a sphere, a cone of normals and an error. A criterion
//! knows the view. It weighs a part, and parts that weigh more than 1 are refined. Parts lie within each other,
//! and what is true of the whole has to be true of the part, or a model would have to look below what it leaves coarse.

use super::{NormalCone, Sphere};

/// A part of a surface that can be left out or put in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Holds whatever changes when the part is left out.
    pub sphere: Sphere,
    /// Holds the normals of all triangles that then go or come.
    pub cone: NormalCone,
    /// How far the surface may be from where it should be while the part is left out, mesh units.
    pub error: f32,
}

/// What a criterion says of a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// How many times what is allowed the part's error is: it is refined above 1. 0 where nothing of it can be seen.
    pub weight: f32,
    /// Whether the weight is above 1 stays the same until the view has moved by more than this; see
    /// [`Criterion::motion_since`]. Never negative.
    pub lasts: f32,
}

impl Verdict {
    /// A weight that has to be asked for again whenever anything moves.
    pub fn now(weight: f32) -> Self {
        Self { weight, lasts: 0.0 }
    }

    /// Whether the part is to be refined.
    pub fn is_wanted(&self) -> bool {
        self.weight > 1.0
    }
}

/// Decides what is refined. Any function that weighs a part is a criterion.
///
/// A part must not weigh less than one that lies within it: whose sphere and cone are held by its own, and whose error is no
/// larger. Models take a part that is not wanted to hold none that is, and do not ask. Where that is not so nothing cracks; but what is
/// shown may then lack such a part, or keep one for as long as its last verdict lasts.
pub trait Criterion {
    /// Weighs a part.
    fn weigh(&self, part: &Part) -> Verdict;

    /// Weighs several parts at once, and appends a verdict for each: the same that [`weigh`](Self::weigh) gives.
    fn weigh_all(&self, parts: &[Part], verdicts: &mut Vec<Verdict>) {
        verdicts.extend(parts.iter().map(|part| self.weigh(part)));
    }

    /// How far the view has moved from an earlier one, in the unit of [`Verdict::lasts`]; infinite where verdicts of the earlier
    /// one say nothing of this one. Motions add up: a verdict lasts while their sum does not exceed it.
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
