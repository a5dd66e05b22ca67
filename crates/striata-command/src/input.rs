//! Input files, which are memory-mapped, decompressed and recognized, rasters of heights, and built-in shapes.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use memmap2::Mmap;
use striata::file::StriataFile;
use striata::mesh::IndexedMesh;
use striata_io::pieces::{PieceOptions, PieceSource as _, Terrain, is_raster};
use striata_io::{Format, Place, ReadError, Source, decompressed, read_bytes_with_report};

use crate::args::RasterArgs;
use crate::failure::{Excerpt, Failure, decode_hint};
use crate::output::Output;
use crate::shapes::Shape;
use crate::stream::truncation_note;

/// An input file that has been opened and recognized, or a built-in shape.
#[derive(Debug)]
pub struct Input {
    /// Name shown in messages.
    pub name: String,
    content: Content,
}

#[derive(Debug)]
enum Content {
    File(FileContent),
    Shape(Shape),
    /// Raster of heights, and how it is read.
    Raster(PathBuf, RasterArgs),
}

#[derive(Debug)]
struct FileContent {
    format: Format,
    /// Size on disk, before decompression.
    file_bytes: usize,
    folder: Option<PathBuf>,
    /// Whether the file may refer to others outside that folder.
    outside_allowed: bool,
    bytes: Bytes,
}

#[derive(Debug)]
enum Bytes {
    Mapped(Mmap),
    Owned(Vec<u8>),
}

impl Bytes {
    fn as_slice(&self) -> &[u8] {
        match self {
            Self::Mapped(map) => map,
            Self::Owned(bytes) => bytes,
        }
    }
}

