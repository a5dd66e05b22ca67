//! Integer tables for probabilities, log-odds and logarithms.
//!
//! Predictions of a decision are combined as log-odds, `ln(p / (1 - p))`, the scale on which
//! [`super::Mixer`] adds them. Log-odds and logarithms are in units of 1/256. The tables are computed at
//! compile time, by integer arithmetic only.

/// Log-odds of 1, in 1/256.
pub(crate) const LOG_ODDS_ONE: i32 = 256;
/// Limit on the magnitude of log-odds: odds of 162754 to 1.
pub(crate) const LOG_ODDS_LIMIT: i32 = 12 * LOG_ODDS_ONE - 1;

const SPAN: usize = 12 * LOG_ODDS_ONE as usize;

/// `exp(-1/256)` in 1/2^62.
const DECAY: u128 = 4_593_706_758_521_714_574;

/// Probability, in 1/65536, for log-odds from -12 to 12.
static PROBABILITIES: [u16; 2 * SPAN] = {
    let mut table = [0; 2 * SPAN];
    let mut decay: u128 = 1 << 62;
    let mut at = 0;
    while at < SPAN {
        let p = ((1u128 << 78) + ((1 << 62) + decay) / 2) / ((1 << 62) + decay);
        let p = if p > 65535 { 65535 } else { p };
        table[SPAN + at] = p as u16;
        table[SPAN - at] = (65536 - p) as u16;
        decay = (decay * DECAY) >> 62;
        at += 1;
    }
    table[0] = 1;
    table
};

/// Log-odds for each probability in 1/4096, evaluated at the middle of the interval.
static LOG_ODDS: [i16; 4096] = {
    let mut table = [0; 4096];
    let mut at = 0;
    let mut p = 0;
    while p < 4096 {
        while at < 2 * SPAN - 1 && (PROBABILITIES[at] as usize) < p * 16 + 8 {
            at += 1;
        }
        table[p] = (at as i32 - SPAN as i32) as i16;
        p += 1;
    }
    table
};

/// Returns the probability, in 1/65536, for log-odds in 1/256: 1 to 65535.
#[inline]
pub(crate) fn probability(log_odds: i32) -> u32 {
    let at = log_odds.clamp(-LOG_ODDS_LIMIT, LOG_ODDS_LIMIT) + SPAN as i32;
    u32::from(PROBABILITIES[at as usize])
}

/// Returns the log-odds, in 1/256, of a probability in 1/65536.
#[inline]
pub(crate) fn log_odds(p_one: u32) -> i32 {
    i32::from(LOG_ODDS[(p_one as usize >> 4) & 4095])
}

/// Fractions of binary logarithms, in 1/256, for mantissas from 1 to 2 in steps of 1/256.
static FRACTIONS: [u8; 256] = {
    let mut table = [0; 256];
    let mut at = 0;
    while at < 256 {
        // The middle of the step, so that errors cancel on average.
        let mut mantissa = ((256 + at as u64) * 2 + 1) << 22;
        let mut fraction = 0u16;
        let mut bit = 0;
        while bit < 9 {
            mantissa = (mantissa * mantissa) >> 31;
            let is_over = mantissa >> 32;
            mantissa >>= is_over;
            fraction = fraction << 1 | is_over as u16;
            bit += 1;
        }
        let rounded = (fraction + 1) >> 1;
        table[at] = if rounded > 255 { 255 } else { rounded as u8 };
        at += 1;
    }
    table
};

/// Returns the binary logarithm of an integer, in 1/256; 0 for 0.
#[inline]
pub(crate) fn log2_q8(number: u32) -> i32 {
    let number = number.max(1);
    let whole = number.ilog2();
    let mantissa = (number << (31 - whole)) >> 23;
    (whole << 8) as i32 + i32::from(FRACTIONS[mantissa as usize & 255])
}

/// Returns the binary logarithm of a positive integer, in 1/65536, by repeated squaring.
pub(crate) const fn log2_q16(number: u64) -> u32 {
    let whole = number.ilog2();
    let mut mantissa = (number << (63 - whole)) as u128;
    let mut logarithm = whole;
    let mut bit = 0;
    while bit < 16 {
        bit += 1;
        mantissa = (mantissa * mantissa) >> 63;
        let is_over = mantissa >> 64 != 0;
        mantissa >>= is_over as u32;
        logarithm = logarithm << 1 | is_over as u32;
    }
    logarithm
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn probabilities_follow_the_logistic_curve() {
        for x in -3100..3100 {
            let expected = 65536.0 / (1.0 + (-f64::from(x.clamp(-3071, 3071)) / 256.0).exp());
            let error = (f64::from(probability(x)) - expected.clamp(1.0, 65535.0)).abs();
            assert!(error <= 0.5001, "{x}: {} for {expected}", probability(x));
            assert_eq!(probability(x) + probability(-x), 65536);
        }
    }

    #[test]
    fn log_odds_invert_probabilities() {
        for p in (8..65536).step_by(16) {
            let expected = (f64::from(p) / (65536.0 - f64::from(p))).ln() * 256.0;
            assert!((f64::from(log_odds(p)) - expected).abs() < 17.0, "{p}: {} for {expected}", log_odds(p));
        }
        assert!(log_odds(65535) > 2000 && log_odds(0) < -2000);
    }

    #[test]
    fn logarithms_are_accurate() {
        for number in (1..5000).chain([1 << 20, u32::MAX, 123_456_789]) {
            let expected = f64::from(number).log2() * 256.0;
            assert!((f64::from(log2_q8(number)) - expected).abs() < 1.6, "{number}");
        }
        assert_eq!(log2_q8(0), log2_q8(1));
    }

    #[test]
    fn fine_logarithms_are_accurate() {
        for number in [1, 2, 3, 1000, u64::MAX, 1 << 63, (1 << 40) + 12345] {
            assert!(
                (f64::from(log2_q16(number)) / 65536.0 - (number as f64).log2()).abs() < 2e-5,
                "{number}"
            );
        }
    }

    #[test]
    fn tables_are_the_same_on_every_machine() {
        let bytes = |table: &[u16]| table.iter().flat_map(|p| p.to_le_bytes()).collect::<Vec<u8>>();
        let odds: Vec<u8> = LOG_ODDS.iter().flat_map(|p| p.to_le_bytes()).collect();
        let found = [&bytes(&PROBABILITIES), &odds, &FRACTIONS[..]].map(crc32fast::hash);
        assert_eq!(found, [4_100_039_620, 2_484_021_974, 1_421_023_757]);
    }
}
