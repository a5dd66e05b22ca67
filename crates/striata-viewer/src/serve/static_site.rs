//! Writes the page with its gallery to a folder, for servers that only have files.
//!
//! The page asks for the same addresses as from this command: `models.json`, `models/PATH` and `pictures/PATH.png`. Everything
//! is written to a temporary folder first, which gets its name at the end.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::output::{Output, format_bytes, format_count};

use super::folder::{Folder, encoded};
use super::listing::{List, Listing};
use super::thumbnails::{Thumbnail, Thumbnails};
use crate::viewer_page::ViewerFiles;

#[derive(Serialize)]
struct SiteReport {
    folder: PathBuf,
    models: usize,
    bytes: u64,
}

/// Writes the page, the models of a folder, their list and their pictures to `to`, which must not exist or be empty.
///
/// # Errors
/// If the models are not in a folder, `to` has files or lies in that folder, or a file cannot be read or written.
pub(super) async fn write(folder: Arc<Folder>, to: &Path, output: &Output) -> Result<(), Failure> {
    check(&folder, to)?;
    let mut partial = to.as_os_str().to_owned();
    partial.push(format!(".partial-{}", std::process::id()));
    let site = Site { root: partial.into(), bytes: 0 };
    let root = site.root.clone();
    let written = site.fill(&folder, output).await.and_then(|(models, bytes)| {
        // Some systems do not replace an empty folder.
        let _ = fs::remove_dir(to);
        fs::rename(&root, to).map_err(|error| cannot_write(to, &error))?;
        Ok(SiteReport { folder: to.to_owned(), models, bytes })
    });
    match written {
        Ok(report) => {
            let (models, bytes) = (format_count(report.models), format_bytes(report.bytes as usize));
            output.data(&report, &format!("{}: {models} models, {bytes}\n", to.display()))
        }
        Err(failure) => {
            let _ = fs::remove_dir_all(&root);
            Err(failure)
        }
    }
}

fn check(folder: &Folder, to: &Path) -> Result<(), Failure> {
    if let Some(only) = folder.only() {
        let failure = Failure::usage(format!("{only} is one model, and a site needs a folder of models"));
        return Err(failure.with_hint("put the model into a folder, with the files that it refers to"));
    }
    let is_full = fs::read_dir(to).is_ok_and(|mut entries| entries.next().is_some());
    if is_full || to.is_file() {
        let failure = Failure::user(format!("{}: there is something already", to.display()));
        return Err(failure.with_hint("name a new folder, or delete this one first"));
    }
    // The folder itself may not exist yet.
    let parent = to.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let parent = parent.canonicalize().map_err(|error| cannot_write(parent, &error))?;
    if parent.starts_with(folder.path()) || to.canonicalize().is_ok_and(|to| to.starts_with(folder.path())) {
        let failure = Failure::usage(format!("{} lies in the folder of the models", to.display()));
        return Err(
            failure.with_hint("name a folder outside, so that the next site does not contain this one")
        );
    }
    Ok(())
}

fn cannot_write(path: &Path, error: &std::io::Error) -> Failure {
    Failure::user(format!("{}: {error}", path.display())).with_hint("name a folder that you can write to")
}

/// A folder that is being filled.
struct Site {
    root: PathBuf,
    bytes: u64,
}

impl Site {
    /// Writes everything; returns the number of models, and of bytes.
    async fn fill(mut self, folder: &Arc<Folder>, output: &Output) -> Result<(usize, u64), Failure> {
        for name in ViewerFiles::iter() {
            if let Some(file) = ViewerFiles::get(&name) {
                self.put(&name, &mut &file.data[..])?;
            }
        }
        let list = Listing::new(folder.clone(), false).current().await;
        if list.is_cut {
            output.say("warning: the folder has more models than a gallery lists; the others are left out");
        }
        let companions = folder.walk_companions();
        if companions.is_truncated {
            output.say("warning: the folder has more textures and buffers than are copied");
        }
        let models = list.stamps().map(|(name, _)| name);
        for name in models.chain(companions.files.iter().map(|(name, _)| name.as_str())) {
            // Only if it has been deleted meanwhile.
            let Some(mut found) = folder.find(&encoded(name)) else { continue };
            self.put(&format!("models/{name}"), &mut found.file)?;
        }
        let pictures = self.draw(folder, &list, output).await?;
        self.put("models.json", &mut &list.document(|path| pictures.contains(path))[..])?;
        Ok((list.model_count, self.bytes))
    }

    /// Draws the models; returns those that have a picture.
    async fn draw(
        &mut self,
        folder: &Arc<Folder>,
        list: &List,
        output: &Output,
    ) -> Result<BTreeSet<String>, Failure> {
        let thumbnails = Thumbnails::new(folder.clone())?;
        let mut drawn = BTreeSet::new();
        for (name, stamp) in list.stamps() {
            match thumbnails.get(name, stamp, &folder.path().join(name)).await {
                Some(Thumbnail::Picture(png)) => {
                    self.put(&format!("pictures/{name}.png"), &mut &png[..])?;
                    drawn.insert(name.to_owned());
                }
                Some(Thumbnail::Broken(reason)) => {
                    output.say(&format!("warning: {name} is broken: {reason}"))
                }
                Some(Thumbnail::TooLarge) | None => {
                    output.say(&format!("warning: {name} has no picture: drawing it takes too long"));
                }
            }
        }
        Ok(drawn)
    }

    fn put(&mut self, name: &str, bytes: &mut impl std::io::Read) -> Result<(), Failure> {
        let path = self.root.join(name);
        let parent = path.parent().unwrap_or(&self.root);
        let written = fs::create_dir_all(parent)
            .and_then(|()| fs::File::create(&path))
            .and_then(|mut file| std::io::copy(bytes, &mut file));
        self.bytes += written.map_err(|error| cannot_write(&path, &error))?;
        Ok(())
    }
}
