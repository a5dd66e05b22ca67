//! A hierarchy that grows step by step shows the same triangles as replay and fans, regardless of how its
//! steps arrive.

use striata_testing::meshes;

use striata_testing::support;

use striata::mesh::{
    CollapseSequence, IndexedMesh, PositionIndex, RefinableMesh, SequenceParts, canonical_triangles, replay,
    shapes,
};
use striata::model::{FanFront, FanInstance, FanScene, Fans};
use striata::simplify::{BatchOptions, SequenceOptions, build_batches, build_sequence};
use striata::view::{Camera, Criterion, Part, ScreenError};
use striata_stream::{
    GrowingHierarchy, HierarchyCut, PrefixMesh, StreamDecoder, StreamOptions, encode_stream,
};
use support::{
    ArbitraryCriterion, Case, Random, hub_cases, nasty_cases, seam_cases, selective_triangles, surface_cases,
    with_seams_and_groups,
};

/// The arrays of a mesh whose triangles are listed in the order in which steps add them.
struct Ordered {
    refinable: RefinableMesh,
    triangles: Vec<[u32; 3]>,
}

/// The arrays of a prefix.
struct Prefix {
    positions: Vec<[f32; 3]>,
    first_vertices: Vec<u32>,
    targets: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    added: Vec<u8>,
}

fn is_proper(&[a, b, c]: &[u32; 3]) -> bool {
    a != b && b != c && c != a
}

impl Ordered {
    fn new(refinable: RefinableMesh) -> Self {
        let mut triangles: Vec<_> = refinable.mesh.triangles.iter().copied().filter(is_proper).collect();
        triangles.sort_by_key(|&corners| Self::adder(&refinable.sequence, corners));
        Self { refinable, triangles }
    }

    /// Returns one more than the step that adds a triangle, or 0 for a triangle of the base.
    fn adder(sequence: &CollapseSequence, mut corners: [u32; 3]) -> usize {
        let base = sequence.base_position_count();
        loop {
            let positions = corners.map(|v| sequence.positions().position_of(v) as usize);
            let youngest = positions[0].max(positions[1]).max(positions[2]);
            let Some(step) = youngest.checked_sub(base) else { return 0 };
            let vertices = sequence.step_vertices(step);
            corners = corners.map(|v| if vertices.contains(&v) { sequence.target(v) } else { v });
            if !is_proper(&corners) {
                return step + 1;
            }
        }
    }

    fn prefix(&self, split_count: usize) -> Prefix {
        let sequence = &self.refinable.sequence;
        let missing = &sequence.removed_triangle_counts()[split_count..];
        let triangle_count = self.triangles.len() - missing.iter().map(|&n| usize::from(n)).sum::<usize>();
        let vertex_count = sequence.vertex_count_at(split_count);
        let shown = |mut v: u32| {
            while v as usize >= vertex_count {
                v = sequence.target(v);
            }
            v
        };
        let position_count = sequence.base_position_count() + split_count;
        Prefix {
            positions: self.refinable.mesh.positions[..vertex_count].to_vec(),
            first_vertices: sequence.positions().first_vertices()[..=position_count].to_vec(),
            targets: sequence.targets()[..vertex_count - sequence.base_vertex_count()].to_vec(),
            triangles: self.triangles[..triangle_count].iter().map(|t| t.map(shown)).collect(),
            added: sequence.removed_triangle_counts()[..split_count].to_vec(),
        }
    }
}

impl Prefix {
    fn mesh(&self) -> PrefixMesh<'_> {
        PrefixMesh {
            positions: &self.positions,
            first_vertices: &self.first_vertices,
            targets: &self.targets,
            triangles: &self.triangles,
            added_triangle_counts: &self.added,
        }
    }

    /// Returns the mesh in the form that models are built from.
    fn refinable(&self) -> RefinableMesh {
        let step_count = self.added.len();
        let sequence = CollapseSequence::from_parts(SequenceParts {
            positions: PositionIndex::from_first(self.first_vertices.clone()),
            base_position_count: self.first_vertices.len() - 1 - step_count,
            targets: self.targets.clone(),
            errors: (0..step_count).map(error).collect(),
            removed_triangle_counts: self.added.clone(),
            triangle_count: self.triangles.len(),
        });
        RefinableMesh {
            mesh: IndexedMesh::new(self.positions.clone(), self.triangles.clone()),
            sequence: sequence.unwrap(),
        }
    }

    /// Older triangles whose corners have changed.
    fn changed_since(&self, before: &Self) -> Vec<u32> {
        let pairs = before.triangles.iter().zip(&self.triangles).enumerate();
        pairs.filter(|(_, (old, new))| old != new).map(|(t, _)| t as u32).collect()
    }
}

