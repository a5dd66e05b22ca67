//! Attribute values of a stream, and the neighborhoods in which those of new vertices are coded.

use crate::base::neighborhoods::BaseNeighborhoods;
use crate::entropy::Coder;
use crate::format::effort::Effort;
use crate::layers::form::LayerForm;
use crate::layers::layer_neighborhood::{LayerNeighborhood, LayerValues};
use crate::layers::model::LayerModel;
use crate::layers::ring_fit::RingFit;
use crate::refine::growth::GrowingMesh;
use crate::refine::source::EncoderInput;
use crate::topology::surface::{NONE, Surface, next, previous};
use crate::wedges::split::SplitWedges;

/// All attribute layers of a stream, as far as it has been coded.
#[derive(Clone, Debug)]
pub(crate) struct Attributes {
    model: LayerModel,
    /// Integers of the vertices, layer by layer.
    values: Vec<LayerValues>,
    /// Ring of the current vertex.
    own: FittedRing,
    /// Ring of all vertices of a position together.
    whole: FittedRing,
    /// Wedge of each corner around the position, and the index of the corner; sorted by wedge. Only used
    /// if the position has several vertices.
    by_wedge: Vec<(u32, u32)>,
    /// Number of its entries that have been used.
    wedge_end: usize,
}

/// The vertices around a vertex, and the affine fit to their positions.
#[derive(Clone, Debug, Default)]
struct FittedRing {
    fit: RingFit,
    ring: Vec<u32>,
    grid_points: Vec<[i32; 3]>,
}

/// Maximum number of corners around a position that are used for all its vertices together.
const MOST_CORNERS: usize = 24;

/// The surroundings of a new position.
#[derive(Clone, Copy)]
pub(crate) struct AttributeContext<'a> {
    /// The surface, including the split.
    pub surface: &'a Surface,
    /// The mesh without the new position.
    pub growth: &'a GrowingMesh,
    /// Grid coordinates of each vertex of the surface.
    pub grid_points: &'a [[i32; 3]],
    /// Corners at the position, starting with the one in A and ending with the one in B.
    pub corners: &'a [u32],
    /// Wedges that the corners refer to, unless each position has exactly one vertex.
    pub split_wedges: Option<&'a SplitWedges>,
}

/// A vertex next to the current one, with its grid coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RingVertex {
    pub vertex: u32,
    pub grid_point: [i32; 3],
}

/// A vertex that a general step adds.
#[derive(Clone, Debug, Default)]
pub(crate) struct GeneralVertex {
    /// Vertices that share triangles with it.
    pub ring: Vec<RingVertex>,
    /// The vertex that it collapses to.
    pub target: u32,
}

/// A vertex of a new position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NewVertex {
    /// Grid coordinates of the position.
    pub grid_point: [i32; 3],
    /// Index of the vertex within the position.
    pub wedge: u32,
    /// The vertex that it collapses to.
    pub target: u32,
}

/// A writer's data: all layers, and the index of the current vertex in them.
type Actual<'a> = Option<(&'a [LayerValues], u32)>;

/// Returns a writer's layers and the index of the current vertex in the source mesh.
pub(crate) fn actual_layers(
    input: Option<&dyn EncoderInput>,
    vertex: impl FnOnce(&dyn EncoderInput) -> u32,
) -> Actual<'_> {
    input.map(|input| (input.layers(), vertex(input)))
}

/// Neighbors and position of a vertex of the base mesh.
pub(crate) struct BasePlace<'a> {
    /// Neighbors of all vertices of the base mesh.
    pub neighborhoods: &'a BaseNeighborhoods<'a>,
    /// Its position on the grid.
    pub grid_point: [i32; 3],
}

/// A vertex, and its number among the wedges of its position.
pub(crate) struct WedgeOfVertex {
    /// Index of the vertex.
    pub vertex: u32,
    /// Its number among the wedges.
    pub wedge: u32,
}

