//! Welds borders that nearly coincide: positions on borders that are closer than a distance become one.
//!
//! ```text
//!  file 1   ---a----b----c---        a and a', b and b', c and c' are closer than D:
//!  file 2   ---a'---b'---c'--        each pair becomes the first of the two
//! ```
//!
//! Each group is represented by its first position. A position joins the group with the nearest representative, and
//! begins a new group if none is closer than D. A position that is closer than D to two representatives merges their
//! groups, unless the representatives are more than 2 D apart. New representatives are at least D apart, so there are
//! only a few near any position, and the cost grows linearly with the number of positions.

use std::collections::{BTreeSet, HashMap};

use striata_io::pieces::Piece;

/// Map from positions to those that replace them, in increasing order of their bits.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct WeldMap {
    moved: Vec<([u32; 3], [f32; 3])>,
}

/// Bits of a position; positive and negative zero are the same.
fn key(position: [f32; 3]) -> [u32; 3] {
    position.map(|x| (x + 0.0).to_bits())
}

/// Positions at edges that only one triangle of the piece has: borders, and cuts between pieces.
pub(super) fn border(piece: &Piece) -> Vec<[f32; 3]> {
    let mut edges: Vec<[u32; 2]> = Vec::with_capacity(3 * piece.triangles.len());
    for t in &piece.triangles {
        edges.extend([[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]].map(|[a, b]| [a.min(b), a.max(b)]));
    }
    edges.sort_unstable();
    let single = edges.chunk_by(|a, b| a == b).filter(|same| same.len() == 1);
    let vertices: BTreeSet<u32> = single.flat_map(|same| same[0]).collect();
    vertices.into_iter().map(|vertex| piece.positions[vertex as usize]).collect()
}

/// Groups of positions, found by location.
struct Groups {
    distance: f64,
    /// Representative of each group.
    centers: Vec<[f32; 3]>,
    /// Group that each group has joined, or itself.
    joined: Vec<u32>,
    at: HashMap<[i64; 3], Vec<u32>>,
}

impl Groups {
    fn cell(&self, position: [f32; 3]) -> [i64; 3] {
        position.map(|x| (f64::from(x) / self.distance).floor() as i64)
    }

    /// Groups that begin closer than the distance, with their squared distances.
    fn near(&self, position: [f32; 3]) -> Vec<(f64, u32)> {
        let cell = self.cell(position);
        let mut found = Vec::new();
        for offset in 0..27 {
            let beside = [offset % 3 - 1, offset / 3 % 3 - 1, offset / 9 - 1];
            let cell = std::array::from_fn(|axis| cell[axis].saturating_add(beside[axis]));
            for &group in self.at.get(&cell).map_or(&[][..], Vec::as_slice) {
                let square = distance_squared(position, self.centers[group as usize]);
                if square < self.distance * self.distance {
                    found.push((square, group));
                }
            }
        }
        found
    }

    fn add(&mut self, position: [f32; 3]) {
        let group = self.centers.len() as u32;
        self.centers.push(position);
        self.joined.push(group);
        self.at.entry(self.cell(position)).or_default().push(group);
    }

    fn root(&self, mut group: u32) -> u32 {
        while self.joined[group as usize] != group {
            group = self.joined[group as usize];
        }
        group
    }

    /// Joins two groups unless they are too far apart.
    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        let square = distance_squared(self.centers[a as usize], self.centers[b as usize]);
        if square <= 4.0 * self.distance * self.distance {
            self.joined[a.max(b) as usize] = a.min(b);
        }
    }
}

fn distance_squared(a: [f32; 3], b: [f32; 3]) -> f64 {
    (0..3).map(|axis| (f64::from(a[axis]) - f64::from(b[axis])).powi(2)).sum()
}

