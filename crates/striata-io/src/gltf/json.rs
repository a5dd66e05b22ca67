//! JSON values that know where in the document they stand, so that messages can say it.

use serde_json::Value;

use crate::error::{Fault, Place};

/// A value and its path, as `meshes[2].primitives[0]`.
#[derive(Clone)]
pub(super) struct At<'a> {
    pub value: &'a Value,
    pub path: String,
}

/// Parses the document.
pub(super) fn parse(bytes: &[u8]) -> Result<Value, Fault> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    serde_json::from_slice(bytes).map_err(|error| {
        let line = error.line() as u64;
        Fault::at_line(line, format!("the JSON is not well-formed: {error}"))
    })
}

impl<'a> At<'a> {
    pub(super) fn fault(&self, reason: impl Into<String>) -> Fault {
        Fault::Malformed(Place::Json(self.path.clone()), reason.into())
    }

    pub(super) fn get(&self, key: &str) -> Option<At<'a>> {
        let value = self.value.get(key)?;
        let dot = if self.path.is_empty() { "" } else { "." };
        Some(At { value, path: format!("{}{dot}{key}", self.path) })
    }

    /// A whole number that is not negative, if the key is there.
    pub(super) fn unsigned(&self, key: &str) -> Result<Option<u64>, Fault> {
        self.get(key).map(|at| at.as_unsigned()).transpose()
    }

    pub(super) fn as_unsigned(&self) -> Result<u64, Fault> {
        let whole = |x: f64| (x.fract() == 0.0 && (0.0..9e15).contains(&x)).then_some(x as u64);
        let found = self.value.as_u64().or_else(|| self.value.as_f64().and_then(whole));
        found.ok_or_else(|| self.fault(format!("expected a whole number, found {}", shown(self.value))))
    }

    pub(super) fn needed_unsigned(&self, key: &str) -> Result<u64, Fault> {
        self.unsigned(key)?.ok_or_else(|| self.fault(format!("`{key}` is missing")))
    }

    /// A text; empty where there is none.
    pub(super) fn text(&self, key: &str) -> &'a str {
        self.value.get(key).and_then(Value::as_str).unwrap_or("")
    }

    pub(super) fn flag(&self, key: &str) -> bool {
        self.value.get(key).and_then(Value::as_bool).unwrap_or(false)
    }

    /// The entries of an array; none where the key is missing.
    pub(super) fn entries(&self, key: &str) -> Result<Vec<At<'a>>, Fault> {
        let Some(at) = self.get(key) else { return Ok(Vec::new()) };
        let Some(values) = at.value.as_array() else {
            return Err(at.fault(format!("expected an array, found {}", shown(at.value))));
        };
        let entry = |(i, value)| At { value, path: format!("{}[{i}]", at.path) };
        Ok(values.iter().enumerate().map(entry).collect())
    }

    /// The members of an object in the order of their names; none where the key is missing.
    pub(super) fn members(&self, key: &str) -> Result<Vec<(&'a str, At<'a>)>, Fault> {
        let Some(at) = self.get(key) else { return Ok(Vec::new()) };
        let Some(map) = at.value.as_object() else {
            return Err(at.fault(format!("expected an object, found {}", shown(at.value))));
        };
        let member = |(name, value): (&'a String, _)| {
            (name.as_str(), At { value, path: format!("{}.{name}", at.path) })
        };
        let mut members: Vec<_> = map.iter().map(member).collect();
        members.sort_by_key(|&(name, _)| name);
        Ok(members)
    }

    /// An array of exactly `N` numbers, if the key is there.
    pub(super) fn numbers<const N: usize>(&self, key: &str) -> Result<Option<[f64; N]>, Fault> {
        let Some(at) = self.get(key) else { return Ok(None) };
        let values = at.value.as_array().filter(|values| values.len() == N);
        let numbers: Option<Vec<f64>> = values.and_then(|v| v.iter().map(Value::as_f64).collect());
        match numbers.and_then(|n| <[f64; N]>::try_from(n).ok()) {
            Some(numbers) => Ok(Some(numbers)),
            None => Err(at.fault(format!("expected {N} numbers, found {}", shown(at.value)))),
        }
    }
}

/// A value for a message, cut short.
fn shown(value: &Value) -> String {
    match value {
        Value::Array(entries) => format!("an array of {}", entries.len()),
        Value::Object(_) => "an object".to_owned(),
        Value::String(text) => format!("the text `{}`", text.chars().take(40).collect::<String>()),
        other => other.to_string(),
    }
}
