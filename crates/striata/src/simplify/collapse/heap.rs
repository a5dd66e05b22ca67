//! Priority queue over positions with changeable keys: a four-ary heap of the least entries, and a list of the rest.
//!
//! Most keys change several times before they are the least. Only the next eighth of all entries is therefore in the
//! heap, which fits into the cache; the others have just a key. When the heap is empty, the next eighth is selected.

const ARITY: usize = 4;
/// The slot of a position without a key.
const ABSENT: u32 = u32::MAX;
/// The slot of a position whose key lies beyond the heap.
const WAITING: u32 = u32::MAX - 1;
/// The slot of a position that is being selected for the heap.
const SELECTED: u32 = u32::MAX - 2;
/// Share of the waiting entries that the heap takes, and how many it takes at least.
const SHARE: usize = 8;
const MIN_TAKEN: usize = 1024;

/// Min-heap of positions by key; ties break by position index, so that the order is deterministic.
#[derive(Debug)]
pub(in crate::simplify) struct IndexedHeap {
    /// Key bits in the high half, position in the low half, so that one comparison orders both.
    items: Vec<u64>,
    places: Vec<HeapPlace>,
    /// Every waiting position, and perhaps others and repetitions.
    waiting: Vec<u32>,
    /// Every entry up to this one is in the heap, and no other.
    last: u64,
}

/// The key of a position, and its place in the heap.
#[derive(Clone, Copy, Debug)]
struct HeapPlace {
    /// Index in `items`, or one of the special values.
    slot: u32,
    /// The key, if the position is waiting.
    key: f32,
}

#[inline]
fn pack(key: f32, v: u32) -> u64 {
    // Non-negative floats have the same order as their bits; adding zero turns -0 into 0.
    (u64::from((key + 0.0).to_bits()) << 32) | u64::from(v)
}

impl IndexedHeap {
    /// Builds a queue from the key of every position; positions with key `f32::INFINITY` are left out.
    pub(in crate::simplify) fn new(keys: &[f32]) -> Self {
        let place = |&key: &f32| HeapPlace { slot: if key < f32::INFINITY { WAITING } else { ABSENT }, key };
        let is_waiting = |&v: &u32| keys[v as usize] < f32::INFINITY;
        Self {
            items: Vec::new(),
            places: keys.iter().map(place).collect(),
            waiting: (0..keys.len() as u32).filter(is_waiting).collect(),
            last: 0,
        }
    }

    /// Returns the smallest key and its position.
    #[inline]
    pub(in crate::simplify) fn first(&mut self) -> Option<(f32, u32)> {
        if self.items.is_empty() {
            self.refill();
        }
        self.items.first().map(|&item| (f32::from_bits((item >> 32) as u32), item as u32))
    }

    /// Inserts a position or changes its key; `f32::INFINITY` removes it.
    #[inline]
    pub(in crate::simplify) fn set(&mut self, v: u32, key: f32) {
        debug_assert!(key >= 0.0, "keys are never negative, nor NaN");
        if key == f32::INFINITY {
            return self.remove(v);
        }
        let (item, slot) = (pack(key, v), self.places[v as usize].slot);
        if item > self.last {
            match slot {
                WAITING => {}
                ABSENT => self.waiting.push(v),
                _ => {
                    self.remove(v);
                    self.waiting.push(v);
                }
            }
            self.places[v as usize] = HeapPlace { slot: WAITING, key };
        } else if slot >= WAITING {
            self.items.push(item);
            self.sift_up(self.items.len() - 1);
        } else {
            let i = slot as usize;
            let old = std::mem::replace(&mut self.items[i], item);
            if item < old {
                self.sift_up(i);
            } else if item > old {
                self.sift_down(i);
            }
        }
    }

