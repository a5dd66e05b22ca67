//! Keeps the triangles of the shown level up to date with the request; independent of any GPU.

mod draw_indices;
mod fans;
mod level_request;
mod live_strips;
mod patterns;

pub(super) use self::draw_indices::{Changes, DrawIndices};
pub(super) use self::level_request::{AchievedLevel, LevelRequest};

use std::ops::Range;
use std::time::Instant;

use striata::model::{
    FanInstance, FanMorphs, LodModel, LodStripsState, MtsState, PatternInstance, StripBuffer, StripModel,
    fan_triangles_into,
};
use striata::strip::{RESTART, restart_triangles_into};

use self::draw_indices::{add_ranges, list_into, patterns_into, strips_into};
use self::fans::ShownFans;
use self::level_request::{split_count_for, uniform};
use self::live_strips::ShownLiveStrips;
use self::patterns::follow_patterns;
use super::args::ShownModel;
use super::mesh_subject::MeshSubject;

/// An instance of the chosen model at the shown level.
#[derive(Debug)]
pub(super) struct ModelInstance {
    state: InstanceState,
    /// Indices of every model except LodStrips and live strips, which have buffers of their own.
    indices: Vec<u32>,
    groups: Vec<Range<u32>>,
    changes: Changes,
    /// Whether no level has been requested yet.
    is_first: bool,
    achieved: AchievedLevel,
}

/// Per-model state of an instance.
#[derive(Debug)]
enum InstanceState {
    /// Split count of the list.
    List(Option<usize>),
    LodStrips {
        state: LodStripsState,
        buffer: StripBuffer,
    },
    LiveStrips(Box<ShownLiveStrips>),
    Mts(MtsState),
    Fans(Box<ShownFans>),
    Patterns(Box<PatternInstance>),
}

impl ModelInstance {
    /// Creates an instance; none if the subject does not contain the model yet.
    pub(super) fn new(subject: &MeshSubject, kind: ShownModel) -> Option<Self> {
        let state = match kind {
            ShownModel::List => InstanceState::List(None),
            ShownModel::LodStrips => {
                let model = subject.lod_strips()?;
                let mut state = model.new_state();
                let buffer = StripBuffer::new(model, &mut state);
                InstanceState::LodStrips { state, buffer }
            }
            ShownModel::LiveStrips => {
                InstanceState::LiveStrips(Box::new(ShownLiveStrips::new(subject.live_strips()?)))
            }
            ShownModel::Mts => InstanceState::Mts(subject.mts()?.new_state()),
            ShownModel::Fans | ShownModel::FansGpu => {
                let scene = subject.fan_scene()?;
                InstanceState::Fans(Box::new(ShownFans::new(&scene, kind == ShownModel::Fans)))
            }
            ShownModel::Patterns => {
                InstanceState::Patterns(Box::new(PatternInstance::base(subject.pattern_scene()?.patterns())))
            }
        };
        let (indices, groups) = (Vec::new(), Vec::new());
        let (changes, achieved) = (Changes::All, AchievedLevel::default());
        Some(Self { state, indices, groups, changes, is_first: true, achieved })
    }

    /// The model of this instance.
    pub(super) fn kind(&self) -> ShownModel {
        match &self.state {
            InstanceState::List(_) => ShownModel::List,
            InstanceState::LodStrips { .. } => ShownModel::LodStrips,
            InstanceState::LiveStrips(_) => ShownModel::LiveStrips,
            InstanceState::Mts(_) => ShownModel::Mts,
            InstanceState::Fans(fans) if fans.triangles.is_none() => ShownModel::FansGpu,
            InstanceState::Fans(_) => ShownModel::Fans,
            InstanceState::Patterns(_) => ShownModel::Patterns,
        }
    }

    /// The level reached by the last request.
    pub(super) fn achieved(&self) -> &AchievedLevel {
        &self.achieved
    }

    /// Whether the next frame differs even if the request does not.
    pub(super) fn is_moving(&self) -> bool {
        self.achieved.moving_count > 0
    }

