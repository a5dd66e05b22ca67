//! What every model is held to: the oracle's triangles at every level, whatever way led there.

use std::fmt::Debug;

use striata::mesh::{IndexedMesh, RefinableMesh, canonical_triangles, replay};
use striata::model::{LodModel, Topology};
use striata::strip::RESTART;

use super::Random;

/// Jumps between levels that are tried beside the walks down and up.
const JUMP_COUNT: usize = 24;

/// The oracle of a selective level: every corner follows its targets to the first vertex that is there.
pub fn selective_triangles(
    refinable: &RefinableMesh,
    triangles: &[[u32; 3]],
    is_taken: impl Fn(u32) -> bool,
) -> Vec<[u32; 3]> {
    let sequence = &refinable.sequence;
    let base = sequence.base_position_count();
    let shown = |mut v: u32| {
        loop {
            let position = sequence.positions().position_of(v) as usize;
            match position.checked_sub(base) {
                Some(step) if is_taken(step as u32) => v = sequence.target(v),
                _ => return v,
            }
        }
    };
    let proper = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    triangles.iter().map(|t| t.map(shown)).filter(proper).collect()
}

/// Holds a model of all levels to the oracle: down and up by `stride`, then in random jumps, group by group; states
/// on the way up equal those on the way down, and the full mesh is at last shown by the state that was there first.
pub fn follows_the_oracle<M>(refinable: &RefinableMesh, model: &M, stride: usize)
where
    M: LodModel,
    M::State: Clone + Debug + PartialEq,
{
    follows_the_oracle_at(refinable, model, stride, |split_count| split_count);
}

/// Does as [`follows_the_oracle`] for a model that has not all levels: `shown` says which level it has to show
/// where it is asked for another.
pub fn follows_the_oracle_at<M>(
    refinable: &RefinableMesh,
    model: &M,
    stride: usize,
    shown: impl Fn(usize) -> usize,
) where
    M: LodModel,
    M::State: Clone + Debug + PartialEq,
{
    follows_levels(model, refinable.sequence.step_count(), stride, shown, |split_count| {
        replay(refinable, split_count)
    });
}

/// Does as [`follows_the_oracle_at`] with whatever oracle there is: `level_of` makes its levels.
pub(super) fn follows_levels<M>(
    model: &M,
    step_count: usize,
    stride: usize,
    shown: impl Fn(usize) -> usize,
    level_of: impl Fn(usize) -> IndexedMesh,
) where
    M: LodModel,
    M::State: Clone + Debug + PartialEq,
{
    assert_eq!(model.step_count(), step_count);
    let full = model.new_state();
    let mut state = full.clone();
    let go_to = |state: &mut M::State, split_count: usize| {
        model.move_to(state, split_count);
        assert_eq!(model.split_count(state), shown(split_count), "asked for level {split_count}");
        shows_its_level(&level_of(model.split_count(state)), model, state);
    };
    shows_its_level(&level_of(model.split_count(&state)), model, &state);
    assert_eq!(model.split_count(&state), step_count, "a new instance shows the full mesh");
    let mut levels: Vec<usize> = (0..=step_count).rev().step_by(stride).collect();
    if levels.last() != Some(&0) {
        levels.push(0);
    }
    let mut seen = Vec::with_capacity(levels.len());
    for &split_count in &levels {
        go_to(&mut state, split_count);
        seen.push(state.clone());
    }
    for (&split_count, expected) in levels.iter().zip(&seen).rev() {
        go_to(&mut state, split_count);
        assert!(state == *expected, "down and up again, the state at {split_count} is another");
    }
    let mut random = Random::new(step_count as u64);
    for _ in 0..JUMP_COUNT.min(step_count) {
        let i = random.below(levels.len());
        go_to(&mut state, levels[i]);
        assert!(state == seen[i], "after a jump, the state at {} is another", levels[i]);
        go_to(&mut state, random.below(step_count + 1));
    }
    model.move_to(&mut state, step_count);
    assert_eq!(state, full, "the full mesh again is the first state again");
}

/// Compares what is drawn with the oracle, group by group, and with the counts that the model tells.
fn shows_its_level<M: LodModel>(level: &IndexedMesh, model: &M, state: &M::State) {
    let split_count = model.split_count(state);
    // What was in the buffer stays: models append.
    let mut indices = vec![7];
    model.indices_into(state, &mut indices);
    assert_eq!(indices[0], 7);
    let indices = &indices[1..];
    let counts = model.draw_counts(state);
    assert_eq!(indices.len(), counts.index_count, "indices at {split_count}");
    let strip_count = match model.topology() {
        Topology::Triangles => {
            assert_eq!(
                indices.len(),
                3 * level.triangle_count(),
                "only what shows is drawn at {split_count}"
            );
            0
        }
        Topology::Strips if indices.is_empty() => 0,
        Topology::Strips => {
            let strips = || indices.split(|&index| index == RESTART);
            assert!(strips().all(|strip| strip.len() >= 3), "strips without triangles at {split_count}");
            strips().count()
        }
    };
    assert_eq!(counts.strip_count, strip_count, "strips at {split_count}");
    let mut triangles = vec![[7; 3]];
    model.triangles_into(state, &mut triangles);
    assert_eq!(triangles[0], [7; 3]);
    let triangles = &triangles[1..];
    assert_eq!(triangles.len(), level.triangle_count(), "triangles at {split_count}");
    for (g, group) in level.groups_or_whole().into_iter().enumerate() {
        let found = canonical_triangles(&triangles[group.range()]);
        let expected = canonical_triangles(&level.triangles[group.range()]);
        assert_eq!(found, expected, "group {g} at {split_count}");
    }
}
