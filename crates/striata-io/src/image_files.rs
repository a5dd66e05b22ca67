//! Files that the images of a mesh or scene become next to an OBJ, PLY or glTF file.
//!
//! An image that lies in the folder of the output already, under its path or the end of it, is referred to. All
//! others are written there, under their file names. A different file of that name is never replaced: the image then
//! gets a number.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use percent_encoding::percent_decode_str;
use striata::mesh::Image;

use crate::CompanionFile;
#[cfg(feature = "gltf")]
use crate::EncodedMesh;
use crate::error::Place;
use crate::report::Warnings;

/// Largest number that is added to a name; no folder has more files of one name.
const MAX_NUMBER: u32 = 100_000;

/// Largest number of folders of a path that are left out to find an image.
const MAX_FOLDERS: usize = 16;

/// Largest length of a file name without its extension, in characters.
const MAX_STEM: usize = 100;

/// Names of the images of a mesh, and the files that have to be written.
pub(crate) struct ImageFiles<'m> {
    images: &'m [Image],
    /// Folder of the output; nothing is written without one.
    folder: Option<PathBuf>,
    /// Name of each image that has been asked for.
    names: BTreeMap<usize, String>,
    /// Names of the files to write in lower case, since many file systems do not distinguish case.
    taken: BTreeMap<String, Option<usize>>,
    files: Vec<CompanionFile>,
}

/// An output in the making, in a format that is written elsewhere: images that become files next to it, as for the formats
/// of this crate, and remarks on what it cannot store.
#[cfg(feature = "gltf")]
pub struct OutputFiles<'m> {
    images: ImageFiles<'m>,
    warnings: Warnings,
}

#[cfg(feature = "gltf")]
impl<'m> OutputFiles<'m> {
    /// Begins an output that is written to a path, or, for [`None`], kept in memory.
    pub fn new(images: &'m [Image], output: Option<&Path>) -> Self {
        let name = output.map_or_else(|| "output".to_owned(), |path| path.display().to_string());
        Self { images: ImageFiles::new(images, output), warnings: Warnings::of_file(&name) }
    }

    /// Returns the name by which the output refers to an image, in its folder; [`None`] if there is no such image.
    pub fn name_of(&mut self, image: usize) -> Option<String> {
        self.images.name_of(image, &mut self.warnings)
    }

    /// Notes what the format cannot store.
    pub fn warn(&mut self, reason: impl Into<String>) {
        self.warnings.push(Place::File, reason);
    }

    /// Completes the output with the contents of the file itself.
    pub fn finish(self, bytes: Vec<u8>) -> EncodedMesh {
        let (companions, warnings) = (self.images.into_files(), self.warnings.into_list());
        EncodedMesh { bytes, companions, warnings }
    }
}

/// A file that needs a name.
struct NewFile<'b> {
    wanted: &'b str,
    /// The image whose bytes it has, if it is one.
    image: Option<usize>,
    bytes: &'b [u8],
    /// Whether an existing file may be replaced.
    is_own: fn(&[u8]) -> bool,
}

/// State of a name in the output folder: free, or taken by the same bytes or by another file.
enum NameState {
    /// No file.
    Nothing,
    /// A file with these bytes.
    Same,
    /// Another file.
    Other,
}

