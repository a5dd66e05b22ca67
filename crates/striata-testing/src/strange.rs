//! glTF documents whose values are changed as random bytes say: changes of the text would rarely leave it
//! well-formed.

use serde_json::{Value, json};

/// Reads choices from the front of random bytes; zeros once they are used up.
struct Choices<'a>(&'a [u8]);

impl Choices<'_> {
    fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    /// Returns a number of two bytes.
    fn short(&mut self) -> usize {
        usize::from(self.byte()) | usize::from(self.byte()) << 8
    }
}

/// A glTF document and its only buffer.
#[derive(Clone, Debug)]
pub struct StrangeParts {
    pub document: Value,
    pub buffer: Vec<u8>,
}

/// Largest number of changes of one input.
const MAX_CHANGES: usize = 64;

impl StrangeParts {
    /// Splits a GLB file, which must be valid, into its parts.
    pub fn of_glb(glb: &[u8]) -> Self {
        let length = |at: usize| {
            glb.get(at..)
                .and_then(|rest| rest.first_chunk::<4>())
                .map_or(0, |bytes| u32::from_le_bytes(*bytes) as usize)
        };
        let json = length(12);
        let binary = 20 + json;
        let document = serde_json::from_slice(&glb[20..binary]).expect("the file is our own");
        Self { document, buffer: glb.get(binary + 8..).unwrap_or_default().to_vec() }
    }

    /// Encodes the parts as a GLB file.
    pub fn to_glb(&self) -> Vec<u8> {
        let mut buffer = self.buffer.clone();
        buffer.resize(buffer.len().next_multiple_of(4), 0);
        let mut text = self.document.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        glb_of_chunks(&text, &buffer)
    }

    /// Changes values of the document and bytes of the buffer, until the input is used up.
    pub fn change(&mut self, input: &[u8]) {
        let input = &mut Choices(input);
        for _ in 0..MAX_CHANGES {
            if input.0.is_empty() {
                break;
            }
            match input.byte() % 8 {
                0 => self.change_bytes(input),
                1 => self.copy_value(input),
                2 => self.remove_value(input),
                3 => self.rename_member(input),
                _ => {
                    let place = input.short() % count(&self.document);
                    if let Some(slot) = value_at(&mut self.document, &mut { place }) {
                        *slot = strange(input, slot);
                    }
                }
            }
        }
    }

    fn change_bytes(&mut self, input: &mut Choices<'_>) {
        const FLOATS: [f32; 6] = [f32::NAN, f32::INFINITY, f32::MAX, -0.0, 1e-40, -1.0];
        let (place, value) = (input.short(), input.byte());
        if self.buffer.len() < 4 {
            return;
        }
        let at = place % self.buffer.len();
        match FLOATS.get(usize::from(value) / 4).filter(|_| value % 4 == 0) {
            Some(float) => {
                let at = (at & !3).min(self.buffer.len() - 4);
                self.buffer[at..at + 4].copy_from_slice(&float.to_le_bytes());
            }
            None => self.buffer[at] = value,
        }
    }

    fn copy_value(&mut self, input: &mut Choices<'_>) {
        let count = count(&self.document);
        let (from, to) = (input.short() % count, input.short() % count);
        let copy = value_at(&mut self.document, &mut { from }).cloned().unwrap_or_default();
        // Copies of large parts into themselves would double the document each time.
        if self::count(&copy) > 200 {
            return;
        }
        if let Some(slot) = value_at(&mut self.document, &mut { to }) {
            match slot {
                Value::Array(entries) if input.byte().is_multiple_of(2) => entries.push(copy),
                slot => *slot = copy,
            }
        }
    }

    fn remove_value(&mut self, input: &mut Choices<'_>) {
        let (place, entry) = (input.short() % count(&self.document), usize::from(input.byte()));
        match value_at(&mut self.document, &mut { place }) {
            Some(Value::Array(entries)) if !entries.is_empty() => {
                entries.remove(entry % entries.len());
            }
            Some(Value::Object(members)) => {
                let key = members.keys().nth(entry % members.len().max(1)).cloned();
                key.and_then(|key| members.remove(&key));
            }
            _ => {}
        }
    }

