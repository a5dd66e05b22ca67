//! Codes the base mesh: grows over its triangles edge by edge, so that most triangles cost a bit or two.
//!
//! A queue contains the edges (gates) whose far side is not yet known. For each gate in turn, the triangle
//! across is either one that has already been coded, or a new one whose third vertex is new or known.
//! Closed surfaces of any kind thus come back with exactly the same adjacency, even if two vertices share
//! several edges. Vertices are numbered in the order in which they are first coded; each is virtual, a new
//! position, or another copy of a coded position.

use std::collections::HashMap;

use crate::base::mesh::Base;
use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Rate, code_uniform};
use crate::topology::surface::{NONE, SurfaceDefect};

/// Maps the decoded base, as renumbered by coding, back to the writer's base.
#[derive(Clone, Debug, Default)]
pub(crate) struct BaseOrder {
    /// The writer's index of each position.
    pub positions: Vec<u32>,
    /// The writer's index of each surface vertex, virtual ones first.
    pub vertices: Vec<u32>,
    /// For each triangle, the writer's corner (three per triangle) that is now its first corner.
    pub corners: Vec<u32>,
}

/// Upper bounds on the size of a base mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BaseLimits {
    pub position_count: u32,
    pub triangle_count: u32,
    /// Number of vertices beyond one per position.
    pub extra_wedges: u32,
}

/// A surface vertex that has been coded.
#[derive(Clone, Copy, Debug)]
struct CodedVertex {
    /// Index of its position, or `NONE` if it is virtual.
    position: u32,
    /// Index in the writer's base.
    original: u32,
}

struct BaseCoder<'a, C: Coder> {
    coder: &'a mut C,
    original: &'a Base,
    limits: BaseLimits,
    /// New index of each of the writer's vertices and positions, or `NONE` if not yet coded.
    index_of_vertex: Vec<u32>,
    index_of_position: Vec<u32>,
    coded: Vec<CodedVertex>,
    positions: Vec<u32>,
    grid_points: Vec<[i32; 3]>,
    triangles: Vec<[u32; 3]>,
    opposite: Vec<u32>,
    corners: Vec<u32>,
    /// For each of the writer's triangles, the new index of its first corner, or `NONE` if not yet coded.
    new_first_corner: Vec<u32>,
    open: HashMap<(u32, u32), Vec<u32>>,
    queue: std::collections::VecDeque<u32>,
    bits: BaseBits,
    residuals: AdaptiveNumber,
}

struct BaseBits {
    is_linked: [AdaptiveBit; 2],
    is_new: AdaptiveBit,
    is_open_end: [AdaptiveBit; 2],
    is_virtual: AdaptiveBit,
    is_copy: AdaptiveBit,
}

fn next(c: u32) -> u32 {
    if c % 3 == 2 { c - 2 } else { c + 1 }
}

fn previous(c: u32) -> u32 {
    if c.is_multiple_of(3) { c + 2 } else { c - 1 }
}

/// Codes a base mesh and returns it renumbered, on both sides. A writer passes its base as `original`, a
/// reader an empty one.
///
/// # Errors
/// [`SurfaceDefect`] if a reader decodes more than the limits allow, or too little.
pub(crate) fn code_base<C: Coder>(
    coder: &mut C,
    original: &Base,
    limits: BaseLimits,
) -> Result<(Base, BaseOrder), SurfaceDefect> {
    let bit = AdaptiveBit::new(Rate::Steady);
    let triangle_count =
        AdaptiveNumber::new(1, Rate::Steady).unsigned(coder, 0, original.triangles.len() as u32);
    if triangle_count > limits.triangle_count {
        return Err(SurfaceDefect::Corners(limits.triangle_count));
    }
    let mut state = BaseCoder {
        coder,
        original,
        limits,
        index_of_vertex: vec![NONE; original.vertex_count()],
        index_of_position: vec![NONE; original.grid_points.len()],
        coded: Vec::new(),
        positions: Vec::new(),
        grid_points: Vec::new(),
        triangles: Vec::new(),
        opposite: Vec::new(),
        corners: Vec::new(),
        new_first_corner: vec![NONE; original.triangles.len()],
        open: HashMap::new(),
        queue: std::collections::VecDeque::new(),
        bits: BaseBits {
            is_linked: [bit; 2],
            is_new: bit,
            is_open_end: [bit; 2],
            is_virtual: bit,
            is_copy: bit,
        },
        residuals: AdaptiveNumber::new(2, Rate::Quick),
    };
    let mut seed = 0;
    while state.triangles.len() < triangle_count as usize {
        while state.new_first_corner.get(seed).is_some_and(|&c| c != NONE) {
            seed += 1;
        }
        state.code_component(3 * seed as u32, triangle_count as usize)?;
    }
    if state.positions.len() != limits.position_count as usize {
        return Err(SurfaceDefect::Position(state.positions.len() as u32));
    }
    Ok(state.finish())
}

