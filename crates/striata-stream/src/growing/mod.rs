//! A vertex hierarchy that grows while steps arrive, and view-dependent cuts of what has arrived.
//!
//! Each step is a node. To refine a step, every position around the restored vertex has to be active, and the position that it
//! collapses to; the hierarchy lists these steps for each step (`grow.rs`). A **cut** is a set of refined steps that holds what each of
//! them needs (`cut.rs`). It shows the triangles that its steps add, and each corner of a triangle is the first active vertex along the
//! chain of targets. These are the triangles of [`FanInstance`](striata::model::FanInstance) for the same set of steps, whatever the topology of
//! the steps is.
//!
//! ```text
//! steps so far      | arriving      grow: replay the new steps backward, only over the triangles that they changed
//! ------------------+---------->          to find what each needs, its parent, and its bounds;
//!  needs, parents,  |                     then widen the bounds of the ancestors until nothing changes
//!  bounds (nodes)   |
//! ```
//!
//! Parents form the tree that a view descends: a step's bounds hold those of its children \[Hop97\], so a step that the view does
//! not want has nothing wanted below it.
//!
//! Differs: in \[Hop97\] bounds are built from the leaves. Here leaves arrive last, so a node begins with the bounds of its own change and is
//! widened by its descendants. Cones keep the axis of the node's own triangles.
//!
//! Cost: growing is linear in the triangles around the new vertices, and in the ancestors whose bounds they widen. A node takes about 85
//! bytes, up to 125 with the room that lists keep. A cut costs a question for each step in or next to it and one pass over the vertices.
//!
//! Invariants: parents and needs are older than their step; bounds are nested.

mod cut;
mod grow;
mod hierarchy;

pub use cut::{CutUpdate, HierarchyCut};
pub use hierarchy::GrowingHierarchy;
