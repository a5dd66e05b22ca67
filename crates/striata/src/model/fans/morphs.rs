//! Animates an instance toward a changing target instance, frame by frame, without jumps.
//!
//! A step that is newly refined is drawn immediately, but its vertices start at the positions of their
//! targets and move to their own over several frames. A step that is no longer wanted moves back, and is
//! collapsed in the drawn instance once it has arrived; by then every step that must be collapsed before
//! it has arrived too. A vertex is drawn between the *drawn position of its target* and its own position;
//! evaluating vertices from coarse to fine keeps chains of moving vertices connected. Each drawn position
//! depends only on the progress of the steps, which changes by one frame at a time. Nothing can jump, even
//! if the target instance changes in the middle of a motion.
//!
//! ```text
//! target    refined              collapsed
//! frame     1    2    3    4     5    6    7
//! factor   1/4  2/4  3/4   1    3/4  2/4  1/4   0: collapsed in the drawn instance too
//! ```
//!
//! Run-time geomorphs in \[Hop97\] move a vertex between two fixed positions; here, refining and
//! coarsening are a single motion that can be reversed at any time.
//!
//! Cost: one instance plus 8 bytes per moving step. A frame scans one 64-bit word per 64 steps and takes
//! time proportional to the number of moving vertices.

use super::{FanInstance, Fans};
use crate::mesh::{AttributeLayer, CollapseSequence};
use crate::model::geomorph::Mix;

/// A vertex in motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovingVertex {
    /// Index of the vertex.
    pub vertex: u32,
    /// The drawn vertex that it comes from or goes to, which may be moving too.
    pub target: u32,
    /// Progress: 0 at the drawn position of its target, 1 at its own position.
    pub factor: f32,
}

/// A step whose vertices are in motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct MovingStep {
    step: u32,
    /// Progress in frames; `frame_count` is its own position.
    frame: u16,
}

/// Continuous morphing of an instance from frame to frame \[Hop96\].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FanMorphs {
    drawn: FanInstance,
    frame_count: u16,
    /// Steps in motion, ascending.
    moving: Vec<MovingStep>,
    /// Steps whose vertices arrived at their own positions in the last frame.
    arrived: Vec<u32>,
    /// Scratch for the moving steps of the next frame.
    next: Vec<MovingStep>,
}

/// How the values of a layer are mixed.
struct MixedCount {
    /// Whether they stay normalized, or are taken from the nearer vertex.
    pub mix: Mix,
    /// Number of components per vertex.
    pub count: usize,
}

impl FanMorphs {
    /// Starts at rest with an instance. Each motion takes `frame_count` frames; with 0 or 1, every change
    /// is immediate.
    pub fn new(instance: &FanInstance, frame_count: u16) -> Self {
        let frame_count = frame_count.max(1);
        let (moving, arrived, next) = (Vec::new(), Vec::new(), Vec::new());
        Self { drawn: instance.clone(), frame_count, moving, arrived, next }
    }

    /// Returns the instance to draw: the target instance plus everything that is still moving back.
    pub fn drawn(&self) -> &FanInstance {
        &self.drawn
    }

    /// Number of steps in motion.
    pub fn moving_count(&self) -> usize {
        self.moving.len()
    }

    /// Number of bytes of the drawn instance and of the moving steps.
    pub fn bytes(&self) -> usize {
        self.drawn.bytes() + 2 * size_of_val(&self.moving[..]) + size_of_val(&self.arrived[..])
    }

    /// Advances one frame toward the target instance `wanted`.
    ///
    /// # Panics
    /// If the target instance belongs to a different table.
    pub fn advance(&mut self, fans: &Fans, wanted: &FanInstance) {
        self.check(fans, wanted);
        self.arrived.clear();
        let moving = std::mem::take(&mut self.moving);
        let mut moving_steps = moving.iter().copied().peekable();
        let mut next = std::mem::take(&mut self.next);
        next.clear();
        for word in 0..wanted.words().len() {
            let mut steps = self.drawn.words()[word] ^ wanted.words()[word];
            // Steps in motion continue even if they are already drawn as wanted.
            let at_first = moving_steps.clone();
            let of_word = at_first.take_while(|moving| moving.step as usize / 64 == word);
            of_word.for_each(|moving| steps |= 1 << (moving.step % 64));
            while steps != 0 {
                let step = 64 * word as u32 + steps.trailing_zeros();
                steps &= steps - 1;
                let known = moving_steps.next_if(|moving| moving.step == step).map(|moving| moving.frame);
                next.extend(self.move_step(step, known, wanted));
            }
        }
        self.next = moving;
        self.moving = next;
        self.collapse_arrived(fans);
    }

