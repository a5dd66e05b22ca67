//! `render`: draws a mesh, several of its levels, or a view, to a PNG file.

mod figure;
mod layout;
mod report;
mod scene_source;
mod source;
mod viewpoint;

use std::path::Path;
use std::time::Instant;

use crate::args::{PictureBackground, RenderArgs};
use crate::commands::levels::camera;
use crate::commands::paged::{failure_of, is_paged_file, open_input};
use figure::Figure;
use layout::Layout;
use report::{DrawingReport, RenderReport};
use source::{PageLimits, PictureSource};
use striata::levels::Levels as _;
use striata::model::ModelKind;
use striata_command::args::Point;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{FullMesh, check_strict};
use striata_command::output::{Bar, Output};
use striata_command::save::{check_place, is_stdout, write_bytes};
use striata_paged::PagedFile;
use striata_render::{Canvas, Theme};
use striata_viewer::PictureRenderer;
use viewpoint::Viewpoint;

/// Reads the input, draws the requested levels, writes the picture, and reports.
///
/// # Errors
/// If any of this fails; nothing is written then.
pub(crate) fn run(args: &RenderArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output))?;
    check(args)?;
    let mut bar = output.bar();
    bar.phase("read");
    if let Some(eye) = args.level.eye.filter(|_| is_paged_file(&args.input)) {
        let source = PictureSource::of_view(args, paged_view(args, eye)?);
        let figures = vec![source.target(None)?];
        return draw(args, (&source, figures), (output, bar, started));
    }
    let pages = is_paged_file(&args.input).then(|| page_limits(args)).transpose()?;
    let input = open_input(&args.input, pages.map_or(usize::MAX, |pages| pages.triangle_count))?;
    let input = input.with_raster(args.raster)?;
    let mut source = PictureSource::read(args, &input, output, &mut bar)?;
    if let Some(pages) = pages {
        source = source.of_pages(pages);
    }
    let figures = figures(args, &source, &input)?;
    draw(args, (&source, figures), (output, bar, started))
}

