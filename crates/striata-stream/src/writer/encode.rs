//! The entry point of the writer: options, [`encode_stream`], and statistics on where the bits went.

use striata::mesh::{Bounds, IndexedMesh, RefinableMesh};
use striata::{ProgressFn, ignore_progress};

use crate::base::coder::BaseLimits;
use crate::entropy::PART_COUNT;
use crate::format::effort::Effort;
use crate::format::grid::{GridError, PositionGrid};
use crate::format::header::{ChunkEntry, GroupName, MAX_COMPONENTS, StreamHeader, put_chunk};
use crate::layers::form::LayerForm;
use crate::layers::layer_neighborhood::LayerValues;
use crate::layers::options::LayerOptions;
use crate::layers::triangle_data;
use crate::refine::parameters::StreamParameters;
use crate::writer::chunks::{Chunks, check_batches, encode_chunks};
use crate::writer::defect::StreamError;
use crate::writer::descent::Descent;
use crate::writer::reference_mesh::VertexData;

/// How precisely positions are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Precision {
    /// Positions snap to a cubic grid with this many bits (1 to 24) along the longest side of the bounds.
    Bits(u32),
    /// Positions snap to a cubic grid so fine that no vertex moves farther than this, in mesh units.
    Tolerance(f64),
    /// Positions snap to points that are multiples of a length after the mesh has been moved; meshes that touch still
    /// do so if they have the same steps, moved to where they touch.
    Lattice {
        /// Length in mesh units; the step is the next power of two below it.
        step: f64,
        /// Move of the mesh, mesh units.
        offset: [f64; 3],
    },
    /// Positions and attribute layers keep their exact floats.
    Lossless,
}

impl Default for Precision {
    fn default() -> Self {
        Self::Bits(14)
    }
}

/// Options of [`encode_stream`].
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StreamOptions {
    /// Precision of the positions; 14 bits by default.
    pub precision: Precision,
    /// Trade-off between speed and size; default [`Effort::Fast`].
    pub effort: Effort,
    /// Precision of the attribute layers.
    pub layers: LayerOptions,
    /// Key and value pairs stored with the stream; none by default.
    pub metadata: Vec<(String, String)>,
}

impl StreamOptions {
    /// Sets [`Self::precision`].
    pub fn with_precision(self, precision: Precision) -> Self {
        Self { precision, ..self }
    }

    /// Sets [`Self::effort`].
    pub fn with_effort(self, effort: Effort) -> Self {
        Self { effort, ..self }
    }

    /// Sets [`Self::layers`].
    pub fn with_layers(self, layers: LayerOptions) -> Self {
        Self { layers, ..self }
    }

    /// Returns the spacing of the position grid for `mesh`, in mesh units.
    ///
    /// # Errors
    /// [`GridError`] if the precision does not give a valid grid.
    pub fn grid_step(&self, mesh: &IndexedMesh) -> Result<f64, GridError> {
        grid_of(mesh, self.precision).map(|grid| grid.step)
    }

    /// Returns how many positions of a mesh fall on those of others when they are rounded, such as because one vertex
    /// is so far away that the grid is coarser than everything else. Cost: sorts all positions.
    ///
    /// # Errors
    /// [`GridError`] if the precision does not give a valid grid.
    pub fn merged_position_count(&self, mesh: &IndexedMesh) -> Result<usize, GridError> {
        if self.precision == Precision::Lossless {
            return Ok(0);
        }
        let grid = grid_of(mesh, self.precision)?;
        let apart = distinct(mesh.positions.iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect());
        Ok(apart.saturating_sub(distinct(mesh.positions.iter().map(|&p| grid.quantize(p)).collect())))
    }

    /// Adds to [`Self::metadata`].
    pub fn with_metadata(mut self, key: impl Into<String>, value: impl Into<String>) -> Self {
        self.metadata.push((key.into(), value.into()));
        self
    }
}

fn distinct<T: Ord>(mut values: Vec<T>) -> usize {
    values.sort_unstable();
    values.dedup();
    values.len()
}

