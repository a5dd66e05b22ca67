//! Opens files of arbitrary bytes in pieces and reads all of them: an error, or consistent pieces. A glTF
//! file that the reader of whole files accepts has the same triangles in pieces.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata_fuzz::allow_contained_panics;
use striata_io::pieces::{LayerKind, Piece, PieceOptions, PieceSource, open_pieces};
use striata_io::{ReadError, read};

const NAMES: [&str; 8] = ["x.ply", "x.obj", "x.stl", "x.off", "x.gltf", "x.glb", "x.obj.gz", "x.glb.zst"];

fuzz_target!(|data: &[u8]| {
    let Some((&name, bytes)) = data.split_first() else { return };
    allow_contained_panics();
    let name = NAMES[usize::from(name) % NAMES.len()];
    let folder = tempfile::tempdir().expect("a folder for temporary files");
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).expect("room for a file");
    let options = PieceOptions::default().with_piece_triangle_count(4);
    let count = open_pieces(&path, &options).and_then(|source| count_triangles(&*source));
    if !name.contains(".gl") {
        return;
    }
    if let Ok(mesh) = read(&path)
        && mesh.check().is_ok()
    {
        let count = count.expect("the whole file can be read");
        assert_eq!(count, mesh.triangle_count());
    }
});

fn count_triangles(source: &dyn PieceSource) -> Result<usize, ReadError> {
    let mut count = 0;
    // A file of some bytes may show its triangles any number of times.
    for index in 0..source.piece_count().min(10_000) {
        let piece = source.read_piece(index)?;
        check(&piece, source);
        count += piece.triangles.len();
    }
    Ok(count)
}

fn check(piece: &Piece, source: &dyn PieceSource) {
    let (summary, vertex_count) = (source.summary(), piece.positions.len());
    assert!(piece.triangles.as_flattened().iter().all(|&v| (v as usize) < vertex_count));
    assert!(piece.positions.as_flattened().iter().all(|x| x.is_finite()));
    assert!(piece.groups.is_empty() || piece.groups.len() == piece.triangles.len());
    assert!(piece.groups.iter().all(|&group| (group as usize) < summary.groups.len()));
    let kinds: Vec<LayerKind> = piece.layers.iter().map(LayerKind::of).collect();
    assert_eq!(kinds, summary.layers);
    for layer in &piece.layers {
        assert_eq!(layer.data.len(), vertex_count * usize::from(layer.component_count));
    }
}
