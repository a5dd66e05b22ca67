//! Decoded data that several threads share: each item is decoded once, and dropped some time after its last
//! use.
//!
//! The pieces of one primitive are read one after another, possibly by several threads, so what recent reads
//! have used is kept however large it is: decoding it again for every piece would take quadratic time.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::draco_mesh::DracoMesh;
use crate::error::Fault;

/// Memory that items take at most, unless recent reads have used more, in bytes.
const KEPT_BYTES: u64 = 1 << 27;

/// Number of the last reads, for each thread, whose items are kept.
const KEPT_READS_PER_THREAD: u64 = 2;

/// Decompressed buffer views and meshes of a document, by the numbers of their buffer views.
#[derive(Default)]
pub(crate) struct UnpackedCache {
    pub(super) views: SharedCache<Vec<u8>>,
    pub(super) draco_meshes: SharedCache<DracoMesh>,
}

impl UnpackedCache {
    /// Counts a read: items that have not been used for some reads are dropped.
    pub(crate) fn begin_read(&self) {
        self.views.begin_read();
        self.draco_meshes.begin_read();
    }

    /// Allows dropping all items that are there now, in order to make room.
    pub(crate) fn expire(&self) {
        self.views.expire();
        self.draco_meshes.expire();
    }
}

/// Items by numbers.
pub(crate) struct SharedCache<T> {
    items: Mutex<BTreeMap<u64, CachedItem<T>>>,
    reads: AtomicU64,
    kept_reads: u64,
}

struct CachedItem<T> {
    /// Locked while the item is decoded.
    slot: Arc<Mutex<Option<Arc<T>>>>,
    /// Size in bytes; 0 until it is decoded.
    bytes: u64,
    /// Number of the read that has used it last.
    last_read: u64,
}

impl<T> Default for SharedCache<T> {
    fn default() -> Self {
        let threads = std::thread::available_parallelism().map_or(1, |count| count.get() as u64);
        let (items, reads) = (Mutex::default(), AtomicU64::new(0));
        Self { items, reads, kept_reads: KEPT_READS_PER_THREAD * threads }
    }
}

impl<T> SharedCache<T> {
    /// Counts a read.
    pub(crate) fn begin_read(&self) {
        self.reads.fetch_add(1, Ordering::Relaxed);
    }

    fn expire(&self) {
        self.reads.fetch_add(self.kept_reads + 1, Ordering::Relaxed);
    }

    /// Returns an item, which is decoded if it is not there. Other threads that want it wait.
    pub(crate) fn get(
        &self,
        number: u64,
        decode: impl FnOnce() -> Result<T, Fault>,
        size: impl FnOnce(&T) -> u64,
    ) -> Result<Arc<T>, Fault> {
        let slot = self.slot(number);
        let mut decoded = locked(&slot);
        if let Some(known) = &*decoded {
            return Ok(Arc::clone(known));
        }
        let item = Arc::new(decode()?);
        *decoded = Some(Arc::clone(&item));
        drop(decoded);
        self.grow(number, size(&item));
        Ok(item)
    }

    fn slot(&self, number: u64) -> Arc<Mutex<Option<Arc<T>>>> {
        let last_read = self.reads.load(Ordering::Relaxed);
        let mut items = locked(&self.items);
        let item =
            items.entry(number).or_insert_with(|| CachedItem { slot: Arc::default(), bytes: 0, last_read });
        item.last_read = last_read;
        Arc::clone(&item.slot)
    }

    /// Sets the size of an item, and drops others that have not been used for long until the rest is small
    /// enough.
    fn grow(&self, number: u64, bytes: u64) {
        let oldest_kept = self.reads.load(Ordering::Relaxed).saturating_sub(self.kept_reads);
        let mut items = locked(&self.items);
        if let Some(item) = items.get_mut(&number) {
            item.bytes = bytes;
        }
        let mut total: u64 = items.values().map(|item| item.bytes).sum();
        while total > KEPT_BYTES {
            let old = items.iter().filter(|(_, item)| item.bytes > 0 && item.last_read < oldest_kept);
            let Some((&oldest, _)) = old.min_by_key(|(_, item)| item.last_read) else { return };
            total -= items.remove(&oldest).map_or(0, |item| item.bytes);
        }
    }
}

/// Locks a mutex; no thread leaves an item half decoded, so a panic of another one does no harm.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_reads(kept_reads: u64) -> SharedCache<u64> {
        SharedCache { items: Mutex::default(), reads: AtomicU64::new(0), kept_reads }
    }

    fn decodes(cache: &SharedCache<u64>, number: u64, bytes: u64) -> bool {
        let mut was_decoded = false;
        let decode = || {
            was_decoded = true;
            Ok(number)
        };
        assert_eq!(*cache.get(number, decode, |_| bytes).unwrap(), number);
        was_decoded
    }

    #[test]
    fn recent_items_are_kept_and_old_ones_are_dropped() {
        let cache = with_reads(2);
        // Each read uses two large items, which stay while the reads follow each other.
        for read in 0..5 {
            cache.begin_read();
            for number in [0, 1] {
                assert_eq!(decodes(&cache, number, KEPT_BYTES), read == 0);
            }
        }
        for number in 2..6 {
            cache.begin_read();
            assert!(decodes(&cache, number, KEPT_BYTES));
        }
        assert!(decodes(&cache, 0, KEPT_BYTES), "it has not been used for four reads");
        assert!(!decodes(&cache, 5, KEPT_BYTES));
        let small = with_reads(0);
        for number in 0..100 {
            small.begin_read();
            decodes(&small, number, 10);
        }
        assert!(!decodes(&small, 0, 10), "there is room for all");
        let expired = with_reads(1000);
        decodes(&expired, 0, KEPT_BYTES);
        expired.expire();
        decodes(&expired, 1, KEPT_BYTES);
        assert!(!decodes(&expired, 1, KEPT_BYTES));
        assert!(decodes(&expired, 0, KEPT_BYTES));
    }

    #[test]
    fn failures_are_not_kept() {
        let cache = with_reads(1);
        let failed = cache.get(3, || Err(Fault::at_line(1, "damaged")), |_| 0);
        assert!(failed.is_err());
        assert!(decodes(&cache, 3, 8));
    }

    #[test]
    fn threads_decode_an_item_once() {
        let (cache, count) = (with_reads(8), AtomicU64::new(0));
        std::thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    let decode = || {
                        std::thread::sleep(std::time::Duration::from_millis(20));
                        Ok(count.fetch_add(1, Ordering::Relaxed))
                    };
                    assert_eq!(*cache.get(7, decode, |_| 8).unwrap(), 0);
                });
            }
        });
        assert_eq!(count.into_inner(), 1);
    }
}
