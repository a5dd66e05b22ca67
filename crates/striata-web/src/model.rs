//! The class that a page has: a model that comes in, is built, and shows levels of itself.

use striata::mesh::Bounds;
use striata_io::Format;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::built::Built;
use crate::camera::View;
use crate::coloring;
use crate::progress::{self, Sink};
use crate::shown::{Shown, Wish};
use crate::streaming::Streaming;
use crate::vertices::Vertices;
use crate::{Failure, limits, normals, stored};

/// Where levels and views come from.
#[derive(Debug)]
enum Stage {
    /// A stream, which may still be arriving.
    Streaming(Box<Streaming>),
    /// A file that was read whole.
    Built(Box<Built>),
}

/// What the bytes of a file were.
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

/// A model. Streams are [pushed](Model::push) bytes and [revealed](Model::reveal); other files are read whole.
///
/// A `show_` method makes a level; `indices`, `group_counts` and the getters that begin with `shown` are about the last of them.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Model {
    stage: Stage,
    kind: Kind,
    shown: Shown,
    is_complete: bool,
}

#[wasm_bindgen]
impl Model {
    /// A model without any bytes yet, for a stream.
    #[wasm_bindgen(constructor)]
    #[expect(clippy::new_without_default, reason = "pages know constructors, no defaults")]
    pub fn new() -> Self {
        let stage = Stage::Streaming(Box::default());
        Self { stage, kind: Kind::Stream, shown: Shown::default(), is_complete: false }
    }

    /// Reads a whole file, unpacked, and builds its model; plain meshes are simplified, which takes a second or two for each 100,000
    /// triangles. What is shown is all of it.
    ///
    /// # Errors
    /// Where the bytes are damaged, of no kind that is known, or too much for a page.
    pub fn from_file(bytes: Vec<u8>, name: &str, sink: &Sink) -> Result<Self, Failure> {
        Self::read(bytes, name, &mut progress::to(sink))
    }

    /// Takes the next bytes of a stream and decodes what is whole.
    ///
    /// # Errors
    /// Where they are no sound stream, or the whole would not fit into a page. What came before stays.
    pub fn push(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let Stage::Streaming(streaming) = &mut self.stage else {
            return Err(Failure::unsupported("the model was read from a whole file: it takes no more bytes"));
        };
        let result = streaming.push(bytes);
        self.is_complete = streaming.decoder().is_complete();
        result
    }

    /// No more bytes will come: reads what an incomplete rest of them tells.
    ///
    /// # Errors
    /// Where there is no mesh without what is missing.
    pub fn finish(&mut self) -> Result<(), Failure> {
        match &mut self.stage {
            Stage::Streaming(streaming) => streaming.finish(),
            Stage::Built(_) => Ok(()),
        }
    }

    /// Prepares views of what has been decoded since the last call. [`reveal`](Self::reveal) does so by itself; calls between pushes spread
    /// the work.
    pub fn grow(&mut self) {
        if let Stage::Streaming(streaming) = &mut self.stage {
            streaming.grow();
        }
    }

    /// Lets levels and views show all that has been decoded. Counts, vertices and normals are of what has been revealed.
    pub fn reveal(&mut self) {
        if let Stage::Streaming(streaming) = &mut self.stage {
            streaming.reveal();
        }
    }

    /// `stream`, `striata` or `mesh`: what the bytes were.
    #[wasm_bindgen(getter)]
    pub fn kind(&self) -> String {
        self.kind.as_str().to_owned()
    }

    /// Whether there is something to show.
    #[wasm_bindgen(getter)]
    pub fn is_ready(&self) -> bool {
        self.vertex_count() > 0
    }

