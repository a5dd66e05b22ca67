//! Tilesets of many meshes: valid trees, and no cracks within a level or between levels.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::common::{built, try_built, try_built_with};
use proptest::prelude::*;
use serde_json::Value;
use striata::ignore_progress;
use striata::mesh::{AttributeLayer, IndexedMesh, Material, Semantic, TriangleGroup, shapes};
use striata_paged::PagedFile;
use striata_testing::meshes::{nasty, two_sided};
use striata_tiles::{TileFormat, TileLevel, TilesError, TilesOptions, TilesReport, Up, write_tiles};

type Point = [f64; 3];
type Cell = [i64; 3];

/// A tile with its content.
struct ReadTile {
    pub level: u32,
    pub cell: Cell,
    pub mesh: IndexedMesh,
    /// Its place relative to the tileset, with z up.
    shift: Point,
}

struct Tileset {
    pub report: TilesReport,
    pub tiles: Vec<ReadTile>,
    json: Value,
}

fn tiled(mesh: &IndexedMesh, options: &TilesOptions) -> Tileset {
    let (folder, mut file) = built(mesh);
    tiled_of(folder.path(), &mut file, options)
}

fn tiled_of(folder: &Path, file: &mut PagedFile, options: &TilesOptions) -> Tileset {
    let output = folder.join("tiles");
    let report = write_tiles(file, &output, options, &mut ignore_progress).unwrap();
    Tileset::read(&output, report)
}

/// Center and half axes of a box.
fn corners_of(value: &Value) -> [Point; 2] {
    let x: Vec<f64> =
        value["boundingVolume"]["box"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    let half = [x[3], x[7], x[11]];
    assert_eq!(x[4..7], [0.0; 3]);
    [[0, 1, 2].map(|a| x[a] - half[a]), [0, 1, 2].map(|a| x[a] + half[a])]
}

fn contains(outer: [Point; 2], inner: [Point; 2]) -> bool {
    (0..3).all(|a| {
        let slack = 1e-9 * (outer[1][a] - outer[0][a]).max(outer[1][a].abs()).max(outer[0][a].abs());
        outer[0][a] <= inner[0][a] + slack && inner[1][a] <= outer[1][a] + slack
    })
}

fn bounds_of(points: impl IntoIterator<Item = Point>) -> [Point; 2] {
    points.into_iter().fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
        [[0, 1, 2].map(|a| low[a].min(p[a])), [0, 1, 2].map(|a| high[a].max(p[a]))]
    })
}

impl ReadTile {
    /// Vertices from the origin of the tileset, with z up.
    fn local_points(&self) -> Vec<Point> {
        let place = |p: &[f32; 3]| {
            let [x, y, z] = [0, 1, 2].map(|a| f64::from(p[a]) + self.mesh.origin[a]);
            [x, 0.0 - z, y]
        };
        self.mesh.positions.iter().map(place).collect()
    }

    /// Vertices with z up.
    fn points(&self) -> Vec<Point> {
        self.local_points().into_iter().map(|p| [0, 1, 2].map(|a| p[a] + self.shift[a])).collect()
    }

    /// Area of the triangles seen from above.
    fn area_in_plan(&self) -> f64 {
        let points = self.points();
        let double = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| points[v as usize]);
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        self.mesh.triangles.iter().map(|t| 0.5 * double(t)).sum()
    }

    /// Sorted triangles.
    fn soup(&self) -> Vec<[[u64; 3]; 3]> {
        let points = self.local_points();
        let corners = |t: &[u32; 3]| {
            let mut at = t.map(|v| points[v as usize].map(|x| (x + 0.0).to_bits()));
            let first = (0..3).min_by_key(|&i| at[i]).unwrap();
            at.rotate_left(first);
            at
        };
        let mut soup: Vec<_> = self.mesh.triangles.iter().map(corners).collect();
        soup.sort_unstable();
        soup
    }

    fn edges(&self) -> impl Iterator<Item = [Point; 2]> {
        let points = self.points();
        self.mesh.triangles.clone().into_iter().flat_map(move |t| {
            let at = t.map(|v| points[v as usize]);
            [0, 1, 2].map(|i| {
                let (a, b) = (at[i], at[(i + 1) % 3]);
                if a < b { [a, b] } else { [b, a] }
            })
        })
    }
}

