//! Many instances of several models in front of a moving camera, within one triangle budget: `cargo run --release -p
//! striata-render --example crowd -- [COUNT] [BUDGET] [MESH]...`.
//!
//! Prints the time of the frames, and that of views which are all updated in each frame, and writes a picture of the
//! last frame to `crowd.png`. Without meshes, there are ten generated models of 10,000 to 70,000 triangles.
#![expect(clippy::print_stdout, reason = "an example shows what it found")]

use std::error::Error;
use std::time::Instant;

use striata::lod::{InstanceId, ViewSet};
use striata::mesh::{IndexedMesh, shapes};
use striata::view::{Camera, ScreenError, Sphere};
use striata::{Lod, LodOptions, View};
use striata_render::{Canvas, Paint, Shot, Style, rasterize};

const FRAME_COUNT: usize = 300;
const SCREEN: [u32; 2] = [1920, 1080];
/// Tangent of half the vertical field of view.
const TAN: f64 = 0.577;
/// Allowed error on the screen, in pixels, if the budget suffices.
const PIXELS: f32 = 0.25;
/// Distance between neighboring instances, which have a radius of 1.
const SPACING: f32 = 3.0;
const PICTURE: [usize; 2] = [960, 540];
const BACKGROUND: [f32; 4] = [0.02, 0.022, 0.028, 1.0];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let count = arguments.next().map_or(Ok(1000), |text| text.parse::<usize>())?;
    let budget = arguments.next().map_or(Ok(1_000_000), |text| text.parse::<usize>())?;
    let mut meshes = arguments.map(striata_io::read).collect::<Result<Vec<_>, _>>()?;
    if meshes.is_empty() {
        meshes = (0..10).map(generated).collect();
    }
    let lods =
        meshes.iter().map(|mesh| Lod::build(mesh, &LodOptions::default())).collect::<Result<Vec<_>, _>>()?;
    let crowd = Crowd { lods, count };
    let sizes: Vec<usize> = crowd.lods.iter().map(|lod| lod.mesh().triangle_count()).collect();
    println!(
        "{count} instances of {} models with {sizes:?} triangles, {budget} triangles allowed",
        sizes.len()
    );

    let (set, ids, pixels) = crowd.measure_set(budget)?;
    crowd.measure_alone(pixels)?;
    let camera = crowd.picture_camera(FRAME_COUNT - 1);
    let shown = crowd.shown(&set, &ids);
    let mut canvas = Canvas::filled(PICTURE[0], PICTURE[1], BACKGROUND);
    let style = Style { has_edges: true, is_flat: true };
    canvas.blend(&rasterize(&Shot::of(&shown, Paint::Surface, style), &camera, PICTURE), 0, 0);
    std::fs::write("crowd.png", canvas.to_png()?)?;
    println!("crowd.png shows the last frame");
    Ok(())
}

/// A bumpy ring of about 10,000 triangles and 6,700 more for each number.
fn generated(number: usize) -> IndexedMesh {
    let sides = ((5000.0 + 3350.0 * number as f32) / 2.0).sqrt() as u32;
    let mut mesh = shapes::torus(2 * sides, sides, 1.0, 0.3 + 0.05 * number as f32);
    let k = number as f32;
    for position in &mut mesh.positions {
        let [x, y, z] = *position;
        let bumps =
            ((4.0 + k) * x).sin() * (5.0 * y + k).sin() + 0.3 * ((19.0 - k) * z).sin() * (17.0 * x + y).cos();
        let fine = (41.0 * x).sin() * (39.0 * y + 1.0).sin() * (43.0 * z).cos();
        *position = position.map(|p| p * (1.0 + 0.12 * bumps + 0.008 * fine));
    }
    mesh
}

/// Instances in rows on the plane y = 0.
struct Crowd {
    lods: Vec<Lod>,
    count: usize,
}

/// Times of frames, in milliseconds.
#[derive(Default)]
struct FrameTimes(Vec<f64>);

impl FrameTimes {
    fn add(&mut self, started: Instant) {
        self.0.push(1e3 * started.elapsed().as_secs_f64());
    }

