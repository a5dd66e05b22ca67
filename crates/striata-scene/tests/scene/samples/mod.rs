//! A small scene with everything that a stream carries: instances, a skin, morph targets, animations,
//! textures.

use std::io::Cursor;

use image::{ImageFormat, Rgba, RgbaImage};
use serde_json::{Value, json};
use striata::mesh::{
    AttributeLayer, Image, IndexedMesh, LayerData, Material, Random, Semantic, TriangleGroup, shapes,
};
use striata_io::{Scene, SceneParts};

/// An image of smooth colors and some noise.
pub(crate) fn picture(side: u32, has_alpha: bool, seed: u64) -> RgbaImage {
    let mut random = Random::new(seed);
    RgbaImage::from_fn(side, side, |x, y| {
        let noise = random.between(0.0, 40.0) as u32;
        let alpha = if has_alpha && x < side / 2 { 90 } else { 255 };
        Rgba([(x * 200 / side + noise) as u8, (y * 200 / side + noise) as u8, noise as u8, alpha])
    })
}

pub(crate) fn encoded(image: &RgbaImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    if format == ImageFormat::Jpeg {
        image::DynamicImage::from(image.clone()).into_rgb8().write_to(&mut bytes, format).unwrap();
    } else {
        image.write_to(&mut bytes, format).unwrap();
    }
    bytes.into_inner()
}

/// The header of a KTX2 file of 64 x 64 pixels, and bytes that nobody here can decode.
pub(crate) fn ktx2() -> Vec<u8> {
    let mut bytes = b"\xabKTX 20\xbb\r\n\x1a\n".to_vec();
    for word in [0u32, 1, 64, 64, 0, 0, 1, 1, 1] {
        bytes.extend(word.to_le_bytes());
    }
    bytes.extend((0..3000u32).map(|i| (i * i / 7) as u8));
    bytes
}

fn with_groups(mut mesh: IndexedMesh, parts: u32) -> IndexedMesh {
    let count = mesh.triangles.len() as u32;
    mesh.groups = (0..parts)
        .map(|part| {
            let (first, end) = (count * part / parts, count * (part + 1) / parts);
            TriangleGroup { name: String::new(), material: Some(part), first, count: end - first }
        })
        .collect();
    mesh.appearance.materials = vec![Material::default(); parts as usize];
    mesh
}

fn texcoords(mesh: &IndexedMesh) -> AttributeLayer {
    let data = mesh.positions.iter().flat_map(|p| [p[0] * 0.5 + 0.5, p[1] * 0.5 + 0.5]).collect();
    AttributeLayer::from_f32(Semantic::TexCoord(0), 2, data)
}

/// A torus with two materials.
fn torus(detail: u32) -> IndexedMesh {
    let mut mesh = with_groups(shapes::torus(6 * detail, 4 * detail, 1.0, 0.4), 2);
    mesh.layers.push(texcoords(&mesh));
    mesh
}

/// A sphere with joints, weights and a morph target.
fn skinned(detail: u32) -> IndexedMesh {
    let mut mesh = with_groups(shapes::uv_sphere(4 * detail, 5 * detail, 1.0), 1);
    let joints = mesh.positions.iter().flat_map(|p| [u8::from(p[2] > 0.0), 1, 0, 0]).collect();
    let weights = mesh.positions.iter().flat_map(|p| {
        let w = (p[2] * 0.5 + 0.5).clamp(0.0, 1.0);
        [w, 1.0 - w, 0.0, 0.0]
    });
    let weights = weights.collect();
    let displacements = mesh.positions.iter().flat_map(|p| [0.3 * p[1], -0.2 * p[0], 0.1]).collect();
    mesh.layers = vec![
        AttributeLayer {
            semantic: Semantic::Joints(0),
            component_count: 4,
            normalized: false,
            data: LayerData::U8(joints),
        },
        AttributeLayer::from_f32(Semantic::Weights(0), 4, weights),
        AttributeLayer::from_f32(Semantic::MorphPosition(0), 3, displacements),
    ];
    mesh
}

/// A very small part.
fn screw() -> IndexedMesh {
    with_groups(shapes::icosphere(2, 0.01), 1)
}

