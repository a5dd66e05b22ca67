//! Encodes fragments: a base mesh like that of any stream, then one record after another.

use std::collections::HashMap;

use striata::mesh::{
    CollapseSequence, Face, FragmentedMesh, PositionIndex, RefinableMesh, SequenceParts, canonical_triangles,
    replay_fragments,
};
use striata::{Progress, ProgressFn, ignore_progress};

use crate::StreamDecoder;
use crate::entropy::RangeWriter;
use crate::format::header::{ChunkEntry, min_bytes_of_fragments, min_chunk_bytes, min_total_bytes};
use crate::fragments::record::{CodedFragment, FragmentCoder, NoFragment};
use crate::fragments::values::{ValueCoder, VertexValues};
use crate::writer::chunks::chunk_end;
use crate::writer::defect::{BatchDefect, StreamError};
use crate::writer::encode::{
    Encoded, EncodedStream, StreamLayout, StreamOptions, StreamPlan, StreamSizes, Totals, encode_splits,
};

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
/// let fragmented = decoder.fragmented_mesh().expect("a complete stream");
/// assert_eq!(fragmented.mesh.triangle_count(), 1024);
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
    let Encoded { mut header, chunks, source_vertex: mut source } =
        encode_splits(&base_of(fragmented), &[0], &plan, progress)?;
    let StreamPlan { layout, .. } = plan;

    // The reader's base mesh, in the reader's order.
    let mut base = header.to_bytes()?;
    chunks.chunks.iter().for_each(|chunk| base.extend_from_slice(&chunk.bytes));
    let mut decoder = StreamDecoder::new();
    decoder.push(&base).map_err(|_| BatchDefect::Dependent { batch: 0 })?;
    let base_vertex_count = source.len();
    source.extend(base_vertex_count as u32..mesh.vertex_count() as u32);
    let mut vertex_of = vec![0; source.len()];
    (0..).zip(&source).for_each(|(vertex, &source)| vertex_of[source as usize] = vertex);
    let renamed = |face: Face| Face { corners: face.corners.map(|v| vertex_of[v as usize]), ..face };

    let all = VertexValues {
        points: source.iter().map(|&v| layout.grid.quantize(mesh.positions[v as usize])).collect(),
        positions: source.iter().map(|&v| mesh.positions[v as usize]).collect(),
        integers: mesh
            .layers
            .iter()
            .zip(&layout.forms)
            .map(|(layer, form)| {
                let (integers, count) = (form.integers(layer), form.integer_count());
                source.iter().flat_map(|&v| integers[v as usize * count..][..count].to_vec()).collect()
            })
            .collect(),
    };
    let group_of = |at: usize| decoder.triangle_groups().get(at).copied().unwrap_or(0);
    let base_faces = decoder.triangles().iter().enumerate();
    let base_faces: Vec<Face> =
        base_faces.map(|(at, &corners)| Face { corners, group: group_of(at) }).collect();
    let mut number_of: HashMap<Face, Vec<u32>> = HashMap::new();
    for (number, &face) in (0..).zip(&base_faces) {
        number_of.entry(canonical(face)).or_default().push(number);
    }
    let group_count = mesh.groups.len() as u32;
    let mut coder = FragmentCoder::new(base_faces.iter().copied(), base_vertex_count as u32, group_count)
        .with_triangle_limit(u64::MAX);
    let mut values = ValueCoder::new(
        all.first(base_vertex_count, &layout.forms),
        layout.grid,
        &layout.forms,
        layout.is_exact,
    );

    let mut spent = chunks.spent;
    let mut exchanged = 0u64;
    let mut created = base_faces.len() as u32;
    let mut bodies: Vec<Vec<u8>> = chunks.chunks.into_iter().map(|chunk| chunk.bytes).collect();
    let step_count = fragments.step_count();
    let mut done = 0;
    while done < step_count {
        Progress { phase: "encode", done: done as u64, total: step_count as u64 }.report(progress)?;
        let end = chunk_end(done, step_count);
        let mut writer = RangeWriter::new();
        for step in done as u32..end as u32 {
            let face = |face: u32| renamed(fragments.faces()[face as usize]);
            let number = |at: &u32| number_of.get_mut(&canonical(face(*at)))?.pop();
            let actual = CodedFragment {
                own_count: levels.step_vertices(step as usize).len() as u32,
                floor: fragments.floor(step).iter().map(number).collect::<Option<_>>().unwrap_or_default(),
                ceiling: fragments.ceiling(step).map(face).collect(),
            };
            let no_fragment = |NoFragment| BatchDefect::Dependent { batch: step as usize };
            let coded = coder.code(&mut writer, &actual).map_err(no_fragment)?;
            values.code(&mut writer, &coded, Some(&all)).map_err(no_fragment)?;
            coder.apply(&coded);
            exchanged += (coded.floor.len() + coded.ceiling.len()) as u64;
            for &face in &coded.ceiling {
                number_of.entry(canonical(face)).or_default().push(created);
                created += 1;
            }
        }
        let (mut bytes, bits) = writer.finish();
        spent.iter_mut().zip(bits).for_each(|(sum, bits)| *sum += bits);
        bytes.resize(bytes.len().max(min_chunk_bytes(end - done, 0)), 0);
        bodies.push(bytes);
        header.chunks.push(ChunkEntry {
            bytes: 0,
            split_count: end as u32,
            error: levels.error_at(done),
            checksum: 0,
        });
        done = end;
    }
    header.max_patch = u32::try_from(exchanged).unwrap_or(u32::MAX);
    let coded: usize = bodies.iter().map(Vec::len).sum();
    let wedges = totals.vertex_count as usize - totals.position_count as usize;
    let least = min_bytes_of_fragments(header.max_patch).max(min_total_bytes(wedges));
    if let Some(last) = bodies.last_mut() {
        // A reader treats missing bytes as zeros, so appending zeros changes nothing.
        last.resize(last.len() + least.saturating_sub(coded), 0);
    }
    for (entry, body) in header.chunks.iter_mut().zip(&bodies) {
        (entry.bytes, entry.checksum) = (body.len() as u32, crc32fast::hash(body));
    }
    header.chunks[0].error = levels.error_at(0);
    header.has_fragments = true;
    (header.position_count, header.vertex_count) = (totals.position_count, totals.vertex_count);
    (header.triangle_count, header.step_count) = (mesh.triangle_count() as u32, step_count as u32);
    let mut bytes = header.to_bytes()?;
    bodies.iter().for_each(|body| bytes.extend_from_slice(body));
    let sizes = StreamSizes::of(bytes.len(), &spent);
    Ok(EncodedStream { bytes, sizes, source_vertex: source })
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
