//! Numbering of wedges: the distinct corners of a mesh become its vertices.

use std::collections::BTreeMap;

/// Marks the end of a chain.
const UNUSED: u32 = u32::MAX;

/// Three words that identify the data of a corner: its position, and for example the indices of its texture
/// coordinates and normal.
type Corner = [u32; 3];

/// Longest chain that is searched linearly; further wedges go into a tree.
const MAX_CHAIN_LENGTH: usize = 32;

/// Numbers distinct corners in order of first occurrence, and returns them with the triangles that use the
/// numbers. The first word of a corner is its position, below `position_count`.
///
/// The wedges of one position form a chain, which is as short as the position has wedges; a file with long
/// chains only slows down its own reading.
pub(crate) fn number_wedges(position_count: usize, corners: &[Corner]) -> (Vec<Corner>, Vec<[u32; 3]>) {
    let mut first = vec![UNUSED; position_count];
    let mut vertices: Vec<Corner> = Vec::with_capacity(position_count);
    let mut next: Vec<u32> = Vec::with_capacity(position_count);
    let mut beyond: BTreeMap<Corner, u32> = BTreeMap::new();
    let mut vertex_of = |corner: &Corner| {
        let position = corner[0] as usize;
        let (mut vertex, mut steps) = (first[position], 0);
        while vertex != UNUSED && vertices[vertex as usize] != *corner && steps < MAX_CHAIN_LENGTH {
            vertex = next[vertex as usize];
            steps += 1;
        }
        let new_vertex = vertices.len() as u32;
        if steps == MAX_CHAIN_LENGTH {
            vertex = *beyond.entry(*corner).or_insert(new_vertex);
        } else if vertex == UNUSED {
            vertex = new_vertex;
        }
        if vertex == new_vertex {
            vertices.push(*corner);
            next.push(first[position]);
            if steps < MAX_CHAIN_LENGTH {
                first[position] = vertex;
            }
        }
        vertex
    };
    let triangles =
        corners.chunks_exact(3).map(|t| [vertex_of(&t[0]), vertex_of(&t[1]), vertex_of(&t[2])]).collect();
    (vertices, triangles)
}
