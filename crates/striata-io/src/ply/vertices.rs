//! PlyVertices of a PLY file as rows of bytes, and their columns as positions and layers.

use std::borrow::Cow;
use std::collections::BTreeSet;

use striata::mesh::{AttributeLayer, LayerData, Semantic, relative_position};

use super::column::Column;
use super::header::{Element, Header, Scalar};
use super::names::{ColumnSet, column_sets};
use super::texcoords::flip;
use crate::error::{Fault, Place};

/// Vertex element without its lists: `count` rows of `stride` little-endian bytes.
pub(crate) struct PlyVertices<'a> {
    pub rows: Cow<'a, [u8]>,
    pub count: usize,
    pub stride: usize,
    pub columns: Vec<Column>,
    /// Whether the rows are those of triangles.
    pub of_triangles: bool,
}

pub(super) fn columns_of(element: &Element) -> (Vec<Column>, usize) {
    let mut offset = 0;
    let mut columns = Vec::new();
    for property in element.properties.iter().filter(|p| p.list.is_none()) {
        let (name, scalar) = (property.name.clone(), property.scalar);
        columns.push(Column { name, scalar, offset, is_flipped: false });
        offset += property.scalar.bytes();
    }
    (columns, offset)
}

/// Returns the columns, those with texture coordinates marked.
#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
pub(crate) fn flipped_columns_of(element: &Element) -> Vec<Column> {
    let (mut columns, _) = columns_of(element);
    super::texcoords::mark_flipped(&mut columns);
    columns
}

impl<'a> PlyVertices<'a> {
    /// Wraps whole rows of little-endian bytes, of any number; their texture coordinates count from the top
    /// of the image if `has_top_origin` is set.
    #[cfg(all(any(feature = "blocks", feature = "pieces"), not(target_family = "wasm")))]
    pub(crate) fn of_rows(element: &Element, rows: Cow<'a, [u8]>, has_top_origin: bool) -> Self {
        let (mut columns, stride) = columns_of(element);
        if has_top_origin {
            super::texcoords::mark_flipped(&mut columns);
        }
        Self { count: rows.len() / stride.max(1), rows, stride, columns, of_triangles: false }
    }

    /// Wraps whole rows of triangles.
    pub(super) fn of_triangles(rows: Cow<'a, [u8]>, columns: Vec<Column>, stride: usize) -> Self {
        Self { count: rows.len() / stride.max(1), rows, stride, columns, of_triangles: true }
    }
}

