//! Removal of keyframes that their neighbors imply.

use std::collections::BTreeMap;

use glam::Quat;
use serde_json::{Value, json};

use super::accessor::accessor;
use super::carry::carry;
use super::document::GltfDocument;
use super::extensions::are_all_carried;
use super::references::entries;
use crate::scene::{Scene, SceneError, SceneParts};

/// Most keyframes between two that are kept, unless all values are equal; bounds the work.
const LONGEST_GAP: usize = 256;

/// How a sampler gets the values between two keyframes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Between {
    /// The earlier one.
    Step,
    /// A straight line.
    Line,
    /// The shortest arc of unit quaternions.
    Arc,
}

/// Keyframes of a sampler: a time and some numbers each.
struct Track<'a> {
    times: &'a [f32],
    values: &'a [f32],
    width: usize,
    between: Between,
    tolerance: f32,
}

impl Scene {
    /// Removes keyframes that are within a tolerance of what the kept ones give, and returns the numbers of
    /// keyframes before and after.
    ///
    /// The tolerance is relative to the largest number of a sampler, which is 1 for rotations. Cubic splines stay as
    /// they are. A scene with an unknown extension, which may refer to keyframes, does too.
    ///
    /// # Errors
    /// [`SceneError`] if the data of an animation are damaged.
    pub fn resampled(self, tolerance: f64) -> Result<(Self, [usize; 2]), SceneError> {
        if !are_all_carried(self.document()) {
            return Ok((self, [0, 0]));
        }
        let warnings = self.warnings().to_vec();
        let SceneParts { mut document, mut buffer, images, meshes } = self.into_parts();
        let mut counts = [0, 0];
        let changes = {
            let read = GltfDocument::over(&document, &buffer)?;
            changed_samplers(&read, tolerance, &mut counts)?
        };
        if !changes.is_empty() {
            for (place, samples) in changes {
                for (key, sampled) in ["input", "output"].into_iter().zip(samples) {
                    let number = sampled.added_to(&mut document, &mut buffer);
                    let pointer = format!("/animations/{}/samplers/{}", place[0], place[1]);
                    if let Some(sampler) = document.pointer_mut(&pointer) {
                        sampler[key] = json!(number);
                    }
                }
            }
            let is_geometry: Vec<bool> = meshes.iter().map(Option::is_some).collect();
            let mut root = document.as_object().cloned().unwrap_or_default();
            buffer = carry(&GltfDocument::over(&document, &buffer)?, &mut root, &is_geometry, false)?;
            document = Value::Object(root);
        }
        let scene = Self::from_parts(SceneParts { document, buffer, images, meshes })?;
        Ok((scene.with_warnings(warnings), counts))
    }
}

/// Keyframes that are kept of an accessor.
struct Samples {
    /// The accessor, without its place.
    accessor: Value,
    bytes: Vec<u8>,
}

impl Samples {
    /// Adds the accessor, and returns its number.
    fn added_to(self, document: &mut Value, buffer: &mut Vec<u8>) -> usize {
        let Self { mut accessor, bytes } = self;
        buffer.resize(buffer.len().next_multiple_of(4), 0);
        let view = json!({ "buffer": 0, "byteOffset": buffer.len(), "byteLength": bytes.len() });
        buffer.extend_from_slice(&bytes);
        let mut push = |list: &str, entry: Value| {
            let entries = document[list].as_array_mut().map(|entries| {
                entries.push(entry);
                entries.len() - 1
            });
            entries.unwrap_or_default()
        };
        accessor["bufferView"] = json!(push("bufferViews", view));
        push("accessors", accessor)
    }
}

/// Number of an animation and of a sampler, and its times and values.
type Change = ([usize; 2], [Samples; 2]);