/// Recommended value of [`BatchOptions::shape_step`](striata::simplify::BatchOptions::shape_step), in
/// grid steps, for a mesh that becomes a stream: well-shaped triangles are cheaper to predict.
pub const SHAPE_STEPS: f64 = 1.5;

/// Number of bits spent on each kind of data. Connectivity, positions, attributes and other add up to the
/// whole stream.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StreamSizes {
    /// Bits that store which vertices split and how.
    pub connectivity_bits: f64,
    /// Bits of vertex positions.
    pub position_bits: f64,
    /// Bits of wedges, groups and attribute layers: the sum of the next three fields and all other layers.
    pub attribute_bits: f64,
    /// Bits that store which vertex each corner refers to, and the groups of triangles.
    pub wedge_bits: f64,
    /// Bits of normals.
    pub normal_bits: f64,
    /// Bits of texture coordinates.
    pub texcoord_bits: f64,
    /// Bits of the header, the base mesh and the rounding between chunks.
    pub other_bits: f64,
}

impl StreamSizes {
    pub(crate) fn of(byte_count: usize, spent: &[f64; PART_COUNT]) -> Self {
        let [connectivity_bits, position_bits, wedge_bits, normal_bits, texcoord_bits, other_layers, _] =
            *spent;
        let attribute_bits = wedge_bits + normal_bits + texcoord_bits + other_layers;
        let other_bits = byte_count as f64 * 8.0 - connectivity_bits - position_bits - attribute_bits;
        Self {
            connectivity_bits,
            position_bits,
            attribute_bits,
            wedge_bits,
            normal_bits,
            texcoord_bits,
            other_bits,
        }
    }
}

/// An encoded stream and its vertex order.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct EncodedStream {
    /// Bytes of the stream.
    pub bytes: Vec<u8>,
    /// Number of bits spent on each kind of data.
    pub sizes: StreamSizes,
    /// For each vertex that a decoder produces, the index of the vertex in the source mesh.
    pub source_vertex: Vec<u32>,
}

/// Encodes a mesh with its collapse sequence as a progressive stream.
///
/// The steps must be in batches, as [`build_batches`](striata::simplify::build_batches) makes them:
/// `batches` lists the split counts at which batches begin, followed by the number of steps.
///
/// # Errors
/// [`StreamError`] if the mesh is invalid, the position grid does not exist, or the steps of a batch
/// depend on each other.
pub fn encode_stream(
    refinable: &RefinableMesh,
    batches: &[u32],
    options: &StreamOptions,
) -> Result<EncodedStream, StreamError> {
    encode_stream_with_progress(refinable, batches, options, &mut ignore_progress)
}

/// Runs [`encode_stream`] and reports progress; the callback can cancel.
///
/// # Errors
/// See [`encode_stream`]; also [`StreamError::Cancelled`] if the callback cancels.
pub fn encode_stream_with_progress(
    refinable: &RefinableMesh,
    batches: &[u32],
    options: &StreamOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<EncodedStream, StreamError> {
    refinable.mesh.check()?;
    let layout = StreamLayout::new(&refinable.mesh, options)?;
    let totals = Totals {
        position_count: refinable.sequence.positions().position_count() as u32,
        vertex_count: refinable.mesh.vertex_count() as u32,
    };
    let SplitChunks { mut header, chunks, source_vertex } =
        encode_splits(refinable, batches, &StreamPlan { options, layout, totals }, progress)?;
    let data = triangle_data::encode(&in_stream_order(&refinable.mesh, &source_vertex));
    let (entry, data) = data.unzip();
    header.triangle_data = entry;
    let mut bytes = header.to_bytes()?;
    chunks.chunks.iter().for_each(|chunk| put_chunk(&chunk.bytes, &mut bytes));
    bytes.extend(data.into_iter().flatten());
    let sizes = StreamSizes::of(bytes.len(), &chunks.spent);
    Ok(EncodedStream { bytes, sizes, source_vertex })
}

/// How a stream stores the values of vertices.
#[derive(Clone, Debug)]
pub(crate) struct StreamLayout {
    pub grid: PositionGrid,
    pub forms: Vec<LayerForm>,
    pub is_exact: bool,
}

impl StreamLayout {
    /// Chooses the layout for a mesh.
    ///
    /// # Errors
    /// If there is no such grid, or the layers have too many numbers.
    pub(crate) fn new(mesh: &IndexedMesh, options: &StreamOptions) -> Result<Self, StreamError> {
        let is_exact = options.precision == Precision::Lossless;
        let grid = grid_of(mesh, options.precision)?;
        let layer_options = LayerOptions { lossless: is_exact || options.layers.lossless, ..options.layers };
        layer_options.check()?;
        let forms: Vec<_> = mesh.layers.iter().map(|layer| LayerForm::of(layer, &layer_options)).collect();
        let number_count = forms.iter().map(LayerForm::integer_count).sum();
        if number_count > MAX_COMPONENTS {
            return Err(StreamError::Numbers { number_count });
        }
        Ok(Self { grid, forms, is_exact })
    }
}

/// Numbers of positions and vertices of the full mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Totals {
    pub position_count: u32,
    pub vertex_count: u32,
}

