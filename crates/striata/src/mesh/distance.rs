//! Surface distance between two meshes by sampling, what Metro measures \[CRS98\].
//!
//! Points are spread over one surface and each is measured against the whole other surface, then the
//! other way round: one way alone does not see what is missing. Samples are stratified by area: sample `k` of
//! `n` lies where the running area passes `k / n`, and inside its triangle at the next point of a
//! low-discrepancy sequence, so figures converge like a grid's and not like noise. All vertices and a
//! share of points on the sides count for the maximum only, since that is where maxima lie.
//!
//! Differs: Metro draws a number of samples per triangle and rounds it; here every sample stands for the same area.
//!
//! Cost: O(n log n) for the trees of n triangles, then O(log n) a sample; no sample is stored. Results depend
//! neither on threads nor on the machine.

use crate::setters::setters;
use glam::DVec3;

use super::surface_samples::{Samples, Strata, in_chunks, spread};
use super::triangle_tree::exact;
use super::{IndexedMesh, MeshError, TriangleTree};

/// Options of [`surface_distance`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DistanceOptions {
    /// Area samples on each of the two surfaces, at least 1; default 500,000. Vertices, and a quarter as
    /// many points on sides, come on top.
    pub sample_count: usize,
    /// Shifts where samples lie; default 0. Two seeds differ by the error of sampling.
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

/// Distances of the samples of one surface to the other surface, mesh units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OneSided {
    /// The largest, over vertices, sides and area.
    pub max: f64,
    /// Root of the mean square over the area.
    pub rms: f64,
    /// Mean over the area.
    pub mean: f64,
}

/// What [`surface_distance`] measures; mesh units, not shares of the diagonal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceDistance {
    /// From the first mesh to the second.
    pub a_to_b: OneSided,
    /// From the second mesh to the first.
    pub b_to_a: OneSided,
    /// The larger one-sided maximum: the Hausdorff distance, as far as samples see it.
    pub max: f64,
    /// The larger one-sided RMS, as Metro reports it.
    pub rms: f64,
    /// The larger one-sided mean.
    pub mean: f64,
    /// Diagonal of the bounds of the first mesh, to divide by.
    pub diagonal: f64,
    /// Points measured, both ways together.
    pub sample_count: usize,
}

/// Why no distance can be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DistanceError {
    /// A mesh does not hang together.
    #[error("the {which} mesh: {source}")]
    Mesh {
        /// `first` or `second`.
        which: &'static str,
        /// What is wrong with it.
        source: MeshError,
    },
    /// A mesh has no surface.
    #[error("the {which} mesh has no triangle to measure a distance to")]
    Empty {
        /// `first` or `second`.
        which: &'static str,
    },
    /// No samples were asked for.
    #[error("the sample count is 0, but must be at least 1")]
    NoSamples,
}

/// Measures how far two surfaces are from each other, both ways.
///
/// ```
/// use striata::mesh::{DistanceOptions, IndexedMesh, surface_distance};
/// let at = |z| IndexedMesh::new(vec![[0., 0., z], [1., 0., z], [0., 1., z]], vec![[0, 1, 2]]);
/// let distance = surface_distance(&at(0.0), &at(0.5), &DistanceOptions::default().with_sample_count(1_000))?;
/// assert_eq!((distance.max, distance.rms), (0.5, 0.5));
/// # Ok::<(), striata::mesh::DistanceError>(())
/// ```
///
/// # Errors
/// [`DistanceError`] where a mesh is inconsistent or without triangles, or no sample is asked for.
pub fn surface_distance(
    a: &IndexedMesh,
    b: &IndexedMesh,
    options: &DistanceOptions,
) -> Result<SurfaceDistance, DistanceError> {
    if options.sample_count == 0 {
        return Err(DistanceError::NoSamples);
    }
    let tree_a = surface_tree(a, "first")?;
    let tree_b = surface_tree(b, "second")?;
    let from_a = Samples::new(a, options.sample_count, options.seed);
    let from_b = Samples::new(b, options.sample_count, options.seed);
    let a_to_b = from_a.measure(&tree_b);
    let b_to_a = from_b.measure(&tree_a);
    Ok(SurfaceDistance {
        a_to_b,
        b_to_a,
        max: a_to_b.max.max(b_to_a.max),
        rms: a_to_b.rms.max(b_to_a.rms),
        mean: a_to_b.mean.max(b_to_a.mean),
        diagonal: a.diagonal(),
        sample_count: from_a.point_count() + from_b.point_count(),
    })
}

