//! When the verdicts about steps expire, in two bytes per step.
//!
//! A verdict is valid until the view has moved by more than its margin. Time is therefore measured in motion, and
//! an expiry is a number of **ticks**, each a fraction of the usual motion between two views. Expiries are rounded
//! down, so a verdict may be evaluated a tick early but never late. If the motion becomes much slower or the
//! numbers too large, all expiries are converted to ticks of another length.
//!
//! ```text
//! motion   0 ......... 1 tick ......... 2 ticks ......... 3 ticks
//! verdict       |---- margin ----------------->|            expires at tick 2: due as soon as tick 2 has begun
//! ```
//!
//! Steps without a verdict have an expiry that is never reached. So the expiries are also the list of the steps
//! that are known to a front, and finding those that are due is a scan of 64 steps at a time.

use bytemuck::must_cast_ref;
use wide::i16x8;

use crate::model::step_bits::StepBits;

/// Number of steps that are scanned together.
pub(super) const CHUNK: usize = 64;

/// Expiry of a step that is not known.
const UNKNOWN: i16 = i16::MAX;

/// Largest expiry of a known step.
const LAST: i16 = UNKNOWN - 1;

/// Expiry of a step that is due in any case.
const DUE: i16 = i16::MIN;

/// Number of ticks of the usual motion. More ticks waste fewer evaluations: with 16, expiries lose half a
/// sixteenth of a frame on average. Fewer ticks last for more frames.
const TICKS_PER_MOTION: f64 = 16.0;

/// A motion of fewer ticks than this asks for shorter ticks.
const MIN_TICKS: f64 = 4.0;

/// A motion of more ticks than this asks for longer ticks.
const MAX_TICKS: f64 = 2048.0;

/// The largest number of ticks before all expiries are converted.
const MAX_NOW: f64 = 60_000.0;

/// Number of ticks that the largest margin of the first verdicts takes, before any motion is known.
const TICKS_OF_FIRST_MARGIN: f64 = 32_768.0;

/// Verdicts are evaluated early by this fraction of their margin, to be safe from rounding.
const SLACK: f32 = 1e-4;

/// The expiry of each step.
#[derive(Clone, Debug)]
pub(super) struct Expiries {
    /// Expiry of each step; a verdict that expires at `tick` is due once more than `tick - i16::MIN` ticks have
    /// passed. Padded to a multiple of [`CHUNK`].
    ticks: Vec<[i16; CHUNK]>,
    /// Chunks that may have known steps.
    populated: StepBits,
    /// Number of ticks per unit of motion; 0 before it is known.
    ticks_per_unit: f64,
    /// Motion since tick 0.
    elapsed: f64,
    /// Expiries below this are due.
    now: i16,
}

impl Expiries {
    /// No step is known.
    pub(super) fn new(step_count: usize) -> Self {
        let chunk_count = step_count.div_ceil(CHUNK);
        Self {
            ticks: vec![[UNKNOWN; CHUNK]; chunk_count],
            populated: StepBits::none(chunk_count),
            ticks_per_unit: 0.0,
            elapsed: 0.0,
            now: DUE + 1,
        }
    }

    /// Number of bytes owned.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.ticks[..]) + self.populated.bytes()
    }

    /// Whether a step is known.
    #[inline]
    pub(super) fn is_known(&self, step: u32) -> bool {
        self.ticks[step as usize / CHUNK][step as usize % CHUNK] != UNKNOWN
    }

    /// Makes a step known and due.
    #[inline]
    pub(super) fn add(&mut self, step: u32) {
        self.ticks[step as usize / CHUNK][step as usize % CHUNK] = DUE;
        self.populated.insert(step / CHUNK as u32);
    }

    /// Makes a step unknown.
    #[inline]
    pub(super) fn forget(&mut self, step: u32) {
        self.ticks[step as usize / CHUNK][step as usize % CHUNK] = UNKNOWN;
    }

    /// Makes all known steps due.
    pub(super) fn expire_all(&mut self) {
        for tick in self.ticks.as_flattened_mut() {
            *tick = if *tick == UNKNOWN { UNKNOWN } else { DUE };
        }
        (self.elapsed, self.now) = (0.0, DUE + 1);
    }

    /// Sets the expiry of a verdict that has just been given.
    #[inline]
    pub(super) fn set(&mut self, step: u32, margin: f32) {
        let valid_until = (self.elapsed + f64::from(margin * (1.0 - SLACK))) * self.ticks_per_unit;
        self.ticks[step as usize / CHUNK][step as usize % CHUNK] = expiry(valid_until);
    }

    /// Chooses the length of a tick by the first margins, if it is not known yet.
    #[inline]
    pub(super) fn calibrate(&mut self, margins: impl Iterator<Item = f32>) {
        if self.ticks_per_unit == 0.0 {
            let largest = margins.filter(|margin| margin.is_finite()).fold(f32::MIN_POSITIVE, f32::max);
            self.ticks_per_unit = TICKS_OF_FIRST_MARGIN / f64::from(largest);
        }
    }

    /// Moves the view. A motion that is not finite makes everything due, and without a motion nothing expires.
    pub(super) fn advance(&mut self, motion: f32) {
        if !motion.is_finite() {
            return self.expire_all();
        }
        let motion = f64::from(motion.max(0.0));
        if motion == 0.0 || self.ticks_per_unit == 0.0 {
            // Only what has been added is due.
            self.now = DUE + 1;
            return;
        }
        self.elapsed += motion;
        let ticks = motion * self.ticks_per_unit;
        if !(MIN_TICKS..MAX_TICKS).contains(&ticks) || self.elapsed * self.ticks_per_unit > MAX_NOW {
            self.rebase(TICKS_PER_MOTION / motion);
        }
        self.now = expiry(self.elapsed * self.ticks_per_unit).saturating_add(1);
    }

    /// Converts all expiries to ticks of another length that begin now.
    fn rebase(&mut self, ticks_per_unit: f64) {
        let (scale, shift) = (ticks_per_unit / self.ticks_per_unit, self.elapsed * ticks_per_unit);
        for expires in self.ticks.as_flattened_mut().iter_mut().filter(|expires| **expires != UNKNOWN) {
            let ticks = f64::from(i32::from(*expires) - i32::from(DUE));
            *expires = expiry(ticks * scale - shift);
        }
        (self.ticks_per_unit, self.elapsed) = (ticks_per_unit, 0.0);
    }

    /// Returns the next chunk from `start` on that may have known steps.
    #[inline]
    pub(super) fn next_chunk(&self, start: u32) -> Option<u32> {
        self.populated.first_from(start)
    }

    /// Returns the steps of a chunk that are due, as bits.
    #[inline]
    pub(super) fn due(&mut self, chunk: u32) -> u64 {
        let ticks: &[[i16; 8]; 8] = must_cast_ref(&self.ticks[chunk as usize]);
        let now = i16x8::splat(self.now);
        let mut due = 0;
        let mut least = i16x8::splat(UNKNOWN);
        for (eighth, &ticks) in ticks.iter().enumerate() {
            let ticks = i16x8::from(ticks);
            due |= u64::from(ticks.simd_lt(now).to_bitmask()) << (8 * eighth);
            least = least.min(ticks);
        }
        if due == 0 && least == i16x8::splat(UNKNOWN) {
            self.populated.remove(chunk);
        }
        due
    }

    /// Returns all known steps in ascending order.
    pub(super) fn known(&self) -> Vec<u32> {
        let ticks = self.ticks.as_flattened();
        (0..).zip(ticks).filter(|(_, tick)| **tick != UNKNOWN).map(|(step, _)| step).collect()
    }
}

