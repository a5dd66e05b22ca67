//! Building the table: one pass from the full mesh to the base, step by step around what each removes.

use super::crowns::{RingArc, crowns};
use super::table::{Creator, Fan, TableWriter};
use super::{Fans, MAX_ARCS};
use crate::mesh::{CollapseSequence, RefinableMesh, is_proper};
use crate::model::step_bounds::StepBounds;
use crate::model::step_vertices::StepVertices;

/// Ends a chain of triangles.
const END: u32 = u32::MAX;

/// Stands for the step that makes a triangle of the full mesh.
const ALWAYS: u32 = u32::MAX;

impl Fans {
    /// Builds the table from a mesh and its sequence, with the bounds of its steps.
    ///
    /// # Panics
    /// If the mesh is not the sequence's: it names vertices that the sequence does not have.
    pub fn build(refinable: &RefinableMesh) -> Self {
        let fans = Self::build_without_bounds(refinable);
        Self { bounds: Some(StepBounds::of_fans(&fans, refinable)), ..fans }
    }

    /// Builds the table alone, which takes less time. Uniform levels and instances that are moved step by step need no more; a
    /// [`FanScene`](super::FanScene) and a file do.
    ///
    /// # Panics
    /// As [`build`](Self::build).
    pub fn build_without_bounds(refinable: &RefinableMesh) -> Self {
        let mut builder = Builder::new(refinable);
        for step in (0..refinable.sequence.step_count()).rev() {
            builder.remove(step);
        }
        builder.finish()
    }
}

/// A triangle, the step that makes it, and its group.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    corners: [u32; 3],
    creator: u32,
    group: u32,
}

struct Builder<'r> {
    sequence: &'r CollapseSequence,
    /// All triangles that there ever are.
    triangles: Vec<Triangle>,
    is_gone: Vec<bool>,
    /// The first of three links of each triangle's chains: one for each corner.
    next: Vec<[u32; 3]>,
    /// First triangle of each vertex, triangles that are gone among them.
    chains: Vec<u32>,
    /// The triangles of each vertex's entry.
    entries: Vec<Vec<u32>>,
    /// Steps that each position waits for beside those that make its triangles.
    bare: Vec<(u32, u32)>,
    /// Steps whose floor has a corner at a position that the star has none at: that of their target.
    far: Vec<[u32; 2]>,
    star: Vec<u32>,
    group_count: usize,
}

impl<'r> Builder<'r> {
    fn new(refinable: &'r RefinableMesh) -> Self {
        let vertex_count = refinable.sequence.positions().vertex_count();
        let mut builder = Self {
            sequence: &refinable.sequence,
            triangles: Vec::with_capacity(3 * refinable.mesh.triangle_count()),
            is_gone: Vec::new(),
            next: Vec::new(),
            chains: vec![END; vertex_count],
            entries: vec![Vec::new(); vertex_count],
            bare: Vec::new(),
            far: Vec::new(),
            star: Vec::new(),
            group_count: refinable.mesh.groups.len().max(1),
        };
        for (group, range) in (0..).zip(refinable.mesh.groups_or_whole().iter().map(|group| group.range())) {
            for &corners in refinable.mesh.triangles[range].iter().filter(|t| is_proper(t)) {
                builder.add(Triangle { corners, creator: ALWAYS, group });
            }
        }
        builder
    }

    fn add(&mut self, triangle: Triangle) {
        let number = self.triangles.len() as u32;
        self.triangles.push(triangle);
        self.is_gone.push(false);
        self.next.push(triangle.corners.map(|v| std::mem::replace(&mut self.chains[v as usize], number)));
    }

