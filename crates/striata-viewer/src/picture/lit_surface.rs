//! Surfaces with materials at the pixels where they are seen: attributes, textures and normals.

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};
use striata_scene::drawn::{AlphaMode, Light, Material, TextureUse};

use super::camera::{cross as cross64, dot as dot64};
use super::scene_look::SceneLook;
use super::shading::{MIN_ROUGHNESS, SurfacePoint, shade};
use super::shot::Shot;
use super::texture::{Footprint, Texture};
use super::vector::{Vec3, add, cross, dot, scaled, sub, unit};

/// Axes of the camera in world space, and the size of a pixel at distance 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct PixelGrid {
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
    fn ray(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        [(x - self.center[0]) / self.scale, (self.center[1] - y) / self.scale, -1.0]
    }

    fn to_world(self, v: Vec3) -> Vec3 {
        add(add(scaled(self.axes[0], v[0]), scaled(self.axes[1], v[1])), scaled(self.axes[2], v[2]))
    }
}

/// The surface of a shot with the attributes of its vertices.
pub(super) struct LitSurface<'a> {
    mesh: &'a IndexedMesh,
    look: &'a SceneLook,
    triangles: &'a [[u32; 3]],
    /// Material of each triangle; beyond the materials of the look, the default material.
    material_of: Vec<u32>,
    default: Material,
    /// Positions in camera space.
    positions: &'a [Vec3],
    normals: Option<&'a AttributeLayer>,
    tangents: Option<&'a AttributeLayer>,
    colors: Option<Vec<[f32; 4]>>,
    uvs: Vec<Option<&'a AttributeLayer>>,
}

