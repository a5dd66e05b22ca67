//! Removal of accessors and buffer views that nothing refers to, and of their bytes.
//!
//! If every extension of the document is known, slots that nothing refers to are removed and the others
//! renumbered. Otherwise, an extension may refer to any slot by its number: then only those accessors that
//! a pass has replaced lose their bytes, and their slots stay as placeholders. Views of which only a part
//! is used are cut, unless they overlap others.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::additions::{remove, set_offset};
use super::parts::{GltfParts, array_length, entries, entries_mut, index, index_at};
use crate::gltf::extensions::are_all_known;
use crate::gltf::references::{Referent, for_each, for_each_view};

/// Extensions of buffer views with a range of bytes of their own.
const COMPRESSIONS: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

/// Drops what is no longer used; `replaced` are the accessors that the caller has replaced by others.
pub(super) fn compact(parts: &mut GltfParts, replaced: &BTreeSet<u64>) {
    let is_closed = are_all_known(&parts.root);
    let (accessor_count, view_count) =
        (array_length(&parts.root, "accessors"), array_length(&parts.root, "bufferViews"));
    let (mut live_accessors, mut live_views) = (vec![false; accessor_count], vec![false; view_count]);
    for_each(&mut parts.root, |referent, value| {
        let live = match referent {
            Referent::Accessor(_) => &mut live_accessors,
            Referent::View => &mut live_views,
        };
        mark(live, value);
    });
    if !is_closed {
        let keeps = |accessor: &usize| !replaced.contains(&(*accessor as u64));
        (0..accessor_count).filter(keeps).for_each(|accessor| live_accessors[accessor] = true);
    }
    let mut views_of_dead = vec![false; view_count];
    for (accessor, &is_live) in entries_mut(&mut parts.root, "accessors").iter_mut().zip(&live_accessors) {
        let views = if is_live { &mut live_views } else { &mut views_of_dead };
        for_each_view(accessor, &mut |value| mark(views, value));
    }
    if !is_closed {
        let pairs = live_views.iter_mut().zip(&views_of_dead);
        pairs.for_each(|(is_live, &is_of_dead)| *is_live |= !is_of_dead);
    }
    repack(parts, &live_accessors, &live_views);
    if is_closed {
        remove_slots(&mut parts.root, &live_accessors, &live_views);
    } else {
        let accessor = json!({ "componentType": 5121, "count": 1, "type": "SCALAR" });
        fill_slots(&mut parts.root, "accessors", &live_accessors, &accessor);
        // The shortest view that there is.
        let view = json!({ "buffer": 0, "byteLength": 1 });
        fill_slots(&mut parts.root, "bufferViews", &live_views, &view);
        if parts.binary.is_empty() && live_views.contains(&false) {
            parts.binary.resize(4, 0);
        }
    }
    declare_buffers(parts);
}

fn mark(live: &mut [bool], value: &Value) {
    let slot = index(value).and_then(|index| live.get_mut(usize::try_from(index).ok()?));
    if let Some(slot) = slot {
        *slot = true;
    }
}

/// Removes slots, and renumbers all references.
fn remove_slots(root: &mut Value, live_accessors: &[bool], live_views: &[bool]) {
    for (key, live) in [("accessors", live_accessors), ("bufferViews", live_views)] {
        let Some(slots) = root.get_mut(key).and_then(Value::as_array_mut) else { continue };
        let mut is_live = live.iter();
        slots.retain(|_| is_live.next().is_none_or(|&is_live| is_live));
        if slots.is_empty() {
            remove(root, key);
        }
    }
    let (accessors, views) = (numbers(live_accessors), numbers(live_views));
    let renumber = |numbers: &[usize], value: &mut Value| {
        if let Some(&number) = index(value).and_then(|index| numbers.get(usize::try_from(index).ok()?)) {
            *value = json!(number);
        }
    };
    for_each(root, |referent, value| match referent {
        Referent::Accessor(_) => renumber(&accessors, value),
        Referent::View => renumber(&views, value),
    });
    for accessor in entries_mut(root, "accessors") {
        for_each_view(accessor, &mut |value| renumber(&views, value));
    }
}