/// Draws levels, writes the picture, and reports.
///
/// # Errors
/// If any of this fails; nothing is written then.
fn draw(
    args: &RenderArgs,
    (source, figures): (&PictureSource<'_>, Vec<Figure>),
    (output, mut bar, started): (&Output, Bar, Instant),
) -> Result<(), Failure> {
    let mut artist = artist(args, output)?;
    for warning in source.look().iter().flat_map(|look| look.warnings()) {
        output.say(&format!("warning: {warning}"));
    }
    for figure in &figures {
        let name = (!figure.title.is_empty()).then_some(figure.title.as_str());
        check_strict(args.strict, name, figure.shortfall.as_deref())?;
    }
    bar.phase("draw");
    let viewpoint = Viewpoint::new(args, source)?;
    let layout = Layout::new(args, source, &figures, &viewpoint)?;
    let picture = layout.draw(&mut artist, &theme(args.background))?;
    write(&args.output, &picture.canvas, &mut bar)?;
    drop(bar);
    let drawing = DrawingReport { artist: &artist, frame_secs: picture.frame_secs, started };
    let report = RenderReport::new(args, source, &figures, &layout, drawing);
    output.summary(&report, &report.to_text())
}

/// Returns the size of a paged file, to which percentages refer, and the most triangles
/// that a picture shows.
///
/// # Errors
/// If the file is damaged.
fn page_limits(args: &RenderArgs) -> Result<PageLimits, Failure> {
    let file = PagedFile::open(&args.input.to_string_lossy()).map_err(failure_of)?;
    let metadata = file.metadata();
    let [vertex_count, triangle_count] =
        [metadata.vertex_count, metadata.triangle_count].map(|count| count as usize);
    let full = FullMesh { diagonal: 0.0, vertex_count, triangle_count };
    let wanted = match &args.levels {
        Some(levels) => levels.iter().map(|count| count.of_triangles(triangle_count)).max(),
        None => args.level.level.triangle_count().map(|count| count.of_triangles(triangle_count)),
    };
    let [width, height] = args.size.0.map(|pixels| pixels as usize);
    let limit = TRIANGLES_PER_PIXEL * width * height;
    Ok(PageLimits { full, triangle_count: limit.min(wanted.unwrap_or(usize::MAX)) })
}

/// Returns the level of a paged file for a view.
///
/// # Errors
/// If the camera is degenerate, or the file is damaged.
fn paged_view(args: &RenderArgs, eye: Point) -> Result<Figure, Failure> {
    let mut file = PagedFile::open(&args.input.to_string_lossy()).map_err(failure_of)?;
    file.load_images().map_err(failure_of)?;
    let (facts, bounds) = (file.facts(), file.bounds().map_err(failure_of)?);
    let limit = args.level.level.triangle_count().map(|count| count.of_triangles(facts.triangle_count));
    let view = args.view.on_screen(args.size.0);
    let camera = camera(&view, eye, facts.origin, bounds)?;
    let found =
        file.find_for_view(&view.relative_to(facts.origin).criterion(camera), limit).map_err(failure_of)?;
    Ok(Figure::of_view(ModelKind::Fans, found, &view, limit))
}

/// A picture shows no more triangles of a paged file than this for each of its pixels.
const TRIANGLES_PER_PIXEL: usize = 2;

/// Checks combinations of flags that the parser cannot check.
///
/// # Errors
/// If flags contradict each other.
fn check(args: &RenderArgs) -> Result<(), Failure> {
    args.size.check_drawable()?;
    let is_png = args.output.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("png"));
    if !is_png && !is_stdout(&args.output) {
        return Err(Failure::usage(format!("{}: pictures are written as PNG", args.output.display()))
            .with_hint("use the extension .png, or - for stdout"));
    }
    check_place(&args.output)?;
    if args.level.eye.is_none() && args.view.has_criterion() {
        return Err(Failure::usage("flags of a view were given without --eye")
            .with_hint("add --eye, or remove --pixels, --viewport and the like"));
    }
    if args.colors.len() > 1 && args.rows.is_some() {
        return Err(Failure::usage("--rows cannot be used with several --colors, which get a row each")
            .with_hint("remove --rows, or name only one of --colors"));
    }
    Ok(())
}

/// Chooses what draws: the named adapter, the best one, or the CPU.
///
/// # Errors
/// If the named adapter does not exist.
fn artist(args: &RenderArgs, output: &Output) -> Result<PictureRenderer, Failure> {
    if args.software {
        return Ok(PictureRenderer::software(output));
    }
    #[cfg(feature = "gpu")]
    if let Some(name) = &args.adapter {
        return PictureRenderer::named(name, output);
    }
    Ok(PictureRenderer::best(output))
}

/// Returns all levels of the picture.
///
/// # Errors
/// If a level cannot be made.
fn figures(args: &RenderArgs, source: &PictureSource<'_>, input: &Input) -> Result<Vec<Figure>, Failure> {
    if let Some(eye) = args.level.eye {
        return Ok(vec![source.view(args, eye, input)?]);
    }
    match &args.levels {
        Some(levels) => levels.iter().map(|&level| source.triangles(level)).collect(),
        None => Ok(vec![source.target(args.level.level.target(source.full()))?]),
    }
}

fn theme(background: PictureBackground) -> Theme {
    match background {
        PictureBackground::Dark => Theme::DARK,
        PictureBackground::Light => Theme::LIGHT,
        PictureBackground::None => Theme::on([0.0; 4]),
        PictureBackground::Color(srgb) => Theme::on_srgb(srgb),
    }
}

/// Writes the picture as PNG.
///
/// # Errors
/// If the file cannot be written.
fn write(path: &Path, canvas: &Canvas, bar: &mut Bar) -> Result<(), Failure> {
    bar.phase("write");
    let bytes = canvas.to_png().map_err(|error| Failure::internal(format!("PNG: {error}")))?;
    write_bytes(&bytes, path)
}
