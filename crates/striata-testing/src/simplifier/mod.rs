//! Guarantees that every simplifier gives for its levels, written once for all simplifiers.

mod implementations;

use std::collections::BTreeSet;
use std::fmt::Debug;
use std::ops::ControlFlow;

use striata::mesh::{Adjacency, Edge, IndexedMesh, LevelTable, shapes, weld};
use striata::simplify::{BoundaryRule, SeamRule, SimplifyError, StopReason, TopologyRule};
use striata::{Cancelled, ProgressFn, ignore_progress};

use crate::meshes::{NamedMesh, all, check_each_variant, closed, nasty, open};
use crate::support::Topology;

pub use implementations::hole_fillings;

/// Result of a simplifier.
pub struct SimplifierOutcome {
    /// The full mesh, in refinement order.
    pub full: IndexedMesh,
    pub levels: LevelTable,
    /// Replays the level at a split count.
    pub replay: Box<dyn Fn(usize) -> IndexedMesh>,
    pub stop_reason: StopReason,
}

impl SimplifierOutcome {
    /// Positions of the base mesh.
    pub fn base_positions(&self) -> BTreeSet<[u32; 3]> {
        positions_of(&self.full, self.levels.base_vertex_count())
    }
}

/// The options that all simplifiers share.
pub struct Rules<'a> {
    pub base_triangle_count: &'a mut usize,
    pub boundary: &'a mut BoundaryRule,
    pub group_borders: &'a mut BoundaryRule,
    pub seams: &'a mut SeamRule,
    pub topology: &'a mut TopologyRule,
    pub locked_vertices: &'a mut Vec<u32>,
}

/// The options of a simplifier, which also select the simplifier.
pub trait Simplifier: Clone + Debug {
    /// Named variants of the options; the guarantees hold for all of them.
    fn variants() -> Vec<(String, Self)>;
    fn rules(&mut self) -> Rules<'_>;
    /// Simplifies as far as possible.
    fn run(
        &self,
        mesh: &IndexedMesh,
        progress: &mut ProgressFn<'_>,
    ) -> Result<SimplifierOutcome, SimplifyError>;

    fn outcome(&self, mesh: &IndexedMesh) -> SimplifierOutcome {
        self.run(mesh, &mut ignore_progress).expect("valid meshes can be simplified")
    }