fn shown(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    triangles.iter().copied().filter(is_proper).collect()
}

fn error(step: usize) -> f32 {
    4.0 / (step as f32 + 2.0)
}

/// Grows to prefixes of random lengths and visits each of them.
fn grow_randomly(ordered: &Ordered, seed: u64, mut visit: impl FnMut(&GrowingHierarchy, &Prefix)) {
    let mut random = Random::new(seed);
    let step_count = ordered.refinable.sequence.step_count();
    let (mut hierarchy, mut split_count) = (GrowingHierarchy::new(), 0);
    let mut before = ordered.prefix(0);
    loop {
        let prefix = ordered.prefix(split_count);
        hierarchy.grow(&prefix.mesh(), &prefix.changed_since(&before), error);
        visit(&hierarchy, &prefix);
        if split_count == step_count {
            return;
        }
        split_count = (split_count + 1 + random.below(1 + step_count / 3)).min(step_count);
        before = prefix;
    }
}

fn cases() -> impl Iterator<Item = (u64, Ordered)> {
    let cases = nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases());
    cases.map(|Case { refinable, seed, .. }| (seed, Ordered::new(refinable)))
}

fn triangles_of(cut: &HierarchyCut, hierarchy: &GrowingHierarchy, prefix: &Prefix) -> Vec<[u32; 3]> {
    let mut shown = Vec::new();
    cut.triangles_into(hierarchy, &prefix.mesh(), &mut shown);
    canonical_triangles(&shown.into_iter().map(|(_, corners)| corners).collect::<Vec<_>>())
}

/// A camera at a random position around the mesh.
fn camera(prefix: &Prefix, random: &mut Random, pixels: f32) -> ScreenError {
    let bounds = IndexedMesh::new(prefix.positions.clone(), Vec::new()).bounds().unwrap();
    let mut point = |spread: f32| {
        let shift = bounds.diagonal() as f32 * spread + 0.1;
        [0, 1, 2].map(|i| {
            let middle = bounds.min[i] / 2.0 + bounds.max[i] / 2.0;
            middle + (random.below(1000) as f32 / 1000.0 - 0.5) * shift
        })
    };
    let (eye, to) = (point(3.0), point(1.0));
    ScreenError::new(Camera::new(eye, to, [0.1, 1.0, 0.2], 0.5, [800, 600]).unwrap(), pixels)
}

#[test]
fn every_level_of_any_prefix_equals_replay() {
    for (seed, ordered) in cases() {
        grow_randomly(&ordered, seed, |hierarchy, prefix| {
            let refinable = prefix.refinable();
            assert_eq!(hierarchy.step_count(), prefix.added.len());
            for split_count in (0..=prefix.added.len()).step_by(1 + prefix.added.len() / 9) {
                let mut level = Vec::new();
                prefix.mesh().triangles_at_into(split_count, &mut level);
                let level: Vec<_> = level.into_iter().map(|(_, corners)| corners).collect();
                let expected = replay(&refinable, split_count).triangles;
                assert_eq!(canonical_triangles(&level), canonical_triangles(&expected));
            }
        });
    }
}

#[test]
fn a_view_refines_the_same_steps_as_fans() {
    let mut refined_count = 0;
    for (seed, ordered) in cases() {
        let mut random = Random::new(seed);
        grow_randomly(&ordered, seed, |hierarchy, prefix| {
            if prefix.positions.is_empty() {
                return;
            }
            let refinable = prefix.refinable();
            let fans = Fans::build(&refinable);
            let mut cut = HierarchyCut::new();
            for pixels in [1.0, 60.0] {
                let criterion = camera(prefix, &mut random, pixels);
                let update = cut.refine(hierarchy, &criterion, usize::MAX);
                // Without the tree, so that a step that the tree hides would be missed.
                let is_wanted = |step| criterion.weigh(&hierarchy.part(step)).should_refine();
                let expected = FanInstance::refined(&fans, is_wanted);
                let is_same =
                    (0..prefix.added.len() as u32).all(|s| expected.is_refined(s) == cut.is_refined(s));
                assert!(is_same, "{} steps, seed {seed}", prefix.added.len());
                let shown = triangles_of(&cut, hierarchy, prefix);
                assert_eq!(update.triangle_count, shown.len());
                let plain =
                    selective_triangles(&refinable, &prefix.triangles, |step| !expected.is_refined(step));
                assert_eq!(shown, canonical_triangles(&plain));
                refined_count += cut.split_count();
            }
        });
    }
    assert!(refined_count > 10_000, "only {refined_count} steps were refined");
}

