//! Processor time of the commands that were run, which tells on a busy machine what the clock cannot.

/// Ticks a second in which Linux counts the time of processes, on every machine that it runs on.
const TICKS_PER_SEC: f64 = 100.0;

/// What all commands that have ended took until some moment; unknown on other systems than Linux.
pub(crate) struct CpuTime(Option<f64>);

impl CpuTime {
    /// Until now.
    pub(crate) fn now() -> Self {
        Self(std::fs::read_to_string("/proc/self/stat").ok().and_then(|stat| children_secs(&stat)))
    }

    /// Seconds that commands have taken since.
    pub(crate) fn secs_since(&self) -> Option<f64> {
        Some(Self::now().0? - self.0?)
    }
}

/// User and system time of children that were waited for: fields 16 and 17, counted after the name in
/// brackets.
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
    fn times_are_found_behind_any_name() {
        let stat = "7 (a (b) c) S 1 7 7 0 -1 4194560 1 2 3 4 50 60 250 125 20 0 1 0 9 9 9";
        assert_eq!(children_secs(stat), Some(3.75));
        assert_eq!(children_secs("nonsense"), None);
    }
}
