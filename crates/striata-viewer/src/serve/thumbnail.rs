//! `thumbnail`: draws one small picture, within limits on memory and time that a server can rely on.

use std::fs::File;
use std::io::Read as _;
use std::path::Path;

use striata::levels::Levels as _;
use striata::mesh::IndexedMesh;
use striata::simplify::Target;
use striata_io::SceneError;
use striata_scene::Poser;
use striata_scene::drawn::{ImageLimits, lights, posed_mesh};

use crate::serve::args::ThumbnailArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Output, to_stdout};
use striata_command::scene::SceneKind;
use striata_paged::{HEAD_NAME, PAGED_MAGIC, PagedError, PagedFile};
use striata_render::{SceneLook, portrait, with_normals};
use striata_stream::StreamLevels;

/// Width in pixels.
pub(super) const WIDTH: usize = 320;
/// Height in pixels.
pub(super) const HEIGHT: usize = 240;
/// Maximum number of triangles; more would be smaller than pixels.
const MAX_TRIANGLES: usize = 40_000;
/// Longest side of a texture, pixels.
const MAX_IMAGE_SIDE: u32 = 512;
/// Size of all textures together, bytes of pixels.
const MAX_IMAGE_BYTES: u64 = 256 << 20;
/// Memory limit of the process.
#[cfg(unix)]
const MAX_MEMORY_BYTES: u64 = 3 << 30;
/// CPU time limit of the process, seconds.
#[cfg(unix)]
const MAX_CPU_SECS: u64 = 20;

/// Draws the thumbnail and writes it to stdout.
///
/// # Errors
/// If the file cannot be read.
pub fn run(args: &ThumbnailArgs, output: &Output) -> Result<(), Failure> {
    limit_this_process();
    if is_paged(&args.input) {
        return draw(coarse_level(&args.input)?, None);
    }
    let input = Input::open(&args.input)?.within_folder();
    let (mesh, look) = match input.scene_kind() {
        Some(kind) => posed_scene(&input, kind, output)?,
        None => {
            let mut mesh = mesh_of(&input, output)?;
            mesh.check()?;
            let look = SceneLook::of_mesh(&mesh, &image_limits());
            if look.is_some() {
                mesh = with_normals(mesh);
            }
            (mesh, look)
        }
    };
    draw(mesh, look.as_ref())
}

/// Whether a file has pages, of which only a few are read.
fn is_paged(path: &Path) -> bool {
    let mut magic = [0; PAGED_MAGIC.len()];
    File::open(path).is_ok_and(|mut file| file.read_exact(&mut magic).is_ok()) && magic == *PAGED_MAGIC
}

/// Reads a coarse level of a paged file.
///
/// # Errors
/// If the head or a page is damaged.
fn coarse_level(path: &Path) -> Result<IndexedMesh, Failure> {
    let name = path.display();
    let failed = |error: PagedError| Failure::user(format!("{name}: {error}"));
    let mut file = PagedFile::open(&folder_of_pages(path).to_string_lossy()).map_err(failed)?;
    let mesh = file.find(Target::Triangles(MAX_TRIANGLES)).map_err(failed)?.shape;
    mesh.check()?;
    Ok(mesh)
}

/// The folder, if the file is the head of one.
fn folder_of_pages(path: &Path) -> &Path {
    match (path.parent(), path.file_name().is_some_and(|name| name == HEAD_NAME)) {
        (Some(folder), true) => folder,
        _ => path,
    }
}

fn draw(mesh: IndexedMesh, look: Option<&SceneLook>) -> Result<(), Failure> {
    let picture = portrait(mesh, look, [WIDTH, HEIGHT]).to_png();
    to_stdout(&picture.map_err(|error| Failure::internal(format!("cannot encode the thumbnail: {error}")))?)
}

/// Limits memory and CPU time; on other systems, the server kills the process when it takes too long.
fn limit_this_process() {
    #[cfg(unix)]
    {
        let _ = rlimit::setrlimit(rlimit::Resource::AS, MAX_MEMORY_BYTES, MAX_MEMORY_BYTES);
        let _ = rlimit::setrlimit(rlimit::Resource::CPU, MAX_CPU_SECS, MAX_CPU_SECS);
    }
}

/// Limits of textures, which have far more pixels than a thumbnail otherwise.
fn image_limits() -> ImageLimits {
    ImageLimits::default().with_max_side(MAX_IMAGE_SIDE).with_total_bytes(MAX_IMAGE_BYTES)
}

/// Reads a scene at a level that is fine enough, in the pose of its nodes, with its materials if it has some.
///
/// # Errors
/// If the file is malformed.
fn posed_scene(
    input: &Input,
    kind: SceneKind,
    output: &Output,
) -> Result<(IndexedMesh, Option<SceneLook>), Failure> {
    let failed = |error: SceneError| Failure::user(format!("{}: {error}", input.name));
    let scene = if kind == SceneKind::Gltf {
        input.scene(output)?
    } else {
        let lods = input.received_scene(output)?.lods;
        lods.level_scene(&lods.level(Target::Triangles(MAX_TRIANGLES)))
    };
    let poser = Poser::new(&scene).map_err(failed)?;
    let pose = poser.rest_pose();
    let mesh = posed_mesh(&scene, &poser, &pose).map_err(failed)?;
    let look = SceneLook::is_described(&scene)
        .then(|| SceneLook::of(&scene, &image_limits()).with_lights(lights(&scene, &pose)));
    Ok((mesh, look))
}

/// Reads as much of the mesh as a thumbnail shows; of a stream, only the beginning is decoded.
fn mesh_of(input: &Input, output: &Output) -> Result<IndexedMesh, Failure> {
    if !input.has_levels() {
        return input.mesh(output);
    }
    let damaged = |error| input.damaged(&error);
    let file = input.striata()?;
    if let Some(stream) = file.stream() {
        let is_enough = |decoder: &striata_stream::StreamDecoder| decoder.triangles().len() >= MAX_TRIANGLES;
        let mut levels = StreamLevels::new(stream.map_err(damaged)?).map_err(damaged)?;
        levels.decode_until(is_enough).map_err(damaged)?;
        let decoder = levels.decoder();
        return Ok(IndexedMesh::new(decoder.positions().to_vec(), decoder.triangles().to_vec()));
    }
    let levels = file.levels().map_err(damaged)?;
    let (split_count, _) = Target::Triangles(MAX_TRIANGLES).resolve_in(&levels);
    file.level(split_count).map_err(damaged)
}
