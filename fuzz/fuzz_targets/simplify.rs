//! Simplifies small meshes of every shape with random options: sequence, models and file must agree with
//! the oracle.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::file::{FileModel, StriataFile, WriteOptions, to_striata};
use striata::mesh::{RefinableMesh, canonical_triangles, replay};
use striata::model::{Fans, LodModel, LodStrips, Mts};
use striata::simplify::{BoundaryRule, CostFunction, SequenceOptions, build_sequence};
use striata::strip::stripify;
use striata_fuzz::Bytes;
use striata_lab::MtsGraph;
use striata_lab::baseline::{OriginalLodStrips, ProgressiveMeshes, SkipStrips};

fuzz_target!(|data: &[u8]| {
    let mut bytes = Bytes(data);
    let options = options(&mut bytes);
    let mesh = bytes.mesh();
    let built = build_sequence(&mesh, &options);
    assert_eq!(built.is_ok(), mesh.check().is_ok(), "{:?}", built.err());
    let Ok(built) = built else { return };
    check_levels(&built.refinable);
});

fn options(bytes: &mut Bytes<'_>) -> SequenceOptions {
    let choice = bytes.byte();
    let costs = CostFunction::ALL;
    let mut options = SequenceOptions::default().with_cost(costs[usize::from(choice) % costs.len()]);
    if choice & 8 != 0 {
        options = options.with_boundary(BoundaryRule::Locked);
    }
    if choice & 16 != 0 {
        options = options.with_pair_distance(f64::from(bytes.byte()) / 16.0);
    }
    if choice & 32 != 0 {
        options = options.with_max_error(f64::from(bytes.byte()) / 64.0);
    }
    if choice & 64 != 0 {
        options = options.with_base_triangle_count(usize::from(bytes.byte()));
    }
    options
}

fn check_levels(refinable: &RefinableMesh) {
    let sequence = &refinable.sequence;
    let mut last_error = 0.0;
    for split_count in (0..=sequence.step_count()).rev() {
        let error = sequence.error_at(split_count);
        assert!(error >= last_error, "error {error} after {last_error}");
        last_error = error;
        assert_eq!(replay(refinable, split_count).triangle_count(), sequence.triangle_count_at(split_count));
    }
    let strips = stripify(&refinable.mesh).expect("full meshes are valid");
    let what = "the strips are the mesh's";
    let lod_strips = LodStrips::build(refinable, &strips).expect(what);
    let mts = Mts::build(refinable, &strips).expect(what);
    check_model(refinable, &lod_strips);
    check_model(refinable, &mts);
    check_model(refinable, &MtsGraph::build(refinable, &strips).expect(what));
    check_model(refinable, &OriginalLodStrips::build(refinable, &strips).expect(what));
    check_model(refinable, &SkipStrips::build(refinable, &strips).expect(what));
    check_model(refinable, &ProgressiveMeshes::build(refinable));
    let fans = Fans::build(refinable);
    check_model(refinable, &fans);
    let models = [FileModel::LodStrips(&lod_strips), FileModel::Mts(&mts), FileModel::Fans(&fans)];
    let bytes =
        to_striata(refinable, &models, &WriteOptions::default()).expect("valid meshes can be written");
    let file = StriataFile::parse(&bytes).expect("written just now");
    assert_eq!(file.refinable_mesh().expect("written just now").sequence, refinable.sequence);
    assert_eq!(file.mts().map(|found| found.expect("written just now")), Some(mts));
    assert_eq!(file.fans().map(|found| found.expect("written just now")), Some(fans));
}

/// From full to base mesh and back, then from each end to the middle.
fn check_model<M: LodModel>(refinable: &RefinableMesh, model: &M) {
    let mut state = model.new_state();
    let step_count = model.step_count();
    let middle = step_count / 2;
    for split_count in (0..=step_count).rev().chain(0..=step_count).chain([middle, 0, middle]) {
        model.move_to(&mut state, split_count);
        let mut shown = Vec::new();
        model.triangles_into(&state, &mut shown);
        let level = replay(refinable, split_count);
        assert_eq!(canonical_triangles(&shown), canonical_triangles(&level.triangles), "at {split_count}");
    }
}
