//! A level to draw, and how it is colored.

use std::borrow::Cow;

use striata::levels::FoundLevel;
use striata::mesh::IndexedMesh;
use striata::model::ModelKind;
use striata::simplify::Target;
use striata::strip::{StripIndices, StripSet, stripify};

use crate::commands::levels::pixels_of;
use striata_command::args::{Coloring, ViewArgs};
use striata_command::failure::Failure;
use striata_command::fan_cover::cover_with_fans;
use striata_command::level::{CoarseningLimit, ReachedLevel, shortfall};
use striata_render::{
    Paint, SceneLook, Shot, Style, fan_colors, fragment_colors, group_colors, strip_colors, triangle_colors,
    with_normals,
};

/// A level to draw.
#[derive(Clone)]
pub(super) struct Figure {
    /// Title above the level.
    pub title: String,
    /// The mesh, whose vertices have normals.
    pub mesh: IndexedMesh,
    /// Strips of the level, if the model has strips.
    pub strips: Option<StripSet>,
    /// The step that inserted each triangle, if this is a uniform level; `None` for those of the base mesh.
    pub steps: Option<Vec<Option<u32>>>,
    /// Name of the model that provided the level.
    pub model: &'static str,
    /// Split count, for levels of a sequence.
    pub split_count: Option<usize>,
    pub vertex_count: usize,
    /// Distance from the original, mesh units.
    pub error: f32,
    pub error_is_guaranteed: bool,
    /// For views: the pixel tolerance.
    pub pixels: Option<f64>,
    /// How the level misses its target, if it does.
    pub shortfall: Option<String>,
}

impl Figure {
    /// Creates a figure of a mesh without levels.
    pub(super) fn of_mesh(mesh: IndexedMesh) -> Self {
        Self {
            title: String::new(),
            vertex_count: mesh.vertex_count(),
            mesh,
            strips: None,
            steps: None,
            model: "list",
            split_count: None,
            error: 0.0,
            error_is_guaranteed: true,
            pixels: None,
            shortfall: None,
        }
    }

    /// Creates a figure of the level for a view, which had to respect the triangle limit, if there is one.
    pub(super) fn of_view(
        model: ModelKind,
        level: FoundLevel<IndexedMesh>,
        view: &ViewArgs,
        triangle_limit: Option<usize>,
    ) -> Self {
        let FoundLevel { vertex_count, triangle_count, stop_reason, .. } = level;
        let reached = ReachedLevel { vertex_count, triangle_count, stop_reason };
        let target = triangle_limit.map(Target::Triangles);
        Self {
            shortfall: target.and_then(|target| shortfall(target, reached, &CoarseningLimit::File)),
            model: model.as_str(),
            split_count: Some(level.split_count),
            error: level.error.unwrap_or_default() as f32,
            error_is_guaranteed: false,
            pixels: Some(pixels_of(view, triangle_limit, level.relaxation)),
            ..Self::of_mesh(with_normals(level.shape))
        }
    }

    /// Colors the level.
    ///
    /// # Errors
    /// If the steps that inserted the triangles are not known, or strips cannot be made, which is an internal error.
    pub(super) fn painted(&self, coloring: Coloring) -> Result<ColoredLevel, Failure> {
        let (triangles, colors) = match coloring {
            Coloring::Surface => {
                let strips = self.strips.as_ref().map(StripSet::to_restart_indices);
                return Ok(ColoredLevel { triangles: None, paint: Paint::Surface, strips });
            }
            Coloring::Strips => match &self.strips {
                Some(strips) => strip_colors(strips),
                None => strip_colors(&stripify(&self.mesh)?),
            },
            Coloring::Fans => fan_colors(&cover_with_fans(&self.mesh)),
            Coloring::Triangles => triangle_colors(&self.mesh.triangles),
            Coloring::Groups => group_colors(&self.mesh),
            Coloring::Fragments => match &self.steps {
                Some(steps) => fragment_colors(&self.mesh.triangles, steps),
                None => return Err(without_steps()),
            },
        };
        Ok(ColoredLevel { triangles: Some(triangles), paint: Paint::Triangles(colors), strips: None })
    }
}

fn without_steps() -> Failure {
    Failure::usage("--colors fragments shows uniform levels of one mesh, not views or paged files")
        .with_hint("use --triangles or --levels, or other --colors")
}

/// A colored level.
pub(super) struct ColoredLevel {
    /// Triangles, if coloring requires a different order from that of the level.
    triangles: Option<Vec<[u32; 3]>>,
    paint: Paint,
    strips: Option<StripIndices>,
}

impl ColoredLevel {
    /// Returns the shot that draws the level.
    pub(super) fn shot<'s>(
        &'s self,
        mesh: &'s IndexedMesh,
        look: Option<&'s SceneLook>,
        style: Style,
    ) -> Shot<'s> {
        let shot = Shot::of(mesh, self.paint.clone(), style);
        let triangles = self.triangles.as_ref().map_or(shot.triangles, |t| Cow::Borrowed(&t[..]));
        Shot { triangles, strips: self.strips.as_ref(), look, ..shot }
    }
}
