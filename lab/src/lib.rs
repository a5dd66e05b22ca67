//! Published level-of-detail models and measuring tools that striata is compared with. Never shipped.
//!
//! [`baseline`] contains level-of-detail models as described in their papers, [`stripifiers`] contains stripifiers,
//! and [`mts_graph`] is the graph of \[BRR02\], which [`Mts`](striata::model::Mts) improves on. Models implement the
//! traits of [`striata::model`] and show the same triangles over the same vertex buffer as the library's models, so
//! that only the data structures are compared. [`PaperBytes`] counts the memory of all of them, including the
//! library's, as the papers do.
//!
//! ```
//! use striata::mesh::shapes;
//! use striata::model::{LodModel, Mts};
//! use striata::simplify::build_sequence;
//! use striata::strip::stripify;
//! use striata_lab::{Accounting, MtsGraph, PaperBytes};
//!
//! let torus = shapes::torus(32, 16, 1.0, 0.4);
//! let refinable = build_sequence(&torus, &Default::default())?.refinable;
//! let strips = stripify(&refinable.mesh)?;
//! let (ours, published) = (Mts::build(&refinable, &strips)?, MtsGraph::build(&refinable, &strips)?);
//! assert_eq!(ours.step_count(), published.step_count());
//! assert!(ours.paper_bytes(Accounting::Words) < published.paper_bytes(Accounting::Words));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod baseline;
mod cpu_clock;
pub mod mts_graph;
mod paper_bytes;
mod spread;
pub mod stripifiers;

pub use cpu_clock::cpu_secs;
pub use mts_graph::{MtsArc, MtsGraph, MtsGraphState, MtsNode};
pub use paper_bytes::{Accounting, PaperBytes};
pub use spread::Spread;
