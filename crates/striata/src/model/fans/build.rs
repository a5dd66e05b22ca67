//! Builds the table in one pass from the full mesh to the base, removing one position per step.

use super::crowns::{RingArc, crowns};
use super::table::{Creator, Fan, TableWriter};
use super::{Fans, MAX_ARCS};
use crate::mesh::{CollapseSequence, RefinableMesh, is_proper};
use crate::model::step_bounds::StepBounds;
use crate::model::step_vertices::StepVertices;
use crate::{Cancelled, Progress, ProgressFn, ignore_progress};

/// Number of steps or vertices between two calls of the progress callback.
const STEPS_PER_REPORT: usize = 1 << 12;

/// Marks the end of a linked list of triangles.
const END: u32 = u32::MAX;

/// Creator of the triangles of the full mesh.
const PERMANENT: u32 = u32::MAX;

impl Fans {
    /// Builds the table from a mesh and its sequence, including the bounds of its steps.
    ///
    /// # Panics
    /// If the mesh uses vertices that the sequence does not have.
    pub fn build(refinable: &RefinableMesh) -> Self {
        Self::build_with_progress(refinable, &mut ignore_progress)
            .expect("the default callback never cancels")
    }

    /// Builds the table like [`build`](Self::build) and reports progress in steps; the callback can cancel.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels.
    ///
    /// # Panics
    /// See [`build`](Self::build).
    pub fn build_with_progress(
        refinable: &RefinableMesh,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Cancelled> {
        let fans = Builder::table(refinable, progress)?;
        Ok(Self { bounds: Some(StepBounds::of_fans(&fans, refinable, progress)?), ..fans })
    }

    /// Builds the table without bounds, which takes less time. That is sufficient for uniform levels and
    /// for instances that are moved step by step; a [`FanScene`](super::FanScene) and a file need bounds.
    ///
    /// # Panics
    /// If the mesh uses vertices that the sequence does not have.
    pub fn build_without_bounds(refinable: &RefinableMesh) -> Self {
        Builder::table(refinable, &mut ignore_progress).expect("the default callback never cancels")
    }
}

/// A triangle, the step that creates it, and its group.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    corners: [u32; 3],
    creator: u32,
    group: u32,
}

struct Builder<'r> {
    sequence: &'r CollapseSequence,
    /// All triangles of all levels.
    triangles: Vec<Triangle>,
    is_gone: Vec<bool>,
    /// For each corner of a triangle, the next triangle in the list of that corner's vertex.
    next: Vec<[u32; 3]>,
    /// First triangle in the list of each vertex; lists may contain removed triangles.
    chains: Vec<u32>,
    /// Triangles of each vertex's entry.
    entries: Vec<Vec<u32>>,
    /// Pairs of a position and a step that must be collapsed before it although it creates no triangle of
    /// its entry.
    unlisted: Vec<(u32, u32)>,
    /// Pairs of a step and the step of its target, if the floor uses the target's position but the star
    /// does not.
    far: Vec<[u32; 2]>,
    star: Vec<u32>,
    group_count: usize,
}

impl<'r> Builder<'r> {
    /// Builds the table without bounds.
    fn table(refinable: &'r RefinableMesh, progress: &mut ProgressFn<'_>) -> Result<Fans, Cancelled> {
        let mut builder = Self::new(refinable);
        let step_count = refinable.sequence.step_count();
        for step in (0..step_count).rev() {
            if step % STEPS_PER_REPORT == 0 {
                // The other half of the work is in `finish`.
                let (done, total) = ((step_count - step) as u64, 2 * step_count as u64);
                Progress { phase: "fans", done, total }.report(progress)?;
            }
            builder.remove(step);
        }
        builder.finish(progress)
    }

    fn new(refinable: &'r RefinableMesh) -> Self {
        let vertex_count = refinable.sequence.positions().vertex_count();
        let mut builder = Self {
            sequence: &refinable.sequence,
            triangles: Vec::with_capacity(3 * refinable.mesh.triangle_count()),
            is_gone: Vec::new(),
            next: Vec::new(),
            chains: vec![END; vertex_count],
            entries: vec![Vec::new(); vertex_count],
            unlisted: Vec::new(),
            far: Vec::new(),
            star: Vec::new(),
            group_count: refinable.mesh.groups.len().max(1),
        };
        for (group, range) in (0..).zip(refinable.mesh.groups_or_whole().iter().map(|group| group.range())) {
            for &corners in refinable.mesh.triangles[range].iter().filter(|t| is_proper(t)) {
                builder.add(Triangle { corners, creator: PERMANENT, group });
            }
        }
        builder
    }

