//! Surface distance between two meshes by sampling, as in Metro \[CRS98\].
//!
//! Points are distributed over each surface and measured against the whole other surface. Both directions are
//! needed, since one alone does not notice what is missing. Samples are stratified by area: sample `k` of `n`
//! lies in the triangle in which the running area passes `k / n`, at the next point of a low-discrepancy
//! sequence, so the results converge as with a grid rather than as with random noise. All vertices and some
//! points on the edges are measured too; they count only for the maximum, which is usually found there.
//!
//! Differs: Metro computes a number of samples per triangle and rounds it; here every sample represents the
//! same area.
//!
//! Cost: O(n log n) for the trees of n triangles, then O(log n) per sample; no sample is stored. Results
//! are the same for any number of threads and on every machine.

use std::borrow::Cow;
use std::ops::Range;

use crate::setters::setters;
use crate::{Cancelled, Progress, ProgressFn, ignore_progress};
use glam::DVec3;

use super::surface_samples::{CHUNK_SIZE, Strata, SurfaceSamples, low_discrepancy_point, map_chunks};
use super::{IndexedMesh, MeshError, TriangleTree};

/// Number of chunks that each thread measures between two calls of the progress callback: some 50 ms.
const CHUNKS_PER_REPORT: usize = 8;

/// Options of [`surface_distance`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DistanceOptions {
    /// Number of area samples on each of the two surfaces, at least 1; default 500,000. All vertices, and a
    /// quarter as many points on edges, are measured in addition.
    pub sample_count: usize,
    /// Offsets the sample points; default 0. The results of two seeds differ by the sampling error.
    pub seed: u64,
}

impl Default for DistanceOptions {
    fn default() -> Self {
        Self { sample_count: 500_000, seed: 0 }
    }
}

impl DistanceOptions {
    setters! {
        with_sample_count, sample_count: usize;
        with_seed, seed: u64;
    }
}

/// Distances from the samples of one surface to the other surface, in mesh units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OneSidedDistance {
    /// Maximum over vertices, edges and area.
    pub max: f64,
    /// Root mean square over the area.
    pub rms: f64,
    /// Mean over the area.
    pub mean: f64,
}

/// Result of [`surface_distance`], in mesh units (not relative to the diagonal).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceDistance {
    /// From the first mesh to the second.
    pub a_to_b: OneSidedDistance,
    /// From the second mesh to the first.
    pub b_to_a: OneSidedDistance,
    /// Larger of the two one-sided maxima: the Hausdorff distance, as far as the samples capture it.
    pub max: f64,
    /// Larger of the two one-sided RMS values, as Metro reports it.
    pub rms: f64,
    /// Larger of the two one-sided means.
    pub mean: f64,
    /// Diagonal of the bounds of the first mesh, for computing relative distances.
    pub diagonal: f64,
    /// Number of points measured, both directions together.
    pub sample_count: usize,
}

/// Why no distance can be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DistanceError {
    /// A mesh is inconsistent.
    #[error("the {which} mesh: {source}")]
    Mesh {
        /// `first` or `second`.
        which: &'static str,
        /// Defect of the mesh.
        source: MeshError,
    },
    /// A mesh has no triangles.
    #[error("the {which} mesh has no triangle to measure a distance to")]
    Empty {
        /// `first` or `second`.
        which: &'static str,
    },
    /// The sample count is 0.
    #[error("the sample count is 0, but must be at least 1")]
    NoSamples,
    /// The progress callback asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Measures the distance between two surfaces in both directions.
///
/// ```
/// use striata::mesh::{DistanceOptions, IndexedMesh, surface_distance};
/// let at = |z| IndexedMesh::new(vec![[0., 0., z], [1., 0., z], [0., 1., z]], vec![[0, 1, 2]]);
/// let options = DistanceOptions::default().with_sample_count(1_000);
/// let distance = surface_distance(&at(0.0), &at(0.5), &options)?;
/// assert_eq!((distance.max, distance.rms), (0.5, 0.5));
/// # Ok::<(), striata::mesh::DistanceError>(())
/// ```
///
/// # Errors
/// [`DistanceError`] if a mesh is inconsistent or has no triangles, or if the sample count is 0.
pub fn surface_distance(
    a: &IndexedMesh,
    b: &IndexedMesh,
    options: &DistanceOptions,
) -> Result<SurfaceDistance, DistanceError> {
    surface_distance_with_progress(a, b, options, &mut ignore_progress)
}

