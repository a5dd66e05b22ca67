//! Files, streams and pages of one mesh as sources of levels.

use std::path::Path;

use striata::file::{DecodeError, StriataFile};
use striata::levels::{FileLevels, FoundLevel};
use striata::mesh::IndexedMesh;
use striata::model::ModelKind;
use striata::strip::StripSet;
use striata_io::Format;
use striata_paged::{PagedError, PagedFile};
use striata_stream::StreamLevels;

use super::LevelSource;
use super::report::{LevelDetails, PagesRead, StreamRead};
use crate::args::TriangleForm;
use crate::commands::build::model_of_name;
use crate::commands::paged::failure_of;
use crate::strip_lists::StripLists;
use striata_command::failure::Failure;
use striata_command::fan_cover::cover_with_fans;
use striata_command::input::Input;
use striata_command::output::Output;
use striata_command::save::{LevelFiles, Primitives, georeference_of};
use striata_command::stream::{cut_off_text, effort_name};

/// The models of a .striata file.
pub(in crate::commands) struct FileSource<'a> {
    levels: FileLevels<'a>,
    input: &'a Input,
    form: TriangleForm,
}

impl<'a> FileSource<'a> {
    /// Chooses the model that the user named, or one that the file has.
    ///
    /// # Errors
    /// If the name is unknown, the file does not have the model, or it is damaged.
    pub(in crate::commands) fn new(
        file: StriataFile<'a>,
        model: Option<&str>,
        form: TriangleForm,
        input: &'a Input,
    ) -> Result<Self, Failure> {
        let named = model.map(model_of_name).transpose()?;
        let levels = FileLevels::new(file, named).map_err(|error| input.damaged(&error))?;
        let levels = if form == TriangleForm::Strips { levels.keeping_strips() } else { levels };
        Ok(Self { levels, input, form })
    }

    /// Checks that the file has a model for uniform levels.
    ///
    /// # Errors
    /// If it has not, or not the one that the user named.
    pub(in crate::commands) fn check_model(&self, named: Option<&str>) -> Result<(), Failure> {
        if self.levels.kind().is_some() {
            return Ok(());
        }
        let what = named.map_or("no model".to_owned(), |kind| format!("no model {kind}"));
        let wanted = named.unwrap_or(ModelKind::LodStrips.as_str());
        Err(Failure::user(format!("{}: this file has {what}", self.input.name))
            .with_hint(format!("build the file again with --models {wanted}")))
    }

    /// Checks that the model that the user named, if any, has views.
    ///
    /// # Errors
    /// If it has none.
    pub(in crate::commands) fn check_views(&self) -> Result<(), Failure> {
        match self.levels.kind_of_views() {
            ModelKind::Fans | ModelKind::Patterns => Ok(()),
            kind => Err(Failure::user(format!("model {kind} does not support views"))
                .with_hint("use --model fans or --model patterns")),
        }
    }
}

impl<'a> LevelSource for FileSource<'a> {
    type Source = FileLevels<'a>;

    fn levels(&mut self) -> &mut FileLevels<'a> {
        &mut self.levels
    }

    fn failure(&self, error: DecodeError) -> Failure {
        self.input.damaged(&error)
    }

    fn write(
        &mut self,
        found: &FoundLevel<IndexedMesh>,
        files: &mut LevelFiles<'_>,
        path: &Path,
    ) -> Result<(), Failure> {
        files.write(&found.shape, primitives_of(self.form, &found.shape, self.levels.strips())?, path)
    }

    fn describe(&mut self, found: &FoundLevel<IndexedMesh>, details: &mut LevelDetails) {
        details.georeference = georeference_of(&found.shape);
        if !details.is_varying {
            details.model = self.levels.kind().map(ModelKind::as_str);
            return;
        }
        // Boxes have no tolerance in pixels, and are made of patterns.
        let kind = if details.pixels.is_some() { self.levels.kind_of_views() } else { ModelKind::Patterns };
        let are_stored = self.levels.file().has_model(kind);
        let origin = Some(if are_stored { "stored" } else { "built" });
        details.model = Some(kind.as_str());
        if kind == ModelKind::Fans {
            details.fans = origin;
        } else {
            details.patterns = origin;
            // Patterns built from collapses only have errors of levels, which do not bound view-dependent states.
            details.has_guaranteed_views = are_stored;
        }
    }
}

/// A stream, or its beginning.
pub(in crate::commands) struct StreamSource<'a> {
    levels: StreamLevels<'a>,
    input: &'a Input,
    form: TriangleForm,
}

impl<'a> StreamSource<'a> {
    /// Finds the stream of a file, possibly cut off.
    ///
    /// # Errors
    /// If the file has no stream, or is damaged.
    pub(in crate::commands) fn new(
        file: &StriataFile<'a>,
        form: TriangleForm,
        input: &'a Input,
    ) -> Result<Self, Failure> {
        let damaged = |error| input.damaged(&error);
        let is_guaranteed = file.has_guaranteed_errors().map_err(damaged)?;
        let levels = StreamLevels::new(stream_of(file, input)?).map_err(damaged)?;
        Ok(Self { levels: levels.with_guaranteed_errors(is_guaranteed), input, form })
    }
}

