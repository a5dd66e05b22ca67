//! A scene as the source of a picture: in a pose, with materials, with or without levels.

use striata::levels::Levels as _;
use striata::mesh::IndexedMesh;
use striata::simplify::Target;
use striata::{LodOptions, ProgressFn};
use striata_command::args::{Coloring, Point, find_entry};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{CoarseningLimit, FullMesh, ReachedLevel, shortfall};
use striata_command::output::{Bar, Output};
use striata_command::scene::{ReceivedScene, SceneKind};
use striata_io::Scene;
use striata_render::{Camera, SceneLook};
use striata_scene::drawn::{DocumentCamera, ImageLimits, Projection, cameras, lights, posed_mesh};
use striata_scene::{LodScene, Pose, Poser};

use super::figure::Figure;
use crate::args::{DrawnModel, RenderArgs};
use crate::commands::levels::{camera, pixels_of};

/// A scene in a pose.
pub(super) struct SceneSource {
    /// The full scene in the pose.
    mesh: IndexedMesh,
    look: Option<SceneLook>,
    levels: Option<ReceivedScene>,
    poser: Poser,
    pose: Pose,
    cameras: Vec<DocumentCamera>,
    /// Whether levels were made for the picture.
    is_built: bool,
}

impl SceneSource {
    /// Reads the input as a scene; [`None`] if it is a mesh, or has to be drawn as one: a plain mesh in glTF
    /// without materials, colors and animations, or any scene for a model other than the list, or for
    /// colors of fragments.
    ///
    /// # Errors
    /// If the input is malformed, or a flag needs a scene or an animation that is not there.
    pub(super) fn read(
        args: &RenderArgs,
        input: &Input,
        output: &Output,
        bar: &mut Bar,
    ) -> Result<Option<Self>, Failure> {
        let reason = match args.model {
            Some(model) if model != DrawnModel::List => Some("is drawn as one mesh by --model"),
            _ if args.colors.contains(&Coloring::Fragments) => {
                Some("is drawn as one mesh by --colors fragments")
            }
            _ => None,
        };
        let Some(kind) = input.scene_kind() else {
            return refuse_scene_flags(args, &input.name, "is one mesh").map(|()| None);
        };
        if let Some(reason) = reason {
            return refuse_scene_flags(args, &input.name, reason).map(|()| None);
        }
        let in_file = |error: &dyn std::fmt::Display| Failure::user(format!("{}: {error}", input.name));
        let (scene, levels) = if kind == SceneKind::Gltf {
            (input.scene(output)?, None)
        } else {
            let received = input.received_scene(output)?;
            (received.lods.full_scene(), Some(received))
        };
        let poser = Poser::new(&scene).map_err(|error| in_file(&error))?;
        let has_look = SceneLook::is_described(&scene);
        if levels.is_none() && !has_look && poser.animation_count() == 0 && args.camera.is_none() {
            return refuse_scene_flags(args, &input.name, "has no animation").map(|()| None);
        }
        let pose = pose(args, &poser, input, output)?;
        let mesh = posed_mesh(&scene, &poser, &pose).map_err(|error| in_file(&error))?;
        let look = (has_look && args.shows_surface()).then(|| {
            bar.phase("textures");
            SceneLook::of(&scene, &ImageLimits::default()).with_lights(lights(&scene, &pose))
        });
        let is_built = levels.is_none() && args.needs_levels();
        let cameras = cameras(&scene, &pose);
        let levels = match levels {
            None if is_built => Some(build(input, &scene, &mut |progress| bar.show(progress))?),
            other => other,
        };
        Ok(Some(Self { mesh, look, levels, poser, pose, cameras, is_built }))
    }

    /// The full scene in its pose.
    pub(super) fn mesh(&self) -> &IndexedMesh {
        &self.mesh
    }

    /// The materials, if the picture shows them.
    pub(super) fn look(&self) -> Option<&SceneLook> {
        self.look.as_ref()
    }

    /// Returns the sizes that percentages of targets refer to.
    pub(super) fn full(&self) -> FullMesh {
        let diagonal = self.mesh.diagonal();
        match &self.levels {
            Some(ReceivedScene { full_counts: [triangle_count, vertex_count], .. }) => {
                FullMesh { diagonal, vertex_count: *vertex_count, triangle_count: *triangle_count }
            }
            None => FullMesh {
                diagonal,
                vertex_count: self.mesh.vertex_count(),
                triangle_count: self.mesh.triangle_count(),
            },
        }
    }

    /// Returns the level for a target, or the full scene if there is none.
    ///
    /// # Errors
    /// Never for levels of a scene that was posed before.
    pub(super) fn target(&self, target: Option<Target>) -> Result<Figure, Failure> {
        let (Some(target), Some(received)) = (target, &self.levels) else {
            let full = Figure::of_mesh(self.mesh.clone());
            let error = self.levels.as_ref().map_or(0.0, |received| received.error as f32);
            return Ok(Figure { error, error_is_guaranteed: error == 0.0, ..full });
        };
        let level = received.lods.level(target);
        let mesh = self.posed(&received.lods.level_scene(&level))?;
        let (vertex_count, triangle_count, stop_reason) =
            (level.vertex_count, level.triangle_count, level.stop_reason);
        let reached = ReachedLevel { vertex_count, triangle_count, stop_reason };
        Ok(Figure {
            vertex_count,
            error: level.error.max(received.error) as f32,
            error_is_guaranteed: received.lods.has_guaranteed_errors(),
            shortfall: shortfall(target, reached, &self.coarsening_limit()),
            ..Figure::of_mesh(mesh)
        })
    }

