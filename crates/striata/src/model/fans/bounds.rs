//! What a criterion needs of each step: a sphere, a cone of normals and an error, in eight bytes.
//!
//! A step changes what its star and its floor cover. Its bounds hold that, and the bounds of all steps below it in the tree,
//! each of which needs the one above it \[Hop97\]. So a step whose bounds cannot be seen has nothing below it that can, and
//! a walk down the tree finds every step that a view wants. What these need beside themselves is undone with them; bounds over
//! all that a step waits for would spare that, and be so wide that a view shows a third more triangles. Cones that also hold
//! the normals of the full mesh under the star were tried: 2 % more triangles, and no error on the screen was smaller.
//!
//! Spheres have the positions of the steps as centres, which are there anyway. All numbers are rounded to the safe side: a
//! radius and an error are the upper 16 bits of what they are without a sign, an axis is three bytes, and a sine is one. What is
//! rounded is what the parent's bounds hold, so that rounding never makes a part weigh more than the whole.

use glam::{DVec3, Vec3};

use super::Fans;
use crate::mesh::{CollapseSequence, RefinableMesh};
use crate::model::ModelError;
use crate::view::{NormalCone, Part, Sphere};

/// For each step a sphere and a cone of normals that hold whatever it and those below it in the tree change, and the error that is
/// there while it is taken.
#[derive(Clone, Debug, PartialEq)]
pub struct FanBounds {
    pub(super) records: Vec<Record>,
}

/// What is stored of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(super) struct Record {
    radius: u16,
    error: u16,
    /// Of the cone, 127 being 1.
    axis: [i8; 3],
    /// Of the cone, 255 being 1.
    sin: u8,
}

impl FanBounds {
    /// The bounds of a table's steps.
    ///
    /// # Panics
    /// If the table is another mesh's, by its count of steps.
    pub fn build(fans: &Fans, refinable: &RefinableMesh) -> Self {
        let step_count = fans.step_count;
        assert_eq!(step_count, refinable.sequence.step_count(), "the table is another mesh's");
        let mut records = vec![Record::default(); step_count];
        let mut normals = vec![DVec3::ZERO; step_count];
        let mut changed = Vec::new();
        let positions = &refinable.mesh.positions;
        // What is below a step is finer, so its bounds are known by then.
        for step in (0..step_count as u32).rev() {
            changed.clear();
            fans.triangles_changed_by(step, &refinable.sequence, &mut changed);
            let corners = changed.iter().map(|t| t.map(|v| positions[v as usize]));
            let mut sphere = Sphere::point(positions[fans.center_vertex(step)]);
            for corner in corners.clone().flatten() {
                sphere = sphere.with_point(corner);
            }
            let own = NormalCone::of_triangles(corners);
            let mut normal = direction(own.axis);
            fans.for_each_child(Some(step), |child| normal += normals[child as usize]);
            normals[step as usize] = normal;
            let mut cone = NormalCone::around(normal).with_cone(&own);
            fans.for_each_child(Some(step), |child| {
                let center = positions[fans.center_vertex(child)];
                let below = records[child as usize].part(center);
                sphere = sphere.with_sphere(&below.sphere);
                cone = cone.with_cone(&below.cone);
            });
            let error = refinable.sequence.error_at(step as usize);
            records[step as usize] = Record::holding(sphere.radius, &cone, error);
        }
        Self { records }
    }

    /// What a step is to a criterion, given the positions of the mesh's vertices.
    ///
    /// # Panics
    /// If there is no such step or position.
    #[inline]
    pub fn part(&self, fans: &Fans, positions: &[[f32; 3]], step: u32) -> Part {
        self.records[step as usize].part(positions[fans.center_vertex(step)])
    }

    /// Steps that there are bounds of.
    pub(crate) fn step_count(&self) -> usize {
        self.records.len()
    }

    /// The records as files hold them.
    pub(crate) fn as_bytes(&self) -> &[u8] {
        bytemuck::must_cast_slice(&self.records)
    }

