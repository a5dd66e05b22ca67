//! Textured PLY files, as MeshLab and photogrammetry programs write them.

use std::fs;

use crate::meshes::{group, read, refused, round_trip, soup, square, written};
use proptest::prelude::*;
use serde_json::{Value, json};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};
use striata_io::{Format, Source, read_bytes_with_report, read_with_report};

/// Encoding of a test file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Encoding {
    Ascii,
    Little,
    Big,
}

const ENCODINGS: [Encoding; 3] = [Encoding::Ascii, Encoding::Little, Encoding::Big];

/// A face with its texture coordinates and texture number.
type Face<'a> = (&'a [i32], &'a [f32], i32);

/// Writes a file with `vertex_count` vertices, and faces with texture data; the positions are `[i, i * i,
/// 0]`.
fn ply(encoding: Encoding, comments: &str, vertex_count: usize, faces: &[Face<'_>]) -> Vec<u8> {
    let name = match encoding {
        Encoding::Ascii => "ascii",
        Encoding::Little => "binary_little_endian",
        Encoding::Big => "binary_big_endian",
    };
    let mut out = format!(
        "ply\nformat {name} 1.0\n{comments}element vertex {vertex_count}\nproperty float x\nproperty float y\n\
         property float z\nproperty uchar id\nelement face {}\nproperty list uchar float texcoord\n\
         property list uchar int vertex_indices\nproperty uchar red\nproperty int texnumber\nend_header\n",
        faces.len()
    )
    .into_bytes();
    let mut push = |bytes: &[u8], text: String| match encoding {
        Encoding::Ascii => out.extend_from_slice(format!("{text} ").as_bytes()),
        Encoding::Little => out.extend_from_slice(bytes),
        Encoding::Big => out.extend(bytes.iter().rev()),
    };
    for i in 0..vertex_count {
        for x in [i as f32, (i * i) as f32, 0.0] {
            push(&x.to_le_bytes(), x.to_string());
        }
        push(&[i as u8], i.to_string());
    }
    for (indices, texcoords, number) in faces {
        push(&[texcoords.len() as u8], texcoords.len().to_string());
        texcoords.iter().for_each(|x| push(&x.to_le_bytes(), x.to_string()));
        push(&[indices.len() as u8], indices.len().to_string());
        indices.iter().for_each(|i| push(&i.to_le_bytes(), i.to_string()));
        push(&[200], "200".to_owned());
        push(&number.to_le_bytes(), number.to_string());
    }
    out
}

fn texcoords(mesh: &IndexedMesh) -> &[f32] {
    match &mesh.layer(&Semantic::TexCoord(0)).unwrap().data {
        LayerData::F32(values) => values,
        other => panic!("{other:?}"),
    }
}

/// A quad and a triangle that disagree about vertex 2, and a triangle without a texture.
const FACES: [Face<'static>; 3] = [
    (&[0, 1, 2, 3], &[0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0], 1),
    (&[3, 2, 4], &[0.0, 1.0, 0.5, 0.5, 0.25, 0.25], 0),
    (&[0, 1, 4], &[], -1),
];

#[test]
fn coordinates_of_faces_split_vertices() {
    for encoding in ENCODINGS {
        let mesh = read("x.ply", &ply(encoding, "", 5, &FACES)).unwrap();
        mesh.check().unwrap();
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [3, 4, 5], [0, 1, 5]], "{encoding:?}");
        let ids = LayerData::U8(vec![0, 1, 2, 3, 2, 4]);
        assert_eq!(mesh.layer(&Semantic::Generic("id".to_owned())).unwrap().data, ids);
        let expected = [0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.25, 0.75];
        assert_eq!(texcoords(&mesh), expected, "`v` counts from the bottom");
        assert!(mesh.groups.is_empty() && mesh.appearance.is_empty());
    }
}

