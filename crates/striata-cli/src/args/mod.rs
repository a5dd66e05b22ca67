//! Command-line arguments: one type per verb, and the types of flag values.

mod paged;
mod render;
mod stream;
mod strips;
mod threads;
mod tiles;

use std::path::{Path, PathBuf};

use clap::{Args, Parser, Subcommand, ValueEnum};
use striata::model::{ModelKind, StageOptions};
#[cfg(feature = "gpu")]
use striata_command::args::DriverArgs;
use striata_command::args::{
    AxisAlignedBox, BUILD_STRIPS, Count, EditArgs, EyeArgs, FlatArgs, LEVEL, Length, LevelArgs, LevelsArgs,
    OutputArgs, RasterArgs, ReportArgs, STRIPS, SequenceArgs, StreamArgs, StripSearchArgs, TextureArgs,
    ViewArgs, strips_help,
};
use striata_command::strip_chain::{StripChain, StripPlan};
#[cfg(feature = "serve")]
use striata_viewer::serve::{PageArgs, ServeArgs, ThumbnailArgs};

pub(crate) use self::paged::{ByteSize, CellArgs, PagedArgs, PlanArgs, RunArgs};
pub(crate) use self::render::{DrawnModel, PictureBackground, RenderArgs};
pub(crate) use self::stream::{DecodeArgs, EncodeArgs};
pub(crate) use self::strips::StripArgs;
use self::threads::ThreadArgs;
pub(crate) use self::tiles::{PageBuildArgs, TilesArgs, TilesFormat, UpAxis};

/// The complete command line.
#[derive(Debug, Parser)]
#[command(
    name = "striata",
    version,
    about = "Continuous level of detail for triangle meshes",
    // Without a usage line, which the heading of the verbs makes redundant, and an empty one, the help fits one screen.
    help_template = "Continuous level of detail for triangle meshes (`striata VERB --help` for more):\n\
        {subcommands}\nOptions:\n{options}\nFormats: .ply .obj .stl .off .gltf .glb .stri .gz .zst. \
        See also: completions",
    subcommand_value_name = "VERB",
    disable_help_subcommand = true,
    disable_help_flag = true,
    max_term_width = 100
)]
pub(crate) struct Cli {
    /// The verb and its arguments.
    #[command(subcommand)]
    pub verb: Verb,
    /// Flags for what is printed.
    #[command(flatten)]
    pub report: ReportArgs,
}

impl Verb {
    /// Returns the files that the verb reads.
    pub(crate) fn inputs(&self) -> Vec<&Path> {
        match self {
            Self::Build(args) => {
                std::iter::once(&args.input).chain(&args.more).map(PathBuf::as_path).collect()
            }
            Self::Extract(args) => vec![&args.input],
            Self::Simplify(args) => vec![&args.input],
            Self::Strip(args) => vec![&args.input],
            Self::Convert(args) => vec![&args.input],
            Self::Encode(args) => vec![&args.input],
            Self::Decode(args) => vec![&args.input],
            Self::Render(args) => vec![&args.input],
            Self::Tiles(args) => args.inputs.iter().map(PathBuf::as_path).collect(),
            _ => Vec::new(),
        }
    }

    /// Returns the file that the verb writes, if the user has named one.
    pub(crate) fn output(&self) -> Option<&Path> {
        match self {
            Self::Build(args) => args.output.as_deref(),
            Self::Extract(args) => Some(args.output.path()),
            Self::Simplify(args) => Some(args.output.path()),
            Self::Strip(args) => args.output.as_deref(),
            Self::Convert(args) => Some(args.output.path()),
            Self::Encode(args) => args.output(),
            Self::Decode(args) => Some(args.output.path()),
            Self::Render(args) => Some(&args.output),
            Self::Tiles(args) => Some(&args.output),
            _ => None,
        }
    }

    /// Returns the number of threads that the user allows.
    pub(crate) fn thread_count(&self) -> Option<usize> {
        let args = match self {
            Self::Build(args) => args.threads,
            Self::Plan(args) => args.threads,
            Self::Run(args) => args.threads,
            Self::Extract(args) => args.threads,
            Self::Simplify(args) => args.threads,
            Self::Strip(args) => args.threads,
            Self::Distance(args) => args.threads,
            Self::Encode(args) => args.threads,
            Self::Decode(args) => args.threads,
            Self::Tiles(args) => args.threads,
            _ => return None,
        };
        args.count()
    }

