//! Progressive fans as published against the oracle, and the data of their criterion.

use striata_testing::support;

use glam::Vec3;
use striata::mesh::{RefinableMesh, canonical_triangles, shapes};
use striata::model::{Fans, LodModel};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::view::Camera;
use striata_lab::baseline::{PublishedFans, PublishedFansError, PublishedFansState, PublishedView};
use striata_lab::{Accounting, PaperBytes};
use support::{
    Random, RandomSequenceOptions, follows_the_oracle, grid, nasty_cases, random_refinable, seam_cases,
    selective_triangles, surface_cases,
};

fn check(refinable: &RefinableMesh, model: &PublishedFans, state: &PublishedFansState) {
    let mut found = Vec::new();
    state.triangles_into(model, &mut found);
    let expected = selective_triangles(refinable, &refinable.mesh.triangles, |step| !state.is_refined(step));
    assert_eq!(canonical_triangles(found.as_chunks().0), canonical_triangles(&expected));
}

#[test]
fn uniform_levels_follow_the_oracle() {
    let mut built = 0;
    for case in nasty_cases().chain(surface_cases()) {
        if let Ok(model) = PublishedFans::build(&case.refinable) {
            built += 1;
            follows_the_oracle(&case.refinable, &model, case.stride);
            let paper = Fans::build_without_bounds(&case.refinable).paper_bytes(Accounting::Words);
            assert_eq!(model.paper_bytes(Accounting::Words), paper + 16 * model.vertex_count());
        }
    }
    assert!(built > 70, "{built}");
}

#[test]
fn seams_and_large_rings_are_rejected() {
    for case in seam_cases() {
        assert!(matches!(PublishedFans::build(&case.refinable), Err(PublishedFansError::Seam { .. })));
    }
    let hub = support::hub_cases().next().unwrap();
    assert!(matches!(PublishedFans::build(&hub.refinable), Err(PublishedFansError::Ring { .. })));
}

/// On closed surfaces that do not collapse to a few triangles, the published dependencies are enough: each floor leaves
/// a triangle at each vertex around it.
#[test]
fn any_insertions_and_simplifications_follow_the_oracle() {
    let options = RandomSequenceOptions { far_percent: 0, base_position_count: 40 };
    let torus = random_refinable(&grid(9, true), options, &mut Random::new(4));
    let spheres = [shapes::icosphere(2, 1.0), shapes::torus(12, 8, 1.0, 0.4)]
        .map(|mesh| build_sequence(&mesh, &options_with_base(60)).unwrap().refinable);
    for refinable in spheres.iter().chain([&torus]) {
        let model = PublishedFans::build(refinable).unwrap();
        let mut random = Random::new(7);
        let mut state = model.new_state();
        for round in 0..300 {
            let step = random.below(model.step_count()) as u32;
            let before = state.split_count();
            if random.below(100) < [70, 30][round / 20 % 2] {
                let count = state.simplify(&model, step);
                assert!(!state.is_refined(step) && state.split_count() + count == before);
            } else {
                let count = state.insert(&model, step);
                assert!(state.is_refined(step) && state.split_count() == before + count);
            }
            check(refinable, &model, &state);
        }
    }
}

fn options_with_base(triangle_count: usize) -> SequenceOptions {
    SequenceOptions::default().with_base_triangle_count(triangle_count)
}

#[test]
fn views_are_refined_where_they_need_it() {
    let sphere = shapes::icosphere(4, 1.0);
    let refinable = build_sequence(&sphere, &options_with_base(60)).unwrap().refinable;
    let model = PublishedFans::build(&refinable).unwrap();
    let mut state = PublishedFansState::base(&model);
    let (mut counts, mut evaluated, mut small) = (Vec::new(), 0, 0);
    for (eye, pixels) in [([0.0, 0.0, 3.0], 1.0), ([0.0, 0.0, 3.0], 8.0), ([0.0, 3.0, 0.5], 1.0)] {
        let camera = Camera::new(eye, [0.0; 3], [0.1, 1.0, 0.2], 0.5, [1000, 1000]).unwrap();
        let view = PublishedView::new(&camera, 1000.0, pixels);
        let changes = model.adapt(&mut state, &view);
        evaluated += changes.evaluated;
        check(&refinable, &model, &state);
        for step in 0..model.step_count() as u32 {
            let vertex = refinable.sequence.base_vertex_count() + step as usize;
            let away = Vec3::from(refinable.mesh.positions[vertex]).dot(Vec3::from(eye)) < -1.5;
            // The bounds of coarse steps reach around the sphere.
            let is_small = model.criterion(step).radius < 0.2 && model.criterion(step).cone_cos > 0.9;
            small += usize::from(is_small && away);
            assert!(!away || !is_small || !model.needs(step, &view), "step {step} is on the far side");
        }
        counts.push(state.split_count());
    }
    assert!(counts[0] > 3 * counts[1] && counts[2] > 3 * counts[1], "{counts:?}");
    assert!(evaluated > 1000 && small > 300, "{evaluated} evaluated, {small} on the far side");
}

/// The normals of the full mesh below a vertex are in its cone, its neighbors in its sphere.
#[test]
fn spheres_and_cones_enclose_what_is_below() {
    let refinable = build_sequence(&shapes::terrain(16, 3), &Default::default()).unwrap().refinable;
    let model = PublishedFans::build(&refinable).unwrap();
    let base = refinable.sequence.base_vertex_count();
    for triangle in &refinable.mesh.triangles {
        for &v in triangle.iter().filter(|&&v| v as usize >= base) {
            let radius = model.criterion(v - base as u32).radius;
            let center = Vec3::from(refinable.mesh.positions[v as usize]);
            for &other in triangle {
                let corner = Vec3::from(refinable.mesh.positions[other as usize]);
                assert!(center.distance(corner) <= radius);
            }
        }
    }
    let steps = 0..model.step_count() as u32;
    assert!(steps.clone().any(|step| model.criterion(step).cone_cos > 0.7));
    let flat = steps.filter(|&step| model.criterion(step).dist > 3.0 * model.criterion(step).surface).count();
    assert!(flat > model.step_count() / 2, "errors of a terrain are along its normals: {flat}");
}
