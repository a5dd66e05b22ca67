//! The writer's front: options, the stream's bytes, and what they were spent on.

use striata::file::EncodeError;
use striata::mesh::{Bounds, IndexedMesh, MeshError, RefinableMesh};

use crate::base::coder::BaseLimits;
use crate::format::form::{Effort, StreamVersion};
use crate::format::grid::{GridError, PositionGrid};
use crate::format::head::{GroupName, Head, MOST_NUMBERS, Row};
use crate::layers::form::LayerForm;
use crate::layers::hood::LayerValues;
use crate::layers::options::{LayerBitsError, LayerOptions};
use crate::refine::terms::Terms;
use crate::writer::chunks::{Chunks, check_batches, encode_chunks};
use crate::writer::defect::BatchDefect;
use crate::writer::descent::Descent;
use crate::writer::truth::Points;

/// How exactly positions are kept.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Precision {
    /// On a cubic grid of so many bits (1 to 24) along the longest side of the bounds.
    Bits(u32),
    /// On a cubic grid on which no vertex moves farther, mesh units.
    Tolerance(f64),
    /// The very floats of the mesh; attribute layers too.
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
    /// How exactly positions are kept; default 14 bits.
    pub precision: Precision,
    /// How hard the coder tries; default [`Effort::Default`].
    pub effort: Effort,
    /// How exactly attribute layers are kept.
    pub layers: LayerOptions,
    /// What the bits mean; default [`StreamVersion::Two`].
    pub version: StreamVersion,
    /// Texts about the stream, key and value; default none.
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

    /// Sets [`Self::version`].
    pub fn with_version(self, version: StreamVersion) -> Self {
        Self { version, ..self }
    }

    /// Sets [`Self::layers`].
    pub fn with_layers(self, layers: LayerOptions) -> Self {
        Self { layers, ..self }
    }

    /// From one point of the grid to the next, mesh units.
    ///
    /// # Errors
    /// [`GridError`] where there is no such grid.
    pub fn grid_step(&self, mesh: &IndexedMesh) -> Result<f64, GridError> {
        grid_of(mesh, self.precision).map(|grid| grid.step)
    }

    /// Adds to [`Self::metadata`].
    pub fn with_metadata(mut self, key: impl Into<String>, value: impl Into<String>) -> Self {
        self.metadata.push((key.into(), value.into()));
        self
    }
}

/// How many steps of the grid an edge's shape should weigh in the batches of a stream
/// ([`BatchOptions::shape_step`](striata::simplify::BatchOptions::shape_step)): regular leftovers are cheap to foretell.
pub const SHAPE_STEPS: f64 = 1.5;

/// What the bytes of a stream are spent on; the sum is all of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StreamSizes {
    /// Bits that say which vertices split and how.
    pub connectivity_bits: f64,
    /// Bits of coordinates.
    pub position_bits: f64,
    /// Bits of wedges, groups and attribute layers: the next three, and other layers.
    pub attribute_bits: f64,
    /// Bits that say which vertices corners show, and groups.
    pub wedge_bits: f64,
    /// Bits of normals.
    pub normal_bits: f64,
    /// Bits of texture coordinates.
    pub texcoord_bits: f64,
    /// Bits of the base mesh, of the head and of what is lost between chunks.
    pub other_bits: f64,
}