    /// Whether the output may replace an input.
    pub(crate) fn is_forced(&self) -> bool {
        match self {
            Self::Build(args) => args.force,
            Self::Extract(args) => args.output.format.force,
            Self::Simplify(args) => args.output.format.force,
            Self::Strip(args) => args.force,
            Self::Convert(args) => args.output.format.force,
            Self::Encode(args) => args.force,
            Self::Decode(args) => args.output.format.force,
            _ => false,
        }
    }
}

/// The verbs of the command.
#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Build a .striata file with every level of detail of a mesh or scene
    Build(BuildArgs),
    /// Plan the build of a mesh larger than memory
    Plan(PlanArgs),
    /// Run one task of a plan, or all
    Run(RunArgs),
    /// Show what a mesh, scene, .striata file or stream contains
    Info(InfoArgs),
    /// Write one or more levels of a .striata file
    Extract(ExtractArgs),
    /// Simplify a mesh or scene to one or more levels
    Simplify(SimplifyArgs),
    /// Convert a mesh to triangle strips
    Strip(StripArgs),
    /// Measure the distance between two surfaces
    Distance(DistanceArgs),
    /// Convert between mesh formats
    Convert(ConvertArgs),
    /// Compress a mesh or scene into a progressive stream
    Encode(EncodeArgs),
    /// Decode a progressive stream, complete or cut off, into a mesh
    Decode(DecodeArgs),
    /// Write 3D Tiles, meshes for Neuroglancer, or arrays of levels (Zarr)
    Tiles(TilesArgs),
    /// Render a mesh, its levels or a view to a PNG file
    Render(Box<RenderArgs>),
    /// Serve a folder of models and the viewer over HTTP
    #[cfg(feature = "serve")]
    Serve(ServeArgs),
    /// View a mesh, a scene or a folder of them in the browser
    #[cfg(feature = "serve")]
    View(PageArgs),
    /// Create a demo: levels, pictures and a viewer of a built-in mesh
    Demo(DemoArgs),
    /// Render a small picture of a mesh, without a GPU
    #[cfg(feature = "serve")]
    #[command(hide = true)]
    Thumbnail(ThumbnailArgs),
    /// Print a completion script for a shell
    #[command(hide = true)]
    Completions(CompletionsArgs),
}

/// Help heading of the flags that limit the base mesh.
const BASE: &str = "Base mesh (the coarsest level)";

/// Limits of the base mesh.
#[derive(Debug, Args)]
pub(crate) struct BaseArgs {
    /// Stop at N triangles, or P% of the input [default: as few as possible]
    #[arg(long, value_name = "N|P%", allow_hyphen_values = true, help_heading = BASE)]
    pub base: Option<Count>,
    /// Fail and write nothing if --base cannot be reached
    #[arg(long, requires = "base", help_heading = BASE)]
    pub strict: bool,
    /// No point of the original is farther from a level (mesh units, or % of the diagonal); guaranteed, except that
    /// the errors of paged files are estimates
    #[arg(long, value_name = "DISTANCE", allow_negative_numbers = true, help_heading = BASE)]
    pub max_error: Option<Length>,
}

