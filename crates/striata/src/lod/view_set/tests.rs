use super::instance::factor_at;
use super::*;
use crate::LodOptions;
use crate::mesh::{Random, shapes};
use crate::model::{FanForm, FanIndices};
use crate::view::{Criterion, Part};

const SCREEN: [u32; 2] = [800, 600];

/// Two meshes, a torus and a bumpy ball, with room for a few thousand triangles each.
fn lods() -> [Lod; 2] {
    let mut ball = shapes::icosphere(4, 1.0);
    for position in &mut ball.positions {
        let [x, y, z] = *position;
        *position =
            position.map(|p| p * (1.0 + 0.1 * (5.0 * x).sin() * (7.0 * y).cos() + 0.02 * (20.0 * z).sin()));
    }
    [shapes::torus(48, 24, 1.0, 0.4), ball].map(|mesh| Lod::build(&mesh, &LodOptions::default()).unwrap())
}

/// A grid of instances that are turned, scaled and, every ninth of them, stretched.
fn crowd(lods: &[Lod], side: usize) -> ViewSet {
    let mut set = ViewSet::new();
    for i in 0..side * side {
        let [x, z] = [i % side, i / side].map(|k| 4.0 * k as f32);
        let scale = 0.5 + (i % 5) as f32 * 0.3;
        let (sin, cos) = (i as f32).sin_cos();
        let stretch = if i % 9 == 8 { 1.6 } else { 1.0 };
        let matrix = [
            [scale * cos, 0.0, -scale * sin, 0.0],
            [0.0, scale * stretch, 0.0, 0.0],
            [scale * sin, 0.0, scale * cos, 0.0],
            [x, 0.0, z, 1.0],
        ];
        set.add(&lods[i % lods.len()], matrix).unwrap();
    }
    set
}

/// A camera that flies over the grid and turns; with a jump in the middle.
fn camera(frame: usize) -> Camera {
    let t = frame as f32 + if frame > 40 { 300.0 } else { 0.0 };
    let eye = [2.0 + 0.05 * t, 1.6, -2.0 + 0.08 * t];
    let (sin, cos) = (0.2 + 0.01 * t).sin_cos();
    Camera::new(eye, [eye[0] + sin, 1.4, eye[2] + cos], [0.0, 1.0, 0.0], 0.577, SCREEN).unwrap()
}

/// Asserts that each instance shows the triangles of its state.
fn assert_triangles(set: &ViewSet) {
    let mut expected = FanIndices::default();
    for (id, instance) in &set.instances {
        match instance.followed() {
            Some(front) => {
                front.instance().emit_into(instance.fans(), FanForm::Triangles, &mut expected);
                assert_eq!(set.indices(*id), expected.indices);
                assert_eq!(set.indices(*id).len(), 3 * front.triangle_count());
            }
            None => assert!(instance.is_base() || instance.is_level()),
        }
        let last = set.groups(*id).last().map_or(0, |range| range.end as usize);
        assert_eq!(last, set.indices(*id).len());
    }
}

/// Asserts that nothing that is left coarse has a visible error above `error`, relaxed as the instances are.
fn assert_errors(set: &ViewSet, error: &ScreenError) -> usize {
    let mut checked = 0;
    for instance in set.instances.values() {
        let Some(own) = error.in_object(&instance.matrix()) else { continue };
        let relaxed = own.relaxed(factor_at(instance.relaxation().unwrap_or(0)) * 1.0005);
        let scene = instance.scene();
        // Bounds of steps can reach farther than the mesh.
        if !relaxed.camera().may_see(&scene.sphere()) {
            continue;
        }
        let base = crate::model::FanInstance::uniform(instance.fans(), 0);
        let shown = instance.followed().map_or(&base, |front| front.instance());
        for step in (0..base.collapse_count() as u32).filter(|&step| !shown.is_refined(step)) {
            let part: Part = scene.part(step);
            assert!(!relaxed.weigh(&part).should_refine(), "step {step} is too coarse: {part:?}");
            checked += 1;
        }
    }
    checked
}

