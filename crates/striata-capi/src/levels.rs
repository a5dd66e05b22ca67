//! Uniform levels: choosing them, listing their triangles, and ranges of one index buffer.

use std::mem::MaybeUninit;

use striata::lod::LevelSizes;
use striata::simplify::StopReason;
use striata::{Level, Lod, Target};

use crate::StriataLod;
use crate::camera::{StriataCamera, checked_pixels};
use crate::raw::{CallerBuffer, slice};
use crate::status::{CallFailure, CallResult, count_of, given, status_of};

/// At most this many triangles.
pub const STRIATA_BY_TRIANGLES: i32 = 1;
/// At most this many vertices.
pub const STRIATA_BY_VERTICES: i32 = 2;
/// At most this share of the triangles, from 0 to 1.
pub const STRIATA_BY_RATIO: i32 = 3;
/// The coarsest level with at most this error, in units of the mesh.
pub const STRIATA_BY_ERROR: i32 = 4;
/// This share of all steps, from 0, the coarsest level, to 1, full detail.
pub const STRIATA_BY_DETAIL: i32 = 5;
/// Exactly this many steps above the coarsest level.
pub const STRIATA_BY_STEPS: i32 = 6;

/// The level is less than one step from the target.
pub const STRIATA_TARGET_REACHED: i32 = 0;
/// The target is below the coarsest level.
pub const STRIATA_COARSEST_REACHED: i32 = 1;
/// The target is above full detail.
pub const STRIATA_FULL_REACHED: i32 = 2;

/// All groups of a mesh.
pub const STRIATA_ALL_GROUPS: i32 = -1;

/// A uniform level: its sizes and its error.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StriataLevel {
    /// Steps above the coarsest level, which identify the level.
    pub step_count: u32,
    /// Vertices: the level uses this many from the start of the vertex buffer.
    pub vertex_count: u32,
    /// Triangles: a third of the number of indices.
    pub triangle_count: u32,
    /// Largest distance of full detail from the level, in units of the mesh.
    pub error: f32,
    /// `STRIATA_TARGET_REACHED`, `STRIATA_COARSEST_REACHED` or `STRIATA_FULL_REACHED`.
    pub stop_reason: i32,
}

/// A range of an index buffer: a level, or a group of one.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StriataRange {
    /// First index of the range.
    pub first_index: u32,
    /// Number of indices.
    pub index_count: u32,
    /// Vertices that the indices refer to, from the start of the vertex buffer.
    pub vertex_count: u32,
    /// Largest distance of full detail from the level, in units of the mesh.
    pub error: f32,
}

/// Levels that become ranges of one index buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct StriataRangeRequest {
    /// The levels, finer ones first, as `striata_lod_halved_levels` writes them.
    pub levels: *const StriataLevel,
    /// Number of levels.
    pub level_count: usize,
    /// Group whose triangles are listed, from 0, or `STRIATA_ALL_GROUPS`.
    pub group: i32,
}

impl StriataLevel {
    fn of(sizes: &LevelSizes) -> Self {
        Self {
            step_count: sizes.split_count as u32,
            vertex_count: sizes.vertex_count as u32,
            triangle_count: sizes.triangle_count as u32,
            error: sizes.error,
            stop_reason: match sizes.stop_reason {
                StopReason::BaseReached | StopReason::ErrorLimit => STRIATA_COARSEST_REACHED,
                StopReason::FullMesh | StopReason::InputEnded => STRIATA_FULL_REACHED,
                _ => STRIATA_TARGET_REACHED,
            },
        }
    }

    /// Returns the target of the level, which must be one of this mesh.
    fn target(&self, lod: &Lod) -> CallResult<Target> {
        let steps = self.step_count as usize;
        let sizes = lod.resolve(Target::SplitCount(steps));
        let own = [sizes.split_count, sizes.vertex_count, sizes.triangle_count];
        if own == [self.step_count, self.vertex_count, self.triangle_count].map(|count| count as usize) {
            return Ok(Target::SplitCount(steps));
        }
        let problem =
            format_args!("{steps} steps with {} triangles are no level of lod", self.triangle_count);
        Err(CallFailure::argument("level", problem))
    }
}

