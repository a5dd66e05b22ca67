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

use striata::strip::{StripLinks, StripOrder, StripSet, join_greedily};

use crate::task::{SpentFn, Task};
use anneal::{Annealer, COLD, HOT_TO_COLD};
use state::State;

/// Share of the budget that a search takes from hot to cold; the rest goes on cold.
const COOLING_SHARE: f64 = 0.8;

/// Improves strips for as long as the budget lasts, and writes them.
///
/// A regular mesh, whose strips hardly can be better, loses more by heat than it gains in the time: where the
/// strips that the search began with were cheaper, it goes on from those and stays cold.
pub(crate) fn run(task: &Task<'_>, links: &mut StripLinks<'_>, spent: &mut SpentFn<'_>, out: &mut StripSet) {
    join_greedily(task.triangles, task.groups, links);
    let mut start = StripSet::new();
    stitch::write(task, links, &mut start);
    let mut order = Vec::with_capacity(task.triangles.len());
    let mut strips = StripOrder::new(task.triangles);
    for group in task.groups {
        strips.visit(group.clone(), links, |path| order.extend(path.triangles(links)));
    }
    let mut state = State::new(order, task.triangles, links);
    let mut annealer = Annealer::new(&mut state, task.options.seed);
    let cost = annealer.anneal(HOT_TO_COLD, &mut |moves| spent(moves) / COOLING_SHARE);
    if cost <= 0 {
        annealer.anneal(COLD, spent);
        state.write_links(links);
    } else {
        let mut state = State::new(state.into_order(), task.triangles, links);
        let mut annealer = Annealer::new(&mut state, task.options.seed);
        if annealer.anneal(COLD, spent) < 0 {
            state.write_links(links);
        }
    }
    stitch::write(task, links, out);
    // What the search counts differs a little from what is written: not all ends that meet can be joined.
    if start.cost().index_count < out.cost().index_count {
        *out = start;
    }
}
