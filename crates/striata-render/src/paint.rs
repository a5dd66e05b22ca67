//! Colors strips, fans and triangles so that neighbors are distinguishable.
//!
//! Regions that share an edge get different colors. Regions are removed one by one, always the one with the
//! fewest remaining neighbors, and colored in reverse order; on a planar surface, each then has fewer
//! colored neighbors than there are colors. Cost: O(triangles log triangles).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use striata::mesh::IndexedMesh;
use striata::strip::{StripSet, strip_triangles};

use super::srgb::from_srgb;

/// Opaque color, linear light as bytes.
pub(crate) type Color = [u8; 4];

/// Triangles and a color for each.
pub type ColoredTriangles = (Vec<[u32; 3]>, Vec<Color>);

/// Colors the triangles of strips by strip.
pub fn strip_colors(strips: &StripSet) -> ColoredTriangles {
    by_region(strips.strips().map(|strip| strip_triangles(strip).collect()))
}

/// Colors the triangles of fans by fan.
pub fn fan_colors(fans: &[Vec<Vec<u32>>]) -> ColoredTriangles {
    let triangles =
        |fan: &Vec<u32>| fan[1..].windows(2).map(|edge| [fan[0], edge[0], edge[1]]).collect::<Vec<_>>();
    by_region(fans.iter().flatten().map(triangles))
}

/// Colors each triangle differently from its neighbors.
pub fn triangle_colors(triangles: &[[u32; 3]]) -> ColoredTriangles {
    by_region(triangles.iter().map(|&triangle| vec![triangle]))
}

fn by_region(regions: impl Iterator<Item = Vec<[u32; 3]>>) -> ColoredTriangles {
    let (mut triangles, mut region_of, mut region_count) = (Vec::new(), Vec::new(), 0);
    for region in regions {
        triangles.extend_from_slice(&region);
        region_of.resize(triangles.len(), region_count);
        region_count += 1;
    }
    let colors = region_colors(&triangles, &region_of, region_count);
    (triangles, colors)
}

/// Returns a color for each triangle: that of its region.
fn region_colors(triangles: &[[u32; 3]], region_of: &[u32], region_count: u32) -> Vec<Color> {
    let palette: Vec<Color> = colorous::TABLEAU10.iter().map(|&color| linear(color)).collect();
    let numbers = distinct_numbers(&neighbors(triangles, region_of, region_count), palette.len());
    region_of.iter().map(|&region| palette[numbers[region as usize]]).collect()
}

/// Colors the triangles of a level by the step that inserted each, if any; those of the base mesh, which no step
/// inserted, are gray.
pub fn fragment_colors(triangles: &[[u32; 3]], steps: &[Option<u32>]) -> ColoredTriangles {
    let mut present: Vec<u32> = steps.iter().copied().flatten().collect();
    present.sort_unstable();
    present.dedup();
    let base = present.len() as u32;
    let region = |step: &Option<u32>| step.map_or(base, |step| present.partition_point(|&s| s < step) as u32);
    let region_of: Vec<u32> = steps.iter().map(region).collect();
    let colors = region_colors(triangles, &region_of, base + 1);
    let of_step = |(color, &region): (Color, &u32)| if region == base { BASE_COLOR } else { color };
    (triangles.to_vec(), colors.into_iter().zip(&region_of).map(of_step).collect())
}

/// Color of triangles of the base mesh among fragments, linear light as bytes.
const BASE_COLOR: Color = [64, 64, 64, 255];

/// Colors the triangles of a mesh by group.
pub fn group_colors(mesh: &IndexedMesh) -> ColoredTriangles {
    let colors = mesh.groups_or_whole().into_iter().zip(colorous::TABLEAU10.iter().cycle());
    let colors = colors.flat_map(|(group, &color)| vec![linear(color); group.range().len()]);
    (mesh.triangles.clone(), colors.collect())
}

/// Converts to linear light as bytes.
fn linear(color: colorous::Color) -> Color {
    let [r, g, b] = [color.r, color.g, color.b].map(|byte| (255.0 * from_srgb(byte) + 0.5) as u8);
    [r, g, b, 255]
}

