use std::ops::ControlFlow;

use super::*;
use crate::Progress;
use crate::file::WriteOptions;
use crate::mesh::{canonical_triangles, replay, shapes};
use crate::model::LodModel as _;
use crate::strip::restart_triangles_into;
use crate::view::Camera;

fn meshes() -> [IndexedMesh; 4] {
    [
        shapes::icosphere(3, 1.0),
        shapes::terrain(20, 3),
        shapes::two_material_sphere(12, 16),
        IndexedMesh { positions: Vec::new(), ..shapes::tetrahedron() },
    ]
}

fn consistent_meshes() -> impl Iterator<Item = IndexedMesh> {
    meshes().into_iter().filter(|mesh| mesh.check().is_ok())
}

#[test]
fn levels_match_the_replay_oracle() {
    for mesh in consistent_meshes() {
        let lod = Lod::build(&mesh, &LodOptions::default()).unwrap();
        let refinable = lod.tables.refinable();
        for split_count in 0..=lod.step_count() {
            let level = lod.level(Target::SplitCount(split_count));
            let expected = replay(refinable, split_count);
            assert_eq!(canonical_triangles(level.triangles()), canonical_triangles(&expected.triangles));
            assert_eq!(level.split_count(), split_count);
            assert!(level.indices().iter().all(|&index| (index as usize) < level.vertex_count()));
            let mut strip_triangles = Vec::new();
            let strips = level.strips();
            for range in &strips.group_ranges {
                let range = range.start as usize..range.end as usize;
                restart_triangles_into(&strips.indices[range], &mut strip_triangles);
            }
            assert_eq!(canonical_triangles(&strip_triangles), canonical_triangles(&expected.triangles));
            let grouped_index_count: usize = level.groups().iter().map(|range| range.len()).sum();
            assert_eq!(grouped_index_count, level.indices().len());
        }
    }
}

#[test]
fn a_moved_level_equals_a_new_one() {
    let lod = Lod::build(&shapes::terrain(20, 3), &LodOptions::default()).unwrap();
    let mut level = lod.level(Target::Detail(1.0));
    for triangles in [100, 700, 3, 100_000] {
        level.move_to(Target::Triangles(triangles));
        let fresh = lod.level(Target::Triangles(triangles));
        assert_eq!(level.indices(), fresh.indices());
        assert_eq!((level.error(), level.stop_reason()), (fresh.error(), fresh.stop_reason()));
    }
}

#[test]
fn strips_follow_levels_by_changes() {
    for mesh in consistent_meshes() {
        let lod = Lod::build(&mesh, &LodOptions::default()).unwrap();
        let mut level = lod.strip_level(Target::Detail(1.0)).unwrap();
        let mut uploaded = level.indices().to_vec();
        level.take_changed_ranges();
        let steps = lod.step_count();
        for split_count in (0..=steps).rev().chain([steps, steps / 2, steps / 3, 2 * steps / 3]) {
            level.move_to(Target::SplitCount(split_count));
            for range in level.take_changed_ranges() {
                let range = range.start as usize..range.end as usize;
                uploaded[range.clone()].copy_from_slice(&level.indices()[range]);
            }
            let mut triangles = Vec::new();
            for range in level.groups() {
                restart_triangles_into(&uploaded[range.start as usize..range.end as usize], &mut triangles);
            }
            let expected = replay(lod.tables.refinable(), split_count);
            assert_eq!(canonical_triangles(&triangles), canonical_triangles(&expected.triangles));
            let counts = (level.triangle_count(), level.split_count(), level.vertex_count());
            assert_eq!(counts, (triangles.len(), split_count, lod.sequence().vertex_count_at(split_count)));
            assert_eq!(level.error(), lod.level(Target::SplitCount(split_count)).error());
        }
    }
}

#[test]
fn models_are_shared_stored_and_taken_over() {
    let lod = Lod::build(&shapes::terrain(20, 3), &LodOptions::default()).unwrap();
    let strips: *const _ = lod.clone().strips().unwrap();
    assert!(std::ptr::eq(strips, lod.strips().unwrap()), "clones share models");
    let (mut mts, mut patterns) = (lod.mts().unwrap().new_state(), lod.patterns().unwrap().new_state());
    let half = lod.step_count() / 2;
    lod.mts().unwrap().move_to(&mut mts, half);
    lod.patterns().unwrap().move_to(&mut patterns, half);
    let expected = canonical_triangles(&replay(lod.tables.refinable(), half).triangles);
    let mut shown = [Vec::new(), Vec::new()];
    lod.mts().unwrap().triangles_into(&mts, &mut shown[0]);
    lod.patterns().unwrap().triangles_into(&patterns, &mut shown[1]);
    assert!(shown.iter().all(|triangles| canonical_triangles(triangles) == expected));

    let bytes = lod.to_striata(&WriteOptions::default()).unwrap();
    let file = StriataFile::parse(&bytes).unwrap();
    let stored = file.lod_strips().expect("strips that were used").unwrap().into_owned();
    assert!(file.mts().is_some() && file.patterns().is_some());
    let opened = Lod::from_file(&file).unwrap().with_strips(stored.clone()).unwrap();
    assert_eq!(opened.strips().unwrap(), lod.strips().unwrap());

    let other = Lod::build(&shapes::terrain(20, 4), &LodOptions::default()).unwrap();
    assert!(matches!(other.with_strips(stored), Err(ModelError::Record { .. } | ModelError::Length { .. })));
}

