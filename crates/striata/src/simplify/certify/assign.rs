//! Assigns a piece to the triangles of a floor: whole if one triangle is close enough, otherwise cut
//! where the nearest changes.
//!
//! ```text
//!        c                 Of the piece's corners, a and b are nearer to A, and c to B. On two of its
//!       / \      B         sides there is a point x that is equally far from both: the cut connects them,
//!   ---x---x---            and both parts are processed further. Distances at x are then those to the
//!     /     \    A         surface, not to the wrong triangle.
//!    a-------b
//! ```

use glam::DVec3;
use wide::f64x4;

use super::floor::Floor;
use super::polygon::{MAX_CORNERS, Polygon};

/// Maximum number of cuts per piece, apart from those for each triangle of the floor.
const MAX_CUTS: usize = 16;
/// Additional cuts per piece for each triangle of the floor.
const MAX_CUTS_PER_FACE: usize = 4;

/// Distances that are kept at most, 8 bytes each: with more, pieces are assigned whole.
pub(super) const MAX_DISTANCES: usize = 1 << 25;

/// A face is nearer only if its squared distance is below this share of the other's: rounding must not
/// cause cuts.
const NEARER_SHARE: f64 = 1.0 - 1e-5;

/// Maximum number of trials to find a point that is equally far from two triangles.
const MAX_TRIALS: usize = 8;

/// A piece may be assigned whole if that makes its bound exceed the step's own error by no more than
/// this share.
pub(super) const SLACK: f64 = 0.03;

/// Points of the original surface with their squared distances from the floor's triangles.
#[derive(Default)]
pub(super) struct MeasuredPoints {
    at: Vec<DVec3>,
    squared: Vec<f64x4>,
    /// The largest squared distance of any point from its nearest triangle.
    farthest: f64,
}

impl MeasuredPoints {
    pub(super) fn clear(&mut self) {
        self.at.clear();
        self.squared.clear();
        self.farthest = 0.0;
    }

    #[inline]
    pub(super) fn push(&mut self, floor: &Floor, at: DVec3) -> u32 {
        self.farthest = self.farthest.max(floor.push_squared_distances(at, &mut self.squared));
        self.at.push(at);
        self.at.len() as u32 - 1
    }

    #[inline]
    fn row(&self, point: u32) -> &[f64x4] {
        let lanes = self.squared.len() / self.at.len();
        &self.squared[point as usize * lanes..][..lanes]
    }

    #[inline]
    fn squared(&self, point: u32, face: usize) -> f64 {
        self.row(point)[face / 4].to_array()[face % 4]
    }

    /// Whether more points may be measured.
    fn has_room(&self) -> bool {
        4 * self.squared.len() < MAX_DISTANCES
    }

    /// Returns the face whose largest squared distance from any of the given points is smallest, and
    /// that distance.
    #[inline]
    pub(super) fn best(&self, points: &[u32], count: usize) -> (usize, f64) {
        let lanes = self.squared.len() / self.at.len();
        let (mut best, mut least) = (0, f64::INFINITY);
        for lane in 0..lanes {
            let mut worst = f64x4::ZERO;
            for &point in points {
                worst = worst.fast_max(self.squared[point as usize * lanes + lane]);
            }
            for (i, &squared) in worst.to_array().iter().enumerate() {
                if squared < least && 4 * lane + i < count {
                    (best, least) = (4 * lane + i, squared);
                }
            }
        }
        (best, least)
    }
}

/// A piece during cutting: its corners and their indices among the measured points.
#[derive(Clone, Copy)]
pub(super) struct CutPiece {
    count: usize,
    corners: [[f64; 2]; MAX_CORNERS + 1],
    points: [u32; MAX_CORNERS + 1],
}

impl CutPiece {
    pub(super) fn new() -> Self {
        Self { count: 0, corners: [[0.0; 2]; MAX_CORNERS + 1], points: [0; MAX_CORNERS + 1] }
    }

    #[inline]
    pub(super) fn push(&mut self, corner: [f64; 2], point: u32) {
        self.corners[self.count] = corner;
        self.points[self.count] = point;
        self.count += 1;
    }

    fn push_from(&mut self, other: &Self, i: usize) {
        self.push(other.corners[i], other.points[i]);
    }

    fn points(&self) -> &[u32] {
        &self.points[..self.count]
    }

    pub(super) fn polygon(&self) -> Polygon {
        Polygon::new(&self.corners[..self.count])
    }
}

