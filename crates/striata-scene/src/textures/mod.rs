//! Textures: what an image contains, previews, and re-encoding.
//!
//! Images are bytes that striata carries along. This module reads their headers ([`image_info`]), makes
//! small previews and average colors for streams ([`preview`]), resizes or re-encodes them
//! ([`recode_scene`]), and decodes them for drawing ([`RgbaImage`]). The meaning of a pixel depends on the materials
//! that use the image: see [`TextureRole`].
//!
//! PNG, JPEG and WebP can be decoded. WebP is written without loss only, because the encoder in Rust has no
//! other mode. KTX2 and DDS, whose blocks are compressed for GPUs, are carried unchanged.
//!
//! **Limits.** Sizes are taken from the header before any pixel is decoded: at most [`MAX_SIDE`] pixels per
//! side, and at most [`MAX_PIXEL_BYTES`] of pixels. Images of more than 64 MiB must also have one byte of
//! file for every 2,048 bytes of pixels; real formats reach half of that. Decoding and converting
//! takes at most two and a half times the size of the pixels.
//!
//! Functions that decode or encode need the feature `textures`, which is on by default.

#[cfg(feature = "textures")]
mod decode;
#[cfg(feature = "textures")]
mod encode;
mod error;
mod info;
mod placeholder;
#[cfg(feature = "textures")]
mod preview;
#[cfg(feature = "textures")]
mod recode;
#[cfg(feature = "textures")]
mod recode_scene;
#[cfg(feature = "textures")]
mod resample;
#[cfg(feature = "textures")]
mod rgba;
mod role;
mod sources;
#[cfg(feature = "textures")]
mod srgb;

#[cfg(feature = "textures")]
pub use encode::EncodedImage;
pub use error::TextureError;
pub use info::{ImageFormat, ImageInfo, MAX_PIXEL_BYTES, MAX_SIDE, image_info};
pub use placeholder::placeholder_png;
#[cfg(feature = "textures")]
pub use preview::{Preview, preview};
#[cfg(feature = "textures")]
pub use recode::{RecodedImage, TextureFormat, TextureOptions, recode};
#[cfg(feature = "textures")]
pub use recode_scene::{ImageChange, TextureReport, recode_scene};
#[cfg(feature = "textures")]
pub use rgba::RgbaImage;
pub(crate) use role::images_of_material;
pub use role::{AlphaUse, TextureRole, TextureTransfer, image_roles};
pub(crate) use sources::without_sources;
