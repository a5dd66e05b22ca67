//! Materials and images that are written next to OBJ and PLY files.

use std::fs;
use std::path::Path;

use crate::meshes::{self, square, written};
use serde_json::Value;
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};
use striata_io::{
    FileBatch, Format, WriteOptions, encode_mesh, read, read_with_report, write, write_with_report,
};
use tempfile::TempDir;

/// Returns a PNG of one pixel of this brightness.
fn png(color: png::ColorType, value: u8) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
    encoder.set_color(color);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header().unwrap().write_image_data(&vec![value; color.samples()]).unwrap();
    bytes
}

/// Writes files into a temporary folder.
fn folder(files: &[(&str, &[u8])]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }
    folder
}

/// Returns the names of all files in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Writes a mesh, and returns the warnings without the path.
fn warnings_of(path: &Path, mesh: &IndexedMesh) -> Vec<String> {
    let prefix = format!("{}: ", path.display());
    let warnings = write_with_report(path, mesh, &WriteOptions::default()).unwrap();
    warnings.iter().map(|warning| warning.to_string().replace(&prefix, "")).collect()
}

const MTL: &str = "newmtl wood\nKd 0.8 0.5 0.25\nPr 0.75\nPm 0.5\nd 0.5\nnewmtl lit sign\nKe 0 2 4\nKd 0.1 0.2 0.3\n\
    map_Ke -s 2 4 1 -o 0.5 0.25 -clamp on maps/my glow.png\nnewmtl wall\nmap_Kd maps/wall.png\n\
    norm -bm 0.5 maps/normal.png\nmap_Pr maps/rough.png\nNs 30\nnewmtl leaf\nmap_Kd leaf.png\nmap_d leaf.png\n\
    newmtl outline\nillum 0\nmap_Kd maps/wall.png\nnewmtl metal\nmap_Pr maps/rough.png\nmap_Pm maps/rough.png\n";

fn obj() -> String {
    let mut text = "mtllib lib/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0.25\nvt 1 0\nvt 0 1\n".to_owned();
    for material in ["wood", "lit sign", "wall", "leaf", "outline", "metal"] {
        text += &format!("usemtl {material}\nf 1/1 2/2 3/3\n");
    }
    text
}

fn textured_folder() -> TempDir {
    let image = |value| png(png::ColorType::Rgb, value);
    let leaf = png(png::ColorType::Rgba, 9);
    folder(&[
        ("in/a.obj", obj().as_bytes()),
        ("in/lib/a.mtl", MTL.as_bytes()),
        ("in/lib/maps/my glow.png", &image(1)),
        ("in/lib/maps/wall.png", &image(2)),
        ("in/lib/maps/normal.png", &image(3)),
        ("in/lib/maps/rough.png", &image(4)),
        ("in/lib/leaf.png", &leaf),
        ("out/unrelated", b""),
    ])
}

