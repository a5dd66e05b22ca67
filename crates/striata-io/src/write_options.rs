//! Options of the writers.

/// Options of [`write()`](crate::write()) and [`to_bytes`](crate::to_bytes).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct WriteOptions {
    /// Whether to write PLY as text instead of binary little-endian. Default: false.
    pub ascii: bool,
    /// glTF only: triangle strips to write instead of the triangles, one index list for each triangle
    /// group. Each list is a single strip (joined by degenerate triangles, without restart indices). A
    /// group with an empty list is written as single triangles. Default: [`None`], so all groups are.
    pub strips: Option<Vec<Vec<u32>>>,
    /// glTF only: fans to write instead of the triangles, for each triangle group a list of index lists.
    /// glTF has no restart index, so each fan becomes a primitive, which takes some 140 bytes of JSON.
    /// Default: [`None`].
    pub fans: Option<Vec<Vec<Vec<u32>>>>,
    /// glTF only: how to round attributes to small integers (`KHR_mesh_quantization`). Default: [`None`],
    /// so all values are kept exactly.
    pub quantize: Option<QuantizeOptions>,
    /// glTF only: whether to compress geometry with meshoptimizer (`EXT_meshopt_compression`). This alone is
    /// lossless and saves little; set [`quantize`](Self::quantize) too, as gltfpack does. Default: false.
    pub meshopt: bool,
    /// glTF only: whether to compress triangles with Draco (`KHR_draco_mesh_compression`); excludes
    /// [`meshopt`](Self::meshopt). Draco quantizes to the bits of [`quantize`](Self::quantize) by itself, and
    /// keeps floats exactly without it. Default: false.
    pub draco: bool,
    /// glTF only: whether a mesh without normals gets smooth ones, up to creases of 50 degrees, and a mesh without
    /// materials a matte one; viewers show flat facets of a white metal otherwise. Vertices at creases are
    /// divided. Has no effect with strips or fans. Default: false.
    pub shading: bool,
    /// `.gltf` only: whether buffer and images are embedded as text, which takes a third more bytes, instead of
    /// being files next to it. Bytes without a path always embed them. Default: false.
    pub embed: bool,
    /// Whether triangles are written in an order that needs few vertex cache misses, and vertices in the order of
    /// their first use. Primitives with a blended material keep the order in which they are drawn. Has no effect
    /// with strips or fans, nor with [`meshopt`](Self::meshopt) or [`draco`](Self::draco), which choose an order of
    /// their own. Default: false.
    pub cache_order: bool,
    /// glTF only: whether the z axis of the mesh is up, as that of a mesh with a georeference always is. A matrix of its
    /// nodes then turns it to the y axis, which is up in glTF. Default: false.
    pub z_up: bool,
}

impl WriteOptions {
    /// Sets [`ascii`](Self::ascii).
    #[must_use]
    pub fn with_ascii(self, ascii: bool) -> Self {
        Self { ascii, ..self }
    }

    /// Sets [`strips`](Self::strips).
    #[must_use]
    pub fn with_strips(self, strips: Vec<Vec<u32>>) -> Self {
        Self { strips: Some(strips), ..self }
    }

    /// Sets [`fans`](Self::fans), and clears the strips.
    #[must_use]
    pub fn with_fans(self, fans: Vec<Vec<Vec<u32>>>) -> Self {
        Self { strips: None, fans: Some(fans), ..self }
    }

    /// Sets [`quantize`](Self::quantize).
    #[must_use]
    pub fn with_quantize(self, quantize: QuantizeOptions) -> Self {
        Self { quantize: Some(quantize), ..self }
    }

    /// Sets [`meshopt`](Self::meshopt).
    #[must_use]
    pub fn with_meshopt(self, meshopt: bool) -> Self {
        Self { meshopt, ..self }
    }

    /// Sets [`shading`](Self::shading).
    #[must_use]
    pub fn with_shading(self, shading: bool) -> Self {
        Self { shading, ..self }
    }

    /// Sets [`embed`](Self::embed).
    #[must_use]
    pub fn with_embed(self, embed: bool) -> Self {
        Self { embed, ..self }
    }

    /// Sets [`draco`](Self::draco).
    #[must_use]
    pub fn with_draco(self, draco: bool) -> Self {
        Self { draco, ..self }
    }

