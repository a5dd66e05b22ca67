//! Greedy strips: from triangles with few free neighbors, walk both ways, keep the best of three walks.
//!
//! The next strip starts where a triangle is most in danger of being left alone. Through that triangle run
//! three walks, one for each pair of its edges; each goes on straight (no swap) where it can, turns where it
//! must, and the walk that saves most indices becomes the strip. In the spirit of SGI's `tomesh` and of
//! \[ESV96\], but the merit is indices (`swaps + 3 * strips`), not the number of strips.
//! Time and memory are linear: at most three times the triangles of the chosen strip are looked at.

use std::ops::Range;

use super::links::{StripLinks, next_side, prev_side};
use super::seeds::{FreeTriangles, Seeds};
use super::strip_set::StripSet;
use super::write::write_strips;
use crate::mesh::{DualGraph, IndexedMesh, MeshError, NO_TWIN};

/// Covers each triangle of a mesh by exactly one strip, quickly and with few indices; degenerate triangles (two equal
/// corners) are left out.
///
/// The groups of the set are those of the mesh (one if it has none). Stripifiers that search for better strips are in the
/// crate `striata-strip`.
///
/// ```
/// use striata::mesh::shapes;
///
/// let mesh = shapes::grid(8, 8);
/// let strips = striata::strip::stripify(&mesh)?;
/// assert_eq!(strips.cost().triangle_count, mesh.triangle_count());
/// # Ok::<(), striata::mesh::MeshError>(())
/// ```
///
/// # Errors
/// [`MeshError`] if the mesh's parts do not fit together.
pub fn stripify(mesh: &IndexedMesh) -> Result<StripSet, MeshError> {
    mesh.check()?;
    let graph = DualGraph::of_vertices(mesh);
    let groups: Vec<_> = mesh.groups_or_whole().iter().map(|group| group.range()).collect();
    let mut links = StripLinks::new(&graph);
    join_greedily(&mesh.triangles, &groups, &mut links);
    let mut out = StripSet::new();
    write_strips(&mesh.triangles, &links, groups, &mut out);
    Ok(out)
}

/// Joins triangles that stand alone into strips, group by group (each a range of triangles); strips that are there already
/// stay as they are.
///
/// # Panics
/// If `triangles` are not those of the graph that the links belong to, or a group goes beyond them.
pub fn join_greedily(triangles: &[[u32; 3]], groups: &[Range<usize>], links: &mut StripLinks<'_>) {
    let stamps = vec![0; triangles.len()];
    let free = FreeTriangles::new(triangles, links);
    let mut walker = Walker { free, twins: links.twins(), stamps, stamp: 0 };
    for group in groups {
        join_group(&mut walker, group.clone(), links);
    }
}

fn join_group(walker: &mut Walker<'_>, group: Range<usize>, links: &mut StripLinks<'_>) {
    let mut seeds = Seeds::new(&walker.free, group);
    let (mut best, mut trial) = (Walk::default(), Walk::default());
    while let Some(seed) = seeds.pop(&walker.free) {
        best.clear();
        for edge in 3 * seed..3 * seed + 3 {
            walker.walk_both_ways(edge, &mut trial);
            if best.is_empty() || trial.merit() > best.merit() {
                std::mem::swap(&mut best, &mut trial);
            }
        }
        for &entered in best.back.iter().chain(&best.front) {
            links.join(entered);
        }
        for &h in best.back.iter().chain(&best.front).chain([&(3 * seed)]) {
            walker.free.take(h / 3);
        }
        for &h in best.back.iter().chain(&best.front).chain([&(3 * seed)]) {
            seeds.push_around(h / 3, &walker.free);
        }
    }
}

/// A walk through a seed: the half-edges by which the triangles after and before it are entered.
#[derive(Default)]
struct Walk {
    seed: u32,
    front: Vec<u32>,
    back: Vec<u32>,
    swap_count: usize,
}

impl Walk {
    fn clear(&mut self) {
        self.front.clear();
        self.back.clear();
        self.seed = NO_TWIN;
        self.swap_count = 0;
    }

    fn is_empty(&self) -> bool {
        self.seed == NO_TWIN
    }

    /// Indices saved against a strip for every triangle.
    fn merit(&self) -> i64 {
        3 * (self.front.len() + self.back.len()) as i64 - self.swap_count as i64
    }
}

struct Walker<'a> {
    free: FreeTriangles<'a>,
    twins: &'a [u32],
    /// The trial that last passed each triangle.
    stamps: Vec<u32>,
    stamp: u32,
}

impl Walker<'_> {
    /// Whether a walk may leave a triangle by this half-edge.
    #[inline]
    fn is_open(&self, exit: u32) -> bool {
        self.free.beyond(exit).is_some_and(|enter| self.stamps[enter as usize / 3] != self.stamp)
    }

    /// Walks from the triangle of `exit` forward through `exit` and backward through the edge before it.
    fn walk_both_ways(&mut self, exit: u32, walk: &mut Walk) {
        self.stamp += 1;
        walk.clear();
        walk.seed = exit;
        self.stamps[exit as usize / 3] = self.stamp;
        // Entered by the edge before `exit`, the seed turns to the next edge; seen from behind, to the one before.
        walk.swap_count = self.walk(exit, false, &mut walk.front);
        walk.swap_count += self.walk(prev_side(exit), true, &mut walk.back);
    }

    /// Appends the half-edges by which triangles are entered; `turns_next` is the turn that needs no swap.
    fn walk(&mut self, mut exit: u32, mut turns_next: bool, entered: &mut Vec<u32>) -> usize {
        let mut swap_count = 0;
        while self.is_open(exit) {
            let enter = self.twins[exit as usize];
            self.stamps[enter as usize / 3] = self.stamp;
            entered.push(enter);
            let (mut straight, mut turned) = (next_side(enter), prev_side(enter));
            if !turns_next {
                (straight, turned) = (turned, straight);
            }
            exit = straight;
            if self.is_open(turned) && (!self.is_open(straight) || self.strands(turned, straight)) {
                exit = turned;
                swap_count += 1;
            } else {
                turns_next = !turns_next;
            }
        }
        swap_count
    }

    /// Whether going straight would leave a triangle alone that a swap picks up without ending the walk.
    fn strands(&self, turned: u32, straight: u32) -> bool {
        let ways_on = |exit: u32| {
            let enter = self.twins[exit as usize];
            usize::from(self.is_open(next_side(enter))) + usize::from(self.is_open(prev_side(enter)))
        };
        ways_on(turned) == 1 && ways_on(straight) == 2
    }
}
