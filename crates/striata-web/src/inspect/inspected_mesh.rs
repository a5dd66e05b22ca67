//! A file as one mesh, whose models a page looks at.

use striata::mesh::{IndexedMesh, Steps};
use striata::model::Geomorph;
use striata::simplify::build_sequence_with_progress;
use striata::{ProgressFn, Target};
use striata_io::{Format, Scene};
use striata_scene::file::is_scene_file;
use wasm_bindgen::prelude::wasm_bindgen;

use super::instance::{InspectedTarget, ModelInstance, fans_of};
use super::models::{InspectedModels, Kind};
use super::surface::{InspectedLevel, Morph, NumberedTriangles};
use crate::encoder::scene_of;
use crate::progress::{Sink, reporter};
use crate::view::View;
use crate::{Failure, limits, normals, stored_file};

/// One mesh in refinement order, its models, and an instance of one of them.
#[wasm_bindgen]
#[derive(Debug)]
pub struct InspectedMesh {
    steps: Steps,
    models: InspectedModels,
    instance: Option<(Kind, ModelInstance)>,
    /// The surface that was shown last, and its split count.
    last: Option<(NumberedTriangles, usize)>,
}

#[wasm_bindgen]
impl InspectedMesh {
    /// Reads an uncompressed file of any format, whose name says the format if its contents do not. Scenes become one
    /// mesh; what has no levels is simplified.
    ///
    /// # Errors
    /// If the file is damaged or of an unknown format, or the mesh is too large for a page.
    pub fn read(bytes: &[u8], name: &str, sink: &Sink) -> Result<Self, Failure> {
        Self::open(bytes, name, &mut reporter(sink))
    }

    /// Positions of all vertices, three numbers each.
    pub fn positions(&self) -> Vec<f32> {
        self.mesh().positions.as_flattened().to_vec()
    }

    /// Normals of all vertices, three numbers each.
    pub fn normals(&self) -> Vec<f32> {
        let mesh = self.mesh();
        let first_vertices = self.steps.levels().positions().first_vertices();
        normals::of_vertices(&mesh.positions, &mesh.triangles, first_vertices).into_flattened()
    }

    /// For each vertex, the number of splits before the one that adds it; -1 for those of the base mesh.
    pub fn steps(&self) -> Vec<i32> {
        let levels = self.steps.levels();
        let step_of = |vertex| levels.step_of(vertex).map_or(-1, |step| step as i32);
        (0..self.mesh().vertex_count() as u32).map(step_of).collect()
    }

    /// Error of each level but the full mesh, the base mesh first.
    pub fn errors(&self) -> Vec<f32> {
        let levels = self.steps.levels();
        (0..levels.step_count()).map(|step| levels.error_at(step)).collect()
    }

    /// Number of triangles of the full mesh.
    #[wasm_bindgen(getter)]
    pub fn triangle_count(&self) -> usize {
        self.mesh().triangle_count()
    }

    /// Whether a model was in the file.
    ///
    /// # Errors
    /// If there is no such model.
    pub fn is_stored(&self, model: &str) -> Result<bool, Failure> {
        Ok(self.models.is_stored(Kind::parse(model)?))
    }

    /// Whether a model can be made of these steps.
    ///
    /// # Errors
    /// If there is no such model.
    pub fn is_available(&self, model: &str) -> Result<bool, Failure> {
        Ok(self.steps.collapses().is_some() || !Kind::parse(model)?.needs_collapses())
    }

    /// Shows a uniform level by detail, from 0 to 1.
    ///
    /// # Errors
    /// If the model cannot be made.
    pub fn show_detail(&mut self, model: &str, detail: f64, morphs: bool) -> Result<InspectedLevel, Failure> {
        self.show_target(model, Target::Detail(detail), morphs)
    }

    /// Shows the finest uniform level with at most this many triangles.
    ///
    /// # Errors
    /// If the model cannot be made.
    pub fn show_triangles(
        &mut self,
        model: &str,
        limit: usize,
        morphs: bool,
    ) -> Result<InspectedLevel, Failure> {
        self.show_target(model, Target::Triangles(limit), morphs)
    }

