//! A level that is drawn, and how it is colored.

use std::borrow::Cow;

use striata::mesh::IndexedMesh;
use striata::model::ModelKind;
use striata::simplify::Target;
use striata::strip::{StripIndices, StripSet, stripify};

use crate::commands::extract::ViewLevel;
use striata_command::args::Coloring;
use striata_command::failure::Failure;
use striata_command::fan_cover::cover_with_fans;
use striata_command::level::{CoarseningLimit, ReachedLevel, shortfall};
use striata_viewer::picture::{
    Paint, Shot, Style, fan_colors, group_colors, strip_colors, triangle_colors, with_normals,
};

/// A level that is drawn.
pub(super) struct Figure {
    /// What stands above it.
    pub(super) title: String,
    /// Its triangles, over vertices with normals.
    pub(super) mesh: IndexedMesh,
    /// As the model hands them over, where it is one of strips.
    pub(super) strips: Option<StripSet>,
    /// Who handed it over.
    pub(super) model: &'static str,
    /// Of a level of a sequence.
    pub(super) split_count: Option<usize>,
    pub(super) vertex_count: usize,
    /// How far it is from the original, mesh units.
    pub(super) error: f32,
    pub(super) error_is_guaranteed: bool,
    /// Of a view: pixels that an error may take.
    pub(super) pixels: Option<f64>,
    /// Why it is not what was asked for, if it is not.
    pub(super) shortfall: Option<String>,
}

impl Figure {
    /// A mesh as it is.
    pub(super) fn of_mesh(mesh: IndexedMesh) -> Self {
        Self {
            title: String::new(),
            vertex_count: mesh.vertex_count(),
            mesh,
            strips: None,
            model: "list",
            split_count: None,
            error: 0.0,
            error_is_guaranteed: true,
            pixels: None,
            shortfall: None,
        }
    }

    /// The level of a view, which was to have no more than so many triangles if that was said.
    pub(super) fn of_view(model: ModelKind, level: ViewLevel, triangle_limit: Option<usize>) -> Self {
        let reached = ReachedLevel {
            vertex_count: level.mesh.vertex_count(),
            triangle_count: level.mesh.triangle_count(),
            stop_reason: level.stop_reason,
        };
        let target = triangle_limit.map(Target::Triangles);
        Self {
            shortfall: target.and_then(|target| shortfall(target, reached, &CoarseningLimit::File)),
            model: model.as_str(),
            split_count: Some(level.split_count),
            error: level.error,
            error_is_guaranteed: false,
            pixels: Some(level.pixels),
            ..Self::of_mesh(with_normals(level.mesh))
        }
    }

    /// What a shot of it shows, in some colors.
    ///
    /// # Errors
    /// Where strips cannot be made, which is our fault.
    pub(super) fn painted(&self, coloring: Coloring) -> Result<Painted, Failure> {
        let (triangles, colors) = match coloring {
            Coloring::Surface => {
                let strips = self.strips.as_ref().map(StripSet::to_restart_indices);
                return Ok(Painted { triangles: None, paint: Paint::Surface, strips });
            }
            Coloring::Strips => match &self.strips {
                Some(strips) => strip_colors(strips),
                None => strip_colors(&stripify(&self.mesh)?),
            },
            Coloring::Fans => fan_colors(&cover_with_fans(&self.mesh)),
            Coloring::Triangles => triangle_colors(&self.mesh.triangles),
            Coloring::Groups => group_colors(&self.mesh),
        };
        Ok(Painted { triangles: Some(triangles), paint: Paint::Triangles(colors), strips: None })
    }
}

/// A level in its colors.
pub(super) struct Painted {
    /// In another order than the level's, where colors need one.
    triangles: Option<Vec<[u32; 3]>>,
    paint: Paint,
    strips: Option<StripIndices>,
}

impl Painted {
    /// The shot of it.
    pub(super) fn shot<'s>(&'s self, mesh: &'s IndexedMesh, style: Style) -> Shot<'s> {
        let shot = Shot::of(mesh, self.paint.clone(), style);
        let triangles = self.triangles.as_ref().map_or(shot.triangles, |t| Cow::Borrowed(&t[..]));
        Shot { triangles, strips: self.strips.as_ref(), ..shot }
    }
}
