//! Published stripifiers: each triangle is in one strip, no loop is left, and the published relations hold.

use proptest::prelude::*;
use striata::mesh::{DualGraph, IndexedMesh, canonical_triangles, is_proper, replay, shapes};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::{StripLinks, strip_triangles};
use striata_lab::stripifiers::{
    EndOrder, Identities, TunnelOptions, TunnelReport, Visits, join_along_tunnels, join_like_tomesh,
    strips_of,
};
use striata_testing::meshes;

const KINDS: [TunnelKind; 3] = [
    TunnelKind { identities: Identities::Dynamic, visits: Visits::OncePerSearch },
    TunnelKind { identities: Identities::Dynamic, visits: Visits::OncePerPath },
    TunnelKind { identities: Identities::Static, visits: Visits::OncePerSearch },
];

/// How a kind of tunneling names strips and visits triangles.
#[derive(Clone, Copy, Debug)]
struct TunnelKind {
    identities: Identities,
    visits: Visits,
}

fn options(kind: TunnelKind, max_length: u32, seed: u64) -> TunnelOptions {
    let TunnelKind { identities, visits } = kind;
    TunnelOptions { max_length, order: EndOrder::Random, identities, visits, seed }
}

/// Joins the strips of a mesh, checks them, and returns their number.
fn checked(mesh: &IndexedMesh, options: &TunnelOptions) -> (usize, TunnelReport) {
    let mut report = TunnelReport::default();
    let strips = strips_of(mesh, |triangles, links| {
        report = join_along_tunnels(triangles, links, options);
        // A loop has no ends, so that its triangles are missing in the strips below.
        assert_eq!(links.clone().cut_loops(), 0);
        let solid_count = links.solid_count();
        assert_eq!(solid_count, report.tunnel_count, "each tunnel makes one link more solid than dashed");
    })
    .unwrap();
    let expected: Vec<[u32; 3]> = mesh.triangles.iter().copied().filter(is_proper).collect();
    let found: Vec<[u32; 3]> = strips.strips().flat_map(strip_triangles).collect();
    assert_eq!(canonical_triangles(&found), canonical_triangles(&expected));
    assert_eq!(strips.strip_count(), expected.len() - report.tunnel_count);
    (strips.strip_count(), report)
}

#[test]
fn difficult_meshes_are_covered() {
    for (name, mesh) in meshes::nasty().into_iter().filter(|(_, mesh)| mesh.check().is_ok()) {
        eprintln!("{name}");
        for kind in KINDS {
            for order in [EndOrder::Random, EndOrder::ShortestFirst, EndOrder::SameStrip] {
                checked(&mesh, &TunnelOptions { order, ..options(kind, 9, 1) });
            }
        }
        let strips = strips_of(&mesh, join_like_tomesh).unwrap();
        let expected: Vec<[u32; 3]> = mesh.triangles.iter().copied().filter(is_proper).collect();
        let found: Vec<[u32; 3]> = strips.strips().flat_map(strip_triangles).collect();
        assert_eq!(canonical_triangles(&found), canonical_triangles(&expected), "{name}");
    }
}

#[test]
fn longer_tunnels_and_more_visits_leave_fewer_strips() {
    let mesh = shapes::torus(60, 40, 1.0, 0.4);
    let mean = |kind, length| {
        let counts = (0..5).map(|seed| checked(&mesh, &options(kind, length, seed)).0);
        counts.sum::<usize>() as f64 / 5.0
    };
    for kind in KINDS {
        assert!(mean(kind, 1) > mean(kind, 5) && mean(kind, 5) > mean(kind, 13), "{kind:?}");
    }
    let [search, path, fixed] = KINDS.map(|kind| mean(kind, 13));
    assert!(path < search && search < fixed, "{path} {search} {fixed}");
}

/// Without steps, nothing that an identity says can have changed.
#[test]
fn tunnels_of_one_link_need_no_dynamic_identities() {
    let mesh = shapes::icosphere(3, 1.0);
    let [a, b, c] = KINDS.map(|kind| checked(&mesh, &options(kind, 1, 4)).0);
    assert_eq!((a, a), (b, c));
}

#[test]
fn only_static_identities_let_loops_pass() {
    let mesh = shapes::torus(60, 40, 1.0, 0.4);
    let loop_counts =
        KINDS.map(|kind| (0..4).map(|seed| checked(&mesh, &options(kind, 25, seed)).1.loop_count).sum());
    let [search, path, fixed]: [usize; 3] = loop_counts;
    assert_eq!((search, path), (0, 0));
    assert!(fixed > 0, "the check before a tunnel is accepted has something to do");
}

/// The worked example of figure 7 \[PS03\]: see the tests of `striata-strip/src/tunnel`.
#[test]
fn figure_7_is_discarded_by_the_check_of_static_identities() {
    // Strips 0 1 2 3 and 4 5 6 7 in a cubic graph: three sides per node.
    let edges = [(0, 1), (1, 2), (2, 3), (4, 5), (5, 6), (6, 7), (3, 5), (6, 1), (2, 4)];
    let mut twins = vec![u32::MAX; 24];
    let mut next = [0u32; 8];
    let mut sides = Vec::new();
    for (a, b) in edges {
        let mut side = |node: usize| {
            next[node] += 1;
            3 * node as u32 + next[node] - 1
        };
        let (one, other) = (side(a), side(b));
        (twins[one as usize], twins[other as usize]) = (other, one);
        sides.push(one);
    }
    let triangles = [[0, 1, 2]; 8];
    let strips_after = |kind| {
        let mut links = StripLinks::from_bits(&twins, vec![0; 8]);
        sides[..6].iter().for_each(|&side| links.join(side));
        // Only the end 3 has a link to cross at first: 0 and 7 have none, 4 only that of the figure.
        let report = join_along_tunnels(&triangles, &mut links, &options(kind, 5, 0));
        assert_eq!(links.clone().cut_loops(), 0);
        (8 - links.solid_count(), report.loop_count)
    };
    // The other path from 5 leads over 4, which must not keep this one from its end.
    assert_eq!(strips_after(KINDS[1]), (2, 0), "dynamic identities refuse the tunnel");
    let (strip_count, loop_count) =
        strips_after(TunnelKind { identities: Identities::Static, visits: Visits::OncePerPath });
    assert!(
        strip_count == 2 && loop_count > 0,
        "static ones find it, and walking finds the loop: {strip_count} {loop_count}"
    );
}

#[test]
fn existing_strips_are_improved() {
    // A level of a grid is irregular.
    let refinable = build_sequence(&shapes::terrain(40, 2), &SequenceOptions::default()).unwrap().refinable;
    let mesh = replay(&refinable, refinable.sequence.step_count() / 2);
    let graph = DualGraph::of_vertices(&mesh);
    let mut links = StripLinks::new(&graph);
    join_like_tomesh(&mesh.triangles, &mut links);
    let before = mesh.triangle_count() - links.solid_count();
    let report = join_along_tunnels(&mesh.triangles, &mut links, &options(KINDS[1], 15, 0));
    assert_eq!(mesh.triangle_count() - links.solid_count(), before - report.tunnel_count);
    assert!(
        report.tunnel_count > 0 && report.pass_count > 1 && report.search_count > report.tunnel_count,
        "{report:?} {before}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_soups_are_covered(seed in any::<u64>(), triangles in 1u32..120, kind in 0usize..3, length in 1u32..30) {
        let mesh = shapes::random_soup(triangles, seed);
        let (_, report) = checked(&mesh, &options(KINDS[kind], length, seed));
        prop_assert!(KINDS[kind].identities == Identities::Static || report.loop_count == 0);
    }
}
