//! Levels of scenes, compared with an oracle that sorts all steps.

use proptest::prelude::*;
use striata::Target;
use striata::mesh::{LevelTable, PositionIndex};
use striata::simplify::StopReason;
use striata_scene::{MeshWeight, SceneLevels};

/// A mesh with its weight; steps are listed from coarse to fine.
#[derive(Clone, Debug)]
struct Sample {
    levels: LevelTable,
    weight: MeshWeight,
}

/// Triangles that a step adds, and by how many quarters the error falls.
type Step = (u32, u8);

fn sample(base: u32, steps: &[Step], last_wedges: bool, weight: MeshWeight) -> Sample {
    let mut counts = vec![base];
    counts.extend(steps.iter().scan(base, |count, &(added, _)| {
        *count += added;
        Some(*count)
    }));
    let mut error = 0.0;
    let mut errors: Vec<f32> = steps
        .iter()
        .rev()
        .map(|&(_, rise)| {
            error += f32::from(rise) / 4.0;
            error
        })
        .collect();
    errors.reverse();
    let position_count = 3 + steps.len();
    let mut first: Vec<u32> = (0..=position_count as u32).collect();
    if last_wedges {
        *first.last_mut().unwrap() += 2;
    }
    let levels = LevelTable::new(PositionIndex::from_first(first), 3, counts, errors).unwrap();
    Sample { levels, weight }
}

fn one_sample() -> impl Strategy<Value = Sample> {
    let steps = prop::collection::vec((0u32..4, 0u8..3), 0..40);
    // Powers of two keep products and quotients exact.
    let weight = (-3i32..4, 1usize..4).prop_map(|(power, instance_count)| MeshWeight {
        scale: 2f64.powi(power),
        instance_count,
        ..Default::default()
    });
    let one = (1u32..5, steps, any::<bool>(), weight);
    one.prop_map(|(base, steps, wedges, weight)| sample(base, &steps, wedges, weight))
}

fn samples() -> impl Strategy<Value = Vec<Option<Sample>>> {
    prop::collection::vec(prop::option::weighted(0.9, one_sample()), 0..8)
}

/// Whether two samples have the same levels at the same scale, which the oracle does not make alike.
fn has_twins(samples: &[Option<Sample>]) -> bool {
    let samples: Vec<&Sample> = samples.iter().flatten().collect();
    let is_twin = |a: &Sample, b: &Sample| a.levels == b.levels && a.weight.scale == b.weight.scale;
    (0..samples.len()).any(|a| samples[..a].iter().any(|b| is_twin(samples[a], b)))
}

fn merged(samples: &[Option<Sample>]) -> SceneLevels {
    let levels: Vec<Option<&LevelTable>> = samples.iter().map(|s| Some(&s.as_ref()?.levels)).collect();
    let weights: Vec<MeshWeight> =
        samples.iter().map(|s| s.as_ref().map_or(MeshWeight::default(), |s| s.weight)).collect();
    SceneLevels::new(&levels, &weights)
}

/// States of the scene from full to base: split counts, triangles, vertices, error.
struct Oracle(Vec<(Vec<usize>, usize, usize, f64)>);

impl Oracle {
    fn new(samples: &[Option<Sample>]) -> Self {
        let scaled = |mesh: usize, split_count: usize| {
            let sample = samples[mesh].as_ref().unwrap();
            sample.weight.scale * f64::from(sample.levels.error_at(split_count))
        };
        let step_counts: Vec<usize> =
            samples.iter().map(|s| s.as_ref().map_or(0, |s| s.levels.step_count())).collect();
        let mut steps: Vec<(usize, usize)> = Vec::new();
        for (mesh, &step_count) in step_counts.iter().enumerate() {
            steps.extend((0..step_count).rev().map(|split_count| (mesh, split_count)));
        }
        // The sort is stable, so meshes of one error follow each other.
        steps.sort_by(|&a, &b| scaled(a.0, a.1).total_cmp(&scaled(b.0, b.1)));
        let mut splits = step_counts;
        let mut states = Vec::new();
        for next in std::iter::once(None).chain(steps.into_iter().map(Some)) {
            if let Some((mesh, split_count)) = next {
                splits[mesh] = split_count;
            }
            let (mut triangles, mut vertices, mut error) = (0, 0, 0f64);
            for (mesh, sample) in samples.iter().enumerate() {
                let Some(sample) = sample else { continue };
                triangles += sample.levels.triangle_count_at(splits[mesh]) * sample.weight.instance_count;
                vertices += sample.levels.vertex_count_at(splits[mesh]);
                error = error.max(scaled(mesh, splits[mesh]));
            }
            states.push((splits.clone(), triangles, vertices, error));
        }
        Self(states)
    }

    fn first(&self, is_enough: impl Fn(&(Vec<usize>, usize, usize, f64)) -> bool) -> &[usize] {
        let found = self.0.iter().find(|&state| is_enough(state));
        &found.or(self.0.last()).unwrap().0
    }
}

