//! Materials at the samples where they are seen: attributes, textures and normals.

use glam::{DVec3, Vec3};
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};
use striata_scene::drawn::{AlphaMode, Material, TextureUse};

use super::shading::{MIN_ROUGHNESS, SurfacePoint, shade};
use super::surface::{Surface, flat_normal, shares, sides};
use super::texture::{Footprint, Texture};
use super::view::{DOWNSAMPLING, View};
use crate::Rgba;
use crate::material_images::{BASE_COLOR, EMISSIVE, METALLIC_ROUGHNESS, NORMAL, OCCLUSION, material_images};
use crate::scene_look::SceneLook;
use crate::shot::Shot;

/// The materials of a shot, and what they need of its vertices.
pub(crate) struct Materials<'a> {
    look: &'a SceneLook,
    /// Material of each triangle; beyond the materials of the look, the default material.
    of_triangles: Vec<u32>,
    default: Material,
    tangents: Option<&'a AttributeLayer>,
    colors: Option<Vec<[f32; 4]>>,
    uvs: Vec<Option<&'a AttributeLayer>>,
}

/// A point of a triangle with a material.
pub(crate) struct MaterialPoint<'a> {
    materials: &'a Materials<'a>,
    surface: &'a Surface<'a>,
    view: &'a View,
    material: &'a Material,
    triangle: usize,
    corners: [DVec3; 3],
    /// From the eye, in camera space.
    ray: DVec3,
    /// Shares of the corners at the point, one pixel to the right and one pixel down.
    shares: [[f32; 3]; 3],
}

impl<'a> Materials<'a> {
    pub(crate) fn new(shot: &'a Shot<'_>, look: &'a SceneLook) -> Self {
        let mesh = shot.vertices;
        let layer =
            |semantic, least: u8| mesh.layer(&semantic).filter(|layer| layer.component_count >= least);
        let sets = look.materials.iter().flat_map(Material::textures).map(|texture| texture.uv_set);
        let set_count = sets.max().map_or(0, |last| u16::from(last) + 1);
        Self {
            look,
            of_triangles: material_of_triangles(mesh, shot.triangles.len()),
            default: Material::default(),
            tangents: layer(Semantic::Tangent, 4),
            colors: mesh.linear_colors(),
            uvs: (0..set_count).map(|set| layer(Semantic::TexCoord(set as u8), 2)).collect(),
        }
    }

    /// Material of a triangle.
    pub(crate) fn of(&self, triangle: usize) -> &Material {
        self.look.materials.get(self.of_triangles[triangle] as usize).unwrap_or(&self.default)
    }

    /// The point of a triangle at a sample.
    pub(crate) fn point(
        &'a self,
        surface: &'a Surface<'a>,
        view: &'a View,
        triangle: usize,
        [x, y]: [f64; 2],
    ) -> MaterialPoint<'a> {
        let corners = surface.corners(triangle);
        let (sides, step) = (sides(corners), DOWNSAMPLING as f64);
        let shares = [[x, y], [x + step, y], [x, y + step]].map(|at| shares(&sides, view.ray(at)));
        let (material, ray) = (self.of(triangle), view.ray([x, y]));
        MaterialPoint { materials: self, surface, view, material, triangle, corners, ray, shares }
    }
}