impl Input {
    /// Opens a file (stdin for `-`), decompresses gzip and zstd, and detects the format; or finds a built-in
    /// shape.
    ///
    /// # Errors
    /// If the file cannot be read or its format is unknown, or if there is no such shape.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        if let Some(shape) = Shape::from_input_name(path)? {
            return Ok(Self { name: path.display().to_string(), content: Content::Shape(shape) });
        }
        if is_raster(path) {
            Self::check_exists(path)?;
            return Ok(Self {
                name: path.display().to_string(),
                content: Content::Raster(path.to_owned(), RasterArgs::default()),
            });
        }
        let is_stdin = path == Path::new("-");
        let name = if is_stdin { "stdin".to_owned() } else { path.display().to_string() };
        let raw = if is_stdin { read_stdin() } else { map(path) };
        let raw = raw.map_err(|error| unreadable(&name, &error))?;
        let file_bytes = raw.as_slice().len();
        let (unpacked, inner_name) = match decompressed(Cow::Borrowed(raw.as_slice()), &name)? {
            (Cow::Owned(bytes), inner_name) => (Some(bytes), inner_name),
            (Cow::Borrowed(_), inner_name) => (None, inner_name),
        };
        let bytes = unpacked.map_or(raw, Bytes::Owned);
        let Some(format) = Format::detect(bytes.as_slice(), &inner_name) else {
            return Err(ReadError::unrecognized(&name, bytes.as_slice(), &inner_name).into());
        };
        let folder = (!is_stdin).then(|| folder_of(path));
        let content = FileContent { format, file_bytes, folder, outside_allowed: true, bytes };
        Ok(Self { name, content: Content::File(content) })
    }

    /// Sets how a raster is read.
    ///
    /// # Errors
    /// If the input is no raster, or the heights would not be finite.
    pub fn with_raster(mut self, raster: RasterArgs) -> Result<Self, Failure> {
        let flag = match raster {
            RasterArgs { nodata: Some(_), .. } => "--nodata",
            RasterArgs { z_scale: Some(_), .. } => "--z-scale",
            _ => return Ok(self),
        };
        let Content::Raster(_, known) = &mut self.content else {
            return Err(Failure::usage(format!("{flag} is for rasters of heights; {} is none", self.name)));
        };
        if raster.z_scale.is_some_and(|factor| !factor.is_finite() || factor == 0.0) {
            return Err(Failure::usage("--z-scale must be a finite number other than 0"));
        }
        *known = raster;
        Ok(self)
    }

    /// Reads no files outside the folder of this one: for models that others have put there.
    #[must_use]
    pub fn within_folder(mut self) -> Self {
        if let Content::File(file) = &mut self.content {
            file.outside_allowed = false;
        }
        self
    }

    /// Wraps the bytes of a file that has been made in memory.
    ///
    /// # Errors
    /// If the format is unknown.
    pub fn of_bytes(name: &str, bytes: Vec<u8>) -> Result<Self, Failure> {
        let Some(format) = Format::detect(&bytes, name) else {
            return Err(ReadError::unrecognized(name, &bytes, name).into());
        };
        let file_bytes = bytes.len();
        let bytes = Bytes::Owned(bytes);
        let content = FileContent { format, file_bytes, folder: None, outside_allowed: false, bytes };
        Ok(Self { name: name.to_owned(), content: Content::File(content) })
    }

    /// Checks that the file or shape exists, without reading it.
    ///
    /// # Errors
    /// If it does not exist.
    pub fn check_exists(path: &Path) -> Result<(), Failure> {
        if path == Path::new("-") || Shape::from_input_name(path)?.is_some() {
            return Ok(());
        }
        match std::fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => Err(io::Error::from(io::ErrorKind::IsADirectory)),
            result => result.map(drop),
        }
        .map_err(|error| unreadable(&path.display().to_string(), &error))
    }

    /// Returns the kind of input: a file extension such as `ply`, or `shape`.
    pub fn kind(&self) -> &'static str {
        match &self.content {
            Content::File(file) => file.format.extension(),
            Content::Shape(_) => "shape",
            Content::Raster(..) => "raster",
        }
    }

    /// Whether the input is a .striata file or a stream of one mesh.
    pub fn has_levels(&self) -> bool {
        matches!(&self.content, Content::File(file) if has_levels(file.format)) && !self.has_scene_levels()
    }

    /// Returns the format and the bytes, without compression; `None` for a shape.
    pub(crate) fn bytes(&self) -> Option<(Format, &[u8])> {
        match &self.content {
            Content::File(file) => Some((file.format, file.bytes.as_slice())),
            Content::Shape(_) | Content::Raster(..) => None,
        }
    }

    /// Returns the text of an OBJ file.
    pub fn obj_text(&self) -> Option<&str> {
        self.bytes()
            .filter(|(format, _)| *format == Format::Obj)
            .and_then(|(_, bytes)| str::from_utf8(bytes).ok())
    }

    /// Returns the name and the folder of the file, as readers need them.
    pub(crate) fn source(&self) -> Source<'_> {
        let source = Source::new(&self.name);
        match &self.content {
            Content::File(FileContent { folder: Some(folder), outside_allowed, .. }) => {
                source.with_folder(folder).with_outside_allowed(*outside_allowed)
            }
            _ => source,
        }
    }

    /// Returns the size of the file on disk; `None` for a shape.
    pub fn file_bytes(&self) -> Option<usize> {
        match &self.content {
            Content::File(file) => Some(file.file_bytes),
            Content::Shape(_) => None,
            Content::Raster(path, _) => usize::try_from(std::fs::metadata(path).ok()?.len()).ok(),
        }
    }

    /// Returns the name without its folder, so that files and reports do not reveal local paths.
    pub fn file_name(&self) -> String {
        let name = Path::new(&self.name).file_name();
        name.map_or_else(|| self.name.clone(), |name| name.to_string_lossy().into_owned())
    }

    /// Returns the mesh of a mesh file or shape, or the full mesh of a .striata file or stream.
    ///
    /// Warns the user of missing textures and other parts that were left out. If a stream is cut off, returns
    /// the finest level that it contains and warns the user.
    ///
    /// # Errors
    /// If the file is malformed; the message says where.
    pub fn mesh(&self, output: &Output) -> Result<IndexedMesh, Failure> {
        let file = match &self.content {
            Content::File(file) => file,
            Content::Shape(shape) => return Ok(shape.mesh()),
            Content::Raster(path, RasterArgs { nodata, z_scale }) => {
                let options =
                    PieceOptions::default().with_nodata(*nodata).with_z_scale(z_scale.unwrap_or(1.0));
                let terrain = Terrain::open(std::slice::from_ref(path), &options)?;
                let mesh = terrain.mesh()?;
                output.warn(&terrain.warnings())?;
                return Ok(mesh);
            }
        };
        if self.has_scene_levels() {
            return Ok(self.scene(output)?.flattened()?);
        }
        if has_levels(file.format) {
            let striata = self.striata()?;
            let mesh = striata.mesh().map_err(|error| self.damaged(&error))?;
            self.remark_on(&striata, output)?;
            return Ok(mesh);
        }
        let report = read_bytes_with_report(file.bytes.as_slice(), &self.source());
        let report = report.map_err(|error| self.unreadable_mesh(error))?;
        output.warn(&report.warnings)?;
        Ok(report.mesh)
    }

    /// Returns the failure for a mesh or scene that cannot be read, with the offending line of a text.
    pub(crate) fn unreadable_mesh(&self, error: ReadError) -> Failure {
        let excerpt = self.bytes().and_then(|(_, bytes)| excerpt(&self.name, bytes, &error));
        Failure::from(error).with_excerpt(excerpt)
    }

    /// Warns the user if the stream of a file is cut off.
    ///
    /// # Errors
    /// If the part of the stream that is present is malformed.
    pub fn remark_on(&self, file: &StriataFile<'_>, output: &Output) -> Result<(), Failure> {
        if let Some(remark) = truncation_note(file, &self.name).map_err(|error| self.damaged(&error))? {
            output.say(&remark);
        }
        Ok(())
    }

    /// Opens the input as a .striata file and checks its tables; a stream counts as a file that contains only
    /// a stream.
    ///
    /// The stream may be cut off.
    ///
    /// # Errors
    /// If the input is a mesh, or the file is damaged or of a newer version.
    pub fn striata(&self) -> Result<StriataFile<'_>, Failure> {
        let parsed = match &self.content {
            Content::File(file) if file.format == Format::Striata => {
                striata_stream::open_truncated(file.bytes.as_slice())
            }
            Content::File(file) if file.format == Format::Stream => {
                striata_stream::open_stream(file.bytes.as_slice())
            }
            _ => {
                let message = format!("{}: this is a mesh ({}), not a .striata file", self.name, self.kind());
                return Err(Failure::user(message)
                    .with_hint("build one with `striata build`, or use `striata simplify` on the mesh"));
            }
        };
        parsed.map_err(|error| self.damaged(&error))
    }

    /// Returns the failure for an error in the contents of this file.
    pub fn damaged(&self, error: &striata::file::DecodeError) -> Failure {
        Failure::user(format!("{}: {error}", self.name)).with_hint(decode_hint(error))
    }
}

