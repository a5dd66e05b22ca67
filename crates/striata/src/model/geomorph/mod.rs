//! Geomorphs \[Hop96\]: from one level to another without a jump.
//!
//! Between two sets of steps everything is drawn that either of them shows. A vertex that the first lacks begins where its
//! targets lead to in the first and ends at its own place; one that the second lacks begins at its own place and ends
//! where its targets lead to in the second. So the drawn surface is the first one's at blend 0, triangle by triangle, since
//! what it has beside has no area then; it is the second one's at blend 1, and moves on straight lines between.
//!
//! ```text
//!    first          drawn at 0        0.5            1 = second
//!    .-----.         .-----.        .--.--.        .--.--.
//!    |    /|         |    /|        | / \ |        | /|\ |       one vertex appears
//!    |  /  |         |  /  |        |/   \|        |/ | \|       (v slides out of its target)
//!    ./----.         v/----.        .--v--.        .--v--.
//! ```
//!
//! Both sets hold what their steps need, hence their union does, and every level of a mesh can be morphed to every other,
//! uniform or not. Wedges move to wedges, so that each side of a seam keeps its attributes.
//!
//! Differs: \[Hop96\] morphs along one sequence; here also between any two instances of fans. What morphs while the wanted
//! level still changes is [`FanMorphs`](super::FanMorphs).
//!
//! Cost: 8 bytes a vertex that moves, and time in proportion, beside a look at each 64 steps.

mod mix;

pub(in crate::model) use mix::Mix;

use bytemuck::{Pod, Zeroable};

use super::fans::FanInstance;
use crate::mesh::{AttributeLayer, CollapseSequence};

/// A vertex that moves, and the vertex at whose place it is not there.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
pub struct MorphVertex {
    /// The vertex.
    pub vertex: u32,
    /// Where its targets lead to in the level that lacks it.
    pub target: u32,
}

/// Where a vertex shader finds a vertex: `mix(positions[target], positions[vertex], factor)`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct MorphPlace {
    /// The vertex that it comes from or goes to; itself where it does not move.
    pub target: u32,
    /// 1 at its own place, 0 at its target's.
    pub factor: f32,
}

/// The way from one level to another; `S` says which level is drawn meanwhile. See the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Geomorph<S> {
    drawn: S,
    /// Those that appear, rising, then those that vanish, rising.
    vertices: Vec<MorphVertex>,
    appearing_count: usize,
}

impl Geomorph<FanInstance> {
    /// The way from one instance of a table of fans to another.
    ///
    /// # Panics
    /// If the instances or the sequence are of another table.
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
    /// The way from one uniform level to another, for any model; drawn is the finer one's split count.
    ///
    /// # Panics
    /// If a split count exceeds the step count.
    pub fn uniform(sequence: &CollapseSequence, from: usize, to: usize) -> Self {
        let [coarse, fine] = [from.min(to), from.max(to)].map(|at| sequence.vertex_count_at(at) as u32);
        let mut vertices: Vec<MorphVertex> = Vec::with_capacity((fine - coarse) as usize);
        for vertex in coarse..fine {
            let target = sequence.target(vertex);
            // A target that moves itself has been led on already.
            let target = if target < coarse { target } else { vertices[(target - coarse) as usize].target };
            vertices.push(MorphVertex { vertex, target });
        }
        let appearing_count = if from < to { vertices.len() } else { 0 };
        Self { drawn: from.max(to), vertices, appearing_count }
    }
}

impl<S> Geomorph<S> {
    /// What to draw while blending: an instance, or the split count of a uniform level.
    pub fn drawn(&self) -> &S {
        &self.drawn
    }

    /// Vertices that only the second level has, rising.
    pub fn appearing(&self) -> &[MorphVertex] {
        &self.vertices[..self.appearing_count]
    }

    /// Vertices that only the first level has, rising.
    pub fn vanishing(&self) -> &[MorphVertex] {
        &self.vertices[self.appearing_count..]
    }

    /// Bytes of the vertices that move.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.vertices[..])
    }

    /// Writes the places of all vertices that move, at a blend of 0 (the first level) to 1 (the second); others in `out` are
    /// left alone: it begins as a copy of the positions.
    ///
    /// # Panics
    /// If the positions or `out` are not those of all vertices.
    pub fn blend_into(&self, blend: f32, positions: &[[f32; 3]], out: &mut [[f32; 3]]) {
        for (MorphVertex { vertex, target }, factor) in self.factors(blend) {
            let [from, to] = [target, vertex].map(|v| &positions[v as usize]);
            Mix::Linear.write(from, to, factor, &mut out[vertex as usize]);
        }
    }

    /// Does as [`blend_into`](Self::blend_into) for another layer, as floats: normals and tangents keep their length, joints
    /// and their weights are the nearer vertex's.
    ///
    /// # Panics
    /// If the layer or `out` are not those of all vertices.
    pub fn blend_layer_into(&self, blend: f32, layer: &AttributeLayer, out: &mut [f32]) {
        let (mix, count) = (Mix::of(&layer.semantic), usize::from(layer.component_count));
        let (mut from, mut to) = (vec![0.0; count], vec![0.0; count]);
        for (MorphVertex { vertex, target }, factor) in self.factors(blend) {
            for (i, (from, to)) in from.iter_mut().zip(&mut to).enumerate() {
                *from = layer.get(target as usize, i);
                *to = layer.get(vertex as usize, i);
            }
            mix.write(&from, &to, factor, &mut out[vertex as usize * count..][..count]);
        }
    }

    /// Puts all vertices that moved back to their own places.
    ///
    /// # Panics
    /// If the positions or `out` are not those of all vertices.
    pub fn restore_into(&self, positions: &[[f32; 3]], out: &mut [[f32; 3]]) {
        self.vertices.iter().map(|moved| moved.vertex as usize).for_each(|v| out[v] = positions[v]);
    }

    /// Makes the table that lets a vertex shader blend, one entry for each of so many vertices.
    ///
    /// # Panics
    /// If vertices move that are not among them.
    pub fn places_into(&self, blend: f32, vertex_count: usize, out: &mut Vec<MorphPlace>) {
        out.clear();
        out.extend((0..vertex_count as u32).map(|vertex| MorphPlace { target: vertex, factor: 1.0 }));
        for (MorphVertex { vertex, target }, factor) in self.factors(blend) {
            out[vertex as usize] = MorphPlace { target, factor };
        }
    }

    /// Each vertex that moves with how far it is at its own place.
    fn factors(&self, blend: f32) -> impl Iterator<Item = (MorphVertex, f32)> {
        // What is no number blends nothing.
        let blend = if blend > 0.0 { blend.min(1.0) } else { 0.0 };
        let appearing = self.appearing().iter().map(move |&vertex| (vertex, blend));
        appearing.chain(self.vanishing().iter().map(move |&vertex| (vertex, 1.0 - blend)))
    }
}
