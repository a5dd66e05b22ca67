//! Primitives: the accessors they use, and the triangles of their indices.

use striata::mesh::Semantic;

use super::accessor::{Accessor, accessor};
use super::document::GltfDocument;
use super::draco::DracoLink;
use super::json::JsonNode;
use super::semantics::{semantic, semantic_in_target};
use crate::error::{Fault, Place};

/// Rule by which indices become triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PrimitiveTopology {
    List,
    Strip,
    Fan,
}

/// Primitive that draws triangles.
pub(crate) struct Primitive<'a> {
    pub at: JsonNode<'a>,
    pub position: u64,
    /// Semantics, sorted, and the index of each accessor.
    pub attributes: Vec<(Semantic, u64)>,
    pub material: Option<u32>,
    /// Compressed mesh that contains the indices and some attributes.
    pub draco: Option<DracoLink<'a>>,
    pub(super) indices: Option<u64>,
    pub(super) topology: PrimitiveTopology,
}

impl<'a> Primitive<'a> {
    /// Reads a primitive; [`None`] if it draws points or lines.
    pub(crate) fn parse(document: &GltfDocument<'_>, at: JsonNode<'a>) -> Result<Option<Self>, Fault> {
        let topology = match at.unsigned("mode")?.unwrap_or(4) {
            0..=3 => return Ok(None),
            4 => PrimitiveTopology::List,
            5 => PrimitiveTopology::Strip,
            6 => PrimitiveTopology::Fan,
            mode => return Err(at.fault(format!("no primitive mode is numbered {mode}"))),
        };
        let mut position = None;
        let mut attributes = Vec::new();
        for (name, entry) in at.members("attributes")? {
            let accessor = entry.as_unsigned()?;
            match name {
                "POSITION" => position = Some(accessor),
                _ => attributes.push((semantic(name), accessor)),
            }
        }
        for (target, entry) in at.entries("targets")?.iter().enumerate() {
            let number = u16::try_from(target)
                .map_err(|_| entry.fault(format!("at most {} morph targets can be handled", u16::MAX)))?;
            for name in entry.value.as_object().into_iter().flat_map(|members| members.keys()) {
                let semantic = semantic_in_target(number, name);
                attributes.extend(entry.unsigned(name)?.map(|accessor| (semantic, accessor)));
            }
        }
        attributes.sort();
        attributes.dedup_by(|a, b| a.0 == b.0);
        let Some(position) = position else { return Err(at.fault("the attribute POSITION is missing")) };
        let material = match at.get("material") {
            Some(entry) => {
                let index = entry.as_unsigned()?;
                document.item("materials", index, &entry)?;
                Some(index as u32)
            }
            None => None,
        };
        let indices = at.unsigned("indices")?;
        let draco = DracoLink::parse(document, &at, position)?;
        // Compressed meshes consist of single triangles, even if the primitive is called a strip.
        let topology = if draco.is_some() { PrimitiveTopology::List } else { topology };
        Ok(Some(Self { at, position, attributes, material, draco, indices, topology }))
    }

    /// Returns the positions, decompressed if necessary.
    pub(crate) fn positions<'d>(&self, document: &'d GltfDocument<'_>) -> Result<Accessor<'d>, Fault> {
        self.data(document, None, self.position)
    }

