//! The traversal of all triangles. One function encodes and decodes: a writer follows the page, and a reader ignores
//! the values that it passes in.

use striata::mesh::AttributeLayer;
use striata::simplify::cells::CellMesh;
use striata_stream::entropy::{AdaptiveBit, Coder, QuickNumber, Rate, code_uniform};

use super::border::{Border, Gate};
use super::counts::{PageCounts, UNKNOWN};
use super::vertex_models::{VertexModels, VertexSite};
use super::wedges::PageWedges;
use crate::error::PageDefect;
use crate::{Import, Metadata, Page, PageId};

/// Third corner of a triangle beyond a gate.
const CLOSED: usize = 0;
const NEW: usize = 1;
const CANDIDATES: usize = 2;
const OTHER: usize = 6;

/// Part of a page that has been coded. Owned vertices are numbered as they are met, imports from
/// [`CodedShape::IMPORTS`].
#[derive(Default)]
pub(super) struct CodedShape {
    /// Positions, in the order in which they are met.
    pub positions: Vec<[f32; 3]>,
    /// Vertices of each position.
    pub wedges: PageWedges,
    /// Position of each vertex.
    pub vertices: Vec<u32>,
    pub layers: Vec<AttributeLayer>,
    pub keys: Vec<f32>,
    pub errors: Vec<f32>,
    pub targets: Vec<u32>,
    pub imports: Vec<Import>,
    pub triangles: Vec<[u32; 3]>,
    pub groups: Vec<u32>,
    pub triangle_layers: Vec<AttributeLayer>,
}

impl CodedShape {
    /// Number of the first import.
    pub(super) const IMPORTS: u32 = 1 << 25;
}

/// A corner at a known node.
#[derive(Clone, Copy)]
struct KnownCorner {
    node: u32,
    /// Number of its vertex in the page that is written.
    actual: u32,
}

/// Codes the triangles of a page, with their vertices, groups and data.
pub(super) struct TriangleCoder<'a> {
    pub counts: &'a PageCounts,
    pub metadata: &'a Metadata,
    pub is_base: bool,
    pub shape: CodedShape,
    pub models: VertexModels,
    border: Border,
    kinds: Vec<[AdaptiveBit; 7]>,
    /// The two last kinds, as context.
    history: usize,
    is_import: Vec<AdaptiveBit>,
    same_wedge: Vec<AdaptiveBit>,
    wedge_rank: QuickNumber,
    same_group: AdaptiveBit,
    group: QuickNumber,
    lone: QuickNumber,
    /// In a writer, the number that each vertex of the page has in this coder; `u32::MAX` before it is met.
    pub met: Vec<u32>,
}

const UNMET: u32 = u32::MAX;

impl<'a> TriangleCoder<'a> {
    pub(super) fn new(counts: &'a PageCounts, metadata: &'a Metadata, is_base: bool) -> Self {
        let bit = AdaptiveBit::new(Rate::Quick);
        let CellMesh { layers, triangle_layers, .. } = metadata.empty_mesh();
        let shape = CodedShape { layers, triangle_layers, ..CodedShape::default() };
        Self {
            counts,
            metadata,
            is_base,
            shape,
            models: VertexModels::new(metadata),
            border: Border::new(counts.positions + counts.imports, counts.triangles),
            kinds: vec![[bit; 7]; 49 * 4],
            history: 0,
            is_import: vec![bit; 4],
            same_wedge: vec![bit; 3],
            wedge_rank: QuickNumber::new(1, Rate::Quick),
            same_group: bit,
            group: QuickNumber::new(1, Rate::Quick),
            lone: QuickNumber::new(2, Rate::Quick),
            met: Vec::new(),
        }
    }

    /// Codes everything.
    pub(super) fn run<C: Coder>(&mut self, coder: &mut C, page: Option<&Page>) {
        self.met = page.map_or(Vec::new(), |page| vec![UNMET; page.positions.len() + page.imports.len()]);
        while self.shape.triangles.len() < self.counts.triangles {
            match self.border.pop() {
                Some(gate) => self.beyond(coder, page, gate),
                None => self.seed(coder, page),
            }
            if coder.overran() {
                return;
            }
        }
        self.lone_vertices(coder, page);
        if !self.is_base {
            self.targets(coder, page);
        }
        self.triangle_layers(coder, page);
    }

