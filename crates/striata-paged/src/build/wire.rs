//! Bytes of the parts that tasks pass to each other: plain little-endian arrays, which are written and read once,
//! on one machine or within one cluster.

use striata::mesh::AttributeLayer;
use striata::simplify::cells::{Cell, CellMesh, History};

use super::PagedBuildError;
use crate::{Import, Page, PageId};

/// Number of low bits of keys and errors that are always zero.
const KEY_BITS: u32 = 18;
const ERROR_BITS: u32 = 17;

/// Writes numbers and arrays.
#[derive(Debug)]
pub(super) struct WireWriter {
    pub bytes: Vec<u8>,
    /// Numbers of layers of vertices and of triangles.
    layer_counts: [usize; 2],
}

impl WireWriter {
    /// Creates a writer for meshes with the layers of this one.
    pub(super) fn new(like: &CellMesh) -> Self {
        Self { bytes: Vec::new(), layer_counts: [like.layers.len(), like.triangle_layers.len()] }
    }

    pub(super) fn u32(&mut self, x: u32) {
        self.bytes.extend(x.to_le_bytes());
    }

    fn array<T: bytemuck::NoUninit>(&mut self, values: &[T]) {
        self.u32(values.len() as u32);
        self.bytes.extend_from_slice(bytemuck::cast_slice(values));
    }

    fn layers(&mut self, layers: &[AttributeLayer]) {
        self.layers_of(layers, self.layer_counts[0]);
    }

    fn triangle_layers(&mut self, layers: &[AttributeLayer]) {
        self.layers_of(layers, self.layer_counts[1]);
    }

    fn layers_of(&mut self, layers: &[AttributeLayer], count: usize) {
        // A part without rows may also lack the layers.
        for i in 0..count {
            self.array(layers.get(i).map_or(&[][..], |layer| layer.data.as_bytes()));
        }
    }

    fn histories(&mut self, histories: &[History]) {
        let packed: Vec<[u16; 2]> = histories
            .iter()
            .map(|h| [(h.key.to_bits() >> KEY_BITS) as u16, (h.error.to_bits() >> ERROR_BITS) as u16])
            .collect();
        self.array(&packed);
    }

    /// Triangles, with 16-bit indices if these suffice.
    fn triangles(&mut self, triangles: &[[u32; 3]], vertex_count: usize) {
        if vertex_count <= 1 << 16 {
            let short: Vec<[u16; 3]> = triangles.iter().map(|t| t.map(|v| v as u16)).collect();
            self.array(&short);
        } else {
            self.array(triangles);
        }
    }

    fn mesh(&mut self, mesh: &CellMesh) {
        self.array(&mesh.positions);
        self.layers(&mesh.layers);
        self.triangles(&mesh.triangles, mesh.positions.len());
        let groups: Vec<u32> = mesh.groups.clone();
        self.array(&groups);
        self.triangle_layers(&mesh.triangle_layers);
        self.histories(&mesh.histories);
        self.array(&mesh.waits.iter().map(|(v, _)| *v).collect::<Vec<u32>>());
        self.histories(&mesh.waits.iter().map(|(_, h)| *h).collect::<Vec<History>>());
    }

    pub(super) fn cell(&mut self, cell: &Cell) {
        self.mesh(&cell.inside);
        self.mesh(&cell.border);
        self.array(&cell.is_within.iter().map(|&b| u8::from(b)).collect::<Vec<u8>>());
    }

    /// A page whose imports are not known yet, with the position and layers of each import.
    pub(super) fn steps(&mut self, steps: &PendingPage) {
        let page = &steps.page;
        self.array(&page.positions);
        self.layers(&page.layers);
        self.array(&page.first);
        self.array(&page.targets);
        self.array(&page.keys);
        self.array(&page.errors);
        self.array(&page.triangles);
        self.array(&page.groups);
        self.triangle_layers(&page.triangle_layers);
        self.array(&steps.others);
        self.layers(&steps.other_layers);
    }
}

/// A page before its imports are known.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PendingPage {
    /// The page; its imports are numbers of `others`.
    pub page: Page,
    /// Position of each import, mesh units.
    pub others: Vec<[f32; 3]>,
    /// Layers of the imports.
    pub other_layers: Vec<AttributeLayer>,
}

