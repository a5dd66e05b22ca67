//! Small meshes of every shape and random options: sequence, model and file agree with the oracle.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::codec::{FileModel, StriataFile, WriteOptions, to_striata};
use striata::ignore_progress;
use striata::mesh::{RefinableMesh, canonical_triangles, replay};
use striata::model::{LodModel, LodStrips};
use striata::simplify::{BoundaryRule, CollapseCost, SequenceOptions, build_sequence};
use striata::strip::{StripOptions, stripify};
use striata_fuzz::Bytes;

fuzz_target!(|data: &[u8]| {
    let mut bytes = Bytes(data);
    let options = options(&mut bytes);
    let mesh = bytes.mesh();
    let built = build_sequence(&mesh, &options, &mut ignore_progress);
    assert_eq!(built.is_ok(), mesh.check().is_ok(), "{:?}", built.err());
    let Ok(built) = built else { return };
    check_levels(&built.refinable);
});

fn options(bytes: &mut Bytes<'_>) -> SequenceOptions {
    let choice = bytes.byte();
    let costs = [CollapseCost::Memoryless, CollapseCost::Accumulated, CollapseCost::Tracked];
    let mut options = SequenceOptions::default().with_cost(costs[usize::from(choice % 3)]);
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
    let strips = stripify(&refinable.mesh, &StripOptions::default()).expect("full meshes are sound");
    let model = LodStrips::build(refinable, &strips).expect("the strips are the mesh's");
    let mut state = model.new_state();
    let mut last_error = 0.0;
    for split_count in (0..=model.step_count()).rev() {
        let level = replay(refinable, split_count);
        assert_eq!(level.triangle_count(), refinable.sequence.triangle_count_at(split_count));
        let error = refinable.sequence.error_at(split_count);
        assert!(error >= last_error, "error {error} after {last_error}");
        last_error = error;
        model.move_to(&mut state, split_count);
        let mut shown = Vec::new();
        model.triangles_into(&state, &mut shown);
        assert_eq!(canonical_triangles(&shown), canonical_triangles(&level.triangles), "at {split_count}");
    }
    let models = [FileModel::LodStrips(&model)];
    let bytes = to_striata(refinable, &models, &WriteOptions::default()).expect("sound meshes are written");
    let found = StriataFile::parse(&bytes).and_then(|file| file.refinable_mesh()).expect("written just now");
    assert_eq!(found.sequence, refinable.sequence);
}
