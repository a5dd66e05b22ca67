//! Finds runs of indices that can be dropped from a strip without changing the triangles that it shows.
//!
//! Dropping a run of even length keeps the parity, and so the winding, of everything behind it. The run
//! can be dropped if, ignoring degenerate triangles, the triangles that touch it are exactly those that
//! form where its two ends are joined. This covers `aa(aa)+`, `ab(ab)+` and every stretch of degenerate
//! triangles that is longer than needed to get from one visible triangle to the next. At the end of a
//! strip nothing follows, so a run of any length can be dropped.

use super::strip_run::{Run, drop_run};

/// Longest run that is dropped from inside a strip in one piece; longer ones are dropped in several pieces.
const MAX_RUN: usize = 16;

/// Drops the runs that have become superfluous around the `changed` indices; returns the remaining live
/// length.
///
/// `changed` is consumed. The runs are appended to `drops` in the order in which they were dropped.
pub(super) fn drop_superfluous(slots: &mut [u32], changed: &mut Vec<u32>, drops: &mut Vec<Run>) -> usize {
    let mut length = slots.len();
    trim_end(slots, &mut length, drops);
    trim_start(slots, &mut length, changed, drops);
    while let Some(index) = changed.pop() {
        while let Some(run) = find_run(&slots[..length], index as usize) {
            apply(slots, &mut length, run, changed, drops);
        }
    }
    trim_end(slots, &mut length, drops);
    trim_start(slots, &mut length, changed, drops);
    length
}

fn apply(slots: &mut [u32], length: &mut usize, run: Run, changed: &mut [u32], drops: &mut Vec<Run>) {
    drop_run(&mut slots[..*length], run);
    *length -= run.count as usize;
    drops.push(run);
    for index in changed {
        if *index >= run.first {
            *index = (*index).saturating_sub(run.count).max(run.first);
        }
    }
}

fn is_degenerate(w: &[u32]) -> bool {
    w[0] == w[1] || w[1] == w[2] || w[2] == w[0]
}

fn trim_end(slots: &mut [u32], length: &mut usize, drops: &mut Vec<Run>) {
    let dead = slots[..*length].windows(3).rev().take_while(|w| is_degenerate(w)).count();
    let keep = if *length - dead < 3 { 0 } else { *length - dead };
    if keep < *length {
        let run = Run { first: keep as u32, count: (*length - keep) as u32 };
        apply(slots, length, run, &mut [], drops);
    }
}

fn trim_start(slots: &mut [u32], length: &mut usize, changed: &mut [u32], drops: &mut Vec<Run>) {
    let dead = slots[..*length].windows(3).take_while(|w| is_degenerate(w)).count();
    let count = (dead & !1) as u32;
    if count > 0 {
        apply(slots, length, Run { first: 0, count }, changed, drops);
    }
}

/// Returns the longest run near index `index` that can be dropped from inside the strip.
fn find_run(strip: &[u32], index: usize) -> Option<Run> {
    let mut best: Option<Run> = None;
    for first in index.saturating_sub(3).max(1)..=index + 2 {
        let mut shown = VisibleTriangles::default();
        for end in first..strip.len().min(first + MAX_RUN + 1) {
            // Triangles from `first - 2` to `end - 1` touch the run.
            let newest = if end == first { first.saturating_sub(2)..first } else { end - 1..end };
            for i in newest {
                shown.add(strip, i, i % 2 == 0);
            }
            if shown.count > 2 {
                break;
            }
            let count = (end - first) as u32;
            let is_longer = best.is_none_or(|b| count > b.count);
            if count > 0 && count.is_multiple_of(2) && is_longer && shown.same(&joined(strip, first, end)) {
                best = Some(Run { first: first as u32, count });
            }
        }
    }
    best
}

/// Returns the triangles that form where the ends of the strip are joined over the run `first..end` of
/// even length.
fn joined(strip: &[u32], first: usize, end: usize) -> VisibleTriangles {
    let start = first.saturating_sub(2);
    let mut around = [0; 4];
    let mut count = 0;
    for &v in strip[start..first].iter().chain(&strip[end..strip.len().min(end + 2)]) {
        around[count] = v;
        count += 1;
    }
    let mut shown = VisibleTriangles::default();
    for i in 0..count.saturating_sub(2) {
        shown.add(&around[..count], i, (start + i).is_multiple_of(2));
    }
    shown
}

/// Up to four visible triangles, each rotated so that its smallest corner comes first.
#[derive(Default)]
struct VisibleTriangles {
    triangles: [[u32; 3]; 4],
    count: usize,
}

impl VisibleTriangles {
    /// Adds the triangle that starts at `at`, if it exists and is not degenerate.
    fn add(&mut self, strip: &[u32], at: usize, is_even: bool) {
        let Some(w) = strip.get(at..at + 3) else { return };
        if is_degenerate(w) || self.count == self.triangles.len() {
            return;
        }
        let [a, b, c] = if is_even { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] };
        let turned = if a < b && a < c {
            [a, b, c]
        } else if b < a && b < c {
            [b, c, a]
        } else {
            [c, a, b]
        };
        self.triangles[self.count] = turned;
        self.count += 1;
    }

    fn same(&self, other: &Self) -> bool {
        match (self.count, other.count) {
            (0, 0) => true,
            (1, 1) => self.triangles[0] == other.triangles[0],
            (2, 2) => {
                let ([a, b, ..], [c, d, ..]) = (self.triangles, other.triangles);
                (a == c && b == d) || (a == d && b == c)
            }
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::canonical_triangles;
    use crate::strip::strip_triangles;

    fn reduced(strip: &[u32]) -> Vec<u32> {
        let mut slots = strip.to_vec();
        let mut changed: Vec<u32> = (0..strip.len() as u32).collect();
        let length = drop_superfluous(&mut slots, &mut changed, &mut Vec::new());
        slots.truncate(length);
        slots
    }

    #[test]
    fn known_patterns_are_dropped() {
        assert_eq!(reduced(&[0, 1, 2, 1, 2, 3]), [0, 1, 2, 3]);
        assert_eq!(reduced(&[0, 1, 2, 2, 2, 2, 3, 4]), [0, 1, 2, 2, 3, 4]);
        assert_eq!(reduced(&[0, 0, 1, 2, 3]), [0, 0, 1, 2, 3], "a parity fix stays");
        assert_eq!(reduced(&[0, 0, 0, 1, 2, 3]), [0, 1, 2, 3]);
        assert_eq!(reduced(&[0, 1, 2, 1, 1]), [0, 1, 2]);
        assert_eq!(reduced(&[0, 0, 1, 0]), [0; 0]);
        // A long stretch of degenerate triangles from 0 1 2 to 5 6 7.
        assert_eq!(reduced(&[0, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 7]).len(), 8);
    }

    #[test]
    fn every_short_strip_keeps_its_triangles() {
        // All strips of 9 indices over 3 vertices, and a spread over 5.
        let check = |mut code: u32, radix: u32| {
            let strip: Vec<u32> = (0..9)
                .map(|_| {
                    let v = code % radix;
                    code /= radix;
                    v
                })
                .collect();
            let triangles = |s: &[u32]| canonical_triangles(&strip_triangles(s).collect::<Vec<_>>());
            let short = reduced(&strip);
            assert_eq!(triangles(&short), triangles(&strip), "{strip:?} became {short:?}");
        };
        (0..3u32.pow(9)).for_each(|code| check(code, 3));
        (0..5u32.pow(9)).step_by(61).for_each(|code| check(code, 5));
    }
}
