//! Patterns in sequential form: every level survives encoding and decoding, and other input gives an error
//! or a surface.

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::{
    DefectKind, FragmentSequence, FragmentedMesh, IndexedMesh, canonical_triangles, fragment_faces,
    replay_fragments, shapes, validate,
};
use striata::simplify::{SequenceOptions, TopologyRule, build_sequence};
use striata_lab::baseline::{
    LoopPatterns, SequentialDecoder, SequentialPatterns, SequentialPatternsError, decode_sequential,
};
use support::{Random, fragment_cases, grid, hub_cases, nasty_cases, random_removals, seam_cases};

fn collapsed(mesh: &IndexedMesh) -> FragmentedMesh {
    // The model supports manifolds only.
    let options = SequenceOptions::default().with_topology(TopologyRule::Keep);
    let simplified = build_sequence(mesh, &options).unwrap();
    FragmentedMesh::from_collapses(&simplified.refinable)
}

fn collapsed_cases() -> impl Iterator<Item = FragmentedMesh> {
    let mut holed = grid(13, false);
    holed.triangles.retain(|t| !(t.contains(&34) && t.contains(&35) || t.contains(&66) && t.contains(&80)));
    [holed, grid(9, false), shapes::icosphere(3, 1.0), shapes::terrain(16, 5)]
        .into_iter()
        .map(|mesh| collapsed(&mesh))
}

fn triangles_at(fragments: &FragmentSequence, split_count: usize) -> Vec<[u32; 3]> {
    let faces = fragment_faces(fragments, |step| (step as usize) < split_count);
    let corners: Vec<_> = faces.iter().map(|&face| fragments.faces()[face as usize].corners).collect();
    canonical_triangles(&corners)
}

fn decodes_as_encoded(mesh: &FragmentedMesh) -> SequentialPatterns {
    let encoded = SequentialPatterns::encode(mesh).unwrap();
    let step_count = mesh.fragments.step_count();
    assert_eq!(encoded.step_count(), step_count);
    let decoded = decode_sequential(encoded.as_bytes()).unwrap();
    assert_eq!(
        (decoded.step_count(), decoded.base_face_count()),
        (step_count, mesh.fragments.base_face_count())
    );
    let mut decoder = SequentialDecoder::new(encoded.as_bytes()).unwrap();
    for split_count in 0..=step_count {
        let expected = canonical_triangles(&replay_fragments(mesh, split_count).triangles);
        assert_eq!(triangles_at(&decoded, split_count), expected, "level {split_count}");
        assert_eq!(canonical_triangles(decoder.triangles()), expected, "level {split_count}, step by step");
        assert_eq!(decoder.next_fragment().unwrap().is_some(), split_count < step_count);
    }
    // Each step exchanges the same triangles, so any closed set of steps is the same too.
    for step in 0..step_count as u32 {
        let floor = |fragments: &FragmentSequence| {
            let corners = fragments.floor(step).iter().map(|&face| fragments.faces()[face as usize].corners);
            canonical_triangles(&corners.collect::<Vec<_>>())
        };
        assert_eq!(floor(&decoded), floor(&mesh.fragments));
    }
    encoded
}

#[test]
fn every_level_is_decoded_as_encoded() {
    for mesh in fragment_cases().map(|case| case.1).chain(collapsed_cases()) {
        let encoded = decodes_as_encoded(&mesh);
        assert!(encoded.fragment_bits() >= encoded.paper_fragment_bits());
        assert!(encoded.fragment_bits() < encoded.paper_fragment_bits() * 12 / 10);
    }
}

#[test]
fn typical_fragments_take_the_papers_bits() {
    let encoded = decodes_as_encoded(&collapsed(&shapes::icosphere(3, 1.0)));
    let (bits, paper) = (encoded.fragment_bits(), 44 * encoded.step_count());
    assert_eq!(encoded.paper_fragment_bits(), paper);
    assert!(bits < paper * 101 / 100, "{bits} bits, the paper has {paper}");
    assert!(encoded.as_bytes().len() < bits / 8 + 200);
}

