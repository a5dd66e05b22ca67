//! Opens files as scenes: with the levels that they contain, or with levels built now.

use serde_json::Value;
use striata::LodOptions;
use striata::mesh::IndexedMesh;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;
use striata_command::scene::SceneKind;
use striata_io::Scene;
use striata_scene::LodScene;

use super::loader::Reporter;
use super::scene::SceneSubject;
use super::subject::Origin;
use crate::picture::{SceneLook, has_materials};

/// A scene that was read.
pub(super) enum SceneContent {
    /// With all of its levels.
    Levels(LodScene),
    /// Without levels.
    Full(Box<Scene>),
    /// From a format that does not say which side of a surface is visible, so both are.
    DoubleSided(Box<Scene>),
}

impl SceneContent {
    /// Reads an input that stores a scene; none if it looks no different from its bare meshes.
    ///
    /// # Errors
    /// If the file is malformed.
    pub(super) fn read(input: &Input, kind: SceneKind, output: &Output) -> Result<Option<Self>, Failure> {
        if kind != SceneKind::Gltf {
            return Ok(Some(Self::Levels(input.received_scene(output)?.lods)));
        }
        let scene = input.scene(output)?;
        Ok(is_worth_drawing(&scene).then(|| Self::Full(Box::new(scene))))
    }

    /// Makes a scene of a mesh that has materials; returns the mesh if it has none.
    ///
    /// # Errors
    /// If the materials are malformed.
    pub(super) fn of_mesh(input: &Input, mesh: IndexedMesh) -> Result<Result<Self, IndexedMesh>, Failure> {
        if !has_materials(&mesh) {
            return Ok(Err(mesh));
        }
        let scene = Scene::from_mesh(mesh);
        let scene = scene.map_err(|error| Failure::user(format!("{}: {error}", input.name)))?;
        Ok(Ok(Self::DoubleSided(Box::new(scene))))
    }

    /// Builds missing levels and decodes images.
    ///
    /// # Errors
    /// If a mesh, an animation or a skin is inconsistent, or the user cancels.
    pub(super) fn into_subject(
        self,
        origin: Origin,
        output: &Output,
        reporter: &mut Reporter,
    ) -> Result<SceneSubject, Failure> {
        let is_double_sided = matches!(self, Self::DoubleSided(_));
        let lods = match self {
            Self::Levels(lods) => lods,
            Self::Full(scene) | Self::DoubleSided(scene) => {
                let options = LodOptions::default();
                let built =
                    LodScene::build_with_progress(&scene, &options, &mut |progress| reporter.show(progress));
                built.map_err(|error| Failure::user(format!("{}: {error}", origin.name)))?
            }
        };
        reporter.phase("textures");
        let (subject, warnings) = SceneSubject::new(origin, lods, is_double_sided)?;
        for warning in warnings {
            output.say(&format!("warning: {warning}"));
        }
        // The first frame needs the order of all levels.
        subject.lods.levels();
        Ok(subject)
    }
}

/// Whether a scene without levels says how it looks, or moves.
fn is_worth_drawing(scene: &Scene) -> bool {
    let animations = scene.document().get("animations").and_then(Value::as_array);
    SceneLook::is_described(scene) || animations.is_some_and(|animations| !animations.is_empty())
}
