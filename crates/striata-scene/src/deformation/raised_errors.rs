//! Errors of all levels, from the distances of those that were measured in the poses of a mesh.
//!
//! A measured level takes its distance. The errors of levels between two measured ones grow by the ratio of
//! distance and error at these, whichever is larger, but not above the distance of the coarser one. If a
//! level's own error is a small part of the coarser one's, such as 0 because the mesh is flat in its bind
//! pose, it says nothing about poses, and the level takes the distance of the coarser one.

use striata::mesh::{CollapseSequence, RefinableMesh, SequenceParts};

use super::measured_levels::MeasuredLevel;

/// Share of the error of the next coarser measured level below which an error says nothing about poses.
const LEAST_SHARE: f64 = 0.25;

/// Returns the mesh with errors that hold in all poses, as far as they were measured.
pub(super) fn with_raised_errors(refinable: RefinableMesh, measured: &[MeasuredLevel]) -> RefinableMesh {
    let errors = raised(refinable.sequence.errors(), measured);
    with_errors(refinable, errors)
}

/// Replaces the errors of all levels.
///
/// # Panics
/// If an error is negative or not a number, or they increase.
pub(crate) fn with_errors(
    RefinableMesh { mesh, sequence }: RefinableMesh,
    errors: Vec<f32>,
) -> RefinableMesh {
    let parts = SequenceParts {
        positions: sequence.positions().clone(),
        base_position_count: sequence.base_position_count(),
        targets: sequence.targets().to_vec(),
        errors,
        removed_triangle_counts: sequence.removed_triangle_counts().to_vec(),
        triangle_count: mesh.triangle_count(),
    };
    let sequence = CollapseSequence::from_parts(parts).expect("only the errors change, and they never rise");
    RefinableMesh { mesh, sequence }
}

/// Returns the errors of all levels, raised by what was measured (finest level first).
fn raised(errors: &[f32], measured: &[MeasuredLevel]) -> Vec<f32> {
    let mut raised = errors.to_vec();
    let mut end = errors.len();
    let (mut finer_ratio, mut largest) = (1.0, 0.0f64);
    for &MeasuredLevel { split_count, distance } in measured {
        largest = largest.max(distance);
        let error = f64::from(errors[split_count]);
        let ratio = if error > 0.0 { (largest / error).max(1.0) } else { 1.0 };
        for between in &mut raised[split_count + 1..end] {
            let own = f64::from(*between);
            let is_telling = error > 0.0 && own >= LEAST_SHARE * error;
            let grown = if is_telling { (own * ratio.max(finer_ratio)).min(largest) } else { largest };
            *between = between.max(rounded_up(grown));
        }
        raised[split_count] = raised[split_count].max(rounded_up(largest));
        (end, finer_ratio) = (split_count, ratio);
    }
    // The error of a level never falls as detail falls.
    for step in (1..raised.len()).rev() {
        raised[step - 1] = raised[step - 1].max(raised[step]);
    }
    raised
}

/// Rounds up, to the largest number at most.
fn rounded_up(distance: f64) -> f32 {
    let rounded = distance as f32;
    let rounded = if f64::from(rounded) < distance { rounded.next_up() } else { rounded };
    rounded.min(f32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn levels(measured: &[(usize, f64)]) -> Vec<MeasuredLevel> {
        measured.iter().map(|&(split_count, distance)| MeasuredLevel { split_count, distance }).collect()
    }

    #[test]
    fn levels_between_measured_ones_take_the_larger_ratio() {
        let errors = [8.0, 4.0, 2.0, 1.0, 0.5, 0.25];
        let measured = levels(&[(4, 0.5), (2, 4.0), (0, 8.0)]);
        assert_eq!(raised(&errors, &measured), [8.0, 8.0, 4.0, 2.0, 0.5, 0.25]);
        assert_eq!(raised(&[0.0, 0.0], &levels(&[(1, 0.0), (0, 3.0)])), [3.0, 0.0]);
    }

    #[test]
    fn levels_whose_errors_say_nothing_take_the_distance_of_the_coarser_one() {
        let errors = [0.0, 0.0, 0.0, 0.0];
        assert_eq!(raised(&errors, &levels(&[(3, 0.0), (0, 3.0)])), [3.0, 3.0, 3.0, 0.0]);
        assert_eq!(raised(&[1.0, 0.5, 0.1, 0.0], &levels(&[(3, 0.0), (0, 4.0)])), [4.0, 4.0, 4.0, 0.0]);
    }

    #[test]
    fn huge_ratios_do_not_exceed_what_was_measured() {
        let errors = [8.0, 4.0, 2.0, 1e-9];
        assert_eq!(raised(&errors, &levels(&[(3, 1.0), (0, 8.0)])), [8.0, 8.0, 8.0, 1.0]);
    }
}