/// Edges with an odd number of triangles.
fn odd(edges: impl Iterator<Item = [Point; 2]>) -> Vec<[Point; 2]> {
    let mut counts: BTreeMap<[[u64; 3]; 2], (usize, [Point; 2])> = BTreeMap::new();
    for edge in edges {
        counts.entry(edge.map(|p| p.map(|x| (x + 0.0).to_bits()))).or_insert((0, edge)).0 += 1;
    }
    counts.into_values().filter(|(count, _)| count % 2 == 1).map(|(_, edge)| edge).collect()
}

impl Tileset {
    fn read(folder: &Path, report: TilesReport) -> Self {
        let json: Value = serde_json::from_slice(&fs::read(folder.join("tileset.json")).unwrap()).unwrap();
        let number = |i: usize| json["root"]["transform"][i].as_f64().unwrap();
        let shift = [number(12), number(13), number(14)];
        let mut tiles = Vec::new();
        for level in 0..report.levels.len() as u32 {
            let Ok(files) = fs::read_dir(folder.join(level.to_string())) else { continue };
            let mut names: Vec<String> =
                files.map(|file| file.unwrap().file_name().into_string().unwrap()).collect();
            names.sort();
            for name in names.iter().filter_map(|name| name.strip_suffix(".glb")) {
                let cell: Vec<i64> = name.split('_').map(|x| x.parse().unwrap()).collect();
                let mesh = striata_io::read(folder.join(format!("{level}/{name}.glb"))).unwrap();
                tiles.push(ReadTile { level, cell: [cell[0], cell[1], cell[2]], mesh, shift });
            }
        }
        Self { report, tiles, json }
    }

    fn levels(&self) -> std::ops::Range<u32> {
        0..self.report.levels.len() as u32
    }

    fn bounds(&self) -> [Point; 2] {
        bounds_of(self.tiles.iter().filter(|tile| tile.level == 0).flat_map(ReadTile::points))
    }

    /// Checks the tree: boxes contain contents and children, errors fall, and every content is named once.
    fn check(&self) {
        assert_eq!(self.json["asset"]["version"], "1.1");
        assert_eq!(self.json["root"]["refine"], "REPLACE");
        let mut named = BTreeSet::new();
        let error = self.json["geometricError"].as_f64().unwrap();
        self.check_tile(&self.json["root"], error, &mut named);
        assert_eq!(named.len(), self.tiles.len());
        assert_eq!(self.report.tiles, self.tiles.len() as u64);
        let triangles: usize = self.tiles.iter().map(|tile| tile.mesh.triangles.len()).sum();
        assert_eq!(self.report.triangles, triangles as u64);
    }

    fn check_tile(&self, tile: &Value, parent_error: f64, named: &mut BTreeSet<String>) {
        let error = tile["geometricError"].as_f64().unwrap();
        let own = corners_of(tile);
        assert!(error <= parent_error, "{error} > {parent_error}");
        if let Some(uri) = tile["content"]["uri"].as_str() {
            assert!(named.insert(uri.to_owned()), "{uri} occurs twice");
            let read = self.tiles.iter().find(|tile| {
                let [x, y, z] = tile.cell;
                format!("{}/{x}_{y}_{z}.glb", tile.level) == uri
            });
            let read = read.expect("the content exists");
            assert!(contains(own, bounds_of(read.local_points())), "{uri}: {own:?}");
            assert!(!read.mesh.triangles.is_empty());
            assert_eq!(error == 0.0, read.level == 0, "{uri}");
        }
        for child in tile["children"].as_array().into_iter().flatten() {
            assert!(contains(own, corners_of(child)));
            self.check_tile(child, error, named);
        }
    }

