//! The mesh of one tile: parts of triangles, cut at the planes between tiles, on the lattice, with equal vertices merged.
//!
//! A point on a plane is computed from the two ends of the edge in one order, whichever triangle and tile it is
//! computed for, and axes are always cut in the same order. So triangles with a common edge, and tiles with a common
//! plane, have equal points there.

use std::collections::{BTreeMap, HashMap};

use striata::mesh::{AttributeLayer, Bounds, IndexedMesh, LayerData, Semantic, TriangleGroup};

use crate::lattice::{Cell, TileBlock, TileLattice};

const NONE: u32 = u32::MAX;

/// The content of a tile.
pub(crate) struct TileMesh {
    /// The mesh; its origin is the distance of its first lattice point from that of the lattice.
    pub mesh: IndexedMesh,
    /// The lattice point of each vertex, in steps of the level.
    pub points: Vec<[i64; 3]>,
}

/// A block of a level, from which tiles are cut.
pub(crate) struct LevelMesh<'a> {
    mesh: &'a IndexedMesh,
    lattice: &'a TileLattice,
    level: u32,
    /// First tile, and one beyond the last.
    cells: [Cell; 2],
    /// Depth of skirts, in steps; 0 for none.
    skirt: i64,
    /// Group of each triangle; empty if there are no groups.
    group_of: Vec<u32>,
}

/// Vertices and triangles that have been added to a tile.
struct TileBuilder<'a> {
    level: &'a LevelMesh<'a>,
    points: Vec<[i64; 3]>,
    /// Attributes of all vertices.
    rows: Vec<u8>,
    row: Vec<u8>,
    /// Last vertex at each point, and the one before each vertex at its point.
    last_at: HashMap<[i64; 3], u32>,
    previous: Vec<u32>,
    triangles: Vec<([u32; 3], u32)>,
}

impl<'a> LevelMesh<'a> {
    /// A block with skirts of this depth, in mesh units.
    pub(crate) fn new(mesh: &'a IndexedMesh, block: &TileBlock<'a>, skirt: f64) -> Self {
        let TileBlock { lattice, number: level, cells, .. } = *block;
        let mut group_of = Vec::new();
        for (index, group) in (0..).zip(&mesh.groups) {
            group_of.resize((group.first + group.count) as usize, index);
        }
        let skirt = (skirt / lattice.step(level)).ceil() as i64;
        Self { mesh, lattice, level, cells, skirt, group_of }
    }

    fn places(&self, triangle: u32) -> [[f64; 3]; 3] {
        let place = |v: u32| self.lattice.place(self.mesh.positions[v as usize]);
        self.mesh.triangles[triangle as usize].map(place)
    }

    /// The triangles that each tile has a part of.
    pub(crate) fn tiles(&self) -> BTreeMap<Cell, Vec<u32>> {
        let mut tiles: BTreeMap<Cell, Vec<u32>> = BTreeMap::new();
        for triangle in 0..self.mesh.triangles.len() as u32 {
            let places = self.places(triangle);
            let cells = [0, 1, 2].map(|a| {
                let low = places.iter().map(|place| place[a]).fold(f64::INFINITY, f64::min);
                let high = places.iter().map(|place| place[a]).fold(f64::NEG_INFINITY, f64::max);
                let [first, last] = self.lattice.cells_of(a, low, high, self.level);
                [first.max(self.cells[0][a]), last.min(self.cells[1][a] - 1)]
            });
            for x in cells[0][0]..=cells[0][1] {
                for y in cells[1][0]..=cells[1][1] {
                    for z in cells[2][0]..=cells[2][1] {
                        tiles.entry([x, y, z]).or_default().push(triangle);
                    }
                }
            }
        }
        tiles
    }

    /// The content of a tile that has parts of these triangles; `None` if nothing is left of them.
    pub(crate) fn tile(&self, cell: Cell, triangles: &[u32]) -> Option<TileMesh> {
        let mut builder = TileBuilder {
            level: self,
            points: Vec::new(),
            rows: Vec::new(),
            row: Vec::new(),
            last_at: HashMap::new(),
            previous: Vec::new(),
            triangles: Vec::with_capacity(triangles.len()),
        };
        let side = self.lattice.tile_side(self.level);
        for &triangle in triangles {
            let mut polygon = corners(self.places(triangle));
            for axis in (0..3).filter(|&axis| self.lattice.is_divided[axis]) {
                let planes = [cell[axis] as f64 * side, (cell[axis] + 1) as f64 * side];
                if polygon.iter().any(|c| c.place[axis] < planes[0] || c.place[axis] > planes[1]) {
                    polygon = between(&polygon, axis, planes);
                }
            }
            if self.lattice.is_halved && self.level > 0 {
                let middle = cell.map(|x| (x as f64 + 0.5) * side);
                eighths(polygon, middle).iter().for_each(|part| builder.add(triangle, part));
            } else {
                builder.add(triangle, &polygon);
            }
        }
        builder.add_skirts(cell);
        builder.finish()
    }
}