#[test]
fn vertices_without_seams_keep_their_order() {
    let faces: [Face<'_>; 1] = [(&[3, 1, 0], &[0.5, 0.0, 1.0, 0.25, 0.0, 0.75], 0)];
    let mesh = read("x.ply", &ply(Encoding::Little, "", 4, &faces)).unwrap();
    assert_eq!((mesh.triangles.as_slice(), mesh.vertex_count()), (&[[3, 1, 0]][..], 4));
    assert_eq!(texcoords(&mesh), [0.0, 0.25, 1.0, 0.75, 0.0, 0.0, 0.5, 1.0]);
    let empty: [Face<'_>; 1] = [(&[3, 1, 0], &[], 0)];
    let mesh = read("x.ply", &ply(Encoding::Ascii, "", 4, &empty)).unwrap();
    assert!(mesh.layer(&Semantic::TexCoord(0)).is_none());
}

#[test]
fn texture_files_become_materials() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("Roof Tiles.jpg"), b"\xff\xd8\xff...").unwrap();
    let comments = "comment TextureFile Roof Tiles.jpg\ncomment by hand\ncomment TextureFile lost.png\n";
    for encoding in ENCODINGS {
        let path = folder.path().join("x.ply");
        fs::write(&path, ply(encoding, comments, 5, &FACES)).unwrap();
        let report = read_with_report(&path).unwrap();
        let mesh = &report.mesh;
        mesh.check().unwrap();
        let expected = format!("{}: line 5: texture `lost.png`: not found", path.display());
        assert_eq!(report.warnings.iter().map(ToString::to_string).collect::<Vec<_>>(), [expected]);
        // The triangles of texture 0 come first, those without a texture last.
        assert_eq!(mesh.triangles, [[3, 4, 5], [0, 1, 2], [0, 2, 3], [0, 1, 5]]);
        let groups = [group("", Some(0), 0, 1), group("", Some(1), 1, 2), group("", None, 3, 1)];
        assert_eq!(mesh.groups, groups);
        let flipped = [0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.25, 0.75];
        assert_eq!(texcoords(mesh), flipped);
        let appearance = &mesh.appearance;
        let names: Vec<&str> = appearance.materials.iter().map(|m| m.name.as_str()).collect();
        assert_eq!(names, ["Roof Tiles", "lost"]);
        let value: Value = serde_json::from_str(&appearance.materials[1].gltf_json).unwrap();
        assert_eq!(
            value["pbrMetallicRoughness"],
            json!({ "baseColorTexture": { "index": 1 }, "metallicFactor": 0.0 })
        );
        assert_eq!(
            (appearance.images[0].mime_type.as_str(), appearance.images[0].bytes.len()),
            ("image/jpeg", 6)
        );
        assert_eq!((appearance.images[1].uri.as_str(), appearance.images[1].bytes.len()), ("lost.png", 0));
        let back = read("x.glb", &written(Format::Glb, mesh)).unwrap();
        assert_eq!((soup(&back), texcoords(&back)), (soup(mesh), texcoords(mesh)));
        assert_eq!(back.appearance.materials, appearance.materials);
        assert_eq!(texcoords(&round_trip(Format::Ply, mesh)), texcoords(mesh));
    }
}

#[test]
fn coordinates_of_vertices_are_flipped_with_and_without_a_texture_file() {
    let mut mesh = square();
    let own = vec![0.0, 0.25, 1.0, 0.5, 0.0, 0.0, 1.0, 1.0];
    mesh.layers = vec![AttributeLayer::from_f32(Semantic::TexCoord(0), 2, own.clone())];
    let plain = written(Format::Ply, &mesh);
    assert_eq!(texcoords(&read("x.ply", &plain).unwrap()), own);
    let comment = b"comment texturefile a.png\ncomment TextureFile b.png\n";
    let at = plain.windows(8).position(|word| word == b"element ").unwrap();
    let textured = [&plain[..at], comment, &plain[at..]].concat();
    let report = read_bytes_with_report(&textured, &Source::new("x.ply")).unwrap();
    assert_eq!(texcoords(&report.mesh), own);
    assert_eq!(report.mesh.groups, [group("", Some(0), 0, 2)]);
    let warnings: Vec<String> = report.warnings.iter().map(ToString::to_string).collect();
    let expected = [
        "x.ply: line 3: texture `a.png`: the folder of the file is not known",
        "x.ply: line 4: texture `b.png`: the folder of the file is not known",
        "x.ply: line 4: 2 textures, but no `texnumber`: all faces get the first one",
    ];
    assert_eq!(warnings, expected);
}