    /// Removes a position if it has a key.
    pub(in crate::simplify) fn remove(&mut self, v: u32) {
        let slot = std::mem::replace(&mut self.places[v as usize].slot, ABSENT);
        if slot >= WAITING {
            return;
        }
        let i = slot as usize;
        let last = self.items.len() - 1;
        let moved = self.items.swap_remove(i);
        if i == last {
            return;
        }
        let filler = self.items[i];
        self.places[filler as u32 as usize].slot = i as u32;
        if filler < moved {
            self.sift_up(i);
        } else {
            self.sift_down(i);
        }
    }

    /// Moves the least of the waiting entries into the heap, which is empty.
    #[cold]
    fn refill(&mut self) {
        let places = &mut self.places;
        self.waiting.retain(|&v| {
            let place = &mut places[v as usize];
            let is_first = place.slot == WAITING;
            if is_first {
                place.slot = SELECTED;
            }
            is_first
        });
        let taken = self.waiting.len().min(MIN_TAKEN.max(self.waiting.len() / SHARE));
        if taken == 0 {
            self.waiting = Vec::new();
            return;
        }
        let mut items: Vec<u64> = self.waiting.iter().map(|&v| pack(places[v as usize].key, v)).collect();
        self.last = *items.select_nth_unstable(taken - 1).1;
        items[taken..].iter().for_each(|&item| places[item as u32 as usize].slot = WAITING);
        self.waiting.retain(|&v| places[v as usize].slot == WAITING);
        items.truncate(taken);
        self.items.extend_from_slice(&items);
        for (i, &item) in (0..).zip(&items) {
            places[item as u32 as usize].slot = i;
        }
        for i in (0..taken.div_ceil(ARITY)).rev() {
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
            self.places[above as u32 as usize].slot = i as u32;
            i = parent;
        }
        self.items[i] = item;
        self.places[item as u32 as usize].slot = i as u32;
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
            self.places[least as u32 as usize].slot = i as u32;
            i = child;
        }
        self.items[i] = item;
        self.places[item as u32 as usize].slot = i as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pops everything, and compares the order with sorted keys.
    fn check_order(mut heap: IndexedHeap, keys: &[f32]) {
        let mut expected: Vec<u64> =
            (0..).zip(keys).filter(|(_, key)| key.is_finite()).map(|(v, &key)| pack(key, v)).collect();
        expected.sort_unstable();
        for expected in expected {
            let (key, v) = heap.first().expect("an entry is left");
            assert_eq!(pack(key, v), expected);
            heap.remove(v);
        }
        assert_eq!(heap.first(), None);
    }

    #[test]
    fn pops_in_order_after_key_changes() {
        // More than the heap takes at a time; many keys are equal.
        let mut keys: Vec<f32> = (0..5000u32).map(|i| ((i * 7919) % 211) as f32).collect();
        let mut heap = IndexedHeap::new(&keys);
        for round in 0..4 {
            for (i, key) in keys.iter_mut().enumerate() {
                if i % 3 == round % 3 {
                    *key = ((i * 31 + round) % 97) as f32;
                } else if i % 7 == round {
                    *key = f32::INFINITY;
                }
                heap.set(i as u32, *key);
            }
            for _ in 0..300 {
                let (_, v) = heap.first().expect("an entry is left");
                heap.remove(v);
                keys[v as usize] = f32::INFINITY;
            }
        }
        check_order(heap, &keys);
    }

    #[test]
    fn entries_may_leave_the_heap_and_return() {
        let mut keys = vec![1.0f32; 3 * MIN_TAKEN];
        let mut heap = IndexedHeap::new(&keys);
        for key in [9.0, 0.0, 7.0, f32::INFINITY, 5.0, 0.5] {
            assert!(heap.first().is_some());
            for v in (0..keys.len()).step_by(2) {
                keys[v] = key + (v % 4) as f32;
                heap.set(v as u32, keys[v]);
            }
        }
        check_order(heap, &keys);
        assert_eq!(IndexedHeap::new(&[]).first(), None);
    }
}
