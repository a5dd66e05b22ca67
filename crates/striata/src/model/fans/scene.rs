//! A table with what it takes to ask a criterion of its steps.

use super::Fans;
use crate::mesh::RefinableMesh;
use crate::model::step_bounds::StepBounds;
use crate::view::{Part, Sphere};

/// What all instances of a model share: the table with the bounds of its steps, and the positions of the mesh's vertices. It only borrows,
/// and costs nothing to make: make one wherever it is needed, from owners that are kept elsewhere.
#[derive(Clone, Copy, Debug)]
pub struct FanScene<'a> {
    pub(super) fans: &'a Fans,
    bounds: &'a StepBounds,
    positions: &'a [[f32; 3]],
}

impl<'a> FanScene<'a> {
    /// Puts a table and the mesh's positions together.
    ///
    /// # Panics
    /// If they are not of the same mesh, by their counts, or the table was built without bounds.
    pub fn new(fans: &'a Fans, refinable: &'a RefinableMesh) -> Self {
        let positions = &refinable.mesh.positions[..];
        assert_eq!(fans.vertex_count(), positions.len(), "the table is another mesh's");
        let bounds = fans.bounds.as_ref().expect("the table was built with bounds");
        Self { fans, bounds, positions }
    }

    /// The table.
    pub fn fans(&self) -> &'a Fans {
        self.fans
    }

    /// What a step is to a criterion.
    ///
    /// # Panics
    /// If there is no such step.
    #[inline]
    pub fn part(&self, step: u32) -> Part {
        self.bounds.part(step, self.positions[self.fans.center_vertex(step)])
    }

    /// A sphere around all positions, for [`ScreenError::with_model_bounds`](crate::view::ScreenError::with_model_bounds). Walks all of them:
    /// keep it.
    pub fn sphere(&self) -> Sphere {
        let mut corners = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
        for position in self.positions {
            for i in 0..3 {
                corners[0][i] = corners[0][i].min(position[i]);
                corners[1][i] = corners[1][i].max(position[i]);
            }
        }
        let center = [0, 1, 2].map(|i| corners[0][i] / 2.0 + corners[1][i] / 2.0);
        if self.positions.is_empty() {
            return Sphere::point([0.0; 3]);
        }
        self.positions.iter().fold(Sphere::point(center), |sphere, &position| sphere.with_point(position))
    }
}
