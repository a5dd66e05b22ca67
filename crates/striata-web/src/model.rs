//! The main class for pages: a model that is loaded or streamed and shows its levels.

use std::fmt;

use striata::Target;
#[cfg(feature = "files")]
use striata::mesh::{FragmentedMesh, RefinableMesh, Steps};
use striata::mesh::{IndexedMesh, PositionEdges};
#[cfg(feature = "files")]
use striata::model::Fans;
use wasm_bindgen::prelude::wasm_bindgen;

#[cfg(feature = "files")]
use crate::fan_model::FanModel;
use crate::leveled::Leveled;
use crate::prefix_model::PrefixModel;
use crate::shown_level::ShownLevel;
#[cfg(feature = "files")]
use crate::step_order::StepOrder;
#[cfg(feature = "stream")]
use crate::streamed_model::StreamedModel;
use crate::vertices::Vertices;
use crate::view::View;
use crate::{Failure, coloring};

/// Most triangles of a mesh that is examined for whether the backs of its triangles can be seen.
const MAX_EXAMINED_TRIANGLES: usize = 2_000_000;

/// Kind of input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InputKind {
    #[cfg(feature = "stream")]
    Stream,
    #[cfg(feature = "files")]
    Striata,
    #[cfg(feature = "stream")]
    Mesh,
}

impl InputKind {
    pub(crate) fn as_str(self) -> &'static str {
        match self {
            #[cfg(feature = "stream")]
            Self::Stream => "stream",
            #[cfg(feature = "files")]
            Self::Striata => "striata",
            #[cfg(feature = "stream")]
            Self::Mesh => "mesh",
        }
    }
}

/// A model. [Push](Model::push) the bytes of a stream and [reveal](Model::reveal) them; models of files are
/// complete.
///
/// The `show_` methods select a level; `indices`, `group_counts` and the `shown_` getters describe the
/// level selected last.
#[wasm_bindgen]
pub struct Model {
    levels: Box<dyn Leveled>,
    kind: InputKind,
    shown: ShownLevel,
}

#[cfg(feature = "stream")]
#[wasm_bindgen]
impl Model {
    /// Creates an empty model for a stream.
    #[wasm_bindgen(constructor)]
    #[expect(clippy::new_without_default, reason = "JavaScript has constructors but no defaults")]
    pub fn new() -> Self {
        Self::of_stream(StreamedModel::default())
    }
}

#[wasm_bindgen]
impl Model {
    /// Appends bytes of a stream and decodes all complete chunks.
    ///
    /// # Errors
    /// If the bytes are not a valid stream, or the model is too large for a page. The part decoded before
    /// stays.
    pub fn push(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        self.levels.push(bytes)
    }

    /// Ends the stream: decodes what an incomplete last chunk contains.
    ///
    /// # Errors
    /// If the base mesh is incomplete.
    pub fn finish(&mut self) -> Result<(), Failure> {
        self.levels.finish()
    }

    /// Prepares view-dependent refinement of what has been decoded since the last call.
    /// [`reveal`](Self::reveal) does this, too; calls between pushes spread the work.
    pub fn grow(&mut self) {
        self.levels.grow();
    }

    /// Makes everything decoded so far available. Counts, vertices and normals refer to what has been
    /// revealed.
    pub fn reveal(&mut self) {
        self.levels.reveal();
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
        self.levels.is_complete()
    }

    /// Number of available vertices.
    #[wasm_bindgen(getter)]
    pub fn vertex_count(&self) -> usize {
        self.levels.vertex_count()
    }

    /// Triangle count of the finest available level.
    #[wasm_bindgen(getter)]
    pub fn triangle_count(&self) -> usize {
        self.levels.triangle_count()
    }

    /// Total vertex count, or 0 while it is unknown.
    #[wasm_bindgen(getter)]
    pub fn full_vertex_count(&self) -> usize {
        self.levels.full_counts().0
    }

    /// Total triangle count, or 0 while it is unknown.
    #[wasm_bindgen(getter)]
    pub fn full_triangle_count(&self) -> usize {
        self.levels.full_counts().1
    }

    /// Number of vertex splits from the base mesh to the full mesh.
    #[wasm_bindgen(getter)]
    pub fn step_count(&self) -> usize {
        self.levels.step_count()
    }

    /// Size of the whole stream in bytes, or 0 while it is unknown.
    #[wasm_bindgen(getter)]
    pub fn stream_bytes(&self) -> f64 {
        self.levels.stream_bytes() as f64
    }

    /// Number of triangle groups, at least one.
    #[wasm_bindgen(getter)]
    pub fn group_count(&self) -> usize {
        self.levels.group_count()
    }

    /// Minimum and maximum coordinates of the available vertices; empty if there are none.
    pub fn bounds(&self) -> Vec<f32> {
        self.levels.bounds().map_or(Vec::new(), |bounds| [bounds.min, bounds.max].as_flattened().to_vec())
    }

    /// Whether z is up: the mesh is a terrain with a georeference, or as flat along z as one.
    #[wasm_bindgen(getter)]
    pub fn is_z_up(&self) -> bool {
        self.levels.is_georeferenced() || self.levels.bounds().is_some_and(|bounds| bounds.lies_flat())
    }

