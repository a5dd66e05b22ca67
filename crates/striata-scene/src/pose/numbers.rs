//! Numbers of accessors, of which animations and skins may share many.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::{DMat4, DVec3};
use serde_json::Value;
use striata_io::{Place, Scene, SceneError};

/// Numbers that may be read regardless of the size of the buffer.
const ALWAYS_ALLOWED: usize = 1 << 24;

/// Numbers of an accessor, and how many of them each element has.
pub(super) type Numbers = (Arc<[f32]>, usize);

/// Reads each accessor of a scene once, and limits the numbers of all of them, which may overlap.
pub(super) struct AccessorNumbers<'s> {
    scene: &'s Scene,
    known: BTreeMap<u64, Numbers>,
    count: usize,
}

impl<'s> AccessorNumbers<'s> {
    pub(super) fn of(scene: &'s Scene) -> Self {
        Self { scene, known: BTreeMap::new(), count: 0 }
    }

    /// Returns the numbers of an accessor.
    ///
    /// # Errors
    /// [`SceneError`] if there is no such accessor, it is malformed, or all accessors together have far more
    /// numbers than the buffer has bytes.
    pub(super) fn read(&mut self, accessor: u64) -> Result<Numbers, SceneError> {
        if let Some(known) = self.known.get(&accessor) {
            return Ok(known.clone());
        }
        let (numbers, width) = self.scene.numbers(accessor)?;
        self.count = self.count.saturating_add(numbers.len());
        let buffer_bytes = self.scene.buffer().len();
        if self.count > ALWAYS_ALLOWED.max(buffer_bytes.saturating_mul(4)) {
            let place = Place::Json(format!("accessors[{accessor}]"));
            let reason = format!("more than {} numbers in a buffer of {buffer_bytes} bytes", self.count);
            return Err(SceneError { place, reason });
        }
        let numbers = (Arc::from(numbers), width);
        self.known.insert(accessor, numbers.clone());
        Ok(numbers)
    }
}

/// Returns a reference to an entry of an array, if it is one.
pub(super) fn index(value: &Value) -> Option<usize> {
    usize::try_from(value.as_u64()?).ok()
}

/// Transforms a position in double precision.
pub(super) fn transformed(matrix: &DMat4, position: [f32; 3]) -> [f32; 3] {
    matrix.transform_point3(DVec3::from_array(position.map(f64::from))).as_vec3().to_array()
}
