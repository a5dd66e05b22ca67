//! Meshes out: to a file in one step, or to stdout.

use std::path::Path;

use striata::mesh::IndexedMesh;
use striata_io::{Format, WriteOptions, to_bytes, write, write_atomically};

use crate::args::{FormatArg, FormatArgs};
use crate::failure::Failure;
use crate::output::to_stdout;

/// True where the output is stdout.
pub(crate) fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// The format that a mesh will be written in.
///
/// # Errors
/// Where neither `--to` nor the extension tells, so that it is known before the work begins.
pub(crate) fn format_of(path: &Path, args: &FormatArgs) -> Result<Format, Failure> {
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
    Ok(format)
}

/// How the triangles of a mesh are written, group by group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Drawn {
    /// Three indices each.
    Triangles,
    /// As one strip a group, joined by degenerate triangles.
    Strips(Vec<Vec<u32>>),
    /// As fans.
    Fans(Vec<Vec<Vec<u32>>>),
}

/// Writes the mesh.
///
/// # Errors
/// Where the format cannot hold it or the system refuses; a file that was there is then as it was.
pub(crate) fn save(mesh: &IndexedMesh, drawn: Drawn, path: &Path, args: &FormatArgs) -> Result<(), Failure> {
    let format = format_of(path, args)?;
    let mut options = WriteOptions::default().with_ascii(args.ascii);
    match drawn {
        Drawn::Triangles => {}
        Drawn::Strips(strips) => options = options.with_strips(strips),
        Drawn::Fans(fans) => options = options.with_fans(fans),
    }
    if is_stdout(path) {
        return to_stdout(&to_bytes(format, mesh, &options)?);
    }
    if args.to.is_none() {
        return Ok(write(path, mesh, &options)?);
    }
    let bytes = to_bytes(format, mesh, &options)?;
    Ok(write_atomically(path, |out| out.write_all(&bytes))?)
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
