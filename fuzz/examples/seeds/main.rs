//! Writes small valid files for the fuzzer to start from to `fuzz/corpus/TARGET/`.

mod scenes;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use striata::file::{FileModel, WriteOptions, to_striata, write_fragments};
use striata::mesh::{FragmentedMesh, IndexedMesh};
use striata::model::{Fans, LodStrips, Mts, Patterns};
use striata::simplify::{BatchOptions, SequenceOptions, build_batches, build_sequence};
use striata::strip::stripify;
use striata_io::Format;
use striata_lab::baseline::SequentialPatterns;
use striata_stream::{Effort, Precision, StreamOptions, encode_stream, file_model};
use striata_testing::meshes;

fn main() -> Result<(), Box<dyn Error>> {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus");
    let folder = |target: &str| -> std::io::Result<PathBuf> {
        let path = corpus.join(target);
        fs::create_dir_all(&path).map(|()| path)
    };
    let meshes: Vec<(&str, IndexedMesh)> = meshes::nasty()
        .into_iter()
        .filter(|(_, mesh)| mesh.check().is_ok() && mesh.triangle_count() < 100)
        .collect();
    for (i, (_, mesh)) in meshes.iter().enumerate() {
        // The first three names are the same in all targets.
        for target in ["read_bytes", "pieces", "triangle_blocks"] {
            write_formats(i, mesh, &folder(target)?)?;
        }
        let folder_of_files = folder("striata_file")?;
        for (name, bytes) in containers(mesh)? {
            fs::write(folder_of_files.join(format!("{i}-{name}.striata")), bytes)?;
        }
        if let Some(bytes) = patterns(mesh)? {
            fs::write(folder("sequential_patterns")?.join(i.to_string()), bytes)?;
        }
        for (name, bytes) in streams(mesh)? {
            fs::write(folder("progressive_stream")?.join(format!("{i}-{name}")), bytes)?;
        }
        for target in ["simplify", "stripify"] {
            fs::write(folder(target)?.join(i.to_string()), as_fuzz_input(mesh))?;
        }
    }
    for (target, name, bytes) in scenes::inputs()? {
        fs::write(folder(target)?.join(name), bytes)?;
    }
    Ok(())
}

/// A file name and its contents.
type NamedBytes = (&'static str, Vec<u8>);

/// Progressive streams of each effort, and a lossless one.
fn streams(mesh: &IndexedMesh) -> Result<Vec<NamedBytes>, Box<dyn Error>> {
    let built = build_batches(mesh, &BatchOptions::default().with_general_floor(0))?;
    let options = StreamOptions::default().with_precision(Precision::Bits(8));
    let forms = [
        ("fast", options.clone()),
        ("compact", options.clone().with_effort(Effort::Compact)),
        ("exact", options.with_precision(Precision::Lossless)),
    ];
    let write = |(name, options)| {
        let stream = encode_stream(&built.built.refinable, &built.batches, &options)?;
        Ok((name, stream.bytes))
    };
    forms.into_iter().map(write).collect()
}

/// Patterns in sequential form, if the mesh is a surface.
fn patterns(mesh: &IndexedMesh) -> Result<Option<Vec<u8>>, Box<dyn Error>> {
    let simplified = build_sequence(mesh, &SequenceOptions::default())?;
    let fragmented = FragmentedMesh::from_collapses(&simplified.refinable);
    Ok(SequentialPatterns::encode(&fragmented).ok().map(|written| written.as_bytes().to_vec()))
}

/// The index of each format's extension in the list of `read_bytes`.
const FORMATS: [(u8, Format); 10] = [
    (0, Format::Ply),
    (1, Format::Obj),
    (2, Format::Stl),
    (3, Format::Off),
    (4, Format::Gltf),
    (5, Format::Glb),
    (9, Format::Vtk),
    (10, Format::Vtp),
    (11, Format::Vtu),
    (12, Format::ThreeMf),
];

fn write_formats(i: usize, mesh: &IndexedMesh, folder: &Path) -> Result<(), Box<dyn Error>> {
    for (place, format) in FORMATS {
        for ascii in [false, true] {
            let options = striata_io::WriteOptions::default().with_ascii(ascii);
            // Some formats cannot represent an empty mesh.
            let Ok(bytes) = striata_io::to_bytes(format, mesh, &options) else { continue };
            let name = format!("{i}-{ascii}.{}", format.extension());
            fs::write(folder.join(name), [&[place], &bytes[..]].concat())?;
        }
    }
    Ok(())
}

/// A file named for its contents.
type Container = (&'static str, Vec<u8>);

/// Files with strip models, with fans alone, with patterns (with and without collapses), and with a
/// stream alone.
fn containers(mesh: &IndexedMesh) -> Result<[Container; 5], Box<dyn Error>> {
    let refinable = build_sequence(mesh, &SequenceOptions::default())?.refinable;
    let strips = stripify(&refinable.mesh)?;
    let (lod_strips, mts) = (LodStrips::build(&refinable, &strips)?, Mts::build(&refinable, &strips)?);
    let fans = Fans::build(&refinable);
    let strips = [FileModel::LodStrips(&lod_strips), FileModel::Mts(&mts)];
    let written = |models: &[FileModel<'_>]| to_striata(&refinable, models, &WriteOptions::default());
    let fragmented = FragmentedMesh::from_collapses(&refinable);
    let patterns = Patterns::build(&fragmented)?;
    let mut fragments = Vec::new();
    write_fragments(
        &fragmented,
        &[FileModel::Patterns(&patterns)],
        &WriteOptions::default(),
        &mut fragments,
    )?;
    Ok([
        ("strips", written(&strips)?),
        ("fans", written(&[FileModel::Fans(&fans)])?),
        ("patterns", written(&[FileModel::Patterns(&patterns)])?),
        ("fragments", fragments),
        ("stream", stream_in_file(mesh)?),
    ])
}

fn stream_in_file(mesh: &IndexedMesh) -> Result<Vec<u8>, Box<dyn Error>> {
    let made = build_batches(mesh, &BatchOptions::default())?;
    let refinable = &made.built.refinable;
    let stream = encode_stream(refinable, &made.batches, &StreamOptions::default())?;
    let models = [file_model(&stream.bytes)?];
    Ok(to_striata(&stream.reorder(refinable), &models, &WriteOptions::default())?)
}

/// Options, shape, vertices on integer coordinates, cuts, triangles: the input that `Bytes::mesh` reads.
fn as_fuzz_input(mesh: &IndexedMesh) -> Vec<u8> {
    let vertex_count = mesh.vertex_count().min(48);
    let mut out = vec![0, 0, vertex_count.saturating_sub(1) as u8];
    let coordinate = |x: &f32| [255].into_iter().chain(x.to_le_bytes());
    out.extend(mesh.positions[..vertex_count].iter().flatten().flat_map(coordinate));
    out.extend([0, 0]);
    out.extend(mesh.triangles.iter().flatten().map(|&v| v as u8));
    out
}
