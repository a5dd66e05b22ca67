//! Data of triangles at every level: which triangle of the full mesh a triangle of a level stems from.
//!
//! A collapse moves corners and removes triangles, but never creates one. A triangle of a level therefore *is*
//! a triangle of the full mesh, whose corners have followed their collapse targets, and keeps its data.
//! Models list the triangles of a level in an order of their own, so [`level_sources`] matches them by their
//! corners. Removals that fill a hole with new triangles, and levels whose vertices have moved, have no such
//! identity: [`nearest_sources`] takes the data of the triangle of the full mesh at the centroid.
//!
//! Both take O(n log n) time, and callers only need them if a mesh has data of triangles.

use glam::DVec3;

use super::{AttributeLayer, IndexedMesh, TriangleTree, canonical_triangle, gather_layers};

/// Group of a triangle and its corners, the smallest first.
type Key = (u32, [u32; 3]);

/// Group of each triangle.
fn groups_of(mesh: &IndexedMesh) -> Vec<u32> {
    let mut groups = vec![0; mesh.triangle_count()];
    for (number, group) in (0..).zip(&mesh.groups) {
        if let Some(groups) = groups.get_mut(group.range()) {
            groups.fill(number);
        }
    }
    groups
}

fn keys_of(mesh: &IndexedMesh) -> impl Iterator<Item = Key> {
    groups_of(mesh).into_iter().zip(&mesh.triangles).map(|(group, &t)| (group, canonical_triangle(t)))
}

/// The triangles sorted by group and corners, so that meshes with the same triangles in different orders agree;
/// equal triangles keep their order. Files and streams store data of triangles in this order.
pub fn sorted_triangle_order(mesh: &IndexedMesh) -> Vec<u32> {
    let keys: Vec<Key> = keys_of(mesh).collect();
    let mut order: Vec<u32> = (0..keys.len() as u32).collect();
    order.sort_by_key(|&t| keys[t as usize]);
    order
}

/// Brings layers of triangles from the [sorted order](sorted_triangle_order) into the order of the mesh.
pub fn layers_from_sorted(mesh: &IndexedMesh, sorted: &[AttributeLayer]) -> Vec<AttributeLayer> {
    let order = sorted_triangle_order(mesh);
    let mut rank = vec![0; order.len()];
    (0..).zip(&order).for_each(|(at, &triangle)| rank[triangle as usize] = at);
    gather_layers(sorted, &rank)
}

/// For each triangle of `level`, the triangle of `full` that it stems from. `target` returns the vertex of
/// the level that a vertex of the full mesh has collapsed to, in the numbering of `level`.
///
/// Equal triangles are matched in order. A triangle that no triangle of the full mesh becomes gets the data
/// of the [nearest](nearest_sources) one.
pub fn level_sources(full: &IndexedMesh, level: &IndexedMesh, target: impl Fn(u32) -> u32) -> Vec<u32> {
    let has_groups = full.groups.len() == level.groups.len();
    let key = |(group, corners): Key| (if has_groups { group } else { 0 }, corners);
    let substituted = groups_of(full)
        .into_iter()
        .zip(&full.triangles)
        .map(|(group, t)| key((group, canonical_triangle(t.map(&target)))));
    let is_proper = |&(_, [a, b, c]): &Key| a != b && b != c && c != a;
    let mut from: Vec<(Key, u32)> =
        substituted.zip(0..).filter(|(candidate, _)| is_proper(candidate)).collect();
    from.sort_unstable();
    let mut to: Vec<(Key, u32)> = keys_of(level).map(key).zip(0..).collect();
    to.sort_unstable();
    let mut sources = vec![u32::MAX; to.len()];
    let mut next = 0;
    for (at, &(wanted, triangle)) in to.iter().enumerate() {
        while next < from.len() && from[next].0 < wanted {
            next += 1;
        }
        if next < from.len() && from[next].0 == wanted {
            sources[triangle as usize] = from[next].1;
            // The last of equal triangles serves all that remain.
            let has_twin = from.get(next + 1).is_some_and(|twin| twin.0 == wanted);
            let is_repeated = to.get(at + 1).is_some_and(|other| other.0 == wanted);
            next += usize::from(has_twin && is_repeated);
        }
    }
    if sources.contains(&u32::MAX) {
        let nearest = nearest_sources(full, level);
        sources.iter_mut().zip(nearest).filter(|(s, _)| **s == u32::MAX).for_each(|(s, n)| *s = n);
    }
    sources
}

