//! A front that follows a view shows the same as refining from the base, regardless of the path.

use striata_testing::support;

use striata::mesh::{RefinableMesh, canonical_triangles};
use striata::model::{FanFront, FanInstance, FanScene, Fans, LodModel};
use striata::view::{Camera, Criterion, Fovea, Part, ScreenError, Sphere, Verdict};
use support::{ArbitraryCriterion, Random, nasty_cases, seam_cases, selective_triangles, surface_cases};

struct Walk {
    random: Random,
    sphere: Sphere,
    eye: [f32; 3],
    to: [f32; 3],
}

impl Walk {
    fn new(sphere: Sphere, seed: u64) -> Self {
        let mut walk = Self { random: Random::new(seed), sphere, eye: [0.0; 3], to: [0.0; 3] };
        walk.jump();
        walk
    }

    fn around(&mut self, spread: f32) -> [f32; 3] {
        let radius = self.sphere.radius.max(1e-3);
        [0, 1, 2].map(|i| {
            self.sphere.center[i] + (self.random.below(1000) as f32 / 1000.0 - 0.5) * spread * radius
        })
    }

    fn jump(&mut self) {
        self.eye = self.around(8.0);
        self.to = self.around(1.0);
    }

    /// Takes a small step, or occasionally a jump.
    fn step(&mut self, pixels: f32) -> ScreenError {
        if self.random.below(12) == 0 {
            self.jump();
        } else {
            let (eye, to) = (self.around(0.3), self.around(0.1));
            for i in 0..3 {
                self.eye[i] += eye[i] - self.sphere.center[i];
                self.to[i] += to[i] - self.sphere.center[i];
            }
        }
        let camera = Camera::new(self.eye, self.to, [0.1, 1.0, 0.2], 0.5, [800, 600]).unwrap();
        ScreenError::new(camera, pixels).with_model_bounds(self.sphere)
    }
}

/// Variants of a criterion that a walk is tested with.
fn variant(criterion: ScreenError, kind: usize, sphere: Sphere) -> ScreenError {
    match kind {
        0 => criterion,
        1 => criterion.with_silhouettes(0.3),
        2 => criterion.with_region(Sphere { radius: 0.3 * sphere.radius, ..sphere }, 0.1),
        _ => criterion.with_fovea(Fovea { at: [0.2, -0.3], radius: 0.1, falloff: 5.0 }),
    }
}

fn follow(refinable: &RefinableMesh, kind: usize, seed: u64) -> [usize; 2] {
    let fans = Fans::build(refinable);
    let scene = FanScene::new(&fans, &refinable.mesh.positions);
    let mut walk = Walk::new(scene.sphere(), seed);
    let mut front = FanFront::new(&scene);
    let mut fresh = FanInstance::full(&fans);
    let (mut evaluated, mut listed) = (0, 0);
    for _ in 0..40 {
        let criterion = variant(walk.step(2.0), kind, scene.sphere());
        let update = front.update(&scene, &criterion, usize::MAX);
        assert!(update.is_complete);
        fresh.refine(&scene, &criterion);
        assert_eq!(front.instance(), &fresh, "criterion {kind}");
        let mut indices = Vec::new();
        fresh.indices_into(&fans, &mut indices);
        assert_eq!(front.triangle_count(), indices.len() / 3);
        evaluated += update.evaluated_count;
        listed += fresh.split_count();
    }
    [evaluated, listed]
}

#[test]
fn a_front_shows_what_is_refined_from_the_base() {
    for (i, case) in nasty_cases().chain(surface_cases()).chain(seam_cases()).enumerate() {
        follow(&case.refinable, i % 4, case.seed);
    }
}

#[test]
fn most_active_steps_are_not_evaluated_again() {
    let mesh = striata::mesh::shapes::uv_sphere(60, 60, 1.0);
    let built = striata::simplify::build_sequence(&mesh, &Default::default());
    let refinable = built.unwrap().refinable;
    let fans = Fans::build(&refinable);
    let scene = FanScene::new(&fans, &refinable.mesh.positions);
    let mut front = FanFront::new(&scene);
    let (mut evaluated, mut active) = (0, 0);
    for frame in 0..200 {
        let eye = [3.0 - frame as f32 * 0.004, 0.5, 1.0];
        let camera = Camera::new(eye, [0.0; 3], [0.0, 1.0, 0.0], 0.5, [1000, 1000]).unwrap();
        let update = front.update(
            &scene,
            &ScreenError::new(camera, 1.0).with_model_bounds(scene.sphere()),
            usize::MAX,
        );
        evaluated += if frame > 0 { update.evaluated_count } else { 0 };
        active += front.instance().split_count();
    }
    assert!(active > 40_000 && evaluated < active / 4, "{evaluated} of {active} active steps evaluated");
}

