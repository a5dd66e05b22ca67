//! `.striata` files of scenes: round trips, damage, and files of single meshes.

use std::borrow::Cow;
use std::fs;

use striata::file::{
    Container, DecodeError, FileHead, FileModel, Section, SectionKind, StriataFile, Verify, WriteOptions,
    metadata_to_bytes, to_striata, write_sections,
};
use striata::mesh::shapes;
use striata::simplify::{BatchOptions, build_batches};
use striata::{Lod, LodOptions, Target};
use striata_io::{Scene, Source, read_scene_bytes};
use striata_scene::file::{SceneDecodeError, SceneEncodeError, SceneFile, is_scene_file, write_scene_file};
use striata_scene::{LodScene, open, save};
use striata_stream::{StreamOptions, encode_stream, file_model};
use striata_testing::scenes::{self, TestScene};

fn build(scene: &TestScene) -> LodScene {
    let scene = read_scene_bytes(&scene.to_glb(), &Source::new("test.glb")).unwrap();
    LodScene::build(&scene, &LodOptions::default()).unwrap()
}

#[test]
fn every_scene_comes_back_from_its_file() {
    for sample in scenes::all() {
        let lods = build(&sample);
        let options = WriteOptions::default().with_metadata("source", sample.name);
        let bytes = lods.to_striata(&options).unwrap();
        assert!(is_scene_file(&bytes));
        let file = SceneFile::parse(&bytes).unwrap();
        assert_eq!(file.metadata(), [("source".to_owned(), sample.name.to_owned())]);
        let again = file.lod_scene().unwrap();
        assert_eq!(again.scene(), lods.scene(), "{}", sample.name);
        for target in [Target::Detail(1.0), Target::Detail(0.3), Target::Triangles(0)] {
            let (level, expected) = (again.level(target), lods.level(target));
            assert_eq!(level, expected, "{}", sample.name);
            assert_eq!(
                again.level_scene(&level).triangle_count(),
                lods.level_scene(&expected).triangle_count()
            );
        }
        assert_eq!(again.to_striata(&options).unwrap(), bytes, "{}", sample.name);
    }
}

#[test]
fn arrays_of_meshes_are_used_in_place() {
    let bytes = build(&scenes::hierarchy()).to_striata(&WriteOptions::default()).unwrap();
    let container = Container::open(&bytes, Verify::All).unwrap();
    let meshes: Vec<_> = container.sections().iter().filter(|s| s.kind == SectionKind::SCENE_MESH).collect();
    assert_eq!(meshes.len(), 3);
    assert!(meshes.iter().all(|section| section.offset % 64 == 0));
}

/// Meshes that differ in their material only are stored once.
#[test]
fn equal_meshes_are_stored_once() {
    let lods = build(&scenes::shared_accessors());
    let bytes = lods.to_striata(&WriteOptions::default()).unwrap();
    let container = Container::open(&bytes, Verify::All).unwrap();
    let of = |kind: SectionKind| container.sections().iter().filter(move |section| section.kind == kind);
    let sizes: Vec<u64> = of(SectionKind::SCENE_MESH).map(|section| section.bytes).collect();
    assert!(sizes[0] > 0 && sizes[1..3] == [0, 0] && sizes[3] > 0, "{sizes:?}");
    assert!(of(SectionKind::SCENE_SHARING).all(|section| section.is_required), "older readers refuse it");
    assert_eq!(of(SectionKind::SCENE_SHARING).count(), 1);
    let file = SceneFile::parse(&bytes).unwrap();
    let again = file.lod_scene().unwrap();
    assert_eq!(again.scene(), lods.scene());
    assert_eq!(again.triangle_count(), lods.triangle_count());
    assert_eq!(again.lods()[1].as_ref().unwrap().mesh(), again.lods()[0].as_ref().unwrap().mesh());
    assert!(file.meshes().iter().all(Option::is_some));
    for sharing in
        [vec![0u32, 0, 0], vec![0, 0, 0, 0], vec![0, 3, 0, 3], vec![0, 9, 0, 3], vec![0, 0, 1, 3, 4]]
    {
        let damaged = with_section(&bytes, |_, kind, bytes| {
            if kind == SectionKind::SCENE_SHARING {
                *bytes = sharing.iter().flat_map(|source| source.to_le_bytes()).collect();
            }
        });
        let message = SceneFile::parse(&damaged).unwrap_err().to_string();
        assert!(message.starts_with("section SCSH"), "{sharing:?}: {message}");
    }
}

