//! Sends triangles to the cells of a level.

use std::collections::BTreeMap;

use super::union::append;
use super::{Cell, CellMesh, PartitionLevel};
use crate::mesh::{AttributeLayer, gather_layers};

/// Triangles that have been sent to the cells of a level.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Routed {
    /// Triangles that each cell receives, by number of the cell.
    pub cells: BTreeMap<u32, Cell>,
    /// Border triangles: no cell of this level may change them, so they go on to the next level.
    pub onward: CellMesh,
}

/// Which triangles and vertices of a mesh a cell receives.
#[derive(Default)]
struct CellSelection {
    inside: Vec<u32>,
    border: Vec<u32>,
    lone: Vec<u32>,
}

/// Sends the triangles of `mesh` to the cells of `level`; its lone vertices and waits to the cells that contain
/// their positions.
pub fn route(level: &PartitionLevel, mesh: &CellMesh) -> Routed {
    let cell_of: Vec<u32> = mesh.positions.iter().map(|&p| level.cell_of(p)).collect();
    let mut selections: BTreeMap<u32, CellSelection> = BTreeMap::new();
    let mut onward = Vec::new();
    let mut is_lone = vec![true; mesh.positions.len()];
    for (t, corners) in (0..).zip(&mesh.triangles) {
        corners.iter().for_each(|&v| is_lone[v as usize] = false);
        let [a, b, c] = corners.map(|v| cell_of[v as usize]);
        if a == b && b == c {
            selections.entry(a).or_default().inside.push(t);
            continue;
        }
        onward.push(t);
        for (i, cell) in [a, b, c].into_iter().enumerate() {
            if ![a, b, c][..i].contains(&cell) {
                selections.entry(cell).or_default().border.push(t);
            }
        }
    }
    for &(v, _) in &mesh.waits {
        is_lone[v as usize] = true;
    }
    for v in (0..cell_of.len()).filter(|&v| is_lone[v]) {
        selections.entry(cell_of[v]).or_default().lone.push(v as u32);
    }
    let cell = |(cell, selection): (u32, CellSelection)| {
        let (border, vertices) = mesh.select(&selection.border, &[]);
        let is_within = vertices.iter().map(|&v| cell_of[v as usize] == cell).collect();
        (cell, Cell { inside: mesh.select(&selection.inside, &selection.lone).0, border, is_within })
    };
    Routed { cells: selections.into_iter().map(cell).collect(), onward: mesh.select(&onward, &[]).0 }
}

impl CellMesh {
    /// Copies some triangles, and vertices whether or not these use them; also returns the vertex of `self` that
    /// each vertex of the result is.
    ///
    /// # Panics
    /// If a triangle or a vertex does not exist.
    pub fn select(&self, triangles: &[u32], vertices: &[u32]) -> (Self, Vec<u32>) {
        const NONE: u32 = u32::MAX;
        let mut number = vec![NONE; self.positions.len()];
        let mut sources = Vec::new();
        let mut number_of = |v: u32| {
            if number[v as usize] == NONE {
                number[v as usize] = sources.len() as u32;
                sources.push(v);
            }
            number[v as usize]
        };
        let corners = triangles.iter().map(|&t| self.triangles[t as usize].map(&mut number_of)).collect();
        vertices.iter().for_each(|&v| {
            number_of(v);
        });
        let is_selected: Vec<bool> = {
            let mut is_selected = vec![false; self.positions.len()];
            vertices.iter().for_each(|&v| is_selected[v as usize] = true);
            is_selected
        };
        let waits = self.waits.iter().filter(|(v, _)| is_selected[*v as usize]);
        let waits = waits.map(|&(v, history)| (number[v as usize], history)).collect();
        let of = |t: &u32| *t as usize;
        let out = Self {
            positions: sources.iter().map(|&v| self.positions[v as usize]).collect(),
            layers: self.layers.iter().map(|layer| layer.gather(&sources)).collect(),
            triangles: corners,
            groups: if self.groups.is_empty() {
                Vec::new()
            } else {
                triangles.iter().map(|t| self.groups[of(t)]).collect()
            },
            triangle_layers: gather_layers(&self.triangle_layers, triangles),
            histories: if self.histories.is_empty() {
                Vec::new()
            } else {
                triangles.iter().map(|t| self.histories[of(t)]).collect()
            },
            waits,
        };
        (out, sources)
    }

    /// Appends another part of the same mesh.
    pub fn append(&mut self, other: &Self) {
        let offset = self.positions.len() as u32;
        append_layers(&mut self.layers, &other.layers);
        append_layers(&mut self.triangle_layers, &other.triangle_layers);
        let before = self.triangles.len();
        self.positions.extend_from_slice(&other.positions);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|v| v + offset)));
        let after = self.triangles.len();
        append_per_triangle(&mut self.groups, &other.groups, before, after);
        append_per_triangle(&mut self.histories, &other.histories, before, after);
        self.waits.extend(other.waits.iter().map(|&(v, history)| (v + offset, history)));
    }
}

/// Appends rows of layers; no layers stand for those of the other part without rows.
fn append_layers(layers: &mut Vec<AttributeLayer>, more: &[AttributeLayer]) {
    if layers.is_empty() {
        *layers = gather_layers(more, &[]);
    }
    for (layer, more) in layers.iter_mut().zip(more) {
        append(&mut layer.data, &more.data);
    }
}

/// Appends values of triangles; an empty list stands for default values.
fn append_per_triangle<T: Clone + Default>(values: &mut Vec<T>, more: &[T], before: usize, after: usize) {
    if values.is_empty() && more.is_empty() {
        return;
    }
    values.resize(before, T::default());
    values.extend_from_slice(more);
    values.resize(after, T::default());
}
