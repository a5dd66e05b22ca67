//! `extract`: one level of a .striata file as a mesh.

use std::time::Instant;

use serde::Serialize;
use striata::codec::{DecodeError, StriataFile};
use striata::mesh::IndexedMesh;
use striata::model::{FanBounds, FanScene, Fans, LodStrips, Mts, StoredModel, StripModel};
use striata::strip::{RESTART, StripOptions, StripSet, stripify};

use super::extract_view::{ViewLevel, level_of_view};
use super::strip::check_form_fits;
use crate::args::{ExtractArgs, Point, TriangleForm};
use crate::commands::build::{MODELS, errors_are_guaranteed, unknown_name};
use crate::failure::Failure;
use crate::fan_cover::fans_of;
use crate::input::Input;
use crate::output::{Output, grouped, lasted, measured};
use crate::save::{Drawn, format_of, is_stdout, save};

#[derive(Serialize)]
struct Report {
    model: &'static str,
    /// Of a view: whether its fans were `stored` in the file or `built` from the sequence.
    #[serde(skip_serializing_if = "Option::is_none")]
    fans: Option<&'static str>,
    /// Of a view: pixels that an error may take where nothing else is allowed, once the triangles are no more than wanted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pixels: Option<f64>,
    split_count: usize,
    vertex_count: usize,
    triangle_count: usize,
    error: f32,
    /// Whether no point of the original is farther than the error; of a view nothing is known.
    error_is_guaranteed: bool,
    stop_reason: &'static str,
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
    if let Some(eye) = args.level.eye {
        return run_view(args, eye, &input, started, output);
    }
    if args.view.is_given() {
        return Err(Failure::user("a view was described, but no level is asked for it")
            .with_hint("say --eye instead of the other level, or leave the view out"));
    }
    let sequence = file.sequence().map_err(|error| input.damaged(&error))?;
    let target = args.level.target(file.summary().bounds.map_or(0.0, |b| b.diagonal()))?;
    let (split_count, stop_reason) = target.resolve(&sequence);
    let error_is_guaranteed = errors_are_guaranteed(&file).map_err(|error| input.damaged(&error))?;
    let extracted = match pick_model(&file, args.model.as_deref(), &input)? {
        Model::LodStrips(model) => Extracted::of_strips("lodstrips", &model, split_count, &file),
        Model::Mts(model) => Extracted::of_strips("mts", &model, split_count, &file),
        Model::Fans(model) => Extracted::of("fans", &model, split_count, &file, |_| None),
    };
    let Extracted { model, mesh, strips, seek_secs } = extracted.map_err(|error| input.damaged(&error))?;
    save(&mesh, drawn(args.form, &mesh, strips)?, &args.output.output, &args.output.format)?;
    let report = Report {
        model,
        fans: None,
        pixels: None,
        split_count,
        vertex_count: mesh.vertex_count(),
        triangle_count: mesh.triangle_count(),
        error: sequence.error_at(split_count),
        error_is_guaranteed,
        stop_reason: stop_reason.as_str(),
        seek_secs,
        secs: started.elapsed().as_secs_f64(),
    };
    output.summary(&report, &report.to_text(sequence.step_count()))
}

/// A model of a file.
enum Model<'a> {
    LodStrips(LodStrips<'a>),
    Mts(Mts<'a>),
    Fans(Fans),
}

/// The model that is named, or else the first that the file has.
///
/// # Errors
/// Where the model is none that this version has, or none that the file has.
fn pick_model<'a>(file: &StriataFile<'a>, name: Option<&str>, input: &Input) -> Result<Model<'a>, Failure> {
    if let Some(name) = name.filter(|name| !MODELS.contains(name)) {
        return Err(unknown_name("model", name, &MODELS));
    }
    let is_wanted = |which: &str| name.is_none_or(|name| name == which);
    let lod_strips = is_wanted("lodstrips").then(|| file.lod_strips()).flatten();
    let lod_strips = lod_strips.map(|model| model.map(Model::LodStrips));
    let mts = || is_wanted("mts").then(|| file.mts()).flatten().map(|model| model.map(Model::Mts));
    let fans =
        || is_wanted("fans").then(|| file.fans()).flatten().map(|model| model.map(|m| Model::Fans(m.0)));
    match lod_strips.or_else(mts).or_else(fans) {
        Some(model) => model.map_err(|error| input.damaged(&error)),
        None => {
            let what = name.map_or("no model".to_owned(), |name| format!("no model {name}"));
            Err(Failure::user(format!("{}: {what} is in this file", input.name))
                .with_hint(format!("build it again with --models {}", name.unwrap_or("lodstrips"))))
        }
    }
}

/// One level of a file.
struct Extracted {
    model: &'static str,
    mesh: IndexedMesh,
    /// Where the model has them.
    strips: Option<StripSet>,
    seek_secs: f64,
}

