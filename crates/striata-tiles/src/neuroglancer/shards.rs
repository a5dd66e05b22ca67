//! Many segments in a few files: `neuroglancer_uint64_sharded_v1`.
//!
//! ```text
//!  shard: index of 2^minishard_bits ranges | fragments, manifest | fragments, manifest | ... | minishard indices
//! ```
//!
//! A shard is a file, and a minishard a part of the manifests in it. Its index has three rows of numbers: identifiers,
//! places and sizes of manifests. The first two are differences. Readers find the fragments of a segment directly
//! before its manifest.

use std::collections::BTreeMap;
use std::io::{self, Seek as _, SeekFrom, Write as _};

use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::{Value, json};

use crate::sink::FolderSink;

/// Segments of a minishard, about, if there are many.
const MINISHARD_SEGMENTS: u64 = 128;
/// Base-2 logarithm of the number of minishards of a shard, if there are many.
const MINISHARD_BITS: u32 = 6;

/// How a shard is chosen for a segment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ShardHash {
    /// By the identifier itself.
    Identity,
    /// By the low half of `MurmurHash3_x86_128` of the identifier.
    #[default]
    Murmur,
}

/// How segments are distributed to shards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sharding {
    /// How numbers are chosen.
    pub hash: ShardHash,
    /// Number of low bits of an identifier that are not hashed.
    pub preshift_bits: u32,
    /// Base-2 logarithm of the number of minishards of a shard: the low bits of the hash. At most 16.
    pub minishard_bits: u32,
    /// Base-2 logarithm of the number of shards: the next bits of the hash. At most 16.
    pub shard_bits: u32,
}

impl Sharding {
    /// A distribution of this number of segments.
    pub fn of_count(segments: u64) -> Self {
        let bits = segments.div_ceil(MINISHARD_SEGMENTS).max(1).next_power_of_two().ilog2();
        let minishard_bits = bits.min(MINISHARD_BITS);
        let shard_bits = (bits - minishard_bits).min(16);
        Self { hash: ShardHash::default(), preshift_bits: 0, minishard_bits, shard_bits }
    }

    pub(super) fn to_json(self) -> Value {
        let hash = match self.hash {
            ShardHash::Identity => "identity",
            ShardHash::Murmur => "murmurhash3_x86_128",
        };
        json!({
            "@type": "neuroglancer_uint64_sharded_v1",
            "hash": hash,
            "preshift_bits": self.preshift_bits,
            "minishard_bits": self.minishard_bits,
            "shard_bits": self.shard_bits,
            "minishard_index_encoding": "gzip",
            "data_encoding": "raw",
        })
    }

    /// The shard and the minishard of a segment.
    fn place(self, id: u64) -> (u64, u64) {
        let id = id.checked_shr(self.preshift_bits).unwrap_or(0);
        let hash = match self.hash {
            ShardHash::Identity => id,
            ShardHash::Murmur => murmur(id),
        };
        let low = |x: u64, bits: u32| x & ((1 << bits) - 1);
        (low(hash >> self.minishard_bits, self.shard_bits), low(hash, self.minishard_bits))
    }
}

/// Shards while they are written.
#[derive(Debug)]
pub(super) struct Shards {
    sharding: Sharding,
    /// Manifests by shard, minishard and segment.
    manifests: BTreeMap<(u64, u64), BTreeMap<u64, Manifest>>,
}

/// Place of a manifest in its shard.
#[derive(Clone, Copy, Debug)]
struct Manifest {
    offset: u64,
    byte_count: u64,
}

impl Shards {
    pub(super) fn new(sharding: Sharding) -> Self {
        let limited = |bits: u32| bits.min(16);
        let sharding = Sharding {
            minishard_bits: limited(sharding.minishard_bits),
            shard_bits: limited(sharding.shard_bits),
            ..sharding
        };
        Self { sharding, manifests: BTreeMap::new() }
    }

    /// Number of bytes of the index at the begin of a shard.
    pub(super) fn index_bytes(&self) -> u64 {
        16 << self.sharding.minishard_bits
    }

    /// Name of the shard of a segment.
    pub(super) fn file_of(&self, id: u64) -> String {
        self.name_of(self.sharding.place(id).0)
    }

