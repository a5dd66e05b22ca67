//! A scene at a time of an animation as one mesh, for renderers that draw one mesh.

use glam::{DMat3, DMat4, DVec3, Vec3};
use striata::mesh::{AttributeLayer, ColorSpace, IndexedMesh, Material, Semantic, TriangleGroup};
use striata_io::{Scene, SceneError, SceneInstance};

use crate::document::entries;
use crate::pose::VertexJoints;
use crate::{Pose, Poser};

/// Most triangles, and most vertices, of a posed mesh.
pub const MAX_POSED_COUNT: usize = 1 << 26;

/// Sets of texture coordinates that are kept.
const UV_SETS: u8 = 8;

/// Returns everything that the default scene shows in a pose as one mesh, in units of the scene.
///
/// The mesh has a group for each primitive of each instance. Materials are numbered as in the document.
/// Normals, tangents, texture coordinates and the first set of colors come along; a vertex that has no
/// normal gets a zero vector, and one without a color is white. The order of the triangles of mirrored
/// instances is reversed, so that their front stays in front.
///
/// # Errors
/// [`SceneError`] if the scene shows more than [`MAX_POSED_COUNT`] triangles or vertices.
pub fn posed_mesh(scene: &Scene, poser: &Poser, pose: &Pose) -> Result<IndexedMesh, SceneError> {
    let shown = || {
        let instances = scene.instances().iter();
        instances.filter_map(|instance| Some((instance, scene.meshes()[instance.mesh].as_ref()?)))
    };
    let count =
        |of: fn(&IndexedMesh) -> usize| shown().fold(0, |sum: usize, (_, mesh)| sum.saturating_add(of(mesh)));
    let (vertex_count, triangle_count) =
        (count(IndexedMesh::vertex_count), count(IndexedMesh::triangle_count));
    let largest = vertex_count.max(triangle_count);
    if largest > MAX_POSED_COUNT {
        let reason = format!("shows {largest} triangles or vertices, but the limit is {MAX_POSED_COUNT}");
        return Err(SceneError { place: striata_io::Place::Json("nodes".to_owned()), reason });
    }
    let material_count = entries(scene.document(), "materials").len();
    let mut posed = UnfinishedPose::new(shown().map(|(_, mesh)| mesh), vertex_count, triangle_count);
    for (instance, mesh) in shown() {
        posed.push(&InstancePose::new(poser, pose, instance), mesh);
        let materials = scene.primitive_materials(instance.mesh);
        posed.push_triangles(mesh, &materials, material_count);
    }
    Ok(posed.into_mesh(material_count))
}

/// How an instance moves its vertices.
struct InstancePose<'p> {
    matrix: DMat4,
    joints: Option<Vec<DMat4>>,
    weights: &'p [f32],
}

impl<'p> InstancePose<'p> {
    fn new(poser: &Poser, pose: &'p Pose, instance: &SceneInstance) -> Self {
        let joints = poser.joint_matrices(pose, instance);
        Self { matrix: pose.matrix_of(instance), joints, weights: pose.weights_of(instance) }
    }

    /// Whether the transform turns the front of triangles to the back.
    fn is_mirrored(&self) -> bool {
        let of = |matrix: &DMat4| DMat3::from_mat4(*matrix).determinant() < 0.0;
        match &self.joints {
            None => of(&self.matrix),
            // Most joints of a mirrored skin are mirrored.
            Some(joints) => 2 * joints.iter().filter(|joint| of(joint)).count() > joints.len(),
        }
    }
}

/// A posed mesh under construction.
struct UnfinishedPose {
    mesh: IndexedMesh,
    normals: Option<Vec<[f32; 3]>>,
    tangents: Option<Vec<[f32; 4]>>,
    uvs: Vec<(u8, Vec<[f32; 2]>)>,
    colors: Option<Vec<[f32; 4]>>,
    /// First vertex of the current instance.
    first: u32,
    is_mirrored: bool,
}

