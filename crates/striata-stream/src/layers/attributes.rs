//! Attributes of new vertices: whom to ask, and where the answers are kept.

use crate::base::hoods::BaseHoods;
use crate::entropy::Coder;
use crate::format::form::{Effort, StreamVersion};
use crate::layers::form::LayerForm;
use crate::layers::hood::{LayerHood, LayerValues};
use crate::layers::model::LayerModel;
use crate::layers::ring_fit::RingFit;
use crate::refine::growth::Growth;
use crate::refine::source::Plan;
use crate::topology::surface::{NONE, Surface, next, previous};
use crate::wedges::split::SplitWedges;

/// The layers of a stream, as far as it has come.
#[derive(Clone, Debug)]
pub(crate) struct Attributes {
    model: LayerModel,
    /// Integers of the vertices, layer by layer.
    values: Vec<LayerValues>,
    own: FittedRing,
    /// Of all vertices of a position together.
    whole: FittedRing,
    /// Which wedge each corner around the position shows, and its place among the corners: by wedge, if there are several.
    by_wedge: Vec<(u32, u32)>,
    /// How much of that is done.
    wedge_end: usize,
    version: StreamVersion,
}

/// Vertices around, and the fit to their places.
#[derive(Clone, Debug, Default)]
struct FittedRing {
    fit: RingFit,
    ring: Vec<u32>,
    places: Vec<[i32; 3]>,
}

/// Corners around a position that are looked at for all its vertices together.
const MOST_CORNERS: usize = 24;

/// What is around a new position.
#[derive(Clone, Copy)]
pub(crate) struct Around<'a> {
    pub(crate) surface: &'a Surface,
    pub(crate) growth: &'a Growth,
    /// Grid coordinates by vertex of the surface.
    pub(crate) places: &'a [[i32; 3]],
    /// Corners at the position, A's first and B's last.
    pub(crate) corners: &'a [u32],
    /// What they show, where that is not one vertex for each position.
    pub(crate) told: Option<&'a SplitWedges>,
}

/// A vertex next to one that is coded, and its place on the grid.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RingVertex {
    pub(crate) vertex: u32,
    pub(crate) place: [i32; 3],
}

/// A vertex that a general step brings.
#[derive(Clone, Debug, Default)]
pub(crate) struct GeneralVertex {
    /// Vertices that it shares triangles with.
    pub(crate) ring: Vec<RingVertex>,
    /// The vertex that it collapses to.
    pub(crate) target: u32,
}

/// A vertex of a new position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NewVertex {
    /// Where the position is on the grid.
    pub(crate) place: [i32; 3],
    /// Which of its vertices it is.
    pub(crate) wedge: u32,
    /// The vertex that it collapses to.
    pub(crate) target: u32,
}

/// What a writer knows: all layers, and the vertex there.
pub(crate) type Actual<'a> = Option<(&'a [LayerValues], u32)>;

/// A writer's layers and the vertex there, of those that the mesh that is given has.
pub(crate) fn actual_layers(plan: Option<&dyn Plan>, vertex: impl FnOnce(&dyn Plan) -> u32) -> Actual<'_> {
    plan.map(|plan| (plan.layers(), vertex(plan)))
}

impl Attributes {
    /// No vertices yet; nothing at all where there are no layers.
    pub(crate) fn new(forms: &[LayerForm], terms: (Effort, StreamVersion)) -> Option<Self> {
        (!forms.is_empty()).then(|| Self {
            model: LayerModel::new(forms, terms),
            values: forms.iter().map(|form| LayerValues::new(form.integer_count())).collect(),
            own: FittedRing::default(),
            whole: FittedRing::default(),
            by_wedge: Vec::new(),
            wedge_end: 0,
            version: terms.1,
        })
    }

    /// The integers of a layer.
    pub(crate) fn integers(&self, layer: usize) -> &[i32] {
        self.values[layer].integers()
    }

