//! The arguments of the command: one type per verb, and the values that flags take.

mod render;
mod stream;
mod strips;

use std::path::{Path, PathBuf};

use clap::{Args, Parser, Subcommand, ValueEnum};
use striata::model::ModelKind;
#[cfg(feature = "gpu")]
use striata_command::args::DriverArgs;
use striata_command::args::{
    BUILD_STRIPS, Corners, Count, EyeArgs, FormatArgs, LEVEL, Length, LevelArgs, LevelsArgs, OutputArgs,
    ReportArgs, STRIPS, SequenceArgs, StreamArgs, StripSearchArgs, ViewArgs, strips_help,
};
use striata_command::strip_chain::{StripChain, StripPlan};
#[cfg(all(feature = "serve", not(feature = "window")))]
use striata_viewer::BrowserArgs;
#[cfg(feature = "serve")]
use striata_viewer::serve::{ServeArgs, ThumbnailArgs};
#[cfg(feature = "window")]
use striata_viewer::window::WindowArgs;

pub(crate) use self::render::{Background, DrawnModel, RenderArgs};
pub(crate) use self::stream::{DecodeArgs, EncodeArgs};
pub(crate) use self::strips::StripArgs;

/// Everything on the command line.
#[derive(Debug, Parser)]
#[command(
    name = "striata",
    version,
    about = "Continuous level of detail for triangle meshes",
    // No line for the usage, which the verbs' heading tells: all of it fits one screen.
    help_template = "{about}\n{all-args}\nMeshes: .ply .obj .stl .off .gltf .glb .stri, .gz, .zst; `-` is stdin or stdout.",
    subcommand_value_name = "VERB",
    subcommand_help_heading = "Verbs (`striata VERB --help` tells all of one, with examples)",
    disable_help_subcommand = true,
    disable_help_flag = true,
    max_term_width = 100
)]
pub(crate) struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub(crate) verb: Verb,
    /// How to report.
    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

/// The verbs.
#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Turn a mesh into one .striata file that holds every level
    Build(BuildArgs),
    /// Say what is inside a mesh or a .striata file
    Info(InfoArgs),
    /// Write one level of a .striata file as a mesh
    Extract(ExtractArgs),
    /// Simplify a mesh to one level
    Simplify(SimplifyArgs),
    /// Cover a mesh by triangle strips
    Strip(StripArgs),
    /// Measure the distance between two surfaces
    Distance(DistanceArgs),
    /// Convert between mesh formats
    Convert(ConvertArgs),
    /// Compress a mesh into a stream that shows it from the first bytes
    Encode(EncodeArgs),
    /// Write the mesh of a stream, or of as much of it as is there
    Decode(DecodeArgs),
    /// Draw a picture of a mesh, of some of its levels, or of a view
    Render(Box<RenderArgs>),
    /// Serve a folder of models and the viewer over HTTP
    #[cfg(feature = "serve")]
    Serve(ServeArgs),
    /// Look at a mesh at any level, in a window or a browser
    #[cfg(feature = "window")]
    View(WindowArgs),
    /// Look at a mesh at any level, in a window or a browser
    #[cfg(all(feature = "serve", not(feature = "window")))]
    View(BrowserArgs),
    /// Show it all on a mesh that the command carries
    Demo(DemoArgs),
    /// Draw a small picture of a mesh, without a GPU
    #[cfg(feature = "serve")]
    #[command(hide = true)]
    Thumbnail(ThumbnailArgs),
    /// Print a completion script for a shell
    #[command(hide = true)]
    Completions(CompletionsArgs),
}

