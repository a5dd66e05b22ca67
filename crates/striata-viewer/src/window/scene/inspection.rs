//! The triangles of a scene one by one, with edges and colors: posed here, because the shader that draws
//! edges knows no skins.

use striata::mesh::IndexedMesh;
use striata_gpu::{
    Gpu, GpuError, GpuVertices, Inspection, Look, Painter, Scene, Viewpoint, palette_color, wgpu,
};

use super::shown::ShownScene;
use super::subject::SceneSubject;
use crate::window::state::Colors;

/// Individual triangles of a frame of a scene.
#[derive(Debug)]
pub(super) struct SceneInspection {
    vertices: GpuVertices,
    inspection: Inspection,
    scene: Scene,
}

impl SceneInspection {
    /// Poses all vertices, and uploads them with the triangles. Returns the uploaded bytes, too.
    ///
    /// # Errors
    /// If a buffer exceeds the device's limit.
    pub(super) fn new(
        gpu: &Gpu,
        painter: &Painter,
        subject: &SceneSubject,
        shown: &ShownScene,
        colors: Colors,
    ) -> Result<(Self, u64), GpuError> {
        let (mesh, colors) = posed(subject, shown, colors);
        let vertices = GpuVertices::upload(gpu, &mesh)?;
        let inspection = Inspection::new(gpu, painter, &vertices, &mesh.triangles, &colors)?;
        let placeholder =
            Viewpoint { eye: [0.0, 0.0, 1.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 1.0 };
        let scene = painter.scene(gpu, &vertices, (&placeholder, [1, 1]), &Look::default())?;
        let uploaded_bytes = 28 * mesh.vertex_count() as u64 + 16 * mesh.triangle_count() as u64;
        Ok((Self { vertices, inspection, scene }, uploaded_bytes))
    }

    /// Prepares a picture.
    pub(super) fn aim(&mut self, gpu: &Gpu, view: (&Viewpoint, [u32; 2]), look: &Look) {
        self.scene.update(gpu, &self.vertices, view, look);
    }

    /// Draws the triangles.
    pub(super) fn draw(&self, painter: &Painter, pass: &mut wgpu::RenderPass<'_>) {
        painter.inspect(pass, &self.scene, &self.inspection);
    }
}

/// Returns all shown triangles over vertices in the space of the scene, with a color for each.
fn posed(subject: &SceneSubject, shown: &ShownScene, colors: Colors) -> (IndexedMesh, Vec<[u8; 4]>) {
    let (mut positions, mut triangles, mut triangle_colors) =
        (Vec::new(), Vec::<[u32; 3]>::new(), Vec::new());
    let mut group_count = 0;
    for index in 0..shown.instance_count() {
        let Some((drawn, list)) = shown.instance(index) else { continue };
        let Some(posed) = shown.positions_of(subject, index) else { continue };
        let Ok(first) = u32::try_from(positions.len()) else { break };
        positions.extend(posed);
        for (primitive, range) in list.groups.iter().enumerate() {
            let material = subject.primitive_materials[drawn.mesh].get(primitive).copied().flatten();
            let corners = &list.indices[range.start as usize..range.end as usize];
            for triangle in corners.as_chunks::<3>().0 {
                triangle_colors.push(match colors {
                    Colors::Surface | Colors::StripsOrFans => subject.plain_color(material),
                    Colors::Triangles => palette_color(triangles.len() as u32),
                    Colors::Groups => palette_color(group_count),
                });
                triangles.push(triangle.map(|vertex| first + vertex));
            }
            group_count += 1;
        }
    }
    (IndexedMesh::new(positions, triangles), triangle_colors)
}
