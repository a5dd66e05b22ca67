//! `compare`: measures models, stripifiers and streams on the same meshes and reports tables, JSON and a
//! page with charts.
//!
//! Each part of the comparison is a module with a `measure` function, a `table` for the text report, and a
//! `section` of the page. This module combines parts and meshes.

mod assets;
mod bars;
mod clusters;
mod contenders;
mod labels;
mod model_charts;
mod models;
mod oracle;
mod page;
mod papers;
mod patterns;
#[cfg(feature = "peers")]
mod peers;
pub(crate) mod plot;
mod rate;
mod scale;
mod stripifiers;
mod sweep;
mod timed_model;
mod tunnels;
mod views;
mod walks;

use std::path::Path;
use std::time::Instant;

use serde::Serialize;
use striata::mesh::{IndexedMesh, weld};
use striata_io::write_atomically;
use striata_strip::strip_count_bound;

use self::assets::AssetsReport;
use self::clusters::ClustersReport;
pub(crate) use self::contenders::compared_models;
use self::models::{ModelsReport, Sequenced};
use self::page::MeshPart;
use self::papers::PaperRow;
use self::patterns::PatternsReport;
use self::rate::RateReport;
use self::stripifiers::StripifierRow;
use self::tunnels::TunnelRow;
use self::views::ViewsReport;
use crate::args::{CompareArgs, ComparisonPart};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Bar, Output, Table, format_duration, format_noun_count, to_stdout};
use striata_command::save::is_stdout;

#[derive(Serialize)]
struct ComparisonReport {
    command: String,
    machine: String,
    meshes: Vec<MeshComparison>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    assets_summary: Vec<assets::AssetSummary>,
    secs: f64,
}

#[derive(Serialize)]
struct MeshComparison {
    name: String,
    vertex_count: usize,
    triangle_count: usize,
    component_count: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    strips: Option<StripsReport>,
    #[serde(flatten)]
    models: Option<ModelsReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    views: Option<ViewsReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    patterns: Option<PatternsReport>,
    #[serde(flatten)]
    rate: Option<RateReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    assets: Option<AssetsReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    clusters: Option<ClustersReport>,
    /// Empty if no paper measured this mesh.
    papers: Vec<PaperRow>,
}

#[derive(Serialize)]
struct StripsReport {
    strip_count_bound: usize,
    tunnel_lengths: Vec<TunnelRow>,
    stripifiers: Vec<StripifierRow>,
}

/// Measures every mesh, writes the page, and prints the report.
///
/// # Errors
/// If a mesh cannot be read or the page cannot be written.
pub(crate) fn run(args: &CompareArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    let page_to_stdout = args.html.as_deref().is_some_and(is_stdout);
    output.check_stdout_is_free(page_to_stdout)?;
    args.html.as_deref().map_or(Ok(()), check_folder)?;
    contenders::entries(&args.models.names())?;
    // Open all inputs first, so that a missing file is reported before minutes of work.
    let inputs: Vec<Input> = args.inputs.iter().map(|path| Input::open(path)).collect::<Result<_, _>>()?;
    let meshes: Vec<MeshComparison> =
        inputs.iter().map(|input| measure(input, args, output)).collect::<Result<_, _>>()?;
    let of_assets: Vec<&AssetsReport> = meshes.iter().filter_map(|mesh| mesh.assets.as_ref()).collect();
    let assets_summary = assets::summarize(&of_assets);
    let (command, machine) = (command_line(std::env::args().skip(1)), machine());
    let report =
        ComparisonReport { command, machine, meshes, assets_summary, secs: started.elapsed().as_secs_f64() };
    if let Some(path) = &args.html {
        let html = report.to_page()?;
        if is_stdout(path) {
            to_stdout(html.as_bytes())?;
        } else {
            write_atomically(path, |out| out.write_all(html.as_bytes()))?;
        }
    }
    let text = report.to_text();
    if page_to_stdout { output.summary(&report, &text) } else { output.data(&report, &text) }
}

fn measure(input: &Input, args: &CompareArgs, output: &Output) -> Result<MeshComparison, Failure> {
    let mesh = input.mesh(output)?;
    let in_input = |failure: Failure| failure.in_file(&input.name);
    let say = |what: &str| output.say(&format!("{}: {what}", input.name));
    let mut bar = output.bar();
    let report = measure_mesh(input.file_name(), mesh, args, &mut bar, &say);
    report.map_err(in_input)
}

