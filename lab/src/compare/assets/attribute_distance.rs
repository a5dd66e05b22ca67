//! Differences of normals and texture coordinates between a simplified mesh and the original.
//!
//! Sample points are spread over the original surface by area. Each is compared with the nearest point of
//! the other surface *on the same side*: on a triangle whose normal is within about 73 degrees (a dot
//! product above 0.3) of the normal of the sample's own triangle. Without that rule, samples on one sheet
//! of a thin part would be compared with the other sheet, whose texture coordinates mean something else.
//!
//! A triangle on the same side counts if it is no farther away than four times the distance of the nearest
//! triangle plus 1 % of the diagonal; if there is none, the nearest triangle on any side is used. If several
//! triangles are equally near, as on both sides of a seam, the one with the smallest difference counts.
//!
//! Cost: O(n log n) for a tree of n triangles, then O(log n) expected and 8 bytes for each sample. Results
//! are the same for any number of threads and on every machine.

use glam::DVec3;
use striata::mesh::{
    AttributeLayer, DistanceError, DistanceOptions, IndexedMesh, Semantic, SurfaceSample, SurfaceSamples,
    TriangleTree,
};

/// Smallest dot product of two unit normals that count as being on the same side.
const SAME_SIDE: f64 = 0.3;

/// Multiple of the distance to the nearest triangle up to which triangles on the same side count, with
/// [`REACH_SHARE`] added.
const REACH: f64 = 4.0;

/// Addition to that reach, as a fraction of the diagonal of the original.
const REACH_SHARE: f64 = 0.01;

/// Triangles are equally near if their distances differ by at most this fraction of the diagonal.
const TIE_SHARE: f64 = 1e-6;

/// Mean and 95th percentile of the differences of one attribute.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct AttributeSpread {
    /// Mean, weighted by area.
    pub mean: f64,
    /// Value that 95 % of the area does not exceed.
    pub percentile_95: f64,
}

/// Result of [`attribute_distance`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct AttributeDistance {
    /// Angles between interpolated normals, in radians; `None` if either mesh has no normals.
    pub normal: Option<AttributeSpread>,
    /// Distances between texture coordinates of set 0, in UV units (1 is the width of the texture); `None`
    /// if either mesh has none.
    pub uv: Option<AttributeSpread>,
    /// Fraction of the samples for which a triangle on the same side was within reach.
    pub same_side_share: f64,
}

/// Measures how far the normals and texture coordinates of `level` differ from those of `original`.
///
/// # Errors
/// [`DistanceError`] if a mesh is inconsistent or has no triangles, or if the sample count is 0.
pub(super) fn attribute_distance(
    original: &IndexedMesh,
    level: &IndexedMesh,
    options: &DistanceOptions,
) -> Result<AttributeDistance, DistanceError> {
    if options.sample_count == 0 {
        return Err(DistanceError::NoSamples);
    }
    let check = |mesh: &IndexedMesh, which| match mesh.check() {
        Err(source) => Err(DistanceError::Mesh { which, source }),
        Ok(()) if mesh.triangles.is_empty() => Err(DistanceError::Empty { which }),
        Ok(()) => Ok(()),
    };
    check(original, "first")?;
    check(level, "second")?;
    let tree = TriangleTree::new(level).map_err(|source| DistanceError::Mesh { which: "second", source })?;
    let comparison = Comparison {
        samples: SurfaceSamples::new(original, options.sample_count, options.seed),
        original: TriangleAttributes::of(original),
        level: TriangleAttributes::of(level),
        tree,
        diagonal: original.diagonal(),
    };
    Ok(comparison.measure())
}

/// The attributes of one mesh, by triangle and by point.
struct TriangleAttributes<'a> {
    mesh: &'a IndexedMesh,
    /// Unit normal of each triangle; zero for triangles without area.
    triangle_normals: Vec<DVec3>,
    normals: Option<&'a AttributeLayer>,
    uvs: Option<&'a AttributeLayer>,
}

