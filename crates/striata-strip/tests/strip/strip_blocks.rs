//! Strips made block by block: they cover the mesh at nearly the cost of strips for the whole mesh, in
//! bounded memory.

use striata_testing::{meshes, support};

use std::convert::Infallible;

use proptest::prelude::*;
use striata::mesh::{IndexedMesh, canonical_triangles, shapes};
use striata::strip::{RESTART, StripSet};
use striata_strip::{
    Block, BlockOptions, BlockSource, BlockTriangle, BlocksError, BlocksReport, MeshBlocks, StripOptions,
    Stripifier, stripify, stripify_blocks, stripify_blocks_with_progress,
};
use support::{Random, soup, with_seams_and_groups};

/// Collects the strips of a source as a set, group by group.
fn strips_of<S: BlockSource>(
    source: &mut S,
    group_count: usize,
    options: &BlockOptions,
) -> Result<(StripSet, BlocksReport), BlocksError<S::Error, Infallible>> {
    let (mut set, mut open) = (StripSet::new(), 0);
    let report = stripify_blocks(source, options, &mut |group, strip| {
        assert!(group >= open, "group {group} comes after {open}");
        while open < group {
            set.end_group();
            open += 1;
        }
        set.push(strip);
        Ok(())
    })?;
    (set.group_count()..group_count).for_each(|_| set.end_group());
    Ok((set, report))
}

/// Checks that strips made in blocks cover the mesh, and that the report states their cost.
fn check(name: &str, mesh: &IndexedMesh, block_triangles: usize, options: &BlockOptions) -> BlocksReport {
    let mut source = MeshBlocks::new(mesh, block_triangles).unwrap();
    let groups = mesh.groups_or_whole();
    let (set, report) = strips_of(&mut source, groups.len(), options).unwrap();
    for (group, of_mesh) in groups.iter().enumerate() {
        let mut found = Vec::new();
        set.group_strips(group).for_each(|s| found.extend(striata::strip::strip_triangles(set.strip(s))));
        let is_proper = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        let mut expected = mesh.triangles[of_mesh.range()].to_vec();
        expected.retain(is_proper);
        assert_eq!(
            canonical_triangles(&found),
            canonical_triangles(&expected),
            "{name}, group {group}, blocks of {block_triangles}"
        );
    }
    assert_eq!(report.cost, set.cost(), "{name}, blocks of {block_triangles}");
    assert_eq!(report.block_count, source.block_count());
    assert!(report.peak_block_triangles <= block_triangles.max(1));
    report
}

#[test]
fn every_triangle_is_in_exactly_one_strip() {
    let options = BlockOptions::default();
    for (name, mesh) in meshes::nasty() {
        if mesh.check().is_err() {
            assert!(MeshBlocks::new(&mesh, 10).is_err(), "{name}");
            continue;
        }
        for block_triangles in [0, 1, 2, 7, 50, usize::MAX] {
            check(name, &mesh, block_triangles, &options);
        }
    }
}

#[test]
fn any_stripifier_works_in_blocks() {
    for name in Stripifier::SPELLINGS.split(", ") {
        let spelling =
            name.replace("[:MAX]", ":5").replace("[:global][:few-swaps|:no-swaps]", ":global:few-swaps");
        let stripifier = spelling.parse().unwrap();
        let strip = StripOptions::default().with_stripifier(stripifier).with_effort(0.2);
        let options = BlockOptions::default().with_strip(strip);
        for (name, mesh) in meshes::nasty().into_iter().filter(|(_, mesh)| mesh.check().is_ok()) {
            check(name, &mesh, 20, &options);
        }
        let mesh = with_seams_and_groups(shapes::terrain(40, 8));
        check("terrain with seams", &mesh, 90, &options);
        let report = check("terrain", &shapes::terrain(40, 8), 300, &options);
        assert!(report.carried_count > 0, "{stripifier}: {report:?}");
    }
}

