//! Division of space into cells: a kd-tree for every level, each in its own rotated frame.

/// Rotation from the frame of one level to the frame of the next, as a quaternion (w, x, y, z) that is
/// normalized when it is used. The axis is far from the coordinate axes, and the angle of 68 degrees is far from
/// every symmetry of a box, so that borders of one level cross those of the next.
const TURN: [f64; 4] = [4.0, 1.0, 2.0, 1.5];
/// A partition has at most this many levels: cells grow by a factor of four from level to level.
const MAX_LEVELS: usize = 24;
/// A path through a tree crosses at most this many nodes.
const MAX_DEPTH: usize = 64;

/// The cells of all levels.
#[derive(Clone, Debug, PartialEq)]
pub struct Partition {
    levels: Vec<PartitionLevel>,
}

/// The cells of one level.
#[derive(Clone, Debug, PartialEq)]
pub struct PartitionLevel {
    /// Rows of the rotation into the frame of the level.
    frame: [[f64; 3]; 3],
    /// The root is the first node.
    nodes: Vec<PartitionNode>,
    cell_count: u32,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum PartitionNode {
    Leaf {
        cell: u32,
    },
    /// Smaller coordinates are in the node that follows, the others in `above`.
    Split {
        axis: u8,
        at: f64,
        above: u32,
    },
}

impl Partition {
    /// Divides space so that a cell of level `k` has about `cell_triangle_count * 4^k` of the original triangles.
    ///
    /// `samples` are points of the mesh, each standing for `triangles_per_sample` triangles. The last level has
    /// one cell. The same samples in the same order give the same partition on every machine.
    pub fn new(samples: &[[f32; 3]], triangles_per_sample: f64, cell_triangle_count: usize) -> Self {
        let total = samples.len() as f64 * triangles_per_sample;
        let mut levels = Vec::new();
        let mut limit = cell_triangle_count.max(1) as f64;
        let mut rotation = [1.0, 0.0, 0.0, 0.0];
        loop {
            let is_last = total <= limit || levels.len() + 1 == MAX_LEVELS;
            let samples_per_cell = if is_last { f64::INFINITY } else { limit / triangles_per_sample };
            levels.push(PartitionLevel::new(samples, frame_of(rotation), samples_per_cell));
            if is_last {
                return Self { levels };
            }
            limit *= 4.0;
            rotation = normalized(product(rotation, normalized(TURN)));
        }
    }

    /// Ends at this number of levels, at least one and at most as many as there are. One cell of the new last level
    /// is all of space, however many triangles it has.
    #[must_use]
    pub fn with_level_limit(mut self, limit: usize) -> Self {
        if (1..self.levels.len()).contains(&limit) {
            self.levels.truncate(limit);
            let last = &mut self.levels[limit - 1];
            (last.nodes, last.cell_count) = (vec![PartitionNode::Leaf { cell: 0 }], 1);
        }
        self
    }

    /// The levels, finest first.
    pub fn levels(&self) -> &[PartitionLevel] {
        &self.levels
    }

    /// Number of cells of all levels.
    pub fn cell_count(&self) -> u64 {
        self.levels.iter().map(|level| u64::from(level.cell_count)).sum()
    }

    /// Stores the partition: per level the number of nodes, the frame, and 17 bytes per node.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = (self.levels.len() as u32).to_le_bytes().to_vec();
        for level in &self.levels {
            bytes.extend((level.nodes.len() as u32).to_le_bytes());
            level.frame.iter().flatten().for_each(|x| bytes.extend(x.to_le_bytes()));
            for node in &level.nodes {
                let (axis, at, index) = match *node {
                    PartitionNode::Leaf { cell } => (3, 0.0, cell),
                    PartitionNode::Split { axis, at, above } => (axis, at, above),
                };
                bytes.push(axis);
                bytes.extend(at.to_le_bytes());
                bytes.extend(index.to_le_bytes());
            }
        }
        bytes
    }

    /// Reads what [`Self::to_bytes`] stored; `None` if the bytes are not a valid partition.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let mut bytes = bytes;
        let level_count = u32::from_le_bytes(take(&mut bytes)?) as usize;
        if !(1..=MAX_LEVELS).contains(&level_count) {
            return None;
        }
        let levels: Option<Vec<_>> = (0..level_count).map(|_| PartitionLevel::read(&mut bytes)).collect();
        levels
            .filter(|levels| bytes.is_empty() && levels[level_count - 1].cell_count == 1)
            .map(|levels| Self { levels })
    }
}

