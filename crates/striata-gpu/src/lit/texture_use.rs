//! How a material uses an image: sampling, texture coordinates and their transform.

/// How texture coordinates outside 0 to 1 are treated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum TextureWrap {
    /// The image repeats.
    #[default]
    Repeat,
    /// The image repeats, every other time mirrored.
    Mirror,
    /// The outermost pixels continue.
    Clamp,
}

/// How a value is found between pixels or mip levels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum TextureFilter {
    /// The nearest value.
    Nearest,
    /// A linear mix of the neighbors.
    #[default]
    Linear,
}

/// Sampling of a texture. The default repeats the image and filters linearly between pixels and mip levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct TextureSampler {
    /// Wrapping along u and v.
    pub wrap: [TextureWrap; 2],
    /// Filter if a pixel of the image covers more than a pixel of the screen.
    pub mag_filter: TextureFilter,
    /// Filter if a pixel of the image covers less than a pixel of the screen.
    pub min_filter: TextureFilter,
    /// Filter between mip levels; [`None`] uses only the full image.
    pub mip_filter: Option<TextureFilter>,
}

impl Default for TextureSampler {
    fn default() -> Self {
        Self {
            wrap: [TextureWrap::Repeat; 2],
            mag_filter: TextureFilter::Linear,
            min_filter: TextureFilter::Linear,
            mip_filter: Some(TextureFilter::Linear),
        }
    }
}

impl TextureSampler {
    /// Whether all filters are linear, as anisotropic filtering requires.
    pub(crate) fn is_linear(&self) -> bool {
        let filters = [Some(self.mag_filter), Some(self.min_filter), self.mip_filter];
        filters.iter().all(|&filter| filter == Some(TextureFilter::Linear))
    }
}

/// An image that a material uses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureUse {
    /// Index of the image.
    pub image: usize,
    /// Sampling.
    pub sampler: TextureSampler,
    /// Set of texture coordinates, 0 or 1.
    pub uv_set: u8,
    /// Transform of the texture coordinates, a row each for u and v: a factor of u, a factor of v, and an
    /// offset.
    pub uv_transform: [[f32; 3]; 2],
}

impl TextureUse {
    /// Uses an image with the default sampling, the first texture coordinates, and no transform.
    pub fn of(image: usize) -> Self {
        let uv_transform = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        Self { image, sampler: TextureSampler::default(), uv_set: 0, uv_transform }
    }
}