    /// Edges of the union of all tiles of a level with an odd number of triangles.
    fn open_edges(&self, level: u32) -> Vec<[Point; 2]> {
        odd(self.tiles.iter().filter(|tile| tile.level == level).flat_map(ReadTile::edges))
    }

    /// The section of a level at each plane between its tiles, by axis and coordinate: points along and above it.
    fn sections(&self, level: usize) -> BTreeMap<(usize, u64), Vec<[f64; 2]>> {
        let mut sections: BTreeMap<(usize, u64), Vec<[f64; 2]>> = BTreeMap::new();
        for tile in self.tiles.iter().filter(|tile| tile.level == level as u32) {
            let [low, high] = bounds_of(tile.points());
            for edge in odd(tile.edges()) {
                for axis in 0..2 {
                    let x = edge[0][axis];
                    // The side of the tile towards the next one, and not that of the mesh.
                    if edge[1][axis] == x && (x == low[axis] || x == high[axis]) {
                        let line = sections.entry((axis, x.to_bits())).or_default();
                        line.extend(edge.map(|p| [p[1 - axis], p[2]]));
                    }
                }
            }
        }
        let [low, high] = self.bounds();
        sections.retain(|&(axis, x), _| {
            let x = f64::from_bits(x);
            x > low[axis] + 1.0 && x < high[axis] - 1.0
        });
        for line in sections.values_mut() {
            line.sort_by(|a, b| a.partial_cmp(b).unwrap());
            line.dedup();
        }
        sections
    }
}

/// Largest vertical distance of two polylines that begin and end together.
fn gap(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let height = |line: &[[f64; 2]], x: f64| {
        let next = line.partition_point(|p| p[0] < x).clamp(1, line.len() - 1);
        let ([x0, y0], [x1, y1]) = (line[next - 1], line[next]);
        if x1 > x0 { y0 + (x - x0).clamp(0.0, x1 - x0) / (x1 - x0) * (y1 - y0) } else { y1 }
    };
    a.iter().chain(b).map(|p| (height(a, p[0]) - height(b, p[0])).abs()).fold(0.0, f64::max)
}

fn options(tile_triangles: u64) -> TilesOptions {
    let mut options = TilesOptions::default();
    (options.tile_triangles, options.shading) = (tile_triangles, false);
    options
}

fn terrain(size: u32) -> IndexedMesh {
    shapes::height_field(size, size, |x, y| {
        let (x, y) = (f64::from(x), f64::from(y));
        (4.0 * (x * 0.11).sin() * (y * 0.07).cos() + 0.6 * (0.9 * x + 0.4 * y).sin()) as f32
    })
}

#[test]
fn a_terrain_has_a_tree_without_cracks() {
    let set = tiled(&terrain(120), &options(1000));
    set.check();
    assert_eq!(set.levels().len(), 4);
    assert_eq!(set.report.levels.last().unwrap().tiles, 1);
    assert!(set.report.levels[0].tiles > 40, "{:?}", set.report);
    for level in set.levels() {
        // Nothing but the four sides is open.
        let open = set.open_edges(level);
        let side = |points: &[Point; 2]| {
            (0..2).any(|a| [0.0, 120.0].iter().any(|&x| points.iter().all(|p| (p[a] - x).abs() < 0.01)))
        };
        assert!(open.iter().all(side), "level {level}: {:?}", open.iter().find(|edge| !side(edge)));
        assert!(open.len() >= 4);
    }
}

#[test]
fn a_closed_surface_has_no_open_edge_at_any_level() {
    // The grid of a file moves vertices out of the bounds of the input.
    let on_grid = |mesh: &IndexedMesh| try_built_with(mesh, false).unwrap();
    let (torus, flat) = (shapes::torus(80, 60, 1.0, 0.4), shapes::torus(80, 60, 1.0, 0.25));
    for (folder, mut file) in
        [built(&torus), built(&shapes::icosphere(5, 3.0)), on_grid(&torus), on_grid(&flat)]
    {
        let set = tiled_of(folder.path(), &mut file, &options(500));
        set.check();
        assert!(set.levels().len() >= 3);
        for level in set.levels() {
            assert!(set.open_edges(level).is_empty(), "level {level}");
        }
    }
}

