//! Squared error that each step of coarsening adds to a mesh, and the order in which several meshes are coarsened.
//!
//! The squared error of a step is the integral of the squared distance that it moves the surface, with the change of
//! attributes as a length: the measure by which the simplifier orders the steps of a single mesh. It is computed from
//! the sequence alone, so files and streams of any age have it. A removed position `p`, with a star of area `A`, comes
//! to lie at the distance `d` from the triangles that replace its star. Distances fall from `d` at `p` to 0 at the
//! border of the star, which makes the integral `A d² / 6`. A step that gives the mesh a larger error than all before it
//! moves its star by that error as a whole, such as a part that vanishes; `A` is then at least the area of the original
//! surface that `p` stands for.
//!
//! Single steps do not show how their errors add up. So some levels are measured from vertices of the full mesh, and
//! the distances of the steps between two of them get the factor that makes their sum the difference.
//!
//! ```text
//!   summed error            x   one step: not convex, if a large part must go early
//!        |          x - x       the hull takes the steps from x to the end as one run
//!        |        /             with one price
//!        |  x - x
//!        +------------- triangles saved
//! ```
//!
//! A price is the error that a run adds for each triangle it saves. The prices of the lower convex hull of a mesh
//! rise, so that always taking the cheapest run of all meshes gives the least summed error for any number of
//! triangles (Everett 1963, Lagrange multipliers for the optimum allocation of resources).

use glam::DVec3;
use striata::mesh::{AttributeLayer, CollapseSequence, IndexedMesh, Semantic, canonical_triangles};
use striata::simplify::AttributeWeights;

use crate::level_walk::{LevelWalk, nearest_shares, point_at};

const NONE: u32 = u32::MAX;
/// Ratio of the steps of one measured level to those of the next finer one.
const LEVEL_RATIO: f64 = 0.5;
/// Number of vertices that are measured in a level, evenly spread over those that it lacks.
const MAX_SAMPLES: usize = 512;

/// Attributes of a mesh as lengths: a difference counts like a distance.
struct Lengths<'m> {
    /// Layers with the length of a difference of 1.
    layers: Vec<(&'m AttributeLayer, f64)>,
}

impl<'m> Lengths<'m> {
    /// `diagonal` is that of the scene, in mesh units.
    fn of(mesh: &'m IndexedMesh, diagonal: f64) -> Self {
        let weights = AttributeWeights::default();
        let weight = |layer: &AttributeLayer| match layer.semantic {
            Semantic::Normal => Some(weights.normal),
            Semantic::TexCoord(0) => Some(weights.texcoord),
            Semantic::Color(0) => Some(weights.color),
            _ => None,
        };
        let layers = mesh.layers.iter();
        let layers = layers.filter_map(|layer| Some((layer, f64::from(weight(layer)?) * diagonal)));
        Self { layers: layers.collect() }
    }

    /// Squared length of the difference between a vertex and a point of a triangle.
    fn squared(&self, vertex: u32, corners: [u32; 3], [x, y]: [f64; 2]) -> f64 {
        let mut sum = 0.0;
        for (layer, length) in &self.layers {
            for component in 0..layer.component_count as usize {
                let value = |v: u32| f64::from(layer.get(v as usize, component));
                let [a, b, c] = corners.map(value);
                let difference = (value(vertex) - (a + x * (b - a) + y * (c - a))) * length;
                sum += difference * difference;
            }
        }
        sum
    }
}

/// Triangles around each position, as lists of corners (3 * triangle + index).
struct MeshCorners {
    corners: Vec<[u32; 3]>,
    position_of: Vec<u32>,
    head: Vec<u32>,
    tail: Vec<u32>,
    next: Vec<u32>,
}

impl MeshCorners {
    fn new(sequence: &CollapseSequence, triangles: &[[u32; 3]]) -> Self {
        let positions = sequence.positions();
        let corners = triangles.to_vec();
        let position_count = positions.position_count();
        let mut position_of = vec![0; positions.vertex_count()];
        for position in 0..position_count as u32 {
            positions.wedges(position).for_each(|vertex| position_of[vertex as usize] = position);
        }
        let next = vec![NONE; 3 * corners.len()];
        let (head, tail) = (vec![NONE; position_count], vec![NONE; position_count]);
        let mut stars = Self { corners, position_of, head, tail, next };
        for corner in 0..stars.next.len() as u32 {
            let position = stars.position_at(corner);
            stars.append(position, corner);
        }
        stars
    }

    fn vertex_at(&self, corner: u32) -> u32 {
        self.corners[corner as usize / 3][corner as usize % 3]
    }

