//! Followers of a camera: progressive fans with and without memory, as published, and with wider bounds;
//! view-dependent progressive meshes; and a uniform level.

use striata::mesh::RefinableMesh;
use striata::model::{
    BoundScope, FanFront, FanInstance, FanOptions, FanScene, FanTriangles, Fans, FansLevel, LodModel,
};
use striata::view::{Criterion as _, ScreenError};
use striata_lab::baseline::{
    PublishedFans, PublishedFansState, PublishedView, ViewDependentMeshes, ViewDependentState,
};

use super::logged_criterion::{LoggedCriterion, QueryLog};
use super::paths::PIXELS_PER_UNIT;

/// The input of a follower in one frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct View<'s> {
    /// The camera's criterion.
    pub screen: &'s ScreenError,
    /// The uniform level that is fine enough everywhere.
    pub split_count: usize,
}

/// Numbers of splits and collapses, including forced ones.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ForcedChanges {
    /// Number of splits.
    pub split_count: usize,
    /// Number of collapses.
    pub collapse_count: usize,
    /// Number of steps evaluated, if the follower does not use the camera's criterion.
    pub evaluated: Option<usize>,
}

/// A model with one instance that follows a camera.
pub(super) trait ModelFollower<'a> {
    /// Resets to the base, as before the first frame.
    fn restart(&mut self);

    /// Adapts to a view.
    fn follow(&mut self, view: View<'a>, log: Option<&'a QueryLog>) -> ForcedChanges;

    /// Appends the indices of the triangles shown.
    fn emit_into(&mut self, out: &mut Vec<u32>);

    /// Bytes that the instance currently owns.
    fn instance_bytes(&self) -> usize;

    /// How many of these are indices that can be drawn as they are.
    fn index_bytes(&self) -> usize {
        0
    }
}

/// The static halves of the models, shared by all followers.
#[derive(Debug)]
pub(super) struct Models<'r> {
    /// The mesh with its sequence.
    pub refinable: &'r RefinableMesh,
    /// The fans with the bounds of their steps.
    pub fans: Fans,
    /// Fans with bounds over everything that depends on a step.
    dependents: Fans,
    /// The view-dependent progressive mesh, or why it cannot be built.
    pub vdpm: Result<ViewDependentMeshes, String>,
    /// Fans as published, or why they cannot be built.
    pub published: Result<PublishedFans, String>,
}

/// Names of the followers; chart colors follow this order.
pub(super) const NAMES: [&str; 8] = [
    "fans",
    "fans-kept",
    "fans-stateless",
    "vdpm",
    "vdpm-kept",
    "fans-published",
    "fans-dependents",
    "uniform",
];

/// Indices into [`NAMES`].
pub(super) const FANS: usize = 0;
pub(super) const KEPT: usize = 1;
pub(super) const STATELESS: usize = 2;
pub(super) const VDPM: usize = 3;
pub(super) const VDPM_KEPT: usize = 4;
pub(super) const PUBLISHED: usize = 5;
pub(super) const UNIFORM: usize = 7;

impl<'r> Models<'r> {
    /// Builds all models that can be built.
    pub(super) fn build(refinable: &'r RefinableMesh) -> Self {
        let fans = Fans::build(refinable);
        let vdpm = ViewDependentMeshes::build(refinable).map_err(|error| error.to_string());
        let published = PublishedFans::build(refinable).map_err(|error| error.to_string());
        let options = FanOptions::default().with_bounds(Some(BoundScope::Dependents));
        let dependents = Fans::build_with(refinable, &options, &mut striata::ignore_progress)
            .expect("nothing cancels this build");
        Self { refinable, fans, dependents, vdpm, published }
    }

    /// Why a follower cannot be built.
    pub(super) fn why_missing(&self, name: &str) -> Option<String> {
        let is_published = name == NAMES[PUBLISHED];
        if is_published { self.published.as_ref().err().cloned() } else { self.vdpm.as_ref().err().cloned() }
    }

    /// The fans with the data needed to evaluate criteria.
    pub(super) fn scene(&self) -> FanScene<'_> {
        FanScene::new(&self.fans, &self.refinable.mesh.positions)
    }

    /// A follower for each of [`NAMES`], or why it cannot be built.
    pub(super) fn followers<'a>(&'a self) -> Vec<Result<Box<dyn ModelFollower<'a> + 'a>, String>> {
        let scene = self.scene();
        let vdpm = self.vdpm.as_ref().map_err(Clone::clone);
        vec![
            Ok(Box::new(Incremental { scene, front: FanFront::new(&scene) })),
            Ok(Box::new(Kept::new(scene))),
            Ok(Box::new(Stateless { scene, instance: FanInstance::uniform(&self.fans, 0) })),
            vdpm.clone().map(|model| Vdpm::boxed(model, false)),
            vdpm.map(|model| Vdpm::boxed(model, true)),
            self.published.as_ref().map_err(Clone::clone).map(|model| {
                let follower = PublishedFollower { model, state: PublishedFansState::base(model) };
                Box::new(follower) as Box<dyn ModelFollower<'a> + 'a>
            }),
            Ok(Box::new({
                let scene = FanScene::new(&self.dependents, &self.refinable.mesh.positions);
                Incremental { scene, front: FanFront::new(&scene) }
            })),
            Ok(Box::new(Uniform { fans: &self.fans, level: self.fans.new_state() })),
        ]
    }
}

/// Fans that continue from the previous view.
struct Incremental<'a> {
    scene: FanScene<'a>,
    front: FanFront<LoggedCriterion<'a>>,
}

