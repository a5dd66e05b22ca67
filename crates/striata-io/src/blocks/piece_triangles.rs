//! Triangles of pieces, which repeat the vertices of their borders.

use super::shared_vertices::{Key, KeyedTriangle, KeyedTriangles};
use crate::ReadError;
use crate::pieces::{Piece, PieceSource, PieceSummary};
use crate::ply::push_row;

/// Bytes of a position.
const POSITION_BYTES: usize = 12;

/// Triangles whose corners are identified by their positions and the values in all layers.
pub(super) struct PieceTriangles<'a>(pub(super) &'a dyn PieceSource);

impl KeyedTriangles for PieceTriangles<'_> {
    fn summary(&self) -> &PieceSummary {
        self.0.summary()
    }

    fn for_each(
        &self,
        visit: &mut dyn FnMut(&KeyedTriangle<'_>) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        let mut rows = Vec::new();
        for index in 0..self.0.piece_count() {
            let piece = self.0.read_piece(index)?;
            write_rows(&piece, &mut rows);
            let length = rows.len() / piece.positions.len().max(1);
            let row = |vertex: u32| &rows[vertex as usize * length..][..length];
            let keys: Vec<Key> = (0..piece.positions.len() as u32).map(|v| key_of(row(v))).collect();
            for corners in &piece.triangles {
                let push_row = |k: usize, out: &mut Vec<u8>| out.extend_from_slice(row(corners[k]));
                visit(&KeyedTriangle { keys: corners.map(|v| keys[v as usize]), push_row: &push_row })?;
            }
        }
        Ok(())
    }
}

/// Fills `rows` with the positions and layers of all vertices.
fn write_rows(piece: &Piece, rows: &mut Vec<u8>) {
    // Adding zero makes -0 and 0 the same.
    let positions: Vec<[f32; 3]> = piece.positions.iter().map(|p| p.map(|x| x + 0.0)).collect();
    rows.clear();
    (0..positions.len()).for_each(|vertex| push_row(&positions, &piece.layers, vertex, rows));
}

/// The position itself, or a hash of it and of the values in the layers.
///
/// Among a billion vertices, two have the same hash by accident with a probability of 1 to 10^11.
fn key_of(row: &[u8]) -> Key {
    let word = |at: usize| u32::from_le_bytes([row[at], row[at + 1], row[at + 2], row[at + 3]]);
    if row.len() == POSITION_BYTES { [0, 4, 8].map(word) } else { hash_of(row) }
}

/// FNV-1a of 128 bits, folded to 96.
fn hash_of(bytes: &[u8]) -> Key {
    const START: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    const PRIME: u128 = (1 << 88) + 0x13b;
    let hash = bytes.iter().fold(START, |hash, &byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME));
    [(hash >> 64) as u32, (hash >> 32) as u32, hash as u32 ^ (hash >> 96) as u32]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_differ_and_positions_are_their_own_keys() {
        assert_eq!(key_of(&[1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0]), [1, 2, 3]);
        let mut row = [0; 20];
        let mut keys = vec![key_of(&row)];
        for bit in 0..160 {
            row[bit / 8] ^= 1 << (bit % 8);
            keys.push(key_of(&row));
        }
        keys.sort_unstable();
        keys.dedup();
        assert_eq!(keys.len(), 161);
        // The published test vector of the hash of 128 bits for the letter a.
        let folded: u128 = 0xd228_cb69_6f1a_8caf_7891_2b70_4e4a_8964;
        let low = folded as u32 ^ (folded >> 96) as u32;
        assert_eq!(hash_of(b"a"), [(folded >> 64) as u32, (folded >> 32) as u32, low]);
    }
}