/// More neighbors than four bits can count, and more rules than a byte can.
#[test]
fn values_that_do_not_fit_use_the_long_form() {
    let bipyramid = |n: u32| {
        let positions = (0..n + 2).map(|i| [i as f32, (i * i % 17) as f32, (i % 5) as f32]).collect();
        let sides = (0..n).map(|i| [2 + i, 2 + (i + 1) % n]);
        IndexedMesh::new(positions, sides.flat_map(|[a, b]| [[a, b, 0], [b, a, 1]]).collect())
    };
    let mut long_count = 0;
    for seed in 1..8 {
        let mesh = random_removals(&bipyramid(40), usize::MAX, &mut Random::new(seed));
        let encoded = decodes_as_encoded(&mesh);
        long_count += usize::from(encoded.fragment_bits() > encoded.paper_fragment_bits());
    }
    assert!(long_count > 0, "no value used the long form");
    let mesh = random_removals(&grid(90, false), usize::MAX, &mut Random::new(4));
    assert!(LoopPatterns::build(&mesh).unwrap().rule_count() > 256);
    let encoded = SequentialPatterns::encode(&mesh).unwrap();
    let decoded = decode_sequential(encoded.as_bytes()).unwrap();
    for split_count in [0, 700, decoded.step_count()] {
        assert_eq!(triangles_at(&decoded, split_count), triangles_at(&mesh.fragments, split_count));
    }
}

#[test]
fn non_surfaces_are_rejected() {
    let mut rejected = 0;
    for case in nasty_cases().chain(seam_cases()).chain(hub_cases()) {
        let mesh = FragmentedMesh::from_collapses(&case.refinable);
        match SequentialPatterns::encode(&mesh) {
            Ok(_) => drop(decodes_as_encoded(&mesh)),
            Err(_) => rejected += 1,
        }
    }
    assert!(rejected > 60, "{rejected} of them are rejected");
}

/// Checks that decoded levels are surfaces; returns false if decoding fails.
fn is_error_or_surface(bytes: &[u8]) -> bool {
    let Ok(mut decoder) = SequentialDecoder::new(bytes) else { return false };
    loop {
        let triangles = decoder.triangles().to_vec();
        let count = triangles.iter().flatten().max().map_or(0, |&v| v as usize + 1);
        let positions = (0..count).map(|i| [i as f32, (i * i % 11) as f32, (i % 7) as f32]).collect();
        let report = validate(&IndexedMesh::new(positions, triangles));
        let mut defects = report.defects().iter();
        assert!(defects.all(|defect| defect.kind() != DefectKind::RepeatedVertex), "{:?}", report.defects());
        match decoder.next_fragment() {
            Ok(Some(_)) => {}
            Ok(None) => return decode_sequential(bytes).is_ok(),
            Err(_) => {
                assert!(decode_sequential(bytes).is_err());
                return false;
            }
        }
    }
}

#[test]
fn every_truncation_is_an_error() {
    let encoded = SequentialPatterns::encode(&collapsed(&grid(6, false))).unwrap();
    let bytes = encoded.as_bytes();
    assert!(is_error_or_surface(bytes));
    for len in 0..bytes.len() {
        assert!(decode_sequential(&bytes[..len]).is_err(), "{len} bytes of {}", bytes.len());
    }
    let longer = [bytes, &[0]].concat();
    assert!(matches!(decode_sequential(&longer), Err(SequentialPatternsError::Trailing { .. })));
}