    /// The bounds of steps that leave such errors, from the bytes of their records.
    ///
    /// # Errors
    /// Where there are more or fewer records, or one holds what no bounds are.
    pub(crate) fn from_bytes(bytes: &[u8], errors: &[f32]) -> Result<Self, ModelError> {
        let expected = size_of::<Record>() * errors.len();
        if bytes.len() != expected {
            return Err(ModelError::Length { what: "bytes of bounds", found: bytes.len(), expected });
        }
        let mut records = vec![Record::default(); errors.len()];
        bytemuck::must_cast_slice_mut(&mut records).copy_from_slice(bytes);
        for (step, (record, &error)) in records.iter().zip(errors).enumerate() {
            record.check(error).map_err(|reason| ModelError::Step { step, reason })?;
        }
        Ok(Self { records })
    }

    /// Bytes of the records.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.records[..])
    }
}

impl Record {
    fn holding(radius: f32, cone: &NormalCone, error: f32) -> Self {
        let mut record =
            Self { radius: round_up(radius), error: round_up(error), axis: [0; 3], sin: u8::MAX };
        if cone.cos > 0.0 {
            // Towards zero, so that the axis is never longer than 1.
            record.axis = cone.axis.map(|x| (x * 127.0) as i8);
            let around = NormalCone::around(direction(record.axis.map(f32::from))).with_cone(cone);
            if around.cos > 0.0 {
                let cos = f64::from(around.cos);
                record.sin = ((1.0 - cos * cos).max(0.0).sqrt() * 255.0 + 1e-3).ceil().min(255.0) as u8;
            }
        }
        record
    }

    fn check(self, error: f32) -> Result<(), &'static str> {
        let axis = self.axis.map(i32::from);
        if self.radius > round_up(f32::INFINITY) {
            return Err("has a radius that is no number");
        }
        if self.error != round_up(error) {
            return Err("has another error in its bounds than in the sequence");
        }
        if axis.iter().map(|x| x * x).sum::<i32>() > 127 * 127 {
            return Err("has an axis that is longer than 1");
        }
        Ok(())
    }

    #[inline]
    fn part(self, center: [f32; 3]) -> Part {
        let sin = f32::from(self.sin) * (1.0 / 255.0);
        // Shortened by what rounding may have added to it.
        let axis = self.axis.map(|x| f32::from(x) * (1.0 / 127.001));
        let cos = if self.sin == u8::MAX { -1.0 } else { (1.0 - sin * sin).sqrt() };
        Part {
            sphere: Sphere { center, radius: expand(self.radius) },
            cone: NormalCone { axis, cos },
            error: expand(self.error),
        }
    }
}

/// The upper 16 bits of a number that is not negative, without its sign; of the next larger number that has no lower ones.
fn round_up(number: f32) -> u16 {
    let bits = number.max(0.0).to_bits();
    (bits.div_ceil(1 << 15)).min(f32::INFINITY.to_bits() >> 15) as u16
}

#[inline]
fn expand(bits: u16) -> f32 {
    f32::from_bits(u32::from(bits) << 15)
}

fn direction(axis: [f32; 3]) -> DVec3 {
    Vec3::from(axis).as_dvec3().normalize_or_zero()
}

impl Fans {
    /// The vertex at whose position a step's sphere has its centre.
    #[inline]
    pub(super) fn center_vertex(&self, step: u32) -> usize {
        self.vertices.of_step(step as usize).start as usize
    }

