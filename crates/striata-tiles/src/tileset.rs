//! The tree of tiles as `tileset.json`.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::earth::Matrix;
use crate::lattice::{Cell, TileLattice, Up};

/// Tilesets of more tiles are divided into several files.
const MOST_TILES: usize = 4096;
/// Number of levels in a file of a divided tileset.
const FILE_LEVELS: u32 = 5;

/// A tile that has a content.
#[derive(Clone, Debug)]
pub(crate) struct Tile {
    /// Bounds of the content, from the origin of the lattice.
    pub bounds: [[f64; 3]; 2],
    pub triangle_count: u64,
    pub byte_count: u64,
}

/// All tiles by level and cell.
pub(crate) struct TileTree<'a> {
    pub lattice: &'a TileLattice,
    pub up: Up,
    /// Geometric error of each level, finest first.
    pub errors: Vec<f64>,
    pub tiles: BTreeMap<(u32, Cell), Tile>,
    /// Geometric error if nothing is drawn.
    pub extent: f64,
}

/// Path of the content of a tile, or of the file that lists its descendants.
pub(crate) fn path_of(level: u32, [x, y, z]: Cell, extension: &str) -> String {
    format!("{level}/{x}_{y}_{z}.{extension}")
}

/// A part of the tree, with bounds of everything in it.
struct Branch {
    value: Value,
    bounds: [[f64; 3]; 2],
}

impl TileTree<'_> {
    /// All files of the tileset by path; the first is its root.
    pub(crate) fn files(&self, transform: Matrix) -> Vec<(String, Value)> {
        let top = self.errors.len() as u32 - 1;
        let mut files = vec![("tileset.json".to_owned(), Value::Null)];
        let mut root = match self.branch(top, [0; 3], &mut files) {
            Some(branch) => branch.value,
            None => json!({ "geometricError": 0.0, "boundingVolume": self.volume([[0.0; 3]; 2]) }),
        };
        root["transform"] = json!(transform);
        files[0].1 = self.file(root);
        files
    }

    fn file(&self, mut root: Value) -> Value {
        root["refine"] = json!("REPLACE");
        json!({
            "asset": { "version": "1.1", "generator": "striata" },
            "geometricError": self.extent.max(root["geometricError"].as_f64().unwrap_or(0.0)),
            "root": root,
        })
    }

    fn branch(&self, level: u32, cell: Cell, files: &mut Vec<(String, Value)>) -> Option<Branch> {
        let tile = self.tiles.get(&(level, cell));
        let mut children = Vec::new();
        if level > 0 {
            for place in 0..8 {
                let bits: [i64; 3] = [place & 1, (place >> 1) & 1, (place >> 2) & 1];
                if (0..3).all(|a| self.lattice.is_divided[a] || bits[a] == 0) {
                    let child = [0, 1, 2].map(|a| 2 * cell[a] + bits[a]);
                    children.extend(self.branch(level - 1, child, files));
                }
            }
        }
        let all = children.iter().map(|child: &Branch| child.bounds).chain(tile.map(|tile| tile.bounds));
        let bounds = all.reduce(|[a, b], [c, d]| {
            let axes = [0, 1, 2];
            [axes.map(|i| a[i].min(c[i])), axes.map(|i| b[i].max(d[i]))]
        })?;
        let volume = self.volume(bounds);
        let mut value = json!({ "boundingVolume": volume, "geometricError": self.errors[level as usize] });
        if tile.is_some() {
            value["content"] = json!({ "uri": self.uri(level, path_of(level, cell, "glb")) });
        }
        if children.is_empty() && level > 0 {
            // A finer level has nothing here, and that replaces the content.
            value["children"] = json!([{ "boundingVolume": volume, "geometricError": 0.0 }]);
        } else if !children.is_empty() {
            value["children"] = children.into_iter().map(|child| child.value).collect();
        }
        if self.file_level(level) == Some(level) {
            let path = path_of(level, cell, "json");
            files.push((path.clone(), self.file(value)));
            value = json!({
                "boundingVolume": volume,
                "geometricError": self.errors[level as usize],
                "content": { "uri": self.uri(level + 1, path) },
            });
        }
        Some(Branch { value, bounds })
    }

    /// Path of a file, relative to the file that lists the tiles of a level.
    fn uri(&self, level: u32, path: String) -> String {
        if self.file_level(level).is_some() { format!("../{path}") } else { path }
    }

    /// Level of the tile that begins the file in which tiles of a level are; `None` for the first file.
    fn file_level(&self, level: u32) -> Option<u32> {
        let first = level.max(1).next_multiple_of(FILE_LEVELS);
        (self.tiles.len() > MOST_TILES && first + 1 < self.errors.len() as u32).then_some(first)
    }

    /// A box whose z axis is up.
    fn volume(&self, [min, max]: [[f64; 3]; 2]) -> Value {
        let center = turned(self.up, [0, 1, 2].map(|a| 0.5 * (min[a] + max[a])));
        let half = turned(self.up, [0, 1, 2].map(|a| 0.5 * (max[a] - min[a]))).map(f64::abs);
        let [x, y, z] = center;
        let [a, b, c] = half;
        json!({ "box": [x, y, z, a, 0.0, 0.0, 0.0, b, 0.0, 0.0, 0.0, c] })
    }
}

