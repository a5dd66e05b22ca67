//! Priority queue over positions with changeable keys: a four-ary heap with an index of its entries.

const ARITY: usize = 4;
const ABSENT: u32 = u32::MAX;

/// Min-heap of positions by key; ties break by position index, so that the order is deterministic.
#[derive(Debug)]
pub(in crate::simplify) struct IndexedHeap {
    /// Key bits in the high half, position in the low half, so that one comparison orders both.
    items: Vec<u64>,
    /// Index of each position in `items`, or `ABSENT`.
    slots: Vec<u32>,
}

#[inline]
fn pack(key: f32, v: u32) -> u64 {
    // Non-negative floats have the same order as their bits; adding zero turns -0 into 0.
    (u64::from((key + 0.0).to_bits()) << 32) | u64::from(v)
}

impl IndexedHeap {
    /// Builds a heap from the key of every position; positions with key `f32::INFINITY` are left out.
    pub(in crate::simplify) fn new(keys: &[f32]) -> Self {
        let items: Vec<u64> = keys
            .iter()
            .enumerate()
            .filter(|(_, key)| **key < f32::INFINITY)
            .map(|(v, &key)| pack(key, v as u32))
            .collect();
        let mut heap = Self { items, slots: vec![ABSENT; keys.len()] };
        for (i, &item) in heap.items.iter().enumerate() {
            heap.slots[item as u32 as usize] = i as u32;
        }
        for i in (0..heap.items.len().div_ceil(ARITY)).rev() {
            heap.sift_down(i);
        }
        heap
    }

    /// Returns the smallest key and its position.
    #[inline]
    pub(in crate::simplify) fn first(&self) -> Option<(f32, u32)> {
        self.items.first().map(|&item| (f32::from_bits((item >> 32) as u32), item as u32))
    }

    /// Inserts a position or changes its key; `f32::INFINITY` removes it.
    #[inline]
    pub(in crate::simplify) fn set(&mut self, v: u32, key: f32) {
        debug_assert!(key >= 0.0, "keys are never negative, nor NaN");
        let slot = self.slots[v as usize];
        if key == f32::INFINITY {
            self.remove(v);
        } else if slot == ABSENT {
            self.items.push(pack(key, v));
            self.slots[v as usize] = self.items.len() as u32 - 1;
            self.sift_up(self.items.len() - 1);
        } else {
            let (i, item) = (slot as usize, pack(key, v));
            let old = std::mem::replace(&mut self.items[i], item);
            if item < old {
                self.sift_up(i);
            } else if item > old {
                self.sift_down(i);
            }
        }
    }

    /// Removes a position if it is in the heap.
    pub(in crate::simplify) fn remove(&mut self, v: u32) {
        let slot = self.slots[v as usize];
        if slot == ABSENT {
            return;
        }
        self.slots[v as usize] = ABSENT;
        let i = slot as usize;
        let last = self.items.len() - 1;
        let moved = self.items.swap_remove(i);
        if i == last {
            return;
        }
        let filler = self.items[i];
        self.slots[filler as u32 as usize] = i as u32;
        if filler < moved {
            self.sift_up(i);
        } else {
            self.sift_down(i);
        }
    }

    fn sift_up(&mut self, mut i: usize) {
        let item = self.items[i];
        while i > 0 {
            let parent = (i - 1) / ARITY;
            let above = self.items[parent];
            if above <= item {
                break;
            }
            self.items[i] = above;
            self.slots[above as u32 as usize] = i as u32;
            i = parent;
        }
        self.items[i] = item;
        self.slots[item as u32 as usize] = i as u32;
    }

    fn sift_down(&mut self, mut i: usize) {
        let n = self.items.len();
        let item = self.items[i];
        loop {
            let first = i * ARITY + 1;
            if first >= n {
                break;
            }
            let mut child = first;
            let mut least = self.items[first];
            for c in first + 1..(first + ARITY).min(n) {
                let candidate = self.items[c];
                if candidate < least {
                    (child, least) = (c, candidate);
                }
            }
            if least >= item {
                break;
            }
            self.items[i] = least;
            self.slots[least as u32 as usize] = i as u32;
            i = child;
        }
        self.items[i] = item;
        self.slots[item as u32 as usize] = i as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pops_in_order_after_key_changes() {
        let mut keys: Vec<f32> = (0..200u32).map(|i| ((i * 7919) % 211) as f32).collect();
        let mut heap = IndexedHeap::new(&keys);
        for (i, key) in keys.iter_mut().enumerate() {
            if i % 3 == 0 {
                *key = ((i * 31) % 97) as f32;
                heap.set(i as u32, *key);
            } else if i % 7 == 0 {
                *key = f32::INFINITY;
                heap.set(i as u32, f32::INFINITY);
            }
        }
        let mut expected: Vec<(u32, u32)> = keys
            .iter()
            .enumerate()
            .filter(|(_, k)| k.is_finite())
            .map(|(v, k)| (*k as u32, v as u32))
            .collect();
        expected.sort_unstable();
        let mut found = Vec::new();
        while let Some((key, v)) = heap.first() {
            found.push((key as u32, v));
            heap.remove(v);
        }
        assert_eq!(found, expected);
    }
}
