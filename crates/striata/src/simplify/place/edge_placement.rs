//! Rules for placing the new vertex of an edge, and the candidate positions.

use glam::DVec3;

use super::quadratic_form::EdgeForm;

/// Rule for placing the new vertex of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EdgePlacement {
    Free,
    /// At the end from which the edge is evaluated.
    FirstEnd,
    /// At the other end.
    SecondEnd,
    /// At either end.
    EitherEnd,
    Forbidden,
}

/// Cost of the first candidate position.
pub(super) fn first_candidate_cost(edge: &EdgeForm, placement: EdgePlacement, tip: DVec3) -> f64 {
    let position = match placement {
        EdgePlacement::Free => edge.volume_preserving().or_else(|| edge.cheapest()).unwrap_or(0.5 * tip),
        EdgePlacement::FirstEnd => DVec3::ZERO,
        EdgePlacement::SecondEnd => tip,
        EdgePlacement::EitherEnd => return edge.cost(DVec3::ZERO).min(edge.cost(tip)),
        EdgePlacement::Forbidden => return f64::INFINITY,
    };
    edge.cost(position)
}

/// Returns candidate positions for the new vertex, relative to the edge's first end and best first,
/// each with whether the first end is the one kept.
pub(super) fn candidate_positions(
    edge: &EdgeForm,
    placement: EdgePlacement,
    tip: DVec3,
) -> [Option<(DVec3, bool)>; 5] {
    let (first_end, second_end) = ((DVec3::ZERO, true), (tip, false));
    let ends = if edge.cost(first_end.0) <= edge.cost(second_end.0) {
        [first_end, second_end]
    } else {
        [second_end, first_end]
    };
    match placement {
        EdgePlacement::Free => [
            edge.volume_preserving().map(|position| (position, false)),
            edge.cheapest().map(|position| (position, false)),
            Some((0.5 * tip, false)),
            Some((ends[0].0, false)),
            Some((ends[1].0, false)),
        ],
        EdgePlacement::FirstEnd => [Some(first_end), None, None, None, None],
        EdgePlacement::SecondEnd => [Some(second_end), None, None, None, None],
        EdgePlacement::EitherEnd => [Some(ends[0]), Some(ends[1]), None, None, None],
        EdgePlacement::Forbidden => [None; 5],
    }
}