impl Attributes {
    /// Creates layers without vertices, or `None` if there are no layers.
    pub(crate) fn new(forms: &[LayerForm], effort: Effort) -> Option<Self> {
        (!forms.is_empty()).then(|| Self {
            model: LayerModel::new(forms, effort),
            values: forms.iter().map(|form| LayerValues::new(form.integer_count())).collect(),
            own: FittedRing::default(),
            whole: FittedRing::default(),
            by_wedge: Vec::new(),
            wedge_end: 0,
        })
    }

    /// Returns the integers of a layer.
    pub(crate) fn integers(&self, layer: usize) -> &[i32] {
        self.values[layer].integers()
    }

    /// Removes all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        self.values.iter_mut().for_each(|values| values.truncate(vertex_count));
        self.model.truncate(vertex_count);
    }

    /// Codes vertex `wedge` of a position of the base mesh.
    pub(crate) fn base_vertex<C: Coder>(
        &mut self,
        coder: &mut C,
        BasePlace { neighborhoods, grid_point }: BasePlace<'_>,
        WedgeOfVertex { vertex, wedge }: WedgeOfVertex,
        actual: Actual<'_>,
    ) {
        let before = vertex.checked_sub(1);
        let FittedRing { fit, ring, grid_points } = &mut self.own;
        let normal = neighborhoods.gather(vertex, ring, grid_points);
        fit.measure(grid_point, grid_points, false);
        fit.normal = normal;
        let mut neighborhood = LayerNeighborhood::new(ring.first().copied().or(before), ring, fit);
        neighborhood.sibling_count = wedge;
        neighborhood.is_base = true;
        self.model.code(coder, &mut self.values, &neighborhood, actual);
    }

    /// Prepares for coding the vertices of a new position in order.
    pub(crate) fn begin_position(&mut self, around: AttributeContext<'_>, grid_point: [i32; 3]) {
        self.by_wedge.clear();
        self.wedge_end = 0;
        let Some(split_wedges) = around.split_wedges.filter(|split_wedges| split_wedges.targets.len() > 1)
        else {
            return;
        };
        let shown = split_wedges.wedges.iter().zip(0..).filter(|(wedge, _)| **wedge != NONE);
        self.by_wedge.extend(shown.map(|(&wedge, at)| (wedge, at)));
        self.by_wedge.sort_unstable();
        let last = split_wedges.wedges.len() - 1;
        let corners =
            (0..split_wedges.wedges.len()).filter(|at| split_wedges.wedges[*at] != NONE).take(MOST_CORNERS);
        let is_closed = self.whole.gather(around, corners, last);
        self.whole.fit.measure(grid_point, &self.whole.grid_points, is_closed);
    }

    /// Codes a vertex of a new position.
    pub(crate) fn vertex<C: Coder>(
        &mut self,
        coder: &mut C,
        around: AttributeContext<'_>,
        NewVertex { grid_point, wedge, target }: NewVertex,
        actual: Actual<'_>,
    ) {
        let last = around.corners.len() - 1;
        let has_several = around.split_wedges.is_some_and(|split_wedges| split_wedges.targets.len() > 1);
        let is_closed = if has_several {
            let rest = &self.by_wedge[self.wedge_end..];
            let own = &rest[..rest.iter().take_while(|(of, _)| *of == wedge).count()];
            self.wedge_end += own.len();
            self.own.gather(around, own.iter().map(|&(_, at)| at as usize), last)
        } else {
            self.own.gather(around, 0..=last, last)
        };
        let is_hidden = has_several && self.own.ring.is_empty();
        let neighborhood = if is_hidden {
            LayerNeighborhood { is_hidden, ..self.whole.neighborhood(target) }
        } else {
            self.own.fit.measure(grid_point, &self.own.grid_points, is_closed);
            self.own.neighborhood(target)
        };
        let neighborhood = match around.split_wedges {
            Some(split_wedges) if has_several => LayerNeighborhood {
                sibling_count: wedge,
                sibling_target: wedge.checked_sub(1).map(|before| split_wedges.targets[before as usize]),
                whole: Some((&self.whole.ring, &self.whole.fit)),
                ..neighborhood
            },
            _ => neighborhood,
        };
        self.model.code(coder, &mut self.values, &neighborhood, actual);
    }

    /// Codes the vertices that a general step adds. `actual` returns a writer's data for each of them.
    pub(crate) fn general_position<'a, C: Coder>(
        &mut self,
        coder: &mut C,
        grid_point: [i32; 3],
        vertices: &[GeneralVertex],
        actual: impl Fn(usize) -> Actual<'a>,
    ) {
        let has_several = vertices.len() > 1;
        if has_several {
            let all = vertices.iter().flat_map(|vertex| &vertex.ring).take(MOST_CORNERS);
            self.whole.set(all.copied(), grid_point);
        }
        for (wedge, vertex) in vertices.iter().enumerate() {
            let is_hidden = has_several && vertex.ring.is_empty();
            self.own.set(vertex.ring.iter().copied(), grid_point);
            let neighborhood = if is_hidden {
                LayerNeighborhood { is_hidden, ..self.whole.neighborhood(vertex.target) }
            } else {
                self.own.neighborhood(vertex.target)
            };
            let neighborhood = LayerNeighborhood {
                sibling_count: wedge as u32,
                sibling_target: wedge.checked_sub(1).map(|before| vertices[before].target),
                whole: has_several.then_some((&self.whole.ring, &self.whole.fit)),
                ..neighborhood
            };
            self.model.code(coder, &mut self.values, &neighborhood, actual(wedge));
        }
    }
}

