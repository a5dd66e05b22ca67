//! Finds the error limit that other simplifiers need to reach a target.
//!
//! They stop at an error limit or at a target, whichever comes first. Passing a limit that is far too high
//! does not help: when collapses run out, both meshoptimizer and gltfpack remove whole parts up to the
//! limit and overshoot the target by far. So each level gets the smallest limit from a list with which the
//! target is reached.

use super::contender::Level;
use super::contender::Request;

/// Error limits as shares of the extent; 0.01 is gltfpack's default.
const LIMITS: [f64; 7] = [0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0];

/// Returns the level of the smallest limit that reaches the target. If there is none, or it is empty, returns
/// the level of the largest limit that misses the target. `simplify` returns `None` if no triangle is left.
///
/// # Errors
/// If `simplify` fails, or no limit leaves a triangle.
pub(super) fn with_smallest_limit(
    request: &Request,
    simplify: impl Fn(f64) -> Result<Option<Level>, String>,
) -> Result<Level, String> {
    let (mut first, mut end) = (0, LIMITS.len());
    let (mut reached, mut missed) = (None, None);
    while first < end {
        let middle = usize::midpoint(first, end);
        let level = simplify(LIMITS[middle])?;
        let level = level.map(|level| Level { error_limit: Some(LIMITS[middle]), ..level });
        match level {
            Some(level) if level.mesh.triangle_count() > request.target_count => {
                missed = Some(level);
                first = middle + 1;
            }
            level => {
                reached = level;
                end = middle;
            }
        }
    }
    reached.or(missed).ok_or_else(|| "no triangle is left".to_owned())
}

#[cfg(test)]
mod tests {
    use striata::mesh::IndexedMesh;

    use super::*;

    /// The triangle count and limit chosen for a target of 100, if any level remains.
    fn found(count_of: impl Fn(f64) -> usize) -> Option<(usize, f64)> {
        let level = with_smallest_limit(&Request { percent: 50.0, target_count: 100 }, |limit| {
            let mesh = IndexedMesh::new(vec![[0.0; 3]; 3], vec![[0, 1, 2]; count_of(limit)]);
            let level = Level { mesh, secs: 0.0, error: None, error_limit: None };
            Ok(Some(level).filter(|level| level.mesh.triangle_count() > 0))
        });
        let level = level.ok()?;
        Some((level.mesh.triangle_count(), level.error_limit?))
    }

    #[test]
    fn smallest_limit_that_reaches_the_target_is_used() {
        assert_eq!(found(|limit| if limit < 0.02 { 150 } else { 90 }), Some((90, 0.03)));
        assert_eq!(found(|_| 80), Some((80, 0.001)));
        assert_eq!(found(|limit| if limit < 0.5 { 150 } else { 20 }), Some((20, 1.0)));
    }

    #[test]
    fn level_that_misses_the_target_is_better_than_none() {
        assert_eq!(found(|limit| if limit < 0.2 { 150 } else { 0 }), Some((150, 0.1)));
        assert_eq!(found(|_| 150), Some((150, 1.0)));
        assert_eq!(found(|_| 0), None);
    }
}
