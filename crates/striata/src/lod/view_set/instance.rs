//! One instance of a set: its place, its triangles, and how long they are good enough.

use std::ops::Range;
use std::sync::Arc;

use glam::{DMat3, DMat4, DVec3};

use crate::Target;
use crate::lod::Level;
use crate::lod::tables::LodTables;
use crate::model::{FanFront, FanTriangles};
use crate::view::{Criterion, NormalCone, Part, ScreenError, Sphere};

/// Share by which errors may grow before an instance is updated.
const RESERVE_SHARE: f32 = 0.05;

/// An earlier reserve is kept while it is between these multiples of the best one, because another one would make the
/// front evaluate all of its steps again.
const KEPT_RESERVES: Range<f32> = 0.25..1.25;

/// Urgency of an instance that has to be updated.
pub(super) const DUE: f32 = 1.0;

/// Steps of the relaxation for a factor of 2.
const STEPS_PER_OCTAVE: i32 = 8;

/// Factor of the tolerance at some relaxation.
pub(super) fn factor_at(relaxation: i32) -> f32 {
    // The result must not depend on the machine, so there is no power function.
    let roots =
        [1.0, 1.090_508, 1.189_207, 1.296_84, std::f32::consts::SQRT_2, 1.542_211, 1.681_793, 1.834_008];
    let relaxation = relaxation.clamp(0, 512);
    let octave = f32::from_bits(((127 + relaxation / STEPS_PER_OCTAVE) as u32) << 23);
    octave * roots[(relaxation % STEPS_PER_OCTAVE) as usize]
}

/// An instance, its state, and what the frame found out about it.
#[derive(Clone, Debug)]
pub(super) struct PlacedInstance {
    base: Arc<Level>,
    matrix: DMat4,
    /// Largest factor by which the matrix enlarges lengths.
    scale: f64,
    importance: f32,
    shown: ShownDetail,
    /// The criterion of the last update, and its relaxation.
    last: Option<(ScreenError, i32)>,
    /// The criterion of this frame with a tolerance that is not relaxed; [`None`] if nothing is in the picture.
    now: Option<ScreenError>,
    has_changed: bool,
    /// Share of the last reserve that has been used; at least [`DUE`] if there is none.
    pub(super) urgency: f32,
    /// Radius on the screen, as a multiple of the tolerance.
    pub(super) size_px: f32,
}

/// Triangles that an instance shows.
#[derive(Clone, Debug)]
enum ShownDetail {
    Base,
    Uniform(Box<Level>),
    Followed(Box<FollowedView>),
}

#[derive(Clone, Debug)]
struct FollowedView {
    front: FanFront<ScreenError>,
    triangles: FanTriangles,
}

impl PlacedInstance {
    /// Places an instance; [`None`] if the matrix cannot be used.
    pub(super) fn new(base: Arc<Level>, matrix: &[[f32; 4]; 4]) -> Option<Self> {
        let mut instance = Self {
            base,
            matrix: DMat4::IDENTITY,
            scale: 1.0,
            importance: 1.0,
            shown: ShownDetail::Base,
            last: None,
            now: None,
            has_changed: true,
            urgency: DUE,
            size_px: 0.0,
        };
        instance.place(matrix).then_some(instance)
    }

