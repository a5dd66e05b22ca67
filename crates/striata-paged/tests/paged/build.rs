//! Files built in tasks: the same bytes whoever runs the tasks.

use striata::ignore_progress;
use striata_paged::build::{BuildError, BuildInput, Plan, SimulationOptions, run_all, run_task};
use tempfile::TempDir;

use crate::workshop::{build, full, open, options, plan};

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
            run_task(&Plan::open(&plan.folder).unwrap(), number).unwrap();
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
    assert!(matches!(run_task(&plan, last), Err(BuildError::TaskOrder { needed: 0, .. })));
    assert!(matches!(run_task(&plan, last + 1), Err(BuildError::NoTask { .. })));
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
        assert!(matches!(result, Err(BuildError::Cancelled(_))));
        assert!(!plan.output.exists());
    }
    run_all(&Plan::open(&plan.folder).unwrap(), 2, &mut ignore_progress).unwrap();
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
