//! JSON values with their path in the document, for error messages.

use serde_json::Value;

use crate::error::{Fault, Place};

/// Value and its path, such as `meshes[2].primitives[0]`.
#[derive(Clone)]
pub(crate) struct JsonNode<'a> {
    pub value: &'a Value,
    pub path: String,
}

/// Parses the document.
pub(crate) fn parse(bytes: &[u8]) -> Result<Value, Fault> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut root = serde_json::from_slice(bytes).map_err(|error| {
        let line = error.line() as u64;
        Fault::at_line(line, format!("the JSON is not well-formed: {error}"))
    })?;
    drop_nulls(&mut root);
    Ok(root)
}

/// Removes members that are null, as some writers say that there is none, but not from `extras`, which belong
/// to the user. The parser limits the depth.
fn drop_nulls(value: &mut Value) {
    match value {
        Value::Array(entries) => entries.iter_mut().for_each(drop_nulls),
        Value::Object(members) => {
            if members.values().any(Value::is_null) {
                members.retain(|_, value| !value.is_null());
            }
            members.iter_mut().filter(|(key, _)| *key != "extras").for_each(|(_, value)| drop_nulls(value));
        }
        _ => {}
    }
}

impl<'a> JsonNode<'a> {
    /// Creates a fault at this value.
    pub(crate) fn fault(&self, reason: impl Into<String>) -> Fault {
        Fault::Malformed(Place::Json(self.path.clone()), reason.into())
    }

    /// Returns the member of an object, if it exists.
    pub(super) fn get(&self, key: &str) -> Option<JsonNode<'a>> {
        let value = self.value.get(key)?;
        let dot = if self.path.is_empty() { "" } else { "." };
        Some(JsonNode { value, path: format!("{}{dot}{key}", self.path) })
    }

    /// Returns entry `index` of an array of this object; `from` is the value that refers to it.
    pub(super) fn item(&self, array: &str, index: u64, from: &JsonNode<'_>) -> Result<JsonNode<'a>, Fault> {
        let entries = self.value.get(array).and_then(Value::as_array);
        let count = entries.map_or(0, Vec::len);
        match entries.and_then(|entries| entries.get(usize::try_from(index).ok()?)) {
            Some(value) => Ok(JsonNode { value, path: format!("{array}[{index}]") }),
            None => Err(from.fault(format!("{array}[{index}] does not exist: there are {count}"))),
        }
    }

    /// Returns a non-negative integer, if the key exists.
    pub(super) fn unsigned(&self, key: &str) -> Result<Option<u64>, Fault> {
        match self.value.get(key) {
            None => Ok(None),
            // The path is only needed for an error; documents may have a million numbers.
            Some(value) => match whole_number(value) {
                Some(number) => Ok(Some(number)),
                None => self.get(key).map(|at| at.as_unsigned()).transpose(),
            },
        }
    }

    /// Returns the value as a non-negative integer.
    pub(super) fn as_unsigned(&self) -> Result<u64, Fault> {
        let found = whole_number(self.value);
        found.ok_or_else(|| self.fault(format!("expected a whole number, found {}", describe(self.value))))
    }

    /// Returns a non-negative integer; fails if the key is missing.
    pub(super) fn required_unsigned(&self, key: &str) -> Result<u64, Fault> {
        self.unsigned(key)?.ok_or_else(|| self.fault(format!("`{key}` is missing")))
    }

    /// Returns a string, or an empty one if the key is missing.
    pub(super) fn text(&self, key: &str) -> &'a str {
        self.value.get(key).and_then(Value::as_str).unwrap_or("")
    }

    /// Returns a boolean; false if the key is missing.
    pub(super) fn flag(&self, key: &str) -> bool {
        self.value.get(key).and_then(Value::as_bool).unwrap_or(false)
    }

    /// Returns the values of an array without their paths; empty if the key is missing.
    pub(super) fn values(&self, key: &str) -> Result<&'a [Value], Fault> {
        let Some(value) = self.value.get(key) else { return Ok(&[]) };
        let is_no_array = || self.fault(format!("`{key}` must be an array, found {}", describe(value)));
        value.as_array().map(Vec::as_slice).ok_or_else(is_no_array)
    }

    /// Returns the entries of an array; empty if the key is missing.
    pub(crate) fn entries(&self, key: &str) -> Result<Vec<JsonNode<'a>>, Fault> {
        let Some(at) = self.get(key) else { return Ok(Vec::new()) };
        let Some(values) = at.value.as_array() else {
            return Err(at.fault(format!("expected an array, found {}", describe(at.value))));
        };
        let entry = |(i, value)| JsonNode { value, path: format!("{}[{i}]", at.path) };
        Ok(values.iter().enumerate().map(entry).collect())
    }

    /// Returns one entry of an array; fails if it does not exist.
    #[cfg(all(feature = "pieces", not(target_family = "wasm")))]
    pub(crate) fn entry(&self, key: &str, index: usize) -> Result<JsonNode<'a>, Fault> {
        match self.values(key)?.get(index) {
            Some(value) => Ok(JsonNode { value, path: format!("{}.{key}[{index}]", self.path) }),
            None => Err(self.fault(format!("`{key}` has no entry {index}"))),
        }
    }

    /// Returns the members of an object, sorted by name; empty if the key is missing.
    pub(super) fn members(&self, key: &str) -> Result<Vec<(&'a str, JsonNode<'a>)>, Fault> {
        let Some(at) = self.get(key) else { return Ok(Vec::new()) };
        let Some(map) = at.value.as_object() else {
            return Err(at.fault(format!("expected an object, found {}", describe(at.value))));
        };
        let member = |(name, value): (&'a String, _)| {
            (name.as_str(), JsonNode { value, path: format!("{}.{name}", at.path) })
        };
        let mut members: Vec<_> = map.iter().map(member).collect();
        members.sort_by_key(|&(name, _)| name);
        Ok(members)
    }

    /// Returns an array of exactly `N` numbers, if the key exists.
    pub(super) fn numbers<const N: usize>(&self, key: &str) -> Result<Option<[f64; N]>, Fault> {
        let Some(value) = self.value.get(key) else { return Ok(None) };
        let mut numbers = [0.0; N];
        let values = value.as_array().filter(|values| values.len() == N);
        let found = values.and_then(|values| {
            let mut slots = numbers.iter_mut().zip(values);
            slots.try_for_each(|(slot, value)| value.as_f64().map(|number| *slot = number))
        });
        match found {
            Some(()) => Ok(Some(numbers)),
            None => {
                let reason = format!("expected {N} numbers, found {}", describe(value));
                Err(self.get(key).map_or_else(|| self.fault(&reason), |at| at.fault(&reason)))
            }
        }
    }
}

/// Returns a non-negative integer, which may be written as a float.
fn whole_number(value: &Value) -> Option<u64> {
    let whole = |x: f64| (x.fract() == 0.0 && (0.0..9e15).contains(&x)).then_some(x as u64);
    value.as_u64().or_else(|| value.as_f64().and_then(whole))
}

/// Describes a value in a message, shortened.
pub(super) fn describe(value: &Value) -> String {
    match value {
        Value::Array(entries) => format!("an array of {}", entries.len()),
        Value::Object(_) => "an object".to_owned(),
        Value::String(text) => format!("the text `{}`", text.chars().take(40).collect::<String>()),
        other => other.to_string(),
    }
}
