//! Time spent in each phase of a run, and its peak memory.

use std::time::Instant;

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

/// A clock that times the phases of one run; a phase lasts until the next one begins.
#[derive(Debug)]
pub struct Phases {
    started: Instant,
    entered: Instant,
    current: Option<usize>,
    secs: Vec<(&'static str, f64)>,
}

impl Phases {
    /// Starts a clock for the named phases; all of them are reported, whether entered or not.
    pub fn new(names: &[&'static str]) -> Self {
        let now = Instant::now();
        Self { started: now, entered: now, current: None, secs: names.iter().map(|&n| (n, 0.0)).collect() }
    }

    /// Ends the current phase and begins another; does nothing if the name is unknown or already current.
    pub fn enter(&mut self, name: &str) {
        let Some(next) = self.secs.iter().position(|&(known, _)| known == name) else { return };
        if self.current == Some(next) {
            return;
        }
        self.leave();
        self.current = Some(next);
    }

    /// Ends the current phase.
    pub fn leave(&mut self) {
        let now = Instant::now();
        if let Some(phase) = self.current.take() {
            self.secs[phase].1 += (now - self.entered).as_secs_f64();
        }
        self.entered = now;
    }

    /// Returns the seconds spent in a phase so far.
    pub fn secs_of(&self, name: &str) -> f64 {
        self.secs.iter().filter(|(known, _)| *known == name).map(|&(_, secs)| secs).sum()
    }

    /// Returns the seconds since the clock was started.
    pub fn total_secs(&self) -> f64 {
        self.started.elapsed().as_secs_f64()
    }
}

impl Serialize for Phases {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.secs.len()))?;
        for (name, secs) in &self.secs {
            map.serialize_entry(name, secs)?;
        }
        map.end()
    }
}

/// Returns the peak resident memory of the process in bytes, if the system reports it (Linux does).
pub fn peak_rss_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phases_are_timed_and_unknown_names_ignored() {
        let mut phases = Phases::new(&["read", "write"]);
        phases.enter("read");
        std::thread::sleep(std::time::Duration::from_millis(5));
        phases.enter("no such phase");
        phases.leave();
        assert!(phases.secs_of("read") >= 0.005);
        assert!(phases.total_secs() >= phases.secs_of("read"));
        assert_eq!(phases.secs_of("write"), 0.0);
        let json = serde_json::to_value(&phases).expect("phases are plain numbers");
        assert_eq!(json.as_object().map(serde_json::Map::len), Some(2));
    }
}
