//! 3MF: objects, components and build items become a scene, and scenes are written as objects and build items.
//!
//! | 3MF | scene |
//! | --- | --- |
//! | object with a mesh | mesh; instances share it |
//! | build item, component | node with a matrix |
//! | base materials | materials |
//! | color groups | vertex colors |
//! | texture groups | materials with a texture, and texture coordinates |
//! | unit, metadata | `asset.extras`; coordinates stay as they are in the file |
//!
//! Parts that production files refer to by `p:path` are read too. What else extensions add (beam lattices, slices,
//! composites, several properties at once) is left out with a warning.
//!
//! Own reader on `quick-xml` and `zip`: `threemf2` allocates what the archive declares without a limit, and its errors
//! have no place. `package` limits what is unpacked, as `compressed` does.

mod model;
mod package;
mod property;
mod scene;
mod write;

use striata::mesh::IndexedMesh;

use crate::error::{Fault, Place};
use crate::report::Warnings;
use crate::{Scene, SceneError};
use package::ThreeMfPackage;

pub(crate) use write::{mesh_to_bytes, scene_to_bytes};

/// Reads the build items of a file as a scene.
pub(crate) fn read_scene(bytes: &[u8], warnings: &mut Warnings) -> Result<Scene, Fault> {
    let mut package = ThreeMfPackage::open(bytes)?;
    scene::scene_of(&mut package, warnings)
}

/// Reads the build items of a file as one mesh, with all transforms applied.
pub(crate) fn read(bytes: &[u8], warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
    let scene = read_scene(bytes, warnings)?;
    scene.flattened().map_err(|error| Fault::Malformed(Place::File, error.to_string()))
}

fn broken(error: SceneError) -> Fault {
    Fault::Malformed(error.place, error.reason)
}
