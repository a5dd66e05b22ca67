//! Grids of positions.

use std::collections::BTreeMap;

use crate::error::Place;
use crate::gltf::accessor::accessor;
use crate::gltf::component_type::GltfComponentType;
use crate::gltf::document::GltfDocument;
use crate::gltf::passes::primitives::PassPrimitive;
use crate::report::Warnings;

/// Grid that positions are rounded to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MeshGrid {
    /// Position of the grid point with the coordinates 0.
    pub origin: [f64; 3],
    /// Side of a cell in mesh units.
    pub step: f32,
    /// Largest coordinate.
    pub last: u32,
    /// Whether nodes must convert it without rounding, because other meshes have the same grid.
    pub is_shared: bool,
}

impl MeshGrid {
    /// Returns the coordinates of the grid point next to a position.
    pub(super) fn rounded(&self, position: [f32; 3]) -> [u32; 3] {
        [0, 1, 2].map(|i| {
            let steps = (f64::from(position[i]) - self.origin[i]) / f64::from(self.step);
            steps.round().clamp(0.0, f64::from(self.last)) as u32
        })
    }
}

/// Grids of all meshes.
#[derive(Debug)]
pub(in crate::gltf::passes) struct Grids {
    /// Grids; [`None`] if the meshes that would share it cannot be quantized.
    pub(super) grids: Vec<Option<MeshGrid>>,
    /// Number of the grid of each mesh.
    pub(super) of_mesh: Vec<usize>,
}

impl Grids {
    /// Returns the number of a mesh's grid, unless its positions are not quantized.
    pub(super) fn number(&self, mesh: usize) -> Option<usize> {
        let &number = self.of_mesh.get(mesh)?;
        self.grids[number].map(|_| number)
    }

    /// Returns two opposite corners of the cube of the grid of a mesh, and the bits of a coordinate in it; [`None`]
    /// if its positions are not quantized.
    #[cfg(feature = "draco")]
    pub(in crate::gltf::passes) fn cube(&self, mesh: usize) -> Option<([[f32; 3]; 2], u32)> {
        let grid = self.grids[self.number(mesh)?]?;
        let bits = grid.last.max(1).ilog2() + 1;
        let side = f64::from(grid.step) * f64::from((1u32 << bits) - 1);
        Some(([grid.origin.map(|x| x as f32), grid.origin.map(|x| (x + side) as f32)], bits))
    }

    /// Warns if rounding makes more than one in a thousand positions fall on others, such as because one vertex is so
    /// far away that the grid is coarser than everything else. Cost: sorts all positions.
    pub(in crate::gltf::passes) fn warn_of_merging(
        &self,
        document: &GltfDocument<'_>,
        primitives: &[PassPrimitive],
        warnings: &mut Warnings,
    ) {
        let positions = |primitive: &PassPrimitive| Some((primitive.attribute("POSITION")?, primitive.mesh));
        let mesh_of: BTreeMap<u64, usize> = primitives.iter().filter_map(positions).collect();
        let (mut merged, mut all) = (0, 0);
        for (accessor, mesh) in mesh_of {
            let Some(grid) = self.number(mesh).and_then(|number| self.grids[number]) else { continue };
            let Some(numbers) = positions_of(document, accessor) else { continue };
            let points = numbers.as_chunks::<3>().0;
            let apart = distinct(points.iter().map(|point| point.map(|x| (x + 0.0).to_bits())).collect());
            merged += apart - distinct(points.iter().map(|&point| grid.rounded(point)).collect());
            all += points.len();
        }
        if merged * 1000 > all {
            let reason = format!(
                "at this precision, {merged} of {all} vertices fall on others; more bits or no quantization keeps them apart"
            );
            warnings.push(Place::File, reason);
        }
    }

    /// Gives up the quantization of all meshes that share a grid.
    pub(super) fn drop_grid(&mut self, number: usize) {
        self.grids[number] = None;
    }
}

fn distinct(mut values: Vec<[u32; 3]>) -> usize {
    values.sort_unstable();
    values.dedup();
    values.len()
}

/// Axis-aligned box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Box3 {
    pub min: [f32; 3],
    pub max: [f32; 3],
}

impl Box3 {
    pub(super) const EMPTY: Self = Self { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };

    pub(super) fn joined(self, other: Self) -> Self {
        let axes = [0, 1, 2];
        Self {
            min: axes.map(|i| self.min[i].min(other.min[i])),
            max: axes.map(|i| self.max[i].max(other.max[i])),
        }
    }

    /// Longest side.
    pub(super) fn side(&self) -> f64 {
        let sides = [0, 1, 2].map(|i| f64::from(self.max[i]) - f64::from(self.min[i]));
        sides.into_iter().fold(0.0, f64::max)
    }

    /// Returns the grid that covers the box; [`None`] if it is empty or its size exceeds all numbers.
    pub(super) fn grid(&self, bits: u32) -> Option<MeshGrid> {
        let last = (1u32 << bits.clamp(1, 16)) - 1;
        let side = self.side();
        if !self.min[0].is_finite() || !side.is_finite() {
            return None;
        }
        let step = (side / f64::from(last)) as f32;
        let step = if step >= f32::MIN_POSITIVE { step } else { 1.0 };
        // Steps so small that they vanish next to the coordinates, or too large, make no grid.
        (step.is_finite() && side <= f64::from(step) * f64::from(last) * 1.001).then_some(MeshGrid {
            origin: self.min.map(f64::from),
            step,
            last,
            is_shared: false,
        })
    }
}

/// Returns positions; [`None`] if they are not finite floats.
pub(super) fn positions_of(document: &GltfDocument<'_>, index: u64) -> Option<Vec<f32>> {
    let positions = accessor(document, index, &document.root).ok()?;
    if positions.component != GltfComponentType::F32 || positions.component_count != 3 || positions.count == 0
    {
        return None;
    }
    let numbers = positions.floats();
    numbers.iter().all(|x| x.is_finite()).then_some(numbers)
}

/// Returns the bounding box of positions; [`None`] if they are not finite floats.
pub(super) fn bounding_box(document: &GltfDocument<'_>, index: u64) -> Option<Box3> {
    let numbers = positions_of(document, index)?;
    let points = numbers.as_chunks::<3>().0.iter();
    Some(points.fold(Box3::EMPTY, |bounds, &point| bounds.joined(Box3 { min: point, max: point })))
}
