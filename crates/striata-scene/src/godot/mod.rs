//! Godot: scenes and meshes as text files that its editor opens without an add-on, with all levels.
//!
//! A surface of a Godot mesh has a vertex buffer, indices, and `lods`: indices of coarser levels over the same vertices,
//! each with an error in units of the mesh. The engine draws the coarsest level whose error is below a limit of pixels.
//! [`LodScene::to_godot`] writes the ranges of [`LodScene::ordered`] that way, as text that Godot 4.3 and later read:
//!
//! | extension | resource | contents |
//! | --- | --- | --- |
//! | `.tscn` | `PackedScene` | a node for each instance of a mesh, meshes, materials |
//! | `.tres` | `ArrayMesh` | one mesh with its materials |
//!
//! Images lie next to the file, where Godot imports them. Skins, morph targets, animations, lights and cameras are left
//! out, with a remark for each kind: scenes with them are better imported from a GLB file with levels (`docs/STRIATA_order.md`),
//! by the add-on in `engines/godot`.

mod material;
mod surface;
mod text;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::Path;

use striata::mesh::Semantic;
use striata_io::{EncodedMesh, OutputFiles, Scene};

use self::material::MaterialText;
use self::surface::{is_written, surface_text};
use self::text::{NodeNames, node_name, quoted};
use crate::document::{entries, has_triangles};
use crate::drawn::{Material, materials};
use crate::lod_scene::LodScene;
use crate::ordered::OrderedMesh;

/// Contents of a Godot file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GodotKind {
    /// A scene (`.tscn`).
    Scene,
    /// A mesh (`.tres`).
    Mesh,
}

/// Why a scene cannot become a Godot file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GodotError {
    /// A file of a mesh can have only one, and this scene shows several or none.
    #[error("a .tres file has one mesh, but this scene shows {0}")]
    MeshCount(usize),
}

impl GodotKind {
    /// Returns the kind that the extension of a file name stands for.
    pub fn from_extension(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?;
        let is = |name: &str| extension.eq_ignore_ascii_case(name);
        (is("tscn").then_some(Self::Scene)).or(is("tres").then_some(Self::Mesh))
    }
}

impl LodScene {
    /// Writes the scene as a Godot file with at most `level_count` levels in each surface, the full one included. Images become
    /// files next to the output, whose path decides their names; without a path they are only named.
    ///
    /// # Errors
    /// [`GodotError`] if a file of a mesh is asked for, and the scene does not show exactly one.
    pub fn to_godot(
        &self,
        kind: GodotKind,
        level_count: usize,
        output: Option<&Path>,
    ) -> Result<EncodedMesh, GodotError> {
        let instance_count = self.scene().instances().len();
        if kind == GodotKind::Mesh && instance_count != 1 {
            return Err(GodotError::MeshCount(instance_count));
        }
        let mut file = FileText::new(self.scene(), output);
        file.warn_of_document();
        let shown: BTreeSet<usize> = self.scene().instances().iter().map(|instance| instance.mesh).collect();
        let meshes: BTreeMap<usize, OrderedMesh> = (0..)
            .zip(self.ordered(level_count.max(1)))
            .filter_map(|(index, mesh)| Some((index, mesh?)))
            .filter(|(index, _)| shown.contains(index))
            .collect();
        meshes.iter().for_each(|(&index, mesh)| file.use_materials(index, mesh));
        let surfaces = meshes.iter().map(|(&index, mesh)| (index, file.mesh(index, mesh))).collect();
        Ok(file.finish(kind, &surfaces))
    }
}

/// The parts of a file.
struct FileText<'s> {
    scene: &'s Scene,
    materials: Vec<Material>,
    /// Name of the root.
    root: String,
    /// Text of each material that is used, by its index in the document; [`None`] for that of primitives without one.
    used: BTreeMap<Option<usize>, MaterialText>,
    files: OutputFiles<'s>,
}

impl<'s> FileText<'s> {
    fn new(scene: &'s Scene, output: Option<&Path>) -> Self {
        let stem = output.and_then(Path::file_stem).map(|stem| stem.to_string_lossy());
        Self {
            scene,
            materials: materials(scene),
            root: node_name(stem.as_deref().unwrap_or_default(), "Scene"),
            used: BTreeMap::new(),
            files: OutputFiles::new(scene.images(), output),
        }
    }

    /// Warns of what the document has and the file does not.
    fn warn_of_document(&mut self) {
        let document = self.scene.document();
        let count = |key: &str| entries(document, key).len();
        let lights =
            document.pointer("/extensions/KHR_lights_punctual").map_or(0, |all| entries(all, "lights").len());
        let primitives = || entries(document, "meshes").iter().flat_map(|mesh| entries(mesh, "primitives"));
        let kinds = [
            ("skins", count("skins")),
            ("animations", count("animations")),
            ("cameras", count("cameras")),
            ("lights", lights),
            (
                "primitives of points or lines",
                primitives().filter(|primitive| !has_triangles(primitive)).count(),
            ),
            (
                "primitives with morph targets",
                primitives().filter(|primitive| !entries(primitive, "targets").is_empty()).count(),
            ),
        ];
        for (kind, count) in kinds.into_iter().filter(|&(_, count)| count > 0) {
            self.files.warn(format!("{kind} are left out, of which there are {count}"));
        }
    }

