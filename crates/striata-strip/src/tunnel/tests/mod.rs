//! The worked examples of \[PS03\] as dual graphs drawn by hand, and tunnels on random meshes.

mod pushed_identities;

use proptest::prelude::*;
use striata::mesh::{DualGraph, IndexedMesh, NO_TWIN, Random, is_proper, shapes};
use striata::strip::StripLinks;

use super::growth::join_ends;
use super::location_table::LocationTable;
use super::search::TunnelPathSearch;
use super::trace::{Relation, StripLocations, StripTrace, TunnelStep};
use super::{TunnelJoiner, swap_links};
use pushed_identities::PushedIdentities;

/// Builds the twins of a dual graph from pairs of linked nodes.
fn twins_of(node_count: u32, edges: &[(u32, u32)]) -> Vec<u32> {
    let mut twins = vec![NO_TWIN; 3 * node_count as usize];
    for &(a, b) in edges {
        let free = |node: u32, twins: &[u32]| {
            (3 * node..3 * node + 3).find(|&side| twins[side as usize] == NO_TWIN).unwrap()
        };
        let (side, twin) = (free(a, &twins), free(b, &twins));
        twins[side as usize] = twin;
        twins[twin as usize] = side;
    }
    twins
}

/// Returns the side of a node that leads to another.
fn side_between(twins: &[u32], a: u32, b: u32) -> u32 {
    let leads_to_b = |&side: &u32| twins[side as usize] != NO_TWIN && twins[side as usize] / 3 == b;
    (3 * a..3 * a + 3).find(leads_to_b).unwrap()
}

/// Makes links solid.
fn linked<'a>(twins: &'a [u32], solid: &[(u32, u32)]) -> StripLinks<'a> {
    let mut links = StripLinks::from_bits(twins, vec![0; twins.len() / 3]);
    solid.iter().for_each(|&(a, b)| links.join(side_between(twins, a, b)));
    links
}

/// Finds and applies the shortest tunnel from a node. Returns the nodes that it visits, in order.
fn apply(links: &mut StripLinks<'_>, start: u32, max_length: u32) -> Option<Vec<u32>> {
    let mut search = TunnelPathSearch::new(links.triangle_count(), max_length);
    let last = search.find(start, links, &LocationTable::new(links), &mut Random::new(7))?;
    swap_links(search.steps(), Some(last), links);
    let inner = search.steps().iter().flat_map(|step| [step.taken, step.end]);
    Some(std::iter::once(start).chain(inner).chain([links.twins()[last as usize] / 3]).collect())
}

/// Number of strips, or [`None`] if a solid link is part of a loop. Walks the strips by itself.
fn path_count(links: &StripLinks<'_>) -> Option<usize> {
    let mut is_seen = vec![false; links.triangle_count()];
    let mut count = 0;
    for end in 0..links.triangle_count() as u32 {
        let degree = (0..3).filter(|k| links.solid_bits(end) & 1 << k != 0).count();
        if degree == 2 || is_seen[end as usize] {
            continue;
        }
        count += 1;
        let (mut at, mut came_by) = (end, NO_TWIN);
        loop {
            assert!(!std::mem::replace(&mut is_seen[at as usize], true), "triangle {at} is in two strips");
            let next = (3 * at..3 * at + 3)
                .find(|&side| side != came_by && links.solid_bits(at) & 1 << (side % 3) != 0);
            let Some(exit) = next else { break };
            came_by = links.twins()[exit as usize];
            assert!(links.is_solid(came_by), "a link is solid on one side only");
            at = came_by / 3;
        }
    }
    is_seen.iter().all(|&seen| seen).then_some(count)
}

/// Figure 3: three strips become two along a tunnel of one link, then one along a tunnel of three.
#[test]
fn figure_3_a_tunnel_of_one_link_and_one_of_three() {
    // Strips 0 1 2, 3 and 4 5. Once 3 is joined to 2, no two ends are linked any more.
    let twins = twins_of(6, &[(0, 1), (1, 2), (4, 5), (3, 2), (2, 5), (4, 1)]);
    let mut links = linked(&twins, &[(0, 1), (1, 2), (4, 5)]);
    assert_eq!(path_count(&links), Some(3));
    assert_eq!(apply(&mut links, 3, 1), Some(vec![3, 2]));
    assert_eq!(path_count(&links), Some(2));
    for end in [0, 3, 4, 5] {
        assert_eq!(apply(&mut links.clone(), end, 1), None);
    }
    assert_eq!(apply(&mut links, 4, 3), Some(vec![4, 1, 2, 5]));
    assert_eq!(path_count(&links), Some(1));
}

/// Figure 4: the last link must not lead to the strip of the moving end.
#[test]
fn figure_4_the_last_link_leads_to_another_strip() {
    let twins = twins_of(4, &[(0, 1), (1, 2), (2, 3), (3, 0)]);
    let mut links = linked(&twins, &[(0, 1), (1, 2), (2, 3)]);
    assert_eq!(apply(&mut links, 0, 9), None);
    links.join(side_between(&twins, 3, 0));
    assert_eq!(path_count(&links), None, "the incorrect tunnel closes a loop");
}