#[test]
fn gaps_between_levels_are_a_sixteenth_of_the_error() {
    let set = tiled(&terrain(160), &options(400));
    let levels = set.report.levels.clone();
    let mut largest = 0.0f64;
    for (level, TileLevel { error, .. }) in levels.iter().enumerate().skip(1).take(levels.len() - 2) {
        let (fine, coarse) = (set.sections(level - 1), set.sections(level));
        let mut plane_count = 0;
        for (plane, line) in &coarse {
            let gap = gap(line, &fine[plane]);
            let allowed = error / 16.0 + set.report.step * f64::from(1 << level);
            assert!(gap <= allowed, "level {level}, {plane:?}: gap {gap}, allowed {allowed}");
            largest = largest.max(gap / error);
            plane_count += 1;
        }
        assert!(plane_count >= 2);
    }
    assert!(largest > 0.0, "nothing was measured");
}

#[test]
fn the_finest_tiles_are_the_input() {
    let mesh = terrain(90);
    let set = tiled(&mesh, &options(500));
    let half = 0.75f64.sqrt() * set.report.step;
    let points: Vec<Point> =
        set.tiles.iter().filter(|tile| tile.level == 0).flat_map(|tile| tile.points()).collect();
    for p in &mesh.positions {
        let p = p.map(f64::from);
        let distance = |q: &Point| (0..3).map(|a| (p[a] - q[a]).powi(2)).sum::<f64>();
        let nearest = points.iter().map(distance).fold(f64::INFINITY, f64::min).sqrt();
        assert!(nearest <= half * 1.0001, "{p:?}: {nearest} > {half}");
    }
    let area: f64 = set.tiles.iter().filter(|tile| tile.level == 0).map(|tile| tile.area_in_plan()).sum();
    assert!((area - 90.0 * 90.0).abs() < 0.01, "{area}");
}

#[test]
fn all_formats_have_the_same_triangles() {
    let mesh = shapes::torus(60, 40, 1.0, 0.4);
    let soups: Vec<_> = [TileFormat::Float, TileFormat::Quantized, TileFormat::Meshopt, TileFormat::Draco]
        .into_iter()
        .map(|format| {
            let mut options = options(800);
            options.format = format;
            let set = tiled(&mesh, &options);
            set.check();
            let of = |tile: &ReadTile| ((tile.level, tile.cell), tile.soup());
            let soups: BTreeMap<_, _> = set.tiles.iter().map(of).collect();
            (soups, set.report.bytes)
        })
        .collect();
    for (soup, _) in &soups[1..] {
        assert!(*soup == soups[0].0);
    }
    assert!(
        soups[3].1 * 2 < soups[1].1 && soups[1].1 < soups[0].1,
        "{:?}",
        soups.iter().map(|s| s.1).collect::<Vec<_>>()
    );
}

