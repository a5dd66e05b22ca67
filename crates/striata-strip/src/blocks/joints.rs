//! Chains that a block lies beside, and where strips of the block may join them.
//!
//! A chain's last two triangles go into the window, linked with each other and with what lies ahead: a strip that
//! passes them begins with them, and knows by their turn how to go on without a swap. It joins the chain at
//! the side by which the chain had come to them, the **joint**.

use super::chain::{Chain, End, sides_of};
use super::hash::NumberMap;
use super::held::{HeldStrip, OpenEnd};
use super::window::Window;

/// A chain while its block is worked on.
#[derive(Debug)]
struct Part {
    chain: Chain,
    /// Ends that no block has reached yet.
    ends: [Option<OpenEnd>; 2],
    /// Sides of triangles in the window where the chain had come to them, as they run there.
    joints: [Option<(u32, u32)>; 2],
}

/// The chains of one window.
#[derive(Debug, Default)]
pub(super) struct Joints {
    parts: Vec<Option<Part>>,
    by_side: NumberMap<(u32, u32), (usize, End)>,
}

impl Joints {
    /// Adds a chain; its end triangles go into the window where the block lies beside them.
    pub(super) fn push(
        &mut self,
        mut chain: Chain,
        mut ends: [Option<OpenEnd>; 2],
        reached: &[Vec<(u32, u32)>; 2],
        window: &mut Window,
    ) {
        let mut joints = [None; 2];
        for end in End::BOTH.into_iter().filter(|&end| !reached[end as usize].is_empty()) {
            let Some(open_end) = ends[end as usize].take() else { continue };
            let beside =
                |[u, v]: [u32; 2]| reached[end as usize].iter().any(|&side| side == (u, v) || side == (v, u));
            let spare = chain.spare_corner(end, beside);
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
            self.by_side.extend(joint.map(|side| (side, (self.parts.len(), end))));
        }
        self.parts.push(Some(Part { chain, ends, joints }));
    }

    /// The sides at which strips of the window may join a chain.
    pub(super) fn sides(&self) -> impl Iterator<Item = &(u32, u32)> {
        self.parts.iter().flatten().flat_map(|part| part.joints.iter().flatten())
    }

    /// Goes on with a chain by this strip, and with another at the strip's other end; false where none fits.
    pub(super) fn join(&mut self, strip: &[u32], window: &Window) -> bool {
        if self.by_side.is_empty() {
            return false;
        }
        let mut strip = Chain::new(strip);
        for strip_end in End::BOTH {
            for side in sides_of(strip.end_triangle(strip_end)) {
                let Some(&(index, end)) = self.by_side.get(&side) else { continue };
                let Some(part) = &mut self.parts[index] else { continue };
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

    /// Goes on from the end of a part that a strip was just added to.
    fn join_next(&mut self, index: usize, end: End, window: &Window) {
        let Some(mut part) = self.parts[index].take() else { return };
        let corners = part.chain.end_triangle(end);
        part.ends[end as usize] =
            window.open_sides_in_mesh(corners).map(|(triangle, open)| OpenEnd { triangle, open });
        for side in sides_of(corners) {
            let Some(&(next_index, next_end)) = self.by_side.get(&side) else { continue };
            // The part's own other end is not there: a strip is no loop.
            let Some(mut next) = self.parts[next_index].take() else { continue };
            if let Some(unchanged) = part.chain.join(end, next.chain, next_end, [side.0, side.1]) {
                next.chain = unchanged;
                self.parts[next_index] = Some(next);
                continue;
            }
            self.by_side.remove(&side);
            let far = next_end.other() as usize;
            part.ends[end as usize] = next.ends[far].take();
            part.joints[end as usize] = next.joints[far];
            self.by_side.extend(next.joints[far].map(|side| (side, (index, end))));
            break;
        }
        self.parts[index] = Some(part);
    }

    /// Takes all chains out, in the order in which they came.
    pub(super) fn take_all(&mut self) -> Vec<HeldStrip> {
        self.by_side.clear();
        let parts = self.parts.drain(..).flatten();
        parts.map(|Part { chain, ends, .. }| HeldStrip::Chain { chain, ends }).collect()
    }
}
