//! Positions and attributes of the vertices that fragments restore, as differences from the mean of their neighbors.

use striata::mesh::Face;

use super::record::{CodedFragment, NoFragment};
use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Part, Rate};
use crate::format::grid::{CorrectionModel, PositionGrid};
use crate::layers::form::LayerForm;
use crate::layers::model::part_of;

/// The values of all vertices of a level: grid points, exact positions, and the integers of each layer.
#[derive(Clone, Debug, Default)]
pub(crate) struct VertexValues {
    pub(crate) points: Vec<[i32; 3]>,
    pub(crate) positions: Vec<[f32; 3]>,
    /// By layer, then by vertex.
    pub(crate) integers: Vec<Vec<i32>>,
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
    pub(crate) values: VertexValues,
    grid: PositionGrid,
    /// Integers of a vertex in each layer.
    integer_counts: Vec<usize>,
    parts: Vec<Part>,
    /// Whether a vertex has the position of the vertex before, as wedges have.
    is_wedge: AdaptiveBit,
    /// By axis.
    offsets: AdaptiveNumber,
    corrections: Option<CorrectionModel>,
    /// By layer; a context for each integer of a vertex.
    differences: Vec<AdaptiveNumber>,
}

impl ValueCoder {
    /// Starts with the values of a base mesh.
    pub(crate) fn new(values: VertexValues, grid: PositionGrid, forms: &[LayerForm], is_exact: bool) -> Self {
        let integer_counts: Vec<usize> = forms.iter().map(LayerForm::integer_count).collect();
        let differences =
            integer_counts.iter().map(|&count| AdaptiveNumber::new(count, Rate::Steady)).collect();
        Self {
            values,
            grid,
            parts: forms.iter().map(part_of).collect(),
            integer_counts,
            is_wedge: AdaptiveBit::new(Rate::Steady),
            offsets: AdaptiveNumber::new(3, Rate::Steady),
            corrections: is_exact.then(CorrectionModel::new),
            differences,
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
            let around = Neighborhood::new(&fragment.ceiling, vertex, first);
            coder.part(Part::Positions);
            let at = vertex as usize;
            let known = actual.map(|values| (values.points[at], values.positions[at]));
            let before = at.checked_sub(1).filter(|_| vertex > first);
            let shared = before.map(|before| (self.values.points[before], self.values.positions[before]));
            let is_shared = shared.is_some() && self.is_wedge.code(coder, known == shared);
            let (point, position) = match shared.filter(|_| is_shared) {
                Some(shared) => shared,
                None => self.code_position(coder, &around.neighbors, known)?,
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
        around: &[u32],
        known: Option<([i32; 3], [f32; 3])>,
    ) -> Result<([i32; 3], [f32; 3]), NoFragment> {
        let guess = [0, 1, 2].map(|axis| mean(around.iter().map(|&v| self.values.points[v as usize][axis])));
        let (actual, exact) = known.unwrap_or_default();
        let mut point = [0; 3];
        for axis in 0..3 {
            let offset = self.offsets.signed(coder, axis, actual[axis].wrapping_sub(guess[axis]));
            point[axis] = guess[axis].wrapping_add(offset);
        }
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
        around: &Neighborhood,
        actual: Option<&[i32]>,
    ) {
        let count = self.integer_counts[layer];
        for component in 0..count {
            let values = &self.values.integers[layer];
            let guess = mean(around.neighbors.iter().map(|&v| values[v as usize * count + component]));
            let known = actual.map_or(0, |values| values[around.vertex as usize * count + component]);
            let difference = self.differences[layer].signed(coder, component, known.wrapping_sub(guess));
            self.values.integers[layer].push(guess.wrapping_add(difference));
        }
    }
}

/// A restored vertex and the older vertices next to it.
struct Neighborhood {
    vertex: u32,
    /// Ascending; those of all restored vertices if it has none.
    neighbors: Vec<u32>,
}

impl Neighborhood {
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
        Self { vertex, neighbors: if own.is_empty() { of(&|_| true) } else { own } }
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