impl PartitionLevel {
    fn new(samples: &[[f32; 3]], frame: [[f64; 3]; 3], samples_per_cell: f64) -> Self {
        let mut points: Vec<[f64; 3]> = samples.iter().map(|&p| in_frame(&frame, p)).collect();
        let mut level = Self { frame, nodes: Vec::new(), cell_count: 0 };
        level.divide(&mut points, samples_per_cell, 1);
        level
    }

    /// Divides space for the level with a number, into cells of at most `samples_per_cell`.
    pub(super) fn numbered(number: usize, samples: &[[f32; 3]], samples_per_cell: f64) -> Self {
        let turned = |rotation, _| normalized(product(rotation, normalized(TURN)));
        let rotation = (0..number).fold([1.0, 0.0, 0.0, 0.0], turned);
        Self::new(samples, frame_of(rotation), samples_per_cell)
    }

    /// Appends the node of `points` and everything below it.
    fn divide(&mut self, points: &mut [[f64; 3]], samples_per_cell: f64, depth: usize) {
        let split =
            if points.len() as f64 <= samples_per_cell || depth == MAX_DEPTH { None } else { median(points) };
        let Some((axis, at, below)) = split else {
            self.nodes.push(PartitionNode::Leaf { cell: self.cell_count });
            self.cell_count += 1;
            return;
        };
        let node = self.nodes.len();
        self.nodes.push(PartitionNode::Split { axis, at, above: 0 });
        let (left, right) = points.split_at_mut(below);
        self.divide(left, samples_per_cell, depth + 1);
        let above = self.nodes.len() as u32;
        self.nodes[node] = PartitionNode::Split { axis, at, above };
        self.divide(right, samples_per_cell, depth + 1);
    }

    /// Number of cells.
    pub fn cell_count(&self) -> u32 {
        self.cell_count
    }

    /// The cell that a position belongs to.
    pub fn cell_of(&self, position: [f32; 3]) -> u32 {
        let p = in_frame(&self.frame, position);
        let mut node = 0;
        loop {
            match self.nodes[node] {
                PartitionNode::Leaf { cell } => return cell,
                PartitionNode::Split { axis, at, above } => {
                    node = if p[axis as usize] < at { node + 1 } else { above as usize };
                }
            }
        }
    }

    /// Reads one level; checks that the nodes form a tree in depth-first order with numbered leaves.
    fn read(bytes: &mut &[u8]) -> Option<Self> {
        let node_count = u32::from_le_bytes(take(bytes)?) as usize;
        let mut frame = [[0.0; 3]; 3];
        for x in frame.iter_mut().flatten() {
            *x = f64::from_le_bytes(take(bytes)?);
        }
        if node_count == 0 || bytes.len() / 13 < node_count || !frame.iter().flatten().all(|x| x.is_finite())
        {
            return None;
        }
        let mut level = Self { frame, nodes: Vec::with_capacity(node_count), cell_count: 0 };
        // Nodes above a split that have not been reached yet, with their depths; the last one comes first.
        let mut open = Vec::new();
        let mut next = Some(1);
        for index in 0..node_count {
            let depth = match next.take() {
                Some(depth) => depth,
                None => open.pop().filter(|&(above, _)| above == index).map(|(_, depth)| depth)?,
            };
            let [axis] = take(bytes)?;
            let at = f64::from_le_bytes(take(bytes)?);
            let number = u32::from_le_bytes(take(bytes)?);
            if axis == 3 {
                if number != level.cell_count {
                    return None;
                }
                level.nodes.push(PartitionNode::Leaf { cell: number });
                level.cell_count += 1;
                continue;
            }
            if axis > 3 || !at.is_finite() || depth == MAX_DEPTH {
                return None;
            }
            level.nodes.push(PartitionNode::Split { axis, at, above: number });
            open.push((number as usize, depth + 1));
            next = Some(depth + 1);
        }
        (open.is_empty() && next.is_none()).then_some(level)
    }
}

