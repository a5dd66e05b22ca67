//! Who is around a vertex, what has become of them, and where they are.

use super::memory::Memory;
use super::ring::{Ring, Spoke, mean};
use super::scene::Scene;
use crate::refine::walk::Fate;
use crate::topology::surface::{next, triangle_of};

impl Ring {
    /// Looks who is around a vertex, and where: all that has to be waited for, in one go.
    pub(super) fn gather(&mut self, scene: &Scene<'_>, memory: &Memory, (vertex, corners): (u32, &[u32])) {
        let here = scene.places[vertex as usize];
        self.reach = 0;
        self.spokes.clear();
        self.fates = [0; 4];
        self.young = 0;
        self.free = 0;
        let mut density = 0;
        for &corner in corners {
            let vertex = scene.surface.vertex(next(corner));
            let is_taken = scene.is_taken(triangle_of(corner));
            self.free += usize::from(!is_taken);
            let mut spoke = Spoke { vertex, is_taken, ..Spoke::default() };
            if scene.surface.is_virtual(vertex) {
                (spoke.is_virtual, spoke.fate, spoke.age, spoke.valence) = (true, 1, 3, 9);
            } else {
                let fate = scene.walk.fate(vertex);
                let trace = memory.trace(vertex);
                spoke.fate = match fate {
                    Fate::Open => 0,
                    Fate::Stays => 1,
                    Fate::Splits => 2,
                    Fate::New => 3,
                };
                spoke.age = memory.age(vertex);
                spoke.valence = trace.valence;
                // Vertices made in this stretch have no place yet, and are not met.
                let place = scene.places.get(vertex as usize).copied().unwrap_or(here);
                spoke.step = std::array::from_fn(|a| place[a].wrapping_sub(here[a]));
                self.reach |= spoke.step.iter().fold(0, |m, s| m | s.unsigned_abs());
                self.fates[usize::from(spoke.fate & 3)] += 1;
                self.young += usize::from(spoke.age == 1);
                if matches!(fate, Fate::Stays | Fate::Splits) {
                    density += i64::from(trace.density);
                }
            }
            self.spokes.push(spoke);
        }
        let asked = self.fates[1] + self.fates[2];
        self.density = if asked == 0 { memory.share() } else { mean(density, asked) };
        self.free_run = self.longest_free_run();
    }

    fn longest_free_run(&self) -> usize {
        if self.free == self.spokes.len() {
            return self.free;
        }
        let (mut longest, mut run, mut first) = (0, 0, None);
        for spoke in &self.spokes {
            if spoke.is_taken {
                longest = longest.max(run);
                first = first.or(Some(run));
                run = 0;
            } else {
                run += 1;
            }
        }
        // The last run goes on in the first.
        longest.max(run + first.unwrap_or(0))
    }
}
