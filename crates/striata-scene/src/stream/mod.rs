//! A whole scene as one progressive stream: every prefix after the base is a complete, drawable scene.
//!
//! A stream consists of packets: the document with a table of everything, the base of every mesh and what
//! skins need, previews of the textures, and then refinement and whole images in the order in which they
//! improve the picture most per byte. Each mesh is a stream of its own ([`striata_stream`]), whose bytes are
//! distributed over packets. [`encode_scene`] writes a stream; [`SceneStreamDecoder`] reads it in pieces of
//! any size.
//!
//! | file | what it does |
//! | --- | --- |
//! | `packet.rs` | header of the stream, packets and their checksums |
//! | `head.rs` | the first packet: document and table |
//! | `precision.rs`, `motion.rs` | precision of each mesh from one tolerance for the scene |
//! | `schedule.rs`, `image_use.rs` | the order of refinement and images |
//! | `animation.rs` | precision of animations |
//! | `buffer.rs`, `filter.rs`, `accessors.rs` | animations and skins, compressed by accessor |
//! | `images.rs` | previews, and what follows of each image |
//! | `encode.rs`, `layout.rs` | the writer |
//! | `decoder.rs`, `received.rs` | the reader |
//! | `prefix.rs`, `weights.rs` | the scene that has been received so far |
//!
//! **Damage.** Every packet has a checksum; the stream of a mesh checks its chunks again. Damage gives an
//! error, and what was received before it remains available. The document unpacks to at most 128 times the
//! length of its packet (or 1 MiB), a part of the buffer to 1,100 times, and the streams of meshes are
//! bounded as `striata_stream` describes.
//!
//! # Example
//! ```
//! use striata::mesh::shapes;
//! use striata_io::Scene;
//! use striata_scene::stream::{SceneStreamDecoder, SceneStreamOptions, encode_scene};
//!
//! let scene = Scene::from_mesh(shapes::torus(32, 16, 1.0, 0.4))?;
//! let stream = encode_scene(&scene, &SceneStreamOptions::default())?;
//!
//! let mut decoder = SceneStreamDecoder::new();
//! for piece in stream.bytes.chunks(500) {
//!     decoder.push(piece)?;
//!     if decoder.is_drawable() {
//!         println!("{} triangles", decoder.scene()?.triangle_count());
//!     }
//! }
//! assert!(decoder.is_complete());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod accessors;
mod animation;
mod buffer;
mod bytes;
mod decoder;
mod deflate;
mod encode;
mod error;
mod filter;
mod head;
mod image_use;
mod images;
mod info;
mod json;
mod layout;
mod mesh_stream;
mod motion;
mod options;
mod packet;
mod precision;
mod prefix;
mod received;
mod schedule;
mod weights;

pub(crate) use precision::share_lattices;
pub(crate) use weights::normalize_weights;

pub use decoder::{MeshUpdate, SceneStreamDecoder, SceneStreamUpdate};
pub use encode::{EncodedScene, encode_scene, encode_scene_with_progress};
pub use error::{SceneEncodeError, SceneStreamError};
pub use images::{ImageState, ReceivedImage};
pub use info::{SceneStreamInfo, StreamedImage, StreamedMesh};
pub use layout::SceneStreamSizes;
pub use options::SceneStreamOptions;
pub use prefix::ReceivedDocument;
