//! What one instance owns: the active vertices and triangles, and the two operations on them.

use super::{NONE, ROOT, Triangle, ViewDependentMeshes, turn_of};

/// An instance: a front of the hierarchy and the triangles that it shows.
///
/// Two instances are equal if they show the same, however they came there.
#[derive(Clone, Debug)]
pub struct ViewDependentState {
    /// The active vertices, in no order.
    pub(super) active: Vec<ActiveVertex>,
    /// Where each vertex stands among them, or [`NONE`].
    pub(super) place_of: Vec<u32>,
    /// Corners of the active triangles: what is drawn.
    corners: Vec<[u32; 3]>,
    /// The same triangles, for those who walk over them.
    triangles: Vec<Triangle>,
    /// Where each triangle stands among them, or [`NONE`].
    slot_of: Vec<u32>,
    /// All motion since everything was last asked; infinite where it is to be asked again.
    pub(super) elapsed: f64,
    /// Every step before is split.
    pub(super) lowest: usize,
    /// No step from here on is split.
    pub(super) highest: usize,
    /// Vertices that have come and may have to be split further.
    pub(super) arrived: Vec<u32>,
    /// Steps that may have become ones to undo.
    pub(super) loosened: Vec<u32>,
    /// Steps that wait for others to be split.
    pub(super) waiting: Vec<u32>,
}

/// A vertex of the surface and the node of the hierarchy that it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct ActiveVertex {
    pub(super) vertex: u32,
    /// The step that splits it, or [`LEAF`](super::LEAF).
    pub(super) node: u32,
    /// Whether both vertices that came of the step that restored this one are there as they came.
    pub(super) has_both: bool,
    /// Motion after which it is asked again whether to split it, and whether to undo the step that restored it.
    pub(super) due: [f32; 2],
}

impl ActiveVertex {
    fn new(vertex: u32, node: u32, has_both: bool) -> Self {
        Self { vertex, node, has_both, due: [ASK; 2] }
    }
}

/// Due at once.
pub(super) const ASK: f32 = f32::NEG_INFINITY;

impl ViewDependentState {
    /// An instance that shows the base.
    pub(super) fn base(model: &ViewDependentMeshes) -> Self {
        let base_count = model.roots.len();
        let mut place_of = vec![NONE; base_count + model.splits.len()];
        (0..).zip(&mut place_of[..base_count]).for_each(|(place, of)| *of = place);
        let mut slot_of = vec![NONE; model.base_triangles.len() + 2 * model.splits.len()];
        (0..).zip(&mut slot_of[..model.base_triangles.len()]).for_each(|(slot, of)| *of = slot);
        let roots = (0..).zip(&model.roots);
        Self {
            active: roots.map(|(vertex, &node)| ActiveVertex::new(vertex, node, false)).collect(),
            place_of,
            corners: model.base_corners.clone(),
            triangles: model.base_triangles.clone(),
            slot_of,
            elapsed: 0.0,
            lowest: 0,
            highest: 0,
            arrived: Vec::new(),
            loosened: Vec::new(),
            waiting: Vec::new(),
        }
    }

