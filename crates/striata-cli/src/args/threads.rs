//! Number of threads.

use clap::Args;

/// Place of the flag in the list of a verb, before the flags of every verb.
pub(super) const ORDER: usize = 898;

/// Number of threads of a verb that computes a lot.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct ThreadArgs {
    /// Use at most N threads [default: one per core]
    // Without this, the heading of whatever flags come before would apply here too.
    #[arg(
        long,
        value_name = "N",
        help_heading = None,
        display_order = ORDER,
        value_parser = clap::value_parser!(u16).range(1..=1024)
    )]
    threads: Option<u16>,
}

impl ThreadArgs {
    /// Returns the number of threads that the user allows.
    pub(super) fn count(self) -> Option<usize> {
        self.threads.map(usize::from)
    }
}