impl UnfinishedPose {
    fn new<'m>(
        meshes: impl Iterator<Item = &'m IndexedMesh>,
        vertex_count: usize,
        triangle_count: usize,
    ) -> Self {
        let (mut has_normals, mut has_tangents, mut has_colors) = (false, false, false);
        let mut has_uvs = [false; UV_SETS as usize];
        for layer in meshes.flat_map(|mesh| &mesh.layers) {
            match layer.semantic {
                Semantic::Normal => has_normals = true,
                Semantic::Tangent => has_tangents = true,
                Semantic::Color(0) => has_colors = true,
                Semantic::TexCoord(set) if set < UV_SETS => has_uvs[usize::from(set)] = true,
                _ => {}
            }
        }
        let sets = (0..UV_SETS).filter(|&set| has_uvs[usize::from(set)]);
        let mesh = IndexedMesh::new(Vec::with_capacity(vertex_count), Vec::with_capacity(triangle_count));
        Self {
            mesh,
            normals: has_normals.then(Vec::new),
            tangents: has_tangents.then(Vec::new),
            uvs: sets.map(|set| (set, Vec::new())).collect(),
            colors: has_colors.then(Vec::new),
            first: 0,
            is_mirrored: false,
        }
    }

    /// Appends the vertices of an instance.
    fn push(&mut self, pose: &InstancePose<'_>, mesh: &IndexedMesh) {
        self.first = self.mesh.positions.len() as u32;
        self.is_mirrored = pose.is_mirrored();
        let matrices = VertexMatrices::new(pose, mesh);
        let vertices = 0..mesh.vertex_count();
        let targets = MorphDisplacements::of(mesh, pose.weights, Semantic::MorphPosition);
        self.mesh.positions.extend(vertices.clone().map(|vertex| {
            let position = targets.apply(vertex, Vec3::from(mesh.positions[vertex]));
            finite(matrices.of(vertex).transform_point3(position.as_dvec3()).as_vec3())
        }));
        let directions = MorphDisplacements::of(mesh, pose.weights, Semantic::MorphNormal);
        let normals = mesh.layer(&Semantic::Normal).filter(|layer| layer.component_count == 3);
        if let Some(out) = &mut self.normals {
            out.extend(vertices.clone().map(|vertex| {
                let Some(layer) = normals else { return [0.0; 3] };
                let normal = directions.apply(vertex, vector(layer, vertex));
                unit(cofactors(&matrices.of(vertex)) * normal.as_dvec3())
            }));
        }
        let directions = MorphDisplacements::of(mesh, pose.weights, Semantic::MorphTangent);
        let tangents = mesh.layer(&Semantic::Tangent).filter(|layer| layer.component_count == 4);
        if let Some(out) = &mut self.tangents {
            out.extend(vertices.clone().map(|vertex| {
                let Some(layer) = tangents else { return [0.0; 4] };
                let tangent = directions.apply(vertex, vector(layer, vertex));
                let [x, y, z] = unit(matrices.of(vertex).transform_vector3(tangent.as_dvec3()));
                let side = if self.is_mirrored { -1.0 } else { 1.0 };
                [x, y, z, side * layer.get(vertex, 3)]
            }));
        }
        for (set, out) in &mut self.uvs {
            let layer = mesh.layer(&Semantic::TexCoord(*set)).filter(|layer| layer.component_count == 2);
            let uv = |vertex| layer.map_or([0.0; 2], |layer| [0, 1].map(|k| layer.get(vertex, k)));
            out.extend(vertices.clone().map(uv));
        }
        if let Some(out) = &mut self.colors {
            let layer = mesh.layer(&Semantic::Color(0)).filter(|layer| layer.component_count >= 3);
            out.extend(vertices.map(|vertex| {
                let channel = |layer: &AttributeLayer, k: usize| {
                    if k < usize::from(layer.component_count) { layer.get(vertex, k) } else { 1.0 }
                };
                layer.map_or([1.0; 4], |layer| [0, 1, 2, 3].map(|k| channel(layer, k)))
            }));
        }
    }

    /// Appends the triangles of the current instance.
    fn push_triangles(&mut self, mesh: &IndexedMesh, materials: &[Option<usize>], material_count: usize) {
        for (index, group) in mesh.groups_or_whole().iter().enumerate() {
            let material = materials.get(index).copied().flatten().filter(|&m| m < material_count);
            self.mesh.groups.push(TriangleGroup {
                material: material.map(|material| material as u32),
                first: self.mesh.triangles.len() as u32,
                count: group.count,
                ..group.clone()
            });
            let triangles = mesh.triangles[group.range()].iter();
            self.mesh.triangles.extend(triangles.map(|triangle| {
                let [a, b, c] = triangle.map(|vertex| vertex + self.first);
                if self.is_mirrored { [a, c, b] } else { [a, b, c] }
            }));
        }
    }

    fn into_mesh(self, material_count: usize) -> IndexedMesh {
        let Self { mut mesh, normals, tangents, uvs, colors, .. } = self;
        let mut push = |semantic, width, values| {
            mesh.layers.push(AttributeLayer::from_f32(semantic, width, values));
        };
        if let Some(normals) = normals {
            push(Semantic::Normal, 3, normals.into_flattened());
        }
        if let Some(tangents) = tangents {
            push(Semantic::Tangent, 4, tangents.into_flattened());
        }
        for (set, values) in uvs {
            push(Semantic::TexCoord(set), 2, values.into_flattened());
        }
        if let Some(colors) = colors {
            push(Semantic::Color(0), 4, colors.into_flattened());
            mesh.appearance.color_space = ColorSpace::Linear;
        }
        mesh.appearance.materials = vec![Material::default(); material_count];
        mesh
    }
}

