//! State of one instance: the active vertices and triangles, and the split and collapse operations.

use super::{NONE, ROOT, Triangle, ViewDependentMeshes, corner_of};

/// State of one instance: a front of the hierarchy and the triangles that it shows.
///
/// Two instances are equal if they show the same triangles, regardless of how they got there.
#[derive(Clone, Debug)]
pub struct ViewDependentState {
    /// The active vertices, unordered.
    pub(super) active: Vec<ActiveVertex>,
    /// Index of each vertex in `active`, or [`NONE`].
    pub(super) index_of: Vec<u32>,
    /// Corners of the active triangles, which are drawn.
    corners: Vec<[u32; 3]>,
    /// Adjacency of the active triangles, in the same order.
    triangles: Vec<Triangle>,
    /// Index of each triangle in `triangles`, or [`NONE`].
    slot_of: Vec<u32>,
    /// Motion accumulated since everything was last evaluated; infinite if everything is due.
    pub(super) elapsed: f64,
    /// Every step before this one is split.
    pub(super) lowest: usize,
    /// Neither this step nor any later one is split.
    pub(super) highest: usize,
    /// Newly active vertices that may have to be split further.
    pub(super) arrived: Vec<u32>,
    /// Steps that may have become collapsible.
    pub(super) collapsible: Vec<u32>,
    /// Stack of steps to split, each waiting for those above it.
    pub(super) waiting: Vec<u32>,
}

/// A vertex of the surface and the hierarchy node that it represents.
#[derive(Clone, Copy, Debug)]
pub(super) struct ActiveVertex {
    pub vertex: u32,
    /// The step that splits it, or [`LEAF`](super::LEAF).
    pub node: u32,
    /// Whether both children of the step that restored this vertex are active.
    pub has_both: bool,
    /// Accumulated motion at which to evaluate again whether to split the vertex, and whether to collapse
    /// the step that restored it.
    pub due: [f32; 2],
}

impl ActiveVertex {
    fn new(vertex: u32, node: u32, has_both: bool) -> Self {
        Self { vertex, node, has_both, due: [DUE_NOW; 2] }
    }
}

/// A verdict that has expired.
pub(super) const DUE_NOW: f32 = f32::NEG_INFINITY;

impl ViewDependentState {
    /// Creates an instance that shows the base.
    pub(super) fn base(model: &ViewDependentMeshes) -> Self {
        let base_count = model.roots.len();
        let mut index_of = vec![NONE; base_count + model.splits.len()];
        (0..).zip(&mut index_of[..base_count]).for_each(|(index, of)| *of = index);
        let mut slot_of = vec![NONE; model.base_triangles.len() + 2 * model.splits.len()];
        (0..).zip(&mut slot_of[..model.base_triangles.len()]).for_each(|(slot, of)| *of = slot);
        let roots = (0..).zip(&model.roots);
        Self {
            active: roots.map(|(vertex, &node)| ActiveVertex::new(vertex, node, false)).collect(),
            index_of,
            corners: model.base_corners.clone(),
            triangles: model.base_triangles.clone(),
            slot_of,
            elapsed: 0.0,
            lowest: 0,
            highest: 0,
            arrived: Vec::new(),
            collapsible: Vec::new(),
            waiting: Vec::new(),
        }
    }

