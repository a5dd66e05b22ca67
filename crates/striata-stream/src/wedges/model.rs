//! Codes which vertices the corners around a new position refer to, and the groups of its triangles.
//!
//! The triangles of the patch referred to vertices of the position that splits. The new position has one
//! vertex (wedge) for each run of them, and more if a seam begins. A wedge has only one target, so
//! corners that referred to different vertices also do so afterward. The two new triangles almost always
//! continue the wedges and the group next to them. Everything is coded as a flag for whether an expected
//! guess is right, which costs almost nothing away from seams.

use std::collections::HashMap;
use std::ops::Range;

use super::split::SplitWedges;
use crate::entropy::{AdaptiveBit, Coder, Rate, code_uniform};
use crate::general::step::CodedStep;
use crate::refine::growth::GrowingMesh;
use crate::refine::source::StreamSide;
use crate::topology::surface::{NONE, Surface, next, previous, triangle_of};
use crate::wedges::hidden::HiddenWedges;

/// Contexts for whether a guess is right: what is coded, whether both guesses agree, and which guess it is.
const GUESSES: usize = VALUE_KINDS * 2 * 2;
/// Number of outcomes of the guesses at the previous corner, see [`outcome`].
const OUTCOMES: usize = 4;
/// Classes for the number of hidden vertices of a position: none, one, more.
const HIDDEN: usize = 3;
/// Number of list positions that have their own probabilities.
const LIST_INDICES: usize = 6;
/// Maximum number of wedges of the new position that are offered one by one.
const MOST_OFFERED: usize = 16;

/// Models of wedges and groups.
#[derive(Clone, Debug)]
pub(crate) struct WedgeModel {
    /// Number of vertices in the full mesh.
    vertex_count: u32,
    /// Whether a corner of the patch refers to the same wedge as the previous one, by whether that holds
    /// at the ring and by the flag of the previous corner.
    continues: [AdaptiveBit; 2 * 3],
    /// Whether it refers to another existing wedge, by index in the list of candidates.
    is_other: [AdaptiveBit; LIST_INDICES],
    /// Whether it refers to a wedge beyond the end of that list.
    is_older: AdaptiveBit,
    /// Whether the corners of A and B refer to the same wedge as the patch next to them, by the outcome
    /// at the end of the ring and by whether other corners refer to the kept position's vertex.
    joins_patch: [AdaptiveBit; OUTCOMES * 2],
    /// Whether a guess is right, also by whether at most one corner refers to it.
    is_guess: [AdaptiveBit; GUESSES * OUTCOMES * HIDDEN * 2],
    /// Whether a hidden vertex is coded, and which.
    is_hidden: [AdaptiveBit; VALUE_KINDS * HIDDEN],
    is_candidate: [AdaptiveBit; VALUE_KINDS * LIST_INDICES],
    /// Whether more wedges without corners follow, by the number of wedges with corners, whether each corner
    /// has its own wedge, how many have followed, and how many vertices of the kept position are hidden.
    has_more: [AdaptiveBit; 8 * 2 * 4 * HIDDEN],
    /// Vertices that no corner refers to yet.
    hidden: HiddenWedges,
    /// In a writer, the wedge of each source vertex at this position.
    wedge_of: HashMap<u32, u32>,
}

/// The kind of value that is coded.
#[derive(Clone, Copy)]
enum ValueKind {
    KeptCorner,
    RingCorner,
    Target,
    Group,
    BaseCorner,
    BaseGroup,
}

impl ValueKind {
    /// Whether the value is a group of triangles rather than a vertex.
    fn is_group(self) -> bool {
        matches!(self, Self::Group | Self::BaseGroup)
    }
}

/// Number of kinds in [`ValueKind`].
const VALUE_KINDS: usize = ValueKind::BaseGroup as usize + 1;

/// Everything that is known about a split when its wedges are coded.
pub(crate) struct WedgeContext<'a, S> {
    pub surface: &'a Surface,
    pub growth: &'a GrowingMesh,
    /// Corners at the new position, starting with the one in A and ending with the one in B.
    pub corners: &'a [u32],
    pub source: &'a S,
    /// Maximum number of vertices of the position in excess of one, as limited by a reader's bytes.
    pub most_beyond: u64,
}