/// Returns what a kind of target and its value ask for.
fn target_of(lod: &Lod, kind: i32, value: f64) -> CallResult<Target> {
    if !(value.is_finite() && value >= 0.0) {
        let problem = format_args!("{value} is not a finite number of at least 0");
        return Err(CallFailure::argument("value", problem));
    }
    let is_share = matches!(kind, STRIATA_BY_RATIO | STRIATA_BY_DETAIL);
    if is_share && value > 1.0 {
        return Err(CallFailure::argument("value", format_args!("the share {value} is more than 1")));
    }
    Ok(match kind {
        STRIATA_BY_TRIANGLES => Target::Triangles(value as usize),
        STRIATA_BY_VERTICES => Target::Vertices(value as usize),
        // The small term keeps a share that was divided before from losing a triangle.
        STRIATA_BY_RATIO => Target::Triangles((value * lod.mesh().triangle_count() as f64 + 1e-6) as usize),
        STRIATA_BY_ERROR => Target::Error(value),
        STRIATA_BY_DETAIL => Target::Detail(value),
        STRIATA_BY_STEPS => Target::SplitCount(value as usize),
        _ => return Err(CallFailure::argument("kind", format_args!("{kind} is no kind of target"))),
    })
}

/// Finds the most detailed level that does not exceed a target, or the coarsest one within an error. Takes less than a
/// microsecond, so that a frame can choose a level and list its triangles only if it is another one.
#[unsafe(no_mangle)]
pub extern "C" fn striata_lod_resolve(
    lod: Option<&StriataLod>,
    kind: i32,
    value: f64,
    level: Option<&mut MaybeUninit<StriataLevel>>,
) -> i32 {
    status_of(|| {
        let (lod, level) = (&given("lod", lod)?.levels, given("level", level)?);
        level.write(StriataLevel::of(&lod.resolve(target_of(lod, kind, value)?)));
        Ok(())
    })
}

/// Finds the coarsest level whose error covers at most a number of pixels of the screen of a camera, anywhere on the mesh. If
/// the camera is within the bounding sphere, that is full detail: use a view there.
#[unsafe(no_mangle)]
pub extern "C" fn striata_lod_resolve_for_camera(
    lod: Option<&StriataLod>,
    camera: Option<&StriataCamera>,
    pixels: f32,
    level: Option<&mut MaybeUninit<StriataLevel>>,
) -> i32 {
    status_of(|| {
        let (lod, level) = (&given("lod", lod)?.levels, given("level", level)?);
        let camera = given("camera", camera)?.to_camera()?;
        let target = lod.target_for_view(&camera, checked_pixels(pixels)?);
        level.write(StriataLevel::of(&lod.resolve(target)));
        Ok(())
    })
}

/// Writes full detail and levels with half as many triangles each, down to the coarsest: as many as there is room for.
/// Returns the number written, or, if `to` is null, the number of levels.
///
/// # Safety
/// `to` has room for `capacity` levels, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_halved_levels(
    lod: Option<&StriataLod>,
    to: *mut StriataLevel,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let lod = &given("lod", lod)?.levels;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        let splits = lod.sequence().halving_split_counts();
        let count = splits.len().min(to.capacity().unwrap_or(usize::MAX));
        let level = |&splits: &usize| StriataLevel::of(&lod.resolve(Target::SplitCount(splits)));
        to.fill(count, || splits[..count].iter().map(level).collect::<Vec<_>>())
    })
}

/// Writes the indices of a level, three for each triangle, and returns their number. They refer to the vertices in
/// refinement order, sorted by group. If `to` is null, nothing is written.
///
/// # Safety
/// `to` has room for `capacity` indices, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_emit(
    lod: Option<&StriataLod>,
    level: Option<&StriataLevel>,
    to: *mut u32,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let (lod, level) = (&given("lod", lod)?.levels, given("level", level)?);
        let target = level.target(lod)?;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        to.fill(3 * level.triangle_count as usize, || LevelIndices(lod.level(target)))
    })
}

/// The indices of a level as a slice.
struct LevelIndices(Level);