#[test]
fn requested_steps_include_the_same_dependencies_as_in_fans() {
    for (seed, ordered) in cases() {
        grow_randomly(&ordered, seed, |hierarchy, prefix| {
            let refinable = prefix.refinable();
            let fans = Fans::build(&refinable);
            let mut cut = HierarchyCut::new();
            for round in 0..4 {
                cut.refine(hierarchy, &ArbitraryCriterion(round), usize::MAX);
                let expected = FanInstance::refined(&fans, |step| cut.is_refined(step));
                assert_eq!(expected.split_count(), cut.split_count());
                let plain = selective_triangles(&refinable, &prefix.triangles, |step| !cut.is_refined(step));
                assert_eq!(triangles_of(&cut, hierarchy, prefix), canonical_triangles(&plain));
            }
        });
    }
}

#[test]
fn steps_beyond_a_limit_stay_coarse() {
    for (seed, ordered) in cases() {
        let whole = ordered.prefix(ordered.refinable.sequence.step_count());
        let mut hierarchy = GrowingHierarchy::new();
        hierarchy.grow(&whole.mesh(), &[], error);
        let limit = whole.added.len() / 2;
        let part = ordered.prefix(limit);
        let mut cut = HierarchyCut::new();
        cut.limit_steps(limit);
        cut.refine(&hierarchy, &|_: &Part| 2.0, usize::MAX);
        assert_eq!(cut.split_count(), limit, "seed {seed}");
        assert_eq!(triangles_of(&cut, &hierarchy, &whole), canonical_triangles(&shown(&part.triangles)));
    }
}

#[test]
fn the_tree_does_not_depend_on_how_steps_arrive() {
    for (seed, ordered) in cases() {
        let whole = ordered.prefix(ordered.refinable.sequence.step_count());
        let mut at_once = GrowingHierarchy::new();
        at_once.grow(&whole.mesh(), &[], error);
        grow_randomly(&ordered, seed, |hierarchy, _| {
            for step in 0..hierarchy.step_count() as u32 {
                assert_eq!(hierarchy.parent(step), at_once.parent(step));
                assert!(hierarchy.parent(step).is_none_or(|parent| parent < step));
            }
        });
    }
}

/// Covers seams, groups, hubs, open borders, edges of many triangles, and a truncated chunk.
#[test]
fn a_growing_stream_gives_the_same_cuts_as_fans() {
    let meshes = [
        shapes::uv_sphere(24, 24, 1.0),
        with_seams_and_groups(shapes::torus(24, 12, 1.0, 0.4)),
        shapes::terrain(20, 3),
        shapes::closed_fan(300),
        shapes::book(12),
        shapes::moebius_strip(40),
        // Steps that change the topology.
        meshes::asset(30, 3),
        meshes::asset(12, 4),
    ];
    for mesh in meshes {
        let batches = BatchOptions::default().with_general_floor(20);
        let built = build_batches(&mesh, &batches).unwrap();
        let options = StreamOptions::default();
        let bytes = encode_stream(&built.built.refinable, &built.batches, &options).unwrap().bytes;
        for length in [bytes.len(), bytes.len() * 4 / 5] {
            let (mut decoder, mut hierarchy) = (StreamDecoder::new(), GrowingHierarchy::new());
            let error = |decoder: &StreamDecoder, step| decoder.error_at(step).unwrap();
            for piece in bytes[..length].chunks(97) {
                let changed = decoder.push(piece).unwrap().changed_triangles;
                hierarchy.grow(&decoder.prefix(), &changed, |step| error(&decoder, step));
            }
            if length < bytes.len() && decoder.split_count() > 0 {
                let changed = decoder.finish().unwrap().changed_triangles;
                hierarchy.grow(&decoder.prefix(), &changed, |step| error(&decoder, step));
            }
            let Some(refinable) = decoder.refinable_mesh() else { continue };
            let fans = Fans::build(&refinable);
            let mut cut = HierarchyCut::new();
            for round in 0..6 {
                cut.refine(&hierarchy, &ArbitraryCriterion(round), usize::MAX);
                let expected = FanInstance::refined(&fans, |step| cut.is_refined(step));
                assert_eq!(expected.split_count(), cut.split_count());
                let mut shown = Vec::new();
                cut.triangles_into(&hierarchy, &decoder.prefix(), &mut shown);
                let shown: Vec<_> = shown.into_iter().map(|(_, corners)| corners).collect();
                let plain =
                    selective_triangles(&refinable, &refinable.mesh.triangles, |step| !cut.is_refined(step));
                assert_eq!(canonical_triangles(&shown), canonical_triangles(&plain));
            }
        }
    }
}

