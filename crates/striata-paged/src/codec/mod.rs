//! Bytes of a page.
//!
//! A page is decoded without any other page. Its triangles are coded by growing a region across edges, as in the
//! cut-border machine [GS98]: each triangle is attached to an open edge, and its third corner is either new or known
//! from a neighboring open edge. A new corner is followed by the position, attributes, key and error of an owned
//! vertex, or by the name of an import. Targets are coded last: positions are collapsed in the order of their keys,
//! and each target is one of the current neighbors.
//!
//! | file | what it does |
//! | --- | --- |
//! | `counts.rs` | numbers at the beginning of a page |
//! | `order.rs` | the order in which triangles and vertices are numbered: [`Page::normalize`] |
//! | `lattice.rs` | the lattice that all positions of the page lie on |
//! | `border.rs` | open edges of the region that has been coded |
//! | `triangles.rs` | the traversal of all triangles, for both directions |
//! | `wedges.rs` | vertices of each position |
//! | `vertex_models.rs` | models of everything about vertices |
//! | `vertices.rs` | positions, attributes, keys, errors and imports of new corners |
//! | `targets.rs` | targets of owned vertices |

mod border;
mod counts;
mod lattice;
mod order;
mod targets;
mod triangles;
mod vertex_models;
mod vertices;
mod wedges;

use striata_stream::entropy::{Coder, RangeReader, RangeWriter};

use crate::bytes::{put_varint, take_varint};
use crate::error::{PageDefect, PagedError};
use crate::{Metadata, Page, PageId};
use counts::PageCounts;
use lattice::Lattice;
use triangles::{CodedShape, TriangleCoder};

/// Maximum number of vertices or triangles of a page.
const MAX_COUNT: u64 = 1 << 24;
/// Maximum number of vertices or triangles per byte, even if all are alike.
const MAX_PER_BYTE: u64 = 4096;

impl Page {
    /// Encodes a page that [`Page::normalize`] has ordered, and whose values are rounded as the metadata say.
    pub fn to_bytes(&self, metadata: &Metadata) -> Vec<u8> {
        let counts = PageCounts::of(self, metadata);
        let mut bytes = Vec::new();
        for count in [counts.positions, counts.vertices, counts.imports, counts.triangles] {
            put_varint(&mut bytes, count as u64);
        }
        put_varint(&mut bytes, counts.pages.len() as u64);
        let mut last = 0;
        for &page in &counts.pages {
            put_varint(&mut bytes, u64::from(page - last));
            last = page;
        }
        counts.lattice.put(&mut bytes);
        let mut writer = RangeWriter::new();
        let mut coder = TriangleCoder::new(&counts, metadata, self.targets.is_empty());
        coder.run(&mut writer, Some(self));
        bytes.extend(writer.finish().0);
        bytes
    }

    /// Decodes a page.
    ///
    /// # Errors
    /// [`PagedError::Page`] if the bytes are not those of a page.
    pub fn from_bytes(id: PageId, bytes: &[u8], metadata: &Metadata) -> Result<Self, PagedError> {
        let page = decode(id, bytes, metadata).map_err(|defect| PagedError::Page { id, defect })?;
        page.check(metadata)?;
        Ok(page)
    }
}

