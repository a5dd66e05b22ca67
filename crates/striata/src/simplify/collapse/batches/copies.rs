//! Gives coincident copies of a surface separate positions, so that each of them can be collapsed.
//!
//! Welding merges equal coordinates. A decal, the back of a two-sided sheet and a part that is moved away only
//! by its joint then share all positions with another surface, and each of their edges has four triangles or
//! more, where no surface batch can remove anything. Here every surface gets a layer, and a position with
//! triangles of several layers is divided:
//!
//! ```text
//! sheet   triangles that are joined at edges, by their vertices if the edge has more than two triangles
//! clash   two sheets have a triangle with the same corners, or hang on different joints at a common edge
//! layer   of a sheet: the first one that no earlier sheet with which it clashes is in
//! ```
//!
//! Surfaces that do not clash share layer 0, so pages that meet at a spine stay together, and a mesh without
//! copies stays as it is. A surface that touches itself is a single sheet and is not divided. Copies of a
//! position follow each other, so they are collapsed alike as long as their costs are equal.
//!
//! Time O(n log n), for the few meshes that have copies; otherwise that of [`Adjacency`].

use crate::mesh::{
    Adjacency, AttributeLayer, DisjointSets, Edge, IndexedMesh, PositionIndex, Semantic, Welded,
};
use crate::simplify::collapse::cost_evaluator::locked_positions;
use crate::simplify::options::SequenceOptions;

/// Maximum number of layers; later copies share the last one, so that time does not become quadratic.
const MAX_LAYERS: usize = 256;

/// A place where sheets may clash: an edge, or the corners of several triangles.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Contact {
    /// First triangle of the sheet.
    sheet: u32,
    place: u32,
    /// Sheets clash at the place if both numbers differ: the joints of an edge's ends, or the sheet twice.
    key: [u32; 2],
}

/// Divides the positions at which copies of a surface coincide. Locked positions are not divided.
pub(super) fn separate_copies(welded: Welded, options: &SequenceOptions) -> Welded {
    let adjacency = Adjacency::of_positions(&welded.mesh, &welded.positions);
    if !adjacency.edges().any(|edge| edge.is_non_manifold()) {
        return welded;
    }
    let layers = layers_of_triangles(&welded.mesh, &adjacency);
    if layers.iter().all(|&layer| layer == 0) {
        return welded;
    }
    let is_locked = locked_positions(&welded, &options.locked_vertices, options.group_borders);
    divide(
        welded,
        &adjacency,
        |position, triangle| {
            if is_locked[position as usize] { 0 } else { layers[triangle as usize] }
        },
    )
}

/// Returns whether each position lies in the same place as the previous one; only copies do.
pub(super) fn marked_copies(welded: &Welded) -> Vec<bool> {
    let at = |p: u32| welded.mesh.positions[welded.positions.first_vertex(p) as usize];
    (0..welded.positions.position_count() as u32).map(|p| p > 0 && at(p) == at(p - 1)).collect()
}

/// Returns the layer of each triangle.
fn layers_of_triangles(mesh: &IndexedMesh, adjacency: &Adjacency) -> Vec<u32> {
    let mut sheets = sheets(mesh, adjacency);
    let mut contacts = Vec::new();
    let mut place_count = 0;
    add_copies(adjacency, &mut sheets, &mut contacts, &mut place_count);
    add_joints(mesh, adjacency, &mut sheets, &mut contacts, &mut place_count);
    contacts.sort_unstable();
    contacts.dedup();
    let mut layers = vec![0; mesh.triangle_count()];
    // Layers and keys of the sheets so far at each place.
    let mut taken: Vec<Vec<(u32, [u32; 2])>> = vec![Vec::new(); place_count as usize];
    let mut is_free = Vec::new();
    for sheet in contacts.chunk_by(|a, b| a.sheet == b.sheet) {
        is_free.clear();
        is_free.resize(MAX_LAYERS, true);
        for &Contact { place, key, .. } in sheet {
            let clashes = |other: &[u32; 2]| key[0] != other[0] && key[1] != other[1];
            let others = taken[place as usize].iter().filter(|(_, other)| clashes(other));
            others.for_each(|&(layer, _)| is_free[layer as usize] = false);
        }
        let layer = is_free.iter().position(|&is_free| is_free).unwrap_or(MAX_LAYERS - 1) as u32;
        for &Contact { place, key, .. } in sheet {
            let taken = &mut taken[place as usize];
            if taken.len() < MAX_LAYERS && !taken.contains(&(layer, key)) {
                taken.push((layer, key));
            }
        }
        layers[sheet[0].sheet as usize] = layer;
    }
    (0..layers.len()).for_each(|triangle| layers[triangle] = layers[sheets.root(triangle as u32) as usize]);
    layers
}

/// Joins triangles to sheets: the two at an edge, or those that alone share two vertices at an edge with more
/// triangles.
fn sheets(mesh: &IndexedMesh, adjacency: &Adjacency) -> DisjointSets {
    let mut sheets = DisjointSets::new(mesh.triangle_count());
    let mut sides = Vec::new();
    for edge in adjacency.edges().filter(|edge| !edge.is_boundary()) {
        sides.clear();
        sides.extend(sides_of(mesh, edge));
        if edge.is_non_manifold() {
            sides.sort_unstable();
        } else {
            sides.iter_mut().for_each(|(vertices, _)| *vertices = edge.ends);
        }
        for run in sides.chunk_by(|a, b| a.0 == b.0) {
            if let &[(_, a), (_, b)] = run
                && corners(adjacency, a) != corners(adjacency, b)
            {
                sheets.join(a, b);
            }
        }
    }
    sheets
}