/// Returns the stream of a file, possibly cut off.
///
/// # Errors
/// If the file has no stream, or is damaged.
fn stream_of<'a>(file: &StriataFile<'a>, input: &Input) -> Result<&'a [u8], Failure> {
    let stream = file.stream().ok_or_else(|| {
        Failure::user(format!("{}: this file has no progressive stream", input.name))
            .with_hint("build it again with --models progressive, or make a stream with `striata encode`")
    })?;
    stream.map_err(|error| input.damaged(&error))
}

impl<'a> LevelSource for StreamSource<'a> {
    type Source = StreamLevels<'a>;

    fn levels(&mut self) -> &mut StreamLevels<'a> {
        &mut self.levels
    }

    fn failure(&self, error: DecodeError) -> Failure {
        self.input.damaged(&error)
    }

    fn write(
        &mut self,
        found: &FoundLevel<IndexedMesh>,
        files: &mut LevelFiles<'_>,
        path: &Path,
    ) -> Result<(), Failure> {
        files.write(&found.shape, primitives_of(self.form, &found.shape, None)?, path)
    }

    fn describe(&mut self, found: &FoundLevel<IndexedMesh>, details: &mut LevelDetails) {
        details.georeference = georeference_of(&found.shape);
        let (info, decoder) = (self.levels.info(), self.levels.decoder());
        details.model = Some(ModelKind::Progressive.as_str());
        details.stream = Some(StreamRead {
            is_complete: !self.levels.is_cut_off(),
            effort: effort_name(info.effort),
            read_bytes: self.levels.read_bytes(),
            level_bytes: decoder.bytes_for(found.split_count),
            stream_bytes: info.stream_bytes,
            file_bytes: self.input.file_bytes(),
            decode_secs: details.prepare_secs,
            triangles_per_sec: decoder.triangle_count() as f64 / details.prepare_secs.max(f64::MIN_POSITIVE),
        });
    }

    fn finish(&mut self, output: &Output) -> Result<(), Failure> {
        if let Some(remark) = cut_off_text(&self.levels, &self.input.name) {
            output.say(&remark);
        }
        Ok(())
    }
}

/// A paged file, of which only the pages are read that the levels need.
pub(in crate::commands) struct PagedSource {
    file: PagedFile,
    form: TriangleForm,
}

impl PagedSource {
    /// Opens a file, a folder, or an address, to write levels of it to `output`.
    ///
    /// # Errors
    /// If its head, or an image that the output can have, cannot be read.
    pub(in crate::commands) fn open(path: &Path, form: TriangleForm, output: &Path) -> Result<Self, Failure> {
        let mut file = PagedFile::open(&path.to_string_lossy()).map_err(failure_of)?;
        if !matches!(Format::from_extension(output), Some(Format::Stl | Format::Off)) {
            file.load_images().map_err(failure_of)?;
        }
        Ok(Self { file, form })
    }
}

impl LevelSource for PagedSource {
    type Source = PagedFile;

    fn levels(&mut self) -> &mut PagedFile {
        &mut self.file
    }

    fn failure(&self, error: PagedError) -> Failure {
        failure_of(error)
    }

    fn write(
        &mut self,
        found: &FoundLevel<IndexedMesh>,
        files: &mut LevelFiles<'_>,
        path: &Path,
    ) -> Result<(), Failure> {
        files.write(&found.shape, primitives_of(self.form, &found.shape, None)?, path)
    }

    fn describe(&mut self, found: &FoundLevel<IndexedMesh>, details: &mut LevelDetails) {
        details.georeference = georeference_of(&found.shape);
        let (statistics, shown) = (self.file.statistics(), self.file.shown_pages());
        details.model = Some(ModelKind::Fans.as_str());
        details.step_count = Some(shown.step_count);
        details.pages = Some(PagesRead {
            page_count: self.file.reader().page_count(),
            read: statistics.page_count,
            shown: shown.page_count,
            bytes: statistics.byte_count,
            step_count: shown.step_count,
        });
    }
}

/// Returns the primitives to write for a level.
///
/// Strips are those of its model, or new ones if these are shorter or the model has none.
///
/// # Errors
/// If the mesh is inconsistent.
fn primitives_of(
    form: TriangleForm,
    mesh: &IndexedMesh,
    strips: Option<&StripSet>,
) -> Result<Primitives, Failure> {
    Ok(match form {
        TriangleForm::List => Primitives::Triangles,
        TriangleForm::Strips => Primitives::Strips(StripLists::of_level(mesh, strips)?.lists),
        TriangleForm::Fans => Primitives::Fans(cover_with_fans(mesh)),
    })
}