/// Reads what a [`WireWriter`] wrote.
pub(super) struct WireReader<'a> {
    bytes: &'a [u8],
    /// Layers without values, as all meshes of a build have them.
    like: &'a CellMesh,
}

impl<'a> WireReader<'a> {
    pub(super) fn new(bytes: &'a [u8], like: &'a CellMesh) -> Self {
        Self { bytes, like }
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], PagedBuildError> {
        if count > self.bytes.len() {
            return Err(PagedBuildError::DamagedPart);
        }
        let (taken, rest) = self.bytes.split_at(count);
        self.bytes = rest;
        Ok(taken)
    }

    pub(super) fn u32(&mut self) -> Result<u32, PagedBuildError> {
        let bytes = self.take(4)?;
        Ok(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
    }

    fn array<T: bytemuck::AnyBitPattern + bytemuck::NoUninit>(&mut self) -> Result<Vec<T>, PagedBuildError> {
        let count = self.u32()? as usize;
        let bytes = self.take(count.saturating_mul(size_of::<T>()))?;
        Ok(bytemuck::pod_collect_to_vec(bytes))
    }

    fn layers(&mut self) -> Result<Vec<AttributeLayer>, PagedBuildError> {
        self.layers_like(&self.like.layers)
    }

    fn triangle_layers(&mut self) -> Result<Vec<AttributeLayer>, PagedBuildError> {
        self.layers_like(&self.like.triangle_layers)
    }

    fn layers_like(&mut self, layers: &[AttributeLayer]) -> Result<Vec<AttributeLayer>, PagedBuildError> {
        layers
            .iter()
            .map(|layer| {
                let bytes: Vec<u8> = self.array()?;
                let data = layer.data.from_bytes_like(&bytes);
                Ok(AttributeLayer { data, semantic: layer.semantic.clone(), ..*layer })
            })
            .collect()
    }

    fn histories(&mut self) -> Result<Vec<History>, PagedBuildError> {
        let packed: Vec<[u16; 2]> = self.array()?;
        let history = |[key, error]: [u16; 2]| History {
            key: f32::from_bits(u32::from(key) << KEY_BITS),
            error: f32::from_bits(u32::from(error) << ERROR_BITS),
        };
        Ok(packed.into_iter().map(history).collect())
    }

    fn triangles(&mut self, vertex_count: usize) -> Result<Vec<[u32; 3]>, PagedBuildError> {
        if vertex_count > 1 << 16 {
            return self.array();
        }
        let short: Vec<[u16; 3]> = self.array()?;
        Ok(short.into_iter().map(|t| t.map(u32::from)).collect())
    }

    fn mesh(&mut self) -> Result<CellMesh, PagedBuildError> {
        let positions: Vec<[f32; 3]> = self.array()?;
        let layers = self.layers()?;
        let triangles = self.triangles(positions.len())?;
        let groups = self.array()?;
        let triangle_layers = self.triangle_layers()?;
        let histories = self.histories()?;
        let waiting: Vec<u32> = self.array()?;
        let waits = waiting.into_iter().zip(self.histories()?).collect();
        Ok(CellMesh { positions, layers, triangles, groups, triangle_layers, histories, waits })
    }

    pub(super) fn cell(&mut self) -> Result<Cell, PagedBuildError> {
        let (inside, border) = (self.mesh()?, self.mesh()?);
        let is_within: Vec<u8> = self.array()?;
        Ok(Cell { inside, border, is_within: is_within.into_iter().map(|b| b != 0).collect() })
    }

    pub(super) fn steps(&mut self, id: PageId) -> Result<PendingPage, PagedBuildError> {
        let mut page = Page {
            id,
            positions: self.array()?,
            layers: self.layers()?,
            first: self.array()?,
            targets: self.array()?,
            keys: self.array()?,
            errors: self.array()?,
            imports: Vec::new(),
            triangles: self.array()?,
            groups: self.array()?,
            triangle_layers: self.triangle_layers()?,
        };
        let others: Vec<[f32; 3]> = self.array()?;
        page.imports = (0..others.len() as u32).map(|vertex| Import { page: 0, vertex }).collect();
        Ok(PendingPage { page, others, other_layers: self.layers()? })
    }
}
