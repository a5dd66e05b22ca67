//! Bytes of a page must give an error, or a page that is consistent and can be encoded again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata_paged::{Metadata, Page, PageId, PagedGrid, PagedLayer};

fn metadata() -> Metadata {
    let layer = |semantic: &str, component_type: &str, step| PagedLayer {
        semantic: semantic.to_owned(),
        component_count: 2,
        normalized: false,
        component_type: component_type.to_owned(),
        step,
    };
    Metadata {
        cell_counts: vec![4, 1],
        grid: Some(PagedGrid { origin: [0.0; 3], step: [0.25; 3] }),
        layers: vec![layer("texcoord_0", "f32", Some(0.001)), layer("generic_a", "u8", None)],
        ..Metadata::default()
    }
}

fuzz_target!(|data: &[u8]| {
    let Some((&level, bytes)) = data.split_first() else { return };
    let metadata = metadata();
    let id = PageId { level: level % 3, cell: 0 };
    if let Ok(mut page) = Page::from_bytes(id, bytes, &metadata) {
        page.check(&metadata).expect("a decoded page is consistent");
        page.normalize();
        page.check(&metadata).expect("a page in order is consistent");
        let _ = page.to_bytes(&metadata);
    }
});
