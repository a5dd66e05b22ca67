//! Patterns in `.striata` files: they round-trip, and damaged bytes are detected.

use striata_testing::support;

use proptest::prelude::*;
use striata::file::{
    DecodeError, FileModel, SectionKind, StriataFile, WriteOptions, to_striata, write_fragments,
};
use striata::mesh::{
    Face, Fragment, FragmentSequence, FragmentedMesh, IndexedMesh, PositionIndex, RefinableMesh,
    canonical_triangles, replay, replay_fragments,
};
use striata::model::{LodModel, Overlap, PatternInstance, Patterns};
use support::{
    Random, RandomSequenceOptions, assert_shows_set, grid, hub_cases, nasty_cases, random_refinable,
    seam_cases, surface_cases, with_seams_and_groups, with_valid_checksums,
};

struct WithPatterns {
    fragmented: FragmentedMesh,
    patterns: Patterns,
}

fn patterns_of(refinable: &RefinableMesh) -> WithPatterns {
    let fragmented = FragmentedMesh::from_collapses(refinable);
    let patterns = Patterns::build(&fragmented).unwrap();
    WithPatterns { fragmented, patterns }
}

/// Returns a file with patterns and collapses, and one with patterns only.
fn both_files(refinable: &RefinableMesh) -> [Vec<u8>; 2] {
    let WithPatterns { fragmented, patterns } = patterns_of(refinable);
    let models = [FileModel::Patterns(&patterns)];
    let with_collapses = to_striata(refinable, &models, &WriteOptions::default()).unwrap();
    let mut alone = Vec::new();
    write_fragments(&fragmented, &[FileModel::Patterns(&patterns)], &WriteOptions::default(), &mut alone)
        .unwrap();
    [with_collapses, alone]
}

#[test]
fn patterns_of_every_kind_of_mesh_round_trip() {
    for case in nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases().take(1)) {
        let refinable = &case.refinable;
        let WithPatterns { patterns, .. } = patterns_of(refinable);
        for (bytes, has_collapses) in both_files(refinable).iter().zip([true, false]) {
            let file = StriataFile::parse(bytes).unwrap();
            assert_eq!(file.has_collapses(), has_collapses);
            let found = file.patterns().unwrap().unwrap();
            assert_eq!(found, patterns);
            assert_eq!(&file.levels().unwrap(), refinable.sequence.levels());
            for split_count in (0..=refinable.sequence.step_count())
                .step_by(case.stride.max(1 + refinable.sequence.step_count() / 12))
            {
                let (level, expected) = (file.level(split_count).unwrap(), replay(refinable, split_count));
                assert_eq!(level.positions, expected.positions);
                for (group, expected_group) in level.groups_or_whole().iter().zip(expected.groups_or_whole())
                {
                    assert_eq!(
                        canonical_triangles(&level.triangles[group.range()]),
                        canonical_triangles(&expected.triangles[expected_group.range()])
                    );
                }
            }
        }
    }
}

#[test]
fn a_file_without_collapses_says_so_and_has_its_fragments() {
    let refinable = random_refinable(
        &with_seams_and_groups(grid(7, false)),
        RandomSequenceOptions { far_percent: 3, base_position_count: 5 },
        &mut Random::new(7),
    );
    let [with_collapses, alone] = both_files(&refinable);
    assert!(alone.len() < with_collapses.len(), "no targets are stored");
    let file = StriataFile::parse(&alone).unwrap();
    assert_eq!(file.refinable_mesh().unwrap_err(), DecodeError::NoCollapses);
    assert_eq!(file.sequence().unwrap_err(), DecodeError::NoCollapses);
    assert_eq!(file.mesh().unwrap().groups, refinable.mesh.groups);
    for bytes in [&with_collapses, &alone] {
        let found = StriataFile::parse(bytes).unwrap().fragmented_mesh().unwrap();
        for split_count in 0..=refinable.sequence.step_count() {
            let (found, expected) = (replay_fragments(&found, split_count), replay(&refinable, split_count));
            assert_eq!(canonical_triangles(&found.triangles), canonical_triangles(&expected.triangles));
        }
    }
}

/// Visits random sets of fragments: no triangle may have an inactive corner.
fn check_random_states(patterns: &Patterns) {
    let mut instance = PatternInstance::base(patterns);
    for round in 0..8u32 {
        let condition = |overlap: Overlap| {
            overlap.upper.wrapping_mul(2_654_435_761).wrapping_add(round * 7919) >> 8 & 7 < round % 5
        };
        instance.adapt(patterns, &condition);
        let step = round * 31 % patterns.fragment_count().max(1) as u32;
        if patterns.fragment_count() > 0 {
            instance.remove(patterns, step);
            instance.insert(patterns, step);
        }
        let mut triangles = Vec::new();
        instance.triangles_into(&mut triangles);
        assert_eq!(triangles.len(), instance.triangle_count());
    }
    let mut state = patterns.new_state();
    for split_count in (0..=patterns.step_count()).rev().step_by(3) {
        patterns.move_to(&mut state, split_count);
    }
}

fn read_everything(bytes: &[u8]) -> Result<(), DecodeError> {
    let file = StriataFile::parse(bytes)?;
    file.levels()?;
    let patterns = file.patterns();
    file.fragmented_mesh()?.mesh.check()?;
    file.level(file.summary().step_count / 2)?.check()?;
    if let Some(patterns) = patterns {
        check_random_states(&patterns?);
    }
    Ok(())
}

