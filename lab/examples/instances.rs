//! A thousand instances of one model, each refined as far as one moving camera needs it: `cargo run
//! --release --manifest-path lab/Cargo.toml --example instances -- [MESH]`.
//!
//! All instances share one table; each owns one bit per removable vertex. The camera is transformed into
//! the space of each instance, since a criterion handles one model and one eye. The example compares two
//! methods: instances that are refined from the base in every frame and store only their bits; and fronts,
//! which remember verdicts and evaluate again only those that may have changed. An instance outside the
//! picture returns to its base, without evaluating any of its steps.
#![expect(clippy::print_stdout, reason = "an example shows what it found")]

use std::error::Error;
use std::time::{Duration, Instant};

use striata::mesh::{IndexedMesh, RefinableMesh, shapes};
use striata::model::{FanForm, FanFront, FanIndices, FanInstance, FanScene, Fans, LodModel};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::view::{Camera, ScreenError, Sphere};

/// Instances are arranged in rows on the plane y = 0.
const COLUMNS: usize = 40;
const ROWS: usize = 25;
/// Distance between neighboring instances, in radii of the model.
const SPACING: f32 = 3.0;
const FRAME_COUNT: usize = 240;
const SCREEN: [u32; 2] = [1920, 1080];
/// Allowed screen error in pixels.
const PIXELS: f32 = 1.0;

/// Memory of view-dependent progressive meshes per vertex, and per active vertex of an instance.
const VDPM_STATIC_BYTES: usize = 136;
const VDPM_ACTIVE_BYTES: usize = 208;

fn main() -> Result<(), Box<dyn Error>> {
    let mesh = match std::env::args_os().nth(1) {
        Some(path) => striata_io::read(path)?,
        None => potato(),
    };
    let refinable = build_sequence(&mesh, &SequenceOptions::default())?.refinable;
    let fans = Fans::build(&refinable);
    let scene = FanScene::new(&fans, &refinable.mesh.positions);
    let placements: Vec<Placement> =
        (0..COLUMNS * ROWS).map(|i| Placement::on_grid(i, scene.sphere())).collect();
    println!(
        "{} instances of {} vertices and {} triangles; {FRAME_COUNT} frames, {} by {}, \
         errors up to {PIXELS} px",
        placements.len(),
        refinable.mesh.vertex_count(),
        refinable.mesh.triangle_count(),
        SCREEN[0],
        SCREEN[1],
    );
    print_static(&refinable, &fans);
    println!("\nbits only, refined from the base in every frame");
    run(&scene, &placements, placements.iter().map(|_| Bits::new(&fans)).collect())?;
    println!("\nfronts, which remember verdicts, while they are visible");
    let base = FanInstance::uniform(&fans, 0);
    run(
        &scene,
        &placements,
        placements.iter().map(|_| FrontWhileVisible { base: &base, front: None }).collect(),
    )
}

/// A ball with bumps of several sizes.
fn potato() -> IndexedMesh {
    let mut mesh = shapes::icosphere(6, 1.0);
    for position in &mut mesh.positions {
        let [x, y, z] = *position;
        let bumps = (2.0 * x + 1.0).sin() * (3.0 * y).sin() + 0.3 * (9.0 * z).sin() * (8.0 * x + y).cos();
        let fine = (31.0 * x).sin() * (29.0 * y + 1.0).sin() * (33.0 * z).cos();
        *position = position.map(|p| p * (1.0 + 0.2 * bumps + 0.01 * fine));
    }
    mesh
}

/// Position and orientation of an instance in the world, in which the model has radius 1.
struct Placement {
    model: Sphere,
    at: [f32; 3],
    /// Sine and cosine of the rotation about the vertical axis.
    sin_cos: (f32, f32),
}

impl Placement {
    fn on_grid(index: usize, model: Sphere) -> Self {
        let [x, z] = [index % COLUMNS, index / COLUMNS].map(|i| SPACING * i as f32);
        Self { model, at: [x, 1.0, z], sin_cos: (2.4 * index as f32).sin_cos() }
    }

    fn direction_in_model(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let (sin, cos) = self.sin_cos;
        [cos * x - sin * z, y, sin * x + cos * z]
    }

    fn point_in_model(&self, point: [f32; 3]) -> [f32; 3] {
        let from_here = self.direction_in_model([0, 1, 2].map(|i| point[i] - self.at[i]));
        [0, 1, 2].map(|i| self.model.center[i] + self.model.radius * from_here[i])
    }

    /// The world's camera in the space of the model.
    fn camera(&self, view: &View) -> Result<Camera, Box<dyn Error>> {
        let [eye, target] = [view.eye, view.target].map(|point| self.point_in_model(point));
        Ok(Camera::new(eye, target, self.direction_in_model([0.0, 1.0, 0.0]), 0.577, SCREEN)?)
    }
}

/// The world's camera in one frame.
struct View {
    eye: [f32; 3],
    target: [f32; 3],
}

impl View {
    /// A view that flies over the rows and looks around.
    fn at(frame: usize) -> Self {
        let part = frame as f32 / FRAME_COUNT as f32;
        let [width, depth] = [COLUMNS, ROWS].map(|count| SPACING * count as f32);
        let eye = [width * (0.1 + 0.3 * part), 3.0, depth * (0.1 + 0.4 * part)];
        let (sin, cos) = (0.3 + 1.2 * part).sin_cos();
        Self { eye, target: [eye[0] + 10.0 * cos, 1.0, eye[2] + 10.0 * sin] }
    }
}

