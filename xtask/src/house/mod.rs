//! The shape of the code: what makes it hard to change is counted, and each count has a limit that only falls.
//!
//! A limit is what was there when it was set. Whoever removes some lowers it; nobody raises it.

mod circles;
mod counts;
mod manifests;
mod phrases;
mod sources;

use anyhow::{Result, ensure};

use crate::steps::say;
use sources::RustFiles;

/// Something that is counted.
struct Check {
    name: &'static str,
    /// Largest count that passes.
    limit: usize,
    find: fn(&RustFiles) -> Result<CountWithPlaces>,
}

/// How much of something there is, and where.
struct CountWithPlaces {
    count: usize,
    /// A line for each place; empty if there are too many to list.
    places: Vec<String>,
}

impl From<Vec<String>> for CountWithPlaces {
    fn from(places: Vec<String>) -> Self {
        Self { count: places.len(), places }
    }
}

/// The checks, with the counts of today as limits.
const CHECKS: &[Check] = &[
    Check { name: "circles of files that use each other", limit: 1, find: circles::circles },
    Check { name: "functions with a tuple as parameter", limit: 39, find: counts::tuple_parameters },
    Check {
        name: "doc comments that begin with a word that says nothing",
        limit: 0,
        find: counts::weak_openings,
    },
    Check { name: "phrases that make text hard to read", limit: 27, find: phrases::forbidden },
    Check { name: "restricted pub per 10,000 lines of Rust", limit: 202, find: counts::restricted_pub },
    Check { name: "type names that are defined several times", limit: 26, find: counts::repeated_type_names },
    Check { name: "shared dependencies that no package uses", limit: 0, find: manifests::unused },
];

/// Counts everything, and prints each place if `lists` is true.
///
/// # Errors
/// If a count exceeds its limit.
pub(crate) fn check(lists: bool) -> Result<()> {
    let sources = RustFiles::read()?;
    let mut exceeded = Vec::new();
    for Check { name, limit, find } in CHECKS {
        let CountWithPlaces { count, places } = find(&sources)?;
        let note = match count.cmp(limit) {
            std::cmp::Ordering::Less => " (please lower the limit)",
            std::cmp::Ordering::Equal => "",
            std::cmp::Ordering::Greater => " (too many)",
        };
        say(&format!("{name}: {count}, limit {limit}{note}"));
        if lists || count > *limit {
            places.iter().for_each(|place| say(&format!("  {place}")));
        }
        if count > *limit {
            exceeded.push(*name);
        }
    }
    ensure!(exceeded.is_empty(), "above the limit of xtask/src/house/mod.rs: {}", exceeded.join("; "));
    Ok(())
}
