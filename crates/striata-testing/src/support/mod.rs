//! Test meshes, random collapse sequences, and the oracles that every model is checked against.
#![allow(dead_code, unreachable_pub, unused_imports, reason = "each test file uses only a part")]

mod arbitrary_criterion;
mod checksums;
mod closed_surface;
mod fragment_oracle;
mod oracle;
mod removals;
mod suite;
mod topology;

pub use arbitrary_criterion::ArbitraryCriterion;
pub use checksums::with_valid_checksums;
pub use closed_surface::ClosedSurface;
pub use fragment_oracle::{
    assert_shows_set, closed_sets, follows_the_fragments, fragment_cases, random_closed_set, smallest_set,
};
pub use oracle::{follows_the_oracle, follows_the_oracle_at, selective_triangles};
pub use removals::random_removals;
use striata::mesh::{
    AttributeLayer, CollapseSequence, IndexedMesh, Material, PositionIndex, RefinableMesh, Semantic,
    SequenceParts, TriangleGroup, weld,
};
pub use suite::{Case, hub_cases, nasty_cases, seam_cases, soups, surface_cases};
pub use topology::Topology;

/// A small random number generator (xorshift) with the same output on every machine.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Returns a number below `limit`, which must be positive.
    pub fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 16) % limit as u64) as usize
    }
}

/// A grid of `n` by `n` squares, bent so that no two vertices coincide; optionally closed to a torus.
pub fn grid(n: usize, is_torus: bool) -> IndexedMesh {
    let side = if is_torus { n } else { n + 1 };
    let at = |x: usize, y: usize| ((y % side) * side + x % side) as u32;
    let positions = (0..side * side)
        .map(|v| {
            let (x, y) = ((v % side) as f32, (v / side) as f32);
            [x, y, (x * 3.0 + y * y) % 7.0]
        })
        .collect();
    let mut triangles = Vec::new();
    for y in 0..n {
        for x in 0..n {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    IndexedMesh::new(positions, triangles)
}

/// Random triangles over a few vertices: duplicates, edges with many triangles, bow-ties.
pub fn soup(vertex_count: usize, triangle_count: usize, random: &mut Random) -> IndexedMesh {
    let positions = (0..vertex_count).map(|v| [v as f32, (v * v % 11) as f32, 0.5]).collect();
    let triangles =
        (0..triangle_count).map(|_| [(); 3].map(|()| random.below(vertex_count) as u32)).collect();
    IndexedMesh::new(positions, triangles)
}

/// Meshes that violate common assumptions.
pub fn nasty() -> Vec<(&'static str, IndexedMesh)> {
    let line = |n: usize| (0..n).map(|i| [i as f32, 0.0, 0.0]).collect::<Vec<_>>();
    let mesh = |n: usize, triangles: &[[u32; 3]]| IndexedMesh::new(line(n), triangles.to_vec());
    let moebius: Vec<[u32; 3]> = (0..7u32).flat_map(|i| [[i, (i + 1) % 7, (i + 2) % 7]]).collect();
    vec![
        ("empty", IndexedMesh::default()),
        ("one triangle", mesh(3, &[[0, 1, 2]])),
        ("duplicates", mesh(4, &[[0, 1, 2], [0, 1, 2], [1, 2, 0], [2, 1, 0], [1, 3, 2]])),
        ("three on an edge", mesh(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]])),
        ("bow-tie", mesh(5, &[[0, 1, 2], [0, 3, 4]])),
        ("moebius", mesh(7, &moebius)),
        ("tetrahedron", mesh(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])),
        ("components", {
            let triangles: Vec<_> = (0..40u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
            mesh(120, &triangles)
        }),
        ("fan", mesh(60, &(1..59u32).map(|i| [0, i, i + 1]).collect::<Vec<_>>())),
    ]
}

/// Adds UVs that split every third vertex, and three groups with materials.
pub fn with_seams_and_groups(mut mesh: IndexedMesh) -> IndexedMesh {
    let corners: Vec<u32> = mesh.triangles.iter().flatten().copied().collect();
    let uvs = corners
        .iter()
        .enumerate()
        .flat_map(|(corner, &v)| [if v % 3 == 0 { (corner % 4) as f32 } else { 0.5 }, v as f32])
        .collect();
    mesh.positions = corners.iter().map(|&v| mesh.positions[v as usize]).collect();
    mesh.triangles = (0..corners.len() as u32 / 3).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    mesh.layers = vec![AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs)];
    let n = mesh.triangles.len() as u32;
    let cuts = [0, n / 3, n / 3, n];
    mesh.groups = (0..3)
        .map(|g| TriangleGroup {
            name: format!("part {g}"),
            material: (g != 1).then_some(g / 2),
            first: cuts[g as usize],
            count: cuts[g as usize + 1] - cuts[g as usize],
        })
        .collect();
    mesh.appearance.materials = ["red", "blue"]
        .map(|name| Material { name: name.into(), gltf_json: format!("{{\"name\":\"{name}\"}}") })
        .to_vec();
    mesh
}