fn has_levels(format: Format) -> bool {
    matches!(format, Format::Striata | Format::Stream)
}

/// Returns the offending line if the file is text and the error knows the line.
fn excerpt(name: &str, bytes: &[u8], error: &ReadError) -> Option<Excerpt> {
    let ReadError::Malformed { place: Place::Line(line), .. } = error else { return None };
    Excerpt::around(name, std::str::from_utf8(bytes).ok()?, usize::try_from(*line).ok()?)
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    }
}

fn unreadable(name: &str, error: &io::Error) -> Failure {
    let failure = Failure::user(format!("{name}: {error}"));
    match error.kind() {
        io::ErrorKind::NotFound => {
            failure.with_hint("check the path; relative paths start at the current folder")
        }
        io::ErrorKind::IsADirectory => failure.with_hint("name a file in that folder"),
        _ => failure,
    }
}

fn read_stdin() -> io::Result<Bytes> {
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes)?;
    Ok(Bytes::Owned(bytes))
}

fn map(path: &Path) -> io::Result<Bytes> {
    let mut file = File::open(path)?;
    let metadata = file.metadata()?;
    if metadata.is_dir() {
        return Err(io::Error::from(io::ErrorKind::IsADirectory));
    }
    // Pipes and empty files cannot be mapped.
    if !metadata.is_file() || metadata.len() == 0 {
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes)?;
        return Ok(Bytes::Owned(bytes));
    }
    #[expect(unsafe_code, reason = "mapping a file is unsafe by nature; there is no safe way to do it")]
    // SAFETY: the map is only ever read as bytes, and every reader accepts arbitrary bytes. If another
    // process changes the file meanwhile, we may read old or new bytes, and if it truncates the file, a
    // signal may end this process. Outputs are written to a temporary file and then renamed, so neither case
    // can damage a file.
    unsafe {
        Mmap::map(&file).map(Bytes::Mapped)
    }
}