#[test]
fn textures_without_coordinates_or_with_unknown_numbers_are_warnings() {
    let faces: [Face<'_>; 1] = [(&[0, 1, 2], &[], 0)];
    let bytes = ply(Encoding::Ascii, "comment TextureFile a.png\n", 3, &faces);
    let report = read_bytes_with_report(&bytes, &Source::new("x.ply")).unwrap();
    assert!(report.mesh.appearance.is_empty() && report.mesh.groups.is_empty());
    let expected = "x.ply: line 3: texture `a.png`: the mesh has no texture coordinates; it is left out";
    assert_eq!(report.warnings[0].to_string(), expected);
    let faces: [Face<'_>; 2] = [(&[0, 1, 2], &[0.0; 6], 7), (&[2, 1, 0], &[0.0; 6], 0)];
    let bytes = ply(Encoding::Big, "comment TextureFile a.png\n", 3, &faces);
    let report = read_bytes_with_report(&bytes, &Source::new("x.ply")).unwrap();
    assert_eq!(report.mesh.groups, [group("", Some(0), 0, 1), group("", None, 1, 1)]);
    let expected = "x.ply: texture number 7 does not exist: there are 1 textures";
    assert_eq!(report.warnings[1].to_string(), expected);
}

#[test]
fn lists_that_do_not_match_the_polygon_are_refused() {
    for length in [1, 5, 7, 8] {
        let coordinates = vec![0.5; length];
        let faces: [Face<'_>; 2] = [FACES[0], (&[0, 1, 2], &coordinates, 0)];
        let expected = format!("`texcoord` has {length} numbers for 3 corners; expected 6");
        let binary = ply(Encoding::Little, "", 5, &faces);
        // The list is followed by its own numbers and by those of the rest of the row.
        let at = binary.len() - (length * 4 + 1 + 12 + 1 + 4);
        let message = refused("x.ply", &binary);
        assert!(message.contains(&expected) && message.contains(&format!("byte {at}:")), "{message}");
        let message = refused("x.ply", &ply(Encoding::Ascii, "", 5, &faces));
        assert!(message.contains(&expected) && message.contains("line "), "{message}");
    }
}

proptest! {
    #[test]
    fn damaged_files_are_an_error_or_a_consistent_mesh(
        encoding in prop::sample::select(ENCODINGS.to_vec()),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..4),
        length in any::<prop::sample::Index>(),
    ) {
        let mut bytes = ply(encoding, "comment TextureFile a.png\n", 5, &FACES);
        let body = bytes.windows(11).position(|word| word == b"end_header\n").unwrap() + 11;
        for (place, value) in changes {
            let place = body + place.index(bytes.len() - body);
            bytes[place] = value;
        }
        bytes.truncate(body + length.index(bytes.len() - body + 1));
        if let Ok(mesh) = read("x.ply", &bytes) {
            let is_finite = mesh.positions.iter().flatten().all(|x| x.is_finite());
            prop_assert!(mesh.check().is_ok() || !is_finite);
        }
    }

    #[test]
    fn all_encodings_give_every_corner_its_coordinates(
        polygons in prop::collection::vec(
            (prop::collection::vec((0..6i32, 0..3u8, 0..3u8), 3..6), -1..3i32), 1..12),
    ) {
        let lists: Vec<(Vec<i32>, Vec<f32>)> = polygons.iter().map(|(corners, _)| {
            let indices = corners.iter().map(|&(i, ..)| i).collect();
            (indices, corners.iter().flat_map(|&(_, u, v)| [f32::from(u) / 2.0, f32::from(v) / 2.0]).collect())
        }).collect();
        let faces: Vec<Face<'_>> =
            lists.iter().zip(&polygons).map(|((i, t), (_, number))| (&i[..], &t[..], *number)).collect();
        let comments = "comment TextureFile a.png\ncomment TextureFile b.png\n";
        // Fans in the order of the textures, none and unknown ones last.
        let mut expected = Vec::new();
        for texture in 0..3 {
            for (corners, number) in &polygons {
                let found = if (0..2).contains(number) { *number } else { 2 };
                for pair in corners[1..].windows(2).filter(|_| found == texture) {
                    expected.push([corners[0], pair[0], pair[1]]);
                }
            }
        }
        for encoding in ENCODINGS {
            let mesh = read("x.ply", &ply(encoding, comments, 6, &faces)).unwrap();
            prop_assert!(mesh.check().is_ok());
            let coordinates = texcoords(&mesh);
            let found: Vec<_> = mesh.triangles.iter().map(|triangle| triangle.map(|vertex| {
                let vertex = vertex as usize;
                let v = 1.0 - coordinates[2 * vertex + 1];
                (mesh.positions[vertex][0] as i32, (coordinates[2 * vertex] * 2.0) as u8, (v * 2.0) as u8)
            })).collect();
            prop_assert_eq!(&found, &expected);
            // No two used vertices are the same corner.
            let mut corners: Vec<_> = found.iter().flatten().copied().collect();
            corners.sort_unstable();
            corners.dedup();
            let mut used: Vec<u32> = mesh.triangles.iter().flatten().copied().collect();
            used.sort_unstable();
            used.dedup();
            prop_assert_eq!(corners.len(), used.len());
        }
    }
}
