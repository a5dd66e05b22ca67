//! Geomorphs \[Hop96\]: smooth transitions from one level to another.
//!
//! While a geomorph runs, every vertex of either level is drawn. A vertex that the first level lacks starts
//! at the position of its nearest target in the first level and moves to its own position. A vertex that the
//! second level lacks starts at its own position and moves to that of its nearest target in the second level.
//! At blend 0 the drawn surface is exactly that of the first level, because all additional triangles have
//! zero area; at blend 1 it is that of the second. In between, vertices move along straight lines.
//!
//! ```text
//!    first          drawn at 0        0.5            1 = second
//!    .-----.         .-----.        .--.--.        .--.--.
//!    |    /|         |    /|        | / \ |        | /|\ |       one vertex appears
//!    |  /  |         |  /  |        |/   \|        |/ | \|       (v slides out of its target)
//!    ./----.         v/----.        .--v--.        .--v--.
//! ```
//!
//! The union of two valid sets of steps is valid too, so every level of a mesh can be morphed to every
//! other level, uniform or not. Wedges move to wedges, so each side of a seam keeps its attributes.
//!
//! Differs: \[Hop96\] morphs along one sequence; this also morphs between any two instances of fans. For
//! continuous morphing toward a target that is still changing, see [`FanMorphs`](super::FanMorphs).
//!
//! Cost: 8 bytes and constant time per moving vertex, plus a scan of one 64-bit word per 64 steps.

mod mix;

pub(in crate::model) use mix::Mix;

use bytemuck::{Pod, Zeroable};

use super::fans::FanInstance;
use crate::mesh::{AttributeLayer, CollapseSequence};

/// A vertex that moves, and the vertex that it merges with at the level that lacks it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
pub struct MorphVertex {
    /// Index of the vertex.
    pub vertex: u32,
    /// Nearest target of the vertex that exists in the level without it.
    pub target: u32,
}

/// Blend parameters of one vertex for a vertex shader: `mix(positions[target], positions[vertex], factor)`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct VertexBlend {
    /// The vertex that it moves out of or into; the vertex itself if it does not move.
    pub target: u32,
    /// 1 at the vertex's own position, 0 at that of its target.
    pub factor: f32,
}

/// The transition from one level to another; `S` identifies the level that is drawn meanwhile. See the
/// [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Geomorph<S> {
    drawn: S,
    /// Appearing vertices in ascending order, then vanishing vertices in ascending order.
    vertices: Vec<MorphVertex>,
    appearing_count: usize,
}

impl Geomorph<FanInstance> {
    /// Creates the transition from one instance of a table of fans to another.
    ///
    /// # Panics
    /// If the instances or the sequence belong to a different table.
    pub fn between(sequence: &CollapseSequence, from: &FanInstance, to: &FanInstance) -> Self {
        let step_count = sequence.step_count();
        let fits = from.step_count() == step_count && to.step_count() == step_count;
        assert!(fits, "instances of {} and {} steps of {step_count}", from.step_count(), to.step_count());
        let (mut appearing, mut vanishing) = (Vec::new(), Vec::new());
        for (word, (&a, &b)) in (0..).zip(from.words().iter().zip(to.words())) {
            let mut changed = a ^ b;
            while changed != 0 {
                let bit = changed.trailing_zeros();
                changed &= changed - 1;
                let (out, lacking) =
                    if a >> bit & 1 != 0 { (&mut appearing, from) } else { (&mut vanishing, to) };
                out.extend(sequence.step_vertices(64 * word + bit as usize).map(|vertex| MorphVertex {
                    vertex,
                    target: lacking.vertex_shown_for(sequence, vertex),
                }));
            }
        }
        let appearing_count = appearing.len();
        appearing.append(&mut vanishing);
        Self { drawn: from.union(to), vertices: appearing, appearing_count }
    }
}

