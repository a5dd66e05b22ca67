//! Reads and writes mesh files: PLY, OBJ, STL, OFF, glTF, VTK and 3MF, optionally compressed with gzip or zstd.
//!
//! ```no_run
//! let mesh = striata_io::read("bunny.ply")?;
//! striata_io::write("bunny.glb", &mesh, &striata_io::WriteOptions::default())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What readers accept
//!
//! Readers accept any bytes: they return a mesh, or an error with the place and the reason, and allocate no
//! more than the size of the input justifies. One rule holds for all formats, in memory and in pieces:
//!
//! * **Anything with a clear meaning is kept**, even if the format does not allow it: keywords in another case,
//!   line ends of any system, a byte order mark, counts in the line of the keyword, chunks without padding,
//!   explicit nulls.
//! * **Anything without a meaning is left out**, and reported once for each kind with a count and the first place,
//!   as a [`Warning`]: unknown statements, normals and texture coordinates that do not exist, polygons with less
//!   than three corners, points and lines.
//! * **Values that are not numbers are repaired** (`repair`): a vertex that is not finite is left out, with a warning if
//!   triangles use it, which are left out too. Normals and tangents follow from the triangles, texture
//!   coordinates become 0, colors 1, displacements 0, and weights are normalized. Generic attributes keep NaN,
//!   which means "no value" in them.
//! * **Damage that makes the rest meaningless is an error**: a position that does not exist, a file that is
//!   cut off, a text in which no line has a meaning. So is a file without bytes, and one with points or lines
//!   and no triangles.
//!
//! Reading takes three steps: `compressed` unpacks gzip and zstd, with a limit against decompression bombs;
//! `format` detects the format by content, and by extension if the content is inconclusive; the module of
//! the format builds an [`IndexedMesh`](striata::mesh::IndexedMesh). Writing runs in the other direction
//! and ends in `atomic`: a temporary file next to the target, which is renamed when it is complete. `error`
//! names the file, the place (line, byte or JSON path) and the reason of every error; `report` collects
//! warnings about parts that were left out. `blocks` handles files that do not fit into memory.
//!
//! Materials are kept as glTF objects, whatever format they come from. Images and material libraries are read
//! from files next to the source (`companions`, `images`), and `texture_set` makes textures of them.
//!
//! | format | parser | why |
//! | --- | --- | --- |
//! | PLY | own, `ply` | `ply-rs-bw` builds a map per vertex (27 MB/s), and its errors give no byte offsets |
//! | OBJ | own, `obj` | `tobj` is slower, its errors give no line numbers, and it loses material and library names |
//! | MTL | own, `obj/mtl` | `tobj` panics on short colors and rejects files for one bad number |
//! | STL | own, `stl` | 84 + 50 n bytes; welding is the main work, and is done in the same pass |
//! | OFF | own, `off` | uses the cursor that OBJ needs anyway |
//! | glTF, GLB | `serde_json`, own `gltf` | the `gltf` crate rejects scenes without nodes; more in `gltf` |
//! | VTK | `quick-xml`, own `vtk` | `vtkio` does not read the lists of cells that VTK writes since version 9, allocates by counts of the file, and its errors have no place |
//! | 3MF | `zip`, `quick-xml`, own `three_mf` | `threemf2` allocates what the archive declares, without a limit, and its errors have no place |
//! | glTF compression | `meshoptimizer-rs`, `draco-core` | safe Rust; they limit what they allocate |
//! | powers of colors | `libm` | the results of the platform's `powf` differ between machines |
//! | numbers in text | own, `text` | one exact division for up to 15 digits, otherwise the standard library |
//! | gzip, zstd | `flate2`, `zstd` | |
//!
//! `tobj`, `ply-rs-bw` and `gltf` are development dependencies: the tests compare our writers with them.
//!
//! Rules for all formats:
//!
//! * **Counts are never trusted.** Before allocating, they are checked against the remaining bytes (PLY,
//!   STL, OFF, VTK), against views and buffers (glTF accessors), or against the file's size (glTF instances,
//!   zero-filled accessors, images, parts of 3MF).
//! * **Texture coordinates of a mesh are glTF's** (`v` grows downward from the top of the image). In OBJ, PLY,
//!   OFF, VTK and 3MF `v` grows upward from the bottom, as Blender, MeshLab and trimesh write and read it, so it is
//!   flipped when read and when written: in decimal in text, within 2^-25 in binary PLY (exactly for pixels
//!   and short decimals).
//! * **Vertex colors are never converted** by reading and writing, so that round trips are exact. They are
//!   linear in glTF and sRGB in PLY, OBJ, OFF and VTK, which the mesh's appearance notes: call
//!   [`convert_colors`] before writing to the other kind. 3MF is read and
//!   written as a scene, with linear colors. The exception: PLY, OFF, VTK and 3MF store the first color set as bytes, because other programs take anything else for black; values
//!   outside 0 to 1 are clamped, and 16-bit values rounded, with a warning.
//! * **Files that the source refers to** are found under their names, with `\` as `/`, without a query, in
//!   another case, or percent-decoded, in this order. They are read inside its folder; also in folders above
//!   it if the source is a path, or [`Source::outside_allowed`] is set. A link that leads out of the folder is
//!   never followed, and nothing absolute is read. A missing file is a [`Warning`] that says why, except for
//!   buffers of glTF, without which there is no mesh.
//! * **Images that glTF cannot store** (TGA, BMP) become PNG when they are read, and the opacity of `map_d`
//!   becomes the alpha of the base color image.
//! * **Materials and images are written next to OBJ and PLY** ([`encode_mesh`]): an OBJ gets a library of its
//!   own name, a PLY `comment TextureFile`. Images are referred to if they lie there already, otherwise
//!   written; no different file is replaced.
//! * **The unit of 3MF** is kept in `asset.extras.unit` of the scene; coordinates stay as they are in the file. A
//!   scene is written in that unit or in meters, a single mesh in millimeters.
//! * **Data that a format cannot store** are left out with a warning each (layers, materials, names of
//!   groups), or refused with a reason if the file would be wrong (NaN in
//!   glTF).
//!
//! On wasm there are no files: functions that take a path are left out; [`read_bytes`] and [`to_bytes`]
//! remain.

