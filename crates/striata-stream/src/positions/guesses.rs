//! Guesses at the position of a new vertex, derived from its surroundings.
//!
//! If a surface was sampled with some regularity, one of these guesses is often nearly right, but it is
//! not known in advance which. Therefore they are not averaged. Each becomes a bump of a density, and the
//! weight of each kind of guess is learned.
//!
//! ```text
//!        apex
//!        /  \
//!      r0 -- r1        inside:  r0 + r2 - r1
//!        \  /  \       across:  r0 + r1 - apex
//!          v -- r2     middle:  (r0 + r3) / 2
//! ```

use super::local::{LANES, LocalRing, Point};

/// Number of kinds of guesses.
pub(super) const KINDS: usize = 4;
/// Kind: parallelograms of three consecutive ring vertices.
pub(super) const INSIDE: usize = 0;
/// Kind: parallelograms across ring edges.
pub(super) const ACROSS: usize = 1;
/// Kind: center of the ring, and midpoints of opposite ring vertices.
pub(super) const MIDDLE: usize = 2;
/// Kind: heights of the planes across ring edges, once the other two coordinates are known.
pub(super) const PLANES: usize = 3;

/// Guesses of one kind, one per lane.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Guesses {
    /// Coordinates by axis.
    pub at: [[i16; LANES]; 3],
    /// Number of lanes in use.
    pub count: usize,
}

impl Guesses {
    /// Adds a guess if a lane is free.
    #[inline]
    fn push(&mut self, point: Point) {
        if self.count < LANES {
            for (at, x) in self.at.iter_mut().zip(point) {
                at[self.count] = x.clamp(-16_000, 16_000) as i16;
            }
            self.count += 1;
        }
    }
}

/// Returns `a + b - c`.
fn corner(a: Point, b: Point, c: Point) -> Point {
    [0, 1, 2].map(|i| a[i] + b[i] - c[i])
}

/// Returns the midpoint of two points.
fn middle(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|i| (a[i] + b[i]) >> 1)
}

/// Makes the guesses of all kinds but the heights of planes.
pub(super) fn guess(local: &LocalRing, guesses: &mut [Guesses; KINDS]) {
    guesses.iter_mut().for_each(|g| g.count = 0);
    let n = local.count;
    let wrap = |i: usize| if i >= n { i - n } else { i };
    guesses[MIDDLE].push([0; 3]);
    for i in 0..n {
        let [here, next, after] = [0, 1, 2].map(|k| local.ring[wrap(i + k)]);
        let Some(here) = here else { continue };
        if let (Some(next), Some(apex)) = (next, local.apexes[i]) {
            guesses[ACROSS].push(corner(here, next, apex));
        }
        if n < 4 {
            continue;
        }
        if let (Some(next), Some(after)) = (next, after) {
            guesses[INSIDE].push(corner(here, after, next));
        }
        if let (true, Some(there)) = (n % 2 == 1 || 2 * i < n, local.ring[wrap(i + n / 2)]) {
            guesses[MIDDLE].push(middle(here, there));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of a regular hexagon with `times` the radius of the ring.
    fn hexagon(times: i32) -> [Option<Point>; LANES] {
        let [x, y] = [500 * times, 866 * times];
        let mut ring = [None; LANES];
        for (at, [px, py]) in
            [[2 * x, 0], [x, y], [-x, y], [-2 * x, 0], [-x, -y], [x, -y]].into_iter().enumerate()
        {
            ring[at] = Some([px, py, 0]);
        }
        ring
    }

    fn regular() -> LocalRing {
        let ring = hexagon(1);
        let sum = |i: usize, j: usize| {
            let (p, q) = (ring[i % 6].unwrap(), ring[j % 6].unwrap());
            [0, 1, 2].map(|a| p[a] + q[a])
        };
        let mut local = LocalRing { count: 6, ring, ..LocalRing::default() };
        for i in 0..6 {
            local.apexes[i] = Some(sum(i, i + 1));
        }
        local
    }

    #[test]
    fn all_guesses_agree_on_a_regular_lattice() {
        let mut guesses = [Guesses::default(); KINDS];
        guess(&regular(), &mut guesses);
        assert_eq!(guesses.map(|g| g.count), [6, 6, 4, 0]);
        for guesses in guesses {
            for at in guesses.at.as_flattened() {
                assert!(at.abs() <= 1, "{at}");
            }
        }
    }

    #[test]
    fn unknown_points_give_no_guesses() {
        let mut local = regular();
        local.ring[2] = None;
        local.apexes[4] = None;
        let mut guesses = [Guesses::default(); KINDS];
        guess(&local, &mut guesses);
        // Six, six and four guesses, minus those that involve unknown points.
        assert_eq!(guesses.map(|g| g.count), [3, 3, 3, 0]);
    }
}
