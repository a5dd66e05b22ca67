//! The triangles that are shown, kept up to what is wanted by the model that makes them; nothing here knows a GPU.

mod fans;
mod indices;
mod patterns;
mod wish;

pub(super) use self::indices::{Changes, Form};
pub(super) use self::wish::{Achieved, Wish};

use std::ops::Range;
use std::time::Instant;

use striata::model::{
    FanInstance, FanMorphs, LodModel, LodStripsState, MtsState, PatternInstance, StripBuffer, StripModel,
    fan_triangles_into,
};
use striata::strip::{RESTART, restart_triangles_into};

use self::fans::FansShown;
use self::indices::{list_into, note, patterns_into, strips_into};
use self::patterns::follow_patterns;
use self::wish::{split_count_for, uniform};
use super::args::ShownModel;
use super::subject::Subject;

/// An instance of a model.
#[derive(Debug)]
pub(super) struct Shown {
    instance: Instance,
    /// Of all but LodStrips, whose buffer has its own.
    indices: Vec<u32>,
    groups: Vec<Range<u32>>,
    changes: Changes,
    /// Nothing has been wanted yet.
    is_first: bool,
    achieved: Achieved,
}

#[derive(Debug)]
enum Instance {
    /// Its split count.
    List(Option<usize>),
    LodStrips {
        state: LodStripsState,
        buffer: StripBuffer,
    },
    Mts(MtsState),
    Fans(Box<FansShown>),
    Patterns(Box<PatternInstance>),
}

impl Shown {
    /// An instance of a model; none while the subject lacks the model.
    pub(super) fn new(subject: &Subject, kind: ShownModel) -> Option<Self> {
        let instance = match kind {
            ShownModel::List => Instance::List(None),
            ShownModel::LodStrips => {
                let model = subject.lod_strips()?;
                let mut state = model.new_state();
                let buffer = StripBuffer::new(model, &mut state);
                Instance::LodStrips { state, buffer }
            }
            ShownModel::Mts => Instance::Mts(subject.mts()?.new_state()),
            ShownModel::Fans | ShownModel::FansGpu => {
                let (scene, _) = subject.fan_scene()?;
                Instance::Fans(Box::new(FansShown::new(&scene, kind == ShownModel::Fans)))
            }
            ShownModel::Patterns => {
                Instance::Patterns(Box::new(PatternInstance::base(subject.pattern_scene()?.patterns())))
            }
        };
        let (indices, groups) = (Vec::new(), Vec::new());
        let (changes, achieved) = (Changes::All, Achieved::default());
        Some(Self { instance, indices, groups, changes, is_first: true, achieved })
    }

    /// The model that it is an instance of.
    pub(super) fn kind(&self) -> ShownModel {
        match &self.instance {
            Instance::List(_) => ShownModel::List,
            Instance::LodStrips { .. } => ShownModel::LodStrips,
            Instance::Mts(_) => ShownModel::Mts,
            Instance::Fans(fans) if fans.triangles.is_none() => ShownModel::FansGpu,
            Instance::Fans(_) => ShownModel::Fans,
            Instance::Patterns(_) => ShownModel::Patterns,
        }
    }

    /// What the last wish came to.
    pub(super) fn achieved(&self) -> &Achieved {
        &self.achieved
    }

    /// Whether the next frame differs even if the wish does not.
    pub(super) fn is_moving(&self) -> bool {
        self.achieved.moving_count > 0
    }

    /// Goes to what is wanted; whether the triangles are others then.
    pub(super) fn follow(&mut self, subject: &Subject, wish: &Wish) -> bool {
        let started = Instant::now();
        let split_count = split_count_for(subject, wish);
        let is_first = std::mem::replace(&mut self.is_first, false);
        let out = (&mut self.indices, &mut self.groups);
        let (is_changed, achieved) = match &mut self.instance {
            Instance::List(shown) => {
                let is_changed = *shown != Some(split_count);
                if is_changed {
                    *shown = Some(split_count);
                    list_into(subject, split_count, out);
                }
                (is_changed, uniform(subject, split_count))
            }
            Instance::LodStrips { state, buffer } => {
                let written = subject.lod_strips().map_or(0, |model| {
                    model.move_to(state, split_count);
                    buffer.sync(model, state)
                });
                self.groups.clear();
                self.groups.extend(buffer.group_ranges());
                note(&mut self.changes, buffer.take_changed_ranges());
                (written > 0, uniform(subject, split_count))
            }
            Instance::Mts(state) => {
                let before = state.split_count();
                if let Some(model) = subject.mts().filter(|_| is_first || before != split_count) {
                    model.move_to(state, split_count);
                    strips_into(model, state, out);
                }
                (before != split_count, uniform(subject, split_count))
            }
            Instance::Fans(fans) => {
                let (is_changed, achieved) = fans.follow(subject, wish, split_count);
                if is_changed || is_first {
                    fans.indices_into(out, subject.steps.mesh().groups.len().max(1));
                }
                (is_changed, achieved)
            }
            Instance::Patterns(instance) => {
                let (is_changed, achieved) = follow_patterns(instance, subject, wish, split_count);
                if is_changed || is_first {
                    patterns_into(instance, subject.steps.mesh().groups.len().max(1), out);
                }
                (is_changed, achieved)
            }
        };
        if is_first || (is_changed && self.kind() != ShownModel::LodStrips) {
            self.changes = Changes::All;
        }
        self.achieved = Achieved { secs: started.elapsed().as_secs_f64(), ..achieved };
        is_changed || is_first
    }

