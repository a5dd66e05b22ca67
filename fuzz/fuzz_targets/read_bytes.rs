//! Passes arbitrary bytes to every reader: the result is a mesh or an error, and a valid mesh survives
//! every writer.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::mesh::IndexedMesh;
use striata_io::{Format, Source, WriteOptions, read_bytes, to_bytes};

const NAMES: [&str; 9] =
    ["x.ply", "x.obj", "x.stl", "x.off", "x.gltf", "x.glb", "x.obj.gz", "x.ply.zst", "x"];
const FORMATS: [Format; 5] = [Format::Ply, Format::Obj, Format::Stl, Format::Off, Format::Glb];

fuzz_target!(|data: &[u8]| {
    let Some((&name, bytes)) = data.split_first() else { return };
    let name = NAMES[usize::from(name) % NAMES.len()];
    let Ok(mesh) = read_bytes(bytes, &Source::new(name)) else { return };
    if mesh.check().is_ok() && mesh.triangle_count() > 0 {
        FORMATS.into_iter().for_each(|format| write_and_read(format, &mesh));
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