    /// Prints the first frame, and the mean and the worst of the others.
    fn print(&self, name: &str, triangle_count: f64, updated_count: f64) {
        let rest = &self.0[1..];
        let mean = rest.iter().sum::<f64>() / rest.len() as f64;
        let worst = rest.iter().copied().fold(0.0, f64::max);
        println!(
            "| {name} | {:.1} | {mean:.2} | {worst:.2} | {triangle_count:.0} | {updated_count:.0} |",
            self.0[0]
        );
    }
}

impl Crowd {
    fn lod(&self, number: usize) -> &Lod {
        &self.lods[number % self.lods.len()]
    }

    fn side(&self) -> usize {
        (self.count as f64).sqrt().ceil() as usize
    }

    /// Matrix of an instance, as a list of columns: turned, and scaled to a radius of 1.
    fn matrix(&self, number: usize) -> [[f32; 4]; 4] {
        let Sphere { center, radius } = sphere_around(self.lod(number).mesh());
        let scale = 1.0 / radius;
        let (sin, cos) = (2.4 * number as f32).sin_cos();
        let axes = [[cos * scale, 0.0, -sin * scale], [0.0, scale, 0.0], [sin * scale, 0.0, cos * scale]];
        let [x, z] = [number % self.side(), number / self.side()].map(|k| SPACING * k as f32);
        let moved = |row: usize, at: f32| at - (0..3).map(|k| axes[k][row] * center[k]).sum::<f32>();
        let [a, b, c] = axes.map(|[x, y, z]| [x, y, z, 0.0]);
        [a, b, c, [moved(0, x), moved(1, 1.0), moved(2, z), 1.0]]
    }

    /// Eye and target of a flight over the rows that looks around.
    fn path(&self, frame: usize) -> [[f32; 3]; 2] {
        let part = frame as f32 / FRAME_COUNT as f32;
        let size = SPACING * self.side() as f32;
        let eye = [size * (0.1 + 0.3 * part), 3.0, size * (0.1 + 0.4 * part)];
        let (sin, cos) = (0.3 + 1.2 * part).sin_cos();
        [eye, [eye[0] + 10.0 * cos, 1.5, eye[2] + 10.0 * sin]]
    }

    fn camera(&self, frame: usize) -> Result<Camera, Box<dyn Error>> {
        let [eye, target] = self.path(frame);
        Ok(Camera::new(eye, target, [0.0, 1.0, 0.0], TAN, SCREEN)?)
    }

    fn picture_camera(&self, frame: usize) -> striata_render::Camera {
        let [eye, look_at] = self.path(frame);
        striata_render::Camera { eye, look_at, up: [0.0, 1.0, 0.0], fov: 2.0 * (TAN as f32).atan() }
    }

    /// Updates the instances together. Returns them, and the median of the errors that the budget allowed, in pixels.
    fn measure_set(&self, budget: usize) -> Result<(ViewSet, Vec<InstanceId>, f32), Box<dyn Error>> {
        let mut set = ViewSet::new();
        let ids =
            (0..self.count).map(|i| set.add(self.lod(i), self.matrix(i))).collect::<Result<Vec<_>, _>>()?;
        let (mut times, mut pixels) = (FrameTimes::default(), Vec::new());
        let (mut triangles, mut updated, mut changed, mut most) = (0, 0, 0, 0);
        for frame in 0..FRAME_COUNT {
            let camera = self.camera(frame)?;
            let started = Instant::now();
            let update = set.update(&camera, PIXELS, budget);
            times.add(started);
            triangles += update.triangle_count;
            most = most.max(update.triangle_count);
            updated += if frame > 0 { update.updated_count } else { 0 };
            changed += if frame > 0 { update.changed.len() } else { 0 };
            pixels.push(update.pixels);
        }
        pixels.sort_by(f32::total_cmp);
        let frames = FRAME_COUNT as f64;
        println!(
            "\n| | first frame, ms | mean, ms | worst, ms | triangles | updates |\n|---|---|---|---|---|---|"
        );
        times.print("together", triangles as f64 / frames, updated as f64 / frames);
        let median = pixels[FRAME_COUNT / 2];
        println!(
            "\nat most {most} triangles; errors of {:.2} to {:.2} pixels, median {median:.2}; the indices of {:.0} instances \
             change per frame",
            pixels[0],
            pixels[FRAME_COUNT - 1],
            changed as f64 / frames
        );
        let base: usize = self
            .lods
            .iter()
            .map(|lod| lod.level(striata::Target::SplitCount(0)).indices().len())
            .max()
            .unwrap_or(0);
        let followers = (0..self.count).filter(|&i| set.indices(ids[i]).len() > base);
        let vertices: usize = followers.map(|i| self.lod(i).mesh().vertex_count()).sum();
        println!(
            "{:.0} bytes an instance without indices, {:.2} bytes per vertex of the instances that follow; {:.0} bytes of indices\n",
            set.bytes() as f64 / self.count as f64,
            set.bytes() as f64 / vertices.max(1) as f64,
            12.0 * set.triangle_count() as f64 / self.count as f64
        );
        Ok((set, ids, median))
    }