/// For each triangle of `level`, the nearest triangle of `full` to its centroid, in the same group if both
/// meshes have the same number of groups. Of equally near ones the one whose normal agrees best is
/// taken, so that the two sides of a sheet are kept apart.
pub fn nearest_sources(full: &IndexedMesh, level: &IndexedMesh) -> Vec<u32> {
    let mut sources = vec![0; level.triangle_count()];
    let has_groups = full.groups.len() == level.groups.len();
    let (wholes, parts) = (full.groups_or_whole(), level.groups_or_whole());
    let all = 0..full.triangle_count();
    for (number, part) in parts.iter().enumerate() {
        let own = wholes.get(number).map_or(0..0, |whole| whole.range());
        let range = if has_groups && !own.is_empty() { own } else { all.clone() };
        let corners = |mesh: &IndexedMesh, t: usize| mesh.triangles[t].map(|v| mesh.positions[v as usize]);
        if part.count == 0 || range.is_empty() {
            continue;
        }
        let tree = TriangleTree::of_triangles(range.clone().map(|t| corners(full, t)).collect());
        for triangle in part.range() {
            sources[triangle] = (range.start + nearest_source(&tree, corners(level, triangle))) as u32;
        }
    }
    sources
}

fn nearest_source(tree: &TriangleTree, corners: [[f32; 3]; 3]) -> usize {
    let points = corners.map(|p| DVec3::from_array(p.map(f64::from)));
    let centroid = ((points[0] + points[1] + points[2]) / 3.0).to_array();
    let normal = normal_of(points);
    let Some(nearest) = tree.nearest(centroid) else { return 0 };
    // Rounding of the centroid must not decide between triangles that touch each other there.
    let extent = points.iter().map(|p| (*p - points[0]).abs().max_element()).fold(0.0, f64::max);
    let reach = nearest.distance + 1e-6 * extent;
    let mut best = (f64::NEG_INFINITY, nearest.triangle as usize);
    tree.visit_within(centroid, reach, |triangle, distance| {
        if distance <= reach {
            let other = tree.corners(triangle).map(|p| DVec3::from_array(p.map(f64::from)));
            let agreement = normal_of(other).dot(normal);
            if agreement > best.0 || (agreement == best.0 && triangle < best.1) {
                best = (agreement, triangle);
            }
        }
        reach
    });
    best.1
}

fn normal_of([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
}

impl IndexedMesh {
    /// Gives every triangle the data of a triangle of `full`: triangle `i` that of `sources[i]`.
    pub fn take_triangle_layers(&mut self, full: &Self, sources: &[u32]) {
        self.triangle_layers = gather_layers(&full.triangle_layers, sources);
    }

    /// Gives every triangle of a level the data of the triangle of `full` at its centroid; for levels whose
    /// triangles do not stem from single triangles of the full mesh. Does nothing if there are no data.
    pub fn take_nearest_triangle_layers(&mut self, full: &Self) {
        if !full.triangle_layers.is_empty() {
            let sources = nearest_sources(full, self);
            self.take_triangle_layers(full, &sources);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{LayerData, Semantic, shapes};

    fn numbered(mut mesh: IndexedMesh) -> IndexedMesh {
        mesh.triangle_layers.push(AttributeLayer {
            semantic: Semantic::Generic("id".to_owned()),
            component_count: 1,
            normalized: false,
            data: LayerData::U32((0..mesh.triangle_count() as u32).collect()),
        });
        mesh
    }

    #[test]
    fn data_survive_any_order_of_the_triangles() {
        let mesh = numbered(shapes::icosphere(2, 1.0));
        let order = sorted_triangle_order(&mesh);
        let sorted = gather_layers(&mesh.triangle_layers, &order);
        assert_eq!(layers_from_sorted(&mesh, &sorted), mesh.triangle_layers);
        let mut shuffled = mesh.clone();
        shuffled.triangles.reverse();
        shuffled.triangles.iter_mut().for_each(|t| t.rotate_left(1));
        let found = level_sources(&mesh, &shuffled, |v| v);
        let expected: Vec<u32> = (0..mesh.triangle_count() as u32).rev().collect();
        assert_eq!(found, expected);
        assert_eq!(nearest_sources(&mesh, &shuffled), expected);
    }

    #[test]
    fn equal_triangles_and_both_sides_of_a_sheet_are_kept_apart() {
        let p = vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]];
        let mesh = numbered(IndexedMesh::new(p, vec![[0, 1, 2], [0, 2, 1], [1, 2, 0]]));
        let mut turned = mesh.clone();
        turned.triangles = vec![[1, 0, 2], [1, 2, 0], [0, 1, 2], [2, 0, 1]];
        assert_eq!(level_sources(&mesh, &turned, |v| v), [1, 0, 2, 2]);
        assert_eq!(nearest_sources(&mesh, &turned), [1, 0, 0, 0]);
    }
}
