//! Materials and images of a mesh, carried along from import to export.

/// A material, as its source file names it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Material {
    /// The material's name; may be empty.
    pub name: String,
    /// The material as a glTF `material` object in JSON; empty if only the name is known.
    pub gltf_json: String,
}

/// An image, which materials refer to by its index in [`Appearance::images`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Image {
    /// The image's name; may be empty.
    pub name: String,
    /// Location of the image relative to the source file; empty for an embedded image.
    pub uri: String,
    /// MIME type such as `image/png` or `image/jpeg`; may be empty if only `uri` is known.
    pub mime_type: String,
    /// Contents of the image file; empty if the reference could not be resolved.
    pub bytes: Vec<u8>,
}

/// Meaning of the numbers of vertex colors, which the formats of files decide.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColorSpace {
    /// As they are shown: PLY, OBJ, OFF, VTK, and arrays of programs.
    #[default]
    Srgb,
    /// Amounts of light: glTF and 3MF.
    Linear,
}

impl ColorSpace {
    /// Amount of light of a channel. NaN and negative values give 0, and no sRGB value gives more than 1.
    pub fn light_of(self, value: f32) -> f32 {
        let x = value.max(0.0);
        match self {
            Self::Linear => x,
            Self::Srgb if x <= 0.040_45 => x / 12.92,
            Self::Srgb => ((x.min(1.0) + 0.055) / 1.055).powf(2.4),
        }
    }
}

/// Everything a mesh carries along for its appearance; striata does not interpret it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Appearance {
    /// Materials, indexed by [`TriangleGroup::material`](super::TriangleGroup).
    pub materials: Vec<Material>,
    /// Images, indexed by glTF textures.
    pub images: Vec<Image>,
    /// glTF `texture` objects, one JSON string each.
    pub textures_json: Vec<String>,
    /// glTF `sampler` objects, one JSON string each.
    pub samplers_json: Vec<String>,
    /// Names of the glTF extensions that the objects above use.
    pub extensions_used: Vec<String>,
    /// File names of OBJ material libraries.
    pub material_libraries: Vec<String>,
    /// Meaning of the numbers of vertex colors.
    pub color_space: ColorSpace,
    /// Place on the Earth of a terrain, whose up is z: a JSON object (`origin`, `epsg`, ...); empty if unknown.
    pub georeference: String,
}

impl Appearance {
    /// Whether there is nothing to carry along.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}
