//! Printing: data goes to stdout, messages to stderr. Progress is a bar in a terminal, and a line every ten seconds
//! in a pipe or a log.

use std::fmt::Write as _;
use std::io::{self, IsTerminal, Write};
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;
use striata::Progress;
use striata_io::Warning;

#[cfg(feature = "gpu")]
use crate::args::DriverArgs;
use crate::args::ReportArgs;
use crate::failure::Failure;

/// Prints reports and messages in the way that the user asked for.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    json: bool,
    quiet: bool,
    is_strict: bool,
    /// Warnings about inputs so far; [`None`] if nothing is printed.
    warnings: Option<&'static Mutex<Vec<Warning>>>,
    #[cfg(feature = "gpu")]
    verbose: bool,
    draws_bars: bool,
}

impl Output {
    /// Follows the flags of the user, with progress bars only if stderr is a terminal.
    pub fn new(args: ReportArgs) -> Self {
        let draws_bars = !args.quiet && io::stderr().is_terminal();
        Self {
            json: args.json,
            quiet: args.quiet,
            is_strict: args.strict_input,
            // One short list for the whole run, so that this type can be copied.
            warnings: Some(Box::leak(Box::default())),
            #[cfg(feature = "gpu")]
            verbose: false,
            draws_bars,
        }
    }

    /// Prints no messages and no progress.
    pub fn quiet() -> Self {
        Self {
            json: false,
            quiet: true,
            is_strict: false,
            warnings: None,
            #[cfg(feature = "gpu")]
            verbose: false,
            draws_bars: false,
        }
    }

    /// Adds the flag for messages of graphics drivers, and starts logging if it is set.
    #[cfg(feature = "gpu")]
    pub fn with_drivers(self, args: DriverArgs) -> Self {
        if args.verbose {
            let env = env_logger::Env::default().default_filter_or("info");
            // Fails only if a logger is running already.
            let _ = env_logger::Builder::from_env(env).try_init();
        }
        Self { verbose: args.verbose, ..self }
    }

    /// Whether to show messages of graphics drivers and libraries.
    #[cfg(feature = "gpu")]
    pub fn is_verbose(&self) -> bool {
        self.verbose
    }

    /// Checks that stdout does not have to take both a JSON report and the output.
    ///
    /// # Errors
    /// If both would be written to stdout.
    pub fn check_stdout_is_free(&self, output_to_stdout: bool) -> Result<(), Failure> {
        if self.json && output_to_stdout {
            return Err(Failure::usage("--json and the output cannot both go to stdout")
                .with_hint("write the output to a file"));
        }
        Ok(())
    }

    /// Prints the result of a verb whose result is a report: to stdout, as text or JSON.
    ///
    /// # Errors
    /// If stdout cannot be written to.
    pub fn data(&self, report: &impl Serialize, text: &str) -> Result<(), Failure> {
        if self.json { self.json_object(report) } else { to_stdout(text.as_bytes()) }
    }

    /// Prints a report about a file that was written: JSON to stdout, or text to stderr.
    ///
    /// # Errors
    /// If stdout cannot be written to.
    pub fn summary(&self, report: &impl Serialize, text: &str) -> Result<(), Failure> {
        if self.json {
            return self.json_object(report);
        }
        self.say(text);
        Ok(())
    }

    /// Prints a message to stderr, unless the user wants errors only.
    pub fn say(&self, text: &str) {
        if !self.quiet {
            // A closed stderr is no reason to fail.
            let _ = writeln!(io::stderr(), "{}", text.trim_end());
        }
    }

    /// Warns of what was left out of an input, or repaired; what was said before is not repeated.
    ///
    /// # Errors
    /// If there is something to warn of, and the user wants that to be an error.
    pub fn warn(&self, warnings: &[Warning]) -> Result<(), Failure> {
        let Some(known) = self.warnings else { return Ok(()) };
        let mut known = known.lock().unwrap_or_else(PoisonError::into_inner);
        for warning in warnings {
            if known.contains(warning) {
                continue;
            }
            if self.is_strict {
                let more = format_noun_count(warnings.len() - 1, "more warning", "more warnings");
                let more = if warnings.len() > 1 { format!(" (and {more})") } else { String::new() };
                return Err(Failure::user(format!("{warning}{more}"))
                    .with_hint("correct the input, or remove --strict-input to use it as far as possible"));
            }
            self.say(&format!("warning: {warning}"));
            known.push(warning.clone());
        }
        Ok(())
    }

