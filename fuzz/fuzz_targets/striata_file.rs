//! Damaged `.striata` files: an error, or levels that are sound meshes.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::codec::{DecodeError, StriataFile, Verify};
use striata::mesh::replay;
use striata::model::StripModel;
use striata_fuzz::with_checksums_set_right;

fuzz_target!(|data: &[u8]| {
    let _ = read_all(data, Verify::WhenRead);
    let _ = read_all(&with_checksums_set_right(data), Verify::All);
});

fn read_all(bytes: &[u8], verify: Verify) -> Result<(), DecodeError> {
    let file = StriataFile::parse_with(bytes, verify)?;
    let _ = file.metadata();
    let _ = file.layers();
    if let Ok(refinable) = file.refinable_mesh() {
        let step_count = refinable.sequence.step_count();
        for split_count in [0, step_count / 2, step_count] {
            assert_eq!(replay(&refinable, split_count).check(), Ok(()));
        }
    }
    if let Some(model) = file.lod_strips() {
        walk_through(&file, &model?);
    }
    if let Some(model) = file.mts() {
        walk_through(&file, &model?);
    }
    Ok(())
}

fn walk_through<M: StripModel>(file: &StriataFile<'_>, model: &M) {
    let full = model.new_state();
    let mut state = model.new_state();
    let step_count = model.step_count();
    for split_count in [step_count / 2, 0, step_count / 3, step_count] {
        model.move_to(&mut state, split_count);
        if let Ok(level) = file.level_of(model, &state) {
            assert_eq!(level.check(), Ok(()));
        }
    }
    for strip in 0..model.strip_count() {
        assert_eq!(model.strip(&state, strip), model.strip(&full, strip), "down and up is not the same");
    }
}
