//! Finds entries of very long rings and lists of edges. A search of all entries after each collapse at a hub, such
//! as the middle of a disc or an end of an edge with very many triangles, would take quadratic time.

use std::collections::HashMap;
use std::ops::Range;

use super::edge::LinkEdge;

/// Rings of more entries than this have an order once they have been searched often.
pub(super) const HUB_ENTRIES: usize = 4096;

/// Number of searches of all entries before an order is made, since it is lost when the ring changes otherwise.
const SEARCHES: u32 = 32;

/// The long rings and lists that have been searched.
#[derive(Debug, Default)]
pub(super) struct Hubs {
    of: HashMap<u32, Hub>,
}

#[derive(Debug)]
enum Hub {
    /// Number of searches so far.
    Searched(u32),
    Ordered(HubOrder),
    Listed(HubPlaces),
}

/// Ends of the chains in [`HubPlaces`].
const NONE: u32 = u32::MAX;

/// Places of the neighbors in a list of edges. The places of each neighbor form a chain in both directions.
#[derive(Debug, Default)]
struct HubPlaces {
    first_of: HashMap<u32, u32>,
    next: Vec<u32>,
    previous: Vec<u32>,
}

/// A list of edges that is edited in place. The last edge takes the place of one that is removed.
pub(super) struct HubList<'a> {
    places: &'a mut HubPlaces,
    /// Two entries of each edge, and room for more.
    entries: &'a mut [u32],
    /// Triangle of each entry, or empty.
    triangles: &'a mut [u32],
    len: &'a mut u32,
}

impl HubPlaces {
    fn of(entries: &[u32]) -> Self {
        let mut places = Self::default();
        entries.iter().zip(0..).for_each(|(&p, place)| places.add(place, p));
        places
    }

    /// Notes that `place`, which is new or unused, holds `p`.
    fn add(&mut self, place: u32, p: u32) {
        let at = place as usize;
        if at >= self.next.len() {
            self.next.resize(at + 1, NONE);
            self.previous.resize(at + 1, NONE);
        }
        let next = self.first_of.insert(p, place).unwrap_or(NONE);
        (self.next[at], self.previous[at]) = (next, NONE);
        if next != NONE {
            self.previous[next as usize] = place;
        }
    }

    /// Notes that `place` does not hold `p` any more.
    fn take(&mut self, place: u32, p: u32) {
        let (next, previous) = (self.next[place as usize], self.previous[place as usize]);
        if next != NONE {
            self.previous[next as usize] = previous;
        }
        match (previous, next) {
            (NONE, NONE) => drop(self.first_of.remove(&p)),
            (NONE, next) => drop(self.first_of.insert(p, next)),
            (previous, next) => self.next[previous as usize] = next,
        }
    }
}

impl HubList<'_> {
    /// Replaces the edges at `p` by `added`; returns false, having changed nothing, if there is no room, or if not
    /// more than `least` entries are left of the others.
    pub(super) fn replace(&mut self, p: u32, added: &[LinkEdge], least: usize) -> bool {
        let next = |&place: &u32| Some(self.places.next[place as usize]).filter(|&next| next != NONE);
        let first = self.places.first_of.get(&p).copied();
        let left = *self.len as usize - 2 * std::iter::successors(first, next).count();
        if left + 2 * added.len() > self.entries.len() || left <= least {
            return false;
        }
        while let Some(&place) = self.places.first_of.get(&p) {
            self.remove(place & !1);
        }
        added.iter().for_each(|&edge| self.push(edge));
        true
    }

    /// Replaces `v` by `u`, and drops the edges that contained both.
    pub(super) fn rename(&mut self, v: u32, u: u32) {
        while let Some(&place) = self.places.first_of.get(&v) {
            if self.entries[place as usize ^ 1] == u {
                self.remove(place & !1);
            } else {
                self.places.take(place, v);
                self.places.add(place, u);
                self.entries[place as usize] = u;
            }
        }
    }

    /// Appends an edge; there must be room.
    fn push(&mut self, edge: LinkEdge) {
        for p in [edge.a, edge.b] {
            self.places.add(*self.len, p);
            self.entries[*self.len as usize] = p;
            if let Some(triangle) = self.triangles.get_mut(*self.len as usize) {
                *triangle = edge.triangle;
            }
            *self.len += 1;
        }
    }

    /// Removes the edge whose entries begin at `place`.
    fn remove(&mut self, place: u32) {
        let last = *self.len - 2;
        for k in 0..2 {
            self.places.take(place + k, self.entries[(place + k) as usize]);
            if last != place {
                let moved = self.entries[(last + k) as usize];
                self.places.take(last + k, moved);
                self.places.add(place + k, moved);
                self.entries[(place + k) as usize] = moved;
            }
        }
        if !self.triangles.is_empty() {
            self.triangles.copy_within(last as usize..last as usize + 2, place as usize);
        }
        *self.len = last;
    }
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
    /// The list of edges of `w`, whose first `len` entries are in use.
    pub(super) fn list<'a>(
        &'a mut self,
        w: u32,
        entries: &'a mut [u32],
        triangles: &'a mut [u32],
        len: &'a mut u32,
    ) -> HubList<'a> {
        let hub = self.of.entry(w).or_insert(Hub::Searched(0));
        if !matches!(hub, Hub::Listed(_)) {
            *hub = Hub::Listed(HubPlaces::of(&entries[..*len as usize]));
        }
        let Hub::Listed(places) = hub else { unreachable!("the hub has just become a list") };
        HubList { places, entries, triangles, len }
    }

    /// Index of `p` in the ring of `w`.
    pub(super) fn find(&mut self, w: u32, ring: &[u32], p: u32) -> Option<usize> {
        let hub = self.of.entry(w).or_insert(Hub::Searched(0));
        match hub {
            Hub::Searched(count) if *count < SEARCHES => {
                *count += 1;
                return super::substitution::find(ring, p);
            }
            Hub::Ordered(_) => {}
            _ => *hub = Hub::Ordered(HubOrder::of(ring)),
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
