//! Tests of the published models, and end-to-end tests of the `striata-lab` command: each runs in a temporary folder
//! and checks the output and the files written.

mod ball;
mod baselines;
#[cfg(feature = "gpu")]
mod bench_gpu;
mod caches;
mod compare;
mod compare_assets;
mod compare_models;
mod compare_patterns;
mod compare_rate;
mod compare_views;
mod general_patterns;
mod help;
mod loop_patterns;
mod mts_graph;
mod multi_triangulation;
mod poses;
mod published_fans;
mod sequential_patterns;
mod show;
mod strip_baselines;
mod stripifiers;
mod view_dependent;
#[path = "../../../crates/striata-cli/tests/cli/workbench.rs"]
#[expect(dead_code, reason = "shared with the tests of striata-cli, which use more of it")]
mod workbench;

/// The command under test.
pub(crate) const COMMAND: &str = "striata-lab";
