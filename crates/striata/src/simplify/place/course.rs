//! Where the vertex of an edge may lie, and the places to try there.

use glam::DVec3;

use super::form::EdgeForm;

/// Where the vertex of an edge may lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Course {
    Free,
    /// At the end that asks.
    Here,
    /// At the other end.
    There,
    /// At one of both.
    Ends,
    Nowhere,
}

/// What the first of `places` costs.
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

/// Places for the vertex of an edge seen from its first end, best first, and whether that end is the one kept.
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
