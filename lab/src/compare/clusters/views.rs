//! Cuts for cameras at several distances, with their errors on the screen.

use glam::DVec3;
use striata::Lod;
use striata::clusters::{ClusterDag, ClusterGroup};
use striata::mesh::{IndexedMesh, SurfaceSamples, TriangleTree};
use striata::model::{BoundScope, FanInstance, FanOptions, FanScene, Fans};
use striata::view::{Camera, Part, Sphere};
use striata_command::failure::Failure;

/// Number of points of the mesh at which errors are measured, of which each camera sees some.
const POINTS: usize = 20_000;
/// Side of the screen, pixels.
const SCREEN_PX: u32 = 1000;
/// Half of the field of view, radians.
const HALF_FIELD: f64 = std::f64::consts::PI / 6.0;
/// Directions of the cameras from the mesh.
const DIRECTIONS: [[f64; 3]; 4] = [[0.3, 0.4, 0.9], [-0.8, 0.3, 0.5], [0.5, 0.2, -0.8], [0.9, 0.5, 0.2]];
/// Distances of the cameras in diagonals: the first two from the center, the others from the surface.
const DISTANCES: [f64; 4] = [0.9, 1.6, 0.3, 0.08];
/// Number of tolerances.
const TOLERANCES: i32 = 15;
/// Smallest tolerance, pixels; each one is larger than the one before by the square root of 2.
const FINEST_PX: f32 = 0.25;
/// Tolerances of the reference at which triangles are compared, pixels.
const COMPARED_PX: std::ops::RangeInclusive<f32> = 0.5..=4.01;

/// Points on the surface, with the normals of their triangles.
pub(super) struct SurfacePoints(Vec<[DVec3; 2]>);

impl SurfacePoints {
    /// Samples a mesh.
    ///
    /// # Errors
    /// If the mesh has no area.
    pub(super) fn new(mesh: &IndexedMesh) -> Result<Self, Failure> {
        let of_sample = |sample: striata::mesh::SurfaceSample| {
            let [a, b, c] = mesh.triangles[sample.triangle].map(|v| place(mesh, v));
            [DVec3::from(sample.point), (b - a).cross(c - a).normalize_or_zero()]
        };
        let samples = SurfaceSamples::new(mesh, POINTS, 1);
        let points = samples.map_area_chunks(|chunk| chunk.map(of_sample).collect::<Vec<_>>()).concat();
        if points.is_empty() {
            return Err(Failure::user("the mesh has no area".to_owned()));
        }
        Ok(Self(points))
    }
}

/// A camera, and the points that it may see with their pixels per unit.
pub(super) struct ViewPoint {
    camera: Camera,
    points: Vec<([f64; 3], f64)>,
}

impl ViewPoint {
    /// The cameras of a mesh.
    ///
    /// # Errors
    /// If the mesh is inconsistent or has no extent.
    pub(super) fn all(mesh: &IndexedMesh, points: &SurfacePoints) -> Result<Vec<Self>, Failure> {
        let bounds = mesh.bounds().ok_or_else(|| Failure::user("the mesh has no vertices".to_owned()))?;
        let [min, max] = [bounds.min, bounds.max].map(|p| DVec3::from(p.map(f64::from)));
        let (center, diagonal) = (0.5 * (min + max), bounds.diagonal());
        let tree = TriangleTree::new(mesh)?;
        let scale = f64::from(SCREEN_PX) / (2.0 * HALF_FIELD.tan());
        let mut views = Vec::new();
        for (direction, distance) in DIRECTIONS.into_iter().zip(DISTANCES) {
            let direction = DVec3::from(direction).normalize();
            let nearest = tree.nearest((center + 2.0 * diagonal * direction).to_array());
            let target = match nearest.filter(|_| distance < 0.5) {
                None => center,
                Some(nearest) => {
                    let corners = mesh.triangles[nearest.triangle as usize].map(|v| place(mesh, v));
                    corners.iter().sum::<DVec3>() / 3.0
                }
            };
            let eye = target + distance * diagonal * direction;
            let [eye_f32, target] = [eye, target].map(|p| p.as_vec3().to_array());
            let camera = Camera::new(eye_f32, target, [0.0, 1.0, 0.01], HALF_FIELD.tan(), [SCREEN_PX; 2]);
            let camera = camera.map_err(|error| Failure::user(error.to_string()))?;
            let is_seen = |&&[point, normal]: &&[DVec3; 2]| {
                (point - eye).dot(normal) < 0.0 && camera.may_see(&Sphere::point(point.as_vec3().to_array()))
            };
            let with_scale = |[point, _]: &[DVec3; 2]| (point.to_array(), scale / point.distance(eye));
            let points = points.0.iter().filter(is_seen).map(with_scale).collect();
            views.push(Self { camera, points });
        }
        Ok(views)
    }
}

/// A cut with its errors on the screen.
#[derive(Clone, Copy, Debug)]
struct MeasuredCut {
    tolerance: f32,
    triangle_count: usize,
    /// Root mean square, 99th percentile and maximum, pixels.
    errors: [f64; 3],
}

