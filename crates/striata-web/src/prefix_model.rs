//! A simplified mesh whose levels are prefixes of its vertices and triangles: the whole, or its first levels.

use striata::Target;
use striata::mesh::{AttributeLayer, Bounds, ColorSpace, steps_for_detail};
#[cfg(feature = "files")]
use striata::mesh::{IndexedMesh, RefinableMesh};
use striata_stream::{GrowingHierarchy, HierarchyCut, PrefixMesh};

use crate::leveled::Leveled;
use crate::shown_level::{ShownLevel, by_group};
#[cfg(feature = "files")]
use crate::step_order::StepOrder;
use crate::vertices::Vertices;
use crate::view::View;
use crate::{Failure, coloring, normals};

/// Sizes of a mesh.
#[derive(Clone, Copy, Debug)]
struct Counts {
    vertices: usize,
    triangles: usize,
    steps: usize,
}

/// Arrays of the mesh, and the hierarchy for views.
#[derive(Debug, Default)]
pub(crate) struct PrefixModel {
    pub positions: Vec<[f32; 3]>,
    pub layers: Vec<AttributeLayer>,
    first_vertices: Vec<u32>,
    targets: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    added_counts: Vec<u8>,
    errors: Vec<f32>,
    groups: Vec<u32>,
    group_count: usize,
    color_space: ColorSpace,
    is_georeferenced: bool,
    /// Sizes of the whole mesh, if later levels are missing.
    whole: Option<Counts>,
    /// Made for the first view.
    hierarchy: Option<GrowingHierarchy>,
    cut: HierarchyCut,
}

#[cfg(feature = "stream")]
impl PrefixModel {
    /// Checks the arrays of vertices and steps.
    ///
    /// # Errors
    /// If they do not fit each other.
    pub(crate) fn new(
        positions: Vec<[f32; 3]>,
        first_vertices: Vec<u32>,
        targets: Vec<u32>,
        added_counts: Vec<u8>,
        errors: Vec<f32>,
    ) -> Result<Self, Failure> {
        let vertex_count = positions.len() as u32;
        let rises = first_vertices.first() == Some(&0) && first_vertices.is_sorted_by(|a, b| a < b);
        let base = first_vertices.len().checked_sub(1 + added_counts.len());
        let base_vertices = base.and_then(|base| first_vertices.get(base)).copied().unwrap_or(u32::MAX);
        let fits = rises
            && first_vertices.last() == Some(&vertex_count)
            && errors.len() == added_counts.len()
            && u32::try_from(targets.len())
                .is_ok_and(|count| base_vertices.checked_add(count) == Some(vertex_count))
            && (base_vertices..).zip(&targets).all(|(vertex, &target)| target < vertex);
        if !fits {
            return Err(Failure::corrupt("the arrays of the simplified mesh do not fit each other"));
        }
        // These are the arrays of a page, whose colors are light.
        let color_space = ColorSpace::Linear;
        Ok(Self { positions, first_vertices, targets, added_counts, errors, color_space, ..Self::default() })
    }

    /// Adds the triangles.
    ///
    /// # Errors
    /// If a corner is not a vertex, or the steps add another number of triangles.
    pub(crate) fn with_triangles(
        mut self,
        triangles: Vec<[u32; 3]>,
        groups: Vec<u32>,
        group_count: usize,
    ) -> Result<Self, Failure> {
        let added: usize = self.added_counts.iter().map(|&count| usize::from(count)).sum();
        let fits = groups.len() == triangles.len()
            && added <= triangles.len()
            && groups.iter().all(|&group| (group as usize) < group_count)
            && triangles.as_flattened().iter().all(|&corner| (corner as usize) < self.positions.len());
        if !fits {
            return Err(Failure::corrupt("the triangles of the simplified mesh do not fit its vertices"));
        }
        (self.triangles, self.groups, self.group_count) = (triangles, groups, group_count);
        Ok(self)
    }
}

impl PrefixModel {
    /// Takes over a mesh and its steps.
    #[cfg(feature = "files")]
    pub(crate) fn of_refinable(
        RefinableMesh { mesh, sequence }: RefinableMesh,
        StepOrder { triangles, groups, added_counts }: StepOrder,
    ) -> Self {
        let group_count = mesh.groups_or_whole().len();
        let color_space = mesh.appearance.color_space;
        let is_georeferenced = !mesh.appearance.georeference.is_empty();
        let IndexedMesh { positions, layers, .. } = mesh;
        Self {
            positions,
            layers,
            first_vertices: sequence.positions().first_vertices().to_vec(),
            targets: sequence.targets().to_vec(),
            errors: sequence.errors().to_vec(),
            triangles,
            groups,
            added_counts,
            group_count,
            color_space,
            is_georeferenced,
            ..Self::default()
        }
    }

