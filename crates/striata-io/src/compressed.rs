//! Compression with gzip and zstd, for any format.
//!
//! Compressed data are recognized by their first bytes, never by the name. The size of the output is limited:
//! a file that grows out of all proportion is a decompression bomb, not a mesh.

use std::borrow::Cow;

use crate::ReadError;
#[cfg(feature = "compressed")]
use crate::error::Place;

/// Largest size that a compressed file may unpack to, in bytes.
#[cfg(any(feature = "compressed", feature = "threemf"))]
const MAX_BYTES: u64 = 4 << 30;

/// Size of the output from which its ratio to the input is limited, in bytes.
#[cfg(any(feature = "compressed", feature = "threemf"))]
const RATIO_CHECK_BYTES: u64 = 64 << 20;

/// A file may begin with this many zeros: STL has 80 bytes for a title.
#[cfg(feature = "compressed")]
const MAX_LEADING_ZEROS: u64 = 4096;

/// Largest number of nested compressions that are unpacked.
const MAX_LAYERS: usize = 3;

/// Returns the size to which a file may unpack, in bytes, if real ones grow at most by the factor `ratio`.
#[cfg(any(feature = "compressed", feature = "threemf"))]
pub(crate) fn unpacked_limit(input_bytes: u64, ratio: u64) -> u64 {
    MAX_BYTES.min(RATIO_CHECK_BYTES.max(input_bytes.saturating_mul(ratio)))
}

/// Compression of a whole file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Compression {
    Gzip,
    Zstd,
}

impl Compression {
    /// Detects compression by the first bytes of a file.
    pub(crate) fn of(bytes: &[u8]) -> Option<Self> {
        match bytes {
            [0x1f, 0x8b, 0x08, ..] => Some(Self::Gzip),
            [0x28, 0xb5, 0x2f, 0xfd, ..] => Some(Self::Zstd),
            _ => None,
        }
    }

    /// Returns the compression that a name's extension stands for.
    pub(crate) fn from_extension(name: &str) -> Option<Self> {
        match name.rsplit_once('.')?.1.to_ascii_lowercase().as_str() {
            "gz" => Some(Self::Gzip),
            "zst" => Some(Self::Zstd),
            _ => None,
        }
    }

    /// Largest ratio of output to input; real meshes stay below 200, even flat ones. No gzip file exceeds 1,032.
    #[cfg(feature = "compressed")]
    fn largest_ratio(self) -> u64 {
        match self {
            Self::Gzip => 400,
            Self::Zstd => 2000,
        }
    }

    pub(crate) fn as_str(self) -> &'static str {
        match self {
            Self::Gzip => "gzip",
            Self::Zstd => "zstd",
        }
    }
}

/// Unpacks gzip and zstd, and removes `.gz` and `.zst` from the name; other bytes are returned unchanged.
///
/// # Errors
/// Returns [`ReadError::Malformed`] if the compressed data are damaged or truncated, or unpack to more than
/// 4 GiB or a multiple of their size that no mesh reaches (400 for gzip, 2,000 for zstd), and [`ReadError::FeatureOff`] without the feature `compressed`.
pub fn decompressed<'a>(bytes: Cow<'a, [u8]>, name: &str) -> Result<(Cow<'a, [u8]>, String), ReadError> {
    let (mut bytes, mut inner_name) = (bytes, name.to_owned());
    for _ in 0..MAX_LAYERS {
        let Some(compression) = Compression::of(&bytes) else { break };
        bytes = Cow::Owned(unpack(&bytes, compression, name)?);
        if Compression::from_extension(&inner_name).is_some()
            && let Some((stem, _)) = inner_name.rsplit_once('.')
        {
            inner_name = stem.to_owned();
        }
    }
    if bytes.is_empty() {
        return Err(ReadError::Empty { file: name.to_owned() });
    }
    Ok((bytes, inner_name))
}

#[cfg(not(feature = "compressed"))]
fn unpack(_bytes: &[u8], compression: Compression, name: &str) -> Result<Vec<u8>, ReadError> {
    Err(ReadError::FeatureOff { file: name.to_owned(), what: compression.as_str(), feature: "compressed" })
}

