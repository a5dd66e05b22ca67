//! Detail for a camera within a triangle limit: the smallest tolerance that the limit allows.
//!
//! A moving camera needs almost the same tolerance as a frame before. So the search starts there, and most
//! frames update the scene once.

use striata::Target;
use striata::view::ScreenError;

use super::SceneView;
use crate::drawn::DrawnInstance;

/// Share of the limit that has to be used before the tolerance stays as it is.
const GOOD_SHARE: f64 = 0.9;

/// Largest factor of the tolerance, as a logarithm.
const MAX_LOG: f32 = 14.0;

/// First step of the search, as a logarithm, and number of halvings.
const FIRST_STEP: f32 = 0.05;
const HALVINGS: usize = 6;

impl SceneView {
    /// Refines the scene like [`update`](Self::update), but with the smallest tolerance, at least that of the
    /// criterion, with which at most `triangle_limit` triangles are shown. The base level is shown if even
    /// that has more. Returns the factor of the tolerance.
    ///
    /// Up to a tenth of the limit may stay unused, so that a camera that moves does not need a search in each
    /// frame.
    pub fn update_to_budget(
        &mut self,
        error: &ScreenError,
        drawn: &[DrawnInstance],
        triangle_limit: usize,
    ) -> f32 {
        let mut search = ToleranceSearch { view: self, error, drawn, limit: triangle_limit };
        let log = search.run();
        match log {
            Some(log) => self.factor = log.exp(),
            None => {
                self.show_level(&self.lods.level(Target::Detail(0.0)));
                self.factor = MAX_LOG.exp();
            }
        }
        self.factor
    }
}

/// Search for a tolerance.
struct ToleranceSearch<'a> {
    view: &'a mut SceneView,
    error: &'a ScreenError,
    drawn: &'a [DrawnInstance],
    limit: usize,
}

impl ToleranceSearch<'_> {
    /// Returns the logarithm of the factor, with which the scene was updated last; [`None`] if no factor is
    /// large enough.
    fn run(&mut self) -> Option<f32> {
        let start = self.view.factor.ln().clamp(0.0, MAX_LOG);
        let count = self.count_at(start);
        let (mut low, mut high, mut step) = (start, start, FIRST_STEP);
        if count > self.limit {
            loop {
                (high, step) = (high + step, 2.0 * step);
                if self.count_at(high) <= self.limit {
                    break;
                }
                if high > MAX_LOG {
                    return None;
                }
                low = high;
            }
        } else if start == 0.0 || self.is_good(count) {
            return Some(start);
        } else {
            loop {
                (low, step) = ((low - step).max(0.0), 2.0 * step);
                let count = self.count_at(low);
                if count > self.limit {
                    break;
                }
                high = low;
                if low == 0.0 || self.is_good(count) {
                    return Some(low);
                }
            }
        }
        self.between(low, high)
    }

    /// Narrows the search: `low` shows too many triangles, `high` few enough.
    fn between(&mut self, mut low: f32, mut high: f32) -> Option<f32> {
        for _ in 0..HALVINGS {
            let middle = f32::midpoint(low, high);
            let count = self.count_at(middle);
            if count > self.limit {
                low = middle;
                continue;
            }
            high = middle;
            if self.is_good(count) {
                return Some(high);
            }
        }
        // The triangles of a view can depend a little on those that it showed before.
        while self.count_at(high) > self.limit {
            high += FIRST_STEP;
            if high > MAX_LOG {
                return None;
            }
        }
        Some(high)
    }

    fn count_at(&mut self, log: f32) -> usize {
        self.view.refine(&self.error.clone().relaxed(log.exp()), self.drawn);
        self.view.triangle_count()
    }

    fn is_good(&self, count: usize) -> bool {
        count as f64 >= GOOD_SHARE * self.limit as f64
    }
}
