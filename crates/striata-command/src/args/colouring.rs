//! What the colours of a picture mean.

use clap::ValueEnum;

/// What colours tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Colouring {
    /// Nothing but what the mesh looks like
    Surface,
    /// Strips
    Strips,
    /// Fans
    Fans,
    /// Single triangles
    Triangles,
    /// Groups, which are its materials
    Groups,
}
