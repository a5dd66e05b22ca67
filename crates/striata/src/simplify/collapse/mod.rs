//! Half-edge collapses, ordered by cost: the quadric simplifier.

pub(super) mod absorb;
pub(super) mod aftermath;
pub(super) mod attributes;
pub(super) mod batches;
pub(super) mod charts;
pub(super) mod course;
pub(super) mod crossing;
pub(super) mod engine;
pub(super) mod fan;
pub(super) mod finish;
pub(super) mod heap;
pub(super) mod judge;
pub(super) mod legality;
pub(super) mod links;
pub(super) mod outward;
pub(super) mod pairs;
pub(super) mod parts;
pub(super) mod quadric;
pub(super) mod relaxation;
pub(super) mod relaxed;
pub(super) mod rest;
pub(super) mod star;
pub(super) mod tracked;
pub(super) mod wedges;
pub(super) mod witness;