    /// The triangles shown, of all groups, unordered.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.corners
    }

    /// Number of vertices shown.
    pub fn vertex_count(&self) -> usize {
        self.active.len()
    }

    /// Whether a vertex is active.
    ///
    /// # Panics
    /// If the vertex does not exist.
    pub fn is_active(&self, vertex: u32) -> bool {
        self.index_of[vertex as usize] != NONE
    }

    /// Bytes owned by the instance: those of active elements, and a word for each vertex and triangle of
    /// the model. Lists count by length, not by capacity.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.active[..])
            + size_of_val(&self.index_of[..])
            + size_of_val(&self.corners[..])
            + size_of_val(&self.triangles[..])
            + size_of_val(&self.slot_of[..])
    }

    /// The active triangles with their indices.
    pub(super) fn indexed(&self) -> impl Iterator<Item = (u32, &[u32; 3])> {
        self.triangles.iter().map(|triangle| triangle.index).zip(&self.corners)
    }

    /// Panics unless the state has the model's sizes.
    pub(super) fn check(&self, model: &ViewDependentMeshes) {
        let vertex_count = model.roots.len() + model.splits.len();
        let triangle_count = model.base_triangles.len() + 2 * model.splits.len();
        assert!(
            self.index_of.len() == vertex_count && self.slot_of.len() == triangle_count,
            "the state belongs to another model"
        );
    }

    /// The node that a vertex currently represents, if it is active.
    #[inline]
    pub(super) fn node_of(&self, vertex: u32) -> Option<u32> {
        let index = self.index_of[vertex as usize];
        (index != NONE).then(|| self.active[index as usize].node)
    }

    #[inline]
    pub(super) fn has_triangle(&self, triangle: u32) -> bool {
        self.slot_of[triangle as usize] != NONE
    }

    /// Whether a step is split.
    #[inline]
    pub(super) fn is_split(&self, model: &ViewDependentMeshes, step: u32) -> bool {
        model.created_by(step).iter().any(|&triangle| self.has_triangle(triangle))
    }

    /// Whether both children of a step are active.
    #[inline]
    pub(super) fn has_children(&self, model: &ViewDependentMeshes, step: u32) -> bool {
        let index = self.index_of[model.restored(step) as usize];
        index != NONE && self.active[index as usize].has_both
    }

    /// Updates whether both children of a split step are active.
    #[inline]
    fn update_children(&mut self, model: &ViewDependentMeshes, step: u32) {
        let split = &model.splits[step as usize];
        // A restored vertex keeps its index even when it is split further.
        let index = self.index_of[model.restored(step) as usize] as usize;
        let kept = self.active[self.index_of[split.target as usize] as usize].node;
        self.active[index].has_both = [kept, self.active[index].node] == split.children;
    }

    fn set_node(&mut self, vertex: u32, node: u32) {
        let active = &mut self.active[self.index_of[vertex as usize] as usize];
        active.node = node;
        active.due[0] = DUE_NOW;
    }

    /// Whether a step whose children are active can be collapsed: the triangles it created must have their
    /// original neighbors.
    #[inline]
    pub(super) fn can_collapse(&self, model: &ViewDependentMeshes, step: u32) -> bool {
        let [left_kept, left_restored, right_kept, right_restored] = model.splits[step as usize].neighbors;
        let [left, right] = model.created_by(step).map(|triangle| self.slot_of[triangle as usize]);
        let has = |slot: u32, neighbors: [u32; 2]| {
            slot == NONE || self.triangles[slot as usize].neighbors[..2] == neighbors
        };
        has(left, [left_restored, left_kept]) && has(right, [right_kept, right_restored])
    }

    /// Splits an active vertex; the triangles that will be adjacent must exist.
    pub(super) fn split(&mut self, model: &ViewDependentMeshes, step: u32) {
        let split = &model.splits[step as usize];
        let (kept, restored) = (split.target, model.restored(step));
        self.set_node(kept, split.children[0]);
        self.index_of[restored as usize] = self.active.len() as u32;
        self.active.push(ActiveVertex::new(restored, split.children[1], true));
        if split.parent != ROOT {
            self.update_children(model, split.parent);
        }
        let [left, right] = split.present(model.created_by(step));
        let [left_kept, left_restored, right_kept, right_restored] = split.neighbors;
        // Both sides of a gap share the vertex at its end; at least one of the sides exists.
        let left_tip = self.link(left_kept, kept, 2, left);
        let left_tip = self.link(left_restored, kept, 1, left).or(left_tip);
        let right_tip = self.link(right_kept, kept, 1, right);
        let right_tip = self.link(right_restored, kept, 2, right).or(right_tip);
        self.rename(split.neighbors, right, kept, restored);
        if let Some(tip) = left_tip {
            self.push(left, [kept, restored, tip], [left_restored, left_kept, right]);
        }
        if let Some(tip) = right_tip {
            self.push(right, [restored, kept, tip], [right_kept, right_restored, left]);
        }
        self.highest = self.highest.max(step as usize + 1);
    }

    /// Collapses a step that can be collapsed in this state.
    pub(super) fn collapse(&mut self, model: &ViewDependentMeshes, step: u32) {
        let split = &model.splits[step as usize];
        let (kept, restored) = (split.target, model.restored(step));
        let [left, right] = split.present(model.created_by(step));
        let [left_kept, left_restored, right_kept, right_restored] = split.neighbors;
        self.rename(split.neighbors, right, restored, kept);
        self.link(left_kept, kept, 2, left_restored);
        self.link(left_restored, kept, 1, left_kept);
        self.link(right_kept, kept, 1, right_restored);
        self.link(right_restored, kept, 2, right_kept);
        [left, right]
            .into_iter()
            .filter(|&triangle| triangle != NONE)
            .for_each(|triangle| self.remove(triangle));
        self.set_node(kept, step);
        let index = std::mem::replace(&mut self.index_of[restored as usize], NONE) as usize;
        self.active.swap_remove(index);
        if let Some(moved) = self.active.get(index) {
            self.index_of[moved.vertex as usize] = index as u32;
        }
        if split.parent != ROOT {
            self.update_children(model, split.parent);
        }
        self.lowest = self.lowest.min(step as usize);
    }

    /// Sets the neighbor across the side that is `turn` corners from a vertex. Returns the other end of
    /// that side.
    #[inline]
    fn link(&mut self, triangle: u32, vertex: u32, turn: usize, neighbor: u32) -> Option<u32> {
        if triangle == NONE {
            return None;
        }
        let slot = self.slot_of[triangle as usize] as usize;
        let corner = corner_of(&self.corners[slot], vertex);
        self.triangles[slot].neighbors[(corner + turn) % 3] = neighbor;
        Some(self.corners[slot][(corner + 3 - turn) % 3])
    }

    /// Moves the triangles on the restored side of a split from one vertex to another: those from the
    /// neighbor of the left triangle around to that of the right one, or from both up to a border in between.
    #[inline]
    fn rename(&mut self, neighbors: [u32; 4], right: u32, from: u32, to: u32) {
        let [_, first, _, last] = neighbors;
        let mut at = first;
        while at != NONE {
            let next = self.rename_corner(at, from, to, 2);
            if at == last {
                return;
            }
            at = next;
        }
        debug_assert!(right != NONE || last == NONE, "a missing triangle has a neighbor");
        at = last;
        while at != NONE {
            at = self.rename_corner(at, from, to, 1);
        }
    }

    /// Renames a corner and returns the triangle across the side that is `turn` corners from it.
    #[inline]
    fn rename_corner(&mut self, triangle: u32, from: u32, to: u32, turn: usize) -> u32 {
        let slot = self.slot_of[triangle as usize] as usize;
        let corner = corner_of(&self.corners[slot], from);
        self.corners[slot][corner] = to;
        self.triangles[slot].neighbors[(corner + turn) % 3]
    }

    fn push(&mut self, triangle: u32, corners: [u32; 3], neighbors: [u32; 3]) {
        self.slot_of[triangle as usize] = self.corners.len() as u32;
        self.corners.push(corners);
        self.triangles.push(Triangle { neighbors, index: triangle });
    }

    fn remove(&mut self, triangle: u32) {
        let slot = std::mem::replace(&mut self.slot_of[triangle as usize], NONE) as usize;
        self.corners.swap_remove(slot);
        self.triangles.swap_remove(slot);
        if let Some(moved) = self.triangles.get(slot) {
            self.slot_of[moved.index as usize] = slot as u32;
        }
    }
}

impl PartialEq for ViewDependentState {
    fn eq(&self, other: &Self) -> bool {
        let shows = |&ActiveVertex { vertex, node, .. }: &ActiveVertex| {
            (vertex as usize) < other.index_of.len() && other.node_of(vertex) == Some(node)
        };
        let has_same = |(at, triangle): (usize, &Triangle)| {
            other.slot_of.get(triangle.index as usize).is_some_and(|&slot| {
                slot != NONE
                    && other.corners[slot as usize] == self.corners[at]
                    && other.triangles[slot as usize] == *triangle
            })
        };
        self.active.len() == other.active.len()
            && self.corners.len() == other.corners.len()
            && self.active.iter().all(shows)
            && self.triangles.iter().enumerate().all(has_same)
    }
}

impl Eq for ViewDependentState {}
