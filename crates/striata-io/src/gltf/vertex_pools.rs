//! Vertices that several meshes have, such as the parts of a building over one vertex buffer.
//!
//! Meshes that have vertices in common form a set. If sharing makes the set much smaller, all of its meshes get
//! one vertex buffer. Where most vertices belong to one mesh, as in tiles that touch, every mesh keeps a buffer of
//! its own, so that it can be loaded alone. A mesh whose primitives show the same triangles in several materials is a set
//! of its own.
//!
//! Many meshes of a few vertices, such as the parts of a building after simplification, share buffers too, because the
//! accessors of one take more bytes than its vertices.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};

use crate::contacts::Sets;

/// Largest share of the bytes that may remain of a set that is worth it.
const WORTH: f64 = 0.75;

/// Number of vertices from which on a sample decides which meshes are compared.
const SAMPLED: usize = 1 << 20;

/// One of this many vertices is sampled.
const SAMPLE: u64 = 64;

/// Bytes of JSON that the accessors of a mesh take, besides those of each layer.
const JSON_BYTES: usize = 190;

/// Bytes of JSON that the accessor of a layer takes.
const LAYER_JSON_BYTES: usize = 75;

/// Number of meshes of a few vertices from which on they share buffers.
const MANY: usize = 64;

/// Vertices of a buffer whose indices take two bytes.
const SHORT: usize = u16::MAX as usize;

/// Vertex of a mesh.
#[derive(Clone, Copy)]
struct PooledVertex {
    mesh: usize,
    vertex: usize,
}

/// Vertices of several meshes, each of them once.
pub(super) struct Pool {
    /// The vertices, without triangles.
    pub vertices: IndexedMesh,
    /// Numbers of the meshes, and for each the place of its vertices in the pool.
    pub members: Vec<(usize, Vec<u32>)>,
}

/// Finds the sets of meshes that are worth a pool. Each mesh counts, so equal ones should be left out.
pub(super) fn pools(meshes: &[(usize, &IndexedMesh)]) -> Vec<Pool> {
    let total: usize = meshes.iter().map(|(_, mesh)| mesh.vertex_count()).sum();
    let every = if total < SAMPLED { 1 } else { SAMPLE };
    if let [(_, mesh)] = meshes
        && mesh.groups.len() < 2
    {
        return Vec::new();
    }
    let all: Vec<usize> = (0..meshes.len()).collect();
    let sets = sets_worth(meshes, &all, every);
    let exact = |set: Vec<usize>| if every == 1 { vec![set] } else { sets_worth(meshes, &set, 1) };
    sets.into_iter().flat_map(exact).map(|set| pool(meshes, &set)).collect()
}

/// Returns the sets of meshes that have vertices in common and are worth it, judged by one of `every` vertices.
fn sets_worth(meshes: &[(usize, &IndexedMesh)], candidates: &[usize], every: u64) -> Vec<Vec<usize>> {
    let mut sets = Sets::new(meshes.len());
    let mut first_at: HashMap<u64, PooledVertex> = HashMap::new();
    let mut counts: Vec<[usize; 2]> = vec![[0; 2]; meshes.len()];
    for &mesh in candidates {
        for vertex in 0..meshes[mesh].1.vertex_count() {
            let own = PooledVertex { mesh, vertex };
            let hash = hash_of(meshes, own);
            if !hash.is_multiple_of(every) {
                continue;
            }
            counts[mesh][0] += 1;
            match first_at.get(&hash) {
                Some(&first) if are_equal(meshes, first, own) => sets.join(first.mesh, mesh),
                Some(_) => counts[mesh][1] += 1,
                None => {
                    first_at.insert(hash, own);
                    counts[mesh][1] += 1;
                }
            }
        }
    }
    join_small(meshes, candidates, &mut sets);
    let mut members: HashMap<usize, Vec<usize>> = HashMap::new();
    for &mesh in candidates {
        members.entry(sets.find(mesh)).or_default().push(mesh);
    }
    let is_worth = |set: &Vec<usize>| {
        let sum = |k: usize| set.iter().map(|&mesh| counts[mesh][k]).sum::<usize>();
        let (with_copies, once) = (sum(0), sum(1));
        let corners: usize = set.iter().map(|&mesh| 3 * meshes[mesh].1.triangle_count()).sum();
        let vertex_bytes = vertex_bytes(meshes[set[0]].1);
        // Indices of a large pool take four bytes instead of two.
        let wider = if once * every as usize > u16::MAX as usize { 2 * corners } else { 0 };
        let bytes = |count: usize, buffers: usize| {
            (count * every as usize * vertex_bytes + buffers * json_bytes(meshes[set[0]].1)) as f64
        };
        let is_shared = set.len() > 1 || meshes[set[0]].1.groups.len() > 1;
        is_shared && bytes(once, 1) + wider as f64 <= WORTH * bytes(with_copies, set.len())
    };
    let mut found: Vec<Vec<usize>> = members.into_values().filter(is_worth).collect();
    found.sort_unstable();
    found
}

