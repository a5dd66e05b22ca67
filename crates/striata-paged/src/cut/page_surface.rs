//! The surface of one page while its steps are undone, from fine to coarse.
//!
//! Everything is numbered as in the page: owned vertices, then imports. A *node* is a position: those that the page
//! owns, then those of its imports.

use std::cmp::Reverse;
use std::collections::HashMap;

use striata::mesh::Bounds;
use striata::view::{NormalCone, Part, Sphere};

use crate::Page;
use crate::hash::IndexHash;
use crate::loaded::LoadedPages;

const NONE: u32 = u32::MAX;

/// The triangles of a page, and the corners at each owned position.
pub(crate) struct PageSurface<'a> {
    page: &'a Page,
    owned_vertices: u32,
    owned_positions: u32,
    pub corners: Vec<[u32; 3]>,
    pub is_alive: Vec<bool>,
    /// Position of each vertex and import, in mesh units.
    points: Vec<[f32; 3]>,
    /// Node of each vertex and import; `None` if they are numbered alike.
    nodes: Option<Vec<u32>>,
    /// First corner at each owned position.
    head: Vec<u32>,
    /// Next corner at the same position.
    next: Vec<u32>,
    star: Vec<u32>,
}

impl<'a> PageSurface<'a> {
    /// The surface of a page at full detail.
    pub(crate) fn new(loaded: &LoadedPages<'a>, slot: u32) -> Self {
        let page = loaded.page(slot);
        let owned_positions = page.first.len() as u32 - 1;
        let imported =
            |place: &crate::loaded::VertexPlace| loaded.page(place.slot).positions[place.vertex as usize];
        let points = page.positions.iter().copied().chain(loaded.imports_of(slot).iter().map(imported));
        let mut surface = Self {
            page,
            owned_vertices: page.positions.len() as u32,
            owned_positions,
            corners: page.triangles.clone(),
            is_alive: vec![true; page.triangles.len()],
            points: points.collect(),
            nodes: nodes_of(loaded, slot),
            head: vec![NONE; owned_positions as usize],
            next: vec![NONE; 3 * page.triangles.len()],
            star: Vec::new(),
        };
        for (corner, &v) in (0..).zip(page.triangles.as_flattened()) {
            surface.link(v, corner);
        }
        surface
    }

    /// Number of nodes of the imports and the owned positions.
    pub(crate) fn node_count(&self) -> usize {
        // Several imports may share a node, so this may be too large.
        self.owned_positions as usize + self.page.imports.len()
    }

    /// The owned positions in the order in which their steps are undone.
    pub(crate) fn order(&self) -> Vec<u32> {
        let keys = &self.page.keys;
        let mut order: Vec<u32> = (0..keys.len() as u32).collect();
        // Keys are not negative, so their bits have the same order.
        order.sort_unstable_by_key(|&p| (keys[p as usize].to_bits(), Reverse(p)));
        order
    }

    /// Node of a vertex or import.
    pub(crate) fn node(&self, v: u32) -> u32 {
        self.nodes.as_ref().map_or(v, |nodes| nodes[v as usize])
    }

    /// Whether the page owns a vertex.
    pub(super) fn owns(&self, v: u32) -> bool {
        v < self.owned_vertices
    }

    fn link(&mut self, v: u32, corner: u32) {
        if self.owns(v) {
            let node = self.node(v) as usize;
            self.next[corner as usize] = self.head[node];
            self.head[node] = corner;
        }
    }

    /// Finds the corners at an owned position.
    pub(crate) fn gather(&mut self, position: u32) {
        self.star.clear();
        let mut corner = self.head[position as usize];
        while corner != NONE {
            if self.is_alive[corner as usize / 3] {
                self.star.push(corner);
            }
            corner = self.next[corner as usize];
        }
    }

    /// Returns the part that a criterion judges for the step of the gathered position: its longest edge is the radius.
    pub(super) fn part(&self, position: u32) -> Part {
        let center = self.points[self.page.first[position as usize] as usize];
        let squared = |v: u32| {
            let point = self.points[v as usize];
            (0..3).map(|a| (point[a] - center[a]).powi(2)).sum::<f32>()
        };
        let ring = self.star.iter().flat_map(|&corner| self.corners[corner as usize / 3]);
        let radius = ring.map(squared).fold(0.0, f32::max).sqrt();
        Part { sphere: Sphere { center, radius }, cone: NormalCone::ALL, error: self.error_of(position) }
    }

