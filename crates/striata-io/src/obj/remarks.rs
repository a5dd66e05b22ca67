//! Statements and values of an OBJ file that are left out and counted: other shapes than triangles, and defects.
//!
//! This code is out of the way of the usual statements, whose speed is measured.

use super::ObjReader;
use super::corners::NONE;
use crate::error::{Fault, Place};
use crate::report::{WarningKind, Warnings};
use crate::text::Cursor;

const KINDS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// Kinds of the warnings about indices.
const MISSING: [WarningKind; 3] = [
    WarningKind("", ""),
    WarningKind("texture coordinate of a corner left out", "texture coordinates of corners left out"),
    WarningKind("normal of a corner left out", "normals of corners left out"),
];

/// Statements that draw something other than triangles.
const SHAPES: [&[u8]; 8] = [b"l", b"p", b"curv", b"curv2", b"surf", b"bzp", b"bsp", b"cdc"];

/// Statements of the format that do not affect triangles.
const IGNORED: [&[u8]; 27] = [
    b"s",
    b"vp",
    b"deg",
    b"bmat",
    b"step",
    b"cstype",
    b"parm",
    b"trim",
    b"hole",
    b"scrv",
    b"sp",
    b"end",
    b"con",
    b"mg",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"maplib",
    b"usemap",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
    b"stech",
    b"cdp",
    b"res",
    b"call",
];

/// Begins the comment in which our writer keeps where on the Earth a terrain is.
pub(super) const GEOREFERENCE: &str = "# georeference";

impl ObjReader {
    /// Reads a comment, which only matters if it is one of our writer.
    pub(super) fn remark(&mut self, cursor: &mut Cursor<'_>) {
        if let Some(text) = cursor.rest_of_line().strip_prefix(GEOREFERENCE.as_bytes())
            && text.trim_ascii_start().starts_with(b"{")
        {
            self.georeference = String::from_utf8_lossy(text.trim_ascii()).into_owned();
        }
    }

    /// Skips a statement that makes no triangle, or that does not exist.
    #[cold]
    pub(super) fn other_statement(&mut self, word: &[u8], cursor: &Cursor<'_>) {
        let (lower, place) = (word.to_ascii_lowercase(), || Place::Line(cursor.line()));
        let shown = String::from_utf8_lossy(&word[..word.len().min(40)]).escape_default().to_string();
        if IGNORED.contains(&&lower[..]) {
        } else if SHAPES.contains(&&lower[..]) {
            let reason = || format!("the statement `{shown}`; only triangles are read");
            self.warnings.count(WarningKind::SHAPES, place, reason);
        } else {
            self.known_count -= 1;
            self.warnings.count(WarningKind::LINES, place, || format!("unknown statement \"{shown}\""));
        }
    }

    /// Counts a vertex with more numbers than there are meanings for.
    #[cold]
    pub(super) fn surplus(&mut self, cursor: &Cursor<'_>) {
        let kind = WarningKind("vertex with surplus numbers", "vertices with surplus numbers");
        self.warnings.count(kind, || Place::Line(cursor.line()), || "a vertex has at most 8".to_owned());
    }

    /// Counts a face that has no area.
    #[cold]
    pub(super) fn no_polygon(&mut self, corner_count: usize, cursor: &Cursor<'_>) {
        let reason = || format!("a face with {corner_count} corners");
        self.warnings.count(WarningKind::POLYGONS, || Place::Line(cursor.line()), reason);
    }

    /// Counts a line with a word that is no number, and returns values that are repaired like others that are not
    /// finite.
    #[cold]
    pub(super) fn no_number<const N: usize>(&mut self, fault: Fault) -> [f32; N] {
        self.warnings.count_fault(WarningKind::WORDS, fault);
        [f32::NAN; N]
    }

    /// Decides about a word in the place of an index. Without a position the face is left out.
    #[cold]
    pub(super) fn no_index(&mut self, kind: usize, fault: Fault) -> u32 {
        if kind > 0 {
            self.warnings.count_fault(MISSING[kind], fault);
        } else {
            self.warnings.count_fault(WarningKind::POLYGONS, fault);
            self.has_bad_corner = true;
        }
        NONE
    }

    /// Decides about an index that is not defined so far: `(kind, index as written, index from 0)`.
    #[cold]
    pub(super) fn unusual_index(
        &mut self,
        cursor: &Cursor<'_>,
        kind: usize,
        index: i64,
        found: Option<u32>,
    ) -> Result<u32, Fault> {
        if let Some(found) = found {
            if self.forward[kind].last().is_none_or(|&(largest, _)| found > largest) {
                self.forward[kind].push((found, cursor.line()));
            }
            return Ok(found);
        }
        let (what, count) = (KINDS[kind], self.counts()[kind]);
        let reason = || format!("{what} {index} does not exist: there are {count} so far");
        if kind == 0 {
            return Err(cursor.fault(reason()));
        }
        self.warnings.count(MISSING[kind], || Place::Line(cursor.line()), reason);
        Ok(NONE)
    }

    /// Checks that the text is an OBJ file, and that positions used before their definition are defined.
    pub(super) fn check_end(&mut self) -> Result<(), Fault> {
        if let Some((line, reason)) = self.missing(0) {
            return Err(Fault::at_line(line, reason));
        }
        let skipped = self.warnings.first_of(WarningKind::LINES).filter(|_| self.known_count == 0);
        match skipped {
            Some(first) => {
                let reason = format!("no line of the file is an OBJ statement: {}", first.reason);
                Err(Fault::Malformed(first.place.clone(), reason))
            }
            None => Ok(()),
        }
    }

    /// Returns the line of the first index of a kind that is never defined, and a description.
    pub(super) fn missing(&self, kind: usize) -> Option<(u64, String)> {
        let (what, count) = (KINDS[kind], self.counts()[kind]);
        let &(index, line) = self.forward[kind].iter().find(|&&(index, _)| index as usize >= count)?;
        Some((line, format!("{what} {} does not exist: there are {count}", u64::from(index) + 1)))
    }

    /// Takes texture coordinates and normals that are never defined from the corners.
    pub(super) fn drop_missing(&mut self) {
        let counts = self.counts();
        for kind in 1..3 {
            let Some((line, reason)) = self.missing(kind) else { continue };
            let mut dropped = 0;
            for corner in &mut self.corners {
                let is_missing = is_missing(corner[kind], counts[kind]);
                corner[kind] = if is_missing { NONE } else { corner[kind] };
                dropped += u64::from(is_missing);
            }
            warn_of_missing(kind, dropped, line, reason, &mut self.warnings);
        }
    }
}

/// Whether a corner has an index that is never defined.
pub(crate) fn is_missing(index: u32, count: usize) -> bool {
    index != NONE && index as usize >= count
}

/// Counts texture coordinates (kind 1) or normals (kind 2) of corners that are never defined.
pub(crate) fn warn_of_missing(kind: usize, count: u64, line: u64, reason: String, warnings: &mut Warnings) {
    warnings.count_many(MISSING[kind], count, || (Place::Line(line), reason));
}
