//! Removes random vertices from a surface and fills the holes with random triangulations.

use striata::mesh::{
    AttributeLayer, Face, Fragment, FragmentSequence, FragmentedMesh, IndexedMesh, PositionIndex,
};

use super::Random;

/// Number of consecutive failed attempts after which no removable vertex is assumed to be left.
const MAX_FAILURES: usize = 300;

/// A removed vertex with its ceiling and its floor.
type Removed = (u32, Vec<[u32; 3]>, Vec<[u32; 3]>);

/// Removes at most `max_count` vertices in random order while the surface stays manifold, possibly with
/// boundary. A vertex whose hole receives a triangulation that would duplicate an edge is kept. Quadratic
/// time.
pub fn random_removals(mesh: &IndexedMesh, max_count: usize, random: &mut Random) -> FragmentedMesh {
    let vertex_count = mesh.vertex_count();
    let mut triangles = mesh.triangles.clone();
    let mut left: Vec<u32> = (0..vertex_count as u32).collect();
    let mut removed: Vec<Removed> = Vec::new();
    let mut failure_count = 0;
    while failure_count < MAX_FAILURES && removed.len() < max_count && !left.is_empty() {
        let index = random.below(left.len());
        let vertex = left[index];
        let Some(floor) = floor_of(&triangles, vertex, random) else {
            failure_count += 1;
            continue;
        };
        failure_count = 0;
        left.swap_remove(index);
        let ceiling: Vec<[u32; 3]> = triangles.extract_if(.., |t| t.contains(&vertex)).collect();
        triangles.extend_from_slice(&floor);
        removed.push((vertex, ceiling, floor));
    }
    left.sort_unstable();
    let order: Vec<u32> = left.iter().copied().chain(removed.iter().rev().map(|r| r.0)).collect();
    let mut new_index = vec![0; vertex_count];
    (0..).zip(&order).for_each(|(new, &old)| new_index[old as usize] = new);
    let face = |t: &[u32; 3]| Face { corners: t.map(|v| new_index[v as usize]), group: 0 };
    let count = removed.len() as f32;
    let fragments = removed.iter().rev().zip(0..).map(|((_, ceiling, floor), step)| Fragment {
        ceiling: ceiling.iter().map(face).collect(),
        floor: floor.iter().map(face).collect(),
        error: (count - step as f32) * 0.25,
    });
    let fragments: Vec<Fragment> = fragments.collect();
    let base = triangles.iter().map(face).collect();
    let positions = PositionIndex::identity(vertex_count);
    let fragments = FragmentSequence::from_fragments(positions, base, fragments.into_iter()).unwrap();
    let layers: Vec<AttributeLayer> = mesh.layers.iter().map(|layer| layer.gather(&order)).collect();
    let mesh = IndexedMesh {
        positions: order.iter().map(|&v| mesh.positions[v as usize]).collect(),
        triangles: mesh.triangles.iter().map(|t| t.map(|v| new_index[v as usize])).collect(),
        layers,
        ..mesh.clone()
    };
    FragmentedMesh { mesh, fragments }
}

/// Returns a random triangulation of the hole that a vertex leaves, or `None` if the result would not be
/// manifold.
fn floor_of(triangles: &[[u32; 3]], vertex: u32, random: &mut Random) -> Option<Vec<[u32; 3]>> {
    let (ring, is_closed) = ring_of(triangles, vertex)?;
    if ring.len() < 3 {
        return None;
    }
    let around = |t: &&[u32; 3]| !t.contains(&vertex);
    let others: Vec<[u32; 3]> = triangles.iter().filter(around).copied().collect();
    let has_edge = |a: u32, b: u32| others.iter().any(|t| (0..3).any(|i| t[i] == a && t[(i + 1) % 3] == b));
    let mut floor = Vec::new();
    let mut polygon = ring.clone();
    while polygon.len() > 3 {
        let i = random.below(polygon.len());
        let n = polygon.len();
        let [a, b, c] = [polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]];
        floor.push([a, b, c]);
        polygon.remove((i + 1) % n);
        // A diagonal must not duplicate an existing edge in either direction.
        if has_edge(a, c) || has_edge(c, a) {
            return None;
        }
    }
    floor.push([polygon[0], polygon[1], polygon[2]]);
    // On a boundary, the last side is new too and must not duplicate a directed edge.
    let [first, last] = [ring[0], ring[ring.len() - 1]];
    if !is_closed && (has_edge(last, first) || has_edge(first, last) && !closes_a_hole(&others, first, last))
    {
        return None;
    }
    // Never end at the smallest closed surface, two triangles back to back.
    let is_back_to_back = |t: &[u32; 3]| others.iter().any(|o| t.iter().all(|v| o.contains(v)));
    (!floor.iter().any(is_back_to_back)).then_some(floor)
}

/// Whether the edge from `first` to `last` is a boundary edge, so that a floor can close the hole there.
fn closes_a_hole(others: &[[u32; 3]], first: u32, last: u32) -> bool {
    let sides =
        |a: u32, b: u32| others.iter().filter(|t| (0..3).any(|i| t[i] == a && t[(i + 1) % 3] == b)).count();
    sides(first, last) == 1 && sides(last, first) == 0
}

/// Returns the neighbors of a vertex in order and whether they form a closed ring; `None` if its triangles
/// are not a single fan.
fn ring_of(triangles: &[[u32; 3]], vertex: u32) -> Option<(Vec<u32>, bool)> {
    let mut arcs: Vec<[u32; 2]> = triangles
        .iter()
        .filter_map(|t| (0..3).find(|&i| t[i] == vertex).map(|i| [t[(i + 1) % 3], t[(i + 2) % 3]]))
        .collect();
    let start = arcs.iter().find(|a| !arcs.iter().any(|b| b[1] == a[0])).or(arcs.first())?[0];
    let mut ring = vec![start];
    while let Some(index) = arcs.iter().position(|arc| arc[0] == *ring.last().unwrap()) {
        let to = arcs.swap_remove(index)[1];
        if to == start {
            return arcs.is_empty().then_some((ring, true));
        }
        if ring.contains(&to) {
            return None;
        }
        ring.push(to);
    }
    arcs.is_empty().then_some((ring, false))
}
