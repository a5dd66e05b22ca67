//! Search for the fewest strips: ends of strips walk at random until they meet.
//!
//! The end of a strip takes a neighboring triangle, which releases one of its own neighbors; that one is the
//! next end. The number of strips stays the same, no loop closes if a triangle of the same strip releases the
//! neighbor on the end's side, and when an end meets the end of another strip, the two become one. The walk
//! is a tunnel of unlimited length, found without a search. Balanced trees (`path_forest`) answer which strip
//! a triangle is in. In each component the walk stops at a number that provably cannot be beaten (`bound`).
//!
//! The algorithm is our own, based on the step of \[PS03\]; within one strip the step is Pósa's rotation of
//! Hamiltonian paths. A step costs about a microsecond; with `s` strips left, some `n / s` steps are needed
//! per join. Memory is 60 bytes per triangle.

mod bound;
mod path_forest;

use striata::mesh::{DualGraph, IndexedMesh, NO_TWIN, Random, is_proper};
use striata::strip::{StripLinks, StripPath, next_side};

use crate::stripifier::DEFAULT_TUNNEL_LENGTH;
use crate::task::{SpentFn, StripTask};
use crate::tunnel::{self, ends_of, join_ends};
use bound::StripCountBounds;
use path_forest::PathForest;

/// Number of steps before another end gets its turn: while many ends are left, and when few are.
///
/// When few strips are left, a walk has no choices, and one that reaches a boundary goes back the way it
/// came; the walks of other ends change what it finds. On the bunny in 3 s with six seeds: 3 or 4 strips
/// with 64 steps at the end, 3 to 5 with 8, 4 or 5 with 256. While many ends are left, continuing is better
/// than starting in a part of memory that is not cached.
const WALK_STEPS: [u64; 2] = [4096, 64];
/// Number of ends up to which few are left.
const FEW_END_COUNT: usize = 32;

/// Number of tunnel searches after the walks.
const FINAL_SEARCH_COUNT: u64 = 1024;

/// Returns a proven lower bound for the number of strips along the links of a mesh's dual graph.
///
/// If more than two triangles share an edge, the graph pairs them in one of several ways, and another pairing
/// might allow fewer strips. Strips that `cheapest` joins at a vertex follow no link there and count as one.
///
/// # Panics
/// If a triangle has a vertex index out of range, or groups do not cover the triangles.
pub fn strip_count_bound(mesh: &IndexedMesh) -> usize {
    let is_degenerate = |t: u32| !is_proper(&mesh.triangles[t as usize]);
    StripCountBounds::new(&DualGraph::of_vertices(mesh), is_degenerate)
        .least
        .iter()
        .map(|&least| least as usize)
        .sum()
}

/// Joins strips until every component has as few as possible, or the budget is spent.
///
/// If boundaries and seams leave ends little room to walk, a final search for tunnels finds what the walks
/// have missed.
pub(crate) fn run(
    task: &StripTask<'_>,
    graph: &DualGraph,
    links: &mut StripLinks<'_>,
    spent: &mut SpentFn<'_>,
) {
    if walk_ends(task, graph, links, spent) {
        let mut few = |searches| searches as f64 / FINAL_SEARCH_COUNT as f64;
        tunnel::run(task, links, DEFAULT_TUNNEL_LENGTH, &mut few);
    }
}

/// Walks until the budget is spent. Returns whether any component still has more strips than its lower bound.
fn walk_ends(
    task: &StripTask<'_>,
    graph: &DualGraph,
    links: &mut StripLinks<'_>,
    spent: &mut SpentFn<'_>,
) -> bool {
    let mut random = Random::new(task.options.seed);
    join_ends(&ends_of(task, links), links, &mut random);
    let bounds = StripCountBounds::new(graph, |t| !task.is_proper(t));
    let ends = ends_of(task, links);
    let mut walk = RandomWalk::new(links, &ends, bounds, random);
    let mut step_count = 0;
    while let Some(mut end) = walk.pick_end() {
        let is_late = walk.ends.len() <= FEW_END_COUNT;
        for _ in 0..WALK_STEPS[usize::from(is_late)] {
            // Checked before the step: ends that cannot move must use up the budget too.
            if step_count % 256 == 0 && spent(step_count) >= 1.0 {
                return true;
            }
            step_count += 1;
            match walk.step(end) {
                Some(moved) => end = moved,
                None => break,
            }
        }
    }
    false
}

/// Strips whose ends walk at random.
struct RandomWalk<'a, 'g> {
    links: &'a mut StripLinks<'g>,
    forest: PathForest,
    /// Ends of strips, in components that have more strips than their bound.
    ends: Vec<u32>,
    /// Index of each triangle in `ends`, or [`NO_TWIN`].
    index_in_ends: Vec<u32>,
    bounds: StripCountBounds,
    /// Number of strips of each component.
    strip_counts: Vec<u32>,
    /// Triangle that released the moving end; the walk does not go back there if it has another choice.
    came_from: u32,
    random: Random,
}

