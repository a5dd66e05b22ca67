//! Fewest strips: ends of strips walk at random until they meet.
//!
//! The end of a strip takes a neighboring triangle, which lets go of one of its own neighbors: that one is the next
//! end. The number of strips stays, no loop closes if a triangle of the same strip lets go of the neighbor on
//! the end's side, and where an end meets the end of another strip the two become one. It is a tunnel without
//! a limit of length, dug without a search; balanced trees (`path_forest`) say which strip a triangle is in. In each
//! component it stops at a number that provably cannot be beaten (`bound`).
//!
//! Our own, after the step of \[PS03\]; in one strip the step is Pósa's rotation of Hamiltonian paths.
//! A step costs about a microsecond; with `s` strips left some `n / s` steps join two. 60 bytes a triangle.

mod bound;
mod path_forest;

use striata::mesh::{DualGraph, IndexedMesh, NO_TWIN, Random, is_proper};
use striata::strip::{StripLinks, StripPath, next_side};

use crate::stripifier::DEFAULT_TUNNEL_LENGTH;
use crate::task::{SpentFn, Task};
use crate::tunnel::{self, Identity, ends_of, join_ends};
use bound::Bounds;
use path_forest::PathForest;

/// Steps after which another end has its turn, while many ends are left and when few are.
///
/// Where few strips are left a walk has no choices, and one that comes to a boundary runs back as it came; the
/// walks of other ends change what it finds. On the bunny in 3 s, six seeds: 3 or 4 strips with 64 steps at last, 3 to 5
/// with 8, 4 or 5 with 256. Before that, going on is better than beginning in a cold part of memory.
const WALK_STEPS: [u64; 2] = [4096, 64];
/// So many ends are few.
const FEW_ENDS: usize = 32;

/// Searches for tunnels after the walks.
const LAST_SEARCHES: u64 = 1024;

/// A number of strips that no strips along the links of a mesh's dual graph can go below, proven from that graph.
///
/// Where more than two triangles share an edge, the graph pairs them in one way of several, and another way might do
/// with fewer. Strips that `cheapest` joins at a vertex follow no link there and count as one.
///
/// # Panics
/// If a triangle names a vertex that is not there, or groups do not cover the triangles.
pub fn strip_count_bound(mesh: &IndexedMesh) -> usize {
    let is_degenerate = |t: u32| !is_proper(&mesh.triangles[t as usize]);
    Bounds::new(&DualGraph::of_vertices(mesh), is_degenerate).least.iter().map(|&least| least as usize).sum()
}

/// Joins strips until every component has as few as can be, or the budget is spent.
///
/// Where boundaries and seams leave ends little room to walk, a last search for tunnels finds what walks have missed.
pub(crate) fn run(task: &Task<'_>, graph: &DualGraph, links: &mut StripLinks<'_>, spent: &mut SpentFn<'_>) {
    if walk_ends(task, graph, links, spent) {
        let mut few = |searches| searches as f64 / LAST_SEARCHES as f64;
        tunnel::run(task, links, DEFAULT_TUNNEL_LENGTH, Identity::Dynamic, &mut few);
    }
}

/// Walks until the budget is spent; whether any component still has more strips than it is known to need.
fn walk_ends(
    task: &Task<'_>,
    graph: &DualGraph,
    links: &mut StripLinks<'_>,
    spent: &mut SpentFn<'_>,
) -> bool {
    let mut random = Random::new(task.options.seed);
    join_ends(&ends_of(task, links), links, &mut random);
    let bounds = Bounds::new(graph, |t| !task.is_proper(t));
    let ends = ends_of(task, links);
    let mut walker = Walker::new(links, &ends, bounds, random);
    let mut step_count = 0;
    while let Some(mut end) = walker.pick_end() {
        let is_late = walker.ends.len() <= FEW_ENDS;
        for _ in 0..WALK_STEPS[usize::from(is_late)] {
            // Asked before the step: ends that cannot move must spend too.
            if step_count % 256 == 0 && spent(step_count) >= 1.0 {
                return true;
            }
            step_count += 1;
            match walker.step(end) {
                Some(moved) => end = moved,
                None => break,
            }
        }
    }
    false
}

/// Strips whose ends walk.
struct Walker<'a, 'g> {
    links: &'a mut StripLinks<'g>,
    forest: PathForest,
    /// Triangles where strips end, of components that have too many strips.
    ends: Vec<u32>,
    /// Where in `ends` a triangle is, or none.
    place: Vec<u32>,
    bounds: Bounds,
    /// Strips of each component.
    strip_counts: Vec<u32>,
    /// What the moving end was let go by: it does not go back there if there is another way.
    came_from: u32,
    random: Random,
}

impl<'a, 'g> Walker<'a, 'g> {
    fn new(links: &'a mut StripLinks<'g>, ends: &[u32], bounds: Bounds, random: Random) -> Self {
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
        let place = vec![NO_TWIN; count];
        let mut walker =
            Self { links, forest, ends: Vec::new(), place, bounds, strip_counts, came_from: NO_TWIN, random };
        for &end in ends {
            walker.update(end);
        }
        walker
    }

    /// An end to walk with, at random; none when no component can do with fewer strips.
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

    /// Whether the component of a triangle has more strips than it needs, as far as is known.
    fn is_open(&self, triangle: u32) -> bool {
        let component = self.bounds.component[triangle as usize] as usize;
        self.strip_counts[component] > self.bounds.least[component]
    }

    /// Notes whether a triangle is an end.
    fn update(&mut self, triangle: u32) {
        let is_end = self.links.solid_degree(triangle) < 2;
        let place = self.place[triangle as usize];
        if is_end && place == NO_TWIN {
            self.place[triangle as usize] = self.ends.len() as u32;
            self.ends.push(triangle);
        } else if !is_end && place != NO_TWIN {
            self.remove(triangle);
        }
    }

    fn remove(&mut self, triangle: u32) {
        let place = std::mem::replace(&mut self.place[triangle as usize], NO_TWIN);
        self.ends.swap_remove(place as usize);
        if let Some(&moved) = self.ends.get(place as usize) {
            self.place[moved as usize] = place;
        }
    }

    /// Moves an end: where to; none if it was joined to another one or has nowhere to go.
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

    /// A link to cross: to the end of another strip if there is one, else at random, but not back.
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

    /// One of the two neighbors along the strip.
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
