//! The `.striata` container: files round-trip, and damaged bytes are detected.

use striata_testing::support;

use proptest::prelude::*;
use striata::file::{
    DecodeError, EncodeError, FileModel, SectionKind, StriataFile, Verify, WriteOptions, to_striata,
};
use striata::mesh::{
    AttributeLayer, Image, IndexedMesh, LayerData, RefinableMesh, Semantic, canonical_triangles, replay,
};
use striata::model::{
    FanFront, FanScene, Fans, LodModel, LodStrips, ModelError, ModelKind, Mts, StageOptions, StripModel,
};
use striata::strip::{StripSet, stripify};
use support::{
    ArbitraryCriterion, Random, RandomSequenceOptions, grid, hub_cases, nasty, nasty_cases, random_refinable,
    seam_cases, surface_cases, with_seams_and_groups, with_valid_checksums,
};

/// A mesh that uses every feature of the file format.
fn full_featured_mesh() -> RefinableMesh {
    let mut random = Random::new(7);
    let sequence_options = RandomSequenceOptions { far_percent: 3, base_position_count: 5 };
    let mut refinable =
        random_refinable(&with_seams_and_groups(grid(7, false)), sequence_options, &mut random);
    let mesh = &mut refinable.mesh;
    let n = mesh.vertex_count();
    let mut number = |limit| random.below(limit) as u32;
    let layer = |semantic, component_count, normalized, data| AttributeLayer {
        semantic,
        component_count,
        normalized,
        data,
    };
    mesh.layers.extend([
        layer(Semantic::Color(1), 4, true, LayerData::U8((0..4 * n).map(|_| number(256) as u8).collect())),
        layer(Semantic::Joints(0), 4, false, LayerData::U16((0..4 * n).map(|_| number(9) as u16).collect())),
        layer(
            Semantic::Generic("größe".into()),
            1,
            false,
            LayerData::U32((0..n).map(|_| number(99)).collect()),
        ),
        AttributeLayer::from_f32(Semantic::MorphNormal(300), 3, (0..3 * n).map(|i| i as f32).collect()),
    ]);
    mesh.appearance.images.push(Image {
        name: "wood".into(),
        uri: "wood.png".into(),
        mime_type: "image/png".into(),
        bytes: vec![1, 2, 3],
    });
    mesh.appearance.textures_json.push("{\"source\":0}".into());
    mesh.appearance.samplers_json.push("{}".into());
    mesh.appearance.extensions_used.push("KHR_materials_unlit".into());
    mesh.appearance.material_libraries.push("room.mtl".into());
    mesh.appearance.georeference = r#"{"epsg":32633}"#.into();
    refinable
}

/// A model with several stages, unless the mesh is too small for them.
fn model_of(refinable: &RefinableMesh) -> LodStrips<'static> {
    let strips = stripify(&refinable.mesh).unwrap();
    let options = StageOptions::default().with_max_indices_per_triangle(1.2);
    let stages = |level: &_| Ok::<_, ModelError>(stripify(level).unwrap());
    LodStrips::build_staged(refinable, &strips, &options, stages).unwrap()
}

fn mts_of(refinable: &RefinableMesh) -> Mts<'static> {
    let strips = stripify(&refinable.mesh).unwrap();
    Mts::build(refinable, &strips).unwrap()
}

fn bytes_of(refinable: &RefinableMesh) -> Vec<u8> {
    let (model, mts, fans) = (model_of(refinable), mts_of(refinable), Fans::build(refinable));
    let models = [FileModel::LodStrips(&model), FileModel::Mts(&mts), FileModel::Fans(&fans)];
    let options = WriteOptions::default().with_metadata("creator", "test");
    to_striata(refinable, &models, &options).unwrap()
}

/// Compares meshes up to the order of triangles within their groups.
fn assert_same_mesh(found: &IndexedMesh, expected: &IndexedMesh) {
    assert_eq!(found.positions, expected.positions);
    assert_eq!(found.layers, expected.layers);
    assert_eq!(found.appearance, expected.appearance);
    assert_eq!(found.groups, expected.groups);
    for group in expected.groups_or_whole() {
        let [a, b] = [found, expected].map(|m| canonical_triangles(&m.triangles[group.range()]));
        assert_eq!(a, b, "group {}", group.name);
    }
}

