//! The history of collapses, found by removing one position per step from the full mesh to the base.

use super::STEPS_PER_REPORT;
use super::history::{FanHistory, HistoryTriangle, PERMANENT, StepLinks};
use crate::mesh::{CollapseSequence, RefinableMesh, is_proper};
use crate::{Cancelled, Progress, ProgressFn};

/// Marks the end of a linked list of triangles.
const END: u32 = u32::MAX;

/// Collects the triangles of all levels of a mesh with collapses.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
pub(super) fn history(
    refinable: &RefinableMesh,
    progress: &mut ProgressFn<'_>,
) -> Result<FanHistory, Cancelled> {
    let mut replay = CollapseReplay::new(refinable);
    let step_count = refinable.sequence.step_count();
    for step in (0..step_count).rev() {
        if step % STEPS_PER_REPORT == 0 {
            // Writing the table is the other half of the work.
            let (done, total) = ((step_count - step) as u64, 2 * step_count as u64);
            Progress { phase: "fans", done, total }.report(progress)?;
        }
        replay.remove(step);
    }
    Ok(FanHistory::new(replay.triangles, replay.links, refinable.sequence.levels()))
}

/// The current triangles, with a linked list for each vertex.
struct CollapseReplay<'r> {
    sequence: &'r CollapseSequence,
    /// All triangles found so far.
    triangles: Vec<HistoryTriangle>,
    is_gone: Vec<bool>,
    /// For each corner of a triangle, the next triangle in the list of that corner's vertex.
    next: Vec<[u32; 3]>,
    /// First triangle in the list of each vertex; lists may contain removed triangles.
    chains: Vec<u32>,
    links: StepLinks,
    star: Vec<u32>,
}

impl<'r> CollapseReplay<'r> {
    fn new(refinable: &'r RefinableMesh) -> Self {
        let vertex_count = refinable.sequence.positions().vertex_count();
        let mut replay = Self {
            sequence: &refinable.sequence,
            triangles: Vec::with_capacity(3 * refinable.mesh.triangle_count()),
            is_gone: Vec::new(),
            next: Vec::new(),
            chains: vec![END; vertex_count],
            links: StepLinks::default(),
            star: Vec::new(),
        };
        for (group, range) in (0..).zip(refinable.mesh.groups_or_whole().iter().map(|group| group.range())) {
            for &corners in refinable.mesh.triangles[range].iter().filter(|t| is_proper(t)) {
                replay.add(HistoryTriangle { corners, creator: PERMANENT, group });
            }
        }
        replay
    }

    fn add(&mut self, triangle: HistoryTriangle) {
        let index = self.triangles.len() as u32;
        self.triangles.push(triangle);
        self.is_gone.push(false);
        self.next.push(triangle.corners.map(|v| std::mem::replace(&mut self.chains[v as usize], index)));
    }

    /// Removes a position: its floor replaces its star.
    fn remove(&mut self, step: usize) {
        let vertices = self.sequence.step_vertices(step);
        let mut star = std::mem::take(&mut self.star);
        star.clear();
        for vertex in vertices.clone() {
            let mut at = self.chains[vertex as usize];
            while at != END {
                let corners = self.triangles[at as usize].corners;
                if !std::mem::replace(&mut self.is_gone[at as usize], true) {
                    star.push(at);
                }
                let corner = corners.iter().position(|&v| v == vertex).unwrap_or(0);
                at = self.next[at as usize][corner];
            }
        }
        let first = self.triangles.len();
        for &triangle in &star {
            let HistoryTriangle { corners, group, .. } = self.triangles[triangle as usize];
            let floor = corners.map(|v| if vertices.contains(&v) { self.sequence.target(v) } else { v });
            if is_proper(&floor) {
                self.add(HistoryTriangle { corners: floor, creator: step as u32, group });
            }
        }
        let corners = star.iter().flat_map(|&triangle| self.triangles[triangle as usize].corners);
        let floor = self.triangles[first..].iter().flat_map(|triangle| triangle.corners);
        self.links.note(step as u32, self.sequence.levels(), corners, floor);
        self.star = star;
    }
}
