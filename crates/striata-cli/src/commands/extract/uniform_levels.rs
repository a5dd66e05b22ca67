//! Levels that are the same everywhere, from whichever model of a file.

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

/// The model that is named, or else the first that the file has.
///
/// # Errors
/// Where the model is none that this version has, or none that the file has.
pub(super) fn pick_model<'a>(
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
            Err(Failure::user(format!("{}: {what} is in this file", input.name))
                .with_hint(format!("build it again with --models {}", named.unwrap_or(ModelKind::LodStrips))))
        }
    }
}

/// One level of a file.
pub(super) struct ExtractedLevel {
    pub(super) model: ModelKind,
    pub(super) mesh: IndexedMesh,
    /// Where the model has them.
    pub(super) strips: Option<StripSet>,
    pub(super) seek_secs: f64,
}

/// Takes a level and its number among all that were asked for.
pub(super) type LevelSink<'a> = dyn FnMut(usize, ExtractedLevel) -> Result<(), Failure> + 'a;

/// Where levels come from, for messages too.
pub(super) type Origin<'a> = (&'a StriataFile<'a>, &'a Input);

/// The strips that a state of a model shows, if it has any.
type StripsOf<'a, M> = dyn Fn(&<M as LodModel>::State) -> Option<StripSet> + 'a;

/// Goes through levels from fine to coarse, so that the model is stepped through once.
///
/// # Errors
/// If a part of the file is unsound, or `take` fails.
pub(super) fn each_level<M: StoredModel>(
    kind: ModelKind,
    model: &M,
    split_counts: &[usize],
    ((file, input), strips): (Origin<'_>, &StripsOf<'_, M>),
    take: &mut LevelSink<'_>,
) -> Result<(), Failure> {
    let mut order: Vec<usize> = (0..split_counts.len()).collect();
    order.sort_by_key(|&number| Reverse(split_counts[number]));
    let mut state = model.new_state();
    for number in order {
        let started = Instant::now();
        model.move_to(&mut state, split_counts[number]);
        let seek_secs = started.elapsed().as_secs_f64();
        let mesh = file.level_of(model, &state).map_err(|error| input.damaged(&error))?;
        take(number, ExtractedLevel { model: kind, mesh, strips: strips(&state), seek_secs })?;
    }
    Ok(())
}

/// # Errors
/// As [`each_level`].
pub(super) fn each_level_of_strips<M: StripModel>(
    kind: ModelKind,
    model: &M,
    split_counts: &[usize],
    from: Origin<'_>,
    take: &mut LevelSink<'_>,
) -> Result<(), Failure> {
    each_level(kind, model, split_counts, (from, &|state| Some(strips_of_level(model, state))), take)
}
