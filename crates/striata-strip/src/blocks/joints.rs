//! Chains adjacent to a block, and the sides at which strips of the block may join them.
//!
//! The last two triangles of a chain enter the window, linked with each other and with the triangles ahead.
//! A strip that passes them begins with them, and their turn decides how it continues without a swap. It
//! joins the chain at the **joint**, the side across which the chain had entered them.

use super::chain::{BlockChain, ChainEnd, sides_of};
use super::integer_map::IntegerMap;
use super::pending::{OpenEnd, PendingStrip};
use super::window::Window;

/// A chain while its block is being processed.
#[derive(Debug)]
struct OpenChain {
    chain: BlockChain,
    /// Ends that no block has reached yet.
    ends: [Option<OpenEnd>; 2],
    /// For each end, the directed side of a window triangle across which the chain had entered it.
    joints: [Option<(u32, u32)>; 2],
}

/// Chains of one window.
#[derive(Debug, Default)]
pub(super) struct Joints {
    chains: Vec<Option<OpenChain>>,
    by_side: IntegerMap<(u32, u32), (usize, ChainEnd)>,
}

impl Joints {
    /// Adds a chain; its end triangles enter the window at the ends that the block touches.
    pub(super) fn push(
        &mut self,
        mut chain: BlockChain,
        mut ends: [Option<OpenEnd>; 2],
        reached: &[Vec<(u32, u32)>; 2],
        window: &mut Window,
    ) {
        let mut joints = [None; 2];
        for end in ChainEnd::BOTH.into_iter().filter(|&end| !reached[end as usize].is_empty()) {
            let Some(open_end) = ends[end as usize].take() else { continue };
            let is_touched =
                |[u, v]: [u32; 2]| reached[end as usize].iter().any(|&side| side == (u, v) || side == (v, u));
            let spare = chain.spare_corner(end, is_touched);
            let Some(edge) = chain.take_end(end) else { continue };
            let before = chain.end_triangle(end);
            let edge_before = chain.take_end(end);
            window.push_end(&open_end.triangle, spare, edge_before.map(|_| before));
            let (edge, sides) = match edge_before {
                Some(edge) => (edge, sides_of(before)),
                None => (edge, sides_of(open_end.triangle.corners)),
            };
            let joint = sides.into_iter().find(|&(a, b)| edge.contains(&a) && edge.contains(&b));
            joints[end as usize] = joint;
            self.by_side.extend(joint.map(|side| (side, (self.chains.len(), end))));
        }
        self.chains.push(Some(OpenChain { chain, ends, joints }));
    }

    /// Iterates over the sides at which strips of the window may join a chain.
    pub(super) fn sides(&self) -> impl Iterator<Item = &(u32, u32)> {
        self.chains.iter().flatten().flat_map(|part| part.joints.iter().flatten())
    }

    /// Continues a chain with this strip, and with another chain at the strip's other end; false if none
    /// fits.
    pub(super) fn join(&mut self, strip: &[u32], window: &Window) -> bool {
        if self.by_side.is_empty() {
            return false;
        }
        let mut strip = BlockChain::new(strip);
        for strip_end in ChainEnd::BOTH {
            for side in sides_of(strip.end_triangle(strip_end)) {
                let Some(&(index, end)) = self.by_side.get(&side) else { continue };
                let Some(part) = &mut self.chains[index] else { continue };
                match part.chain.join(end, strip, strip_end, [side.0, side.1]) {
                    Some(unchanged) => strip = unchanged,
                    None => {
                        part.joints[end as usize] = None;
                        self.by_side.remove(&side);
                        self.join_next(index, end, window);
                        return true;
                    }
                }
            }
        }
        false
    }

    /// Continues from the end of a chain that a strip was just added to.
    fn join_next(&mut self, index: usize, end: ChainEnd, window: &Window) {
        let Some(mut part) = self.chains[index].take() else { return };
        let corners = part.chain.end_triangle(end);
        part.ends[end as usize] =
            window.open_sides_in_mesh(corners).map(|(triangle, open)| OpenEnd { triangle, open });
        for side in sides_of(corners) {
            let Some(&(next_index, next_end)) = self.by_side.get(&side) else { continue };
            // The chain's own other end is not in the list: a strip is not a loop.
            let Some(mut next) = self.chains[next_index].take() else { continue };
            if let Some(unchanged) = part.chain.join(end, next.chain, next_end, [side.0, side.1]) {
                next.chain = unchanged;
                self.chains[next_index] = Some(next);
                continue;
            }
            self.by_side.remove(&side);
            let far = next_end.other() as usize;
            part.ends[end as usize] = next.ends[far].take();
            part.joints[end as usize] = next.joints[far];
            self.by_side.extend(next.joints[far].map(|side| (side, (index, end))));
            break;
        }
        self.chains[index] = Some(part);
    }

    /// Removes and returns all chains, in order of arrival.
    pub(super) fn take_all(&mut self) -> Vec<PendingStrip> {
        self.by_side.clear();
        let chains = self.chains.drain(..).flatten();
        chains.map(|OpenChain { chain, ends, .. }| PendingStrip::Chain { chain, ends }).collect()
    }
}