    /// Jumps to another instance immediately, as after a camera cut.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn jump_to(&mut self, fans: &Fans, wanted: &FanInstance) {
        self.check(fans, wanted);
        self.arrived.clear();
        for (word, (&drawn, &wanted)) in (0..).zip(self.drawn.words().iter().zip(wanted.words())) {
            let mut changed = drawn & !wanted;
            while changed != 0 {
                self.arrived.push(64 * word + changed.trailing_zeros());
                changed &= changed - 1;
            }
        }
        self.arrived.extend(self.moving.drain(..).map(|moving| moving.step));
        self.drawn.clone_from(wanted);
    }

    /// Returns all vertices in motion from coarse to fine, so a moving target comes before the vertices
    /// that depend on it.
    ///
    /// # Panics
    /// If the sequence belongs to a different mesh.
    pub fn moving<'a>(&'a self, sequence: &'a CollapseSequence) -> impl Iterator<Item = MovingVertex> + 'a {
        self.moving.iter().flat_map(move |moving| {
            let factor = f32::from(moving.frame) / f32::from(self.frame_count);
            sequence.step_vertices(moving.step as usize).map(move |vertex| {
                let target = self.drawn.vertex_shown_for(sequence, sequence.target(vertex));
                MovingVertex { vertex, target, factor }
            })
        })
    }

    /// Returns the vertices that arrived at their own positions in the last frame.
    ///
    /// # Panics
    /// If the sequence belongs to a different mesh.
    pub fn arrived<'a>(&'a self, sequence: &'a CollapseSequence) -> impl Iterator<Item = u32> + 'a {
        self.arrived.iter().flat_map(|&step| sequence.step_vertices(step as usize))
    }

    /// Writes the positions of all vertices that moved in the last frame. Initialize `out` with a copy of
    /// the positions and call this in every frame; then the positions of all drawn vertices are correct.
    ///
    /// # Panics
    /// If `positions` or `out` does not cover all vertices, or the sequence belongs to a different mesh.
    pub fn positions_into(&self, sequence: &CollapseSequence, positions: &[[f32; 3]], out: &mut [[f32; 3]]) {
        let own = |vertex: usize, i: usize| positions[vertex][i];
        self.write(sequence, MixedCount { mix: Mix::Linear, count: 3 }, own, out.as_flattened_mut());
    }

    /// Writes another attribute layer, like [`positions_into`](Self::positions_into) does for positions.
    /// Normals and tangents stay normalized; joints and their weights are those of the nearer vertex, and
    /// so are identifiers.
    ///
    /// # Panics
    /// If the layer or `out` does not cover all vertices, or the sequence belongs to a different mesh.
    pub fn layer_into(&self, sequence: &CollapseSequence, layer: &AttributeLayer, out: &mut [f32]) {
        let shape = MixedCount { mix: Mix::of(layer), count: usize::from(layer.component_count) };
        self.write(sequence, shape, |vertex, i| layer.get(vertex, i), out);
    }

    /// Advances a step by one frame. Returns `None` if its vertices have arrived at their own positions.
    fn move_step(&mut self, step: u32, known: Option<u16>, wanted: &FanInstance) -> Option<MovingStep> {
        if !wanted.is_refined(step) {
            let frame = known.unwrap_or(self.frame_count).saturating_sub(1);
            return Some(MovingStep { step, frame });
        }
        self.drawn.collapsed.remove(step);
        let frame = known.unwrap_or(0) + 1;
        if frame < self.frame_count {
            return Some(MovingStep { step, frame });
        }
        self.arrived.push(step);
        None
    }

    /// Collapses the steps that have arrived at their targets. The steps that must be collapsed before
    /// them have arrived too, because they have been unwanted for at least as long and all motions take
    /// the same time.
    fn collapse_arrived(&mut self, fans: &Fans) {
        let Self { drawn, moving, .. } = self;
        for &MovingStep { step, frame } in moving.iter().rev() {
            if frame > 0 {
                continue;
            }
            if cfg!(debug_assertions) {
                fans.for_each_needed_by_collapse(step, |finer| {
                    assert!(!drawn.is_refined(finer), "step {step} is collapsed before {finer}");
                });
            }
            drawn.collapsed.insert(step);
        }
        moving.retain(|moving| moving.frame > 0);
    }

    /// Writes a layer with `count` components per vertex for all vertices that moved.
    fn write(
        &self,
        sequence: &CollapseSequence,
        MixedCount { mix, count }: MixedCount,
        own: impl Fn(usize, usize) -> f32,
        out: &mut [f32],
    ) {
        for vertex in self.arrived(sequence) {
            let values = &mut out[vertex as usize * count..][..count];
            values.iter_mut().enumerate().for_each(|(i, out)| *out = own(vertex as usize, i));
        }
        let (mut from, mut to) = (vec![0.0; count], vec![0.0; count]);
        for MovingVertex { vertex, target, factor } in self.moving(sequence) {
            let (vertex, target_at) = (vertex as usize, target as usize);
            (0..count).for_each(|i| to[i] = own(vertex, i));
            if self.is_moving(sequence, target) {
                from.copy_from_slice(&out[target_at * count..][..count]);
            } else {
                (0..count).for_each(|i| from[i] = own(target_at, i));
            }
            mix.write(&from, &to, factor, &mut out[vertex * count..][..count]);
        }
    }

    fn is_moving(&self, sequence: &CollapseSequence, vertex: u32) -> bool {
        let position = sequence.positions().position_of(vertex);
        position
            .checked_sub(sequence.base_position_count() as u32)
            .is_some_and(|step| self.moving.binary_search_by_key(&step, |moving| moving.step).is_ok())
    }

    fn check(&self, fans: &Fans, wanted: &FanInstance) {
        self.drawn.check_table(fans);
        wanted.check_table(fans);
    }
}
