//! Points, cells and data of a file, and the mesh that they are.

use std::collections::BTreeMap;

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use super::array::{Array, Role, Values, layer_data};
use super::cells::{CellSurface, Cells, VOLUMES};
use crate::error::{Fault, Place};
use crate::foreign::EXTRACT_SURFACE;
use crate::report::Warnings;

/// Points, cells and data of a file, over all its pieces.
#[derive(Debug, Default)]
pub(super) struct VtkGrid {
    /// Three coordinates of each point.
    points: Option<Values>,
    pub cells: Cells,
    pub point_data: Vec<Array>,
    pub cell_data: Vec<Array>,
}

/// Most values per vertex that a layer may have.
const MAX_COMPONENTS: usize = 255;
/// Most layers that are kept, since each is compared with the others.
const MAX_LAYERS: usize = 1000;

impl VtkGrid {
    pub(super) fn point_count(&self) -> usize {
        self.points.as_ref().map_or(0, |points| points.len() / 3)
    }

    /// Appends the points of a piece, three coordinates each.
    pub(super) fn push_points(&mut self, points: Values) -> Result<(), String> {
        if !points.len().is_multiple_of(3) {
            return Err(format!("{} coordinates are not three per point", points.len()));
        }
        match &mut self.points {
            None => self.points = Some(points),
            Some(known) => {
                if !known.append(&points) {
                    return Err("the points of this piece have another type than those before".to_owned());
                }
            }
        }
        Ok(())
    }

    /// Appends the arrays of a piece to those of the pieces before.
    pub(super) fn push_data(
        &mut self,
        [point_data, cell_data]: [Vec<Array>; 2],
        is_first: bool,
        warnings: &mut Warnings,
    ) {
        for (known, more) in [(&mut self.point_data, point_data), (&mut self.cell_data, cell_data)] {
            if is_first {
                *known = more;
                continue;
            }
            let by_name: BTreeMap<&str, &Array> =
                more.iter().map(|array| (array.name.as_str(), array)).collect();
            known.retain_mut(|array| {
                let same = by_name.get(array.name.as_str());
                let same = same.filter(|other| other.component_count == array.component_count);
                let is_kept = same.is_some_and(|other| array.values.append(&other.values));
                if !is_kept {
                    warnings.push(
                        Place::File,
                        format!("data `{}`: not in all pieces, or of another type; left out", array.name),
                    );
                }
                is_kept
            });
        }
    }

    /// Returns the mesh of all triangles.
    pub(super) fn into_mesh(self, warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
        let (point_count, cell_count) = (self.point_count(), self.cells.len());
        let surface = self.cells.surface();
        report_cells(&surface, warnings)?;
        let mut mesh = IndexedMesh::new(Vec::new(), surface.triangles);
        match self.points {
            // Doubles that single precision cannot hold.
            Some(Values::F64(points))
                if points.iter().any(|&x| f64::from(x as f32) != x && x.is_finite()) =>
            {
                mesh.set_file_positions(points.as_chunks::<3>().0.to_vec());
            }
            Some(points) => mesh.positions = points.floats().as_chunks::<3>().0.to_vec(),
            None => {}
        }
        mesh.layers = layers(self.point_data, point_count, "points", warnings);
        // Normals and texture coordinates belong to vertices.
        let cell_data =
            self.cell_data.into_iter().map(|array| Array { role: Role::Other, ..array }).collect();
        let of_cells = layers(cell_data, cell_count, "cells", warnings);
        mesh.triangle_layers = of_cells.iter().map(|layer| layer.gather(&surface.cells)).collect();
        Ok(mesh)
    }
}

/// Warns of cells that are not part of the surface.
fn report_cells(surface: &CellSurface, warnings: &mut Warnings) -> Result<(), Fault> {
    if surface.triangles.is_empty() && surface.left_out.contains_key(VOLUMES) {
        return Err(Fault::NeedsConversion {
            found: format!(
                "an unstructured grid of {} {VOLUMES} and no triangles",
                surface.left_out[VOLUMES]
            ),
            hint: EXTRACT_SURFACE,
        });
    }
    for (what, count) in &surface.left_out {
        warnings.push(Place::File, format!("{count} cells are left out: {what}, not triangles or polygons"));
    }
    if surface.curved_count > 0 {
        let reason =
            format!("{} curved cells are kept as triangles between their corners", surface.curved_count);
        warnings.push(Place::File, reason);
    }
    Ok(())
}

/// Converts arrays to layers; what cannot be kept is a warning for each array.
fn layers(arrays: Vec<Array>, count: usize, what: &str, warnings: &mut Warnings) -> Vec<AttributeLayer> {
    let mut layers: Vec<AttributeLayer> = Vec::new();
    for array in arrays {
        let name = array.name.clone();
        if layers.len() == MAX_LAYERS {
            warnings.push(Place::File, format!("data beyond the first {MAX_LAYERS} arrays are left out"));
            continue;
        }
        match layer(array, count, what) {
            Ok(mut layer) => {
                if layers.iter().any(|known| known.semantic == layer.semantic) {
                    layer.semantic = Semantic::Generic(unused_name(&name, &layers));
                }
                layers.push(layer);
            }
            Err(reason) => warnings.push(Place::File, format!("data `{name}`: {reason}")),
        }
    }
    layers
}

/// Returns the name, with a number if there is such a layer already.
fn unused_name(name: &str, layers: &[AttributeLayer]) -> String {
    let is_used = |name: &str| {
        layers.iter().any(|layer| matches!(&layer.semantic, Semantic::Generic(known) if known == name))
    };
    let mut candidates = (2..).map(|number| format!("{name}_{number}"));
    if is_used(name) { candidates.find(|name| !is_used(name)).unwrap_or_default() } else { name.to_owned() }
}

fn layer(array: Array, count: usize, what: &str) -> Result<AttributeLayer, String> {
    let Array { name, role, component_count, values } = array;
    let is_float = matches!(values, Values::F32(_) | Values::F64(_));
    if values.len() != count * component_count {
        return Err(format!(
            "{} values for {count} {what} with {component_count} each; left out",
            values.len()
        ));
    }
    if component_count == 0 || component_count > MAX_COMPONENTS {
        return Err(format!("{component_count} values for each of the {what}; left out"));
    }
    let component_count_u8 = component_count as u8;
    let named = Semantic::Generic(name);
    let (semantic, data, normalized) = match (role, component_count, values) {
        (Role::Normals, 3, values) if is_float => (Semantic::Normal, LayerData::F32(values.floats()), false),
        // The origin of VTK's texture coordinates is at the bottom left.
        (Role::TexCoords, 2, values) if is_float => {
            let flip = |(index, x): (usize, f32)| if index % 2 == 1 { 1.0 - x } else { x };
            (
                Semantic::TexCoord(0),
                LayerData::F32(values.floats().into_iter().enumerate().map(flip).collect()),
                false,
            )
        }
        (_, 3 | 4, Values::U8(bytes)) => (Semantic::Color(0), LayerData::U8(bytes), true),
        (_, _, values) => (named, layer_data(values)?, false),
    };
    Ok(AttributeLayer { semantic, component_count: component_count_u8, normalized, data })
}
