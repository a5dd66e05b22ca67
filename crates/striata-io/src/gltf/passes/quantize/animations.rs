//! Rounding of keyframes.
//!
//! Rotations become normalized 16-bit integers, which glTF allows everywhere. If `meshopt` follows, times and moves
//! become multiples of powers of two, which it stores as integers. Cubic splines stay as they are, because their
//! tangents may be of any length.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::changes::{DocumentChanges, Texcoords};
use super::convert;
use crate::QuantizeOptions;
use crate::gltf::accessor::accessor;
use crate::gltf::component_type::GltfComponentType;
use crate::gltf::document::GltfDocument;
use crate::gltf::passes::additions::ViewKind;
use crate::gltf::passes::elements::Elements;
use crate::gltf::passes::parts::{entries, index, index_at};
use crate::gltf::references::{Referent, for_each};

/// Times are rounded to 1/4096 s.
const TIME_CELLS: f32 = 4096.0;

/// Bits of a move along the axis of the largest.
const MOVE_BITS: i32 = 16;

/// How the numbers of an accessor are rounded; [`None`] if its uses contradict each other.
type Rules = BTreeMap<u64, Option<ChannelRule>>;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ChannelRule {
    Time,
    Rotation,
    Move,
}

/// Rounds the keyframes of all animations.
pub(super) fn quantize(
    document: &GltfDocument<'_>,
    options: &QuantizeOptions,
    texcoords: Texcoords,
    changes: &mut DocumentChanges<'_>,
) {
    let is_packed = texcoords == Texcoords::Floats;
    for (number, rule) in rules(document) {
        let Some(rule) = rule.filter(|rule| is_packed || *rule == ChannelRule::Rotation) else { continue };
        let Ok(source) = accessor(document, number, &document.root) else { continue };
        if source.component != GltfComponentType::F32 || source.count == 0 {
            continue;
        }
        let numbers = source.floats();
        // The filter of `meshopt` rounds once more.
        let bits = if is_packed { 16 } else { options.rotation_bits };
        let elements = match rule {
            ChannelRule::Time => times(&numbers),
            ChannelRule::Move => moves(&numbers, source.component_count),
            ChannelRule::Rotation if source.component_count == 4 => {
                convert::signed_fractions(&turned(&numbers), 4, bits.clamp(9, 16))
            }
            ChannelRule::Rotation => None,
        };
        let (Some(elements), Ok(old)) = (elements, document.item("accessors", number, &document.root)) else {
            continue;
        };
        let mut accessor = elements.accessor();
        if let Some(name) = old.get("name") {
            accessor["name"] = name.value.clone();
        }
        if rule == ChannelRule::Time {
            elements.declare_bounds(&mut accessor);
        }
        let kind = ViewKind::of_others(&format!("{rule:?}"), &elements);
        let new = changes.additions.push(kind, &elements, accessor);
        changes.replaced.insert(number);
        refer(changes.root, number, new);
    }
}

/// Finds the accessors that only keyframes use.
fn rules(document: &GltfDocument<'_>) -> Rules {
    let mut rules = Rules::new();
    let mut add = |number: Option<u64>, rule: Option<ChannelRule>| {
        if let Some(number) = number {
            let known = rules.entry(number).or_insert(rule);
            *known = known.filter(|known| Some(*known) == rule);
        }
    };
    for animation in entries(document.root.value, "animations") {
        let mut paths: BTreeMap<usize, Option<ChannelRule>> = BTreeMap::new();
        for channel in entries(animation, "channels") {
            let rule = match channel.pointer("/target/path").and_then(Value::as_str) {
                Some("rotation") => Some(ChannelRule::Rotation),
                Some("translation" | "scale") => Some(ChannelRule::Move),
                _ => None,
            };
            if let Some(sampler) = index_at(channel, "sampler") {
                let known = paths.entry(sampler).or_insert(rule);
                *known = known.filter(|known| Some(*known) == rule);
            }
        }
        for (place, sampler) in entries(animation, "samplers").iter().enumerate() {
            let is_spline = sampler.get("interpolation").and_then(Value::as_str) == Some("CUBICSPLINE");
            let rule = paths.get(&place).copied().flatten().filter(|_| !is_spline);
            add(sampler.get("input").and_then(index), Some(ChannelRule::Time));
            add(sampler.get("output").and_then(index), rule);
        }
    }
    let mut copy = document.root.value.clone();
    let mut counts: BTreeMap<u64, [usize; 2]> = BTreeMap::new();
    for_each(&mut copy, |referent, value| {
        if let (Referent::Accessor(usage), Some(number)) = (referent, index(value)) {
            let is_other = usage != crate::gltf::references::Use::Animation;
            counts.entry(number).or_default()[usize::from(is_other)] += 1;
        }
    });
    rules.retain(|number, _| counts.get(number).is_some_and(|[_, others]| *others == 0));
    rules
}

/// Rounds times; [`None`] if two would become equal.
fn times(numbers: &[f32]) -> Option<Elements> {
    let rounded: Vec<f32> = numbers.iter().map(|x| (x * TIME_CELLS).round() / TIME_CELLS).collect();
    let is_fit = rounded.iter().all(|x| x.is_finite()) && rounded.array_windows().all(|[a, b]| a < b);
    is_fit.then(|| Elements::floats(&rounded, 1))
}

/// Rounds lengths to a power of two, relative to the largest.
fn moves(numbers: &[f32], width: usize) -> Option<Elements> {
    let largest = numbers.iter().fold(0.0f32, |most, x| most.max(x.abs()));
    if !largest.is_finite() || largest < f32::MIN_POSITIVE * 65536.0 {
        return None;
    }
    let step = f64::exp2(f64::from(largest.log2().ceil() as i32 - MOVE_BITS));
    let rounded = numbers.iter().map(|&x| ((f64::from(x) / step).round() * step) as f32);
    Some(Elements::floats(&rounded.collect::<Vec<_>>(), width))
}

/// Replaces quaternions by their opposites where that makes them nearer to the one before; they turn alike.
fn turned(numbers: &[f32]) -> Vec<f32> {
    let mut out = numbers.to_vec();
    let keys = out.as_chunks_mut::<4>().0;
    for key in 1..keys.len() {
        let dot: f32 = keys[key - 1].iter().zip(&keys[key]).map(|(a, b)| a * b).sum();
        if dot < 0.0 {
            keys[key] = keys[key].map(|x| -x);
        }
    }
    out
}

/// Replaces an accessor in the samplers of all animations.
fn refer(root: &mut Value, old: u64, new: usize) {
    for animation in crate::gltf::references::entries(root, "animations") {
        for sampler in crate::gltf::references::entries(animation, "samplers") {
            for key in ["input", "output"] {
                if sampler.get(key).and_then(index) == Some(old) {
                    sampler[key] = json!(new);
                }
            }
        }
    }
}