impl WeldMap {
    /// Finds the positions that are replaced, and their replacements.
    pub(super) fn of(mut positions: Vec<[f32; 3]>, distance: f64) -> Self {
        positions.sort_unstable_by_key(|&position| key(position));
        positions.dedup_by_key(|position| key(*position));
        let mut groups = Groups { distance, centers: Vec::new(), joined: Vec::new(), at: HashMap::new() };
        for &position in &positions {
            if groups.near(position).is_empty() {
                groups.add(position);
            }
        }
        for &position in &positions {
            let near = groups.near(position);
            near.windows(2).for_each(|pair| groups.join(pair[0].1, pair[1].1));
        }
        let nearest = |position| {
            let near = groups.near(position).into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
            near.map(|(_, group)| groups.centers[groups.root(group) as usize])
        };
        let moved = positions.iter().filter_map(|&position| Some((key(position), nearest(position)?)));
        Self { moved: moved.filter(|&(from, to)| from != key(to)).collect() }
    }

    /// The position that replaces another one.
    pub(super) fn get(&self, position: [f32; 3]) -> [f32; 3] {
        let found = self.moved.binary_search_by_key(&key(position), |entry| entry.0);
        found.map_or(position, |at| self.moved[at].1)
    }

    pub(super) fn to_bytes(&self) -> Vec<u8> {
        let words = self.moved.iter().flat_map(|(from, to)| from.iter().copied().chain(to.map(f32::to_bits)));
        words.flat_map(u32::to_le_bytes).collect()
    }

    /// Reads a map; `None` if the bytes do not contain one.
    pub(super) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (words, rest) = bytes.as_chunks::<4>();
        let words: Vec<u32> = words.iter().map(|word| u32::from_le_bytes(*word)).collect();
        let (entries, left) = words.as_chunks::<6>();
        let entry = |w: &[u32; 6]| ([w[0], w[1], w[2]], [w[3], w[4], w[5]].map(f32::from_bits));
        (rest.is_empty() && left.is_empty()).then(|| Self { moved: entries.iter().map(entry).collect() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pseudorandom numbers from 0 to 1.
    fn random(seed: &mut u64) -> f32 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 40) as f32 / (1u64 << 24) as f32
    }

    #[test]
    fn borders_that_differ_a_little_become_one_wherever_they_are() {
        let (mut seed, mut positions, mut pairs) = (7, Vec::new(), Vec::new());
        for i in 0..500 {
            let at = [i as f32 * 0.37, (i % 7) as f32, 0.0];
            let moved = at.map(|x| x + 2e-4 * random(&mut seed));
            positions.extend([at, moved]);
            pairs.push((at, moved));
        }
        for distance in [5e-4, 1e-3, 0.05, 0.3] {
            let map = WeldMap::of(positions.clone(), distance);
            assert!(pairs.iter().all(|&(a, b)| map.get(a) == map.get(b)), "{distance}");
            let after: BTreeSet<[u32; 3]> = positions.iter().map(|&p| key(map.get(p))).collect();
            assert_eq!(after.len(), 500, "{distance}");
            assert_eq!(WeldMap::from_bytes(&map.to_bytes()), Some(map));
        }
        assert_eq!(WeldMap::from_bytes(&[0; 23]), None);
    }

    #[test]
    fn close_positions_become_one_unless_that_moves_them_far() {
        let mut seed = 3;
        for _ in 0..50 {
            let positions: Vec<[f32; 3]> =
                (0..60).map(|_| std::array::from_fn(|_| 4.0 * random(&mut seed))).collect();
            let map = WeldMap::of(positions.clone(), 0.5);
            for &a in &positions {
                assert!(distance_squared(a, map.get(a)).sqrt() <= 1.5, "at most 2 D from what it joined");
                assert_eq!(map.get(map.get(a)), map.get(a), "what stands for others stays");
            }
        }
        // A chain: the ends are farther apart than twice the distance.
        let chain: Vec<[f32; 3]> = (0..9).map(|i| [i as f32 * 0.4, 0.0, 0.0]).collect();
        let map = WeldMap::of(chain.clone(), 0.5);
        assert_eq!(map.get(chain[0]), map.get(chain[1]));
        assert_ne!(map.get(chain[0]), map.get(chain[8]));
    }

    #[test]
    fn dense_positions_take_no_square_of_time() {
        let mut seed = 5;
        let positions: Vec<[f32; 3]> =
            (0..200_000).map(|_| std::array::from_fn(|_| random(&mut seed))).collect();
        let map = WeldMap::of(positions.clone(), 0.9);
        assert!(positions.iter().map(|&p| key(map.get(p))).collect::<BTreeSet<_>>().len() < 50);
    }
}
