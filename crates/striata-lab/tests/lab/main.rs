//! The lab's command as its users meet it: run in a folder of its own, judged by what it prints and leaves.

mod ball;
#[cfg(feature = "gpu")]
mod bench_gpu;
mod compare;
mod compare_assets;
mod compare_models;
mod compare_patterns;
mod compare_rate;
mod compare_views;
mod help;
#[path = "../../../striata-cli/tests/cli/workbench.rs"]
#[expect(dead_code, reason = "the product's tests need more of it")]
mod workbench;

/// The command under test.
pub(crate) const COMMAND: &str = "striata-lab";
