//! Strips of a mesh that does not fit into memory: block by block, with the border handed on.
//!
//! A mesh comes as blocks of triangles that lie together, in an order that goes through space without jumps.
//! Each block is stripified by any [`Stripifier`](super::Stripifier). Strips that touch triangles still to
//! come are not written: they wait, and the block that brings those triangles takes them apart and makes strips of
//! their triangles and its own together, so that a border between blocks is searched like any other place.
//! \[PS03, 6\] names the task as future work; that a vertex tells when it is last used is from \[IL05\].
//!
//! ```text
//!     +---------+- - - - +
//!     |  written| waits  :  next block
//!     |  strips | strips :  takes both
//!     +---------+- - - - +
//! ```
//!
//! Time is that of the stripifier, on each triangle once and on those that wait again. Memory is that of the
//! stripifier for one block and the strips that it takes over, and what waits: strips along the border of the part that
//! is done, which on a surface grows as the square root of the mesh, up to [`BlockOptions::held_limit`].
//! Invariants: each triangle is written once, in its winding; no strip crosses a group.

mod curve;
mod hash;
mod held;
mod mesh_blocks;
mod source;
mod window;

use crate::mesh::MeshError;
use crate::strip::{RESTART, StripCost, StripOptions, StripSet, strip_triangles};
use crate::{Cancelled, Progress, ProgressFn};

pub use curve::BlockCurve;
use held::Held;
pub use mesh_blocks::MeshBlocks;
pub use source::{Block, BlockSource, BlockTriangle};
use window::Window;

/// Options of [`stripify_blocks`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct BlockOptions {
    /// How each block is stripified.
    pub strip: StripOptions,
    /// The most triangles that may wait for later blocks; a triangle that waits takes some 30 bytes. Beyond it
    /// strips end at the border. Default 1,000,000.
    pub held_limit: usize,
}

impl Default for BlockOptions {
    fn default() -> Self {
        Self { strip: StripOptions::default(), held_limit: 1_000_000 }
    }
}

impl BlockOptions {
    /// Sets [`BlockOptions::strip`].
    pub fn with_strip(mut self, strip: StripOptions) -> Self {
        self.strip = strip;
        self
    }

    /// Sets [`BlockOptions::held_limit`].
    pub fn with_held_limit(mut self, triangle_count: usize) -> Self {
        self.held_limit = triangle_count;
        self
    }
}

/// What [`stripify_blocks`] made, and what it kept in memory for it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BlocksReport {
    /// What the strips cost.
    pub cost: StripCost,
    /// Blocks.
    pub block_count: u32,
    /// Triangles of the largest block.
    pub peak_block_triangles: usize,
    /// The most triangles that were stripified at once: a block and the strips that waited for it.
    pub peak_window_triangles: usize,
    /// The most triangles that waited at once for later blocks.
    pub peak_held_triangles: usize,
    /// How often a triangle was handed on to a later block.
    pub carried_count: usize,
}

/// Why [`stripify_blocks`] ended early: `R` is what reading a block says, `W` what writing a strip says.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BlocksError<R, W> {
    /// A block could not be read.
    #[error("block {block}: {error}")]
    Read {
        /// The block.
        block: u32,
        /// What its source says.
        error: R,
    },
    /// A strip could not be written.
    #[error("{0}")]
    Write(W),
    /// A block's group comes before that of the block before it.
    #[error("block {block} is of group {found}, after a block of group {previous}")]
    GroupFalls {
        /// The block.
        block: u32,
        /// Its group.
        found: u32,
        /// The group of the block before it.
        previous: u32,
    },
    /// A vertex has the number of the restart index.
    #[error("block {block}, triangle {triangle}: no vertex can have the number {RESTART}")]
    ReservedVertex {
        /// The block.
        block: u32,
        /// The triangle, counted within the block.
        triangle: usize,
    },
    /// A block and what waits for it are more than can be numbered.
    #[error("block {block}: {error}")]
    TooLarge {
        /// The block.
        block: u32,
        /// How large they are.
        error: MeshError,
    },
    /// The progress callback asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Covers each triangle of a mesh by exactly one strip, with one block of it in memory at a time.
