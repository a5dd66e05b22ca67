//! Which vertices the corners around a new position show, and which groups its triangles are in.
//!
//! The triangles of the patch showed vertices of the position that splits; the new position has a vertex (wedge) for each
//! run of them, more where a seam begins. A wedge has one target, so where the old corners differ the new ones do. The
//! two new triangles nearly always go on with the wedges and the group beside them. All is asked as "is it the one that one
//! would expect?", which costs next to nothing away from seams.

use std::collections::HashMap;
use std::ops::Range;

use super::split::SplitWedges;
use crate::entropy::{AdaptiveBit, Coder, Rate, code_uniform};
use crate::format::form::StreamVersion;
use crate::general::step::CodedStep;
use crate::refine::growth::Growth;
use crate::refine::source::Source;
use crate::topology::surface::{NONE, Surface, next, previous, triangle_of};
use crate::wedges::hidden::HiddenWedges;

/// Answers whether a guess is right: by who asks, whether both guesses agree, and which it is.
const GUESSES: usize = ASKED * 2 * 2;
/// What the guesses of a corner before it came to, see [`outcome`].
const OUTCOMES: usize = 4;
/// Classes of how many vertices of a position are hidden: none, one, more.
const HIDDEN: usize = 3;
/// Places in a list that have probabilities of their own.
const PLACES: usize = 6;
/// Wedges of the new position that are offered one by one in version 2.
const MOST_OFFERED: usize = 16;

/// Models of wedges and groups. Version 1 uses the first contexts of each kind only.
#[derive(Clone, Debug)]
pub(crate) struct WedgeModel {
    version: StreamVersion,
    vertex_count: u32,
    /// Whether a corner of the patch shows what the one before does: where that is so at the ring, and where not; by what
    /// came of that at the corner before.
    goes_on: [AdaptiveBit; 2 * 3],
    /// Whether it shows another wedge that is there, by place in the list.
    is_other: [AdaptiveBit; PLACES],
    /// Whether it shows one that is too far down that list.
    is_older: AdaptiveBit,
    /// Whether A's and B's show what the patch beside them does, by what the end of the ring shows, and whether the kept
    /// position's vertex is shown elsewhere.
    joins_patch: [AdaptiveBit; OUTCOMES * 2],
    /// Whether a guess is right, also by whether other corners show it.
    is_guess: [AdaptiveBit; GUESSES * OUTCOMES * HIDDEN * 2],
    /// Whether a hidden vertex is meant, and which.
    is_hidden: [AdaptiveBit; ASKED * HIDDEN],
    is_this: [AdaptiveBit; ASKED * PLACES],
    /// Whether there are wedges that no corner shows, by how many are shown, whether each corner shows another one, how many
    /// have come, and how many of the kept position are hidden.
    has_more: [AdaptiveBit; 8 * 2 * 4 * HIDDEN],
    hidden: HiddenWedges,
    /// The wedge of each vertex that a writer has named at this position.
    wedge_of: HashMap<u32, u32>,
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

impl Asked {
    /// True if not a vertex is asked for, but a group of triangles.
    fn is_group(self) -> bool {
        matches!(self, Self::Group | Self::BaseGroup)
    }
}

/// How many kinds of [`Asked`] there are.
const ASKED: usize = Asked::BaseGroup as usize + 1;

/// What is known at a split.
pub(crate) struct Split<'a, S> {
    pub(crate) surface: &'a Surface,
    pub(crate) growth: &'a Growth,
    /// Corners at the new position, A's first and B's last.
    pub(crate) corners: &'a [u32],
    pub(crate) source: &'a S,
    /// Vertices beyond the first that the position may have: what a reader's bytes can tell.
    pub(crate) most_beyond: u64,
}

