//! Parser of material libraries (MTL).
//!
//! The parser is our own. `tobj::load_mtl_buf` panics on `Kd` with fewer than three numbers, rejects a whole
//! file for one malformed number or one byte that is not UTF-8, distinguishes upper and lower case (exporters
//! write `map_Bump`, `map_bump`, `Map_Kd`), keeps the options of a texture as part of its name, and gives no
//! line numbers. Here a malformed statement is skipped with a warning, and so are those that no material can have; unknown
//! statements are ignored.
//!
//! Keywords are compared without case. If a statement is repeated within a material, the last one counts.

use std::collections::{BTreeMap, BTreeSet};

use super::texture_statement::TextureStatement;
use crate::error::Fault;
use crate::report::Warnings;
use crate::text::{Cursor, quoted};

/// Materials of a library, in the order of the file.
#[derive(Debug, Default)]
pub(super) struct Library {
    pub materials: Vec<Definition>,
    /// Whether Blender wrote the file: its colors are linear, and its exponents have their own scale.
    pub is_from_blender: bool,
}

/// Statements of one material.
#[derive(Debug, Default)]
pub(super) struct Definition {
    pub name: String,
    /// Line of `newmtl`.
    pub line: u64,
    /// `Kd`.
    pub diffuse: Option<[f32; 3]>,
    /// `Ks`.
    pub specular: Option<[f32; 3]>,
    /// `Ke`.
    pub emission: Option<[f32; 3]>,
    /// `Ns`.
    pub exponent: Option<f32>,
    /// `d`.
    pub opacity: Option<f32>,
    /// `Tr`.
    pub transparency: Option<f32>,
    /// `Pr`.
    pub roughness: Option<f32>,
    /// `Pm`.
    pub metallic: Option<f32>,
    /// `illum`.
    pub illumination: Option<i64>,
    pub maps: BTreeMap<MapKind, TextureStatement>,
}

/// Purpose of a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum MapKind {
    /// `map_Kd`.
    Diffuse,
    /// `map_d`.
    Opacity,
    /// `map_Ke`.
    Emission,
    /// `norm`, also spelled `map_norm` and `map_Kn`: a tangent space normal map.
    Normal,
    /// `map_Bump`, also spelled `bump`: a height map, or a normal map.
    Bump,
    /// `map_Pr`.
    Roughness,
    /// `map_Pm`.
    Metallic,
}

/// Reader of one library.
struct MtlReader<'r> {
    library: Library,
    /// Names of the materials that are kept.
    wanted: &'r BTreeSet<&'r str>,
    known: BTreeSet<&'r str>,
    /// Whether the current material is the last one of the library, and not skipped.
    is_open: bool,
}

/// Parses the definitions of the materials that are `wanted`; malformed statements are skipped with a
/// warning about `file`. If a name is defined twice, the first definition counts.
pub(super) fn parse(bytes: &[u8], wanted: &BTreeSet<&str>, file: &str, warnings: &mut Warnings) -> Library {
    let mut cursor = Cursor::new(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes));
    let library = Library::default();
    let mut reader = MtlReader { library, wanted, known: BTreeSet::new(), is_open: false };
    while !cursor.at_end() {
        if let Err(Fault::Malformed(place, reason)) = reader.statement(&mut cursor) {
            warnings.push_for(file, place, format!("{reason}; the statement is skipped"));
        }
        cursor.next_line();
    }
    reader.library
}

impl MtlReader<'_> {
    fn statement(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        if cursor.at_line_end() {
            return Ok(());
        }
        let line = cursor.line();
        if cursor.peek() == Some(b'#') {
            let comment = cursor.rest_of_line();
            let text = comment.strip_prefix(b"#").unwrap_or(comment).trim_ascii_start();
            self.library.is_from_blender |= text.starts_with(b"Blender");
            return Ok(());
        }
        let keyword = cursor.word().to_ascii_lowercase();
        if keyword == b"newmtl" {
            let name = String::from_utf8_lossy(cursor.rest_of_line());
            let wanted = self.wanted.get(name.as_ref());
            self.is_open = wanted.is_some_and(|&name| self.known.insert(name));
            if self.is_open {
                let definition = Definition { name: name.into_owned(), line, ..Definition::default() };
                self.library.materials.push(definition);
            }
            return Ok(());
        }
        match self.library.materials.last_mut() {
            Some(material) if self.is_open => material.statement(&keyword, cursor),
            _ => Ok(()),
        }
    }
}

impl Definition {
    fn statement(&mut self, keyword: &[u8], cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let map = match keyword {
            b"kd" => return color_into(&mut self.diffuse, cursor),
            b"ks" => return color_into(&mut self.specular, cursor),
            b"ke" => return color_into(&mut self.emission, cursor),
            b"ns" => return number_into(&mut self.exponent, cursor),
            b"d" => {
                skip_halo(cursor);
                return number_into(&mut self.opacity, cursor);
            }
            b"tr" => return number_into(&mut self.transparency, cursor),
            b"pr" => return number_into(&mut self.roughness, cursor),
            b"pm" => return number_into(&mut self.metallic, cursor),
            b"illum" => {
                self.illumination = Some(cursor.integer()?);
                return Ok(());
            }
            b"map_kd" => MapKind::Diffuse,
            b"map_d" => MapKind::Opacity,
            b"map_ke" => MapKind::Emission,
            b"norm" | b"map_norm" | b"map_kn" => MapKind::Normal,
            b"bump" | b"map_bump" => MapKind::Bump,
            b"map_pr" => MapKind::Roughness,
            b"map_pm" => MapKind::Metallic,
            _ if is_lost(keyword) => {
                return Err(cursor.fault(format!("{} has no counterpart in glTF", quoted(keyword))));
            }
            _ => return Ok(()),
        };
        let line = cursor.line();
        match TextureStatement::parse(cursor.rest_of_line(), line) {
            Some(statement) => drop(self.maps.insert(map, statement)),
            None => return Err(cursor.fault(format!("{} names no file", quoted(keyword)))),
        }
        Ok(())
    }
}