    /// The page that has been read.
    pub(super) fn into_page(self, id: PageId) -> Result<Page, PageDefect> {
        let is_base = self.is_base;
        self.shape.into_page(id, is_base)
    }

    /// The next triangle of the page that is written, and its group.
    fn actual(&self, page: Option<&Page>) -> Option<([u32; 3], u32)> {
        let index = self.shape.triangles.len();
        let triangle = *page?.triangles.get(index)?;
        Some((triangle, page?.groups.get(index).copied().unwrap_or(0)))
    }

    /// Node of a vertex as numbered here.
    fn node_of(&self, v: u32) -> u32 {
        match v.checked_sub(CodedShape::IMPORTS) {
            Some(import) => self.counts.positions as u32 + import,
            None => self.shape.vertices[v as usize],
        }
    }

    /// Node of a vertex of the page that is written; `None` if it is new.
    fn met_node(&self, page: &Page, v: u32) -> Option<u32> {
        let met = self.met[v as usize];
        if met != UNMET {
            return Some(self.node_of(met));
        }
        let owned = page.positions.len() as u32;
        if v >= owned {
            return None;
        }
        // Another wedge of the position may be known.
        let p = page.first.partition_point(|&first| first <= v) - 1;
        (page.first[p]..page.first[p + 1])
            .map(|w| self.met[w as usize])
            .find(|&met| met != UNMET)
            .map(|met| self.node_of(met))
    }

    /// Codes the triangle beyond an open edge, or that there is none.
    fn beyond<C: Coder>(&mut self, coder: &mut C, page: Option<&Page>, gate: Gate) {
        let candidates = self.border.candidates(&gate);
        let [a, b] = gate.nodes;
        let actual = self.actual(page).filter(|(t, _)| {
            page.is_some_and(|page| {
                self.met_node(page, t[0]) == Some(b) && self.met_node(page, t[1]) == Some(a)
            })
        });
        let third = actual.map(|(t, _)| page.and_then(|page| self.met_node(page, t[2])));
        let kind = match third {
            None => CLOSED,
            Some(None) => NEW,
            Some(Some(c)) => candidates.iter().position(|&k| k == c).map_or(OTHER, |k| CANDIDATES + k),
        };
        let kind = self.kind(coder, &candidates, kind);
        if kind == CLOSED {
            self.border.close(gate.nodes);
            return;
        }
        let c = match kind {
            NEW => None,
            OTHER => {
                let known = self.known_nodes();
                let place = self.place_of_node(third.flatten().unwrap_or(0));
                let place = code_uniform(coder, known.max(1), place);
                Some(self.node_at(place))
            }
            _ => Some(candidates[kind - CANDIDATES]),
        };
        let corners = actual.map_or([0; 3], |(t, _)| t);
        let group = self.group(coder, Some(gate.group), actual.map_or(0, |(_, group)| group));
        let vb = self.wedge(coder, page, KnownCorner { node: b, actual: corners[0] }, gate.vertices[1]);
        let va = self.wedge(coder, page, KnownCorner { node: a, actual: corners[1] }, gate.vertices[0]);
        let vc = match c {
            Some(c) => {
                let expected = self.border.last_vertex(c);
                self.wedge(coder, page, KnownCorner { node: c, actual: corners[2] }, expected)
            }
            None => self.new_node(coder, page, corners[2], Some(&gate)),
        };
        self.push([vb, va, vc], group, true);
    }

