//! A crowd of instances of one mesh, refined on the GPU without history, compared with views on the CPU.
//!
//! Instances stand in rows on a plane, three radii apart, and each is turned differently. The camera is above a corner
//! and looks across them, so that instances at all distances are seen.

use std::time::Instant;

use glam::{DMat4, DQuat, DVec3};
use serde::Serialize;
use striata::mesh::{IndexedMesh, RefinableMesh, TriangleTree};
use striata::model::{FanBoxes, FanInstance, FanScene, Fans};
use striata::view::{Camera, ScreenError, Sphere};
use striata_command::failure::Failure;
use striata_command::output::{format_bytes, format_count};
use striata_render::gpu::{CrowdInstance, CrowdMesh, Gpu, GpuCrowd};

/// Screen of the crowd, in pixels.
const SCREEN: [u32; 2] = [1920, 1080];

/// Tolerance, in pixels.
const PIXELS: f32 = 1.0;

/// Distance between neighbors, in radii of the mesh.
const SPACING: f64 = 3.0;

/// Number of frames; the fastest counts.
const FRAME_COUNT: usize = 5;

/// Number of instances whose error on the screen is measured, those with the most triangles.
const MEASURED_COUNT: usize = 24;

/// Results of a crowd.
#[derive(Debug, Serialize)]
pub(super) struct CrowdReport {
    instance_count: usize,
    visible_count: usize,
    triangle_limit: usize,
    /// Bytes of the bits of one instance.
    bit_bytes: u64,
    /// Bytes of the camera, the place and the draw of one instance.
    state_bytes: u64,
    /// Bytes of the tables that all instances share.
    mesh_bytes: u64,
    /// Bytes uploaded in one frame.
    uploaded_bytes: u64,
    /// Steps of all instances.
    step_count: usize,
    /// Steps that are left after ranges without effect have been skipped.
    evaluated_count: usize,
    triangle_count: usize,
    /// Triangles of views of the same instances, which follow the camera on the CPU.
    view_triangle_count: usize,
    /// Multiple of the tolerance that the triangle limit required.
    relaxation: f64,
    /// Largest error of the measured instances, in pixels.
    error_px: f64,
    /// Seconds to place the camera on the grid of each instance, on the CPU.
    place_secs: f64,
    /// Seconds from submitting the decision until it is done.
    decide_secs: f64,
    /// Seconds from submitting the extraction until it is done.
    expand_secs: f64,
    /// Seconds in which the CPU refines the instances that can be seen from their bits.
    view_secs: f64,
}

/// A crowd, and the mesh and the camera that it is measured with.
struct CrowdStage<'a> {
    refinable: &'a RefinableMesh,
    fans: &'a Fans,
    instances: Vec<CrowdInstance>,
    criterion: ScreenError,
}

