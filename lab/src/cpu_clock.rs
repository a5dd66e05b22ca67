//! Time that a thread has spent on a processor.

use std::sync::OnceLock;
use std::time::Instant;

/// Returns the CPU time of this thread in seconds if the system reports it, otherwise the time since the first
/// call.
///
/// Other jobs on the machine change it much less than wall-clock time.
pub fn cpu_secs() -> f64 {
    static START: OnceLock<Instant> = OnceLock::new();
    let schedstat = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanos = schedstat.and_then(|text| text.split_whitespace().next()?.parse::<u64>().ok());
    nanos.map_or_else(|| START.get_or_init(Instant::now).elapsed().as_secs_f64(), |nanos| nanos as f64 * 1e-9)
}