    /// Codes a triangle that is not attached to any open edge.
    fn seed<C: Coder>(&mut self, coder: &mut C, page: Option<&Page>) {
        let (corners, group) = self.actual(page).unwrap_or(([0; 3], 0));
        let group = self.group(coder, None, group);
        let mut vertices = [0; 3];
        for i in 0..3 {
            let known = page.and_then(|page| self.met_node(page, corners[i]));
            let kind = self.is_known_node(coder, known.is_some());
            vertices[i] = if kind {
                let place = self.place_of_node(known.unwrap_or(0));
                let count = self.known_nodes().max(1);
                let place = code_uniform(coder, count, place);
                let node = self.node_at(place);
                let expected = self.border.last_vertex(node);
                self.wedge(coder, page, KnownCorner { node, actual: corners[i] }, expected)
            } else {
                self.new_node(coder, page, corners[i], None)
            };
        }
        self.push(vertices, group, false);
    }

    fn push(&mut self, vertices: [u32; 3], group: u32, attached: bool) {
        let nodes = vertices.map(|v| self.node_of(v));
        self.border.add(nodes, vertices, group, attached);
        self.shape.triangles.push(vertices);
        self.shape.groups.push(group);
    }

    /// Number of nodes met so far: positions, then imports.
    fn known_nodes(&self) -> u32 {
        (self.shape.positions.len() + self.shape.imports.len()) as u32
    }

    /// Place of a node among those met.
    fn place_of_node(&self, node: u32) -> u32 {
        match node.checked_sub(self.counts.positions as u32) {
            Some(import) => self.shape.positions.len() as u32 + import,
            None => node,
        }
    }

    fn node_at(&self, place: u32) -> u32 {
        match place.checked_sub(self.shape.positions.len() as u32) {
            Some(import) => self.counts.positions as u32 + import,
            None => place,
        }
    }

    /// Codes whether a corner of a seed is known.
    fn is_known_node<C: Coder>(&mut self, coder: &mut C, actual: bool) -> bool {
        if self.known_nodes() == 0 {
            return false;
        }
        if self.is_full() {
            return true;
        }
        self.is_import[3].code(coder, actual)
    }

    /// Whether all nodes have been met.
    fn is_full(&self) -> bool {
        self.known_nodes() as usize == self.counts.positions + self.counts.imports
    }

    /// Codes the kind of triangle beyond a gate, as a tree of decisions that skips impossible ones.
    fn kind<C: Coder>(&mut self, coder: &mut C, candidates: &[u32; 4], actual: usize) -> usize {
        let available = candidates.iter().take(2).filter(|&&c| c != u32::MAX).count();
        let bits = &mut self.kinds[self.history * 4 + available];
        let is_full = self.shape.positions.len() + self.shape.imports.len()
            == self.counts.positions + self.counts.imports;
        let kind = if !is_full && bits[NEW].code(coder, actual == NEW) {
            NEW
        } else {
            let mut kind = None;
            for (k, _) in candidates.iter().enumerate().filter(|(_, c)| **c != u32::MAX) {
                if bits[CANDIDATES + k].code(coder, actual == CANDIDATES + k) {
                    kind = Some(CANDIDATES + k);
                    break;
                }
            }
            kind.unwrap_or_else(|| if bits[CLOSED].code(coder, actual == CLOSED) { CLOSED } else { OTHER })
        };
        self.history = self.history % 7 * 7 + kind;
        kind
    }

    fn group<C: Coder>(&mut self, coder: &mut C, expected: Option<u32>, actual: u32) -> u32 {
        if self.metadata.groups.len() < 2 {
            return 0;
        }
        let expected = expected.or_else(|| self.shape.groups.last().copied()).unwrap_or(0);
        if self.same_group.code(coder, actual == expected) {
            return expected;
        }
        self.group.unsigned(coder, 0, actual.into()) as u32
    }

