//! Bytes of a paged file must give an error, or pages that can be assembled or do not fit.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata_paged::{Page, PagedReader, assemble};

fuzz_target!(|data: &[u8]| {
    let mut reader = PagedReader::new();
    for _ in 0..20 {
        let wants = reader.wants();
        if wants.is_empty() && reader.page_count() > 0 {
            match reader.select(|_| true) {
                Some(pages) => reader.request(pages),
                None => continue,
            }
            if reader.wants().is_empty() {
                break;
            }
        }
        for want in wants {
            let from = (want.range.start as usize).min(data.len());
            let to = (want.range.end as usize).min(data.len());
            if reader.supply(&want, &data[from..to]).is_err() {
                return;
            }
        }
    }
    let pages: Vec<(u32, &Page)> = reader.pages().collect();
    if let Some(metadata) = reader.metadata() {
        let _ = assemble(&pages, metadata);
    }
});