    /// The indices.
    pub(super) fn form(&self) -> Form<'_> {
        let indices = match &self.instance {
            Instance::LodStrips { buffer, .. } => buffer.indices(),
            _ => &self.indices,
        };
        let is_strips = matches!(self.instance, Instance::LodStrips { .. } | Instance::Mts(_));
        Form { indices, groups: &self.groups, is_strips }
    }

    /// What has changed of the indices since the last time.
    pub(super) fn take_changes(&mut self) -> Changes {
        std::mem::replace(&mut self.changes, Changes::None)
    }

    /// All triangles, and of each which strip or fan it is of, or which group where there are none.
    pub(super) fn pieces(&self, subject: &Subject) -> (Vec<[u32; 3]>, Vec<u32>) {
        let (mut triangles, mut pieces) = (Vec::new(), Vec::new());
        let mut piece =
            |number: usize, triangles: &Vec<[u32; 3]>| pieces.resize(triangles.len(), number as u32);
        match (&self.instance, subject.fan_scene()) {
            (Instance::Fans(fans), Some((scene, _))) => {
                let mut indices = Vec::new();
                fans.drawn.fans_into(scene.fans(), &mut indices);
                for (number, fan) in indices.split(|&index| index == RESTART).enumerate() {
                    fan_triangles_into(fan, &mut triangles);
                    piece(number, &triangles);
                }
            }
            (Instance::LodStrips { state, .. }, _) => {
                for strip in 0..subject.lod_strips().map_or(0, StripModel::strip_count) {
                    let indices = subject.lod_strips().map_or(&[][..], |model| model.strip(state, strip));
                    restart_triangles_into(indices, &mut triangles);
                    piece(strip, &triangles);
                }
            }
            (Instance::Mts(state), _) => {
                for strip in 0..subject.mts().map_or(0, StripModel::strip_count) {
                    let indices = subject.mts().map_or(&[][..], |model| model.strip(state, strip));
                    restart_triangles_into(indices, &mut triangles);
                    piece(strip, &triangles);
                }
            }
            _ => (triangles, pieces) = self.grouped(subject),
        }
        (triangles, pieces)
    }

    /// All triangles, and of each which group it is of.
    pub(super) fn grouped(&self, subject: &Subject) -> (Vec<[u32; 3]>, Vec<u32>) {
        let (mut triangles, mut numbers) = (Vec::new(), Vec::new());
        if let (Instance::Fans(fans), Some((scene, _))) = (&self.instance, subject.fan_scene()) {
            for group in 0..scene.fans().group_count() {
                let mut indices = Vec::new();
                fans.drawn.group_indices_into(scene.fans(), group, &mut indices);
                triangles.extend_from_slice(indices.as_chunks().0);
                numbers.resize(triangles.len(), group as u32);
            }
            return (triangles, numbers);
        }
        let Form { indices, groups, is_strips } = self.form();
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

    /// What a GPU makes the triangles of, where it does.
    pub(super) fn instance_for_gpu(&self) -> Option<&FanInstance> {
        match &self.instance {
            Instance::Fans(fans) if fans.triangles.is_none() => Some(&fans.drawn),
            _ => None,
        }
    }

    /// How what is drawn moves.
    pub(super) fn morphs(&self) -> Option<&FanMorphs> {
        match &self.instance {
            Instance::Fans(fans) => fans.morphs.as_ref(),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::state::Goal;
    use super::super::subject::tests::subject_of;
    use super::fans::MORPH_FRAMES;
    use super::*;
    use striata::mesh::{canonical_triangles, shapes};
    use striata::view::Camera;

    const FAR: [f32; 3] = [3.0, 4.0, 9.0];

    fn camera(eye: [f32; 3]) -> Camera {
        Camera::new(eye, [0.0; 3], [0.0, 1.0, 0.0], 0.4, [800, 600]).expect("a direction")
    }

    fn wish(goal: Goal) -> Wish {
        Wish { goal, camera: Some(camera(FAR)), morphs: false }
    }

    fn subject_with_all() -> Subject {
        let subject = subject_of(&shapes::two_material_sphere(24, 32));
        ShownModel::ALL.iter().for_each(|&kind| subject.build(kind).expect("collapses do"));
        subject
    }

    #[test]
    fn all_models_show_the_same_triangles_of_a_level() {
        let subject = subject_with_all();
        for kind in ShownModel::ALL {
            let mut shown = Shown::new(&subject, kind).expect("it is built");
            assert_eq!(shown.kind(), kind);
            for detail in [1.0, 0.3, 0.0, 0.6] {
                let is_changed = shown.follow(&subject, &wish(Goal::Detail(detail)));
                assert!(is_changed, "{kind:?} at {detail}");
                assert!(!shown.follow(&subject, &wish(Goal::Detail(detail))), "{kind:?}: nothing new");
                let expected = subject.steps.level(shown.achieved().split_count);
                for (triangles, numbers) in [shown.grouped(&subject), shown.pieces(&subject)] {
                    assert_eq!(triangles.len(), numbers.len());
                    let expected = canonical_triangles(&expected.triangles);
                    assert_eq!(canonical_triangles(&triangles), expected, "{kind:?} at {detail}");
                }
                assert_eq!(shown.achieved().triangle_count, expected.triangle_count());
                let groups: std::collections::BTreeSet<u32> = shown.grouped(&subject).1.into_iter().collect();
                assert_eq!(groups.len(), 2, "{kind:?} tells groups apart");
            }
        }
    }

    #[test]
    fn of_strips_only_what_changed_is_to_be_uploaded() {
        let subject = subject_with_all();
        let mut shown = Shown::new(&subject, ShownModel::LodStrips).expect("it is built");
        shown.follow(&subject, &wish(Goal::Detail(0.5)));
        assert_eq!(shown.take_changes(), Changes::All);
        let mut copy = shown.form().indices.to_vec();
        for detail in [0.505, 0.51, 0.2] {
            shown.follow(&subject, &wish(Goal::Detail(detail)));
            let Changes::Ranges(ranges) = shown.take_changes() else { panic!("ranges at {detail}") };
            for range in ranges {
                let range = range.start as usize..range.end as usize;
                copy[range.clone()].copy_from_slice(&shown.form().indices[range]);
            }
            for range in shown.form().groups {
                let drawn = range.start as usize..range.end as usize;
                let is_same = copy[drawn.clone()] == shown.form().indices[drawn];
                assert!(is_same, "at {detail} a copy that got the ranges draws the same");
            }
        }
        assert_eq!(shown.take_changes(), Changes::None);
    }

    #[test]
    fn views_are_followed_and_budgets_kept() {
        let subject = subject_with_all();
        for kind in [ShownModel::Fans, ShownModel::FansGpu, ShownModel::Patterns] {
            let mut shown = Shown::new(&subject, kind).expect("it is built");
            shown.follow(&subject, &wish(Goal::Pixels(0.5)));
            let fine = *shown.achieved();
            shown.follow(&subject, &wish(Goal::Pixels(20.0)));
            let coarse = *shown.achieved();
            assert!(fine.triangle_count > 2 * coarse.triangle_count, "{kind:?}: {fine:?} {coarse:?}");
            assert!(fine.error < coarse.error && fine.error_px == Some(0.5), "{kind:?}");
            assert_eq!(shown.grouped(&subject).0.len(), coarse.triangle_count);
        }
        let mut shown = Shown::new(&subject, ShownModel::Fans).expect("it is built");
        shown.follow(&subject, &wish(Goal::Budget(300)));
        assert!((200..=300).contains(&shown.achieved().triangle_count), "{:?}", shown.achieved());
    }

    #[test]
    fn a_model_that_cannot_follow_a_view_keeps_its_pixels_everywhere() {
        let subject = subject_with_all();
        let mut shown = Shown::new(&subject, ShownModel::LodStrips).expect("it is built");
        shown.follow(&subject, &wish(Goal::Pixels(2.0)));
        let achieved = *shown.achieved();
        let pixels = camera(FAR).error_px(achieved.error, &subject.sphere);
        assert!(pixels <= 2.0 && achieved.triangle_count < subject.steps.mesh().triangle_count(), "{pixels}");
    }

    #[test]
    fn a_motion_ends_where_a_jump_would_have_gone() {
        let subject = subject_with_all();
        let mut jumping = Shown::new(&subject, ShownModel::Fans).expect("it is built");
        let mut moving = Shown::new(&subject, ShownModel::Fans).expect("it is built");
        for goal in [Goal::Pixels(2.0), Goal::Detail(0.1)] {
            jumping.follow(&subject, &wish(goal));
            let morphing = Wish { morphs: true, ..wish(goal) };
            assert!(moving.follow(&subject, &morphing) && moving.is_moving(), "{goal:?}");
            let mut frames = 0;
            while moving.is_moving() && frames < 1000 {
                assert!(moving.follow(&subject, &morphing), "every frame of a motion is another picture");
                frames += 1;
            }
            assert!((10..=usize::from(MORPH_FRAMES)).contains(&frames), "{frames}");
            let [a, b] = [&jumping, &moving].map(|shown| canonical_triangles(&shown.grouped(&subject).0));
            assert_eq!(a, b, "{goal:?}");
        }
    }
}
