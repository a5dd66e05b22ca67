//! Where the new vertex of an edge may be placed, and the candidate positions.

use glam::DVec3;

use super::form::EdgeForm;

/// Rule for placing the new vertex of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Course {
    Free,
    /// At the end from which the edge is evaluated.
    Here,
    /// At the other end.
    There,
    /// At either end.
    Ends,
    Nowhere,
}

/// Cost of the first candidate position.
pub(super) fn first_cost(edge: &EdgeForm, course: Course, tip: DVec3) -> f64 {
    let place = match course {
        Course::Free => edge.keeping_volume().or_else(|| edge.cheapest()).unwrap_or(0.5 * tip),
        Course::Here => DVec3::ZERO,
        Course::There => tip,
        Course::Ends => return edge.cost(DVec3::ZERO).min(edge.cost(tip)),
        Course::Nowhere => return f64::INFINITY,
    };
    edge.cost(place)
}

/// Returns candidate positions for the new vertex, relative to the edge's first end and best first,
/// each with whether that end is the one kept.
pub(super) fn places(edge: &EdgeForm, course: Course, tip: DVec3) -> [Option<(DVec3, bool)>; 5] {
    let (here, there) = ((DVec3::ZERO, true), (tip, false));
    let ends = if edge.cost(here.0) <= edge.cost(there.0) { [here, there] } else { [there, here] };
    match course {
        Course::Free => [
            edge.keeping_volume().map(|place| (place, false)),
            edge.cheapest().map(|place| (place, false)),
            Some((0.5 * tip, false)),
            Some((ends[0].0, false)),
            Some((ends[1].0, false)),
        ],
        Course::Here => [Some(here), None, None, None, None],
        Course::There => [Some(there), None, None, None, None],
        Course::Ends => [Some(ends[0]), Some(ends[1]), None, None, None],
        Course::Nowhere => [None; 5],
    }
}