    fn add(&mut self, triangle: Triangle) {
        let index = self.triangles.len() as u32;
        self.triangles.push(triangle);
        self.is_gone.push(false);
        self.next.push(triangle.corners.map(|v| std::mem::replace(&mut self.chains[v as usize], index)));
    }

    /// Removes a position: its star becomes the entries of its vertices, and its floor replaces the star.
    fn remove(&mut self, step: usize) {
        let vertices = self.sequence.step_vertices(step);
        self.star.clear();
        // A triangle is stored with its newest vertex, even if several wedges of the position are among
        // its corners.
        for vertex in vertices.clone().rev() {
            let mut at = self.chains[vertex as usize];
            while at != END {
                let corners = self.triangles[at as usize].corners;
                if !std::mem::replace(&mut self.is_gone[at as usize], true) {
                    self.star.push(at);
                    self.entries[vertex as usize].push(at);
                }
                let corner = corners.iter().position(|&v| v == vertex).unwrap_or(0);
                at = self.next[at as usize][corner];
            }
        }
        let star = std::mem::take(&mut self.star);
        let mut covered = Vec::new();
        for &triangle in &star {
            let Triangle { corners, group, .. } = self.triangles[triangle as usize];
            let floor = corners.map(|v| if vertices.contains(&v) { self.sequence.target(v) } else { v });
            if is_proper(&floor) {
                covered.extend(floor.map(|v| self.sequence.positions().position_of(v)));
                self.add(Triangle { corners: floor, creator: step as u32, group });
            }
        }
        covered.sort_unstable();
        self.note_far_target(step as u32, &star, &covered);
        // If the floor leaves no triangle at a neighbor, the dependency does not follow from any entry and
        // is listed.
        for &triangle in &star {
            for vertex in self.triangles[triangle as usize].corners {
                let position = self.sequence.positions().position_of(vertex);
                if !vertices.contains(&vertex) && covered.binary_search(&position).is_err() {
                    self.unlisted.push((position, step as u32));
                }
            }
        }
        self.star = star;
    }

    fn note_far_target(&mut self, step: u32, star: &[u32], covered: &[u32]) {
        let positions = self.sequence.positions();
        let first = self.sequence.step_vertices(step as usize).start;
        let target = positions.position_of(self.sequence.target(first));
        let Some(target_step) = target.checked_sub(self.sequence.base_position_count() as u32) else {
            return;
        };
        let corners = || star.iter().flat_map(|&triangle| self.triangles[triangle as usize].corners);
        if covered.binary_search(&target).is_ok() && corners().all(|v| positions.position_of(v) != target) {
            self.far.push([step, target_step]);
        }
    }

    /// Returns a triangle as an arc around one of its vertices.
    fn arc(&self, vertex: u32, triangle: u32) -> RingArc {
        let Triangle { corners, creator, .. } = self.triangles[triangle as usize];
        let turn = corners.iter().position(|&v| v == vertex).unwrap_or(0);
        RingArc { from: corners[(turn + 1) % 3], to: corners[(turn + 2) % 3], creator }
    }

    /// Returns the step that removes a vertex plus 1, or 0 for a base vertex.
    fn own_step(&self, vertex: usize) -> u32 {
        let position = self.sequence.positions().position_of(vertex as u32);
        (position + 1).saturating_sub(self.sequence.base_position_count() as u32)
    }

    fn tree(&self) -> Tree {
        let mut tree = Tree::new(self.sequence.step_count());
        for (vertex, entry) in self.entries.iter().enumerate() {
            let own_step = self.own_step(vertex);
            entry.iter().for_each(|&triangle| {
                tree.add_entry_step(self.triangles[triangle as usize].creator, own_step)
            });
        }
        tree
    }

