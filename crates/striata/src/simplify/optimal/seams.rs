//! Wedges across an edge whose both ends may go: who merges with whom.

use glam::DVec3;

use crate::mesh::Welded;

use super::super::links::Links;
use super::super::star::Star;
use super::super::wedges::Wedges;

/// The wedges of a mesh that has some, and the stars that they are read from.
#[derive(Debug)]
pub(super) struct Seams<'a> {
    pub(super) wedges: Wedges<'a>,
    star: Star,
    /// Positions as stars want them.
    positions: Vec<[f32; 4]>,
}

fn padded(p: DVec3) -> [f32; 4] {
    [p.x as f32, p.y as f32, p.z as f32, 0.0]
}

impl<'a> Seams<'a> {
    pub(super) fn new(welded: &'a Welded, positions: &[DVec3]) -> Self {
        Self {
            wedges: Wedges::new(&welded.positions, welded.mesh.triangles.clone()),
            star: Star::default(),
            positions: positions.iter().copied().map(padded).collect(),
        }
    }

    /// True where every wedge of `removed` has a partner at `kept`, and, if both move, the other way round too.
    pub(super) fn allow(&mut self, links: &Links, (removed, kept): (u32, u32), both_move: bool) -> bool {
        if !self.wedges.is_split(removed) && !self.wedges.is_split(kept) {
            return true;
        }
        self.pair(links, removed, kept) && (!both_move || self.pair(links, kept, removed))
    }

    fn pair(&mut self, links: &Links, removed: u32, kept: u32) -> bool {
        self.star.gather(links, &self.positions, removed);
        let k = self.star.ids.iter().position(|&id| id == kept);
        k.is_some_and(|k| self.wedges.pair(&self.star, removed, k))
    }

    /// Finds the partners of the wedges of `removed` that triangles show, as pairs (removed, kept), and
    /// makes the triangles show the kept ones; `targets` gets the partners of all.
    pub(super) fn merge(
        &mut self,
        links: &Links,
        (removed, kept): (u32, u32),
        targets: &mut [u32],
        pairs: &mut Vec<(u32, u32)>,
    ) {
        self.pair(links, removed, kept);
        for &t in &self.star.triangles[..self.star.triangle_count()] {
            let shown = self.wedges.shown(t, removed);
            if pairs.iter().all(|&(from, _)| from != shown) {
                pairs.push((shown, shown));
            }
        }
        self.wedges.write_targets(removed, kept, targets);
        self.wedges.substitute(&self.star, removed, targets);
        for (from, to) in pairs {
            *to = targets[*from as usize];
        }
    }

    pub(super) fn place(&mut self, position: u32, at: DVec3) {
        self.positions[position as usize] = padded(at);
    }
}
