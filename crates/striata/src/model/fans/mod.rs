//! Progressive fans \[Cor01\]: every level, uniform or not, from one static table and one bit for each step.
//!
//! Each triangle of every level stands with the vertex that leaves it first, which is the one with the highest number; the
//! triangles that a vertex has when it is removed are its entry. A triangle is there while its entry's vertex is and
//! once the step that makes it has been taken, if one does. So what an instance shows is told by which steps it has taken,
//! a bit each, and each vertex can say by itself which of its triangles are there.
//!
//! ```text
//!          c                 entry of v: ring a b c d e, closed
//!       d / \ b              arcs a-b, b-c ... are the triangles v a b, v b c ...
//!       |  v  |              dependencies: always 11000, made by step 7: 00110, by step 9: 00001
//!        e---a               shown with 7 taken and 9 not: arcs 11110, the fan v; a b c d e
//! ```
//!
//! **Which sets of steps are possible.** A step can be taken once all steps are that once took a triangle from one of its
//! vertices: those that make the triangles of its entry, and some whose floor left nothing at the vertex, which are
//! listed beside (a step at a border, say). It can be undone once every position around it is there, and its target if
//! its floor reaches to one that is not around.
//! [`FanInstance::collapse`] and [`FanInstance::split`] take along whatever is needed for that.
//!
//! Differs: \[Cor01\] stores words, here an entry is a few bytes (see `table.rs`); it recurses, here steps wait on a stack. A
//! ring longer than [`MAX_ARCS`] is cut into several fans of one vertex; crowns are fans too, so that no arc has to be
//! void. Positions with several wedges have an entry for each, and one bit.
//!
//! Cost: a triangle a vertex is made by each step that touches it, three times as many as the full mesh has. Extraction
//! is linear in the vertices that are there, a change in the entries that it touches.

mod bounds;
mod budget;
mod build;
mod crowns;
mod emit;
mod front;
mod instance;
mod level;
mod live;
mod morphs;
mod scene;
mod sets;
mod stored;
mod table;
mod table_fan;
mod validate;

pub use emit::{FanForm, FanIndices, fan_triangles_into};
pub use front::{FanFront, FanUpdate};
pub use instance::FanInstance;
pub use live::FanTriangles;
pub use morphs::{FanMorphs, MovingVertex};
pub use scene::FanScene;
pub(crate) use stored::FansParts;
pub use table::MAX_ARCS;
pub use table_fan::{ArcMaker, TableFan};

use self::table::{Entry, Table};
use super::step_bounds::StepBounds;
use super::step_vertices::StepVertices;
use super::{DrawCounts, LodModel, PartBytes, StoredModel, Topology};

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fans {
    vertices: StepVertices<'static>,
    step_count: usize,
    group_count: usize,
    table: Table,
    /// Steps and further steps that they wait for, rising.
    waits: Vec<[u32; 2]>,
    /// Steps and those of their targets, where the target is not among the nodes around.
    far: Vec<[u32; 2]>,
    /// Steps that no position waits for; in the tree they hang from the base.
    orphans: Vec<u32>,
    /// Triangles that each step takes away.
    removed: Box<[u8]>,
    /// What views ask of each step; none if the table was built without.
    bounds: Option<StepBounds>,
}

impl Fans {
    /// Vertices of the full mesh.
    pub fn vertex_count(&self) -> usize {
        self.vertices.vertex_count
    }

    /// Vertices that a uniform level shows: the first so many.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn vertex_count_at(&self, split_count: usize) -> usize {
        self.vertices.count_at(split_count)
    }

    /// Triangles of the base mesh.
    pub fn base_triangle_count(&self) -> usize {
        self.draw_counts(&self.level_at(0)).index_count / 3
    }

    /// Groups of triangles.
    pub fn group_count(&self) -> usize {
        self.group_count
    }

    /// The state of a uniform level.
    pub(crate) fn level_at(&self, split_count: usize) -> FansLevel {
        let mut level = self.new_state();
        self.move_to(&mut level, split_count);
        level
    }

    /// The fans of a vertex of the base.
    #[inline]
    fn base_entry(&self, vertex: u32) -> Entry<'_> {
        self.table.entry(vertex, 0)
    }

    /// The fans of a vertex that a step takes away.
    #[inline]
    fn step_entry(&self, vertex: u32, step: u32) -> Entry<'_> {
        self.table.entry(vertex, step + 1)
    }

    /// Visits the fans of all vertices that are there at a uniform level.
    fn for_each_fan_at(&self, split_count: usize, mut visit: impl FnMut(table::FanView<'_>)) {
        for vertex in 0..self.vertices.base_vertex_count {
            for fan in self.base_entry(vertex) {
                visit(fan);
            }
        }
        for step in 0..split_count {
            for vertex in self.vertices.of_step(step) {
                for fan in self.step_entry(vertex, step as u32) {
                    visit(fan);
                }
            }
        }
    }
}

/// What is listed for a step in rising pairs.
fn listed(pairs: &[[u32; 2]], step: u32) -> impl Iterator<Item = u32> {
    let first = pairs.partition_point(|pair| pair[0] < step);
    pairs[first..].iter().take_while(move |pair| pair[0] == step).map(|pair| pair[1])
}

/// An instance at a uniform level: nothing but its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FansLevel {
    split_count: usize,
}

impl LodModel for Fans {
    type State = FansLevel;

    fn step_count(&self) -> usize {
        self.step_count
    }

    fn new_state(&self) -> FansLevel {
        FansLevel { split_count: self.step_count }
    }

    fn split_count(&self, state: &FansLevel) -> usize {
        state.split_count
    }

    fn move_to(&self, state: &mut FansLevel, split_count: usize) {
        assert!(split_count <= self.step_count, "split count {split_count} of {}", self.step_count);
        state.split_count = split_count;
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &FansLevel) -> DrawCounts {
        self.level_draw_counts(state, FanForm::Triangles)
    }

    fn indices_into(&self, state: &FansLevel, out: &mut Vec<u32>) {
        emit::append_all(self, state, FanForm::Triangles, out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let [entries, starts] = self.table.sizes();
        let mut parts = vec![
            part("first vertices", 4 * self.vertices.firsts.len()),
            part("entries", entries),
            part("starts", starts),
            part("waits", size_of_val(&self.waits[..]) + size_of_val(&self.far[..])),
            part("orphans", size_of_val(&self.orphans[..])),
            part("triangle counts", self.removed.len()),
        ];
        parts.extend(self.bounds.as_ref().map(|bounds| part("bounds", bounds.as_bytes().len())));
        parts
    }

    fn state_bytes(&self, _: &FansLevel) -> usize {
        size_of::<FansLevel>()
    }
}

impl StoredModel for Fans {
    fn step_vertices(&self) -> &StepVertices<'_> {
        &self.vertices
    }

    fn group_count(&self) -> usize {
        self.group_count
    }

    fn group_triangles_into(&self, state: &FansLevel, group: usize, out: &mut Vec<[u32; 3]>) {
        assert!(group < self.group_count, "group {group} of {}", self.group_count);
        let is_taken = |step: u32| step as usize >= state.split_count;
        let mut indices = Vec::new();
        self.for_each_fan_at(state.split_count, |fan| {
            if fan.group as usize == group {
                fan.triangles_into(fan.mask(is_taken), &mut indices);
            }
        });
        out.extend_from_slice(indices.as_chunks().0);
    }
}
