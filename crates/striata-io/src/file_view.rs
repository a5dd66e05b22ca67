//! File that is read at several positions at once.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::sync::Arc;

/// A position in a file that others read as well; every access seeks first.
#[derive(Clone, Debug)]
pub(crate) struct FileView {
    file: Arc<File>,
    at: u64,
}

impl FileView {
    /// Starts at the beginning of a file.
    pub(crate) fn new(file: Arc<File>) -> Self {
        Self { file, at: 0 }
    }

    fn sought(&self) -> io::Result<&File> {
        let mut file = &*self.file;
        file.seek(SeekFrom::Start(self.at))?;
        Ok(file)
    }
}

impl Read for FileView {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let count = self.sought()?.read(out)?;
        self.at += count as u64;
        Ok(count)
    }
}

impl Write for FileView {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.sought()?.write(bytes)?;
        self.at += count as u64;
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        (&*self.file).flush()
    }
}

impl Seek for FileView {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.at = match to {
            SeekFrom::Start(at) => at,
            SeekFrom::Current(by) => self.at.saturating_add_signed(by),
            SeekFrom::End(by) => self.file.metadata()?.len().saturating_add_signed(by),
        };
        Ok(self.at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_views_do_not_disturb_each_other() {
        let file = Arc::new(tempfile::tempfile().unwrap());
        let (mut one, mut other) = (FileView::new(Arc::clone(&file)), FileView::new(file));
        one.write_all(b"0123456789").unwrap();
        let (mut a, mut b) = ([0; 2], [0; 2]);
        one.seek(SeekFrom::End(-4)).unwrap();
        other.read_exact(&mut b).unwrap();
        one.read_exact(&mut a).unwrap();
        assert_eq!((&a, &b), (b"67", b"01"));
        other.seek(SeekFrom::Current(1)).unwrap();
        other.read_exact(&mut b).unwrap();
        assert_eq!(&b, b"34");
    }
}