/// Arguments of `build`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata build [OPTIONS] <INPUT> [-o <OUT.striata>]",
    after_help = "Examples:\n  \
    striata build bunny.ply -o bunny.striata\n  \
    striata build helmet.glb -o helmet.striata --base 500 --max-error 1%"
)]
pub(crate) struct BuildArgs {
    /// The mesh, or - for stdin
    pub(crate) input: PathBuf,
    /// The file to write, or - for stdout [default: the name of the input with .striata, in the same folder]
    #[arg(short, long, value_name = "OUT.striata")]
    pub(crate) output: Option<PathBuf>,
    /// Models to store, separated by commas: lodstrips (small, steps fast), mts (walks strips anew), fans (finer
    /// where a view asks for it; without them `extract --eye` builds them each time), patterns (the same for views and boxes,
    /// in less memory, of any order), progressive (a compressed stream, last in the file; alone it is the file)
    #[arg(long, value_name = "NAMES", value_delimiter = ',', default_value = "lodstrips")]
    models: Vec<String>,
    /// Store a stream alone, as --models progressive does: the mesh is compressed, as exact as --bits says
    #[arg(long, conflicts_with = "models")]
    stream: bool,
    /// Stop when at most this many triangles are left, or this share of them [default: as far as it goes]
    #[arg(long, value_name = "N|P%", allow_hyphen_values = true)]
    pub(crate) base: Option<Count>,
    /// Fail, and write nothing, if --base cannot be reached
    #[arg(long, requires = "base")]
    pub(crate) strict: bool,
    /// Never let the original be farther than this from a level, which is guaranteed: mesh units, or `1%` of the diagonal
    #[arg(long, value_name = "E", allow_negative_numbers = true)]
    pub(crate) max_error: Option<Length>,
    /// What is simplified first.
    #[command(flatten)]
    pub(crate) sequence: SequenceArgs,
    /// How the strips at full detail are made.
    #[arg(long, value_name = "SPEC", help = format!("{} [default: {BUILD_STRIPS}]", strips_help()), help_heading = STRIPS)]
    pub(crate) strips: Option<StripChain>,
    /// How long, and with which chances, strips are searched.
    #[command(flatten)]
    pub(crate) search: StripSearchArgs,
    /// How the stream is coded.
    #[command(flatten)]
    pub(crate) stream_terms: StreamArgs,
}

/// Arguments of `info`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  striata info bunny.striata\n  striata info scan.ply.gz --json")]
pub(crate) struct InfoArgs {
    /// A mesh, a .striata file or a stream, or - for stdin
    pub(crate) input: PathBuf,
    /// Also build every model and report what each would cost on this mesh
    #[arg(long)]
    pub(crate) models: bool,
}

