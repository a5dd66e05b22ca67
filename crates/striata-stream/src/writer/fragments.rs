//! Encodes fragments: a base mesh like that of any stream, then one record after another.

use std::collections::HashMap;
use std::ops::Range;

use striata::mesh::{
    CollapseSequence, Face, FragmentSequence, FragmentedMesh, PositionIndex, RefinableMesh, SequenceParts,
    canonical_triangles, replay_fragments,
};
use striata::{Progress, ProgressFn, ignore_progress};

use crate::StreamDecoder;
use crate::entropy::{PART_COUNT, RangeWriter};
use crate::format::header::{
    ChunkEntry, min_bytes_of_fragments, min_chunk_bytes, min_total_bytes, put_chunk,
};
use crate::fragments::record::{CodedFragment, FragmentCoder};
use crate::fragments::values::{ValueCoder, VertexValues};
use crate::writer::chunks::chunk_end;
use crate::writer::defect::{BatchDefect, StreamError};
use crate::writer::encode::{
    EncodedStream, SplitChunks, StreamLayout, StreamOptions, StreamPlan, StreamSizes, Totals, encode_splits,
};

/// Number of steps in the first chunk. A chunk has one error, which falls by orders of magnitude within the first
/// hundreds of steps.
const FIRST_STEPS: usize = 8;

/// Encodes a mesh with the fragments of any simplifier as a progressive stream.
///
/// Steps may remove positions and fill the hole in any way, or collapse edges to new vertices; they are coded in their
/// order. Streams of collapses ([`encode_stream`](crate::encode_stream)) are smaller, since the steps of a batch
/// need no place.
///
/// ```
/// use striata::mesh::shapes;
/// use striata::simplify::{RemovalOptions, build_fragments};
/// use striata_stream::{StreamDecoder, StreamOptions, encode_fragments};
///
/// let built = build_fragments(&shapes::torus(32, 16, 1.0, 0.4), &RemovalOptions::default())?;
/// let stream = encode_fragments(&built.fragmented, &StreamOptions::default())?;
/// let mut decoder = StreamDecoder::new();
/// decoder.push(&stream.bytes)?;
/// let steps = decoder.steps().expect("a complete stream");
/// assert_eq!(steps.mesh().triangle_count(), 1024);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`StreamError`] if the mesh is invalid, the position grid does not exist, or triangles have data.
pub fn encode_fragments(
    fragmented: &FragmentedMesh,
    options: &StreamOptions,
) -> Result<EncodedStream, StreamError> {
    encode_fragments_with_progress(fragmented, options, &mut ignore_progress)
}