/// How the vertex splits of a stream are encoded.
pub(crate) struct StreamPlan<'o> {
    pub options: &'o StreamOptions,
    pub layout: StreamLayout,
    pub totals: Totals,
}

/// Chunks of vertex splits, and a header for them.
pub(crate) struct SplitChunks {
    pub header: StreamHeader,
    pub chunks: Chunks,
    /// For each vertex that a decoder produces, the index of the vertex in the source mesh.
    pub source_vertex: Vec<u32>,
}

/// Encodes a base mesh and the vertex splits that refine it.
///
/// # Errors
/// [`StreamError`] if the steps are no batches, or the callback cancels.
pub(crate) fn encode_splits(
    refinable: &RefinableMesh,
    batches: &[u32],
    plan: &StreamPlan<'_>,
    progress: &mut ProgressFn<'_>,
) -> Result<SplitChunks, StreamError> {
    check_batches(batches, refinable.sequence.step_count())?;
    let StreamPlan { options, layout: StreamLayout { grid, forms, is_exact }, totals } = plan;
    let points = points_of(refinable, grid, forms);
    let parameters = StreamParameters {
        has_general: false,
        effort: options.effort,
        grid: *grid,
        is_exact: *is_exact,
        max_patch: 0,
        position_count: totals.position_count,
        base: BaseLimits { position_count: 0, triangle_count: 0, extra_wedges: u32::MAX },
        vertex_count: totals.vertex_count,
        group_count: refinable.mesh.groups.len() as u32,
        layers: forms.clone(),
    };
    let mut descent = Descent::new(refinable, batches, progress)?;
    let first = first_batch(&parameters, &descent);
    let shortened = (first > 0).then(|| refinable.clone().without_levels_below(batches[first] as usize));
    let refinable = shortened.as_ref().unwrap_or(refinable);
    let batches: Vec<u32> = batches[first..].iter().map(|n| n - batches[first]).collect();
    let batches = batches.as_slice();
    if first > 0 {
        descent = Descent::new(refinable, batches, progress)?;
    }
    let chunks = encode_chunks(refinable, (&descent, batches), (&points, &parameters), progress)?;
    let source_vertex = source_vertices(refinable, &chunks);
    let header = header_of(refinable, batches, &chunks, options, &parameters);
    Ok(SplitChunks { header, chunks, source_vertex })
}

/// Triangles and their layers, with vertices in the order of the stream; without other layers.
fn in_stream_order(mesh: &IndexedMesh, source_vertex: &[u32]) -> IndexedMesh {
    if mesh.triangle_layers.is_empty() {
        return IndexedMesh::default();
    }
    let mut vertex_of = vec![u32::MAX; source_vertex.len()];
    (0..).zip(source_vertex).for_each(|(vertex, &source)| vertex_of[source as usize] = vertex);
    IndexedMesh {
        triangles: mesh.triangles.iter().map(|t| t.map(|v| vertex_of[v as usize])).collect(),
        triangle_layers: mesh.triangle_layers.clone(),
        groups: mesh.groups.clone(),
        ..IndexedMesh::default()
    }
}

