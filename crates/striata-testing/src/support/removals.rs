//! Random removals of vertices from a surface, with any triangulations of the holes.

use striata::mesh::{
    AttributeLayer, Face, Fragment, FragmentSequence, FragmentedMesh, IndexedMesh, PositionIndex,
};

use super::Random;

/// Tries in a row that may fail before there is taken to be nothing left to remove.
const MISSES: usize = 300;

/// A vertex with its ceiling and its floor.
type Removed = (u32, Vec<[u32; 3]>, Vec<[u32; 3]>);

/// Removes vertices in random order, at most so many, as long as the surface stays a simple one, borders allowed; a vertex whose
/// hole has a triangulation that would double an edge stays. Looks at all triangles each time.
pub fn random_removals(mesh: &IndexedMesh, most: usize, random: &mut Random) -> FragmentedMesh {
    let vertex_count = mesh.vertex_count();
    let mut triangles = mesh.triangles.clone();
    let mut left: Vec<u32> = (0..vertex_count as u32).collect();
    let mut removed: Vec<Removed> = Vec::new();
    let mut misses = 0;
    while misses < MISSES && removed.len() < most && !left.is_empty() {
        let place = random.below(left.len());
        let vertex = left[place];
        let Some(floor) = floor_of(&triangles, vertex, random) else {
            misses += 1;
            continue;
        };
        misses = 0;
        left.swap_remove(place);
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

/// A random triangulation of the hole that a vertex leaves, or none if the surface would not be simple any more.
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
        // A diagonal must not be an edge already, in either direction.
        if has_edge(a, c) || has_edge(c, a) {
            return None;
        }
    }
    floor.push([polygon[0], polygon[1], polygon[2]]);
    // At a border the last side is new as well, and must not lie where another triangle has it so.
    let [first, last] = [ring[0], ring[ring.len() - 1]];
    if !is_closed && (has_edge(last, first) || has_edge(first, last) && !closes_a_hole(&others, first, last))
    {
        return None;
    }
    // The smallest closed surface is two triangles back to back; leave it at more than that.
    let is_back_to_back = |t: &[u32; 3]| others.iter().any(|o| t.iter().all(|v| o.contains(v)));
    (!floor.iter().any(is_back_to_back)).then_some(floor)
}

/// Whether the side that a triangle has from `first` to `last` is a border, so that a floor may close the hole at it.
fn closes_a_hole(others: &[[u32; 3]], first: u32, last: u32) -> bool {
    let sides =
        |a: u32, b: u32| others.iter().filter(|t| (0..3).any(|i| t[i] == a && t[(i + 1) % 3] == b)).count();
    sides(first, last) == 1 && sides(last, first) == 0
}

/// The neighbors of a vertex in order, and whether they close a ring; none where its triangles are not one fan.
fn ring_of(triangles: &[[u32; 3]], vertex: u32) -> Option<(Vec<u32>, bool)> {
    let mut arcs: Vec<[u32; 2]> = triangles
        .iter()
        .filter_map(|t| (0..3).find(|&i| t[i] == vertex).map(|i| [t[(i + 1) % 3], t[(i + 2) % 3]]))
        .collect();
    let start = arcs.iter().find(|a| !arcs.iter().any(|b| b[1] == a[0])).or(arcs.first())?[0];
    let mut ring = vec![start];
    while let Some(place) = arcs.iter().position(|arc| arc[0] == *ring.last().unwrap()) {
        let to = arcs.swap_remove(place)[1];
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