/// Arguments of `extract`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata extract [OPTIONS] <INPUT> -o <OUT> <LEVEL>",
    after_help = "Examples:\n  \
    striata extract bunny.striata -o bunny-{}.glb --levels 50%,25%,10%\n  \
    striata extract bunny.striata -o seen.glb --eye 0,0.1,0.3 --pixels 2"
)]
pub(crate) struct ExtractArgs {
    /// A .striata file or a stream, which may be cut off, or - for stdin
    pub(crate) input: PathBuf,
    /// Which model of the file to use: lodstrips, mts, fans, patterns, progressive [default: for a view fans or patterns, for a
    /// box patterns, else the first of these that the file has]
    #[arg(long, value_name = "NAME")]
    pub(crate) model: Option<String>,
    /// How triangles are written; strips and fans need .glb or .gltf, where each fan is a primitive of its own: a
    /// few thousand make a large file that is slow to draw
    #[arg(long = "as", value_name = "FORM", default_value = "list")]
    pub(crate) form: TriangleForm,
    /// Which level.
    #[command(flatten)]
    pub(crate) level: LevelArgs,
    /// Which levels.
    #[command(flatten)]
    pub(crate) levels: LevelsArgs,
    /// From where.
    #[command(flatten)]
    pub(crate) eye: EyeArgs,
    /// Full detail in this box, by two of its corners; outside the base, or what --error or --triangles leave
    #[arg(long, value_name = "X,Y,Z,X,Y,Z", allow_hyphen_values = true, group = "LevelArgs", help_heading = LEVEL, conflicts_with_all = ["vertices", "detail", "split_count", "levels", "eye"])]
    pub(crate) detail_box: Option<Corners>,
    /// Fail, and write nothing, if a level cannot be reached
    #[arg(long, help_heading = LEVEL)]
    pub(crate) strict: bool,
    /// What a view needs beside its eye.
    #[command(flatten)]
    pub(crate) view: ViewArgs,
    /// Where the mesh goes.
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Arguments of `simplify`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata simplify [OPTIONS] <INPUT> -o <OUT> <LEVEL>",
    after_help = "Examples:\n  \
    striata simplify bunny.ply -o small.ply --triangles 10%\n  \
    striata simplify scan.obj -o scan.glb --max-error 0.5% --order hausdorff"
)]
pub(crate) struct SimplifyArgs {
    /// The mesh, or - for stdin
    pub(crate) input: PathBuf,
    /// Where vertices may lie: those of the input, or anywhere (nearer, attributes interpolated)
    #[arg(long, default_value = "subset")]
    pub(crate) placement: PlacementArg,
    /// Which level.
    #[command(flatten)]
    pub(crate) level: LevelArgs,
    /// Which levels.
    #[command(flatten)]
    pub(crate) levels: LevelsArgs,
    /// Never let the original be farther than this, which is guaranteed; alone or with another level: mesh units, or `1%` of
    /// the diagonal
    #[arg(long, value_name = "E", allow_negative_numbers = true, group = "LevelArgs", help_heading = LEVEL)]
    pub(crate) max_error: Option<Length>,
    /// Fail, and write nothing, if a level cannot be reached
    #[arg(long, help_heading = LEVEL)]
    pub(crate) strict: bool,
    /// What is simplified first.
    #[command(flatten)]
    pub(crate) sequence: SequenceArgs,
    /// Where the mesh goes.
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Arguments of `distance`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata distance bunny.ply bunny-5k.glb\n  \
    striata distance a.ply b.ply --samples 2000000 --json")]
pub(crate) struct DistanceArgs {
    /// One mesh (a .striata file stands for its full level)
    pub(crate) a: PathBuf,
    /// The other mesh
    pub(crate) b: PathBuf,
    /// Samples taken on each surface
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub(crate) samples: Option<usize>,
    /// Seed of the samples' places
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub(crate) seed: Option<u64>,
}

/// Arguments of `convert`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata convert scan.stl scan.glb\n  \
    striata convert helmet.gltf - --to ply --ascii")]
pub(crate) struct ConvertArgs {
    /// The mesh, or - for stdin
    pub(crate) input: PathBuf,
    /// The file to write, or - for stdout
    #[arg(value_name = "OUT", required_unless_present = "output_flag")]
    output_place: Option<PathBuf>,
    /// The same as OUT
    #[arg(id = "output_flag", short, long = "output", value_name = "OUT", conflicts_with = "output_place")]
    output_flag: Option<PathBuf>,
    /// How it is written.
    #[command(flatten)]
    pub(crate) format: FormatArgs,
}

impl ConvertArgs {
    /// The file to write.
    pub(crate) fn output(&self) -> Option<&Path> {
        self.output_flag.as_deref().or(self.output_place.as_deref())
    }
}

/// Arguments of `demo`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  striata demo\n  striata demo /srv/www/striata --json")]
pub(crate) struct DemoArgs {
    /// The folder to fill
    #[arg(value_name = "DIR", default_value = "striata-demo")]
    dir: PathBuf,
    /// The same as DIR
    #[arg(short, long, value_name = "DIR", conflicts_with = "dir")]
    output: Option<PathBuf>,
    /// How graphics drivers report.
    #[cfg(feature = "gpu")]
    #[command(flatten)]
    pub(crate) drivers: DriverArgs,
}

impl DemoArgs {
    /// The folder to fill.
    pub(crate) fn dir(&self) -> &Path {
        self.output.as_ref().unwrap_or(&self.dir)
    }
}

/// Arguments of `completions`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata completions bash > ~/.local/share/bash-completion/completions/striata\n  \
    striata completions fish > ~/.config/fish/completions/striata.fish")]
pub(crate) struct CompletionsArgs {
    /// The shell
    pub(crate) shell: clap_complete::Shell,
}

/// How triangles are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TriangleForm {
    /// Three indices a triangle
    List,
    /// Triangle strips joined by degenerate triangles; single triangles for groups where these take fewer indices
    Strips,
    /// Triangle fans
    Fans,
}

/// Where vertices may lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlacementArg {
    /// Only at vertices of the input, attributes untouched
    Subset,
    /// Anywhere: nearer to the surface, attributes interpolated
    Optimal,
}

impl BuildArgs {
    /// The strips asked for.
    pub(crate) fn strip_plan(&self) -> StripPlan {
        let chain = self.strips.clone().unwrap_or_else(|| BUILD_STRIPS.into());
        StripPlan { chain, search: self.search }
    }

    /// The first flag that only strips need.
    pub(crate) fn strip_flag(&self) -> Option<&'static str> {
        let flags = [("--strips", self.strips.is_some()), ("--budget", self.search.budget.is_some())];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }

    /// The models asked for, as they were spelled.
    pub(crate) fn model_names(&self) -> Vec<String> {
        if self.stream { vec![ModelKind::Progressive.to_string()] } else { self.models.clone() }
    }

    /// The strips that are made where nothing is asked for.
    pub(crate) fn usual_strip_plan() -> StripPlan {
        StripPlan { chain: BUILD_STRIPS.into(), search: StripSearchArgs::default() }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_tree_of_arguments_is_consistent() {
        Cli::command().debug_assert();
    }
}
