//! Vectors of three floats.

pub(super) type Vec3 = [f32; 3];

pub(super) fn dot(a: Vec3, b: Vec3) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn scaled(a: Vec3, factor: f32) -> Vec3 {
    a.map(|x| x * factor)
}

/// Interpolates from `a` to `b`.
pub(super) fn mix(a: Vec3, b: Vec3, share: f32) -> Vec3 {
    [0, 1, 2].map(|k| a[k] + share * (b[k] - a[k]))
}

/// Multiplies components.
pub(super) fn product(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// Normalizes a vector; a zero vector stays zero.
pub(super) fn unit(v: Vec3) -> Vec3 {
    let length = dot(v, v).sqrt();
    if length > 0.0 && length.is_finite() { v.map(|x| x / length) } else { [0.0; 3] }
}
