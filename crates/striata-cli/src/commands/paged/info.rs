//! `info` of a paged file: reads its head only.

use std::path::Path;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::output::{Output, Table, format_bytes, format_count, format_length, format_noun_count};
use striata_paged::{Metadata, PagedFile, PagedImage};

use super::failure_of;

#[derive(Serialize)]
struct PagedInfoReport {
    kind: &'static str,
    page_count: u32,
    page_bytes: u64,
    read_bytes: u64,
    levels: Vec<PagedLevelReport>,
    #[serde(flatten)]
    metadata: Metadata,
}

#[derive(Clone, Default, Serialize)]
struct PagedLevelReport {
    level: u8,
    pages: usize,
    triangles: u64,
    bytes: u64,
    error_max: f32,
}

/// Describes a paged file.
///
/// # Errors
/// If its head is damaged.
pub(crate) fn info(path: &Path, output: &Output) -> Result<(), Failure> {
    let mut file = PagedFile::open(&path.to_string_lossy()).map_err(failure_of)?;
    let pages = file.select(|_| true).map_err(failure_of)?;
    let metadata = file.metadata().clone();
    let mut levels = vec![PagedLevelReport::default(); metadata.cell_counts.len() + 1];
    for entry in pages.iter().filter_map(|&page| file.reader().entry(page)) {
        let Some(level) = levels.get_mut(entry.id.level as usize) else { continue };
        level.level = entry.id.level;
        level.pages += 1;
        level.triangles += u64::from(entry.added_triangle_count);
        level.bytes += u64::from(entry.byte_count);
        level.error_max = level.error_max.max(entry.error);
    }
    levels.reverse();
    let report = PagedInfoReport {
        kind: "paged",
        page_count: file.reader().page_count(),
        page_bytes: levels.iter().map(|level| level.bytes).sum(),
        read_bytes: file.statistics().byte_count,
        levels,
        metadata,
    };
    output.data(&report, &text(path, &report))
}

fn text(path: &Path, report: &PagedInfoReport) -> String {
    let metadata = &report.metadata;
    let mut table = Table::with_head(&["level", "pages", "triangles", "bytes", "error"]);
    for level in &report.levels {
        let name = if level.level as usize == metadata.cell_counts.len() {
            "base".to_owned()
        } else {
            level.level.to_string()
        };
        table.row(vec![
            name,
            format_count(level.pages),
            format_count(level.triangles as usize),
            format_bytes(level.bytes as usize),
            format_length(level.error_max.into()),
        ]);
    }
    let layers: Vec<&str> = metadata.layers.iter().map(|layer| layer.semantic.as_str()).collect();
    let precision =
        metadata.grid.map_or("exact".to_owned(), |grid| format!("multiples of {}", steps_text(grid.step)));
    format!(
        "{}: paged file of {}\n{} triangles, {} vertices; diagonal {}; positions {}; attributes: {}\n\
        {} pages, {} ({:.2} bytes per triangle){}\n\n{}",
        path.display(),
        metadata.source,
        format_count(metadata.triangle_count as usize),
        format_count(metadata.vertex_count as usize),
        format_length(metadata.diagonal()),
        precision,
        if layers.is_empty() { "none".to_owned() } else { layers.join(", ") },
        format_count(report.page_count as usize),
        format_bytes(report.page_bytes as usize),
        report.page_bytes as f64 / metadata.triangle_count.max(1) as f64,
        images_text(&metadata.images),
        table.to_text(),
    )
}

/// The number and size of images, if there are any.
fn images_text(images: &[PagedImage]) -> String {
    if images.is_empty() {
        return String::new();
    }
    let bytes: u64 = images.iter().map(|image| image.byte_count).sum();
    format!("; {}, {}", format_noun_count(images.len(), "image", "images"), format_bytes(bytes as usize))
}

/// Distances of neighboring positions: one number if all axes have the same.
fn steps_text([x, y, z]: [f64; 3]) -> String {
    if x == y && y == z {
        return format_length(x);
    }
    [x, y, z].map(format_length).join(" x ")
}
