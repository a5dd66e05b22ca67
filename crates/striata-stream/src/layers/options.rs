//! Number of bits for each kind of attribute.

use striata::mesh::Semantic;

use crate::format::grid::MAX_BITS;

/// Number of bits that each kind of attribute is quantized to.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct LayerOptions {
    /// Bits for each of the two coordinates that encode a unit normal or tangent, 2 to 16; 10 by default.
    pub normal_bits: u32,
    /// Bits for texture coordinates over their range, 1 to 24; 12 by default.
    pub texcoord_bits: u32,
    /// Bits for colors that are stored as floats, 1 to 24; 8 by default.
    pub color_bits: u32,
    /// Bits for joint weights that are stored as floats, 1 to 24; 10 by default.
    pub weight_bits: u32,
    /// Bits for morph targets and all other float layers, 1 to 24; 12 by default. Layers with identifiers
    /// ([`AttributeLayer::has_identifiers`](striata::mesh::AttributeLayer::has_identifiers)) are exact
    /// whatever it is.
    pub generic_bits: u32,
    /// Whether to keep every bit of all layers; false by default.
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
    /// Sets [`Self::normal_bits`].
    pub fn with_normal_bits(mut self, bits: u32) -> Self {
        self.normal_bits = bits;
        self
    }

    /// Sets [`Self::texcoord_bits`].
    pub fn with_texcoord_bits(mut self, bits: u32) -> Self {
        self.texcoord_bits = bits;
        self
    }

    /// Sets [`Self::color_bits`].
    pub fn with_color_bits(mut self, bits: u32) -> Self {
        self.color_bits = bits;
        self
    }

    /// Sets [`Self::weight_bits`].
    pub fn with_weight_bits(mut self, bits: u32) -> Self {
        self.weight_bits = bits;
        self
    }

    /// Sets [`Self::generic_bits`].
    pub fn with_generic_bits(mut self, bits: u32) -> Self {
        self.generic_bits = bits;
        self
    }

    /// Sets [`Self::lossless`].
    pub fn with_lossless(mut self, lossless: bool) -> Self {
        self.lossless = lossless;
        self
    }

    /// Checks that every number of bits is within its limits.
    ///
    /// # Errors
    /// [`LayerBitsError`] describing the first one that is not.
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

    /// Returns the number of bits for a layer with this semantic.
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

/// The requested number of bits is not allowed for this kind of layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what} cannot have {bits} bits: the number must be {least} to {most}")]
pub struct LayerBitsError {
    /// Kind of layer, in words.
    pub what: &'static str,
    /// Requested number of bits.
    pub bits: u32,
    /// Smallest number of bits allowed.
    pub least: u32,
    /// Largest number of bits allowed.
    pub most: u32,
}
