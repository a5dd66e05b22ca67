//! Writing a file whole or not at all.
//!
//! The bytes go to a temporary file beside the target, which then takes the target's name in one step.
//! Whoever looks at the target sees the old file or the new one, never half of one, and a failure
//! leaves nothing behind. What is no plain file (a pipe, `/dev/stdout`) has no such step and is written straight.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::WriteError;

/// Writes a file whole or not at all.
///
/// Nothing is flushed to the disk itself: a crash of the machine, unlike one of the program, may lose
/// the file.
///
/// # Errors
/// [`WriteError::Io`] with what the system or `write` says; the target is then as it was.
pub fn write_atomically(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), WriteError> {
    write_whole(path, write).map_err(|source| WriteError::Io { file: path.display().to_string(), source })
}

fn write_whole(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let (target, permissions) = match fs::metadata(path) {
        Ok(there) if there.is_dir() => return Err(io::Error::from(io::ErrorKind::IsADirectory)),
        Ok(there) if !there.is_file() => {
            let mut file = BufWriter::new(fs::File::create(path)?);
            write(&mut file)?;
            return file.flush();
        }
        // A link stays a link: what it points to is replaced.
        Ok(there) => (fs::canonicalize(path)?, Some(there.permissions())),
        Err(_) => (path.to_owned(), None),
    };
    let folder = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    };
    // A folder that is missing is told in the system's own words.
    fs::metadata(&folder)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".striata-").suffix(".part");
    // Else the file would be readable by its owner alone; the mask of the process still applies.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder).map_err(without_path)?;
    let mut buffered = BufWriter::with_capacity(1 << 16, file);
    write(&mut buffered)?;
    let file = buffered.into_inner().map_err(io::IntoInnerError::into_error)?;
    if let Some(permissions) = permissions {
        fs::set_permissions(file.path(), permissions)?;
    }
    file.persist(target).map_err(|error| error.error)?;
    Ok(())
}

/// What the system said, without the temporary name that the caller never chose.
fn without_path(error: io::Error) -> io::Error {
    match error.kind() {
        kind @ (io::ErrorKind::PermissionDenied | io::ErrorKind::StorageFull) => kind.into(),
        _ => error,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mesh.off");
        write_atomically(&path, |out| out.write_all(b"old")).unwrap();
        let failed = write_atomically(&path, |out| {
            out.write_all(b"half of the new")?;
            Err(io::Error::other("no more"))
        });
        assert!(failed.unwrap_err().to_string().ends_with("no more"));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        write_atomically(&path, |out| out.write_all(b"new")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
    }

    #[test]
    fn a_missing_folder_is_told_without_the_temporary_name() {
        let folder = tempfile::tempdir().unwrap();
        let said = write_atomically(&folder.path().join("no/mesh.off"), |_| Ok(())).unwrap_err();
        assert!(!said.to_string().contains(".part"), "{said}");
    }

    #[test]
    #[cfg(unix)]
    fn links_devices_and_permissions_stay_what_they_are() {
        use std::os::unix::fs::{PermissionsExt as _, symlink};
        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (folder.path().join("real"), folder.path().join("link"));
        fs::write(&real, "old").unwrap();
        fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
        symlink(&real, &link).unwrap();
        write_atomically(&link, |out| out.write_all(b"new")).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&real).unwrap(), b"new");
        assert_eq!(fs::metadata(&real).unwrap().permissions().mode() & 0o777, 0o640);
        let device = Path::new("/dev/null");
        write_atomically(device, |out| out.write_all(b"new")).unwrap();
        assert!(!fs::metadata(device).unwrap().is_file());
        assert!(write_atomically(folder.path(), |_| Ok(())).is_err());
    }
}
