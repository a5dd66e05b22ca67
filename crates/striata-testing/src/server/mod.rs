//! A `striata serve` process for tests, a client that sends exact bytes, and many clients at the same time.

mod client;
mod load;

pub use client::{Answer, Connection, PATIENCE, Server};
pub use load::{FILE, LoadOutcome, LoadPlan, memory_kb, run, write_file};
