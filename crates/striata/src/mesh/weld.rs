//! Welding: merges equal vertices and makes the wedges of each position consecutive.
//!
//! Files repeat vertices (STL for every corner, glTF for every primitive). Two vertices are merged if their
//! position, every layer and the material agree bit for bit (with -0 equal to 0); they become wedges of one
//! position if only the position agrees. Vertices that no triangle uses are dropped, and so are triangles
//! with two corners at one position, which are invisible. Time O(n) expected, memory O(n).

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use super::{AttributeLayer, IndexedMesh, MeshError, PositionIndex, TriangleGroup, gather_layers};

/// Number of vertices of a position that are compared one by one.
const MAX_COMPARED: usize = 32;

/// Result of [`weld`].
#[derive(Clone, Debug)]
pub struct Welded {
    /// The welded mesh: no unused and no repeated vertices, and the wedges of each position are consecutive.
    pub mesh: IndexedMesh,
    /// The vertices (wedges) of each position.
    pub positions: PositionIndex,
    /// For each vertex, the first input vertex that was merged into it.
    pub source_vertex: Vec<u32>,
    /// For each input vertex, its position in the welded mesh; `u32::MAX` if no triangle uses it.
    pub position_of_source: Vec<u32>,
    /// Number of triangles that were dropped because two of their corners share a position.
    pub degenerate_triangle_count: usize,
    /// Number of vertices that were merged into an equal one.
    pub merged_vertex_count: usize,
}

/// Hasher that multiplies and folds: the keys are few, well-mixed words, so a keyed hash would only cost
/// time.
#[derive(Default)]
struct WordHasher(u64);

impl Hasher for WordHasher {
    fn finish(&self) -> u64 {
        self.0
    }
    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.write_u64(u64::from_le_bytes(word));
        }
    }
    fn write_u32(&mut self, word: u32) {
        self.write_u64(u64::from(word));
    }
    fn write_u64(&mut self, word: u64) {
        let mixed = (self.0 ^ word).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        self.0 = mixed ^ (mixed >> 29);
    }
}

type WordMap<K, V> = HashMap<K, V, BuildHasherDefault<WordHasher>>;

/// Merges equal vertices and makes the wedges of each position consecutive.
///
/// # Errors
/// [`MeshError`] if the mesh is inconsistent or a coordinate is not finite.
pub fn weld(mesh: &IndexedMesh) -> Result<Welded, MeshError> {
    mesh.check()?;
    let material_of = materials_of_triangles(mesh);
    let position_of = index_positions(&mesh.positions);
    let mut triangles = Vec::with_capacity(mesh.triangles.len());
    let groups = drop_degenerate(mesh, &position_of, &mut triangles);
    let degenerate_triangle_count = mesh.triangles.len() - triangles.len();
    let source = WeldSource { mesh, position_of, material_of };
    let vertices = index_vertices(&source, &mut triangles);
    let (order, first) = order_by_position(mesh, &vertices);
    let position_of_source = positions_of_sources(&source.position_of, &vertices, &order, &first);
    let mut new_index = vec![0u32; order.len()];
    for (new, &old) in order.iter().enumerate() {
        new_index[old as usize] = new as u32;
    }
    let source_vertex: Vec<u32> = order.iter().map(|&v| vertices.source[v as usize]).collect();
    let positions = PositionIndex::from_first(first);
    let welded = IndexedMesh {
        positions: source_vertex.iter().map(|&v| mesh.positions[v as usize].map(|x| x + 0.0)).collect(),
        origin: mesh.origin,
        exact_positions: mesh.gathered_exact_positions(&source_vertex),
        triangles: triangles.iter().map(|t| t.map(|v| new_index[v as usize])).collect(),
        layers: mesh.layers.iter().map(|layer| layer.gather(&source_vertex)).collect(),
        triangle_layers: proper_triangle_layers(&source, degenerate_triangle_count),
        groups,
        appearance: mesh.appearance.clone(),
    };
    Ok(Welded {
        mesh: welded,
        positions,
        source_vertex,
        position_of_source,
        degenerate_triangle_count,
        merged_vertex_count: vertices.merged_count,
    })
}

struct WeldSource<'a> {
    mesh: &'a IndexedMesh,
    position_of: Vec<u32>,
    /// Material of each triangle plus one, 0 for none; empty if all triangles share one material.
    material_of: Vec<u32>,
}

/// Material of each triangle plus one, 0 for none; empty if all triangles share one material.
fn materials_of_triangles(mesh: &IndexedMesh) -> Vec<u32> {
    let mut materials = mesh.groups.iter().map(|g| g.material);
    let first = materials.next();
    if first.is_none() || materials.all(|m| Some(m) == first) {
        return Vec::new();
    }
    let mut out = Vec::with_capacity(mesh.triangles.len());
    for group in &mesh.groups {
        out.extend(std::iter::repeat_n(group.material.map_or(0, |m| m + 1), group.count as usize));
    }
    out
}