#[test]
fn instances_show_their_state_within_the_budget_and_the_tolerance() {
    let lods = lods();
    for (pixels, budget) in [(0.5, usize::MAX), (0.1, 30_000), (0.1, 12_000)] {
        let mut set = crowd(&lods, 6);
        let (mut updated, mut checked, mut most) = (0, 0, 0);
        for frame in 0..80 {
            let update = set.update(&camera(frame), pixels, budget);
            assert!(update.triangle_count <= budget && update.triangle_count == set.triangle_count());
            assert!(update.pixels >= pixels && update.pixels.is_finite());
            most = most.max(update.triangle_count);
            updated += update.updated_count;
            if frame % 8 == 0 || frame == 41 {
                assert_triangles(&set);
                checked += assert_errors(&set, &ScreenError::new(camera(frame), pixels));
            }
        }
        assert!(checked > 10_000 && updated < 36 * 80, "{checked} checked, {updated} updates");
        assert!(budget == usize::MAX || most as f64 > 0.8 * budget as f64, "{most} of {budget}");
    }
}

#[test]
fn a_budget_below_the_base_meshes_shows_them() {
    let mut set = crowd(&lods(), 4);
    let base = set.triangle_count();
    for budget in [0, base - 1] {
        let update = set.update(&camera(3), 0.1, budget);
        assert_eq!((update.triangle_count, update.pixels), (base, f32::INFINITY));
    }
    assert_eq!(set.update(&camera(3), 0.1, base).triangle_count, base);
    let update = set.update(&camera(3), 0.1, 10 * base);
    assert!(update.triangle_count > base && update.pixels.is_finite());
    assert_eq!(set.update(&camera(3), 0.1, usize::MAX).pixels, 0.1);
}

#[test]
fn an_instance_that_stays_in_place_costs_no_work() {
    for budget in [usize::MAX, 20_000] {
        let mut set = crowd(&lods(), 5);
        let first = set.update(&camera(0), 0.1, budget);
        assert!(first.updated_count > 0 && !first.changed.is_empty());
        for _ in 0..40 {
            set.update(&camera(0), 0.1, budget);
        }
        let last = set.update(&camera(0), 0.1, budget);
        assert_eq!((last.updated_count, last.changed), (0, Vec::new()));
        // A motion within the reserve costs nothing either.
        let Some(id) = set.instances.iter().find_map(|(id, i)| (i.followed().is_some()).then_some(*id))
        else {
            panic!("nothing is refined")
        };
        let matrix = set.instances[&id].matrix().map(|number| number as f32);
        let mut columns: [[f32; 4]; 4] = std::array::from_fn(|c| std::array::from_fn(|r| matrix[4 * c + r]));
        columns[3][0] += 1e-4;
        set.set_matrix(id, columns).unwrap();
        assert_eq!(set.update(&camera(0), 0.1, budget).updated_count, 0);
        columns[3][1] += 0.7;
        set.set_matrix(id, columns).unwrap();
        let moved = set.update(&camera(0), 0.1, budget);
        assert!(moved.updated_count >= 1 && moved.changed.contains(&id));
    }
}

#[cfg(feature = "parallel")]
#[test]
fn the_number_of_threads_does_not_matter() {
    let lods = lods();
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut set = crowd(&lods, 6);
            let updates: Vec<_> = (0..60).map(|frame| set.update(&camera(frame), 0.1, 15_000)).collect();
            let indices: Vec<Vec<u32>> = set.instances.keys().map(|id| set.indices(*id).to_vec()).collect();
            (updates, indices)
        })
    };
    let alone = run(1);
    assert!([2, 5].into_iter().all(|threads| run(threads) == alone));
}

