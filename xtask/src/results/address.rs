//! Addresses of values in JSON: `meshes[name=bunny.ply].models[name=mts].bytes / 1000000`.
//!
//! Keys are separated by dots. Brackets after the key of an array select an element, by its index or by the
//! values of some of its keys. A value may be divided by another one or by a number. An address that begins
//! with a dot is relative to `base`.

use anyhow::{Context, Result, ensure};
use serde_json::Value;

/// Returns the values of addresses or numbers that are separated by `+`.
///
/// # Errors
/// If an address does not exist or its value is not a number.
pub(super) fn values(json: &Value, base: &str, addresses: &str) -> Result<Vec<f64>> {
    split(addresses, " + ").into_iter().map(|address| quotient(json, base, address.trim())).collect()
}

fn quotient(json: &Value, base: &str, address: &str) -> Result<f64> {
    match split(address, " / ").as_slice() {
        [above, below] => Ok(number(json, base, above.trim())? / number(json, base, below.trim())?),
        _ => number(json, base, address),
    }
}

fn number(json: &Value, base: &str, address: &str) -> Result<f64> {
    if let Ok(number) = address.parse() {
        return Ok(number);
    }
    let whole = if address.starts_with('.') { format!("{base}{address}") } else { address.to_owned() };
    let address = whole.as_str();
    let mut at = json;
    for segment in split(address, ".") {
        at = step(at, segment).with_context(|| format!("`{segment}` of `{address}` is not in the JSON"))?;
    }
    at.as_f64().with_context(|| format!("`{address}` is not a number in the JSON"))
}

/// Splits text at separators that are not inside brackets.
fn split<'a>(text: &'a str, separator: &str) -> Vec<&'a str> {
    let (mut parts, mut from, mut depth) = (Vec::new(), 0, 0);
    for (at, c) in text.char_indices() {
        match c {
            '[' => depth += 1,
            ']' => depth -= 1,
            _ if depth == 0 && at >= from && text[at..].starts_with(separator) => {
                parts.push(&text[from..at]);
                from = at + separator.len();
            }
            _ => (),
        }
    }
    parts.push(&text[from..]);
    parts
}

fn step<'a>(at: &'a Value, segment: &str) -> Result<&'a Value> {
    let (name, chosen) = match segment.split_once('[') {
        Some((name, chosen)) => (name, chosen.strip_suffix(']')),
        None => (segment, None),
    };
    let value = at.get(name).context("no such key")?;
    let Some(chosen) = chosen else { return Ok(value) };
    let array = value.as_array().context("not an array")?;
    if let Ok(index) = chosen.parse::<usize>() {
        return array.get(index).context("too few elements");
    }
    let mut pairs = Vec::new();
    for pair in chosen.split('&') {
        let (key, wanted) = pair.split_once('=').context("brackets must contain an index or key=value")?;
        pairs.push((key.trim(), wanted.trim()));
    }
    ensure!(!pairs.is_empty(), "empty brackets");
    let is_it = |element: &&Value| pairs.iter().all(|&(key, wanted)| text(element.get(key)) == wanted);
    array.iter().find(is_it).context("no such element")
}

fn text(value: Option<&Value>) -> String {
    match value {
        Some(Value::String(text)) => text.clone(),
        Some(Value::Number(number)) => number.to_string().trim_end_matches(".0").to_owned(),
        Some(other) => other.to_string(),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_give_numbers() {
        let json = serde_json::json!({
            "n": 7,
            "rows": [{ "name": "a.ply", "px": 1.0, "x": [{ "y": 3 }] }, { "name": "b + c / \
             d", "y": 6 }, { "name": "a.ply", "px": 5.0, "x": [{ "y": 4 }] }],
        });
        let one = |address| values(&json, "rows[2]", address).unwrap();
        assert_eq!(one("n"), [7.0]);
        assert_eq!(one("rows[name=a.ply&px=5].x[0].y / 8 + n / n + 1"), [0.5, 1.0, 1.0]);
        assert_eq!(one(".px + .x[0].y"), [5.0, 4.0]);
        assert_eq!(one("rows[name=b + c / d].y"), [6.0]);
        for wrong in ["m", "rows[3].x", "rows[name=b].px", "rows[0].name", "rows"] {
            assert!(values(&json, "", wrong).is_err(), "{wrong}");
        }
    }
}
