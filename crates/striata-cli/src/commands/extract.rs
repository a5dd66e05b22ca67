//! `extract`: one level of a .striata file, or several, as meshes.

use std::cmp::Reverse;
use std::path::PathBuf;
use std::time::Instant;

use serde::Serialize;
use striata::file::StriataFile;
use striata::mesh::{Bounds, IndexedMesh};
use striata::model::{
    FanScene, Fans, LodModel, LodStrips, ModelKind, Mts, Patterns, StoredModel, StripModel,
};
use striata::simplify::{StopReason, Target};
use striata::strip::{RESTART, StripSet};

use super::extract_patterns::{Budget, PatternsOfFile};
use super::extract_stream;
use super::extract_view::{ViewLevel, level_of_view};
use super::strip::check_form_fits;
use crate::args::{ExtractArgs, TriangleForm};
use crate::commands::build::{errors_are_guaranteed, model_of_name};
use crate::strip_lists::{StripLists, without_unused_vertices};
use striata_command::args::{Corners, Length, LevelArgs, Point};
use striata_command::failure::Failure;
use striata_command::fan_cover::fans_of;
use striata_command::input::Input;
use striata_command::level::{
    Floor, FullMesh, LevelRow, Reached, Wanted, check_paths, check_strict, remark, shortfall,
    table_of_levels, wanted_levels,
};
use striata_command::output::{Output, grouped, lasted, measured};
use striata_command::save::{Drawn, LevelFiles, format_of, is_stdout, name_of, save};

/// Of several levels.
#[derive(Serialize)]
struct LevelsReport {
    levels: Vec<Report>,
    step_count: usize,
    secs: f64,
}

#[derive(Serialize)]
struct Report {
    /// As the user wrote it, if it is one of several.
    #[serde(skip_serializing_if = "Option::is_none")]
    level: Option<String>,
    path: String,
    model: &'static str,
    /// Of a view: whether its fans were `stored` in the file or `built` from the sequence.
    #[serde(skip_serializing_if = "Option::is_none")]
    fans: Option<&'static str>,
    /// Of a view or a box: whether its patterns were `stored` in the file or `built` from the sequence.
    #[serde(skip_serializing_if = "Option::is_none")]
    patterns: Option<&'static str>,
    /// Of a view: pixels that an error may take where nothing else is allowed, once the triangles are no more than wanted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pixels: Option<f64>,
    split_count: usize,
    vertex_count: usize,
    triangle_count: usize,
    error: f32,
    /// Whether no point of the original is farther than the error.
    error_is_guaranteed: bool,
    stop_reason: &'static str,
    /// Why the level is not what was asked for; null if it is.
    shortfall: Option<String>,
    seek_secs: f64,
    secs: f64,
}

