//! The union of a cell's inside and border triangles, welded.

use super::{Cell, CellMesh, History};
use crate::mesh::{
    Appearance, AttributeLayer, IndexedMesh, LayerData, Material, MeshError, TriangleGroup, Welded, weld,
};

/// A welded cell. Its triangles are sorted by group; those inside come from `inside_of`.
pub(super) struct CellUnion {
    pub welded: Welded,
    /// For each welded triangle, the triangle of the inside part that it is; `u32::MAX` for the border.
    pub inside_of: Vec<u32>,
    /// For each position, whether it belongs to the cell.
    pub is_within: Vec<bool>,
    /// Corners of border triangles, as vertices of the input of welding.
    pub locked_vertices: Vec<u32>,
    /// History of each position that must be respected although no triangle of it tells.
    pub waits: Vec<(u32, History)>,
    /// Vertices of the inside part without triangles at the position, by position.
    pub lone: Vec<(u32, u32)>,
}

/// Marks a triangle of the border.
pub(super) const BORDER: u32 = u32::MAX;

impl CellUnion {
    pub(super) fn new(cell: &Cell, materials: &[Option<u32>]) -> Result<Self, MeshError> {
        let inside_count = cell.inside.positions.len() as u32;
        let (order, groups) = by_group(cell, materials);
        let triangle = |&t: &u32| {
            let inside = cell.inside.triangles.len() as u32;
            if t < inside {
                cell.inside.triangles[t as usize]
            } else {
                cell.border.triangles[(t - inside) as usize].map(|v| v + inside_count)
            }
        };
        let mesh = IndexedMesh {
            positions: [cell.inside.positions.as_slice(), &cell.border.positions].concat(),
            layers: joined_layers(&cell.inside, &cell.border),
            triangles: order.iter().map(triangle).collect(),
            triangle_layers: Vec::new(),
            origin: [0.0; 3],
            exact_positions: Vec::new(),
            groups,
            appearance: Appearance {
                materials: vec![
                    Material::default();
                    materials.iter().flatten().max().map_or(0, |&m| m as usize + 1)
                ],
                ..Appearance::default()
            },
        };
        let is_proper = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| mesh.positions[v as usize].map(|x| x + 0.0));
            a != b && b != c && c != a
        };
        let inside = cell.inside.triangles.len() as u32;
        let kept = order.iter().zip(&mesh.triangles).filter(|(_, t)| is_proper(t));
        let inside_of = kept.map(|(&t, _)| if t < inside { t } else { BORDER }).collect();
        let welded = weld(&mesh)?;
        let mut union = Self {
            is_within: vec![true; welded.positions.position_count()],
            welded,
            inside_of,
            locked_vertices: cell.border.triangles.as_flattened().iter().map(|v| v + inside_count).collect(),
            waits: Vec::new(),
            lone: Vec::new(),
        };
        union.locate(cell);
        Ok(union)
    }

    /// Finds the positions of border vertices, waits and lone vertices.
    fn locate(&mut self, cell: &Cell) {
        let inside_count = cell.inside.positions.len();
        let position_of = &self.welded.position_of_source;
        for (v, _) in cell.is_within.iter().enumerate().filter(|(_, is_within)| !**is_within) {
            if let Some(is_within) = self.is_within.get_mut(position_of[inside_count + v] as usize) {
                *is_within = false;
            }
        }
        let known = |v: u32| Some(position_of[v as usize]).filter(|&p| p != u32::MAX);
        for &(v, history) in &cell.inside.waits {
            self.waits.extend(known(v).map(|p| (p, history)));
        }
        let mut is_used = vec![false; inside_count];
        for &v in cell.inside.triangles.as_flattened() {
            is_used[v as usize] = true;
        }
        let unused = (0..inside_count as u32).filter(|&v| !is_used[v as usize]);
        self.lone = unused.filter_map(|v| known(v).map(|p| (p, v))).collect();
        self.drop_known_wedges(cell);
    }

    /// Drops lone vertices that equal a wedge with triangles or another lone vertex.
    fn drop_known_wedges(&mut self, cell: &Cell) {
        let key = |layers: &[AttributeLayer], v: u32| -> Vec<u8> {
            let bytes = layers.iter().flat_map(|layer| {
                let n = layer.vertex_bytes();
                layer.data.as_bytes()[v as usize * n..][..n].to_vec()
            });
            bytes.collect()
        };
        let mut lone: Vec<(u32, Vec<u8>, u32)> =
            self.lone.iter().map(|&(p, v)| (p, key(&cell.inside.layers, v), v)).collect();
        lone.sort();
        lone.dedup_by(|a, b| (a.0, &a.1) == (b.0, &b.1));
        let welded = &self.welded;
        lone.retain(|(p, bytes, _)| {
            welded.positions.wedges(*p).all(|w| key(&welded.mesh.layers, w) != *bytes)
        });
        self.lone = lone.into_iter().map(|(p, _, v)| (p, v)).collect();
    }
}

/// Orders all triangles by group; returns the order and the groups.
fn by_group(cell: &Cell, materials: &[Option<u32>]) -> (Vec<u32>, Vec<TriangleGroup>) {
    let count = cell.inside.triangles.len() + cell.border.triangles.len();
    let mut order: Vec<u32> = (0..count as u32).collect();
    if cell.inside.groups.is_empty() && cell.border.groups.is_empty() {
        return (order, Vec::new());
    }
    let all = |mesh: &CellMesh| {
        let mut groups = mesh.groups.clone();
        groups.resize(mesh.triangles.len(), 0);
        groups
    };
    let of = [all(&cell.inside), all(&cell.border)].concat();
    order.sort_by_key(|&t| of[t as usize]);
    let mut groups: Vec<TriangleGroup> = Vec::new();
    for (i, run) in order.chunk_by(|&a, &b| of[a as usize] == of[b as usize]).enumerate() {
        let first = if i == 0 { 0 } else { groups[i - 1].first + groups[i - 1].count };
        let material = materials.get(of[run[0] as usize] as usize).copied().flatten();
        groups.push(TriangleGroup { material, first, count: run.len() as u32, ..TriangleGroup::default() });
    }
    (order, groups)
}

/// Layers of two parts, one after the other.
fn joined_layers(inside: &CellMesh, border: &CellMesh) -> Vec<AttributeLayer> {
    let layers = if inside.layers.is_empty() { &border.layers } else { &inside.layers };
    (0..layers.len())
        .map(|i| {
            let mut layer = layers[i].clone();
            if let (Some(_), Some(more)) = (inside.layers.get(i), border.layers.get(i)) {
                append(&mut layer.data, &more.data);
            }
            layer
        })
        .collect()
}

/// Appends values of the same type.
pub(super) fn append(data: &mut LayerData, more: &LayerData) {
    // Parts of one mesh have the same layers.
    let is_one_type = data.extend_from(more);
    debug_assert!(is_one_type, "parts of one mesh have the same layers");
}
