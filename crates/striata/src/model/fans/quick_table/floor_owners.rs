//! The vertices that own the triangles of each floor: those whose triangles change, besides those of the step itself,
//! when the step is taken.

use super::QuickTable;
use super::record::NODES;
use crate::model::fans::{Fans, listed};

/// Some owners are listed apart.
const ELSEWHERE: u8 = 1 << 7;

/// The owners of all floors.
#[derive(Clone, Debug, Default)]
pub(super) struct FloorOwners {
    /// For each step, a bit for each node of its first vertex's record that is an owner, and [`ELSEWHERE`].
    nodes: Box<[u8]>,
    /// Pairs of a step and an owner that is not in that record, ascending.
    others: Vec<[u32; 2]>,
}

impl FloorOwners {
    /// Finds all owners.
    pub(super) fn of(fans: &Fans, table: &QuickTable) -> Self {
        let mut nodes = vec![0; fans.step_count];
        let mut others = Vec::new();
        for fan in fans.table_fans() {
            let owner = fan.vertex();
            for maker in fan.makers() {
                let vertex = fans.vertices.of_step(maker.step as usize).start;
                let ring = table.nodes(vertex);
                // The last node has no bit; if the fan is closed, it is the first one.
                let find = |ring: [u32; NODES]| ring[..NODES - 1].iter().position(|&node| node == owner);
                match ring.and_then(find) {
                    Some(node) => nodes[maker.step as usize] |= 1 << node,
                    None => {
                        nodes[maker.step as usize] |= ELSEWHERE;
                        others.push([maker.step, owner]);
                    }
                }
            }
        }
        others.sort_unstable();
        others.dedup();
        Self { nodes: nodes.into(), others }
    }

    /// Visits the owners of a step's floor; `ring` has the nodes of its first vertex, if that has a record.
    #[inline]
    pub(super) fn for_each(&self, step: u32, ring: Option<[u32; NODES]>, mut visit: impl FnMut(u32)) {
        let mut bits = self.nodes[step as usize];
        if bits & ELSEWHERE != 0 {
            listed(&self.others, step).for_each(&mut visit);
            bits &= !ELSEWHERE;
        }
        let Some(ring) = ring else { return };
        while bits != 0 {
            visit(ring[bits.trailing_zeros() as usize & 7]);
            bits &= bits - 1;
        }
    }

    /// Number of bytes in memory.
    pub(super) fn bytes(&self) -> usize {
        self.nodes.len() + size_of_val(&self.others[..])
    }
}