fn measure_mesh(
    name: String,
    mesh: IndexedMesh,
    args: &CompareArgs,
    bar: &mut Bar,
    say: &dyn Fn(&str),
) -> Result<MeshComparison, Failure> {
    let mesh = if args.strips.weld { weld(&mesh)?.mesh } else { mesh };
    let component_count = mesh.component_count()?;
    let strips =
        args.has(ComparisonPart::Strips).then(|| measure_strips(&mesh, args, bar, say)).transpose()?;
    let needs_sequence = [ComparisonPart::Models, ComparisonPart::Views, ComparisonPart::Patterns]
        .into_iter()
        .any(|part| args.has(part));
    let sequenced = needs_sequence.then(|| Sequenced::build(&mesh, args.certify, bar, say)).transpose()?;
    let sequenced_for = |part| sequenced.as_ref().filter(|_| args.has(part));
    let models = sequenced_for(ComparisonPart::Models);
    let models = models.map(|sequenced| models::measure(sequenced, &args.models, bar, say)).transpose()?;
    let views = sequenced_for(ComparisonPart::Views);
    let views = views.map(|sequenced| views::measure(&sequenced.refinable, bar, say)).transpose()?;
    let patterns = sequenced_for(ComparisonPart::Patterns)
        .map(|sequenced| patterns::measure(&mesh, &sequenced.refinable, sequenced.secs, bar, say));
    let patterns = patterns.transpose()?;
    let rate =
        args.has(ComparisonPart::Rate).then(|| rate::measure(&mesh, &args.rates, bar, say)).transpose()?;
    let assets = args
        .has(ComparisonPart::Assets)
        .then(|| assets::measure(&mesh, &args.assets, bar, say))
        .transpose()?;
    let clusters = args.has(ComparisonPart::Clusters).then(|| clusters::measure(&mesh, say)).transpose()?;
    Ok(MeshComparison {
        name,
        vertex_count: mesh.vertex_count(),
        triangle_count: mesh.triangle_count(),
        component_count,
        strips,
        papers: models.as_ref().map_or_else(Vec::new, papers::compare),
        models,
        views,
        patterns,
        rate,
        assets,
        clusters,
    })
}

fn measure_strips(
    mesh: &IndexedMesh,
    args: &CompareArgs,
    bar: &mut Bar,
    say: &dyn Fn(&str),
) -> Result<StripsReport, Failure> {
    let (searches, lengths, seeds) = (&args.strips.tunnel_searches[..], args.tunnels(), args.seeds());
    say(&format!("tunnels of up to {} links, {seeds} seeds each", lengths.iter().max().unwrap_or(&0)));
    let mut show_share = |share| bar.share("tunnels", share);
    let tunnel_lengths = tunnels::measure(mesh, searches, lengths, seeds, &mut show_share)?;
    let mut show = |name: &str| say(name);
    let stripifiers = stripifiers::measure(mesh, &args.strips.chains, args.budgets(), &mut show)?;
    Ok(StripsReport { strip_count_bound: strip_count_bound(mesh), tunnel_lengths, stripifiers })
}

impl ComparisonReport {
    fn to_text(&self) -> String {
        let mut text = String::new();
        for mesh in &self.meshes {
            text.push_str(&format!("{}: {}\n\n", mesh.name, mesh.summary()));
            mesh.add_text(&mut text);
        }
        if !self.assets_summary.is_empty() {
            text.push_str(&assets::summary_text(&self.assets_summary, text_of));
        }
        text.push_str(&format!("{}; all measured in {}\n", self.machine, format_duration(self.secs)));
        text
    }

    fn to_page(&self) -> Result<String, Failure> {
        let mut parts: Vec<MeshPart> =
            self.meshes.iter().map(MeshComparison::to_part).collect::<Result<_, Failure>>()?;
        let views: Vec<&ViewsReport> = self.meshes.iter().filter_map(|mesh| mesh.views.as_ref()).collect();
        parts.extend(views::by_size(&views)?);
        parts.extend(assets::summary_part(&self.assets_summary));
        Ok(page::render(&self.command, &self.machine, &parts))
    }
}

impl MeshComparison {
    fn summary(&self) -> String {
        // The bound does not apply to `cheapest`, which also joins strips at vertices.
        let bound = self.strips.as_ref().map_or_else(String::new, |strips| {
            format!(
                "; at least {} along its edges",
                format_noun_count(strips.strip_count_bound, "strip", "strips")
            )
        });
        format!(
            "{}, {}, {}{bound}",
            format_noun_count(self.triangle_count, "triangle", "triangles"),
            format_noun_count(self.vertex_count, "vertex", "vertices"),
            format_noun_count(self.component_count, "component", "components"),
        )
    }