proptest! {
    #[test]
    fn every_target_selects_the_level_of_the_oracle(
        samples in samples().prop_filter("twins are another test", |samples| !has_twins(samples)),
        share in 0f64..1.0,
    ) {
        let levels = merged(&samples);
        let oracle = Oracle::new(&samples);
        let full = &oracle.0[0];
        prop_assert_eq!((levels.triangle_count(), levels.vertex_count()), (full.1, full.2));
        prop_assert_eq!(levels.step_count() + 1, oracle.0.len());
        for limit in 0..=full.1 + 1 {
            let level = levels.resolve(Target::Triangles(limit));
            prop_assert_eq!(&level.split_counts[..], oracle.first(|state| state.1 <= limit));
            let is_reached = level.triangle_count <= limit;
            prop_assert_eq!(is_reached, level.stop_reason != StopReason::BaseReached);
        }
        for limit in 0..=full.2 + 1 {
            let level = levels.resolve(Target::Vertices(limit));
            prop_assert_eq!(&level.split_counts[..], oracle.first(|state| state.2 <= limit));
        }
        for (taken, state) in oracle.0.iter().enumerate() {
            let split_count = levels.step_count() - taken;
            let level = levels.resolve(Target::SplitCount(split_count));
            prop_assert_eq!(&level.split_counts, &state.0);
            prop_assert_eq!((level.triangle_count, level.vertex_count), (state.1, state.2));
            prop_assert_eq!(level.error, state.3);
            prop_assert_eq!(&levels.level_of(level.split_counts.clone()), &level);
        }
        let exact = (share * levels.step_count() as f64 + 1e-9) as usize;
        prop_assert_eq!(levels.resolve(Target::Detail(share)), levels.resolve(Target::SplitCount(exact)));
    }

    #[test]
    fn equal_meshes_are_shown_alike_and_targets_hold(sample in one_sample(), copies in 2usize..4) {
        let levels = merged(&vec![Some(sample); copies]);
        for limit in (0..=levels.triangle_count() + 7).step_by(7) {
            for target in [Target::Triangles(limit), Target::Vertices(limit)] {
                let level = levels.resolve(target);
                prop_assert!(level.split_counts.iter().all(|count| *count == level.split_counts[0]));
                let found =
                    if target == Target::Vertices(limit) { level.vertex_count } else { level.triangle_count };
                prop_assert!(found <= limit || level.stop_reason == StopReason::BaseReached);
            }
        }
    }

    #[test]
    fn a_cut_by_error_is_the_level_of_each_mesh(samples in samples(), quarters in 0u32..200) {
        let levels = merged(&samples);
        let error = f64::from(quarters) / 16.0;
        let level = levels.resolve(Target::Error(error));
        prop_assert!(level.error <= error);
        for (sample, &split_count) in samples.iter().zip(&level.split_counts) {
            let within = |s: &Sample| s.levels.split_count_for_error(error / s.weight.scale);
            let expected = sample.as_ref().map_or(0, within);
            prop_assert_eq!(split_count, expected);
        }
        let is_base = level.split_counts.iter().all(|&count| count == 0);
        prop_assert!(level.stop_reason != StopReason::BaseReached || is_base);
    }

    #[test]
    fn less_detail_never_means_less_error(samples in samples()) {
        let levels = merged(&samples);
        let mut last = levels.resolve(Target::Detail(1.0));
        prop_assert_eq!(last.error, 0.0);
        for split_count in (0..levels.step_count()).rev() {
            let level = levels.resolve(Target::SplitCount(split_count));
            prop_assert!(level.error >= last.error && level.vertex_count < last.vertex_count);
            prop_assert!(level.triangle_count <= last.triangle_count);
            last = level;
        }
        prop_assert_eq!(last.error, levels.base_error());
    }
}

#[test]
fn targets_out_of_range_are_reported() {
    let weight = MeshWeight { scale: 2.0, instance_count: 3, ..Default::default() };
    let levels = merged(&[None, Some(sample(2, &[(2, 1), (2, 1)], false, weight))]);
    let reason = |target| levels.resolve(target).stop_reason;
    assert_eq!(reason(Target::Triangles(19)), StopReason::FullMesh);
    assert_eq!(reason(Target::Triangles(18)), StopReason::TargetReached);
    assert_eq!(reason(Target::Triangles(5)), StopReason::BaseReached);
    assert_eq!(reason(Target::Vertices(2)), StopReason::BaseReached);
    assert_eq!(reason(Target::Error(1.0)), StopReason::TargetReached);
    assert_eq!(reason(Target::Error(1.1)), StopReason::BaseReached);
    assert_eq!(reason(Target::SplitCount(3)), StopReason::FullMesh);
    assert_eq!(reason(Target::Detail(f64::NAN)), StopReason::TargetReached);
}

#[test]
fn counts_that_rise_while_a_mesh_gets_coarser_are_searched_exactly() {
    // The floor of a removal may be larger than its ceiling.
    let counts = vec![4, 9, 3, 10];
    let levels = LevelTable::new(PositionIndex::identity(6), 3, counts, vec![3.0, 2.0, 1.0]).unwrap();
    let scene = SceneLevels::new(&[Some(&levels)], &[]);
    assert_eq!(scene.resolve(Target::Triangles(9)).split_counts, [2]);
    assert_eq!(scene.resolve(Target::Triangles(3)).split_counts, [2]);
    assert_eq!(scene.resolve(Target::Triangles(2)).split_counts, [0]);
}

#[test]
fn long_orders_are_found_block_by_block() {
    let steps: Vec<Step> = (0..3000).map(|step| (step % 3, (step % 2) as u8)).collect();
    let of_scale =
        |scale| Some(sample(4, &steps, false, MeshWeight { scale, instance_count: 2, ..Default::default() }));
    let samples = vec![of_scale(1.0), of_scale(0.25), None, of_scale(8.0)];
    let (levels, oracle) = (merged(&samples), Oracle::new(&samples));
    for limit in (0..oracle.0[0].1).step_by(97) {
        let level = levels.resolve(Target::Triangles(limit));
        assert_eq!(level.split_counts, oracle.first(|state| state.1 <= limit));
        let level = levels.resolve(Target::Vertices(limit));
        assert_eq!(level.split_counts, oracle.first(|state| state.2 <= limit));
    }
    for taken in (0..oracle.0.len()).step_by(101) {
        let level = levels.resolve(Target::SplitCount(levels.step_count() - taken));
        assert_eq!(level.split_counts, oracle.0[taken].0);
    }
}
