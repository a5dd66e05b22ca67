//! Axes of charts: linear or logarithmic, with round numbers at the ticks.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

use striata_command::output::format_count;

/// The range of values that an axis shows, and its ticks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Scale {
    low: f64,
    high: f64,
    is_log: bool,
    ticks: Vec<f64>,
}

impl Scale {
    /// Creates a linear axis with ticks at these values, in ascending order.
    pub(super) fn at(ticks: &[f64]) -> Self {
        let (low, high) = bounds(ticks.iter().copied());
        // Leaves room for the first and last marks.
        let margin = 0.03 * (high - low);
        Self { low: low - margin, high: high + margin, is_log: false, ticks: ticks.to_vec() }
    }

    /// Creates a linear axis that covers these values and ends at round numbers.
    pub(super) fn linear(values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = bounds(values);
        // Keeps marks off the border.
        let margin = 0.04 * (high - low);
        let (low, high) = (if low < 0.0 { low - margin } else { (low - margin).max(0.0) }, high + margin);
        let step = round_step((high - low) / 6.0);
        let (first, last) = ((low / step).floor() as i64, (high / step).ceil() as i64);
        let ticks: Vec<f64> = (first..=last).map(|i| i as f64 * step).collect();
        Self { low: first as f64 * step, high: last as f64 * step, is_log: false, ticks }
    }

    /// Creates a logarithmic axis that covers these values; nonpositive values are ignored.
    pub(super) fn log(values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = bounds(values.into_iter().filter(|&value| value > 0.0));
        let low = if low > 0.0 { low } else { 1.0 };
        let margin = (high.max(low * 2.0) / low).powf(0.04);
        let (low, high) = (low / margin, high.max(low * 2.0) * margin);
        let decades = low.log10().floor() as i32..=high.log10().ceil() as i32;
        let digits: &[f64] = if high / low > 2000.0 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let all: Vec<f64> = decades.flat_map(|e| digits.iter().map(move |d| d * 10f64.powi(e))).collect();
        let lowest = all.iter().copied().filter(|&tick| tick <= low).fold(low / 2.0, f64::max);
        let highest = all.iter().copied().filter(|&tick| tick >= high).fold(f64::INFINITY, f64::min);
        let highest = if highest.is_finite() { highest } else { high };
        let ticks = all.into_iter().filter(|tick| (lowest..=highest).contains(tick)).collect();
        Self { low: lowest, high: highest, is_log: true, ticks }
    }

    /// Values of the ticks.
    pub(super) fn ticks(&self) -> &[f64] {
        &self.ticks
    }

    /// The pixel of a value on an axis between two pixels.
    pub(super) fn pixel(&self, value: f64, first: i32, last: i32) -> i32 {
        first + (self.share(value) * f64::from(last - first)).round() as i32
    }

    /// The label of a tick.
    pub(super) fn label(value: f64) -> String {
        if value >= 1000.0 {
            return format_count(value.round() as usize);
        }
        // Ticks have few digits; this hides rounding errors behind them.
        let text = format!("{value:.6}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    }

    fn share(&self, value: f64) -> f64 {
        if self.is_log {
            (value.max(self.low / 10.0) / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        }
    }
}

/// Minimum and maximum of the values, widened if they are equal or if there are none.
fn bounds(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let finite = values.into_iter().filter(|value| value.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    match high - low {
        width if width > 0.0 => (low, high),
        _ if low.is_finite() => (low, low + low.abs().max(1.0) * 0.1),
        _ => (0.0, 1.0),
    }
}

/// Rounds up to 1, 2 or 5 times a power of ten.
fn round_step(at_least: f64) -> f64 {
    let power = 10f64.powi(at_least.log10().floor() as i32);
    [1.0, 2.0, 5.0].iter().map(|digit| digit * power).find(|&step| step >= at_least).unwrap_or(10.0 * power)
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, &value: &f64, ends: (i32, i32)) -> i32 {
        self.pixel(value, ends.0, ends.1)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let every = self.ticks.len().div_ceil(hint.bold_points().max(1)).max(1);
        self.ticks.iter().copied().step_by(every).collect()
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Scale {
    fn format_ext(&self, &value: &f64) -> String {
        Self::label(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: &Scale) -> Vec<String> {
        scale.ticks.iter().map(|tick| scale.format_ext(tick)).collect()
    }

    #[test]
    fn ticks_are_round_and_cover_all_values() {
        assert_eq!(labels(&Scale::linear([1.13, 1.47])), ["1.1", "1.2", "1.3", "1.4", "1.5"]);
        assert_eq!(
            labels(&Scale::log([46.0, 5123.0])),
            ["20", "50", "100", "200", "500", "1,000", "2,000", "5,000", "10,000"]
        );
        assert_eq!(labels(&Scale::log([0.002, 7.0])).first().map(String::as_str), Some("0.001"));
        assert_eq!(labels(&Scale::at(&[1.0, 3.0])), ["1", "3"]);
    }

    #[test]
    fn axis_ends_map_to_pixel_ends() {
        for scale in [Scale::linear([3.0, 17.0]), Scale::log([0.5, 90.0])] {
            let Range { start, end } = scale.range();
            assert_eq!((scale.map(&start, (100, 0)), scale.map(&end, (100, 0))), (100, 0));
        }
        assert_eq!(Scale::log([1.0, 100.0]).map(&10.0, (0, 100)), 50);
    }

    #[test]
    fn axes_work_for_no_value_and_for_one() {
        for values in [vec![], vec![5.0], vec![0.0], vec![f64::NAN]] {
            for scale in [Scale::linear(values.clone()), Scale::log(values.clone()), Scale::at(&values)] {
                let Range { start, end } = scale.range();
                assert!(start < end && (end - start).is_finite(), "{values:?}: {scale:?}");
            }
        }
    }
}
