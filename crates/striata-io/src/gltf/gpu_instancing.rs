//! Instances of `EXT_mesh_gpu_instancing`: a node that shows its mesh several times.
//!
//! Each instance has a translation, rotation and scale of its own, which come before the transform of the
//! node. Accessors may be shared by nodes, and zeros take no bytes in a file, so the number of instances is
//! limited by the size of the file. A skinned mesh has the place of its joints, and is shown once.

use glam::{DMat4, DQuat, DVec3};

use super::accessor::{Accessor, accessor};
use super::document::GltfDocument;
use super::json::JsonNode;
use crate::error::Fault;

/// Name of the extension.
const EXTENSION: &str = "EXT_mesh_gpu_instancing";

/// Instances that a document may have regardless of its size.
const ALWAYS_ALLOWED: u64 = 1 << 18;

/// Bytes of the document and its buffers for each instance more, if all are kept in memory anyway.
pub(super) const BYTES_PER_INSTANCE: u64 = 4;

/// Reads the instances of nodes, and limits their number.
pub(super) struct GpuInstances {
    count: u64,
    bytes_per_instance: u64,
}

/// Accessors of the places of instances; a missing one means the identity.
struct InstanceAccessors<'d> {
    translation: Option<Accessor<'d>>,
    rotation: Option<Accessor<'d>>,
    scale: Option<Accessor<'d>>,
}

/// Whether a node has instances of its own.
pub(super) fn is_instanced(node: &JsonNode<'_>) -> bool {
    attributes(node).is_some() && node.get("skin").is_none()
}

fn attributes<'a>(node: &JsonNode<'a>) -> Option<JsonNode<'a>> {
    node.get("extensions")?.get(EXTENSION)?.get("attributes")
}

impl GpuInstances {
    /// Allows one instance for each `bytes_per_instance` bytes of the document and its buffers, besides a fixed
    /// number.
    pub(super) fn new(bytes_per_instance: u64) -> Self {
        Self { count: 0, bytes_per_instance }
    }

    /// Returns the transforms from the mesh to the node; a single [`None`] if the node has no instances of
    /// its own.
    pub(super) fn of_node(
        &mut self,
        document: &GltfDocument<'_>,
        node: &JsonNode<'_>,
    ) -> Result<Vec<Option<DMat4>>, Fault> {
        let Some(at) = attributes(node).filter(|_| is_instanced(node)) else { return Ok(vec![None]) };
        let mut places = InstanceAccessors { translation: None, rotation: None, scale: None };
        let mut count = None;
        for (name, entry) in node_members(node)? {
            let found = accessor(document, entry.as_unsigned()?, &entry)?;
            if *count.get_or_insert(found.count) != found.count {
                let (own, first) = (found.count, count.unwrap_or(0));
                return Err(entry.fault(format!("{own} elements, but another attribute has {first}")));
            }
            let (slot, width) = match name {
                "TRANSLATION" => (&mut places.translation, 3),
                "ROTATION" => (&mut places.rotation, 4),
                "SCALE" => (&mut places.scale, 3),
                _ => continue,
            };
            if found.component_count != width {
                return Err(found.fault(format!("{name} of instances must be VEC{width}")));
            }
            *slot = Some(found);
        }
        let Some(count) = count else { return Ok(vec![None]) };
        self.claim(count as u64, document, &at)?;
        places.matrices(count)
    }

    /// Accounts for instances that are about to be read.
    fn claim(&mut self, count: u64, document: &GltfDocument<'_>, at: &JsonNode<'_>) -> Result<(), Fault> {
        self.count = self.count.saturating_add(count);
        let limit = ALWAYS_ALLOWED.max(document.input_bytes / self.bytes_per_instance);
        if self.count > limit {
            let (found, bytes) = (self.count, document.input_bytes);
            return Err(at.fault(format!("{found} instances are too many for a file of {bytes} bytes")));
        }
        Ok(())
    }
}

/// Returns the attributes of a node's instances by name.
fn node_members<'a>(node: &JsonNode<'a>) -> Result<Vec<(&'a str, JsonNode<'a>)>, Fault> {
    let extension = node.get("extensions").and_then(|extensions| extensions.get(EXTENSION));
    extension.map_or_else(|| Ok(Vec::new()), |extension| extension.members("attributes"))
}

impl InstanceAccessors<'_> {
    fn matrices(&self, count: usize) -> Result<Vec<Option<DMat4>>, Fault> {
        let numbers = |of: &Option<Accessor<'_>>| of.as_ref().map(Accessor::floats).unwrap_or_default();
        let (translations, rotations, scales) =
            (numbers(&self.translation), numbers(&self.rotation), numbers(&self.scale));
        let (translations, _) = translations.as_chunks::<3>();
        let (rotations, _) = rotations.as_chunks::<4>();
        let (scales, _) = scales.as_chunks::<3>();
        let rotation = |index: usize| rotations.get(index).map(|q| unit(q.map(f64::from)));
        let bad = (0..rotations.len()).find(|&index| rotation(index) == Some(None));
        if let Some((index, at)) = bad.zip(self.rotation.as_ref()) {
            return Err(at.fault(format!("the rotation of instance {index} has no length")));
        }
        let vector = |of: &[[f32; 3]], index: usize, default| {
            of.get(index).map_or(default, |v| DVec3::from_array(v.map(f64::from)))
        };
        let matrix = |index: usize| {
            let rotation = rotation(index).flatten().unwrap_or(DQuat::IDENTITY);
            let scale = vector(scales, index, DVec3::ONE);
            let translation = vector(translations, index, DVec3::ZERO);
            Some(DMat4::from_scale_rotation_translation(scale, rotation, translation))
        };
        Ok((0..count).map(matrix).collect())
    }
}

/// Returns a quaternion with unit length; [`None`] if it has no length. The identity stays exact.
pub(super) fn unit(quaternion: [f64; 4]) -> Option<DQuat> {
    let rotation = DQuat::from_array(quaternion);
    let length = rotation.length();
    let has_length = length > 0.0 && length.is_finite();
    has_length.then(|| if length == 1.0 { rotation } else { rotation.normalize() })
}