/// Rounds a number of ticks down to an expiry.
///
/// This is monotonic, so the expiry of a verdict is below the present only if the verdict has expired or would
/// within a tick, whatever the rounding errors.
#[inline]
fn expiry(ticks: f64) -> i16 {
    const COUNT: i32 = LAST as i32 - DUE as i32;
    // The conversion from a float saturates.
    ((ticks.max(0.0) as i32).min(COUNT) + i32::from(DUE)) as i16
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    fn due_steps(expiries: &mut Expiries) -> Vec<u32> {
        let (mut steps, mut start) = (Vec::new(), 0);
        while let Some(chunk) = expiries.next_chunk(start) {
            let due = expiries.due(chunk);
            steps.extend((0..64).filter(|bit| due >> bit & 1 != 0).map(|bit| 64 * chunk + bit));
            start = chunk + 1;
        }
        steps
    }

    #[test]
    fn verdicts_are_never_kept_for_too_long_and_rarely_dropped_early() {
        let mut random = Random::new(17);
        let count = 300;
        let mut expiries = Expiries::new(count);
        (0..count as u32).for_each(|step| expiries.add(step));
        let mut valid_until = vec![f64::NEG_INFINITY; count];
        let (mut total, mut early, mut evaluated) = (0.0f64, 0, 0);
        for frame in 0..3000 {
            // Speeds of all magnitudes, and now and then a pause.
            let speed = 10f64.powi(frame / 500 - 3);
            let motion = if frame % 50 == 0 { 0.0 } else { (random.unit() * speed) as f32 };
            total += f64::from(motion);
            expiries.advance(motion);
            let due = due_steps(&mut expiries);
            for (step, &until) in (0..).zip(&valid_until) {
                assert!(total <= until || due.contains(&step), "frame {frame}: {step} has expired");
            }
            for step in due {
                let margin = (random.unit() * 20.0 * speed) as f32;
                evaluated += 1;
                early += usize::from(valid_until[step as usize] > total + speed * 0.5);
                expiries.calibrate([margin].into_iter());
                expiries.set(step, margin);
                valid_until[step as usize] = total + f64::from(margin);
            }
        }
        assert!(evaluated > 40_000 && early < evaluated / 10, "{early} of {evaluated} are early");
    }

    #[test]
    fn unlimited_margins_last_and_zero_margins_do_not() {
        let mut expiries = Expiries::new(70);
        for step in [3, 69] {
            expiries.add(step);
        }
        expiries.calibrate([0.5, f32::INFINITY].into_iter());
        expiries.set(3, 0.0);
        expiries.set(69, f32::INFINITY);
        expiries.advance(0.0);
        assert!(due_steps(&mut expiries).len() <= 1, "without a motion, nothing expires");
        expiries.advance(1e-3);
        assert_eq!(due_steps(&mut expiries), [3]);
        expiries.advance(f32::NAN);
        assert_eq!(due_steps(&mut expiries), [3, 69]);
        expiries.forget(3);
        expiries.forget(69);
        assert!(due_steps(&mut expiries).is_empty() && expiries.next_chunk(0).is_none());
        assert!(expiries.known().is_empty() && !expiries.is_known(3));
    }
}
