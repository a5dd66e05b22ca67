//! Textures of OBJ and PLY files, as the glTF textures, samplers and images of an [`Appearance`].
//!
//! Each file is read once and becomes one image, whatever names refer to it. An image whose file is missing
//! keeps its name as a URI, as in glTF files, so that it can be found later.

use std::collections::{BTreeMap, BTreeSet};

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use serde_json::{Value, json};
use striata::mesh::{Appearance, Image, Material};

use crate::Source;
use crate::companions::{Companions, NameKind};
use crate::error::Place;
use crate::gltf_json::extensions_in;
use crate::images::{ImageBudget, image_from_afar, media_type, png_of};
use crate::report::Warnings;
pub(crate) use crate::report::shortened;

/// Wrap mode of samplers.
const CLAMP_TO_EDGE: u32 = 33071;

/// Images and textures found so far.
pub(crate) struct TextureSet<'a> {
    companions: Companions<'a>,
    budget: ImageBudget,
    files: Vec<TextureFile>,
    file_of_path: BTreeMap<String, usize>,
    image_count: usize,
    textures: Vec<Value>,
    texture_of: BTreeMap<(usize, bool), usize>,
    /// Whether some texture uses the only sampler.
    clamps: bool,
    /// Combined images most of which is translucent.
    translucent: BTreeSet<usize>,
}

/// A file, whether or not a texture uses it.
struct TextureFile {
    image: Image,
    /// Index among the images, once a texture uses it.
    index: Option<usize>,
}

/// Text of a file that names a texture, for messages and for finding it.
pub(crate) struct TextureName<'n> {
    /// Name of the texture's file.
    pub name: &'n str,
    /// Folder of the file that names it, relative to that of the source.
    pub folder: &'n str,
    /// Name of the file that names it.
    pub file: &'n str,
    pub place: Place,
}

impl<'a> TextureSet<'a> {
    /// Creates an empty set for a file of `input_bytes`.
    pub(crate) fn new(source: &Source<'a>, input_bytes: u64) -> Self {
        Self {
            companions: Companions::new(source),
            budget: ImageBudget::new(input_bytes),
            files: Vec::new(),
            file_of_path: BTreeMap::new(),
            image_count: 0,
            textures: Vec::new(),
            texture_of: BTreeMap::new(),
            clamps: false,
            translucent: BTreeSet::new(),
        }
    }

