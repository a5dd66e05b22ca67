//! Files built in tasks: the same bytes whoever runs the tasks, and one mesh with levels whatever is read.
#![cfg(feature = "build")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use striata::ignore_progress;
use striata::mesh::{AttributeLayer, IndexedMesh, Random, Semantic, TriangleGroup, replay, shapes};
use striata_io::WriteOptions;
use striata_paged::build::{BuildError, BuildInput, BuildOptions, Plan, run_all, run_task};
use striata_paged::{Assembled, Page, PagedFile, assemble};
use tempfile::TempDir;

fn options() -> BuildOptions {
    BuildOptions { cell: 2000, pieces_per_task: 2, cells_per_task: 3, ..BuildOptions::default() }
}

fn plan(folder: &TempDir, input: BuildInput, options: BuildOptions, name: &str) -> Plan {
    let (output, work) = (folder.path().join(name), folder.path().join(format!("{name}.work")));
    Plan::make((input, options), &output, &work, (2, &mut ignore_progress)).unwrap()
}

fn build(folder: &TempDir, input: BuildInput, options: BuildOptions, threads: usize) -> PathBuf {
    let plan = plan(folder, input, options, &format!("threads-{threads}.striata"));
    run_all(&plan, threads, &mut ignore_progress).unwrap();
    plan.remove_work().unwrap();
    assert!(!plan.folder.exists());
    plan.output
}

fn open(path: &Path) -> PagedFile {
    PagedFile::open(path.to_str().unwrap()).unwrap()
}

fn full(file: &mut PagedFile) -> Assembled {
    let pages = file.select(|_| true).unwrap();
    assert_eq!(pages.len() as u32, file.reader().page_count());
    file.assemble(&pages).unwrap()
}

type Soup = BTreeMap<[[u32; 3]; 3], i32>;

/// Multiset of triangles by the bits of their positions.
fn soup(mesh: &IndexedMesh, round: impl Fn([f32; 3]) -> [f32; 3]) -> Soup {
    let mut soup = Soup::new();
    for t in &mesh.triangles {
        let at = t.map(|v| round(mesh.positions[v as usize]).map(|x| (x + 0.0).to_bits()));
        if at[0] == at[1] || at[1] == at[2] || at[2] == at[0] {
            continue;
        }
        let first = (0..3).min_by_key(|&i| at[i]).unwrap();
        *soup.entry([0, 1, 2].map(|i| at[(first + i) % 3])).or_default() += 1;
    }
    soup
}

/// Every level has the triangles that the sequence announces, and errors that never rise.
fn check_levels(assembled: &Assembled) {
    let refinable = &assembled.refinable;
    refinable.mesh.check().unwrap();
    let sequence = &refinable.sequence;
    let steps = sequence.step_count();
    assert!(assembled.keys.is_sorted_by(|a, b| a >= b));
    for split_count in [0, steps / 10, steps / 3, steps / 2, steps.saturating_sub(1), steps] {
        let level = replay(refinable, split_count);
        assert_eq!(
            level.triangle_count(),
            sequence.triangle_count_at(split_count),
            "{split_count} of {steps}"
        );
    }
}

#[test]
fn terrain_is_the_same_with_any_number_of_threads_and_in_any_order() {
    let folder = TempDir::new().unwrap();
    let input = BuildInput::Terrain(150);
    let bytes =
        [1, 2, 5].map(|threads| std::fs::read(build(&folder, input.clone(), options(), threads)).unwrap());
    assert!(bytes[0] == bytes[1] && bytes[0] == bytes[2]);
    // One task at a time, from the last of each stage to the first, and every third one twice.
    let plan = plan(&folder, input, options(), "tasks.striata");
    for stage in plan.stages() {
        let numbers: Vec<usize> = plan.tasks_of(stage).map(|(number, _)| number).collect();
        for &number in numbers.iter().rev() {
            run_task(&Plan::open(&plan.folder).unwrap(), number).unwrap();
            if number % 3 == 0 {
                run_task(&plan, number).unwrap();
            }
        }
    }
    assert!(std::fs::read(&plan.output).unwrap() == bytes[0]);
}

#[test]
fn tasks_that_are_not_ready_and_unknown_tasks_are_refused() {
    let folder = TempDir::new().unwrap();
    let plan = plan(&folder, BuildInput::Terrain(120), options(), "a.striata");
    let last = plan.tasks.len() - 1;
    assert!(matches!(run_task(&plan, last), Err(BuildError::TaskOrder { needed: 0, .. })));
    assert!(matches!(run_task(&plan, last + 1), Err(BuildError::NoTask { .. })));
    assert!(!plan.output.exists());
}

