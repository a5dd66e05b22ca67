//! Instances that follow a camera from frame to frame.

use std::mem::MaybeUninit;
use std::ops::Range;

use striata::View;
use striata::lod::PlacedTriangles;

use crate::camera::{StriataCamera, checked_pixels};
use crate::raw::CallerBuffer;
use crate::status::{CallFailure, CallResult, count_of, given, status_of};
use crate::{StriataLod, StriataRange};

/// An instance of a mesh that follows a camera: fine where errors would be visible, coarse elsewhere. One thread at a time
/// may use it.
#[derive(Debug)]
pub struct StriataView {
    view: View,
    /// Vertices of the mesh at full detail.
    vertex_count: u32,
    /// The triangles of each group at their places; empty until they are asked for.
    placed: Vec<PlacedTriangles>,
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

/// A part of the placed indices of a view.
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
        *to = Some(Box::new(StriataView { view: lod.view(), vertex_count, placed: Vec::new() }));
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

/// Updates the placed indices of a group to what the view shows, and writes the parts that have changed since they were
/// last written. Returns the number of parts: none if nothing has changed.
///
/// `striata_view_emit` lists triangles one after another, so that one more moves all those after it. In the placed indices,
/// a triangle stays where it is, and new ones take the places of those that have gone. Free places have three equal
/// indices, which draw nothing; there are never more than a quarter of them. Groups are counted from 0; a mesh without
/// groups has one.
///
/// # Safety
/// `to` has room for `capacity` spans, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_view_changes(
    view: Option<&mut StriataView>,
    group: u32,
    to: *mut StriataSpan,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let StriataView { view, placed, .. } = given("view", view)?;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        placed.resize_with(view.groups().len(), PlacedTriangles::default);
        let (placed, shown) = (placed_of(placed, group)?, &view.groups()[group as usize]);
        placed.follow(view.indices()[shown.start as usize..shown.end as usize].as_chunks().0);
        let span = |triangles: &Range<usize>| StriataSpan {
            first_index: 3 * triangles.start as u32,
            index_count: 3 * triangles.len() as u32,
        };
        let spans: Vec<_> = placed.changes().iter().map(span).collect();
        let is_written = to.capacity().is_some();
        let count = to.fill(spans.len(), || spans)?;
        if is_written {
            placed.clear_changes();
        }
        Ok(count)
    })
}

/// Writes a part of the placed indices of a group, which `striata_view_changes` has updated, or all of them if `span` is
/// null. Returns the number of indices; that of all is the number to draw.
///
/// # Safety
/// `to` has room for `capacity` indices, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_view_placed(
    view: Option<&mut StriataView>,
    group: u32,
    span: Option<&StriataSpan>,
    to: *mut u32,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let StriataView { view, placed, .. } = given("view", view)?;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        placed.resize_with(view.groups().len(), PlacedTriangles::default);
        let indices = placed_of(placed, group)?.indices();
        let range = span.map_or(0..indices.len(), |span| {
            let first = span.first_index as usize;
            first..first.saturating_add(span.index_count as usize)
        });
        let Some(part) = indices.get(range.clone()) else {
            let problem = format_args!("{range:?} is not within the {} placed indices", indices.len());
            return Err(CallFailure::argument("span", problem));
        };
        to.fill(part.len(), || part)
    })
}

fn placed_of(placed: &mut [PlacedTriangles], group: u32) -> CallResult<&mut PlacedTriangles> {
    let count = placed.len();
    let problem = || CallFailure::argument("group", format_args!("there is no group {group} of {count}"));
    placed.get_mut(group as usize).ok_or_else(problem)
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