impl Extracted {
    /// # Errors
    /// Where a part of the file is unsound.
    fn of<M: StoredModel>(
        name: &'static str,
        model: &M,
        split_count: usize,
        file: &StriataFile<'_>,
        strips: impl Fn(&M::State) -> Option<StripSet>,
    ) -> Result<Self, DecodeError> {
        let mut state = model.new_state();
        let started = Instant::now();
        model.move_to(&mut state, split_count);
        let seek_secs = started.elapsed().as_secs_f64();
        let mesh = file.level_of(model, &state)?;
        Ok(Self { model: name, mesh, strips: strips(&state), seek_secs })
    }

    /// # Errors
    /// Where a part of the file is unsound.
    fn of_strips<M: StripModel>(
        name: &'static str,
        model: &M,
        split_count: usize,
        file: &StriataFile<'_>,
    ) -> Result<Self, DecodeError> {
        Self::of(name, model, split_count, file, |state| Some(strips_of_level(model, state)))
    }
}

/// What is written of a level: strips are those of its model, or made where it has none.
///
/// # Errors
/// Where the mesh's parts do not fit together.
fn drawn(form: TriangleForm, mesh: &IndexedMesh, strips: Option<StripSet>) -> Result<Drawn, Failure> {
    Ok(match (form, strips) {
        (TriangleForm::List, _) => Drawn::Triangles,
        (TriangleForm::Strips, Some(strips)) => Drawn::Strips(stitched(&strips)),
        (TriangleForm::Strips, None) => Drawn::Strips(stitched(&stripify(mesh, &StripOptions::default())?)),
        (TriangleForm::Fans, _) => Drawn::Fans(fans_of(mesh)),
    })
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
    if let Some(name) = args.model.as_deref().filter(|&name| name != "fans") {
        return Err(
            Failure::user(format!("{name} knows whole levels only")).with_hint("a view takes --model fans")
        );
    }
    let file = input.striata()?;
    let center = file.summary().bounds.map_or([0.0; 3], |b| [0, 1, 2].map(|i| (b.min[i] + b.max[i]) / 2.0));
    let camera = args.view.camera(eye, center).map_err(|error| {
        Failure::user(error.to_string()).with_hint("move --eye or --look-at, or turn --up")
    })?;
    let refinable = file.refinable_mesh().map_err(|error| input.damaged(&error))?;
    let stored = file.fans().transpose().map_err(|error| input.damaged(&error))?;
    let fans = if stored.is_some() { "stored" } else { "built" };
    let (table, bounds) = stored.unwrap_or_else(|| {
        let table = Fans::build(&refinable);
        let bounds = FanBounds::build(&table, &refinable);
        (table, bounds)
    });
    let scene = FanScene::new(&table, &bounds, &refinable);
    let ViewLevel { mesh, split_count, error, pixels, stop_reason, seek_secs } =
        level_of_view(&scene, &refinable, &args.view, camera, args.level.triangles);
    save(&mesh, drawn(args.form, &mesh, None)?, &args.output.output, &args.output.format)?;
    let report = Report {
        model: "fans",
        fans: Some(fans),
        pixels: Some(pixels),
        split_count,
        vertex_count: mesh.vertex_count(),
        triangle_count: mesh.triangle_count(),
        error,
        error_is_guaranteed: false,
        stop_reason: stop_reason.as_str(),
        seek_secs,
        secs: started.elapsed().as_secs_f64(),
    };
    output.summary(&report, &report.to_text(refinable.sequence.step_count()))
}

impl Report {
    fn to_text(&self, step_count: usize) -> String {
        let kind = if self.error_is_guaranteed { "guaranteed error" } else { "error" };
        let fans = self.fans.map_or_else(String::new, |origin| format!(", fans {origin}"));
        format!(
            "{} triangles, {} vertices, split {} of {}, {kind} {}, {}; sought in {}{fans}",
            grouped(self.triangle_count),
            grouped(self.vertex_count),
            grouped(self.split_count),
            grouped(step_count),
            measured(self.error.into()),
            self.stop_reason.replace('_', " "),
            lasted(self.seek_secs)
        )
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

/// One list of indices a group, its strips joined by degenerate triangles.
pub(crate) fn stitched(strips: &StripSet) -> Vec<Vec<u32>> {
    let joined = strips.to_stitched_indices();
    let of_group =
        |range: &std::ops::Range<u32>| joined.indices[range.start as usize..range.end as usize].to_vec();
    joined.group_ranges.iter().map(of_group).collect()
}

/// # Errors
/// Where strips or fans are asked for in a format that has none.
fn check_form(args: &ExtractArgs) -> Result<(), Failure> {
    let path = &args.output.output;
    let format = format_of(path, &args.output.format)?;
    match args.form {
        TriangleForm::List => Ok(()),
        TriangleForm::Strips => check_form_fits("strips", path, format, "say --as list"),
        TriangleForm::Fans => check_form_fits("fans", path, format, "say --as list"),
    }
}
