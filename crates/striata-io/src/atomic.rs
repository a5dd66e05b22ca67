//! Atomic writing: a file completely or not at all, several files together or none of them.
//!
//! The bytes go to a temporary file next to the target, which is then renamed to the target in one step.
//! Other processes see the old file or the new one, never half of one, and a failure leaves nothing behind.
//! Targets that are not regular files (pipes, `/dev/stdout`) cannot be renamed and are written directly.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempPath};

use crate::WriteError;

/// Writes a file completely or not at all.
///
/// The file is not flushed to the disk: a crash of the machine, unlike one of the program, may lose it.
///
/// # Errors
/// Returns [`WriteError::Io`] with the error of the system or of `write`; the target is then unchanged.
/// [`WriteError::Io`] with what the system or `write` says; the target is then as it was.
pub fn write_atomically(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), WriteError> {
    write_whole(path, write).map_err(|source| WriteError::Io { file: path.display().to_string(), source })
}

fn write_whole(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    if fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
        let mut file = BufWriter::new(fs::File::create(path)?);
        write(&mut file)?;
        return file.flush();
    }
    let StagedFile { file, target, .. } = stage(path, write)?;
    file.persist(target).map_err(|error| error.error)
}

/// Files that are written together: in the end either all of them exist, or none.
///
/// ```no_run
/// # use std::path::Path;
/// let mut files = striata_io::FileBatch::default();
/// files.write(Path::new("level-50.bin"), |out| out.write_all(b"fine"))?;
/// files.write(Path::new("level-10.bin"), |out| out.write_all(b"coarse"))?;
/// files.commit()?; // until here, neither has a name
/// # Ok::<(), striata_io::WriteError>(())
/// ```
#[derive(Debug, Default)]
pub struct FileBatch {
    staged: Vec<StagedFile>,
}

/// File that is written and waits to be renamed.
#[derive(Debug)]
struct StagedFile {
    file: TempPath,
    /// Path as given by the caller.
    path: PathBuf,
    /// Path after following links.
    target: PathBuf,
}

impl FileBatch {
    /// Writes a file that appears together with the others.
    ///
    /// # Errors
    /// Returns [`WriteError::Io`] with the error of the system or of `write`, or if the path is not a
    /// regular file.
    pub fn write(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), WriteError> {
        let staged = match fs::metadata(path) {
            Ok(there) if !there.is_file() && !there.is_dir() => {
                Err(io::Error::other("several files cannot go to a pipe or a device"))
            }
            _ => stage(path, write),
        };
        self.staged
            .push(staged.map_err(|source| WriteError::Io { file: path.display().to_string(), source })?);
        Ok(())
    }

    /// Writes a file that several others may share: it is written once.
    ///
    /// # Errors
    /// Returns the errors of [`write`](Self::write), or [`WriteError::Io`] if a file with other contents was
    /// written to the same path.
    pub fn write_shared(&mut self, path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
        let Some(known) = self.staged.iter().find(|staged| staged.path == path) else {
            return self.write(path, |out| out.write_all(bytes));
        };
        let error = match fs::read(&known.file) {
            Ok(found) if found == bytes => return Ok(()),
            Ok(_) => io::Error::other("two outputs need different files of this name"),
            Err(error) => error,
        };
        Err(WriteError::Io { file: path.display().to_string(), source: error })
    }

    /// Renames all files to their targets.
    ///
    /// # Errors
    /// Returns [`WriteError::Io`] if one cannot be renamed; the others are then removed, and the files they
    /// replaced are restored.
    pub fn commit(self) -> Result<(), WriteError> {
        let mut named = Vec::new();
        for StagedFile { file, path, target } in self.staged {
            let replaced = keep_old(&target).and_then(|old| {
                file.persist(&target).map_err(|error| error.error)?;
                Ok(old)
            });
            match replaced {
                Ok(old) => named.push((target, old)),
                Err(source) => {
                    named.into_iter().rev().for_each(|(target, old)| undo_rename(target, old));
                    return Err(WriteError::Io { file: path.display().to_string(), source });
                }
            }
        }
        Ok(())
    }
}

