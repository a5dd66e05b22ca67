//! Meshes and files for the tests, and what every mesh made of pages must fulfill.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use striata::ignore_progress;
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic, TriangleGroup, replay, shapes};
use striata_paged::build::{BuildInput, BuildOptions, BuildPaths, PagedPlan, run_all};
use striata_paged::{Assembled, PagedFile};
use tempfile::TempDir;

pub(crate) fn options() -> BuildOptions {
    BuildOptions { cell: 2000, pieces_per_task: 2, cells_per_task: 3, ..BuildOptions::default() }
}

pub(crate) fn plan(folder: &TempDir, input: BuildInput, options: BuildOptions, name: &str) -> PagedPlan {
    let (output, work) = (folder.path().join(name), folder.path().join(format!("{name}.work")));
    PagedPlan::make(input, options, BuildPaths { output: &output, folder: &work }, 2, &mut ignore_progress)
        .unwrap()
}

pub(crate) fn build(folder: &TempDir, input: BuildInput, options: BuildOptions, threads: usize) -> PathBuf {
    let plan = plan(folder, input, options, &format!("threads-{threads}.striata"));
    run_all(&plan, threads, &mut ignore_progress).unwrap();
    plan.remove_work().unwrap();
    assert!(!plan.folder.exists());
    plan.output
}

pub(crate) fn open(path: &Path) -> PagedFile {
    PagedFile::open(path.to_str().unwrap()).unwrap()
}

pub(crate) fn full(file: &mut PagedFile) -> Assembled {
    let pages = file.select(|_| true).unwrap();
    assert_eq!(pages.len() as u32, file.reader().page_count());
    file.assemble(&pages).unwrap()
}

pub(crate) type Soup = BTreeMap<[[u32; 3]; 3], i32>;

/// Multiset of triangles by the bits of their positions.
pub(crate) fn soup(mesh: &IndexedMesh, round: impl Fn([f32; 3]) -> [f32; 3]) -> Soup {
    let mut soup = Soup::new();
    for t in &mesh.triangles {
        let at = t.map(|v| round(mesh.positions[v as usize]).map(|x| (x + 0.0).to_bits()));
        if at[0] == at[1] || at[1] == at[2] || at[2] == at[0] {
            continue;
        }
        let first = (0..3).min_by_key(|&i| at[i]).unwrap();
        *soup.entry([0, 1, 2].map(|i| at[(first + i) % 3])).or_default() += 1;
    }
    soup
}

/// Every level has the triangles that the sequence announces, and errors that never rise.
pub(crate) fn check_levels(assembled: &Assembled) {
    let refinable = &assembled.refinable;
    refinable.mesh.check().unwrap();
    let sequence = &refinable.sequence;
    let steps = sequence.step_count();
    assert!(assembled.keys.is_sorted_by(|a, b| a >= b));
    for split_count in [0, steps / 10, steps / 3, steps / 2, steps.saturating_sub(1), steps] {
        let level = replay(refinable, split_count);
        assert_eq!(
            level.triangle_count(),
            sequence.triangle_count_at(split_count),
            "{split_count} of {steps}"
        );
    }
}

/// A mesh with split normals, a seam of texture coordinates and two materials.
pub(crate) fn attributed() -> IndexedMesh {
    let mut mesh = shapes::torus(60, 60, 1.0, 0.4);
    let texcoords = (0..mesh.positions.len()).flat_map(|v| [(v % 60) as f32 / 60.0, (v / 60) as f32 / 60.0]);
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords.collect()));
    let order: Vec<u32> = mesh.triangles.as_flattened().to_vec();
    let count = mesh.triangles.len() as u32;
    let normals = (0..count).flat_map(|t| [[0.0, (t / 2 % 5) as f32 * 0.2, 1.0]; 3].concat()).collect();
    let mut soup = IndexedMesh {
        positions: order.iter().map(|&v| mesh.positions[v as usize]).collect(),
        layers: mesh.layers.iter().map(|layer| layer.gather(&order)).collect(),
        triangles: (0..count).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect(),
        ..IndexedMesh::default()
    };
    soup.layers.insert(0, AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    soup.appearance.materials = vec![striata::mesh::Material::default(); 2];
    let half = count / 2;
    soup.groups = [(0, half), (half, count - half)]
        .into_iter()
        .zip(0..)
        .map(|((first, count), m)| TriangleGroup {
            material: Some(m),
            first,
            count,
            name: format!("part {m}"),
        })
        .collect();
    soup
}

/// Number of edges with one triangle.
pub(crate) fn borders(mesh: &IndexedMesh) -> usize {
    let mut edges: BTreeMap<[[u32; 3]; 2], i32> = BTreeMap::new();
    for t in &mesh.triangles {
        let at = t.map(|v| mesh.positions[v as usize].map(f32::to_bits));
        for i in 0..3 {
            let (a, b) = (at[i], at[(i + 1) % 3]);
            *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    edges.values().filter(|&&count| count == 1).count()
}