#[test]
fn an_interrupted_build_goes_on() {
    let folder = TempDir::new().unwrap();
    let whole = std::fs::read(build(&folder, BuildInput::Terrain(150), options(), 1)).unwrap();
    let plan = plan(&folder, BuildInput::Terrain(150), options(), "b.striata");
    for stop_after in [1, 3, 9] {
        let mut count = 0;
        let result = run_all(&plan, 1, &mut |_| {
            count += 1;
            if count == stop_after {
                std::ops::ControlFlow::Break(())
            } else {
                std::ops::ControlFlow::Continue(())
            }
        });
        assert!(matches!(result, Err(BuildError::Cancelled(_))));
        assert!(!plan.output.exists());
    }
    run_all(&Plan::open(&plan.folder).unwrap(), 2, &mut ignore_progress).unwrap();
    assert!(std::fs::read(&plan.output).unwrap() == whole);
}

#[test]
fn a_damaged_part_is_named() {
    let folder = TempDir::new().unwrap();
    let plan = plan(&folder, BuildInput::Terrain(120), options(), "c.striata");
    run_task(&plan, 0).unwrap();
    let part = std::fs::read_dir(&plan.folder).unwrap().flatten().map(|file| file.path());
    let part = part.filter(|path| path.extension().is_some_and(|e| e == "part")).min().unwrap();
    let bytes = std::fs::read(&part).unwrap();
    std::fs::write(&part, &bytes[..bytes.len() - 1]).unwrap();
    let error = run_all(&plan, 1, &mut ignore_progress).unwrap_err();
    assert!(error.to_string().contains(&part.display().to_string()), "{error}");
}

#[test]
fn all_pages_are_the_input() {
    let folder = TempDir::new().unwrap();
    let mut file = open(&build(&folder, BuildInput::Terrain(150), options(), 2));
    let terrain = full(&mut file);
    check_levels(&terrain);
    let metadata = file.metadata();
    assert_eq!(metadata.triangle_count, 2 * 149 * 149);
    assert_eq!(terrain.refinable.mesh.triangle_count() as u64, metadata.triangle_count);
    assert_eq!(metadata.position_count, 150 * 150);
    assert!(terrain.refinable.sequence.triangle_count_at(0) < 100);
}

/// A mesh with split normals, a seam of texture coordinates and two materials.
fn attributed() -> IndexedMesh {
    let mut mesh = shapes::torus(60, 60, 1.0, 0.4);
    let texcoords = (0..mesh.positions.len()).flat_map(|v| [(v % 60) as f32 / 60.0, (v / 60) as f32 / 60.0]);
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords.collect()));
    let order: Vec<u32> = mesh.triangles.as_flattened().to_vec();
    let count = mesh.triangles.len() as u32;
    let normals = (0..count).flat_map(|t| [[0.0, (t / 2 % 5) as f32 * 0.2, 1.0]; 3].concat()).collect();
    let mut soup = IndexedMesh {
        positions: order.iter().map(|&v| mesh.positions[v as usize]).collect(),
        layers: mesh.layers.iter().map(|layer| layer.gather(&order)).collect(),
        triangles: (0..count).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect(),
        ..IndexedMesh::default()
    };
    soup.layers.insert(0, AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    soup.appearance.materials = vec![striata::mesh::Material::default(); 2];
    let half = count / 2;
    soup.groups = [(0, half), (half, count - half)]
        .into_iter()
        .zip(0..)
        .map(|((first, count), m)| TriangleGroup {
            material: Some(m),
            first,
            count,
            name: format!("part {m}"),
        })
        .collect();
    soup
}

#[test]
fn attributes_and_groups_survive() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("torus.glb");
    let mesh = attributed();
    striata_io::write(&path, &mesh, &WriteOptions::default()).unwrap();
    for exact in [false, true] {
        let options = BuildOptions { exact, ..options() };
        let input = BuildInput::Files(vec![path.clone()]);
        let mut file = open(&build(&folder, input, options, 1 + usize::from(exact)));
        let all = full(&mut file);
        check_levels(&all);
        let read = &all.refinable.mesh;
        let grid = file.metadata().grid;
        assert_eq!(soup(read, |p| p), soup(&mesh, |p| grid.map_or(p, |grid| grid.snap(p))));
        assert_eq!(read.layers.len(), 2);
        assert_eq!(read.groups.iter().map(|g| g.count).sum::<u32>(), read.triangles.len() as u32);
        assert_eq!(read.groups.iter().map(|g| g.material).collect::<Vec<_>>(), [Some(0), Some(1)]);
    }
}

