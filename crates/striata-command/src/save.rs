//! Writes meshes to stdout, or to files that appear complete or not at all.

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::{fs, io};

use striata::mesh::IndexedMesh;
use striata_io::{
    EncodedMesh, FileBatch, Format, Scene, WriteError, WriteOptions, convert_colors, encode_mesh,
    encode_scene, needs_other_colors, write_atomically,
};

use crate::args::{FormatArg, FormatArgs};
use crate::failure::Failure;
use crate::output::{Output, to_stdout};
use crate::shapes::Shape;

/// Whether the path is `-`, which stands for stdout (or stdin).
pub fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// Returns the format that a mesh will be written in; called before the work begins, to fail early.
///
/// # Errors
/// If neither `--to` nor the extension names a mesh format.
pub fn format_of(path: &Path, args: &FormatArgs) -> Result<Format, Failure> {
    let format = match args.to {
        Some(to) => to.into(),
        None if is_stdout(path) => Format::Ply,
        None => Format::from_extension(path).ok_or_else(|| {
            Failure::usage(format!("{}: the extension is not that of a mesh format", path.display()))
                .with_hint("use the extension .ply, .obj, .stl, .off, .gltf or .glb, or add --to FORMAT")
        })?,
    };
    if format == Format::Stream {
        return Err(Failure::usage(format!(
            "{}: a single level cannot be written as a stream",
            path.display()
        ))
        .with_hint("`striata encode MESH -o OUT.stri` writes streams"));
    }
    if format == Format::Striata {
        return Err(Failure::usage(format!(
            "{}: a single level cannot be written as a .striata file",
            path.display()
        ))
        .with_hint("`striata build MESH -o OUT.striata` writes .striata files"));
    }
    if args.ascii && format != Format::Ply {
        return Err(Failure::usage(format!(
            "--ascii is for PLY, but {} is written as {format}",
            display_name(path)
        ))
        .with_hint("remove --ascii, or use the extension .ply"));
    }
    let flag = args.gltf.first_given_flag().or_else(|| args.gltf.first_plain_flag());
    if let Some(flag) = flag.filter(|_| !matches!(format, Format::Gltf | Format::Glb)) {
        return Err(Failure::usage(format!(
            "{flag} is for glTF, but {} is written as {format}",
            display_name(path)
        ))
        .with_hint(format!("remove {flag}, or use the extension .glb or .gltf")));
    }
    Ok(format)
}

/// The primitives that the triangles of a mesh are written as, group by group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Primitives {
    /// A triangle list, in cache order.
    Triangles,
    /// A triangle list in the order of the mesh.
    UnsortedTriangles,
    /// One strip per group, joined by degenerate triangles; an empty strip stands for a triangle list.
    Strips(Vec<Vec<u32>>),
    /// The fans of each group.
    Fans(Vec<Vec<Vec<u32>>>),
}

/// Returns the contents of the files that a mesh is written to.
///
/// # Errors
/// If the format cannot represent the mesh.
fn encoded(
    mesh: &IndexedMesh,
    primitives: Primitives,
    path: &Path,
    args: &FormatArgs,
) -> Result<EncodedMesh, Failure> {
    let format = format_of(path, args)?;
    let mut mesh = Cow::Borrowed(mesh);
    if needs_other_colors(&mesh, format) {
        convert_colors(mesh.to_mut(), format);
    }
    let mut options = args.gltf.applied_to(WriteOptions::default().with_ascii(args.ascii));
    match primitives {
        Primitives::Triangles => options = options.with_shading(!args.gltf.raw).with_cache_order(true),
        Primitives::UnsortedTriangles => options = options.with_shading(!args.gltf.raw),
        Primitives::Strips(strips) => options = options.with_strips(strips),
        Primitives::Fans(fans) => options = options.with_fans(fans),
    }
    Ok(encode_mesh(format, &mesh, &options, folder_path(path))?)
}

/// Returns the path whose folder gets images, material libraries and buffers; those of stdout get none.
pub fn folder_path(path: &Path) -> Option<&Path> {
    (!is_stdout(path)).then_some(path)
}

