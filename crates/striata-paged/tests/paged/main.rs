//! Tests of paged files: builds, levels, views, addresses.
#![cfg(feature = "build")]

mod build;
mod reading;
mod reference_cut;
#[cfg(feature = "remote")]
mod remote;
mod views;
mod workshop;
