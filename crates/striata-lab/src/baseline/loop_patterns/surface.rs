//! A triangulation that knows its neighbors, and the two ways to change it: a fan for a floor, and a floor for a fan.
//!
//! Triangles stand side by side in slots. Side `i` of a triangle runs from its corner `i` to the next; behind it is another slot,
//! or a border. Every vertex knows one of its triangles. A rule is laid over the triangles by walking its tree, so that a floor
//! is found from one of its sides.

use super::rule::Rule;

/// No triangle.
pub(in crate::baseline) const NONE: u32 = u32::MAX;

/// A manifold surface of oriented triangles, borders allowed.
#[derive(Clone, Debug)]
pub(in crate::baseline) struct Surface {
    corners: Vec<[u32; 3]>,
    beside: Vec<[u32; 3]>,
    /// Some triangle of each vertex, or [`NONE`].
    triangle_at: Vec<u32>,
}

/// What a walk finds: a ring, what lies outside of it, and the triangles within.
#[derive(Clone, Debug, Default)]
pub(in crate::baseline) struct Found {
    /// Vertices of the ring from the first anchor on.
    pub(in crate::baseline) ring: Vec<u32>,
    /// Behind the side of the ring that each of them begins.
    outer: Vec<u32>,
    slots: Vec<u32>,
    rings: Vec<Part>,
}

/// A part of a ring that a triangle is to fill, and where that hangs.
#[derive(Clone, Copy, Debug)]
struct Part {
    first: usize,
    /// The ring's length stands for its first corner.
    last: usize,
    /// A slot: the triangle itself, or the one before it.
    slot: u32,
    side: usize,
}

/// A triangle and one of its sides, or the corner that the side begins with.
pub(in crate::baseline) type Side = (u32, usize);

#[inline]
fn next(side: usize) -> usize {
    if side == 2 { 0 } else { side + 1 }
}