impl PlyVertices<'_> {
    /// Returns the columns of x, y and z; [`None`] if there are no vertices and no such columns.
    fn axes(&self, header: &Header) -> Result<Option<[&Column; 3]>, Fault> {
        let mut axes = Vec::with_capacity(3);
        for name in ["x", "y", "z"] {
            let Some(column) = self.columns.iter().find(|c| c.name == name) else {
                if header.vertex()?.count == 0 {
                    return Ok(None);
                }
                let reason = format!("the element `vertex` has no property `{name}`");
                return Err(Fault::Malformed(Place::File, reason));
            };
            axes.push(column);
        }
        Ok(Some([axes[0], axes[1], axes[2]]))
    }

    /// Returns the positions of all vertices relative to an origin.
    pub(crate) fn positions(&self, header: &Header, origin: [f64; 3]) -> Result<Vec<[f32; 3]>, Fault> {
        let Some(axes) = self.axes(header)? else { return Ok(Vec::new()) };
        let [x, y, z] = axes.map(|column| column.offset);
        let are_floats = axes.iter().all(|c| c.scalar == Scalar::F32);
        if are_floats && y == x + 4 && z == x + 8 && origin == [0.0; 3] {
            let position = |row: &[u8]| [f32_at(row, 0), f32_at(row, 4), f32_at(row, 8)];
            return Ok(self.rows().map(|row| position(&row[x..x + 12])).collect());
        }
        Ok(self.rows().map(|row| relative_position(axes.map(|column| to_f64(row, column)), origin)).collect())
    }

    /// Returns the coordinates of all vertices in doubles, if single precision cannot hold their type.
    pub(crate) fn file_positions(&self, header: &Header) -> Result<Option<Vec<[f64; 3]>>, Fault> {
        let Some(axes) = self.axes(header)? else { return Ok(None) };
        if !axes.iter().any(|column| matches!(column.scalar, Scalar::F64 | Scalar::I32 | Scalar::U32)) {
            return Ok(None);
        }
        Ok(Some(self.rows().map(|row| axes.map(|column| to_f64(row, column))).collect()))
    }

    fn rows(&self) -> impl ExactSizeIterator<Item = &[u8]> {
        debug_assert_eq!(self.rows.len(), self.count * self.stride, "rows are whole");
        self.rows.chunks_exact(self.stride.max(1))
    }

    /// Returns the attribute layers of all vertices.
    pub(crate) fn layers(&self, header: &Header) -> Vec<AttributeLayer> {
        let mut seen = BTreeSet::new();
        let sets = column_sets(&self.columns, self.of_triangles);
        let first_of_its_name = |set: &&ColumnSet<'_>| seen.insert(set.semantic.clone());
        sets.iter().filter(first_of_its_name).map(|set| self.layer(set, header)).collect()
    }

    fn layer(&self, set: &ColumnSet<'_>, header: &Header) -> AttributeLayer {
        let semantic = set.semantic.clone();
        let component_count = set.columns.len() as u8;
        let (data, normalized) = match (&semantic, set.columns[0].scalar) {
            (Semantic::Normal | Semantic::Tangent, _) => (self.floats(set), false),
            (Semantic::MorphPosition(_) | Semantic::MorphNormal(_) | Semantic::MorphTangent(_), _) => {
                (self.floats(set), false)
            }
            (Semantic::Color(_), Scalar::I16 | Scalar::I32 | Scalar::U32) => {
                (self.gathered(set, |row, c| (to_f64(row, c) / 255.0) as f32, LayerData::F32), false)
            }
            (Semantic::Color(_) | Semantic::TexCoord(_) | Semantic::Weights(_), scalar) => {
                (self.typed(set), matches!(scalar, Scalar::U8 | Scalar::U16))
            }
            (Semantic::Generic(name), _) => {
                let names = if self.of_triangles { &header.normalized_faces } else { &header.normalized };
                (self.typed(set), names.contains(name))
            }
            (Semantic::Joints(_), _) => (self.typed(set), false),
        };
        let mut layer = AttributeLayer { semantic, component_count, normalized, data };
        if !self.of_triangles && !set.columns.iter().any(|column| column.is_flipped) {
            flip(&mut layer);
        }
        layer
    }

    /// Returns the columns in their own type.
    fn typed(&self, set: &ColumnSet<'_>) -> LayerData {
        match set.columns[0].scalar {
            Scalar::U8 => self.gathered(set, |row, c| row[c.offset], LayerData::U8),
            Scalar::U16 => self.gathered(set, |row, c| to_f64(row, c) as u16, LayerData::U16),
            Scalar::U32 => self.gathered(set, |row, c| to_f64(row, c) as u32, LayerData::U32),
            Scalar::I8 => self.gathered(set, |row, c| row[c.offset] as i8, LayerData::I8),
            Scalar::I16 => self.gathered(set, |row, c| to_f64(row, c) as i16, LayerData::I16),
            Scalar::I32 => self.gathered(set, |row, c| to_f64(row, c) as i32, LayerData::I32),
            Scalar::F32 | Scalar::F64 => self.floats(set),
        }
    }

    fn floats(&self, set: &ColumnSet<'_>) -> LayerData {
        if set.columns.iter().all(|c| c.scalar == Scalar::F32) {
            return self.gathered(set, |row, c| f32_at(row, c.offset), LayerData::F32);
        }
        if set.columns.iter().all(|c| c.scalar == Scalar::F64) {
            return self.gathered(set, to_f64, LayerData::F64);
        }
        self.gathered(set, |row, c| to_f64(row, c) as f32, LayerData::F32)
    }

    fn gathered<T>(
        &self,
        set: &ColumnSet<'_>,
        number: impl Fn(&[u8], &Column) -> T,
        data: impl Fn(Vec<T>) -> LayerData,
    ) -> LayerData {
        let mut out = Vec::with_capacity(self.count * set.columns.len());
        for row in self.rows() {
            out.extend(set.columns.iter().map(|&column| number(row, column)));
        }
        data(out)
    }
}

#[inline]
fn f32_at(row: &[u8], offset: usize) -> f32 {
    f32::from_le_bytes([row[offset], row[offset + 1], row[offset + 2], row[offset + 3]])
}

/// Converts any number of a row; every type fits into an `f64` exactly.
fn to_f64(row: &[u8], column: &Column) -> f64 {
    let mut word = [0u8; 8];
    let length = column.scalar.bytes();
    word[..length].copy_from_slice(&row[column.offset..column.offset + length]);
    let value = u64::from_le_bytes(word);
    match column.scalar {
        Scalar::I8 => f64::from(value as i8),
        Scalar::I16 => f64::from(value as i16),
        Scalar::I32 => f64::from(value as i32),
        Scalar::U8 | Scalar::U16 | Scalar::U32 => value as f64,
        Scalar::F32 => f64::from(f32::from_bits(value as u32)),
        Scalar::F64 => f64::from_bits(value),
    }
}
