//! Shared test support for all crates: test meshes, random collapse sequences, and oracles that check models.

#![expect(missing_docs, reason = "only used by tests, and the names describe the meshes")]

pub mod gltf_check;
pub mod levels;
pub mod meshes;
pub mod scenes;
#[cfg(all(unix, feature = "server"))]
pub mod server;
pub mod simplifier;
pub mod strange;
pub mod support;
