//! Passes arbitrary bytes to every reader: the result is a mesh or an error, and a valid mesh survives
//! every writer.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::mesh::IndexedMesh;
use striata_io::{Format, Source, WriteOptions, read_bytes, to_bytes};

const NAMES: [&str; 13] = [
    "x.ply",
    "x.obj",
    "x.stl",
    "x.off",
    "x.gltf",
    "x.glb",
    "x.obj.gz",
    "x.ply.zst",
    "x",
    "x.vtk",
    "x.vtp",
    "x.vtu",
    "x.3mf",
];

fuzz_target!(|data: &[u8]| {
    let Some((&name, bytes)) = data.split_first() else { return };
    let name = NAMES[usize::from(name) % NAMES.len()];
    let Ok(mesh) = read_bytes(bytes, &Source::new(name)) else { return };
    if mesh.check().is_ok() && mesh.triangle_count() > 0 {
        Format::meshes().for_each(|format| write_and_read(format, &mesh));
    }
});

/// A writer may reject what its format cannot represent, but whatever it writes must be readable.
fn write_and_read(format: Format, mesh: &IndexedMesh) {
    let Ok(bytes) = to_bytes(format, mesh, &WriteOptions::default()) else { return };
    let name = format!("x.{}", format.extension());
    match read_bytes(&bytes, &Source::new(&name)) {
        Ok(again) => assert_eq!(again.triangle_count(), mesh.triangle_count(), "{format} loses triangles"),
        Err(error) => panic!("{format} cannot be read back: {error}"),
    }
}
