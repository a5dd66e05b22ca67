//! The published criterion: that of \[Hop97\], with a sphere, a cone of normals and two scalars per vertex.
//!
//! A vertex is refined unless its sphere is outside the frustum, all its normals are turned away, or its error covers
//! less than the tolerance. The error along the normal counts as much as the normal is turned to the side.

use glam::{DVec3, Vec3};
use striata::mesh::{RefinableMesh, is_proper};
use striata::model::Fans;
use striata::view::{Camera, NormalCone, Sphere};

use super::deviations::{self, Deviation};
use super::{PublishedFans, PublishedFansState};

/// Data of the criterion of a vertex (`radio`, `dotcone`, `surface` and `dist` in the paper).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexCriterion {
    /// Radius of a sphere around the vertex that contains everything below it.
    pub radius: f32,
    /// Cosine of the angle around the vertex's normal that contains the normals of everything below it; -1 if
    /// these point in all directions.
    pub cone_cos: f32,
    /// Error in any direction.
    pub surface: f32,
    /// Error in the direction of the normal.
    pub dist: f32,
}

/// Data of all vertices.
pub(super) struct CriterionData {
    pub criteria: Vec<VertexCriterion>,
    pub normals: Vec<[f32; 3]>,
}

/// A camera with a tolerance, as the published criterion needs it.
#[derive(Clone, Copy, Debug)]
pub struct PublishedView<'c> {
    camera: &'c Camera,
    eye: Vec3,
    /// Pixels per unit of length at unit distance, divided by the tolerance.
    scale: f32,
}

impl<'c> PublishedView<'c> {
    /// Allows errors of `pixels` pixels. `pixels_per_unit` is the height of the screen in pixels over that of the
    /// picture at unit distance.
    pub fn new(camera: &'c Camera, pixels_per_unit: f32, pixels: f32) -> Self {
        Self { camera, eye: camera.eye().into(), scale: pixels_per_unit / pixels }
    }
}

/// Numbers of insertions and simplifications, and of vertices that were evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PublishedChanges {
    /// Vertices inserted.
    pub inserted: usize,
    /// Vertices simplified.
    pub simplified: usize,
    /// Vertices evaluated.
    pub evaluated: usize,
}

impl PublishedFans {
    /// Whether a view needs the vertex of a step (`qrefine` in \[Hop97\]).
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn needs(&self, step: u32, view: &PublishedView<'_>) -> bool {
        let vertex = (self.base_vertex_count + step) as usize;
        let VertexCriterion { radius, cone_cos, surface, dist } = self.criteria[vertex];
        let position = self.positions[vertex];
        if !view.camera.may_see(&Sphere { center: position, radius }) {
            return false;
        }
        let to = Vec3::from(position) - view.eye;
        let (square, along) = (to.length_squared(), to.dot(Vec3::from(self.normals[vertex])));
        // All normals within the angle around this one are turned away if the line of sight is within its
        // complement.
        if cone_cos > 0.0 && along > 0.0 && along * along > square * (1.0 - cone_cos * cone_cos) {
            return false;
        }
        let scale = view.scale * view.scale;
        surface * surface * scale >= square
            || dist * dist * scale * (square - along * along) >= square * square
    }

    /// Adapts an instance to a view, beginning with what it shows: inserts what the view needs and what that needs,
    /// and simplifies what nothing needs. Nothing is remembered from one view to the next but one bit per vertex.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn adapt(&self, state: &mut PublishedFansState, view: &PublishedView<'_>) -> PublishedChanges {
        let mut changes = PublishedChanges::default();
        // From coarse to fine: what depends on a vertex is finer, so what is inserted is visited later.
        for vertex in 0..self.vertex_count() as u32 {
            if self.step_of(vertex).is_some_and(|step| !state.is_refined(step)) {
                continue;
            }
            for finer in self.dependencies(vertex).iter().map(|d| d.step).filter(|&step| step != super::NONE)
            {
                if state.is_refined(finer) {
                    continue;
                }
                changes.evaluated += 1;
                if self.needs(finer, view) {
                    changes.inserted += state.insert(self, finer);
                }
            }
        }
        for step in (0..self.step_count as u32).rev() {
            if state.is_refined(step) && state.is_free(self, step) {
                changes.evaluated += 1;
                if !self.needs(step, view) {
                    changes.simplified += state.simplify(self, step);
                }
            }
        }
        changes
    }
}

