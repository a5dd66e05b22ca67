//! Errors of reading and writing images.

/// Why an image cannot be read or written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TextureError {
    /// The bytes begin like no format that is known here.
    #[error("the image has an unknown format: it begins with {found:02x?}")]
    Format {
        /// The first bytes, at most 8.
        found: Vec<u8>,
    },
    /// The header is malformed or truncated.
    #[error("the header of the {format} image is malformed")]
    Header {
        /// Name of the format.
        format: &'static str,
    },
    /// The header states more pixels than are allowed; nothing was decoded.
    #[error("the image has {width} x {height} pixels, but the limit is {limit}")]
    TooLarge {
        /// Width, pixels.
        width: u32,
        /// Height, pixels.
        height: u32,
        /// The limit, in words.
        limit: String,
    },
    /// The format is carried, but its pixels cannot be decoded.
    #[error("{format} images cannot be decoded")]
    NotDecoded {
        /// Name of the format.
        format: &'static str,
    },
    /// The decoder rejected the image.
    #[error("the image cannot be decoded: {reason}")]
    Malformed {
        /// Reason that the decoder gave.
        reason: String,
    },
    /// The encoder failed.
    #[error("the image cannot be encoded: {reason}")]
    Encode {
        /// Reason that the encoder gave.
        reason: String,
    },
    /// A parameter is out of range.
    #[error("{what} is {value}, but it must be {range}")]
    Parameter {
        /// Name of the parameter.
        what: &'static str,
        /// Its value.
        value: u32,
        /// The range, in words.
        range: &'static str,
    },
}