/// Returns the new number of each slot.
fn numbers(live: &[bool]) -> Vec<usize> {
    let number = |next: &mut usize, &is_live: &bool| {
        let number = *next;
        *next += usize::from(is_live);
        Some(number)
    };
    live.iter().scan(0, number).collect()
}

/// Replaces slots by placeholders.
fn fill_slots(root: &mut Value, key: &str, live: &[bool], placeholder: &Value) {
    for (slot, is_live) in entries_mut(root, key).iter_mut().zip(live) {
        if !is_live {
            *slot = placeholder.clone();
        }
    }
}

/// Declares the size of the first buffer, or removes it if it is the only one and empty.
fn declare_buffers(parts: &mut GltfParts) {
    if parts.binary.is_empty() && array_length(&parts.root, "buffers") == 1 {
        remove(&mut parts.root, "buffers");
    } else if array_length(&parts.root, "buffers") > 0 {
        if parts.binary.is_empty() {
            // A buffer has at least one byte.
            parts.binary.resize(4, 0);
        }
        parts.declare_binary();
    }
}

/// Range of the binary that a view or its compressed form occupies.
struct Range {
    start: usize,
    end: usize,
    view: usize,
    /// Extension that owns the range instead of the view itself.
    extension: Option<&'static str>,
}

/// Moves the bytes of all live views together.
fn repack(parts: &mut GltfParts, live_accessors: &[bool], live_views: &[bool]) {
    let mut ranges = Vec::new();
    for (view, value) in entries(&parts.root, "bufferViews").iter().enumerate() {
        if !live_views[view] {
            continue;
        }
        let of_view = range(value, parts.binary.len());
        ranges.extend(of_view.map(|[start, end]| Range { start, end, view, extension: None }));
        for name in COMPRESSIONS {
            let packed = value.get("extensions").and_then(|extensions| extensions.get(name));
            let packed = packed.and_then(|packed| range(packed, parts.binary.len()));
            ranges.extend(packed.map(|[start, end]| Range { start, end, view, extension: Some(name) }));
        }
    }
    ranges.sort_by_key(|range| (range.start, range.end));
    let users = users_of_views(&mut parts.root, live_accessors, live_views.len());
    let mut binary = Vec::with_capacity(parts.binary.len());
    let mut rest = &ranges[..];
    while let Some(first) = rest.first() {
        let mut end = first.end;
        let mut count = 1;
        while let Some(next) = rest.get(count).filter(|next| next.start < end) {
            end = end.max(next.end);
            count += 1;
        }
        let (cluster, later) = rest.split_at(count);
        rest = later;
        // The alignment must remain.
        while binary.len() % 4 != first.start % 4 {
            binary.push(0);
        }
        match (cluster, &users[first.view]) {
            ([range], Some(users)) if range.extension.is_none() => {
                let source = &parts.binary[range.start..range.end];
                cut(&mut parts.root, range, users, source, &mut binary);
            }
            _ => {
                let moved = binary.len();
                binary.extend_from_slice(&parts.binary[first.start..end]);
                for range in cluster {
                    let owner = owner(&mut parts.root, range);
                    owner["byteOffset"] = json!(moved + range.start - first.start);
                }
            }
        }
    }
    parts.binary = binary;
}

/// Returns the range that a view or its extension declares, if it lies in the binary.
fn range(value: &Value, limit: usize) -> Option<[usize; 2]> {
    let start = if value.get("byteOffset").is_some() { index_at(value, "byteOffset")? } else { 0 };
    let end = start.checked_add(index_at(value, "byteLength")?)?;
    (index_at(value, "buffer")? == 0 && end <= limit).then_some([start, end])
}

