//! Many instances of several meshes that follow one camera, or several, within one triangle budget.
//!
//! Each instance that shows more than its base mesh has a front ([`FanFront`](crate::model::FanFront)) and its
//! triangles. It is refined with a reserve ([`ScreenError::with_reserve`]), so that its errors stay within the tolerance
//! until the view has moved by a twentieth of the distance to the instance. Before that, a frame does not touch it:
//! most instances are updated once in many frames, and a few are updated early so that they do not become due
//! together. Instances outside the picture show their base mesh and keep nothing.
//!
//! All instances have the same tolerance: that of the caller times a factor, in steps of an eighth of a power of two. If
//! an update shows too many triangles, the factor grows by a step or more, and instances follow one after another,
//! smallest on the screen first, until the sum is within the budget. If triangles are left, the factor falls, and a few
//! instances follow in each frame.
//!
//! Results are the same with any number of threads.

mod budget;
mod instance;

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use self::budget::BudgetedFrame;
use self::instance::PlacedInstance;
use super::{Level, Lod};
use crate::view::{Camera, ScreenError};

/// Names an instance of a [`ViewSet`]. The name of a removed instance is not used again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct InstanceId(u64);

/// Why an instance cannot be placed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlacementError {
    /// The matrix is singular, contains a number that is not finite, or has a last row other than 0, 0, 0, 1.
    #[error("the matrix of an instance is singular, not affine, or contains a number that is not finite")]
    Matrix,
    /// The importance is not a positive finite number.
    #[error("an importance of {importance} is not a positive number")]
    Importance {
        /// The value given.
        importance: f32,
    },
    /// The instance does not exist, or has been removed.
    #[error("there is no such instance")]
    Unknown,
}

/// Summary of an update of a [`ViewSet`].
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ViewSetUpdate {
    /// Number of triangles that all instances show together.
    pub triangle_count: usize,
    /// Number of updates of instances; the others were not touched.
    pub updated_count: usize,
    /// Instances whose indices have changed, in ascending order.
    pub changed: Vec<InstanceId>,
    /// Error that the instances in the picture may show, in pixels: the tolerance, or more if the budget required it.
    /// Infinite if even the base meshes exceed the budget.
    pub pixels: f32,
}

/// Thousands of instances of several [`Lod`]s that follow one camera, or several, within a triangle budget.
///
/// Memory: an instance that shows its base mesh, such as one outside the picture, keeps no more than its matrix. An
/// instance that follows keeps less than 4 bytes per vertex of its mesh, and the indices of the triangles that it shows.
///
/// ```
/// use striata::lod::ViewSet;
/// use striata::mesh::shapes;
/// use striata::view::Camera;
/// use striata::{Lod, LodOptions};
///
/// let lod = Lod::build(&shapes::torus(64, 32, 1.0, 0.4), &LodOptions::default())?;
/// let mut set = ViewSet::new();
/// let mut matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
/// let near = set.add(&lod, matrix)?;
/// matrix[3] = [0.0, 0.0, -30.0, 1.0];
/// let far = set.add(&lod, matrix)?;
///
/// let camera = Camera::new([0.0, 1.0, 5.0], [0.0; 3], [0.0, 1.0, 0.0], 0.577, [1920, 1080])?;
/// let update = set.update(&camera, 0.5, 3000); // at most 3,000 triangles
/// assert!(update.triangle_count <= 3000);
/// assert!(set.indices(near).len() > set.indices(far).len());
/// // Draw set.indices(near) over the vertices of lod.mesh().
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct ViewSet {
    instances: BTreeMap<InstanceId, PlacedInstance>,
    /// The base mesh of each mesh that has instances.
    bases: Vec<Arc<Level>>,
    next_id: u64,
    /// Logarithm of the factor of the tolerance.
    relaxation: i32,
}

impl ViewSet {
    /// Creates a set without instances.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds an instance, which shows its base mesh until the next update. `matrix`, a list of columns, places the mesh
    /// in the space of the camera.
    ///
    /// An instance follows the camera vertex by vertex if the matrix is a rotation with a translation and a uniform
    /// scale. Otherwise, it shows uniform levels, for the largest factor by which the matrix enlarges errors.
    ///
    /// # Errors
    /// [`PlacementError::Matrix`].
    pub fn add(&mut self, lod: &Lod, matrix: [[f32; 4]; 4]) -> Result<InstanceId, PlacementError> {
        let base = self.bases.iter().find(|base| Arc::ptr_eq(base.tables(), &lod.tables)).cloned();
        let base = base.unwrap_or_else(|| Arc::new(lod.level(crate::Target::SplitCount(0))));
        let instance = PlacedInstance::new(Arc::clone(&base), &matrix).ok_or(PlacementError::Matrix)?;
        if Arc::strong_count(&base) == 2 {
            self.bases.push(base);
        }
        let id = InstanceId(self.next_id);
        self.next_id += 1;
        self.instances.insert(id, instance);
        Ok(id)
    }

