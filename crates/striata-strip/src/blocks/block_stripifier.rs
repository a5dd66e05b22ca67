//! Processing of each block: builds a window, makes strips, and decides which of them wait for later blocks.

use striata::strip::{RESTART, StripCost, StripSet, strip_triangles};

use super::chain::{BlockChain, ChainEnd};
use super::joints::Joints;
use super::options::{BlockOptions, BlocksError, BlocksReport, WriteStripFn};
use super::pending::{OpenEnd, PendingStrip, PendingStrips, TouchedStrip};
use super::source::Block;
use super::window::Window;

/// A strip with more triangles than this per open side is not taken apart again.
const LOOSE_TRIANGLES: usize = 8;
/// Minimum number of triangles of a chain that other strips may continue; shorter ones are taken apart.
const MIN_CHAIN_TRIANGLES: usize = 8;
/// Strips with this many triangles are written: continuing them would save a negligible part of their
/// indices.
const MAX_CHAIN_TRIANGLES: usize = 1000;
/// Number of triangles that may always be taken apart again, however small the block was.
const MIN_LOOSE_TRIANGLES: usize = 4096;

/// State between two blocks.
pub(super) struct BlockStripifier<'a, W> {
    options: &'a BlockOptions,
    writer: BlockStripWriter<'a, W>,
    pending: PendingStrips,
    window: Window,
    joints: Joints,
    report: BlocksReport,
}

impl<'a, W> BlockStripifier<'a, W> {
    /// Creates a stripifier that passes finished strips to `write`.
    pub(super) fn new(options: &'a BlockOptions, write: &'a mut WriteStripFn<'a, W>) -> Self {
        Self {
            options,
            writer: BlockStripWriter { write, group: 0, is_begun: false, cost: StripCost::default() },
            pending: PendingStrips::default(),
            window: Window::default(),
            joints: Joints::default(),
            report: BlocksReport::default(),
        }
    }

    /// Makes strips of a block and the strips it takes over, and writes those that are complete.
    pub(super) fn add<R>(&mut self, index: u32, block: &Block) -> Result<(), BlocksError<R, W>> {
        self.enter_group(index, block.group)?;
        check_vertices(index, block)?;
        self.fill_window(block);
        self.write_expired(index).map_err(BlocksError::Write)?;
        let strips = self.window.stripify(&self.options.strip);
        let strips = strips.map_err(|error| BlocksError::TooLarge { block: index, error })?;
        self.window.find_rim(index, self.joints.sides());
        self.distribute(&strips, block.triangles.len()).map_err(BlocksError::Write)
    }

    /// Writes the strips that still wait.
    pub(super) fn finish(mut self, block_count: u32) -> Result<BlocksReport, W> {
        self.write_expired(u32::MAX)?;
        let mut cost = self.writer.cost;
        if cost.triangle_count > 0 {
            cost.indices_per_triangle = cost.index_count as f64 / cost.triangle_count as f64;
        }
        let peak_held_triangles = self.pending.peak_triangle_count();
        Ok(BlocksReport { cost, block_count, peak_held_triangles, ..self.report })
    }

    /// Enters the group of a block; when a group ends, its waiting strips are written.
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

    /// Fills the window with adjacent loose strips, the ends of adjacent chains, and the block's triangles.
    fn fill_window(&mut self, block: &Block) {
        self.window.clear();
        for TouchedStrip { strip, touched_sides } in self.pending.take_adjacent(block) {
            match strip {
                PendingStrip::Loose { triangles, .. } => triangles.iter().for_each(|t| self.window.push(t)),
                PendingStrip::Chain { chain, ends } => {
                    self.joints.push(chain, ends, &touched_sides, &mut self.window)
                }
            }
        }
        let report = &mut self.report;
        report.carried_count += self.window.triangle_count();
        block.triangles.iter().for_each(|t| self.window.push(t));
        report.peak_block_triangles = report.peak_block_triangles.max(block.triangles.len());
        report.peak_window_triangles = report.peak_window_triangles.max(self.window.triangle_count());
    }

    fn write_expired(&mut self, block: u32) -> Result<(), W> {
        while let Some(strip) = self.pending.take_expired(block) {
            self.writer.push(&strip)?;
        }
        Ok(())
    }

