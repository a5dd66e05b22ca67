//! Scenes: inputs with nodes, materials, skins and animations, and the levels of all their meshes.

use serde_json::Value;
use striata::file::SCENE_STREAM_MAGIC;
use striata::mesh::{Appearance, IndexedMesh, Material};
use striata::simplify::Target;
use striata::{Lod, LodOptions, ProgressFn};
use striata_io::{Format, Scene, lost_group_names, mesh_data, read_scene_bytes};
use striata_scene::file::{SceneFile, is_scene_file};
use striata_scene::glb_stream::STREAM_EXTENSION;
use striata_scene::stream::{SceneStreamDecoder, SceneStreamInfo};
use striata_scene::textures::{TextureOptions, TextureReport, recode_scene};
use striata_scene::{BuildError, LodScene, read_glb_with_stream};

use crate::args::{EditArgs, SequenceArgs};
use crate::failure::{Failure, decode_hint};
use crate::input::Input;
use crate::level::FullMesh;
use crate::output::{Output, format_bytes, format_count, format_noun_count};
use crate::sequence::{ErrorGuarantee, Limits, SequencePlan};

/// How an input stores a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneKind {
    /// glTF or 3MF without levels.
    Gltf,
    /// glTF with a stream of each mesh, in the extension `STRIATA_lod`.
    GltfWithStreams,
    /// `.striata` file of a scene.
    File,
    /// Stream of a scene.
    Stream,
}

/// A scene with its levels, as far as an input contains them.
#[derive(Clone, Debug)]
pub struct ReceivedScene {
    /// The scene and the levels that were received.
    pub lods: LodScene,
    /// Whether the input is complete: not a stream that is cut off.
    pub is_complete: bool,
    /// Error of the finest level that was received, scene units; 0 if the input is complete.
    pub error: f64,
    /// Numbers of triangles and vertices of the full scene, even if the input is cut off.
    pub full_counts: [usize; 2],
}

impl ReceivedScene {
    /// Wraps all levels of a scene.
    pub fn complete(lods: LodScene) -> Self {
        let full_counts = [lods.levels().triangle_count(), lods.levels().vertex_count()];
        Self { lods, is_complete: true, error: 0.0, full_counts }
    }
}

/// Returns the numbers of triangles and vertices of the full scene of a stream, counted as in the levels.
fn full_counts(info: &SceneStreamInfo, lods: &LodScene) -> [usize; 2] {
    let meshes = info.meshes.iter().enumerate().filter_map(|(mesh, facts)| Some((mesh, facts.as_ref()?)));
    meshes.fold([0, 0], |[triangles, vertices], (mesh, facts)| {
        let instances = lods.levels().weight(mesh).map_or(1, |weight| weight.instance_count);
        [triangles + instances * facts.triangle_count as usize, vertices + facts.vertex_count as usize]
    })
}

impl Input {
    /// Returns how the input stores a scene; `None` for meshes, shapes, and the levels of one mesh.
    pub fn scene_kind(&self) -> Option<SceneKind> {
        match self.bytes()? {
            (Format::Gltf | Format::Glb, bytes) if self.has_streams(bytes) => {
                Some(SceneKind::GltfWithStreams)
            }
            (format, _) if format.has_scenes() => Some(SceneKind::Gltf),
            (Format::Striata, bytes) if is_scene_file(bytes) => Some(SceneKind::File),
            (Format::Stream, bytes) if bytes.starts_with(&SCENE_STREAM_MAGIC) => Some(SceneKind::Stream),
            _ => None,
        }
    }

    /// Whether the input contains the levels of a scene.
    pub fn has_scene_levels(&self) -> bool {
        self.scene_kind().is_some_and(|kind| kind != SceneKind::Gltf)
    }