#[test]
fn materials_of_obj_files_come_back_unchanged() {
    let folder = textured_folder();
    let report = read_with_report(folder.path().join("in/a.obj")).unwrap();
    assert!(report.warnings.is_empty(), "{:?}", report.warnings);
    let mesh = report.mesh;
    for name in ["b.obj", "c.obj.gz"] {
        let path = folder.path().join("out").join(name);
        assert_eq!(warnings_of(&path, &mesh), [""; 0]);
        let back = read_with_report(&path).unwrap();
        assert!(back.warnings.is_empty(), "{:?}", back.warnings);
        let (found, expected) = (&back.mesh.appearance, &mesh.appearance);
        for (found, expected) in found.materials.iter().zip(&expected.materials) {
            assert_eq!(found.gltf_json, expected.gltf_json);
        }
        assert_eq!(found.materials, expected.materials);
        assert_eq!(
            (&found.textures_json, &found.samplers_json),
            (&expected.textures_json, &expected.samplers_json)
        );
        let bytes = |mesh: &IndexedMesh| -> Vec<Vec<u8>> {
            mesh.appearance.images.iter().map(|image| image.bytes.clone()).collect()
        };
        assert_eq!(bytes(&back.mesh), bytes(&mesh));
        assert_eq!(back.mesh.groups, mesh.groups);
    }
    let expected = [
        "b.mtl",
        "b.obj",
        "c.mtl",
        "c.obj.gz",
        "leaf.png",
        "my glow.png",
        "normal.png",
        "rough.png",
        "unrelated",
        "wall.png",
    ];
    assert_eq!(names(&folder.path().join("out")), expected);
    // Existing files are neither written again nor moved.
    let path = folder.path().join("in/lib/b.obj");
    assert_eq!(warnings_of(&path, &mesh), [""; 0]);
    assert_eq!(names(&folder.path().join("in/lib")), ["a.mtl", "b.mtl", "b.obj", "leaf.png", "maps"]);
    let mtl = fs::read_to_string(folder.path().join("in/lib/b.mtl")).unwrap();
    assert!(mtl.contains("\nmap_Kd maps/wall.png\n"), "{mtl}");
    assert!(read_with_report(&path).unwrap().warnings.is_empty());
}

#[test]
fn different_files_are_never_replaced() {
    let folder = textured_folder();
    let mesh = read(folder.path().join("in/a.obj")).unwrap();
    let out = folder.path().join("out");
    fs::write(out.join("Wall.png"), "another").unwrap();
    fs::write(out.join("b.mtl"), "newmtl mine\n").unwrap();
    let path = out.join("b.obj");
    // Files of the same name in another case are the same in some file systems.
    fs::write(out.join("wall.png"), "another").unwrap();
    let warnings = warnings_of(&path, &mesh);
    let expected = [
        "`wall.png` exists and is another file; a number is added to the name",
        "`b.mtl` exists and is another file; a number is added to the name",
    ];
    assert_eq!(warnings, expected);
    assert_eq!(fs::read(out.join("wall.png")).unwrap(), b"another");
    assert_eq!(fs::read(out.join("b.mtl")).unwrap(), b"newmtl mine\n");
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.starts_with("mtllib b-2.mtl\n"), "{text}");
    let back = read_with_report(&path).unwrap();
    assert!(back.warnings.is_empty());
    assert_eq!(back.mesh.appearance.materials, mesh.appearance.materials);
    // A second run replaces its own library.
    let before = names(&out);
    fs::remove_file(out.join("b.mtl")).unwrap();
    fs::rename(out.join("b-2.mtl"), out.join("b.mtl")).unwrap();
    let mut changed = mesh.clone();
    changed.appearance.materials[0].gltf_json = "{}".to_owned();
    warnings_of(&path, &changed);
    assert_eq!(before.len(), names(&out).len() + 1);
}

#[test]
fn embedded_images_become_files() {
    let folder = textured_folder();
    let mesh = read(folder.path().join("in/a.obj")).unwrap();
    let glb = folder.path().join("a.glb");
    fs::write(&glb, written(Format::Glb, &mesh)).unwrap();
    let scene = read(&glb).unwrap();
    assert!(scene.appearance.images.iter().all(|image| image.uri.is_empty()));
    for (name, count) in [("x.obj", 5), ("x.ply", 2)] {
        let path = folder.path().join(name.replace('.', "/")).with_extension(&name[2..]);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        write(&path, &scene, &WriteOptions::default()).unwrap();
        let back = read_with_report(&path).unwrap();
        assert!(back.warnings.is_empty(), "{:?}", back.warnings);
        let images = &back.mesh.appearance.images;
        assert_eq!(images.len(), count, "{name}: {images:?}");
        assert!(images.iter().all(|image| !image.bytes.is_empty()));
    }
}

