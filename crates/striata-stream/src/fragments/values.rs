//! Positions and attributes of the vertices that fragments restore, as differences from the mean of their neighbors.
//!
//! How far a ring spreads and which way it faces say how large differences are.

use striata::mesh::Face;

use super::record::{CodedFragment, NoFragment};
use crate::entropy::{AdaptiveBit, Coder, MixedNumber, Part, Rate};
use crate::format::grid::{CorrectionModel, PositionGrid};
use crate::layers::form::LayerForm;
use crate::layers::model::part_of;

/// Number of classes of sizes.
const CLASSES: usize = 40;
/// Largest distance from the mean of a ring that counts for its normal: products of two fit in 64 bits.
const REACH: i64 = 1 << 24;

/// The values of all vertices of a level: grid points, exact positions, and the integers of each layer.
#[derive(Clone, Debug, Default)]
pub(crate) struct VertexValues {
    pub points: Vec<[i32; 3]>,
    pub positions: Vec<[f32; 3]>,
    /// By layer, then by vertex.
    pub integers: Vec<Vec<i32>>,
}

impl VertexValues {
    /// The values of the first vertices.
    pub(crate) fn first(&self, vertex_count: usize, forms: &[LayerForm]) -> Self {
        let of_layer =
            |(all, form): (&Vec<i32>, &LayerForm)| all[..vertex_count * form.integer_count()].to_vec();
        Self {
            points: self.points[..vertex_count].to_vec(),
            positions: self.positions[..vertex_count].to_vec(),
            integers: self.integers.iter().zip(forms).map(of_layer).collect(),
        }
    }
}

/// Models of values, and the values that were coded.
#[derive(Clone, Debug)]
pub(crate) struct ValueCoder {
    pub values: VertexValues,
    grid: PositionGrid,
    /// Integers of a vertex in each layer.
    integer_counts: Vec<usize>,
    parts: Vec<Part>,
    /// Whether a vertex has the position of the vertex before, as wedges have.
    is_wedge: AdaptiveBit,
    offsets: MixedNumber<4>,
    /// Mean size class of the last offsets, in 1/16.
    recent: usize,
    corrections: Option<CorrectionModel>,
    /// By layer.
    differences: Vec<MixedNumber<2>>,
}

impl ValueCoder {
    /// Starts with the values of a base mesh.
    pub(crate) fn new(values: VertexValues, grid: PositionGrid, forms: &[LayerForm], is_exact: bool) -> Self {
        let integer_counts: Vec<usize> = forms.iter().map(LayerForm::integer_count).collect();
        let differences =
            integer_counts.iter().map(|&count| MixedNumber::new([count * CLASSES, CLASSES * CLASSES], 1));
        Self {
            values,
            grid,
            parts: forms.iter().map(part_of).collect(),
            differences: differences.collect(),
            integer_counts,
            is_wedge: AdaptiveBit::new(Rate::Steady),
            offsets: MixedNumber::new([3 * CLASSES, 4 * CLASSES, CLASSES * CLASSES, 12 * CLASSES], 4),
            recent: 0,
            corrections: is_exact.then(CorrectionModel::new),
        }
    }

