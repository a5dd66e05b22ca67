//! Levels that are shown: triangles over the vertex buffer, group by group.

/// A level that is shown, uniform or view-dependent.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ShownLevel {
    /// Corners of the triangles, group by group.
    pub triangles: Vec<[u32; 3]>,
    /// Triangle count of each group; there is at least one group.
    pub group_counts: Vec<u32>,
    /// Number of vertex splits of the level.
    pub split_count: usize,
    /// Largest distance from the full mesh, mesh units.
    pub error: f32,
}

/// Sorts triangles with their indices by group and counts each group's.
pub(crate) fn by_group(
    numbered: &[(u32, [u32; 3])],
    groups: &[u32],
    group_count: usize,
) -> (Vec<[u32; 3]>, Vec<u32>) {
    if groups.is_empty() || group_count < 2 {
        return (numbered.iter().map(|&(_, corners)| corners).collect(), vec![numbered.len() as u32]);
    }
    let group_of = |triangle: u32| groups[triangle as usize] as usize;
    let mut counts = vec![0u32; group_count];
    numbered.iter().for_each(|&(triangle, _)| counts[group_of(triangle)] += 1);
    let mut next = Vec::with_capacity(group_count);
    let mut first = 0;
    for &count in &counts {
        next.push(first as usize);
        first += count;
    }
    let mut ordered = vec![[0; 3]; numbered.len()];
    for &(triangle, corners) in numbered {
        let slot = &mut next[group_of(triangle)];
        ordered[*slot] = corners;
        *slot += 1;
    }
    (ordered, counts)
}
