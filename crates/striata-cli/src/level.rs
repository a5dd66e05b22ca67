//! Which level the user means.

use striata::mesh::CollapseSequence;
use striata::simplify::{StopReason, Target};

use crate::args::LevelArgs;
use crate::failure::Failure;

impl LevelArgs {
    /// The target in mesh units.
    ///
    /// # Errors
    /// Where none is given, which the argument parser refuses before.
    pub(crate) fn target(&self, diagonal: f64) -> Result<Target, Failure> {
        let targets = [
            self.triangles.map(Target::Triangles),
            self.vertices.map(Target::Vertices),
            self.detail.map(Target::Detail),
            self.error.map(|error| Target::Error(error.in_units(diagonal))),
            self.split_count.map(Target::SplitCount),
        ];
        targets.into_iter().flatten().next().ok_or_else(|| Failure::internal("no level was given"))
    }
}

/// The level of a sequence that a target asks for, and how near it comes.
///
/// Where the target cannot be met, the nearest level that does not exceed it; the base where all do.
pub(crate) fn choose(sequence: &CollapseSequence, target: Target) -> Result<(usize, StopReason), Failure> {
    let last = sequence.step_count();
    let full_or = |exceeds: bool, split_count| match exceeds {
        true => (split_count, StopReason::FullMesh),
        false => (split_count, StopReason::TargetReached),
    };
    Ok(match target {
        Target::Triangles(count) if count < sequence.triangle_count_at(0) => (0, StopReason::BaseReached),
        Target::Triangles(count) => {
            let exceeds = count > sequence.triangle_count_at(last);
            full_or(exceeds, sequence.split_count_for_triangles(count))
        }
        Target::Vertices(count) if count < sequence.vertex_count_at(0) => (0, StopReason::BaseReached),
        Target::Vertices(count) => {
            let exceeds = count > sequence.vertex_count_at(last);
            full_or(exceeds, sequence.split_count_for_vertices(count))
        }
        Target::Detail(detail) => (sequence.split_count_for_detail(detail), StopReason::TargetReached),
        Target::Error(error) => match sequence.split_count_for_error(error) {
            0 => (0, StopReason::BaseReached),
            split_count => (split_count, StopReason::TargetReached),
        },
        Target::SplitCount(count) => full_or(count > last, count.min(last)),
        other => return Err(Failure::internal(format!("target {other:?} is not known here"))),
    })
}

#[cfg(test)]
mod tests {
    use striata::mesh::{PositionIndex, SequenceParts};

    use super::*;

    /// Four positions, two steps that remove two triangles each of five.
    fn sequence() -> CollapseSequence {
        CollapseSequence::from_parts(SequenceParts {
            positions: PositionIndex::identity(6),
            base_position_count: 4,
            targets: vec![0, 1],
            errors: vec![0.5, 0.25],
            removed_triangle_counts: vec![2, 2],
            triangle_count: 5,
        })
        .expect("the parts fit")
    }

    #[test]
    fn targets_are_met_or_say_why_not() {
        use StopReason::{BaseReached, FullMesh, TargetReached};
        let cases = [
            (Target::Triangles(0), (0, BaseReached)),
            (Target::Triangles(1), (0, TargetReached)),
            (Target::Triangles(4), (1, TargetReached)),
            (Target::Triangles(5), (2, TargetReached)),
            (Target::Triangles(6), (2, FullMesh)),
            (Target::Vertices(3), (0, BaseReached)),
            (Target::Vertices(5), (1, TargetReached)),
            (Target::Vertices(7), (2, FullMesh)),
            (Target::Detail(0.5), (1, TargetReached)),
            (Target::Error(0.3), (1, TargetReached)),
            (Target::Error(0.0), (2, TargetReached)),
            (Target::Error(9.0), (0, BaseReached)),
            (Target::SplitCount(1), (1, TargetReached)),
            (Target::SplitCount(3), (2, FullMesh)),
        ];
        for (target, expected) in cases {
            let chosen = choose(&sequence(), target).expect("a known target");
            assert_eq!(chosen, expected, "{target:?}");
        }
    }
}
