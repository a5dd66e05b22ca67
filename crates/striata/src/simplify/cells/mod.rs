//! Simplification in cells: builds one continuous hierarchy of a mesh of any size from small tasks.
//!
//! Space is divided into cells, once for every level of a hierarchy ([`Partition`]). A cell task
//! ([`simplify_cell`]) loads the triangles of one cell, simplifies them to a quarter, and passes the surviving
//! triangles on to the cells of the next level. Cells of one level are independent of each other, and nothing
//! ever moves, so nothing has to be stitched afterwards: the steps of all tasks together form one sequence.
//!
//! ```text
//! level 0          level 1 (rotated)      level 2
//! +--+--+--+--+      /\                   +---------+
//! |  |  |  |  |     /  \/\                |         |
//! +--+--+--+--+ --> \  /  \ /  ... -->    | all of  |
//! |  |  |  |  |      \/\  //              |  space  |
//! +--+--+--+--+         \//               +---------+
//!   steps              steps                steps, base mesh
//! ```
//!
//! # Inside and border
//!
//! A position belongs to the cell that contains it. A triangle is **inside** a cell if all three corners belong
//! to that cell; otherwise it is a **border triangle**, which no cell of that level may change. A cell task also
//! sees the border triangles at its own positions, so that it knows every complete star; the corners of border
//! triangles are locked. Two cells therefore never change the same triangle or create the same edge, and a
//! border of one level lies inside a cell of a later one, because every level uses another frame.
//!
//! # Order
//!
//! A step depends on the last step that changed each triangle of its star. Every triangle carries the
//! [`History`] of that step from level to level, so the key and the error of a step cover those of all steps
//! that it depends on. A key is always larger than those, so sorting all steps by key gives a valid sequence,
//! and steps with the same key are independent of each other.

mod cell_mesh;
mod cell_steps;
mod hierarchy;
mod in_core;
mod partition;
mod rounding;
mod route;
mod simplify_cell;
mod trace;
mod union;

pub use cell_mesh::{Cell, CellMesh, History};
pub(super) use in_core::{CELL_TRIANGLES, is_worth_dividing, simplify_in_cells};

pub use cell_steps::{CellOptions, CellSteps, SimplifiedCell};
pub use hierarchy::{CellHierarchy, HierarchyCell, build_in_cells};
pub use partition::{Partition, PartitionLevel};
pub use rounding::{next_key, round_error, round_key};
pub use route::{Routed, route};
pub use simplify_cell::simplify_cell;
