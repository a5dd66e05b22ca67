//! The triangles of an instance kept from frame to frame: only what changes is written.
//!
//! A fan knows its triangles whenever it is asked, so an instance needs to keep none. Where a few steps change in each of many
//! frames it pays to keep them all the same: a step that is taken or undone changes its own triangles and those that
//! take their place, which stand with a few vertices around it. Each vertex that is there knows where its arcs stand in the list, each place of the list which arc
//! stands there, so a triangle that goes is replaced by the last one and the list has no holes.
//!
//! Cost: 16 bytes a triangle, 4 a vertex of the mesh, and 4 for each arc of a vertex that is there, rounded up to a power of two;
//! a change takes time in proportion to the triangles around it, and finding it a look at each 64 steps.

use super::table::FanView;
use super::{FanInstance, Fans, MAX_ARCS};
use crate::mesh::CollapseSequence;
use crate::model::step_bits::StepBits;

/// An arc that is not shown, a vertex that is not there.
const NONE: u32 = u32::MAX;

/// All triangles that an instance shows, in any order.
#[derive(Clone, Debug)]
pub struct FanTriangles {
    shown: FanInstance,
    groups: Vec<Group>,
    /// Where the arcs of each vertex begin in `places`.
    heads: Vec<u32>,
    /// For each arc of a vertex that is there its place in its group's list.
    places: Vec<u32>,
    /// Free runs of `places`, by the power of two that is their length.
    free: [Vec<u32>; 32],
    /// Vertices to look at, once each.
    changed: Vec<u32>,
    is_changed: StepBits,
}

#[derive(Clone, Debug, Default)]
struct Group {
    triangles: Vec<[u32; 3]>,
    /// The arc that each triangle is of, as its place in `places`.
    arcs: Vec<u32>,
}

impl FanTriangles {
    /// The triangles of an instance.
    ///
    /// # Panics
    /// If the instance is of another table.
    pub fn new(fans: &Fans, instance: &FanInstance) -> Self {
        instance.check_table(fans);
        let vertex_count = fans.vertex_count();
        let mut triangles = Self {
            shown: instance.clone(),
            groups: vec![Group::default(); fans.group_count],
            heads: vec![NONE; vertex_count],
            places: Vec::new(),
            free: Default::default(),
            changed: Vec::new(),
            is_changed: StepBits::none(vertex_count),
        };
        (0..vertex_count as u32).for_each(|vertex| triangles.look_at(fans, vertex));
        triangles
    }

    /// The triangles of a group; of a mesh without groups, of group 0.
    ///
    /// # Panics
    /// If there is no such group.
    pub fn triangles(&self, group: usize) -> &[[u32; 3]] {
        &self.groups[group].triangles
    }

    /// The instance whose triangles these are.
    pub fn shown(&self) -> &FanInstance {
        &self.shown
    }

    /// Bytes owned.
    pub fn bytes(&self) -> usize {
        let groups = self.groups.iter().map(|g| 12 * g.triangles.capacity() + 4 * g.arcs.capacity());
        let words = [&self.heads, &self.places, &self.changed].into_iter().chain(&self.free);
        groups.chain(words.map(|list| 4 * list.capacity())).sum::<usize>()
            + self.shown.bytes()
            + self.is_changed.bytes()
    }

    /// Goes on to another instance; returns how many steps were changed.
    ///
    /// # Panics
    /// If the instance or the sequence is of another mesh.
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
                self.note_around(fans, sequence, step);
            }
        }
        self.shown.clone_from(instance);
        let mut changed = std::mem::take(&mut self.changed);
        for &vertex in &changed {
            self.is_changed.remove(vertex);
            self.look_at(fans, vertex);
        }
        changed.clear();
        self.changed = changed;
        count
    }

    /// Notes the vertices whose triangles a step changes: its own, and those that the triangles of its floor stand with.
    fn note_around(&mut self, fans: &Fans, sequence: &CollapseSequence, step: u32) {
        let vertices = fans.vertices.of_step(step as usize);
        let on_floor = |v: u32| if vertices.contains(&v) { sequence.target(v) } else { v };
        for vertex in vertices.clone() {
            self.note(vertex);
            let target = sequence.target(vertex);
            for fan in fans.step_entry(vertex, step) {
                let mut nodes = fan.nodes().map(on_floor);
                let Some(first) = nodes.next() else { continue };
                let mut last = first;
                let closing = fan.is_closed.then_some(first);
                for node in nodes.chain(closing) {
                    if last != target && node != target && node != last {
                        self.note(target.max(last).max(node));
                    }
                    last = node;
                }
            }
        }
    }

    fn note(&mut self, vertex: u32) {
        if !self.is_changed.has(vertex) {
            self.is_changed.insert(vertex);
            self.changed.push(vertex);
        }
    }

    /// Brings the triangles of a vertex up to date.
    fn look_at(&mut self, fans: &Fans, vertex: u32) {
        let base = fans.vertices.base_vertex_count;
        let step = (vertex >= base).then(|| fans.vertices.step_of(vertex) as u32);
        let entry = fans.table.entry(vertex, step.map_or(0, |step| step + 1));
        let is_there = step.is_none_or(|step| self.shown.is_refined(step));
        let mut head = self.heads[vertex as usize];
        if head == NONE {
            let arc_count: usize = entry.map(|fan| fan.arc_count()).sum();
            if !is_there || arc_count == 0 {
                return;
            }
            head = self.allocate(arc_count);
            self.heads[vertex as usize] = head;
        }
        let mut arc = head;
        for fan in entry {
            let mask = if is_there { fan.mask(|step| !self.shown.is_refined(step)) } else { 0 };
            self.show(&fan, arc, mask);
            arc += fan.arc_count() as u32;
        }
        if !is_there {
            self.release(head, (arc - head) as usize);
            self.heads[vertex as usize] = NONE;
        }
    }

    /// Shows the arcs of a fan that are in a mask, and no others.
    fn show(&mut self, fan: &FanView<'_>, first_arc: u32, mask: u32) {
        let arcs = first_arc as usize..first_arc as usize + fan.arc_count();
        let shown =
            self.places[arcs].iter().rev().fold(0, |mask, &place| mask << 1 | u32::from(place != NONE));
        let group = &mut self.groups[fan.group as usize];
        for_each_bit(shown & !mask, |at| {
            let place = std::mem::replace(&mut self.places[(first_arc + at) as usize], NONE) as usize;
            group.triangles.swap_remove(place);
            group.arcs.swap_remove(place);
            if let Some(&moved) = group.arcs.get(place) {
                self.places[moved as usize] = place as u32;
            }
        });
        let new = mask & !shown;
        if new == 0 {
            return;
        }
        let mut ring = [0; MAX_ARCS + 1];
        fan.ring_into(&mut ring);
        for_each_bit(new, |at| {
            self.places[(first_arc + at) as usize] = group.triangles.len() as u32;
            group.triangles.push([fan.vertex, ring[at as usize], ring[at as usize + 1]]);
            group.arcs.push(first_arc + at);
        });
    }

    /// Places for so many arcs, none of them shown.
    fn allocate(&mut self, arc_count: usize) -> u32 {
        let power = arc_count.next_power_of_two().ilog2() as usize;
        self.free[power].pop().unwrap_or_else(|| {
            let head = self.places.len() as u32;
            self.places.resize(self.places.len() + (1 << power), NONE);
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
