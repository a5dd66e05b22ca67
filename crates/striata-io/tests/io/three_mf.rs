//! 3MF: objects, components, properties, parts of production files, and errors.

use std::io::{Cursor, Write as _};

use crate::meshes::{read, refused, square};
use striata::mesh::{LayerData, Semantic};
use striata_io::{Format, Scene, Source, WriteOptions, read_scene_bytes, scene_to_bytes, to_bytes};

/// Returns an archive with these parts.
fn archive(parts: &[(&str, &[u8])]) -> Vec<u8> {
    let mut writer = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default();
    for (name, bytes) in parts {
        writer.start_file(*name, options.compression_method(zip::CompressionMethod::Deflated)).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

const TETRAHEDRON: &str = "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"10\" y=\"0\" z=\"0\"/>\
    <vertex x=\"0\" y=\"10\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1e1\"/></vertices><triangles>\
    <triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\" pid=\"1\" p1=\"1\"/>\
    <triangle v1=\"1\" v2=\"2\" v3=\"3\" pid=\"2\" p1=\"0\" p2=\"1\" p3=\"0\"/>\
    <triangle v1=\"2\" v2=\"0\" v3=\"3\"/></triangles></mesh>";

/// Returns a model with base materials (1), colors (2) and the tetrahedron (3).
fn model(objects: &str, build: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<model unit=\"inch\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" \
         xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n<metadata name=\"Title\">A &amp; B\
         </metadata>\n<resources><basematerials id=\"1\"><base name=\"red\" displaycolor=\"#FF0000\"/>\
         <base name=\"glass\" displaycolor=\"#00FF0080\"/></basematerials>\n<m:colorgroup id=\"2\"><m:color color=\"#FFFFFF\"/>\
         <m:color color=\"#0000FF\"/></m:colorgroup>\n<object id=\"3\" name=\"tetra\" pid=\"1\" pindex=\"0\">{TETRAHEDRON}\
         </object>{objects}</resources>\n<build>{build}</build></model>"
    )
}

fn file(objects: &str, build: &str) -> Vec<u8> {
    archive(&[("3D/3dmodel.model", model(objects, build).as_bytes())])
}

fn scene(bytes: &[u8]) -> Scene {
    read_scene_bytes(bytes, &Source::new("a.3mf")).unwrap()
}

#[test]
fn build_items_and_components_become_nodes_that_share_meshes() {
    let objects = "<object id=\"4\"><components><component objectid=\"3\"/><component objectid=\"3\" \
        transform=\"1 0 0 0 1 0 0 0 1 100 0 0\"/></components></object>";
    let build = "<item objectid=\"4\"/><item objectid=\"3\" transform=\"0 2 0 -2 0 0 0 0 2 0 0 5\"/>";
    let scene = scene(&file(objects, build));
    assert_eq!((scene.meshes().len(), scene.instances().len(), scene.triangle_count()), (1, 3, 12));
    assert_eq!(scene.mesh_name(0), "tetra");
    assert_eq!(scene.document()["asset"]["extras"]["unit"], "inch");
    assert_eq!(scene.document()["asset"]["extras"]["metadata"]["Title"], "A & B");
    // The second item turns x to y, doubles, and lifts by 5.
    let bounds = scene.bounds().unwrap();
    assert_eq!((bounds.min, bounds.max), ([-20.0, 0.0, 0.0], [110.0, 20.0, 25.0]));
    let flat = read("a.3mf", &file(objects, build)).unwrap();
    assert_eq!(flat.triangle_count(), 12);
    assert_eq!(flat.bounds().unwrap(), bounds);
}

#[test]
fn materials_and_colors_are_kept() {
    let scene = scene(&file("", "<item objectid=\"3\"/>"));
    assert!(scene.warnings().is_empty(), "{:?}", scene.warnings());
    let mesh = scene.meshes()[0].as_ref().unwrap();
    // Without a material, with red, and with glass.
    assert_eq!(mesh.groups.iter().map(|group| group.count).collect::<Vec<_>>(), [1, 2, 1]);
    assert_eq!(scene.primitive_materials(0), [None, Some(0), Some(1)]);
    let glass = &scene.document()["materials"][1];
    assert_eq!((glass["name"].as_str(), glass["alphaMode"].as_str()), (Some("glass"), Some("BLEND")));
    let colors = mesh.layer(&Semantic::Color(0)).unwrap();
    let LayerData::U16(words) = &colors.data else { panic!("{colors:?}") };
    assert!(words.chunks(3).any(|color| color == [0, 0, 65535]));
    // The corners of the colored triangle are split from those of the others.
    assert_eq!(mesh.positions.len(), 7);
}

#[test]
fn textures_are_read_from_the_archive() {
    let png = b"\x89PNG\r\n\x1a\n....";
    let objects = "<m:texture2d id=\"5\" path=\"/3D/Textures/a.png\" contenttype=\"image/png\" tilestyleu=\"clamp\"/>\
        <m:texture2dgroup id=\"6\" texid=\"5\"><m:tex2coord u=\"0\" v=\"0\"/><m:tex2coord u=\"1\" v=\"0.25\"/></m:texture2dgroup>\
        <object id=\"7\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>\
        <vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\" pid=\"6\" p1=\"0\" \
        p2=\"1\" p3=\"0\"/></triangles></mesh></object>";
    let text = model(objects, "<item objectid=\"7\"/>");
    let parts: [(&str, &[u8]); 2] = [("3D/3dmodel.model", text.as_bytes()), ("3D/Textures/a.png", png)];
    let with_texture = scene(&archive(&parts));
    assert_eq!(with_texture.images()[0].bytes, png);
    let mesh = with_texture.meshes()[0].as_ref().unwrap();
    let uv = LayerData::F32(vec![0.0, 1.0, 1.0, 0.75, 0.0, 1.0]);
    assert_eq!(mesh.layer(&Semantic::TexCoord(0)).unwrap().data, uv);
    assert_eq!(with_texture.document()["samplers"][0]["wrapS"], 33071);
    let without = scene(&archive(&parts[..1]));
    assert!(without.warnings()[0].reason.contains("not found"), "{:?}", without.warnings());
}

#[test]
fn production_files_have_objects_in_other_parts() {
    let relations = "<Relationships><Relationship Target=\"/3D/root.model\" Id=\"a\" \
        Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    let root = "<model xmlns:p=\"urn:p\"><resources><object id=\"1\"><components><component p:path=\"/3D/Objects/b.model\" \
        objectid=\"3\"/></components></object></resources><build><item objectid=\"1\" p:UUID=\"x\"/></build></model>";
    let other = model("", "");
    let parts: [(&str, &[u8]); 3] = [
        ("_rels/.rels", relations.as_bytes()),
        ("3D/root.model", root.as_bytes()),
        ("3D/Objects/b.model", other.as_bytes()),
    ];
    let found = scene(&archive(&parts));
    assert_eq!(found.triangle_count(), 4);
    assert_eq!(found.document()["asset"]["extras"]["unit"], "millimeter");
    let message = refused("a.3mf", &archive(&parts[..2]));
    assert!(message.contains("the part `3D/Objects/b.model` does not exist"), "{message}");
}

#[test]
fn damaged_files_are_refused_with_their_place() {
    let object = |inner: &str| format!("<object id=\"9\">{inner}</object>");
    let triangle = "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"0\"/>";
    for (objects, build, expected) in [
        (object("<mesh></vertices>"), "", "malformed"),
        (object(&format!("{triangle}</triangles></mesh>")), "", "triangle 0: vertex 1 of 1 does not exist"),
        (
            object("<mesh><vertices><vertex x=\"0\" y=\"z\"/></vertices></mesh>"),
            "",
            "without the three numbers",
        ),
        (String::new(), "<item objectid=\"8\"/>", "object 8 does not exist"),
        (String::new(), "<item/>", "the attribute `objectid` is missing"),
        (String::new(), "<item objectid=\"3\" transform=\"1 0\"/>", "`transform` is not 12 numbers"),
        (
            object("<components><component objectid=\"9\"/></components>"),
            "<item objectid=\"9\"/>",
            "contain themselves",
        ),
    ] {
        let message = refused("a.3mf", &file(&objects, build));
        assert!(message.contains(expected), "{message}");
        assert!(message.starts_with("a.3mf: 3D/3dmodel.model, line "), "{message}");
    }
    // Twice two to the power of 40 nodes.
    let bomb: String = (10..50)
        .map(|id| format!("<object id=\"{id}\"><components><component objectid=\"{0}\"/><component objectid=\"{0}\"/></components></object>", id + 1))
        .collect();
    let message = refused(
        "a.3mf",
        &file(&format!("{bomb}<object id=\"50\">{TETRAHEDRON}</object>"), "<item objectid=\"10\"/>"),
    );
    assert!(message.contains("more than 200000 objects"), "{message}");
    let zeros = vec![b' '; 80 << 20];
    let message = refused("a.3mf", &archive(&[("3D/3dmodel.model", &zeros)]));
    assert!(message.contains("unpacks to more than"), "{message}");
}

#[test]
fn what_is_left_out_is_a_warning() {
    let objects = "<slicestack id=\"20\"><slice/></slicestack><slicestack id=\"21\"/>";
    let found = scene(&file(objects, "<item objectid=\"3\"/>"));
    assert_eq!(found.warnings().len(), 1);
    assert_eq!(found.warnings()[0].reason, "2 elements `slicestack` are left out");
}

#[test]
fn scenes_survive_writing() {
    let build = "<item objectid=\"3\"/><item objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 0 0 30\"/>";
    let before = scene(&file("", build));
    let bytes = scene_to_bytes(Format::ThreeMf, &before, &WriteOptions::default()).unwrap();
    let after = scene(&bytes);
    assert_eq!(after.bounds(), before.bounds());
    assert_eq!((after.meshes().len(), after.instances().len(), after.triangle_count()), (1, 2, 8));
    assert_eq!(after.document()["asset"], before.document()["asset"]);
    let colors = |scene: &Scene| scene.meshes()[0].as_ref().unwrap().layer(&Semantic::Color(0)).is_some();
    assert!(colors(&before) && colors(&after));
    assert_eq!(bytes, scene_to_bytes(Format::ThreeMf, &before, &WriteOptions::default()).unwrap());
}

#[test]
fn meshes_survive_writing() {
    let mesh = square();
    let bytes = to_bytes(Format::ThreeMf, &mesh, &WriteOptions::default()).unwrap();
    let back = read("x", &bytes).unwrap();
    assert_eq!((back.positions, back.triangles), (mesh.positions, mesh.triangles));
}

#[test]
fn every_truncation_is_an_error() {
    let bytes = file("", "<item objectid=\"3\"/>");
    for length in 4..bytes.len() {
        assert!(read("a.3mf", &bytes[..length]).is_err(), "cut to {length}");
    }
}
