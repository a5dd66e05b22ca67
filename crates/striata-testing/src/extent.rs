//! How much work tests do: all of it with `STRIATA_TEST_ALL`, which `cargo xtask test --all` sets.

use proptest::prelude::ProptestConfig;

fn is_all() -> bool {
    std::env::var_os("STRIATA_TEST_ALL").is_some()
}

/// Returns a configuration with that number of random cases, or a tenth of it, but at least eight.
pub fn cases(count: u32) -> ProptestConfig {
    ProptestConfig::with_cases(if is_all() { count } else { (count / 10).max(8).min(count) })
}

/// Returns the size of a large input, or a quarter of it.
pub fn large(count: usize) -> usize {
    if is_all() { count } else { count / 4 }
}
