//! The text form of STL, as programs write it: keywords in any case, closing words apart (`end loop`), remarks
//! after `#`.
//!
//! The normal of a facet is not used, and some writers put invalid numbers there. Lines that mean nothing are
//! skipped and counted; so are facets with a vertex that lacks a number. A facet that is cut off is an error.

use striata::mesh::{IndexedMesh, TriangleGroup, origin_of, relative_position};

use super::vertex_table::VertexTable;
use crate::error::{Fault, Place};
use crate::report::{WarningKind, Warnings};
use crate::text::{Cursor, quoted};

/// Part of an ASCII file.
pub(crate) enum Statement {
    /// Beginning of a solid, with its name.
    Solid(String),
    /// Corners of a triangle.
    Facet([[f64; 3]; 3]),
}

/// Words that have a meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Keyword {
    Solid,
    Facet,
    Normal,
    Outer,
    Loop,
    Vertex,
    EndLoop,
    EndFacet,
    EndSolid,
    Other,
}

/// Number of words of the name of a solid after which no facet is expected in its line.
const LONGEST_NAME: usize = 32;

/// Keywords in the order of their frequency.
const KEYWORDS: [(&[u8], Keyword); 9] = [
    (b"vertex", Keyword::Vertex),
    (b"endloop", Keyword::EndLoop),
    (b"endfacet", Keyword::EndFacet),
    (b"facet", Keyword::Facet),
    (b"normal", Keyword::Normal),
    (b"outer", Keyword::Outer),
    (b"loop", Keyword::Loop),
    (b"solid", Keyword::Solid),
    (b"endsolid", Keyword::EndSolid),
];

