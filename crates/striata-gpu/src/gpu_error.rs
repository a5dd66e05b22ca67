//! What may go wrong on the way to a picture.

use std::fmt;

/// Nothing to draw with.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// No adapter that fits.
    #[error("found no graphics adapter{}", if *.is_fallback { " that draws on the processor" } else { "" })]
    NoAdapter {
        /// Whether one that draws on the processor was asked for.
        is_fallback: bool,
    },
    /// There are adapters, and none of them can draw.
    #[error("no graphics adapter can draw: {}", joined(.rejected))]
    NoUsableAdapter {
        /// Each of them with its reason.
        rejected: Vec<RejectedAdapter>,
    },
    /// No adapter whose name holds what was asked for.
    #[error("found no graphics adapter that is called {name:?}{}", others(.known))]
    NoSuchAdapter {
        /// What was asked for.
        name: String,
        /// The names of those that there are.
        known: Vec<String>,
    },
    /// The adapter gave no device.
    #[error("the adapter {adapter} gave no device: {reason}")]
    NoDevice {
        /// Its name.
        adapter: String,
        /// What it reported.
        reason: String,
    },
    /// More than the device can hold in one piece.
    #[error("{what} takes {needed_bytes} bytes, and {adapter} has at most {limit_bytes} for one buffer")]
    TooLarge {
        /// What was to be uploaded.
        what: &'static str,
        /// Its size.
        needed_bytes: u64,
        /// The device's limit.
        limit_bytes: u64,
        /// The adapter's name.
        adapter: String,
    },
    /// A picture of no pixels, or of more in a row than the device draws.
    #[error("cannot draw {width} x {height} pixels: each side must be 1 to {limit}")]
    PictureSize {
        /// Asked width.
        width: u32,
        /// Asked height.
        height: u32,
        /// The longest side.
        limit: u32,
    },
    /// The device was lost, or a result could not be read back.
    #[error("the graphics device failed: {0}")]
    Failed(String),
}

/// An adapter that was found and cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RejectedAdapter {
    /// Its name and its backend.
    pub name: String,
    /// What it lacks, or what failed, in one line.
    pub reason: String,
}

impl fmt::Display for RejectedAdapter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.name, self.reason)
    }
}

impl GpuError {
    /// Why an adapter cannot be used, without its name, in one line: the feature that it lacks if that is all.
    pub(crate) fn reason(&self) -> String {
        let text = match self {
            Self::Failed(reason) | Self::NoDevice { reason, .. } => reason.clone(),
            other => other.to_string(),
        };
        let flags = text.split_once("DownlevelFlags(").and_then(|(_, rest)| rest.split_once(')'));
        match flags {
            Some((flags, _)) => format!("it lacks {flags}"),
            None => text,
        }
    }
}

fn joined(rejected: &[RejectedAdapter]) -> String {
    rejected.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

/// What there is instead of what was asked for.
fn others(known: &[String]) -> String {
    if known.is_empty() {
        "; there is none at all".to_owned()
    } else {
        format!("; there are: {}", known.join(", "))
    }
}
