//! The last task: collects all pages into one file, or into a folder of objects, here or at an address.

use std::fs;
use std::io::{BufWriter, Write};
use std::path::Path;

use super::PagedBuildError;
use super::part_file::{PartFile, PartIndex, PartSegment};
use super::plan::{PagedPlan, TaskKind, temporary_in, write_whole};
use crate::store::path_in;
use crate::{HEAD_NAME, PageEntry, PageId, PagedImage, StoredPlace, write_head};

/// Writes the result.
pub(super) fn run(plan: &PagedPlan) -> Result<(), PagedBuildError> {
    let paths = plan.tasks.iter().filter_map(|task| match task.kind {
        TaskKind::Encode(level) => Some(plan.pages_path(level, task.first)),
        _ => None,
    });
    let pages = PartIndex::open(paths)?;
    let (triangles, limit) =
        (base_triangle_count(plan)?, plan.options.base_triangle_count(plan.metadata.triangle_count));
    if plan.options.strict && triangles > limit {
        return Err(PagedBuildError::Base { triangles, limit });
    }
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
    for image in &mut metadata.images {
        image.offset = offset;
        offset += image.byte_count;
    }
    let destination = ResultDestination::of(&plan.output)?;
    let head = write_head(&metadata, &entries, destination.is_folder());
    let each = |write: &mut WriteObject<'_>| {
        ids.iter().try_for_each(|&id| {
            let Some((part, segment)) = pages.find(id).next() else { return Ok(()) };
            write(StoredPlace::Page(id), &split(part, segment)?.1)
        })?;
        (0..).zip(&metadata.images).filter(|(_, image)| image.byte_count > 0).try_for_each(
            |(index, image)| write(StoredPlace::Image(index), &stored_image(&plan.image_path(index), image)?),
        )
    };
    match destination {
        ResultDestination::File => write_file(&plan.output, &head, &each),
        ResultDestination::Folder => write_folder(&plan.output, &head, &each),
        #[cfg(feature = "remote")]
        ResultDestination::Address(store) => write_to_address(&store, &head, &each),
    }
}

/// Destination of the result.
pub(super) enum ResultDestination {
    /// One file.
    File,
    /// A folder with one object per page.
    Folder,
    /// An address, with one object or one per page.
    #[cfg(feature = "remote")]
    Address(crate::remote::RemoteStore),
}

impl ResultDestination {
    /// Chooses the destination of an output: a path without an extension is a folder.
    ///
    /// # Errors
    /// [`PagedBuildError::Page`] if it is an address that cannot be written.
    pub(super) fn of(output: &Path) -> Result<Self, PagedBuildError> {
        let name = output.to_string_lossy();
        if is_address(output) {
            #[cfg(feature = "remote")]
            return Ok(Self::Address(crate::remote::RemoteStore::open(&name)?));
            #[cfg(not(feature = "remote"))]
            return Err(
                crate::PagedError::FeatureOff { address: name.into_owned(), feature: "remote" }.into()
            );
        }
        let is_folder = output.is_dir() || output.extension().is_none();
        Ok(if is_folder { Self::Folder } else { Self::File })
    }

    /// Refuses an address that cannot be written, as far as that is known before writing.
    pub(super) fn check(&self) -> Result<(), PagedBuildError> {
        match self {
            Self::File | Self::Folder => Ok(()),
            #[cfg(feature = "remote")]
            Self::Address(store) => Ok(store.check_bucket()?),
        }
    }

    fn is_folder(&self) -> bool {
        match self {
            Self::File => false,
            Self::Folder => true,
            #[cfg(feature = "remote")]
            Self::Address(store) => store.is_folder(),
        }
    }
}

/// Takes the bytes of one page or image.
type WriteObject<'a> = dyn FnMut(StoredPlace, &[u8]) -> Result<(), PagedBuildError> + 'a;
/// Passes the bytes of every page and image to a function.
type EachObject<'a> = dyn Fn(&mut WriteObject<'_>) -> Result<(), PagedBuildError> + 'a;