/// Figure 5: a link inside the moving end's strip; the next link must lead back to the moving end.
#[test]
fn figure_5_inside_a_strip_the_tunnel_turns_back() {
    // Strip 0 1 2 3 4; the tunnel from 0 enters 2. Releasing 1, the neighbor toward 0, leaves one strip
    // 1 0 2 3 4, whose new end 1 reaches the strip 5. Releasing 3 would leave the loop 0 1 2.
    let edges = [(0, 1), (1, 2), (2, 3), (3, 4), (0, 2), (1, 5), (3, 6)];
    let twins = twins_of(7, &edges);
    let solid = [(0, 1), (1, 2), (2, 3), (3, 4)];
    let mut links = linked(&twins, &solid);
    assert_eq!(apply(&mut links, 0, 3), Some(vec![0, 2, 1, 5]));
    assert_eq!(path_count(&links), Some(2));

    let mut wrong = linked(&twins, &solid);
    let side = |a, b| side_between(&twins, a, b);
    swap_links(
        &[TunnelStep { crossed: side(0, 2), taken: 2, cut: side(2, 3), end: 3 }],
        Some(side(3, 6)),
        &mut wrong,
    );
    assert_eq!(path_count(&wrong), None, "the other direction closes a loop");

    // Without the strip 5, there is no tunnel: the strip 6 can only be reached in the wrong direction.
    let twins = twins_of(7, &[(0, 1), (1, 2), (2, 3), (3, 4), (0, 2), (3, 6)]);
    assert_eq!(apply(&mut linked(&twins, &solid), 0, 3), None);
}

/// Figure 7: every link obeys both rules by the identities from before the search, yet a loop closes.
#[test]
fn figure_7_identities_from_before_the_search_do_not_suffice() {
    // Strips 0 1 2 3 and 4 5 6 7. The tunnel 3 - 5 = 6 - 1 = 2 - 4 ends at another strip than that of 2, if
    // one asks for the strips before the search. But by then 2 3 5 4 is one strip.
    let solid = [(0, 1), (1, 2), (2, 3), (4, 5), (5, 6), (6, 7)];
    let dashed = [(3, 5), (6, 1), (2, 4)];
    let twins = twins_of(8, &[&solid[..], &dashed[..]].concat());
    let side = |a, b| side_between(&twins, a, b);
    let steps = [
        TunnelStep { crossed: side(3, 5), taken: 5, cut: side(5, 6), end: 6 },
        TunnelStep { crossed: side(6, 1), taken: 1, cut: side(1, 2), end: 2 },
    ];
    let links = linked(&twins, &solid);
    let before = LocationTable::new(&links);
    assert_ne!(before.strip(2), before.strip(4), "static identities accept the tunnel");

    let mut complemented = links.clone();
    swap_links(&steps, Some(side(2, 4)), &mut complemented);
    assert_eq!(path_count(&complemented), None);

    let mut trace = StripTrace::default();
    trace.follow(3, &steps, &links, &before);
    assert!(matches!(trace.relation(4, &before), Relation::SameMoved { .. }), "dynamic ones refuse it");
    assert_eq!(apply(&mut links.clone(), 3, 99), None);
}

/// A graph of a mesh whose strips are joined at random, without loops.
fn random_strips<'a>(mesh: &IndexedMesh, graph: &'a DualGraph, random: &mut Random) -> StripLinks<'a> {
    let mut links = StripLinks::new(graph);
    let mut identities: Vec<u32> = (0..links.triangle_count() as u32).collect();
    let mut sides: Vec<u32> = (0..3 * links.triangle_count() as u32).collect();
    for i in (1..sides.len()).rev() {
        sides.swap(i, random.below(i as u32 + 1) as usize);
    }
    let share = 40 + random.below(60);
    for side in sides {
        let twin = graph.twins()[side as usize];
        if twin == NO_TWIN || random.below(100) >= share {
            continue;
        }
        let (a, b) = (side / 3, twin / 3);
        let (one, other) = (identities[a as usize], identities[b as usize]);
        let is_free = |t: u32| links.solid_degree(t) < 2 && is_proper(&mesh.triangles[t as usize]);
        if one != other && is_free(a) && is_free(b) {
            links.join(side);
            identities.iter_mut().filter(|id| **id == other).for_each(|id| *id = one);
        }
    }
    links
}

