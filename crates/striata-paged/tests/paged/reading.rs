//! One mesh with levels, whatever is read.

use striata::Target;
use striata::ignore_progress;
use striata::levels::Levels as _;
use striata::mesh::{AttributeLayer, Image, IndexedMesh, LayerData, Random, Semantic, replay};
use striata::view::DetailBox;
use striata_io::WriteOptions;
use striata_paged::build::{BuildInput, BuildOptions, run_all};
use striata_paged::{
    Assembled, CutPages, Metadata, Page, PageId, PagedError, PagedFile, SuppliedStore, assemble,
};
use tempfile::TempDir;

use crate::workshop::{attributed, borders, build, check_levels, full, open, options, plan, soup};

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

/// Nineteen vertices, but no position that they could have, and 32 triangles without vertices.
#[test]
fn pages_whose_counts_contradict_each_other_are_refused() {
    let metadata = Metadata { cell_counts: vec![4, 1], ..Metadata::default() };
    let no_positions: &[u8] = &[0, 19, 0, 0, 0, 0, 35, 0, 131, 0, 0, 10, 41];
    let no_vertices: &[u8] = b"\0\0\0 \0`cci*cccc\0.";
    for bytes in [no_positions, no_vertices] {
        let error = Page::from_bytes(PageId { level: 0, cell: 0 }, bytes, &metadata).err().unwrap();
        assert!(error.to_string().contains("contradict each other"), "{error}");
    }
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

#[test]
fn levels_stay_coarse_where_a_page_is_damaged() {
    let folder = TempDir::new().unwrap();
    let path = build(&folder, BuildInput::Terrain(200), options(), 2);
    let everywhere = DetailBox { min: [f32::MAX; 3], max: [f32::MAX; 3], error_outside: -1.0 };
    let mut whole = open(&path);
    let finest = whole.level_for(&everywhere).unwrap().mesh;
    // A page that others refine, in the middle of the file.
    let is_parent = |page: u32| whole.reader().entries().any(|(_, entry)| entry.parents.contains(&page));
    let damaged = (1..whole.reader().page_count()).rfind(|&page| is_parent(page)).unwrap();
    let entry = whole.reader().entry(damaged).unwrap();
    let mut bytes = std::fs::read(&path).unwrap();
    let pages: u64 = whole.reader().entries().map(|(_, entry)| u64::from(entry.byte_count)).sum();
    let first = bytes.len() - pages as usize + entry.offset as usize;
    bytes[first + entry.byte_count as usize / 2] ^= 0x55;
    std::fs::write(&path, bytes).unwrap();
    let mut file = open(&path);
    let error = file.level_for(&everywhere).unwrap_err();
    assert_eq!(error.page(), Some(entry.id), "{error}");
    assert!(file.withhold(entry.id) && !file.withhold(entry.id));
    let level = file.level_for(&everywhere).unwrap();
    assert!(level.mesh.triangle_count() < finest.triangle_count());
    assert!(level.mesh.triangle_count() > finest.triangle_count() / 4);
    assert!(level.error >= entry.error);
    assert!(borders(&level.mesh) <= borders(&finest), "a crack");
    let base = file.reader().entry(0).unwrap().id;
    assert!(!file.withhold(base), "no level can do without the base");
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

/// A torus whose triangles have numbers and doubles that follow from them, and whose vertices have doubles.
fn numbered() -> IndexedMesh {
    let mut mesh = attributed();
    let generic = |name: &str, data| AttributeLayer {
        semantic: Semantic::Generic(name.to_owned()),
        component_count: 1,
        normalized: false,
        data,
    };
    let ids = 0..mesh.triangle_count() as u32;
    let doubles = ids.clone().map(|id| f64::from(id) / 3.0).collect();
    let labels = ids.clone().map(|id| id as i16 - 3000).collect();
    mesh.triangle_layers = vec![
        generic("id", LayerData::U32(ids.collect())),
        generic("share", LayerData::F64(doubles)),
        generic("label", LayerData::I16(labels)),
    ];
    let heights = mesh.positions.iter().map(|p| f64::from(p[2]) * 0.1 + 1e-9).collect();
    mesh.layers.push(generic("height", LayerData::F64(heights)));
    mesh
}

fn data_of(mesh: &IndexedMesh) -> Vec<(u32, f64, i16)> {
    let [LayerData::U32(ids), LayerData::F64(shares), LayerData::I16(labels)] =
        [0, 1, 2].map(|i| mesh.triangle_layers[i].data.clone())
    else {
        panic!("types are kept")
    };
    ids.into_iter().zip(shares).zip(labels).map(|((id, share), label)| (id, share, label)).collect()
}

#[test]
fn data_of_triangles_and_doubles_survive() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("torus.ply");
    let mut mesh = numbered();
    // PLY has no groups.
    mesh.groups.clear();
    mesh.appearance = Default::default();
    striata_io::write(&path, &mesh, &WriteOptions::default()).unwrap();
    for tasks in [1, 3] {
        let options = BuildOptions { exact: true, ..options() };
        let mut file = open(&build(&folder, BuildInput::Files(vec![path.clone()]), options, tasks));
        let all = full(&mut file);
        check_levels(&all);
        let read = &all.refinable.mesh;
        let data = data_of(read);
        let mut ids: Vec<u32> = data.iter().map(|row| row.0).collect();
        ids.sort_unstable();
        assert_eq!(ids, (0..mesh.triangle_count() as u32).collect::<Vec<_>>());
        let corners = |mesh: &IndexedMesh, t: usize| {
            let mut corners =
                mesh.triangles[t].map(|v| mesh.positions[v as usize].map(|x| (x + 0.0).to_bits()));
            corners.sort_unstable();
            corners
        };
        for (t, &(id, share, label)) in data.iter().enumerate() {
            assert_eq!((share, label), (f64::from(id) / 3.0, id as i16 - 3000));
            assert_eq!(corners(read, t), corners(&mesh, id as usize));
        }
        let height = |mesh: &IndexedMesh| {
            let layer = mesh.layers.iter().find(|layer| layer.semantic.to_string() == "generic_height");
            let LayerData::F64(values) = &layer.unwrap().data else { panic!("doubles stay doubles") };
            let mut all: Vec<u64> = values.iter().map(|x| x.to_bits()).collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        assert_eq!(height(read), height(&mesh));
        // Triangles of a level keep the data of one triangle each.
        let pages: Vec<(u32, &Page)> = file.reader().pages().collect();
        for limit in [0.0, 0.01, 0.1, f32::INFINITY] {
            let cut = CutPages::new(&pages, file.metadata()).unwrap().cut(|part| part.error > limit);
            cut.mesh.check().unwrap();
            let mut data = data_of(&cut.mesh);
            assert!(
                data.iter()
                    .all(|&(id, share, label)| (share, label) == (f64::from(id) / 3.0, id as i16 - 3000))
            );
            data.sort_by_key(|row| row.0);
            data.dedup_by_key(|row| row.0);
            assert_eq!(data.len(), cut.mesh.triangle_count(), "{limit}");
        }
    }
}

#[test]
fn a_paged_file_is_a_source_of_levels() {
    let folder = TempDir::new().unwrap();
    let mut file = open(&build(&folder, BuildInput::Terrain(60), options(), 1));
    let all = full(&mut file).refinable;
    striata_testing::levels::check_levels(&mut file, &|split_count| replay(&all, split_count));
    striata_testing::levels::check_views(&mut file);
    let metadata = file.metadata().clone();
    let middle = [0, 1, 2].map(|axis| f32::midpoint(metadata.min[axis], metadata.max[axis]));
    let corner = DetailBox { min: metadata.min, max: middle, error_outside: f32::INFINITY };
    let coarse = file.find_for_box(&corner, None).unwrap().unwrap();
    let limit = usize::midpoint(coarse.triangle_count, metadata.triangle_count as usize);
    let within = file.find_for_box(&corner, Some(limit)).unwrap().unwrap();
    assert!(coarse.triangle_count < within.triangle_count && within.triangle_count <= limit);
}

#[test]
fn a_level_reads_the_pages_that_it_needs() {
    let folder = TempDir::new().unwrap();
    let path = build(&folder, BuildInput::Terrain(150), options(), 1);
    let mut file = open(&path);
    let coarse = file.find(Target::Triangles(500)).unwrap();
    let read = file.statistics().page_count;
    assert!(read < u64::from(file.reader().page_count()));
    // A finer level is not made of the pages of the coarse one.
    let finer = file.find(Target::Triangles(5000)).unwrap();
    assert!(finer.triangle_count > 4500 && file.statistics().page_count > read);
    assert_eq!(open(&path).find(Target::Triangles(500)).unwrap().shape, coarse.shape);
}

/// Repeats an action until a store has all bytes that it needs, which come from a file.
fn with_bytes<T>(store: &SuppliedStore, file: &[u8], mut act: impl FnMut() -> Result<T, PagedError>) -> T {
    for _ in 0..1000 {
        match act() {
            Ok(found) => return found,
            Err(error) => {
                let wants = store.take_wants();
                assert!(!wants.is_empty(), "{error}");
                for want in wants {
                    let [from, to] =
                        [want.range.start, want.range.end].map(|at| (at as usize).min(file.len()));
                    store.supply(want, file[from..to].to_vec());
                }
            }
        }
    }
    panic!("a level needs more and more bytes");
}

#[test]
fn a_coarse_level_does_not_wait_for_the_pages_of_a_finer_one() {
    let folder = TempDir::new().unwrap();
    let path = build(&folder, BuildInput::Terrain(200), options(), 2);
    let bytes = std::fs::read(&path).unwrap();
    let store = SuppliedStore::new("terrain");
    let mut file = with_bytes(&store, &bytes, || PagedFile::with_store(Box::new(store.clone())));
    store.clear();
    let byte_count = |store: &SuppliedStore| {
        store.take_wants().iter().map(|want| want.range.end - want.range.start).sum::<u64>()
    };
    let level = |error_outside| DetailBox { min: [f32::MAX; 3], max: [f32::MAX; 3], error_outside };
    assert!(file.level_for(&level(0.0)).is_err());
    let all = byte_count(&store);
    let error = file.metadata().diagonal() as f32 / 100.0;
    assert!(file.level_for(&level(error)).is_err());
    let some = byte_count(&store);
    assert!(some > 0 && some < all / 2, "{some} of {all} bytes");
}

#[test]
fn levels_do_not_depend_on_who_fetches_the_bytes() {
    let folder = TempDir::new().unwrap();
    let path = build(&folder, BuildInput::Terrain(150), options(), 1);
    let bytes = std::fs::read(&path).unwrap();
    let store = SuppliedStore::new("supplied");
    let mut supplied = with_bytes(&store, &bytes, || PagedFile::with_store(Box::new(store.clone())));
    // The cache is so small that pages are read again and again.
    supplied = supplied.with_max_vertices(5_000);
    let metadata = supplied.metadata().clone();
    let middle = [0, 1, 2].map(|axis| f32::midpoint(metadata.min[axis], metadata.max[axis]));
    for share in [0.5, 0.1, 0.02, 0.005] {
        store.clear();
        let error = share * metadata.diagonal() as f32 / 10.0;
        let detail = DetailBox { min: metadata.min, max: middle, error_outside: error };
        let found = with_bytes(&store, &bytes, || supplied.level_for(&detail));
        assert_eq!(found.mesh, open(&path).level_for(&detail).unwrap().mesh);
    }
}

#[test]
fn images_are_kept_with_the_file() {
    let folder = TempDir::new().unwrap();
    let mut mesh = attributed();
    let picture = |name: &str, bytes: &[u8]| Image {
        name: name.to_owned(),
        mime_type: "image/png".to_owned(),
        bytes: bytes.to_vec(),
        ..Image::default()
    };
    mesh.appearance.images = vec![picture("bark", b"\x89PNG wood"), picture("leaf", b"\x89PNG green")];
    mesh.appearance.textures_json = vec![r#"{"source":0}"#.to_owned(), r#"{"source":1}"#.to_owned()];
    for (texture, material) in mesh.appearance.materials.iter_mut().enumerate() {
        material.gltf_json =
            format!(r#"{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":{texture}}}}}}}"#);
    }
    let path = folder.path().join("tree.glb");
    striata_io::write(&path, &mesh, &WriteOptions::default()).unwrap();
    let input = || BuildInput::Files(vec![path.clone()]);
    let file = build(&folder, input(), options(), 1);
    let many = plan(&folder, input(), options(), "folder");
    run_all(&many, 1, &mut ignore_progress).unwrap();
    many.remove_work().unwrap();
    std::fs::remove_file(&path).unwrap();
    for path in [&file, &many.output] {
        let mut opened = open(path);
        opened.load_images().unwrap();
        let level = opened.find(Target::Triangles(500)).unwrap().shape;
        let view = opened.find_for_box(&DetailBox { min: [0.0; 3], max: [1.0; 3], error_outside: 1.0 }, None);
        for read in [level, view.unwrap().unwrap().shape] {
            assert_eq!(read.appearance.images, mesh.appearance.images);
            assert_eq!(read.appearance.textures_json.len(), 2);
        }
    }
    let mut bytes = std::fs::read(&file).unwrap();
    *bytes.last_mut().unwrap() ^= 1;
    std::fs::write(&file, &bytes).unwrap();
    let error = open(&file).load_images().unwrap_err();
    assert_eq!(error.to_string(), "image 1: the checksum does not match");
}