/// Reads everything that a file offers. Errors are accepted, panics are not, and whatever can be read must
/// be valid.
fn read_everything(bytes: &[u8]) -> Result<(), DecodeError> {
    let file = StriataFile::parse(bytes)?;
    file.metadata()?;
    let refinable = file.refinable_mesh()?;
    refinable.mesh.check()?;
    let models = (file.lod_strips(), file.mts());
    if let (Some(model), _) = models {
        check_levels(&file, &model?)?;
    }
    if let (_, Some(model)) = models {
        check_levels(&file, &model?)?;
    }
    file.level(file.summary().step_count / 2)?.check()?;
    if let Some(model) = file.fans() {
        let fans = model?;
        for split_count in (0..=fans.step_count()).step_by(5) {
            let mut level = fans.new_state();
            fans.move_to(&mut level, split_count);
            file.level_of(&fans, &level)?.check()?;
        }
        check_random_states(&refinable, &fans);
    }
    Ok(())
}

/// Moves a front through several views: no triangle may have an inactive corner, and the triangle count
/// must be right.
fn check_random_states(refinable: &RefinableMesh, fans: &Fans) {
    let scene = FanScene::new(fans, &refinable.mesh.positions);
    let mut front = FanFront::new(&scene);
    for round in 0..6 {
        front.update(&scene, &ArbitraryCriterion(round * 7919), [usize::MAX, 4][round as usize % 2]);
        let mut indices = Vec::new();
        front.instance().indices_into(fans, &mut indices);
        assert_eq!(front.triangle_count(), indices.len() / 3);
        let positions = refinable.sequence.positions();
        let base = refinable.sequence.base_position_count() as u32;
        for &vertex in &indices {
            let step = positions.position_of(vertex).checked_sub(base);
            assert!(
                step.is_none_or(|step| front.instance().is_refined(step)),
                "vertex {vertex} is not active"
            );
        }
        let level = front.instance().level(fans, refinable);
        assert_eq!(level.check(), Ok(()));
    }
}

fn check_levels<M: StripModel>(file: &StriataFile<'_>, model: &M) -> Result<(), DecodeError> {
    let mut state = model.new_state();
    let full = model.new_state();
    for split_count in (0..=model.step_count()).rev().step_by(5).chain([0]) {
        model.move_to(&mut state, split_count);
        file.level_of(model, &state)?.check()?;
    }
    model.move_to(&mut state, model.step_count());
    for strip in 0..model.strip_count() {
        assert_eq!(model.strip(&state, strip), model.strip(&full, strip));
    }
    Ok(())
}

#[test]
fn all_parts_round_trip() {
    let refinable = full_featured_mesh();
    let bytes = bytes_of(&refinable);
    let file = StriataFile::parse_with(&bytes, Verify::All).unwrap();
    let found = file.refinable_mesh().unwrap();
    assert_same_mesh(&found.mesh, &refinable.mesh);
    assert_eq!(found.sequence, refinable.sequence);
    let model = file.lod_strips().unwrap().unwrap();
    assert!(model.stage_split_counts().count() > 2);
    assert_eq!(model, model_of(&refinable));
    assert_eq!(file.mts().unwrap().unwrap(), mts_of(&refinable));
    assert_eq!(file.fans().unwrap().unwrap(), Fans::build(&refinable));
    assert_eq!(file.metadata().unwrap(), [("creator".to_owned(), "test".to_owned())]);
    let summary = file.summary();
    assert_eq!(summary.triangle_count, refinable.mesh.triangle_count());
    assert_eq!(summary.step_count, refinable.sequence.step_count());
    assert_eq!(summary.bounds, refinable.mesh.bounds());
    assert_eq!(summary.error_max, refinable.sequence.error_at(0));
    let sum: u64 = file.sections().iter().map(|s| s.bytes).sum();
    assert!(sum < bytes.len() as u64);
}

#[test]
fn every_level_of_a_file_is_the_oracle() {
    let refinable = full_featured_mesh();
    let bytes = bytes_of(&refinable);
    let file = StriataFile::parse(&bytes).unwrap();
    for split_count in 0..=refinable.sequence.step_count() {
        assert_same_mesh(&file.level(split_count).unwrap(), &replay(&refinable, split_count));
    }
    let step_count = refinable.sequence.step_count();
    let error = file.level(step_count + 1).unwrap_err();
    assert_eq!(error, DecodeError::SplitCount { split_count: step_count + 1, step_count });
}

#[test]
fn fans_of_every_kind_of_mesh_round_trip() {
    for case in nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases()) {
        let refinable = &case.refinable;
        let fans = Fans::build(refinable);
        let models = [FileModel::Fans(&fans)];
        let bytes = to_striata(refinable, &models, &WriteOptions::default()).unwrap();
        let file = StriataFile::parse(&bytes).unwrap();
        let found = file.fans().unwrap().unwrap();
        assert_eq!(found, fans);
        check_random_states(refinable, &found);
    }
}

