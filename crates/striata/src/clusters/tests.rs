use std::collections::HashMap;

use super::*;
use crate::mesh::{canonical_triangles, shapes, weld};
use crate::simplify::BoundaryRule;

fn build(mesh: &IndexedMesh) -> ClusterDag {
    ClusterDag::build(mesh, &small()).expect("the mesh and the options are valid")
}

/// Clusters of a few triangles: several levels of small meshes.
fn small() -> ClusterOptions {
    ClusterOptions::default().with_max_triangles(24).with_max_vertices(40).with_group_size(6)
}

fn meshes() -> Vec<IndexedMesh> {
    let bare = |mesh: IndexedMesh| IndexedMesh { layers: Vec::new(), ..mesh };
    vec![
        shapes::torus(60, 30, 1.0, 0.4),
        bare(shapes::terrain(40, 3)),
        shapes::two_material_sphere(24, 30),
        shapes::uv_sphere(20, 30, 1.0),
        shapes::icosphere(4, 1e-7),
    ]
}

/// Numbers of uses of each edge between positions, in either direction.
fn edges(mesh: &IndexedMesh, triangles: &[[u32; 3]]) -> HashMap<[u32; 2], usize> {
    let position_of = crate::mesh::index_positions(&mesh.positions);
    let mut edges = HashMap::new();
    for t in triangles {
        let t = t.map(|v| position_of[v as usize]);
        for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    edges
}

#[test]
fn full_detail_is_the_mesh() {
    for mesh in meshes() {
        let dag = build(&mesh);
        let welded = weld(&mesh).expect("the mesh is valid");
        let of = |v: u32| welded.source_vertex[v as usize];
        let expected: Vec<[u32; 3]> = welded.mesh.triangles.iter().map(|t| t.map(of)).collect();
        let full = dag.cut(|_| false);
        assert_eq!(canonical_triangles(&dag.triangles_of(&full)), canonical_triangles(&expected));
        assert!(full.iter().all(|&c| dag.clusters[c].refines.is_none()));
    }
}

#[test]
fn clusters_are_small_and_of_one_group_and_spheres_contain_them() {
    for mesh in meshes() {
        let dag = build(&mesh);
        let groups = mesh.groups_or_whole();
        for cluster in &dag.clusters {
            let triangles = &dag.triangles[cluster.triangles.clone()];
            let mut vertices = triangles.as_flattened().to_vec();
            vertices.sort_unstable();
            vertices.dedup();
            assert!((1..=24).contains(&triangles.len()) && vertices.len() <= 40);
            assert!(vertices.iter().all(|&v| cluster.sphere.contains(mesh.positions[v as usize])));
            assert!(cluster.mesh_group < groups.len());
        }
        for (number, group) in dag.groups.iter().enumerate() {
            assert!(dag.clusters[group.clusters.clone()].iter().all(|c| c.group == number));
        }
    }
}

#[test]
fn errors_and_spheres_nest() {
    for mesh in meshes() {
        let dag = build(&mesh);
        for cluster in &dag.clusters {
            let Some(finer) = cluster.refines else { continue };
            assert!(finer < cluster.group, "finer groups come first");
            let (finer, group) = (&dag.groups[finer], &dag.groups[cluster.group]);
            assert!(finer.error <= group.error && finer.depth < group.depth);
            assert!(group.sphere.with_sphere(&finer.sphere).radius <= group.sphere.radius * 1.0001);
        }
    }
}

/// Cuts of a mesh: uniform ones, and those around points on its surface.
fn cuts(mesh: &IndexedMesh, dag: &ClusterDag) -> Vec<Vec<usize>> {
    let mut errors: Vec<f32> = dag.groups.iter().map(|g| g.error).filter(|e| e.is_finite()).collect();
    errors.sort_by(f32::total_cmp);
    let mut cuts: Vec<_> = errors.iter().step_by(7).map(|&error| dag.cut_for_error(error)).collect();
    let size = mesh.bounds().map_or(1.0, |b| b.diagonal()) as f32;
    for &p in mesh.positions.iter().step_by(97) {
        for slope in [0.002, 0.01, 0.05] {
            cuts.push(dag.cut(|group| {
                let d = (0..3).map(|a| (group.sphere.center[a] - p[a]).powi(2)).sum::<f32>().sqrt();
                group.error <= slope * (d - group.sphere.radius).max(0.001 * size)
            }));
        }
    }
    cuts
}

#[test]
fn no_cut_of_a_closed_mesh_has_an_open_edge() {
    for mesh in
        [shapes::torus(60, 30, 1.0, 0.4), shapes::two_material_sphere(24, 30), shapes::icosphere(4, 1.0)]
    {
        let dag = build(&mesh);
        let is_closed = |triangles: &[[u32; 3]]| edges(&mesh, triangles).values().all(|&n| n % 2 == 0);
        assert!(is_closed(&mesh.triangles), "the test needs a closed mesh");
        let mut counts = Vec::new();
        for cut in cuts(&mesh, &dag) {
            let triangles = dag.triangles_of(&cut);
            assert!(is_closed(&triangles));
            counts.push(triangles.len());
        }
        counts.sort_unstable();
        assert!(counts[0] * 4 < counts[counts.len() - 1], "the cuts differ: {counts:?}");
    }
}

#[test]
fn levels_halve_down_to_one_cluster_of_each_material() {
    for mesh in meshes() {
        let dag = build(&mesh);
        let coarsest = dag.cut(|_| true);
        assert!((1..=mesh.groups_or_whole().len()).contains(&coarsest.len()));
        let last = dag.groups.last().expect("there is a group");
        assert!(last.error.is_infinite() && dag.groups.iter().filter(|g| g.error.is_infinite()).count() == 1);
        let total = dag.triangles.len();
        assert!(total < 9 * mesh.triangle_count() / 4, "{total} of {}", mesh.triangle_count());
    }
}

#[test]
fn errors_of_uniform_cuts_are_those_that_can_be_measured() {
    use crate::mesh::{DistanceOptions, surface_distance};
    let mesh = shapes::icosphere(5, 1.0);
    let dag = ClusterDag::build(&mesh, &ClusterOptions::default()).expect("the mesh is valid");
    for error in [0.0012, 0.005, 0.025] {
        let cut = dag.cut_for_error(error);
        let level =
            IndexedMesh::new(mesh.positions.clone(), dag.triangles_of(&cut)).without_unused_vertices();
        assert!(level.triangle_count() <= mesh.triangle_count() / 2);
        let measured =
            surface_distance(&mesh, &level, &DistanceOptions::default()).expect("both have triangles");
        let is_coarse = |group: &&ClusterGroup| group.error <= error;
        let reported = dag.groups.iter().filter(is_coarse).fold(0.0, |error, group| group.error.max(error));
        let ratio = f64::from(reported) / measured.max;
        assert!((0.9..1.3).contains(&ratio), "{reported} reported, {} measured", measured.max);
    }
}

#[test]
fn results_do_not_depend_on_threads() {
    let mesh = shapes::torus(60, 30, 1.0, 0.4);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("there are threads");
        pool.install(|| build(&mesh))
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn locked_vertices_and_borders_stay() {
    let mesh = IndexedMesh { layers: Vec::new(), ..shapes::terrain(30, 2) };
    let sequence =
        SequenceOptions::default().with_boundary(BoundaryRule::Locked).with_locked_vertices(vec![200, 431]);
    let dag = ClusterDag::build(&mesh, &small().with_sequence(sequence)).expect("the options are valid");
    let open = |triangles: &[[u32; 3]]| {
        let mut open: Vec<_> =
            edges(&mesh, triangles).into_iter().filter(|e| e.1 == 1).map(|e| e.0).collect();
        open.sort_unstable();
        open
    };
    let coarsest = dag.triangles_of(&dag.cut(|_| true));
    assert!(coarsest.len() * 3 < mesh.triangle_count());
    assert_eq!(open(&coarsest), open(&mesh.triangles));
    assert!([200, 431].iter().all(|v| coarsest.as_flattened().contains(v)));
}

#[test]
fn clusters_at_full_detail_keep_their_material() {
    let mesh = shapes::two_material_sphere(24, 30);
    let dag = build(&mesh);
    for (number, group) in mesh.groups_or_whole().iter().enumerate() {
        let is_of_group = |c: &&usize| dag.clusters[**c].mesh_group == number;
        let clusters: Vec<usize> = dag.cut(|_| false).iter().filter(is_of_group).copied().collect();
        let places = |triangles: &[[u32; 3]]| {
            let mut places: Vec<[[u32; 3]; 3]> =
                triangles.iter().map(|t| t.map(|v| mesh.positions[v as usize].map(f32::to_bits))).collect();
            places.iter_mut().for_each(|t| t.sort_unstable());
            places.sort_unstable();
            places
        };
        assert_eq!(places(&dag.triangles_of(&clusters)), places(&mesh.triangles[group.range()]));
    }
}

#[test]
fn unusual_meshes() {
    let triangle = IndexedMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]]);
    assert_eq!(build(&IndexedMesh::default()), ClusterDag::default());
    assert_eq!(build(&triangle).clusters.len(), 1);
    let mut degenerate = triangle.clone();
    degenerate.triangles = vec![[0, 0, 1], [0, 1, 2]];
    assert_eq!(build(&degenerate).triangles.len(), 1);
    // Many parts of a few triangles each.
    let mut soup = IndexedMesh::default();
    for i in 0..500 {
        let at = i as f32;
        soup.positions.extend([[at, 0.0, 0.0], [at + 0.5, 0.0, 0.0], [at, 0.5, 1e6 * (i % 2) as f32]]);
        soup.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    let dag = build(&soup);
    assert_eq!(dag.triangles_of(&dag.cut(|_| false)).len(), 500);
    // Everything at one edge.
    let mut fan = IndexedMesh::new(vec![[0.0; 3], [0.0, 0.0, 1.0]], Vec::new());
    for i in 0..300u32 {
        fan.positions.push([(i as f32).sin(), (i as f32).cos(), 0.0]);
        fan.triangles.push([0, 1, i + 2]);
    }
    assert!(build(&fan).cut(|_| true).len() < 14);
    let mut invalid = triangle;
    invalid.positions[0][0] = f32::NAN;
    assert!(ClusterDag::build(&invalid, &small()).is_err());
}