/// Returns the contents of the files that a scene is written to: glTF keeps it as it is; other formats get one
/// mesh.
///
/// # Errors
/// If the format cannot represent the scene.
fn encoded_scene(
    scene: &Scene,
    has_cache_order: bool,
    path: &Path,
    args: &FormatArgs,
) -> Result<EncodedMesh, Failure> {
    let format = format_of(path, args)?;
    let options = WriteOptions::default().with_ascii(args.ascii).with_cache_order(has_cache_order);
    let options = args.gltf.applied_to(options);
    Ok(encode_scene(format, scene, &options, folder_path(path))?)
}

/// Writes a scene to a file or to stdout, with its triangles in cache order or in their own.
///
/// # Errors
/// If the format cannot represent the scene or writing fails; existing files are then left unchanged.
pub fn write_scene(
    scene: &Scene,
    has_cache_order: bool,
    path: &Path,
    args: &FormatArgs,
    output: &Output,
) -> Result<(), Failure> {
    write_encoded(&encoded_scene(scene, has_cache_order, path, args)?, path, output)
}

/// Writes a mesh to a file or to stdout.
///
/// # Errors
/// If the format cannot represent the mesh or writing fails; an existing file is then left unchanged.
pub fn write_mesh(
    mesh: &IndexedMesh,
    primitives: Primitives,
    path: &Path,
    args: &FormatArgs,
    output: &Output,
) -> Result<(), Failure> {
    write_encoded(&encoded(mesh, primitives, path, args)?, path, output)
}

/// Writes a file with its companions, or the file alone to stdout. Warns of what the format cannot store.
///
/// # Errors
/// If writing fails; existing files are then left unchanged.
pub fn write_encoded(encoded: &EncodedMesh, path: &Path, output: &Output) -> Result<(), Failure> {
    output.warn_of_losses(&encoded.warnings);
    if is_stdout(path) {
        return to_stdout(&encoded.bytes);
    }
    Ok(encoded.write(path)?)
}

/// Writes bytes to a file, atomically, or to stdout.
///
/// # Errors
/// If writing fails; an existing file is then left unchanged.
pub fn write_bytes(bytes: &[u8], path: &Path) -> Result<(), Failure> {
    if is_stdout(path) {
        return to_stdout(bytes);
    }
    Ok(write_atomically(path, |out| out.write_all(bytes))?)
}

/// The output files of several levels, which appear all together or not at all; a single level may go to
/// stdout.
#[derive(Debug)]
pub struct LevelFiles<'a> {
    format: &'a FormatArgs,
    output: &'a Output,
    /// The files written so far, if there are several levels.
    batch: Option<FileBatch>,
}

impl<'a> LevelFiles<'a> {
    /// Starts without any files.
    pub fn new(format: &'a FormatArgs, has_several: bool, output: &'a Output) -> Self {
        Self { format, output, batch: has_several.then(FileBatch::default) }
    }

    /// Writes a level; one of several is visible under its name only after [`commit`](Self::commit).
    ///
    /// # Errors
    /// If the format cannot represent the mesh or writing fails.
    pub fn write(&mut self, mesh: &IndexedMesh, primitives: Primitives, path: &Path) -> Result<(), Failure> {
        self.write_contents(&encoded(mesh, primitives, path, self.format)?, path)
    }

    /// Writes a level of a scene, like [`write`](Self::write).
    ///
    /// # Errors
    /// If the format cannot represent the scene or writing fails.
    pub fn write_scene(&mut self, scene: &Scene, path: &Path) -> Result<(), Failure> {
        self.write_contents(&encoded_scene(scene, true, path, self.format)?, path)
    }

    fn write_contents(&mut self, encoded: &EncodedMesh, path: &Path) -> Result<(), Failure> {
        match &mut self.batch {
            Some(batch) => {
                self.output.warn_of_losses(&encoded.warnings);
                Ok(encoded.stage(path, batch)?)
            }
            None => write_encoded(encoded, path, self.output),
        }
    }

    /// Gives all files their final names.
    ///
    /// # Errors
    /// If renaming fails; all existing files are then left unchanged.
    pub fn commit(self) -> Result<(), Failure> {
        Ok(self.batch.map_or(Ok(()), FileBatch::commit)?)
    }
}

