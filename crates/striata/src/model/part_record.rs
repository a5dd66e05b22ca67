//! Packs the bounds of a step into eight bytes, nested along a tree of steps.
//!
//! A record is a sphere around a known center, a normal cone and an error. Every number is rounded to the
//! safe side: radius and error are the upper 16 bits of an unsigned float, the axis takes three bytes and
//! the sine one. The bounds of a parent enclose the rounded bounds of its children, so rounding never
//! makes a child weigh more than its parent.

use glam::{DVec3, Vec3};

use super::ModelError;
use crate::view::{NormalCone, Part, Sphere};
use crate::{Cancelled, Progress, ProgressFn};

/// Number of steps between two calls of the progress callback.
const STEPS_PER_REPORT: usize = 1 << 12;

/// Marks a step that has no parent.
pub(in crate::model) const NO_STEP: u32 = u32::MAX;

/// Steps whose changes are to be bounded, and the tree along which the bounds are nested.
pub(in crate::model) trait Bounded {
    /// Returns the parent of each step in the tree, which is coarser; [`NO_STEP`] for a child of the base.
    fn parents(&self) -> Vec<u32>;
    /// Returns the center of a step's sphere.
    fn center(&self, step: u32) -> [f32; 3];
    /// Appends the triangles that a step adds or removes.
    fn changed_into(&mut self, step: u32, out: &mut Vec<[[f32; 3]; 3]>);
    /// Returns the error that remains while a step is collapsed, in mesh units.
    fn error(&self, step: u32) -> f32;
}

/// Computes the records of all steps; each bounds what its step changes and the records of all its
/// descendants.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
pub(in crate::model) fn bound(
    steps: &mut impl Bounded,
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<PartRecord>, Cancelled> {
    let parents = steps.parents();
    let mut records = vec![PartRecord::default(); parents.len()];
    let mut normals = vec![DVec3::ZERO; parents.len()];
    let (mut first_child, mut next_child) = (vec![NO_STEP; parents.len()], vec![NO_STEP; parents.len()]);
    let mut changed = Vec::new();
    // Descendants are finer, so their bounds are known by then; and children are linked in ascending order.
    for step in (0..parents.len()).rev() {
        if step % STEPS_PER_REPORT == 0 {
            let (done, total) = ((parents.len() - step) as u64, parents.len() as u64);
            Progress { phase: "bounds", done, total }.report(progress)?;
        }
        let children =
            || std::iter::successors(some_step(first_child[step]), |&c| some_step(next_child[c as usize]));
        changed.clear();
        steps.changed_into(step as u32, &mut changed);
        let mut sphere = Sphere::point(steps.center(step as u32));
        for &corner in changed.iter().flatten() {
            sphere = sphere.with_point(corner);
        }
        let own = NormalCone::of_triangles(changed.iter().copied());
        let normal = direction(own.axis) + children().map(|child| normals[child as usize]).sum::<DVec3>();
        let mut cone = NormalCone::around(normal.to_array()).with_cone(&own);
        let mut error = steps.error(step as u32);
        for child in children() {
            let below = records[child as usize].part(steps.center(child));
            sphere = sphere.with_sphere(&below.sphere);
            cone = cone.with_cone(&below.cone);
            error = error.max(below.error);
        }
        normals[step] = normal;
        records[step] = PartRecord::holding(sphere.radius, &cone, error);
        if let Some(parent) = some_step(parents[step]) {
            next_child[step] = std::mem::replace(&mut first_child[parent as usize], step as u32);
        }
    }
    Ok(records)
}

fn some_step(step: u32) -> Option<u32> {
    (step != NO_STEP).then_some(step)
}

/// The bounds of a part in eight bytes, without the center of its sphere, which is stored anyway.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct PartRecord {
    radius: u16,
    error: u16,
    /// Axis of the cone; 127 stands for 1.
    axis: [i8; 3],
    /// Sine of the cone's half-angle; 255 stands for 1.
    sin: u8,
}

impl PartRecord {
    /// Packs bounds, rounded up so that the record encloses them.
    pub fn holding(radius: f32, cone: &NormalCone, error: f32) -> Self {
        let mut record =
            Self { radius: round_up(radius), error: round_up(error), axis: [0; 3], sin: u8::MAX };
        if cone.cos > 0.0 {
            // Rounded toward zero, so that the axis is never longer than 1.
            record.axis = cone.axis.map(|x| (x * 127.0) as i8);
            let around = NormalCone::around(direction(record.axis.map(f32::from)).to_array()).with_cone(cone);
            if around.cos > 0.0 {
                let cos = f64::from(around.cos);
                record.sin = ((1.0 - cos * cos).max(0.0).sqrt() * 255.0 + 1e-3).ceil().min(255.0) as u8;
            }
        }
        record
    }