/// Assigns an index to each distinct position, in the order in which the vertices first use them.
pub fn index_positions(positions: &[[f32; 3]]) -> Vec<u32> {
    let mut numbers: WordMap<[u32; 3], u32> = WordMap::default();
    numbers.reserve(positions.len());
    let mut next = 0;
    positions
        .iter()
        .map(|p| {
            // Adding zero turns -0 into 0, so that the two are merged.
            let key = p.map(|x| (x + 0.0).to_bits());
            *numbers.entry(key).or_insert_with(|| {
                next += 1;
                next - 1
            })
        })
        .collect()
}

/// Copies the triangles with three different positions to `kept`; returns the groups adapted to them.
fn drop_degenerate(mesh: &IndexedMesh, position_of: &[u32], kept: &mut Vec<[u32; 3]>) -> Vec<TriangleGroup> {
    let is_proper = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| position_of[v as usize]);
        a != b && b != c && c != a
    };
    if mesh.groups.is_empty() {
        kept.extend(mesh.triangles.iter().filter(|t| is_proper(t)));
        return Vec::new();
    }
    let mut groups = Vec::with_capacity(mesh.groups.len());
    for group in &mesh.groups {
        let first = kept.len() as u32;
        kept.extend(mesh.triangles[group.range()].iter().filter(|t| is_proper(t)));
        groups.push(TriangleGroup { first, count: kept.len() as u32 - first, ..group.clone() });
    }
    groups
}

/// Layers of the triangles that [`drop_degenerate`] keeps.
fn proper_triangle_layers(source: &WeldSource<'_>, degenerate_count: usize) -> Vec<AttributeLayer> {
    let mesh = source.mesh;
    if mesh.triangle_layers.is_empty() || degenerate_count == 0 {
        return mesh.triangle_layers.clone();
    }
    let is_proper = |t: &u32| {
        let [a, b, c] = mesh.triangles[*t as usize].map(|v| source.position_of[v as usize]);
        a != b && b != c && c != a
    };
    let kept: Vec<u32> = (0..mesh.triangle_count() as u32).filter(is_proper).collect();
    gather_layers(&mesh.triangle_layers, &kept)
}

#[derive(Default)]
struct WeldVertices {
    /// Input vertex of each new vertex.
    source: Vec<u32>,
    /// Position of each new vertex.
    position: Vec<u32>,
    merged_count: usize,
}

/// Assigns new indices to the distinct vertices, in the order of the input, and applies them to the
/// triangles.
///
/// The first vertices of a position form a linked list and are compared one by one, so that attributes need not be
/// hashed. If there are more than [`MAX_COMPARED`], as at the tip of a cone with flat shading, the others are found by a
/// hash.
fn index_vertices(source: &WeldSource<'_>, triangles: &mut [[u32; 3]]) -> WeldVertices {
    const NONE: u32 = u32::MAX;
    let has_materials = !source.material_of.is_empty();
    // New vertex of each pair (input vertex, material). Without materials, every input vertex is looked up
    // once.
    let mut pair_of_vertex: WordMap<(u32, u32), u32> = WordMap::default();
    let mut used = vec![false; source.mesh.positions.len()];
    for &v in triangles.iter().flatten() {
        used[v as usize] = true;
    }
    let position_count = source.position_of.iter().max().map_or(0, |&p| p as usize + 1);
    let mut head = vec![NONE; position_count];
    let mut crowded: WordMap<u64, u32> = WordMap::default();
    let mut next: Vec<u32> = Vec::new();
    let mut material: Vec<u32> = Vec::new();
    let mut out = WeldVertices::default();
    let mut new_vertex = |v: u32, m: u32, out: &mut WeldVertices| -> u32 {
        let position = source.position_of[v as usize];
        let is_equal = |slot: u32, out: &WeldVertices, material: &[u32]| {
            material[slot as usize] == m
                && same_attributes(source.mesh, v as usize, out.source[slot as usize] as usize)
                && out.position[slot as usize] == position
        };
        let (mut slot, mut last, mut count) = (head[position as usize], NONE, 0);
        let mut key = None;
        loop {
            if slot == NONE && count == MAX_COMPARED {
                let hash = attribute_hash(source.mesh, v as usize, [position, m]);
                key = Some(hash);
                (slot, count) = (crowded.get(&hash).copied().unwrap_or(NONE), count + 1);
            }
            if slot == NONE {
                break;
            }
            if is_equal(slot, out, &material) {
                out.merged_count += 1;
                return slot;
            }
            (last, slot) = (slot, next[slot as usize]);
            count += usize::from(count < MAX_COMPARED);
        }
        let new = out.source.len() as u32;
        if let Some(hash) = key {
            next.push(crowded.insert(hash, new).unwrap_or(NONE));
        } else {
            match last {
                NONE => head[position as usize] = new,
                _ => next[last as usize] = new,
            }
            next.push(NONE);
        }
        material.push(m);
        out.source.push(v);
        out.position.push(position);
        new
    };
    if !has_materials {
        let renamed: Vec<u32> = (0..used.len() as u32)
            .map(|v| if used[v as usize] { new_vertex(v, 0, &mut out) } else { NONE })
            .collect();
        for corner in triangles.iter_mut().flatten() {
            *corner = renamed[*corner as usize];
        }
        return out;
    }
    // `triangles` no longer contains degenerate triangles: walk the input to keep the materials in step.
    let mut kept = triangles.iter_mut();
    for (t, corners) in source.mesh.triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|v| source.position_of[v as usize]);
        if a == b || b == c || c == a {
            continue;
        }
        let Some(triangle) = kept.next() else { break };
        let m = source.material_of[t];
        *triangle =
            corners.map(|v| *pair_of_vertex.entry((v, m)).or_insert_with(|| new_vertex(v, m, &mut out)));
    }
    out
}

