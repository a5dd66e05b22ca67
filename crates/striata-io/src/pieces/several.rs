//! Several inputs as one.

use std::path::Path;

use striata::mesh::Appearance;

use super::{LayerKind, Piece, PieceGroup, PieceSource, PieceSummary};
use crate::ReadError;

/// Several inputs as one mesh.
pub(super) struct Several {
    sources: Vec<Member>,
    summary: PieceSummary,
}

struct Member {
    source: Box<dyn PieceSource>,
    /// Pieces of the members before this one.
    first_piece: u64,
    /// Groups of the members before this one.
    first_group: u32,
    /// For each layer of the whole, its index in this member.
    layers: Vec<usize>,
}

impl Several {
    pub(super) fn new(sources: Vec<Box<dyn PieceSource>>) -> Self {
        let mut summary = PieceSummary::default();
        let mut first_piece = 0;
        let layers = common_layers(&sources);
        let mut members = Vec::with_capacity(sources.len());
        for source in sources {
            let own = source.summary();
            let find = |kind: &LayerKind| own.layers.iter().position(|other| other == kind);
            let member_layers = layers.iter().filter_map(find).collect();
            let first_group = summary.groups.len() as u32;
            let first_material = summary.appearance.materials.len() as u32;
            summary.groups.extend(own.groups.iter().map(|group| PieceGroup {
                name: if group.name.is_empty() { stem(&own.name) } else { group.name.clone() },
                material: group.material.map(|material| material + first_material),
            }));
            append_appearance(&mut summary.appearance, &own.appearance);
            summary.triangle_count += own.triangle_count;
            summary.byte_count += own.byte_count;
            let count = source.piece_count();
            members.push(Member { source, first_piece, first_group, layers: member_layers });
            first_piece += count;
        }
        summary.layers = layers;
        let first = members.first().map_or(String::new(), |member| member.source.summary().name.clone());
        summary.name = format!("{first} and {} more", members.len().saturating_sub(1));
        Self { sources: members, summary }
    }
}

/// Layers that all sources have.
fn common_layers(sources: &[Box<dyn PieceSource>]) -> Vec<LayerKind> {
    let Some((first, others)) = sources.split_first() else { return Vec::new() };
    let is_common = |kind: &&LayerKind| others.iter().all(|source| source.summary().layers.contains(kind));
    first.summary().layers.iter().filter(is_common).cloned().collect()
}

/// Name of a file without folder and extension.
fn stem(name: &str) -> String {
    Path::new(name).file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Appends materials and images. Textures refer to images by number, so theirs are shifted.
fn append_appearance(all: &mut Appearance, own: &Appearance) {
    if all.is_empty() {
        *all = own.clone();
        return;
    }
    // Numbers of textures inside the JSON of materials would have to be shifted too; only names and factors of
    // materials without textures stay right, so materials of later files lose their textures.
    let has_textures = !own.textures_json.is_empty();
    all.materials.extend(own.materials.iter().map(|material| {
        let mut material = material.clone();
        if has_textures {
            material.gltf_json = String::new();
        }
        material
    }));
}

impl PieceSource for Several {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.sources.last().map_or(0, |last| last.first_piece + last.source.piece_count())
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let at = self.sources.partition_point(|member| member.first_piece <= index).saturating_sub(1);
        let Some(member) = self.sources.get(at) else { return Ok(Piece::default()) };
        let mut piece = member.source.read_piece(index - member.first_piece)?;
        piece.layers = member.layers.iter().map(|&layer| piece.layers[layer].clone()).collect();
        piece.groups.resize(piece.triangles.len(), 0);
        piece.groups.iter_mut().for_each(|group| *group += member.first_group);
        Ok(piece)
    }
}
