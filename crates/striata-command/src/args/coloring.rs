//! What the colors of a picture mean.

use clap::ValueEnum;

/// What colors tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Coloring {
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
