//! One record: a fan whose parts have fixed places.

use super::RecordNumber;
use crate::model::fans::Fans;
use crate::model::fans::table::FanView;
use crate::model::step_bits::StepBits;

/// Largest number of arcs of a fan that has a record.
pub(in super::super) const QUICK_ARCS: usize = 7;

/// Number of nodes of a record, the first one again if the fan is closed.
pub(super) const NODES: usize = QUICK_ARCS + 1;

/// Number of creators of a record.
const CREATORS: usize = 5;

/// The only fan of a vertex, or nothing if there is none or it is too large; `N` is the type of its numbers.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub(in super::super) struct FanRecord<N> {
    /// Vertex minus node, the first one again at the end if the fan is closed; unused ones repeat the first. All
    /// are 0 if there is no fan.
    distances: [N; NODES],
    /// Steps as in the table: twice the distance from the own step, plus 1 for a child. Unused ones repeat the
    /// first.
    creators: [N; CREATORS],
    /// Arcs of each creator, 0 for unused ones; then the permanent arcs.
    masks: [u8; CREATORS + 1],
}

impl<N: RecordNumber> FanRecord<N> {
    /// Makes the records of all vertices.
    pub(super) fn all_of(fans: &Fans) -> Box<[Self]> {
        let mut records = vec![Self::default(); fans.vertex_count()];
        let mut add = |vertex: u32, own_step: u32| {
            let mut entry = fans.table.entry(vertex, own_step);
            let only = entry.next().filter(|_| entry.next().is_none());
            if let Some(record) = only.and_then(|fan| Self::of(&fan)) {
                records[vertex as usize] = record;
            }
        };
        // Without steps, there is nothing that a creator could name.
        let base = if fans.step_count > 0 { fans.vertices.base_vertex_count } else { 0 };
        (0..base).for_each(|vertex| add(vertex, 0));
        for step in 0..fans.step_count {
            fans.vertices.of_step(step).for_each(|vertex| add(vertex, step as u32 + 1));
        }
        records.into()
    }

    /// Makes the record of a fan, unless it has too many arcs or creators, or too large numbers.
    fn of(fan: &FanView<'_>) -> Option<Self> {
        let has_room = fan.arc_count() <= QUICK_ARCS && fan.pairs().count() <= CREATORS;
        let numbers = fan.distances().chain(fan.pairs().map(|pair| pair[0]));
        if !has_room || fan.group > u32::from(u16::MAX) || numbers.max()? > N::MAX {
            return None;
        }
        let mut record = Self::default();
        let first = fan.distances().next()?;
        let closing = fan.is_closed.then_some(first);
        record.distances = [N::store(first); NODES];
        for (slot, distance) in record.distances.iter_mut().zip(fan.distances().chain(closing)) {
            *slot = N::store(distance);
        }
        // Without a creator, the slots name some step that exists: for a base vertex the first one.
        let first = fan.pairs().next().map_or(2 * u32::from(fan.own_step == 0), |pair| pair[0]);
        record.creators = [N::store(first); CREATORS];
        for (i, [number, mask]) in fan.pairs().enumerate() {
            record.creators[i] = N::store(number);
            record.masks[i] = mask as u8;
        }
        record.masks[CREATORS] = fan.permanent as u8;
        Some(record)
    }

    /// Whether there is a fan. If not, the vertex has to be looked up in the table.
    #[inline(always)]
    pub(in super::super) fn is_complete(&self) -> bool {
        self.distances[0].load() != 0
    }

    /// Returns the nodes of a vertex, some of them repeatedly.
    #[inline(always)]
    pub(in super::super) fn nodes(&self, vertex: u32) -> [u32; NODES] {
        self.distances.map(|distance| vertex.wrapping_sub(distance.load()))
    }

    /// Returns the nodes of a vertex in order, the first one again if the fan is closed; then anything.
    #[inline(always)]
    pub(in super::super) fn ring(&self, vertex: u32) -> [u32; 2 * NODES] {
        // Twice as long as necessary, so that an arc and the next one of three bits each are always in it.
        let mut ring = [0; 2 * NODES];
        for (node, distance) in ring.iter_mut().zip(&self.distances) {
            *node = vertex.wrapping_sub(distance.load());
        }
        ring
    }

    /// Returns a creator's step; `own_step` is the step of the vertex plus 1, or 0 in the base.
    #[inline(always)]
    fn step(number: u32, own_step: u32) -> u32 {
        (number >> 1).wrapping_add(own_step).wrapping_sub(1)
    }

    /// Returns the mask of the active arcs. `collapsed` returns 1 for a collapsed step and otherwise 0.
    #[inline(always)]
    pub(in super::super) fn mask(&self, own_step: u32, collapsed: impl Fn(u32) -> u64) -> u32 {
        // Without a branch, half of which would be mispredicted: a byte of ones for each active mask.
        let mut active = 1 << (8 * CREATORS);
        for (index, number) in self.creators.iter().enumerate() {
            active |= collapsed(Self::step(number.load(), own_step)) << (8 * index);
        }
        let [a, b, c, d, e, permanent] = self.masks;
        let masks = u64::from_le_bytes([a, b, c, d, e, permanent, 0, 0]) & (active * 0xff);
        let masks = masks | masks >> 24;
        ((masks | masks >> 8 | masks >> 16) & 0xff) as u32
    }

    /// Visits the children of a vertex in the tree.
    #[inline(always)]
    pub(super) fn for_each_child(&self, own_step: u32, mut visit: impl FnMut(u32)) {
        for (number, &arcs) in self.creators.iter().zip(&self.masks) {
            let number = number.load();
            if number & 1 != 0 && arcs != 0 {
                visit(Self::step(number, own_step));
            }
        }
    }

    /// Adds the children of a vertex to a set of steps.
    #[inline(always)]
    pub(super) fn add_children(&self, own_step: u32, set: &mut StepBits) {
        for number in &self.creators {
            // Without a branch, half of which would be mispredicted. A repeated creator does no harm.
            let number = number.load();
            set.insert_if(Self::step(number, own_step), number & 1 != 0);
        }
    }

    /// Whether all creators are collapsed.
    #[inline(always)]
    pub(super) fn is_free(&self, own_step: u32, is_collapsed: impl Fn(u32) -> bool) -> bool {
        let mut creators = self.creators.iter().zip(&self.masks);
        creators.all(|(number, &arcs)| arcs == 0 || is_collapsed(Self::step(number.load(), own_step)))
    }
}