/// Returns the object that declares a range.
fn owner<'a>(root: &'a mut Value, range: &Range) -> &'a mut Value {
    let view = &mut root["bufferViews"][range.view];
    match range.extension {
        Some(name) => &mut view["extensions"][name],
        None => view,
    }
}

/// Returns the accessors of each view; [`None`] if it may have other users.
fn users_of_views(root: &mut Value, live_accessors: &[bool], view_count: usize) -> Vec<Option<Vec<usize>>> {
    let mut users: Vec<Option<Vec<usize>>> = vec![Some(Vec::new()); view_count];
    if !are_all_known(root) {
        return vec![None; view_count];
    }
    let mut lock = |value: &Value| {
        if let Some(view) = index(value).and_then(|view| users.get_mut(usize::try_from(view).ok()?)) {
            *view = None;
        }
    };
    for_each(root, |referent, value| {
        if referent == Referent::View {
            lock(value);
        }
    });
    let accessors = entries_mut(root, "accessors");
    for accessor in accessors.iter_mut().filter(|accessor| accessor.get("sparse").is_some()) {
        for_each_view(accessor, &mut |value| lock(value));
    }
    for (number, accessor) in accessors.iter().enumerate().filter(|&(number, _)| live_accessors[number]) {
        let view = index_at(accessor, "bufferView").and_then(|view| users.get_mut(view)?.as_mut());
        if let Some(view) = view {
            view.push(number);
        }
    }
    users
}

/// Copies those parts of a view that its accessors use.
fn cut(root: &mut Value, range: &Range, users: &[usize], source: &[u8], binary: &mut Vec<u8>) {
    let moved = binary.len();
    let view = &root["bufferViews"][range.view];
    // Parts of interleaved data consist of whole steps, because some readers expect them.
    let step = if view.get("byteStride").is_some() { index_at(view, "byteStride") } else { Some(4) };
    let spans: Option<Vec<[usize; 3]>> = users
        .iter()
        .map(|&user| {
            let [start, end] =
                span(&root["accessors"][user], view).filter(|&[_, end]| end <= source.len())?;
            Some([start, end, user])
        })
        .collect();
    root["bufferViews"][range.view]["byteOffset"] = json!(moved);
    // If something is wrong with an accessor, everything is kept.
    let (Some(mut spans), Some(step @ 1..)) = (spans, step) else {
        return binary.extend_from_slice(source);
    };
    spans.sort_unstable();
    // Bytes up to `copied` have been copied or skipped, and are found `shift` bytes before.
    let (mut copied, mut shift) = (0, 0);
    for [start, end, user] in spans {
        let first = start / step * step;
        if first > copied {
            shift += first - copied;
            copied = first;
        }
        let last = end.next_multiple_of(step).min(source.len());
        if last > copied {
            binary.extend_from_slice(&source[copied..last]);
            copied = last;
        }
        set_offset(&mut root["accessors"][user], start - shift);
    }
    root["bufferViews"][range.view]["byteLength"] = json!(binary.len() - moved);
}

/// Returns the bytes of a view that an accessor uses.
fn span(accessor: &Value, view: &Value) -> Option<[usize; 2]> {
    let start = if accessor.get("byteOffset").is_some() { index_at(accessor, "byteOffset")? } else { 0 };
    let component = match index_at(accessor, "componentType")? {
        5120 | 5121 => 1,
        5122 | 5123 => 2,
        5125 | 5126 => 4,
        _ => return None,
    };
    let width = match accessor.get("type")?.as_str()? {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        // Columns of small matrices are padded.
        "MAT2" if component == 4 => 4,
        "MAT3" if component == 4 => 9,
        "MAT4" => 16,
        _ => return None,
    };
    let size: usize = component * width;
    let stride = if view.get("byteStride").is_some() { index_at(view, "byteStride")? } else { size };
    let steps = index_at(accessor, "count")?.checked_sub(1)?;
    let end = start.checked_add(steps.checked_mul(stride)?)?.checked_add(size)?;
    Some([start, end])
}
