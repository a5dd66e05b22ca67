//! An instance that follows what is wanted frame by frame, in motion instead of jumps.
//!
//! A step that is newly undone is drawn at once, but its vertices begin at their targets' places and move to their own over
//! some frames; a step that is no longer wanted moves back, and is taken in the drawn instance once it has arrived: by then all
//! that it waits for has arrived, too. A vertex is shown between where its *target is shown* and its own place; worked out from coarse
//! to fine, chains of vertices that all move stay together. So a place depends on nothing but how far each step has come, which
//! changes by one frame's share at a time: nothing can jump, whatever is wanted next, also in the middle of a motion.
//!
//! ```text
//! wanted    undone               taken again
//! frame     1    2    3    4     5    6    7
//! factor   1/4  2/4  3/4   1    3/4  2/4  1/4   0: taken
//! ```
//!
//! Geomorphs at run time are \[Hop97\]'s, of a vertex between two places that are fixed; here refining and coarsening are one
//! motion that may turn round at any time.
//!
//! Cost: an instance, 8 bytes a step that moves; a frame takes a look at each 64 steps and time in proportion to what moves.

use super::{FanInstance, Fans};
use crate::mesh::{AttributeLayer, CollapseSequence};
use crate::model::geomorph::Mix;

/// A vertex that is on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovingVertex {
    /// The vertex.
    pub vertex: u32,
    /// The drawn vertex that it comes from or goes to; it may move, too.
    pub target: u32,
    /// 0 where its target is shown, 1 at its own place.
    pub factor: f32,
}

/// A step that is drawn on its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct MovingStep {
    step: u32,
    /// Frames of the way to its own place.
    frame: u16,
}

/// The motion of an instance from frame to frame: it follows what is wanted, and nothing jumps \[Hop96\].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FanMorphs {
    drawn: FanInstance,
    frame_count: u16,
    /// Rising.
    moving: Vec<MovingStep>,
    /// Steps that came to their own place in the last frame.
    settled: Vec<u32>,
    /// Memory for the next frame's steps.
    next: Vec<MovingStep>,
}

impl FanMorphs {
    /// Begins at rest with an instance. Each motion takes `frame_count` frames; 0 is as 1, a change at once.
    pub fn new(instance: &FanInstance, frame_count: u16) -> Self {
        let frame_count = frame_count.max(1);
        let (moving, settled, next) = (Vec::new(), Vec::new(), Vec::new());
        Self { drawn: instance.clone(), frame_count, moving, settled, next }
    }

    /// The instance to draw: what is wanted, and what is still on its way out.
    pub fn drawn(&self) -> &FanInstance {
        &self.drawn
    }

    /// Steps that move.
    pub fn moving_count(&self) -> usize {
        self.moving.len()
    }

    /// Bytes of the drawn instance and of the steps that move.
    pub fn bytes(&self) -> usize {
        self.drawn.bytes() + 2 * size_of_val(&self.moving[..]) + size_of_val(&self.settled[..])
    }

