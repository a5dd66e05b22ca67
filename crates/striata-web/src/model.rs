//! The class that a page has: a model that comes in, is built, and shows levels of itself.

use striata::mesh::Bounds;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::built::{Built, Kind};
use crate::camera::View;
use crate::colouring;
use crate::progress::{self, Sink};
use crate::shown::{Shown, Wish};
use crate::streaming::Streaming;
use crate::vertices::Vertices;
use crate::{Failure, normals};

/// How far a model has come.
#[derive(Debug)]
enum Stage {
    Streaming(Box<Streaming>),
    Built(Box<Built>),
}

/// A model. Streams are pushed bytes and then built; other files come built.
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
            return Err(Failure::unsupported("the model is built already: it takes no more bytes"));
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

    /// Makes what views are taken from, of what has come. No more bytes can be pushed then.
    ///
    /// # Errors
    /// Where too little has come.
    pub fn build(&mut self) -> Result<(), Failure> {
        let Stage::Streaming(streaming) = &mut self.stage else { return Ok(()) };
        if streaming.decoder().positions().is_empty() {
            return Err(Failure::corrupt("what has come of the stream is no mesh yet"));
        }
        let built = std::mem::take(streaming.as_mut()).into_built()?;
        self.stage = Stage::Built(Box::new(built));
        Ok(())
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

    /// Whether views can be shown.
    #[wasm_bindgen(getter)]
    pub fn is_built(&self) -> bool {
        matches!(self.stage, Stage::Built(_))
    }

    /// Vertices that are there.
    #[wasm_bindgen(getter)]
    pub fn vertex_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.decoder().positions().len(),
            Stage::Built(built) => built.refinable().mesh.vertex_count(),
        }
    }

    /// Triangles of the finest level that is there.
    #[wasm_bindgen(getter)]
    pub fn triangle_count(&self) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.decoder().triangles().len(),
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
            Stage::Streaming(streaming) => {
                let decoder = streaming.decoder();
                normals::of_vertices(decoder.positions(), decoder.triangles(), decoder.first_vertices())
            }
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

    /// Shows what a view asks for; false where asking once more would show more of it.
    ///
    /// # Errors
    /// Where the model is not built, or the camera sees nothing.
    pub fn show_view(&mut self, view: &View) -> Result<bool, Failure> {
        let Stage::Built(built) = &mut self.stage else {
            return Err(Failure::unsupported("views can be shown once the model is built"));
        };
        let (shown, is_settled) = built.show_view(view)?;
        self.shown = shown;
        Ok(is_settled)
    }

    /// Puts the triangles that are shown into the order of strips made of them, and tells the strip of each.
    ///
    /// # Errors
    /// Where no strips can be made.
    pub fn color_strips(&mut self) -> Result<Vec<u32>, Failure> {
        let vertex_count = self.vertex_count();
        colouring::by_strips(&mut self.shown, vertex_count)
    }

    /// Puts the triangles that are shown into the order of fans, and tells the fan of each. Before the model is built: the
    /// vertex that they turn around.
    pub fn color_fans(&mut self) -> Vec<u32> {
        match &mut self.stage {
            Stage::Streaming(_) => colouring::by_pivots(&self.shown),
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
        let (mut built, kind) = Built::from_file(bytes, name, progress)?;
        let shown = built.show(Wish::Detail(1.0));
        Ok(Self { stage: Stage::Built(Box::new(built)), kind, shown, is_complete: true })
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
    fn told(
        &self,
        number: impl Fn(&striata::codec::progressive::StreamFacts) -> usize,
        built: usize,
    ) -> usize {
        match &self.stage {
            Stage::Streaming(streaming) => streaming.facts().map_or(0, number),
            Stage::Built(_) => built,
        }
    }
}