    /// The triangles that it shows, of all groups, in no order.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.corners
    }

    /// Vertices that it shows.
    pub fn vertex_count(&self) -> usize {
        self.active.len()
    }

    /// Whether a vertex is there.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn is_active(&self, vertex: u32) -> bool {
        self.place_of[vertex as usize] != NONE
    }

    /// Bytes that the instance owns: what is active, and a word for each vertex and triangle that could be. Lists are counted
    /// by what they hold.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.active[..])
            + size_of_val(&self.place_of[..])
            + size_of_val(&self.corners[..])
            + size_of_val(&self.triangles[..])
            + size_of_val(&self.slot_of[..])
    }

    /// The active triangles with their numbers.
    pub(super) fn numbered(&self) -> impl Iterator<Item = (u32, &[u32; 3])> {
        self.triangles.iter().map(|triangle| triangle.number).zip(&self.corners)
    }

    /// Whether it can belong to the model.
    pub(super) fn check(&self, model: &ViewDependentMeshes) {
        let vertex_count = model.roots.len() + model.splits.len();
        let triangle_count = model.base_triangles.len() + 2 * model.splits.len();
        assert!(
            self.place_of.len() == vertex_count && self.slot_of.len() == triangle_count,
            "the state belongs to another model"
        );
    }

    /// The node that a vertex is, if it is there.
    #[inline]
    pub(super) fn node_of(&self, vertex: u32) -> Option<u32> {
        let place = self.place_of[vertex as usize];
        (place != NONE).then(|| self.active[place as usize].node)
    }

    #[inline]
    pub(super) fn has_triangle(&self, number: u32) -> bool {
        self.slot_of[number as usize] != NONE
    }

    /// Whether the vertex that a step splits has been split.
    #[inline]
    pub(super) fn is_split(&self, model: &ViewDependentMeshes, step: u32) -> bool {
        model.made_by(step).iter().any(|&number| self.has_triangle(number))
    }

    /// Whether both children of a step's vertex are there.
    #[inline]
    pub(super) fn has_children(&self, model: &ViewDependentMeshes, step: u32) -> bool {
        let place = self.place_of[model.restored(step) as usize];
        place != NONE && self.active[place as usize].has_both
    }

    /// Notes whether both children of a step that is split are there.
    #[inline]
    fn note_children(&mut self, model: &ViewDependentMeshes, step: u32) {
        let split = &model.splits[step as usize];
        // Whatever comes of it further, a vertex that is restored stays there under its number.
        let place = self.place_of[model.restored(step) as usize] as usize;
        let kept = self.active[self.place_of[split.target as usize] as usize].node;
        self.active[place].has_both = [kept, self.active[place].node] == split.children;
    }

    fn set_node(&mut self, vertex: u32, node: u32) {
        let active = &mut self.active[self.place_of[vertex as usize] as usize];
        active.node = node;
        active.due[0] = ASK;
    }

    /// Whether a step whose children are there can be collapsed: the triangles that it made have the neighbors that they
    /// were made with.
    #[inline]
    pub(super) fn can_collapse(&self, model: &ViewDependentMeshes, step: u32) -> bool {
        let [left_kept, left_restored, right_kept, right_restored] = model.splits[step as usize].beside;
        let [left, right] = model.made_by(step).map(|number| self.slot_of[number as usize]);
        let has =
            |slot: u32, beside: [u32; 2]| slot == NONE || self.triangles[slot as usize].beside[..2] == beside;
        has(left, [left_restored, left_kept]) && has(right, [right_kept, right_restored])
    }

    /// Splits a vertex that is there, beside triangles that are.
    pub(super) fn split(&mut self, model: &ViewDependentMeshes, step: u32) {
        let split = &model.splits[step as usize];
        let (kept, restored) = (split.target, model.restored(step));
        self.set_node(kept, split.children[0]);
        self.place_of[restored as usize] = self.active.len() as u32;
        self.active.push(ActiveVertex::new(restored, split.children[1], true));
        if split.parent != ROOT {
            self.note_children(model, split.parent);
        }
        let [left, right] = split.present(model.made_by(step));
        let [left_kept, left_restored, right_kept, right_restored] = split.beside;
        // Both sides of a gap name the vertex at its end; one of them is there.
        let left_tip = self.link(left_kept, kept, 2, left);
        let left_tip = self.link(left_restored, kept, 1, left).or(left_tip);
        let right_tip = self.link(right_kept, kept, 1, right);
        let right_tip = self.link(right_restored, kept, 2, right).or(right_tip);
        self.rename(split.beside, right, kept, restored);
        if let Some(tip) = left_tip {
            self.push(left, [kept, restored, tip], [left_restored, left_kept, right]);
        }
        if let Some(tip) = right_tip {
            self.push(right, [restored, kept, tip], [right_kept, right_restored, left]);
        }
        self.highest = self.highest.max(step as usize + 1);
    }

    /// Undoes the split of a step that can be collapsed.
    pub(super) fn collapse(&mut self, model: &ViewDependentMeshes, step: u32) {
        let split = &model.splits[step as usize];
        let (kept, restored) = (split.target, model.restored(step));
        let [left, right] = split.present(model.made_by(step));
        let [left_kept, left_restored, right_kept, right_restored] = split.beside;
        self.rename(split.beside, right, restored, kept);
        self.link(left_kept, kept, 2, left_restored);
        self.link(left_restored, kept, 1, left_kept);
        self.link(right_kept, kept, 1, right_restored);
        self.link(right_restored, kept, 2, right_kept);
        [left, right].into_iter().filter(|&number| number != NONE).for_each(|number| self.remove(number));
        self.set_node(kept, step);
        let place = std::mem::replace(&mut self.place_of[restored as usize], NONE) as usize;
        self.active.swap_remove(place);
        if let Some(moved) = self.active.get(place) {
            self.place_of[moved.vertex as usize] = place as u32;
        }
        if split.parent != ROOT {
            self.note_children(model, split.parent);
        }
        self.lowest = self.lowest.min(step as usize);
    }

    /// Puts a neighbor behind the side of a triangle that lies so many turns from a vertex; the other end of that side.
    #[inline]
    fn link(&mut self, number: u32, vertex: u32, turn: usize, neighbor: u32) -> Option<u32> {
        if number == NONE {
            return None;
        }
        let slot = self.slot_of[number as usize] as usize;
        let corner = turn_of(&self.corners[slot], vertex);
        self.triangles[slot].beside[(corner + turn) % 3] = neighbor;
        Some(self.corners[slot][(corner + 3 - turn) % 3])
    }

    /// Gives the triangles of one vertex on the restored side of a split to another: those from beside the left triangle
    /// round to beside the right one, or from both to a border between.
    #[inline]
    fn rename(&mut self, beside: [u32; 4], right: u32, from: u32, to: u32) {
        let [_, first, _, last] = beside;
        let mut at = first;
        while at != NONE {
            let next = self.rename_corner(at, from, to, 2);
            if at == last {
                return;
            }
            at = next;
        }
        debug_assert!(right != NONE || last == NONE, "there is a side beside a triangle that is none");
        at = last;
        while at != NONE {
            at = self.rename_corner(at, from, to, 1);
        }
    }

    /// The triangle behind the side that lies so many turns from the corner.
    #[inline]
    fn rename_corner(&mut self, number: u32, from: u32, to: u32, turn: usize) -> u32 {
        let slot = self.slot_of[number as usize] as usize;
        let corner = turn_of(&self.corners[slot], from);
        self.corners[slot][corner] = to;
        self.triangles[slot].beside[(corner + turn) % 3]
    }

    fn push(&mut self, number: u32, corners: [u32; 3], beside: [u32; 3]) {
        self.slot_of[number as usize] = self.corners.len() as u32;
        self.corners.push(corners);
        self.triangles.push(Triangle { beside, number });
    }

    fn remove(&mut self, number: u32) {
        let slot = std::mem::replace(&mut self.slot_of[number as usize], NONE) as usize;
        self.corners.swap_remove(slot);
        self.triangles.swap_remove(slot);
        if let Some(moved) = self.triangles.get(slot) {
            self.slot_of[moved.number as usize] = slot as u32;
        }
    }
}

impl PartialEq for ViewDependentState {
    fn eq(&self, other: &Self) -> bool {
        let shows = |&ActiveVertex { vertex, node, .. }: &ActiveVertex| {
            (vertex as usize) < other.place_of.len() && other.node_of(vertex) == Some(node)
        };
        let holds = |(at, triangle): (usize, &Triangle)| {
            other.slot_of.get(triangle.number as usize).is_some_and(|&slot| {
                slot != NONE
                    && other.corners[slot as usize] == self.corners[at]
                    && other.triangles[slot as usize] == *triangle
            })
        };
        self.active.len() == other.active.len()
            && self.corners.len() == other.corners.len()
            && self.active.iter().all(shows)
            && self.triangles.iter().enumerate().all(holds)
    }
}

impl Eq for ViewDependentState {}