    /// Returns the whole scene; a mesh or shape becomes a scene with one node.
    ///
    /// Warns the user of missing textures. If a stream is cut off, returns what it contains, and warns the
    /// user.
    ///
    /// # Errors
    /// If the file is malformed; the message says where.
    pub fn scene(&self, output: &Output) -> Result<Scene, Failure> {
        if self.has_scene_levels() {
            let scene = self.received_scene(output)?.lods.full_scene();
            output.warn(scene.warnings())?;
            return Ok(scene);
        }
        let scene = match self.bytes() {
            Some((Format::Striata | Format::Stream, _)) | None => {
                let failed = |error| Failure::user(format!("{}: {error}", self.name));
                return Scene::from_mesh(self.mesh(output)?).map_err(failed);
            }
            Some((_, bytes)) => {
                read_scene_bytes(bytes, &self.source()).map_err(|error| self.unreadable_mesh(error))?
            }
        };
        output.warn(scene.warnings())?;
        Ok(scene)
    }

    /// Returns the levels of the scene that the input contains, and warns the user if it is cut off; levels
    /// of one mesh become a scene with one node.
    ///
    /// # Errors
    /// If the input has no levels, or is damaged.
    pub fn received_scene(&self, output: &Output) -> Result<ReceivedScene, Failure> {
        let complete = ReceivedScene::complete;
        let (Some(kind), Some((_, bytes))) = (self.scene_kind(), self.bytes()) else {
            let lod = Lod::from_file(&self.striata()?).map_err(|error| self.broken(&error))?;
            return Ok(complete(LodScene::from_lod(lod).map_err(|error| self.broken(&error))?));
        };
        match kind {
            SceneKind::Gltf => {
                // A damaged file has another reason.
                self.scene(&Output::quiet())?;
                Err(self.without_levels())
            }
            SceneKind::GltfWithStreams => {
                let read = read_glb_with_stream(bytes, &self.source());
                read.map_err(|error| self.broken(&error))?.map(complete).ok_or_else(|| self.without_levels())
            }
            SceneKind::File => {
                let file = SceneFile::parse(bytes).map_err(|error| self.broken(&error))?;
                Ok(complete(file.lod_scene().map_err(|error| self.broken(&error))?))
            }
            SceneKind::Stream => self.streamed_scene(bytes, output),
        }
    }

    fn streamed_scene(&self, bytes: &[u8], output: &Output) -> Result<ReceivedScene, Failure> {
        let mut decoder = SceneStreamDecoder::new();
        decoder.push(bytes).map_err(|error| self.broken(&error))?;
        let is_complete = decoder.is_complete();
        if !is_complete {
            decoder.finish().map_err(|error| self.broken(&error))?;
        }
        decoder.check_drawable().map_err(|error| self.broken(&error))?;
        let scene = decoder.scene().map_err(|error| self.broken(&error))?;
        if !is_complete {
            let whole = decoder.stream_bytes().and_then(|bytes| usize::try_from(bytes).ok());
            output.say(&format!(
                "{}: cut off after {} of {} bytes; all meshes are there, some of them coarse, and textures \
                 that are missing are shown by previews",
                self.name,
                format_count(bytes.len()),
                format_count(whole.unwrap_or(usize::MAX)),
            ));
        }
        // A mesh whose base is missing has no levels, but shows nothing either.
        let lods = LodScene::from_lods(scene.without_meshes(), decoder.lods());
        let error = decoder.error().unwrap_or(0.0);
        let received = ReceivedScene::complete(lods.map_err(|error| self.broken(&error))?);
        let info = SceneStreamInfo::read(bytes).map_err(|error| self.broken(&error))?.unwrap_or_default();
        let full_counts = full_counts(&info, &received.lods);
        Ok(ReceivedScene { is_complete, error, full_counts, ..received })
    }

    /// Whether a mesh of a glTF file has a stream; also if the extension is malformed.
    fn has_streams(&self, bytes: &[u8]) -> bool {
        mentions_streams(bytes)
            && mesh_data(bytes, &self.source(), STREAM_EXTENSION)
                .map_or(true, |meshes| meshes.iter().any(Option::is_some))
    }

    fn without_levels(&self) -> Failure {
        let message = format!("{}: this is a scene ({}) without levels", self.name, self.kind());
        Failure::user(message)
            .with_hint("build a file with `striata build`, or use `striata simplify` on the scene")
    }