impl CrowdReport {
    /// Refines `instance_count` instances of a mesh with at most `triangle_limit` triangles.
    ///
    /// # Errors
    /// If the crowd does not fit onto the GPU, or the GPU fails.
    pub(super) fn new(
        gpu: &Gpu,
        refinable: &RefinableMesh,
        instance_count: usize,
        triangle_limit: usize,
    ) -> Result<Self, Failure> {
        let fans = Fans::build(refinable);
        let boxes = FanBoxes::new(&fans, refinable);
        let stage = CrowdStage::new(refinable, &fans, instance_count)?;
        let mut crowd = GpuCrowd::new(gpu, &[CrowdMesh { fans: &fans, boxes: &boxes }])?;
        crowd.set_instances(gpu, &stage.instances, triangle_limit)?;
        gpu.wait()?;
        let mut secs = [f64::INFINITY; 3];
        let before = crowd.uploaded_bytes();
        for _ in 0..FRAME_COUNT {
            let started = Instant::now();
            crowd.look(gpu, &stage.criterion, triangle_limit)?;
            let placed = started.elapsed().as_secs_f64();
            let decided = timed(gpu, |encoder| crowd.decide(encoder))?;
            let expanded = timed(gpu, |encoder| crowd.expand(encoder))?;
            secs = [0, 1, 2].map(|at| secs[at].min([placed, decided, expanded][at]));
        }
        let [place_secs, decide_secs, expand_secs] = secs;
        let counts = crowd.read_counts(gpu)?;
        let per_instance = |bytes: u64| bytes / instance_count.max(1) as u64;
        let started = Instant::now();
        let view_triangle_count = stage.view_triangles(&counts.triangle_counts);
        Ok(Self {
            view_secs: started.elapsed().as_secs_f64(),
            instance_count,
            visible_count: counts.triangle_counts.iter().filter(|&&count| count > 0).count(),
            triangle_limit,
            bit_bytes: per_instance(crowd.bit_bytes()),
            state_bytes: per_instance(crowd.state_bytes()),
            mesh_bytes: crowd.mesh_bytes(),
            uploaded_bytes: (crowd.uploaded_bytes() - before) / FRAME_COUNT as u64,
            step_count: instance_count * boxes.boxes().len(),
            evaluated_count: counts.range_counts.iter().map(|&count| 32 * count as usize).sum(),
            triangle_count: counts.triangle_counts.iter().map(|&count| count as usize).sum(),
            view_triangle_count,
            relaxation: (f64::from(counts.threshold) / 1024.0).exp2(),
            error_px: stage.largest_error(&crowd.read_triangles(gpu)?)?,
            place_secs,
            decide_secs,
            expand_secs,
        })
    }

    /// Lines of the report for people.
    pub(super) fn to_text(&self) -> String {
        let millis = |secs: f64| format!("{:.2} ms", 1e3 * secs);
        let bytes = |bytes: u64| format_bytes(bytes as usize);
        format!(
            "crowd of {} at {PIXELS} px in {} x {}: {} visible, {} triangles of at most {}, views {} ({:.3})\n  \
             tolerance times {:.2}; largest error {:.2} px; {} bits and {} state per instance, {} shared, {} sent\n  \
             {} of {} steps evaluated; place {}, decide {}, expand {}; views from bits on the CPU {}\n",
            format_count(self.instance_count),
            SCREEN[0],
            SCREEN[1],
            format_count(self.visible_count),
            format_count(self.triangle_count),
            format_count(self.triangle_limit),
            format_count(self.view_triangle_count),
            self.triangle_count as f64 / self.view_triangle_count.max(1) as f64,
            self.relaxation,
            self.error_px,
            bytes(self.bit_bytes),
            bytes(self.state_bytes),
            bytes(self.mesh_bytes),
            bytes(self.uploaded_bytes),
            format_count(self.evaluated_count),
            format_count(self.step_count),
            millis(self.place_secs),
            millis(self.decide_secs),
            millis(self.expand_secs),
            millis(self.view_secs),
        )
    }
}

/// Seconds until recorded commands are done.
fn timed(
    gpu: &Gpu,
    record: impl FnOnce(&mut striata_render::gpu::wgpu::CommandEncoder),
) -> Result<f64, Failure> {
    let mut encoder = gpu.device().create_command_encoder(&Default::default());
    record(&mut encoder);
    let started = Instant::now();
    gpu.queue().submit([encoder.finish()]);
    gpu.wait()?;
    Ok(started.elapsed().as_secs_f64())
}

