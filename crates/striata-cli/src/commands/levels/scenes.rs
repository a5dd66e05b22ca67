//! Scenes as sources of levels, whether they come from a file or are simplified for the purpose.

use std::convert::Infallible;
use std::path::Path;

use striata::levels::{FoundLevel, Levels, LevelsFacts};
use striata::mesh::{Bounds, IndexedMesh};
use striata::simplify::{SequenceOptions, StopReason, Target};
use striata::view::ScreenError;
use striata_io::{Format, Scene, WriteOptions};
use striata_scene::textures::TextureOptions;
use striata_scene::{BuildError, FittedMeshes, Fitting, LodChainOptions, LodScene, SceneLevel, lod_chain};

use super::super::placement::{ChosenPlacement, fitting_limit};
use super::LevelSource;
use super::report::LevelDetails;
use striata_command::args::FormatArgs;
use striata_command::failure::Failure;
use striata_command::level::CoarseningLimit;
use striata_command::output::{Output, format_noun_count};
use striata_command::save::{LevelFiles, display_name, folder_path, format_of, write_encoded};
use striata_command::scene::{ReceivedScene, with_textures};

/// Levels of a scene.
pub(in crate::commands) struct SceneSource<'a> {
    levels: SceneLevelsSource<'a>,
    limit: CoarseningLimit,
    /// The output of all levels together, if they are written as one file between whose levels engines switch.
    chain: Option<Chain<'a>>,
}

/// One file with the full scene and all levels.
struct Chain<'a> {
    path: &'a Path,
    format: &'a FormatArgs,
    levels: Vec<SceneLevel>,
}

/// The levels, and what happens to them on the way.
pub(in crate::commands) struct SceneLevelsSource<'a> {
    received: ReceivedScene,
    placement: Option<ScenePlacement>,
    /// Whether the coarsest level is the last one within an error limit.
    has_error_limit: bool,
    /// The last level that was found.
    last: Option<SceneLevel>,
    fitted_count: usize,
    output: &'a Output,
}

/// Which meshes get vertices that are not those of the input.
pub(in crate::commands) struct ScenePlacement {
    pub chosen: ChosenPlacement,
    /// Constraints on vertices that move.
    pub options: SequenceOptions,
}

impl<'a> SceneSource<'a> {
    /// Takes the levels of a file, and re-encodes the images of the scene, which are the same in all levels.
    ///
    /// # Errors
    /// If an image cannot be encoded.
    pub(in crate::commands) fn new(
        received: ReceivedScene,
        textures: Option<&TextureOptions>,
        output: &'a Output,
    ) -> Result<Self, Failure> {
        let received = match textures {
            None => received,
            Some(_) => {
                let frame = with_textures(received.lods.scene().clone(), textures, output)?;
                let lods = LodScene::from_lods(frame, received.lods.lods().to_vec());
                let lods = lods.map_err(|error| Failure::internal(error.to_string()))?;
                ReceivedScene { lods, ..received }
            }
        };
        let levels = SceneLevelsSource {
            received,
            placement: None,
            has_error_limit: false,
            last: None,
            fitted_count: 0,
            output,
        };
        Ok(Self { levels, limit: CoarseningLimit::File, chain: None })
    }

    /// States why a scene that was simplified has no coarser levels, and which of its vertices move.
    pub(in crate::commands) fn simplified(
        mut self,
        limit: CoarseningLimit,
        has_error_limit: bool,
        placement: Option<ScenePlacement>,
    ) -> Self {
        (self.levels.has_error_limit, self.levels.placement) = (has_error_limit, placement);
        Self { limit, ..self }
    }

    /// Writes all levels to one file.
    pub(in crate::commands) fn in_one_file(self, path: &'a Path, format: &'a FormatArgs) -> Self {
        Self { chain: Some(Chain { path, format, levels: Vec::new() }), ..self }
    }

    /// Whether vertices of a level were moved.
    pub(in crate::commands) fn is_fitted(&self) -> bool {
        self.levels.fitted_count > 0
    }
}

impl<'a> LevelSource for SceneSource<'a> {
    type Source = SceneLevelsSource<'a>;