/// Returns the batch to begin with. If there are too many batches that split only a few vertices, the
/// earliest ones are merged into the base mesh.
fn first_batch(parameters: &StreamParameters, descent: &Descent) -> usize {
    let mut visits_left = parameters.most_visits();
    let mut first = descent.visits.len();
    while first > 0 {
        let Some(left) = visits_left.checked_sub(descent.visits[first - 1]) else { break };
        visits_left = left;
        first -= 1;
    }
    first
}

/// Bits of the grid that exact positions are predicted on.
const LOSSLESS_BITS: u32 = 16;

/// Builds the grid for a mesh.
fn grid_of(mesh: &IndexedMesh, precision: Precision) -> Result<PositionGrid, GridError> {
    let bounds = mesh.bounds().unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
    match precision {
        Precision::Bits(bits) => PositionGrid::from_bits(&bounds, bits),
        Precision::Tolerance(tolerance) => PositionGrid::from_tolerance(&bounds, tolerance),
        Precision::Lattice { step, offset } => PositionGrid::on_lattice(&bounds, step, offset),
        Precision::Lossless => PositionGrid::from_bits(&bounds, LOSSLESS_BITS),
    }
}

/// Quantizes the positions and layers of a mesh.
fn points_of(refinable: &RefinableMesh, grid: &PositionGrid, forms: &[LayerForm]) -> VertexData {
    let positions = refinable.sequence.positions();
    let exact: Vec<[f32; 3]> = (0..positions.position_count() as u32)
        .map(|p| refinable.mesh.positions[positions.first_vertex(p) as usize])
        .collect();
    let layers = refinable.mesh.layers.iter().zip(forms);
    let layers =
        layers.map(|(layer, form)| LayerValues::from_integers(form.integers(layer), form.integer_count()));
    VertexData { coords: exact.iter().map(|&p| grid.quantize(p)).collect(), exact, layers: layers.collect() }
}

/// Assembles the header of the stream.
fn header_of(
    refinable: &RefinableMesh,
    batches: &[u32],
    chunks: &Chunks,
    options: &StreamOptions,
    parameters: &StreamParameters,
) -> StreamHeader {
    let (mesh, sequence) = (&refinable.mesh, &refinable.sequence);
    let group = |g: &striata::mesh::TriangleGroup| GroupName { name: g.name.clone(), material: g.material };
    let mut before = 0;
    let entries = chunks.chunks.iter().map(|chunk| {
        // Steps are reordered within a batch, so the error at its beginning applies to all of it.
        let batch = batches.partition_point(|&first| first <= before).saturating_sub(1);
        let error = batches.get(batch).map_or(0.0, |&first| sequence.error_at(first as usize));
        before = chunk.split_count;
        ChunkEntry { bytes: chunk.bytes.len() as u32, split_count: chunk.split_count, error }
    });
    StreamHeader {
        length: 0,
        effort: options.effort,
        is_exact: options.precision == Precision::Lossless,
        position_count: sequence.positions().position_count() as u32,
        vertex_count: mesh.vertex_count() as u32,
        triangle_count: mesh.triangle_count() as u32,
        step_count: sequence.step_count() as u32,
        max_patch: chunks.max_patch,
        has_fragments: false,
        has_general: chunks.has_general,
        grid: parameters.grid,
        origin: refinable.mesh.origin,
        layers: parameters.layers.clone(),
        groups: mesh.groups.iter().map(group).collect(),
        appearance: mesh.appearance.clone(),
        metadata: options.metadata.clone(),
        chunks: entries.collect(),
        triangle_data: None,
    }
}

/// Returns the source vertex of each vertex of the stream.
fn source_vertices(refinable: &RefinableMesh, chunks: &Chunks) -> Vec<u32> {
    if !chunks.source_vertex.is_empty() {
        return chunks.source_vertex.clone();
    }
    let positions = refinable.sequence.positions();
    let base = refinable.sequence.base_position_count() as u32;
    let steps = chunks.order.iter().map(|&step| base + step);
    chunks.base_positions.iter().copied().chain(steps).flat_map(|p| positions.wedges(p)).collect()
}