/// Runs [`surface_distance`] and reports progress in samples; the callback can cancel.
///
/// # Errors
/// See [`surface_distance`]; also [`DistanceError::Cancelled`] if the callback cancels.
pub fn surface_distance_with_progress(
    a: &IndexedMesh,
    b: &IndexedMesh,
    options: &DistanceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<SurfaceDistance, DistanceError> {
    if options.sample_count == 0 {
        return Err(DistanceError::NoSamples);
    }
    let mut meter = Meter { progress, done: 0, total: 0 };
    meter.report()?;
    let b = &*with_origin(b, a.origin);
    let tree_a = surface_tree(a, "first")?;
    let tree_b = surface_tree(b, "second")?;
    let from_a = SurfaceSamples::new(a, options.sample_count, options.seed);
    let from_b = SurfaceSamples::new(b, options.sample_count, options.seed);
    let sample_count = from_a.point_count() + from_b.point_count();
    meter.total = sample_count as u64;
    let a_to_b = from_a.measure(&tree_b, &mut meter)?;
    let b_to_a = from_b.measure(&tree_a, &mut meter)?;
    Ok(SurfaceDistance {
        a_to_b,
        b_to_a,
        max: a_to_b.max.max(b_to_a.max),
        rms: a_to_b.rms.max(b_to_a.rms),
        mean: a_to_b.mean.max(b_to_a.mean),
        diagonal: a.diagonal(),
        sample_count,
    })
}

/// The progress of a measurement, in samples.
struct Meter<'a, 'p> {
    progress: &'a mut ProgressFn<'p>,
    done: u64,
    total: u64,
}

impl Meter<'_, '_> {
    fn report(&mut self) -> Result<(), Cancelled> {
        Progress { phase: "measure", done: self.done, total: self.total }.report(self.progress)
    }
}

/// Returns a mesh relative to an origin, so that two meshes can be compared.
fn with_origin(mesh: &IndexedMesh, origin: [f64; 3]) -> Cow<'_, IndexedMesh> {
    let mut mesh = Cow::Borrowed(mesh);
    if mesh.origin != origin {
        mesh.to_mut().set_origin(origin);
    }
    mesh
}

fn surface_tree(mesh: &IndexedMesh, which: &'static str) -> Result<TriangleTree, DistanceError> {
    let tree = TriangleTree::new(mesh).map_err(|source| DistanceError::Mesh { which, source })?;
    if mesh.triangles.is_empty() { Err(DistanceError::Empty { which }) } else { Ok(tree) }
}

impl SurfaceSamples<'_> {
    /// Measures all samples. Means are over the area or, if the area is 0, over the edges or else the
    /// vertices.
    fn measure(&self, tree: &TriangleTree, meter: &mut Meter<'_, '_>) -> Result<OneSidedDistance, Cancelled> {
        let vertices = sum_chunks(self.used_vertices.len(), meter, |range, sums| {
            let mut hint = usize::MAX;
            for &v in &self.used_vertices[range] {
                sums.add(tree.distance_within(
                    self.mesh.positions[v as usize].map(f64::from),
                    0.0,
                    &mut hint,
                ));
            }
        })?;
        let sides = self.measure_strata(&self.sides, tree, meter, |t, [u, _]| self.point_on_side(t, u))?;
        let areas = self.measure_strata(&self.areas, tree, meter, |t, uv| self.point_on_triangle(t, uv))?;
        let means = [areas, sides, vertices].into_iter().find(|s| s.count > 0).unwrap_or_default();
        let count = means.count.max(1) as f64;
        Ok(OneSidedDistance {
            max: vertices.max.max(sides.max).max(areas.max),
            rms: (means.squares / count).sqrt(),
            mean: means.sum / count,
        })
    }

    fn measure_strata(
        &self,
        strata: &Strata,
        tree: &TriangleTree,
        meter: &mut Meter<'_, '_>,
        point: impl Fn(usize, [f64; 2]) -> DVec3 + Sync,
    ) -> Result<Sums, Cancelled> {
        sum_chunks(strata.count(), meter, |range, sums| {
            let mut hint = usize::MAX;
            for (k, t) in strata.samples(range) {
                sums.add(tree.distance_within(
                    point(t, low_discrepancy_point(self.seed, k)).to_array(),
                    0.0,
                    &mut hint,
                ));
            }
        })
    }
}

#[derive(Clone, Copy, Default)]
struct Sums {
    count: usize,
    max: f64,
    sum: f64,
    squares: f64,
}

impl Sums {
    fn add(&mut self, distance: f64) {
        self.count += 1;
        self.max = self.max.max(distance);
        self.sum += distance;
        self.squares += distance * distance;
    }

    fn join(self, other: Self) -> Self {
        Self {
            count: self.count + other.count,
            max: self.max.max(other.max),
            sum: self.sum + other.sum,
            squares: self.squares + other.squares,
        }
    }
}

