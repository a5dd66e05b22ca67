//! The strips that other tools wrote, see `benches/peers`.

use std::collections::HashMap;
use std::path::Path;

use striata::mesh::IndexedMesh;
use striata::strip::{RESTART, StripSet};

use crate::Fallible;

/// Reads the strips of another tool: f64 milliseconds, u32 count, u32 indices, little-endian. Returns milliseconds
/// and indices.
pub(crate) fn read(path: &Path) -> Fallible<(f64, Vec<u32>)> {
    let bytes = std::fs::read(path)?;
    let cut_short = || format!("{} is cut short", path.display());
    let (head, body) = bytes.split_first_chunk::<12>().ok_or_else(cut_short)?;
    let (ms, count) = head.split_first_chunk::<8>().ok_or_else(cut_short)?;
    let count = u32::from_le_bytes(count.try_into()?) as usize;
    if body.len() != 4 * count {
        return Err(cut_short().into());
    }
    let indices = body.as_chunks().0.iter().map(|&word| u32::from_le_bytes(word)).collect();
    Ok((f64::from_le_bytes(*ms), indices))
}

/// Reads the positions of the list that a tool was given; `stripifier_rows::write_list` writes it.
pub(crate) fn read_positions(path: &Path) -> Fallible<Vec<[f32; 3]>> {
    let bytes = std::fs::read(path)?;
    let words = bytes.as_chunks::<4>().0;
    let count = words.first().map_or(0, |&count| u32::from_le_bytes(count) as usize);
    let numbers = words.get(2..).unwrap_or_default().as_chunks::<3>().0;
    let positions = numbers.get(..count).ok_or_else(|| format!("{} is cut short", path.display()))?;
    Ok(positions.iter().map(|position| position.map(f32::from_le_bytes)).collect())
}

/// Strips that draw each triangle of a mesh once: those of another tool, cut where they draw a triangle that the mesh
/// does not have or that has been drawn, and a strip for each triangle that they leave out.
pub(crate) fn of_mesh(indices: &[u32], mesh: &IndexedMesh) -> StripSet {
    let mut left: HashMap<[u32; 3], usize> = HashMap::new();
    mesh.triangles.iter().for_each(|&triangle| *left.entry(rotated(triangle)).or_default() += 1);
    let mut take = |triangle: [u32; 3]| match left.get_mut(&rotated(triangle)) {
        Some(count) if *count > 0 => {
            *count -= 1;
            true
        }
        _ => false,
    };
    let mut strips = StripSet::new();
    for strip in indices.split(|&index| index == RESTART) {
        let mut start = 0;
        for (at, corners) in strip.windows(3).enumerate() {
            let &[a, b, c] = corners else { continue };
            let is_degenerate = a == b || b == c || c == a;
            if !is_degenerate && !take(if at % 2 == 0 { [a, b, c] } else { [b, a, c] }) {
                push(&mut strips, strip, start..at + 2);
                start = at + 1;
            }
        }
        push(&mut strips, strip, start..strip.len());
    }
    mesh.triangles.iter().filter(|&&triangle| take(triangle)).for_each(|triangle| strips.push(triangle));
    strips.end_group();
    strips
}

/// Adds a part of a strip, which keeps its winding; nothing if it has no triangle.
fn push(strips: &mut StripSet, strip: &[u32], part: std::ops::Range<usize>) {
    if part.len() < 3 {
        return;
    }
    let flip = strip[part.start..].iter().take(part.start % 2);
    strips.push(&flip.chain(&strip[part.clone()]).copied().collect::<Vec<_>>());
}

/// A triangle that begins with its smallest corner.
fn rotated([a, b, c]: [u32; 3]) -> [u32; 3] {
    match a.min(b).min(c) {
        least if least == a => [a, b, c],
        least if least == b => [b, c, a],
        _ => [c, a, b],
    }
}
