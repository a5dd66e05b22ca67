//! Geomorphs: both ends match their level exactly, including wedges, nothing jumps in between, and
//! animated instances follow a changing target without jumps.

use striata_testing::meshes;

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::{AttributeLayer, RefinableMesh, Semantic, canonical_triangles, replay};
use striata::model::{FanInstance, FanMorphs, Fans, Geomorph, LodModel, VertexBlend};
use striata::simplify::{CostFunction, build_sequence};
use support::{
    Case, Random, RandomSequenceOptions, grid, hub_cases, nasty_cases, random_refinable, seam_cases, soups,
    with_seams_and_groups,
};

type Position = [f32; 3];

/// Triangles by the values at their corners, smallest corner first; degenerate ones are dropped.
fn seen<const N: usize>(triangles: impl IntoIterator<Item = [[f32; N]; 3]>) -> Vec<[[u32; N]; 3]> {
    let mut out: Vec<_> = triangles
        .into_iter()
        .filter(|[a, b, c]| a[..3] != b[..3] && b[..3] != c[..3] && c[..3] != a[..3])
        // Normalizes -0 to 0.
        .map(|corners| corners.map(|numbers| numbers.map(|x| (x + 0.0).to_bits())))
        .map(|mut corners| {
            let least = (0..3).min_by_key(|&i| corners[i]).unwrap();
            corners.rotate_left(least);
            corners
        })
        .collect();
    out.sort_unstable();
    out
}

/// The oracle: the triangles of the full mesh, with each corner mapped to the first active vertex in its
/// chain of targets.
fn oracle(refinable: &RefinableMesh, is_collapsed: impl Fn(u32) -> bool) -> Vec<[u32; 3]> {
    let sequence = &refinable.sequence;
    let base = sequence.base_position_count();
    let shown = |mut v: u32| {
        while let Some(step) = (sequence.positions().position_of(v) as usize).checked_sub(base) {
            if !is_collapsed(step as u32) {
                break;
            }
            v = sequence.target(v);
        }
        v
    };
    refinable.mesh.triangles.iter().map(|t| t.map(shown)).collect()
}

fn drawn(fans: &Fans, instance: &FanInstance) -> Vec<[u32; 3]> {
    let mut indices = Vec::new();
    instance.indices_into(fans, &mut indices);
    indices.as_chunks().0.to_vec()
}

fn at_positions<'a>(
    triangles: &'a [[u32; 3]],
    positions: &'a [Position],
) -> impl Iterator<Item = [Position; 3]> + 'a {
    triangles.iter().map(|t| t.map(|v| positions[v as usize]))
}

fn distance(a: Position, b: Position) -> f64 {
    (0..3).map(|i| (f64::from(a[i]) - f64::from(b[i])).powi(2)).sum::<f64>().sqrt()
}

/// Returns an instance reached by random splits and collapses.
fn random_instance(fans: &Fans, random: &mut Random) -> FanInstance {
    let step_count = fans.step_count();
    let mut instance = FanInstance::uniform(fans, random.below(step_count + 1));
    for _ in 0..step_count.min(12) {
        let step = random.below(step_count) as u32;
        match random.below(3) {
            0 => instance.collapse(fans, step),
            _ => instance.split(fans, step),
        };
    }
    instance
}

/// Blends 0 and 1 match the oracle. In between, the vertex blends match the positions, and positions move
/// evenly.
fn check_blend<S>(
    refinable: &RefinableMesh,
    morph: &Geomorph<S>,
    drawn: &[[u32; 3]],
    ends: [&[[u32; 3]]; 2],
) {
    let own = &refinable.mesh.positions;
    let mut positions = own.clone();
    for (blend, end) in [(0.0, ends[0]), (1.0, ends[1])] {
        morph.blend_into(blend, own, &mut positions);
        assert_eq!(seen(at_positions(drawn, &positions)), seen(at_positions(end, own)), "at blend {blend}");
    }
    let mut table = Vec::new();
    let mut before = own.clone();
    morph.blend_into(f32::NAN, own, &mut before);
    let lengths: Vec<f64> = {
        let mut last = own.clone();
        morph.blend_into(7.0, own, &mut last);
        before.iter().zip(&last).map(|(&a, &b)| distance(a, b)).collect()
    };
    for quarter in 1..=4 {
        let blend = quarter as f32 / 4.0;
        morph.blend_into(blend, own, &mut positions);
        morph.vertex_blends_into(blend, own.len(), &mut table);
        for (v, &VertexBlend { target, factor }) in table.iter().enumerate() {
            let [from, to] = [own[target as usize], own[v]];
            let mixed = [0, 1, 2].map(|i| from[i] * (1.0 - factor) + to[i] * factor);
            assert!(distance(mixed, positions[v]) <= 1e-5 * (1.0 + lengths[v]));
            let moved = distance(before[v], positions[v]);
            assert!((moved - lengths[v] / 4.0).abs() <= 1e-5 * (1.0 + lengths[v]), "vertex {v} at {blend}");
        }
        before.clone_from(&positions);
    }
    morph.restore_into(own, &mut positions);
    assert_eq!(&positions, own);
    assert_eq!(morph.bytes(), 8 * (morph.appearing().len() + morph.vanishing().len()));
}

