//! Triangles and vertices of some parts of a scene, put together.

use std::borrow::Cow;
use std::ops::Range;

use striata::mesh::{IndexedMesh, LayerData, Semantic};

use super::cuts::CutPart;
use super::outline::{OutlinePrimitive, PrimitiveOutline, SceneOutline};
use crate::error::Fault;
use crate::gltf::parts::{
    Accessor, GltfDocument, Primitive, Transform, TriangleRuns, append, document_fault, fill,
};
use crate::pieces::local::localize;

/// Memory that a piece may take regardless of the size of the scene, in bytes.
const ALWAYS_ALLOWED_BYTES: u64 = 1 << 30;

/// Additional memory allowed per byte of the scene.
const BYTES_PER_INPUT_BYTE: u64 = 64;

/// Mesh under construction.
pub(super) struct Assembly<'s> {
    outline: &'s SceneOutline,
    document: &'s GltfDocument<'s>,
    pub mesh: IndexedMesh,
    /// Group of each triangle.
    pub groups: Vec<u32>,
}

/// Vertices that some parts have in common.
pub(super) struct AssemblyBatch {
    shown: OutlinePrimitive,
    /// Number of each vertex in the accessors, increasing.
    pub numbers: Vec<u32>,
    /// The vertices in the mesh.
    vertices: Range<usize>,
}

impl<'s> Assembly<'s> {
    pub(super) fn new(outline: &'s SceneOutline, document: &'s GltfDocument<'s>) -> Self {
        let layers = outline.formats.iter().map(|(semantic, format)| format.layer(semantic, 0));
        let mesh = IndexedMesh { layers: layers.collect(), ..IndexedMesh::default() };
        Self { outline, document, mesh, groups: Vec::new() }
    }

