//! State of one instance: its faces, and how it splits and collapses vertices.

use super::faces::{HalfEdgeFaces, NONE, next, prev};
use super::{HAS_CORNERS, HAS_LEFT, HAS_RIGHT, HAS_SECOND_RUN, HoppeProgressiveMeshes, Split};
use striata::model::LodModel;

/// State of one instance: its level and its faces. Created by
/// [`LodModel::new_state`](striata::model::LodModel).
#[derive(Clone, Debug)]
pub struct HoppeProgressiveMeshesState {
    split_count: usize,
    /// End of the extra words of the last refined step.
    extra_cursor: usize,
    faces: HalfEdgeFaces,
    /// Number of faces shown in each group.
    live_counts: Vec<u32>,
    /// Scratch: the half-edges that leave the vertex of a step in its runs.
    run: Vec<u32>,
}

/// States are equal if they show the same faces in the same order.
impl PartialEq for HoppeProgressiveMeshesState {
    fn eq(&self, other: &Self) -> bool {
        self.split_count == other.split_count
            && self.live_counts == other.live_counts
            && self.faces.corners == other.faces.corners
    }
}

impl Eq for HoppeProgressiveMeshesState {}

impl HoppeProgressiveMeshesState {
    pub(super) fn new(model: &HoppeProgressiveMeshes) -> Self {
        let mut state = Self::base(model);
        state.move_to(model, model.step_count());
        state
    }

    /// An instance that shows the base.
    fn base(model: &HoppeProgressiveMeshes) -> Self {
        let corner_count = 3 * model.face_count();
        let mut faces = HalfEdgeFaces { corners: vec![0; corner_count], twins: vec![NONE; corner_count] };
        let mut at = 0;
        for (&first, &count) in model.group_offsets.iter().zip(&model.base_counts) {
            let (to, count) = (3 * first as usize, count as usize);
            let own = at..at + count;
            faces.corners[to..to + 3 * count].copy_from_slice(model.base_corners[own.clone()].as_flattened());
            faces.twins[to..to + 3 * count].copy_from_slice(model.base_twins[own].as_flattened());
            at += count;
        }
        let live_counts = model.base_counts.clone();
        Self { split_count: 0, extra_cursor: 0, faces, live_counts, run: Vec::new() }
    }

    /// The current level.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// The triangle list, three indices per triangle. It includes triangles that are not shown, so its
    /// length never changes; [`HoppeProgressiveMeshes::group_ranges`] returns the parts to draw.
    pub fn indices(&self) -> &[u32] {
        &self.faces.corners
    }

    /// Bytes owned by the instance.
    pub fn bytes(&self) -> usize {
        4 * (self.faces.corners.len() + self.faces.twins.len() + self.live_counts.len())
    }

    /// Number of faces shown in each group.
    pub(super) fn live_counts(&self) -> &[u32] {
        &self.live_counts
    }

    pub(super) fn move_to(&mut self, model: &HoppeProgressiveMeshes, split_count: usize) {
        let step_count = model.step_count();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert!(
            self.faces.corners.len() == 3 * model.face_count()
                && self.live_counts.len() == model.group_count(),
            "the state belongs to another model"
        );
        while self.split_count > split_count {
            self.collapse(model);
        }
        while self.split_count < split_count {
            self.split(model);
        }
    }

    /// Refines the next step.
    fn split(&mut self, model: &HoppeProgressiveMeshes) {
        let step = self.split_count;
        self.split_count += 1;
        let split = model.splits[step];
        let extras = &model.extras[self.extra_cursor..];
        let vertex = model.vertices.of_step(step).start;
        let [left, right] = self.append_faces(model, step, split);
        let (ends, second_run) = self.find_run(split, extras);
        for at in 0..self.run.len() {
            self.faces.set_corner(self.run[at], vertex);
        }
        self.insert_faces([left, right], vertex, ends);
        if split.code & HAS_CORNERS != 0 {
            let skipped = if split.code & HAS_SECOND_RUN == 0 { 0 } else { 2 };
            self.set_corners(&extras[skipped + self.run.len()..], [left, right]);
        }
        self.extra_cursor += model.extra_count(split, second_run);
    }

