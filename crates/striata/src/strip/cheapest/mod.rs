//! Fewest indices: what a GPU pays for is not the number of strips but that of indices.
//!
//! A strip of `n` triangles takes `n + 2` indices, one more for every swap, and a restart: so `swaps + 3 * strips` is to
//! be least. From greedy strips on, links are turned over one at a time (`anneal`), with costs that only the triangles
//! around a link decide (`state`). At last strips whose ends meet at a vertex are joined there (`stitch`), which
//! saves the restart; the search knows that and lets ends meet.
//!
//! Nearest to \[ESV96\] and \[XHM99\] in what it counts; the moves and the joints are our own.
//! Time is the budget's, memory 45 bytes a triangle.

mod anneal;
mod state;
mod stitch;

use super::StripLinks;
use super::stripifier::{SpentFn, Task};
use super::write::StripOrder;
use super::{StripSet, greedy};
use state::State;

/// Improves strips for as long as the budget lasts, and writes them.
pub(super) fn run(task: &Task<'_>, links: &mut StripLinks<'_>, spent: &mut SpentFn<'_>, out: &mut StripSet) {
    greedy::run(task, links);
    let mut order = Vec::with_capacity(task.triangles.len());
    let mut strips = StripOrder::new(task.triangles);
    for group in &task.groups {
        strips.visit(group.clone(), links, |path| order.extend(path.triangles(links)));
    }
    let mut state = State::new(order, task.triangles, links);
    anneal::anneal(&mut state, task.options.seed, spent);
    state.write_links(links);
    stitch::write(task, links, out);
}