#[test]
fn readers_of_single_meshes_name_the_reason() {
    let bytes = build(&scenes::morphed()).to_striata(&WriteOptions::default()).unwrap();
    assert_eq!(StriataFile::parse(&bytes).unwrap_err(), DecodeError::Scene);
    assert_eq!(FileHead::read(&bytes).unwrap_err(), DecodeError::Scene);
    let lod = Lod::build(&shapes::icosphere(2, 1.0), &LodOptions::default()).unwrap();
    let single = lod.to_striata(&WriteOptions::default()).unwrap();
    assert!(!is_scene_file(&single) && !is_scene_file(b"text"));
    assert!(matches!(SceneFile::parse(&single), Err(SceneDecodeError::Container(_))));
}

#[test]
fn every_changed_byte_and_every_truncation_is_an_error() {
    let bytes = build(&scenes::without_nodes()).to_striata(&WriteOptions::default()).unwrap();
    let table = Container::open(&bytes, Verify::All).unwrap();
    let mut is_covered = vec![false; bytes.len()];
    is_covered[..64 + 32 * table.sections().len()].fill(true);
    for section in table.sections() {
        is_covered[section.offset as usize..][..section.bytes as usize].fill(true);
    }
    let mut damaged = bytes.clone();
    for place in 0..bytes.len() {
        damaged[place] ^= 1 << (place % 8);
        // Only the padding between sections has no checksum.
        assert_eq!(SceneFile::parse(&damaged).is_err(), is_covered[place], "byte {place}");
        damaged[place] = bytes[place];
    }
    for length in (0..bytes.len()).step_by(7) {
        assert!(SceneFile::parse(&bytes[..length]).is_err(), "{length} bytes");
        is_scene_file(&bytes[..length]);
    }
}

/// Rewrites the checksums, so that damage reaches the code behind them.
fn with_section(bytes: &[u8], change: impl Fn(usize, SectionKind, &mut Vec<u8>)) -> Vec<u8> {
    let container = Container::open(bytes, Verify::WhenRead).unwrap();
    let section = |(index, info): (usize, &striata::file::SectionInfo)| {
        let mut bytes = bytes[info.offset as usize..][..info.bytes as usize].to_vec();
        change(index, info.kind, &mut bytes);
        Section { kind: info.kind, is_required: info.is_required, bytes: bytes.into() }
    };
    let sections: Vec<Section<'_>> = container.sections().iter().enumerate().map(section).collect();
    let mut out = Vec::new();
    write_sections(&sections, &mut out).unwrap();
    out
}

#[test]
fn damage_with_valid_checksums_never_panics() {
    let bytes = build(&scenes::shared_accessors()).to_striata(&WriteOptions::default()).unwrap();
    let container = Container::open(&bytes, Verify::All).unwrap();
    for (index, section) in container.sections().iter().enumerate() {
        // The files of meshes have tests of their own; here their headers and tables are damaged.
        for place in 0..(section.bytes as usize).min(900) {
            let damaged = with_section(&bytes, |at, _, bytes| {
                if at == index {
                    bytes[place] ^= 1 << (place % 8);
                }
            });
            if let Ok(file) = SceneFile::parse(&damaged) {
                let _ = file.lod_scene();
            }
        }
    }
}

#[test]
fn parts_that_do_not_match_are_refused() {
    let bytes = build(&scenes::hierarchy()).to_striata(&WriteOptions::default()).unwrap();
    let error = |change: &dyn Fn(usize, SectionKind, &mut Vec<u8>)| {
        SceneFile::parse(&with_section(&bytes, change)).unwrap_err().to_string()
    };
    let no_json = error(&|_, kind, bytes| {
        if kind == SectionKind::SCENE {
            bytes.clear();
        }
    });
    assert!(no_json.starts_with("section SCND: "), "{no_json}");
    let cut_image = error(&|_, kind, bytes| {
        if kind == SectionKind::SCENE_IMAGE {
            bytes.truncate(6);
        }
    });
    assert_eq!(cut_image, "section SCIM 0, byte 0: ends within a text");
    let no_images = error(&|_, kind, bytes| {
        if kind == SectionKind::SCENE {
            let text = String::from_utf8(bytes.clone()).unwrap();
            *bytes = text.replace("\"images\"", "\"jmages\"").into_bytes();
        }
    });
    assert_eq!(no_images, "images: 1 images for 0 entries");
    let text = error(&|_, kind, bytes| {
        if kind == SectionKind::SCENE_MESH {
            *bytes = b"no model".to_vec();
        }
    });
    assert!(text.starts_with("meshes[0]: not a .striata file"), "{text}");
    let nested = error(&|_, kind, bytes_of_mesh| {
        if kind == SectionKind::SCENE_MESH {
            *bytes_of_mesh = bytes.clone();
        }
    });
    assert!(nested.starts_with("meshes[0]: the file contains a scene"), "{nested}");
    let other = build(&scenes::morphed()).lods()[0].clone().unwrap();
    let other = other.to_striata(&WriteOptions::default()).unwrap();
    let groups = error(&|_, kind, bytes| {
        if kind == SectionKind::SCENE_MESH {
            bytes.clone_from(&other);
        }
    });
    assert_eq!(groups, "meshes[0]: 1 groups for 2 triangle primitives");
}