impl MaterialPoint<'_> {
    /// Returns the light and the opacity.
    pub(crate) fn shade(&self) -> Rgba {
        let [r, g, b, a] = self.base_color();
        let alpha = if self.material.alpha_mode == AlphaMode::Blend { a.clamp(0.0, 1.0) } else { 1.0 };
        let color = Vec3::new(r, g, b);
        let is_unlit = self.material.is_unlit;
        let light = if is_unlit { color } else { shade(&self.lit_point(color), &self.materials.look.lights) };
        let [r, g, b] = light.to_array().map(|x| if x.is_finite() { x.clamp(0.0, 1.0) * alpha } else { 0.0 });
        [r, g, b, alpha]
    }

    pub(crate) fn base_color(&self) -> [f32; 4] {
        let mut color = self.material.base_color;
        if let Some(texel) = self.texel(BASE_COLOR) {
            color = std::array::from_fn(|k| color[k] * texel[k]);
        }
        if let Some(colors) = &self.materials.colors {
            let corners = self.surface.triangles[self.triangle].map(|v| colors[v as usize]);
            let vertex = |k: usize| (0..3).map(|i| self.shares[0][i] * corners[i][k]).sum::<f32>();
            color = std::array::from_fn(|k| color[k] * vertex(k).max(0.0));
        }
        color
    }

    /// Samples an image of the material.
    fn texel(&self, slot: usize) -> Option<[f32; 4]> {
        let (texture, image) = self.image(slot)?;
        let (uv, footprint) = self.uv(texture)?;
        Some(image.sample(&texture.sampler, uv, &footprint))
    }

    fn image(&self, slot: usize) -> Option<(&TextureUse, &Texture)> {
        let used = material_images(self.material)[slot]?;
        Some((used.0, self.materials.look.texture(used)?))
    }

    fn uv(&self, texture: &TextureUse) -> Option<([f32; 2], Footprint)> {
        let layer = self.materials.uvs.get(usize::from(texture.uv_set)).copied().flatten()?;
        let [uv, right, down] = self
            .shares
            .map(|shares| texture.transform.apply(self.surface.attribute(layer, self.triangle, shares)));
        Some((uv, [right, down].map(|next| [next[0] - uv[0], next[1] - uv[1]])))
    }

    /// Everything that determines the light of a lit point.
    fn lit_point(&self, base_color: Vec3) -> SurfacePoint {
        let material = self.material;
        let [_, green, blue, _] = self.texel(METALLIC_ROUGHNESS).unwrap_or([1.0; 4]);
        let occlusion = self.texel(OCCLUSION).map_or(1.0, |texel| texel[0]);
        let [red, green_light, blue_light, _] = self.texel(EMISSIVE).unwrap_or([1.0; 4]);
        let ray = self.view.to_world(self.ray.as_vec3());
        let (smooth, spread) = self.normal();
        let depth: f64 = -(0..3).map(|k| f64::from(self.shares[0][k]) * self.corners[k].z).sum::<f64>();
        SurfacePoint {
            position: self.view.eye.as_vec3() + depth as f32 * ray,
            normal: self.mapped_normal(smooth),
            to_eye: -ray.normalize_or_zero(),
            base_color,
            metallic: (material.metallic * blue).clamp(0.0, 1.0),
            roughness: ((material.roughness * green).max(MIN_ROUGHNESS) + spread).min(1.0),
            occlusion: 1.0 + material.occlusion_strength * (occlusion - 1.0),
            emissive: Vec3::from(material.emissive) * Vec3::new(red, green_light, blue_light),
        }
    }

    /// 1 on the front of the triangle, -1 on its back.
    fn side(&self) -> f32 {
        if self.surface.is_front(self.triangle) { 1.0 } else { -1.0 }
    }

    /// Returns the unit normal on the side of the eye, and by how much it changes within a pixel.
    fn normal(&self) -> (Vec3, f32) {
        let [at, right, down] = self.shares.map(|shares| self.surface.smooth_normal(self.triangle, shares));
        let Some(normal) = at else {
            return (self.side() * self.view.to_world(flat_normal(self.corners).as_vec3()), 0.0);
        };
        let change = |next: Vec3| self.view.turned((next - normal).as_dvec3()).abs().max_element();
        let spread = right.zip(down).map_or(0.0, |(right, down)| change(right).max(change(down)));
        (self.side() * normal, spread)
    }

    /// Applies the normal map of the material to a normal.
    fn mapped_normal(&self, normal: Vec3) -> Vec3 {
        let Some((texture, image)) = self.image(NORMAL) else { return normal };
        let Some((uv, footprint)) = self.uv(texture) else { return normal };
        let [x, y, z, _] = image.sample(&texture.sampler, uv, &footprint);
        let [x, y, z] = [x, y, z].map(|x| 2.0 * x - 1.0);
        let [x, y] = [x, y].map(|x| x * self.material.normal_scale);
        let side = self.side();
        let Some([tangent, bitangent]) = self.tangents(texture, side * normal) else { return normal };
        (side * (x * tangent + y * bitangent) + z * normal).normalize_or(normal)
    }

    /// Returns the directions of the x and y components of a normal map, for the normal of the front: those
    /// of the vertices, or else those in which the texture coordinates grow.
    fn tangents(&self, texture: &TextureUse, normal: Vec3) -> Option<[Vec3; 2]> {
        let (surface, materials) = (self.surface, self.materials);
        if let Some(layer) = materials.tangents {
            let [x, y, z, w]: [f32; 4] = surface.attribute(layer, self.triangle, self.shares[0]);
            let tangent = Vec3::new(x, y, z).normalize_or_zero();
            if tangent != Vec3::ZERO {
                let bitangent = normal.cross(tangent).normalize_or_zero();
                return Some([tangent, if w < 0.0 { -bitangent } else { bitangent }]);
            }
        }
        let layer = materials.uvs.get(usize::from(texture.uv_set)).copied().flatten()?;
        let corners = surface.triangles[self.triangle].map(|v| v as usize);
        let [a, b, c] = corners.map(|v| Vec3::from(surface.mesh.positions[v]));
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