    /// Whether all of the mesh is there.
    #[wasm_bindgen(getter)]
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// Vertices that are there.
    #[wasm_bindgen(getter)]
    pub fn vertex_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.vertex_count(),
            Stage::Built(built) => built.refinable().mesh.vertex_count(),
        }
    }

    /// Triangles of the finest level that is there.
    #[wasm_bindgen(getter)]
    pub fn triangle_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.triangle_count(),
            Stage::Built(built) => built.refinable().mesh.triangle_count(),
        }
    }

    /// Vertices that there will be; 0 as long as nobody has told.
    #[wasm_bindgen(getter)]
    pub fn full_vertex_count(&self) -> usize {
        self.told(|facts| facts.vertex_count, self.vertex_count())
    }

    /// Triangles that there will be; 0 as long as nobody has told.
    #[wasm_bindgen(getter)]
    pub fn full_triangle_count(&self) -> usize {
        self.told(|facts| facts.triangle_count, self.triangle_count())
    }

    /// Vertex splits from the base to the full mesh.
    #[wasm_bindgen(getter)]
    pub fn step_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.decoder().step_count().unwrap_or(0),
            Stage::Built(built) => built.refinable().sequence.step_count(),
        }
    }

    /// Bytes of the whole stream; 0 as long as nobody has told.
    #[wasm_bindgen(getter)]
    pub fn stream_bytes(&self) -> f64 {
        self.told(|facts| facts.stream_bytes as usize, 0) as f64
    }

    /// Groups of triangles, at least one.
    #[wasm_bindgen(getter)]
    pub fn group_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.group_count(),
            Stage::Built(built) => built.group_count(),
        }
    }

    /// The smallest and the largest coordinates that are there; empty where nothing is.
    pub fn bounds(&self) -> Vec<f32> {
        self.box_bounds().map_or(Vec::new(), |bounds| [bounds.min, bounds.max].as_flattened().to_vec())
    }

    /// Diagonal of these bounds, mesh units.
    #[wasm_bindgen(getter)]
    pub fn diagonal(&self) -> f64 {
        self.box_bounds().map_or(0.0, |bounds| bounds.diagonal())
    }

    /// Vertices from one on.
    pub fn vertices(&self, first: usize) -> Vertices {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.vertices(first),
            Stage::Built(built) => built.vertices(first),
        }
    }

    /// Normals of all vertices that are there, made from the finest level of what has come.
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

    /// Shows a level by its detail, 0 to 1 of the full mesh.
    pub fn show_detail(&mut self, detail: f64) {
        self.show(Wish::Detail(detail));
    }

    /// Shows the finest level of no more triangles.
    pub fn show_triangles(&mut self, most: usize) {
        self.show(Wish::Triangles(most));
    }

    /// Shows the coarsest level that is no farther off, mesh units.
    pub fn show_error(&mut self, most: f64) {
        self.show(Wish::Error(most));
    }

    /// Shows what a view asks for, of what has arrived; false if asking once more would show more of it.
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

    /// Puts the triangles that are shown into the order of strips made of them, and tells the strip of each.
    ///
    /// # Errors
    /// Where no strips can be made.
    pub fn color_strips(&mut self) -> Result<Vec<u32>, Failure> {
        let vertex_count = self.vertex_count();
        coloring::by_strips(&mut self.shown, vertex_count)
    }

    /// Returns the fan of each triangle that is shown, whose order may change. For a stream that is the vertex that the triangle
    /// turns around.
    pub fn color_fans(&mut self) -> Vec<u32> {
        match &mut self.stage {
            Stage::Streaming(_) => coloring::by_pivots(&self.shown),
            Stage::Built(built) => built.color_fans(&mut self.shown),
        }
    }

    /// Corners of the triangles that are shown, group after group.
    pub fn indices(&self) -> Vec<u32> {
        self.shown.triangles.as_flattened().to_vec()
    }

    /// Triangles of each group that are shown.
    pub fn group_counts(&self) -> Vec<u32> {
        self.shown.group_counts.clone()
    }

    /// Vertex splits that are shown.
    #[wasm_bindgen(getter)]
    pub fn shown_split_count(&self) -> usize {
        self.shown.split_count
    }

    /// How far what is shown is from the full mesh, where it is farthest, mesh units.
    #[wasm_bindgen(getter)]
    pub fn shown_error(&self) -> f32 {
        self.shown.error
    }
}

impl Model {
    /// As [`from_file`](Self::from_file), with a callback.
    ///
    /// # Errors
    /// As that.
    pub fn read(bytes: Vec<u8>, name: &str, progress: &mut striata::ProgressFn<'_>) -> Result<Self, Failure> {
        limits::check_file(bytes.len())?;
        let (stage, kind) = match Format::detect(&bytes, name) {
            Some(Format::Stream) => (whole_stream(&bytes)?, Kind::Stream),
            Some(Format::Striata) => {
                let file = striata_stream::open_truncated(&bytes)?;
                limits::check_counts(file.summary().vertex_count, file.summary().triangle_count)?;
                let stage = match file.stream() {
                    Some(stream) => whole_stream(stream?)?,
                    None => Stage::Built(Box::new(stored::read(&file)?)),
                };
                (stage, Kind::Striata)
            }
            _ => (Stage::Built(Box::new(Built::from_mesh_file(bytes, name, progress)?)), Kind::Mesh),
        };
        let mut model = Self { stage, kind, shown: Shown::default(), is_complete: true };
        model.show(Wish::Detail(1.0));
        Ok(model)
    }

    fn show(&mut self, wish: Wish) {
        self.shown = match &mut self.stage {
            Stage::Streaming(streaming) => streaming.show(wish),
            Stage::Built(built) => built.show(wish),
        };
    }

    fn box_bounds(&self) -> Option<Bounds> {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.bounds(),
            Stage::Built(built) => built.box_bounds(),
        }
    }

    /// A number of the stream's head, or that of a model that is built.
    fn told(&self, number: impl Fn(&striata_stream::StreamInfo) -> usize, built: usize) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.facts().map_or(0, number),
            Stage::Built(_) => built,
        }
    }
}

/// Decodes a stream that is there as a whole.
fn whole_stream(bytes: &[u8]) -> Result<Stage, Failure> {
    let mut streaming = Streaming::default();
    streaming.push(bytes)?;
    if !streaming.decoder().is_complete() {
        return Err(Failure::corrupt("the stream ends before the mesh does"));
    }
    streaming.reveal();
    Ok(Stage::Streaming(Box::new(streaming)))
}