    fn rename_member(&mut self, input: &mut Choices<'_>) {
        const KEYS: [&str; 24] = [
            "children",
            "mesh",
            "skin",
            "weights",
            "matrix",
            "rotation",
            "scale",
            "translation",
            "sparse",
            "byteStride",
            "byteOffset",
            "normalized",
            "mode",
            "targets",
            "indices",
            "JOINTS_0",
            "WEIGHTS_0",
            "COLOR_0",
            "extensions",
            "EXT_mesh_gpu_instancing",
            "attributes",
            "ROTATION",
            "SCALE",
            "uri",
        ];
        let (place, entry) = (input.short() % count(&self.document), usize::from(input.byte()));
        let key = KEYS[usize::from(input.byte()) % KEYS.len()];
        if let Some(Value::Object(members)) = value_at(&mut self.document, &mut { place }) {
            let old = members.keys().nth(entry % members.len().max(1)).cloned();
            let value = old.and_then(|old| members.remove(&old)).unwrap_or(Value::Null);
            members.insert(key.to_owned(), value);
        }
    }
}

/// Encodes the chunks of a GLB file as they are.
pub fn glb_of_chunks(text: &[u8], buffer: &[u8]) -> Vec<u8> {
    let mut out = b"glTF\x02\0\0\0".to_vec();
    out.extend((28 + text.len() as u32 + buffer.len() as u32).to_le_bytes());
    for (kind, bytes) in [(b"JSON", text), (b"BIN\0", buffer)] {
        out.extend((bytes.len() as u32).to_le_bytes());
        out.extend(kind);
        out.extend(bytes);
    }
    out
}

/// Returns a value that a document does not expect, or another number.
fn strange(input: &mut Choices<'_>, old: &Value) -> Value {
    const TEXTS: [&str; 15] = [
        "SCALAR",
        "VEC2",
        "VEC3",
        "VEC4",
        "MAT4",
        "STEP",
        "CUBICSPLINE",
        "weights",
        "rotation",
        "../x",
        "data:,A",
        "OCTAHEDRAL",
        "QUATERNION",
        "TRIANGLES",
        "INDICES",
    ];
    match input.byte() % 24 {
        0 => json!(null),
        1 => json!(-1),
        2 => json!(0.5),
        3 => json!(1e30),
        4 => json!(-1e300),
        5 => json!(u64::MAX),
        6 => json!(1u64 << 31),
        7 => json!(1u64 << 40),
        8 => json!([]),
        9 => json!({}),
        10 => json!([{}, 3]),
        11 => json!({ "POSITION": 1 }),
        12 => json!(true),
        13 => json!(5120 + u64::from(input.byte() % 8)),
        14 => json!([old, old]),
        15 => json!(TEXTS[usize::from(input.byte()) % TEXTS.len()]),
        16 => json!(input.short()),
        17 => json!(old.as_u64().unwrap_or(0).wrapping_add(1)),
        18 => json!(old.as_u64().unwrap_or(0).wrapping_sub(1)),
        _ => json!(input.byte() % 16),
    }
}

/// Returns the number of values in a document.
fn count(value: &Value) -> usize {
    1 + match value {
        Value::Array(entries) => entries.iter().map(count).sum(),
        Value::Object(members) => members.values().map(count).sum(),
        _ => 0,
    }
}

/// Returns value number `place` of a document, counted in depth-first order.
fn value_at<'a>(value: &'a mut Value, place: &mut usize) -> Option<&'a mut Value> {
    if *place == 0 {
        return Some(value);
    }
    *place -= 1;
    match value {
        Value::Array(entries) => entries.iter_mut().find_map(|entry| value_at(entry, place)),
        Value::Object(members) => members.values_mut().find_map(|member| value_at(member, place)),
        _ => None,
    }
}
