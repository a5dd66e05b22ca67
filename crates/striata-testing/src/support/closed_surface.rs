//! Reference model of the progressive coder's view of a mesh: cut into manifold copies, with holes closed by
//! virtual vertices.

use std::collections::{BTreeMap, BTreeSet};

/// A closed surface over copies of positions, followed by virtual vertices that close holes.
#[derive(Clone)]
pub struct ClosedSurface {
    /// All triangles, including those that close holes.
    pub triangles: Vec<[u32; 3]>,
    /// Position of each copy.
    pub position_of: Vec<u32>,
    /// Part of the surface to which each copy belongs.
    pub part_of: Vec<u32>,
    is_manifold: Vec<bool>,
}

/// The ring of a vertex: its neighbors, and the undirected edges between them.
pub struct SurfaceRing {
    pub vertices: BTreeSet<u32>,
    pub edges: BTreeSet<[u32; 2]>,
}

impl ClosedSurface {
    /// Cuts a mesh with `position_count` positions into manifold copies and closes its holes.
    pub fn new(position_count: usize, triangles: &[[u32; 3]]) -> Self {
        let mut users: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
        for (t, &[a, b, c]) in triangles.iter().enumerate() {
            for (side, edge) in [[a, b], [b, c], [c, a]].into_iter().enumerate() {
                users.entry(edge).or_default().push(3 * t + side);
            }
        }
        let across =
            |edge: [u32; 2]| match (&users[&edge][..], users.get(&[edge[1], edge[0]]).map(|v| &v[..])) {
                (&[_], Some(&[other])) => Some(other),
                _ => None,
            };
        let next = |corner: usize| corner - corner % 3 + (corner + 1) % 3;
        let mut corners: Vec<usize> = (0..3 * triangles.len()).collect();
        let mut parts: Vec<usize> = (0..triangles.len()).collect();
        for (edge, corner) in
            users.iter().flat_map(|(edge, corners)| corners.iter().map(move |c| (*edge, *c)))
        {
            if let Some(other) = across(edge) {
                unite(&mut corners, corner, next(other));
                unite(&mut corners, next(corner), other);
                unite(&mut parts, corner / 3, other / 3);
            }
        }
        let mut surface = Self {
            triangles: Vec::new(),
            position_of: Vec::new(),
            part_of: Vec::new(),
            is_manifold: Vec::new(),
        };
        let mut copy_of = vec![u32::MAX; corners.len()];
        let mut copy_counts = vec![0; position_count];
        for corner in 0..corners.len() {
            let root = root(&corners, corner);
            if copy_of[root] == u32::MAX {
                copy_of[root] = surface.position_of.len() as u32;
                let position = triangles[corner / 3][corner % 3];
                surface.position_of.push(position);
                surface.part_of.push(self::root(&parts, corner / 3) as u32);
                copy_counts[position as usize] += 1;
            }
            copy_of[corner] = copy_of[root];
        }
        let copies = |t: usize| [0, 1, 2].map(|k| copy_of[3 * t + k]);
        surface.triangles = (0..triangles.len()).map(copies).collect();
        let simple = |p: u32| {
            let leaving: Vec<_> = users.range([p, 0]..=[p, u32::MAX]).collect();
            leaving.iter().all(|(_, corners)| corners.len() == 1)
                && triangles.iter().filter(|t| t.contains(&p)).all(|t| {
                    t.iter().filter(|&&q| q != p).all(|&q| users.get(&[q, p]).is_none_or(|c| c.len() == 1))
                })
        };
        surface.is_manifold = (0..position_count).map(|p| copy_counts[p] == 1 && simple(p as u32)).collect();
        surface.close_holes(&users, &copy_of, across);
        // A triangle and its reverse form a fan, but not a ring.
        for copy in 0..surface.position_of.len() as u32 {
            if surface.edges_around(copy).count() < 3 {
                surface.is_manifold[surface.position_of[copy as usize] as usize] = false;
            }
        }
        surface
    }

    fn close_holes(
        &mut self,
        users: &BTreeMap<[u32; 2], Vec<usize>>,
        copy_of: &[u32],
        across: impl Fn([u32; 2]) -> Option<usize>,
    ) {
        let next = |corner: usize| corner - corner % 3 + (corner + 1) % 3;
        let mut holes: Vec<usize> = (0..self.position_of.len()).collect();
        let mut rim = Vec::new();
        for (_, corners) in users.iter().filter(|(edge, _)| across(**edge).is_none()) {
            for &corner in corners {
                let [a, b] = [copy_of[corner], copy_of[next(corner)]];
                rim.push([a, b]);
                unite(&mut holes, a as usize, b as usize);
            }
        }
        let first = self.position_of.len() as u32;
        // The index of a virtual vertex derives from a copy on the hole, so indices may have gaps.
        let closing = rim.iter().map(|&[a, b]| [b, a, first + root(&holes, a as usize) as u32]);
        self.triangles.extend(closing);
    }