    /// Checks that a stored record is a valid bound.
    ///
    /// # Errors
    /// A description of what is wrong.
    pub(in crate::model) fn check_shape(self) -> Result<(), &'static str> {
        let axis = self.axis.map(i32::from);
        if self.radius > round_up(f32::INFINITY) || self.error > round_up(f32::INFINITY) {
            return Err("has a radius or an error that is no number");
        }
        if axis.iter().map(|x| x * x).sum::<i32>() > 127 * 127 {
            return Err("has an axis that is longer than 1");
        }
        Ok(())
    }

    /// Whether the record was made from this error.
    pub(in crate::model) fn has_error(self, error: f32) -> bool {
        self.error == round_up(error)
    }

    /// Reads the records of `step_count` steps.
    ///
    /// # Errors
    /// [`ModelError::Length`] if the number of bytes does not match.
    pub(in crate::model) fn read_all(bytes: &[u8], step_count: usize) -> Result<Vec<Self>, ModelError> {
        let expected = size_of::<Self>() * step_count;
        if bytes.len() != expected {
            return Err(ModelError::Length { what: "bytes of bounds", found: bytes.len(), expected });
        }
        let mut records = vec![Self::default(); step_count];
        bytemuck::must_cast_slice_mut(&mut records).copy_from_slice(bytes);
        Ok(records)
    }

    /// Unpacks the bounds around a center.
    #[inline(always)]
    pub fn part(self, center: [f32; 3]) -> Part {
        // Rounding may have lengthened the axis a little; this makes up for it.
        let axis = self.axis.map(|x| f32::from(x) * (1.0 / 127.001));
        Part {
            sphere: Sphere { center, radius: expand(self.radius) },
            cone: NormalCone { axis, cos: COSINES[usize::from(self.sin)] },
            error: expand(self.error),
        }
    }
}

/// Cosine of the half-angle of a cone by its stored sine; a lookup takes less time than a square root.
static COSINES: [f32; 256] = cosines();

const fn cosines() -> [f32; 256] {
    let mut all = [-1.0; 256];
    let mut sin = 0;
    while sin < 255 {
        // Newton's method, because roots are not available in constants; it ends just above the root.
        let square = 1.0 - (sin * sin) as f64 / (255.0 * 255.0);
        let mut root: f64 = 1.0;
        let mut step = 0;
        while step < 12 {
            root = (root + square / root) / 2.0;
            step += 1;
        }
        all[sin] = root as f32;
        sin += 1;
    }
    all
}

/// Returns the upper 16 bits, without the sign, of a non-negative float rounded up to the next value whose
/// lower bits are zero.
fn round_up(number: f32) -> u16 {
    let bits = number.max(0.0).to_bits();
    (bits.div_ceil(1 << 15)).min(f32::INFINITY.to_bits() >> 15) as u16
}

#[inline]
/// Inverse of [`round_up`].
fn expand(bits: u16) -> f32 {
    f32::from_bits(u32::from(bits) << 15)
}

/// Returns the unit vector along an axis, or zero if the axis is zero.
pub(in crate::model) fn direction(axis: [f32; 3]) -> DVec3 {
    Vec3::from(axis).as_dvec3().normalize_or_zero()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    #[test]
    fn rounding_up_adds_little() {
        for number in [0.0, 1e-40, 1e-20, 0.1, 1.0, 1.001, 12345.6, 3e38] {
            let kept = expand(round_up(number));
            assert!(kept >= number && kept <= number * 1.004 + 1e-40, "{number} became {kept}");
        }
        assert_eq!(expand(round_up(f32::INFINITY)), f32::INFINITY);
        assert_eq!(expand(round_up(f32::MAX)), f32::INFINITY);
    }

    #[test]
    fn cosines_are_those_of_the_sines() {
        for sin in 0..255u8 {
            let expected = (1.0 - (f64::from(sin) / 255.0).powi(2)).sqrt();
            let found = f64::from(COSINES[usize::from(sin)]);
            assert!((found - expected).abs() < 1e-7, "{sin}: {found}, not {expected}");
        }
        assert_eq!(COSINES[255], -1.0);
    }

    #[test]
    fn a_stored_cone_encloses_the_original_cone() {
        let mut random = Random::new(9);
        let mut direction = || DVec3::from([(); 3].map(|()| random.unit() - 0.5)).normalize();
        let mut wider = 0.0f32;
        for _ in 0..2000 {
            let (axis, other) = (direction(), direction());
            let cone = NormalCone::around(axis.to_array())
                .with_cone(&NormalCone::around((axis * 1.5 + other).normalize().to_array()));
            let kept = PartRecord::holding(1.0, &cone, 0.0).part([0.0; 3]).cone;
            assert!(Vec3::from(kept.axis).length() <= 1.0);
            let around = NormalCone::around(super::direction(kept.axis).to_array()).with_cone(&cone);
            assert!(kept.cos <= around.cos, "{cone:?} became {kept:?}");
            wider = wider.max(cone.cos - kept.cos);
        }
        assert!(wider < 0.02, "a cone lost {wider} of its cosine");
        assert_eq!(PartRecord::holding(1.0, &NormalCone::ALL, 0.0).part([0.0; 3]).cone.cos, -1.0);
    }
}
