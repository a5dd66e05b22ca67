//! Oracle for all models: a model must show the oracle's triangles at every level, regardless of the path.

use std::fmt::Debug;

use striata::mesh::{IndexedMesh, RefinableMesh, canonical_triangles, replay};
use striata::model::{LodModel, Topology};
use striata::strip::RESTART;

use super::Random;

/// Number of random jumps between levels, in addition to moving down and up.
const JUMP_COUNT: usize = 24;

/// Oracle of a selective level: every corner is mapped to the first active vertex in its chain of targets.
pub fn selective_triangles(
    refinable: &RefinableMesh,
    triangles: &[[u32; 3]],
    is_collapsed: impl Fn(u32) -> bool,
) -> Vec<[u32; 3]> {
    let sequence = &refinable.sequence;
    let base = sequence.base_position_count();
    let shown = |mut v: u32| {
        loop {
            let position = sequence.positions().position_of(v) as usize;
            match position.checked_sub(base) {
                Some(step) if is_collapsed(step as u32) => v = sequence.target(v),
                _ => return v,
            }
        }
    };
    let proper = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    triangles.iter().map(|t| t.map(shown)).filter(proper).collect()
}

/// Checks a model against the oracle, group by group: down and up by `stride`, then in random jumps.
/// States on the way up must equal those on the way down, and returning to the full mesh must restore the
/// initial state.
pub fn follows_the_oracle<M>(refinable: &RefinableMesh, model: &M, stride: usize)
where
    M: LodModel,
    M::State: Clone + Debug + PartialEq,
{
    follows_the_oracle_at(refinable, model, stride, |split_count| split_count);
}

/// Checks a model that does not have all levels, like [`follows_the_oracle`]; `shown` returns the level
/// that it must show for a requested one.
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

/// Checks a model like [`follows_the_oracle_at`], with `level_of` as the oracle.
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
        assert_eq!(model.split_count(state), shown(split_count), "requested level {split_count}");
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
        assert!(state == *expected, "the state at {split_count} differs after moving down and up");
    }
    let mut random = Random::new(step_count as u64);
    for _ in 0..JUMP_COUNT.min(step_count) {
        let i = random.below(levels.len());
        go_to(&mut state, levels[i]);
        assert!(state == seen[i], "the state at {} differs after a jump", levels[i]);
        go_to(&mut state, random.below(step_count + 1));
    }
    model.move_to(&mut state, step_count);
    assert_eq!(state, full, "returning to the full mesh restores the initial state");
}

/// Compares what is drawn with the oracle, group by group, and with the counts that the model reports.
fn shows_its_level<M: LodModel>(level: &IndexedMesh, model: &M, state: &M::State) {
    let split_count = model.split_count(state);
    // Models append, so existing contents must be kept.
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
                "only visible triangles are drawn at {split_count}"
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