    /// Writes the materials of a mesh that have not been written.
    fn use_materials(&mut self, index: usize, mesh: &OrderedMesh) {
        let has_colors = mesh.mesh.layer(&Semantic::Color(0)).is_some();
        for material in self.scene.primitive_materials(index) {
            let text = self.used.entry(material).or_insert_with(|| {
                let source = material.and_then(|material| self.materials.get(material));
                let source = source.cloned().unwrap_or_default();
                let is_known = |image: usize| {
                    self.scene.images().get(image).is_some_and(|image| !image.bytes.is_empty())
                };
                let mut text = MaterialText::new(&source, is_known);
                text.remarks.drain(..).for_each(|remark| self.files.warn(remark));
                let extensions =
                    material.and_then(|material| entries(self.scene.document(), "materials").get(material));
                let extensions = extensions.and_then(|material| material["extensions"].as_object());
                let lost = extensions.into_iter().flat_map(|all| all.keys()).filter(|name| !is_drawn(name));
                lost.for_each(|name| {
                    self.files.warn(format!("{name} of material {:?} is left out", source.name))
                });
                text
            });
            if has_colors {
                text.use_vertex_colors(mesh.mesh.appearance.color_space);
            }
        }
    }

    /// Returns the surfaces of a mesh.
    fn mesh(&mut self, index: usize, mesh: &OrderedMesh) -> String {
        let name = self.scene.mesh_name(index);
        for layer in mesh.mesh.layers.iter().filter(|layer| !is_written(&layer.semantic)) {
            self.files.warn(format!("the data {} of vertices are left out", layer.semantic));
        }
        let mut surfaces = Vec::new();
        for (primitive, material) in mesh.primitives.iter().zip(self.scene.primitive_materials(index)) {
            let Some(mut surface) = surface_text(&mesh.mesh, primitive) else { continue };
            let _ = writeln!(surface, "\"material\": SubResource(\"{}\"),", material_id(material));
            surfaces.push(format!("{{\n{surface}\"primitive\": 3,\n\"uv_scale\": Vector4(0, 0, 0, 0)\n}}"));
        }
        let name =
            if name.is_empty() { String::new() } else { format!("resource_name = {}\n", quoted(name)) };
        format!("{name}_surfaces = [{}]\n", surfaces.join(", "))
    }

    fn finish(mut self, kind: GodotKind, meshes: &BTreeMap<usize, String>) -> EncodedMesh {
        let mut text = match kind {
            GodotKind::Scene => "[gd_scene format=4]\n\n".to_owned(),
            GodotKind::Mesh => "[gd_resource type=\"ArrayMesh\" format=4]\n\n".to_owned(),
        };
        let images: BTreeSet<usize> = self.used.values().flat_map(MaterialText::images).collect();
        for image in images {
            let path = quoted(&self.files.name_of(image).unwrap_or_default());
            let _ = writeln!(text, "[ext_resource type=\"Texture2D\" path={path} id=\"image_{image}\"]\n");
        }
        for (&material, contents) in &self.used {
            let _ =
                writeln!(text, "[sub_resource type=\"StandardMaterial3D\" id=\"{}\"]", material_id(material));
            let _ = writeln!(text, "{contents}");
        }
        for (index, surfaces) in meshes {
            let _ = match kind {
                GodotKind::Mesh => write!(text, "[resource]\n{surfaces}"),
                GodotKind::Scene => {
                    writeln!(text, "[sub_resource type=\"ArrayMesh\" id=\"mesh_{index}\"]\n{surfaces}")
                }
            };
        }
        if kind == GodotKind::Scene {
            self.nodes(&mut text, meshes);
        }
        self.files.finish(text.into_bytes())
    }

    /// Writes a node for each instance.
    fn nodes(&self, text: &mut String, meshes: &BTreeMap<usize, String>) {
        let _ = writeln!(text, "[node name={} type=\"Node3D\"]\n", quoted(&self.root));
        let mut names = NodeNames::default();
        let nodes = entries(self.scene.document(), "nodes");
        for instance in self.scene.instances() {
            if !meshes.contains_key(&instance.mesh) {
                continue;
            }
            let node = instance.node.and_then(|node| nodes.get(node)).and_then(|node| node["name"].as_str());
            let name = names.unused(node_name(node.unwrap_or(self.scene.mesh_name(instance.mesh)), "Mesh"));
            let m = instance.transform;
            let rows = [m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10], m[12], m[13], m[14]];
            let rows = rows.map(|number| (number as f32).to_string()).join(", ");
            let _ = writeln!(text, "[node name={} type=\"MeshInstance3D\" parent=\".\"]", quoted(&name));
            let _ = writeln!(text, "transform = Transform3D({rows})");
            let _ = writeln!(text, "mesh = SubResource(\"mesh_{}\")\n", instance.mesh);
        }
    }
}

/// Name of a material within the file.
fn material_id(material: Option<usize>) -> String {
    material.map_or_else(|| "material_default".to_owned(), |material| format!("material_{material}"))
}

/// Whether [`Material`] contains what an extension of a material says.
fn is_drawn(extension: &str) -> bool {
    let known =
        ["KHR_materials_unlit", "KHR_materials_emissive_strength", "KHR_materials_pbrSpecularGlossiness"];
    known.contains(&extension)
}
