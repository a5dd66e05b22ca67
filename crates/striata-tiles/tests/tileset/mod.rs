//! A tileset that has been read back, and what holds for all of them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use serde_json::Value;
use striata::ignore_progress;
use striata::mesh::IndexedMesh;
use striata_paged::PagedFile;
use striata_paged::build::{BuildInput, BuildOptions, BuildPaths, PagedPlan, run_all};
use striata_tiles::{TilesOptions, TilesReport, write_tiles};
use tempfile::TempDir;

pub(crate) type Point = [f64; 3];
type Cell = [i64; 3];

/// A tile with its content.
pub(crate) struct ReadTile {
    pub level: u32,
    pub cell: Cell,
    pub mesh: IndexedMesh,
    /// Its place relative to the tileset, with z up.
    shift: Point,
}

pub(crate) struct Tileset {
    pub report: TilesReport,
    pub tiles: Vec<ReadTile>,
    json: Value,
}

/// A paged file of a mesh, unless no file can hold it.
pub(crate) fn try_built(mesh: &IndexedMesh) -> Option<(TempDir, PagedFile)> {
    let folder = tempfile::tempdir().unwrap();
    let (input, output) = (folder.path().join("mesh.glb"), folder.path().join("mesh.striata"));
    striata_io::write(&input, mesh, &striata_io::WriteOptions::default()).ok()?;
    let work = folder.path().join("work");
    let options = BuildOptions { cell: 2000, exact: true, ..BuildOptions::default() };
    let paths = BuildPaths { output: &output, folder: &work };
    let plan =
        PagedPlan::make(BuildInput::Files(vec![input]), options, paths, 1, &mut ignore_progress).ok()?;
    run_all(&plan, 1, &mut ignore_progress).ok()?;
    plan.remove_work().unwrap();
    let file = PagedFile::open(output.to_str().unwrap()).unwrap();
    Some((folder, file))
}

pub(crate) fn built(mesh: &IndexedMesh) -> (TempDir, PagedFile) {
    try_built(mesh).expect("the mesh can be built")
}

pub(crate) fn tiled(mesh: &IndexedMesh, options: &TilesOptions) -> Tileset {
    let (folder, mut file) = built(mesh);
    let output = folder.path().join("tiles");
    let report = write_tiles(&mut file, &output, options, &mut ignore_progress).unwrap();
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
    pub(crate) fn points(&self) -> Vec<Point> {
        self.local_points().into_iter().map(|p| [0, 1, 2].map(|a| p[a] + self.shift[a])).collect()
    }

    /// Area of the triangles seen from above.
    pub(crate) fn area_in_plan(&self) -> f64 {
        let points = self.points();
        let double = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| points[v as usize]);
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        self.mesh.triangles.iter().map(|t| 0.5 * double(t)).sum()
    }

    /// Sorted triangles.
    pub(crate) fn soup(&self) -> Vec<[[u64; 3]; 3]> {
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
    pub(crate) fn read(folder: &Path, report: TilesReport) -> Self {
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

    pub(crate) fn levels(&self) -> std::ops::Range<u32> {
        0..self.report.levels.len() as u32
    }

    pub(crate) fn bounds(&self) -> [Point; 2] {
        bounds_of(self.tiles.iter().filter(|tile| tile.level == 0).flat_map(ReadTile::points))
    }

    /// Checks the tree: boxes contain contents and children, errors fall, and every content is named once.
    pub(crate) fn check(&self) {
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
    pub(crate) fn open_edges(&self, level: u32) -> Vec<[Point; 2]> {
        odd(self.tiles.iter().filter(|tile| tile.level == level).flat_map(ReadTile::edges))
    }

    /// The section of a level at each plane between its tiles, by axis and coordinate: points along and above it.
    pub(crate) fn sections(&self, level: usize) -> BTreeMap<(usize, u64), Vec<[f64; 2]>> {
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
pub(crate) fn gap(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let height = |line: &[[f64; 2]], x: f64| {
        let next = line.partition_point(|p| p[0] < x).clamp(1, line.len() - 1);
        let ([x0, y0], [x1, y1]) = (line[next - 1], line[next]);
        if x1 > x0 { y0 + (x - x0).clamp(0.0, x1 - x0) / (x1 - x0) * (y1 - y0) } else { y1 }
    };
    a.iter().chain(b).map(|p| (height(a, p[0]) - height(b, p[0])).abs()).fold(0.0, f64::max)
}
