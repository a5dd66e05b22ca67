//! Lists of a row: their lengths, and rows and properties that are skipped.

use super::header::{Element, PlyProperty, Scalar};
use super::rows::Rows;
use crate::error::Fault;

pub(crate) fn skip_property<'a>(property: &PlyProperty, rows: &mut impl Rows<'a>) -> Result<(), Fault> {
    let count = match property.list {
        None => 1,
        Some(scalar) => list_length(scalar, rows)?,
    };
    rows.skip(property.scalar, count)
}

pub(crate) fn list_length<'a>(scalar: Scalar, rows: &mut impl Rows<'a>) -> Result<usize, Fault> {
    let length = rows.integer(scalar)?;
    usize::try_from(length).map_err(|_| rows.fault(format!("a list cannot have {length} entries")))
}

pub(crate) fn skip_element<'a>(element: &Element, rows: &mut impl Rows<'a>) -> Result<(), Fault> {
    if element.properties.iter().all(|p| p.list.is_none()) {
        for property in &element.properties {
            rows.skip(property.scalar, element.count)?;
        }
        return Ok(());
    }
    for _ in 0..element.count {
        for property in &element.properties {
            skip_property(property, rows)?;
        }
    }
    Ok(())
}

/// Returns the index of the vertex list among an element's properties.
pub(crate) fn index_list(element: &Element) -> Option<usize> {
    let is_index_list =
        |p: &PlyProperty| p.list.is_some() && matches!(p.name.as_str(), "vertex_indices" | "vertex_index");
    element.properties.iter().position(is_index_list)
}
