//! Connectivity of splits: which vertices split, and which triangles move to the new vertex.
//!
//! Whether a vertex splits is predicted from numbers stored with it. Which run of its triangles moves to the new
//! vertex is coded as a rank among the possible runs, or chosen by a log-linear model that learns online.
//!
//! | file | what it does |
//! | --- | --- |
//! | `model.rs` | [`ConnectivityModel`]: flags and cuts |
//! | `chain_cuts.rs` | cuts as sequences of binary decisions |
//! | `ranked_cuts.rs` | cuts as two symbols, by rank: for the fast effort |
//! | `learned_cuts.rs` | cuts by learned scores: for the compact effort |
//! | `arithmetic.rs` | integer arithmetic on vectors and scores |
//! | `split_context.rs` | [`SplitContext`]: what both sides know when a vertex is coded |
//!
//! All models use integers only, and depend only on what has been decoded.

mod arithmetic;
mod chain_cuts;
mod learned_cuts;
mod model;
mod ranked_cuts;
mod split_context;

pub(crate) use model::{ConnectivityModel, CutOfSplit};
pub(crate) use split_context::SplitContext;