    fn levels(&mut self) -> &mut SceneLevelsSource<'a> {
        &mut self.levels
    }

    fn failure(&self, error: BuildError) -> Failure {
        Failure::user(error.to_string())
    }

    fn limit(&self) -> CoarseningLimit {
        self.limit.clone()
    }

    fn write(
        &mut self,
        found: &FoundLevel<Scene>,
        files: &mut LevelFiles<'_>,
        path: &Path,
    ) -> Result<(), Failure> {
        match &mut self.chain {
            Some(chain) => chain.levels.extend(self.levels.last.clone()),
            None => files.write_scene(&found.shape, path)?,
        }
        Ok(())
    }

    fn describe(&mut self, found: &FoundLevel<Scene>, details: &mut LevelDetails) {
        details.georeference = found.shape.georeference().cloned();
        let lods = &self.levels.received.lods;
        if let Some(pixels) = &mut details.pixels {
            // The least important object may err by more.
            *pixels /= lods.least_importance();
            (details.split_count, details.step_count) = (None, None);
            details.has_guaranteed_views = true;
        }
    }

    fn finish(&mut self, output: &Output) -> Result<(), Failure> {
        let lods = &self.levels.received.lods;
        if lods.triangle_count() == 0 {
            output.say("note: the scene shows no triangles; points and lines stay as they are");
        }
        let Some(Chain { path, format, levels }) = &self.chain else { return Ok(()) };
        let write = format.gltf.applied_to(WriteOptions::default());
        let options =
            LodChainOptions::default().with_format(chain_format(path, format)?).with_write_options(write);
        let encoded = lod_chain(lods, levels, &options, folder_path(path))?;
        write_encoded(&encoded, path, output)
    }
}

/// Returns the format of a file with several levels.
///
/// # Errors
/// If the format is not glTF.
pub(in crate::commands) fn chain_format(path: &Path, args: &FormatArgs) -> Result<Format, Failure> {
    match format_of(path, args)? {
        format @ (Format::Gltf | Format::Glb) => Ok(format),
        format => Err(Failure::usage(format!(
            "--lod-chain is for glTF, but {} is written as {format}",
            display_name(path)
        ))
        .with_hint("use the extension .glb or .gltf")),
    }
}

impl SceneLevelsSource<'_> {
    /// Fits the meshes of a level, and reports the meshes that stay although the user asked for fitting.
    fn fitted(&mut self, level: &SceneLevel, max_error: f64) -> Result<Option<FittedMeshes>, BuildError> {
        let Some(placement) = &self.placement else { return Ok(None) };
        let mut bar = self.output.bar();
        let selects = |mesh: &IndexedMesh| placement.chosen.moves(mesh);
        let fitting = Fitting { selects: &selects, options: &placement.options, max_error };
        let lods = &self.received.lods;
        let fitted = lods.fitted_meshes(level, &fitting, &mut |progress| bar.show(progress))?;
        drop(bar);
        let stays = fitted.meshes.iter().flatten().count() - fitted.fitted_count;
        if placement.chosen == ChosenPlacement::Optimal && stays > 0 {
            let count = format_noun_count(stays, "mesh", "meshes");
            self.output
                .say(&format!("note: {count} with skins or morph targets: vertices of the input are kept"));
        }
        self.fitted_count += fitted.fitted_count;
        Ok(Some(fitted))
    }

    /// Whether a stream that is cut off ends before the level for a target.
    fn ends_before(&self, target: Target) -> bool {
        let levels = self.received.lods.levels();
        !self.received.is_complete
            && match target {
                Target::Triangles(n) => n > levels.triangle_count(),
                Target::Vertices(n) => n > levels.vertex_count(),
                Target::Error(error) => error < self.received.error,
                Target::SplitCount(n) => n > levels.step_count(),
                _ => false,
            }
    }
}

impl Levels for SceneLevelsSource<'_> {
    type Shape = Scene;
    type Error = BuildError;

    fn facts(&self) -> LevelsFacts {
        let [triangle_count, vertex_count] = self.received.full_counts;
        LevelsFacts { triangle_count, vertex_count, ..self.received.lods.facts() }
    }

    fn bounds(&mut self) -> Result<Option<Bounds>, BuildError> {
        Ok(self.received.lods.bounds().unwrap_or_else(|never: Infallible| match never {}))
    }

    fn find(&mut self, target: Target) -> Result<FoundLevel<Scene>, BuildError> {
        let mut level = self.received.lods.level(target);
        level.error = level.error.max(self.received.error);
        let fitted = self.fitted(&level, fitting_limit(target))?;
        let scene = match fitted {
            None => self.received.lods.level_scene(&level),
            Some(fitted) => {
                level = fitted.level;
                let scene = self.received.lods.scene().clone().with_meshes(fitted.meshes);
                scene.expect("the groups of each mesh were checked, and every level has them all")
            }
        };
        if self.has_error_limit && level.stop_reason == StopReason::BaseReached {
            level.stop_reason = StopReason::ErrorLimit;
        }
        if self.ends_before(target) {
            level.stop_reason = StopReason::InputEnded;
        }
        let found = self.received.lods.found_level(&level, scene);
        self.last = Some(level);
        Ok(found)
    }

    fn find_for_view(
        &mut self,
        criterion: &ScreenError,
        triangle_limit: Option<usize>,
    ) -> Result<FoundLevel<Scene>, BuildError> {
        let found = self.received.lods.find_for_view(criterion, triangle_limit);
        Ok(found.unwrap_or_else(|never: Infallible| match never {}))
    }
}
