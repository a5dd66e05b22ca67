//! Parts of a large mesh that are annealed at the same time.
//!
//! A part is a box of the mesh. Links between parts stay dashed, so the last moves are made in the joined mesh, along
//! the borders. How a mesh is divided does not depend on the number of threads, so neither do the strips.

use striata::mesh::NO_TWIN;
use striata::strip::StripLinks;

use super::anneal::Annealer;
use super::strip_state::{StateNumbers, StripState};
use crate::task::{SpentFn, StripTask};

/// Number of triangles of a part.
const PART_TRIANGLES: usize = 1 << 17;
/// Number of triangles that a sweep of a part visits between checks of the budget.
const BATCH: u64 = 4096;

/// Largest number of moves for each triangle at a border: a few of them would get all that are left, and following
/// long strips around would take quadratic time.
const BORDER_MOVES: u64 = 128;

/// Searches of all parts.
pub(super) struct StripParts {
    parts: Vec<Annealer>,
    /// Largest number of moves.
    most_moves: u64,
}

impl StripParts {
    /// Divides triangles, given in the order of their strips.
    pub(super) fn new(order: &[u32], task: &StripTask<'_>, links: &StripLinks<'_>) -> Self {
        // Triangles by their place in the order, which each part keeps.
        let mut places: Vec<u32> = (0..order.len() as u32).collect();
        let mut numbers = StateNumbers::new(task.triangles);
        let mut parts: Vec<Annealer> = Vec::new();
        let center = |place: u32| {
            let corners = task.triangles[order[place as usize] as usize].map(|v| task.positions[v as usize]);
            [0, 1, 2].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f32>())
        };
        split(&mut places, &center, &mut |places| {
            places.sort_unstable();
            let run: Vec<u32> = places.iter().map(|&place| order[place as usize]).collect();
            let seed = task.options.seed ^ (parts.len() as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            parts.push(Annealer::new(StripState::new(&run, task.triangles, links, &mut numbers), seed));
        });
        Self { parts, most_moves: u64::MAX }
    }

    /// Whether the mesh is large enough for several parts.
    pub(super) fn are_several(&self) -> bool {
        self.parts.len() > 1
    }

    /// Joins the parts to search along their borders; links must be those that have been written. Returns the number
    /// of moves before, which do not count any more.
    pub(super) fn join(&mut self, order: &[u32], task: &StripTask<'_>, links: &StripLinks<'_>) -> u64 {
        let before = self.move_count();
        let mut part_of = vec![0u32; task.triangles.len()];
        for (part, index) in self.parts.iter().zip(0..) {
            part.state.order().iter().for_each(|&triangle| part_of[triangle as usize] = index);
        }
        self.parts.clear();
        let whole = StripState::new(order, task.triangles, links, &mut StateNumbers::new(task.triangles));
        let is_at_border = |&triangle: &u32| {
            let own = part_of[order[triangle as usize] as usize];
            let twins = (0..3).map(|k| whole.twin((triangle << 2) | k)).filter(|&twin| twin != NO_TWIN);
            twins.map(|twin| part_of[order[twin as usize >> 2] as usize]).any(|part| part != own)
        };
        let visited: Vec<u32> = (0..order.len() as u32).filter(is_at_border).collect();
        self.most_moves = BORDER_MOVES * visited.len() as u64;
        self.parts.push(Annealer::new(whole, task.options.seed).visiting(visited));
        before
    }

    fn move_count(&self) -> u64 {
        self.parts.iter().map(|part| part.move_count).sum()
    }

    /// Improves strips until the budget is spent, while the temperature, in indices, changes from the first to the
    /// last one. Returns the change of cost.
    pub(super) fn anneal(&mut self, [first, last]: [f64; 2], spent: &mut SpentFn<'_>) -> i64 {
        let mut change = 0;
        if !self.parts.iter().any(Annealer::can_move) {
            return change;
        }
        loop {
            let share = spent(self.move_count());
            if share >= 1.0 || self.move_count() >= self.most_moves {
                return change;
            }
            let temperature = first + (last - first) * share;
            let largest = self.parts.iter().map(Annealer::len).max().unwrap_or(1) as u64;
            change += sum(&mut self.parts, |part| {
                let visits = (BATCH.min(self.most_moves) * part.len() as u64).div_ceil(largest);
                part.sweep(temperature, visits)
            });
        }
    }

    /// Writes the links of all parts.
    pub(super) fn write_links(&self, links: &mut StripLinks<'_>) {
        links.clear();
        self.parts.iter().for_each(|part| part.state.write_links(links));
    }
}

/// Divides triangles along the longest axis until no part is too large.
fn split(places: &mut [u32], center: &impl Fn(u32) -> [f32; 3], visit: &mut impl FnMut(&mut [u32])) {
    if places.len() <= PART_TRIANGLES {
        return visit(places);
    }
    let centers = || places.iter().map(|&place| center(place));
    let extent = |axis: usize| {
        let (least, most) = centers().fold((f32::INFINITY, f32::NEG_INFINITY), |(least, most), center| {
            (least.min(center[axis]), most.max(center[axis]))
        });
        most - least
    };
    let extents = [0, 1, 2].map(extent);
    let axis = (1..3).fold(0, |best, axis| if extents[axis] > extents[best] { axis } else { best });
    let middle = places.len() / 2;
    places
        .select_nth_unstable_by(middle, |&a, &b| center(a)[axis].total_cmp(&center(b)[axis]).then(a.cmp(&b)));
    let (below, above) = places.split_at_mut(middle);
    split(below, center, visit);
    split(above, center, visit);
}

#[cfg(feature = "parallel")]
fn sum(parts: &mut [Annealer], sweep: impl Fn(&mut Annealer) -> i64 + Sync + Send) -> i64 {
    use rayon::prelude::*;
    match parts {
        [part] => sweep(part),
        _ => parts.par_iter_mut().map(sweep).sum(),
    }
}

#[cfg(not(feature = "parallel"))]
fn sum(parts: &mut [Annealer], sweep: impl Fn(&mut Annealer) -> i64) -> i64 {
    parts.iter_mut().map(sweep).sum()
}
