//! The demo's pictures: shaded levels, strips, wireframes, error heat maps, and a view-dependent level.

use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::model::{FanInstance, FanScene, Fans, LodModel, StripModel as _};
use striata::view::ScreenError;

use super::levels::{percent, split_count_at};
use crate::commands::build::BuildOutput;
use striata_command::args::tan;
use striata_command::failure::Failure;
use striata_command::output::format_count;
use striata_render::{
    Camera, ColorBar, DistanceMap, Frustum, Paint, Panel, Sheet, Shot, Style, Theme, ViewAngles,
    strip_colors, with_normals,
};
use striata_viewer::PictureRenderer;

/// Fractions of the triangles of the levels in the pictures.
const SHARES: [f64; 4] = [1.0, 0.1, 0.02, 0.005];

/// Camera angles for the bust.
const PORTRAIT: ViewAngles = ViewAngles { turn: -0.62, rise: 0.04, up: [0.0, 1.0, 0.0], fov: 0.47 };

/// A picture of the demo.
pub(super) struct Picture {
    /// File name.
    pub name: &'static str,
    /// Short description.
    pub what: &'static str,
    /// Text on the page.
    pub text: &'static str,
    /// Contents of the PNG file.
    pub png: Vec<u8>,
}

/// Draws all pictures.
///
/// # Errors
/// If a distance cannot be measured, which is an internal error.
pub(super) fn draw_all(built: &BuildOutput, artist: &mut PictureRenderer) -> Result<Vec<Picture>, Failure> {
    let RefinableMesh { mesh, sequence } = built.refinable().clone();
    let refinable = RefinableMesh { mesh: with_normals(mesh), sequence };
    let mut studio = DemoStudio { built, refinable, artist };
    Ok(vec![
        Picture {
            name: "levels.png",
            what: "four levels, shaded and as strips",
            text: "Top: levels shaded with the normals of the full mesh, which remain valid because no \
                   vertex moves. Bottom: the triangle strips that are drawn. They are made once, at full \
                   detail, and adapted to every level.",
            png: studio.levels()?,
        },
        Picture {
            name: "wireframe.png",
            what: "the same levels with their edges",
            text: "Flat regions lose triangles first; eyes, lips and the rim of the crown keep theirs.",
            png: studio.wireframes()?,
        },
        Picture {
            name: "heat.png",
            what: "how far three levels are from the original",
            text: "Distance from each vertex of the original to the level, in mesh units. The end of the \
                   color bar is the largest distance of the three levels.",
            png: studio.heat()?,
        },
        Picture {
            name: "view.png",
            what: "a view-dependent level, seen from outside",
            text: "Detail only where one camera needs it: the region inside the outlined frustum is \
                   refined until no error exceeds two pixels; everything else stays coarse.",
            png: studio.view()?,
        },
    ])
}

struct DemoStudio<'a> {
    built: &'a BuildOutput,
    refinable: RefinableMesh,
    artist: &'a mut PictureRenderer,
}

