//! Positions with thousands of triangles are reduced in a reasonable time: without limits on the work at each
//! collapse, these meshes take minutes.

use striata::mesh::{IndexedMesh, replay, shapes};
use striata::simplify::{CostFunction, SequenceOptions, Target, build_sequence};

const COUNT: u32 = 4000;

/// Triangles that share one edge.
fn fin(count: u32) -> IndexedMesh {
    let corner = |i: u32| {
        let angle = f64::from(i) / f64::from(count) * std::f64::consts::TAU;
        [angle.cos() as f32, angle.sin() as f32, 0.0]
    };
    IndexedMesh {
        positions: [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]].into_iter().chain((0..count).map(corner)).collect(),
        triangles: (0..count).map(|i| [0, 1, i + 2]).collect(),
        ..IndexedMesh::default()
    }
}

#[test]
fn hubs_are_reduced_to_a_few_triangles() {
    let meshes = [
        ("fan", shapes::triangle_fan(COUNT)),
        ("closed fan", shapes::closed_fan(COUNT)),
        ("fin", fin(COUNT / 2)),
    ];
    for (name, mesh) in meshes {
        for cost in [CostFunction::Memoryless, CostFunction::Accumulated] {
            let options = SequenceOptions::default().with_cost(cost);
            let built = build_sequence(&mesh, &options).expect("valid");
            for count in [1000, 300, 100, 20, 2] {
                let (split_count, _) = Target::Triangles(count).resolve(&built.refinable.sequence);
                let level = replay(&built.refinable, split_count);
                let found = level.triangle_count();
                assert!(found <= count && found + 3 > count, "{name}, {cost:?}: {found} of {count}");
            }
        }
    }
}

#[test]
fn copies_of_a_triangle_do_not_take_quadratic_time() {
    let mesh = IndexedMesh {
        positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        triangles: vec![[0, 1, 2]; 200_000],
        ..IndexedMesh::default()
    };
    let built = build_sequence(&mesh, &SequenceOptions::default()).expect("valid");
    assert_eq!(built.refinable.mesh.triangle_count(), 200_000);
}