/// Parameters of a random collapse sequence.
#[derive(Clone, Copy, Debug)]
pub struct RandomSequenceOptions {
    /// Percentage of collapses that go to an arbitrary position instead of a neighbor.
    pub far_percent: usize,
    /// Minimum number of positions in the base mesh.
    pub base_position_count: usize,
}

/// Welds a mesh and collapses its positions in random order to random targets, and wedges to random wedges.
pub fn random_refinable(
    mesh: &IndexedMesh,
    sequence_options: RandomSequenceOptions,
    random: &mut Random,
) -> RefinableMesh {
    let welded = weld(mesh).expect("test meshes are valid");
    let positions = &welded.positions;
    let position_count = positions.position_count();
    let mut present: Vec<u32> = (0..position_count as u32).collect();
    let mut target_of = vec![u32::MAX; positions.vertex_count()];
    let mut triangles = welded.mesh.triangles.clone();
    let mut triangles_of: Vec<Vec<u32>> = vec![Vec::new(); positions.vertex_count()];
    for (t, corners) in triangles.iter().enumerate() {
        corners.iter().for_each(|&v| triangles_of[v as usize].push(t as u32));
    }
    let is_shown = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    let (mut removed, mut removed_counts) = (Vec::new(), Vec::new());
    while present.len() > sequence_options.base_position_count.max(1) {
        let p = present.swap_remove(random.below(present.len()));
        let mut neighbors: Vec<u32> = positions
            .wedges(p)
            .flat_map(|v| &triangles_of[v as usize])
            .map(|&t| triangles[t as usize])
            .filter(is_shown)
            .flat_map(|t| t.map(|v| positions.position_of(v)))
            .filter(|&q| q != p)
            .collect();
        neighbors.sort_unstable();
        let is_far = neighbors.is_empty() || random.below(100) < sequence_options.far_percent;
        let pool = if is_far { &present } else { &neighbors };
        let wedges = positions.wedges(pool[random.below(pool.len())]);
        let mut removed_count = 0u8;
        for v in positions.wedges(p) {
            let target = wedges.start + random.below(wedges.len()) as u32;
            target_of[v as usize] = target;
            for t in std::mem::take(&mut triangles_of[v as usize]) {
                let corners = &mut triangles[t as usize];
                let was_shown = is_shown(corners);
                corners.iter_mut().filter(|c| **c == v).for_each(|c| *c = target);
                removed_count += u8::from(was_shown && !is_shown(corners));
                triangles_of[target as usize].push(t);
            }
        }
        removed.push(p);
        removed_counts.push(removed_count);
    }
    present.sort_unstable();
    let base_position_count = present.len();
    let position_order: Vec<u32> = present.into_iter().chain(removed.into_iter().rev()).collect();
    removed_counts.reverse();
    let order: Vec<u32> = position_order.iter().flat_map(|&p| positions.wedges(p)).collect();
    let mut first = vec![0];
    first.extend(position_order.iter().scan(0, |sum, &p| {
        *sum += positions.wedges(p).len() as u32;
        Some(*sum)
    }));
    let base_vertex_count = first[base_position_count] as usize;
    let mut new_index = vec![0; order.len()];
    order.iter().enumerate().for_each(|(new, &old)| new_index[old as usize] = new as u32);
    let step_count = removed_counts.len();
    let sequence = CollapseSequence::from_parts(SequenceParts {
        positions: PositionIndex::from_first(first),
        base_position_count,
        targets: order[base_vertex_count..]
            .iter()
            .map(|&v| new_index[target_of[v as usize] as usize])
            .collect(),
        errors: (0..step_count).map(|s| (step_count - s) as f32 * 0.25).collect(),
        removed_triangle_counts: removed_counts,
        triangle_count: welded.mesh.triangle_count(),
    })
    .expect("a random sequence is valid");
    let source = welded.mesh;
    let mesh = IndexedMesh {
        positions: order.iter().map(|&v| source.positions[v as usize]).collect(),
        origin: source.origin,
        exact_positions: order
            .iter()
            .filter_map(|&v| source.exact_positions.get(v as usize).copied())
            .collect(),
        triangles: source.triangles.iter().map(|t| t.map(|v| new_index[v as usize])).collect(),
        layers: source.layers.iter().map(|layer| layer.gather(&order)).collect(),
        triangle_layers: source.triangle_layers,
        groups: source.groups,
        appearance: source.appearance,
    };
    RefinableMesh { mesh, sequence }
}
