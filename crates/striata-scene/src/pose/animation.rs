//! Animations: keys of node transforms and morph weights.

use std::sync::Arc;

use glam::DQuat;
use serde_json::Value;
use striata_io::SceneError;

use super::interpolation::{along_arc, cubic};
use super::numbers::{AccessorNumbers, index};
use crate::document::entries;

/// Property of a node that a channel changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ChannelProperty {
    Translation,
    Rotation,
    Scale,
    MorphWeights,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Interpolation {
    Step,
    Linear,
    CubicSpline,
}

/// Keys of one property of a node.
#[derive(Clone, Debug)]
pub(super) struct Channel {
    pub node: usize,
    pub property: ChannelProperty,
    interpolation: Interpolation,
    /// Seconds, ascending.
    times: Arc<[f32]>,
    /// Values of all keys; three for each key of a spline: tangent, value, tangent.
    values: Arc<[f32]>,
    /// Numbers in a value.
    width: usize,
    /// Numbers in a value that matter: weights beyond the morph targets of a mesh do not.
    used: usize,
}

/// An animation; channels of unknown kinds are left out.
#[derive(Clone, Debug)]
pub(super) struct Animation {
    pub name: String,
    pub channels: Vec<Channel>,
}

impl Animation {
    pub(super) fn read(
        at: &Value,
        accessors: &mut AccessorNumbers<'_>,
        target_counts: &[usize],
    ) -> Result<Self, SceneError> {
        let samplers = entries(at, "samplers");
        let mut channels = Vec::new();
        for channel in entries(at, "channels") {
            let node = channel
                .pointer("/target/node")
                .and_then(index)
                .and_then(|node| Some((node, *target_counts.get(node)?)));
            let sampler = channel.get("sampler").and_then(index).and_then(|sampler| samplers.get(sampler));
            let property = match channel.pointer("/target/path").and_then(Value::as_str) {
                Some("translation") => ChannelProperty::Translation,
                Some("rotation") => ChannelProperty::Rotation,
                Some("scale") => ChannelProperty::Scale,
                Some("weights") => ChannelProperty::MorphWeights,
                _ => continue,
            };
            if let (Some((node, target_count)), Some(sampler)) = (node, sampler) {
                channels.extend(Channel::read(sampler, accessors, node, property, target_count)?);
            }
        }
        let name = at.get("name").and_then(Value::as_str).unwrap_or_default().to_owned();
        Ok(Self { name, channels })
    }

    /// Time of the last key, in seconds.
    pub(super) fn duration(&self) -> f32 {
        let ends = self.channels.iter().filter_map(|channel| channel.times.last());
        ends.copied().filter(|time| time.is_finite()).fold(0.0, f32::max)
    }
}

impl Channel {
    /// Reads a channel; [`None`] if it has no keys, or too few values for them.
    fn read(
        sampler: &Value,
        accessors: &mut AccessorNumbers<'_>,
        node: usize,
        property: ChannelProperty,
        target_count: usize,
    ) -> Result<Option<Self>, SceneError> {
        let accessor = |key| sampler.get(key).and_then(Value::as_u64);
        let (Some(input), Some(output)) = (accessor("input"), accessor("output")) else { return Ok(None) };
        let (times, _) = accessors.read(input)?;
        let (values, _) = accessors.read(output)?;
        let interpolation = match sampler.get("interpolation").and_then(Value::as_str) {
            Some("STEP") => Interpolation::Step,
            Some("CUBICSPLINE") => Interpolation::CubicSpline,
            _ => Interpolation::Linear,
        };
        let per_key = if interpolation == Interpolation::CubicSpline { 3 } else { 1 };
        let width = match property {
            ChannelProperty::Translation | ChannelProperty::Scale => 3,
            ChannelProperty::Rotation => 4,
            ChannelProperty::MorphWeights => values.len() / (times.len() * per_key).max(1),
        };
        let is_enough = values.len() >= times.len() * per_key * width;
        if times.is_empty() || width == 0 || !is_enough {
            return Ok(None);
        }
        let used = if property == ChannelProperty::MorphWeights { width.min(target_count) } else { width };
        Ok(Some(Self { node, property, interpolation, times, values, width, used }))
    }

    /// Returns the value at a time.
    pub(super) fn value(&self, time: f32) -> Vec<f64> {
        let next = self.times.partition_point(|&key| key <= time);
        let last = self.times.len() - 1;
        if next == 0 || next > last {
            return self.key(next.saturating_sub(1).min(last)).collect();
        }
        let (before, after) = (self.times[next - 1], self.times[next]);
        let duration = f64::from(after) - f64::from(before);
        let share = if duration > 0.0 { (f64::from(time) - f64::from(before)) / duration } else { 0.0 };
        match self.interpolation {
            Interpolation::Step => self.key(next - 1).collect(),
            Interpolation::Linear if self.property == ChannelProperty::Rotation => {
                let rotation = |key| {
                    let mut q = [0.0; 4];
                    q.iter_mut().zip(self.key(key)).for_each(|(slot, x)| *slot = x);
                    DQuat::from_array(q).normalize()
                };
                along_arc(rotation(next - 1), rotation(next), share).to_array().to_vec()
            }
            Interpolation::Linear => {
                self.key(next - 1).zip(self.key(next)).map(|(a, b)| a + share * (b - a)).collect()
            }
            Interpolation::CubicSpline => (0..self.used)
                .map(|component| {
                    let at = |key: usize, part: usize| {
                        f64::from(self.values[(key * 3 + part) * self.width + component])
                    };
                    let tangents = [at(next - 1, 2) * duration, at(next, 0) * duration];
                    cubic(share, [at(next - 1, 1), at(next, 1)], tangents)
                })
                .collect(),
        }
    }

    /// Returns the value of a key.
    fn key(&self, key: usize) -> impl Iterator<Item = f64> {
        let first = match self.interpolation {
            Interpolation::CubicSpline => (key * 3 + 1) * self.width,
            _ => key * self.width,
        };
        self.values[first..first + self.used].iter().map(|&x| f64::from(x))
    }
}
