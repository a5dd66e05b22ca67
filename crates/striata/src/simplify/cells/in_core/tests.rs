use glam::Vec3;

use super::*;
use crate::ignore_progress;
use crate::mesh::{
    AttributeLayer, CollapseSequence, DisjointSets, IndexedMesh, RefinableMesh, Semantic,
    canonical_triangles, replay, shapes, weld,
};
use crate::simplify::collapse::refinement_order::build_refinable;
use crate::simplify::{CostFunction, Target, TopologyRule};

fn build(mesh: &IndexedMesh, options: &SequenceOptions, cell: usize) -> (RefinableMesh, StopReason) {
    let welded = weld(mesh).expect("the mesh is valid");
    let built = simplify_in_cells(&welded, options, cell, &mut ignore_progress);
    let (record, stop_reason) = built.expect("the options are valid");
    (build_refinable(welded, record).expect("the steps are consistent").0, stop_reason)
}

/// Closed, with a border, and of two parts.
fn meshes() -> Vec<IndexedMesh> {
    let mut two = shapes::torus(80, 40, 1.0, 0.4);
    let other = shapes::icosphere(4, 0.3);
    let offset = two.positions.len() as u32;
    two.positions.extend(&other.positions);
    two.triangles.extend(other.triangles.iter().map(|t| t.map(|v| v + offset)));
    let bare = |mesh: IndexedMesh| IndexedMesh { layers: Vec::new(), ..mesh };
    vec![shapes::icosphere(5, 1.0), bare(shapes::terrain(70, 1)), two].into_iter().map(bare).collect()
}

/// These meshes with a normal and a color at each vertex.
fn meshes_with_attributes() -> Vec<IndexedMesh> {
    let with_layers = |mut mesh: IndexedMesh| {
        let normals = vertex_normals(&mesh);
        let colors: Vec<f32> = mesh.positions.iter().flat_map(|p| p.map(|x| x.sin().abs())).collect();
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals.into_flattened()));
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, colors));
        mesh
    };
    meshes().into_iter().map(with_layers).collect()
}

fn vertex_normals(mesh: &IndexedMesh) -> Vec<[f32; 3]> {
    let mut sums = vec![Vec3::ZERO; mesh.positions.len()];
    for t in &mesh.triangles {
        let [a, b, c] = t.map(|v| Vec3::from(mesh.positions[v as usize]));
        t.iter().for_each(|&v| sums[v as usize] += (b - a).cross(c - a));
    }
    sums.into_iter().map(|sum| sum.normalize_or_zero().to_array()).collect()
}

/// Applies the steps one by one and compares every level with the plain replay, and with its count.
fn check_levels(refinable: &RefinableMesh) {
    let sequence: &CollapseSequence = &refinable.sequence;
    let mut triangles = refinable.mesh.triangles.clone();
    for split_count in (0..=sequence.step_count()).rev() {
        assert_eq!(triangles.len(), sequence.triangle_count_at(split_count));
        if split_count % 97 == 0 {
            let level = replay(refinable, split_count);
            assert_eq!(canonical_triangles(&level.triangles), canonical_triangles(&triangles));
        }
        let Some(v) = (sequence.vertex_count_at(split_count) as u32).checked_sub(1) else { break };
        if split_count > 0 {
            let target = sequence.target(v);
            assert!(target < v, "the target still exists");
            let is_star = |t: &[u32; 3]| t.contains(&v);
            let is_neighbor = triangles.iter().any(|t| is_star(t) && t.contains(&target));
            let is_strict =
                sequence.triangle_count_at(split_count) - sequence.triangle_count_at(split_count - 1) > 0;
            assert!(is_neighbor || !is_strict || split_count < 200, "a step follows an edge");
            triangles.iter_mut().flatten().filter(|w| **w == v).for_each(|w| *w = target);
            triangles.retain(|&[a, b, c]| a != b && b != c && c != a);
        }
    }
}

#[test]
fn every_level_is_the_plain_replay() {
    for mesh in meshes().into_iter().chain(meshes_with_attributes()) {
        let (refinable, stop_reason) = build(&mesh, &SequenceOptions::default(), 700);
        assert_eq!(stop_reason, StopReason::BaseReached);
        check_levels(&refinable);
        let errors = &refinable.sequence;
        assert!(errors.error_at(0) > errors.error_at(errors.step_count() / 2));
    }
}

#[cfg(feature = "parallel")]
#[test]
fn the_number_of_threads_does_not_matter() {
    for mesh in meshes().into_iter().chain(meshes_with_attributes()) {
        let on_threads = |count: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build().expect("there are threads");
            pool.install(|| build(&mesh, &SequenceOptions::default(), 300))
        };
        let expected = on_threads(1);
        for count in [2, 3] {
            assert_eq!(on_threads(count), expected, "{count} threads");
        }
    }
}

