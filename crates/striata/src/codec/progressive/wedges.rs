//! Which vertices the corners around a new position show, and which groups its triangles are in.
//!
//! The triangles of the patch showed vertices of the position that splits; the new position has a vertex (wedge) for each
//! run of them, more where a seam begins. A wedge has one target, so where the old corners differ the new ones do. The
//! two new triangles nearly always go on with the wedges and the group beside them. All is asked as "is it the one that one
//! would expect?", which costs next to nothing away from seams.

use std::ops::Range;

use super::super::entropy::{AdaptiveBit, Coder, Rate, code_uniform};
use super::growth::Growth;
use super::refiner::Source;
use super::surface::{NONE, Surface, next, previous, triangle_of};

/// Models of wedges and groups.
#[derive(Clone, Debug)]
pub(super) struct WedgeModel {
    vertex_count: u32,
    /// Whether a corner of the patch shows what the one before does: where that is so at the ring, and where not; whether
    /// it shows another wedge that is there; and whether A's and B's show what the patch beside them does.
    goes_on: [AdaptiveBit; 4],
    /// Whether a guess is right, by who asks, whether both guesses agree, and which it is.
    is_meant: [AdaptiveBit; 24],
    has_more: [AdaptiveBit; 2],
}

/// What a corner is asked for.
#[derive(Clone, Copy)]
enum Asked {
    KeptCorner,
    RingCorner,
    Target,
    Group,
    BaseCorner,
    BaseGroup,
}

/// What the corners around a new position show.
#[derive(Clone, Debug, Default)]
pub(super) struct SplitWedges {
    /// The vertex that each wedge of the new position collapses to.
    pub(super) targets: Vec<u32>,
    /// The wedge of each corner at the new position, in the order of the corners; none in virtual triangles.
    pub(super) wedges: Vec<u32>,
    /// What A's and B's corners at the kept position show.
    pub(super) kept: [u32; 2],
    /// What their corners at the ends of the ring show.
    pub(super) ends: [u32; 2],
    /// Groups of A and B.
    pub(super) groups: [u32; 2],
    /// What a writer calls the wedges.
    pub(super) named: Vec<u32>,
}

/// What is known at a split.
pub(super) struct Split<'a, S> {
    pub(super) surface: &'a Surface,
    pub(super) growth: &'a Growth,
    /// Corners at the new position, A's first and B's last.
    pub(super) corners: &'a [u32],
    pub(super) source: &'a S,
    /// Vertices beyond the first that the position may have: what a reader's bytes can tell.
    pub(super) most_beyond: u64,
}

