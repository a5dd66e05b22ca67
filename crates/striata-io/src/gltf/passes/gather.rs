//! Buffer views of one kind, joined if there are many, because a view takes as much JSON as a hundred bytes.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::additions::set_offset;
use super::compact::compact;
use super::parts::{GltfParts, array_length, entries, entries_mut, index_at};
use crate::error::Refusal;
use crate::gltf::builder::ELEMENT_ARRAY_BUFFER;
use crate::gltf::extensions::are_all_known;

/// Number of views of one kind from which on they are joined.
const MANY: usize = 32;

/// Target and stride of a view, and the type of the indices in it.
type ViewKey = (u64, Option<usize>, Option<usize>);

/// Joins the views of vertices and of indices, unless an unknown extension may refer to them.
pub(super) fn gather(parts: &mut GltfParts) -> Result<(), Refusal> {
    if array_length(&parts.root, "bufferViews") < MANY {
        return Ok(());
    }
    parts.parse_written()?;
    if !are_all_known(&parts.root) {
        return Ok(());
    }
    let types = index_types(&parts.root);
    let mut alike: BTreeMap<ViewKey, Vec<usize>> = BTreeMap::new();
    for (number, view) in entries(&parts.root, "bufferViews").iter().enumerate() {
        let is_plain = view.get("extensions").is_none() && index_at(view, "buffer") == Some(0);
        let Some(target) = view.get("target").and_then(Value::as_u64).filter(|_| is_plain) else { continue };
        let stride = index_at(view, "byteStride");
        // Accessors of vertices may share a view only if it has a stride.
        if stride.is_some() || target == u64::from(ELEMENT_ARRAY_BUFFER) {
            alike.entry((target, stride, types.get(&number).copied())).or_default().push(number);
        }
    }
    // For each joined view, the view that contains it now, and the offset there.
    let mut moved: BTreeMap<usize, [usize; 2]> = BTreeMap::new();
    for views in alike.into_values().filter(|views| views.len() >= MANY) {
        join(parts, &views, &mut moved);
    }
    if moved.is_empty() {
        return Ok(());
    }
    for accessor in entries_mut(&mut parts.root, "accessors") {
        let place = index_at(accessor, "bufferView").and_then(|view| moved.get(&view));
        if let Some(&[view, start]) = place {
            let own = index_at(accessor, "byteOffset").unwrap_or(0);
            accessor["bufferView"] = json!(view);
            set_offset(accessor, start + own);
        }
    }
    compact(parts, &std::collections::BTreeSet::new());
    Ok(())
}

/// Returns the component type of the accessors in each view.
fn index_types(root: &Value) -> BTreeMap<usize, usize> {
    let place =
        |accessor: &Value| Some((index_at(accessor, "bufferView")?, index_at(accessor, "componentType")?));
    entries(root, "accessors").iter().filter_map(place).collect()
}

/// Appends the bytes of views to the binary as one view, which replaces the first of them.
fn join(parts: &mut GltfParts, views: &[usize], moved: &mut BTreeMap<usize, [usize; 2]>) {
    let mut joined: Vec<u8> = Vec::new();
    for &number in views {
        let view = &parts.root["bufferViews"][number];
        let (start, length) =
            (index_at(view, "byteOffset").unwrap_or(0), index_at(view, "byteLength").unwrap_or(0));
        let Some(bytes) = parts.binary.get(start..).and_then(|rest| rest.get(..length)) else { continue };
        joined.resize(joined.len().next_multiple_of(4), 0);
        moved.insert(number, [views[0], joined.len()]);
        joined.extend_from_slice(bytes);
    }
    let place = parts.push_bytes(&joined);
    let first = &mut parts.root["bufferViews"][views[0]];
    for key in ["byteOffset", "byteLength"] {
        first[key] = place[key].clone();
    }
}