    /// Moves one frame on towards what is wanted now.
    ///
    /// # Panics
    /// If the wanted instance is of another table.
    pub fn advance(&mut self, fans: &Fans, wanted: &FanInstance) {
        self.check(fans, wanted);
        self.settled.clear();
        let moving = std::mem::take(&mut self.moving);
        let mut moving_steps = moving.iter().copied().peekable();
        let mut next = std::mem::take(&mut self.next);
        next.clear();
        for word in 0..wanted.words().len() {
            let mut steps = self.drawn.words()[word] ^ wanted.words()[word];
            // All that moves goes on, whether or not it is drawn as wanted.
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
        self.take_arrived(fans);
    }

    /// Is at rest with another instance at once, as after a cut.
    ///
    /// # Panics
    /// If the instance is of another table.
    pub fn jump_to(&mut self, fans: &Fans, wanted: &FanInstance) {
        self.check(fans, wanted);
        self.settled.clear();
        for (word, (&drawn, &wanted)) in (0..).zip(self.drawn.words().iter().zip(wanted.words())) {
            let mut undone = drawn & !wanted;
            while undone != 0 {
                self.settled.push(64 * word + undone.trailing_zeros());
                undone &= undone - 1;
            }
        }
        self.settled.extend(self.moving.drain(..).map(|moving| moving.step));
        self.drawn.clone_from(wanted);
    }

    /// All vertices that move, from coarse to fine: a target that moves comes before those that go to it.
    ///
    /// # Panics
    /// If the sequence is another mesh's.
    pub fn moving<'a>(&'a self, sequence: &'a CollapseSequence) -> impl Iterator<Item = MovingVertex> + 'a {
        self.moving.iter().flat_map(move |moving| {
            let factor = f32::from(moving.frame) / f32::from(self.frame_count);
            sequence.step_vertices(moving.step as usize).map(move |vertex| {
                let target = self.drawn.vertex_shown_for(sequence, sequence.target(vertex));
                MovingVertex { vertex, target, factor }
            })
        })
    }

    /// Vertices that came to their own places in the last frame.
    ///
    /// # Panics
    /// If the sequence is another mesh's.
    pub fn settled<'a>(&'a self, sequence: &'a CollapseSequence) -> impl Iterator<Item = u32> + 'a {
        self.settled.iter().flat_map(|&step| sequence.step_vertices(step as usize))
    }

    /// Brings the places of all vertices up to date that moved in the last frame. `out` begins as a copy of the positions,
    /// and is brought up to date in every frame: then all that is drawn is where it should be.
    ///
    /// # Panics
    /// If the positions or `out` are not those of all vertices, or the sequence is another mesh's.
    pub fn positions_into(&self, sequence: &CollapseSequence, positions: &[[f32; 3]], out: &mut [[f32; 3]]) {
        let own = |vertex: usize, i: usize| positions[vertex][i];
        self.write(sequence, (Mix::Linear, 3), own, out.as_flattened_mut());
    }

    /// Does as [`positions_into`](Self::positions_into) for another layer, as floats: normals and tangents keep their
    /// length, joints and their weights are the nearer vertex's.
    ///
    /// # Panics
    /// If the layer or `out` are not those of all vertices, or the sequence is another mesh's.
    pub fn layer_into(&self, sequence: &CollapseSequence, layer: &AttributeLayer, out: &mut [f32]) {
        let shape = (Mix::of(&layer.semantic), usize::from(layer.component_count));
        self.write(sequence, shape, |vertex, i| layer.get(vertex, i), out);
    }

    /// One frame of a step's way; none if it is then at its own place.
    fn move_step(&mut self, step: u32, known: Option<u16>, wanted: &FanInstance) -> Option<MovingStep> {
        if !wanted.is_refined(step) {
            let frame = known.unwrap_or(self.frame_count).saturating_sub(1);
            return Some(MovingStep { step, frame });
        }
        self.drawn.taken.remove(step);
        let frame = known.unwrap_or(0) + 1;
        if frame < self.frame_count {
            return Some(MovingStep { step, frame });
        }
        self.settled.push(step);
        None
    }

    /// Takes the steps that are at their targets. What they wait for is there, too: it was never wanted for longer, and all
    /// ways take the same time.
    fn take_arrived(&mut self, fans: &Fans) {
        let Self { drawn, moving, .. } = self;
        for &MovingStep { step, frame } in moving.iter().rev() {
            if frame > 0 {
                continue;
            }
            if cfg!(debug_assertions) {
                fans.for_each_needed_by_collapse(step, |finer| {
                    assert!(!drawn.is_refined(finer), "step {step} is taken before {finer}");
                });
            }
            drawn.taken.insert(step);
        }
        moving.retain(|moving| moving.frame > 0);
    }

    /// Writes a layer of `count` numbers a vertex where something moved.
    fn write(
        &self,
        sequence: &CollapseSequence,
        (mix, count): (Mix, usize),
        own: impl Fn(usize, usize) -> f32,
        out: &mut [f32],
    ) {
        for vertex in self.settled(sequence) {
            let slot = &mut out[vertex as usize * count..][..count];
            slot.iter_mut().enumerate().for_each(|(i, out)| *out = own(vertex as usize, i));
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
