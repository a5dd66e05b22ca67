//! Processor time used by commands, which is more meaningful than elapsed time on a busy machine.

/// Number of ticks per second in which Linux reports process times; it is the same on all architectures.
const TICKS_PER_SEC: f64 = 100.0;

/// Processor time of all finished commands at some moment; unknown on systems other than Linux.
pub(crate) struct CpuTime(Option<f64>);

impl CpuTime {
    /// Returns the time used so far.
    pub(crate) fn now() -> Self {
        Self(std::fs::read_to_string("/proc/self/stat").ok().and_then(|stat| children_secs(&stat)))
    }

    /// Returns the seconds used since then.
    pub(crate) fn secs_since(&self) -> Option<f64> {
        Some(Self::now().0? - self.0?)
    }
}

/// Returns user and system time of finished children: fields 16 and 17 of `/proc/self/stat`, counted after
/// the name in parentheses.
fn children_secs(stat: &str) -> Option<f64> {
    let (_, fields) = stat.rsplit_once(')')?;
    let ticks: Vec<f64> =
        fields.split_whitespace().skip(13).take(2).filter_map(|word| word.parse().ok()).collect();
    (ticks.len() == 2).then(|| ticks.iter().sum::<f64>() / TICKS_PER_SEC)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_found_after_names_with_parentheses() {
        let stat = "7 (a (b) c) S 1 7 7 0 -1 4194560 1 2 3 4 50 60 250 125 20 0 1 0 9 9 9";
        assert_eq!(children_secs(stat), Some(3.75));
        assert_eq!(children_secs("nonsense"), None);
    }
}
