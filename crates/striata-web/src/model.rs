//! The main class for pages: a model that is loaded or streamed and shows its levels.

use striata::mesh::Bounds;
use striata_io::Format;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::built_model::BuiltModel;
use crate::coloring;
use crate::progress::{self, Sink};
use crate::shown_level::{LevelRequest, ShownLevel};
use crate::streamed_model::StreamedModel;
use crate::vertices::Vertices;
use crate::view::View;
use crate::{Failure, limits, normals, stored_model};

/// Source of levels and views.
#[derive(Debug)]
enum Stage {
    /// A stream, which may still be arriving.
    Streaming(Box<StreamedModel>),
    /// A file that was read whole.
    Built(Box<BuiltModel>),
}

/// Kind of input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Stream,
    Striata,
    Mesh,
}

impl Kind {
    pub(crate) fn as_str(self) -> &'static str {
        match self {
            Self::Stream => "stream",
            Self::Striata => "striata",
            Self::Mesh => "mesh",
        }
    }
}

/// A model. [Push](Model::push) the bytes of a stream and [reveal](Model::reveal) them; other files are
/// read as a whole.
///
/// The `show_` methods select a level; `indices`, `group_counts` and the `shown_` getters describe the
/// level selected last.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Model {
    stage: Stage,
    kind: Kind,
    shown: ShownLevel,
    is_complete: bool,
}

#[wasm_bindgen]
impl Model {
    /// Creates an empty model for a stream.
    #[wasm_bindgen(constructor)]
    #[expect(clippy::new_without_default, reason = "JavaScript has constructors but no defaults")]
    pub fn new() -> Self {
        let stage = Stage::Streaming(Box::default());
        Self { stage, kind: Kind::Stream, shown: ShownLevel::default(), is_complete: false }
    }

    /// Reads a whole uncompressed file and builds its model. Plain meshes are simplified, which takes a
    /// second or two per 100,000 triangles. Shows the full mesh.
    ///
    /// # Errors
    /// If the bytes are damaged, of an unknown format, or the model is too large for a page.
    pub fn from_file(bytes: Vec<u8>, name: &str, sink: &Sink) -> Result<Self, Failure> {
        Self::read(bytes, name, &mut progress::reporter(sink))
    }

    /// Appends bytes of a stream and decodes all complete chunks.
    ///
    /// # Errors
    /// If the bytes are not a valid stream, or the model is too large for a page. The part decoded before
    /// stays.
    pub fn push(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let Stage::Streaming(streaming) = &mut self.stage else {
            return Err(Failure::unsupported("cannot push bytes: the model was read from a file"));
        };
        let result = streaming.push(bytes);
        self.is_complete = streaming.decoder().is_complete();
        result
    }

    /// Ends the stream: decodes what an incomplete last chunk contains.
    ///
    /// # Errors
    /// If the base mesh is incomplete.
    pub fn finish(&mut self) -> Result<(), Failure> {
        match &mut self.stage {
            Stage::Streaming(streaming) => streaming.finish(),
            Stage::Built(_) => Ok(()),
        }
    }

    /// Prepares view-dependent refinement of what has been decoded since the last call.
    /// [`reveal`](Self::reveal) does this, too; calls between pushes spread the work.
    pub fn grow(&mut self) {
        if let Stage::Streaming(streaming) = &mut self.stage {
            streaming.grow();
        }
    }

    /// Makes everything decoded so far available. Counts, vertices and normals refer to what has been
    /// revealed.
    pub fn reveal(&mut self) {
        if let Stage::Streaming(streaming) = &mut self.stage {
            streaming.reveal();
        }
    }

    /// Kind of input: `stream`, `striata` or `mesh`.
    #[wasm_bindgen(getter)]
    pub fn kind(&self) -> String {
        self.kind.as_str().to_owned()
    }

    /// Whether there is something to show.
    #[wasm_bindgen(getter)]
    pub fn is_ready(&self) -> bool {
        self.vertex_count() > 0
    }