/// Opens the file, goes to the level, writes it.
///
/// # Errors
/// Where any of it fails.
pub(crate) fn run(args: &ExtractArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    check_form(args)?;
    let input = Input::open(&args.input)?;
    let file = input.striata()?;
    let is_named = args.model.as_deref() == Some(ModelKind::Progressive.as_str());
    let is_place = args.eye.eye.is_some() || args.detail_box.is_some();
    if !is_place && !args.view.is_given() && (is_named || args.model.is_none() && file.is_stream_only()) {
        return extract_stream::run(args, (&file, &input), started, output);
    }
    input.remark_on(&file, output)?;
    if args.view.is_given() && args.eye.eye.is_none() {
        return Err(Failure::user("a view was described, but no level is asked for it")
            .with_hint("say --eye instead of the other level, or leave the view out"));
    }
    if let Some(eye) = args.eye.eye {
        return run_view(args, eye, &input, started, output);
    }
    if let Some(corners) = args.detail_box {
        return run_box(args, corners, &input, started, output);
    }
    let levels = file.levels().map_err(|error| input.damaged(&error))?;
    let full = FullMesh::of_levels(&levels, diagonal_of(&args.level, &file, &input)?);
    let wanted = wanted_levels(&args.level, &args.levels, full, &args.output.output)?;
    let error_is_guaranteed = errors_are_guaranteed(&file).map_err(|error| input.damaged(&error))?;
    let resolve = |wanted: &Wanted| -> Result<_, Failure> {
        Ok(wanted.target.ok_or_else(no_level)?.resolve_in(&levels))
    };
    let resolved = wanted.iter().map(resolve).collect::<Result<Vec<_>, _>>()?;
    let split_counts: Vec<usize> = resolved.iter().map(|&(split_count, _)| split_count).collect();
    let mut files = LevelFiles::new(&args.output.format, args.levels.levels.is_some());
    let mut reports: Vec<Option<Report>> = wanted.iter().map(|_| None).collect();
    let mut take = |number: usize, extracted: Extracted| -> Result<(), Failure> {
        let Extracted { model, mesh, strips, seek_secs } = extracted;
        let (mesh, strips) = without_unused_vertices(mesh, strips);
        let (wanted, (split_count, stop_reason)) = (&wanted[number], resolved[number]);
        let report = Report {
            error: levels.error_at(split_count),
            error_is_guaranteed,
            ..Report::of_level(
                model,
                wanted,
                (&mesh, split_count, stop_reason),
                [seek_secs, seconds(started)],
            )
        };
        check_strict(args.strict, wanted.name.as_deref(), report.shortfall.as_deref())?;
        files.save(&mesh, drawn(args.form, &mesh, strips)?, &wanted.path)?;
        reports[number] = Some(report);
        Ok(())
    };
    let (from, split_counts) = ((&file, &input), &split_counts[..]);
    match pick_model(&file, args.model.as_deref(), &input)? {
        Model::LodStrips(model) => {
            each_level_of_strips(ModelKind::LodStrips, &model, split_counts, from, &mut take)
        }
        Model::Mts(model) => each_level_of_strips(ModelKind::Mts, &model, split_counts, from, &mut take),
        Model::Fans(model) => each_level(ModelKind::Fans, &model, split_counts, (from, &|_| None), &mut take),
        Model::Patterns(model) => {
            each_level(ModelKind::Patterns, &model, split_counts, (from, &|_| None), &mut take)
        }
    }?;
    files.commit()?;
    let mut reports: Vec<Report> = reports.into_iter().flatten().collect();
    if args.levels.levels.is_some() {
        let report =
            LevelsReport { levels: reports, step_count: levels.step_count(), secs: seconds(started) };
        return output.summary(&report, &report.to_text());
    }
    let report = reports.pop().ok_or_else(no_level)?;
    output.summary(&report, &report.to_text(levels.step_count()))
}

fn seconds(started: Instant) -> f64 {
    started.elapsed().as_secs_f64()
}

/// The parser sees to it that there is a level.
pub(super) fn no_level() -> Failure {
    Failure::internal("no level was given")
}

/// A model of a file.
enum Model<'a> {
    LodStrips(LodStrips<'a>),
    Mts(Mts<'a>),
    Fans(Fans),
    Patterns(Patterns),
}

/// The model that is named, or else the first that the file has.
///
/// # Errors
/// Where the model is none that this version has, or none that the file has.
fn pick_model<'a>(file: &StriataFile<'a>, name: Option<&str>, input: &Input) -> Result<Model<'a>, Failure> {
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
struct Extracted {
    model: ModelKind,
    mesh: IndexedMesh,
    /// Where the model has them.
    strips: Option<StripSet>,
    seek_secs: f64,
}

/// Takes a level and its number among all that were asked for.
type TakeLevel<'a> = dyn FnMut(usize, Extracted) -> Result<(), Failure> + 'a;

/// Where levels come from, for messages too.
type Origin<'a> = (&'a StriataFile<'a>, &'a Input);

/// The strips that a state of a model shows, if it has any.
type StripsOf<'a, M> = dyn Fn(&<M as LodModel>::State) -> Option<StripSet> + 'a;

