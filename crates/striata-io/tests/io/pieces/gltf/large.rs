//! A file that does not fit into memory is not copied.

use std::time::Instant;

use serde_json::json;
use striata_io::pieces::open_pieces;
use tempfile::TempDir;

use super::options;

/// Size of the process in memory, apart from mapped files, in bytes.
#[cfg(target_os = "linux")]
fn resident_bytes() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("RssAnon:")).unwrap();
    let kilobytes: u64 = line.split_whitespace().nth(1).unwrap().parse().unwrap();
    kilobytes << 10
}

/// Nine gigabytes, nearly all of which are a hole that takes no room on disk: 500 million triangles, more
/// than a mesh in memory may have indices, of which one far from the start is no zero.
#[cfg(target_os = "linux")]
#[test]
fn one_piece_of_a_huge_file_is_read_alone() {
    use std::fs::File;
    use std::os::unix::fs::FileExt as _;

    let (index_count, vertex_count) = (1_500_000_000u64, 250_000_000u64);
    let folder = TempDir::new().unwrap();
    let buffer = File::create(folder.path().join("huge.bin")).unwrap();
    let bytes = 4 * index_count + 12 * vertex_count;
    if buffer.set_len(bytes).is_err() {
        eprintln!("skipped: the file system has no room for holes");
        return;
    }
    let triangle = 444_444_444;
    let corners = [1, vertex_count - 1, 7];
    for (corner, vertex) in corners.into_iter().enumerate() {
        let place = 4 * (3 * triangle + corner as u64);
        buffer.write_all_at(&(vertex as u32).to_le_bytes(), place).unwrap();
        let position = [vertex as f32, 1.0, 2.0];
        let position: Vec<u8> = position.iter().flat_map(|x| x.to_le_bytes()).collect();
        buffer.write_all_at(&position, 4 * index_count + 12 * vertex).unwrap();
    }
    let document = json!({
        "asset": { "version": "2.0" },
        "buffers": [{ "byteLength": bytes, "uri": "huge.bin" }],
        "bufferViews": [
            { "buffer": 0, "byteLength": 4 * index_count },
            { "buffer": 0, "byteOffset": 4 * index_count, "byteLength": 12 * vertex_count },
        ],
        "accessors": [
            { "bufferView": 0, "componentType": 5125, "count": index_count, "type": "SCALAR" },
            { "bufferView": 1, "componentType": 5126, "count": vertex_count, "type": "VEC3" },
        ],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 1 }, "indices": 0 }] }],
    });
    let path = folder.path().join("huge.gltf");
    std::fs::write(&path, document.to_string()).unwrap();
    let (started, before) = (Instant::now(), resident_bytes());
    let source = open_pieces(&path, &options(100_000)).unwrap();
    assert_eq!(source.summary().triangle_count, index_count / 3);
    assert_eq!(source.piece_count(), 5000);
    let piece = source.read_piece(triangle / 100_000).unwrap();
    let grown = resident_bytes().saturating_sub(before);
    let corners = piece.triangles[(triangle % 100_000) as usize].map(|v| piece.positions[v as usize]);
    assert_eq!(corners, [[1.0, 1.0, 2.0], [(vertex_count - 1) as f32, 1.0, 2.0], [7.0, 1.0, 2.0]]);
    assert_eq!((piece.positions.len(), piece.triangles.len()), (4, 100_000));
    assert!(grown < 512 << 20, "reading takes {grown} bytes");
    assert!(started.elapsed().as_secs() < 20, "{:?}", started.elapsed());
}