/// Accumulates `0..count` in chunks and joins the chunks in order, on several threads if enabled.
fn sum_chunks(
    count: usize,
    meter: &mut Meter<'_, '_>,
    measure: impl Fn(Range<usize>, &mut Sums) + Sync,
) -> Result<Sums, Cancelled> {
    let mut total = Sums::default();
    let step = CHUNK_SIZE * CHUNKS_PER_REPORT * thread_count();
    for start in (0..count).step_by(step) {
        meter.report()?;
        let end = count.min(start.saturating_add(step));
        let chunks = map_chunks(start..end, |range| {
            let mut sums = Sums::default();
            measure(range, &mut sums);
            sums
        });
        total = chunks.into_iter().fold(total, Sums::join);
        meter.done += (end - start) as u64;
    }
    Ok(total)
}

fn thread_count() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "parallel"))]
    1
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use super::*;

    fn square(z: f32) -> IndexedMesh {
        let positions = vec![[0., 0., z], [2., 0., z], [2., 2., z], [0., 2., z]];
        IndexedMesh::new(positions, vec![[0, 1, 2], [0, 2, 3]])
    }

    #[test]
    fn a_missing_half_is_seen_in_one_direction_only() {
        let mut half = square(0.0);
        half.triangles.pop();
        let d = surface_distance(&square(0.0), &half, &DistanceOptions::default()).unwrap();
        assert_eq!(d.b_to_a, OneSidedDistance::default());
        assert!((d.a_to_b.max - 2f64.sqrt()).abs() < 1e-12);
        // Over the missing half, the distance h to the diagonal has the density 2 (c - h) / c^2, c = sqrt 2.
        assert!((d.a_to_b.mean - 0.5 * 2f64.sqrt() / 3.0).abs() < 1e-4);
        assert!((d.a_to_b.rms - (0.5f64 * 2.0 / 6.0).sqrt()).abs() < 1e-4);
        assert_eq!((d.max, d.rms), (d.a_to_b.max, d.a_to_b.rms));
    }

    #[test]
    fn surfaces_without_area_are_measured_by_edges_then_vertices() {
        let line = |z| IndexedMesh::new(vec![[0., 0., z], [1., 0., z], [4., 0., z]], vec![[0, 1, 2]]);
        let point = |z| IndexedMesh::new(vec![[0., 0., z]], vec![[0, 0, 0]]);
        for (a, b) in [(line(0.0), line(3.0)), (point(0.0), point(3.0))] {
            let d = surface_distance(&a, &b, &DistanceOptions::default().with_sample_count(100)).unwrap();
            assert_eq!((d.max, d.rms, d.mean), (3.0, 3.0, 3.0));
        }
        let d = surface_distance(&line(0.0), &point(0.0), &DistanceOptions::default()).unwrap();
        assert!((d.a_to_b.mean - 2.0).abs() < 1e-3);
    }

    #[test]
    fn errors_say_which_mesh_is_bad() {
        let measure = |a: &_, b: &_| surface_distance(a, b, &DistanceOptions::default());
        let empty = IndexedMesh::default();
        assert_eq!(measure(&square(0.), &empty), Err(DistanceError::Empty { which: "second" }));
        let mut broken = square(0.0);
        broken.positions[1][2] = f32::NAN;
        let error = measure(&broken, &square(0.0)).unwrap_err();
        assert_eq!(error.to_string(), "the first mesh: vertex 1 has the coordinate NaN on axis 2");
        let none = DistanceOptions::default().with_sample_count(0);
        assert_eq!(surface_distance(&empty, &empty, &none), Err(DistanceError::NoSamples));
    }

    #[test]
    fn the_callback_can_cancel() {
        let options = DistanceOptions::default().with_sample_count(1 << 40);
        let mut calls = 0;
        let stopped = surface_distance_with_progress(&square(0.0), &square(1.0), &options, &mut |now| {
            assert!(now.phase == "measure" && now.done <= now.total);
            calls += 1;
            if calls < 4 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        assert_eq!((stopped, calls), (Err(DistanceError::Cancelled(Cancelled)), 4));
    }

    #[test]
    fn precision_holds_far_from_the_origin() {
        let moved = |z: f32| {
            let mut mesh = square(z);
            mesh.positions.iter_mut().for_each(|p| *p = [p[0] + 1e7, p[1] - 1e7, p[2] + 8e6]);
            mesh
        };
        let d = surface_distance(&moved(0.0), &moved(0.5), &DistanceOptions::default()).unwrap();
        assert!((d.max - 0.5).abs() < 1e-8 && (d.rms - 0.5).abs() < 1e-8, "{d:?}");
    }
}