    /// Forgets all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        self.values.iter_mut().for_each(|values| values.truncate(vertex_count));
        self.model.truncate(vertex_count);
    }

    /// Codes vertex `wedge` of a position of the base. Version 1 knows nothing but the vertex before it.
    pub(crate) fn base_vertex<C: Coder>(
        &mut self,
        coder: &mut C,
        (hoods, place): (&BaseHoods<'_>, [i32; 3]),
        (vertex, wedge): (u32, u32),
        actual: Actual<'_>,
    ) {
        let before = vertex.checked_sub(1);
        let FittedRing { fit, ring, places } = &mut self.own;
        if self.version > StreamVersion::One {
            let normal = hoods.gather(vertex, ring, places);
            fit.measure(place, places, false);
            fit.normal = normal;
        }
        let mut hood = LayerHood::new(ring.first().copied().or(before), ring, fit);
        hood.sibling_count = wedge;
        hood.is_base = true;
        self.model.code(coder, &mut self.values, &hood, actual);
    }

    /// Makes ready for the vertices of a new position, to be coded in order.
    pub(crate) fn begin_position(&mut self, around: Around<'_>, place: [i32; 3]) {
        self.by_wedge.clear();
        self.wedge_end = 0;
        let Some(told) = around.told.filter(|told| told.targets.len() > 1) else { return };
        let shown = told.wedges.iter().zip(0..).filter(|(wedge, _)| **wedge != NONE);
        self.by_wedge.extend(shown.map(|(&wedge, at)| (wedge, at)));
        self.by_wedge.sort_unstable();
        if self.version > StreamVersion::One {
            let last = told.wedges.len() - 1;
            let corners = (0..told.wedges.len()).filter(|at| told.wedges[*at] != NONE).take(MOST_CORNERS);
            let is_closed = self.whole.gather(around, corners, last);
            self.whole.fit.measure(place, &self.whole.places, is_closed);
        }
    }

    /// Codes a vertex of a new position.
    pub(crate) fn vertex<C: Coder>(
        &mut self,
        coder: &mut C,
        around: Around<'_>,
        NewVertex { place, wedge, target }: NewVertex,
        actual: Actual<'_>,
    ) {
        let last = around.corners.len() - 1;
        let has_several = around.told.is_some_and(|told| told.targets.len() > 1);
        let is_closed = if has_several {
            let rest = &self.by_wedge[self.wedge_end..];
            let own = &rest[..rest.iter().take_while(|(of, _)| *of == wedge).count()];
            self.wedge_end += own.len();
            self.own.gather(around, own.iter().map(|&(_, at)| at as usize), last)
        } else {
            self.own.gather(around, 0..=last, last)
        };
        let is_hidden = has_several && self.version > StreamVersion::One && self.own.ring.is_empty();
        let hood = if is_hidden {
            LayerHood { is_hidden, ..self.whole.hood(target) }
        } else {
            self.own.fit.measure(place, &self.own.places, is_closed);
            self.own.hood(target)
        };
        let hood = match around.told {
            Some(told) if has_several && self.version > StreamVersion::One => LayerHood {
                sibling_count: wedge,
                sibling_target: wedge.checked_sub(1).map(|before| told.targets[before as usize]),
                whole: Some((&self.whole.ring, &self.whole.fit)),
                ..hood
            },
            _ => hood,
        };
        self.model.code(coder, &mut self.values, &hood, actual);
    }

    /// Codes vertices that a general step brings: of each, what it shares triangles with, its target and what is meant.
    pub(crate) fn general_position<'a, C: Coder>(
        &mut self,
        coder: &mut C,
        place: [i32; 3],
        vertices: &[GeneralVertex],
        actual: impl Fn(usize) -> Actual<'a>,
    ) {
        let has_several = vertices.len() > 1;
        if has_several {
            let all = vertices.iter().flat_map(|vertex| &vertex.ring).take(MOST_CORNERS);
            self.whole.set(all.copied(), place);
        }
        for (wedge, vertex) in vertices.iter().enumerate() {
            let is_hidden = has_several && vertex.ring.is_empty();
            self.own.set(vertex.ring.iter().copied(), place);
            let hood = if is_hidden {
                LayerHood { is_hidden, ..self.whole.hood(vertex.target) }
            } else {
                self.own.hood(vertex.target)
            };
            let hood = LayerHood {
                sibling_count: wedge as u32,
                sibling_target: wedge.checked_sub(1).map(|before| vertices[before].target),
                whole: has_several.then_some((&self.whole.ring, &self.whole.fit)),
                ..hood
            };
            self.model.code(coder, &mut self.values, &hood, actual(wedge));
        }
    }
}

impl FittedRing {
    /// These vertices, in no order.
    fn set(&mut self, vertices: impl Iterator<Item = RingVertex>, place: [i32; 3]) {
        self.ring.clear();
        self.places.clear();
        for there in vertices {
            if !self.ring.contains(&there.vertex) {
                self.ring.push(there.vertex);
                self.places.push(there.place);
            }
        }
        self.fit.measure(place, &self.places, false);
    }

    fn hood(&self, target: u32) -> LayerHood<'_> {
        LayerHood::new(Some(target), &self.ring, &self.fit)
    }

    /// Finds the vertices in the triangles of some of the corners around a position, in ring order; true if they close at
    /// the last corner of all.
    fn gather(&mut self, around: Around<'_>, corners: impl Iterator<Item = usize>, last: usize) -> bool {
        self.ring.clear();
        self.places.clear();
        for at in corners {
            let Some(shown) = shown_beside(around, at) else { continue };
            let corner = around.corners[at];
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

/// What the two other corners of a triangle show, if it is there.
fn shown_beside(around: Around<'_>, at: usize) -> Option<[u32; 2]> {
    let Around { surface, growth, corners, told, .. } = around;
    let corner = corners[at];
    let Some(told) = told else {
        let vertices = [next(corner), previous(corner)].map(|c| surface.vertex(c));
        let is_there = vertices.iter().all(|&v| !surface.is_virtual(v));
        return is_there.then(|| vertices.map(|v| growth.wedges(v).start));
    };
    if told.wedges[at] == NONE {
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