/// Goes through levels from fine to coarse, so that the model is stepped through once.
///
/// # Errors
/// If a part of the file is unsound, or `take` fails.
fn each_level<M: StoredModel>(
    kind: ModelKind,
    model: &M,
    split_counts: &[usize],
    ((file, input), strips): (Origin<'_>, &StripsOf<'_, M>),
    take: &mut TakeLevel<'_>,
) -> Result<(), Failure> {
    let mut order: Vec<usize> = (0..split_counts.len()).collect();
    order.sort_by_key(|&number| Reverse(split_counts[number]));
    let mut state = model.new_state();
    for number in order {
        let started = Instant::now();
        model.move_to(&mut state, split_counts[number]);
        let seek_secs = started.elapsed().as_secs_f64();
        let mesh = file.level_of(model, &state).map_err(|error| input.damaged(&error))?;
        take(number, Extracted { model: kind, mesh, strips: strips(&state), seek_secs })?;
    }
    Ok(())
}

/// # Errors
/// As [`each_level`].
fn each_level_of_strips<M: StripModel>(
    kind: ModelKind,
    model: &M,
    split_counts: &[usize],
    from: Origin<'_>,
    take: &mut TakeLevel<'_>,
) -> Result<(), Failure> {
    each_level(kind, model, split_counts, (from, &|state| Some(strips_of_level(model, state))), take)
}

/// What is written of a level. Strips come from its model, or are made anew if it has none or if new ones are shorter.
///
/// # Errors
/// Where the mesh's parts do not fit together.
pub(super) fn drawn(
    form: TriangleForm,
    mesh: &IndexedMesh,
    strips: Option<StripSet>,
) -> Result<Drawn, Failure> {
    Ok(match form {
        TriangleForm::List => Drawn::Triangles,
        TriangleForm::Strips => Drawn::Strips(StripLists::of_level(mesh, strips.as_ref())?.lists),
        TriangleForm::Fans => Drawn::Fans(fans_of(mesh)),
    })
}

/// The bounds of the full mesh; of a stream without a file around it, those of what is there.
///
/// # Errors
/// Where the stream is unsound.
fn bounds_of(file: &StriataFile<'_>, input: &Input) -> Result<Option<Bounds>, Failure> {
    match file.summary().bounds {
        Some(bounds) => Ok(Some(bounds)),
        None => Ok(file.mesh().map_err(|error| input.damaged(&error))?.bounds()),
    }
}

/// The diagonal that an error is a share of; 0 where none is.
///
/// # Errors
/// Where the stream is unsound.
pub(super) fn diagonal_of(level: &LevelArgs, file: &StriataFile<'_>, input: &Input) -> Result<f64, Failure> {
    match level.error {
        Some(Length::OfDiagonal(_)) => Ok(bounds_of(file, input)?.map_or(0.0, |b| b.diagonal())),
        _ => Ok(0.0),
    }
}

/// Where a view or a box goes.
///
/// # Errors
/// If its name has a place for a level and there is none.
fn path_of_place(args: &ExtractArgs) -> Result<PathBuf, Failure> {
    let paths = check_paths(&args.level, &args.levels, &args.output.output)?;
    paths.into_iter().next().ok_or_else(no_level)
}

/// The number of triangles that a view or a box may have.
fn triangle_limit(args: &ExtractArgs, file: &StriataFile<'_>) -> Option<usize> {
    args.level.triangle_count().map(|count| count.of_triangles(file.summary().triangle_count))
}

/// The same for a view.
///
/// # Errors
/// Where the view makes no picture, or any of it fails.
fn run_view(
    args: &ExtractArgs,
    eye: Point,
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let file = input.striata()?;
    let center =
        bounds_of(&file, input)?.map_or([0.0; 3], |b| [0, 1, 2].map(|i| (b.min[i] + b.max[i]) / 2.0));
    let camera = args.view.camera(eye, center).map_err(|error| {
        Failure::user(error.to_string()).with_hint("move --eye or --look-at, or turn --up")
    })?;
    if asks_patterns(args, &file, input)? {
        let model = PatternsOfFile::read(&file, input)?;
        let level = model.level_of_view(&args.view, camera, triangle_limit(args, &file));
        return report_patterns(args, (&model, level), input, started, output);
    }
    let refinable = file.refinable_mesh().map_err(|error| input.damaged(&error))?;
    let stored = file.fans().transpose().map_err(|error| input.damaged(&error))?;
    let fans = if stored.is_some() { "stored" } else { "built" };
    let table = stored.unwrap_or_else(|| Fans::build(&refinable));
    let scene = FanScene::new(&table, &refinable);
    let limit = triangle_limit(args, &file);
    let level = level_of_view(&scene, &refinable, &args.view, camera, limit);
    let (pixels, drawn) = (level.pixels, drawn(args.form, &level.mesh, None)?);
    let report = Report::of_place(ModelKind::Fans, args, (&level, limit), started)?;
    save(&level.mesh, drawn, &path_of_place(args)?, &args.output.format)?;
    let report = Report { fans: Some(fans), pixels: Some(pixels), ..report };
    output.summary(&report, &report.to_text(refinable.sequence.step_count()))
}