#[test]
fn attributes_and_materials_are_kept() {
    let mut mesh = terrain(60);
    let colors = mesh.positions.iter().flat_map(|p| [p[0] / 60.0, p[1] / 60.0, 0.5]).collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, colors));
    mesh.layers.insert(0, AttributeLayer::from_f32(Semantic::Normal, 3, [0.0, 0.6, 0.8].repeat(3721)));
    let half = mesh.triangles.len() as u32 / 2;
    let textured = r#"{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicFactor":0.25}}"#;
    mesh.appearance.materials = vec![
        Material { name: "grass".into(), gltf_json: "{}".into() },
        Material { name: "rock".into(), gltf_json: textured.into() },
    ];
    mesh.appearance.textures_json = vec![r#"{"source":0}"#.into()];
    mesh.appearance.images =
        vec![striata::mesh::Image { name: "photo".into(), uri: "photo.png".into(), ..Default::default() }];
    let group =
        |first, material| TriangleGroup { name: String::new(), material: Some(material), first, count: half };
    mesh.groups = vec![group(0, 0), group(half, 1)];
    let set = tiled(&mesh, &options(300));
    let expected = [
        "textures of the material rock are left out: the mesh has no texcoord_0",
        "the image photo is left out: it is missing",
    ];
    assert_eq!(set.report.left_out, expected);
    let mut names = BTreeSet::new();
    for tile in &set.tiles {
        let color =
            tile.mesh.layers.iter().find(|layer| layer.semantic == Semantic::Color(0)).expect("colors");
        for (v, p) in tile.points().iter().enumerate() {
            // Colors are linear in the plane, so cutting keeps them linear.
            let error = (0..2).map(|a| (f64::from(color.get(v, a)) - p[a] / 60.0).abs()).fold(0.0, f64::max);
            assert!(error < 2e-3, "{p:?}: {error}");
        }
        assert!(tile.mesh.layers.iter().any(|layer| layer.semantic == Semantic::Normal));
        for material in &tile.mesh.appearance.materials {
            names.insert(material.name.clone());
            assert!(!material.gltf_json.contains("Texture"), "{}", material.gltf_json);
        }
        assert!(tile.mesh.appearance.images.is_empty());
    }
    assert_eq!(names.into_iter().collect::<Vec<_>>(), ["grass", "rock"]);
}

#[test]
fn the_axis_that_is_up_becomes_z() {
    // Higher than wide, so y is up, and its octree is that of a mesh whose z is up.
    let mut mesh = shapes::icosphere(4, 1.0);
    mesh.positions.iter_mut().for_each(|p| *p = [p[0], p[1] * 3.0, p[2]]);
    let set = tiled(&mesh, &options(500));
    assert_eq!(set.report.up, "y");
    let [low, high] = set.bounds();
    assert!(high[2] - low[2] > 2.0 * (high[0] - low[0]), "{low:?} {high:?}");
    let turned = {
        let mut mesh = mesh.clone();
        mesh.positions.iter_mut().for_each(|p| *p = [p[0], -p[2], p[1]]);
        let mut options = options(500);
        options.up = Some(Up::Z);
        tiled(&mesh, &options)
    };
    let [other_low, other_high] = turned.bounds();
    for a in 0..3 {
        assert!((low[a] - other_low[a]).abs() < 1e-3 && (high[a] - other_high[a]).abs() < 1e-3);
    }
}

#[test]
fn skirts_hang_below_the_borders_of_a_terrain() {
    let mut options = options(1000);
    let plain = tiled(&terrain(90), &options);
    options.has_skirts = true;
    let set = tiled(&terrain(90), &options);
    set.check();
    for (with, without) in set.tiles.iter().zip(&plain.tiles) {
        assert!((with.area_in_plan() - without.area_in_plan()).abs() < 1e-6);
        let is_root = set.report.levels.len() == with.level as usize + 1;
        assert_eq!(with.mesh.triangles.len() > without.mesh.triangles.len(), !is_root);
    }
    let (_folder, mut file) = built(&shapes::icosphere(3, 1.0));
    let output = _folder.path().join("tiles");
    let refused = write_tiles(&mut file, &output, &options, &mut ignore_progress);
    assert!(matches!(refused, Err(TilesError::Skirts { .. })));
    assert!(!output.exists());
}