/// Hash of the attributes of a vertex, and of two numbers.
fn attribute_hash(mesh: &IndexedMesh, vertex: usize, numbers: [u32; 2]) -> u64 {
    let mut hasher = WordHasher::default();
    numbers.iter().for_each(|&number| hasher.write_u32(number));
    for layer in &mesh.layers {
        let n = layer.vertex_bytes();
        hasher.write(&layer.data.as_bytes()[vertex * n..][..n]);
    }
    hasher.finish()
}

fn same_attributes(mesh: &IndexedMesh, a: usize, b: usize) -> bool {
    mesh.layers.iter().all(|layer| {
        let n = layer.vertex_bytes();
        let bytes = layer.data.as_bytes();
        bytes[a * n..][..n] == bytes[b * n..][..n]
    })
}

/// Orders vertices along a space-filling curve, keeping the wedges of a position together; returns the
/// order and the first vertex of each position. Simplification accesses the mesh in random order, so what
/// is close in space should be close in memory.
fn order_by_position(mesh: &IndexedMesh, vertices: &WeldVertices) -> (Vec<u32>, Vec<u32>) {
    let mut keys: Vec<(u64, u32, u32)> = Vec::with_capacity(vertices.source.len());
    if let Some(curve) = ZOrderCurve::of(mesh) {
        keys.extend(vertices.source.iter().zip(&vertices.position).enumerate().map(
            |(v, (&source, &position))| (curve.code(mesh.positions[source as usize]), position, v as u32),
        ));
    }
    keys.sort_unstable();
    let mut first = Vec::new();
    let mut last = None;
    for (i, &(_, position, _)) in keys.iter().enumerate() {
        if last != Some(position) {
            first.push(i as u32);
            last = Some(position);
        }
    }
    first.push(keys.len() as u32);
    (keys.into_iter().map(|(_, _, v)| v).collect(), first)
}

/// Position index in the welded mesh for every input vertex.
fn positions_of_sources(
    position_of: &[u32],
    vertices: &WeldVertices,
    order: &[u32],
    first: &[u32],
) -> Vec<u32> {
    let mut new_position = vec![u32::MAX; position_of.iter().max().map_or(0, |&p| p as usize + 1)];
    for (new, &v) in first[..first.len() - 1].iter().enumerate() {
        new_position[vertices.position[order[v as usize] as usize] as usize] = new as u32;
    }
    position_of.iter().map(|&p| new_position[p as usize]).collect()
}

/// The Z-order (Morton) curve over the bounds of a mesh.
pub(crate) struct ZOrderCurve {
    min: [f64; 3],
    scale: f64,
}

impl ZOrderCurve {
    const BITS: u32 = 21;

    /// Fits the curve to the bounds of a mesh; `None` if it has no vertices.
    pub(crate) fn of(mesh: &IndexedMesh) -> Option<Self> {
        let bounds = mesh.bounds()?;
        let min = bounds.min.map(f64::from);
        let extent = (0..3).map(|a| f64::from(bounds.max[a]) - min[a]).fold(0.0, f64::max);
        let cells = f64::from((1u32 << Self::BITS) - 1);
        Some(Self { min, scale: if extent > 0.0 { cells / extent } else { 0.0 } })
    }

