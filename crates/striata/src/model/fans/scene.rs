//! Combines a table with the positions that a view criterion needs.

use super::Fans;
use crate::model::step_bounds::StepBounds;
use crate::view::{Part, Sphere};

/// A table with bounds and the vertex positions of its mesh, shared by all instances. It only borrows and
/// costs nothing to create, so make one whenever it is needed.
#[derive(Clone, Copy, Debug)]
pub struct FanScene<'a> {
    pub(super) fans: &'a Fans,
    bounds: &'a StepBounds,
    positions: &'a [[f32; 3]],
}

impl<'a> FanScene<'a> {
    /// Combines a table with the positions of its mesh, in refinement order.
    ///
    /// # Panics
    /// If their vertex counts differ, or the table was built without bounds.
    pub fn new(fans: &'a Fans, positions: &'a [[f32; 3]]) -> Self {
        assert_eq!(fans.vertex_count(), positions.len(), "the table belongs to a different mesh");
        let bounds = fans.bounds.as_ref().expect("the table was built with bounds");
        Self { fans, bounds, positions }
    }

    /// Returns the table.
    pub fn fans(&self) -> &'a Fans {
        self.fans
    }

    /// Returns the bounds of a step in the form that a criterion evaluates.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline(always)]
    pub fn part(&self, step: u32) -> Part {
        self.bounds.part(step, self.positions[self.fans.center_vertex(step)])
    }

    /// Returns a sphere around all positions, for
    /// [`ScreenError::with_model_bounds`](crate::view::ScreenError::with_model_bounds). Takes time linear in
    /// the vertex count, so keep the result.
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
