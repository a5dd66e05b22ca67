//! The criterion that followers are given: that of a camera, which can note what it is asked.
//!
//! A clock around each question would take longer than the question. So a rehearsal notes the parts that a frame is asked
//! for, as many at once as they came, and they are weighed again by themselves under the clock.

use std::cell::RefCell;
use std::hint::black_box;
use std::time::Instant;

use striata::view::{Criterion, Part, ScreenError, Verdict};

/// What was asked for in a frame.
#[derive(Debug, Default)]
pub(super) struct Log {
    parts: RefCell<Vec<Part>>,
    /// The end of each question among the parts.
    ends: RefCell<Vec<usize>>,
}

/// The criterion of a camera, noting or not.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asker<'a> {
    /// The criterion.
    pub(super) screen: &'a ScreenError,
    /// Where questions are noted.
    pub(super) log: Option<&'a Log>,
}

impl Criterion for Asker<'_> {
    #[inline]
    fn weigh(&self, part: &Part) -> Verdict {
        if let Some(log) = self.log {
            log.note(std::slice::from_ref(part));
        }
        self.screen.weigh(part)
    }

    #[inline]
    fn weigh_all(&self, parts: &[Part], verdicts: &mut Vec<Verdict>) {
        if let Some(log) = self.log {
            log.note(parts);
        }
        self.screen.weigh_all(parts, verdicts);
    }

    fn motion_since(&self, earlier: &Self) -> f32 {
        self.screen.motion_since(earlier.screen)
    }
}

impl Log {
    /// Repetitions of which the quickest counts.
    const REPETITIONS: usize = 3;

    fn note(&self, parts: &[Part]) {
        let mut all = self.parts.borrow_mut();
        all.extend_from_slice(parts);
        self.ends.borrow_mut().push(all.len());
    }

    /// Forgets what was noted.
    pub(super) fn clear(&self) {
        self.parts.borrow_mut().clear();
        self.ends.borrow_mut().clear();
    }

    /// Parts that were asked for.
    pub(super) fn asked_count(&self) -> usize {
        self.parts.borrow().len()
    }

    /// Seconds that it takes to weigh them again, each question as it came.
    pub(super) fn weighing_secs(&self, screen: &ScreenError) -> f64 {
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
    fn questions_are_noted_and_answered_as_without_a_log() {
        let frames = Path::Orbit.frames(&shapes::icosphere(1, 1.0));
        let screen = ScreenError::new(frames[0].camera().unwrap(), 1.0);
        let part = |error| Part { sphere: Sphere::point([0.0; 3]), cone: NormalCone::ALL, error };
        let log = Log::default();
        let (noting, silent) =
            (Asker { screen: &screen, log: Some(&log) }, Asker { screen: &screen, log: None });
        assert_eq!(noting.weigh(&part(0.5)), silent.weigh(&part(0.5)));
        let mut verdicts = [Vec::new(), Vec::new()];
        noting.weigh_all(&[part(1e-9), part(1.0)], &mut verdicts[0]);
        silent.weigh_all(&[part(1e-9), part(1.0)], &mut verdicts[1]);
        assert!(verdicts[0] == verdicts[1] && verdicts[0].len() == 2);
        assert_eq!((log.asked_count(), log.ends.borrow().clone()), (3, vec![1, 3]));
        assert!(log.weighing_secs(&screen) >= 0.0);
        log.clear();
        assert_eq!(log.asked_count(), 0);
    }
}
