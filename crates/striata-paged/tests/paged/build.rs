//! Files built in tasks: the same bytes whoever runs the tasks.

use striata::ignore_progress;
use striata::mesh::replay;
use striata_paged::build::{
    BuildInput, BuildOptions, Limit, PagedBuildError, PagedPlan, SimulationOptions, run_all, run_task,
};
use tempfile::TempDir;

use crate::workshop::{build, check_levels, full, open, options, plan};

#[test]
fn terrain_is_the_same_with_any_number_of_threads_and_in_any_order() {
    let folder = TempDir::new().unwrap();
    let input = BuildInput::Terrain(150);
    let bytes =
        [1, 2, 5].map(|threads| std::fs::read(build(&folder, input.clone(), options(), threads)).unwrap());
    assert!(bytes[0] == bytes[1] && bytes[0] == bytes[2]);
    // One task at a time, from the last of each stage to the first, and every third one twice.
    let plan = plan(&folder, input, options(), "tasks.striata");
    for stage in plan.stages() {
        for number in stage.tasks().rev() {
            run_task(&PagedPlan::open(&plan.folder).unwrap(), number).unwrap();
            if number % 3 == 0 {
                run_task(&plan, number).unwrap();
            }
        }
    }
    assert!(std::fs::read(&plan.output).unwrap() == bytes[0]);
}

#[test]
fn tasks_that_are_not_ready_and_unknown_tasks_are_refused() {
    let folder = TempDir::new().unwrap();
    let plan = plan(&folder, BuildInput::Terrain(120), options(), "a.striata");
    let last = plan.tasks.len() - 1;
    assert!(matches!(run_task(&plan, last), Err(PagedBuildError::TaskOrder { needed: 0, .. })));
    assert!(matches!(run_task(&plan, last + 1), Err(PagedBuildError::NoTask { .. })));
    assert!(!plan.output.exists());
}

#[test]
fn an_interrupted_build_goes_on() {
    let folder = TempDir::new().unwrap();
    let whole = std::fs::read(build(&folder, BuildInput::Terrain(150), options(), 1)).unwrap();
    let plan = plan(&folder, BuildInput::Terrain(150), options(), "b.striata");
    for stop_after in [1, 3, 9] {
        let mut count = 0;
        let result = run_all(&plan, 1, &mut |_| {
            count += 1;
            if count == stop_after {
                std::ops::ControlFlow::Break(())
            } else {
                std::ops::ControlFlow::Continue(())
            }
        });
        assert!(matches!(result, Err(PagedBuildError::Cancelled(_))));
        assert!(!plan.output.exists());
    }
    run_all(&PagedPlan::open(&plan.folder).unwrap(), 2, &mut ignore_progress).unwrap();
    assert!(std::fs::read(&plan.output).unwrap() == whole);
}

#[test]
fn a_damaged_part_is_named() {
    let folder = TempDir::new().unwrap();
    let plan = plan(&folder, BuildInput::Terrain(120), options(), "c.striata");
    run_task(&plan, 0).unwrap();
    let part = std::fs::read_dir(&plan.folder).unwrap().flatten().map(|file| file.path());
    let part = part.filter(|path| path.extension().is_some_and(|e| e == "part")).min().unwrap();
    let bytes = std::fs::read(&part).unwrap();
    std::fs::write(&part, &bytes[..bytes.len() - 1]).unwrap();
    let error = run_all(&plan, 1, &mut ignore_progress).unwrap_err();
    assert!(error.to_string().contains(&part.display().to_string()), "{error}");
}

#[test]
fn folders_have_one_object_per_page() {
    let folder = TempDir::new().unwrap();
    let one = build(&folder, BuildInput::Terrain(120), options(), 1);
    let plan = plan(&folder, BuildInput::Terrain(120), options(), "folder");
    run_all(&plan, 1, &mut ignore_progress).unwrap();
    assert!(plan.output.join("head.striata").is_file());
    let (mut one, mut many) = (open(&one), open(&plan.output));
    assert_eq!(full(&mut one).refinable, full(&mut many).refinable);
}