    /// Whether a vertex is a copy of a position, as opposed to a virtual vertex.
    pub fn is_real(&self, vertex: u32) -> bool {
        (vertex as usize) < self.position_of.len()
    }

    /// Whether the triangles of a position formed a single fan in the original mesh.
    pub fn is_manifold(&self, position: u32) -> bool {
        self.is_manifold[position as usize]
    }

    /// Returns the copies of a position that are still used by a triangle.
    pub fn copies(&self, position: u32) -> BTreeSet<u32> {
        let all = self.triangles.iter().flatten().copied();
        all.filter(|&c| self.is_real(c) && self.position_of[c as usize] == position).collect()
    }

    /// Returns the ring of a vertex; panics if it is not a single cycle of distinct vertices.
    pub fn ring(&self, v: u32) -> SurfaceRing {
        let follows: BTreeMap<u32, u32> = self.edges_around(v).collect();
        assert_eq!(follows.len(), self.edges_around(v).count(), "{v} has a neighbor twice");
        let first = *follows.keys().next().unwrap_or_else(|| panic!("{v} has lost all triangles"));
        let mut at = follows[&first];
        let mut length = 1;
        while at != first {
            at = *follows.get(&at).unwrap_or_else(|| panic!("the ring of {v} is open at {at}"));
            length += 1;
            assert!(length <= follows.len(), "the ring of {v} crosses itself");
        }
        assert_eq!(length, follows.len(), "{v} has several rings");
        assert!(length >= 3, "{v} has {length} triangles");
        SurfaceRing {
            vertices: follows.keys().copied().collect(),
            edges: follows.iter().map(|(&a, &b)| [a.min(b), a.max(b)]).collect(),
        }
    }

    fn edges_around(&self, v: u32) -> impl Iterator<Item = (u32, u32)> {
        self.triangles.iter().filter_map(move |&[a, b, c]| match v {
            _ if v == a => Some((b, c)),
            _ if v == b => Some((c, a)),
            _ if v == c => Some((a, b)),
            _ => None,
        })
    }

    /// Returns the vertices and edges around a vertex, even if they do not form a ring.
    pub fn unordered_ring(&self, v: u32) -> SurfaceRing {
        let edges: Vec<_> = self.edges_around(v).collect();
        SurfaceRing {
            vertices: edges.iter().flat_map(|&(a, b)| [a, b]).collect(),
            edges: edges.iter().map(|&(a, b)| [a.min(b), a.max(b)]).collect(),
        }
    }

    /// Returns the only copy of position `target` that is a neighbor of `v`.
    pub fn neighbor(&self, v: u32, target: u32) -> u32 {
        let ring = self.ring(v);
        let mut found =
            ring.vertices.iter().filter(|&&c| self.is_real(c) && self.position_of[c as usize] == target);
        let u = *found.next().unwrap_or_else(|| panic!("{v} has no neighbor at position {target}"));
        assert!(found.next().is_none(), "{v} has two neighbors at position {target}");
        u
    }

    /// Replaces `v` by `u` and drops triangles that become degenerate.
    pub fn collapse(&mut self, v: u32, u: u32) {
        for corner in self.triangles.iter_mut().flatten().filter(|c| **c == v) {
            *corner = u;
        }
        self.triangles.retain(|&[a, b, c]| a != b && b != c && c != a);
    }

    /// Returns the triangles over positions, without those that close holes.
    pub fn real_triangles(&self) -> Vec<[u32; 3]> {
        let real = self.triangles.iter().filter(|t| t.iter().all(|&c| self.is_real(c)));
        real.map(|t| t.map(|c| self.position_of[c as usize])).collect()
    }

    /// For each part, returns its number of real triangles and whether it is closed.
    pub fn parts(&self) -> BTreeMap<u32, (usize, bool)> {
        let mut parts: BTreeMap<u32, (usize, bool)> = BTreeMap::new();
        for t in &self.triangles {
            let Some(&c) = t.iter().find(|&&c| self.is_real(c)) else { continue };
            let part = parts.entry(self.part_of[c as usize]).or_insert((0, true));
            if t.iter().all(|&c| self.is_real(c)) {
                part.0 += 1;
            } else {
                part.1 = false;
            }
        }
        parts
    }
}

fn root(links: &[usize], mut i: usize) -> usize {
    while links[i] != i {
        i = links[i];
    }
    i
}

fn unite(links: &mut [usize], a: usize, b: usize) {
    let (a, b) = (root(links, a), root(links, b));
    links[a.max(b)] = a.min(b);
}
