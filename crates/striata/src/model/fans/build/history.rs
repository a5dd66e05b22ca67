//! All triangles of all levels, by the vertex that stores them and the step that creates them.

use crate::mesh::LevelTable;
use crate::model::fans::crowns::RingArc;
use crate::model::fans::step_counts::StepCounts;

/// Creator of the triangles of the full mesh.
pub(super) const PERMANENT: u32 = u32::MAX;

/// A triangle, the step that creates it when it is collapsed, and its group.
#[derive(Clone, Copy, Debug)]
pub(super) struct HistoryTriangle {
    pub corners: [u32; 3],
    pub creator: u32,
    pub group: u32,
}

/// The triangles of all levels; each belongs to the entry of its newest vertex.
#[derive(Debug)]
pub(super) struct FanHistory {
    triangles: Vec<HistoryTriangle>,
    /// First triangle of each vertex in `entries`, followed by the triangle count.
    firsts: Vec<u32>,
    entries: Vec<u32>,
    /// Pairs of a step and a later one that it waits for although that one creates no triangle of its entry.
    pub waits: Vec<[u32; 2]>,
    /// Pairs of a step and another one that restores a position of its floor but not of its star.
    pub far: Vec<[u32; 2]>,
}

impl FanHistory {
    /// Sorts triangles into entries. `links` has the pairs that do not follow from them.
    pub(super) fn new(triangles: Vec<HistoryTriangle>, links: StepLinks, levels: &LevelTable) -> Self {
        let newest = |triangle: &HistoryTriangle| {
            let [a, b, c] = triangle.corners;
            a.max(b).max(c) as usize
        };
        let mut firsts = vec![0; levels.positions().vertex_count() + 1];
        triangles.iter().for_each(|triangle| firsts[newest(triangle) + 1] += 1);
        for vertex in 1..firsts.len() {
            firsts[vertex] += firsts[vertex - 1];
        }
        let mut next = firsts.clone();
        let mut entries = vec![0; triangles.len()];
        for (index, triangle) in (0..).zip(&triangles) {
            let at = &mut next[newest(triangle)];
            entries[*at as usize] = index;
            *at += 1;
        }
        let StepLinks { mut waits, mut far, .. } = links;
        for pairs in [&mut waits, &mut far] {
            pairs.sort_unstable();
            pairs.dedup();
        }
        Self { triangles, firsts, entries, waits, far }
    }

    /// Number of vertices of the full mesh.
    pub(super) fn vertex_count(&self) -> usize {
        self.firsts.len() - 1
    }

    /// Returns the triangles whose newest vertex is this one.
    pub(super) fn entry(&self, vertex: u32) -> &[u32] {
        &self.entries[self.firsts[vertex as usize] as usize..self.firsts[vertex as usize + 1] as usize]
    }

    /// Returns the group of a triangle.
    pub(super) fn group(&self, triangle: u32) -> u32 {
        self.triangles[triangle as usize].group
    }

    /// Returns the step that creates a triangle, or [`PERMANENT`].
    pub(super) fn creator(&self, triangle: u32) -> u32 {
        self.triangles[triangle as usize].creator
    }

    /// Counts the triangles that each step adds.
    pub(super) fn added_counts(&self, levels: &LevelTable) -> StepCounts {
        let mut counts = vec![0i32; levels.step_count()];
        for vertex in 0..self.vertex_count() as u32 {
            if let Some(step) = levels.step_of(vertex) {
                counts[step as usize] += self.entry(vertex).len() as i32;
            }
        }
        for triangle in self.triangles.iter().filter(|triangle| triangle.creator != PERMANENT) {
            counts[triangle.creator as usize] -= 1;
        }
        StepCounts::new(counts.into_iter())
    }

    /// Returns a triangle as an arc around one of its vertices.
    pub(super) fn arc(&self, vertex: u32, triangle: u32) -> RingArc {
        let HistoryTriangle { corners, creator, .. } = self.triangles[triangle as usize];
        let turn = corners.iter().position(|&v| v == vertex).unwrap_or(0);
        RingArc { from: corners[(turn + 1) % 3], to: corners[(turn + 2) % 3], creator }
    }
}

/// Dependencies between steps that do not follow from the entries.
#[derive(Debug, Default)]
pub(super) struct StepLinks {
    waits: Vec<[u32; 2]>,
    far: Vec<[u32; 2]>,
    star: Vec<u32>,
    floor: Vec<u32>,
}

impl StepLinks {
    /// Notes the dependencies of a step, given the vertices of the triangles that it restores and of those that
    /// it replaces.
    ///
    /// If the floor leaves no triangle at a position of the star, that position must not be removed before this
    /// step, although no entry says so. If the floor has a position that the star does not have, this step must
    /// not be refined before that position.
    pub(super) fn note(
        &mut self,
        step: u32,
        levels: &LevelTable,
        star: impl Iterator<Item = u32>,
        floor: impl Iterator<Item = u32>,
    ) {
        let steps_of = |vertices: &mut dyn Iterator<Item = u32>, out: &mut Vec<u32>| {
            out.clear();
            out.extend(vertices.filter_map(|vertex| levels.step_of(vertex)).filter(|&other| other != step));
            out.sort_unstable();
            out.dedup();
        };
        steps_of(&mut { star }, &mut self.star);
        steps_of(&mut { floor }, &mut self.floor);
        let is_missing = |steps: &[u32], step: &u32| steps.binary_search(step).is_err();
        let uncovered = self.star.iter().filter(|other| is_missing(&self.floor, other));
        self.waits.extend(uncovered.map(|&other| [other, step]));
        let beyond = self.floor.iter().filter(|other| is_missing(&self.star, other));
        self.far.extend(beyond.map(|&other| [step, other]));
    }
}
