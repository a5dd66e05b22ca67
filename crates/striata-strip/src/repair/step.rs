//! One step: the mesh changes, strips continue across the changed triangles, and tunnels repair the rest.

use striata::mesh::NO_TWIN;
use striata::strip::StripLinks;

use super::live_strips::LiveStrips;
use super::options::{RepairGoal, RepairReport};
use super::scratch::RepairScratch;
use super::tunnel_search::{TunnelChange, TunnelSearch, swap_at};

impl LiveStrips<'_> {
    /// Takes one step toward the base mesh, to the level at the current split count.
    pub(super) fn coarsen(&mut self, report: &mut RepairReport) {
        self.scratch.touched.clear();
        for vertex in self.sequence.step_vertices(self.split_count()).rev() {
            self.collapse(vertex, report);
        }
        report.collapse_count += 1;
        self.repair(report);
    }

    /// Takes one step toward the full mesh, from the level at the current split count.
    pub(super) fn refine(&mut self, report: &mut RepairReport) {
        self.scratch.touched.clear();
        for vertex in self.sequence.step_vertices(self.split_count()) {
            self.vertex_split(vertex, report);
        }
        report.split_count += 1;
        self.repair(report);
    }

    /// Removes a vertex; strips continue past triangles that disappear inside them.
    fn collapse(&mut self, vertex: u32, report: &mut RepairReport) {
        let target = self.sequence.target(vertex);
        let Self { graph, scratch, .. } = self;
        let RepairScratch { changed: dying, bridges, touched, .. } = scratch;
        graph.dying_into(vertex, target, dying);
        bridges.clear();
        touched.extend(graph.corners_at(vertex).map(|corner| corner / 3));
        let mut links = StripLinks::from_bits(graph.twins(), std::mem::take(&mut self.solid));
        let mut cut_count = 0;
        for &triangle in dying.iter() {
            touched.extend(neighbors(&links, triangle));
            let solid = links.first_solid(triangle);
            if let Some((one, other)) = solid.and_then(|one| Some((one, links.other_solid(one)?))) {
                bridges.push([one, other].map(|side| links.twins()[side as usize]));
            }
            while let Some(side) = links.first_solid(triangle) {
                links.cut(side);
                cut_count += 1;
            }
        }
        self.solid = links.into_bits();
        graph.collapse(vertex, target, dying);
        self.triangle_count -= dying.len();
        self.count_links(0, cut_count, report);

        let Self { graph, scratch, .. } = self;
        let mut links = StripLinks::from_bits(graph.twins(), std::mem::take(&mut self.solid));
        let mut joined_count = 0;
        for &[one, other] in &scratch.bridges {
            if links.twins()[one as usize] == other {
                links.join(one);
                joined_count += 1;
            }
        }
        self.solid = links.into_bits();
        self.count_links(joined_count, 0, report);
    }

    /// Restores a vertex; strips continue through triangles that appear inside them.
    fn vertex_split(&mut self, vertex: u32, report: &mut RepairReport) {
        let target = self.sequence.target(vertex);
        let Self { graph, scratch, .. } = self;
        let RepairScratch { changed: restored, detached, bridges, .. } = scratch;
        graph.detach_into(vertex, target, detached);
        bridges.clear();
        let mut links = StripLinks::from_bits(graph.twins(), std::mem::take(&mut self.solid));
        for &side in detached.iter() {
            let ends = [side, links.twins()[side as usize]];
            scratch.touched.extend(ends.map(|side| side / 3));
            if links.is_solid(side) {
                links.cut(side);
                bridges.push(ends);
            }
        }
        let cut_count = bridges.len();
        self.solid = links.into_bits();
        graph.restore_into(vertex, target, detached, restored);
        self.triangle_count += restored.len();
        self.count_links(0, cut_count, report);

        let Self { graph, scratch, .. } = self;
        let RepairScratch { changed: restored, bridges, touched, .. } = scratch;
        touched.extend(graph.corners_at(vertex).map(|corner| corner / 3));
        let mut links = StripLinks::from_bits(graph.twins(), std::mem::take(&mut self.solid));
        for &triangle in restored.iter() {
            touched.extend(neighbors(&links, triangle));
        }
        let mut joined_count = 0;
        for &ends in bridges.iter() {
            let [a, b] = ends.map(|side| links.twins()[side as usize]);
            if a != NO_TWIN && b != NO_TWIN && a / 3 == b / 3 && links.solid_degree(a / 3) == 0 {
                links.join(a);
                links.join(b);
                joined_count += 2;
            }
        }
        self.solid = links.into_bits();
        self.count_links(joined_count, 0, report);
    }

    /// Adds joined and cut links to the report and to the number of solid links.
    fn count_links(&mut self, joined_count: usize, cut_count: usize, report: &mut RepairReport) {
        report.joined_count += joined_count;
        report.cut_count += cut_count;
        self.solid_count = self.solid_count + joined_count - cut_count;
    }

    /// Searches for tunnels from the triangles around a step, and from the triangles that the found tunnels
    /// pass.
    fn repair(&mut self, report: &mut RepairReport) {
        let Self { graph, scratch, search, changes, .. } = self;
        let seeds = &mut scratch.touched;
        let mut links = StripLinks::from_bits(graph.twins(), std::mem::take(&mut self.solid));
        seeds.sort_unstable();
        seeds.dedup();
        report.touched_count += seeds.len();
        seeds.iter().for_each(|&triangle| changes.add(triangle));
        for _ in 0..self.reach {
            for i in 0..seeds.len() {
                seeds.extend(neighbors(&links, seeds[i]));
            }
            seeds.sort_unstable();
            seeds.dedup();
        }
        let seed_limit = 2 * seeds.len();
        let (mut joined_count, mut cut_count) = (0, 0);
        let mut next = 0;
        while let Some(&seed) = seeds.get(next) {
            next += 1;
            if let Some(found) = search_at(seed, self.goal, &mut links, search) {
                report.tunnel_count += usize::from(found.is_gain);
                joined_count += found.joined_count;
                cut_count += found.cut_count;
                seeds.extend(search.touched_triangles().take(seed_limit.saturating_sub(seeds.len())));
                for side in search.touched_sides() {
                    changes.add(side / 3);
                    changes.add(links.twins()[side as usize] / 3);
                }
            }
        }
        self.solid = links.into_bits();
        self.count_links(joined_count, cut_count, report);
    }
}

/// Searches from one triangle: if it is an end, from there; otherwise across those of its links that are
/// swaps.
fn search_at(
    seed: u32,
    goal: RepairGoal,
    links: &mut StripLinks<'_>,
    search: &mut TunnelSearch,
) -> Option<TunnelChange> {
    if links.solid_degree(seed) < 2 {
        return search.search_from_end(links, seed);
    }
    if goal == RepairGoal::FewestStrips {
        return None;
    }
    (3 * seed..3 * seed + 3).find_map(|side| {
        let is_swap = links.is_solid(side) && swap_at(links, side) > 0;
        if is_swap { search.search_across(links, side) } else { None }
    })
}

/// Iterates over the triangles linked to a triangle.
fn neighbors(links: &StripLinks<'_>, triangle: u32) -> impl Iterator<Item = u32> {
    let sides = 3 * triangle as usize..3 * triangle as usize + 3;
    links.twins()[sides].iter().filter(|&&twin| twin != NO_TWIN).map(|&twin| twin / 3)
}