#[test]
fn views_refine_as_the_camera_approaches() {
    let lod = Lod::build(&shapes::terrain(40, 3), &LodOptions::default()).unwrap();
    let center = lod.mesh().bounds().unwrap().min;
    let mut view = lod.view();
    assert_eq!(view.triangle_count(), lod.level(Target::SplitCount(0)).triangle_count());
    let camera = |distance: f32| {
        Camera::new([center[0], center[1], center[2] + distance], center, [0.0, 1.0, 0.0], 0.577, [800, 600])
    };
    let diagonal = lod.mesh().diagonal() as f32;
    view.update(&camera(100.0 * diagonal).unwrap(), 1.0);
    let far = view.triangle_count();
    view.update(&camera(0.5 * diagonal).unwrap(), 1.0);
    assert!(view.triangle_count() > 2 * far, "{} against {far}", view.triangle_count());
    assert_eq!(view.indices().len(), 3 * view.triangle_count());
    view.update_to_budget(&camera(0.5 * diagonal).unwrap(), 1.0, 200);
    assert!(view.triangle_count() <= 200);
    assert_eq!(view.indices().len(), 3 * view.triangle_count());
}

#[test]
fn files_round_trip() {
    for (mesh, is_guaranteed) in consistent_meshes().zip([false, true, false]) {
        let options = LodOptions::default().with_guaranteed_errors(is_guaranteed);
        let lod = Lod::build(&mesh, &options).unwrap();
        let bytes = lod.to_striata(&WriteOptions::default()).unwrap();
        let read = Lod::from_file(&StriataFile::parse(&bytes).unwrap()).unwrap();
        assert_eq!(read.has_guaranteed_errors(), is_guaranteed);
        assert_eq!(read.positions(), lod.positions());
        assert_eq!(canonical_triangles(&read.mesh().triangles), canonical_triangles(&lod.mesh().triangles));
        let target = Target::Detail(0.5);
        assert_eq!(read.level(target).indices(), lod.level(target).indices());
        assert_eq!(read.level(target).error(), lod.level(target).error());
    }
}

#[test]
fn inconsistent_meshes_are_rejected() {
    let broken = meshes().into_iter().find(|mesh| mesh.check().is_err()).unwrap();
    assert!(matches!(Lod::build(&broken, &LodOptions::default()), Err(SimplifyError::Mesh(_))));
}

#[test]
fn meshes_of_levels_need_no_fans() {
    let lod = Lod::build(&shapes::terrain(20, 1), &LodOptions::default()).unwrap();
    for target in [Target::Triangles(0), Target::Triangles(300), Target::Detail(0.5), Target::Error(0.0)] {
        let mesh = lod.level_mesh(target);
        let level = lod.level(target);
        assert_eq!((&mesh, mesh.triangle_count()), (&level.to_mesh(), level.triangle_count()), "{target:?}");
    }
}

#[test]
fn the_callback_can_cancel() {
    let mesh = shapes::terrain(100, 1);
    let cancelled = Lod::build_with_progress(&mesh, &LodOptions::default(), &mut |_| ControlFlow::Break(()));
    assert!(matches!(cancelled, Err(SimplifyError::Cancelled(_))), "{cancelled:?}");
}