    /// Sets [`cache_order`](Self::cache_order).
    #[must_use]
    pub fn with_cache_order(self, cache_order: bool) -> Self {
        Self { cache_order, ..self }
    }

    /// Sets [`z_up`](Self::z_up).
    #[must_use]
    pub fn with_z_up(self, z_up: bool) -> Self {
        Self { z_up, ..self }
    }

    /// Whether triangles and vertices get their order for caches before they are encoded.
    pub(crate) fn has_cache_order(&self) -> bool {
        self.cache_order && !self.meshopt && !self.draco && self.strips.is_none() && self.fans.is_none()
    }
}

/// Precision of quantized glTF. Values outside the given ranges are clamped.
///
/// Normals, tangents, colors, weights and joints become integers of 8 bits, or of 16 bits if they need
/// more. Texture coordinates that leave the range 0 to 1, or that
/// [`meshopt`](WriteOptions::meshopt) compresses, remain floats of the given precision. Animated rotations become
/// integers of 16 bits; with meshopt, times are rounded to 1/4096 s, and animated moves and scales to 16 bits of the
/// largest.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct QuantizeOptions {
    /// Bits per coordinate along the longest side of a mesh's bounding box, 1 to 16. Default: 14.
    pub position_bits: u32,
    /// Bits per coordinate of a normal or tangent, 2 to 16. Default: 8.
    pub normal_bits: u32,
    /// Bits per texture coordinate, from 0 to 1; 1 to 16. Default: 12.
    pub texcoord_bits: u32,
    /// Bits per color channel, 1 to 16. Default: 8.
    pub color_bits: u32,
    /// Bits per component of an animated rotation, 9 to 16. Default: 12.
    pub rotation_bits: u32,
    /// Which meshes have a common grid. Default: those that touch.
    pub grid: GridScope,
    /// Base-2 logarithm of the distance of grid positions, which are multiples of it: files with the same one have a
    /// common grid. A mesh that takes more than 65,535 steps keeps its floats. Default: [`None`], so
    /// [`position_bits`](Self::position_bits) count.
    pub step_log2: Option<i32>,
}

/// Which meshes of a scene are rounded to a common grid, so that points they have in common stay so. Only meshes
/// whose transforms differ by nothing but a move can have one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum GridScope {
    /// Meshes with common vertices, with the step of the finest of them; one that is too large for it keeps its
    /// own.
    #[default]
    Touching,
    /// All, with the step of the finest, or of the largest if that needs more than 16 bits.
    Scene,
    /// None: each has the grid that fits it best.
    Mesh,
}

impl Default for QuantizeOptions {
    fn default() -> Self {
        Self {
            position_bits: 14,
            normal_bits: 8,
            texcoord_bits: 12,
            color_bits: 8,
            rotation_bits: 12,
            grid: GridScope::Touching,
            step_log2: None,
        }
    }
}

impl QuantizeOptions {
    /// Sets [`position_bits`](Self::position_bits).
    #[must_use]
    pub fn with_position_bits(self, position_bits: u32) -> Self {
        Self { position_bits, ..self }
    }

    /// Sets [`normal_bits`](Self::normal_bits).
    #[must_use]
    pub fn with_normal_bits(self, normal_bits: u32) -> Self {
        Self { normal_bits, ..self }
    }

    /// Sets [`texcoord_bits`](Self::texcoord_bits).
    #[must_use]
    pub fn with_texcoord_bits(self, texcoord_bits: u32) -> Self {
        Self { texcoord_bits, ..self }
    }

    /// Sets [`color_bits`](Self::color_bits).
    #[must_use]
    pub fn with_color_bits(self, color_bits: u32) -> Self {
        Self { color_bits, ..self }
    }

    /// Sets [`rotation_bits`](Self::rotation_bits).
    #[must_use]
    pub fn with_rotation_bits(self, rotation_bits: u32) -> Self {
        Self { rotation_bits, ..self }
    }

    /// Sets [`grid`](Self::grid).
    #[must_use]
    pub fn with_grid(self, grid: GridScope) -> Self {
        Self { grid, ..self }
    }

    /// Sets [`step_log2`](Self::step_log2).
    #[must_use]
    pub fn with_step_log2(self, step_log2: Option<i32>) -> Self {
        Self { step_log2, ..self }
    }
}