impl<S: Source> Split<'_, S> {
    /// What a writer's corner shows, of the mesh that is given; nothing that counts for a reader.
    fn wedge(&self, corner: u32) -> u32 {
        self.source.plan().map_or(0, |plan| plan.wedge(corner))
    }

    /// The same, of the stream.
    fn vertex_at(&self, corner: u32) -> u32 {
        self.source.plan().map_or(0, |plan| plan.vertex_at(corner))
    }

    /// The group of a writer's triangle at a corner.
    fn group(&self, corner: u32) -> u32 {
        self.source.plan().map_or(0, |plan| plan.group(triangle_of(corner)))
    }
}

impl WedgeModel {
    /// Nothing learned; `vertex_count` is that of the full mesh.
    pub(crate) fn new(vertex_count: u32, version: StreamVersion) -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            version,
            vertex_count,
            goes_on: [bit; 2 * 3],
            is_other: [bit; PLACES],
            is_older: bit,
            joins_patch: [bit; OUTCOMES * 2],
            is_guess: [bit; GUESSES * OUTCOMES * HIDDEN * 2],
            is_hidden: [bit; ASKED * HIDDEN],
            is_this: [bit; ASKED * PLACES],
            has_more: [bit; 8 * 2 * 4 * HIDDEN],
            hidden: HiddenWedges::default(),
            wedge_of: HashMap::new(),
        }
    }

    fn is_first_version(&self) -> bool {
        self.version == StreamVersion::One
    }

    /// Vertices of a range that no corner shows yet, nearest to a vertex first.
    pub(crate) fn hidden(&mut self, all: &Range<u32>, near: u32) -> &[u32] {
        self.hidden.find(all, near)
    }

    /// Notes what corners show after a general step, which `growth` does not have yet.
    pub(crate) fn follow_general(&mut self, growth: &Growth, step: &CodedStep) {
        let first = growth.vertex_count();
        for &corner in &step.fan {
            self.hidden.hide(growth.triangles[corner as usize / 3][corner as usize % 3]);
        }
        step.wedges.iter().for_each(|wedge| self.hidden.show(first + wedge));
        step.others.as_flattened().iter().for_each(|&vertex| self.hidden.show(vertex));
    }

    /// Codes which number of a range is meant: one of the guesses, or any. `outcome` is that of a corner before, and does
    /// not count in version 1.
    fn choose<C: Coder>(
        &mut self,
        coder: &mut C,
        (asked, outcome): (Asked, usize),
        (guesses, all): ([Option<u32>; 2], Range<u32>),
        meant: u32,
    ) -> u32 {
        if all.len() == 1 {
            return all.start;
        }
        let class = self.find_hidden(asked, &guesses, &all);
        let outcome = if self.is_first_version() { 0 } else { outcome };
        let key = (asked as usize * 2 + usize::from(guesses[0] == guesses[1])) * 2;
        let key = key + GUESSES * (outcome * HIDDEN + class);
        let knows_corners = !self.is_first_version() && !asked.is_group();
        let mut tried = NONE;
        for (place, guess) in guesses.into_iter().enumerate() {
            let Some(guess) = guess.filter(|guess| all.contains(guess) && *guess != tried) else { continue };
            let is_lone = knows_corners && self.hidden.is_lone(guess);
            let key = key + place + GUESSES * OUTCOMES * HIDDEN * usize::from(is_lone);
            if self.is_guess[key].code(coder, guess == meant) {
                return guess;
            }
            tried = guess;
        }
        if let Some(vertex) = self.choose_hidden(coder, (asked, class), &guesses, meant) {
            return vertex;
        }
        all.start + code_uniform(coder, all.len() as u32, meant.wrapping_sub(all.start))
    }

    /// Finds hidden vertices that may be meant, and gives the class of how many there are.
    fn find_hidden(&mut self, asked: Asked, guesses: &[Option<u32>; 2], all: &Range<u32>) -> usize {
        if self.is_first_version() || asked.is_group() {
            return 0;
        }
        let near = guesses.iter().flatten().next().copied().unwrap_or(all.start);
        self.hidden.find(all, near).len().min(HIDDEN - 1)
    }

    /// Codes whether a hidden vertex is meant that is no guess, and which.
    fn choose_hidden<C: Coder>(
        &mut self,
        coder: &mut C,
        (asked, class): (Asked, usize),
        guesses: &[Option<u32>; 2],
        meant: u32,
    ) -> Option<u32> {
        if class == 0 {
            return None;
        }
        let offered = self.hidden.found().iter().filter(|vertex| !guesses.contains(&Some(**vertex)));
        let last = *offered.clone().next_back()?;
        let is_meant = offered.clone().any(|vertex| *vertex == meant);
        if !self.is_hidden[asked as usize * HIDDEN + class].code(coder, is_meant) {
            return None;
        }
        for (place, &vertex) in offered.enumerate() {
            let bit = &mut self.is_this[asked as usize * PLACES + place.min(PLACES - 1)];
            if vertex == last || bit.code(coder, vertex == meant) {
                return Some(vertex);
            }
        }
        None
    }

    /// Codes what the corners around a new position show.
    pub(crate) fn code<C: Coder, S: Source>(
        &mut self,
        coder: &mut C,
        split: &Split<'_, S>,
        out: &mut SplitWedges,
    ) {
        let corners = split.corners;
        out.targets.clear();
        out.named.clear();
        out.wedges.clear();
        out.wedges.resize(corners.len(), NONE);
        self.wedge_of.clear();
        self.patch(coder, split, out);
        for side in 0..2 {
            self.side(coder, split, side, out);
        }
        self.unshown(coder, split, out);
        if !self.is_first_version() {
            self.count_corners(split, out);
        }
    }

    /// The wedges that no corner shows.
    fn unshown<C: Coder, S: Source>(&mut self, coder: &mut C, split: &Split<'_, S>, out: &mut SplitWedges) {
        let Split { surface, growth, corners, source, .. } = *split;
        let kept = growth.wedges(surface.vertex(next(corners[0])));
        let left = source.plan().map_or(0..0, |plan| plan.wedges(surface.vertex(corners[0])));
        let mut meant =
            left.filter(|wedge| !self.wedge_of.contains_key(wedge)).collect::<Vec<_>>().into_iter();
        let shown = out.targets.len();
        let corner_count = out.wedges.iter().filter(|wedge| **wedge != NONE).count();
        let shown_class = 2 * shown.min(7) + usize::from(shown == corner_count);
        let near = out.targets.last().copied();
        let class = if kept.len() > 1 { self.find_hidden(Asked::Target, &[near, None], &kept) } else { 0 };
        loop {
            let more = meant.next();
            let count = out.targets.len();
            // Where all vertices of the mesh are there, nothing is left to be asked.
            let is_full = growth.vertex_count() as usize + count >= self.vertex_count as usize;
            let is_full = is_full || count as u64 > split.most_beyond.saturating_add(1);
            let context = if self.is_first_version() {
                usize::from(count > 1)
            } else {
                (shown_class * 4 + (count - shown).min(3)) * HIDDEN + class
            };
            if count > 0 && (is_full || !self.has_more[context].code(coder, more.is_some())) {
                break;
            }
            let target = more.and_then(|wedge| Some(source.plan()?.target(wedge))).unwrap_or(NONE);
            let guesses = [out.targets.last().copied(), None];
            let target = self.choose(coder, (Asked::Target, 0), (guesses, kept.clone()), target);
            out.targets.push(target);
            out.named.push(more.unwrap_or(NONE));
        }
    }

    /// Counts corners as they will be when the split is part of the mesh.
    fn count_corners<S: Source>(&mut self, split: &Split<'_, S>, out: &SplitWedges) {
        let Split { surface, growth, corners, .. } = *split;
        let first = growth.vertex_count();
        for (at, (&corner, &wedge)) in corners.iter().zip(&out.wedges).enumerate() {
            if wedge == NONE {
                continue;
            }
            self.hidden.show(first + wedge);
            let side = usize::from(at > 0);
            if at == 0 || at + 1 == corners.len() {
                self.hidden.show(out.kept[side]);
                self.hidden.show(out.ends[side]);
            } else if let Some(old) = growth.shown(surface, corner) {
                self.hidden.hide(old);
            }
        }
    }

    /// The corners of the patch.
    fn patch<C: Coder, S: Source>(&mut self, coder: &mut C, split: &Split<'_, S>, out: &mut SplitWedges) {
        let Split { surface, growth, corners, .. } = *split;
        let mut before: Option<PatchCorner> = None;
        // What came of it at the corner before: not asked, another one, the same.
        let mut outcome = 0;
        for (at, &corner) in corners.iter().enumerate().take(corners.len() - 1).skip(1) {
            let Some(old) = growth.shown(surface, corner) else {
                before = None;
                continue;
            };
            let meant = split.wedge(corner);
            let ring = growth.shown(surface, next(corner)).unwrap_or(NONE);
            let wedge = match before {
                Some(PatchCorner { wedge, old: old_before, ring: ring_before }) if old_before == old => {
                    let earlier = if self.is_first_version() { 0 } else { outcome };
                    let context = usize::from(ring != ring_before) + 2 * earlier;
                    let goes_on = self.goes_on[context].code(coder, out.named[wedge as usize] == meant);
                    outcome = 1 + usize::from(goes_on);
                    if goes_on { wedge } else { self.other_wedge(coder, (meant, old), Some(wedge), out) }
                }
                _ => self.other_wedge(coder, (meant, old), None, out),
            };
            out.wedges[at] = wedge;
            let ring = growth.shown(surface, previous(corner)).unwrap_or(NONE);
            before = Some(PatchCorner { wedge, old, ring });
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
        let found = if self.is_first_version() {
            self.any_wedge(coder, (meant, target), besides, out)
        } else {
            self.late_wedge(coder, (meant, target), besides, out)
        };
        found.unwrap_or_else(|| {
            out.targets.push(target);
            out.named.push(meant);
            let wedge = out.targets.len() as u32 - 1;
            if !C::READS {
                self.wedge_of.insert(meant, wedge);
            }
            wedge
        })
    }

    /// Version 1 offers all wedges that fit.
    fn any_wedge<C: Coder>(
        &mut self,
        coder: &mut C,
        (meant, target): (u32, u32),
        besides: Option<u32>,
        out: &SplitWedges,
    ) -> Option<u32> {
        let wedges = (0..).zip(out.targets.iter().zip(&out.named));
        let mut fits = wedges.filter(|(wedge, (of, _))| **of == target && besides != Some(*wedge));
        fits.find(|(_, (_, name))| self.is_other[0].code(coder, **name == meant)).map(|(wedge, _)| wedge)
    }

    /// Version 2 offers the latest wedges that fit, and asks for the number of any other.
    fn late_wedge<C: Coder>(
        &mut self,
        coder: &mut C,
        (meant, target): (u32, u32),
        besides: Option<u32>,
        out: &SplitWedges,
    ) -> Option<u32> {
        let older_count = out.targets.len().saturating_sub(MOST_OFFERED);
        let mut place = 0;
        for wedge in (older_count..out.targets.len()).rev() {
            if out.targets[wedge] != target || besides == Some(wedge as u32) {
                continue;
            }
            if self.is_other[place].code(coder, out.named[wedge] == meant) {
                return Some(wedge as u32);
            }
            place = (place + 1).min(PLACES - 1);
        }
        if older_count == 0 {
            return None;
        }
        let older = self.wedge_of.get(&meant).copied().filter(|wedge| (*wedge as usize) < older_count);
        if !self.is_older.code(coder, older.is_some()) {
            return None;
        }
        let wedge = code_uniform(coder, older_count as u32, older.unwrap_or(0));
        // The triangle would not vanish in the coarser level if the wedge went elsewhere.
        (out.targets[wedge as usize] == target).then_some(wedge)
    }

    /// The corners of A (side 0) or B, and its group.
    fn side<C: Coder, S: Source>(
        &mut self,
        coder: &mut C,
        split: &Split<'_, S>,
        side: usize,
        out: &mut SplitWedges,
    ) {
        let Split { surface, growth, corners, .. } = *split;
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
        out.kept[side] = self.choose(coder, (Asked::KeptCorner, 0), offer, split.vertex_at(kept));
        let of_kept = outcome([guesses[1], guesses[0]], out.kept[side]);
        let guesses = [growth.shown(surface, end_inside), growth.shown(surface, end_across)];
        let offer = (guesses, growth.wedges(positions[2]));
        out.ends[side] = self.choose(coder, (Asked::RingCorner, of_kept), offer, split.vertex_at(end));
        let of_end = outcome(guesses, out.ends[side]);
        let new =
            New { of_end, meant: split.wedge(corner), beside: out.wedges[beside], kept: out.kept[side] };
        out.wedges[at] = self.new_corner(coder, new, out);
        let guesses = [across, inside].map(|c| growth.group(surface, triangle_of(c)));
        let offer = (guesses, 0..growth.group_count.max(1));
        out.groups[side] = self.choose(coder, (Asked::Group, of_end), offer, split.group(corner));
    }

    /// The wedge at the corner of A or B: that of the patch beside it, another one, or a new one. It collapses to what the
    /// kept position shows there, or the triangle would not vanish.
    fn new_corner<C: Coder>(&mut self, coder: &mut C, new: New, out: &mut SplitWedges) -> u32 {
        let New { of_end, meant, beside, kept } = new;
        if beside == NONE || out.targets[beside as usize] != kept {
            return self.other_wedge(coder, (meant, kept), None, out);
        }
        let is_beside = out.named[beside as usize] == meant;
        let is_lone = self.hidden.is_lone(kept);
        let context = if self.is_first_version() { 0 } else { 2 * of_end + usize::from(is_lone) };
        if self.joins_patch[context].code(coder, is_beside) {
            return beside;
        }
        self.other_wedge(coder, (meant, kept), Some(beside), out)
    }

    /// Codes what the corners of a base triangle show, and its group; `last` is what each position showed before.
    pub(crate) fn base_corner<C: Coder>(
        &mut self,
        coder: &mut C,
        (wedges, last): (Range<u32>, Option<u32>),
        meant: u32,
    ) -> u32 {
        let vertex = self.choose(coder, (Asked::BaseCorner, 0), ([last, None], wedges), meant);
        self.hidden.show(vertex);
        vertex
    }

    /// Codes the group of a base triangle.
    pub(crate) fn base_group<C: Coder>(
        &mut self,
        coder: &mut C,
        (group_count, last): (u32, Option<u32>),
        meant: u32,
    ) -> u32 {
        self.choose(coder, (Asked::BaseGroup, 0), ([last, None], 0..group_count.max(1)), meant)
    }
}

/// A corner of the patch.
struct PatchCorner {
    /// The wedge that it shows now.
    wedge: u32,
    /// What it showed before.
    old: u32,
    /// What the end of its triangle at the ring shows.
    ring: u32,
}

/// The corner of A or B at the new position.
#[derive(Clone, Copy)]
struct New {
    /// The outcome at the end of the ring.
    of_end: usize,
    meant: u32,
    /// The wedge of the patch beside it.
    beside: u32,
    /// What the kept position shows in the same triangle.
    kept: u32,
}

/// What two guesses came to, that of the patch first: both right, the patch's, the other one, none.
fn outcome(guesses: [Option<u32>; 2], vertex: u32) -> usize {
    match guesses.map(|guess| guess == Some(vertex)) {
        [true, true] => 0,
        [true, false] => 1,
        [false, true] => 2,
        _ => 3,
    }
}
