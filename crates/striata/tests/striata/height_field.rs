//! Levels of a terrain stay height fields: no triangle turns over in plan.

use striata::mesh::{IndexedMesh, Random, replay, replay_fragments, shapes};
use striata::simplify::{
    BatchOptions, PlacedCollapse, PlacedOptions, Placement, RemovalOptions, Retriangulation, SequenceOptions,
    SimplifyOptions, Target, build_batches, build_fragments, build_placed_fragments, build_sequence,
    simplify,
};

const SHARES: [f64; 6] = [0.7, 0.4, 0.2, 0.1, 0.03, 0.0];

/// A grid with noise and cliffs that are several times as high as its samples are apart.
fn cliffs() -> IndexedMesh {
    let mut random = Random::new(5);
    shapes::height_field(60, 60, |x, y| {
        let cliff = if (x / 9 + y / 7) % 2 == 0 { 12.0 } else { 0.0 };
        cliff + 3.0 * (random.unit() as f32) + 0.2 * x as f32
    })
}

/// Number of triangles that do not face up.
fn turned_count(mesh: &IndexedMesh) -> usize {
    let area = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.positions[v as usize].map(f64::from));
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    mesh.triangles.iter().filter(|t| area(t) <= 0.0).count()
}

fn sum_at_levels(step_count: usize, level: impl Fn(usize) -> IndexedMesh) -> usize {
    SHARES.map(|share| turned_count(&level((share * step_count as f64) as usize))).iter().sum()
}

/// Triangles that are turned over in the levels of every kind of simplification.
fn counts(mesh: &IndexedMesh, is_height_field: bool) -> Vec<usize> {
    let sequence = SequenceOptions::default().with_height_field(is_height_field);
    let built = build_sequence(mesh, &sequence).unwrap().refinable;
    let mut counts = vec![sum_at_levels(built.sequence.step_count(), |at| replay(&built, at))];
    let batches = BatchOptions::default().with_sequence(sequence.clone());
    let built = build_batches(mesh, &batches).unwrap().built.refinable;
    counts.push(sum_at_levels(built.sequence.step_count(), |at| replay(&built, at)));
    for retriangulation in [Retriangulation::Free, Retriangulation::Collapse] {
        let options = RemovalOptions::default().with_retriangulation(retriangulation);
        let built = build_fragments(mesh, &options.with_height_field(is_height_field)).unwrap().fragmented;
        counts.push(sum_at_levels(built.fragments.levels().step_count(), |at| replay_fragments(&built, at)));
    }
    for collapse in [PlacedCollapse::Edge, PlacedCollapse::Triangle] {
        let options = PlacedOptions::default().with_collapse(collapse).with_sequence(sequence.clone());
        let built = build_placed_fragments(mesh, &options).unwrap().fragmented;
        counts.push(sum_at_levels(built.fragments.levels().step_count(), |at| replay_fragments(&built, at)));
    }
    let placed = SHARES.map(|share| {
        let options = SimplifyOptions::default()
            .with_target(Target::Triangles((share * mesh.triangle_count() as f64) as usize))
            .with_placement(Placement::Optimal)
            .with_sequence(sequence.clone());
        turned_count(&simplify(mesh, &options).unwrap().mesh)
    });
    counts.push(placed.iter().sum());
    counts
}

#[test]
fn no_triangle_of_a_height_field_turns_over() {
    let mesh = cliffs();
    assert_eq!(turned_count(&mesh), 0);
    assert!(counts(&mesh, false).iter().all(|&count| count > 0), "the test needs a steep mesh");
    assert_eq!(counts(&mesh, true), [0; 7]);
    // Far from the origin, and with samples in lines that rounding would bend.
    let mut far = mesh;
    for [x, y, _] in &mut far.positions {
        (*x, *y) = (4000.0 + 0.1 * *x, 9000.0 + 0.3 * *y);
    }
    assert_eq!(turned_count(&far), 0);
    assert_eq!(counts(&far, true), [0; 7]);
}

#[test]
fn a_georeference_makes_it_the_default() {
    let mut mesh = cliffs();
    let built = |mesh: &IndexedMesh, options| build_sequence(mesh, &options).unwrap().refinable;
    let option = || SequenceOptions::default();
    let plain = built(&mesh, option());
    assert_eq!(plain, built(&mesh, option().with_height_field(false)));
    let kept = built(&mesh, option().with_height_field(true));
    assert_ne!(plain.sequence, kept.sequence);
    mesh.appearance.georeference = "{}".to_owned();
    assert_eq!(built(&mesh, option()).sequence, kept.sequence);
    assert_eq!(built(&mesh, option().with_height_field(false)).sequence, plain.sequence);
}

#[test]
fn a_surface_that_faces_down_stays_one() {
    let mut mesh = cliffs();
    mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    let options = SequenceOptions::default().with_height_field(true);
    let built = build_sequence(&mesh, &options).unwrap().refinable;
    for share in SHARES {
        let level = replay(&built, (share * built.sequence.step_count() as f64) as usize);
        assert_eq!(turned_count(&level), level.triangle_count());
    }
}
