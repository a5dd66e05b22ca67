//! Levels of paged files whose detail varies: for a camera, a box, or any other criterion.

use striata::view::{Criterion, DetailBox, Part, ScreenError, Sphere};

use crate::{PageBound, PagedCut, PagedError, PagedFile, PagedReader};

/// Maximum factor by which tolerances are relaxed.
const MAX_RELAXATION: f32 = 1e9;
/// Factor between the tolerances that are tried until there are too many triangles.
const COARSE_STEP: f32 = 3.0;
/// Maximum number of tolerances that are tried after that.
const SEARCH_STEPS: usize = 8;
/// Share of the allowed triangles from which a level is accepted.
const GOOD_SHARE: f64 = 0.97;

/// Error that a passing level leaves for a factor of 65, as a share of the coarsest level's; for smaller factors it falls
/// with a power of 1.5, which spreads the pages of a view from within evenly over the usual factors.
const PASSING_SHARE: f32 = 1.0 / 8.0;

/// A level for a view.
#[derive(Clone, Debug)]
pub struct ViewCut {
    /// The level.
    pub cut: PagedCut,
    /// All tolerances have been multiplied by this, at least 1, to respect the triangle limit.
    pub relaxation: f32,
    /// Whether the triangle limit, if any, is respected.
    pub is_within_limit: bool,
}

impl PageBound {
    /// Returns the part that a criterion judges: the sphere around this part of a page, and its largest error.
    pub fn part(&self) -> Part {
        let center = [0, 1, 2].map(|a| 0.5 * (self.min[a] + self.max[a]));
        let half = [0, 1, 2].map(|a| 0.5 * f64::from(self.max[a] - self.min[a]));
        let radius = half.iter().map(|x| x * x).sum::<f64>().sqrt() as f32;
        Part { sphere: Sphere { center, radius }, cone: striata::view::NormalCone::ALL, error: self.error }
    }
}

impl PagedReader {
    /// Largest error of a step whose page is not among these, in mesh units.
    pub fn error_without(&self, pages: &[u32]) -> f32 {
        let others = self.entries().filter(|(index, _)| pages.binary_search(index).is_err());
        others.map(|(_, entry)| entry.error).chain(self.unread_errors()).fold(0.0, f32::max)
    }

    /// Error that a level leaves everywhere while pages of finer ones are on their way, in mesh units; `factor` is
    /// that by which its tolerance is relaxed. Around the eye no tolerance leaves any error, and most pages of a view
    /// from within are there.
    pub fn passing_error(&self, factor: f32) -> f32 {
        let share = (factor - 1.0).max(0.0) / 64.0;
        PASSING_SHARE * share * share.sqrt() * self.error_without(&[0])
    }
}

/// A criterion that refines what another one does, except for parts with errors of up to `error`.
pub fn leaving<C: Criterion>(criterion: C, error: f32) -> impl Fn(&Part) -> f32 {
    move |part| if part.error > error { criterion.weigh(part).weight } else { 0.0 }
}

impl PagedFile {
    /// The coarsest level that refines every step that a criterion wants; reads only the pages that this needs.
    ///
    /// # Errors
    /// [`PagedError`] if a page cannot be read or does not match the others.
    pub fn level_for(&mut self, criterion: &(impl Criterion + Sync)) -> Result<PagedCut, PagedError> {
        let pages = self.select(|bound| criterion.weigh(&bound.part()).should_refine())?;
        let error = self.reader().error_without(&pages);
        let cut = self.cut_pages(&pages)?.cut(|part| criterion.weigh(part).should_refine());
        Ok(PagedCut { error: cut.error.max(error), ..cut })
    }

    /// The level for a view, with relaxed tolerances if it would have more triangles than allowed.
    ///
    /// # Errors
    /// See [`Self::level_for`].
    pub fn level_for_view(
        &mut self,
        criterion: &ScreenError,
        triangle_limit: Option<usize>,
    ) -> Result<ViewCut, PagedError> {
        let Some(limit) = triangle_limit else {
            let cut = self.level_for(criterion)?;
            return Ok(ViewCut { cut, relaxation: 1.0, is_within_limit: true });
        };
        self.level_within(limit, |file, factor| file.level_for(&criterion.clone().relaxed(factor)))
    }

    /// The level with full detail in a box, and as many triangles outside of it as a limit allows.
    ///
    /// # Errors
    /// See [`Self::level_for`].
    pub fn level_for_box(
        &mut self,
        detail: &DetailBox,
        triangle_limit: usize,
    ) -> Result<ViewCut, PagedError> {
        // So the largest factor allows errors of ten diagonals.
        let least = (self.metadata().diagonal() * 10.0 / f64::from(MAX_RELAXATION)) as f32;
        let cut = |file: &mut Self, factor: f32| {
            file.level_for(&DetailBox { error_outside: least * factor, ..*detail })
        };
        self.level_within(triangle_limit, cut)
    }

    /// The level with the smallest factor of its tolerances, at least 1, that respects a triangle limit.
    fn level_within(
        &mut self,
        limit: usize,
        level_at: impl Fn(&mut Self, f32) -> Result<PagedCut, PagedError>,
    ) -> Result<ViewCut, PagedError> {
        // From coarse to fine, so that no page is read that is much too fine for the limit.
        let (mut low, mut high) = (None, MAX_RELAXATION);
        let mut best = level_at(self, high)?;
        if best.mesh.triangle_count() > limit {
            return Ok(ViewCut { cut: best, relaxation: high, is_within_limit: false });
        }
        while high > 1.0 {
            let next = (high / COARSE_STEP).max(1.0);
            let cut = level_at(self, next)?;
            if cut.mesh.triangle_count() > limit {
                low = Some(TriedTolerance { relaxation: next, triangle_count: cut.mesh.triangle_count() });
                break;
            }
            (high, best) = (next, cut);
        }
        let Some(mut low) = low else {
            return Ok(ViewCut { cut: best, relaxation: high, is_within_limit: true });
        };
        for _ in 0..SEARCH_STEPS {
            let count = best.mesh.triangle_count();
            if count as f64 >= GOOD_SHARE * limit as f64 {
                break;
            }
            let middle = between(low, TriedTolerance { relaxation: high, triangle_count: count }, limit);
            let cut = level_at(self, middle)?;
            match cut.mesh.triangle_count() {
                found if found > limit => {
                    low = TriedTolerance { relaxation: middle, triangle_count: found };
                }
                _ => (high, best) = (middle, cut),
            }
        }
        Ok(ViewCut { cut: best, relaxation: high, is_within_limit: true })
    }
}

/// A relaxation of the tolerance, and the number of triangles that it leaves.
#[derive(Clone, Copy)]
struct TriedTolerance {
    relaxation: f32,
    triangle_count: usize,
}

/// A tolerance between two others, where about `limit` triangles are expected: counts follow powers of tolerances.
fn between(finer: TriedTolerance, coarser: TriedTolerance, limit: usize) -> f32 {
    let (low, high) = (finer.relaxation, coarser.relaxation);
    let (many, few) = (finer.triangle_count, coarser.triangle_count);
    let logarithm = |count: usize| (count.max(1) as f64).log2();
    let wanted = logarithm(limit) + GOOD_SHARE.log2() / 2.0;
    let share = (logarithm(many) - wanted) / (logarithm(many) - logarithm(few)).max(1e-9);
    // Never too close to either end, so that the interval shrinks.
    let share = share.clamp(0.1, 0.9);
    (f64::from(low) * (f64::from(high) / f64::from(low)).powf(share)) as f32
}