    /// Returns an attribute, decompressed if necessary.
    pub(crate) fn attribute<'d>(
        &self,
        document: &'d GltfDocument<'_>,
        semantic: &Semantic,
        index: u64,
    ) -> Result<Accessor<'d>, Fault> {
        self.data(document, Some(semantic), index)
    }

    /// Returns the positions ([`None`]) or another attribute, decompressed if necessary.
    pub(super) fn data<'d>(
        &self,
        document: &'d GltfDocument<'_>,
        semantic: Option<&Semantic>,
        index: u64,
    ) -> Result<Accessor<'d>, Fault> {
        let compressed = match &self.draco {
            Some(draco) => draco.attribute(document, semantic, index)?,
            None => None,
        };
        compressed.map_or_else(|| accessor(document, index, &self.at), Ok)
    }

    /// Returns the indices, decompressed if necessary; [`None`] if the vertices are drawn in their order.
    pub(super) fn index_accessor<'d>(
        &self,
        document: &'d GltfDocument<'_>,
    ) -> Result<Option<Accessor<'d>>, Fault> {
        match (&self.draco, self.indices) {
            (Some(draco), _) => draco.indices(document).map(Some),
            (None, Some(index)) => accessor(document, index, &self.at).map(Some),
            (None, None) => Ok(None),
        }
    }

    /// Whether it is a single fan; glTF needs a primitive for each fan.
    pub(crate) fn is_fan(&self) -> bool {
        self.topology == PrimitiveTopology::Fan
    }

    /// Returns an upper limit of the number of triangles that the primitive draws.
    pub(super) fn triangle_limit(
        &self,
        document: &GltfDocument<'_>,
        vertex_count: usize,
    ) -> Result<u64, Fault> {
        let count = self.index_accessor(document)?.map_or(vertex_count, |indices| indices.count) as u64;
        Ok(match self.topology {
            PrimitiveTopology::List => count / 3,
            PrimitiveTopology::Strip | PrimitiveTopology::Fan => count.saturating_sub(2),
        })
    }

    /// Appends the triangles, with `first_vertex` added to their indices; degenerate triangles that join
    /// strips are left out.
    pub(super) fn triangles_into(
        &self,
        document: &GltfDocument<'_>,
        first_vertex: u32,
        vertex_count: usize,
        triangles: &mut Vec<[u32; 3]>,
    ) -> Result<(), Fault> {
        let indices = self.indices(document, vertex_count)?;
        match self.topology {
            PrimitiveTopology::List => {
                let (chunks, _) = indices.as_chunks::<3>();
                triangles.extend(chunks.iter().map(|t| t.map(|v| v + first_vertex)));
            }
            PrimitiveTopology::Strip => {
                for (i, w) in indices.windows(3).enumerate() {
                    let triangle = if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] };
                    push_proper(triangle, first_vertex, triangles);
                }
            }
            PrimitiveTopology::Fan => {
                for w in indices.get(1..).unwrap_or(&[]).windows(2) {
                    push_proper([indices[0], w[0], w[1]], first_vertex, triangles);
                }
            }
        }
        Ok(())
    }

    /// Returns the checked indices of all corners.
    pub(super) fn indices(
        &self,
        document: &GltfDocument<'_>,
        vertex_count: usize,
    ) -> Result<Vec<u32>, Fault> {
        let Some(accessor) = self.index_accessor(document)? else {
            return Ok((0..vertex_count as u32).collect());
        };
        if accessor.component_count != 1 {
            return Err(accessor.fault("indices must be SCALAR"));
        }
        let Some(indices) = accessor.integers() else {
            return Err(accessor.fault("indices must be unsigned integers"));
        };
        if let Some(place) = indices.iter().position(|&v| v as usize >= vertex_count) {
            let reason = format!("index {place} is vertex {}, but there are {vertex_count}", indices[place]);
            return Err(accessor.fault(reason));
        }
        Ok(indices)
    }
}

fn push_proper(triangle: [u32; 3], first_vertex: u32, triangles: &mut Vec<[u32; 3]>) {
    if is_proper(triangle) {
        triangles.push(triangle.map(|v| v + first_vertex));
    }
}

/// Whether the corners of a triangle of a strip or fan are different.
pub(super) fn is_proper([a, b, c]: [u32; 3]) -> bool {
    a != b && b != c && c != a
}

/// Creates a fault for the whole document.
pub(crate) fn document_fault(reason: String) -> Fault {
    Fault::Malformed(Place::File, reason)
}
