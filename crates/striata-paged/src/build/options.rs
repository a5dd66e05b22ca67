//! Options of a build.

use std::path::Path;

use serde::{Deserialize, Serialize};
use striata::simplify::cells::CellOptions;
use striata::simplify::{AttributeWeights, BoundaryRule, SeamRule, SequenceOptions, TopologyRule};

use striata_io::pieces::PieceOptions;

use crate::Metadata;

/// A limit, absolute or relative to the whole mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// A number of triangles, or a distance in mesh units.
    Absolute(f64),
    /// A fraction of the triangles, or of the diagonal of the bounding box.
    Share(f64),
}

impl Limit {
    pub(super) fn of(self, whole: f64) -> f64 {
        match self {
            Self::Absolute(limit) => limit,
            Self::Share(share) => share * whole,
        }
    }
}

/// Options of a build.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BuildOptions {
    /// Triangles of a cell of the finest level; default 65,536.
    pub cell: usize,
    /// Whether positions and attributes are kept bit for bit instead of being rounded; default no, which rounds
    /// positions to at most 1/256 of the median edge.
    pub exact: bool,
    /// Distance in mesh units below which positions on borders are welded, transitively up to twice that distance;
    /// default none.
    pub weld_distance: Option<f64>,
    /// Factor for the heights of a terrain; default 1.
    pub z_scale: f64,
    /// Another sample value of a raster that means "no height", in addition to the one that the file names;
    /// default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nodata: Option<f64>,
    /// Weight of normals; see [`AttributeWeights`].
    pub normal_weight: f32,
    /// Weight of texture coordinates.
    pub texcoord_weight: f32,
    /// Weight of colors.
    pub color_weight: f32,
    /// Whether rounding may merge more than one in a thousand vertices; default no, which is an error.
    pub allow_merging: bool,
    /// Whether the topology may change, so that small parts vanish; default yes.
    pub change_topology: bool,
    /// Whether every connected part keeps a triangle, although the topology may change; default no.
    pub keep_parts: bool,
    /// Whether all vertices on boundaries are kept; default no.
    pub lock_boundary: bool,
    /// Whether all vertices on borders between groups are kept; default no.
    pub lock_groups: bool,
    /// Whether seams only collapse along themselves; default no.
    pub keep_seams: bool,
    /// Whether no triangle may turn over in plan, seen along the z axis; default if the input is a terrain.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub height_field: Option<bool>,
    /// Number of triangles at which the coarsest level stops; default none, which simplifies as far as possible.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base: Option<Limit>,
    /// Largest estimated error of any level; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_error: Option<Limit>,
    /// Whether a coarsest level of more triangles than `base` is an error, so that nothing is written; default no.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub strict: bool,
    /// Pieces that one task sorts; default 8, about 800,000 triangles.
    pub pieces_per_task: u64,
    /// Cells that one task simplifies or encodes; default 16, about a million triangles.
    pub cells_per_task: u64,
}

impl Default for BuildOptions {
    fn default() -> Self {
        let weights = AttributeWeights::default();
        Self {
            cell: 65_536,
            exact: false,
            weld_distance: None,
            z_scale: 1.0,
            nodata: None,
            normal_weight: weights.normal,
            texcoord_weight: weights.texcoord,
            color_weight: weights.color,
            allow_merging: false,
            change_topology: true,
            keep_parts: false,
            lock_boundary: false,
            lock_groups: false,
            keep_seams: false,
            height_field: None,
            base: None,
            max_error: None,
            strict: false,
            pieces_per_task: 8,
            cells_per_task: 16,
        }
    }
}

impl BuildOptions {
    /// How the input is opened; temporary files are in the work folder.
    pub(super) fn piece_options(&self, folder: &Path) -> PieceOptions {
        let options = PieceOptions::default().with_scratch(folder.to_owned());
        options.with_z_scale(self.z_scale).with_nodata(self.nodata)
    }

    /// Number of triangles at which the coarsest level of a mesh stops. A share gives at least 2, the fewest that a
    /// closed surface can have.
    pub(super) fn base_triangle_count(&self, triangle_count: u64) -> u64 {
        match self.base {
            None => 0,
            Some(base) => (base.of(triangle_count as f64) as u64).max(match base {
                Limit::Share(share) if share > 0.0 => 2,
                _ => 0,
            }),
        }
    }

    /// Options of the cells of one level of a mesh, which may be a terrain.
    pub(super) fn cell_options(&self, metadata: &Metadata, is_terrain: bool, is_last: bool) -> CellOptions {
        let weights = AttributeWeights {
            normal: self.normal_weight,
            texcoord: self.texcoord_weight,
            color: self.color_weight,
            ..AttributeWeights::default()
        };
        let topology = match (self.change_topology, self.keep_parts) {
            (false, _) => TopologyRule::Keep,
            (true, true) => TopologyRule::KeepParts,
            (true, false) => TopologyRule::Change,
        };
        let rule = |is_locked| if is_locked { BoundaryRule::Locked } else { BoundaryRule::Kept };
        let base = if is_last { self.base_triangle_count(metadata.triangle_count) } else { 0 };
        let mut sequence = SequenceOptions::default()
            .with_base_triangle_count(base as usize)
            .with_height_field(self.height_field.unwrap_or(is_terrain))
            .with_attribute_weights(weights)
            .with_topology(topology)
            .with_boundary(rule(self.lock_boundary))
            .with_group_borders(rule(self.lock_groups))
            .with_seams(if self.keep_seams { SeamRule::Keep } else { SeamRule::Cross });
        sequence.max_error = self.max_error.map(|error| error.of(metadata.diagonal()));
        let options = CellOptions::new(metadata.diagonal())
            .with_sequence(sequence)
            .with_materials(metadata.groups.iter().map(|group| group.material).collect());
        if is_last { options.with_keep(0.0) } else { options }
    }
}
