//! Fans extracted in compute shaders equal those extracted on the CPU, index by index, and give the same
//! picture.

use crate::support::{differing_pixels, drawn_pixels, gpu};
use bytemuck::cast_slice;
use proptest::prelude::*;
use striata::mesh::{
    CollapseSequence, IndexedMesh, PositionIndex, Random, RefinableMesh, SequenceParts, shapes,
};
use striata::model::fans::MAX_ARCS;
use striata::model::{FanForm, FanIndices, FanInstance, FanScene, Fans, LodModel};
use striata::simplify::build_sequence;
use striata::view::{Camera, ScreenError};
use striata_render::gpu::{
    Canvas, Drawing, FanExtractor, Gpu, GpuFanInstance, GpuFans, GpuIndices, GpuVertices, Look, Painter,
};
use striata_testing::meshes;

/// Table on the CPU and the GPU, and one instance that is rewritten again and again.
struct ExtractionTest<'a> {
    gpu: &'a Gpu,
    extractor: &'a FanExtractor,
    fans: Fans,
    instance: GpuFanInstance,
}

impl<'a> ExtractionTest<'a> {
    fn new(gpu: &'a Gpu, extractor: &'a FanExtractor, refinable: &RefinableMesh) -> Self {
        let fans = Fans::build(refinable);
        let table = GpuFans::upload(gpu, &fans).unwrap();
        let instance = GpuFanInstance::new(gpu, extractor, &table).unwrap();
        Self { gpu, extractor, fans, instance }
    }

    fn extract(&mut self, expected_instance: &FanInstance) {
        self.instance.write(self.gpu, expected_instance);
        let mut encoder = self.gpu.device().create_command_encoder(&Default::default());
        self.extractor.extract(&mut encoder, &self.instance);
        self.gpu.queue().submit([encoder.finish()]);
    }

    fn check(&mut self, expected_instance: &FanInstance, what: &str) {
        self.extract(expected_instance);
        let found = self.instance.read(self.gpu).unwrap();
        let mut expected = FanIndices::default();
        expected_instance.emit_into(&self.fans, FanForm::Triangles, &mut expected);
        assert_eq!(found, expected, "{what}, {} steps collapsed", expected_instance.collapse_count());
    }

    fn check_levels(&mut self, count: usize, what: &str) {
        let step_count = self.fans.step_count();
        for part in (0..=count).rev() {
            let level = FanInstance::uniform(&self.fans, step_count * part / count);
            self.check(&level, what);
        }
    }

    fn check_random_sets(&mut self, count: usize, random: &mut Random, what: &str) {
        let step_count = self.fans.step_count() as u32;
        if step_count == 0 {
            return;
        }
        let mut expected_instance = FanInstance::uniform(&self.fans, random.below(step_count + 1) as usize);
        for _ in 0..count {
            for _ in 0..random.below(8) {
                let step = random.below(step_count);
                match random.below(2) {
                    0 => expected_instance.collapse(&self.fans, step),
                    _ => expected_instance.split(&self.fans, step),
                };
            }
            self.check(&expected_instance, what);
        }
    }
}

/// Returns none for inputs that are not valid meshes.
fn refinable(mesh: &IndexedMesh) -> Option<RefinableMesh> {
    Some(build_sequence(mesh, &Default::default()).ok()?.refinable)
}

#[test]
fn degenerate_meshes_are_extracted_exactly() {
    let gpu = gpu();
    let extractor = FanExtractor::new(&gpu);
    let mut mesh_count = 0;
    for (name, mesh) in meshes::nasty() {
        let Some(refinable) = refinable(&mesh) else { continue };
        let mut test = ExtractionTest::new(&gpu, &extractor, &refinable);
        test.check_levels(6, name);
        test.check_random_sets(6, &mut Random::new(3), name);
        mesh_count += 1;
    }
    assert!(mesh_count >= 25, "only {mesh_count} meshes");
}

/// A wheel whose hub is refined first, before every other vertex of its rim.
fn wheel(spoke_count: u32) -> RefinableMesh {
    let hub = spoke_count;
    let on_rim = |turn: f32| {
        let angle = turn / spoke_count as f32 * std::f32::consts::TAU;
        [angle.cos(), angle.sin(), 0.0]
    };
    let rim = (0..spoke_count).map(|i| on_rim(i as f32));
    let between = (0..spoke_count).map(|i| on_rim(i as f32 + 0.5));
    let positions = rim.chain([[0.0; 3]]).chain(between).collect();
    let sides = |i: u32| {
        let middle = hub + 1 + i;
        [[hub, i, middle], [hub, middle, (i + 1) % spoke_count]]
    };
    let triangles: Vec<[u32; 3]> = (0..spoke_count).flat_map(sides).collect();
    let step_count = spoke_count as usize + 1;
    let sequence = CollapseSequence::from_parts(SequenceParts {
        positions: PositionIndex::from_first((0..=2 * spoke_count + 1).collect()),
        base_position_count: spoke_count as usize,
        targets: [0].into_iter().chain(0..spoke_count).collect(),
        errors: (0..step_count).map(|step| (step_count - step) as f32).collect(),
        removed_triangle_counts: [2].into_iter().chain((0..spoke_count).map(|_| 1)).collect(),
        triangle_count: triangles.len(),
    });
    RefinableMesh { mesh: IndexedMesh::new(positions, triangles), sequence: sequence.unwrap() }
}

