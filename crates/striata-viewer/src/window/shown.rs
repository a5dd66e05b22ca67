//! The triangles that are shown, kept up to what is wanted by the model that makes them; nothing here knows a GPU.

use std::ops::Range;
use std::time::Instant;

use striata::model::{
    FanFront, FanInstance, FanMorphs, FanTriangles, LodModel, LodStripsState, MtsState, Overlap,
    PatternChange, PatternInstance, StripBuffer, StripModel, fan_triangles_into,
};
use striata::strip::{RESTART, restart_triangles_into};
use striata::view::{Camera, Criterion, ScreenError};

use super::args::ShownModel;
use super::state::Goal;
use super::subject::Subject;

/// Errors of fewer pixels than this are no smaller to a budget, so that what weighs them stays a number.
const LEAST_PIXELS: f32 = 1e-6;

/// Frames that a motion takes.
const MORPH_FRAMES: u16 = 24;

/// What a level is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wish {
    pub(super) goal: Goal,
    /// The view that it is for, where the level depends on it; none where there is no picture, either.
    pub(super) camera: Option<Camera>,
    /// Whether changes are motions.
    pub(super) morphs: bool,
}

/// What a level is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Achieved {
    /// Steps that are undone.
    pub(super) split_count: usize,
    pub(super) triangle_count: usize,
    /// Mesh units.
    pub(super) error: f32,
    /// The same on the screen, where the level was made for a view.
    pub(super) error_px: Option<f32>,
    /// Steps that move.
    pub(super) moving_count: usize,
    /// Time that it took.
    pub(super) secs: f64,
}

/// Which indices are to be uploaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Changes {
    /// As they are.
    None,
    /// These.
    Ranges(Vec<Range<u32>>),
    /// Any.
    All,
}

/// Indices as they are drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form<'a> {
    pub(super) indices: &'a [u32],
    /// A range for each group.
    pub(super) groups: &'a [Range<u32>],
    /// Strips with restarts between them, or three indices a triangle.
    pub(super) is_strips: bool,
}

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

#[derive(Debug)]
struct FansShown {
    front: FanFront<ScreenError>,
    /// Where a level is the same everywhere; its split count.
    uniform: Option<(usize, FanInstance)>,
    /// The instance that is drawn: what is wanted, and what is still on its way out.
    drawn: FanInstance,
    /// Its triangles, where they are not made on the GPU.
    triangles: Option<FanTriangles>,
    morphs: Option<FanMorphs>,
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
                let front = FanFront::new(&scene);
                let drawn = front.instance().clone();
                let triangles = (kind == ShownModel::Fans).then(|| FanTriangles::new(scene.fans(), &drawn));
                Instance::Fans(Box::new(FansShown { front, uniform: None, drawn, triangles, morphs: None }))
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

impl FansShown {
    /// Whether anything changed, and what came of it.
    fn follow(&mut self, subject: &Subject, wish: &Wish, split_count: usize) -> (bool, Achieved) {
        let Some((scene, refinable)) = subject.fan_scene() else { return (false, Achieved::default()) };
        let mut error_px = None;
        match (wish.goal, wish.camera) {
            (Goal::Pixels(pixels), Some(camera)) => {
                self.uniform = None;
                let criterion = ScreenError::new(camera, pixels).of_model(subject.sphere);
                self.front.update(&scene, &criterion, usize::MAX);
                error_px = Some(pixels);
            }
            (Goal::Budget(limit), Some(camera)) => {
                self.uniform = None;
                let criterion = ScreenError::new(camera, LEAST_PIXELS).of_model(subject.sphere);
                let update = self.front.update_to_budget(&scene, &criterion, limit);
                error_px = Some(criterion.pixels() * update.threshold).filter(|pixels| pixels.is_finite());
            }
            _ if self.uniform.as_ref().is_none_or(|(shown, _)| *shown != split_count) => {
                self.uniform = Some((split_count, FanInstance::uniform(scene.fans(), split_count)));
            }
            _ => {}
        }
        let wanted = self.uniform.as_ref().map_or(self.front.instance(), |(_, instance)| instance);
        let was_moving = self.morphs.as_ref().is_some_and(|morphs| morphs.moving_count() > 0);
        if wish.morphs {
            let morphs = self.morphs.get_or_insert_with(|| FanMorphs::new(&self.drawn, MORPH_FRAMES));
            morphs.advance(scene.fans(), wanted);
        } else {
            self.morphs = None;
        }
        let drawn = self.morphs.as_ref().map_or(wanted, FanMorphs::drawn);
        let is_changed = self.drawn != *drawn;
        if is_changed {
            self.drawn.clone_from(drawn);
            if let Some(triangles) = &mut self.triangles {
                triangles.follow(scene.fans(), &refinable.sequence, drawn);
            }
        }
        let levels = refinable.sequence.levels();
        let coarsest = (0..levels.step_count()).find(|&step| !wanted.is_refined(step as u32));
        let moving_count = self.morphs.as_ref().map_or(0, FanMorphs::moving_count);
        let achieved = Achieved {
            split_count: wanted.split_count(),
            triangle_count: match self.uniform {
                Some((split_count, _)) => levels.triangle_count_at(split_count),
                None => self.front.triangle_count(),
            },
            error: coarsest.map_or(0.0, |step| levels.error_at(step)),
            error_px,
            moving_count,
            secs: 0.0,
        };
        (is_changed || was_moving || moving_count > 0, achieved)
    }

