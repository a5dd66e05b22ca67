//! Surfaces with materials at the pixels where they are seen: attributes, textures and normals.

use glam::{DVec3, Vec3};
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};
use striata_scene::drawn::{AlphaMode, Material, TextureUse};

use super::shading::{MIN_ROUGHNESS, SurfacePoint, shade};
use super::texture::{Footprint, Texture};
use crate::camera::to_f64;
use crate::material_images::{BASE_COLOR, EMISSIVE, METALLIC_ROUGHNESS, NORMAL, OCCLUSION, material_images};
use crate::scene_look::SceneLook;
use crate::shot::Shot;

/// Axes of the camera in world space, and the size of a pixel at distance 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PixelGrid {
    /// Right, up, and toward the eye.
    pub axes: [Vec3; 3],
    /// Pixel whose ray is the view direction.
    pub center: [f64; 2],
    /// Pixels per unit at distance 1.
    pub scale: f64,
    /// Side of the square that is shaded as one, pixels of the grid.
    pub step: f64,
}

impl PixelGrid {
    /// Returns the ray through a point of the picture, in camera space.
    fn ray(&self, [x, y]: [f64; 2]) -> DVec3 {
        DVec3::new((x - self.center[0]) / self.scale, (self.center[1] - y) / self.scale, -1.0)
    }

    fn to_world(self, v: Vec3) -> Vec3 {
        v.x * self.axes[0] + v.y * self.axes[1] + v.z * self.axes[2]
    }
}

/// The surface of a shot with the attributes of its vertices.
pub(crate) struct LitSurface<'a> {
    mesh: &'a IndexedMesh,
    look: &'a SceneLook,
    triangles: &'a [[u32; 3]],
    /// Material of each triangle; beyond the materials of the look, the default material.
    material_of: Vec<u32>,
    default: Material,
    /// Positions in camera space.
    positions: &'a [[f32; 3]],
    normals: Option<&'a AttributeLayer>,
    tangents: Option<&'a AttributeLayer>,
    colors: Option<Vec<[f32; 4]>>,
    uvs: Vec<Option<&'a AttributeLayer>>,
}

/// How a point of the picture lies in a triangle: shares of the corners there and one pixel away.
struct Weights {
    at: [f32; 3],
    right: [f32; 3],
    down: [f32; 3],
}

/// The ray through a pixel, and the base color of the point that it hits.
struct RayColor {
    /// Point that the ray begins at.
    pub eye: Vec3,
    /// Direction of the ray.
    pub ray: Vec3,
    /// Linear color.
    pub base_color: Vec3,
}

impl<'a> LitSurface<'a> {
    /// Prepares the surface of a shot, whose vertices have these positions in camera space.
    pub(crate) fn new(shot: &'a Shot<'_>, look: &'a SceneLook, positions: &'a [[f32; 3]]) -> Self {
        let mesh = shot.vertices;
        let layer =
            |semantic, least: u8| mesh.layer(&semantic).filter(|layer| layer.component_count >= least);
        let sets = look.materials.iter().flat_map(Material::textures).map(|texture| texture.uv_set);
        let set_count = sets.max().map_or(0, |last| u16::from(last) + 1);
        let uvs = (0..set_count).map(|set| layer(Semantic::TexCoord(set as u8), 2)).collect();
        Self {
            mesh,
            look,
            triangles: &shot.triangles,
            material_of: material_of_triangles(mesh, shot.triangles.len()),
            default: Material::default(),
            positions,
            normals: if shot.is_flat { None } else { layer(Semantic::Normal, 3) },
            tangents: layer(Semantic::Tangent, 4),
            colors: mesh.linear_colors(),
            uvs,
        }
    }

    /// Material of a triangle.
    pub(crate) fn material(&self, triangle: usize) -> &Material {
        self.look.materials.get(self.material_of[triangle] as usize).unwrap_or(&self.default)
    }

    /// Whether a triangle shows its front to the eye.
    pub(crate) fn is_front(&self, triangle: usize) -> bool {
        let [a, b, c] = self.corners(triangle);
        b.cross(c).dot(a) < 0.0
    }

    fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|v| to_f64(self.positions[v as usize]))
    }

    /// Returns opacity at a point of the picture, to be compared with the cutoff of a mask.
    pub(crate) fn alpha(&self, triangle: usize, grid: &PixelGrid, pixel: [f64; 2]) -> f32 {
        let weights = self.weights(triangle, grid, pixel);
        self.base_color(triangle, &weights)[3]
    }

    /// Returns the light and the opacity of a triangle at a point of the picture.
    pub(crate) fn shade(&self, triangle: usize, grid: &PixelGrid, eye: Vec3, pixel: [f64; 2]) -> [f32; 4] {
        let material = self.material(triangle);
        let weights = self.weights(triangle, grid, pixel);
        let [r, g, b, a] = self.base_color(triangle, &weights);
        let alpha = if material.alpha_mode == AlphaMode::Blend { a.clamp(0.0, 1.0) } else { 1.0 };
        let light = if material.is_unlit {
            Vec3::new(r, g, b)
        } else {
            let ray = grid.to_world(grid.ray(pixel).as_vec3());
            let point =
                self.point(triangle, &weights, grid, RayColor { eye, ray, base_color: Vec3::new(r, g, b) });
            shade(&point, &self.look.lights)
        };
        let [r, g, b] = light.to_array().map(|x| if x.is_finite() { x.clamp(0.0, 1.0) * alpha } else { 0.0 });
        [r, g, b, alpha]
    }

    /// Shares of the corners by the volumes between the ray and the sides of the triangle, which is exact
    /// in perspective, also for triangles that reach behind the eye.
    fn weights(&self, triangle: usize, grid: &PixelGrid, [x, y]: [f64; 2]) -> Weights {
        let [a, b, c] = self.corners(triangle);
        let sides = [b.cross(c), c.cross(a), a.cross(b)];
        let at = |pixel: [f64; 2]| {
            let ray = grid.ray(pixel);
            let volumes = sides.map(|side| side.dot(ray));
            let total = volumes[0] + volumes[1] + volumes[2];
            let shares = volumes.map(|volume| (volume / total) as f32);
            if shares.iter().all(|share| share.is_finite()) { shares } else { [1.0, 0.0, 0.0] }
        };
        Weights { at: at([x, y]), right: at([x + grid.step, y]), down: at([x, y + grid.step]) }
    }

    fn attribute<const N: usize>(
        &self,
        layer: &AttributeLayer,
        triangle: usize,
        weights: [f32; 3],
    ) -> [f32; N] {
        let corners = self.triangles[triangle];
        let width = usize::from(layer.component_count);
        std::array::from_fn(|k| {
            if k >= width {
                return 1.0;
            }
            (0..3).map(|i| weights[i] * layer.get(corners[i] as usize, k)).sum()
        })
    }

    /// Samples an image of a material.
    fn texel(&self, triangle: usize, weights: &Weights, slot: usize) -> Option<[f32; 4]> {
        let (texture, image) = self.image(triangle, slot)?;
        let (uv, footprint) = self.uv(triangle, weights, texture)?;
        Some(image.sample(&texture.sampler, uv, &footprint))
    }

    fn uv(&self, triangle: usize, weights: &Weights, texture: &TextureUse) -> Option<([f32; 2], Footprint)> {
        let layer = self.uvs.get(usize::from(texture.uv_set)).copied().flatten()?;
        let corners = self.triangles[triangle];
        let corners = corners.map(|v| texture.transform.apply([0, 1].map(|k| layer.get(v as usize, k))));
        let at = |weights: [f32; 3]| -> [f32; 2] {
            [0, 1]
                .map(|k| weights[0] * corners[0][k] + weights[1] * corners[1][k] + weights[2] * corners[2][k])
        };
        let [uv, right, down] = [at(weights.at), at(weights.right), at(weights.down)];
        Some((uv, [right, down].map(|next| [next[0] - uv[0], next[1] - uv[1]])))
    }

    fn image(&self, triangle: usize, slot: usize) -> Option<(&TextureUse, &Texture)> {
        let used = material_images(self.material(triangle))[slot]?;
        Some((used.0, self.look.texture(used)?))
    }

    fn base_color(&self, triangle: usize, weights: &Weights) -> [f32; 4] {
        let material = self.material(triangle);
        let mut color = material.base_color;
        if let Some(texel) = self.texel(triangle, weights, BASE_COLOR) {
            color = std::array::from_fn(|k| color[k] * texel[k]);
        }
        if let Some(colors) = &self.colors {
            let corners = self.triangles[triangle].map(|v| colors[v as usize]);
            let vertex = |k: usize| (0..3).map(|i| weights.at[i] * corners[i][k]).sum::<f32>();
            color = std::array::from_fn(|k| color[k] * vertex(k).max(0.0));
        }
        color
    }

    /// Everything that determines the light of a lit point.
    fn point(
        &self,
        triangle: usize,
        weights: &Weights,
        grid: &PixelGrid,
        RayColor { eye, ray, base_color }: RayColor,
    ) -> SurfacePoint {
        let material = self.material(triangle);
        let sample = |slot| self.texel(triangle, weights, slot);
        let [_, green, blue, _] = sample(METALLIC_ROUGHNESS).unwrap_or([1.0; 4]);
        let occlusion = sample(OCCLUSION).map_or(1.0, |texel| texel[0]);
        let [red, green_light, blue_light, _] = sample(EMISSIVE).unwrap_or([1.0; 4]);
        let to_eye = -ray.normalize_or_zero();
        let (smooth, spread) = self.normal(triangle, weights, grid);
        let normal = self.mapped_normal(triangle, weights, smooth);
        let corners = self.corners(triangle);
        let depth: f64 = -(0..3).map(|k| f64::from(weights.at[k]) * corners[k].z).sum::<f64>();
        SurfacePoint {
            position: eye + depth as f32 * ray,
            normal,
            to_eye,
            base_color,
            metallic: (material.metallic * blue).clamp(0.0, 1.0),
            roughness: ((material.roughness * green).max(MIN_ROUGHNESS) + spread).min(1.0),
            occlusion: 1.0 + material.occlusion_strength * (occlusion - 1.0),
            emissive: Vec3::from(material.emissive) * Vec3::new(red, green_light, blue_light),
        }
    }

    /// Returns the unit normal on the side of the eye, and by how much it changes within a pixel.
    fn normal(&self, triangle: usize, weights: &Weights, grid: &PixelGrid) -> (Vec3, f32) {
        let side = if self.is_front(triangle) { 1.0 } else { -1.0 };
        let smooth = self.normals.map(|layer| {
            [weights.at, weights.right, weights.down]
                .map(|weights| Vec3::from(self.attribute::<3>(layer, triangle, weights)).normalize_or_zero())
        });
        match smooth {
            Some([normal, right, down]) if normal != Vec3::ZERO => {
                let change = |next: Vec3| {
                    grid.axes.map(|axis| axis.dot(next - normal).abs()).into_iter().fold(0.0, f32::max)
                };
                let spread = if right == Vec3::ZERO || down == Vec3::ZERO {
                    0.0
                } else {
                    change(right).max(change(down))
                };
                (side * normal, spread)
            }
            _ => {
                let [a, b, c] = self.corners(triangle);
                let normal = (b - a).cross(c - a).normalize_or_zero().as_vec3();
                (side * grid.to_world(normal), 0.0)
            }
        }
    }

    /// Applies the normal map of a material to a normal.
    fn mapped_normal(&self, triangle: usize, weights: &Weights, normal: Vec3) -> Vec3 {
        let material = self.material(triangle);
        let Some((texture, image)) = self.image(triangle, NORMAL) else { return normal };
        let Some((uv, footprint)) = self.uv(triangle, weights, texture) else { return normal };
        let [x, y, z, _] = image.sample(&texture.sampler, uv, &footprint);
        let [x, y, z] = [x, y, z].map(|x| 2.0 * x - 1.0);
        let [x, y] = [x, y].map(|x| x * material.normal_scale);
        let side = if self.is_front(triangle) { 1.0 } else { -1.0 };
        let Some([tangent, bitangent]) = self.tangents(triangle, weights, texture, side * normal) else {
            return normal;
        };
        (side * (x * tangent + y * bitangent) + z * normal).normalize_or(normal)
    }

    /// Returns the directions of the x and y components of a normal map, for the normal of the front: those
    /// of the vertices, or else those in which the texture coordinates grow.
    fn tangents(
        &self,
        triangle: usize,
        weights: &Weights,
        texture: &TextureUse,
        normal: Vec3,
    ) -> Option<[Vec3; 2]> {
        if let Some(layer) = self.tangents {
            let [x, y, z, w]: [f32; 4] = self.attribute(layer, triangle, weights.at);
            let tangent = Vec3::new(x, y, z).normalize_or_zero();
            if tangent != Vec3::ZERO {
                let bitangent = normal.cross(tangent).normalize_or_zero();
                return Some([tangent, if w < 0.0 { -bitangent } else { bitangent }]);
            }
        }
        let layer = self.uvs.get(usize::from(texture.uv_set)).copied().flatten()?;
        let corners = self.triangles[triangle].map(|v| v as usize);
        let [a, b, c] = corners.map(|v| Vec3::from(self.mesh.positions[v]));
        let uv = corners.map(|v| texture.transform.apply([layer.get(v, 0), layer.get(v, 1)]));
        let [[u0, v0], [u1, v1]] = [1, 2].map(|k| [uv[k][0] - uv[0][0], uv[k][1] - uv[0][1]]);
        let (across, along) = ((c - a).cross(normal), normal.cross(b - a));
        let tangent = u0 * across + u1 * along;
        let bitangent = v0 * across + v1 * along;
        let longest = tangent.length().max(bitangent.length());
        if !(longest > 0.0 && longest.is_finite()) {
            return None;
        }
        // Texture coordinates grow downward, and the y of normal maps grows upward.
        Some([tangent / longest, -bitangent / longest])
    }
}

/// Material of each triangle; `u32::MAX` for those without one.
fn material_of_triangles(mesh: &IndexedMesh, triangle_count: usize) -> Vec<u32> {
    let mut materials = vec![u32::MAX; triangle_count];
    for group in mesh.groups_or_whole() {
        if let (Some(material), Some(triangles)) = (group.material, materials.get_mut(group.range())) {
            triangles.fill(material);
        }
    }
    materials
}