/// The matrix of each vertex: one for all, or those of its joints.
struct VertexMatrices<'p, 'm> {
    pose: &'p InstancePose<'p>,
    joints: VertexJoints<'m>,
}

impl<'p, 'm> VertexMatrices<'p, 'm> {
    fn new(pose: &'p InstancePose<'p>, mesh: &'m IndexedMesh) -> Self {
        Self { pose, joints: VertexJoints::of(mesh) }
    }

    fn of(&self, vertex: usize) -> DMat4 {
        match &self.pose.joints {
            None => self.pose.matrix,
            Some(matrices) => self.joints.matrix(vertex, matrices).unwrap_or(DMat4::IDENTITY),
        }
    }
}

/// Displacements by the morph targets whose weights are not 0.
struct MorphDisplacements<'m>(Vec<(f32, &'m AttributeLayer)>);

impl<'m> MorphDisplacements<'m> {
    fn of(mesh: &'m IndexedMesh, weights: &[f32], semantic: fn(u16) -> Semantic) -> Self {
        let weighted = weights.iter().zip(0u16..).filter(|(weight, _)| **weight != 0.0);
        let layers = weighted.filter_map(|(&weight, target)| {
            let layer = mesh.layer(&semantic(target)).filter(|layer| layer.component_count == 3)?;
            Some((weight, layer))
        });
        Self(layers.collect())
    }

    fn apply(&self, vertex: usize, start: Vec3) -> Vec3 {
        self.0.iter().fold(start, |sum, (weight, layer)| sum + *weight * vector(layer, vertex))
    }
}

fn vector(layer: &AttributeLayer, vertex: usize) -> Vec3 {
    Vec3::new(layer.get(vertex, 0), layer.get(vertex, 1), layer.get(vertex, 2))
}

/// The matrix that transforms normals, up to their length: exists for flattening transforms too.
fn cofactors(matrix: &DMat4) -> DMat3 {
    let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(|axis| axis.truncate());
    let of = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
    if x.dot(y.cross(z)) < 0.0 { of * -1.0 } else { of }
}

fn unit(direction: DVec3) -> [f32; 3] {
    direction.normalize_or_zero().as_vec3().to_array()
}

/// Returns a position whose coordinates are numbers: broken matrices may not break the whole picture.
fn finite(position: Vec3) -> [f32; 3] {
    if position.is_finite() { position.to_array() } else { [0.0; 3] }
}
