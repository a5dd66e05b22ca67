//! glTF files with several levels of each mesh, which engines switch between: chains of `MSFT_lod`.
//!
//! Each node that shows a mesh gets the extension `MSFT_lod` with a node for each coarser level, and the
//! screen coverages at which to switch. All levels of a mesh use one vertex buffer, because a level is a
//! prefix of it; only their indices differ. Skins, morph targets and animated weights work at every level.
//!
//! # Screen coverage
//! `MSFT_screencoverage` is the share of the viewport that an object covers. A level whose error is `e`, of
//! a mesh whose bounding sphere has the radius `r`, appears `p` pixels off when a length of `e` spans `p`
//! pixels, and `r` then spans `r p / e`. The disc of the sphere covers this share of `w x h` pixels:
//!
//! ```text
//! coverage = π (r p / e)² / (w h)
//! ```
//!
//! A level may be shown once the object covers no more than this. Errors and radius are both in mesh units,
//! so scales of nodes cancel out.

mod coverage;
mod nodes;

use std::path::Path;

use serde_json::Value;
use striata::{Level, Target};
use striata_io::{EncodedMesh, Format, Scene, SceneWriter, SharedMesh, WriteError, WriteOptions};

use crate::document::{array, use_extension};
use crate::levels::SceneLevel;
use crate::lod_scene::LodScene;
use coverage::coverage;
use nodes::{ChainLevel, ChainNodes};

/// Options of [`lod_chain`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LodChainOptions {
    /// Error on the screen up to which a level is shown, in pixels; default 1.
    pub error_px: f64,
    /// Width and height of the viewport that the screen coverages are computed for, in pixels; default
    /// 1920 x 1080.
    pub viewport_px: [u32; 2],
    /// Format of the file, glTF or GLB; default GLB.
    pub format: Format,
    /// How the file is quantized and compressed; default: neither.
    pub write: WriteOptions,
}

impl Default for LodChainOptions {
    fn default() -> Self {
        Self { error_px: 1.0, viewport_px: [1920, 1080], format: Format::Glb, write: WriteOptions::default() }
    }
}

impl LodChainOptions {
    /// Sets [`LodChainOptions::error_px`].
    #[must_use]
    pub fn with_error_px(self, error_px: f64) -> Self {
        Self { error_px, ..self }
    }

    /// Sets [`LodChainOptions::viewport_px`].
    #[must_use]
    pub fn with_viewport_px(self, viewport_px: [u32; 2]) -> Self {
        Self { viewport_px, ..self }
    }

    /// Sets [`LodChainOptions::format`].
    #[must_use]
    pub fn with_format(self, format: Format) -> Self {
        Self { format, ..self }
    }

    /// Sets [`LodChainOptions::write`].
    #[must_use]
    pub fn with_write_options(self, write: WriteOptions) -> Self {
        Self { write, ..self }
    }
}

/// Writes the full scene together with coarser levels, as glTF with the extension `MSFT_lod`.
///
/// The levels may be given in any order; a mesh for which several of them are equal, or equal to the full
/// mesh, has fewer levels. Triangles are in cache order at each level, whatever the options say. Viewers without the
/// extension show the full scene. A node that has children, a
/// camera, a light or an animated transform, or that is a joint, keeps these: its mesh moves to a new child,
/// because engines replace a node with everything below it.
///
/// `path` is that of the file, as for [`encode_scene`](striata_io::encode_scene).
///
/// # Errors
/// [`WriteError`] if a mesh contains numbers that glTF cannot store, or the format is neither glTF nor GLB.
pub fn lod_chain(
    scene: &LodScene,
    levels: &[SceneLevel],
    options: &LodChainOptions,
    path: Option<&Path>,
) -> Result<EncodedMesh, WriteError> {
    let mut parts = scene.full_scene().into_parts();
    nodes::show_bare_meshes(&mut parts.document);
    let mut shared = Vec::new();
    let mut chains = Vec::with_capacity(scene.lods().len());
    for mesh in 0..scene.lods().len() {
        let splits = chain_splits(scene, levels, mesh);
        let mut chain = Vec::with_capacity(splits.len());
        for split_count in splits {
            let Some(lod) = &scene.lods()[mesh] else { continue };
            let level = lod.level(Target::SplitCount(split_count));
            let number = chain.len() + 1;
            let entry = push_level(&mut parts.document, mesh, &level, number);
            if let Some(entry) = entry {
                shared.push((entry, shared_mesh(mesh, &level)));
                parts.meshes.resize(entry + 1, None);
            }
            let radius = lod.mesh().diagonal() / 2.0;
            chain.push(ChainLevel {
                mesh: entry,
                coverage: coverage(radius * options.error_px / f64::from(level.error()), options.viewport_px),
            });
        }
        chains.push(chain);
    }
    if chains.iter().any(|chain| !chain.is_empty()) {
        ChainNodes::new(&mut parts.document, &chains).add_all();
        use_extension(&mut parts.document, nodes::EXTENSION);
    }
    let refused = |reason: String| WriteError::BadMesh { file: options.format.to_string(), reason };
    let scene = Scene::from_parts(parts).map_err(|error| refused(error.to_string()))?;
    let writer = SceneWriter::new(&scene);
    let writer =
        shared.into_iter().fold(writer, |writer, (mesh, shared)| writer.with_shared_mesh(mesh, shared));
    writer.encode(options.format, &options.write.clone().with_cache_order(true), path)
}

/// Split counts of the levels of a mesh below the full one, from fine to coarse.
fn chain_splits(scene: &LodScene, levels: &[SceneLevel], mesh: usize) -> Vec<usize> {
    let step_count = scene.lods()[mesh].as_ref().map_or(0, |lod| lod.step_count());
    let splits = levels.iter().filter_map(|level| level.split_counts.get(mesh).copied());
    let mut splits: Vec<usize> = splits.filter(|&split_count| split_count < step_count).collect();
    splits.sort_unstable_by(|a, b| b.cmp(a));
    splits.dedup();
    splits
}

/// Adds an entry for a level of a mesh, and returns its index; [`None`] if it would show nothing.
fn push_level(document: &mut Value, mesh: usize, level: &Level, number: usize) -> Option<usize> {
    let meshes = array(document, "meshes")?;
    let mut entry = meshes.get(mesh)?.clone();
    let primitives = entry.get("primitives").and_then(Value::as_array).map_or(0, Vec::len);
    if level.triangle_count() == 0 && primitives == group_ranges(level).len() {
        return None;
    }
    if let Some(name) = entry.get("name").and_then(Value::as_str) {
        entry["name"] = Value::String(nodes::level_name(name, number));
    }
    meshes.push(entry);
    Some(meshes.len() - 1)
}

fn shared_mesh(mesh: usize, level: &Level) -> SharedMesh {
    let lists = group_ranges(level).into_iter();
    SharedMesh {
        vertices_of: mesh,
        vertex_count: level.vertex_count(),
        index_lists: lists.map(|range| level.indices()[range].to_vec()).collect(),
    }
}

fn group_ranges(level: &Level) -> Vec<std::ops::Range<usize>> {
    level.groups().iter().map(|range| range.start as usize..range.end as usize).collect()
}