/// Runs [`encode_fragments`] and reports progress; the callback can cancel.
///
/// # Errors
/// See [`encode_fragments`]; also [`StreamError::Cancelled`] if the callback cancels.
pub fn encode_fragments_with_progress(
    fragmented: &FragmentedMesh,
    options: &StreamOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<EncodedStream, StreamError> {
    let FragmentedMesh { mesh, fragments } = fragmented;
    mesh.check()?;
    if let Some(layer) = mesh.triangle_layers.first() {
        return Err(StreamError::TriangleData { name: format!("{:?}", layer.semantic) });
    }
    let layout = StreamLayout::new(mesh, options)?;
    let levels = fragments.levels();
    let totals = Totals {
        position_count: levels.positions().position_count() as u32,
        vertex_count: mesh.vertex_count() as u32,
    };
    let plan = StreamPlan { options, layout, totals };
    let SplitChunks { mut header, chunks, source_vertex: mut source } =
        encode_splits(&base_of(fragmented), &[0], &plan, progress)?;
    let mut decoder = StreamDecoder::new();
    let mut base = header.to_bytes()?;
    chunks.chunks.iter().for_each(|chunk| put_chunk(&chunk.bytes, &mut base));
    decoder.push(&base).map_err(|_| BatchDefect::Dependent { batch: 0 })?;
    let base_vertex_count = source.len() as u32;
    source.extend(base_vertex_count..totals.vertex_count);
    let mut writer = FragmentWriter::new(fragmented, &decoder, &source, &plan.layout);

    let mut spent = chunks.spent;
    let mut bodies: Vec<Vec<u8>> = chunks.chunks.into_iter().map(|chunk| chunk.bytes).collect();
    let step_count = levels.step_count();
    let mut done = 0;
    while done < step_count {
        Progress { phase: "encode", done: done as u64, total: step_count as u64 }.report(progress)?;
        let end = chunk_end(done, step_count, FIRST_STEPS);
        let (bytes, bits) = writer.chunk(done as u32..end as u32)?;
        spent.iter_mut().zip(bits).for_each(|(sum, bits)| *sum += bits);
        bodies.push(bytes);
        let error = levels.error_at(done);
        header.chunks.push(ChunkEntry { bytes: 0, split_count: end as u32, error });
        done = end;
    }
    header.max_patch = u32::try_from(writer.exchanged).unwrap_or(u32::MAX);
    let wedges = totals.vertex_count as usize - totals.position_count as usize;
    let least = min_bytes_of_fragments(header.max_patch).max(min_total_bytes(wedges));
    let coded: usize = bodies.iter().map(Vec::len).sum();
    if let Some(last) = bodies.last_mut() {
        // A reader treats missing bytes as zeros, so appending zeros changes nothing.
        last.resize(last.len() + least.saturating_sub(coded), 0);
    }
    for (entry, body) in header.chunks.iter_mut().zip(&bodies) {
        entry.bytes = body.len() as u32;
    }
    header.chunks[0].error = levels.error_at(0);
    header.has_fragments = true;
    (header.position_count, header.vertex_count) = (totals.position_count, totals.vertex_count);
    (header.triangle_count, header.step_count) = (mesh.triangle_count() as u32, step_count as u32);
    let mut bytes = header.to_bytes()?;
    bodies.iter().for_each(|body| put_chunk(body, &mut bytes));
    let sizes = StreamSizes::of(bytes.len(), &spent);
    Ok(EncodedStream { bytes, sizes, source_vertex: source })
}

/// Codes the fragments of a mesh, from the base mesh as a reader has it.
struct FragmentWriter<'m> {
    fragments: &'m FragmentSequence,
    coder: FragmentCoder,
    values: ValueCoder,
    /// Values of all vertices, in the order of the stream.
    all: VertexValues,
    /// For each vertex of the mesh, that of the stream.
    vertex_of: Vec<u32>,
    /// Numbers of the triangles of the level.
    number_of: HashMap<Face, Vec<u32>>,
    /// Number of triangles so far, those of the base mesh included.
    created: u32,
    /// Number of triangles of all floors and ceilings so far.
    exchanged: u64,
}

impl<'m> FragmentWriter<'m> {
    /// Starts with the base mesh that a reader has; `source` has the vertex of the mesh for each vertex of the stream.
    fn new(
        FragmentedMesh { mesh, fragments }: &'m FragmentedMesh,
        reader: &StreamDecoder,
        source: &[u32],
        StreamLayout { grid, forms, is_exact }: &StreamLayout,
    ) -> Self {
        let mut vertex_of = vec![0; source.len()];
        (0..).zip(source).for_each(|(vertex, &source)| vertex_of[source as usize] = vertex);
        let integers = mesh.layers.iter().zip(forms).map(|(layer, form)| {
            let (integers, count) = (form.integers(layer), form.integer_count());
            source.iter().flat_map(|&v| integers[v as usize * count..][..count].to_vec()).collect()
        });
        let all = VertexValues {
            points: source.iter().map(|&v| grid.quantize(mesh.positions[v as usize])).collect(),
            positions: source.iter().map(|&v| mesh.positions[v as usize]).collect(),
            integers: integers.collect(),
        };
        let group_of = |at: usize| reader.triangle_groups().get(at).copied().unwrap_or(0);
        let corners = reader.triangles().iter().enumerate();
        let base: Vec<Face> = corners.map(|(at, &corners)| Face { corners, group: group_of(at) }).collect();
        let mut number_of: HashMap<Face, Vec<u32>> = HashMap::new();
        for (number, &face) in (0..).zip(&base) {
            number_of.entry(canonical(face)).or_default().push(number);
        }
        let vertex_count = reader.positions().len();
        let coder = FragmentCoder::new(base.iter().copied(), vertex_count as u32, mesh.groups.len() as u32);
        Self {
            fragments,
            coder: coder.with_triangle_limit(u64::MAX),
            values: ValueCoder::new(all.first(vertex_count, forms), *grid, forms, *is_exact),
            all,
            vertex_of,
            number_of,
            created: base.len() as u32,
            exchanged: 0,
        }
    }

