//! Fans that cover a mesh: around the vertex with most triangles first, until none is left.
//!
//! A vertex inside of a surface has some six triangles, and its neighbors have fewer once these are taken; that makes half to
//! two thirds as many fans as vertices, however the triangles came. Cost: linear but for the queue.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

use striata::mesh::IndexedMesh;

/// The fans of each group, a pivot and the nodes around it each; triangles without area are left out.
pub fn fans_of(mesh: &IndexedMesh) -> Vec<Vec<Vec<u32>>> {
    let mut cover = Cover::new(mesh);
    mesh.groups_or_whole().into_iter().map(|group| cover.of_group(group.range())).collect()
}

struct Cover<'m> {
    triangles: &'m [[u32; 3]],
    /// Triangles around each vertex, and where they begin.
    around: Vec<u32>,
    firsts: Vec<usize>,
    /// How many of each vertex are left in the group.
    left: Vec<u32>,
    is_covered: Vec<bool>,
}

impl<'m> Cover<'m> {
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
        Self { triangles, around, firsts, left: vec![0; mesh.vertex_count()], is_covered }
    }

    fn of_group(&mut self, range: Range<usize>) -> Vec<Vec<u32>> {
        let drawn = range.clone().filter(|&t| !self.is_covered[t]);
        let mut vertices: Vec<u32> = drawn.flat_map(|t| self.triangles[t]).collect();
        vertices.iter().for_each(|&v| self.left[v as usize] += 1);
        vertices.sort_unstable();
        vertices.dedup();
        let mut queue: BinaryHeap<(u32, Reverse<u32>)> =
            vertices.into_iter().map(|v| (self.left[v as usize], Reverse(v))).collect();
        let mut fans = Vec::new();
        while let Some((count, Reverse(pivot))) = queue.pop() {
            let left = self.left[pivot as usize];
            if left == count {
                self.cover(pivot, &range, &mut fans);
            } else if left > 0 {
                queue.push((left, Reverse(pivot)));
            }
        }
        fans
    }

    /// Covers what is left around a vertex by fans, as few as there are runs.
    fn cover(&mut self, pivot: u32, range: &Range<usize>, fans: &mut Vec<Vec<u32>>) {
        let mut arcs: Vec<[u32; 2]> = Vec::new();
        for at in self.firsts[pivot as usize]..self.firsts[pivot as usize + 1] {
            let t = self.around[at] as usize;
            if range.contains(&t) && !self.is_covered[t] {
                self.is_covered[t] = true;
                let corners = self.triangles[t];
                corners.iter().for_each(|&v| self.left[v as usize] -= 1);
                let turn = corners.iter().position(|&v| v == pivot).unwrap_or(0);
                arcs.push([corners[(turn + 1) % 3], corners[(turn + 2) % 3]]);
            }
        }
        arcs.sort_unstable();
        let is_entered = |node: u32| arcs.iter().any(|arc| arc[1] == node);
        let mut starts: Vec<usize> = (0..arcs.len()).filter(|&i| !is_entered(arcs[i][0])).collect();
        starts.extend(0..arcs.len());
        let mut is_walked = vec![false; arcs.len()];
        for start in starts {
            let mut fan = vec![pivot, arcs[start][0]];
            let mut at = Some(start).filter(|&start| !is_walked[start]);
            while let Some(arc) = at {
                is_walked[arc] = true;
                let node = arcs[arc][1];
                fan.push(node);
                let first = arcs.partition_point(|arc| arc[0] < node);
                let leaving = arcs[first..].iter().take_while(|arc| arc[0] == node).count();
                at = (first..first + leaving).find(|&arc| !is_walked[arc]);
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

    use super::*;

    fn triangles_of(fans: &[Vec<u32>]) -> Vec<[u32; 3]> {
        let of_fan = |fan: &Vec<u32>| -> Vec<[u32; 3]> {
            fan[1..].windows(2).map(|edge| [fan[0], edge[0], edge[1]]).collect()
        };
        canonical_triangles(&fans.iter().flat_map(of_fan).collect::<Vec<_>>())
    }

    #[test]
    fn fans_cover_each_triangle_once() {
        for (name, mesh) in shapes::nasty() {
            if mesh.check().is_err() {
                continue;
            }
            let mut drawn = mesh.triangles.clone();
            drawn.retain(|&[a, b, c]| a != b && b != c && c != a);
            let fans: Vec<Vec<u32>> = fans_of(&mesh).into_iter().flatten().collect();
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
        let fans = fans_of(&mesh);
        for (group, fans) in mesh.groups.iter().zip(&fans) {
            assert_eq!(triangles_of(fans), canonical_triangles(&mesh.triangles[group.range()]));
        }
        let fan_count: usize = fans.iter().map(Vec::len).sum();
        assert!(fan_count < mesh.vertex_count() * 7 / 10, "{fan_count} fans");
        let ring = shapes::grid(2, 2);
        assert_eq!(fans_of(&ring).concat()[0].len(), 8, "a closed ring is one fan");
    }
}