    /// Warns of what the format of an output cannot store; that is never an error.
    pub fn warn_of_losses(&self, losses: &[Warning]) {
        let warned = Self { is_strict: false, ..*self }.warn(losses);
        debug_assert!(warned.is_ok(), "only strict inputs are errors");
    }

    /// Creates a progress bar for the progress callbacks of the library; if stderr is no terminal, lines take its
    /// place.
    pub fn bar(&self) -> Bar {
        let target =
            if self.draws_bars { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(0), target);
        let style = ProgressStyle::with_template("{msg:<10} {bar:40} {percent:>3}% {eta}");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        let lines = (!self.quiet && !self.draws_bars).then(ProgressLines::default);
        Bar { bar, phase: "", lines }
    }

    fn json_object(&self, report: &impl Serialize) -> Result<(), Failure> {
        let failed = |e: serde_json::Error| Failure::internal(format!("report: {e}"));
        let mut bytes = serde_json::to_vec(report).map_err(failed)?;
        let warnings = self.warnings.map(|known| known.lock().unwrap_or_else(PoisonError::into_inner));
        if bytes.len() > 2 && bytes.ends_with(b"}") {
            let warnings: Vec<_> = warnings.iter().flat_map(|known| known.iter()).map(json_of).collect();
            bytes.pop();
            bytes.extend_from_slice(b",\"warnings\":");
            bytes.extend(serde_json::to_vec(&warnings).map_err(failed)?);
            bytes.push(b'}');
        }
        bytes.push(b'\n');
        to_stdout(&bytes)
    }
}

/// A warning in a JSON report.
fn json_of(warning: &Warning) -> serde_json::Value {
    serde_json::json!({
        "file": warning.file,
        "place": warning.place.to_string(),
        "count": warning.count,
        "what": warning.what(),
        "reason": warning.reason,
        "message": warning.to_string(),
    })
}

/// A progress bar for one run.
#[derive(Debug)]
pub struct Bar {
    bar: ProgressBar,
    phase: &'static str,
    lines: Option<ProgressLines>,
}

/// Progress in lines, for logs and pipes: those who wait see that the command is alive.
#[derive(Debug)]
struct ProgressLines {
    started: Instant,
    /// Time from the start to the next line.
    next: Duration,
}

impl ProgressLines {
    const INTERVAL: Duration = Duration::from_secs(10);

    /// Returns the line that is due so long after the start, if one is.
    fn due(&mut self, elapsed: Duration, progress: Progress) -> Option<String> {
        if elapsed < self.next {
            return None;
        }
        self.next = elapsed + Self::INTERVAL;
        let Progress { phase, done, total } = progress;
        // The length of a phase with a single step is unknown.
        let share = if total > 1 { format!(" {}%", done.saturating_mul(100) / total) } else { String::new() };
        Some(format!("{phase}{share}, {} s", elapsed.as_secs()))
    }
}

impl Default for ProgressLines {
    fn default() -> Self {
        Self { started: Instant::now(), next: Self::INTERVAL }
    }
}

impl Bar {
    /// Shows that a phase of unknown length has begun.
    pub fn phase(&mut self, phase: &'static str) {
        let _ = self.show(Progress { phase, done: 0, total: 1 });
    }

    /// Shows the completed fraction of a phase, 0 to 1.
    pub fn share(&mut self, phase: &'static str, share: f64) {
        let _ = self.show(Progress { phase, done: (1000.0 * share) as u64, total: 1000 });
    }

    /// Shows the progress that the library reports; never cancels.
    pub fn show(&mut self, progress: Progress) -> ControlFlow<()> {
        if self.phase != progress.phase {
            self.phase = progress.phase;
            self.bar.reset_eta();
            self.bar.set_message(progress.phase);
        }
        self.bar.set_length(progress.total);
        self.bar.set_position(progress.done);
        if let Some(line) = self.lines.as_mut().and_then(|lines| lines.due(lines.started.elapsed(), progress))
        {
            // A closed stderr is no reason to fail.
            let _ = writeln!(io::stderr(), "{line}");
        }
        ControlFlow::Continue(())
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Writes bytes to stdout. A reader that has gone away (`| head`) is not an error.
///
/// # Errors
/// If stdout cannot be written to.
pub fn to_stdout(bytes: &[u8]) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(bytes).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::user(format!("stdout: {error}")))
        }
        _ => Ok(()),
    }
}