    fn broken(&self, error: &(dyn std::error::Error + 'static)) -> Failure {
        Failure::user(format!("{}: {error}", self.name)).with_hint(decode_hint(error))
    }
}

/// Whether the document of a glTF or GLB file mentions the extension for streams.
fn mentions_streams(bytes: &[u8]) -> bool {
    let length = bytes.get(12..16).and_then(|length| length.try_into().ok()).map(u32::from_le_bytes);
    let document = match length {
        Some(length) if bytes.starts_with(b"glTF") => bytes.get(20..).map(|rest| {
            let end = usize::try_from(length).unwrap_or(usize::MAX).min(rest.len());
            &rest[..end]
        }),
        _ => Some(bytes),
    };
    let name = STREAM_EXTENSION.as_bytes();
    document.is_some_and(|document| document.windows(name.len()).any(|window| window == name))
}

/// Checks that no flag was given that only has a meaning for one mesh.
///
/// # Errors
/// If there is such a flag.
pub fn check_scene_flags(input: &Input, flags: &[(&str, bool)]) -> Result<(), Failure> {
    match flags.iter().find(|&&(_, is_given)| is_given) {
        None => Ok(()),
        Some((flag, _)) => {
            Err(Failure::user(format!("{flag} is for one mesh, but {} is a scene", input.name))
                .with_hint(format!("add --flat to treat the scene as one mesh, or remove {flag}")))
        }
    }
}

/// Returns the sizes that percentages of targets refer to: triangles count once for each instance.
pub fn full_scene_sizes(received: &ReceivedScene, needs_diagonal: bool) -> FullMesh {
    let [triangle_count, vertex_count] = received.full_counts;
    // The scene of a `LodScene` has no triangles of its own.
    let diagonal = if needs_diagonal { received.lods.full_scene().diagonal() } else { 0.0 };
    FullMesh { diagonal, vertex_count, triangle_count }
}

/// Builds the levels of a scene, down to the limits.
///
/// # Errors
/// If an option is out of range, or a mesh is inconsistent.
pub fn build_scene(
    input: &Input,
    scene: &Scene,
    args: &SequenceArgs,
    limits: Limits,
    progress: &mut ProgressFn<'_>,
) -> Result<LodScene, Failure> {
    let options = args.scene_options(scene, limits.max_error.is_some())?;
    let failed = |error: BuildError| Failure::user(format!("{}: {error}", input.name));
    let lods = LodScene::build_with_progress(scene, &options, progress).map_err(failed)?;
    let lods = match limits.max_error {
        Some(error) => lods.without_levels_below(&lods.level(Target::Error(error))),
        None => lods,
    };
    Ok(match limits.base_triangle_count {
        0 => lods,
        count => lods.without_levels_below(&lods.level(Target::Triangles(count))),
    })
}

impl SequenceArgs {
    /// Returns the options for the levels of a scene.
    ///
    /// # Errors
    /// If a flag is for one mesh only, or belongs to the other order.
    pub fn scene_options(&self, scene: &Scene, has_limit: bool) -> Result<LodOptions, Failure> {
        let SequencePlan::Quadric { options, guarantee, .. } =
            self.plan(scene.diagonal(), Limits::default())?
        else {
            let flag = match self.new_vertices {
                Some(_) => "--new-vertices",
                None => "--order hausdorff",
            };
            return Err(Failure::user(format!("{flag} is for one mesh, not for a scene"))
                .with_hint(format!("add --flat to treat the scene as one mesh, or remove {flag}")));
        };
        let is_guaranteed = guarantee != ErrorGuarantee::None || has_limit;
        Ok(LodOptions::default().with_sequence(options).with_guaranteed_errors(is_guaranteed))
    }
}

/// Returns the materials, textures and images of a scene, as a mesh has them.
fn appearance_of(scene: &Scene) -> Appearance {
    let materials = entries(scene.document(), "materials").iter().map(|material| Material {
        name: material["name"].as_str().unwrap_or_default().to_owned(),
        gltf_json: material.to_string(),
    });
    let texts = |key: &str| entries(scene.document(), key).iter().map(Value::to_string).collect();
    Appearance {
        materials: materials.collect(),
        textures_json: texts("textures"),
        samplers_json: texts("samplers"),
        images: scene.images().to_vec(),
        ..Appearance::default()
    }
}

fn entries<'v>(document: &'v Value, key: &str) -> &'v [Value] {
    document.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// Merges equal parts of a scene if `merges`, leaves out keyframes if the options say so, and reports what was removed.