    fn finish(mut self, progress: &mut ProgressFn<'_>) -> Result<Fans, Cancelled> {
        // The remaining triangles form the base mesh; like all others, they are stored with their newest
        // vertex.
        for triangle in 0..self.triangles.len() {
            if !self.is_gone[triangle] {
                let [a, b, c] = self.triangles[triangle].corners;
                self.entries[a.max(b).max(c) as usize].push(triangle as u32);
            }
        }
        self.unlisted.sort_unstable();
        self.unlisted.dedup();
        let mut table = TableWriter::new(self.group_count > 1);
        let base = self.sequence.base_position_count() as u32;
        let mut tree = self.tree();
        let (mut arcs, mut fans) = (Vec::new(), Vec::new());
        let vertex_count = self.entries.len();
        for (vertex, mut entry) in std::mem::take(&mut self.entries).into_iter().enumerate() {
            if vertex % STEPS_PER_REPORT == 0 {
                let (done, total) = ((vertex_count + vertex) as u64, 2 * vertex_count as u64);
                Progress { phase: "fans", done, total }.report(progress)?;
            }
            entry.sort_by_key(|&triangle| self.triangles[triangle as usize].group);
            let group_of = |&triangle: &u32| self.triangles[triangle as usize].group;
            fans.clear();
            for of_group in entry.chunk_by(|a, b| group_of(a) == group_of(b)) {
                arcs.clear();
                arcs.extend(of_group.iter().map(|&t| self.arc(vertex as u32, t)));
                push_crowns(&crowns(&mut arcs), group_of(&of_group[0]), &mut fans);
            }
            let own_step = self.own_step(vertex);
            tree.mark_children(own_step, &mut fans);
            table.push(own_step, &fans);
        }
        let waits = self.unlisted.iter().filter(|wait| wait.0 >= base);
        // They were found from the last step to the first.
        self.far.reverse();
        Ok(Fans {
            vertices: StepVertices::of_sequence(self.sequence).without_targets(),
            step_count: self.sequence.step_count(),
            group_count: self.group_count,
            table: table.finish(),
            waits: waits.map(|&(position, waits_for)| [position - base, waits_for]).collect(),
            far: self.far,
            orphans: tree.orphans(),
            removed: self.sequence.removed_triangle_counts().into(),
            bounds: None,
        })
    }
}

/// The parent of each step, which is the coarsest position that depends on it, and whether an entry lists
/// the step as its child.
struct Tree {
    /// Step of the parent plus 1, 0 for the base, or `u32::MAX` if no entry names the step.
    parents: Vec<u32>,
    is_listed: Vec<bool>,
}

impl Tree {
    fn new(step_count: usize) -> Self {
        Self { parents: vec![u32::MAX; step_count], is_listed: vec![false; step_count] }
    }

    /// Records that the entry of a position names a step; `own_step` is the step of the position plus 1.
    fn add_entry_step(&mut self, step: u32, own_step: u32) {
        if let Some(parent) = self.parents.get_mut(step as usize) {
            *parent = own_step.min(*parent);
        }
    }

    /// Marks the children of a position in the fans of one of its vertices, each only once.
    fn mark_children(&mut self, own_step: u32, fans: &mut [Fan]) {
        for creator in fans.iter_mut().flat_map(|fan| &mut fan.creators) {
            let step = creator.step as usize;
            if self.parents[step] == own_step {
                creator.is_child = !std::mem::replace(&mut self.is_listed[step], true);
            }
        }
    }

    /// Returns the steps that no entry lists as a child.
    fn orphans(self) -> Vec<u32> {
        (0..).zip(&self.is_listed).filter(|(_, is_listed)| !**is_listed).map(|(step, _)| step).collect()
    }
}

/// Appends the fans of crowns, cutting those with more than [`MAX_ARCS`] arcs.
fn push_crowns(crowns: &[Vec<RingArc>], group: u32, fans: &mut Vec<Fan>) {
    for crown in crowns {
        let pieces = crown.chunks(MAX_ARCS);
        fans.extend(pieces.map(|piece| fan_of(piece, crown.len() == piece.len(), group)));
    }
}

/// Makes a fan of consecutive arcs; `is_whole` is set if they are an entire crown, which may then be closed.
fn fan_of(arcs: &[RingArc], is_whole: bool, group: u32) -> Fan {
    let mut fan = Fan { group, arc_count: arcs.len(), ..Fan::default() };
    fan.nodes.extend(arcs.iter().map(|arc| arc.from));
    let (first, last) = (arcs[0], arcs[arcs.len() - 1]);
    if !(is_whole && last.to == first.from) {
        fan.nodes.push(last.to);
    }
    for (at, arc) in arcs.iter().enumerate() {
        let bit = 1 << at;
        if arc.creator == PERMANENT {
            fan.permanent |= bit;
        } else if let Some(creator) = fan.creators.iter_mut().find(|c| c.step == arc.creator) {
            creator.mask |= bit;
        } else {
            fan.creators.push(Creator { step: arc.creator, mask: bit, is_child: false });
        }
    }
    fan
}