impl FittedRing {
    /// Replaces the ring by these vertices, in no particular order.
    fn set(&mut self, vertices: impl Iterator<Item = RingVertex>, grid_point: [i32; 3]) {
        self.ring.clear();
        self.grid_points.clear();
        for there in vertices {
            if !self.ring.contains(&there.vertex) {
                self.ring.push(there.vertex);
                self.grid_points.push(there.grid_point);
            }
        }
        self.fit.measure(grid_point, &self.grid_points, false);
    }

    /// Returns the neighborhood of a vertex with this ring.
    fn neighborhood(&self, target: u32) -> LayerNeighborhood<'_> {
        LayerNeighborhood::new(Some(target), &self.ring, &self.fit)
    }

    /// Collects the vertices in the triangles of some of the corners around a position, in ring order.
    /// Returns whether they form a closed ring, which requires that `last` is among the corners.
    fn gather(
        &mut self,
        around: AttributeContext<'_>,
        corners: impl Iterator<Item = usize>,
        last: usize,
    ) -> bool {
        self.ring.clear();
        self.grid_points.clear();
        for at in corners {
            let Some(shown) = other_vertices(around, at) else { continue };
            let corner = around.corners[at];
            let surface_vertices = [next(corner), previous(corner)].map(|c| around.surface.vertex(c));
            for (vertex, surface_vertex) in shown.into_iter().zip(surface_vertices) {
                let closes = at == last && self.ring.len() > 2 && self.ring.first() == Some(&vertex);
                if closes {
                    return true;
                }
                if self.ring.last() != Some(&vertex) {
                    self.ring.push(vertex);
                    self.grid_points.push(around.grid_points[surface_vertex as usize]);
                }
            }
        }
        false
    }
}

/// Returns the vertices that the other two corners of a triangle refer to, if the triangle exists.
fn other_vertices(around: AttributeContext<'_>, at: usize) -> Option<[u32; 2]> {
    let AttributeContext { surface, growth, corners, split_wedges, .. } = around;
    let corner = corners[at];
    let Some(split_wedges) = split_wedges else {
        let vertices = [next(corner), previous(corner)].map(|c| surface.vertex(c));
        let is_there = vertices.iter().all(|&v| !surface.is_virtual(v));
        return is_there.then(|| vertices.map(|v| growth.wedges(v).start));
    };
    if split_wedges.wedges[at] == NONE {
        return None;
    }
    if at == 0 {
        return Some([split_wedges.kept[0], split_wedges.ends[0]]);
    }
    if at + 1 == corners.len() {
        return Some([split_wedges.ends[1], split_wedges.kept[1]]);
    }
    Some([growth.shown(surface, next(corner))?, growth.shown(surface, previous(corner))?])
}
