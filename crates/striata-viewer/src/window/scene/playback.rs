//! Time of an animation.

use striata_scene::{Pose, Poser};

/// The animation that is shown, and its time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::window) struct Playback {
    /// Index of the animation; none for the pose without animation.
    pub animation: Option<usize>,
    /// Seconds from its beginning.
    pub time: f32,
    pub is_playing: bool,
}

impl Playback {
    /// Starts or pauses the animation; the first one if none was chosen. Does nothing without animations.
    pub(in crate::window) fn toggle(&mut self, poser: &Poser) {
        if poser.animation_count() > 0 {
            self.animation.get_or_insert(0);
            self.is_playing ^= true;
        }
    }

    /// Chooses an animation from its beginning.
    pub(in crate::window) fn choose(&mut self, animation: Option<usize>) {
        let is_playing = self.is_playing && animation.is_some();
        *self = Self { animation, time: 0.0, is_playing };
    }

    /// Lets time pass, in seconds, and begins again at the end.
    pub(in crate::window) fn advance(&mut self, secs: f32, poser: &Poser) {
        let Some(animation) = self.animation.filter(|_| self.is_playing) else { return };
        let duration = poser.duration(animation);
        self.time = if duration > 0.0 { (self.time + secs) % duration } else { 0.0 };
    }

    /// The pose at this time.
    pub(super) fn pose(&self, poser: &Poser) -> Pose {
        self.animation.map_or_else(|| poser.rest_pose(), |animation| poser.pose(animation, self.time))
    }
}
