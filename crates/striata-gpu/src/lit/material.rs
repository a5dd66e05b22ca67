//! Materials as plain data: factors, textures and how opaque a surface is, as in glTF.

use crate::lit::texture_use::TextureUse;

/// How the opacity of a material is used.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum AlphaMode {
    /// The surface is opaque, whatever its opacity.
    #[default]
    Opaque,
    /// The surface is opaque or not there at all.
    Mask {
        /// Smallest opacity that is drawn, 0 to 1.
        cutoff: f32,
    },
    /// The surface is blended over what is behind it.
    Blend,
}

/// A metallic-roughness material. Colors are linear light; factors multiply their textures.
///
/// The default is glTF's: a white, rough metal.
#[derive(Clone, Debug, PartialEq)]
pub struct LitMaterial {
    /// Name, for error messages.
    pub name: String,
    /// Base color and opacity.
    pub base_color: [f32; 4],
    /// Base color (sRGB) and opacity.
    pub base_color_texture: Option<TextureUse>,
    /// 0 for dielectrics, 1 for metals.
    pub metallic: f32,
    /// Perceptual roughness, 0 to 1.
    pub roughness: f32,
    /// Roughness in green, metallic in blue.
    pub metallic_roughness_texture: Option<TextureUse>,
    /// Normals in the frame of the texture coordinates.
    pub normal_texture: Option<TextureUse>,
    /// Factor of the sideways components of the normal map.
    pub normal_scale: f32,
    /// Visible part of the surroundings in red.
    pub occlusion_texture: Option<TextureUse>,
    /// Effect of the occlusion texture: 0 for none, 1 for its full effect.
    pub occlusion_strength: f32,
    /// Light that the surface emits, including the emissive strength.
    pub emissive: [f32; 3],
    /// Emitted color (sRGB).
    pub emissive_texture: Option<TextureUse>,
    /// How opacity is used.
    pub alpha_mode: AlphaMode,
    /// Whether back faces are drawn, with their normals turned toward the viewer.
    pub is_double_sided: bool,
    /// Whether to show the base color without any lighting.
    pub is_unlit: bool,
}

impl Default for LitMaterial {
    fn default() -> Self {
        Self {
            name: String::new(),
            base_color: [1.0; 4],
            base_color_texture: None,
            metallic: 1.0,
            roughness: 1.0,
            metallic_roughness_texture: None,
            normal_texture: None,
            normal_scale: 1.0,
            occlusion_texture: None,
            occlusion_strength: 1.0,
            emissive: [0.0; 3],
            emissive_texture: None,
            alpha_mode: AlphaMode::Opaque,
            is_double_sided: false,
            is_unlit: false,
        }
    }
}

impl LitMaterial {
    /// The textures in the order in which the shader binds them: base color, metallic-roughness, normal,
    /// occlusion, emissive.
    pub(crate) fn textures(&self) -> [Option<&TextureUse>; 5] {
        [
            self.base_color_texture.as_ref(),
            self.metallic_roughness_texture.as_ref(),
            self.normal_texture.as_ref(),
            self.occlusion_texture.as_ref(),
            self.emissive_texture.as_ref(),
        ]
    }
}