/// Whether a view is one of patterns: where they are named, or no fans are and these would have to be built.
///
/// # Errors
/// Where a model is named that knows whole levels only, or fans where there are no collapses.
fn asks_patterns(args: &ExtractArgs, file: &StriataFile<'_>, input: &Input) -> Result<bool, Failure> {
    match args.model.as_deref().map(model_of_name).transpose()? {
        Some(ModelKind::Patterns) => Ok(true),
        Some(ModelKind::Fans) if !file.has_collapses() => {
            Err(Failure::user(format!("{}: fans take collapses, and this file has none", input.name))
                .with_hint("leave --model out, or say --model patterns"))
        }
        Some(ModelKind::Fans) => Ok(false),
        Some(kind) => Err(Failure::user(format!("{kind} knows whole levels only"))
            .with_hint("a view takes --model fans or patterns")),
        None => Ok(file.fans().is_none() && file.patterns().is_some()),
    }
}

/// The same for a box.
///
/// # Errors
/// Where another model is asked for, or any of it fails.
fn run_box(
    args: &ExtractArgs,
    corners: Corners,
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    if let Some(name) = args.model.as_deref().filter(|&name| name != ModelKind::Patterns.as_str()) {
        return Err(Failure::user(format!("{name} are not asked for boxes"))
            .with_hint("a box takes --model patterns"));
    }
    let file = input.striata()?;
    let diagonal = diagonal_of(&args.level, &file, input)?;
    let triangle_limit = triangle_limit(args, &file);
    // What is nowhere in the box weighs its error: all of it may be left out, or none of what is over the limit.
    let threshold = match (args.level.error, triangle_limit) {
        (Some(error), _) => error.in_units(diagonal) as f32,
        (None, Some(_)) => 0.0,
        (None, None) => f32::MAX,
    };
    let model = PatternsOfFile::read(&file, input)?;
    let level = model.level_of_box(corners, Budget { triangle_limit, threshold });
    report_patterns(args, (&model, level), input, started, output)
}

/// Writes and reports what patterns show of a view or a box.
///
/// # Errors
/// Where the file is unsound or the output cannot be written.
fn report_patterns(
    args: &ExtractArgs,
    (model, level): (&PatternsOfFile, ViewLevel),
    input: &Input,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let file = input.striata()?;
    let report = Report::of_place(ModelKind::Patterns, args, (&level, triangle_limit(args, &file)), started)?;
    save(&level.mesh, drawn(args.form, &level.mesh, None)?, &path_of_place(args)?, &args.output.format)?;
    let is_guaranteed = errors_are_guaranteed(&file).map_err(|error| input.damaged(&error))?;
    let report = Report {
        patterns: Some(if model.are_stored { "stored" } else { "built" }),
        pixels: args.eye.eye.is_some().then_some(level.pixels),
        // Built from collapses they know errors of levels only, and not what holds of each floor wherever it is shown.
        error_is_guaranteed: is_guaranteed && model.are_stored,
        ..report
    };
    output.summary(&report, &report.to_text(model.step_count()))
}

