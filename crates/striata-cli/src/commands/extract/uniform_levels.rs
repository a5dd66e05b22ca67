//! Levels of uniform detail, from any model of a file.

use std::cmp::Reverse;
use std::time::Instant;

use striata::file::StriataFile;
use striata::mesh::IndexedMesh;
use striata::model::{Fans, LodModel, LodStrips, ModelKind, Mts, Patterns, StoredModel, StripModel};
use striata::strip::StripSet;

use crate::commands::build::model_of_name;
use crate::strip_lists::strips_of_level;
use striata_command::failure::Failure;
use striata_command::input::Input;

/// A model of a file.
pub(super) enum Model<'a> {
    LodStrips(LodStrips<'a>),
    Mts(Mts<'a>),
    Fans(Fans),
    Patterns(Patterns),
}

/// Reads the named model, or the first one that the file has.
///
/// # Errors
/// If the name is unknown, the file does not have the model, or the file is damaged.
pub(super) fn read_model<'a>(
    file: &StriataFile<'a>,
    name: Option<&str>,
    input: &Input,
) -> Result<Model<'a>, Failure> {
    let named = name.map(model_of_name).transpose()?;
    let is_wanted = |kind| named.is_none_or(|named| named == kind);
    let lod_strips = is_wanted(ModelKind::LodStrips).then(|| file.lod_strips()).flatten();
    let lod_strips = lod_strips.map(|model| model.map(Model::LodStrips));
    let mts = || is_wanted(ModelKind::Mts).then(|| file.mts()).flatten().map(|model| model.map(Model::Mts));
    let fans =
        || is_wanted(ModelKind::Fans).then(|| file.fans()).flatten().map(|model| model.map(Model::Fans));
    let patterns = || {
        let model = is_wanted(ModelKind::Patterns).then(|| file.patterns()).flatten();
        model.map(|model| model.map(Model::Patterns))
    };
    match lod_strips.or_else(mts).or_else(fans).or_else(patterns) {
        Some(model) => model.map_err(|error| input.damaged(&error)),
        None => {
            let what = named.map_or("no model".to_owned(), |kind| format!("no model {kind}"));
            Err(Failure::user(format!("{}: this file has {what}", input.name)).with_hint(format!(
                "build the file again with --models {}",
                named.unwrap_or(ModelKind::LodStrips)
            )))
        }
    }
}

/// One level of a file.
pub(super) struct ExtractedLevel {
    pub model: ModelKind,
    pub mesh: IndexedMesh,
    /// The strips of the level, if the model has strips.
    pub strips: Option<StripSet>,
    pub seek_secs: f64,
}

/// Receives a level and its index among the requested levels.
pub(super) type LevelSink<'a> = dyn FnMut(usize, ExtractedLevel) -> Result<(), Failure> + 'a;

/// The file that levels come from, and the input for messages.
pub(super) type Origin<'a> = (&'a StriataFile<'a>, &'a Input);

/// Returns the strips of a state of a model, if it has any.
type StripsOf<'a, M> = dyn Fn(&<M as LodModel>::State) -> Option<StripSet> + 'a;

/// Extracts levels from fine to coarse, so that the model is traversed only once.
///
/// # Errors
/// If the file is damaged, or `sink` fails.
pub(super) fn each_level<M: StoredModel>(
    kind: ModelKind,
    model: &M,
    split_counts: &[usize],
    ((file, input), strips): (Origin<'_>, &StripsOf<'_, M>),
    sink: &mut LevelSink<'_>,
) -> Result<(), Failure> {
    let mut order: Vec<usize> = (0..split_counts.len()).collect();
    order.sort_by_key(|&index| Reverse(split_counts[index]));
    let mut state = model.new_state();
    for index in order {
        let started = Instant::now();
        model.move_to(&mut state, split_counts[index]);
        let seek_secs = started.elapsed().as_secs_f64();
        let mesh = file.level_of(model, &state).map_err(|error| input.damaged(&error))?;
        sink(index, ExtractedLevel { model: kind, mesh, strips: strips(&state), seek_secs })?;
    }
    Ok(())
}

/// Extracts levels of a model with strips.
///
/// # Errors
/// Under the same conditions as [`each_level`].
pub(super) fn each_level_of_strips<M: StripModel>(
    kind: ModelKind,
    model: &M,
    split_counts: &[usize],
    origin: Origin<'_>,
    sink: &mut LevelSink<'_>,
) -> Result<(), Failure> {
    each_level(kind, model, split_counts, (origin, &|state| Some(strips_of_level(model, state))), sink)
}
