//! Which strip is this triangle in, now that a tunnel under search has changed the strips?
//!
//! A tunnel changes strips long before it is accepted, and the rules against loops need to know what they would be.
//! The paper pushes new identifiers along whole strips and pops them again \[PS03, 4\]; here nothing is pushed:
//! the strip of the moving end is a chain of runs of the strips that the search began with, and
//! following the tunnel's own few cuts gives that chain. The answers are the same, at a cost that depends on the
//! length of the tunnel and not on that of the strips.
//!
//! ```text
//!     t0 ===...=== z   the end t0 takes x, x lets b go, b is the next moving end:
//!      |
//!     (x)===...        the strip of t0 now runs on through x, the strip of b is the run beyond the cut
//!      :
//!     (b)===...
//! ```
//!
//! Cost: quadratic in the steps of the tunnel, which are few.

use striata::strip::StripLinks;

/// Where triangles stand in the strips that a search begins with.
pub(crate) trait Places {
    /// The strip of a triangle, any number that only its strip has.
    fn strip(&self, triangle: u32) -> u32;

    /// The triangle's place along its strip, counted from either end.
    fn place(&self, triangle: u32) -> u32;
}

/// Two links of a tunnel: the moving end takes a triangle, which lets go of a neighbor: the next moving end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    /// The dashed link, as the side of the moving end.
    pub(crate) crossed: u32,
    /// The triangle taken.
    pub(crate) taken: u32,
    /// The solid link let go, as the side of the triangle taken.
    pub(crate) cut: u32,
    /// The next moving end.
    pub(crate) end: u32,
}

/// Triangles of one strip between two places.
#[derive(Clone, Copy, Debug)]
struct Run {
    strip: u32,
    low: u32,
    high: u32,
    /// Whether places rise away from the moving end.
    rises: bool,
}

/// Whether and how a triangle lies in the strip of the moving end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Relation {
    /// In another strip, and in none that the tunnel has changed.
    Untouched,
    /// In another strip, which the tunnel has changed.
    Other,
    /// In the same strip, unmoved so far; the moving end lies towards lower or higher places.
    Same {
        /// Towards higher places.
        is_end_above: bool,
    },
    /// In the same strip, in a part that the tunnel has joined to it or turned round.
    SameMoved {
        /// Towards higher places.
        is_end_above: bool,
    },
}

/// The strip of a moving end as runs of the strips that were there.
#[derive(Debug, Default)]
pub(crate) struct Trace {
    runs: Vec<Run>,
    touched: Vec<u32>,
}

impl Trace {
    /// Follows the strip whose moving end is that of the last step (`start` without steps).
    pub(crate) fn follow(
        &mut self,
        start: u32,
        steps: &[Step],
        links: &StripLinks<'_>,
        places: &impl Places,
    ) {
        self.runs.clear();
        self.touched.clear();
        self.touched.push(places.strip(start));
        self.touched.extend(steps.iter().map(|step| places.strip(step.taken)));
        // Where a run begins: a triangle, and the one that the tunnel has cut it from.
        let mut from = match steps.last() {
            Some(last) => (last.end, Some(last.taken)),
            None => (start, None),
        };
        while let Some(run) = self.run_from(from, steps, links, places) {
            let Some(far) = self.far_end(run, start, steps, places) else { return };
            from = match far {
                Far::Taken(0) => (start, None),
                Far::Taken(i) => (steps[i - 1].end, Some(steps[i - 1].taken)),
                Far::Start if steps.is_empty() => return,
                Far::Start => (steps[0].taken, Some(steps[0].end)),
                Far::End(i) if i + 1 == steps.len() => return,
                Far::End(i) => (steps[i + 1].taken, Some(steps[i + 1].end)),
            };
        }
    }

    /// Appends the run that begins at a triangle, away from what it was cut from; none if nothing lies beyond.
    fn run_from(
        &mut self,
        (first, cut_from): (u32, Option<u32>),
        steps: &[Step],
        links: &StripLinks<'_>,
        places: &impl Places,
    ) -> Option<Run> {
        let (strip, place) = (places.strip(first), places.place(first));
        let rises = match cut_from {
            Some(other) => place > places.place(other),
            None => match links.first_solid(first) {
                Some(side) => places.place(links.twins()[side as usize] / 3) > place,
                None => true,
            },
        };
        let is_alone = links.solid_degree(first) == u32::from(cut_from.is_some());
        let mut run = Run { strip, low: place, high: place, rises };
        if is_alone {
            self.runs.push(run);
            return None;
        }
        let cuts = steps
            .iter()
            .filter(|step| places.strip(step.taken) == strip)
            .map(|step| places.place(step.taken).min(places.place(step.end)));
        if rises {
            run.high = cuts.filter(|&low| low >= place).min().unwrap_or(u32::MAX);
        } else {
            run.low = cuts.filter(|&low| low < place).map(|low| low + 1).max().unwrap_or(0);
        }
        self.runs.push(run);
        Some(run)
    }

    /// What stands at the far end of a run, if the strip goes on from there.
    fn far_end(&self, run: Run, start: u32, steps: &[Step], places: &impl Places) -> Option<Far> {
        let far = if run.rises { run.high } else { run.low };
        let is_far = |triangle: u32| places.strip(triangle) == run.strip && places.place(triangle) == far;
        for (i, step) in steps.iter().enumerate() {
            if is_far(step.taken) {
                return Some(Far::Taken(i));
            }
            if is_far(step.end) {
                return Some(Far::End(i));
            }
        }
        // An uncut run reaches the strip's end, and the tunnel's first end may be that one.
        let place = places.place(start);
        let is_beyond =
            if run.rises { place > run.low && far == u32::MAX } else { place < run.high && far == 0 };
        (places.strip(start) == run.strip && is_beyond).then_some(Far::Start)
    }

    /// How a triangle that is no part of the tunnel lies to the moving end.
    pub(crate) fn relation(&self, triangle: u32, places: &impl Places) -> Relation {
        let strip = places.strip(triangle);
        if !self.touched.contains(&strip) {
            return Relation::Untouched;
        }
        let place = places.place(triangle);
        let within = |run: &Run| run.strip == strip && (run.low..=run.high).contains(&place);
        match self.runs.iter().position(within) {
            Some(0) => Relation::Same { is_end_above: !self.runs[0].rises },
            Some(i) => Relation::SameMoved { is_end_above: !self.runs[i].rises },
            None => Relation::Other,
        }
    }
}

/// What a run comes to.
#[derive(Clone, Copy, Debug)]
enum Far {
    /// The triangle that step `i` took.
    Taken(usize),
    /// The end that step `i` left.
    End(usize),
    /// Where the tunnel began.
    Start,
}
