//! What groups of triangles look like: material names, and what is kept of a glTF's materials.

/// One material as its source names it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Material {
    /// The material's name; may be empty.
    pub name: String,
    /// The material as a glTF `material` object in JSON; empty where the source was no glTF.
    pub gltf_json: String,
}

/// An image that materials refer to by its place in [`Appearance::images`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Image {
    /// The image's name; may be empty.
    pub name: String,
    /// Where the source found it, relative to the source; empty for an embedded image.
    pub uri: String,
    /// `image/png`, `image/jpeg`, …; may be empty where only `uri` is known.
    pub mime_type: String,
    /// The file's bytes; empty where the reference could not be followed.
    pub bytes: Vec<u8>,
}

/// All that a mesh carries along for looks; striata itself never interprets it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Appearance {
    /// Materials, by the index that [`TriangleGroup::material`](super::TriangleGroup) holds.
    pub materials: Vec<Material>,
    /// Images, by the index that glTF textures hold.
    pub images: Vec<Image>,
    /// glTF `texture` objects in JSON, one each.
    pub textures_json: Vec<String>,
    /// glTF `sampler` objects in JSON, one each.
    pub samplers_json: Vec<String>,
    /// glTF extensions that the objects above use.
    pub extensions_used: Vec<String>,
    /// OBJ material libraries by file name.
    pub material_libraries: Vec<String>,
}

impl Appearance {
    /// Nothing to carry.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}