///
/// `write` takes the strips one after another, each with its group, which never falls. Degenerate
/// triangles (two equal corners) are left out.
///
/// ```
/// use std::convert::Infallible;
/// use striata::mesh::shapes;
/// use striata::strip::{BlockOptions, MeshBlocks, stripify_blocks};
///
/// let mesh = shapes::terrain(40, 1);
/// let mut blocks = MeshBlocks::new(&mesh, 500)?;
/// let mut indices: Vec<u32> = Vec::new();
/// let report = stripify_blocks(
///     &mut blocks,
///     &BlockOptions::default(),
///     &mut |_group, strip| {
///         indices.extend_from_slice(strip);
///         Ok::<(), Infallible>(())
///     },
///     &mut striata::ignore_progress,
/// )?;
/// assert_eq!(report.cost.triangle_count, mesh.triangle_count());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`BlocksError`], first of all where reading or writing fails; strips written until then stay written.
pub fn stripify_blocks<S: BlockSource, W>(
    source: &mut S,
    options: &BlockOptions,
    write: &mut dyn FnMut(u32, &[u32]) -> Result<(), W>,
    progress: &mut ProgressFn<'_>,
) -> Result<BlocksReport, BlocksError<S::Error, W>> {
    let total = source.block_count();
    let mut work = Work::new(options, write);
    let mut block = Block::default();
    for number in 0..total {
        let now = Progress { phase: "strip", done: u64::from(number), total: u64::from(total) };
        if progress(now).is_break() {
            return Err(Cancelled.into());
        }
        source.read_block(number, &mut block).map_err(|error| BlocksError::Read { block: number, error })?;
        work.add(number, &block)?;
    }
    work.write_expired(u32::MAX).map_err(BlocksError::Write)?;
    Ok(BlocksReport { block_count: total, ..work.report() })
}

/// Fewest triangles that may wait, however small the block was.
const LEAST_HELD: usize = 4096;

/// The state between two blocks.
struct Work<'a, W> {
    options: &'a BlockOptions,
    writer: Writer<'a, W>,
    held: Held,
    window: Window,
    report: BlocksReport,
}

impl<'a, W> Work<'a, W> {
    fn new(options: &'a BlockOptions, write: &'a mut dyn FnMut(u32, &[u32]) -> Result<(), W>) -> Self {
        Self {
            options,
            writer: Writer { write, group: 0, is_begun: false, cost: StripCost::default() },
            held: Held::default(),
            window: Window::default(),
            report: BlocksReport::default(),
        }
    }

    /// Makes strips of a block and of what waited for it; writes those that are complete.
    fn add<R>(&mut self, number: u32, block: &Block) -> Result<(), BlocksError<R, W>> {
        self.enter_group(number, block.group)?;
        check_vertices(number, block)?;
        self.window.clear();
        for strip in self.held.take_beside(block) {
            self.report.carried_count += strip.triangle_count;
            self.window.push_strip(&strip);
        }
        self.write_expired(number).map_err(BlocksError::Write)?;
        for triangle in &block.triangles {
            self.window.push(triangle);
        }
        let report = &mut self.report;
        report.peak_block_triangles = report.peak_block_triangles.max(block.triangles.len());
        report.peak_window_triangles = report.peak_window_triangles.max(self.window.triangle_count());
        let strips = self.window.stripify(&self.options.strip);
        let strips = strips.map_err(|error| BlocksError::TooLarge { block: number, error })?;
        self.window.find_rim(number);
        let budget = self.options.held_limit.saturating_sub(self.held.triangle_count());
        let expiries =
            choose_held(&self.window, &strips, budget.min(block.triangles.len().max(LEAST_HELD) / 2));
        self.write_or_hold(&strips, &expiries).map_err(BlocksError::Write)
    }

