//! Fragments as a reader receives them.

use std::sync::OnceLock;

use striata::mesh::{
    Face, Fragment, FragmentError, FragmentSequence, FragmentedMesh, IndexedMesh, PositionIndex,
};

use crate::entropy::{Coder as _, RangeReader};
use crate::format::error::StreamDefect;
use crate::format::header::StreamHeader;
use crate::fragments::record::{CodedFragment, FragmentCoder, NoFragment};
use crate::fragments::values::{ValueCoder, VertexValues};
use crate::refine::growth::GrowingMesh;

/// A level made of fragments, and the fragments that led to it.
#[derive(Clone, Debug)]
pub(crate) struct FragmentReader {
    coder: FragmentCoder,
    values: ValueCoder,
    base: Vec<Face>,
    received: Vec<CodedFragment>,
    /// First vertex of each position, followed by the number of vertices.
    first_vertex: Vec<u32>,
    group_count: usize,
    /// Triangles of the level, once they were asked for since the last step.
    listed: OnceLock<Listed>,
}

/// The triangles of a level by group.
#[derive(Clone, Debug, Default)]
struct Listed {
    triangles: Vec<[u32; 3]>,
    /// Group of each triangle; empty if there is at most one.
    groups: Vec<u32>,
}

impl FragmentReader {
    /// Starts at a base mesh; `integers` are those of its layers.
    pub(crate) fn new(header: &StreamHeader, growth: &GrowingMesh, integers: Vec<Vec<i32>>) -> Self {
        let group = |at: usize| growth.groups.get(at).copied().unwrap_or(0);
        let faces = growth.triangles.iter().enumerate();
        let base: Vec<Face> = faces.map(|(at, &corners)| Face { corners, group: group(at) }).collect();
        let values = VertexValues {
            points: growth.positions.iter().map(|&position| header.grid.quantize(position)).collect(),
            positions: growth.positions.clone(),
            integers,
        };
        let vertex_count = growth.positions.len() as u32;
        let coder = FragmentCoder::new(base.iter().copied(), vertex_count, header.groups.len() as u32)
            .with_triangle_limit(header.max_patch.into());
        Self {
            coder,
            values: ValueCoder::new(values, header.grid, &header.layers, header.is_exact),
            base,
            received: Vec::new(),
            first_vertex: growth.first_vertex.clone(),
            group_count: header.groups.len(),
            listed: OnceLock::new(),
        }
    }

    /// Number of fragments received.
    pub(crate) fn len(&self) -> usize {
        self.received.len()
    }

    /// Number of triangles of the level.
    pub(crate) fn triangle_count(&self) -> usize {
        self.coder.faces.len() as usize
    }

    /// Positions of all vertices.
    pub(crate) fn positions(&self) -> &[[f32; 3]] {
        &self.values.values.positions
    }

    /// Integers of all vertices in a layer.
    pub(crate) fn integers(&self, layer: usize) -> &[i32] {
        &self.values.values.integers[layer]
    }

    /// First vertex of each position, followed by the number of vertices.
    pub(crate) fn first_vertex(&self) -> &[u32] {
        &self.first_vertex
    }

    /// Decodes the next fragment; false if the data ended before it did.
    ///
    /// # Errors
    /// If the bits are no fragment, or there are more vertices than `most_vertices`.
    pub(crate) fn read(
        &mut self,
        reader: &mut RangeReader<'_>,
        most_vertices: u64,
    ) -> Result<bool, StreamDefect> {
        let step = self.received.len();
        let vertex_count = self.positions().len();
        let fragment = self.coder.code(reader, &CodedFragment::default());
        if reader.overran() {
            return Ok(false);
        }
        let fragment = fragment.map_err(|NoFragment| StreamDefect::Fragment { step })?;
        if vertex_count as u64 + u64::from(fragment.own_count) > most_vertices {
            return Err(StreamDefect::Fragment { step });
        }
        let values = self.values.code(reader, &fragment, None);
        if reader.overran() {
            self.values.truncate(vertex_count);
            return Ok(false);
        }
        values.map_err(|NoFragment| StreamDefect::Fragment { step })?;
        self.coder.apply(&fragment);
        self.first_vertex.push(self.positions().len() as u32);
        self.received.push(fragment);
        self.listed = OnceLock::new();
        Ok(true)
    }

    /// Triangles of the level by group.
    pub(crate) fn triangles(&self) -> &[[u32; 3]] {
        &self.listed().triangles
    }

    /// Group of each triangle; empty if the mesh has at most one.
    pub(crate) fn groups(&self) -> &[u32] {
        &self.listed().groups
    }

    fn listed(&self) -> &Listed {
        self.listed.get_or_init(|| {
            let faces = &self.coder.faces;
            let mut present: Vec<Face> =
                (0..faces.len()).map(|place| faces.get(faces.in_place(place))).collect();
            if self.group_count < 2 {
                return Listed {
                    triangles: present.iter().map(|face| face.corners).collect(),
                    groups: Vec::new(),
                };
            }
            present.sort_by_key(|face| face.group);
            let (triangles, groups) = present.iter().map(|face| (face.corners, face.group)).unzip();
            Listed { triangles, groups }
        })
    }

    /// Returns the fragments with a mesh that has the triangles of the level; `error_of` is the error of a step.
    ///
    /// # Errors
    /// [`FragmentError`] if the fragments are no sequence, which damaged streams can contain.
    pub(crate) fn fragmented_mesh(
        &self,
        mesh: IndexedMesh,
        error_of: impl Fn(usize) -> f32,
    ) -> Result<FragmentedMesh, FragmentError> {
        // Faces of the coder have numbers in the order of their creation, as those of a sequence.
        let mut created: Vec<Face> = self.base.clone();
        let fragments: Vec<Fragment> = self
            .received
            .iter()
            .enumerate()
            .map(|(step, fragment)| {
                let floor = fragment.floor.iter().map(|&face| created[face as usize]).collect();
                created.extend(&fragment.ceiling);
                Fragment { ceiling: fragment.ceiling.clone(), floor, error: error_of(step) }
            })
            .collect();
        let positions = PositionIndex::from_first(self.first_vertex.clone());
        let fragments =
            FragmentSequence::from_fragments(positions, self.base.clone(), fragments.into_iter())?;
        Ok(FragmentedMesh { mesh, fragments })
    }
}
