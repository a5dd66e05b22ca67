//! Threads for the library's parallel loops that survive a fork.
//!
//! A forked child has only the thread that called `fork`, so rayon's global pool would wait there forever for
//! threads that no longer exist. Work therefore runs in a pool of our own, which belongs to one process: the
//! first call in another process makes a new one. Nothing here waits for a lock that a fork could leave held.

use std::sync::Arc;

use arc_swap::ArcSwapOption;
use rayon::{ThreadPool, ThreadPoolBuilder};

struct ProcessPool {
    process: u32,
    pool: ThreadPool,
}

static POOL: ArcSwapOption<ProcessPool> = ArcSwapOption::const_empty();

/// Runs work so that its parallel loops use the threads of this process. Without threads, they run on this
/// one, with the same results.
pub(crate) fn install<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    match current() {
        Some(pool) => pool.pool.install(work),
        None => work(),
    }
}

fn current() -> Option<Arc<ProcessPool>> {
    let process = std::process::id();
    if let Some(pool) = POOL.load_full().filter(|pool| pool.process == process) {
        return Some(pool);
    }
    let pool = ThreadPoolBuilder::new().thread_name(|index| format!("striata-{index}")).build().ok()?;
    let pool = Arc::new(ProcessPool { process, pool });
    // The old pool's threads belong to another process, so dropping it could wait for them.
    std::mem::forget(POOL.swap(Some(Arc::clone(&pool))));
    Some(pool)
}