    /// Error of the surface without an owned position, in mesh units.
    pub(super) fn error_of(&self, position: u32) -> f32 {
        self.page.errors[position as usize]
    }

    /// Bounds of the triangles at the gathered position before and after its step is undone.
    pub(crate) fn bounds_around(&self, position: u32) -> Bounds {
        let first = self.points[self.page.first[position as usize] as usize];
        let mut bounds = Bounds { min: first, max: first };
        self.for_each_needed(position, |v| {
            for (axis, &x) in self.points[v as usize].iter().enumerate() {
                bounds.min[axis] = bounds.min[axis].min(x);
                bounds.max[axis] = bounds.max[axis].max(x);
            }
        });
        bounds
    }

    /// For each axis, whether a triangle faces against it, and whether one faces along it.
    pub(crate) fn facings(&self) -> [[bool; 2]; 3] {
        let mut facings = [[false; 2]; 3];
        for corners in &self.corners {
            let [a, b, c] = corners.map(|v| self.points[v as usize].map(f64::from));
            for (axis, facing) in facings.iter_mut().enumerate() {
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                let normal = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
                facing[0] |= normal < 0.0;
                facing[1] |= normal > 0.0;
            }
        }
        facings
    }

    /// Bounds of all triangles of the page, whichever of its steps are undone.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        Bounds::of(&self.points)
    }

    /// Calls a function with each vertex that the step of the gathered position needs: its one-ring and its targets.
    pub(crate) fn for_each_needed(&self, position: u32, mut visit: impl FnMut(u32)) {
        for v in self.page.first[position as usize]..self.page.first[position as usize + 1] {
            visit(self.page.targets[v as usize]);
        }
        for &corner in &self.star {
            self.corners[corner as usize / 3].iter().for_each(|&v| visit(v));
        }
    }

    /// Undoes the step of the gathered position.
    pub(crate) fn collapse(&mut self) {
        let star = std::mem::take(&mut self.star);
        for &corner in &star {
            let (t, slot) = (corner as usize / 3, corner as usize % 3);
            self.corners[t][slot] = self.page.targets[self.corners[t][slot] as usize];
            let [a, b, c] = self.corners[t].map(|v| self.node(v));
            self.is_alive[t] = a != b && b != c && c != a;
        }
        for &corner in &star {
            let t = corner as usize / 3;
            if self.is_alive[t] {
                self.link(self.corners[t][corner as usize % 3], corner);
            }
        }
        self.star = star;
    }
}

/// Node of each vertex and import of a page; `None` if they are numbered alike.
fn nodes_of(loaded: &LoadedPages<'_>, slot: u32) -> Option<Vec<u32>> {
    let has_wedges = |page: &Page| page.first.len() != page.positions.len() + 1;
    let page = loaded.page(slot);
    let imports = loaded.imports_of(slot);
    let has_imported_wedges = {
        let mut last = NONE;
        imports.iter().any(|place| {
            let is_other = std::mem::replace(&mut last, place.slot) != place.slot;
            is_other && has_wedges(loaded.page(place.slot))
        })
    };
    if !has_wedges(page) && !has_imported_wedges {
        return None;
    }
    let mut nodes = vec![0; page.positions.len() + imports.len()];
    for (p, wedges) in (0..).zip(page.first.windows(2)) {
        nodes[wedges[0] as usize..wedges[1] as usize].fill(p);
    }
    let mut node_of: HashMap<(u32, u32), u32, IndexHash> = HashMap::default();
    let mut next = page.first.len() as u32 - 1;
    for (node, place) in nodes[page.positions.len()..].iter_mut().zip(imports) {
        *node = *node_of
            .entry((place.slot, loaded.page(place.slot).position_of(place.vertex)))
            .or_insert_with(|| {
                next += 1;
                next - 1
            });
    }
    Some(nodes)
}
