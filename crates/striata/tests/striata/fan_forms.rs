//! Output forms of fans: for any instance, triangles, fans and strips describe the same triangles, group
//! by group, for any number of threads.

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::canonical_triangles;
use striata::model::{FanForm, FanIndices, FanInstance, Fans, LodModel, fan_triangles_into};
use striata::strip::{RESTART, restart_triangles_into};
use support::{
    Case, Random, RandomSequenceOptions, grid, hub_cases, nasty_cases, random_refinable, seam_cases, soups,
    surface_cases, with_seams_and_groups,
};

const FORMS: [FanForm; 3] = [FanForm::Triangles, FanForm::Fans, FanForm::Strips];

/// The triangles that a GPU draws for these indices.
fn drawn(form: FanForm, indices: &[u32]) -> Vec<[u32; 3]> {
    let mut out = Vec::new();
    match form {
        FanForm::Triangles => out.extend_from_slice(indices.as_chunks().0),
        FanForm::Fans => fan_triangles_into(indices, &mut out),
        FanForm::Strips => restart_triangles_into(indices, &mut out),
    }
    canonical_triangles(&out)
}

/// Checks that every fan or strip has a triangle; returns the number of fans or strips.
fn check_runs(form: FanForm, indices: &[u32]) -> usize {
    if form == FanForm::Triangles || indices.is_empty() {
        return 0;
    }
    let runs = indices.split(|&index| index == RESTART);
    assert!(runs.clone().all(|run| run.len() >= 3), "{form:?}: a run without triangles");
    runs.count()
}

/// Checks the output in a form, each group separately and all groups together.
fn check_emitted(form: FanForm, out: &FanIndices, groups: &[Vec<[u32; 3]>]) {
    assert_eq!(out.group_ranges.len(), groups.len());
    let mut end = 0;
    for (g, (range, expected)) in out.group_ranges.iter().zip(groups).enumerate() {
        assert!(
            range.start >= end && range.end >= range.start,
            "group {g} of {form:?}: {range:?} after {end}"
        );
        end = range.end;
        let indices = &out.indices[range.start as usize..range.end as usize];
        assert_eq!(&drawn(form, indices), expected, "group {g} as {form:?}");
        check_runs(form, indices);
    }
    let all: Vec<[u32; 3]> = groups.iter().flatten().copied().collect();
    assert_eq!(drawn(form, &out.indices), canonical_triangles(&all), "all groups as {form:?}");
    assert_eq!(end as usize, out.indices.len());
}

fn check_instance(fans: &Fans, instance: &FanInstance, out: &mut FanIndices) {
    let groups: Vec<Vec<[u32; 3]>> = (0..fans.group_count())
        .map(|group| {
            let mut indices = Vec::new();
            instance.group_indices_into(fans, group, &mut indices);
            drawn(FanForm::Triangles, &indices)
        })
        .collect();
    for form in FORMS {
        instance.emit_into(fans, form, out);
        check_emitted(form, out, &groups);
        let counts = instance.draw_counts(fans, form);
        assert_eq!(counts.index_count, out.indices.len(), "{form:?}");
        assert_eq!(counts.strip_count, check_runs(form, &out.indices), "{form:?}");
        let mut appended = vec![5, 6, 7];
        match form {
            FanForm::Triangles => instance.indices_into(fans, &mut appended),
            FanForm::Fans => instance.fans_into(fans, &mut appended),
            FanForm::Strips => instance.strips_into(fans, &mut appended),
        }
        assert_eq!(appended[..3], [5, 6, 7]);
        assert_eq!(appended[3..], out.indices, "{form:?}");
        #[cfg(feature = "parallel")]
        {
            let mut parallel = FanIndices::default();
            instance.emit_parallel_into(fans, form, &mut parallel);
            assert_eq!(&parallel, out);
        }
    }
}

/// A uniform level must produce the same output as the instance with the same steps.
fn check_level(fans: &Fans, split_count: usize) {
    let mut level = fans.new_state();
    fans.move_to(&mut level, split_count);
    let instance = FanInstance::uniform(fans, split_count);
    let (mut of_level, mut of_instance) = (FanIndices::default(), FanIndices::default());
    for form in FORMS {
        fans.emit_level_into(&level, form, &mut of_level);
        instance.emit_into(fans, form, &mut of_instance);
        assert_eq!(of_level, of_instance, "{form:?} at {split_count}");
        assert_eq!(fans.level_draw_counts(&level, form), instance.draw_counts(fans, form));
        #[cfg(feature = "parallel")]
        {
            let mut parallel = FanIndices::default();
            fans.emit_level_parallel_into(&level, form, &mut parallel);
            assert_eq!(parallel, of_level);
        }
    }
}

