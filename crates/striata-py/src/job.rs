//! Runs long calls on a worker thread, so that Python goes on and Ctrl-C works.
//!
//! The calling thread releases the interpreter and wakes every 20 ms to look for signals and to report
//! progress. If a signal handler or the caller's progress function raises an exception, the caller gets it at
//! once. The work goes on in the background until it reports progress next, stops there, and its result is
//! dropped; work therefore owns what it uses. Calls that take less than about a millisecond run on the calling
//! thread.

use std::any::Any;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;
use striata::{Progress, ProgressFn};

use crate::errors::{Outcome, internal_error};
use crate::pool;

/// Time between two looks at signals.
const WAKE_INTERVAL: Duration = Duration::from_millis(20);
/// Amount of work, in triangles or the like, below which a thread costs more than it is worth.
const SMALL: usize = 400;
/// Names of the phases that the library reports.
const UNKNOWN_PHASE: &str = "striata";

/// State that both threads see.
struct JobState<T> {
    is_cancelled: AtomicBool,
    done: AtomicU64,
    total: AtomicU64,
    phase: Mutex<&'static str>,
    outcome: Mutex<Option<thread::Result<Outcome<T>>>>,
    is_finished: Condvar,
}

/// Runs `work` on `size` triangles (or anything that takes about as long), and calls `progress` with phase,
/// done and total from time to time.
pub(crate) fn run<T, F>(
    py: Python<'_>,
    size: usize,
    progress: Option<&Bound<'_, PyAny>>,
    work: F,
) -> Outcome<T>
where
    T: Send + 'static,
    F: FnOnce(&mut ProgressFn<'_>) -> Outcome<T> + Send + 'static,
{
    if size < SMALL && progress.is_none() {
        let run = AssertUnwindSafe(|| work(&mut striata::ignore_progress));
        return catch_unwind(run).unwrap_or_else(|panic| Err(panic_error(&*panic)));
    }
    let shared = Arc::new(JobState {
        is_cancelled: AtomicBool::new(false),
        done: AtomicU64::new(0),
        total: AtomicU64::new(0),
        phase: Mutex::new(UNKNOWN_PHASE),
        outcome: Mutex::new(None),
        is_finished: Condvar::new(),
    });
    let worker = Arc::clone(&shared);
    let name = thread::Builder::new().name("striata".to_owned());
    name.spawn(move || worker.work(work)).map_err(|error| internal_error(format!("no thread: {error}")))?;
    let outcome = shared.wait(py, progress);
    if outcome.is_err() {
        shared.is_cancelled.store(true, Ordering::Relaxed);
    }
    outcome
}

impl<T: Send> JobState<T> {
    fn work(&self, work: impl FnOnce(&mut ProgressFn<'_>) -> Outcome<T> + Send) {
        let mut report = |now: Progress| self.report(now);
        let report: &mut (dyn FnMut(Progress) -> ControlFlow<()> + Send) = &mut report;
        let mut forward = move |now: Progress| report(now);
        let outcome = catch_unwind(AssertUnwindSafe(|| pool::install(move || work(&mut forward))));
        *self.outcome.lock().unwrap_or_else(PoisonError::into_inner) = Some(outcome);
        self.is_finished.notify_all();
    }

    fn report(&self, now: Progress) -> ControlFlow<()> {
        self.done.store(now.done, Ordering::Relaxed);
        self.total.store(now.total, Ordering::Relaxed);
        *self.phase.lock().unwrap_or_else(PoisonError::into_inner) = now.phase;
        match self.is_cancelled.load(Ordering::Relaxed) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }

    fn wait(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> Outcome<T> {
        loop {
            let outcome = py.detach(|| self.outcome_within(WAKE_INTERVAL));
            if let Some(outcome) = outcome {
                self.call(progress)?;
                return outcome.unwrap_or_else(|panic| Err(panic_error(&*panic)));
            }
            py.check_signals()?;
            self.call(progress)?;
        }
    }

    fn outcome_within(&self, time: Duration) -> Option<thread::Result<Outcome<T>>> {
        let outcome = self.outcome.lock().unwrap_or_else(PoisonError::into_inner);
        let wait = self.is_finished.wait_timeout_while(outcome, time, |outcome| outcome.is_none());
        wait.unwrap_or_else(PoisonError::into_inner).0.take()
    }

    fn call(&self, progress: Option<&Bound<'_, PyAny>>) -> Outcome<()> {
        let Some(progress) = progress else { return Ok(()) };
        let phase = *self.phase.lock().unwrap_or_else(PoisonError::into_inner);
        let (done, total) = (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed));
        progress.call1((phase, done.min(total), total))?;
        Ok(())
    }
}

fn panic_error(panic: &(dyn Any + Send)) -> PyErr {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    internal_error(text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("unknown"))
}
