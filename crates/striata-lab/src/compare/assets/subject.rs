//! The mesh that all contenders simplify, and the data that levels are compared with.

use std::collections::HashMap;

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, weld};
use striata::simplify::BaseColor;

use super::gallery::Gallery;
use striata_command::failure::Failure;
use striata_scene::drawn::{ImageLimits, base_colors_of_mesh};
use striata_viewer::picture::{SceneLook, with_normals};

/// A mesh with the attributes that all contenders can weight.
pub(super) struct Subject {
    /// The mesh to simplify.
    pub(super) mesh: IndexedMesh,
    /// What the textures of its materials show.
    pub(super) base_colors: Vec<Option<BaseColor>>,
    /// The mesh with normals for comparison and lighting: its own, or smooth ones.
    pub(super) reference: IndexedMesh,
    /// Pictures of the mesh.
    pub(super) gallery: Gallery,
    /// The smooth normal of each position, if the mesh itself has no normals.
    smooth_normals: Option<HashMap<[u32; 3], [f32; 3]>>,
}

impl Subject {
    /// Welds the mesh, leaves out other attributes, and takes its pictures, with the materials if it has any.
    ///
    /// # Errors
    /// If the mesh has no triangles or its parts do not fit together.
    pub(super) fn new(mesh: &IndexedMesh) -> Result<Self, Failure> {
        let look = SceneLook::of_mesh(mesh, &ImageLimits::default());
        let base_colors = base_colors_of_mesh(mesh);
        let mesh = weld(&with_common_layers(mesh))?.mesh;
        if mesh.triangles.is_empty() {
            return Err(Failure::user("there is no triangle to simplify"));
        }
        let reference = with_normals(mesh.clone());
        let smooth_normals = mesh.layer(&Semantic::Normal).is_none().then(|| normals_by_position(&reference));
        let gallery = Gallery::of(&reference, look);
        Ok(Self { mesh, base_colors, reference, gallery, smooth_normals })
    }

    /// Whether the mesh itself has normals.
    pub(super) fn has_normals(&self) -> bool {
        self.smooth_normals.is_none()
    }

    /// Whether the mesh has texture coordinates.
    pub(super) fn has_uvs(&self) -> bool {
        self.mesh.layer(&Semantic::TexCoord(0)).is_some()
    }

    /// Adds normals to a level if needed: its own, or the original's smooth normals at the same positions.
    /// Materials get the numbers that they have in the original, which their names contain.
    pub(super) fn lit(&self, mut level: IndexedMesh) -> IndexedMesh {
        let numbers: Vec<Option<u32>> =
            level.appearance.materials.iter().map(|material| number_in(&material.name)).collect();
        for group in &mut level.groups {
            group.material = group.material.and_then(|own| *numbers.get(own as usize)?);
        }
        level.appearance.materials.clone_from(&self.mesh.appearance.materials);
        let Some(normals) = &self.smooth_normals else { return level };
        let normal = |p: &[f32; 3]| normals.get(&key(p)).copied().unwrap_or_default();
        let data = level.positions.iter().flat_map(normal).collect();
        level.layers.retain(|layer| layer.semantic != Semantic::Normal);
        level.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, data));
        level
    }
}

/// The bits of a position, with -0 as 0.
pub(super) fn key(position: &[f32; 3]) -> [u32; 3] {
    position.map(|x| (x + 0.0).to_bits())
}

/// Names of materials begin with this; their numbers follow.
const MATERIAL: &str = "material ";

fn number_in(name: &str) -> Option<u32> {
    name.strip_prefix(MATERIAL)?.parse().ok()
}

/// Keeps positions, normals, and the first set of texture coordinates and of colors; materials become
/// numbered ones without textures.
fn with_common_layers(mesh: &IndexedMesh) -> IndexedMesh {
    let is_common = |layer: &&AttributeLayer| match layer.semantic {
        Semantic::Normal => layer.component_count == 3,
        Semantic::TexCoord(0) => layer.component_count == 2,
        Semantic::Color(0) => matches!(layer.component_count, 3 | 4),
        _ => false,
    };
    let mut layers: Vec<AttributeLayer> = mesh.layers.iter().filter(is_common).map(as_floats).collect();
    layers.sort_by(|a, b| a.semantic.cmp(&b.semantic));
    let mut common = IndexedMesh { layers, ..mesh.clone() };
    common.groups.iter_mut().for_each(|group| group.name.clear());
    let materials = std::mem::take(&mut common.appearance.materials);
    common.appearance = Default::default();
    common.appearance.materials = (0..materials.len())
        .map(|index| striata::mesh::Material { name: format!("{MATERIAL}{index}"), ..Default::default() })
        .collect();
    common
}

/// Converts a layer to floats, which pass through every contender unchanged.
fn as_floats(layer: &AttributeLayer) -> AttributeLayer {
    if matches!(layer.data, LayerData::F32(_)) {
        return layer.clone();
    }
    let width = usize::from(layer.component_count);
    let data = (0..layer.data.len()).map(|at| layer.get(at / width, at % width)).collect();
    AttributeLayer::from_f32(layer.semantic.clone(), layer.component_count, data)
}

fn normals_by_position(mesh: &IndexedMesh) -> HashMap<[u32; 3], [f32; 3]> {
    let Some(layer) = mesh.layer(&Semantic::Normal) else { return HashMap::new() };
    let normal = |v: usize| [0, 1, 2].map(|k| layer.get(v, k));
    mesh.positions.iter().enumerate().map(|(v, position)| (key(position), normal(v))).collect()
}