    fn position_at(&self, corner: u32) -> u32 {
        self.position_of[self.vertex_at(corner) as usize]
    }

    fn append(&mut self, position: u32, corner: u32) {
        self.next[corner as usize] = NONE;
        match self.tail[position as usize] {
            NONE => self.head[position as usize] = corner,
            last => self.next[last as usize] = corner,
        }
        self.tail[position as usize] = corner;
    }

    /// Takes the corners of a position whose triangles are left.
    fn take(&mut self, position: u32, star: &mut Vec<u32>) {
        star.clear();
        let mut corner = std::mem::replace(&mut self.head[position as usize], NONE);
        self.tail[position as usize] = NONE;
        while corner != NONE {
            let [a, b, c] = self.corners[corner as usize / 3].map(|v| self.position_of[v as usize]);
            if a != b && b != c && c != a {
                star.push(corner);
            }
            corner = self.next[corner as usize];
        }
    }
}

/// Returns the squared error of each step, from the full mesh to the base, in mesh units to the fourth power.
pub(crate) fn step_errors(mesh: &IndexedMesh, sequence: &CollapseSequence, diagonal: f64) -> Vec<f64> {
    // Sums must not depend on the order of the triangles, which files may change: their last digits would decide between
    // steps that are equal.
    let triangles = canonical_triangles(&mesh.triangles);
    let step_count = sequence.step_count();
    let mut errors = single_errors(mesh, sequence, &triangles, diagonal);
    let (mut finer, mut before) = (step_count, 0.0);
    for (split_count, sum) in measured_sums(mesh, sequence, &triangles) {
        let steps = &mut errors[step_count - finer..step_count - split_count];
        // A level that is better than a finer one adds nothing.
        let added = (sum - before).max(0.0);
        let single: f64 = steps.iter().map(|[distance, _]| distance).sum();
        match added / single {
            factor if factor.is_finite() => steps.iter_mut().for_each(|[distance, _]| *distance *= factor),
            _ => {
                let share = added / steps.len() as f64;
                steps.iter_mut().for_each(|[distance, _]| *distance = share);
            }
        }
        (finer, before) = (split_count, before.max(sum));
    }
    errors.into_iter().map(|[distance, attributes]| distance + attributes).collect()
}

/// Returns the squared distances of some levels, from fine to coarse, each with its split count.
fn measured_sums(
    mesh: &IndexedMesh,
    sequence: &CollapseSequence,
    triangles: &[[u32; 3]],
) -> Vec<(usize, f64)> {
    let mut areas = vec![0.0; mesh.vertex_count()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|v| DVec3::from_array(mesh.positions[v as usize].map(f64::from)));
        let third = (b - a).cross(c - a).length() / 6.0;
        triangle.iter().for_each(|&v| areas[v as usize] += third);
    }
    let mut walk = LevelWalk::default();
    let mut finer = triangles.to_vec();
    let mut sums = Vec::new();
    let mut split_count = sequence.step_count();
    while split_count > 0 {
        split_count = (split_count as f64 * LEVEL_RATIO) as usize;
        walk.move_to(&finer, sequence, split_count);
        finer.clone_from(&walk.triangles);
        let farthest = f64::from(sequence.error_at(split_count)).powi(2);
        let removed = sequence.vertex_count_at(split_count)..mesh.vertex_count();
        let stride = removed.len().div_ceil(MAX_SAMPLES).max(1);
        let samples = removed.step_by(stride).map(|vertex| {
            let squared = walk.nearest(&mesh.positions, vertex as u32, 0.0).unwrap_or(farthest);
            squared * areas[vertex]
        });
        sums.push((split_count, samples.sum::<f64>() * stride as f64));
    }
    sums
}