impl<'a> ModelFollower<'a> for Incremental<'a> {
    fn restart(&mut self) {
        self.front = FanFront::new(&self.scene);
    }

    fn follow(&mut self, view: View<'a>, log: Option<&'a QueryLog>) -> ForcedChanges {
        let update =
            self.front.update(&self.scene, &LoggedCriterion { screen: view.screen, log }, usize::MAX);
        ForcedChanges {
            split_count: update.split_count,
            collapse_count: update.collapse_count,
            evaluated: None,
        }
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        self.front.instance().indices_into(self.scene.fans(), out);
    }

    fn instance_bytes(&self) -> usize {
        self.front.bytes()
    }
}

/// Incremental fans that keep their triangles from frame to frame, so that emission writes only those that
/// change.
struct Kept<'a> {
    incremental: Incremental<'a>,
    triangles: FanTriangles,
}

impl<'a> Kept<'a> {
    fn new(scene: FanScene<'a>) -> Self {
        let incremental = Incremental { scene, front: FanFront::new(&scene) };
        let triangles = FanTriangles::new(scene.fans(), incremental.front.instance());
        Self { incremental, triangles }
    }
}

impl<'a> ModelFollower<'a> for Kept<'a> {
    fn restart(&mut self) {
        *self = Self::new(self.incremental.scene);
    }

    fn follow(&mut self, view: View<'a>, log: Option<&'a QueryLog>) -> ForcedChanges {
        self.incremental.follow(view, log)
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        let (fans, shown) = (self.incremental.scene.fans(), self.incremental.front.instance());
        self.triangles.follow(fans, shown);
        out.extend_from_slice(self.triangles.indices());
    }

    fn instance_bytes(&self) -> usize {
        self.incremental.instance_bytes() + self.triangles.bytes() + self.index_bytes()
    }

    fn index_bytes(&self) -> usize {
        size_of_val(self.triangles.indices())
    }
}

/// Fans that store only one bit per step and begin at the base in each frame.
struct Stateless<'a> {
    scene: FanScene<'a>,
    instance: FanInstance,
}

impl<'a> ModelFollower<'a> for Stateless<'a> {
    fn restart(&mut self) {
        self.instance = FanInstance::uniform(self.scene.fans(), 0);
    }

    fn follow(&mut self, view: View<'a>, log: Option<&'a QueryLog>) -> ForcedChanges {
        let split_count = self.instance.refine(&self.scene, &LoggedCriterion { screen: view.screen, log });
        ForcedChanges { split_count, ..ForcedChanges::default() }
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        self.instance.indices_into(self.scene.fans(), out);
    }

    fn instance_bytes(&self) -> usize {
        self.instance.bytes()
    }
}

/// View-dependent progressive meshes, which evaluate every active vertex in each frame, or keep verdicts while they
/// are valid.
struct Vdpm<'a> {
    model: &'a ViewDependentMeshes,
    state: ViewDependentState,
    keeps_verdicts: bool,
    last: Option<&'a ScreenError>,
}

impl<'a> Vdpm<'a> {
    fn boxed(model: &'a ViewDependentMeshes, keeps_verdicts: bool) -> Box<dyn ModelFollower<'a> + 'a> {
        Box::new(Self { model, state: model.base_state(), keeps_verdicts, last: None })
    }
}

impl<'a> ModelFollower<'a> for Vdpm<'a> {
    fn restart(&mut self) {
        (self.state, self.last) = (self.model.base_state(), None);
    }

    fn follow(&mut self, view: View<'a>, log: Option<&'a QueryLog>) -> ForcedChanges {
        let last = self.last.replace(view.screen).filter(|_| self.keeps_verdicts);
        let motion = last.map_or(f32::INFINITY, |last| view.screen.motion_since(last));
        let criterion = LoggedCriterion { screen: view.screen, log };
        let adapted = self.model.adapt_after(&mut self.state, &criterion, motion);
        ForcedChanges {
            split_count: adapted.split_count,
            collapse_count: adapted.collapse_count,
            evaluated: None,
        }
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        self.model.indices_into(&self.state, out);
    }

    fn instance_bytes(&self) -> usize {
        self.state.bytes()
    }
}

/// Fans as published: machine words, the published criterion, and a pass over all bits in each frame.
struct PublishedFollower<'a> {
    model: &'a PublishedFans,
    state: PublishedFansState,
}

impl<'a> ModelFollower<'a> for PublishedFollower<'a> {
    fn restart(&mut self) {
        self.state = PublishedFansState::base(self.model);
    }

    fn follow(&mut self, view: View<'a>, _log: Option<&'a QueryLog>) -> ForcedChanges {
        let view = PublishedView::new(view.screen.camera(), PIXELS_PER_UNIT, view.screen.pixels());
        let changes = self.model.adapt(&mut self.state, &view);
        ForcedChanges {
            split_count: changes.inserted,
            collapse_count: changes.simplified,
            evaluated: Some(changes.evaluated),
        }
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        self.state.triangles_into(self.model, out);
    }

    fn instance_bytes(&self) -> usize {
        self.state.bytes()
    }
}

/// Fans at one level for the whole mesh.
struct Uniform<'a> {
    fans: &'a Fans,
    level: FansLevel,
}

impl<'a> ModelFollower<'a> for Uniform<'a> {
    fn restart(&mut self) {
        self.fans.move_to(&mut self.level, 0);
    }

    fn follow(&mut self, view: View<'a>, _log: Option<&'a QueryLog>) -> ForcedChanges {
        let before = self.fans.split_count(&self.level);
        self.fans.move_to(&mut self.level, view.split_count);
        ForcedChanges {
            split_count: view.split_count.saturating_sub(before),
            collapse_count: before.saturating_sub(view.split_count),
            evaluated: None,
        }
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        self.fans.indices_into(&self.level, out);
    }

    fn instance_bytes(&self) -> usize {
        self.fans.state_bytes(&self.level)
    }
}
