//! Material libraries of OBJ: glTF materials, textures, and warnings about what is missing.

use std::fs;
use std::path::Path;

use crate::meshes::{read, written};
use serde_json::{Value, json};
use striata::mesh::IndexedMesh;
use striata_io::{Format, ReadReport, Source, read_bytes_with_report, read_with_report};
use tempfile::TempDir;

/// Returns a PNG of one pixel.
fn png(color: png::ColorType) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
    encoder.set_color(color);
    encoder.set_depth(png::BitDepth::Eight);
    let pixel = vec![200; color.samples()];
    encoder.write_header().unwrap().write_image_data(&pixel).unwrap();
    bytes
}

/// An OBJ file with one triangle per material.
fn obj(head: &str, materials: &[&str]) -> String {
    let mut text = format!("{head}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0.25\nvt 1 0\nvt 0 1\n");
    for material in materials {
        text += &format!("usemtl {material}\nf 1/1 2/2 3/3\n");
    }
    text
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

fn report(folder: &TempDir, name: &str) -> ReadReport {
    read_with_report(folder.path().join(name)).unwrap()
}

/// Returns the warnings without the path of the folder.
fn warnings(folder: &TempDir, report: &ReadReport) -> Vec<String> {
    let prefix = format!("{}/", folder.path().display());
    report.warnings.iter().map(|warning| warning.to_string().replace(&prefix, "")).collect()
}

fn materials(mesh: &IndexedMesh) -> Vec<Value> {
    mesh.appearance.materials.iter().map(|m| serde_json::from_str(&m.gltf_json).unwrap()).collect()
}

/// Reads one material from an MTL file next to `files`; it must give no warnings.
fn material(mtl: &str, files: &[(&str, &[u8])]) -> (Value, IndexedMesh) {
    let text = obj("mtllib a.mtl", &["m"]);
    let mtl = format!("newmtl m\n{mtl}");
    let files = [files, &[("a.obj", text.as_bytes()), ("a.mtl", mtl.as_bytes())]].concat();
    let folder = folder(&files);
    let report = report(&folder, "a.obj");
    assert_eq!(warnings(&folder, &report), [""; 0]);
    (materials(&report.mesh).remove(0), report.mesh)
}

/// Checks that GLB keeps the appearance, and that an independent reader accepts the file.
fn assert_survives_glb(mesh: &IndexedMesh) {
    let bytes = written(Format::Glb, mesh);
    let back = read("x.glb", &bytes).unwrap();
    let mut expected = mesh.appearance.clone();
    expected.material_libraries.clear();
    for material in expected.materials.iter_mut().filter(|material| material.gltf_json.is_empty()) {
        material.gltf_json = json!({ "name": material.name }).to_string();
    }
    for image in &mut expected.images {
        if !image.bytes.is_empty() {
            image.uri.clear();
        }
    }
    assert_eq!(back.appearance, expected);
    gltf::Gltf::from_slice(&bytes).unwrap();
}

#[test]
fn a_textured_obj_becomes_a_textured_glb() {
    let image = png(png::ColorType::Rgba);
    let (value, mesh) = material(
        "Kd 0.5 0.5 0.5\r\nKs 0.5 0.5 0.5\r\nNs 96\r\nmap_Kd maps\\My Wood.png\r\nmap_Ke maps/my wood.PNG\r\n",
        &[("Maps/my wood.png", &image)],
    );
    let texture = json!({ "index": 0 });
    assert_eq!(value["pbrMetallicRoughness"]["baseColorTexture"], texture);
    assert_eq!(value["pbrMetallicRoughness"]["metallicFactor"], 0.0);
    assert_eq!(value["pbrMetallicRoughness"].get("baseColorFactor"), None, "the texture replaces `Kd`");
    assert_eq!((&value["emissiveTexture"], &value["emissiveFactor"]), (&texture, &json!([1.0, 1.0, 1.0])));
    let [found] = &mesh.appearance.images[..] else { panic!("{:?}", mesh.appearance.images) };
    assert_eq!((found.name.as_str(), found.uri.as_str()), ("My Wood.png", "maps/My%20Wood.png"));
    assert_eq!((found.mime_type.as_str(), &found.bytes), ("image/png", &image));
    assert_eq!(mesh.appearance.textures_json, [r#"{"source":0}"#]);
    assert_survives_glb(&mesh);
    let again = String::from_utf8(written(Format::Obj, &mesh)).unwrap();
    assert!(again.starts_with("mtllib a.mtl\n") && again.contains("\nusemtl m\n"), "{again}");
}

#[test]
fn factors_are_converted() {
    let pbr = |mtl: &str| material(mtl, &[]).0["pbrMetallicRoughness"].clone();
    let color = pbr("Kd 0.5 0 1\nd 0.25");
    let factors: Vec<f64> =
        color["baseColorFactor"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    for (found, expected) in factors.iter().zip([0.214_041, 0.0, 1.0, 0.25]) {
        assert!((found - expected).abs() < 1e-5, "{factors:?}");
    }
    assert_eq!(color["roughnessFactor"], 1.0);
    assert_eq!(pbr("Kd 1 1 1").get("baseColorFactor"), None);
    let roughness = |mtl: &str| pbr(mtl)["roughnessFactor"].as_f64().unwrap();
    assert_eq!(roughness("Ns 30\nKs 0.5 0.5 0.5"), 0.5);
    assert_eq!(roughness("Ns 30\nKs 0 0 0"), 1.0);
    assert_eq!(roughness("Ns 30\nKs 1 1 1\nillum 1"), 1.0);
    assert_eq!(roughness("Ns 30\nPr 0.75\nPm 0.5"), 0.75);
    assert_eq!(pbr("Pm 0.5")["metallicFactor"], 0.5);
    let alpha = |mtl: &str| {
        let value = material(mtl, &[]).0;
        (value["alphaMode"].clone(), value["pbrMetallicRoughness"]["baseColorFactor"][3].clone())
    };
    assert_eq!(alpha("d 1\nTr 0.5\nKd 0 0 0"), (Value::Null, json!(1.0)), "`d` wins");
    assert_eq!(alpha("Tr 0.25"), (json!("BLEND"), json!(0.75)));
    let bright = material("Ke 0 2 4", &[]).0;
    assert_eq!(bright["extensions"]["KHR_materials_emissive_strength"], json!({ "emissiveStrength": 4.0 }));
    assert_eq!(bright["emissiveFactor"][2], 1.0);
    assert_eq!(material("Ke 0 0 0\nillum 0", &[]).0.get("extensions"), None);
}

#[test]
fn blender_writes_linear_colors_and_its_own_exponents() {
    let text = obj("mtllib a.mtl", &["m"]);
    let mtl =
        b"# Blender 4.2.0 MTL File: 'a.blend'\n# www.blender.org\n\nnewmtl m\nNs 250\nKd 0.5 0.25 0.125\n";
    let folder = folder(&[("a.obj", text.as_bytes()), ("a.mtl", mtl)]);
    let value = materials(&report(&folder, "a.obj").mesh).remove(0);
    let pbr = &value["pbrMetallicRoughness"];
    assert_eq!(
        (&pbr["baseColorFactor"], &pbr["roughnessFactor"]),
        (&json!([0.5, 0.25, 0.125, 1.0]), &json!(0.5))
    );
}

#[test]
fn options_become_transforms_and_samplers() {
    let image = png(png::ColorType::Rgb);
    let (value, mesh) = material(
        "map_Kd -s 2 4 1 -o 0.5 0.25 a.png\nmap_Ke -clamp on a.png\nnorm -bm 0.5 -imfchan m a.png\nillum 0",
        &[("a.png", &image)],
    );
    let transform = json!({ "scale": [2.0, 4.0], "offset": [0.5, -3.25] });
    let base_color = &value["pbrMetallicRoughness"]["baseColorTexture"];
    assert_eq!(base_color["extensions"]["KHR_texture_transform"], transform);
    assert_eq!(value["normalTexture"], json!({ "index": 0, "scale": 0.5 }));
    assert_eq!(value["emissiveTexture"], json!({ "index": 1 }));
    assert_eq!(value["extensions"], json!({ "KHR_materials_unlit": {} }));
    let appearance = &mesh.appearance;
    assert_eq!((appearance.images.len(), appearance.textures_json.len()), (1, 2));
    assert_eq!(appearance.samplers_json, [r#"{"wrapS":33071,"wrapT":33071}"#]);
    assert_eq!(appearance.extensions_used, ["KHR_materials_unlit", "KHR_texture_transform"]);
    assert_survives_glb(&mesh);
}

#[test]
fn maps_that_gltf_cannot_combine_are_left_out() {
    let (rgb, rgba, gray) =
        (png(png::ColorType::Rgb), png(png::ColorType::Rgba), png(png::ColorType::Grayscale));
    let files: [(&str, &[u8]); 3] = [("rgb.png", &rgb), ("rgba.png", &rgba), ("gray.png", &gray)];
    // These can be used as they are.
    let pbr = |mtl: &str| material(mtl, &files).0["pbrMetallicRoughness"].clone();
    let both = pbr("map_Pr rgb.png\nmap_Pm ./rgb.png");
    assert_eq!(both["metallicRoughnessTexture"], json!({ "index": 0 }));
    assert_eq!((&both["metallicFactor"], &both["roughnessFactor"]), (&json!(1.0), &json!(1.0)));
    let rough = pbr("map_Pr gray.png");
    assert_eq!(
        (&rough["metallicRoughnessTexture"]["index"], &rough["metallicFactor"]),
        (&json!(0), &json!(0.0))
    );
    assert_eq!(material("map_Kd rgba.png\nmap_d gray.png", &files).0["alphaMode"], "MASK");
    assert_eq!(material("map_Kd rgb.png\nmap_d rgb.png", &files).0["alphaMode"], "MASK");
    assert_eq!(material("map_Bump rgb.png", &files).0["normalTexture"]["index"], 0);
    // These cannot.
    for (mtl, reason) in [
        ("map_Pr gray.png\nmap_Pm rgb.png", "combines metalness and roughness"),
        ("map_Kd rgb.png\nmap_d -s 2 2 gray.png", "not those of the base color"),
        ("bump gray.png", "no height maps"),
        ("Tr 1", "material `m` would be invisible"),
    ] {
        let (text, mtl) = (obj("mtllib a.mtl", &["m"]), format!("newmtl m\n{mtl}\n"));
        let folder = folder(&[&files[..], &[("a.obj", text.as_bytes()), ("a.mtl", mtl.as_bytes())]].concat());
        let report = report(&folder, "a.obj");
        let warnings = warnings(&folder, &report);
        assert!(warnings[0].starts_with("a.mtl: line ") && warnings[0].contains(reason), "{warnings:?}");
        let used = mtl.contains("map_Kd");
        assert_eq!(report.mesh.appearance.images.len(), usize::from(used), "{mtl}");
        assert_survives_glb(&report.mesh);
    }
}

/// An uncompressed TGA of two by two pixels of one color.
fn tga([red, green, blue]: [u8; 3]) -> Vec<u8> {
    let mut bytes = vec![0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0x20];
    bytes.extend([blue, green, red].repeat(4));
    bytes
}

/// A BMP of two by two pixels of one color.
fn bmp([red, green, blue]: [u8; 3]) -> Vec<u8> {
    let mut bytes = b"BM".to_vec();
    for number in [70u32, 0, 54, 40, 2, 2, 1 | 24 << 16, 0, 16, 2835, 2835, 0, 0] {
        bytes.extend(number.to_le_bytes());
    }
    (0..2).for_each(|_| bytes.extend([blue, green, red, blue, green, red, 0, 0]));
    bytes
}

/// Decodes a PNG to its size and its samples.
fn pixels(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut out = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut out).unwrap();
    out.truncate(info.buffer_size());
    (info.width, info.height, out)
}

#[test]
#[cfg(feature = "images")]
fn tga_and_bmp_become_png() {
    let files: [(&str, &[u8]); 2] = [("Wood.TGA", &tga([160, 80, 40])), ("bark.bmp", &bmp([90, 40, 20]))];
    let (_, mesh) = material("map_Kd wood.tga\nmap_Ke bark.bmp", &files);
    let images = &mesh.appearance.images;
    assert!(images.iter().all(|image| image.mime_type == "image/png"));
    assert_eq!(pixels(&images[0].bytes), (2, 2, [160, 80, 40].repeat(4)));
    assert_eq!(pixels(&images[1].bytes), (2, 2, [90, 40, 20].repeat(4)));
    assert_survives_glb(&mesh);
    // A glTF document may not refer to them, but some do.
    let mut root: Value = serde_json::from_slice(&written(Format::Gltf, &mesh)).unwrap();
    root["images"] = json!([{ "uri": "Wood.TGA" }, { "uri": "bark.bmp" }, { "uri": "broken.tga" }]);
    let broken = &tga([0; 3])[..20];
    let folder =
        folder(&[&files[..], &[("a.gltf", root.to_string().as_bytes()), ("broken.tga", broken)]].concat());
    let report = report(&folder, "a.gltf");
    assert_eq!(pixels(&report.mesh.appearance.images[0].bytes).2[..3], [160, 80, 40]);
    assert_eq!(report.mesh.appearance.images[1].mime_type, "image/png");
    let warnings = warnings(&folder, &report);
    assert!(warnings.len() == 1 && warnings[0].contains("the image is damaged"), "{warnings:?}");
}

#[test]
#[cfg(feature = "images")]
fn masks_become_the_alpha_of_the_base_color() {
    let mut gray = Vec::new();
    let mut encoder = png::Encoder::new(&mut gray, 2, 1);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.write_header().unwrap().write_image_data(&[0, 255]).unwrap();
    let (rgb, soft) = (png(png::ColorType::Rgb), png(png::ColorType::Grayscale));
    let files: [(&str, &[u8]); 4] =
        [("leaf.png", &rgb), ("mask.png", &gray), ("soft.png", &soft), ("wood.tga", &tga([1, 2, 3]))];
    let (value, mesh) = material("map_Kd wood.tga\nmap_d mask.png\nd 0.5", &files);
    assert_eq!((&value["alphaMode"], mesh.appearance.images.len()), (&json!("MASK"), 1));
    let image = &mesh.appearance.images[0];
    assert_eq!((image.name.as_str(), image.uri.as_str()), ("wood_alpha.png", "wood_alpha.png"));
    let expected = [[1, 2, 3, 0], [1, 2, 3, 255]].concat().repeat(2);
    assert_eq!(pixels(&image.bytes), (2, 2, expected));
    assert_survives_glb(&mesh);
    let (value, mesh) = material("map_Kd leaf.png\nmap_d soft.png", &files);
    assert_eq!(value["alphaMode"], "BLEND", "most of it is translucent");
    assert_eq!(pixels(&mesh.appearance.images[0].bytes), (1, 1, vec![200; 4]));
    // Without a base color image, the color stays a factor.
    let (value, mesh) = material("Kd 1 0 0\nmap_d mask.png", &files);
    let pbr = &value["pbrMetallicRoughness"];
    assert_eq!(
        (&pbr["baseColorFactor"], &value["alphaMode"]),
        (&json!([1.0, 0.0, 0.0, 1.0]), &json!("MASK"))
    );
    assert_eq!(pixels(&mesh.appearance.images[0].bytes), (2, 1, vec![255, 255, 255, 0, 255, 255, 255, 255]));
    // Materials that share both files share the image.
    let text = obj("mtllib a.mtl", &["m", "n"]);
    let mtl = "newmtl m\nmap_Kd leaf.png\nmap_d mask.png\nnewmtl n\nmap_Kd leaf.png\nmap_d mask.png\n";
    let files = [&files[..], &[("a.obj", text.as_bytes()), ("a.mtl", mtl.as_bytes())]].concat();
    let folder = folder(&files);
    assert_eq!(report(&folder, "a.obj").mesh.appearance.images.len(), 1);
}

#[test]
fn missing_and_outside_files_are_warnings() {
    let text = obj("mtllib lost.mtl\nmtllib ../secret.mtl\nmtllib a.mtl", &["m", "unknown"]);
    let mtl = "newmtl m\nmap_Kd lost.png\nmap_Ke ../secret.png\nnorm image.tga\nmap_Pr folder\nKd x\n";
    let folder = folder(&[
        ("model/a.obj", text.as_bytes()),
        ("model/a.mtl", mtl.as_bytes()),
        ("model/folder/x", b""),
        ("model/image.tga", b"no header"),
        ("secret.png", &png(png::ColorType::Rgb)),
        ("secret.mtl", b"newmtl unknown\nKd 1 0 0\n"),
    ]);
    let bytes = fs::read(folder.path().join("model/a.obj")).unwrap();
    let inner = folder.path().join("model");
    let name = inner.join("a.obj").display().to_string();
    let strict = Source::new(&name).with_folder(&inner);
    let report = read_bytes_with_report(&bytes, &strict).unwrap();
    let expected = [
        "model/a.obj: line 1: material library `lost.mtl`: not found",
        "model/a.obj: line 2: material library `../secret.mtl`: it leaves the folder of the file",
        "model/a.mtl: line 6: expected a number, found `x`; the statement is skipped",
        "model/a.mtl: line 2: texture `lost.png`: not found",
        "model/a.mtl: line 5: texture `folder`: not a regular file",
        "model/a.mtl: line 4: texture `image.tga`: not PNG or JPEG, which glTF requires; it stays a \
         reference to the file",
        "model/a.mtl: line 3: texture `../secret.png`: it leaves the folder of the file",
        "model/a.obj: material `unknown` is not in the material libraries",
    ];
    assert_eq!(warnings(&folder, &report), expected);
    let mesh = &report.mesh;
    let names: Vec<&str> = mesh.appearance.materials.iter().map(|m| m.name.as_str()).collect();
    assert_eq!((names, mesh.appearance.materials[1].gltf_json.as_str()), (vec!["m", "unknown"], ""));
    let uris: Vec<&str> = mesh.appearance.images.iter().map(|image| image.uri.as_str()).collect();
    assert_eq!(uris, ["lost.png", "folder", "image.tga", "../secret.png"]);
    assert!(mesh.appearance.images.iter().all(|image| image.bytes.is_empty() || image.uri == "image.tga"));
    // A path is read with the files outside.
    let mesh = read_with_report(inner.join("a.obj")).unwrap().mesh;
    assert_eq!(mesh.appearance.images[3].mime_type, "image/png");
    assert_eq!(materials(&mesh)[1]["pbrMetallicRoughness"]["baseColorFactor"], json!([1.0, 0.0, 0.0, 1.0]));
}

#[test]
fn libraries_and_images_may_lie_anywhere() {
    let (image, text) = (png(png::ColorType::Rgb), obj("mtllib ..\\Mtl\\a.mtl", &["m"]));
    let mtl =
        "newmtl m\nmap_Kd ../maps/../Maps/My%20Wood.png\nnorm gr\u{fc}n.png?v=3\nmap_Ke ../passwd.png\n";
    let folder = folder(&[
        ("model/deep/a.obj", text.as_bytes()),
        ("model/mtl/A.mtl", mtl.as_bytes()),
        ("model/maps/my wood.png", &image),
        ("model/mtl/gr\u{fc}n.png", &image),
        ("model/passwd.png", b"root:x:0:0:root:/root:/bin/sh\n"),
    ]);
    let report = report(&folder, "model/deep/a.obj");
    let warnings = warnings(&folder, &report);
    let expected = "texture `../passwd.png`: not an image, and outside the folder of the file";
    assert!(warnings.len() == 1 && warnings[0].ends_with(expected), "{warnings:?}");
    let sizes: Vec<usize> = report.mesh.appearance.images.iter().map(|image| image.bytes.len()).collect();
    assert_eq!(sizes, [image.len(), image.len(), 0]);
}

#[test]
fn without_a_folder_only_the_names_are_kept() {
    let report =
        read_bytes_with_report(obj("mtllib a.mtl", &["m"]).as_bytes(), &Source::new("a.obj")).unwrap();
    assert_eq!(report.mesh.appearance.materials[0].gltf_json, "");
    let expected = "a.obj: line 1: material library `a.mtl`: the folder of the file is not known";
    assert_eq!(report.warnings[0].to_string(), expected);
}

#[test]
fn library_names_may_contain_blanks() {
    let red = "newmtl red\nKd 1 0 0\nmap_Ke glow.png\n";
    let glow = png(png::ColorType::Rgb);
    for (statement, names) in [
        ("mtllib my red.mtl", vec!["my red.mtl"]),
        ("mtllib my red.mtl blue.mtl", vec!["my red.mtl", "blue.mtl"]),
        ("mtllib blue.mtl  my red.mtl ", vec!["my red.mtl", "blue.mtl"]),
        ("mtllib blue.mtl\r\nmtllib lib\\RED.MTL\nmtllib blue.mtl", vec!["lib/red.mtl", "blue.mtl"]),
        ("mtllib red blue.mtl.bak", vec!["red", "blue.mtl.bak"]),
    ] {
        let text = obj(statement, &["red", "blue"]);
        let blue = "newmtl blue\nKd 0 0 1\n".to_owned();
        let glow_name = if names[0].starts_with("lib") { "lib/glow.png" } else { "glow.png" };
        let mut files = vec![("a.obj", text.as_bytes()), (glow_name, glow.as_slice())];
        files.push((names[0], red.as_bytes()));
        files.extend(names.get(1).map(|name| (*name, blue.as_bytes())));
        let folder = folder(&files);
        let report = report(&folder, "a.obj");
        let has_blue = names.len() > 1;
        assert_eq!(report.warnings.len(), usize::from(!has_blue), "{statement}: {:?}", report.warnings);
        let [red, ..] = &report.mesh.appearance.materials[..] else { panic!() };
        assert!(red.gltf_json.contains("emissiveTexture"), "{statement}");
        assert_eq!(report.mesh.appearance.images[0].uri, glow_name);
        assert_eq!(report.mesh.appearance.material_libraries.len(), statement.matches("mtllib").count());
    }
}

#[test]
fn absolute_names_are_looked_up_by_their_file_name() {
    let image = png(png::ColorType::Rgb);
    for name in [r"C:\Users\me\wood.png", "/home/me/wood.png", "file:///wood.png", r"\\server\wood.png"] {
        let (_, mesh) = material(&format!("map_Kd {name}\n"), &[("wood.png", &image)]);
        assert_eq!(mesh.appearance.images[0].uri, "wood.png");
    }
}

#[test]
fn without_texture_coordinates_there_are_no_textures() {
    let mtl = "newmtl m\nmap_Kd a.png\nKd 1 0 0\n";
    let text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    let image = png(png::ColorType::Rgb);
    let folder = folder(&[("a.obj", text.as_bytes()), ("a.mtl", mtl.as_bytes()), ("a.png", &image)]);
    let report = report(&folder, "a.obj");
    let expected = ["a.mtl: line 2: texture `a.png`: the mesh has no texture coordinates; it is left out"];
    assert_eq!(warnings(&folder, &report), expected);
    assert!(report.mesh.appearance.images.is_empty());
    assert_survives_glb(&report.mesh);
}

#[test]
fn many_missing_textures_are_fast_and_give_few_warnings() {
    const COUNT: usize = 20_000;
    let names: Vec<String> = (0..COUNT).map(|i| format!("m{i}")).collect();
    let mtl: String = names.iter().map(|name| format!("newmtl {name}\nmap_Kd {name}.png\n")).collect();
    let text = obj("mtllib a.mtl", &names.iter().map(String::as_str).collect::<Vec<_>>());
    let folder = folder(&[("a.obj", text.as_bytes()), ("a.mtl", mtl.as_bytes())]);
    let report = report(&folder, "a.obj");
    assert_eq!((report.mesh.appearance.images.len(), report.warnings.len()), (COUNT, 101));
    assert!(report.warnings[100].to_string().ends_with(": 19900 more warnings"), "{}", report.warnings[100]);
}

#[test]
fn damaged_libraries_never_fail() {
    let mtl = b"# Blender\nnewmtl m\nKd 0.5 0.5 0.5\nNs 10\nd 0.5\nmap_Kd -s 1 2 3 -o 1 a.png\nmap_Pr a.png\nillum 2\n";
    let folder =
        folder(&[("a.obj", obj("mtllib a.mtl", &["m"]).as_bytes()), ("a.png", &png(png::ColorType::Rgb))]);
    let write = |bytes: &[u8]| fs::write(Path::new(folder.path()).join("a.mtl"), bytes).unwrap();
    for at in 0..mtl.len() {
        for byte in [0, b'\n', b'-', b'9', 0xff] {
            let mut damaged = mtl.to_vec();
            damaged[at] = byte;
            write(&damaged);
            assert_survives_glb(&report(&folder, "a.obj").mesh);
        }
        write(&mtl[..at]);
        assert_survives_glb(&report(&folder, "a.obj").mesh);
    }
}
