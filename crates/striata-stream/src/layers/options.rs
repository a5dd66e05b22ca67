//! How many bits attributes get.

use striata::mesh::Semantic;

use crate::format::grid::MAX_BITS;

/// How many bits attributes get.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct LayerOptions {
    /// For each of the two numbers that a unit normal or tangent becomes, 2 to 16; 10 by default.
    pub normal_bits: u32,
    /// For texture coordinates, 1 to 24, over their range; 12 by default.
    pub texcoord_bits: u32,
    /// For colors given as floats, 1 to 24; 8 by default.
    pub color_bits: u32,
    /// For weights of joints given as floats, 1 to 24; 10 by default.
    pub weight_bits: u32,
    /// For morph targets and everything else that is floats, 1 to 24; 12 by default.
    pub generic_bits: u32,
    /// Keep every bit of all layers; false by default.
    pub lossless: bool,
}

impl Default for LayerOptions {
    fn default() -> Self {
        Self {
            normal_bits: 10,
            texcoord_bits: 12,
            color_bits: 8,
            weight_bits: 10,
            generic_bits: 12,
            lossless: false,
        }
    }
}

impl LayerOptions {
    /// Other bits for normals and tangents.
    pub fn with_normal_bits(mut self, bits: u32) -> Self {
        self.normal_bits = bits;
        self
    }

    /// Other bits for texture coordinates.
    pub fn with_texcoord_bits(mut self, bits: u32) -> Self {
        self.texcoord_bits = bits;
        self
    }

    /// Other bits for colors.
    pub fn with_color_bits(mut self, bits: u32) -> Self {
        self.color_bits = bits;
        self
    }

    /// Other bits for weights.
    pub fn with_weight_bits(mut self, bits: u32) -> Self {
        self.weight_bits = bits;
        self
    }

    /// Other bits for everything else.
    pub fn with_generic_bits(mut self, bits: u32) -> Self {
        self.generic_bits = bits;
        self
    }

    /// Whether every bit is kept.
    pub fn with_lossless(mut self, lossless: bool) -> Self {
        self.lossless = lossless;
        self
    }

    /// Checks that all bits are within their limits.
    ///
    /// # Errors
    /// [`LayerBitsError`] naming the first that is not.
    pub fn check(&self) -> Result<(), LayerBitsError> {
        let check = |what, bits, least, most| {
            if (least..=most).contains(&bits) {
                Ok(())
            } else {
                Err(LayerBitsError { what, bits, least, most })
            }
        };
        check("normals", self.normal_bits, 2, 16)?;
        check("texture coordinates", self.texcoord_bits, 1, MAX_BITS)?;
        check("colors", self.color_bits, 1, MAX_BITS)?;
        check("weights", self.weight_bits, 1, MAX_BITS)?;
        check("other layers", self.generic_bits, 1, MAX_BITS)
    }

    /// The bits of the numbers of a layer.
    pub(super) fn bits_of(&self, semantic: &Semantic) -> u32 {
        match semantic {
            Semantic::Normal | Semantic::Tangent => self.normal_bits,
            Semantic::TexCoord(_) => self.texcoord_bits,
            Semantic::Color(_) => self.color_bits,
            Semantic::Weights(_) => self.weight_bits,
            _ => self.generic_bits,
        }
    }
}

/// A number of bits that a kind of layer cannot have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{bits} bits asked for {what}, but it must be {least} to {most}")]
pub struct LayerBitsError {
    /// The kind of layer.
    pub what: &'static str,
    /// Bits asked for.
    pub bits: u32,
    /// Fewest that it can have.
    pub least: u32,
    /// Most that it can have.
    pub most: u32,
}
