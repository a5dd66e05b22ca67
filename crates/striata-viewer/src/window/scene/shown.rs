//! A scene as a frame shows it: the triangles and the place of each instance.

use std::time::Instant;

use striata::Target;
use striata::mesh::Bounds;
use striata::view::{Camera, ScreenError};
use striata_scene::drawn::{DrawnInstance, Light, lights};
use striata_scene::{Pose, SceneView, ShownIndices};

use super::playback::Playback;
use super::subject::SceneSubject;
use crate::window::instance::AchievedLevel;
use crate::window::state::Goal;

/// Smallest tolerance for a triangle limit, pixels: nobody would see smaller errors.
const MIN_PIXELS: f32 = 0.05;

/// A request for a level and a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::window) struct SceneRequest {
    pub goal: Goal,
    /// Camera for view-dependent levels; none if there is no picture.
    pub camera: Option<Camera>,
    /// Animation and time in seconds.
    pub pose: (Option<usize>, f32),
    /// Increases when nodes are hidden or shown.
    pub hiding: u64,
}

/// A scene as the last request shows it.
#[derive(Debug)]
pub(in crate::window) struct ShownScene {
    view: SceneView,
    pose: Pose,
    drawn: Vec<DrawnInstance>,
    lights: Vec<Light>,
    /// Rows of the tree that the user has hidden.
    hidden_rows: Vec<bool>,
    /// Rows of the tree whose descendants are not listed.
    pub folded_rows: Vec<bool>,
    hiding: u64,
    achieved: AchievedLevel,
    /// Goal and camera of the triangles, unless they follow the pose.
    last_goal: Option<(Goal, u64)>,
    last_pose: Option<(Option<usize>, f32)>,
}

impl ShownScene {
    /// Shows the base level without animation.
    pub(in crate::window) fn new(subject: &SceneSubject) -> Self {
        let pose = subject.poser.rest_pose();
        let scene = subject.lods.scene();
        Self {
            view: subject.lods.view(),
            drawn: subject.poser.instances(scene, &pose),
            lights: lights(scene, &pose),
            pose,
            hidden_rows: vec![false; subject.rows.len()],
            folded_rows: vec![false; subject.rows.len()],
            hiding: 0,
            achieved: AchievedLevel::default(),
            last_goal: None,
            last_pose: None,
        }
    }

    /// The level reached by the last request.
    pub(in crate::window) fn achieved(&self) -> &AchievedLevel {
        &self.achieved
    }

    /// Changes with each node that is hidden or shown.
    pub(in crate::window) fn hiding(&self) -> u64 {
        self.hiding
    }

    /// Moves to the requested pose and level.
    pub(in crate::window) fn follow(&mut self, subject: &SceneSubject, request: &SceneRequest) {
        let started = Instant::now();
        if self.last_pose != Some(request.pose) {
            let (animation, time) = request.pose;
            self.pose = Playback { animation, time, is_playing: false }.pose(&subject.poser);
            self.drawn = subject.poser.instances(subject.lods.scene(), &self.pose);
            self.lights = lights(subject.lods.scene(), &self.pose);
            self.last_pose = Some(request.pose);
        }
        self.follow_level(subject, request);
        self.achieved.triangle_count = self.view.triangle_count();
        self.achieved.secs = started.elapsed().as_secs_f64();
    }

    fn follow_level(&mut self, subject: &SceneSubject, request: &SceneRequest) {
        let tolerance = |pixels| Some(ScreenError::new(request.camera?, pixels));
        let target = match request.goal {
            Goal::Detail(detail) => Target::Detail(detail),
            Goal::Triangles(count) => Target::Triangles(count),
            Goal::Pixels(pixels) => match tolerance(pixels) {
                Some(error) => {
                    self.view.update(&error, &self.drawn);
                    return self.reached_view(pixels);
                }
                None => Target::Detail(1.0),
            },
            Goal::Budget(count) => match tolerance(MIN_PIXELS) {
                Some(error) => {
                    let factor = self.view.update_to_budget(&error, &self.drawn, count);
                    return self.reached_view(factor * MIN_PIXELS);
                }
                None => Target::Triangles(count),
            },
        };
        let wanted = (request.goal, request.hiding);
        if self.last_goal == Some(wanted) {
            return;
        }
        let level = subject.lods.level(target);
        self.view.show_level(&level);
        self.achieved.split_count = level.split_counts.iter().sum();
        (self.achieved.error, self.achieved.error_px) = (level.error as f32, None);
        self.last_goal = Some(wanted);
    }

    fn reached_view(&mut self, pixels: f32) {
        (self.achieved.error, self.achieved.error_px) = (0.0, Some(pixels));
        self.last_goal = None;
    }

    /// Number of instances.
    pub(super) fn instance_count(&self) -> usize {
        self.drawn.len()
    }

    /// Place and triangles of an instance; none if it is hidden or has no triangles.
    pub(super) fn instance(&self, index: usize) -> Option<(&DrawnInstance, ShownIndices<'_>)> {
        if self.view.is_hidden(index) {
            return None;
        }
        Some((self.drawn.get(index)?, self.view.shown(index)?))
    }

    /// Positions of the vertices of an instance in the current pose.
    pub(super) fn positions_of(&self, subject: &SceneSubject, index: usize) -> Option<Vec<[f32; 3]>> {
        let instance = subject.lods.scene().instances().get(index)?;
        let mesh = subject.lods.lods()[instance.mesh].as_ref()?.mesh();
        Some(subject.poser.positions(&self.pose, instance, mesh))
    }

    /// Number of triangles that an instance would show if it were not hidden.
    pub(super) fn triangles_of(&self, index: usize) -> usize {
        self.view.shown(index).map_or(0, |shown| shown.indices.len() / 3)
    }

    /// Lights in the current pose.
    pub(super) fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// Whether the user has hidden a row of the tree.
    pub(in crate::window) fn is_hidden(&self, row: usize) -> bool {
        self.hidden_rows.get(row).is_some_and(|&is_hidden| is_hidden)
    }

    /// Hides or shows a row of the tree with everything below it.
    pub(in crate::window) fn set_hidden(&mut self, subject: &SceneSubject, row: usize, is_hidden: bool) {
        let Some(slot) = self.hidden_rows.get_mut(row) else { return };
        *slot = is_hidden;
        self.hiding += 1;
        let mut hidden_until = 0;
        for (index, row) in subject.rows.iter().enumerate() {
            if self.hidden_rows[index] {
                hidden_until = hidden_until.max(row.end);
            }
            for &instance in &row.instances {
                self.view.set_hidden(instance, index < hidden_until);
            }
        }
    }

    /// Returns the box around a row of the tree in the current pose.
    pub(in crate::window) fn bounds_of(&self, subject: &SceneSubject, row: usize) -> Option<Bounds> {
        let end = subject.rows.get(row)?.end;
        let instances = subject.rows[row..end].iter().flat_map(|row| row.instances.iter().copied());
        subject.bounds_in(&self.pose, instances)
    }
}
