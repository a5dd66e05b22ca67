//! A store for programs that fetch bytes themselves, such as web pages: it lists the bytes that are missing.

use std::collections::HashMap;
use std::io;
use std::ops::Range;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::{PagedError, Store, StoredPlace, Want};

/// Bytes that have been supplied, and the ranges that were missing. Clones share them.
///
/// If bytes are missing, a read fails with [`io::ErrorKind::WouldBlock`]. Take what is
/// [wanted](Self::take_wants), fetch it, [supply](Self::supply) it, and repeat the call that failed: pages that
/// a [`PagedFile`](crate::PagedFile) has decoded are not read again.
#[derive(Clone, Debug, Default)]
pub struct SuppliedStore {
    bytes: Arc<Mutex<Supplied>>,
    name: String,
}

#[derive(Debug, Default)]
struct Supplied {
    arrived: HashMap<(StoredPlace, Range<u64>), Vec<u8>>,
    wants: Vec<Want>,
}

impl SuppliedStore {
    /// Creates a store without bytes; errors show the name.
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), ..Self::default() }
    }

    /// Takes the list of ranges that the last read missed.
    pub fn take_wants(&self) -> Vec<Want> {
        std::mem::take(&mut self.lock().wants)
    }

    /// Whether the last read missed ranges that have not been [taken](Self::take_wants).
    pub fn lacks_bytes(&self) -> bool {
        !self.lock().wants.is_empty()
    }

    /// Supplies bytes that were wanted; fewer if the object ends before.
    pub fn supply(&self, want: Want, bytes: Vec<u8>) {
        self.lock().arrived.insert((want.place, want.range), bytes);
    }

    /// Drops all supplied bytes.
    pub fn clear(&self) {
        self.lock().arrived.clear();
    }

    fn lock(&self) -> MutexGuard<'_, Supplied> {
        self.bytes.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Store for SuppliedStore {
    fn name(&self) -> &str {
        &self.name
    }

    fn read(&self, place: StoredPlace, range: Range<u64>) -> Result<Vec<u8>, PagedError> {
        let mut read = self.read_all(&[Want { place, range }])?;
        Ok(read.pop().unwrap_or_default())
    }

    fn read_all(&self, wants: &[Want]) -> Result<Vec<Vec<u8>>, PagedError> {
        let mut supplied = self.lock();
        let key = |want: &Want| (want.place, want.range.clone());
        let is_missing = |want: &&Want| !supplied.arrived.contains_key(&key(want));
        let missing: Vec<Want> = wants.iter().filter(is_missing).cloned().collect();
        supplied.wants = missing;
        if supplied.wants.is_empty() {
            return Ok(wants.iter().map(|want| supplied.arrived[&key(want)].clone()).collect());
        }
        Err(PagedError::Io { place: self.name.clone(), source: io::ErrorKind::WouldBlock.into() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_fail_until_the_bytes_are_supplied() {
        let store = SuppliedStore::new("far.striata");
        assert!(store.read(StoredPlace::Head, 0..8).is_err());
        assert!(store.lacks_bytes());
        let wants = store.take_wants();
        assert_eq!(wants, [Want { place: StoredPlace::Head, range: 0..8 }]);
        assert!(!store.lacks_bytes());
        store.supply(wants[0].clone(), vec![1, 2, 3]);
        assert_eq!(store.read(StoredPlace::Head, 0..8).unwrap(), [1, 2, 3], "the object ends early");
        store.clear();
        assert!(store.read(StoredPlace::Head, 0..8).is_err());
    }
}