fn check_between(case: &Case) {
    let refinable = &case.refinable;
    let fans = Fans::build(refinable);
    let mut random = Random::new(case.seed + 1);
    for _ in 0..8 {
        let [from, to] = [(); 2].map(|()| random_instance(&fans, &mut random));
        let morph = Geomorph::between(&refinable.sequence, &from, &to);
        let all = drawn(&fans, morph.drawn());
        let proper = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        let mut union = oracle(refinable, |step| !from.is_refined(step) && !to.is_refined(step));
        union.retain(proper);
        assert_eq!(canonical_triangles(&all), canonical_triangles(&union));
        let ends = [&from, &to].map(|instance| oracle(refinable, |step| !instance.is_refined(step)));
        check_blend(refinable, &morph, &all, [&ends[0], &ends[1]]);
        assert!(Geomorph::between(&refinable.sequence, &from, &from).bytes() == 0);
    }
    check_uniform(case, &mut random);
}

fn check_uniform(case: &Case, random: &mut Random) {
    let refinable = &case.refinable;
    let step_count = refinable.sequence.step_count();
    for _ in 0..6 {
        let [from, to] = [(); 2].map(|()| random.below(step_count + 1));
        let morph = Geomorph::uniform(&refinable.sequence, from, to);
        assert_eq!(*morph.drawn(), from.max(to));
        let levels = [from.max(to), from, to].map(|split_count| replay(refinable, split_count).triangles);
        check_blend(refinable, &morph, &levels[0], [&levels[1], &levels[2]]);
        let fans = Fans::build(refinable);
        let [a, b] = [from, to].map(|split_count| FanInstance::uniform(&fans, split_count));
        let between = Geomorph::between(&refinable.sequence, &a, &b);
        assert_eq!((between.appearing(), between.vanishing()), (morph.appearing(), morph.vanishing()));
    }
}

#[test]
fn geomorphs_of_nasty_meshes_begin_and_end_exactly() {
    nasty_cases().for_each(|case| check_between(&case));
}

#[test]
fn geomorphs_of_seams_and_hubs_begin_and_end_exactly() {
    seam_cases().chain(hub_cases().take(4)).for_each(|case| check_between(&case));
}

/// At either end, each corner has the attributes of the wedge that the level shows, not those of another
/// wedge there.
#[test]
fn attributes_stay_on_their_side_of_a_seam() {
    for case in seam_cases() {
        let refinable = &case.refinable;
        let fans = Fans::build(refinable);
        let mut random = Random::new(case.seed);
        let (own, uv) = (&refinable.mesh.positions, &refinable.mesh.layers[0]);
        let corner = |v: u32, place: Position, uvs: &[f32]| {
            let at = 2 * v as usize;
            [place[0], place[1], place[2], uvs[at], uvs[at + 1]]
        };
        let uvs: Vec<f32> = (0..own.len()).flat_map(|v| [uv.get(v, 0), uv.get(v, 1)]).collect();
        for _ in 0..6 {
            let ends = [(); 2].map(|()| random_instance(&fans, &mut random));
            let morph = Geomorph::between(&refinable.sequence, &ends[0], &ends[1]);
            let all = drawn(&fans, morph.drawn());
            for (blend, end) in [0.0, 1.0].into_iter().zip(&ends) {
                let (mut positions, mut mixed) = (own.clone(), uvs.clone());
                morph.blend_into(blend, own, &mut positions);
                morph.blend_layer_into(blend, uv, &mut mixed);
                let found = all.iter().map(|t| t.map(|v| corner(v, positions[v as usize], &mixed)));
                let expected = oracle(refinable, |step| !end.is_refined(step));
                let expected = expected.iter().map(|t| t.map(|v| corner(v, own[v as usize], &uvs)));
                assert_eq!(seen(found), seen(expected));
            }
        }
    }
}