    fn name_of(&self, shard: u64) -> String {
        let digits = self.sharding.shard_bits.div_ceil(4) as usize;
        format!("{shard:0digits$x}.shard")
    }

    /// Adds the manifest of a segment, given its place in the shard.
    pub(super) fn add(&mut self, id: u64, offset: u64, byte_count: u64) {
        let place = self.sharding.place(id);
        self.manifests.entry(place).or_default().insert(id, Manifest { offset, byte_count });
    }

    /// Writes the indices of all shards.
    pub(super) fn write_indices(&self, sink: &mut FolderSink) -> io::Result<()> {
        let minishards: Vec<_> = self.manifests.iter().collect();
        for shard in minishards.chunk_by(|a, b| a.0.0 == b.0.0) {
            let mut file = sink.open(&self.name_of(shard[0].0.0))?;
            let mut index = vec![[0u64; 2]; 1 << self.sharding.minishard_bits];
            for ((_, minishard), manifests) in shard {
                let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
                encoder.write_all(&self.minishard_index(manifests))?;
                let bytes = encoder.finish()?;
                let start = file.seek(SeekFrom::End(0))? - self.index_bytes();
                file.write_all(&bytes)?;
                index[*minishard as usize] = [start, start + bytes.len() as u64];
            }
            file.seek(SeekFrom::Start(0))?;
            let bytes: Vec<u8> = index.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
            file.write_all(&bytes)?;
        }
        Ok(())
    }

    fn minishard_index(&self, manifests: &BTreeMap<u64, Manifest>) -> Vec<u8> {
        let mut rows = [Vec::new(), Vec::new(), Vec::new()];
        let (mut last_id, mut end) = (0, self.index_bytes());
        for (&id, manifest) in manifests {
            // Differences may be negative; sums of readers wrap around.
            let numbers = [id - last_id, manifest.offset.wrapping_sub(end), manifest.byte_count];
            rows.iter_mut().zip(numbers).for_each(|(row, x)| row.extend(x.to_le_bytes()));
            (last_id, end) = (id, manifest.offset + manifest.byte_count);
        }
        rows.concat()
    }
}

/// Low half of `MurmurHash3_x86_128` of eight bytes, with the seed 0.
fn murmur(key: u64) -> u64 {
    const FACTORS: [u32; 3] = [0x239b_961b, 0xab0e_9789, 0x38b3_4ae5];
    const LENGTH: u32 = 8;
    let mixed = |x: u32, first: u32, turn: u32, second: u32| {
        x.wrapping_mul(first).rotate_left(turn).wrapping_mul(second)
    };
    let low = mixed(key as u32, FACTORS[0], 15, FACTORS[1]) ^ LENGTH;
    let high = mixed((key >> 32) as u32, FACTORS[1], 16, FACTORS[2]) ^ LENGTH;
    let mut words = [low, high, LENGTH, LENGTH];
    let add = |words: &mut [u32; 4]| {
        words[0] = words.iter().fold(0, |sum, &word| sum.wrapping_add(word));
        let first = words[0];
        words[1..].iter_mut().for_each(|word| *word = word.wrapping_add(first));
    };
    add(&mut words);
    for word in &mut words {
        *word = (*word ^ *word >> 16).wrapping_mul(0x85eb_ca6b);
        *word = (*word ^ *word >> 13).wrapping_mul(0xc2b2_ae35);
        *word ^= *word >> 16;
    }
    add(&mut words);
    u64::from(words[0]) | u64::from(words[1]) << 32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_are_those_of_other_readers() {
        // By cloud-volume 12.
        for (key, hash) in [
            (0, 0x4772_b084_e028_ae41),
            (1, 0xe8bd_67d6_16d4_ce9a),
            (42, 0xc20b_94f9_5119_f47a),
            (u64::MAX, 0x574f_66bd_212b_5d1a),
        ] {
            assert_eq!(murmur(key), hash, "{key}");
        }
    }

    #[test]
    fn shards_hold_thousands_of_segments() {
        let bits = |count| {
            let sharding = Sharding::of_count(count);
            (sharding.minishard_bits, sharding.shard_bits)
        };
        assert_eq!(
            [0, 1, 128, 129, 10_000, 1_000_000, u64::MAX].map(bits),
            [(0, 0), (0, 0), (0, 0), (1, 0), (6, 1), (6, 7), (6, 16)]
        );
    }
}
