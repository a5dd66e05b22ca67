//! Readings of a name: the paths that it may mean, which are tried one after another.

use std::borrow::Cow;
use std::fmt;

use percent_encoding::percent_decode_str;

/// Kind of text that names a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NameKind {
    /// File name, as in OBJ, MTL and PLY. An absolute one (`C:\art\wood.png`) stands for the file name alone,
    /// because textures usually travel with the model.
    #[cfg_attr(not(any(feature = "ply", feature = "obj")), allow(dead_code, reason = "glTF has URIs"))]
    Plain,
    /// URI, as in glTF: percent escapes come first, and nothing absolute is read.
    #[cfg_attr(not(feature = "gltf"), allow(dead_code, reason = "only glTF has URIs"))]
    Uri,
}

/// Path relative to the folder of the source, without `.` and with all `..` in front.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RelativePath {
    /// Number of folders above that of the source.
    pub ups: usize,
    pub parts: Vec<String>,
}

impl fmt::Display for RelativePath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (0..self.ups).try_for_each(|_| f.write_str("../"))?;
        f.write_str(&self.parts.join("/"))
    }
}

impl RelativePath {
    fn of(folder: &str, name: &str, is_separator: fn(char) -> bool) -> Self {
        let mut path = Self { ups: 0, parts: Vec::new() };
        for part in folder.split('/').chain(name.split(is_separator)) {
            match part {
                "" | "." => {}
                ".." if path.parts.pop().is_none() => path.ups += 1,
                ".." => {}
                part => path.parts.push(part.to_owned()),
            }
        }
        path
    }
}

/// Readings of one name.
#[derive(Debug)]
pub(super) struct Names {
    /// The usual reading, for a file that does not exist.
    pub usual: RelativePath,
    /// All readings, in the order in which they are tried.
    pub candidates: Vec<RelativePath>,
    is_absolute: bool,
}

impl Names {
    /// Finds the readings of a name; an error says why there is none.
    pub(super) fn of(folder: &str, name: &str, kind: NameKind) -> Result<Self, String> {
        let decoded = percent_decode_str(name).decode_utf8().unwrap_or(Cow::Borrowed(name));
        let is_absolute = is_absolute(name) || kind == NameKind::Uri && is_absolute(&decoded);
        if is_absolute {
            return match kind {
                NameKind::Plain => Ok(Self::file_name_of(folder, name)),
                NameKind::Uri => Err(absolute_uri(&decoded)),
            };
        }
        let texts = match kind {
            NameKind::Plain => [name, &*decoded],
            NameKind::Uri => [&*decoded, name],
        };
        let usual = RelativePath::of(folder, texts[0], is_any_separator);
        let mut candidates: Vec<RelativePath> = Vec::new();
        for text in texts {
            let before_query = text.split(['?', '#']).next().unwrap_or(text);
            for text in [text, before_query] {
                for is_separator in [(|c| c == '/') as fn(char) -> bool, is_any_separator] {
                    let path = RelativePath::of(folder, text, is_separator);
                    if !candidates.contains(&path) {
                        candidates.push(path);
                    }
                }
            }
        }
        Ok(Self { usual, candidates, is_absolute })
    }

    /// The file name of an absolute path, in the folder of the file that names it.
    fn file_name_of(folder: &str, name: &str) -> Self {
        // `C:x` has no separator, but is relative to the current folder of a drive.
        let last = name.rsplit(['/', '\\', ':']).next().filter(|last| *last != "..").unwrap_or("");
        let usual = RelativePath::of(folder, last, is_any_separator);
        Self { candidates: vec![usual.clone()], usual, is_absolute: true }
    }

    /// Returns the reason if no reading exists.
    pub(super) fn not_found(&self) -> String {
        match self.is_absolute {
            true => format!("not found; it is absolute, and there is no `{}`", self.usual),
            false => "not found".to_owned(),
        }
    }
}

fn is_any_separator(letter: char) -> bool {
    matches!(letter, '/' | '\\')
}

fn is_absolute(name: &str) -> bool {
    let is_drive = matches!(name.as_bytes(), [letter, b':', ..] if letter.is_ascii_alphabetic());
    is_drive || name.starts_with(is_any_separator) || scheme_of(name).is_some()
}

/// Returns the scheme of a URI: `https` of `https://a/b`, `file` of `file:/a/b`.
fn scheme_of(name: &str) -> Option<&str> {
    let (scheme, rest) = name.split_once(':')?;
    let is_word =
        !scheme.is_empty() && scheme.bytes().all(|b| b.is_ascii_alphanumeric() || b"+-.".contains(&b));
    let is_scheme = rest.starts_with('/') || scheme.eq_ignore_ascii_case("file");
    (is_word && is_scheme).then_some(scheme)
}

/// Returns why an absolute URI is not followed.
fn absolute_uri(uri: &str) -> String {
    match scheme_of(uri).filter(|scheme| scheme.len() > 1) {
        Some(scheme) => format!("only files next to this one are read, nothing from `{scheme}:`"),
        None => "it is an absolute path; only files next to this one are read".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_relative_paths() {
        for (folder, name, expected) in [
            ("", "a b.png", "a b.png"),
            ("", r"maps\\wood\a.png", "maps/wood/a.png"),
            ("mtl", "./a.png", "mtl/a.png"),
            ("mtl/x", "../../a.png", "a.png"),
            ("mtl", "../../a.png", "../a.png"),
            ("", "../../a.png", "../../a.png"),
            ("../mtl", "../maps/a.png", "../maps/a.png"),
            ("", "a/../../b/../c", "../c"),
            ("mtl", r"C:\art\wood.png", "mtl/wood.png"),
            ("", "C:wood.png", "wood.png"),
            ("", "/etc/passwd", "passwd"),
            ("", r"\\server\share\..", ""),
            ("", "file:///a/b.png", "b.png"),
            ("", "wood: dark.png", "wood: dark.png"),
        ] {
            let names = Names::of(folder, name, NameKind::Plain).unwrap();
            assert_eq!(names.usual.to_string(), expected, "{folder} {name}");
        }
    }

    #[test]
    fn readings_are_tried_in_order() {
        let readings = |name, kind| -> Vec<String> {
            Names::of("", name, kind).unwrap().candidates.iter().map(ToString::to_string).collect()
        };
        assert_eq!(readings(r"a\b%20c", NameKind::Uri), [r"a\b c", "a/b c", r"a\b%20c", "a/b%20c"]);
        assert_eq!(readings("a%20b", NameKind::Plain), ["a%20b", "a b"]);
        assert_eq!(readings("a.png?v=3", NameKind::Uri), ["a.png?v=3", "a.png"]);
        assert_eq!(readings("%2e%2e/x", NameKind::Uri), ["../x", "%2e%2e/x"]);
    }

    #[test]
    fn absolute_uris_are_refused_by_kind() {
        for (uri, reason) in [
            ("/etc/passwd", "an absolute path"),
            ("%2Fetc/passwd", "an absolute path"),
            ("C:\\x", "an absolute path"),
            ("\\\\server\\x", "an absolute path"),
            ("file:///x", "nothing from `file:`"),
            ("http://x/y", "nothing from `http:`"),
        ] {
            let found = Names::of("", uri, NameKind::Uri).unwrap_err();
            assert!(found.contains(reason), "{uri}: {found}");
        }
    }
}
