//! Uses of accessors, as far as they matter for compression.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::gltf::extensions::are_all_known;
use crate::gltf::passes::parts::{entries, index, index_at};
use crate::gltf::passes::primitives::{PassPrimitive, TRIANGLES};
use crate::gltf::references::{Referent, for_each};

/// Use of an accessor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum AccessorUse {
    /// Attribute or morph target of vertices.
    Vertices,
    /// Indices of single triangles.
    Triangles,
    /// Indices of strips or fans.
    Strips,
    /// Anything else.
    Other,
}

/// Role of an accessor that can be compressed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct AccessorRole {
    pub usage: AccessorUse,
    /// Name of the use, such as `NORMAL` or `time`; accessors in the same view have the same name.
    pub name: String,
    /// Whether only triangles use it, so that its order is free.
    pub is_free: bool,
}

/// Returns the roles of accessors; [`None`] for those that must stay as they are.
pub(super) fn roles(root: &Value, primitives: &[PassPrimitive]) -> BTreeMap<u64, Option<AccessorRole>> {
    let mut collector = Collector::default();
    for primitive in primitives {
        collector.primitive(primitive);
    }
    for skin in entries(root, "skins") {
        collector.add(skin.get("inverseBindMatrices"), AccessorUse::Other, "matrices");
    }
    for animation in entries(root, "animations") {
        let paths = animated_paths(animation);
        for (number, sampler) in entries(animation, "samplers").iter().enumerate() {
            collector.add(sampler.get("input"), AccessorUse::Other, "time");
            let name = format!("animated {}", paths.get(&number).unwrap_or(&""));
            collector.add(sampler.get("output"), AccessorUse::Other, &name);
        }
    }
    for node in entries(root, "nodes") {
        let attributes = node.pointer("/extensions/EXT_mesh_gpu_instancing/attributes");
        for value in attributes.and_then(Value::as_object).into_iter().flat_map(|map| map.values()) {
            collector.add(Some(value), AccessorUse::Other, "instances");
        }
    }
    collector.checked(root)
}

/// Returns the property that the first channel of each sampler of an animation changes.
fn animated_paths(animation: &Value) -> BTreeMap<usize, &str> {
    let mut paths = BTreeMap::new();
    for channel in entries(animation, "channels") {
        let Some(sampler) = index_at(channel, "sampler") else { continue };
        let path = channel.pointer("/target/path").and_then(Value::as_str);
        paths.entry(sampler).or_insert(path.unwrap_or_default());
    }
    paths
}

/// Roles found so far, and the number of uses that they explain.
#[derive(Default)]
struct Collector {
    roles: BTreeMap<u64, Option<AccessorRole>>,
    counts: BTreeMap<u64, usize>,
}

impl Collector {
    fn primitive(&mut self, primitive: &PassPrimitive) {
        let is_packed = primitive.extensions.iter().any(|name| name == "KHR_draco_mesh_compression");
        let is_free = primitive.has_triangles() && !is_packed;
        let targets = primitive.targets.iter().flatten();
        let targets = targets.map(|(name, accessor)| (format!("target {name}"), accessor));
        let attributes = primitive.attributes.iter().map(|(name, accessor)| (name.clone(), accessor));
        for (name, &accessor) in attributes.chain(targets) {
            let name = name.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned();
            self.put(accessor, AccessorRole { usage: AccessorUse::Vertices, name, is_free });
        }
        if let Some(indices) = primitive.indices {
            let usage =
                if primitive.mode == TRIANGLES { AccessorUse::Triangles } else { AccessorUse::Strips };
            self.put(indices, AccessorRole { usage, name: "indices".to_owned(), is_free });
        }
    }

    fn add(&mut self, reference: Option<&Value>, usage: AccessorUse, name: &str) {
        if let Some(accessor) = reference.and_then(index) {
            self.put(accessor, AccessorRole { usage, name: name.to_owned(), is_free: true });
        }
    }

    fn put(&mut self, accessor: u64, role: AccessorRole) {
        *self.counts.entry(accessor).or_default() += 1;
        match self.roles.get_mut(&accessor) {
            None => {
                self.roles.insert(accessor, Some(role));
            }
            Some(known) => *known = known.take().and_then(|known| known.joined(role)),
        }
    }

    /// Leaves out accessors with other uses, or without any by triangles.
    fn checked(mut self, root: &Value) -> BTreeMap<u64, Option<AccessorRole>> {
        let mut copy = root.clone();
        let mut counts: BTreeMap<u64, usize> = BTreeMap::new();
        for_each(&mut copy, |referent, value| {
            if let (Referent::Accessor(_), Some(accessor)) = (referent, index(value)) {
                *counts.entry(accessor).or_default() += 1;
            }
        });
        let is_closed = are_all_known(root);
        for (accessor, role) in &mut self.roles {
            let is_explained = self.counts.get(accessor) == counts.get(accessor);
            *role = role.take().filter(|_| is_explained);
            if let Some(role) = role {
                role.is_free &= is_closed;
            }
        }
        self.roles
    }
}

impl AccessorRole {
    /// Returns the role of an accessor with two uses; [`None`] if they are too different.
    fn joined(self, other: Self) -> Option<Self> {
        let is_same = self.usage == other.usage;
        let name = if self.name == other.name { self.name } else { "several".to_owned() };
        is_same.then_some(Self { usage: self.usage, name, is_free: self.is_free && other.is_free })
    }
}
