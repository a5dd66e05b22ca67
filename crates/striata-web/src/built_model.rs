//! A completely loaded model with everything needed for its levels and views.

use striata::ProgressFn;
use striata::mesh::{Bounds, IndexedMesh, RefinableMesh};
use striata::model::{FanForm, FanFront, FanIndices, FanScene, Fans, LodModel};
use striata::simplify::{SequenceOptions, build_sequence_with_progress};
use striata::view::{ScreenError, Sphere};
#[cfg(feature = "files")]
use striata_io::{Source, read_bytes};

use crate::leveled::Leveled;
use crate::shown_level::{LevelRequest, ShownLevel};
use crate::vertices::Vertices;
use crate::view::View;
use crate::{Failure, coloring, limits, normals};

/// Kind of the level shown last, to emit its triangles again in another form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LastShown {
    Uniform(usize),
    View,
}

/// Mesh, collapse sequence, the table of fans, and one instance of it.
#[derive(Debug)]
pub(crate) struct BuiltModel {
    refinable: RefinableMesh,
    fans: Fans,
    sphere: Sphere,
    front: Option<FanFront<ScreenError>>,
    last: LastShown,
    indices: FanIndices,
}

impl BuiltModel {
    /// Builds the fans of a mesh.
    pub(crate) fn new(refinable: RefinableMesh) -> Self {
        let fans = Fans::build(&refinable);
        Self::from_parts(refinable, fans)
    }

    pub(crate) fn from_parts(refinable: RefinableMesh, fans: Fans) -> Self {
        let sphere = FanScene::new(&fans, &refinable.mesh.positions).sphere();
        let last = LastShown::Uniform(refinable.sequence.step_count());
        let indices = FanIndices::default();
        Self { refinable, fans, sphere, front: None, last, indices }
    }

    /// Reads an uncompressed mesh file and simplifies it.
    ///
    /// # Errors
    /// If the bytes are damaged, of an unknown format, or the mesh is too large for a page.
    #[cfg(feature = "files")]
    pub(crate) fn from_mesh_file(
        bytes: Vec<u8>,
        name: &str,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Failure> {
        let mesh = read_bytes(&bytes, &Source::new(name))?;
        drop(bytes);
        Self::simplify(mesh, progress)
    }

    /// Simplifies a mesh.
    ///
    /// # Errors
    /// If the mesh is inconsistent, empty or too large for a page.
    pub(crate) fn simplify(mesh: IndexedMesh, progress: &mut ProgressFn<'_>) -> Result<Self, Failure> {
        limits::check_to_build(mesh.vertex_count(), mesh.triangle_count())?;
        if mesh.triangles.is_empty() {
            return Err(Failure::unsupported("the file has no triangles")
                .with_hint("point clouds and curves cannot be simplified"));
        }
        let built = build_sequence_with_progress(&mesh, &SequenceOptions::default(), progress)?;
        drop(mesh);
        Ok(Self::new(built.refinable))
    }

    /// Emits the triangles of the level shown last.
    fn shown(&mut self) -> ShownLevel {
        self.emit(FanForm::Triangles);
        let sequence = &self.refinable.sequence;
        let (split_count, coarsest) = match (self.last, &self.front) {
            (LastShown::View, Some(front)) => {
                let instance = front.instance();
                let step_count = sequence.step_count();
                let coarsest = (0..step_count).find(|&step| !instance.is_refined(step as u32));
                (instance.split_count(), coarsest.unwrap_or(step_count))
            }
            (LastShown::Uniform(split_count), _) => (split_count, split_count),
            (LastShown::View, None) => (0, 0),
        };
        let group_counts = self.indices.group_ranges.iter().map(|range| range.len() as u32 / 3).collect();
        ShownLevel {
            triangles: self.indices.indices.as_chunks().0.to_vec(),
            group_counts,
            split_count,
            error: sequence.error_at(coarsest),
        }
    }

    fn emit(&mut self, form: FanForm) {
        match (self.last, &self.front) {
            (LastShown::View, Some(front)) => front.instance().emit_into(&self.fans, form, &mut self.indices),
            (LastShown::Uniform(split_count), _) => {
                let mut level = self.fans.new_state();
                self.fans.move_to(&mut level, split_count);
                self.fans.emit_level_into(&level, form, &mut self.indices);
            }
            (LastShown::View, None) => {}
        }
    }
}

impl Leveled for BuiltModel {
    fn is_complete(&self) -> bool {
        true
    }

    fn vertex_count(&self) -> usize {
        self.refinable.mesh.vertex_count()
    }

    fn triangle_count(&self) -> usize {
        self.refinable.mesh.triangle_count()
    }

    fn full_counts(&self) -> (usize, usize) {
        (self.vertex_count(), self.triangle_count())
    }

    fn step_count(&self) -> usize {
        self.refinable.sequence.step_count()
    }

    fn bounds(&self) -> Option<Bounds> {
        self.refinable.mesh.bounds()
    }

    fn smooth_normals(&self) -> Vec<[f32; 3]> {
        let RefinableMesh { mesh, sequence } = &self.refinable;
        normals::of_vertices(&mesh.positions, &mesh.triangles, sequence.positions().first_vertices())
    }

    fn split_count_for(&self, request: LevelRequest) -> usize {
        let sequence = &self.refinable.sequence;
        match request {
            LevelRequest::Detail(detail) => sequence.split_count_for_detail(detail),
            LevelRequest::Triangles(limit) => sequence.split_count_for_triangles(limit),
            LevelRequest::Error(limit) => sequence.split_count_for_error(limit),
        }
    }

    fn triangle_count_at(&self, split_count: usize) -> usize {
        self.refinable.sequence.triangle_count_at(split_count.min(self.step_count()))
    }

    fn error_at(&self, split_count: usize) -> f32 {
        self.refinable.sequence.error_at(split_count.min(self.step_count()))
    }

    fn vertices(&self, first: usize) -> Vertices {
        let mesh = &self.refinable.mesh;
        let first = first.min(mesh.vertex_count());
        Vertices::new(&mesh.positions[first..], &mesh.layers, first, mesh.appearance.color_space)
    }

    fn show(&mut self, request: LevelRequest) -> ShownLevel {
        let split_count = self.split_count_for(request);
        self.last = LastShown::Uniform(split_count);
        self.shown()
    }

    fn show_view(&mut self, view: &View) -> Result<(ShownLevel, bool), Failure> {
        let criterion = view.criterion()?.with_model_bounds(self.sphere);
        let scene = FanScene::new(&self.fans, &self.refinable.mesh.positions);
        let front = self.front.get_or_insert_with(|| FanFront::new(&scene));
        let update = match view.triangle_limit {
            0 => front.update(&scene, &criterion, usize::MAX),
            limit => front.update_to_budget(&scene, &criterion, limit as usize),
        };
        self.last = LastShown::View;
        Ok((self.shown(), update.is_complete))
    }

    fn group_count(&self) -> usize {
        self.fans.group_count()
    }

    fn color_fans(&mut self, shown: &mut ShownLevel) -> Vec<u32> {
        self.emit(FanForm::Fans);
        coloring::by_fans(shown, &self.indices)
    }
}