/// Takes random steps from an end; after each, compares what the trace says with pushed identities.
fn check_traces(links: &StripLinks<'_>, start: u32, random: &mut Random) -> usize {
    let locations = LocationTable::new(links);
    let mut pushed = PushedIdentities::new(links.clone());
    let (mut steps, mut trace, mut end): (Vec<TunnelStep>, _, _) = (Vec::new(), StripTrace::default(), start);
    let mut compared_count = 0;
    for _ in 0..12 {
        trace.follow(start, &steps, links, &locations);
        let is_on_path = |t: u32| t == start || steps.iter().any(|step| step.taken == t || step.end == t);
        for triangle in (0..links.triangle_count() as u32).filter(|&t| !is_on_path(t)) {
            let (is_same, is_end_above) = match trace.relation(triangle, &locations) {
                Relation::Untouched | Relation::Other => (false, false),
                Relation::Same { is_end_above } | Relation::SameMoved { is_end_above } => {
                    (true, is_end_above)
                }
            };
            assert_eq!(is_same, pushed.are_in_one_strip(end, triangle), "{steps:?}, triangle {triangle}");
            compared_count += 1;
            for side in (3 * triangle..3 * triangle + 3).filter(|&side| is_same && links.is_solid(side)) {
                let is_above = locations.index(links.twins()[side as usize] / 3) > locations.index(triangle);
                assert_eq!(is_above == is_end_above, pushed.leads_to(side, end), "{steps:?}, side {side}");
            }
        }
        let choices = pushed.valid_steps(end, is_on_path);
        if choices.is_empty() {
            break;
        }
        let step = choices[random.below(choices.len() as u32) as usize];
        pushed.push(step);
        steps.push(step);
        end = step.end;
    }
    // Popping restores the identities and the links, as a search that goes back needs it.
    steps.iter().for_each(|_| pushed.pop());
    assert_eq!(pushed.into_links().into_bits(), links.clone().into_bits());
    compared_count
}

fn meshes() -> Vec<(&'static str, IndexedMesh)> {
    vec![
        ("grid", shapes::grid(6, 5)),
        ("torus", shapes::torus(9, 7, 1.0, 0.4)),
        ("sphere", shapes::icosphere(2, 1.0)),
        ("moebius", shapes::moebius_strip(30)),
        ("book", shapes::book(12)),
        ("soup", shapes::random_soup(60, 3)),
    ]
}

proptest! {
    #![proptest_config(striata_testing::cases(64))]

    /// The trace knows the strips of all triangles after any steps, without pushing identities.
    #[test]
    fn traced_identities_equal_pushed_ones(seed in any::<u64>(), which in 0usize..6) {
        let (name, mesh) = &meshes()[which];
        let graph = DualGraph::of_vertices(mesh);
        let mut random = Random::new(seed);
        let links = random_strips(mesh, &graph, &mut random);
        let is_end = |&t: &u32| links.solid_degree(t) < 2 && is_proper(&mesh.triangles[t as usize]);
        let ends: Vec<u32> = (0..links.triangle_count() as u32).filter(is_end).collect();
        let mut compared_count = 0;
        for _ in 0..8 {
            let start = ends[random.below(ends.len() as u32) as usize];
            compared_count += check_traces(&links, start, &mut random);
        }
        prop_assert!(compared_count > 0, "{name}");
    }

    /// After every single tunnel and every move, walking finds no loop, and a tunnel leaves one strip fewer.
    #[test]
    fn no_tunnel_closes_a_loop(seed in any::<u64>(), which in 0usize..6, max_length in 1u32..40) {
        let (name, mesh) = &meshes()[which];
        let graph = DualGraph::of_vertices(mesh);
        let mut random = Random::new(seed);
        let mut links = random_strips(mesh, &graph, &mut random);
        let ends: Vec<u32> = (0..links.triangle_count() as u32)
            .filter(|&t| links.solid_degree(t) < 2 && is_proper(&mesh.triangles[t as usize])).collect();
        let mut strip_count = path_count(&links).unwrap();
        let locations = LocationTable::new(&links);
        let search = TunnelPathSearch::new(links.triangle_count(), max_length);
        let mut joiner = TunnelJoiner { links: &mut links, locations, search, random, search_count: 0 };
        for &end in &ends {
            let found_count = joiner.dig(end, 3, &mut |_| 0.0).unwrap();
            let after = path_count(joiner.links);
            prop_assert_eq!(after, Some(strip_count - found_count), "{}", name);
            strip_count -= found_count;
            // The table is kept up to date by walking only what has changed.
            let fresh = LocationTable::new(joiner.links);
            for t in 1..joiner.links.triangle_count() as u32 {
                let is_same = |table: &LocationTable| table.strip(t) == table.strip(t - 1);
                prop_assert_eq!(is_same(&joiner.locations), is_same(&fresh), "{}, triangle {}", name, t);
            }
        }
    }

    /// Growth closes no loop either, and leaves no tunnel of one link.
    #[test]
    fn growth_closes_no_loop(seed in any::<u64>(), which in 0usize..6) {
        let (name, mesh) = &meshes()[which];
        let graph = DualGraph::of_vertices(mesh);
        let mut random = Random::new(seed);
        let mut links = random_strips(mesh, &graph, &mut random);
        let ends = |links: &StripLinks<'_>| -> Vec<u32> {
            let is_end = |&t: &u32| links.solid_degree(t) < 2 && is_proper(&mesh.triangles[t as usize]);
            (0..links.triangle_count() as u32).filter(is_end).collect()
        };
        join_ends(&ends(&links), &mut links, &mut random);
        prop_assert!(path_count(&links).is_some(), "{}", name);
        for end in ends(&links) {
            prop_assert_eq!(apply(&mut links.clone(), end, 1), None, "{}", name);
        }
    }
}
