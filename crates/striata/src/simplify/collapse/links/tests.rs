//! Tests links against triangles whose corners are substituted directly.

use super::*;
use crate::mesh::canonical_triangles;

/// Returns all triangles in the links, each as often as it appears in the link of its smallest corner.
fn triangles_of(links: &Links) -> Vec<[u32; 3]> {
    let mut out = Vec::new();
    let mut edges = Vec::new();
    for v in 0..links.slabs.len() as u32 {
        links.edges_into(v, &mut edges);
        out.extend(edges.iter().filter(|e| v < e.a && v < e.b).map(|e| [v, e.a, e.b]));
    }
    canonical_triangles(&out)
}

#[test]
fn filling_a_hole_with_a_fan_equals_a_collapse() {
    // A strip, a book of three pages and a tetrahedron on one of them.
    let triangles = [
        [0, 1, 2],
        [2, 1, 3],
        [2, 3, 4],
        [4, 3, 5],
        [1, 0, 6],
        [1, 6, 7],
        [0, 1, 8],
        [8, 1, 9],
        [3, 1, 9],
        [3, 9, 5],
    ];
    for v in 0..10 {
        for u in (0..10).filter(|&u| u != v) {
            let (mut filled, mut collapsed) =
                (Links::new(10, &triangles, true), Links::new(10, &triangles, true));
            if !collapsed.entries(v).contains(&u) {
                continue;
            }
            let mut edges = Vec::new();
            filled.edges_into(v, &mut edges);
            let kept = edges.iter().filter(|e| e.a != u && e.b != u);
            let floor: Vec<_> = kept.map(|e| (20 + e.triangle, [u, e.a, e.b])).collect();
            filled.fill(v, &floor);
            collapsed.collapse(v, u);
            assert_eq!(triangles_of(&filled), triangles_of(&collapsed), "{v} -> {u}");
            assert_eq!(filled.kind(v), LinkKind::Empty);
            filled.edges_into(u, &mut edges);
            let new_triangles: Vec<u32> = edges.iter().map(|e| e.triangle).filter(|&t| t >= 20).collect();
            assert_eq!(new_triangles.len(), floor.len(), "{v} -> {u}: new_triangles of new triangles");
        }
    }
}

#[test]
fn links_without_triangles_are_empty() {
    let pillow = [[0, 1, 2], [0, 2, 1]];
    for (triangles, left) in [(&pillow[..1], 0), (&pillow[..], 0)] {
        let mut links = Links::new(3, triangles, false);
        links.collapse(0, 1);
        assert_eq!([0, 1, 2].map(|p| links.kind(p)), [LinkKind::Empty; 3]);
        assert_eq!([0, 1, 2].map(|p| links.triangle_count(p)), [left; 3]);
    }
    // A tetrahedron folds into a pillow.
    let mut links = Links::new(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]], true);
    links.collapse(0, 1);
    assert_eq!([1, 2, 3].map(|p| links.triangle_count(p)), [2; 3]);
    links.collapse(1, 2);
    assert_eq!([1, 2, 3].map(|p| links.kind(p)), [LinkKind::Empty; 3]);
}

fn check_against_substitution(triangles: &[[u32; 3]], count: usize, collapses: &[(u32, u32)]) {
    for follows in [true, false] {
        check_one(triangles.to_vec(), count, collapses, follows);
    }
}

/// Compares after every collapse.
fn check_one(triangles: Vec<[u32; 3]>, count: usize, collapses: &[(u32, u32)], follows: bool) {
    for end in 1..=collapses.len() {
        check_at_end(triangles.clone(), count, &collapses[..end], follows);
    }
}

fn check_at_end(mut triangles: Vec<[u32; 3]>, count: usize, collapses: &[(u32, u32)], follows: bool) {
    let mut links = Links::new(count, &triangles, follows);
    let input = triangles.clone();
    for &(v, u) in collapses.iter().filter(|(v, u)| v != u) {
        links.collapse(v, u);
        for t in &mut triangles {
            *t = t.map(|x| if x == v { u } else { x });
        }
    }
    let expected: Vec<_> =
        triangles.iter().copied().filter(|&[a, b, c]| a != b && b != c && c != a).collect();
    let is_equal = triangles_of(&links) == canonical_triangles(&expected);
    assert!(is_equal, "after {collapses:?} of {:?}", &input[..input.len().min(100)]);
    let mut edges = Vec::new();
    for w in (0..count as u32).filter(|_| follows) {
        links.edges_into(w, &mut edges);
        for e in &edges {
            let found = canonical_triangles(&[[w, e.a, e.b]]);
            assert_eq!(found, canonical_triangles(&[triangles[e.triangle as usize]]), "triangle indices");
        }
    }
}

