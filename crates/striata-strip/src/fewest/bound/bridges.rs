//! Lower bound of the strip count from the bridges of the dual graph.
//!
//! A bridge is a link that is the only connection between two parts of the dual graph; only one strip can
//! use it. The parts between bridges form a tree, and however well each part is covered, a strip that
//! passes through it uses two of its bridges. Counting the least number of strips over that tree gives a
//! bound that is valid for any interior of the parts. For example, a triangle with three bridges lets at
//! most one strip pass, and a triangle at the tip of a chain ends one.
//!
//! Every part of one triangle has at most three bridges. Linear in time, 30 bytes per triangle.

use striata::mesh::{DualGraph, NO_TWIN};

/// Depth-first search data of a triangle.
#[derive(Clone, Copy, Debug)]
struct Visit {
    /// Time of the first visit, or `NO_TWIN` if not visited.
    time: u32,
    /// Earliest triangle that its subtree has a link to.
    low: u32,
    /// Side of the previous triangle through which it was entered.
    entered: u32,
    /// Number of its sides that were followed.
    followed: u8,
    /// The part that this triangle belongs to, as far as its subtree has been searched.
    part: BridgePart,
}

/// Connected part of the graph below a triangle, up to the next bridges.
#[derive(Clone, Copy, Debug, Default)]
struct BridgePart {
    /// Number of strips behind its bridges if those bridges are not used.
    beyond: u32,
    /// Number of bridges that save a strip when used.
    useful: u32,
    /// Whether it has more than one triangle.
    is_large: bool,
}

impl BridgePart {
    /// Returns the number of strips of the part and of everything behind its bridges, if `outer` further
    /// bridges are used.
    fn strips(self, outer: u32) -> u32 {
        let used = if self.is_large { self.useful } else { self.useful.min(2 - outer) };
        self.beyond + (used + outer).div_ceil(2).max(1) - used
    }

    /// Adds a part found below, across a bridge or a normal link.
    fn add(&mut self, below: Self, is_bridge: bool) {
        if is_bridge {
            let (unused, used) = (below.strips(0), below.strips(1) - 1);
            self.beyond += unused;
            self.useful += u32::from(used < unused);
        } else {
            self.beyond += below.beyond;
            self.useful += below.useful;
            self.is_large = true;
        }
    }
}

/// Returns a lower bound of the strip count for each component, in the order of their first triangles.
///
/// Calls `found` with every triangle and its component. Triangles that are `left_out` belong to no
/// component and have no link.
pub(super) fn least_strips(
    graph: &DualGraph,
    left_out: impl Fn(u32) -> bool,
    mut found: impl FnMut(u32, u32),
) -> Vec<u32> {
    let count = graph.triangle_count();
    let unseen = Visit { time: NO_TWIN, low: 0, entered: NO_TWIN, followed: 0, part: BridgePart::default() };
    let mut search =
        BridgeSearch { twins: graph.twins(), visits: vec![unseen; count], time: 0, stack: Vec::new() };
    let mut least = Vec::new();
    for triangle in 0..count as u32 {
        if search.visits[triangle as usize].time == NO_TWIN && !left_out(triangle) {
            let component = least.len() as u32;
            let part = search.run(triangle, |triangle| found(triangle, component));
            least.push(part.strips(0));
        }
    }
    least
}

/// Depth-first search without recursion.
struct BridgeSearch<'a> {
    twins: &'a [u32],
    visits: Vec<Visit>,
    time: u32,
    stack: Vec<u32>,
}

impl BridgeSearch<'_> {
    /// Searches a component and returns the part that contains the start triangle.
    fn run(&mut self, root: u32, mut found: impl FnMut(u32)) -> BridgePart {
        self.enter(root, NO_TWIN);
        found(root);
        while let Some(&triangle) = self.stack.last() {
            let visit = &mut self.visits[triangle as usize];
            let side = 3 * triangle + u32::from(visit.followed);
            if visit.followed == 3 {
                self.stack.pop();
                self.leave(triangle);
                continue;
            }
            visit.followed += 1;
            let twin = self.twins[side as usize];
            // The link by which it was entered leads back; a second link between the same two triangles
            // does not count as back.
            if twin == NO_TWIN || twin == visit.entered {
                continue;
            }
            let other = self.visits[twin as usize / 3].time;
            if other == NO_TWIN {
                self.enter(twin / 3, side);
                found(twin / 3);
            } else {
                let low = &mut self.visits[triangle as usize].low;
                *low = (*low).min(other);
            }
        }
        self.visits[root as usize].part
    }

    fn enter(&mut self, triangle: u32, entered: u32) {
        let time = self.time;
        self.time += 1;
        self.visits[triangle as usize] =
            Visit { time, low: time, entered, followed: 0, part: BridgePart::default() };
        self.stack.push(triangle);
    }

    /// Merges the part below a triangle into that of its predecessor.
    fn leave(&mut self, triangle: u32) {
        let Visit { low, entered, part, .. } = self.visits[triangle as usize];
        if entered == NO_TWIN {
            return;
        }
        let parent = &mut self.visits[entered as usize / 3];
        parent.low = parent.low.min(low);
        let is_bridge = low > parent.time;
        parent.part.add(part, is_bridge);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::{IndexedMesh, shapes};

    fn bound(mesh: &IndexedMesh) -> u32 {
        least_strips(&DualGraph::of_vertices(mesh), |_| false, |_, _| ()).iter().sum()
    }

    #[test]
    fn parts_that_one_strip_can_cover_need_one() {
        assert_eq!(bound(&shapes::tetrahedron()), 1);
        assert_eq!(bound(&shapes::grid(5, 4)), 1);
        assert_eq!(bound(&shapes::triangle_fan(7)), 1);
        assert_eq!(bound(&shapes::many_components(13)), 13);
    }

    #[test]
    fn a_triangle_with_three_arms_needs_two() {
        // A middle triangle with a neighbor on each of its sides.
        let star = [[0, 1, 2], [1, 0, 3], [2, 1, 4], [0, 2, 5]];
        let mesh = |triangles: &[[u32; 3]]| IndexedMesh::new(vec![[0.0; 3]; 20], triangles.to_vec());
        assert_eq!(bound(&mesh(&star)), 2);
        // Each arm forks again: four triangles with three links each, and six tips.
        let mut tree = star.to_vec();
        for (arm, k) in [(1, 6), (2, 9), (3, 12)] {
            let [a, b, c]: [u32; 3] = star[arm];
            tree.extend([[c, b, k], [a, c, k + 1]]);
        }
        // However the middle is covered, two arms keep a tip for themselves, or the middle stays alone.
        assert_eq!(bound(&mesh(&tree)), 4);
    }
}
