//! Attributes of new vertices: whom to ask, and where the answers are kept.

use super::super::entropy::Coder;
use super::Effort;
use super::growth::Growth;
use super::layer_model::{LayerHood, LayerModel, LayerValues};
use super::layers::LayerForm;
use super::ring_fit::RingFit;
use super::surface::{Surface, next, previous};
use super::wedges::SplitWedges;

/// The layers of a stream, as far as it has come.
#[derive(Clone, Debug)]
pub(super) struct Attributes {
    model: LayerModel,
    /// Integers of the vertices, layer by layer.
    values: Vec<LayerValues>,
    fit: RingFit,
    ring: Vec<u32>,
    places: Vec<[i32; 3]>,
}

/// What is around a new position.
#[derive(Clone, Copy)]
pub(super) struct Around<'a> {
    pub(super) surface: &'a Surface,
    pub(super) growth: &'a Growth,
    /// Grid coordinates by vertex of the surface.
    pub(super) places: &'a [[i32; 3]],
    /// Corners at the position, A's first and B's last.
    pub(super) corners: &'a [u32],
    /// What they show, where that is not one vertex for each position.
    pub(super) told: Option<&'a SplitWedges>,
}

/// A vertex next to one that is coded, and its place on the grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct RingVertex {
    pub(super) vertex: u32,
    pub(super) place: [i32; 3],
}

/// What a writer knows: all layers, and the vertex there.
pub(super) type Actual<'a> = Option<(&'a [LayerValues], u32)>;

impl Attributes {
    /// No vertices yet; nothing at all where there are no layers.
    pub(super) fn new(forms: &[LayerForm], effort: Effort) -> Option<Self> {
        (!forms.is_empty()).then(|| Self {
            model: LayerModel::new(forms, effort),
            values: forms.iter().map(|form| LayerValues::new(form.integer_count())).collect(),
            fit: RingFit::default(),
            ring: Vec::new(),
            places: Vec::new(),
        })
    }

    /// The integers of a layer.
    pub(super) fn integers(&self, layer: usize) -> &[i32] {
        self.values[layer].integers()
    }

    /// Forgets all but the first vertices.
    pub(super) fn truncate(&mut self, vertex_count: usize) {
        self.values.iter_mut().for_each(|values| values.truncate(vertex_count));
    }

    /// Codes a vertex of the base: all that is known is the one before.
    pub(super) fn base_vertex<C: Coder>(&mut self, coder: &mut C, vertex: u32, actual: Actual<'_>) {
        let hood = LayerHood { target: vertex.checked_sub(1), ring: &[], fit: &self.fit };
        self.model.code(coder, &mut self.values, &hood, actual);
    }

    /// Codes wedge `wedge` of a new position, which collapses to vertex `target`.
    pub(super) fn vertex<C: Coder>(
        &mut self,
        coder: &mut C,
        around: Around<'_>,
        (place, wedge, target): ([i32; 3], u32, u32),
        actual: Actual<'_>,
    ) {
        let is_closed = self.gather(around, wedge);
        self.fit.measure(place, &self.places, is_closed);
        let hood = LayerHood { target: Some(target), ring: &self.ring, fit: &self.fit };
        self.model.code(coder, &mut self.values, &hood, actual);
    }

    /// Codes a vertex that a general step brings; `ring` are those that it shares triangles with.
    pub(super) fn general_vertex<C: Coder>(
        &mut self,
        coder: &mut C,
        ring: &[RingVertex],
        (place, target): ([i32; 3], u32),
        actual: Actual<'_>,
    ) {
        self.ring.clear();
        self.ring.extend(ring.iter().map(|there| there.vertex));
        self.places.clear();
        self.places.extend(ring.iter().map(|there| there.place));
        self.fit.measure(place, &self.places, false);
        let hood = LayerHood { target: Some(target), ring: &self.ring, fit: &self.fit };
        self.model.code(coder, &mut self.values, &hood, actual);
    }

    /// Finds the vertices that share triangles with a wedge, in ring order; true where they close.
    fn gather(&mut self, around: Around<'_>, wedge: u32) -> bool {
        self.ring.clear();
        self.places.clear();
        let last = around.corners.len() - 1;
        for (at, &corner) in around.corners.iter().enumerate() {
            let Some(shown) = shown_beside(around, at, wedge) else { continue };
            let surface_vertices = [next(corner), previous(corner)].map(|c| around.surface.vertex(c));
            for (vertex, surface_vertex) in shown.into_iter().zip(surface_vertices) {
                let closes = at == last && self.ring.len() > 2 && self.ring.first() == Some(&vertex);
                if closes {
                    return true;
                }
                if self.ring.last() != Some(&vertex) {
                    self.ring.push(vertex);
                    self.places.push(around.places[surface_vertex as usize]);
                }
            }
        }
        false
    }
}

/// What the two other corners of a triangle show, if its corner at the new position shows the wedge.
fn shown_beside(around: Around<'_>, at: usize, wedge: u32) -> Option<[u32; 2]> {
    let Around { surface, growth, corners, told, .. } = around;
    let corner = corners[at];
    let Some(told) = told else {
        let vertices = [next(corner), previous(corner)].map(|c| surface.vertex(c));
        let is_there = vertices.iter().all(|&v| !surface.is_virtual(v));
        return is_there.then(|| vertices.map(|v| growth.wedges(v).start));
    };
    if told.wedges[at] != wedge {
        return None;
    }
    if at == 0 {
        return Some([told.kept[0], told.ends[0]]);
    }
    if at + 1 == corners.len() {
        return Some([told.ends[1], told.kept[1]]);
    }
    Some([growth.shown(surface, next(corner))?, growth.shown(surface, previous(corner))?])
}