#[test]
fn change_limits_hold_and_the_view_is_reached_eventually() {
    for case in surface_cases().chain(seam_cases()) {
        let fans = Fans::build(&case.refinable);
        let scene = FanScene::new(&fans, &case.refinable.mesh.positions);
        let mut walk = Walk::new(scene.sphere(), case.seed);
        let mut front = FanFront::new(&scene);
        for limit in [1, 2, 3, 7, 50] {
            let criterion = walk.step(1.0);
            let mut frame_count = 0;
            loop {
                let update = front.update(&scene, &criterion, limit);
                assert!(update.changes() <= limit);
                frame_count += 1;
                assert!(frame_count <= 4 * fans.step_count() + 2, "the view is never reached");
                if update.is_complete {
                    break;
                }
            }
            let mut fresh = FanInstance::full(&fans);
            fresh.refine(&scene, &criterion);
            assert_eq!(front.instance(), &fresh);
        }
    }
}

/// Splits begun for a view that has changed are reverted.
#[test]
fn views_that_were_never_reached_leave_nothing_behind() {
    for case in surface_cases().chain(seam_cases()) {
        let fans = Fans::build(&case.refinable);
        let scene = FanScene::new(&fans, &case.refinable.mesh.positions);
        let mut walk = Walk::new(scene.sphere(), case.seed);
        let mut front = FanFront::new(&scene);
        let mut fresh = FanInstance::full(&fans);
        for round in 0..60 {
            for _ in 0..6 {
                front.update(&scene, &walk.step(1.0), 1 + round % 3);
            }
            let criterion = walk.step(1.0);
            assert!(front.update(&scene, &criterion, usize::MAX).is_complete);
            fresh.refine(&scene, &criterion);
            assert_eq!(front.instance(), &fresh);
        }
    }
}

#[test]
fn an_arbitrary_criterion_yields_levels_without_cracks() {
    for case in nasty_cases().chain(surface_cases()).chain(seam_cases()) {
        let fans = Fans::build(&case.refinable);
        let scene = FanScene::new(&fans, &case.refinable.mesh.positions);
        let mut front = FanFront::new(&scene);
        for round in 0..20 {
            front.update(&scene, &ArbitraryCriterion(round * 7919), [usize::MAX, 5][round as usize % 2]);
            let instance = front.instance();
            let mut indices = Vec::new();
            instance.indices_into(&fans, &mut indices);
            let full = &case.refinable.mesh.triangles;
            let expected = selective_triangles(&case.refinable, full, |step| !instance.is_refined(step));
            assert_eq!(canonical_triangles(indices.as_chunks().0), canonical_triangles(&expected));
            assert_eq!(front.triangle_count(), indices.len() / 3);
        }
    }
}

/// Returns the instance with everything that weighs more than a threshold, and what that needs.
fn refined_above(scene: &FanScene<'_>, criterion: &ScreenError, threshold: f32) -> FanInstance {
    let mut instance = FanInstance::full(scene.fans());
    instance.refine(scene, &|part: &Part| criterion.weigh(part).weight / threshold);
    instance
}

fn triangle_count(fans: &Fans, instance: &FanInstance) -> usize {
    let mut indices = Vec::new();
    instance.indices_into(fans, &mut indices);
    indices.len() / 3
}

#[test]
fn a_budget_is_spent_on_the_largest_weights() {
    let mut bound = 0;
    for case in surface_cases().chain(seam_cases()) {
        let fans = Fans::build(&case.refinable);
        let scene = FanScene::new(&fans, &case.refinable.mesh.positions);
        let mut walk = Walk::new(scene.sphere(), case.seed);
        let mut front = FanFront::new(&scene);
        let full = triangle_count(&fans, &FanInstance::full(&fans));
        for round in 0..30 {
            let criterion = walk.step(1.0);
            let limit = full * [10, 25, 60][round % 3] / 100;
            let update = front.update_to_budget(&scene, &criterion, limit);
            assert_eq!(front.triangle_count(), triangle_count(&fans, front.instance()));
            // Steps of equal weight may be partially refined.
            let [least, more] =
                [1.0, 1.0 - 1e-6].map(|x| refined_above(&scene, &criterion, update.threshold * x));
            for step in 0..fans.step_count() as u32 {
                assert!(
                    !least.is_refined(step) || front.instance().is_refined(step),
                    "step {step} is missing"
                );
                assert!(
                    !front.instance().is_refined(step) || more.is_refined(step),
                    "step {step} is too much"
                );
            }
            assert!(front.triangle_count() <= limit.max(fans.base_triangle_count()));
            if update.threshold > 1.0 {
                // A slightly smaller threshold would exceed the budget.
                bound += 1;
                assert!(triangle_count(&fans, &more) > limit, "{} of {limit}", front.triangle_count());
            }
        }
    }
    assert!(bound > 50, "only {bound} budgets were too small for the view");
}

#[test]
fn budget_and_tolerance_updates_can_alternate() {
    for case in surface_cases() {
        let fans = Fans::build(&case.refinable);
        let scene = FanScene::new(&fans, &case.refinable.mesh.positions);
        let mut walk = Walk::new(scene.sphere(), case.seed);
        let mut front = FanFront::new(&scene);
        for round in 0..12 {
            let criterion = walk.step(1.0);
            if round % 2 == 0 {
                front.update_to_budget(&scene, &criterion, 40);
            } else {
                front.update(&scene, &criterion, usize::MAX);
                assert_eq!(front.instance(), &refined_above(&scene, &criterion, 1.0));
            }
        }
    }
}

