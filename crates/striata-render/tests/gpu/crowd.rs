//! Crowds refined by compute shaders have the bits that the CPU decides, show the triangles of these bits, and keep to
//! their budget.

use std::collections::HashMap;

use glam::{DMat4, DQuat, DVec3};
use striata::mesh::{IndexedMesh, Random, RefinableMesh, shapes};
use striata::model::{FanBoxes, FanInstance, Fans};
use striata::simplify::build_sequence;
use striata::view::{Camera, GridCamera, ScreenError};
use striata_render::gpu::{CrowdInstance, CrowdMesh, Gpu, GpuCrowd, GpuError};

use crate::support::gpu;

const EVERYTHING: usize = 1 << 20;

/// Meshes with their tables, and a crowd of them on the GPU.
struct CrowdTest {
    gpu: Gpu,
    parts: Vec<(Fans, FanBoxes)>,
    instances: Vec<CrowdInstance>,
    crowd: GpuCrowd,
}

fn refinable(mesh: &IndexedMesh) -> RefinableMesh {
    build_sequence(mesh, &Default::default()).unwrap().refinable
}

fn direction(random: &mut Random) -> DVec3 {
    DVec3::from([(); 3].map(|()| random.unit() - 0.5)).normalize()
}

/// Meshes of size 1 somewhere in a room of size 10, turned and scaled.
fn placed(random: &mut Random, mesh: usize, size: f64) -> CrowdInstance {
    let scale = (0.3 + 2.0 * random.unit()) / size;
    let turn = DQuat::from_axis_angle(direction(random), random.unit() * 6.0);
    let at = direction(random) * 5.0 * random.unit();
    let transform = DMat4::from_scale_rotation_translation(DVec3::splat(scale), turn, at).to_cols_array();
    CrowdInstance { mesh, transform }
}

fn criterion(random: &mut Random) -> ScreenError {
    let reach = [3.0, 8.0, 40.0, 1000.0][random.below(4) as usize];
    let eye = (direction(random) * reach).as_vec3().into();
    let target = direction(random).as_vec3().into();
    let tan = 0.1 + random.unit();
    let camera = Camera::new(eye, target, [0.1, 0.2, 0.9], tan, [1920, 1080]).unwrap();
    ScreenError::new(camera, [0.0, 0.5, 1.0, 6.0][random.below(4) as usize])
}

impl CrowdTest {
    fn new(meshes: &[IndexedMesh], instance_count: usize, random: &mut Random) -> Self {
        let gpu = gpu();
        let build = |mesh: &IndexedMesh| {
            let refinable = refinable(mesh);
            let fans = Fans::build_without_bounds(&refinable);
            let boxes = FanBoxes::new(&fans, &refinable);
            (fans, boxes)
        };
        let parts: Vec<_> = meshes.iter().map(build).collect();
        let sizes: Vec<f64> = meshes.iter().map(|mesh| mesh.bounds().unwrap().diagonal()).collect();
        let instances: Vec<CrowdInstance> = (0..instance_count)
            .map(|at| placed(random, at % meshes.len(), sizes[at % meshes.len()]))
            .collect();
        let crowd_meshes: Vec<_> = parts.iter().map(|(fans, boxes)| CrowdMesh { fans, boxes }).collect();
        let mut crowd = GpuCrowd::new(&gpu, &crowd_meshes).unwrap();
        crowd.set_instances(&gpu, &instances, EVERYTHING).unwrap();
        Self { gpu, parts, instances, crowd }
    }

    fn refine(&mut self, criterion: &ScreenError, triangle_limit: usize) {
        self.crowd.look(&self.gpu, criterion, triangle_limit).unwrap();
        let mut encoder = self.gpu.device().create_command_encoder(&Default::default());
        self.crowd.decide(&mut encoder);
        self.crowd.expand(&mut encoder);
        self.gpu.queue().submit([encoder.finish()]);
    }

    /// The instances that the CPU decides, or none where the mesh cannot be seen.
    fn expected(&self, criterion: &ScreenError, threshold: i32) -> Vec<Option<FanInstance>> {
        let decide = |shown: &CrowdInstance| {
            let (fans, boxes) = &self.parts[shown.mesh];
            let camera = GridCamera::new(criterion, &shown.transform, boxes.grid()).unwrap();
            camera.may_see(&boxes.whole()).then(|| boxes.instance(fans, &camera, threshold))
        };
        self.instances.iter().map(decide).collect()
    }

    /// Compares bits, counts and triangles with those of the CPU; returns the number of triangles.
    fn check(&self, criterion: &ScreenError) -> usize {
        let counts = self.crowd.read_counts(&self.gpu).unwrap();
        let bits = self.crowd.read_bits(&self.gpu).unwrap();
        let triangles = self.crowd.read_triangles(&self.gpu).unwrap();
        let expected = self.expected(criterion, counts.threshold);
        for (at, expected) in expected.iter().enumerate() {
            let (fans, _) = &self.parts[self.instances[at].mesh];
            let Some(expected) = expected else {
                assert!(triangles[at].is_empty() && counts.triangle_counts[at] == 0, "instance {at}");
                continue;
            };
            let found = bits[at].chunks(2).map(|word| {
                u64::from(word[0]) | u64::from(word.get(1).copied().unwrap_or(0)) << 32 //
            });
            assert_eq!(found.collect::<Vec<_>>(), expected.words(), "bits of instance {at}");
            assert!(expected.is_valid(fans));
            let mut indices = Vec::new();
            expected.indices_into(fans, &mut indices);
            let mut shown: Vec<[u32; 3]> = indices.as_chunks().0.to_vec();
            let mut found = triangles[at].clone();
            shown.sort_unstable();
            found.sort_unstable();
            assert_eq!(found, shown, "triangles of instance {at}");
            assert_eq!(counts.triangle_counts[at] as usize, shown.len(), "instance {at}");
        }
        triangles.iter().map(Vec::len).sum()
    }
}