    /// Shows what a camera needs; models without views show a uniform level with as small an error.
    ///
    /// # Errors
    /// If the model cannot be made, or such a camera sees nothing.
    pub fn show_view(&mut self, model: &str, view: &View, morphs: bool) -> Result<InspectedLevel, Failure> {
        let limit = if view.triangle_limit == 0 { usize::MAX } else { view.triangle_limit as usize };
        let request = InspectedTarget::View(view.criterion()?, limit);
        self.show(Kind::parse(model)?, request, morphs)
    }
}

impl InspectedMesh {
    pub(crate) fn open(bytes: &[u8], name: &str, progress: &mut ProgressFn<'_>) -> Result<Self, Failure> {
        limits::check_file(bytes.len())?;
        let is_mesh_file = Format::detect(bytes, name) == Some(Format::Striata) && !is_scene_file(bytes);
        let (steps, models) = if is_mesh_file {
            let file = stored_file::open(bytes)?;
            let summary = file.summary();
            limits::check_counts(summary.vertex_count, summary.triangle_count)?;
            (file.steps()?, InspectedModels::stored(&file)?)
        } else {
            let scene: Scene = scene_of(bytes, name)?;
            limits::check_to_build(0, scene.triangle_count())?;
            let mesh = scene.flattened().map_err(Failure::unsupported)?;
            let options = Default::default();
            let built = build_sequence_with_progress(&mesh, &options, progress)?;
            (Steps::Collapses(built.refinable), InspectedModels::default())
        };
        Ok(Self { steps, models, instance: None, last: None })
    }

    fn mesh(&self) -> &IndexedMesh {
        self.steps.mesh()
    }

    fn show_target(&mut self, model: &str, target: Target, morphs: bool) -> Result<InspectedLevel, Failure> {
        let (splits, _) = target.resolve_in(self.steps.levels());
        self.show(Kind::parse(model)?, InspectedTarget::Splits(splits), morphs)
    }

    fn show(
        &mut self,
        kind: Kind,
        request: InspectedTarget,
        morphs: bool,
    ) -> Result<InspectedLevel, Failure> {
        if self.instance.as_ref().is_none_or(|(shown, _)| *shown != kind) {
            self.instance = Some((kind, ModelInstance::new(kind, &self.models, &self.steps)?));
            self.last = None;
        }
        let Some((_, instance)) = &mut self.instance else { return Err(Failure::unsupported("no model")) };
        let before = instance.fans().cloned();
        let mut level = instance.show(&self.models, &self.steps, request)?;
        if morphs
            && let (Some((surface, splits)), Steps::Collapses(refinable)) = (self.last.take(), &self.steps)
        {
            level.morph = match (before, instance.fans()) {
                (Some(from), Some(to)) if from != *to => {
                    let morph = Geomorph::between(&refinable.sequence, &from, to);
                    let (drawn, _) = fans_of(self.models.fans(&self.steps), morph.drawn());
                    Some(moving(&morph, drawn))
                }
                (None, None) if splits != level.split_count => {
                    let morph = Geomorph::uniform(&refinable.sequence, splits, level.split_count);
                    // The finer level is drawn: the one before, or this one.
                    let drawn = if splits > level.split_count { surface } else { level.surface.clone() };
                    Some(moving(&morph, drawn))
                }
                _ => None,
            };
        }
        self.last = Some((level.surface.clone(), level.split_count));
        Ok(level)
    }
}

fn moving<S>(morph: &Geomorph<S>, drawn: NumberedTriangles) -> Morph {
    let both = || morph.appearing().iter().chain(morph.vanishing());
    Morph {
        drawn,
        vertices: both().map(|moved| moved.vertex).collect(),
        targets: both().map(|moved| moved.target).collect(),
        appearing_count: morph.appearing().len(),
    }
}

#[cfg(test)]
mod tests {
    use striata::file::{FileModel, WriteOptions as FileOptions, to_striata};
    use striata::ignore_progress;
    use striata::mesh::{FragmentedMesh, canonical_triangles, shapes};
    use striata_io::{WriteOptions, to_bytes};

    use super::*;

    const ALL: [&str; 6] = ["list", "lodstrips", "live-strips", "mts", "fans", "patterns"];

    fn torus() -> InspectedMesh {
        let obj =
            to_bytes(Format::Obj, &shapes::torus(32, 16, 1.0, 0.4), &WriteOptions::default()).expect("OBJ");
        InspectedMesh::open(&obj, "torus.obj", &mut ignore_progress).expect("a mesh")
    }

