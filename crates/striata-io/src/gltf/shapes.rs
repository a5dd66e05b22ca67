//! Points, lines and motion: a scene carries them, a mesh does not have them.

use serde_json::Value;

use super::document::GltfDocument;
use super::json::JsonNode;
use crate::error::{Fault, Place};
use crate::lost_data::warn_of_motion_in;
use crate::report::{WarningKind, Warnings, with_commas};

/// Calls `visit` with each primitive that draws points (mode 0) or lines.
fn visit_shapes<'a>(
    document: &GltfDocument<'a>,
    mut visit: impl FnMut(&JsonNode<'a>, u64),
) -> Result<(), Fault> {
    for mesh in document.root.entries("meshes")? {
        let primitives = mesh.values("primitives")?;
        let mode = |primitive: &Value| primitive.get("mode").and_then(Value::as_u64).unwrap_or(4);
        if primitives.iter().all(|primitive| mode(primitive) > 3) {
            continue;
        }
        for primitive in mesh.entries("primitives")? {
            let mode = mode(primitive.value);
            if mode <= 3 {
                visit(&primitive, mode);
            }
        }
    }
    Ok(())
}

/// Refuses a document that draws only points and lines.
pub(crate) fn check_triangles(document: &GltfDocument<'_>, has_none: bool) -> Result<(), Fault> {
    if !has_none {
        return Ok(());
    }
    let (mut points, mut lines) = (0, 0u64);
    let accessors = document.root.values("accessors")?;
    visit_shapes(document, |primitive, mode| {
        let position = primitive.value.pointer("/attributes/POSITION").and_then(Value::as_u64);
        let accessor = position.and_then(|index| accessors.get(usize::try_from(index).ok()?));
        let count = accessor.and_then(|accessor| accessor.get("count")?.as_u64());
        match mode {
            0 => points += count.unwrap_or(0),
            _ => lines += 1,
        }
    })?;
    let noun = |count: u64, one: &str, many: &str| {
        (count > 0).then(|| format!("{} {}", with_commas(count), if count == 1 { one } else { many }))
    };
    let found = [noun(points, "point", "points"), noun(lines, "set of lines", "sets of lines")];
    let found: Vec<String> = found.into_iter().flatten().collect();
    if found.is_empty() { Ok(()) } else { Err(Fault::NoTriangles(found.join(", "))) }
}

/// Warns of the primitives that a mesh cannot have, and of what moves.
pub(crate) fn left_out(document: &GltfDocument<'_>, warnings: &mut Warnings) -> Result<(), Fault> {
    let list = |value: &Value, key: &str| value.get(key).and_then(Value::as_array).map_or(0, Vec::len);
    let mut targets = 0;
    for mesh in document.root.entries("meshes")? {
        targets += mesh.values("primitives")?.iter().map(|own| list(own, "targets")).max().unwrap_or(0);
    }
    warn_of_motion_in(document.root.value, targets, warnings);
    let kind = WarningKind("primitive left out", "primitives left out");
    visit_shapes(document, |primitive, mode| {
        let what = if mode == 0 { "points" } else { "lines" };
        let place = || Place::Json(primitive.path.clone());
        warnings.count(kind, place, || format!("it draws {what}; a mesh has only triangles"));
    })
}