fn check(case: &Case) {
    let fans = Fans::build(&case.refinable);
    let step_count = fans.step_count();
    let mut random = Random::new(case.seed);
    let mut out = FanIndices::default();
    let mut instance = FanInstance::full(&fans);
    check_instance(&fans, &instance, &mut out);
    for change in 0..if step_count == 0 { 0 } else { 24 } {
        let step = random.below(step_count) as u32;
        if (change / 6) % 2 == 0 {
            instance.collapse(&fans, step);
        } else {
            instance.split(&fans, step);
        }
        check_instance(&fans, &instance, &mut out);
    }
    for split_count in (0..=step_count).step_by(3 * case.stride) {
        check_level(&fans, split_count);
    }
}

#[test]
fn every_form_of_nasty_meshes_is_the_same_triangles() {
    nasty_cases().for_each(|case| check(&case));
}

#[test]
fn every_form_of_surfaces_is_the_same_triangles() {
    surface_cases().for_each(|case| check(&case));
}

#[test]
fn every_form_of_seams_and_groups_is_the_same_triangles() {
    seam_cases().for_each(|case| check(&case));
}

#[test]
fn every_form_of_a_hub_is_the_same_triangles() {
    hub_cases().for_each(|case| check(&case));
}

/// Large enough for several sections, both of the base and of the steps.
#[test]
fn parallel_sections_join_to_the_sequential_output() {
    for base_position_count in [3, 6000] {
        for has_groups in [false, true] {
            let mesh = grid(if has_groups { 80 } else { 120 }, true);
            let mesh = if has_groups { with_seams_and_groups(mesh) } else { mesh };
            let mut random = Random::new(base_position_count as u64);
            let sequence_options = RandomSequenceOptions { far_percent: 1, base_position_count };
            let refinable = random_refinable(&mesh, sequence_options, &mut random);
            let fans = Fans::build(&refinable);
            let mut out = FanIndices::default();
            for split_count in [0, fans.step_count() / 3, fans.step_count()] {
                check_level(&fans, split_count);
            }
            let instance = FanInstance::refined(&fans, |step| step % 61 == 0);
            check_instance(&fans, &instance, &mut out);
        }
    }
}

/// The center of a grid, removed last, has one closed ring, which is a single fan wherever it begins.
#[test]
fn a_whole_ring_is_one_fan() {
    let refinable = random_refinable(
        &grid(12, true),
        RandomSequenceOptions { far_percent: 0, base_position_count: 4 },
        &mut Random::new(1),
    );
    let fans = Fans::build(&refinable);
    let mut out = Vec::new();
    FanInstance::full(&fans).fans_into(&fans, &mut out);
    let rings = out.split(|&index| index == RESTART).filter(|fan| fan[1] == fan[fan.len() - 1]);
    // Vertices removed before any neighbor have their full star, none of whose triangles is created by a
    // step.
    assert!(rings.count() > 12);
    let pivots: Vec<u32> = out.split(|&index| index == RESTART).map(|fan| fan[0]).collect();
    let open_ends = out.split(|&index| index == RESTART).map(|fan| (fan[0], fan[1], fan[fan.len() - 1]));
    // No fan may begin where another one of the same pivot ends, because the two should have been one.
    for (pivot, _, last) in open_ends.clone().filter(|&(_, first, last)| first != last) {
        assert!(!open_ends.clone().any(|other| other.0 == pivot && other.1 == last), "two fans of {pivot}");
    }
    assert!(pivots.windows(2).all(|pair| pair[0] <= pair[1]));
}

#[test]
fn empty_groups_at_either_end_have_empty_ranges() {
    let mut mesh = with_seams_and_groups(grid(6, false));
    let count = mesh.triangle_count() as u32;
    for (group, (first, size)) in mesh.groups.iter_mut().zip([(0, 0), (0, count), (count, 0)]) {
        (group.first, group.count) = (first, size);
    }
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 3 };
    let fans = Fans::build(&random_refinable(&mesh, sequence_options, &mut Random::new(2)));
    let mut out = FanIndices::default();
    check_instance(&fans, &FanInstance::full(&fans), &mut out);
    FanInstance::full(&fans).emit_into(&fans, FanForm::Strips, &mut out);
    assert!(out.group_ranges[0].is_empty() && out.group_ranges[2].is_empty());
    assert_ne!(out.indices.last(), Some(&RESTART));
}

#[test]
#[should_panic(expected = "the instance belongs to a different table")]
fn an_instance_of_another_table_is_not_written() {
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 3 };
    let [small, large] = [4, 9]
        .map(|n| Fans::build(&random_refinable(&grid(n, false), sequence_options, &mut Random::new(1))));
    FanInstance::full(&large).emit_into(&small, FanForm::Fans, &mut FanIndices::default());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(128) })]

    #[test]
    fn every_form_of_random_meshes_is_the_same_triangles(case in soups()) {
        check(&case);
    }
}
