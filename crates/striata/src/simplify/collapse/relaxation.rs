//! Decides when relaxed collapses begin.
//!
//! A position that has no strict collapse gets a relaxed one at its cost. On a closed surface of a few
//! large parts, relaxed collapses begin only after the last strict one, and nothing is prepared for
//! them until then.

use crate::mesh::Welded;

use super::judge::Judge;
use super::links::LinkKind;
use super::whole::{Relaxed, Removed};
use crate::simplify::options::TopologyRule;

/// On a closed surface of several parts, relaxed collapses are postponed if the parts have at least
/// this many triangles on average: strict collapses alone reduce them to a twenty-fifth.
const LEAST_CLOSED_PART: usize = 100;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Never,
    /// No position has needed one yet.
    Unknown,
    /// Begin once no strict collapse is left anywhere.
    Later,
    Now,
}

/// Schedule of relaxed collapses: whether positions without a strict collapse may have one already.
pub(in crate::simplify) struct Relaxation<'a> {
    welded: &'a Welded,
    keeps_parts: bool,
    state: State,
    /// State prepared for relaxed collapses that begin later.
    waiting: Option<Relaxed<'a>>,
}

impl<'a> Relaxation<'a> {
    pub(in crate::simplify) fn new(welded: &'a Welded, rule: TopologyRule) -> Self {
        let state = if rule == TopologyRule::Keep { State::Never } else { State::Unknown };
        Self { welded, keeps_parts: rule == TopologyRule::KeepParts, state, waiting: None }
    }

    /// Whether there may ever be relaxed collapses.
    pub(in crate::simplify) fn is_possible(&self) -> bool {
        self.state != State::Never
    }

    /// Whether relaxed collapses are postponed until no strict one is left.
    pub(in crate::simplify) fn is_waiting(&self) -> bool {
        self.state == State::Later
    }

    /// Called when a position has no strict collapse: begins relaxed collapses, or postpones them.
    pub(in crate::simplify) fn consider(&mut self, judge: &mut Judge<'a>, removed: Removed<'_>) {
        if self.state != State::Unknown {
            return;
        }
        let relaxed = Relaxed::new(self.welded, self.keeps_parts);
        let is_closed = |p: u32| matches!(judge.links.kind(p), LinkKind::Closed | LinkKind::Empty);
        let part_count = relaxed.part_count();
        let waits = self.welded.positions.is_identity()
            && (part_count == 1 || LEAST_CLOSED_PART * part_count <= self.welded.mesh.triangle_count())
            && (0..judge.positions.len() as u32).all(is_closed);
        self.waiting = Some(relaxed);
        if waits {
            self.state = State::Later;
        } else {
            self.begin(judge, removed);
        }
    }

    /// Begins relaxed collapses; if they are ruled out, still begins tracking parts and their losses.
    pub(in crate::simplify) fn begin(&mut self, judge: &mut Judge<'a>, removed: Removed<'_>) {
        let mut relaxed = self.waiting.take().unwrap_or_else(|| Relaxed::new(self.welded, self.keeps_parts));
        relaxed.is_tail = self.is_waiting();
        relaxed.begin(&judge.links, &judge.is_locked, removed);
        judge.relaxed = Some(relaxed);
        if self.state != State::Never {
            self.state = State::Now;
        }
    }
}