/// The plane of an original triangle, which maps its own coordinates to space.
#[derive(Clone, Copy)]
pub(super) struct TrianglePlane {
    pub first: DVec3,
    pub to_second: DVec3,
    pub to_third: DVec3,
}

impl TrianglePlane {
    #[inline]
    pub(super) fn at(&self, [u, v]: [f64; 2]) -> DVec3 {
        self.first + self.to_second * u + self.to_third * v
    }
}

/// A floor and the points measured against it.
#[derive(Default)]
pub(super) struct PieceAssigner {
    pub floor: Floor,
    pub points: MeasuredPoints,
    /// Squared distance below which nothing is cut.
    negligible: f64,
    jobs: Vec<CutPiece>,
}

impl PieceAssigner {
    /// Creates an assigner with the squared distance below which nothing is cut.
    pub(super) fn new(negligible: f64) -> Self {
        Self { negligible, ..Self::default() }
    }

    /// Squared bound that a piece may have without being cut.
    #[inline]
    fn allowed(&self) -> f64 {
        (self.points.farthest * ((1.0 + SLACK) * (1.0 + SLACK))).max(self.negligible)
    }

    /// Returns the face that is close enough to all points, if there is one, and its squared bound.
    #[inline]
    pub(super) fn single_face(&self, points: &[u32]) -> Option<(usize, f64)> {
        let (face, squared) = self.points.best(points, self.floor.count());
        (squared <= self.allowed()).then_some((face, squared))
    }

    /// Cuts a piece until each part has a face that is close enough, and passes each part with its face and
    /// its squared bound to `out`.
    pub(super) fn assign(
        &mut self,
        shape: CutPiece,
        plane: &TrianglePlane,
        mut out: impl FnMut(usize, f64, &CutPiece),
    ) {
        let mut cuts_left = MAX_CUTS + MAX_CUTS_PER_FACE * self.floor.count();
        self.jobs.push(shape);
        while let Some(shape) = self.jobs.pop() {
            let (face, squared) = self.points.best(shape.points(), self.floor.count());
            if squared > self.allowed()
                && cuts_left > 0
                && self.points.has_room()
                && let Some(parts) = self.cut(&shape, plane, face)
            {
                cuts_left -= 1;
                parts.into_iter().for_each(|part| self.push_job(part));
            } else {
                out(face, squared, &shape);
            }
        }
    }

    /// Queues a part, split in two if it has one corner too many.
    fn push_job(&mut self, part: CutPiece) {
        if part.count <= MAX_CORNERS {
            self.jobs.push(part);
            return;
        }
        let middle = part.count / 2;
        let (mut near, mut far) = (CutPiece::new(), CutPiece::new());
        (0..=middle).for_each(|i| near.push_from(&part, i));
        (middle..=part.count).for_each(|i| far.push_from(&part, i % part.count));
        self.jobs.extend([near, far]);
    }

    /// Cuts off the region around the corner farthest from `face` that is nearer to another face.
    fn cut(&mut self, shape: &CutPiece, plane: &TrianglePlane, face: usize) -> Option<[CutPiece; 2]> {
        let farther = |&i: &usize, &j: &usize| {
            let squared = |i: usize| self.points.squared(shape.points[i], face);
            squared(i).total_cmp(&squared(j))
        };
        let worst = (0..shape.count).max_by(farther)?;
        let other = self.face_to_cut_towards(face, shape.points[worst])?;
        let mut cutter =
            Cutter { assigner: self, shape, plane, faces: [face, other], bisector: None, tie_tolerance: 0.0 };
        let advantage = cutter.advantage(shape.points[worst]);
        cutter.tie_tolerance = (0.01 * cutter.assigner.allowed().sqrt()).min(0.5 * advantage);
        if advantage <= 0.0 {
            return None;
        }
        cutter.bisector = cutter.assigner.floor.bisector_plane(face, other);
        cutter.cut_around(worst)
    }
}

