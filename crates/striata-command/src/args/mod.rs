//! Flags shared by several verbs, and the types that their values parse to.

mod coloring;
mod gltf;
mod length;
mod level;
mod output;
mod pose;
mod report;
mod scene;
mod sequence;
mod stream;
mod strips;
mod view;

pub use self::coloring::Coloring;
pub use self::gltf::GltfArgs;
pub use self::length::Length;
pub use self::level::{
    Count, EyeArgs, LEVEL, Level, LevelArgs, LevelChoice, LevelsArgs, OptionalLevel, parse_detail,
};
pub use self::output::{FormatArg, FormatArgs, OutputArgs};
pub use self::pose::{PoseArgs, find_entry};
#[cfg(feature = "gpu")]
pub use self::report::DriverArgs;
pub use self::report::ReportArgs;
pub use self::scene::{EditArgs, FlatArgs, RasterArgs, TextureArgs};
pub use self::sequence::{OrderArg, RetriangulationArg, SequenceArgs};
pub use self::stream::{EffortArg, StreamArgs};
pub use self::strips::{BUILD_STRIPS, STRIPS, StripSearchArgs, parse_at_least_zero, strips_help};
pub use self::view::{AxisAlignedBox, Point, ViewArgs, Viewport, tan};