/// Undoes a rename if possible; the error that made it necessary is the one that is reported.
fn undo_rename(target: PathBuf, old: Option<TempPath>) {
    let _ = match old {
        Some(old) => old.persist(&target).map_err(|error| error.error),
        None => fs::remove_file(&target),
    };
}

/// Creates a second name for the file that is about to be replaced, if it exists; dropping the result
/// removes that name.
fn keep_old(target: &Path) -> io::Result<Option<TempPath>> {
    if !target.exists() {
        return Ok(None);
    }
    let link = |name: &Path| fs::hard_link(target, name).or_else(|_| fs::copy(target, name).map(drop));
    let old = tempfile::Builder::new().prefix(".striata-").suffix(".old").make_in(folder_of(target), link)?;
    Ok(Some(old.into_temp_path()))
}

/// Writes a temporary file next to its target.
fn stage(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<StagedFile> {
    let (target, permissions) = match fs::metadata(path) {
        Ok(there) if there.is_dir() => return Err(io::Error::from(io::ErrorKind::IsADirectory)),
        // A link stays a link: the file it points to is replaced.
        Ok(there) => (fs::canonicalize(path)?, Some(there.permissions())),
        Err(_) => (path.to_owned(), None),
    };
    let folder = folder_of(&target);
    // If the folder is missing, this reports the system's own error.
    fs::metadata(&folder)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".striata-").suffix(".part");
    // Otherwise only the owner could read the file; the process's umask still applies.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder).map_err(without_path)?;
    let mut buffered = BufWriter::with_capacity(1 << 16, file);
    write(&mut buffered)?;
    let file: NamedTempFile = buffered.into_inner().map_err(io::IntoInnerError::into_error)?;
    if let Some(permissions) = permissions {
        fs::set_permissions(file.path(), permissions)?;
    }
    Ok(StagedFile { file: file.into_temp_path(), path: path.to_owned(), target })
}

fn folder_of(target: &Path) -> PathBuf {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// Removes the temporary file name, which the caller never chose, from a system error.
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
    fn a_batch_writes_all_files_or_none() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let names = || {
            let entries = fs::read_dir(folder.path()).unwrap();
            let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
            names.sort();
            names
        };
        fs::write(path("b"), "old").unwrap();
        let batch = |last: &str| {
            let mut files = FileBatch::default();
            for name in ["a", "b", last] {
                files.write(&path(name), |out| out.write_all(name.as_bytes()))?;
            }
            Ok::<_, WriteError>(files)
        };
        // A batch that is never committed, and one that cannot be written.
        drop(batch("c").unwrap());
        assert!(batch("no/c").is_err());
        assert_eq!((names(), fs::read(path("b")).unwrap()), (vec!["b".to_owned()], b"old".to_vec()));
        // A batch whose last target becomes a folder in the meantime.
        let files = batch("c").unwrap();
        fs::create_dir(path("c")).unwrap();
        assert!(files.commit().is_err());
        assert_eq!((names(), fs::read(path("b")).unwrap()), (vec!["b".into(), "c".into()], b"old".to_vec()));
        fs::remove_dir(path("c")).unwrap();
        batch("c").unwrap().commit().unwrap();
        assert_eq!(
            (names(), fs::read(path("b")).unwrap()),
            (["a", "b", "c"].map(Into::into).to_vec(), b"b".to_vec())
        );
    }

    #[test]
    fn a_missing_folder_is_reported_without_the_temporary_name() {
        let folder = tempfile::tempdir().unwrap();
        let error = write_atomically(&folder.path().join("no/mesh.off"), |_| Ok(())).unwrap_err();
        assert!(!error.to_string().contains(".part"), "{error}");
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