/// Computes the data of all vertices.
pub(super) fn of_vertices(refinable: &RefinableMesh, fans: &Fans) -> CriterionData {
    let mut leaves = Leaves::of(refinable);
    let parents = parents(fans);
    let base = refinable.sequence.base_vertex_count();
    for step in (0..parents.len()).rev() {
        if let Some(parent) = parents[step] {
            leaves.enclose(parent as usize, base + step);
        }
    }
    let deviations = deviations::of_steps(refinable, &leaves.normals);
    let none = std::iter::repeat_n(Deviation::default(), base);
    let of_vertices = none.chain(deviations).zip(leaves.spheres).zip(leaves.cones);
    let criteria = of_vertices.map(|((Deviation { surface, dist }, sphere), cone)| VertexCriterion {
        radius: sphere.radius,
        cone_cos: cone.cos,
        surface,
        dist,
    });
    CriterionData { criteria: criteria.collect(), normals: leaves.normals }
}

/// The coarsest vertex whose entry names each step.
fn parents(fans: &Fans) -> Vec<Option<u32>> {
    let mut parents = vec![None; striata::model::LodModel::step_count(fans)];
    for fan in fans.table_fans() {
        for maker in fan.makers() {
            let parent: &mut Option<u32> = &mut parents[maker.step as usize];
            *parent = Some(parent.map_or(fan.vertex(), |other| other.min(fan.vertex())));
        }
    }
    parents
}

/// Bounds of the triangles around each vertex of the full mesh, to which those of finer vertices are added.
struct Leaves {
    spheres: Vec<Sphere>,
    cones: Vec<NormalCone>,
    normals: Vec<[f32; 3]>,
}

impl Leaves {
    fn of(refinable: &RefinableMesh) -> Self {
        let mesh = &refinable.mesh;
        let triangles = || mesh.triangles.iter().filter(|t| is_proper(t));
        let corners = |t: &[u32; 3]| t.map(|v| mesh.positions[v as usize]);
        let mut sums = vec![DVec3::ZERO; mesh.vertex_count()];
        let mut spheres: Vec<Sphere> = mesh.positions.iter().map(|&p| Sphere::point(p)).collect();
        for triangle in triangles() {
            let [a, b, c] = corners(triangle).map(|p| DVec3::from(p.map(f64::from)));
            for &v in triangle {
                sums[v as usize] += (b - a).cross(c - a);
                let sphere = &mut spheres[v as usize];
                *sphere = corners(triangle).iter().fold(*sphere, |sphere, &p| sphere.with_point(p));
            }
        }
        let normals: Vec<[f32; 3]> =
            sums.iter().map(|sum| sum.normalize_or(DVec3::Z).as_vec3().into()).collect();
        let mut cones: Vec<NormalCone> =
            normals.iter().map(|normal| NormalCone::around(normal.map(f64::from))).collect();
        for triangle in triangles() {
            let own = NormalCone::of_triangles([corners(triangle)].into_iter());
            if own != NormalCone::ALL {
                triangle.iter().for_each(|&v| cones[v as usize] = cones[v as usize].with_cone(&own));
            }
        }
        Self { spheres, cones, normals }
    }

    /// Encloses the bounds of a finer vertex.
    fn enclose(&mut self, parent: usize, child: usize) {
        self.spheres[parent] = self.spheres[parent].with_sphere(&self.spheres[child]);
        self.cones[parent] = self.cones[parent].with_cone(&self.cones[child]);
    }
}
