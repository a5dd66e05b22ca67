//! Half-edge collapses in order of cost: the simplifier behind every collapse sequence.
//!
//! A **strict** collapse preserves the topology. A position without one takes its cheapest **relaxed**
//! collapse, so that every target is reached.
//!
//! # Cost
//!
//! The cost of collapsing `v` to a neighbor `u` is computed over the triangles around `v` in the *current*
//! mesh. Its quadratic part adds the squared distances of `u` from their planes, weighted by area, and the
//! squared change of volume divided by the area. The full cost adds the squared distance of `v` from the new
//! fan times the area, how far the new edges of the fan stick out of the old star, and the cost of attributes
//! that end up on the wrong side of a seam. Measuring the edges reduced the largest distances by a fifth at
//! 25 % of the triangles and below. Thin spikes count for more than their area, because they are visible.
//!
//! A relaxed collapse costs as much as the surface moves. It competes with all other collapses, except that
//! on closed surfaces of a few parts relaxed collapses begin only after the last strict one, so that they do
//! not make any level worse. A position that loses its last triangle becomes a step that removes none, so
//! base meshes have no unused vertices.
//!
//! # Queue
//!
//! The queue (`heap.rs`) has one entry per position. Its key is provisional first: twice the cheapest
//! quadratic part of the position's candidates. When an entry reaches the top, the position is evaluated in
//! full, and goes back with its full cost as the key if that exceeds the next key. Full costs are nearly
//! always more than twice their quadratic part, so the order is nearly that of full costs, for a fraction of
//! the work: compared with keys that are never too high, this adds 0.3 % to the RMS down to 10 % of the
//! triangles and 1.3 % at 2 %, and saves over a quarter of the time.
//!
//! On meshes with seams or relaxed collapses, errors are measured in both directions. A collapse that would
//! exceed the largest error so far is measured first, and goes back into the queue with the measured cost.
//! Otherwise levels would report early peaks that disappear later.
//!
//! # Files
//!
//! | files | what they do |
//! | --- | --- |
//! | `links/`, `legality.rs` | the link of each position; whether a collapse preserves the surface |
//! | `star/`, `fan.rs` | the star of one position, its quadratic form, the fan each candidate would leave |
//! | `flat_fold.rs`, `height_field.rs` | whether a triangle would turn over within a flat surface, or in plan |
//! | `wedges.rs`, `attributes.rs`, `seam_cost.rs`, `charts.rs` | pairing of wedges, cost of attributes |
//! | `base_colors.rs` | cost of what changes in the colors that textures show |
//! | `collapse_choice.rs`, `cost_evaluator.rs` | bound and full cost of a position's candidates |
//! | `costs/` | the trait of all costs, their list, and what each of them adds |
//! | `pairs.rs` | contraction of separate parts |
//! | `heap.rs`, `simplifier.rs`, `executor.rs`, `refinement_order.rs` | the loop, a step, the numbering |
//! | `part_order.rs` | how the steps of parts that are simplified at the same time merge |
//! | `walk.rs`, `witness.rs`, `outward_bounds.rs` | the error that a step reports, in both directions |
//! | `relaxed_state.rs`, `parts.rs`, `surface_snapshot.rs` | global data that relaxed collapses need |
//! | `relaxation_schedule.rs`, `relaxed_candidates.rs` | when relaxed collapses begin and what they cost |
//! | `lost_positions.rs`, `foliage.rs` | what else relaxed collapses remove, and what replaces it |
//! | `batches/` | half-edge collapses in batches, for progressive coding |

pub(super) mod attributes;
pub(super) mod base_colors;
pub(super) mod batches;
pub(super) mod charts;
pub(super) mod collapse_choice;
pub(super) mod cost_evaluator;
pub(super) mod costs;
pub(super) mod executor;
pub(super) mod fan;
pub(super) mod flat_fold;
pub(super) mod foliage;
pub(super) mod heap;
pub(super) mod height_field;
pub(super) mod legality;
pub(super) mod links;
pub(super) mod lost_positions;
pub(super) mod outward_bounds;
pub(super) mod pairs;
pub(super) mod part_order;
pub(super) mod parts;
pub(super) mod refinement_order;
pub(super) mod relaxation_schedule;
pub(super) mod relaxed_candidates;
pub(super) mod relaxed_state;
pub(super) mod seam_cost;
pub(super) mod simplifier;
pub(super) mod star;
pub(super) mod surface_snapshot;
pub(super) mod walk;
pub(super) mod wedges;
pub(super) mod witness;