impl PieceAssigner {
    /// Returns the face to which the region around a point is cut off: the nearest face that shares a
    /// side with `face`, if it is nearer than that, or else the nearest of all. Across a shared side
    /// the nearest face changes at the side, so the cut follows it.
    fn face_to_cut_towards(&mut self, face: usize, point: u32) -> Option<usize> {
        let own = self.points.squared(point, face);
        let points = &self.points;
        let squared = |&other: &usize| points.squared(point, other);
        let nearer = |a: &usize, b: &usize| squared(a).total_cmp(&squared(b));
        let adjacent = self.floor.adjacent(face).min_by(nearer);
        if let Some(other) = adjacent.filter(|other| squared(other) < NEARER_SHARE * own) {
            return Some(other);
        }
        let (nearest, _) = self.points.best(&[point], self.floor.count());
        (squared(&nearest) < NEARER_SHARE * own).then_some(nearest)
    }
}

/// Cuts one piece between two faces.
struct Cutter<'a> {
    assigner: &'a mut PieceAssigner,
    shape: &'a CutPiece,
    plane: &'a TrianglePlane,
    faces: [usize; 2],
    /// If the faces share a side: a point of the plane of equal distances, and the plane's normal.
    bisector: Option<(DVec3, DVec3)>,
    /// Two distances that differ by no more than this are considered equal.
    tie_tolerance: f64,
}

impl Cutter<'_> {
    /// Returns how much nearer a point is to the second face than to the first.
    fn advantage(&self, point: u32) -> f64 {
        let points = &self.assigner.points;
        points.squared(point, self.faces[0]).sqrt() - points.squared(point, self.faces[1]).sqrt()
    }

    fn cut_around(&mut self, worst: usize) -> Option<[CutPiece; 2]> {
        let count = self.shape.count;
        let mut advantages = [0.0; MAX_CORNERS + 1];
        for (advantage, &point) in advantages.iter_mut().zip(self.shape.points()) {
            *advantage = self.advantage(point);
        }
        let is_first = |i: usize| advantages[i % count] < -self.tie_tolerance;
        // The nearest corners on either side of the worst that are closer to the first face.
        let after = (worst + 1..worst + count).find(|&i| is_first(i))?;
        let before = (after..worst + count).rev().find(|&i| is_first(i))?;
        let end = self.equidistant_point((after + count - 1) % count, after % count, &advantages);
        let start = self.equidistant_point((before + 1) % count, before % count, &advantages);
        let (mut off, mut rest) = (CutPiece::new(), CutPiece::new());
        off.push(start.0, start.1);
        for i in before + 1..after + count {
            let point = self.shape.points[i % count];
            if point != start.1 && point != end.1 {
                off.push_from(self.shape, i % count);
            }
        }
        off.push(end.0, end.1);
        rest.push(end.0, end.1);
        (after..=before).for_each(|i| rest.push_from(self.shape, i % count));
        rest.push(start.0, start.1);
        Some([off, rest])
    }

    /// Finds the point between two corners that is equally far from both faces. `from` is nearer to the
    /// second face, or equally far from both.
    fn equidistant_point(
        &mut self,
        from: usize,
        to: usize,
        advantages: &[f64; MAX_CORNERS + 1],
    ) -> ([f64; 2], u32) {
        let (mut advantage_from, mut advantage_to) = (advantages[from], advantages[to]);
        if advantage_from <= self.tie_tolerance {
            return (self.shape.corners[from], self.shape.points[from]);
        }
        let [p, q] = [from, to].map(|i| self.shape.corners[i]);
        let (mut low, mut high) = (0.0, 1.0);
        let mut guess = self.bisector.and_then(|(at, normal)| {
            let [height_from, height_to] = [from, to].map(|i| {
                let point = self.assigner.points.at[self.shape.points[i] as usize];
                normal.dot(point - at)
            });
            (height_from * height_to < 0.0).then(|| height_from / (height_from - height_to))
        });
        let mut trial = 0;
        loop {
            let equal_share = low + (high - low) * (advantage_from / (advantage_from - advantage_to));
            let share = guess.take().unwrap_or(equal_share);
            let corner = [p[0] + (q[0] - p[0]) * share, p[1] + (q[1] - p[1]) * share];
            let point = self.assigner.points.push(&self.assigner.floor, self.plane.at(corner));
            let advantage = self.advantage(point);
            trial += 1;
            if advantage.abs() <= self.tie_tolerance || trial == MAX_TRIALS {
                return (corner, point);
            }
            // The end that stays twice counts half (Illinois method), so that both ends converge.
            if advantage > 0.0 {
                (low, advantage_from, advantage_to) = (share, advantage, 0.5 * advantage_to);
            } else {
                (high, advantage_to, advantage_from) = (share, advantage, 0.5 * advantage_from);
            }
        }
    }
}
