//! Levels whose detail varies: cut from pages, they equal a cut through the assembled mesh, and have no cracks.

use striata::mesh::Random;
use striata::view::{Camera, Criterion, DetailBox, ScreenError};
use striata_paged::build::BuildInput;
use striata_paged::{CutPages, Page, PagedFile, assemble, leaving};
use tempfile::TempDir;

use crate::reference_cut::{reference_cut, soup_of};
use crate::workshop::{attributed, borders, build, full, open, options};

/// A terrain without attributes, and a mesh with wedges, groups and seams.
fn files(folder: &TempDir) -> [PagedFile; 2] {
    let path = folder.path().join("torus.glb");
    striata_io::write(&path, &attributed(), &striata_io::WriteOptions::default()).unwrap();
    [(BuildInput::Terrain(200), 1), (BuildInput::Files(vec![path]), 2)]
        .map(|(input, threads)| open(&build(folder, input, options(), threads)))
}

/// Checks a cut of pages against the reference, for one criterion.
fn check(pages: &[(u32, &Page)], file: &PagedFile, criterion: &(impl Criterion + Sync)) -> usize {
    let is_wanted = |part: &striata::view::Part| criterion.weigh(part).should_refine();
    let cut = CutPages::new(pages, file.metadata()).unwrap().cut(is_wanted);
    let expected = reference_cut(&assemble(pages, file.metadata()).unwrap(), is_wanted);
    cut.mesh.check().unwrap();
    assert_eq!((cut.refined_count, cut.error), (expected.refined_count, expected.error));
    assert!(soup_of(&cut.mesh) == expected.soup, "the triangles differ");
    assert_eq!(cut.page_of_vertex.len(), cut.mesh.vertex_count());
    cut.mesh.triangle_count()
}

#[test]
fn cuts_equal_those_of_the_assembled_mesh() {
    let folder = TempDir::new().unwrap();
    for mut file in files(&folder) {
        full(&mut file);
        let (min, max) = (file.metadata().min, file.metadata().max);
        let at = |random: &mut Random, axis: usize| {
            min[axis] + (max[axis] - min[axis]) * (random.below(1201) as f32 / 1000.0 - 0.1)
        };
        let diagonal = file.metadata().diagonal() as f32;
        let mut random = Random::new(7);
        let pages: Vec<(u32, &Page)> = file.reader().pages().collect();
        let mut counts = std::collections::BTreeSet::new();
        for round in 0..12 {
            let center = [0, 1, 2].map(|axis| at(&mut random, axis));
            let size = diagonal * 0.5f32.powi(1 + random.below(5) as i32);
            let (min, max) = (center.map(|x| x - size), center.map(|x| x + size));
            let error_outside = diagonal * 0.1f32.powi(1 + round % 5);
            counts.insert(check(&pages, &file, &DetailBox { min, max, error_outside }));
            let eye = [0, 1, 2].map(|axis| at(&mut random, axis) + diagonal * (random.below(3) as f32 - 1.0));
            if let Ok(camera) = Camera::new(eye, center, [0.1, 0.2, 1.0], 0.5, [640, 480]) {
                let pixels = 0.25 * 4f32.powi(random.below(4) as i32);
                counts.insert(check(&pages, &file, &ScreenError::new(camera, pixels)));
            }
        }
        assert!(counts.len() > 8, "the criteria differ: {counts:?}");
        // All, and nothing.
        let everything = DetailBox { min: [f32::MIN; 3], max: [f32::MAX; 3], error_outside: 0.0 };
        let count = check(&pages, &file, &everything);
        assert!(count as u64 * 100 >= file.metadata().triangle_count * 99);
        let nothing = DetailBox { min: [f32::MAX; 3], max: [f32::MAX; 3], error_outside: f32::INFINITY };
        assert!(check(&pages, &file, &nothing) < 400);
    }
}

