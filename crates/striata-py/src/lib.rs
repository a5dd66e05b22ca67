//! The Rust half of the Python package `striata`: arrays in, arrays out.
//!
//! The package is `python/striata`; it converts what users pass (arrays of any kind, meshes of other packages)
//! and calls the module `striata._striata`, which this crate builds with the feature `python`. Without that
//! feature only [`sources`] and [`one_level`] are compiled, which need no Python and are tested like
//! any other crate.
//!
//! In reading order: `sources` says which vertex of the input each vertex of a level comes from, `one_level`
//! simplifies to a single level, `levels` has all of them; `job` runs long calls so that Ctrl-C works, `pool`
//! gives them threads that survive a fork, `arrays` and `errors` convert; the remaining modules are the classes
//! and functions of the module, one file each.
//!
//! Arrays are untrusted: every call succeeds or raises an exception that names the place.

pub mod one_level;
pub mod sources;

#[cfg(feature = "python")]
mod arrays;
#[cfg(feature = "python")]
mod clusters;
#[cfg(feature = "python")]
mod content;
#[cfg(feature = "python")]
mod decode;
#[cfg(feature = "python")]
mod distance;
#[cfg(feature = "python")]
mod errors;
#[cfg(feature = "python")]
mod files;
#[cfg(feature = "python")]
mod job;
#[cfg(feature = "python")]
mod lod;
#[cfg(feature = "python")]
mod mesh;
#[cfg(feature = "python")]
mod module;
#[cfg(feature = "python")]
mod options;
#[cfg(feature = "python")]
mod paged;
#[cfg(feature = "python")]
mod plan;
#[cfg(feature = "python")]
mod pool;
#[cfg(feature = "python")]
mod scene;
#[cfg(feature = "python")]
mod simplify;
#[cfg(feature = "python")]
mod stream;
#[cfg(feature = "python")]
mod strip_level;
#[cfg(feature = "python")]
mod strips;
#[cfg(feature = "python")]
mod tiles;
#[cfg(feature = "python")]
mod view;
