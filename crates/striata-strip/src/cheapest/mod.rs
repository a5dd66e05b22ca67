//! Strips with the fewest indices, by simulated annealing: a GPU pays for indices, not for strips.
//!
//! A strip of `n` triangles takes `n + 2` indices, one more per swap, and a restart. The cost to minimize is
//! therefore `swaps + 3 * strips`. Starting from greedy strips, links are flipped one at a time (`anneal`);
//! the cost of a flip follows from the triangles around the link (`strip_state`). Finally, strips whose ends
//! meet at a vertex are joined there (`stitch`), which saves the restart. The search counts these meetings as
//! it goes; on the bunny that lowers the cost from 1.131 to 1.122 indices per triangle in the same time.
//!
//! Large meshes are searched in parts (`parts`), on several threads: on meshes of 100,000 and 400,000 triangles in 2 and
//! 8 parts, strips take 1.268 instead of 1.266, and 1.281 instead of 1.279, indices per triangle.
//!
//! The cost function is closest to \[ESV96\] and \[XHM99\]; the moves and the joints are our own. The
//! budget determines the time; memory is 45 bytes per triangle.

mod anneal;
mod parts;
mod stitch;
mod strip_state;

use striata::Cancelled;
use striata::strip::{StripLinks, StripOrder, StripSet, join_greedily_with_progress};

use crate::task::{SearchLimits, StripTask};
use anneal::{COLD, HOT_TO_COLD};
use parts::StripParts;

/// Share of the budget during which the search cools down; the rest runs cold.
const COOLING_SHARE: f64 = 0.8;
/// Indices per triangle up to which strips are not improved, as on a grid.
const BEST: f64 = 1.005;
/// Share of the budget that is spent within parts of a large mesh; the rest is spent along their borders.
const PARTS_SHARE: f64 = 0.95;

/// Improves strips until the budget is spent, and writes them.
///
/// On a regular mesh, whose initial strips are nearly optimal, a hot search loses more than it can win back
/// in time. If the strips that the search began with were cheaper, the search starts again from those and
/// stays cold.
pub(crate) fn run(
    task: &StripTask<'_>,
    links: &mut StripLinks<'_>,
    limits: &mut dyn SearchLimits,
    out: &mut StripSet,
) -> Result<(), Cancelled> {
    join_greedily_with_progress(task.triangles, task.groups, links, &mut |now| limits.report(now))?;
    let mut start = StripSet::new();
    stitch::write(task, links, &mut start);
    if start.cost().index_count as f64 <= BEST * task.triangles.len() as f64 {
        *out = start;
        return Ok(());
    }
    let mut order = Vec::with_capacity(task.triangles.len());
    let mut strips = StripOrder::new(task.triangles);
    for group in task.groups {
        strips.visit(group.clone(), links, |path| order.extend(path.triangles(links)));
    }
    let mut parts = StripParts::new(&order, task, links);
    let cost = parts.anneal(HOT_TO_COLD, &mut |moves| limits.spent(moves) / COOLING_SHARE);
    limits.check()?;
    if cost > 0 {
        parts = StripParts::new(&order, task, links);
    }
    let share = if parts.are_several() { PARTS_SHARE } else { 1.0 };
    let colder = parts.anneal(COLD, &mut |moves| limits.spent(moves) / share);
    if cost <= 0 || colder < 0 {
        parts.write_links(links);
    }
    if parts.are_several() {
        let before = parts.join(&order, task, links);
        parts.anneal(COLD, &mut |moves| limits.spent(before + moves));
        parts.write_links(links);
    }
    limits.check()?;
    stitch::write(task, links, out);
    // The search's cost differs slightly from the written one: not all ends that meet can be joined.
    if start.cost().index_count < out.cost().index_count {
        *out = start;
    }
    Ok(())
}
