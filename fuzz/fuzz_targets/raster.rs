//! Opens rasters of arbitrary bytes (GeoTIFF, HGT, PNG), alone and as two tiles of one terrain, and plans a paged
//! build of each: an error, or consistent pieces and a plan that can be opened again.
#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use striata::ignore_progress;
use striata_fuzz::Bytes;
use striata_io::pieces::{PieceOptions, PieceSource, Terrain, open_all};
use striata_paged::build::{BuildInput, BuildOptions, BuildPaths, PagedPlan};

fuzz_target!(|data: &[u8]| {
    let mut bytes = Bytes(data);
    let (kind, cut) = (bytes.byte(), bytes.short());
    let folder = tempfile::tempdir().expect("a folder for temporary files");
    let mut paths = Vec::new();
    let mut add = |name: &str, content: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, content).expect("room for a file");
        paths.push(path);
    };
    match kind % 4 {
        0 => add("x.tif", bytes.0),
        1 => {
            let (first, second) = bytes.0.split_at(cut.min(bytes.0.len()));
            add("x.tif", first);
            add("y.tif", second);
        }
        2 => add("x.png", bytes.0),
        _ => {
            let side = (bytes.0.len() / 2).isqrt();
            add("N10E020.hgt", &bytes.0[..2 * side * side]);
        }
    }
    let nodata = (kind & 16 != 0).then_some(f64::from(kind));
    let z_scale = if kind & 32 != 0 { 1e30 } else { 1.0 };
    let options = PieceOptions::default().with_nodata(nodata).with_z_scale(z_scale);
    if let Ok(source) = open_all(&paths, &options) {
        check_pieces(&*source);
    }
    if let Ok(terrain) = Terrain::open(&paths, &options)
        && let Ok(mesh) = terrain.mesh()
    {
        mesh.check().expect("a raster that is read is a valid mesh");
    }
    check_plan(BuildInput::Files(paths), folder.path());
});

/// Reads pieces: their triangles have corners that exist, at finite heights.
fn check_pieces(source: &dyn PieceSource) {
    for index in 0..source.piece_count().min(50) {
        let Ok(piece) = source.read_piece(index) else { return };
        assert!(piece.positions.as_flattened().iter().all(|x| x.is_finite()));
        let count = piece.positions.len();
        assert!(piece.triangles.as_flattened().iter().all(|&v| (v as usize) < count));
    }
}

/// Plans a build: what is written can be read again.
fn check_plan(input: BuildInput, folder: &Path) {
    let (output, work) = (folder.join("x.striata"), folder.join("work"));
    let paths = BuildPaths { output: &output, folder: &work };
    let Ok(plan) = PagedPlan::make(input, BuildOptions::default(), paths, 1, &mut ignore_progress) else {
        return;
    };
    let again = PagedPlan::open(&work).expect("a plan that was written can be opened");
    assert_eq!(again.metadata, plan.metadata);
}