    /// Distributes the strips of the window: appended to a chain, added to the waiting strips, or written.
    fn distribute(&mut self, strips: &StripSet, block_triangles: usize) -> Result<(), W> {
        let is_loose = self.choose_loose(strips, block_triangles.max(MIN_LOOSE_TRIANGLES) / 2);
        for (strip, is_loose) in strips.strips().zip(is_loose) {
            let in_mesh = self.window.strip_in_mesh(strip);
            if self.joints.join(&in_mesh, &self.window) {
                continue;
            }
            let pending = if is_loose {
                let triangles = strip_triangles(strip).map(|t| self.window.to_mesh_triangle(t)).collect();
                PendingStrip::Loose { strip: in_mesh, triangles, open: self.window.open_sides(strip) }
            } else {
                let chain = BlockChain::new(&in_mesh);
                let end_of = |end| {
                    chain.last_edge(end)?;
                    self.window.open_sides_in_mesh(chain.end_triangle(end))
                };
                let ends =
                    ChainEnd::BOTH.map(|e| end_of(e).map(|(triangle, open)| OpenEnd { triangle, open }));
                PendingStrip::Chain { chain, ends }
            };
            self.keep_or_write(pending)?;
        }
        for part in self.joints.take_all() {
            self.keep_or_write(part)?;
        }
        Ok(())
    }

    /// Selects the strips that a later block may take apart: those with the most open sides for their length.
    fn choose_loose(&self, strips: &StripSet, budget: usize) -> Vec<bool> {
        let mut chosen = vec![false; strips.strip_count()];
        let mut candidates: Vec<(usize, usize, usize)> = Vec::new();
        for (index, strip) in strips.strips().enumerate() {
            let side_count = self.window.open_side_count(strip);
            let triangle_count = strip_triangles(strip).count();
            if side_count > 0 && triangle_count <= MIN_CHAIN_TRIANGLES.max(LOOSE_TRIANGLES * side_count) {
                candidates.push((side_count, triangle_count, index));
            }
        }
        candidates.sort_by(|a, b| (b.0 * a.1).cmp(&(a.0 * b.1)).then(a.2.cmp(&b.2)));
        let mut left = budget;
        for (_, triangle_count, index) in candidates {
            chosen[index] = triangle_count <= left;
            left -= if chosen[index] { triangle_count } else { 0 };
        }
        chosen
    }

    /// Keeps a strip for later blocks if it can grow and the limit allows it; otherwise writes it.
    fn keep_or_write(&mut self, strip: PendingStrip) -> Result<(), W> {
        let count = strip.triangle_count();
        let can_grow = match &strip {
            PendingStrip::Loose { .. } => true,
            PendingStrip::Chain { ends, .. } => {
                ends.iter().any(Option::is_some)
                    && (MIN_CHAIN_TRIANGLES..MAX_CHAIN_TRIANGLES).contains(&count)
            }
        };
        if can_grow && self.pending.triangle_count() + count <= self.options.held_limit {
            self.pending.push(strip);
            return Ok(());
        }
        self.writer.push(&strip)
    }
}

/// Checks that no vertex has the index that is reserved for restarts.
fn check_vertices<R, W>(index: u32, block: &Block) -> Result<(), BlocksError<R, W>> {
    match block.triangles.iter().position(|triangle| triangle.corners.contains(&RESTART)) {
        Some(triangle) => Err(BlocksError::ReservedVertex { block: index, triangle }),
        None => Ok(()),
    }
}

/// Writes strips and sums up their cost.
struct BlockStripWriter<'a, W> {
    write: &'a mut WriteStripFn<'a, W>,
    group: u32,
    /// Whether the group already has a strip.
    is_begun: bool,
    cost: StripCost,
}

impl<W> BlockStripWriter<'_, W> {
    fn push(&mut self, strip: &PendingStrip) -> Result<(), W> {
        let mut indices = Vec::new();
        strip.write(&mut indices);
        let triangle_count = strip_triangles(&indices).count();
        self.cost.triangle_count += triangle_count;
        self.cost.strip_count += 1;
        self.cost.swap_count += indices.len().saturating_sub(2) - triangle_count;
        self.cost.index_count += indices.len() + usize::from(self.is_begun);
        self.cost.longest_strip = self.cost.longest_strip.max(indices.len());
        self.is_begun = true;
        (self.write)(self.group, &indices)
    }
}