/// Regions that share an edge with each region.
fn neighbors(triangles: &[[u32; 3]], region_of: &[u32], region_count: u32) -> Vec<Vec<u32>> {
    let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * triangles.len());
    for (&[a, b, c], &region) in triangles.iter().zip(region_of) {
        sides.extend([[a, b], [b, c], [c, a]].map(|[a, b]| ([a.min(b), a.max(b)], region)));
    }
    sides.sort_unstable();
    let mut pairs = Vec::new();
    for edge in sides.chunk_by(|a, b| a.0 == b.0) {
        for (i, &(_, a)) in edge.iter().enumerate() {
            // At edges with very many triangles, adjacent colors would not be visible anyway.
            let others = edge[i + 1..].iter().take(8).map(|&(_, b)| b);
            pairs.extend(others.filter(|&b| a != b).flat_map(|b| [(a, b), (b, a)]));
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    let mut neighbors = vec![Vec::new(); region_count as usize];
    pairs.into_iter().for_each(|(a, b)| neighbors[a as usize].push(b));
    neighbors
}

/// Assigns each node a number below `count` that differs from its neighbors' if possible.
fn distinct_numbers(neighbors: &[Vec<u32>], count: usize) -> Vec<usize> {
    const NONE: usize = usize::MAX;
    let mut numbers = vec![NONE; neighbors.len()];
    for &node in smallest_last(neighbors).iter().rev() {
        let mut used = vec![0u32; count];
        for &neighbor in &neighbors[node as usize] {
            if let Some(uses) = used.get_mut(numbers[neighbor as usize]) {
                *uses += 1;
            }
        }
        // Starting at a pseudo-random number makes sure that all colors are used.
        let first = (node.wrapping_mul(2_654_435_769) >> 16) as usize;
        let in_turn = (0..count).map(|i| (first + i) % count);
        numbers[node as usize] = in_turn.min_by_key(|&number| used[number]).unwrap_or(0);
    }
    numbers
}

/// Smallest-last order: each node has the fewest neighbors among itself and its successors.
fn smallest_last(neighbors: &[Vec<u32>]) -> Vec<u32> {
    let mut remaining: Vec<usize> = neighbors.iter().map(Vec::len).collect();
    let mut is_removed = vec![false; neighbors.len()];
    let mut queue: BinaryHeap<Reverse<(usize, u32)>> =
        remaining.iter().copied().zip(0..).map(Reverse).collect();
    let mut order = Vec::with_capacity(neighbors.len());
    while let Some(Reverse((degree, node))) = queue.pop() {
        if is_removed[node as usize] || degree != remaining[node as usize] {
            continue;
        }
        is_removed[node as usize] = true;
        order.push(node);
        for &neighbor in neighbors[node as usize].iter().filter(|&&n| !is_removed[n as usize]) {
            remaining[neighbor as usize] -= 1;
            queue.push(Reverse((remaining[neighbor as usize], neighbor)));
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;
    use striata::strip::stripify;

    use super::*;

    /// Panics if two triangles of different regions share an edge and a color.
    fn assert_distinct(triangles: &[[u32; 3]], region_of: &[u32], colors: &[Color]) {
        let region_count = region_of.iter().max().map_or(0, |&last| last + 1);
        let color_of = |region: u32| colors[region_of.iter().position(|&r| r == region).expect("one")];
        for (region, around) in (0..).zip(neighbors(triangles, region_of, region_count)) {
            for other in around {
                let (a, b) = (color_of(region), color_of(other));
                let difference: u32 = a.iter().zip(b).map(|(&x, y)| u32::from(x.abs_diff(y))).sum();
                assert!(difference > 40, "regions {region} and {other}: {a:?} and {b:?}");
            }
        }
    }

    #[test]
    fn neighboring_strips_fans_and_triangles_differ_in_color() {
        for mesh in [shapes::icosphere(3, 1.0), shapes::torus(48, 24, 1.0, 0.4), shapes::grid(20, 20)] {
            let strips = stripify(&mesh).expect("a sound mesh");
            let (triangles, colors) = strip_colors(&strips);
            assert_eq!(triangles.len(), mesh.triangle_count());
            let mut region_of = Vec::new();
            for (number, strip) in (0..).zip(strips.strips()) {
                region_of.resize(region_of.len() + strip_triangles(strip).count(), number);
            }
            assert_distinct(&triangles, &region_of, &colors);
            let (triangles, colors) = triangle_colors(&mesh.triangles);
            assert_distinct(&triangles, &(0..triangles.len() as u32).collect::<Vec<_>>(), &colors);
            let used: std::collections::BTreeSet<Color> = colors.into_iter().collect();
            assert_eq!(used.len(), 10, "all colors are seen");
        }
    }

    #[test]
    fn fragments_differ_from_their_neighbors_and_from_the_base() {
        let mesh = shapes::grid(20, 20);
        let region_of: Vec<u32> = (0..mesh.triangle_count() as u32).map(|t| t / 5).collect();
        let steps: Vec<Option<u32>> =
            region_of.iter().map(|r| r.checked_sub(10).map(|step| 7 * step)).collect();
        let (triangles, colors) = fragment_colors(&mesh.triangles, &steps);
        assert_eq!(triangles, mesh.triangles);
        assert!(colors[..50].iter().all(|&color| color == BASE_COLOR));
        let merged: Vec<u32> = region_of.iter().map(|r| r.saturating_sub(9)).collect();
        assert_distinct(&triangles, &merged, &colors);
    }

    #[test]
    fn nothing_and_an_edge_of_many_triangles() {
        assert_eq!(triangle_colors(&[]), (Vec::new(), Vec::new()));
        let (triangles, colors) = triangle_colors(&(2..40).map(|v| [0, 1, v]).collect::<Vec<_>>());
        assert_eq!((triangles.len(), colors.len()), (38, 38));
        assert_ne!(colors[0], colors[1]);
    }
}
