//! Arcs in 32 bits: which place comes next, and down to which change of the strip.
//!
//! ```text
//! bits 31..16   res: the last change of the strip for which it holds; 65535 from then on
//! bit  15       break: the strip ends at this place, another begins at the next
//! bits 14..0    how many places further the next one is; 0: the strip ends
//! ```

/// The last arc of a row holds for the rest.
pub(super) const REST: u16 = u16::MAX;
const BREAK: u32 = 1 << 15;
const SKIP: u32 = BREAK - 1;

/// What comes after a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Arc(pub(super) u32);

impl Arc {
    /// The arc of an empty row.
    pub(super) const NEXT: Self = Self(1);
    /// The end of the strip.
    pub(super) const END: Self = Self(0);

    /// To a place `skip` further, of 32,767 at most, by a break or not; for the rest.
    pub(super) fn new(skip: u32, is_break: bool) -> Self {
        debug_assert!(skip > 0 && skip <= SKIP);
        Self(skip | if is_break { BREAK } else { 0 })
    }

    /// The same down to a change.
    pub(super) fn until(self, res: u16) -> Self {
        Self(self.0 & 0xffff | u32::from(res) << 16)
    }

    #[inline]
    pub(super) fn res(self) -> u16 {
        (self.0 >> 16) as u16
    }

    #[inline]
    pub(super) fn skip(self) -> usize {
        (self.0 & SKIP) as usize
    }

    #[inline]
    pub(super) fn is_break(self) -> bool {
        self.0 & BREAK != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_is_what_was_put_in() {
        let arc = Arc::new(32_767, true).until(7);
        assert_eq!((arc.skip(), arc.is_break(), arc.res()), (32_767, true, 7));
        assert_eq!(Arc::NEXT, Arc::new(1, false).until(0));
        assert_eq!((Arc::END.until(REST).skip(), Arc::END.until(REST).res()), (0, REST));
    }
}