    fn add_text(&self, text: &mut String) {
        if let Some(models) = &self.models {
            text.push_str(&models::to_text(models, text_of));
            text.push('\n');
        }
        if !self.papers.is_empty() {
            text.push_str(&format!("Compared with the papers: {}\n", papers::READING));
            text.push_str(&text_of(papers::table(&self.papers)));
            text.push('\n');
        }
        if let Some(views) = &self.views {
            text.push_str(&views::to_text(views, text_of));
            text.push('\n');
        }
        if let Some(patterns) = &self.patterns {
            text.push_str(&patterns::to_text(patterns, text_of));
            text.push('\n');
        }
        if let Some(rate) = &self.rate {
            text.push_str(&rate::to_text(rate, text_of));
            text.push('\n');
        }
        if let Some(assets) = &self.assets {
            text.push_str(&assets::to_text(assets, text_of));
            text.push('\n');
        }
        if let Some(clusters) = &self.clusters {
            text.push_str(&clusters::to_text(clusters, text_of));
            text.push('\n');
        }
        if let Some(strips) = &self.strips {
            text.push_str("Strips by the longest tunnel: mean and standard deviation, range, CPU seconds\n");
            text.push_str(&text_of(tunnels::table(&strips.tunnel_lengths)));
            text.push_str("\nTime against quality\n");
            text.push_str(&text_of(stripifiers::table(&strips.stripifiers)));
            text.push('\n');
        }
    }

    fn to_part(&self) -> Result<MeshPart, Failure> {
        let mut sections = Vec::new();
        if let Some(models) = &self.models {
            sections.extend(model_charts::sections(models)?);
        }
        if !self.papers.is_empty() {
            sections.push(papers::section(&self.papers));
        }
        if let Some(views) = &self.views {
            sections.extend(views::sections(views)?);
        }
        if let Some(patterns) = &self.patterns {
            sections.extend(patterns::sections(patterns)?);
        }
        if let Some(rate) = &self.rate {
            sections.push(rate::section(rate)?);
        }
        if let Some(assets) = &self.assets {
            sections.push(assets::section(assets)?);
        }
        sections.extend(self.clusters.as_ref().map(clusters::section));
        if let Some(strips) = &self.strips {
            sections.push(tunnels::section(&strips.tunnel_lengths)?);
            sections.push(stripifiers::section(&strips.stripifiers)?);
        }
        Ok(MeshPart { name: self.name.clone(), summary: self.summary(), sections })
    }
}

fn text_of(rows: Vec<Vec<String>>) -> String {
    let mut table = Table::default();
    rows.into_iter().for_each(|row| table.row(row));
    table.to_text()
}

/// Formats the command line so that it can be pasted into a shell.
fn command_line(arguments: impl Iterator<Item = String>) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./:,=+%@".contains(c);
    let quoted = arguments.map(|argument| {
        let needs_none = !argument.is_empty() && argument.chars().all(is_plain);
        if needs_none { argument } else { format!("'{}'", argument.replace('\'', "'\\''")) }
    });
    std::iter::once("striata-lab".to_owned()).chain(quoted).collect::<Vec<_>>().join(" ")
}

fn machine() -> String {
    let threads = std::thread::available_parallelism().map_or(1, |count| count.get());
    let version = env!("CARGO_PKG_VERSION");
    let (system, processor) = (std::env::consts::OS, std::env::consts::ARCH);
    let peers =
        if cfg!(feature = "peers") { "" } else { "; built without other tools (the feature `peers`)" };
    format!("striata {version} on {system}, {processor}, {threads} threads{peers}")
}

/// Checks that the folder of the page exists, so that `compare` fails before it measures rather than after.
fn check_folder(path: &Path) -> Result<(), Failure> {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            Err(Failure::user(format!("{}: there is no folder {}", path.display(), folder.display()))
                .with_hint("create the output folder first"))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn command_line_can_be_pasted() {
        let line = |arguments: &[&str]| command_line(arguments.iter().map(|&a| a.to_owned()));
        assert_eq!(line(&["compare", "a.ply", "--seeds", "3"]), "striata-lab compare a.ply --seeds 3");
        assert_eq!(line(&["it's here.ply", ""]), "striata-lab 'it'\\''s here.ply' ''");
    }
}
