//! Several inputs as one.

use std::path::{Path, PathBuf};

use striata::mesh::{AttributeLayer, Semantic};

use super::{LayerKind, Piece, PieceOptions, PieceSource, PieceSummary, appearances, open_pieces};
use crate::error::Place;
use crate::report::Warnings;
use crate::{ReadError, Warning};

/// Several inputs whose pieces follow each other.
///
/// The layers that all inputs have are kept; the summary's warnings name the others. Groups, materials and
/// images are those of the first input, then of the second, and so on.
pub struct Several {
    inputs: Vec<InputPart>,
    summary: PieceSummary,
}

struct InputPart {
    source: Box<dyn PieceSource>,
    /// Number of pieces of the inputs before this one.
    first_piece: u64,
    /// Number of groups of the inputs before this one.
    first_group: u32,
    /// Index of each common layer among the layers of this input, of vertices and of triangles.
    layers: [Vec<usize>; 2],
}

/// Opens files as one input; groups without names get those of their files.
///
/// # Errors
/// [`ReadError`] of a file, or if there is none.
pub fn open_several(paths: &[PathBuf], options: &PieceOptions) -> Result<Several, ReadError> {
    let sources = open_each(paths, options)?;
    let origins = sources.iter().map(|(source, _)| source.summary().origin);
    let origin = origins.clone().find(|&origin| origin != [0.0; 3]);
    match origin.filter(|&common| options.origin.is_none() && origins.clone().any(|own| own != common)) {
        // Borders of neighboring files must round alike.
        Some(common) => Several::new(open_each(paths, &options.clone().with_origin(common))?),
        None => Several::new(sources),
    }
}

/// Files with their names.
type Named = (Box<dyn PieceSource>, String);

fn open_each(paths: &[PathBuf], options: &PieceOptions) -> Result<Vec<Named>, ReadError> {
    let mut sources = Vec::with_capacity(paths.len());
    for path in paths {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        // `a.ply.gz` is `a`.
        let stem = Path::new(stem.as_ref()).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        sources.push((open_pieces(path, options)?, stem));
    }
    Ok(sources)
}

impl Several {
    /// Joins inputs; each one's name is given to its group, if it has a single one without a name.
    ///
    /// # Errors
    /// [`ReadError::Malformed`] if there are no inputs.
    pub fn new(sources: Vec<Named>) -> Result<Self, ReadError> {
        let Some((first, _)) = sources.first() else {
            let (file, place) = ("list of files".to_owned(), Place::File);
            return Err(ReadError::Malformed { file, place, reason: "it names no files".to_owned() });
        };
        let mut summary = PieceSummary { name: first.summary().name.clone(), ..PieceSummary::default() };
        if sources.len() > 1 {
            summary.name = format!("{} and {} more", summary.name, sources.len() - 1);
        }
        summary.origin = first.summary().origin;
        summary.georeference = first.summary().georeference.clone();
        let color_space = |source: &dyn PieceSource| source.summary().appearance.color_space;
        let have_one_space =
            sources.iter().all(|(source, _)| color_space(&**source) == color_space(&**first));
        let common = |layers: fn(&PieceSummary) -> &Vec<LayerKind>| -> Vec<LayerKind> {
            let is_common = |kind: &&LayerKind| {
                (have_one_space || !matches!(kind.semantic, Semantic::Color(_)))
                    && sources.iter().all(|(source, _)| layers(source.summary()).contains(kind))
            };
            layers(first.summary()).iter().filter(is_common).cloned().collect()
        };
        summary.layers = common(|summary| &summary.layers);
        summary.triangle_layers = common(|summary| &summary.triangle_layers);
        let (mut inputs, mut first_piece) = (Vec::with_capacity(sources.len()), 0);
        for (source, name) in sources {
            let first_group = summary.groups.len() as u32;
            let layers = add(&mut summary, source.summary(), &name);
            summary.companions.extend_from_slice(&source.summary().companions);
            let piece_count = source.piece_count();
            inputs.push(InputPart { source, first_piece, first_group, layers });
            first_piece += piece_count;
        }
        Ok(Self { inputs, summary })
    }
}

/// Adds one input to the summary; returns the places of the common layers in it.
fn add(to: &mut PieceSummary, from: &PieceSummary, name: &str) -> [Vec<usize>; 2] {
    let first_material = appearances::append(&mut to.appearance, &from.appearance);
    let is_bare = matches!(&from.groups[..], [only] if only.name.is_empty());
    for group in &from.groups {
        let mut group = group.clone();
        group.material = group.material.map(|material| material + first_material);
        if is_bare {
            name.clone_into(&mut group.name);
        }
        to.groups.push(group);
    }
    to.triangle_count += from.triangle_count;
    to.byte_count += from.byte_count;
    to.warnings.extend(from.warnings.iter().cloned());
    let mut warnings = Warnings::of_list(&from.name, std::mem::take(&mut to.warnings));
    let kinds = [
        ("layer", &to.layers, &from.layers),
        ("layer of triangles", &to.triangle_layers, &from.triangle_layers),
    ];
    let places = kinds.map(|(what, common, own)| {
        for kind in own.iter().filter(|kind| !common.contains(kind)) {
            let reason =
                format!("the {what} {} is left out: not all files have it in this form", kind.semantic);
            warnings.push(Place::File, reason);
        }
        common.iter().filter_map(|kind| own.iter().position(|other| other == kind)).collect()
    });
    to.warnings = warnings.into_list();
    places
}

/// Takes the layers at some places.
fn taken(layers: Vec<AttributeLayer>, places: &[usize]) -> Vec<AttributeLayer> {
    let mut layers: Vec<Option<AttributeLayer>> = layers.into_iter().map(Some).collect();
    places.iter().filter_map(|&place| layers.get_mut(place)?.take()).collect()
}

impl PieceSource for Several {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.inputs.last().map_or(0, |last| last.first_piece + last.source.piece_count())
    }

    fn warnings(&self) -> Vec<Warning> {
        let mut all = Warnings::of_list(&self.summary.name, self.summary.warnings.clone());
        for input in &self.inputs {
            let known = &input.source.summary().warnings;
            let found = input.source.warnings().into_iter().filter(|warning| !known.contains(warning));
            all.append(Warnings::of_list(&self.summary.name, found.collect()));
        }
        all.into_list()
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let after = self.inputs.partition_point(|input| input.first_piece <= index);
        let input = &self.inputs[after - 1];
        let mut piece = input.source.read_piece(index - input.first_piece)?;
        let [of_vertices, of_triangles] = &input.layers;
        piece.layers = taken(piece.layers, of_vertices);
        piece.triangle_layers = taken(piece.triangle_layers, of_triangles);
        if piece.groups.is_empty() && self.summary.groups.len() > 1 {
            piece.groups = vec![0; piece.triangles.len()];
        }
        piece.groups.iter_mut().for_each(|group| *group += input.first_group);
        Ok(piece)
    }
}
