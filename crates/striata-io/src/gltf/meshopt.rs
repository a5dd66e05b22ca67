//! Buffer views that meshoptimizer has compressed: the layout that the extension declares, and decoding.
//!
//! `EXT_meshopt_compression` and `KHR_meshopt_compression` are read alike. The latter adds a color filter
//! and version 1 of the vertex codec, both of which are also accepted in the former.
//!
//! The decoder checks counts against the compressed bytes before it allocates: even the most compact
//! stream of version 1 takes a byte per kilobyte of vertices.

use super::compression::GeometryCompression;
use super::json::JsonNode;
use super::uri::shortened;
use crate::error::Fault;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    Attributes,
    Triangles,
    Indices,
}

/// Transform that decoding applies last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ViewFilter {
    None,
    Octahedral,
    Quaternion,
    Exponential,
    Color,
}

/// Layout of decompressed data.
#[derive(Clone, Copy, Debug)]
struct ViewLayout {
    mode: Mode,
    filter: ViewFilter,
    count: usize,
    stride: usize,
}

/// Decompresses the buffer view `view`, whose extension object is `at`; `source` returns the compressed bytes, unless that
/// many decompressed ones are too many.
pub(super) fn decompressed<'b>(
    view: &JsonNode<'_>,
    at: &JsonNode<'_>,
    source: impl FnOnce(u64) -> Result<&'b [u8], Fault>,
) -> Result<Vec<u8>, Fault> {
    if !GeometryCompression::Meshopt.is_on() {
        return Err(GeometryCompression::Meshopt.feature_off());
    }
    let layout = layout(at)?;
    let bytes = (layout.count as u64).saturating_mul(layout.stride as u64);
    let declared = view.required_unsigned("byteLength")?;
    if bytes != declared {
        let ViewLayout { count, stride, .. } = layout;
        return Err(at.fault(format!("{count} elements of {stride} bytes, in a view of {declared} bytes")));
    }
    decode(layout, source(bytes)?)
        .map_err(|reason| at.fault(format!("the compressed data are damaged: {reason}")))
}

fn layout(at: &JsonNode<'_>) -> Result<ViewLayout, Fault> {
    let (mode, filter) = (mode(at)?, filter(at)?);
    let (count, stride) = (at.required_unsigned("count")?, at.required_unsigned("byteStride")?);
    let is_valid = match mode {
        Mode::Attributes => (4..=256).contains(&stride) && stride % 4 == 0,
        Mode::Triangles | Mode::Indices => matches!(stride, 2 | 4),
    };
    if !is_valid {
        return Err(at.fault(format!("byteStride {stride} is not valid for the mode {}", at.text("mode"))));
    }
    let fits = match filter {
        ViewFilter::None => true,
        _ if mode != Mode::Attributes => false,
        ViewFilter::Octahedral | ViewFilter::Color => matches!(stride, 4 | 8),
        ViewFilter::Quaternion => stride == 8,
        ViewFilter::Exponential => true,
    };
    if !fits {
        let (filter, mode) = (at.text("filter"), at.text("mode"));
        return Err(at.fault(format!("the filter {filter} cannot follow {mode} with byteStride {stride}")));
    }
    if mode == Mode::Triangles && count % 3 != 0 {
        return Err(at.fault(format!("{count} indices are not whole triangles")));
    }
    let Ok(count) = usize::try_from(count) else {
        return Err(at.fault(format!("{count} elements are more than can be handled")));
    };
    Ok(ViewLayout { mode, filter, count, stride: stride as usize })
}

fn mode(at: &JsonNode<'_>) -> Result<Mode, Fault> {
    match at.text("mode") {
        "ATTRIBUTES" => Ok(Mode::Attributes),
        "TRIANGLES" => Ok(Mode::Triangles),
        "INDICES" => Ok(Mode::Indices),
        other => Err(at.fault(format!("no compression mode is called `{}`", shortened(other)))),
    }
}

fn filter(at: &JsonNode<'_>) -> Result<ViewFilter, Fault> {
    match at.text("filter") {
        "" | "NONE" => Ok(ViewFilter::None),
        "OCTAHEDRAL" => Ok(ViewFilter::Octahedral),
        "QUATERNION" => Ok(ViewFilter::Quaternion),
        "EXPONENTIAL" => Ok(ViewFilter::Exponential),
        "COLOR" => Ok(ViewFilter::Color),
        other => Err(at.fault(format!("no compression filter is called `{}`", shortened(other)))),
    }
}

#[cfg(not(feature = "meshopt"))]
fn decode(_: ViewLayout, _: &[u8]) -> Result<Vec<u8>, String> {
    Err("the feature is off".to_owned())
}

#[cfg(feature = "meshopt")]
fn decode(layout: ViewLayout, source: &[u8]) -> Result<Vec<u8>, String> {
    if layout.count == 0 {
        return Ok(Vec::new());
    }
    super::compression::contained(|| decode_and_filter(layout, source).map_err(|error| error.to_string()))
}

#[cfg(feature = "meshopt")]
fn decode_and_filter(layout: ViewLayout, source: &[u8]) -> Result<Vec<u8>, meshoptimizer_rs::Error> {
    use meshoptimizer_rs::codec;

    let ViewLayout { mode, filter, count, stride } = layout;
    let workspace = &mut meshoptimizer_rs::Workspace::default();
    let mut bytes = match mode {
        Mode::Attributes => codec::decode_vertex_buffer(count, stride, source, workspace)?,
        Mode::Triangles => codec::decode_index_buffer(count, stride, source, workspace)?,
        Mode::Indices => codec::decode_index_sequence(count, stride, source, workspace)?,
    };
    match filter {
        ViewFilter::None => {}
        ViewFilter::Octahedral => codec::decode_filter_oct(&mut bytes, count, stride, workspace)?,
        ViewFilter::Quaternion => codec::decode_filter_quat(&mut bytes, count, stride, workspace)?,
        ViewFilter::Exponential => codec::decode_filter_exp(&mut bytes, count, stride, workspace)?,
        ViewFilter::Color => codec::decode_filter_color(&mut bytes, count, stride, workspace)?,
    }
    Ok(bytes)
}