    /// The triangles, where they are not made on the GPU.
    fn indices_into(&self, (indices, groups): (&mut Vec<u32>, &mut Vec<Range<u32>>), group_count: usize) {
        let Some(triangles) = &self.triangles else { return };
        indices.clear();
        ranges_of_groups(group_count, groups, |group| {
            indices.extend_from_slice(triangles.triangles(group).as_flattened());
            indices.len()
        });
    }
}

/// The level that a wish comes to where all of a mesh has the same.
fn split_count_for(subject: &Subject, wish: &Wish) -> usize {
    let levels = subject.steps.levels();
    match wish.goal {
        Goal::Detail(detail) => levels.split_count_for_detail(detail),
        Goal::Triangles(count) | Goal::Budget(count) => levels.split_count_for_triangles(count),
        Goal::Pixels(pixels) => {
            let unit_px = wish.camera.map_or(f32::INFINITY, |camera| camera.error_px(1.0, &subject.sphere));
            levels.split_count_for_error(f64::from(pixels / unit_px))
        }
    }
}

/// What a level is that is the same everywhere.
fn uniform(subject: &Subject, split_count: usize) -> Achieved {
    let levels = subject.steps.levels();
    Achieved {
        split_count,
        triangle_count: levels.triangle_count_at(split_count),
        error: levels.error_at(split_count),
        ..Achieved::default()
    }
}

/// Whether anything changed, and what came of it.
fn follow_patterns(
    instance: &mut PatternInstance,
    subject: &Subject,
    wish: &Wish,
    split_count: usize,
) -> (bool, Achieved) {
    let Some(scene) = subject.pattern_scene() else { return (false, Achieved::default()) };
    let patterns = scene.patterns();
    let (Goal::Pixels(pixels), Some(camera)) = (wish.goal, wish.camera) else {
        let first_left_out = split_count as u32;
        let change = instance.adapt(patterns, &|overlap: Overlap| overlap.upper < first_left_out);
        return (change != PatternChange::default(), uniform(subject, split_count));
    };
    let criterion = ScreenError::new(camera, pixels);
    let is_wanted = |overlap: Overlap| criterion.weigh(&scene.part(overlap.upper)).is_wanted();
    let change = instance.adapt(patterns, &is_wanted);
    let mut left_out = (0..patterns.fragment_count() as u32).filter(|&step| !instance.is_refined(step));
    let achieved = Achieved {
        split_count: instance.split_count(),
        triangle_count: instance.triangle_count(),
        error: left_out.next().map_or(0.0, |step| scene.part(step).error),
        error_px: Some(pixels),
        ..Achieved::default()
    };
    (change != PatternChange::default(), achieved)
}

/// The triangles of patterns, group by group.
fn patterns_into(
    instance: &PatternInstance,
    group_count: usize,
    (indices, groups): (&mut Vec<u32>, &mut Vec<Range<u32>>),
) {
    let mut triangles = Vec::with_capacity(instance.triangle_count());
    ranges_of_groups(group_count, groups, |group| {
        instance.group_triangles_into(group as u32, &mut triangles);
        3 * triangles.len()
    });
    indices.clear();
    indices.extend_from_slice(triangles.as_flattened());
}

/// A level's triangles by plain substitution.
fn list_into(
    subject: &Subject,
    split_count: usize,
    (indices, groups): (&mut Vec<u32>, &mut Vec<Range<u32>>),
) {
    let level = subject.steps.level(split_count);
    indices.clear();
    indices.extend_from_slice(level.triangles.as_flattened());
    groups.clear();
    groups.extend(level.groups_or_whole().iter().map(|group| {
        let range = group.range();
        3 * range.start as u32..3 * range.end as u32
    }));
}

/// All strips with restarts between them, group by group.
fn strips_into<M: StripModel>(
    model: &M,
    state: &M::State,
    (indices, groups): (&mut Vec<u32>, &mut Vec<Range<u32>>),
) {
    indices.clear();
    ranges_of_groups(model.group_count(), groups, |group| {
        for strip in model.group_strips(group) {
            let strip = model.strip(state, strip);
            if !strip.is_empty() {
                indices.extend_from_slice(strip);
                indices.push(RESTART);
            }
        }
        indices.len()
    });
}

/// A range for each group, one after the other; `end` fills a group and says where it ends.
fn ranges_of_groups(group_count: usize, groups: &mut Vec<Range<u32>>, mut end: impl FnMut(usize) -> usize) {
    groups.clear();
    let mut first = 0;
    for group in 0..group_count {
        let end = end(group) as u32;
        groups.push(first..end);
        first = end;
    }
}

/// Adds changed ranges to what is to be uploaded.
fn note(changes: &mut Changes, mut ranges: Vec<Range<u32>>) {
    match changes {
        Changes::All => {}
        _ if ranges.is_empty() => {}
        Changes::None => *changes = Changes::Ranges(ranges),
        Changes::Ranges(before) => before.append(&mut ranges),
    }
}

#[cfg(test)]
mod tests {
    use super::super::subject::tests::subject_of;
    use super::*;
    use striata::mesh::{canonical_triangles, shapes};

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