    /// Codes the values of the vertices that a fragment restores, which follow those of the level. A writer passes the
    /// values of all vertices.
    ///
    /// # Errors
    /// If a position is outside of the grid.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        fragment: &CodedFragment,
        actual: Option<&VertexValues>,
    ) -> Result<(), NoFragment> {
        let first = self.values.points.len() as u32;
        for vertex in first..first + fragment.own_count {
            let around = CeilingNeighbors::new(&fragment.ceiling, vertex, first);
            coder.part(Part::Positions);
            let at = vertex as usize;
            let known = actual.map(|values| (values.points[at], values.positions[at]));
            let before = at.checked_sub(1).filter(|_| vertex > first);
            let shared = before.map(|before| (self.values.points[before], self.values.positions[before]));
            let is_shared = shared.is_some() && self.is_wedge.code(coder, known == shared);
            let (point, position) = match shared.filter(|_| is_shared) {
                Some(shared) => shared,
                None => self.code_position(coder, &around, known)?,
            };
            self.values.points.push(point);
            self.values.positions.push(position);
            for layer in 0..self.integer_counts.len() {
                coder.part(self.parts[layer]);
                let actual = actual.map(|values| &values.integers[layer][..]);
                self.code_layer(coder, layer, &around, actual);
            }
        }
        Ok(())
    }

    /// Forgets all vertices but the first ones.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        self.values.points.truncate(vertex_count);
        self.values.positions.truncate(vertex_count);
        for (values, count) in self.values.integers.iter_mut().zip(&self.integer_counts) {
            values.truncate(vertex_count * count);
        }
    }

    fn code_position<C: Coder>(
        &mut self,
        coder: &mut C,
        around: &CeilingNeighbors,
        known: Option<([i32; 3], [f32; 3])>,
    ) -> Result<([i32; 3], [f32; 3]), NoFragment> {
        let points = &self.values.points;
        let ring = &around.neighbors;
        let guess = [0, 1, 2].map(|axis| mean(ring.iter().map(|&v| points[v as usize][axis])));
        let spreads =
            [0, 1, 2].map(|axis| spread(guess[axis], ring.iter().map(|&v| points[v as usize][axis])));
        let normal = around.normal_classes(points, guess);
        let size = class_of(spreads.iter().sum());
        let (actual, exact) = known.unwrap_or_default();
        let mut point = [0; 3];
        let (mut before, mut sum) = (0, 0);
        for axis in 0..3 {
            let contexts = [
                axis * CLASSES + class_of(spreads[axis]),
                normal[axis] * CLASSES + size,
                before * CLASSES + size,
                (axis * 4 + normal[axis]) * CLASSES + self.recent / 16,
            ];
            let wanted = actual[axis].wrapping_sub(guess[axis]);
            let offset = self.offsets.signed(coder, (contexts, normal[axis]), wanted);
            point[axis] = guess[axis].wrapping_add(offset);
            before = before.max(class_of(offset.unsigned_abs().into()));
            sum += u64::from(offset.unsigned_abs());
        }
        self.recent = (self.recent * 15).div_ceil(16) + class_of(sum);
        if !self.grid.contains(point) {
            return Err(NoFragment);
        }
        let position = match &mut self.corrections {
            Some(model) => model.code(coder, &self.grid, point, exact),
            None => self.grid.position(point),
        };
        Ok((point, position))
    }

    fn code_layer<C: Coder>(
        &mut self,
        coder: &mut C,
        layer: usize,
        around: &CeilingNeighbors,
        actual: Option<&[i32]>,
    ) {
        let count = self.integer_counts[layer];
        let mut before = 0;
        for component in 0..count {
            let values = &self.values.integers[layer];
            let of_ring = around.neighbors.iter().map(|&v| values[v as usize * count + component]);
            let guess = mean(of_ring.clone());
            let class = class_of(spread(guess, of_ring));
            let known = actual.map_or(0, |values| values[around.vertex as usize * count + component]);
            let contexts = [component * CLASSES + class, before * CLASSES + class];
            let wanted = known.wrapping_sub(guess);
            let difference = self.differences[layer].signed(coder, (contexts, 0), wanted);
            before = class_of(difference.unsigned_abs().into());
            self.values.integers[layer].push(guess.wrapping_add(difference));
        }
    }
}

/// A restored vertex and the older vertices next to it.
struct CeilingNeighbors {
    vertex: u32,
    /// Ascending; those of all restored vertices if it has none.
    neighbors: Vec<u32>,
    /// The sides across from the vertex whose ends are older.
    sides: Vec<[u32; 2]>,
}

impl CeilingNeighbors {
    /// Finds the neighbors among the vertices before `first`.
    fn new(ceiling: &[Face], vertex: u32, first: u32) -> Self {
        let of = |wanted: &dyn Fn(&Face) -> bool| {
            let corners = ceiling.iter().filter(|face| wanted(face)).flat_map(|face| face.corners);
            let mut found: Vec<u32> = corners.filter(|&v| v < first).collect();
            found.sort_unstable();
            found.dedup();
            found
        };
        let own = of(&|face| face.corners.contains(&vertex));
        let sides = ceiling.iter().flat_map(|face| {
            let [a, b, c] = face.corners;
            [([b, c], a), ([c, a], b), ([a, b], c)]
        });
        let across = sides.filter(|&(side, apex)| apex == vertex && side[0].max(side[1]) < first);
        let sides = across.map(|(side, _)| side).collect();
        Self { vertex, neighbors: if own.is_empty() { of(&|_| true) } else { own }, sides }
    }