/// An instance that follows the camera.
trait ModelFollower {
    fn update(&mut self, scene: &FanScene<'_>, criterion: &ScreenError);

    /// Returns to the base immediately.
    fn drop_detail(&mut self, scene: &FanScene<'_>);

    fn instance(&self) -> &FanInstance;

    fn bytes(&self) -> usize;
}

/// An instance that stores only its bits.
struct Bits {
    instance: FanInstance,
    is_base: bool,
}

impl Bits {
    fn new(fans: &Fans) -> Self {
        Self { instance: FanInstance::uniform(fans, 0), is_base: true }
    }
}

impl ModelFollower for Bits {
    fn update(&mut self, scene: &FanScene<'_>, criterion: &ScreenError) {
        self.is_base = self.instance.refine(scene, criterion) == 0;
    }

    fn drop_detail(&mut self, scene: &FanScene<'_>) {
        if !self.is_base {
            *self = Self::new(scene.fans());
        }
    }

    fn instance(&self) -> &FanInstance {
        &self.instance
    }

    fn bytes(&self) -> usize {
        self.instance.bytes()
    }
}

/// A front that exists while the instance is visible; nothing needs to be remembered at the base.
struct FrontWhileVisible<'a> {
    base: &'a FanInstance,
    front: Option<FanFront<ScreenError>>,
}

impl ModelFollower for FrontWhileVisible<'_> {
    fn update(&mut self, scene: &FanScene<'_>, criterion: &ScreenError) {
        self.front.get_or_insert_with(|| FanFront::new(scene)).update(scene, criterion, usize::MAX);
    }

    fn drop_detail(&mut self, _: &FanScene<'_>) {
        self.front = None;
    }

    fn instance(&self) -> &FanInstance {
        self.front.as_ref().map_or(self.base, FanFront::instance)
    }

    fn bytes(&self) -> usize {
        self.front.as_ref().map_or(0, FanFront::bytes)
    }
}

/// Sums over all frames.
#[derive(Default)]
struct Totals {
    update: Duration,
    slowest: Duration,
    emission: Duration,
    triangles: usize,
    visible_count: usize,
}

fn run<F: ModelFollower>(
    scene: &FanScene<'_>,
    placements: &[Placement],
    mut followers: Vec<F>,
) -> Result<(), Box<dyn Error>> {
    let mut out = FanIndices::default();
    let mut totals = Totals::default();
    for frame in 0..=FRAME_COUNT {
        let view = View::at(frame);
        let started = Instant::now();
        let mut visible = Vec::new();
        for (i, (placement, follower)) in placements.iter().zip(&mut followers).enumerate() {
            let camera = placement.camera(&view)?;
            if camera.may_see(&placement.model) {
                let criterion = ScreenError::new(camera, PIXELS).with_model_bounds(placement.model);
                follower.update(scene, &criterion);
                visible.push(i);
            } else {
                follower.drop_detail(scene);
            }
        }
        let update = started.elapsed();
        if frame == 0 {
            println!("  first frame       {:8.2} ms", millis(update));
            continue;
        }
        let started = Instant::now();
        for &i in &visible {
            followers[i].instance().emit_into(scene.fans(), FanForm::Triangles, &mut out);
            totals.triangles += out.indices.len() / 3;
        }
        totals.emission += started.elapsed();
        totals.update += update;
        totals.slowest = totals.slowest.max(update);
        totals.visible_count += visible.len();
    }
    totals.print();
    print_memory(scene, &followers);
    Ok(())
}

impl Totals {
    fn print(&self) {
        let frames = FRAME_COUNT as f64;
        println!(
            "  criterion, update {:8.2} ms per frame, slowest {:.2}",
            millis(self.update) / frames,
            millis(self.slowest)
        );
        println!(
            "  emission          {:8.2} ms per frame, {:.1} M triangles per second",
            millis(self.emission) / frames,
            self.triangles as f64 / self.emission.as_secs_f64() / 1e6
        );
        println!(
            "  triangles         {:8.0} per frame, in {:.0} visible instances",
            self.triangles as f64 / frames,
            self.visible_count as f64 / frames
        );
    }
}

fn print_static(refinable: &RefinableMesh, fans: &Fans) {
    let vertex_count = refinable.mesh.vertex_count();
    let parts = fans.bytes();
    let sum = |are_bounds: bool| -> usize {
        parts.iter().filter(|part| (part.name == "bounds") == are_bounds).map(|part| part.bytes).sum()
    };
    let (table, bounds) = (sum(false), sum(true));
    let all = table + bounds + 12 * vertex_count;
    println!(
        "shared: table {}, bounds {}, positions {}: {}, {:.1} bytes per vertex \
         (view-dependent progressive mesh {VDPM_STATIC_BYTES})",
        kilobytes(table),
        kilobytes(bounds),
        kilobytes(12 * vertex_count),
        kilobytes(all),
        all as f64 / vertex_count as f64,
    );
}

fn print_memory<F: ModelFollower>(scene: &FanScene<'_>, followers: &[F]) {
    let bytes: usize = followers.iter().map(ModelFollower::bytes).sum();
    let largest = followers.iter().map(ModelFollower::bytes).max().unwrap_or(0);
    let active = |follower: &F| scene.fans().vertex_count() - follower.instance().collapse_count();
    let active_count: usize = followers.iter().map(active).sum();
    println!(
        "  memory            {} in all, {} each, largest {}",
        kilobytes(bytes),
        kilobytes(bytes / followers.len().max(1)),
        kilobytes(largest)
    );
    println!(
        "  as view-dependent progressive meshes: {} for {active_count} active vertices at \
         {VDPM_ACTIVE_BYTES} bytes",
        kilobytes(VDPM_ACTIVE_BYTES * active_count)
    );
}

fn millis(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}

fn kilobytes(bytes: usize) -> String {
    format!("{:.1} kB", bytes as f64 / 1e3)
}