impl WedgeModel {
    /// Nothing learned; `vertex_count` is that of the full mesh.
    pub(super) fn new(vertex_count: u32) -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self { vertex_count, goes_on: [bit; 4], is_meant: [bit; 24], has_more: [bit; 2] }
    }

    /// Codes which number of a range is meant: one of the guesses, or any.
    fn choose<C: Coder>(
        &mut self,
        coder: &mut C,
        asked: Asked,
        (guesses, all): ([Option<u32>; 2], Range<u32>),
        meant: u32,
    ) -> u32 {
        if all.len() == 1 {
            return all.start;
        }
        let key = (asked as usize * 2 + usize::from(guesses[0] == guesses[1])) * 2;
        let mut tried = NONE;
        for (place, guess) in guesses.into_iter().enumerate() {
            let Some(guess) = guess.filter(|guess| all.contains(guess) && *guess != tried) else { continue };
            if self.is_meant[key + place].code(coder, guess == meant) {
                return guess;
            }
            tried = guess;
        }
        all.start + code_uniform(coder, all.len() as u32, meant.wrapping_sub(all.start))
    }

    /// Codes what the corners around a new position show.
    pub(super) fn code<C: Coder, S: Source>(
        &mut self,
        coder: &mut C,
        split: &Split<'_, S>,
        out: &mut SplitWedges,
    ) {
        let Split { surface, growth, corners, source, .. } = *split;
        out.targets.clear();
        out.named.clear();
        out.wedges.clear();
        out.wedges.resize(corners.len(), NONE);
        self.patch(coder, split, out);
        for side in 0..2 {
            self.side(coder, split, side, out);
        }
        let kept = growth.wedges(surface.vertex(next(corners[0])));
        let vertex = surface.vertex(corners[0]);
        let left = source.wedges(vertex).filter(|wedge| !out.named.contains(wedge));
        let mut meant = left.collect::<Vec<_>>().into_iter();
        loop {
            let more = meant.next();
            let count = out.targets.len();
            // Where all vertices of the mesh are there, nothing is left to be asked.
            let is_full = growth.vertex_count() as usize + count >= self.vertex_count as usize;
            let is_full = is_full || count as u64 > split.most_beyond.saturating_add(1);
            if count > 0 && (is_full || !self.has_more[usize::from(count > 1)].code(coder, more.is_some())) {
                break;
            }
            let target = more.map_or(NONE, |wedge| source.target(wedge));
            let guesses = [out.targets.last().copied(), None];
            out.targets.push(self.choose(coder, Asked::Target, (guesses, kept.clone()), target));
            out.named.push(more.unwrap_or(NONE));
        }
    }

    /// The corners of the patch.
    fn patch<C: Coder, S: Source>(&mut self, coder: &mut C, split: &Split<'_, S>, out: &mut SplitWedges) {
        let Split { surface, growth, corners, source, .. } = *split;
        let mut before: Option<(u32, u32, u32)> = None;
        for (at, &corner) in corners.iter().enumerate().take(corners.len() - 1).skip(1) {
            let Some(old) = growth.shown(surface, corner) else {
                before = None;
                continue;
            };
            let meant = source.wedge(corner);
            let ring = growth.shown(surface, next(corner)).unwrap_or(NONE);
            let wedge = match before {
                Some((wedge, old_before, ring_before)) if old_before == old => {
                    let context = usize::from(ring != ring_before);
                    if self.goes_on[context].code(coder, out.named[wedge as usize] == meant) {
                        wedge
                    } else {
                        self.other_wedge(coder, (meant, old), Some(wedge), out)
                    }
                }
                _ => self.other_wedge(coder, (meant, old), None, out),
            };
            out.wedges[at] = wedge;
            before = Some((wedge, old, growth.shown(surface, previous(corner)).unwrap_or(NONE)));
        }
    }

    /// A wedge of the given target that is there already, or a new one.
    fn other_wedge<C: Coder>(
        &mut self,
        coder: &mut C,
        (meant, target): (u32, u32),
        besides: Option<u32>,
        out: &mut SplitWedges,
    ) -> u32 {
        for (wedge, (&its_target, &name)) in (0..).zip(out.targets.iter().zip(&out.named)) {
            let is_candidate = its_target == target && besides != Some(wedge);
            if is_candidate && self.goes_on[2].code(coder, name == meant) {
                return wedge;
            }
        }
        out.targets.push(target);
        out.named.push(meant);
        out.targets.len() as u32 - 1
    }

    /// The corners of A (side 0) or B, and its group.
    fn side<C: Coder, S: Source>(
        &mut self,
        coder: &mut C,
        split: &Split<'_, S>,
        side: usize,
        out: &mut SplitWedges,
    ) {
        let Split { surface, growth, corners, source, .. } = *split;
        let (at, beside) = if side == 0 { (0, 1) } else { (corners.len() - 1, corners.len() - 2) };
        let corner = corners[at];
        let (kept, end) =
            if side == 0 { (next(corner), previous(corner)) } else { (previous(corner), next(corner)) };
        let positions = [corner, kept, end].map(|c| surface.vertex(c));
        if positions.iter().any(|&v| surface.is_virtual(v)) {
            return;
        }
        // Across the edge between kept position and end of the ring; and the triangle of the patch next to it.
        let across = surface.opposite(corner);
        let (kept_across, end_across) =
            if side == 0 { (previous(across), next(across)) } else { (next(across), previous(across)) };
        let inside = corners[beside];
        let end_inside = if side == 0 { next(inside) } else { previous(inside) };
        // The corner of the patch still shows the kept position.
        let guesses = [growth.shown(surface, kept_across), growth.shown(surface, inside)];
        let offer = (guesses, growth.wedges(positions[1]));
        out.kept[side] = self.choose(coder, Asked::KeptCorner, offer, source.vertex_at(kept));
        let guesses = [growth.shown(surface, end_inside), growth.shown(surface, end_across)];
        let offer = (guesses, growth.wedges(positions[2]));
        out.ends[side] = self.choose(coder, Asked::RingCorner, offer, source.vertex_at(end));
        let new = New { meant: source.wedge(corner), beside: out.wedges[beside], kept: out.kept[side] };
        out.wedges[at] = self.new_corner(coder, new, out);
        let guesses = [across, inside].map(|c| growth.group(surface, triangle_of(c)));
        let offer = (guesses, 0..growth.group_count.max(1));
        out.groups[side] = self.choose(coder, Asked::Group, offer, source.group(triangle_of(corner)));
    }

    /// The wedge at the corner of A or B: that of the patch beside it, another one, or a new one. It collapses to what the
    /// kept position shows there, or the triangle would not vanish.
    fn new_corner<C: Coder>(&mut self, coder: &mut C, new: New, out: &mut SplitWedges) -> u32 {
        let New { meant, beside, kept } = new;
        if beside == NONE || out.targets[beside as usize] != kept {
            return self.other_wedge(coder, (meant, kept), None, out);
        }
        let is_beside = out.named[beside as usize] == meant;
        if self.goes_on[3].code(coder, is_beside) {
            return beside;
        }
        self.other_wedge(coder, (meant, kept), Some(beside), out)
    }

    /// Codes what the corners of a base triangle show, and its group; `last` is what each position showed before.
    pub(super) fn base_corner<C: Coder>(
        &mut self,
        coder: &mut C,
        (wedges, last): (Range<u32>, Option<u32>),
        meant: u32,
    ) -> u32 {
        self.choose(coder, Asked::BaseCorner, ([last, None], wedges), meant)
    }

    /// Codes the group of a base triangle.
    pub(super) fn base_group<C: Coder>(
        &mut self,
        coder: &mut C,
        (group_count, last): (u32, Option<u32>),
        meant: u32,
    ) -> u32 {
        self.choose(coder, Asked::BaseGroup, ([last, None], 0..group_count.max(1)), meant)
    }
}

/// The corner of A or B at the new position.
#[derive(Clone, Copy)]
struct New {
    meant: u32,
    /// The wedge of the patch beside it.
    beside: u32,
    /// What the kept position shows in the same triangle.
    kept: u32,
}