impl Surface {
    /// Joins triangles along their edges.
    ///
    /// # Errors
    /// A triangle and what keeps it from being part of a surface.
    pub(in crate::baseline) fn new(
        corners: &[[u32; 3]],
        vertex_count: usize,
    ) -> Result<Self, (usize, &'static str)> {
        let mut sides = Vec::with_capacity(3 * corners.len());
        let mut counts = vec![0u32; vertex_count];
        let mut triangle_at = vec![NONE; vertex_count];
        for (slot, t) in corners.iter().enumerate() {
            if t.iter().any(|&v| v as usize >= vertex_count) {
                return Err((slot, "has a vertex that is not there"));
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
            return Err((pair[1].2 as usize, "runs along an edge as another triangle does"));
        }
        let mut beside = vec![[NONE; 3]; corners.len()];
        for &(from, to, slot, side) in &sides {
            let at = sides.partition_point(|other| (other.0, other.1) < (to, from));
            if let Some(other) = sides.get(at).filter(|other| (other.0, other.1) == (to, from)) {
                beside[slot as usize][side] = other.2;
            }
        }
        let surface = Self { corners: corners.to_vec(), beside, triangle_at };
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

    /// The next vertex, without triangles as yet.
    pub(in crate::baseline) fn add_vertex(&mut self) {
        self.triangle_at.push(NONE);
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.corners[..]) + size_of_val(&self.beside[..]) + size_of_val(&self.triangle_at[..])
    }

    #[inline]
    fn corner_of(&self, slot: u32, vertex: u32) -> usize {
        let corners = &self.corners[slot as usize];
        debug_assert!(corners.contains(&vertex), "{corners:?} has no vertex {vertex}");
        usize::from(corners[1] == vertex) + 2 * usize::from(corners[2] == vertex)
    }

    /// The triangle around a vertex that comes after one, counterclockwise; the vertex stands at the given corner.
    #[inline]
    fn turn_left(&self, (slot, corner): Side) -> Option<Side> {
        let vertex = self.corners[slot as usize][corner];
        let other = self.beside[slot as usize][next(next(corner))];
        (other != NONE).then(|| (other, self.corner_of(other, vertex)))
    }

    #[inline]
    fn turn_right(&self, (slot, corner): Side) -> Option<Side> {
        let vertex = self.corners[slot as usize][corner];
        let other = self.beside[slot as usize][corner];
        (other != NONE).then(|| (other, self.corner_of(other, vertex)))
    }

    /// Lists the triangles of a vertex counterclockwise, with the corner where it stands: from the border on, if there is one.
    /// Whether they close a ring.
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

    /// The side from one vertex to another that is accepted, if any is.
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

    /// Whether nothing lies behind a side.
    pub(in crate::baseline) fn is_border(&self, (slot, side): Side) -> bool {
        self.beside[slot as usize][side] == NONE
    }

    /// Lays the floor of a rule over the triangles from its first side on: the comparison of \[KG98\], where what is compared is
    /// a rule with a place. False where the triangles are otherwise, or the ring is not simple.
    pub(in crate::baseline) fn find_floor(&self, rule: Rule, start: Side, found: &mut Found) -> bool {
        let n = rule.ring_len();
        let (slot, side) = start;
        found.start(n);
        found.ring[0] = self.corners[slot as usize][side];
        found.ring[1] = self.corners[slot as usize][next(side)];
        found.outer[0] = self.beside[slot as usize][side];
        found.rings.push(Part { first: 1, last: n, slot, side });
        for &apex in rule.apexes {
            let Some(Part { first, last, slot, side }) = found.rings.pop() else { return false };
            let m = usize::from(apex);
            let corners = &self.corners[slot as usize];
            let is_entered =
                corners[side] == found.ring[last % n] && corners[next(side)] == found.ring[first];
            if !is_entered || m <= first || m >= last {
                return false;
            }
            found.slots.push(slot);
            found.ring[m] = corners[next(next(side))];
            for (first, last, side) in [(m, last, next(next(side))), (first, m, next(side))] {
                let behind = self.beside[slot as usize][side];
                if last - first == 1 {
                    found.outer[first] = behind;
                } else if behind == NONE {
                    return false;
                } else {
                    let side = self.corner_of(behind, found.ring[last % n]);
                    found.rings.push(Part { first, last, slot: behind, side });
                }
            }
        }
        found.rings.is_empty()
    }

    /// Whether the fan of an open ring can be put where a floor was found: it lies at a border, or it closes a hole
    /// whose ends have no other border.
    pub(in crate::baseline) fn is_openable(&self, found: &Found, star: &mut Vec<Side>) -> bool {
        let ends = [found.ring[0], found.ring[found.ring.len() - 1]];
        found.outer.last() == Some(&NONE) || ends.into_iter().all(|end| self.star_into(end, star))
    }

    /// The triangles of a floor that was found.
    pub(in crate::baseline) fn found_corners<'f>(
        &'f self,
        found: &'f Found,
    ) -> impl Iterator<Item = [u32; 3]> + 'f {
        found.slots.iter().map(|&slot| self.corners[slot as usize])
    }

    /// Finds the ring of a vertex from an anchor on.
    pub(super) fn find_fan(&self, vertex: u32, anchor: u32, found: &mut Found, star: &mut Vec<Side>) {
        let is_closed = self.star_into(vertex, star);
        let after = |&(slot, corner): &Side| self.corners[slot as usize][next(corner)];
        if is_closed {
            let start = star.iter().position(|side| after(side) == anchor);
            star.rotate_left(start.expect("an anchor is around its vertex"));
        }
        found.start(0);
        for side in star.iter() {
            found.ring.push(after(side));
            found.outer.push(self.beside[side.0 as usize][next(side.1)]);
            found.slots.push(side.0);
        }
        if let Some(&(slot, corner)) = star.last().filter(|_| !is_closed) {
            found.ring.push(self.corners[slot as usize][next(next(corner))]);
            found.outer.push(NONE);
        }
    }

    /// Puts the fan of a new vertex where a floor was found.
    pub(in crate::baseline) fn put_fan(&mut self, vertex: u32, rule: Rule, found: &mut Found) {
        let (n, count) = (rule.ring_len(), rule.ceiling_len());
        while found.slots.len() < count {
            found.slots.push(self.corners.len() as u32);
            self.corners.push([NONE; 3]);
            self.beside.push([NONE; 3]);
        }
        for i in 0..count {
            let [a, b] = [found.ring[i], found.ring[(i + 1) % n]];
            let slot = found.slots[i];
            let before = if i > 0 { found.slots[i - 1] } else { found.slots[count - 1] };
            let after = found.slots[(i + 1) % count];
            let is_end = |at: usize| rule.is_open && i == at;
            self.corners[slot as usize] = [vertex, a, b];
            self.beside[slot as usize] = [
                if is_end(0) { NONE } else { before },
                found.outer[i],
                if is_end(count - 1) { NONE } else { after },
            ];
            self.join(found.outer[i], [b, a], slot);
            self.triangle_at[a as usize] = slot;
            self.triangle_at[b as usize] = slot;
        }
        if rule.is_open && n > 2 {
            // Where the floor had closed a hole the hole is open again.
            self.join(found.outer[n - 1], [found.ring[0], found.ring[n - 1]], NONE);
        }
        self.triangle_at[vertex as usize] = found.slots[0];
    }

    /// Puts a floor where the fan of a vertex was found.
    pub(super) fn put_floor(&mut self, vertex: u32, rule: Rule, found: &mut Found) {
        let n = rule.ring_len();
        debug_assert_eq!(found.ring.len(), n, "the fan is another rule's");
        self.triangle_at[vertex as usize] = NONE;
        let [first, last] = [found.ring[0], found.ring[n - 1]];
        let mut closing = None;
        if rule.apexes.is_empty() {
            // A triangle on an edge of another: that becomes a border.
            self.join(found.outer[0], [last, first], NONE);
            [first, last].iter().for_each(|&v| self.triangle_at[v as usize] = found.outer[0]);
        } else {
            found.rings.push(Part { first: 1, last: n, slot: found.outer[0], side: 3 });
        }
        for (at, &apex) in rule.apexes.iter().enumerate() {
            let part = found.rings.pop().expect("a rule is a tree");
            let m = usize::from(apex);
            let slot = found.slots[at];
            let corners = [part.last % n, part.first, m].map(|corner| found.ring[corner]);
            self.corners[slot as usize] = corners;
            self.beside[slot as usize][0] = part.slot;
            corners.iter().for_each(|&v| self.triangle_at[v as usize] = slot);
            if part.side == 3 {
                self.join(part.slot, [corners[1], corners[0]], slot);
            } else {
                self.beside[part.slot as usize][part.side] = slot;
            }
            for (first, last, side) in [(m, part.last, 2), (part.first, m, 1)] {
                if last - first > 1 {
                    found.rings.push(Part { first, last, slot, side });
                    continue;
                }
                self.beside[slot as usize][side] = found.outer[first];
                self.join(found.outer[first], [found.ring[last % n], found.ring[first]], slot);
                if rule.is_open && last == n {
                    closing = Some((slot, side));
                }
            }
        }
        if let Some(side) = closing {
            self.close_hole(side, last);
        }
        let rest = &mut found.slots[rule.apexes.len()..];
        rest.sort_unstable();
        rest.iter().rev().for_each(|&slot| self.remove(slot));
    }

    /// Joins a new border side with what lies at the other end of the fan of the vertex that it leads to, if that leads back.
    fn close_hole(&mut self, side: Side, from: u32) {
        let mut at = (side.0, next(side.1));
        while let Some(before) = self.turn_right(at) {
            at = before;
        }
        if self.corners[at.0 as usize][next(at.1)] == from {
            self.beside[at.0 as usize][at.1] = side.0;
            self.beside[side.0 as usize][side.1] = at.0;
        }
    }

    /// Tells a triangle what lies behind its side `ends`.
    fn join(&mut self, slot: u32, ends: [u32; 2], behind: u32) {
        if slot != NONE {
            let side = self.corner_of(slot, ends[0]);
            debug_assert_eq!(self.corners[slot as usize][next(side)], ends[1]);
            self.beside[slot as usize][side] = behind;
        }
    }

    /// Takes a triangle out that no other names any more; the last one moves to its slot.
    fn remove(&mut self, slot: u32) {
        self.corners.swap_remove(slot as usize);
        self.beside.swap_remove(slot as usize);
        let moved = self.corners.len() as u32;
        if slot == moved {
            return;
        }
        let (corners, beside) = (self.corners[slot as usize], self.beside[slot as usize]);
        for side in 0..3 {
            let ends = [corners[next(side)], corners[side]];
            // A neighbor behind two sides is told of both.
            self.join(beside[side], ends, slot);
            let at = &mut self.triangle_at[corners[side] as usize];
            if *at == moved {
                *at = slot;
            }
        }
    }
}

impl Found {
    fn start(&mut self, n: usize) {
        self.ring.clear();
        self.ring.resize(n, NONE);
        self.outer.clear();
        self.outer.resize(n, NONE);
        self.slots.clear();
        self.rings.clear();
    }

    /// A triangle that hangs on an edge of another: found where that has a border.
    pub(in crate::baseline) fn hang(&mut self, ring: [u32; 2], on: u32) {
        self.start(2);
        self.ring.copy_from_slice(&ring);
        self.outer[0] = on;
    }
}