    /// Appends the star that a step takes away and the floor that it leaves.
    fn triangles_changed_by(&self, step: u32, sequence: &CollapseSequence, out: &mut Vec<[u32; 3]>) {
        let vertices = self.vertices.of_step(step as usize);
        let mut indices = Vec::new();
        for vertex in vertices.clone() {
            for fan in self.step_entry(vertex, step) {
                fan.triangles_into(fan.mask(|_| true), &mut indices);
            }
        }
        for &star in indices.as_chunks().0 {
            let floor = star.map(|v| if vertices.contains(&v) { sequence.target(v) } else { v });
            out.extend([star, floor]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    #[test]
    fn numbers_are_rounded_up_by_little() {
        for number in [0.0, 1e-40, 1e-20, 0.1, 1.0, 1.001, 12345.6, 3e38] {
            let kept = expand(round_up(number));
            assert!(kept >= number && kept <= number * 1.004 + 1e-40, "{number} became {kept}");
        }
        assert_eq!(expand(round_up(f32::INFINITY)), f32::INFINITY);
        assert_eq!(expand(round_up(f32::MAX)), f32::INFINITY);
    }

    fn terrain() -> RefinableMesh {
        let mesh = crate::mesh::shapes::terrain(24, 5);
        let options = crate::simplify::SequenceOptions::default();
        crate::simplify::build_sequence(&mesh, &options, &mut crate::ignore_progress).unwrap().refinable
    }

    #[test]
    fn bounds_hold_what_their_step_changes() {
        let refinable = terrain();
        let fans = Fans::build(&refinable);
        let bounds = FanBounds::build(&fans, &refinable);
        let positions = &refinable.mesh.positions;
        let mut changed = Vec::new();
        for step in 0..fans.step_count as u32 {
            let part = bounds.part(&fans, positions, step);
            assert!(part.error >= refinable.sequence.error_at(step as usize));
            changed.clear();
            fans.triangles_changed_by(step, &refinable.sequence, &mut changed);
            assert!(!changed.is_empty());
            for corners in changed.iter().map(|t| t.map(|v| positions[v as usize])) {
                assert!(
                    corners.iter().all(|&p| part.sphere.holds(p)),
                    "step {step}: {corners:?} in {part:?}"
                );
                let cone = NormalCone::of_triangles([corners].into_iter());
                // A triangle without area has no normal.
                assert!(
                    cone == NormalCone::ALL || part.cone.holds(cone.axis),
                    "step {step}: {cone:?} in {part:?}"
                );
            }
        }
    }

    #[test]
    fn every_step_is_below_one_that_it_needs_and_within_its_bounds() {
        let refinable = terrain();
        let fans = Fans::build(&refinable);
        let bounds = FanBounds::build(&fans, &refinable);
        let part = |step| bounds.part(&fans, &refinable.mesh.positions, step);
        let mut parents = vec![0; fans.step_count];
        fans.for_each_child(None, |child| parents[child as usize] += 1);
        for step in 0..fans.step_count as u32 {
            let whole = part(step);
            fans.for_each_child(Some(step), |child| {
                parents[child as usize] += 1;
                let inner = part(child);
                assert!(whole.sphere.with_sphere(&inner.sphere).radius <= whole.sphere.radius * 1.0001);
                let axis = |cone: NormalCone| NormalCone::around(direction(cone.axis));
                let around =
                    axis(whole.cone).with_cone(&NormalCone { axis: axis(inner.cone).axis, ..inner.cone });
                assert!(whole.cone.cos <= around.cos + 1e-4, "{whole:?} around {inner:?}");
                assert!(whole.error >= inner.error);
                let mut is_needed = false;
                fans.for_each_needed_by_split(child, |needed| is_needed |= needed == step);
                assert!(is_needed, "step {child} is below {step}");
            });
        }
        assert!(parents.iter().all(|&count| count == 1));
    }

    #[test]
    fn a_stored_cone_holds_the_cone_that_it_was_made_of() {
        let mut random = Random::new(9);
        let mut direction = || DVec3::from([(); 3].map(|()| random.unit() - 0.5)).normalize();
        let mut wider = 0.0f32;
        for _ in 0..2000 {
            let (axis, other) = (direction(), direction());
            let cone =
                NormalCone::around(axis).with_cone(&NormalCone::around((axis * 1.5 + other).normalize()));
            let kept = Record::holding(1.0, &cone, 0.0).part([0.0; 3]).cone;
            assert!(Vec3::from(kept.axis).length() <= 1.0);
            let around = NormalCone::around(super::direction(kept.axis)).with_cone(&cone);
            assert!(kept.cos <= around.cos, "{cone:?} became {kept:?}");
            wider = wider.max(cone.cos - kept.cos);
        }
        assert!(wider < 0.02, "a cone lost {wider} of its cosine");
        assert_eq!(Record::holding(1.0, &NormalCone::ALL, 0.0).part([0.0; 3]).cone.cos, -1.0);
    }
}
