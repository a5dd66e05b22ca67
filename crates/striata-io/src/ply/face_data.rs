//! Numbers of faces: labels, colors and whatever else the rows of the element `face` contain.
//!
//! A polygon that becomes several triangles gives each of them a copy of its row. Triangles without a row
//! (those of strips) have zeros.

use std::borrow::Cow;

use striata::mesh::AttributeLayer;

use super::column::Column;
use super::header::{Element, Header, PlyProperty};
use super::vertices::{PlyVertices, columns_of};

/// Bytes of rows that any file may have, and per byte of the file: long rows of polygons with many corners would
/// otherwise let a small file fill the memory.
const FREE_BYTES: usize = 64 << 20;
const BYTES_PER_FILE_BYTE: usize = 8;

/// Rows of little-endian numbers, one for each triangle.
#[derive(Default)]
pub(crate) struct FaceData {
    rows: Vec<u8>,
    columns: Vec<Column>,
    stride: usize,
    /// Most bytes that the rows may have.
    limit: usize,
    /// Whether the texture number is a column like any other, because no texture has a number.
    pub keeps_texture_numbers: bool,
    is_too_large: bool,
    /// Whether the current element has the columns.
    is_open: bool,
    /// Remarks on what was left out.
    remarks: Vec<String>,
}

impl FaceData {
    /// Sets what depends on the file.
    pub(crate) fn new(header: &Header, file_bytes: usize) -> Self {
        Self {
            limit: FREE_BYTES.saturating_add(file_bytes.saturating_mul(BYTES_PER_FILE_BYTE)),
            keeps_texture_numbers: header.texture_files.is_empty(),
            ..Self::default()
        }
    }

    /// Begins an element of faces, whose first triangle will be `triangle_count`.
    pub(crate) fn begin(&mut self, element: &Element, triangle_count: usize) {
        let own = Element {
            properties: element.properties.iter().filter(|p| self.takes(p)).cloned().collect(),
            ..element.clone()
        };
        let (columns, stride) = columns_of(&own);
        let is_same = |a: &Column, b: &Column| a.name == b.name && a.scalar == b.scalar;
        if self.columns.is_empty() {
            (self.columns, self.stride) = (columns.clone(), stride);
        }
        self.is_open = !columns.is_empty()
            && columns.len() == self.columns.len()
            && columns.iter().zip(&self.columns).all(|(a, b)| is_same(a, b));
        if !self.is_open {
            let left_out = columns
                .iter()
                .map(|c| format!("the property `{}` of a second element `face` is left out", c.name));
            self.remarks.extend(left_out);
        }
        self.pad(triangle_count);
    }

    /// Whether a property is a column.
    pub(crate) fn takes(&self, property: &PlyProperty) -> bool {
        property.list.is_none() && (self.keeps_texture_numbers || property.name != "texnumber")
    }

    /// Whether the rows of the current element are wanted.
    #[inline]
    pub(crate) fn is_open(&self) -> bool {
        self.is_open
    }

    /// Adds the row of a polygon for each of its triangles.
    pub(crate) fn push(&mut self, row: &[u8], triangle_count: usize) {
        if row.len().saturating_mul(triangle_count) > self.limit.saturating_sub(self.rows.len()) {
            self.is_too_large = true;
            self.is_open = false;
        }
        if self.is_open {
            (0..triangle_count).for_each(|_| self.rows.extend_from_slice(row));
        }
    }

    /// Adds rows of zeros for triangles without any.
    fn pad(&mut self, triangle_count: usize) {
        let length = self.stride.saturating_mul(triangle_count);
        self.is_too_large |= length > self.limit;
        if !self.is_too_large && self.rows.len() < length {
            self.rows.resize(length, 0);
        }
    }

    /// Returns the layers of all triangles, and remarks on what was left out.
    pub(crate) fn into_layers(
        mut self,
        header: &Header,
        triangle_count: usize,
    ) -> (Vec<AttributeLayer>, Vec<String>) {
        if self.columns.is_empty() {
            return (Vec::new(), self.remarks);
        }
        let with_rows = self.rows.len() / self.stride;
        self.pad(triangle_count);
        if self.is_too_large {
            let names = self
                .columns
                .iter()
                .map(|c| format!("the property `{}` of faces is left out: it would fill the memory", c.name));
            self.remarks.extend(names);
            return (Vec::new(), self.remarks);
        }
        if with_rows < triangle_count {
            let (count, name) = (triangle_count - with_rows, &self.columns[0].name);
            self.remarks.push(format!("{count} triangles have no property `{name}`: theirs are 0"));
        }
        let rows = PlyVertices::of_triangles(Cow::Owned(self.rows), self.columns, self.stride);
        (rows.layers(header), self.remarks)
    }
}

/// Remarks on properties and elements that a mesh has no place for, one each.
pub(crate) fn left_out(header: &Header) -> Vec<String> {
    let mut out = Vec::new();
    for element in header.elements.iter().filter(|element| element.count > 0) {
        let name = element.name.as_str();
        let is_known = |p: &&PlyProperty| match name {
            "vertex" => p.list.is_none(),
            "face" => {
                p.list.is_none() || matches!(p.name.as_str(), "vertex_indices" | "vertex_index" | "texcoord")
            }
            _ => p.list.is_some() && matches!(p.name.as_str(), "vertex_indices" | "vertex_index"),
        };
        match name {
            "vertex" | "face" | "tristrips" => {
                let lost = element.properties.iter().filter(|p| !is_known(p));
                out.extend(lost.map(|p| format!("the property `{}` of `{name}` is left out", p.name)));
            }
            _ => out.push(format!("the element `{name}` is left out ({} rows)", element.count)),
        }
    }
    out
}