#[test]
fn meshes_can_be_files_of_any_model() {
    let mesh = shapes::torus(20, 12, 1.0, 0.4);
    let scene = Scene::from_mesh(mesh).unwrap();
    let mesh = scene.meshes()[0].as_ref().unwrap();
    let built = build_batches(mesh, &BatchOptions::default()).unwrap();
    let stream = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default()).unwrap();
    let refinable = stream.reorder(&built.built.refinable);
    let models: [Vec<FileModel<'_>>; 2] = [vec![file_model(&stream.bytes).unwrap()], vec![]];
    for models in models {
        let file = to_striata(&refinable, &models, &WriteOptions::default()).unwrap();
        let mut out = Vec::new();
        let files = [Some(Cow::Borrowed(&file[..]))];
        write_scene_file(&scene.without_meshes(), &files, &WriteOptions::default(), &mut out).unwrap();
        let read = SceneFile::parse(&out).unwrap();
        assert_eq!(read.meshes()[0].as_ref().unwrap().summary().step_count, refinable.sequence.step_count());
        assert_eq!(read.lod_scene().unwrap().triangle_count(), mesh.triangle_count());
    }
}

#[test]
fn wrong_mesh_files_are_not_written() {
    let lods = build(&scenes::hierarchy());
    let write = |meshes: &[Option<Cow<'_, [u8]>>]| {
        write_scene_file(lods.scene(), meshes, &WriteOptions::default(), &mut Vec::new())
    };
    assert!(matches!(write(&[]), Err(SceneEncodeError::Mismatch(_))));
    let text = Some(Cow::Borrowed(&b"text"[..]));
    assert!(matches!(write(&[None, text, None]), Err(SceneEncodeError::MeshFile { mesh: 1, .. })));
    assert!(write(&[None, None, None]).is_ok());
}

#[test]
fn scenes_and_single_meshes_open_from_paths() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.striata");
    let lods = build(&scenes::skinned());
    save(&path, &lods).unwrap();
    assert_eq!(open(&path).unwrap().scene(), lods.scene());

    let single = folder.path().join("sphere.striata");
    let mut sphere = shapes::two_material_sphere(9, 12);
    sphere.groups[1].material = Some(0);
    let lod = Lod::build(&sphere, &LodOptions::default()).unwrap();
    striata_io::save(&single, &lod).unwrap();
    let scene = open(&single).unwrap();
    assert_eq!(scene.scene().primitive_materials(0), [Some(0), Some(0)]);
    assert_eq!(scene.full_scene().triangle_count(), sphere.triangle_count());
    let bare = Lod::build(&shapes::icosphere(1, 1.0), &LodOptions::default()).unwrap();
    let bare = LodScene::from_lod(bare).unwrap();
    assert_eq!(bare.full_scene().triangle_count(), 80);
    assert!(
        striata_io::scene_to_bytes(striata_io::Format::Glb, &bare.full_scene(), &Default::default()).is_ok()
    );

    fs::write(&path, "text").unwrap();
    let error = open(&path).unwrap_err().to_string();
    assert!(error.contains("scene.striata") && error.contains("not a .striata file"), "{error}");
    assert!(open(folder.path().join("none")).is_err());
}

#[test]
fn metadata_of_any_container_is_read() {
    let texts = vec![("key".to_owned(), "value".to_owned())];
    let bytes = metadata_to_bytes(&texts).unwrap();
    let section = Section { kind: SectionKind::METADATA, is_required: false, bytes: bytes.into() };
    let mut out = Vec::new();
    write_sections(&[section], &mut out).unwrap();
    assert_eq!(Container::open(&out, Verify::All).unwrap().metadata().unwrap(), texts);
    let many: Vec<_> = (0..65_537)
        .map(|_| Section { kind: SectionKind::LAYER, is_required: false, bytes: Cow::Borrowed(&[]) })
        .collect();
    let error = write_sections(&many, &mut Vec::new()).unwrap_err().to_string();
    assert_eq!(error, "the file would have 65537 sections, but at most 65536 can be stored");
}
