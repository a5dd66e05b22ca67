//! A triangulation with adjacency and its two edit operations: replacing a floor by a fan, and a fan by a
//! floor.
//!
//! Triangles are stored in slots. Side `i` of a triangle runs from its corner `i` to the next; across it
//! is another slot or a border. Every vertex stores one of its triangles. A rule is matched by walking its
//! tree over the triangles, so a floor is located from one of its sides.

use super::rule::LoopRule;

/// Marks a missing triangle.
pub(in crate::baseline) const NONE: u32 = u32::MAX;

/// A manifold surface of oriented triangles, possibly with borders.
#[derive(Clone, Debug)]
pub(in crate::baseline) struct LoopSurface {
    corners: Vec<[u32; 3]>,
    across: Vec<[u32; 3]>,
    /// One triangle of each vertex, or [`NONE`].
    triangle_at: Vec<u32>,
}

/// A region located by a walk: its ring, the triangles outside the ring and those inside.
#[derive(Clone, Debug, Default)]
pub(in crate::baseline) struct LoopRegion {
    /// Vertices of the ring, beginning at the first anchor.
    pub ring: Vec<u32>,
    /// For each vertex of the ring, the triangle across the side that begins there.
    outer: Vec<u32>,
    slots: Vec<u32>,
    rings: Vec<RingPart>,
}

/// A part of a ring that remains to be triangulated, and the side from which it is entered.
#[derive(Clone, Copy, Debug)]
struct RingPart {
    first: usize,
    /// Last corner; the ring's length denotes corner 0.
    last: usize,
    /// The triangle inside the part, or the one before it.
    slot: u32,
    side: usize,
}

/// A slot and a side of its triangle, or the corner at which the side begins.
pub(in crate::baseline) type Side = (u32, usize);

#[inline]
fn next(side: usize) -> usize {
    if side == 2 { 0 } else { side + 1 }
}

