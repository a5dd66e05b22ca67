//! Targets of owned vertices, coded from fine to coarse: nearly always one of the current neighbors.

use striata_stream::entropy::{AdaptiveSymbol, Coder, code_uniform};

use super::triangles::{CodedShape, TriangleCoder};
use crate::Page;

/// Symbol of targets that are not among the first neighbors.
const OTHER: usize = 15;
/// Maximum number of neighbors that are considered.
const MAX_NEIGHBORS: usize = 62;
/// Negative binary logarithm of the rate at which ranks are learned.
const LAST_SHIFT: u32 = 7;

impl TriangleCoder<'_> {
    /// Codes all targets.
    pub(super) fn targets<C: Coder>(&mut self, coder: &mut C, page: Option<&Page>) {
        let corners = CornersOfVertices::new(&self.shape);
        let mut order: Vec<u32> = (0..self.shape.positions.len() as u32).collect();
        // Keys are not negative, so their bits have the same order.
        order.sort_unstable_by_key(|&p| (self.shape.keys[p as usize].to_bits(), p));
        let mut targets: Vec<u32> = (0..self.shape.vertices.len() as u32).collect();
        let mut links = targets.clone();
        let actual_of = self.actual_targets(page);
        let mut ranks = [AdaptiveSymbol::new(8); 32];
        let (mut wedges, mut neighbors) = (Vec::new(), VertexNeighbors::default());
        for p in order {
            if coder.overran() {
                break;
            }
            let mut first: Option<u32> = None;
            self.shape.wedges.of(p, &mut wedges);
            for &v in &wedges {
                neighbors.gather(&self.shape.triangles, corners.of(v), v, &mut links);
                // All wedges go to the same position.
                if let Some(first) = first {
                    neighbors.prefer(|w| self.is_same_position(w, first));
                }
                let actual = actual_of.get(v as usize).copied().unwrap_or(v);
                let context = if first.is_some() { 16 } else { 0 } + neighbors.known.len().min(15);
                let rank = neighbors.known.iter().position(|&w| w == actual).unwrap_or(OTHER);
                let rank = ranks[context].code(coder, rank, LAST_SHIFT);
                let target = match neighbors.known.get(rank) {
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
        v < CodedShape::IMPORTS
            && w < CodedShape::IMPORTS
            && self.shape.vertices[v as usize] == self.shape.vertices[w as usize]
            || v == w
    }

    /// Codes any vertex.
    fn any_vertex<C: Coder>(&self, coder: &mut C, actual: u32) -> u32 {
        let owned = self.shape.vertices.len() as u32;
        let count = owned + self.shape.imports.len() as u32;
        let place = match actual.checked_sub(CodedShape::IMPORTS) {
            Some(import) => owned + import,
            None => actual,
        };
        let place = code_uniform(coder, count, place);
        if place < owned { place } else { CodedShape::IMPORTS + place - owned }
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
    fn new(shape: &CodedShape) -> Self {
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

    /// Triangles at a vertex.
    fn of(&self, v: u32) -> &[u32] {
        &self.triangles[self.first[v as usize] as usize..self.first[v as usize + 1] as usize]
    }
}

/// Neighbors of a vertex: those at full detail, and the current ones.
#[derive(Default)]
struct VertexNeighbors {
    /// Neighbors at full detail.
    original: Vec<u32>,
    /// Vertices that they have collapsed to so far, each once, at most 15.
    known: Vec<u32>,
}

impl VertexNeighbors {
    /// Finds the neighbors of a vertex in its triangles.
    fn gather(&mut self, triangles: &[[u32; 3]], at: &[u32], v: u32, links: &mut [u32]) {
        self.original.clear();
        self.known.clear();
        for &t in at {
            let [a, b, c] = triangles[t as usize];
            for w in if a == v {
                [b, c]
            } else if b == v {
                [c, a]
            } else {
                [a, b]
            } {
                // There are few neighbors, so a linear search is faster than a set.
                if self.original.contains(&w) || self.original.len() >= MAX_NEIGHBORS {
                    continue;
                }
                self.original.push(w);
                let w = current(links, w);
                if w != v && !self.known.contains(&w) && self.known.len() < OTHER {
                    self.known.push(w);
                }
            }
        }
    }

    /// Moves the first neighbor with a property to the front.
    fn prefer(&mut self, has_property: impl Fn(u32) -> bool) {
        if let Some(at) = self.known.iter().position(|&w| has_property(w)) {
            self.known.swap(0, at);
        }
    }
}