/// Returns the triangles at an edge, each with its vertices at the lower and at the higher end.
fn sides_of<'a>(mesh: &'a IndexedMesh, edge: Edge<'a>) -> impl Iterator<Item = ([u32; 2], u32)> + 'a {
    let vertex = |side: u32, k: u32| mesh.triangles[side as usize / 3][(side + k) as usize % 3];
    let forward = edge.forward.iter().map(move |&side| ([vertex(side, 0), vertex(side, 1)], side / 3));
    let backward = edge.backward.iter().map(move |&side| ([vertex(side, 1), vertex(side, 0)], side / 3));
    forward.chain(backward)
}

/// Returns the positions of a triangle, ascending.
fn corners(adjacency: &Adjacency, triangle: u32) -> [u32; 3] {
    let mut corners = adjacency.triangles()[triangle as usize];
    corners.sort_unstable();
    corners
}

/// Adds the contacts of triangles with the same corners.
fn add_copies(
    adjacency: &Adjacency,
    sheets: &mut DisjointSets,
    contacts: &mut Vec<Contact>,
    place_count: &mut u32,
) {
    let mut triangles: Vec<([u32; 3], u32)> =
        (0..adjacency.triangles().len() as u32).map(|t| (corners(adjacency, t), t)).collect();
    triangles.sort_unstable();
    for copies in triangles.chunk_by(|a, b| a.0 == b.0).filter(|copies| copies.len() > 1) {
        contacts.extend(copies.iter().map(|&(_, triangle)| {
            let sheet = sheets.root(triangle);
            Contact { sheet, place: *place_count, key: [sheet; 2] }
        }));
        *place_count += 1;
    }
}

/// Adds the contacts of sheets at edges with more than two triangles if these hang on different joints.
fn add_joints(
    mesh: &IndexedMesh,
    adjacency: &Adjacency,
    sheets: &mut DisjointSets,
    contacts: &mut Vec<Contact>,
    place_count: &mut u32,
) {
    let joints = strongest_joints(mesh);
    if joints.is_empty() {
        return;
    }
    for edge in adjacency.edges().filter(|edge| edge.is_non_manifold()) {
        let before = contacts.len();
        contacts.extend(sides_of(mesh, edge).map(|(vertices, triangle)| {
            let key = vertices.map(|v| joints[v as usize]);
            Contact { sheet: sheets.root(triangle), place: *place_count, key }
        }));
        let [first, others @ ..] = &contacts[before..] else { continue };
        if others.iter().all(|other| other.key == first.key) {
            contacts.truncate(before);
        } else {
            *place_count += 1;
        }
    }
}

/// Returns the joint with the largest weight of each vertex; empty if the mesh has no joints.
fn strongest_joints(mesh: &IndexedMesh) -> Vec<u32> {
    let weights_of = |layer: &AttributeLayer| match layer.semantic {
        Semantic::Joints(set) => mesh.layer(&Semantic::Weights(set)),
        _ => None,
    };
    let sets: Vec<_> = mesh.layers.iter().filter_map(|joints| Some((joints, weights_of(joints)?))).collect();
    if sets.is_empty() {
        return Vec::new();
    }
    let strongest = |vertex: usize| {
        let mut best = (0.0, 0);
        for (joints, weights) in &sets {
            for k in 0..usize::from(joints.component_count.min(weights.component_count)) {
                let weight = weights.get(vertex, k);
                if weight > best.0 {
                    best = (weight, joints.get(vertex, k) as u32);
                }
            }
        }
        best.1
    };
    (0..mesh.vertex_count()).map(strongest).collect()
}

/// Divides each position by the layers of its triangles. A vertex that triangles of several layers use is
/// duplicated.
fn divide(welded: Welded, adjacency: &Adjacency, layer: impl Fn(u32, u32) -> u32) -> Welded {
    let Welded { mut mesh, positions, .. } = welded;
    let old = std::mem::take(&mut mesh.triangles);
    let mut triangles = old.clone();
    let (mut first, mut order) = (Vec::new(), Vec::new());
    let mut new_position = Vec::with_capacity(positions.position_count());
    let mut vertices: Vec<(u32, u32)> = Vec::new();
    for position in 0..positions.position_count() as u32 {
        let vertex_at = |corner: u32| {
            let triangle = corner / 3;
            (layer(position, triangle), old[triangle as usize][corner as usize % 3])
        };
        vertices.clear();
        vertices.extend(adjacency.corners(position).iter().map(|&corner| vertex_at(corner)));
        if vertices.is_empty() {
            vertices.extend(positions.wedges(position).map(|vertex| (0, vertex)));
        }
        vertices.sort_unstable();
        vertices.dedup();
        let start = order.len() as u32;
        for &corner in adjacency.corners(position) {
            let index = vertices.binary_search(&vertex_at(corner)).unwrap_or_default();
            triangles[corner as usize / 3][corner as usize % 3] = start + index as u32;
        }
        new_position.push(first.len() as u32);
        for run in vertices.chunk_by(|a, b| a.0 == b.0) {
            first.push(order.len() as u32);
            order.extend(run.iter().map(|&(_, vertex)| vertex));
        }
    }
    first.push(order.len() as u32);
    let added_count = order.len().saturating_sub(positions.vertex_count());
    let position_of = |p: &u32| new_position.get(*p as usize).copied().unwrap_or(u32::MAX);
    Welded {
        mesh: IndexedMesh { triangles, ..mesh.gather(&order, &[]) },
        positions: PositionIndex::from_first(first),
        source_vertex: order.iter().map(|&v| welded.source_vertex[v as usize]).collect(),
        position_of_source: welded.position_of_source.iter().map(position_of).collect(),
        degenerate_triangle_count: welded.degenerate_triangle_count,
        merged_vertex_count: welded.merged_vertex_count.saturating_sub(added_count),
    }
}