impl<'a, 'g> RandomWalk<'a, 'g> {
    fn new(links: &'a mut StripLinks<'g>, ends: &[u32], bounds: StripCountBounds, random: Random) -> Self {
        let count = links.triangle_count();
        let mut forest = PathForest::new(count);
        let mut strip_counts = vec![0; bounds.least.len()];
        let mut is_done = vec![false; count];
        let (mut path, mut triangles) = (StripPath::default(), Vec::new());
        for &end in ends {
            if is_done[end as usize] {
                continue;
            }
            path.follow(links, end);
            triangles.clear();
            triangles.extend(path.triangles(links));
            forest.chain(&triangles);
            for &end in [triangles.first(), triangles.last()].into_iter().flatten() {
                is_done[end as usize] = true;
            }
            strip_counts[bounds.component[end as usize] as usize] += 1;
        }
        let index_in_ends = vec![NO_TWIN; count];
        let mut walk = Self {
            links,
            forest,
            ends: Vec::new(),
            index_in_ends,
            bounds,
            strip_counts,
            came_from: NO_TWIN,
            random,
        };
        for &end in ends {
            walk.update(end);
        }
        walk
    }

    /// Picks a random end to walk with; [`None`] if every component has reached its bound.
    fn pick_end(&mut self) -> Option<u32> {
        self.came_from = NO_TWIN;
        while !self.ends.is_empty() {
            let end = self.ends[self.random.below(self.ends.len() as u32) as usize];
            if self.is_open(end) {
                return Some(end);
            }
            self.remove(end);
        }
        None
    }

    /// Whether the component of a triangle has more strips than its bound.
    fn is_open(&self, triangle: u32) -> bool {
        let component = self.bounds.component[triangle as usize] as usize;
        self.strip_counts[component] > self.bounds.least[component]
    }

    /// Updates `ends` after the links of a triangle have changed.
    fn update(&mut self, triangle: u32) {
        let is_end = self.links.solid_degree(triangle) < 2;
        let index_in_ends = self.index_in_ends[triangle as usize];
        if is_end && index_in_ends == NO_TWIN {
            self.index_in_ends[triangle as usize] = self.ends.len() as u32;
            self.ends.push(triangle);
        } else if !is_end && index_in_ends != NO_TWIN {
            self.remove(triangle);
        }
    }

    fn remove(&mut self, triangle: u32) {
        let index_in_ends = std::mem::replace(&mut self.index_in_ends[triangle as usize], NO_TWIN);
        self.ends.swap_remove(index_in_ends as usize);
        if let Some(&moved) = self.ends.get(index_in_ends as usize) {
            self.index_in_ends[moved as usize] = index_in_ends;
        }
    }

    /// Moves an end. Returns the new end, or [`None`] if it was joined to another one or cannot move.
    fn step(&mut self, end: u32) -> Option<u32> {
        let crossed = self.choose(end)?;
        let taken = self.links.twins()[crossed as usize] / 3;
        let side = self.forest.side_of(end, taken);
        if side.is_none() && self.links.solid_degree(taken) < 2 {
            self.join(crossed);
            self.strip_counts[self.bounds.component[end as usize] as usize] -= 1;
            return None;
        }
        let left = match side {
            Some(side) => self.forest.neighbor(taken, side)?,
            None => self.either_neighbor(taken),
        };
        self.cut(taken, left);
        self.join(crossed);
        self.came_from = taken;
        Some(left)
    }

    /// Chooses a link to cross: one to the end of another strip if possible, otherwise a random one, but
    /// the link that was just cut only if there is no other.
    fn choose(&mut self, end: u32) -> Option<u32> {
        let mut side = 3 * end + self.random.below(3);
        let mut chosen = None;
        for _ in 0..3 {
            let twin = self.links.twins()[side as usize];
            if twin != NO_TWIN && !self.links.is_solid(side) {
                let taken = twin / 3;
                if self.links.solid_degree(taken) < 2
                    && taken != end
                    && self.forest.side_of(end, taken).is_none()
                {
                    return Some(side);
                }
                if chosen.is_none() || self.links.twins()[chosen? as usize] / 3 == self.came_from {
                    chosen = Some(side);
                }
            }
            side = next_side(side);
        }
        chosen
    }

    /// Returns one of the two neighbors along the strip, at random.
    fn either_neighbor(&mut self, triangle: u32) -> u32 {
        let first = self.links.first_solid(triangle).unwrap_or(3 * triangle);
        let second = self.links.other_solid(first).unwrap_or(first);
        let side = if self.random.next_u64() & 1 == 0 { first } else { second };
        self.links.twins()[side as usize] / 3
    }

    fn cut(&mut self, a: u32, b: u32) {
        let twins = self.links.twins();
        let between = |&side: &u32| self.links.is_solid(side) && twins[side as usize] / 3 == b;
        if let Some(side) = (3 * a..3 * a + 3).find(between) {
            self.links.cut(side);
            self.forest.cut(a, b);
            self.update(a);
            self.update(b);
        }
    }

    fn join(&mut self, side: u32) {
        let (a, b) = (side / 3, self.links.twins()[side as usize] / 3);
        self.links.join(side);
        self.forest.join(a, b);
        self.update(a);
        self.update(b);
    }
}