impl TileBuilder<'_> {
    /// Adds a convex part of a triangle as a fan, without triangles of which two corners have become one.
    fn add(&mut self, triangle: u32, polygon: &[Corner]) {
        if polygon.len() < 3 {
            return;
        }
        let group = self.level.group_of.get(triangle as usize).copied().unwrap_or(0);
        let vertices: Vec<u32> = polygon.iter().map(|corner| self.vertex(triangle, corner)).collect();
        for pair in vertices[1..].windows(2) {
            let corners = [vertices[0], pair[0], pair[1]];
            let [a, b, c] = corners.map(|v| self.points[v as usize]);
            if a != b && b != c && c != a {
                self.triangles.push((corners, group));
            }
        }
    }

    /// The vertex at a corner, which several triangles may share.
    fn vertex(&mut self, triangle: u32, corner: &Corner) -> u32 {
        let point = self.level.lattice.snap(corner.place, self.level.level);
        let mut row = std::mem::take(&mut self.row);
        row.clear();
        self.level.push_row(triangle, corner.weights, &mut row);
        let last = self.last_at.get(&point).copied().unwrap_or(NONE);
        let mut at = last;
        while at != NONE && self.rows[at as usize * row.len()..][..row.len()] != row {
            at = self.previous[at as usize];
        }
        if at == NONE {
            at = self.points.len() as u32;
            self.points.push(point);
            self.previous.push(last);
            self.last_at.insert(point, at);
            self.rows.extend_from_slice(&row);
        }
        self.row = row;
        at
    }

    /// Adds a vertical strip below each edge at a plane between tiles.
    fn add_skirts(&mut self, cell: Cell) {
        let TileLattice { side, is_divided, .. } = *self.level.lattice;
        let (Some(up), depth) = (is_divided.iter().position(|&is_divided| !is_divided), self.level.skirt)
        else {
            return;
        };
        if depth == 0 {
            return;
        }
        let is_at_plane = |a: [i64; 3], b: [i64; 3]| {
            let planes = |axis: usize| [cell[axis], cell[axis] + 1].map(|plane| plane * i64::from(side));
            (0..3).any(|axis| axis != up && a[axis] == b[axis] && planes(axis).contains(&a[axis]))
        };
        let mut counts: BTreeMap<[[i64; 3]; 2], u32> = BTreeMap::new();
        let edges = |corners: [u32; 3]| [0, 1, 2].map(|i| [corners[i], corners[(i + 1) % 3]]);
        let key = |points: [[i64; 3]; 2]| [points[0].min(points[1]), points[0].max(points[1])];
        for edge in self.triangles.iter().flat_map(|&(corners, _)| edges(corners)) {
            *counts.entry(key(edge.map(|v| self.points[v as usize]))).or_default() += 1;
        }
        let mut below: BTreeMap<u32, u32> = BTreeMap::new();
        for (corners, group) in self.triangles.clone() {
            for [a, b] in edges(corners) {
                let points = [a, b].map(|v| self.points[v as usize]);
                if counts[&key(points)] != 1 || !is_at_plane(points[0], points[1]) {
                    continue;
                }
                let [c, d] = [a, b].map(|v| *below.entry(v).or_insert_with(|| self.lowered(v, up, depth)));
                self.triangles.extend([([b, a, c], group), ([b, c, d], group)]);
            }
        }
    }

    /// A copy of a vertex at the bottom of a skirt.
    fn lowered(&mut self, v: u32, up: usize, depth: i64) -> u32 {
        let width = self.rows.len() / self.points.len();
        let row = self.rows[v as usize * width..][..width].to_vec();
        self.rows.extend(row);
        let mut point = self.points[v as usize];
        point[up] -= depth;
        self.points.push(point);
        self.points.len() as u32 - 1
    }

    /// The mesh, in the order in which its triangles use vertices.
    fn finish(self) -> Option<TileMesh> {
        let mut number = vec![NONE; self.points.len()];
        let mut used = Vec::new();
        for &v in self.triangles.iter().flat_map(|(corners, _)| corners) {
            if number[v as usize] == NONE {
                number[v as usize] = used.len() as u32;
                used.push(v);
            }
        }
        let first = used.iter().map(|&v| self.points[v as usize]);
        let first = first.reduce(|a, b| [0, 1, 2].map(|i| a[i].min(b[i])))?;
        let step = self.level.lattice.step(self.level.level);
        let position =
            |&v: &u32| [0, 1, 2].map(|a| ((self.points[v as usize][a] - first[a]) as f64 * step) as f32);
        let source = self.level.mesh;
        let row_bytes = source.layers.iter().map(AttributeLayer::vertex_bytes).sum::<usize>();
        let mut offset = 0;
        let layer = |layer: &AttributeLayer| {
            let width = layer.vertex_bytes();
            let row = |&v: &u32| &self.rows[v as usize * row_bytes + offset..][..width];
            let bytes: Vec<u8> = used.iter().flat_map(row).copied().collect();
            offset += width;
            let data = layer.data.from_bytes_like(&bytes);
            AttributeLayer { semantic: layer.semantic.clone(), data, ..*layer }
        };
        let layers = source.layers.iter().map(layer).collect();
        let mut triangles = self.triangles;
        triangles.sort_by_key(|&(_, group)| group);
        let mut groups = Vec::new();
        for run in triangles.chunk_by(|a, b| a.1 == b.1).filter(|_| !source.groups.is_empty()) {
            let first = groups.last().map_or(0, |group: &TriangleGroup| group.first + group.count);
            let group = source.groups[run[0].1 as usize].clone();
            groups.push(TriangleGroup { first, count: run.len() as u32, ..group });
        }
        let mesh = IndexedMesh {
            positions: used.iter().map(position).collect(),
            layers,
            triangles: triangles.iter().map(|(corners, _)| corners.map(|v| number[v as usize])).collect(),
            groups,
            appearance: source.appearance.clone(),
            origin: first.map(|x| x as f64 * step),
            ..IndexedMesh::default()
        };
        let points = used.iter().map(|&v| self.points[v as usize]).collect();
        Some(TileMesh { mesh, points })
    }
}

