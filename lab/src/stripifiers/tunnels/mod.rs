//! Stripification by tunnels as published: \[PS03\] with dynamic identities, and \[Ste01\] with static ones.
//!
//! The library's `tunnel` grows strips before it searches, and moves ends that have no tunnel. Here, every
//! triangle begins as a strip of its own, ends are taken in random order, each end gets the shortest tunnel
//! that a breadth-first search finds from it, and all ends are tried again until none has a tunnel. A tunnel
//! alternates dashed and solid links; making the dashed ones solid and the solid ones dashed joins two strips
//! (`strip` of the library explains the terms). Two rules keep loops out \[PS03, 3.1\]: the last link must
//! lead to another strip, and inside a strip a tunnel must turn back toward its moving end. Whether two
//! triangles are in one strip is known from identities:
//!
//! * [`Identities::Dynamic`] \[PS03, 4\]: each step of a search pushes the identity of the moving end along the
//!   triangles that it takes over, and a step back restores them. The rules are then exact (`dynamic`).
//! * [`Identities::Static`] \[Ste01\]: identities, and the direction of the moving end, are those of the
//!   beginning of the search. The rules then let loops pass, so each tunnel is checked by walking before it
//!   is accepted (`fixed`).
//!
//! Differs: \[PS03\] keeps a stack of identities in every node; here one log lists the changes of all nodes in
//! order, which undoes them just as well. \[Ste01\] is known to us through \[PS03\]; how it treats loops is our
//! reading, chosen because it leaves as many strips of the bunny as \[PS03\] reports (158) at lengths that \[Ste01\] used.

mod dynamic;
mod fixed;
mod options;
mod path_search;

use striata::mesh::{Random, is_proper};
use striata::strip::StripLinks;

use dynamic::DynamicTunnels;
use fixed::StaticTunnels;
use options::FindTunnels;

pub use options::{EndOrder, Identities, TunnelOptions, Visits};

/// Counts of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TunnelReport {
    /// Number of times that all ends were tried.
    pub pass_count: usize,
    /// Number of searches.
    pub search_count: usize,
    /// Number of tunnels applied: each joins two strips.
    pub tunnel_count: usize,
    /// Number of tunnels found that would have closed a loop; 0 with dynamic identities.
    pub loop_count: usize,
}

/// Starts a search.
fn search(options: &TunnelOptions, links: &StripLinks<'_>) -> Box<dyn FindTunnels> {
    let mut tunnels: Box<dyn FindTunnels> = match options.identities {
        Identities::Dynamic => Box::new(DynamicTunnels::new(links, options)),
        Identities::Static => Box::new(StaticTunnels::new(links, options)),
    };
    tunnels.set_max_length(options.max_length);
    tunnels
}

/// Joins strips along tunnels until no end has one; the links may contain strips already, but no loops.
///
/// Degenerate triangles are left out.
///
/// # Panics
/// If `triangles` are not those of the links' graph.
pub fn join_along_tunnels(
    triangles: &[[u32; 3]],
    links: &mut StripLinks<'_>,
    options: &TunnelOptions,
) -> TunnelReport {
    let mut tunnels = search(options, links);
    let mut random = Random::new(options.seed);
    let mut report = TunnelReport::default();
    let mut max_length = if options.order == EndOrder::ShortestFirst { 1 } else { options.max_length };
    loop {
        tunnels.set_max_length(max_length);
        let mut found_count = 0;
        for end in shuffled_ends(triangles, links, &mut random) {
            // Another tunnel may have made it the inside of a strip.
            let mut from = (links.solid_degree(end) < 2).then_some(end);
            while let Some(end) = from.take() {
                report.search_count += 1;
                if tunnels.apply_shortest(end, links, &mut random) {
                    found_count += 1;
                    from = (options.order == EndOrder::SameStrip).then(|| strip_end(end, links, &mut random));
                }
            }
        }
        report.pass_count += 1;
        report.tunnel_count += found_count;
        if found_count == 0 {
            if max_length >= options.max_length {
                report.loop_count = tunnels.loop_count();
                return report;
            }
            max_length = (max_length + 2).min(options.max_length);
        }
    }
}

/// Joins two strips along one tunnel; returns the sides whose links it has complemented, one for each link, or
/// [`None`] if no end has a tunnel.
///
/// # Panics
/// If `triangles` are not those of the links' graph.
pub fn join_along_one_tunnel(
    triangles: &[[u32; 3]],
    links: &mut StripLinks<'_>,
    options: &TunnelOptions,
) -> Option<Vec<u32>> {
    let before = links.clone();
    let mut tunnels = search(options, links);
    let mut random = Random::new(options.seed);
    let mut ends = shuffled_ends(triangles, links, &mut random).into_iter();
    ends.find(|&end| tunnels.apply_shortest(end, links, &mut random))?;
    let is_changed =
        |&side: &u32| side < links.twins()[side as usize] && before.is_solid(side) != links.is_solid(side);
    Some((0..3 * links.triangle_count() as u32).filter(is_changed).collect())
}

/// Returns either end of the strip of a triangle.
fn strip_end(triangle: u32, links: &StripLinks<'_>, random: &mut Random) -> u32 {
    let Some(first) = links.first_solid(triangle) else { return triangle };
    let sides = [Some(first), links.other_solid(first)];
    let mut at = triangle;
    let mut exit = sides[random.below(2) as usize];
    while let Some(side) = exit {
        let entered = links.twins()[side as usize];
        (at, exit) = (entered / 3, links.other_solid(entered));
    }
    at
}

/// Returns the triangles at which strips end, in random order.
fn shuffled_ends(triangles: &[[u32; 3]], links: &StripLinks<'_>, random: &mut Random) -> Vec<u32> {
    let is_end = |&t: &u32| links.solid_degree(t) < 2 && is_proper(&triangles[t as usize]);
    let mut ends: Vec<u32> = (0..triangles.len() as u32).filter(is_end).collect();
    for i in (1..ends.len()).rev() {
        ends.swap(i, random.below(i as u32 + 1) as usize);
    }
    ends
}
