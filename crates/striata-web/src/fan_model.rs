//! A mesh made by removals, whose levels are those of fans: its steps are no collapses.

use striata::Target;
use striata::mesh::{Bounds, FragmentedMesh, IndexedMesh, LevelTable};
use striata::model::{FanForm, FanFront, FanIndices, FanScene, Fans, LodModel};
use striata::view::{ScreenError, Sphere};

use crate::leveled::Leveled;
use crate::shown_level::ShownLevel;
use crate::vertices::Vertices;
use crate::view::View;
use crate::{Failure, coloring, normals};

/// Kind of the level shown last, to emit its triangles again in another form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LastShown {
    Uniform(usize),
    View,
}

/// Mesh, counts and errors of its levels, the table of fans, and one instance of it.
#[derive(Debug)]
pub(crate) struct FanModel {
    mesh: IndexedMesh,
    levels: LevelTable,
    fans: Fans,
    sphere: Sphere,
    front: Option<FanFront<ScreenError>>,
    last: LastShown,
    indices: FanIndices,
}

impl FanModel {
    /// Takes over a mesh and its fans.
    pub(crate) fn new(FragmentedMesh { mesh, fragments }: FragmentedMesh, fans: Fans) -> Self {
        let levels = fragments.levels().clone();
        let sphere = FanScene::new(&fans, &mesh.positions).sphere();
        let last = LastShown::Uniform(levels.step_count());
        let indices = FanIndices::default();
        Self { mesh, levels, fans, sphere, front: None, last, indices }
    }

    /// Emits the triangles of the level shown last.
    fn shown(&mut self) -> ShownLevel {
        self.emit(FanForm::Triangles);
        let (split_count, coarsest) = match (self.last, &self.front) {
            (LastShown::View, Some(front)) => {
                let instance = front.instance();
                let step_count = self.levels.step_count();
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
            error: self.levels.error_at(coarsest),
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

impl Leveled for FanModel {
    fn is_complete(&self) -> bool {
        true
    }

    fn vertex_count(&self) -> usize {
        self.mesh.vertex_count()
    }

    fn triangle_count(&self) -> usize {
        self.mesh.triangle_count()
    }

    fn full_counts(&self) -> (usize, usize) {
        (self.vertex_count(), self.triangle_count())
    }

    fn step_count(&self) -> usize {
        self.levels.step_count()
    }

    fn bounds(&self) -> Option<Bounds> {
        self.mesh.bounds()
    }

    fn is_georeferenced(&self) -> bool {
        !self.mesh.appearance.georeference.is_empty()
    }

    fn smooth_normals(&self) -> Vec<[f32; 3]> {
        let first_vertices = self.levels.positions().first_vertices();
        normals::of_vertices(&self.mesh.positions, &self.mesh.triangles, first_vertices)
    }

    fn split_count_for(&self, target: Target) -> usize {
        target.resolve_in(&self.levels).0
    }

    fn triangle_count_at(&self, split_count: usize) -> usize {
        self.levels.triangle_count_at(split_count.min(self.step_count()))
    }

    fn error_at(&self, split_count: usize) -> f32 {
        self.levels.error_at(split_count.min(self.step_count()))
    }

    fn vertices(&self, first: usize) -> Vertices {
        let mesh = &self.mesh;
        let first = first.min(mesh.vertex_count());
        Vertices::new(&mesh.positions[first..], &mesh.layers, first, mesh.appearance.color_space)
    }

    fn step_of(&self, vertex: u32) -> Option<usize> {
        self.levels.step_of(vertex).map(|step| step as usize)
    }

    fn show(&mut self, target: Target) -> ShownLevel {
        let split_count = self.split_count_for(target);
        self.last = LastShown::Uniform(split_count);
        self.shown()
    }

    fn show_view(&mut self, view: &View) -> Result<(ShownLevel, bool), Failure> {
        let criterion = view.criterion()?.with_model_bounds(self.sphere);
        let scene = FanScene::new(&self.fans, &self.mesh.positions);
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