#[test]
fn a_budget_is_spent_on_the_largest_errors() {
    let mut bound = 0;
    for (seed, ordered) in surface_cases().chain(seam_cases()).map(|c| (c.seed, Ordered::new(c.refinable))) {
        let mut random = Random::new(seed);
        grow_randomly(&ordered, seed, |hierarchy, prefix| {
            let (mut cut, mut free) = (HierarchyCut::new(), HierarchyCut::new());
            for share in [10, 25, 60] {
                let criterion = camera(prefix, &mut random, 1.0);
                let limit = prefix.triangles.len() * share / 100;
                let update = cut.refine(hierarchy, &criterion, limit);
                assert!(update.triangle_count <= limit.max(hierarchy.base_triangle_count()));
                // Around the eye weights are infinite, so no threshold can separate them.
                if update.threshold.is_infinite() {
                    continue;
                }
                let asked = &criterion;
                let of = |threshold: f32| move |part: &Part| asked.weigh(part).weight / threshold;
                if update.threshold > 1.0 {
                    bound += 1;
                    let more = free.refine(hierarchy, &of(update.threshold * (1.0 - 1e-6)), usize::MAX);
                    assert!(more.triangle_count > limit);
                }
                free.refine(hierarchy, &of(update.threshold), usize::MAX);
                let is_missing = |step| free.is_refined(step) && !cut.is_refined(step);
                assert!(!(0..prefix.added.len() as u32).any(is_missing));
            }
        });
    }
    assert!(bound > 50, "only {bound} budgets were too small for the view");
}

#[test]
fn views_need_few_more_triangles_than_with_bounds_built_from_the_leaves() {
    let meshes = [shapes::uv_sphere(60, 60, 1.0), shapes::terrain(64, 3), shapes::torus(80, 40, 1.0, 0.4)];
    for mesh in meshes {
        let built = build_sequence(&mesh, &SequenceOptions::default());
        let ordered = Ordered::new(built.unwrap().refinable);
        let sequence = &ordered.refinable.sequence;
        let fans = Fans::build(&ordered.refinable);
        let scene = FanScene::new(&fans, &ordered.refinable.mesh.positions);
        let whole = ordered.prefix(sequence.step_count());
        let (mut hierarchy, mut before) = (GrowingHierarchy::new(), ordered.prefix(0));
        for split_count in (0..sequence.step_count()).step_by(200).chain([sequence.step_count()]) {
            let prefix = ordered.prefix(split_count);
            let changed = prefix.changed_since(&before);
            hierarchy.grow(&prefix.mesh(), &changed, |step| sequence.error_at(step));
            before = prefix;
        }
        let (mut cut, mut front) = (HierarchyCut::new(), FanFront::new(&scene));
        let (mut random, mut counts) = (Random::new(7), [0; 2]);
        for _ in 0..40 {
            let criterion = camera(&whole, &mut random, 1.0);
            front.update(&scene, &criterion, usize::MAX);
            let grown = cut.refine(&hierarchy, &criterion, usize::MAX);
            counts = [counts[0] + front.triangle_count(), counts[1] + grown.triangle_count];
        }
        assert!(counts[1] * 100 < counts[0] * 115, "{counts:?}");
    }
}
