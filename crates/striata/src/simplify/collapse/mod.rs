//! Half-edge collapses, the cheapest first: the simplifier that every sequence of collapses comes from.
//!
//! The cost of collapsing `v` to a neighbor `u` is a quadratic form of `u`, over the triangles around `v` in the *current* mesh: squared
//! distances from their planes by area, and the squared change of volume. The distance between the old star and the new fan comes on top, and
//! the price of attributes that cross a seam. Judging a candidate in full is dear, so the queue holds bounds: whoever reaches its top is
//! judged in full first, and goes back if its cost is higher than the next bound. A position without a **strict** collapse, one that
//! keeps the topology, takes the cheapest **relaxed** one, so that every target is reached.
//!
//! In reading order:
//!
//! | files | what they do |
//! | --- | --- |
//! | `links/`, `legality.rs` | what surrounds each position; whether a collapse keeps the surface what it is |
//! | `star/`, `fan.rs` | the star of one position, its quadratic form, and the fan that each candidate would leave |
//! | `wedges.rs`, `attributes.rs`, `crossing.rs`, `charts.rs` | which vertex stands for which, and what that does to attributes |
//! | `choice.rs`, `judge.rs` | all of it together: a bound quickly, the best target in full |
//! | `quadric.rs`, `tracked.rs`, `pairs.rs` | what the other two costs remember; contraction of parts that do not touch |
//! | `heap.rs`, `engine.rs`, `course.rs`, `finish.rs` | the loop, what one step changes and records, and refinement order at the end |
//! | `walk.rs`, `witness.rs`, `outward.rs` | the error that a step reports, from the original to the surface and back |
//! | `whole.rs`, `parts.rs`, `rest.rs` | what relaxed collapses need to know of the whole mesh |
//! | `relaxation.rs`, `relaxed.rs`, `aftermath.rs`, `absorb.rs` | when relaxed collapses begin, what they cost, and what follows them |
//! | `batches/` | the same collapses in batches, as a progressive coder undoes them |

pub(super) mod absorb;
pub(super) mod aftermath;
pub(super) mod attributes;
pub(super) mod batches;
pub(super) mod charts;
pub(super) mod choice;
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
pub(super) mod walk;
pub(super) mod wedges;
pub(super) mod whole;
pub(super) mod witness;