#![cfg_attr(
    not(all(
        feature = "ply",
        feature = "obj",
        feature = "stl",
        feature = "off",
        feature = "gltf",
        feature = "threemf",
        feature = "vtk",
        feature = "meshopt",
        feature = "draco"
    )),
    allow(unused, unreachable_code, reason = "shared by formats that may all be left out")
)]

#[cfg(not(target_family = "wasm"))]
mod atomic;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
mod blocks;
mod cache_order;
mod color_space;
#[cfg(any(feature = "ply", feature = "obj", feature = "gltf"))]
mod companions;
mod compressed;
#[cfg(feature = "gltf")]
mod contacts;
mod error;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
mod file_view;
#[cfg_attr(target_family = "wasm", allow(dead_code, reason = "left out of web pages, to keep them small"))]
mod foreign;
mod format;
#[cfg(feature = "gltf")]
mod gltf;
#[cfg(any(feature = "ply", feature = "obj", feature = "gltf"))]
mod gltf_json;
#[cfg(any(feature = "ply", feature = "obj", feature = "gltf"))]
mod image_files;
#[cfg(all(feature = "images", any(feature = "ply", feature = "obj", feature = "gltf")))]
mod image_pixels;
#[cfg(any(feature = "ply", feature = "obj", feature = "gltf"))]
mod images;
#[cfg(not(target_family = "wasm"))]
mod lod;
#[cfg(any(
    feature = "ply",
    feature = "obj",
    feature = "off",
    feature = "stl",
    feature = "threemf",
    feature = "vtk"
))]
mod losses;
mod lost_data;
mod normals;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "off")]
mod off;
#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
pub mod pieces;
#[cfg(feature = "ply")]
mod ply;
mod read;
mod repair;
mod report;
#[cfg(feature = "gltf")]
mod scene;
mod source;
#[cfg(feature = "stl")]
mod stl;
mod text;
#[cfg(any(feature = "ply", feature = "obj"))]
mod texture_set;
#[cfg(feature = "threemf")]
mod three_mf;
#[cfg(feature = "vtk")]
mod vtk;
#[cfg(any(feature = "ply", feature = "obj", feature = "threemf"))]
mod wedges;
mod write;
mod write_options;

#[cfg(not(target_family = "wasm"))]
pub use atomic::{FileBatch, write_atomically};
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
pub use blocks::{StripSpool, TriangleBlocks};
pub use color_space::{
    convert_colors, linear_to_srgb, linear_to_srgb_colors, needs_other_colors, srgb_to_linear_colors,
};
pub use compressed::decompressed;
pub use error::{Place, ReadError, WriteError};
pub use format::Format;
#[cfg(feature = "draco")]
pub use gltf::encode_draco;
#[cfg(feature = "gltf")]
pub use gltf::{ExtensionUse, extension_use, known_extensions, shaded};
#[cfg(feature = "gltf")]
pub use gltf_json::texcoord_scale;
#[cfg(feature = "gltf")]
pub use image_files::OutputFiles;
#[cfg(not(target_family = "wasm"))]
pub use lod::{open, save};
pub use lost_data::losses;
#[cfg(feature = "gltf")]
pub use lost_data::{lost_group_names, scene_losses};
#[cfg(not(target_family = "wasm"))]
pub use read::{read, read_with_report};
pub use read::{read_bytes, read_bytes_with_report};
pub use report::{ReadReport, Warning};
#[cfg(feature = "gltf")]
pub use scene::{
    MergedParts, MeshData, Scene, SceneError, SceneInstance, SceneParts, SceneWriter, SharedMesh,
    encode_scene, mesh_data, read_scene_bytes, scene_to_bytes,
};
#[cfg(all(feature = "gltf", not(target_family = "wasm")))]
pub use scene::{read_scene, write_scene, write_scene_with_report};
pub use source::Source;
pub use write::{CompanionFile, EncodedMesh, encode_mesh, to_bytes};
#[cfg(not(target_family = "wasm"))]
pub use write::{write, write_with_report};
pub use write_options::{GridScope, QuantizeOptions, WriteOptions};

/// The README's example, compiled with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
