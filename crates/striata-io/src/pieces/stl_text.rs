//! ASCII STL, converted to a temporary binary file.

use super::input::Input;
use super::spool::Spool;
use super::{PieceGroup, PieceOptions};
use crate::ReadError;
use crate::report::Warnings;
use crate::stl::{HEADER_BYTES, Statement, visit_ascii};
use crate::text::trimmed;

/// Solids of a file: their names and first facets.
pub(super) struct Solids {
    pub(super) groups: Vec<PieceGroup>,
    pub(super) starts: Vec<usize>,
}

/// Replaces the bytes of a text file by those of a binary one.
pub(super) fn convert(
    input: &mut Input,
    options: &PieceOptions,
    warnings: &mut Warnings,
) -> Result<Solids, ReadError> {
    input.make_plain_text(options)?;
    let mut spool = Spool::new(options)?;
    spool.write(&[b' '; HEADER_BYTES]);
    let mut solids = Solids { groups: Vec::new(), starts: Vec::new() };
    let mut count = 0u32;
    let visited = visit_ascii(trimmed(&input.bytes), warnings, |statement, cursor| {
        match statement {
            Statement::Solid(name) => {
                solids.groups.push(PieceGroup { name, material: None });
                solids.starts.push(count as usize);
            }
            Statement::Facet(corners) => {
                let coordinates = corners.as_flattened();
                let mut facet = [0; 50];
                for (bytes, value) in facet[12..48].chunks_exact_mut(4).zip(coordinates) {
                    bytes.copy_from_slice(&value.to_le_bytes());
                }
                spool.write(&facet);
                count = count.checked_add(1).ok_or_else(|| cursor.fault("there are too many facets"))?;
            }
        }
        Ok(())
    });
    visited.map_err(|fault| fault.in_file(&input.name))?;
    spool.replace(HEADER_BYTES as u64 - 4, &count.to_le_bytes());
    input.bytes = spool.finish(options)?;
    Ok(solids)
}
