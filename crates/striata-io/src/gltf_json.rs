//! glTF objects that a mesh carries as JSON text.

use std::collections::BTreeSet;

use serde_json::Value;

/// Collects the names of all extensions used within a value.
pub(crate) fn extensions_in(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(map) => {
            if let Some(Value::Object(extensions)) = map.get("extensions") {
                found.extend(extensions.keys().cloned());
            }
            map.values().for_each(|value| extensions_in(value, found));
        }
        Value::Array(entries) => entries.iter().for_each(|value| extensions_in(value, found)),
        _ => {}
    }
}

/// Returns a number as JSON with the fewest digits that read back as the same `f32`.
#[cfg(feature = "obj")]
pub(crate) fn number(value: f32) -> Value {
    let shortest: f64 = value.to_string().parse().unwrap_or(0.0);
    serde_json::Number::from_f64(shortest).map_or(Value::from(0), Value::Number)
}
