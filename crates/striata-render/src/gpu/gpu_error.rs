//! Errors of this crate.

use std::fmt;

use striata::mesh::MeshError;

/// Why something could not be drawn.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// No suitable adapter was found.
    #[error("found no {wanted}")]
    NoAdapter {
        /// Kind of adapters that were considered, in words.
        wanted: &'static str,
    },
    /// Adapters were found, but none of them can draw.
    #[error("no graphics adapter can draw: {}", joined(.rejected))]
    NoUsableAdapter {
        /// The adapters, each with the reason.
        rejected: Vec<RejectedAdapter>,
    },
    /// No adapter's name contains the requested one.
    #[error("found no graphics adapter named {name:?}{}", others(.known))]
    NoSuchAdapter {
        /// The requested name.
        name: String,
        /// Names of the adapters that were found.
        known: Vec<String>,
    },
    /// The adapter did not open a device.
    #[error("cannot open a device on the adapter {adapter}: {reason}")]
    NoDevice {
        /// The adapter's name.
        adapter: String,
        /// The error that it reported.
        reason: String,
    },
    /// A buffer would exceed the device's limit.
    #[error(
        "{what}: {needed_bytes} bytes are needed, but {adapter} allows at most {limit_bytes} bytes per buffer"
    )]
    TooLarge {
        /// Intended contents of the buffer.
        what: &'static str,
        /// Size of the buffer, bytes.
        needed_bytes: u64,
        /// The device's limit, bytes.
        limit_bytes: u64,
        /// The adapter's name.
        adapter: String,
    },
    /// The picture is empty, or one of its sides exceeds the device's limit.
    #[error("cannot draw {width} x {height} pixels: each side must be 1 to {limit}")]
    PictureSize {
        /// Requested width, pixels.
        width: u32,
        /// Requested height, pixels.
        height: u32,
        /// Longest side that the device supports, pixels.
        limit: u32,
    },
    /// A mesh is inconsistent.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// An image is empty, or its bytes do not match its size.
    #[error(
        "image {image} has {found_bytes} bytes for {width} x {height} pixels; it must have 4 bytes per pixel \
         and at least one pixel"
    )]
    ImageSize {
        /// Index of the image.
        image: usize,
        /// Width, pixels.
        width: u32,
        /// Height, pixels.
        height: u32,
        /// Number of bytes found.
        found_bytes: usize,
    },
    /// A material uses an image that does not exist.
    #[error("material {material:?} uses image {image}, but there are {image_count} images")]
    NoSuchImage {
        /// Name of the material.
        material: String,
        /// The image index it contains.
        image: usize,
        /// Number of images.
        image_count: usize,
    },
    /// A part uses a material that does not exist.
    #[error("a part uses material {material}, but there are {material_count} materials")]
    NoSuchMaterial {
        /// The material index it contains.
        material: usize,
        /// Number of materials.
        material_count: usize,
    },
    /// A part uses indices beyond the end of their buffer.
    #[error("a part uses the indices {start}..{end}, but the buffer has {index_count}")]
    IndexRange {
        /// First index of the part.
        start: u32,
        /// One past its last index.
        end: u32,
        /// Number of indices that fit into the buffer.
        index_count: usize,
    },
    /// A scene has more lights than a frame can show.
    #[error("the scene has {count} lights, but a frame shows at most {limit}")]
    TooManyLights {
        /// Number of lights.
        count: usize,
        /// Largest number supported.
        limit: usize,
    },
    /// A crowd has more instances than one dispatch can process.
    #[error("the crowd has {count} instances, but this adapter processes at most {limit}")]
    TooManyInstances {
        /// Number of instances.
        count: usize,
        /// Largest number supported.
        limit: u32,
    },
    /// An instance of a crowd shows a mesh that does not exist.
    #[error("instance {instance} shows mesh {mesh}, but there are {mesh_count} meshes")]
    NoSuchMesh {
        /// Index of the instance.
        instance: usize,
        /// The mesh index it contains.
        mesh: usize,
        /// Number of meshes.
        mesh_count: usize,
    },
    /// An instance of a crowd cannot be placed.
    #[error(
        "instance {instance} has a transform that is not a rotation with a translation and a uniform scale, \
         or the eye is too far away, or there are several cameras or an orthographic one"
    )]
    Placement {
        /// Index of the instance.
        instance: usize,
    },
    /// The device was lost, or a result could not be read back.
    #[error("the graphics device failed: {0}")]
    Failed(String),
}

/// An adapter that was found but cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RejectedAdapter {
    /// The adapter's name and backend.
    pub name: String,
    /// Missing feature or failed operation, in one line.
    pub reason: String,
}

impl fmt::Display for RejectedAdapter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.name, self.reason)
    }
}

impl GpuError {
    /// Why an adapter cannot be used, in one line without its name: just the missing feature if that is
    /// known.
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

/// Lists the adapters that were found, for an error about one that was not.
fn others(known: &[String]) -> String {
    if known.is_empty() {
        "; no adapters were found".to_owned()
    } else {
        format!("; available: {}", known.join(", "))
    }
}
