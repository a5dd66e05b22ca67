//! The layout of a picture in panels, and drawing them.

use std::borrow::Cow;

use super::figure::Figure;
use super::source::PictureSource;
use super::viewpoint::Viewpoint;
use crate::args::RenderArgs;
use striata::mesh::without_copies;
use striata_command::args::Coloring;
use striata_command::failure::Failure;
use striata_command::output::format_noun_count;
use striata_render::{
    Camera, Canvas, ColorBar, DistanceMap, Paint, Panel, SceneLook, Sheet, Shot, Style, Theme, significant,
    with_all_normals,
};
use striata_viewer::PictureRenderer;

/// A picture that is ready to be drawn.
pub(super) struct Layout<'a> {
    args: &'a RenderArgs,
    source: &'a PictureSource<'a>,
    figures: &'a [Figure],
    viewpoint: &'a Viewpoint,
    /// Distances from the original to each level, if the picture shows them.
    pub heats: Vec<DistanceMap>,
    /// Distance at the end of the color scale.
    pub heat_top: f64,
    diagonal: f64,
    sheet: Sheet,
}

/// The finished picture.
pub(super) struct FinishedPicture {
    pub canvas: Canvas,
    /// Time to draw one frame of all panels, seconds.
    pub frame_secs: f64,
}

impl<'a> Layout<'a> {
    /// Chooses the arrangement of the panels and measures distances.
    ///
    /// # Errors
    /// If a distance cannot be measured, which is an internal error.
    pub(super) fn new(
        args: &'a RenderArgs,
        source: &'a PictureSource<'a>,
        figures: &'a [Figure],
        viewpoint: &'a Viewpoint,
    ) -> Result<Self, Failure> {
        let original = source.mesh();
        let heats = if args.heat {
            figures.iter().map(|figure| DistanceMap::of(original, &figure.mesh)).collect::<Result<_, _>>()?
        } else {
            Vec::new()
        };
        let largest = heats.iter().map(|heat: &DistanceMap| heat.max).fold(0.0, f64::max);
        let diagonal = source.diagonal();
        let heat_top = args.heat_max.map_or(largest, |top| top.in_units(diagonal));
        let size = args.size.0.map(|side| side as usize);
        let make = |[columns, rows]: [usize; 2]| {
            let mut sheet = Sheet::new(size, columns, rows);
            if args.levels.is_some() {
                sheet = sheet.with_text(args.colors.len() > 1);
            }
            if args.heat { sheet.with_bar(ColorBar::up_to(heat_top, largest)) } else { sheet }
        };
        let sheet = make(grid(args, figures.len(), viewpoint, &make));
        Ok(Self { args, source, figures, viewpoint, heats, heat_top, diagonal, sheet })
    }

    /// Draws all panels and assembles the picture.
    ///
    /// # Errors
    /// If strips or fans for coloring cannot be made.
    pub(super) fn draw(
        &self,
        artist: &mut PictureRenderer,
        theme: &Theme,
    ) -> Result<FinishedPicture, Failure> {
        let size = self.sheet.panel_size();
        let camera = self.viewpoint.camera(size[0] as f32 / size[1] as f32);
        let (mut panels, mut frame_secs) = (Vec::new(), 0.0);
        for &coloring in &self.args.colors {
            for (number, figure) in self.figures.iter().enumerate() {
                let drawn = self.draw_one((number, figure), coloring, artist, (&camera, size))?;
                frame_secs += drawn.secs;
                let (title, caption) = (figure.title.clone(), self.caption(number, figure));
                panels.push(Panel { canvas: drawn.canvas, title, caption });
            }
        }
        Ok(FinishedPicture { canvas: self.sheet.assemble(&panels, theme), frame_secs })
    }

    fn draw_one(
        &self,
        (number, figure): (usize, &Figure),
        coloring: Coloring,
        artist: &mut PictureRenderer,
        (camera, size): (&Camera, [usize; 2]),
    ) -> Result<striata_render::Drawn, Failure> {
        let draw = |mut shot: Shot<'_>, artist: &mut PictureRenderer| {
            if let Some(frustum) = &self.viewpoint.frustum {
                frustum.draw_into(&mut shot);
            }
            artist.draw(&shot, camera, size)
        };
        let style = Style { has_edges: self.args.wireframe, is_flat: self.args.flat };
        if let Some(heat) = self.heats.get(number) {
            let original = with_all_normals(self.source.mesh());
            return Ok(draw(Shot::of(&original, Paint::Vertices(heat.colors(self.heat_top)), style), artist));
        }
        let painted = figure.painted(coloring)?;
        let is_lit = coloring == Coloring::Surface && !self.args.wireframe;
        let look = self.source.look().filter(|_| is_lit);
        let mesh = match is_lit && figure.strips.is_none() && !look.is_some_and(SceneLook::is_transparent) {
            true => without_copies(&figure.mesh),
            false => Cow::Borrowed(&figure.mesh),
        };
        match look {
            // Materials show vertices without normals flat, as glTF prescribes.
            Some(look) => Ok(draw(painted.shot(&mesh, Some(look), style), artist)),
            None => Ok(draw(painted.shot(&with_all_normals(&mesh), None, style), artist)),
        }
    }

    fn caption(&self, number: usize, figure: &Figure) -> String {
        let triangles = format_noun_count(figure.mesh.triangle_count(), "triangle", "triangles");
        let percent = |distance: f64| significant(100.0 * distance / self.diagonal, 2);
        match (self.heats.get(number), &figure.strips) {
            (Some(heat), _) if heat.max > 0.0 => format!("{triangles}, up to {} % away", percent(heat.max)),
            (None, Some(strips)) if self.args.colors.contains(&Coloring::Strips) => {
                format!("{triangles}, {}", format_noun_count(strips.strip_count(), "strip", "strips"))
            }
            (None, _) if figure.error > 0.0 => {
                format!("{triangles}, error {} %", percent(f64::from(figure.error)))
            }
            _ => triangles,
        }
    }
}

/// Returns the number of columns and rows: a row per coloring, or else the arrangement that shows levels
/// largest.
fn grid(
    args: &RenderArgs,
    count: usize,
    viewpoint: &Viewpoint,
    make: &impl Fn([usize; 2]) -> Sheet,
) -> [usize; 2] {
    if args.colors.len() > 1 {
        return [count, args.colors.len()];
    }
    if let Some(rows) = args.rows {
        let rows = usize::from(rows).min(count);
        return [count.div_ceil(rows), rows];
    }
    let aspect = viewpoint.aspect().unwrap_or(1.0);
    let shown = |&columns: &usize| {
        let [width, height] = make([columns, count.div_ceil(columns)]).panel_size();
        (width as f32).min(height as f32 * aspect)
    };
    // Of equally good arrangements, `max_by` returns the last one, which has the fewest rows.
    let columns = (1..=count).max_by(|a, b| shown(a).total_cmp(&shown(b))).unwrap_or(1);
    [columns, count.div_ceil(columns)]
}