/// Arguments of `build`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata build [OPTIONS] <INPUT>... [-o <OUT.striata|OUT.glb|OUT.tscn>]",
    after_help = "Examples:\n  \
    striata build scan.ply --models lodstrips,fans --base 500 --max-error 1%\n  \
    striata build robot.gltf -o robot.glb --ranges 8"
)]
pub(crate) struct BuildArgs {
    /// Mesh or scene to read, - for stdin, or a built-in shape: shape:torus
    pub input: PathBuf,
    /// More files of the same mesh, for a paged file
    #[arg(value_name = "MORE")]
    pub more: Vec<PathBuf>,
    /// File to write, or - for stdout [default: the input with extension .striata]. A .glb is a plain glTF file at full
    /// detail, with vertices in refinement order and what makes levels of it (STRIATA_order). A .tscn or .tres is a scene or
    /// mesh for Godot with all levels
    #[arg(short, long, value_name = "OUT.striata")]
    pub output: Option<PathBuf>,
    /// Let the output replace the input
    #[arg(long)]
    pub force: bool,
    /// For .glb: also store the first N levels as index ranges, each with half of the triangles of the one before. For Godot:
    /// store only the first N levels
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub ranges: Option<u32>,
    /// For .glb: store clusters of at most N triangles for engines that draw meshlets (STRIATA_clusters), instead of
    /// vertices in refinement order [default N: 128]
    #[arg(
        long,
        value_name = "N",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "128",
        conflicts_with = "ranges",
        value_parser = clap::value_parser!(u32).range(2..=512)
    )]
    pub clusters: Option<u32>,
    /// Models to store: lodstrips (strips; small, fast), mts (strips rebuilt at each level), fans (for views;
    /// else `extract --eye` builds them), patterns (for views and boxes, with any --order), progressive
    /// (stream)
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', default_value = "lodstrips")]
    models: Vec<String>,
    /// Store only a compressed stream, like --models progressive; --bits sets the precision
    #[arg(long, conflicts_with = "models")]
    stream: bool,
    /// Store an error for each overlap of patterns, which views and boxes then evaluate
    #[arg(long)]
    pub overlap_errors: bool,
    /// Limits of the base mesh.
    #[command(flatten)]
    pub limits: BaseArgs,
    /// How the mesh is simplified.
    #[command(flatten)]
    pub sequence: SequenceArgs,
    /// Stripifiers of the full mesh.
    #[arg(
        long,
        value_name = "SPEC",
        help = format!("{} [default: {BUILD_STRIPS}]", strips_help()),
        help_heading = STRIPS,
    )]
    pub strips: Option<StripChain>,
    /// Strips to begin with, from another stripifier: a text with the vertices of a strip in each line, or a mesh
    /// with its triangles in the order of strips. Without --strips they stay as they are
    #[arg(long, value_name = "FILE", help_heading = STRIPS)]
    pub strips_from: Option<PathBuf>,
    /// For lodstrips: make new strips for levels that would need more indices per triangle, or `none` to edit
    /// the strips of the full mesh at all levels [default: 1.45]
    #[arg(long, value_name = "INDICES", value_parser = parse_strip_limit, help_heading = STRIPS)]
    pub max_strip_indices: Option<f64>,
    /// Options of stripifiers that search.
    #[command(flatten)]
    pub search: StripSearchArgs,
    /// How the stream is encoded.
    #[command(flatten)]
    pub stream_encoding: StreamArgs,
    /// Whether a scene becomes one mesh.
    #[command(flatten)]
    pub scene: FlatArgs,
    /// Parts of a scene that are left out.
    #[command(flatten)]
    pub edits: EditArgs,
    /// How textures are re-encoded.
    #[command(flatten)]
    pub textures: TextureArgs,
    /// How a mesh is built that does not fit into memory.
    #[command(flatten)]
    pub paged: PagedArgs,
    /// Show the seconds and the CPU seconds of each stage
    #[arg(long, help_heading = None, display_order = threads::ORDER - 1)]
    pub timings: bool,
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
}

/// Arguments of `info`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  striata info torus.striata\n  striata info shape:torus --models --json")]
pub(crate) struct InfoArgs {
    /// Mesh, .striata file or stream to read, or - for stdin
    pub input: PathBuf,
    /// Also build every model and report its size and build time
    #[arg(long)]
    pub models: bool,
    /// Whether a scene is described as one mesh.
    #[command(flatten)]
    pub scene: FlatArgs,
    /// How a raster is read.
    #[command(flatten)]
    pub raster: RasterArgs,
}

