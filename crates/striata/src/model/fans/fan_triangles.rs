//! A triangle list that is kept from frame to frame and updated incrementally.
//!
//! Fans can produce their triangles on demand, so an instance does not have to keep any. But if only a few
//! steps change per frame, keeping a list is faster: collapsing or splitting a step changes its own
//! triangles and those that replace them, which are stored with a few vertices around it. Each active
//! vertex knows where its arcs are in the list, and each list entry knows its arc, so a removed triangle
//! is replaced by the last one and the list has no holes.
//!
//! Cost: 16 bytes per triangle, 4 bytes per vertex of the mesh, and 4 bytes per arc of an active vertex,
//! rounded up to a power of two. A change takes time proportional to the triangles around it; finding
//! changes scans one 64-bit word per 64 steps.

use super::table::FanView;
use super::{FanInstance, Fans, MAX_ARCS};
use crate::mesh::CollapseSequence;
use crate::model::step_bits::StepBits;

/// Marks an arc without a triangle, or a vertex that is not active.
const NONE: u32 = u32::MAX;

/// All triangles that an instance shows, in arbitrary order.
#[derive(Clone, Debug)]
pub struct FanTriangles {
    shown: FanInstance,
    groups: Vec<Group>,
    /// Index of each vertex's first arc in `arc_triangles`.
    heads: Vec<u32>,
    /// For each arc of an active vertex, the index of its triangle in the list of its group.
    arc_triangles: Vec<u32>,
    /// Free runs of `arc_triangles`; `free[n]` lists those of length `2^n`.
    free: [Vec<u32>; 32],
    /// Vertices to update, without duplicates.
    changed: Vec<u32>,
    is_changed: StepBits,
}

#[derive(Clone, Debug, Default)]
struct Group {
    triangles: Vec<[u32; 3]>,
    /// Index in `arc_triangles` of the arc to which each triangle belongs.
    arcs: Vec<u32>,
}

