//! Test meshes for the whole pipeline.
#![allow(dead_code, unreachable_pub, reason = "each test file uses only a part")]

mod nasty;

use std::panic::{AssertUnwindSafe, catch_unwind};

use striata::mesh::{
    AttributeLayer, IndexedMesh, LayerData, Material, Random, Semantic, TriangleGroup, shapes,
};
use striata::simplify::{BoundaryRule, CostFunction, SeamRule, SequenceOptions, TopologyRule};

pub use nasty::nasty;

pub type NamedMesh = (String, IndexedMesh);

fn named(name: &str, mesh: IndexedMesh) -> NamedMesh {
    (name.to_owned(), mesh)
}

/// Closed oriented manifolds; the last ones have seams.
pub fn closed() -> Vec<NamedMesh> {
    vec![
        named("tetrahedron", shapes::tetrahedron()),
        named("cube", shapes::cube()),
        named("icosphere", shapes::icosphere(2, 1.0)),
        named("uv sphere", shapes::uv_sphere(9, 14, 3.0)),
        named("sphere with sharp poles", shapes::uv_sphere(3, 70, 1.0)),
        named("torus", shapes::torus(14, 9, 2.0, 1.0)),
        named("rough torus", rough(shapes::torus(20, 12, 2.0, 1.0), 0.15, 3)),
        named("two bodies", joined(shapes::torus(8, 7, 2.0, 0.5), shapes::icosphere(1, 0.5))),
        named("two materials", shapes::two_material_sphere(6, 9)),
        named("hard cube", shapes::hard_cube()),
        named("torus in patches", with_patches(shapes::torus(12, 10, 2.0, 1.0), 17)),
    ]
}

/// Oriented manifolds with boundaries.
pub fn open() -> Vec<NamedMesh> {
    vec![
        named(
            "one triangle",
            IndexedMesh::new(vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]], vec![[0, 1, 2]]),
        ),
        named("flat grid", shapes::grid(9, 7)),
        named("terrain", shapes::terrain(17, 5)),
        named("cylinder", shapes::uv_cylinder(16, 7)),
        named("open fan", shapes::triangle_fan(40)),
        named("closed fan", shapes::closed_fan(30)),
        named("perforated torus", without_every(shapes::torus(16, 11, 2.0, 1.0), 37)),
        named("terrain in patches", with_patches(shapes::terrain(14, 2), 9)),
    ]
}

/// All other valid meshes: problematic ones, soups, one-sided surfaces, books.
pub fn odd() -> Vec<NamedMesh> {
    let nasty = nasty().into_iter().filter(|(_, mesh)| mesh.check().is_ok());
    let mut all: Vec<NamedMesh> = nasty.map(|(name, mesh)| named(name, mesh)).collect();
    all.push(named("long moebius strip", shapes::moebius_strip(40)));
    all.push(named("klein bottle", shapes::klein_bottle(12, 9)));
    all.push(named("book of 30", shapes::book(30)));
    all.push(named("torus twice", copies(&shapes::torus(10, 8, 2.0, 1.0), 2)));
    all.push(named("torus inside out", inside_out(shapes::torus(10, 8, 2.0, 1.0))));
    all.push(named("two-sided sheet", two_sided(shapes::terrain(8, 3))));
    all.push(named("balls on joints", on_joints(&shapes::icosphere(1, 1.0), 3)));
    all.push(named("decal", decal(shapes::terrain(9, 3))));
    for seed in 0..12 {
        all.push((format!("soup {seed}"), shapes::random_soup(20 + 15 * seed as u32, seed)));
        all.push((format!("sheets {seed}"), crossing_sheets(seed)));
    }
    all
}

/// Runs a check on each mesh with each cost, and fails with a list of all failures.
pub fn check_each(meshes: Vec<NamedMesh>, check: impl Fn(&str, &IndexedMesh, &SequenceOptions)) {
    check_each_variant(meshes, &by_cost(), check);
}

/// Returns options with each cost.
pub fn by_cost() -> Vec<(String, SequenceOptions)> {
    CostFunction::ALL
        .iter()
        .map(|&cost| (format!("{cost:?}"), SequenceOptions::default().with_cost(cost)))
        .collect()
}

/// Runs a check on each mesh with each of several named options, and fails with a list of all failures.
pub fn check_each_variant<O>(
    meshes: Vec<NamedMesh>,
    variants: &[(impl std::fmt::Display, O)],
    check: impl Fn(&str, &IndexedMesh, &O),
) {
    let mut failed = Vec::new();
    for (name, mesh) in meshes {
        for (variant, options) in variants {
            let name = format!("{name}, {variant}");
            if catch_unwind(AssertUnwindSafe(|| check(&name, &mesh, options))).is_err() {
                failed.push(name);
            }
        }
    }
    assert!(failed.is_empty(), "failed: {failed:#?}");
}

pub fn all() -> Vec<NamedMesh> {
    [closed(), open(), odd()].concat()
}

