//! Files in: mapped into memory, unpacked, recognized, and blamed line by line where they are wrong; and shapes.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use memmap2::Mmap;
use striata::file::StriataFile;
use striata::mesh::IndexedMesh;
use striata_io::{Format, Place, ReadError, Source, decompressed, read_bytes};

use crate::failure::{Excerpt, Failure};
use crate::output::Output;
use crate::shapes::Shape;
use crate::stream::remark_on;

/// A file whose bytes are at hand and whose kind is known, or a shape.
#[derive(Debug)]
pub struct Input {
    /// The name that messages show.
    pub name: String,
    content: Content,
}

#[derive(Debug)]
enum Content {
    File(FileContent),
    Shape(Shape),
}

#[derive(Debug)]
struct FileContent {
    format: Format,
    /// As they lie on disk.
    file_bytes: usize,
    folder: Option<PathBuf>,
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
    /// Opens a file, or stdin for `-`, takes gzip and zstd off, and recognizes what is inside; or finds a shape.
    ///
    /// # Errors
    /// Where it cannot be read, is no file that we know, or there is no such shape.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        if let Some(shape) = Shape::named(path)? {
            return Ok(Self { name: path.display().to_string(), content: Content::Shape(shape) });
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
            return Err(ReadError::UnknownFormat { file: name }.into());
        };
        let folder = (!is_stdin).then(|| folder_of(path));
        Ok(Self { name, content: Content::File(FileContent { format, file_bytes, folder, bytes }) })
    }

    /// Looks whether there is such a file or shape, without reading it.
    ///
    /// # Errors
    /// Where there is not.
    pub fn check_exists(path: &Path) -> Result<(), Failure> {
        if path == Path::new("-") || Shape::named(path)?.is_some() {
            return Ok(());
        }
        match std::fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => Err(io::Error::from(io::ErrorKind::IsADirectory)),
            result => result.map(drop),
        }
        .map_err(|error| unreadable(&path.display().to_string(), &error))
    }

    /// What it is, in a word.
    pub fn kind(&self) -> &'static str {
        match &self.content {
            Content::File(file) => file.format.extension(),
            Content::Shape(_) => "shape",
        }
    }

    /// Whether it is a .striata file or a stream.
    pub fn has_levels(&self) -> bool {
        matches!(&self.content, Content::File(file) if has_levels(file.format))
    }

    /// Bytes as they lie on disk; none of a shape.
    pub fn file_bytes(&self) -> Option<usize> {
        match &self.content {
            Content::File(file) => Some(file.file_bytes),
            Content::Shape(_) => None,
        }
    }

    /// The name without its folder: what may be told to others.
    pub fn file_name(&self) -> String {
        let name = Path::new(&self.name).file_name();
        name.map_or_else(|| self.name.clone(), |name| name.to_string_lossy().into_owned())
    }

    /// The mesh of a mesh file or a shape, or the full level of a .striata file or stream; where that is cut off, what is
    /// there of it, which the user is told.
    ///
    /// # Errors
    /// Where the bytes are no such thing; the message names the place.
    pub fn mesh(&self, output: &Output) -> Result<IndexedMesh, Failure> {
        let file = match &self.content {
            Content::File(file) => file,
            Content::Shape(shape) => return Ok(shape.mesh()),
        };
        if has_levels(file.format) {
            let striata = self.striata()?;
            let mesh = striata.mesh().map_err(|error| self.damaged(&error))?;
            self.remark_on(&striata, output)?;
            return Ok(mesh);
        }
        let mut source = Source::new(&self.name);
        if let Some(folder) = &file.folder {
            source = source.with_folder(folder);
        }
        read_bytes(file.bytes.as_slice(), &source).map_err(|error| {
            let excerpt = excerpt(&self.name, file.bytes.as_slice(), &error);
            Failure::from(error).with_excerpt(excerpt)
        })
    }

    /// Tells the user where a file ends within its stream.
    ///
    /// # Errors
    /// Where what is there of the stream is unsound.
    pub fn remark_on(&self, file: &StriataFile<'_>, output: &Output) -> Result<(), Failure> {
        if let Some(remark) = remark_on(file, &self.name).map_err(|error| self.damaged(&error))? {
            output.say(&remark);
        }
        Ok(())
    }

    /// The container, its tables read and checked; a stream stands for one that holds nothing else.
    ///
    /// Either may be cut off within its stream.
    ///
    /// # Errors
    /// Where the file is a mesh, or a container that is damaged or too new.
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
                    .with_hint("make one with `striata build`, or use `striata simplify` on the mesh"));
            }
        };
        parsed.map_err(|error| self.damaged(&error))
    }

    /// A failure to decode this file.
    pub fn damaged(&self, error: &striata::file::DecodeError) -> Failure {
        Failure::user(format!("{}: {error}", self.name))
            .with_hint("the file is damaged or cut off; build it again, or copy it again")
    }
}

fn has_levels(format: Format) -> bool {
    matches!(format, Format::Striata | Format::Stream)
}

/// The line to blame, where the file is text and the error knows its line.
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
        io::ErrorKind::NotFound => failure.with_hint("check the path; a relative one starts at this folder"),
        io::ErrorKind::IsADirectory => failure.with_hint("name a file inside the folder"),
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
    // SAFETY: the map is only ever read as bytes, and every reader takes any bytes. Another process that
    // changes the file meanwhile can make us read old or new bytes, and one that cuts it off can end us by a
    // signal; outputs are written beside their target and renamed, so no file is lost to either.
    unsafe {
        Mmap::map(&file).map(Bytes::Mapped)
    }
}
