//! Those who follow an eye: progressive fans with and without a memory, their rival, and a level that is the same everywhere.

use striata::mesh::RefinableMesh;
use striata::model::{FanFront, FanInstance, FanScene, FanTriangles, Fans, FansLevel, LodModel};
use striata::view::ScreenError;
use striata_lab::baseline::{ViewDependentMeshes, ViewDependentState};

use super::asker::{Asker, Log};

/// What is shown to a follower in a frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct View<'s> {
    /// The criterion.
    pub(super) screen: &'s ScreenError,
    /// The level that is fine enough everywhere.
    pub(super) split_count: usize,
}

/// Splits and collapses, those that had to be among them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Changes {
    /// Splits.
    pub(super) split_count: usize,
    /// Collapses.
    pub(super) collapse_count: usize,
}

/// A model with one instance that follows an eye.
pub(super) trait Follower<'a> {
    /// Goes back to the base, as if nothing had been seen yet.
    fn restart(&mut self);

    /// Goes to what a view wants.
    fn follow(&mut self, view: View<'a>, log: Option<&'a Log>) -> Changes;

    /// Appends what it shows.
    fn emit_into(&mut self, out: &mut Vec<u32>);

    /// Bytes that the instance owns now.
    fn instance_bytes(&self) -> usize;
}

/// What followers stand on: built once for all.
#[derive(Debug)]
pub(super) struct Models<'r> {
    /// The mesh with its sequence.
    pub(super) refinable: &'r RefinableMesh,
    /// The table with the bounds of its steps.
    pub(super) fans: Fans,
    /// The rival, or why there is none.
    pub(super) rival: Result<ViewDependentMeshes, String>,
}

/// The names of followers; the colors of charts follow this order.
pub(super) const NAMES: [&str; 5] = ["fans", "fans-kept", "fans-stateless", "vdpm", "uniform"];

/// Their places among [`NAMES`].
pub(super) const FANS: usize = 0;
pub(super) const KEPT: usize = 1;
pub(super) const STATELESS: usize = 2;
pub(super) const RIVAL: usize = 3;
pub(super) const UNIFORM: usize = 4;

impl<'r> Models<'r> {
    /// Builds all that can be built.
    pub(super) fn build(refinable: &'r RefinableMesh) -> Self {
        let fans = Fans::build(refinable);
        let rival = ViewDependentMeshes::build(refinable).map_err(|error| error.to_string());
        Self { refinable, fans, rival }
    }

    /// The table with what it takes to ask for its steps.
    pub(super) fn scene(&self) -> FanScene<'_> {
        FanScene::new(&self.fans, self.refinable)
    }

    /// A follower for each of [`NAMES`], or why there is none.
    pub(super) fn followers<'a>(&'a self) -> Vec<Result<Box<dyn Follower<'a> + 'a>, String>> {
        let scene = self.scene();
        let rival = self.rival.as_ref().map_err(Clone::clone);
        vec![
            Ok(Box::new(Incremental { scene, front: FanFront::new(&scene) })),
            Ok(Box::new(Kept::new(scene, self.refinable))),
            Ok(Box::new(Stateless { scene, instance: FanInstance::uniform(&self.fans, 0) })),
            rival.map(|model| {
                let follower = Rival { model, state: model.base_state() };
                Box::new(follower) as Box<dyn Follower<'a> + 'a>
            }),
            Ok(Box::new(Uniform { fans: &self.fans, level: self.fans.new_state() })),
        ]
    }
}

/// Fans that go on from what the last view showed.
struct Incremental<'a> {
    scene: FanScene<'a>,
    front: FanFront<Asker<'a>>,
}

