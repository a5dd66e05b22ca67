//! Transforms of nodes, applied to points and to values of layers.

use glam::{DMat3, DMat4, DVec3};
use striata::mesh::Semantic;

/// Transform, prepared for points and for directions.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Transform {
    matrix: DMat4,
    linear: DMat3,
    /// Cofactor matrix for normals, scaled so that a uniform scale keeps their length.
    cofactor: DMat3,
    /// Average scale factor of lengths.
    scale: f64,
    pub is_mirrored: bool,
}

impl Default for Transform {
    fn default() -> Self {
        let (matrix, linear) = (DMat4::IDENTITY, DMat3::IDENTITY);
        Self { matrix, linear, cofactor: linear, scale: 1.0, is_mirrored: false }
    }
}

impl Transform {
    /// Returns [`None`] for the identity.
    pub(crate) fn new(matrix: DMat4) -> Option<Self> {
        if matrix == DMat4::IDENTITY {
            return None;
        }
        let linear = DMat3::from_mat4(matrix);
        let (x, y, z) = (linear.x_axis, linear.y_axis, linear.z_axis);
        let determinant = linear.determinant();
        let is_mirrored = determinant < 0.0;
        let sign = if is_mirrored { -1.0 } else { 1.0 };
        let scale = cube_root(determinant.abs());
        let size = if scale > 0.0 { sign / (scale * scale) } else { sign };
        let cofactor = DMat3::from_cols(y.cross(z) * size, z.cross(x) * size, x.cross(y) * size);
        Some(Self { matrix, linear, cofactor, scale, is_mirrored })
    }

    /// Returns bits that identify the transform.
    pub(super) fn key(&self) -> [u64; 16] {
        self.matrix.to_cols_array().map(f64::to_bits)
    }

    pub(crate) fn point(&self, point: [f32; 3]) -> [f32; 3] {
        self.matrix.transform_point3(wide(point)).as_vec3().to_array()
    }

    /// Transforms a point in double precision.
    pub(crate) fn exact_point(&self, point: [f32; 3]) -> [f64; 3] {
        self.matrix.transform_point3(wide(point)).to_array()
    }

    /// Returns the transform followed by a move of `origin` to zero; [`None`] if that is the identity.
    pub(crate) fn relative_to(&self, origin: [f64; 3]) -> Option<Self> {
        Self::new(DMat4::from_translation(-DVec3::from_array(origin)) * self.matrix)
    }

    /// Transforms a displacement of a point.
    pub(super) fn displacement(&self, vector: [f32; 3]) -> [f32; 3] {
        (self.linear * wide(vector)).as_vec3().to_array()
    }

    /// Transforms a unit normal, or a displacement of one.
    pub(super) fn normal(&self, vector: [f32; 3], is_displacement: bool) -> [f32; 3] {
        direction(self.cofactor * wide(vector), is_displacement)
    }

    /// Transforms a unit tangent, or a displacement of one.
    pub(super) fn tangent(&self, vector: [f32; 3], is_displacement: bool) -> [f32; 3] {
        let moved = self.linear * wide(vector);
        direction(if self.scale > 0.0 { moved / self.scale } else { moved }, is_displacement)
    }
}

/// Cube root by Newton's method: `f64::cbrt` may differ between platforms.
fn cube_root(x: f64) -> f64 {
    if !(x > 0.0 && x.is_finite()) {
        return 0.0;
    }
    let mut root = f64::from_bits(x.to_bits() / 3 + 0x2A9F_0000_0000_0000);
    for _ in 0..8 {
        root = (2.0 * root + x / (root * root)) / 3.0;
    }
    root
}

fn wide(vector: [f32; 3]) -> DVec3 {
    DVec3::from_array(vector.map(f64::from))
}

fn direction(vector: DVec3, is_displacement: bool) -> [f32; 3] {
    let unit = if is_displacement { None } else { crate::normals::unit(vector.to_array()) };
    unit.unwrap_or_else(|| vector.as_vec3().to_array())
}

/// Transforms the numbers of some vertices of a layer like their instance.
pub(crate) fn transform_values(semantic: &Semantic, numbers: &mut [f32], transform: &Transform) {
    match semantic {
        Semantic::Normal | Semantic::MorphNormal(_) => {
            let is_displacement = *semantic != Semantic::Normal;
            for n in numbers.as_chunks_mut::<3>().0 {
                *n = transform.normal(*n, is_displacement);
            }
        }
        Semantic::MorphPosition(_) => {
            for d in numbers.as_chunks_mut::<3>().0 {
                *d = transform.displacement(*d);
            }
        }
        Semantic::MorphTangent(_) => {
            for d in numbers.as_chunks_mut::<3>().0 {
                *d = transform.tangent(*d, true);
            }
        }
        Semantic::Tangent => {
            let handedness = if transform.is_mirrored { -1.0 } else { 1.0 };
            for [x, y, z, w] in numbers.as_chunks_mut::<4>().0 {
                [*x, *y, *z] = transform.tangent([*x, *y, *z], false);
                *w *= handedness;
            }
        }
        _ => {}
    }
}