impl<'m> ImageFiles<'m> {
    /// Creates the files for an output, whose own name is taken.
    pub(crate) fn new(images: &'m [Image], output: Option<&Path>) -> Self {
        let folder = output.map(|path| match path.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
            _ => PathBuf::from("."),
        });
        let own_name = output.and_then(Path::file_name).map(|name| name.to_string_lossy().to_lowercase());
        Self {
            images,
            folder,
            names: BTreeMap::new(),
            taken: own_name.into_iter().map(|name| (name, None)).collect(),
            files: Vec::new(),
        }
    }

    /// Returns the name by which the output refers to an image; [`None`] if there is no such image.
    pub(crate) fn name_of(&mut self, image: usize, warnings: &mut Warnings) -> Option<String> {
        if let Some(name) = self.names.get(&image) {
            return Some(name.clone());
        }
        let known = self.images.get(image)?;
        let path = percent_decode_str(&known.uri).decode_utf8_lossy().into_owned();
        let is_reference = known.bytes.is_empty() && !path.is_empty();
        let name = if is_reference {
            one_line(&path)
        } else if let Some(found) =
            self.folder.as_ref().and_then(|folder| found_in(folder, &path, &known.bytes))
        {
            found
        } else {
            self.free_name(image, &file_name(known, &path, image), warnings)
        };
        self.names.insert(image, name.clone());
        Some(name)
    }

    /// Returns the name of a file with the bytes of an image, which is written if it does not exist.
    fn free_name(&mut self, image: usize, wanted: &str, warnings: &mut Warnings) -> String {
        let bytes = &self.images[image].bytes;
        let file = NewFile { wanted, image: Some(image), bytes, is_own: |_| false };
        let name = self.reserve(&file, warnings);
        if let Some(folder) = &self.folder
            && !bytes.is_empty()
            && !self.files.iter().any(|file| file.path == folder.join(&name))
            && !compare(folder, &name, bytes).is_same()
        {
            self.files.push(CompanionFile { path: folder.join(&name), bytes: bytes.clone() });
        }
        name
    }

    /// Adds a file that is not an image, and returns its name. A file of the same name is replaced if
    /// `is_own` recognizes it as an earlier output.
    pub(crate) fn add(
        &mut self,
        wanted: &str,
        bytes: Vec<u8>,
        is_own: fn(&[u8]) -> bool,
        warnings: &mut Warnings,
    ) -> String {
        let name = self.reserve(&NewFile { wanted, image: None, bytes: &bytes, is_own }, warnings);
        if let Some(folder) = &self.folder {
            self.files.push(CompanionFile { path: folder.join(&name), bytes });
        }
        name
    }

    /// Finds a name that is free, or that has these bytes already.
    fn reserve(&mut self, file: &NewFile<'_>, warnings: &mut Warnings) -> String {
        let &NewFile { wanted, image, bytes, is_own } = file;
        for number in 1..MAX_NUMBER {
            let name = numbered(wanted, number);
            match self.taken.get(&name.to_lowercase()) {
                Some(Some(other)) if self.images[*other].bytes == bytes && image.is_some() => return name,
                Some(_) => continue,
                None => {}
            }
            let found =
                self.folder.as_ref().map_or(NameState::Nothing, |folder| compare(folder, &name, bytes));
            let is_replaced = || self.folder.as_ref().is_some_and(|f| is_own_file(&f.join(&name), is_own));
            if matches!(found, NameState::Other) && !is_replaced() {
                if number == 1 {
                    let reason =
                        format!("`{wanted}` exists and is another file; a number is added to the name");
                    warnings.push(Place::File, reason);
                }
                continue;
            }
            self.taken.insert(name.to_lowercase(), image);
            return name;
        }
        wanted.to_owned()
    }

    /// Returns the files to write.
    pub(crate) fn into_files(self) -> Vec<CompanionFile> {
        self.files
    }
}

impl NameState {
    fn is_same(&self) -> bool {
        matches!(self, Self::Same)
    }
}

/// Finds an image in the folder of the output, under its path or under the end of it.
fn found_in(folder: &Path, path: &str, bytes: &[u8]) -> Option<String> {
    let ends = path.match_indices('/').map(|(at, _)| &path[at + 1..]).take(MAX_FOLDERS);
    let mut ends = std::iter::once(path).chain(ends).filter(|end| is_relative(end));
    ends.find(|end| compare(folder, end, bytes).is_same()).map(str::to_owned)
}

/// Compares a file with bytes; only a regular file can be the same.
fn compare(folder: &Path, name: &str, bytes: &[u8]) -> NameState {
    let path = folder.join(name);
    let Ok(metadata) = fs::metadata(&path) else {
        // A link to nowhere is there all the same.
        return if fs::symlink_metadata(&path).is_ok() { NameState::Other } else { NameState::Nothing };
    };
    let may_be_same = metadata.is_file() && metadata.len() == bytes.len() as u64;
    match may_be_same && fs::read(&path).is_ok_and(|found| found == bytes) {
        true => NameState::Same,
        false => NameState::Other,
    }
}

fn is_own_file(path: &Path, is_own: fn(&[u8]) -> bool) -> bool {
    fs::metadata(path).is_ok_and(|found| found.is_file()) && fs::read(path).is_ok_and(|bytes| is_own(&bytes))
}

/// Whether a path starts at a folder, and can be written in one line.
fn is_relative(path: &str) -> bool {
    !path.is_empty()
        && Path::new(path).is_relative()
        && !path.contains([':', '\\'])
        && path == one_line(path)
        && path == path.trim()
        && is_safe_in_mtl(path)
}

/// Whether no part of a name reads like an option of a texture statement.
fn is_safe_in_mtl(name: &str) -> bool {
    !name.starts_with('-') && !name.contains(" -")
}

fn one_line(text: &str) -> String {
    text.replace(|c: char| c.is_control(), "_")
}