    /// Adds parts that have their vertices in common. Normals that the file lacks are zero.
    pub(super) fn add(&mut self, parts: &[CutPart]) -> Result<AssemblyBatch, Fault> {
        let shown = self.outline.shown[parts[0].shown];
        let placement = &self.outline.placements[shown.placement as usize];
        let transform = placement.transform();
        let mut triangles = self.triangles(parts)?;
        let numbers = localize(&mut triangles);
        if transform.is_some_and(|transform| transform.is_mirrored) {
            triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        let vertices = self.mesh.positions.len()..self.mesh.positions.len() + numbers.len();
        self.check_size(vertices.end)?;
        let first = vertices.start as u32;
        self.mesh.triangles.extend(triangles.iter().map(|triangle| triangle.map(|vertex| vertex + first)));
        let batch = AssemblyBatch { shown, numbers, vertices };
        self.add_vertices(&batch, transform.as_ref())?;
        placement.pose.apply(&mut self.mesh, batch.vertices.clone());
        Ok(batch)
    }

    fn primitive_of(&self, shown: OutlinePrimitive) -> Result<(Primitive<'s>, &'s PrimitiveOutline), Fault> {
        let outline = &self.outline.primitives[shown.primitive as usize];
        let mesh = self.document.item("meshes", outline.mesh, &self.document.root)?;
        let at = mesh.entry("primitives", outline.index)?;
        match Primitive::parse(self.document, at.clone())? {
            Some(primitive) => Ok((primitive, outline)),
            None => Err(at.fault("the primitive draws no triangles")),
        }
    }

    /// Reads the triangles of all parts, and notes their groups.
    fn triangles(&mut self, parts: &[CutPart]) -> Result<Vec<[u32; 3]>, Fault> {
        let mut triangles = Vec::new();
        for CutPart { shown, triangles: range } in parts {
            let shown = self.outline.shown[*shown];
            let (primitive, outline) = self.primitive_of(shown)?;
            let runs = TriangleRuns::of(self.document, &primitive, outline.vertex_count)?;
            let place = outline.triangles.place_of(range.start);
            triangles.extend(runs.read(place, (range.end - range.start) as usize)?);
            self.groups.resize(triangles.len() + self.mesh.triangles.len(), shown.group);
        }
        Ok(triangles)
    }

    /// Refuses pieces whose vertices have far more attributes than the scene has bytes.
    fn check_size(&self, vertex_count: usize) -> Result<(), Fault> {
        let vertex_bytes: u64 = 12 + self.outline.formats.values().map(|f| f.vertex_bytes()).sum::<u64>();
        let bytes = vertex_bytes.saturating_mul(vertex_count as u64);
        let input_bytes = self.document.input_bytes;
        if bytes > ALWAYS_ALLOWED_BYTES.max(input_bytes.saturating_mul(BYTES_PER_INPUT_BYTE)) {
            let reason = format!(
                "a piece has {vertex_count} vertices of {vertex_bytes} bytes, too many for a scene of \
                 {input_bytes} bytes"
            );
            return Err(document_fault(reason));
        }
        Ok(())
    }

    /// Appends the positions and layers of a batch.
    fn add_vertices(&mut self, batch: &AssemblyBatch, transform: Option<&Transform>) -> Result<(), Fault> {
        let document = self.document;
        let (primitive, outline) = self.primitive_of(batch.shown)?;
        let accessor = primitive.positions(document)?;
        outline.check_count(&accessor)?;
        let points = elements(&accessor, &batch.numbers);
        let numbers = accessor.with_elements(&points).floats();
        let (points, _) = numbers.as_chunks::<3>();
        match transform {
            None => self.mesh.positions.extend_from_slice(points),
            Some(transform) => self.mesh.positions.extend(points.iter().map(|&p| transform.point(p))),
        }
        for layer in &mut self.mesh.layers {
            let place = primitive.attributes.binary_search_by(|(semantic, _)| semantic.cmp(&layer.semantic));
            match place.map(|place| &primitive.attributes[place]) {
                Ok((semantic, index)) => {
                    let accessor = primitive.attribute(document, semantic, *index)?;
                    outline.check_count(&accessor)?;
                    let values = elements(&accessor, &batch.numbers);
                    append(layer, &accessor.with_elements(&values), transform);
                }
                Err(_) => fill(layer, batch.numbers.len()),
            }
        }
        Ok(())
    }

    /// Accounts for memory that all vertices of a shown primitive will take; returns their number.
    pub(super) fn claim_vertices(&self, shown: u32, vertex_bytes: usize) -> Result<usize, Fault> {
        let (primitive, outline) = self.primitive_of(self.outline.shown[shown as usize])?;
        // Compressed views may declare any number of vertices.
        outline.check_count(&primitive.positions(self.document)?)?;
        let bytes = vertex_bytes as u64 * outline.vertex_count as u64;
        self.document.unpacked.claim(bytes, self.document.input_bytes, &primitive.at)?;
        Ok(outline.vertex_count)
    }

    /// Sets the normals of a batch; `normals` are those of all vertices of its accessors.
    pub(super) fn set_normals(&mut self, batch: &AssemblyBatch, normals: &[[f32; 3]]) {
        let layer = self.mesh.layers.iter_mut().find(|layer| layer.semantic == Semantic::Normal);
        if let Some(LayerData::F32(data)) = layer.map(|layer| &mut layer.data) {
            let (own, _) = data[3 * batch.vertices.start..3 * batch.vertices.end].as_chunks_mut::<3>();
            for (normal, &number) in own.iter_mut().zip(&batch.numbers) {
                *normal = normals[number as usize];
            }
        }
    }
}

impl AssemblyBatch {
    /// Number of the block whose normals the batch needs, if the file lacks them.
    pub(super) fn block(&self) -> Option<usize> {
        self.shown.block()
    }
}

impl PrimitiveOutline {
    /// Whether an accessor still has an element for each vertex: compressed data may change in the file.
    fn check_count(&self, accessor: &Accessor<'_>) -> Result<(), Fault> {
        if accessor.count == self.vertex_count {
            return Ok(());
        }
        let (found, vertex_count) = (accessor.count, self.vertex_count);
        Err(accessor.fault(format!("{found} elements for {vertex_count} vertices")))
    }
}

/// Returns the bytes of the elements with these increasing numbers, copied only if there are gaps.
fn elements<'a>(accessor: &'a Accessor<'_>, numbers: &[u32]) -> Cow<'a, [u8]> {
    let (Some(&first), Some(&last)) = (numbers.first(), numbers.last()) else { return Cow::Borrowed(&[]) };
    let range = first as usize..last as usize + 1;
    if range.len() == numbers.len() { accessor.range(range) } else { Cow::Owned(accessor.gather(numbers)) }
}
