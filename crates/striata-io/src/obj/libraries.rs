//! Reads the material libraries that an OBJ file names, and gives its materials their appearance.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;
use striata::mesh::{IndexedMesh, Material, Semantic};

use super::materials::{Converter, DefinitionOrigin};
use super::mtl::{self, Definition, Library};
use crate::Source;
use crate::companions::NameKind;
use crate::error::Place;
use crate::report::Warnings;
use crate::texture_set::{TextureSet, shortened};

/// A `mtllib` statement.
pub(super) struct LibraryStatement {
    /// One file name with blanks, or several file names.
    pub names: String,
    pub line: u64,
}

/// A library that has been read.
struct LoadedLibrary {
    /// Path in messages.
    file: String,
    /// Folder of the library, relative to that of the source.
    folder: String,
    library: Library,
}

/// Gives the materials of a mesh their appearance. Materials without a definition keep only their names.
pub(super) fn attach(
    mesh: &mut IndexedMesh,
    statements: &[LibraryStatement],
    input_bytes: u64,
    source: &Source<'_>,
    warnings: &mut Warnings,
) {
    let mut textures = TextureSet::new(source, input_bytes);
    let names: BTreeSet<&str> = mesh.appearance.materials.iter().map(|m| m.name.as_str()).collect();
    let mut loader = Loader { textures: &mut textures, warnings, wanted: &names, seen: BTreeSet::new() };
    let libraries: Vec<LoadedLibrary> = statements.iter().flat_map(|it| loader.load_all(it)).collect();
    if libraries.is_empty() {
        return;
    }
    let definitions = definitions_by_name(&libraries);
    let has_texcoords = mesh.layer(&Semantic::TexCoord(0)).is_some();
    let mut values = Vec::new();
    for material in &mut mesh.appearance.materials {
        let Some(&(definition, loaded)) = definitions.get(material.name.as_str()) else {
            let name = shortened(&material.name);
            warnings.push(Place::File, format!("material `{name}` is not in the material libraries"));
            continue;
        };
        let (file, folder) = (loaded.file.as_str(), loaded.folder.as_str());
        let origin = DefinitionOrigin { file, folder, is_from_blender: loaded.library.is_from_blender };
        let mut converter = Converter { textures: &mut textures, warnings, has_texcoords };
        let value = converter.material(definition, origin);
        material.gltf_json = value.to_string();
        values.push(value);
    }
    fill_appearance(mesh, textures, &values);
}

/// Replaces everything in the appearance but the materials and the names of the libraries.
fn fill_appearance(mesh: &mut IndexedMesh, textures: TextureSet<'_>, values: &[Value]) {
    let appearance = &mut mesh.appearance;
    let materials: Vec<Material> = std::mem::take(&mut appearance.materials);
    let material_libraries = std::mem::take(&mut appearance.material_libraries);
    *appearance = textures.into_appearance(materials, values);
    appearance.material_libraries = material_libraries;
}

/// Reads libraries; a file that is named several times is read once.
struct Loader<'l, 'a> {
    textures: &'l mut TextureSet<'a>,
    warnings: &'l mut Warnings,
    /// Names of the materials of the mesh.
    wanted: &'l BTreeSet<&'l str>,
    seen: BTreeSet<String>,
}

impl Loader<'_, '_> {
    fn load_all(&mut self, statement: &LibraryStatement) -> Vec<LoadedLibrary> {
        let names = self.file_names(&statement.names);
        names.iter().filter_map(|name| self.load(name, statement.line)).collect()
    }

    /// Splits the names of a statement. A name may contain blanks, so the whole text is tried first, then
    /// the parts that end in `.mtl`, then single words.
    fn file_names(&mut self, names: &str) -> Vec<String> {
        let exists = self.textures.companions().find("", names, NameKind::Plain).file.is_ok();
        let words: Vec<&str> = names.split_whitespace().collect();
        let is_library = |word: &&str| word.to_ascii_lowercase().ends_with(".mtl");
        let library_count = words.iter().filter(|word| is_library(word)).count();
        if exists || words.len() < 2 || library_count == 1 {
            return vec![names.to_owned()];
        }
        if library_count == 0 {
            return words.into_iter().map(str::to_owned).collect();
        }
        words.split_inclusive(is_library).map(|part| part.join(" ")).collect()
    }

    /// Reads and parses a library; warns if that is not possible.
    fn load(&mut self, name: &str, line: u64) -> Option<LoadedLibrary> {
        let companion = self.textures.companions().find("", name, NameKind::Plain);
        if !self.seen.insert(companion.relative.clone()) {
            return None;
        }
        let folder = companion.folder().to_owned();
        let read = companion.file.and_then(|found| {
            let read = self.textures.budget().read(found.file).map_err(|error| error.to_string());
            Ok((read?, found.path.display().to_string()))
        });
        let (bytes, file) = match read {
            Ok(read) => read,
            Err(reason) => {
                let reason = format!("material library `{}`: {reason}", shortened(name));
                self.warnings.push(Place::Line(line), reason);
                return None;
            }
        };
        let library = mtl::parse(&bytes, self.wanted, &file, self.warnings);
        Some(LoadedLibrary { file, folder, library })
    }
}

/// Returns the first definition of each name, with its library.
fn definitions_by_name(libraries: &[LoadedLibrary]) -> BTreeMap<&str, (&Definition, &LoadedLibrary)> {
    let mut out = BTreeMap::new();
    for loaded in libraries {
        for definition in &loaded.library.materials {
            out.entry(definition.name.as_str()).or_insert((definition, loaded));
        }
    }
    out
}
