//! Texture statements of a material: a file name with options such as `-s 2 2 1`.

use crate::text::Cursor;

/// A texture with the options that glTF can express.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TextureStatement {
    /// Name of the file, which may contain blanks.
    pub name: String,
    pub line: u64,
    /// `-s`: factor of the coordinates.
    pub scale: [f32; 2],
    /// `-o`: offset of the coordinates, added after scaling; `v` grows upward.
    pub offset: [f32; 2],
    /// `-bm`: factor of bumps and normals.
    pub bump_scale: f32,
    /// `-clamp on`: whether the texture does not repeat.
    pub clamps: bool,
    /// `-imfchan`: letter of the channel that is used: `r`, `g`, `b`, `m` (alpha), `l` (brightness).
    pub channel: Option<u8>,
}

/// Arguments of an option.
#[derive(Clone, Copy)]
enum Arguments {
    /// One word.
    Word,
    /// As many numbers as there are between these limits.
    Numbers(usize, usize),
}

fn arguments_of(option: &[u8]) -> Option<Arguments> {
    Some(match option {
        b"-blendu" | b"-blendv" | b"-cc" | b"-clamp" | b"-imfchan" | b"-type" | b"-colorspace" => {
            Arguments::Word
        }
        b"-bm" | b"-boost" | b"-texres" => Arguments::Numbers(1, 1),
        b"-mm" => Arguments::Numbers(2, 2),
        b"-o" | b"-s" | b"-t" => Arguments::Numbers(1, 3),
        _ => return None,
    })
}

impl TextureStatement {
    /// Parses the words after the keyword; [`None`] if there is no file name.
    ///
    /// Options are also accepted after the name. Words that begin like an option but have no arguments of
    /// its kind belong to the name.
    pub(super) fn parse(text: &[u8], line: u64) -> Option<Self> {
        let mut statement = Self {
            name: String::new(),
            line,
            scale: [1.0; 2],
            offset: [0.0; 2],
            bump_scale: 1.0,
            clamps: false,
            channel: None,
        };
        // Start and end of the name.
        let mut name: Option<(usize, usize)> = None;
        let mut at = 0;
        while let Some((start, end)) = word_at(text, at) {
            if let Some(after) = statement.option(text, start, end) {
                at = after;
            } else {
                name = Some((name.map_or(start, |(first, _)| first), end));
                at = end;
            }
        }
        let (start, end) = name?;
        let found = &text[start..end];
        let unquoted = found.strip_prefix(b"\"").and_then(|f| f.strip_suffix(b"\"")).unwrap_or(found);
        statement.name = text_of(unquoted.trim_ascii());
        (!statement.name.is_empty()).then_some(statement)
    }

    /// Applies the option at `start..end`, and returns the end of its arguments; [`None`] if it is none.
    fn option(&mut self, text: &[u8], start: usize, end: usize) -> Option<usize> {
        let option = text[start..end].to_ascii_lowercase();
        let (least, most) = match arguments_of(&option)? {
            Arguments::Word => {
                let (from, to) = word_at(text, end)?;
                if option == b"-clamp" {
                    self.clamps = text[from..to].eq_ignore_ascii_case(b"on");
                } else if option == b"-imfchan" {
                    self.channel = text.get(from).map(u8::to_ascii_lowercase);
                }
                return Some(to);
            }
            Arguments::Numbers(least, most) => (least, most),
        };
        let (mut numbers, mut at) = (Vec::with_capacity(most), end);
        while numbers.len() < most
            && let Some((from, to)) = word_at(text, at)
            && let Ok(number) = Cursor::new(&text[from..to]).f32()
            && number.is_finite()
        {
            numbers.push(number);
            at = to;
        }
        if numbers.len() < least {
            return None;
        }
        let pair = |default: f32| [numbers[0], numbers.get(1).copied().unwrap_or(default)];
        match option.as_slice() {
            b"-s" => self.scale = pair(1.0),
            b"-o" => self.offset = pair(0.0),
            b"-bm" => self.bump_scale = numbers[0],
            _ => {}
        }
        Some(at)
    }

    /// Whether the coordinates are scaled or moved.
    pub(super) fn has_transform(&self) -> bool {
        self.scale != [1.0; 2] || self.offset != [0.0; 2]
    }
}

/// Returns the start and end of the next word from `at` on.
fn word_at(text: &[u8], at: usize) -> Option<(usize, usize)> {
    let start = at + text[at..].iter().position(|byte| !byte.is_ascii_whitespace())?;
    let length = text[start..].iter().position(u8::is_ascii_whitespace).unwrap_or(text.len() - start);
    Some((start, start + length))
}

/// Decodes a file name: UTF-8, or Latin-1 as older programs write it.
fn text_of(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().copied().map(char::from).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> TextureStatement {
        TextureStatement::parse(text.as_bytes(), 1).unwrap()
    }

    #[test]
    fn options_precede_or_follow_the_name() {
        let all = parse(r"-s 2 3 1 -o .5 -clamp on -mm 0 1 -bm 0.25 -imfchan l  maps\my  wood.png ");
        assert_eq!(
            (all.name.as_str(), all.scale, all.offset),
            (r"maps\my  wood.png", [2.0, 3.0], [0.5, 0.0])
        );
        assert_eq!((all.clamps, all.bump_scale, all.has_transform()), (true, 0.25, true));
        let after = parse("a.png -bm 2 -clamp off");
        assert_eq!((after.name.as_str(), after.bump_scale, after.clamps), ("a.png", 2.0, false));
    }

    #[test]
    fn unusual_names_are_kept() {
        for (text, name) in [
            ("-s.png", "-s.png"),
            ("-s 1 1 1 2.png", "2.png"),
            ("a -bm.png", "a -bm.png"),
            ("wood -s side.png", "wood -s side.png"),
            ("\"my wood.png\"", "my wood.png"),
            ("-type sphere \t x # y.png", "x # y.png"),
        ] {
            assert_eq!(parse(text).name, name, "{text}");
        }
        assert_eq!(TextureStatement::parse(b"gr\xfcn.png", 1).unwrap().name, "grün.png");
        for none in ["", "  ", "-s 1 2 3", "-clamp on", "\"\""] {
            assert_eq!(TextureStatement::parse(none.as_bytes(), 1), None, "{none}");
        }
    }
}
