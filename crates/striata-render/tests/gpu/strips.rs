//! Strips on the GPU equal those on the CPU after any sequence of moves, and small moves upload little.

use crate::support::gpu;
use proptest::prelude::*;
use striata::mesh::{IndexedMesh, Random, RefinableMesh, shapes};
use striata::model::{LodModel, LodStrips};
use striata::simplify::build_sequence;
use striata::strip::stripify;
use striata_render::gpu::{Drawing, Gpu, GpuLodStrips};
use striata_testing::meshes;

fn refinable(mesh: &IndexedMesh) -> Option<RefinableMesh> {
    Some(build_sequence(mesh, &Default::default()).ok()?.refinable)
}

fn model(refinable: &RefinableMesh) -> LodStrips<'static> {
    let strips = stripify(&refinable.mesh).unwrap();
    LodStrips::build(refinable, &strips).unwrap()
}

/// Compares the drawn ranges on both sides; indices past them may be stale.
fn check(gpu: &Gpu, strips: &GpuLodStrips, what: &str) {
    let found = strips.indices().read(gpu).unwrap();
    let expected = strips.buffer().indices();
    let mut drawn = 0;
    for range in strips.buffer().group_ranges() {
        let range = range.start as usize..range.end as usize;
        let differing = found[range.clone()].iter().zip(&expected[range.clone()]).position(|(a, b)| a != b);
        assert_eq!(differing, None, "{what}: an index at or after {} differs", range.start);
        drawn += range.len();
    }
    let strip_indices: usize = strips.buffer().strip_ranges().map(|strip| strip.len()).sum();
    assert!(drawn >= strip_indices, "{what}: {drawn} of {strip_indices} indices are drawn");
}

/// Moves through these levels and compares CPU and GPU after each.
fn walk(gpu: &Gpu, model: &LodStrips<'_>, split_counts: impl IntoIterator<Item = usize>) {
    let mut state = model.new_state();
    let mut strips = GpuLodStrips::new(gpu, model, &mut state).unwrap();
    check(gpu, &strips, "initially");
    for split_count in split_counts {
        model.move_to(&mut state, split_count);
        strips.follow(gpu, model, &mut state);
        check(gpu, &strips, &format!("level {split_count}"));
        let Drawing::Strips { groups, .. } = strips.drawing() else { panic!("not drawn as strips") };
        assert_eq!(groups, strips.buffer().group_ranges().collect::<Vec<_>>());
    }
}

fn random_levels(step_count: usize, seed: u64) -> impl Iterator<Item = usize> {
    let mut random = Random::new(seed);
    let mut at = step_count;
    (0..40).map(move |i| {
        let reach = if i % 5 == 0 { step_count } else { step_count / 50 + 2 };
        let low = at.saturating_sub(reach);
        let high = (at + reach).min(step_count);
        at = low + random.below((high - low) as u32 + 1) as usize;
        at
    })
}

#[test]
fn any_sequence_of_moves_leaves_equal_indices_on_cpu_and_gpu() {
    let gpu = gpu();
    let mut mesh_count = 0;
    for (_, mesh) in meshes::nasty() {
        let Some(refinable) = refinable(&mesh) else { continue };
        mesh_count += 1;
        let step_count = refinable.sequence.step_count();
        walk(&gpu, &model(&refinable), (0..=4).rev().chain(0..=4).map(|part| step_count * part / 4));
    }
    assert!(mesh_count >= 25, "only {mesh_count} meshes");
    for mesh in [shapes::icosphere(4, 1.0), shapes::two_material_sphere(20, 30), shapes::uv_cylinder(40, 12)]
    {
        let refinable = refinable(&mesh).unwrap();
        walk(&gpu, &model(&refinable), random_levels(refinable.sequence.step_count(), 9));
    }
}

#[test]
fn small_moves_upload_little() {
    let gpu = gpu();
    let refinable = refinable(&shapes::terrain(220, 3)).unwrap();
    let model = model(&refinable);
    let mut state = model.new_state();
    let mut strips = GpuLodStrips::new(&gpu, &model, &mut state).unwrap();
    let whole = strips.uploaded_bytes();
    assert_eq!(whole, 4 * strips.buffer().indices().len() as u64);
    model.move_to(&mut state, model.step_count() - 1);
    strips.follow(&gpu, &model, &mut state);
    let sent = strips.uploaded_bytes() - whole;
    assert!(sent > 0 && sent < whole / 4, "{sent} of {whole} bytes for one step");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(12) })]

    #[test]
    fn random_walks_on_soups(triangle_count in 1u32..200, seed in 0u64..1000) {
        let gpu = gpu();
        let refinable = refinable(&shapes::random_soup(triangle_count, seed)).unwrap();
        walk(&gpu, &model(&refinable), random_levels(refinable.sequence.step_count(), seed));
    }
}
