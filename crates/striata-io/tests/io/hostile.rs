//! Damaged files of every format, truncated or with changed bytes, give an error or a consistent mesh.

use crate::meshes::{self, read, sheet, square_with_everything, written};
use proptest::prelude::*;
use striata::mesh::{IndexedMesh, MeshError};
use striata_io::{Format, WriteOptions, to_bytes};

/// Returns a file of a small mesh in every format, with its name.
fn files() -> Vec<(String, Vec<u8>)> {
    let mut mesh = square_with_everything();
    mesh.groups = vec![meshes::group("a", None, 0, 1), meshes::group("b", None, 1, 1)];
    let mut files: Vec<(String, Vec<u8>)> = Format::meshes()
        .map(|format| (format!("x.{}", format.extension()), written(format, &mesh)))
        .collect();
    let ascii = to_bytes(Format::Ply, &mesh, &WriteOptions::default().with_ascii(true)).unwrap();
    files.push(("ascii.ply".to_owned(), ascii));
    let stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n\
        endfacet\nendsolid a\n";
    files.push(("ascii.stl".to_owned(), stl.into()));
    let mut big =
        b"ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
        property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
            .to_vec();
    big.extend_from_slice(&[0; 12]);
    big.extend_from_slice(&[3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
    files.push(("big.ply".to_owned(), big));
    files
}

/// Checks that the mesh is consistent, except for its coordinates.
fn assert_consistent(name: &str, mesh: &IndexedMesh) {
    match mesh.check() {
        Ok(()) | Err(MeshError::NonFinitePosition { .. }) => {}
        Err(error) => panic!("{name} was read as a broken mesh: {error}"),
    }
}

#[test]
fn every_truncation_is_an_error_or_a_consistent_mesh() {
    for (name, bytes) in files() {
        let mut refused_count = 0;
        for length in 0..bytes.len() {
            match read(&name, &bytes[..length]) {
                Ok(mesh) => assert_consistent(&name, &mesh),
                Err(error) => {
                    assert!(error.to_string().starts_with(&name), "{error}");
                    refused_count += 1;
                }
            }
        }
        // OBJ declares no counts, so most of its prefixes are complete files; STL may lack its last line,
        // and legacy VTK ends with optional data.
        let least = if name == "ascii.stl" { 8 } else { 9 };
        assert!(
            name.ends_with(".obj") || name.ends_with(".vtk") || refused_count > bytes.len() * least / 10,
            "{name}: {refused_count}"
        );
    }
}

#[test]
fn damaged_compressed_files_are_refused() {
    use std::io::Write as _;
    let mesh = sheet(8);
    let plain = written(Format::Ply, &mesh);
    let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    gzip.write_all(&plain).unwrap();
    let gzip = gzip.finish().unwrap();
    let zstd = zstd::bulk::compress(&plain, 3).unwrap();
    for (name, bytes) in [("x.ply.gz", &gzip), ("x.ply.zst", &zstd), ("x", &zstd)] {
        assert_eq!(read(name, bytes).unwrap(), mesh);
        for length in 5..bytes.len() {
            assert!(read(name, &bytes[..length]).is_err(), "{name} cut to {length}");
        }
    }
    assert_eq!(read("x.gz.zst", &zstd::bulk::compress(&gzip, 3).unwrap()).unwrap(), mesh);
    // Decompression bombs: hundreds of megabytes in a few of them.
    let letters = || std::io::Read::take(std::io::repeat(b'v'), 1 << 28);
    let zeros = || std::io::Read::take(std::io::repeat(0), 1 << 28);
    let gzipped = |mut content: std::io::Take<std::io::Repeat>| {
        let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
        std::io::copy(&mut content, &mut gzip).unwrap();
        gzip.finish().unwrap()
    };
    for bomb in [zstd::stream::encode_all(letters(), 1).unwrap(), gzipped(letters())] {
        let message = meshes::refused("x.ply", &bomb);
        assert!(message.contains("unpack to more than"), "{message}");
    }
    for bomb in [zstd::stream::encode_all(zeros(), 1).unwrap(), gzipped(zeros())] {
        let message = meshes::refused("x.ply", &bomb);
        assert!(message.contains("unpack to zeros, with which no format begins"), "{message}");
    }
}

#[test]
fn the_name_decides_if_the_content_does_not() {
    assert!(meshes::refused("x.png", b"\x89PNG").contains("this is a raster or an image"));
    assert!(meshes::refused("x.striata", b"STRIATA\0abc").contains("extract a level"));
    assert!(
        striata_io::read("/no/such/file.ply").unwrap_err().to_string().starts_with("/no/such/file.ply: ")
    );
    let mesh = sheet(3);
    assert_eq!(read("misnamed.obj", &written(Format::Ply, &mesh)).unwrap(), mesh);
    assert_eq!(read("no_name", &written(Format::Stl, &mesh)).unwrap().triangle_count(), 18);
}

#[test]
fn files_are_written_and_read_by_path() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = sheet(5);
    for name in ["a.ply", "a.obj", "a.off", "a.glb", "a.gltf", "a.ply.gz", "a.obj.zst"] {
        let path = folder.path().join(name);
        striata_io::write(&path, &mesh, &WriteOptions::default()).unwrap();
        let back = striata_io::read(&path).unwrap();
        assert_eq!(
            (back.positions, back.triangles),
            (mesh.positions.clone(), mesh.triangles.clone()),
            "{name}"
        );
    }
    let error = striata_io::write(folder.path().join("a.doc"), &mesh, &WriteOptions::default()).unwrap_err();
    assert!(error.to_string().contains("names no mesh format"), "{error}");
    assert!(striata_io::write(folder.path().join("no/a.ply"), &mesh, &WriteOptions::default()).is_err());
    // The buffer of `a.gltf` is a file of its own.
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 8);
}

proptest! {
    #![proptest_config(striata_testing::cases(1500))]

    #[test]
    fn changed_bytes_are_an_error_or_a_consistent_mesh(
        file in 0usize..13,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let (name, mut bytes) = files().swap_remove(file);
        for (place, value) in changes {
            let place = place.index(bytes.len());
            bytes[place] = value;
        }
        if let Ok(mesh) = read(&name, &bytes) {
            assert_consistent(&name, &mesh);
        }
    }

    #[test]
    fn changed_digits_are_an_error_or_a_consistent_mesh(
        file in prop::sample::select(vec![1usize, 3, 4, 6]),
        changes in prop::collection::vec((any::<prop::sample::Index>(), b'0'..=b'9'), 1..8),
    ) {
        let (name, mut bytes) = files().swap_remove(file);
        let digits: Vec<usize> = (0..bytes.len()).filter(|&i| bytes[i].is_ascii_digit()).collect();
        for (place, digit) in changes {
            bytes[digits[place.index(digits.len())]] = digit;
        }
        if let Ok(mesh) = read(&name, &bytes) {
            assert_consistent(&name, &mesh);
        }
    }
}