#[test]
fn a_file_can_store_its_triangles_as_fans() {
    let refinable = full_featured_mesh();
    let fans = Fans::build(&refinable);
    let bytes = to_striata(&refinable, &[FileModel::Fans(&fans)], &WriteOptions::default()).unwrap();
    let file = StriataFile::parse(&bytes).unwrap();
    assert!(file.sections().iter().all(|section| section.kind != SectionKind::TRIANGLES));
    assert!(file.strips().is_none() && file.lod_strips().is_none() && file.mts().is_none());
    assert_same_mesh(&file.refinable_mesh().unwrap().mesh, &refinable.mesh);
    for split_count in 0..=refinable.sequence.step_count() {
        let expected = replay(&refinable, split_count);
        assert_same_mesh(&file.level(split_count).unwrap(), &expected);
    }
}

/// For compatibility with older readers and files, nothing else in a file may depend on its fans.
#[test]
fn a_file_is_the_same_without_its_fans() {
    let refinable = full_featured_mesh();
    let (model, fans) = (model_of(&refinable), Fans::build(&refinable));
    let old = [FileModel::LodStrips(&model)];
    let old = to_striata(&refinable, &old, &WriteOptions::default()).unwrap();
    assert!(StriataFile::parse(&old).unwrap().fans().is_none());
    for models in [
        [FileModel::LodStrips(&model), FileModel::Fans(&fans)],
        [FileModel::Fans(&fans), FileModel::LodStrips(&model)],
    ] {
        let new = to_striata(&refinable, &models, &WriteOptions::default()).unwrap();
        let files = [&old, &new].map(|bytes| StriataFile::parse(bytes).unwrap());
        assert_eq!(files[0].refinable_mesh(), files[1].refinable_mesh());
        assert_eq!(files[0].lod_strips().unwrap(), files[1].lod_strips().unwrap());
        assert!(files[1].sections().iter().all(|s| !s.is_required || !s.kind.0.starts_with(b"FN")));
    }
}

#[test]
fn files_without_strips_keep_the_triangles_in_order() {
    let refinable = full_featured_mesh();
    let bytes = to_striata(&refinable, &[], &WriteOptions::default()).unwrap();
    let file = StriataFile::parse(&bytes).unwrap();
    assert_eq!(file.refinable_mesh().unwrap(), refinable);
    assert!(file.lod_strips().is_none());
    assert_same_mesh(&file.level(0).unwrap(), &replay(&refinable, 0));
}

#[test]
fn nasty_meshes_round_trip() {
    for (name, mesh) in nasty() {
        let sequence_options = RandomSequenceOptions { far_percent: 10, base_position_count: 1 };
        let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(3));
        let bytes = bytes_of(&refinable);
        read_everything(&bytes).unwrap_or_else(|e| panic!("{name}: {e}"));
        let found = StriataFile::parse(&bytes).unwrap().refinable_mesh().unwrap();
        assert_same_mesh(&found.mesh, &refinable.mesh);
    }
}

#[test]
fn unaligned_bytes_are_read_too() {
    let refinable = full_featured_mesh();
    let mut bytes = vec![0];
    bytes.extend(bytes_of(&refinable));
    let file = StriataFile::parse(&bytes[1..]).unwrap();
    assert_same_mesh(&file.refinable_mesh().unwrap().mesh, &refinable.mesh);
    assert_same_mesh(&file.level(9).unwrap(), &replay(&refinable, 9));
}

#[test]
fn every_truncation_is_rejected() {
    let bytes = bytes_of(&full_featured_mesh());
    for length in 0..bytes.len() {
        assert!(StriataFile::parse(&bytes[..length]).is_err(), "{length} bytes");
    }
    let longer = [&bytes[..], &[0]].concat();
    assert!(matches!(StriataFile::parse(&longer), Err(DecodeError::FileLength { .. })));
}

#[test]
fn every_flipped_bit_of_header_and_table_is_rejected() {
    let bytes = bytes_of(&full_featured_mesh());
    let file = StriataFile::parse(&bytes).unwrap();
    let head_bytes = 64 + 32 * file.sections().len();
    for bit in 0..8 * head_bytes {
        let mut flipped = bytes.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        assert!(StriataFile::parse(&flipped).is_err(), "bit {bit}");
    }
}

