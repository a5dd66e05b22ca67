//! Refinement without history keeps the error on the screen, and costs few triangles.

use striata::mesh::{IndexedMesh, Random, RefinableMesh, TriangleTree, shapes};
use striata::model::{FanBoxes, FanInstance, FanScene, Fans, LodModel};
use striata::simplify::{build_sequence, certify_collapses_in_any_state};
use striata::view::{Camera, GridCamera, ScreenError, Sphere};

const PLACED: [f64; 16] = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
const SIZE: [u32; 2] = [1000, 800];

fn certified(mesh: &IndexedMesh) -> RefinableMesh {
    certify_collapses_in_any_state(&build_sequence(mesh, &Default::default()).unwrap().refinable)
}

fn camera(random: &mut Random) -> Camera {
    let distance = [1.4, 2.0, 6.0][random.below(3) as usize];
    let eye = loop {
        let eye = [(); 3].map(|()| random.between(-1.0, 1.0));
        let length = eye.iter().map(|x| x * x).sum::<f32>().sqrt();
        if length > 0.1 && length < 1.0 {
            break eye.map(|x| x * distance / length);
        }
    };
    let target = [(); 3].map(|()| random.between(-0.4, 0.4));
    Camera::new(eye, target, [0.1, 0.3, 0.8], 0.6, SIZE).unwrap()
}

/// The largest error in pixels of the vertices that the camera sees.
fn largest_error(mesh: &IndexedMesh, shown: &[[u32; 3]], camera: &Camera) -> f64 {
    let level = IndexedMesh::new(mesh.positions.clone(), shown.to_vec());
    let tree = TriangleTree::new(&level).unwrap();
    let eye = camera.eye();
    let mut is_seen = vec![false; mesh.vertex_count()];
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| mesh.positions[v as usize]);
        let minus = |p: [f32; 3], q: [f32; 3]| [0, 1, 2].map(|i| p[i] - q[i]);
        let [u, v, w] = [minus(b, a), minus(c, a), minus(eye, a)];
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        if normal.iter().zip(w).map(|(n, w)| n * w).sum::<f32>() > 0.0 {
            triangle.iter().for_each(|&v| is_seen[v as usize] = true);
        }
    }
    let mut largest = 0.0f64;
    for (&position, _) in mesh.positions.iter().zip(&is_seen).filter(|(_, is_seen)| **is_seen) {
        let point = Sphere::point(position);
        if camera.may_see(&point) {
            let distance = tree.distance_to(position.map(f64::from));
            largest = largest.max(f64::from(camera.error_px(distance as f32, &point)));
        }
    }
    largest
}

#[test]
fn certified_errors_hold_on_the_screen() {
    let mut random = Random::new(51);
    let mut mixed = 0;
    for mesh in [shapes::icosphere(5, 1.0), shapes::torus(48, 24, 0.7, 0.3)] {
        let refinable = certified(&mesh);
        let fans = Fans::build_without_bounds(&refinable);
        let boxes = FanBoxes::new(&fans, &refinable);
        for _ in 0..12 {
            let (camera, pixels) = (camera(&mut random), [0.5f32, 2.0, 6.0][random.below(3) as usize]);
            let criterion = ScreenError::new(camera, pixels);
            let instance =
                boxes.instance(&fans, &GridCamera::new(&criterion, &PLACED, boxes.grid()).unwrap(), 0);
            assert!(instance.is_valid(&fans));
            let mut indices = Vec::new();
            instance.indices_into(&fans, &mut indices);
            let error = largest_error(&refinable.mesh, indices.as_chunks().0, &camera);
            assert!(error <= f64::from(pixels) * 1.001, "{error} px, {pixels} allowed");
            mixed += usize::from(instance.collapse_count() > 0 && error > 0.0);
        }
    }
    assert!(mixed > 12, "{mixed}");
}

#[test]
fn boxes_cost_few_triangles() {
    let mut random = Random::new(52);
    let refinable = certified(&shapes::terrain(90, 3));
    let (fans, positions) = (Fans::build(&refinable), &refinable.mesh.positions);
    let boxes = FanBoxes::new(&fans, &refinable);
    let scene = FanScene::new(&fans, positions);
    let middle = scene.sphere();
    let (mut stateless, mut followed) = (0, 0);
    for _ in 0..20 {
        let offset = [(); 3].map(|()| random.between(-1.0, 1.0) * middle.radius);
        let eye = [0, 1, 2].map(|i| middle.center[i] + offset[i] * 2.0);
        let camera = Camera::new(eye, middle.center, [0.0, 0.1, 1.0], 0.5, SIZE).unwrap();
        let criterion = ScreenError::new(camera, 2.0);
        let grid_camera = GridCamera::new(&criterion, &PLACED, boxes.grid()).unwrap();
        let mut by_view = FanInstance::full(&fans);
        by_view.refine(&scene, &criterion);
        for (instance, total) in
            [(boxes.instance(&fans, &grid_camera, 0), &mut stateless), (by_view, &mut followed)]
        {
            let mut indices = Vec::new();
            instance.indices_into(&fans, &mut indices);
            *total += indices.len() / 3;
        }
    }
    let ratio = f64::from(stateless as u32) / f64::from(followed as u32);
    assert!((0.7..1.25).contains(&ratio), "{ratio} of the triangles of a view");
    assert!(fans.step_count() > 0 && boxes.bytes() <= 26 * fans.step_count());
}
