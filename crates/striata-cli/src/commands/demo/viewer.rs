//! The demo's viewer: one page with the web viewer and the bust as a stream inside.

use striata::mesh::{IndexedMesh, weld};
use striata_stream::{StreamOptions, encode_stream};

use super::folder::Folder;
use striata_command::failure::Failure;
use striata_command::output::{Bar, format_count};
use striata_command::sequence::{BatchTerms, SequencePlan, Steps};
use striata_viewer::viewer_page::self_contained;

/// The stream's file.
const STREAM: &str = "nefertiti.stri";

/// The viewer's page.
pub(super) const PAGE: &str = "viewer.html";

/// Compresses the mesh into a stream, and writes it alone and inside the viewer.
///
/// # Errors
/// Where it cannot be made or written.
pub(super) fn write(mesh: &IndexedMesh, folder: &mut Folder<'_>, bar: &mut Bar) -> Result<(), Failure> {
    let mut plan = SequencePlan::default();
    plan.come_in_batches(BatchTerms::default())?;
    let sequenced = plan.run(weld(mesh)?, &mut |progress| bar.show(progress))?;
    let (Steps::Collapses(refinable), Some(batches)) = (&sequenced.steps, &sequenced.batches) else {
        return Err(Failure::internal("collapses come in batches"));
    };
    bar.phase("encode");
    let stream = encode_stream(refinable, batches, &StreamOptions::default())?.bytes;
    let what = format!("{} triangles as a stream, coarse to fine", format_count(mesh.triangle_count()));
    folder.write(STREAM, &what, &stream)?;
    let page = self_contained(Some((STREAM, &stream)))?;
    folder.write(PAGE, "the viewer, with the stream inside", page.as_bytes())
}
