//! Cells of tables: the numbers in them, and whether they equal measured values.

/// A number in a cell, with its precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CellNumber {
    value: f64,
    /// Number of digits after the decimal point.
    digits: usize,
}

impl CellNumber {
    /// Whether a measured value, rounded to the same number of digits, equals this number.
    fn matches(self, measured: f64) -> bool {
        let digits = self.digits;
        format!("{:.digits$}", self.value) == format!("{measured:.digits$}")
    }
}

/// Returns the numbers of a cell in order: `1,234 (5.60 MB)` has 1234 and 5.60.
pub(super) fn numbers(cell: &str) -> Vec<CellNumber> {
    let is_part = |c: char| c.is_ascii_digit() || c == ',' || c == '.';
    let mut numbers = Vec::new();
    for word in cell.split(|c| !is_part(c)) {
        let plain = word.trim_end_matches([',', '.']).trim_start_matches(',').replace(',', "");
        if let Ok(value) = plain.parse() {
            let digits = plain.split_once('.').map_or(0, |(_, digits)| digits.len());
            numbers.push(CellNumber { value, digits });
        }
    }
    numbers
}

/// Removes emphasis and code marks from a cell, for labels and placeholders.
pub(super) fn label(cell: &str) -> String {
    cell.replace("**", "").replace('`', "").trim().to_owned()
}

/// Returns the label of a cell; numbers without thousands separators.
pub(super) fn argument(cell: &str) -> String {
    let label = label(cell);
    let is_number = label.starts_with(|c: char| c.is_ascii_digit())
        && label.chars().all(|c| c.is_ascii_digit() || c == ',' || c == '.');
    if is_number { label.replace(',', "") } else { label }
}

/// Whether a cell shows these values; a cell without numbers always does.
pub(super) fn shows(cell: &str, measured: &[f64]) -> bool {
    let shown = numbers(cell);
    let is_same = |(shown, &measured): (&CellNumber, &f64)| shown.matches(measured);
    shown.is_empty() || (shown.len() == measured.len() && shown.iter().zip(measured).all(is_same))
}

/// Returns a cell with its numbers replaced by measured values, in the same format; `None` if the counts
/// differ.
pub(super) fn with_values(cell: &str, measured: &[f64]) -> Option<String> {
    let shown = numbers(cell);
    if shown.len() != measured.len() {
        return None;
    }
    let mut values = shown.iter().zip(measured);
    let is_part = |c: char| c.is_ascii_digit() || c == ',' || c == '.';
    let mut text = String::new();
    let mut rest = cell;
    while let Some(start) = rest.find(is_part) {
        text.push_str(&rest[..start]);
        let end = rest[start..].find(|c| !is_part(c)).map_or(rest.len(), |length| start + length);
        let word = &rest[start..end];
        if numbers(word).is_empty() {
            text.push_str(word);
        } else {
            let (number, value) = values.next()?;
            let formatted = with_separators(&format!("{value:.digits$}", digits = number.digits));
            let formatted =
                if word.starts_with('.') { formatted.trim_start_matches('0') } else { &formatted };
            text.push_str(formatted);
            text.push_str(&word[word.trim_end_matches([',', '.']).len()..]);
        }
        rest = &rest[end..];
    }
    text.push_str(rest);
    Some(text)
}

/// Inserts commas between groups of three digits before the decimal point, from four digits on.
fn with_separators(number: &str) -> String {
    let (whole, fraction) = number.split_at(number.find('.').unwrap_or(number.len()));
    let mut text = String::new();
    for (at, digit) in whole.chars().enumerate() {
        if at > 0 && (whole.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text + fraction
}

/// Returns the measured numbers of a printed cell.
pub(super) fn printed_values(printed: &str) -> Vec<f64> {
    numbers(printed).iter().map(|number| number.value).collect()
}

/// Whether a cell shows the same numbers as a printed one, with the same number of digits or fewer.
pub(super) fn shows_printed(cell: &str, printed: &str) -> bool {
    shows(cell, &printed_values(printed))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_in_formatted_cells() {
        let values = |cell| numbers(cell).iter().map(|n| (n.value, n.digits)).collect::<Vec<_>>();
        assert_eq!(values("**1,234** (5.60 MB)"), [(1234.0, 0), (5.6, 2)]);
        assert_eq!(values(".51 / 0.6, 7"), [(0.51, 2), (0.6, 1), (7.0, 0)]);
        assert_eq!(values("1/11.8"), [(1.0, 0), (11.8, 1)]);
        assert_eq!(values("–"), []);
    }

    #[test]
    fn a_value_is_shown_by_its_rounded_number_only() {
        assert!(shows("1.35", &[1.3461]) && !shows("1.35", &[1.3561]));
        assert!(shows("114.1 ± 9.3", &[114.08, 9.31]) && !shows("114.1", &[114.08, 9.31]));
        assert!(shows("", &[3.0]) && shows("–", &[]) && !shows("3", &[]));
        assert!(shows_printed("1.20 (98)", "1.198 (98)") && !shows_printed("1.20 (98)", "1.198 (99)"));
    }

    #[test]
    fn values_are_written_in_the_format_of_the_cell() {
        assert_eq!(with_values("**1,234** (5.60 MB)", &[98765.4, 7.123]).unwrap(), "**98,765** (7.12 MB)");
        assert_eq!(with_values("1/11.8", &[1.0, 9.96]).unwrap(), "1/10.0");
        assert_eq!(with_values(".51, then", &[0.493]).unwrap(), ".49, then");
        assert_eq!(with_values("3", &[1.0, 2.0]), None);
    }

    #[test]
    fn arguments_have_no_formatting() {
        assert_eq!(argument("10,000"), "10000");
        assert_eq!(argument("**dragon**"), "dragon");
        assert_eq!(argument("1, 2 and 3"), "1, 2 and 3");
    }
}
