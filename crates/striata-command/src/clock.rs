//! Time spent in each phase of a run, and its peak memory.

use std::time::Instant;

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use serde_json::{Map, Value, json};

use crate::output::Table;

/// A clock that times the phases of one run; a phase lasts until the next one begins.
#[derive(Debug)]
pub struct Phases {
    started: Moment,
    entered: Moment,
    current: Option<usize>,
    spent: Vec<(&'static str, Spent)>,
}

/// A moment by the clock and in the CPU time of the process.
#[derive(Clone, Copy, Debug)]
struct Moment {
    at: Instant,
    cpu_secs: Option<f64>,
}

/// Seconds by the clock, and CPU seconds of all threads if the system reports them.
#[derive(Clone, Copy, Debug)]
struct Spent {
    secs: f64,
    cpu_secs: Option<f64>,
}

impl Moment {
    fn now() -> Self {
        Self { at: Instant::now(), cpu_secs: cpu_secs() }
    }

    fn since(self, earlier: Self) -> Spent {
        let cpu_secs = self.cpu_secs.zip(earlier.cpu_secs).map(|(now, then)| now - then);
        Spent { secs: (self.at - earlier.at).as_secs_f64(), cpu_secs }
    }
}

impl Spent {
    fn add(&mut self, more: Self) {
        self.secs += more.secs;
        self.cpu_secs = self.cpu_secs.zip(more.cpu_secs).map(|(own, more)| own + more);
    }
}

/// Returns the CPU time that the process has used, in seconds, if the system reports it.
fn cpu_secs() -> Option<f64> {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        Some(time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64)
    }
    #[cfg(not(unix))]
    None
}

impl Phases {
    /// Starts a clock for the named phases; all of them are reported, whether entered or not.
    pub fn new(names: &[&'static str]) -> Self {
        let now = Moment::now();
        let nothing = now.since(now);
        let spent = names.iter().map(|&name| (name, nothing)).collect();
        Self { started: now, entered: now, current: None, spent }
    }

    /// Ends the current phase and begins another; does nothing if the name is unknown or already current.
    pub fn enter(&mut self, name: &str) {
        let Some(next) = self.spent.iter().position(|&(known, _)| known == name) else { return };
        if self.current == Some(next) {
            return;
        }
        self.leave();
        self.current = Some(next);
    }

    /// Ends the current phase.
    pub fn leave(&mut self) {
        let now = Moment::now();
        if let Some(phase) = self.current.take() {
            self.spent[phase].1.add(now.since(self.entered));
        }
        self.entered = now;
    }

    /// Returns the seconds spent in a phase so far.
    pub fn secs_of(&self, name: &str) -> f64 {
        self.spent.iter().filter(|(known, _)| *known == name).map(|(_, spent)| spent.secs).sum()
    }

    /// Returns the seconds since the clock was started.
    pub fn total_secs(&self) -> f64 {
        self.started.at.elapsed().as_secs_f64()
    }

    /// Returns a table of the seconds and the CPU seconds of each phase, and of the whole run.
    pub fn to_text(&self) -> String {
        let mut table = Table::default();
        table.row(["stage", "s", "CPU s"].map(str::to_owned).to_vec());
        let total = ("total", Moment::now().since(self.started));
        for (name, Spent { secs, cpu_secs }) in self.spent.iter().chain([&total]) {
            let cpu = cpu_secs.map_or("not known".to_owned(), |secs| format!("{secs:.2}"));
            table.row(vec![(*name).to_owned(), format!("{secs:.2}"), cpu]);
        }
        table.to_text()
    }
}

/// Serializes the members `phases` and `cpu_phases`, seconds by name, and `secs`, the seconds of the whole run.
impl Serialize for Phases {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let by_name = |secs_of: fn(&Spent) -> Option<f64>| -> Map<String, Value> {
            self.spent.iter().map(|(name, spent)| ((*name).to_owned(), json!(secs_of(spent)))).collect()
        };
        let mut map = serializer.serialize_map(Some(3))?;
        map.serialize_entry("phases", &by_name(|spent| Some(spent.secs)))?;
        map.serialize_entry("cpu_phases", &by_name(|spent| spent.cpu_secs))?;
        map.serialize_entry("secs", &self.total_secs())?;
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
        for member in ["phases", "cpu_phases"] {
            assert_eq!(json[member].as_object().map(Map::len), Some(2), "{member}");
        }
        assert!(json["secs"].as_f64() >= json["phases"]["read"].as_f64());
        let names: Vec<String> = phases
            .to_text()
            .lines()
            .filter_map(|line| line.split_whitespace().next().map(str::to_owned))
            .collect();
        assert_eq!(names, ["stage", "read", "write", "total"]);
    }

    #[cfg(unix)]
    #[test]
    fn work_counts_as_cpu_time() {
        let mut phases = Phases::new(&["work"]);
        phases.enter("work");
        let started = cpu_secs().expect("unix reports it");
        while cpu_secs().is_some_and(|now| now < started + 0.01) {}
        phases.leave();
        let json = serde_json::to_value(&phases).expect("phases are plain numbers");
        assert!(json["cpu_phases"]["work"].as_f64() >= Some(0.01), "{json}");
    }
}