    /// Returns the files next to the source.
    pub(crate) fn companions(&mut self) -> &mut Companions<'a> {
        &mut self.companions
    }

    /// Returns the budget for reading companions.
    pub(crate) fn budget(&mut self) -> &mut ImageBudget {
        &mut self.budget
    }

    /// Reads a texture's file, unless it is known, and returns its number among all files. [`None`] if the
    /// name is not that of a file.
    pub(crate) fn file(&mut self, texture: &TextureName<'_>, warnings: &mut Warnings) -> Option<usize> {
        let mut warn = |reason: String| {
            let reason = format!("texture `{}`: {reason}", shortened(texture.name));
            warnings.push_for(texture.file, texture.place.clone(), reason);
        };
        let companion = self.companions.find(texture.folder, texture.name, NameKind::Plain);
        if companion.file_name().is_empty() || companion.file_name() == ".." {
            warn("not the name of a file".to_owned());
            return None;
        }
        // Names that differ in case or in `./` lead to the same file.
        let key = match &companion.file {
            Ok(found) => found.path.to_string_lossy().into_owned(),
            Err(_) => companion.relative.clone(),
        };
        if let Some(&known) = self.file_of_path.get(&key) {
            return Some(known);
        }
        let (name, uri) = (companion.file_name().to_owned(), to_uri(&companion.relative));
        let is_outside = companion.is_outside();
        let read = companion
            .file
            .and_then(|found| self.budget.read(found.file).map_err(|error| error.to_string()))
            .and_then(|bytes| image_from_afar(bytes, &name, is_outside));
        let bytes = read.unwrap_or_else(|reason| {
            warn(reason);
            Vec::new()
        });
        let (bytes, damage) = match png_of(&bytes, &name) {
            Some(Ok(png)) => (png, None),
            Some(Err(damage)) => (bytes, Some(damage)),
            None => (bytes, None),
        };
        let mime_type = media_type(&bytes).to_owned();
        if !bytes.is_empty() && mime_type.is_empty() {
            let found = damage.unwrap_or_else(|| "not PNG or JPEG, which glTF requires".to_owned());
            warn(format!("{found}; it stays a reference to the file"));
        }
        self.files.push(TextureFile { image: Image { name, uri, mime_type, bytes }, index: None });
        self.file_of_path.insert(key, self.files.len() - 1);
        Some(self.files.len() - 1)
    }

    /// Returns the bytes of a file; empty if they are missing.
    #[cfg(feature = "obj")]
    pub(crate) fn bytes(&self, file: usize) -> &[u8] {
        &self.files[file].image.bytes
    }

    /// Adds the base color of `color` (white if there is none) with the opacity of `mask`, and returns the
    /// number of the new file and whether most of it is translucent.
    #[cfg(all(feature = "obj", feature = "images"))]
    pub(crate) fn masked(
        &mut self,
        color: Option<usize>,
        mask: usize,
        channel: Option<u8>,
    ) -> Result<(usize, bool), String> {
        let key = format!("{color:?} with {mask} {channel:?}");
        let file = match self.file_of_path.get(&key) {
            Some(&known) => known,
            None => {
                let color_bytes = color.map(|color| self.bytes(color));
                let masked = crate::image_pixels::masked(color_bytes, self.bytes(mask), channel)?;
                self.budget.take(masked.png.len() as u64).map_err(|error| error.to_string())?;
                let named = &self.files[color.unwrap_or(mask)].image;
                let with_ending = |path: &str| {
                    let stem = path.rsplit_once('.').map_or(path, |(stem, _)| stem);
                    format!("{stem}_alpha.png")
                };
                let (name, uri) = (with_ending(&named.name), with_ending(&named.uri));
                let (mime_type, bytes) = ("image/png".to_owned(), masked.png);
                let image = Image { name, uri, mime_type, bytes };
                self.files.push(TextureFile { image, index: None });
                self.file_of_path.insert(key, self.files.len() - 1);
                self.translucent.extend(masked.is_translucent.then_some(self.files.len() - 1));
                self.files.len() - 1
            }
        };
        Ok((file, self.translucent.contains(&file)))
    }

    /// Without the feature `images`, nothing is decoded.
    #[cfg(all(feature = "obj", not(feature = "images")))]
    pub(crate) fn masked(
        &mut self,
        _color: Option<usize>,
        _mask: usize,
        _channel: Option<u8>,
    ) -> Result<(usize, bool), String> {
        Err("it cannot be combined with the base color: the feature `images` is off".to_owned())
    }

    /// Returns the index of the texture that shows a file.
    pub(crate) fn texture(&mut self, file: usize, clamps: bool) -> usize {
        if let Some(&known) = self.texture_of.get(&(file, clamps)) {
            return known;
        }
        let (files, count) = (&mut self.files, &mut self.image_count);
        let image = *files[file].index.get_or_insert_with(|| {
            *count += 1;
            *count - 1
        });
        let mut texture = source_of(&files[file].image.mime_type, image);
        if clamps {
            texture["sampler"] = json!(0);
            self.clamps = true;
        }
        self.textures.push(texture);
        self.texture_of.insert((file, clamps), self.textures.len() - 1);
        self.textures.len() - 1
    }

    /// Returns the appearance with these materials, which are glTF objects.
    pub(crate) fn into_appearance(
        mut self,
        materials: Vec<Material>,
        material_values: &[Value],
    ) -> Appearance {
        self.files.retain(|file| file.index.is_some());
        self.files.sort_by_key(|file| file.index);
        let mut extensions = BTreeSet::new();
        material_values.iter().chain(&self.textures).for_each(|value| extensions_in(value, &mut extensions));
        let sampler = json!({ "wrapS": CLAMP_TO_EDGE, "wrapT": CLAMP_TO_EDGE });
        Appearance {
            materials,
            images: self.files.into_iter().map(|file| file.image).collect(),
            textures_json: self.textures.iter().map(Value::to_string).collect(),
            samplers_json: if self.clamps { vec![sampler.to_string()] } else { Vec::new() },
            extensions_used: extensions.into_iter().collect(),
            ..Appearance::default()
        }
    }
}

/// Returns a glTF texture with its image; formats other than PNG and JPEG need an extension.
fn source_of(mime_type: &str, image: usize) -> Value {
    let extension = match mime_type {
        "image/webp" => "EXT_texture_webp",
        "image/ktx2" => "KHR_texture_basisu",
        "image/vnd-ms.dds" => "MSFT_texture_dds",
        _ => return json!({ "source": image }),
    };
    json!({ "extensions": { extension: { "source": image } } })
}

/// Returns a relative path as a URI: bytes that URIs reserve become percent escapes.
fn to_uri(path: &str) -> String {
    const RESERVED: AsciiSet =
        NON_ALPHANUMERIC.remove(b'/').remove(b'-').remove(b'.').remove(b'_').remove(b'~');
    utf8_percent_encode(path, &RESERVED).to_string()
}
