//! Detects texture atlases: charts next to each other in one copy of the texture, each part of which is
//! used once or a few times.
//!
//! Wrong atlas coordinates show an unrelated part of the texture; wrong tiled coordinates show the same
//! pattern, shifted.

use glam::{DVec2, Vec3};

use crate::mesh::{AttributeLayer, IndexedMesh, Welded};

/// Cells along each side of the unit square of texture coordinates.
const CELL_COUNT: usize = 512;
/// A material that covers more cells than this uses the texture several times over.
const MAX_CELLS: u64 = 3 * (CELL_COUNT * CELL_COUNT) as u64;
/// Maximum extent of the coordinates along each axis: charts may extend slightly beyond the unit square.
const MAX_EXTENT: f32 = 1.25;
/// Share of the covered cells that may be covered twice.
const MAX_OVERLAP: f64 = 0.6;

/// Returns for each vertex the length on the surface of one unit of its texture coordinates, as a share
/// of the mesh's diagonal, if its material uses `layer` as an atlas; otherwise 0. `scales` are parts of the
/// texture per unit of its coordinates, for each material; a unit is a copy of the texture.
///
/// Takes O(n) time for n triangles, plus the time to rasterize them into 512 by 512 cells.
pub(in crate::simplify) fn atlas_unit_lengths(
    welded: &Welded,
    layer: &AttributeLayer,
    diagonal: f64,
    scales: &[[f32; 2]],
) -> Vec<f32> {
    let mesh = &welded.mesh;
    let mut lengths = vec![0.0; mesh.vertex_count()];
    if layer.component_count < 2 {
        return lengths;
    }
    let mut coverage = TextureCoverage {
        owner: vec![0; CELL_COUNT * CELL_COUNT],
        stamp: 0,
        covered_count: 0,
        repeated_count: 0,
    };
    for (material, slices) in by_material(mesh) {
        let texcoords = ChartTexcoords { layer, scale: scale_of(material, scales) };
        if coverage.is_atlas(&slices, texcoords) {
            let length = unit_length(mesh, &slices, texcoords) / diagonal;
            let length = if length.is_finite() { length as f32 } else { 0.0 };
            for &vertex in slices.iter().flat_map(|slice| slice.as_flattened()) {
                lengths[vertex as usize] = length;
            }
        }
    }
    lengths
}

/// Texture coordinates in copies of the texture.
#[derive(Clone, Copy)]
struct ChartTexcoords<'a> {
    layer: &'a AttributeLayer,
    scale: [f32; 2],
}

impl ChartTexcoords<'_> {
    fn get(self, vertex: u32, axis: usize) -> f32 {
        self.scale[axis] * self.layer.get(vertex as usize, axis)
    }
}

/// Returns the scale of a material's texture coordinates; 1 if none is given.
pub(super) fn scale_of(material: Option<u32>, scales: &[[f32; 2]]) -> [f32; 2] {
    material.and_then(|material| scales.get(material as usize)).copied().unwrap_or([1.0; 2])
}

/// Triangles of a material, in one or more slices.
type Slices<'m> = Vec<&'m [[u32; 3]]>;

/// Returns the triangles of each material.
fn by_material(mesh: &IndexedMesh) -> Vec<(Option<u32>, Slices<'_>)> {
    if mesh.groups.is_empty() {
        return vec![(None, vec![&mesh.triangles])];
    }
    let mut materials: Vec<Option<u32>> = mesh.groups.iter().map(|group| group.material).collect();
    materials.sort_unstable();
    materials.dedup();
    let of = |material| {
        let groups = mesh.groups.iter().filter(move |group| group.material == material);
        (material, groups.map(|group| &mesh.triangles[group.range()]).collect())
    };
    materials.into_iter().map(of).collect()
}

/// Returns the length on the surface of one unit of texture coordinates.
fn unit_length(mesh: &IndexedMesh, slices: &[&[[u32; 3]]], texcoords: ChartTexcoords<'_>) -> f64 {
    let (mut surface, mut texture) = (0.0, 0.0);
    for t in slices.iter().copied().flatten() {
        let [a, b, c] = t.map(|v| Vec3::from(mesh.positions[v as usize]).as_dvec3());
        surface += (b - a).cross(c - a).length();
        let [a, b, c] = t.map(|v| [0, 1].map(|k| f64::from(texcoords.get(v, k)))).map(DVec2::from);
        texture += (b - a).perp_dot(c - a).abs();
    }
    (surface / texture).sqrt()
}