impl Geomorph<usize> {
    /// Creates the transition from one uniform level to another, for any model. [`drawn`](Self::drawn) is
    /// the larger split count.
    ///
    /// # Panics
    /// If a split count exceeds the step count.
    pub fn uniform(sequence: &CollapseSequence, from: usize, to: usize) -> Self {
        let [coarse, fine] = [from.min(to), from.max(to)].map(|at| sequence.vertex_count_at(at) as u32);
        let mut vertices: Vec<MorphVertex> = Vec::with_capacity((fine - coarse) as usize);
        for vertex in coarse..fine {
            let target = sequence.target(vertex);
            // If the target moves too, its own target is already resolved.
            let target = if target < coarse { target } else { vertices[(target - coarse) as usize].target };
            vertices.push(MorphVertex { vertex, target });
        }
        let appearing_count = if from < to { vertices.len() } else { 0 };
        Self { drawn: from.max(to), vertices, appearing_count }
    }
}

impl<S> Geomorph<S> {
    /// Returns the level to draw while blending: an instance, or the split count of a uniform level.
    pub fn drawn(&self) -> &S {
        &self.drawn
    }

    /// Returns the vertices that only the second level has, ascending.
    pub fn appearing(&self) -> &[MorphVertex] {
        &self.vertices[..self.appearing_count]
    }

    /// Returns the vertices that only the first level has, ascending.
    pub fn vanishing(&self) -> &[MorphVertex] {
        &self.vertices[self.appearing_count..]
    }

    /// Number of bytes of the list of moving vertices.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.vertices[..])
    }

    /// Writes the positions of all moving vertices at a blend from 0 (the first level) to 1 (the second).
    /// Other entries of `out` are left unchanged, so initialize `out` with a copy of the positions.
    ///
    /// # Panics
    /// If `positions` or `out` does not cover all vertices.
    pub fn blend_into(&self, blend: f32, positions: &[[f32; 3]], out: &mut [[f32; 3]]) {
        for (MorphVertex { vertex, target }, factor) in self.factors(blend) {
            let [from, to] = [target, vertex].map(|v| &positions[v as usize]);
            Mix::Linear.write(from, to, factor, &mut out[vertex as usize]);
        }
    }

    /// Writes the values of another attribute layer for all moving vertices, like
    /// [`blend_into`](Self::blend_into). Normals and tangents stay normalized; joints and their weights
    /// are those of the nearer vertex, and so are identifiers.
    ///
    /// # Panics
    /// If the layer or `out` does not cover all vertices.
    pub fn blend_layer_into(&self, blend: f32, layer: &AttributeLayer, out: &mut [f32]) {
        let (mix, count) = (Mix::of(layer), usize::from(layer.component_count));
        let (mut from, mut to) = (vec![0.0; count], vec![0.0; count]);
        for (MorphVertex { vertex, target }, factor) in self.factors(blend) {
            for (i, (from, to)) in from.iter_mut().zip(&mut to).enumerate() {
                *from = layer.get(target as usize, i);
                *to = layer.get(vertex as usize, i);
            }
            mix.write(&from, &to, factor, &mut out[vertex as usize * count..][..count]);
        }
    }

    /// Resets all moving vertices to their own positions.
    ///
    /// # Panics
    /// If `positions` or `out` does not cover all vertices.
    pub fn restore_into(&self, positions: &[[f32; 3]], out: &mut [[f32; 3]]) {
        self.vertices.iter().map(|moved| moved.vertex as usize).for_each(|v| out[v] = positions[v]);
    }

    /// Fills `out` with the blend parameters of vertices `0..vertex_count`, for a vertex shader.
    ///
    /// # Panics
    /// If a moving vertex is not below `vertex_count`.
    pub fn vertex_blends_into(&self, blend: f32, vertex_count: usize, out: &mut Vec<VertexBlend>) {
        out.clear();
        out.extend((0..vertex_count as u32).map(|vertex| VertexBlend { target: vertex, factor: 1.0 }));
        for (MorphVertex { vertex, target }, factor) in self.factors(blend) {
            out[vertex as usize] = VertexBlend { target, factor };
        }
    }

    /// Returns each moving vertex with its blend factor: 1 at its own position, 0 at its target's.
    fn factors(&self, blend: f32) -> impl Iterator<Item = (MorphVertex, f32)> {
        // A NaN blend counts as 0.
        let blend = if blend > 0.0 { blend.min(1.0) } else { 0.0 };
        let appearing = self.appearing().iter().map(move |&vertex| (vertex, blend));
        appearing.chain(self.vanishing().iter().map(move |&vertex| (vertex, 1.0 - blend)))
    }
}