#[test]
fn valid_files_are_read() {
    for seed in 0..4 {
        let mesh = if seed % 2 == 0 { with_seams_and_groups(grid(4, true)) } else { grid(5, false) };
        let sequence_options = RandomSequenceOptions { far_percent: 10, base_position_count: 4 };
        for mut bytes in both_files(&random_refinable(&mesh, sequence_options, &mut Random::new(seed))) {
            let before = bytes.clone();
            with_valid_checksums(&mut bytes);
            assert!(bytes == before, "checksums are computed as the writer does");
            read_everything(&bytes).unwrap();
        }
    }
}

/// Checks that patterns show their own fragments in any set, and reach the same sets as a fresh build.
fn check_against_own_fragments(patterns: &Patterns, group_count: usize) {
    let fragments = patterns.unpack(vec![0.0; patterns.fragment_count()]).unwrap();
    let built = Patterns::from_fragments(&fragments, group_count).unwrap();
    let (mut instance, mut other) = (PatternInstance::base(patterns), PatternInstance::base(&built));
    for round in 0..6u32 {
        let name = |overlap: Overlap| overlap.upper << 8 ^ overlap.lower.unwrap_or(77) ^ round << 20;
        let condition = |overlap: Overlap| {
            name(overlap).wrapping_mul(2_654_435_761) >> 16 & 7 < [1, 3, 0, 5][round as usize % 4]
        };
        instance.adapt(patterns, &condition);
        other.adapt(&built, &condition);
        let steps = 0..patterns.fragment_count() as u32;
        assert!(steps.into_iter().all(|step| instance.is_refined(step) == other.is_refined(step)));
        let mut shown = Vec::new();
        instance.triangles_into(&mut shown);
        assert_shows_set(&fragments, &shown, |step| instance.is_refined(step));
    }
    let mut state = patterns.new_state();
    for split_count in (0..=patterns.step_count()).rev().step_by(5) {
        patterns.move_to(&mut state, split_count);
        let mut shown = Vec::new();
        patterns.triangles_into(&state, &mut shown);
        assert_shows_set(&fragments, &shown, |step| (step as usize) < split_count);
    }
}

/// Damages one number at a time: whatever can still be read must be consistent in every set of fragments.
#[test]
fn damaged_numbers_never_yield_inconsistent_patterns() {
    let sequence_options = RandomSequenceOptions { far_percent: 10, base_position_count: 4 };
    let (mut read, mut refused) = (0, 0);
    for mesh in [with_seams_and_groups(grid(3, true)), grid(5, false)] {
        let [_, bytes] = both_files(&random_refinable(&mesh, sequence_options, &mut Random::new(5)));
        let sections = StriataFile::parse(&bytes).unwrap().sections().to_vec();
        let pattern_sections =
            sections.iter().filter(|s| s.kind.0.starts_with(b"PA") && s.kind.0 != *b"PABD");
        for offset in pattern_sections.flat_map(|s| s.offset..s.offset + s.bytes) {
            for change in [1, 2, 0x10, 0x80] {
                let mut damaged = bytes.clone();
                damaged[offset as usize] ^= change;
                with_valid_checksums(&mut damaged);
                let file = StriataFile::parse(&damaged).unwrap();
                match file.patterns().unwrap() {
                    Ok(patterns) => check_against_own_fragments(&patterns, mesh.groups.len().max(1)),
                    Err(_) => refused += 1,
                }
                read += 1;
            }
        }
    }
    assert!(refused < read, "corners of the base are as good as others");
    assert!(refused * 10 > read * 8, "{refused} of {read} are refused");
}

#[test]
fn patterns_with_too_many_triangles_are_not_written() {
    let face = |corners: [u32; 3]| Face { corners, group: 0 };
    let base = vec![face([0, 1, 2])];
    for (count, is_stored) in [(500, true), (600, false)] {
        let ceiling = vec![face([0, 1, 3]); count];
        let step = Fragment { ceiling, floor: base.clone(), error: 0.0 };
        let positions = PositionIndex::identity(4);
        let fragments = FragmentSequence::from_fragments(positions, base.clone(), [step].into_iter());
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mesh = IndexedMesh::new(corners.to_vec(), vec![[0, 1, 3]; count]);
        let fragmented = FragmentedMesh { mesh, fragments: fragments.unwrap() };
        let patterns = Patterns::build(&fragmented).unwrap();
        let mut out = Vec::new();
        let written = write_fragments(
            &fragmented,
            &[FileModel::Patterns(&patterns)],
            &WriteOptions::default(),
            &mut out,
        );
        assert_eq!(written.is_ok(), is_stored, "{count}: {written:?}");
    }
}

proptest! {
    #![proptest_config(striata_testing::cases(500))]

    #[test]
    fn damaged_patterns_are_an_error_or_patterns_without_cracks(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..3),
        seed in 0u64..6,
        which in 0usize..2,
    ) {
        let mesh = if seed % 2 == 0 { with_seams_and_groups(grid(3, true)) } else { grid(5, false) };
        let sequence_options = RandomSequenceOptions { far_percent: 10, base_position_count: 4 };
        let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(seed));
        let mut bytes = both_files(&refinable)[which].clone();
        let is_damaged = |kind: SectionKind| kind.0.starts_with(b"PA") || kind == SectionKind::SUMMARY;
        let sections = StriataFile::parse(&bytes).unwrap().sections().to_vec();
        let spans = sections.iter().filter(|s| is_damaged(s.kind)).map(|s| s.offset..s.offset + s.bytes);
        let candidates: Vec<u64> = spans.flatten().collect();
        for (index, byte) in changes {
            bytes[candidates[index.index(candidates.len())] as usize] ^= byte;
        }
        with_valid_checksums(&mut bytes);
        let _ = read_everything(&bytes);
    }
}
