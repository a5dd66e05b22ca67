//! Poses of a whole scene: its animations at evenly spread times.

use striata_io::{Scene, SceneError};

use crate::pose::{Pose, Poser};

/// Number of times at which each animation is examined, and the least number if there are many animations.
const TIMES: usize = 32;
const MIN_TIMES: usize = 2;
/// Largest number of poses of all animations.
const MAX_POSES: usize = 256;
/// Largest number of nodes, summed over all poses; bounds their memory to 128 MB.
const MAX_NODES: usize = 1 << 20;

/// The animations of a scene at evenly spread times, shared by all of its meshes.
#[derive(Clone, Debug)]
pub struct ScenePoses {
    poser: Poser,
    poses: Vec<Pose>,
}

impl ScenePoses {
    /// Evaluates each animation of a scene at 32 times from its beginning to its end. If there are more than
    /// eight animations, or many nodes, there are fewer times or animations.
    ///
    /// # Errors
    /// [`SceneError`] if skins or animations refer to something that does not exist, or their data are
    /// malformed.
    pub fn new(scene: &Scene) -> Result<Self, SceneError> {
        let poser = Poser::new(scene)?;
        let limit = MAX_POSES.min(MAX_NODES / poser.node_count().max(1));
        let animations = poser.animation_count();
        let times = TIMES.min(limit / animations.max(1)).max(MIN_TIMES);
        let examined = animations.min(limit / MIN_TIMES);
        let mut poses = Vec::with_capacity(times * examined);
        for index in 0..examined {
            // Evenly spread over the animations if there are too many of them.
            let animation = index * animations / examined;
            let duration = poser.duration(animation);
            let time = |step: usize| duration * (step as f32 / (times - 1) as f32);
            poses.extend((0..times).map(|step| poser.pose(animation, time(step))));
        }
        Ok(Self { poser, poses })
    }

    /// Evaluates the animations and skins of the scene.
    pub fn poser(&self) -> &Poser {
        &self.poser
    }

    pub(super) fn poses(&self) -> &[Pose] {
        &self.poses
    }
}
