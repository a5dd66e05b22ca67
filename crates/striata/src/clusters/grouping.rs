//! Groups clusters that share long borders.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Positions of more clusters than this link each of them to the next one only.
const MAX_CLUSTERS_AT_POSITION: usize = 16;

/// Clusters at each position that several of them share.
pub(super) struct SharedPositions {
    /// Position and cluster, sorted.
    uses: Vec<(u32, u32)>,
    /// The first position of each cluster. Positions are numbered along a space-filling curve.
    first: Vec<u32>,
}

impl SharedPositions {
    /// Finds the shared ones among the positions of each cluster, given in ascending order without repetition.
    pub(super) fn new(positions: &[Vec<u32>], position_count: usize) -> Self {
        let mut counts = vec![0u8; position_count];
        for &p in positions.iter().flatten() {
            counts[p as usize] = counts[p as usize].saturating_add(1);
        }
        let mut uses = Vec::new();
        for (cluster, positions) in (0..).zip(positions) {
            uses.extend(positions.iter().filter(|&&p| counts[p as usize] > 1).map(|&p| (p, cluster)));
        }
        uses.sort_unstable();
        Self { uses, first: positions.iter().map(|all| all.first().copied().unwrap_or(0)).collect() }
    }

    /// Positions whose clusters belong to more than one group.
    pub(super) fn between_groups<'a>(&'a self, group_of: &'a [u32]) -> impl Iterator<Item = u32> + 'a {
        let runs = self.uses.chunk_by(|a, b| a.0 == b.0);
        let group = |&(_, cluster): &(u32, u32)| group_of[cluster as usize];
        runs.filter(move |run| run.iter().any(|u| group(u) != group(&run[0]))).map(|run| run[0].0)
    }

    /// Neighbors of each cluster with the number of positions that they share, by cluster.
    fn links(&self) -> Vec<Vec<Link>> {
        let mut pairs = Vec::new();
        for run in self.uses.chunk_by(|a, b| a.0 == b.0) {
            let reach = if run.len() <= MAX_CLUSTERS_AT_POSITION { run.len() } else { 2 };
            for (i, a) in run.iter().enumerate() {
                pairs.extend(run[i + 1..run.len().min(i + reach)].iter().map(|b| (a.1, b.1)));
            }
        }
        pairs.sort_unstable();
        let mut links = vec![Vec::new(); self.first.len()];
        for run in pairs.chunk_by(|a, b| a == b) {
            let ((a, b), shared) = (run[0], run.len() as f32);
            links[a as usize].push(Link { to: b, shared });
            links[b as usize].push(Link { to: a, shared });
        }
        links
    }

    /// Groups the clusters; returns the clusters of each group, in ascending order.
    ///
    /// The smallest group is merged with the neighbor with which it shares the most, for its size, until all have
    /// nearly the wanted size. Groups without such a neighbor are merged along the curve.
    pub(super) fn group(&self, size: usize) -> Vec<Vec<u32>> {
        let count = self.first.len();
        let mut merger = GroupMerger {
            links: self.links(),
            parents: (0..count as u32).collect(),
            sizes: vec![1; count],
            max: size + size / 4,
        };
        let mut queue: BinaryHeap<Reverse<(u32, u32)>> =
            (0..count as u32).map(|cluster| Reverse((1, cluster))).collect();
        while let Some(Reverse((count, group))) = queue.pop() {
            let is_current = merger.find(group) == group && merger.sizes[group as usize] == count;
            if !is_current || count as usize >= size {
                continue;
            }
            if let Some(other) = merger.best_neighbor(group) {
                let merged = merger.merge(group, other);
                queue.push(Reverse((merger.sizes[merged as usize], merged)));
            }
        }
        merger.merge_small(&self.first, size);
        merger.groups()
    }
}

/// A neighbor of a group.
#[derive(Clone, Copy)]
struct Link {
    to: u32,
    shared: f32,
}

/// Groups that grow by merging.
struct GroupMerger {
    links: Vec<Vec<Link>>,
    /// The cluster that stands for the group of each cluster, directly or over others.
    parents: Vec<u32>,
    sizes: Vec<u32>,
    max: usize,
}

impl GroupMerger {
    fn find(&mut self, mut cluster: u32) -> u32 {
        while self.parents[cluster as usize] != cluster {
            let parent = self.parents[cluster as usize];
            self.parents[cluster as usize] = self.parents[parent as usize];
            cluster = parent;
        }
        cluster
    }

    /// The neighbor with which the group shares the most, relative to its size, and fits into one group.
    fn best_neighbor(&mut self, group: u32) -> Option<u32> {
        let mut links = std::mem::take(&mut self.links[group as usize]);
        for link in &mut links {
            link.to = self.find(link.to);
        }
        links.retain(|link| link.to != group);
        links.sort_unstable_by_key(|link| link.to);
        links.dedup_by(|a, b| {
            let is_same = a.to == b.to;
            if is_same {
                b.shared += a.shared;
            }
            is_same
        });
        let mut best = None;
        let mut best_score = 0.0;
        for link in &links {
            let size = self.sizes[link.to as usize];
            let score = link.shared / (size as f32).sqrt();
            if (self.sizes[group as usize] + size) as usize <= self.max && score > best_score {
                (best, best_score) = (Some(link.to), score);
            }
        }
        self.links[group as usize] = links;
        best
    }

    fn merge(&mut self, a: u32, b: u32) -> u32 {
        let (from, to) =
            if self.links[a as usize].len() > self.links[b as usize].len() { (b, a) } else { (a, b) };
        let mut links = std::mem::take(&mut self.links[from as usize]);
        self.links[to as usize].append(&mut links);
        self.parents[from as usize] = to;
        self.sizes[to as usize] += self.sizes[from as usize];
        to
    }

    /// Merges groups of less than half the wanted size with others like them that are near.
    fn merge_small(&mut self, places: &[u32], size: usize) {
        let is_small =
            |c: &u32| self.parents[*c as usize] == *c && 2 * self.sizes[*c as usize] as usize <= size;
        let mut small: Vec<u32> = (0..places.len() as u32).filter(is_small).collect();
        small.sort_by_key(|&c| places[c as usize]);
        let mut last: Option<u32> = None;
        for group in small {
            let fits =
                |other: &u32| (self.sizes[*other as usize] + self.sizes[group as usize]) as usize <= size;
            last = Some(match last.filter(fits) {
                Some(other) => self.merge(other, group),
                None => group,
            });
        }
    }

    /// Clusters of each group, in the order of their first ones.
    fn groups(mut self) -> Vec<Vec<u32>> {
        let mut number = vec![u32::MAX; self.parents.len()];
        let mut groups: Vec<Vec<u32>> = Vec::new();
        for cluster in 0..self.parents.len() as u32 {
            let number = &mut number[self.find(cluster) as usize];
            if *number == u32::MAX {
                *number = groups.len() as u32;
                groups.push(Vec::new());
            }
            groups[*number as usize].push(cluster);
        }
        groups
    }
}
