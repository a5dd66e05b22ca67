//! A vertex hierarchy that grows while a stream is decoded, and view-dependent cuts of it.
//!
//! Each step is a node. To refine a step, every position around the restored vertex has to be active, and
//! so does the position that it collapses to; the hierarchy lists the steps that create these as the step's
//! dependencies (`grow.rs`). A **cut** is a set of refined steps that includes the dependencies of each
//! (`cut.rs`). It shows the base triangles and those that its steps add; each corner of a triangle is the
//! first active vertex along the chain of collapse targets. These are the triangles of
//! [`FanInstance`](striata::model::FanInstance) for the same set of steps, for any topology of the steps.
//!
//! ```text
//! steps so far      | new steps     grow: replay the new steps backward, only over the triangles that they
//! ------------------+---------->          changed, to find each one's dependencies, parent and bounds;
//!  dependencies,    |                     then widen the bounds of the ancestors until nothing changes
//!  parents, bounds  |
//! ```
//!
//! The parents form the tree that a view descends. The bounds of a step include those of its children
//! \[Hop97\], so if the view does not request a step, it requests none below it either.
//!
//! Differs: \[Hop97\] builds the bounds from the leaves. Here the leaves arrive last, so a node begins with
//! the bounds of its own triangles and is widened by its descendants. Cones keep the axis of the node's own
//! triangles.
//!
//! Cost: growing is linear in the triangles around the new vertices, and in the ancestors whose bounds they
//! widen. A node takes about 85 bytes, up to 125 including spare capacity. A cut evaluates the criterion
//! once for each step in the cut or just below it, and makes one pass over the vertices.
//!
//! Invariants: a step's parent and dependencies are older than the step; bounds are nested.

mod cut;
mod grow;
mod hierarchy;

pub use cut::{CutUpdate, HierarchyCut};
pub use hierarchy::GrowingHierarchy;
