//! `demo`: builds, extracts and draws levels of a built-in mesh and of a built-in scene, and writes a page
//! that presents them.

mod amphora;
mod folder;
mod levels;
mod page;
mod pictures;
mod viewer;

use std::path::Path;
use std::time::Instant;

use serde::Serialize;
use striata_io::{Source, read_bytes};

use crate::args::DemoArgs;
use crate::commands::build::{BuildOutput, BuildPlan, PHASES, build};
use folder::DemoFolder;
use levels::Level;
use pictures::Picture;
use striata_command::clock::Phases;
use striata_command::failure::Failure;
use striata_command::output::{Output, format_bytes, format_count, format_duration};
use striata_viewer::PictureRenderer;

/// The bust of Nefertiti; for its origin, see `assets/README.md` in the root of the repository.
const NEFERTITI: &[u8] = include_bytes!("../../../assets/nefertiti.ply.zst");

#[derive(Serialize)]
struct DemoReport {
    dir: String,
    files: Vec<String>,
    levels: Vec<Level>,
    secs: f64,
}

/// Creates and fills the folder.
///
/// # Errors
/// If the folder or a file in it cannot be written.
pub(crate) fn run(args: &DemoArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    let mut folder = DemoFolder::create(args.dir())?;
    let mut bar = output.bar();
    let mut phases = Phases::new(&PHASES);
    let mesh = read_bytes(NEFERTITI, &Source::new("nefertiti.ply.zst"))?;
    let built = build(&mesh, &BuildPlan::with_defaults(), &mut phases, &mut bar)?;
    bar.phase("files");
    let bytes = built.to_bytes("nefertiti.ply.zst")?;
    folder.write("nefertiti.striata", "every level in one file", &bytes)?;
    let levels = levels::measure(&built);
    let file = striata_stream::open(&bytes)?;
    levels::write_meshes(&file, &built, &mut folder)?;
    bar.phase("pictures");
    let mut artist = PictureRenderer::best(output);
    let mut pictures = pictures::draw_all(&built, &mut artist)?;
    for picture in &pictures {
        folder.write(picture.name, picture.what, &picture.png)?;
    }
    viewer::write(&mesh, &mut folder, &mut bar)?;
    pictures.push(amphora::write(&mut folder, &mut artist, &mut bar)?);
    bar.phase("page");
    let page = render_page(&built, &levels, &folder, &pictures, bytes.len());
    folder.write("index.html", "the page to open", page.as_bytes())?;
    drop(bar);
    let report = DemoReport {
        dir: args.dir().display().to_string(),
        files: folder.files.iter().map(|(name, _)| name.clone()).collect(),
        levels,
        secs: started.elapsed().as_secs_f64(),
    };
    output.data(&report, &report.to_text(&phases))?;
    output.say(&what_next(args.dir()));
    Ok(())
}

fn render_page(
    built: &BuildOutput,
    levels: &[Level],
    folder: &DemoFolder<'_>,
    pictures: &[Picture],
    file_bytes: usize,
) -> String {
    let sequence = &built.refinable().sequence;
    let intro = format!(
        "The bust of Nefertiti ({} triangles) became a single file of {} with {} levels of detail.",
        format_count(sequence.triangle_count_at(sequence.step_count())),
        format_bytes(file_bytes),
        format_count(sequence.step_count() + 1),
    );
    let content = page::PageContent {
        intro: &intro,
        levels: "Errors are distances from the full mesh, relative to the diagonal of its bounding box. \
                 Seek times are those from full detail to the level, on the machine that ran the demo.",
        table: &levels::rows(levels),
        files: &folder.files,
        pictures,
    };
    page::render(&content)
}

impl DemoReport {
    fn to_text(&self, phases: &Phases) -> String {
        let mut table = striata_command::output::Table::default();
        for row in levels::rows(&self.levels) {
            table.row(row);
        }
        format!(
            "{}\nsimplified in {}, finished in {}\n",
            table.to_text(),
            format_duration(phases.secs_of("simplify")),
            format_duration(self.secs)
        )
    }
}

fn what_next(dir: &Path) -> String {
    let page = dir.join("index.html");
    let page = page.canonicalize().unwrap_or(page);
    let file = dir.join("nefertiti.striata");
    format!(
        "\nOpen {} in a browser to see the levels and open the viewer.\n\
         Then try:\n  \
         striata info {file}\n  \
         striata extract {file} -o small.glb --triangles 5000\n  \
         striata build YOUR-MESH.ply -o YOUR-MESH.striata",
        page.display(),
        file = file.display()
    )
}