impl<'a> TriangleAttributes<'a> {
    fn of(mesh: &'a IndexedMesh) -> Self {
        let triangle_normals = mesh.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| to_dvec3(mesh.positions[v as usize]));
            (b - a).cross(c - a).normalize_or_zero()
        });
        let layer = |semantic, least| mesh.layer(&semantic).filter(|layer| layer.component_count >= least);
        Self {
            mesh,
            triangle_normals: triangle_normals.collect(),
            normals: layer(Semantic::Normal, 3),
            uvs: layer(Semantic::TexCoord(0), 2),
        }
    }

    /// Unit normal at a point of a triangle; the triangle's own normal if those of its corners cancel out.
    fn normal(&self, triangle: usize, weights: [f64; 3]) -> Option<DVec3> {
        let layer = self.normals?;
        let sum = self.mix(layer, triangle, weights);
        Some(sum.try_normalize().unwrap_or(self.triangle_normals[triangle]))
    }

    fn uv(&self, triangle: usize, weights: [f64; 3]) -> Option<DVec3> {
        self.uvs.map(|layer| self.mix(layer, triangle, weights))
    }

    /// Interpolates up to three components of a layer at a point of a triangle.
    fn mix(&self, layer: &AttributeLayer, triangle: usize, weights: [f64; 3]) -> DVec3 {
        let count = usize::from(layer.component_count).min(3);
        let corner = |v: u32| {
            let mut value = [0.0; 3];
            (0..count).for_each(|k| value[k] = f64::from(layer.get(v as usize, k)));
            DVec3::from_array(value)
        };
        let corners = self.mesh.triangles[triangle].map(corner);
        weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2]
    }
}

/// Differences measured at some samples, in the order of the samples.
#[derive(Default)]
struct Differences {
    angles: Vec<f32>,
    uvs: Vec<f32>,
    sample_count: usize,
    same_side_count: usize,
}

/// The data of one measurement.
struct Comparison<'a> {
    samples: SurfaceSamples<'a>,
    original: TriangleAttributes<'a>,
    level: TriangleAttributes<'a>,
    tree: TriangleTree,
    diagonal: f64,
}

impl Comparison<'_> {
    fn measure(&self) -> AttributeDistance {
        let chunks = self.samples.map_area_chunks(|samples| {
            let mut found = Differences::default();
            let (mut hint, mut triangles) = (usize::MAX, Vec::new());
            for sample in samples {
                found.same_side_count += usize::from(self.find_nearest(&sample, &mut hint, &mut triangles));
                found.sample_count += 1;
                self.compare(&sample, &triangles, &mut found);
            }
            found
        });
        let count = |of: fn(&Differences) -> usize| chunks.iter().map(of).sum::<usize>();
        let sample_count = count(|chunk| chunk.sample_count).max(1);
        let same_side_count = count(|chunk| chunk.same_side_count);
        AttributeDistance {
            normal: AttributeSpread::of(chunks.iter().flat_map(|chunk| &chunk.angles).copied().collect()),
            uv: AttributeSpread::of(chunks.iter().flat_map(|chunk| &chunk.uvs).copied().collect()),
            same_side_share: same_side_count as f64 / sample_count as f64,
        }
    }

    /// Finds the triangles of the level to compare a sample with; returns whether they are on the same side.
    fn find_nearest(&self, sample: &SurfaceSample, hint: &mut usize, found: &mut Vec<usize>) -> bool {
        let point = sample.point;
        let own_normal = self.original.triangle_normals[sample.triangle];
        let is_same_side =
            |candidate: usize| self.level.triangle_normals[candidate].dot(own_normal) > SAME_SIDE;
        let nearest_distance = self.tree.distance_from_hint(point, hint);
        let reach = REACH * nearest_distance + REACH_SHARE * self.diagonal;
        let mut nearest = if is_same_side(*hint) { nearest_distance } else { f64::INFINITY };
        if nearest == f64::INFINITY {
            self.tree.visit_within(point, reach, |candidate, distance| {
                if distance < nearest && is_same_side(candidate) {
                    nearest = distance;
                }
                nearest.min(reach)
            });
        }
        let has_same_side = nearest <= reach;
        let limit = if has_same_side { nearest } else { nearest_distance } + TIE_SHARE * self.diagonal;
        found.clear();
        self.tree.visit_within(point, limit, |candidate, distance| {
            if distance <= limit && (!has_same_side || is_same_side(candidate)) {
                found.push(candidate);
            }
            limit
        });
        has_same_side
    }

    fn compare(&self, sample: &SurfaceSample, triangles: &[usize], found: &mut Differences) {
        let SurfaceSample { point, triangle: own, weights } = *sample;
        let point = DVec3::from_array(point);
        let (mut angle, mut distance) = (None::<f64>, None::<f64>);
        let lower =
            |least: &mut Option<f64>, value: f64| *least = Some(least.map_or(value, |x| x.min(value)));
        let (own_normal, own_uv) = (self.original.normal(own, weights), self.original.uv(own, weights));
        for &triangle in triangles {
            let corners =
                self.level.mesh.triangles[triangle].map(|v| to_dvec3(self.level.mesh.positions[v as usize]));
            let weights = nearest_weights(point, corners);
            if let (Some(a), Some(b)) = (own_normal, self.level.normal(triangle, weights)) {
                lower(&mut angle, angle_between(a, b));
            }
            if let (Some(a), Some(b)) = (own_uv, self.level.uv(triangle, weights)) {
                lower(&mut distance, (a - b).truncate().length());
            }
        }
        found.angles.extend(angle.map(|x| x as f32));
        found.uvs.extend(distance.map(|x| x as f32));
    }
}