    /// Removes a position: its star becomes the entries of its vertices, its floor takes the star's place.
    fn remove(&mut self, step: usize) {
        let vertices = self.sequence.step_vertices(step);
        self.star.clear();
        // A triangle stands with its last vertex, also where wedges of the position meet in it.
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
        // Where nothing of the floor is left at a neighbor, no triangle tells it to wait for this step.
        for &triangle in &star {
            for vertex in self.triangles[triangle as usize].corners {
                let position = self.sequence.positions().position_of(vertex);
                if !vertices.contains(&vertex) && covered.binary_search(&position).is_err() {
                    self.bare.push((position, step as u32));
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

    /// A triangle as its vertex sees it.
    fn arc(&self, vertex: u32, triangle: u32) -> RingArc {
        let Triangle { corners, creator, .. } = self.triangles[triangle as usize];
        let turn = corners.iter().position(|&v| v == vertex).unwrap_or(0);
        RingArc { from: corners[(turn + 1) % 3], to: corners[(turn + 2) % 3], creator }
    }

    /// The step that takes a vertex away and one, or 0 for a vertex of the base.
    fn own_step(&self, vertex: usize) -> u32 {
        let position = self.sequence.positions().position_of(vertex as u32);
        (position + 1).saturating_sub(self.sequence.base_position_count() as u32)
    }

    fn tree(&self) -> Tree {
        let mut tree = Tree::new(self.sequence.step_count());
        for (vertex, entry) in self.entries.iter().enumerate() {
            let own_step = self.own_step(vertex);
            entry.iter().for_each(|&triangle| tree.note(self.triangles[triangle as usize].creator, own_step));
        }
        tree
    }

    fn finish(mut self) -> Fans {
        // What is left is the base: its triangles stand with their last vertex, as all others do.
        for triangle in 0..self.triangles.len() {
            if !self.is_gone[triangle] {
                let [a, b, c] = self.triangles[triangle].corners;
                self.entries[a.max(b).max(c) as usize].push(triangle as u32);
            }
        }
        self.bare.sort_unstable();
        self.bare.dedup();
        let mut table = TableWriter::new(self.group_count > 1);
        let base = self.sequence.base_position_count() as u32;
        let mut tree = self.tree();
        let (mut arcs, mut fans) = (Vec::new(), Vec::new());
        for (vertex, mut entry) in std::mem::take(&mut self.entries).into_iter().enumerate() {
            entry.sort_by_key(|&triangle| self.triangles[triangle as usize].group);
            let group_of = |&triangle: &u32| self.triangles[triangle as usize].group;
            fans.clear();
            for of_group in entry.chunk_by(|a, b| group_of(a) == group_of(b)) {
                arcs.clear();
                arcs.extend(of_group.iter().map(|&t| self.arc(vertex as u32, t)));
                push_crowns(&crowns(&mut arcs), group_of(&of_group[0]), &mut fans);
            }
            let own_step = self.own_step(vertex);
            tree.tell(own_step, &mut fans);
            table.push(own_step, &fans);
        }
        let waits = self.bare.iter().filter(|wait| wait.0 >= base);
        // They came from the last step down.
        self.far.reverse();
        Fans {
            vertices: StepVertices::of_sequence(self.sequence).without_targets(),
            step_count: self.sequence.step_count(),
            group_count: self.group_count,
            table: table.finish(),
            waits: waits.map(|&(position, waits_for)| [position - base, waits_for]).collect(),
            far: self.far,
            orphans: tree.orphans(),
            removed: self.sequence.removed_triangle_counts().into(),
            bounds: None,
        }
    }
}

/// The coarsest position that waits for each step, and which steps have been told by an entry of it.
struct Tree {
    /// Numbers of steps and one; 0 for the base, more than there are where no entry has the step.
    parents: Vec<u32>,
    is_told: Vec<bool>,
}

impl Tree {
    fn new(step_count: usize) -> Self {
        Self { parents: vec![u32::MAX; step_count], is_told: vec![false; step_count] }
    }

    /// Takes note of a step in the entry of a position, whose own step is `own_step - 1`.
    fn note(&mut self, step: u32, own_step: u32) {
        if let Some(parent) = self.parents.get_mut(step as usize) {
            *parent = own_step.min(*parent);
        }
    }

    /// Marks in the fans of a vertex the steps that are its position's, each once.
    fn tell(&mut self, own_step: u32, fans: &mut [Fan]) {
        for creator in fans.iter_mut().flat_map(|fan| &mut fan.creators) {
            let step = creator.step as usize;
            if self.parents[step] == own_step {
                creator.is_child = !std::mem::replace(&mut self.is_told[step], true);
            }
        }
    }

    /// The steps that no entry has.
    fn orphans(self) -> Vec<u32> {
        (0..).zip(&self.is_told).filter(|(_, is_told)| !**is_told).map(|(step, _)| step).collect()
    }
}

/// Appends fans: crowns one after the other, long ones in pieces.
fn push_crowns(crowns: &[Vec<RingArc>], group: u32, fans: &mut Vec<Fan>) {
    for crown in crowns {
        let pieces = crown.chunks(MAX_ARCS);
        fans.extend(pieces.map(|piece| fan_of(piece, crown.len() == piece.len(), group)));
    }
}

/// The fan of some arcs; `is_whole` where they are all of a crown, which may then be closed.
fn fan_of(arcs: &[RingArc], is_whole: bool, group: u32) -> Fan {
    let mut fan = Fan { group, arc_count: arcs.len(), ..Fan::default() };
    fan.nodes.extend(arcs.iter().map(|arc| arc.from));
    let (first, last) = (arcs[0], arcs[arcs.len() - 1]);
    if !(is_whole && last.to == first.from) {
        fan.nodes.push(last.to);
    }
    for (at, arc) in arcs.iter().enumerate() {
        let bit = 1 << at;
        if arc.creator == ALWAYS {
            fan.always |= bit;
        } else if let Some(creator) = fan.creators.iter_mut().find(|c| c.step == arc.creator) {
            creator.mask |= bit;
        } else {
            fan.creators.push(Creator { step: arc.creator, mask: bit, is_child: false });
        }
    }
    fan
}
