//! ASCII STL, converted to a temporary binary file.

use striata::mesh::{origin_of, relative_position};

use super::input::PieceInput;
use super::spool::Spool;
use super::{PieceGroup, PieceOptions};
use crate::ReadError;
use crate::report::Warnings;
use crate::stl::{HEADER_BYTES, Statement, visit_ascii};
use crate::text::trimmed;

/// Solids of a file: their names and first facets.
pub(super) struct Solids {
    pub groups: Vec<PieceGroup>,
    pub starts: Vec<usize>,
}

/// Replaces the bytes of a text file by those of a binary one, whose positions are relative to the origin that
/// is returned.
pub(super) fn convert(
    input: &mut PieceInput,
    options: &PieceOptions,
    warnings: &mut Warnings,
) -> Result<(Solids, [f64; 3]), ReadError> {
    input.make_plain_text(options)?;
    let first = options.origin.unwrap_or([0.0; 3]);
    let written = write_facets(input, first, options, warnings)?;
    let origin = match options.origin {
        None if written.has_long_coordinates => origin_of(&written.sample),
        _ => first,
    };
    let written = match origin == first {
        true => written,
        false => write_facets(input, origin, options, &mut Warnings::of_file(&input.name))?,
    };
    input.bytes = written.spool.finish(options)?;
    Ok((written.solids, origin))
}

/// A text that has been converted.
struct ConvertedText {
    spool: Spool,
    solids: Solids,
    /// Coordinates of some corners.
    sample: Vec<[f64; 3]>,
    has_long_coordinates: bool,
}

fn write_facets(
    input: &PieceInput,
    origin: [f64; 3],
    options: &PieceOptions,
    warnings: &mut Warnings,
) -> Result<ConvertedText, ReadError> {
    /// Number of corners that an origin is chosen from.
    const SAMPLES: usize = 1 << 16;
    let mut spool = Spool::new(options)?;
    spool.write(&[b' '; HEADER_BYTES]);
    let mut solids = Solids { groups: Vec::new(), starts: Vec::new() };
    let (mut sample, mut stride, mut count) = (Vec::new(), 1, 0u32);
    let visited = visit_ascii(trimmed(&input.bytes), warnings, |statement, cursor| {
        match statement {
            Statement::Solid(name) => {
                solids.groups.push(PieceGroup { name, material: None });
                solids.starts.push(count as usize);
            }
            Statement::Facet(corners) => {
                if count % stride == 0 {
                    sample.push(corners[0]);
                }
                if sample.len() == SAMPLES {
                    stride *= 2;
                    sample = sample.iter().copied().step_by(2).collect();
                }
                let coordinates = corners.map(|corner| relative_position(corner, origin));
                let mut facet = [0; 50];
                for (bytes, value) in facet[12..48].chunks_exact_mut(4).zip(coordinates.as_flattened()) {
                    bytes.copy_from_slice(&value.to_le_bytes());
                }
                spool.write(&facet);
                count = count.checked_add(1).ok_or_else(|| cursor.fault("there are too many facets"))?;
            }
        }
        Ok(())
    });
    let has_long_coordinates = visited.map_err(|fault| fault.in_file(&input.name))?;
    spool.replace(HEADER_BYTES as u64 - 4, &count.to_le_bytes());
    Ok(ConvertedText { spool, solids, sample, has_long_coordinates })
}