/// Formats a number with commas between groups of three digits.
pub fn format_count(number: usize) -> String {
    let digits = number.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

/// Formats a count with its noun: `1 triangle`, `1,000 triangles`.
pub fn format_noun_count(count: usize, one: &str, many: &str) -> String {
    format!("{} {}", format_count(count), if count == 1 { one } else { many })
}

/// Formats a size in bytes, in B, kB, MB or GB.
pub fn format_bytes(bytes: usize) -> String {
    match bytes {
        0..10_000 => format!("{bytes} B"),
        10_000..1_000_000 => format!("{:.1} kB", bytes as f64 / 1e3),
        1_000_000..10_000_000_000 => format!("{:.2} MB", bytes as f64 / 1e6),
        _ => format!("{:.2} GB", bytes as f64 / 1e9),
    }
}

/// Formats a length in mesh units with enough significant digits at any scale.
pub fn format_length(length: f64) -> String {
    match length.abs() {
        size if size == 0.0 || (1e-4..1e7).contains(&size) => format!("{length:.6}"),
        _ => format!("{length:.3e}"),
    }
}

/// Formats a duration in seconds, in µs, ms, s or minutes.
pub fn format_duration(secs: f64) -> String {
    if secs < 0.001 {
        format!("{:.0} µs", secs * 1e6)
    } else if secs < 1.0 {
        format!("{:.1} ms", secs * 1e3)
    } else if secs < 600.0 {
        format!("{secs:.2} s")
    } else {
        format!("{:.1} min", secs / 60.0)
    }
}

/// A text table: the first column is aligned to the left, the others to the right.
#[derive(Debug, Default)]
pub struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    /// Widest column. Longer cells overflow instead of moving all others to the right.
    const MAX_WIDTH: usize = 64;

    /// Creates a table with a header row.
    pub fn with_head(head: &[&str]) -> Self {
        Self { rows: vec![head.iter().map(|&cell| cell.to_owned()).collect()] }
    }

    /// Appends a row.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// Formats the table; every line ends with a newline.
    pub fn to_text(&self) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |c: usize| self.rows.iter().filter_map(move |r| r.get(c)).map(|s| s.chars().count());
        let widths: Vec<usize> = (0..columns)
            .map(|c| width(c).filter(|&width| width <= Self::MAX_WIDTH).max().unwrap_or(0))
            .collect();
        let mut text = String::new();
        for row in &self.rows {
            let mut line = String::new();
            for (column, cell) in row.iter().enumerate() {
                let width = widths[column];
                // Writing to a string cannot fail.
                let _ = if column == 0 {
                    write!(line, "{cell:<width$}")
                } else {
                    write!(line, "  {cell:>width$}")
                };
            }
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_grouped_by_three() {
        assert_eq!(format_count(0), "0");
        assert_eq!(format_count(999), "999");
        assert_eq!(format_count(1000), "1,000");
        assert_eq!(format_count(1_234_567), "1,234,567");
    }

    #[test]
    fn lengths_have_significant_digits_at_any_scale() {
        assert_eq!(format_length(0.0), "0.000000");
        assert_eq!(format_length(1.25), "1.250000");
        assert_eq!(format_length(8.76e-11), "8.760e-11");
        assert_eq!(format_length(7.07e29), "7.070e29");
    }

    #[test]
    fn lines_of_progress_are_ten_seconds_apart() {
        let mut lines = ProgressLines::default();
        let mut due = |secs, done, total| {
            lines.due(Duration::from_secs(secs), Progress { phase: "simplify", done, total })
        };
        assert_eq!(due(9, 1, 10), None);
        assert_eq!(due(12, 2, 10).as_deref(), Some("simplify 20%, 12 s"));
        assert_eq!(due(21, 3, 10), None);
        assert_eq!(due(22, 0, 1).as_deref(), Some("simplify, 22 s"));
    }

    #[test]
    fn a_long_cell_does_not_move_others() {
        let mut table = Table::default();
        table.row(vec!["names".to_owned(), "x".repeat(200)]);
        table.row(vec!["count".to_owned(), "7".to_owned()]);
        assert!(table.to_text().ends_with("\ncount  7\n"));
    }

    #[test]
    fn tables_align_their_columns() {
        let mut table = Table::with_head(&["level", "triangles"]);
        table.row(vec!["full".to_owned(), "99,938".to_owned()]);
        assert_eq!(table.to_text(), "level  triangles\nfull      99,938\n");
    }
}