/// Splits points at the median of their widest axis: the axis, the coordinate, and how many are below it. The
/// points below come first. `None` if all are equal.
fn median(points: &mut [[f64; 3]]) -> Option<(u8, f64, usize)> {
    let mut low = points[0];
    let mut high = points[0];
    for p in points.iter() {
        for axis in 0..3 {
            low[axis] = low[axis].min(p[axis]);
            high[axis] = high[axis].max(p[axis]);
        }
    }
    let extent = |axis: usize| high[axis] - low[axis];
    let axis = (1..3).fold(0, |best, axis| if extent(axis) > extent(best) { axis } else { best });
    if extent(axis) <= 0.0 {
        return None;
    }
    let middle = points.len() / 2;
    let (_, pivot, _) = points.select_nth_unstable_by(middle, |p, q| p[axis].total_cmp(&q[axis]));
    let mut at = pivot[axis];
    if at <= low[axis] {
        // More than half of the points have the smallest coordinate: split above it.
        at = points.iter().map(|p| p[axis]).filter(|&x| x > low[axis]).fold(f64::INFINITY, f64::min);
    }
    // Which points are below decides everything; their order does not matter.
    let mut below = 0;
    for i in 0..points.len() {
        if points[i][axis] < at {
            points.swap(i, below);
            below += 1;
        }
    }
    Some((axis as u8, at, below))
}

fn take<const N: usize>(bytes: &mut &[u8]) -> Option<[u8; N]> {
    let (first, rest) = bytes.split_first_chunk::<N>()?;
    *bytes = rest;
    Some(*first)
}

fn in_frame(frame: &[[f64; 3]; 3], p: [f32; 3]) -> [f64; 3] {
    let p = p.map(f64::from);
    frame.map(|row| row[0] * p[0] + row[1] * p[1] + row[2] * p[2])
}

/// Product of two quaternions.
fn product([a, b, c, d]: [f64; 4], [w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

fn normalized(q: [f64; 4]) -> [f64; 4] {
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    q.map(|x| x / length)
}

/// Rows of the rotation matrix of a unit quaternion.
fn frame_of([w, x, y, z]: [f64; 4]) -> [[f64; 3]; 3] {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(side: u32) -> Vec<[f32; 3]> {
        (0..side * side).map(|i| [(i % side) as f32, (i / side) as f32, ((i * 7) % 5) as f32]).collect()
    }

    #[test]
    fn cells_grow_fourfold_and_the_last_level_has_one() {
        let partition = Partition::new(&grid(128), 32.0, 1 << 13);
        let counts: Vec<u32> = partition.levels().iter().map(PartitionLevel::cell_count).collect();
        assert_eq!(counts, [64, 16, 4, 1]);
    }

    #[test]
    fn cells_contain_about_equal_shares_of_the_samples() {
        let samples = grid(100);
        let partition = Partition::new(&samples, 1.0, 500);
        for (k, level) in partition.levels().iter().enumerate() {
            let mut counts = vec![0usize; level.cell_count() as usize];
            for &p in &samples {
                counts[level.cell_of(p) as usize] += 1;
            }
            assert!(counts.iter().all(|&n| n <= 500 << (2 * k)), "{counts:?}");
        }
    }

    #[test]
    fn equal_and_no_samples_give_one_cell() {
        for samples in [vec![], vec![[1.0f32; 3]; 1000]] {
            let partition = Partition::new(&samples, 32.0, 100);
            assert!(partition.levels().iter().all(|level| level.cell_count() == 1));
            assert_eq!(partition.levels()[0].cell_of([f32::MAX; 3]), 0);
        }
    }

    #[test]
    fn bytes_are_read_back_and_damage_is_refused() {
        let partition = Partition::new(&grid(40), 1.0, 100);
        let bytes = partition.to_bytes();
        assert_eq!(Partition::from_bytes(&bytes), Some(partition));
        for end in 0..bytes.len() {
            assert_eq!(Partition::from_bytes(&bytes[..end]), None);
        }
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 0x41;
            if let Some(partition) = Partition::from_bytes(&damaged) {
                partition
                    .levels()
                    .iter()
                    .for_each(|level| assert!(level.cell_of([3.0; 3]) < level.cell_count()));
            }
        }
    }
}