/// Returns the squared error of each step by itself, as the sequence shows it: of distances and of attributes.
fn single_errors(
    mesh: &IndexedMesh,
    sequence: &CollapseSequence,
    triangles: &[[u32; 3]],
    diagonal: f64,
) -> Vec<[f64; 2]> {
    let lengths = Lengths::of(mesh, diagonal);
    let mut stars = MeshCorners::new(sequence, triangles);
    let mut star = Vec::new();
    let point = |vertex: u32| DVec3::from_array(mesh.positions[vertex as usize].map(f64::from));
    // Area of the original surface that each position stands for.
    let mut areas = vec![0.0; sequence.positions().position_count()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(point);
        let third = (b - a).cross(c - a).length() / 6.0;
        triangle.iter().for_each(|&v| areas[stars.position_of[v as usize] as usize] += third);
    }
    let mut errors = Vec::with_capacity(sequence.step_count());
    for step in (0..sequence.step_count()).rev() {
        let vertices = sequence.step_vertices(step);
        let Some(first) = vertices.clone().next() else {
            errors.push([0.0; 2]);
            continue;
        };
        let (removed, target) = (stars.position_of[first as usize], sequence.target(first));
        stars.take(removed, &mut star);
        let from = point(first);
        let (mut area, mut nearest) = (0.0, [f64::INFINITY, 0.0]);
        for &corner in &star {
            let triangle = stars.corners[corner as usize / 3];
            let [a, b, c] = triangle.map(point);
            area += 0.5 * (b - a).cross(c - a).length();
        }
        let target_position = stars.position_of[target as usize];
        for &corner in &star {
            let (t, k) = (corner as usize / 3, corner as usize % 3);
            let vertex = stars.corners[t][k];
            stars.corners[t][k] = sequence.target(vertex);
            stars.append(target_position, corner);
            let corners = stars.corners[t];
            let [p, q, r] = corners.map(|v| stars.position_of[v as usize]);
            if p == q || q == r || r == p {
                continue;
            }
            let triangle = corners.map(point);
            let shares = nearest_shares(from, triangle);
            let found =
                [from.distance_squared(point_at(triangle, shares)), lengths.squared(vertex, corners, shares)];
            if found[0] + found[1] < nearest[0] + nearest[1] {
                nearest = found;
            }
        }
        if nearest[0] == f64::INFINITY {
            nearest[0] = from.distance_squared(point(target));
        }
        // An error that no step before had counts over the whole star.
        let [before, after] = [step + 1, step].map(|split_count| f64::from(sequence.error_at(split_count)));
        if after > before {
            nearest[0] = nearest[0].max(6.0 * after * after);
        }
        let own = std::mem::take(&mut areas[removed as usize]);
        areas[target_position as usize] += own;
        errors.push(nearest.map(|squared| area.max(3.0 * own) * squared / 6.0));
    }
    errors
}

/// Returns for each step, from the full mesh to the base, the price of its run on the lower convex hull of summed
/// errors. `triangle_counts` are those before the first step and after each.
pub(super) fn prices(errors: &[f64], triangle_counts: impl Fn(usize) -> usize) -> Vec<f64> {
    // Runs of steps: their number, error and saved triangles.
    let mut runs: Vec<(usize, f64, f64)> = Vec::new();
    let price =
        |&(_, error, saved): &(usize, f64, f64)| if saved > 0.0 { error / saved } else { f64::INFINITY };
    for (step, &error) in errors.iter().enumerate() {
        let saved = triangle_counts(step).saturating_sub(triangle_counts(step + 1)) as f64;
        let mut run = (1, if error.is_finite() { error.max(0.0) } else { f64::MAX.sqrt() }, saved);
        while let Some(last) = runs.pop_if(|last| price(last) >= price(&run)) {
            run = (last.0 + run.0, last.1 + run.1, last.2 + run.2);
        }
        runs.push(run);
    }
    runs.iter().flat_map(|run| std::iter::repeat_n(price(run), run.0)).collect()
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;
    use striata::{Lod, LodOptions};

    use super::*;

    #[test]
    fn prices_rise_and_keep_the_sum() {
        // A step that saves nothing goes together with the one after it.
        let (errors, counts) = ([1.0, 9.0, 1.0, 0.0, 30.0], [100, 98, 96, 90, 90, 88]);
        let found = prices(&errors, |at| counts[at]);
        assert!(found.is_sorted(), "{found:?}");
        assert_eq!(found, [0.5, 1.25, 1.25, 15.0, 15.0]);
    }

    #[test]
    fn flat_parts_cost_nothing_and_curved_ones_more_the_coarser_they_get() {
        let lod = |mesh| Lod::build(&mesh, &LodOptions::default()).expect("a valid mesh");
        let errors_of = |lod: &Lod| step_errors(lod.mesh(), lod.sequence(), lod.mesh().diagonal());
        let plane = lod(shapes::grid(12, 12));
        // Only the last steps change the outline.
        let inner = plane.sequence().errors().iter().filter(|&&error| error < 1e-6).count();
        let flat: f64 = errors_of(&plane).iter().take(inner).sum();
        assert!(inner > 100 && flat < 1e-9, "{inner} {flat}");
        let ball = lod(shapes::icosphere(3, 1.0));
        let errors = errors_of(&ball);
        assert_eq!(errors.len(), ball.step_count());
        let half = errors.len() / 2;
        let [fine, coarse] = [&errors[..half], &errors[half..]].map(|half| half.iter().sum::<f64>());
        assert!(fine > 0.0 && coarse > 4.0 * fine, "{fine} {coarse}");
    }
}
