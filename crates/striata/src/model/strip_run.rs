//! Drops a run of a strip's indices in place, and restores it.

/// A run of consecutive live indices of a strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Run {
    /// Index of the first index of the run.
    pub first: u32,
    /// Length of the run, at least 1.
    pub count: u32,
}

/// Moves a run behind the remaining live indices; the caller then shortens the live part by `run.count`.
#[inline]
pub(super) fn drop_run(live: &mut [u32], run: Run) {
    let (first, count) = (run.first as usize, run.count as usize);
    let tail = &mut live[first..];
    if let (2, &[a, b, ..]) = (count, &*tail) {
        let rest = tail.len() - 2;
        tail.copy_within(2.., 0);
        tail[rest] = a;
        tail[rest + 1] = b;
    } else {
        tail.rotate_left(count);
    }
}

/// Moves the last `run.count` indices, which the caller has just added back to the live part, to where the
/// run was.
#[inline]
pub(super) fn restore_run(live: &mut [u32], run: Run) {
    let (first, count) = (run.first as usize, run.count as usize);
    let tail = &mut live[first..];
    if let (2, &[.., a, b]) = (count, &*tail) {
        let rest = tail.len() - 2;
        tail.copy_within(..rest, 2);
        tail[0] = a;
        tail[1] = b;
    } else {
        tail.rotate_right(count);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn restoring_undoes_dropping() {
        for (first, count) in [(0, 2), (1, 2), (3, 2), (0, 5), (2, 1), (1, 4)] {
            let mut slot = [10, 11, 12, 13, 14];
            drop_run(&mut slot, Run { first, count });
            let expected: Vec<u32> = (10..10 + first).chain(10 + first + count..15).collect();
            assert_eq!(slot[..5 - count as usize], expected);
            restore_run(&mut slot, Run { first, count });
            assert_eq!(slot, [10, 11, 12, 13, 14]);
        }
    }
}