    /// Adds the faces of a split to the end of their lists; returns their first half-edges.
    #[inline]
    fn append_faces(&mut self, model: &HoppeProgressiveMeshes, step: usize, split: Split) -> [u32; 2] {
        let groups = model.groups_of(step);
        let mut append = |flag: u16, group: usize| {
            if split.code & flag == 0 {
                return NONE;
            }
            let face = model.group_offsets[group] + self.live_counts[group];
            self.live_counts[group] += 1;
            3 * face
        };
        [append(HAS_LEFT, groups[0]), append(HAS_RIGHT, groups[1])]
    }

    /// Walks around the target of a split: lists the half-edges of the run, and returns the ends of the run
    /// and the number of faces of its second part.
    #[inline]
    fn find_run(&mut self, split: Split, extras: &[u32]) -> (RunEnds, usize) {
        let faces = &self.faces;
        self.run.clear();
        let mut at = split.half_edge;
        for _ in 0..split.run {
            self.run.push(at);
            at = faces.turned(at);
        }
        let left = match self.run.first() {
            Some(&first) => CornerSide::of_left(faces, first),
            None => CornerSide::outside(faces, split.half_edge, split.code & HAS_LEFT != 0),
        };
        if split.code & HAS_SECOND_RUN == 0 {
            let right = match self.run.last() {
                Some(&last) => CornerSide::of_right(faces, last),
                None if split.code & HAS_LEFT == 0 => left,
                // The two new faces share two edges.
                None => CornerSide { inner: NONE, outer: faces.twin(split.half_edge), ..left },
            };
            return (RunEnds { left, right }, 0);
        }
        let (half_edge, count) = (extras[0], extras[1] as usize);
        let mut at = half_edge;
        for _ in 0..count {
            self.run.push(at);
            at = faces.turned_back(at);
        }
        let right = match count {
            0 => CornerSide::outside(faces, half_edge, false),
            _ => CornerSide::of_right(faces, half_edge),
        };
        (RunEnds { left, right }, count)
    }

    /// Puts new faces between the run and what is outside.
    #[inline]
    fn insert_faces(&mut self, [left, right]: [u32; 2], vertex: u32, ends: RunEnds) {
        let faces = &mut self.faces;
        let mut set = |face: u32, corners: [u32; 3]| {
            (0..).zip(corners).for_each(|(i, corner)| faces.set_corner(face + i, corner));
        };
        if left != NONE {
            set(left, [vertex, ends.left.target, ends.left.tip]);
        }
        if right != NONE {
            set(right, [vertex, ends.right.tip, ends.right.target]);
        }
        if left != NONE {
            faces.link(left, NONE);
            faces.link(left + 1, ends.left.outer);
            faces.link(left + 2, ends.left.inner);
        }
        if right != NONE {
            faces.link(right, ends.right.inner);
            faces.link(right + 1, ends.right.outer);
            faces.link(right + 2, left);
            if left != NONE && ends.left.inner == NONE && ends.right.inner == NONE && ends.is_pillow() {
                faces.link(left + 2, right);
            }
        }
    }

    /// Collapses the last refined step.
    fn collapse(&mut self, model: &HoppeProgressiveMeshes) {
        self.split_count -= 1;
        let step = self.split_count;
        let split = model.splits[step];
        let [left, right] = self.remove_faces(model, step, split);
        self.find_run_around(split, left, right);
        let target = if left != NONE { self.faces.corner(left + 1) } else { self.faces.corner(right + 2) };
        for at in 0..self.run.len() {
            self.faces.set_corner(self.run[at], target);
        }
        let second_run = self.run.len() - usize::from(split.run);
        self.extra_cursor -= model.extra_count(split, second_run);
        if split.code & HAS_CORNERS != 0 {
            let skipped = if split.code & HAS_SECOND_RUN == 0 { 0 } else { 2 };
            let coarse = &model.extras[self.extra_cursor + skipped..];
            for (&half_edge, &corner) in self.run.iter().zip(coarse) {
                self.faces.set_corner(half_edge, corner);
            }
        }
        self.join_around(left, right);
    }

