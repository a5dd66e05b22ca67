//! The last task: collects all pages into one file, or into a folder of objects.

use std::fs;
use std::io::{BufWriter, Write};
use std::path::Path;

use super::BuildError;
use super::part_file::{PartFile, PartIndex, Segment};
use super::plan::{Plan, TaskKind, temporary_in, write_whole};
use crate::{HEAD_NAME, PageEntry, PageId, page_path, write_head};

/// Writes the result.
pub(super) fn run(plan: &Plan) -> Result<(), BuildError> {
    let paths = plan.tasks.iter().filter_map(|task| match task.kind {
        TaskKind::Encode(level) => Some(plan.pages_path(level, task.first)),
        _ => None,
    });
    let pages = PartIndex::open(paths)?;
    let mut ids: Vec<PageId> = pages.ids().collect();
    ids.sort_by_key(|id| (u8::MAX - id.level, id.cell));
    let mut entries: Vec<PageEntry> = Vec::with_capacity(ids.len());
    let mut offset = 0;
    for &id in &ids {
        let Some((part, segment)) = pages.find(id).next() else { continue };
        let mut entry = split(part, segment)?.0;
        entry.offset = offset;
        offset += u64::from(entry.byte_count);
        entries.push(entry);
    }
    let mut metadata = plan.metadata.clone();
    metadata.position_count = entries.iter().map(|entry| u64::from(entry.position_count)).sum();
    metadata.vertex_count = entries.iter().map(|entry| u64::from(entry.vertex_count)).sum();
    let is_folder = is_folder(&plan.output);
    let head = write_head(&metadata, &entries, is_folder);
    let each = |write: &mut WritePage<'_>| {
        ids.iter().try_for_each(|&id| {
            let Some((part, segment)) = pages.find(id).next() else { return Ok(()) };
            write(id, &split(part, segment)?.1)
        })
    };
    if is_folder {
        each(&mut |id, bytes| {
            let path = plan.output.join(page_path(id));
            let folder = path.parent().unwrap_or(&plan.output);
            fs::create_dir_all(folder).map_err(|source| BuildError::io(folder, source))?;
            write_whole(&path, bytes)
        })?;
        // The head comes last: without it, nobody sees the pages.
        write_whole(&plan.output.join(HEAD_NAME), &head)
    } else {
        write_file(&plan.output, &head, &each)
    }
}

/// Takes the bytes of one page.
type WritePage<'a> = dyn FnMut(PageId, &[u8]) -> Result<(), BuildError> + 'a;
/// Passes the bytes of every page to a function.
type EachPage<'a> = dyn Fn(&mut WritePage<'_>) -> Result<(), BuildError> + 'a;

fn write_file(output: &Path, head: &[u8], each: &EachPage<'_>) -> Result<(), BuildError> {
    let failed = |source| BuildError::io(output, source);
    let folder = output.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let file = temporary_in(folder).map_err(failed)?;
    let mut file = BufWriter::new(file);
    file.write_all(head).map_err(failed)?;
    each(&mut |_, bytes| file.write_all(bytes).map_err(failed))?;
    let file = file.into_inner().map_err(|error| failed(error.into_error()))?;
    file.persist(output).map_err(|error| failed(error.error))?;
    Ok(())
}

/// Whether pages become separate objects in a folder.
pub(super) fn is_folder(output: &Path) -> bool {
    output.is_dir() || output.extension().is_none()
}

/// Entry and bytes of a page.
fn split(part: &PartFile, segment: &Segment) -> Result<(PageEntry, Vec<u8>), BuildError> {
    let bytes = part.read(segment)?;
    let damaged = || part.named(BuildError::DamagedPart);
    let (length, rest) = bytes.split_first_chunk::<4>().ok_or_else(damaged)?;
    let (entry, page) = rest.split_at_checked(u32::from_le_bytes(*length) as usize).ok_or_else(damaged)?;
    let entry = serde_json::from_slice(entry).map_err(|_| damaged())?;
    Ok((entry, page.to_vec()))
}
