//! Turns any triangle mesh into a closed surface by duplicating non-manifold vertices and closing
//! boundary loops with virtual vertices.
//!
//! An edge joins two triangles if exactly two triangles meet there in opposite directions. All other
//! edges are cut open. The triangles around a vertex may then split into several fans, each of which gets
//! its own copy of the vertex; a vertex with a single fan is its own copy. The open edges that remain
//! form loops, and each loop is closed by a fan of triangles around a virtual vertex.

use crate::topology::surface::{NONE, Surface, edge_facing, half_edges, is_forward};

/// A mesh turned into a closed surface.
#[derive(Debug)]
pub(crate) struct Closed {
    /// The closed surface. Virtual vertices come first, then the copies: copy `i` is vertex
    /// `virtual_count + i`. Its first triangles are those of the mesh, in their original order.
    pub surface: Surface,
    /// The mesh vertex that each copy represents. The first copies are the used vertices, in their
    /// original order.
    pub vertex_of_copy: Vec<u32>,
    /// Whether each mesh vertex must not be removed: it has several copies, or lies on a cut edge that is
    /// not a boundary.
    pub is_locked: Vec<bool>,
}

/// Closes a mesh. Each triangle must have three different corners, and every vertex must be used.
pub(crate) fn close(triangles: &[[u32; 3]], vertex_count: usize) -> Closed {
    let mut is_locked = vec![false; vertex_count];
    let mut opposite = join(triangles, &mut is_locked);
    let (mut copies, vertex_of_copy) = assign_copies(triangles, &opposite, vertex_count);
    for &v in &vertex_of_copy[vertex_count..] {
        is_locked[v as usize] = true;
    }
    let virtual_count = close_loops(&mut copies, &mut opposite, vertex_of_copy.len());
    let copy_count = vertex_of_copy.len() as u32;
    // Virtual vertices were numbered after the copies; move them to the front.
    let renumbered = |v: u32| if v < copy_count { v + virtual_count } else { v - copy_count };
    let corners: Vec<[u32; 3]> = copies.iter().map(|t| t.map(renumbered)).collect();
    let surface =
        Surface::from_opposites(&corners, &opposite, (copy_count + virtual_count) as usize, virtual_count);
    Closed { surface, vertex_of_copy, is_locked }
}

/// Closes triangles over positions, some of which may be unused: these get no copy. Copies represent
/// positions.
pub(crate) fn close_used(triangles: &[[u32; 3]], position_count: usize) -> Closed {
    let mut number = vec![NONE; position_count];
    triangles.as_flattened().iter().for_each(|&p| number[p as usize] = 0);
    let used: Vec<u32> = (0..position_count as u32).filter(|&p| number[p as usize] == 0).collect();
    if used.len() == position_count {
        return close(triangles, position_count);
    }
    (0..).zip(&used).for_each(|(new, &p)| number[p as usize] = new);
    let dense: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(|p| number[p as usize])).collect();
    let Closed { surface, vertex_of_copy, is_locked: locked } = close(&dense, used.len());
    let mut is_locked = vec![true; position_count];
    used.iter().zip(locked).for_each(|(&p, locked)| is_locked[p as usize] = locked);
    Closed { surface, vertex_of_copy: vertex_of_copy.iter().map(|&v| used[v as usize]).collect(), is_locked }
}

/// Pairs the manifold half-edges. The ends of edges with more than two triangles, or with two that run in
/// the same direction, become locked.
fn join(triangles: &[[u32; 3]], is_locked: &mut [bool]) -> Vec<u32> {
    let mut edges = half_edges(triangles);
    edges.sort_unstable();
    let mut opposite = vec![NONE; 3 * triangles.len()];
    for run in edges.chunk_by(|a, b| a.0 == b.0) {
        match *run {
            [_] => {}
            [(_, a), (_, b)] if is_forward(triangles, a) != is_forward(triangles, b) => {
                opposite[a as usize] = b;
                opposite[b as usize] = a;
            }
            _ => {
                let (a, b) = edge_facing(triangles, run[0].1);
                is_locked[a as usize] = true;
                is_locked[b as usize] = true;
            }
        }
    }
    opposite
}

/// Next corner of the triangle; corners are numbered three per triangle here.
fn next(c: u32) -> u32 {
    if c % 3 == 2 { c - 2 } else { c + 1 }
}

/// Previous corner of the triangle.
fn previous(c: u32) -> u32 {
    if c.is_multiple_of(3) { c + 2 } else { c - 1 }
}

/// Returns the triangles with each corner's copy in place of its vertex, and the vertex of each copy.
fn assign_copies(triangles: &[[u32; 3]], opposite: &[u32], vertex_count: usize) -> (Vec<[u32; 3]>, Vec<u32>) {
    let mut copies = vec![[NONE; 3]; triangles.len()];
    let mut vertex_of_copy: Vec<u32> = (0..vertex_count as u32).collect();
    let mut is_met = vec![false; vertex_count];
    for corner in 0..3 * triangles.len() as u32 {
        if copies[corner as usize / 3][corner as usize % 3] != NONE {
            continue;
        }
        let vertex = triangles[corner as usize / 3][corner as usize % 3];
        let copy = if is_met[vertex as usize] {
            vertex_of_copy.push(vertex);
            vertex_of_copy.len() as u32 - 1
        } else {
            vertex
        };
        is_met[vertex as usize] = true;
        // Forward to the end of the fan or all the way around, then backward from the starting corner.
        let mut here = corner;
        loop {
            copies[here as usize / 3][here as usize % 3] = copy;
            let across = opposite[next(here) as usize];
            if across == NONE || next(across) == corner {
                break;
            }
            here = next(across);
        }
        here = corner;
        loop {
            let across = opposite[previous(here) as usize];
            if across == NONE || copies[previous(across) as usize / 3][previous(across) as usize % 3] == copy
            {
                break;
            }
            here = previous(across);
            copies[here as usize / 3][here as usize % 3] = copy;
        }
    }
    (copies, vertex_of_copy)
}

/// Adds a fan of triangles around a virtual vertex along each boundary loop. Returns the number of loops.
fn close_loops(copies: &mut Vec<[u32; 3]>, opposite: &mut Vec<u32>, copy_count: usize) -> u32 {
    // For each copy, the corner that faces the open edge leaving it.
    let mut leaving = vec![NONE; copy_count];
    let corner_count = 3 * copies.len() as u32;
    for corner in (0..corner_count).filter(|&c| opposite[c as usize] == NONE) {
        leaving[edge_facing(copies, corner).0 as usize] = corner;
    }
    let mut loops = 0;
    for start in 0..corner_count {
        if opposite[start as usize] != NONE {
            continue;
        }
        let center = copy_count as u32 + loops;
        loops += 1;
        let first = copies.len() as u32;
        let mut corner = start;
        loop {
            let (a, b) = edge_facing(copies, corner);
            let here = 3 * copies.len() as u32;
            copies.push([center, b, a]);
            opposite.extend([corner, NONE, NONE]);
            opposite[corner as usize] = here;
            if here / 3 > first {
                // The edge to `a` is shared with the previous triangle, in which `a` is the second corner.
                opposite[here as usize + 1] = here - 3 + 2;
                opposite[here as usize - 3 + 2] = here + 1;
            }
            corner = leaving[b as usize];
            if corner == start {
                opposite[3 * first as usize + 1] = here + 2;
                opposite[here as usize + 2] = 3 * first + 1;
                break;
            }
        }
    }
    loops
}
