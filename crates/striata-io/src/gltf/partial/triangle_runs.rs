//! Triangles of a primitive, of which any run can be read.
//!
//! Places are where a triangle may begin: every third index of a list, and all indices but the last two of a
//! strip or fan. Strips and fans have degenerate triangles, which are left out, so their triangles are
//! counted once, with the places of some of them for later.

use std::ops::Range;

use crate::error::Fault;
use crate::gltf::accessor::{Accessor, AccessorShape};
use crate::gltf::component_type::GltfComponentType;
use crate::gltf::document::GltfDocument;
use crate::gltf::primitive::{Primitive, PrimitiveTopology, is_proper};

/// Number of indices of strips and fans that may be read regardless of the size of the file.
const ALWAYS_READ: u64 = 1 << 26;

/// Number of indices more for each byte of the document and its buffers.
const INDICES_PER_INPUT_BYTE: u64 = 16;

/// Number of places of a strip or fan that are examined at once.
const PLACES_AT_ONCE: usize = 1 << 14;

/// Triangles of a primitive.
pub(crate) struct TriangleRuns<'d> {
    /// [`None`] if the vertices are drawn in their order.
    indices: Option<Accessor<'d>>,
    index_count: usize,
    vertex_count: usize,
    topology: PrimitiveTopology,
}

/// Number of triangles of a primitive, and places of some of them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct TriangleCount {
    pub triangle_count: u64,
    /// Place of every triangle whose number is a multiple of the size of a run; none if places are numbers of
    /// triangles.
    run_places: Box<[u64]>,
    run_size: u64,
}

impl TriangleCount {
    /// Counts the triangles of a primitive. Lists are not read for this unless they are compressed meshes.
    ///
    /// `read_count` is the number of indices that have been read; those of this primitive are added. It is
    /// limited by the size of the document, because primitives may share their indices.
    pub(crate) fn of(
        document: &GltfDocument<'_>,
        primitive: &Primitive<'_>,
        vertex_count: usize,
        run_size: usize,
        read_count: &mut u64,
    ) -> Result<Self, Fault> {
        if primitive.topology != PrimitiveTopology::List || primitive.draco.is_some() {
            let runs = TriangleRuns::of(document, primitive, vertex_count)?;
            *read_count += runs.index_count as u64;
            if *read_count > ALWAYS_READ.max(document.input_bytes.saturating_mul(INDICES_PER_INPUT_BYTE)) {
                let reason = format!(
                    "{read_count} indices of strips and fans are too many for a file of {} bytes",
                    document.input_bytes
                );
                return Err(primitive.at.fault(reason));
            }
            return runs.count(run_size);
        }
        let shape = primitive.index_shape(document)?;
        shape.as_ref().map_or(Ok(()), check)?;
        let index_count = shape.map_or(vertex_count, |shape| shape.count);
        Ok(Self { triangle_count: index_count as u64 / 3, ..Self::default() })
    }

    /// Returns the place of a triangle whose number is a multiple of the size of a run.
    pub(crate) fn place_of(&self, triangle: u64) -> u64 {
        if self.run_places.is_empty() {
            triangle
        } else {
            self.run_places[(triangle / self.run_size) as usize]
        }
    }
}

/// Refuses what cannot be indices.
fn check(shape: &AccessorShape) -> Result<(), Fault> {
    if shape.component_count != 1 {
        return Err(shape.fault("indices must be SCALAR"));
    }
    if !matches!(shape.component, GltfComponentType::U8 | GltfComponentType::U16 | GltfComponentType::U32) {
        return Err(shape.fault("indices must be unsigned integers"));
    }
    Ok(())
}

impl<'d> TriangleRuns<'d> {
    /// Opens the triangles of a primitive.
    pub(crate) fn of(
        document: &'d GltfDocument<'_>,
        primitive: &Primitive<'_>,
        vertex_count: usize,
    ) -> Result<Self, Fault> {
        let indices = primitive.index_accessor(document)?;
        indices.as_deref().map_or(Ok(()), check)?;
        let index_count = indices.as_ref().map_or(vertex_count, |indices| indices.count);
        Ok(Self { indices, index_count, vertex_count, topology: primitive.topology })
    }

    fn place_count(&self) -> usize {
        match self.topology {
            PrimitiveTopology::List => self.index_count / 3,
            PrimitiveTopology::Strip | PrimitiveTopology::Fan => self.index_count.saturating_sub(2),
        }
    }

    fn count(&self, run_size: usize) -> Result<TriangleCount, Fault> {
        if self.topology == PrimitiveTopology::List {
            return Ok(TriangleCount {
                triangle_count: self.place_count() as u64,
                ..TriangleCount::default()
            });
        }
        let (mut triangle_count, run_size, mut run_places) = (0u64, run_size as u64, Vec::new());
        self.visit(0, |place, _| {
            if triangle_count.is_multiple_of(run_size) {
                run_places.push(place as u64);
            }
            triangle_count += 1;
            true
        })?;
        Ok(TriangleCount { triangle_count, run_places: run_places.into(), run_size })
    }

    /// Reads `count` triangles from a place on, or as many as there are.
    pub(crate) fn read(&self, place: u64, count: usize) -> Result<Vec<[u32; 3]>, Fault> {
        let first = usize::try_from(place).unwrap_or(usize::MAX).min(self.place_count());
        if self.topology == PrimitiveTopology::List {
            let end = first.saturating_add(count).min(self.place_count());
            return Ok(self.numbers(3 * first..3 * end)?.as_chunks::<3>().0.to_vec());
        }
        let mut triangles = Vec::with_capacity(count.min(self.place_count() - first));
        if count > 0 {
            self.visit(first, |_, triangle| {
                triangles.push(triangle);
                triangles.len() < count
            })?;
        }
        Ok(triangles)
    }

    /// Visits the triangles of a strip or fan from a place on, while `visit` returns true.
    fn visit(&self, first: usize, mut visit: impl FnMut(usize, [u32; 3]) -> bool) -> Result<(), Fault> {
        let is_strip = self.topology == PrimitiveTopology::Strip;
        let hub = if self.place_count() > 0 && !is_strip { self.numbers(0..1)?[0] } else { 0 };
        let places_at_once = self.indices.as_ref().map_or(0, Accessor::replaced_count).max(PLACES_AT_ONCE);
        let mut next = first;
        while next < self.place_count() {
            let end = self.place_count().min(next + places_at_once);
            let numbers = self.numbers(next..end + 2)?;
            for (place, w) in (next..).zip(numbers.windows(3)) {
                let triangle = match (is_strip, place % 2) {
                    (false, _) => [hub, w[1], w[2]],
                    (true, 0) => [w[0], w[1], w[2]],
                    (true, _) => [w[1], w[0], w[2]],
                };
                if is_proper(triangle) && !visit(place, triangle) {
                    return Ok(());
                }
            }
            next = end;
        }
        Ok(())
    }

    /// Reads and checks the numbers of vertices at some indices.
    fn numbers(&self, range: Range<usize>) -> Result<Vec<u32>, Fault> {
        let Some(indices) = &self.indices else { return Ok(range.map(|index| index as u32).collect()) };
        let bytes = indices.range(range.clone());
        let numbers = indices.with_elements(&bytes).integers().unwrap_or_default();
        match numbers.iter().position(|&vertex| vertex as usize >= self.vertex_count) {
            None => Ok(numbers),
            Some(place) => {
                let (vertex, count) = (numbers[place], self.vertex_count);
                let place = range.start + place;
                let reason = format!("index {place} is vertex {vertex}, but there are {count}");
                Err(indices.fault(reason))
            }
        }
    }
}