///
/// # Errors
/// If the data of an animation are damaged.
pub fn edited(mut scene: Scene, edits: &EditArgs, merges: bool, output: &Output) -> Result<Scene, Failure> {
    if merges || edits.dedup {
        let (merged, counts) = scene.deduplicated();
        scene = merged;
        let parts = [
            (counts.images, "image", "images"),
            (counts.textures, "texture", "textures"),
            (counts.materials, "material", "materials"),
            (counts.vertices, "vertex", "vertices"),
            (counts.meshes, "mesh", "meshes"),
        ];
        let parts = parts.into_iter().filter(|part| part.0 > 0);
        let parts: Vec<_> =
            parts.map(|(count, one, several)| format_noun_count(count, one, several)).collect();
        if !parts.is_empty() {
            output.say(&format!("note: {} merged with equal ones", parts.join(", ")));
        }
    }
    if let Some(tolerance) = edits.resample {
        let (resampled, [before, after]) =
            scene.resampled(tolerance).map_err(|error| Failure::user(error.to_string()))?;
        scene = resampled;
        if before > 0 {
            output.say(&format!("note: {} of {} keyframes kept", format_count(after), format_count(before)));
        }
    }
    Ok(scene)
}

/// Re-encodes the images of a scene, and reports which have changed.
///
/// # Errors
/// If an encoder fails.
pub fn with_textures(
    scene: Scene,
    options: Option<&TextureOptions>,
    output: &Output,
) -> Result<Scene, Failure> {
    let Some(options) = options else { return Ok(scene) };
    let recoded = recode_scene(scene, options);
    let (scene, report) = recoded.map_err(|error| Failure::user(error.to_string()))?;
    say_textures(&report, output);
    Ok(scene)
}

/// Re-encodes the images of a mesh, and reports which have changed.
///
/// # Errors
/// If an encoder fails.
pub fn with_mesh_textures(
    mut mesh: IndexedMesh,
    options: Option<&TextureOptions>,
    output: &Output,
) -> Result<IndexedMesh, Failure> {
    if options.is_none() || mesh.appearance.images.is_empty() {
        return Ok(mesh);
    }
    let mut images = IndexedMesh::new(Vec::new(), Vec::new());
    images.appearance = std::mem::take(&mut mesh.appearance);
    let Appearance { materials, material_libraries, .. } = images.appearance.clone();
    let scene = Scene::from_mesh(images).map_err(|error| Failure::internal(error.to_string()))?;
    let scene = with_textures(scene, options, output)?;
    mesh.appearance = Appearance { materials, material_libraries, ..appearance_of(&scene) };
    let used = entries(scene.document(), "extensionsUsed").iter().filter_map(Value::as_str);
    mesh.appearance.extensions_used = used.map(str::to_owned).collect();
    Ok(mesh)
}

fn say_textures(report: &TextureReport, output: &Output) {
    for warning in &report.warnings {
        output.say(&format!("warning: {warning}"));
    }
    let [before, after] = report
        .changed
        .iter()
        .fold([0, 0], |[before, after], change| [before + change.bytes_before, after + change.bytes]);
    let count = format_noun_count(report.changed.len(), "image", "images");
    let unchanged = match report.unchanged_count {
        0 => String::new(),
        unchanged => format!("; {} unchanged", format_count(unchanged)),
    };
    let [before, after] = [before, after].map(format_bytes);
    output.say(&format!("textures: {count} re-encoded, {before} -> {after}{unchanged}"));
}

/// Returns a scene with one node that shows everything in the input as one mesh, and warns of names that scenes cannot
/// hold; `file` is the name of the output.
///
/// # Errors
/// If the input is malformed.
pub fn flat_scene(input: &Input, file: &str, output: &Output) -> Result<Scene, Failure> {
    let mesh = input.mesh(output)?;
    output.warn_of_losses(&lost_group_names(&mesh, file));
    Scene::from_mesh(mesh).map_err(|error| Failure::user(format!("{}: {error}", input.name)))
}