fn sphere_scene() -> RefinableMesh {
    let mesh = striata::mesh::shapes::uv_sphere(40, 40, 1.0);
    let built = striata::simplify::build_sequence(&mesh, &Default::default());
    built.unwrap().refinable
}

#[test]
fn a_pending_split_is_listed_once() {
    let refinable = sphere_scene();
    let fans = Fans::build(&refinable);
    let scene = FanScene::new(&fans, &refinable.mesh.positions);
    let mut front = FanFront::new(&scene);
    let all = |_: &Part| 2.0;
    front.update(&scene, &all, 3);
    front.update(&scene, &all, 0);
    let bytes = front.bytes();
    for _ in 0..200 {
        assert!(!front.update(&scene, &all, 0).is_complete);
    }
    assert_eq!(front.bytes(), bytes);
    assert!(front.update(&scene, &all, usize::MAX).is_complete);
    assert_eq!(front.instance(), &FanInstance::full(&fans));
}

/// The accumulated motion is imprecise after a long journey; verdicts given after it must remain as exact
/// as before.
#[test]
fn a_long_journey_does_not_extend_verdicts() {
    let refinable = sphere_scene();
    let fans = Fans::build(&refinable);
    let scene = FanScene::new(&fans, &refinable.mesh.positions);
    let mut front = FanFront::new(&scene);
    let mut fresh = FanInstance::full(&fans);
    let see = |eye: [f32; 3]| {
        let camera = Camera::new(eye, [0.0; 3], [0.0, 1.0, 0.0], 0.5, [1000, 1000]).unwrap();
        ScreenError::new(camera, 1.0).with_model_bounds(scene.sphere())
    };
    for far in [10.0, 1e4, 1e6, 1e8] {
        front.update(&scene, &see([far, 0.5, 1.0]), usize::MAX);
        for frame in 0..100 {
            let criterion = see([3.0 - frame as f32 * 0.01, 0.5, 1.0]);
            front.update(&scene, &criterion, usize::MAX);
            fresh.refine(&scene, &criterion);
            assert_eq!(front.instance(), &fresh, "frame {frame} after {far}");
        }
    }
}

fn changes_at_once(refinable: &RefinableMesh, pixels: f32, scale: f32) -> usize {
    let fans = Fans::build(refinable);
    let scene = FanScene::new(&fans, &refinable.mesh.positions);
    let eye = [0.0, 0.0, 3.0 * scale];
    let camera = Camera::new(eye, [0.0; 3], [0.0, 1.0, 0.0], 0.5, [1000, 1000]).unwrap();
    let criterion = ScreenError::new(camera, pixels).with_model_bounds(scene.sphere());
    FanFront::new(&scene).update(&scene, &criterion, usize::MAX).changes()
}

#[test]
fn any_number_of_pixels_is_a_limit() {
    let refinable = sphere_scene();
    let none = changes_at_once(&refinable, 0.0, 1.0);
    assert!(none > 100);
    for pixels in [f32::NAN, -1.0, f32::NEG_INFINITY, 1e-40] {
        assert_eq!(changes_at_once(&refinable, pixels, 1.0), none, "{pixels} pixels");
    }
    assert_eq!(changes_at_once(&refinable, f32::INFINITY, 1.0), 0);
}

#[test]
fn a_view_of_a_model_is_the_same_at_any_scale() {
    let sphere = striata::mesh::shapes::uv_sphere(20, 20, 1.0);
    let changes_at = |scale: f32| {
        let mut mesh = sphere.clone();
        mesh.positions.iter_mut().flatten().for_each(|x| *x *= scale);
        let built = striata::simplify::build_sequence(&mesh, &Default::default());
        changes_at_once(&built.unwrap().refinable, 1.0, scale)
    };
    let changes = changes_at(1.0);
    for scale in [1e-18, 1e-7, 1e7, 1e18] {
        // The order of the steps differs slightly.
        assert!(changes_at(scale).abs_diff(changes) < changes / 20, "{} at {scale}", changes_at(scale));
    }
}

/// Gives every part the same weight, with verdicts whose validity span is NaN.
#[derive(Clone)]
struct Numberless(f32);

impl Criterion for Numberless {
    fn weigh(&self, _: &Part) -> Verdict {
        Verdict { weight: self.0, motion_margin: f32::NAN }
    }

    fn motion_since(&self, _: &Self) -> f32 {
        0.0
    }
}

#[test]
fn a_verdict_with_nan_validity_is_evaluated_again() {
    let case = surface_cases().next().unwrap();
    let fans = Fans::build(&case.refinable);
    let scene = FanScene::new(&fans, &case.refinable.mesh.positions);
    let mut front = FanFront::new(&scene);
    front.update(&scene, &Numberless(0.0), usize::MAX);
    assert_eq!(front.instance(), &FanInstance::uniform(&fans, 0));
    front.update(&scene, &Numberless(2.0), usize::MAX);
    assert_eq!(front.instance(), &FanInstance::full(&fans));
}