    /// Updates a view for each instance in the picture, on as many threads as there are cores.
    fn measure_alone(&self, pixels: f32) -> Result<(), Box<dyn Error>> {
        let bounds: Vec<Sphere> = self.lods.iter().map(|lod| sphere_around(lod.mesh())).collect();
        let mut views: Vec<(usize, Option<View>)> = (0..self.count).map(|i| (i, None)).collect();
        let (mut times, mut triangles, mut updated) = (FrameTimes::default(), 0, 0);
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        for frame in 0..FRAME_COUNT {
            let error = ScreenError::new(self.camera(frame)?, pixels);
            let started = Instant::now();
            let follow = |(i, view): &mut (usize, Option<View>)| {
                let matrix = self.matrix(*i).as_flattened().iter().map(|x| f64::from(*x)).collect::<Vec<_>>();
                let own = matrix.try_into().ok().and_then(|matrix| error.in_object(&matrix));
                match own.filter(|own| own.camera().may_see(&bounds[*i % self.lods.len()])) {
                    Some(own) => {
                        view.get_or_insert_with(|| self.lod(*i).view()).update_by(own);
                    }
                    None => *view = None,
                }
            };
            let share = self.count.div_ceil(threads).max(1);
            std::thread::scope(|scope| {
                for part in views.chunks_mut(share) {
                    scope.spawn(|| part.iter_mut().for_each(follow));
                }
            });
            times.add(started);
            triangles += views.iter().flat_map(|(_, view)| view).map(View::triangle_count).sum::<usize>();
            updated += if frame > 0 { views.iter().filter(|(_, view)| view.is_some()).count() } else { 0 };
        }
        let frames = FRAME_COUNT as f64;
        times.print(
            &format!("each alone, {pixels:.2} pixels"),
            triangles as f64 / frames,
            updated as f64 / frames,
        );
        println!();
        Ok(())
    }

    /// Copies the triangles that all instances show to one mesh.
    fn shown(&self, set: &ViewSet, ids: &[InstanceId]) -> IndexedMesh {
        let (mut positions, mut triangles) = (Vec::new(), Vec::new());
        for (i, id) in ids.iter().enumerate() {
            let matrix = self.matrix(i);
            let place = |p: [f32; 3]| {
                std::array::from_fn(|row| matrix[3][row] + (0..3).map(|k| matrix[k][row] * p[k]).sum::<f32>())
            };
            for triangle in set.indices(*id).as_chunks::<3>().0 {
                let first = positions.len() as u32;
                positions.extend(triangle.map(|vertex| place(self.lod(i).positions()[vertex as usize])));
                triangles.push([first, first + 1, first + 2]);
            }
        }
        IndexedMesh::new(positions, triangles)
    }
}

/// Sphere around the box of a mesh.
fn sphere_around(mesh: &IndexedMesh) -> Sphere {
    mesh.bounds().map_or(Sphere::point([0.0; 3]), |bounds| Sphere {
        center: std::array::from_fn(|k| f32::midpoint(bounds.min[k], bounds.max[k])),
        radius: (bounds.diagonal() as f32 / 2.0).max(f32::MIN_POSITIVE),
    })
}
