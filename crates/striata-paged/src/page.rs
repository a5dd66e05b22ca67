//! One page: the steps of one cell, with the vertices that they restore.

use striata::mesh::AttributeLayer;

use crate::error::{PageDefect, PagedError};
use crate::{Metadata, PageId};

/// A vertex of another page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Import {
    /// Index of the page in the directory; smaller than that of the importing page.
    pub page: u32,
    /// Vertex among those that the page owns.
    pub vertex: u32,
}

/// A decoded page.
///
/// Vertices are numbered locally: first the `n` that the page owns, then its imports. If every owned vertex collapses
/// to its target, the triangles of the page become triangles of coarser pages; loading the page replaces those.
/// Positions are numbered in the order in which the triangles use them; refinement restores positions with larger
/// keys first.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// Level and cell.
    pub id: PageId,
    /// Position of each owned vertex, in mesh units; the wedges of a position are adjacent.
    pub positions: Vec<[f32; 3]>,
    /// Attribute layers of the owned vertices.
    pub layers: Vec<AttributeLayer>,
    /// First vertex of each owned position, followed by the number of owned vertices.
    pub first: Vec<u32>,
    /// Target of each owned vertex: an owned vertex at a position with a larger key, or an import. Empty in the
    /// base page.
    pub targets: Vec<u32>,
    /// Key of the step that restores each owned position; empty in the base page.
    pub keys: Vec<f32>,
    /// Error of the surface without each owned position, mesh units; empty in the base page.
    pub errors: Vec<f32>,
    /// Vertices of other pages, each once, in the order in which the triangles meet them.
    pub imports: Vec<Import>,
    /// Triangles with at least one owned corner.
    pub triangles: Vec<[u32; 3]>,
    /// Group of each triangle; empty if all belong to group 0.
    pub groups: Vec<u32>,
    /// Attribute layers of the triangles, each with a row for every triangle.
    pub triangle_layers: Vec<AttributeLayer>,
}

impl Page {
    /// Position that an owned vertex belongs to.
    pub(crate) fn position_of(&self, vertex: u32) -> u32 {
        if self.first.len() == self.positions.len() + 1 {
            return vertex;
        }
        self.first.partition_point(|&first| first <= vertex) as u32 - 1
    }

    /// Group of a triangle.
    pub(crate) fn group_of(&self, triangle: usize) -> u32 {
        self.groups.get(triangle).copied().unwrap_or(0)
    }

    /// Number that distinguishes triangles with the same corners: a hash of group and data.
    pub(crate) fn tag_of(&self, triangle: usize) -> u32 {
        let mut tag = self.group_of(triangle);
        for layer in &self.triangle_layers {
            let width = layer.vertex_bytes();
            for &byte in &layer.data.as_bytes()[triangle * width..][..width] {
                tag = (tag ^ u32::from(byte)).wrapping_mul(0x0100_0193);
            }
        }
        tag
    }

    /// Data of some triangles.
    pub(crate) fn triangle_rows(&self, triangles: &[u32]) -> Vec<AttributeLayer> {
        self.triangle_layers.iter().map(|layer| layer.gather(triangles)).collect()
    }

    /// Checks that the page is consistent in itself.
    ///
    /// # Errors
    /// [`PagedError::Page`] with the list and the entry that is wrong.
    pub fn check(&self, metadata: &Metadata) -> Result<(), PagedError> {
        self.find_defect(metadata).map_or(Ok(()), |defect| Err(PagedError::Page { id: self.id, defect }))
    }

    fn find_defect(&self, metadata: &Metadata) -> Option<PageDefect> {
        let (owned, position_count) = (self.positions.len(), self.first.len().saturating_sub(1));
        let is_base = self.id.level as usize == metadata.cell_counts.len();
        let steps = |count: usize| if is_base { 0 } else { count };
        let lengths = [
            ("targets", self.targets.len(), steps(owned)),
            ("keys", self.keys.len(), steps(position_count)),
            ("errors", self.errors.len(), steps(position_count)),
            ("layers", self.layers.len(), metadata.layers.len()),
            ("triangle layers", self.triangle_layers.len(), metadata.triangle_layers.len()),
            ("groups", self.groups.len(), if self.groups.is_empty() { 0 } else { self.triangles.len() }),
        ];
        let of_rows = |rows: usize| {
            move |layer: &AttributeLayer| ("layers", layer.data.len(), rows * layer.component_count as usize)
        };
        let layers = self.layers.iter().map(of_rows(owned));
        let layers = layers.chain(self.triangle_layers.iter().map(of_rows(self.triangles.len())));
        let wrong = lengths.into_iter().chain(layers).find(|&(_, found, expected)| found != expected);
        if let Some((what, found, expected)) = wrong {
            return Some(PageDefect::Length { what, found, expected });
        }
        let entry = |what, index, reason| Some(PageDefect::Entry { what, index, reason });
        let is_rising = self.first.first() == Some(&0)
            && self.first.last().is_some_and(|&last| last as usize == owned)
            && self.first.windows(2).all(|w| w[0] < w[1]);
        if !is_rising {
            return entry("first vertices", 0, "does not cover the owned vertices");
        }
        if let Some(v) = self.positions.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
            return entry("positions", v, "is not finite");
        }
        self.find_bad_target().or_else(|| self.find_bad_triangle(metadata))
    }

    /// The first target that is not at a position with a larger key, or that differs between wedges.
    fn find_bad_target(&self) -> Option<PageDefect> {
        let (owned, all) = (self.positions.len() as u32, (self.positions.len() + self.imports.len()) as u32);
        for p in 0..self.keys.len() {
            let mut common = None;
            for v in self.first[p] as usize..self.first[p + 1] as usize {
                let target = self.targets[v];
                let at = (target < owned).then(|| self.position_of(target) as usize);
                let reason = if target >= all {
                    "does not exist"
                } else if at.is_some_and(|q| self.keys[q].total_cmp(&self.keys[p]).is_le()) {
                    "has no larger key"
                } else if *common.get_or_insert(at) != at {
                    "is not at the same position as those of other wedges"
                } else {
                    continue;
                };
                return Some(PageDefect::Entry { what: "targets", index: v, reason });
            }
        }
        None
    }

    /// The first triangle that is degenerate, uses unknown vertices or none of the page's own.
    fn find_bad_triangle(&self, metadata: &Metadata) -> Option<PageDefect> {
        let (owned, all) = (self.positions.len() as u32, (self.positions.len() + self.imports.len()) as u32);
        for (index, t) in self.triangles.iter().enumerate() {
            let [a, b, c] = *t;
            let reason = if t.iter().any(|&v| v >= all) {
                "uses a vertex that does not exist"
            } else if a == b || b == c || c == a {
                "is degenerate"
            } else if t.iter().all(|&v| v >= owned) {
                "uses no vertex of the page"
            } else {
                continue;
            };
            return Some(PageDefect::Entry { what: "triangles", index, reason });
        }
        let group_count = metadata.groups.len().max(1) as u32;
        let bad = self.groups.iter().position(|&group| group >= group_count)?;
        Some(PageDefect::Entry { what: "groups", index: bad, reason: "does not exist" })
    }
}