impl<'a> Follower<'a> for Incremental<'a> {
    fn restart(&mut self) {
        self.front = FanFront::new(&self.scene);
    }

    fn follow(&mut self, view: View<'a>, log: Option<&'a Log>) -> Changes {
        let update = self.front.update(&self.scene, &Asker { screen: view.screen, log }, usize::MAX);
        Changes { split_count: update.split_count, collapse_count: update.collapse_count }
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        self.front.instance().indices_into(self.scene.fans(), out);
    }

    fn instance_bytes(&self) -> usize {
        self.front.bytes()
    }
}

/// The same with all triangles kept from frame to frame, so that emission writes only those that change.
struct Kept<'a> {
    followed: Incremental<'a>,
    triangles: FanTriangles,
    refinable: &'a RefinableMesh,
}

impl<'a> Kept<'a> {
    fn new(scene: FanScene<'a>, refinable: &'a RefinableMesh) -> Self {
        let followed = Incremental { scene, front: FanFront::new(&scene) };
        let triangles = FanTriangles::new(scene.fans(), followed.front.instance());
        Self { followed, triangles, refinable }
    }
}

impl<'a> Follower<'a> for Kept<'a> {
    fn restart(&mut self) {
        *self = Self::new(self.followed.scene, self.refinable);
    }

    fn follow(&mut self, view: View<'a>, log: Option<&'a Log>) -> Changes {
        self.followed.follow(view, log)
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        let (fans, shown) = (self.followed.scene.fans(), self.followed.front.instance());
        self.triangles.follow(fans, &self.refinable.sequence, shown);
        for group in 0..fans.group_count() {
            out.extend_from_slice(self.triangles.triangles(group).as_flattened());
        }
    }

    fn instance_bytes(&self) -> usize {
        self.followed.instance_bytes() + self.triangles.bytes()
    }
}

/// Fans that know nothing but their bits, and begin at the base in each frame.
struct Stateless<'a> {
    scene: FanScene<'a>,
    instance: FanInstance,
}

impl<'a> Follower<'a> for Stateless<'a> {
    fn restart(&mut self) {
        self.instance = FanInstance::uniform(self.scene.fans(), 0);
    }

    fn follow(&mut self, view: View<'a>, log: Option<&'a Log>) -> Changes {
        let split_count = self.instance.refine(&self.scene, &Asker { screen: view.screen, log });
        Changes { split_count, collapse_count: 0 }
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        self.instance.indices_into(self.scene.fans(), out);
    }

    fn instance_bytes(&self) -> usize {
        self.instance.bytes()
    }
}

/// View-dependent progressive meshes.
struct Rival<'a> {
    model: &'a ViewDependentMeshes,
    state: ViewDependentState,
}

impl<'a> Follower<'a> for Rival<'a> {
    fn restart(&mut self) {
        self.state = self.model.base_state();
    }

    fn follow(&mut self, view: View<'a>, log: Option<&'a Log>) -> Changes {
        let adapted = self.model.adapt(&mut self.state, &Asker { screen: view.screen, log });
        Changes { split_count: adapted.split_count, collapse_count: adapted.collapse_count }
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        self.model.indices_into(&self.state, out);
    }

    fn instance_bytes(&self) -> usize {
        self.state.bytes()
    }
}

/// The same table at one level everywhere.
struct Uniform<'a> {
    fans: &'a Fans,
    level: FansLevel,
}

impl<'a> Follower<'a> for Uniform<'a> {
    fn restart(&mut self) {
        self.fans.move_to(&mut self.level, 0);
    }

    fn follow(&mut self, view: View<'a>, _log: Option<&'a Log>) -> Changes {
        let before = self.fans.split_count(&self.level);
        self.fans.move_to(&mut self.level, view.split_count);
        Changes {
            split_count: view.split_count.saturating_sub(before),
            collapse_count: before.saturating_sub(view.split_count),
        }
    }

    fn emit_into(&mut self, out: &mut Vec<u32>) {
        self.fans.indices_into(&self.level, out);
    }

    fn instance_bytes(&self) -> usize {
        self.fans.state_bytes(&self.level)
    }
}
