//! The mesh that all contenders simplify, and the data that levels are compared with.

use std::collections::HashMap;

use glam::DVec3;
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, MeshError, Semantic, TriangleTree, weld};
use striata::simplify::BaseColor;

use super::attribute_distance::nearest_weights;
use super::gallery::Gallery;
use striata_command::failure::Failure;
use striata_render::{SceneLook, with_normals};
use striata_scene::drawn::{ImageLimits, base_colors_of_mesh};

/// A mesh with the attributes that all contenders can weight.
pub(super) struct ComparedAsset {
    /// The mesh to simplify.
    pub mesh: IndexedMesh,
    /// Base colors of its materials, as [`base_colors_of_mesh`] returns them.
    pub base_colors: Vec<Option<BaseColor>>,
    /// The mesh with normals for comparison and lighting: its own, or smooth ones.
    pub reference: IndexedMesh,
    /// Pictures of the mesh.
    pub gallery: Gallery,
    /// The smooth normals of the reference, if the mesh itself has none.
    smooth_normals: Option<SmoothNormals>,
}

impl ComparedAsset {
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
        let smooth_normals = match mesh.layer(&Semantic::Normal) {
            Some(_) => None,
            None => Some(SmoothNormals::of(&reference)?),
        };
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

    /// Adds normals to a level if needed: those of the original's smooth surface at the nearest points.
    /// Materials get the numbers that they have in the original, which their names contain.
    pub(super) fn lit(&self, mut level: IndexedMesh) -> IndexedMesh {
        let numbers: Vec<Option<u32>> =
            level.appearance.materials.iter().map(|material| number_in(&material.name)).collect();
        for group in &mut level.groups {
            group.material = group.material.and_then(|own| *numbers.get(own as usize)?);
        }
        level.appearance.materials.clone_from(&self.mesh.appearance.materials);
        let Some(normals) = &self.smooth_normals else { return level };
        let data = level.positions.iter().flat_map(|p| normals.at(p, &self.reference)).collect();
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

/// Normals of a smooth surface.
struct SmoothNormals {
    by_position: HashMap<[u32; 3], [f32; 3]>,
    /// For positions that the surface does not have.
    tree: TriangleTree,
}

impl SmoothNormals {
    fn of(mesh: &IndexedMesh) -> Result<Self, MeshError> {
        let normals = mesh.layer(&Semantic::Normal).into_iter();
        let by_position = normals.flat_map(|layer| {
            let normal = |v: usize| [0, 1, 2].map(|k| layer.get(v, k));
            mesh.positions.iter().enumerate().map(move |(v, position)| (key(position), normal(v)))
        });
        Ok(Self { by_position: by_position.collect(), tree: TriangleTree::new(mesh)? })
    }

    /// The normal at a position, or at the nearest point of the surface.
    fn at(&self, position: &[f32; 3], mesh: &IndexedMesh) -> [f32; 3] {
        if let Some(&normal) = self.by_position.get(&key(position)) {
            return normal;
        }
        let point = position.map(f64::from);
        let Some(nearest) = self.tree.nearest(point) else { return [0.0; 3] };
        let corners = mesh.triangles[nearest.triangle as usize].map(|v| &mesh.positions[v as usize]);
        let weights = nearest_weights(DVec3::from(point), corners.map(|&p| DVec3::from(p.map(f64::from))));
        let normals = corners.map(|p| self.by_position.get(&key(p)).copied().unwrap_or_default());
        let mixed = |k: usize| (0..3).map(|corner| weights[corner] * f64::from(normals[corner][k])).sum();
        DVec3::from([0, 1, 2].map(mixed)).normalize_or_zero().as_vec3().to_array()
    }
}
