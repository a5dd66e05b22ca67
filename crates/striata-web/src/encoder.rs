//! Encodes a whole file of any format as a stream (`.stri`), as a GLB file with streams, or as one of a single
//! level, so that a page can save a model that was dropped on it.
//!
//! The file is read again instead of being taken from the model that is shown, because a page shows levels
//! whose vertices are ordered for drawing, and because encoding runs in a worker of its own. Cost: the scene
//! is simplified once for a stream and twice for a GLB file; memory of about five times the file.

use striata::file::StriataFile;
use striata::mesh::IndexedMesh;
use striata::{Lod, LodOptions, ProgressFn, Target};
use striata_io::{Format, Scene, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_scene::file::{SceneFile, is_scene_file};
use striata_scene::stream::{SceneStreamDecoder, SceneStreamOptions, encode_scene_with_progress};
use striata_scene::{GlbStreamOptions, LodScene, read_glb_with_stream};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::progress::{Sink, reporter};
use crate::{Failure, limits};

/// Encodes a file as `stri`, as `glb`, or its `level` with a number of triangles as GLB, and reports the progress of
/// each phase to a sink.
///
/// The file is uncompressed; its name says the format if its contents do not.
///
/// # Errors
/// If the file is damaged or of an unknown format, or the model is too large for a page.
#[wasm_bindgen]
pub fn encode_file(
    bytes: Vec<u8>,
    name: &str,
    format: &str,
    triangles: u32,
    sink: &Sink,
) -> Result<Vec<u8>, Failure> {
    let mut progress = reporter(sink);
    encode(bytes, name, format, triangles, &mut progress)
}

fn encode(
    bytes: Vec<u8>,
    name: &str,
    format: &str,
    triangles: u32,
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<u8>, Failure> {
    limits::check_file(bytes.len())?;
    let scene = scene_of(&bytes, name)?;
    drop(bytes);
    let vertex_count = scene.meshes().iter().flatten().map(IndexedMesh::vertex_count).sum();
    limits::check_to_build(vertex_count, scene.triangle_count())?;
    match format {
        "stri" => {
            let encoded = encode_scene_with_progress(&scene, &SceneStreamOptions::default(), progress);
            Ok(encoded.map_err(Failure::unsupported)?.bytes)
        }
        "glb" => {
            let lods = LodScene::build_with_progress(&scene, &LodOptions::default(), progress);
            let lods = lods.map_err(Failure::corrupt)?;
            lods.to_glb_with_stream(&GlbStreamOptions::default()).map_err(Failure::unsupported)
        }
        "level" => {
            let is_whole = triangles as usize >= scene.triangle_count();
            let level = if is_whole { scene } else { level_of(&scene, triangles, progress)? };
            let options = WriteOptions::default().with_cache_order(!is_whole);
            scene_to_bytes(Format::Glb, &level, &options).map_err(Failure::unsupported)
        }
        other => Err(Failure::unsupported(format!("cannot encode as {other:?}, only as stri or glb"))),
    }
}

fn level_of(scene: &Scene, triangles: u32, progress: &mut ProgressFn<'_>) -> Result<Scene, Failure> {
    let lods = LodScene::build_with_progress(scene, &LodOptions::default(), progress);
    let lods = lods.map_err(Failure::corrupt)?;
    Ok(lods.level_scene(&lods.level(Target::Triangles(triangles as usize))))
}

/// Reads the full scene of a file; a single mesh becomes a scene with one node.
pub(crate) fn scene_of(bytes: &[u8], name: &str) -> Result<Scene, Failure> {
    let source = Source::new(name);
    match Format::detect(bytes, name) {
        Some(Format::Stream) if bytes.starts_with(&striata::file::SCENE_STREAM_MAGIC) => {
            streamed_scene(bytes)
        }
        Some(Format::Stream) => {
            let stream = striata_stream::open_stream(bytes)?;
            if stream.is_truncated() {
                return Err(truncated());
            }
            scene_of_mesh(stream.refinable_mesh()?.mesh)
        }
        Some(Format::Striata) if is_scene_file(bytes) => {
            let file = SceneFile::parse(bytes).map_err(Failure::corrupt)?;
            Ok(file.lod_scene().map_err(Failure::corrupt)?.full_scene())
        }
        Some(Format::Striata) => {
            let lod = Lod::from_file(&StriataFile::parse(bytes)?)?;
            scene_of_mesh(lod.mesh().clone())
        }
        Some(Format::Gltf | Format::Glb) => match read_glb_with_stream(bytes, &source) {
            Ok(Some(lods)) => Ok(lods.full_scene()),
            Ok(None) => Ok(read_scene_bytes(bytes, &source)?),
            Err(error) => Err(Failure::corrupt(error)),
        },
        _ => Ok(read_scene_bytes(bytes, &source)?),
    }
}

fn streamed_scene(bytes: &[u8]) -> Result<Scene, Failure> {
    let mut decoder = SceneStreamDecoder::new();
    decoder.push(bytes).map_err(Failure::corrupt)?;
    if !decoder.is_complete() {
        return Err(truncated());
    }
    decoder.scene().map_err(Failure::corrupt)
}

fn scene_of_mesh(mesh: IndexedMesh) -> Result<Scene, Failure> {
    Scene::from_mesh(mesh).map_err(Failure::corrupt)
}

fn truncated() -> Failure {
    Failure::corrupt("the stream is truncated").with_hint("check that it was copied completely")
}

#[cfg(test)]
mod tests {
    use striata::ignore_progress;
    use striata::mesh::shapes;
    use striata_io::to_bytes;

    use super::*;

    fn encoded(bytes: &[u8], name: &str, format: &str) -> Result<Vec<u8>, Failure> {
        encode(bytes.to_vec(), name, format, 300, &mut ignore_progress)
    }

    fn triangle_count(bytes: &[u8], name: &str) -> usize {
        scene_of(bytes, name).expect("a scene").triangle_count()
    }

    #[test]
    fn every_format_is_encoded_as_every_other() {
        let torus = shapes::torus(32, 16, 1.0, 0.4);
        let count = torus.triangle_count();
        let obj = to_bytes(Format::Obj, &torus, &WriteOptions::default()).expect("OBJ");
        let stream = encoded(&obj, "torus.obj", "stri").expect("a stream");
        let glb = encoded(&obj, "torus.obj", "glb").expect("a GLB file");
        for (bytes, name) in [(&stream, "torus.stri"), (&glb, "torus.glb")] {
            assert_eq!(triangle_count(bytes, name), count, "{name}");
            let level = encoded(bytes, name, "level").expect("a level");
            let kept = triangle_count(&level, "level.glb");
            assert!((250..=300).contains(&kept), "{kept} triangles of {name}");
            for format in ["stri", "glb"] {
                let again = encoded(bytes, name, format).expect(name);
                assert_eq!(triangle_count(&again, &format!("a.{format}")), count, "{name} as {format}");
            }
        }
    }

    #[test]
    fn damaged_files_and_other_formats_are_refused() {
        let torus = shapes::torus(16, 8, 1.0, 0.4);
        let obj = to_bytes(Format::Obj, &torus, &WriteOptions::default()).expect("OBJ");
        assert_eq!(encoded(&obj, "a.obj", "ply").expect_err("not offered").code(), "unsupported");
        assert_eq!(encoded(b"no model", "a.xyz", "stri").expect_err("unknown").code(), "format");
        let stream = encoded(&obj, "a.obj", "stri").expect("a stream");
        let cut = encoded(&stream[..stream.len() / 2], "a.stri", "glb").expect_err("cut off");
        assert_eq!((cut.code().as_str(), cut.hint().is_some()), ("corrupt", true));
        for length in 0..stream.len().min(200) {
            assert!(encoded(&stream[..length], "a.stri", "glb").is_err(), "{length} bytes");
        }
    }
}
