//! Meaning of the colors in a picture.

use clap::ValueEnum;

/// Meaning of the colors in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Coloring {
    /// The mesh as it looks: its vertex colors, or plain stone
    Surface,
    /// One color per triangle strip
    Strips,
    /// One color per triangle fan
    Fans,
    /// One color per triangle
    Triangles,
    /// One color per group, that is, per material
    Groups,
    /// One color per fragment: the triangles that one step inserted
    Fragments,
}