impl TileMesh {
    /// Bounds of the content, from the origin of the lattice.
    pub(crate) fn bounds(&self) -> [[f64; 3]; 2] {
        let bounds = Bounds::of(&self.mesh.positions).unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
        [bounds.min, bounds.max].map(|p| [0, 1, 2].map(|a| f64::from(p[a]) + self.mesh.origin[a]))
    }
}

impl LevelMesh<'_> {
    /// Appends the attributes at a point of a triangle.
    fn push_row(&self, triangle: u32, weights: [f64; 3], row: &mut Vec<u8>) {
        let corners = self.mesh.triangles[triangle as usize];
        // Equal weights are decided alike for all triangles of an edge.
        let is_nearer =
            |a: usize, b: usize| weights[a].total_cmp(&weights[b]).then(corners[b].cmp(&corners[a])).is_gt();
        let nearest = (1..3).fold(0, |best, i| if is_nearer(i, best) { i } else { best });
        let shares: Vec<(usize, f64)> =
            (0..3).map(|i| (i, weights[i])).filter(|share| share.1 > 0.0).collect();
        for layer in &self.mesh.layers {
            let n = layer.component_count as usize;
            let number =
                |corner: usize, component: usize| layer.data.number(corners[corner] as usize * n + component);
            let is_whole = |corner: usize| (0..n).all(|component| number(corner, component).fract() == 0.0);
            // Identifiers cannot be mixed, and floats may be some, too.
            let has_identifiers = matches!(layer.semantic, Semantic::Generic(_))
                && !layer.normalized
                && shares.iter().all(|&(corner, _)| is_whole(corner));
            if shares.len() == 1 || has_identifiers || layer.semantic.is_of_poses() {
                let width = layer.vertex_bytes();
                row.extend_from_slice(&layer.data.as_bytes()[corners[nearest] as usize * width..][..width]);
                continue;
            }
            let mixed = |component| shares.iter().map(|&(i, share)| share * number(i, component)).sum();
            let mut values: Vec<f64> = (0..n).map(mixed).collect();
            let is_direction = matches!(layer.semantic, Semantic::Normal | Semantic::Tangent);
            if is_direction && n >= 3 && layer.data.is_float() {
                make_direction(&mut values, |component| number(nearest, component));
            }
            push_values(&layer.data, &values, row);
        }
    }
}

/// Makes the first three values those of a unit vector, and takes the rest from a corner.
fn make_direction(values: &mut [f64], corner: impl Fn(usize) -> f64) {
    let length = values[..3].iter().map(|x| x * x).sum::<f64>().sqrt();
    for (component, value) in values.iter_mut().enumerate() {
        *value = if component < 3 && length > 0.0 { *value / length } else { corner(component) };
    }
}

