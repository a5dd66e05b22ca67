//! Warnings: parts of a file that were left out of a mesh, or repaired, and parts of a mesh that were left out
//! of a file.

use std::fmt;

use striata::mesh::IndexedMesh;

use crate::error::{Fault, Place};

/// Largest number of warnings that are kept, so that a hostile file cannot fill the memory with them.
const MAX_WARNINGS: usize = 100;

/// Remark on what was left out or repaired while a file was read or written, such as lines that mean nothing.
///
/// There is one for each kind, which counts the cases and says where the first is.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Warning {
    /// Name of the file that the remark is about; for OBJ it may be a material library.
    pub file: String,
    /// Number of cases, at least 1.
    pub count: u64,
    /// Location of the first case in that file.
    pub place: Place,
    /// Description of what was found in the first case, and what was done.
    pub reason: String,
    kind: WarningKind,
}

impl Warning {
    /// Name of the things that were counted, such as `lines skipped`; empty if the reason says it.
    pub fn what(&self) -> &'static str {
        if self.count == 1 { self.kind.0 } else { self.kind.1 }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, count, place, reason, .. } = self;
        let what = self.what();
        write!(f, "{file}: ")?;
        match (what.is_empty(), *count, place) {
            (true, 1, Place::File) => f.write_str(reason),
            (true, 1, place) => write!(f, "{place}: {reason}"),
            (true, count, place) => {
                write!(f, "{place}: {reason} ({} such places)", with_commas(count))
            }
            (false, count, Place::File) => write!(f, "{} {what}: {reason}", with_commas(count)),
            (false, 1, place) => write!(f, "1 {what}, {place}: {reason}"),
            (false, count, place) => {
                write!(f, "{} {what}, the first is {place}: {reason}", with_commas(count))
            }
        }
    }
}

