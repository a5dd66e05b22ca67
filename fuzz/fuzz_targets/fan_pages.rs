//! Damaged pages of fans must be refused, or fit into a table without a panic.
#![no_main]

use std::sync::OnceLock;

use libfuzzer_sys::fuzz_target;
use striata::mesh::shapes;
use striata::model::{Fans, PagedFans};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::view::Part;

fuzz_target!(|data: &[u8]| {
    static TABLE: OnceLock<PagedFans> = OnceLock::new();
    let mut paged = TABLE.get_or_init(table).clone();
    if paged.load(data).is_err() {
        return;
    }
    let mut instance = paged.base_instance();
    for weight in [2.0, 0.5] {
        paged.refine(&mut instance, &|_: &Part| weight);
        paged.triangles(&instance);
    }
    paged.refine(&mut instance, &|_: &Part| 2.0);
    paged.unload(1);
    paged.settle(&mut instance);
    paged.triangles(&instance);
});

/// A small table with all of its pages; `examples/seeds` writes the same pages.
fn table() -> PagedFans {
    let built = build_sequence(&shapes::terrain(8, 3), &SequenceOptions::default());
    let refinable = built.expect("a terrain can be simplified").refinable;
    let (directory, pages) = Fans::build(&refinable).to_pages(&refinable.mesh, 16);
    let mut paged = PagedFans::new(directory);
    for page in &pages {
        paged.load(page).expect("the page is valid");
    }
    paged
}