/// A grid with random diagonals in which some triangles are duplicated, some flipped and some missing.
fn damaged_grid(seed: u64, percent: u32) -> IndexedMesh {
    let mut random = striata::mesh::Random::new(seed);
    let (columns, rows) = (8 + random.below(40), 8 + random.below(30));
    let at = |x: u32, y: u32| y * (columns + 1) + x;
    let mut triangles = Vec::new();
    for (y, x) in (0..rows).flat_map(|y| (0..columns).map(move |x| (y, x))) {
        let (a, b, c, d) = (at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
        let either = [[[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]];
        for mut corners in either[usize::from(random.below(3) > 0)] {
            let mut happens = || random.below(100) < percent;
            if happens() {
                triangles.push(corners);
            }
            if happens() {
                corners.swap(0, 1);
            }
            if !happens() {
                triangles.push(corners);
            }
        }
    }
    let vertex = |i: u32| [(i % (columns + 1)) as f32, (i / (columns + 1)) as f32, (i * i % 7) as f32];
    IndexedMesh::new((0..(columns + 1) * (rows + 1)).map(vertex).collect(), triangles)
}

#[test]
fn inconsistent_windings_are_kept_by_every_stripifier() {
    for seed in 30..40 {
        for percent in [3, 30] {
            let mesh = damaged_grid(seed, percent);
            for spec in ["greedy", "stripe", "tunnel:9", "fewest", "cheapest"] {
                let strip = StripOptions::default().with_stripifier(spec.parse().unwrap()).with_effort(0.1);
                let options = BlockOptions::default().with_strip(strip);
                for size in [100, 250] {
                    check(&format!("{spec}, seed {seed}"), &mesh, size, &options);
                }
            }
        }
    }
}

#[test]
fn groups_and_seams_are_borders_of_strips() {
    let mesh = with_seams_and_groups(shapes::torus(12, 17, 3.0, 1.0));
    for block_triangles in [1, 10, 100, 1000] {
        check("torus", &mesh, block_triangles, &BlockOptions::default());
    }
}

#[test]
fn blocks_need_few_more_indices_than_the_whole_mesh() {
    let scan =
        striata_io::read(concat!(env!("CARGO_MANIFEST_DIR"), "/../striata-cli/assets/nefertiti.ply.zst"))
            .unwrap();
    for (name, mesh, block_triangles) in [
        ("terrain", shapes::terrain(180, 3), 6000),
        ("sphere", shapes::uv_sphere(150, 200, 1.0), 12_000),
        ("nefertiti", scan, 10_000),
    ] {
        let whole = stripify(&mesh, &StripOptions::default()).unwrap().cost().index_count;
        let report = check(name, &mesh, block_triangles, &BlockOptions::default());
        let ratio = report.cost.index_count as f64 / whole as f64;
        assert!(report.block_count >= 6, "{name}: {} blocks", report.block_count);
        assert!(ratio <= 1.03, "{name}: {ratio} times the indices of the whole");
    }
}

#[test]
fn one_block_gives_the_strips_of_the_whole_mesh() {
    let mesh = shapes::terrain(60, 5);
    let report = check("terrain", &mesh, usize::MAX, &BlockOptions::default());
    assert_eq!((report.block_count, report.carried_count, report.peak_held_triangles), (1, 0, 0));
}

#[test]
fn waiting_strips_cross_borders_and_obey_their_limit() {
    let mesh = shapes::terrain(120, 7);
    let free = check("terrain", &mesh, 500, &BlockOptions::default());
    assert!(free.carried_count > 0 && free.peak_held_triangles > 1000, "{free:?}");
    assert!(free.peak_window_triangles > free.peak_block_triangles, "{free:?}");
    let none = check("terrain", &mesh, 500, &BlockOptions::default().with_held_limit(0));
    assert_eq!((none.carried_count, none.peak_held_triangles), (0, 0));
    assert_eq!(none.peak_window_triangles, none.peak_block_triangles);
    assert!(free.cost.index_count < none.cost.index_count, "{free:?} against {none:?}");
    let few = check("terrain", &mesh, 500, &BlockOptions::default().with_held_limit(600));
    assert!((1..=600).contains(&few.peak_held_triangles), "{few:?}");
}

#[test]
fn memory_grows_with_the_border_and_not_with_the_mesh() {
    let reports =
        [140, 280, 560].map(|n| check("terrain", &shapes::terrain(n, 2), 2000, &BlockOptions::default()));
    for pair in reports.windows(2) {
        // With four times the triangles, the border doubles; blocks and windows keep their size.
        assert!(pair[1].peak_held_triangles < 3 * pair[0].peak_held_triangles, "{reports:?}");
    }
    assert!(reports.iter().all(|report| report.peak_window_triangles < 4 * 2000), "{reports:?}");
}

#[test]
fn the_same_blocks_give_the_same_strips() {
    let mesh = shapes::terrain(50, 9);
    let run = || strips_of(&mut MeshBlocks::new(&mesh, 300).unwrap(), 1, &BlockOptions::default()).unwrap();
    assert_eq!(run(), run());
}

/// Blocks given as a list.
struct BlockList(Vec<Block>);

impl BlockSource for BlockList {
    type Error = String;

    fn block_count(&self) -> u32 {
        self.0.len() as u32
    }

    fn read_block(&mut self, number: u32, block: &mut Block) -> Result<(), String> {
        let found = self.0[number as usize].clone();
        if found.triangles.is_empty() {
            return Err("nothing there".to_owned());
        }
        *block = found;
        Ok(())
    }
}

fn block(group: u32, triangles: &[([u32; 3], [u32; 3])]) -> Block {
    let triangles =
        triangles.iter().map(|&(corners, last_blocks)| BlockTriangle { corners, last_blocks }).collect();
    Block { triangles, group }
}

#[test]
fn a_strip_continues_across_a_border() {
    let blocks = vec![
        block(0, &[([0, 1, 2], [0, 1, 1]), ([7, 8, 9], [0, 0, 0])]),
        block(0, &[([2, 1, 3], [1, 1, 2])]),
        block(0, &[([3, 4, 5], [2, 2, 2])]),
    ];
    let (set, report) = strips_of(&mut BlockList(blocks), 1, &BlockOptions::default()).unwrap();
    assert_eq!(set.strips().map(<[u32]>::len).collect::<Vec<_>>(), vec![3, 4, 3]);
    assert_eq!((report.carried_count, report.peak_held_triangles), (1, 1));
}

#[test]
fn wrong_last_uses_of_vertices_lose_no_triangle() {
    let at_border =
        |last: u32| vec![block(0, &[([0, 1, 2], [last; 3])]), block(0, &[([2, 1, 3], [last; 3])])];
    for (last, strip_count) in [(0, 2), (1, 1), (u32::MAX, 1)] {
        let (set, report) = strips_of(&mut BlockList(at_border(last)), 1, &BlockOptions::default()).unwrap();
        assert_eq!((set.strip_count(), report.cost.triangle_count), (strip_count, 2), "last {last}");
    }
}

#[test]
fn invalid_blocks_are_reported_with_their_index() {
    let plain = ([0, 1, 2], [0; 3]);
    let message = |blocks: Vec<Block>| {
        strips_of(&mut BlockList(blocks), 2, &BlockOptions::default()).unwrap_err().to_string()
    };
    assert_eq!(message(vec![block(0, &[plain]), block(0, &[])]), "block 1: nothing there");
    let falling = vec![block(1, &[plain]), block(0, &[plain])];
    assert_eq!(message(falling), "block 1 has group 0, but the block before it has group 1");
    let reserved = vec![block(0, &[plain, ([0, RESTART, 1], [0; 3])])];
    assert_eq!(message(reserved), "block 0, triangle 1: vertex index 4294967295 is reserved for restarts");
}

#[test]
fn writer_errors_and_cancellation_end_the_work() {
    let mesh = shapes::terrain(20, 1);
    let mut written = 0;
    let failed =
        stripify_blocks(&mut MeshBlocks::new(&mesh, 50).unwrap(), &BlockOptions::default(), &mut |_, _| {
            written += 1;
            if written == 3 { Err("full") } else { Ok(()) }
        });
    assert_eq!((failed, written), (Err(BlocksError::Write("full")), 3));
    let mut seen = Vec::new();
    let stopped = stripify_blocks_with_progress(
        &mut MeshBlocks::new(&mesh, 50).unwrap(),
        &BlockOptions::default(),
        &mut |_, _| Ok::<(), Infallible>(()),
        &mut |now| {
            seen.push(now.done);
            if now.done == 2 { std::ops::ControlFlow::Break(()) } else { std::ops::ControlFlow::Continue(()) }
        },
    );
    assert!(matches!(stopped, Err(BlocksError::Cancelled(_))));
    assert_eq!(seen, vec![0, 1, 2]);
}

proptest! {
    #![proptest_config(striata_testing::cases(60))]

    #[test]
    fn soups_keep_their_triangles(
        seed in any::<u64>(),
        vertex_count in 3usize..30,
        triangle_count in 0usize..120,
        block_triangles in 1usize..60,
        held_limit in prop_oneof![Just(usize::MAX), 0usize..40],
    ) {
        let mesh = soup(vertex_count, triangle_count, &mut Random::new(seed));
        let options = BlockOptions::default().with_held_limit(held_limit);
        let report = check("soup", &mesh, block_triangles, &options);
        prop_assert!(report.peak_held_triangles <= held_limit);
    }
}