/// Formats a count with commas between groups of three digits.
pub(crate) fn with_commas(count: u64) -> String {
    let digits = count.to_string();
    let mut out = String::with_capacity(digits.len() * 4 / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

/// Mesh of a file, with remarks on what was left out of it.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ReadReport {
    /// The mesh.
    pub mesh: IndexedMesh,
    /// Remarks in the order of the file, one for each kind; at most 100, and one more that counts the rest.
    pub warnings: Vec<Warning>,
}

/// Kind of warning that counts its cases: what happened to one, and to several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct WarningKind(pub(crate) &'static str, pub(crate) &'static str);

impl WarningKind {
    /// The reason says everything.
    const NONE: Self = Self("", "");
    pub(crate) const LINES: Self = Self("line skipped", "lines skipped");
    /// Primitives other than triangles.
    pub(crate) const SHAPES: Self = Self("line, point or curve left out", "lines, points or curves left out");
    pub(crate) const WORDS: Self = Self("value that is no number", "values that are no numbers");
    pub(crate) const POLYGONS: Self = Self("polygon left out", "polygons left out");
}

/// Warnings collected while a file is read.
#[derive(Clone, Debug, Default)]
pub(crate) struct Warnings {
    file: String,
    kept: Vec<Warning>,
    omitted_count: u64,
}

impl Warnings {
    /// Creates an empty list for a file.
    pub(crate) fn of_file(file: &str) -> Self {
        Self { file: file.to_owned(), kept: Vec::new(), omitted_count: 0 }
    }

    /// Continues a list.
    #[cfg(any(feature = "gltf", all(feature = "pieces", not(target_family = "wasm"))))]
    pub(crate) fn of_list(file: &str, kept: Vec<Warning>) -> Self {
        Self { file: file.to_owned(), kept, omitted_count: 0 }
    }

    /// Returns the name of the file that is read.
    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// Adds a remark on the file itself.
    pub(crate) fn push(&mut self, place: Place, reason: impl Into<String>) {
        let file = self.file.clone();
        self.push_for(&file, place, reason);
    }

    /// Adds a remark on another file. A reason that was given before is only counted.
    pub(crate) fn push_for(&mut self, file: &str, place: Place, reason: impl Into<String>) {
        let reason = reason.into();
        let same = |w: &&mut Warning| w.kind == WarningKind::NONE && w.reason == reason && w.file == file;
        match self.kept.iter_mut().find(same) {
            Some(known) if known.place == place => {}
            Some(known) => known.count += 1,
            None => {
                self.keep(Warning {
                    file: file.to_owned(),
                    count: 1,
                    place,
                    reason,
                    kind: WarningKind::NONE,
                });
            }
        }
    }

    /// Counts one more case of a kind; `place` and `reason` are only asked for the first.
    #[cold]
    pub(crate) fn count(
        &mut self,
        kind: WarningKind,
        place: impl FnOnce() -> Place,
        reason: impl FnOnce() -> String,
    ) {
        self.count_many(kind, 1, || (place(), reason()));
    }

    /// Counts a fault that the reader gets over.
    #[cold]
    pub(crate) fn count_fault(&mut self, kind: WarningKind, fault: Fault) {
        if let Fault::Malformed(place, reason) = fault {
            self.count_many(kind, 1, || (place, reason));
        }
    }

    /// Counts more cases of a kind; `first` is only asked for the first ones.
    pub(crate) fn count_many(
        &mut self,
        kind: WarningKind,
        count: u64,
        first: impl FnOnce() -> (Place, String),
    ) {
        if count == 0 {
            return;
        }
        match self.kept.iter_mut().find(|w| w.kind == kind) {
            Some(known) => known.count += count,
            None => {
                let ((place, reason), file) = (first(), self.file.clone());
                self.keep(Warning { file, count, place, reason, kind });
            }
        }
    }

    /// Returns the first case of a kind.
    pub(crate) fn first_of(&self, kind: WarningKind) -> Option<&Warning> {
        self.kept.iter().find(|w| w.kind == kind)
    }

    /// Describes the first thing that could not be read, without the name of the file.
    pub(crate) fn fault(&self) -> Option<String> {
        let fault = self.kept.iter().find(|warning| warning.kind != WarningKind::SHAPES)?.to_string();
        Some(fault.strip_prefix(&format!("{}: ", self.file)).unwrap_or(&fault).to_owned())
    }

    /// Replaces the places, which were those in a part of the file.
    pub(crate) fn set_place(&mut self, place: &Place) {
        self.kept.iter_mut().for_each(|warning| warning.place = place.clone());
    }

    /// Describes the points, lines and curves that were left out, if there were any.
    pub(crate) fn shapes(&self) -> Option<String> {
        let count = self.first_of(WarningKind::SHAPES)?.count;
        Some(format!(
            "{} {}",
            with_commas(count),
            if count == 1 { "line or curve" } else { "lines or curves" }
        ))
    }

    /// Appends the warnings of a part of the reader.
    pub(crate) fn append(&mut self, other: Self) {
        for warning in other.kept {
            let is_counted = warning.kind != WarningKind::NONE;
            let same = |w: &&mut Warning| is_counted && w.kind == warning.kind && w.file == warning.file;
            match self.kept.iter_mut().find(same) {
                Some(known) => known.count += warning.count,
                None => self.keep(warning),
            }
        }
        self.omitted_count += other.omitted_count;
    }

    fn keep(&mut self, warning: Warning) {
        // Kinds are few, and must not be lost behind reasons that differ.
        if self.kept.len() < MAX_WARNINGS || warning.kind != WarningKind::NONE {
            self.kept.push(warning);
        } else {
            self.omitted_count += warning.count;
        }
    }

    /// Returns all warnings; the last one counts those that were not kept.
    pub(crate) fn into_list(self) -> Vec<Warning> {
        let Self { file, mut kept, omitted_count } = self;
        if omitted_count > 0 {
            let reason = format!("{omitted_count} more warnings");
            kept.push(Warning { file, count: 1, place: Place::File, reason, kind: WarningKind::NONE });
        }
        kept
    }
}

/// Shortens a name for a message.
pub(crate) fn shortened(name: &str) -> String {
    name.chars().filter(|c| !c.is_control()).take(80).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repetitions_are_counted_and_so_is_the_rest() {
        let mut warnings = Warnings::of_file("a.obj");
        for line in 0..150 {
            for _ in 0..2 {
                warnings.push(Place::Line(line), format!("{line} left out"));
            }
        }
        warnings.push(Place::Line(9), "3 left out");
        warnings.count(WarningKind::LINES, || Place::Line(200), || "the first".to_owned());
        let list = warnings.clone().into_list();
        assert_eq!(list.len(), MAX_WARNINGS + 2);
        assert_eq!(list[3].to_string(), "a.obj: line 3: 3 left out (2 such places)");
        assert_eq!(list[4].to_string(), "a.obj: line 4: 4 left out");
        assert_eq!(list[MAX_WARNINGS].to_string(), "a.obj: 1 line skipped, line 200: the first");
        assert_eq!(list[MAX_WARNINGS + 1].to_string(), "a.obj: 100 more warnings");
        warnings.count_many(WarningKind::LINES, 1233, || unreachable!());
        let counted = warnings.into_list()[MAX_WARNINGS].to_string();
        assert_eq!(counted, "a.obj: 1,234 lines skipped, the first is line 200: the first");
    }
}