#[test]
fn what_mtl_cannot_store_is_named() {
    let mut mesh = square();
    let material = r#"{"name":"m","doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.25,
        "occlusionTexture":{"index":0},"extensions":{"KHR_materials_clearcoat":{}},
        "pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}}}"#;
    mesh.layers = vec![
        AttributeLayer::from_f32(Semantic::TexCoord(0), 2, vec![0.0; 8]),
        AttributeLayer::from_f32(Semantic::TexCoord(1), 2, vec![0.0; 8]),
        AttributeLayer::from_f32(Semantic::Color(0), 4, vec![1.0; 16]),
    ];
    mesh.appearance.materials = vec![
        striata::mesh::Material { name: "m".to_owned(), gltf_json: material.to_owned() },
        striata::mesh::Material { name: "m".to_owned(), gltf_json: "{}".to_owned() },
    ];
    mesh.appearance.images = vec![striata::mesh::Image {
        name: "a".to_owned(),
        mime_type: "image/png".to_owned(),
        bytes: png(png::ColorType::Rgb, 1),
        ..Default::default()
    }];
    mesh.appearance.textures_json = vec![r#"{"source":0}"#.to_owned()];
    mesh.groups = vec![meshes::group("left", Some(0), 0, 1), meshes::group("right", Some(1), 1, 1)];
    let folder = tempfile::tempdir().unwrap();
    let obj = warnings_of(&folder.path().join("a.obj"), &mesh);
    for what in [
        "the second set of texture coordinates of baseColorTexture",
        "the alpha cutoff 0.25",
        "doubleSided",
        "occlusionTexture",
        "KHR_materials_clearcoat",
    ] {
        let expected = format!("material `m`: MTL cannot store {what}; it is left out");
        assert!(obj.contains(&expected), "{expected}: {obj:?}");
    }
    assert!(obj.iter().any(|w| w.contains("the layer texcoord_1")), "{obj:?}");
    assert!(obj.iter().any(|w| w.contains("the alpha of vertex colors")), "{obj:?}");
    assert_eq!(obj.len(), 7, "{obj:?}");
    let text = fs::read_to_string(folder.path().join("a.obj")).unwrap();
    assert!(text.contains("usemtl m\n") && text.contains("usemtl m_2\n"), "names are unique: {text}");
    let ply = warnings_of(&folder.path().join("a.ply"), &mesh);
    let expected = [
        "PLY cannot store 2 groups, such as `left`; their names are left out",
        "PLY stores only the base color image of the material `m`",
        "PLY cannot store the material `m` without an image; it is left out",
    ];
    assert_eq!(ply, expected);
    for format in [Format::Stl, Format::Off] {
        let lost = warnings_of(&folder.path().join(format!("a.{}", format.extension())), &mesh);
        assert!(lost.iter().any(|w| w.contains("cannot store the material `m`")), "{lost:?}");
        assert!(lost.iter().any(|w| w.contains("the layer texcoord_1")), "{lost:?}");
    }
}

/// A PLY file with two images, and a triangle without one.
fn two_images() -> TempDir {
    let text = "ply\nformat ascii 1.0\ncomment TextureFile maps/my a.png\ncomment TextureFile b.jpg\n\
        element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float s\nproperty float t\n\
        element face 3\nproperty list uchar int vertex_indices\nproperty int texnumber\nend_header\n\
        0 0 0 0.1 0.75\n1 0 0 0.9 0.75\n1 1 0 0.9 0.875\n0 1 0 0.1 0.25\n3 0 1 2 1\n3 0 2 3 0\n3 0 1 3 -1\n";
    let a = png(png::ColorType::Rgb, 1);
    folder(&[
        ("in/t.ply", text.as_bytes()),
        ("in/maps/my a.png", &a),
        ("in/b.jpg", b"\xff\xd8\xff..."),
        ("out/x", b""),
    ])
}

#[test]
fn images_of_ply_files_are_kept() {
    let folder = two_images();
    let mesh = read(folder.path().join("in/t.ply")).unwrap();
    for (name, ascii) in [("text.ply", true), ("binary.ply", false)] {
        let path = folder.path().join("out").join(name);
        write(&path, &mesh, &WriteOptions::default().with_ascii(ascii)).unwrap();
        let back = read_with_report(&path).unwrap();
        assert!(back.warnings.is_empty(), "{:?}", back.warnings);
        assert_eq!((&back.mesh.groups, back.mesh.vertex_count()), (&mesh.groups, 4));
        assert_eq!((&back.mesh.layers, &back.mesh.triangles), (&mesh.layers, &mesh.triangles));
        let images = |mesh: &IndexedMesh| -> Vec<Vec<u8>> {
            mesh.appearance.images.iter().map(|image| image.bytes.clone()).collect()
        };
        assert_eq!(images(&back.mesh), images(&mesh));
        assert_eq!(back.mesh.appearance.materials, mesh.appearance.materials);
    }
    assert_eq!(names(&folder.path().join("out")), ["b.jpg", "binary.ply", "my a.png", "text.ply", "x"]);
    let path = folder.path().join("in/again.ply");
    assert_eq!(warnings_of(&path, &mesh), [""; 0]);
    assert_eq!(names(&folder.path().join("in")), ["again.ply", "b.jpg", "maps", "t.ply"]);
    let head = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
    assert!(head.contains("\ncomment TextureFile maps/my a.png\ncomment TextureFile b.jpg\n"), "{head}");
    // Without a path the names stay; in OBJ they become materials.
    let head = String::from_utf8_lossy(&written(Format::Ply, &mesh)).into_owned();
    assert!(head.contains("\ncomment TextureFile my a.png\n"), "{head}");
    write(folder.path().join("out/t.obj"), &mesh, &WriteOptions::default()).unwrap();
    let back = read_with_report(folder.path().join("out/t.obj")).unwrap();
    assert!(back.warnings.is_empty() && back.mesh.appearance.images.len() == 2, "{:?}", back.warnings);
}

#[test]
fn one_image_needs_no_numbers() {
    let text = "ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 3\nproperty float x\n\
        property float y\nproperty float z\nproperty float s\nproperty float t\nelement face 1\n\
        property list uchar int vertex_indices\nend_header\n0 0 0 0 0.75\n1 0 0 0 0\n0 1 0 1 1\n3 0 1 2\n";
    let folder = folder(&[("t.ply", text.as_bytes()), ("a.png", &png(png::ColorType::Rgb, 1))]);
    let mesh = read(folder.path().join("t.ply")).unwrap();
    let path = folder.path().join("u.ply");
    write(&path, &mesh, &WriteOptions::default().with_ascii(true)).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
}

#[test]
fn all_files_appear_or_none() {
    let folder = textured_folder();
    let mesh = read(folder.path().join("in/a.obj")).unwrap();
    let out = folder.path().join("out");
    let path = out.join("b.obj");
    let encoded = encode_mesh(Format::Obj, &mesh, &WriteOptions::default(), Some(&path)).unwrap();
    assert_eq!((encoded.companions.len(), names(&out)), (6, vec!["unrelated".to_owned()]));
    let mut batch = FileBatch::default();
    encoded.stage(&path, &mut batch).unwrap();
    encoded.stage(&out.join("c.obj"), &mut batch).unwrap();
    assert_eq!(names(&out).iter().filter(|name| !name.starts_with('.')).count(), 1);
    batch.commit().unwrap();
    assert_eq!(names(&out).len(), 9);
    let library = &encoded.companions[5];
    let mut batch = FileBatch::default();
    batch.write_shared(&library.path, &library.bytes).unwrap();
    let error = batch.write_shared(&library.path, b"else").unwrap_err().to_string();
    assert!(error.contains("b.mtl") && error.contains("different files"), "{error}");
    let in_memory = encode_mesh(Format::Obj, &mesh, &WriteOptions::default(), None).unwrap();
    assert!(in_memory.companions.is_empty() && in_memory.bytes.starts_with(b"mtllib lib/a.mtl\n"));
    let value: Value = serde_json::from_str(&mesh.appearance.materials[0].gltf_json).unwrap();
    assert_eq!(value["alphaMode"], "BLEND");
}