/// The buffer: two inverse bind matrices, times, rotations, weights of the morph target.
fn buffer() -> Vec<u8> {
    let identity = |scale: f32| {
        (0..16).map(move |i| if i % 5 == 0 { if i == 15 { 1.0 } else { scale } } else { 0.0f32 })
    };
    let times = (0..20).map(|i| i as f32 / 24.0);
    let rotations = (0..20).flat_map(|i| {
        let x = i as f32 * 0.02;
        [x, 0.0, 0.0, (1.0 - x * x).sqrt()]
    });
    let weights = (0..20).map(|i| i as f32 * 0.07);
    let floats: Vec<f32> =
        identity(1.0).chain(identity(1.5)).chain(times).chain(rotations).chain(weights).collect();
    floats.into_iter().flat_map(f32::to_le_bytes).collect()
}

fn document() -> Value {
    let accessor = |view: usize, offset: usize, kind: &str, count: usize| json!({ "bufferView": view, "byteOffset": offset, "componentType": 5126, "type": kind, "count": count });
    let texture = |index: usize| json!({ "index": index });
    let mut times = accessor(1, 0, "SCALAR", 20);
    (times["min"], times["max"]) = (json!([0.0]), json!([19.0f32 / 24.0]));
    json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": ["KHR_texture_basisu"],
        "extensionsRequired": ["KHR_texture_basisu"],
        "scene": 0,
        "scenes": [{ "nodes": [0, 1, 2, 3, 4] }],
        "nodes": [
            { "mesh": 0, "name": "ring" },
            { "mesh": 0, "translation": [4.0, 0.0, 0.0], "scale": [2.0, 2.0, 2.0] },
            { "mesh": 1, "skin": 0 },
            { "translation": [0.0, 3.0, 0.0], "children": [5] },
            { "mesh": 2, "translation": [0.0, 0.0, 2.0] },
            {},
        ],
        "skins": [{ "joints": [3, 5], "inverseBindMatrices": 0 }],
        "animations": [{
            "samplers": [{ "input": 1, "output": 2 }, { "input": 1, "output": 3 }],
            "channels": [
                { "sampler": 0, "target": { "node": 3, "path": "rotation" } },
                { "sampler": 1, "target": { "node": 2, "path": "weights" } },
            ],
        }],
        "accessors": [
            accessor(0, 0, "MAT4", 2),
            times,
            accessor(1, 80, "VEC4", 20),
            accessor(1, 400, "SCALAR", 20),
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 128 },
            { "buffer": 0, "byteOffset": 128, "byteLength": 480 },
        ],
        "meshes": [
            { "primitives": [
                { "attributes": { "POSITION": null, "TEXCOORD_0": null }, "material": 0 },
                { "attributes": { "POSITION": null, "TEXCOORD_0": null }, "material": 1 },
            ] },
            { "primitives": [{
                "attributes": { "POSITION": null, "JOINTS_0": null, "WEIGHTS_0": null },
                "targets": [{ "POSITION": null }],
                "material": 1,
            }] },
            { "primitives": [{ "attributes": { "POSITION": null }, "material": 1 }] },
        ],
        "materials": [
            {
                "pbrMetallicRoughness": { "baseColorTexture": texture(0) },
                "normalTexture": texture(1),
                "alphaMode": "BLEND",
            },
            { "emissiveTexture": texture(2), "occlusionTexture": texture(3) },
        ],
        "textures": [
            { "source": 0 },
            { "source": 1 },
            { "extensions": { "KHR_texture_basisu": { "source": 2 } } },
            { "source": 3 },
        ],
        "images": [
            { "mimeType": "image/png", "name": "skin" },
            { "mimeType": "image/jpeg" },
            { "mimeType": "image/ktx2" },
            { "mimeType": "image/png" },
        ],
    })
}

/// A scene whose meshes have more triangles with more detail, 1 or more.
pub(crate) fn scene(detail: u32) -> Scene {
    let image = |mime_type: &str, bytes: Vec<u8>| Image {
        mime_type: mime_type.to_owned(),
        bytes,
        ..Image::default()
    };
    let side = 24 * detail;
    let images = vec![
        Image {
            name: "skin".to_owned(),
            ..image("image/png", encoded(&picture(side, true, 1), ImageFormat::Png))
        },
        image("image/jpeg", encoded(&picture(side, false, 2), ImageFormat::Jpeg)),
        image("image/ktx2", ktx2()),
        image("image/png", encoded(&picture(2, false, 3), ImageFormat::Png)),
    ];
    let meshes = vec![Some(torus(detail)), Some(skinned(detail)), Some(screw())];
    Scene::from_parts(SceneParts { document: document(), buffer: buffer(), images, meshes }).unwrap()
}
