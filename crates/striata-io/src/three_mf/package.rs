//! The zip archive: finds parts by name, and limits what they unpack to.

use std::io::{Cursor, Read as _};

use quick_xml::Reader;
use quick_xml::events::Event;
use zip::ZipArchive;

use super::model::attribute;
use crate::compressed::unpacked_limit;
use crate::error::{Fault, Place};

/// Usual name of the part with the build items.
const USUAL_MODEL: &str = "3D/3dmodel.model";

/// Largest ratio of output to input: models are text, which shrinks to a tenth or a twentieth.
const MAX_RATIO: u64 = 300;

/// An open archive.
pub(super) struct ThreeMfPackage<'a> {
    archive: ZipArchive<Cursor<&'a [u8]>>,
    /// Bytes that may still be unpacked.
    bytes_left: u64,
    limit: u64,
    input_bytes: u64,
}

impl<'a> ThreeMfPackage<'a> {
    pub(super) fn open(bytes: &'a [u8]) -> Result<Self, Fault> {
        let archive = ZipArchive::new(Cursor::new(bytes));
        let archive =
            archive.map_err(|error| fault(format!("the zip archive is damaged or cut off: {error}")))?;
        let input_bytes = bytes.len() as u64;
        let limit = unpacked_limit(input_bytes, MAX_RATIO);
        Ok(Self { archive, bytes_left: limit, limit, input_bytes })
    }

    /// Size of the archive.
    pub(super) fn input_bytes(&self) -> u64 {
        self.input_bytes
    }

    /// Returns the content of a part; [`None`] if there is no such part.
    pub(super) fn part(&mut self, name: &str) -> Result<Option<Vec<u8>>, Fault> {
        let name = name.trim_start_matches('/');
        let index = self.archive.index_for_name(name).or_else(|| {
            self.archive.file_names_raw().position(|known| known.eq_ignore_ascii_case(name.as_bytes()))
        });
        let Some(index) = index else { return Ok(None) };
        let damaged = |error: &dyn std::fmt::Display| fault(format!("the part `{name}` is damaged: {error}"));
        let entry = self.archive.by_index(index).map_err(|error| damaged(&error))?;
        let mut bytes = Vec::new();
        entry.take(self.bytes_left + 1).read_to_end(&mut bytes).map_err(|error| damaged(&error))?;
        match self.bytes_left.checked_sub(bytes.len() as u64) {
            Some(left) => self.bytes_left = left,
            None => {
                let reason =
                    format!("the archive unpacks to more than {} bytes, which no mesh does", self.limit);
                return Err(fault(reason));
            }
        }
        Ok(Some(bytes))
    }

    /// Returns the name of the part with the build items.
    pub(super) fn root_name(&mut self) -> Result<String, Fault> {
        let relations = self.part("_rels/.rels")?.unwrap_or_default();
        if let Some(name) = root_in(&relations) {
            return Ok(name);
        }
        let is_model = |name: &&[u8]| name.to_ascii_lowercase().ends_with(b".model");
        let names: Vec<&[u8]> = self.archive.file_names_raw().collect();
        let usual = names.iter().copied().find(|name| name.eq_ignore_ascii_case(USUAL_MODEL.as_bytes()));
        match usual.or_else(|| names.iter().copied().filter(is_model).min()) {
            Some(name) => Ok(String::from_utf8_lossy(name).into_owned()),
            None => Err(fault("the archive contains no 3D model (3D/3dmodel.model)".to_owned())),
        }
    }
}

/// Returns the target of the first relation to a 3D model.
fn root_in(relations: &[u8]) -> Option<String> {
    let mut xml = Reader::from_reader(relations);
    loop {
        match xml.read_event().ok()? {
            Event::Start(start) | Event::Empty(start)
                if attribute(&start, "Type").is_some_and(|kind| kind.ends_with("/3dmodel")) =>
            {
                return Some(attribute(&start, "Target")?.trim_start_matches('/').to_owned());
            }
            Event::Eof => return None,
            _ => {}
        }
    }
}

fn fault(reason: String) -> Fault {
    Fault::Malformed(Place::File, reason)
}
