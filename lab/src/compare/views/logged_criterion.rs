//! The criterion passed to followers: that of a camera, which can also log the parts it evaluates.
//!
//! Timing each evaluation would take longer than the evaluation itself. A rehearsal therefore logs the
//! parts evaluated in a frame, in the batches in which they arrived, and these are evaluated once more,
//! separately, under the clock.

use std::cell::RefCell;
use std::hint::black_box;
use std::time::Instant;

use striata::view::{Criterion, Part, ScreenError, Verdict};

/// The parts evaluated in one frame.
#[derive(Debug, Default)]
pub(super) struct QueryLog {
    parts: RefCell<Vec<Part>>,
    /// End of each batch in `parts`.
    ends: RefCell<Vec<usize>>,
}

/// The criterion of a camera, with or without a log.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoggedCriterion<'a> {
    /// The camera's criterion.
    pub screen: &'a ScreenError,
    /// QueryLog of the evaluated parts, if any.
    pub log: Option<&'a QueryLog>,
}

impl Criterion for LoggedCriterion<'_> {
    #[inline]
    fn weigh(&self, part: &Part) -> Verdict {
        if let Some(log) = self.log {
            log.record(std::slice::from_ref(part));
        }
        self.screen.weigh(part)
    }

    #[inline]
    fn weigh_all(&self, parts: &[Part], verdicts: &mut Vec<Verdict>) {
        if let Some(log) = self.log {
            log.record(parts);
        }
        self.screen.weigh_all(parts, verdicts);
    }

    fn motion_since(&self, earlier: &Self) -> f32 {
        self.screen.motion_since(earlier.screen)
    }
}

impl QueryLog {
    /// Number of repetitions; the fastest one counts.
    const REPETITIONS: usize = 3;

    fn record(&self, parts: &[Part]) {
        let mut all = self.parts.borrow_mut();
        all.extend_from_slice(parts);
        self.ends.borrow_mut().push(all.len());
    }

    /// Empties the log.
    pub(super) fn clear(&self) {
        self.parts.borrow_mut().clear();
        self.ends.borrow_mut().clear();
    }

    /// Number of evaluated parts.
    pub(super) fn evaluated_count(&self) -> usize {
        self.parts.borrow().len()
    }

    /// Seconds needed to evaluate the logged parts again, in the same batches.
    pub(super) fn evaluation_secs(&self, screen: &ScreenError) -> f64 {
        let (parts, ends) = (self.parts.borrow(), self.ends.borrow());
        let mut verdicts = Vec::new();
        let mut once = || {
            let started = Instant::now();
            let mut start = 0;
            for &end in &*ends {
                match &parts[start..end] {
                    [part] => {
                        black_box(screen.weigh(part));
                    }
                    several => {
                        verdicts.clear();
                        screen.weigh_all(several, &mut verdicts);
                        black_box(&verdicts);
                    }
                }
                start = end;
            }
            started.elapsed().as_secs_f64()
        };
        (0..Self::REPETITIONS).map(|_| once()).fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;
    use striata::view::{NormalCone, Sphere};

    use super::super::paths::Path;
    use super::*;

    #[test]
    fn logging_does_not_change_verdicts() {
        let frames = Path::Orbit.frames(&shapes::icosphere(1, 1.0));
        let screen = ScreenError::new(frames[0].camera().unwrap(), 1.0);
        let part = |error| Part { sphere: Sphere::point([0.0; 3]), cone: NormalCone::ALL, error };
        let log = QueryLog::default();
        let (logging, silent) = (
            LoggedCriterion { screen: &screen, log: Some(&log) },
            LoggedCriterion { screen: &screen, log: None },
        );
        assert_eq!(logging.weigh(&part(0.5)), silent.weigh(&part(0.5)));
        let mut verdicts = [Vec::new(), Vec::new()];
        logging.weigh_all(&[part(1e-9), part(1.0)], &mut verdicts[0]);
        silent.weigh_all(&[part(1e-9), part(1.0)], &mut verdicts[1]);
        assert!(verdicts[0] == verdicts[1] && verdicts[0].len() == 2);
        assert_eq!((log.evaluated_count(), log.ends.borrow().clone()), (3, vec![1, 3]));
        assert!(log.evaluation_secs(&screen) >= 0.0);
        log.clear();
        assert_eq!(log.evaluated_count(), 0);
    }
}