    /// Diagonal of these bounds, mesh units.
    #[wasm_bindgen(getter)]
    pub fn diagonal(&self) -> f64 {
        self.levels.bounds().map_or(0.0, |bounds| bounds.diagonal())
    }

    /// Returns the vertices starting at index `first`.
    pub fn vertices(&self, first: usize) -> Vertices {
        self.levels.vertices(first)
    }

    /// Computes normals of all available vertices from the finest available level.
    pub fn smooth_normals(&self) -> Vec<f32> {
        self.levels.smooth_normals().into_flattened()
    }

    /// Shows a level by its detail, 0 (base mesh) to 1 (full mesh).
    pub fn show_detail(&mut self, detail: f64) {
        self.shown = self.levels.show(Target::Detail(detail));
    }

    /// Shows the finest level with at most this many triangles.
    pub fn show_triangles(&mut self, limit: usize) {
        self.shown = self.levels.show(Target::Triangles(limit));
    }

    /// Shows the coarsest level whose error is at most this, mesh units.
    pub fn show_error(&mut self, limit: f64) {
        self.shown = self.levels.show(Target::Error(limit));
    }

    /// Number of vertex splits of the coarsest level whose error is at most this, mesh units.
    pub fn split_count_for_error(&self, limit: f64) -> usize {
        self.levels.split_count_for(Target::Error(limit))
    }

    /// Number of triangles of an available level.
    pub fn triangle_count_at(&self, split_count: usize) -> usize {
        self.levels.triangle_count_at(split_count)
    }

    /// Number of splits before the one that adds a vertex; -1 if it is in the base mesh.
    pub fn step_of(&self, vertex: u32) -> i32 {
        self.levels.step_of(vertex).and_then(|step| i32::try_from(step).ok()).unwrap_or(-1)
    }

    /// Error of a level, mesh units.
    pub fn error_at(&self, split_count: usize) -> f32 {
        self.levels.error_at(split_count)
    }

    /// Refines what has arrived for a view. Returns false if calling it again would refine further.
    ///
    /// # Errors
    /// If the camera sees nothing.
    pub fn show_view(&mut self, view: &View) -> Result<bool, Failure> {
        let (shown, is_settled) = self.levels.show_view(view)?;
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
        self.levels.color_fans(&mut self.shown)
    }

    /// Whether the triangles of the full mesh enclose bodies and face outward, so that their backs cannot be seen.
    /// Takes about half a second per million triangles; larger meshes than two million are not examined.
    pub fn is_solid(&mut self) -> bool {
        if self.triangle_count() > MAX_EXAMINED_TRIANGLES {
            return false;
        }
        let positions = self.levels.vertices(0).take_positions().as_chunks().0.to_vec();
        let mesh = IndexedMesh::new(positions, self.levels.show(Target::Detail(1.0)).triangles);
        PositionEdges::of(&mesh).is_ok_and(|edges| edges.is_solid())
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

impl fmt::Debug for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Model").field("kind", &self.kind).finish_non_exhaustive()
    }
}

#[cfg(feature = "stream")]
impl Model {
    /// A model that is decoded from a stream.
    pub(crate) fn of_stream(streamed: StreamedModel) -> Self {
        Self { levels: Box::new(streamed), kind: InputKind::Stream, shown: ShownLevel::default() }
    }

    /// A model of a mesh that was simplified by another module. Shows the full mesh.
    pub(crate) fn of_prefixes(prefixes: PrefixModel) -> Self {
        let mut model =
            Self { levels: Box::new(prefixes), kind: InputKind::Mesh, shown: ShownLevel::default() };
        model.show_detail(1.0);
        model
    }
}

#[cfg(feature = "files")]
impl Model {
    /// A model that was read from a file. Shows the base mesh.
    pub(crate) fn of_steps(steps: Steps, fans: impl FnOnce(&FragmentedMesh) -> Fans) -> Self {
        let of_fans = |fragmented| {
            let fans = fans(&fragmented);
            Box::new(FanModel::new(fragmented, fans)) as Box<dyn Leveled>
        };
        let levels = match steps {
            Steps::Collapses(refinable) => match StepOrder::of(&refinable) {
                Some(order) => Box::new(PrefixModel::of_refinable(refinable, order)),
                None => of_fans(FragmentedMesh::from_collapses(&refinable)),
            },
            Steps::Fragments(fragmented) => of_fans(fragmented),
        };
        Self::of_levels(levels)
    }

    /// Takes over the coarse levels of a mesh, the whole of which follows in another model.
    #[cfg(feature = "files")]
    pub(crate) fn of_first_levels(first: RefinableMesh, whole: &RefinableMesh) -> Option<Self> {
        let order = StepOrder::of(&first)?;
        Some(Self::of_levels(Box::new(PrefixModel::of_refinable(first, order).with_later_levels(whole))))
    }

    fn of_levels(levels: Box<dyn Leveled>) -> Self {
        let mut model = Self { levels, kind: InputKind::Striata, shown: ShownLevel::default() };
        model.show_detail(0.0);
        model
    }
}
