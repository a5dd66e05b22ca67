//! Finds entries of very long rings. A search of all entries after each collapse at a hub, such as the middle of
//! a disc, would take quadratic time.

use std::collections::HashMap;
use std::ops::Range;

/// Rings of more entries than this have an order once they have been searched often.
pub(super) const HUB_ENTRIES: usize = 4096;

/// Number of searches of all entries before an order is made, since it is lost when the ring changes otherwise.
const SEARCHES: u32 = 32;

/// The long rings that have been searched.
#[derive(Debug, Default)]
pub(super) struct Hubs {
    of: HashMap<u32, Hub>,
}

#[derive(Debug)]
enum Hub {
    /// Number of searches so far.
    Searched(u32),
    Ordered(HubOrder),
}

/// Places of the neighbors in a ring from which some have been removed since.
#[derive(Debug)]
struct HubOrder {
    /// Place that each neighbor had in the beginning.
    place_of: HashMap<u32, u32>,
    /// Number of entries that are left, as a Fenwick tree over the places.
    left: Vec<u32>,
}

impl Hubs {
    /// Index of `p` in the ring of `w`.
    pub(super) fn find(&mut self, w: u32, ring: &[u32], p: u32) -> Option<usize> {
        let hub = self.of.entry(w).or_insert(Hub::Searched(0));
        match hub {
            Hub::Searched(count) if *count < SEARCHES => {
                *count += 1;
                return super::substitution::find(ring, p);
            }
            Hub::Searched(_) => *hub = Hub::Ordered(HubOrder::of(ring)),
            Hub::Ordered(_) => {}
        }
        let Hub::Ordered(order) = hub else { return None };
        order.index(p)
    }

    /// Notes that `v` became `u` in the ring of `w`.
    pub(super) fn rename(&mut self, w: u32, v: u32, u: u32) {
        if let Some(Hub::Ordered(order)) = self.of.get_mut(&w)
            && let Some(place) = order.place_of.remove(&v)
        {
            order.place_of.insert(u, place);
        }
    }

    /// Notes that `v` left the ring of `w`.
    pub(super) fn remove(&mut self, w: u32, v: u32) {
        if let Some(Hub::Ordered(order)) = self.of.get_mut(&w)
            && let Some(place) = order.place_of.remove(&v)
        {
            order.take(place as usize);
        }
    }

    /// Forgets the order of a ring that changed in another way.
    pub(super) fn forget(&mut self, w: u32) {
        if !self.of.is_empty() {
            self.of.remove(&w);
        }
    }
}

impl HubOrder {
    fn of(ring: &[u32]) -> Self {
        let place_of = ring.iter().zip(0..).map(|(&p, place)| (p, place)).collect();
        // Entry i of a Fenwick tree sums as many numbers as the lowest bit of i + 1, all of them 1.
        let left = (1..=ring.len() as u32).map(|i| i & i.wrapping_neg()).collect();
        Self { place_of, left }
    }

    /// Number of entries that are left before the place of `p`.
    fn index(&self, p: u32) -> Option<usize> {
        let mut end = *self.place_of.get(&p)? as usize;
        let mut sum = 0;
        while end > 0 {
            sum += self.left[end - 1] as usize;
            end &= end - 1;
        }
        Some(sum)
    }

    fn take(&mut self, place: usize) {
        let mut at = place + 1;
        while at <= self.left.len() {
            self.left[at - 1] -= 1;
            at += at & at.wrapping_neg();
        }
    }
}

/// Removes entry `i` of a slab's part of `values` by moving the shorter side. The caller moves the slab's start
/// if this returns true.
pub(super) fn remove_entry(values: &mut [u32], slab: Range<usize>, i: usize) -> bool {
    let ring = &mut values[slab];
    let is_head = ring.len() > HUB_ENTRIES && i < ring.len() / 2;
    match is_head {
        true => ring.copy_within(..i, 1),
        false => ring.copy_within(i + 1.., i),
    }
    is_head
}
