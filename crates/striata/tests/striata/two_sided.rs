//! A sheet that is modeled from both sides keeps its border, like the same sheet with one side.

use striata_testing::meshes;

use striata::mesh::{DistanceOptions, IndexedMesh, replay_fragments, shapes, surface_distance};
use striata::simplify::{
    BoundaryRule, CostFunction, Placement, RemovalOptions, RemovalOrder, SeamRule, SequenceOptions,
    SimplifyOptions, Target, build_fragments, simplify,
};

/// A wavy sheet whose sides are 20 long.
fn sheet() -> IndexedMesh {
    shapes::height_field(20, 20, |x, _| 1.5 * (0.4 * x as f32).sin())
}

/// The sheet from both sides, with separate vertices or common ones.
fn two_sided_sheets() -> [(&'static str, IndexedMesh); 2] {
    [("separate", meshes::two_sided(sheet())), ("common", meshes::inside_out(sheet()))]
}

/// Half of the triangles of a mesh.
fn half(mesh: &IndexedMesh) -> Target {
    Target::Triangles(mesh.triangle_count() / 2)
}

/// Checks that a level is near the full mesh.
fn check_near(name: &str, mesh: &IndexedMesh, level: &IndexedMesh, most: f64) {
    let distance = surface_distance(mesh, level, &DistanceOptions::default()).expect("valid").max;
    assert!(distance <= most, "{name}: {distance} with {} triangles", level.triangle_count());
}

#[test]
fn levels_keep_the_border() {
    let rules = |options: SequenceOptions| {
        [
            options.clone(),
            options.clone().with_boundary(BoundaryRule::Locked),
            options.with_seams(SeamRule::Keep),
        ]
    };
    for (name, mesh) in two_sided_sheets() {
        for &cost in CostFunction::ALL {
            for options in rules(SequenceOptions::default().with_cost(cost)) {
                let name = format!("{name}, {cost:?}, {:?}, {:?}", options.boundary, options.seams);
                let options = SimplifyOptions::default().with_sequence(options).with_target(half(&mesh));
                let level = simplify(&mesh, &options).expect("valid").mesh;
                check_near(&name, &mesh, &level, 0.05);
            }
        }
        for options in rules(SequenceOptions::default()) {
            let name = format!("{name}, optimal placement, {:?}, {:?}", options.boundary, options.seams);
            let options =
                SimplifyOptions::default().with_sequence(options).with_placement(Placement::Optimal);
            let level = simplify(&mesh, &options.with_target(half(&mesh))).expect("valid").mesh;
            check_near(&name, &mesh, &level, 0.05);
        }
    }
}

#[test]
fn removals_keep_the_border() {
    for (name, mesh) in two_sided_sheets() {
        for order in [RemovalOrder::Mixed, RemovalOrder::Hausdorff] {
            let options = RemovalOptions::default().with_order(order);
            let fragmented = build_fragments(&mesh, &options).expect("valid").fragmented;
            let (split_count, _) = half(&mesh).resolve_in(fragmented.fragments.levels());
            let level = replay_fragments(&fragmented, split_count);
            check_near(&format!("{name}, {order:?}"), &mesh, &level, 0.05);
        }
    }
}

/// A locked border stays as it is.
#[test]
fn locked_borders_stay() {
    for (name, mesh) in two_sided_sheets() {
        let locked = SequenceOptions::default().with_boundary(BoundaryRule::Locked);
        for placement in [Placement::Subset, Placement::Optimal] {
            let options = SimplifyOptions::default().with_sequence(locked.clone()).with_placement(placement);
            let level = simplify(&mesh, &options.with_target(Target::Triangles(250))).expect("valid").mesh;
            let is_border = |p: &&[f32; 3]| [0.0, 20.0].iter().any(|end| p[0] == *end || p[1] == *end);
            let mut kept: Vec<_> =
                level.positions.iter().filter(is_border).map(|p| p.map(f32::to_bits)).collect();
            kept.sort_unstable();
            kept.dedup();
            assert_eq!(kept.len(), 80, "{name}, {placement:?}");
        }
    }
}
