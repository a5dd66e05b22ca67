//! Multiresolution models over one collapse sequence.
//!
//! A model has two halves. The static half is built once, never changes, may be shared by any number of
//! instances and may borrow its arrays from a mapped file. The state is what one instance on the
//! screen owns: where it stands and what it shows.

pub mod lod_strips;

pub use lod_strips::{LodStrips, LodStripsError, LodStripsState, StripBuffer};

/// What a part of a model takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartBytes {
    /// The part, in the words of the format's description.
    pub name: &'static str,
    /// Its bytes.
    pub bytes: usize,
}

/// A model that shows any level of a collapse sequence as a whole.
pub trait LodModel {
    /// What one instance owns.
    type State;

    /// Steps from the base mesh to the full mesh.
    fn step_count(&self) -> usize;

    /// A new instance; it shows the full mesh.
    fn new_state(&self) -> Self::State;

    /// The level that an instance shows.
    fn split_count(&self, state: &Self::State) -> usize;

    /// Moves an instance to a level, step by step.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count, or the state belongs to a model of another shape.
    fn move_to(&self, state: &mut Self::State, split_count: usize);

    /// Appends the triangles that an instance shows, group after group.
    fn triangles_into(&self, state: &Self::State, out: &mut Vec<[u32; 3]>);

    /// Bytes of the static half by part; positions and attributes are the mesh's and not counted.
    fn bytes(&self) -> Vec<PartBytes>;
}
