//! The command as its users meet it: run in a folder of its own, judged by what it prints and leaves.

#[cfg(feature = "gpu")]
mod bench_gpu;
mod compare;
mod compare_assets;
mod compare_models;
mod compare_patterns;
mod compare_views;
mod help;
mod levels;
mod orders;
mod outputs;
mod patterns;
mod refusals;
mod render;
mod seams;
#[cfg(all(unix, feature = "serve"))]
mod serve;
#[cfg(all(unix, feature = "serve"))]
mod serve_client;
#[cfg(all(unix, feature = "serve"))]
mod serve_load;
mod streams;
mod strip_blocks;
mod strips;
mod verbs;
#[cfg(feature = "window")]
mod view;
mod workbench;