/// Returns a path for messages: `stdout` for `-`.
pub fn display_name(path: &Path) -> String {
    if is_stdout(path) { "stdout".to_owned() } else { path.display().to_string() }
}

/// Note after an output name that the user did not choose.
pub const DEFAULT_NAME_NOTE: &str = "; use -o to choose another name";

/// Returns the default name of an output: the input with another extension, in the same folder. Outputs of
/// built-in shapes go to the current folder.
///
/// # Errors
/// If the input has no file name, or the output would overwrite it.
pub fn default_output_path(input: &Path, extension: &str) -> Result<PathBuf, Failure> {
    let hint = format!("name the output: -o OUT.{extension}");
    if is_stdout(input) {
        return Err(Failure::usage("the input is stdin, which gives the output no name").with_hint(hint));
    }
    if let Some(shape) = Shape::from_input_name(input)? {
        return Ok(PathBuf::from(format!("{}.{extension}", shape.name())));
    }
    if std::fs::metadata(input).is_ok_and(|there| !there.is_file()) {
        let message = format!("{}: this is not a regular file, so the output needs a name", input.display());
        return Err(Failure::usage(message).with_hint(hint));
    }
    let is_packed = |e: &std::ffi::OsStr| e.eq_ignore_ascii_case("gz") || e.eq_ignore_ascii_case("zst");
    let bare =
        if input.extension().is_some_and(is_packed) { input.with_extension("") } else { input.to_owned() };
    let output = bare.with_extension(extension);
    let is_input = output == input
        || output.canonicalize().is_ok_and(|output| input.canonicalize().is_ok_and(|input| output == input));
    if is_input {
        let message = format!("{}: the output would overwrite the input", input.display());
        return Err(Failure::usage(message).with_hint(hint));
    }
    check_folder(&output)?;
    Ok(output)
}

/// Checks that a file can be created or replaced, before the work begins.
///
/// # Errors
/// If the path is a folder, or its folder is missing or cannot be written to.
pub fn check_place(path: &Path) -> Result<(), Failure> {
    if path.is_dir() {
        let source = io::ErrorKind::IsADirectory.into();
        return Err(WriteError::Io { file: path.display().to_string(), source }.into());
    }
    check_folder(path)
}

/// Checks that the folder of an output exists and takes new files, as outputs are until they are complete.
/// Addresses of web servers and buckets, pipes and devices have no such folder.
///
/// # Errors
/// If the folder is missing or cannot be written to.
pub fn check_folder(path: &Path) -> Result<(), Failure> {
    let is_device = || fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir());
    if is_stdout(path) || path.to_string_lossy().contains("://") || is_device() {
        return Ok(());
    }
    // The file that a link points to is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    if !folder.is_dir() {
        let (path, folder) = (path.display(), folder.display());
        return Err(Failure::user(format!("{path}: the folder {folder} does not exist"))
            .with_hint("make the output's folder first"));
    }
    let tried = tempfile::Builder::new().prefix(".striata-").suffix(".part").tempfile_in(folder);
    // The name of the temporary file, which some errors have, means nothing to the user.
    tried.map(drop).map_err(|error| {
        Failure::user(format!("{}: cannot write to the folder: {}", path.display(), error.kind()))
            .with_hint("choose a folder that you can write to")
    })
}

/// Checks that an output name does not end in `.gz` or `.zst`, since these outputs are not compressed again.
///
/// # Errors
/// If the extension is `.gz` or `.zst`.
pub fn check_not_compressed(path: &Path, what: &str) -> Result<(), Failure> {
    let is_packed =
        path.extension().is_some_and(|e| e.eq_ignore_ascii_case("gz") || e.eq_ignore_ascii_case("zst"));
    if !is_packed || is_stdout(path) {
        return Ok(());
    }
    Err(Failure::usage(format!("{}: {what} are already compressed", path.display()))
        .with_hint("remove .gz or .zst from the name"))
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

/// Returns the place of a terrain on the Earth, for reports.
pub fn georeference_of(mesh: &IndexedMesh) -> Option<serde_json::Value> {
    serde_json::from_str(&mesh.appearance.georeference).ok()
}
