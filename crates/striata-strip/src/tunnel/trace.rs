//! Finds out which strip a triangle would be in after a tunnel that is still being searched.
//!
//! A tunnel changes strips long before it is accepted, and the rules against loops refer to the changed
//! strips. \[PS03, 4\] pushes new identifiers along whole strips and pops them again. Here nothing is
//! pushed: the strip of the moving end is a chain of runs of the strips that existed before the search, and
//! the few cuts of the tunnel determine that chain. The results are the same, at a cost that depends on the
//! length of the tunnel and not on that of the strips.
//!
//! ```text
//!     t0 ===...=== z   the end t0 takes x, x releases b, b is the next moving end:
//!      |
//!     (x)===...        the strip of t0 now continues through x; the strip of b is the run beyond the cut
//!      :
//!     (b)===...
//! ```
//!
//! Cost: quadratic in the number of steps of the tunnel, which is small.

use striata::strip::StripLinks;

/// Location of triangles in the strips that existed before a search.
pub(crate) trait StripLocations {
    /// Returns the id of a triangle's strip.
    fn strip(&self, triangle: u32) -> u32;

    /// Returns the triangle's index along its strip, counted from either end.
    fn index(&self, triangle: u32) -> u32;
}

/// Two links of a tunnel: the moving end takes a triangle, which releases a neighbor, the next moving end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TunnelStep {
    /// The dashed link, as the side of the moving end.
    pub crossed: u32,
    /// The triangle taken.
    pub taken: u32,
    /// The solid link that is released, as the side of the triangle taken.
    pub cut: u32,
    /// The next moving end.
    pub end: u32,
}

/// Triangles of one original strip between two indices.
#[derive(Clone, Copy, Debug)]
struct OriginalRun {
    strip: u32,
    low: u32,
    high: u32,
    /// Whether indices rise away from the moving end.
    rises: bool,
}

/// Whether and how a triangle lies in the strip of the moving end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Relation {
    /// In another strip, which the tunnel has not changed.
    Untouched,
    /// In another strip, which the tunnel has changed.
    Other,
    /// In the same strip, in the part that the tunnel has not moved.
    Same {
        /// Whether the moving end is in the direction of higher indices.
        is_end_above: bool,
    },
    /// In the same strip, in a part that the tunnel has joined to it or reversed.
    SameMoved {
        /// Whether the moving end is in the direction of higher indices.
        is_end_above: bool,
    },
}

/// The strip of a moving end as runs of the original strips.
#[derive(Debug, Default)]
pub(crate) struct StripTrace {
    runs: Vec<OriginalRun>,
    touched: Vec<u32>,
}

impl StripTrace {
    /// Traces the strip of the last step's moving end (of `start` if there are no steps).
    pub(crate) fn follow(
        &mut self,
        start: u32,
        steps: &[TunnelStep],
        links: &StripLinks<'_>,
        locations: &impl StripLocations,
    ) {
        self.runs.clear();
        self.touched.clear();
        self.touched.push(locations.strip(start));
        self.touched.extend(steps.iter().map(|step| locations.strip(step.taken)));
        let mut from = match steps.last() {
            Some(last) => RunStart { first: last.end, cut_from: Some(last.taken) },
            None => RunStart { first: start, cut_from: None },
        };
        while let Some(run) = self.run_from(from, steps, links, locations) {
            let Some(far) = self.far_end(run, start, steps, locations) else { return };
            from = match far {
                RunEnd::Taken(0) => RunStart { first: start, cut_from: None },
                RunEnd::Taken(i) => RunStart { first: steps[i - 1].end, cut_from: Some(steps[i - 1].taken) },
                RunEnd::Start if steps.is_empty() => return,
                RunEnd::Start => RunStart { first: steps[0].taken, cut_from: Some(steps[0].end) },
                RunEnd::End(i) if i + 1 == steps.len() => return,
                RunEnd::End(i) => RunStart { first: steps[i + 1].taken, cut_from: Some(steps[i + 1].end) },
            };
        }
    }

    /// Appends the run that begins at a triangle, away from what it was cut from; returns [`None`] if the
    /// strip ends there.
    fn run_from(
        &mut self,
        start: RunStart,
        steps: &[TunnelStep],
        links: &StripLinks<'_>,
        locations: &impl StripLocations,
    ) -> Option<OriginalRun> {
        let RunStart { first, cut_from } = start;
        let (strip, index) = (locations.strip(first), locations.index(first));
        let rises = match cut_from {
            Some(other) => index > locations.index(other),
            None => match links.first_solid(first) {
                Some(side) => locations.index(links.twins()[side as usize] / 3) > index,
                None => true,
            },
        };
        let is_alone = links.solid_degree(first) == u32::from(cut_from.is_some());
        let mut run = OriginalRun { strip, low: index, high: index, rises };
        if is_alone {
            self.runs.push(run);
            return None;
        }
        let cuts = steps
            .iter()
            .filter(|step| locations.strip(step.taken) == strip)
            .map(|step| locations.index(step.taken).min(locations.index(step.end)));
        if rises {
            run.high = cuts.filter(|&low| low >= index).min().unwrap_or(u32::MAX);
        } else {
            run.low = cuts.filter(|&low| low < index).map(|low| low + 1).max().unwrap_or(0);
        }
        self.runs.push(run);
        Some(run)
    }

    /// Returns the element of the tunnel at the far end of a run, if the strip continues from there.
    fn far_end(
        &self,
        run: OriginalRun,
        start: u32,
        steps: &[TunnelStep],
        locations: &impl StripLocations,
    ) -> Option<RunEnd> {
        let far = if run.rises { run.high } else { run.low };
        let is_far =
            |triangle: u32| locations.strip(triangle) == run.strip && locations.index(triangle) == far;
        for (i, step) in steps.iter().enumerate() {
            if is_far(step.taken) {
                return Some(RunEnd::Taken(i));
            }
            if is_far(step.end) {
                return Some(RunEnd::End(i));
            }
        }
        // An uncut run reaches the end of the strip, which may be the start of the tunnel.
        let index = locations.index(start);
        let is_beyond =
            if run.rises { index > run.low && far == u32::MAX } else { index < run.high && far == 0 };
        (locations.strip(start) == run.strip && is_beyond).then_some(RunEnd::Start)
    }

    /// Classifies a triangle outside the tunnel by its strip relative to the moving end.
    pub(crate) fn relation(&self, triangle: u32, locations: &impl StripLocations) -> Relation {
        let strip = locations.strip(triangle);
        if !self.touched.contains(&strip) {
            return Relation::Untouched;
        }
        let index = locations.index(triangle);
        let within = |run: &OriginalRun| run.strip == strip && (run.low..=run.high).contains(&index);
        match self.runs.iter().position(within) {
            Some(0) => Relation::Same { is_end_above: !self.runs[0].rises },
            Some(i) => Relation::SameMoved { is_end_above: !self.runs[i].rises },
            None => Relation::Other,
        }
    }
}

/// Start of a run: a triangle, and the one that the tunnel has cut it from.
#[derive(Clone, Copy)]
struct RunStart {
    first: u32,
    cut_from: Option<u32>,
}

/// Element at the far end of a run.
#[derive(Clone, Copy, Debug)]
enum RunEnd {
    /// The triangle that step `i` took.
    Taken(usize),
    /// The end that step `i` released.
    End(usize),
    /// The start of the tunnel.
    Start,
}