impl StreamSizes {
    fn of(byte_count: usize, chunks: &Chunks) -> Self {
        let [connectivity_bits, position_bits, wedge_bits, normal_bits, texcoord_bits, other_layers, _] =
            chunks.spent;
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

/// A stream, and the mesh in its order.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct EncodedStream {
    /// The stream.
    pub bytes: Vec<u8>,
    /// What its bytes are spent on.
    pub sizes: StreamSizes,
    /// For each vertex that a reader gets, the vertex of the mesh that was given.
    pub source_vertex: Vec<u32>,
}

/// Why a mesh does not become a stream.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StreamError {
    /// The mesh is unsound.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// There is no grid as asked for.
    #[error(transparent)]
    Grid(#[from] GridError),
    /// There is no such number of bits for a layer.
    #[error(transparent)]
    Layers(#[from] LayerBitsError),
    /// The sequence is not one of batches.
    #[error(transparent)]
    Batches(#[from] BatchDefect),
    /// Layers have too many numbers.
    #[error("a vertex has {number_count} numbers in all layers, but streams have room for {}", MOST_NUMBERS)]
    Numbers {
        /// Numbers that a stream would hold for each vertex.
        number_count: usize,
    },
    /// A text is too long.
    #[error(transparent)]
    Text(#[from] EncodeError),
}

/// Codes a mesh with its sequence, whose steps are in batches as [`build_batches`](striata::simplify::build_batches) makes
/// them: `batches` are the split counts at which batches begin, closed by the number of steps.
///
/// # Errors
/// [`StreamError`] where the mesh is unsound, there is no such grid, or the steps of a batch depend on each other.
pub fn encode_stream(
    refinable: &RefinableMesh,
    batches: &[u32],
    options: &StreamOptions,
) -> Result<EncodedStream, StreamError> {
    refinable.mesh.check()?;
    check_batches(batches, refinable.sequence.step_count())?;
    let is_exact = options.precision == Precision::Lossless;
    let grid = grid_of(&refinable.mesh, options.precision)?;
    let layer_options = LayerOptions { lossless: is_exact || options.layers.lossless, ..options.layers };
    layer_options.check()?;
    let forms: Vec<_> =
        refinable.mesh.layers.iter().map(|layer| LayerForm::of(layer, &layer_options)).collect();
    let number_count = forms.iter().map(LayerForm::integer_count).sum();
    if number_count > MOST_NUMBERS {
        return Err(StreamError::Numbers { number_count });
    }
    let points = points_of(refinable, &grid, &forms);
    let position_count = points.places.len() as u32;
    let terms = Terms {
        version: options.version,
        has_general: false,
        effort: options.effort,
        grid,
        is_exact,
        max_patch: 0,
        position_count,
        base: BaseLimits { position_count: 0, triangle_count: 0, wedges_beyond: u32::MAX },
        vertex_count: refinable.mesh.vertex_count() as u32,
        group_count: refinable.mesh.groups.len() as u32,
        layers: forms,
    };
    let mut descent = Descent::new(refinable, batches, terms.version)?;
    let first = first_batch(&terms, &descent);
    let shortened = (first > 0).then(|| refinable.clone().without_levels_below(batches[first] as usize));
    let refinable = shortened.as_ref().unwrap_or(refinable);
    let batches: Vec<u32> = batches[first..].iter().map(|n| n - batches[first]).collect();
    let batches = batches.as_slice();
    if first > 0 {
        descent = Descent::new(refinable, batches, terms.version)?;
    }
    let chunks = encode_chunks(refinable, (&descent, batches), (&points, &terms))?;
    let head = head_of(refinable, batches, &chunks, (options, &terms)).to_bytes()?;
    let mut bytes = head;
    chunks.chunks.iter().for_each(|chunk| bytes.extend_from_slice(&chunk.bytes));
    let sizes = StreamSizes::of(bytes.len(), &chunks);
    Ok(EncodedStream { bytes, sizes, source_vertex: source_vertices(refinable, &chunks) })
}

/// The batch to begin with: earlier ones go to the base where there are too many that bring next to nothing.
fn first_batch(terms: &Terms, descent: &Descent) -> usize {
    let mut visits_left = terms.most_visits();
    let mut first = descent.visits.len();
    while first > 0 {
        let Some(left) = visits_left.checked_sub(descent.visits[first - 1]) else { break };
        visits_left = left;
        first -= 1;
    }
    first
}

/// Bits of the grid that predicts exact positions.
const LOSSLESS_BITS: u32 = 16;

fn grid_of(mesh: &IndexedMesh, precision: Precision) -> Result<PositionGrid, GridError> {
    let bounds = mesh.bounds().unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
    match precision {
        Precision::Bits(bits) => PositionGrid::from_bits(&bounds, bits),
        Precision::Tolerance(tolerance) => PositionGrid::from_tolerance(&bounds, tolerance),
        Precision::Lossless => PositionGrid::from_bits(&bounds, LOSSLESS_BITS),
    }
}

fn points_of(refinable: &RefinableMesh, grid: &PositionGrid, forms: &[LayerForm]) -> Points {
    let positions = refinable.sequence.positions();
    let exact: Vec<[f32; 3]> = (0..positions.position_count() as u32)
        .map(|p| refinable.mesh.positions[positions.first_vertex(p) as usize])
        .collect();
    let layers = refinable.mesh.layers.iter().zip(forms);
    let layers =
        layers.map(|(layer, form)| LayerValues::from_integers(form.integers(layer), form.integer_count()));
    Points { places: exact.iter().map(|&p| grid.quantize(p)).collect(), exact, layers: layers.collect() }
}

fn head_of(
    refinable: &RefinableMesh,
    batches: &[u32],
    chunks: &Chunks,
    (options, terms): (&StreamOptions, &Terms),
) -> Head {
    let (mesh, sequence) = (&refinable.mesh, &refinable.sequence);
    let group = |g: &striata::mesh::TriangleGroup| GroupName { name: g.name.clone(), material: g.material };
    let mut before = 0;
    let rows = chunks.chunks.iter().map(|chunk| {
        // Within a batch steps change places, so the error of its beginning holds for all of it.
        let batch = batches.partition_point(|&first| first <= before).saturating_sub(1);
        let error = batches.get(batch).map_or(0.0, |&first| sequence.error_at(first as usize));
        before = chunk.split_count;
        let checksum = crc32fast::hash(&chunk.bytes);
        Row { bytes: chunk.bytes.len() as u32, split_count: chunk.split_count, error, checksum }
    });
    Head {
        length: 0,
        version: options.version,
        effort: options.effort,
        is_exact: options.precision == Precision::Lossless,
        position_count: sequence.positions().position_count() as u32,
        vertex_count: mesh.vertex_count() as u32,
        triangle_count: mesh.triangle_count() as u32,
        step_count: sequence.step_count() as u32,
        max_patch: chunks.max_patch,
        has_general: chunks.has_general,
        grid: terms.grid,
        layers: terms.layers.clone(),
        groups: mesh.groups.iter().map(group).collect(),
        appearance: mesh.appearance.clone(),
        metadata: options.metadata.clone(),
        rows: rows.collect(),
    }
}

fn source_vertices(refinable: &RefinableMesh, chunks: &Chunks) -> Vec<u32> {
    if !chunks.source_vertex.is_empty() {
        return chunks.source_vertex.clone();
    }
    let positions = refinable.sequence.positions();
    let base = refinable.sequence.base_position_count() as u32;
    let steps = chunks.order.iter().map(|&step| base + step);
    chunks.base_positions.iter().copied().chain(steps).flat_map(|p| positions.wedges(p)).collect()
}
