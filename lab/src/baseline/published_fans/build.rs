//! Builds the published table from a table of fans.

use striata::mesh::RefinableMesh;
use striata::model::Fans;
use striata::model::fans::TableFan;

use super::{Dependency, EntryRanges, NONE, PublishedFans, criterion, paper_bytes_of};

/// Why a mesh has no published table.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PublishedFansError {
    /// A position has several wedges.
    #[error("vertices {first} and {} share a position", first + 1)]
    Seam {
        /// First of the vertices.
        first: u32,
    },
    /// A ring does not fit into the mask of a byte count.
    #[error("vertex {vertex} has {node_count} vertices around it, but a published entry has at most 255")]
    Ring {
        /// The vertex.
        vertex: u32,
        /// Number of nodes of its ring.
        node_count: usize,
    },
}

/// Largest number of nodes of a ring: counts have one byte.
const MAX_NODES: usize = 255;

impl PublishedFans {
    /// Builds the table of a mesh and its sequence, with the data of the criterion.
    ///
    /// # Errors
    /// [`PublishedFansError`] if a position has several vertices, or a ring has more than 255.
    pub fn build(refinable: &RefinableMesh) -> Result<Self, PublishedFansError> {
        let positions = refinable.sequence.positions();
        let seam =
            (0..positions.position_count() as u32).find(|&position| positions.wedges(position).len() > 1);
        if let Some(position) = seam {
            return Err(PublishedFansError::Seam { first: positions.first_vertex(position) });
        }
        let fans = Fans::build_without_bounds(refinable);
        let mut table = Self {
            base_vertex_count: refinable.sequence.base_vertex_count() as u32,
            step_count: refinable.sequence.step_count(),
            entries: Vec::with_capacity(fans.vertex_count() + 1),
            rings: Vec::new(),
            dependencies: Vec::new(),
            masks: Vec::new(),
            criteria: Vec::new(),
            normals: Vec::new(),
            positions: refinable.mesh.positions.clone(),
            paper_bytes: paper_bytes_of(&fans),
        };
        let mut crowns: Vec<TableFan<'_>> = Vec::new();
        for fan in fans.table_fans() {
            if crowns.last().is_some_and(|last| last.vertex() != fan.vertex()) {
                table.push_entry(&crowns)?;
                crowns.clear();
            }
            crowns.push(fan);
        }
        table.push_entry(&crowns)?;
        table.fill_to(fans.vertex_count() + 1);
        let data = criterion::of_vertices(refinable, &fans);
        (table.criteria, table.normals) = (data.criteria, data.normals);
        Ok(table)
    }

    /// Adds empty entries up to a number of entries.
    fn fill_to(&mut self, count: usize) {
        let end = EntryRanges { ring: self.rings.len() as u32, dependency: self.dependencies.len() as u32 };
        self.entries.resize(count, end);
    }

    /// Joins the crowns of a vertex to one cyclic ring.
    fn push_entry(&mut self, crowns: &[TableFan<'_>]) -> Result<(), PublishedFansError> {
        let Some(vertex) = crowns.first().map(TableFan::vertex) else { return Ok(()) };
        self.fill_to(vertex as usize + 1);
        let first = self.rings.len();
        let mut arcs: Vec<(u32, Vec<usize>)> = Vec::new();
        for fan in crowns {
            let offset = self.rings.len() - first;
            self.rings.extend(fan.nodes());
            // A closed crown among others is opened, so that the next one can follow.
            if fan.is_closed() && crowns.len() > 1 {
                self.rings.extend(fan.nodes().next());
            }
            let permanent = (NONE, fan.permanent_arcs());
            let masks = fan.makers().map(|maker| (maker.step, maker.arcs));
            for (step, mask) in masks.chain((permanent.1 != 0).then_some(permanent)) {
                let of_fan = (0..32).filter(|arc| mask >> arc & 1 != 0).map(|arc| offset + arc);
                match arcs.iter_mut().find(|(other, _)| *other == step) {
                    Some((_, known)) => known.extend(of_fan),
                    None => arcs.push((step, of_fan.collect())),
                }
            }
        }
        let node_count = self.rings.len() - first;
        if node_count > MAX_NODES {
            return Err(PublishedFansError::Ring { vertex, node_count });
        }
        for (step, arcs) in arcs {
            let mask = self.masks.len();
            self.masks.resize(mask + node_count.div_ceil(8), 0);
            arcs.into_iter().for_each(|arc| self.masks[mask + arc / 8] |= 1 << (arc % 8));
            self.dependencies.push(Dependency { step, mask: mask as u32 });
        }
        Ok(())
    }
}
