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

/// Size of the output from which it may be at most [`MAX_RATIO`] times the input, in bytes.
#[cfg(any(feature = "compressed", feature = "threemf"))]
const RATIO_CHECK_BYTES: u64 = 64 << 20;

/// Largest ratio of output to input; real meshes stay below 200, even flat ones.
#[cfg(feature = "compressed")]
const MAX_RATIO: u64 = 2000;

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
/// 4 GiB or 2,000 times their size, and [`ReadError::FeatureOff`] without the feature `compressed`.
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
    use std::io::Read as _;
    let limit = unpacked_limit(bytes.len() as u64, MAX_RATIO);
    let mut out = Vec::new();
    let read = match compression {
        Compression::Gzip => {
            flate2::bufread::MultiGzDecoder::new(bytes).take(limit + 1).read_to_end(&mut out)
        }
        Compression::Zstd => unpack_zstd(bytes, limit + 1, &mut out),
    };
    let reason = match read {
        Err(error) => format!("the {} data are damaged or truncated: {error}", compression.as_str()),
        Ok(_) if out.len() as u64 > limit => format!(
            "{} bytes of {} unpack to more than {limit} bytes, which no mesh does",
            bytes.len(),
            compression.as_str()
        ),
        Ok(_) => return Ok(out),
    };
    Err(ReadError::Malformed { file: name.to_owned(), place: Place::File, reason })
}

/// Unpacks a whole file into another one, under the limits of [`decompressed`].
#[cfg(all(feature = "pieces", feature = "compressed", not(target_family = "wasm")))]
pub(crate) fn unpack_into(
    bytes: &[u8],
    compression: Compression,
    name: &str,
    out: &mut dyn std::io::Write,
) -> Result<(), ReadError> {
    use std::io::Read as _;
    let limit = unpacked_limit(bytes.len() as u64, MAX_RATIO);
    let mut decoder: Box<dyn std::io::Read + '_> = match compression {
        Compression::Gzip => Box::new(flate2::bufread::MultiGzDecoder::new(bytes).take(limit + 1)),
        Compression::Zstd => match zstd::stream::read::Decoder::with_buffer(bytes) {
            Ok(decoder) => Box::new(decoder.take(limit + 1)),
            Err(source) => return Err(ReadError::Io { file: name.to_owned(), source }),
        },
    };
    let reason = match std::io::copy(&mut decoder, out) {
        Err(error) => format!("the {} data are damaged or truncated: {error}", compression.as_str()),
        Ok(count) if count > limit => {
            format!("the {} data unpack to more than {limit} bytes, which no mesh does", compression.as_str())
        }
        Ok(_) => return Ok(()),
    };
    Err(ReadError::Malformed { file: name.to_owned(), place: Place::File, reason })
}

/// Unpacks at most `limit` bytes.
#[cfg(all(feature = "compressed", not(target_family = "wasm")))]
fn unpack_zstd(bytes: &[u8], limit: u64, out: &mut Vec<u8>) -> std::io::Result<usize> {
    use std::io::Read as _;
    zstd::stream::read::Decoder::with_buffer(bytes)?.take(limit).read_to_end(out)
}

/// Unpacks at most `limit` bytes, frame by frame, for targets on which zstd's own library does not compile.
#[cfg(all(feature = "compressed", target_family = "wasm"))]
fn unpack_zstd(mut bytes: &[u8], limit: u64, out: &mut Vec<u8>) -> std::io::Result<usize> {
    use std::io::Read as _;
    while !bytes.is_empty() && (out.len() as u64) < limit {
        let decoder = ruzstd::decoding::StreamingDecoder::new(&mut bytes).map_err(std::io::Error::other)?;
        decoder.take(limit - out.len() as u64).read_to_end(out)?;
    }
    Ok(out.len())
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
