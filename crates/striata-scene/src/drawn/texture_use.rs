//! How a material refers to an image: sampler, texture coordinates and their transform.

use serde_json::Value;
pub use striata::simplify::Wrap;

use super::json::{extension, number, numbers};
use crate::document::{entries, index};
use crate::textures::ImageFormat;

/// How an image is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sampler {
    /// Behavior outside the image, along u and v.
    pub wrap: [Wrap; 2],
    /// Whether enlarged pixels are interpolated.
    pub is_smooth: bool,
    /// Whether reduced copies are used for distant surfaces.
    pub has_mip_maps: bool,
}

impl Default for Sampler {
    fn default() -> Self {
        Self { wrap: [Wrap::Repeat; 2], is_smooth: true, has_mip_maps: true }
    }
}

/// Affine transform of texture coordinates: two rows of a 2 x 3 matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UvTransform(pub [[f32; 3]; 2]);

impl Default for UvTransform {
    fn default() -> Self {
        Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    }
}

impl UvTransform {
    /// Transforms texture coordinates.
    pub fn apply(&self, [u, v]: [f32; 2]) -> [f32; 2] {
        self.0.map(|[a, b, c]| a * u + b * v + c)
    }

    /// Reads `KHR_texture_transform`: first the scale, then the rotation, then the offset.
    fn read(transform: &Value) -> Self {
        let [scale_u, scale_v] = numbers(transform, "scale").unwrap_or([1.0; 2]);
        let [offset_u, offset_v] = numbers(transform, "offset").unwrap_or([0.0; 2]);
        // The platform's own functions would choose other levels on other machines.
        let (sin, cos) = libm::sincosf(number(transform, "rotation").unwrap_or(0.0));
        Self([[cos * scale_u, sin * scale_v, offset_u], [-sin * scale_u, cos * scale_v, offset_v]])
    }
}

/// A reference of a material to an image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureUse {
    /// Index of the image.
    pub image: usize,
    /// How the image is sampled.
    pub sampler: Sampler,
    /// Set of texture coordinates.
    pub uv_set: u8,
    /// Transform of the texture coordinates.
    pub transform: UvTransform,
}

/// Reads texture references of one document.
#[derive(Clone, Copy, Debug)]
pub struct TextureReader<'s> {
    /// The document: its textures and samplers.
    pub document: &'s Value,
    /// Its images, of which the first bytes are enough.
    pub images: &'s [striata::mesh::Image],
}

impl TextureReader<'_> {
    /// Reads a member that refers to a texture; [`None`] if it is absent or broken.
    pub fn read(&self, value: &Value, key: &str) -> Option<TextureUse> {
        let info = value.get(key)?;
        let texture = entries(self.document, "textures").get(index(info, "index")?)?;
        let sampler = index(texture, "sampler");
        let sampler = sampler.and_then(|sampler| entries(self.document, "samplers").get(sampler));
        let transform = extension(info, "KHR_texture_transform");
        let uv_set = transform.and_then(|transform| index(transform, "texCoord"));
        let uv_set = uv_set.or_else(|| index(info, "texCoord")).unwrap_or(0);
        Some(TextureUse {
            image: self.image_of(texture)?,
            sampler: sampler.map_or_else(Sampler::default, read_sampler),
            uv_set: u8::try_from(uv_set).ok()?,
            transform: transform.map(UvTransform::read).unwrap_or_default(),
        })
    }

    /// Returns the image of a texture: the first one that can be decoded, or else the first one.
    fn image_of(&self, texture: &Value) -> Option<usize> {
        let of = |name| extension(texture, name).and_then(|extension| index(extension, "source"));
        let others = ["EXT_texture_avif", "KHR_texture_basisu", "MSFT_texture_dds"];
        let sources = [of("EXT_texture_webp"), index(texture, "source")];
        let sources = sources.into_iter().chain(others.map(of)).flatten();
        let exists = |&image: &usize| image < self.images.len();
        let can_be_decoded = |&image: &usize| {
            let format = ImageFormat::detect(&self.images[image].bytes);
            format.is_some_and(ImageFormat::is_decoded)
        };
        let sources: Vec<usize> = sources.filter(exists).collect();
        sources.iter().copied().find(can_be_decoded).or(sources.first().copied())
    }
}

fn read_sampler(sampler: &Value) -> Sampler {
    const NEAREST: usize = 9728;
    const LINEAR: usize = 9729;
    let wrap = |key| match index(sampler, key) {
        Some(33071) => Wrap::ClampToEdge,
        Some(33648) => Wrap::MirroredRepeat,
        _ => Wrap::Repeat,
    };
    Sampler {
        wrap: [wrap("wrapS"), wrap("wrapT")],
        is_smooth: index(sampler, "magFilter") != Some(NEAREST),
        has_mip_maps: !matches!(index(sampler, "minFilter"), Some(NEAREST | LINEAR)),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use striata::mesh::Image;

    use super::*;

    fn image(bytes: &[u8]) -> Image {
        Image { bytes: bytes.to_vec(), ..Image::default() }
    }

    #[test]
    fn references_are_read_with_sampler_set_and_transform() {
        let document = json!({
            "textures": [{ "source": 1, "sampler": 0 }],
            "samplers": [{ "wrapS": 33071, "wrapT": 33648, "magFilter": 9728, "minFilter": 9729 }],
        });
        let images = [image(b""), image(b"\xff\xd8\xff")];
        let reader = TextureReader { document: &document, images: &images };
        let transform = json!({ "offset": [0.5, 0.25], "scale": [2, 4], "texCoord": 1 });
        let info = json!({
            "t": { "index": 0, "texCoord": 3, "extensions": { "KHR_texture_transform": transform } },
        });
        let found = reader.read(&info, "t").expect("a texture");
        assert_eq!((found.image, found.uv_set), (1, 1));
        let wrap = [Wrap::ClampToEdge, Wrap::MirroredRepeat];
        assert_eq!(found.sampler, Sampler { wrap, is_smooth: false, has_mip_maps: false });
        assert_eq!(found.transform.apply([1.0, 1.0]), [2.5, 4.25]);
        assert_eq!(reader.read(&json!({ "t": { "index": 9 } }), "t"), None);
        assert_eq!(reader.read(&json!({ "t": { "index": "x" } }), "t"), None);
    }

    #[test]
    fn a_quarter_turn_exchanges_u_and_v() {
        let turned = UvTransform::read(&json!({ "rotation": std::f64::consts::FRAC_PI_2 }));
        let [u, v] = turned.apply([0.25, 0.5]);
        assert!((u - 0.5).abs() < 1e-6 && (v + 0.25).abs() < 1e-6, "{u} {v}");
    }

    #[test]
    fn images_that_can_be_decoded_are_preferred() {
        let sources = |extension: &str| json!({ "textures": [{ "source": 0, "extensions": { extension: { "source": 1 } } }] });
        let [png, ktx] = [&b"\x89PNG\r\n\x1a\n"[..], b"\xabKTX 20\xbb"];
        let of = |document: &Value, images: [&[u8]; 2]| {
            let images = images.map(image);
            let reader = TextureReader { document, images: &images };
            reader.read(&json!({ "t": { "index": 0 } }), "t").map(|found| found.image)
        };
        assert_eq!(of(&sources("KHR_texture_basisu"), [png, ktx]), Some(0));
        assert_eq!(of(&sources("EXT_texture_webp"), [png, b"RIFF0000WEBP"]), Some(1));
        let only = json!({ "textures": [{ "extensions": { "KHR_texture_basisu": { "source": 1 } } }] });
        assert_eq!(of(&only, [png, ktx]), Some(1));
    }
}
