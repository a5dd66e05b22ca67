//! The command as its users meet it: run in a folder of its own, judged by what it prints and leaves.

mod compare;
mod compare_models;
mod compare_patterns;
mod compare_views;
mod help;
mod orders;
mod patterns;
mod refusals;
mod streams;
mod strip_blocks;
mod strips;
mod verbs;
mod view;
mod workbench;