    /// Announces the levels of the whole mesh, of which the model has the coarse ones.
    #[cfg(feature = "files")]
    pub(crate) fn with_later_levels(mut self, RefinableMesh { mesh, sequence }: &RefinableMesh) -> Self {
        // The finest level here has an error, too.
        self.errors = sequence.errors().to_vec();
        let (vertices, triangles) = (mesh.vertex_count(), mesh.triangle_count());
        self.whole = Some(Counts { vertices, triangles, steps: sequence.step_count() });
        self
    }

    /// Number of steps that the model has.
    fn own_step_count(&self) -> usize {
        self.added_counts.len()
    }

    fn new_hierarchy(&mut self) -> GrowingHierarchy {
        let mut hierarchy = GrowingHierarchy::new();
        hierarchy.grow(&self.prefix(), &[], |step| self.error_at(step));
        self.cut.limit_steps(self.own_step_count());
        hierarchy
    }

    fn prefix(&self) -> PrefixMesh<'_> {
        PrefixMesh {
            positions: &self.positions,
            first_vertices: &self.first_vertices,
            targets: &self.targets,
            triangles: &self.triangles,
            added_triangle_counts: &self.added_counts,
        }
    }

    fn shown(&self, numbered: &[(u32, [u32; 3])], split_count: usize, coarsest: usize) -> ShownLevel {
        let (triangles, group_counts) = by_group(numbered, &self.groups, self.group_count);
        ShownLevel { triangles, group_counts, split_count, error: self.error_at(coarsest) }
    }
}

/// Step that adds a vertex, among positions that begin at these vertices; the last entry is the number of vertices.
pub(crate) fn step_in(first_vertices: &[u32], step_count: usize, vertex: u32) -> Option<usize> {
    let position = first_vertices.partition_point(|&first| first <= vertex).checked_sub(1)?;
    let base_count = first_vertices.len().checked_sub(1 + step_count)?;
    position.checked_sub(base_count).filter(|&step| step < step_count)
}

impl Leveled for PrefixModel {
    fn is_complete(&self) -> bool {
        self.whole.is_none()
    }

    fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    fn full_counts(&self) -> (usize, usize) {
        let own = (self.vertex_count(), self.triangle_count());
        self.whole.map_or(own, |whole| (whole.vertices, whole.triangles))
    }

    fn step_count(&self) -> usize {
        self.whole.map_or(self.own_step_count(), |whole| whole.steps)
    }

    fn group_count(&self) -> usize {
        self.group_count.max(1)
    }

    fn bounds(&self) -> Option<Bounds> {
        Bounds::of(&self.positions)
    }

    fn is_georeferenced(&self) -> bool {
        self.is_georeferenced
    }

    fn vertices(&self, first: usize) -> Vertices {
        let first = first.min(self.vertex_count());
        Vertices::new(&self.positions[first..], &self.layers, first, self.color_space)
    }

    fn smooth_normals(&self) -> Vec<[f32; 3]> {
        normals::of_vertices(&self.positions, &self.triangles, &self.first_vertices)
    }

    fn split_count_for(&self, target: Target) -> usize {
        let wanted = match target {
            Target::Detail(detail) => steps_for_detail(detail, self.step_count()),
            Target::Triangles(limit) => self.prefix().split_count_for_triangles(limit),
            // Errors never rise with the split count.
            Target::Error(limit) => self.errors.partition_point(|&error| f64::from(error) > limit),
            // Pages ask for no others.
            _ => self.step_count(),
        };
        wanted.min(self.own_step_count())
    }

    fn triangle_count_at(&self, split_count: usize) -> usize {
        self.prefix().triangle_count_at(split_count.min(self.own_step_count()))
    }

    fn error_at(&self, split_count: usize) -> f32 {
        self.errors.get(split_count).copied().unwrap_or(0.0)
    }

    fn step_of(&self, vertex: u32) -> Option<usize> {
        step_in(&self.first_vertices, self.own_step_count(), vertex)
    }

    fn show(&mut self, target: Target) -> ShownLevel {
        let split_count = self.split_count_for(target);
        let mut triangles = Vec::new();
        self.prefix().triangles_at_into(split_count, &mut triangles);
        self.shown(&triangles, split_count, split_count)
    }

    fn show_view(&mut self, view: &View) -> Result<(ShownLevel, bool), Failure> {
        let criterion = view.criterion()?;
        let limit = if view.triangle_limit == 0 { usize::MAX } else { view.triangle_limit as usize };
        let hierarchy = match self.hierarchy.take() {
            Some(hierarchy) => hierarchy,
            None => self.new_hierarchy(),
        };
        self.cut.refine(&hierarchy, &criterion, limit);
        let mut triangles = Vec::new();
        self.cut.triangles_into(&hierarchy, &self.prefix(), &mut triangles);
        let coarsest = self.cut.first_coarse_step(&hierarchy);
        self.hierarchy = Some(hierarchy);
        Ok((self.shown(&triangles, self.cut.split_count(), coarsest), true))
    }

    fn color_fans(&mut self, shown: &mut ShownLevel) -> Vec<u32> {
        coloring::by_pivots(shown)
    }
}