impl Report {
    /// Of a level that is the same everywhere; its error is known elsewhere.
    fn of_level(
        model: ModelKind,
        wanted: &Wanted,
        (mesh, split_count, stop_reason): (&IndexedMesh, usize, StopReason),
        [seek_secs, secs]: [f64; 2],
    ) -> Self {
        let reached =
            Reached { vertex_count: mesh.vertex_count(), triangle_count: mesh.triangle_count(), stop_reason };
        Self {
            level: wanted.name.clone(),
            path: name_of(&wanted.path),
            model: model.as_str(),
            fans: None,
            patterns: None,
            pixels: None,
            split_count,
            vertex_count: reached.vertex_count,
            triangle_count: reached.triangle_count,
            error: 0.0,
            error_is_guaranteed: false,
            stop_reason: stop_reason.as_str(),
            shortfall: wanted.target.and_then(|target| shortfall(target, reached, &Floor::File)),
            seek_secs,
            secs,
        }
    }

    /// Of a level that differs from place to place.
    ///
    /// # Errors
    /// If it has more triangles than allowed and that is forbidden, or its file has no name.
    fn of_place(
        model: ModelKind,
        args: &ExtractArgs,
        (level, triangle_limit): (&ViewLevel, Option<usize>),
        started: Instant,
    ) -> Result<Self, Failure> {
        let path = path_of_place(args)?;
        let wanted = Wanted { name: None, target: triangle_limit.map(Target::Triangles), path };
        let level_is = (&level.mesh, level.split_count, level.stop_reason);
        let report = Self {
            error: level.error,
            ..Self::of_level(model, &wanted, level_is, [level.seek_secs, seconds(started)])
        };
        check_strict(args.strict, None, report.shortfall.as_deref())?;
        Ok(report)
    }

    fn to_text(&self, step_count: usize) -> String {
        let kind = if self.error_is_guaranteed { "guaranteed error" } else { "error" };
        let of_model = |model: ModelKind, origin: Option<&str>| {
            origin.map_or_else(String::new, |origin| format!(", {model} {origin}"))
        };
        let origin = of_model(ModelKind::Fans, self.fans) + &of_model(ModelKind::Patterns, self.patterns);
        format!(
            "{} triangles, {} vertices, split {} of {}, {kind} {}, {}; sought in {}{origin}{}",
            grouped(self.triangle_count),
            grouped(self.vertex_count),
            grouped(self.split_count),
            grouped(step_count),
            measured(self.error.into()),
            self.stop_reason.replace('_', " "),
            lasted(self.seek_secs),
            self.shortfall.as_ref().map_or_else(String::new, |text| format!("\n{}", remark(None, text)))
        )
    }
}

impl LevelsReport {
    fn to_text(&self) -> String {
        let rows: Vec<LevelRow<'_>> = self.levels.iter().map(Report::row).collect();
        let model = self.levels.first().map_or("", |level| level.model);
        format!("{}from {model} in {}", table_of_levels(&rows), lasted(self.secs))
    }
}

impl Report {
    fn row(&self) -> LevelRow<'_> {
        LevelRow {
            name: self.level.as_deref().unwrap_or_default(),
            triangle_count: self.triangle_count,
            vertex_count: self.vertex_count,
            error: self.error.into(),
            path: &self.path,
            shortfall: self.shortfall.as_deref(),
        }
    }
}

/// The strips that a level shows, group by group; dead ones are left out.
pub(crate) fn strips_of_level<M: StripModel>(model: &M, state: &M::State) -> StripSet {
    let mut strips = StripSet::new();
    for group in 0..model.group_count() {
        for strip in model.group_strips(group) {
            let pieces = model.strip(state, strip).split(|&index| index == RESTART);
            pieces.filter(|piece| piece.len() >= 3).for_each(|piece| strips.push(piece));
        }
        strips.end_group();
    }
    strips
}

/// # Errors
/// Where strips or fans are asked for in a format that has none.
fn check_form(args: &ExtractArgs) -> Result<(), Failure> {
    for path in check_paths(&args.level, &args.levels, &args.output.output)? {
        let format = format_of(&path, &args.output.format)?;
        match args.form {
            TriangleForm::List => {}
            TriangleForm::Strips => check_form_fits("strips", &path, format, "say --as list")?,
            TriangleForm::Fans => check_form_fits("fans", &path, format, "say --as list")?,
        }
    }
    Ok(())
}