#[cfg(feature = "compressed")]
fn unpack(bytes: &[u8], compression: Compression, name: &str) -> Result<Vec<u8>, ReadError> {
    let mut out = Vec::new();
    unpack_into(bytes, compression, name, &mut out).map(|()| out)
}

/// Unpacks a whole file into another one, under the limits of [`decompressed`].
#[cfg(feature = "compressed")]
pub(crate) fn unpack_into(
    bytes: &[u8],
    compression: Compression,
    name: &str,
    out: &mut dyn std::io::Write,
) -> Result<(), ReadError> {
    let limit = unpacked_limit(bytes.len() as u64, compression.largest_ratio());
    let mut guarded = Guarded { out, limit, count: 0, has_content: false, refusal: None, failure: None };
    let unpacked = match compression {
        Compression::Gzip => {
            std::io::copy(&mut flate2::bufread::MultiGzDecoder::new(bytes), &mut guarded).map(drop)
        }
        Compression::Zstd => unpack_zstd(bytes, &mut guarded),
    };
    let (Err(error), compression) = (unpacked, compression.as_str()) else { return Ok(()) };
    if let Some(source) = guarded.failure {
        return Err(ReadError::Io { file: name.to_owned(), source });
    }
    let reason = match guarded.refusal {
        Some(refusal) => format!("{} bytes of {compression} unpack to {refusal}", bytes.len()),
        None => format!("the {compression} data are damaged or truncated: {error}"),
    };
    Err(ReadError::Malformed { file: name.to_owned(), place: Place::File, reason })
}

/// Output of a decompression that stops it as soon as the result cannot be a mesh.
#[cfg(feature = "compressed")]
struct Guarded<'a> {
    out: &'a mut dyn std::io::Write,
    limit: u64,
    count: u64,
    /// Whether a byte was not zero.
    has_content: bool,
    refusal: Option<String>,
    /// Failure of the output itself.
    failure: Option<std::io::Error>,
}

#[cfg(feature = "compressed")]
impl std::io::Write for Guarded<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.count += bytes.len() as u64;
        self.has_content = self.has_content || bytes.iter().any(|&byte| byte != 0);
        if self.count > self.limit {
            self.refusal = Some(format!("more than {} bytes, which no mesh does", self.limit));
        } else if !self.has_content && self.count > MAX_LEADING_ZEROS {
            self.refusal = Some("zeros, with which no format begins".to_owned());
        }
        if self.refusal.is_none() {
            self.failure = self.out.write_all(bytes).err();
        }
        let is_written = self.refusal.is_none() && self.failure.is_none();
        is_written.then_some(bytes.len()).ok_or_else(|| std::io::Error::other("not written"))
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.out.flush()
    }
}

#[cfg(all(feature = "compressed", not(target_family = "wasm")))]
fn unpack_zstd(bytes: &[u8], out: &mut Guarded<'_>) -> std::io::Result<()> {
    std::io::copy(&mut zstd::stream::read::Decoder::with_buffer(bytes)?, out).map(drop)
}

/// Unpacks frame by frame, for targets on which zstd's own library does not compile.
#[cfg(all(feature = "compressed", target_family = "wasm"))]
fn unpack_zstd(mut bytes: &[u8], out: &mut Guarded<'_>) -> std::io::Result<()> {
    while !bytes.is_empty() {
        let decoder = ruzstd::decoding::StreamingDecoder::new(&mut bytes).map_err(std::io::Error::other)?;
        std::io::copy(&mut { decoder }, out)?;
    }
    Ok(())
}

/// Compresses a whole file.
#[cfg(all(feature = "compressed", not(target_family = "wasm")))]
pub(crate) fn packed(bytes: &[u8], compression: Compression) -> std::io::Result<Vec<u8>> {
    use std::io::Write as _;
    match compression {
        Compression::Gzip => {
            let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
            encoder.write_all(bytes)?;
            encoder.finish()
        }
        Compression::Zstd => zstd::bulk::compress(bytes, 3),
    }
}