    /// Moves the instance; returns whether the matrix can be used.
    pub(super) fn place(&mut self, matrix: &[[f32; 4]; 4]) -> bool {
        let matrix = DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from)));
        let linear = DMat3::from_mat4(matrix);
        let is_affine = matrix.is_finite() && matrix.row(3) == glam::DVec4::W;
        let scale = largest_scale(&linear);
        let is_usable = is_affine && scale > 0.0 && linear.determinant().abs() > 1e-12 * scale.powi(3);
        if is_usable {
            (self.matrix, self.scale) = (matrix, scale);
        }
        is_usable
    }

    pub(super) fn set_importance(&mut self, importance: f32) {
        self.importance = importance;
    }

    pub(super) fn triangle_count(&self) -> usize {
        self.indices().len() / 3
    }

    pub(super) fn indices(&self) -> &[u32] {
        match &self.shown {
            ShownDetail::Base => self.base.indices(),
            ShownDetail::Uniform(level) => level.indices(),
            ShownDetail::Followed(view) => view.triangles.indices(),
        }
    }

    pub(super) fn groups(&self) -> &[Range<u32>] {
        match &self.shown {
            ShownDetail::Base => self.base.groups(),
            ShownDetail::Uniform(level) => level.groups(),
            ShownDetail::Followed(view) => view.triangles.group_ranges(),
        }
    }

    pub(super) fn bytes(&self) -> usize {
        size_of::<Self>()
            + match &self.shown {
                ShownDetail::Base => 0,
                ShownDetail::Uniform(_) => size_of::<Level>(),
                ShownDetail::Followed(view) => {
                    size_of::<FollowedView>() + view.front.bytes() + view.triangles.bytes()
                }
            }
    }

    /// Whether the indices have changed since the last call.
    pub(super) fn take_change(&mut self) -> bool {
        std::mem::take(&mut self.has_changed)
    }

    /// Relaxation of the last update, if something of the instance is in the picture.
    pub(super) fn relaxation(&self) -> Option<i32> {
        self.now.as_ref().and(self.last.as_ref()).map(|last| last.1)
    }

    /// Whether something of the instance may be in the picture.
    pub(super) fn is_seen(&self) -> bool {
        self.now.is_some()
    }

    /// Whether the instance was outside the picture before this frame.
    pub(super) fn is_new(&self) -> bool {
        self.now.is_some() && self.last.is_none()
    }

    fn tables(&self) -> &Arc<LodTables> {
        self.base.tables()
    }

    /// Finds out whether the instance is in the picture and how much it needs an update. Outside, it returns to its base
    /// mesh.
    pub(super) fn look_at(&mut self, error: &ScreenError) {
        let (criterion, sphere) = self.criterion(error);
        let reserve = self.reserve(&criterion);
        let size_px = radius_px(&criterion.clone().with_reserve(reserve), &sphere);
        if size_px == 0.0 {
            self.leave();
            return;
        }
        let is_in_picture = radius_px(&criterion, &sphere) > 0.0;
        self.size_px = size_px;
        self.urgency = match &self.last {
            Some((last, relaxation)) => {
                let relaxed = self.relaxed(criterion.clone(), *relaxation).with_reserve(reserve);
                let motion = relaxed.motion_since(last);
                if motion == 0.0 { 0.0 } else { motion / reserve }
            }
            // It has just appeared at the border of the picture, or will soon.
            None => {
                if is_in_picture {
                    DUE
                } else {
                    DUE / 2.0
                }
            }
        };
        self.urgency = if self.urgency.is_nan() { DUE } else { self.urgency };
        self.now = Some(criterion.with_reserve(reserve));
    }

    /// Shows the base mesh and forgets the rest.
    pub(super) fn leave(&mut self) {
        self.has_changed |= self.indices() != self.base.indices();
        (self.shown, self.last, self.now) = (ShownDetail::Base, None, None);
        (self.urgency, self.size_px) = (0.0, 0.0);
    }

    /// Shows the base mesh, because the budget allows no more.
    pub(super) fn give_up(&mut self) {
        self.has_changed |= self.indices() != self.base.indices();
        (self.shown, self.last) = (ShownDetail::Base, None);
    }

    /// Returns the criterion in the space where errors are measured, and the sphere around the mesh there.
    fn criterion(&self, error: &ScreenError) -> (ScreenError, Sphere) {
        let own = self.tables().sphere();
        if let Some(criterion) = error.in_object(&self.matrix.to_cols_array()) {
            return (criterion.with_model_bounds(own), own);
        }
        let center = self.matrix.transform_point3(DVec3::from(own.center.map(f64::from)));
        let radius = (f64::from(own.radius) * self.scale) as f32 * 1.000_001;
        let sphere = Sphere { center: center.as_vec3().into(), radius };
        (error.clone().with_model_bounds(sphere), sphere)
    }

    fn relaxed(&self, criterion: ScreenError, relaxation: i32) -> ScreenError {
        criterion.relaxed(factor_at(relaxation) / self.importance)
    }

    /// Returns the reserve for this frame: the last one if it is still good.
    fn reserve(&self, criterion: &ScreenError) -> f32 {
        let best = criterion.motion_of_growth(RESERVE_SHARE);
        match &self.last {
            Some((last, _)) if best > 0.0 && KEPT_RESERVES.contains(&(last.reserve() / best)) => {
                last.reserve()
            }
            // A power of two, so that instances that come nearer keep it for a while.
            _ => f32::from_bits(best.to_bits() & 0x7f80_0000),
        }
    }

    /// Refines and coarsens the instance with a tolerance, if something of it is in the picture.
    pub(super) fn refine(&mut self, relaxation: i32) {
        let Some(now) = self.now.clone() else { return };
        let criterion = self.relaxed(now, relaxation);
        self.has_changed |= if criterion.model() == Some(self.tables().sphere()) {
            self.follow(&criterion)
        } else {
            self.show_uniform(&criterion)
        };
        self.last = Some((criterion, relaxation));
        self.urgency = 0.0;
    }

    fn follow(&mut self, criterion: &ScreenError) -> bool {
        let tables = Arc::clone(self.tables());
        if !matches!(self.shown, ShownDetail::Followed(_)) {
            let front = FanFront::new(&tables.scene());
            let triangles = FanTriangles::new(tables.fans(), front.instance());
            self.shown = ShownDetail::Followed(Box::new(FollowedView { front, triangles }));
        }
        let ShownDetail::Followed(view) = &mut self.shown else { return false };
        view.front.update(&tables.scene(), criterion, usize::MAX);
        let has_changed = view.triangles.follow(tables.fans(), view.front.instance()) > 0;
        if view.front.instance().split_count() == 0 {
            // A base mesh needs no front.
            self.shown = ShownDetail::Base;
        }
        has_changed
    }

    /// Shows the coarsest uniform level that the criterion allows at the nearest point of the sphere.
    fn show_uniform(&mut self, criterion: &ScreenError) -> bool {
        let Some(sphere) = criterion.model() else { return false };
        let sequence = &self.tables().refinable().sequence;
        let is_wanted = |error: f32| {
            let error = (f64::from(error) * self.scale) as f32;
            criterion.weigh(&Part { sphere, cone: NormalCone::ALL, error }).should_refine()
        };
        let split_count =
            sequence.errors().partition_point(|&error| is_wanted(error)).min(sequence.step_count());
        let target = Target::SplitCount(split_count);
        match &mut self.shown {
            ShownDetail::Uniform(level) if level.split_count() == split_count => return false,
            ShownDetail::Uniform(level) => level.move_to(target),
            _ => {
                let mut level = Level::clone(&self.base);
                level.move_to(target);
                self.shown = ShownDetail::Uniform(Box::new(level));
            }
        }
        true
    }
}