/// A point of the mesh with the z axis up.
pub(crate) fn turned(up: Up, [x, y, z]: [f64; 3]) -> [f64; 3] {
    match up {
        Up::Y => [x, 0.0 - z, y],
        Up::Z => [x, y, z],
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn many_tiles_are_listed_in_several_files() {
        let lattice = TileLattice {
            origin: [0.0; 3],
            unit: 1.0,
            side: 16,
            high: [0.0; 3],
            is_divided: [true, true, false],
            is_halved: false,
        };
        let mut tiles = BTreeMap::new();
        for level in 0..7 {
            for x in 0..1i64 << (6 - level) {
                for y in 0..1i64 << (6 - level) {
                    let side = lattice.tile_side(level);
                    let [low, high] =
                        [0, 1].map(|k| [(x + k) as f64 * side, (y + k) as f64 * side, k as f64]);
                    let tile = Tile { bounds: [low, high], triangle_count: 1, byte_count: 1 };
                    tiles.insert((level, [x, y, 0]), tile);
                }
            }
        }
        let count = tiles.len();
        assert!(count > MOST_TILES);
        let errors = (0..7).map(f64::from).collect();
        let tree = TileTree { lattice: &lattice, up: Up::Z, errors, tiles, extent: 100.0 };
        let files: BTreeMap<String, Value> = tree.files([1.0; 16]).into_iter().collect();
        assert_eq!(files.len(), 5);
        let (mut contents, mut open) = (BTreeSet::new(), vec![("tileset.json".to_owned(), 101.0)]);
        while let Some((path, limit)) = open.pop() {
            let file = &files[&path];
            assert_eq!(file["root"]["refine"], "REPLACE");
            let folder = path.rsplit_once('/').map(|(folder, _)| folder.to_owned());
            let mut tiles = vec![(&file["root"], limit)];
            while let Some((tile, limit)) = tiles.pop() {
                let error = tile["geometricError"].as_f64().unwrap();
                assert!(error <= limit);
                tiles.extend(tile["children"].as_array().into_iter().flatten().map(|child| (child, error)));
                let uri = tile["content"]["uri"].as_str().unwrap();
                let path = match &folder {
                    Some(_) => uri.strip_prefix("../").unwrap().to_owned(),
                    None => uri.to_owned(),
                };
                if path.ends_with(".json") {
                    open.push((path, error));
                } else {
                    assert!(contents.insert(path));
                }
            }
        }
        assert_eq!(contents.len(), count);
    }
}
