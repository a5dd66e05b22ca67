//! Access to the JSON of documents; whatever has the wrong type counts as absent.

use serde_json::Value;

/// Returns an extension of an object.
pub(super) fn extension<'v>(value: &'v Value, name: &str) -> Option<&'v Value> {
    value.get("extensions")?.get(name)
}

/// Returns a member that is a finite number.
pub(super) fn number(value: &Value, key: &str) -> Option<f32> {
    let number = value.get(key)?.as_f64()? as f32;
    number.is_finite().then_some(number)
}

/// Returns a member that is an array of finite numbers of this length.
pub(super) fn numbers<const COUNT: usize>(value: &Value, key: &str) -> Option<[f32; COUNT]> {
    let found = value.get(key)?.as_array()?;
    let found: Vec<f32> = found.iter().map(|x| x.as_f64().map(|x| x as f32)).collect::<Option<_>>()?;
    <[f32; COUNT]>::try_from(found).ok().filter(|found| found.iter().all(|x| x.is_finite()))
}