/// Appends values in the type of a layer.
fn push_values(like: &LayerData, values: &[f64], row: &mut Vec<u8>) {
    for &x in values {
        match like {
            LayerData::F32(_) => row.extend((x as f32).to_le_bytes()),
            LayerData::F64(_) => row.extend(x.to_le_bytes()),
            LayerData::U8(_) => row.push(x.round() as u8),
            LayerData::I8(_) => row.extend((x.round() as i8).to_le_bytes()),
            LayerData::U16(_) => row.extend((x.round() as u16).to_le_bytes()),
            LayerData::I16(_) => row.extend((x.round() as i16).to_le_bytes()),
            LayerData::U32(_) => row.extend((x.round() as u32).to_le_bytes()),
            LayerData::I32(_) => row.extend((x.round() as i32).to_le_bytes()),
        }
    }
}

/// A corner of a part of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Corner {
    /// Position, from the origin of the lattice.
    pub place: [f64; 3],
    /// Weights of the corners of the triangle.
    pub weights: [f64; 3],
}

/// Corners of a whole triangle.
fn corners(places: [[f64; 3]; 3]) -> Vec<Corner> {
    let weights = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    places.into_iter().zip(weights).map(|(place, weights)| Corner { place, weights }).collect()
}

/// The part of a convex polygon between two planes across an axis; fewer than three corners if there is none.
fn between(polygon: &[Corner], axis: usize, planes: [f64; 2]) -> Vec<Corner> {
    let mut part = Vec::with_capacity(polygon.len() + 2);
    for (from, to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (x, y) = (from.place[axis], to.place[axis]);
        if planes[0] <= x && x <= planes[1] {
            part.push(*from);
        }
        let [first, last] = if x < y { planes } else { [planes[1], planes[0]] };
        for plane in [first, last] {
            if x.min(y) < plane && plane < x.max(y) {
                part.push(at_plane(from, to, axis, plane));
            }
        }
    }
    part
}

/// The parts of a convex polygon in the eighths of a tile. What lies in a plane belongs to the part above it.
fn eighths(polygon: Vec<Corner>, middle: [f64; 3]) -> Vec<Vec<Corner>> {
    let mut parts = vec![polygon];
    for (axis, plane) in middle.into_iter().enumerate() {
        let halves = |part: Vec<Corner>| {
            let is_below = part.iter().any(|corner| corner.place[axis] < plane);
            let is_above = part.iter().any(|corner| corner.place[axis] > plane);
            if !(is_below && is_above) {
                return vec![part];
            }
            [[f64::NEG_INFINITY, plane], [plane, f64::INFINITY]].map(|half| between(&part, axis, half)).into()
        };
        parts = parts.into_iter().flat_map(halves).collect();
    }
    parts
}

/// The point of an edge on a plane.
fn at_plane(from: &Corner, to: &Corner, axis: usize, plane: f64) -> Corner {
    let [low, high] = if from.place[axis] < to.place[axis] { [from, to] } else { [to, from] };
    let share = (plane - low.place[axis]) / (high.place[axis] - low.place[axis]);
    let mix = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]));
    let mut place = mix(low.place, high.place);
    place[axis] = plane;
    Corner { place, weights: mix(low.weights, high.weights) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_a_triangle_are_cut_from_its_own_edges() {
        let triangle = corners([[0.0, 0.0, 0.0], [4.0, 0.0, 1.0], [0.0, 4.0, 2.0]]);
        let parts: Vec<Vec<Corner>> =
            (0..4).map(|i| between(&triangle, 0, [f64::from(i), f64::from(i + 1)])).collect();
        assert_eq!(parts.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4, 4, 3]);
        let on = |part: &[Corner], x: f64| {
            let mut on: Vec<[f64; 3]> = part.iter().map(|c| c.place).filter(|place| place[0] == x).collect();
            on.sort_by(|a, b| a[1].total_cmp(&b[1]));
            on
        };
        for i in 1..4 {
            let x = f64::from(i);
            assert_eq!(on(&parts[i as usize - 1], x), on(&parts[i as usize], x));
            assert_eq!(on(&parts[i as usize], x).len(), 2);
        }
        for corner in parts.iter().flatten() {
            assert!((corner.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        }
        assert!(between(&triangle, 1, [4.5, 5.0]).is_empty());
        // It only touches this interval, so there is no polygon.
        assert!(between(&triangle, 1, [4.0, 5.0]).len() < 3);
    }
}