impl<S: StreamSide> WedgeContext<'_, S> {
    /// Returns the source mesh's vertex that a corner refers to; 0 in a reader, where it is ignored.
    fn wedge(&self, corner: u32) -> u32 {
        self.source.input().map_or(0, |input| input.wedge(corner))
    }

    /// Returns the stream's vertex that a corner refers to; 0 in a reader, where it is ignored.
    fn vertex_at(&self, corner: u32) -> u32 {
        self.source.input().map_or(0, |input| input.vertex_at(corner))
    }

    /// Returns the group of the triangle at a corner; 0 in a reader, where it is ignored.
    fn group(&self, corner: u32) -> u32 {
        self.source.input().map_or(0, |input| input.group(triangle_of(corner)))
    }
}

/// A wedge that is coded.
struct WedgeOfTarget {
    /// Its number in the mesh of the encoder.
    pub actual: u32,
    /// The vertex that it collapses to.
    pub target: u32,
}

impl WedgeModel {
    /// Creates an untrained model; `vertex_count` is that of the full mesh.
    pub(crate) fn new(vertex_count: u32) -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            vertex_count,
            continues: [bit; 2 * 3],
            is_other: [bit; LIST_INDICES],
            is_older: bit,
            joins_patch: [bit; OUTCOMES * 2],
            is_guess: [bit; GUESSES * OUTCOMES * HIDDEN * 2],
            is_hidden: [bit; VALUE_KINDS * HIDDEN],
            is_candidate: [bit; VALUE_KINDS * LIST_INDICES],
            has_more: [bit; 8 * 2 * 4 * HIDDEN],
            hidden: HiddenWedges::default(),
            wedge_of: HashMap::new(),
        }
    }

    /// Finds the vertices of a range that no corner refers to yet, those nearest to `near` first.
    pub(crate) fn hidden(&mut self, all: &Range<u32>, near: u32) -> &[u32] {
        self.hidden.find(all, near)
    }

    /// Updates the corner counts for a general step that `growth` does not include yet.
    pub(crate) fn follow_general(&mut self, growth: &GrowingMesh, step: &CodedStep) {
        let first = growth.vertex_count();
        for &corner in &step.fan {
            self.hidden.remove_corner(growth.triangles[corner as usize / 3][corner as usize % 3]);
        }
        step.wedges.iter().for_each(|wedge| self.hidden.add_corner(first + wedge));
        step.others.as_flattened().iter().for_each(|&vertex| self.hidden.add_corner(vertex));
    }

    /// Codes a value of a range: one of the guesses, or any other. `outcome` is that of the previous
    /// corner.
    fn choose<C: Coder>(
        &mut self,
        coder: &mut C,
        (kind, outcome): (ValueKind, usize),
        (guesses, all): ([Option<u32>; 2], Range<u32>),
        actual: u32,
    ) -> u32 {
        if all.len() == 1 {
            return all.start;
        }
        let class = self.find_hidden(kind, &guesses, &all);
        let key = (kind as usize * 2 + usize::from(guesses[0] == guesses[1])) * 2;
        let key = key + GUESSES * (outcome * HIDDEN + class);
        let mut tried = NONE;
        for (index, guess) in guesses.into_iter().enumerate() {
            let Some(guess) = guess.filter(|guess| all.contains(guess) && *guess != tried) else { continue };
            let has_one_corner_at_most = !kind.is_group() && self.hidden.has_one_corner_at_most(guess);
            let key = key + index + GUESSES * OUTCOMES * HIDDEN * usize::from(has_one_corner_at_most);
            if self.is_guess[key].code(coder, guess == actual) {
                return guess;
            }
            tried = guess;
        }
        if let Some(vertex) = self.choose_hidden(coder, (kind, class), &guesses, actual) {
            return vertex;
        }
        all.start + code_uniform(coder, all.len() as u32, actual.wrapping_sub(all.start))
    }

    /// Finds hidden vertices that may be the coded value, and returns the class of their number.
    fn find_hidden(&mut self, kind: ValueKind, guesses: &[Option<u32>; 2], all: &Range<u32>) -> usize {
        if kind.is_group() {
            return 0;
        }
        let near = guesses.iter().flatten().next().copied().unwrap_or(all.start);
        self.hidden.find(all, near).len().min(HIDDEN - 1)
    }

    /// Codes whether the value is a hidden vertex that is not among the guesses, and which.
    fn choose_hidden<C: Coder>(
        &mut self,
        coder: &mut C,
        (kind, class): (ValueKind, usize),
        guesses: &[Option<u32>; 2],
        actual: u32,
    ) -> Option<u32> {
        if class == 0 {
            return None;
        }
        let offered = self.hidden.found().iter().filter(|vertex| !guesses.contains(&Some(**vertex)));
        let last = *offered.clone().next_back()?;
        let is_offered = offered.clone().any(|vertex| *vertex == actual);
        if !self.is_hidden[kind as usize * HIDDEN + class].code(coder, is_offered) {
            return None;
        }
        for (index, &vertex) in offered.enumerate() {
            let bit = &mut self.is_candidate[kind as usize * LIST_INDICES + index.min(LIST_INDICES - 1)];
            if vertex == last || bit.code(coder, vertex == actual) {
                return Some(vertex);
            }
        }
        None
    }

    /// Codes the vertices that the corners around a new position refer to.
    pub(crate) fn code<C: Coder, S: StreamSide>(
        &mut self,
        coder: &mut C,
        split: &WedgeContext<'_, S>,
        out: &mut SplitWedges,
    ) {
        let corners = split.corners;
        out.targets.clear();
        out.source_vertices.clear();
        out.wedges.clear();
        out.wedges.resize(corners.len(), NONE);
        self.wedge_of.clear();
        self.code_patch(coder, split, out);
        for side in 0..2 {
            self.code_side(coder, split, side, out);
        }
        self.code_cornerless(coder, split, out);
        self.count_corners(split, out);
    }

    /// Codes the wedges that no corner refers to.
    fn code_cornerless<C: Coder, S: StreamSide>(
        &mut self,
        coder: &mut C,
        split: &WedgeContext<'_, S>,
        out: &mut SplitWedges,
    ) {
        let WedgeContext { surface, growth, corners, source, .. } = *split;
        let kept = growth.wedges(surface.vertex(next(corners[0])));
        let left = source.input().map_or(0..0, |input| input.wedges(surface.vertex(corners[0])));
        let mut actual =
            left.filter(|wedge| !self.wedge_of.contains_key(wedge)).collect::<Vec<_>>().into_iter();
        let shown = out.targets.len();
        let corner_count = out.wedges.iter().filter(|wedge| **wedge != NONE).count();
        let shown_class = 2 * shown.min(7) + usize::from(shown == corner_count);
        let near = out.targets.last().copied();
        let class =
            if kept.len() > 1 { self.find_hidden(ValueKind::Target, &[near, None], &kept) } else { 0 };
        loop {
            let more = actual.next();
            let count = out.targets.len();
            // If all vertices of the mesh exist, nothing is left to code.
            let is_full = growth.vertex_count() as usize + count >= self.vertex_count as usize;
            let is_full = is_full || count as u64 > split.most_beyond.saturating_add(1);
            let context = (shown_class * 4 + (count - shown).min(3)) * HIDDEN + class;
            if count > 0 && (is_full || !self.has_more[context].code(coder, more.is_some())) {
                break;
            }
            let target = more.and_then(|wedge| Some(source.input()?.target(wedge))).unwrap_or(NONE);
            let guesses = [out.targets.last().copied(), None];
            let target = self.choose(coder, (ValueKind::Target, 0), (guesses, kept.clone()), target);
            out.targets.push(target);
            out.source_vertices.push(more.unwrap_or(NONE));
        }
    }

    /// Updates the corner counts for the split.
    fn count_corners<S: StreamSide>(&mut self, split: &WedgeContext<'_, S>, out: &SplitWedges) {
        let WedgeContext { surface, growth, corners, .. } = *split;
        let first = growth.vertex_count();
        for (at, (&corner, &wedge)) in corners.iter().zip(&out.wedges).enumerate() {
            if wedge == NONE {
                continue;
            }
            self.hidden.add_corner(first + wedge);
            let side = usize::from(at > 0);
            if at == 0 || at + 1 == corners.len() {
                self.hidden.add_corner(out.kept[side]);
                self.hidden.add_corner(out.ends[side]);
            } else if let Some(old) = growth.shown(surface, corner) {
                self.hidden.remove_corner(old);
            }
        }
    }

    /// Codes the wedges at the corners of the patch.
    fn code_patch<C: Coder, S: StreamSide>(
        &mut self,
        coder: &mut C,
        split: &WedgeContext<'_, S>,
        out: &mut SplitWedges,
    ) {
        let WedgeContext { surface, growth, corners, .. } = *split;
        let mut before: Option<PatchCorner> = None;
        // Flag of the previous corner: none was coded, another wedge, the same wedge.
        let mut outcome = 0;
        for (at, &corner) in corners.iter().enumerate().take(corners.len() - 1).skip(1) {
            let Some(old) = growth.shown(surface, corner) else {
                before = None;
                continue;
            };
            let actual = split.wedge(corner);
            let ring = growth.shown(surface, next(corner)).unwrap_or(NONE);
            let wedge = match before {
                Some(PatchCorner { wedge, old: old_before, ring: ring_before }) if old_before == old => {
                    let context = usize::from(ring != ring_before) + 2 * outcome;
                    let continues =
                        self.continues[context].code(coder, out.source_vertices[wedge as usize] == actual);
                    outcome = 1 + usize::from(continues);
                    if continues {
                        wedge
                    } else {
                        self.other_wedge(coder, WedgeOfTarget { actual, target: old }, Some(wedge), out)
                    }
                }
                _ => self.other_wedge(coder, WedgeOfTarget { actual, target: old }, None, out),
            };
            out.wedges[at] = wedge;
            let ring = growth.shown(surface, previous(corner)).unwrap_or(NONE);
            before = Some(PatchCorner { wedge, old, ring });
        }
    }

    /// Codes an existing wedge with the given target, or a new one.
    fn other_wedge<C: Coder>(
        &mut self,
        coder: &mut C,
        WedgeOfTarget { actual, target }: WedgeOfTarget,
        excluded: Option<u32>,
        out: &mut SplitWedges,
    ) -> u32 {
        self.existing_wedge(coder, WedgeOfTarget { actual, target }, excluded, out).unwrap_or_else(|| {
            out.targets.push(target);
            out.source_vertices.push(actual);
            let wedge = out.targets.len() as u32 - 1;
            if !C::READS {
                self.wedge_of.insert(actual, wedge);
            }
            wedge
        })
    }

    /// Offers the latest wedges with this target, and codes the index of any older one.
    fn existing_wedge<C: Coder>(
        &mut self,
        coder: &mut C,
        WedgeOfTarget { actual, target }: WedgeOfTarget,
        excluded: Option<u32>,
        out: &SplitWedges,
    ) -> Option<u32> {
        let older_count = out.targets.len().saturating_sub(MOST_OFFERED);
        let mut index = 0;
        for wedge in (older_count..out.targets.len()).rev() {
            if out.targets[wedge] != target || excluded == Some(wedge as u32) {
                continue;
            }
            if self.is_other[index].code(coder, out.source_vertices[wedge] == actual) {
                return Some(wedge as u32);
            }
            index = (index + 1).min(LIST_INDICES - 1);
        }
        if older_count == 0 {
            return None;
        }
        let older = self.wedge_of.get(&actual).copied().filter(|wedge| (*wedge as usize) < older_count);
        if !self.is_older.code(coder, older.is_some()) {
            return None;
        }
        let wedge = code_uniform(coder, older_count as u32, older.unwrap_or(0));
        // With another target, the triangle would not disappear in the coarser level.
        (out.targets[wedge as usize] == target).then_some(wedge)
    }

    /// Codes the vertices of the corners of A (side 0) or B, and its group.
    fn code_side<C: Coder, S: StreamSide>(
        &mut self,
        coder: &mut C,
        split: &WedgeContext<'_, S>,
        side: usize,
        out: &mut SplitWedges,
    ) {
        let WedgeContext { surface, growth, corners, .. } = *split;
        let (at, adjacent) = if side == 0 { (0, 1) } else { (corners.len() - 1, corners.len() - 2) };
        let corner = corners[at];
        let (kept, end) =
            if side == 0 { (next(corner), previous(corner)) } else { (previous(corner), next(corner)) };
        let positions = [corner, kept, end].map(|c| surface.vertex(c));
        if positions.iter().any(|&v| surface.is_virtual(v)) {
            return;
        }
        // Opposite corners across the edge between the kept position and the end of the ring, and the
        // adjacent triangle of the patch.
        let across = surface.opposite(corner);
        let (kept_across, end_across) =
            if side == 0 { (previous(across), next(across)) } else { (next(across), previous(across)) };
        let inside = corners[adjacent];
        let end_inside = if side == 0 { next(inside) } else { previous(inside) };
        // The corner of the patch still refers to the kept position.
        let guesses = [growth.shown(surface, kept_across), growth.shown(surface, inside)];
        let offer = (guesses, growth.wedges(positions[1]));
        out.kept[side] = self.choose(coder, (ValueKind::KeptCorner, 0), offer, split.vertex_at(kept));
        let of_kept = outcome([guesses[1], guesses[0]], out.kept[side]);
        let guesses = [growth.shown(surface, end_inside), growth.shown(surface, end_across)];
        let offer = (guesses, growth.wedges(positions[2]));
        out.ends[side] = self.choose(coder, (ValueKind::RingCorner, of_kept), offer, split.vertex_at(end));
        let of_end = outcome(guesses, out.ends[side]);
        let new = NewCorner {
            of_end,
            actual: split.wedge(corner),
            adjacent: out.wedges[adjacent],
            kept: out.kept[side],
        };
        out.wedges[at] = self.new_corner(coder, new, out);
        let guesses = [across, inside].map(|c| growth.group(surface, triangle_of(c)));
        let offer = (guesses, 0..growth.group_count.max(1));
        out.groups[side] = self.choose(coder, (ValueKind::Group, of_end), offer, split.group(corner));
    }

    /// Codes the wedge at the corner of A or B: the one of the adjacent patch triangle, another one, or a
    /// new one. Its target is the kept position's vertex in the same triangle, or else the triangle would
    /// not disappear in the coarser level.
    fn new_corner<C: Coder>(&mut self, coder: &mut C, new: NewCorner, out: &mut SplitWedges) -> u32 {
        let NewCorner { of_end, actual, adjacent, kept } = new;
        if adjacent == NONE || out.targets[adjacent as usize] != kept {
            return self.other_wedge(coder, WedgeOfTarget { actual, target: kept }, None, out);
        }
        let is_adjacent = out.source_vertices[adjacent as usize] == actual;
        let has_one_corner_at_most = self.hidden.has_one_corner_at_most(kept);
        let context = 2 * of_end + usize::from(has_one_corner_at_most);
        if self.joins_patch[context].code(coder, is_adjacent) {
            return adjacent;
        }
        self.other_wedge(coder, WedgeOfTarget { actual, target: kept }, Some(adjacent), out)
    }

    /// Codes the vertex of a base triangle's corner; `last` is the last vertex coded at its position.
    pub(crate) fn base_corner<C: Coder>(
        &mut self,
        coder: &mut C,
        wedges: Range<u32>,
        last: Option<u32>,
        actual: u32,
    ) -> u32 {
        let vertex = self.choose(coder, (ValueKind::BaseCorner, 0), ([last, None], wedges), actual);
        self.hidden.add_corner(vertex);
        vertex
    }

    /// Codes the group of a base triangle.
    pub(crate) fn base_group<C: Coder>(
        &mut self,
        coder: &mut C,
        group_count: u32,
        last: Option<u32>,
        actual: u32,
    ) -> u32 {
        self.choose(coder, (ValueKind::BaseGroup, 0), ([last, None], 0..group_count.max(1)), actual)
    }
}

/// A corner of the patch.
struct PatchCorner {
    /// The wedge that it refers to now.
    wedge: u32,
    /// The vertex that it referred to before.
    old: u32,
    /// The vertex at the end of its triangle at the ring.
    ring: u32,
}

/// The corner of A or B at the new position.
#[derive(Clone, Copy)]
struct NewCorner {
    /// The outcome at the end of the ring.
    of_end: usize,
    actual: u32,
    /// The wedge of the adjacent patch triangle.
    adjacent: u32,
    /// The kept position's vertex in the same triangle.
    kept: u32,
}

/// Classifies which of two guesses is right, the patch's first: both, only the first, only the second, none.
fn outcome(guesses: [Option<u32>; 2], vertex: u32) -> usize {
    match guesses.map(|guess| guess == Some(vertex)) {
        [true, true] => 0,
        [true, false] => 1,
        [false, true] => 2,
        _ => 3,
    }
}