    /// Returns the level for a view.
    ///
    /// # Errors
    /// If the camera is degenerate.
    pub(super) fn view(&self, args: &RenderArgs, eye: Point) -> Result<Figure, Failure> {
        let Some(ReceivedScene { lods, .. }) = &self.levels else {
            return Err(Failure::internal("a view needs a scene with levels"));
        };
        let view = args.view.on_screen(args.size.0);
        let camera = camera(&view, eye, [0.0; 3], self.mesh.bounds())?;
        let limit = args.level.level.triangle_count();
        let limit = limit.map(|count| count.of_triangles(self.full().triangle_count));
        let Ok(found) = lods.clone().find_for_view(&view.criterion(camera), limit);
        let mesh = self.posed(&found.shape)?;
        let (vertex_count, triangle_count) = (mesh.vertex_count(), mesh.triangle_count());
        let reached = ReachedLevel { vertex_count, triangle_count, stop_reason: found.stop_reason };
        let target = limit.map(Target::Triangles);
        Ok(Figure {
            shortfall: target.and_then(|target| shortfall(target, reached, &self.coarsening_limit())),
            error_is_guaranteed: false,
            pixels: Some(pixels_of(&view, limit, found.relaxation) / lods.least_importance()),
            ..Figure::of_mesh(mesh)
        })
    }

    /// Returns a camera of the document by its number or name. It looks at the height of `center`.
    ///
    /// # Errors
    /// If there is no such camera, or it has no perspective.
    pub(super) fn camera(&self, wanted: &str, center: [f32; 3]) -> Result<Camera, Failure> {
        let names: Vec<&str> = self.cameras.iter().map(|camera| &camera.name[..]).collect();
        let index = find_entry(wanted, &names, "camera")?;
        let DocumentCamera { projection, eye, forward, up, .. } = &self.cameras[index];
        let Projection::Perspective { fov } = *projection else {
            return Err(Failure::user(format!(
                "camera {wanted} is orthographic; pictures are in perspective"
            ))
            .with_hint("place the camera with --from, --turn or --rise"));
        };
        // The farther the point, the less its rounding turns the camera.
        let offset: f32 = (0..3).map(|k| (center[k] - eye[k]).powi(2)).sum::<f32>().sqrt();
        let distance = if offset > 0.0 && offset.is_finite() { offset } else { 1.0 };
        let look_at = [0, 1, 2].map(|k| eye[k] + distance * forward[k]);
        Ok(Camera { eye: *eye, look_at, up: *up, fov })
    }

    fn posed(&self, scene: &Scene) -> Result<IndexedMesh, Failure> {
        posed_mesh(scene, &self.poser, &self.pose).map_err(|error| Failure::internal(error.to_string()))
    }

    fn coarsening_limit(&self) -> CoarseningLimit {
        if self.is_built {
            CoarseningLimit::Simplification(
                "no more edges can be collapsed without removing the last triangles".to_owned(),
            )
        } else {
            CoarseningLimit::File
        }
    }
}

/// Builds the levels of a scene for a picture.
fn build(input: &Input, scene: &Scene, progress: &mut ProgressFn<'_>) -> Result<ReceivedScene, Failure> {
    let built = LodScene::build_with_progress(scene, &LodOptions::default(), progress);
    let built = built.map_err(|error| Failure::user(format!("{}: {error}", input.name)))?;
    Ok(ReceivedScene::complete(built))
}

/// Checks that no flag was given that needs a scene.
fn refuse_scene_flags(args: &RenderArgs, name: &str, reason: &str) -> Result<(), Failure> {
    let flags = [
        ("--time", args.pose.time.is_some()),
        ("--animation", args.pose.animation.is_some()),
        ("--camera", args.camera.is_some()),
    ];
    match flags.into_iter().find(|&(_, is_given)| is_given) {
        None => Ok(()),
        Some((flag, _)) => Err(Failure::user(format!("{flag} is for scenes, but {name} {reason}"))
            .with_hint(format!("remove {flag}"))),
    }
}

/// Returns the pose that the flags ask for.
///
/// # Errors
/// If there is no such animation.
fn pose(args: &RenderArgs, poser: &Poser, input: &Input, output: &Output) -> Result<Pose, Failure> {
    let Some((animation, time)) = args.pose.choose(poser, &input.name)? else {
        return Ok(poser.rest_pose());
    };
    let duration = poser.duration(animation);
    if time > duration {
        output.say(&format!("note: animation {animation} ends after {duration} seconds; showing its end"));
    }
    Ok(poser.pose(animation, time))
}
