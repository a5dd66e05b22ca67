//! The fast greedy stripifier: starts at triangles with few free neighbors and keeps the best of three walks.
//!
//! Each strip starts at the triangle that is most likely to be left isolated. Three walks run through that
//! triangle, one for each pair of its edges. A walk continues without a swap if it can and swaps if it
//! must; the walk that saves most indices becomes the strip. This follows the idea of SGI's `tomesh` and
//! \[ESV96\], but minimizes the number of indices (`swaps + 3 * strips`) instead of the number of strips.
//! Time and memory are linear: for each strip, at most three times its triangles are visited.

use std::ops::Range;

use super::links::{StripLinks, next_side, prev_side};
use super::seeds::{FreeTriangles, Seeds};
use super::strip_set::StripSet;
use super::write::write_strips;
use crate::mesh::{DualGraph, IndexedMesh, MeshError, NO_TWIN};
use crate::{Cancelled, Progress, ProgressFn, ignore_progress};

/// Number of triangles joined between two calls of the progress callback.
const TRIANGLES_PER_REPORT: u64 = 1 << 14;

/// Covers each triangle of a mesh by exactly one strip, quickly and with few indices.
///
/// Degenerate triangles (two equal corners) are left out. The set has the same groups as the mesh, or a
/// single group if the mesh has none. For stripifiers that search for better strips, see the crate
/// `striata-strip`.
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
/// [`MeshError`] if the mesh is inconsistent.
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

/// Joins triangles that do not belong to a strip yet into strips, group by group; existing strips stay as
/// they are.
///
/// Each group is a range of triangles.
///
/// # Panics
/// If `triangles` are not those of the links' graph, or if a group extends past them.
pub fn join_greedily(triangles: &[[u32; 3]], groups: &[Range<usize>], links: &mut StripLinks<'_>) {
    join_greedily_with_progress(triangles, groups, links, &mut ignore_progress)
        .expect("the default callback never cancels");
}

/// Runs [`join_greedily`] and reports progress in triangles; the callback can cancel, which leaves the strips
/// made so far.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
///
/// # Panics
/// See [`join_greedily`].
pub fn join_greedily_with_progress(
    triangles: &[[u32; 3]],
    groups: &[Range<usize>],
    links: &mut StripLinks<'_>,
    progress: &mut ProgressFn<'_>,
) -> Result<(), Cancelled> {
    let last_walks = vec![0; triangles.len()];
    let free = FreeTriangles::new(triangles, links);
    let mut grower = StripGrower { free, twins: links.twins(), last_walks, walk_index: 0 };
    let (mut done, mut reported) = (0, 0);
    for group in groups {
        join_group(&mut grower, group.clone(), links, &mut |triangle_count| {
            done += triangle_count as u64;
            if done < reported + TRIANGLES_PER_REPORT {
                return Ok(());
            }
            reported = done;
            Progress { phase: "strip", done, total: triangles.len() as u64 }.report(progress)
        })?;
    }
    Ok(())
}

/// Joins the triangles of a group; `report` gets the number of triangles of each strip.
fn join_group(
    grower: &mut StripGrower<'_>,
    group: Range<usize>,
    links: &mut StripLinks<'_>,
    report: &mut dyn FnMut(usize) -> Result<(), Cancelled>,
) -> Result<(), Cancelled> {
    let mut seeds = Seeds::new(&grower.free, group);
    let (mut best, mut trial) = (SeedWalk::default(), SeedWalk::default());
    while let Some(seed) = seeds.pop(&grower.free) {
        best.clear();
        for edge in 3 * seed..3 * seed + 3 {
            grower.walk_both_ways(edge, &mut trial);
            if best.is_empty() || trial.saved_index_count() > best.saved_index_count() {
                std::mem::swap(&mut best, &mut trial);
            }
        }
        for &entered in best.back.iter().chain(&best.front) {
            links.join(entered);
        }
        for &h in best.back.iter().chain(&best.front).chain([&(3 * seed)]) {
            grower.free.mark_used(h / 3);
        }
        for &h in best.back.iter().chain(&best.front).chain([&(3 * seed)]) {
            seeds.push_around(h / 3, &grower.free);
        }
        report(best.back.len() + best.front.len() + 1)?;
    }
    Ok(())
}

/// A walk through a seed triangle, given by the sides through which the triangles after and before it are
/// entered.
#[derive(Default)]
struct SeedWalk {
    seed: u32,
    front: Vec<u32>,
    back: Vec<u32>,
    swap_count: usize,
}

impl SeedWalk {
    fn clear(&mut self) {
        self.front.clear();
        self.back.clear();
        self.seed = NO_TWIN;
        self.swap_count = 0;
    }

    fn is_empty(&self) -> bool {
        self.seed == NO_TWIN
    }

    /// Number of indices saved compared with one strip per triangle.
    fn saved_index_count(&self) -> i64 {
        3 * (self.front.len() + self.back.len()) as i64 - self.swap_count as i64
    }
}

struct StripGrower<'a> {
    free: FreeTriangles<'a>,
    twins: &'a [u32],
    /// Index of the last walk that passed each triangle.
    last_walks: Vec<u32>,
    walk_index: u32,
}

impl StripGrower<'_> {
    /// Whether the current walk can leave a triangle through this side.
    #[inline]
    fn is_open(&self, exit: u32) -> bool {
        self.free
            .free_entry_across(exit)
            .is_some_and(|enter| self.last_walks[enter as usize / 3] != self.walk_index)
    }

    /// Walks from the triangle of `exit` forward through `exit` and backward through the side before it.
    fn walk_both_ways(&mut self, exit: u32, walk: &mut SeedWalk) {
        self.walk_index += 1;
        walk.clear();
        walk.seed = exit;
        self.last_walks[exit as usize / 3] = self.walk_index;
        // Entered by the side before `exit`, the seed turns to the next side; seen from the other end, to
        // the previous one.
        walk.swap_count = self.walk(exit, false, &mut walk.front);
        walk.swap_count += self.walk(prev_side(exit), true, &mut walk.back);
    }

    /// Appends the sides through which triangles are entered; `turns_next` is the direction that needs no
    /// swap. Returns the number of swaps.
    fn walk(&mut self, mut exit: u32, mut turns_next: bool, entered: &mut Vec<u32>) -> usize {
        let mut swap_count = 0;
        while self.is_open(exit) {
            let enter = self.twins[exit as usize];
            self.last_walks[enter as usize / 3] = self.walk_index;
            entered.push(enter);
            let (mut straight, mut turned) = (next_side(enter), prev_side(enter));
            if !turns_next {
                (straight, turned) = (turned, straight);
            }
            exit = straight;
            if self.is_open(turned) && (!self.is_open(straight) || self.isolates(turned, straight)) {
                exit = turned;
                swap_count += 1;
            } else {
                turns_next = !turns_next;
            }
        }
        swap_count
    }

    /// Whether going straight would isolate a triangle that a swap would include without ending the walk.
    fn isolates(&self, turned: u32, straight: u32) -> bool {
        let open_side_count = |exit: u32| {
            let enter = self.twins[exit as usize];
            usize::from(self.is_open(next_side(enter))) + usize::from(self.is_open(prev_side(enter)))
        };
        open_side_count(turned) == 1 && open_side_count(straight) == 2
    }
}
