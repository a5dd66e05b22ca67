//! Base colors of the materials of a scene, for the cost of simplification.

use std::collections::BTreeMap;

use striata::mesh::IndexedMesh;
use striata::simplify::{BaseColor, TextureLevels};
use striata_io::Scene;

use super::image_store::{ImageLimits, decode_images};
use super::material::{AlphaMode, Material, materials};
use crate::single_mesh::sample_of;
use crate::textures::RgbaImage;

/// Longer images are reduced before their levels are made, pixels.
const MAX_SIDE: u32 = 512;

/// Returns the base color of each material of a scene, for
/// [`SequenceOptions::base_colors`](striata::simplify::SequenceOptions::base_colors). A color is unknown if
/// its texture cannot be decoded; if no material has a texture that can, the list is empty.
pub fn base_colors(scene: &Scene) -> Vec<Option<BaseColor>> {
    let mut colored: Vec<Material> = materials(scene).into_iter().map(without_other_textures).collect();
    let had_texture: Vec<bool> = colored.iter().map(|m| m.base_color_texture.is_some()).collect();
    if !had_texture.contains(&true) {
        return Vec::new();
    }
    let limits = ImageLimits::default().with_max_side(MAX_SIDE);
    let decoded =
        decode_images(scene, &mut colored, &limits, |count, decode| (0..count).map(decode).collect());
    let mut levels = ImageLevels { images: &decoded.images, known: BTreeMap::new() };
    if colored.iter().all(|material| material.base_color_texture.is_none()) {
        return Vec::new();
    }
    let of = |(material, had_texture): (&Material, bool)| match material.base_color_texture {
        None if had_texture => None,
        _ => levels.base_color(material),
    };
    colored.iter().zip(had_texture).map(of).collect()
}

/// Returns the base colors of a mesh's materials like [`base_colors`].
pub fn base_colors_of_mesh(mesh: &IndexedMesh) -> Vec<Option<BaseColor>> {
    Scene::from_mesh(sample_of(mesh)).map_or_else(|_| Vec::new(), |scene| base_colors(&scene))
}

fn without_other_textures(material: Material) -> Material {
    let Material { base_color, base_color_texture, alpha_mode, .. } = material;
    Material { base_color, base_color_texture, alpha_mode, ..Material::default() }
}

/// Levels of the images that have been needed so far.
struct ImageLevels<'d> {
    images: &'d [Option<RgbaImage>],
    known: BTreeMap<(usize, bool), Option<TextureLevels>>,
}

impl ImageLevels<'_> {
    fn base_color(&mut self, material: &Material) -> Option<BaseColor> {
        let [r, g, b, _] = material.base_color;
        let Some(texture) = material.base_color_texture else {
            let white = TextureLevels::new(1, 1, &[[u8::MAX; 4]], false)?;
            return Some(BaseColor { factor: [r, g, b], ..BaseColor::new(white) });
        };
        let has_alpha = material.alpha_mode != AlphaMode::Opaque;
        let image = self.images.get(texture.image)?.as_ref()?;
        let levels = self.known.entry((texture.image, has_alpha)).or_insert_with(|| {
            TextureLevels::new(image.width, image.height, image.rgba.as_chunks::<4>().0, has_alpha)
        });
        Some(BaseColor {
            texture: levels.clone()?,
            wrap: texture.sampler.wrap,
            texcoord_set: texture.uv_set,
            transform: texture.transform.0,
            factor: [r, g, b],
        })
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use serde_json::{Value, json};
    use striata::LodOptions;
    use striata::mesh::{Image, Material as MeshMaterial, Semantic, TriangleGroup, shapes};
    use striata::simplify::Wrap;

    use super::*;
    use crate::LodScene;

    fn png() -> Vec<u8> {
        let image = image::RgbImage::from_fn(4, 4, |x, y| image::Rgb([60 * x as u8, 60 * y as u8, 9]));
        let mut bytes = Cursor::new(Vec::new());
        image.write_to(&mut bytes, image::ImageFormat::Png).expect("writing to memory succeeds");
        bytes.into_inner()
    }

    /// A torus whose materials have this JSON; texture 0 shows the image.
    fn torus(materials: &[Value], image: &[u8]) -> IndexedMesh {
        let mut mesh = shapes::torus(24, 12, 1.0, 0.4);
        let uvs = mesh.positions.iter().flat_map(|p| [p[0], p[1] * p[2]]).collect();
        mesh.layers.push(striata::mesh::AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs));
        let of = |json: &Value| MeshMaterial { name: String::new(), gltf_json: json.to_string() };
        mesh.appearance.materials = materials.iter().map(of).collect();
        mesh.appearance.images =
            vec![Image { mime_type: "image/png".into(), bytes: image.to_vec(), ..Image::default() }];
        mesh.appearance.textures_json = vec![json!({ "source": 0, "sampler": 0 }).to_string()];
        mesh.appearance.samplers_json = vec![json!({ "wrapS": 33648, "wrapT": 33071 }).to_string()];
        let count = mesh.triangles.len() as u32;
        mesh.groups = vec![TriangleGroup { first: 0, count, material: Some(0), ..TriangleGroup::default() }];
        mesh
    }

    fn textured() -> Value {
        let transform = json!({ "scale": [2, 3], "offset": [0.5, 0.25] });
        let texture = json!({ "index": 0, "extensions": { "KHR_texture_transform": transform } });
        json!({ "pbrMetallicRoughness": { "baseColorTexture": texture, "baseColorFactor": [0.25, 1, 1, 1] } })
    }

    #[test]
    fn samplers_transforms_and_factors_are_read() {
        let found = base_colors_of_mesh(&torus(&[textured(), json!({})], &png()));
        let [Some(color), Some(plain)] = &found[..] else { panic!("{found:?}") };
        assert_eq!(color.wrap, [Wrap::MirroredRepeat, Wrap::ClampToEdge]);
        assert_eq!(color.transform, [[2.0, 0.0, 0.5], [0.0, 3.0, 0.25]]);
        assert_eq!((color.factor, color.texcoord_set), ([0.25, 1.0, 1.0], 0));
        assert_eq!(plain.factor, [1.0; 3]);
    }

    #[test]
    fn images_that_are_missing_or_damaged_change_nothing() {
        let levels = |materials: &[Value], image: &[u8]| {
            let scene = Scene::from_mesh(torus(materials, image)).expect("a scene");
            let lods = LodScene::build(&scene, &LodOptions::default()).expect("a valid mesh");
            lods.lods()[0].as_ref().expect("a mesh").sequence().clone()
        };
        let usual = levels(&[textured()], &[]);
        assert!(base_colors_of_mesh(&torus(&[textured()], &png()[..30])).is_empty());
        assert!(levels(&[textured()], &png()[..30]) == usual);
        assert!(levels(&[textured()], &png()) != usual);
        let two = base_colors_of_mesh(&torus(&[textured(), json!({})], &[]));
        assert!(two.is_empty(), "no material has a texture that can be decoded");
    }
}