#[test]
fn every_flipped_bit_of_a_section_is_detected() {
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let refinable = random_refinable(&grid(3, false), sequence_options, &mut Random::new(5));
    let bytes = bytes_of(&refinable);
    let sections = StriataFile::parse(&bytes).unwrap().sections().to_vec();
    for section in sections {
        for bit in 8 * section.offset as usize..8 * (section.offset + section.bytes) as usize {
            let mut flipped = bytes.clone();
            flipped[bit / 8] ^= 1 << (bit % 8);
            let error = StriataFile::parse_with(&flipped, Verify::All).unwrap_err();
            assert!(matches!(error, DecodeError::Checksum { kind, .. } if kind == section.kind));
            assert!(read_everything(&flipped).is_err(), "{}, bit {bit}", section.kind);
        }
    }
}

/// Rewrites the kind and flags of one section of a valid file.
fn with_kind(bytes: &[u8], from: SectionKind, to: SectionKind, flags: u32) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let entry = StriataFile::parse(&bytes).unwrap().sections().iter().position(|s| s.kind == from).unwrap();
    let at = 64 + 32 * entry;
    bytes[at..at + 4].copy_from_slice(&to.0);
    bytes[at + 4..at + 8].copy_from_slice(&flags.to_le_bytes());
    with_valid_checksums(&mut bytes);
    bytes
}

#[test]
fn unknown_sections_are_skipped_unless_required() {
    let refinable = full_featured_mesh();
    let bytes = bytes_of(&refinable);
    let new = SectionKind(*b"FUT1");
    let file_bytes = with_kind(&bytes, SectionKind::METADATA, new, 0);
    let file = StriataFile::parse(&file_bytes).unwrap();
    assert_same_mesh(&file.refinable_mesh().unwrap().mesh, &refinable.mesh);
    assert!(file.metadata().unwrap().is_empty());
    let file_bytes = with_kind(&bytes, SectionKind::METADATA, new, 1);
    assert_eq!(StriataFile::parse(&file_bytes).unwrap_err(), DecodeError::UnknownSection { kind: new });
    let twice = with_kind(&bytes, SectionKind::METADATA, SectionKind::SUMMARY, 1);
    let expected = DecodeError::SectionCount { kind: SectionKind::SUMMARY, found: 2 };
    assert_eq!(StriataFile::parse(&twice).unwrap_err(), expected);
}

#[test]
fn models_of_other_meshes_are_not_written() {
    let refinable = full_featured_mesh();
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let other = model_of(&random_refinable(&grid(3, false), sequence_options, &mut Random::new(5)));
    let error = to_striata(&refinable, &[FileModel::LodStrips(&other)], &WriteOptions::default());
    assert!(matches!(error, Err(EncodeError::Model { what: "vertices", .. })));
    let model = model_of(&refinable);
    let models = [FileModel::LodStrips(&model); 2];
    let error = to_striata(&refinable, &models, &WriteOptions::default());
    assert!(matches!(error, Err(EncodeError::RepeatedModel { .. })));
    let triangles = refinable.mesh.triangles.iter().map(|t| t.to_vec()).collect::<Vec<_>>();
    let mut single = StripSet::new();
    for group in refinable.mesh.groups_or_whole() {
        triangles[group.range()].iter().for_each(|t| single.push(t));
        single.end_group();
    }
    let fans = Fans::build(&random_refinable(&grid(3, false), sequence_options, &mut Random::new(5)));
    let error = to_striata(&refinable, &[FileModel::Fans(&fans)], &WriteOptions::default());
    assert!(matches!(error, Err(EncodeError::Model { model: ModelKind::Fans, what: "vertices", .. })));
    let fans = Fans::build_without_bounds(&refinable);
    let error = to_striata(&refinable, &[FileModel::Fans(&fans)], &WriteOptions::default());
    assert!(matches!(error, Err(EncodeError::Model { model: ModelKind::Fans, what: "bounds", .. })));
    let mts = Mts::build(&refinable, &single).unwrap();
    let models = [FileModel::LodStrips(&model), FileModel::Mts(&mts)];
    let error = to_striata(&refinable, &models, &WriteOptions::default());
    assert!(matches!(error, Err(EncodeError::OtherStrips { model: ModelKind::Mts })));
}

#[test]
fn damaged_stages_are_rejected() {
    let refinable = full_featured_mesh();
    let model = model_of(&refinable);
    let bytes = to_striata(&refinable, &[FileModel::LodStrips(&model)], &WriteOptions::default()).unwrap();
    let section = |kind| {
        let file = StriataFile::parse(&bytes).unwrap();
        let found = file.sections().iter().find(|s| s.kind == kind).copied().unwrap();
        found.offset as usize..(found.offset + found.bytes) as usize
    };
    let damaged = |at: usize, word: u32| {
        let mut bytes = bytes.clone();
        bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
        with_valid_checksums(&mut bytes);
        let file = StriataFile::parse(&bytes).unwrap();
        file.lod_strips().unwrap().unwrap_err().to_string()
    };
    // Each row of the table has the split count and the number of strips of each of three groups.
    let table = section(SectionKind::STAGES);
    let step_count = refinable.sequence.step_count() as u32;
    assert!(damaged(table.start, step_count).contains("does not begin below"));
    assert!(damaged(table.start + 4, 0).contains("stage 1"));
    assert!(damaged(table.start + 4, u32::MAX).contains("stage 1"));
    let walks = section(SectionKind::STAGE_WALKS);
    let message = damaged(walks.start, u32::MAX);
    assert!(message.contains("stage 1"), "{message}");
}

