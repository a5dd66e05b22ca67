//! The demo's textured scene: a stream, a viewer page that contains it, and a picture of its levels.

use striata::LodOptions;
use striata::mesh::IndexedMesh;
use striata::simplify::Target;
use striata_io::{Scene, Source, read_scene_bytes};
use striata_scene::drawn::{ImageLimits, posed_mesh};
use striata_scene::stream::{SceneStreamOptions, encode_scene};
use striata_scene::{LodScene, Poser};

use super::folder::DemoFolder;
use super::pictures::{Picture, finish};
use striata_command::failure::Failure;
use striata_command::output::{Bar, format_count};
use striata_render::{Camera, Paint, Panel, SceneLook, Sheet, Shot, Style, ViewAngles};
use striata_viewer::PictureRenderer;
use striata_viewer::viewer_page::self_contained;

/// An amphora on a wheel; for its origin, see `assets/README.md` in the root of the repository.
const AMPHORA: &[u8] = include_bytes!("../../../assets/amphora.glb");

/// File name of the stream.
const STREAM: &str = "amphora.stri";

/// File name of the viewer page.
pub(super) const PAGE: &str = "amphora.html";

/// Fractions of the triangles of the levels in the picture.
const SHARES: [f64; 3] = [1.0, 0.1, 0.02];

/// Camera angles.
const ANGLES: ViewAngles = ViewAngles { turn: 0.3, rise: 0.22, up: [0.0, 1.0, 0.0], fov: 0.47 };

/// Writes the stream and the viewer page, and draws the picture.
///
/// # Errors
/// If a file cannot be written; other errors are internal.
pub(super) fn write(
    folder: &mut DemoFolder<'_>,
    artist: &mut PictureRenderer,
    bar: &mut Bar,
) -> Result<Picture, Failure> {
    let scene = read_scene_bytes(AMPHORA, &Source::new("amphora.glb"))?;
    bar.phase("encode");
    let stream = encode_scene(&scene, &SceneStreamOptions::default()).map_err(internal)?.bytes;
    let what = format!(
        "a textured, animated scene of {} triangles as a stream",
        format_count(scene.triangle_count())
    );
    folder.write(STREAM, &what, &stream)?;
    let page = self_contained(Some((STREAM, &stream)))?;
    folder.write(PAGE, "the viewer, with the scene inside", page.as_bytes())?;
    bar.phase("simplify");
    let lods = LodScene::build_with_progress(&scene, &LodOptions::default(), &mut |at| bar.show(at));
    bar.phase("pictures");
    let picture = Picture {
        name: "amphora.png",
        what: "three levels of the scene",
        text: "A scene keeps its nodes, materials, textures and animations at every level. One priority \
               decides for all of its meshes which triangles go first.",
        png: draw(&scene, &lods.map_err(internal)?, artist)?,
    };
    folder.write(picture.name, picture.what, &picture.png)?;
    Ok(picture)
}

/// Draws levels next to each other.
fn draw(scene: &Scene, lods: &LodScene, artist: &mut PictureRenderer) -> Result<Vec<u8>, Failure> {
    let poser = Poser::new(scene).map_err(internal)?;
    let posed = |scene: &Scene| -> Result<IndexedMesh, Failure> {
        posed_mesh(scene, &poser, &poser.rest_pose()).map_err(internal)
    };
    let full = posed(scene)?;
    let look = SceneLook::of(scene, &ImageLimits::default());
    let sheet = Sheet::new([1280, 560], SHARES.len(), 1).with_text(true);
    let size = sheet.panel_size();
    let camera = Camera::around(&full.positions, &ANGLES, size[0] as f32 / size[1] as f32);
    let mut panels = Vec::new();
    for share in SHARES {
        let count = (share * scene.triangle_count() as f64) as usize;
        let level = lods.level(Target::Triangles(count));
        let mesh = posed(&lods.level_scene(&level))?;
        let shot = Shot { look: Some(&look), ..Shot::of(&mesh, Paint::Surface, Style::SMOOTH) };
        panels.push(Panel {
            canvas: artist.draw(&shot, &camera, size).canvas,
            title: super::levels::percent(share),
            caption: format!("{} triangles", format_count(level.triangle_count)),
        });
    }
    finish(&sheet, &panels)
}

fn internal(error: impl std::fmt::Display) -> Failure {
    Failure::internal(error.to_string())
}
