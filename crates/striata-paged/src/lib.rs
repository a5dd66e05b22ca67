//! Paged `.striata` files: continuous level of detail of meshes that do not fit into memory.

mod page;

pub use page::{Import, Page, PageId};