/// Joins meshes with few vertices, as many as short indices can number, if there are many with the same layers.
fn join_small(meshes: &[(usize, &IndexedMesh)], candidates: &[usize], sets: &mut Sets) {
    let is_small = |mesh: &IndexedMesh| mesh.vertex_count() * vertex_bytes(mesh) < json_bytes(mesh);
    let mut alike: HashMap<Vec<LayerKey<'_>>, Vec<usize>> = HashMap::new();
    for &mesh in candidates.iter().filter(|&&mesh| is_small(meshes[mesh].1)) {
        alike.entry(meshes[mesh].1.layers.iter().map(layer_key).collect()).or_default().push(mesh);
    }
    for small in alike.into_values().filter(|small| small.len() >= MANY) {
        let mut count = 0;
        for pair in small.windows(2) {
            count += meshes[pair[0]].1.vertex_count();
            if count + meshes[pair[1]].1.vertex_count() > SHORT {
                count = 0;
            } else {
                sets.join(pair[0], pair[1]);
            }
        }
    }
}

/// Name and type of a layer.
type LayerKey<'a> = (&'a Semantic, u8, bool, usize);

fn layer_key(layer: &AttributeLayer) -> LayerKey<'_> {
    (&layer.semantic, layer.component_count, layer.normalized, layer.data.type_code())
}

/// Bytes of JSON that a vertex buffer of a mesh takes.
fn json_bytes(mesh: &IndexedMesh) -> usize {
    JSON_BYTES + LAYER_JSON_BYTES * mesh.layers.len()
}

fn pool(meshes: &[(usize, &IndexedMesh)], set: &[usize]) -> Pool {
    let mut first_at: HashMap<u64, (PooledVertex, u32)> = HashMap::new();
    let layers = meshes[set[0]].1.layers.iter().map(empty_like).collect();
    let mut vertices = IndexedMesh { layers, ..IndexedMesh::default() };
    let mut members = Vec::new();
    for &mesh in set {
        let source = meshes[mesh].1;
        let mut added = Vec::new();
        let mut next = vertices.vertex_count() as u32;
        let numbers = (0..source.vertex_count()).map(|vertex| {
            let own = PooledVertex { mesh, vertex };
            let hash = hash_of(meshes, own);
            match first_at.get(&hash) {
                Some(&(first, number)) if are_equal(meshes, first, own) => return number,
                Some(_) => {}
                None => {
                    first_at.insert(hash, (own, next));
                }
            }
            added.push(vertex as u32);
            next += 1;
            next - 1
        });
        let numbers: Vec<u32> = numbers.collect();
        vertices.positions.extend(added.iter().map(|&v| source.positions[v as usize]));
        for (to, from) in vertices.layers.iter_mut().zip(&source.layers) {
            let own = from.gather(&added);
            to.data.extend_from_range(&own.data, 0..own.data.len());
        }
        members.push((meshes[mesh].0, numbers));
    }
    Pool { vertices, members }
}

fn empty_like(layer: &AttributeLayer) -> AttributeLayer {
    AttributeLayer { data: layer.data.empty_like(), ..layer.clone() }
}

fn vertex_bytes(mesh: &IndexedMesh) -> usize {
    12 + mesh.layers.iter().map(AttributeLayer::vertex_bytes).sum::<usize>()
}

/// Bytes of a vertex in a layer.
fn bytes_of(layer: &AttributeLayer, vertex: usize) -> &[u8] {
    let size = layer.vertex_bytes();
    layer.data.as_bytes().get(vertex * size..(vertex + 1) * size).unwrap_or(&[])
}

fn hash_of(meshes: &[(usize, &IndexedMesh)], place: PooledVertex) -> u64 {
    let (mesh, vertex) = (meshes[place.mesh].1, place.vertex);
    let mut hasher = DefaultHasher::new();
    hasher.write(bytemuck::bytes_of(&mesh.positions[vertex]));
    for layer in &mesh.layers {
        layer.semantic.hash(&mut hasher);
        hasher.write(bytes_of(layer, vertex));
    }
    hasher.finish()
}

/// Whether two vertices have the same layers with the same bits.
fn are_equal(meshes: &[(usize, &IndexedMesh)], a: PooledVertex, b: PooledVertex) -> bool {
    let (first, second) = (meshes[a.mesh].1, meshes[b.mesh].1);
    let bits = |mesh: &IndexedMesh, vertex: usize| mesh.positions[vertex].map(f32::to_bits);
    bits(first, a.vertex) == bits(second, b.vertex)
        && first.layers.len() == second.layers.len()
        && first
            .layers
            .iter()
            .zip(&second.layers)
            .all(|(x, y)| layer_key(x) == layer_key(y) && bytes_of(x, a.vertex) == bytes_of(y, b.vertex))
}
