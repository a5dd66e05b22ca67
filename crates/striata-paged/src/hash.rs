//! A fast hash of indices. It does not resist deliberate collisions, which would only cost time.

use std::hash::{BuildHasherDefault, Hasher};

/// Hasher of a few indices.
#[derive(Default)]
pub(crate) struct IndexHasher(u64);

/// Builds hashers of a few indices.
pub(crate) type IndexHash = BuildHasherDefault<IndexHasher>;

impl Hasher for IndexHasher {
    fn finish(&self) -> u64 {
        self.0
    }
    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.write_u64(u64::from_le_bytes(word));
        }
    }
    fn write_u32(&mut self, word: u32) {
        self.write_u64(u64::from(word));
    }
    fn write_u64(&mut self, word: u64) {
        let mixed = (self.0 ^ word).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        self.0 = mixed ^ (mixed >> 29);
    }
}
