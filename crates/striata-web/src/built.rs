//! A model with everything that levels and views are taken from.

use striata::ProgressFn;
use striata::mesh::{Bounds, IndexedMesh, RefinableMesh};
use striata::model::{FanForm, FanFront, FanIndices, FanScene, Fans, LodModel};
use striata::simplify::{SequenceOptions, build_sequence_with_progress};
use striata::view::{ScreenError, Sphere};
use striata_io::{Source, read_bytes};

use crate::camera::View;
use crate::shown::{Shown, Wish};
use crate::vertices::Vertices;
use crate::{Failure, coloring, limits};

/// What is shown at the moment, to be shown in another form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Last {
    Uniform(usize),
    View,
}

/// Mesh, steps, the table of fans and one instance of it.
#[derive(Debug)]
pub(crate) struct Built {
    refinable: RefinableMesh,
    fans: Fans,
    sphere: Sphere,
    front: Option<FanFront<ScreenError>>,
    last: Last,
    indices: FanIndices,
}

impl Built {
    /// Builds the table of a mesh's fans.
    pub(crate) fn new(refinable: RefinableMesh) -> Self {
        let fans = Fans::build(&refinable);
        Self::of_parts(refinable, fans)
    }

    pub(crate) fn of_parts(refinable: RefinableMesh, fans: Fans) -> Self {
        let sphere = FanScene::new(&fans, &refinable).sphere();
        let last = Last::Uniform(refinable.sequence.step_count());
        let indices = FanIndices::default();
        Self { refinable, fans, sphere, front: None, last, indices }
    }

    /// Reads a whole mesh file, not packed, and simplifies it.
    ///
    /// # Errors
    /// If the bytes are damaged, of no known kind, or too much for a page.
    pub(crate) fn from_mesh_file(
        bytes: Vec<u8>,
        name: &str,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Failure> {
        let mesh = read_bytes(&bytes, &Source::new(name))?;
        drop(bytes);
        Self::simplified(mesh, progress)
    }

    fn simplified(mesh: IndexedMesh, progress: &mut ProgressFn<'_>) -> Result<Self, Failure> {
        limits::check_to_build(mesh.vertex_count(), mesh.triangle_count())?;
        if mesh.triangles.is_empty() {
            return Err(Failure::unsupported("the file has no triangles")
                .with_hint("point clouds and curves cannot be simplified"));
        }
        let built = build_sequence_with_progress(&mesh, &SequenceOptions::default(), progress)?;
        drop(mesh);
        Ok(Self::new(built.refinable))
    }

    pub(crate) fn refinable(&self) -> &RefinableMesh {
        &self.refinable
    }

    pub(crate) fn box_bounds(&self) -> Option<Bounds> {
        self.refinable.mesh.bounds()
    }

    pub(crate) fn group_count(&self) -> usize {
        self.fans.group_count()
    }

    pub(crate) fn vertices(&self, first: usize) -> Vertices {
        let mesh = &self.refinable.mesh;
        let first = first.min(mesh.vertex_count());
        Vertices::new(&mesh.positions[first..], &mesh.layers, first)
    }

    /// The level that a wish means.
    pub(crate) fn show(&mut self, wish: Wish) -> Shown {
        let sequence = &self.refinable.sequence;
        let split_count = match wish {
            Wish::Detail(detail) => sequence.split_count_for_detail(detail),
            Wish::Triangles(most) => sequence.split_count_for_triangles(most),
            Wish::Error(most) => sequence.split_count_for_error(most),
        };
        self.last = Last::Uniform(split_count);
        self.shown()
    }

    /// What a camera asks for, and whether that is all that it asks for.
    ///
    /// # Errors
    /// Where such a camera sees nothing.
    pub(crate) fn show_view(&mut self, view: &View) -> Result<(Shown, bool), Failure> {
        let criterion = view.criterion()?.with_model_bounds(self.sphere);
        let scene = FanScene::new(&self.fans, &self.refinable);
        let front = self.front.get_or_insert_with(|| FanFront::new(&scene));
        let update = match view.triangle_limit {
            0 => front.update(&scene, &criterion, usize::MAX),
            limit => front.update_to_budget(&scene, &criterion, limit as usize),
        };
        self.last = Last::View;
        Ok((self.shown(), update.is_settled))
    }

    /// The triangles of what was asked for last.
    fn shown(&mut self) -> Shown {
        self.emit(FanForm::Triangles);
        let sequence = &self.refinable.sequence;
        let (split_count, coarsest) = match (self.last, &self.front) {
            (Last::View, Some(front)) => {
                let instance = front.instance();
                let step_count = sequence.step_count();
                let coarsest = (0..step_count).find(|&step| !instance.is_refined(step as u32));
                (instance.split_count(), coarsest.unwrap_or(step_count))
            }
            (Last::Uniform(split_count), _) => (split_count, split_count),
            (Last::View, None) => (0, 0),
        };
        let group_counts = self.indices.group_ranges.iter().map(|range| range.len() as u32 / 3).collect();
        Shown {
            triangles: self.indices.indices.as_chunks().0.to_vec(),
            group_counts,
            split_count,
            error: sequence.error_at(coarsest),
        }
    }

    /// Puts the triangles of what was asked for last into the order of fans, and tells the fan of each.
    pub(crate) fn color_fans(&mut self, shown: &mut Shown) -> Vec<u32> {
        self.emit(FanForm::Fans);
        coloring::by_fans(shown, &self.indices)
    }

    fn emit(&mut self, form: FanForm) {
        match (self.last, &self.front) {
            (Last::View, Some(front)) => front.instance().emit_into(&self.fans, form, &mut self.indices),
            (Last::Uniform(split_count), _) => {
                let mut level = self.fans.new_state();
                self.fans.move_to(&mut level, split_count);
                self.fans.emit_level_into(&level, form, &mut self.indices);
            }
            (Last::View, None) => {}
        }
    }
}