/// Whether a statement says how a surface looks, but no material can have it. `Ka` and `Ni` are in most libraries, as
/// defaults of the exporter, and not worth a remark.
fn is_lost(keyword: &[u8]) -> bool {
    let is_map = keyword.starts_with(b"map_") && keyword != b"map_aat";
    is_map || [&b"disp"[..], b"decal", b"refl", b"tf", b"pc", b"ps", b"aniso"].contains(&keyword)
}

/// Reads a color; one number stands for gray.
fn color_into(color: &mut Option<[f32; 3]>, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
    let red = finite(cursor)?;
    let is_gray = cursor.at_line_end() || cursor.peek() == Some(b'#');
    *color = Some(if is_gray { [red; 3] } else { [red, finite(cursor)?, finite(cursor)?] });
    Ok(())
}

fn number_into(number: &mut Option<f32>, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
    *number = Some(finite(cursor)?);
    Ok(())
}

fn finite(cursor: &mut Cursor<'_>) -> Result<f32, Fault> {
    let number = cursor.f32()?;
    if number.is_finite() { Ok(number) } else { Err(cursor.fault("the number is not finite")) }
}

/// Skips the option of `d` that makes opacity depend on the angle of view.
fn skip_halo(cursor: &mut Cursor<'_>) {
    let mut ahead = cursor.clone();
    if ahead.word().eq_ignore_ascii_case(b"-halo") {
        *cursor = ahead;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse_all(bytes: &[u8], wanted: &[&str]) -> (Library, Vec<String>) {
        let mut warnings = Warnings::of_file("x.obj");
        let library = parse(bytes, &wanted.iter().copied().collect(), "x.mtl", &mut warnings);
        (library, warnings.into_list().iter().map(ToString::to_string).collect())
    }

    #[test]
    fn statements_in_any_case_and_spacing() {
        let text = "\u{feff}# Blender 4.1.0 MTL File: 'x.blend'\r\nKd 9 9 9\r\n\r\n  newmtl  red paint \r\n\
            \tKD\t1  0.5 .25 # red\r\nkS 0.5\nNs 1e2\nd -halo 0.5\nTr 0.25\nKe 0 0 0\nPr 1\nPm .5\nillum 2\n\
            unknown 7 x\nmap_Bump -bm 2 a b.png\nnewmtl unused\nKd x\nnewmtl other\nMap_Kd C:\\x.png\n\
            newmtl red paint\nNs 5";
        let (library, warnings) = parse_all(text.as_bytes(), &["red paint", "other"]);
        assert!(warnings.is_empty(), "{warnings:?}");
        assert!(library.is_from_blender);
        let [red, other] = &library.materials[..] else { panic!("{library:?}") };
        assert_eq!((red.name.as_str(), red.line), ("red paint", 4));
        assert_eq!((red.diffuse, red.specular), (Some([1.0, 0.5, 0.25]), Some([0.5; 3])));
        assert_eq!((red.exponent, red.opacity, red.transparency), (Some(100.0), Some(0.5), Some(0.25)));
        assert_eq!((red.roughness, red.metallic, red.illumination), (Some(1.0), Some(0.5), Some(2)));
        assert_eq!(red.maps[&MapKind::Bump].name, "a b.png");
        assert_eq!(other.maps[&MapKind::Diffuse].name, "C:\\x.png");
    }

    #[test]
    fn malformed_statements_are_skipped() {
        let text = b"newmtl a\nKd 1 0\nKs x\nNs nan\nillum 1.5\nmap_Kd\nmap_Ke -s 1 1 1\nKd spectral x.rfl\n\
            map_Ks s.png\nTf 1 0 0\nd 0.5\n\xff\xfe 1\nKa 1 1 1\nmap_Ks t.png";
        let (library, warnings) = parse_all(text, &["a"]);
        let lines: Vec<&str> = warnings.iter().map(|w| w.split(": ").nth(1).unwrap()).collect();
        assert!(
            warnings[7].starts_with("x.mtl: line 9: `map_ks` has no counterpart in glTF"),
            "{}",
            warnings[7]
        );
        assert_eq!(lines, (2..=10).map(|line| format!("line {line}")).collect::<Vec<_>>());
        let expected =
            "x.mtl: line 2: expected a number, found the end of the line; the statement is skipped";
        assert_eq!(warnings[0], expected);
        let [a] = &library.materials[..] else { panic!("{library:?}") };
        assert_eq!((a.diffuse, a.specular, a.exponent, a.opacity), (None, None, None, Some(0.5)));
        assert!(a.maps.is_empty() && !library.is_from_blender);
    }
}