    fn view(pixels: f32) -> View {
        let numbers = [3.0, 4.0, 9.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.4, 800.0, 600.0];
        View::new(&numbers, pixels, 0).expect("12 numbers")
    }

    #[test]
    fn every_model_draws_the_triangles_of_the_replay() {
        let mut mesh = torus();
        for model in ALL {
            assert!(mesh.is_available(model).expect(model) && !mesh.is_stored(model).expect(model));
            for detail in [1.0, 0.3, 0.0, 0.6, 0.61] {
                let level = mesh.show_detail(model, detail, false).expect(model);
                let expected = mesh.steps.level(level.split_count).triangles;
                let drawn = canonical_triangles(&level.surface.triangles);
                assert_eq!(drawn, canonical_triangles(&expected), "{model} at {detail}");
                assert_eq!(level.surface.numbers.len(), drawn.len());
                assert!(level.index_count >= drawn.len() && level.instance_bytes > 0, "{model} at {detail}");
                assert_eq!(
                    level.primitive_count == 0,
                    model == "list" || (model == "patterns" && detail == 0.0)
                );
                let again = mesh.show_detail(model, detail, true).expect(model);
                assert!(!again.has_morph() && again.changed_count == 0, "{model} at {detail}");
            }
        }
    }

    #[test]
    fn views_are_refined_where_the_model_can() {
        let mut mesh = torus();
        for model in ALL {
            let [fine, coarse] =
                [0.3, 30.0].map(|pixels| mesh.show_view(model, &view(pixels), false).expect(model));
            if matches!(model, "fans" | "patterns") {
                assert!(fine.surface.triangles.len() > coarse.surface.triangles.len(), "{model}");
            }
            let mut limited_view = view(0.01);
            limited_view.triangle_limit = 300;
            let limited = mesh.show_view(model, &limited_view, false).expect(model);
            assert!(limited.surface.triangles.len() <= 300, "{model}");
        }
    }

    #[test]
    fn vertices_move_between_levels() {
        let mut mesh = torus();
        for model in ["list", "lodstrips", "mts", "fans"] {
            mesh.show_detail(model, 0.2, true).expect(model);
            let finer = mesh.show_detail(model, 0.5, true).expect(model);
            let (added, morph) = (finer.split_count, finer.morph.expect("levels differ"));
            assert_eq!(morph.vertices.len(), morph.appearing_count, "{model}");
            assert_eq!(
                canonical_triangles(&morph.drawn.triangles),
                canonical_triangles(&finer.surface.triangles)
            );
            let coarser = mesh.show_detail(model, 0.2, true).expect(model);
            let back = coarser.morph.expect("levels differ");
            assert_eq!((back.appearing_count, back.vertices.len()), (0, morph.vertices.len()), "{model}");
            assert_eq!(back.drawn.triangles.len(), morph.drawn.triangles.len());
            assert!(coarser.split_count < added);
            assert_eq!(back.targets, morph.targets, "{model}: the way back ends at the same vertices");
        }
    }

    #[test]
    fn stored_models_and_removals_are_known() {
        let mut mesh = torus();
        let Steps::Collapses(refinable) = &mesh.steps else { panic!("collapses") };
        let strips = mesh.models.lod_strips(&mesh.steps).expect("strips");
        let models = [FileModel::LodStrips(strips)];
        let file = to_striata(refinable, &models, &FileOptions::default()).expect("a file");
        let again = InspectedMesh::open(&file, "a.striata", &mut ignore_progress).expect("a mesh");
        assert!(again.is_stored("lodstrips").expect("known") && !again.is_stored("mts").expect("known"));
        assert!(InspectedMesh::open(&file[..file.len() / 2], "a.striata", &mut ignore_progress).is_err());
        assert!(again.is_stored("meshlets").is_err());
        mesh.steps = Steps::Fragments(FragmentedMesh::from_collapses(refinable));
        mesh.models = InspectedModels::default();
        for model in ALL {
            let is_strips = matches!(model, "lodstrips" | "mts" | "live-strips");
            assert_eq!(mesh.is_available(model).expect("known"), !is_strips);
            assert_eq!(mesh.show_detail(model, 0.5, true).is_ok(), !is_strips, "{model}");
        }
    }
}