#[test]
fn pages_are_encoded_the_same_again() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("torus.glb");
    striata_io::write(&path, &attributed(), &WriteOptions::default()).unwrap();
    for input in [BuildInput::Terrain(150), BuildInput::Files(vec![path])] {
        let mut file = open(&build(&folder, input, options(), 1));
        full(&mut file);
        let metadata = file.metadata();
        for (_, page) in file.reader().pages() {
            let bytes = page.to_bytes(metadata);
            assert!(Page::from_bytes(page.id, &bytes, metadata).unwrap() == *page);
            let mut again = page.clone();
            again.normalize();
            assert!(again == *page, "a page in order stays as it is");
        }
    }
}

#[test]
fn withheld_pages_leave_a_coarser_mesh_without_cracks() {
    let folder = TempDir::new().unwrap();
    let mut file = open(&build(&folder, BuildInput::Terrain(200), options(), 2));
    let all = full(&mut file);
    let outline = borders(&replay(&all.refinable, all.refinable.sequence.step_count()));
    let mut random = Random::new(5);
    for _ in 0..10 {
        let count = file.reader().page_count();
        let mut is_there = vec![true; count as usize];
        for page in 1..count {
            let parents = &file.reader().entry(page).unwrap().parents;
            is_there[page as usize] =
                random.below(10) < 8 && parents.iter().all(|&parent| is_there[parent as usize]);
        }
        let pages: Vec<(u32, &Page)> =
            file.reader().pages().filter(|&(index, _)| is_there[index as usize]).collect();
        let part = assemble(&pages, file.metadata()).unwrap();
        check_levels(&part);
        let finest = &part.refinable.mesh;
        // Inside, every edge has two triangles: there is no crack. The outline only becomes coarser.
        assert!(borders(finest) <= outline);
    }
    let (absent, _) = (1..file.reader().page_count())
        .map(|page| (page, file.reader().entry(page).unwrap().parents.len()))
        .max_by_key(|&(_, parents)| parents)
        .unwrap();
    let parent = file.reader().entry(absent).unwrap().parents[0];
    let pages: Vec<(u32, &Page)> = file.reader().pages().filter(|&(index, _)| index != parent).collect();
    assert!(assemble(&pages, file.metadata()).is_err());
}

/// Number of edges with one triangle.
fn borders(mesh: &IndexedMesh) -> usize {
    let mut edges: BTreeMap<[[u32; 3]; 2], i32> = BTreeMap::new();
    for t in &mesh.triangles {
        let at = t.map(|v| mesh.positions[v as usize].map(f32::to_bits));
        for i in 0..3 {
            let (a, b) = (at[i], at[(i + 1) % 3]);
            *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    edges.values().filter(|&&count| count == 1).count()
}

#[test]
fn levels_read_only_what_they_need() {
    let folder = TempDir::new().unwrap();
    let path = build(&folder, BuildInput::Terrain(300), options(), 2);
    let mut whole = open(&path);
    let all = full(&mut whole);
    let total = whole.statistics();
    for triangle_count in [500, 3000] {
        let mut file = open(&path);
        let part = file.level_for_triangles(triangle_count).unwrap();
        assert!(file.statistics().byte_count < total.byte_count / 2);
        let level = |assembled: &Assembled| {
            let split_count = assembled.refinable.sequence.split_count_for_triangles(triangle_count);
            soup(&replay(&assembled.refinable, split_count), |p| p)
        };
        assert_eq!(level(&part), level(&all));
    }
    let mut file = open(&path);
    let pages = file.select(|bound| bound.min[0] < 20.0 && bound.min[1] < 20.0).unwrap();
    assert!(pages.len() < file.reader().page_count() as usize / 2);
    check_levels(&file.assemble(&pages).unwrap());
}

#[test]
fn folders_have_one_object_per_page() {
    let folder = TempDir::new().unwrap();
    let one = build(&folder, BuildInput::Terrain(120), options(), 1);
    let plan = plan(&folder, BuildInput::Terrain(120), options(), "folder");
    run_all(&plan, 1, &mut ignore_progress).unwrap();
    assert!(plan.output.join("head.striata").is_file());
    let (mut one, mut many) = (open(&one), open(&plan.output));
    assert_eq!(full(&mut one).refinable, full(&mut many).refinable);
}

#[test]
fn damaged_pages_are_named_or_read() {
    let folder = TempDir::new().unwrap();
    let mut file = open(&build(&folder, BuildInput::Terrain(60), options(), 1));
    full(&mut file);
    let metadata = file.metadata();
    let mut random = Random::new(3);
    for (_, page) in file.reader().pages() {
        let bytes = page.to_bytes(metadata);
        for _ in 0..200 {
            let mut damaged = bytes.clone();
            let at = random.below(bytes.len() as u32) as usize;
            damaged[at] ^= 1 << random.below(8);
            damaged.truncate(if random.below(2) == 0 { bytes.len() } else { at + 1 });
            if let Ok(read) = Page::from_bytes(page.id, &damaged, metadata) {
                read.check(metadata).unwrap();
            }
        }
    }
}