/// Arguments of `extract`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata extract [OPTIONS] <INPUT> <OUT> <LEVEL>",
    after_help = "Examples:\n  \
    striata extract torus.striata -o torus-{}.glb --levels 50%,25%,10%\n  \
    striata extract torus.striata -o view.glb --eye 0,2,3 --pixels 2"
)]
pub(crate) struct ExtractArgs {
    /// .striata file or stream to read, possibly cut off, or - for stdin
    pub input: PathBuf,
    /// Model to use: lodstrips, mts, fans, patterns or progressive [default: fans or patterns for --eye,
    /// patterns for --detail-box, else the first of these in the file]
    #[arg(long, value_name = "NAME")]
    pub model: Option<String>,
    /// Write triangles as list, strips or fans; strips and fans need .glb or .gltf, and since each fan is a
    /// primitive of its own, files with thousands of fans are large and slow to draw
    #[arg(long = "as", value_name = "FORM", default_value = "list", hide_possible_values = true)]
    pub form: TriangleForm,
    /// The level to produce.
    #[command(flatten)]
    pub level: LevelArgs,
    /// Several levels to produce.
    #[command(flatten)]
    pub levels: LevelsArgs,
    /// The eye of a view.
    #[command(flatten)]
    pub eye: EyeArgs,
    /// Full detail in this box (two opposite corners); outside, the base mesh or what --error or --triangles
    /// allow
    #[arg(
        long,
        value_name = "X,Y,Z,...",
        allow_hyphen_values = true,
        group = "LevelArgs",
        help_heading = LEVEL,
        conflicts_with_all = ["vertices", "detail", "split_count", "levels", "eye"],
    )]
    pub detail_box: Option<AxisAlignedBox>,
    /// Fail and write nothing if a level cannot be reached
    #[arg(long, help_heading = LEVEL)]
    pub strict: bool,
    /// The rest of the view.
    #[command(flatten)]
    pub view: ViewArgs,
    /// The output file.
    #[command(flatten)]
    pub output: OutputArgs,
    /// How textures are re-encoded.
    #[command(flatten)]
    pub textures: TextureArgs,
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
}

/// Arguments of `simplify`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata simplify [OPTIONS] <INPUT> <OUT> <LEVEL>",
    after_help = "Examples:\n  \
    striata simplify shape:torus -o small.ply --triangles 10%\n  \
    striata simplify robot.glb -o robot-{}.glb --levels 50%,10% --texture-max 512"
)]
pub(crate) struct SimplifyArgs {
    /// Mesh or scene to read, - for stdin, or a built-in shape: shape:torus
    pub input: PathBuf,
    /// Positions of vertices: subset (vertices of the input) or optimal (anywhere, with fitted attributes: about half
    /// the error) [default: optimal for one level, but subset if something refers to vertices of the input]
    #[arg(long, hide_possible_values = true)]
    pub placement: Option<PlacementArg>,
    /// The level to produce.
    #[command(flatten)]
    pub level: LevelArgs,
    /// Several levels to produce.
    #[command(flatten)]
    pub levels: LevelsArgs,
    /// Guarantee that no point of the original is farther from the level; alone or with another of these
    #[arg(
        long,
        value_name = "DISTANCE",
        allow_negative_numbers = true,
        group = "LevelArgs",
        help_heading = LEVEL,
    )]
    pub max_error: Option<Length>,
    /// Fail and write nothing if a level cannot be reached
    #[arg(long, help_heading = LEVEL)]
    pub strict: bool,
    /// How the mesh is simplified.
    #[command(flatten)]
    pub sequence: SequenceArgs,
    /// The output file.
    #[command(flatten)]
    pub output: OutputArgs,
    /// Whether a scene becomes one mesh.
    #[command(flatten)]
    pub scene: FlatArgs,
    /// Parts of a scene that are left out.
    #[command(flatten)]
    pub edits: EditArgs,
    /// How textures are re-encoded.
    #[command(flatten)]
    pub textures: TextureArgs,
    /// How a raster is read.
    #[command(flatten)]
    pub raster: RasterArgs,
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
}

/// Arguments of `distance`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata distance shape:torus small.ply\n  \
    striata distance scan.ply scan-small.glb --samples 2000000 --json")]
pub(crate) struct DistanceArgs {
    /// First mesh, or .striata file (its full mesh)
    pub a: PathBuf,
    /// Second mesh
    pub b: PathBuf,
    /// Number of sample points on each surface [default: 500000]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub samples: Option<usize>,
    /// Random seed of the sample points [default: 0]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub seed: Option<u64>,
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
}

