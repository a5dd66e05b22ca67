//! The demo's viewer: a single page that contains the web viewer and the bust as a stream.

use striata::mesh::{IndexedMesh, weld};
use striata_stream::{StreamOptions, encode_stream};

use super::folder::DemoFolder;
use striata::mesh::Steps;
use striata_command::failure::Failure;
use striata_command::output::{Bar, format_count};
use striata_command::sequence::{BatchSettings, SequencePlan};
use striata_viewer::viewer_page::self_contained;

/// File name of the stream.
const STREAM: &str = "nefertiti.stri";

/// File name of the viewer page.
pub(super) const PAGE: &str = "viewer.html";

/// Compresses the mesh into a stream, and writes the stream and a viewer page that contains it.
///
/// # Errors
/// If the stream cannot be made or a file cannot be written.
pub(super) fn write(mesh: &IndexedMesh, folder: &mut DemoFolder<'_>, bar: &mut Bar) -> Result<(), Failure> {
    let mut plan = SequencePlan::default();
    plan.use_batches(BatchSettings::default())?;
    let sequenced = plan.run(weld(mesh)?, &mut |progress| bar.show(progress))?;
    let (Steps::Collapses(refinable), Some(batches)) = (&sequenced.steps, &sequenced.batches) else {
        return Err(Failure::internal("the collapses are not in batches"));
    };
    bar.phase("encode");
    let stream = encode_stream(refinable, batches, &StreamOptions::default())?.bytes;
    let what = format!("{} triangles as a stream, coarse to fine", format_count(mesh.triangle_count()));
    folder.write(STREAM, &what, &stream)?;
    let page = self_contained(Some((STREAM, &stream)))?;
    folder.write(PAGE, "the viewer, with the stream inside", page.as_bytes())
}