#[test]
fn several_cameras_are_all_served() {
    let lods = lods();
    let mut set = crowd(&lods, 5);
    for frame in 0..20 {
        let cameras = [camera(frame), camera(60 + frame)];
        let [left, right] = cameras.map(|camera| ScreenError::new(camera, 0.3));
        set.update_by(&left.clone().or(right.clone()), 40_000);
        assert_errors(&set, &left);
        assert_errors(&set, &right);
    }
    assert_triangles(&set);
}

#[test]
fn instances_come_and_go() {
    let lods = lods();
    let mut set = crowd(&lods, 4);
    let ids: Vec<InstanceId> = set.instances.keys().copied().collect();
    set.update(&camera(0), 0.1, 10_000);
    assert_eq!((set.instance_count(), set.bases.len()), (16, 2));
    for id in &ids {
        assert!(set.remove(*id) && !set.remove(*id));
        assert!(set.indices(*id).is_empty() && set.groups(*id).is_empty());
    }
    assert_eq!((set.triangle_count(), set.bases.len(), set.bytes()), (0, 0, 0));
    let nothing = set.update(&camera(0), 0.1, 10_000);
    assert_eq!((nothing.triangle_count, nothing.updated_count, nothing.changed), (0, 0, Vec::new()));

    let identity = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [3.0, 0.0, 3.0, 1.0]];
    let id = set.add(&lods[0], identity).unwrap();
    assert!(!ids.contains(&id));
    assert_eq!(set.update(&camera(0), 0.1, 10_000).changed, [id]);
    assert!(set.indices(id).len() > lods[0].level(crate::Target::SplitCount(0)).indices().len());
    let vertex_count = lods[0].mesh().vertex_count();
    assert!(set.bytes() < 4 * vertex_count + 6000, "{} bytes for {vertex_count} vertices", set.bytes());
    // Twice as important: the same as half of the tolerance.
    let mut other = ViewSet::new();
    let twin = other.add(&lods[0], identity).unwrap();
    set.set_importance(id, 2.0).unwrap();
    set.update(&camera(0), 0.1, usize::MAX);
    other.update(&camera(0), 0.05, usize::MAX);
    assert_eq!(set.indices(id), other.indices(twin));
}

#[test]
fn matrices_that_place_nothing_are_rejected() {
    let lod = &lods()[0];
    let mut set = ViewSet::new();
    let identity = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    let id = set.add(lod, identity).unwrap();
    for (column, row, number) in [(0, 0, 0.0), (1, 1, f32::NAN), (3, 0, f32::INFINITY), (2, 3, 1.0)] {
        let mut matrix = identity;
        matrix[column][row] = number;
        assert_eq!(set.add(lod, matrix), Err(PlacementError::Matrix));
        assert_eq!(set.set_matrix(id, matrix), Err(PlacementError::Matrix));
    }
    assert!(matches!(set.set_importance(id, 0.0), Err(PlacementError::Importance { .. })));
    assert!(matches!(set.set_importance(id, f32::NAN), Err(PlacementError::Importance { .. })));
    set.remove(id);
    assert_eq!(set.set_matrix(id, identity), Err(PlacementError::Unknown));
    assert_eq!(set.set_importance(id, 1.0), Err(PlacementError::Unknown));
}

#[test]
fn empty_meshes_and_random_cameras_do_no_harm() {
    let mut lods = lods().to_vec();
    lods.push(Lod::build(&crate::mesh::IndexedMesh::default(), &LodOptions::default()).unwrap());
    let mut set = crowd(&lods, 4);
    let mut random = Random::new(8);
    for frame in 0..30 {
        let mut point = |spread: f64| [(); 3].map(|()| ((random.unit() - 0.3) * spread) as f32);
        let Ok(camera) = Camera::new(point(20.0), point(20.0), [0.0, 1.0, 0.0], 0.577, SCREEN) else {
            continue;
        };
        let pixels = [1.0, 0.0, f32::NAN, f32::INFINITY, -1.0][frame % 5];
        assert!(set.update(&camera, pixels, 20_000).triangle_count <= 20_000);
    }
    assert_triangles(&set);
}