impl AsRef<[u32]> for LevelIndices {
    fn as_ref(&self) -> &[u32] {
        self.0.indices()
    }
}

/// Writes the range of each group in the indices of a level, and returns the number of groups, which is at least 1. Takes
/// as long as `striata_lod_emit`.
///
/// # Safety
/// `to` has room for `capacity` ranges, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_emit_groups(
    lod: Option<&StriataLod>,
    level: Option<&StriataLevel>,
    to: *mut StriataRange,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let (lod, level) = (&given("lod", lod)?.levels, given("level", level)?);
        let target = level.target(lod)?;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        let range = |group: &std::ops::Range<u32>| StriataRange {
            first_index: group.start,
            index_count: group.end - group.start,
            vertex_count: level.vertex_count,
            error: level.error,
        };
        let count = lod.mesh().groups.len().max(1);
        to.fill(count, || lod.level(target).groups().iter().map(range).collect::<Vec<_>>())
    })
}

/// Makes levels as ranges of one index buffer, each in an order for the vertex cache. Writes the indices to `to`, a range
/// for each level to `ranges` unless that is null, and returns the number of indices. If `to` is null, nothing is written
/// to it; with `STRIATA_ALL_GROUPS`, the ranges are then known without making the levels.
///
/// # Safety
/// The request has as many levels as it states, `ranges` has room for one range for each of them, or is null, and `to` has
/// room for `capacity` indices, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_ranges(
    lod: Option<&StriataLod>,
    request: Option<&StriataRangeRequest>,
    ranges: *mut StriataRange,
    to: *mut u32,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let (lod, request) = (&given("lod", lod)?.levels, given("request", request)?);
        // SAFETY: the promise of the caller.
        let levels = unsafe { slice("request.levels", request.levels, request.level_count) }?;
        // SAFETY: the promise of the caller.
        let ranges = unsafe { CallerBuffer::new(ranges, levels.len()) }?;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        let group = group_of(lod, request.group)?;
        let places = whole_ranges(levels)?;
        let mut splits = Vec::new();
        for level in levels {
            level.target(lod)?;
            let steps = level.step_count as usize;
            if splits.last().is_some_and(|&last| last < steps) {
                return Err(CallFailure::argument(
                    "request.levels",
                    "a level is finer than the one before it",
                ));
            }
            splits.push(steps);
        }
        if to.capacity().is_none() && group.is_none() {
            ranges.fill(places.len(), || &places)?;
            return Ok(places.iter().map(|range| range.index_count as usize).sum());
        }
        let made = lod.ranges(&splits, group);
        let count = to.fill(made.indices.len(), || &made.indices)?;
        let range = |range: &striata::lod::IndexRange| StriataRange {
            first_index: range.first_index as u32,
            index_count: range.index_count as u32,
            vertex_count: range.vertex_count as u32,
            error: range.error,
        };
        ranges.fill(made.ranges.len(), || made.ranges.iter().map(range).collect::<Vec<_>>())?;
        Ok(count)
    })
}

fn group_of(lod: &Lod, group: i32) -> CallResult<Option<usize>> {
    if group == STRIATA_ALL_GROUPS {
        return Ok(None);
    }
    let count = lod.mesh().groups.len().max(1);
    let problem =
        || CallFailure::argument("request.group", format_args!("there is no group {group} of {count}"));
    usize::try_from(group).ok().filter(|&group| group < count).map(Some).ok_or_else(problem)
}

/// Returns the ranges of levels of all groups, which follow from their sizes.
fn whole_ranges(levels: &[StriataLevel]) -> CallResult<Vec<StriataRange>> {
    let mut places: Vec<StriataRange> = Vec::with_capacity(levels.len());
    for level in levels {
        let next = places.last().map_or(0, |last| last.first_index + last.index_count);
        let index_count = level.triangle_count.checked_mul(3);
        let Some(index_count) = index_count.filter(|&count| next.checked_add(count).is_some()) else {
            return Err(CallFailure::argument("request.levels", "the levels have more than 2^32 indices"));
        };
        let StriataLevel { vertex_count, error, .. } = *level;
        places.push(StriataRange { first_index: next, index_count, vertex_count, error });
    }
    Ok(places)
}
