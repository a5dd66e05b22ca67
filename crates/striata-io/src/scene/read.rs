//! Reading of scenes, from a path or from bytes, in any format.

use std::borrow::Cow;
#[cfg(not(target_family = "wasm"))]
use std::path::Path;

use super::Scene;
use crate::read::read_bytes_with_report;
#[cfg(not(target_family = "wasm"))]
use crate::read::with_file;
use crate::report::{ReadReport, Warnings};
use crate::{Format, ReadError, Source, decompressed};

/// Reads a scene from a file of any known format.
///
/// A file without a scene becomes one with a single node. Missing image files do not fail: see
/// [`Scene::warnings`].
///
/// # Errors
/// Returns [`ReadError`] with the file, the place and the reason.
#[cfg(not(target_family = "wasm"))]
pub fn read_scene(path: impl AsRef<Path>) -> Result<Scene, ReadError> {
    with_file(path.as_ref(), read_scene_bytes)
}

/// Reads a scene from the bytes of a file.
///
/// # Errors
/// Returns [`ReadError`] with the source's name, the place and the reason.
pub fn read_scene_bytes(bytes: &[u8], source: &Source<'_>) -> Result<Scene, ReadError> {
    let (unpacked, name) = decompressed(Cow::Borrowed(bytes), source.name)?;
    match Format::detect(&unpacked, &name) {
        Some(format @ (Format::Gltf | Format::Glb)) => {
            let mut warnings = Warnings::of_file(source.name);
            let scene = crate::gltf::read_scene(&unpacked, format, source, &mut warnings);
            let scene = scene.map_err(|fault| fault.in_file(source.name))?;
            Ok(scene.with_warnings(warnings.into_list()))
        }
        #[cfg(feature = "threemf")]
        Some(Format::ThreeMf) => {
            let mut warnings = Warnings::of_file(source.name);
            let scene = crate::three_mf::read_scene(&unpacked, &mut warnings);
            let scene = scene.map_err(|fault| fault.in_file(source.name))?;
            Ok(scene.with_warnings(warnings.into_list()))
        }
        _ => {
            let ReadReport { mesh, warnings } =
                read_bytes_with_report(&unpacked, &Source { name: &name, ..*source })?;
            let scene = Scene::from_mesh(mesh).map_err(|error| error.in_file(source.name))?;
            Ok(scene.with_warnings(warnings))
        }
    }
}
