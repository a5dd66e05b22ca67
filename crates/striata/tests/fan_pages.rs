//! Tables of which only some pages are loaded: any pages give a valid surface, and loading what a view asks for leads
//! to what the whole table shows.

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::{FragmentedMesh, shapes};
use striata::model::{FanInstance, FanScene, Fans, LodModel, PageDemand, PagedFans};
use striata::simplify::build_sequence;
use striata::view::{Camera, Criterion, ScreenError};
use support::{
    ArbitraryCriterion, Random, assert_shows_set, fragment_cases, hub_cases, nasty_cases, seam_cases,
    surface_cases,
};

/// A mesh, its table, and all pages of it.
struct Model {
    mesh: FragmentedMesh,
    fans: Fans,
    paged: PagedFans,
    pages: Vec<Vec<u8>>,
}

impl Model {
    fn new(mesh: FragmentedMesh, max_steps: usize) -> Self {
        let fans = Fans::build(&mesh);
        let (directory, pages) = fans.to_pages(&mesh.mesh, max_steps);
        assert_eq!(directory.page_count(), pages.len());
        assert_eq!(directory.step_count(), fans.step_count());
        Self { mesh, fans, paged: PagedFans::new(directory), pages }
    }

    fn scene(&self) -> FanScene<'_> {
        FanScene::new(&self.fans, &self.mesh.mesh.positions)
    }

    fn load(&mut self, page: u32) {
        assert!(!self.paged.is_loaded(page), "page {page} was asked for, but it is loaded");
        assert_eq!(self.paged.load(&self.pages[page as usize]), Ok(page));
    }

    /// Loads each page with a probability of `percent`, and unloads it otherwise.
    fn withhold(&mut self, percent: usize, random: &mut Random) {
        for page in 0..self.pages.len() as u32 {
            self.paged.unload(page);
            if random.below(100) < percent {
                self.load(page);
            }
        }
    }

    /// Whether the page of a step is loaded.
    fn has(&self, step: u32) -> bool {
        self.paged.is_loaded(self.paged.directory().page_of(step))
    }

    /// Checks that the surface is valid and uses only what is loaded.
    fn check(&self, instance: &FanInstance) {
        let triangles = self.paged.triangles(instance);
        assert_shows_set(&self.mesh.fragments, &triangles, |step| instance.is_refined(step));
        for step in (0..self.fans.step_count() as u32).filter(|&step| instance.is_refined(step)) {
            assert!(self.has(step), "step {step} is shown, but its page is not loaded");
            assert_eq!(instance.clone().split(&self.fans, step), 0);
            assert!(!needs_more(&self.fans, instance, step), "step {step} needs a step that is not shown");
        }
    }

    /// Refines, checks the result, and that no step has been left out that could be shown.
    fn refine(&self, criterion: &impl Criterion) -> (FanInstance, PageDemand) {
        let mut instance = self.paged.base_instance();
        let demand = self.paged.refine(&mut instance, criterion);
        self.check(&instance);
        assert!(demand.used.iter().all(|&page| self.paged.is_loaded(page)));
        assert!(demand.absent.iter().all(|absent| !self.paged.is_loaded(absent.page)));
        assert!(demand.absent.windows(2).all(|pair| pair[0].weight >= pair[1].weight));
        (instance, demand)
    }
}

/// Whether a step needs others than those that are refined.
fn needs_more(fans: &Fans, instance: &FanInstance, step: u32) -> bool {
    let mut with = instance.clone();
    if with.is_refined(step) {
        // Collapses what depends on the step too, which is finer than what the step needs.
        with.collapse(fans, step);
    }
    with.split(fans, step) > 1
}

fn cameras(scene: &FanScene<'_>, random: &mut Random) -> impl Iterator<Item = ScreenError> {
    let sphere = scene.sphere();
    (0..4).filter_map(move |_| {
        let at = sphere.center.map(|x| x + (random.below(1000) as f32 / 250.0 - 2.0) * sphere.radius);
        let camera = Camera::new(at, sphere.center, [0.1, 1.0, 0.2], 0.4, [600, 600]).ok()?;
        Some(ScreenError::new(camera, 1.5))
    })
}

fn follow(mesh: &FragmentedMesh, seed: u64, page_sizes: &[usize]) {
    let mut random = Random::new(seed);
    for &max_steps in page_sizes {
        let mut model = Model::new(mesh.clone(), max_steps);
        let cameras: Vec<_> = cameras(&model.scene(), &mut Random::new(seed)).collect();
        for screen in cameras {
            let mut whole = FanInstance::full(&model.fans);
            whole.refine(&model.scene(), &screen);
            model.withhold([0, 40, 80][random.below(3)], &mut random);
            let mut rounds = 0;
            loop {
                let (shown, demand) = model.refine(&screen);
                let steps = 0..model.fans.step_count() as u32;
                for step in steps.filter(|&step| !shown.is_refined(step) && whole.is_refined(step)) {
                    let is_wanted = screen.weigh(&model.scene().part(step)).should_refine();
                    let is_blocked = !model.has(step) || needs_more(&model.fans, &shown, step);
                    assert!(!is_wanted || is_blocked, "step {step} could be shown");
                }
                assert!(
                    (0..model.fans.step_count() as u32)
                        .all(|step| !shown.is_refined(step) || whole.is_refined(step))
                );
                if demand.absent.is_empty() {
                    assert_eq!(shown, whole);
                    break;
                }
                // Some of what is asked for, the most important first.
                for absent in &demand.absent[..demand.absent.len().div_ceil(2)] {
                    model.load(absent.page);
                }
                rounds += 1;
                assert!(rounds <= model.pages.len(), "loading does not end");
            }
            let mut settled = whole;
            model.withhold(70, &mut random);
            let before = settled.clone();
            let count = model.paged.settle(&mut settled);
            assert_eq!(count, before.split_count() - settled.split_count());
            model.check(&settled);
            for step in 0..model.fans.step_count() as u32 {
                let is_lost = before.is_refined(step) && !settled.is_refined(step);
                assert!(!is_lost || !model.has(step) || needs_more(&model.fans, &settled, step));
            }
        }
        for round in 0..6 {
            model.withhold(60, &mut random);
            model.refine(&ArbitraryCriterion(round * 7919));
        }
    }
}

