//! Paged `.striata` files: continuous level of detail of meshes that do not fit into memory.
//!
//! A mesh is built in cells of space, in tasks that any executor may run ([`build`]). The steps of one cell are
//! one [`Page`]; a paged file is a head and pages, coarse to fine. Any set of pages that contains the parents of
//! its members is a valid mesh: what is absent is coarser, never cracked.

#[cfg(feature = "build")]
pub mod build;
mod bytes;
mod codec;
mod directory;
mod error;
mod head;
mod metadata;
mod page;

pub use directory::{PageBound, PageEntry, page_path};
pub use error::{HeadDefect, PageDefect, PagedError};
pub use head::{HEAD_NAME, Leaf, PAGED_MAGIC, PREFIX_BYTES, Prefix, Root, write_head};
pub use metadata::{Grid, Metadata, PagedGroup, PagedLayer};
pub use page::{Import, Page, PageId};