#[test]
fn flipped_bits_give_an_error_or_a_surface() {
    let mesh = random_removals(&grid(5, false), usize::MAX, &mut Random::new(2));
    let encoded = SequentialPatterns::encode(&mesh).unwrap();
    let (mut decoded, mut rejected) = (0, 0);
    for bit in 0..8 * encoded.as_bytes().len() {
        let mut bytes = encoded.as_bytes().to_vec();
        bytes[bit / 8] ^= 1 << (bit % 8);
        *if is_error_or_surface(&bytes) { &mut decoded } else { &mut rejected } += 1;
    }
    assert!(decoded > 0 && rejected > 500, "{decoded} are decoded, {rejected} rejected");
}

#[test]
fn invalid_counts_are_rejected_before_allocating() {
    let head = |counts: [u32; 4]| counts.iter().flat_map(|count| count.to_le_bytes()).collect::<Vec<u8>>();
    let message = |bytes: &[u8]| decode_sequential(bytes).unwrap_err().to_string();
    let most = u32::MAX;
    assert_eq!(message(&[1, 2, 3]), "the counts take 16 bytes, but 3 are left");
    let all = 12 * u64::from(most);
    assert_eq!(
        message(&head([most; 4])),
        format!("the triangles of the base take {all} bytes, but 0 are left")
    );
    assert_eq!(
        message(&head([most, 0, 0, 0])),
        format!("there are {most} vertices of the base, but at most 0 are possible")
    );
    assert_eq!(message(&head([0, 0, 9, 0])), "the fragments take 50 bytes, but 0 are left");
    assert_eq!(message(&head([0, 0, 0, 70_000])), "there are 70000 rules, but at most 65536 are possible");
    assert_eq!(message(&head([0, 0, 0, 5])), "the rules take 10 bytes, but 0 are left");
    let rule = |rule: &[u8]| message(&[&head([0, 0, 0, 1])[..], rule].concat());
    assert_eq!(rule(&[1, 0]), "rule 0 has a ring of fewer than two corners");
    assert_eq!(rule(&[2, 0]), "rule 0 has a closed ring of two corners");
    assert_eq!(rule(&[3, 2, 2]), "rule 0 has a ring that is neither open nor closed");
    assert_eq!(rule(&[4, 0, 2, 2]), "rule 0 has a floor that does not fill its ring");
    assert_eq!(rule(&[200, 0]), "the floor of a rule take 198 bytes, but 0 are left");
    let triangle = [0u32, 1, 2].map(u32::to_le_bytes).concat();
    let with = |steps: u32, tail: &[u8]| [&head([3, 1, steps, 1])[..], &triangle, &[3, 0, 2], tail].concat();
    assert!(decode_sequential(&with(0, &[])).is_ok());
    assert!(decode_sequential(&with(1, &[0; 6])).is_ok());
    assert_eq!(message(&with(1, &[1, 0, 0, 0, 0, 0])), "step 0 has an unknown rule");
    assert_eq!(message(&with(1, &[0, 3, 0, 0, 0, 0])), "step 0 has an anchor out of range");
    assert_eq!(message(&with(1, &[0, 0, 0, 0, 0, 2])), "step 0 counts more neighbors than its anchor has");
    assert_eq!(message(&with(1, &[0, 0, 0, 0, 0, 1])), "step 0 has no triangle at its anchors");
    assert_eq!(message(&with(1, &[0, 0, 0, 0, 0, 15])), "step 0 is truncated");
    assert_eq!(
        message(&with(1, &[0, 0, 0, 0, 0, 0x80])),
        "4 bits follow the last fragment, some of them set"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn random_bytes_give_an_error_or_a_surface(seed in any::<u64>(), changes in 1usize..12) {
        let mut random = Random::new(seed);
        let mesh = random_removals(&grid(4 + random.below(3), random.below(2) == 0), 30, &mut random);
        let mut bytes = SequentialPatterns::encode(&mesh).unwrap().as_bytes().to_vec();
        for _ in 0..changes {
            let at = random.below(bytes.len());
            bytes[at] = random.below(256) as u8;
        }
        is_error_or_surface(&bytes);
    }
}