#[test]
fn plans_are_simulated() {
    let folder = TempDir::new().unwrap();
    let plan = plan(&folder, BuildInput::Terrain(150), options(), "s.striata");
    let run = |workers: usize, failing_share: f64| {
        plan.simulate(&SimulationOptions { failing_share, ..SimulationOptions::new(workers) })
    };
    let one = run(1, 0.0);
    assert_eq!(one.attempts, plan.tasks.len());
    assert!((one.seconds - one.core_seconds).abs() < 1e-9 * one.seconds, "one worker never waits");
    let many = run(8, 0.0);
    assert!(many.seconds < 0.5 * one.seconds && many.seconds >= one.seconds / 8.0);
    assert!((many.core_seconds - one.core_seconds).abs() < 1e-9 * one.core_seconds);
    // No stage is shorter than its longest task, however many workers there are.
    assert!(run(1000, 0.0).seconds > 0.0);
    let failing = run(8, 0.3);
    assert!(failing.attempts > plan.tasks.len() && failing.core_seconds > many.core_seconds);
    assert_eq!(failing, run(8, 0.3), "the same seed gives the same failures");
    assert_eq!(failing.work_bytes, many.work_bytes);
    assert_eq!(many.stages.len(), plan.stages().len());
    assert!(many.stages.iter().all(|stage| stage.busy_share > 0.0 && stage.busy_share <= 1.0 + 1e-9));
}

/// Numbers of triangles of the coarsest level and of all levels of cells, with options for a terrain of
/// 44,402 triangles.
fn base_of(options: BuildOptions) -> (usize, usize) {
    let folder = TempDir::new().unwrap();
    let mut file = open(&build(&folder, BuildInput::Terrain(150), options, 2));
    let all = full(&mut file);
    check_levels(&all);
    (all.refinable.sequence.triangle_count_at(0), file.metadata().cell_counts.len())
}

#[test]
fn the_coarsest_level_has_as_many_triangles_as_asked_for() {
    let with_base = |base| BuildOptions { base: Some(base), ..options() };
    let (_, all_levels) = base_of(options());
    for (base, most) in [
        (Limit::Absolute(200.0), 200),
        (Limit::Absolute(3000.0), 3000),
        (Limit::Share(0.05), 2220),
        (Limit::Share(0.4), 17_760),
    ] {
        let (count, levels) = base_of(with_base(base));
        assert!((most - 2..=most).contains(&count), "{base:?}: {count}");
        assert!(levels <= all_levels);
    }
    assert_eq!(base_of(with_base(Limit::Share(1.0))).0, 2 * 149 * 149);
    assert_eq!(base_of(with_base(Limit::Absolute(0.0))), base_of(options()));
}

#[test]
fn a_base_that_cannot_be_reached_is_an_error_if_it_must_be() {
    let folder = TempDir::new().unwrap();
    let strict =
        BuildOptions { base: Some(Limit::Absolute(500.0)), strict: true, lock_boundary: true, ..options() };
    let strict = plan(&folder, BuildInput::Terrain(150), strict, "strict.striata");
    let error = run_all(&strict, 1, &mut ignore_progress).unwrap_err();
    assert!(matches!(error, PagedBuildError::Base { triangles: 594.., limit: 500 }), "{error}");
    assert!(!strict.output.exists());
}

#[test]
fn no_level_has_a_larger_error_than_allowed() {
    let folder = TempDir::new().unwrap();
    let mut unlimited = open(&build(&folder, BuildInput::Terrain(150), options(), 1));
    let largest = full(&mut unlimited).refinable.sequence.error_at(0);
    let diagonal = unlimited.metadata().diagonal();
    for share in [0.5, 0.1, 0.02] {
        let most = share * f64::from(largest);
        let [a, b] = [Limit::Absolute(most), Limit::Share(most / diagonal)].map(|limit| {
            let options = BuildOptions { max_error: Some(limit), ..options() };
            let mut file = open(&build(&folder, BuildInput::Terrain(150), options, 2));
            let all = full(&mut file);
            check_levels(&all);
            let sequence = &all.refinable.sequence;
            assert!(f64::from(sequence.error_at(0)) <= most, "{limit:?}: {}", sequence.error_at(0));
            sequence.triangle_count_at(0)
        });
        assert!(a.abs_diff(b) <= a / 20, "{a} {b}");
        let whole = full(&mut unlimited).refinable.sequence;
        let at = whole.split_count_for_error(most);
        assert!(a <= whole.triangle_count_at(at), "{a} of {}", whole.triangle_count_at(at));
    }
    let none = BuildOptions { max_error: Some(Limit::Absolute(0.0)), ..options() };
    assert!(base_of(none).0 > 40_000);
}

#[test]
fn levels_of_terrain_are_height_fields() {
    let folder = TempDir::new().unwrap();
    let mut file = open(&build(&folder, BuildInput::Terrain(150), options(), 1));
    let all = full(&mut file);
    let steps = all.refinable.sequence.step_count();
    for split_count in [0, steps / 100, steps / 30, steps / 10, steps / 3, steps] {
        let level = replay(&all.refinable, split_count);
        let area = |t: &&[u32; 3]| {
            let [a, b, c] = t.map(|v| level.positions[v as usize].map(f64::from));
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        assert_eq!(level.triangles.iter().filter(|t| area(t) <= 0.0).count(), 0, "{split_count}");
    }
}
