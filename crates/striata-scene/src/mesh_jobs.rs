//! Runs a job for each mesh of a scene, on several threads if the feature `parallel` is enabled.
//!
//! Results do not depend on the number of threads. Jobs begin with the largest mesh, which would otherwise be the last
//! one for which all others wait. Progress of all jobs arrives at the caller's callback on the caller's thread.

use std::collections::HashMap;
use std::ops::ControlFlow;

use striata::mesh::IndexedMesh;
use striata::{Cancelled, Progress, ProgressFn};

/// Time for which a thread waits for others before it looks for other work.
#[cfg(feature = "parallel")]
const WAIT: std::time::Duration = std::time::Duration::from_millis(10);

/// A mesh that a job has failed for, and why.
pub(crate) struct MeshFailure<E> {
    /// Index of the mesh.
    pub mesh: usize,
    pub error: E,
}

/// Runs a job for each mesh; equal meshes that are alike in everything else, such as one ball in many colors, share a
/// result. Indices are those of `meshes`.
///
/// # Errors
/// The failure of the first mesh that has one.
pub(crate) fn for_each_distinct<T: Clone + Send, E: From<Cancelled> + Send>(
    meshes: &[Option<IndexedMesh>],
    is_alike: impl Fn([usize; 2]) -> bool,
    job: impl Fn(usize, &IndexedMesh, &mut ProgressFn<'_>) -> Result<T, E> + Sync,
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<Option<T>>, MeshFailure<E>> {
    let mut first_of: HashMap<[u64; 2], usize> = HashMap::new();
    let source = |(index, mesh): (usize, &Option<IndexedMesh>)| {
        let first = *first_of.entry(mesh.as_ref()?.fingerprints()).or_insert(index);
        Some(if first < index && is_alike([first, index]) { first } else { index })
    };
    let sources: Vec<Option<usize>> = meshes.iter().enumerate().map(source).collect();
    let size = |(index, mesh): (usize, &Option<IndexedMesh>)| {
        Some(mesh.as_ref()?.triangle_count()).filter(|_| sources[index] == Some(index))
    };
    let sizes: Vec<Option<usize>> = meshes.iter().enumerate().map(size).collect();
    let job = |index: usize, progress: &mut ProgressFn<'_>| match &meshes[index] {
        Some(mesh) => job(index, mesh, progress).map(Some),
        None => Ok(None),
    };
    let made = for_each_size(&sizes, job, progress)?;
    Ok(sources.into_iter().map(|source| made[source?].clone().flatten()).collect())
}

/// Runs a job for each item that has a size, which says how much work it is.
///
/// # Errors
/// The failure of the first item that has one; that of being cancelled if the callback cancels.
pub(crate) fn for_each_size<T: Send, E: From<Cancelled> + Send>(
    sizes: &[Option<usize>],
    job: impl Fn(usize, &mut ProgressFn<'_>) -> Result<T, E> + Sync,
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<Option<T>>, MeshFailure<E>> {
    let mut order: Vec<usize> = (0..sizes.len()).filter(|&index| sizes[index].is_some()).collect();
    order.sort_by_key(|&index| std::cmp::Reverse(sizes[index]));
    let mut sum = SummedProgress::new(sizes);
    let mut is_cancelled = false;
    let mut report = |number: usize, now: Progress| {
        let answer = progress(sum.after(order[number], now));
        is_cancelled |= answer.is_break();
        answer
    };
    // Small items report nothing themselves.
    let jobs = |number: usize, progress: &mut ProgressFn<'_>| -> Result<T, E> {
        let at = |done: u64| Progress { phase: "simplify", done, total: 1 };
        at(0).report(progress)?;
        let made = job(order[number], progress)?;
        at(1).report(progress)?;
        Ok(made)
    };
    let mut made: Vec<Option<T>> = sizes.iter().map(|_| None).collect();
    let mut failure: Option<MeshFailure<E>> = None;
    let results = run(order.len(), jobs, &mut report);
    if is_cancelled {
        // Jobs may have ended before they heard of it.
        return Err(MeshFailure { mesh: order.first().copied().unwrap_or(0), error: Cancelled.into() });
    }
    for (number, result) in results {
        match (order[number], result) {
            (mesh, Ok(result)) => made[mesh] = Some(result),
            (mesh, Err(error)) => {
                if failure.as_ref().is_none_or(|failure| mesh < failure.mesh) {
                    failure = Some(MeshFailure { mesh, error });
                }
            }
        }
    }
    failure.map_or(Ok(made), Err)
}

/// Results of a function for the numbers below `count`, in their order.
pub(crate) fn map<T: Send>(count: usize, run_one: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let results = run(count, |number, _| run_one(number), &mut |_, _| ControlFlow::Continue(()));
    results.into_iter().map(|(_, result)| result).collect()
}

/// Runs jobs 0 to `count`, which begin in this order; returns their results with their numbers, in order.
fn run<T: Send>(
    count: usize,
    job: impl Fn(usize, &mut ProgressFn<'_>) -> T + Sync,
    report: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
) -> Vec<(usize, T)> {
    #[cfg(feature = "parallel")]
    if count > 1 && rayon::current_num_threads() > 1 {
        return run_parallel(count, job, report);
    }
    (0..count).map(|number| (number, job(number, &mut |now| report(number, now)))).collect()
}

/// Runs jobs on the caller's thread and on those of the current pool of rayon, of which the caller's may be one. Only the
/// caller's thread reports.
#[cfg(feature = "parallel")]
fn run_parallel<T: Send>(
    count: usize,
    job: impl Fn(usize, &mut ProgressFn<'_>) -> T + Sync,
    report: &mut dyn FnMut(usize, Progress) -> ControlFlow<()>,
) -> Vec<(usize, T)> {
    use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
    use std::sync::mpsc::{RecvTimeoutError, channel};
    use std::sync::{Mutex, PoisonError};

    let (next, is_cancelled) = (AtomicUsize::new(0), AtomicBool::new(false));
    let results = Mutex::new(Vec::with_capacity(count));
    let run_all = |tell: &mut dyn FnMut(usize, Progress)| {
        // Each thread takes the next number when it is free.
        while let Some(number) = Some(next.fetch_add(1, Relaxed)).filter(|&number| number < count) {
            let result = job(number, &mut |now| {
                tell(number, now);
                if is_cancelled.load(Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            results.lock().unwrap_or_else(PoisonError::into_inner).push((number, result));
        }
    };
    let mut report = |number: usize, now: Progress| {
        if !is_cancelled.load(Relaxed) && report(number, now).is_break() {
            is_cancelled.store(true, Relaxed);
        }
    };
    rayon::in_place_scope(|scope| {
        let (sender, receiver) = channel();
        for _ in 1..rayon::current_num_threads().min(count) {
            let (sender, run_all) = (sender.clone(), &run_all);
            scope.spawn(move |_| {
                run_all(&mut |number, now| {
                    // The receiver lives as long as the scope.
                    let _ = sender.send((number, now));
                });
            });
        }
        drop(sender);
        run_all(&mut |number, now| {
            receiver.try_iter().for_each(|(number, now)| report(number, now));
            report(number, now);
        });
        // The other threads still run.
        loop {
            match receiver.recv_timeout(WAIT) {
                Ok((number, now)) => report(number, now),
                Err(RecvTimeoutError::Disconnected) => break,
                // Jobs of this or another call may wait for this thread.
                Err(RecvTimeoutError::Timeout) => {
                    let _ = rayon::yield_now();
                }
            }
        }
    });
    let mut results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    results.sort_by_key(|&(number, _)| number);
    results
}

/// Progress over all items, in their sizes.
struct SummedProgress {
    sizes: Vec<u64>,
    done: Vec<u64>,
    sum: u64,
    total: u64,
}

impl SummedProgress {
    fn new(sizes: &[Option<usize>]) -> Self {
        let sizes: Vec<u64> = sizes.iter().map(|size| size.unwrap_or(0) as u64).collect();
        Self { done: vec![0; sizes.len()], sum: 0, total: sizes.iter().sum(), sizes }
    }

    /// Progress after an item has reported its own.
    fn after(&mut self, index: usize, now: Progress) -> Progress {
        let share = if now.total == 0 { 0.0 } else { now.done as f64 / now.total as f64 };
        let done = ((share.min(1.0) * self.sizes[index] as f64) as u64).max(self.done[index]);
        self.sum += done - self.done[index];
        self.done[index] = done;
        Progress { phase: now.phase, done: self.sum, total: self.total }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs jobs that report twice; returns results and the numbers that were reported.
    fn run_all(
        sizes: &[Option<usize>],
        fails: impl Fn(usize) -> bool + Sync,
        mut is_ended: impl FnMut(Progress) -> bool,
    ) -> Result<Vec<Option<usize>>, MeshFailure<String>> {
        let job = |index: usize, progress: &mut ProgressFn<'_>| -> Result<usize, String> {
            for done in 0..2 {
                let now = Progress { phase: "simplify", done, total: 2 };
                if progress(now).is_break() {
                    return Err("cancelled".to_owned());
                }
            }
            if fails(index) { Err(format!("job {index}")) } else { Ok(10 * index) }
        };
        let job = |index: usize, progress: &mut ProgressFn<'_>| job(index, progress).map_err(Failure);
        let mut progress =
            |now| if is_ended(now) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
        for_each_size(sizes, job, &mut progress)
            .map_err(|MeshFailure { mesh, error }| MeshFailure { mesh, error: error.0 })
    }

    struct Failure(String);

    impl From<Cancelled> for Failure {
        fn from(_: Cancelled) -> Self {
            Self("cancelled".to_owned())
        }
    }

    #[test]
    fn results_are_in_order_and_progress_adds_up() {
        let sizes: Vec<Option<usize>> = (0..40).map(|i| (i % 3 != 1).then_some(i * 7 % 11)).collect();
        let mut last = 0;
        let made = run_all(
            &sizes,
            |_| false,
            |now| {
                assert!(now.done >= last && now.done <= now.total, "{now:?} after {last}");
                last = now.done;
                false
            },
        );
        let Ok(made) = made else { panic!("no job fails") };
        let expected: Vec<_> = (0..40).map(|i| (i % 3 != 1).then_some(10 * i)).collect();
        assert_eq!(made, expected);
        assert_eq!(last, sizes.iter().flatten().sum::<usize>() as u64);
        assert_eq!(map(5, |i| i * i), [0, 1, 4, 9, 16]);
    }

    #[test]
    fn the_first_failure_counts_whichever_job_ends_first() {
        let sizes: Vec<Option<usize>> = (0..30).map(Some).collect();
        let Err(failure) = run_all(&sizes, |index| index % 7 == 5, |_| false) else { panic!("jobs fail") };
        assert_eq!((failure.mesh, failure.error.as_str()), (5, "job 5"));
    }

    #[cfg(feature = "parallel")]
    #[test]
    fn jobs_of_jobs_end_in_a_small_pool() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("two threads");
        let sums = pool.install(|| map(8, |i| map(8, |j| map(3, |k| i * j * k).iter().sum::<usize>())));
        for (i, sums) in sums.iter().enumerate() {
            assert!(sums.iter().enumerate().all(|(j, &sum)| sum == 3 * i * j), "{sums:?}");
        }
    }

    #[test]
    fn cancelling_ends_the_jobs_that_wait() {
        let sizes = vec![Some(1); 1000];
        let mut reports = 0;
        let made = run_all(
            &sizes,
            |_| false,
            |_| {
                reports += 1;
                reports == 3
            },
        );
        assert!(made.is_err_and(|failure| failure.error == "cancelled"));
        assert_eq!(reports, 3, "nothing is reported after that");
    }
}