    /// Codes steps, and returns their bytes and the bits of each part.
    ///
    /// # Errors
    /// If a step replaces triangles that are not there.
    fn chunk(&mut self, steps: Range<u32>) -> Result<(Vec<u8>, [f64; PART_COUNT]), BatchDefect> {
        let step_count = steps.len();
        let mut writer = RangeWriter::new();
        for step in steps {
            self.step(&mut writer, step).ok_or(BatchDefect::Dependent { batch: step as usize })?;
        }
        let (mut bytes, bits) = writer.finish();
        bytes.resize(bytes.len().max(min_chunk_bytes(step_count, 0)), 0);
        Ok((bytes, bits))
    }

    /// Codes a step; [`None`] if it replaces triangles that are not there.
    fn step(&mut self, writer: &mut RangeWriter, step: u32) -> Option<()> {
        let named = |face: u32| {
            let face = self.fragments.faces()[face as usize];
            Face { corners: face.corners.map(|v| self.vertex_of[v as usize]), ..face }
        };
        let number_of = &mut self.number_of;
        let floor =
            self.fragments.floor(step).iter().map(|&face| number_of.get_mut(&canonical(named(face)))?.pop());
        let actual = CodedFragment {
            own_count: self.fragments.levels().step_vertices(step as usize).len() as u32,
            floor: floor.collect::<Option<_>>()?,
            ceiling: self.fragments.ceiling(step).map(named).collect(),
        };
        let coded = self.coder.code(writer, &actual).ok()?;
        self.values.code(writer, &coded, Some(&self.all)).ok()?;
        self.coder.apply(&coded);
        self.exchanged += (coded.floor.len() + coded.ceiling.len()) as u64;
        for &face in &coded.ceiling {
            self.number_of.entry(canonical(face)).or_default().push(self.created);
            self.created += 1;
        }
        Some(())
    }
}

/// The base mesh as a sequence without steps.
fn base_of(fragmented: &FragmentedMesh) -> RefinableMesh {
    let mut mesh = replay_fragments(fragmented, 0);
    mesh.appearance = fragmented.mesh.appearance.clone();
    let levels = fragmented.fragments.levels();
    let base_position_count = levels.base_position_count();
    let firsts = (0..=base_position_count as u32).map(|position| {
        if position as usize == base_position_count {
            mesh.vertex_count() as u32
        } else {
            levels.positions().first_vertex(position)
        }
    });
    let sequence = CollapseSequence::from_parts(SequenceParts {
        base_position_count,
        positions: PositionIndex::from_first(firsts.collect()),
        targets: Vec::new(),
        errors: Vec::new(),
        removed_triangle_counts: Vec::new(),
        triangle_count: mesh.triangle_count(),
    });
    let sequence = sequence.expect("the positions of the base mesh");
    RefinableMesh { mesh, sequence }
}

fn canonical(face: Face) -> Face {
    Face { corners: canonical_triangles(&[face.corners])[0], ..face }
}