#[test]
fn normals_keep_their_length() {
    let mut mesh = grid(8, true);
    let normal = |v: usize| {
        let [x, y, z] = [(v % 5) as f32 - 2.0, (v % 3) as f32 - 1.0, 1.0];
        let length = (x * x + y * y + z * z).sqrt();
        [x / length, y / length, z / length]
    };
    mesh.layers = vec![AttributeLayer::from_f32(
        Semantic::Normal,
        3,
        (0..mesh.vertex_count()).flat_map(normal).collect(),
    )];
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(5));
    let fans = Fans::build(&refinable);
    let (layer, sequence) = (&refinable.mesh.layers[0], &refinable.sequence);
    let length = |out: &[f32], v: u32| out[3 * v as usize..][..3].iter().map(|x| x * x).sum::<f32>().sqrt();
    let mut out = vec![0.0; 3 * refinable.mesh.vertex_count()];
    let morph = Geomorph::uniform(sequence, 0, sequence.step_count());
    assert_eq!(morph.appearing().len(), fans.step_count());
    for blend in [0.1, 0.5, 0.9] {
        morph.blend_layer_into(blend, layer, &mut out);
        let moved = morph.appearing().iter().map(|moved| moved.vertex);
        moved.for_each(|v| assert!((length(&out, v) - 1.0).abs() < 1e-5));
    }
    let mut morphs = FanMorphs::new(&FanInstance::uniform(&fans, 0), 4);
    for _ in 0..3 {
        morphs.advance(&fans, &FanInstance::full(&fans));
        morphs.layer_into(sequence, layer, &mut out);
        morphs.moving(sequence).for_each(|moved| assert!((length(&out, moved.vertex) - 1.0).abs() < 1e-5));
    }
}

/// Computes the drawn position of each vertex of the full mesh: its factor blends between the drawn
/// position of its target and its own. Vertices that are not drawn have factor 0. Independent of which
/// vertices the morphs draw.
fn drawn_positions(refinable: &RefinableMesh, morphs: &FanMorphs, factors: &mut Vec<f32>) -> Vec<Position> {
    let (sequence, own) = (&refinable.sequence, &refinable.mesh.positions);
    let base = sequence.base_position_count() as u32;
    factors.clear();
    factors.extend((0..own.len() as u32).map(|v| {
        let step = sequence.positions().position_of(v).checked_sub(base);
        if step.is_some_and(|step| !morphs.drawn().is_refined(step)) { 0.0 } else { 1.0 }
    }));
    let mut reached = 0;
    for moving in morphs.moving(sequence) {
        assert!(moving.vertex >= reached && moving.target < moving.vertex, "from coarse to fine");
        reached = moving.vertex;
        assert_eq!(factors[moving.vertex as usize], 1.0, "only what is drawn moves");
        assert!((0.0..1.0).contains(&moving.factor));
    }
    for moving in morphs.moving(sequence) {
        factors[moving.vertex as usize] = moving.factor;
    }
    let mut positions = own.clone();
    for v in 0..own.len() {
        let (from, factor) = (positions[sequence.target(v as u32) as usize], factors[v]);
        positions[v] = match factor {
            1.0 => own[v],
            0.0 => from,
            _ => [0, 1, 2].map(|i| from[i] * (1.0 - factor) + own[v][i] * factor),
        };
    }
    positions
}