    /// Nothing waits for a group that is over.
    fn enter_group<R>(&mut self, block: u32, found: u32) -> Result<(), BlocksError<R, W>> {
        let previous = self.writer.group;
        if found < previous {
            return Err(BlocksError::GroupFalls { block, found, previous });
        }
        if found > previous {
            self.write_expired(u32::MAX).map_err(BlocksError::Write)?;
            self.writer.group = found;
            self.writer.is_begun = false;
        }
        Ok(())
    }

    fn write_expired(&mut self, block: u32) -> Result<(), W> {
        while let Some(strip) = self.held.take_expired(block) {
            self.writer.push(&strip.indices)?;
        }
        Ok(())
    }

    fn write_or_hold(&mut self, strips: &StripSet, expiries: &[Option<u32>]) -> Result<(), W> {
        let mut in_mesh = Vec::new();
        for (strip, expiry) in strips.strips().zip(expiries) {
            if let Some(expiry) = *expiry {
                let (held, open_sides) = self.window.to_held(strip, expiry);
                self.held.push(held, open_sides.into_iter());
            } else {
                self.window.strip_in_mesh(strip, &mut in_mesh);
                self.writer.push(&in_mesh)?;
            }
        }
        Ok(())
    }

    fn report(&self) -> BlocksReport {
        let mut report = self.report;
        report.cost = self.writer.cost;
        report.peak_held_triangles = self.held.peak_triangle_count();
        if report.cost.triangle_count > 0 {
            report.cost.indices_per_triangle =
                report.cost.index_count as f64 / report.cost.triangle_count as f64;
        }
        report
    }
}

fn check_vertices<R, W>(number: u32, block: &Block) -> Result<(), BlocksError<R, W>> {
    match block.triangles.iter().position(|triangle| triangle.corners.contains(&RESTART)) {
        Some(triangle) => Err(BlocksError::ReservedVertex { block: number, triangle }),
        None => Ok(()),
    }
}

/// Until which block each strip waits; `None` for those that are complete, or for which there is no room.
///
/// A strip is worth holding for the sides that it has open, and costs its triangles.
fn choose_held(window: &Window, strips: &StripSet, budget: usize) -> Vec<Option<u32>> {
    let mut chosen = vec![None; strips.strip_count()];
    let mut candidates: Vec<(usize, usize, usize)> = Vec::new();
    for (index, strip) in strips.strips().enumerate() {
        let open = window.count_open_sides(strip);
        if open.count > 0 {
            candidates.push((open.count, strip_triangles(strip).count(), index));
            chosen[index] = Some(open.expiry);
        }
    }
    candidates.sort_by(|a, b| (b.0 * a.1).cmp(&(a.0 * b.1)).then(a.2.cmp(&b.2)));
    let mut held = 0;
    for (_, triangle_count, index) in candidates {
        if held + triangle_count > budget {
            chosen[index] = None;
        } else {
            held += triangle_count;
        }
    }
    chosen
}

/// Hands strips out and counts what they cost.
struct Writer<'a, W> {
    write: &'a mut dyn FnMut(u32, &[u32]) -> Result<(), W>,
    group: u32,
    /// Whether the group has a strip.
    is_begun: bool,
    cost: StripCost,
}

impl<W> Writer<'_, W> {
    fn push(&mut self, strip: &[u32]) -> Result<(), W> {
        let triangle_count = strip_triangles(strip).count();
        self.cost.triangle_count += triangle_count;
        self.cost.strip_count += 1;
        self.cost.swap_count += strip.len().saturating_sub(2) - triangle_count;
        self.cost.index_count += strip.len() + usize::from(self.is_begun);
        self.cost.longest_strip = self.cost.longest_strip.max(strip.len());
        self.is_begun = true;
        (self.write)(self.group, strip)
    }
}
