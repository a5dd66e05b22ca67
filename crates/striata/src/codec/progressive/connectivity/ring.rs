//! What is seen around a vertex that may split: lengths, angles, areas and bends, as small numbers.

use super::super::super::entropy::log2_q8;
use super::super::surface::{next, triangle_of};
use super::super::walk::Fate;
use super::Scene;
use super::memory::Memory;

/// An edge from the vertex, and the triangle behind it, counter-clockwise.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Spoke {
    /// The other end.
    pub(super) vertex: u32,
    /// The other end stands for a boundary loop.
    pub(super) is_virtual: bool,
    /// The triangle cannot go to a new vertex any more.
    pub(super) is_taken: bool,
    /// To the other end, in units of the ring.
    pub(super) step: [i32; 3],
    /// Twice the area of the triangle as a vector.
    pub(super) normal: [i64; 3],
    /// Logarithm to base 2 of the squared length, in 1/256.
    pub(super) length: i32,
    /// Of the squared area.
    pub(super) area: i32,
    /// Of the squared height of the other end of the next edge over the triangle before this edge.
    pub(super) height: i32,
    /// Of the squared tangent of the triangle's angle.
    pub(super) tangent: i32,
    /// The angle is over 90 degrees.
    pub(super) is_blunt: bool,
    /// What became of the other end.
    pub(super) fate: usize,
    /// Its age.
    pub(super) age: usize,
    /// Its valence.
    pub(super) valence: usize,
}

/// A vertex and what is around it.
#[derive(Clone, Debug, Default)]
pub(super) struct Ring {
    pub(super) spokes: Vec<Spoke>,
    /// Means over what is not virtual, as the logarithms of [`Spoke`].
    pub(super) length: i32,
    pub(super) area: i32,
    /// The logarithm of the mean squared height.
    pub(super) height: i32,
    /// Bits by which steps were shifted down.
    pub(super) shift: i32,
    pub(super) free: usize,
    pub(super) free_run: usize,
}

/// The logarithm to base 2 in 1/256.
#[inline]
pub(super) fn log2_wide(number: u64) -> i32 {
    let spare = (64 - number.leading_zeros()).saturating_sub(32);
    log2_q8((number >> spare) as u32) + ((spare as i32) << 8)
}

#[inline]
pub(super) fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
fn cross(a: [i32; 3], b: [i32; 3]) -> [i64; 3] {
    let [a, b] = [a, b].map(|v| v.map(i64::from));
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
fn square(v: [i64; 3]) -> u64 {
    dot(v, v) as u64
}

impl Ring {
    /// Looks around a vertex.
    pub(super) fn survey(&mut self, scene: &Scene<'_>, memory: &Memory, corners: &[u32]) {
        let surface = scene.surface;
        let here = scene.places[surface.vertex(corners[0]) as usize];
        self.spokes.clear();
        let mut reach = 0;
        for &corner in corners {
            let vertex = surface.vertex(next(corner));
            let is_virtual = surface.is_virtual(vertex);
            let step = match scene.places.get(vertex as usize) {
                Some(place) if !is_virtual => std::array::from_fn(|a| place[a].wrapping_sub(here[a])),
                _ => [0; 3],
            };
            reach |= step.iter().fold(0, |m, s| m | s.unsigned_abs());
            self.spokes.push(Spoke {
                vertex,
                is_virtual,
                is_taken: scene.is_taken(triangle_of(corner)),
                step,
                fate: match scene.walk.fate(vertex) {
                    Fate::Open => 0,
                    Fate::Stays => 1,
                    Fate::Splits => 2,
                    Fate::New => 3,
                },
                age: memory.age(vertex),
                valence: memory.valence(vertex),
                ..Spoke::default()
            });
        }
        // Products of four steps must fit.
        self.shift = (18 - reach.leading_zeros() as i32).max(0);
        if self.shift > 0 {
            let shift = self.shift;
            self.spokes.iter_mut().for_each(|s| s.step = s.step.map(|x| x >> shift));
        }
        self.measure();
        self.count_free();
    }

    fn measure(&mut self) {
        let n = self.spokes.len();
        let (mut lengths, mut areas, mut real_edges, mut real_triangles) = (0, 0, 0, 0);
        for i in 0..n {
            let behind = self.spokes[if i + 1 < n { i + 1 } else { 0 }];
            let spoke = &mut self.spokes[i];
            if spoke.is_virtual {
                continue;
            }
            spoke.length = log2_wide(square(spoke.step.map(i64::from)));
            lengths += spoke.length;
            real_edges += 1;
            if behind.is_virtual {
                continue;
            }
            spoke.normal = cross(spoke.step, behind.step);
            spoke.area = log2_wide(square(spoke.normal));
            let cosine = dot(spoke.step.map(i64::from), behind.step.map(i64::from));
            spoke.tangent = spoke.area - 2 * log2_wide(cosine.unsigned_abs());
            spoke.is_blunt = cosine < 0;
            areas += spoke.area;
            real_triangles += 1;
        }
        self.length = lengths / real_edges.max(1);
        self.area = areas / real_triangles.max(1);
        let mut heights = 0;
        for i in 0..n {
            let before = self.spokes[if i > 0 { i - 1 } else { n - 1 }];
            let behind = self.spokes[if i + 1 < n { i + 1 } else { 0 }];
            let spoke = &mut self.spokes[i];
            if before.is_virtual || behind.is_virtual || spoke.is_virtual {
                continue;
            }
            let volume = dot(before.normal, behind.step.map(i64::from)).unsigned_abs();
            spoke.height = (2 * log2_wide(volume) - before.area + 512 * self.shift).max(-512);
            heights += spoke.height;
        }
        self.height = heights / real_edges.max(1);
    }

    fn count_free(&mut self) {
        self.free = self.spokes.iter().filter(|s| !s.is_taken).count();
        self.free_run = 0;
        if self.free == self.spokes.len() {
            self.free_run = self.free;
            return;
        }
        let mut run = 0;
        for spoke in self.spokes.iter().chain(&self.spokes) {
            run = if spoke.is_taken { 0 } else { run + 1 };
            self.free_run = self.free_run.max(run);
        }
    }
}