    /// Moves to the requested level; returns whether the triangles have changed.
    pub(super) fn follow(&mut self, subject: &MeshSubject, request: &LevelRequest) -> bool {
        let started = Instant::now();
        let split_count = split_count_for(subject, request);
        let is_first = std::mem::replace(&mut self.is_first, false);
        let (indices, groups) = (&mut self.indices, &mut self.groups);
        let (is_changed, achieved) = match &mut self.state {
            InstanceState::List(current) => {
                let is_changed = *current != Some(split_count);
                if is_changed {
                    *current = Some(split_count);
                    list_into(subject, split_count, indices, groups);
                }
                (is_changed, uniform(subject, split_count))
            }
            InstanceState::LodStrips { state, buffer } => {
                let written = subject.lod_strips().map_or(0, |model| {
                    model.move_to(state, split_count);
                    buffer.sync(model, state)
                });
                self.groups.clear();
                self.groups.extend(buffer.group_ranges());
                add_ranges(&mut self.changes, buffer.take_changed_ranges());
                (written > 0, uniform(subject, split_count))
            }
            InstanceState::LiveStrips(live) => {
                let is_changed = live.follow(split_count);
                let shown = live.split_count();
                self.groups.clear();
                self.groups.extend(live.group_ranges());
                add_ranges(&mut self.changes, live.take_changed_ranges());
                let moving_count = shown.abs_diff(split_count);
                (is_changed, AchievedLevel { moving_count, ..uniform(subject, shown) })
            }
            InstanceState::Mts(state) => {
                let before = state.split_count();
                if let Some(model) = subject.mts().filter(|_| is_first || before != split_count) {
                    model.move_to(state, split_count);
                    strips_into(model, state, indices, groups);
                }
                (before != split_count, uniform(subject, split_count))
            }
            InstanceState::Fans(fans) => {
                let (is_changed, achieved) = fans.follow(subject, request, split_count);
                if is_changed || is_first {
                    fans.indices_into(indices, groups);
                }
                (is_changed, achieved)
            }
            InstanceState::Patterns(instance) => {
                let (is_changed, achieved) = follow_patterns(instance, subject, request, split_count);
                if is_changed || is_first {
                    patterns_into(instance, subject.steps.mesh().groups.len().max(1), indices, groups);
                }
                (is_changed, achieved)
            }
        };
        let has_ranges = matches!(self.kind(), ShownModel::LodStrips | ShownModel::LiveStrips);
        if is_first || (is_changed && !has_ranges) {
            self.changes = Changes::All;
        }
        self.achieved = AchievedLevel { secs: started.elapsed().as_secs_f64(), ..achieved };
        is_changed || is_first
    }