fn decode(id: PageId, bytes: &[u8], metadata: &Metadata) -> Result<Page, PageDefect> {
    let byte_count = bytes.len();
    let mut rest = bytes;
    let limit = MAX_COUNT.min(MAX_PER_BYTE * byte_count as u64);
    let count = |what: &'static str, rest: &mut &[u8]| {
        let announced = take_varint(rest).ok_or(PageDefect::Truncated)?;
        if announced > limit {
            return Err(PageDefect::TooMany { what, announced, byte_count });
        }
        Ok(announced as usize)
    };
    let positions = count("positions", &mut rest)?;
    let vertices = count("vertices", &mut rest)?;
    let imports = count("imports", &mut rest)?;
    let triangles = count("triangles", &mut rest)?;
    let page_count = count("pages", &mut rest)?;
    let is_empty = positions == 0 && (vertices > 0 || (imports == 0 && triangles > 0));
    if page_count > imports || positions > vertices || is_empty {
        return Err(PageDefect::Entry { what: "counts", index: 0, reason: "contradict each other" });
    }
    let mut pages: Vec<u32> = Vec::new();
    for index in 0..page_count {
        let delta = take_varint(&mut rest).ok_or(PageDefect::Truncated)?;
        let last = pages.last().copied().unwrap_or(0);
        let page = u64::from(last) + delta;
        if page > u64::from(u32::MAX) || (index > 0 && delta == 0) {
            return Err(PageDefect::Entry { what: "pages", index, reason: "is not in ascending order" });
        }
        pages.push(page as u32);
    }
    let lattice = Lattice::take(&mut rest).ok_or(PageDefect::Truncated)?;
    let counts = PageCounts { positions, vertices, imports, triangles, pages, lattice };
    if counts.imports > 0 && counts.pages.is_empty() {
        return Err(PageDefect::Entry { what: "pages", index: 0, reason: "is missing" });
    }
    let mut reader = RangeReader::new(rest, true);
    let is_base = id.level as usize == metadata.cell_counts.len();
    let mut coder = TriangleCoder::new(&counts, metadata, is_base);
    coder.run(&mut reader, None);
    if reader.overran() {
        return Err(PageDefect::Truncated);
    }
    coder.into_page(id)
}

impl CodedShape {
    /// Vertices with those of a position adjacent, and the first one of each position.
    fn order_of_vertices(&self) -> Result<(Vec<u32>, Vec<u32>), PageDefect> {
        if self.wedges.is_trivial() {
            let count = self.vertices.len() as u32;
            return Ok(((0..count).collect(), (0..=count).collect()));
        }
        let mut order = Vec::with_capacity(self.vertices.len());
        let mut first = Vec::with_capacity(self.wedges.position_count() + 1);
        let mut wedges = Vec::new();
        for position in 0..self.wedges.position_count() as u32 {
            first.push(order.len() as u32);
            self.wedges.of(position, &mut wedges);
            if wedges.is_empty() {
                return Err(PageDefect::Entry { what: "positions", index: 0, reason: "has no vertex" });
            }
            order.extend_from_slice(&wedges);
        }
        first.push(order.len() as u32);
        Ok((order, first))
    }

    /// The page in the final numbering: wedges of a position adjacent, in the order in which they were met.
    fn into_page(self, id: PageId, is_base: bool) -> Result<Page, PageDefect> {
        let position_count = self.wedges.position_count();
        let (order, first) = self.order_of_vertices()?;
        let mut number = vec![0; order.len()];
        for (new, &v) in (0..).zip(&order) {
            number[v as usize] = new;
        }
        let owned = order.len() as u32;
        let rename = |v: u32| match v.checked_sub(Self::IMPORTS) {
            Some(import) => owned + import,
            None => number[v as usize],
        };
        let keys = if is_base { Vec::new() } else { self.keys.clone() };
        Ok(Page {
            id,
            positions: order.iter().map(|&v| self.positions[self.vertices[v as usize] as usize]).collect(),
            layers: self.layers.iter().map(|layer| layer.gather(&order)).collect(),
            first,
            targets: if is_base {
                Vec::new()
            } else {
                order.iter().map(|&v| rename(self.targets[v as usize])).collect()
            },
            errors: if is_base { Vec::new() } else { self.errors[..position_count].to_vec() },
            keys,
            imports: self.imports.clone(),
            triangles: self.triangles.iter().map(|t| t.map(rename)).collect(),
            triangle_layers: self.triangle_layers,
            groups: if self.groups.iter().all(|&group| group == 0) { Vec::new() } else { self.groups },
        })
    }
}
