//! Opens files beneath a folder: no link leads out of it.

#[cfg(not(target_family = "wasm"))]
pub(super) use native::Folders;
#[cfg(target_family = "wasm")]
pub(super) use web::Folders;

/// Why a file is not opened.
#[derive(Debug)]
pub(super) enum Missing {
    NotFound,
    #[cfg_attr(target_family = "wasm", expect(dead_code, reason = "there are no files"))]
    Refused(String),
}

#[cfg(target_family = "wasm")]
mod web {
    use std::path::Path;

    use super::super::FoundFile;
    use super::super::names::RelativePath;
    use super::Missing;

    /// There are no folders.
    #[derive(Default)]
    pub(in super::super) struct Folders;

    impl Folders {
        pub(in super::super) fn open(
            &mut self,
            _folder: &Path,
            _path: &RelativePath,
            _in_any_case: bool,
        ) -> Result<FoundFile, Missing> {
            Err(Missing::NotFound)
        }
    }
}

#[cfg(not(target_family = "wasm"))]
mod native {
    use std::collections::BTreeMap;
    use std::io;
    use std::path::{Component, Path, PathBuf};

    use cap_std::ambient_authority;
    use cap_std::fs::Dir;

    use super::super::FoundFile;
    use super::super::names::RelativePath;
    use super::Missing;

    /// Names in a folder, by their lower-case form.
    type Listing = BTreeMap<String, String>;

    /// Folders in which names begin, by how far they are above that of the source.
    #[derive(Default)]
    pub(in super::super) struct Folders {
        bases: BTreeMap<usize, Vec<BaseFolder>>,
    }

    /// Folder that nothing leads out of.
    struct BaseFolder {
        dir: Dir,
        path: PathBuf,
        listings: BTreeMap<String, Listing>,
    }

    impl Folders {
        /// Opens a path relative to `folder`; if `in_any_case` is set, only under names that differ in upper
        /// or lower case.
        pub(in super::super) fn open(
            &mut self,
            folder: &Path,
            path: &RelativePath,
            in_any_case: bool,
        ) -> Result<FoundFile, Missing> {
            if path.parts.is_empty() {
                return Err(Missing::NotFound);
            }
            let bases = self.bases.entry(path.ups).or_insert_with(|| bases_above(folder, path.ups));
            let mut missing = Missing::NotFound;
            for base in bases {
                let opened = match in_any_case {
                    false => base.open(&path.parts.join("/")),
                    true => base.in_any_case(&path.parts).map_or(Err(Missing::NotFound), |p| base.open(&p)),
                };
                match opened {
                    Ok(opened) => return Ok(opened),
                    Err(Missing::NotFound) => {}
                    Err(refused) => missing = refused,
                }
            }
            Err(missing)
        }
    }

    /// Opens the folders that are `ups` above `folder`: by its path as it stands, and, if it contains links,
    /// by its path without them.
    fn bases_above(folder: &Path, ups: usize) -> Vec<BaseFolder> {
        if ups == 0 {
            return BaseFolder::open_folder(folder.to_owned()).into_iter().collect();
        }
        let above = |path: PathBuf| path.ancestors().nth(ups).map(Path::to_owned);
        let plain = std::path::absolute(folder).ok().map(|path| without_dots(&path)).and_then(above);
        let real = folder.canonicalize().ok().and_then(above).filter(|real| Some(real) != plain.as_ref());
        plain.into_iter().chain(real).filter_map(BaseFolder::open_folder).collect()
    }

    fn without_dots(path: &Path) -> PathBuf {
        let mut out = PathBuf::new();
        for part in path.components() {
            match part {
                Component::CurDir => {}
                Component::ParentDir => drop(out.pop()),
                part => out.push(part),
            }
        }
        out
    }

    impl BaseFolder {
        fn open_folder(path: PathBuf) -> Option<Self> {
            let dir = Dir::open_ambient_dir(&path, ambient_authority()).ok()?;
            Some(Self { dir, path, listings: BTreeMap::new() })
        }

        fn open(&self, relative: &str) -> Result<FoundFile, Missing> {
            // Opening a pipe would block until it has a writer.
            if !self.dir.metadata(relative).map_err(|error| missing(&error))?.is_file() {
                return Err(Missing::Refused("not a regular file".to_owned()));
            }
            let file = self.dir.open(relative).map_err(|error| missing(&error))?;
            Ok(FoundFile { file: file.into_std(), path: self.path.join(relative) })
        }

        /// Finds a path whose parts have the given names in upper or lower case.
        fn in_any_case(&mut self, parts: &[String]) -> Option<String> {
            let mut path = String::new();
            for part in parts {
                let name = if self.dir.symlink_metadata(joined(&path, part)).is_ok() {
                    part.clone()
                } else {
                    self.listing(&path).get(&part.to_lowercase())?.clone()
                };
                path = joined(&path, &name);
            }
            Some(path)
        }

        fn listing(&mut self, folder: &str) -> &Listing {
            let Self { dir, listings, .. } = self;
            listings.entry(folder.to_owned()).or_insert_with(|| {
                let entries = dir.read_dir(if folder.is_empty() { "." } else { folder });
                let mut names: Vec<String> = entries
                    .into_iter()
                    .flatten()
                    .flatten()
                    .filter_map(|entry| entry.file_name().into_string().ok())
                    .collect();
                // If several names differ only in case, the first one is found on every machine.
                names.sort_unstable_by(|a, b| b.cmp(a));
                names.into_iter().map(|name| (name.to_lowercase(), name)).collect()
            })
        }
    }

    fn joined(folder: &str, name: &str) -> String {
        if folder.is_empty() { name.to_owned() } else { format!("{folder}/{name}") }
    }

    fn missing(error: &io::Error) -> Missing {
        match error.kind() {
            io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => Missing::NotFound,
            // The error of the system has a number; without one, `cap-std` has found a link that leads out.
            io::ErrorKind::PermissionDenied if error.raw_os_error().is_none() => {
                Missing::Refused("a link leads out of the folder; such links are not followed".to_owned())
            }
            _ => Missing::Refused(error.to_string()),
        }
    }
}
