//! Paged `.striata` files: continuous level of detail of meshes that do not fit into memory.

mod directory;
mod metadata;
mod page;

pub use directory::{PageBound, PageEntry};
pub use metadata::{Grid, Metadata, PagedGroup, PagedLayer};
pub use page::{Import, Page, PageId};