impl AttributeSpread {
    /// Mean and 95th percentile of some values; `None` if there are no values.
    fn of(mut values: Vec<f32>) -> Option<Self> {
        let count = values.len();
        let mean = values.iter().map(|&x| f64::from(x)).sum::<f64>() / count.max(1) as f64;
        let last = (count * 19).div_ceil(20).checked_sub(1)?;
        let (_, &mut percentile, _) = values.select_nth_unstable_by(last, f32::total_cmp);
        Some(Self { mean, percentile_95: f64::from(percentile) })
    }
}

/// Barycentric coordinates of the point of a triangle that is nearest to another point.
pub(super) fn nearest_weights(point: DVec3, [a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(ac);
    let area = normal.length_squared();
    let inside = [(b, c), (c, a), (a, b)].map(|(p, q)| normal.dot((q - p).cross(point - p)) / area);
    if area > 0.0 && inside.iter().all(|&weight| weight >= 0.0) {
        return inside;
    }
    let along = |from: DVec3, to: DVec3| {
        let length = (to - from).length_squared();
        if length > 0.0 { ((point - from).dot(to - from) / length).clamp(0.0, 1.0) } else { 0.0 }
    };
    let (s, t, u) = (along(a, b), along(b, c), along(c, a));
    let sides = [[1.0 - s, s, 0.0], [0.0, 1.0 - t, t], [u, 0.0, 1.0 - u]];
    let distance = |w: &[f64; 3]| (w[0] * a + w[1] * b + w[2] * c - point).length_squared();
    let nearest = sides.into_iter().min_by(|p, q| distance(p).total_cmp(&distance(q)));
    nearest.unwrap_or([1.0, 0.0, 0.0])
}

/// Angle between two unit vectors, 0 to pi.
///
/// It uses correctly rounded operations only, since the inverse trigonometric functions of a platform may
/// differ in the last bit.
fn angle_between(a: DVec3, b: DVec3) -> f64 {
    let (across, along) = ((a - b).length(), (a + b).length());
    // A quarter of the angle is at most pi / 4; two further halvings bring its tangent below 0.2.
    let quarter = across / ((across * across + along * along).sqrt() + along).max(f64::MIN_POSITIVE);
    let halved = |x: f64| x / (1.0 + (1.0 + x * x).sqrt());
    let x = halved(halved(quarter));
    let term = |k: i32| (1 - 2 * (k % 2)) as f64 / f64::from(2 * k + 1);
    let series = (0..8).rev().fold(0.0, |sum, k| sum * x * x + term(k));
    16.0 * x * series
}

/// Converts a position to f64, which is exact.
fn to_dvec3(position: [f32; 3]) -> DVec3 {
    DVec3::from_array(position.map(f64::from))
}

#[cfg(test)]
mod tests {
    use striata::mesh::{LayerData, shapes};

    use super::*;

    /// A unit square at height `z`, with normals along z and texture coordinates shifted by `u`.
    fn square(z: f32, u: f32) -> IndexedMesh {
        let corners = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]];
        let mut mesh =
            IndexedMesh::new(corners.iter().map(|&[x, y]| [x, y, z]).collect(), vec![[0, 1, 2], [0, 2, 3]]);
        let uvs = corners.iter().flat_map(|&[x, y]| [x + u, y]).collect();
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, [0., 0., 1.].repeat(4)));
        mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs));
        mesh
    }

    fn turned_over(mut mesh: IndexedMesh) -> IndexedMesh {
        mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        mesh
    }

    fn joined(a: IndexedMesh, b: &IndexedMesh) -> IndexedMesh {
        let first = a.vertex_count() as u32;
        let mut mesh = a;
        mesh.positions.extend(&b.positions);
        mesh.triangles.extend(b.triangles.iter().map(|t| t.map(|v| v + first)));
        for (layer, other) in mesh.layers.iter_mut().zip(&b.layers) {
            if let (LayerData::F32(into), LayerData::F32(from)) = (&mut layer.data, &other.data) {
                into.extend(from);
            }
        }
        mesh
    }

    fn measured(a: &IndexedMesh, b: &IndexedMesh) -> AttributeDistance {
        attribute_distance(a, b, &DistanceOptions::default().with_sample_count(10_000)).unwrap()
    }

    #[test]
    fn samples_of_similar_spheres_are_on_the_same_side() {
        let found = measured(&shapes::icosphere(4, 1.0), &shapes::icosphere(2, 1.0));
        assert_eq!((found.same_side_share, found.uv), (1.0, None));
    }

    #[test]
    fn uv_shifts_are_measured() {
        let found = measured(&square(0.0, 0.0), &square(0.25, 0.125));
        let uv = found.uv.unwrap();
        assert!((uv.mean - 0.125).abs() < 1e-6 && (uv.percentile_95 - 0.125).abs() < 1e-6, "{uv:?}");
        assert!(found.normal.unwrap().mean < 1e-7);
        assert_eq!(found.same_side_share, 1.0);
    }

    #[test]
    fn samples_are_not_compared_with_the_opposite_sheet() {
        // The surface is unchanged, but the upper sheet of the level lies below the lower one of the
        // original.
        let original = joined(square(0.01, 0.0), &turned_over(square(0.0, 0.5)));
        let level = joined(square(0.001, 0.0), &turned_over(square(0.009, 0.5)));
        let uv = measured(&original, &level).uv.unwrap();
        assert!(uv.percentile_95 < 1e-6, "{uv:?}");
        // With only one sheet left, the samples of the other one must use it: half of them are off by 0.5.
        let found = measured(&original, &square(0.01, 0.0));
        assert!((found.uv.unwrap().mean - 0.25).abs() < 1e-3 && (found.same_side_share - 0.5).abs() < 1e-3);
    }

    #[test]
    fn normals_differ_by_their_angle() {
        let mut level = square(0.0, 0.0);
        let normals = [0.0, 0.6, 0.8].repeat(4);
        level.layers[0] = AttributeLayer::from_f32(Semantic::Normal, 3, normals);
        let normal = measured(&square(0.0, 0.0), &level).normal.unwrap();
        assert!(
            (normal.mean - 0.6f64.asin()).abs() < 1e-6 && (normal.percentile_95 - normal.mean).abs() < 1e-6
        );
    }

    #[test]
    fn a_seam_is_compared_with_its_better_side() {
        // A roof whose two sides have separate charts, and a strip above its ridge, which is nearest to
        // both sides.
        let bent = |mut mesh: IndexedMesh, slope: f32, u: f32| {
            mesh.positions.iter_mut().for_each(|p| *p = [p[0] - u, p[1], slope * (p[0] - u)]);
            mesh
        };
        let (left, right) = (bent(square(0.0, 7.0), 1.0, 1.0), bent(square(0.0, 0.0), -1.0, 0.0));
        let mut strip = square(0.0, 0.0);
        strip.positions.iter_mut().for_each(|p| *p = [0.01 * p[0], p[1], 0.5]);
        for level in [joined(left.clone(), &right), joined(right, &left)] {
            let found = measured(&strip, &level).uv.unwrap();
            // The strip covers its whole chart, but the ridge is only one edge of that chart.
            assert!((found.mean - 0.5).abs() < 1e-3, "{found:?}");
        }
    }

    #[test]
    fn percentile_95_covers_95_percent_of_the_values() {
        let spread = AttributeSpread::of((1..=100).map(|x| x as f32).collect()).unwrap();
        assert_eq!(spread, AttributeSpread { mean: 50.5, percentile_95: 95.0 });
        assert_eq!(AttributeSpread::of(Vec::new()), None);
        assert_eq!(AttributeSpread::of(vec![3.0]).unwrap().percentile_95, 3.0);
    }

    #[test]
    fn angle_between_matches_the_platform() {
        for k in 0..=64 {
            let angle = f64::from(k) / 64.0 * std::f64::consts::PI;
            let found = angle_between(DVec3::X, DVec3::new(angle.cos(), angle.sin(), 0.0));
            assert!((found - angle).abs() < 1e-10, "{found} for {angle}");
        }
    }

    #[test]
    fn weights_of_the_nearest_point() {
        let corners = [DVec3::ZERO, DVec3::new(4., 0., 0.), DVec3::new(0., 4., 0.)];
        assert_eq!(nearest_weights(DVec3::new(1., 1., 9.), corners), [0.5, 0.25, 0.25]);
        assert_eq!(nearest_weights(DVec3::new(1., -5., 0.), corners), [0.75, 0.25, 0.0]);
        assert_eq!(nearest_weights(DVec3::new(9., 9., 1.), corners), [0.0, 0.5, 0.5]);
        assert_eq!(nearest_weights(DVec3::new(1., 0., 0.), [DVec3::ZERO; 3]), [1.0, 0.0, 0.0]);
    }
}
