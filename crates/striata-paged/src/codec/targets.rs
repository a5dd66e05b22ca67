//! Targets of owned vertices, coded from fine to coarse: nearly always one of the current neighbors.

use striata_stream::entropy::{AdaptiveNumber, Coder, Rate, code_uniform};

use super::triangles::{Shape, TriangleCoder};
use crate::Page;

/// More neighbors than this are not distinguished.
const MAX_RANK: usize = 62;

impl TriangleCoder<'_> {
    /// Codes all targets.
    pub(super) fn targets<C: Coder>(&mut self, coder: &mut C, page: Option<&Page>) {
        let corners = CornersOfVertices::new(&self.shape);
        let mut order: Vec<u32> = (0..self.shape.positions.len() as u32).collect();
        let keys = &self.shape.keys;
        order.sort_by(|&p, &q| keys[p as usize].total_cmp(&keys[q as usize]).then(p.cmp(&q)));
        let mut targets: Vec<u32> = (0..self.shape.vertices.len() as u32).collect();
        let mut links = targets.clone();
        let actual_of = self.actual_targets(page);
        let mut ranks = AdaptiveNumber::new(32, Rate::Steady);
        let mut neighbors: Vec<u32> = Vec::new();
        for p in order {
            if coder.overran() {
                break;
            }
            let mut first: Option<u32> = None;
            for i in 0..self.shape.wedges[p as usize].len() {
                let v = self.shape.wedges[p as usize][i];
                neighbors.clear();
                corners.for_each(v, |t| {
                    let t = self.shape.triangles[t as usize];
                    let at = t.iter().position(|&w| w == v).unwrap_or(0);
                    for w in [t[(at + 1) % 3], t[(at + 2) % 3]] {
                        let w = current(&mut links, w);
                        if w != v && !neighbors.contains(&w) && neighbors.len() < MAX_RANK {
                            neighbors.push(w);
                        }
                    }
                });
                // All wedges go to the same position.
                if let Some(first) = first
                    && let Some(at) = neighbors.iter().position(|&w| self.is_same_position(w, first))
                {
                    neighbors.swap(0, at);
                }
                let actual = actual_of.get(v as usize).copied().unwrap_or(v);
                let rank = neighbors.iter().position(|&w| w == actual).unwrap_or(neighbors.len());
                let context = if first.is_some() { 16 } else { 0 } + neighbors.len().min(15);
                let rank = ranks.unsigned(coder, context, rank as u32) as usize;
                let target = match neighbors.get(rank) {
                    Some(&target) => target,
                    None => self.any_vertex(coder, actual),
                };
                // Damaged bytes must not form a cycle; a vertex that is its own target is refused later.
                let target = if current(&mut links, target) == v { v } else { target };
                first = first.or(Some(target));
                targets[v as usize] = target;
                links[v as usize] = target;
            }
        }
        self.shape.targets = targets;
    }

    /// Targets of the page that is written, in the numbering of this coder.
    fn actual_targets(&self, page: Option<&Page>) -> Vec<u32> {
        let Some(page) = page else { return Vec::new() };
        let mut actual = vec![0; self.shape.vertices.len()];
        for (v, &target) in page.targets.iter().enumerate() {
            actual[self.met[v] as usize] = self.met[target as usize];
        }
        actual
    }

    fn is_same_position(&self, v: u32, w: u32) -> bool {
        v < Shape::IMPORTS
            && w < Shape::IMPORTS
            && self.shape.vertices[v as usize] == self.shape.vertices[w as usize]
            || v == w
    }

    /// Codes any vertex.
    fn any_vertex<C: Coder>(&self, coder: &mut C, actual: u32) -> u32 {
        let owned = self.shape.vertices.len() as u32;
        let count = owned + self.shape.imports.len() as u32;
        let place = match actual.checked_sub(Shape::IMPORTS) {
            Some(import) => owned + import,
            None => actual,
        };
        let place = code_uniform(coder, count, place);
        if place < owned { place } else { Shape::IMPORTS + place - owned }
    }
}

/// The vertex that `v` has become, with compression of paths. A vertex that has not collapsed is its own link.
fn current(links: &mut [u32], mut v: u32) -> u32 {
    while let Some(&link) = links.get(v as usize)
        && link != v
    {
        if let Some(&above) = links.get(link as usize) {
            links[v as usize] = above;
        }
        v = link;
    }
    v
}

/// Triangles at each owned vertex.
struct CornersOfVertices {
    first: Vec<u32>,
    triangles: Vec<u32>,
}

impl CornersOfVertices {
    fn new(shape: &Shape) -> Self {
        let count = shape.vertices.len();
        let mut first = vec![0u32; count + 1];
        let owned = |t: &[u32; 3]| t.map(|v| v as usize).into_iter().filter(move |&v| v < count);
        for v in shape.triangles.iter().flat_map(owned) {
            first[v + 1] += 1;
        }
        for v in 0..count {
            first[v + 1] += first[v];
        }
        let mut at = first.clone();
        let mut triangles = vec![0; first[count] as usize];
        for (t, corners) in (0..).zip(&shape.triangles) {
            for v in owned(corners) {
                triangles[at[v] as usize] = t;
                at[v] += 1;
            }
        }
        Self { first, triangles }
    }

    fn for_each(&self, v: u32, visit: impl FnMut(u32)) {
        let range = self.first[v as usize] as usize..self.first[v as usize + 1] as usize;
        self.triangles[range].iter().copied().for_each(visit);
    }
}