impl FanTriangles {
    /// Creates the list of an instance's triangles.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn new(fans: &Fans, instance: &FanInstance) -> Self {
        instance.check_table(fans);
        let vertex_count = fans.vertex_count();
        let mut triangles = Self {
            shown: instance.clone(),
            groups: vec![Group::default(); fans.group_count],
            heads: vec![NONE; vertex_count],
            arc_triangles: Vec::new(),
            free: Default::default(),
            changed: Vec::new(),
            is_changed: StepBits::none(vertex_count),
        };
        (0..vertex_count as u32).for_each(|vertex| triangles.update_vertex(fans, vertex));
        triangles
    }

    /// Returns the triangles of a group; a mesh without groups has all triangles in group 0.
    ///
    /// # Panics
    /// If the group does not exist.
    pub fn triangles(&self, group: usize) -> &[[u32; 3]] {
        &self.groups[group].triangles
    }

    /// Returns the instance whose triangles the list contains.
    pub fn shown(&self) -> &FanInstance {
        &self.shown
    }

    /// Number of bytes owned.
    pub fn bytes(&self) -> usize {
        let groups = self.groups.iter().map(|g| 12 * g.triangles.capacity() + 4 * g.arcs.capacity());
        let words = [&self.heads, &self.arc_triangles, &self.changed].into_iter().chain(&self.free);
        groups.chain(words.map(|list| 4 * list.capacity())).sum::<usize>()
            + self.shown.bytes()
            + self.is_changed.bytes()
    }

    /// Updates the list to another instance; returns the number of steps that differ.
    ///
    /// # Panics
    /// If the instance or the sequence belongs to a different mesh.
    pub fn follow(&mut self, fans: &Fans, sequence: &CollapseSequence, instance: &FanInstance) -> usize {
        instance.check_table(fans);
        self.shown.check_table(fans);
        let mut count = 0;
        for at in 0..instance.words().len() {
            let mut steps = self.shown.words()[at] ^ instance.words()[at];
            while steps != 0 {
                let step = 64 * at as u32 + steps.trailing_zeros();
                steps &= steps - 1;
                count += 1;
                self.mark_around(fans, sequence, step);
            }
        }
        self.shown.clone_from(instance);
        let mut changed = std::mem::take(&mut self.changed);
        for &vertex in &changed {
            self.is_changed.remove(vertex);
            self.update_vertex(fans, vertex);
        }
        changed.clear();
        self.changed = changed;
        count
    }

    /// Marks the vertices whose triangles a step changes: its own, and those that store the triangles of
    /// its floor.
    fn mark_around(&mut self, fans: &Fans, sequence: &CollapseSequence, step: u32) {
        let vertices = fans.vertices.of_step(step as usize);
        let on_floor = |v: u32| if vertices.contains(&v) { sequence.target(v) } else { v };
        for vertex in vertices.clone() {
            self.mark(vertex);
            let target = sequence.target(vertex);
            for fan in fans.step_entry(vertex, step) {
                let mut nodes = fan.nodes().map(on_floor);
                let Some(first) = nodes.next() else { continue };
                let mut last = first;
                let closing = fan.is_closed.then_some(first);
                for node in nodes.chain(closing) {
                    if last != target && node != target && node != last {
                        self.mark(target.max(last).max(node));
                    }
                    last = node;
                }
            }
        }
    }

    fn mark(&mut self, vertex: u32) {
        if !self.is_changed.has(vertex) {
            self.is_changed.insert(vertex);
            self.changed.push(vertex);
        }
    }

    /// Updates the triangles of a vertex.
    fn update_vertex(&mut self, fans: &Fans, vertex: u32) {
        let base = fans.vertices.base_vertex_count;
        let step = (vertex >= base).then(|| fans.vertices.step_of(vertex) as u32);
        let entry = fans.table.entry(vertex, step.map_or(0, |step| step + 1));
        let is_active = step.is_none_or(|step| self.shown.is_refined(step));
        let mut head = self.heads[vertex as usize];
        if head == NONE {
            let arc_count: usize = entry.map(|fan| fan.arc_count()).sum();
            if !is_active || arc_count == 0 {
                return;
            }
            head = self.allocate(arc_count);
            self.heads[vertex as usize] = head;
        }
        let mut arc = head;
        for fan in entry {
            let mask = if is_active { fan.mask(|step| !self.shown.is_refined(step)) } else { 0 };
            self.show(&fan, arc, mask);
            arc += fan.arc_count() as u32;
        }
        if !is_active {
            self.release(head, (arc - head) as usize);
            self.heads[vertex as usize] = NONE;
        }
    }

    /// Shows exactly those arcs of a fan that are in a mask.
    fn show(&mut self, fan: &FanView<'_>, first_arc: u32, mask: u32) {
        let arcs = first_arc as usize..first_arc as usize + fan.arc_count();
        let shown = self.arc_triangles[arcs]
            .iter()
            .rev()
            .fold(0, |mask, &triangle| mask << 1 | u32::from(triangle != NONE));
        let group = &mut self.groups[fan.group as usize];
        for_each_bit(shown & !mask, |at| {
            let triangle =
                std::mem::replace(&mut self.arc_triangles[(first_arc + at) as usize], NONE) as usize;
            group.triangles.swap_remove(triangle);
            group.arcs.swap_remove(triangle);
            if let Some(&moved) = group.arcs.get(triangle) {
                self.arc_triangles[moved as usize] = triangle as u32;
            }
        });
        let new = mask & !shown;
        if new == 0 {
            return;
        }
        let mut ring = [0; MAX_ARCS + 1];
        fan.ring_into(&mut ring);
        for_each_bit(new, |at| {
            self.arc_triangles[(first_arc + at) as usize] = group.triangles.len() as u32;
            group.triangles.push([fan.vertex, ring[at as usize], ring[at as usize + 1]]);
            group.arcs.push(first_arc + at);
        });
    }

    /// Allocates entries for `arc_count` arcs, none of them shown.
    fn allocate(&mut self, arc_count: usize) -> u32 {
        let power = arc_count.next_power_of_two().ilog2() as usize;
        self.free[power].pop().unwrap_or_else(|| {
            let head = self.arc_triangles.len() as u32;
            self.arc_triangles.resize(self.arc_triangles.len() + (1 << power), NONE);
            head
        })
    }

    fn release(&mut self, head: u32, arc_count: usize) {
        self.free[arc_count.next_power_of_two().ilog2() as usize].push(head);
    }
}

#[inline]
fn for_each_bit(mut mask: u32, mut visit: impl FnMut(u32)) {
    while mask != 0 {
        visit(mask.trailing_zeros());
        mask &= mask - 1;
    }
}