/// Follows a target instance that changes at arbitrary times. Each frame must match the full mesh with its
/// vertices at their drawn positions, and each vertex may move only by its share per frame.
fn check_running(case: &Case, frame_count: u16) {
    let refinable = &case.refinable;
    let (sequence, own) = (&refinable.sequence, &refinable.mesh.positions);
    let fans = Fans::build(refinable);
    let mut random = Random::new(case.seed + 3);
    let mut wanted = random_instance(&fans, &mut random);
    let mut morphs = FanMorphs::new(&wanted, frame_count);
    let (mut buffer, mut factors, mut old_factors) = (own.clone(), Vec::new(), Vec::new());
    let mut old = drawn_positions(refinable, &morphs, &mut old_factors);
    let mut still = 0;
    for frame in 0..40 {
        if frame < 30 && random.below(usize::from(frame_count) + 2) == 0 {
            wanted = random_instance(&fans, &mut random);
            still = 0;
        }
        morphs.advance(&fans, &wanted);
        still += 1;
        morphs.positions_into(sequence, own, &mut buffer);
        let positions = drawn_positions(refinable, &morphs, &mut factors);
        let all = drawn(&fans, morphs.drawn());
        let found = seen(at_positions(&all, &buffer));
        assert_eq!(found, seen(at_positions(&refinable.mesh.triangles, &positions)), "frame {frame}");
        check_motion(refinable, frame_count, [&old, &positions], [&old_factors, &factors]);
        if still >= usize::from(frame_count) {
            assert_eq!((morphs.drawn(), morphs.moving_count()), (&wanted, 0), "at rest after its frames");
            let level = oracle(refinable, |step| !wanted.is_refined(step));
            assert_eq!(found, seen(at_positions(&level, own)));
        }
        (old, old_factors) = (positions, factors.clone());
    }
}

/// A vertex moves by at most the motion of its target plus its share of the distance between the two.
fn check_motion(
    refinable: &RefinableMesh,
    frame_count: u16,
    positions: [&[Position]; 2],
    factors: [&[f32]; 2],
) {
    let own = &refinable.mesh.positions;
    let extent = own.iter().flatten().fold(1.0, |most: f32, x| most.max(x.abs()));
    let rounding = 4e-7 * f64::from(extent);
    for v in 0..own.len() {
        let target = refinable.sequence.target(v as u32) as usize;
        let share = 1.0 / f64::from(frame_count);
        assert!(f64::from((factors[0][v] - factors[1][v]).abs()) <= share * (1.0 + 1e-6));
        let gap = distance(own[v], positions[0][target]);
        let limit = if target == v {
            0.0
        } else {
            gap * share + distance(positions[0][target], positions[1][target])
        };
        let moved = distance(positions[0][v], positions[1][v]);
        assert!(moved <= limit + rounding, "vertex {v} jumps by {moved} of {limit}");
    }
}

#[test]
fn nothing_pops_on_nasty_meshes() {
    nasty_cases().for_each(|case| check_running(&case, 1 + (case.seed % 5) as u16));
}

#[test]
fn nothing_pops_on_surfaces_and_seams() {
    seam_cases().chain(hub_cases().take(3)).for_each(|case| check_running(&case, 4 + (case.seed % 3) as u16));
    for seed in 0..3 {
        let mesh = with_seams_and_groups(grid(14, seed == 0));
        let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
        let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(seed));
        check_running(&Case { stride: 1, seed, refinable }, 7);
    }
}

#[test]
fn a_jump_is_immediately_at_rest() {
    for case in seam_cases() {
        let (sequence, own) = (&case.refinable.sequence, &case.refinable.mesh.positions);
        let fans = Fans::build(&case.refinable);
        let mut random = Random::new(case.seed);
        let mut morphs = FanMorphs::new(&FanInstance::full(&fans), 5);
        let mut buffer = own.clone();
        for frame in 0..60 {
            let wanted = random_instance(&fans, &mut random);
            if frame % 10 == 9 {
                morphs.jump_to(&fans, &wanted);
                morphs.positions_into(sequence, own, &mut buffer);
                assert_eq!((morphs.drawn(), morphs.moving_count()), (&wanted, 0));
                let triangles = drawn(&fans, &wanted);
                assert_eq!(seen(at_positions(&triangles, &buffer)), seen(at_positions(&triangles, own)));
            } else {
                morphs.advance(&fans, &wanted);
                morphs.positions_into(sequence, own, &mut buffer);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(96) })]

    #[test]
    fn random_meshes_morph_without_jumps(case in soups(), frame_count in 1u16..6) {
        check_between(&case);
        check_running(&case, frame_count);
    }

    #[test]
    fn random_assets_morph_without_jumps(pieces in 1usize..4, seed: u64, cost in 0..CostFunction::ALL.len()) {
        let mesh = meshes::asset(pieces, seed);
        let options = meshes::random_options(&mesh, seed, cost);
        let refinable = build_sequence(&mesh, &options).unwrap().refinable;
        let case = Case { stride: 1, seed: seed >> 1, refinable };
        check_between(&case);
        check_running(&case, 4);
    }
}