/// Arguments of `convert`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata convert shape:torus torus.glb\n  \
    striata convert robot.gltf robot.glb --meshopt --texture-format webp")]
pub(crate) struct ConvertArgs {
    /// Mesh or scene to read, - for stdin, or a built-in shape: shape:torus
    pub input: PathBuf,
    /// The output file.
    #[command(flatten)]
    pub output: OutputArgs,
    /// Whether a scene becomes one mesh.
    #[command(flatten)]
    pub scene: FlatArgs,
    /// Parts of a scene that are left out.
    #[command(flatten)]
    pub edits: EditArgs,
    /// How textures are re-encoded.
    #[command(flatten)]
    pub textures: TextureArgs,
    /// How a raster is read.
    #[command(flatten)]
    pub raster: RasterArgs,
}

/// Arguments of `demo`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  striata demo\n  striata demo /srv/www/striata --json")]
pub(crate) struct DemoArgs {
    /// Folder to create and fill
    #[arg(value_name = "DIR", default_value = "striata-demo")]
    dir: PathBuf,
    /// Folder to create and fill, as an alternative to DIR
    #[arg(short, long, value_name = "DIR", conflicts_with = "dir")]
    output: Option<PathBuf>,
    /// Options for the messages of graphics drivers.
    #[cfg(feature = "gpu")]
    #[command(flatten)]
    pub drivers: DriverArgs,
}

impl DemoArgs {
    /// Returns the folder to fill.
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
    /// Shell to write the script for
    pub shell: clap_complete::Shell,
}

/// Primitive type that triangles are written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TriangleForm {
    /// Triangle list: three indices per triangle
    List,
    /// Triangle strips, joined by degenerate triangles; triangle lists for groups that need fewer indices
    /// that way
    Strips,
    /// Triangle fans
    Fans,
}

/// Positions that vertices of a simplified mesh may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlacementArg {
    /// Only at vertices of the input, with their attributes
    Subset,
    /// Anywhere: closer to the surface, with fitted attributes
    Optimal,
}

/// Parses the limit of indices per triangle; `none` is infinite. Below 1.2 strips are made again and again
/// without meeting it.
fn parse_strip_limit(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        _ if text == "none" => Ok(f64::INFINITY),
        Ok(limit) if limit.is_finite() && limit >= 1.2 => Ok(limit),
        _ => Err("must be a number, 1.2 or more, or none".to_owned()),
    }
}

impl BuildArgs {
    /// Returns the plan for the strips of the full mesh.
    pub(crate) fn strip_plan(&self) -> StripPlan {
        let chain = self.strips.clone().unwrap_or_else(|| BUILD_STRIPS.into());
        StripPlan { chain, search: self.search }
    }

    /// Returns when LodStrips begin a stage with new strips.
    pub(crate) fn stages(&self) -> StageOptions {
        let stages = StageOptions::default();
        self.max_strip_indices.map_or(stages, |limit| stages.with_max_indices_per_triangle(limit))
    }

    /// Returns the first given flag that has no effect without strips.
    pub(crate) fn strip_flag(&self) -> Option<&'static str> {
        let flags = [
            ("--strips", self.strips.is_some()),
            ("--strips-from", self.strips_from.is_some()),
            ("--budget", self.search.budget.is_some()),
            ("--max-strip-indices", self.max_strip_indices.is_some()),
        ];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }

    /// Whether only a stream is stored.
    pub(crate) fn is_stream(&self) -> bool {
        self.stream
    }

    /// Returns the names of the models to store, as the user spelled them.
    pub(crate) fn model_names(&self) -> Vec<String> {
        if self.stream { vec![ModelKind::Progressive.to_string()] } else { self.models.clone() }
    }

    /// Returns the plan for strips that is used without any flags.
    pub(crate) fn default_strip_plan() -> StripPlan {
        StripPlan { chain: BUILD_STRIPS.into(), search: StripSearchArgs::default() }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn clap_accepts_the_arguments() {
        Cli::command().debug_assert();
    }
}