    /// How much of the normal of the ring lies along each axis: 0 (little) to 3 (almost all).
    fn normal_classes(&self, points: &[[i32; 3]], center: [i32; 3]) -> [usize; 3] {
        let off = |v: u32| {
            [0, 1, 2].map(|axis| {
                i64::from(points[v as usize][axis].wrapping_sub(center[axis])).clamp(-REACH, REACH)
            })
        };
        let mut normal = [0i64; 3];
        for &[a, b] in &self.sides {
            let (a, b) = (off(a), off(b));
            for (axis, sum) in normal.iter_mut().enumerate() {
                let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                *sum = sum.saturating_add(a[next] * b[last] - a[last] * b[next]);
            }
        }
        let length: u64 = normal.iter().map(|part| part.unsigned_abs() >> 2).sum();
        normal.map(|part| (((part.unsigned_abs() >> 2) * 4).checked_div(length).unwrap_or(0) as usize).min(3))
    }
}

/// Mean distance of integers from their mean.
fn spread(mean: i32, values: impl Iterator<Item = i32>) -> u64 {
    let (sum, count) =
        values.fold((0, 0), |(sum, count), value| (sum + u64::from(value.abs_diff(mean)), count + 1));
    sum.checked_div(count).unwrap_or(0)
}

/// Class of a size, two for each doubling, below [`CLASSES`].
fn class_of(size: u64) -> usize {
    match size {
        0 | 1 => size as usize,
        _ => ((2 * size.ilog2() + (size >> (size.ilog2() - 1) & 1) as u32) as usize).min(CLASSES - 1),
    }
}

/// Mean of integers, rounded toward zero; 0 of none.
fn mean(values: impl Iterator<Item = i32>) -> i32 {
    let (mut sum, mut count) = (0i64, 0i64);
    values.for_each(|value| (sum, count) = (sum + i64::from(value), count + 1));
    if count == 0 { 0 } else { (sum / count) as i32 }
}

#[cfg(test)]
mod tests {
    use striata::mesh::{FragmentedMesh, IndexedMesh, shapes};
    use striata::simplify::{RemovalOptions, build_fragments};

    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};
    use crate::layers::options::LayerOptions;

    fn values_of(mesh: &IndexedMesh, grid: &PositionGrid, forms: &[LayerForm]) -> VertexValues {
        VertexValues {
            points: mesh.positions.iter().map(|&position| grid.quantize(position)).collect(),
            positions: mesh.positions.clone(),
            integers: mesh.layers.iter().zip(forms).map(|(layer, form)| form.integers(layer)).collect(),
        }
    }

    #[test]
    fn positions_and_layers_come_back() {
        for mesh in [shapes::icosphere(3, 1.0), shapes::two_material_sphere(12, 16), shapes::terrain(20, 3)] {
            let FragmentedMesh { mesh, fragments } =
                build_fragments(&mesh, &RemovalOptions::default()).expect("a sound mesh").fragmented;
            let grid = PositionGrid::from_bits(&mesh.bounds().expect("vertices"), 12).expect("a grid");
            let forms: Vec<LayerForm> =
                mesh.layers.iter().map(|layer| LayerForm::of(layer, &LayerOptions::default())).collect();
            let all = values_of(&mesh, &grid, &forms);
            for is_exact in [false, true] {
                let base = fragments.levels().vertex_count_at(0);
                let new = || ValueCoder::new(all.first(base, &forms), grid, &forms, is_exact);
                let coded = |step: u32| CodedFragment {
                    own_count: fragments.levels().step_vertices(step as usize).len() as u32,
                    floor: Vec::new(),
                    ceiling: fragments.ceiling(step).map(|face| fragments.faces()[face as usize]).collect(),
                };
                let (mut writer, mut coder) = (RangeWriter::new(), new());
                for step in 0..fragments.step_count() as u32 {
                    coder.code(&mut writer, &coded(step), Some(&all)).expect("values on the grid");
                }
                let bytes = writer.finish().0;
                let (mut reader, mut coder) = (RangeReader::new(&bytes, true), new());
                for step in 0..fragments.step_count() as u32 {
                    coder.code(&mut reader, &coded(step), None).expect("values on the grid");
                }
                assert_eq!(coder.values.points, all.points);
                assert_eq!(coder.values.integers, all.integers);
                if is_exact {
                    assert_eq!(coder.values.positions, all.positions);
                }
            }
        }
    }
}
