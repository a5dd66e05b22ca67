//! Coding the base mesh: its triangles one across an edge of another, so that most of them cost a bit or two.
//!
//! A queue holds the edges of triangles behind which nothing is known yet. The first is taken: behind it is another
//! triangle that is there already, or a new one, whose third vertex is new or known. So closed surfaces of any kind
//! come back with their very adjacency, also where two vertices have several edges in common. Vertices are numbered as
//! they are met; a vertex is virtual, a new position, or another copy of one.

use std::collections::HashMap;

use crate::base::mesh::Base;
use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Rate, code_uniform};
use crate::topology::surface::{NONE, SurfaceDefect};

/// Which parts of a writer's base are where in what a reader gets.
#[derive(Clone, Debug, Default)]
pub(crate) struct BaseOrder {
    /// The writer's position of each new one.
    pub(crate) positions: Vec<u32>,
    /// The writer's vertex of each new one, virtual ones first.
    pub(crate) vertices: Vec<u32>,
    /// For each new triangle the writer's corner, three a triangle, that is its first.
    pub(crate) corners: Vec<u32>,
}

/// What a base may be at most.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BaseLimits {
    pub(crate) position_count: u32,
    pub(crate) triangle_count: u32,
    /// Vertices beyond one a position.
    pub(crate) wedges_beyond: u32,
}

/// A vertex that has been met.
#[derive(Clone, Copy, Debug)]
struct Met {
    /// Its position; none if it is virtual.
    position: u32,
    /// The writer's number.
    known: u32,
}

struct BaseCoder<'a, C: Coder> {
    coder: &'a mut C,
    known: &'a Base,
    limits: BaseLimits,
    /// The new number of each of the writer's vertices and positions.
    met_of: Vec<u32>,
    position_of: Vec<u32>,
    met: Vec<Met>,
    positions: Vec<u32>,
    places: Vec<[i32; 3]>,
    triangles: Vec<[u32; 3]>,
    opposite: Vec<u32>,
    corners: Vec<u32>,
    /// The writer's triangles that have been coded, as first corners here.
    first_corner: Vec<u32>,
    open: HashMap<(u32, u32), Vec<u32>>,
    queue: std::collections::VecDeque<u32>,
    bits: Bits,
    residuals: AdaptiveNumber,
}

struct Bits {
    joins: [AdaptiveBit; 2],
    is_new: AdaptiveBit,
    is_guess: [AdaptiveBit; 2],
    is_virtual: AdaptiveBit,
    is_copy: AdaptiveBit,
}

fn next(c: u32) -> u32 {
    if c % 3 == 2 { c - 2 } else { c + 1 }
}

fn previous(c: u32) -> u32 {
    if c.is_multiple_of(3) { c + 2 } else { c - 1 }
}

/// Codes a base: the writer's `known`, nothing for a reader. What comes back is numbered anew on both sides.
///
/// # Errors
/// Where a reader gets more than the limits allow, or too little.
pub(crate) fn code_base<C: Coder>(
    coder: &mut C,
    known: &Base,
    limits: BaseLimits,
) -> Result<(Base, BaseOrder), SurfaceDefect> {
    let bit = AdaptiveBit::new(Rate::Steady);
    let triangle_count =
        AdaptiveNumber::new(1, Rate::Steady).unsigned(coder, 0, known.triangles.len() as u32);
    if triangle_count > limits.triangle_count {
        return Err(SurfaceDefect::Corners(limits.triangle_count));
    }
    let mut state = BaseCoder {
        coder,
        known,
        limits,
        met_of: vec![NONE; known.vertex_count()],
        position_of: vec![NONE; known.places.len()],
        met: Vec::new(),
        positions: Vec::new(),
        places: Vec::new(),
        triangles: Vec::new(),
        opposite: Vec::new(),
        corners: Vec::new(),
        first_corner: vec![NONE; known.triangles.len()],
        open: HashMap::new(),
        queue: std::collections::VecDeque::new(),
        bits: Bits { joins: [bit; 2], is_new: bit, is_guess: [bit; 2], is_virtual: bit, is_copy: bit },
        residuals: AdaptiveNumber::new(2, Rate::Quick),
    };
    let mut seed = 0;
    while state.triangles.len() < triangle_count as usize {
        while state.first_corner.get(seed).is_some_and(|&c| c != NONE) {
            seed += 1;
        }
        state.component(3 * seed as u32, triangle_count as usize)?;
    }
    if state.positions.len() != limits.position_count as usize {
        return Err(SurfaceDefect::Position(state.positions.len() as u32));
    }
    Ok(state.finish())
}