fn meshes() -> Vec<IndexedMesh> {
    vec![
        shapes::terrain(30, 2),
        shapes::icosphere(4, 1.0),
        shapes::uv_cylinder(24, 9),
        shapes::moebius_strip(80),
        shapes::two_material_sphere(12, 18),
        shapes::random_soup(90, 4),
        shapes::tetrahedron(),
        shapes::bow_tie(),
    ]
}

#[test]
fn bits_and_triangles_equal_those_of_the_cpu() {
    let mut random = Random::new(41);
    let mut test = CrowdTest::new(&meshes(), 90, &mut random);
    let mut totals = Vec::new();
    for _ in 0..40 {
        let criterion = criterion(&mut random);
        test.refine(&criterion, EVERYTHING);
        totals.push(test.check(&criterion));
        assert_eq!(test.crowd.read_counts(&test.gpu).unwrap().threshold, 0, "everything fits");
    }
    totals.sort_unstable();
    totals.dedup();
    assert!(totals.len() > 25 && totals[0] * 4 < totals[totals.len() - 1], "{totals:?}");
}

#[test]
fn a_budget_is_kept_or_the_base_is_shown() {
    let mut random = Random::new(42);
    let mut test = CrowdTest::new(&meshes(), 60, &mut random);
    let mut relaxed = 0;
    for round in 0..40 {
        let criterion = criterion(&mut random);
        test.refine(&criterion, EVERYTHING);
        let all = test.check(&criterion);
        let base: usize = test
            .expected(&criterion, GridCamera::MOST)
            .iter()
            .zip(&test.instances)
            .filter_map(|(seen, shown)| seen.as_ref().map(|_| test.parts[shown.mesh].0.base_triangle_count()))
            .sum();
        let limit = [all / 2, all / 10, base + (all - base) / 3, 0][round % 4];
        test.refine(&criterion, limit);
        let found = test.check(&criterion);
        let threshold = test.crowd.read_counts(&test.gpu).unwrap().threshold;
        assert!(found <= limit.max(base), "{found} triangles, {limit} allowed, {base} in the base");
        if limit >= base && threshold >= 64 {
            relaxed += 1;
            // One class of weights further, they would not have fit.
            let next = test.expected(&criterion, threshold - 64);
            let mut indices = Vec::new();
            for (instance, shown) in next.iter().zip(&test.instances) {
                if let Some(instance) = instance {
                    instance.indices_into(&test.parts[shown.mesh].0, &mut indices);
                }
            }
            assert!(indices.len() / 3 > limit, "{} of {limit} at {threshold}", indices.len() / 3);
        }
    }
    assert!(relaxed > 10, "{relaxed}");
}

#[test]
fn closed_meshes_stay_closed() {
    let mut random = Random::new(43);
    let mut test =
        CrowdTest::new(&[shapes::icosphere(5, 1.0), shapes::torus(40, 20, 1.0, 0.4)], 12, &mut random);
    let mut partly = 0;
    for _ in 0..12 {
        test.refine(&criterion(&mut random), EVERYTHING);
        let triangles = test.crowd.read_triangles(&test.gpu).unwrap();
        for (shown, triangles) in test.instances.iter().zip(&triangles) {
            let mut edges: HashMap<[u32; 2], i32> = HashMap::new();
            for &[a, b, c] in triangles {
                for [from, to] in [[a, b], [b, c], [c, a]] {
                    *edges.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
                }
            }
            assert!(edges.values().all(|&balance| balance == 0), "an edge is open");
            let (fans, _) = &test.parts[shown.mesh];
            let full = *fans.triangle_counts().last().unwrap() as usize;
            partly += usize::from(triangles.len() > fans.base_triangle_count() && triangles.len() < full);
        }
    }
    assert!(partly > 40, "{partly}");
}

#[test]
fn instances_that_cannot_be_shown_are_rejected() {
    let mut random = Random::new(44);
    let mut test = CrowdTest::new(&[shapes::icosphere(1, 1.0)], 2, &mut random);
    let mut instances = test.instances.clone();
    instances[1].mesh = 7;
    let error = test.crowd.set_instances(&test.gpu, &instances, 10).unwrap_err();
    assert!(matches!(error, GpuError::NoSuchMesh { instance: 1, mesh: 7, mesh_count: 1 }), "{error}");
    instances[1].mesh = 0;
    instances[1].transform[0] *= 2.0;
    test.crowd.set_instances(&test.gpu, &instances, 10).unwrap();
    let error = test.crowd.look(&test.gpu, &criterion(&mut random), 10).unwrap_err();
    assert!(matches!(error, GpuError::Placement { instance: 1 }), "{error}");
    let error = test.crowd.set_instances(&test.gpu, &instances, usize::MAX / 8).unwrap_err();
    assert!(matches!(error, GpuError::TooLarge { .. }), "{error}");
    test.crowd.set_instances(&test.gpu, &[], 10).unwrap();
    test.refine(&criterion(&mut random), 10);
    assert!(test.crowd.read_triangles(&test.gpu).unwrap().is_empty());
}
