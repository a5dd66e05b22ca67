//! Meshes out: to a file in one step, or to stdout.

use std::path::{Path, PathBuf};

use striata::mesh::IndexedMesh;
use striata_io::{FileBatch, Format, WriteOptions, to_file_bytes, write_atomically};

use crate::args::{FormatArg, FormatArgs};
use crate::failure::Failure;
use crate::output::to_stdout;
use crate::shapes::Shape;

/// True where the output is stdout.
pub fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// The format that a mesh will be written in.
///
/// # Errors
/// Where neither `--to` nor the extension tells, so that it is known before the work begins.
pub fn format_of(path: &Path, args: &FormatArgs) -> Result<Format, Failure> {
    let format = match args.to {
        Some(to) => to.into(),
        None if is_stdout(path) => Format::Ply,
        None => Format::from_extension(path).ok_or_else(|| {
            Failure::user(format!("{}: the extension names no mesh format", path.display()))
                .with_hint("end the name in .ply .obj .stl .off .gltf or .glb, or add --to FORMAT")
        })?,
    };
    if format == Format::Stream {
        return Err(Failure::user(format!("{}: one level is no stream", path.display()))
            .with_hint("`striata encode MESH -o OUT.stri` makes one from a mesh"));
    }
    if format == Format::Striata {
        return Err(Failure::user(format!("{}: one level is no .striata file", path.display()))
            .with_hint("`striata build MESH -o OUT.striata` makes one from a mesh"));
    }
    if args.ascii && format != Format::Ply {
        return Err(Failure::user(format!(
            "--ascii is for PLY, and {} is written as {format}",
            name_of(path)
        ))
        .with_hint("leave --ascii out, or end the name in .ply"));
    }
    Ok(format)
}

/// How the triangles of a mesh are written, group by group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Drawn {
    /// Three indices each.
    Triangles,
    /// As one strip a group, joined by degenerate triangles; a group without one as single triangles.
    Strips(Vec<Vec<u32>>),
    /// As fans.
    Fans(Vec<Vec<Vec<u32>>>),
}

/// The bytes of the file that a mesh goes to.
///
/// # Errors
/// If the format cannot hold it.
fn bytes_of(mesh: &IndexedMesh, drawn: Drawn, path: &Path, args: &FormatArgs) -> Result<Vec<u8>, Failure> {
    let format = format_of(path, args)?;
    let mut options = WriteOptions::default().with_ascii(args.ascii);
    match drawn {
        Drawn::Triangles => {}
        Drawn::Strips(strips) => options = options.with_strips(strips),
        Drawn::Fans(fans) => options = options.with_fans(fans),
    }
    Ok(to_file_bytes(path, format, mesh, &options)?)
}

/// Writes the mesh.
///
/// # Errors
/// If the format cannot hold it or the system refuses; a file that was there is then as it was.
pub fn save(mesh: &IndexedMesh, drawn: Drawn, path: &Path, args: &FormatArgs) -> Result<(), Failure> {
    put(&bytes_of(mesh, drawn, path, args)?, path)
}

/// Writes bytes to a file in one step, or to stdout.
///
/// # Errors
/// If the system refuses; a file that was there is then as it was.
pub fn put(bytes: &[u8], path: &Path) -> Result<(), Failure> {
    if is_stdout(path) {
        return to_stdout(bytes);
    }
    Ok(write_atomically(path, |out| out.write_all(bytes))?)
}

/// The files of several levels, which are there together or not at all; a single one may go to stdout.
#[derive(Debug)]
pub struct LevelFiles<'a> {
    format: &'a FormatArgs,
    /// Of several levels.
    batch: Option<FileBatch>,
}

impl<'a> LevelFiles<'a> {
    /// No files yet.
    pub fn new(format: &'a FormatArgs, are_several: bool) -> Self {
        Self { format, batch: are_several.then(FileBatch::default) }
    }

    /// Writes a level.
    ///
    /// # Errors
    /// If the format cannot hold it or the system refuses.
    pub fn save(&mut self, mesh: &IndexedMesh, drawn: Drawn, path: &Path) -> Result<(), Failure> {
        let bytes = bytes_of(mesh, drawn, path, self.format)?;
        match &mut self.batch {
            Some(batch) => Ok(batch.write(path, |out| out.write_all(&bytes))?),
            None => put(&bytes, path),
        }
    }

    /// Gives several files their names.
    ///
    /// # Errors
    /// If the system refuses; all files that were there are then as they were.
    pub fn commit(self) -> Result<(), Failure> {
        Ok(self.batch.map_or(Ok(()), FileBatch::commit)?)
    }
}

/// A path for people.
pub fn name_of(path: &Path) -> String {
    if is_stdout(path) { "stdout".to_owned() } else { path.display().to_string() }
}

/// What is said of a name that the user did not give.
pub const CHOSEN_NAME: &str = "; -o names another";

/// The name that an output has if the user gives none: that of the input with another extension, in the same folder; that of
/// a shape in the current one.
///
/// # Errors
/// If the input has no name, or that would be the input itself.
pub fn beside(input: &Path, extension: &str) -> Result<PathBuf, Failure> {
    let hint = format!("name the output: -o OUT.{extension}");
    if is_stdout(input) {
        return Err(Failure::user("stdin has no name that the output could take").with_hint(hint));
    }
    if let Some(shape) = Shape::named(input)? {
        return Ok(PathBuf::from(format!("{}.{extension}", shape.name())));
    }
    if std::fs::metadata(input).is_ok_and(|there| !there.is_file()) {
        let message = format!("{}: this is no plain file that the output could lie next to", input.display());
        return Err(Failure::user(message).with_hint(hint));
    }
    let is_packed = |e: &std::ffi::OsStr| e.eq_ignore_ascii_case("gz") || e.eq_ignore_ascii_case("zst");
    let bare =
        if input.extension().is_some_and(is_packed) { input.with_extension("") } else { input.to_owned() };
    let output = bare.with_extension(extension);
    let is_input = output == input
        || matches!((output.canonicalize(), input.canonicalize()), (Ok(output), Ok(input)) if output == input);
    if is_input {
        let message = format!("{}: the output would take the place of the input", input.display());
        return Err(Failure::user(message).with_hint(hint));
    }
    Ok(output)
}

/// Refuses names that promise a compression which nobody does.
///
/// # Errors
/// If the name ends in `.gz` or `.zst`.
pub fn check_not_packed(path: &Path, what: &str) -> Result<(), Failure> {
    let is_packed =
        path.extension().is_some_and(|e| e.eq_ignore_ascii_case("gz") || e.eq_ignore_ascii_case("zst"));
    if !is_packed || is_stdout(path) {
        return Ok(());
    }
    Err(Failure::user(format!("{}: {what} are not compressed any further", path.display()))
        .with_hint("leave .gz or .zst out of the name"))
}

impl From<FormatArg> for Format {
    fn from(format: FormatArg) -> Self {
        match format {
            FormatArg::Ply => Self::Ply,
            FormatArg::Obj => Self::Obj,
            FormatArg::Stl => Self::Stl,
            FormatArg::Off => Self::Off,
            FormatArg::Gltf => Self::Gltf,
            FormatArg::Glb => Self::Glb,
        }
    }
}