impl<C: Coder> BaseCoder<'_, C> {
    /// A component, from the writer's corner on.
    fn component(&mut self, seed: u32, most: usize) -> Result<(), SurfaceDefect> {
        let mut corners = [0; 3];
        for (i, known) in [seed, seed + 1, seed + 2].into_iter().enumerate() {
            let meant = self.known_vertex(known);
            corners[i] = self.vertex(meant, None)?;
        }
        self.push(corners, seed);
        while let Some(gate) = self.queue.pop_front() {
            if self.opposite[gate as usize] != NONE {
                continue;
            }
            let across = self.known_across(gate);
            if self.join(gate, across) {
                continue;
            }
            if self.triangles.len() >= most {
                return Err(SurfaceDefect::Edge(gate / 3));
            }
            let meant = self.known_vertex(across);
            let apex = self.vertex(meant, Some(gate))?;
            let [a, b] = [next(gate), previous(gate)].map(|c| self.vertex_at(c));
            // The edge runs the other way in the new triangle; its first corner faces the edge.
            let first = 3 * self.triangles.len() as u32;
            self.push([apex, b, a], across);
            self.link(gate, first);
        }
        Ok(())
    }

    fn vertex_at(&self, corner: u32) -> u32 {
        self.triangles[corner as usize / 3][corner as usize % 3]
    }

    fn known_vertex(&self, known: u32) -> u32 {
        self.known.triangles.get(known as usize / 3).map_or(NONE, |t| t[known as usize % 3])
    }

    /// The writer's corner across the edge that a corner faces.
    fn known_across(&self, corner: u32) -> u32 {
        if C::READS {
            return NONE;
        }
        let first = self.corners[corner as usize / 3];
        let known = first / 3 * 3 + (first % 3 + corner % 3) % 3;
        self.known.opposite.get(known as usize).copied().unwrap_or(NONE)
    }

    fn push(&mut self, corners: [u32; 3], known: u32) {
        let first = 3 * self.triangles.len() as u32;
        self.triangles.push(corners);
        self.corners.push(known);
        self.opposite.extend([NONE; 3]);
        if let Some(place) = self.first_corner.get_mut(known as usize / 3) {
            *place = first + (3 - known % 3) % 3;
        }
        for corner in first..first + 3 {
            let edge = (self.vertex_at(next(corner)), self.vertex_at(previous(corner)));
            self.open.entry(edge).or_default().push(corner);
            self.queue.push_back(corner);
        }
    }

    fn link(&mut self, a: u32, b: u32) {
        self.opposite[a as usize] = b;
        self.opposite[b as usize] = a;
        for corner in [a, b] {
            let edge = (self.vertex_at(next(corner)), self.vertex_at(previous(corner)));
            if let Some(open) = self.open.get_mut(&edge) {
                open.retain(|&c| c != corner);
            }
        }
    }

    /// Codes whether a triangle that is there already lies behind an edge, and joins it.
    fn join(&mut self, gate: u32, across: u32) -> bool {
        let edge = (self.vertex_at(previous(gate)), self.vertex_at(next(gate)));
        let Some(open) = self.open.get(&edge).filter(|open| !open.is_empty()) else { return false };
        let first = self.first_corner.get(across as usize / 3).copied().unwrap_or(NONE);
        let meant = if first == NONE { NONE } else { first / 3 * 3 + (first % 3 + across % 3) % 3 };
        let place = open.iter().position(|&c| c == meant);
        let bit = &mut self.bits.joins[usize::from(open.len() > 1)];
        if !bit.code(self.coder, place.is_some()) {
            return false;
        }
        let place = code_uniform(self.coder, open.len() as u32, place.unwrap_or(0) as u32);
        let partner = open[place as usize];
        self.link(gate, partner);
        true
    }

    /// Codes a vertex, which is `meant` for a writer: behind an edge, or at the beginning of a component.
    fn vertex(&mut self, meant: u32, gate: Option<u32>) -> Result<u32, SurfaceDefect> {
        let meant_met = self.met_of.get(meant as usize).copied().unwrap_or(NONE);
        if !self.met.is_empty() && !self.bits.is_new.code(self.coder, meant_met == NONE) {
            return Ok(self.known_vertex_here(meant_met, gate));
        }
        let is_virtual = self.bits.is_virtual.code(self.coder, meant < self.known.virtual_count);
        let position = if is_virtual { NONE } else { self.position(meant, gate)? };
        if let Some(place) = self.met_of.get_mut(meant as usize) {
            *place = self.met.len() as u32;
        }
        self.met.push(Met { position, known: meant });
        Ok(self.met.len() as u32 - 1)
    }

    /// Codes which of the vertices that have been met it is: perhaps one at the next open edges.
    fn known_vertex_here(&mut self, meant: u32, gate: Option<u32>) -> u32 {
        let guesses = gate.map_or([NONE; 2], |gate| [self.open_end(gate, true), self.open_end(gate, false)]);
        for (i, guess) in guesses.into_iter().enumerate() {
            let is_tried = guess == NONE || (i == 1 && guess == guesses[0]);
            if !is_tried && self.bits.is_guess[i].code(self.coder, guess == meant) {
                return guess;
            }
        }
        code_uniform(self.coder, self.met.len() as u32, meant)
    }

    /// The far end of the next open edge around one end of a gate.
    fn open_end(&self, gate: u32, is_forward: bool) -> u32 {
        let mut corner = gate;
        for _ in 0..64 {
            let turned = if is_forward { next(corner) } else { previous(corner) };
            match self.opposite[turned as usize] {
                NONE => {
                    let far = if is_forward { previous(turned) } else { next(turned) };
                    return self.vertex_at(far);
                }
                across => corner = across,
            }
        }
        NONE
    }

    /// Codes the position of a new vertex: that of another copy, or a new one with its place.
    fn position(&mut self, meant: u32, gate: Option<u32>) -> Result<u32, SurfaceDefect> {
        let known = meant.wrapping_sub(self.known.virtual_count);
        let known = self.known.position_of_copy.get(known as usize).copied().unwrap_or(NONE);
        let meant_position = self.position_of.get(known as usize).copied().unwrap_or(NONE);
        let count = self.positions.len() as u32;
        if count > 0 && self.bits.is_copy.code(self.coder, meant_position != NONE) {
            return Ok(code_uniform(self.coder, count, meant_position));
        }
        if count == self.limits.position_count {
            return Err(SurfaceDefect::Position(count));
        }
        let (guess, context) = self.guess_place(gate);
        let actual = self.known.places.get(known as usize).copied().unwrap_or(guess);
        let place = [0, 1, 2].map(|a| {
            let residual = actual[a].wrapping_sub(guess[a]);
            guess[a].wrapping_add(self.residuals.signed(self.coder, context, residual))
        });
        if let Some(at) = self.position_of.get_mut(known as usize) {
            *at = count;
        }
        self.positions.push(known);
        self.places.push(place);
        Ok(count)
    }

    /// Where a vertex behind an edge may be: where it would make a parallelogram.
    fn guess_place(&self, gate: Option<u32>) -> ([i32; 3], usize) {
        let place = |corner: u32| {
            let position = self.met[self.vertex_at(corner) as usize].position;
            (position != NONE).then(|| self.places[position as usize])
        };
        let last = self.places.last().copied().unwrap_or([0; 3]);
        let Some(gate) = gate else { return (last, 0) };
        match [next(gate), previous(gate), gate].map(place) {
            [Some(a), Some(b), Some(c)] => {
                (std::array::from_fn(|i| a[i].wrapping_add(b[i]).wrapping_sub(c[i])), 1)
            }
            [Some(a), ..] | [None, Some(a), _] => (a, 0),
            _ => (last, 0),
        }
    }

    /// The base with virtual vertices first.
    fn finish(self) -> (Base, BaseOrder) {
        let is_virtual = |met: &&Met| met.position == NONE;
        let virtual_count = self.met.iter().filter(is_virtual).count() as u32;
        let (mut virtuals, mut copies) = (0, virtual_count);
        let numbers: Vec<u32> = self
            .met
            .iter()
            .map(|met| {
                let counter = if is_virtual(&met) { &mut virtuals } else { &mut copies };
                *counter += 1;
                *counter - 1
            })
            .collect();
        let (first, rest): (Vec<&Met>, Vec<&Met>) = self.met.iter().partition(is_virtual);
        let base = Base {
            virtual_count,
            position_of_copy: rest.iter().map(|met| met.position).collect(),
            triangles: self.triangles.iter().map(|t| t.map(|v| numbers[v as usize])).collect(),
            opposite: self.opposite,
            places: self.places,
            ..Base::default()
        };
        let vertices = first.iter().chain(&rest).map(|met| met.known).collect();
        (base, BaseOrder { positions: self.positions, vertices, corners: self.corners })
    }
}
