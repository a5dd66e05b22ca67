//! The class `StripLevelData`: strips that follow a level.

use std::sync::{Mutex, MutexGuard, PoisonError};

use numpy::PyArray1;
use pyo3::prelude::*;
use striata::{StripLevel, Target};

use crate::arrays::signed;

/// Strips at a level, which threads move one after another.
#[pyclass(frozen, module = "striata._striata")]
#[derive(Debug)]
pub(crate) struct StripLevelData {
    level: Mutex<StripLevel>,
}

impl From<StripLevel> for StripLevelData {
    fn from(level: StripLevel) -> Self {
        Self { level: Mutex::new(level) }
    }
}

impl StripLevelData {
    fn lock(&self) -> MutexGuard<'_, StripLevel> {
        self.level.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[pymethods]
impl StripLevelData {
    /// Moves to a level, given by its number of vertex splits.
    fn move_to(&self, py: Python<'_>, split_count: usize) {
        py.detach(|| self.lock().move_to(Target::SplitCount(split_count)));
    }

    /// Index buffer with the restart index -1.
    fn indices<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i32>> {
        let indices = py.detach(|| self.lock().indices().to_vec());
        signed(py, indices)
    }

    /// Range of the index buffer to draw for each group.
    fn groups(&self, py: Python<'_>) -> Vec<(u32, u32)> {
        py.detach(|| self.lock().groups().map(|range| (range.start, range.end)).collect())
    }

    /// Ranges of the index buffer that changed since the last call.
    fn take_changed_ranges(&self, py: Python<'_>) -> Vec<(u32, u32)> {
        let ranges = py.detach(|| self.lock().take_changed_ranges());
        ranges.into_iter().map(|range| (range.start, range.end)).collect()
    }

    /// Numbers of strips and of indices that they need, restarts included.
    fn counts(&self, py: Python<'_>) -> (usize, usize) {
        py.detach(|| {
            let level = self.lock();
            (level.strip_count(), level.index_count())
        })
    }
}
