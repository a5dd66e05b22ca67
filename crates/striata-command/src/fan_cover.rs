//! Covers a mesh with triangle fans, greedily: the vertex with the most uncovered triangles comes first.
//!
//! A vertex inside a surface has about six triangles, and covering them leaves fewer for its neighbors. The
//! result has half to two thirds as many fans as vertices, whatever the order of the triangles. Takes linear
//! time, except for the priority queue.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

use striata::mesh::IndexedMesh;

/// Returns the fans of each group: the pivot, then the vertices around it. Triangles with two equal corners
/// are left out.
pub fn cover_with_fans(mesh: &IndexedMesh) -> Vec<Vec<Vec<u32>>> {
    let mut cover = FanCover::new(mesh);
    mesh.groups_or_whole().into_iter().map(|group| cover.cover_group(group.range())).collect()
}

struct FanCover<'m> {
    triangles: &'m [[u32; 3]],
    /// Triangles around each vertex, one list after another.
    around: Vec<u32>,
    /// Start of the list of each vertex in `around`.
    firsts: Vec<usize>,
    /// Number of uncovered triangles of each vertex in the current group.
    uncovered_counts: Vec<u32>,
    is_covered: Vec<bool>,
}

impl<'m> FanCover<'m> {
    fn new(mesh: &'m IndexedMesh) -> Self {
        let triangles = &mesh.triangles;
        let is_covered: Vec<bool> = triangles.iter().map(|&[a, b, c]| a == b || b == c || c == a).collect();
        let mut firsts = vec![0; mesh.vertex_count() + 1];
        let drawn = || (0..).zip(triangles).filter(|&(t, _)| !is_covered[t as usize]);
        drawn().flat_map(|(_, corners)| corners).for_each(|&v| firsts[v as usize + 1] += 1);
        for vertex in 0..mesh.vertex_count() {
            firsts[vertex + 1] += firsts[vertex];
        }
        let mut next = firsts.clone();
        let mut around = vec![0; firsts[mesh.vertex_count()]];
        for (t, corners) in drawn() {
            for &v in corners {
                around[next[v as usize]] = t;
                next[v as usize] += 1;
            }
        }
        Self { triangles, around, firsts, uncovered_counts: vec![0; mesh.vertex_count()], is_covered }
    }

    /// Covers the triangles of one group.
    fn cover_group(&mut self, range: Range<usize>) -> Vec<Vec<u32>> {
        let drawn = range.clone().filter(|&t| !self.is_covered[t]);
        let mut vertices: Vec<u32> = drawn.flat_map(|t| self.triangles[t]).collect();
        vertices.iter().for_each(|&v| self.uncovered_counts[v as usize] += 1);
        vertices.sort_unstable();
        vertices.dedup();
        let mut queue: BinaryHeap<(u32, Reverse<u32>)> =
            vertices.into_iter().map(|v| (self.uncovered_counts[v as usize], Reverse(v))).collect();
        let mut fans = Vec::new();
        while let Some((count, Reverse(pivot))) = queue.pop() {
            let uncovered_count = self.uncovered_counts[pivot as usize];
            if uncovered_count == count {
                self.cover_vertex(pivot, &range, &mut fans);
            } else if uncovered_count > 0 {
                queue.push((uncovered_count, Reverse(pivot)));
            }
        }
        fans
    }

    /// Covers the remaining triangles around a vertex, with one fan per connected run.
    fn cover_vertex(&mut self, pivot: u32, range: &Range<usize>, fans: &mut Vec<Vec<u32>>) {
        let mut arcs: Vec<[u32; 2]> = Vec::new();
        for at in self.firsts[pivot as usize]..self.firsts[pivot as usize + 1] {
            let t = self.around[at] as usize;
            if range.contains(&t) && !self.is_covered[t] {
                self.is_covered[t] = true;
                let corners = self.triangles[t];
                corners.iter().for_each(|&v| self.uncovered_counts[v as usize] -= 1);
                let turn = corners.iter().position(|&v| v == pivot).unwrap_or(0);
                arcs.push([corners[(turn + 1) % 3], corners[(turn + 2) % 3]]);
            }
        }
        arcs.sort_unstable();
        let has_incoming_arc = |node: u32| arcs.iter().any(|arc| arc[1] == node);
        let mut starts: Vec<usize> = (0..arcs.len()).filter(|&i| !has_incoming_arc(arcs[i][0])).collect();
        starts.extend(0..arcs.len());
        let mut is_used = vec![false; arcs.len()];
        for start in starts {
            let mut fan = vec![pivot, arcs[start][0]];
            let mut at = Some(start).filter(|&start| !is_used[start]);
            while let Some(arc) = at {
                is_used[arc] = true;
                let node = arcs[arc][1];
                fan.push(node);
                let first = arcs.partition_point(|arc| arc[0] < node);
                let leaving = arcs[first..].iter().take_while(|arc| arc[0] == node).count();
                at = (first..first + leaving).find(|&arc| !is_used[arc]);
            }
            if fan.len() > 2 {
                fans.push(fan);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::{TriangleGroup, canonical_triangles, shapes};
    use striata_testing::meshes;

    use super::*;

    fn triangles_of(fans: &[Vec<u32>]) -> Vec<[u32; 3]> {
        let of_fan = |fan: &Vec<u32>| -> Vec<[u32; 3]> {
            fan[1..].windows(2).map(|edge| [fan[0], edge[0], edge[1]]).collect()
        };
        canonical_triangles(&fans.iter().flat_map(of_fan).collect::<Vec<_>>())
    }

    #[test]
    fn fans_cover_each_triangle_once() {
        for (name, mesh) in meshes::nasty() {
            if mesh.check().is_err() {
                continue;
            }
            let mut drawn = mesh.triangles.clone();
            drawn.retain(|&[a, b, c]| a != b && b != c && c != a);
            let fans: Vec<Vec<u32>> = cover_with_fans(&mesh).into_iter().flatten().collect();
            assert_eq!(triangles_of(&fans), canonical_triangles(&drawn), "{name}");
        }
    }

    #[test]
    fn fans_stay_in_their_group_and_are_few() {
        let mut mesh = shapes::grid(30, 30);
        let half = mesh.triangle_count() / 2;
        let group = |first: usize, count: usize| TriangleGroup {
            name: String::new(),
            material: None,
            first: first as u32,
            count: count as u32,
        };
        mesh.groups = vec![group(0, half), group(half, mesh.triangle_count() - half)];
        let fans = cover_with_fans(&mesh);
        for (group, fans) in mesh.groups.iter().zip(&fans) {
            assert_eq!(triangles_of(fans), canonical_triangles(&mesh.triangles[group.range()]));
        }
        let fan_count: usize = fans.iter().map(Vec::len).sum();
        assert!(fan_count < mesh.vertex_count() * 7 / 10, "{fan_count} fans");
        let ring = shapes::grid(2, 2);
        assert_eq!(cover_with_fans(&ring).concat()[0].len(), 8, "a closed ring is one fan");
    }
}