#[test]
fn the_fans_report_progress_and_can_be_cancelled() {
    let refinable = Lod::build(&shapes::terrain(100, 1), &LodOptions::default()).unwrap();
    let refinable = RefinableMesh { mesh: refinable.mesh().clone(), sequence: refinable.sequence().clone() };
    let mut phases = Vec::new();
    let lod = Lod::from_certified(refinable.clone());
    let mut report = |now: Progress| {
        assert!(now.done <= now.total, "{now:?}");
        phases.push(now.phase);
        ControlFlow::Continue(())
    };
    lod.prepare_with_progress(&mut report).unwrap();
    assert!(lod.has_guaranteed_errors());
    lod.clone().prepare_with_progress(&mut |_| panic!("clones share their models")).unwrap();
    assert!(phases.is_sorted_by_key(|&phase| phase != "fans"), "{phases:?}");
    for last in 1..=phases.len() {
        let mut calls = 0;
        let lod = Lod::from_refinable(refinable.clone());
        let stopped = lod.prepare_with_progress(&mut |_| {
            calls += 1;
            if calls < last { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        assert_eq!((stopped, calls), (Err(Cancelled), last));
        assert!(lod.level(Target::Triangles(100)).triangle_count() <= 100, "the next call builds them");
    }
}

#[test]
fn sizes_of_levels_are_known_without_their_triangles() {
    for mesh in consistent_meshes() {
        let lod = Lod::build(&mesh, &LodOptions::default()).unwrap();
        for target in [Target::Triangles(50), Target::Vertices(40), Target::Detail(0.3), Target::Error(0.1)] {
            let (sizes, level) = (lod.resolve(target), lod.level(target));
            assert_eq!(sizes.split_count, level.split_count());
            assert_eq!(
                (sizes.vertex_count, sizes.triangle_count),
                (level.vertex_count(), level.triangle_count())
            );
            assert_eq!((sizes.error, sizes.stop_reason), (level.error(), level.stop_reason()));
        }
    }
}

#[test]
fn vertices_of_the_input_are_known_unless_the_levels_come_from_a_file() {
    for (mesh, is_guaranteed) in consistent_meshes().zip([false, true, false]) {
        let options = LodOptions::default().with_guaranteed_errors(is_guaranteed);
        let lod = Lod::build(&mesh, &options).unwrap();
        let sources = lod.source_vertices();
        let permuted: Vec<_> = sources.iter().map(|&v| mesh.positions[v as usize]).collect();
        assert_eq!(permuted, lod.positions());
        assert_eq!(lod.without_levels_below(3).source_vertices(), sources);
        let bytes = lod.to_striata(&WriteOptions::default()).unwrap();
        assert!(Lod::from_file(&StriataFile::parse(&bytes).unwrap()).unwrap().source_vertices().is_empty());
    }
}

#[test]
fn ranges_are_the_levels_of_each_group() {
    for mesh in consistent_meshes() {
        let lod = Lod::build(&mesh, &LodOptions::default()).unwrap();
        let splits = lod.sequence().halving_split_counts();
        assert_eq!((splits[0], splits[splits.len() - 1]), (lod.step_count(), 0));
        let group_count = mesh.groups_or_whole().len();
        for group in (0..group_count).map(Some).chain([None]) {
            let made = lod.ranges(&splits, group);
            for (&split_count, range) in splits.iter().zip(&made.ranges) {
                let level = lod.level(Target::SplitCount(split_count));
                let expected = match group {
                    Some(group) => level.groups()[group].start as usize..level.groups()[group].end as usize,
                    None => 0..level.indices().len(),
                };
                let found = &made.indices[range.first_index..][..range.index_count];
                let [found, expected] = [found, &level.indices()[expected]]
                    .map(|indices| canonical_triangles(indices.as_chunks().0));
                assert_eq!(found, expected);
                assert_eq!((range.vertex_count, range.error), (level.vertex_count(), level.error()));
            }
        }
    }
}

#[test]
fn uniform_levels_for_a_camera_keep_the_error_on_the_screen() {
    let lod = Lod::build(&shapes::icosphere(4, 1.0), &LodOptions::default()).unwrap();
    let camera = |eye: f32, target: f32| {
        Camera::new([0.0, 0.0, eye], [0.0, 0.0, target], [0.0, 1.0, 0.0], 0.5, [800, 800]).unwrap()
    };
    let triangles = |camera: &Camera, pixels| lod.resolve(lod.target_for_view(camera, pixels)).triangle_count;
    let counts = [2.0, 5.0, 20.0, 100.0].map(|eye| triangles(&camera(eye, 0.0), 1.0));
    assert!(counts.is_sorted_by(|a, b| a > b), "{counts:?}");
    let full = lod.mesh().triangle_count();
    assert_eq!([0.0, -1.0, f32::NAN].map(|pixels| triangles(&camera(5.0, 0.0), pixels)), [full; 3]);
    assert_eq!(triangles(&camera(0.5, 0.0), 1.0), full, "a camera inside");
    let off = camera(5.0, 9.0);
    assert_eq!(lod.target_for_view(&off, 1.0), Target::SplitCount(0));
    let level = lod.resolve(lod.target_for_view(&camera(5.0, 0.0), 1.0));
    // 800 pixels for a tangent of 0.5, and nothing is nearer than 4.
    assert!(level.error * 800.0 / 4.0 <= 1.0 && level.triangle_count < full);
}
