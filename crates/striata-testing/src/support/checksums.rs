//! Makes damaged files pass their checksums, so that tests reach the checks behind them.

/// Recomputes all checksums of a damaged file, as a malicious writer would.
pub fn with_valid_checksums(bytes: &mut [u8]) {
    let count = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    for entry in 0..count {
        let at = 64 + 32 * entry;
        let number = |i: usize| u64::from_le_bytes(bytes[at + i..at + i + 8].try_into().unwrap()) as usize;
        let (offset, length) = (number(8), number(16));
        let Some(section) = bytes.get(offset..offset.saturating_add(length)) else { continue };
        let checksum = crc32fast::hash(section).to_le_bytes();
        bytes[at + 24..at + 28].copy_from_slice(&checksum);
    }
    bytes[24..28].fill(0);
    let checksum = crc32fast::hash(&bytes[..64 + 32 * count]).to_le_bytes();
    bytes[24..28].copy_from_slice(&checksum);
}
