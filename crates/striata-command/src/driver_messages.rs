//! Keeps the messages of graphics drivers off the terminal.
//!
//! Drivers and the libraries below them write to the process's standard error themselves, about things that a user cannot do
//! anything about (`XDG_RUNTIME_DIR is invalid or not set`). While adapters are tried, file descriptor 2 leads nowhere; what was
//! found is then reported in one line of our own. `--verbose` leaves everything as it is.

use crate::output::Output;

/// Runs `work` with the standard error of the process leading nowhere, unless the user asked for details.
pub fn without_driver_messages<T>(output: &Output, work: impl FnOnce() -> T) -> T {
    if output.is_verbose() {
        return work();
    }
    let _hush = Hush::new();
    work()
}

/// Standard error leads nowhere as long as this lives.
#[cfg(unix)]
struct Hush {
    /// Where it led before.
    before: Option<rustix::fd::OwnedFd>,
}

#[cfg(unix)]
impl Hush {
    fn new() -> Self {
        // If any of this fails, the messages are seen, which is no reason to stop.
        let before = rustix::io::fcntl_dupfd_cloexec(rustix::stdio::stderr(), 3).ok();
        let nowhere = std::fs::OpenOptions::new().write(true).open("/dev/null").ok();
        if let (Some(_), Some(nowhere)) = (&before, nowhere) {
            let _ = rustix::stdio::dup2_stderr(nowhere);
        }
        Self { before }
    }
}

#[cfg(unix)]
impl Drop for Hush {
    fn drop(&mut self) {
        if let Some(before) = self.before.take() {
            let _ = rustix::stdio::dup2_stderr(before);
        }
    }
}

/// Drivers of other systems keep their messages to themselves.
#[cfg(not(unix))]
struct Hush;

#[cfg(not(unix))]
impl Hush {
    fn new() -> Self {
        Self
    }
}