/// Returns the file name that an image should have: that of its file, or its own.
fn file_name(image: &Image, path: &str, index: usize) -> String {
    let last = path.rsplit(['/', '\\']).next().unwrap_or("");
    let own = [last, &image.name].into_iter().map(clean).find(|name| !name.is_empty());
    let name = own.unwrap_or_else(|| format!("image{index}"));
    let extensions: &[&str] = match image.mime_type.as_str() {
        "image/png" => &["png"],
        "image/jpeg" => &["jpg", "jpeg"],
        "image/webp" => &["webp"],
        "image/ktx2" => &["ktx2"],
        "image/vnd-ms.dds" => &["dds"],
        _ => &[],
    };
    const REPLACED: [&str; 10] = ["png", "jpg", "jpeg", "webp", "ktx2", "dds", "tga", "bmp", "gif", "tif"];
    let (stem, extension) = name.rsplit_once('.').unwrap_or((&name, ""));
    let is_one_of = |list: &[&str]| list.iter().any(|known| known.eq_ignore_ascii_case(extension));
    let short = |stem: &str| stem.chars().take(MAX_STEM).collect::<String>();
    match extensions.first() {
        _ if is_one_of(extensions) => format!("{}.{extension}", short(stem)),
        Some(right) if is_one_of(&REPLACED) => format!("{}.{right}", short(stem)),
        Some(right) => format!("{}.{right}", short(&name)),
        None if extension.is_empty() => short(&name),
        None => format!("{}.{}", short(stem), short(extension)),
    }
}

/// Replaces what file systems and the statements of MTL reserve.
fn clean(name: &str) -> String {
    let is_reserved = |c: char| c.is_control() || "/\\:*?\"<>|".contains(c);
    let name = name.replace(is_reserved, "_");
    let name = name.trim().trim_matches('.').trim();
    match is_safe_in_mtl(name) {
        true => name.to_owned(),
        false => name.replace('-', "_"),
    }
}

/// Returns `stem-2.png` for `stem.png` and the number 2.
fn numbered(name: &str, number: u32) -> String {
    match name.rsplit_once('.') {
        _ if number == 1 => name.to_owned(),
        Some((stem, extension)) => format!("{stem}-{number}.{extension}"),
        None => format!("{name}-{number}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(uri: &str, name: &str, mime_type: &str, bytes: &[u8]) -> Image {
        Image { name: name.into(), uri: uri.into(), mime_type: mime_type.into(), bytes: bytes.into() }
    }

    fn names(files: &mut ImageFiles<'_>, count: usize) -> Vec<String> {
        let mut warnings = Warnings::of_file("x.obj");
        (0..count).map(|index| files.name_of(index, &mut warnings).unwrap()).collect()
    }

    #[test]
    fn images_become_files_with_names_of_their_own() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("maps")).unwrap();
        fs::write(folder.path().join("maps/here.png"), b"h").unwrap();
        fs::write(folder.path().join("same.png"), b"s").unwrap();
        fs::write(folder.path().join("Other.png"), b"another").unwrap();
        let images = vec![
            image("a/wood.png", "", "image/png", b"1"),
            image("b/Wood.PNG", "", "image/png", b"2"),
            image("c/wood.png", "", "image/png", b"1"),
            image("maps/here.png", "", "image/png", b"h"),
            image("../same.png", "", "image/png", b"s"),
            image("Other.png", "", "image/png", b"o"),
            image("", "bark: old/new", "image/jpeg", b"j"),
            image("", "", "image/webp", b"w"),
            image("gr%C3%BCn%20a.tga", "", "image/png", b"g"),
            image("maps/lost.png", "", "", b""),
            image("x.obj", "", "", b"x"),
        ];
        let mut files = ImageFiles::new(&images, Some(&folder.path().join("x.obj")));
        let expected = [
            "wood.png",
            "Wood-2.PNG",
            "wood.png",
            "maps/here.png",
            "same.png",
            "Other-2.png",
            "bark_ old_new.jpg",
            "image7.webp",
            "grün a.png",
            "maps/lost.png",
            "x-2.obj",
        ];
        assert_eq!(names(&mut files, 11), expected);
        let written: Vec<String> = files
            .into_files()
            .iter()
            .map(|file| file.path.file_name().unwrap().to_string_lossy().into_owned())
            .collect();
        let new = [0, 1, 5, 6, 7, 8, 10].map(|index: usize| expected[index]);
        assert_eq!(written, new);
        let mut in_memory = ImageFiles::new(&images, None);
        assert_eq!(names(&mut in_memory, 2), ["wood.png", "Wood-2.PNG"]);
        assert!(in_memory.into_files().is_empty());
    }
}