    /// Removes an instance; returns whether it existed.
    pub fn remove(&mut self, id: InstanceId) -> bool {
        let removed = self.instances.remove(&id).is_some();
        self.bases.retain(|base| Arc::strong_count(base) > 1);
        removed
    }

    /// Moves an instance. It follows in the next update.
    ///
    /// # Errors
    /// [`PlacementError::Matrix`] or [`PlacementError::Unknown`]; the instance stays where it is.
    pub fn set_matrix(&mut self, id: InstanceId, matrix: [[f32; 4]; 4]) -> Result<(), PlacementError> {
        let instance = self.instances.get_mut(&id).ok_or(PlacementError::Unknown)?;
        instance.place(&matrix).then_some(()).ok_or(PlacementError::Matrix)
    }

    /// Sets how much the errors of an instance count: 2 allows it half of the pixels that others may err by. At first
    /// it is 1.
    ///
    /// # Errors
    /// [`PlacementError::Importance`] or [`PlacementError::Unknown`].
    pub fn set_importance(&mut self, id: InstanceId, importance: f32) -> Result<(), PlacementError> {
        if !(importance > 0.0 && importance.is_finite()) {
            return Err(PlacementError::Importance { importance });
        }
        let instance = self.instances.get_mut(&id).ok_or(PlacementError::Unknown)?;
        instance.set_importance(importance);
        Ok(())
    }

    /// Number of instances.
    pub fn instance_count(&self) -> usize {
        self.instances.len()
    }

    /// Number of triangles that all instances show together.
    pub fn triangle_count(&self) -> usize {
        self.instances.values().map(PlacedInstance::triangle_count).sum()
    }

    /// Number of bytes that the set owns for its instances, without the indices that they show.
    pub fn bytes(&self) -> usize {
        self.instances.values().map(|instance| size_of::<InstanceId>() + instance.bytes()).sum()
    }

    /// Vertex indices that an instance shows, three per triangle, sorted by group; none if it does not exist.
    pub fn indices(&self, id: InstanceId) -> &[u32] {
        self.instances.get(&id).map_or(&[], PlacedInstance::indices)
    }

    /// Range of [`indices`](Self::indices) that belongs to each group of the mesh.
    pub fn groups(&self, id: InstanceId) -> &[Range<u32>] {
        self.instances.get(&id).map_or(&[], PlacedInstance::groups)
    }

    /// Refines whatever the camera sees until no error covers more than `pixels` pixels of its screen, or, if that
    /// needs more than `triangle_budget` triangles, the fewest pixels that the budget allows, nearly. Coarsens the
    /// rest.
    ///
    /// The instances never show more triangles than the budget, unless their base meshes do, which are then shown. A
    /// budget of `usize::MAX` is no limit. Up to a sixth of the budget can stay unused while the camera moves.
    pub fn update(&mut self, camera: &Camera, pixels: f32, triangle_budget: usize) -> ViewSetUpdate {
        self.update_by(&ScreenError::new(*camera, pixels), triangle_budget)
    }

    /// Updates the set like [`update`](Self::update), but with a custom screen error in the space of the camera. With
    /// [`ScreenError::or`], it takes several cameras. With a fovea, most instances are updated in each frame.
    pub fn update_by(&mut self, error: &ScreenError, triangle_budget: usize) -> ViewSetUpdate {
        let instances: Vec<&mut PlacedInstance> = self.instances.values_mut().collect();
        let mut frame = BudgetedFrame::new(instances, error, triangle_budget);
        self.relaxation = frame.run(self.relaxation);
        let (updated_count, pixels) = (frame.updated_count(), frame.pixels());
        let changed =
            self.instances.iter_mut().filter_map(|(id, instance)| instance.take_change().then_some(*id));
        let changed = changed.collect();
        ViewSetUpdate { triangle_count: self.triangle_count(), updated_count, changed, pixels }
    }
}

#[cfg(test)]
mod tests;