#[test]
fn withheld_pages_leave_valid_cuts() {
    let folder = TempDir::new().unwrap();
    let [mut file, _] = files(&folder);
    let outline = borders(&full(&mut file).refinable.mesh);
    let mut random = Random::new(3);
    for _ in 0..8 {
        let count = file.reader().page_count();
        let mut is_there = vec![true; count as usize];
        for page in 1..count {
            let parents = &file.reader().entry(page).unwrap().parents;
            is_there[page as usize] =
                random.below(10) < 7 && parents.iter().all(|&parent| is_there[parent as usize]);
        }
        let pages: Vec<(u32, &Page)> =
            file.reader().pages().filter(|&(index, _)| is_there[index as usize]).collect();
        let corner = [random.below(150) as f32, random.below(150) as f32, -1e6];
        let max = [corner[0] + 60.0, corner[1] + 60.0, 1e6];
        let criterion = DetailBox { min: corner, max, error_outside: 2.0 };
        check(&pages, &file, &criterion);
        let is_wanted = |part: &striata::view::Part| criterion.weigh(part).should_refine();
        let cut = CutPages::new(&pages, file.metadata()).unwrap().cut(is_wanted);
        assert!(borders(&cut.mesh) <= outline, "a crack");
    }
    // A page without one of its parents is refused.
    let (absent, _) = (1..file.reader().page_count())
        .map(|page| (page, file.reader().entry(page).unwrap().parents.len()))
        .max_by_key(|&(_, parents)| parents)
        .unwrap();
    let parent = file.reader().entry(absent).unwrap().parents[0];
    let pages: Vec<(u32, &Page)> = file.reader().pages().filter(|&(index, _)| index != parent).collect();
    assert!(CutPages::new(&pages, file.metadata()).is_err());
}

#[test]
fn views_read_what_they_show_and_respect_limits() {
    let folder = TempDir::new().unwrap();
    let path = build(&folder, BuildInput::Terrain(300), options(), 2);
    let camera = Camera::new([150.0, 150.0, 90.0], [180.0, 150.0, 0.0], [0.0, 0.0, 1.0], 0.5, [640, 480]);
    let criterion = ScreenError::new(camera.unwrap(), 1.0);
    let mut file = open(&path);
    let view = file.level_for_view(&criterion, None).unwrap();
    assert_eq!(view.relaxation, 1.0);
    let all = file.reader().page_count() as u64;
    assert!(file.statistics().page_count < all, "some pages are not needed");
    // Pages that were not read have errors, too.
    let unread = (0..file.reader().page_count()).filter(|&page| file.reader().page(page).is_none());
    let error = unread.map(|page| file.reader().entry(page).unwrap().error).fold(0.0, f32::max);
    assert!(view.cut.error >= error);
    let count = view.cut.mesh.triangle_count();
    for limit in [count * 2, count / 3, count / 20] {
        let mut file = open(&path);
        let limited = file.level_for_view(&criterion, Some(limit)).unwrap();
        let found = limited.cut.mesh.triangle_count();
        assert!(limited.is_within_limit && found <= limit, "{found} of {limit}");
        assert!(found * 10 >= limit.min(count) * 9, "{found} of {limit}");
        assert_eq!(limited.relaxation == 1.0, limit >= count);
    }
    let tiny = open(&path).level_for_view(&criterion, Some(1)).unwrap();
    assert!(!tiny.is_within_limit);
}

#[test]
fn passing_levels_of_a_view_from_within_need_few_pages_at_first() {
    let folder = TempDir::new().unwrap();
    let path = build(&folder, BuildInput::Terrain(400), options(), 2);
    let pages_read = |leaves_errors: bool| {
        let mut file = open(&path);
        let (min, max) = (file.metadata().min, file.metadata().max);
        let at = |shares: [f32; 3]| [0, 1, 2].map(|a| min[a] + shares[a] * (max[a] - min[a]));
        let (eye, target) = (at([0.5, 0.5, 1.0]), at([0.6, 0.5, 0.5]));
        let camera = Camera::new(eye, target, [0.0, 0.0, 1.0], 0.4, [1920, 1080]);
        let criterion = ScreenError::new(camera.unwrap(), 1.0);
        let counts = [64.0, 16.0, 4.0, 2.0, 1.0].map(|factor| {
            let left = if leaves_errors { file.reader().passing_error(factor) } else { 0.0 };
            let level = file.level_for(&leaving(criterion.clone().relaxed(factor), left)).unwrap();
            (file.statistics().page_count, level.mesh.triangle_count())
        });
        let whole = file.level_for(&criterion).unwrap();
        assert_eq!(counts[4].1, whole.mesh.triangle_count(), "the last level leaves no errors");
        counts
    };
    let (passing, relaxed) = (pages_read(true), pages_read(false));
    assert!(passing.is_sorted() && passing[4] == relaxed[4] && passing[4].0 > 20, "{passing:?}");
    let is_half = |at: usize| 2 * passing[at].0 <= relaxed[at].0;
    assert!(is_half(0) && is_half(1), "{passing:?} and {relaxed:?}");
}
