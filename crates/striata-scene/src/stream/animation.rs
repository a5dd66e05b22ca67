//! Precision of animations: outputs are rounded as far as the tolerance of the scene allows.
//!
//! Translations are rounded to the tolerance in the space of their node, and rotations, scales and weights of
//! morph targets to the same share of one as the tolerance is of the scene's longest side. Steps are powers
//! of two, so rounded floats are exact multiples and are stored as small integers (see `buffer.rs`). Times,
//! cubic splines, integers, and accessors that anything else uses stay exact.

use std::collections::BTreeMap;

use serde_json::Value;
use striata_io::Scene;

use super::accessors::place_of;
use super::motion::node_stretch;
use crate::document::{entries, index};

/// Rounds the outputs of animations in a copy of the scene's buffer. `tolerance` and `side`, the longest side
/// of the scene, are in its units.
///
/// Their minima and maxima, which are optional, are removed from the document.
pub(super) fn round_animations(scene: &Scene, tolerance: f64, side: f64) -> (Value, Vec<u8>) {
    let (mut document, mut buffer) = (scene.document().clone(), scene.buffer().to_vec());
    for (accessor, step) in steps(scene, tolerance, side) {
        let Some(place) = place_of(&document, &entries(&document, "accessors")[accessor], buffer.len())
        else {
            continue;
        };
        let (words, _) = buffer[place.bytes].as_chunks_mut::<4>();
        for word in words {
            *word = rounded(f32::from_le_bytes(*word), step).to_le_bytes();
        }
        if let Some(Value::Object(entry)) = document.pointer_mut(&format!("/accessors/{accessor}")) {
            entry.remove("min");
            entry.remove("max");
        }
    }
    (document, buffer)
}

/// Returns the multiple of a power of two that is nearest to a number; numbers for which floats are coarser
/// than that stay as they are.
fn rounded(number: f32, step: f32) -> f32 {
    let multiple = number / step;
    if multiple.abs() < (1 << 23) as f32 { (multiple.round() * step) + 0.0 } else { number }
}

/// Returns the step of each accessor that may be rounded.
fn steps(scene: &Scene, tolerance: f64, side: f64) -> BTreeMap<usize, f32> {
    let document = scene.document();
    let stretch = node_stretch(document);
    let mut steps: BTreeMap<usize, Option<f32>> = BTreeMap::new();
    for animation in entries(document, "animations") {
        let samplers = entries(animation, "samplers");
        for channel in entries(animation, "channels") {
            let Some(sampler) = index(channel, "sampler").and_then(|sampler| samplers.get(sampler)) else {
                continue;
            };
            let Some(output) = index(sampler, "output") else { continue };
            let step = channel.get("target").and_then(|target| {
                let largest = match target.get("path")?.as_str()? {
                    "translation" => tolerance / stretch.get(index(target, "node")?)?,
                    "rotation" | "scale" | "weights" => tolerance / side,
                    _ => return None,
                };
                power_of_two(largest)
            });
            let is_spline = sampler.get("interpolation").and_then(Value::as_str) == Some("CUBICSPLINE");
            let step = step.filter(|_| !is_spline);
            let slot = steps.entry(output).or_insert(step);
            *slot = slot.zip(step).map(|(a, b)| a.min(b));
        }
    }
    let is_alone = others_than_outputs(document, scene.buffer().len(), &steps);
    steps
        .into_iter()
        .filter(|(accessor, _)| is_alone(*accessor))
        .filter_map(|(a, step)| Some((a, step?)))
        .collect()
}

/// Returns a test whether no other accessor shares the bytes of an accessor of floats.
fn others_than_outputs<'d>(
    document: &'d Value,
    buffer_bytes: usize,
    outputs: &BTreeMap<usize, Option<f32>>,
) -> impl Fn(usize) -> bool + use<'d> {
    let accessors = entries(document, "accessors");
    let inputs = entries(document, "animations").iter().flat_map(|animation| entries(animation, "samplers"));
    let inputs: Vec<usize> = inputs.filter_map(|sampler| index(sampler, "input")).collect();
    let mut places: Vec<(usize, usize, usize)> = Vec::new();
    for (number, accessor) in accessors.iter().enumerate() {
        let Some(place) = place_of(document, accessor, buffer_bytes) else { continue };
        places.push((place.bytes.start, place.bytes.end, number));
    }
    places.sort_unstable();
    let mut is_alone = vec![false; accessors.len()];
    let mut end_before = 0;
    for (at, &(start, end, number)) in places.iter().enumerate() {
        let next = places.get(at + 1).map_or(usize::MAX, |next| next.0);
        let is_float = index(&accessors[number], "componentType") == Some(5126);
        let is_dense = accessors[number].get("sparse").is_none();
        is_alone[number] =
            start >= end_before && end <= next && is_float && is_dense && outputs.contains_key(&number);
        end_before = end_before.max(end);
    }
    inputs.into_iter().for_each(|input| is_alone.get_mut(input).into_iter().for_each(|slot| *slot = false));
    // Views may interleave accessors.
    for (number, accessor) in accessors.iter().enumerate() {
        let view = super::json::referred(document, "bufferViews", accessor, "bufferView");
        if view.is_some_and(|view| view.get("byteStride").is_some()) {
            is_alone[number] = false;
        }
    }
    move |accessor| is_alone.get(accessor).copied().unwrap_or(false)
}

/// Returns the largest power of two that is not larger; [`None`] if floats cannot use it as a step.
fn power_of_two(number: f64) -> Option<f32> {
    let float = number as f32;
    let power = f32::from_bits(float.to_bits() & 0x7f80_0000);
    (float.is_normal() && float > 0.0 && (1e-30..1e30).contains(&power)).then_some(power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_moves_numbers_by_half_a_step_at_most() {
        let step = power_of_two(0.001).unwrap();
        assert_eq!(step, 1.0 / 1024.0);
        for i in -1000..1000 {
            let number = i as f32 * 0.003_77;
            let there = rounded(number, step);
            assert!((there - number).abs() <= 0.5 * step);
            assert_eq!((there / step).fract(), 0.0);
            assert!(there != 0.0 || there.is_sign_positive());
        }
        assert_eq!(rounded(1e20, step), 1e20);
        assert!(rounded(f32::NAN, step).is_nan());
        assert_eq!(
            (power_of_two(0.0), power_of_two(f64::NAN), power_of_two(f64::INFINITY)),
            (None, None, None)
        );
    }
}