fn changed_samplers(
    document: &GltfDocument<'_>,
    tolerance: f64,
    counts: &mut [usize; 2],
) -> Result<Vec<Change>, crate::error::Fault> {
    let mut changes = Vec::new();
    let mut root = document.root.value.clone();
    for (number, animation) in entries(&mut root, "animations").enumerate() {
        let mut paths: BTreeMap<u64, bool> = BTreeMap::new();
        for channel in entries(animation, "channels") {
            let is_rotation = channel.pointer("/target/path").and_then(Value::as_str) == Some("rotation");
            if let Some(sampler) = channel.get("sampler").and_then(Value::as_u64) {
                *paths.entry(sampler).or_insert(true) &= is_rotation;
            }
        }
        for (place, sampler) in entries(animation, "samplers").enumerate() {
            let between = match sampler.get("interpolation").and_then(Value::as_str) {
                Some("CUBICSPLINE") => continue,
                Some("STEP") => Between::Step,
                _ if paths.get(&(place as u64)) == Some(&true) => Between::Arc,
                _ => Between::Line,
            };
            let numbers = ["input", "output"].map(|key| sampler.get(key).and_then(Value::as_u64));
            let [Some(input), Some(output)] = numbers else { continue };
            let [times, values] = [input, output].map(|number| accessor(document, number, &document.root));
            let (times, values) = (times?, values?);
            let key_count = times.shape.count;
            let per_key = values.shape.count.checked_div(key_count).unwrap_or(0);
            if per_key == 0 || values.shape.count != per_key * key_count {
                continue;
            }
            let (all_times, all_values) = (times.floats(), values.floats());
            let largest = all_values.iter().fold(0.0f32, |most, x| most.max(x.abs()));
            let width = per_key * values.shape.component_count;
            let between = if between == Between::Arc && width != 4 { Between::Line } else { between };
            let tolerance = (tolerance * f64::from(largest)) as f32;
            let track = Track { times: &all_times, values: &all_values, width, between, tolerance };
            let kept = track.kept();
            counts[0] += key_count;
            counts[1] += kept.len();
            if kept.len() == key_count {
                continue;
            }
            let samples = [(input, times, 1), (output, values, per_key)].map(|(number, source, per_key)| {
                let packed = source.packed_bytes();
                let size = packed.len() / source.shape.count.max(1) * per_key;
                let bytes: Vec<u8> =
                    kept.iter().flat_map(|&key| &packed[key * size..][..size]).copied().collect();
                let entries = document.root.value.get("accessors").and_then(Value::as_array);
                let entry = entries.and_then(|entries| entries.get(number as usize));
                let mut accessor = entry.cloned().unwrap_or_default();
                for key in ["bufferView", "byteOffset", "sparse", "min", "max"] {
                    accessor.as_object_mut().map(|members| members.remove(key));
                }
                accessor["count"] = json!(kept.len() * per_key);
                Samples { accessor, bytes }
            });
            let [mut inputs, outputs] = samples;
            // glTF requires the range of times.
            inputs.accessor["min"] = json!([all_times[kept[0]]]);
            inputs.accessor["max"] = json!([all_times[kept[kept.len() - 1]]]);
            changes.push(([number, place], [inputs, outputs]));
        }
    }
    Ok(changes)
}

impl Track<'_> {
    fn value(&self, key: usize) -> &[f32] {
        &self.values[key * self.width..][..self.width]
    }

    /// Returns the keyframes that are kept, from the first.
    fn kept(&self) -> Vec<usize> {
        let count = self.times.len();
        let mut kept = vec![0];
        // Lines between values that are as near as this are within the tolerance of all of them.
        let half = 0.5 * self.tolerance;
        let (mut start, mut is_constant) = (0, true);
        for key in 1..count {
            is_constant &= is_near(self.value(start), self.value(key), half);
            let gap_is_fine = match self.between {
                Between::Step => is_constant,
                _ => is_constant || (key - start <= LONGEST_GAP && self.implies(start, key)),
            };
            if gap_is_fine {
                continue;
            }
            // With steps, a key only ends what is before it.
            start = if self.between == Between::Step { key } else { key - 1 };
            if kept.last() != Some(&start) {
                kept.push(start);
            }
            is_constant = is_near(self.value(start), self.value(key), half);
        }
        // The last keyframe defines the length of the animation.
        if kept.last() != Some(&(count - 1)) {
            kept.push(count - 1);
        }
        kept
    }

    /// Whether the keyframes between two follow from them.
    fn implies(&self, start: usize, end: usize) -> bool {
        let [t0, t1] = [start, end].map(|key| self.times[key]);
        let (a, b) = (self.value(start), self.value(end));
        (start + 1..end).all(|key| {
            let along = (self.times[key] - t0) / (t1 - t0);
            if self.between == Between::Arc {
                let [a, b, found] = [a, b, self.value(key)].map(Quat::from_slice);
                let arc = a.slerp(b, along);
                // Opposite quaternions are the same rotation.
                let arc = if arc.dot(found) < 0.0 { -arc } else { arc };
                return is_near(&arc.to_array(), &found.to_array(), self.tolerance);
            }
            let found = self.value(key);
            let line: Vec<f32> = a.iter().zip(b).map(|(a, b)| a + (b - a) * along).collect();
            is_near(&line, found, self.tolerance)
        })
    }
}

/// Whether values are within a tolerance; false for NaN.
fn is_near(a: &[f32], b: &[f32], tolerance: f32) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
}
