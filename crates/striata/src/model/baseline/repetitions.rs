//! Repetitions of a strip, left out while its indices go by.
//!
//! Vertices that have become one stand side by side as `abab`, whose triangles have no area. Leaving out two indices
//! at a time keeps the winding of all that follows: `abab` becomes `ab`, and by the same rule `aaaa` becomes `aa`.

use std::hint::select_unpredictable;

/// Stands where no index does; no vertex has this number.
const NONE: u32 = u32::MAX;

/// Looks at the indices of one strip in turn and remembers the last four that stay.
struct RepetitionFilter {
    kept: [u32; 4],
    has_triangle: bool,
}

impl RepetitionFilter {
    fn new() -> Self {
        Self { kept: [NONE; 4], has_triangle: false }
    }

    /// Whether the next index completes a repetition: it goes then, and the one before it too.
    ///
    /// Coarse levels repeat without any pattern that a branch could learn, hence the selections.
    #[inline]
    fn completes_repetition(&mut self, index: u32) -> bool {
        let [d, a, b, c] = self.kept;
        let is_repetition = (a == c) & (b == index);
        self.has_triangle |= (index != c) & (index != b) & (b != c) & (b != NONE) & !is_repetition;
        // What stood before `d` is not needed: what is kept never ends in `abab`, so an index must stay first.
        let (if_it_goes, if_it_stays) = ([NONE, d, a, b], [a, b, c, index]);
        self.kept =
            std::array::from_fn(|i| select_unpredictable(is_repetition, if_it_goes[i], if_it_stays[i]));
        is_repetition
    }

    /// The length after an index for which [`completes_repetition`](Self::completes_repetition) said this.
    #[inline]
    fn grown(length: usize, is_repetition: bool) -> usize {
        (length + 1).wrapping_sub(2 * usize::from(is_repetition))
    }
}

/// Writes what is left of a strip into the front of `slot`, which has room for all of it; returns how many indices
/// that are, none where no triangle is left.
pub(super) fn write_filtered(strip: impl Iterator<Item = u32>, slot: &mut [u32]) -> usize {
    let mut filter = RepetitionFilter::new();
    let mut length = 0;
    for index in strip {
        slot[length] = index;
        length = RepetitionFilter::grown(length, filter.completes_repetition(index));
    }
    if filter.has_triangle { length } else { 0 }
}

/// How many indices are left of a strip, none where no triangle is.
pub(super) fn filtered_length(strip: impl Iterator<Item = u32>) -> usize {
    let mut filter = RepetitionFilter::new();
    let mut length = 0;
    for index in strip {
        length = RepetitionFilter::grown(length, filter.completes_repetition(index));
    }
    if filter.has_triangle { length } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::canonical_triangles;
    use crate::strip::strip_triangles;

    fn filtered(strip: &[u32]) -> Vec<u32> {
        let mut slot = vec![NONE; strip.len()];
        let length = write_filtered(strip.iter().copied(), &mut slot);
        assert_eq!(filtered_length(strip.iter().copied()), length);
        slot.truncate(length);
        slot
    }

    #[test]
    fn repetitions_go_in_pairs() {
        assert_eq!(filtered(&[0, 1, 2, 1, 2, 3]), [0, 1, 2, 3]);
        assert_eq!(filtered(&[0, 1, 2, 1, 2, 1, 2, 3]), [0, 1, 2, 3]);
        assert_eq!(filtered(&[0, 1, 2, 2, 2, 2, 2, 2, 3, 4]), [0, 1, 2, 2, 3, 4]);
        assert_eq!(filtered(&[0, 1, 2, 2, 2, 3]), [0, 1, 2, 2, 2, 3], "an odd one keeps the winding");
        assert_eq!(filtered(&[0, 0, 1, 2]), [0, 0, 1, 2], "a first turn stays");
        // What goes brings others together.
        assert_eq!(filtered(&[5, 0, 1, 2, 2, 2, 2, 1, 2, 1, 2, 6]), [5, 0, 1, 2, 2, 1, 2, 6]);
    }

    #[test]
    fn a_strip_without_triangles_is_not_drawn() {
        for strip in [&[][..], &[1], &[1, 2], &[1, 2, 1, 2, 1], &[1, 1, 1], &[1, 2, 2, 2, 1, 1]] {
            assert_eq!(filtered(strip), [0; 0], "{strip:?}");
        }
        assert_eq!(filtered(&[1, 2, 3]), [1, 2, 3]);
    }

    #[test]
    fn every_short_strip_keeps_its_triangles_and_no_repetition() {
        let check = |mut code: u32, radix: u32| {
            let digit = |_| {
                let v = code % radix;
                code /= radix;
                v
            };
            let strip: Vec<u32> = (0..9).map(digit).collect();
            let short = filtered(&strip);
            let triangles = |s: &[u32]| canonical_triangles(&strip_triangles(s).collect::<Vec<_>>());
            assert_eq!(triangles(&short), triangles(&strip), "{strip:?} became {short:?}");
            assert!(short.windows(4).all(|w| w[..2] != w[2..]), "{strip:?} became {short:?}");
        };
        (0..3u32.pow(9)).for_each(|code| check(code, 3));
        (0..5u32.pow(9)).step_by(61).for_each(|code| check(code, 5));
    }
}