/// Cuts of one contender at all tolerances, for each camera.
pub(super) struct ViewCuts(Vec<Vec<MeasuredCut>>);

impl ViewCuts {
    /// Cuts of clusters.
    ///
    /// # Errors
    /// If a cut is inconsistent, which would be a bug.
    pub(super) fn of_clusters(
        mesh: &IndexedMesh,
        dag: &ClusterDag,
        views: &[ViewPoint],
    ) -> Result<Self, Failure> {
        Self::new(&mesh.positions, views, |view, tolerance| {
            let is_good =
                |group: &ClusterGroup| view.camera.error_px(group.error, &group.sphere) <= tolerance;
            dag.triangles_of(&dag.cut(is_good))
        })
    }

    /// Cuts at single vertices, with bounds that make a vertex independent of all others.
    ///
    /// # Errors
    /// If a cut is inconsistent, which would be a bug.
    pub(super) fn of_vertices(lod: &Lod, views: &[ViewPoint]) -> Result<Self, Failure> {
        let refinable =
            striata::mesh::RefinableMesh { mesh: lod.mesh().clone(), sequence: lod.sequence().clone() };
        let options = FanOptions::default().with_bounds(Some(BoundScope::Dependents));
        let fans = Fans::build_with(&refinable, &options, &mut striata::ignore_progress);
        let fans = fans.map_err(|error| Failure::internal(error.to_string()))?;
        let scene = FanScene::new(&fans, lod.positions());
        Self::new(lod.positions(), views, |view, tolerance| {
            let mut instance = FanInstance::uniform(&fans, 0);
            instance
                .refine(&scene, &|part: &Part| view.camera.error_px(part.error, &part.sphere) / tolerance);
            let mut indices = Vec::new();
            instance.indices_into(&fans, &mut indices);
            indices.as_chunks().0.to_vec()
        })
    }

    fn new(
        positions: &[[f32; 3]],
        views: &[ViewPoint],
        cut: impl Fn(&ViewPoint, f32) -> Vec<[u32; 3]>,
    ) -> Result<Self, Failure> {
        let mut all = Vec::new();
        for view in views {
            let mut cuts = Vec::new();
            for step in 0..TOLERANCES {
                let tolerance = FINEST_PX * std::f32::consts::SQRT_2.powi(step);
                let triangles = cut(view, tolerance);
                let triangle_count = triangles.len();
                let level = IndexedMesh::new(positions.to_vec(), triangles).without_unused_vertices();
                let errors = errors(&level, view)?;
                cuts.push(MeasuredCut { tolerance, triangle_count, errors });
            }
            all.push(cuts);
        }
        Ok(Self(all))
    }

    /// Triangles relative to those of another contender at its errors: geometric means for each kind of error.
    pub(super) fn relative_to(&self, reference: &Self) -> [f64; 3] {
        [0, 1, 2].map(|kind| {
            let mut logs = Vec::new();
            for (own, reference) in self.0.iter().zip(&reference.0) {
                for cut in reference.iter().filter(|cut| COMPARED_PX.contains(&cut.tolerance)) {
                    let count = triangles_at(own, kind, cut.errors[kind]);
                    logs.extend(count.map(|count| (count / cut.triangle_count as f64).ln()));
                }
            }
            (logs.iter().sum::<f64>() / logs.len() as f64).exp()
        })
    }
}

/// Triangles that a contender needs for an error, interpolated between its cuts; [`None`] outside of them.
fn triangles_at(cuts: &[MeasuredCut], kind: usize, error: f64) -> Option<f64> {
    let mut points: Vec<[f64; 2]> = cuts
        .iter()
        .filter(|cut| cut.errors[kind] > 0.0 && cut.triangle_count > 0)
        .map(|cut| [cut.errors[kind].ln(), (cut.triangle_count as f64).ln()])
        .collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let wanted = error.ln();
    let [low, high] = points.array_windows().find(|[a, b]| a[0] <= wanted && wanted <= b[0])?;
    let share = if high[0] > low[0] { (wanted - low[0]) / (high[0] - low[0]) } else { 0.0 };
    Some((low[1] + share * (high[1] - low[1])).exp())
}

fn errors(level: &IndexedMesh, view: &ViewPoint) -> Result<[f64; 3], Failure> {
    let tree = TriangleTree::new(level)?;
    let mut errors: Vec<f64> = view.points.iter().map(|(p, scale)| tree.distance_to(*p) * scale).collect();
    errors.sort_by(f64::total_cmp);
    let count = errors.len().max(1);
    let rms = (errors.iter().map(|error| error * error).sum::<f64>() / count as f64).sqrt();
    let at = |index: usize| errors.get(index).copied().unwrap_or(0.0);
    Ok([rms, at(count * 99 / 100), at(count - 1)])
}

fn place(mesh: &IndexedMesh, vertex: u32) -> DVec3 {
    DVec3::from(mesh.positions[vertex as usize].map(f64::from))
}