#[test]
fn limits_end_the_sequence_where_they_say() {
    for mesh in meshes() {
        let whole = build(&mesh, &SequenceOptions::default(), 700).0.sequence;
        let (level, reason) = build(&mesh, &SequenceOptions::default().with_base_triangle_count(1500), 700);
        assert_eq!(reason, StopReason::TargetReached);
        let count = level.sequence.triangle_count_at(0);
        assert!((1400..=1500).contains(&count), "{count}");
        let limit = f64::from(whole.error_at(whole.step_count() / 4));
        let (level, reason) = build(&mesh, &SequenceOptions::default().with_max_error(limit), 700);
        assert_eq!(reason, StopReason::ErrorLimit);
        assert!(f64::from(level.sequence.error_at(0)) <= limit);
        assert!(level.sequence.step_count() > whole.step_count() / 4);
        check_levels(&level);
    }
}

#[test]
fn locks_borders_and_parts_stay() {
    let [_, terrain, two] = meshes().try_into().expect("there are three");
    let locked: Vec<u32> = (0..40).map(|i| i * 61).collect();
    let options = SequenceOptions::default().with_locked_vertices(locked.clone());
    let base = replay(&build(&terrain, &options, 500).0, 0);
    assert!(locked.iter().all(|&v| base.positions.contains(&terrain.positions[v as usize])));
    let options = SequenceOptions::default().with_boundary(BoundaryRule::Locked);
    let level = build(&terrain, &options, 500).0;
    let base = replay(&level, 0);
    let is_border = |p: &&[f32; 3]| p[..2].iter().any(|&x| x == 0.0 || x == 70.0);
    assert_eq!(base.positions.iter().filter(is_border).count(), 4 * 70, "every vertex of the border is left");
    let options = SequenceOptions::default().with_topology(TopologyRule::KeepParts);
    let level = build(&two, &options, 500).0;
    let base = replay(&level, 0).without_unused_vertices();
    let mut parts = DisjointSets::new(base.positions.len());
    let joins = base.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c)]);
    let joined = joins.filter(|&(a, b)| parts.join(a, b)).count();
    assert_eq!(base.positions.len() - joined, 2, "both parts have triangles");
    let keep = build(&two, &SequenceOptions::default().with_topology(TopologyRule::Keep), 500).0;
    assert!(keep.sequence.step_count() > 3000);
    assert_eq!(Target::Triangles(usize::MAX).resolve(&keep.sequence).1, StopReason::FullMesh);
}

#[test]
fn a_callback_cancels() {
    let welded = weld(&meshes()[0]).expect("the mesh is valid");
    let cancel = &mut |_: Progress| std::ops::ControlFlow::Break(());
    let result = simplify_in_cells(&welded, &SequenceOptions::default(), 700, cancel);
    assert!(matches!(result, Err(SimplifyError::Cancelled(_))));
}

#[test]
fn only_large_meshes_of_large_parts_without_seams_are_divided() {
    let large = weld(&IndexedMesh { layers: Vec::new(), ..shapes::terrain(360, 1) }).expect("it is valid");
    assert!(large.mesh.triangle_count() >= MIN_TRIANGLES);
    let options = SequenceOptions::default();
    assert!(is_worth_dividing(&large, &options));
    for other in [
        options.clone().with_cost(CostFunction::Tracked),
        options.clone().with_pair_distance(1.0),
        options.clone().with_group_borders(BoundaryRule::Locked),
    ] {
        assert!(!is_worth_dividing(&large, &other));
    }
    let seamed = weld(&shapes::terrain(360, 1)).expect("it is valid");
    assert_eq!(is_worth_dividing(&seamed, &options), seamed.positions.is_identity());
    let small = weld(&meshes()[0]).expect("it is valid");
    assert!(!is_worth_dividing(&small, &options));
    let mut loose = large;
    loose.mesh.triangles.chunks_mut(1 << 6).enumerate().for_each(|(i, chunk)| {
        let first = (3 * i) as u32;
        chunk.iter_mut().for_each(|t| *t = [first, first + 1, first + 2]);
    });
    assert!(!is_worth_dividing(&loose, &options));
}

#[test]
fn attributes_count_in_cells_as_they_do_without() {
    // Half of the sheet is red. Where colors change, vertices stay longest.
    let mut sheet = IndexedMesh { layers: Vec::new(), ..shapes::terrain(70, 1) };
    sheet.positions.iter_mut().for_each(|p| p[2] = 0.0);
    let colors = sheet.positions.iter().flat_map(|p| if p[0] < 30.5 { [1.0, 0.0, 0.0] } else { [0.0; 3] });
    let colors = AttributeLayer::from_f32(Semantic::Color(0), 3, colors.collect());
    let near_change = |mesh: IndexedMesh| {
        let level = build(&mesh, &SequenceOptions::default().with_base_triangle_count(1200), 700).0;
        let base = replay(&level, 0);
        let mut used: Vec<u32> = base.triangles.as_flattened().to_vec();
        used.sort_unstable();
        used.dedup();
        let xs = used.iter().map(|&v| base.positions[v as usize][0]);
        xs.filter(|x| (29.0..=32.0).contains(x)).count() as f64 / used.len() as f64
    };
    let without = near_change(sheet.clone());
    sheet.layers.push(colors);
    let with = near_change(sheet);
    assert!(with > 2.0 * without, "{with} of the vertices are where colors change, {without} without colors");
}