    /// Removes the faces of a split from the ends of their lists; returns their first half-edges.
    #[inline]
    fn remove_faces(&mut self, model: &HoppeProgressiveMeshes, step: usize, split: Split) -> [u32; 2] {
        let groups = model.groups_of(step);
        let mut remove = |flag: u16, group: usize| {
            if split.code & flag == 0 {
                return NONE;
            }
            self.live_counts[group] -= 1;
            3 * (model.group_offsets[group] + self.live_counts[group])
        };
        let right = remove(HAS_RIGHT, groups[1]);
        [remove(HAS_LEFT, groups[0]), right]
    }

    /// Lists the half-edges that leave the vertex of a step, except in the two faces that vanish.
    #[inline]
    fn find_run_around(&mut self, split: Split, left: u32, right: u32) {
        let faces = &self.faces;
        self.run.clear();
        if left != NONE {
            let mut at = faces.turned(left);
            while at != NONE && at != right {
                self.run.push(at);
                at = faces.turned(at);
            }
            if at == NONE && right != NONE {
                let mut at = faces.turned_back(right);
                while at != NONE {
                    self.run.push(at);
                    at = faces.turned_back(at);
                }
            }
        } else {
            let mut at = faces.turned_back(right);
            while at != NONE {
                self.run.push(at);
                at = faces.turned_back(at);
            }
            self.run.reverse();
        }
        debug_assert!(self.run.len() >= usize::from(split.run), "the run is shorter than recorded");
    }

    /// Joins what the vanishing faces separated.
    #[inline]
    fn join_around(&mut self, left: u32, right: u32) {
        let faces = &mut self.faces;
        let is_pillow = left != NONE && right != NONE && faces.twin(left + 2) == right;
        if is_pillow {
            faces.link(faces.twin(left + 1), faces.twin(right + 1));
            return;
        }
        if left != NONE {
            let (inner, outer) = (faces.twin(left + 2), faces.twin(left + 1));
            faces.link(inner, outer);
        }
        if right != NONE {
            let (inner, outer) = (faces.twin(right), faces.twin(right + 1));
            faces.link(inner, outer);
        }
    }

    /// Sets all corners around a split: those of the run, then those of the new faces.
    fn set_corners(&mut self, corners: &[u32], new_faces: [u32; 2]) {
        let of_faces = new_faces.into_iter().filter(|&face| face != NONE).flat_map(|face| face..face + 3);
        for (half_edge, &corner) in self.run.iter().copied().chain(of_faces).zip(corners) {
            self.faces.corners[half_edge as usize] = corner;
        }
    }
}

/// Half-edges and corners on both sides of a run.
#[derive(Clone, Copy)]
struct RunEnds {
    left: CornerSide,
    right: CornerSide,
}

impl RunEnds {
    /// Whether the two new faces share two edges.
    #[inline]
    fn is_pillow(&self) -> bool {
        self.left.tip == self.right.tip
    }
}

/// Half-edges and corners on one side of a run before a face is put there.
#[derive(Clone, Copy)]
struct CornerSide {
    /// The half-edge of the run that will be opposite to the new face, or [`NONE`].
    inner: u32,
    /// The half-edge outside that will be opposite to the new face, or [`NONE`].
    outer: u32,
    /// The target of the step.
    target: u32,
    /// The third corner of the new face.
    tip: u32,
}

impl CornerSide {
    #[inline]
    fn of_left(faces: &HalfEdgeFaces, first: u32) -> Self {
        let tip = faces.corner(next(first));
        Self { inner: first, outer: faces.twin(first), target: faces.corner(first), tip }
    }

    #[inline]
    fn of_right(faces: &HalfEdgeFaces, last: u32) -> Self {
        let inner = prev(last);
        Self { inner, outer: faces.twin(inner), target: faces.corner(last), tip: faces.corner(inner) }
    }

    /// A side without a run: `outer` leads toward the target on the left, and away from it on the right.
    #[inline]
    fn outside(faces: &HalfEdgeFaces, outer: u32, is_left: bool) -> Self {
        let (here, there) = (faces.corner(outer), faces.corner(next(outer)));
        let [target, tip] = if is_left { [there, here] } else { [here, there] };
        Self { inner: NONE, outer, target, tip }
    }
}
