//! Instances that follow a camera from frame to frame.

use std::mem::MaybeUninit;
use std::ops::Range;

use striata::View;

use crate::camera::{StriataCamera, checked_pixels};
use crate::raw::CallerBuffer;
use crate::status::{count_of, given, status_of};
use crate::{StriataLod, StriataRange};

/// Changed ranges with fewer equal indices between them become one: an upload of its own costs more than those.
const MAX_GAP: usize = 256;

/// An instance of a mesh that follows a camera: fine where errors would be visible, coarse elsewhere. One thread at a time
/// may use it.
#[derive(Debug)]
pub struct StriataView {
    view: View,
    /// Vertices of the mesh at full detail.
    vertex_count: u32,
    /// The indices when the changes were last written.
    uploaded: Vec<u32>,
}

/// Sizes of a view, and the work of its last update.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StriataViewUpdate {
    /// Triangles that the view shows.
    pub triangle_count: u32,
    /// Number of indices, three for each triangle.
    pub index_count: u32,
    /// Steps that were refined.
    pub refined_count: u32,
    /// Steps that were coarsened. If both numbers are 0, the indices are those of the frame before.
    pub coarsened_count: u32,
    /// 1 if no error exceeds the tolerance; 0 if the triangle limit kept some.
    pub is_complete: i32,
}

/// A part of the indices that has changed.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StriataSpan {
    /// First index of the part.
    pub first_index: u32,
    /// Number of indices.
    pub index_count: u32,
}

/// Creates an instance that shows the coarsest level, and writes a handle to `to`, which `striata_view_free` frees. The
/// mesh may be freed before its views.
#[unsafe(no_mangle)]
pub extern "C" fn striata_view_new(
    lod: Option<&StriataLod>,
    to: Option<&mut MaybeUninit<Option<Box<StriataView>>>>,
) -> i32 {
    status_of(|| {
        let to = given("to", to)?.write(None);
        let lod = &given("lod", lod)?.levels;
        let vertex_count = lod.mesh().vertex_count() as u32;
        *to = Some(Box::new(StriataView { view: lod.view(), vertex_count, uploaded: Vec::new() }));
        Ok(())
    })
}

/// Refines whatever the camera sees until no error covers more than this number of pixels of its screen, and coarsens the rest.
/// With a triangle limit other than 0, the view shows at most that many triangles, or the coarsest level. `update` may be
/// null.
#[unsafe(no_mangle)]
pub extern "C" fn striata_view_update(
    view: Option<&mut StriataView>,
    camera: Option<&StriataCamera>,
    pixels: f32,
    triangle_limit: u32,
    update: Option<&mut MaybeUninit<StriataViewUpdate>>,
) -> i32 {
    status_of(|| {
        let view = &mut given("view", view)?.view;
        let camera = given("camera", camera)?.to_camera()?;
        let pixels = checked_pixels(pixels)?;
        let work = match triangle_limit {
            0 => view.update(&camera, pixels),
            limit => view.update_to_budget(&camera, pixels, limit as usize),
        };
        if let Some(update) = update {
            update.write(StriataViewUpdate {
                triangle_count: view.triangle_count() as u32,
                index_count: view.indices().len() as u32,
                refined_count: work.split_count as u32,
                coarsened_count: work.collapse_count as u32,
                is_complete: (work.is_complete && work.threshold <= 1.0).into(),
            });
        }
        Ok(())
    })
}

/// Writes the indices of a view, three for each triangle, and returns their number. They refer to the vertices in refinement
/// order, sorted by group.
///
/// # Safety
/// `to` has room for `capacity` indices, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_view_emit(view: Option<&StriataView>, to: *mut u32, capacity: usize) -> i64 {
    count_of(|| {
        let indices = given("view", view)?.view.indices();
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        to.fill(indices.len(), || indices)
    })
}

/// Writes the range of each group in the indices of a view, and returns the number of groups, which is at least 1. Their
/// vertex count is that of the mesh, and their error is 0, because a view has no uniform one.
///
/// # Safety
/// `to` has room for `capacity` ranges, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_view_groups(
    view: Option<&StriataView>,
    to: *mut StriataRange,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let StriataView { view, vertex_count, .. } = given("view", view)?;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        let range = |group: &Range<u32>| StriataRange {
            first_index: group.start,
            index_count: group.end - group.start,
            vertex_count: *vertex_count,
            error: 0.0,
        };
        to.fill(view.groups().len(), || view.groups().iter().map(range).collect::<Vec<_>>())
    })
}

/// Writes the parts of the indices that have changed since the last call that wrote them, and returns the number of parts:
/// all indices at first, none if the view is as it was. Upload the parts from the result of `striata_view_emit`. An index
/// beyond the end of a list that has become shorter is no change. A triangle that appears moves all those after it, so that
/// a camera that moves changes most of the list: 85 % of the indices in each frame of an approach, 9 steps a frame.
///
/// # Safety
/// `to` has room for `capacity` spans, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_view_changes(
    view: Option<&mut StriataView>,
    to: *mut StriataSpan,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let StriataView { view, uploaded, .. } = given("view", view)?;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        let (is_written, spans) = (to.capacity().is_some(), changes(uploaded, view.indices()));
        let count = to.fill(spans.len(), || spans)?;
        if is_written {
            uploaded.clear();
            uploaded.extend_from_slice(view.indices());
        }
        Ok(count)
    })
}

/// Finds the parts in which a list differs from an older one.
fn changes(old: &[u32], new: &[u32]) -> Vec<StriataSpan> {
    let mut spans: Vec<Range<usize>> = Vec::new();
    let differs = |at: &usize| old.get(*at) != Some(&new[*at]);
    for at in (0..new.len()).filter(differs) {
        match spans.last_mut() {
            Some(last) if at - last.end < MAX_GAP => last.end = at + 1,
            _ => spans.push(at..at + 1),
        }
    }
    let span =
        |span: &Range<usize>| StriataSpan { first_index: span.start as u32, index_count: span.len() as u32 };
    spans.iter().map(span).collect()
}

/// Frees a view. Null is allowed.
#[unsafe(no_mangle)]
pub extern "C" fn striata_view_free(view: Option<Box<StriataView>>) {
    // A panic has no meaning for the caller: the handle is gone.
    let _ = status_of(|| {
        drop(view);
        Ok(())
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_changes_are_one_span() {
        let old: Vec<u32> = (0..3000).collect();
        let mut new = old.clone();
        assert_eq!(changes(&old, &new), []);
        for at in [5, 7, 2000] {
            new[at] = 0;
        }
        let span = |first_index, index_count| StriataSpan { first_index, index_count };
        assert_eq!(changes(&old, &new), [span(5, 3), span(2000, 1)]);
        new.extend([1, 2]);
        assert_eq!(changes(&old, &new), [span(5, 3), span(2000, 1), span(3000, 2)]);
        assert_eq!(changes(&old, &old[..9]), []);
        assert_eq!(changes(&[], &old), [span(0, 3000)]);
    }
}