fn surface_tree(mesh: &IndexedMesh, which: &'static str) -> Result<TriangleTree, DistanceError> {
    let tree = TriangleTree::new(mesh).map_err(|source| DistanceError::Mesh { which, source })?;
    if mesh.triangles.is_empty() { Err(DistanceError::Empty { which }) } else { Ok(tree) }
}

impl Samples<'_> {
    /// The mean is taken over the area; over the sides where there is no area; else over the vertices.
    fn measure(&self, tree: &TriangleTree) -> OneSided {
        let vertices = sum_chunks(self.used_vertices.len(), |range, sums| {
            let mut hint = usize::MAX;
            for &v in &self.used_vertices[range] {
                sums.add(tree.distance_from_hint(exact(self.mesh.positions[v as usize]), &mut hint));
            }
        });
        let sides = self.measure_strata(&self.sides, tree, |t, [u, _]| self.point_on_side(t, u));
        let areas = self.measure_strata(&self.areas, tree, |t, uv| self.point_on_triangle(t, uv));
        let means = [areas, sides, vertices].into_iter().find(|s| s.count > 0).unwrap_or_default();
        let count = means.count.max(1) as f64;
        OneSided {
            max: vertices.max.max(sides.max).max(areas.max),
            rms: (means.squares / count).sqrt(),
            mean: means.sum / count,
        }
    }

    fn measure_strata(
        &self,
        strata: &Strata,
        tree: &TriangleTree,
        point: impl Fn(usize, [f64; 2]) -> DVec3 + Sync,
    ) -> Sums {
        sum_chunks(strata.count(), |range, sums| {
            let mut hint = usize::MAX;
            strata.for_each(range, |k, t| {
                sums.add(tree.distance_from_hint(point(t, spread(self.seed, k)), &mut hint));
            });
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

/// Sums `0..count` chunk by chunk and joins the chunks in order, with or without threads.
fn sum_chunks(count: usize, measure: impl Fn(std::ops::Range<usize>, &mut Sums) + Sync) -> Sums {
    let chunks = in_chunks(count, |range| {
        let mut sums = Sums::default();
        measure(range, &mut sums);
        sums
    });
    chunks.into_iter().fold(Sums::default(), Sums::join)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(z: f32) -> IndexedMesh {
        let positions = vec![[0., 0., z], [2., 0., z], [2., 2., z], [0., 2., z]];
        IndexedMesh::new(positions, vec![[0, 1, 2], [0, 2, 3]])
    }

    #[test]
    fn a_missing_half_shows_one_way_only() {
        let mut half = square(0.0);
        half.triangles.pop();
        let d = surface_distance(&square(0.0), &half, &DistanceOptions::default()).unwrap();
        assert_eq!(d.b_to_a, OneSided::default());
        assert!((d.a_to_b.max - 2f64.sqrt()).abs() < 1e-12);
        // Over the missing half the distance h to the diagonal has density 2 (c - h) / c^2, c = sqrt 2.
        assert!((d.a_to_b.mean - 0.5 * 2f64.sqrt() / 3.0).abs() < 1e-4);
        assert!((d.a_to_b.rms - (0.5f64 * 2.0 / 6.0).sqrt()).abs() < 1e-4);
        assert_eq!((d.max, d.rms), (d.a_to_b.max, d.a_to_b.rms));
    }

    #[test]
    fn surfaces_without_area_are_measured_by_sides_then_points() {
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
    fn errors_name_the_mesh() {
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
    fn far_from_the_origin_nothing_is_lost() {
        let moved = |z: f32| {
            let mut mesh = square(z);
            mesh.positions.iter_mut().for_each(|p| *p = [p[0] + 1e7, p[1] - 1e7, p[2] + 8e6]);
            mesh
        };
        let d = surface_distance(&moved(0.0), &moved(0.5), &DistanceOptions::default()).unwrap();
        assert!((d.max - 0.5).abs() < 1e-8 && (d.rms - 0.5).abs() < 1e-8, "{d:?}");
    }
}