impl<C: Coder> BaseCoder<'_, C> {
    /// Codes a connected component, starting at the writer's corner `seed`.
    fn code_component(&mut self, seed: u32, max_triangles: usize) -> Result<(), SurfaceDefect> {
        let mut corners = [0; 3];
        for (i, original) in [seed, seed + 1, seed + 2].into_iter().enumerate() {
            let actual = self.original_vertex(original);
            corners[i] = self.vertex(actual, None)?;
        }
        self.push(corners, seed);
        while let Some(gate) = self.queue.pop_front() {
            if self.opposite[gate as usize] != NONE {
                continue;
            }
            let across = self.original_across(gate);
            if self.code_link(gate, across) {
                continue;
            }
            if self.triangles.len() >= max_triangles {
                return Err(SurfaceDefect::Edge(gate / 3));
            }
            let actual = self.original_vertex(across);
            let apex = self.vertex(actual, Some(gate))?;
            let [a, b] = [next(gate), previous(gate)].map(|c| self.vertex_at(c));
            // The new triangle runs along the edge in the opposite direction; its first corner faces the
            // edge.
            let first = 3 * self.triangles.len() as u32;
            self.push([apex, b, a], across);
            self.link(gate, first);
        }
        Ok(())
    }

    fn vertex_at(&self, corner: u32) -> u32 {
        self.triangles[corner as usize / 3][corner as usize % 3]
    }

    fn original_vertex(&self, original: u32) -> u32 {
        self.original.triangles.get(original as usize / 3).map_or(NONE, |t| t[original as usize % 3])
    }

    /// Returns the writer's corner across the edge that a corner faces.
    fn original_across(&self, corner: u32) -> u32 {
        if C::READS {
            return NONE;
        }
        let first = self.corners[corner as usize / 3];
        let original = first / 3 * 3 + (first % 3 + corner % 3) % 3;
        self.original.opposite.get(original as usize).copied().unwrap_or(NONE)
    }

    fn push(&mut self, corners: [u32; 3], original: u32) {
        let first = 3 * self.triangles.len() as u32;
        self.triangles.push(corners);
        self.corners.push(original);
        self.opposite.extend([NONE; 3]);
        if let Some(slot) = self.new_first_corner.get_mut(original as usize / 3) {
            *slot = first + (3 - original % 3) % 3;
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

    /// Codes whether the triangle across a gate has already been coded, and links it if so.
    fn code_link(&mut self, gate: u32, across: u32) -> bool {
        let edge = (self.vertex_at(previous(gate)), self.vertex_at(next(gate)));
        let Some(open) = self.open.get(&edge).filter(|open| !open.is_empty()) else { return false };
        let first = self.new_first_corner.get(across as usize / 3).copied().unwrap_or(NONE);
        let actual = if first == NONE { NONE } else { first / 3 * 3 + (first % 3 + across % 3) % 3 };
        let index = open.iter().position(|&c| c == actual);
        let bit = &mut self.bits.is_linked[usize::from(open.len() > 1)];
        if !bit.code(self.coder, index.is_some()) {
            return false;
        }
        let index = code_uniform(self.coder, open.len() as u32, index.unwrap_or(0) as u32);
        let partner = open[index as usize];
        self.link(gate, partner);
        true
    }

    /// Codes a vertex: the one across `gate`, or one of the first triangle of a component. A writer passes
    /// it as `actual`.
    fn vertex(&mut self, actual: u32, gate: Option<u32>) -> Result<u32, SurfaceDefect> {
        let actual_index = self.index_of_vertex.get(actual as usize).copied().unwrap_or(NONE);
        if !self.coded.is_empty() && !self.bits.is_new.code(self.coder, actual_index == NONE) {
            return Ok(self.code_earlier_vertex(actual_index, gate));
        }
        let is_virtual = self.bits.is_virtual.code(self.coder, actual < self.original.virtual_count);
        let position = if is_virtual { NONE } else { self.position(actual, gate)? };
        if let Some(slot) = self.index_of_vertex.get_mut(actual as usize) {
            *slot = self.coded.len() as u32;
        }
        self.coded.push(CodedVertex { position, original: actual });
        Ok(self.coded.len() as u32 - 1)
    }

    /// Codes the choice among the vertices coded so far; often it is one at the next open edges.
    fn code_earlier_vertex(&mut self, actual: u32, gate: Option<u32>) -> u32 {
        let open_ends =
            gate.map_or([NONE; 2], |gate| [self.open_end(gate, true), self.open_end(gate, false)]);
        for (i, guess) in open_ends.into_iter().enumerate() {
            let is_excluded = guess == NONE || (i == 1 && guess == open_ends[0]);
            if !is_excluded && self.bits.is_open_end[i].code(self.coder, guess == actual) {
                return guess;
            }
        }
        code_uniform(self.coder, self.coded.len() as u32, actual)
    }

    /// Returns the far end of the next open edge, turning around one end of a gate.
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

    /// Codes the position of a new vertex: the position of another copy, or a new one with its coordinates.
    fn position(&mut self, actual: u32, gate: Option<u32>) -> Result<u32, SurfaceDefect> {
        let original = actual.wrapping_sub(self.original.virtual_count);
        let original = self.original.position_of_copy.get(original as usize).copied().unwrap_or(NONE);
        let actual_index = self.index_of_position.get(original as usize).copied().unwrap_or(NONE);
        let count = self.positions.len() as u32;
        if count > 0 && self.bits.is_copy.code(self.coder, actual_index != NONE) {
            return Ok(code_uniform(self.coder, count, actual_index));
        }
        if count == self.limits.position_count {
            return Err(SurfaceDefect::Position(count));
        }
        let (guess, context) = self.predict(gate);
        let coordinates = self.original.grid_points.get(original as usize).copied().unwrap_or(guess);
        let grid_point = [0, 1, 2].map(|a| {
            let residual = coordinates[a].wrapping_sub(guess[a]);
            guess[a].wrapping_add(self.residuals.signed(self.coder, context, residual))
        });
        if let Some(at) = self.index_of_position.get_mut(original as usize) {
            *at = count;
        }
        self.positions.push(original);
        self.grid_points.push(grid_point);
        Ok(count)
    }

    /// Predicts the coordinates of the vertex across a gate by the parallelogram rule, and returns the
    /// context of the residual.
    fn predict(&self, gate: Option<u32>) -> ([i32; 3], usize) {
        let grid_point = |corner: u32| {
            let position = self.coded[self.vertex_at(corner) as usize].position;
            (position != NONE).then(|| self.grid_points[position as usize])
        };
        let last = self.grid_points.last().copied().unwrap_or([0; 3]);
        let Some(gate) = gate else { return (last, 0) };
        match [next(gate), previous(gate), gate].map(grid_point) {
            [Some(a), Some(b), Some(c)] => {
                (std::array::from_fn(|i| a[i].wrapping_add(b[i]).wrapping_sub(c[i])), 1)
            }
            [Some(a), ..] | [None, Some(a), _] => (a, 0),
            _ => (last, 0),
        }
    }

    /// Renumbers the vertices so that virtual ones come first.
    fn finish(self) -> (Base, BaseOrder) {
        let is_virtual = |coded: &&CodedVertex| coded.position == NONE;
        let virtual_count = self.coded.iter().filter(is_virtual).count() as u32;
        let (mut next_virtual, mut next_copy) = (0, virtual_count);
        let new_indices: Vec<u32> = self
            .coded
            .iter()
            .map(|coded| {
                let counter = if is_virtual(&coded) { &mut next_virtual } else { &mut next_copy };
                *counter += 1;
                *counter - 1
            })
            .collect();
        let (first, rest): (Vec<&CodedVertex>, Vec<&CodedVertex>) = self.coded.iter().partition(is_virtual);
        let base = Base {
            virtual_count,
            position_of_copy: rest.iter().map(|coded| coded.position).collect(),
            triangles: self.triangles.iter().map(|t| t.map(|v| new_indices[v as usize])).collect(),
            opposite: self.opposite,
            grid_points: self.grid_points,
            ..Base::default()
        };
        let vertices = first.iter().chain(&rest).map(|coded| coded.original).collect();
        (base, BaseOrder { positions: self.positions, vertices, corners: self.corners })
    }
}
