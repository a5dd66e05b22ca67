//! The table again, in records of fixed size, for what runs every frame.
//!
//! Nearly all vertices have a single fan of at most seven arcs and five creators. Their records hold it in a form
//! that is decoded without a branch: the nodes are decoded together, the bits of all creators are looked up, and
//! whatever is not used is harmless. All other vertices are decoded from the table itself. Numbers have two bytes
//! up to 65,536 vertices, three bytes up to 16 million, and four beyond that.
//!
//! The records are made when they are first needed and shared by all instances. With numbers of two bytes they take
//! 32 bytes per vertex. On the bunny, writing triangles from them takes half as long as from the table.

mod floor_owners;
mod number;
mod record;

use std::sync::OnceLock;

use self::floor_owners::FloorOwners;
pub(super) use self::number::RecordNumber;
use self::number::U24;
pub(super) use self::record::{FanRecord, QUICK_ARCS};
use super::Fans;
use crate::model::step_bits::StepBits;

/// The records of all vertices.
#[derive(Clone, Debug)]
pub(super) struct QuickTable {
    pub records: FanRecords,
    /// Group of each vertex; empty if there is only one group.
    groups: Box<[u16]>,
    /// Step of each vertex plus 1, or 0 in the base; empty if each step has one vertex.
    own_steps: Box<[u32]>,
    floors: FloorOwners,
}

/// Records by vertex, with numbers that are large enough.
#[derive(Clone, Debug)]
pub(super) enum FanRecords {
    /// Two bytes per number.
    Small(Box<[FanRecord<u16>]>),
    /// Three bytes per number.
    Medium(Box<[FanRecord<U24>]>),
    /// Four bytes per number.
    Large(Box<[FanRecord<u32>]>),
}

/// Runs an expression with the records, whatever their type; `$record` is the one of a vertex if it has one.
macro_rules! with_record {
    ($table:expr, $vertex:expr, $record:ident => $found:expr, $other:expr) => {
        match &$table.records {
            FanRecords::Small(records) => match &records[$vertex as usize] {
                $record if $record.is_complete() => $found,
                _ => $other,
            },
            FanRecords::Medium(records) => match &records[$vertex as usize] {
                $record if $record.is_complete() => $found,
                _ => $other,
            },
            FanRecords::Large(records) => match &records[$vertex as usize] {
                $record if $record.is_complete() => $found,
                _ => $other,
            },
        }
    };
}

impl Fans {
    /// Returns the records of the table, which are made at the first call.
    #[inline]
    pub(super) fn quick(&self) -> &QuickTable {
        self.quick.0.get_or_init(|| QuickTable::of(self))
    }
}

/// Records that are made when they are needed. They follow from the table, so they do not count in comparisons.
#[derive(Clone, Debug, Default)]
pub(super) struct LazyQuickTable(OnceLock<QuickTable>);

impl PartialEq for LazyQuickTable {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for LazyQuickTable {}

impl LazyQuickTable {
    /// Number of bytes of the records, if they have been made.
    pub(super) fn bytes(&self) -> usize {
        self.0.get().map_or(0, QuickTable::bytes)
    }
}

impl QuickTable {
    fn of(fans: &Fans) -> Self {
        let vertex_count = fans.vertex_count();
        let has_wedges = !fans.vertices.firsts.is_empty();
        let mut own_steps = vec![0; if has_wedges { vertex_count } else { 0 }];
        for step in 0..if has_wedges { fans.step_count } else { 0 } {
            let vertices = fans.vertices.of_step(step);
            own_steps[vertices.start as usize..vertices.end as usize].fill(step as u32 + 1);
        }
        let records = if vertex_count <= 1 << 16 {
            FanRecords::Small(FanRecord::all_of(fans))
        } else if vertex_count <= 1 << 24 {
            FanRecords::Medium(FanRecord::all_of(fans))
        } else {
            FanRecords::Large(FanRecord::all_of(fans))
        };
        let groups = vec![0; if fans.group_count > 1 { vertex_count } else { 0 }].into();
        let floors = FloorOwners::default();
        let mut table = Self { records, groups, own_steps: own_steps.into(), floors };
        if fans.group_count > 1 {
            fans.table_fans().for_each(|fan| table.groups[fan.vertex() as usize] = fan.group() as u16);
        }
        table.floors = FloorOwners::of(fans, &table);
        table
    }

    fn bytes(&self) -> usize {
        let records = match &self.records {
            FanRecords::Small(records) => size_of_val(&records[..]),
            FanRecords::Medium(records) => size_of_val(&records[..]),
            FanRecords::Large(records) => size_of_val(&records[..]),
        };
        records + size_of_val(&self.groups[..]) + size_of_val(&self.own_steps[..]) + self.floors.bytes()
    }

    /// Returns the step of a vertex that is not in the base, which has `base` vertices.
    #[inline(always)]
    pub(super) fn step_of(&self, vertex: u32, base: u32) -> u32 {
        if self.own_steps.is_empty() { vertex - base } else { self.own_steps[vertex as usize] - 1 }
    }

    /// Returns the group of a vertex that has a record.
    #[inline(always)]
    pub(super) fn group(&self, vertex: u32) -> u32 {
        if self.groups.is_empty() { 0 } else { u32::from(self.groups[vertex as usize]) }
    }

    /// Returns the nodes of a vertex, some of them repeatedly; `None` if it has no record.
    #[inline(always)]
    pub(super) fn nodes(&self, vertex: u32) -> Option<[u32; QUICK_ARCS + 1]> {
        with_record!(self, vertex, record => Some(record.nodes(vertex)), None)
    }

    /// Visits the children of a vertex in the tree. Returns whether it has a record.
    #[inline(always)]
    pub(super) fn for_each_child(&self, vertex: u32, own_step: u32, visit: impl FnMut(u32)) -> bool {
        with_record!(self, vertex, record => { record.for_each_child(own_step, visit); true }, false)
    }

    /// Adds the children of a vertex to a set of steps. Returns whether it has a record.
    #[inline(always)]
    pub(super) fn add_children(&self, vertex: u32, own_step: u32, set: &mut StepBits) -> bool {
        with_record!(self, vertex, record => { record.add_children(own_step, set); true }, false)
    }

    /// Whether all creators of a vertex are collapsed; `None` if it has no record.
    #[inline(always)]
    pub(super) fn is_free(
        &self,
        vertex: u32,
        own_step: u32,
        is_collapsed: impl Fn(u32) -> bool,
    ) -> Option<bool> {
        with_record!(self, vertex, record => Some(record.is_free(own_step, is_collapsed)), None)
    }

    /// Visits the vertices that own triangles of a step's floor. `vertex` is the first vertex of the step.
    #[inline]
    pub(super) fn for_each_floor_owner(&self, step: u32, vertex: u32, visit: impl FnMut(u32)) {
        self.floors.for_each(step, self.nodes(vertex), visit);
    }
}
