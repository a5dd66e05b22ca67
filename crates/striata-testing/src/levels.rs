//! Checks for every source of levels: its levels equal the plain replay of its steps.

use std::fmt::Debug;

use striata::Target;
use striata::levels::{FoundLevel, Levels};
use striata::mesh::IndexedMesh;
use striata::simplify::StopReason;
use striata::view::{Camera, ScreenError};

/// A triangle as the bits of its corners' coordinates, which do not depend on the numbers of vertices.
type PlacedTriangle = [[u32; 3]; 3];

/// Returns the triangles of a mesh in an order that depends on their corners alone.
pub fn placed_triangles(mesh: &IndexedMesh) -> Vec<PlacedTriangle> {
    let bits = |&v: &u32| mesh.positions[v as usize].map(f32::to_bits);
    let mut all: Vec<PlacedTriangle> =
        mesh.triangles.iter().map(|t| [&t[0], &t[1], &t[2]].map(bits)).collect();
    for triangle in &mut all {
        let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or(0);
        triangle.rotate_left(least);
    }
    all.sort_unstable();
    all
}

/// Checks levels of uniform detail: each has the triangles that `oracle` returns for its number of steps, respects its
/// target, and is the finest one that does.
///
/// # Panics
/// If one does not.
pub fn check_levels<L>(source: &mut L, oracle: &dyn Fn(usize) -> IndexedMesh)
where
    L: Levels<Shape = IndexedMesh>,
    L::Error: Debug,
{
    let facts = source.facts();
    let full = source.find(Target::Detail(1.0)).expect("the full mesh");
    assert_eq!((full.triangle_count, full.error), (facts.triangle_count, Some(0.0)));
    let step_count = full.split_count;
    let base = source.find(Target::SplitCount(0)).expect("the base mesh");
    let base_error = base.error.expect("the error of a mesh");
    let mut targets = vec![Target::SplitCount(1.min(step_count)), Target::Error(0.0), Target::Detail(0.3)];
    for share in [0.03, 0.2, 0.55, 0.9, 1.0] {
        targets.push(Target::Triangles((share * facts.triangle_count as f64) as usize));
        targets.push(Target::Vertices((share * facts.vertex_count as f64) as usize));
        targets.push(Target::Error(share * f64::from(base_error as f32)));
    }
    source.prepare(&targets).expect("all levels at once");
    for target in targets {
        let level = source.find(target).expect("a level");
        assert_eq!(level.triangle_count, level.shape.triangle_count(), "{target:?}");
        assert_eq!(level.vertex_count, level.shape.vertex_count(), "{target:?}");
        assert_eq!(
            placed_triangles(&level.shape),
            placed_triangles(&oracle(level.split_count)),
            "{target:?}: level {} of {step_count}",
            level.split_count
        );
        assert!(meets(&level, target) || level.stop_reason == StopReason::BaseReached, "{target:?}");
        let next = (level.split_count < step_count)
            .then(|| source.find(Target::SplitCount(level.split_count + 1)).expect("the next level"));
        if let (Target::Triangles(count), Some(next)) = (target, next) {
            assert!(next.triangle_count > count, "{target:?}: there is a finer level");
        }
    }
    check_ends(source, &base, &full);
}

/// Whether a level does not exceed its target.
fn meets(level: &FoundLevel<IndexedMesh>, target: Target) -> bool {
    match target {
        Target::Triangles(count) => level.triangle_count <= count,
        Target::Vertices(count) => level.vertex_count <= count,
        Target::Error(error) => level.error.is_some_and(|found| found <= error),
        Target::SplitCount(count) => level.split_count == count,
        _ => true,
    }
}

/// Checks targets beyond the base and beyond the full mesh.
fn check_ends<L>(source: &mut L, base: &FoundLevel<IndexedMesh>, full: &FoundLevel<IndexedMesh>)
where
    L: Levels<Shape = IndexedMesh>,
    L::Error: Debug,
{
    let coarsest = source.find(Target::Detail(-1.0)).expect("the base mesh");
    assert_eq!((coarsest.split_count, coarsest.stop_reason), (0, StopReason::BaseReached));
    assert_eq!(placed_triangles(&coarsest.shape), placed_triangles(&base.shape));
    let finest = source.find(Target::Triangles(usize::MAX)).expect("the full mesh");
    assert_eq!((finest.split_count, finest.stop_reason), (full.split_count, StopReason::FullMesh));
    assert_eq!(placed_triangles(&finest.shape), placed_triangles(&full.shape));
}

/// Checks levels for a camera that looks at the mesh from outside: tighter tolerances give more triangles, and a limit is
/// respected.
///
/// # Panics
/// If one does not.
pub fn check_views<L>(source: &mut L)
where
    L: Levels<Shape = IndexedMesh>,
    L::Error: Debug,
{
    let bounds = source.bounds().expect("bounds").expect("a mesh with vertices");
    let center = [0, 1, 2].map(|axis| f32::midpoint(bounds.min[axis], bounds.max[axis]));
    let eye = [center[0], center[1] + 0.3, center[2] + 1.2 * bounds.diagonal() as f32];
    let camera = Camera::new(eye, center, [0.0, 1.0, 0.0], 0.5, [800, 600]).expect("a camera");
    let counts = [0.05, 2.0, 30.0].map(|pixels| {
        let level = source.find_for_view(&ScreenError::new(camera, pixels), None).expect("a view");
        assert_eq!((level.relaxation, level.triangle_count), (1.0, level.shape.triangle_count()));
        level.triangle_count
    });
    assert!(counts.is_sorted_by(|fine, coarse| fine >= coarse) && counts[0] > counts[2], "{counts:?}");
    let limit = usize::midpoint(counts[0], counts[2]);
    let within = source.find_for_view(&ScreenError::new(camera, 0.05), Some(limit)).expect("a view");
    assert!(
        within.triangle_count <= limit && within.relaxation >= 1.0,
        "{} of {limit}",
        within.triangle_count
    );
    assert!(within.triangle_count > counts[2], "{} of {limit}", within.triangle_count);
}