    /// Returns the place of a point along the curve.
    pub(crate) fn code(&self, p: [f32; 3]) -> u64 {
        let cell = |a: usize| spread_bits(((f64::from(p[a]) - self.min[a]) * self.scale) as u64);
        cell(0) | cell(1) << 1 | cell(2) << 2
    }
}

/// Inserts two zero bits between the lower 21 bits of `x`.
fn spread_bits(x: u64) -> u64 {
    let mut x = x & 0x1F_FFFF;
    x = (x | x << 32) & 0x001F_0000_0000_FFFF;
    x = (x | x << 16) & 0x001F_0000_FF00_00FF;
    x = (x | x << 8) & 0x100F_00F0_0F00_F00F;
    x = (x | x << 4) & 0x10C3_0C30_C30C_30C3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Semantic;

    #[test]
    fn a_tip_of_many_vertices_keeps_those_that_differ() {
        // A fan with a normal of its own for each triangle, all of it twice.
        let count = 40_000u32;
        let mut mesh = IndexedMesh::default();
        let mut normals = Vec::new();
        for i in (0..count).chain(0..count) {
            let corner = mesh.positions.len() as u32;
            mesh.positions.extend([[0.0; 3], [1.0, i as f32, 0.0], [1.0, i as f32 + 1.0, 0.0]]);
            mesh.triangles.push([corner, corner + 1, corner + 2]);
            normals.extend([[0.0, i as f32, 1.0]; 3]);
        }
        mesh.layers = vec![AttributeLayer::from_f32(Semantic::Normal, 3, normals.into_flattened())];
        let welded = weld(&mesh).unwrap();
        assert_eq!(welded.mesh.vertex_count(), 3 * count as usize);
        assert_eq!(welded.merged_vertex_count, 3 * count as usize);
        assert_eq!(welded.positions.position_count(), count as usize + 2);
        let tip = welded.position_of_source[0];
        assert_eq!(welded.positions.wedges(tip).len(), count as usize);
        let (first, second) = welded.mesh.triangles.split_at(count as usize);
        assert_eq!(first, second);
    }

    #[test]
    fn soup_of_two_triangles_becomes_four_vertices() {
        let p = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        let mesh = IndexedMesh::new(vec![p[0], p[1], p[2], p[0], p[2], p[3]], vec![[0, 1, 2], [3, 4, 5]]);
        let welded = weld(&mesh).unwrap();
        assert_eq!(welded.mesh.vertex_count(), 4);
        // Along the curve: (0,0), (1,0), (0,1), (1,1).
        assert_eq!(welded.mesh.triangles, vec![[0, 1, 3], [0, 3, 2]]);
        assert_eq!(welded.merged_vertex_count, 2);
        assert!(welded.positions.is_identity());
    }

    #[test]
    fn wedges_stay_separate_but_consecutive() {
        let p = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [-0., 0., 0.]];
        let mut mesh = IndexedMesh::new(p.to_vec(), vec![[0, 1, 2], [3, 2, 1]]);
        mesh.layers.push(AttributeLayer::from_f32(
            Semantic::TexCoord(0),
            2,
            vec![0., 0., 1., 0., 1., 1., 0., 1.],
        ));
        let welded = weld(&mesh).unwrap();
        assert_eq!(welded.positions.wedges(0), 0..2);
        assert_eq!(welded.mesh.triangles, vec![[0, 2, 3], [1, 3, 2]]);
        assert_eq!(welded.source_vertex, vec![0, 3, 1, 2]);
        assert_eq!(welded.position_of_source, vec![0, 1, 2, 0]);
    }

    #[test]
    fn materials_split_shared_vertices() {
        let p = vec![[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        let mut mesh = IndexedMesh::new(p, vec![[0, 1, 2], [0, 0, 1], [0, 2, 3]]);
        mesh.appearance.materials = vec![Default::default(); 2];
        let group = |material, first, count| TriangleGroup {
            name: String::new(),
            material: Some(material),
            first,
            count,
        };
        mesh.groups = vec![group(0, 0, 2), group(1, 2, 1)];
        let welded = weld(&mesh).unwrap();
        assert_eq!(welded.degenerate_triangle_count, 1);
        assert_eq!(welded.mesh.vertex_count(), 6);
        assert_eq!(welded.positions.position_count(), 4);
        assert_eq!(welded.mesh.groups, vec![group(0, 0, 1), group(1, 1, 1)]);
        welded.mesh.check().unwrap();
    }

    #[test]
    fn nan_coordinates_are_rejected() {
        let mesh = IndexedMesh::new(vec![[0., f32::NAN, 0.]], vec![]);
        assert!(matches!(weld(&mesh), Err(MeshError::NonFinitePosition { vertex: 0, axis: 1, .. })));
    }
}