/// Passes the solids and facets of an ASCII file to `visit`, which may create faults at the current line.
/// Returns whether some coordinate has more digits than single precision keeps.
pub(crate) fn visit_ascii(
    bytes: &[u8],
    warnings: &mut Warnings,
    mut visit: impl FnMut(Statement, &Cursor<'_>) -> Result<(), Fault>,
) -> Result<bool, Fault> {
    let mut cursor = Cursor::new(bytes);
    let (mut polygon, mut in_solid, mut has_content) = (Vec::new(), false, false);
    loop {
        cursor.skip_lines(Some(b'#'));
        if cursor.at_end() {
            break;
        }
        let word = cursor.word();
        match keyword(word, &mut cursor) {
            Keyword::Solid => {
                let name = solid_name(&mut cursor);
                visit(Statement::Solid(name), &cursor)?;
                (in_solid, has_content) = (true, true);
            }
            Keyword::Facet => {
                has_content = true;
                read_facet(&mut cursor, &mut polygon, warnings)?;
                for pair in polygon.get(1..).unwrap_or(&[]).windows(2) {
                    visit(Statement::Facet([polygon[0], pair[0], pair[1]]), &cursor)?;
                }
            }
            Keyword::EndSolid => {
                cursor.rest_of_line();
                in_solid = false;
            }
            _ => skip_line(word, &mut cursor, warnings),
        }
    }
    if !has_content {
        return Err(cursor.fault("the text has neither `solid` nor `facet`"));
    }
    if in_solid {
        warnings.push(Place::Line(cursor.line()), "the file ends before `endsolid`");
    }
    Ok(cursor.has_long_coordinates())
}

/// Reads the name of a solid: the rest of the line, or what precedes its first facet in that line.
fn solid_name(cursor: &mut Cursor<'_>) -> String {
    let mut ahead = cursor.clone();
    let mut name = Vec::new();
    loop {
        let before = ahead.clone();
        let word = ahead.word();
        if word.is_empty() || name.len() == LONGEST_NAME {
            return String::from_utf8_lossy(cursor.rest_of_line()).into_owned();
        }
        if word.eq_ignore_ascii_case(b"facet") && ahead.word().eq_ignore_ascii_case(b"normal") {
            *cursor = before;
            return String::from_utf8_lossy(&name.join(&b' ')).into_owned();
        }
        name.push(word);
    }
}

/// Returns the meaning of a word; reads the second word of `end loop`, `end facet` and `end solid`.
#[inline]
fn keyword(word: &[u8], cursor: &mut Cursor<'_>) -> Keyword {
    match KEYWORDS.iter().find(|(text, _)| *text == word) {
        Some(&(_, keyword)) => keyword,
        None => unusual_keyword(word, cursor),
    }
}

#[cold]
fn unusual_keyword(word: &[u8], cursor: &mut Cursor<'_>) -> Keyword {
    if word.eq_ignore_ascii_case(b"end") {
        let mut ahead = cursor.clone();
        let joined = [b"end", ahead.word()].concat();
        let found = KEYWORDS.iter().find(|(text, _)| text.eq_ignore_ascii_case(&joined));
        return found.map_or(Keyword::Other, |&(_, keyword)| {
            *cursor = ahead;
            keyword
        });
    }
    let found = KEYWORDS.iter().find(|(text, _)| text.eq_ignore_ascii_case(word));
    found.map_or(Keyword::Other, |&(_, keyword)| keyword)
}

#[cold]
fn skip_line(word: &[u8], cursor: &mut Cursor<'_>, warnings: &mut Warnings) {
    let line = cursor.line();
    warnings.count(
        WarningKind::LINES,
        || Place::Line(line),
        || format!("unknown statement {}", quoted(word)),
    );
    cursor.rest_of_line();
}

/// Reads the coordinates of a corner; one that is no number is not finite, so that its triangles are left out.
fn coordinates(cursor: &mut Cursor<'_>, warnings: &mut Warnings) -> [f64; 3] {
    [(); 3].map(|()| {
        cursor.long_coordinate().unwrap_or_else(|fault| {
            warnings.count_fault(WarningKind::WORDS, fault);
            f64::NAN
        })
    })
}

/// Reads the corners of a facet after the word `facet`. Most have three; others are left out, or are polygons.
fn read_facet(
    cursor: &mut Cursor<'_>,
    polygon: &mut Vec<[f64; 3]>,
    warnings: &mut Warnings,
) -> Result<(), Fault> {
    polygon.clear();
    let line = cursor.line();
    loop {
        cursor.skip_lines(Some(b'#'));
        if cursor.at_end() {
            return Err(cursor.fault("the file ends within a facet"));
        }
        let word = cursor.word();
        match keyword(word, cursor) {
            Keyword::Vertex => polygon.push(coordinates(cursor, warnings)),
            Keyword::Normal => (0..3).for_each(|_| {
                cursor.word();
            }),
            Keyword::Outer | Keyword::Loop | Keyword::EndLoop => {}
            Keyword::EndFacet => break,
            Keyword::Other => skip_line(word, cursor, warnings),
            _ => return Err(cursor.fault(format!("expected `endfacet`, found {}", quoted(word)))),
        }
    }
    if polygon.len() < 3 {
        let reason = || format!("a facet with {} vertices", polygon.len());
        warnings.count(WarningKind::POLYGONS, || Place::Line(line), reason);
    }
    Ok(())
}

/// Reads a text whose lines end as on all current systems.
pub(super) fn read_ascii(text: &[u8], warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
    let (mesh, has_long_coordinates) = read_relative(text, [0.0; 3], warnings)?;
    if !has_long_coordinates {
        return Ok(IndexedMesh { exact_positions: Vec::new(), ..mesh });
    }
    // Corners are the same vertex if they agree relative to the origin.
    let origin = origin_of(&mesh.exact_positions);
    Ok(read_relative(text, origin, &mut Warnings::of_file(warnings.file()))?.0)
}

/// Reads a text with positions relative to an origin, and returns whether they need doubles.
fn read_relative(
    text: &[u8],
    origin: [f64; 3],
    warnings: &mut Warnings,
) -> Result<(IndexedMesh, bool), Fault> {
    let mut vertices = VertexTable::with_capacity(text.len() / 500);
    let (mut triangles, mut exact) = (Vec::new(), Vec::new());
    let mut groups: Vec<TriangleGroup> = Vec::new();
    let has_long_coordinates = visit_ascii(text, warnings, |statement, _| {
        match statement {
            Statement::Solid(name) => {
                groups.push(TriangleGroup { name, first: triangles.len() as u32, ..Default::default() });
            }
            Statement::Facet(corners) => triangles.push(corners.map(|corner| {
                let vertex = vertices.vertex(relative_position(corner, origin));
                if vertex as usize == exact.len() {
                    exact.push(corner);
                }
                vertex
            })),
        }
        Ok(())
    })?;
    if let Some(first) = groups.first_mut() {
        // Facets before the first solid belong to it.
        first.first = 0;
    }
    let ends: Vec<u32> = groups.iter().skip(1).map(|g| g.first).chain([triangles.len() as u32]).collect();
    for (group, end) in groups.iter_mut().zip(ends) {
        group.count = end - group.first;
    }
    if groups.iter().all(|g| g.name.is_empty()) && groups.len() <= 1 {
        groups.clear();
    }
    let mesh = IndexedMesh::new(vertices.positions, triangles);
    Ok((IndexedMesh { groups, origin, exact_positions: exact, ..mesh }, has_long_coordinates))
}