    /// Codes which wedge of a known node a corner is.
    fn wedge<C: Coder>(
        &mut self,
        coder: &mut C,
        page: Option<&Page>,
        corner: KnownCorner,
        expected: u32,
    ) -> u32 {
        let KnownCorner { node, actual } = corner;
        if let Some(import) = node.checked_sub(self.counts.positions as u32) {
            return CodedShape::IMPORTS + import;
        }
        if self.counts.positions == self.counts.vertices {
            return node;
        }
        let met = page.map_or(UNMET, |_| self.met[actual as usize]);
        let [same, is_known, _] = &mut self.same_wedge[..] else { return expected };
        // In damaged bytes, a seed may name a node twice, which has no last vertex yet.
        if same.code(coder, met == expected) && expected != UNMET {
            return expected;
        }
        let is_full = self.shape.vertices.len() == self.counts.vertices;
        let count = self.shape.wedges.count(node);
        if is_full || (count > 1 && is_known.code(coder, met != UNMET)) {
            let rank = self.shape.wedges.latest_first(node).position(|w| w == met).unwrap_or(0);
            let rank = self.wedge_rank.unsigned(coder, 0, rank as u64) as usize;
            // Damaged bytes may name a wedge that does not exist.
            return self.shape.wedges.latest_first(node).take(rank + 1).last().unwrap_or(expected);
        }
        self.new_vertex(coder, page, actual, VertexSite { node: Some(node), near: [UNMET; 3] })
    }

    /// Codes a corner at a node that has not been met.
    fn new_node<C: Coder>(
        &mut self,
        coder: &mut C,
        page: Option<&Page>,
        actual: u32,
        gate: Option<&Gate>,
    ) -> u32 {
        let is_import = page.is_some_and(|page| actual as usize >= page.positions.len());
        let near = gate.map_or([UNMET; 3], |gate| gate.vertices);
        let can_own = self.shape.positions.len() < self.counts.positions;
        let can_import = self.shape.imports.len() < self.counts.imports;
        let context = near[..2].iter().filter(|&&v| v != UNMET && v >= CodedShape::IMPORTS).count();
        let is_import = match (can_own, can_import) {
            (true, true) => self.is_import[context].code(coder, is_import),
            (false, _) => true,
            (true, false) => false,
        };
        if !is_import {
            return self.new_vertex(coder, page, actual, VertexSite { node: None, near });
        }
        let import = page.map_or(UNKNOWN, |page| {
            self.met[actual as usize] = CodedShape::IMPORTS + self.shape.imports.len() as u32;
            page.imports[actual as usize - page.positions.len()]
        });
        let import = self.import(coder, import, near);
        self.shape.imports.push(import);
        CodedShape::IMPORTS + self.shape.imports.len() as u32 - 1
    }

    /// Codes owned vertices and imports that no triangle uses.
    fn lone_vertices<C: Coder>(&mut self, coder: &mut C, page: Option<&Page>) {
        while self.shape.positions.len() < self.counts.positions && !coder.overran() {
            let actual = page.map_or(0, |page| page.first[self.shape.positions.len()]);
            self.new_vertex(coder, page, actual, VertexSite { node: None, near: [UNMET; 3] });
        }
        let (mut position, mut next) = (0, 0);
        while self.shape.vertices.len() < self.counts.vertices && !coder.overran() {
            let actual = page.and_then(|page| {
                let found = (next..page.positions.len() as u32).find(|&v| self.met[v as usize] == UNMET);
                next = found.map_or(next, |v| v + 1);
                found
            });
            let at = match (page, actual) {
                (Some(page), Some(v)) => page.first.partition_point(|&first| first <= v) as u32 - 1,
                _ => position,
            };
            // Positions are numbered here as in the page.
            let step = self.lone.unsigned(coder, 0, at.saturating_sub(position).into());
            let last = self.counts.positions.saturating_sub(1) as u64;
            position = u64::from(position).saturating_add(step).min(last) as u32;
            self.new_vertex(
                coder,
                page,
                actual.unwrap_or(0),
                VertexSite { node: Some(position), near: [UNMET; 3] },
            );
        }
        while self.shape.imports.len() < self.counts.imports && !coder.overran() {
            let index = self.shape.imports.len();
            let import = page.map_or(UNKNOWN, |page| {
                self.met[page.positions.len() + index] = CodedShape::IMPORTS + index as u32;
                page.imports[index]
            });
            let import = self.import(coder, import, [UNMET; 3]);
            self.shape.imports.push(import);
        }
    }
}