/// How a point of the picture lies in a triangle: shares of the corners there and one pixel away.
struct Weights {
    at: Vec3,
    right: Vec3,
    down: Vec3,
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
    pub(super) fn new(shot: &'a Shot<'_>, look: &'a SceneLook, positions: &'a [Vec3]) -> Self {
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
    pub(super) fn material(&self, triangle: usize) -> &Material {
        self.look.materials.get(self.material_of[triangle] as usize).unwrap_or(&self.default)
    }

    /// Whether a triangle shows its front to the eye.
    pub(super) fn is_front(&self, triangle: usize) -> bool {
        let [a, b, c] = self.corners(triangle);
        dot64(cross64(b, c), a) < 0.0
    }

    fn corners(&self, triangle: usize) -> [[f64; 3]; 3] {
        self.triangles[triangle].map(|v| self.positions[v as usize].map(f64::from))
    }

    /// Returns opacity at a point of the picture, to be compared with the cutoff of a mask.
    pub(super) fn alpha(&self, triangle: usize, grid: &PixelGrid, pixel: [f64; 2]) -> f32 {
        let weights = self.weights(triangle, grid, pixel);
        self.base_color(triangle, &weights)[3]
    }

    /// Returns the light and the opacity of a triangle at a point of the picture.
    pub(super) fn shade(&self, triangle: usize, grid: &PixelGrid, eye: Vec3, pixel: [f64; 2]) -> [f32; 4] {
        let material = self.material(triangle);
        let weights = self.weights(triangle, grid, pixel);
        let [r, g, b, a] = self.base_color(triangle, &weights);
        let alpha = if material.alpha_mode == AlphaMode::Blend { a.clamp(0.0, 1.0) } else { 1.0 };
        let light = if material.is_unlit {
            [r, g, b]
        } else {
            let ray = grid.to_world(grid.ray(pixel).map(|x| x as f32));
            let point = self.point(triangle, &weights, grid, RayColor { eye, ray, base_color: [r, g, b] });
            shade(&point, self.lights())
        };
        let [r, g, b] = light.map(|x| if x.is_finite() { x.clamp(0.0, 1.0) * alpha } else { 0.0 });
        [r, g, b, alpha]
    }

    fn lights(&self) -> &[Light] {
        &self.look.lights
    }

    /// Shares of the corners by the volumes between the ray and the sides of the triangle, which is exact
    /// in perspective, also for triangles that reach behind the eye.
    fn weights(&self, triangle: usize, grid: &PixelGrid, [x, y]: [f64; 2]) -> Weights {
        let [a, b, c] = self.corners(triangle);
        let sides = [cross64(b, c), cross64(c, a), cross64(a, b)];
        let at = |pixel: [f64; 2]| {
            let ray = grid.ray(pixel);
            let volumes = sides.map(|side| dot64(side, ray));
            let total = volumes[0] + volumes[1] + volumes[2];
            let shares = volumes.map(|volume| (volume / total) as f32);
            if shares.iter().all(|share| share.is_finite()) { shares } else { [1.0, 0.0, 0.0] }
        };
        Weights { at: at([x, y]), right: at([x + grid.step, y]), down: at([x, y + grid.step]) }
    }

    fn attribute<const N: usize>(&self, layer: &AttributeLayer, triangle: usize, weights: Vec3) -> [f32; N] {
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
    fn texel(
        &self,
        triangle: usize,
        weights: &Weights,
        texture: Option<(&TextureUse, &Texture)>,
    ) -> Option<[f32; 4]> {
        let (texture, image) = texture?;
        let (uv, footprint) = self.uv(triangle, weights, texture)?;
        Some(image.sample(&texture.sampler, uv, &footprint))
    }

    fn uv(&self, triangle: usize, weights: &Weights, texture: &TextureUse) -> Option<([f32; 2], Footprint)> {
        let layer = self.uvs.get(usize::from(texture.uv_set)).copied().flatten()?;
        let corners = self.triangles[triangle];
        let corners = corners.map(|v| texture.transform.apply([0, 1].map(|k| layer.get(v as usize, k))));
        let at = |weights: Vec3| -> [f32; 2] {
            [0, 1]
                .map(|k| weights[0] * corners[0][k] + weights[1] * corners[1][k] + weights[2] * corners[2][k])
        };
        let [uv, right, down] = [at(weights.at), at(weights.right), at(weights.down)];
        Some((uv, [right, down].map(|next| [next[0] - uv[0], next[1] - uv[1]])))
    }

    fn image<'t>(
        &'t self,
        texture: &'t Option<TextureUse>,
        is_color: bool,
    ) -> Option<(&'t TextureUse, &'t Texture)> {
        let texture = texture.as_ref()?;
        Some((texture, self.look.texture(texture, is_color)?))
    }

    fn base_color(&self, triangle: usize, weights: &Weights) -> [f32; 4] {
        let material = self.material(triangle);
        let mut color = material.base_color;
        if let Some(texel) = self.texel(triangle, weights, self.image(&material.base_color_texture, true)) {
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
        let sample = |texture: &Option<TextureUse>, is_color| {
            self.texel(triangle, weights, self.image(texture, is_color))
        };
        let [_, green, blue, _] = sample(&material.metallic_roughness_texture, false).unwrap_or([1.0; 4]);
        let occlusion = sample(&material.occlusion_texture, false).map_or(1.0, |texel| texel[0]);
        let emissive = sample(&material.emissive_texture, true).unwrap_or([1.0; 4]);
        let to_eye = unit(scaled(ray, -1.0));
        let (smooth, spread) = self.normal(triangle, weights, grid);
        let normal = self.mapped_normal(triangle, weights, smooth);
        let corners = self.corners(triangle);
        let depth: f64 = -(0..3).map(|k| f64::from(weights.at[k]) * corners[k][2]).sum::<f64>();
        SurfacePoint {
            position: add(eye, scaled(ray, depth as f32)),
            normal,
            to_eye,
            base_color,
            metallic: (material.metallic * blue).clamp(0.0, 1.0),
            roughness: ((material.roughness * green).max(MIN_ROUGHNESS) + spread).min(1.0),
            occlusion: 1.0 + material.occlusion_strength * (occlusion - 1.0),
            emissive: std::array::from_fn(|k| material.emissive[k] * emissive[k]),
        }
    }

    /// Returns the unit normal on the side of the eye, and by how much it changes within a pixel.
    fn normal(&self, triangle: usize, weights: &Weights, grid: &PixelGrid) -> (Vec3, f32) {
        let side = if self.is_front(triangle) { 1.0 } else { -1.0 };
        let smooth = self.normals.map(|layer| {
            [weights.at, weights.right, weights.down]
                .map(|weights| unit(self.attribute(layer, triangle, weights)))
        });
        match smooth {
            Some([normal, right, down]) if normal != [0.0; 3] => {
                let change = |next: Vec3| {
                    let difference = sub(next, normal);
                    grid.axes.map(|axis| dot(axis, difference).abs()).into_iter().fold(0.0, f32::max)
                };
                let spread =
                    if right == [0.0; 3] || down == [0.0; 3] { 0.0 } else { change(right).max(change(down)) };
                (scaled(normal, side), spread)
            }
            _ => {
                let [a, b, c] = self.corners(triangle);
                let edge = |p: [f64; 3]| [0, 1, 2].map(|k| (p[k] - a[k]) as f32);
                let normal = unit(cross(edge(b), edge(c)));
                (scaled(grid.to_world(normal), side), 0.0)
            }
        }
    }

    /// Applies the normal map of a material to a normal.
    fn mapped_normal(&self, triangle: usize, weights: &Weights, normal: Vec3) -> Vec3 {
        let material = self.material(triangle);
        let Some((texture, image)) = self.image(&material.normal_texture, false) else { return normal };
        let Some((uv, footprint)) = self.uv(triangle, weights, texture) else { return normal };
        let [x, y, z, _] = image.sample(&texture.sampler, uv, &footprint);
        let [x, y, z] = [x, y, z].map(|x| 2.0 * x - 1.0);
        let [x, y] = [x, y].map(|x| x * material.normal_scale);
        let side = if self.is_front(triangle) { 1.0 } else { -1.0 };
        let Some([tangent, bitangent]) = self.tangents(triangle, weights, texture, scaled(normal, side))
        else {
            return normal;
        };
        let bent = add(add(scaled(tangent, side * x), scaled(bitangent, side * y)), scaled(normal, z));
        let bent = unit(bent);
        if bent == [0.0; 3] { normal } else { bent }
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
            let tangent = unit([x, y, z]);
            if tangent != [0.0; 3] {
                return Some([
                    tangent,
                    scaled(unit(cross(normal, tangent)), if w < 0.0 { -1.0 } else { 1.0 }),
                ]);
            }
        }
        let layer = self.uvs.get(usize::from(texture.uv_set)).copied().flatten()?;
        let corners = self.triangles[triangle].map(|v| v as usize);
        let [a, b, c] = corners.map(|v| self.mesh.positions[v]);
        let uv = corners.map(|v| texture.transform.apply([layer.get(v, 0), layer.get(v, 1)]));
        let [[u0, v0], [u1, v1]] = [1, 2].map(|k| [uv[k][0] - uv[0][0], uv[k][1] - uv[0][1]]);
        let (across, along) = (cross(sub(c, a), normal), cross(normal, sub(b, a)));
        let tangent = add(scaled(across, u0), scaled(along, u1));
        let bitangent = add(scaled(across, v0), scaled(along, v1));
        let longest = dot(tangent, tangent).max(dot(bitangent, bitangent)).sqrt();
        if !(longest > 0.0 && longest.is_finite()) {
            return None;
        }
        // Texture coordinates grow downward, and the y of normal maps grows upward.
        Some([scaled(tangent, 1.0 / longest), scaled(bitangent, -1.0 / longest)])
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
