//! Colors for strips, fans and single triangles, so that neighbors can be told apart.
//!
//! Regions that share an edge get different colors: taken off one by one, always the one with fewest neighbors left, and
//! colored in the opposite order, each finds fewer colored neighbors than there are colors on any surface that is drawn
//! without crossings. Cost: O(triangles log triangles).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use striata::mesh::IndexedMesh;
use striata::strip::{StripSet, strip_triangles};

use super::canvas::from_srgb;

/// Linear light as bytes, opaque.
pub(super) type Color = [u8; 4];

/// Triangles, and a color for each.
pub type Painted = (Vec<[u32; 3]>, Vec<Color>);

/// The triangles of strips, in a color for each strip.
pub fn strip_colors(strips: &StripSet) -> Painted {
    by_region(strips.strips().map(|strip| strip_triangles(strip).collect()))
}

/// The triangles of fans, in a color for each fan.
pub fn fan_colors(fans: &[Vec<Vec<u32>>]) -> Painted {
    let triangles =
        |fan: &Vec<u32>| fan[1..].windows(2).map(|edge| [fan[0], edge[0], edge[1]]).collect::<Vec<_>>();
    by_region(fans.iter().flatten().map(triangles))
}

/// Triangles, each in a color of its own.
pub fn triangle_colors(triangles: &[[u32; 3]]) -> Painted {
    by_region(triangles.iter().map(|&triangle| vec![triangle]))
}

fn by_region(regions: impl Iterator<Item = Vec<[u32; 3]>>) -> Painted {
    let (mut triangles, mut region_of, mut region_count) = (Vec::new(), Vec::new(), 0);
    for region in regions {
        triangles.extend_from_slice(&region);
        region_of.resize(triangles.len(), region_count);
        region_count += 1;
    }
    let palette: Vec<Color> = colorous::TABLEAU10.iter().map(|&color| linear(color)).collect();
    let numbers = distinct_numbers(&neighbors(&triangles, &region_of, region_count), palette.len());
    let colors = region_of.iter().map(|&region| palette[numbers[region as usize]]).collect();
    (triangles, colors)
}

/// The triangles of a mesh, in a color for each of its groups.
pub fn group_colors(mesh: &IndexedMesh) -> Painted {
    let colors = mesh.groups_or_whole().into_iter().zip(colorous::TABLEAU10.iter().cycle());
    let colors = colors.flat_map(|(group, &color)| vec![linear(color); group.range().len()]);
    (mesh.triangles.clone(), colors.collect())
}

/// Linear light as bytes.
fn linear(color: colorous::Color) -> Color {
    let [r, g, b] = [color.r, color.g, color.b].map(|byte| (255.0 * from_srgb(byte) + 0.5) as u8);
    [r, g, b, 255]
}

/// For each region those that it shares an edge with.
fn neighbors(triangles: &[[u32; 3]], region_of: &[u32], region_count: u32) -> Vec<Vec<u32>> {
    let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * triangles.len());
    for (&[a, b, c], &region) in triangles.iter().zip(region_of) {
        sides.extend([[a, b], [b, c], [c, a]].map(|[a, b]| ([a.min(b), a.max(b)], region)));
    }
    sides.sort_unstable();
    let mut pairs = Vec::new();
    for edge in sides.chunk_by(|a, b| a.0 == b.0) {
        for (i, &(_, a)) in edge.iter().enumerate() {
            // Edges of very many triangles are no place where one tells regions apart.
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

/// A number below `count` for each node, different from those of its neighbors wherever that many numbers do.
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
        // Where one looks first is scattered, so that all colors are seen.
        let first = (node.wrapping_mul(2_654_435_769) >> 16) as usize;
        let in_turn = (0..count).map(|i| (first + i) % count);
        numbers[node as usize] = in_turn.min_by_key(|&number| used[number]).unwrap_or(0);
    }
    numbers
}

/// All nodes, each the one with fewest neighbors among those that come after it.
fn smallest_last(neighbors: &[Vec<u32>]) -> Vec<u32> {
    let mut left: Vec<usize> = neighbors.iter().map(Vec::len).collect();
    let mut is_taken = vec![false; neighbors.len()];
    let mut queue: BinaryHeap<Reverse<(usize, u32)>> = left.iter().copied().zip(0..).map(Reverse).collect();
    let mut order = Vec::with_capacity(neighbors.len());
    while let Some(Reverse((degree, node))) = queue.pop() {
        if is_taken[node as usize] || degree != left[node as usize] {
            continue;
        }
        is_taken[node as usize] = true;
        order.push(node);
        for &neighbor in neighbors[node as usize].iter().filter(|&&n| !is_taken[n as usize]) {
            left[neighbor as usize] -= 1;
            queue.push(Reverse((left[neighbor as usize], neighbor)));
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;
    use striata::strip::stripify;

    use super::*;

    /// Panics where two triangles of different regions share an edge and a color.
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
    fn nothing_and_an_edge_of_many_triangles() {
        assert_eq!(triangle_colors(&[]), (Vec::new(), Vec::new()));
        let (triangles, colors) = triangle_colors(&(2..40).map(|v| [0, 1, v]).collect::<Vec<_>>());
        assert_eq!((triangles.len(), colors.len()), (38, 38));
        assert_ne!(colors[0], colors[1]);
    }
}