impl DemoStudio<'_> {
    fn levels(&mut self) -> Result<Vec<u8>, Failure> {
        let sheet = Sheet::new([1280, 980], SHARES.len(), 2).with_text(true);
        let mut panels = Vec::new();
        for share in SHARES {
            let level = self.level(share);
            panels.push(self.panel(share, &Shot::of(&level, Paint::Surface, Style::SMOOTH), &sheet));
        }
        for share in SHARES {
            let level = self.level(share);
            let mut state = self.built.lod_strips().new_state();
            self.built.lod_strips().move_to(&mut state, split_count_at(self.built, share));
            let strips = self.built.lod_strips().strips_at(&state);
            let (triangles, colors) = strip_colors(&strips);
            let painted = Shot::of(&level, Paint::Triangles(colors), Style::FLAT);
            panels.push(self.panel(share, &Shot { triangles: triangles.into(), ..painted }, &sheet));
        }
        finish(&sheet, &panels)
    }

    fn wireframes(&mut self) -> Result<Vec<u8>, Failure> {
        let sheet = Sheet::new([1280, 520], SHARES.len(), 1).with_text(true);
        let mut panels = Vec::new();
        for share in SHARES {
            let level = self.level(share);
            panels.push(self.panel(share, &Shot::of(&level, Paint::Surface, Style::FACETED), &sheet));
        }
        finish(&sheet, &panels)
    }

    fn heat(&mut self) -> Result<Vec<u8>, Failure> {
        let shares = &SHARES[1..];
        let heats = shares.iter().map(|&share| DistanceMap::of(&self.refinable.mesh, &self.level(share)));
        let heats: Vec<DistanceMap> = heats.collect::<Result<_, _>>()?;
        let top = heats.iter().map(|heat| heat.max).fold(0.0, f64::max);
        let sheet =
            Sheet::new([1280, 560], shares.len(), 1).with_text(true).with_bar(ColorBar::up_to(top, top));
        let original = self.refinable.mesh.clone();
        let mut panels = Vec::new();
        for (&share, heat) in shares.iter().zip(&heats) {
            let shot = Shot::of(&original, Paint::Vertices(heat.colors(top)), Style::SMOOTH);
            panels.push(self.panel(share, &shot, &sheet));
        }
        finish(&sheet, &panels)
    }

    fn view(&mut self) -> Result<Vec<u8>, Failure> {
        const SIZE: [usize; 2] = [1280, 800];
        const FOV: f32 = 0.42;
        let Some(bounds) = self.refinable.mesh.bounds() else {
            return Err(Failure::internal("the bust has no positions"));
        };
        let at =
            |share: [f32; 3]| [0, 1, 2].map(|k| bounds.min[k] + share[k] * (bounds.max[k] - bounds.min[k]));
        // In front of the face, slightly to its side.
        let (eye, look_at, up) = (at([0.15, 0.62, 2.3]), at([0.5, 0.45, 0.8]), [0.0, 1.0, 0.0]);
        let camera = striata::view::Camera::new(eye, look_at, up, tan(f64::from(FOV) / 2.0), [1920, 1080]);
        let camera = camera.map_err(|error| Failure::internal(error.to_string()))?;
        let fans = Fans::build(&self.refinable);
        let mut instance = FanInstance::full(&fans);
        instance
            .refine(&FanScene::new(&fans, &self.refinable.mesh.positions), &ScreenError::new(camera, 2.0));
        let level = instance.level(&fans, &self.refinable);
        let seen = Camera { eye, look_at, up, fov: FOV };
        let frustum = Frustum::new(&seen, 16.0 / 9.0, &self.refinable.mesh.positions);
        let mut shot = Shot::of(&level, Paint::Surface, Style::FACETED);
        frustum.draw_into(&mut shot);
        let points = [self.refinable.mesh.positions.clone(), frustum.points()].concat();
        let angles = ViewAngles { turn: 1.35, rise: 0.22, ..PORTRAIT };
        let sheet = Sheet::new(SIZE, 1, 1).with_text(true);
        let [width, height] = sheet.panel_size();
        let outside = Camera::around(&points, &angles, width as f32 / height as f32);
        let canvas = self.artist.draw(&shot, &outside, [width, height]).canvas;
        let full = self.refinable.mesh.triangle_count();
        let caption = format!("{} of {} triangles", format_count(level.triangle_count()), format_count(full));
        let title = "view-dependent level".to_owned();
        finish(&sheet, &[Panel { canvas, title, caption }])
    }

    fn level(&self, share: f64) -> IndexedMesh {
        striata::mesh::replay(&self.refinable, split_count_at(self.built, share))
    }

    fn panel(&mut self, share: f64, shot: &Shot<'_>, sheet: &Sheet) -> Panel {
        let size = sheet.panel_size();
        let camera =
            Camera::around(&self.refinable.mesh.positions, &PORTRAIT, size[0] as f32 / size[1] as f32);
        let canvas = self.artist.draw(shot, &camera, size).canvas;
        let sequence = &self.refinable.sequence;
        let count = sequence.triangle_count_at(split_count_at(self.built, share));
        Panel { canvas, title: percent(share), caption: format!("{} triangles", format_count(count)) }
    }
}

/// Assembles the panels into a PNG file.
///
/// # Errors
/// If the file cannot be encoded, which is an internal error.
pub(super) fn finish(sheet: &Sheet, panels: &[Panel]) -> Result<Vec<u8>, Failure> {
    let canvas = sheet.assemble(panels, &Theme::DARK);
    canvas.to_png().map_err(|error| Failure::internal(format!("PNG: {error}")))
}
