//! Half-edge collapses in order of cost: the simplifier behind every collapse sequence.
//!
//! The cost of collapsing `v` to a neighbor `u` is a quadratic form of `u` over the triangles around
//! `v` in the *current* mesh: squared distances from their planes, weighted by area, plus the squared
//! change of volume. The distance between the old star and the new fan is added, and the cost of
//! attributes that cross a seam. The full cost of a candidate is expensive to evaluate, so the queue
//! contains lower bounds: a position that reaches the top is evaluated in full first, and goes back if
//! its cost exceeds the next bound. A **strict** collapse preserves the topology. A position without
//! one takes its cheapest **relaxed** collapse, so that every target is reached.
//!
//! # Cost
//!
//! Over the triangles around `v` in the current mesh, the cost adds the squared distances of `u` from
//! their planes by area, the squared change of volume over the area, and the area times the squared
//! distance of `v` from the new fan. It also adds how far the new edges of the fan stick out of the old
//! star, which the distance of `v` does not measure; that reduced the largest distances by a fifth from
//! 25 % of the triangles on. Thin spikes count for more than their area, because they are visible.
//!
//! After a collapse, each neighbor gets the least of its quadratic costs, doubled, as its bound: a full
//! cost is nearly always more than twice its quadratic part. A position whose full cost is below its
//! bound comes up late, by at most that factor. Compared with bounds that are never too high, this adds
//! 0.3 % to the RMS down to 10 % of the triangles and 1.3 % at 2 %, and saves over a quarter of the time.
//!
//! Seams are crossed at the price of the attributes that end up in the wrong chart. Relaxed collapses
//! compete with all others in one queue, at a cost that says how far the surface moves; closed surfaces
//! of a few parts wait until no strict collapse is left, so their levels are as good as without them. A
//! position that loses its last triangle becomes a step that removes none, so base meshes have no
//! unused vertices. On meshes with seams or relaxed collapses, errors are measured in both directions:
//! a collapse that would exceed the largest error so far is measured first, and goes back into the
//! queue with the measured cost. Otherwise levels would report early peaks that disappear later.
//!
//! # Files
//!
//! | files | what they do |
//! | --- | --- |
//! | `links/`, `legality.rs` | the link of each position; whether a collapse preserves the surface |
//! | `star/`, `fan.rs` | the star of one position, its quadratic form, the fan each candidate would leave |
//! | `wedges.rs`, `attributes.rs`, `seam_cost.rs`, `charts.rs` | pairing of wedges, cost of attributes |
//! | `collapse_choice.rs`, `cost_evaluator.rs` | bound and full cost of a position's candidates |
//! | `quadric.rs`, `tracked.rs`, `pairs.rs` | data of the other two costs; contraction of separate parts |
//! | `heap.rs`, `simplifier.rs`, `executor.rs`, `refinement_order.rs` | the loop, a step, the numbering |
//! | `walk.rs`, `witness.rs`, `outward_bounds.rs` | the error that a step reports, in both directions |
//! | `relaxed_state.rs`, `parts.rs`, `surface_snapshot.rs` | global data that relaxed collapses need |
//! | `relaxation_schedule.rs`, `relaxed_candidates.rs` | when relaxed collapses begin and what they cost |
//! | `lost_positions.rs`, `foliage.rs` | what else relaxed collapses remove, and what replaces it |
//! | `batches/` | half-edge collapses in batches, for progressive coding |

pub(super) mod attributes;
pub(super) mod batches;
pub(super) mod charts;
pub(super) mod collapse_choice;
pub(super) mod cost_evaluator;
pub(super) mod executor;
pub(super) mod fan;
pub(super) mod foliage;
pub(super) mod heap;
pub(super) mod legality;
pub(super) mod links;
pub(super) mod lost_positions;
pub(super) mod outward_bounds;
pub(super) mod pairs;
pub(super) mod parts;
pub(super) mod quadric;
pub(super) mod refinement_order;
pub(super) mod relaxation_schedule;
pub(super) mod relaxed_candidates;
pub(super) mod relaxed_state;
pub(super) mod seam_cost;
pub(super) mod simplifier;
pub(super) mod star;
pub(super) mod surface_snapshot;
pub(super) mod tracked;
pub(super) mod walk;
pub(super) mod wedges;
pub(super) mod witness;