#[test]
fn error_limits_hold() {
    let mesh = shapes::torus(60, 30, 1.0, 0.4);
    for limit in [0.01f32, 0.05] {
        let sequence = SequenceOptions::default().with_max_error(f64::from(limit));
        let dag = ClusterDag::build(&mesh, &small().with_sequence(sequence)).expect("the options are valid");
        let finite = dag.groups.iter().map(|group| group.error).filter(|error| error.is_finite());
        let largest = finite.fold(0.0, f32::max);
        assert!(largest > 0.3 * limit && largest <= limit, "{largest} within {limit}");
    }
}

#[test]
fn small_parts_do_not_vanish_in_groups_of_their_own() {
    // Far from each other, each in a group without neighbors.
    let mut mesh = IndexedMesh::default();
    for i in 0..40u32 {
        let part = shapes::icosphere(2, 0.01);
        let offset = mesh.positions.len() as u32;
        mesh.positions.extend(part.positions.iter().map(|p| [p[0] + i as f32, p[1], p[2]]));
        mesh.triangles.extend(part.triangles.iter().map(|t| t.map(|v| v + offset)));
    }
    let dag = build(&mesh);
    for group in dag.groups.iter().filter(|group| group.error.is_finite()) {
        let cut = dag.cut_for_error(group.error);
        let level = IndexedMesh::new(mesh.positions.clone(), dag.triangles_of(&cut));
        let tree = crate::mesh::TriangleTree::new(&level).expect("the cut is valid");
        let distance = |p: &[f32; 3]| tree.distance_to(p.map(f64::from));
        let farthest = mesh.positions.iter().map(distance).fold(0.0, f64::max);
        assert!(farthest <= 1.1 * f64::from(group.error), "{farthest} for {}", group.error);
    }
}

#[test]
fn options_out_of_range_are_named() {
    let mesh = shapes::icosphere(1, 1.0);
    let options = ClusterOptions::default();
    for (options, name) in [
        (options.clone().with_max_triangles(1), "max_triangles"),
        (options.clone().with_max_vertices(5), "max_vertices"),
        (options.with_group_size(1), "group_size"),
    ] {
        let error = ClusterDag::build(&mesh, &options).expect_err("the option is out of range");
        assert!(error.to_string().contains(name), "{error}");
    }
}
