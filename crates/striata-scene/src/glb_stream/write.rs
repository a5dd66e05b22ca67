//! Writing: a coarse level in the primitives, and a stream for each mesh.

use serde_json::{Map, Value, json};
use striata::mesh::IndexedMesh;
use striata::simplify::SimplifyError;
use striata::{Lod, ProgressFn, Target, ignore_progress};
use striata_io::{Format, Scene, SceneWriter, WriteOptions};
use striata_stream::{Precision, SHAPE_STEPS, StreamError, StreamOptions, encode_stream_with_progress};

use super::{GlbStreamError, GlbStreamOptions, STREAM_EXTENSION, STREAM_EXTENSION_VERSION};
use crate::document::{extension_slot, use_extension};
use crate::error::BuildError;
use crate::levels::{MeshWeight, SceneLevel};
use crate::lod_scene::LodScene;
use crate::mesh_simplifier::MeshSimplifier;
use crate::stream::share_lattices;

impl LodScene {
    /// Encodes the scene as a GLB file that any viewer shows at a coarse level, and that contains the full
    /// meshes as progressive streams in the extension `STRIATA_lod`.
    ///
    /// Primitives of which the coarse level shows nothing keep their place, as one triangle without area.
    /// The binary chunk holds the coarse level and the data of animations and skins first, then the images,
    /// then the streams.
    ///
    /// # Errors
    /// [`GlbStreamError`] if an option is out of range, a mesh contains numbers that glTF cannot store, or
    /// the file would be larger than 4 GiB.
    pub fn to_glb_with_stream(&self, options: &GlbStreamOptions) -> Result<Vec<u8>, GlbStreamError> {
        self.to_glb_with_stream_and_progress(options, &mut ignore_progress)
    }

    /// Runs [`to_glb_with_stream`](Self::to_glb_with_stream) and reports progress of each mesh; the callback
    /// can cancel.
    ///
    /// # Errors
    /// See [`to_glb_with_stream`](Self::to_glb_with_stream); also [`GlbStreamError::Cancelled`] if the callback
    /// cancels.
    pub fn to_glb_with_stream_and_progress(
        &self,
        options: &GlbStreamOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Vec<u8>, GlbStreamError> {
        let coarse = self.drawable_level(options.coarse_target(self.triangle_count()));
        let streams = self.streams(options, progress)?;
        let mut parts = self.level_scene(&coarse).into_parts();
        for (mesh, stream) in streams.iter().enumerate() {
            let (Some(_), Some(lod)) = (stream, &self.lods()[mesh]) else { continue };
            let error = f64::from(lod.sequence().error_at(coarse.split_counts[mesh]));
            describe_stream(&mut parts.document, mesh, lod.mesh(), error);
        }
        if streams.iter().any(Option::is_some) {
            use_extension(&mut parts.document, STREAM_EXTENSION);
        }
        let scene = Scene::from_parts(parts).expect("the extension does not change what the parts depend on");
        let mut writer = SceneWriter::new(&scene).keeping_primitives();
        for (mesh, stream) in streams.into_iter().enumerate() {
            let pointer = format!("/meshes/{mesh}/extensions/{STREAM_EXTENSION}/bufferView");
            if let Some(stream) = stream {
                writer = writer.with_attachment(pointer, stream);
            }
        }
        Ok(writer.to_bytes(Format::Glb, &WriteOptions::default().with_cache_order(true))?)
    }

    /// Returns the level for a target, refined until each mesh shows at least one triangle, because glTF
    /// has no empty meshes.
    fn drawable_level(&self, target: Target) -> SceneLevel {
        let mut splits = self.level(target).split_counts;
        for (split_count, lod) in splits.iter_mut().zip(self.lods()) {
            let Some(lod) = lod else { continue };
            let shows_something = |&at: &usize| lod.sequence().triangle_count_at(at) > 0;
            *split_count = (*split_count..=lod.step_count()).find(shows_something).unwrap_or(*split_count);
        }
        self.levels().level_of(splits)
    }

    /// Encodes a stream for each mesh that shows anything.
    fn streams(
        &self,
        options: &GlbStreamOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Vec<Option<Vec<u8>>>, GlbStreamError> {
        let simplifier = MeshSimplifier::new(self.scene());
        let weights = MeshWeight::of_scene(self.scene());
        let mut options_of: Vec<_> =
            weights.iter().map(|weight| in_mesh_units(&options.stream, weight)).collect();
        let meshes: Vec<_> = self.lods().iter().map(|lod| lod.as_ref().map(Lod::mesh)).collect();
        share_lattices(self.scene(), &meshes, options_of.iter_mut().map(Some).collect());
        let encode = |(mesh, lod): (usize, &Option<Lod>)| {
            let Some(lod) = lod.as_ref().filter(|lod| lod.mesh().triangle_count() > 0) else {
                return Ok(None);
            };
            let failed = |error: SimplifyError| match error {
                SimplifyError::Cancelled(reason) => reason.into(),
                error => BuildError::new(mesh, self.scene().mesh_name(mesh).to_owned(), error).into(),
            };
            let in_stream = |error: StreamError| match error {
                StreamError::Cancelled(reason) => reason.into(),
                error => GlbStreamError::Stream { mesh, error },
            };
            let own = &options_of[mesh];
            let step = own.grid_step(lod.mesh()).map_err(|error| in_stream(error.into()))?;
            let shape_step = options.batches.shape_step.unwrap_or(SHAPE_STEPS * step);
            let batches = options.batches.clone().with_shape_step(Some(shape_step));
            let built: Result<_, GlbStreamError> =
                simplifier.batches(mesh, lod.mesh(), &batches, progress).map_err(failed);
            let built = built?;
            let stream = encode_stream_with_progress(&built.built.refinable, &built.batches, own, progress);
            Ok(Some(stream.map_err(in_stream)?.bytes))
        };
        self.lods().iter().enumerate().map(encode).collect()
    }
}

/// Returns the options of a mesh, with a tolerance in its own units.
fn in_mesh_units(options: &StreamOptions, weight: &MeshWeight) -> StreamOptions {
    match options.precision {
        Precision::Tolerance(length) => {
            options.clone().with_precision(Precision::Tolerance(length / weight.scale))
        }
        _ => options.clone(),
    }
}

/// Adds the extension to a mesh of the document; the writer sets the buffer view.
fn describe_stream(document: &mut Value, mesh: usize, full: &IndexedMesh, error: f64) {
    let Some(slot) = extension_slot(&mut document["meshes"][mesh], STREAM_EXTENSION) else { return };
    *slot = Value::Object(Map::from_iter([
        ("version".to_owned(), json!(STREAM_EXTENSION_VERSION)),
        ("bufferView".to_owned(), Value::Null),
        ("vertexCount".to_owned(), json!(full.vertex_count())),
        ("triangleCount".to_owned(), json!(full.triangle_count())),
        ("error".to_owned(), json!(error)),
    ]));
}
