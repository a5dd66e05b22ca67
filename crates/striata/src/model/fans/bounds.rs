//! What a criterion needs of each step: a sphere, a cone of normals and an error that cover all that depends on the step.
//!
//! Nothing that waits for a step, nor the step itself, can change the picture outside of its sphere; and whatever triangles
//! it or they take away or leave have their normals in its cone. So where the sphere cannot be seen, or everything in it
//! is turned away, or its error is small enough on the screen, the step and all that needs it undone can stay taken:
//! a criterion never has to look below.
//!
//! Bounds grow from the finest step to the coarsest, along what each step waits for. Centres are the positions of the
//! steps, which are there anyway; so a bound is a radius and a cone.

use super::Fans;
use crate::mesh::{CollapseSequence, RefinableMesh};
use crate::view::{NormalCone, Sphere};

/// For each step a sphere and a cone of normals that hold whatever the step and all that it waits for change.
#[derive(Clone, Debug, PartialEq)]
pub struct FanBounds {
    radii: Vec<f32>,
    cones: Vec<NormalCone>,
}

impl FanBounds {
    /// The bounds of a table's steps.
    ///
    /// # Panics
    /// If the table is another mesh's.
    pub fn build(fans: &Fans, refinable: &RefinableMesh) -> Self {
        let step_count = fans.step_count;
        assert_eq!(step_count, refinable.sequence.step_count(), "the table is another mesh's");
        let mut bounds = Self { radii: vec![0.0; step_count], cones: vec![NormalCone::ALL; step_count] };
        let mut changed = Vec::new();
        // What a step waits for is finer, so its bounds are known by then.
        for step in (0..step_count as u32).rev() {
            changed.clear();
            fans.triangles_changed_by(step, &refinable.sequence, &mut changed);
            let positions = &refinable.mesh.positions;
            let corners = changed.iter().map(|t| t.map(|v| positions[v as usize]));
            let mut sphere = Sphere::point(bounds.center(step, refinable));
            for corner in corners.clone().flatten() {
                sphere = sphere.with_point(corner);
            }
            let mut cone = NormalCone::of_triangles(corners);
            fans.for_each_needed_by_collapse(step, |finer| {
                sphere = sphere.with_sphere(&bounds.sphere(finer, refinable));
                cone = cone.with_cone(&bounds.cones[finer as usize]);
            });
            bounds.radii[step as usize] = sphere.radius;
            bounds.cones[step as usize] = cone;
        }
        bounds
    }

    /// The sphere outside of which nothing changes by the step and all that it waits for.
    ///
    /// # Panics
    /// If there is no such step.
    pub fn sphere(&self, step: u32, refinable: &RefinableMesh) -> Sphere {
        Sphere { center: self.center(step, refinable), radius: self.radii[step as usize] }
    }

    /// The cone of the normals of all triangles that these take away or leave.
    ///
    /// # Panics
    /// If there is no such step.
    pub fn cone(&self, step: u32) -> NormalCone {
        self.cones[step as usize]
    }

    /// Bytes of radii and cones.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.radii[..]) + size_of_val(&self.cones[..])
    }

    fn center(&self, step: u32, refinable: &RefinableMesh) -> [f32; 3] {
        refinable.mesh.positions[refinable.sequence.step_vertices(step as usize).start as usize]
    }
}

impl Fans {
    /// Appends the star that a step takes away and the floor that it leaves.
    fn triangles_changed_by(&self, step: u32, sequence: &CollapseSequence, out: &mut Vec<[u32; 3]>) {
        let vertices = self.vertices.of_step(step as usize);
        let mut indices = Vec::new();
        for vertex in vertices.clone() {
            for fan in self.step_entry(vertex, step) {
                fan.triangles_into(fan.mask(|_| true), &mut indices);
            }
        }
        for &star in indices.as_chunks().0 {
            let floor = star.map(|v| if vertices.contains(&v) { sequence.target(v) } else { v });
            out.extend([star, floor]);
        }
    }
}