impl LoopSurface {
    /// Connects triangles along their edges.
    ///
    /// # Errors
    /// The first triangle that cannot be part of a surface, and the reason.
    pub(in crate::baseline) fn new(
        corners: &[[u32; 3]],
        vertex_count: usize,
    ) -> Result<Self, (usize, &'static str)> {
        let mut sides = Vec::with_capacity(3 * corners.len());
        let mut counts = vec![0u32; vertex_count];
        let mut triangle_at = vec![NONE; vertex_count];
        for (slot, t) in corners.iter().enumerate() {
            if t.iter().any(|&v| v as usize >= vertex_count) {
                return Err((slot, "has a vertex out of range"));
            }
            if t[0] == t[1] || t[1] == t[2] || t[2] == t[0] {
                return Err((slot, "has a vertex twice"));
            }
            for side in 0..3 {
                counts[t[side] as usize] += 1;
                triangle_at[t[side] as usize] = slot as u32;
                sides.push((t[side], t[next(side)], slot as u32, side));
            }
        }
        sides.sort_unstable();
        if let Some(pair) = sides.windows(2).find(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1)) {
            return Err((pair[1].2 as usize, "has an edge in the same direction as another triangle"));
        }
        let mut across = vec![[NONE; 3]; corners.len()];
        for &(from, to, slot, side) in &sides {
            let at = sides.partition_point(|other| (other.0, other.1) < (to, from));
            if let Some(other) = sides.get(at).filter(|other| (other.0, other.1) == (to, from)) {
                across[slot as usize][side] = other.2;
            }
        }
        let surface = Self { corners: corners.to_vec(), across, triangle_at };
        let mut star = Vec::new();
        for (v, &count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
            surface.star_into(v as u32, &mut star);
            if star.len() != count as usize {
                let slot = surface.triangle_at[v] as usize;
                return Err((slot, "has a vertex whose triangles are not one fan"));
            }
        }
        Ok(surface)
    }

    pub(in crate::baseline) fn corners(&self) -> &[[u32; 3]] {
        &self.corners
    }

    pub(super) fn has(&self, vertex: u32) -> bool {
        self.triangle_at[vertex as usize] != NONE
    }

    /// Appends a vertex, initially without triangles.
    pub(in crate::baseline) fn add_vertex(&mut self) {
        self.triangle_at.push(NONE);
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.corners[..]) + size_of_val(&self.across[..]) + size_of_val(&self.triangle_at[..])
    }

    #[inline]
    fn corner_of(&self, slot: u32, vertex: u32) -> usize {
        let corners = &self.corners[slot as usize];
        debug_assert!(corners.contains(&vertex), "{corners:?} has no vertex {vertex}");
        usize::from(corners[1] == vertex) + 2 * usize::from(corners[2] == vertex)
    }

    /// The next triangle counterclockwise around the vertex at the given corner.
    #[inline]
    fn turn_left(&self, (slot, corner): Side) -> Option<Side> {
        let vertex = self.corners[slot as usize][corner];
        let other = self.across[slot as usize][next(next(corner))];
        (other != NONE).then(|| (other, self.corner_of(other, vertex)))
    }

    #[inline]
    fn turn_right(&self, (slot, corner): Side) -> Option<Side> {
        let vertex = self.corners[slot as usize][corner];
        let other = self.across[slot as usize][corner];
        (other != NONE).then(|| (other, self.corner_of(other, vertex)))
    }

    /// Lists the triangles of a vertex counterclockwise, each with the vertex's corner, beginning at the
    /// border if there is one. Returns whether they form a closed ring.
    pub(in crate::baseline) fn star_into(&self, vertex: u32, out: &mut Vec<Side>) -> bool {
        out.clear();
        let slot = self.triangle_at[vertex as usize];
        if slot == NONE {
            return false;
        }
        let start = (slot, self.corner_of(slot, vertex));
        let mut first = start;
        let mut is_closed = false;
        while let Some(before) = self.turn_right(first) {
            first = before;
            if first == start {
                is_closed = true;
                break;
            }
        }
        out.push(first);
        while let Some(after) = self.turn_left(out[out.len() - 1]) {
            if after == first {
                break;
            }
            out.push(after);
        }
        is_closed
    }

    /// The first side from one vertex to another that `accept` accepts, if any.
    pub(super) fn find_side(&self, from: u32, to: u32, accept: impl Fn(Side) -> bool) -> Option<Side> {
        let slot = self.triangle_at[from as usize];
        if slot == NONE {
            return None;
        }
        let is_it = |side: Side| self.corners[side.0 as usize][next(side.1)] == to && accept(side);
        let start = (slot, self.corner_of(slot, from));
        let mut at = start;
        loop {
            if is_it(at) {
                return Some(at);
            }
            match self.turn_left(at) {
                Some(after) if after == start => return None,
                Some(after) => at = after,
                None => break,
            }
        }
        at = start;
        while let Some(before) = self.turn_right(at) {
            if is_it(before) {
                return Some(before);
            }
            at = before;
        }
        None
    }

    /// Whether a side is a border.
    pub(in crate::baseline) fn is_border(&self, (slot, side): Side) -> bool {
        self.across[slot as usize][side] == NONE
    }

    /// Matches the floor of a rule against the triangles, beginning at the given side: the comparison of
    /// \[KG98\], with a positioned rule. Returns false if the triangles differ or the ring is not simple.
    pub(in crate::baseline) fn find_floor(
        &self,
        rule: LoopRule,
        start: Side,
        region: &mut LoopRegion,
    ) -> bool {
        let n = rule.ring_len();
        let (slot, side) = start;
        region.start(n);
        region.ring[0] = self.corners[slot as usize][side];
        region.ring[1] = self.corners[slot as usize][next(side)];
        region.outer[0] = self.across[slot as usize][side];
        region.rings.push(RingPart { first: 1, last: n, slot, side });
        for &apex in rule.apexes {
            let Some(RingPart { first, last, slot, side }) = region.rings.pop() else { return false };
            let m = usize::from(apex);
            let corners = &self.corners[slot as usize];
            let matches = corners[side] == region.ring[last % n] && corners[next(side)] == region.ring[first];
            if !matches || m <= first || m >= last {
                return false;
            }
            region.slots.push(slot);
            region.ring[m] = corners[next(next(side))];
            for (first, last, side) in [(m, last, next(next(side))), (first, m, next(side))] {
                let across_side = self.across[slot as usize][side];
                if last - first == 1 {
                    region.outer[first] = across_side;
                } else if across_side == NONE {
                    return false;
                } else {
                    let side = self.corner_of(across_side, region.ring[last % n]);
                    region.rings.push(RingPart { first, last, slot: across_side, side });
                }
            }
        }
        region.rings.is_empty()
    }

    /// Whether the fan of an open ring can replace the located floor: the floor is at a border, or it
    /// closes a hole whose ends have no other border.
    pub(in crate::baseline) fn is_openable(&self, region: &LoopRegion, star: &mut Vec<Side>) -> bool {
        let ends = [region.ring[0], region.ring[region.ring.len() - 1]];
        region.outer.last() == Some(&NONE) || ends.into_iter().all(|end| self.star_into(end, star))
    }

    /// The triangles of a located floor.
    pub(in crate::baseline) fn region_corners<'f>(
        &'f self,
        region: &'f LoopRegion,
    ) -> impl Iterator<Item = [u32; 3]> + 'f {
        region.slots.iter().map(|&slot| self.corners[slot as usize])
    }

    /// Locates the fan and the ring of a vertex, beginning at an anchor.
    pub(super) fn find_fan(&self, vertex: u32, anchor: u32, region: &mut LoopRegion, star: &mut Vec<Side>) {
        let is_closed = self.star_into(vertex, star);
        let after = |&(slot, corner): &Side| self.corners[slot as usize][next(corner)];
        if is_closed {
            let start = star.iter().position(|side| after(side) == anchor);
            star.rotate_left(start.expect("an anchor is around its vertex"));
        }
        region.start(0);
        for side in star.iter() {
            region.ring.push(after(side));
            region.outer.push(self.across[side.0 as usize][next(side.1)]);
            region.slots.push(side.0);
        }
        if let Some(&(slot, corner)) = star.last().filter(|_| !is_closed) {
            region.ring.push(self.corners[slot as usize][next(next(corner))]);
            region.outer.push(NONE);
        }
    }

    /// Replaces a located floor by the fan of a new vertex.
    pub(in crate::baseline) fn replace_by_fan(
        &mut self,
        vertex: u32,
        rule: LoopRule,
        region: &mut LoopRegion,
    ) {
        let (n, count) = (rule.ring_len(), rule.ceiling_len());
        while region.slots.len() < count {
            region.slots.push(self.corners.len() as u32);
            self.corners.push([NONE; 3]);
            self.across.push([NONE; 3]);
        }
        for i in 0..count {
            let [a, b] = [region.ring[i], region.ring[(i + 1) % n]];
            let slot = region.slots[i];
            let before = if i > 0 { region.slots[i - 1] } else { region.slots[count - 1] };
            let after = region.slots[(i + 1) % count];
            let is_end = |at: usize| rule.is_open && i == at;
            self.corners[slot as usize] = [vertex, a, b];
            self.across[slot as usize] = [
                if is_end(0) { NONE } else { before },
                region.outer[i],
                if is_end(count - 1) { NONE } else { after },
            ];
            self.join(region.outer[i], [b, a], slot);
            self.triangle_at[a as usize] = slot;
            self.triangle_at[b as usize] = slot;
        }
        if rule.is_open && n > 2 {
            // If the floor had closed a hole, the hole is open again.
            self.join(region.outer[n - 1], [region.ring[0], region.ring[n - 1]], NONE);
        }
        self.triangle_at[vertex as usize] = region.slots[0];
    }

    /// Replaces the located fan of a vertex by a floor.
    pub(super) fn replace_by_floor(&mut self, vertex: u32, rule: LoopRule, region: &mut LoopRegion) {
        let n = rule.ring_len();
        debug_assert_eq!(region.ring.len(), n, "the fan is another rule's");
        self.triangle_at[vertex as usize] = NONE;
        let [first, last] = [region.ring[0], region.ring[n - 1]];
        let mut closing = None;
        if rule.apexes.is_empty() {
            // The fan is a triangle attached to an edge of another, which becomes a border.
            self.join(region.outer[0], [last, first], NONE);
            [first, last].iter().for_each(|&v| self.triangle_at[v as usize] = region.outer[0]);
        } else {
            region.rings.push(RingPart { first: 1, last: n, slot: region.outer[0], side: 3 });
        }
        for (at, &apex) in rule.apexes.iter().enumerate() {
            let part = region.rings.pop().expect("a rule is a tree");
            let m = usize::from(apex);
            let slot = region.slots[at];
            let corners = [part.last % n, part.first, m].map(|corner| region.ring[corner]);
            self.corners[slot as usize] = corners;
            self.across[slot as usize][0] = part.slot;
            corners.iter().for_each(|&v| self.triangle_at[v as usize] = slot);
            if part.side == 3 {
                self.join(part.slot, [corners[1], corners[0]], slot);
            } else {
                self.across[part.slot as usize][part.side] = slot;
            }
            for (first, last, side) in [(m, part.last, 2), (part.first, m, 1)] {
                if last - first > 1 {
                    region.rings.push(RingPart { first, last, slot, side });
                    continue;
                }
                self.across[slot as usize][side] = region.outer[first];
                self.join(region.outer[first], [region.ring[last % n], region.ring[first]], slot);
                if rule.is_open && last == n {
                    closing = Some((slot, side));
                }
            }
        }
        if let Some(side) = closing {
            self.close_hole(side, last);
        }
        let rest = &mut region.slots[rule.apexes.len()..];
        rest.sort_unstable();
        rest.iter().rev().for_each(|&slot| self.remove(slot));
    }

    /// Connects a new border side with the one at the other end of its vertex's fan if that leads back.
    fn close_hole(&mut self, side: Side, from: u32) {
        let mut at = (side.0, next(side.1));
        while let Some(before) = self.turn_right(at) {
            at = before;
        }
        if self.corners[at.0 as usize][next(at.1)] == from {
            self.across[at.0 as usize][at.1] = side.0;
            self.across[side.0 as usize][side.1] = at.0;
        }
    }

    /// Sets the triangle across the side `ends` of a triangle.
    fn join(&mut self, slot: u32, ends: [u32; 2], across_side: u32) {
        if slot != NONE {
            let side = self.corner_of(slot, ends[0]);
            debug_assert_eq!(self.corners[slot as usize][next(side)], ends[1]);
            self.across[slot as usize][side] = across_side;
        }
    }

    /// Removes a triangle that nothing refers to any more; the last triangle moves to its slot.
    fn remove(&mut self, slot: u32) {
        self.corners.swap_remove(slot as usize);
        self.across.swap_remove(slot as usize);
        let moved = self.corners.len() as u32;
        if slot == moved {
            return;
        }
        let (corners, across) = (self.corners[slot as usize], self.across[slot as usize]);
        for side in 0..3 {
            let ends = [corners[next(side)], corners[side]];
            // A neighbor across two sides is updated for both.
            self.join(across[side], ends, slot);
            let at = &mut self.triangle_at[corners[side] as usize];
            if *at == moved {
                *at = slot;
            }
        }
    }
}

impl LoopRegion {
    fn start(&mut self, n: usize) {
        self.ring.clear();
        self.ring.resize(n, NONE);
        self.outer.clear();
        self.outer.resize(n, NONE);
        self.slots.clear();
        self.rings.clear();
    }

    /// Describes a triangle to be attached to a border edge of another one.
    pub(in crate::baseline) fn attach(&mut self, ring: [u32; 2], on: u32) {
        self.start(2);
        self.ring.copy_from_slice(&ring);
        self.outer[0] = on;
    }
}