/// The contents of an image, as they were when the plan was made.
fn stored_image(path: &Path, image: &PagedImage) -> Result<Vec<u8>, PagedBuildError> {
    let bytes = fs::read(path).map_err(|source| PagedBuildError::io(path, source))?;
    let is_whole = bytes.len() as u64 == image.byte_count && crc32fast::hash(&bytes) == image.crc;
    is_whole.then_some(bytes).ok_or_else(|| PagedBuildError::Damaged { path: path.to_owned() })
}

fn write_file(output: &Path, head: &[u8], each: &EachObject<'_>) -> Result<(), PagedBuildError> {
    let failed = |source| PagedBuildError::io(output, source);
    let folder = output.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let file = temporary_in(folder).map_err(failed)?;
    let mut file = BufWriter::new(file);
    file.write_all(head).map_err(failed)?;
    each(&mut |_, bytes| file.write_all(bytes).map_err(failed))?;
    let file = file.into_inner().map_err(|error| failed(error.into_error()))?;
    // The final name must not appear before the contents are on disk, even if the power fails.
    file.as_file().sync_all().map_err(failed)?;
    file.persist(output).map_err(|error| failed(error.error))?;
    Ok(())
}

fn write_folder(output: &Path, head: &[u8], each: &EachObject<'_>) -> Result<(), PagedBuildError> {
    each(&mut |place, bytes| {
        let path = path_in(output, place);
        let folder = path.parent().unwrap_or(output);
        fs::create_dir_all(folder).map_err(|source| PagedBuildError::io(folder, source))?;
        write_whole(&path, bytes)
    })?;
    // The head is written last: readers ignore pages without a head.
    write_whole(&output.join(HEAD_NAME), head)
}

#[cfg(feature = "remote")]
fn write_to_address(
    store: &crate::remote::RemoteStore,
    head: &[u8],
    each: &EachObject<'_>,
) -> Result<(), PagedBuildError> {
    if !store.is_folder() {
        let mut upload = store.upload()?;
        let written = upload.write(head).map_err(PagedBuildError::from);
        return match written.and_then(|()| each(&mut |_, bytes| Ok(upload.write(bytes)?))) {
            Ok(()) => Ok(upload.finish()?),
            Err(error) => {
                upload.abort();
                Err(error)
            }
        };
    }
    let mut pages = store.put_all();
    each(&mut |place, bytes| Ok(pages.put(place, bytes)?))?;
    pages.finish()?;
    // The head is written last: readers ignore pages without a head.
    let mut last = store.put_all();
    last.put(StoredPlace::Head, head)?;
    Ok(last.finish()?)
}

/// Whether an output is an address and not a path.
pub fn is_address(output: &Path) -> bool {
    output.to_string_lossy().contains("://")
}

/// Number of triangles of the base page.
pub(super) fn base_triangle_count(plan: &PagedPlan) -> Result<u64, PagedBuildError> {
    let id = PageId { level: plan.level_count(), cell: 0 };
    let pages = PartIndex::open(std::iter::once(plan.pages_path(id.level, 0)))?;
    let Some((part, segment)) = pages.find(id).next() else { return Err(PagedBuildError::DamagedPart) };
    Ok(u64::from(split(part, segment)?.0.triangle_count))
}

/// Entry and bytes of a page.
fn split(part: &PartFile, segment: &PartSegment) -> Result<(PageEntry, Vec<u8>), PagedBuildError> {
    let bytes = part.read(segment)?;
    let damaged = || part.named(PagedBuildError::DamagedPart);
    let (length, rest) = bytes.split_first_chunk::<4>().ok_or_else(damaged)?;
    let (entry, page) = rest.split_at_checked(u32::from_le_bytes(*length) as usize).ok_or_else(damaged)?;
    let entry = serde_json::from_slice(entry).map_err(|_| damaged())?;
    Ok((entry, page.to_vec()))
}