    /// The indices to draw.
    pub(super) fn draw_indices(&self) -> DrawIndices<'_> {
        let indices = match &self.state {
            InstanceState::LodStrips { buffer, .. } => buffer.indices(),
            InstanceState::LiveStrips(live) => live.indices(),
            _ => &self.indices,
        };
        let is_strips = matches!(
            self.state,
            InstanceState::LodStrips { .. } | InstanceState::LiveStrips(_) | InstanceState::Mts(_)
        );
        DrawIndices { indices, groups: &self.groups, is_strips }
    }

    /// Takes the changes of the indices since the last call.
    pub(super) fn take_changes(&mut self) -> Changes {
        std::mem::replace(&mut self.changes, Changes::None)
    }

    /// All triangles, with the number of the strip or fan of each, or of the group if the model has neither.
    pub(super) fn by_primitive(&self, subject: &MeshSubject) -> (Vec<[u32; 3]>, Vec<u32>) {
        let (mut triangles, mut numbers) = (Vec::new(), Vec::new());
        let mut push =
            |number: usize, triangles: &Vec<[u32; 3]>| numbers.resize(triangles.len(), number as u32);
        match (&self.state, subject.fan_scene()) {
            (InstanceState::Fans(fans), Some(scene)) => {
                let mut indices = Vec::new();
                fans.drawn.fans_into(scene.fans(), &mut indices);
                for (number, fan) in indices.split(|&index| index == RESTART).enumerate() {
                    fan_triangles_into(fan, &mut triangles);
                    push(number, &triangles);
                }
            }
            (InstanceState::LodStrips { state, .. }, _) => {
                for strip in 0..subject.lod_strips().map_or(0, StripModel::strip_count) {
                    let indices = subject.lod_strips().map_or(&[][..], |model| model.strip(state, strip));
                    restart_triangles_into(indices, &mut triangles);
                    push(strip, &triangles);
                }
            }
            (InstanceState::LiveStrips(live), _) => {
                for (number, strip) in live.numbered_strips() {
                    restart_triangles_into(strip, &mut triangles);
                    push(number, &triangles);
                }
            }
            (InstanceState::Mts(state), _) => {
                for strip in 0..subject.mts().map_or(0, StripModel::strip_count) {
                    let indices = subject.mts().map_or(&[][..], |model| model.strip(state, strip));
                    restart_triangles_into(indices, &mut triangles);
                    push(strip, &triangles);
                }
            }
            _ => (triangles, numbers) = self.by_group(subject),
        }
        (triangles, numbers)
    }

    /// All triangles, with the group of each.
    pub(super) fn by_group(&self, subject: &MeshSubject) -> (Vec<[u32; 3]>, Vec<u32>) {
        let (mut triangles, mut numbers) = (Vec::new(), Vec::new());
        if let (InstanceState::Fans(fans), Some(scene)) = (&self.state, subject.fan_scene()) {
            for group in 0..scene.fans().group_count() {
                let mut indices = Vec::new();
                fans.drawn.group_indices_into(scene.fans(), group, &mut indices);
                triangles.extend_from_slice(indices.as_chunks().0);
                numbers.resize(triangles.len(), group as u32);
            }
            return (triangles, numbers);
        }
        let DrawIndices { indices, groups, is_strips } = self.draw_indices();
        for (group, range) in groups.iter().enumerate() {
            let indices = &indices[range.start as usize..range.end as usize];
            if is_strips {
                restart_triangles_into(indices, &mut triangles);
            } else {
                triangles.extend_from_slice(indices.as_chunks().0);
            }
            numbers.resize(triangles.len(), group as u32);
        }
        (triangles, numbers)
    }

    /// The fan instance whose triangles the GPU extracts, if it does.
    pub(super) fn instance_for_gpu(&self) -> Option<&FanInstance> {
        match &self.state {
            InstanceState::Fans(fans) if fans.triangles.is_none() => Some(&fans.drawn),
            _ => None,
        }
    }

    /// The geomorphs in progress, if any.
    pub(super) fn morphs(&self) -> Option<&FanMorphs> {
        match &self.state {
            InstanceState::Fans(fans) => fans.morphs.as_ref(),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::mesh_subject::tests::subject_of;
    use super::super::state::Goal;
    use super::fans::MORPH_FRAMES;
    use super::*;
    use striata::mesh::{canonical_triangles, shapes};
    use striata::view::Camera;

    const FAR: [f32; 3] = [3.0, 4.0, 9.0];

    fn camera(eye: [f32; 3]) -> Camera {
        Camera::new(eye, [0.0; 3], [0.0, 1.0, 0.0], 0.4, [800, 600]).expect("a direction")
    }

    fn request(goal: Goal) -> LevelRequest {
        LevelRequest { goal, camera: Some(camera(FAR)), morphs: false }
    }

    /// Follows a request until nothing moves any more. Returns whether the triangles have changed.
    fn settle(instance: &mut ModelInstance, subject: &MeshSubject, request: &LevelRequest) -> bool {
        let mut is_changed = instance.follow(subject, request);
        while instance.is_moving() {
            is_changed |= instance.follow(subject, request);
        }
        is_changed
    }

    fn subject_with_all() -> MeshSubject {
        let subject = subject_of(&shapes::two_material_sphere(24, 32));
        ShownModel::ALL.iter().for_each(|&kind| subject.build(kind).expect("collapses do"));
        subject
    }

    #[test]
    fn all_models_show_the_same_triangles_of_a_level() {
        let subject = subject_with_all();
        for kind in ShownModel::ALL {
            let mut instance = ModelInstance::new(&subject, kind).expect("the model is built");
            assert_eq!(instance.kind(), kind);
            for detail in [1.0, 0.3, 0.0, 0.6] {
                let is_changed = settle(&mut instance, &subject, &request(Goal::Detail(detail)));
                assert!(is_changed, "{kind:?} at {detail}");
                assert!(!instance.follow(&subject, &request(Goal::Detail(detail))), "{kind:?}: nothing new");
                let expected = subject.steps.level(instance.achieved().split_count);
                for (triangles, numbers) in [instance.by_group(&subject), instance.by_primitive(&subject)] {
                    assert_eq!(triangles.len(), numbers.len());
                    let expected = canonical_triangles(&expected.triangles);
                    assert_eq!(canonical_triangles(&triangles), expected, "{kind:?} at {detail}");
                }
                assert_eq!(instance.achieved().triangle_count, expected.triangle_count());
                let groups: std::collections::BTreeSet<u32> =
                    instance.by_group(&subject).1.into_iter().collect();
                assert_eq!(groups.len(), 2, "{kind:?} tells groups apart");
            }
        }
    }

    #[test]
    fn only_changed_strip_indices_are_uploaded() {
        let subject = subject_with_all();
        for kind in [ShownModel::LodStrips, ShownModel::LiveStrips] {
            let mut instance = ModelInstance::new(&subject, kind).expect("the model is built");
            settle(&mut instance, &subject, &request(Goal::Detail(0.5)));
            assert_eq!(instance.take_changes(), Changes::All);
            let mut copy = instance.draw_indices().indices.to_vec();
            for detail in [0.505, 0.51, 0.2] {
                settle(&mut instance, &subject, &request(Goal::Detail(detail)));
                let Changes::Ranges(ranges) = instance.take_changes() else { panic!("ranges at {detail}") };
                for range in ranges {
                    let range = range.start as usize..range.end as usize;
                    copy.resize(instance.draw_indices().indices.len(), 0);
                    copy[range.clone()].copy_from_slice(&instance.draw_indices().indices[range]);
                }
                for range in instance.draw_indices().groups {
                    let drawn = range.start as usize..range.end as usize;
                    let is_same = copy[drawn.clone()] == instance.draw_indices().indices[drawn];
                    assert!(is_same, "{kind:?} at {detail}: a copy that got the ranges draws the same");
                }
            }
            assert_eq!(instance.take_changes(), Changes::None);
        }
    }

    #[test]
    fn a_long_way_of_live_strips_is_spread_over_frames() {
        let subject = subject_of(&shapes::terrain(160, 3));
        subject.build(ShownModel::LiveStrips).expect("collapses do");
        let mut instance = ModelInstance::new(&subject, ShownModel::LiveStrips).expect("the model is built");
        let base = request(Goal::Detail(0.0));
        let mut frame_count = 0;
        let mut triangle_counts = vec![subject.steps.mesh().triangle_count()];
        loop {
            assert!(instance.follow(&subject, &base));
            triangle_counts.push(instance.achieved().triangle_count);
            frame_count += 1;
            if !instance.is_moving() {
                break;
            }
        }
        assert!(frame_count > 2, "{frame_count} frames");
        assert!(triangle_counts.is_sorted_by(|a, b| a > b), "{triangle_counts:?}");
        assert_eq!(instance.achieved().split_count, 0);
    }

    #[test]
    fn views_are_followed_and_budgets_respected() {
        let subject = subject_with_all();
        for kind in [ShownModel::Fans, ShownModel::FansGpu, ShownModel::Patterns] {
            let mut instance = ModelInstance::new(&subject, kind).expect("the model is built");
            instance.follow(&subject, &request(Goal::Pixels(0.5)));
            let fine = *instance.achieved();
            instance.follow(&subject, &request(Goal::Pixels(20.0)));
            let coarse = *instance.achieved();
            assert!(fine.triangle_count > 2 * coarse.triangle_count, "{kind:?}: {fine:?} {coarse:?}");
            assert!(fine.error < coarse.error && fine.error_px == Some(0.5), "{kind:?}");
            assert_eq!(instance.by_group(&subject).0.len(), coarse.triangle_count);
        }
        let mut instance = ModelInstance::new(&subject, ShownModel::Fans).expect("the model is built");
        instance.follow(&subject, &request(Goal::Budget(300)));
        assert!((200..=300).contains(&instance.achieved().triangle_count), "{:?}", instance.achieved());
    }

    #[test]
    fn models_without_views_respect_the_screen_error_everywhere() {
        let subject = subject_with_all();
        let mut instance = ModelInstance::new(&subject, ShownModel::LodStrips).expect("the model is built");
        instance.follow(&subject, &request(Goal::Pixels(2.0)));
        let achieved = *instance.achieved();
        let pixels = camera(FAR).error_px(achieved.error, &subject.sphere);
        assert!(pixels <= 2.0 && achieved.triangle_count < subject.steps.mesh().triangle_count(), "{pixels}");
    }

    #[test]
    fn geomorphs_end_at_the_requested_level() {
        let subject = subject_with_all();
        let mut jumping = ModelInstance::new(&subject, ShownModel::Fans).expect("the model is built");
        let mut moving = ModelInstance::new(&subject, ShownModel::Fans).expect("the model is built");
        for goal in [Goal::Pixels(2.0), Goal::Detail(0.1)] {
            jumping.follow(&subject, &request(goal));
            let morphing = LevelRequest { morphs: true, ..request(goal) };
            assert!(moving.follow(&subject, &morphing) && moving.is_moving(), "{goal:?}");
            let mut frames = 0;
            while moving.is_moving() && frames < 1000 {
                assert!(moving.follow(&subject, &morphing), "every frame of a geomorph differs");
                frames += 1;
            }
            assert!((10..=usize::from(MORPH_FRAMES)).contains(&frames), "{frames}");
            let [a, b] =
                [&jumping, &moving].map(|instance| canonical_triangles(&instance.by_group(&subject).0));
            assert_eq!(a, b, "{goal:?}");
        }
    }
}
