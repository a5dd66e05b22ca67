//! Keeps the messages of graphics drivers off the terminal.
//!
//! Drivers and the libraries below them write directly to the standard error of the process, about things
//! that a user cannot change (`XDG_RUNTIME_DIR is invalid or not set`). While adapters are probed, file
//! descriptor 2 is redirected to `/dev/null`; afterward striata reports in one line what was found. With
//! `--verbose` nothing is redirected.

use crate::output::Output;

/// Runs `work` with the standard error of the process discarded, unless the user gave `--verbose`.
pub fn without_driver_messages<T>(output: &Output, work: impl FnOnce() -> T) -> T {
    if output.is_verbose() {
        return work();
    }
    let _guard = StderrSilencer::new();
    work()
}

/// Discards standard error until it is dropped.
#[cfg(unix)]
struct StderrSilencer {
    /// The original standard error.
    before: Option<rustix::fd::OwnedFd>,
}

#[cfg(unix)]
impl StderrSilencer {
    fn new() -> Self {
        // If any of this fails, the messages are shown, which is no reason to stop.
        let before = rustix::io::fcntl_dupfd_cloexec(rustix::stdio::stderr(), 3).ok();
        let null = std::fs::OpenOptions::new().write(true).open("/dev/null").ok();
        if let (Some(_), Some(null)) = (&before, null) {
            let _ = rustix::stdio::dup2_stderr(null);
        }
        Self { before }
    }
}

#[cfg(unix)]
impl Drop for StderrSilencer {
    fn drop(&mut self) {
        if let Some(before) = self.before.take() {
            let _ = rustix::stdio::dup2_stderr(before);
        }
    }
}

/// Does nothing: drivers on other systems do not write to standard error.
#[cfg(not(unix))]
struct StderrSilencer;

#[cfg(not(unix))]
impl StderrSilencer {
    fn new() -> Self {
        Self
    }
}