/// Displaces every vertex randomly by at most `by` along each axis.
pub fn rough(mut mesh: IndexedMesh, by: f32, seed: u64) -> IndexedMesh {
    let mut random = Random::new(seed);
    mesh.positions.iter_mut().flatten().for_each(|x| *x += random.between(-by, by));
    mesh
}

fn joined(mut a: IndexedMesh, b: IndexedMesh) -> IndexedMesh {
    let first = a.vertex_count() as u32;
    a.positions.extend(b.positions);
    a.triangles.extend(b.triangles.iter().map(|t| t.map(|v| v + first)));
    a
}

fn without_every(mut mesh: IndexedMesh, n: usize) -> IndexedMesh {
    mesh.triangles =
        mesh.triangles.into_iter().enumerate().filter(|(i, _)| i % n != 5).map(|(_, t)| t).collect();
    mesh.without_unused_vertices()
}

/// Two grids that share vertices: edges with three and four triangles among ordinary ones.
fn crossing_sheets(seed: u64) -> IndexedMesh {
    let mut mesh = rough(shapes::grid(6, 6), 0.02, seed);
    let mut random = Random::new(seed);
    let sheets = mesh.triangles.clone();
    let n = mesh.vertex_count() as u32;
    mesh.positions.extend(mesh.positions.clone().iter().map(|&[x, y, z]| [x, y, z + 1.0]));
    let lifted: Vec<u32> = (0..n).map(|v| if random.below(3) == 0 { v } else { v + n }).collect();
    mesh.triangles.extend(sheets.iter().map(|t| t.map(|v| lifted[v as usize])));
    mesh
}

/// Gives every `run` consecutive triangles separate texture coordinates, and each of three parts a material.
pub fn with_patches(mesh: IndexedMesh, run: usize) -> IndexedMesh {
    let corners: Vec<u32> = mesh.triangles.iter().flatten().copied().collect();
    let texcoords = corners.iter().enumerate().flat_map(|(c, &v)| [(c / (3 * run)) as f32, v as f32]);
    let n = mesh.triangle_count() as u32;
    let cuts = [0, n / 3, n / 2, n];
    let group = |g: usize| TriangleGroup {
        name: format!("part {g}"),
        material: (g != 1).then_some(g as u32 / 2),
        first: cuts[g],
        count: cuts[g + 1] - cuts[g],
    };
    let mut out = IndexedMesh {
        positions: corners.iter().map(|&v| mesh.positions[v as usize]).collect(),
        triangles: (0..n).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect(),
        layers: vec![AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords.collect())],
        groups: (0..3).map(group).collect(),
        ..IndexedMesh::default()
    };
    out.appearance.materials =
        ["red", "blue"].map(|name| Material { name: name.into(), ..Material::default() }).to_vec();
    out
}

/// A strip folded onto itself, with degenerate triangles between its runs.
pub fn folded(count: u32) -> IndexedMesh {
    let position = |i: u32| [f32::from(i as u8 % 2), (i / 2) as f32 * 0.25, 0.01 * (i % 3) as f32];
    let positions = (0..2 * count + 2).map(position).chain([[0.5, 0.0, 0.0], [1.0, 0.0, 0.01]]).collect();
    let n = 2 * count + 2;
    let runs = (0..2 * count).flat_map(|i| [[i, i + 1, i + 2], [i + 2, i + 1, i]]);
    IndexedMesh::new(positions, runs.chain([[0, n, 1], [0, n + 1, n]]).collect())
}

/// Several copies of a mesh in the same place, each with its own vertices.
pub fn copies(mesh: &IndexedMesh, count: u32) -> IndexedMesh {
    let n = mesh.vertex_count() as u32;
    let triangles = (0..count).flat_map(|k| mesh.triangles.iter().map(move |t| t.map(|v| v + k * n)));
    IndexedMesh::new(mesh.positions.repeat(count as usize), triangles.collect())
}

/// Several copies of a mesh in the same place, each bound to its own joint.
pub fn on_joints(mesh: &IndexedMesh, count: u32) -> IndexedMesh {
    let mut out = copies(mesh, count);
    let n = mesh.vertex_count();
    let joints = (0..out.vertex_count()).flat_map(|v| [(v / n) as u16, 0, 0, 0]).collect();
    let weights = [1.0, 0.0, 0.0, 0.0].repeat(out.vertex_count());
    out.layers = skin(joints, weights);
    out
}

/// Layers of joints and weights, four per vertex.
pub fn skin(joints: Vec<u16>, weights: Vec<f32>) -> Vec<AttributeLayer> {
    let joints = AttributeLayer {
        semantic: Semantic::Joints(0),
        component_count: 4,
        normalized: false,
        data: LayerData::U16(joints),
    };
    vec![joints, AttributeLayer::from_f32(Semantic::Weights(0), 4, weights)]
}

/// A sheet that is modeled from both sides: every triangle again, reversed, with its own vertices and normals.
pub fn two_sided(sheet: IndexedMesh) -> IndexedMesh {
    let n = sheet.vertex_count();
    let mut out = inside_out(sheet);
    let normals = [[0.0, 0.0, 1.0].repeat(n), [0.0, 0.0, -1.0].repeat(n)].concat();
    out.layers = vec![AttributeLayer::from_f32(Semantic::Normal, 3, normals)];
    out
}

