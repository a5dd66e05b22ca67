//! What happens to each block: a window of it and of what waited, strips, and which of them wait in turn.

use striata::strip::{RESTART, StripCost, StripSet, strip_triangles};

use super::chain::{Chain, End};
use super::held::{Held, HeldStrip, OpenEnd, Reached};
use super::joints::Joints;
use super::options::{BlockOptions, BlocksError, BlocksReport, WriteStripFn};
use super::source::Block;
use super::window::Window;

/// A strip that has more triangles than this for each of its open sides is not taken apart again.
const LOOSE_TRIANGLES: usize = 8;
/// Fewest triangles of a strip that others may go on with: shorter ones are taken apart.
const SHORTEST_CHAIN: usize = 8;
/// Strips that have so many triangles are written: what going on would save is nothing beside them.
const LONGEST_CHAIN: usize = 1000;
/// Fewest triangles that may be taken apart again, however small the block was.
const LEAST_LOOSE: usize = 4096;

/// The state between two blocks.
pub(super) struct Work<'a, W> {
    options: &'a BlockOptions,
    writer: Writer<'a, W>,
    held: Held,
    window: Window,
    joints: Joints,
    report: BlocksReport,
}

impl<'a, W> Work<'a, W> {
    pub(super) fn new(options: &'a BlockOptions, write: &'a mut WriteStripFn<'a, W>) -> Self {
        Self {
            options,
            writer: Writer { write, group: 0, is_begun: false, cost: StripCost::default() },
            held: Held::default(),
            window: Window::default(),
            joints: Joints::default(),
            report: BlocksReport::default(),
        }
    }

    /// Makes strips of a block and of what waited for it; writes those that are complete.
    pub(super) fn add<R>(&mut self, number: u32, block: &Block) -> Result<(), BlocksError<R, W>> {
        self.enter_group(number, block.group)?;
        check_vertices(number, block)?;
        self.fill_window(block);
        self.write_expired(number).map_err(BlocksError::Write)?;
        let strips = self.window.stripify(&self.options.strip);
        let strips = strips.map_err(|error| BlocksError::TooLarge { block: number, error })?;
        self.window.find_rim(number, self.joints.sides());
        self.place(&strips, block.triangles.len()).map_err(BlocksError::Write)
    }

    /// Writes what still waits.
    pub(super) fn finish(mut self, block_count: u32) -> Result<BlocksReport, W> {
        self.write_expired(u32::MAX)?;
        let mut cost = self.writer.cost;
        if cost.triangle_count > 0 {
            cost.indices_per_triangle = cost.index_count as f64 / cost.triangle_count as f64;
        }
        let peak_held_triangles = self.held.peak_triangle_count();
        Ok(BlocksReport { cost, block_count, peak_held_triangles, ..self.report })
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

    /// A block's triangles, before them those of loose strips and the ends of chains beside them.
    fn fill_window(&mut self, block: &Block) {
        self.window.clear();
        for Reached { strip, at } in self.held.take_beside(block) {
            match strip {
                HeldStrip::Loose { triangles, .. } => triangles.iter().for_each(|t| self.window.push(t)),
                HeldStrip::Chain { chain, ends } => self.joints.push(chain, ends, &at, &mut self.window),
            }
        }
        let report = &mut self.report;
        report.carried_count += self.window.triangle_count();
        block.triangles.iter().for_each(|t| self.window.push(t));
        report.peak_block_triangles = report.peak_block_triangles.max(block.triangles.len());
        report.peak_window_triangles = report.peak_window_triangles.max(self.window.triangle_count());
    }

    fn write_expired(&mut self, block: u32) -> Result<(), W> {
        while let Some(strip) = self.held.take_expired(block) {
            self.writer.push(&strip)?;
        }
        Ok(())
    }

    /// Puts every strip of the window where it belongs: on to a chain, among what waits, or out.
    fn place(&mut self, strips: &StripSet, block_triangles: usize) -> Result<(), W> {
        let is_loose = self.choose_loose(strips, block_triangles.max(LEAST_LOOSE) / 2);
        for (strip, is_loose) in strips.strips().zip(is_loose) {
            let in_mesh = self.window.strip_in_mesh(strip);
            if self.joints.join(&in_mesh, &self.window) {
                continue;
            }
            let held = if is_loose {
                let triangles = strip_triangles(strip).map(|t| self.window.in_mesh(t)).collect();
                HeldStrip::Loose { strip: in_mesh, triangles, open: self.window.open_sides(strip) }
            } else {
                let chain = Chain::new(&in_mesh);
                let end_of = |end| {
                    chain.last_edge(end)?;
                    self.window.open_sides_in_mesh(chain.end_triangle(end))
                };
                let ends = End::BOTH.map(|e| end_of(e).map(|(triangle, open)| OpenEnd { triangle, open }));
                HeldStrip::Chain { chain, ends }
            };
            self.hold_or_write(held)?;
        }
        for part in self.joints.take_all() {
            self.hold_or_write(part)?;
        }
        Ok(())
    }

    /// Which strips are worth to be taken apart by a later block: those with most open sides for their length.
    fn choose_loose(&self, strips: &StripSet, budget: usize) -> Vec<bool> {
        let mut chosen = vec![false; strips.strip_count()];
        let mut candidates: Vec<(usize, usize, usize)> = Vec::new();
        for (index, strip) in strips.strips().enumerate() {
            let side_count = self.window.open_side_count(strip);
            let triangle_count = strip_triangles(strip).count();
            if side_count > 0 && triangle_count <= SHORTEST_CHAIN.max(LOOSE_TRIANGLES * side_count) {
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

    fn hold_or_write(&mut self, strip: HeldStrip) -> Result<(), W> {
        let count = strip.triangle_count();
        let can_grow = match &strip {
            HeldStrip::Loose { .. } => true,
            HeldStrip::Chain { ends, .. } => {
                ends.iter().any(Option::is_some) && (SHORTEST_CHAIN..LONGEST_CHAIN).contains(&count)
            }
        };
        if can_grow && self.held.triangle_count() + count <= self.options.held_limit {
            self.held.push(strip);
            return Ok(());
        }
        self.writer.push(&strip)
    }
}

fn check_vertices<R, W>(number: u32, block: &Block) -> Result<(), BlocksError<R, W>> {
    match block.triangles.iter().position(|triangle| triangle.corners.contains(&RESTART)) {
        Some(triangle) => Err(BlocksError::ReservedVertex { block: number, triangle }),
        None => Ok(()),
    }
}

/// Hands strips out and counts what they cost.
struct Writer<'a, W> {
    write: &'a mut WriteStripFn<'a, W>,
    group: u32,
    /// Whether the group has a strip.
    is_begun: bool,
    cost: StripCost,
}

impl<W> Writer<'_, W> {
    fn push(&mut self, strip: &HeldStrip) -> Result<(), W> {
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