/// Counts the cells whose centers are covered by triangles.
struct TextureCoverage {
    /// Index of the last material that covered each cell.
    owner: Vec<u32>,
    stamp: u32,
    covered_count: u64,
    repeated_count: u64,
}

impl TextureCoverage {
    /// Whether the triangles use each part of the texture about once.
    fn is_atlas(&mut self, slices: &[&[[u32; 3]]], texcoords: ChartTexcoords<'_>) -> bool {
        let corners = || slices.iter().flat_map(|slice| slice.as_flattened());
        for axis in 0..2 {
            let values = || corners().map(|&v| texcoords.get(v, axis));
            let low = values().fold(f32::INFINITY, f32::min);
            let high = values().fold(f32::NEG_INFINITY, f32::max);
            // The extent is not finite if there are no values, or if one is NaN.
            if (high - low).is_nan() || high - low > MAX_EXTENT {
                return false;
            }
        }
        (self.stamp, self.covered_count, self.repeated_count) = (self.stamp + 1, 0, 0);
        for t in slices.iter().copied().flatten() {
            if self.covered_count > MAX_CELLS {
                // Covered several times over.
                return false;
            }
            self.paint(t.map(|v| [0, 1].map(|c| texcoords.get(v, c) * CELL_COUNT as f32 - 0.5)));
        }
        self.repeated_count as f64 <= MAX_OVERLAP * self.covered_count as f64
    }

    fn paint(&mut self, [a, b, c]: [[f32; 2]; 3]) {
        let bounds = |axis: usize| {
            let low = a[axis].min(b[axis]).min(c[axis]).ceil();
            let high = a[axis].max(b[axis]).max(c[axis]).floor();
            (low as i64, high as i64)
        };
        let ((left, right), (bottom, top)) = (bounds(0), bounds(1));
        let side = |p: [f32; 2], q: [f32; 2], x: f32, y: f32| {
            (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])
        };
        for row in bottom..=top {
            for column in left..=right {
                let (x, y) = (column as f32, row as f32);
                let sides = [side(a, b, x, y), side(b, c, x, y), side(c, a, x, y)];
                // Inside if on the same side of all three edges; points on a shared edge count once, up
                // to rounding.
                if sides.iter().all(|&s| s > 0.0) || sides.iter().all(|&s| s < 0.0) {
                    let [row, column] = [row, column].map(|i| i.rem_euclid(CELL_COUNT as i64) as usize);
                    let owner = &mut self.owner[row * CELL_COUNT + column];
                    let is_repeated = std::mem::replace(owner, self.stamp) == self.stamp;
                    self.covered_count += 1;
                    self.repeated_count += u64::from(is_repeated);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{LayerData, Semantic, weld};

    /// A row of squares, each with its own part of the texture; `repeat` scales the texture coordinates.
    fn lengths(count: usize, repeat: f32, overlap: bool) -> Vec<f32> {
        let (mut positions, mut triangles, mut uvs) = (Vec::new(), Vec::new(), Vec::new());
        for i in 0..count {
            let first = positions.len() as u32;
            for (x, y) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
                positions.push([2.0 * i as f32 + x, y, 0.0]);
                let chart = if overlap { 0.0 } else { i as f32 };
                uvs.extend([repeat * (chart + 0.9 * x) / count as f32, repeat * 0.9 * y / count as f32]);
            }
            triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
        let mut mesh = IndexedMesh::new(positions, triangles);
        let layer = AttributeLayer {
            semantic: Semantic::TexCoord(0),
            component_count: 2,
            normalized: false,
            data: LayerData::F32(uvs),
        };
        mesh.layers.push(layer);
        let welded = weld(&mesh).expect("the mesh is valid");
        atlas_unit_lengths(&welded, &welded.mesh.layers[0], welded.mesh.diagonal(), &[])
    }

    #[test]
    fn adjacent_charts_form_an_atlas() {
        let found = lengths(4, 1.0, false);
        // A square of side 1 covers 0.9 / 4 of the texture; the bounds of the row are 7 by 1.
        let expected = (4.0 / 0.9) / 50.0f32.sqrt();
        assert!(found.iter().all(|length| (length - expected).abs() < 1e-4), "{found:?}");
    }

    #[test]
    fn tiled_and_overlapping_charts_are_not_an_atlas() {
        assert!(lengths(4, 8.0, false).iter().all(|&length| length == 0.0), "the texture is repeated");
        assert!(lengths(8, 8.0, true).iter().all(|&length| length == 0.0), "all charts overlap");
    }
}
