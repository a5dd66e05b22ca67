//! Paged `.striata` files: continuous level of detail of meshes that do not fit into memory.
//!
//! A mesh is built in cells of space, in tasks that any executor can run ([`build`]). The steps of one cell form a
//! [`Page`]; a paged file is a head and pages, coarse to fine. Any set of pages that contains the parents of its
//! members is a valid mesh: a region whose page is absent is coarser, but never has cracks.
//!
//! The error of a step covers the steps below it: it is the root of the sum of their squared errors, or the largest
//! distance in the cell plus the errors of finer levels, whichever is less.
//!
//! [`PagedFile`] reads the pages that a level needs; [`PagedReader`] does the same without any input and output,
//! for programs that fetch bytes themselves. [`assemble`] makes a mesh of pages, with all of its levels;
//! [`CutPages`] makes levels whose detail varies, for a view or a box.
//!
//! | file | what it does |
//! | --- | --- |
//! | `metadata.rs`, `directory.rs`, `head.rs` | the parts that are read before any page |
//! | `page.rs`, `codec/` | pages and their bytes |
//! | `reader.rs`, `store.rs`, `supplied_store.rs`, `paged_file.rs`, `paged_view.rs` | reading what a level or a view needs |
//! | `loaded.rs`, `replaced.rs`, `mesh_parts.rs` | how pages in memory refer to each other |
//! | `assemble.rs` | a mesh made of pages, with all of its levels |
//! | `cut/`, `tiers.rs` | levels of varying detail made of pages |
//! | `build/` | building from inputs of any size |

mod assemble;
#[cfg(feature = "build")]
pub mod build;
mod bytes;
mod codec;
mod cut;
mod directory;
mod error;
mod hash;
mod head;
mod levels;
mod loaded;
mod mesh_parts;
mod metadata;
mod page;
mod paged_file;
mod paged_view;
mod parallel;
mod reader;
#[cfg(feature = "remote")]
mod remote;
mod replaced;
mod store;
mod supplied_store;
mod tiers;

pub use assemble::{Assembled, assemble};
pub use cut::{CutPages, PagedCut};
pub use directory::{PageBound, PageEntry, image_path, page_path};
pub use error::{HeadDefect, PageDefect, PagedError};
pub use head::{HEAD_NAME, Leaf, PAGED_MAGIC, PREFIX_BYTES, Prefix, Root, write_head};
pub use metadata::{Metadata, PageId, PagedGrid, PagedGroup, PagedImage, PagedLayer};
pub use page::{Import, Page};
pub use paged_file::{PagedFile, ReadStatistics, ShownPages};
pub use paged_view::{ViewCut, leaving};
pub use reader::{PagedReader, StoredPlace, Want};
pub use store::{FileStore, Store, open_store};
pub use supplied_store::SuppliedStore;
pub use tiers::StepTiers;