    /// Whether the whole mesh has been decoded.
    #[wasm_bindgen(getter)]
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// Number of available vertices.
    #[wasm_bindgen(getter)]
    pub fn vertex_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.vertex_count(),
            Stage::Built(built) => built.refinable().mesh.vertex_count(),
        }
    }

    /// Triangle count of the finest available level.
    #[wasm_bindgen(getter)]
    pub fn triangle_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.triangle_count(),
            Stage::Built(built) => built.refinable().mesh.triangle_count(),
        }
    }

    /// Total vertex count, or 0 while it is unknown.
    #[wasm_bindgen(getter)]
    pub fn full_vertex_count(&self) -> usize {
        self.fact(|facts| facts.vertex_count, self.vertex_count())
    }

    /// Total triangle count, or 0 while it is unknown.
    #[wasm_bindgen(getter)]
    pub fn full_triangle_count(&self) -> usize {
        self.fact(|facts| facts.triangle_count, self.triangle_count())
    }

    /// Number of vertex splits from the base mesh to the full mesh.
    #[wasm_bindgen(getter)]
    pub fn step_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.decoder().step_count().unwrap_or(0),
            Stage::Built(built) => built.refinable().sequence.step_count(),
        }
    }

    /// Size of the whole stream in bytes, or 0 while it is unknown.
    #[wasm_bindgen(getter)]
    pub fn stream_bytes(&self) -> f64 {
        self.fact(|facts| facts.stream_bytes as usize, 0) as f64
    }

    /// Number of triangle groups, at least one.
    #[wasm_bindgen(getter)]
    pub fn group_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.group_count(),
            Stage::Built(built) => built.group_count(),
        }
    }

    /// Minimum and maximum coordinates of the available vertices; empty if there are none.
    pub fn bounds(&self) -> Vec<f32> {
        self.box_bounds().map_or(Vec::new(), |bounds| [bounds.min, bounds.max].as_flattened().to_vec())
    }

    /// Diagonal of these bounds, mesh units.
    #[wasm_bindgen(getter)]
    pub fn diagonal(&self) -> f64 {
        self.box_bounds().map_or(0.0, |bounds| bounds.diagonal())
    }

    /// Returns the vertices starting at index `first`.
    pub fn vertices(&self, first: usize) -> Vertices {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.vertices(first),
            Stage::Built(built) => built.vertices(first),
        }
    }

    /// Computes normals of all available vertices from the finest available level.
    pub fn smooth_normals(&self) -> Vec<f32> {
        let normals = match &self.stage {
            Stage::Streaming(streaming) => streaming.smooth_normals(),
            Stage::Built(built) => {
                let (mesh, positions) = (&built.refinable().mesh, built.refinable().sequence.positions());
                normals::of_vertices(&mesh.positions, &mesh.triangles, positions.first_vertices())
            }
        };
        normals.into_flattened()
    }

    /// Shows a level by its detail, 0 (base mesh) to 1 (full mesh).
    pub fn show_detail(&mut self, detail: f64) {
        self.show(LevelRequest::Detail(detail));
    }

    /// Shows the finest level with at most this many triangles.
    pub fn show_triangles(&mut self, limit: usize) {
        self.show(LevelRequest::Triangles(limit));
    }

    /// Shows the coarsest level whose error is at most this, mesh units.
    pub fn show_error(&mut self, limit: f64) {
        self.show(LevelRequest::Error(limit));
    }

    /// Refines what has arrived for a view. Returns false if calling it again would refine further.
    ///
    /// # Errors
    /// If the camera sees nothing.
    pub fn show_view(&mut self, view: &View) -> Result<bool, Failure> {
        let (shown, is_settled) = match &mut self.stage {
            Stage::Streaming(streaming) => (streaming.show_view(view)?, true),
            Stage::Built(built) => built.show_view(view)?,
        };
        self.shown = shown;
        Ok(is_settled)
    }

    /// Stripifies the shown triangles, reorders them by strip, and returns the strip number of each.
    ///
    /// # Errors
    /// If the triangles cannot be stripified.
    pub fn color_strips(&mut self) -> Result<Vec<u32>, Failure> {
        let vertex_count = self.vertex_count();
        coloring::by_strips(&mut self.shown, vertex_count)
    }

    /// Returns the fan number of each shown triangle, whose order may change. For a stream this is the
    /// vertex that the triangle pivots around.
    pub fn color_fans(&mut self) -> Vec<u32> {
        match &mut self.stage {
            Stage::Streaming(_) => coloring::by_pivots(&self.shown),
            Stage::Built(built) => built.color_fans(&mut self.shown),
        }
    }

    /// Corners of the shown triangles, group by group.
    pub fn indices(&self) -> Vec<u32> {
        self.shown.triangles.as_flattened().to_vec()
    }

    /// Number of shown triangles in each group.
    pub fn group_counts(&self) -> Vec<u32> {
        self.shown.group_counts.clone()
    }

    /// Number of vertex splits of the shown level.
    #[wasm_bindgen(getter)]
    pub fn shown_split_count(&self) -> usize {
        self.shown.split_count
    }

    /// Largest distance of the shown level from the full mesh, mesh units.
    #[wasm_bindgen(getter)]
    pub fn shown_error(&self) -> f32 {
        self.shown.error
    }
}

impl Model {
    /// Reads a whole file like [`from_file`](Self::from_file), with a Rust callback.
    ///
    /// # Errors
    /// Fails like `from_file`.
    pub fn read(bytes: Vec<u8>, name: &str, progress: &mut striata::ProgressFn<'_>) -> Result<Self, Failure> {
        limits::check_file(bytes.len())?;
        let (stage, kind) = match Format::detect(&bytes, name) {
            Some(Format::Stream) => (whole_stream(&bytes)?, Kind::Stream),
            Some(Format::Striata) => {
                let file = striata_stream::open_truncated(&bytes)?;
                limits::check_counts(file.summary().vertex_count, file.summary().triangle_count)?;
                let stage = match file.stream() {
                    Some(stream) => whole_stream(stream?)?,
                    None => Stage::Built(Box::new(stored_model::read(&file)?)),
                };
                (stage, Kind::Striata)
            }
            _ => (Stage::Built(Box::new(BuiltModel::from_mesh_file(bytes, name, progress)?)), Kind::Mesh),
        };
        let mut model = Self { stage, kind, shown: ShownLevel::default(), is_complete: true };
        model.show(LevelRequest::Detail(1.0));
        Ok(model)
    }

    fn show(&mut self, request: LevelRequest) {
        self.shown = match &mut self.stage {
            Stage::Streaming(streaming) => streaming.show(request),
            Stage::Built(built) => built.show(request),
        };
    }

    fn box_bounds(&self) -> Option<Bounds> {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.bounds(),
            Stage::Built(built) => built.box_bounds(),
        }
    }

    /// A count from the stream's header (0 until it has arrived), or that of a built model.
    fn fact(&self, number: impl Fn(&striata_stream::StreamInfo) -> usize, built: usize) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.facts().map_or(0, number),
            Stage::Built(_) => built,
        }
    }
}

/// Decodes a complete stream.
fn whole_stream(bytes: &[u8]) -> Result<Stage, Failure> {
    let mut streaming = StreamedModel::default();
    streaming.push(bytes)?;
    if !streaming.decoder().is_complete() {
        return Err(Failure::corrupt("the stream is incomplete"));
    }
    streaming.reveal();
    Ok(Stage::Streaming(Box::new(streaming)))
}
