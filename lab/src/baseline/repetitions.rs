//! Removes repetitions from a strip while its indices stream by.
//!
//! Two vertices that have collapsed into each other leave `abab`, whose triangles have no area. Removing
//! two indices at a time keeps the winding of everything that follows: `abab` becomes `ab`, and by the
//! same rule `aaaa` becomes `aa`.

use std::hint::select_unpredictable;

/// Placeholder for a missing index; no vertex has it.
const NONE: u32 = u32::MAX;

/// Writes a strip without its repetitions to the front of `slot`, which has room for all of it. Returns
/// the number of indices written, or 0 if no triangle remains.
///
/// Coarse levels repeat in no pattern that a branch predictor could learn, hence the selections.
pub(super) fn write_filtered(strip: impl Iterator<Item = u32>, slot: &mut [u32]) -> usize {
    // The last four indices kept.
    let [mut a, mut b, mut c, mut d] = [NONE; 4];
    let mut length = 0;
    for index in strip {
        let is_repetition = (b == d) & (c == index);
        slot[length] = index;
        length = (length + 1).wrapping_sub(2 * usize::from(is_repetition));
        // The index before `a` is not needed: the output never ends in `abab`, so the next index is always
        // kept.
        let next = [NONE, a, b, c];
        let select = |i: usize, otherwise| select_unpredictable(is_repetition, next[i], otherwise);
        [a, b, c, d] = [select(0, b), select(1, c), select(2, d), select(3, index)];
    }
    let has_triangle = slot[..length].windows(3).any(|w| w[0] != w[1] && w[1] != w[2] && w[2] != w[0]);
    if has_triangle { length } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::canonical_triangles;
    use striata::strip::strip_triangles;

    fn filtered(strip: &[u32]) -> Vec<u32> {
        let mut slot = vec![NONE; strip.len()];
        let length = write_filtered(strip.iter().copied(), &mut slot);
        slot.truncate(length);
        slot
    }

    #[test]
    fn repetitions_are_removed_in_pairs() {
        assert_eq!(filtered(&[0, 1, 2, 1, 2, 3]), [0, 1, 2, 3]);
        assert_eq!(filtered(&[0, 1, 2, 1, 2, 1, 2, 3]), [0, 1, 2, 3]);
        assert_eq!(filtered(&[0, 1, 2, 2, 2, 2, 2, 2, 3, 4]), [0, 1, 2, 2, 3, 4]);
        assert_eq!(filtered(&[0, 1, 2, 2, 2, 3]), [0, 1, 2, 2, 2, 3], "an odd one keeps the winding");
        assert_eq!(filtered(&[0, 0, 1, 2]), [0, 0, 1, 2], "a first turn stays");
        // A removal can create another repetition.
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
