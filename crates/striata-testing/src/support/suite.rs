//! Meshes on which every model is checked against the oracle: meshes that violate assumptions, surfaces,
//! seams and groups, a vertex with hundreds of triangles, and random soups.

use proptest::prelude::*;
use striata::mesh::{IndexedMesh, RefinableMesh};

use super::{Random, RandomSequenceOptions, grid, nasty, random_refinable, soup, with_seams_and_groups};

/// A mesh with a random sequence.
pub struct Case {
    /// Number of steps between two levels that are checked.
    pub stride: usize,
    /// Seed of the sequence, also used for other choices that should differ between cases.
    pub seed: u64,
    pub refinable: RefinableMesh,
}

impl Case {
    pub fn new(
        mesh: &IndexedMesh,
        sequence_options: RandomSequenceOptions,
        seed: u64,
        stride: usize,
    ) -> Self {
        Self { stride, seed, refinable: random_refinable(mesh, sequence_options, &mut Random::new(seed)) }
    }
}

/// Meshes that violate assumptions, collapsed to one position, with targets nearby or anywhere.
pub fn nasty_cases() -> impl Iterator<Item = Case> {
    let with_seeds = |(name, mesh): (&'static str, IndexedMesh)| {
        (0..8).map(move |seed| {
            eprintln!("{name}, seed {seed}");
            let sequence_options =
                RandomSequenceOptions { far_percent: (seed as usize % 3) * 30, base_position_count: 1 };
            Case::new(&mesh, sequence_options, seed, 1)
        })
    };
    nasty().into_iter().flat_map(with_seeds)
}

/// Surfaces with and without boundary; not every level of the largest one is checked.
pub fn surface_cases() -> impl Iterator<Item = Case> {
    let surfaces = [(grid(12, false), 1), (grid(14, true), 1), (grid(60, true), 97)];
    surfaces.into_iter().flat_map(|(mesh, stride)| {
        (0..4).map(move |seed| {
            let sequence_options =
                RandomSequenceOptions { far_percent: seed as usize * 4, base_position_count: 4 };
            Case::new(&mesh, sequence_options, seed, stride)
        })
    })
}

/// Surfaces with seams and three groups, one of them empty.
pub fn seam_cases() -> impl Iterator<Item = Case> {
    (0..4).map(|seed| {
        let mesh = with_seams_and_groups(grid(9, seed % 2 == 0));
        Case::new(&mesh, RandomSequenceOptions { far_percent: 5, base_position_count: 3 }, seed, 1)
    })
}

/// Fans whose hub, which has hundreds of triangles, is removed early.
pub fn hub_cases() -> impl Iterator<Item = Case> {
    let n = 900;
    let positions = (0..=n).map(|i| [i as f32, (i * i % 17) as f32, 0.0]).collect();
    let triangles = (0..n as u32).step_by(3).map(|i| [n as u32, i, i + 1]).collect();
    let mesh = IndexedMesh::new(positions, triangles);
    (0..20).map(move |seed| {
        let sequence_options = RandomSequenceOptions { far_percent: 50, base_position_count: 500 };
        Case::new(&mesh, sequence_options, seed, 7)
    })
}

/// Random triangle soups, with or without seams and groups, collapsed to one position.
pub fn soups() -> impl Strategy<Value = Case> {
    let shape = (any::<u64>(), 3usize..30, 0usize..60, 0usize..60, any::<bool>());
    shape.prop_map(|(seed, vertex_count, triangle_count, far_percent, has_seams)| {
        let mut random = Random::new(seed);
        let mut mesh = soup(vertex_count, triangle_count, &mut random);
        if has_seams {
            mesh = with_seams_and_groups(mesh);
        }
        let sequence_options = RandomSequenceOptions { far_percent, base_position_count: 1 };
        Case { stride: 1, seed, refinable: random_refinable(&mesh, sequence_options, &mut random) }
    })
}

impl std::fmt::Debug for Case {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mesh = &self.refinable.mesh;
        write!(f, "seed {}: {:?} of {} vertices", self.seed, mesh.triangles, mesh.vertex_count())
    }
}