#[test]
fn hexagon_is_one_ring_and_collapses_to_a_fan() {
    let fan: Vec<[u32; 3]> = (0..6).map(|i| [0, 1 + i, 1 + (i + 1) % 6]).collect();
    let links = Links::new(7, &fan, false);
    assert_eq!(links.kind(0), LinkKind::Closed);
    assert_eq!(links.kind(1), LinkKind::Open);
    check_against_substitution(&fan, 7, &[(0, 1), (3, 4), (5, 1)]);
}

#[test]
fn long_rings_equal_substitution() {
    // A disc around 0 with a band around it; its rim loses positions, and some become those of the band.
    let n = 4200;
    let (rim, band) = (|i: u32| 1 + i % n, |i: u32| 1 + n + i % n);
    for open in [0, 1] {
        let mut triangles: Vec<[u32; 3]> = (0..n - open).map(|i| [0, rim(i), rim(i + 1)]).collect();
        for i in 0..n - open {
            triangles.extend([[rim(i), band(i), rim(i + 1)], [rim(i + 1), band(i), band(i + 1)]]);
        }
        let collapses: Vec<(u32, u32)> = (0..60)
            .map(|i| (i, i * 911 % (n - 5) + 2))
            .map(|(i, at)| match i % 3 {
                0 => (rim(at), rim(at + 1)),
                1 => (rim(at), rim(at - 1)),
                _ => (rim(at), band(at)),
            })
            .collect();
        for follows in [true, false] {
            check_at_end(triangles.clone(), 1 + 2 * n as usize, &collapses, follows);
        }
    }
}

#[test]
fn long_lists_of_edges_equal_substitution() {
    // Pages at an edge, with flaps at their ends, of which some become neighbors, or an end of the edge.
    let n = 700;
    let (page, flap) = (|i: u32| 2 + i % n, |i: u32| 2 + n + i % n);
    let triangles: Vec<[u32; 3]> =
        (0..n).flat_map(|i| [[0, 1, page(i)], [1, 0, page(i + 1)], [1, page(i), flap(i)]]).collect();
    let mut collapses: Vec<(u32, u32)> = (0..90)
        .map(|i| (i, i * 97 + 2))
        .map(|(i, at)| match i % 6 {
            0 => (flap(at), page(at)),
            1 => (page(at), flap(at)),
            2 => (page(at), 1),
            3 => (flap(at), page(at + 1)),
            4 => (page(at), 0),
            _ => (page(at), page(at + 1)),
        })
        .collect();
    for follows in [true, false] {
        check_at_end(triangles.clone(), 2 + 2 * n as usize, &collapses, follows);
    }
    collapses.extend([(0, 1), (page(5), flap(3))]);
    check_at_end(triangles, 2 + 2 * n as usize, &collapses, true);
}

#[test]
fn rings_of_a_grid_equal_substitution() {
    // Interior and border vertices, each collapsed to each neighbor in turn.
    let at = |x: u32, y: u32| 5 * y + x;
    let mut grid = Vec::new();
    for y in 0..4 {
        for x in 0..4 {
            grid.extend([
                [at(x, y), at(x + 1, y), at(x + 1, y + 1)],
                [at(x, y), at(x + 1, y + 1), at(x, y + 1)],
            ]);
        }
    }
    let links = Links::new(25, &grid, false);
    for v in 0..25 {
        for &u in links.entries(v) {
            for &w in links.entries(u) {
                check_against_substitution(&grid, 25, &[(v, u), (u, if w == v { u } else { w })]);
            }
        }
    }
}

#[test]
fn bow_tie_of_equal_cycles_is_not_a_ring() {
    for n in [3u32, 30] {
        let cone = |base: u32| (0..n).map(move |i| [0, base + i, base + (i + 1) % n]);
        let both: Vec<[u32; 3]> = cone(1).chain(cone(1 + n)).collect();
        let links = Links::new(1 + 2 * n as usize, &both, false);
        assert_eq!(links.kind(0), LinkKind::Edges);
        assert_eq!(links.triangle_count(0), 2 * n as usize);
    }
}

#[test]
fn random_collapses_of_random_soups_equal_substitution() {
    let mut state = 1u64;
    let mut next = move |n: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) % n
    };
    for round in 0..300 {
        let count = 5 + next(12) as u32;
        let mut triangles = Vec::new();
        if round % 2 == 0 {
            // A strip-like grid, mostly manifold.
            for i in 0..count - 2 {
                triangles.push(if i % 2 == 0 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] });
            }
            triangles.push([count - 1, count - 2, 0]);
        }
        for _ in 0..next(20) {
            let t =
                [next(u64::from(count)), next(u64::from(count)), next(u64::from(count))].map(|x| x as u32);
            if t[0] != t[1] && t[1] != t[2] && t[2] != t[0] {
                triangles.push(t);
            }
        }
        let mut left: Vec<u32> = (0..count).collect();
        let mut collapses = Vec::new();
        while left.len() > 1 {
            let v = left.swap_remove(next(left.len() as u64) as usize);
            collapses.push((v, left[next(left.len() as u64) as usize]));
        }
        check_against_substitution(&triangles, count as usize, &collapses);
    }
}