#[test]
fn any_pages_of_removals_show_a_valid_surface() {
    fragment_cases().for_each(|(seed, mesh)| follow(&mesh, seed, &[1, 7, 40]));
}

#[test]
fn any_pages_of_collapses_show_a_valid_surface() {
    for case in nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases().take(2)) {
        let mesh = FragmentedMesh::from_collapses(&case.refinable);
        // The checks take time that grows with the square of the number of steps.
        if mesh.fragments.step_count() < 400 {
            follow(&mesh, case.seed, &[9]);
        }
    }
}

/// A camera that sees a part of a terrain loads a part of the table.
#[test]
fn a_view_loads_what_it_sees() {
    let refinable = build_sequence(&shapes::terrain(96, 5), &Default::default()).unwrap().refinable;
    let mut model = Model::new(FragmentedMesh::from_collapses(&refinable), 128);
    // Straight down from above, near a corner.
    let bounds = refinable.mesh.bounds().unwrap();
    let extent = [0, 1, 2].map(|i| bounds.max[i] - bounds.min[i]);
    let up = (0..3).min_by(|&a, &b| extent[a].total_cmp(&extent[b])).unwrap();
    let look_at = [0, 1, 2].map(|i| bounds.min[i] + if i == up { 1.0 } else { 0.15 } * extent[i]);
    let mut eye = look_at;
    eye[up] += 0.2 * extent[(up + 1) % 3];
    let camera = Camera::new(eye, look_at, [0.3, 0.4, 0.5], 0.3, [600, 600]).unwrap();
    let screen = ScreenError::new(camera, 1.0);
    let (mut loaded, mut first) = (0, None);
    let demand = loop {
        let (shown, demand) = model.refine(&screen);
        let Some(&most_important) = demand.absent.first() else { break demand };
        first.get_or_insert(most_important.page);
        model.load(most_important.page);
        loaded += 1;
        assert!(shown.split_count() <= 128 * loaded);
    };
    let total = model.pages.len();
    assert_eq!(first, Some(0), "the coarsest page comes first");
    assert!(loaded > total / 10 && loaded < total * 2 / 3, "{loaded} of {total} pages");
    assert!(demand.used.len() <= loaded);
    let whole: usize = model.fans.bytes().iter().map(|part| part.bytes).sum();
    let mut all = model.paged.clone();
    model.pages.iter().for_each(|page| assert!(all.load(page).is_ok()));
    let positions = 12 * refinable.mesh.vertex_count();
    assert!(all.bytes() < 2 * (whole + positions), "{} bytes, {whole} in one table", all.bytes());
    assert!(model.paged.bytes() < all.bytes());
}

#[test]
fn pages_of_another_table_and_truncated_pages_are_refused() {
    let [mesh, other] = [5, 6].map(|seed| {
        let refinable = build_sequence(&shapes::terrain(16, seed), &Default::default()).unwrap().refinable;
        Model::new(FragmentedMesh::from_collapses(&refinable), 20)
    });
    let mut paged = mesh.paged.clone();
    assert!(other.pages.iter().filter(|page| paged.load(page).is_ok()).count() < other.pages.len() / 2);
    for page in &mesh.pages {
        for length in 0..page.len() {
            assert!(paged.load(&page[..length]).is_err(), "{length} of {} bytes", page.len());
        }
        let error = paged.load(&[&page[..], &[0]].concat()).unwrap_err();
        assert!(error.to_string().contains("entries"), "{error}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    /// Pages that pass the checks may not fit to others, but nothing fails.
    #[test]
    fn damaged_pages_are_an_error_or_harmless(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
        which in 0usize..24,
        seed in any::<u32>(),
    ) {
        let (_, mesh) = fragment_cases().nth(which).unwrap();
        let mut model = Model::new(mesh, 16);
        for (index, byte) in changes {
            let page = index.index(model.pages.len());
            let at = index.index(model.pages[page].len());
            model.pages[page][at] ^= byte;
        }
        for page in &model.pages {
            let _ = model.paged.load(page);
        }
        let mut instance = model.paged.base_instance();
        model.paged.refine(&mut instance, &ArbitraryCriterion(seed));
        model.paged.triangles(&instance);
        model.paged.unload(0);
        model.paged.settle(&mut instance);
        model.paged.triangles(&instance);
    }
}
