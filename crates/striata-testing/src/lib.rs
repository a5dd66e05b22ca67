//! What the tests of all crates share: meshes of every kind, random sequences, and the oracles that models are held to.

#![expect(missing_docs, reason = "only tests use it, and names say what a mesh is")]

pub mod meshes;
pub mod support;