#[test]
fn only_a_tileset_of_striata_is_replaced() {
    let (folder, mut file) = built(&shapes::torus(10, 10, 1.0, 0.4));
    let output = folder.path().join("tiles");
    let mut write = |path| write_tiles(&mut file, path, &options(1000), &mut ignore_progress);
    write(&output).unwrap();
    fs::write(output.join("old"), "").unwrap();
    write(&output).unwrap();
    assert!(!output.join("old").exists(), "the old folder is replaced as a whole");
    fs::write(output.join("tileset.json"), r#"{"asset":{"generator":"another"}}"#).unwrap();
    let text = write(&output).unwrap_err().to_string();
    assert!(text.ends_with("it is a folder, but no tileset of striata"), "{text}");
    let taken = folder.path().join("file");
    fs::write(&taken, "mine").unwrap();
    assert!(matches!(write(&taken), Err(TilesError::Place { .. })));
    assert_eq!(fs::read(&taken).unwrap(), b"mine");
    let archive = folder.path().join("a.3tz");
    write(&archive).unwrap();
    let first = fs::read(&archive).unwrap();
    write(&archive).unwrap();
    assert!(fs::read(&archive).unwrap() == first, "the same tiles are the same bytes");
    let stopped = write_tiles(&mut file, &folder.path().join("no"), &options(1000), &mut |_| {
        std::ops::ControlFlow::Break(())
    });
    assert!(matches!(stopped, Err(TilesError::Cancelled(_))));
    let left: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|file| file.unwrap().file_name()).collect();
    assert!(left.iter().all(|name| !name.to_string_lossy().starts_with(".striata")), "{left:?}");
}

#[test]
fn results_do_not_depend_on_pages_in_memory() {
    let (folder, file) = built(&terrain(120));
    let name = file.name().to_owned();
    let read = |max_vertices: u64, name_of_output: &str| {
        let mut file = PagedFile::open(&name).unwrap().with_max_vertices(max_vertices);
        let output = folder.path().join(name_of_output);
        write_tiles(&mut file, &output, &options(1000), &mut ignore_progress).unwrap();
        fs::read(output).unwrap()
    };
    assert!(read(0, "few.3tz") == read(10_000_000, "all.3tz"));
}

#[test]
fn nasty_meshes_become_valid_tilesets() {
    for (name, mesh) in nasty() {
        let Some((_folder, mut file)) = try_built(&mesh) else { continue };
        for tile_triangles in [20, 100] {
            let output = _folder.path().join("tiles");
            match write_tiles(&mut file, &output, &options(tile_triangles), &mut ignore_progress) {
                Ok(report) => Tileset::read(&output, report).check(),
                // Nothing is left of it, or the corner of a tile is beyond the largest float.
                Err(TilesError::Empty { .. }) => {}
                Err(error) => assert_eq!(name, "coordinates around 1e38", "{error}"),
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(24) })]

    /// Sheets with two sides, far away, tiny, or with vertices exactly on planes.
    #[test]
    fn levels_of_sheets_are_closed_inside(
        size in 2u32..24,
        shift in prop::sample::select(vec![0.0f32, 4096.0, -1e6]),
        scale in prop::sample::select(vec![1.0f32, 0.25, 2f32.powi(-40)]),
        tile_triangles in 2u64..200,
        is_two_sided in any::<bool>(),
        seed in 0u32..1000,
    ) {
        // Whole numbers, so that coordinates stay exact and vertices lie on planes.
        let height = |x: u32, y: u32| ((x * 7 + y * 13 + seed) % 5) as f32;
        let mut mesh = shapes::height_field(size, size, height);
        mesh.positions.iter_mut().for_each(|p| *p = p.map(|x| x * scale + shift));
        let mesh = if is_two_sided { two_sided(mesh) } else { mesh };
        prop_assume!(shift == 0.0 || scale == 1.0);
        let mut options = options(tile_triangles);
        options.up = Some(Up::Z);
        let set = tiled(&mesh, &options);
        set.check();
        for level in set.levels() {
            for edge in set.open_edges(level) {
                // A line between vertices of the mesh has a whole number, a plane between tiles has none.
                let place = |axis: usize| (edge[0][axis] - f64::from(shift)) / f64::from(scale);
                let is_at = |axis: usize| edge[0][axis] == edge[1][axis];
                prop_assert!(!(0..2).any(|a| is_at(a) && place(a).fract() != 0.0), "level {level}: {edge:?}");
                let is_side = |a: usize| is_at(a) && [0.0, f64::from(size)].contains(&place(a));
                prop_assert!(level > 0 || (0..2).any(is_side), "{edge:?}");
            }
        }
    }
}