    /// Returns a copy with changed rules.
    fn with_rules(&self, change: impl FnOnce(Rules<'_>)) -> Self {
        let mut options = self.clone();
        change(options.rules());
        options
    }

    /// Returns a copy that preserves seams and topology.
    fn preserving_all(&self) -> Self {
        self.with_rules(|rules| (*rules.seams, *rules.topology) = (SeamRule::Keep, TopologyRule::Keep))
    }
}

/// Turns each of the named checks of [`simplifier`](crate::simplifier) into a test.
#[macro_export]
macro_rules! test_guarantees {
    ($options:ty: $($check:ident),+ $(,)?) => {
        $(
            #[test]
            fn $check() {
                $crate::simplifier::$check::<$options>();
            }
        )+
    };
}

/// Returns the bits of a position, with -0 mapped to 0.
pub fn key(p: [f32; 3]) -> [u32; 3] {
    p.map(|x| (x + 0.0).to_bits())
}

/// Positions of the first vertices of a mesh.
pub fn positions_of(mesh: &IndexedMesh, vertex_count: usize) -> BTreeSet<[u32; 3]> {
    mesh.positions[..vertex_count].iter().map(|&p| key(p)).collect()
}

/// Positions on the boundary: at edges with one triangle, or only with both sides of one.
pub fn boundary_of(mesh: &IndexedMesh) -> BTreeSet<[u32; 3]> {
    ends_of_edges(mesh, |adjacency, edge| {
        let apex = |side: u32| adjacency.triangles()[side as usize / 3][(side as usize + 2) % 3];
        match (edge.forward, edge.backward) {
            (&[forward], &[backward]) => apex(forward) == apex(backward),
            _ => edge.is_boundary(),
        }
    })
}

/// Positions at edges with one triangle.
pub fn open_edges_of(mesh: &IndexedMesh) -> BTreeSet<[u32; 3]> {
    ends_of_edges(mesh, |_, edge| edge.is_boundary())
}

fn ends_of_edges(mesh: &IndexedMesh, counts: impl Fn(&Adjacency, &Edge<'_>) -> bool) -> BTreeSet<[u32; 3]> {
    let welded = weld(mesh).expect("test meshes are valid");
    let adjacency = Adjacency::of_positions(&welded.mesh, &welded.positions);
    let place = |p: u32| key(welded.mesh.positions[welded.positions.first_vertex(p) as usize]);
    adjacency.edges().filter(|e| counts(&adjacency, e)).flat_map(|e| e.ends).map(place).collect()
}

/// Positions used by triangles of more than one group.
pub fn group_border_of(mesh: &IndexedMesh) -> BTreeSet<[u32; 3]> {
    let places = mesh.groups.iter().map(|group| -> BTreeSet<[u32; 3]> {
        let corners = mesh.triangles[group.range()].as_flattened().iter();
        corners.map(|&v| key(mesh.positions[v as usize])).collect()
    });
    let places: Vec<_> = places.collect();
    places.iter().enumerate().flat_map(|(i, a)| places[..i].iter().flat_map(move |b| a & b)).collect()
}

/// Runs a check on each mesh with each variant of the options, and fails with a list of all failures.
pub fn check_each<S: Simplifier>(meshes: Vec<NamedMesh>, check: impl Fn(&str, &IndexedMesh, &S)) {
    check_each_variant(meshes, &S::variants(), check);
}

pub fn every_mesh_simplifies_to_a_few_triangles<S: Simplifier>() {
    check_each(all(), |_, mesh, options: &S| {
        let built = options.outcome(mesh);
        let levels = &built.levels;
        let left = levels.triangle_count_at(0);
        // With three positions left, all remaining triangles can only disappear together.
        assert!(left <= 8 || levels.base_position_count() <= 3, "{left} triangles left");
        assert_eq!(left == 0, built.full.triangle_count() == 0, "the last triangles stay");
        let base = (built.replay)(0).without_unused_vertices();
        let used = positions_of(&base, base.vertex_count());
        assert_eq!(used.len(), levels.base_position_count(), "every position of the base is used");
        // A target in between is missed by less than the triangles of one step.
        for split_count in 1..=levels.step_count() {
            let [coarse, fine] = [split_count - 1, split_count].map(|s| levels.triangle_count_at(s));
            for target in coarse..fine {
                let found = levels.split_count_for_triangles(target);
                assert_eq!(levels.triangle_count_at(found), coarse, "at most {target}");
            }
        }
    });
}

pub fn manifolds_keep_their_topology_at_every_level<S: Simplifier>() {
    check_each([closed(), open()].concat(), |_, mesh, options: &S| {
        let expected = Topology::of(mesh);
        assert!(expected.genus.is_some() && expected.duplicate_triangle_count == 0);
        let built = options.with_rules(|rules| *rules.topology = TopologyRule::Keep).outcome(mesh);
        for split_count in (0..=built.levels.step_count()).rev() {
            assert_eq!(Topology::of(&(built.replay)(split_count)), expected, "at {split_count}");
        }
    });
}

/// Checks that surfaces without seams simplify to at most the given triangle counts after `change` has
/// been applied.
pub fn simplifies_to<S: Simplifier>(limits: &[(&str, usize)], change: impl Fn(&S) -> S) {
    let meshes = [closed(), open()].concat();
    let plain = meshes.into_iter().filter(|(name, _)| limits.iter().any(|(n, _)| n == name)).collect();
    check_each(plain, |name, mesh, options: &S| {
        let built = change(options).outcome(mesh);
        let (_, limit) = limits.iter().find(|(n, _)| name.starts_with(&format!("{n},"))).expect("filtered");
        let count = built.levels.triangle_count_at(0);
        assert!(count <= *limit, "{count} triangles left");
        assert_eq!(built.stop_reason, StopReason::BaseReached);
    });
}

pub fn seams_cut_every_level_into_the_same_pieces<S: Simplifier>() {
    // Cut open along its seams, a mesh falls into pieces with boundaries. Removing vertices along seams
    // preserves both.
    let pieces = |mesh: &IndexedMesh| {
        let adjacency = Adjacency::of_vertices(&mesh.without_unused_vertices());
        (adjacency.component_count(), adjacency.boundary_loop_count(), adjacency.bow_ties().len())
    };
    let seamed = [
        ("cylinder", shapes::uv_cylinder(20, 9)),
        ("two materials", shapes::two_material_sphere(9, 12)),
        ("hard cube", shapes::hard_cube()),
    ];
    check_each(seamed.map(|(name, mesh)| (name.to_owned(), mesh)).to_vec(), |name, mesh, options: &S| {
        let welded = weld(mesh).expect("shapes are valid").mesh;
        let built = options.preserving_all().outcome(mesh);
        let step_count = built.levels.step_count();
        let is_simplified = name.starts_with("hard cube") || step_count > welded.vertex_count() / 2;
        assert!(is_simplified, "{step_count} steps");
        for split_count in (0..=step_count).rev() {
            assert_eq!(pieces(&(built.replay)(split_count)), pieces(&welded), "at {split_count}");
        }
    });
}

pub fn locked_vertices_are_in_the_base<S: Simplifier>() {
    check_each(all(), |_, mesh, options: &S| {
        let locked: Vec<u32> = mesh.triangles.iter().flatten().copied().step_by(7).take(12).collect();
        let base = options
            .with_rules(|rules| rules.locked_vertices.clone_from(&locked))
            .outcome(mesh)
            .base_positions();
        // Degenerate triangles are dropped, and such a triangle may be the only one that uses a vertex.
        let position_of_source = weld(mesh).expect("valid").position_of_source;
        for &v in locked.iter().filter(|&&v| position_of_source[v as usize] != u32::MAX) {
            assert!(base.contains(&key(mesh.positions[v as usize])), "vertex {v} was locked");
        }
    });
}

pub fn locked_boundaries_keep_every_vertex<S: Simplifier>() {
    check_each([open(), closed()].concat(), |_, mesh, options: &S| {
        let boundary = boundary_of(mesh);
        let built = options.with_rules(|rules| *rules.boundary = BoundaryRule::Locked).outcome(mesh);
        assert!(boundary.is_subset(&built.base_positions()), "a boundary vertex went");
        let interior = built.levels.positions().position_count() - boundary.len();
        let is_simplified = interior <= 60 || built.levels.step_count() > interior / 3;
        assert!(is_simplified, "the interior is simplified");
    });
}

pub fn locked_group_borders_keep_every_vertex<S: Simplifier>() {
    let sphere = shapes::two_material_sphere(21, 40);
    let border = group_border_of(&sphere);
    assert_eq!(border.len(), 40, "the equator");
    for (variant, options) in S::variants() {
        let base_of =
            |rule| options.with_rules(|rules| *rules.group_borders = rule).outcome(&sphere).base_positions();
        let is_subset = border.is_subset(&base_of(BoundaryRule::Kept));
        assert!(!is_subset, "{variant}: borders that are not locked are simplified");
        let base = base_of(BoundaryRule::Locked);
        assert!(border.is_subset(&base), "{variant}: a vertex of the border went");
        assert!(base.len() < 2 * border.len(), "{variant}: {} positions: the rest is simplified", base.len());
    }
}

pub fn the_base_triangle_count_is_missed_by_less_than_a_step<S: Simplifier>() {
    check_each(all(), |_, mesh, options: &S| {
        let free = options.outcome(mesh).levels;
        let least = free.triangle_count_at(0);
        let goal = usize::midpoint(least, free.triangle_count_at(free.step_count()));
        let built = options.with_rules(|rules| *rules.base_triangle_count = goal).outcome(mesh);
        let found = &built.levels;
        assert!(found.triangle_count_at(0) <= goal);
        // The first steps may restore positions that have no triangle yet.
        let mut counts = (0..=found.step_count()).map(|s| found.triangle_count_at(s));
        let more = counts.find(|&n| n > found.triangle_count_at(0));
        assert!(more.is_none_or(|n| n > goal), "went too far");
        if goal > least {
            assert_eq!(built.stop_reason, StopReason::TargetReached);
        }
    });
}

/// Checks that each of these options is rejected by name.
pub fn rejects<S: Simplifier>(mesh: &IndexedMesh, cases: &[(&str, S)]) {
    for (name, options) in cases {
        match options.run(mesh, &mut ignore_progress) {
            Err(SimplifyError::Option { option, .. }) => assert_eq!(option, *name),
            other => panic!("{name} in {options:?}: {:?}", other.map(|built| built.stop_reason)),
        }
    }
}

pub fn invalid_meshes_are_rejected_with_the_location<S: Simplifier>() {
    let mut count = 0;
    for (name, mesh) in nasty() {
        let Err(expected) = mesh.check() else { continue };
        let (_, options) = S::variants().swap_remove(0);
        let error = options.run(&mesh, &mut ignore_progress).map(|_| ()).unwrap_err();
        // Compared as text, because NaN is not equal to itself.
        assert_eq!(error.to_string(), expected.to_string(), "{name}");
        count += 1;
    }
    assert!(count > 5);
}

pub fn the_callback_sees_progress_and_can_cancel<S: Simplifier>() {
    let mesh = shapes::torus(110, 80, 2.0, 1.0);
    for (variant, options) in S::variants() {
        let mut seen = Vec::new();
        let mut watch = |progress: striata::Progress| {
            seen.push((progress.phase, progress.done, progress.total));
            ControlFlow::Continue(())
        };
        options.run(&mesh, &mut watch).expect("nobody cancels");
        assert!(!seen.is_empty());
        assert!(seen.iter().all(|(_, done, total)| done <= total), "{variant}: {seen:?}");
        let mut phases = seen.chunk_by(|a, b| a.0 == b.0);
        assert!(phases.all(|phase| phase.is_sorted_by_key(|(_, done, _)| *done)), "{variant}: {seen:?}");
        let mut calls = 0;
        let mut cancel = |_| {
            calls += 1;
            ControlFlow::Break(())
        };
        let error = options.run(&mesh, &mut cancel).map(|_| ()).unwrap_err();
        assert_eq!(error, SimplifyError::Cancelled(Cancelled));
        assert_eq!(calls, 1, "{variant}: the callback is not called again after cancelling");
    }
}

pub fn no_triangle_of_a_sphere_turns_inward<S: Simplifier>() {
    let mesh = shapes::icosphere(3, 1.0);
    for (variant, options) in S::variants() {
        let built = options.outcome(&mesh);
        let from = built.levels.split_count_for_triangles(60);
        for split_count in (from..=built.levels.step_count()).step_by(7) {
            let level = (built.replay)(split_count);
            for t in &level.triangles {
                let [a, b, c] = t.map(|v| glam::Vec3::from(level.positions[v as usize]));
                assert!(
                    (b - a).cross(c - a).dot(a + b + c) > 0.0,
                    "{variant} at {split_count}: triangle {t:?}"
                );
            }
        }
    }
}