#[test]
fn rings_longer_than_a_mask_are_extracted_exactly() {
    let gpu = gpu();
    let extractor = FanExtractor::new(&gpu);
    for spoke_count in [7, 8, 9, 31, 32, 33, 64, 65, 200] {
        let refinable = wheel(spoke_count);
        let mut test = ExtractionTest::new(&gpu, &extractor, &refinable);
        let longest = test.fans.table_fans().map(|fan| fan.makers().count()).max();
        assert_eq!(longest, Some((spoke_count as usize).min(MAX_ARCS)));
        test.check_levels(refinable.sequence.step_count(), "wheel");
        test.check_random_sets(30, &mut Random::new(5), "wheel");
    }
}

#[test]
fn surfaces_seams_and_groups_are_extracted_exactly() {
    let gpu = gpu();
    let extractor = FanExtractor::new(&gpu);
    let meshes = [
        ("sphere", shapes::icosphere(4, 1.0)),
        ("terrain", shapes::terrain(50, 7)),
        ("two materials", shapes::two_material_sphere(16, 24)),
        ("seams", shapes::uv_cylinder(40, 12)),
        ("moebius", shapes::moebius_strip(300)),
    ];
    for (name, mesh) in meshes {
        let mut test = ExtractionTest::new(&gpu, &extractor, &refinable(&mesh).unwrap());
        test.check_levels(9, name);
        test.check_random_sets(12, &mut Random::new(11), name);
    }
}

/// With more than 256 blocks, the prefix sum over the blocks takes several rounds.
#[test]
fn a_large_table_is_extracted_exactly_and_small_changes_are_small_uploads() {
    let gpu = gpu();
    let extractor = FanExtractor::new(&gpu);
    let refinable = refinable(&shapes::terrain(300, 1)).unwrap();
    let mut test = ExtractionTest::new(&gpu, &extractor, &refinable);
    assert!(test.fans.table_fans().count() > 256 * 256);
    test.check_levels(3, "large terrain");
    let mut expected_instance = FanInstance::uniform(&test.fans, test.fans.step_count() / 2);
    test.check(&expected_instance, "half");
    let before = test.instance.uploaded_bytes();
    test.check(&expected_instance, "unchanged");
    assert_eq!(test.instance.uploaded_bytes(), before);
    expected_instance.collapse(&test.fans, test.fans.step_count() as u32 / 2 - 1);
    test.check(&expected_instance, "one step further");
    let uploaded = test.instance.uploaded_bytes() - before;
    assert!(uploaded > 0 && uploaded < 64, "{uploaded} bytes for one step");
}

#[test]
fn views_are_extracted_exactly_and_drawn_like_their_lists() {
    const SIZE: [u32; 2] = [240, 200];
    let gpu = gpu();
    let extractor = FanExtractor::new(&gpu);
    let (painter, canvas) = (Painter::new(&gpu, 1), Canvas::new(&gpu, SIZE, 1).unwrap());
    let mut differing = 0;
    for (name, mesh) in [
        ("sphere", shapes::icosphere(5, 1.0)),
        ("terrain", shapes::terrain(60, 4)),
        ("two materials", shapes::two_material_sphere(40, 60)),
    ] {
        let refinable = refinable(&mesh).unwrap();
        let mut test = ExtractionTest::new(&gpu, &extractor, &refinable);
        let mut expected_instance = FanInstance::full(&test.fans);
        let vertices = GpuVertices::upload(&gpu, &refinable.mesh).unwrap();
        let look = Look { shows_groups: true, ..Look::default() };
        for (turn, pixels) in [(0.4, 1.0), (2.0, 3.0), (4.0, 0.5)] {
            let mut view =
                striata_render::Camera::portrait(&refinable.mesh.bounds().unwrap(), turn, 0.5, 0.8);
            view.eye = std::array::from_fn(|k| 0.5 * view.eye[k] + 0.5 * view.look_at[k]);
            let half_height = f64::from(view.fov / 2.0).tan();
            let camera = Camera::new(view.eye, view.look_at, view.up, half_height, SIZE).unwrap();
            let scene = FanScene::new(&test.fans, &refinable.mesh.positions);
            let criterion = ScreenError::new(camera, pixels).with_model_bounds(scene.sphere());
            assert!(
                expected_instance.refine(&scene, &criterion) > 20,
                "{name}: the view needs no refinement"
            );
            test.check(&expected_instance, name);

            let scene = painter.scene(&gpu, &vertices, (&view, SIZE), &look).unwrap();
            let mut list = FanIndices::default();
            expected_instance.emit_into(&test.fans, FanForm::Triangles, &mut list);
            let indices = GpuIndices::upload(&gpu, cast_slice(&list.indices)).unwrap();
            let by_list = Drawing::List { indices: &indices, groups: &list.group_ranges };
            let [by_list, extracted] = [by_list, test.instance.drawing()].map(|drawing| {
                canvas.paint(&gpu, look.background, |p| painter.draw(p, &scene, &vertices, drawing)).unwrap()
            });
            assert!(drawn_pixels(&by_list) > 2000, "{name}: too little is drawn");
            differing += differing_pixels(&by_list, &extracted, 0);
        }
    }
    assert_eq!(differing, 0, "pictures differ");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(24) })]

    #[test]
    fn random_soups_are_extracted_exactly(triangle_count in 1u32..120, seed in 0u64..1000) {
        let gpu = gpu();
        let extractor = FanExtractor::new(&gpu);
        let refinable = refinable(&shapes::random_soup(triangle_count, seed)).unwrap();
        let mut test = ExtractionTest::new(&gpu, &extractor, &refinable);
        test.check_levels(3, "soup");
        test.check_random_sets(4, &mut Random::new(seed), "soup");
    }
}
