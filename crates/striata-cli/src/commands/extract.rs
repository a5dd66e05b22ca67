//! `extract`: one level of a .striata file as a mesh.

use std::time::Instant;

use serde::Serialize;
use striata::codec::{DecodeError, StriataFile};
use striata::mesh::IndexedMesh;
use striata::model::{LodStrips, Mts, StripModel};
use striata::simplify::StopReason;
use striata::strip::{RESTART, StripOptions, StripSet, stripify};

use super::extract_view::{ViewLevel, level_of_view};
use super::strip::check_strips_fit;
use crate::args::{ExtractArgs, Point, TriangleForm};
use crate::commands::build::{MODELS, unknown_name};
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{Output, grouped, lasted, measured};
use crate::save::{format_of, is_stdout, save};

#[derive(Serialize)]
struct Report {
    model: &'static str,
    split_count: usize,
    vertex_count: usize,
    triangle_count: usize,
    error: f32,
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
    let extracted = match pick_model(&file, args.model.as_deref(), &input)? {
        Model::LodStrips(model) => Extracted::of("lodstrips", &model, split_count, &file),
        Model::Mts(model) => Extracted::of("mts", &model, split_count, &file),
    };
    let Extracted { model, mesh, strips, seek_secs } = extracted.map_err(|error| input.damaged(&error))?;
    let strips = (args.form == TriangleForm::Strips).then(|| stitched(&strips));
    save(&mesh, strips, &args.output.output, &args.output.format)?;
    let report = Report {
        model,
        split_count,
        vertex_count: mesh.vertex_count(),
        triangle_count: mesh.triangle_count(),
        error: sequence.error_at(split_count),
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
    let mts = || is_wanted("mts").then(|| file.mts()).flatten();
    let model = match lod_strips {
        Some(model) => Some(model.map(Model::LodStrips)),
        None => mts().map(|model| model.map(Model::Mts)),
    };
    match model {
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
    strips: StripSet,
    seek_secs: f64,
}

impl Extracted {
    /// # Errors
    /// Where a part of the file is unsound.
    fn of<M: StripModel>(
        name: &'static str,
        model: &M,
        split_count: usize,
        file: &StriataFile<'_>,
    ) -> Result<Self, DecodeError> {
        let mut state = model.new_state();
        let started = Instant::now();
        model.move_to(&mut state, split_count);
        let seek_secs = started.elapsed().as_secs_f64();
        let mesh = file.level_of(model, &state)?;
        Ok(Self { model: name, mesh, strips: strips_of_level(model, &state), seek_secs })
    }
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
    let ViewLevel { mesh, split_count, error, seek_secs } =
        level_of_view(&refinable, camera, args.view.pixels());
    let strips = match args.form {
        TriangleForm::List => None,
        TriangleForm::Strips => Some(stitched(&stripify(&mesh, &StripOptions::default())?)),
    };
    save(&mesh, strips, &args.output.output, &args.output.format)?;
    let report = Report {
        model: "fans",
        split_count,
        vertex_count: mesh.vertex_count(),
        triangle_count: mesh.triangle_count(),
        error,
        stop_reason: StopReason::TargetReached.as_str(),
        seek_secs,
        secs: started.elapsed().as_secs_f64(),
    };
    output.summary(&report, &report.to_text(refinable.sequence.step_count()))
}

impl Report {
    fn to_text(&self, step_count: usize) -> String {
        format!(
            "{} triangles, {} vertices, split {} of {}, error {}, {}; sought in {}",
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
/// Where strips are asked for in a format that has none.
fn check_form(args: &ExtractArgs) -> Result<(), Failure> {
    let format = format_of(&args.output.output, &args.output.format)?;
    if args.form == TriangleForm::Strips {
        return check_strips_fit(&args.output.output, format, "say --as list");
    }
    Ok(())
}
