//! Selective loading: a table of which only some pages are in memory.
//!
//! A page has what belongs to some of the steps: their entries, bounds and positions. Steps that are about as
//! coarse and near each other share a page, so a view needs few pages. A small directory is always in memory: the
//! entries of the base, the page of each step, and bounds of each page.
//!
//! ```text
//!           coarse ------------------------> fine
//! directory [ base ]  [ page 0 ]  [ page 1 ][ page 2 ]  [ page 3 ][ page 4 ][ page 5 ][ page 6 ]   a band per column,
//!                                                                                                  pages along a curve
//! ```
//!
//! **What can be shown.** A step needs its own entry, and the steps that this entry names. So the steps that are
//! wanted, have their pages and need no step that is missing are a valid set: it shows a surface without cracks,
//! whichever pages are loaded. [`PagedFans::refine`] shows this set and says which pages the view needs, and which of
//! them are absent, most important first. With all of these loaded, it shows what [`FanInstance::refine`] shows.
//!
//! This is the future work of \[Cor01\]: the model is in secondary memory, and only what the criterion requires is
//! loaded. Differs: the entries of children are not needed to decide whether they are wanted, because pages have
//! bounds of their own.
//!
//! [`FanInstance::refine`]: super::FanInstance::refine

mod demand;
mod directory;
mod page;
mod paged_fans;

pub use self::demand::{AbsentPage, PageDemand};
pub use self::directory::FanDirectory;
pub use self::paged_fans::PagedFans;