/// A mesh, a third of whose triangles are there again with their own texture coordinates.
pub fn decal(mesh: IndexedMesh) -> IndexedMesh {
    let n = mesh.vertex_count();
    let mut patch = mesh.clone();
    patch.triangles.truncate(mesh.triangle_count() / 3);
    let mut out = joined(mesh, patch);
    let texcoords = (0..2 * n).flat_map(|v| if v < n { [0.0; 2] } else { [v as f32, 1.0] }).collect();
    out.layers = vec![AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords)];
    out
}

/// A mesh together with a copy of opposite orientation.
pub fn inside_out(mesh: IndexedMesh) -> IndexedMesh {
    let mut turned = mesh.clone();
    turned.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    joined(mesh, turned)
}

/// Random options for a mesh: locks, rules and contractions.
pub fn random_options(mesh: &IndexedMesh, seed: u64, cost: usize) -> SequenceOptions {
    let mut random = Random::new(seed ^ 0x5EED);
    let mut one_in = |n: u32| random.below(n) == 0;
    let mut options = SequenceOptions::default().with_cost(CostFunction::ALL[cost]);
    if one_in(3) {
        options = options.with_locked_vertices((0..mesh.vertex_count() as u32).step_by(29).collect());
    }
    if one_in(4) {
        options = options.with_boundary(BoundaryRule::Locked);
    }
    if one_in(4) {
        options = options.with_group_borders(BoundaryRule::Locked);
    }
    if one_in(4) {
        options = options.with_seams(SeamRule::Keep);
    }
    if one_in(4) {
        options = options.with_topology(TopologyRule::KeepParts);
    }
    for share in [0.01, 0.1, 1.0] {
        if one_in(6) {
            options = options.with_pair_distance(share * mesh.diagonal());
        }
    }
    options
}

/// A random piece of an asset: small bodies, sheets, cards and typical modeling leftovers.
fn piece(random: &mut Random) -> IndexedMesh {
    let seed = u64::from(random.below(1000));
    match random.below(16) {
        0 => shapes::cube(),
        1 => shapes::icosphere(1, 0.7),
        2 => shapes::terrain(5, seed),
        3 => shapes::grid(1, 1),
        4 => shapes::book(3 + random.below(5)),
        5 => joined(shapes::grid(1, 1), shapes::grid(1, 1)),
        6 => shapes::random_soup(4 + random.below(12), seed),
        7 => shapes::many_components(5),
        8 => shapes::moebius_strip(7),
        9 => joined(shapes::icosphere(0, 0.5), shapes::icosphere(0, 0.5)),
        10 => shapes::bow_tie(),
        11 => shapes::needle(),
        12 => shapes::closed_fan(4 + random.below(8)),
        13 => folded(5),
        14 => inside_out(shapes::icosphere(0, 0.5)),
        _ => shapes::torus(5, 4, 1.0, 0.4),
    }
}

/// Random pieces next to, inside and on top of each other, as in files from modeling tools: flat or smooth
/// normals, charts of texture coordinates, three materials, duplicate triangles.
pub fn asset(piece_count: usize, seed: u64) -> IndexedMesh {
    let mut random = Random::new(seed);
    let mut out = IndexedMesh::default();
    let (mut normals, mut texcoords) = (Vec::new(), Vec::new());
    for index in 0..piece_count {
        let mut piece = piece(&mut random);
        if random.below(3) == 0 {
            let first = piece.triangles.first().copied();
            piece.triangles.extend(first);
        }
        let scale = [0.1, 0.5, 1.0][random.below(3) as usize];
        let offset: [f32; 3] = std::array::from_fn(|_| random.below(4) as f32);
        let (is_flat, run) = (random.below(2) == 0, 1 + random.below(12) as usize);
        let first = out.triangles.len() as u32;
        for (t, corners) in piece.triangles.iter().enumerate() {
            let points = corners.map(|v| glam::Vec3::from(piece.positions[v as usize]));
            let normal = (points[1] - points[0]).cross(points[2] - points[0]).normalize_or_zero();
            let n = out.positions.len() as u32;
            out.triangles.push([n, n + 1, n + 2]);
            for (point, &v) in points.into_iter().zip(corners) {
                let smooth = point.normalize_or_zero();
                normals.extend(if is_flat { normal } else { smooth }.to_array());
                texcoords.extend([(t / run) as f32 * 0.1, v as f32 * 0.01]);
                out.positions.push((scale * point + glam::Vec3::from(offset)).to_array());
            }
        }
        out.groups.push(TriangleGroup {
            name: format!("piece {index}"),
            material: Some(index as u32 % 3),
            first,
            count: out.triangles.len() as u32 - first,
        });
    }
    out.layers = vec![
        AttributeLayer::from_f32(Semantic::Normal, 3, normals),
        AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords),
    ];
    out.appearance.materials =
        ["red", "green", "blue"].map(|name| Material { name: name.into(), ..Material::default() }).to_vec();
    out
}