#[test]
fn strips_are_stored_once_for_all_models() {
    let refinable = full_featured_mesh();
    let (model, mts) = (model_of(&refinable), mts_of(&refinable));
    let of = |models: &[FileModel<'_>]| to_striata(&refinable, models, &WriteOptions::default()).unwrap();
    let alone = of(&[FileModel::Mts(&mts)]);
    let file = StriataFile::parse(&alone).unwrap();
    assert!(file.lod_strips().is_none());
    assert_eq!(file.mts().unwrap().unwrap(), mts);
    let level = file.level(file.summary().step_count / 3).unwrap();
    assert_same_mesh(&level, &replay(&refinable, refinable.sequence.step_count() / 3));
    let both = of(&[FileModel::LodStrips(&model), FileModel::Mts(&mts)]);
    let file = StriataFile::parse(&both).unwrap();
    let count = |kind| file.sections().iter().filter(|s| s.kind == kind).count();
    assert_eq!(
        [count(SectionKind::STRIP_INDICES), count(SectionKind::LIFETIMES), count(SectionKind::RECORDS)],
        [1; 3]
    );
    assert_eq!(file.strips().unwrap().unwrap().indices().len(), mts.slot_count());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(1500) })]

    #[test]
    fn damage_with_valid_checksums_is_an_error_or_a_valid_mesh(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
        seed in 0u64..6,
    ) {
        let mesh = if seed % 2 == 0 { with_seams_and_groups(grid(3, true)) } else { grid(4, false) };
        let sequence_options = RandomSequenceOptions { far_percent: 10, base_position_count: 4 };
        let mut bytes = bytes_of(&random_refinable(&mesh, sequence_options, &mut Random::new(seed)));
        for (index, byte) in changes {
            // Magic, version, length and count are kept, because damage to these ends the reading early.
            let at = 28 + index.index(bytes.len() - 28);
            bytes[at] ^= byte;
        }
        with_valid_checksums(&mut bytes);
        let _ = read_everything(&bytes);
    }

    #[test]
    fn damaged_fans_are_an_error_or_fans_without_cracks(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..3),
        seed in 0u64..6,
    ) {
        let mesh = if seed % 2 == 0 { with_seams_and_groups(grid(3, true)) } else { grid(5, false) };
        let sequence_options = RandomSequenceOptions { far_percent: 10, base_position_count: 4 };
        let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(seed));
        let fans = Fans::build(&refinable);
        let models = [FileModel::Fans(&fans)];
        let mut bytes = to_striata(&refinable, &models, &WriteOptions::default()).unwrap();
        let is_of_fans = |kind: SectionKind| kind.0.starts_with(b"FN") || kind == SectionKind::REMOVED;
        let sections = StriataFile::parse(&bytes).unwrap().sections().to_vec();
        let spans = sections.iter().filter(|s| is_of_fans(s.kind)).map(|s| s.offset..s.offset + s.bytes);
        let candidates: Vec<u64> = spans.flatten().collect();
        for (index, byte) in changes {
            bytes[candidates[index.index(candidates.len())] as usize] ^= byte;
        }
        with_valid_checksums(&mut bytes);
        if let Some(Ok(fans)) = StriataFile::parse(&bytes).unwrap().fans() {
            check_random_states(&refinable, &fans);
        }
    }

    #[test]
    fn any_bytes_after_the_magic_are_rejected_or_read(tail in prop::collection::vec(any::<u8>(), 0..400)) {
        let mut bytes = b"STRIATA\0\x02\0\0\0".to_vec();
        bytes.extend(tail);
        let _ = read_everything(&bytes);
        if bytes.len() >= 64 {
            let length = bytes.len() as u64;
            bytes[16..24].copy_from_slice(&length.to_le_bytes());
            let count = ((length - 64) / 32) as u32;
            bytes[12..16].copy_from_slice(&count.to_le_bytes());
            with_valid_checksums(&mut bytes);
            let _ = read_everything(&bytes);
        }
    }
}