/// Returns the radius of a sphere on the screen, in pixels over the tolerance; 0 if it is outside the picture.
fn radius_px(criterion: &ScreenError, sphere: &Sphere) -> f32 {
    let error = sphere.radius.max(f32::MIN_POSITIVE);
    criterion.weigh(&Part { sphere: *sphere, cone: NormalCone::ALL, error }).weight
}

/// Returns an upper bound of the factor by which a matrix enlarges lengths; exact for rotations with scales along the
/// axes.
fn largest_scale(linear: &DMat3) -> f64 {
    let squares = linear.transpose() * *linear;
    let rows = [squares.x_axis, squares.y_axis, squares.z_axis];
    // No eigenvalue exceeds the largest sum of a row.
    rows.map(|row| row.abs().element_sum()).into_iter().fold(0.0, f64::max).sqrt()
}

#[cfg(test)]
impl PlacedInstance {
    pub(super) fn followed(&self) -> Option<&FanFront<ScreenError>> {
        match &self.shown {
            ShownDetail::Followed(view) => Some(&view.front),
            _ => None,
        }
    }

    pub(super) fn is_base(&self) -> bool {
        matches!(self.shown, ShownDetail::Base)
    }

    pub(super) fn is_level(&self) -> bool {
        matches!(self.shown, ShownDetail::Uniform(_))
    }

    pub(super) fn matrix(&self) -> [f64; 16] {
        self.matrix.to_cols_array()
    }

    pub(super) fn fans(&self) -> &crate::model::Fans {
        self.tables().fans()
    }

    pub(super) fn scene(&self) -> crate::model::FanScene<'_> {
        self.tables().scene()
    }
}
