//! Colors of facets in the attribute words of binary STL.
//!
//! Two forms are in use, both with 5 bits per channel. VisCAM and SolidView: bit 15 marks a color, blue in the
//! lowest bits. Materialise Magics: the header contains `COLOR=` and the color of the body, bit 15 marks facets of
//! that color, and red is in the lowest bits. Words of neither form are kept as numbers. The writer uses the
//! first form.

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use crate::error::Place;
use crate::report::Warnings;

/// Marks a color in the form of VisCAM, and a facet in the color of the body in that of Magics.
const MARK: u16 = 1 << 15;
/// Name of the layer of words that are no colors.
const WORDS: &str = "attribute";

/// The attribute word of a facet.
#[inline]
pub(crate) fn word_of(facet: &[u8]) -> u16 {
    u16::from_le_bytes([facet[48], facet[49]])
}

/// Meaning of the attribute words of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum FacetForm {
    /// Numbers.
    Words,
    /// Colors; those of facets without one are white.
    Colors,
    /// Colors; that of the body belongs to facets without one.
    BodyColors([u8; 3]),
}

impl FacetForm {
    /// Returns the form of a file; [`None`] if all words are zero.
    pub(crate) fn of(bytes: &[u8], words: impl Iterator<Item = u16>) -> Option<Self> {
        let all_words = words.fold(0, |all, word| all | word);
        match body_color(&bytes[..80]) {
            _ if all_words == 0 => None,
            Some(body) => Some(Self::BodyColors(body)),
            None if all_words & MARK == 0 => Some(Self::Words),
            None => Some(Self::Colors),
        }
    }

    /// Returns the layer of some facets.
    pub(crate) fn layer(self, words: impl Iterator<Item = u16>) -> AttributeLayer {
        let (semantic, component_count, normalized, data) = match self {
            Self::Words => (Semantic::Generic(WORDS.to_owned()), 1, false, LayerData::U16(words.collect())),
            _ => {
                let colors = words.flat_map(|word| self.color(word));
                (Semantic::Color(0), 3, true, LayerData::U8(colors.collect()))
            }
        };
        AttributeLayer { semantic, component_count, normalized, data }
    }

    fn color(self, word: u16) -> [u8; 3] {
        match self {
            Self::BodyColors(body) if word & MARK != 0 => body,
            Self::BodyColors(_) => [word, word >> 5, word >> 10].map(byte_of),
            _ if word & MARK == 0 => [u8::MAX; 3],
            _ => [word >> 10, word >> 5, word].map(byte_of),
        }
    }

    /// Warns of facets without a color.
    pub(crate) fn warn(self, words: impl ExactSizeIterator<Item = u16>, warnings: &mut Warnings) {
        let count = words.len();
        let bare_count = words.filter(|word| word & MARK == 0).count();
        if self == Self::Colors && bare_count > 0 {
            let reason = format!("{bare_count} of {count} facets have no color; they become white");
            warnings.push(Place::File, reason);
        }
    }
}

/// The color of the body in a header of Magics.
fn body_color(header: &[u8]) -> Option<[u8; 3]> {
    let at = header.windows(6).position(|window| window == b"COLOR=")?;
    header.get(at + 6..)?.first_chunk().copied()
}

fn byte_of(five_bits: u16) -> u8 {
    ((u32::from(five_bits & 31) * 255 + 15) / 31) as u8
}

fn five_bits_of(share: f32) -> u16 {
    (share.clamp(0.0, 1.0) * 31.0).round() as u16
}

/// Returns the layer that the writer stores in the words of the facets.
pub(super) fn stored(mesh: &IndexedMesh) -> Option<&AttributeLayer> {
    let is_stored = |layer: &&AttributeLayer| match (&layer.semantic, &layer.data) {
        (Semantic::Color(0), _) => matches!(layer.component_count, 3 | 4),
        (Semantic::Generic(name), LayerData::U16(_)) => name == WORDS && layer.component_count == 1,
        _ => false,
    };
    mesh.triangle_layers.iter().find(is_stored)
}

/// Whether a layer is stored without a loss: the channels have 5 bits, and there is no alpha.
pub(crate) fn is_exact(mesh: &IndexedMesh, layer: &AttributeLayer) -> Option<bool> {
    stored(mesh).filter(|stored| stored.semantic == layer.semantic)?;
    let LayerData::U8(bytes) = &layer.data else { return Some(layer.semantic != Semantic::Color(0)) };
    let is_kept = |&byte: &u8| byte_of(five_bits_of(f32::from(byte) / 255.0)) == byte;
    Some(layer.component_count == 3 && layer.normalized && bytes.iter().all(is_kept))
}

/// The word of a triangle.
pub(super) fn word_to_store(layer: &AttributeLayer, triangle: usize) -> u16 {
    if let LayerData::U16(words) = &layer.data
        && layer.component_count == 1
    {
        return words[triangle];
    }
    let [red, green, blue] = [0, 1, 2].map(|channel| five_bits_of(layer.get(triangle, channel)));
    MARK | red << 10 | green << 5 | blue
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(header: &[u8], words: &[u16]) -> Vec<u8> {
        let mut bytes = header.to_vec();
        bytes.resize(80, 0);
        bytes.extend((words.len() as u32).to_le_bytes());
        for (i, word) in words.iter().enumerate() {
            let corners = [0.0, 0.0, i as f32, 1.0, 0.0, i as f32, 0.0, 1.0, i as f32];
            bytes.extend([0.0f32; 3].iter().chain(&corners).flat_map(|x| x.to_le_bytes()));
            bytes.extend(word.to_le_bytes());
        }
        bytes
    }

    fn read(bytes: &[u8]) -> IndexedMesh {
        super::super::read(bytes, &mut Warnings::of_file("a.stl")).unwrap()
    }

    #[test]
    fn colors_of_both_forms_are_read_and_written() {
        let mesh = read(&file(b"x", &[0xFC00, 0x801F, 0x83E0, 0x8421]));
        let colors = LayerData::U8(vec![255, 0, 0, 0, 0, 255, 0, 255, 0, 8, 8, 8]);
        assert_eq!(mesh.triangle_layers[0].data, colors);
        let written = super::super::to_bytes(&mesh, &mut Warnings::of_file("a.stl")).unwrap();
        assert_eq!(read(&written).triangle_layers, mesh.triangle_layers);
        assert_eq!(is_exact(&mesh, &mesh.triangle_layers[0]), Some(true));
        let magics = read(&file(b"COLOR=\x01\x02\x03\xff", &[0x001F, 0x8000, 0x7C00]));
        assert_eq!(magics.triangle_layers[0].data, LayerData::U8(vec![255, 0, 0, 1, 2, 3, 0, 0, 255]));
    }

    #[test]
    fn other_words_are_numbers() {
        let mesh = read(&file(b"x", &[7, 0, 9]));
        assert_eq!(mesh.triangle_layers[0].data, LayerData::U16(vec![7, 0, 9]));
        assert_eq!(
            read(&super::super::to_bytes(&mesh, &mut Warnings::of_file("a.stl")).unwrap()).triangle_layers,
            mesh.triangle_layers
        );
        assert!(read(&file(b"x", &[0, 0])).triangle_layers.is_empty());
    }
}
