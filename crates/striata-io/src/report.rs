//! Warnings of reading: parts of a file that were left out of a mesh.

use std::fmt;

use striata::mesh::IndexedMesh;

use crate::error::Place;

/// Largest number of warnings that are kept, so that a hostile file cannot fill the memory with them.
const MAX_WARNINGS: usize = 100;

/// Remark on something that was left out or changed while a file was read, such as a missing texture.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Warning {
    /// Name of the file that the remark is about; for OBJ it may be a material library.
    pub file: String,
    /// Location in that file.
    pub place: Place,
    /// Description of what was found and what was done.
    pub reason: String,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            Place::File => write!(f, "{}: {}", self.file, self.reason),
            place => write!(f, "{}: {place}: {}", self.file, self.reason),
        }
    }
}

/// Mesh of a file, with remarks on what was left out of it.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ReadReport {
    /// The mesh.
    pub mesh: IndexedMesh,
    /// Remarks in the order of the file, without repetitions; at most 100, and one more that counts the rest.
    pub warnings: Vec<Warning>,
}

/// Warnings collected while a file is read.
#[derive(Debug)]
pub(crate) struct Warnings {
    file: String,
    kept: Vec<Warning>,
    omitted_count: usize,
}

impl Warnings {
    /// Creates an empty list for a file.
    pub(crate) fn of_file(file: &str) -> Self {
        Self { file: file.to_owned(), kept: Vec::new(), omitted_count: 0 }
    }

    /// Returns the name of the file that is read.
    #[cfg(feature = "ply")]
    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// Adds a remark on the file itself.
    pub(crate) fn push(&mut self, place: Place, reason: impl Into<String>) {
        let file = self.file.clone();
        self.push_for(&file, place, reason);
    }

    /// Adds a remark on another file.
    pub(crate) fn push_for(&mut self, file: &str, place: Place, reason: impl Into<String>) {
        let warning = Warning { file: file.to_owned(), place, reason: reason.into() };
        if self.kept.contains(&warning) {
            return;
        }
        if self.kept.len() < MAX_WARNINGS {
            self.kept.push(warning);
        } else {
            self.omitted_count += 1;
        }
    }

    /// Returns all warnings; the last one counts those that were not kept.
    pub(crate) fn into_list(self) -> Vec<Warning> {
        let Self { file, mut kept, omitted_count } = self;
        if omitted_count > 0 {
            let reason = format!("{omitted_count} more warnings");
            kept.push(Warning { file, place: Place::File, reason });
        }
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repetitions_are_dropped_and_the_rest_is_counted() {
        let mut warnings = Warnings::of_file("a.obj");
        for line in 0..150 {
            for _ in 0..2 {
                warnings.push(Place::Line(line), "left out");
            }
        }
        let list = warnings.into_list();
        assert_eq!(list.len(), MAX_WARNINGS + 1);
        assert_eq!(list[3].to_string(), "a.obj: line 3: left out");
        assert_eq!(list[MAX_WARNINGS].to_string(), "a.obj: 100 more warnings");
    }
}
