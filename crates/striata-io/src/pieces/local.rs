//! Vertices of a piece: those that its triangles mention.

/// Largest ratio of the range of vertex numbers to their count at which a table of the range is worth it.
const TABLE_RATIO: usize = 8;

/// Replaces vertex numbers by indices into the sorted list of the numbers that occur, and returns the list.
pub(super) fn localize(triangles: &mut [[u32; 3]]) -> Vec<u32> {
    let Some(&first) = triangles.as_flattened().iter().min() else { return Vec::new() };
    let last = triangles.as_flattened().iter().max().copied().unwrap_or(first);
    let range = (last - first) as usize + 1;
    if range > triangles.len().saturating_mul(TABLE_RATIO) {
        return localize_by_search(triangles);
    }
    let mut table = vec![u32::MAX; range];
    triangles.as_flattened().iter().for_each(|&v| table[(v - first) as usize] = 0);
    let mut numbers = Vec::new();
    for (offset, index) in table.iter_mut().enumerate().filter(|(_, index)| **index == 0) {
        *index = numbers.len() as u32;
        numbers.push(first + offset as u32);
    }
    triangles.as_flattened_mut().iter_mut().for_each(|v| *v = table[(*v - first) as usize]);
    numbers
}

fn localize_by_search(triangles: &mut [[u32; 3]]) -> Vec<u32> {
    let mut numbers: Vec<u32> = triangles.as_flattened().to_vec();
    numbers.sort_unstable();
    numbers.dedup();
    for vertex in triangles.as_flattened_mut() {
        *vertex = numbers.partition_point(|number| number < vertex) as u32;
    }
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_become_indices() {
        for offset in [0, 1_000_000] {
            let mut triangles = vec![[7, 5, 9], [5, 9, 12 + offset]];
            assert_eq!(localize(&mut triangles), [5, 7, 9, 12 + offset]);
            assert_eq!(triangles, [[1, 0, 2], [0, 2, 3]]);
        }
        assert!(localize(&mut []).is_empty());
    }
}