impl<'a> CrowdStage<'a> {
    fn new(refinable: &'a RefinableMesh, fans: &'a Fans, count: usize) -> Result<Self, Failure> {
        let sphere = FanScene::new(fans, &refinable.mesh.positions).sphere();
        let (center, radius) = (DVec3::from(sphere.center.map(f64::from)), f64::from(sphere.radius));
        let columns = (count as f64).sqrt().ceil().max(1.0) as usize;
        let place = |at: usize| {
            let [x, z] = [at % columns, at / columns].map(|i| SPACING * i as f64);
            let turn = DMat4::from_quat(DQuat::from_rotation_y(2.4 * at as f64));
            let unit = DMat4::from_scale(DVec3::splat(1.0 / radius)) * DMat4::from_translation(-center);
            let transform = DMat4::from_translation(DVec3::new(x, 1.0, z)) * turn * unit;
            CrowdInstance { mesh: 0, transform: transform.to_cols_array() }
        };
        let side = (SPACING * columns as f64) as f32;
        let (eye, target) = ([-4.0, 6.0, -4.0], [side / 3.0, 0.0, side / 3.0]);
        let camera = Camera::new(eye, target, [0.0, 1.0, 0.0], 0.577, SCREEN)
            .map_err(|error| Failure::internal(error.to_string()))?;
        let criterion = ScreenError::new(camera, PIXELS);
        Ok(Self { refinable, fans, instances: (0..count).map(place).collect(), criterion })
    }

    /// Triangles of the instances that can be seen, refined as views are.
    fn view_triangles(&self, counts: &[u32]) -> usize {
        let scene = FanScene::new(self.fans, &self.refinable.mesh.positions);
        let added: Vec<i64> =
            self.fans.triangle_counts().windows(2).map(|two| i64::from(two[1]) - i64::from(two[0])).collect();
        let mut instance = FanInstance::full(self.fans);
        let shown = self.instances.iter().zip(counts).filter(|&(_, &count)| count > 0);
        let total: i64 = shown
            .filter_map(|(shown, _)| self.criterion.in_object(&shown.transform))
            .map(|criterion| {
                instance.refine(&scene, &criterion);
                let refined = (0..added.len()).filter(|&step| instance.is_refined(step as u32));
                self.fans.base_triangle_count() as i64 + refined.map(|step| added[step]).sum::<i64>()
            })
            .sum();
        total.max(0) as usize
    }

    /// The largest error on the screen of the instances with the most triangles.
    ///
    /// # Errors
    /// If the triangles refer to missing vertices, which would be a bug.
    fn largest_error(&self, triangles: &[Vec<[u32; 3]>]) -> Result<f64, Failure> {
        let mut order: Vec<usize> = (0..triangles.len()).filter(|&at| !triangles[at].is_empty()).collect();
        order.sort_by_key(|&at| std::cmp::Reverse(triangles[at].len()));
        let mut largest = 0.0f64;
        for at in order.into_iter().take(MEASURED_COUNT) {
            if let Some(criterion) = self.criterion.in_object(&self.instances[at].transform) {
                let error = largest_error(&self.refinable.mesh, &triangles[at], criterion.camera())?;
                largest = largest.max(error);
            }
        }
        Ok(largest)
    }
}

/// The largest error in pixels of all vertices in the picture on triangles that face the camera.
///
/// # Errors
/// If the triangles refer to missing vertices.
fn largest_error(mesh: &IndexedMesh, shown: &[[u32; 3]], camera: &Camera) -> Result<f64, Failure> {
    let tree = TriangleTree::new(&IndexedMesh::new(mesh.positions.clone(), shown.to_vec()))?;
    let point = |v: u32| DVec3::from(mesh.positions[v as usize].map(f64::from));
    let eye = DVec3::from(camera.eye().map(f64::from));
    let mut is_seen = vec![false; mesh.vertex_count()];
    for &[a, b, c] in &mesh.triangles {
        let [first, second, third] = [a, b, c].map(point);
        if (second - first).cross(third - first).dot(eye - first) > 0.0 {
            [a, b, c].into_iter().for_each(|v| is_seen[v as usize] = true);
        }
    }
    let seen = (0..).zip(&is_seen).filter(|&(_, &is_seen)| is_seen).map(|(v, _)| v);
    let errors = seen.filter_map(|v: u32| {
        let at = Sphere::point(mesh.positions[v as usize]);
        let distance = || tree.distance_to(point(v).to_array()) as f32;
        camera.may_see(&at).then(|| f64::from(camera.error_px(distance(), &at)))
    });
    Ok(errors.fold(0.0, f64::max))
}
